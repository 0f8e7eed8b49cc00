"""Independent tests of blocked poppets: closed curves C(x) and b(x) with known errors, without code of `poppet`."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

Curve = Callable[[np.ndarray], np.ndarray]


def draw_curves(seed: int) -> tuple[Curve, Curve, np.ndarray, float, float, np.random.Generator]:
    """Return C(x), b(x), the strokes, the relative uncertainty of C, the uncertainty of b, and the generator.

    C rises from an annular gap to the area of the seat, with a soft start (a leaking edge) in every second case.
    """
    generator = np.random.default_rng(seed)
    largest, bend = 10.0 ** generator.uniform(-8.7, -7.3), generator.uniform(2.0, 5.0)
    soft, height = (generator.uniform(0.05, 0.2), generator.uniform(0.3, 0.6)) if seed % 2 else (0.0, 0.0)
    travel = generator.uniform(0.5e-3, 2e-3)
    strokes = travel * np.linspace(0.05, 1.0, generator.integers(9, 16))
    level, slope = generator.uniform(0.25, 0.45), generator.uniform(-0.1, 0.1)

    def conductance(x: np.ndarray) -> np.ndarray:
        u = x / travel
        gate = 1.0 if soft == 0.0 else 1.0 - height * np.exp(-((u / soft) ** 2))
        return np.asarray(largest * gate * bend * u / (1.0 + (bend * u) ** 3) ** (1.0 / 3.0))

    def ratio(x: np.ndarray) -> np.ndarray:
        return np.asarray(level + slope * x / travel)

    return conductance, ratio, strokes, generator.uniform(0.001, 0.004), generator.uniform(0.002, 0.008), generator

"""Independent tests of blocked poppets: closed curves C(x) and b(x) with known errors, without code of `poppet`."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

Curve = Callable[[np.ndarray], np.ndarray]
SHAPES = ("smooth", "soft", "kinked", "dead zone", "saturation", "underlap")


def draw_curves(seed: int, shape: str = "") -> tuple[Curve, Curve, np.ndarray, float, float, np.random.Generator]:
    """Return C(x), b(x), the strokes, the relative uncertainty of C, the uncertainty of b, and the generator.

    C rises from an annular gap to the area of the seat (`smooth`), with a leaking edge (`soft`). By default, every
    second edge is soft. The slope of the other shapes changes abruptly: a small slope before cracking, a leakage
    before the edge opens, a stop, or two edges that are both open in the centre.
    """
    generator = np.random.default_rng(seed)
    shape = shape or SHAPES[seed % 2]
    largest, bend = 10.0 ** generator.uniform(-8.7, -7.3), generator.uniform(2.0, 5.0)
    soft, height = (generator.uniform(0.05, 0.2), generator.uniform(0.3, 0.6)) if shape == "soft" else (0.0, 0.0)
    travel = generator.uniform(0.5e-3, 2e-3)
    strokes = travel * np.linspace(0.05, 1.0, generator.integers(9, 16))
    level, slope = generator.uniform(0.25, 0.45), generator.uniform(-0.1, 0.1)
    if shape in SHAPES[2:]:  # after the draws of the first shapes, whose cases stay the same
        kink, small = generator.uniform(0.15, 0.45), generator.uniform(0.05, 0.3)

    def conductance(x: np.ndarray) -> np.ndarray:
        u = x / travel
        if shape == "kinked":  # cracks at `kink`
            return np.asarray(largest * (small * u + np.maximum(u - kink, 0.0)))
        if shape == "dead zone":
            opening = bend * np.maximum(u - kink, 0.0)
            return np.asarray(largest * (0.1 * small + opening / (1.0 + opening**3) ** (1.0 / 3.0)))
        if shape == "saturation":
            return np.asarray(largest * np.minimum(u, 1.0 - kink))
        if shape == "underlap":  # the second edge closes at `kink`
            return np.asarray(largest * (u + kink - 2.0 * small * np.maximum(kink - u, 0.0)))
        gate = 1.0 if soft == 0.0 else 1.0 - height * np.exp(-((u / soft) ** 2))
        return np.asarray(largest * gate * bend * u / (1.0 + (bend * u) ** 3) ** (1.0 / 3.0))

    def ratio(x: np.ndarray) -> np.ndarray:
        return np.asarray(level + slope * x / travel)

    return conductance, ratio, strokes, generator.uniform(0.001, 0.004), generator.uniform(0.002, 0.008), generator

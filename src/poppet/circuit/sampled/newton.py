"""Newton's method on a sampled circuit's map."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.sampled.point import SampledPoint

Array = NDArray[np.float64]

STEPS, HALVINGS = 40, 12
SINGULAR = 1e-11
"""Singular values of the scaled Jacobian below this part of the largest one: directions in which all is rest."""
LARGEST = 1e100
"""Rates are cut off here: a timer that is set or called off changes by more than can be squared."""


def polished(point: SampledPoint, v: Array) -> Array:
    """States and memory nearer to rest."""
    f, jacobian = _scaled(point, v)
    # Seconds: rates of fast and slow equations become changes of the variables.
    weight = 1.0 / np.maximum(np.abs(jacobian).max(axis=1, initial=0.0), 1e-3)
    for _ in range(STEPS):
        if not np.all(np.isfinite(jacobian)):
            break
        matrix = jacobian * weight[:, None]
        step = np.linalg.lstsq(matrix, -f * weight, rcond=SINGULAR)[0] * point.size
        lower = _lowered(point, v, step, weight, float(np.linalg.norm(f * weight)))
        if lower is None:
            break
        v = lower
        f, jacobian = _scaled(point, v)
    return v


def _lowered(point: SampledPoint, v: Array, step: Array, weight: Array, norm: float) -> Array | None:
    for halvings in range(HALVINGS):
        trial = v + step * 0.5**halvings
        if np.all(trial[point.positive] > 0.0) and np.linalg.norm(_scaled(point, trial)[0] * weight) < norm:
            return trial
    return None


def _scaled(point: SampledPoint, v: Array) -> tuple[Array, Array]:
    f, jacobian = point.scaled(v)
    return np.clip(f, -LARGEST, LARGEST), jacobian

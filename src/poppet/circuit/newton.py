"""Newton's method for states at rest: zeros of rates, or of what a sample changes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

STEPS, HALVINGS = 50, 12
SINGULAR = 1e-11
"""Singular values of the scaled Jacobian below this part of the largest one belong to what is conserved or at rest
anywhere."""
LARGEST = 1e100
"""Rates are cut off here: a timer that is set or called off changes by more than can be squared."""
SLOWEST = 1e-3
"""Equations slower than this are not sped up to the others [1/s]."""
AT_REST = 1e-10
"""Rate of change at rest, per size of a state [1/s]; rounding of the rates is granted on top."""
ROUNDING = 1e3 * np.finfo(float).eps

Scaled = Callable[[Array], tuple[Array, Array]]
"""Rates per size at a point, (n,), and their Jacobian in sizes, (n, n) [1/s]."""


def residual_of(scaled: Scaled, v: Array, size: Array) -> tuple[Array, Array]:
    """Rate of each variable per size, and what of it counts as rest [1/s]."""
    f, jacobian = scaled(v)
    return np.abs(f), AT_REST + ROUNDING * np.abs(jacobian) @ (np.abs(v) / size)


def polished(scaled: Scaled, v: Array, size: Array, positive: NDArray[np.bool_], *, conserves: bool) -> Array:
    """A point nearer to rest; steps are halved until they lower the rates and keep positive variables positive.

    With `conserves` what the Jacobian says is conserved (its left null space) keeps its value, as the gas of a closed
    network does. Without, the smallest step is taken: what rests anywhere, as an integral within its band, may move.
    """
    f, jacobian = _cut(scaled(v))
    # Seconds: rates of fast and slow equations become changes of the variables. Not where something is conserved:
    # that is a sum of the rates as they are.
    largest = np.abs(jacobian).max(axis=1, initial=0.0)
    weight: Array = np.ones(f.size) if conserves else 1.0 / np.maximum(largest, SLOWEST)
    for _ in range(STEPS):
        # Derivatives have poles, as a root has at zero: the point before is the best there is.
        if not np.all(np.isfinite(jacobian)):
            break
        step = _step(f * weight, jacobian * weight[:, None], conserves) * size
        lower = _lowered(scaled, v, step, positive, weight, float(np.linalg.norm(f * weight)))
        if lower is None:
            break
        v = lower
        f, jacobian = _cut(scaled(v))
    return v


def _step(f: Array, jacobian: Array, conserves: bool) -> Array:
    matrix, wanted = jacobian, -f
    if conserves and f.size:
        # J has no full rank where something is conserved; the rows added say that it keeps its value.
        left, singular, _ = np.linalg.svd(jacobian)
        conserved = left[:, singular <= SINGULAR * singular[0]].T
        matrix = np.vstack([jacobian, conserved * singular[0]])
        wanted = np.concatenate([wanted, np.zeros(len(conserved))])
    # The shortest step of all that solve it, sizes being those of the variables.
    return np.asarray(np.linalg.lstsq(matrix, wanted, rcond=SINGULAR)[0], dtype=np.float64)


def _lowered(
    scaled: Scaled, v: Array, step: Array, positive: NDArray[np.bool_], weight: Array, norm: float
) -> Array | None:
    for halvings in range(HALVINGS):
        trial = v + step * 0.5**halvings
        if np.all(trial[positive] > 0.0) and np.linalg.norm(_cut(scaled(trial))[0] * weight) < norm:
            return trial
    return None


def _cut(scaled: tuple[Array, Array]) -> tuple[Array, Array]:
    f, jacobian = scaled
    return np.clip(f, -LARGEST, LARGEST), jacobian

"""Newton's method for steady states.

It finds a zero of the rates, or of the changes over a sample if the circuit is sampled.
"""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

STEPS, HALVINGS = 50, 12
SINGULAR = 1e-11
"""Limit for singular values of the scaled Jacobian, relative to the largest one.

Directions with a singular value below the limit are conserved or neutral."""
MAX_RATE = 1e100
"""Limit of the absolute rates.

The rate of a timer that is set or cancelled is so large that its square would overflow."""
MIN_SPEED = 1e-3
"""Lower limit of the largest derivative by which an equation is divided to scale it [1/s]."""
STEADY_RATE = 1e-10
"""Largest rate of change in a steady state, per size of the state [1/s].

The rounding error of the rates is added to this limit."""
ROUNDING = 1e3 * np.finfo(float).eps

ScaledRates = Callable[[Array], tuple[Array, Array]]
"""Function from a point to its rates, (n,), and their Jacobian, (n, n) [1/s].

Both are in units of the sizes of the variables."""


def scaled_residual(scaled: ScaledRates, v: Array, size: Array) -> tuple[Array, Array]:
    """Return the absolute rate of each variable, and its limit for a steady state [1/s].

    The function `scaled` returns the rates and their Jacobian, in units of the typical sizes. `v` contains the
    variables, and `size` their typical sizes.
    """
    f, jacobian = scaled(v)
    return np.abs(f), STEADY_RATE + ROUNDING * np.abs(jacobian) @ (np.abs(v) / size)


def refine_steady_state(
    scaled: ScaledRates, v: Array, size: Array, positive: NDArray[np.bool_], *, conserves: bool
) -> Array:
    """Improve an approximate steady state by damped Newton steps.

    The function `scaled` returns rates and Jacobian. `v` is the start point, and `size` contains the typical sizes.
    Variables marked in `positive` stay positive.

    If the keyword `conserves` is True, conserved quantities such as the gas in a closed network keep their values. They
    correspond to the left null space of the Jacobian. If it is False, each step has minimum length, so variables
    without effect on the rates can change.
    """
    f, jacobian = _limit(scaled(v))
    # Weights [s] convert rates of fast and slow equations to changes; conserved quantities need unweighted rates.
    fastest = np.abs(jacobian).max(axis=1, initial=0.0)
    weight: Array = np.ones(f.size) if conserves else 1.0 / np.maximum(fastest, MIN_SPEED)
    for _ in range(STEPS):
        # A derivative can be infinite, as of a root at zero: the previous point is the result.
        if not np.all(np.isfinite(jacobian)):
            break
        matrix, target = jacobian * weight[:, None], -f * weight
        if conserves and f.size:
            # With conserved quantities J is singular; the additional rows keep these quantities constant.
            left, singular, _ = np.linalg.svd(matrix)
            conserved = left[:, singular <= SINGULAR * singular[0]].T
            matrix = np.vstack([matrix, conserved * singular[0]])
            target = np.concatenate([target, np.zeros(len(conserved))])
        # The shortest solution, in sizes of the variables.
        step, norm = np.linalg.lstsq(matrix, target, rcond=SINGULAR)[0] * size, np.linalg.norm(f * weight)
        for halvings in range(HALVINGS):
            trial = v + step * 0.5**halvings
            if np.all(trial[positive] > 0.0) and np.linalg.norm(_limit(scaled(trial))[0] * weight) < norm:
                break
        else:
            break
        v = trial
        f, jacobian = _limit(scaled(v))
    return v


def _limit(scaled: tuple[Array, Array]) -> tuple[Array, Array]:
    return np.clip(scaled[0], -MAX_RATE, MAX_RATE), scaled[1]

"""Loss functions; the robust ones reduce the effect of outliers.

References
----------
Triggs, McLauchlan, Hartley & Fitzgibbon 2000, Bundle adjustment, in: Vision Algorithms: Theory and Practice, Lecture
Notes in Computer Science 1883, 298-372, section 4.3 (second-order weights).
"""

from __future__ import annotations

import numpy as np

from poppet.timeseries.checks import FloatArray

LOSSES = ("linear", "soft_l1", "huber", "cauchy")
FLAT = 1e-16
"""Minimum curvature of a loss, relative to that of half a square."""


def costs_of(residual: FloatArray, loss: str) -> FloatArray:
    """Return the costs of the residuals: half their squares, or SciPy's rho."""
    squares = residual**2
    if loss == "soft_l1":
        squares = 2.0 * (np.sqrt(1.0 + squares) - 1.0)
    elif loss == "huber":
        squares = np.where(squares <= 1.0, squares, 2.0 * np.sqrt(squares) - 1.0)
    elif loss == "cauchy":
        squares = np.log1p(squares)
    return np.asarray(0.5 * squares)


def weights_of(residual: FloatArray, loss: str) -> FloatArray:
    """Return the weight of each residual in the gradient of the cost, rho' in SciPy."""
    if loss == "soft_l1":
        return np.asarray(1.0 / np.sqrt(1.0 + residual**2))
    if loss == "huber":
        return np.asarray(1.0 / np.maximum(1.0, np.abs(residual)))
    return np.asarray(1.0 / (1.0 + residual**2)) if loss == "cauchy" else np.ones(residual.size)


def curvatures_of(residual: FloatArray, loss: str) -> FloatArray:
    """Return the weights in the curvature, rho' + 2 r^2 rho'', if positive."""
    weights = weights_of(residual, loss)
    if loss == "soft_l1":
        weights = weights**3
    elif loss == "huber":
        weights = np.where(weights < 1.0, 0.0, 1.0)
    elif loss == "cauchy":
        weights = 2.0 * weights**2 - weights
    return np.asarray(np.maximum(weights, FLAT))

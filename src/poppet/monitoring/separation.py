"""Separation of faults by their effects on the readings, with nuisances marginalised."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ROUNDING = 1e-6
"""Fraction of an effect below which a rest of it is a rounding error of the differences."""


class RemainingEffects(NamedTuple):
    """Effects of faults that nuisances cannot explain, divided by the noise of the readings."""

    columns: Array  # (k, f) the squared norm of a column is the information on the fault
    resolution: Array  # (f,) size of the rounding errors of a column


def remaining_effects(faults: Array, nuisances: Array) -> RemainingEffects:
    """Return the effects of faults after marginalisation of all nuisances.

    `faults` contains the effects of the faults, (n, f), and `nuisances` those of the nuisances at one prior standard
    deviation, (n, q), both divided by the noise of the readings.
    """
    q = nuisances.shape[1]
    # The rows of the priors make the matrix regular. A triangular matrix contains all information on the columns.
    stacked = np.vstack([np.hstack([nuisances, faults]), np.eye(q, q + faults.shape[1])])
    triangle: Array = np.linalg.qr(stacked, mode="r")  # type: ignore[assignment]
    columns = triangle[q:, q:].copy()
    resolution = ROUNDING * np.linalg.norm(faults, axis=0)
    columns[:, np.linalg.norm(columns, axis=0) <= resolution] = 0.0
    return RemainingEffects(columns, resolution)


def with_scatter(effects: RemainingEffects, scatter: float) -> RemainingEffects:
    """Return the remaining effects if each fault number of a healthy plant scatters around its baseline.

    `scatter` is the standard deviation, in the unit of the columns. With the information of all faults, Lambda, the
    columns have the inner products of the inverse of (inverse of Lambda + scatter^2 I).
    """
    norms = np.linalg.norm(effects.columns, axis=0)
    _, values, rows = np.linalg.svd(effects.columns, full_matrices=False)
    columns = (values / np.sqrt(1.0 + (scatter * values) ** 2))[:, np.newaxis] * rows
    columns[:, norms == 0.0] = 0.0
    ratio = np.divide(np.linalg.norm(columns, axis=0), norms, out=np.ones(norms.size), where=norms > 0.0)
    return RemainingEffects(columns, effects.resolution * ratio)


def effect_angles(effects: RemainingEffects, directions: Sequence[int]) -> Array:
    """Return the angles between the effects of faults [deg], (f, f).

    A fault with a direction of 0 can have both signs, so its angles are at most 90 degrees. The angle of an effect that
    is zero is not a number.
    """
    signs, norms = np.array([direction or 1 for direction in directions]), np.linalg.norm(effects.columns, axis=0)
    unit = effects.columns * np.divide(signs, norms, out=np.full(norms.size, np.nan), where=norms > 0.0)
    smallest = np.divide(effects.resolution, norms, out=np.full(norms.size, np.nan), where=norms > 0.0)
    angles = np.zeros((norms.size, norms.size))
    for i, j in zip(*np.nonzero(~np.eye(norms.size, dtype=bool)), strict=True):
        # More accurate than the arc cosine at small angles.
        angle = 2.0 * math.atan2(np.linalg.norm(unit[:, i] - unit[:, j]), np.linalg.norm(unit[:, i] + unit[:, j]))
        angle = angle if directions[i] and directions[j] else min(angle, math.pi - angle)
        angles[i, j] = 0.0 if angle <= max(smallest[i], smallest[j]) else math.degrees(angle)
    return angles


def separations(effects: RemainingEffects, angles: Array) -> Array:
    """Return the effect of each fault that another fault of any size cannot explain, (f, f), in standard deviations.

    `angles` are the angles between the effects [deg].
    """
    sines = np.where(angles < 90.0, np.sin(np.radians(angles)), 1.0)
    return np.asarray(np.linalg.norm(effects.columns, axis=0)[:, np.newaxis] * sines)


def free_deviations(effects: RemainingEffects) -> Array:
    """Return the standard deviation of each fault if all others are free, (f,).

    The value is infinite if other faults have the same effect.
    """
    norms = np.linalg.norm(effects.columns, axis=0)
    deviations = np.full(norms.size, math.inf)
    for i in np.flatnonzero(norms):
        is_other = (norms > 0.0) & (np.arange(norms.size) != i)
        basis, values, _ = np.linalg.svd(effects.columns[:, is_other] / norms[is_other], full_matrices=False)
        smallest = max(float(np.max(effects.resolution[is_other] / norms[is_other], initial=0.0)), 1e-12)
        basis = basis[:, values > smallest]
        residual = effects.columns[:, i] - basis @ (basis.T @ effects.columns[:, i])
        rest_size = float(np.linalg.norm(residual - basis @ (basis.T @ residual)))
        if rest_size > effects.resolution[i]:
            deviations[i] = 1.0 / rest_size
    return deviations

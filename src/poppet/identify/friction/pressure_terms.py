"""Tests of residuals for terms with the product of pressure and speed, which a friction law may lack."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from poppet.identify.friction.motion import SlidingRows
from poppet.identify.gum import cluster_covariance, coverage_factor
from poppet.timeseries.checks import FloatArray

CONFIDENCE = 0.99
"""Confidence level at which a term is significant."""
LEAST_EFFECT = 1e-3
"""Root mean square of a term below which it is negligible, as a fraction of that of the friction."""
INDEPENDENT = 1e-6
"""Norm of a column without the other columns, relative to its own norm, above which it is independent."""
FEWEST_CLUSTERS, FEWEST_RECORDS = 6, 3
"""Minimum numbers of strokes and of recordings for a test."""


def pressure_significance(
    rows: SlidingRows,
    law_columns: FloatArray,
    column: FloatArray,
    nuisances: Sequence[FloatArray],
    group: NDArray[np.int_],
) -> float:
    """Return how significant the dependence of a friction term on the pressure is.

    The value is the coefficient of the dependence, divided by the half width of its interval. It is 0 for a negligible
    dependence. `column` contains the values of the term, (n,). `law_columns` contains the derivatives of the friction
    by the parameters of the law, (n, n_parameters). The coefficients of the terms `nuisances` can also depend on the
    pressure. `group` is the group of each sample.

    The friction of each recording has a free level. Therefore only differences within recordings test the dependence.
    Residuals are independent between strokes, and between the points of a table. With at least three recordings, the
    coefficient of the term in each recording must also depend on the pressure more than it scatters.
    """
    records = [np.where(rows.record == k, 1.0, 0.0) for k in np.unique(rows.record)]
    root = np.sqrt(rows.weight)
    candidates = [*(rows.sign * record for record in records), *records, *law_columns.T]
    candidates += [nuisance * rows.pressure for nuisance in nuisances]
    basis = np.zeros((root.size, 0))  # orthonormal, (n, rank)
    for candidate in candidates:
        weighted = candidate * root
        rest = weighted - basis @ (basis.T @ weighted)
        rest -= basis @ (basis.T @ rest)
        if np.linalg.norm(rest) > INDEPENDENT * np.linalg.norm(weighted):
            basis = np.column_stack([basis, rest / np.linalg.norm(rest)])
    term, friction = column * rows.pressure * root, rows.friction * root
    rest = term - basis @ (basis.T @ term)
    freedom = len(rows) - basis.shape[1] - 1
    if freedom < 1 or np.linalg.norm(rest) <= INDEPENDENT * np.linalg.norm(term):
        return 0.0
    coefficient = float(rest @ friction) / float(rest @ rest)
    if np.linalg.norm(coefficient * term) < LEAST_EFFECT * np.linalg.norm(friction):
        return 0.0
    errors = friction - basis @ (basis.T @ friction) - coefficient * rest
    if (rows.stroke < 0).all():
        half = coverage_factor(freedom, CONFIDENCE) * math.sqrt(float(errors @ errors) / freedom / float(rest @ rest))
    else:
        cluster = rows.stroke if np.unique(rows.stroke).size >= FEWEST_CLUSTERS else group
        size = float(np.linalg.norm(rest))
        spread = cluster_covariance(np.column_stack([rest / size, basis]), errors, cluster, 1)
        half = coverage_factor(float(spread.freedom[0]), CONFIDENCE) * math.sqrt(float(spread.covariance[0, 0])) / size
    statistic = coefficient / half if half > 0.0 else math.copysign(math.inf, coefficient)
    if len(records) < FEWEST_RECORDS:
        return statistic
    # A recording whose whole friction is 1 % higher has 1 % more of each term. With a common coefficient of the
    # nuisances, its column would absorb a part of their difference, and less of the scatter than of the trend.
    candidates += [nuisance * record for nuisance in nuisances for record in records]
    between = _statistic_between_recordings(rows, candidates, column, records)
    return min(statistic, between, key=abs)


def _statistic_between_recordings(
    rows: SlidingRows, candidates: Sequence[FloatArray], column: FloatArray, records: Sequence[FloatArray]
) -> float:
    """Return how significantly the coefficient of a friction term depends on the pressure of the recordings.

    `column` contains the values of the term. Its coefficient is fitted in each recording. The result is the slope of
    the coefficient versus pressure, divided by the half width of its interval.
    """
    root = np.sqrt(rows.weight)
    matrix = np.column_stack([*(column * record for record in records), *candidates]) * root[:, None]
    norms = np.linalg.norm(matrix, axis=0)
    matrix = matrix / np.where(norms > 0.0, norms, 1.0)
    # The least-norm solution distributes the common coefficient; the differences between recordings are unique.
    solution = np.linalg.lstsq(matrix, rows.friction * root, rcond=1e-10)[0] / np.where(norms > 0.0, norms, 1.0)
    values, pressure = solution[: len(records)], np.array([np.average(rows.pressure, weights=r) for r in records])
    if np.ptp(pressure) <= 0.0:
        return 0.0
    line, freedom = np.column_stack([np.ones_like(pressure), pressure / np.max(pressure)]), len(records) - 2
    slope = np.linalg.lstsq(line, values, rcond=None)[0]
    errors = values - line @ slope
    variance = float(errors @ errors) / freedom * np.linalg.inv(line.T @ line)[1, 1]
    half = coverage_factor(float(freedom), CONFIDENCE) * math.sqrt(variance)
    return float(slope[1]) / half if half > 0.0 else math.copysign(math.inf, float(slope[1]))

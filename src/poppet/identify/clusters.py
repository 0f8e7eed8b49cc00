"""Covariance of estimates whose residuals are correlated within groups."""

from __future__ import annotations

import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.identify.gum import gain
from poppet.timeseries.checks import FloatArray


class ClusterCovariance(NamedTuple):
    """Covariance and degrees of freedom of estimates."""

    covariance: FloatArray  # (n_numbers, n_numbers); infinite on the diagonal where a number is not seen
    freedom: FloatArray  # degrees of freedom of each, (n_numbers,)


def clustered(jacobian: FloatArray, residuals: FloatArray, group: NDArray[np.int_], numbers: int) -> ClusterCovariance:
    r"""Return the covariance of the first `numbers` parameters for residuals correlated within groups.

    .. math::

        V = M \Big(\sum_g J_g^\mathsf{T} A_g e_g e_g^\mathsf{T} A_g J_g\Big) M, \quad
        M = (J^\mathsf{T} J)^{-1}, \quad A_g = (1 - J_g M J_g^\mathsf{T})^{-1/2}

    Notes
    -----
    The factors A make the variance right on the average where the residuals are alike in size, for few groups and
    groups of large leverage too. The degrees of freedom are those of a chi-square with the same mean and variance.

    References
    ----------
    Bell & McCaffrey 2002, Bias reduction in standard errors for linear regression with multi-stage samples, Survey
    Methodology 28, 169-181; Imbens & Kolesar 2016, Robust standard errors in small samples, Review of Economics and
    Statistics 98, 701-712.

    Examples
    --------
    The mean of four groups is known as well as the mean of four values:

    >>> group = np.repeat([0, 1, 2, 3], 5)
    >>> level = np.repeat([1.0, 2.0, 3.0, 4.0], 5)
    >>> spread = clustered(np.ones((20, 1)), level.mean() - level, group, 1)
    >>> bool(np.isclose(spread.covariance[0, 0], np.var(level[::5], ddof=1) / 4)), float(spread.freedom[0].round(6))
    (True, 3.0)
    """
    norms = np.linalg.norm(jacobian, axis=0)
    sizes = np.where(norms > 1e-150, norms, 1.0)
    scaled = jacobian / sizes
    inverse, is_visible = gain(scaled)
    inner = inverse @ inverse.T
    scores, squares, projections = [], [], []
    for k in np.unique(group):
        rows = group == k
        basis, triangle = np.linalg.qr(scaled[rows])
        values, vectors = np.linalg.eigh(np.eye(len(triangle)) - triangle @ inner @ triangle.T)
        # What one group alone determines leaves no residual in it.
        root = np.where(values > 1e-9, np.abs(values), np.inf) ** -0.5
        factor = (vectors * root) @ vectors.T - np.eye(root.size)
        scores.append(scaled[rows].T @ residuals[rows] + triangle.T @ (factor @ (basis.T @ residuals[rows])))
        # Of each number its weights on the residuals of the group, A J M: as columns.
        weights = scaled[rows] @ inner + basis @ (factor @ (triangle @ inner))
        squares.append(np.einsum("ij,ij->j", weights, weights))
        projections.append(scaled[rows].T @ weights)
    score = inner @ np.array(scores).T
    covariance = score @ score.T / sizes / sizes[:, None]
    freedom = np.empty(numbers)
    for j in range(numbers):
        projection = np.array([matrix[:, j] for matrix in projections])
        table = np.diag([matrix[j] for matrix in squares]) - projection @ inner @ projection.T
        total = float(np.sum(table**2))
        freedom[j] = float(np.trace(table)) ** 2 / total if total > 0.0 else math.inf
        if not is_visible[j]:
            covariance[j, j] = math.inf
    return ClusterCovariance(covariance[:numbers, :numbers], np.maximum(freedom, 1.0))

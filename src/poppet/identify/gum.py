"""Uncertainty according to the GUM: degrees of freedom, coverage factors and tests of residuals."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.identify.result import CONFIDENCE, Estimate
from poppet.timeseries.checks import FloatArray

SPREAD = 3.0
"""Standard uncertainty of an unstated ambient temperature [K]."""


def effective_degrees_of_freedom(components: Sequence[tuple[float, float]]) -> float:
    r"""Return the degrees of freedom of a combined standard uncertainty (Welch-Satterthwaite).

    `components` contains pairs of a standard uncertainty u_i and its degrees of freedom nu_i.

    .. math:: \nu_\mathrm{eff} = \frac{u_c^4}{\sum_i u_i^4/\nu_i}, \qquad u_c^2 = \sum_i u_i^2

    References
    ----------
    JCGM 100:2008 (GUM), G.4.1, equation (G.2b).

    Examples
    --------
    >>> effective_degrees_of_freedom([(1.0, 10.0), (1.0, math.inf)])
    40.0
    """
    combined = math.fsum(u * u for u, _ in components)
    spread = math.fsum(u**4 / nu for u, nu in components)
    return combined * combined / spread if spread > 0.0 else math.inf


def coverage_factor(degrees_of_freedom: float, confidence: float = CONFIDENCE) -> float:
    """Return the ratio of interval half width to standard uncertainty (Student's t).

    The interval has the probability `confidence`.

    References
    ----------
    JCGM 100:2008 (GUM), G.3.2 and table G.2.

    Examples
    --------
    >>> round(coverage_factor(math.inf), 3), round(coverage_factor(10.0), 3)
    (1.96, 2.228)
    """
    from scipy.special import ndtri, stdtrit

    upper = 0.5 + 0.5 * confidence
    return float(ndtri(upper) if math.isinf(degrees_of_freedom) else stdtrit(degrees_of_freedom, upper))


def add_relative_uncertainty(estimate: Estimate, share: float) -> Estimate:
    """Return an estimate whose standard error and interval include a further uncertainty.

    `share` is this standard uncertainty as a fraction of the value.
    """
    value, error = estimate.value, share * abs(estimate.value)
    half = coverage_factor(math.inf) * error
    return replace(
        estimate,
        standard_error=math.hypot(estimate.standard_error, error),
        low=max(0.0, value - math.hypot(value - estimate.low, half)),
        high=value + math.hypot(estimate.high - value, half),
    )


def chi_square_probability(chi_square: float, degrees_of_freedom: int) -> float:
    """Return the probability that chi-square is larger than a given value.

    Chi-square is a sum of squared standardised residuals.

    Examples
    --------
    >>> round(chi_square_probability(18.307, 10), 3)
    0.05
    """
    from scipy.special import chdtrc

    return float(chdtrc(degrees_of_freedom, chi_square)) if degrees_of_freedom > 0 else math.nan


def few_runs_probability(residuals: FloatArray) -> float:
    r"""Return the probability of at most the observed number of sign runs (Wald-Wolfowitz).

    A sign run is a sequence of successive residuals of equal sign. The probability is exact. In the formula, P is the
    probability of 2k sign runs, and n_+ and n_- are the numbers of positive and negative residuals.


    .. math::

        P(2k) = 2 \binom{n_+ - 1}{k - 1} \binom{n_- - 1}{k - 1} \Big/ \binom{n}{n_+}

    Notes
    -----
    With an odd number of sign runs, 2k + 1, one sign has k + 1 of them and the other has k. The residuals of a fit
    change sign slightly more often than independent residuals. The test therefore rejects a fit less often than stated.

    References
    ----------
    Wald & Wolfowitz 1940, On a test whether two samples are from the same population, Annals of Mathematical
    Statistics 11, 147-162.

    Examples
    --------
    >>> few_runs_probability(np.array([1.0, 1.0, 1.0, 1.0, -1.0, -1.0, -1.0, -1.0])) == 2 / 70
    True
    """
    signs = np.sign(residuals[residuals != 0.0])
    n_positive, n_negative = int(np.sum(signs > 0.0)), int(np.sum(signs < 0.0))
    if not n_positive or not n_negative:
        return 1.0
    runs = 1 + int(np.sum(signs[1:] != signs[:-1]))
    orders = 0
    for count in range(2, runs + 1):
        # The orders that begin with a positive sign, and those that begin with a negative one.
        more, fewer = (count + 1) // 2 - 1, count // 2 - 1
        orders += math.comb(n_positive - 1, more) * math.comb(n_negative - 1, fewer)
        orders += math.comb(n_positive - 1, fewer) * math.comb(n_negative - 1, more)
    return orders / math.comb(n_positive + n_negative, n_positive)


def gain(jacobian: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
    r"""Return the derivatives of estimates with respect to residuals, and a mask of determined parameters.

    `jacobian` is the matrix J of derivatives of the residuals with respect to the parameters. The derivatives G of the
    estimates are the pseudo-inverse of J. The matrix cov is the covariance of the estimates for residuals of unit
    variance. The mask is True for each parameter that the data determine.

    .. math:: G = J^{+}, \qquad \mathrm{cov} = G G^\mathsf{T}
    """
    left, sizes, right = np.linalg.svd(jacobian, full_matrices=False)
    is_visible = sizes > 1e-9 * max(float(sizes.max(initial=0.0)), 1e-300)
    inverse = right[is_visible].T @ (left[:, is_visible] / sizes[is_visible]).T
    # The cut removes the variance of directions that are not identifiable: their parameters are not determined.
    return inverse, np.sum(right[is_visible] ** 2, axis=0) > 1.0 - 1e-9


def correlations(names: Sequence[str], covariance: FloatArray) -> dict[str, dict[str, float]]:
    """Return the correlation between each pair of estimates, as nested mappings by name.

    The result is empty for a single estimate.
    """
    errors = np.maximum(np.sqrt(np.diag(covariance)), 1e-300)
    # Divide in two steps: the product of the errors can underflow.
    table = np.clip(covariance / errors / errors[:, None], -1.0, 1.0)
    rows = {a: {b: float(table[i, j]) for j, b in enumerate(names) if j != i} for i, a in enumerate(names)}
    return rows if len(names) > 1 else {}


def corrected_penalty(numbers: int, samples: int) -> float:
    """Return the penalty term of the information criterion AICc.

    `numbers` is the number of fitted parameters, and `samples` the number of independent samples. The result is
    infinite if there are too few samples.

    References
    ----------
    Hurvich & Tsai 1989, Regression and time series model selection in small samples, Biometrika 76, 297-307.
    """
    k, left = float(numbers), samples - numbers - 1
    return 2.0 * k + (2.0 * k * (k + 1.0) / left if left > 0 else math.inf)


def leave_one_out(jacobian: FloatArray, residuals: FloatArray, data_gain: FloatArray) -> FloatArray:
    r"""Return the first-order shift of each parameter estimate if one residual is omitted.

    G is `data_gain`, the derivative of the estimates by the residuals. J is the Jacobian, r_i is a residual and h_i
    its leverage.

    .. math:: \Delta\theta_i = G_{\cdot i}\, \frac{r_i}{1 - h_i}, \qquad h_i = J_{i \cdot} G_{\cdot i}

    References
    ----------
    Belsley, Kuh & Welsch 1980, Regression Diagnostics, equation (2.1): DFBETA.
    """
    leverage = np.einsum("ij,ji->i", jacobian, data_gain)
    # A residual with leverage 1 alone determines a parameter: there is no estimate without it.
    remaining = np.where(leverage < 1.0 - 1e-9, 1.0 - leverage, np.nan)
    return np.asarray(data_gain * (residuals / remaining))


def studentised(jacobian: FloatArray, residuals: FloatArray, data_gain: FloatArray, freedom: int) -> FloatArray:
    r"""Return each residual divided by a standard error that is estimated from the other residuals.

    .. math:: t_i = e_i \sqrt{\frac{\nu - 1}{\nu - e_i^2}}, \qquad e_i = \frac{r_i}{s \sqrt{1 - h_i}}

    Here nu is `freedom`, s is the standard deviation of the residuals, and h_i is the leverage of r_i. The result
    follows Student's t with `freedom` - 1 degrees of freedom. It is not-a-number if a residual cannot be tested.

    References
    ----------
    Belsley, Kuh & Welsch 1980, Regression Diagnostics, equation (2.26): RSTUDENT.
    """
    left = 1.0 - np.einsum("ij,ji->i", jacobian, data_gain)
    square = float(residuals @ residuals)
    if freedom < 2 or square <= 0.0:
        return np.full(residuals.size, np.nan)
    inner = residuals / np.sqrt(np.where(left > 1e-9, left, np.nan) * square / freedom)
    return np.asarray(inner * np.sqrt((freedom - 1.0) / np.maximum(freedom - inner**2, 1e-9)))


class ClusterCovariance(NamedTuple):
    """Covariance and degrees of freedom of estimates, for residuals in correlated groups."""

    covariance: FloatArray  # (n, n); infinite on the diagonal if a parameter is not identifiable
    freedom: FloatArray  # degrees of freedom of each parameter, (n,)


def cluster_covariance(
    jacobian: FloatArray, residuals: FloatArray, group: NDArray[np.int_], numbers: int
) -> ClusterCovariance:
    r"""Return the covariance of the first `numbers` parameters of a fit with residuals correlated within groups.

    `group` is the group of each residual. In the formula, J_g is the Jacobian of the residuals e_g of group g.

    .. math::

        V = M \Big(\sum_g J_g^\mathsf{T} A_g e_g e_g^\mathsf{T} A_g J_g\Big) M, \quad
        M = (J^\mathsf{T} J)^{-1}, \quad A_g = (1 - J_g M J_g^\mathsf{T})^{-1/2}

    Notes
    -----
    With the factors A, the variance is unbiased for residuals of equal size, also for few groups and groups of large
    leverage. The degrees of freedom belong to a chi-square distribution with the same mean and variance.

    References
    ----------
    Bell & McCaffrey 2002, Bias reduction in standard errors for linear regression with multi-stage samples, Survey
    Methodology 28, 169-181; Imbens & Kolesar 2016, Robust standard errors in small samples, Review of Economics and
    Statistics 98, 701-712.

    Examples
    --------
    The mean of four groups is as uncertain as the mean of four values:

    >>> group = np.repeat([0, 1, 2, 3], 5)
    >>> level = np.repeat([1.0, 2.0, 3.0, 4.0], 5)
    >>> spread = cluster_covariance(np.ones((20, 1)), level.mean() - level, group, 1)
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
        # A parameter that one group alone determines leaves no residual in this group.
        root = np.where(values > 1e-9, np.abs(values), np.inf) ** -0.5
        factor = (vectors * root) @ vectors.T - np.eye(root.size)
        scores.append(scaled[rows].T @ residuals[rows] + triangle.T @ (factor @ (basis.T @ residuals[rows])))
        # Columns of A J M: the weights of the residuals of the group in each parameter.
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

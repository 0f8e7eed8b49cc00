"""Uncertainty according to the GUM: degrees of freedom, coverage, tests of residuals."""

from __future__ import annotations

import math
from collections.abc import Sequence

import numpy as np
from numpy.typing import NDArray

from poppet.identify.result import CONFIDENCE
from poppet.timeseries.checks import FloatArray


def effective_degrees_of_freedom(components: Sequence[tuple[float, float]]) -> float:
    r"""Return the degrees of freedom of a combined standard uncertainty (Welch-Satterthwaite).

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
    """Return the half width of a two-sided interval in standard uncertainties (Student's t).

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


def chi_square_probability(chi_square: float, degrees_of_freedom: int) -> float:
    """Return the probability of a larger sum of squared standardised residuals.

    Examples
    --------
    >>> round(chi_square_probability(18.307, 10), 3)
    0.05
    """
    from scipy.special import chdtrc

    return float(chdtrc(degrees_of_freedom, chi_square)) if degrees_of_freedom > 0 else math.nan


def few_runs_probability(residuals: FloatArray) -> float:
    r"""Return the probability of at most this number of runs of equal sign (Wald-Wolfowitz, exact).

    .. math::

        P(2k) = 2 \binom{n_+ - 1}{k - 1} \binom{n_- - 1}{k - 1} \Big/ \binom{n}{n_+}

    Notes
    -----
    Odd numbers of runs, 2k + 1, split one sign into k + 1 runs and the other into k. The residuals of a fit
    alternate a little more than independent ones, so a small probability is a cautious verdict.

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
    orders = sum(_orders_with(count, n_positive, n_negative) for count in range(2, runs + 1))
    return orders / math.comb(n_positive + n_negative, n_positive)


def _orders_with(runs: int, n_positive: int, n_negative: int) -> int:
    """Return the number of orders of the signs with this number of runs."""
    half = runs // 2
    if runs % 2 == 0:
        return 2 * math.comb(n_positive - 1, half - 1) * math.comb(n_negative - 1, half - 1)
    longer_positive = math.comb(n_positive - 1, half) * math.comb(n_negative - 1, half - 1)
    return longer_positive + math.comb(n_positive - 1, half - 1) * math.comb(n_negative - 1, half)


def gain(jacobian: FloatArray) -> tuple[FloatArray, NDArray[np.bool_]]:
    r"""Return the sensitivity of the estimates to the data, and a mask of determined parameters.

    .. math:: G = J^{+}, \qquad \mathrm{cov} = G G^\mathsf{T}
    """
    left, sizes, right = np.linalg.svd(jacobian, full_matrices=False)
    is_visible = sizes > 1e-9 * max(float(sizes.max(initial=0.0)), 1e-300)
    inverse = right[is_visible].T @ (left[:, is_visible] / sizes[is_visible]).T
    # The cut leaves unseen directions without any variance: a number with a part in them is not determined.
    return inverse, np.sum(right[is_visible] ** 2, axis=0) > 1.0 - 1e-9


def correlations(names: Sequence[str], covariance: FloatArray) -> dict[str, dict[str, float]]:
    """Return the correlations between all estimates."""
    errors = np.maximum(np.sqrt(np.diag(covariance)), 1e-300)
    # One after the other: their product may be too small for a float.
    table = np.clip(covariance / errors / errors[:, None], -1.0, 1.0)
    rows = {a: {b: float(table[i, j]) for j, b in enumerate(names) if j != i} for i, a in enumerate(names)}
    return rows if len(names) > 1 else {}


def corrected_penalty(numbers: int, samples: int) -> float:
    """Return the penalty of AICc; infinite if there are too few samples.

    References
    ----------
    Hurvich & Tsai 1989, Regression and time series model selection in small samples, Biometrika 76, 297-307.
    """
    k, left = float(numbers), samples - numbers - 1
    return 2.0 * k + (2.0 * k * (k + 1.0) / left if left > 0 else math.inf)


def leave_one_out(jacobian: FloatArray, residuals: FloatArray, data_gain: FloatArray) -> FloatArray:
    r"""Return the first-order shift of every parameter if one residual is omitted.

    .. math:: \Delta\theta_i = G_{\cdot i}\, \frac{r_i}{1 - h_i}, \qquad h_i = J_{i \cdot} G_{\cdot i}

    References
    ----------
    Belsley, Kuh & Welsch 1980, Regression Diagnostics, equation (2.1): DFBETA.
    """
    leverage = np.einsum("ij,ji->i", jacobian, data_gain)
    # A residual of leverage one is all that determines some number: without it there is none.
    remaining = np.where(leverage < 1.0 - 1e-9, 1.0 - leverage, np.nan)
    return np.asarray(data_gain * (residuals / remaining))


def studentised(jacobian: FloatArray, residuals: FloatArray, data_gain: FloatArray, freedom: int) -> FloatArray:
    r"""Return each residual over its standard error from the other residuals.

    .. math:: t_i = e_i \sqrt{\frac{\nu - 1}{\nu - e_i^2}}, \qquad e_i = \frac{r_i}{s \sqrt{1 - h_i}}

    with `freedom` - 1 degrees of freedom, where s is the standard deviation of the residuals and h their leverage;
    not-a-number where a residual cannot be judged.

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

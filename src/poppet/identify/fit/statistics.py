"""Statistics of a fit: effects of noise, lack of fit and offsets, with intervals, verdicts and AICc."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import combinations, pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.residuals import Staircase, correlation_time, weights_of
from poppet.identify.fit.search import Optimum
from poppet.identify.free_parameter import FreeParameter
from poppet.identify.gum import corrected_penalty, correlations, coverage_factor
from poppet.identify.result import CONFIDENCE, Estimate, ResidualSummary, Verdict, verdict_on_interval
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel

RANK = 1e-5
"""Least singular value of the normalised Jacobian, as a fraction of the largest, that counts as not zero. The
derivatives have this relative error. For C, V and h A of one tank, the least singular value is 1e-6; for parameters
that tests do determine, it is at least 0.01."""
PART = 1e-4
"""Squared component in a singular direction above which a parameter is not determined."""
UNFELT = 1e-4
"""Norm of the sensitivity to a relative change, in sigmas, below which a parameter has no effect."""
CHANCE = 6e-5
"""Probability that noise alone is reported as an offset: four sigmas for many samples."""
UNSEEN = 1e-6
"""Least fraction of a constant that the parameters cannot imitate; below it, the offset is not visible."""
MOST_JOINT = 4
"""Number of parameters at a bound up to which the values of all of them are combined; of more, only pairs."""
EDGE = 1e-3
"""Lower limit on 1 - leverage; below it, one sample alone determines a parameter."""
OF_RATIOS = 0.05, 0.15
"""Limits of the verdict on dimensionless parameters of finite range, as fractions of the range."""


# Influence of samples on parameters -------------------------------------------------------------------------------


def influences(optimum: Optimum) -> FloatArray:
    """Return the change of each parameter if one sample changes by one standard deviation of its noise.

    The matrix K in the formula has one row for each parameter. J contains the derivatives of the weighted residuals by
    the parameters.


    .. math:: K = (J^T J)^{-1} J^T
    """
    scale = _scale(optimum)
    relative, is_inside = optimum.jacobian * scale, optimum.active == 0
    result = np.empty((optimum.x.size, optimum.jacobian.shape[0]))
    # A parameter at a bound is fixed for the others; its row ignores the bound.
    if not np.all(is_inside):
        result[~is_inside] = _pseudo_inverse(_jacobian_near_bounds(optimum) * scale)[~is_inside]
    result[is_inside] = _pseudo_inverse(relative[:, is_inside])
    return result * scale[:, None]


def _jacobian_near_bounds(optimum: Optimum) -> FloatArray:
    return optimum.inside if optimum.inside.size else optimum.jacobian


def _scale(optimum: Optimum) -> FloatArray:
    return np.where(optimum.x == 0.0, 1.0, np.abs(optimum.x))


def _pseudo_inverse(jacobian: FloatArray) -> FloatArray:
    """Return the pseudo-inverse (J^T J)^-1 J^T of the Jacobian J of the residuals, (n_free, n_rows).

    `jacobian` is J per relative change of the parameters. The rows of parameters that are not identifiable are
    infinite.
    """
    scale, felt, u, s, vt = _decompose_jacobian(jacobian)
    is_visible = s > RANK * np.max(s, initial=0.0)
    rows = (vt[is_visible].T / s[is_visible]) @ u[:, is_visible].T / scale[:, None]
    rows[np.sum(vt[~is_visible] ** 2, axis=0) > PART] = np.inf
    inverse = np.full(jacobian.shape[::-1], np.inf)
    inverse[felt] = rows
    return inverse


def _decompose_jacobian(
    jacobian: FloatArray,
) -> tuple[FloatArray, NDArray[np.bool_], FloatArray, FloatArray, FloatArray]:
    """Return the singular value decomposition U, s, V^T of the non-zero columns of a Jacobian.

    Each column is divided by its norm. The result contains the norms of these columns, a mask that selects them, U, s
    and V^T.
    """
    norms = np.linalg.norm(jacobian, axis=0)
    felt = norms > UNFELT
    u, s, vt = np.linalg.svd(jacobian[:, felt] / norms[felt], full_matrices=False)
    # A lower limit keeps the directions finite that are not identifiable; they then dominate each sum.
    return norms[felt], felt, u, np.maximum(s, 1e-9 * s[0] if s.size else 0.0), vt


class SensorLimits(NamedTuple):
    """Rounding error of a sensor and its largest possible offset, in units of its noise."""

    steps: Staircase | None = None  # rounding error; None for a sensor of fine resolution
    largest: float = np.inf  # largest possible offset


class SensorOffset(NamedTuple):
    """Offset of a sensor that the residuals indicate, in units of the noise of the channel.

    `bias` is the mean of model - measurement. `size` is the estimated offset if no other sensor has one, and `error` is
    the standard deviation of this estimate. Both are limited to the largest possible offset of the sensor.
    `is_possible` is False if the estimate exceeds this limit. An offset then does not explain the difference between
    channel and model.
    """

    channel: int
    rows: slice
    bias: float
    size: float
    error: float
    is_possible: bool = True


class ErrorModel:
    r"""Error model of a fit: it gives the standard deviation of any weighted sum of the samples.

    A parameter estimate is an example of such a sum.

    .. math:: \sigma^2 = \max\Big(w \sum_i k_i^2,\; \sum_c \sum_{i,j \in c} \beta_{ij} m_i m_j,\;
        s^2 \sum_i k_i^2 + \sum_c e_c\Big)
        + \sum_c \Big(\sum_{i \in c} k_i\Big)^2 (o_c^2 + u_c^2), \quad m_i = k_i r_i / \sqrt{1 - h_i}

    c are the channels, k is the weight of each sample, r its residual, h its leverage, and w the mean variance factor.
    The first term is for a lack of fit that is equal in all samples. The second term uses the lack of fit of each
    sample; its weights beta decrease from 1 at i = j to 0 over the correlation length of the residuals. The third term
    treats a lack of fit of mean square s^2 as independent, except for the rounding e of coarse sensors (`Staircase`).
    The last sum contains the offsets o of the channels, with their own uncertainty u.

    Notes
    -----
    The free parameters can compensate a fraction of an offset, which is then not visible in the residuals. An error
    that several sensors share is therefore counted as an offset of each sensor.

    References
    ----------
    MacKinnon & White 1985, J. Econometrics 29, 305-325 (lack of fit of each sample, HC2); Newey & West 1987,
    Econometrica 55, 703-708, and Andrews 1991, Econometrica 59, 817-858, eq. 6.2 and 6.4 (correlated lack of fit).
    """

    def __init__(
        self,
        optimum: Optimum,
        sizes: Sequence[int],
        variance_factor: float,
        loss: str = "linear",
        gauges: Sequence[SensorLimits] = (),
    ) -> None:
        self.variance_factor = variance_factor  # factor on the variances, the mean over all samples
        self._gauges = gauges or [SensorLimits()] * len(sizes)
        self.influences = influences(optimum)
        ends = np.cumsum([0, *sizes])  # of the channels, in the order of the residual
        self.rows = [slice(int(a), int(b)) for a, b in pairwise(ends)]
        self._priors = slice(int(ends[-1]), None)
        # A robust loss reduces the weight of outliers, as in the search.
        self.residual = residual = optimum.residual * weights_of(optimum.residual, loss)
        self._seen = _decompose_jacobian((optimum.jacobian * _scale(optimum))[:, optimum.active == 0])[2]
        self._leverage = np.minimum(1.0 - EDGE, np.sum(self._seen**2, axis=1))
        self._square = max(1.0, float(np.mean(residual**2)))
        offsets = [self._offset(k, residual) for k in range(len(self.rows))]
        self.offsets = [offset for offset in offsets if offset is not None]
        self._misfit, self._reaches = self._correct_for_leverage(residual)

    def visible_part(self, columns: FloatArray) -> FloatArray:
        """Return columns of changes of the residuals without the part that the parameters inside their bounds imitate.

        The columns are (n_rows, k).
        """
        return np.asarray(columns - self._seen @ (self._seen.T @ columns))

    def deviation(self, weights: FloatArray, *, offsets: Sequence[SensorOffset] | None = None) -> float:
        """Return the standard deviation of a weighted sum of the samples.

        The samples are divided by their noise. The keyword `offsets` contains the sensor offsets that are included, by
        default all detected ones.
        """
        if not np.all(np.isfinite(weights)):
            return float("inf")
        spread = max(
            self.variance_factor * float(weights @ weights),
            self._local_variance(weights),
            self._rounding_variance(weights),
        )
        included = self.offsets if offsets is None else offsets
        shifts = sum(float(np.sum(weights[o.rows])) ** 2 * (o.size**2 + o.error**2) for o in included)
        return float(np.sqrt(spread + shifts))

    def factor(self, weights: FloatArray) -> float:
        """Return the variance of a weighted sum of the samples, divided by its value for white noise.

        The samples are divided by their noise.
        """
        white_deviation = float(np.sqrt(weights @ weights)) if np.all(np.isfinite(weights)) else 0.0
        return (self.deviation(weights) / white_deviation) ** 2 if white_deviation > 0.0 else self.variance_factor

    def model_deviation(self) -> FloatArray:
        """Return the standard deviation of the model at each sample, in units of the noise.

        Parameters at a bound are treated as fixed.
        """
        # The model at a sample is row i of U U'; in these coordinates no direction is worse conditioned than another.
        basis = self._seen
        moves = basis.T * self._misfit
        independent = moves @ moves.T
        correlated = independent.copy()
        for rows, reach in zip(self.rows, self._reaches, strict=True):
            piece = moves[:, rows]
            for lag in range(1, reach + 1):
                part = (1.0 - lag / (reach + 1.0)) * (piece[:, lag:] @ piece[:, :-lag].T)
                correlated += part + part.T
        variance = self.variance_factor * np.sum(basis**2, axis=1)
        for matrix in (independent, correlated):
            variance = np.maximum(variance, np.sum((basis @ matrix) * basis, axis=1))
        for o in self.offsets:
            variance += (basis @ basis[o.rows].sum(axis=0)) ** 2 * (o.size**2 + o.error**2)
        return np.asarray(np.sqrt(variance))

    def is_local(self, weights: FloatArray, factor: float) -> bool:
        """Return True if few samples with a large lack of fit dominate the variance of a weighted sum.

        `weights` contains the weight of each sample in the sum. The variance is computed from the lack of fit of each
        sample, and from the mean lack of fit. The first value must exceed `factor` squared times the second.
        """
        if not np.all(np.isfinite(weights)):
            return False
        return self._local_variance(weights) > factor**2 * self.variance_factor * float(weights @ weights)

    def _local_variance(self, weights: FloatArray) -> float:
        return _correlated_variance(weights * self._misfit, self.rows, self._reaches)

    def _rounding_variance(self, weights: FloatArray) -> float:
        """Return the variance of a weighted sum of the samples, with correlated rounding errors of coarse sensors.

        `weights` contains the weight of each sample. The result is 0 if no sensor is coarse.
        """
        pairs = [(gauge.steps, rows) for gauge, rows in zip(self._gauges, self.rows, strict=True) if gauge.steps]
        if not pairs:
            return 0.0
        excess = sum(steps.excess(weights[rows]) for steps, rows in pairs)
        return self._square * float(weights @ weights) + excess

    def _correct_for_leverage(self, residual: FloatArray) -> tuple[FloatArray, list[int]]:
        """Return residuals divided by sqrt(1 - leverage), and the correlation length of each channel in samples."""
        misfit = residual / np.sqrt(1.0 - self._leverage)
        misfit[self._priors] = 1.0
        reaches = []
        for rows in self.rows:
            time, size = correlation_time(residual[rows]), rows.stop - rows.start
            # Bartlett weights; 4 a^2/(1 - a^2)^2 (Andrews) for a first-order process with a correlation time of
            # (1 + a)/(1 - a).
            steepness = (time**2 - 1.0) ** 2 / (4.0 * time**2)
            reaches.append(min(int(np.ceil(1.1447 * (steepness * size) ** (1.0 / 3.0))), size // 3))
        return misfit, reaches

    def _offset(self, channel: int, residual: FloatArray) -> SensorOffset | None:
        """Return the detected offset of the sensor of one channel.

        The result is None if noise explains the offset, or if the free parameters can compensate almost all of it.
        """
        from scipy.special import stdtrit

        rows = self.rows[channel]
        constant = np.zeros(residual.size)
        constant[rows] = 1.0
        # Remove the part of the constant that the free parameters can imitate.
        constant -= self._seen @ (self._seen.T @ constant)
        remaining = float(constant @ constant)
        if remaining < UNSEEN * (rows.stop - rows.start):
            return None
        size = -float(constant @ residual) / remaining
        left = residual + size * constant
        misfit, reaches = self._correct_for_leverage(left)
        weights, piece = constant / remaining, left[rows]
        independent = max(1.0, float(np.mean(piece**2))) * float(weights @ weights)
        error = float(
            np.sqrt(
                max(
                    independent,
                    _correlated_variance(weights * misfit, self.rows, reaches),
                    self._rounding_variance(weights),
                )
            )
        )
        freedom = max(1.0, piece.size / correlation_time(piece) - 1.0)
        if abs(size) <= -float(stdtrit(freedom, 0.5 * CHANCE)) * error:
            return None
        largest = self._gauges[channel].largest
        bias, bounded = float(np.mean(residual[rows])), float(np.clip(size, -largest, largest))
        return SensorOffset(channel, rows, bias, bounded, min(error, largest), bounded == size)


def _correlated_variance(terms: FloatArray, channels: Sequence[slice], lengths: Sequence[int]) -> float:
    """Return the variance of a sum of samples that are correlated within each channel.

    `terms` contains the terms of the sum, `channels` the slice of each channel in them, and `lengths` the correlation
    length of each channel in samples.
    """
    independent = float(terms @ terms)
    correlated = independent
    for rows, length in zip(channels, lengths, strict=True):
        piece = terms[rows]
        for lag in range(1, length + 1):
            correlated += 2.0 * (1.0 - lag / (length + 1.0)) * float(piece[lag:] @ piece[:-lag])
    # An alternating lack of fit would give a smaller variance than independent terms: do not use that.
    return max(independent, correlated)


# Estimates and bands ----------------------------------------------------------------------------------------------


def estimates(
    free: Sequence[FreeParameter], optimum: Optimum, spread: ErrorModel, *, is_conditional: bool = False
) -> dict[str, Estimate]:
    """Return the estimate of each free parameter by name.

    An estimate contains the 95 % confidence interval and the verdict. `spread` is the error model of the fit. The
    intervals include the effect of all values of parameters at a bound that the data do not reject. If the keyword
    `is_conditional` is True, these parameters are treated as fixed.
    """
    quantile, result = _quantile(optimum), {}
    errors = np.array([spread.deviation(weights) for weights in spread.influences])
    below, above = quantile * errors, quantile * errors
    if not is_conditional:
        _extend_into_bounds(below, above, free, optimum, spread, quantile)
    for k, (f, x, active) in enumerate(zip(free, optimum.x, optimum.active, strict=True)):
        value, half = float(x), max(float(below[k]), float(above[k]))
        error = float(errors[k]) if half <= quantile * errors[k] else half / quantile
        low, high = max(f.low, value - float(below[k])), min(f.high, value + float(above[k]))
        level = "at bound" if active else verdict(f, value, half)
        result[f.name] = Estimate(value, f.unit, error, low, high, level, f.start)
    return result


def _extend_into_bounds(
    below: FloatArray,
    above: FloatArray,
    free: Sequence[FreeParameter],
    optimum: Optimum,
    spread: ErrorModel,
    quantile: float,
) -> None:
    r"""Extend intervals by the effect of parameters at a bound, which can have values inside their bounds.

    `below` and `above` are the half widths of the intervals of all parameters, with parameters at a bound fixed. They
    are replaced by the ends of the confidence region of the linear model. For residuals r with the derivatives J, this
    region contains all changes d with

    .. math:: |r + J d|^2 - |r|^2 \le q^2 w

    that no bound excludes. q is `quantile`, and w is the variance factor of the parameter.
    """
    jacobian, scale = _jacobian_near_bounds(optimum), _scale(optimum)
    norms = np.linalg.norm(jacobian * scale, axis=0)
    bounded = [k for k, f in enumerate(free) if optimum.active[k] and f.name not in optimum.fixed and norms[k] > UNFELT]
    inner = [k for k in range(len(free)) if not optimum.active[k] and np.all(np.isfinite(spread.influences[k]))]
    if not bounded or not inner:
        return
    # Positive changes of the bounded parameters are inside, and one unit changes the residuals by one sigma.
    units = -optimum.active[bounded] * scale[bounded] / norms[bounded]
    columns = jacobian[:, bounded] * units
    ranges = np.array([free[k].high - free[k].low for k in bounded]) / np.abs(units)
    forces = np.maximum(spread.residual @ columns, 0.0)
    responses = -spread.influences[inner] @ columns
    visible = spread.visible_part(columns)
    limits = [np.sum(ranges * side * responses, axis=1, where=side * responses > 0.0) for side in (-1.0, 1.0)]
    fixed_halves = below[inner].copy()
    largest = len(bounded) if len(bounded) <= MOST_JOINT else 2
    for subset in (list(c) for size in range(1, largest + 1) for c in combinations(range(len(bounded)), size)):
        u, s, vt = np.linalg.svd(visible[:, subset], full_matrices=False)
        s = np.maximum(s, RANK)
        inverse = (vt.T / s) @ u.T
        moves = -((vt.T / s**2) @ (vt @ forces[subset]))  # to the minimum beyond the bounds
        depth = -float(forces[subset] @ moves)
        for position, k in enumerate(inner):
            response = responses[position, subset]
            weights = spread.influences[k] + response @ inverse
            size = float(np.linalg.norm(weights))
            radius = float(np.sqrt(quantile**2 * spread.factor(weights) + depth))
            direction = inverse @ weights * (radius / size) if size > 0.0 else np.zeros(len(subset))
            for side, halves, limit in ((-1.0, below, limits[0]), (1.0, above, limits[1])):
                if np.all(moves + side * direction >= 0.0):
                    half = side * float(response @ moves) + radius * size
                    halves[k] = max(halves[k], min(half, fixed_halves[position] + limit[position]))


def _quantile(optimum: Optimum) -> float:
    return coverage_factor(max(1, optimum.residual.size - optimum.x.size), CONFIDENCE)


def verdict(f: FreeParameter, value: float, half: float) -> Verdict:
    """Return the verdict on the estimate of the parameter `f`, for example `determined`.

    `half` is half the width of the interval. For offsets and dimensionless parameters with finite bounds, it is
    compared with the range between the bounds. For other parameters it is compared with the value.
    """
    span = f.high - f.low
    is_ratio = (f.unit == "1" or f.role == "offset") and np.isfinite(span)
    return verdict_on_interval(half, span, OF_RATIOS) if is_ratio else verdict_on_interval(half, abs(value))


def covariance(optimum: Optimum) -> FloatArray:
    """Return the covariance matrix of the parameters for white noise, (n_free, n_free).

    For a parameter at a bound, the covariances with all other parameters are zero. The variance of a parameter that is
    not identifiable is infinite.
    """
    rows = influences(optimum)
    is_unfelt = ~np.all(np.isfinite(rows), axis=1)
    rows[is_unfelt] = 0.0
    result = rows @ rows.T
    variances = np.where(is_unfelt, np.inf, np.diag(result))
    is_at_bound = optimum.active != 0
    result[is_at_bound, :] = result[:, is_at_bound] = 0.0
    result[np.diag_indices_from(result)] = variances
    return np.asarray(result)


def correlation(free: Sequence[FreeParameter], optimum: Optimum) -> dict[str, dict[str, float]]:
    """Return the correlation of each pair of estimates, as nested mappings by name.

    Parameters at a bound are omitted.
    """
    matrix = covariance(optimum)
    sd = np.sqrt(np.diag(matrix))
    indices = [k for k in range(len(free)) if np.isfinite(sd[k]) and sd[k] > 0.0 and not optimum.active[k]]
    return correlations([free[k].name for k in indices], matrix[np.ix_(indices, indices)])


class ConfidenceBand(NamedTuple):
    """Half widths of two 95 % bands of a channel: of the model, and of single samples."""

    model: FloatArray
    samples: FloatArray


def confidence_bands(optimum: Optimum, spread: ErrorModel) -> list[ConfidenceBand]:
    """Return the half widths of the 95 % confidence bands of each fitted channel."""
    quantile, result = _quantile(optimum), []
    model = spread.model_deviation()
    for rows, sigma in zip(spread.rows, optimum.sigmas, strict=True):
        noise = max(1.0, float(np.mean(optimum.residual[rows] ** 2)))
        deviation = model[rows]
        result.append(ConfidenceBand(quantile * sigma * deviation, quantile * sigma * np.sqrt(deviation**2 + noise)))
    return result


class ChannelFit(NamedTuple):
    """Measured and simulated values of one channel at the same times."""

    name: str
    channel: Channel
    model: FloatArray

    def summary(self) -> ResidualSummary:
        """Return the statistics of the residuals of the channel."""
        return ResidualSummary.of(self.model, self.channel.values, self.channel.unit)


def channel_fits(experiments: Sequence[Experiment], values: Mapping[str, float]) -> list[ChannelFit]:
    """Return the recorded and simulated channels of all recordings for given parameter values.

    `values` maps the names of the free parameters to their values.
    """
    return [
        ChannelFit(f"{e.name}.{channel.address}", channel, model)
        for e in experiments
        for channel, model in zip(e.measurement.channels, e.outputs(values), strict=True)
    ]


def aicc(pieces: Sequence[FloatArray], n_free: int) -> float:
    """Return the information criterion AICc of several groups of residuals.

    Each group in `pieces` has its own variance, which is estimated from the group. `n_free` is the number of free
    parameters.
    """
    # -2 ln L at the variance that makes it largest: the mean square of the residuals.
    squares = ((p.size, max(float(np.mean(p**2)), 1e-300)) for p in pieces)
    likelihood = sum(size * (np.log(2.0 * np.pi * square) + 1.0) for size, square in squares)
    return float(likelihood) + corrected_penalty(n_free + len(pieces), sum(piece.size for piece in pieces))

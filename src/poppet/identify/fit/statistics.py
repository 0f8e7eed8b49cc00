"""What a fit is worth: how far noise, misfit and offsets of sensors move its numbers; intervals, verdicts, AICc."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.losses import weights_of
from poppet.identify.fit.rounding import Staircase
from poppet.identify.fit.search import Optimum
from poppet.identify.fit.whiteness import correlation_time
from poppet.identify.free_parameter import FreeParameter
from poppet.identify.gum import corrected_penalty, correlations, coverage_factor
from poppet.identify.result import CONFIDENCE, Estimate, ResidualSummary, Verdict, judged
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel

RANK = 1e-5
"""Least singular value of the slopes, each over its norm, as part of the largest: the slopes are exact to no more than
this, and below it a direction is not seen at all. C, V and h A of one tank scaled together come to 1e-6, the weakest
direction of numbers that tests do determine to 0.01 or more."""
PART = 1e-4
"""Square of a number's part in such a direction from which it is not determined."""
UNFELT = 1e-4
"""Sigmas over all samples per relative change of one below which a number is not felt at all."""
CHANCE = 6e-5
"""Probability with which noise alone makes a constant that is taken for an offset: four sigmas of many samples."""
UNSEEN = 1e-6
"""Part of a constant that the numbers leave over below which they imitate it: a free offset does."""
EDGE = 1e-3
"""Least part of a sample's misfit that the fit leaves over; below it the sample is all that determines a number."""
OF_RATIOS = 0.05, 0.15
"""Limits of the verdict on dimensionless numbers of finite range, as part of it: critical ratios lie between 0.1 and
0.55."""


# How far samples move numbers -------------------------------------------------------------------------------------


def pulls(optimum: Optimum) -> FloatArray:
    r"""How far each sample moves each number, per sigma that the sample is off: one row for each number.

    .. math:: K = (J^T J)^{-1} J^T
    """
    scale = _scale(optimum)
    relative, inside = optimum.jacobian * scale, optimum.active == 0
    result = np.empty((optimum.x.size, optimum.jacobian.shape[0]))
    # A number at its bound is held for the others, but has a row of its own, as if the bound were not there.
    if not np.all(inside):
        result[~inside] = _inverted(relative)[~inside]
    result[inside] = _inverted(relative[:, inside])
    return result * scale[:, None]


def _scale(optimum: Optimum) -> FloatArray:
    return np.where(optimum.x == 0.0, 1.0, np.abs(optimum.x))


def _inverted(jacobian: FloatArray) -> FloatArray:
    """(J^T J)^-1 J^T of derivatives per relative change; infinite rows for numbers that are not felt, or that trade."""
    scale, felt, u, s, vt = _decomposed(jacobian)
    seen = s > RANK * np.max(s, initial=0.0)
    own = (vt[seen].T / s[seen]) @ u[:, seen].T / scale[:, None]
    own[np.sum(vt[~seen] ** 2, axis=0) > PART] = np.inf
    inverse = np.full(jacobian.shape[::-1], np.inf)
    inverse[felt] = own
    return inverse


def _decomposed(jacobian: FloatArray) -> tuple[FloatArray, NDArray[np.bool_], FloatArray, FloatArray, FloatArray]:
    """Norms of the columns that are felt, which these are, and u, s, vt of these columns over their norms."""
    norms = np.linalg.norm(jacobian, axis=0)
    felt = norms > UNFELT
    u, s, vt = np.linalg.svd(jacobian[:, felt] / norms[felt], full_matrices=False)
    # Directions that the data do not see at all stay finite, and then dominate every sum they are in.
    return norms[felt], felt, u, np.maximum(s, 1e-9 * s[0] if s.size else 0.0), vt


class Gauge(NamedTuple):
    """What is known of the sensor of a channel, in sigmas of its noise."""

    steps: Staircase | None = None  # where it is coarse
    largest: float = np.inf  # offset that it may have


class Offset(NamedTuple):
    """A channel, by its place among all, that is missed by a constant; sizes in sigmas of its noise.

    `bias` is the mean of model - measurement, `size` by how much its sensor reads too high if it alone is off, and
    `error` one sigma of that. Both are no larger than its sensor may be off; `is_possible` is false where it would
    have to be off by more, so that something else is wrong.
    """

    channel: int
    rows: slice
    bias: float
    size: float
    error: float
    is_possible: bool = True


class ErrorModel:
    r"""Standard deviation of whatever the samples determine linearly.

    .. math:: \sigma^2 = \max\Big(w \sum_i k_i^2,\; \sum_c \sum_{i,j \in c} \beta_{ij} m_i m_j,\;
        s^2 \sum_i k_i^2 + \sum_c e_c\Big)
        + \sum_c \Big(\sum_{i \in c} k_i\Big)^2 (o_c^2 + u_c^2), \quad m_i = k_i r_i / \sqrt{1 - h_i}

    k is the pull of each sample, r its residual, h its leverage, w the mean widening. The first sum supposes misfit
    that is spread over all samples alike. The second takes it where it is; its weights fall from 1 at i = j to 0 over
    a time that follows from the correlation of the residuals. The third takes misfit of mean square s^2 as independent,
    but for what coarse gauges add by their steps, e (`Staircase`). The last holds the offsets o of those channels c
    that are missed by a constant, with their own uncertainty u.

    Notes
    -----
    A part of an offset that the free numbers imitate is not seen. What several gauges have in common therefore counts
    as if each were off on its own by what would explain its misfit.

    References
    ----------
    MacKinnon & White 1985, J. Econometrics 29, 305-325 (misfit where it is, HC2); Newey & West 1987, Econometrica 55,
    703-708, and Andrews 1991, Econometrica 59, 817-858, eq. 6.2 and 6.4 (correlated misfit).
    """

    def __init__(
        self,
        optimum: Optimum,
        sizes: Sequence[int],
        widening: float,
        loss: str = "linear",
        gauges: Sequence[Gauge] = (),
    ) -> None:
        self.widening = widening  # factor on the variances, the mean over all samples
        self._gauges = gauges or [Gauge()] * len(sizes)
        self.pulls = pulls(optimum)
        ends = np.cumsum([0, *sizes])  # of the channels, in the order of the residual
        self.rows = [slice(int(a), int(b)) for a, b in pairwise(ends)]
        self._priors = slice(int(ends[-1]), None)
        # A robust loss counts outliers less, here as in the search.
        residual = optimum.residual * weights_of(optimum.residual, loss)
        self._seen = _decomposed((optimum.jacobian * _scale(optimum))[:, optimum.active == 0])[2]
        self._leverage = np.minimum(1.0 - EDGE, np.sum(self._seen**2, axis=1))
        self._square = max(1.0, float(np.mean(residual**2)))
        found = [self._offset(k, residual) for k in range(len(self.rows))]
        self.offsets = [offset for offset in found if offset is not None]
        self._misfit, self._reaches = self._by_leverage(residual)

    def deviation(self, pull: FloatArray, *, offsets: Sequence[Offset] | None = None) -> float:
        """One sigma of a combination of samples."""
        if not np.all(np.isfinite(pull)):
            return float("inf")
        spread = max(self.widening * float(pull @ pull), self._where_it_is(pull), self._stepped(pull))
        included = self.offsets if offsets is None else offsets
        shifts = sum(float(np.sum(pull[o.rows])) ** 2 * (o.size**2 + o.error**2) for o in included)
        return float(np.sqrt(spread + shifts))

    def factor(self, pull: FloatArray) -> float:
        """Variance of a combination over that of white noise of one sigma."""
        plain = float(np.sqrt(pull @ pull)) if np.all(np.isfinite(pull)) else 0.0
        return (self.deviation(pull) / plain) ** 2 if plain > 0.0 else self.widening

    def of_model(self) -> FloatArray:
        """One sigma of the model at every sample, in sigmas of its noise; numbers at a bound are held there."""
        # The model at a sample is row i of U U'; in these coordinates no direction is worse conditioned than another.
        seen = self._seen
        moves = seen.T * self._misfit
        alone = moves @ moves.T
        together = alone.copy()
        for rows, reach in zip(self.rows, self._reaches, strict=True):
            piece = moves[:, rows]
            for lag in range(1, reach + 1):
                part = (1.0 - lag / (reach + 1.0)) * (piece[:, lag:] @ piece[:, :-lag].T)
                together += part + part.T
        variance = self.widening * np.sum(seen**2, axis=1)
        for matrix in (alone, together):
            variance = np.maximum(variance, np.sum((seen @ matrix) * seen, axis=1))
        for o in self.offsets:
            variance += (seen @ seen[o.rows].sum(axis=0)) ** 2 * (o.size**2 + o.error**2)
        return np.asarray(np.sqrt(variance))

    def is_local(self, pull: FloatArray, more: float) -> bool:
        """Whether misfit where it counts widens a combination by so much more than misfit on the whole does."""
        if not np.all(np.isfinite(pull)):
            return False
        return self._where_it_is(pull) > more**2 * self.widening * float(pull @ pull)

    def _where_it_is(self, pull: FloatArray) -> float:
        return _joint(pull * self._misfit, self.rows, self._reaches)

    def _stepped(self, pull: FloatArray) -> float:
        """Variance of a combination where gauges are coarse: the steps move neighbouring samples together."""
        pairs = [(gauge.steps, rows) for gauge, rows in zip(self._gauges, self.rows, strict=True) if gauge.steps]
        if not pairs:
            return 0.0
        excess = sum(steps.excess(pull[rows]) for steps, rows in pairs)
        return self._square * float(pull @ pull) + excess

    def _by_leverage(self, residual: FloatArray) -> tuple[FloatArray, list[int]]:
        """Misfit put right for what the fit took of it, and the samples of each channel to be taken together."""
        misfit = residual / np.sqrt(1.0 - self._leverage)
        misfit[self._priors] = 1.0
        return misfit, [_reach(residual[rows]) for rows in self.rows]

    def _offset(self, channel: int, residual: FloatArray) -> Offset | None:
        """The constant that the residuals of a channel ask for, the numbers fitted along, if noise does not make it."""
        from scipy.special import stdtrit

        rows = self.rows[channel]
        constant = np.zeros(residual.size)
        constant[rows] = 1.0
        # What the free numbers imitate of a constant in this channel is theirs.
        constant -= self._seen @ (self._seen.T @ constant)
        seen = float(constant @ constant)
        if seen < UNSEEN * (rows.stop - rows.start):
            return None
        size = -float(constant @ residual) / seen
        left = residual + size * constant
        misfit, reaches = self._by_leverage(left)
        pull, piece = constant / seen, left[rows]
        plain = max(1.0, float(np.mean(piece**2))) * float(pull @ pull)
        error = float(np.sqrt(max(plain, _joint(pull * misfit, self.rows, reaches), self._stepped(pull))))
        freedom = max(1.0, piece.size / correlation_time(piece) - 1.0)
        if abs(size) <= -float(stdtrit(freedom, 0.5 * CHANCE)) * error:
            return None
        most = self._gauges[channel].largest
        bias, bounded = float(np.mean(residual[rows])), float(np.clip(size, -most, most))
        return Offset(channel, rows, bias, bounded, min(error, most), bounded == size)


def _joint(moves: FloatArray, channels: Sequence[slice], reaches: Sequence[int]) -> float:
    """Variance of a sum whose terms are correlated within channels over so many samples; others stand alone."""
    alone = float(moves @ moves)
    together = alone
    for rows, reach in zip(channels, reaches, strict=True):
        piece = moves[rows]
        for lag in range(1, reach + 1):
            together += 2.0 * (1.0 - lag / (reach + 1.0)) * float(piece[lag:] @ piece[:-lag])
    # Misfit that alternates would make the sum quieter than its terms: nobody should rely on that.
    return max(alone, together)


def _reach(residual: FloatArray) -> int:
    """Samples over which residuals are taken together: Bartlett weights, for a first-order process (Andrews)."""
    time = correlation_time(residual)
    # Andrews' 4 a^2/(1 - a^2)^2 of a first-order process, whose correlation time is (1 + a)/(1 - a).
    steepness = (time**2 - 1.0) ** 2 / (4.0 * time**2)
    return min(int(np.ceil(1.1447 * (steepness * residual.size) ** (1.0 / 3.0))), residual.size // 3)


# What is told of them ---------------------------------------------------------------------------------------------


def estimates(free: Sequence[FreeParameter], optimum: Optimum, spread: ErrorModel) -> dict[str, Estimate]:
    """Values with 95 % intervals and verdicts."""
    quantile, result = _quantile(optimum), {}
    for f, x, pull, active in zip(free, optimum.x, spread.pulls, optimum.active, strict=True):
        value, error = float(x), spread.deviation(pull)
        half = quantile * error
        low, high = max(f.low, value - half), min(f.high, value + half)
        word = "at bound" if active else verdict(f, value, half)
        result[f.name] = Estimate(value, f.unit, error, low, high, word, f.start)
    return result


def _quantile(optimum: Optimum) -> float:
    return coverage_factor(max(1, optimum.residual.size - optimum.x.size), CONFIDENCE)


def verdict(f: FreeParameter, value: float, half: float) -> Verdict:
    """Whether the data determine a number: its interval against its own size, or against its finite range.

    A sensor that reads right has an offset of no size.
    """
    span = f.high - f.low
    is_ratio = (f.unit == "1" or f.role == "offset") and np.isfinite(span)
    return judged(half, span, OF_RATIOS) if is_ratio else judged(half, abs(value))


def covariance(optimum: Optimum) -> FloatArray:
    """Covariance of the free numbers for white noise; those at a bound have their own variance only."""
    rows = pulls(optimum)
    dead = ~np.all(np.isfinite(rows), axis=1)
    rows[dead] = 0.0
    result = rows @ rows.T
    own = np.where(dead, np.inf, np.diag(result))
    outside = optimum.active != 0
    result[outside, :] = result[:, outside] = 0.0
    result[np.diag_indices_from(result)] = own
    return np.asarray(result)


def errors(optimum: Optimum) -> FloatArray:
    """One sigma of each number for white noise; infinite where it is not felt."""
    return np.asarray(np.linalg.norm(pulls(optimum), axis=1))


def correlation(free: Sequence[FreeParameter], optimum: Optimum) -> dict[str, dict[str, float]]:
    """Correlations between the estimates that lie inside their bounds."""
    matrix = covariance(optimum)
    sd = np.sqrt(np.diag(matrix))
    known = [k for k in range(len(free)) if np.isfinite(sd[k]) and sd[k] > 0.0 and not optimum.active[k]]
    return correlations([free[k].name for k in known], matrix[np.ix_(known, known)])


class Band(NamedTuple):
    """95 % of a channel, above and below the model: of the model itself, and of single samples with their noise."""

    model: FloatArray
    samples: FloatArray


def bands(optimum: Optimum, spread: ErrorModel) -> list[Band]:
    """How far the model of every fitted channel may be off, and how far its samples may lie from it."""
    quantile, found = _quantile(optimum), []
    model = spread.of_model()
    for rows, sigma in zip(spread.rows, optimum.sigmas, strict=True):
        noise = max(1.0, float(np.mean(optimum.residual[rows] ** 2)))
        own = model[rows]
        found.append(Band(quantile * sigma * own, quantile * sigma * np.sqrt(own**2 + noise)))
    return found


class ChannelFit(NamedTuple):
    """What the model makes of one channel."""

    name: str
    channel: Channel
    model: FloatArray

    def summary(self) -> ResidualSummary:
        """Model minus measurement."""
        return ResidualSummary.of(self.model, self.channel.values, self.channel.unit)


def shown(experiments: Sequence[Experiment], values: Mapping[str, float]) -> list[ChannelFit]:
    """Every channel with what the model makes of it at some free numbers."""
    return [
        ChannelFit(f"{e.name}.{channel.address}", channel, model)
        for e in experiments
        for channel, model in zip(e.measurement.channels, e.outputs(values), strict=True)
    ]


def aicc(pieces: Sequence[FloatArray], n_free: int) -> float:
    """Corrected information criterion of a joint Gaussian likelihood, the variance of every channel estimated."""
    # -2 ln L at the variance that makes it largest: the mean square of the residuals.
    squares = ((p.size, max(float(np.mean(p**2)), 1e-300)) for p in pieces)
    likelihood = sum(size * (np.log(2.0 * np.pi * square) + 1.0) for size, square in squares)
    return float(likelihood) + corrected_penalty(n_free + len(pieces), sum(piece.size for piece in pieces))

"""How far noise, misfit and the offsets of sensors move the numbers of a fit."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from poppet.identify.fit.search import Optimum
from poppet.identify.fit.whiteness import correlation_time

Array = NDArray[np.float64]

UNFELT = 1e-4
"""Sigmas over all samples per relative change of one below which a number is not felt at all."""
CHANCE = 6e-5
"""Probability with which noise alone makes a constant that is taken for an offset: four sigmas of many samples."""
UNSEEN = 1e-6
"""Part of a constant that the numbers leave over below which they imitate it: a free offset does."""
EDGE = 1e-3
"""Least part of a sample's misfit that the fit leaves over; below it the sample is all that determines a number."""


@dataclass(frozen=True)
class Offset:
    """A channel that is missed by a constant.

    Parameters
    ----------
    channel : int
        Its place among all channels.
    rows : slice
        Its samples among all.
    bias : float
        Mean of model - measurement [sigma].
    size : float
        By how much its sensor reads too high if it alone is off [sigma].
    error : float
        One sigma of it [sigma].
    """

    channel: int
    rows: slice
    bias: float
    size: float
    error: float


def pulls(optimum: Optimum) -> Array:
    r"""How far each sample moves each number, per sigma that the sample is off.

    .. math:: K = (J^T J)^{-1} J^T
    """
    scale = _scale(optimum)
    relative, inside = optimum.jacobian * scale, optimum.active == 0
    result = np.empty((optimum.x.size, optimum.jacobian.shape[0]))
    if not np.all(inside):
        result[~inside] = _inverted(relative)[~inside]
    result[inside] = _inverted(relative[:, inside])
    return result * scale[:, None]


def _scale(optimum: Optimum) -> Array:
    return np.where(optimum.x == 0.0, 1.0, np.abs(optimum.x))


def _inverted(jacobian: Array) -> Array:
    """(J^T J)^-1 J^T of derivatives per relative change; infinite rows for numbers that are not felt."""
    scale, felt, u, s, vt = _decomposed(jacobian)
    inverse = np.full(jacobian.shape[::-1], np.inf)
    inverse[felt] = (vt.T / s) @ u.T / scale[:, None]
    return inverse


def _decomposed(jacobian: Array) -> tuple[Array, NDArray[np.bool_], Array, Array, Array]:
    """Scales of the columns that are felt, which these are, and the singular values of these columns, scaled."""
    norms = np.linalg.norm(jacobian, axis=0)
    felt = norms > UNFELT
    u, s, vt = np.linalg.svd(jacobian[:, felt] / norms[felt], full_matrices=False)
    return norms[felt], felt, u, np.maximum(s, 1e-9 * s[0] if s.size else 0.0), vt


class Spread:
    r"""Standard deviation of whatever the samples determine linearly.

    .. math:: \sigma^2 = \max\Big(w \sum_i k_i^2,\; \sum_c \sum_{i,j \in c} \beta_{ij} m_i m_j\Big)
        + \sum_c \Big(\sum_{i \in c} k_i\Big)^2 (o_c^2 + u_c^2), \quad m_i = k_i r_i / \sqrt{1 - h_i}

    k is the pull of each sample, r its residual, h its leverage, w the mean widening. The first sum supposes misfit
    that is spread over all samples alike. The second takes it where it is; its weights fall from 1 at i = j to 0 over
    a time that follows from the correlation of the residuals. The last holds the offsets o of those channels c that
    are missed by a constant, with their own uncertainty u.

    Parameters
    ----------
    optimum : Optimum
        Where the search ended.
    sizes : sequence of int
        Number of samples of each channel, in the order of the residual.
    widening : float
        Factor on the variances, the mean over all samples.
    loss : str, optional
        Of the search; a robust one counts outliers less.

    Notes
    -----
    A part of an offset that the free numbers imitate is not seen. What several gauges have in common therefore counts
    as if each were off on its own by what would explain its misfit.

    References
    ----------
    MacKinnon & White 1985, J. Econometrics 29, 305-325 (misfit where it is, HC2); Newey & West 1987, Econometrica 55,
    703-708, and Andrews 1991, Econometrica 59, 817-858, eq. 6.2 and 6.4 (correlated misfit).
    """

    def __init__(self, optimum: Optimum, sizes: Sequence[int], widening: float, loss: str = "linear") -> None:
        self.widening = widening
        ends = np.cumsum([0, *sizes])
        self.rows = [slice(int(a), int(b)) for a, b in pairwise(ends)]
        self._priors = slice(int(ends[-1]), None)
        residual = optimum.residual * _weights(optimum.residual, loss)
        self._seen = _decomposed((optimum.jacobian * _scale(optimum))[:, optimum.active == 0])[2]
        self._leverage = np.minimum(1.0 - EDGE, np.sum(self._seen**2, axis=1))
        found = [self._offset(k, residual) for k in range(len(self.rows))]
        self.offsets = [offset for offset in found if offset is not None]
        self._misfit, self._reaches = self._by_leverage(residual)

    def deviation(self, pull: Array, *, offsets: Sequence[Offset] | None = None) -> float:
        """One sigma of a combination of samples."""
        if not np.all(np.isfinite(pull)):
            return float("inf")
        spread = max(self.widening * float(pull @ pull), self._where_it_is(pull))
        included = self.offsets if offsets is None else offsets
        shifts = sum(float(np.sum(pull[o.rows])) ** 2 * (o.size**2 + o.error**2) for o in included)
        return float(np.sqrt(spread + shifts))

    def factor(self, pull: Array) -> float:
        """Variance of a combination over that of white noise of one sigma."""
        plain = float(np.sqrt(pull @ pull)) if np.all(np.isfinite(pull)) else 0.0
        return (self.deviation(pull) / plain) ** 2 if plain > 0.0 else self.widening

    def is_local(self, pull: Array, more: float) -> bool:
        """Whether misfit where it counts widens a combination by so much more than misfit on the whole does."""
        if not np.all(np.isfinite(pull)):
            return False
        return self._where_it_is(pull) > more**2 * self.widening * float(pull @ pull)

    def _where_it_is(self, pull: Array) -> float:
        return _joint(pull * self._misfit, self.rows, self._reaches)

    def _unimitated(self, rows: slice) -> Array:
        """What the free numbers cannot imitate of a constant in one channel."""
        constant = np.zeros(self._seen.shape[0])
        constant[rows] = 1.0
        return np.asarray(constant - self._seen @ (self._seen.T @ constant))

    def _by_leverage(self, residual: Array) -> tuple[Array, list[int]]:
        """Misfit put right for what the fit took of it, and the samples of each channel to be taken together."""
        misfit = residual / np.sqrt(1.0 - self._leverage)
        misfit[self._priors] = 1.0
        return misfit, [_reach(residual[rows]) for rows in self.rows]

    def _offset(self, channel: int, residual: Array) -> Offset | None:
        """The constant that the residuals of a channel ask for, the numbers fitted along, if noise does not make it."""
        from scipy.stats import t

        rows = self.rows[channel]
        constant = self._unimitated(rows)
        seen = float(constant @ constant)
        if seen < UNSEEN * (rows.stop - rows.start):
            return None
        size = -float(constant @ residual) / seen
        left = residual + size * constant
        misfit, reaches = self._by_leverage(left)
        pull, piece = constant / seen, left[rows]
        plain = max(1.0, float(np.mean(piece**2))) * float(pull @ pull)
        error = float(np.sqrt(max(plain, _joint(pull * misfit, self.rows, reaches))))
        freedom = max(1.0, piece.size / correlation_time(piece) - 1.0)
        if abs(size) <= float(t.isf(0.5 * CHANCE, freedom)) * error:
            return None
        return Offset(channel, rows, float(np.mean(residual[rows])), size, error)


def _joint(moves: Array, channels: Sequence[slice], reaches: Sequence[int]) -> float:
    """Variance of a sum whose terms are correlated within channels over so many samples; others stand alone."""
    alone = float(moves @ moves)
    together = alone
    for rows, reach in zip(channels, reaches, strict=True):
        piece = moves[rows]
        for lag in range(1, reach + 1):
            together += 2.0 * (1.0 - lag / (reach + 1.0)) * float(piece[lag:] @ piece[:-lag])
    return max(alone, together)


def _weights(residual: Array, loss: str) -> Array:
    """What a residual counts in the slope of the cost, by the loss of the search."""
    if loss == "soft_l1":
        return np.asarray(1.0 / np.sqrt(1.0 + residual**2))
    if loss == "huber":
        return np.asarray(1.0 / np.maximum(1.0, np.abs(residual)))
    return np.asarray(1.0 / (1.0 + residual**2)) if loss == "cauchy" else np.ones(residual.size)


def _reach(residual: Array) -> int:
    """Samples over which residuals are taken together: Bartlett weights, for a first-order process."""
    time = correlation_time(residual)
    steepness = (time**2 - 1.0) ** 2 / (4.0 * time**2)
    return min(int(np.ceil(1.1447 * (steepness * residual.size) ** (1.0 / 3.0))), residual.size // 3)

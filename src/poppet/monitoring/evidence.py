"""Evidence for and against hypotheses on faults, from fits of the readings since a time."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from poppet.monitoring.fault_statistics import PairFit, chi_square_limit

Array = NDArray[np.float64]
Hypothesis = tuple[int, ...]
"""Indices of the faults that are present; empty for a healthy plant. The index f + k means that fault k grows."""
RISE_SIZE, FALL_SIZE = 0.5, 0.25
"""Change from which an alarm begins, and below which it ends, in alarm sizes."""
MISFIT = 2.0
"""Ratio of the mean squared innovations to those of the baseline, above which the model does not fit.

A fault that leaves only a small part of what it explains is named nevertheless.
"""
LEFT = 0.05
"""Largest part that such a fault leaves."""
LAST = 1.0 / 8.0
"""Last part of the readings of a fit, whose residuals are also judged alone: those of a wrong hypothesis increase."""
GROWTH, POSSIBLE_GROWTH = 4.5, 1.0
"""Decrease of half the sum of squares from which a fault grows, and from which its size can follow a growth."""
GROWN_PART = 0.35
"""Smallest part of the size of a fault by which it has grown since its onset.

With a wrong onset, a sudden fault seems to grow by less.
"""
TOO_SMALL, FEW = 0.1, 10
"""Ratio of mean squared residuals to those of healthy cycles below which a sensor is stuck, and the least number."""


class HypothesisFit(NamedTuple):
    """Fit of one hypothesis to the readings since a fault began.

    The faults of the hypothesis are free and constant. The other fault numbers can differ from the baseline by
    `SCATTER` alarm sizes.
    """

    cost: float  # half the sum of squares, in standard deviations, priors included
    sizes: Array  # (h,) changes of the faults at the start of the readings, and their growth until the end [SI]
    last: float = 1.0  # mean squared residual of the last readings, in variances
    is_known: bool = True  # False if the search has not found the minimum, which can be lower


class WindowEvidence(NamedTuple):
    """Fits of several hypotheses to the same readings."""

    fits: Mapping[Hypothesis, HypothesisFit]
    n_readings: int
    before: float = 0.0  # sum of squared innovations of the filter before these readings


class Refit(Protocol):
    """Function that fits hypotheses to the readings since a time [s]."""

    def __call__(
        self, since: float, hypotheses: Sequence[Hypothesis], steps: Array, *, is_quick: bool = False
    ) -> WindowEvidence | None:
        """Return the fits, or None if the readings are not available.

        `steps` contains the approximate size of each fault as the only one, (f,) [SI]. If `is_quick`, only the best fit
        must be accurate.
        """


class HypothesisEvidence(NamedTuple):
    """Evidence for and against all hypotheses; sizes are changes from the baseline in alarm sizes."""

    z: Array  # (f,) evidence for each fault in its direction, in standard deviations
    sizes: Array  # (f,) size of each fault if it is the only one
    joint: float  # evidence against a healthy plant, a chi-square
    rests: Array  # (f,) evidence against each single fault, a chi-square
    pairs: Callable[[], Mapping[tuple[int, int], PairFit]]  # fits of pairs of faults
    squares: float  # sum of squares that the best single fault leaves, relative to healthy cycles
    n_readings: int
    growths: Array  # (f,) growth of each fault since the onset, which its size contains
    before: float = 0.0  # sum of squared innovations before these readings, relative to healthy cycles
    is_noisy: bool = False  # True if the residuals are those of fits, and the readings have noise
    unknown: Hypothesis = ()  # single faults that can explain more, because their fits have not found a minimum
    left: float = LEFT  # largest part of the evidence that a fault leaves
    is_healthy: bool = True  # True if a single fault leaves residuals as small as those of a healthy plant

    @property
    def misfit(self) -> float:
        """Mean square that the best single fault leaves, relative to healthy cycles; at least 1."""
        return max(self.squares / max(self.n_readings, 1), 1.0)

    @property
    def fits(self) -> bool:
        """True if the best single fault leaves little, in total or compared with what it explains.

        Much smaller residuals than on healthy cycles are those of a sensor that is stuck.
        """
        if self.is_noisy and self.n_readings >= FEW and self.squares < TOO_SMALL * self.n_readings:
            return False
        explained = self.joint - float(np.min(self.rests[self.z > 0.0], initial=math.inf))
        return self.misfit <= MISFIT or self.squares - self.n_readings <= self.left * explained

    def tempered(self) -> HypothesisEvidence:
        """Return the evidence divided by the misfit."""
        factor = self.misfit

        def pairs() -> dict[tuple[int, int], PairFit]:
            fits = self.pairs().items()
            return {pair: fit._replace(rest=fit.rest / (fit.misfit or factor)) for pair, fit in fits}

        evidence = self._replace(z=self.z / factor**0.5, joint=self.joint / factor, rests=self.rests / factor)
        return evidence._replace(pairs=pairs)


@dataclass(frozen=True, eq=False)
class HypothesisComparison:
    """Comparison of hypotheses by fits.

    Parameters
    ----------
    alarms, directions : (f,) array
        Alarm sizes of the faults [SI], and their directions.
    refit : callable
        Function that fits hypotheses to the readings since a time.
    temper, healthy_nis : float
        Factor on the variances of the fault numbers, and mean squared residual of healthy cycles.
    """

    alarms: Array
    directions: Array
    refit: Refit
    temper: float
    healthy_nis: float

    def evidence(
        self, since: float, steps: Array, *, can_grow: bool = False, is_noisy: bool = False, is_quick: bool = False
    ) -> HypothesisEvidence | None:
        """Compare the hypotheses by fits to the readings since a time; None if the readings are not available.

        With `can_grow`, a single fault may also have grown since then. If `is_quick`, only the best one is accurate.
        """
        f = self.alarms.size
        every = tuple(range(f))
        singles: list[Hypothesis] = [(k,) for k in every]
        growing: list[Hypothesis] = [(k, f + k) for k in every]
        constant: list[Hypothesis] = [(), *singles, every]
        evidence = self.refit(since, [*constant, *growing] if can_grow else constant, steps, is_quick=is_quick)
        if evidence is None:
            return None
        best, growths = [evidence.fits[single] for single in singles], np.zeros(f)
        for k, hypothesis in enumerate(growing):
            fit = evidence.fits.get(hypothesis)
            is_better = fit and fit.cost + GROWTH < best[k].cost and self.is_fit(fit, evidence.n_readings)
            if fit and is_better and abs(fit.sizes[1]) >= GROWN_PART * abs(np.sum(fit.sizes)):
                best[k], growths[k] = fit._replace(cost=fit.cost + GROWTH), fit.sizes[1] / self.alarms[k]
        scale, least = 2.0 / self.temper, min(fit.cost for fit in (*(evidence.fits[h] for h in constant), *best))
        sizes = np.array([np.sum(fit.sizes) for fit in best]) / self.alarms
        rests = np.array([scale * (fit.cost - least) for fit in best])
        joint = scale * (evidence.fits[()].cost - least)
        roots = np.sqrt(np.maximum(joint - rests, 0.0))
        z = np.where(self.directions == 0, roots, np.sign(self.directions * sizes) * roots)

        def pairs() -> dict[tuple[int, int], PairFit]:
            hypotheses = list(combinations(every, 2))
            evidence = self.refit(since, hypotheses, steps) if hypotheses else None
            pair_fits: dict[tuple[int, int], PairFit] = {}
            if evidence is None:
                return pair_fits
            for pair in hypotheses:
                fit, members = evidence.fits[pair], list(pair)
                misfit = max(2.0 * fit.cost / (self.healthy_nis * evidence.n_readings), 1.0)
                # If no single fault fits, a pair must leave as little as a healthy plant.
                if misfit <= max(MISFIT, single_misfit) and np.all(fit.sizes * self.directions[members] >= 0.0):
                    rest = scale * max(fit.cost - least, 0.0)
                    pair_fits[pair] = PairFit(rest, fit.sizes / self.alarms[members], misfit)
            return pair_fits

        squares = 2.0 * min(fit.cost for fit in best) / self.healthy_nis
        before = evidence.before / self.healthy_nis
        n_readings = evidence.n_readings
        unknown = tuple(k for k, fit in enumerate(best) if not fit.is_known)
        is_healthy = any(self.is_fit(fit, n_readings) for fit in best)
        result = HypothesisEvidence(
            z,
            sizes,
            joint,
            rests,
            pairs,
            squares,
            n_readings,
            growths,
            before,
            is_noisy,
            unknown,
            is_healthy=is_healthy,
        )
        single_misfit = result.misfit if result.fits else 0.0
        return result

    def grown(self, since: float, members: Hypothesis, sizes: Array) -> tuple[Array, Array]:
        """Return the sizes of known faults, and their growth since a time if they possibly grow; in alarm sizes."""
        f, steps, alarms = self.alarms.size, np.zeros(self.alarms.size), self.alarms[list(members)]
        steps[list(members)] = sizes * alarms
        growing = (*members, *(f + k for k in members))
        evidence = self.refit(since, [members, growing], steps)
        if evidence is None:
            return sizes, np.zeros(sizes.size)
        fit, is_better = evidence.fits[growing], False
        if self.is_fit(fit, evidence.n_readings):
            is_better = fit.cost + POSSIBLE_GROWTH < evidence.fits[members].cost
        if not is_better:
            return sizes, np.zeros(sizes.size)
        starts, growths = np.split(evidence.fits[growing].sizes, 2)
        return (starts + growths) / alarms, growths / alarms

    def is_fit(self, fit: HypothesisFit, n_readings: int) -> bool:
        """Return True if the squared residuals of a fit are as small as those of a healthy plant, except by chance."""
        freedom, last = max(n_readings, 1), max(round(LAST * n_readings), 1)
        squares, squares_last = 2.0 * fit.cost / self.healthy_nis, last * fit.last / self.healthy_nis
        return squares <= chi_square_limit(freedom) and squares_last <= chi_square_limit(last)

    def explanations(self, since: float, named: Hypothesis, steps: Array) -> dict[Hypothesis, HypothesisFit] | None:
        """Return the hypotheses that explain the readings since a time, the simplest first; None without readings.

        If those without a fault do, the readings do not depend on the faults.
        """
        every = range(self.alarms.size)
        first = dict.fromkeys([(), named, *((k,) for k in every)])
        growing = {h: (*h, *(self.alarms.size + k for k in h)) for h in first if h}
        further = [tuple(sorted((*named, k))) for k in every if k not in named]
        pairs = [h for h in dict.fromkeys([*further, *combinations(every, 2)]) if h not in first]
        found: dict[Hypothesis, HypothesisFit] = {}
        for hypotheses in ([*first], [*growing.values()], pairs):
            evidence = self.refit(since, hypotheses, steps) if hypotheses else None
            if evidence is None:
                return None if hypotheses == [*first] else found
            for hypothesis, complete in evidence.fits.items():
                h, fit = hypothesis, complete
                if h not in first and h in growing.values():
                    h = h[: len(h) // 2]
                    fit = complete._replace(sizes=complete.sizes[: len(h)] + complete.sizes[len(h) :])
                sizes = fit.sizes / self.alarms[list(h)] * self.directions[list(h)]
                most = MISFIT * self.healthy_nis * evidence.n_readings
                if 2.0 * fit.cost <= most and np.all(sizes >= -FALL_SIZE):
                    found[h] = fit
            if found:
                break
        most = min((fit.cost for fit in found.values()), default=0.0)
        most += 0.5 * self.temper * chi_square_limit(self.alarms.size - 1)
        return {h: fit for h, fit in found.items() if fit.cost <= most}

"""Verdicts on faults: alarms, and the cases without an answer."""

from __future__ import annotations

import enum
import math
from collections import deque
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.number_format import readable_unit, scaled
from poppet.monitoring.evidence import (
    FALL_SIZE,
    GROWN_PART,
    MISFIT,
    RISE_SIZE,
    TOO_SMALL,
    Hypothesis,
    HypothesisComparison,
    HypothesisEvidence,
    HypothesisFit,
    Refit,
)
from poppet.monitoring.fault_statistics import (
    PRIOR,
    FaultStatistics,
    OnsetBank,
    PairFit,
    chi_square_limit,
    fault_probabilities,
    fault_statistics,
    fits_of_pairs,
    probable_set,
)
from poppet.monitoring.plan import Fault

Array = NDArray[np.float64]
RISE, FALL = 5.0, 3.0
"""Evidence z above which an alarm begins, and below which it ends, in standard deviations."""
REVIEW = 0.01
"""Time between two evaluations of evidence that changes slowly, in windows."""
KEPT = 0.75
"""Age of a fault after which the filter adopts it although it cannot be told apart from others, in windows."""
LARGEST = 1e6
"""Size above which a step is never adopted, in alarm sizes: only impossible readings cause it."""
GROWING = 0.25
"""Time between two comparisons of a fault that grows, in windows."""
FOLLOWED = 1.5
"""Age of a fault up to which all its readings are compared again if it changes, in windows."""
EXPLAINED = 0.98
"""Fraction of the evidence from which a hypothesis explains it although a rest is significant.

The onset of a fault is known only approximately, and the effect of a large fault is known to a few per cent.
"""
EXPLAINED_LINEARLY, LEFT_LINEARLY = 0.95, 0.1
"""This fraction, and the largest part that a fault leaves, without fits: its effect is then linear in its size."""
GROWN = 0.75
"""This fraction for a further step of a fault that the filter has adopted before."""
SMALLEST_NIS = 0.25
"""Smallest mean squared innovation of healthy cycles that is used, in variances of the noise."""
COUNTED, ONSET = 50.0, 4.0
"""Largest evidence that counts for names by fits, a chi-square, until a fault is older than so many alarm delays."""
MOST_ONSETS = 6
"""Largest number of neighbouring onsets for which a search compares the hypotheses."""
MOST_REFINEMENTS, FINEST = 8, 1.0 / 32.0
"""Largest number of further onsets between two of them, and their smallest distance, in alarm delays."""
LIKELY = 0.5
"""Smallest probability of the faults of an alarm together."""


class VerdictKind(enum.Enum):
    """Kind of a verdict; the value is a message code."""

    HEALTHY = "watch.healthy"
    FAULT = "watch.fault"
    NOT_ISOLABLE = "watch.cannot_tell"
    SEVERAL = "watch.several"
    NONE_FITS = "watch.none_fits"
    NO_INFORMATION = "watch.no_information"
    UNKNOWN_INPUT = "watch.unknown_input"
    NO_READINGS = "watch.no_readings"


ALARMS = VerdictKind.FAULT, VerdictKind.NOT_ISOLABLE, VerdictKind.SEVERAL
"""Kinds of verdicts that are alarms."""


@dataclass(frozen=True)
class WatchVerdict:
    """Conclusion on the present state of a plant.

    Parameters
    ----------
    kind : VerdictKind
        Kind of the conclusion.
    names : tuple of str
        Names of the faults of an alarm, the most probable first.
    note : Note
        Conclusion as a sentence, with its code and facts.
    """

    kind: VerdictKind
    names: tuple[str, ...]
    note: Note

    def __str__(self) -> str:
        return str(self.note)


class OnsetComparison(NamedTuple):
    """Comparison of all hypotheses for one onset."""

    onset: float  # [s]
    age: float  # of the readings that are compared [s]
    is_by_fits: bool
    fits: bool  # True if a hypothesis fits the readings
    evidence: HypothesisEvidence  # tempered
    is_explained: bool  # True if a fault is evident and explains the readings
    total: float  # sum of squares of all readings with the best fault, relative to healthy cycles


CompareOnset = Callable[..., OnsetComparison]
"""Function that compares all hypotheses for an onset [s]; with `can_grow=True`, single faults can also grow."""


class StepEvidence(NamedTuple):
    """Evidence for each fault as the only one, at several onsets or for one estimate."""

    roots: Array  # (..., f) size in standard deviations
    sizes: Array  # (..., f) size in alarm sizes


class Adoption(NamedTuple):
    """Step of faults that the filter should adopt, because it is confirmed."""

    onset: int  # index of its onset in the bank, or -1 if the bank has none
    members: Hypothesis
    sizes: Array  # (h,) sizes of the steps of these faults [SI]
    since: float = math.nan  # time of the onset, if it is not that of the bank [s]
    growths: Array = np.zeros(0)  # (h,) approximate growth of these faults since then [SI]; empty if none grows
    totals: Array = np.zeros(0)  # (h,) changes of these faults from the baseline [SI]


class OpenSteps(NamedTuple):
    """Step of each fault as the only one."""

    onsets: NDArray[np.int64]  # (f,) index of its onset in the bank
    sizes: Array  # (f,) [SI]


class FaultMonitor:
    """Alarms and verdicts of a running plant, from the estimates of a filter.

    The evidence for a fault is a step at one of the onsets of the bank, or a change of the estimates of the filter. The
    memory is constant. Without `refit`, hypotheses are compared by the filter alone, which is accurate for faults whose
    effects are almost linear.

    Parameters
    ----------
    faults : sequence of Fault
        Faults with their directions and alarm sizes.
    alarm_delay : float
        Time for which a fault must be evident before its alarm, and absent before the end of the alarm [s].
    window : float
        Longest time for which readings are compared with the hypotheses [s].
    temper : float, optional
        Factor on the variances of the fault numbers, from the lack of fit on healthy cycles.
    healthy_nis : float, optional
        Mean normalised squared innovation of one reading on healthy cycles.
    refit : callable, optional
        Function that fits hypotheses to the readings since a time.
    separating : mapping, optional
        Mapping from two names of faults to the additional sensor that would separate them.
    bounds : tuple of arrays, optional
        Smallest and largest possible change of each fault number, (f,) each [SI].
    """

    def __init__(
        self,
        faults: Sequence[Fault],
        *,
        alarm_delay: float,
        window: float,
        temper: float = 1.0,
        healthy_nis: float = 1.0,
        refit: Refit | None = None,
        separating: Mapping[frozenset[str], str] | None = None,
        bounds: tuple[Array, Array] | None = None,
    ) -> None:
        self.faults = tuple(faults)
        self.alarm_delay, self.window = alarm_delay, window
        # A healthy recording without noise, such as a simulated one, is no reason to expect better readings.
        self.temper, self.healthy_nis = temper, max(healthy_nis, SMALLEST_NIS)
        self._separating = separating or {}
        self._alarms = np.array([fault.alarm for fault in faults])
        self._directions = np.array([fault.direction for fault in faults])
        self._fits: HypothesisComparison | None = None
        if refit is not None:
            self._fits = HypothesisComparison(self._alarms, self._directions, refit, self.temper, self.healthy_nis)
        self._is_two_sided = self._directions == 0
        f = len(self.faults)
        self._time = self._next_review = self._next_judgement = -math.inf
        self._step_since = math.inf  # start of the uninterrupted evidence for a step
        self._fault_since = math.inf  # start of the uninterrupted evidence for a fault
        self._present_at = -math.inf  # last time at which a fault of the alarm was evident
        self._begun = -math.inf  # onset of the fault of the alarm [s]
        self._misfit, self._averaged = 1.0, 0.0
        self._squares, self._n_readings = 0.0, 0  # sum of squared innovations, relative to healthy cycles
        self._sums: deque[tuple[float, float, int]] = deque(maxlen=round(1.5 / REVIEW))  # of these, with their times
        self._adopted = np.zeros(f)  # steps that the filter has adopted, in alarm sizes
        self._is_adopted = np.zeros(f, dtype=bool)  # faults with such a step at some time of the alarm
        self._estimated = StepEvidence(np.zeros(f), np.zeros(f))
        self._is_estimated = False  # True if an evidence of the estimates exceeds 3 standard deviations
        self._is_changed = False  # True if the estimates of the filter are evidence of a fault
        self._prior = np.full(f, PRIOR / f)
        self._uncertainties = np.full(f, math.inf)  # standard deviations of these, in alarm sizes
        self._is_informed = False
        self._information = 0.0  # sum of the bank at the last sample without readings
        self._is_confirmed = False  # True if the filter has adopted the fault of the alarm
        infinite = np.full(f, math.inf)
        self._bounds = (-infinite, infinite) if bounds is None else bounds
        self._indices = {fault.name: k for k, fault in enumerate(self.faults)}
        self._dropped_at = -math.inf  # last time at which no name was to be dropped
        self._complete_at = -math.inf  # last time at which no name was to be added
        self._joint_sizes, self._joint_sigmas = np.zeros(f), np.full(f, math.inf)  # if all faults are possible
        self._suspected: Hypothesis = ()  # faults that the last comparison has named
        self._grows = False  # True if the size of the named faults is compared again without a step, as they can grow
        self._is_walking = False  # True if the filter has adopted a growth
        self._judged: Array | None = None  # probabilities of the last judgement
        self._bank = OnsetBank(np.zeros(0), np.zeros((0, f)), np.zeros((0, f, f)))
        self._estimate = np.zeros(f), np.diag(self._alarms**2)
        self.adoption: Adoption | None = None
        self.verdict = WatchVerdict(VerdictKind.NO_INFORMATION, (), Note(VerdictKind.NO_INFORMATION.value))

    # Results -------------------------------------------------------------------------------------------------------

    @property
    def alarm(self) -> tuple[str, ...]:
        """Names of the faults of the present alarm; empty without an alarm."""
        return self.verdict.names if self.verdict.kind in ALARMS else ()

    @property
    def statistics(self) -> FaultStatistics:
        """Statistics of the single faults at the last sample; the last onset means the estimates of the filter."""
        change, covariance = self._estimate
        information = np.linalg.inv(covariance)
        numerators = np.concatenate([self._bank.numerators, [information @ change]])
        gram = np.concatenate([self._bank.gram, [information]])
        return fault_statistics(numerators, gram, self._alarms, self._directions, self.temper)

    @property
    def probabilities(self) -> Array:
        """Probability of each fault, (f,).

        It is the prior probability if no evidence exceeds 3 standard deviations.
        """
        if self._judged is not None:
            return self._judged
        if not self._is_estimated and self._steps(FALL) is None:
            return self._prior
        s = self.statistics
        return fault_probabilities(s.z, s.joint, s.rests)

    @property
    def confirmed(self) -> Array:
        """Changes of the faults that the filter has adopted, (f,) [SI]."""
        return np.asarray(self._adopted * self._alarms)

    @property
    def misfit(self) -> float:
        """Mean squared innovation of the last quarter of a window, relative to healthy cycles."""
        return self._misfit

    def open_steps(self) -> OpenSteps | None:
        """Return the step of each fault that is evident but not adopted, or None; each as if it were the only one."""
        steps = self._steps(FALL) if self.alarm or self._step_since < math.inf else None
        if steps is None:
            return None
        onsets = np.argmax(np.abs(steps.roots), axis=0)
        faults = np.arange(onsets.size)
        sizes = np.where(np.abs(steps.roots[onsets, faults]) > FALL, steps.sizes[onsets, faults], 0.0)
        return OpenSteps(onsets, sizes * self._alarms)

    # Updates -------------------------------------------------------------------------------------------------------

    def update(self, time: float, bank: OnsetBank, change: Array, covariance: Array, nis: float, count: int) -> bool:
        """Process the estimates of the filter at a time, and return True if the verdict has changed.

        If `adoption` is not None after the call, the filter should adopt this step and empty the bank.

        Parameters
        ----------
        time : float
            Time of the sample [s].
        bank : OnsetBank
            Evidence for steps of the faults. The arrays are not copied.
        change : (f,) array
            Changes of the fault numbers from the baseline, as estimated by the filter.
        covariance : (f, f) array
            Their covariance, with all nuisances marginalised.
        nis : float
            Normalised squared innovation of the sample, a chi-square.
        count : int
            Number of readings in it. Without readings, nothing changes.
        """
        self._bank, self._estimate, self.adoption = bank, (change, covariance), None
        previous = self.verdict
        if not count:
            # Without readings, old evidence does not become older. A late reading is not among those of the sample.
            information, known = float(bank.gram.sum()), self._information
            self._information = information
            if not information > known:
                return False
        elapsed, self._time = time - self._time, time
        if self.alarm_delay < elapsed < math.inf:
            self._step_since = self._fault_since = math.inf
            self._present_at += elapsed
        if count:
            self._average_misfit(nis / (count * self.healthy_nis), elapsed)
        self._squares += nis / self.healthy_nis
        self._n_readings += count
        if time >= self._next_review:
            self._review(change, covariance)
        steps = self._steps(FALL if previous.kind in ALARMS else RISE)
        is_step, is_fault = False, self._is_changed
        if steps is not None:
            is_step = bool(np.any((np.abs(steps.roots) > RISE) & (np.abs(steps.sizes) >= FALL_SIZE)))
            is_fault |= bool(self._evident(steps, self._adopted, RISE, RISE_SIZE).any())
        if not is_step:
            self._step_since = math.inf
        elif self._step_since == math.inf:
            self._step_since, self._next_judgement = time, -math.inf
        self._fault_since = min(self._fault_since, time) if is_fault else math.inf
        is_alarm = previous.kind in ALARMS and not self._has_ended(steps)
        self._is_confirmed &= is_alarm
        if self._is_confirmed:
            if self._fits is not None:
                self._drop_names()
                self._add_names()
            is_due = steps is not None and time - max(self._step_since, self._fault_since) >= self.alarm_delay
            if self._fits is None:
                if is_due:
                    self._add_fault()
            elif (is_due or self._grows) and time >= self._next_judgement:
                self._judge_again(self._fits, is_due)
        elif is_alarm or time - self._fault_since >= self.alarm_delay:
            is_due = time - max(self._step_since, self._fault_since) >= self.alarm_delay or not is_step
            if time >= self._next_judgement and is_due:
                self._judge(is_alarm)
        else:
            self._judged, self._suspected = None, ()
            self._is_adopted[:] = False
            self._set_verdict(self._kind_without_fault())
        is_open = is_alarm and not self._is_confirmed  # the fault of the alarm is not known yet
        if self.adoption is None and steps is not None and not is_open and time - self._step_since >= self.alarm_delay:
            self._adopt_return(steps, is_alarm)
        return self.verdict is not previous

    def _steps(self, limit: float) -> StepEvidence | None:
        """Return the evidence for steps, or None if none of it reaches a limit in standard deviations."""
        evidence, information = self._bank.numerators, self._bank.gram.diagonal(axis1=1, axis2=2) * self.temper
        if not (evidence * evidence > limit**2 * information).any():
            return None
        information = np.maximum(information, 1e-300)
        roots = evidence / np.sqrt(information)
        return StepEvidence(roots, evidence * self.temper / (information * self._alarms))

    def _evident(self, steps: StepEvidence, already: Array | float, z: float, size: float) -> NDArray[np.bool_]:
        """Return a mask of faults in their direction, (..., f), with an evidence above z and a minimum total size."""
        roots, sizes = steps.roots, steps.sizes + already
        roots, sizes = (np.where(self._is_two_sided, np.abs(a), self._directions * a) for a in (roots, sizes))
        return np.asarray((roots > z) & (sizes >= size))

    def _review(self, change: Array, covariance: Array) -> None:
        """Evaluate the estimates of the filter, which change slowly, and the information of the bank."""
        self._next_review = self._time + REVIEW * self.window
        self._sums.append((self._time, self._squares, self._n_readings))
        information = np.linalg.inv(covariance)
        gains, diagonal = information @ change, information.diagonal()
        self._estimated = StepEvidence(gains / np.sqrt(diagonal * self.temper), gains / (diagonal * self._alarms))
        self._uncertainties = np.sqrt(self.temper / diagonal) / self._alarms
        self._joint_sizes = change / self._alarms
        self._joint_sigmas = np.sqrt(self.temper * covariance.diagonal()) / self._alarms
        self._is_estimated = bool((np.abs(self._estimated.roots) > FALL).any())
        self._is_changed = bool(self._evident(self._estimated, 0.0, RISE, RISE_SIZE).any())
        information = self._bank.gram.diagonal(axis1=1, axis2=2)
        self._is_informed = bool((information * self._alarms**2 > self.temper).any())

    def _average_misfit(self, ratio: float, elapsed: float) -> None:
        """Add the squared innovations of a sample, relative to healthy cycles, to their moving average."""
        memory, elapsed = 0.25 * self.window, max(elapsed, 0.0)
        # A plain mean at first, until its duration reaches the memory.
        self._averaged = min(self._averaged + elapsed, memory) if elapsed < memory else 0.0
        self._misfit += (ratio - self._misfit) * (min(elapsed / self._averaged, 1.0) if self._averaged else 1.0)

    def _kind_without_fault(self) -> VerdictKind:
        if self._misfit > MISFIT and self._averaged > self.alarm_delay:
            return VerdictKind.NONE_FITS
        return VerdictKind.HEALTHY if self._is_informed else VerdictKind.NO_INFORMATION

    def _set_verdict(self, kind: VerdictKind, names: tuple[str, ...] = (), **facts: object) -> None:
        if (kind, names) != (self.verdict.kind, self.verdict.names):
            self.verdict = WatchVerdict(kind, names, Note(kind.value, "", **facts))

    def _has_ended(self, steps: StepEvidence | None) -> bool:
        """Return True if the faults of the present alarm have been absent for the alarm delay.

        A fault that the filter has adopted is absent only if its estimate is well known and small.
        """
        sizes = self._directed(self._estimated.sizes)
        if self._is_confirmed:
            is_present = (sizes >= FALL_SIZE) | (self._uncertainties >= FALL_SIZE)
        else:
            is_present = self._evident(self._estimated, 0.0, FALL, FALL_SIZE)
            if steps is not None:
                is_present = is_present | self._evident(steps, self._adopted, FALL, FALL_SIZE).any(axis=0)
        if any(self.faults[k].name in self.verdict.names for k in np.flatnonzero(is_present)):
            self._present_at = self._time
        return self._time - self._present_at > self.alarm_delay

    # Judgement -----------------------------------------------------------------------------------------------------

    def _judge(self, is_alarm: bool) -> None:
        """Compare all hypotheses, set the verdict, and let the filter adopt the step of an alarm.

        The comparison is repeated when the time since the beginning of the fault has doubled, and later once a window;
        more often if no fault is named.
        `is_alarm` is True during an alarm.
        """
        time, statistics = self._time, self.statistics
        steps = np.where(statistics.onsets < self._bank.ages.size, statistics.sizes, 0.0) * self._alarms
        f = len(self.faults)
        onsets = [self._begun] if is_alarm else self._onsets(statistics)
        compare = partial(self._compare, statistics=statistics, steps=steps)
        best = compare(onsets[0], is_quick=True)
        if best.is_by_fits:
            quick = partial(compare, is_quick=True)
            onset = self._growing_onset(self._constant_onsets(best, onsets[1:], quick), onsets, quick)
            best = compare(onset, can_grow=True)
        elif len(onsets) > 1 and not best.is_explained:
            best = self._compare(onsets[1], statistics, steps)
        self._begun, age, fits, evidence = best.onset, best.age, best.fits, best.evidence
        self._present_at = time
        self._judged = self._probabilities_of(best)
        unexplained = (1.0 - (EXPLAINED if best.is_by_fits else EXPLAINED_LINEARLY)) * evidence.joint
        rest = float(np.min(evidence.rests[evidence.z > 0.0], initial=math.inf))
        members = probable_set(self._judged)
        is_likely = float(np.sum(self._judged[members])) >= LIKELY
        if fits and float(evidence.z.max()) <= RISE:
            # The fits do not confirm a new fault. The end of an alarm has its own rule.
            if not is_alarm:
                self._set_verdict(VerdictKind.HEALTHY)
        elif fits and rest <= chi_square_limit(f - 1) + unexplained:
            if not is_likely:
                # A single fault explains the readings, but a healthy plant is still possible.
                self._suspected = ()
                self._next_judgement = time + max(0.25 * age, self.alarm_delay)
                return
            members += [k for k in evidence.unknown if k not in members]
            self._name(members, evidence.sizes)
            is_same = not best.is_by_fits or self._suspected == (members[0],)
            self._suspected = (members[0],) if len(members) == 1 else ()
            # Only a step whose fault is known in two comparisons, or which the bank would soon forget.
            if (len(members) == 1 and is_same) or age > KEPT * self.window:
                self._is_confirmed = self._adopt_single(members[0], best, int(statistics.onsets[members[0]]))
                self._grows = best.is_by_fits  # at least until the next comparison
        else:
            nothing = PairFit(math.inf, np.zeros(0))
            pairs = evidence.pairs().items() if fits or best.is_by_fits else ()
            pair, fit = min(pairs, key=lambda item: item[1].rest, default=((), nothing))
            if fit.rest <= chi_square_limit(f - 2) + unexplained:
                names = tuple(self.faults[k].name for k in pair)
                self._set_verdict(VerdictKind.SEVERAL, names, faults=names)
                if not best.is_by_fits or self._suspected == pair:
                    self._is_confirmed = self._adopt(statistics.joint_onset, pair, fit.sizes, time - age)
                self._suspected = pair
            elif not is_alarm or best.is_by_fits:
                self._judged, self._suspected = np.zeros(f), ()
                self._set_verdict(VerdictKind.NONE_FITS)
        # Without a name, the onset can be wrong: a later comparison has a better one.
        factor = 1.0 if self.verdict.kind in ALARMS else 0.25
        is_suspected = bool(self._suspected) and not self._is_confirmed
        factor = 0.5 if self._is_confirmed and self._grows else factor
        self._next_judgement = time + (self.alarm_delay if is_suspected else max(factor * age, self.alarm_delay))

    def _probabilities_of(self, comparison: OnsetComparison) -> Array:
        """Return the probability of each fault, (f,).

        A wrong onset lets another fault fit better. It matters less as the fault becomes older. Without fits, the
        effects of large faults are inaccurate, because they are not linear in the size.
        """
        evidence = comparison.evidence
        novelty = min(ONSET * self.alarm_delay / max(comparison.age, self.alarm_delay), 1.0)
        caution = 1.0 + novelty * evidence.joint / COUNTED
        if not comparison.is_by_fits:
            caution = 1.0 + (1.0 - EXPLAINED_LINEARLY) * evidence.joint / chi_square_limit(max(len(self.faults) - 1, 1))
        return fault_probabilities(evidence.z, evidence.joint / caution, evidence.rests / caution)

    def _adopt_single(self, k: int, comparison: OnsetComparison, onset: int, *, is_new: bool = True) -> bool:
        """Let the filter adopt the fault k of a comparison, except an old one without growth; False if it cannot."""
        evidence, since = comparison.evidence, self._time - comparison.age
        if not comparison.is_by_fits:
            return self._adopt(onset, (k,), evidence.sizes[[k]])
        sizes, growths = self._grown(since, (k,), evidence.sizes[[k]])
        if abs(growths[0]) < GROWN_PART * abs(sizes[0]):
            sizes, growths = evidence.sizes[[k]], np.zeros(1)
        self._grows = bool(growths.any())
        if not (is_new or self._grows or self._is_walking):
            return True
        members = self._with_former((k,))
        further = np.zeros(len(members) - 1)
        return self._adopt(onset, members, np.append(sizes, further), since, np.append(growths, further))

    def _grown(self, since: float, members: Hypothesis, sizes: Array) -> tuple[Array, Array]:
        """Return the sizes of known faults, and their growth since a time if they possibly grow; in alarm sizes."""
        return (sizes, np.zeros(sizes.size)) if self._fits is None else self._fits.grown(since, members, sizes)

    def _with_former(self, members: Sequence[int]) -> Hypothesis:
        """Return faults, and those that the filter has adopted for another verdict."""
        former = np.flatnonzero(np.abs(self._adopted) >= FALL_SIZE)
        return tuple(dict.fromkeys((*members, *former.tolist())))

    def _compare(
        self,
        onset: float,
        statistics: FaultStatistics,
        steps: Array,
        *,
        can_grow: bool = False,
        is_quick: bool = False,
    ) -> OnsetComparison:
        """Compare all hypotheses for a fault that began at a time.

        With `can_grow`, single faults can also grow. If `is_quick`, the comparison is only valid for the choice of an
        onset.
        """
        # Readings of two windows are stored.
        longest = self.window if self._fits is None else 1.9 * self.window
        age = min(self._time - onset, longest)
        by_fits = None
        if self._fits is not None:
            # A plant without noise, such as a simulated one, always has small residuals.
            is_noisy = self._misfit > 3.0 * TOO_SMALL
            by_fits = self._fits.evidence(
                self._time - age, steps, can_grow=can_grow, is_noisy=is_noisy, is_quick=is_quick
            )
        evidence = by_fits or self._compare_estimates(statistics, self._time - age)
        tempered = self._within_bounds(evidence.tempered())
        explained = EXPLAINED if by_fits is not None else EXPLAINED_LINEARLY
        limit = chi_square_limit(len(self.faults) - 1) + (1.0 - explained) * tempered.joint
        is_explained = evidence.fits and float(tempered.z.max()) > RISE
        is_explained = is_explained and float(np.min(tempered.rests[tempered.z > 0.0])) <= limit
        total = evidence.before + evidence.squares
        return OnsetComparison(onset, age, by_fits is not None, evidence.fits, tempered, is_explained, total)

    def _constant_onsets(
        self, best: OnsetComparison, others: Iterable[float], compare: CompareOnset
    ) -> dict[float, OnsetComparison]:
        """Compare constant faults for several onsets.

        The evidence of the bank is linear in the size of a fault. If no fault fits with the best onset of the bank, the
        search continues between this onset and its neighbours: the readings show the onset of a large fault more
        precisely than the bank.
        """
        comparisons = {best.onset: best}
        best, times = self._best_onset(comparisons, others, compare), self._times(comparisons)
        times = [*times, max(times[-1], self._time - self.alarm_delay)]
        k = times.index(best.onset)
        low, high = times[max(k - 1, 0)], times[k + 1]
        for _ in range(MOST_REFINEMENTS):
            gap_below, gap_above = best.onset - low, high - best.onset
            if best.evidence.is_healthy or max(gap_below, gap_above) < FINEST * self.alarm_delay:
                break
            onset = best.onset - 0.5 * gap_below if gap_below > gap_above else best.onset + 0.5 * gap_above
            comparison = comparisons[onset] = compare(onset)
            best, worse = (comparison, best) if comparison.total < best.total else (best, comparison)
            if worse.onset < best.onset:
                low = worse.onset
            else:
                high = worse.onset
        return comparisons

    def _growing_onset(
        self, constant: Mapping[float, OnsetComparison], onsets: Iterable[float], compare: CompareOnset
    ) -> float:
        """Return the best onset, for faults that can grow if no constant one fits.

        A constant fault with a late onset can explain the last readings of a fault that grows.
        """
        best = min(constant.values(), key=lambda comparison: comparison.total)
        comparisons = {onset: comparison for onset, comparison in constant.items() if comparison.evidence.is_healthy}
        return self._best_onset(comparisons, [best.onset, *onsets], partial(compare, can_grow=True)).onset

    def _best_onset(
        self, comparisons: dict[float, OnsetComparison], others: Iterable[float], compare: CompareOnset
    ) -> OnsetComparison:
        """Return the comparison of the onset with which all readings are most probable.

        The search begins with some onsets, and continues with the neighbours of the best one. It adds its comparisons
        to the given ones.
        """
        comparisons.update((onset, compare(onset)) for onset in others if onset not in comparisons)
        times, limit = self._times(comparisons), max(len(comparisons), 1) + MOST_ONSETS
        while len(comparisons) < limit:
            k = times.index(min(comparisons, key=lambda onset: comparisons[onset].total))
            near = [onset for onset in times[max(k - 1, 0) : k + 2] if onset not in comparisons]
            if not near:
                break
            comparisons[near[0]] = compare(near[0])
        return min(comparisons.values(), key=lambda comparison: comparison.total)

    def _times(self, comparisons: Iterable[float]) -> list[float]:
        """Return the onsets that can be compared: those of the bank and of the comparisons, the earliest first."""
        ages = self._bank.ages[(self._bank.ages >= self.alarm_delay) & (self._bank.ages <= self.window)]
        return sorted({*(self._time - ages).tolist(), *comparisons})

    def _statistics_of_steps(self) -> FaultStatistics:
        """Return the statistics of the single faults from the bank alone, without the estimates of the filter."""
        return fault_statistics(self._bank.numerators, self._bank.gram, self._alarms, self._directions, self.temper)

    def _onsets(self, statistics: FaultStatistics) -> list[float]:
        """Return the possible times at which the fault has begun: of the best fault, and of all faults together."""
        bank = self._statistics_of_steps()
        if bank.joint <= RISE**2:
            return [self._time - self.window]
        best = int(bank.onsets[np.argmax(bank.z)])
        # A fault is evident for the alarm delay. After a later onset, few readings can contradict a hypothesis.
        youngest = self.alarm_delay if self._fits is not None else 0.0
        ages = [max(float(self._bank.ages[k]), youngest) for k in (best, bank.joint_onset)]
        return [self._time - age for age in dict.fromkeys(ages)]

    def _within_bounds(self, evidence: HypothesisEvidence) -> HypothesisEvidence:
        """Return the evidence without hypotheses whose parameters are outside their limits."""
        low, high = (bound / self._alarms for bound in self._bounds)
        is_outside = (evidence.sizes < low - FALL_SIZE) | (evidence.sizes > high + FALL_SIZE)

        def pairs() -> dict[tuple[int, int], PairFit]:
            fits = evidence.pairs().items()
            return {
                pair: fit
                for pair, fit in fits
                if np.all((fit.sizes >= low[[*pair]] - FALL_SIZE) & (fit.sizes <= high[[*pair]] + FALL_SIZE))
            }

        return evidence._replace(z=np.where(is_outside, -1.0, evidence.z), pairs=pairs)

    def _drop_names(self) -> None:
        """Drop the names of faults whose estimate is well known and small, if others remain."""
        directed = self._directed(self._joint_sizes)
        small = (directed < FALL_SIZE) & (self._joint_sigmas < FALL_SIZE)
        names = tuple(name for name in self.verdict.names if not small[self._indices[name]])
        if self._time - self._dropped_at < self.alarm_delay or not names or names == self.verdict.names:
            self._dropped_at = self._dropped_at if names and names != self.verdict.names else self._time
        elif len(names) > 1:
            self._set_verdict(VerdictKind.SEVERAL, names, faults=names)
        elif directed[k := self._indices[names[0]]] >= FALL_SIZE:
            self._set_fault(k, float(self._joint_sizes[k]))

    def _add_names(self) -> None:
        """Add the names of faults that are known to be present besides those of the alarm.

        The comparison of a second fault can have replaced the names of the first one, which the filter has adopted.
        """
        sizes, sigmas = self._directed(self._joint_sizes), self._joint_sigmas
        is_present = (sizes > RISE * sigmas) & (sizes >= RISE_SIZE) & (sigmas < FALL_SIZE)
        # Other estimates can drift because the model is not accurate.
        is_present &= self._is_adopted
        present = [self.faults[k].name for k in np.flatnonzero(is_present).tolist()]
        further = tuple(name for name in present if name not in self.verdict.names)
        is_known = self.verdict.kind in (VerdictKind.FAULT, VerdictKind.SEVERAL) and self._misfit <= MISFIT
        if not further or not is_known or self._step_since < math.inf:
            self._complete_at = self._time
        elif self._time - self._complete_at >= self.alarm_delay:
            names = (*self.verdict.names, *further)
            self._set_verdict(VerdictKind.SEVERAL, names, faults=names)

    def _directed(self, sizes: Array) -> Array:
        """Return sizes in the directions of their faults."""
        return np.where(self._is_two_sided, np.abs(sizes), self._directions * sizes)

    def _add_fault(self) -> None:
        """Let the filter adopt a further step during a confirmed alarm, and add its fault to the names."""
        statistics = self._statistics_of_steps()
        k = int(np.argmin(np.where(statistics.z > RISE, statistics.rests, np.inf)))
        # A fault that grows steadily is not a step, and is followed in several steps.
        explained = GROWN if self._adopted[k] * statistics.sizes[k] > 0.0 else EXPLAINED
        if statistics.rests[k] <= chi_square_limit(len(self.faults) - 1) + (1.0 - explained) * statistics.joint:
            is_adopted = self._adopt(int(statistics.onsets[k]), (k,), self._adopted[[k]] + statistics.sizes[[k]])
            if is_adopted and self.faults[k].name not in self.verdict.names:
                names = (*self.verdict.names, self.faults[k].name)
                self._set_verdict(VerdictKind.SEVERAL, names, faults=names)

    def _judge_again(self, fits: HypothesisComparison, is_step: bool) -> None:
        """Compare the names of a confirmed alarm with other faults by fits to the readings since a further step.

        Another size of the named faults is the simplest explanation, and then another fault instead of them. Without a
        step, the named faults may still grow.
        """
        statistics, ages = self._statistics_of_steps(), self._bank.ages
        if self._judge_from_begin(statistics, is_step):
            return
        named = tuple(sorted(self._indices[name] for name in self.verdict.names))
        steps = (self._adopted + statistics.sizes) * self._alarms
        if not is_step:
            age = GROWING * self.window
            self._next_judgement = self._time + age
            found = fits.explanations(self._time - age, named, self._adopted * self._alarms)
            self._grows = self._is_walking
            if found and named in found and self._is_walking:
                self._adopt_grown(ages.size, named, found[named], self._time - age)
            return
        # The estimates at the step contain the errors of the steps before it, which matter less later.
        least = ONSET * self.alarm_delay
        onset, younger = statistics.joint_onset, int(np.argmin(np.where(ages >= least, ages, np.inf)))
        found = fits.explanations(self._time - float(ages[onset]), named, steps)
        if found == {} and ages[onset] > ages[younger] >= least:
            # A fault that grows is constant only for a short time.
            onset, found = younger, fits.explanations(self._time - float(ages[younger]), named, steps)
        age = float(ages[onset])
        self._next_judgement = self._time + max(0.25 * age, self.alarm_delay)
        if found is None:
            self._add_fault()
        elif named in found:
            self._adopt_grown(onset, named, found[named], self._time - age)
        elif age >= least and () not in found:
            self._rename(onset, named, found)

    def _judge_from_begin(self, statistics: FaultStatistics, is_step: bool) -> bool:
        """Compare single faults, which may grow, by all readings of a confirmed alarm; return False if none fits."""
        age = self._time - self._begun
        if len(self.verdict.names) > 1 or not age <= FOLLOWED * self.window:
            return False
        steps = (self._adopted + statistics.sizes) * self._alarms
        best = self._compare(self._begun, statistics, steps, can_grow=True)
        evidence = best.evidence
        self._next_judgement = self._time + max(0.5 * age, self.alarm_delay)
        if not (best.is_by_fits and best.is_explained):
            return False
        probabilities = self._probabilities_of(best)
        members = probable_set(probabilities)
        if float(np.sum(probabilities[members])) < LIKELY:
            return False
        members += [k for k in evidence.unknown if k not in members]
        is_new = is_step or self.verdict.names != (self.faults[members[0]].name,)
        self._judged, self._suspected = probabilities, ()
        self._name(members, evidence.sizes)
        bank = self._bank.ages.size
        self._is_confirmed = len(members) == 1 and self._adopt_single(members[0], best, bank, is_new=is_new)
        return True

    def _adopt_grown(self, onset: int, members: Hypothesis, fit: HypothesisFit, since: float) -> None:
        """Let the filter adopt another size of named faults, which can grow."""
        sizes, growths = self._grown(since, members, fit.sizes[: len(members)] / self._alarms[list(members)])
        self._grows = bool(growths.any())
        self._adopt(onset, members, sizes, since, growths)

    def _rename(self, onset: int, named: Hypothesis, found: Mapping[Hypothesis, HypothesisFit]) -> None:
        """Replace the names of a confirmed alarm by those of the hypotheses that explain the readings since a step."""
        since, singles = self._time - float(self._bank.ages[onset]), sorted(h[0] for h in found if len(h) == 1)
        self._judged, self._suspected = None, ()
        if not found:
            self._is_confirmed, self._judged = False, np.zeros(len(self.faults))
            self._set_verdict(VerdictKind.NONE_FITS)
            return
        if len(singles) > 1:
            self._is_confirmed, self._begun = False, since
            self._name(singles, np.zeros(len(self.faults)))
            return
        # A further fault before two others.
        chosen = min(found, key=lambda h: (not set(named) < set(h), found[h].cost))
        sizes = found[chosen].sizes / self._alarms[list(chosen)]
        if singles:
            self._set_fault(singles[0], float(sizes[0]))
        else:
            names = tuple(self.faults[k].name for k in chosen)
            self._set_verdict(VerdictKind.SEVERAL, names, faults=names)
        members = self._with_former(chosen)
        self._adopt(onset, members, np.append(sizes, np.zeros(len(members) - len(chosen))), since)

    def _adopt(
        self, onset: int, members: Hypothesis, sizes: Array, since: float | None = None, growths: Array | None = None
    ) -> bool:
        """Let the filter adopt total changes of some faults, in alarm sizes; return False if the bank cannot.

        The bank needs information on these faults at the onset, unless readings since a time can be fitted. `growths`
        are the parts of the changes by which the faults have grown since then.
        """
        indices, is_in_bank = list(members), onset < self._bank.ages.size
        has_fit = self._fits is not None and since is not None
        if is_in_bank:
            is_informed = bool(
                np.all(self._bank.gram[onset, indices, indices] * self._alarms[indices] ** 2 > self.temper)
            )
        elif not has_fit:
            return True  # the estimates of the filter contain the change
        if not ((has_fit or is_informed) and np.all(np.abs(sizes) < LARGEST)):
            return False
        # Rounded, so that the exported C code adopts steps with the same bits.
        sizes = np.asarray(sizes, dtype=np.float32).astype(np.float64)
        steps = sizes - self._adopted[indices]
        self._adopted[indices] = sizes
        self._is_adopted[indices] |= np.abs(sizes) >= FALL_SIZE
        known = onset if is_in_bank and is_informed else -1
        begun = since if since is not None and has_fit else math.nan
        alarms, self._is_walking = self._alarms[indices], growths is not None and bool(growths.any())
        grown = growths * alarms if growths is not None and self._is_walking else np.zeros(0)
        self.adoption = Adoption(known, members, steps * alarms, begun, grown, sizes * alarms)
        self._next_review, self._step_since = -math.inf, math.inf
        return True

    def reject_adoption(self) -> None:
        """Take back the last adoption, because the filter could not adopt it, and a verdict that depends on it."""
        adoption, self.adoption = self.adoption, None
        if adoption is None:
            return
        members = list(adoption.members)
        self._adopted[members] -= adoption.sizes / self._alarms[members]
        if self._is_confirmed and any(self.faults[k].name in self.verdict.names for k in members):
            self._is_confirmed, self._suspected, self._judged = False, (), np.zeros(len(self.faults))
            self._set_verdict(VerdictKind.NONE_FITS)

    def _adopt_return(self, steps: StepEvidence, is_alarm: bool) -> None:
        """Let the filter adopt a step that is no new fault: against its direction, or a change during an alarm."""
        onset, k = np.unravel_index(np.argmax(np.abs(steps.roots)), steps.roots.shape)
        root, size = steps.roots[onset, k], steps.sizes[onset, k]
        is_return = abs(root) > RISE and abs(size) >= FALL_SIZE and (is_alarm or root * self._directions[k] < 0.0)
        if is_return and not self._evident(steps, self._adopted, RISE, RISE_SIZE)[onset, k]:
            self._adopt(int(onset), (int(k),), self._adopted[[k]] + size)

    def _name(self, members: list[int], sizes: Array) -> None:
        """Set the verdict of an alarm whose fault is one of `members`; sizes are in alarm sizes."""
        names = tuple(self.faults[k].name for k in members)
        if len(members) == 1:
            self._set_fault(members[0], float(sizes[members[0]]))
        else:
            pairs = combinations(names, 2)
            sensors = [self._separating[pair] for pair in map(frozenset, pairs) if pair in self._separating]
            self._set_verdict(VerdictKind.NOT_ISOLABLE, names, faults=names, sensors=tuple(dict.fromkeys(sensors)))

    def _set_fault(self, index: int, size: float) -> None:
        """Set the verdict of an alarm with one fault; `size` is its change in alarm sizes."""
        fault = self.faults[index]
        unit = readable_unit(fault.unit, size * fault.alarm)
        change = scaled(size * fault.alarm, fault.unit, unit)
        self._set_verdict(VerdictKind.FAULT, (fault.name,), fault=fault.name, change=change, unit=unit, times=abs(size))

    def _compare_estimates(self, statistics: FaultStatistics, since: float) -> HypothesisEvidence:
        """Compare the hypotheses by the bank and the estimates of the filter."""
        s = statistics
        already = np.where(s.onsets < self._bank.ages.size, self._adopted, 0.0)

        def pairs() -> dict[tuple[int, int], PairFit]:
            base = self._adopted if s.joint_onset < self._bank.ages.size else np.zeros(len(self.faults))
            fits = fits_of_pairs(s, self._directions).items()
            return {pair: PairFit(fit.rest, fit.sizes + base[list(pair)]) for pair, fit in fits}

        _, squares, n_readings = next((sums for sums in reversed(self._sums) if sums[0] <= since), self._sums[0])
        # The filter has the innovations of a healthy plant; the best fault explains a part of them.
        explained = self.temper * float(np.max(np.maximum(s.z, 0.0))) ** 2
        squares = max(self._squares - squares - explained / self.healthy_nis, 0.0)
        growths, count = np.zeros(len(self.faults)), self._n_readings - n_readings
        return HypothesisEvidence(
            s.z, s.sizes + already, s.joint, s.rests, pairs, squares, count, growths, left=LEFT_LINEARLY
        )

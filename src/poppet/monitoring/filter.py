"""Filter of a running plant: estimates of states, faults, nuisances and offsets after each sample."""

from __future__ import annotations

import math
from collections import deque
from functools import cached_property
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from poppet.identify.fit.residuals import whiteness
from poppet.monitoring.fault_statistics import OnsetBank
from poppet.monitoring.initial_estimate import InitialState, ordered_product
from poppet.monitoring.input_course import FilledSample, InputCourse
from poppet.monitoring.onsets import ONSETS, PER_DELAY, slot_to_renew
from poppet.monitoring.plan import WatchPlan
from poppet.monitoring.plant_estimator import EstimateReplay, make_estimator, use_last
from poppet.monitoring.verdicts import Adoption, OpenSteps
from poppet.monitoring.window_model import Samples
from poppet.monitoring.windows import FLAT, Arrival, Window, changes_of_rates
from poppet.timeseries.measurements.measurement import LEAST_SAMPLES

Array = NDArray[np.float64]

STARTS = 1.0 / 12.0, 1.0 / 6.0, 1.0 / 3.0, 2.0 / 3.0
"""Times of the fits after a start, in windows."""
IMPROBABLE = 1e-3
"""Probability of the residuals of such a fit, or of their whiteness, below which the plant has changed in it."""
MOST_STARTS = 3
"""Number of starts after which improbable fits are accepted: the model is not accurate."""
ABRUPT = 20.0
"""Deviation of several successive readings, in gates, above which a state has jumped: no fault is as fast."""
FIRST, RETRIES = 5, 2
"""Number of samples within which the reading of a start can prove an outlier, and of repeated starts."""
GROWTH = 0.25
"""Longest time for which the growth of a fault is constant, in windows."""
LINEAR = 0.3
"""Error of the changes of all estimates by an adopted step that is not fitted, relative to their sizes."""
MOST_FITTED = 20_000
"""Largest number of samples of such a fit."""
GAP = 30.0
"""Number of usual sample times above which the inputs between two samples are unknown."""
LOST, UNLIKELY = 1.75, 2.0
"""Number of shortest sample times above which samples are missing, and deviation of a reading after a change of an
input in this time, in standard deviations, above which the input has changed before its sample."""
FORGET = 0.05
"""Weight of a new sample time in the mean."""
FARTHEST = 30.0
"""Largest change of a free number, in largest standard deviations; beyond it, the filter starts again."""
CHECK = 0.05
"""Time between two of these checks, in windows."""
REWIND = 64
"""Largest number of samples after which a late reading is still used."""
REWIND_MEMORY = 4_000_000
"""Largest size of the kept estimates for late readings [bytes]."""
ARRIVALS = 32
"""Number of estimates per window that are kept as arrival priors."""
MOST_SAMPLES = 65_536
"""Largest number of kept samples."""
REQUESTED = 24
"""Number of estimates that are kept because they were arrival priors lately."""
WINDOWS = 2
"""Number of windows for which samples and arrival priors are kept."""


class Healthy(Protocol):
    """Healthy values of the free numbers of a plan with their standard deviations, (m,), and the noise."""

    @property
    def values(self) -> Array:
        """Healthy values."""

    @property
    def sigmas(self) -> Array:
        """Standard deviations."""

    @property
    def noise(self) -> Array:
        """Standard deviations of the readings, which include the lack of fit of the model, (c,)."""


class FaultPosterior(NamedTuple):
    """Joint distribution of the changes of all faults; nuisances, offsets and states are marginalised."""

    change: Array  # (f,) changes from the baseline [SI]
    covariance: Array  # (f, f)


class PlantFilter:
    """Extended Kalman filter for states and free numbers, with a bank of onsets of the faults.

    Faults have a slow random walk. The bank finds steps of faults, and `adopt` adds a step to the estimates. A reading
    is used if it is not missing, and if its deviation from the expected reading is within the gate of the sensor.
    Single readings outside are outliers; the third one in succession on the same side is used.

    The states start from the first readings. While the estimates are uncertain, the model is not linear within their
    standard deviations, and the filter would become certain of wrong values. During the first window, fits of all
    samples (`poppet.monitoring.windows`) therefore replace the estimates several times. Before the last of these fits,
    nothing is known about the faults. After a gap, or a jump of a state, only the states start again.

    Parameters
    ----------
    plan : WatchPlan
        Sensors, inputs and free numbers.
    baseline : Baseline, optional
        Healthy values of the free numbers, and noise of the readings; by default those of the circuit and the plan.
    fuses : bool, optional
        True to use fused multiply-add operations. If False, the results have the bits of the exported C code.
    fits : bool, optional
        If False, no sample is fitted, as in the exported C code. Nothing is known about the faults during the first
        window.
    """

    def __init__(
        self, plan: WatchPlan, baseline: Healthy | None = None, *, fuses: bool = True, fits: bool = True
    ) -> None:
        self.plan, self._has_fits = plan, fits
        model = plan.instance.model
        self.states = tuple(state.name for state in model.states)
        self._nominal = np.array([state.nominal for state in model.states])
        n, f, m = len(self.states), len(plan.faults), plan.prior.size
        self._n, self._n_faults, self._n_memory = n, f, len(model.memory)
        self._faults = slice(n, n + f)
        self._alarms = np.array([fault.alarm for fault in plan.faults])
        self.healthy = plan.reference if baseline is None else np.asarray(baseline.values, dtype=np.float64)
        variances = plan.prior**2
        if baseline is not None:
            # The other free numbers differ from the baseline by their stated deviations at most.
            variances[:f] += np.asarray(baseline.sigmas, dtype=np.float64)[:f] ** 2
        self.prior_covariance = np.diag(variances) if m else np.zeros((0, 0))
        stated = np.array([channel.noise for channel in plan.channels])
        self.noise = stated if baseline is None else np.asarray(baseline.noise, dtype=np.float64)
        self.initial, self._inputs = InitialState(plan, self.noise, fuses=fuses), InputCourse(plan)
        self._estimator = make_estimator(plan, fuses)
        self._replay = EstimateReplay(plan, self.noise, self._inputs, fuses=fuses)
        self._estimator.noise[:] = self.noise**2
        self._onsets = np.full(ONSETS, math.nan)  # times of the onsets [s]
        self._spacing = plan.alarm_delay / PER_DELAY
        # Kept estimates of the last samples.
        e = self._estimator
        memory = e.p[e.p.size - self._n_memory :]
        self._squares = np.zeros(1)  # sum of squared innovations
        self._arrays = e.estimate, e.signatures, e.numerators, e.gram, e.rejected, memory, self._onsets, self._squares
        length = max(4, min(REWIND, REWIND_MEMORY // sum(array.nbytes for array in self._arrays)))
        self._kept = [np.empty((length, *array.shape)) for array in self._arrays]
        self._count = 0  # number of kept estimates
        self._usual_step, self._shortest_step = 0.0, math.inf  # mean and shortest time between recent samples [s]
        self._age, self._retries = 0, RETRIES  # number of samples since the start, and of its permitted repetitions
        self._next_onset = self._next_arrival = self._next_check = math.inf
        self._start = self.healthy, self.prior_covariance  # free numbers and their covariance at the start
        self._fits: list[float] = []  # times of the next fits after the start
        self._is_fitted = False
        self._starts = 0  # number of starts without accepted fits
        # Confirmed sizes of the faults of the alarm [SI], and times of their last confirmation [s].
        self._grown, self._adopted_at = np.zeros(f), np.full(f, math.nan)
        self._at_onset: list[Arrival | None] = [None] * ONSETS  # estimates at the onsets
        self._requested: list[Arrival] = []  # last snapshots
        self._history: deque[FilledSample] = deque(maxlen=MOST_SAMPLES)
        self._arrivals: deque[Arrival] = deque(maxlen=WINDOWS * ARRIVALS)
        self.restarts = 0  # number of restarts of the states after gaps and failures
        self.ignored = 0  # number of samples that were too late
        self.lost_changes = 0  # number of changes of an input whose time is unknown

    # Results ---------------------------------------------------------------------------------------------------------

    @property
    def time(self) -> float:
        """Time of the newest sample [s], NaN before the first one."""
        return self._history[-1].time if self._history else math.nan

    @property
    def mean(self) -> Array:
        """Estimates: states, then free numbers, (n + m,)."""
        return self._estimator.mean.copy()

    @property
    def covariance(self) -> Array:
        """Covariance of the estimates, (n + m, n + m)."""
        return self._estimator.covariance.copy()

    @property
    def theta(self) -> Array:
        """Estimates of the free numbers, (m,)."""
        return self._estimator.mean[self._n :].copy()

    @property
    def sigmas(self) -> Array:
        """Standard deviations of the free numbers, (m,)."""
        sigmas: Array = np.sqrt(self._estimator.covariance.diagonal()[self._n :])
        return sigmas

    @property
    def expected(self) -> Array:
        """Readings of the last sample that the filter expected, (c,)."""
        return self._estimator.expected.copy()

    @property
    def innovations(self) -> Array:
        """Readings of the last sample minus expected ones, (c,), NaN for missing readings."""
        return self._estimator.innovations.copy()

    @property
    def deviations(self) -> Array:
        """Standard deviations of the innovations, (c,)."""
        return self._estimator.deviations.copy()

    @property
    def used(self) -> Array:
        """1 for used readings of the last sample, 0 for missing and -1 for rejected ones, (c,)."""
        return self._estimator.used.copy()

    @property
    def nis(self) -> float:
        """Joint squared normalised innovation of the used readings of the last sample."""
        return self._estimator.nis

    @property
    def count(self) -> int:
        """Number of used readings of the last sample: the mean of `nis` for a correct model."""
        return int(np.count_nonzero(self._estimator.used > 0.0))

    def fault_posterior(self) -> FaultPosterior:
        """Return the distribution of the changes of the faults from the baseline, without recent steps."""
        faults = self._faults
        if not self._is_fitted:
            return FaultPosterior(np.zeros(self._n_faults), np.diag(self.plan.cap[: self._n_faults] ** 2))
        change = self._estimator.mean[faults] - self.healthy[: self._n_faults]
        return FaultPosterior(change, self._estimator.covariance[faults, faults].copy())

    def bank(self) -> OnsetBank:
        """Return the evidence for steps of the faults; the arrays change with the next sample."""
        ages = np.where(np.isnan(self._onsets), 0.0, self.time - self._onsets)
        return OnsetBank(ages, self._estimator.numerators, self._estimator.gram)

    def snapshot(self, time: float) -> Arrival:
        """Return the estimate after the last sample until a time [s], or else the earliest kept one.

        The estimates at the onsets of the bank are kept, others at regular times within two windows, and the last
        results: a fault is judged again after the bank has dropped its onset. The samples between such a time and the
        stated one are used again.
        """
        at_onset = (arrival for arrival in self._at_onset if arrival is not None)
        earlier = [arrival for arrival in (*self._arrivals, *at_onset, *self._requested) if arrival.time <= time]
        start = max(earlier, key=lambda arrival: arrival.time, default=self._arrivals[0])
        latest = self._replay(start, self._history, time, self._estimator.walk)
        others = [arrival for arrival in self._requested if arrival is not latest]
        self._requested = [*others, latest][-REQUESTED:]
        return latest

    def samples(self, since: float) -> Samples:
        """Return the kept samples after a time [s], and those before it that its delayed inputs need."""
        since -= max((item.delay for item in self.plan.inputs), default=0.0)
        selected: list[FilledSample] = []
        for sample in reversed(self._history):
            selected.append(sample)
            if sample.time <= since:
                break
        selected.reverse()
        return Samples(
            np.array([sample.time for sample in selected]),
            np.array([sample.readings for sample in selected]).reshape(-1, len(self.plan.channels)),
            np.array([sample.row for sample in selected]).reshape(-1, len(self.plan.inputs)),
        )

    # Samples ---------------------------------------------------------------------------------------------------------

    def update(self, time: float, readings: Array, inputs: Array | None = None, *, is_gap: bool = False) -> None:
        """Use a sample.

        A sample that is earlier than the newest one is inserted, and the samples after it are repeated.

        Parameters
        ----------
        time : float
            Time of the sample [s].
        readings : ndarray
            Readings of the sensors in SI, (c,), NaN for missing readings.
        inputs : ndarray, optional
            Driven inputs in SI, (d,), NaN for missing values, which keep their last value.
        is_gap : bool, optional
            True if the inputs since the previous sample are unknown. The states then start again from the readings.
        """
        driven = None if inputs is None else np.array(inputs, dtype=np.float64)
        values = np.array(readings, dtype=np.float64)
        if not self._history:
            sample = FilledSample(time, values, driven, self._inputs.first_row(driven))
            self._initialise(sample, self.healthy, self.prior_covariance)
        elif time >= self._history[-1].time:
            step = time - self._history[-1].time
            self._process(time, values, driven, is_gap)
            if step > 0.0:
                usual = self._usual_step or step
                shortest = min(self._shortest_step, usual)
                self._shortest_step = min(step, shortest + FORGET * (usual - shortest))
        else:
            self._insert(time, values, driven)

    def _initialise(self, sample: FilledSample, theta: Array, covariance: Array) -> None:
        """Start the states from the readings of a sample."""
        self._start = theta, covariance
        self._history.clear()
        self._arrivals.clear()
        self._requested.clear()
        self._history.append(sample)
        self._count, self._age, self._usual_step, self._next_arrival = 0, 0, 0.0, -math.inf
        self._next_check = sample.time + CHECK * self.plan.window
        start, estimator = self.initial.estimate(sample.readings, theta, covariance), self._estimator
        estimator.mean[:], estimator.covariance[:] = start.mean, start.covariance
        sizes = np.maximum(np.abs(start.mean[: self._n]), self._nominal)
        estimator.walk[: self._n] = (self.plan.state_noise * sizes) ** 2
        estimator.time[0] = sample.time
        estimator.restart()
        estimator.u[:] = self._inputs.vector(self._history)
        estimator.readings[:] = np.where(start.is_used, np.nan, sample.readings)
        estimator.correct()
        if not self._is_fitted or self._fits:
            self._is_fitted, self._starts = False, self._starts + 1
            fractions = STARTS if self._has_fits else (1.0,)
            self._fits = [sample.time + fraction * self.plan.window for fraction in fractions]
        self._clear_bank()
        self._keep()

    def _process(self, time: float, readings: Array, inputs: Array | None, is_gap: bool = False) -> None:
        previous = self._history[-1]
        step = time - previous.time
        sample = FilledSample(time, readings, inputs, self._inputs.fill(inputs, previous.row))
        longest = self.plan.window
        if self.plan.inputs and self._usual_step > 0.0:
            longest = min(longest, GAP * self._usual_step)
        self._history.append(sample)
        is_moved = not is_gap and step <= longest and use_last(self._estimator, self._inputs, self._history)
        if is_moved and time >= self._next_check:
            self._next_check = time + CHECK * self.plan.window
            is_moved = not self._is_far()
        if not is_moved:
            self._resume(sample, step)
            return
        self._age += 1
        self._squares += self._estimator.nis
        if (
            self._age < FIRST
            and (self._retries or not self._has_fits)
            and (np.abs(self._estimator.rejected) > 1.0).any()
        ):
            # The reading of the start was an outlier, not these ones.
            self._retries = max(0, self._retries - 1)
            self._initialise(sample, *self._start)
            return
        if self._age == FIRST:
            self._retries = RETRIES
        has_lost_change = self._has_fits and self._has_lost_change(previous, sample)
        if has_lost_change or (self._has_fits and self._has_jumped() and not self._is_step_of_fault()):
            self.lost_changes += has_lost_change
            self._resume(sample, step)
            return
        self._usual_step += (step - self._usual_step) * (FORGET if self._usual_step > 0.0 else 1.0)
        if self._fits and time >= self._fits[0]:
            self._fits.pop(0)
            self._fit_start()
        if time >= self._next_onset:
            self._begin_onset(slot_to_renew(self._onsets, time, self.plan.window))
        self._keep()

    def _is_step_of_fault(self) -> bool:
        """Return True if a large fault that began some time ago explains most of the squared innovations since then."""
        e = self._estimator
        for slot in np.flatnonzero(self.time - self._onsets >= self.plan.alarm_delay).tolist():
            before, information = self._at_onset[slot], e.gram[slot].diagonal()
            explained = np.max(e.numerators[slot] ** 2 / np.maximum(information, 1e-300), initial=0.0)
            if before is not None and explained > 0.5 * (self._squares[0] - before.squares):
                return True
        return False

    def _has_jumped(self) -> bool:
        """Return True if successive readings of a channel deviate so much that a state must have jumped."""
        e = self._estimator
        if not e.rejected.any():
            return False
        is_used_outside = (np.abs(e.rejected) > 1.0) & (e.used > 0.0)
        return bool((is_used_outside & (np.abs(e.innovations) > ABRUPT * np.sqrt(e.gates) * e.deviations)).any())

    def _has_lost_change(self, previous: FilledSample, sample: FilledSample) -> bool:
        """Return True if an input has changed while samples are missing, and the readings show an earlier change."""
        e = self._estimator
        if sample.row is previous.row or not sample.time - previous.time > LOST * self._shortest_step:
            return False
        return bool((np.abs(e.innovations) > UNLIKELY * e.deviations).any())

    @cached_property
    def _growing_window(self) -> Window:
        tolerance = self.plan.circuit.run.tolerance
        return Window(self.plan, healthy=self.healthy, noise=self.noise, tolerance=tolerance, grows=True)

    def _fit_start(self) -> None:
        """Replace the estimates by those of a fit of all samples since the start.

        If the plant has changed since the start, a new start begins.
        """
        start = self._arrivals[0]
        samples = self.samples(start.time)
        has_fit = self._has_fits and samples.times.size <= MOST_FITTED
        fit = self._window.fit(samples, start) if has_fit else None
        if fit is not None and fit.is_complete:
            columns = [r[used == 1] for r, used in zip(fit.residuals.T, fit.used.T, strict=True)]
            white = [whiteness(residuals) for residuals in columns if residuals.size >= LEAST_SAMPLES]
            if min([fit.probability, *white]) < IMPROBABLE and self._starts < MOST_STARTS:
                self._initialise(self._history[-1], *self._start)
                return
            covariance = fit.arrival.covariance
            self._estimator.mean[:], self._estimator.covariance[:] = fit.arrival.mean, covariance
            # The fit has constant numbers. Those that walk have moved from their mean value, and the fit has moved the
            # other estimates with them.
            for k in np.flatnonzero(self.plan.walk) + self._n:
                moved = covariance[:, k] / max(covariance[k, k], 1e-300)
                variance = self.plan.walk[k - self._n] * (fit.arrival.time - start.time) / 3.0
                self._estimator.covariance[:] += variance * np.outer(moved, moved)
        self._is_fitted = not self._fits
        self._starts = 0 if self._is_fitted else self._starts
        self._clear_bank()
        self._count = 0  # a late sample must not return to estimates before the fit
        self._next_arrival = -math.inf  # nor may a snapshot begin before it

    @cached_property
    def _window(self) -> Window:
        return Window(self.plan, healthy=self.healthy, noise=self.noise, tolerance=self.plan.circuit.run.tolerance)

    def _resume(self, sample: FilledSample, gap: float) -> None:
        """Start the states again from a sample, and keep the estimates of the free numbers."""
        # The estimates before this sample, which may have changed them already.
        kept, total = self._kept[0][(self._count - 1) % len(self._kept[0])], self._estimator.mean.size
        theta = kept[2 + self._n : 2 + total].copy()
        covariance = kept[2 + total :].reshape(total, total)[self._n :, self._n :] + np.diag(self.plan.walk * gap)
        excess = np.maximum(1.0, np.sqrt(np.diag(covariance)) / self.plan.cap)
        covariance = covariance / np.outer(excess, excess)
        if self._is_far():
            theta, covariance = self.healthy, self.prior_covariance
        self.restarts += 1
        starts = self._starts  # a gap is no sign of an inaccurate model
        self._initialise(sample, theta, covariance)
        self._starts = max(starts, 1)

    def _is_far(self) -> bool:
        """Return True if impossible readings have moved a free number far away from its healthy value."""
        return bool(np.any(~(np.abs(self.theta - self.healthy) <= FARTHEST * self.plan.cap)))

    def restart(self, changes: Array | None = None) -> None:
        """Start again at the newest sample, from the baseline.

        Parameters
        ----------
        changes : ndarray, optional
            Confirmed changes of the faults from the baseline, (f,) [SI].
        """
        if self._history:
            theta = self.healthy.copy()
            theta[: self._n_faults] += 0.0 if changes is None else changes
            self._is_fitted, self._starts = False, 0
            self.restarts += 1
            self._initialise(self._history[-1], theta, self.prior_covariance)

    def _insert(self, time: float, readings: Array, inputs: Array | None) -> None:
        """Insert a late sample: return to the estimates before it, and repeat the later samples."""
        later = self._return_to(time)
        if later is None:
            self.ignored += 1
            return
        self._process(time, readings, inputs)
        for sample in later:
            self._process(sample.time, sample.readings, sample.inputs)

    def forget(self, channel: int, since: float) -> bool:
        """Repeat the samples after a time [s] without the readings of a channel.

        The result is False, and nothing changes, if the estimates at this time are no longer kept.
        """
        later = self._return_to(since)
        for sample in later or ():
            readings = sample.readings.copy()
            readings[channel] = math.nan
            self._process(sample.time, readings, sample.inputs)
        return later is not None

    def _return_to(self, time: float) -> list[FilledSample] | None:
        """Return to the estimates at a time, and return the later samples; None if the estimates are not kept."""
        later: list[FilledSample] = []
        while self._history and self._history[-1].time > time:
            later.append(self._history.pop())
        later.reverse()
        if not self._history or len(later) >= min(self._count, len(self._kept[0])):
            self._history.extend(later)
            return None
        self._restore(len(later))
        return later

    # Kept estimates --------------------------------------------------------------------------------------------------

    def _keep(self) -> None:
        """Keep the estimates after a sample, for late samples and as arrival priors."""
        k = self._count % len(self._kept[0])
        for copies, array in zip(self._kept, self._arrays, strict=True):
            copies[k] = array
        self._count += 1
        time = self._history[-1].time
        if time >= self._next_arrival:
            self._next_arrival = time + self.plan.window / ARRIVALS
            self._arrivals.append(self._arrival())
            oldest = time - WINDOWS * self.plan.window
            while self._history[0].time < oldest:
                self._history.popleft()

    def _arrival(self) -> Arrival:
        """Return a copy of the estimates after the newest sample."""
        e = self._estimator
        memory = e.p[e.p.size - self._n_memory :]
        squares = float(self._squares[0])
        return Arrival(self._history[-1].time, e.mean.copy(), e.covariance.copy(), memory.copy(), squares)

    def _restore(self, back: int) -> None:
        """Return to the estimates `back` samples ago, which belong to the last sample of the history."""
        self._count -= back
        k = (self._count - 1) % len(self._kept[0])
        for copies, array in zip(self._kept, self._arrays, strict=True):
            array[:] = copies[k]
        time = self._history[-1].time
        self._next_onset = max(self._onsets[np.isfinite(self._onsets)], default=math.inf) + self._spacing
        while self._arrivals and self._arrivals[-1].time > time:
            self._arrivals.pop()
        self._at_onset = [a if a is not None and a.time <= time else None for a in self._at_onset]
        self._requested = [arrival for arrival in self._requested if arrival.time <= time]
        self._estimator.u[:] = self._inputs.vector(self._history)

    # Onsets ----------------------------------------------------------------------------------------------------------

    def _clear_bank(self) -> None:
        """Remove all onsets, and begin a new one if something is known about the faults."""
        estimator = self._estimator
        estimator.signatures[:], estimator.numerators[:], estimator.gram[:] = 0.0, 0.0, 0.0
        self._onsets[:], self._next_onset = math.nan, math.inf
        self._at_onset = [None] * ONSETS
        if self._is_fitted:
            self._begin_onset(0)

    def _begin_onset(self, slot: int) -> None:
        """Let an onset begin at the newest sample."""
        self._estimator.renew(slot)
        self._at_onset[slot] = self._arrival()
        self._onsets[slot] = self._history[-1].time
        self._next_onset = self._onsets[slot] + self._spacing

    def changes_by_steps(self, steps: OpenSteps) -> Array:
        """Return the changes of the estimates of all faults (columns) by a step of each one alone (rows), (f, f)."""
        columns = steps.onsets * self._n_faults + np.arange(self._n_faults)
        changes: Array = (self._estimator.signatures[self._faults, columns] * steps.sizes).T
        return changes

    def adopt(self, adoption: Adoption) -> bool:
        """Add confirmed steps of faults to the estimates, and begin the bank again.

        The result is False, and nothing is added, if the bank contains no evidence for the steps at their onset, or if
        the estimates would exceed the limits of their parameters.
        """
        estimator = self._estimator
        is_linear = adoption.onset >= 0 and (not self._has_fits or adoption.since != adoption.since)
        adopted = self._linear_step(adoption) if is_linear else self._fit_step(adoption)
        is_fitted = adopted is not None and not is_linear
        if adopted is None and adoption.onset >= 0:
            adopted = self._linear_step(adoption)
        if adopted is None:
            # Without an onset in the bank, the estimates contain the change.
            return adoption.onset < 0
        estimator.mean[:], estimator.covariance[:] = adopted
        self._let_grow(adoption, is_fitted)
        self._fits.clear()  # they would take the step back: free numbers are constant in them
        self._clear_bank()
        self._count = 0  # a late sample must not take the step back
        self._next_arrival = -math.inf
        self._keep()
        return True

    def _let_grow(self, adoption: Adoption, is_fitted: bool) -> None:
        """Let a fault walk that grows in a fit, or that the filter adopts again with a larger size."""
        walk, n, now = self._estimator.walk, self._n, self._history[-1].time
        if is_fitted:
            duration = max(now - adoption.since, self.plan.alarm_delay)
            members = list(adoption.members)
            rates = np.resize(adoption.growths if adoption.growths.size else 0.0, len(members)) / duration
            limit = min(duration, GROWTH * self.plan.window)
            walk[[n + k for k in members]] = np.maximum(rates**2 * limit, self.plan.walk[members])
            self._adopted_at[members], self._grown[members] = now, adoption.totals
            return
        for k, size in zip(adoption.members, adoption.sizes.tolist(), strict=True):
            if size * self._grown[k] > 0.0:
                rate = size * size / max(now - self._adopted_at[k], self.plan.alarm_delay)
                walk[n + k] = max(walk[n + k], rate)
                moved = self._estimator.covariance[:, n + k] / self._estimator.covariance[n + k, n + k]
                # Until now, the error is that of a constant number, and it has moved the other estimates with it.
                self._estimator.covariance[:] += size * size / 3.0 * np.outer(moved, moved)
            else:
                walk[n + k] = self.plan.walk[k]
            self._adopted_at[k], self._grown[k] = now, self._grown[k] + size

    def end_growth(self) -> None:
        """Let all faults walk slowly again, after the end of an alarm."""
        if self._grown.any():
            self._grown[:] = 0.0
            self._estimator.walk[self._n :] = self.plan.walk

    def _linear_step(self, adoption: Adoption) -> tuple[Array, Array] | None:
        """Return mean and covariance with a step of faults from its effect on the estimates, or None."""
        estimator, members = self._estimator, list(adoption.members)
        columns = [adoption.onset * self._n_faults + k for k in members]
        signatures = estimator.signatures[:, columns]
        information = estimator.gram[adoption.onset][np.ix_(members, members)]
        if np.linalg.matrix_rank(information * np.outer(self._alarms[members], self._alarms[members])) < len(members):
            return None
        moved = ordered_product(signatures, adoption.sizes)
        mean = estimator.mean + moved
        is_outside = (mean[self._n :] < self.plan.low) | (mean[self._n :] > self.plan.high)
        # The exported C code adopts all steps.
        if self._has_fits and is_outside.any():
            return None
        uncertainty = 1.0 / information if len(members) == 1 else np.linalg.inv(information)
        # In a fixed order of operations, as in the exported C code.
        covariance = estimator.covariance + ordered_product(ordered_product(signatures, uncertainty), signatures.T)
        errors = LINEAR * moved
        covariance[np.diag_indices_from(covariance)] += errors * errors
        return mean, covariance

    def _fit_step(self, adoption: Adoption) -> tuple[Array, Array] | None:
        """Return mean and covariance from a fit of all samples since a step of faults began, or None without a fit.

        The faults of the step have no prior; the other numbers continue from the estimates before it.
        """
        members, n = self._n + np.array(adoption.members), self._n
        onset = adoption.since if adoption.since == adoption.since else float(self._onsets[adoption.onset])
        before = self.snapshot(onset)
        samples = self.samples(before.time)
        if samples.times.size > MOST_FITTED or not np.isfinite(samples.readings[samples.times > before.time]).any():
            return None
        window = self._growing_window if adoption.growths.size else self._window
        covariance, begin, steps = before.covariance.copy(), before.mean[n:].copy(), np.zeros(self._n_faults)
        steps[list(adoption.members)] = adoption.sizes
        begin[members - n] = self.healthy[members - n] + adoption.totals
        covariance[members, members] += (FLAT * self.plan.prior[members - n]) ** 2
        spread = onset - before.time + self._spacing
        shifts = spread * (changes_of_rates(self._window, samples, before) @ steps)
        covariance[:n, :n] += np.outer(shifts, shifts)
        walked = np.arange(n, covariance.shape[0])
        covariance[walked, walked] += self.plan.walk * (self.time - before.time)
        arrival = window.with_rates(before._replace(covariance=covariance))
        if adoption.growths.size:
            duration, rates = self.time - before.time, self.plan.prior.size + np.array(adoption.members)
            begin = np.pad(begin, (0, self._n_faults))
            begin[rates], begin[members - n] = adoption.growths / duration, begin[members - n] - adoption.growths
            is_grown = adoption.growths != 0.0
            flat = FLAT * self.plan.prior[members - n][is_grown] / duration
            arrival.covariance[n + rates[is_grown], n + rates[is_grown]] = flat**2
        fit = window.fit(samples, arrival, begin=begin)
        if not fit.is_complete:
            return None
        # The lack of fit widens all deviations.
        squares = float(np.sum(fit.residuals[fit.used == 1] ** 2)) + 2.0 * fit.prior_cost
        size = self._estimator.mean.size
        covariance = fit.arrival.covariance[:size, :size]
        return fit.arrival.mean[:size], covariance * max(1.0, squares / max(fit.freedom, 1))

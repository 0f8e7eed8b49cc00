"""Commissioning of a watch: baseline of a plant from a recording of its healthy operation.

The recording is fitted in windows, each of which continues from the estimate of the one before it. Both halves of the
recording are fitted separately, so that a change during the recording is noticed, and then combined. The residuals give
the lack of fit of each sensor, which increases the noise for a second pass and for the watch.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError
from poppet.identify.fit.residuals import correlation_time
from poppet.monitoring.baseline import Baseline, ChannelMisfit
from poppet.monitoring.healthy_statistics import healthy_statistics
from poppet.monitoring.initial_estimate import InitialState
from poppet.monitoring.plan import WatchPlan
from poppet.monitoring.verdicts import RISE
from poppet.monitoring.window_model import Samples
from poppet.monitoring.windows import Arrival, Window, WindowFit

Array = NDArray[np.float64]

LEAST_READINGS = 20
"""Minimum number of readings of each sensor."""
MOVES = 0.9
"""Ratio of the standard deviations of a number after and before the recording above which nothing was learnt."""
CHANGED, CHANGED_SIZE = 4.0, 0.25
"""Difference of the halves in standard deviations and in alarm sizes above which a fault number has changed."""
PRESENT, PRESENT_SIZE = 3.0, 1.0
"""Difference from the circuit above which the baseline contains a fault."""
UNDETERMINED = 0.2
"""Standard deviation in alarm sizes above which a fault number is not determined; an alarm requires five of them."""
UNUSUAL = 3.0
"""Deviation of a nuisance from the circuit in its standard deviations above which it is unusual."""
MISFIT = 2.0
"""Factor on the noise above which the lack of fit is reported."""
OUTLIERS = 0.01
"""Fraction of outliers above which they are reported."""
ONE_AMBIENT = 0.4
"""Relative difference of a deviation from the ambient pressure below which readings may be gauge pressures."""
REFINED = 1.05
"""Factor on the noise above which the recording is fitted again with the increased noise."""


class _NumbersEstimate(NamedTuple):
    """Gaussian estimate of the free numbers."""

    mean: Array
    covariance: Array


def commission(
    plan: WatchPlan,
    samples: Samples,
    *,
    recording: str = "",
    progress: Callable[[float], Any] | None = None,
) -> Baseline:
    """Return the baseline of a plant from a recording of its healthy operation.

    Parameters
    ----------
    plan : WatchPlan
        Plan of the watch.
    samples : Samples
        Recording of the healthy plant.
    recording : str, optional
        Name of the recording for messages and the baseline file.
    progress : callable, optional
        Function that is called with the fraction of the work that is done.

    Returns
    -------
    Baseline
        Healthy values, with remarks on doubtful ones.

    Raises
    ------
    InputErrors
        If the recording is shorter than the window of the plan, if a sensor has too few readings, if the circuit cannot
        be simulated, if the recording contains no information on any fault, or if a fault number changes between its
        halves.
    """
    _check(plan, samples, recording)
    fits = _RecordingFits(plan, samples, recording, progress or (lambda _: None))
    return fits.baseline()


def _check(plan: WatchPlan, samples: Samples, recording: str) -> None:
    """Raise all errors of a recording that is too short or has too few readings."""
    duration = float(samples.times[-1] - samples.times[0]) if samples.times.size else 0.0
    with ErrorCollector() as errors:
        if duration < plan.window:
            errors.add("baseline.short", recording=recording, duration=duration, window=plan.window)
        for channel, readings in zip(plan.channels, samples.readings.T, strict=True):
            count = int(np.count_nonzero(np.isfinite(readings)))
            if count < LEAST_READINGS:
                facts = {"recording": recording, "count": count, "least": LEAST_READINGS}
                errors.add("baseline.few_readings", channel.address, **facts)


class _RecordingFits:
    """Fits of one recording."""

    def __init__(self, plan: WatchPlan, samples: Samples, recording: str, progress: Callable[[float], Any]) -> None:
        self.plan, self.samples, self.recording, self.progress = plan, samples, recording, progress
        begin, end = float(samples.times[0]), float(samples.times[-1])
        count = 2 * max(1, int((end - begin) / (2.0 * plan.window)))
        self.edges = np.linspace(begin, end, count + 1)
        self.prior = _NumbersEstimate(plan.reference, np.diag(plan.prior**2))
        self.lead = max((item.delay for item in plan.inputs), default=0.0)
        self.memory = plan.instance.start()[1][len(plan.instance.model.parameters) :]

    def baseline(self) -> Baseline:
        """Fit the recording, and again with increased noise if the model does not fit; then check the estimates."""
        halves, fits = self._fit(np.ones(len(self.plan.channels)))
        misfit = _misfit(self.plan, fits)
        factors = np.array([channel.factor for channel in misfit])
        if factors.max() > REFINED:
            halves, fits = self._fit(factors)
        values, covariance = _combine(self.prior, halves)
        sigmas = np.sqrt(np.diag(covariance))
        self._check_information(sigmas)
        self._check_halves(halves)
        baseline = Baseline(
            self.plan, values, sigmas, misfit,
            duration=float(self.edges[-1] - self.edges[0]), readings=sum(int(np.count_nonzero(f.used)) for f in fits),
            recording=self.recording,
            remarks=(*self._number_notes(values, sigmas, halves), *self._sensor_notes(misfit, fits)),
        )  # fmt: skip
        statistics = healthy_statistics(baseline, self.samples, lambda done: self.progress(0.5 + 0.5 * done))
        notes = [
            Note("baseline.step", fault.address, name=fault.name, sigmas=float(z), time=float(time))
            for fault, z, time in zip(self.plan.faults, statistics.steps, statistics.times, strict=True)
            if z > RISE
        ]
        return replace(
            baseline,
            temper=statistics.temper,
            healthy_nis=statistics.healthy_nis,
            remarks=(*baseline.remarks, *notes),
        )

    def _fit(self, factors: Array) -> tuple[tuple[_NumbersEstimate, _NumbersEstimate], list[WindowFit]]:
        """Fit both halves of the recording with factors on the noise; return their estimates and all windows."""
        plan, n = self.plan, len(self.plan.instance.model.states)
        window = Window(plan, noise=factors * [channel.noise for channel in plan.channels])
        first = self.samples.readings[0]
        mean, covariance, _ = InitialState(plan).estimate(first, self.prior.mean, self.prior.covariance)
        arrival = Arrival(float(self.edges[0]), mean, covariance, self.memory)
        half, halves, fits = self.edges.size // 2, [], []
        for k, end in enumerate(self.edges[1:]):
            first, last = self.samples.times.searchsorted([arrival.time - self.lead, end], side="right")
            window_samples = Samples(*(column[max(0, first - 1) : last] for column in self.samples))
            if np.isfinite(window_samples.readings[window_samples.times > arrival.time]).any():
                fit = window.fit(window_samples, arrival)
                if not fit.is_complete:
                    raise InputError("baseline.no_run", recording=self.recording, begin=arrival.time, end=end)
                fits.append(replace(fit, slopes=np.zeros(0)))
                arrival = fit.arrival
            if k + 1 in (half, self.edges.size - 1):
                halves.append(_NumbersEstimate(arrival.mean[n:], arrival.covariance[n:, n:]))
                state = _NumbersEstimate(arrival.mean[:n], arrival.covariance[:n, :n])
                mean, covariance = _joint(state, self.prior)
                arrival = arrival._replace(mean=mean, covariance=covariance)
            self.progress(0.5 * (k + 1) / (self.edges.size - 1))
        return (halves[0], halves[1]), fits

    # Checks ----------------------------------------------------------------------------------------------------------

    def _check_information(self, sigmas: Array) -> None:
        """Raise an error if the recording determines no fault number better than before."""
        faults = self.plan.faults
        if np.all(sigmas[: len(faults)] > MOVES * self.plan.prior[: len(faults)]):
            names = [fault.name for fault in faults]
            raise InputError("baseline.no_information", recording=self.recording, names=names)

    def _check_halves(self, halves: tuple[_NumbersEstimate, _NumbersEstimate]) -> None:
        """Raise the errors of all fault numbers that change during the recording."""
        with ErrorCollector() as errors:
            for k, fault in enumerate(self.plan.faults):
                change, sigmas = _difference(halves, k)
                if sigmas > CHANGED and abs(change) > CHANGED_SIZE * fault.alarm:
                    facts = {"recording": self.recording, "name": fault.name, "unit": fault.unit, "sigmas": sigmas}
                    first, second = (half.mean[k] for half in halves)
                    errors.add("baseline.changed", fault.address, **facts, first=first, second=second)

    def _number_notes(
        self, values: Array, sigmas: Array, halves: tuple[_NumbersEstimate, _NumbersEstimate]
    ) -> Iterator[Note]:
        """Yield notes on doubtful values of faults and nuisances."""
        plan, deviations = self.plan, values - self.plan.reference
        for k, fault in enumerate(plan.faults):
            facts = {"name": fault.name, "unit": fault.unit, "value": values[k], "sigma": sigmas[k]}
            if sigmas[k] > UNDETERMINED * fault.alarm:
                yield Note("baseline.undetermined", fault.address, **facts, sizes=sigmas[k] / fault.alarm)
            if abs(deviations[k]) > max(PRESENT * sigmas[k], PRESENT_SIZE * fault.alarm):
                facts |= {"stated": plan.reference[k], "sizes": abs(deviations[k]) / fault.alarm}
                yield Note("baseline.contains", fault.address, **facts)
        ambient = plan.instance.surroundings.pressure
        absolute = [c.address for c in plan.channels if c.si_unit == "Pa" and not c.is_gauge]
        for k, name in enumerate(plan.names):
            # One ambient pressure is missing: the usual mistake with the unit of a gauge.
            if absolute and plan.units[k] == "Pa" and abs(deviations[k] / ambient + 1.0) < ONE_AMBIENT:
                yield Note("baseline.gauge", name, sensors=absolute)
        for k in range(len(plan.faults), len(plan.names)):
            facts = {"unit": plan.units[k], "value": values[k], "stated": plan.reference[k]}
            ratio = abs(deviations[k]) / plan.prior[k]
            if ratio > UNUSUAL:
                yield Note("baseline.unusual", plan.names[k], **facts, sigmas=ratio)
            if plan.walk[k] == 0.0 and _difference(halves, k)[1] > CHANGED:
                first, second = (half.mean[k] for half in halves)
                yield Note("baseline.drifted", plan.names[k], unit=plan.units[k], first=first, second=second)

    def _sensor_notes(self, misfit: tuple[ChannelMisfit, ...], fits: list[WindowFit]) -> Iterator[Note]:
        """Yield notes on sensors with a lack of fit or with many outliers."""
        masks = np.concatenate([fit.used for fit in fits])
        for k, channel in enumerate(self.plan.channels):
            if misfit[k].factor > MISFIT:
                yield Note("baseline.misfit", channel.address, **misfit[k]._asdict(), factor=misfit[k].factor)
            fraction = float(np.mean(masks[masks[:, k] != 0, k] == -1))
            if fraction > OUTLIERS:
                yield Note("baseline.outliers", channel.address, fraction=fraction)


def _joint(state: _NumbersEstimate, numbers: _NumbersEstimate) -> _NumbersEstimate:
    """Return the joint estimate of two independent ones."""
    n, m = state.mean.size, numbers.mean.size
    covariance = np.zeros((n + m, n + m))
    covariance[:n, :n], covariance[n:, n:] = state.covariance, numbers.covariance
    return _NumbersEstimate(np.append(state.mean, numbers.mean), covariance)


def _combine(prior: _NumbersEstimate, halves: tuple[_NumbersEstimate, _NumbersEstimate]) -> _NumbersEstimate:
    """Return the estimate from both halves, whose estimates both contain the prior."""
    # In prior standard deviations: the sizes of the numbers differ by many orders of magnitude.
    scale = np.sqrt(np.diag(prior.covariance))
    precisions = [np.linalg.inv(half.covariance / np.outer(scale, scale)) for half in halves]
    covariance = np.linalg.inv(sum(precisions) - np.eye(scale.size))
    changes = [(half.mean - prior.mean) / scale for half in halves]
    weighted = sum(precision @ change for precision, change in zip(precisions, changes, strict=True))
    return _NumbersEstimate(prior.mean + scale * (covariance @ weighted), covariance * np.outer(scale, scale))


def _difference(halves: tuple[_NumbersEstimate, _NumbersEstimate], k: int) -> tuple[float, float]:
    """Return the change of a number between the halves, and its size in standard deviations."""
    change = float(halves[1].mean[k] - halves[0].mean[k])
    return change, abs(change) / float(np.sqrt(sum(half.covariance[k, k] for half in halves)))


def _misfit(plan: WatchPlan, fits: list[WindowFit]) -> tuple[ChannelMisfit, ...]:
    """Return the lack of fit of each sensor from the residuals of all windows without outliers."""
    residuals, masks = np.concatenate([fit.residuals for fit in fits]), np.concatenate([fit.used for fit in fits])
    misfit = []
    for channel, series, is_used in zip(plan.channels, residuals.T, masks.T == 1, strict=True):
        values = series[is_used]
        ratio = float(np.sqrt(np.mean(values**2)))
        misfit.append(ChannelMisfit(ratio, correlation_time(values), channel.noise))
    return tuple(misfit)

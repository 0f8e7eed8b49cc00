"""Watch of a running plant: estimates, probabilities and alarms of each sample."""

from __future__ import annotations

import math
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import chain
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, raise_errors
from poppet.monitoring.absent_values import AbsentValues
from poppet.monitoring.baseline import Baseline, read_baseline
from poppet.monitoring.clock import StreamClock
from poppet.monitoring.commissioning import commission
from poppet.monitoring.filter import PlantFilter
from poppet.monitoring.isolable import Isolability, isolable
from poppet.monitoring.plan import WatchPlan, read_plan
from poppet.monitoring.record import WatchRecord, result_columns, rounded_number
from poppet.monitoring.recorded_rows import RecordedRows, held_values, read_rows
from poppet.monitoring.refit import WindowRefit
from poppet.monitoring.samples import Sample, SampleReader
from poppet.monitoring.stuck_sensors import StuckSensors
from poppet.monitoring.twin_file import ClockColumn, Twin, read_clock, read_twin_file
from poppet.monitoring.unknown_inputs import UnknownInputs
from poppet.monitoring.verdicts import FaultMonitor, VerdictKind, WatchVerdict
from poppet.monitoring.window_model import Samples
from poppet.timeseries.checks import FloatArray

Progress = Callable[[float], Any]
"""Function that is called with the fraction of the work that is done."""
DEFAULT_CLOCK = ClockColumn()
PROGRESS_ROWS = 500
"""Number of samples between two calls of the progress function."""
MANY_MISSING, MANY_OUTLIERS = 0.2, 0.03
"""Fractions of missing readings and of outliers of a sensor above which a note reports them."""
USUAL = 0.2
"""Quantile of the distances between the readings of a sensor, in rows, that is its usual distance."""
MOST_MESSAGES = 100
"""Maximum number of messages on used samples that a watch keeps."""
SHORTEST_GAP = 60.0
"""Shortest time without samples that is a gap [s]."""
BLIND = WatchVerdict(VerdictKind.NO_READINGS, (), Note(VerdictKind.NO_READINGS.value, ""))
"""Verdict without any readings."""


@dataclass(frozen=True)
class StateEstimate:
    """Estimate of a state or of a parameter.

    Parameters
    ----------
    value, sigma : float
        Value and standard deviation, in `unit`; pressures are absolute.
    unit : str
        SI unit.
    """

    value: float
    sigma: float
    unit: str


@dataclass(frozen=True)
class FaultEstimate(StateEstimate):
    """Estimate of the parameter of a fault.

    Parameters
    ----------
    change : float
        Difference to the baseline, in `unit`.
    probability : float
        Probability that this fault explains the readings. The rest to 1 is the healthy plant, or another cause.
    """

    change: float
    probability: float


class Watch:
    """Condition monitoring of a running plant.

    `poppet.watch` creates it. A watch without a baseline can only compute one (`commission`) and predict which faults
    the sensors can distinguish (`isolable`).

    Parameters
    ----------
    plan : WatchPlan
        Sensors, faults, nuisances and settings.
    baseline : Baseline, optional
        Healthy state of the plant.
    clock : ClockColumn, optional
        Key of the time in samples, and its unit.
    title : str, optional
        Title of records and reports.

    Attributes
    ----------
    messages : deque of InputError
        Last messages on samples that were used, such as a gap, a clock that was set, or a sensor that is stuck.
    """

    def __init__(
        self,
        plan: WatchPlan,
        baseline: Baseline | None = None,
        *,
        clock: ClockColumn = DEFAULT_CLOCK,
        title: str = "",
    ) -> None:
        self.plan, self.clock, self.title = plan, clock, title
        self.reader = SampleReader(plan, clock)
        self.columns = result_columns(plan)
        self._set_baseline(baseline)

    def _set_baseline(self, baseline: Baseline | None) -> None:
        """Start all estimates again from a baseline."""
        plan = self.plan
        self.time = math.nan  # of the last sample that was used [s]
        self.readings = np.full(len(plan.channels), math.nan)  # of this sample [SI]
        self.messages: deque[InputError] = deque(maxlen=MOST_MESSAGES)
        self.baseline = baseline
        self._clock = StreamClock(len(self.reader.columns), max(plan.window, SHORTEST_GAP))
        self._stuck = StuckSensors(plan.channels)
        self._absent = AbsentValues(self.reader.columns, len(plan.channels), plan.window)
        self._unknown = UnknownInputs(plan.inputs)
        self._is_gap = False  # True if the states must start again, because an input was unknown
        self._must_restart = False  # when a stuck sensor returns
        self.is_late = False  # True if the last sample was earlier than others
        if baseline is None:
            return
        self._filter = PlantFilter(plan, baseline)
        n_faults = len(plan.faults)
        self.monitor = FaultMonitor(
            plan.faults,
            alarm_delay=plan.alarm_delay,
            window=plan.window,
            temper=baseline.temper,
            healthy_nis=baseline.healthy_nis,
            refit=WindowRefit(plan, baseline, self._filter),
            bounds=(plan.free.low[:n_faults] - baseline.faults, plan.free.high[:n_faults] - baseline.faults),
        )

    # Results --------------------------------------------------------------------------------------------------------

    @property
    def state(self) -> dict[str, StateEstimate]:
        """Estimates of the states of the circuit, such as the pressure of a chamber, by address."""
        states = self.plan.instance.model.states
        sigmas = np.sqrt(np.diag(self.running_filter.covariance))
        return {
            state.name: StateEstimate(float(value), float(sigma), state.unit)
            for state, value, sigma in zip(states, self.running_filter.mean, sigmas, strict=False)
        }

    @property
    def faults(self) -> dict[str, FaultEstimate]:
        """Estimates of the faults by name, with their change and probability."""
        values, sigmas = self.fault_numbers()
        assert self.baseline is not None
        changes, probabilities = values - self.baseline.faults, self.monitor.probabilities
        return {
            fault.name: FaultEstimate(
                float(values[k]), float(sigmas[k]), fault.unit, float(changes[k]), float(probabilities[k])
            )
            for k, fault in enumerate(self.plan.faults)
        }

    @property
    def alarms(self) -> tuple[str, ...]:
        """Names of the faults of the present alarm; empty without an alarm."""
        _ = self.running_filter
        return self.monitor.alarm

    @property
    def alarm_text(self) -> str:
        """Names of the present alarm, joined by "or", or by "and" for faults that are present together."""
        joint = " and " if self.monitor.verdict.kind is VerdictKind.SEVERAL else " or "
        return joint.join(self.monitor.alarm)

    @property
    def verdict(self) -> WatchVerdict:
        """Conclusion on the present state of the plant, as a sentence with a code."""
        _ = self.running_filter
        verdict = self.monitor.verdict
        if verdict.names:
            return verdict
        return BLIND if self._absent.is_blind else self._unknown.verdict or verdict

    @property
    def running_filter(self) -> PlantFilter:
        """Filter of the states and free parameters; an error is raised without a baseline."""
        if self.baseline is None:
            raise InputError("twin.no_baseline")
        return self._filter

    def fault_numbers(self) -> tuple[FloatArray, FloatArray]:
        """Return values and standard deviations of the fault numbers, (f,).

        During an alarm, each fault that it names has the size with which it alone explains the readings. As long as the
        filter has not adopted a step that is evident, the standard deviations contain the changes that it can cause.
        """
        n, f = len(self.plan.instance.model.states), len(self.plan.faults)
        rows = slice(n, n + f)
        values = self.running_filter.mean[rows].copy()
        variances = self.running_filter.covariance.diagonal()[rows].copy()
        steps = self.monitor.open_steps()
        if steps is not None:
            changes = self.running_filter.changes_by_steps(steps)  # (f, f) by each fault alone
            is_named = np.array([fault.name in self.monitor.alarm for fault in self.plan.faults])
            values[is_named] += np.diag(changes)[is_named]
            own = np.diag(changes) * (0.5 if np.count_nonzero(is_named) == 1 else 1.0)
            np.fill_diagonal(changes, own)
            variances += np.max(changes**2, axis=0)
        return values, np.sqrt(variances)

    @property
    def nis(self) -> float:
        """Squared deviations of the readings of the last sample from their predictions; NaN without readings.

        It is also NaN after a late sample.
        """
        return self.running_filter.nis if self.running_filter.count and not self.is_late else math.nan

    # Samples --------------------------------------------------------------------------------------------------------

    def update(self, sample: Mapping[str, Any]) -> dict[str, Any]:
        """Process one sample, and return the estimates.

        Parameters
        ----------
        sample : mapping
            Mapping from the columns of the twin file, including the time, to values in their units. Without a column
            in the twin file, the key is the address, and the value is in SI. Missing values can be absent, None or NaN.
            Inputs hold their value.

        Returns
        -------
        dict
            Estimates with the keys of the CSV file: `time [s]`, for each fault `<fault> [unit]`, `<fault>.sigma` and
            `<fault>.probability`, then `nis` and `alarm`.

        Raises
        ------
        InputErrors
            If the watch has no baseline, a value or the time is invalid, or the sample is older than earlier ones. The
            estimates are then unchanged.
        """
        _ = self.running_filter
        problems: list[InputError] = []
        read = self.reader.read(sample, problems)
        if problems:
            # The next sample ends the time with unknown inputs.
            self._unknown.valid(read.values[len(self.plan.channels) :])
        raise_errors(problems)
        if not self.process(read, problems):
            raise_errors(problems or [InputError("stream.waiting", time=read.time)])
        self.messages.extend(problems)
        return self.row()

    def process(self, sample: Sample, problems: list[InputError]) -> bool:
        """Process one sample in SI units, and return False if it could not be used.

        Messages are added to the list `problems`. A sample that could not be used does not change the estimates. A late
        sample changes the estimates at the time of the newest one. While an input is unknown, readings are not used.
        """
        placed = self._clock.place(sample.time, sample.values, problems)
        if placed is None:
            return False
        n_channels = len(self.plan.channels)
        readings, inputs = placed.values[:n_channels], placed.values[n_channels:]
        was_unknown = bool(self._unknown)
        inputs = self._unknown.valid(inputs)
        self.is_late = placed.time < self._clock.latest
        self._is_gap |= was_unknown and not self._unknown
        if self._unknown or (self._is_gap and self.is_late):
            readings = [math.nan] * n_channels
        if not self.is_late:
            self.time, self.readings[:] = sample.time, placed.values[:n_channels]
        # The model has had wrong inputs. A late value ends this time, but the next sample starts the states again.
        is_gap = self._is_gap and not (self.is_late or self._unknown)
        self._is_gap &= not is_gap
        if self.is_late or self._unknown or is_gap:
            self._absent.check(placed.time, placed.values, problems)
            self._filter.update(placed.time, np.array(readings), np.array(inputs), is_gap=is_gap)
            if is_gap:
                self._stuck = StuckSensors(self.plan.channels)
        else:
            self._evaluate(placed.time, readings, np.array(inputs), problems)
        return True

    def _evaluate(self, time: float, readings: Sequence[float], inputs: FloatArray, problems: list[InputError]) -> None:
        """Use the readings of a sample, and set the verdict; the verdict does not change if a sensor may be stuck."""
        filter, stuck = self._filter, self._stuck
        self.readings[:] = stuck.without_stuck(time, readings, filter.expected, problems)
        self._absent.check(time, [*self.readings.tolist(), *inputs.tolist()], problems)
        for channel, since in stuck.new:
            self._must_restart |= not filter.forget(channel, since)
        lost_changes = filter.lost_changes
        filter.update(time, self.readings, inputs)
        if filter.lost_changes > lost_changes:
            problems.append(InputError("stream.lost_change", time=self.time))
        if stuck.is_suspected or (self._must_restart and stuck.is_stuck):
            return
        if self._must_restart:
            self._must_restart = False
            filter.restart(self.monitor.confirmed)
        change, covariance = filter.fault_posterior()
        self.monitor.update(time, filter.bank(), change, covariance, filter.nis, filter.count)
        if self.monitor.adoption is not None and not filter.adopt(self.monitor.adoption):
            self.monitor.reject_adoption()
        if not self.monitor.alarm:
            filter.end_growth()

    def row(self) -> dict[str, Any]:
        """Return the present estimates with the keys of the CSV file and nine digits; None for a missing NIS."""
        values, sigmas = self.fault_numbers()
        faults = zip(values.tolist(), sigmas.tolist(), self.monitor.probabilities.tolist(), strict=True)
        rounded = [rounded_number(number) for number in (*chain.from_iterable(faults), self.nis)]
        return dict(zip(self.columns, (self.time, *rounded, self.alarm_text), strict=True))

    # Recordings -----------------------------------------------------------------------------------------------------

    def run(
        self, recording: Any, *, progress: Progress | None = None, problems: list[InputError] | None = None
    ) -> WatchRecord:
        """Process all samples of a recording, and return the estimates of each.

        The estimates continue from those of earlier samples.

        Parameters
        ----------
        recording : str, Path, Recording or DataFrame
            Path of a table with the columns of the twin file. The names of a `Recording` or of a data frame can also be
            addresses, with values in SI or in the units that they state.
        progress : callable, optional
            Function that is called with the fraction of the samples that are processed.
        problems : list of InputError, optional
            List to which messages on single values and samples are added. Such values are missing.

        Returns
        -------
        WatchRecord
            One row for each sample that was used. If the user interrupts the evaluation, `is_complete` is False, and
            the record contains the rows until then.

        Raises
        ------
        InputErrors
            If the watch has no baseline, or the recording cannot be read, lacks a column or has another unit.
        """
        _ = self.running_filter
        messages: list[InputError] = [] if problems is None else problems
        rows = read_rows(recording, self.reader, messages)
        writer = _RecordWriter(self, rows)
        is_complete = True
        try:
            for k, (time, values) in enumerate(zip(rows.time.tolist(), rows.values.tolist(), strict=True)):
                if self.process(Sample(time, values), messages):
                    writer.add(time)
                if progress is not None and not k % PROGRESS_ROWS:
                    progress(k / rows.time.size)
        except KeyboardInterrupt:
            is_complete = False
        return writer.record(is_complete=is_complete)

    def commission(self, recording: Any, *, progress: Progress | None = None) -> Baseline:
        """Compute the baseline from a recording of the healthy plant, and start all estimates from it.

        Parameters
        ----------
        recording : str, Path, Recording or DataFrame
            Recording, as for `run`.
        progress : callable, optional
            Function that is called with the fraction of the work that is done.

        Returns
        -------
        Baseline
            Healthy values of faults and nuisances, and the lack of fit of the model. `Baseline.save` writes it.

        Raises
        ------
        InputErrors
            If the recording cannot be read, has invalid values or times, is too short, or does not determine any fault.
        """
        problems: list[InputError] = []
        rows = read_rows(recording, self.reader, problems)
        raise_errors(problems)
        name = (
            Path(recording).name
            if isinstance(recording, str | Path)
            else getattr(recording, "title", "") or "recording"
        )
        baseline = commission(self.plan, self._samples(rows, name), recording=name, progress=progress)
        self._set_baseline(baseline)
        return baseline

    def _samples(self, rows: RecordedRows, name: str) -> Samples:
        """Return the samples of a recording, whose times must increase; inputs hold their last value."""
        n_channels = len(self.plan.channels)
        is_later = np.append(True, np.diff(rows.time) > 0.0)
        if not (np.isfinite(rows.time).all() and is_later.all()):
            k = int(np.argmin(is_later & np.isfinite(rows.time)))
            raise InputError("stream.clock_of_recording", name, time=float(rows.time[k]), last=float(rows.time[k - 1]))
        return Samples(rows.time, rows.values[:, :n_channels], held_values(rows.values[:, n_channels:]))

    def isolable(self, recording: Any = None, *, longest: float = math.inf) -> Isolability:
        """Predict which faults the sensors can distinguish, before any fault has occurred.

        Parameters
        ----------
        recording : str, Path, Recording or DataFrame, optional
            Recording with the inputs of the usual operation. Default: the signals of the circuit.
        longest : float, optional
            Duration of the part of the recording that is used, from its start [s] (default: all).

        Returns
        -------
        Isolability
            Standard deviations, angles and verdicts; `summary` returns them as text.

        Raises
        ------
        InputErrors
            If the recording cannot be read, or if the circuit has neither a recording nor a duration.
        """
        if recording is None:
            return isolable(self.plan)
        rows = read_rows(recording, self.reader, [])
        samples = self._samples(rows, "recording")
        n = int(np.searchsorted(samples.times, samples.times[0] + longest, side="right"))
        return isolable(self.plan, time=samples.times[:n], inputs=samples.inputs[:n])


class _RecordWriter:
    """Writer of the rows of a record, whose arrays have the length of the recording."""

    def __init__(self, watch: Watch, rows: RecordedRows) -> None:
        n, f, c = rows.time.size, len(watch.plan.faults), len(watch.plan.channels)
        self.watch, self.rows, self.count = watch, rows, 0
        self.time, self.nis = np.empty(n), np.empty(n)
        self.faults = np.empty((n, 3, f))
        self.channels = np.empty((n, 3, c))
        self.used = np.empty((n, c), dtype=np.int8)
        self.alarms: list[str] = []
        self.verdicts: list[tuple[float, Note]] = []
        self._verdict: WatchVerdict | None = None

    def add(self, time: float) -> None:
        """Add the present estimates as a row."""
        k, watch = self.count, self.watch
        filter, monitor = watch.running_filter, watch.monitor
        self.time[k], self.nis[k] = time, watch.nis
        self.faults[k, 0], self.faults[k, 1] = watch.fault_numbers()
        self.faults[k, 2] = monitor.probabilities
        self.channels[k] = watch.readings, filter.expected, filter.deviations
        self.used[k] = 0 if watch.is_late else filter.used
        self.alarms.append(watch.alarm_text)
        if watch.verdict is not self._verdict:
            self._verdict = watch.verdict
            self.verdicts.append((time, watch.verdict.note))
        self.count += 1

    def record(self, *, is_complete: bool) -> WatchRecord:
        """Return the record of the rows."""
        end = slice(0, self.count)
        values, sigmas, probabilities = self.faults[end].transpose(1, 0, 2)
        readings, expected, deviations = self.channels[end].transpose(1, 0, 2)
        is_used = self.used[end]
        return WatchRecord(
            self.watch.plan, self.time[end], values, sigmas, probabilities, self.nis[end],
            np.count_nonzero(is_used == 1, axis=1), tuple(self.alarms), readings, expected, deviations, is_used,
            tuple(self.verdicts), (*self.rows.notes, *self._notes(readings, is_used)), self.watch.title, is_complete,
        )  # fmt: skip

    def _notes(self, readings: FloatArray, is_used: NDArray[np.int8]) -> Iterator[Note]:
        """Yield notes on sensors that failed, or have many missing readings or outliers."""
        time, window = self.time[: len(readings)], self.watch.plan.window
        for k, channel in enumerate(self.watch.plan.channels):
            if not readings.size:
                break
            outliers = float(np.mean(is_used[:, k] == -1))
            is_present = np.isfinite(readings[:, k])
            missing = _missing_fraction(is_present)
            since = float(time[is_present][-1]) if is_present.any() else float(time[0])
            if time[-1] - since > window:
                yield Note("stream.failed", channel.address, since=since)
            elif missing > MANY_MISSING:
                yield Note("stream.missing", channel.address, fraction=missing)
            if outliers > MANY_OUTLIERS:
                yield Note("stream.outliers", channel.address, fraction=outliers)


def _missing_fraction(is_present: NDArray[np.bool_]) -> float:
    """Return the fraction of the readings of a sensor that are missing; a slow sensor has regular rows without one."""
    rows = np.flatnonzero(is_present)
    usual = float(np.quantile(np.diff(rows), USUAL, method="lower")) if rows.size > 1 else 1.0
    return max(1.0 - rows.size * usual / is_present.size, 0.0)


def watch(
    circuit: BaseCircuit | str | Path,
    *,
    measured: Mapping[str, Any] | None = None,
    faults: Mapping[str, Any] | None = None,
    nuisance: Mapping[str, Any] | None = None,
    baseline: Baseline | str | Path | None = None,
    time: str | Mapping[str, str] = "time",
    window: str | float = "60 s",
    alarm_delay: str | float = "2 s",
    hold: bool = True,
    title: str = "",
) -> Watch:
    """Return the condition monitoring of a running plant.

    Parameters
    ----------
    circuit : Circuit, str or Path
        Model of the healthy plant, or the path of a twin file, which contains all other arguments.
    measured : mapping
        Table of each measured output by address: `noise` (standard deviation of one reading), and optionally `column`
        (key in samples), `unit` and `offset` (standard deviation of the constant error). A table without `noise` is an
        input of the circuit that the samples drive.
    faults : mapping
        Table of each fault by name: `address` of the parameter, `alarm` (alarm size), and `direction`
        (`up`, `down` or `both`, the default).
    nuisance : mapping, optional
        Table of each parameter that can vary without being a fault, by address: `sigma` or `relative_sigma`, and
        optionally `drift` or `relative_drift` (standard deviation of the change in one hour).
    baseline : Baseline, str or Path, optional
        Healthy state of the plant, or its file. Default: that of the twin file, if it exists.
    time : str or mapping, optional
        Key of the time in samples, or a table with `column` and `unit`.
    window : str or float, optional
        Longest time for which readings are stored and compared with the faults [s].
    alarm_delay : str or float, optional
        Time for which a fault must be evident before its alarm [s].
    hold : bool, optional
        True if inputs hold their value until the next sample, False if they change linearly to it.
    title : str, optional
        Title of records and reports (default: that of the circuit).

    Returns
    -------
    Watch

    Raises
    ------
    InputErrors
        If any argument, the twin file or the baseline is invalid. The exception contains all errors.

    Examples
    --------
    >>> import poppet
    >>> tank = poppet.loads('''
    ... [parts.tank]
    ... kind = "chamber"
    ... volume = "10 l"
    ... initial_pressure = "5 bar g"
    ... [parts.leak]
    ... kind = "orifice"
    ... from = "tank"
    ... to = "ambient"
    ... sonic_conductance = "1e-10 m^3/(s Pa)"
    ... critical_ratio = 0.3
    ... ''')
    >>> watch = poppet.watch(
    ...     tank,
    ...     measured={"tank.pressure": {"column": "p", "unit": "bar g", "noise": "2 mbar"}},
    ...     faults={"leak": {"address": "leak.sonic_conductance", "alarm": "1e-10 m^3/(s Pa)", "direction": "up"}},
    ... )
    >>> sorted(watch.columns)
    ['alarm', 'leak [m^3/(s Pa)]', 'leak.probability', 'leak.sigma', 'nis', 'time [s]']
    """
    if isinstance(circuit, str | Path):
        twin = read_twin_file(circuit)
        if baseline is None and twin.baseline.exists():
            baseline = twin.baseline
        return watch_of_twin(twin, read_baseline(baseline, twin.plan) if isinstance(baseline, str | Path) else baseline)
    with ErrorCollector() as errors:
        clock = read_clock(errors, time)
        with errors.collecting():
            settings = {"window": window, "alarm_delay": alarm_delay, "hold": hold}
            plan = read_plan(circuit, measured or {}, faults or {}, nuisance, settings)
    if isinstance(baseline, str | Path):
        baseline = read_baseline(baseline, plan)
    return Watch(plan, baseline, clock=clock, title=title or circuit.title)


def watch_of_twin(twin: Twin, baseline: Baseline | None = None) -> Watch:
    """Return the watch of a twin file."""
    return Watch(twin.plan, baseline, clock=twin.clock, title=twin.title)

"""One recording and the circuit that is to explain it: numbers in, modelled channels out, fast.

A run of the model is a compiled kernel on plain arrays. Derivatives with respect to the numbers come from runs that
share the step sequence of the base run: they differ smoothly, so that forward differences are good to 1e-6.
"""

from __future__ import annotations

import copy
import dataclasses
from collections.abc import Mapping, Sequence
from concurrent.futures import ThreadPoolExecutor
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.options import Run
from poppet.core.errors import InputError, NameSuggestion, relocated
from poppet.engine.batch import usable_cores
from poppet.engine.call import RepeatedCall
from poppet.engine.lane_kernel import LockstepLanes
from poppet.engine.problem import Problem, RawRun
from poppet.engine.solve import solve
from poppet.identify.fit.fit_series import driving_signals, first_value, lagged
from poppet.identify.free_parameter import FreeParameter
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel, Measurement

DIFFERENCE = 1e-6
"""Relative step of the forward differences over a shared step sequence."""
SAMPLED_DIFFERENCE = 0.1
"""Relative step of the central differences of whole runs where a program samples: decisions at instants make
a run smooth in its numbers on the whole only. A search tries other widths; the statistics take this one."""
DELAY_STEP = 1e-3
"""Step of the central differences in a delay, as a fraction of the recording, for it moves the breakpoints."""
FINE = 1000
"""Least number of rows where a sensor's lag is modelled between sparse samples."""
SCRIPT_LENGTH = 50_000
FAILED = 1e6
"""Residual, in sigmas, of samples that a failed run did not reach."""


class Sensor(NamedTuple):
    """What stands between an output of the circuit and a channel."""

    places: slice | NDArray[np.int64]  # rows of the grid at which there are samples
    lag: float  # known time constant [s]
    free_lag: str  # names of the free numbers of the sensor; empty for none
    free_offset: str


class _Kept(NamedTuple):
    """The last run."""

    repeated: RepeatedCall | None  # what made it, where it is alone
    tables: FloatArray  # (n_runs, n_outputs, n_times), those with a number moved behind it where it went in lanes
    steps: FloatArray  # by which these were moved


class Experiment:
    """A recording with the model that is to explain it; of the free numbers, those of other recordings are ignored."""

    def __init__(
        self,
        instance: Instance,
        measurement: Measurement,
        free: Sequence[FreeParameter],
        *,
        relative_tolerance: float = 1e-6,
    ) -> None:
        self.measurement = measurement
        own = [f for f in free if f.recording in ("", measurement.name)]
        self.free, instance = _with_dead_times(own, measurement, instance)
        outputs = [name for name, _ in instance.model.outputs]
        for channel in measurement.channels:
            if channel.address not in outputs:
                place = f"recordings.{measurement.name}.{channel.address}"
                near = NameSuggestion(channel.address, outputs)
                raise InputError("names.unknown", place, meaning="an output of this circuit", near=near)
        started = _with_start(measurement, instance)
        driven = driving_signals(measurement, {})
        self.instance = started.with_signals({**instance.signals, **driven}) if driven else started
        rows = tuple(outputs.index(channel.address) for channel in measurement.channels)
        self.grid = _grid(measurement, any(f.role == "lag" for f in self.free))
        self.run = Run(duration=float(self.grid[-1]), relative_tolerance=relative_tolerance)
        # Only the measured channels are computed.
        self._kernel = instance.kernel.observing(rows)
        self.base = self._problem_of(self.instance)
        self.slots = _slots(self.instance, [f for f in self.free if f.role in ("number", "start")])
        self._sensors = [_sensor(channel, self.grid, self.free) for channel in measurement.channels]
        # What only numbers of p and inputs held at them change is run in the same arrays again and again.
        self._rebuilds = None in self.slots.values() or any(
            f.role in ("delay", "dead_time", "input_lag") for f in self.free
        )
        self._led = None if self._rebuilds or not LockstepLanes.takes(self.base) else self._in_lanes()
        self._repeated = None if self._rebuilds or self._led else RepeatedCall(self.base, np.empty(SCRIPT_LENGTH))
        self.samples = self.instance.model.n_timers > 0
        self._last: tuple[tuple[float, ...], _Kept] | None = None

    def with_samples(self, samples: Sequence[FloatArray], free: Sequence[FreeParameter]) -> Experiment:
        """The same with other values at the times of each channel, and free numbers that begin elsewhere."""
        channels = zip(self.measurement.channels, samples, strict=True)
        told = tuple(dataclasses.replace(channel, values=values) for channel, values in channels)
        measurement = dataclasses.replace(self.measurement, channels=told)
        if self._led is None or "first" in measurement.start.values():
            return Experiment(self.instance, measurement, free, relative_tolerance=self.run.tolerance)
        # What runs does not depend on the samples, and no later run writes over the last one.
        own, begun = copy.copy(self), {f.name: f for f in free}
        own.measurement, own.free = measurement, tuple(begun[f.name] for f in self.free)
        return own

    @property
    def name(self) -> str:
        """Name of the recording."""
        return str(self.measurement.name)

    @property
    def brings_slopes(self) -> bool:
        """Whether a run comes with its slopes, which then cost little more."""
        return self._led is not None

    @property
    def sizes(self) -> list[int]:
        """Number of samples of each channel."""
        return [channel.time.size for channel in self.measurement.channels]

    def problem(self, values: Mapping[str, float]) -> Problem:
        """Arrays of a run with other numbers."""
        base = self._rebuilt(values) if self._rebuilds else self.base
        p, coefficients = base.p.copy(), base.coefficients.copy()
        self._write(values, p, coefficients)
        return dataclasses.replace(base, p=p, x0=base.kernel.start(p), coefficients=coefficients)

    def _rebuilt(self, values: Mapping[str, float]) -> Problem:
        """Arrays of a run where the inputs, or numbers that others follow from, are not those of the recording."""
        delays = {f.address: values[f.name] for f in self.free if f.role == "delay"}
        delays |= {f.address: -values[f.name] for f in self.free if f.role == "dead_time"}
        lags = {f.address: values[f.name] for f in self.free if f.role == "input_lag"}
        slow = {f.address: values[f.name] for f in self.free if f.name in self.slots and self.slots[f.name] is None}
        instance = self.instance.with_values(slow) if slow else self.instance
        return self._problem_of(
            instance.with_signals({**instance.signals, **driving_signals(self.measurement, delays, lags)})
        )

    def _problem_of(self, instance: Instance) -> Problem:
        return dataclasses.replace(instance.problem(self.run), grid=self.grid, kernel=self._kernel)

    def _write(self, values: Mapping[str, float], p: FloatArray, coefficients: FloatArray) -> None:
        """Numbers in their slots."""
        for name, slots in self.slots.items():
            if slots is None:
                continue
            place, held = slots
            p[place] = values[name]
            if held:
                coefficients[:, held, 0] = values[name]

    def _in_lanes(self) -> LockstepLanes:
        """The run at some numbers with those that have one of them moved."""
        slots = [each for each in self.slots.values() if each is not None]
        held = tuple((k, place) for place, inputs in slots for k in inputs)
        return LockstepLanes(self.base, len(slots) + 1, np.array([place for place, _ in slots], dtype=np.int64), held)

    def _prepared(self, values: Mapping[str, float]) -> RepeatedCall:
        """What runs at some numbers."""
        if self._repeated is None:
            return RepeatedCall(self.problem(values), np.empty(SCRIPT_LENGTH))
        self._write(values, self._repeated.p, self._repeated.coefficients)
        return self._repeated

    def everything(self, values: Mapping[str, float]) -> tuple[RawRun, list[str]]:
        """A run with all outputs of the circuit, and their names."""
        kernel = self.instance.kernel
        run = solve(dataclasses.replace(self.problem(values), kernel=kernel))
        return run, [name for name, _ in kernel.model.outputs]

    def outputs(self, values: Mapping[str, float]) -> list[FloatArray]:
        """Modelled channels at the measured times, lags included."""
        return self._channels(self._kept(values).tables[0], values)

    def _kept(self, values: Mapping[str, float]) -> _Kept:
        """The run at some numbers and its table, in lanes with those of the runs that have a number moved.

        The last one is kept, for slopes follow at the same place.

        Where it stalls, that place is a bad one, and not worth a slower method.
        """
        key = tuple([values[f.name] for f in self.free])
        if self._last is None or self._last[0] != key:
            # Whatever ends this run early, the arrays of the last one are written over.
            self._last = None
            if self._led is None:
                repeated = self._prepared(values)
                self._last = key, _Kept(repeated, repeated.run()[np.newaxis], np.zeros(0))
            else:
                self._led.values[:] = [values[name] for name in self.slots]
                moved = np.arange(len(self.slots))
                steps = np.array([_step(f, values) for f in self.free if f.name in self.slots])
                self._led.values[moved + 1, moved] += steps
                self._last = key, _Kept(None, self._led.run(), steps)
        return self._last[1]

    def _channels(self, table: FloatArray, values: Mapping[str, float]) -> list[FloatArray]:
        result = []
        for series, sensor in zip(table, self._sensors, strict=True):
            lag = values[sensor.free_lag] if sensor.free_lag else sensor.lag
            shown = lagged(self.grid, series, lag)
            result.append(shown[sensor.places] + (values[sensor.free_offset] if sensor.free_offset else 0.0))
        return result

    def outputs_and_slopes(
        self, values: Mapping[str, float], width: float = SAMPLED_DIFFERENCE
    ) -> tuple[list[FloatArray], list[FloatArray]]:
        """Modelled channels and their derivatives, as `slopes` gives them."""
        return self.outputs(values), self.slopes(values, width)

    def slopes(self, values: Mapping[str, float], width: float = SAMPLED_DIFFERENCE) -> list[FloatArray]:
        """Derivatives of the modelled channels, (n_samples, n_free) each, with respect to the free numbers.

        `width` is that of the differences where a program samples, relative to the numbers.
        """
        repeated, tables, steps = self._kept(values)
        # By columns: each is written whole.
        slopes = [np.empty((size, len(self.free)), order="F") for size in self.sizes]
        others = [(k, f) for k, f in enumerate(self.free) if len(tables) == 1 or f.name not in self.slots]
        if len(tables) > 1:
            self._write_slopes(values, tables, steps, slopes)
        wide = self._wide_slopes([f for _, f in others], values, width)
        base = self._channels(tables[0], values) if others else []
        for k, f in others:
            columns = wide.get(f.name) or self._slope(f, values, base, repeated, tables[0])
            for slope, column in zip(slopes, columns, strict=True):
                slope[:, k] = column
        return slopes

    def _write_slopes(
        self, values: Mapping[str, float], tables: FloatArray, steps: FloatArray, slopes: list[FloatArray]
    ) -> None:
        """Differences of the runs in lanes from the first one."""
        places = [k for k, f in enumerate(self.free) if f.name in self.slots]
        for series, sensor, slope in zip(tables.swapaxes(0, 1), self._sensors, slopes, strict=True):
            lag = values[sensor.free_lag] if sensor.free_lag else sensor.lag
            shown = lagged(self.grid, series, lag)
            shown = shown[:, sensor.places]
            found = np.subtract(shown[1:], shown[0], out=slope.T if len(places) == len(self.free) else None)
            found /= steps[:, np.newaxis]
            if len(places) < len(self.free):
                slope.T[places] = found

    def _slope(
        self,
        f: FreeParameter,
        values: Mapping[str, float],
        base: list[FloatArray],
        repeated: RepeatedCall | None,
        table: FloatArray,
    ) -> list[FloatArray]:
        step = _step(f, values)
        moved = {**values, f.name: values[f.name] + step}
        if f.role not in ("lag", "offset"):
            table = self._moved(f, moved, repeated)
        return [(a - b) / step for a, b in zip(self._channels(table, moved), base, strict=True)]

    def _ends(self, f: FreeParameter, values: Mapping[str, float], width: float) -> tuple[float, float] | None:
        """Values between which whole runs are compared, where runs over the same steps would not tell a slope.

        A number stays within its bounds, a record may be early as well as late.
        """
        value = values[f.name]
        if f.role in ("delay", "dead_time", "input_lag"):
            step = DELAY_STEP * float(self.grid[-1])
            return value - step, value + step
        if f.role in ("number", "start") and self.samples:
            step = width * max(abs(value), 0.1 * f.scale)
            return max(value - step, f.low), min(value + step, f.high)
        return None

    def _wide_slopes(
        self, free: Sequence[FreeParameter], values: Mapping[str, float], width: float
    ) -> dict[str, list[FloatArray]]:
        """Differences of whole runs for the numbers that need them, all runs on threads."""
        ends = {f.name: both for f in free if (both := self._ends(f, values, width))}
        if not ends:
            return {}
        moved = [{**values, name: value} for name, both in ends.items() for value in both]
        # In arrays of their own: nothing is written over where an interruption leaves a thread behind.
        runs = [RepeatedCall(self.problem(each), np.empty(0)) for each in moved]
        with ThreadPoolExecutor(min(usable_cores(), len(runs))) as threads:
            channels = [self._channels(*each) for each in zip(threads.map(RepeatedCall.run, runs), moved, strict=True)]
        return {
            name: [(b - a) / (high - low) for a, b in zip(*channels[2 * k : 2 * k + 2], strict=True)]
            for k, (name, (low, high)) in enumerate(ends.items())
        }

    def _moved(self, f: FreeParameter, values: Mapping[str, float], repeated: RepeatedCall | None) -> FloatArray:
        """The run with one number moved, over the steps of the base run where there are any."""
        assert repeated is not None
        if not repeated.is_scripted:
            return RepeatedCall(self.problem(values), repeated.script).run()
        if self.slots[f.name] is None:
            return RepeatedCall(self.problem(values), repeated.script).replay()
        self._write(values, repeated.p, repeated.coefficients)
        return repeated.replay()


def _step(f: FreeParameter, values: Mapping[str, float]) -> float:
    """Step of the forward difference in a number."""
    step = DIFFERENCE * max(abs(values[f.name]), 1e-3 * f.scale)
    return -step if values[f.name] + step > f.high else step


class FittedChannel(NamedTuple):
    """A channel among all that are fitted; `rows` are its samples among all."""

    name: str
    channel: Channel
    rows: slice


def channels_of(experiments: Sequence[Experiment]) -> list[FittedChannel]:
    """All channels in the order of experiments, as residuals are joined."""
    found, row = [], 0
    for e in experiments:
        for channel in e.measurement.channels:
            found.append(FittedChannel(f"{e.name}.{channel.address}", channel, slice(row, row + channel.time.size)))
            row += channel.time.size
    return found


def _with_dead_times(
    free: Sequence[FreeParameter], measurement: Measurement, instance: Instance
) -> tuple[tuple[FreeParameter, ...], Instance]:
    """Free numbers that delay a recorded input move its record instead, which may reach back before the run."""
    recorded = {item.address for item in measurement.inputs}
    delaying = {item.delay: item.name for item in instance.model.inputs if item.delay and item.name in recorded}
    moving = {f.address for f in free if f.role == "number"} & set(delaying)
    told = tuple(
        dataclasses.replace(f, role="dead_time", address=delaying[f.address]) if f.address in moving else f
        for f in free
    )
    return told, instance.with_values(dict.fromkeys(moving, 0.0)) if moving else instance


def _with_start(measurement: Measurement, instance: Instance) -> Instance:
    """Return a model with the start values of a recording."""
    values = start_values(measurement, instance)
    try:
        return instance.with_values(values) if values else instance
    except InputError as error:
        raise relocated(error, f"recordings.{measurement.name}.start.{{}}".format) from None


def start_values(measurement: Measurement, instance: Instance) -> dict[str, Any]:
    """Return the start values of a recording by address: given values, or first values of channels.

    A free start value begins at the first value of its channel. It is omitted if no channel measures it.

    Raises
    ------
    InputError
        If a start value is `first` and no channel measures it.
    """
    values: dict[str, Any] = {}
    for address, start in measurement.start.items():
        if start not in ("first", "free"):
            values[address] = start
            continue
        output, channel = starting_channel(address, instance, measurement)
        if channel is not None:
            values[address] = first_value(channel)
        elif start == "first":
            raise InputError("fit.first", f"recordings.{measurement.name}.start.{address}", channel=output)
    return values


def starting_channel(address: str, instance: Instance, measurement: Measurement) -> tuple[str, Channel | None]:
    """The output that begins at a number of the circuit, and its channel where it was recorded."""
    output = next((name for name, number in instance.initial.items() if number == address), address)
    return output, next((c for c in measurement.channels if c.address == output), None)


def _grid(measurement: Measurement, has_lag: bool) -> FloatArray:
    times = [np.zeros(1), *(channel.time for channel in measurement.channels)]
    grid = np.unique(np.concatenate(times))
    if has_lag or any(channel.lag for channel in measurement.channels):
        grid = np.unique(np.concatenate([grid, np.linspace(0.0, grid[-1], FINE)]))
    return grid


def _sensor(channel: Channel, grid: FloatArray, free: Sequence[FreeParameter]) -> Sensor:
    places = slice(None) if np.array_equal(grid, channel.time) else np.searchsorted(grid, channel.time)
    names = {f.role: f.name for f in free if f.address == channel.address and f.role in ("lag", "offset")}
    return Sensor(places, channel.lag or 0.0, names.get("lag", ""), names.get("offset", ""))


def _slots(instance: Instance, free: Sequence[FreeParameter]) -> dict[str, tuple[int, list[int]] | None]:
    """Place of each free number in p and of the inputs that it is the default of; None where others follow from it."""
    inputs, before = instance.model.inputs, instance.parameters
    tied = instance.tied({f.address: _probe(f, before[f.address]) for f in free if f.address in before})
    # A delay moves breakpoints: the segments of its input are made anew.
    tied |= {item.delay for item in inputs}
    slots: dict[str, tuple[int, list[int]] | None] = {}
    for f in free:
        held = [k for k, i in enumerate(inputs) if i.default == f.address and i.name not in instance.signals]
        slots[f.name] = (instance.place(f.address), held) if f.address in before and f.address not in tied else None
    return slots


def _probe(f: FreeParameter, value: float) -> float:
    """A value of a free number close to the one that it has."""
    probe = value * (1.0 + 1e-6) if value else 1e-6 * f.scale
    return probe if f.low <= probe <= f.high else value * (1.0 - 1e-6)

"""Model of one recording, which computes modelled channels and their derivatives from parameter values.

A run is one simulation of the recording by a compiled kernel on plain arrays. Derivatives by the parameters are
differences between runs that use the step sequence of the base run. The outputs are then smooth functions of the
parameters, and forward differences are accurate to 1e-6.
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
from poppet.identify.fit.fit_series import apply_lag, driving_signals, first_value
from poppet.identify.free_parameter import FreeParameter
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel, Measurement

DIFFERENCE = 1e-6
"""Relative step of the forward differences over a shared step sequence."""
SAMPLED_DIFFERENCE = 0.1
"""Relative step of the central differences of whole runs for sampled circuits, whose outputs are not smooth at small
scale. A search also uses other widths; the statistics use this one."""
DELAY_STEP = 1e-3
"""Step of the central differences in a delay, as a fraction of the recording; a delay moves the breakpoints."""
FINE = 1000
"""Minimum number of rows for the model of a sensor lag between sparse samples."""
SCRIPT_LENGTH = 50_000
FAILED = 1e6
"""Residual of samples that a failed run did not reach, in sigmas."""


class ChannelSensor(NamedTuple):
    """Model of a sensor: lag and offset between a simulated output and its readings."""

    places: slice | NDArray[np.int64]  # indices of the times of the samples in the grid
    lag: float  # known time constant [s]
    free_lag: str  # names of the free parameters of the sensor; empty for none
    free_offset: str


class _LastRun(NamedTuple):
    """Results of the most recent simulation, stored because the same values are often requested again."""

    repeated: RepeatedCall | None  # call of the compiled kernel; None if several runs are computed together
    tables: FloatArray  # (n_runs, n_outputs, n_times); the first run has the given values, others one shifted parameter
    steps: FloatArray  # shift of the parameter in each further run


class Experiment:
    """Recording together with the model that simulates it.

    The constructor ignores free parameters that apply to other recordings only.
    """

    def __init__(
        self,
        instance: Instance,
        measurement: Measurement,
        free: Sequence[FreeParameter],
        *,
        relative_tolerance: float = 1e-6,
    ) -> None:
        self.measurement = measurement
        parameters = [f for f in free if f.recording in ("", measurement.name)]
        # Replace free dead times of recorded inputs by shifts of the recordings, which can contain times before the
        # start of the run.
        recorded = {item.address for item in measurement.inputs}
        inputs = {i.delay: i.name for i in instance.model.inputs if i.delay and i.name in recorded}
        shifting = {f.address for f in parameters if f.role == "number"} & set(inputs)
        self.free = tuple(
            dataclasses.replace(f, role="dead_time", address=inputs[f.address]) if f.address in shifting else f
            for f in parameters
        )
        if shifting:
            instance = instance.with_values(dict.fromkeys(shifting, 0.0))
        outputs = [name for name, _ in instance.model.outputs]
        for channel in measurement.channels:
            if channel.address not in outputs:
                location = f"recordings.{measurement.name}.{channel.address}"
                near = NameSuggestion(channel.address, outputs)
                raise InputError("names.unknown", location, meaning="an output of this circuit", suggestion=near)
        starts = start_values(measurement, instance)
        try:
            started = instance.with_values(starts) if starts else instance
        except InputError as error:
            raise relocated(error, f"recordings.{measurement.name}.start.{{}}".format) from None
        driven = driving_signals(measurement, {})
        self.instance = started.with_signals({**instance.signals, **driven}) if driven else started
        rows = tuple(outputs.index(channel.address) for channel in measurement.channels)
        self.grid = np.unique(np.concatenate([np.zeros(1), *(channel.time for channel in measurement.channels)]))
        if any(f.role == "lag" for f in self.free) or any(channel.lag for channel in measurement.channels):
            self.grid = np.unique(np.concatenate([self.grid, np.linspace(0.0, self.grid[-1], FINE)]))
        self.run = Run(duration=float(self.grid[-1]), relative_tolerance=relative_tolerance)
        # Only the measured channels are computed.
        self._kernel = instance.kernel.observing(rows)
        self.base = self._problem_of(self.instance)
        self.slots = _locations_in_arrays(self.instance, [f for f in self.free if f.role in ("number", "start")])
        self._sensors: list[ChannelSensor] = []
        for channel in measurement.channels:
            samples = slice(None) if np.array_equal(self.grid, channel.time) else self.grid.searchsorted(channel.time)
            names = {f.role: f.name for f in self.free if f.address == channel.address and f.role in ("lag", "offset")}
            sensor = ChannelSensor(samples, channel.lag or 0.0, names.get("lag", ""), names.get("offset", ""))
            self._sensors.append(sensor)
        # If parameters change only p and constant inputs, all runs use the same arrays.
        self._rebuilds = None in self.slots.values() or any(
            f.role in ("delay", "dead_time", "input_lag") for f in self.free
        )
        self._lanes: LockstepLanes | None = None
        self._repeated: RepeatedCall | None = None
        if not self._rebuilds and LockstepLanes.can_run(self.base):
            # The base values and one shifted value per parameter run together.
            slots = [slot for slot in self.slots.values() if slot is not None]
            driven_inputs = tuple((k, index) for index, inputs in slots for k in inputs)
            indices = np.array([index for index, _ in slots], dtype=np.int64)
            self._lanes = LockstepLanes(self.base, len(slots) + 1, indices, driven_inputs)
        elif not self._rebuilds:
            self._repeated = RepeatedCall(self.base, np.empty(SCRIPT_LENGTH))
        self.samples = self.instance.model.n_timers > 0
        self._last: tuple[tuple[float, ...], _LastRun] | None = None

    def with_samples(self, samples: Sequence[FloatArray], free: Sequence[FreeParameter]) -> Experiment:
        """Return a copy of the recording and its model with other recorded values and other start values.

        `samples` contains the values of each channel. `free` contains the free parameters with the new start values.
        """
        channels = zip(self.measurement.channels, samples, strict=True)
        resampled = tuple(dataclasses.replace(channel, values=values) for channel, values in channels)
        measurement = dataclasses.replace(self.measurement, channels=resampled)
        if self._lanes is None or "first" in measurement.start.values():
            return Experiment(self.instance, measurement, free, relative_tolerance=self.run.tolerance)
        # The run does not depend on the samples, and a later run does not overwrite the last one.
        experiment, parameters = copy.copy(self), {f.name: f for f in free}
        experiment.measurement, experiment.free = measurement, tuple(parameters[f.name] for f in self.free)
        return experiment

    @property
    def name(self) -> str:
        """Name of the recording."""
        return str(self.measurement.name)

    @property
    def sizes(self) -> list[int]:
        """Number of samples of each channel of the recording."""
        return [channel.time.size for channel in self.measurement.channels]

    def problem(self, values: Mapping[str, float]) -> Problem:
        """Return the definition of a simulation with given values of the free parameters.

        `values` maps the names of the free parameters to their values.
        """
        base = self.base
        if self._rebuilds:
            # Inputs or dependent parameters change: compute the arrays again from the circuit.
            delays = {f.address: values[f.name] for f in self.free if f.role == "delay"}
            delays |= {f.address: -values[f.name] for f in self.free if f.role == "dead_time"}
            lags = {f.address: values[f.name] for f in self.free if f.role == "input_lag"}
            slow = {f.address: values[f.name] for f in self.free if f.name in self.slots and self.slots[f.name] is None}
            instance = self.instance.with_values(slow) if slow else self.instance
            driven = driving_signals(self.measurement, delays, lags)
            base = self._problem_of(instance.with_signals({**instance.signals, **driven}))
        p, coefficients = base.p.copy(), base.coefficients.copy()
        self._write(values, p, coefficients)
        return dataclasses.replace(base, p=p, x0=base.kernel.start(p), coefficients=coefficients)

    def _problem_of(self, instance: Instance) -> Problem:
        return dataclasses.replace(instance.problem(self.run), grid=self.grid, kernel=self._kernel)

    def _write(self, values: Mapping[str, float], p: FloatArray, coefficients: FloatArray) -> None:
        """Write values of the free parameters into the arrays of a simulation.

        `p` contains the parameters of the model, and `coefficients` its input signals. `values` maps names to values.
        """
        for name, slots in self.slots.items():
            if slots is None:
                continue
            index, driven = slots
            p[index] = values[name]
            if driven:
                coefficients[:, driven, 0] = values[name]

    def all_outputs(self, values: Mapping[str, float]) -> tuple[RawRun, list[str]]:
        """Simulate the circuit, and return the run and the names of all outputs.

        `values` maps the names of the free parameters to their values.
        """
        kernel = self.instance.kernel
        run = solve(dataclasses.replace(self.problem(values), kernel=kernel))
        return run, [name for name, _ in kernel.model.outputs]

    def outputs(self, values: Mapping[str, float]) -> list[FloatArray]:
        """Return the simulated readings of each channel at the times of its samples.

        They include lags and offsets of the sensors. `values` maps the names of the free parameters to their values.
        """
        return self._channels(self._run_at(values).tables[0], values)

    def _run_at(self, values: Mapping[str, float]) -> _LastRun:
        """Return the simulated outputs for given values of the free parameters.

        If several runs can be computed together, the result also contains one run for each parameter, in which its
        value is shifted. The result is stored, because the derivatives at the same values are usually requested next. A
        run that stalls is not repeated with a slower solver.
        """
        key = tuple([values[f.name] for f in self.free])
        if self._last is None or self._last[0] != key:
            # If this run ends early, the arrays of the last run are already overwritten.
            self._last = None
            if self._lanes is None:
                repeated = self._repeated
                if repeated is None:
                    repeated = RepeatedCall(self.problem(values), np.empty(SCRIPT_LENGTH))
                else:
                    self._write(values, repeated.p, repeated.coefficients)
                self._last = key, _LastRun(repeated, repeated.run()[np.newaxis], np.zeros(0))
            else:
                self._lanes.values[:] = [values[name] for name in self.slots]
                lanes = np.arange(len(self.slots))
                steps = np.array([_difference_step(f, values) for f in self.free if f.name in self.slots])
                self._lanes.values[lanes + 1, lanes] += steps
                self._last = key, _LastRun(None, self._lanes.run(), steps)
        return self._last[1]

    def _channels(self, table: FloatArray, values: Mapping[str, float]) -> list[FloatArray]:
        return [
            self._sense(series, sensor, values) + (values[sensor.free_offset] if sensor.free_offset else 0.0)
            for series, sensor in zip(table, self._sensors, strict=True)
        ]

    def _sense(self, series: FloatArray, sensor: ChannelSensor, values: Mapping[str, float]) -> FloatArray:
        """Convert output series, (..., n_times), to readings of a sensor at its sample times.

        The readings include the lag, but not the offset.
        """
        lag = values[sensor.free_lag] if sensor.free_lag else sensor.lag
        return apply_lag(self.grid, series, lag)[..., sensor.places]

    def slopes(self, values: Mapping[str, float], width: float = SAMPLED_DIFFERENCE) -> list[FloatArray]:
        """Return the derivatives of each simulated channel by the free parameters, (n_samples, n_free) each.

        `values` maps the names of the free parameters to their values. `width` is the relative step of the finite
        differences, which are used only for circuits with sampled controllers.
        """
        repeated, tables, steps = self._run_at(values)
        # Column order, because each column is written as a whole.
        slopes = [np.empty((size, len(self.free)), order="F") for size in self.sizes]
        remaining = [(k, f) for k, f in enumerate(self.free) if len(tables) == 1 or f.name not in self.slots]
        if len(tables) > 1:
            # Runs that were computed together contain the differences.
            columns = [k for k, f in enumerate(self.free) if f.name in self.slots]
            for series, sensor, slope in zip(tables.swapaxes(0, 1), self._sensors, slopes, strict=True):
                sensed = self._sense(series, sensor, values)
                differences = np.subtract(sensed[1:], sensed[0], out=None if remaining else slope.T)
                differences /= steps[:, np.newaxis]
                if remaining:
                    slope.T[columns] = differences
        whole_run_slopes = self._wide_slopes([f for _, f in remaining], values, width)
        base = self._channels(tables[0], values) if remaining else []
        for k, f in remaining:
            quotients = whole_run_slopes.get(f.name)
            if quotients is None:
                step, table = _difference_step(f, values), tables[0]
                shifted_values = {**values, f.name: values[f.name] + step}
                if f.role not in ("lag", "offset"):
                    # Run with one shifted parameter over the steps of the base run.
                    assert repeated is not None
                    if not repeated.is_scripted:
                        table = RepeatedCall(self.problem(shifted_values), repeated.script).run()
                    elif self.slots[f.name] is None:
                        table = RepeatedCall(self.problem(shifted_values), repeated.script).replay()
                    else:
                        self._write(shifted_values, repeated.p, repeated.coefficients)
                        table = repeated.replay()
                shifted = self._channels(table, shifted_values)
                quotients = [(a - b) / step for a, b in zip(shifted, base, strict=True)]
            for slope, column in zip(slopes, quotients, strict=True):
                slope[:, k] = column
        return slopes

    def _wide_slopes(
        self, free: Sequence[FreeParameter], values: Mapping[str, float], width: float
    ) -> dict[str, list[FloatArray]]:
        """Return derivatives by the parameters `free`, from differences between whole runs.

        The differences are central, with steps of relative size `width`. Values are limited to their bounds, except
        delays, because an input can be recorded early or late.
        """
        pairs: dict[str, tuple[float, float]] = {}
        for f in free:
            value = values[f.name]
            if f.role in ("delay", "dead_time", "input_lag"):
                step = DELAY_STEP * float(self.grid[-1])
                pairs[f.name] = value - step, value + step
            elif f.role in ("number", "start") and self.samples:
                step = width * max(abs(value), 0.1 * f.scale)
                pairs[f.name] = max(value - step, f.low), min(value + step, f.high)
        if not pairs:
            return {}
        trials = [{**values, name: value} for name, pair in pairs.items() for value in pair]
        # Separate arrays: after an interruption, a remaining thread cannot overwrite the results.
        runs = [RepeatedCall(self.problem(trial), np.empty(0)) for trial in trials]
        threads = ThreadPoolExecutor(min(usable_cores(), len(runs)))
        try:
            channels = [
                self._channels(*trial) for trial in zip(threads.map(RepeatedCall.run, runs), trials, strict=True)
            ]
        finally:
            # `map` cancels no runs if the interruption comes before its first result is requested.
            threads.shutdown(cancel_futures=True)
        return {
            name: [(b - a) / (high - low) for a, b in zip(*channels[2 * k : 2 * k + 2], strict=True)]
            for k, (name, (low, high)) in enumerate(pairs.items())
        }


def _difference_step(f: FreeParameter, values: Mapping[str, float]) -> float:
    """Return the step of the parameter `f` for a finite difference.

    `values` maps names of parameters to their values. The step is negative if a positive step would exceed the upper
    bound.
    """
    step = DIFFERENCE * max(abs(values[f.name]), 1e-3 * f.scale)
    return -step if values[f.name] + step > f.high else step


class FittedChannel(NamedTuple):
    """Recorded channel that a fit compares with the model.

    `rows` is the slice of its samples in the vector of all residuals.
    """

    name: str
    channel: Channel
    rows: slice


def channels_of(experiments: Sequence[Experiment]) -> list[FittedChannel]:
    """Return the channels of all recordings, with the location of their samples in the vector of residuals."""
    channels, row = [], 0
    for e in experiments:
        for channel in e.measurement.channels:
            channels.append(FittedChannel(f"{e.name}.{channel.address}", channel, slice(row, row + channel.time.size)))
            row += channel.time.size
    return channels


def start_values(measurement: Measurement, instance: Instance) -> dict[str, Any]:
    """Return the initial values that a recording states or measures, by address.

    For a free initial value, this is the value from which the search starts. An initial value that is free and not
    measured is omitted.

    Raises
    ------
    InputError
        If a start value is stated as `first`, the first sample of a channel, and no channel measures it.
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
    """Return the output that has the initial value at `address`, and the recorded channel of this output.

    The channel is None if the output was not measured.
    """
    output = next((name for name, number in instance.initial.items() if number == address), address)
    return output, next((c for c in measurement.channels if c.address == output), None)


def _locations_in_arrays(instance: Instance, free: Sequence[FreeParameter]) -> dict[str, tuple[int, list[int]] | None]:
    """Return the locations of each free parameter in the arrays of a simulation, by name.

    A location is the index in the parameter array p, and the indices of the inputs that have this parameter as their
    value. It is None for a parameter that is not in p, or on which other parameters depend.
    """
    inputs, values = instance.model.inputs, instance.parameters
    probes: dict[str, float] = {}
    for f in free:
        if f.address in values:
            # Differ slightly from the present value, within the bounds.
            value = values[f.address]
            probe = value * (1.0 + 1e-6) if value else 1e-6 * f.scale
            probes[f.address] = probe if f.low <= probe <= f.high else value * (1.0 - 1e-6)
    tied = instance.tied(probes)
    # A delay moves breakpoints: the segments of its input must be computed again.
    tied |= {item.delay for item in inputs}
    slots: dict[str, tuple[int, list[int]] | None] = {}
    for f in free:
        driven = [k for k, i in enumerate(inputs) if i.default == f.address and i.name not in instance.signals]
        slots[f.name] = (instance.place(f.address), driven) if f.address in values and f.address not in tied else None
    return slots

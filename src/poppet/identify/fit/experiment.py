"""One recording and the circuit that is to explain it: numbers in, modelled channels out, fast.

A run of the model is a compiled kernel on plain arrays. Derivatives with respect to the numbers come from runs that
share the step sequence of the base run: they differ smoothly, so that forward differences are good to 1e-6.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import Circuit
from poppet.circuit.options import Run
from poppet.engine.kernel import KERNELS, Kernel
from poppet.engine.problem import Problem, RawRun
from poppet.engine.repeated import Repeated
from poppet.engine.solve import solve
from poppet.ground.errors import InputError, relocated, suggestion
from poppet.identify.fit.series import driving_signals, first_value, lagged
from poppet.identify.free import Free
from poppet.series.measured import Channel

Array = NDArray[np.float64]

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
    """What stands between an output of the circuit and a channel.

    Parameters
    ----------
    places : slice or array of int
        Rows of the grid at which there are samples.
    lag : float
        Known time constant [s].
    free_lag, free_offset : str
        Names of the free numbers of the sensor; empty for none.
    """

    places: slice | NDArray[np.int64]
    lag: float
    free_lag: str
    free_offset: str


class Experiment:
    """A recording with its circuit.

    Parameters
    ----------
    circuit : Circuit
        The model, with its own numbers.
    measurement : Measurement
        Channels, inputs and start values of one recording.
    free : sequence of Free
        All free numbers of the fit; those of other recordings are ignored.
    relative_tolerance : float, optional
        Of the runs.

    Raises
    ------
    InputError
        If a channel is no output of the circuit, or an input no input of it.
    """

    def __init__(
        self, circuit: Circuit, measurement: Any, free: Sequence[Free], *, relative_tolerance: float = 1e-6
    ) -> None:
        self.measurement = measurement
        own = [f for f in free if f.recording in ("", measurement.name)]
        self.free, circuit = _with_dead_times(own, measurement, circuit)
        outputs = [name for name, _ in circuit.model.outputs]
        for channel in measurement.channels:
            if channel.address not in outputs:
                raise InputError(
                    f"recordings.{measurement.name}.{channel.address}", "is no output of this circuit.",
                    suggestion(channel.address, outputs), address=f"recordings.{measurement.name}.{channel.address}",
                )  # fmt: skip
        started = _started(measurement, circuit)
        self.circuit = dataclasses.replace(started, signals={**circuit.signals, **driving_signals(measurement, {})})
        rows = [outputs.index(channel.address) for channel in measurement.channels]
        self.grid = _grid(measurement, any(f.role == "lag" for f in self.free))
        self.run = Run(duration=float(self.grid[-1]), relative_tolerance=relative_tolerance)
        base = self.circuit.problem(self.run)
        self._kernel = _observing(self.circuit, tuple(rows))
        self.base = dataclasses.replace(base, grid=self.grid, kernel=self._kernel)
        self.slots = _slots(self.circuit, [f for f in self.free if f.role in ("number", "start")])
        self._sensors = [_sensor(channel, self.grid, self.free) for channel in measurement.channels]
        # What only numbers of p and inputs held at them change is run in the same arrays again and again.
        rebuilds = any(f.role in ("delay", "dead_time", "input_lag") for f in self.free) or None in self.slots.values()
        self._repeated = None if rebuilds else Repeated(self.base, np.empty(SCRIPT_LENGTH))
        self.samples = self.circuit.model.n_timers > 0
        self._aside: Repeated | None = None
        self._last: tuple[tuple[float, ...], Repeated, Array] | None = None

    def with_measurement(self, measurement: Any, free: Sequence[Free]) -> Experiment:
        """The same circuit for another measurement, or other free numbers."""
        return Experiment(self.circuit, measurement, free, relative_tolerance=self.run.tolerance)

    @property
    def name(self) -> str:
        """Name of the recording."""
        return str(self.measurement.name)

    @property
    def sizes(self) -> list[int]:
        """Number of samples of each channel."""
        return [channel.time.size for channel in self.measurement.channels]

    def problem(self, values: Mapping[str, float]) -> Problem:
        """Arrays of a run with other numbers."""
        base = self.base if self._repeated else self._rebuilt(values)
        p, coefficients = base.p.copy(), base.coefficients.copy()
        self._write(values, p, coefficients)
        return dataclasses.replace(base, p=p, x0=base.kernel.start(p), coefficients=coefficients)

    def _rebuilt(self, values: Mapping[str, float]) -> Problem:
        """Arrays of a run where the inputs, or numbers that others follow from, are not those of the recording."""
        delays = {f.address: values[f.name] for f in self.free if f.role == "delay"}
        delays |= {f.address: -values[f.name] for f in self.free if f.role == "dead_time"}
        lags = {f.address: values[f.name] for f in self.free if f.role == "input_lag"}
        slow = {f.address: values[f.name] for f in self.free if f.name in self.slots and self.slots[f.name] is None}
        circuit = self.circuit.with_values(slow) if slow else self.circuit
        signals = {**circuit.signals, **driving_signals(self.measurement, delays, lags)}
        circuit = dataclasses.replace(circuit, signals=signals)
        return dataclasses.replace(circuit.problem(self.run), grid=self.grid, kernel=self._kernel)

    def _write(self, values: Mapping[str, float], p: Array, coefficients: Array) -> None:
        """Numbers in their slots."""
        for name, slots in self.slots.items():
            if slots is None:
                continue
            place, held = slots
            p[place] = values[name]
            if held:
                coefficients[:, held, 0] = values[name]

    def _prepared(self, values: Mapping[str, float]) -> Repeated:
        """What runs at some numbers."""
        if self._repeated is None:
            return Repeated(self.problem(values), np.empty(SCRIPT_LENGTH))
        self._write(values, self._repeated.p, self._repeated.coefficients)
        return self._repeated

    def everything(self, values: Mapping[str, float]) -> tuple[RawRun, list[str]]:
        """A run with all outputs of the circuit, and their names."""
        kernel = self.circuit.kernel
        run = solve(dataclasses.replace(self.problem(values), kernel=kernel))
        return run, [name for name, _ in kernel.model.outputs]

    def outputs(self, values: Mapping[str, float]) -> list[Array]:
        """Modelled channels at the measured times, lags included."""
        return self._channels(self._kept(values)[1], values)

    def _kept(self, values: Mapping[str, float]) -> tuple[Repeated, Array]:
        """The run at some numbers and its table; the last one is kept, for slopes follow at the same place.

        Where it stalls, that place is a bad one, and not worth a slower method.
        """
        key = tuple(values[f.name] for f in self.free)
        if self._last is None or self._last[0] != key:
            # Whatever ends this run early, the arrays of the last one are written over.
            self._last = None
            repeated = self._prepared(values)
            self._last = key, repeated, repeated.run()
        return self._last[1], self._last[2]

    def _channels(self, table: Array, values: Mapping[str, float]) -> list[Array]:
        result = []
        for series, sensor in zip(table, self._sensors, strict=True):
            lag = values[sensor.free_lag] if sensor.free_lag else sensor.lag
            shown = series if lag <= 0.0 else lagged(self.grid, series, lag)
            result.append(shown[sensor.places] + (values[sensor.free_offset] if sensor.free_offset else 0.0))
        return result

    def outputs_and_slopes(
        self, values: Mapping[str, float], width: float = SAMPLED_DIFFERENCE
    ) -> tuple[list[Array], list[Array]]:
        """Modelled channels and their derivatives, (n_samples, n_free) each, with respect to the free numbers.

        `width` is that of the differences where a program samples, relative to the numbers.
        """
        repeated, table = self._kept(values)
        base = self._channels(table, values)
        # By columns: each is written whole.
        slopes = [np.empty((size, len(self.free)), order="F") for size in self.sizes]
        for k, f in enumerate(self.free):
            for slope, column in zip(slopes, self._slope(f, values, width, base, repeated, table), strict=True):
                slope[:, k] = column
        return base, slopes

    def _slope(
        self, f: Free, values: Mapping[str, float], width: float, base: list[Array], repeated: Repeated, table: Array
    ) -> list[Array]:
        if f.role in ("delay", "dead_time", "input_lag"):
            return self._wide_slope(f, values, DELAY_STEP * float(self.grid[-1]))
        if f.role in ("number", "start") and self.samples:
            return self._wide_slope(f, values, width * max(abs(values[f.name]), 0.1 * f.scale))
        step = DIFFERENCE * max(abs(values[f.name]), 1e-3 * f.scale)
        if values[f.name] + step > f.high:
            step = -step
        moved = {**values, f.name: values[f.name] + step}
        if f.role not in ("lag", "offset"):
            table = self._moved(f, moved, repeated)
        return [(a - b) / step for a, b in zip(self._channels(table, moved), base, strict=True)]

    def _wide_slope(self, f: Free, values: Mapping[str, float], step: float) -> list[Array]:
        """Central difference of whole runs; a number stays within its bounds, a record may be early as well as late."""
        low, high = values[f.name] - step, values[f.name] + step
        if f.role in ("number", "start"):
            low, high = max(low, f.low), min(high, f.high)
        up, down = (self._channels(self._whole(moved), moved) for moved in ({**values, f.name: v} for v in (high, low)))
        return [(a - b) / (high - low) for a, b in zip(up, down, strict=True)]

    def _whole(self, values: Mapping[str, float]) -> Array:
        """A run in arrays of its own, for those of the last run are still needed."""
        if self._repeated is None:
            return self._prepared(values).run()
        if self._aside is None:
            self._aside = Repeated(self.base, np.empty(0))
        self._write(values, self._aside.p, self._aside.coefficients)
        return self._aside.run()

    def _moved(self, f: Free, values: Mapping[str, float], repeated: Repeated) -> Array:
        """The run with one number moved, over the steps of the base run where there are any."""
        if not repeated.is_scripted:
            return Repeated(self.problem(values), repeated.script).run()
        if self.slots[f.name] is None:
            return Repeated(self.problem(values), repeated.script).replay()
        self._write(values, repeated.p, repeated.coefficients)
        return repeated.replay()


class Compared(NamedTuple):
    """A channel among all that are fitted; `rows` are its samples among all."""

    name: str
    channel: Channel
    rows: slice


def channels_of(experiments: Sequence[Experiment]) -> list[Compared]:
    """All channels in the order of experiments, as residuals are joined."""
    found, row = [], 0
    for e in experiments:
        for channel in e.measurement.channels:
            found.append(Compared(f"{e.name}.{channel.address}", channel, slice(row, row + channel.time.size)))
            row += channel.time.size
    return found


def _observing(circuit: Circuit, rows: tuple[int, ...]) -> Kernel:
    """A kernel that gives the measured channels only."""
    return KERNELS.get((circuit.structure, rows), lambda: circuit.kernel.observing(rows))


def _with_dead_times(free: Sequence[Free], measurement: Any, circuit: Circuit) -> tuple[tuple[Free, ...], Circuit]:
    """Free numbers that delay a recorded input move its record instead, which may reach back before the run."""
    recorded = {item.address for item in measurement.inputs}
    delaying = {item.delay: item.name for item in circuit.model.inputs if item.delay and item.name in recorded}
    moving = {f.address for f in free if f.role == "number"} & set(delaying)
    told = tuple(
        dataclasses.replace(f, role="dead_time", address=delaying[f.address]) if f.address in moving else f
        for f in free
    )
    return told, circuit.with_values(dict.fromkeys(moving, 0.0)) if moving else circuit


def _started(measurement: Any, circuit: Circuit) -> Circuit:
    values = _start_values(measurement, circuit)
    try:
        return circuit.with_values(values)
    except InputError as error:
        raise relocated(error, f"recordings.{measurement.name}.start.{{}}".format) from None


def _start_values(measurement: Any, circuit: Circuit) -> dict[str, Any]:
    """Start values of a recording: given ones, or `first`, the first sample of the channel they belong to."""
    values: dict[str, Any] = {}
    for address, given in measurement.start.items():
        if given not in ("first", "free"):
            values[address] = given
            continue
        owner, _, local = address.partition(".")
        output = next((k for k, v in getattr(circuit.parts.get(owner), "resume", {}).items() if v == local), local)
        channel = next((c for c in measurement.channels if c.address == f"{owner}.{output}"), None)
        if channel is None and given == "free":
            continue
        if channel is None:
            raise InputError(
                f'recordings.{measurement.name}.start.{address} = "first"', f"needs a channel {owner}.{output}.",
                "Give a value, or record that channel.", address=f"recordings.{measurement.name}.start",
            )  # fmt: skip
        values[address] = first_value(channel)
    return values


def _grid(measurement: Any, has_lag: bool) -> Array:
    times = [np.zeros(1), *(channel.time for channel in measurement.channels)]
    grid = np.unique(np.concatenate(times))
    if has_lag or any(channel.lag for channel in measurement.channels):
        grid = np.unique(np.concatenate([grid, np.linspace(0.0, grid[-1], FINE)]))
    return grid


def _sensor(channel: Any, grid: Array, free: Sequence[Free]) -> Sensor:
    places = slice(None) if np.array_equal(grid, channel.time) else np.searchsorted(grid, channel.time)
    names = {f.role: f.name for f in free if f.address == channel.address and f.role in ("lag", "offset")}
    return Sensor(places, channel.lag or 0.0, names.get("lag", ""), names.get("offset", ""))


def _slots(circuit: Circuit, free: Sequence[Free]) -> dict[str, tuple[int, list[int]] | None]:
    """Place of each free number in p and of the inputs that it is the default of; None where others follow from it."""
    model, before = circuit.model, circuit.parameters
    probes = {f.address: _probe(f, before[f.address]) for f in free if f.address in before}

    def others_follow(moved: dict[str, float]) -> bool:
        return bool(circuit.with_values(moved).parameters != {**before, **moved})

    # One look at all of them is the rule, and enough.
    tied = {a for a, value in probes.items() if others_follow({a: value})} if others_follow(probes) else set()
    tied |= {i.delay for i in model.inputs}
    slots: dict[str, tuple[int, list[int]] | None] = {}
    for f in free:
        held = [k for k, i in enumerate(model.inputs) if i.default == f.address and i.name not in circuit.signals]
        is_slow = f.address not in probes or f.address in tied
        slots[f.name] = None if is_slow else (model.parameters.index(f.address), held)
    return slots


def _probe(f: Free, value: float) -> float:
    """A value of a free number close to the one that it has."""
    probe = value * (1.0 + 1e-6) if value else 1e-6 * f.scale
    return probe if f.low <= probe <= f.high else value * (1.0 - 1e-6)

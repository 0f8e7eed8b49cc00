"""One recording and the circuit that is to explain it: numbers in, modelled channels out, fast.

A run of the model is a compiled kernel on plain arrays. Derivatives with respect to the numbers come from runs that
share the step sequence of the base run: they differ smoothly, so that forward differences are good to 1e-6.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Hashable, Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit import Circuit
from poppet.engine.kernel import Kernel
from poppet.errors import InputError, relocated, suggestion
from poppet.identify.free import Free
from poppet.run_options import Run
from poppet.signals import Sampled
from poppet.simulate import Problem, RawRun
from poppet.simulate import solve as solve_whole

Array = NDArray[np.float64]

DIFFERENCE = 1e-6
"""Relative step of the forward differences over a shared step sequence."""
DELAY_STEP = 1e-3
"""Step of the central differences in a delay, as a fraction of the recording, for it moves the breakpoints."""
FINE = 1000
"""Least number of rows where a sensor's lag is modelled between sparse samples."""
SCRIPT_LENGTH = 50_000
PER_START = 75
"""Samples of a recording for each one that its first value is taken from."""
FAILED = 1e6
"""Residual, in sigmas, of samples that a failed run did not reach."""


def solve(problem: Problem) -> RawRun:
    """A run of a search: where it stalls, that place is a bad one, and not worth a slower method."""
    return solve_whole(problem, hands_over=False)


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
        self.free = tuple(f for f in free if f.recording in ("", measurement.name))
        outputs = [name for name, _ in circuit.model.outputs]
        for channel in measurement.channels:
            if channel.address not in outputs:
                raise InputError(
                    f"recordings.{measurement.name}.{channel.address}", "is no output of this circuit.",
                    suggestion(channel.address, outputs), address=f"recordings.{measurement.name}.{channel.address}",
                )  # fmt: skip
        started = _started(measurement, circuit)
        self.circuit = dataclasses.replace(started, signals={**circuit.signals, **_signals(measurement, {})})
        rows = [outputs.index(channel.address) for channel in measurement.channels]
        self.grid = _grid(measurement, any(f.role == "lag" for f in self.free))
        self.run = Run(duration=float(self.grid[-1]), relative_tolerance=relative_tolerance)
        base = self.circuit.problem(self.run)
        self._kernel = _observing(self.circuit, tuple(rows))
        self.base = dataclasses.replace(base, grid=self.grid, kernel=self._kernel)
        self.slots = {f.name: _slots(self.circuit, f) for f in self.free if f.role in ("number", "start")}
        self._last: tuple[tuple[float, ...], Problem, RawRun] | None = None
        self.places = [np.searchsorted(self.grid, channel.time) for channel in measurement.channels]

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
        """Arrays of a run with other numbers.

        Parameters
        ----------
        values : mapping
            Name of each free number to its value, SI.

        Returns
        -------
        Problem
            Ready to be solved.
        """
        base, slow = self.base, {}
        delays = {f.address: values[f.name] for f in self.free if f.role == "delay"}
        delays |= {f.address: -values[f.name] for f in self.free if f.role == "dead_time"}
        numbers = [f for f in self.free if f.role in ("number", "start")]
        slow = {f.address: values[f.name] for f in numbers if self.slots[f.name] is None}
        lags = {f.address: values[f.name] for f in self.free if f.role == "input_lag"}
        if delays or slow or lags:
            circuit = self.circuit.with_values(slow) if slow else self.circuit
            signals = {**circuit.signals, **_signals(self.measurement, delays, lags)}
            circuit = dataclasses.replace(circuit, signals=signals)
            base = dataclasses.replace(circuit.problem(self.run), grid=self.grid, kernel=self._kernel)
        p, coefficients = base.p.copy(), base.coefficients
        for f in numbers:
            slots = self.slots[f.name]
            if slots is None:
                continue
            p[slots[0]] = values[f.name]
            if slots[1]:
                coefficients = coefficients.copy() if coefficients is base.coefficients else coefficients
                coefficients[:, slots[1], 0] = values[f.name]
        x0 = base.kernel.start(p)
        return dataclasses.replace(base, p=p, x0=x0, coefficients=coefficients)

    def everything(self, values: Mapping[str, float]) -> tuple[RawRun, list[str]]:
        """A run with all outputs of the circuit, and their names.

        Parameters
        ----------
        values : mapping
            Name of each free number to its value, SI.

        Returns
        -------
        tuple of (RawRun, list of str)
            Outputs at the times of the grid.
        """
        kernel = self.circuit.kernel
        run = solve_whole(dataclasses.replace(self.problem(values), kernel=kernel))
        return run, [name for name, _ in kernel.model.outputs]

    def outputs(self, values: Mapping[str, float]) -> list[Array]:
        """Modelled channels at the measured times, lags included.

        Parameters
        ----------
        values : mapping
            Name of each free number to its value, SI.

        Returns
        -------
        list of (n,) array
            One per channel; rows that a failed run did not reach are not a number.
        """
        return self._channels(self._kept(values)[1], values)

    def _kept(self, values: Mapping[str, float]) -> tuple[Problem, RawRun]:
        """The run at some numbers with its step sequence; the last one is kept, for slopes follow at the same place."""
        key = tuple(values[f.name] for f in self.free)
        if self._last is None or self._last[0] != key:
            scripted = dataclasses.replace(self.problem(values), script=np.empty(SCRIPT_LENGTH))
            self._last = key, scripted, solve(scripted)
        return self._last[1], self._last[2]

    def _channels(self, run: RawRun, values: Mapping[str, float]) -> list[Array]:
        table = run.values
        if run.time.size < self.grid.size:
            table = np.full((run.values.shape[0], self.grid.size), np.nan)
            table[:, : run.time.size] = run.values
        result = []
        lags = {f.address: values[f.name] for f in self.free if f.role == "lag"}
        offsets = {f.address: values[f.name] for f in self.free if f.role == "offset"}
        for channel, series, places in zip(self.measurement.channels, table, self.places, strict=True):
            lag = lags.get(channel.address, channel.lag or 0.0)
            shown = series if lag <= 0.0 else lagged(self.grid, series, lag)
            result.append(shown[places] + offsets.get(channel.address, 0.0))
        return result

    def outputs_and_slopes(self, values: Mapping[str, float]) -> tuple[list[Array], list[Array]]:
        """Modelled channels and their derivatives with respect to every free number of this recording.

        Parameters
        ----------
        values : mapping
            Name of each free number to its value, SI.

        Returns
        -------
        tuple
            Channels, (n,) each; slopes, (n, number of free numbers) each, in the order of `free`.
        """
        problem, run = self._kept(values)
        base = self._channels(run, values)
        replay = _replayed(problem, run)
        slopes = [np.zeros((size, len(self.free))) for size in self.sizes]
        for k, f in enumerate(self.free):
            for slope, column in zip(slopes, self._slope(f, values, base, run, replay), strict=True):
                slope[:, k] = column
        return base, slopes

    def _slope(
        self, f: Free, values: Mapping[str, float], base: list[Array], run: RawRun, replay: Problem | None
    ) -> list[Array]:
        if f.role in ("delay", "dead_time", "input_lag"):
            step = DELAY_STEP * float(self.grid[-1])
            up, down = (
                self._channels(solve(self.problem(moved)), moved)
                for moved in ({**values, f.name: values[f.name] + way * step} for way in (1.0, -1.0))
            )
            return [(a - b) / (2.0 * step) for a, b in zip(up, down, strict=True)]
        step = DIFFERENCE * max(abs(values[f.name]), 1e-3 * f.scale)
        if values[f.name] + step > f.high:
            step = -step
        moved = {**values, f.name: values[f.name] + step}
        if f.role not in ("lag", "offset"):
            run = self._moved(f, moved, replay)
        return [(a - b) / step for a, b in zip(self._channels(run, moved), base, strict=True)]

    def _moved(self, f: Free, values: Mapping[str, float], replay: Problem | None) -> RawRun:
        """The run with one number moved, over the steps of the base run where there are any."""
        if replay is None:
            return solve(self.problem(values))
        slots = self.slots[f.name]
        if slots is None:
            again = self.problem(values)
            return solve(dataclasses.replace(again, script=replay.script, replay=True))
        # In place: the integrator knows these arrays already.
        place, held = slots
        before, inputs, start = replay.p[place], replay.coefficients[:, held, 0].copy(), replay.x0.copy()
        replay.p[place] = replay.coefficients[:, held, 0] = values[f.name]
        replay.x0[:] = replay.kernel.start(replay.p)
        run = solve(replay)
        replay.p[place], replay.coefficients[:, held, 0], replay.x0[:] = before, inputs, start
        return run


_OBSERVING: dict[tuple[Hashable, tuple[int, ...]], Kernel] = {}
"""Kernels that give the measured channels only, by structure and channels."""


def _observing(circuit: Circuit, rows: tuple[int, ...]) -> Kernel:
    key = circuit.structure, rows
    if key not in _OBSERVING:
        _OBSERVING[key] = circuit.kernel.observing(rows)
    return _OBSERVING[key]


def _replayed(problem: Problem, run: RawRun) -> Problem | None:
    """The same problem over the steps that a run took, with arrays of its own; None where these are not known."""
    if not (0 < run.accepted <= SCRIPT_LENGTH and run.outcome.is_success and not run.notes):
        return None
    own = {name: getattr(problem, name).copy() for name in ("p", "coefficients", "x0")}
    return dataclasses.replace(problem, script=problem.script[: run.accepted].copy(), replay=True, **own)


def lagged(time: Array, values: Array, lag: float) -> Array:
    r"""Response of a first-order sensor to a series that is straight between its samples.

    .. math:: \tau \dot y + y = u, \quad y(0) = u(0)

    Parameters
    ----------
    time : (n,) array
        Times [s].
    values : (n,) array
        What the sensor is exposed to.
    lag : float
        Time constant tau [s]; zero or less is no lag.

    Returns
    -------
    (n,) array
        What the sensor shows.

    Examples
    --------
    >>> ramp = np.linspace(0.0, 10.0, 101)
    >>> bool(abs(lagged(ramp, ramp, 0.5)[-1] - 9.5) < 1e-8)
    True
    """
    if lag <= 0.0:
        return values
    steps = np.diff(time)
    decay = np.exp(-steps / lag)
    slope = np.diff(values) / steps
    # Exact for straight pieces: the sensor trails a ramp by slope * lag.
    push = slope * steps - slope * lag * (1.0 - decay)
    first, second = np.concatenate([[0.0], decay]), np.concatenate([[values[0]], values[:-1] * (1.0 - decay) + push])
    return _recursion(first, second)


def _recursion(factor: Array, term: Array) -> Array:
    """y[k] = factor[k] y[k-1] + term[k] from y = 0, by doubling the reach of every row."""
    factor, result, reach = factor.copy(), term.copy(), 1
    while reach < result.size:
        result[reach:] += factor[reach:] * result[:-reach]
        factor[reach:] = factor[reach:] * factor[:-reach]
        reach *= 2
    return result


def shifted(time: Array, values: Array, late: float) -> tuple[Array, Array]:
    """A record that is late by some time, put right: its values happened that much earlier.

    Parameters
    ----------
    time, values : (n,) array
        The record, beginning at 0.
    late : float
        Time by which it is late [s]; negative when it is early.

    Returns
    -------
    tuple of (m,) array
        Times from 0 on, and values; before the first value it is held.
    """
    moved = time - late
    first = float(np.interp(0.0, moved, values))
    inside = moved > 0.0
    return np.concatenate([[0.0], moved[inside]]), np.concatenate([[first], values[inside]])


def _signals(measurement: Any, delays: Mapping[str, float], lags: Mapping[str, float] | None = None) -> dict[str, Any]:
    """Recorded inputs as signals, put right for the lateness and the lag of their instruments."""
    signals, lags = {}, lags or {}
    for item in measurement.inputs:
        values = item.values
        lag = lags.get(item.address, item.lag or 0.0)
        if lag:
            values = values + lag * np.gradient(values, item.time)
        time, values = shifted(item.time, values, delays.get(item.address, item.delay or 0.0))
        signals[item.address] = Sampled(time, values, f"{measurement.name}.{item.address}")
    return signals


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


def first_value(channel: Any) -> float:
    """A channel at its first sample: of many samples, what a straight line through the first few says, for the noise.

    Parameters
    ----------
    channel : Channel
        Samples from time 0 on.

    Returns
    -------
    float
        In the unit of the channel; the first sample itself where there are few, or where a line does not fit.
    """
    from poppet.measured import noise_of

    n = channel.values.size // PER_START
    if n < 3:
        return float(channel.values[0])
    time, values = channel.time[:n], channel.values[:n]
    line = np.polynomial.Polynomial.fit(time, values, 1)
    misfit = float(np.sqrt(np.mean((line(time) - values) ** 2)))
    is_straight = misfit <= 2.0 * max(noise_of(channel.values, channel.time), channel.quantum)
    return float(line(0.0)) if is_straight else float(channel.values[0])


def _grid(measurement: Any, has_lag: bool) -> Array:
    times = [np.zeros(1), *(channel.time for channel in measurement.channels)]
    grid = np.unique(np.concatenate(times))
    if has_lag or any(channel.lag for channel in measurement.channels):
        grid = np.unique(np.concatenate([grid, np.linspace(0.0, grid[-1], FINE)]))
    return grid


def _slots(circuit: Circuit, f: Free) -> tuple[int, list[int]] | None:
    """Place of a free number in p and of the inputs it is the default of; None where other numbers follow from it."""
    names = circuit.model.parameters
    if f.address not in names:
        return None
    before = circuit.parameters
    probe = before[f.address] * (1.0 + 1e-6) if before[f.address] else 1e-6 * f.scale
    if not f.low <= probe <= f.high:
        probe = before[f.address] * (1.0 - 1e-6)
    after = circuit.with_values({f.address: probe}).parameters
    if set(after) != set(before) or [k for k in before if after[k] != before[k]] != [f.address]:
        return None
    model = circuit.model
    held = [k for k, i in enumerate(model.inputs) if i.default == f.address and i.name not in circuit.signals]
    if any(i.delay == f.address for i in model.inputs):
        return None
    return names.index(f.address), held

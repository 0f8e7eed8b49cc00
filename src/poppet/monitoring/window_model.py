"""Runs of a circuit over a window of samples, with sensitivities by the start state and the free parameters.

The start state consists of parameters of a derived model (`model_from_state`). The runs of a window, one with the given
values and one for each shifted value, therefore take the same steps in the lanes of the vector registers, and forward
differences are accurate to 1e-6.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.options import Run
from poppet.engine.call import RepeatedCall
from poppet.engine.kernel import KERNELS, Kernel, compile_kernel
from poppet.engine.lane_kernel import LockstepLanes
from poppet.engine.model import Model
from poppet.engine.problem import Problem
from poppet.engine.state_start import kernel_from_state
from poppet.monitoring.plan import WatchPlan
from poppet.timeseries.segments import MergedSegments, held, lines, merge

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

DIFFERENCE = 1e-6
"""Relative step of the forward differences over a shared step sequence."""
SAMPLED_DIFFERENCE = 0.05
"""Step of the differences of whole runs for sampled circuits, relative to the sizes of the values."""
SCRIPT_LENGTH = 50_000
MOST_ATTEMPTS, ATTEMPTS_PER_ROW = 5_000, 50
"""Maximum number of steps of a run, and further ones per sample; usual runs need about 2 steps per sample.

A search can try values with which the model would take minutes. Such a run fails.
"""


class Samples(NamedTuple):
    """Readings and inputs of a plant on one clock, in SI and absolute."""

    times: Array  # (n,) increasing [s]
    readings: Array  # (n, n_channels), NaN for missing readings
    inputs: Array  # (n, n_driven) driven inputs of the plan before their delays, NaN for missing values


class WindowRun(NamedTuple):
    """Result of a run: readings of the model and state at the end, with their sensitivities by the free values.

    The arrays are NaN after the end of a failed run.
    """

    readings: Array  # (n, n_channels)
    slopes: Array  # (n, n_channels, n_free)
    end: Array  # (n_states,)
    end_slopes: Array  # (n_states, n_free)
    end_memory: Array  # (n_memory,) discrete state, whose timers have the clock of the samples


class WindowModel:
    """Model of a plant that simulates windows of samples from any state.

    Its values are z = (x, theta): the state at the start of the window, and the free numbers of the plan. If faults can
    grow, z also contains their growth rates [SI/s]: within the window, a fault number is theta plus rate times time.

    Parameters
    ----------
    plan : WatchPlan
        Sensors, inputs and free numbers.
    tolerance : float, optional
        Relative tolerance of the integration.
    grows : bool, optional
        True if the values contain growth rates.
    """

    def __init__(self, plan: WatchPlan, *, tolerance: float = 1e-6, grows: bool = False) -> None:
        self.plan, self.tolerance = plan, tolerance
        instance, model = plan.instance, plan.instance.model
        n, first = len(model.states), len(model.parameters)
        self.n_states, self.n_memory = n, len(model.memory)
        self.n_numbers, self.n_rates = plan.prior.size, len(plan.faults) if grows else 0
        names = [name for name, _ in model.outputs]
        by_rates = plan.directions[:, : self.n_rates]
        is_grown = by_rates.any(axis=1)
        self.by_rates = by_rates[is_grown]
        grown = np.append(plan.free.places, -1 - plan.touched_inputs)[is_grown]
        rows = tuple(names.index(channel.address) for channel in plan.channels)
        self.kernel = _kernel_of(model, rows, tuple(grown.tolist()))
        further = len(self.kernel.model.parameters) - first
        self._p = self.kernel.with_memory(np.append(instance.numbers(), np.zeros(further)))
        self._memory = slice(first + n, first + n + self.n_memory)
        self._timers = slice(first + n, first + n + model.n_timers)
        segment = instance.problem(Run(duration=1.0)).coefficients[0]
        self._constants = segment[: len(model.inputs), 0].tolist()
        # A touched input is held at the value of its own parameter.
        inputs = first + n + self.n_memory + plan.touched_inputs
        self.held_inputs = tuple(zip(plan.touched_inputs.tolist(), inputs.tolist(), strict=True))
        rates = first + n + self.n_memory + len(model.inputs) + np.arange(grown.size)
        self.places = np.concatenate([first + np.arange(n), plan.free.places, inputs, rates])
        self.base = np.append(self._p[plan.free.places], [self._constants[k] for k in plan.touched_inputs])
        nominal = [state.nominal for state in model.states]
        self.sizes = np.concatenate([nominal, plan.prior, plan.prior[: self.n_rates] / plan.window])

    def runs(self, samples: Samples, begin: float, free: Integers, memory: Array) -> WindowRuns:
        """Return the prepared runs of a window.

        Parameters
        ----------
        samples : Samples
            Samples up to the end of the window. Those before its start are only necessary for delayed inputs.
        begin : float
            Start of the window [s].
        free : ndarray
            Indices of the values in z that can change.
        memory : ndarray
            Discrete state at the start, (n_memory,); its timers have the clock of the samples.
        """
        p, is_later = self._p.copy(), samples.times > begin
        p[self._memory] = memory
        p[self._timers] -= begin
        grid = np.append(0.0, samples.times[is_later] - begin)
        segments, most = self._segments(samples, begin, float(grid[-1])), MOST_ATTEMPTS + ATTEMPTS_PER_ROW * grid.size
        problem = Problem(self.kernel, p, np.zeros(self.n_states), *segments, grid, self.tolerance, most_attempts=most)
        return WindowRuns(self, problem, free, begin)

    def _segments(self, samples: Samples, begin: float, duration: float) -> MergedSegments:
        """Return the inputs of a window as segments; before the first sample, an input has its first value."""
        inputs = self.plan.instance.model.inputs
        tables = {item.name: held(value) for item, value in zip(inputs, self._constants, strict=True)}
        for item, column in zip(self.plan.inputs, samples.inputs.T, strict=True):
            present = np.isfinite(column)
            if not present.any():
                continue
            values, starts = (
                np.clip(column[present], item.low, item.high),
                samples.times[present] + (item.delay - begin),
            )
            slopes = np.zeros(starts.size)
            if not item.hold:
                slopes[:-1] = np.diff(values) / np.diff(starts)
            first = max(0, int(np.searchsorted(starts, 0.0, side="right")) - 1)
            overlap = slice(first, max(first + 1, int(np.searchsorted(starts, duration, side="left"))))
            starts, values, slopes = starts[overlap], values[overlap].copy(), slopes[overlap]
            if starts[0] < 0.0:
                values[0] -= slopes[0] * starts[0]
            elif starts[0] > 0.0:
                starts, values, slopes = np.append(0.0, starts), np.append(values[0], values), np.append(0.0, slopes)
            starts[0] = 0.0
            changes = np.append(True, (np.diff(values) != 0.0) | (slopes[1:] != slopes[:-1]))
            jumps = np.append(False, np.full(starts.size - 1, item.hold))
            tables[item.address] = lines(starts[changes], values[changes], slopes[changes], jumps[changes])
        for slope in inputs:
            if slope.slope_of:
                tables[slope.name] = tables[slope.slope_of].derivative(slope.slope_of)
        return merge([tables[item.name] for item in inputs] or [held(0.0)])


class WindowRuns:
    """Repeated runs of one window."""

    def __init__(self, model: WindowModel, problem: Problem, free: Integers, begin: float) -> None:
        self._model, self._free, self._begin = model, free, begin
        self._n_timers, self._end_memory = problem.kernel.model.n_timers, np.zeros(0)
        self._is_sampled = bool(problem.kernel.model.n_timers)
        self._elapsed = problem.grid
        self._lanes: LockstepLanes | None = None
        self._call: RepeatedCall | None = None
        if LockstepLanes.can_run(problem):
            self._lanes = LockstepLanes(problem, free.size + 1, model.places, model.held_inputs)
        else:
            self._call = RepeatedCall(problem, np.empty(SCRIPT_LENGTH))

    def run(self, z: Array, high: Array) -> WindowRun:
        """Simulate the window with the values z, (n + m,); shifted values are not above the limits `high`."""
        model, free, n = self._model, self._free, self._model.n_states
        sizes = model.sizes[free]
        steps = SAMPLED_DIFFERENCE * sizes if self._is_sampled else DIFFERENCE * np.maximum(np.abs(z[free]), sizes)
        points, lanes = np.tile(z, (free.size + 1, 1)), np.arange(free.size)
        points[lanes + 1, free] += np.where(z[free] + steps > high[free], -steps, steps)
        steps = points[lanes + 1, free] - z[free]  # as rounded
        tables = self._tables(points)
        base, differences = tables[0], (tables[1:] - tables[0]) / steps[:, None, None]
        n_channels, end = base.shape[0] - n, n + model.n_numbers
        plan, is_number, is_rate = model.plan, (free >= n) & (free < end), free >= end
        elapsed, by_rates = self._elapsed[:, np.newaxis], plan.effects[:, : model.n_rates]
        readings = base[:n_channels].T + plan.effects @ (z[n:end] - plan.reference)
        readings += elapsed * (by_rates @ z[end:])
        slopes = differences[:, :n_channels].transpose(2, 1, 0).copy()
        slopes[:, :, is_number] += plan.effects[:, free[is_number] - n]
        slopes[:, :, is_rate] += elapsed[:, :, np.newaxis] * by_rates[:, free[is_rate] - end]
        return WindowRun(readings, slopes, base[n_channels:, -1], differences[:, n_channels:, -1].T, self._end_memory)

    def _tables(self, points: Array) -> Array:
        """Return the outputs of the runs with all points, (n_points, n_outputs, n_times)."""
        model, n, end = self._model, self._model.n_states, self._model.n_states + self._model.n_numbers
        touched = model.base + (points[:, n:end] - model.plan.reference) @ model.plan.directions.T
        values = np.hstack([points[:, :n], touched, points[:, end:] @ model.by_rates.T])
        if self._lanes is not None:
            self._lanes.values[:] = values
            return self._lanes.run()
        assert self._call is not None
        call, tables = self._call, []
        for k, row in enumerate(values):
            call.p[model.places] = row
            for index, parameter in model.held_inputs:
                call.coefficients[:, index, 0] = call.p[parameter]
            replays = k > 0 and call.is_scripted and not self._is_sampled
            tables.append((call.replay() if replays else call.run()).copy())
            if k == 0:
                self._end_memory = call.memory.copy()
                self._end_memory[: self._n_timers] += self._begin
        return np.array(tables)


def _kernel_of(model: Model, rows: tuple[int, ...], grown: tuple[int, ...]) -> Kernel:
    """Return the kernel that starts from a state, and whose outputs are the channels and then the states.

    The parameters with the indices `grown` change linearly with the time; -1 - k means the input k.
    """
    base = kernel_from_state(model)
    if grown:
        base = KERNELS.get((base, grown, "growth"), lambda: compile_kernel(_growing(base.model, grown)))

    def select_outputs() -> Kernel:
        import casadi as ca

        derived, n = base.model, len(model.states)
        expressions = ca.vertcat(derived.expressions["outputs"], derived.symbols["x"][:n])
        outputs = derived.outputs + tuple((state.name, state.unit) for state in model.states)
        extended = replace(derived, outputs=outputs, expressions={**derived.expressions, "outputs": expressions})
        # Only the selected outputs are compiled.
        return replace(base, model=extended).observing([*rows, *range(len(derived.outputs), len(outputs))])

    return KERNELS.get((base, rows, "states"), select_outputs)


def _growing(model: Model, grown: tuple[int, ...]) -> Model:
    """Return a model with further parameters: the rates with which some parameters and inputs change."""
    import casadi as ca

    count, s = len(model.parameters), model.symbols
    rates, p, u = ca.SX.sym("growth", len(grown)), ca.SX(s["p"]), ca.SX(s["u"])
    for k, index in enumerate(grown):
        if index >= 0:
            p[index] += rates[k] * s["t"]
        else:
            u[-1 - index] += rates[k] * s["t"]
    names = [name for name in model.expressions if name not in ("start", "memory_start")]
    expressions = ca.substitute([model.expressions[name] for name in names], [s["p"], s["u"]], [p, u])
    return replace(
        model,
        parameters=(*model.parameters, *(f"growth.{k}" for k in range(len(grown)))),
        symbols={**s, "p": ca.vertcat(s["p"][:count], rates, s["p"][count:])},
        expressions={**model.expressions, **dict(zip(names, expressions, strict=True))},
    )

"""Public class `Stepper`: steps of a circuit from any state, with outputs and exact derivatives."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from poppet.circuit.free_numbers import FreeNumbers, Integers, free_numbers
from poppet.circuit.instance import Instance
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, SimulationError
from poppet.engine.estimator_call import EstimatorCall
from poppet.engine.lane_kernel import usual_width
from poppet.engine.lru_cache import LruCache
from poppet.engine.problem import Outcome
from poppet.engine.state_start import kernel_from_state
from poppet.engine.stepper import DerivativeCall, LaneSteps, StepCall

Array = NDArray[np.float64]
ORDERS = {"x": "states", "u": "inputs", "free": "free", "memory": "memory_names"}
"""Attribute of a stepper with the order of the values of each argument."""
BATCHES = 4
"""Number of pairs of count and duration for which lanes are prepared."""


@dataclass(frozen=True, eq=False)
class Derivatives:
    r"""Rates and outputs with their exact derivatives at one point.

    .. math:: \dot x = f(x, u, \theta), \qquad y = g(x, u, \theta)

    Parameters
    ----------
    rates, outputs : (n,), (n_y,) arrays
        f and g, SI.
    rates_by_state, rates_by_input, rates_by_free : (n, n), (n, n_u), (n, m) arrays
        Derivatives of f by the states x, the inputs u and the free parameters theta.
    outputs_by_state, outputs_by_input, outputs_by_free : (n_y, n), (n_y, n_u), (n_y, m) arrays
        Derivatives of g.
    """

    rates: Array
    outputs: Array
    rates_by_state: Array
    rates_by_input: Array
    rates_by_free: Array
    outputs_by_state: Array
    outputs_by_input: Array
    outputs_by_free: Array


@dataclass(frozen=True, eq=False)
class StateTransition:
    """State after a step, with its derivatives by the state before it and by the free parameters.

    Parameters
    ----------
    state : (n,) array
        State after the step, SI.
    by_state : (n, n) array
        Transition matrix.
    by_free : (n, m) array
        Derivatives by the free parameters.
    """

    state: Array
    by_state: Array
    by_free: Array


class Stepper:
    """Steps of a circuit from any state, with its outputs and exact derivatives.

    `Circuit.stepper` makes a stepper. Its methods write nothing into the circuit, and do not depend on earlier calls:
    the same arguments give the same bits. The only exception is `memory`, the discrete state of a sampled circuit. A
    stepper reuses its arrays, so each thread needs its own.

    All values are in SI units, and pressures are absolute. Vectors have the order of the names.

    Attributes
    ----------
    states, inputs, outputs, free : tuple of str
        Addresses of the states x, the inputs u, the outputs y and the free parameters theta.
    state_units, input_units, output_units, free_units : tuple of str
        Their SI units.
    memory : (n_z,) array
        Discrete state of a sampled or switched circuit. Each step starts from it and replaces it.
    memory_names : tuple of str
        Addresses of the discrete states.
    free_values, free_low, free_high : (m,) arrays
        Values of the free parameters in the circuit, and the limits of the parts.

    Notes
    -----
    The steps of the solver inside one `step` are adapted to the tolerance. Delays of signals are not applied: `u` acts
    immediately.
    """

    def __init__(
        self,
        instance: Instance,
        free: Sequence[str] = (),
        outputs: Sequence[str] | None = None,
        tolerance: float = 1e-6,
    ) -> None:
        self._instance, model, names = instance, instance.model, instance.model.columns[0]
        with ErrorCollector() as errors:
            if not 0.0 < tolerance < 1.0:
                errors.add("stepper.tolerance", "tolerance", value=tolerance)
            for name in outputs or ():
                if name not in names:
                    suggestion = NameSuggestion(name, names)
                    errors.add("names.unknown", name, meaning="an output of this circuit", suggestion=suggestion)
            with errors.collecting():
                self._numbers: FreeNumbers = free_numbers(instance, free)
        selected = range(len(names)) if outputs is None else [names.index(name) for name in outputs]
        self._tolerance = tolerance
        kernel = kernel_from_state(model)
        public = [k for k, item in enumerate(model.inputs) if not item.slope_of]
        self._public, position = np.array(public, dtype=np.int64), {item.name: k for k, item in enumerate(model.inputs)}
        # Inputs that are time derivatives of others.
        self._slopes = [(k, position[item.slope_of]) for k, item in enumerate(model.inputs) if item.slope_of]
        self.states = tuple(state.name for state in model.states)
        self.state_units = tuple(state.unit for state in model.states)
        self.inputs = tuple(model.inputs[k].name for k in public)
        self.input_units = tuple(model.inputs[k].unit for k in public)
        self.outputs = tuple(names[k] for k in selected)
        self.output_units = tuple(model.outputs[k][1] for k in selected)
        self.free, self.free_units = self._numbers.addresses, self._numbers.units
        self.free_values, self.free_low, self.free_high = (
            array.copy() for array in (self._numbers.values, self._numbers.low, self._numbers.high)
        )
        for array in (self.free_values, self.free_low, self.free_high):
            array.flags.writeable = False
        self.memory_names = tuple(name for name, _ in model.memory)

        start, p = instance.start()
        self._n_numbers, parameters = len(model.parameters), instance.parameters
        self._start, self._start_memory = start[: len(self.states)].copy(), p[self._n_numbers :].copy()
        self.memory = self._start_memory.copy()
        self._p = kernel.with_memory(np.zeros(len(kernel.model.parameters)))
        self._p[: self._n_numbers] = p[: self._n_numbers]

        def value(end: str | float) -> float:
            return parameters[end] if isinstance(end, str) else end

        # Unlike in a steady state, inputs without a signal have their default.
        unset = [item for item in model.inputs if item.name not in instance.signals and not item.slope_of]
        self._u = instance.held_inputs({item.name: value(item.default) for item in unset})
        self._u[[k for k, _ in self._slopes]] = 0.0
        inputs = [model.inputs[k] for k in public]
        self._input_limits = np.array([value(i.low) for i in inputs]), np.array([value(i.high) for i in inputs])
        self._lowest = np.where(kernel.positive, 0.0, -np.inf)
        self._kernel = kernel.observing(selected)
        self._call = StepCall(kernel.observing(()), self._p, self._u, tolerance)
        self._lanes: LruCache[LaneSteps] = LruCache(BATCHES)

    @cached_property
    def _derivatives(self) -> DerivativeCall:
        return DerivativeCall(self._kernel, self._numbers.places)

    @cached_property
    def _touched(self) -> Integers:
        """Columns of derivatives by the elements that free parameters touch."""
        n, places, inputs = len(self.states), self._numbers.places, self._numbers.inputs
        return np.concatenate([n + np.arange(places.size), n + places.size + inputs])

    @cached_property
    def _estimator(self) -> EstimatorCall:
        # Only its transitions are used; it needs an output.
        numbers, model = self._numbers, kernel_from_state(self._instance.model).model
        return EstimatorCall(
            model, [0], numbers.places.tolist(), numbers.inputs.tolist(), numbers.directions,
            np.zeros((1, len(self.free))), tolerance=self._tolerance,
        )  # fmt: skip

    def start(self) -> Array:
        """Return the initial state of the circuit, (n,), and set `memory` to the initial discrete state."""
        self.memory = self._start_memory.copy()
        return self._start.copy()

    def default_inputs(self) -> Array:
        """Return the inputs at the start of a run, (n_u,): values of signals at t = 0, or defaults."""
        return self._u[self._public].copy()

    def step(
        self,
        x: ArrayLike,
        dt: float,
        *,
        u: ArrayLike | None = None,
        free: ArrayLike | None = None,
        t: float | None = None,
    ) -> Array:
        """Return the state after a duration.

        Parameters
        ----------
        x : (n,) array
            State before the step, SI.
        dt : float
            Duration [s].
        u : (n_u,) or (2, n_u) array, optional
            Inputs that are constant, or that change linearly from the first row to the second (default:
            `default_inputs`).
        free : (m,) array, optional
            Values of the free parameters (default: those of the circuit). An input that depends on one of them has the
            value that follows from it, not that in `u`.
        t : float, optional
            Time at the start of the step [s]. Only circuits with a discrete state need it, for their sample instants.

        Returns
        -------
        (n,) array
            State after the step, SI. The discrete state `memory` is advanced too.

        Raises
        ------
        InputError
            If an argument has a wrong shape, or a state or an input is outside its limits.
        SimulationError
            If the solver fails. `memory` is then unchanged.
        """
        call, n_numbers = self._call, self._n_numbers
        call.x[:], time = self._state(x), self._time(t)
        first, last, p = self._course(u, free, dt)
        call.p[:n_numbers] = p[:n_numbers]
        if first is last:
            call.hold(first)
        else:
            call.ramp(first, last, dt)
        if self.memory_names:
            call.memory[:] = _vector("memory", self.memory, self.memory_names)
        if call.run(time, dt) is not Outcome.DONE:
            raise SimulationError(Note("stepper.failed", step=dt))
        if self.memory_names:
            self.memory = call.memory.copy()
        return call.x.copy()

    def steps(self, x: ArrayLike, dt: float, *, u: ArrayLike | None = None, free: ArrayLike | None = None) -> Array:
        """Return several states after a duration, each with its own inputs and free parameters.

        The steps are computed in the lanes of the vector registers, with the tolerance of single steps, but with other
        digits.

        Parameters
        ----------
        x : (k, n) array
            States before the step, SI.
        dt : float
            Duration [s].
        u : (n_u,) or (k, n_u) array, optional
            Constant inputs, of all steps or of each (default: `default_inputs`).
        free : (m,) or (k, m) array, optional
            Values of the free parameters (default: those of the circuit).

        Returns
        -------
        (k, n) array
            States after the step, SI.

        Raises
        ------
        InputError
            If an argument has a wrong shape, a state or an input is outside its limits, or the circuit has a discrete
            state.
        SimulationError
            If the solver fails for a state.
        """
        if self.memory_names:
            raise InputError("stepper.sampled", self.memory_names[0])
        numbers, states = self._numbers, np.asarray(x, dtype=np.float64)
        count = len(states) if states.ndim else 0
        if states.shape != (count, len(self.states)):
            raise _wrong_shape("x", states, (count, len(self.states)))
        for state in states[~((states > self._lowest) & (states < np.inf)).all(axis=1)]:
            self._state(state)
        if not 0.0 < dt < np.inf:
            raise InputError("stepper.duration", "dt", value=dt)
        all_u, theta = np.tile(self._u, (count, 1)), np.tile(self.free_values, (count, 1))
        if u is not None:
            rows = _rows("u", u, count, self.inputs)
            all_u[:, self._public] = self._checked(rows, *self._input_limits, self.inputs)
        if free is not None:
            rows = _rows("free", free, count, self.free)
            theta[:] = self._checked(rows, self.free_low, self.free_high, self.free)
        if not states.size:
            return states.copy()

        def single(k: int) -> Array:
            return self.step(states[k], dt, u=all_u[k, self._public], free=None if free is None else theta[k])

        if usual_width() == 1:
            return np.array([single(k) for k in range(count)])
        lanes = self._lanes.get((count, dt), lambda: LaneSteps(self._call, count, dt, numbers.places))
        n_touched, changes = numbers.places.size, (theta - numbers.values) @ numbers.directions.T
        lanes.states[:], lanes.parameters[:] = states, self._p[numbers.places] + changes[:, :n_touched]
        lanes.inputs[:] = all_u
        if free is not None:
            lanes.inputs[:, numbers.inputs] = self._u[numbers.inputs] + changes[:, n_touched:]
        ends, outcomes = lanes.run()
        return np.array([ends[k] if o is Outcome.DONE else single(k) for k, o in enumerate(outcomes)])

    def outputs_at(self, x: ArrayLike, *, u: ArrayLike | None = None, free: ArrayLike | None = None) -> Array:
        """Return the outputs at a state, (n_y,), SI.

        The arguments are those of `step`, with constant inputs. In a sampled circuit, the outputs also depend on
        `memory`.
        """
        y, state = np.empty(len(self.outputs)), np.ascontiguousarray(self._state(x))
        all_u, p = self._arguments(u, free)
        self._kernel.call("outputs", np.zeros(1), state, all_u, self._with_memory(p), y)
        return y

    def derivatives(self, x: ArrayLike, *, u: ArrayLike | None = None, free: ArrayLike | None = None) -> Derivatives:
        """Return rates and outputs at a state, with their exact derivatives.

        The arguments are those of `step`, with constant inputs. A derivative by a free parameter includes its effect on
        other numbers and on inputs. Exactly at a kink of the model, the derivatives are those of one side, or combine
        both.
        """
        call, numbers, n = self._derivatives, self._numbers, len(self.states)
        call.x[:], (call.u[:], p) = self._state(x), self._arguments(u, free)
        call.p[:] = self._with_memory(p)
        call.run()
        first_input, results = n + numbers.places.size, list[Array]()
        for by in (call.rates_by, call.outputs_by):
            # A gather is a copy: the next call overwrites the matrices.
            touched = by[:, self._touched] @ numbers.directions
            results += [by[:, :n].copy(), by[:, first_input + self._public], touched]
        return Derivatives(call.rates.copy(), call.outputs.copy(), *results)

    def transition(
        self,
        x: ArrayLike,
        dt: float,
        *,
        u: ArrayLike | None = None,
        free: ArrayLike | None = None,
        t: float | None = None,
    ) -> StateTransition:
        """Return the state after a duration, with its derivatives by the state before it and by the free parameters.

        The state is that of `step`, which also describes the arguments and the errors. `memory` remains unchanged.

        Notes
        -----
        The derivatives solve the variational equation of the model along the steps of the solver, without finite
        differences. At a sample instant, the discrete state is regarded as constant. An input that depends on a
        free parameter must be constant during the step.
        """
        state, estimator, numbers, n = self._state(x), self._estimator, self._numbers, len(self.states)
        first, last, p = self._course(u, free, dt)
        moving = numbers.inputs[first[numbers.inputs] != last[numbers.inputs]]
        if moving.size:
            raise InputError("stepper.ramp", self._instance.input_names[moving[0]])
        estimator.restart()
        estimator.time[0], estimator.p[:] = self._time(t), self._with_memory(p)
        estimator.u[:] = first, last
        theta = self.free_values if free is None else np.asarray(free, dtype=np.float64)
        # The touched elements already have the values for theta.
        estimator.base[:], estimator.reference[:] = numbers.base(p, first), theta
        estimator.mean[:n], estimator.mean[n:] = state, theta
        if estimator.advance(dt) is not Outcome.DONE:
            raise SimulationError(Note("stepper.failed", step=dt))
        transition = estimator.transition
        return StateTransition(estimator.mean[:n].copy(), transition[:, :n].copy(), transition[:, n:].copy())

    # Arguments ---------------------------------------------------------------------------------------------------

    def _course(self, u: ArrayLike | None, free: ArrayLike | None, dt: float) -> tuple[Array, Array, Array]:
        """Return all inputs at the start and at the end of a step, and the parameters."""
        if not 0.0 < dt < np.inf:
            raise InputError("stepper.duration", "dt", value=dt)
        ends = None if u is None else np.asarray(u, dtype=np.float64)
        if ends is None or ends.ndim != 2:
            all_u, p = self._arguments(ends, free)
            return all_u, all_u, p
        if ends.shape != (2, len(self.inputs)):
            raise _wrong_shape("u", ends, (2, len(self.inputs)))
        (first, p), (last, _) = (self._arguments(end, free) for end in ends)
        for k, base in self._slopes:
            first[k] = last[k] = (last[base] - first[base]) / dt
        return first, last, p

    def _time(self, t: float | None) -> float:
        """Return the start time of a step, which matters only if the circuit has a discrete state."""
        if not self.memory_names:
            # At t = 0, no digits of dt are lost.
            return 0.0
        if t is None:
            raise InputError("stepper.no_time", "t", name=self.memory_names[0])
        return t

    def _arguments(self, u: ArrayLike | None, free: ArrayLike | None) -> tuple[Array, Array]:
        """Return all inputs and the parameters for constant inputs and free parameters."""
        all_u, p = self._u, self._p
        if u is not None:
            all_u = all_u.copy()
            all_u[self._public] = self._checked(_vector("u", u, self.inputs), *self._input_limits, self.inputs)
        if free is not None:
            numbers, all_u, p = self._numbers, all_u.copy(), p.copy()
            theta = self._checked(_vector("free", free, self.free), self.free_low, self.free_high, self.free)
            # The value of an input that depends on a free parameter follows from it, not from `u`.
            numbers.write(theta, numbers.base(p, self._u), p, all_u)
        return all_u, p

    def _with_memory(self, p: Array) -> Array:
        """Return parameters followed by the present discrete state."""
        if not self._start_memory.size:
            return p
        memory = _vector("memory", self.memory, self.memory_names)
        return np.concatenate([p[: -memory.size], memory])

    def _state(self, x: ArrayLike) -> Array:
        """Return a state as an array whose shape and values are valid."""
        state = _vector("x", x, self.states)
        # Also rejects values that are not finite.
        valid = (state > self._lowest) & (state < np.inf)
        if not valid.all():
            k = int(np.argmin(valid))
            raise InputError("stepper.state", self.states[k], value=float(state[k]), unit=self.state_units[k])
        return state

    def _checked(self, values: Array, low: Array, high: Array, names: Sequence[str]) -> Array:
        """Return values, the last axis of which has given limits and names, if they are valid."""
        valid = (values >= low) & (values <= high)
        if not valid.all():
            *_, k = np.argwhere(~valid)[0]
            code, units = ("inputs", self.input_units) if names is self.inputs else ("stepper", self.free_units)
            facts = {"low": float(low[k]), "high": float(high[k]), "unit": units[k]}
            raise InputError(f"{code}.outside", names[k], given=float(values[~valid][0]), **facts)
        return values


def _vector(name: str, argument: ArrayLike, names: Sequence[str]) -> Array:
    """Return an argument as an array with one value for each of `names`."""
    values = np.asarray(argument, dtype=np.float64)
    if values.shape != (len(names),):
        raise _wrong_shape(name, values, (len(names),))
    return values


def _rows(name: str, argument: ArrayLike, count: int, names: Sequence[str]) -> Array:
    """Return an argument as an array with `count` rows; a single row applies to all."""
    values = np.asarray(argument, dtype=np.float64)
    if values.shape not in ((len(names),), (count, len(names))):
        raise _wrong_shape(name, values, (count, len(names)))
    return np.broadcast_to(values, (count, len(names)))


def _wrong_shape(name: str, values: Array, shape: tuple[int, ...]) -> InputError:
    return InputError("stepper.shape", name, shape=str(values.shape), expected=str(shape), names=ORDERS[name])

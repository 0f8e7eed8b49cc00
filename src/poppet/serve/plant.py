"""Plant: the model of a served circuit, which advances period by period with inputs that change at run time."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.stop_conditions import domain_conditions
from poppet.core.codes import Note
from poppet.engine.call import Call
from poppet.engine.problem import Outcome, constant_input_problem, ending
from poppet.engine.solve import TIGHTER, TIGHTEST
from poppet.engine.state_start import kernel_from_state
from poppet.parts.faults import FAULTS, HEALTHY, fault_code
from poppet.serve.courses import SLOPE, VALUE, SignalCourse, WrittenCourse, same_time
from poppet.serve.points import ServedCircuit

Array = NDArray[np.float64]
MOST_ATTEMPTS = 200_000
"""Maximum number of attempted steps of the integrator in one period."""
FAULT_CODES = {HEALTHY: 0.0, **{fault: fault_code(fault) for fault in FAULTS}}
"""Commands that switch the faults of a valve."""


def initial_commands(served: ServedCircuit) -> Array:
    """Return the values of the writable inputs at the start, then the codes of the faults of the circuit file."""
    inputs = [served.by_address[address].initial for address in served.writable]
    return np.array([*inputs, *(FAULT_CODES[fault] for fault in served.initial_faults.values())])


class ServedPlant:
    """Model of a served circuit with its state.

    For each period, call `begin` with the commands, read `outputs`, and call `advance`.

    Parameters
    ----------
    served : ServedCircuit
        Circuit.
    period : float
        Duration of a period [s].

    Attributes
    ----------
    outputs : (n_y,) array
        Outputs at the begin of the period, after all events at this time, as in the rows of a run.
    failure : Note or None
        Reason why the integration has failed.
    children : tuple of int
        Identifiers of the processes for which the plant waits.
    """

    children: tuple[int, ...] = ()

    def __init__(self, served: ServedCircuit, period: float) -> None:
        self.served, self._exact_period = served, Fraction(repr(float(period)))
        # `ServedCircuit.of` has checked whether the circuit can be served.
        instance = served.circuit.unguarded_instance
        full, kernel = instance.model, kernel_from_state(instance.model)
        kernel.optimise()
        n_z, run, u = len(full.memory), served.circuit.run, np.zeros(len(full.inputs))
        p = kernel.with_memory(np.zeros(len(kernel.model.parameters)))
        conditions = [
            condition
            for address, (curve, stops) in instance.domains.items()
            if curve.edge == "error"
            for condition in domain_conditions(address, curve.limits(stops), dict(full.outputs))
        ]
        problem = constant_input_problem(
            kernel if conditions else kernel.observing(()), p, np.zeros(len(full.states)), u, np.ones(1),
            relative_tolerance=run.tolerance, maximum_step=run.longest_step, most_attempts=MOST_ATTEMPTS,
        )  # fmt: skip
        problem = replace(problem, stop_conditions=tuple(conditions))
        self._problem, self._call = problem, Call(problem)
        self._set_state(instance)
        self.t, self.count = 0.0, 0
        self.failure: Note | None = None
        self.outputs, self._u, self._time = np.zeros(len(full.outputs)), u, np.zeros(1)
        self._coefficients = problem.coefficients[0]
        n_timers = full.n_timers
        self._z, self._fired, self._after = self._call.memory, np.zeros(n_timers), np.zeros(n_z)
        self._timers, self._acting = self._z[:n_timers], np.array(full.acting, dtype=bool)
        arguments = self._time, self._call.x, u, self._call.p
        self._observe = kernel.caller("outputs", *arguments, self.outputs)
        if n_timers:
            self._update = kernel.caller("update", *arguments, self._fired, self._after)

        parameters = instance.parameters
        position = {item.name: k for k, item in enumerate(full.inputs)}
        self._delays = [parameters[item.delay] if item.delay else 0.0 for item in full.inputs]
        self._slopes = {position[item.slope_of]: k for k, item in enumerate(full.inputs) if item.slope_of}
        self._written, self._courses = WrittenCourse(), dict[int, SignalCourse]()
        duration = None if run.duration is None else float(run.duration)  # type: ignore[arg-type]
        for k, item in enumerate(full.inputs):
            signal = instance.signals.get(item.slope_of or item.name)
            if signal is not None:
                delayed = signal if item.slope_of else signal.delayed(self._delays[k])
                self._courses[k] = SignalCourse(delayed, duration, item.slope_of)
            elif not item.slope_of:
                value = parameters[item.default] if isinstance(item.default, str) else item.default
                self._coefficients[k, VALUE] = value
        self._inputs = [position[address] for address in served.writable]
        locations = [served.fault_locations[valve] for valve in served.faults]
        self._faults = [(position[item.input], full.parameters.index(item.code)) for item in locations]
        for valve, (k, _) in zip(served.faults, self._faults, strict=True):
            if served.initial_faults[valve] == HEALTHY:
                del self._courses[k]  # of an idle fault
        self._commands = initial_commands(served)
        self._has_jumped = False

    def _set_state(self, instance: Instance) -> None:
        """Set the model to the initial state of an instance."""
        start, numbers = instance.start()
        n, n_z = len(instance.model.parameters), len(instance.model.memory)
        self._call.x[:] = self._problem.x0[:] = start[: self._call.x.size]
        self._call.p[:n] = numbers[:n]
        if n_z:
            self._call.p[-n_z:] = numbers[n:]

    def close(self) -> None:
        """Release what the plant uses besides memory, which is nothing without FMUs."""

    def notes(self) -> Iterator[Note]:
        """Yield notes on the accuracy of the values up to now."""
        yield from ()

    def time_of(self, count: int) -> float:
        """Return the time of a period, rounded once from the exact product [s]."""
        exact = self._exact_period
        return count * exact.numerator / exact.denominator

    # Begin of a period -------------------------------------------------------------------------------------------

    def begin(self, commands: Array) -> None:
        """Apply commands, signals and sample instants at the begin of a period, and compute `outputs`."""
        end = self.time_of(self.count + 1)
        for course in self._courses.values():
            course.cover(self.t, end)
        # Before the commands: a linear change of the last period ends here, and a new one starts at its end.
        self._enter(self.t)
        n = len(self._inputs)
        if (changed := np.flatnonzero(commands != self._commands)).size:
            for i in changed.tolist():
                if i < n:
                    self._write(self._inputs[i], float(commands[i]))
                else:
                    self._switch_fault(*self._faults[i - n], float(commands[i]))
            self._commands[:] = commands
            self._enter(self.t)
        self._act(self.t)
        self._observe()

    def _write(self, k: int, value: float) -> None:
        t = self.t + self._delays[k]
        if k not in self._slopes:
            self._written.put(t, k, value)
            return
        # The time derivative of a jump does not exist: the input changes linearly over one period.
        step = float(self._exact_period)
        present = self._coefficients[k, VALUE]
        slope = (value - present) / step
        for i, level, rate, last in ((k, present, slope, value), (self._slopes[k], slope, 0.0, 0.0)):
            self._written.put(t, i, level, rate)
            self._written.put(t + step, i, last)

    def _switch_fault(self, k: int, parameter: int, code: float) -> None:
        # From now on, commands replace the fault of the circuit file.
        self._courses.pop(k, None)
        if code:
            self._call.p[parameter] = code
        self._written.put(self.t, k, float(code > 0.0))

    def _enter(self, t: float) -> None:
        """Write the coefficients of the inputs from the time t on."""
        for k, course in self._courses.items():
            self._has_jumped |= course.enter(t)
            self._coefficients[k] = course.row()
        self._has_jumped |= self._written.enter(t, self._coefficients)

    def _inputs_at(self, t: float) -> None:
        """Compute the inputs at the time t."""
        c, dt = self._coefficients[: self._u.size], t - self._coefficients[: self._u.size, 6]
        self._u[:] = c[:, VALUE] + c[:, SLOPE] * dt
        for k in np.flatnonzero(c[:, 2]).tolist():
            _, _, amplitude, frequency, rate, phase, _ = c[k].tolist()
            turns = (frequency + 0.5 * rate * dt[k]) * dt[k]
            self._u[k] += amplitude * math.sin(2.0 * math.pi * (turns - math.floor(turns)) + phase)

    def _act(self, t: float) -> None:
        """Run the sample instants that are due at the time t, as the integrator does at the start of a segment."""
        self._inputs_at(t)
        self._time[0], due = t, t + 1e-14 * t + 1e-15
        while self._timers.size and self._timers.min() <= due:
            self._fired[:] = self._timers <= due
            self._update()
            self._has_jumped |= bool((self._acting & (self._after != self._z)).any())
            self._z[:] = self._after

    # Integration -------------------------------------------------------------------------------------------------

    def advance(self) -> None:
        """Integrate to the end of the period; after a failure, `failure` is set and the state is that before it."""
        end = self.time_of(self.count + 1)
        while True:
            stop = min((course.next() for course in self._courses.values()), default=math.inf)
            stop = min(stop, self._written.next())
            is_last = stop >= end or same_time(stop, end)
            stop = end if is_last else stop
            self._integrate(stop)
            if self.failure is not None:
                return
            self.t = stop
            if is_last:
                self.count += 1
                return
            self._enter(stop)

    def _integrate(self, stop: float) -> None:
        problem, call = self._problem, self._call
        problem.starts[0], problem.grid[0], problem.jumps[0] = self.t, stop, self._has_jumped
        self._has_jumped = False
        x, z = call.x.copy(), self._z.copy()
        outcome = call.proceed()
        # A stalled step is repeated with tighter tolerances, as in a run.
        for factor in TIGHTER if outcome is Outcome.STALLED else ():
            call.x[:], self._z[:] = x, z
            call.limits[3] = max(factor * problem.relative_tolerance, TIGHTEST)
            outcome = call.proceed()
            if outcome is not Outcome.STALLED:
                break
        if outcome is Outcome.DONE:
            # The next call continues with these tolerances and with the last length of a step.
            call.limits[3] = 0.0
        else:
            raw = call.result(outcome)
            self.failure = ending(problem, replace(raw, time=np.array([self.t])))
            call.x[:], self._z[:] = x, z

"""Plant of a served circuit with FMUs: each period consists of communication steps of a co-simulation."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import ExitStack
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.coupled_run import (
    CoupledVariables,
    agreement_notes,
    fmu_setups,
    requested_steps,
    step_course,
)
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.cosim.fmu_slave import FmuFailure
from poppet.cosim.master import Master, start_slaves
from poppet.serve.courses import ORIGIN, VALUE, same_time
from poppet.serve.plant import ServedPlant
from poppet.serve.points import ServedCircuit

Array = NDArray[np.float64]


def make_plant(served: ServedCircuit, period: float) -> ServedPlant:
    """Return the plant of a circuit, with or without FMUs."""
    return CoupledPlant(served, period) if served.circuit.fmus else ServedPlant(served, period)


def steps_per_period(circuit: BaseCircuit, period: float) -> int:
    """Return the number of communication steps in a period.

    Written values act at the start of a period. Therefore, the shortest step of all FMUs must divide the period.

    Raises
    ------
    InputError
        If the period is not a multiple of the communication step.
    """
    step = min(requested_steps(circuit, period), default=period)
    count = round(period / step)
    if count < 1 or abs(count * step - period) > 1e-9 * period:
        raise InputError("serve.communication_step", "period", period=period, step=step)
    return count


class StepPiece(NamedTuple):
    """Part of a communication step, in which the inputs of the circuit follow one set of coefficients."""

    start: float
    stop: float
    coefficients: Array
    has_jumped: bool


class StepHub:
    """Hub of the master: the circuit of a plant in one communication step."""

    def __init__(self, plant: CoupledPlant) -> None:
        self.used = plant.used
        self.initial_inputs, self.start = plant.initial_inputs, plant.start
        self.advance, self.accept = plant.advance_step, plant.accept


class CoupledPlant(ServedPlant):
    """Model of a served circuit with its FMUs, which run in child processes until `close` is called.

    Parameters
    ----------
    served : ServedCircuit
        Circuit, with the permission to execute native code.
    period : float
        Duration of a period [s].

    Raises
    ------
    SimulationError
        If an FMU cannot be loaded or initialised.
    """

    def __init__(self, served: ServedCircuit, period: float) -> None:
        super().__init__(served, period)
        circuit = served.circuit
        self._instance, self._n_steps = circuit.unguarded_instance, steps_per_period(circuit, period)
        self._variables = CoupledVariables.of(circuit.symbolic_model, circuit.fmus, circuit.connections)
        self.used = self._variables.used
        self._pieces, self._saved = list[StepPiece](), self._call.save()
        self._first = np.zeros(self._variables.of_u.size)
        tolerance = self._problem.relative_tolerance
        with ExitStack() as stack:
            try:
                slaves = start_slaves(stack, fmu_setups(circuit, tolerance))
                self._master = Master(slaves, StepHub(self), tolerance)
                self._master.initialise(self._variables.start_values(circuit.parameters))
            except FmuFailure as error:
                raise SimulationError(error.note) from None
            self.children = tuple(slave.process_id for slave in slaves)
            self._stack = stack.pop_all()

    def close(self) -> None:
        """End the child processes of the FMUs."""
        self._stack.close()

    def notes(self) -> Iterator[Note]:
        """Yield notes on the accuracy of the coupling up to now."""
        yield from agreement_notes(self._master.report)

    # Interface of the master -------------------------------------------------------------------------------------

    def initial_inputs(self, y: Array) -> Array:
        """Return the inputs of the FMUs at t = 0 for given outputs."""
        self.start(y)
        self._enter(0.0)
        return self._inputs_of_fmus(0.0)

    def start(self, y: Array) -> None:
        """Start at t = 0 with the outputs of the FMUs."""
        self._set_state(self._instance.with_numbers(self._variables.start_numbers(y)))
        self._hold(0.0, y)

    def advance_step(self, begin: float, end: float, first: Array, y: Array) -> Array:
        """Advance from the last accepted point; return the inputs of the FMUs at three points of the step."""
        result = np.tile(self._first, (3, 1))
        if end < self._pieces[-1].stop:
            # An FMU has ended the simulation, and with it the machine.
            return result
        self._call.restore(self._saved)
        self.failure = None
        middle, course = _middle(begin, end), step_course(begin, end, first, y, self._variables.is_held)
        for piece in self._pieces:
            self._coefficients[:] = piece.coefficients
            self._coefficients[self._variables.of_y] = course[int(piece.start >= middle)]
            self.t, self._has_jumped = piece.start, piece.has_jumped
            if piece.start == middle:
                self._act(middle)
                result[1] = self._inputs_of_fmus(middle)
            self._integrate(piece.stop)
            if self.failure is not None:
                # The master accepts the step if other values do not help, and the machine ends then.
                return result
        result[2] = self._inputs_of_fmus(end)
        return result

    def accept(self) -> bool:
        """Accept the last advance, and return False after a failure of the circuit."""
        return self.failure is None

    def _inputs_of_fmus(self, t: float) -> Array:
        self._inputs_at(t)
        self._time[0] = t
        self._observe()
        result: Array = self.outputs[self._variables.of_u]
        return result

    def _hold(self, t: float, y: Array) -> None:
        """Keep the outputs of the FMUs constant from the time t on."""
        self._coefficients[self._variables.of_y] = 0.0
        self._coefficients[self._variables.of_y, VALUE] = y
        self._coefficients[self._variables.of_y, ORIGIN] = t

    # Integration -------------------------------------------------------------------------------------------------

    def advance(self) -> None:
        """Take the communication steps of a period; after a failure, `failure` is set."""
        step = self._exact_period / self._n_steps
        begin = self.t
        for k in range(1, self._n_steps + 1):
            moment = self.count * self._exact_period + k * step
            end = moment.numerator / moment.denominator
            if k > 1:
                self._enter(begin)
                self._act(begin)
            self._prepare(begin, end)
            last = self._master.y
            try:
                is_complete = self._master.advance(begin, end, float(step))
            except FmuFailure as error:
                self.failure, is_complete = error.note, False
            if not is_complete:
                self.failure, self.t = self.failure or self._master.report.end, begin
                self._call.restore(self._saved)
                return
            self._has_jumped = bool((self._variables.is_held & (self._master.y != last)).any())
            self._hold(end, self._master.y)
            self.t = begin = end
        self.count += 1

    def _prepare(self, begin: float, end: float) -> None:
        """Divide a communication step at its middle and at all changes of signals and written values."""
        self._first, self._saved, self._pieces = self._inputs_of_fmus(begin), self._call.save(), []
        start, middle = begin, _middle(begin, end)
        while True:
            change = min((course.next() for course in self._courses.values()), default=np.inf)
            change, bound = min(change, self._written.next()), middle if start < middle else end
            stop = bound if change >= bound or same_time(change, bound) else change
            self._pieces.append(StepPiece(start, stop, self._coefficients.copy(), self._has_jumped))
            self._has_jumped = False
            if stop == end:
                return
            self._enter(stop)
            start = stop


def _middle(begin: float, end: float) -> float:
    return begin + 0.5 * (end - begin)

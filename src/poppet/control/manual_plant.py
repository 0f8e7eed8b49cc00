"""Plants with their controller in manual mode: bodies, cascades and further sampled parts.

The controller remains in the circuit, and the command is its manual command. The exact linear model over one sample
then includes hold, delay and sensor, the order of controllers at one instant, and inner sampled loops.
"""

from __future__ import annotations

from collections.abc import Iterator
from copy import copy
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.linear import steady_state
from poppet.circuit.linear_model import LinearModel
from poppet.circuit.newton import refine_steady_state
from poppet.circuit.sampled.point import SampledPoint
from poppet.circuit.sampled.sampled_model import SampledModel, model_at
from poppet.control.loop import SampledPlant
from poppet.control.plant import NUDGE, OperatingPoint, Plant
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.engine.call import Call
from poppet.engine.problem import Problem, constant_coefficients
from poppet.parts.part import Scope
from poppet.parts.pid import PID
from poppet.parts.quantities import COMMANDS, QUANTITIES, command_of

Array = NDArray[np.float64]

_STAGES = 10
"""Count of steps from one steady state to another one if a single step fails."""
_MET = 1e-6
"""Tolerance of an operating point as a fraction of the nominal size of the measurement."""
_NONE = 1e-12
"""Fraction of the nominal size of a command that counts as zero."""
_BESIDE, _TOLERANCE, _ATTEMPTS = 1.0, 1e-9, 1_000_000
"""Duration of a run with a small command, in which fast valves reach their position [s]."""
_ALIKE = 1e-6
_SEEN, _ANSWERS = 1e-12, 2000
"""Fraction of the largest state that counts as zero; count of samples of a step response."""


class ManualPlant(Plant):
    """Plant that contains its controller in manual mode.

    The manual command of the controller is the command of the plant. `instance` includes the controller, and `commands`
    describes its connections in the circuit.
    """

    @property
    def _hand(self) -> str:
        return f"{self.controller}.manual_command"

    def sampled(self, point: OperatingPoint, branch: str, factor: float = 1.0) -> SampledPlant:
        model = point.models[branch]
        assert isinstance(model, SampledModel)
        column, row = model.inputs.index(self._hand), model.outputs.index(self._sensor_output)
        if model.D[row, column] != 0.0:
            raise InputError("plant.direct", self.measurement, inputs=tuple(self.targets))
        size = model.sizes
        if branch == "vent":  # the model includes the present factor
            factor /= self._vent_factor(point.value)
        a, b, c = model.A * size[None, :] / size[:, None], factor * model.B[:, column] / size, model.C[row] * size
        # Without states that the command cannot reach or the measurement does not depend on.
        relevant = _reachable_states(a != 0.0, b != 0.0) & _reachable_states(a.T != 0.0, c != 0.0)
        return SampledPlant(a[np.ix_(relevant, relevant)], b[relevant], c[relevant], model.sample_time)

    def _vent_factor(self, value: float) -> float:
        """Return the vent factor of the controller at a value of the measurement, SI."""
        surroundings = self.instance.surroundings
        numbers = self.part.parameters(surroundings)
        if isinstance(self.part, PID):
            numbers = self.part.gains_at(Scope(numbers, {}, {}, surroundings), value, value)
        return float(numbers.get("vent_factor", 1.0))

    @property
    def _sensor_output(self) -> str:
        return f"{self.controller}.sensor_{self.part.controls}"

    def operating_point(self, value: Any) -> OperatingPoint:
        target = self.read(value)
        instance = self.instance.with_values({self.begins: target}) if self.begins else self.instance
        manual, setpoint = {f"{self.controller}.automatic": 0.0}, f"{self.controller}.setpoint"
        is_by_setpoint = isinstance(self.part, PID) and self.part.schedule_by == "setpoint"
        if is_by_setpoint and setpoint in instance.input_names:  # determines the vent factor of the schedule
            manual[setpoint] = target
        point = SampledPoint(instance, instance.held_inputs(manual))
        time = self.part.parameters(instance.surroundings)["sample_time"]
        if abs(point.clock.sample_time - time) > 1e-9 * time:
            raise InputError("plant.other_period", self.controller, sample_time=time, period=point.clock.sample_time)
        trim = _SteadyStateSearch(instance, point, self._hand, self._sensor_output, self.part)
        low, high = trim.limits
        causes: list[Note] = []
        for v, command in self._search_starts(trim, causes):
            operating_state = trim.find(v, command, target)
            if operating_state is not None and low <= operating_state[1] <= high:
                v, command = operating_state
                break
        else:
            moves = (
                self._value_after_step(trim.linear_model(point.start, 0.0, direction)) != 0.0
                for direction in (1.0, -1.0)
            )
            if self.part.is_of_openings and not any(moves):
                raise self._dead_zone_error("plant.dead_zone", "positive", target)
            raise SimulationError(
                Note("plant.not_trimmed", self.measurement, why=causes, **self.readable_value(target))
            )
        models: dict[str, LinearModel] = {}
        for branch in self.sides if self.part.is_of_openings else ("command", "back"):
            model = trim.linear_model(v, command, -1.0 if branch in ("vent", "back") else 1.0)
            answer = self._value_after_step(model)
            if branch == "back":
                z = np.exp(2j * np.pi * np.geomspace(1e-4, 0.4, 9))
                forward, back = (self._plant_of(side).response(z) for side in (models["command"], model))
                if answer == 0.0 or np.allclose(forward, back, rtol=_ALIKE, atol=0.0):
                    continue  # the plant has one side only
            if answer <= 0.0:
                raise self._dead_zone_error("plant.wrong_way" if answer < 0.0 else "plant.dead_zone", branch, target)
            models[branch] = model
        return OperatingPoint(target, command, models, {name: {} for name in models})

    def _plant_of(self, model: LinearModel) -> SampledPlant:
        return self.sampled(OperatingPoint(0.0, 0.0, {"": model}, {}), "")

    def _value_after_step(self, model: SampledModel) -> float:
        """Return the measured value 2000 samples after a unit step of the command.

        The result is 0 if the value is not larger than rounding errors.
        """
        plant = self._plant_of(model)
        x = np.zeros(len(plant.B))
        for _ in range(_ANSWERS):
            x = plant.A @ x + plant.B
        scale = float(np.max(np.abs(x), initial=0.0) * np.max(np.abs(plant.C), initial=0.0))
        answer = float(plant.C @ x)
        return answer if abs(answer) > _SEEN * scale else 0.0

    def _dead_zone_error(self, code: str, branch: str, target: float) -> InputError:
        return InputError(
            code, self.measurement, inputs=tuple(self.targets), branch=branch, **self.readable_value(target)
        )

    def _search_starts(self, trim: _SteadyStateSearch, causes: list[Note]) -> Iterator[tuple[Array, float]]:
        """Yield start points for the search of a steady state: state vector and command.

        If the steady state of the circuit at a typical command cannot be found, the reason is added to the list
        `causes`.
        """
        low, high = trim.limits
        bias = self.part.parameters(self.instance.surroundings)["bias"]
        command = bias if low < bias < high else 0.5 * (low + high)
        if self.part.is_of_openings:
            # A closed valve keeps the state; both sides of its kink at zero.
            yield trim.point.start, NUDGE
            yield trim.point.start, -NUDGE
            command = 0.0
        try:
            steady = steady_state(trim.instance, {self._hand: command, f"{self.controller}.automatic": 0.0})
            yield trim.point.v(steady.x, np.array(list(steady.memory.values()))), command
        except SimulationError as error:
            causes.append(error.note)  # a body without a restoring force, or a limit cycle
        yield trim.point.start, command


def _reachable_states(edges: NDArray[np.bool_], start: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Return a mask of all states that can be reached from some states.

    `start` is the mask of these states. `edges[i, j]` is True if state j directly affects state i.
    """
    reached = start
    while not np.array_equal(reached, further := reached | edges @ reached):
        reached = further
    return reached


class _SteadyStateSearch:
    """Search for the steady state and the command that give a requested measurement."""

    def __init__(self, instance: Instance, point: SampledPoint, manual_input: str, output: str, part: Any) -> None:
        self.instance, self.point, self.column = instance, point, point.input_names.index(manual_input)
        self.row = point.model.columns[0].index(output)
        self.is_of_openings = part.is_of_openings
        self.size, self.command_size = QUANTITIES[part.controls].usual, COMMANDS[command_of(part)].usual
        numbers = dict(zip(point.model.parameters, point.numbers, strict=True))
        controller = manual_input.rpartition(".")[0]
        names = ("fill_limit", "vent_limit") if part.is_of_openings else ("upper_limit", "lower_limit")
        high, low = (float(numbers[f"{controller}.{name}"]) for name in names)
        self.limits = (-low, high) if part.is_of_openings else (low, high)

    def at(self, command: float) -> SampledPoint:
        """Return a copy of the operating point with another command."""
        point = copy(self.point)
        point.u = self.point.u.copy()
        point.u[self.column] = command
        return point

    def measured_value(self, v: Array, command: float) -> float:
        """Return the measured value in SI units for the state vector `v` and a command."""
        return float(self.at(command).between(v).outputs[self.row])

    def find(self, v: Array, command: float, target: float) -> tuple[Array, float] | None:
        """Return the state vector and the command of the steady state with the measurement `target`.

        The search starts at the state `v`. It uses intermediate targets if a single step fails. The result is None if
        the search fails.
        """
        operating_state = self._solve(v, command, target)
        if operating_state is not None:
            return operating_state
        begin = self.measured_value(v, command)
        for fraction in np.linspace(0.0, 1.0, _STAGES + 1):
            operating_state = self._solve(v, command, begin + fraction * (target - begin))
            if operating_state is None:
                return None
            v, command = operating_state
        return operating_state

    def _solve(self, v: Array, command: float, target: float) -> tuple[Array, float] | None:
        """Solve for the steady state at which the measurement has the value `target`.

        Newton's method starts from the state vector `v` and the command `command`. The result contains the state vector
        and the command of the steady state. The result is None if the method does not converge.
        """
        size = np.append(self.point.size, self.command_size)

        def scaled(w: Array) -> tuple[Array, Array]:
            point = self.at(float(w[-1]))
            f, jacobian = point.scaled(w[:-1])
            intersample = point.between(w[:-1])
            by_u = point.scaled_by_u(w[:-1])[:, self.column] * self.command_size
            by_v = intersample.outputs_by_v[self.row] * point.size / self.size
            last = intersample.outputs_by_u[self.row, self.column] * self.command_size / self.size
            error = (intersample.outputs[self.row] - target) / self.size
            return np.append(f, error), np.block([[jacobian, by_u[:, None]], [by_v[None, :], np.array([[last]])]])

        is_positive = np.append(self.point.positive, False)
        w = refine_steady_state(scaled, np.append(v, command), size, is_positive, conserves=True)
        point = self.at(float(w[-1]))
        if abs(self.measured_value(w[:-1], float(w[-1])) - target) > _MET * self.size or not point.is_at_rest(w[:-1]):
            return None
        # A residual of the nudge counts as zero.
        return w[:-1], float(w[-1]) if abs(w[-1]) > _NONE * self.command_size else 0.0

    def linear_model(self, v: Array, command: float, sign: float) -> SampledModel:
        """Return the linear model at the steady state `v` for small command changes of one sign.

        The sign matters because valves and inner loops have kinks.
        """
        nudged = sign * NUDGE
        if self.is_of_openings:
            if command * sign > NUDGE:
                return model_at(self.at(command), v)
            # A small command keeps the state for this duration, also in a plant with leaks.
            return model_at(*self._run(v, nudged, _BESIDE))
        gaps = np.diff([*self.point.clock.times, self.point.clock.sample_time])
        # Just after the first instants, when inner commands have left zero on this side.
        return model_at(*self._run(v, command + nudged * self.command_size, 0.25 * float(np.min(gaps))))

    def _run(self, v: Array, command: float, duration: float) -> tuple[SampledPoint, Array]:
        """Simulate the circuit with a constant command, starting at the state vector `v`.

        The result contains the equations with this command and the final state vector. A `duration` [s] that is longer
        than the sample time is rounded to an integer multiple of the sample time.
        """
        point = self.at(command)
        (x, p), begin = point.at_clock(v), point.clock.start
        sample = point.clock.sample_time
        grid = np.array([begin + (duration if duration < sample else round(duration / sample) * sample)])
        call = Call(
            Problem(
                point.kernel, p.copy(), x.copy(), np.array([begin]), np.zeros(1, dtype=np.int64),
                constant_coefficients(point.u, begin), np.zeros(1, dtype=bool), grid, _TOLERANCE,
                most_attempts=_ATTEMPTS,
            )
        )  # fmt: skip
        run = call.run()
        if not run.outcome.is_success:
            text = str(Note(run.outcome.value))
            raise SimulationError(Note("limits.unsettled", outcome=run.outcome.value, text=text))
        return point, point.v(run.x, call.memory)

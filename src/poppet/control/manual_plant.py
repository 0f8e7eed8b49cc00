"""A plant for small changes with its controller in manual: bodies that anything may move, cascades, sampled parts.

Nothing is taken out of the circuit: the command is what the controller is given by hand, so that its hold, delay and
sensor, the order in which controllers act at one instant, and whatever is sampled further in are in the exact linear
model over one sample.
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
from poppet.parts.quantities import COMMANDS, QUANTITIES, command_of

Array = NDArray[np.float64]

_STAGES = 10
"""Steps of the way from a rest that is known to the one that is wanted, where one step does not lead there."""
_MET = 1e-6
"""Part of the usual size of what is measured within which an operating point counts as met."""
_NONE = 1e-12
"""Part of the usual size of a command that counts as none."""
_BESIDE, _TOLERANCE, _ATTEMPTS = 1.0, 1e-9, 1_000_000
"""Length of a run with a command just beyond zero, after which fast valves have followed it [s]."""
_ALIKE = 1e-6
_SEEN, _ANSWERS = 1e-12, 2000
"""Part of the greatest answer that counts as none; samples of the answer to a step."""


class ManualPlant(Plant):
    """A circuit whose controller is in manual; `instance` has it, and `commands` says how it was connected."""

    @property
    def _hand(self) -> str:
        return f"{self.controller}.manual_command"

    def sampled(self, point: OperatingPoint, branch: str, factor: float = 1.0) -> SampledPlant:
        model = point.models[branch]
        assert isinstance(model, SampledModel)
        column, row = model.inputs.index(self._hand), model.outputs.index(self._shown)
        if model.D[row, column] != 0.0:
            raise InputError("plant.direct", self.measurement, inputs=tuple(self.targets))
        size = model.sizes
        if branch == "vent":  # the controller is in the model, with the factor that it has now
            factor /= self.part.parameters(self.instance.surroundings).get("vent_factor", 1.0)
        a, b, c = model.A * size[None, :] / size[:, None], factor * model.B[:, column] / size, model.C[row] * size
        # What the command does not reach, and what the measurement does not show, as the controller's own memory.
        kept = _reached(a != 0.0, b != 0.0) & _reached(a.T != 0.0, c != 0.0)
        return SampledPlant(a[np.ix_(kept, kept)], b[kept], c[kept], model.sample_time)

    @property
    def _shown(self) -> str:
        return f"{self.controller}.sensor_{self.part.controls}"

    def operating_point(self, value: Any) -> OperatingPoint:
        wanted = self.read(value)
        instance = self.instance.with_values({self.begins: wanted}) if self.begins else self.instance
        by_hand = {f"{self.controller}.automatic": 0.0}
        point = SampledPoint(instance, instance.held_inputs(by_hand))
        time = self.part.parameters(instance.surroundings)["sample_time"]
        if abs(point.clock.sample_time - time) > 1e-9 * time:
            raise InputError("plant.other_period", self.controller, sample_time=time, period=point.clock.sample_time)
        trim = _Trim(instance, point, self._hand, self._shown, self.part)
        v, command = self._found(trim, wanted)
        models: dict[str, LinearModel] = {}
        for branch in self.sides if self.part.is_of_openings else ("command", "back"):
            model = trim.model(v, command, -1.0 if branch in ("vent", "back") else 1.0)
            answer = self._answer(model)
            if branch == "back" and (answer == 0.0 or self._is_alike(models["command"], model)):
                continue  # a valve of one side, or nothing that has two
            if answer <= 0.0:
                raise self._refused("plant.wrong_way" if answer < 0.0 else "plant.dead_zone", branch, wanted)
            models[branch] = model
        return OperatingPoint(wanted, command, models, {name: {} for name in models})

    def _is_alike(self, first: LinearModel, second: LinearModel) -> bool:
        """True when both are the same plant for the command and the measurement."""
        one, other = (self.sampled(OperatingPoint(0.0, 0.0, {"": each}, {}), "") for each in (first, second))
        z = one.at(np.geomspace(1e-4, 0.4, 9) / one.sample_time)
        return bool(np.allclose(one.response(z), other.response(z), rtol=_ALIKE, atol=0.0))

    def _answer(self, model: SampledModel) -> float:
        """What a step of the command has made of the measurement after some time; 0 where that is rounding."""
        plant = self.sampled(OperatingPoint(0.0, 0.0, {"": model}, {}), "")
        x, seen = np.zeros(len(plant.B)), [0.0]
        for _ in range(_ANSWERS):
            x = plant.A @ x + plant.B
            seen.append(float(plant.C @ x))
        greatest = float(np.max(np.abs(x), initial=0.0) * np.max(np.abs(plant.C), initial=0.0))
        return seen[-1] if abs(seen[-1]) > _SEEN * greatest else 0.0

    def _found(self, trim: _Trim, wanted: float) -> tuple[Array, float]:
        """A rest with the command that makes it, from wherever one can be followed to it."""
        low, high = trim.limits
        why: list[Note] = []
        for v, command in self._begins(trim, why):
            found = trim.followed(v, command, wanted)
            if found is not None and low <= found[1] <= high:
                return found
        if self.part.is_of_openings and all(
            self._answer(trim.model(trim.point.start, 0.0, way)) == 0.0 for way in (1.0, -1.0)
        ):
            raise self._refused("plant.dead_zone", "positive", wanted)
        raise SimulationError(Note("plant.not_trimmed", self.measurement, why=why, **self.shown(wanted)))

    def _refused(self, code: str, branch: str, wanted: float) -> InputError:
        return InputError(code, self.measurement, inputs=tuple(self.targets), branch=branch, **self.shown(wanted))

    def _begins(self, trim: _Trim, why: list[Note]) -> Iterator[tuple[Array, float]]:
        """Where a search may begin: where the circuit does; where that comes to rest, or `why` it comes to none."""
        low, high = trim.limits
        bias = self.part.parameters(self.instance.surroundings)["bias"]
        command = bias if low < bias < high else 0.5 * (low + high)
        if self.part.is_of_openings:
            # A valve that is shut holds what there is; on either side of its kink at zero.
            yield trim.point.start, NUDGE
            yield trim.point.start, -NUDGE
            command = 0.0
        try:
            rest = steady_state(trim.instance, {self._hand: command, f"{self.controller}.automatic": 0.0})
            yield trim.point.v(rest.x, np.array(list(rest.memory.values()))), command
        except SimulationError as error:
            why.append(error.note)  # a body that any force moves on, or what hunts
        yield trim.point.start, command


def _reached(leads: NDArray[np.bool_], first: NDArray[np.bool_]) -> NDArray[np.bool_]:
    """Elements to which a way leads from the first ones; `leads[i, j]` is true where one goes from j to i."""
    found = first
    while not np.array_equal(found, further := found | leads @ found):
        found = further
    return found


class _Trim:
    """Rests of a circuit over the command: the one at which the measurement has a value."""

    def __init__(self, instance: Instance, point: SampledPoint, hand: str, shown: str, part: Any) -> None:
        self.instance, self.point, self.column = instance, point, point.input_names.index(hand)
        self.row = point.model.columns[0].index(shown)
        self.is_of_openings = part.is_of_openings
        self.size, self.command_size = QUANTITIES[part.controls].usual, COMMANDS[command_of(part)].usual
        numbers = dict(zip(point.model.parameters, point.numbers, strict=True))
        own = hand.rpartition(".")[0]
        names = ("fill_limit", "vent_limit") if part.is_of_openings else ("upper_limit", "lower_limit")
        high, low = (float(numbers[f"{own}.{name}"]) for name in names)
        self.limits = (-low, high) if part.is_of_openings else (low, high)

    def at(self, command: float) -> SampledPoint:
        """The circuit under another command."""
        other = copy(self.point)
        other.u = self.point.u.copy()
        other.u[self.column] = command
        return other

    def shown(self, v: Array, command: float) -> float:
        """The measurement."""
        return float(self.at(command).between(v).outputs[self.row])

    def followed(self, v: Array, command: float, wanted: float) -> tuple[Array, float] | None:
        """The rest at which the measurement has a value, in one step or, from a rest, in several."""
        found = self._near(v, command, wanted)
        if found is not None:
            return found
        begin = self.shown(v, command)
        for share in np.linspace(0.0, 1.0, _STAGES + 1):
            found = self._near(v, command, begin + share * (wanted - begin))
            if found is None:
                return None
            v, command = found
        return found

    def _near(self, v: Array, command: float, wanted: float) -> tuple[Array, float] | None:
        """By Newton's method: nothing changes, and the measurement is what it should be."""
        size = np.append(self.point.size, self.command_size)

        def scaled(w: Array) -> tuple[Array, Array]:
            point = self.at(float(w[-1]))
            f, jacobian = point.scaled(w[:-1])
            between = point.between(w[:-1])
            by_u = point.scaled_by_u(w[:-1])[:, self.column] * self.command_size
            by_v = between.outputs_by_v[self.row] * point.size / self.size
            last = between.outputs_by_u[self.row, self.column] * self.command_size / self.size
            miss = (between.outputs[self.row] - wanted) / self.size
            return np.append(f, miss), np.block([[jacobian, by_u[:, None]], [by_v[None, :], np.array([[last]])]])

        w = refine_steady_state(
            scaled, np.append(v, command), size, np.append(self.point.positive, False), conserves=True
        )
        found = self.at(float(w[-1]))
        if abs(self.shown(w[:-1], float(w[-1])) - wanted) > _MET * self.size or not found.is_at_rest(w[:-1]):
            return None
        # What is left of a nudge is no command.
        return w[:-1], float(w[-1]) if abs(w[-1]) > _NONE * self.command_size else 0.0

    def model(self, v: Array, command: float, sign: float) -> SampledModel:
        """The linear model at a rest, on one side of its kinks: a valve that is shut, a loop further in."""
        nudged = sign * NUDGE
        if self.is_of_openings:
            if command * sign > NUDGE:
                return model_at(self.at(command), v)
            # What is beside zero here holds the state for the moment, be the plant tight or not.
            return model_at(*self._run(v, nudged, _BESIDE))
        gaps = np.diff([*self.point.clock.times, self.point.clock.sample_time])
        # Just after the first instants, when what they command has left its zero on that side.
        return model_at(*self._run(v, command + nudged * self.command_size, 0.25 * float(np.min(gaps))))

    def _run(self, v: Array, command: float, duration: float) -> tuple[SampledPoint, Array]:
        """Where a command leads in some time; a long run ends at the beginning of a sample."""
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

"""A circuit without its controller: what it commands, what it measures, and linear models at operating points."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from poppet.circuit.instance import Instance
from poppet.circuit.linear import linearise, steady_state
from poppet.circuit.linear_model import LinearModel
from poppet.control.loop import SampledPlant, sampled_plant
from poppet.control.metrics import readable
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.core.units import convert, quantity
from poppet.parts.quantities import QUANTITIES
from poppet.parts.sampled_loop import NEXT_SAMPLE, SampledLoop
from poppet.timeseries.recording import Recording

COMMANDS = {"command": 1.0, "fill_command": 1.0, "vent_command": -1.0}
"""Outputs of a controller and the sign with which the pressure follows them."""
SIGNS = {"command": 1.0, "fill": 1.0, "vent": -1.0}
"""Sides of an operating point and the sign of their commands."""
_NEAR = 1e-4
"""Part of a pressure within which an operating point counts as met."""
_CORRECTIONS = 6
_TINY, _FINE = 1e-15, 1e-7
"""Tolerances of the command that holds a pressure: in all, and as a part of it."""
NUDGE = 1e-6
"""Command beside zero at which a linear model is made: on one side of the kink of a closed valve."""


@dataclass(frozen=True)
class OperatingPoint:
    """A rest at a pressure or another value of what is controlled, and how the plant answers there.

    Parameters
    ----------
    value : float
        Measured, at rest, SI.
    command : float
        That holds it; a positive opening fills.
    models : dict
        `fill` and `vent`, or `command`, of a valve that opens both ways also `back`, to the linear model of the circuit
        without its controller, for commands of that sign. The side on which the command rests has the model of the
        rest; the other one that of a command just beyond zero at the same state, for the loop goes there in every move
        the other way, be the plant tight or not.
    weights : dict
        The same names to the inputs that such a command moves, with their signs.
    """

    value: float
    command: float
    models: Mapping[str, LinearModel]
    weights: Mapping[str, Mapping[str, float]]


@dataclass(frozen=True, eq=False)
class Plant:
    """A circuit without one controller.

    Parameters
    ----------
    instance : Instance
        Of the circuit without it; inputs that the controller drove are free.
    controller : str
        Name of the part that was taken out.
    part : SampledLoop
        It.
    measurement : str
        Address of what it measures.
    commands : dict
        Output of the controller to the inputs that take it.
    begins : str
        Address of the initial value of what is measured; empty where that follows from other states.
    notes : tuple of Note
        What was taken for something else in it: friction that sticks for its viscous part.
    """

    instance: Instance
    controller: str
    part: SampledLoop
    measurement: str
    commands: Mapping[str, tuple[str, ...]]
    begins: str
    notes: tuple[Note, ...] = ()

    @property
    def targets(self) -> list[str]:
        """Inputs that the controller commands."""
        return [target for inputs in self.commands.values() for target in inputs]

    @property
    def sides(self) -> tuple[str, ...]:
        """The sides on which a command acts."""
        if not self.part.is_of_openings:
            return ("command",)
        named = {"fill": "fill_command", "vent": "vent_command", "command": "command", "back": "command"}
        return tuple(side for side, output in named.items() if output in self.commands)

    def read(self, value: Any) -> float:
        """A value of what is measured.

        Parameters
        ----------
        value : float or str
            SI, or text with a unit.

        Returns
        -------
        float
            SI, a pressure absolute.
        """
        read = quantity(value, self.part.unit, kind=QUANTITIES[self.part.controls].kind, name="operating point")
        return float(read.value + (self.instance.surroundings.pressure if read.reference == "gauge" else 0.0))

    def shown(self, value: float) -> dict[str, Any]:
        """A value of what is measured as people read it.

        Parameters
        ----------
        value : float
            SI.

        Returns
        -------
        dict
            `value` and its `unit`.
        """
        unit = readable(self.part.unit)
        return {"value": convert(value, self.part.unit, unit), "unit": unit}

    @property
    def delay(self) -> int:
        """Samples by which a command comes late."""
        return 1 if self.part.acts == NEXT_SAMPLE else 0

    def sampled(self, point: OperatingPoint, branch: str, factor: float = 1.0) -> SampledPlant:
        """The plant as the controller meets it, for one sign of its command.

        Parameters
        ----------
        point : OperatingPoint
            Where.
        branch : str
            Of the point's models.
        factor : float, optional
            On the command.

        Returns
        -------
        SampledPlant
            With sensor, hold and delay.
        """
        numbers = self.part.parameters(self.instance.surroundings)
        weights = {name: factor * weight for name, weight in point.weights[branch].items()}
        return sampled_plant(
            point.models[branch], weights, self.measurement, sample_time=numbers["sample_time"],
            sensor_lag=numbers["sensor.lag"], delay=self.delay,
        )  # fmt: skip

    def operating_point(self, value: Any) -> OperatingPoint:
        """The rest at which the measurement has a value.

        Parameters
        ----------
        value : float or str
            SI, or text with a unit.

        Returns
        -------
        OperatingPoint
            With the command that holds it, 0 for a chamber that is tight, and a model for each side that is connected.

        Raises
        ------
        SimulationError
            If no command holds it.
        """
        wanted = self.read(value)
        instance = self._begun_at(wanted)
        command = 0.0
        if abs(self._rest(instance, 0.0) - wanted) > _NEAR * wanted:
            command = self._holding(instance, wanted)
        rest = steady_state(instance, self._inputs(command))
        if abs(rest.y[self.measurement] - wanted) > _NEAR * wanted:  # a leak that takes decades is no rest to be found
            raise self._not_held(wanted, rest.y[self.measurement])
        weights, models = self._weights(), {}
        for branch, inputs in weights.items():
            sign = SIGNS[branch]
            # Beside the kink of a valve that is closed at rest, on the side of this branch, but at the same state.
            beside = command if command * sign > 0.0 else sign * NUDGE
            models[branch] = linearise(instance, self._inputs(beside), at=_row(instance, rest.y))
            self._check_moved(models[branch], branch, inputs)
        return OperatingPoint(rest.y[self.measurement], command, models, weights)

    def _begun_at(self, wanted: float) -> Instance:
        """The plant with the measured store beginning so that, left alone, it comes to rest at a pressure."""
        if not self.begins:
            return self.instance
        begin, instance = wanted, self.instance
        for _ in range(_CORRECTIONS):
            instance = self.instance.with_values({self.begins: begin})
            reached = self._rest(instance, 0.0)
            if abs(reached - wanted) <= _NEAR * wanted:
                break
            again = begin * wanted / reached
            if abs(self._rest(instance.with_values({self.begins: again}), 0.0) - reached) <= _NEAR * wanted:
                break  # a leak decides, not the beginning
            begin = again
        return instance

    def _holding(self, instance: Instance, wanted: float) -> float:
        """The command at which the plant rests at a pressure."""
        from scipy.optimize import brentq

        def miss(command: float) -> float:
            return self._rest(instance, command) - wanted

        limits = self.part.parameters(self.instance.surroundings)
        end = limits["fill_limit"] if miss(0.0) < 0.0 else -limits["vent_limit"]
        if end == 0.0 or miss(0.0) * miss(end) > 0.0:
            raise self._not_held(wanted, self._rest(instance, end))
        # A small leak is held by a small command: the tolerance is a part of it.
        return float(brentq(miss, 0.0, end, xtol=_TINY, rtol=_FINE))

    def _not_held(self, wanted: float, reached: float) -> SimulationError:
        return SimulationError(Note("plant.not_held", self.measurement, wanted=wanted, reached=reached))

    def _rest(self, instance: Instance, command: float) -> float:
        return steady_state(instance, self._inputs(command)).y[self.measurement]

    def _inputs(self, command: float) -> dict[str, float]:
        values = {"command": command, "fill_command": max(command, 0.0), "vent_command": max(-command, 0.0)}
        return {target: values[output] for output, targets in self.commands.items() for target in targets}

    def _weights(self) -> dict[str, dict[str, float]]:
        """The inputs that small changes of the command move, by its sign."""
        outputs = {"command": "command", "fill": "fill_command", "vent": "vent_command"}
        return {
            branch: dict.fromkeys(self.commands[output], COMMANDS[output])
            for branch, output in outputs.items()
            if output in self.commands
        }

    def _check_moved(self, model: LinearModel, branch: str, inputs: Mapping[str, float]) -> None:
        row = model.outputs.index(self.measurement)
        pushed = sum(model.B[:, model.inputs.index(target)] * weight for target, weight in inputs.items())
        # C A^k B: the first of them that is not zero says which way the measurement moves at first.
        reached, ways = pushed, [pushed]
        for _ in model.states:
            reached = model.A @ reached
            ways.append(reached)
        answers = [answer for way in ways if (answer := float(model.C[row] @ way))]
        if answers and answers[0] > 0.0:
            return
        code = "beyond_exhaust" if branch == "vent" else "beyond_supply"
        code = f"plant.{code if answers else 'dead_zone'}"
        raise InputError(code, self.measurement, inputs=tuple(inputs), branch=branch, **self.shown(model.y[row]))


def place(plant: Plant, value: float, branch: str) -> str:
    """Where a loop is looked at, `2 bar, fill`."""
    return f"{'{value:.4g} {unit}'.format(**plant.shown(value))}, {branch}"


def _row(instance: Instance, values: Mapping[str, float]) -> Recording:
    """A recording of one row: where a linear model is made."""
    units = dict(instance.model.outputs)
    return Recording.from_series([0.0], {f"{name} [{units[name]}]": [value] for name, value in values.items()})

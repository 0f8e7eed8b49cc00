"""Plants: circuits without their controller, with linear models at operating points."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

from poppet.circuit.instance import Instance
from poppet.circuit.linear import linearise, steady_state
from poppet.circuit.linear_model import LinearModel
from poppet.control.loop import SampledPlant, sampled_plant
from poppet.control.metrics import readable_unit_of
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.core.tables import Field
from poppet.core.units import convert
from poppet.parts.quantities import QUANTITIES
from poppet.parts.sampled_loop import NEXT_SAMPLE, SampledLoop
from poppet.timeseries.recording import Recording

COMMANDS = {"command": 1.0, "fill_command": 1.0, "vent_command": -1.0}
"""Outputs of a controller and the sign of their effect on the pressure."""
SIGNS = {"command": 1.0, "fill": 1.0, "vent": -1.0}
"""Sides of an operating point and the signs of their commands."""
_TOLERANCE = 1e-4
"""Tolerance of the measurement at an operating point, relative to the requested value."""
_CORRECTIONS = 6
_ABSOLUTE, _RELATIVE = 1e-15, 1e-7
"""Absolute and relative tolerance of the command at an operating point."""
NUDGE = 1e-6
"""Command at which a closed valve is linearised, on one side of its kink at zero."""


@dataclass(frozen=True)
class OperatingPoint:
    """Steady state of a plant at a value of the measurement, with linear models.

    Parameters
    ----------
    value : float
        Measurement at the steady state, SI.
    command : float
        Command at the steady state. A positive opening means that the fill valve is open.
    models : dict
        Linear models of the plant, because it can depend on the sign of the command. A controller with two commands has
        the models `fill` (positive command) and `vent` (negative command). Other controllers have the model `command`
        and, if a decreasing command has another effect, the model `back`. The model for the sign of the steady command
        is linearised at the steady state. The model for the other sign is linearised at the same state with a small
        command of that sign.
    weights : dict
        For each model, a mapping from the address of each driven input to a factor, +1 or -1. The value of the input is
        the command multiplied by this factor.
    """

    value: float
    command: float
    models: Mapping[str, LinearModel]
    weights: Mapping[str, Mapping[str, float]]


@dataclass(frozen=True, eq=False)
class Plant:
    """Circuit without one controller, with the inputs that this controller would drive.

    Parameters
    ----------
    instance : Instance
        Instance of the circuit without the controller.
    controller : str
        Name of the controller.
    part : SampledLoop
        The controller.
    measurement : str
        Address of the measurement.
    commands : dict
        Mapping from each output of the controller to the addresses of the inputs that the output drives.
    begins : str
        Address of the initial value of the measurement; empty if it depends on other states.
    notes : tuple of Note
        Simplifications of the plant, such as viscous friction in place of stiction.
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
        """Addresses of the inputs that the controller drives."""
        return [target for inputs in self.commands.values() for target in inputs]

    @property
    def sides(self) -> tuple[str, ...]:
        """Names of the sides (signs) of the command, such as `fill` and `vent`."""
        if not self.part.is_of_openings:
            return ("command",)
        outputs = {"fill": "fill_command", "vent": "vent_command", "command": "command", "back": "command"}
        return tuple(side for side, output in outputs.items() if output in self.commands)

    def read(self, value: Any) -> float:
        """Convert a value of the measured quantity to SI units.

        Parameters
        ----------
        value : float or str
            Value in SI, or text with a unit.

        Returns
        -------
        float
            Value in SI; a pressure is absolute.
        """
        field = Field(unit=self.part.unit, kind=QUANTITIES[self.part.controls].kind)
        return float(field.read(value, "operating point", self.instance.surroundings.pressure))

    def readable_value(self, value: float) -> dict[str, Any]:
        """Convert an SI value of the measured quantity to a readable unit.

        Parameters
        ----------
        value : float
            Value in SI.

        Returns
        -------
        dict
            The converted `value` and its `unit`.
        """
        unit = readable_unit_of(self.part.unit)
        return {"value": convert(value, self.part.unit, unit), "unit": unit}

    @property
    def delay(self) -> int:
        """Number of samples from a measurement to the command that uses it."""
        return 1 if self.part.acts == NEXT_SAMPLE else 0

    def sampled(self, point: OperatingPoint, branch: str, factor: float = 1.0) -> SampledPlant:
        """Return a linear sampled plant for commands on one side of an operating point.

        Parameters
        ----------
        point : OperatingPoint
            Operating point.
        branch : str
            Side of the command.
        factor : float, optional
            Factor on the command.

        Returns
        -------
        SampledPlant
            Plant with sensor, hold and delay.
        """
        numbers = self.part.parameters(self.instance.surroundings)
        weights = {name: factor * weight for name, weight in point.weights[branch].items()}
        return sampled_plant(
            point.models[branch], weights, self.measurement, sample_time=numbers["sample_time"],
            sensor_lag=numbers["sensor.lag"], delay=self.delay,
        )  # fmt: skip

    def operating_point(self, value: Any) -> OperatingPoint:
        """Return the steady state at which the measurement has a given value.

        Parameters
        ----------
        value : float or str
            Value in SI, or text with a unit.

        Returns
        -------
        OperatingPoint
            Steady state with its command, 0 for a tight chamber, and a model for each connected side.

        Raises
        ------
        SimulationError
            If no command leads to a steady state at this value.
        """
        target = self.read(value)
        instance = self._with_initial_value(target)
        command = 0.0
        if abs(self._rest(instance, 0.0) - target) > _TOLERANCE * target:
            from scipy.optimize import brentq

            def error(command: float) -> float:
                return self._rest(instance, command) - target

            limits = self.part.parameters(self.instance.surroundings)
            limit = limits["fill_limit"] if error(0.0) < 0.0 else -limits["vent_limit"]
            if limit == 0.0 or error(0.0) * error(limit) > 0.0:
                raise self._unreachable(target, self._rest(instance, limit))
            # A small leak needs a small command: the tolerance is relative.
            command = float(brentq(error, 0.0, limit, xtol=_ABSOLUTE, rtol=_RELATIVE))
        steady = steady_state(instance, self._inputs(command))
        if abs(steady.y[self.measurement] - target) > _TOLERANCE * target:  # a leak with a very long time constant
            raise self._unreachable(target, steady.y[self.measurement])
        outputs = {"command": "command", "fill": "fill_command", "vent": "vent_command"}
        connected = [(branch, output) for branch, output in outputs.items() if output in self.commands]
        # For each side, the inputs that its command drives and their signs.
        weights = {branch: dict.fromkeys(self.commands[output], COMMANDS[output]) for branch, output in connected}
        models = {}
        for branch, inputs in weights.items():
            sign = SIGNS[branch]
            # On this side of the kink of a closed valve, at the same state.
            nudged = command if command * sign > 0.0 else sign * NUDGE
            # A recording of one row: the state at which the model is made.
            units = dict(instance.model.outputs)
            row = Recording.from_series([0.0], {f"{name} [{units[name]}]": [y] for name, y in steady.y.items()})
            models[branch] = model = linearise(instance, self._inputs(nudged), at=row)
            index = model.outputs.index(self.measurement)
            # The first nonzero C A^k B has the sign of the initial response.
            state_rate = sum(model.B[:, model.inputs.index(target)] * weight for target, weight in inputs.items())
            effect = float(model.C[index] @ state_rate)
            for _ in model.states if effect == 0.0 else ():
                state_rate = model.A @ state_rate
                effect = effect or float(model.C[index] @ state_rate)
            if not effect > 0.0:
                code = "beyond_exhaust" if branch == "vent" else "beyond_supply"
                code = f"plant.{code if effect else 'dead_zone'}"
                facts = {"inputs": tuple(inputs), "branch": branch, **self.readable_value(model.y[index])}
                raise InputError(code, self.measurement, **facts)
        return OperatingPoint(steady.y[self.measurement], command, models, weights)

    def _with_initial_value(self, target: float) -> Instance:
        """Return the plant with an initial pressure from which the measurement settles at `target`.

        The command is zero. If a leak determines the steady state, the initial pressure has no effect.
        """
        if not self.begins:
            return self.instance
        initial, instance = target, self.instance
        for _ in range(_CORRECTIONS):
            instance = self.instance.with_values({self.begins: initial})
            reached = self._rest(instance, 0.0)
            if abs(reached - target) <= _TOLERANCE * target:
                break
            corrected = initial * target / reached
            if abs(self._rest(instance.with_values({self.begins: corrected}), 0.0) - reached) <= _TOLERANCE * target:
                break  # a leak determines the steady state
            initial = corrected
        return instance

    def _unreachable(self, target: float, reached: float) -> SimulationError:
        return SimulationError(Note("plant.not_held", self.measurement, wanted=target, reached=reached))

    def _rest(self, instance: Instance, command: float) -> float:
        return steady_state(instance, self._inputs(command)).y[self.measurement]

    def _inputs(self, command: float) -> dict[str, float]:
        values = {"command": command, "fill_command": max(command, 0.0), "vent_command": max(-command, 0.0)}
        return {target: values[output] for output, targets in self.commands.items() for target in targets}


def point_label(plant: Plant, value: float, branch: str) -> str:
    """Return a label of an operating point and a side, such as `2 bar, fill`.

    `branch` is the side of the command.
    """
    return f"{'{value:.4g} {unit}'.format(**plant.readable_value(value))}, {branch}"

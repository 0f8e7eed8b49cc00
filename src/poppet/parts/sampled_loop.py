"""What all sampled controllers share: a sensor, a clock, limits, and commands for two valves or one."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.symbolic import maximum, where
from poppet.parts.electronics import SHORTEST_LAG, SHORTEST_SAMPLE, FirstOrderSensor
from poppet.parts.fields import NumberLike, group, number, option
from poppet.parts.part import (
    Controller,
    ControlOutputs,
    DiscreteState,
    Input,
    Quantities,
    Scope,
    State,
    Surroundings,
    Timer,
    advance_clock,
)
from poppet.parts.quantities import (
    COMMANDS,
    OPENING,
    QUANTITIES,
    as_setpoint,
    command_of,
    of_openings,
    quantity_of,
)  # fmt: skip

AT_ONCE, NEXT_SAMPLE = "at_once", "next_sample"


@dataclass(frozen=True)
class SampledLoop(Controller):
    """A controller that samples a quantity and commands a filling and a venting valve, or an inner loop.

    Parameters
    ----------
    setpoint : number
        Without a signal [Pa], or in the unit of the quantity.
    sample_time : number
        Sample time [s].
    acts : str
        `at_once` (default): a command follows its sample without delay; `next_sample`: it comes one sample later.
    sensor : group
        lag, offset.
    fill_limit, vent_limit : number
        Greatest commands of the two valves, 0..1.
    """

    measured: ClassVar[tuple[str, ...]] = ("measurement",)
    internal_outputs: ClassVar[tuple[str, ...]] = (
        "fill_command",
        "vent_command",
        *(f"sensor_{name}" for name in QUANTITIES),
    )

    setpoint: NumberLike = number(
        "Pa", "0 bar g", doc="setpoint", kind="pressure", low=0.0, note="no pressure", varies=as_setpoint
    )
    sample_time: NumberLike = number("s", "1 ms", doc="sample time", low=SHORTEST_SAMPLE)
    acts: str = option(AT_ONCE, NEXT_SAMPLE, doc="time at which a command follows its sample")
    sensor: Any = group(FirstOrderSensor, doc="the sensor")
    fill_limit: NumberLike = number(
        "1", 1.0, doc="greatest command to fill", low=0.0, high=1.0, note="fully open", varies=of_openings
    )
    vent_limit: NumberLike = number(
        "1", 1.0, doc="greatest command to vent", low=0.0, high=1.0, note="fully open", varies=of_openings
    )

    @property
    def controls(self) -> str:
        """Name of the quantity that is measured."""
        return quantity_of(self)

    @property
    def is_of_openings(self) -> bool:
        """True when the command opens valves; else it is the setpoint of another loop."""
        return command_of(self) == OPENING

    @property
    def unit(self) -> str:
        """SI unit of the quantity."""
        return QUANTITIES[self.controls].unit

    @property
    def command_unit(self) -> str:
        """SI unit of the command."""
        return COMMANDS[command_of(self)].unit

    @property
    def _shown(self) -> str:
        """Name of what the sensor has come to."""
        return f"sensor_{self.controls}"

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        # Without a connection it measures the open air.
        air = {"pressure": ambient.pressure, "temperature": ambient.temperature}
        return super().parameters(ambient) | {"measurement": air.get(self.controls, 0.0)}

    @abstractmethod
    def compute_command(self, scope: Scope, measured: Any) -> tuple[Any, Any, dict[str, Any]]:
        """Command (positive fills, negative vents), opening of the venting valve 0..1, and new memory."""

    @abstractmethod
    def law_memory(self) -> tuple[DiscreteState, ...]:
        """Memory beside the commands and the clock."""

    @abstractmethod
    def law_outputs(self, scope: Scope) -> Quantities:
        """Outputs beside the commands and what the sensor shows."""

    def states(self) -> tuple[State, ...]:
        of = QUANTITIES[self.controls]
        return (State(self._shown, of.unit, of.usual, floor=of.floor),)

    def memory(self) -> tuple[DiscreteState, ...]:
        names = ("command", "vent_command") if self.is_of_openings else ("command",)
        waiting = [f"next_{name}" for name in names] if self.acts == NEXT_SAMPLE else []
        commands = (DiscreteState(name, self.command_unit) for name in (*names, *waiting))
        return *commands, DiscreteState("sample_count", "1"), *self.law_memory()

    def timers(self) -> tuple[Timer, ...]:
        return (Timer("sample"),)

    def inputs(self) -> tuple[Input, ...]:
        of = QUANTITIES[self.controls]
        return tuple(Input(name, of.unit, name, kind=of.kind, low=of.low) for name in ("setpoint", "measurement"))

    def sensors(self) -> dict[str, tuple[str, str]]:
        return {self._shown: ("measurement", "sensor")}

    def start(self, scope: Scope) -> dict[str, Any]:
        remembered = {each.name: 0.0 for each in self.memory()}
        return remembered | {self._shown: scope.inputs["measurement"], "sample": 0.0}

    def control(self, scope: Scope) -> ControlOutputs:
        command = scope.memory["command"]
        outputs: Quantities = {"command": (command, self.command_unit)}
        if self.is_of_openings:
            outputs["fill_command"] = (maximum(command, 0.0), "1")
            outputs["vent_command"] = (scope.memory["vent_command"], "1")
        outputs |= {self._shown: (self._sensed(scope), self.unit), **self.law_outputs(scope)}
        shown = scope.states[self._shown]
        lag = maximum(scope["sensor.lag"], SHORTEST_LAG)
        # Without a lag the state is not used; it rests, so that it costs no steps.
        rate = where(scope["sensor.lag"] > 0.0, (scope.inputs["measurement"] - shown) / lag, 0.0)
        return ControlOutputs(outputs, {self._shown: rate})

    def _sensed(self, scope: Scope) -> Any:
        """What the sensor has come to, without its offset."""
        return where(scope["sensor.lag"] > 0.0, scope.states[self._shown], scope.inputs["measurement"])

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        # The offset is an error of the sensor: the controller sees it, a recording shows the quantity itself.
        command, vent, new = self.compute_command(scope, self._sensed(scope) + scope["sensor.offset"])
        given = {"command": command} | ({"vent_command": vent} if self.is_of_openings else {})
        if self.acts == NEXT_SAMPLE:
            new |= {f"next_{name}": value for name, value in given.items()}
            given = {name: scope.memory[f"next_{name}"] for name in given}
        return new | given | advance_clock(scope, timer, scope["sample_time"])


def is_first(scope: Scope) -> Any:
    """True at the first sample of a run, which has none before it."""
    return scope.memory["sample_count"] < 0.5

"""What all sampled pressure controllers share: a sensor, a clock, limits, and commands for two valves or one."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.ground.symbolic import maximum, where
from poppet.parts.electronics import SHORTEST_LAG, SHORTEST_SAMPLE, Sensor
from poppet.parts.fields import NumberLike, group, number, option
from poppet.parts.part import Control, Controller, Input, Memory, Quantities, Scope, State, Surroundings, Timer, ticked

AT_ONCE, NEXT_SAMPLE = "at_once", "next_sample"


@dataclass(frozen=True)
class PressureLoop(Controller):
    """A controller that samples a pressure and commands a filling and a venting valve.

    Parameters
    ----------
    setpoint : number
        Without a signal [Pa].
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
    inside: ClassVar[tuple[str, ...]] = ("fill_command", "vent_command", "sensor_pressure")

    setpoint: NumberLike = number("Pa", "0 bar g", doc="setpoint", kind="pressure", low=0.0, note="no pressure")
    sample_time: NumberLike = number("s", "1 ms", doc="sample time", low=SHORTEST_SAMPLE)
    acts: str = option(AT_ONCE, NEXT_SAMPLE, doc="time at which a command follows its sample")
    sensor: Any = group(Sensor, doc="the pressure sensor")
    fill_limit: NumberLike = number("1", 1.0, doc="greatest command to fill", low=0.0, high=1.0, note="fully open")
    vent_limit: NumberLike = number("1", 1.0, doc="greatest command to vent", low=0.0, high=1.0, note="fully open")

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        # Without a connection it measures the open air.
        return super().parameters(ambient) | {"measurement": ambient.pressure}

    @abstractmethod
    def sampled(self, scope: Scope, pressure: Any) -> tuple[Any, Any, dict[str, Any]]:
        """Command (positive fills, negative vents), opening of the venting valve 0..1, and new memory."""

    @abstractmethod
    def own_memory(self) -> tuple[Memory, ...]:
        """Memory beside the commands and the clock."""

    @abstractmethod
    def own_outputs(self, scope: Scope) -> Quantities:
        """Outputs beside the commands and the sensor's pressure."""

    def states(self) -> tuple[State, ...]:
        return (State("sensor_pressure", "Pa", 1e5),)

    def memory(self) -> tuple[Memory, ...]:
        waiting = ("next_command", "next_vent_command") if self.acts == NEXT_SAMPLE else ()
        names = ("command", "vent_command", *waiting, "sample_count")
        return *(Memory(name, "1") for name in names), *self.own_memory()

    def timers(self) -> tuple[Timer, ...]:
        return (Timer("sample"),)

    def inputs(self) -> tuple[Input, ...]:
        return (
            Input("setpoint", "Pa", "setpoint", kind="pressure", low=0.0),
            Input("measurement", "Pa", "measurement", kind="pressure", low=0.0),
        )

    def start(self, scope: Scope) -> dict[str, Any]:
        remembered = {each.name: 0.0 for each in self.memory()}
        return remembered | {"sensor_pressure": scope.inputs["measurement"], "sample": 0.0}

    def control(self, scope: Scope) -> Control:
        command = scope.memory["command"]
        outputs: Quantities = {
            "command": (command, "1"),
            "fill_command": (maximum(command, 0.0), "1"),
            "vent_command": (scope.memory["vent_command"], "1"),
            "sensor_pressure": (self._sensed(scope), "Pa"),
            **self.own_outputs(scope),
        }
        shown = scope.states["sensor_pressure"]
        lag = maximum(scope["sensor.lag"], SHORTEST_LAG)
        # Without a lag the state is not used; it rests, so that it costs no steps.
        rate = where(scope["sensor.lag"] > 0.0, (scope.inputs["measurement"] - shown) / lag, 0.0)
        return Control(outputs, {"sensor_pressure": rate})

    def _sensed(self, scope: Scope) -> Any:
        """What the sensor has come to, without its offset."""
        return where(scope["sensor.lag"] > 0.0, scope.states["sensor_pressure"], scope.inputs["measurement"])

    def at_instant(self, timer: str, scope: Scope) -> dict[str, Any]:
        # The offset is an error of the sensor: the controller sees it, a recording shows the pressure itself.
        command, vent, new = self.sampled(scope, self._sensed(scope) + scope["sensor.offset"])
        if self.acts == NEXT_SAMPLE:
            new |= {"next_command": command, "next_vent_command": vent}
            command, vent = scope.memory["next_command"], scope.memory["next_vent_command"]
        return new | {"command": command, "vent_command": vent} | ticked(scope, timer, scope["sample_time"])


def is_first(scope: Scope) -> Any:
    """True at the first sample of a run, which has none before it."""
    return scope.memory["sample_count"] < 0.5

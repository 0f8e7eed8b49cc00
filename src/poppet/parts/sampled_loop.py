"""Sampled controllers: sensor, clock, limits, and commands for one or two valves."""

from __future__ import annotations

from abc import abstractmethod
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.core.symbolic import maximum, where
from poppet.parts.electronics import MIN_LAG, MIN_SAMPLE_TIME, FirstOrderSensor
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
    command_of,
    command_properties,
    opening_properties,
    quantity_of,
    setpoint_properties,
)  # fmt: skip
from poppet.parts.safe_state import FAULT_INPUT, FAULT_MEMORY, NEVER_VALID, fault_state

AT_ONCE, NEXT_SAMPLE = "at_once", "next_sample"


@dataclass(frozen=True)
class SampledLoop(Controller):
    """Base class of sampled controllers that control one measured quantity.

    The command opens a fill and a vent valve, or it is the setpoint of an inner controller. With the option `acts =
    "next_sample"`, a command acts one sample later than the measurement from which it was computed.
    """

    measured: ClassVar[tuple[str, ...]] = ("measurement",)
    internal_outputs: ClassVar[tuple[str, ...]] = (
        "fill_command", "vent_command", "input_fault", *(f"sensor_{name}" for name in QUANTITIES)
    )  # fmt: skip

    setpoint: NumberLike = number(
        "Pa", "0 bar g", doc="setpoint without a signal", kind="pressure", low=0.0, note="no pressure",
        varies=setpoint_properties,
    )  # fmt: skip
    sample_time: NumberLike = number("s", "1 ms", doc="sample time", low=MIN_SAMPLE_TIME)
    acts: str = option(AT_ONCE, NEXT_SAMPLE, doc="time at which a command acts")
    sensor: Any = group(FirstOrderSensor, doc="sensor")
    fill_limit: NumberLike = number(
        "1", 1.0, doc="limit of the fill command", low=0.0, high=1.0, note="fully open", varies=opening_properties
    )
    vent_limit: NumberLike = number(
        "1", 1.0, doc="limit of the vent command", low=0.0, high=1.0, note="fully open", varies=opening_properties
    )
    fault_time: NumberLike = number("s", "0.1 s", doc="time from an invalid input to the safe command", low=0.0)
    safe_command: NumberLike = number(
        "1",
        0.0,
        doc="command after an invalid input",
        low=-1.0,
        high=1.0,
        note="valves closed",
        varies=command_properties,
    )

    @property
    def controls(self) -> str:
        """Name of the measured quantity, for example `pressure`."""
        return quantity_of(self)

    @property
    def is_of_openings(self) -> bool:
        """True if the command opens valves.

        If False, the command is the setpoint of another controller.
        """
        return command_of(self) == OPENING

    @property
    def unit(self) -> str:
        """SI unit of the measured quantity."""
        return QUANTITIES[self.controls].unit

    @property
    def command_unit(self) -> str:
        """SI unit of the command."""
        return COMMANDS[command_of(self)].unit

    @property
    def _sensor_state(self) -> str:
        """Name of the state with the sensor reading, which lags behind the measured quantity.

        The output of the circuit with the sensor reading has the same name.
        """
        return f"sensor_{self.controls}"

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        # Without a connection it measures the ambient.
        defaults = {"pressure": ambient.pressure, "temperature": ambient.temperature}
        return super().parameters(ambient) | {"measurement": defaults.get(self.controls, 0.0)}

    @abstractmethod
    def compute_command(self, scope: Scope, measured: Any, is_safe: Any) -> tuple[Any, Any, dict[str, Any]]:
        """Return the command, the opening of the vent valve, and the new discrete states.

        `measured` is the sensor reading at this sample instant in SI units. If the command opens valves, a positive
        command is the opening of the fill valve, from 0 to 1. Otherwise the opening of the vent valve is None. If
        `is_safe` is 1, the command is the safe command.
        """

    @abstractmethod
    def law_memory(self) -> tuple[DiscreteState, ...]:
        """Return the declarations of the discrete states of the control law.

        The states of commands and clock, which all sampled controllers have, are not included.
        """

    @abstractmethod
    def law_outputs(self, scope: Scope) -> Quantities:
        """Return the outputs of the control law, such as the integral.

        The outputs of commands and sensor, which all sampled controllers have, are not included.
        """

    def states(self) -> tuple[State, ...]:
        measured = QUANTITIES[self.controls]
        return (State(self._sensor_state, measured.unit, measured.usual, floor=measured.floor),)

    def memory(self) -> tuple[DiscreteState, ...]:
        names = ("command", "vent_command") if self.is_of_openings else ("command",)
        delayed = [f"next_{name}" for name in names] if self.acts == NEXT_SAMPLE else []
        commands = (DiscreteState(name, self.command_unit) for name in (*names, *delayed))
        return *commands, DiscreteState("sample_count", "1"), *FAULT_MEMORY, *self.law_memory()

    def timers(self) -> tuple[Timer, ...]:
        return (Timer("sample"),)

    def inputs(self) -> tuple[Input, ...]:
        measured = QUANTITIES[self.controls]
        options: dict[str, Any] = {"kind": measured.kind, "low": measured.low}
        setpoint = Input("setpoint", measured.unit, "setpoint", is_command=True, **options)
        return setpoint, Input("measurement", measured.unit, "measurement", **options), FAULT_INPUT

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        return dict.fromkeys(("fill_command", "vent_command"), (0.0, 1.0)) | {"command": ("-vent_limit", "fill_limit")}

    def sensors(self) -> dict[str, tuple[str, str]]:
        return {self._sensor_state: ("measurement", "sensor")}

    def start(self, scope: Scope) -> dict[str, Any]:
        discrete = {state.name: 0.0 for state in self.memory()} | {"faulty_samples": NEVER_VALID}
        return discrete | {self._sensor_state: scope.inputs["measurement"], "sample": 0.0}

    def control(self, scope: Scope) -> ControlOutputs:
        command = scope.memory["command"]
        outputs: Quantities = {"command": (command, self.command_unit)}
        if self.is_of_openings:
            outputs["fill_command"] = (maximum(command, 0.0), "1")
            outputs["vent_command"] = (scope.memory["vent_command"], "1")
        outputs |= {self._sensor_state: (self._sensed(scope), self.unit), **self.law_outputs(scope)}
        sensor_value = scope.states[self._sensor_state]
        lag = maximum(scope["sensor.lag"], MIN_LAG)
        # Without a lag the state is not used. It is constant and causes no steps.
        rate = where(scope["sensor.lag"] > 0.0, (scope.inputs["measurement"] - sensor_value) / lag, 0.0)
        return ControlOutputs(outputs, {self._sensor_state: rate})

    def _sensed(self, scope: Scope) -> Any:
        """Return the measured quantity with the lag of the sensor, but without its offset.

        The value is in SI units.
        """
        return where(scope["sensor.lag"] > 0.0, scope.states[self._sensor_state], scope.inputs["measurement"])

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        # The offset is an error of the sensor: it acts on the controller and is not in the output of the sensor.
        is_safe, fault = fault_state(scope, scope["sample_time"])
        measured = self._sensed(scope) + scope["sensor.offset"]
        command, vent, discrete = self.compute_command(scope, measured, is_safe)
        commands = {"command": command} | ({"vent_command": vent} if self.is_of_openings else {})
        if self.acts == NEXT_SAMPLE:
            discrete |= {f"next_{name}": value for name, value in commands.items()}
            # The safe command does not wait.
            commands = {k: where(is_safe > 0.5, value, scope.memory[f"next_{k}"]) for k, value in commands.items()}
        return discrete | fault | commands | advance_clock(scope, timer, scope["sample_time"])


def is_first(scope: Scope) -> Any:
    """Return True at the first sample instant of a run.

    For a symbolic scope, the result is a symbolic condition.
    """
    return scope.memory["sample_count"] < 0.5

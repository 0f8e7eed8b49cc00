"""Functions of spool valves with five ports: their inputs, switching and centre positions."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import cache
from types import SimpleNamespace
from typing import Any, NamedTuple

from poppet.core.provenance import Number
from poppet.core.symbolic import clip, where
from poppet.parts.electronics import SCALES
from poppet.parts.fields import NumberSpec, default_number
from poppet.parts.two_positions import END_GAIN, switching_target

ON, OFF = 0.75, 0.25
"""Signals from which an actuation counts as set, and up to which it counts as not set [1].

Between both, it keeps its state, so noise does not switch the spool repeatedly."""


PILOTS = ("pilot_a", "pilot_b")
"""Pilot ports, whose pressure moves the spool to a and to b."""


class SpoolFunction(NamedTuple):
    """Inputs and positions of a spool valve."""

    commands: tuple[str, ...]
    pilots: tuple[str, ...] = PILOTS  # permitted pilot ports
    n_positions: int = 3  # two or three
    open_at_centre: str = ""  # edges that are open at the centre: "supply", "exhaust" or none


PROPORTIONAL, MONOSTABLE, BISTABLE = "proportional", "5/2 monostable", "5/2 bistable"
_BOTH = ("command_a", "command_b")
FUNCTIONS: Mapping[str, SpoolFunction] = {
    PROPORTIONAL: SpoolFunction(("command",), ()),
    MONOSTABLE: SpoolFunction(("command",), ("pilot_a",), n_positions=2),
    BISTABLE: SpoolFunction(_BOTH, n_positions=2),
    "5/3 closed": SpoolFunction(_BOTH),
    "5/3 exhausted": SpoolFunction(_BOTH, open_at_centre="exhaust"),
    "5/3 pressurised": SpoolFunction(_BOTH, open_at_centre="supply"),
}
_TWO_POSITIONS = tuple(name for name, function in FUNCTIONS.items() if function.n_positions == 2)
_OPEN_CENTRE = tuple(name for name, function in FUNCTIONS.items() if function.open_at_centre)
FIELDS: Mapping[str, tuple[str, ...]] = {
    **dict.fromkeys(("dynamics", "setpoint_type", "lag"), (PROPORTIONAL,)),
    **dict.fromkeys(("natural_frequency", "damping", "hysteresis"), (PROPORTIONAL,)),
    "command": (PROPORTIONAL, MONOSTABLE),
    **{name: tuple(key for key, function in FUNCTIONS.items() if name in function.commands) for name in _BOTH},
    **dict.fromkeys(("overlap", "exhaust_overlap"), (PROPORTIONAL, *_TWO_POSITIONS)),
    **dict.fromkeys(("centre_conductance", "centre_ratio"), _OPEN_CENTRE),
    **{name: tuple(key for key, function in FUNCTIONS.items() if name in function.pilots) for name in PILOTS},
}  # fmt: skip
"""Mapping from each field that only some functions use to these functions."""


def function_of(part: Any) -> SpoolFunction:
    """Return the function of a spool valve; an invalid one counts as proportional."""
    return FUNCTIONS.get(part.function, FUNCTIONS[PROPORTIONAL])


# --- Changes of declarations ---

UNUSED: Mapping[str, Any] = {"default": None, "optional": True}
SETPOINTS = {name: scale for name, scale in SCALES.items() if name != "pressure"}
"""Unit of the command by type of setpoint, and its values at the positions -1 and 1 of the spool."""


def used_field(name: str) -> Callable[[Any], Mapping[str, Any]]:
    """Return a callable that removes the default of a field if the selected valve function does not use the field.

    `name` is the name of the field in `FIELDS`. The callable is a value of `NumberSpec.varies`.
    """
    return lambda part: {} if part.function in FIELDS[name] else UNUSED


def command_properties(part: Any) -> Mapping[str, Any]:
    """Return the limits, the unit and the default of the field `command` that depend on the options of a valve."""
    if part.function not in FIELDS["command"]:
        return UNUSED
    if part.function != PROPORTIONAL:
        return {"low": 0.0, "note": "off by default"}
    if part.setpoint_type not in SETPOINTS:
        return {}
    unit, low, high = SETPOINTS[part.setpoint_type]
    return {"unit": unit, "low": low, "high": high, "default": 0.5 * (low + high)}


def time_properties(part: Any) -> Mapping[str, Any]:
    """Return the changes of the field `switching_time`, which has no default for a proportional valve."""
    return UNUSED if function_of(part) is FUNCTIONS[PROPORTIONAL] else {}


def pilot_properties(part: Any) -> Mapping[str, Any]:
    """Return the changes of a field that only a valve with a pilot port uses."""
    return UNUSED if part.pilot_a is None and part.pilot_b is None else {}


@cache
def possible_defaults(name: str, spec: NumberSpec) -> frozenset[Number | None]:
    """Return the defaults of the field `name` of a spool valve for all options."""
    options = (
        SimpleNamespace(function=function, setpoint_type=setpoint_type, pilot_a="", pilot_b=None)
        for function in FUNCTIONS
        for setpoint_type in ("command", *SETPOINTS)
    )
    return frozenset(default_number(name, spec.within(option)) for option in options)


# --- Positions ---


def position_of(command: Any, setpoint_type: str) -> Any:
    """Return the position of a proportional spool for a constant command in the unit of `setpoint_type`."""
    if setpoint_type not in SETPOINTS:
        return command
    _, low, high = SETPOINTS[setpoint_type]
    return (command - 0.5 * (low + high)) / (0.5 * (high - low))


def edge_opening(function: SpoolFunction, edge: str, position: Any, overlap: Any) -> Any:
    """Return the opening of a metering edge between 0 and 1.

    `edge` is "supply" or "exhaust", and `position` the position of the spool in the direction in which the edge opens.
    `overlap` is the position at which the edge starts to open, if the function of the valve does not determine it.
    """
    start, end = overlap, 1.0
    if function.open_at_centre:
        # An edge that is open at the centre closes over the first half of the stroke, before the others open.
        start, end = (-0.5, 0.0) if edge == function.open_at_centre else (0.5, 1.0)
    return clip((position - start) / (end - start), 0.0, 1.0)


def pilot_signal(pressure: Any, switching_pressure: Any, hysteresis: Any) -> Any:
    """Return the signal of a pneumatic pilot.

    It is `ON` at the switching pressure, and `OFF` at a pressure that is lower by `hysteresis` [Pa].
    """
    return clip(ON + (ON - OFF) * (pressure - switching_pressure) / hysteresis, 0.0, 1.0)


def resting_position(function: SpoolFunction, signal_a: Any, signal_b: Any) -> Any:
    """Return the end position of a switched spool for constant signals.

    The result is -1, 0 or 1. A bistable valve without a set signal is in the position -1.
    """
    difference = signal_a - signal_b
    if function.n_positions == 2:
        return where(difference >= ON, 1.0, -1.0)
    return where(difference >= ON, 1.0, where(difference <= -ON, -1.0, 0.0))


def switched_speed(
    function: SpoolFunction, position: Any, signal_a: Any, signal_b: Any, switching_time: Any, closing_time: Any
) -> Any:
    """Return the speed of a switched spool [1/s].

    With two positions, the spool moves from -1 to 1 in `switching_time`, and back in `closing_time` [s]. With three
    positions, it moves from the centre to an end in `switching_time`, and back to the centre in `closing_time`.
    """

    # The drive of an element with a spring is +/-1 at the signals ON and OFF.
    def spring_drive(signal: Any) -> Any:
        return (2.0 * signal - (ON + OFF)) / (ON - OFF)

    if function.n_positions == 2:
        element = 0.5 * (1.0 + position)
        has_spring = len(function.commands) == 1
        drive = spring_drive(signal_a) if has_spring else (signal_a - signal_b) / ON
        error, travel = switching_target(element, drive) - element, 2.0
        opening_time, return_time = switching_time, closing_time
    else:
        difference = signal_a - signal_b
        target_a = switching_target(clip(position, 0.0, 1.0), spring_drive(difference))
        target_b = switching_target(clip(-position, 0.0, 1.0), spring_drive(-difference))
        error, travel = target_a - target_b - position, 1.0
        opening_time = where(position < 0.0, closing_time, switching_time)
        return_time = where(position > 0.0, closing_time, switching_time)
    speed = clip(END_GAIN * error, -1.0, 1.0)
    return travel * (clip(speed, 0.0, 1.0) / opening_time + clip(speed, -1.0, 0.0) / return_time)

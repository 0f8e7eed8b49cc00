"""What a controller may measure and command, and how its numbers follow from that choice.

Fields of a controller are declared for a pressure that openings control. Where `quantity` and `command_quantity` say
something else, the functions below say what changes in a declaration: they are its `varies`.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from poppet.core.units import Kind


@dataclass(frozen=True)
class ControlledQuantity:
    """A quantity: its SI unit and kind, what it is without a word, its least value, and its usual size."""

    unit: str
    usual: float
    kind: Kind = "plain"
    default: str | float = 0.0
    low: float = -math.inf
    floor: float = 0.1  # tolerance of a sensor per relative tolerance and usual size; that of a gas is tighter


QUANTITIES = {
    "pressure": ControlledQuantity("Pa", 1e5, "pressure", "0 bar g", 0.0, 1e-3),
    "position": ControlledQuantity("m", 0.1),
    "angle": ControlledQuantity("rad", 0.1),
    "velocity": ControlledQuantity("m/s", 1.0),
    "angular_velocity": ControlledQuantity("rad/s", 1.0),
    "force": ControlledQuantity("N", 100.0),
    "torque": ControlledQuantity("N m", 1.0),
    "temperature": ControlledQuantity("K", 300.0, "temperature", "20 degC", 0.0, 1e-3),
    "mass_flow": ControlledQuantity("kg/s", 1e-2, "mass_flow"),
}
OPENING = "opening"
COMMANDS = {OPENING: ControlledQuantity("1", 1.0), **QUANTITIES}
"""What a command may be: the opening of valves, -1 ... 1, or the setpoint of a controller further in."""


def quantity_of(part: Any) -> str:
    """Name of what a controller measures."""
    name = getattr(part, "quantity", "pressure")
    return name if name in QUANTITIES else "pressure"  # a name that is none is a mistake of its own field


def command_of(part: Any) -> str:
    """Name of what a controller commands."""
    name = getattr(part, "command_quantity", OPENING)
    return name if name in COMMANDS else OPENING


def gain_unit(quantity: str, command: str) -> str:
    """Unit of a gain.

    Examples
    --------
    >>> gain_unit("pressure", "opening"), gain_unit("position", "force"), gain_unit("velocity", "pressure")
    ('1/Pa', 'N/m', 'Pa/(m/s)')
    """
    unit = QUANTITIES[quantity].unit
    return f"{COMMANDS[command].unit}/" + (f"({unit})" if set(" /") & set(unit) else unit)


# --- What changes in a declaration ---


def as_setpoint(part: Any) -> dict[str, Any]:
    """A value of what is measured."""
    name = quantity_of(part)
    if name == "pressure":
        return {}
    of = QUANTITIES[name]
    return {"unit": of.unit, "kind": of.kind, "default": of.default, "low": of.low, "note": "without a signal"}


def as_difference(part: Any) -> dict[str, Any]:
    """A difference of what is measured."""
    return {"unit": QUANTITIES[quantity_of(part)].unit}


def as_gain(part: Any) -> dict[str, Any]:
    """Command per error."""
    return {"unit": gain_unit(quantity_of(part), command_of(part))}


def as_command(part: Any) -> dict[str, Any]:
    """A value of the command."""
    name = command_of(part)
    if name == OPENING:
        return {}
    of = COMMANDS[name]
    return {"unit": of.unit, "kind": of.kind, "default": of.default, "low": of.low, "high": math.inf}


def as_limit(part: Any) -> dict[str, Any]:
    """A limit of the command; openings have limits of their own."""
    return {key: value for key, value in as_command(part).items() if key != "default"}


def as_command_change(part: Any) -> dict[str, Any]:
    """A change of the command."""
    return {"unit": COMMANDS[command_of(part)].unit}


def of_openings(part: Any) -> dict[str, Any]:
    """A number that only commands of openings have."""
    return {} if command_of(part) == OPENING else {"default": None, "optional": True}

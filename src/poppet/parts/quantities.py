"""Measured and commanded quantities of controllers.

The fields of a controller are declared for a pressure that openings control. For other options `quantity` and
`command_quantity`, the functions below return the changes of a declaration (`NumberSpec.varies`).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any

from poppet.core.units import Kind


@dataclass(frozen=True)
class ControlledQuantity:
    """Properties of a physical quantity that a controller can measure or command.

    They are the SI unit, the typical size (`usual`), the kind of value (such as an absolute pressure), the default, the
    lower limit, and a factor (`floor`) of the absolute tolerance of a sensor for the quantity.
    """

    unit: str
    usual: float
    kind: Kind = "plain"
    default: str | float = 0.0
    low: float = -math.inf
    floor: float = 0.1  # tolerance of a sensor per relative tolerance and nominal size; smaller for a gas


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
"""Commanded quantities: the opening of valves, -1 ... 1, or the setpoint of an inner controller."""


def quantity_of(part: Any) -> str:
    """Return the name of the quantity that the controller `part` measures, for example `pressure`."""
    name = getattr(part, "quantity", "pressure")
    return name if name in QUANTITIES else "pressure"  # the field itself reports an invalid name


def command_of(part: Any) -> str:
    """Return the name of the quantity that the controller `part` commands, for example `opening`."""
    name = getattr(part, "command_quantity", OPENING)
    return name if name in COMMANDS else OPENING


def gain_unit(quantity: str, command: str) -> str:
    """Return the SI unit of a controller gain, which is a command divided by a measured quantity.

    Examples
    --------
    >>> gain_unit("pressure", "opening"), gain_unit("position", "force"), gain_unit("velocity", "pressure")
    ('1/Pa', 'N/m', 'Pa/(m/s)')
    """
    unit = QUANTITIES[quantity].unit
    return f"{COMMANDS[command].unit}/" + (f"({unit})" if set(" /") & set(unit) else unit)


# --- Changes of declarations ---


def as_setpoint(part: Any) -> dict[str, Any]:
    """Return unit, kind, default and limits of the setpoint field of the controller `part`.

    They override the declaration of the field, which is that of a pressure. The result is empty for a pressure.
    """
    name = quantity_of(part)
    if name == "pressure":
        return {}
    measured = QUANTITIES[name]
    limits = {"default": measured.default, "low": measured.low, "note": "without a signal"}
    return {"unit": measured.unit, "kind": measured.kind, **limits}


def as_difference(part: Any) -> dict[str, Any]:
    """Return the unit of a field of the controller `part` for a difference of measured values.

    An example is a dead band. The result overrides the unit in the declaration of the field.
    """
    return {"unit": QUANTITIES[quantity_of(part)].unit}


def as_gain(part: Any) -> dict[str, Any]:
    """Return the unit of the gain (command per error) of the controller `part`.

    The result overrides the unit in the declaration of the field.
    """
    return {"unit": gain_unit(quantity_of(part), command_of(part))}


def as_command(part: Any) -> dict[str, Any]:
    """Return unit, kind, default and limits of a field of the controller `part` for a command.

    They override the declaration of the field, which is that of an opening. The result is empty for an opening.
    """
    name = command_of(part)
    if name == OPENING:
        return {}
    command = COMMANDS[name]
    limits = {"default": command.default, "low": command.low, "high": math.inf}
    return {"unit": command.unit, "kind": command.kind, **limits}


def as_limit(part: Any) -> dict[str, Any]:
    """Return unit, kind and limits of a field of the controller `part` for a limit of its command.

    They override the declaration of the field. The result contains no default: a user must specify the limits.
    """
    return {key: value for key, value in as_command(part).items() if key != "default"}


def as_command_change(part: Any) -> dict[str, Any]:
    """Return the unit of a field of the controller `part` for a difference of commands.

    An example is the initial integral. The result overrides the unit in the declaration of the field.
    """
    return {"unit": COMMANDS[command_of(part)].unit}


def of_openings(part: Any) -> dict[str, Any]:
    """Return changes that make a field optional if the controller `part` does not command an opening.

    The field, such as the largest opening, then has no default and no effect. The result is empty for an opening.
    """
    return {} if command_of(part) == OPENING else {"default": None, "optional": True}

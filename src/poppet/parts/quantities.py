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


def setpoint_properties(part: Any) -> dict[str, Any]:
    """Return the properties of the field for the setpoint that depend on the measured quantity.

    They are unit, kind of value, default and limits, and override the declaration of the field, which is valid for a
    pressure. `part` is the controller. The result is empty if it measures a pressure.
    """
    name = quantity_of(part)
    if name == "pressure":
        return {}
    measured = QUANTITIES[name]
    limits = {"default": measured.default, "low": measured.low, "note": "without a signal"}
    return {"unit": measured.unit, "kind": measured.kind, **limits}


def difference_properties(part: Any) -> dict[str, Any]:
    """Return the unit of a field for a difference of measured values, such as a dead band.

    The result overrides the unit in the declaration of the field. `part` is the controller.
    """
    return {"unit": QUANTITIES[quantity_of(part)].unit}


def gain_properties(part: Any) -> dict[str, Any]:
    """Return the unit of the field for the gain, command per error.

    The result overrides the unit in the declaration of the field. `part` is the controller.
    """
    return {"unit": gain_unit(quantity_of(part), command_of(part))}


def command_properties(part: Any) -> dict[str, Any]:
    """Return the properties of a field for a command that depend on the commanded quantity.

    They are unit, kind of value, default and limits, and override the declaration of the field, which is valid for the
    opening of a valve. `part` is the controller. The result is empty if it commands an opening.
    """
    name = command_of(part)
    if name == OPENING:
        return {}
    command = COMMANDS[name]
    limits = {"default": command.default, "low": command.low, "high": math.inf}
    return {"unit": command.unit, "kind": command.kind, **limits}


def limit_properties(part: Any) -> dict[str, Any]:
    """Return the properties of a field for a limit of the command, such as its unit.

    They are the properties from `command_properties` without the default, because a user must specify the limits.
    `part` is the controller.
    """
    return {key: value for key, value in command_properties(part).items() if key != "default"}


def command_change_properties(part: Any) -> dict[str, Any]:
    """Return the unit of a field for a difference of commands, such as the initial integral.

    The result overrides the unit in the declaration of the field. `part` is the controller.
    """
    return {"unit": COMMANDS[command_of(part)].unit}


def opening_properties(part: Any) -> dict[str, Any]:
    """Return the properties of a field that has an effect only on commands that open valves.

    If the controller `part` commands another quantity, the field is optional and has no default. If it commands an
    opening, the result is empty.
    """
    return {} if command_of(part) == OPENING else {"default": None, "optional": True}

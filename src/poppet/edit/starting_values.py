"""Starting values of the editor, with which a new part is valid as soon as its ports are connected.

The values are typical of a small machine with a supply of 6 bar, a cylinder of 32 mm and valves of size G1/8.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from poppet.parts import KINDS
from poppet.parts.fields import GroupSpec, MemberSpec, NumberSpec, Spec, specs

NOTE = "starting value of the editor"
"""Note of each parameter that the editor assumed."""

_PASSAGE = {"sonic_conductance": "1 dm^3/(s bar)", "critical_ratio": 0.3}
_VALVE = {"sonic_conductance": "2 dm^3/(s bar)", "critical_ratio": 0.3}
_CHAMBERS = {"cap.dead_volume": "5 cm^3", "rod.dead_volume": "5 cm^3"}
_STEPS = {"off": {"next": {"on": "elapsed > 0.5 s"}}, "on": {"on": ["output"], "next": {"off": "elapsed > 0.5 s"}}}

STARTING_VALUES: dict[str, dict[str, Any]] = {
    "reservoir": {"pressure": "6 bar g"},
    "compressor": {"free_air_delivery": "120 l/min ANR", "start_pressure": "6 bar g", "stop_pressure": "8 bar g"},
    "pressure_regulator": {**_VALVE, "setpoint": "4 bar g"},
    "filter": _VALVE,
    "flow_source": {"mass_flow_rate": "50 l/min ANR"},
    "chamber": {"volume": "1 l"},
    "tube": {"length": "1 m", "bore": "4 mm"},
    "orifice": _PASSAGE,
    "flow_control_valve": {**_PASSAGE, "throttle_conductance": "0.2 dm^3/(s bar)"},
    "check_valve": _PASSAGE,
    "piloted_check_valve": _PASSAGE,
    "relief_valve": {**_PASSAGE, "set_pressure": "7 bar g"},
    "silencer": _VALVE,
    "shuttle_valve": _PASSAGE,
    "two_pressure_valve": _PASSAGE,
    "quick_exhaust_valve": _VALVE,
    "directional_valve": _VALVE,
    "spool_valve": {"function": "5/2 monostable", **_VALVE},
    "proportional_valve": {"data": "vppm_6l"},
    "main_stage": {"data": "vppm_6l", "mode": "regulator"},
    "pilot_stage": {"data": "vppm_6l"},
    "cylinder": {"bore": "32 mm", "rod_diameter": "12 mm", "stroke_length": "100 mm", **_CHAMBERS},
    "rotary_actuator": {
        "displacement": "20 cm^3/rad",
        "swivel_angle": "180 deg",
        "shaft.inertia": "0.05 kg m^2",
        "forward.dead_volume": "10 cm^3",
        "backward.dead_volume": "10 cm^3",
    },
    "gripper": {
        "bore": "20 mm",
        "jaw_stroke": "5 mm",
        "rated_force": "45 N",
        "jaws.mass": "0.2 kg",
        "cap.dead_volume": "1 cm^3",
        "rod.dead_volume": "1 cm^3",
    },
    "muscle": {"data": "dmsp_20_300"},
    "pressure_booster": {
        "pressure_ratio": 2,
        "bore": "40 mm",
        "stroke_length": "40 mm",
        "piston.mass": "0.5 kg",
        **{f"{member}.{field}": value for member in ("valve", "checks") for field, value in _PASSAGE.items()},
    },
    "vacuum_ejector": {"nozzle_conductance": "0.1 dm^3/(s bar)"},
    "suction_cup": {"diameter": "30 mm", "volume": "5 cm^3"},
    "mass": {"mass": "5 kg"},
    "joint": {"inertia": "0.03 kg m^2", "pulley_radius": "25 mm"},
    "guide": {},
    "sequence": {"outputs": ["output"], "start": "off", "steps": _STEPS},
    "switch": {"on_above": "5 bar g", "off_below": "4 bar g"},
    "pid": {"gain": "0.5 1/bar", "setpoint": "3 bar g"},
    "pressure_controller": {
        "time_constant": "0.1 s",
        "volume": "1 l",
        "supply_pressure": "6 bar g",
        "fill.sonic_conductance": "1 dm^3/(s bar)",
        "vent.sonic_conductance": "1 dm^3/(s bar)",
    },
    "electronics": {"data": "vppm_6l"},
    "inverse_muscle": {"data": "dmsp_20_300"},
    "antagonist": {"data": "dmsp_20_300", "pulley_radius": "25 mm"},
    "fmu": {"path": "model.fmu"},
}
"""Values by kind and address of the field; kinds of plugins have none."""


def starting_fields(kind: str) -> dict[str, Any]:
    """Return the fields of a new part, for the operation `add`.

    Each parameter has the source "assumed" and a note; options, lists and texts are plain.

    Parameters
    ----------
    kind : str
        Kind of the part.

    Examples
    --------
    >>> starting_fields("chamber")
    {'volume': {'value': '1 l', 'source': 'assumed', 'note': 'starting value of the editor'}}
    """
    values = STARTING_VALUES.get(kind, {})
    declared = specs(KINDS[kind])
    return {field: _assumed(value) if _is_number(declared, field) else value for field, value in values.items()}


def _is_number(declared: Mapping[str, Spec], field: str) -> bool:
    name, _, rest = field.partition(".")
    match declared[name]:
        case MemberSpec(part=inner) | GroupSpec(group=inner):
            return _is_number(specs(inner), rest)
        case spec:
            return isinstance(spec, NumberSpec)


def _assumed(value: Any) -> dict[str, Any]:
    return {"value": value, "source": "assumed", "note": NOTE}

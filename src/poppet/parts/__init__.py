"""The parts of a circuit, and the register by which a circuit file names them: a module is read when it is needed."""

from __future__ import annotations

import importlib
from collections import UserDict
from typing import TYPE_CHECKING, Any

from poppet.parts.part import Part, Passage, Store

if TYPE_CHECKING:
    from poppet.parts.bodies import BodyFriction, BodyStop, Guide, Joint, JointFriction, JointStop, Mass
    from poppet.parts.chamber import Chamber
    from poppet.parts.cylinder import Cylinder
    from poppet.parts.electronics import Electronics
    from poppet.parts.flow_source import FlowSource
    from poppet.parts.main_stage import Contact, Exhaust, Friction, MainStage, Spring, Stop
    from poppet.parts.muscle import Muscle
    from poppet.parts.orifice import Orifice
    from poppet.parts.pid import PID
    from poppet.parts.pilot_stage import PilotStage
    from poppet.parts.pressure_controller import PressureController
    from poppet.parts.proportional_valve import ProportionalValve
    from poppet.parts.reservoir import Reservoir
    from poppet.parts.solenoid import Solenoid
    from poppet.parts.tube import Tube
    from poppet.parts.valves import CheckValve, DirectionalValve, ReliefValve, Silencer


class _Register(UserDict[str, Any]):
    """Kind to class; one that was not asked for yet is the name of its class, which `_PLACES` has."""

    def __getitem__(self, kind: str) -> Any:
        made = super().__getitem__(kind)
        return getattr(importlib.import_module(__name__), made) if isinstance(made, str) else made


KINDS: UserDict[str, type[Part]] = _Register({
    "reservoir": "Reservoir",
    "chamber": "Chamber",
    "orifice": "Orifice",
    "flow_source": "FlowSource",
    "main_stage": "MainStage",
    "pilot_stage": "PilotStage",
    "electronics": "Electronics",
    "proportional_valve": "ProportionalValve",
    "pid": "PID",
    "pressure_controller": "PressureController",
    "check_valve": "CheckValve",
    "relief_valve": "ReliefValve",
    "directional_valve": "DirectionalValve",
    "silencer": "Silencer",
    "mass": "Mass",
    "joint": "Joint",
    "guide": "Guide",
    "cylinder": "Cylinder",
    "muscle": "Muscle",
    "tube": "Tube",
})  # fmt: skip

_MODULES = {
    "bodies": ("BodyFriction", "BodyStop", "Guide", "Joint", "JointFriction", "JointStop", "Mass"),
    "chamber": ("Chamber",),
    "cylinder": ("Cylinder",),
    "electronics": ("Electronics",),
    "flow_source": ("FlowSource",),
    "main_stage": ("Contact", "Exhaust", "Friction", "MainStage", "Spring", "Stop"),
    "muscle": ("Muscle",),
    "orifice": ("Orifice",),
    "pid": ("PID",),
    "pilot_stage": ("PilotStage",),
    "pressure_controller": ("PressureController",),
    "proportional_valve": ("ProportionalValve",),
    "reservoir": ("Reservoir",),
    "solenoid": ("Solenoid",),
    "tube": ("Tube",),
    "valves": ("CheckValve", "DirectionalValve", "ReliefValve", "Silencer"),
}
_PLACES = {name: module for module, names in _MODULES.items() for name in names}

# Literal, so that type checkers can read it.
__all__ = [
    "KINDS",
    "PID",
    "BodyFriction",
    "BodyStop",
    "Chamber",
    "CheckValve",
    "Contact",
    "Cylinder",
    "DirectionalValve",
    "Electronics",
    "Exhaust",
    "FlowSource",
    "Friction",
    "Guide",
    "Joint",
    "JointFriction",
    "JointStop",
    "MainStage",
    "Mass",
    "Muscle",
    "Orifice",
    "Part",
    "Passage",
    "PilotStage",
    "PressureController",
    "ProportionalValve",
    "ReliefValve",
    "Reservoir",
    "Silencer",
    "Solenoid",
    "Spring",
    "Stop",
    "Store",
    "Tube",
]


def __getattr__(name: str) -> Any:
    if name not in _PLACES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    made = globals()[name] = getattr(importlib.import_module(f"{__name__}.{_PLACES[name]}"), name)
    return made

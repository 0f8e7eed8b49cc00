"""The parts of a circuit, and the register by which a circuit file names them: a module is read when it is needed."""

from __future__ import annotations

import importlib
from collections import UserDict
from typing import TYPE_CHECKING, Any

from poppet.parts.part import Part, Passage, Store

if TYPE_CHECKING:
    from poppet.parts.antagonist import Antagonist, InverseMuscle
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
    from poppet.parts.spool_valve import SpoolValve
    from poppet.parts.tube import Tube
    from poppet.parts.valves import CheckValve, DirectionalValve, ReliefValve, Silencer


class _Register(UserDict[str, Any]):
    """Kind to class, which is kept by its place until it is asked for."""

    def __getitem__(self, kind: str) -> Any:
        made = super().__getitem__(kind)
        return __getattr__(made.partition(".")[2]) if isinstance(made, str) else made


KINDS: UserDict[str, type[Part]] = _Register({
    "reservoir": "reservoir.Reservoir",
    "chamber": "chamber.Chamber",
    "orifice": "orifice.Orifice",
    "flow_source": "flow_source.FlowSource",
    "main_stage": "main_stage.MainStage",
    "pilot_stage": "pilot_stage.PilotStage",
    "electronics": "electronics.Electronics",
    "proportional_valve": "proportional_valve.ProportionalValve",
    "pid": "pid.PID",
    "pressure_controller": "pressure_controller.PressureController",
    "check_valve": "valves.CheckValve",
    "relief_valve": "valves.ReliefValve",
    "directional_valve": "valves.DirectionalValve",
    "spool_valve": "spool_valve.SpoolValve",
    "silencer": "valves.Silencer",
    "mass": "bodies.Mass",
    "joint": "bodies.Joint",
    "guide": "bodies.Guide",
    "cylinder": "cylinder.Cylinder",
    "muscle": "muscle.Muscle",
    "inverse_muscle": "antagonist.InverseMuscle",
    "antagonist": "antagonist.Antagonist",
    "tube": "tube.Tube",
})  # fmt: skip

_GROUPS = {
    "bodies": ("BodyFriction", "BodyStop", "JointFriction", "JointStop"),
    "main_stage": ("Contact", "Exhaust", "Friction", "Spring", "Stop"),
    "solenoid": ("Solenoid",),
}
_MODULES = {name: module for module, names in _GROUPS.items() for name in names}
_MODULES |= {place.partition(".")[2]: place.partition(".")[0] for place in map(str, KINDS.data.values())}

# Literal, so that type checkers can read it.
__all__ = [
    "KINDS",
    "PID",
    "Antagonist",
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
    "InverseMuscle",
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
    "SpoolValve",
    "Spring",
    "Stop",
    "Store",
    "Tube",
]


def __getattr__(name: str) -> Any:
    if name not in _MODULES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f"{__name__}.{_MODULES[name]}"), name)

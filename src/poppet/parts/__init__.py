"""Parts of circuits and the registry of their kinds."""

from __future__ import annotations

import importlib
from typing import TYPE_CHECKING

from poppet.core.plugins import Registry
from poppet.parts.part import Part, Passage, Store

if TYPE_CHECKING:
    from poppet.parts.antagonist import Antagonist, InverseMuscle
    from poppet.parts.bodies import BodyFriction, BodyStop, Guide, Joint, JointFriction, JointStop, Mass
    from poppet.parts.chamber import Chamber
    from poppet.parts.cylinder import Cylinder
    from poppet.parts.electronics import Electronics
    from poppet.parts.flow_path import Orifice
    from poppet.parts.fmu import FMU
    from poppet.parts.gripper import Gripper
    from poppet.parts.logic_valves import QuickExhaustValve, ShuttleValve, TwoPressureValve
    from poppet.parts.main_stage import Contact, Exhaust, Friction, MainStage, Spring, Stop
    from poppet.parts.muscle import Muscle
    from poppet.parts.one_way_valves import FlowControlValve, PilotedCheckValve
    from poppet.parts.pid import PID
    from poppet.parts.pilot_stage import PilotStage
    from poppet.parts.pressure_booster import PressureBooster
    from poppet.parts.pressure_controller import PressureController
    from poppet.parts.proportional_valve import ProportionalValve
    from poppet.parts.rotary_actuator import RotaryActuator
    from poppet.parts.sequence import Sequence
    from poppet.parts.solenoid import Solenoid
    from poppet.parts.sources import FlowSource, Reservoir
    from poppet.parts.spool_valve import SpoolValve
    from poppet.parts.supply import Compressor, PressureRegulator
    from poppet.parts.switch import Switch
    from poppet.parts.tube import Tube
    from poppet.parts.vacuum import SuctionCup, VacuumEjector
    from poppet.parts.valves import CheckValve, DirectionalValve, Filter, ReliefValve, Silencer


KINDS: Registry[type[Part]] = Registry(
    "poppet.parts",
    {
        "reservoir": "poppet.parts.sources:Reservoir",
        "chamber": "poppet.parts.chamber:Chamber",
        "orifice": "poppet.parts.flow_path:Orifice",
        "flow_source": "poppet.parts.sources:FlowSource",
        "main_stage": "poppet.parts.main_stage:MainStage",
        "pilot_stage": "poppet.parts.pilot_stage:PilotStage",
        "electronics": "poppet.parts.electronics:Electronics",
        "proportional_valve": "poppet.parts.proportional_valve:ProportionalValve",
        "pid": "poppet.parts.pid:PID",
        "pressure_controller": "poppet.parts.pressure_controller:PressureController",
        "check_valve": "poppet.parts.valves:CheckValve",
        "relief_valve": "poppet.parts.valves:ReliefValve",
        "directional_valve": "poppet.parts.valves:DirectionalValve",
        "flow_control_valve": "poppet.parts.one_way_valves:FlowControlValve",
        "piloted_check_valve": "poppet.parts.one_way_valves:PilotedCheckValve",
        "shuttle_valve": "poppet.parts.logic_valves:ShuttleValve",
        "two_pressure_valve": "poppet.parts.logic_valves:TwoPressureValve",
        "quick_exhaust_valve": "poppet.parts.logic_valves:QuickExhaustValve",
        "spool_valve": "poppet.parts.spool_valve:SpoolValve",
        "silencer": "poppet.parts.valves:Silencer",
        "filter": "poppet.parts.valves:Filter",
        "pressure_regulator": "poppet.parts.supply:PressureRegulator",
        "compressor": "poppet.parts.supply:Compressor",
        "vacuum_ejector": "poppet.parts.vacuum:VacuumEjector",
        "suction_cup": "poppet.parts.vacuum:SuctionCup",
        "mass": "poppet.parts.bodies:Mass",
        "joint": "poppet.parts.bodies:Joint",
        "guide": "poppet.parts.bodies:Guide",
        "cylinder": "poppet.parts.cylinder:Cylinder",
        "pressure_booster": "poppet.parts.pressure_booster:PressureBooster",
        "gripper": "poppet.parts.gripper:Gripper",
        "rotary_actuator": "poppet.parts.rotary_actuator:RotaryActuator",
        "muscle": "poppet.parts.muscle:Muscle",
        "inverse_muscle": "poppet.parts.antagonist:InverseMuscle",
        "antagonist": "poppet.parts.antagonist:Antagonist",
        "tube": "poppet.parts.tube:Tube",
        "switch": "poppet.parts.switch:Switch",
        "sequence": "poppet.parts.sequence:Sequence",
        "fmu": "poppet.parts.fmu:FMU",
    },
    lambda name, value: isinstance(value, type) and issubclass(value, Part) and value.kind == name,
)
"""Kind to class. A module is imported when one of its kinds is requested; plugins add kinds (`core/plugins.py`)."""

_PATHS = {
    **{name: f"poppet.parts.bodies:{name}" for name in ("BodyFriction", "BodyStop", "JointFriction", "JointStop")},
    **{name: f"poppet.parts.main_stage:{name}" for name in ("Contact", "Exhaust", "Friction", "Spring", "Stop")},
    "Solenoid": "poppet.parts.solenoid:Solenoid",
    **{str(path).partition(":")[2]: str(path) for path in KINDS.data.values()},
}

# Literal, so that type checkers can read it.
__all__ = [
    "FMU", "KINDS", "PID", "Antagonist", "BodyFriction", "BodyStop", "Chamber", "CheckValve", "Compressor", "Contact",
    "Cylinder", "DirectionalValve", "Electronics", "Exhaust", "Filter", "FlowControlValve", "FlowSource", "Friction",
    "Gripper", "Guide", "InverseMuscle", "Joint", "JointFriction", "JointStop", "MainStage", "Mass", "Muscle",
    "Orifice", "Part", "Passage", "PilotStage", "PilotedCheckValve", "PressureBooster", "PressureController",
    "PressureRegulator", "ProportionalValve", "QuickExhaustValve", "ReliefValve", "Reservoir", "RotaryActuator",
    "Sequence", "ShuttleValve", "Silencer", "Solenoid", "SpoolValve", "Spring", "Stop", "Store", "SuctionCup", "Switch",
    "Tube", "TwoPressureValve", "VacuumEjector",
]  # fmt: skip


def __getattr__(name: str) -> object:
    if name not in _PATHS:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(_PATHS[name].partition(":")[0]), name)

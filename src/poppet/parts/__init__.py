"""The parts of a circuit, and the register by which a circuit file names them."""

from poppet.parts.antagonist import Antagonist, InverseMuscle
from poppet.parts.bodies import BodyFriction, BodyStop, Guide, Joint, JointFriction, JointStop, Mass
from poppet.parts.chamber import Chamber
from poppet.parts.cylinder import Cylinder
from poppet.parts.electronics import Electronics
from poppet.parts.flow_source import FlowSource
from poppet.parts.main_stage import Contact, Exhaust, Friction, MainStage, Spring, Stop
from poppet.parts.muscle import Muscle
from poppet.parts.orifice import Orifice
from poppet.parts.part import Part, Passage, Store
from poppet.parts.pid import PID
from poppet.parts.pilot_stage import PilotStage
from poppet.parts.pressure_controller import PressureController
from poppet.parts.proportional_valve import ProportionalValve
from poppet.parts.reservoir import Reservoir
from poppet.parts.solenoid import Solenoid
from poppet.parts.spool_valve import SpoolValve
from poppet.parts.tube import Tube
from poppet.parts.valves import CheckValve, DirectionalValve, ReliefValve, Silencer

KINDS: dict[str, type[Part]] = {
    part.kind: part
    for part in (
        Reservoir,
        Chamber,
        Orifice,
        FlowSource,
        MainStage,
        PilotStage,
        Electronics,
        ProportionalValve,
        PID,
        PressureController,
        CheckValve,
        ReliefValve,
        DirectionalValve,
        SpoolValve,
        Silencer,
        Mass,
        Joint,
        Guide,
        Cylinder,
        Muscle,
        InverseMuscle,
        Antagonist,
        Tube,
    )
}

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

"""Identification: from bench recordings to numbers with honest intervals."""

from poppet.identify.baselines import Score, baselines, score_table
from poppet.identify.characteristic.file import read_characteristic_file, write_characteristic
from poppet.identify.characteristic.run import identify_characteristic
from poppet.identify.design.file import DesignPlan, read_design_file
from poppet.identify.design.run import Design, Predicted, identify_design
from poppet.identify.fit.file import read_fit_file
from poppet.identify.fit.run import identify_fit
from poppet.identify.fit.search import Settings
from poppet.identify.flow.file import read_flow_file
from poppet.identify.flow.points import FlowPoints
from poppet.identify.flow.run import identify_flow
from poppet.identify.free import Free, Prior
from poppet.identify.friction.file import read_friction_file
from poppet.identify.friction.records import FrictionRecord
from poppet.identify.friction.run import identify_friction
from poppet.identify.muscle.file import read_muscle_file
from poppet.identify.muscle.points import MusclePoints
from poppet.identify.muscle.run import identify_muscle
from poppet.identify.result import Estimate, ResidualSummary, Result, read_result
from poppet.identify.tank.run import identify_tank
from poppet.identify.tank.test import TankTest, read_tank_file

__all__ = [
    "Design",
    "DesignPlan",
    "Estimate",
    "FlowPoints",
    "Free",
    "FrictionRecord",
    "MusclePoints",
    "Predicted",
    "Prior",
    "ResidualSummary",
    "Result",
    "Score",
    "Settings",
    "TankTest",
    "baselines",
    "identify_characteristic",
    "identify_design",
    "identify_fit",
    "identify_flow",
    "identify_friction",
    "identify_muscle",
    "identify_tank",
    "read_characteristic_file",
    "read_design_file",
    "read_fit_file",
    "read_flow_file",
    "read_friction_file",
    "read_muscle_file",
    "read_result",
    "read_tank_file",
    "score_table",
    "write_characteristic",
]

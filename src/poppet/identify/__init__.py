"""Identification: from bench recordings to numbers with honest intervals."""

from poppet.identify.baselines import Score, baselines, score_table
from poppet.identify.characteristic.characteristic_file import read_characteristic_file, write_characteristic
from poppet.identify.characteristic.identify_characteristic import identify_characteristic
from poppet.identify.design.design_file import DesignPlan, read_design_file
from poppet.identify.design.identify_design import Design, Prediction, identify_design
from poppet.identify.fit.fit_file import read_fit_file
from poppet.identify.fit.identify_fit import identify_fit
from poppet.identify.fit.search import SearchSettings
from poppet.identify.flow.flow_file import read_flow_file
from poppet.identify.flow.identify_flow import identify_flow
from poppet.identify.flow.points import FlowPoints
from poppet.identify.free_parameter import FreeParameter, NormalPrior
from poppet.identify.friction.friction_file import read_friction_file
from poppet.identify.friction.identify_friction import identify_friction
from poppet.identify.friction.records import FrictionRecord
from poppet.identify.muscle.identify_muscle import identify_muscle
from poppet.identify.muscle.muscle_file import read_muscle_file
from poppet.identify.muscle.points import MusclePoints
from poppet.identify.result import Estimate, ResidualSummary, Result, read_result
from poppet.identify.tank.identify_tank import identify_tank
from poppet.identify.tank.test import TankTest, read_tank_file

__all__ = [
    "Design",
    "DesignPlan",
    "Estimate",
    "FlowPoints",
    "FreeParameter",
    "FrictionRecord",
    "MusclePoints",
    "NormalPrior",
    "Prediction",
    "ResidualSummary",
    "Result",
    "Score",
    "SearchSettings",
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

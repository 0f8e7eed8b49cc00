"""Identification of parameters, with confidence intervals, from recordings of a test bench."""

from __future__ import annotations

import importlib
import warnings
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from poppet.identify.baseline_models import Score, baselines, score_table
    from poppet.identify.characteristic.characteristic_file import read_characteristic_file, write_characteristic
    from poppet.identify.characteristic.identify_characteristic import identify_characteristic
    from poppet.identify.design.design_file import DesignPlan, read_design_file
    from poppet.identify.design.identify_design import Design, Prediction, identify_design
    from poppet.identify.fit.fit_circuit import FitResult
    from poppet.identify.fit.fit_plan import read_fit_file
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
    from poppet.identify.muscle.muscle_file import MusclePoints, read_muscle_file
    from poppet.identify.result import Estimate, ResidualSummary, Result, read_result
    from poppet.identify.tank.identify_tank import identify_tank
    from poppet.identify.tank.test import TankTest, read_tank_file

__all__ = [
    "Design",
    "DesignPlan",
    "Estimate",
    "FitResult",
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

_NAMES_IN = {
    "baseline_models": "Score baselines score_table",
    "characteristic.characteristic_file": "read_characteristic_file write_characteristic",
    "characteristic.identify_characteristic": "identify_characteristic",
    "design.design_file": "DesignPlan read_design_file",
    "design.identify_design": "Design Prediction identify_design",
    "fit.fit_plan": "read_fit_file",
    "fit.fit_circuit": "FitResult",
    "fit.identify_fit": "identify_fit",
    "fit.search": "SearchSettings",
    "flow.flow_file": "read_flow_file",
    "flow.identify_flow": "identify_flow",
    "flow.points": "FlowPoints",
    "free_parameter": "FreeParameter NormalPrior",
    "friction.friction_file": "read_friction_file",
    "friction.identify_friction": "identify_friction",
    "friction.records": "FrictionRecord",
    "muscle.identify_muscle": "identify_muscle",
    "muscle.muscle_file": "MusclePoints read_muscle_file",
    "result": "Estimate ResidualSummary Result read_result",
    "tank.identify_tank": "identify_tank",
    "tank.test": "TankTest read_tank_file",
}
_MODULE_OF = {name: module for module, names in _NAMES_IN.items() for name in names.split()}
_FORMER_NAMES = {"Free": "FreeParameter", "Predicted": "Prediction", "Settings": "SearchSettings"}


def __getattr__(name: str) -> object:
    # Names are imported on first use: a program loads only the methods that it calls.
    if name in _FORMER_NAMES:
        warnings.warn(f"poppet.identify.{name} is now called {_FORMER_NAMES[name]}.", DeprecationWarning, stacklevel=2)
        name = _FORMER_NAMES[name]
    if name not in _MODULE_OF:
        raise AttributeError(f"module 'poppet.identify' has no attribute {name!r}")
    return getattr(importlib.import_module(f"poppet.identify.{_MODULE_OF[name]}"), name)


def __dir__() -> list[str]:
    return sorted(__all__)

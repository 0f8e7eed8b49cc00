"""Comparison of thermal laws on the same tank test."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from poppet.core.codes import Note
from poppet.identify.fit.experiment import channels_of
from poppet.identify.fit.fit_findings import error_model_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.identify_fit import CLEAR
from poppet.identify.fit.search import SearchSettings, optimise
from poppet.identify.fit.statistics import aicc, estimates
from poppet.identify.result import Estimate, Result
from poppet.identify.tank.tank_plan import TankRun, plan_tank_fit
from poppet.identify.tank.test import TankTest

Law = dict[str, Any]


def compare_laws(test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result) -> Result:
    """Add the estimates and the AICc under each law in `compare` to a result."""
    first_row = _row(
        result.comparison["aicc"], result.parameters, {k: result.residuals[k].rms for k in _channel_names(plan)}
    )
    laws: dict[str, Law] = {test.thermal: first_row}
    for name in test.compare:
        if name in laws:
            continue
        law = {"wall_conductance": 0.0, "thermal": "energy"} if name == "adiabatic" else {"thermal": name}
        law_plan = plan_tank_fit(replace(test, compare=(), **law), runs)
        sigmas = [float(result.conditions["noise"][fitted]) for fitted in _channel_names(law_plan)]
        optimum = optimise(law_plan.experiments, law_plan.free, SearchSettings(test.loss), sigmas=sigmas)
        if optimum.interrupted:
            conditions = {**result.conditions, "interrupted": True}
            return replace(result, conditions=conditions, remarks=(*result.remarks, Note("finding.stopped.laws")))
        channels = zip(channels_of(law_plan.experiments), sigmas, strict=True)
        pieces = {fitted.name: sigma * optimum.residual[fitted.rows] for fitted, sigma in channels}
        parameters = estimates(law_plan.free, optimum, error_model_of(law_plan.experiments, optimum, law_plan.settings))
        rms = {channel: float((piece @ piece / piece.size) ** 0.5) for channel, piece in pieces.items()}
        laws[name] = _row(aicc(list(pieces.values()), len(law_plan.free)), parameters, rms)
    number = f"{test.part}.sonic_conductance"
    remarks = [_law_note(laws, number)] if len(laws) > 1 and number in first_row["numbers"] else []
    comparison = {**result.comparison, "thermal_laws": laws}
    return replace(result, comparison=comparison, remarks=(*remarks, *result.remarks))


def _channel_names(plan: FitPlan) -> list[str]:
    return [fitted.name for fitted in channels_of(plan.experiments)]


def _row(criterion: float, parameters: Mapping[str, Estimate], rms: Mapping[str, float]) -> Law:
    return {
        "aicc": criterion,
        "rms": dict(rms),
        "numbers": {name: vars(estimate).copy() for name, estimate in parameters.items()},
    }


def _law_note(laws: Mapping[str, Law], number: str) -> Note:
    """Return a note on the spread of C between the laws."""
    least = min(law["aicc"] for law in laws.values())
    values = {name: float(law["numbers"][number]["value"]) for name, law in laws.items()}
    left = tuple(name for name, law in laws.items() if law["aicc"] - least < CLEAR)
    facts = {"values": values, "factor": max(values.values()) / min(values.values()), "left": left}
    unit = next(iter(laws.values()))["numbers"][number]["unit"]
    return Note(f"finding.laws.{'one' if len(left) == 1 else 'several'}", number, **facts, unit=unit)

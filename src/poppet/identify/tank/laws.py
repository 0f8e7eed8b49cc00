"""The same tank test under other thermal laws, side by side: how far C rests on what becomes of the heat."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from poppet.core.codes import Note
from poppet.identify.fit.experiment import channels_of
from poppet.identify.fit.fit_findings import spread_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.identify_fit import CLEAR
from poppet.identify.fit.search import SearchSettings, optimise
from poppet.identify.fit.statistics import aicc, estimates
from poppet.identify.result import Estimate, Result
from poppet.identify.tank.tank_plan import TankRun, tank_plan
from poppet.identify.tank.test import TankTest

Law = dict[str, Any]


def compared_laws(test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result) -> Result:
    """A result with the numbers and AICc of the same recordings under each law that `compare` names."""
    own = _row(result.comparison["aicc"], result.parameters, {k: result.residuals[k].rms for k in _fitted(plan)})
    laws: dict[str, Law] = {test.thermal: own}
    for name in test.compare:
        if name in laws:
            continue
        law = {"wall_conductance": 0.0, "thermal": "energy"} if name == "adiabatic" else {"thermal": name}
        other = tank_plan(replace(test, compare=(), **law), runs)
        sigmas = [float(result.conditions["noise"][each]) for each in _fitted(other)]
        optimum = optimise(other.experiments, other.free, SearchSettings(test.loss), sigmas=sigmas)
        if optimum.interrupted:
            conditions = {**result.conditions, "interrupted": True}
            return replace(result, conditions=conditions, remarks=(*result.remarks, Note("finding.stopped.laws")))
        channels = zip(channels_of(other.experiments), sigmas, strict=True)
        pieces = {each.name: sigma * optimum.residual[each.rows] for each, sigma in channels}
        found = estimates(other.free, optimum, spread_of(other.experiments, optimum, other.settings))
        rms = {channel: float((piece @ piece / piece.size) ** 0.5) for channel, piece in pieces.items()}
        laws[name] = _row(aicc(list(pieces.values()), len(other.free)), found, rms)
    number = f"{test.part}.sonic_conductance"
    remarks = [_judged(laws, number)] if len(laws) > 1 and number in own["numbers"] else []
    comparison = {**result.comparison, "thermal_laws": laws}
    return replace(result, comparison=comparison, remarks=(*remarks, *result.remarks))


def _fitted(plan: FitPlan) -> list[str]:
    return [each.name for each in channels_of(plan.experiments)]


def _row(criterion: float, found: Mapping[str, Estimate], rms: Mapping[str, float]) -> Law:
    return {"aicc": criterion, "rms": dict(rms), "numbers": {name: vars(e).copy() for name, e in found.items()}}


def _judged(laws: Mapping[str, Law], number: str) -> Note:
    """How far the conductance rests on the law, and which laws the recordings leave."""
    least = min(law["aicc"] for law in laws.values())
    values = {name: float(law["numbers"][number]["value"]) for name, law in laws.items()}
    left = tuple(name for name, law in laws.items() if law["aicc"] - least < CLEAR)
    facts = {"values": values, "factor": max(values.values()) / min(values.values()), "left": left}
    unit = next(iter(laws.values()))["numbers"][number]["unit"]
    return Note(f"finding.laws.{'one' if len(left) == 1 else 'several'}", number, **facts, unit=unit)

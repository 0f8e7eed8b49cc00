"""Other models of the same recordings: what the numbers of a tank test would be if what was held were not so."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.identify.fit.experiment import channels_of
from poppet.identify.fit.fit_findings import spread_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.identify_fit import STRONG
from poppet.identify.fit.search import Objective, Optimum, SearchSettings, optimise
from poppet.identify.fit.statistics import aicc, estimates
from poppet.identify.fit.whiteness import correlation_time, is_white
from poppet.identify.free_parameter import FreeParameter, begun_at
from poppet.identify.result import Estimate, Result
from poppet.identify.tank.tank_plan import TankRun, is_free, plausible_wall, tank_plan
from poppet.identify.tank.test import TankTest
from poppet.timeseries.checks import FloatArray

HELD = (
    "wall_heat_capacity",
    "subsonic_index",
    "supply_pressure",
    "leak_conductance",
    "pressure_lag",
    "pressure_offset",
)
"""What may be free instead of held, by the name of its field."""
ASKED_FOR = 2.5
"""Sigmas of a step towards another value from which it is worth a fit; chance costs time only."""
BY_STEPS = 0.5
"""Of the step of a gauge: residuals up to there are its rounding, which is a staircase where noise does not blur it."""
CONSTANT = 1e3
"""Times a plausible heat capacity: a wall that keeps its temperature."""
LIGHTER = ((1.0, 1.0), (0.1, 1.0), (0.01, 1.0), (0.1, 10.0))
"""Times a plausible heat capacity and a common conductance of a wall where the searches for its capacity begin."""
WARMS = 0.05
"""Part of the greatest difference of temperature between gas and wall by which a wall may warm unseen."""


@dataclass(frozen=True)
class Alternative:
    """A model with more free numbers than the one that was fitted."""

    name: str  # of the field that is free
    estimates: Mapping[str, Estimate]
    difference: float  # of AICc to that of the fit; negative: better
    samples: float  # of its residuals that count as one

    @property
    def gain(self) -> float:
        """By how much its AICc is lower; correlated residuals are fewer than they look."""
        return -self.difference / self.samples


def misfits(plan: FitPlan, result: Result) -> set[str]:
    """Channels whose residuals are no noise, and no steps of a coarse gauge either."""
    found = set()
    for each in channels_of(plan.experiments):
        shown = result.series[each.name]
        residual = shown["model"] - shown["measured"]
        if not is_white(residual) and np.std(residual) > BY_STEPS * each.channel.quantum:
            found.add(each.name)
    return found


def tried(test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result) -> list[Alternative]:
    """All alternatives, the best first, if the recordings ask for one; else none."""
    plans = {name: other for name in HELD if (other := _plan(test, runs, name)) and _added(other, result)}
    if not (misfits(plan, result) or any(_pull(other, result) > ASKED_FOR for other in plans.values())):
        # Pressures without wall heat and with a light wall may look alike, whatever the slopes say.
        is_blind = all(len(run.measurement.channels) == 1 for run in runs)
        plans = {name: other for name, other in plans.items() if is_blind and name == "wall_heat_capacity"}
    found = []
    for name, other in plans.items():
        # A light wall has minima of its own: the heat that it does not take looks like no wall at all.
        starts = LIGHTER if name == "wall_heat_capacity" else ((1.0, 1.0),)
        optimum = min((_optimum(other, result, *times) for times in starts), key=lambda each: each.cost)
        if optimum.interrupted:
            break
        found.append(_alternative(name, other, optimum, result))
    found.sort(key=lambda each: each.difference)
    if found:
        # The best is searched as thoroughly as the fit was: where that ended need not be near.
        best = plans[found[0].name]
        optimum = _optimum(best, result, kicks=best.settings.kicks)
        again = _alternative(found[0].name, best, optimum, result)
        found[0] = min(found[0], again, key=lambda each: each.difference)
    return found


def warmed(test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result, number: str) -> list[Note]:
    """By how much a wall of a plausible heat capacity would have warmed, and what that makes of a number."""
    if test.thermal != "energy" or test.wall_heat_capacity is not None:
        return []
    values = {name: estimate.value for name, estimate in result.parameters.items()}
    rise, swing, capacity = 0.0, 0.0, 0.0
    for e in plan.experiments:
        run, names = e.everything(values)
        gas, heat = (np.asarray(run.values[names.index(f"tank.{each}")]) for each in ("temperature", "heat_flow_rate"))
        taken = np.cumsum(0.5 * (heat[1:] + heat[:-1]) * np.diff(e.grid))
        wall = e.instance.parameters["tank.wall_temperature"]
        capacity = plausible_wall(e.instance.parameters["tank.volume"])
        rise = max(rise, float(np.max(np.abs(taken))) / capacity)
        swing = max(swing, float(np.max(np.abs(gas - wall))))
    if not rise > WARMS * swing:
        return []
    x = np.array([values[f.name] for f in plan.free])
    before = Objective(plan.experiments, plan.free, _sigmas(plan, result)).cost(x)
    lighter = tank_plan(replace(test, wall_heat_capacity=capacity), runs)
    optimum = _optimum(lighter, result)
    if optimum.cost > before + 0.5 * STRONG:
        return []  # the recordings speak against it
    simple, value = result.parameters[number], optimum.x[[f.name for f in lighter.free].index(number)]
    if simple.low <= value <= simple.high:
        return []
    facts = {
        "capacity": capacity,
        "rise": rise,
        "number": number,
        "percent": 100.0 * (float(value) / simple.value - 1.0),
    }
    return [Note("finding.wall", "tank.wall_heat_capacity", **facts)]


def table(found: Sequence[Alternative], number: str) -> dict[str, Any]:
    """What stands in a result file: AICc, the number that a test is made for, and what was free in addition."""
    return {
        each.name: {
            "aicc_difference": each.difference,
            number: _row(each.estimates[number]),
            "free": {name: _row(e) for name, e in each.estimates.items()},
        }
        for each in found
    }


def _row(estimate: Estimate) -> dict[str, Any]:
    return {key: getattr(estimate, key) for key in ("value", "low", "high", "unit")}


def _plan(test: TankTest, runs: Sequence[TankRun], name: str) -> FitPlan | None:
    """The plan with one held number free; None where it does not exist, or was not held as it is by default."""
    if name == "supply_pressure":
        if not any(run.direction == "charge" and not is_free(run.supply_pressure) for run in runs):
            return None
        freed = [replace(run, supply_pressure=_freed(run.supply_pressure)) for run in runs]
        # Off by the same, the gauge would hide it: one of the two is right.
        offset = 0.0 if test.pressure_offset is None else test.pressure_offset
        return tank_plan(replace(test, supply_pressure=_freed(test.supply_pressure), pressure_offset=offset), freed)
    given = getattr(test, name)
    if is_free(given) or (name == "wall_heat_capacity" and test.thermal != "energy"):
        return None
    changed: dict[str, Any] = {name: "free"}
    if name == "subsonic_index":
        changed[name] = _freed(given)
    elif given not in (None, 0.0):
        return None
    return tank_plan(replace(test, **changed), runs)


def _freed(given: Any) -> Any:
    return given if given is None or is_free(given) else {"start": given}


def _added(plan: FitPlan, result: Result) -> list[FreeParameter]:
    return [f for f in plan.free if f.name not in result.parameters]


def _pull(plan: FitPlan, result: Result) -> float:
    """Sigmas by which the recordings ask for a held number, by the slope of the cost where the fit ended."""
    added, names = _added(plan, result), [f.name for f in plan.free]
    x = np.array([result.parameters[f.name].value if f not in added else _held(f) for f in plan.free])
    residual, jacobian = Objective(plan.experiments, plan.free, _sigmas(plan, result)).residual_and_jacobian(x)
    norms = np.linalg.norm(jacobian, axis=0)
    jacobian = jacobian / np.where(norms > 0.0, norms, 1.0)
    inside = [k for k, f in enumerate(plan.free) if f not in added and result.parameters[f.name].verdict != "at bound"]
    basis = np.linalg.qr(jacobian[:, inside])[0]
    largest, size = 0.0, float(np.sqrt(np.mean(residual**2)))
    for f in added:
        own = jacobian[:, names.index(f.name)]
        own = own - basis @ (basis.T @ own)
        length = float(np.linalg.norm(own))
        step = -float(own @ residual)
        # Held at a bound, it can go one way only.
        is_outward = (step < 0.0 and _held(f) <= f.low) or (step > 0.0 and f.address == "tank.wall_heat_capacity")
        if length > 1e-6 and not is_outward:
            largest = max(largest, abs(step) / (length * size))
    return largest


def _held(f: FreeParameter) -> float:
    """The value of a number that is free in an alternative and held in the fit."""
    if f.role in ("lag", "offset") or f.address == "leak.sonic_conductance":
        return 0.0
    return CONSTANT * f.start if f.address == "tank.wall_heat_capacity" else f.start


def _sigmas(plan: FitPlan, result: Result) -> list[float]:
    return [float(result.conditions["noise"][each.name]) for each in channels_of(plan.experiments)]


def _optimum(
    plan: FitPlan, result: Result, times: float = 1.0, conducts: float = 1.0, kicks: int | None = 0
) -> Optimum:
    """The search from where the fit ended; what was held begins at so many times its usual start."""
    is_walled = any(f.address == "tank.wall_heat_capacity" for f in plan.free)

    def begun(f: FreeParameter) -> float:
        if f.name not in result.parameters:
            return times * f.start
        ended = float(np.clip(result.parameters[f.name].value, f.low, f.high))
        # Without wall heat its capacity would not be felt.
        return max(ended, conducts * f.start) if is_walled and f.address == "tank.wall_conductance" else ended

    settings = SearchSettings(plan.settings.loss, kicks=kicks)
    return optimise(
        plan.experiments, begun_at(plan.free, map(begun, plan.free)), settings, sigmas=_sigmas(plan, result)
    )


def _alternative(name: str, plan: FitPlan, optimum: Optimum, result: Result) -> Alternative:
    sigmas = _sigmas(plan, result)
    pieces = [optimum.residual[each.rows] * s for each, s in zip(channels_of(plan.experiments), sigmas, strict=True)]
    found = estimates(plan.free, optimum, spread_of(plan.experiments, optimum, plan.settings))
    difference = aicc(pieces, len(plan.free)) - float(result.comparison["aicc"])
    return Alternative(name, found, difference, max(map(_count_as_one, pieces)))


def _count_as_one(residual: FloatArray) -> float:
    return 1.0 if is_white(residual) else correlation_time(residual)

"""Fits of a charge from both thermal limits, in which a small leak and the supply pressure are uncertain.

An isothermal tank with a small leak has nearly the same pressure curve as a tank with little wall heat. The same is
true of a supply pressure that is slightly below the stated one. The difference of two optima is therefore evidence only
if it remains with these parameters free.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from poppet.core.codes import Note
from poppet.identify.fit.fit_findings import error_model_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.optima import ISOTHERMAL, NEARLY_ADIABATIC, NEARLY_ISOTHERMAL, typical_wall_conductances
from poppet.identify.fit.search import Optimum, SearchSettings, optimise
from poppet.identify.fit.statistics import estimates
from poppet.identify.free_parameter import FreeParameter, NormalPrior, by_name
from poppet.identify.result import DETERMINED, Estimate, Result
from poppet.identify.tank.budget import Uncertainties
from poppet.identify.tank.tank_plan import LEAK_ADDRESS, USUAL_ZERO, TankRun, has_leak, is_free, plan_tank_fit
from poppet.identify.tank.test import TankTest

SUPPLY = 0.01
"""Relative standard uncertainty of a supply pressure whose uncertainty is not stated. A wrong choice of the limit
changes C by up to 40 %, so that it is larger than in the budget."""
SUPPLY_ADDRESS, WALL = "supply.pressure", "tank.wall_conductance"
EQUIVALENT = 1.92
"""Largest excess of the cost of an equivalent fit: the limit of a 95 % interval (chi-square, one parameter)."""
SMALL = 0.3
"""Start value of the leak, as a fraction of its standard uncertainty."""


@dataclass(frozen=True)
class UncertainFit:
    """Fit of a tank test in which leak and supply pressure are free, with normal priors."""

    plan: FitPlan
    optimum: Optimum

    @property
    def values(self) -> dict[str, float]:
        """Mapping from the name of each free parameter to its value."""
        return by_name(self.plan.free, self.optimum.x)

    def estimates(self) -> dict[str, Estimate]:
        """Return the estimates of all free parameters by name."""
        return estimates(self.plan.free, self.optimum, error_model_of(self.plan, self.optimum))


@dataclass(frozen=True)
class ThermalLimits:
    """Fits of a charge near the adiabatic and isothermal limits that describe the recordings equally well.

    Leak and supply pressure are uncertain in these fits.
    """

    local: UncertainFit  # from the optimum of the fit
    equivalent: tuple[UncertainFit, ...]  # optima that differ in C and that the data do not exclude


def fit_thermal_limits(
    test: TankTest,
    uncertainties: Uncertainties,
    runs: Sequence[TankRun],
    plan: FitPlan,
    result: Result,
    number: str,
) -> ThermalLimits | None:
    """Fit a charge test from its adiabatic and its isothermal limit, with uncertain leak and supply pressure.

    The result is None if the test is not a charge with pressure only, or if the fit already has equivalent optima. It
    is also None if leak and supply pressure are exact or free in the fit. `number` is the address of the sonic
    conductance.
    """
    units = typical_wall_conductances(plan.experiments, plan.free)
    if not units or len(units) > 1 or any(run.direction != "charge" for run in runs):
        return None
    conductances = [float(optimum["values"][number]) for optimum in result.optima]
    if max(conductances) > (1.0 + DETERMINED) * min(conductances):
        return None
    uncertain = _uncertain_plan(test, uncertainties, runs, plan)
    if uncertain is None:
        return None
    values = {name: estimate.value for name, estimate in result.parameters.items()}
    leaks = {f.name for f in uncertain.free if f.address == LEAK_ADDRESS} - values.keys()
    sigmas = [float(sigma) for sigma in result.conditions["noise"].values()]
    wall = plan.free[next(iter(units))].name
    unit = next(iter(units.values()))

    def search(start: Mapping[str, float], fixed: Mapping[str, float] | None = None) -> UncertainFit:
        # The leak is a fraction of C, which differs between the limits.
        sd = uncertainties.leak * start[number]
        free = tuple(
            replace(f, start=SMALL * sd, low=0.0, prior=NormalPrior(0.0, sd)) if f.name in leaks else f
            for f in uncertain.free
        )
        start_point = [np.clip(start.get(f.name, f.start), f.low, f.high) for f in free]
        optimum = optimise(
            uncertain.experiments,
            free,
            SearchSettings(plan.settings.loss, kicks=0),
            sigmas=sigmas,
            fixed=fixed,
            start_point=np.array(start_point),
        )
        return UncertainFit(replace(uncertain, free=free), replace(optimum, fixed=dict(fixed or {})))

    local = search(values)
    limit = EQUIVALENT * error_model_of(local.plan, local.optimum).variance_factor
    fits = [local]
    ends = {row["name"]: row["end"] for row in result.conditions["searches"]}
    for name, at_limit, near in (
        ("adiabatic", 0.0, NEARLY_ADIABATIC),
        ("isothermal", ISOTHERMAL, NEARLY_ISOTHERMAL),
    ):
        end = ends.get(name)
        if end is None or abs(end[number] - values[number]) <= DETERMINED * values[number]:
            continue
        fit = search(end, {wall: at_limit * unit})
        if fit.optimum.cost - local.optimum.cost >= limit:
            fit = search({**fit.values, wall: near * unit})
        fits.append(fit)
    least = min(fit.optimum.cost for fit in fits)
    equivalent = tuple(
        fit
        for fit in fits[1:]
        if fit.optimum.cost - least < limit
        and abs(fit.values[number] - values[number]) > DETERMINED * values[number]
        and not fit.optimum.interrupted
    )
    return ThermalLimits(local, equivalent)


def thermal_limit_notes(limits: ThermalLimits, result: Result, number: str) -> list[Note]:
    """Return a note for each fit near the adiabatic or isothermal limit that describes a charge equally well.

    `number` is the address of the sonic conductance.
    """
    notes, simple = [], result.parameters[number]
    for fit in limits.equivalent:
        values = fit.values
        facts = {"value": values[number], "unit": simple.unit, "percent": 100.0 * (values[number] / simple.value - 1.0)}
        facts |= {"wall": values[WALL], "leak": 100.0 * values.get(LEAK_ADDRESS, 0.0) / values[number]}
        supply = next((f for f in fit.plan.free if f.address == SUPPLY_ADDRESS and f.prior), None)
        facts["supply"] = 100.0 * (values[supply.name] / supply.start - 1.0) if supply else 0.0
        rms = [float(np.sqrt(np.mean(f.optimum.residual**2))) for f in (fit, limits.local)]
        facts["excess"] = 100.0 * (max(rms) / max(min(rms), 1e-300) - 1.0)
        notes.append(Note("finding.optima.leak", number, **facts))
    return notes


def _uncertain_plan(
    test: TankTest, uncertainties: Uncertainties, runs: Sequence[TankRun], plan: FitPlan
) -> FitPlan | None:
    """Return the plan of a fit in which leak, supply pressure and sensor offset are free.

    Supply pressure and offset have normal priors. The result is None if both leak and supply pressure are exact or free
    in the original fit.
    """
    changed: dict[str, object] = {}
    if not has_leak(test) and uncertainties.leak > 0.0:
        changed["leak_conductance"] = "free"
    freed = list(runs)
    if uncertainties.supply_pressure > 0.0 and not any(is_free(run.supply_pressure) for run in runs):
        freed = [replace(run, supply_pressure={"start": run.supply_pressure}) for run in runs]
        changed["supply_pressure"] = {"start": test.supply_pressure}
    if not changed:
        return None
    if test.pressure_offset is None and test.loss == "linear":
        changed["pressure_offset"] = "free"
    uncertain = plan_tank_fit(replace(test, **changed), freed)  # type: ignore[arg-type]
    spans = {run.measurement.name: float(np.ptp(run.pressure.values)) for run in runs}
    before = {f.name: f for f in plan.free}
    supply = SUPPLY if "supply_pressure" in uncertainties.assumed else uncertainties.supply_pressure

    def with_prior(f: FreeParameter) -> FreeParameter:
        if f.name in before:
            return before[f.name]
        if f.role == "offset":
            return replace(f, prior=NormalPrior(0.0, USUAL_ZERO * spans[f.recording]))
        return replace(f, prior=NormalPrior(f.start, supply * f.start)) if f.address == SUPPLY_ADDRESS else f

    return replace(uncertain, free=tuple(map(with_prior, uncertain.free)))

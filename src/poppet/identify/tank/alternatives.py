"""Fits of a tank test with other models, in which one more parameter is free or the thermal law differs."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.identify.fit.experiment import channels_of
from poppet.identify.fit.fit_findings import error_model_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.identify_fit import CLEAR, STRONG
from poppet.identify.fit.intervals import Stages
from poppet.identify.fit.residuals import correlation_time, is_white
from poppet.identify.fit.search import FitObjective, Optimum, SearchSettings, optimise
from poppet.identify.fit.statistics import aicc, estimates
from poppet.identify.free_parameter import FreeParameter, with_starts
from poppet.identify.result import Estimate, Result, mark_interrupted
from poppet.identify.tank.tank_plan import (
    LEAK,
    LEAK_ADDRESS,
    NEARLY_TIGHT,
    TankRun,
    is_free,
    plan_tank_fit,
    plausible_wall,
)
from poppet.identify.tank.test import TankTest
from poppet.parts.fields import NumberLike
from poppet.timeseries.checks import FloatArray

STAGE = "fits of alternative models"
"""Name of this stage of an identification on the progress display."""
HELD = (
    "wall_heat_capacity",
    "subsonic_index",
    "supply_pressure",
    "leak_conductance",
    "pressure_lag",
    "pressure_offset",
)
"""Fixed fields of a tank test that can be free."""
ASKED_FOR = 2.5
"""Predicted change of a fixed parameter above which it is fitted, in sigmas; a false alarm only costs time."""
BY_STEPS = 0.5
"""Residuals up to this fraction of the sensor resolution count as rounding."""
CONSTANT = 1e3
"""Factor on a plausible heat capacity that makes the wall temperature constant."""
LIGHTER = ((1.0, 1.0), (0.1, 1.0), (0.01, 1.0), (0.1, 10.0))
"""Start points of the wall capacity: factors on a plausible heat capacity and on a usual wall conductance."""
WARMS = 0.05
"""Negligible warming of the wall, as a fraction of the largest temperature difference of gas and wall."""


@dataclass(frozen=True)
class Alternative:
    """Fit of a tank test with one more free parameter than the original fit."""

    name: str  # name of the field that is free in this model only
    estimates: Mapping[str, Estimate]
    difference: float  # AICc of this model minus that of the fit; negative if this model is better
    samples: float  # number of residuals per independent residual

    @property
    def gain(self) -> float:
        """Decrease of AICc compared with the original fit, corrected for correlated samples.

        The decrease is divided by the number of samples that correspond to one independent sample.
        """
        return -self.difference / self.samples


def misfit_channels(plan: FitPlan, result: Result) -> set[str]:
    """Return the names of the channels that the model does not describe.

    Their residuals are neither white noise nor rounding errors.
    """
    channels = set()
    for fitted in channels_of(plan.experiments):
        series = result.series[fitted.name]
        residual = series["model"] - series["measured"]
        if not is_white(residual) and np.std(residual) > BY_STEPS * fitted.channel.quantum:
            channels.add(fitted.name)
    return channels


def fit_alternatives(
    test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result, stages: Stages | None = None
) -> list[Alternative]:
    """Fit a tank test with one more free parameter, for each of several parameters, and return the best fit first.

    The list is empty if the recordings give no reason for another model. `stages` is called before each fit.
    """
    show = stages or (lambda stage, completed, total: None)
    plans = {
        name: alternative_plan
        for name in HELD
        if (alternative_plan := _alternative_plan(test, runs, name)) and _added_parameters(alternative_plan, result)
    }
    if not (
        misfit_channels(plan, result)
        or any(_largest_step(alternative_plan, result) > ASKED_FOR for alternative_plan in plans.values())
    ):
        # Pressures with and without a light wall can be equal although the derivatives differ.
        is_blind = all(len(run.measurement.channels) == 1 for run in runs)
        plans = {name: plans[name] for name in plans if is_blind and name == "wall_heat_capacity"}
    alternatives: list[Alternative] = []
    for name, alternative_plan in plans.items():
        show(STAGE, len(alternatives), len(plans) + 1)
        # A light wall has additional minima: a wall that takes little heat resembles an adiabatic tank.
        starts = LIGHTER if name == "wall_heat_capacity" else ((1.0, 1.0),)
        optimum = min(
            (_fit_plan(alternative_plan, result, *times) for times in starts), key=lambda alternative: alternative.cost
        )
        if optimum.interrupted:
            break
        alternatives.append(_to_alternative(name, alternative_plan, optimum, result))
    alternatives.sort(key=lambda alternative: alternative.difference)
    if alternatives:
        # Search the best one as thoroughly as the fit: its optimum can be far from that of the fit.
        show(STAGE, len(plans), len(plans) + 1)
        best = plans[alternatives[0].name]
        optimum = _fit_plan(best, result, kicks=best.settings.kicks)
        thorough = _to_alternative(alternatives[0].name, best, optimum, result)
        alternatives[0] = min(alternatives[0], thorough, key=lambda alternative: alternative.difference)
    return alternatives


def wall_temperature_notes(
    test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result, number: str
) -> list[Note]:
    """Return a note if a wall that warms up would change the sonic conductance clearly.

    The fit assumes a constant wall temperature. `number` is the address of the sonic conductance.
    """
    if test.thermal != "energy" or test.wall_heat_capacity is not None:
        return []
    values = {name: estimate.value for name, estimate in result.parameters.items()}
    rise, swing, capacity = 0.0, 0.0, 0.0
    for experiment in plan.experiments:
        run, names = experiment.all_outputs(values)
        gas, heat = (
            np.asarray(run.values[names.index(f"tank.{quantity}")]) for quantity in ("temperature", "heat_flow_rate")
        )
        taken_heat = np.cumsum(0.5 * (heat[1:] + heat[:-1]) * np.diff(experiment.grid))
        wall = experiment.instance.parameters["tank.wall_temperature"]
        capacity = plausible_wall(experiment.instance.parameters["tank.volume"])
        rise = max(rise, float(np.max(np.abs(taken_heat))) / capacity)
        swing = max(swing, float(np.max(np.abs(gas - wall))))
    if not rise > WARMS * swing:
        return []
    x = np.array([values[f.name] for f in plan.free])
    cost_before = FitObjective(plan.experiments, plan.free, _sigmas(plan, result)).cost(x)
    lighter = plan_tank_fit(replace(test, wall_heat_capacity=capacity), runs)
    optimum = _fit_plan(lighter, result)
    if optimum.cost > cost_before + 0.5 * STRONG:
        return []  # the recordings contradict a lighter wall
    simple, value = result.parameters[number], optimum.x[[f.name for f in lighter.free].index(number)]
    if simple.low <= value <= simple.high:
        return []
    percent = 100.0 * (float(value) / simple.value - 1.0)
    facts = {"capacity": capacity, "rise": rise, "number": number, "percent": percent}
    return [Note("finding.wall", "tank.wall_heat_capacity", **facts)]


def alternatives_table(alternatives: Sequence[Alternative], number: str) -> dict[str, Any]:
    """Return the alternative models as tables for a result file, by name.

    Each table contains the difference of AICc, the sonic conductance and all free parameters. `number` is the address
    of the sonic conductance.
    """
    return {
        alternative.name: {
            "aicc_difference": alternative.difference,
            number: _row(alternative.estimates[number]),
            "free": {name: _row(estimate) for name, estimate in alternative.estimates.items()},
        }
        for alternative in alternatives
    }


def _row(estimate: Estimate) -> dict[str, Any]:
    return {key: getattr(estimate, key) for key in ("value", "low", "high", "unit")}


def _alternative_plan(test: TankTest, runs: Sequence[TankRun], name: str) -> FitPlan | None:
    """Return the plan of a fit in which one more parameter is free.

    `name` is the name of this parameter. The result is None if this model does not apply to the test.
    """
    if name == "supply_pressure":
        if not any(run.direction == "charge" and not is_free(run.supply_pressure) for run in runs):
            return None
        freed = [replace(run, supply_pressure=_free_table(run.supply_pressure)) for run in runs]
        # An equal offset of the sensor would compensate it: free only one of the two.
        offset = 0.0 if test.pressure_offset is None else test.pressure_offset
        return plan_tank_fit(
            replace(test, supply_pressure=_free_table(test.supply_pressure), pressure_offset=offset), freed
        )
    argument = getattr(test, name)
    if is_free(argument) or (name == "wall_heat_capacity" and test.thermal != "energy"):
        return None
    changed: dict[str, Any] = {name: "free"}
    if name == "subsonic_index":
        changed[name] = _free_table(argument)
    elif argument not in (None, 0.0):
        return None
    return plan_tank_fit(replace(test, **changed), runs)


def _free_table(argument: Any) -> NumberLike:
    return argument if argument is None or is_free(argument) else {"start": argument}


def _added_parameters(plan: FitPlan, result: Result) -> list[FreeParameter]:
    return [f for f in plan.free if f.name not in result.parameters]


def _largest_step(plan: FitPlan, result: Result) -> float:
    """Return the largest change of an additional parameter that is predicted if it becomes free, in standard errors.

    The additional parameters are free in `plan` but fixed in the fit `result`. The prediction uses the gradient of the
    cost.
    """
    added, names = _added_parameters(plan, result), [f.name for f in plan.free]
    x = np.array([result.parameters[f.name].value if f not in added else _fixed_value(f) for f in plan.free])
    objective = FitObjective(plan.experiments, plan.free, _sigmas(plan, result))
    residual = objective.residual(x)
    # Without a leak, the derivatives by it are inaccurate.
    leaks = [NEARLY_TIGHT / LEAK * f.start if f in added and f.address == LEAK_ADDRESS else 0.0 for f in plan.free]
    jacobian = objective.residual_and_jacobian(x + leaks)[1]
    norms = np.linalg.norm(jacobian, axis=0)
    jacobian = jacobian / np.where(norms > 0.0, norms, 1.0)
    indices = [k for k, f in enumerate(plan.free) if f not in added and result.parameters[f.name].verdict != "at bound"]
    basis = np.linalg.qr(jacobian[:, indices])[0]
    largest, size = 0.0, float(np.sqrt(np.mean(residual**2)))
    for f in added:
        column = jacobian[:, names.index(f.name)]
        column = column - basis @ (basis.T @ column)
        length = float(np.linalg.norm(column))
        step = -float(column @ residual)
        # A parameter at a bound can move in one direction only.
        is_outward = (step < 0.0 and _fixed_value(f) <= f.low) or (
            step > 0.0 and f.address == "tank.wall_heat_capacity"
        )
        if length > 1e-6 and not is_outward:
            largest = max(largest, abs(step) / (length * size))
    return largest


def _fixed_value(f: FreeParameter) -> float:
    """Return the value that the additional free parameter `f` has in the original fit, in which it is fixed."""
    if f.role in ("lag", "offset") or f.address == LEAK_ADDRESS:
        return 0.0
    return CONSTANT * f.start if f.address == "tank.wall_heat_capacity" else f.start


def _sigmas(plan: FitPlan, result: Result) -> list[float]:
    return [float(result.conditions["noise"][fitted.name]) for fitted in channels_of(plan.experiments)]


def _fit_plan(
    plan: FitPlan, result: Result, times: float = 1.0, conducts: float = 1.0, kicks: int | None = 0
) -> Optimum:
    """Return the optimum of an alternative model of a tank test.

    The search starts from the values of the original fit, `result`. Additional parameters start from their usual start
    value times the factor `times`. The wall conductance starts from at least its usual start value times the factor
    `conducts`.
    """
    is_walled = any(f.address == "tank.wall_heat_capacity" for f in plan.free)

    def begun(f: FreeParameter) -> float:
        if f.name not in result.parameters:
            return times * f.start
        ended = float(np.clip(result.parameters[f.name].value, f.low, f.high))
        # Without wall heat, the data are insensitive to the wall capacity.
        return max(ended, conducts * f.start) if is_walled and f.address == "tank.wall_conductance" else ended

    settings = SearchSettings(plan.settings.loss, kicks=kicks)
    return optimise(
        plan.experiments, with_starts(plan.free, map(begun, plan.free)), settings, sigmas=_sigmas(plan, result)
    )


def _evaluate_optimum(plan: FitPlan, optimum: Optimum) -> tuple[dict[str, Estimate], dict[str, FloatArray], float]:
    """Return the estimates at an optimum, the residuals by channel in SI units, and the AICc."""
    channels = zip(channels_of(plan.experiments), optimum.sigmas, strict=True)
    residuals = {fitted.name: sigma * optimum.residual[fitted.rows] for fitted, sigma in channels}
    parameters = estimates(plan.free, optimum, error_model_of(plan, optimum))
    return parameters, residuals, aicc(list(residuals.values()), len(plan.free))


def _to_alternative(name: str, plan: FitPlan, optimum: Optimum, result: Result) -> Alternative:
    parameters, residuals, criterion = _evaluate_optimum(plan, optimum)
    difference = criterion - float(result.comparison["aicc"])
    samples = max(1.0 if is_white(residual) else correlation_time(residual) for residual in residuals.values())
    return Alternative(name, parameters, difference, samples)


# Thermal laws -----------------------------------------------------------------------------------------------------


def compare_laws(test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result) -> Result:
    """Add a comparison of thermal laws, such as isothermal and polytropic, to the result of a tank test.

    The comparison contains the estimates and the AICc for the law of the test and for each law in its field `compare`.
    """
    names = [fitted.name for fitted in channels_of(plan.experiments)]
    first_row = _law_row(result.comparison["aicc"], result.parameters, {k: result.residuals[k].rms for k in names})
    laws: dict[str, dict[str, Any]] = {test.thermal: first_row}
    for name in test.compare:
        if name in laws:
            continue
        law = {"wall_conductance": 0.0, "thermal": "energy"} if name == "adiabatic" else {"thermal": name}
        law_plan = plan_tank_fit(replace(test, compare=(), **law), runs)
        settings, sigmas = SearchSettings(test.loss), _sigmas(law_plan, result)
        optimum = optimise(law_plan.experiments, law_plan.free, settings, sigmas=sigmas)
        if optimum.interrupted:
            return mark_interrupted(result, Note("finding.stopped.laws"))
        parameters, residuals, criterion = _evaluate_optimum(law_plan, optimum)
        rms = {channel: float((piece @ piece / piece.size) ** 0.5) for channel, piece in residuals.items()}
        laws[name] = _law_row(criterion, parameters, rms)
    number, remarks = f"{test.part}.sonic_conductance", list[Note]()
    if len(laws) > 1 and number in first_row["numbers"]:
        least = min(law["aicc"] for law in laws.values())
        values = {name: float(law["numbers"][number]["value"]) for name, law in laws.items()}
        left = tuple(name for name, law in laws.items() if law["aicc"] - least < CLEAR)
        facts = {"values": values, "factor": max(values.values()) / min(values.values()), "left": left}
        unit = first_row["numbers"][number]["unit"]
        remarks = [Note(f"finding.laws.{'one' if len(left) == 1 else 'several'}", number, **facts, unit=unit)]
    comparison = {**result.comparison, "thermal_laws": laws}
    return replace(result, comparison=comparison, remarks=(*remarks, *result.remarks))


def _law_row(criterion: float, parameters: Mapping[str, Estimate], rms: Mapping[str, float]) -> dict[str, Any]:
    return {
        "aicc": criterion,
        "rms": dict(rms),
        "numbers": {name: vars(estimate).copy() for name, estimate in parameters.items()},
    }

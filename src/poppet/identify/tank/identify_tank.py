"""Method `identify tank`: charge and discharge tests according to ISO 6358-2.

Evidence against the model of a test limits the verdicts of its estimates.
"""

from __future__ import annotations

import math
from collections.abc import Collection, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np

from poppet.core.codes import Note
from poppet.core.toml_file import TomlFile
from poppet.core.units import quantity
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.identify_fit import CLEAR, STRONG, Progress, identify_fit
from poppet.identify.fit.intervals import Stages
from poppet.identify.fit.optima import unite_estimates
from poppet.identify.flow.flow_findings import USUAL_CONDUCTANCE
from poppet.identify.gum import SPREAD, add_relative_uncertainty
from poppet.identify.result import DETERMINED, Result
from poppet.identify.tank.alternatives import (
    Alternative,
    alternatives_table,
    compare_laws,
    fit_alternatives,
    misfit_channels,
    wall_temperature_notes,
)
from poppet.identify.tank.budget import Uncertainties, add_budget, read_uncertainties, update_parameter_notes
from poppet.identify.tank.tank_plan import AREA_FACTOR, TankRun, plan_tank_fit, read_runs
from poppet.identify.tank.test import ROOM, TankTest, read_test
from poppet.identify.tank.thermal_limits import fit_thermal_limits, thermal_limit_notes
from poppet.laws.iso6358.conversion import conductance_from_effective_area

MISFIT = "finding.residuals.not_white"
CAPPING = (
    MISFIT,
    "finding.other_model.clear",
    "finding.other_model.several",
    "finding.other_model.doubt",
    "finding.area",
    "finding.wall",
    "finding.unusual.conductance",
    "finding.unusual.wall",
)
"""Codes of findings that limit the verdicts of all parameters that depend on the model."""
MISREAD = ("finding.unusual.closes", "finding.unusual.time", "finding.unexplained.", "suspicion.", "finding.gauge")
"""Code prefixes of findings on invalid data, which come first."""
DOUBTFUL = 6.0
"""Least improvement of AICc of another model whose estimate is outside the interval; its probability by chance is
0.5 %."""
ALIKE = 3.0
"""Largest excess of AICc of an equivalent model, about the penalty of its additional parameter."""
LOOK_ALIKE = ("wall_heat_capacity", "supply_pressure")
"""Free parameters whose effect the other parameters can imitate. (A leak always shares C with the valve.)"""
USUAL_TRANSFER = 0.1, 1000.0
"""Wide range of the heat transfer coefficient of air in tanks [W/(m^2 K)]."""
CHANGING = 0.1, 0.9
"""Fractions of the pressure change between which its duration is measured."""
LONGEST, LONGEST_STEP = 500.0, 2.0
"""Duration of a pressure change and sample time above which the times may be milliseconds [s]."""
MOST = 0.6
"""Fraction of the pressure change after closing above which the closing time is wrong; cooling after an adiabatic
charge is less than 0.3."""
LARGE_VOLUME = 1.0
"""Volume above which the unit was probably litres [m^3]."""
READ_OFF = ("initial_pressure", "initial_temperature")
"""Parameters that the first samples determine for each model."""
POWERS = {"sonic_conductance": 0.5, "wall_conductance": 1.0, "wall_heat_capacity": 1.0}
"""Exponents of the temperature: with all temperatures times r, C / r^0.5 and h A / r give the same pressures."""


def identify_tank(
    test: TankTest | str | Path,
    *,
    profile: Sequence[str] = (),
    repeats: int = 0,
    contour: bool = False,
    progress: Progress | None = None,
    stages: Stages | None = None,
) -> Result:
    """Fit C, b and other free parameters to charge and discharge tests of a tank.

    Parameters
    ----------
    test : TankTest, str or Path
        Tank test, or its file.
    profile : sequence of str, optional
        Free parameters whose intervals are computed from the profile likelihood.
    repeats : int, optional
        Number of bootstrap fits; 0 for none.
    contour : bool, optional
        If True, add the chi-square contour over conductance and wall conductance to the series, and its findings.
    progress : callable, optional
        Function that is called with the number of evaluations and the least cost so far.
    stages : callable, optional
        Function that is called with the stage after the fit (profiles, contour, bootstrap), the number of completed
        steps and their total number.

    Returns
    -------
    Result
        Estimates by address, such as `valve.sonic_conductance`, `valve.critical_ratio`, `tank.wall_conductance`. The
        name of a nuisance parameter begins with its recording: `first.valve.delay`, `first.tank.pressure.offset`.

    Raises
    ------
    InputErrors
        If the test is invalid, or if a recording contradicts its direction. Examples are a pressure that rises in a
        discharge, that is almost constant, or that exceeds the supply pressure.

    Notes
    -----
    The fit integrates the equations; it does not differentiate the recorded pressure.

    Examples
    --------
    >>> import numpy as np
    >>> from poppet import Chamber, Circuit, Orifice
    >>> tank = Chamber(volume="20 l", initial_pressure="7 bar", wall_conductance=5.0)
    >>> valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> truth = Circuit({"tank": tank, "valve": valve}).simulate("40 s", "0.1 s")
    >>> pressure = truth["tank.pressure"] + np.random.default_rng(1).normal(0.0, 500.0, truth.time.size)
    >>> test = TankTest(recordings={"a": {"time": truth.time, "tank.pressure": pressure}}, volume="20 l")
    >>> found = identify_tank(test).parameters["valve.sonic_conductance"]
    >>> found.verdict, bool(abs(found.value / 1e-8 - 1.0) < 0.005)
    ('determined', True)
    """
    if isinstance(test, TankTest):
        runs = read_runs(test)
        plan = plan_tank_fit(test, runs)
        uncertainties = read_uncertainties(test, plan)
    else:
        file = TomlFile.read(test, "recordings")
        with file.errors():
            test = read_test(file)
            runs = read_runs(test)
            plan = plan_tank_fit(test, runs)
            uncertainties = read_uncertainties(test, plan)
    result = identify_fit(plan, profile=profile, repeats=repeats, contour=contour, progress=progress, stages=stages)
    result = apply_caps(test, uncertainties, runs, plan, replace(result, method="tank"), stages)
    if test.compare and not result.conditions["interrupted"]:
        result = compare_laws(test, runs, plan, result)
    result = add_budget(test, uncertainties, runs, plan, result, widen_for_ambient(test, runs, result))
    return update_parameter_notes(plan, result)


def widen_for_ambient(test: TankTest, runs: Sequence[TankRun], result: Result) -> Result:
    """Widen the intervals of a tank test if the temperature of the flowing gas is not known.

    This is the case if the ambient temperature is not stated, and no stated or recorded temperature replaces it.
    """

    # The temperature of the flowing gas is that of the supply or that in the tank.
    is_known = all(
        run.supply_temperature is not None
        if run.direction == "charge"
        else test.initial_temperature is not None or run.has_temperature
        for run in runs
    )
    if test.ambient_temperature is not None or is_known:
        return result
    wider = {
        name: add_relative_uncertainty(estimate, POWERS[field] * SPREAD / ROOM)
        for name, estimate in result.parameters.items()
        if (field := name.rpartition(".")[2]) in POWERS and estimate.verdict in ("determined", "weak")
    }
    number = f"{test.part}.sonic_conductance"
    if number not in wider:
        return result
    facts = {"celsius": ROOM - 273.15, "percent": 50.0 / ROOM, "spread": SPREAD, "names": tuple(wider)}
    note = Note("finding.room", number, **facts)
    return replace(result, parameters={**result.parameters, **wider}, remarks=(note, *result.remarks))


def apply_caps(
    test: TankTest,
    uncertainties: Uncertainties,
    runs: Sequence[TankRun],
    plan: FitPlan,
    result: Result,
    stages: Stages | None = None,
) -> Result:
    """Compare a tank test with alternative models, and reduce verdicts if there is evidence against its model.

    The result contains the alternative models and the notes on them.
    """
    number = f"{test.part}.sonic_conductance"
    if result.conditions["interrupted"] or number not in result.parameters:
        return result
    timing = time_unit_notes(runs)
    # Fits with a wrong time of closing do not compare models.
    is_mistimed = any(note.code == "finding.unusual.closes" for note in timing)
    alternatives = [] if is_mistimed else fit_alternatives(test, runs, plan, result, stages)
    comparison = dict(result.comparison)
    if alternatives:
        comparison["alternatives"] = alternatives_table(alternatives, number)
    remarks = [*timing, *_alternative_notes(alternatives, result, number)]
    conductance = result.parameters[number]
    if test.bore:
        # The discharge coefficient is the conductance divided by that of a nozzle of the same bore; the least value
        # is that for a bore that is larger by two standard deviations.
        bore, sigma = (quantity(argument, "m", name="bore").value for argument in (test.bore, test.bore_uncertainty))
        nozzle, largest_nozzle = (
            conductance_from_effective_area(0.25 * math.pi * diameter**2).sonic_conductance
            for diameter in (bore, bore + 2.0 * sigma)
        )
        coefficient = {key: getattr(conductance, key) / nozzle for key in ("value", "low", "high")}
        comparison["discharge_coefficient"] = coefficient | {"least": conductance.value / largest_nozzle}
        if conductance.value > largest_nozzle:
            remarks.append(Note("finding.area", number, **comparison["discharge_coefficient"]))
    # If another model is clearly better, the effect of a warm wall on this one does not matter.
    if not any(note.code == "finding.other_model.clear" for note in remarks):
        remarks += wall_temperature_notes(test, runs, plan, result, number)
    if not USUAL_CONDUCTANCE[0] <= conductance.value <= USUAL_CONDUCTANCE[1]:
        remarks.append(Note("finding.unusual.conductance", number, value=conductance.value))
    volume = max(e.instance.parameters["tank.volume"] for e in plan.experiments)
    if "tank.volume" in result.parameters:
        volume = result.parameters["tank.volume"].value
    if volume > LARGE_VOLUME:
        remarks.append(Note("finding.unusual.volume", "tank.volume", value=volume))
    area = AREA_FACTOR * volume ** (2.0 / 3.0)
    for name, e in result.parameters.items():
        is_unusual = e.low > 0.0 and (e.high < USUAL_TRANSFER[0] * area or e.low > USUAL_TRANSFER[1] * area)
        if name.endswith("tank.wall_conductance") and is_unusual:
            remarks.append(Note("finding.unusual.wall", name, value=e.value, coefficient=e.value / area))
    estimates_by_model = [
        {**result.parameters, **alternative.estimates}
        for alternative in alternatives
        if _is_equivalent_model(alternative, result, number)
    ]
    if limits := fit_thermal_limits(test, uncertainties, runs, plan, result, number):
        remarks += thermal_limit_notes(limits, result, number)
        estimates_by_model += [{**result.parameters, **fit.estimates()} for fit in limits.equivalent]
    parameters = unite_estimates(plan, [result.parameters, *estimates_by_model])
    sorted_remarks = sorted((*remarks, *result.remarks), key=lambda note: not note.code.startswith(MISREAD))
    doubts = replace(result, parameters=parameters, comparison=comparison, remarks=tuple(sorted_remarks))
    return _cap_verdicts(doubts, misfit_channels(plan, result))


def _is_equivalent_model(alternative: Alternative, result: Result, number: str) -> bool:
    """Return True if an alternative model of a tank test explains the recordings equally well.

    `number` is the address of the sonic conductance C. An alternative with nearly the same C counts only if it has no
    more free parameters.
    """
    simple, value = result.parameters[number], alternative.estimates[number].value
    is_swap = len(alternative.estimates) <= len(result.parameters) and alternative.difference < CLEAR
    is_far = abs(value / simple.value - 1.0) > DETERMINED and alternative.difference < ALIKE
    return alternative.name in LOOK_ALIKE and (is_swap or is_far)


def _alternative_notes(alternatives: Sequence[Alternative], result: Result, number: str) -> list[Note]:
    """Return notes on the best alternative model of a tank test, and on C in each alternative.

    `number` is the address of the sonic conductance C.
    """
    if not alternatives:
        return []
    simple, best = result.parameters[number], alternatives[0]
    values = {alternative.name: alternative.estimates[number].value for alternative in alternatives}
    changes = {name: 100.0 * (value / simple.value - 1.0) for name, value in values.items()}
    outside = [a for a in alternatives if not simple.low <= values[a.name] <= simple.high]
    rival = next((a for a in outside if _is_equivalent_model(a, result, number)), None)
    if best.gain > STRONG:
        degree = "clear"
    elif best.gain > DOUBTFUL and best in outside:
        degree = "doubt"
    elif rival:
        degree, best = "alike", rival
    elif len(alternatives) == 1 and best.gain < CLEAR:
        return []  # no evidence for another model
    else:
        degree = "somewhat" if best.gain > CLEAR else "none"
    sizes = {alternative.name: alternative.difference for alternative in alternatives}
    alike = tuple(name for name, size in sizes.items() if abs(size - best.difference) < CLEAR)
    facts = {"models": alike, "size": -best.difference, "percent": changes[best.name]}
    facts |= {"value": values[best.name], "unit": simple.unit}
    if degree == "clear":
        # Do not report models that are themselves contradicted.
        changes = {a.name: changes[a.name] for a in alternatives if a.gain > best.gain - STRONG}
        facts["models"] = tuple(changes)
        if max(changes.values()) - min(changes.values()) > 100.0 * DETERMINED:
            facts |= {"low": min(changes.values()), "high": max(changes.values())}
            return [Note("finding.other_model.several", number, **facts)]
        return [Note("finding.other_model.clear", number, **facts)]
    return [
        Note(f"finding.other_model.{degree}", number, **facts),
        Note("finding.other_models", number, changes=changes, sizes=sizes),
    ]


def time_unit_notes(runs: Sequence[TankRun]) -> list[Note]:
    """Return notes on recordings whose times are probably in another unit."""
    notes = []
    for run in runs:
        channel = run.pressure
        time, change = channel.time, np.abs(channel.values - np.median(channel.values[:3]))
        reached = [float(time[np.argmax(change >= share * np.max(change))]) for share in CHANGING]
        address, step = f"{run.measurement.name}.{channel.address}", float(np.median(np.diff(time)))
        after = (
            1.0 - float(np.interp(run.closes, time, change)) / float(np.max(change)) if run.closes < time[-1] else 0.0
        )
        if after > MOST:
            notes.append(Note("finding.unusual.closes", address, share=after, closes=run.closes))
        elif reached[1] - reached[0] > LONGEST and step > LONGEST_STEP:
            notes.append(Note("finding.unusual.time", address, span=reached[1] - reached[0], step=step))
    return notes


def _cap_verdicts(result: Result, missed: Collection[str]) -> Result:
    """Reduce the verdict `determined` to `weak` for parameters with evidence against the model.

    The item `capped` of the conditions of the result contains the reasons. `missed` contains the names of the channels
    that the model does not describe.
    """
    reasons: dict[str, list[str]] = {}
    for note in result.remarks:
        if note.code not in CAPPING or (note.code == MISFIT and note.address not in missed):
            continue
        if note.code == "finding.wall" and abs(note.facts["percent"]) <= 100.0 * DETERMINED:
            continue  # the change of C is below the limit of a verdict
        recording, names = note.address.partition(".")[0], result.conditions["recordings"]
        for name, estimate in result.parameters.items():
            owner, field = name.partition(".")[0], name.rpartition(".")[2]
            # A lack of fit of one recording does not affect the parameters of another.
            is_of_other = recording in names and owner in names and owner != recording
            is_capped = estimate.verdict == "determined" and field not in READ_OFF and not is_of_other
            if is_capped and note.code not in reasons.setdefault(name, []):
                reasons[name].append(note.code)
    if not reasons:
        return result
    parameters = {k: replace(e, verdict="weak") if k in reasons else e for k, e in result.parameters.items()}
    cap_note = Note("finding.capped", names=tuple(reasons))
    conditions = {**result.conditions, "capped": reasons}
    return replace(result, parameters=parameters, remarks=(cap_note, *result.remarks), conditions=conditions)

"""What speaks against the model of a tank test caps its verdicts: an interval holds noise, not a wrong model."""

from __future__ import annotations

import math
from collections.abc import Collection, Iterator, Sequence
from dataclasses import replace

from poppet.core.codes import Note
from poppet.core.units import quantity
from poppet.identify.fit.equivalent_optima import united
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.identify_fit import CLEAR, STRONG
from poppet.identify.flow.flow_findings import USUAL_CONDUCTANCE
from poppet.identify.result import DETERMINED, Estimate, Result
from poppet.identify.tank.alternatives import Alternative, misfits, table, tried, warmed
from poppet.identify.tank.tank_plan import AREA_FACTOR, TankRun
from poppet.identify.tank.test import TankTest
from poppet.laws.iso6358.conversion import conductance_from_effective_area

MISFIT = "finding.residuals.not_white"
CAPPING = (
    MISFIT,
    "finding.other_model.clear",
    "finding.other_model.doubt",
    "finding.area",
    "finding.wall",
    "finding.unusual.conductance",
    "finding.unusual.wall",
)
"""Findings after which no number that depends on the model is determined."""
MISREAD = ("finding.unexplained.", "suspicion.", "finding.gauge")
"""How findings begin after which other models are of no interest."""
DOUBTFUL = 6.0
"""AICc by which another model has to be better for its number to count where it lies outside the interval; chance does
so once in 200 times."""
ALIKE = 3.0
"""AICc by which another model may be worse, which is what its number costs, and is as good."""
LOOK_ALIKE = ("wall_heat_capacity", "supply_pressure")
"""Models that a fit without them imitates. (A leak shares C with the valve in any discharge, if nothing shows it.)"""
USUAL_TRANSFER = 0.1, 1000.0
"""Heat transfer of air in tanks, generously [W/(m^2 K)]."""
LARGE_VOLUME = 1.0
"""Above it litres may have been meant [m^3]."""
READ_OFF = ("initial_pressure", "initial_temperature")
"""Numbers that the first samples say, whatever the model."""


def doubted(test: TankTest, runs: Sequence[TankRun], plan: FitPlan, result: Result) -> Result:
    """A result with what speaks against its model, other models beside it, and verdicts that heed it."""
    number = f"{test.part}.sonic_conductance"
    if result.conditions["interrupted"] or number not in result.parameters:
        return result
    found = tried(test, runs, plan, result)
    comparison = {**result.comparison, **({"alternatives": table(found, number)} if found else {})}
    remarks = _of_alternatives(found, result, number)
    if test.bore:
        coefficient = _coefficient(test, result.parameters[number])
        comparison["discharge_coefficient"] = coefficient
        remarks += [Note("finding.area", number, **coefficient)] if coefficient["least"] > 1.0 else []
    remarks += warmed(test, runs, plan, result, number)
    remarks += _unusual(plan, result, number)
    local = [{**result.parameters, **each.estimates} for each in found if _is_rival(each, result, number)]
    parameters = united(plan, [result.parameters, *local])
    said = sorted((*remarks, *result.remarks), key=lambda note: not note.code.startswith(MISREAD))
    doubts = replace(result, parameters=parameters, comparison=comparison, remarks=tuple(said))
    return _capped(doubts, misfits(plan, result))


def _is_rival(each: Alternative, result: Result, number: str) -> bool:
    """Whether another model explains the recordings as well; where its C is near, with no more free numbers."""
    simple, value = result.parameters[number], each.estimates[number].value
    is_swap = len(each.estimates) <= len(result.parameters) and each.difference < CLEAR
    is_far = abs(value / simple.value - 1.0) > DETERMINED and each.difference < ALIKE
    return each.name in LOOK_ALIKE and (is_swap or is_far)


def _of_alternatives(found: Sequence[Alternative], result: Result, number: str) -> list[Note]:
    """Which of the other models is the best, and the number that a test is made for under each."""
    if not found:
        return []
    simple, best = result.parameters[number], found[0]
    changes = {each.name: 100.0 * (each.estimates[number].value / simple.value - 1.0) for each in found}

    def is_outside(each: Alternative) -> bool:
        return not simple.low <= each.estimates[number].value <= simple.high

    rival = next((each for each in found if _is_rival(each, result, number) and is_outside(each)), None)
    if best.gain > STRONG:
        word = "clear"
    elif best.gain > DOUBTFUL and is_outside(best):
        word = "doubt"
    elif rival:
        word, best = "alike", rival
    elif len(found) == 1 and best.gain < CLEAR:
        return []  # nothing asked for it
    else:
        word = "somewhat" if best.gain > CLEAR else "none"
    alike = tuple(each.name for each in found if abs(each.difference - best.difference) < CLEAR)
    facts = {"models": alike, "size": -best.difference, "percent": changes[best.name]}
    facts |= {"value": best.estimates[number].value, "unit": simple.unit}
    return [
        Note(f"finding.other_model.{word}", number, **facts),
        Note("finding.other_models", number, changes=changes, sizes={each.name: each.difference for each in found}),
    ]


def _unusual(plan: FitPlan, result: Result, number: str) -> Iterator[Note]:
    """Numbers of no valve and no tank: some unit is wrong."""
    conductance = result.parameters[number].value
    if not USUAL_CONDUCTANCE[0] <= conductance <= USUAL_CONDUCTANCE[1]:
        yield Note("finding.unusual.conductance", number, value=conductance)
    values = {e.instance.parameters["tank.volume"] for e in plan.experiments}
    volume = result.parameters["tank.volume"].value if "tank.volume" in result.parameters else max(values)
    if volume > LARGE_VOLUME:
        yield Note("finding.unusual.volume", "tank.volume", value=volume)
    area = AREA_FACTOR * volume ** (2.0 / 3.0)
    for name, e in result.parameters.items():
        if not name.endswith("tank.wall_conductance"):
            continue
        if e.low > 0.0 and (e.high < USUAL_TRANSFER[0] * area or e.low > USUAL_TRANSFER[1] * area):
            yield Note("finding.unusual.wall", name, value=e.value, coefficient=e.value / area)


def _coefficient(test: TankTest, conductance: Estimate) -> dict[str, float]:
    """Discharge coefficient with the interval of C, and the least that the uncertainty of the bore leaves."""
    bore, sigma = (quantity(each, "m", name="bore").value for each in (test.bore, test.bore_uncertainty))

    def nozzle(diameter: float) -> float:
        return conductance_from_effective_area(0.25 * math.pi * diameter**2).sonic_conductance

    value, low, high = (each / nozzle(bore) for each in (conductance.value, conductance.low, conductance.high))
    return {"value": value, "low": low, "high": high, "least": conductance.value / nozzle(bore + 2.0 * sigma)}


def _capped(result: Result, missed: Collection[str]) -> Result:
    """A result in which no number is determined that a finding speaks against; `capped` of its conditions says why."""
    reasons: dict[str, list[str]] = {}
    for note in result.remarks:
        if note.code not in CAPPING or (note.code == MISFIT and note.address not in missed):
            continue
        if note.code == "finding.wall" and abs(note.facts["percent"]) <= 100.0 * DETERMINED:
            continue  # it moves C by no more than a verdict allows
        for name in _touched(note, result):
            if note.code not in reasons.setdefault(name, []):
                reasons[name].append(note.code)
    if not reasons:
        return result
    found = {k: replace(e, verdict="weak") if k in reasons else e for k, e in result.parameters.items()}
    told = Note("finding.capped", names=tuple(reasons))
    conditions = {**result.conditions, "capped": reasons}
    return replace(result, parameters=found, remarks=(told, *result.remarks), conditions=conditions)


def _touched(note: Note, result: Result) -> list[str]:
    """Numbers that were determined and depend on what a note says."""
    own, names = note.address.partition(".")[0], result.conditions["recordings"]
    return [
        name
        for name, estimate in result.parameters.items()
        if estimate.verdict == "determined"
        and name.rpartition(".")[2] not in READ_OFF
        # A recording's misfit says nothing of the numbers that belong to another.
        and not (own in names and name.partition(".")[0] in names and name.partition(".")[0] != own)
    ]

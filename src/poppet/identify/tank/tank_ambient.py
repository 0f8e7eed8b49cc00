"""Effect of an unknown ambient temperature on a tank test."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from poppet.core.codes import Note
from poppet.identify.ambient import SPREAD, widened
from poppet.identify.result import Result
from poppet.identify.tank.tank_plan import TEMPERATURE, TankRun
from poppet.identify.tank.test import ROOM, TankTest

POWERS = {"sonic_conductance": 0.5, "wall_conductance": 1.0, "wall_heat_capacity": 1.0}
"""Exponents of the temperature: with all temperatures times r, C / r^0.5 and h A / r give the same pressures."""


def widen_for_ambient(test: TankTest, runs: Sequence[TankRun], result: Result) -> Result:
    """Widen the intervals of a result for an unknown ambient temperature."""
    if test.ambient_temperature is not None or all(_is_known(test, run) for run in runs):
        return result
    wider = {
        name: widened(estimate, POWERS[field] * SPREAD / ROOM)
        for name, estimate in result.parameters.items()
        if (field := name.rpartition(".")[2]) in POWERS and estimate.verdict in ("determined", "weak")
    }
    number = f"{test.part}.sonic_conductance"
    if number not in wider:
        return result
    facts = {"celsius": ROOM - 273.15, "percent": 50.0 / ROOM, "spread": SPREAD, "names": tuple(wider)}
    note = Note("finding.room", number, **facts)
    return replace(result, parameters={**result.parameters, **wider}, remarks=(note, *result.remarks))


def _is_known(test: TankTest, run: TankRun) -> bool:
    """Return True if the temperature of the flowing gas is known."""
    if run.direction == "charge":
        return run.supply_temperature is not None
    return test.initial_temperature is not None or any(c.address == TEMPERATURE for c in run.measurement.channels)

"""A room whose temperature nobody states: how far the guess moves what is found."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from poppet.core.codes import Note
from poppet.identify.ambient import SPREAD, widened
from poppet.identify.result import Result
from poppet.identify.tank.tank_plan import TEMPERATURE, TankRun
from poppet.identify.tank.test import ROOM, TankTest

POWERS = {"sonic_conductance": 0.5, "wall_conductance": 1.0, "wall_heat_capacity": 1.0}
"""Homogeneous: with all temperatures r times as high, C / r^0.5 and h A / r give the same pressures."""


def allowing_for_room(test: TankTest, runs: Sequence[TankRun], result: Result) -> Result:
    """A result whose intervals hold what an unknown temperature of the room may change."""
    if test.ambient_temperature is not None or all(_is_known(test, run) for run in runs):
        return result
    wider = {
        name: widened(estimate, POWERS[own] * SPREAD / ROOM)
        for name, estimate in result.parameters.items()
        if (own := name.rpartition(".")[2]) in POWERS and estimate.verdict in ("determined", "weak")
    }
    number = f"{test.part}.sonic_conductance"
    if number not in wider:
        return result
    facts = {"celsius": ROOM - 273.15, "percent": 50.0 / ROOM, "spread": SPREAD, "names": tuple(wider)}
    told = Note("finding.room", number, **facts)
    return replace(result, parameters={**result.parameters, **wider}, remarks=(told, *result.remarks))


def _is_known(test: TankTest, run: TankRun) -> bool:
    """Whether the gas that flows has a temperature of its own."""
    if run.direction == "charge":
        return run.supply_temperature is not None
    return test.initial_temperature is not None or any(c.address == TEMPERATURE for c in run.measurement.channels)

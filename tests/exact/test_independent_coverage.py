"""Whether intervals of 95 % hold the truth in 95 % of tests, where the tests come from code of its own."""

from __future__ import annotations

from functools import cache
from typing import Any, NamedTuple

import pytest
from scipy.stats import binom

from exact.independent_tanks import AIR, ROOM, Tank, drawn, recorded
from poppet.identify import TankTest, identify_tank
from poppet.identify.result import Estimate

FEW, ALL = 20, 300
CHANCE = 0.001
"""With which a sound method leaves the band below; it leaves 93 to 98 % by no more than this many tests make of it."""
BAND = 0.93, 0.98
NAMES = {"C": "valve.sonic_conductance", "b": "valve.critical_ratio", "hA": "tank.wall_conductance"}


class Answer(NamedTuple):
    """What the identification says of one test."""

    tank: Tank
    found: dict[str, Estimate]
    rms: float

    def truth(self, name: str) -> float:
        return {"C": self.tank.conductance, "b": self.tank.ratio, "hA": self.tank.wall}[name]

    def holds(self, name: str) -> bool:
        return self.found[name].low <= self.truth(name) <= self.found[name].high


def told(tank: Tank, seed: int, **more: Any) -> TankTest:
    """A test as a user would describe it, who knows nothing of the offset of the gauge."""
    record = recorded(tank, seed)
    recording: dict[str, Any] = {"time": record["time"], "tank.pressure": record["pressure"], "closes": tank.closes}
    if "temperature" in record:
        recording["tank.temperature"] = record["temperature"]
    return TankTest(
        recordings={"test": recording},
        volume=tank.volume,
        direction="charge" if tank.is_charge else "discharge",
        supply_pressure=tank.outside if tank.is_charge else None,
        ambient_pressure=AIR,
        ambient_temperature=ROOM,
        initial_temperature=ROOM,
        **{"uncertainties": 0, **more},
    )


@cache
def answer(seed: int) -> Answer:
    """One test, identified through the public door."""
    tank = drawn(seed)
    result = identify_tank(told(tank, seed))
    found = {short: result.parameters[address] for short, address in NAMES.items()}
    return Answer(tank, found, result.residuals["test.tank.pressure"].rms)


def bounds(count: int) -> tuple[float, float]:
    """Of a count, how many a sound method holds at least and at most."""
    return float(binom.ppf(CHANCE, count, BAND[0])), float(binom.isf(CHANCE, count, BAND[1]))


def check_coverage(answers: list[Answer]) -> None:
    """Prints what was held of how many; `pytest -rP` shows it."""
    missed = {}
    for name in NAMES:
        sure = [each.holds(name) for each in answers if each.found[name].verdict == "determined"]
        count, held = len(sure), sum(sure)
        print(f"{name}: {held} of {count} determined hold the truth, of {len(answers)} tests")
        low, high = bounds(count)
        if not low <= held <= high:
            missed[name] = (held, count)
    assert missed == {}


def twins_called_determined(count: int) -> list[int]:
    """Tests of which nobody can tell C, but of which somebody says so."""
    twins = [seed for seed in range(count) if drawn(seed).has_twin]
    assert twins
    return [seed for seed in twins if "determined" in {answer(seed).found[name].verdict for name in ("C", "hA")}]


def test_few_intervals_hold_the_truth() -> None:
    check_coverage([answer(seed) for seed in range(FEW)])


def test_few_twins_are_not_determined() -> None:
    assert twins_called_determined(FEW) == []


@pytest.mark.slow
def test_many_intervals_hold_the_truth() -> None:
    check_coverage([answer(seed) for seed in range(ALL)])


@pytest.mark.slow
def test_many_twins_are_not_determined() -> None:
    assert twins_called_determined(ALL) == []

"""Tests of intervals if the ambient temperature is not stated; the independent generator uses 25 degC."""

from __future__ import annotations

from dataclasses import replace

import pytest

from exact import independent_tanks
from exact.independent_tanks import Tank, drawn
from exact.test_independent_coverage import NAMES, told
from poppet.identify import Result, TankTest, identify_tank

WARM, USUAL = 298.15, 293.15


@pytest.fixture
def warm_room(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(independent_tanks, "ROOM", WARM)


def generate_test(seed: int) -> tuple[Tank, TankTest]:
    """Return a test with recorded pressure only; odd seeds are discharges."""
    tank = replace(drawn(seed), source=WARM, wall=5.0, temperature_noise=None, is_coarse=False, offset=0.0, noise=50.0)
    return tank, replace(told(tank, seed), ambient_temperature=None, initial_temperature=None)


def has_room_note(result: Result) -> bool:
    return "finding.room" in {note.code for note in result.remarks}


@pytest.mark.parametrize("seed", [1, 4])
def test_intervals_include_unknown_temperature(warm_room: None, seed: int) -> None:
    tank, test = generate_test(seed)
    known, guessed = identify_tank(replace(test, ambient_temperature=WARM)), identify_tank(test)
    for short, power, truth in (("C", 0.5, tank.conductance), ("hA", 1.0, tank.wall)):
        sure, wide = (result.parameters[NAMES[short]] for result in (known, guessed))
        assert wide.value / sure.value == pytest.approx((WARM / USUAL) ** power, rel=1e-3)
        assert sure.low <= truth <= sure.high
        assert wide.low <= truth <= wide.high
        assert wide.standard_error == pytest.approx(power * wide.value * 3.0 / USUAL, rel=0.5)
    conductance = known.parameters[NAMES["C"]]
    # Without this uncertainty, the interval does not include the truth.
    assert guessed.parameters[NAMES["C"]].value - tank.conductance > conductance.high - conductance.value
    ratios = [result.parameters[NAMES["b"]] for result in (known, guessed)]
    assert ratios[0].value == pytest.approx(ratios[1].value, rel=1e-3)
    assert (has_room_note(known), has_room_note(guessed)) == (False, True)


@pytest.mark.parametrize(("seed", "said"), [(1, "initial_temperature"), (4, "supply_temperature")])
def test_known_gas_temperature_needs_no_room_temperature(warm_room: None, seed: int, said: str) -> None:
    assert not has_room_note(identify_tank(replace(generate_test(seed)[1], **{said: WARM})))

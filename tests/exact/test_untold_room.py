"""A room at 25 degC of which nothing is said, recordings of the independent generator: intervals allow for it."""

from __future__ import annotations

from dataclasses import replace

import pytest

from exact import independent_tanks
from exact.independent_tanks import Tank, drawn
from exact.test_independent_coverage import NAMES, told
from poppet.identify import Result, TankTest, identify_tank

WARM, USUAL = 298.15, 293.15


@pytest.fixture
def warm(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(independent_tanks, "ROOM", WARM)


def recorded(seed: int) -> tuple[Tank, TankTest]:
    """A test whose pressure alone was recorded, by a good gauge; odd seeds discharge."""
    tank = replace(drawn(seed), source=WARM, wall=5.0, temperature_noise=None, is_coarse=False, offset=0.0, noise=50.0)
    return tank, replace(told(tank, seed), ambient_temperature=None, initial_temperature=None)


def says_so(result: Result) -> bool:
    return "finding.room" in {note.code for note in result.remarks}


@pytest.mark.parametrize("seed", [1, 4])
def test_the_intervals_allow_for_it(warm: None, seed: int) -> None:
    tank, test = recorded(seed)
    known, guessed = identify_tank(replace(test, ambient_temperature=WARM)), identify_tank(test)
    for short, power, truth in (("C", 0.5, tank.conductance), ("hA", 1.0, tank.wall)):
        sure, wide = (result.parameters[NAMES[short]] for result in (known, guessed))
        assert wide.value / sure.value == pytest.approx((WARM / USUAL) ** power, rel=1e-3)
        assert sure.low <= truth <= sure.high
        assert wide.low <= truth <= wide.high
        assert wide.standard_error == pytest.approx(power * wide.value * 3.0 / USUAL, rel=0.5)
    conductance = known.parameters[NAMES["C"]]
    # Without the allowance it would not hold it.
    assert guessed.parameters[NAMES["C"]].value - tank.conductance > conductance.high - conductance.value
    ratios = [result.parameters[NAMES["b"]] for result in (known, guessed)]
    assert ratios[0].value == pytest.approx(ratios[1].value, rel=1e-3)
    assert (says_so(known), says_so(guessed)) == (False, True)


@pytest.mark.parametrize(("seed", "said"), [(1, "initial_temperature"), (4, "supply_temperature")])
def test_a_gas_of_known_temperature_needs_no_room(warm: None, seed: int, said: str) -> None:
    assert not says_so(identify_tank(replace(recorded(seed)[1], **{said: WARM})))

"""Air and exergy of a double stroke: the hand calculation, the expected figures and the simulation."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

import poppet

sys.path.insert(0, str(Path(__file__).parent))
from hand_double_stroke import AIR_L_ANR, EXERGY_J, PERIOD, circuit_text, double_stroke


@pytest.mark.parametrize("ambient", [1e5, 101325.0])
def test_the_expected_figures_follow_from_areas_volumes_and_pressures(ambient: float) -> None:
    air, exergy = double_stroke(ambient)
    assert air == pytest.approx(AIR_L_ANR, rel=5e-3)
    assert exergy == pytest.approx(EXERGY_J, rel=5e-3)


def test_they_need_the_dead_volumes() -> None:
    air, exergy = double_stroke(dead=0.0)
    assert air == pytest.approx(2.10, rel=5e-3)
    assert exergy == pytest.approx(407.4, rel=5e-3)


@pytest.mark.parametrize("ambient", [1e5, 101325.0])
def test_the_simulation_agrees(ambient: float) -> None:
    text = circuit_text(ambient)
    one = poppet.loads(text).simulate(0.5 + PERIOD).figures
    two = poppet.loads(text).simulate(0.5 + 2.0 * PERIOD).figures
    air, exergy = double_stroke(ambient)
    for found in (1e3 * one.air_used, 1e3 * (two.air_used - one.air_used)):
        assert found == pytest.approx(air, rel=5e-3)
        assert found == pytest.approx(AIR_L_ANR, rel=5e-3)
    for found in (one.exergy, two.exergy - one.exergy):
        assert found == pytest.approx(exergy, rel=5e-3)
        assert found == pytest.approx(EXERGY_J, rel=5e-3)

"""Measured regulators and proportional valves: a circuit against linear baselines, on segments that it has not seen.

Proportional solenoid: RespiraWorks/Ventilator sample data (Apache-2.0). All are read in place.
"""

from __future__ import annotations

from pathlib import Path

import pytest

from poppet.identify import Result, identify_fit
from poppet.identify.baselines import ARX, FIRST_ORDER, GREY_BOX, Score, baselines
from poppet.identify.fit_file import read_fit_file

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT.parent / "shared" / "data"
EXAMPLES = ROOT / "examples" / "regulators"
pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the measured data are not beside this checkout")


def judged(fit: str, commands: dict[str, str]) -> tuple[Result, list[Score]]:
    path = EXAMPLES / fit
    result = identify_fit(path)
    return result, baselines(read_fit_file(path), commands, result)


@pytest.fixture(scope="module")
def lungs() -> dict[int, tuple[Result, list[Score]]]:
    return {n: judged(f"fit_test_lung_{n}.toml", {"airway.pressure": "inhale.stroke"}) for n in (1, 5)}


@pytest.mark.parametrize("recording", [1, 5])
def test_a_proportional_solenoid_is_better_than_both_baselines_on_held_out_breaths(lungs, recording):
    held = {s.model: s.nrmse for s in lungs[recording][1] if s.held_out}
    assert held[GREY_BOX] < 0.035
    assert held[GREY_BOX] < 0.65 * min(held[FIRST_ORDER], held[ARX])


def test_two_recordings_at_different_lungs_find_the_same_valves(lungs):
    first, second = (lungs[n][0].parameters for n in (1, 5))
    for name in ("exhale.sonic_conductance", "inhale.characteristic.sonic_conductance.y4"):
        assert second[name].value == pytest.approx(first[name].value, rel=0.1)

"""Measured regulators and proportional valves: a circuit against linear baselines, on segments that it has not seen.

Regulators: ASU-RISE-Lab/4-chamber-softarm-control (MIT). Proportional solenoid: RespiraWorks/Ventilator sample data
(Apache-2.0). All are read in place.
"""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from poppet.identify import Result, Score, baselines, identify_fit, read_fit_file
from poppet.identify.baselines import ARX, FIRST_ORDER, GREY_BOX

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT.parent / "shared" / "data"
EXAMPLES = ROOT / "examples" / "regulators"
pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the measured data are not beside this checkout")
COMMANDS = {"itv0050": {"arm.pressure": "controller.setpoint"}, "test_lung": {"airway.pressure": "inhale.stroke"}}
FITS = {"itv0050": (1, 2, 4, 5), "test_lung": (1, 5)}
EVERY_DAY = (1,)
"""Of each bench; the others are as long, and no different in kind."""
WORST = {1: 0.072, 2: 0.052, 4: 0.030, 5: 0.035}
"""Largest NRMSE of each channel of the regulators over its held-out windows."""


@cache
def judged(bench: str, number: int) -> tuple[Result, list[Score]]:
    path = EXAMPLES / f"fit_{bench}_{number}.toml"
    result = identify_fit(path)
    return result, baselines(read_fit_file(path), COMMANDS[bench], result)


def windows(bench: str, number: int) -> list[dict[str, float]]:
    """NRMSE by model of every held-out window."""
    scores = [s for s in judged(bench, number)[1] if s.held_out]
    names = dict.fromkeys(s.response for s in scores)
    return [{s.model: s.nrmse for s in scores if s.response == name} for name in names]


def recordings(bench: str) -> list[Any]:
    return [pytest.param(n, marks=[pytest.mark.slow] * (n not in EVERY_DAY)) for n in FITS[bench]]


@pytest.mark.parametrize("channel", recordings("itv0050"))
def test_a_regulator_is_better_than_both_baselines_in_every_held_out_window(channel):
    held = windows("itv0050", channel)
    assert len(held) == (4 if channel in (2, 5) else 2)
    for scores in held:
        assert scores[GREY_BOX] < WORST[channel]
        assert scores[GREY_BOX] < 0.65 * min(scores[FIRST_ORDER], scores[ARX])


@pytest.mark.slow
def test_regulators_fitted_apart_have_the_same_venting_valve():
    found = [judged("itv0050", n)[0].parameters["vent.sonic_conductance"].value for n in FITS["itv0050"]]
    assert max(found) / min(found) < 1.2


@pytest.mark.parametrize("recording", recordings("test_lung"))
def test_a_proportional_solenoid_is_better_than_both_baselines_on_held_out_breaths(recording):
    (held,) = windows("test_lung", recording)
    assert held[GREY_BOX] < 0.035
    assert held[GREY_BOX] < 0.65 * min(held[FIRST_ORDER], held[ARX])


@pytest.mark.slow
def test_two_recordings_at_different_lungs_find_the_same_valves():
    first, second = (judged("test_lung", n)[0].parameters for n in FITS["test_lung"])
    for name in ("exhale.sonic_conductance", "inhale.characteristic.sonic_conductance.y4"):
        assert second[name].value == pytest.approx(first[name].value, rel=0.1)


@pytest.mark.slow
def test_the_documented_scores_are_those_that_come_out():
    text = (ROOT / "docs" / "regulators.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\|.*\| \*\*([\d.]+) %\*\* \| ([\d.]+) % \| ([\d.]+) % \|$", text, re.MULTILINE)
    shown = [[float(cell) for cell in row] for row in rows]
    scores = [s for bench, numbers in FITS.items() for n in numbers for s in judged(bench, n)[1]]
    columns = [[100.0 * s.nrmse for s in scores if s.model == model] for model in (GREY_BOX, FIRST_ORDER, ARX)]
    assert shown == [pytest.approx(row, rel=0.05) for row in zip(*columns, strict=True)]


@pytest.mark.slow
@pytest.mark.parametrize(("bench", "number"), [(bench, n) for bench, numbers in FITS.items() for n in numbers])
def test_other_places_are_no_better(bench, number, tmp_path):
    """The fit files save the rounds of new places; with these the search ends at the same misfit."""
    text = (EXAMPLES / f"fit_{bench}_{number}.toml").read_text(encoding="utf-8")
    for path in re.findall(r'"([^"]+\.(?:csv|toml))"', text):
        text = text.replace(f'"{path}"', f'"{(EXAMPLES / path).resolve().as_posix()}"')
    (tmp_path / "fit.toml").write_text(text.replace("kicks = 0", "kicks = 3"), encoding="utf-8")
    again, first = identify_fit(tmp_path / "fit.toml"), judged(bench, number)[0]
    assert again.conditions["kicks"] == 3
    for name, found in again.residuals.items():
        if name.startswith("seen."):
            assert found.rms == pytest.approx(first.residuals[name].rms, rel=0.03)

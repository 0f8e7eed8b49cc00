"""Measured regulators and proportional valves: a circuit against linear baselines, on segments that it has not seen.

Regulators: ASU-RISE-Lab/4-chamber-softarm-control (MIT). Proportional solenoid: RespiraWorks/Ventilator sample data
(Apache-2.0). All are read in place.
"""

from __future__ import annotations

import importlib.util
import os
import re
from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import load
from poppet.identify import Result, Score, baselines, identify_fit, read_fit_file
from poppet.identify.baseline_models import ARX, FIRST_ORDER, GREY_BOX
from poppet.signals import Constant

ROOT = Path(__file__).resolve().parents[2]
DATA = ROOT.parent / "shared" / "data"
EXAMPLES = ROOT / "examples" / "regulators"
pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the measured data are not beside this checkout")
COPY = os.environ.get("POPPET_SOFTARM")
"""A copy of the repository of the regulators, with its recordings of other days."""
PSI = 6894.757293168
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


def in_place(bench: str, number: int) -> str:
    """The text of a fit file with paths that hold everywhere."""
    text = (EXAMPLES / f"fit_{bench}_{number}.toml").read_text(encoding="utf-8")
    return re.sub(r'"([^"]+\.(?:csv|toml))"', lambda m: f'"{(EXAMPLES / m[1]).resolve().as_posix()}"', text)


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


def test_the_supply_of_the_circuit_lies_above_every_pressure_that_was_recorded():
    """27 psi, once assumed, is 12.3 psi gauge; recordings of other days hold 15 and show 19.4."""
    circuit = load(EXAMPLES / "itv0050.toml")
    ambient, supply = circuit.surroundings.pressure, float(circuit.numbers()["supply.pressure"])
    assert supply > ambient + 19.4 * PSI
    held = replace(circuit, signals={"controller.setpoint": Constant(ambient + 15.0 * PSI)}).simulate("5 s")
    assert held["arm.pressure"][-1] == pytest.approx(ambient + 15.0 * PSI, abs=0.3 * PSI)


@pytest.mark.slow
def test_the_supply_is_not_determined(tmp_path):
    """Free, it runs to the least that the data allow; nearly three times as much fits nearly as well."""
    text = in_place("itv0050", 4)
    found = {}
    for name, address in (("free", None), ("high", "100 psi")):
        more = f'"supply.pressure" = "{address}", ' if address else ""
        changed = text.replace("set = { ", f"set = {{ {more}")
        if address is None:
            changed += '"supply.pressure" = { start = "45 psi", min = "34.1 psi", max = "150 psi" }\n'
        (tmp_path / f"{name}.toml").write_text(changed, encoding="utf-8")
        found[name] = identify_fit(tmp_path / f"{name}.toml")
    assert found["free"].parameters["supply.pressure"].verdict == "at bound"
    rms = {name: result.residuals["seen.arm.pressure"].rms for name, result in found.items()}
    assert rms["free"] < rms["high"] < 1.1 * rms["free"]


def days() -> Any:
    spec = importlib.util.spec_from_file_location("regulator_days", EXAMPLES / "days.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def copied(folder: Path, names: dict[str, str], *, height: float = 1.0) -> Path:
    """Recordings in the columns of their repository: time, three commands, three pressures, and so once more."""
    for source, place in names.items():
        rows = np.loadtxt(DATA / "regulator_itv0050" / f"{source}.csv", delimiter=",", skiprows=1)
        rows[:, 1:7] = 1.0 + height * (rows[:, 1:7] - 1.0)
        path = folder / place
        path.parent.mkdir(parents=True, exist_ok=True)
        np.savetxt(path, rows[:, [0, 1, 2, 3, 7, 8, 9, 4, 5, 6, 10, 11, 12]], delimiter=",")
    return folder


def test_files_of_other_days_are_found_once_and_only_where_a_channel_moves(tmp_path):
    places = {"jan10-2_1": "Jan 10-2/data_collect_1.txt", "jan10-3_1": "Jan 10-3/data_collect_1.txt"}
    copied(tmp_path, places)
    copied(tmp_path, {"jan10-2_1": "Jan 19 ml train/data_collect_3.txt"})  # the fitted one again
    copied(tmp_path, {"jan10-3_1": "apr 4/data_collect_1.txt"}, height=2.0)
    found = {k: {day: len(paths) for day, paths in days().recordings(tmp_path, k).items()} for k in (1, 2, 5)}
    assert found == {1: {}, 2: {"10 Jan, 5 psi": 1, "4 Apr, 9 psi": 1}, 5: {"10 Jan, 10 psi": 1, "4 Apr, 19 psi": 1}}


@pytest.mark.slow
def test_another_recording_of_the_same_day_comes_out_as_documented(tmp_path):
    """By the way of `days.py`; the repository of the recordings has two more of this kind."""
    copied(tmp_path, {"jan10-3_1": "Jan 10-3/data_collect_1.txt"})
    scores, anew = days().judged(5, days().recordings(tmp_path, 5))
    (day,) = scores
    found = {s.model: s.nrmse for s in scores[day]}
    assert found[GREY_BOX] == pytest.approx(0.0176, rel=0.05)
    assert found[GREY_BOX] < 0.25 * min(found[FIRST_ORDER], found[ARX])
    assert anew[day][0] <= found[GREY_BOX]


@pytest.mark.slow
@pytest.mark.skipif(COPY is None, reason="POPPET_SOFTARM names no copy of the repository of these recordings")
@pytest.mark.parametrize("channel", FITS["itv0050"])
def test_the_documented_scores_of_other_days_are_those_that_come_out(channel):
    text = (EXAMPLES / "days.csv").read_text(encoding="utf-8")
    rows = re.findall(rf"^{channel},.*$", text, re.MULTILINE)
    module = days()
    scores, anew = module.judged(channel, module.recordings(Path(COPY), channel))
    assert [", ".join(row.split(",")[1:3]) for row in rows] == list(scores)
    for told, row in zip(rows, module.rows(channel, scores, anew), strict=True):
        numbers = [[float(n) for n in re.findall(r"\d+(?:\.\d+)?", text)] for text in (told, row)]
        assert numbers[0] == pytest.approx(numbers[1], rel=0.1, abs=0.1)


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
    (tmp_path / "fit.toml").write_text(in_place(bench, number).replace("kicks = 0", "kicks = 3"), encoding="utf-8")
    again, first = identify_fit(tmp_path / "fit.toml"), judged(bench, number)[0]
    assert again.conditions["kicks"] == 3
    for name, found in again.residuals.items():
        if name.startswith("seen."):
            assert found.rms == pytest.approx(first.residuals[name].rms, rel=0.03)

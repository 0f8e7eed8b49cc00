"""Tests of `poppet simulate`: options, files, summaries and failures."""

from __future__ import annotations

import dataclasses
import io
import itertools
import re
import sys
from pathlib import Path

import numpy as np
import pytest

import poppet as house
from poppet.cli.progress import RunProgress
from poppet.core.note_groups import grouped
from poppet.engine.problem import Outcome
from poppet.engine.solve import run_kernel

DRAIN = """
[parts.tank]
kind = "chamber"
volume = "1 l"

[parts.pump]
kind = "flow_source"
to = "tank"
mass_flow_rate = "-1 g/s"

[run]
duration = "10 s"
"""


@pytest.fixture
def drain(tmp_path):
    """A pump draws an empty tank: no run can reach its end."""
    path = tmp_path / "drain.toml"
    path.write_text(DRAIN)
    return path


def test_the_summary_shows_outcome_outputs_balances_and_steps(poppet, tanks):
    code, out, err = poppet("simulate", "tanks.toml")
    assert (code, err) == (0, "")
    assert out.startswith("Two tanks\nThe run is complete.\n\n11 rows, 11 series, 0 ... 5 s\nseries ")
    assert "4 checked, all within limits" in out
    assert "Steps: " in out
    rows = [line.split() for line in out.splitlines()]
    assert ["high.pressure", "bar", "7", "5.3237", "5.3237", "7"] in rows


def test_an_output_file_contains_the_recording(poppet, tanks, tmp_path):
    code, out, _ = poppet("simulate", "tanks.toml", "-o", "out.csv")
    assert (code, out) == (0, "out.csv: 11 rows, 11 series, 0 ... 5 s. The run is complete.\n")
    read, run = house.Recording.read("out.csv"), house.load(tanks).simulate()
    assert read.names == run.names
    assert np.array_equal(read.values, run.values)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["out.csv", "tanks.toml"]


@pytest.mark.parametrize("suffix", ["csv", "parquet", "mat"])
def test_all_formats(poppet, tanks, suffix):
    if suffix == "parquet":
        pytest.importorskip("pyarrow")
    assert poppet("simulate", "tanks.toml", "-o", f"out.{suffix}").code == 0
    assert house.Recording.read(f"out.{suffix}").time[-1] == 5.0


@pytest.mark.parametrize("given", ["20 l", '"20 l"', "'20 l'", "0.02", " 20 l "])
def test_set_takes_text_with_unit_quotes_and_bare_numbers(poppet, tanks, given):
    assert poppet("simulate", "tanks.toml", "--set", f"high.volume={given}", "-o", "out.csv").code == 0
    mass = house.Recording.read("out.csv")["high.mass"][0]
    assert mass == pytest.approx(7e5 * 0.02 / (287.05 * 293.15), rel=1e-12)


def test_set_changes_options_and_the_run(poppet, tanks):
    changes = (
        "--set",
        "high.thermal=isothermal",
        "--set",
        "run.duration=2 s",
        "--set",
        "ambient.pressure=0.9 bar",
    )
    assert poppet("simulate", "tanks.toml", *changes, "-o", "out.csv").code == 0
    recording = house.Recording.read("out.csv")
    assert recording.time[-1] == 2.0
    assert np.ptp(recording["high.temperature"]) == 0.0
    assert recording["high.pressure"][0] == pytest.approx(6.9e5, rel=1e-12)


def test_missing_matplotlib_is_reported_before_the_run(poppet, tanks, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    monkeypatch.setattr("poppet.engine.solve.solve", lambda *_: pytest.fail("it ran"))
    answer = poppet("simulate", "tanks.toml", "-o", "out.csv", "--plot", "out.png")
    assert (answer.code, answer.codes) == (2, ["missing.package"])
    assert not Path("out.csv").exists()


def test_set_on_a_driven_input_replaces_its_signal_with_a_note(poppet, tanks):
    code, _, err = poppet("simulate", "tanks.toml", "--set", "hole.opening=0.5", "-o", "out.csv")
    assert (code, err) == (
        0,
        "note: hole.opening is set to 0.5 by this command, "
        "so the signal of hole.opening in the circuit file is not used.\n",
    )
    assert set(house.Recording.read("out.csv")["hole.opening"]) == {0.5}


def test_run_options(poppet, tanks):
    options = (
        "--duration",
        "3 s",
        "--output-step",
        "250 ms",
        "--tolerance",
        "1e-9",
        "--solver",
        "rosenbrock",
    )
    code, _, err = poppet("simulate", "tanks.toml", *options, "-o", "out.csv")
    assert (code, err) == (0, "")
    assert np.array_equal(house.Recording.read("out.csv").time, np.arange(13) * 0.25)


def test_a_bare_duration_is_in_seconds(poppet, tanks):
    poppet("simulate", "tanks.toml", "--duration", "3", "-o", "out.csv")
    assert house.Recording.read("out.csv").time[-1] == 3.0


def test_stop_conditions_add_up(poppet, tanks):
    late, early = "low.pressure > 9 bar", "high.pressure < 6 bar g"
    code, out, _ = poppet("simulate", "tanks.toml", "--stop-when", late, "--stop-when", "high.pressure < 6 bar")
    assert code == 0
    assert "A stop condition was met: high.pressure < 6 bar at t = " in out
    tanks.write_text(tanks.read_text() + f'stop_when = "{early}"\n')
    _, out, _ = poppet("simulate", "tanks.toml", "--stop-when", late)
    assert f"A stop condition was met: {early} at t = 1" in out


def test_notes_go_to_stderr(poppet, tanks):
    code, out, err = poppet("simulate", "tanks.toml", "--duration", "0.5 s", "--quiet")
    assert (code, out) == (0, "")
    assert err == (
        "note: hole.opening: 1 of 2 steps have no effect, because they are at or after the end of the run, t = 0.5 s.\n"
    )


MISSING = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.valve]
kind = "proportional_valve"
data = "vppm_6l"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
[parts.tank]
kind = "chamber"
volume = "20 l"
[signals."valve.setpoint"]
kind = "steps"
times = [0.0, 0.1, 0.2, 0.3, 0.4, 0.5]
values = ["5 bar", "2 bar", "5 bar", "2 bar", "5 bar", "2 bar"]
[run]
duration = "0.6 s"
output_step = "1 ms"
"""


def test_one_note_reports_all_missed_steps(poppet, tmp_path):
    (tmp_path / "missing.toml").write_text(MISSING)
    code, _, err = poppet("simulate", "missing.toml", "-o", "out.parquet")
    notes = [note for note in house.Recording.read("out.parquet").remarks if note.code == "valve.not_reached"]
    assert (code, len(notes)) == (0, 6)
    (sentence,) = grouped(notes)
    assert (sentence.facts["more"], sentence.facts["size"]) == (5, max(note.facts["missed_bar"] for note in notes))
    assert err == f"note: {sentence}\n"


def test_select_and_units_apply_to_the_file(poppet, tanks):
    options = ("--select", "*.pressure,hole.mass_flow_rate", "--units", "bar,low.pressure=kPa,l/min ANR")
    assert poppet("simulate", "tanks.toml", *options, "-o", "out.csv").code == 0
    recording = house.Recording.read("out.csv")
    assert dict(zip(recording.names, recording.units, strict=True)) == {
        "high.pressure": "bar",
        "low.pressure": "kPa",
        "hole.mass_flow_rate": "l/min ANR",
    }
    assert recording["high.pressure"][0] == pytest.approx(7.0, rel=1e-12)


def test_start_from_continues_a_run(poppet, tanks):
    poppet("simulate", "tanks.toml", "--set", "hole.opening=1", "--duration", "2 s", "-o", "first.csv")
    code, _, _ = poppet(
        "simulate",
        "tanks.toml",
        "--set",
        "hole.opening=1",
        "--start-from",
        "first.csv",
        "--duration",
        "3 s",
        "-o",
        "next.csv",
    )
    assert code == 0
    poppet("simulate", "tanks.toml", "--set", "hole.opening=1", "-o", "whole.csv")
    parts, uninterrupted = house.Recording.read("next.csv").last(), house.Recording.read("whole.csv").last()
    assert parts["high.pressure"] == pytest.approx(uninterrupted["high.pressure"], rel=1e-5)


def test_set_prevails_over_start_from(poppet, tanks):
    poppet("simulate", "tanks.toml", "-o", "first.csv")
    options = ("--start-from", "first.csv", "--set", "high.initial_pressure=3 bar", "-o", "next.csv")
    assert poppet("simulate", "tanks.toml", *options).code == 0
    first, following = house.Recording.read("first.csv"), house.Recording.read("next.csv")
    assert following["high.pressure"][0] == pytest.approx(3e5, rel=1e-12)
    assert following["low.pressure"][0] == pytest.approx(first["low.pressure"][-1], rel=1e-12)


@pytest.mark.parametrize("suffix", ["png", "svg"])
def test_plot(poppet, tanks, tmp_path, suffix):
    pytest.importorskip("matplotlib")
    code, out, _ = poppet("simulate", "tanks.toml", "-o", "out.csv", "--plot", f"out.{suffix}", "--units", "bar")
    assert code == 0
    assert out.splitlines()[1] == f"out.{suffix}: drawn."
    assert (tmp_path / f"out.{suffix}").stat().st_size > 5000


@pytest.mark.parametrize(
    ("arguments", "code", "address", "nearest"),
    [
        (("-o", "out.xlsx"), "files.suffix", "", ""),
        (("-o", "out"), "cli.output.no_suffix", "", ""),
        (("-o", "no/out.csv"), "files.no_folder", "", ""),
        (("-o", "folder.csv"), "cli.output.is_folder", "", ""),
        (("--plot", "out.jpeg"), "files.suffix", "", ".png"),
        (("--set", "high.volmue=1 l"), "names.unknown", "high.volmue", "high.volume"),
        (("--set", "hihg.volume=1 l"), "address.meant", "hihg.volume", ""),
        (("--set", "high.volume"), "cli.assignment", "", ""),
        (("--set", "high.volume="), "cli.assignment", "", ""),
        (("--set", "high.volume=1 l", "--set", "high.volume=2 l"), "cli.assigned_twice", "high.volume", ""),
        (("--set", "high.volume=1 bar"), "quantity.other_quantity", "high.volume", ""),
        (("--set", "high.volume=-1"), "fields.out_of_range", "high.volume", ""),
        (("--set", "high.volume=nan"), "quantity.not_finite", "high.volume", ""),
        (("--set", "high.initial_pressure=-2 bar g"), "numbers.below_vacuum", "high.initial_pressure", ""),
        (("--set", "high.thermal=isotermal"), "fields.not_an_option", "high.thermal", "isothermal"),
        (("--duration", "-1 s"), "fields.out_of_range", "run.duration", ""),
        (("--duration", "1 bar"), "quantity.other_quantity", "run.duration", ""),
        (("--output-step", "1e-12 s"), "options.too_many_rows", "run.output_step", ""),
        (("--tolerance", "tight"), "quantity.no_number", "run.relative_tolerance", ""),
        (("--solver", "rosenbrok"), "fields.not_an_option", "run.solver", "rosenbrock"),
        (("--stop-when", "high.presure > 5 bar"), "stop.unknown_output", "run.stop_when", "high.pressure"),
        (("--stop-when", "high.pressure"), "stop.no_condition", "run.stop_when", ""),
        (("--units", "bra"), "unit.misspelt", "", ""),
        (("--units", "V"), "series.no_such_quantity", "", ""),
        (("--units", "high.pressure=K"), "series.other_quantity", "", ""),
        (("--select", "high.presure"), "names.unknown", "high.presure", "high.pressure"),
        (("--start-from", "missing.csv"), "files.unreadable", "", ""),
    ],
)
def test_errors_are_reported_before_the_run(poppet, tanks, tmp_path, monkeypatch, arguments, code, address, nearest):
    def never(*_, **__):
        raise AssertionError("the run began")

    (tmp_path / "folder.csv").mkdir()
    monkeypatch.setattr("poppet.engine.solve.solve", never)
    answer = poppet("simulate", "tanks.toml", *arguments)
    assert (answer.code, answer.out) == (2, "")
    assert answer.errors == [(code, address, None, nearest)]
    assert sorted(path.name for path in tmp_path.iterdir()) == ["folder.csv", "tanks.toml"]


def test_all_errors_of_set_are_reported(poppet, tanks):
    changes = ("--set", "high.volume=1 bar", "--set", "low.volmue=1 l", "--set", "hole.critical_ratio=1.5")
    answer = poppet("simulate", "tanks.toml", *changes)
    assert answer.code == 2
    assert [error.address for error in answer.errors] == ["high.volume", "low.volmue", "hole.critical_ratio"]


def test_a_file_without_duration(poppet, tanks):
    tanks.write_text(tanks.read_text().replace('duration = "5 s"', ""))
    answer = poppet("simulate", "tanks.toml")
    assert (answer.code, answer.errors) == (2, [("fields.missing", "run.duration", 25, "")])
    assert answer.err.startswith("error: tanks.toml:25: ")
    assert poppet("simulate", "tanks.toml", "--duration", "1 s").code == 0


def test_a_failed_run_keeps_its_rows(poppet, drain):
    answer = poppet("simulate", "drain.toml", "-o", "out.csv")
    assert (answer.code, answer.codes) == (1, ["run.emptied.stalled"])
    assert answer.err.splitlines()[-1] == f"error: {answer.error.note}"
    assert "rows" in answer.out
    recording = house.Recording.read("out.csv")
    # 1 l at 1 bar and 20 degC holds 1.188 g, which 1 g/s draws in 1.188 s.
    assert recording.time[-1] == pytest.approx(1.188, abs=0.01)


def test_a_failed_run_without_output_still_shows_its_summary(poppet, drain):
    answer = poppet("simulate", "drain.toml")
    assert (answer.code, answer.codes) == (1, ["run.emptied.stalled"])
    assert "tank.pressure" in answer.out


def test_a_run_that_fails_at_its_start_writes_no_file(poppet, tanks, tmp_path, monkeypatch):
    def failing(problem, *_):
        run = run_kernel(problem)
        nothing = {"time": run.time[:0], "values": run.values[:, :0]}
        return dataclasses.replace(run, outcome=Outcome.NOT_FINITE, **nothing)

    monkeypatch.setattr("poppet.engine.solve.solve", failing)
    answer = poppet("simulate", "tanks.toml", "-o", "out.csv", "--plot", "out.png")
    assert answer.code == 1
    assert "not written" in answer.out
    assert [path.name for path in tmp_path.iterdir()] == ["tanks.toml"]


def test_ctrl_c_keeps_a_partial_result(poppet, tanks, monkeypatch):
    def interrupt(self, reached):
        if reached > 0.0:
            raise KeyboardInterrupt

    monkeypatch.setattr(RunProgress, "__call__", interrupt)
    long = ("--duration", "1e6 s", "--output-step", "1e3 s", "--set", "run.maximum_step=10 ms")
    answer = poppet("simulate", "tanks.toml", *long, "-o", "out.csv")
    assert (answer.code, answer.codes) == (130, ["run.ended.interrupted"])
    recording = house.Recording.read("out.csv")
    assert 0 < recording.time.size < 1001


class Terminal(io.StringIO):
    """Something that calls itself a terminal."""

    def isatty(self):
        return True


@pytest.mark.parametrize(
    ("stream", "is_quiet", "is_shown"),
    [(Terminal(), False, True), (Terminal(), True, False), (io.StringIO(), False, False)],
)
def test_a_progress_bar_appears_after_a_time_on_a_terminal(monkeypatch, stream, is_quiet, is_shown):
    clock = itertools.count(0.0, 0.4)  # the display begins after 0.6 s
    monkeypatch.setattr("sys.stderr", stream)
    monkeypatch.setattr("poppet.cli.progress.time.monotonic", lambda: next(clock))
    with RunProgress(10.0, is_quiet=is_quiet) as progress:
        progress(2.5)
        assert stream.getvalue() == ""
        monkeypatch.setattr("poppet.cli.progress.PATIENCE", 0.0)
        progress(5.0)
    assert ("5 of 10 s" in stream.getvalue()) == is_shown


def test_report(poppet, tanks, tmp_path):
    pytest.importorskip("matplotlib")
    code, out, _ = poppet("simulate", "tanks.toml", "--report", "run.html", "--select", "*.pressure", "--units", "kPa")
    assert code == 0
    assert "run.html: written." in out
    text = (tmp_path / "run.html").read_text(encoding="utf-8")
    assert "pressure [kPa, absolute]" in text
    assert poppet("simulate", "tanks.toml", "--report", "run.txt").codes == ["files.suffix"]


def test_the_summary_of_a_load_begins_with_strokes_and_energy(poppet, tmp_path):
    example = Path(__file__).parents[2] / "examples" / "cylinder_meter_out.toml"
    figures = house.load(example).simulate().figures
    done = poppet("simulate", str(example), "--report", "run.html")
    rows = [line.split() for line in done.out.splitlines()]
    strokes = [row for row in rows if row[:1] == ["slide"] and "mm/s" in row]
    assert [float(row[4]) for row in strokes] == [pytest.approx(s.duration, rel=1e-3) for s in figures.strokes]
    assert [float(row[9]) for row in strokes] == [
        pytest.approx(1e3 * abs(figures.met(s).velocity), rel=1e-3) for s in figures.strokes
    ]
    assert [float(row[11]) for row in strokes] == [pytest.approx(s.from_command, rel=1e-3) for s in figures.strokes]
    assert [row[12:] for row in strokes] == [["valve_cap.command", "at", time, "s"] for time in ("0.1", "2.1")]
    assert float(next(row for row in rows if row[:2] == ["air", "used"])[2]) == pytest.approx(
        1e3 * figures.air_used, rel=1e-3
    )
    page = (tmp_path / "run.html").read_text(encoding="utf-8")
    assert f"{1e3 * figures.air_used:.4g} l ANR" in page
    written = poppet("simulate", str(example), "-o", "run.csv")
    assert "efficiency" in written.out


def test_the_diagram_of_a_step_sequence_is_drawn(poppet, tmp_path):
    example = Path(__file__).parents[2] / "examples" / "two_cylinders.toml"
    answer = poppet("simulate", str(example), "--duration", "0.4 s", "--diagram", "steps.svg")
    assert answer.code == 0
    assert "steps.svg: drawn." in answer.out
    assert (tmp_path / "steps.svg").read_text(encoding="utf-8").startswith("<?xml")


def test_a_circuit_without_a_sequence_has_no_diagram(poppet, tmp_path):
    (tmp_path / "drain.toml").write_text(DRAIN)
    answer = poppet("simulate", "drain.toml", "--diagram", "steps.svg")
    assert (answer.code, answer.codes) == (2, ["drawing.no_sequence"])
    assert not (tmp_path / "steps.svg").exists()


def test_cells_of_a_tube_are_one_row_of_the_summary(poppet):
    """Minimum and maximum are those of all cells; --all prints each cell."""
    assert poppet("new", "drive-sizing").code == 0
    short, complete = (poppet("simulate", "drive-sizing.toml", *options).out for options in ((), ("--all",)))
    assert "tube_cap.2.pressure" not in short
    cells = [line.split() for line in complete.splitlines() if re.match(r"tube_cap\.\d\.pressure ", line)]
    assert len(cells) == 4
    (row,) = [line.split() for line in short.splitlines() if line.startswith("tube_cap.1 ... 4.pressure ")]
    assert [float(value) for value in row[-2:]] == [min(float(c[-2]) for c in cells), max(float(c[-1]) for c in cells)]

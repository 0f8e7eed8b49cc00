"""The report on Varga & Keski-Honkola 2012: its numbers against independent ones, its verdicts, its files."""

from __future__ import annotations

import csv
import dataclasses
import io
import json
import re
import sys
import xml.etree.ElementTree as ElementTree
from collections import Counter
from pathlib import Path

import numpy as np
import pytest

from pages import needs_nothing_else, plots
from poppet import library, load
from poppet.core.errors import InputError, MissingDependencyError
from poppet.report.varga2012 import runs
from poppet.report.varga2012.paper import PaperResult, Verdict, figure_3, figure_4, figure_6, statements, write_paper
from poppet.report.varga2012.paper_circuits import write_circuits
from poppet.report.varga2012.runs import STROKES, SUPPLIES
from poppet.timeseries.plotting.figures import style
from poppet.timeseries.signals import Steps

# Computed once from the equations of the paper, apart from this package.
TABLE_C = (0.50034, 0.9211, 1.3390, 1.5595, 1.6358, 1.65010, 1.6401, 1.6114, 1.5746, 1.5493, 1.47354)
TABLE_B = (0.71748, 0.5125, 0.4157, 0.3886, 0.4003, 0.42740, 0.4541, 0.4723, 0.4814, 0.4884, 0.50788)
TIMES = {"isothermal": 71.11, "isentrope": 38.22, "adiabatic": 50.79, "wall 30": 63.51, "wall 100": 68.32}
PEAK_WALLS, END_WALLS = (42.4, 46.3, 54.1), (30.8, 38.5, 50.3)
FIGURES = ("fig3", "fig4", "fig6", "circuit")


@pytest.fixture(scope="module")
def told() -> list[str]:
    """Steps that were named while the report was made."""
    return []


@pytest.fixture(scope="module")
def result(tmp_path_factory, told) -> PaperResult:
    return write_paper(tmp_path_factory.mktemp("paper") / "report", told.append)


@pytest.fixture(scope="module")
def page(result) -> str:
    return (result.folder / "report.html").read_text(encoding="utf-8")


# --- numbers ---


def test_conductance_and_ratio_at_eleven_strokes(result):
    assert 1e8 * np.array(result.findings.conductances) == pytest.approx(TABLE_C, abs=5.1e-5)
    assert result.findings.ratios == pytest.approx(TABLE_B, abs=5.1e-5)


def test_extremes_of_the_polynomials(result):
    found = result.findings
    assert found.largest == pytest.approx((0.49901e-3, 1.650097e-8), rel=1e-5)
    assert found.smallest_ratio == pytest.approx((0.30863e-3, 0.38848), rel=1e-5)
    assert 1.0 - found.conductances[-1] / found.largest[1] == pytest.approx(0.107, abs=5e-4)
    assert found.conductance_beyond == pytest.approx(-1.16e-8, rel=5e-3)
    assert found.suspected_largest == pytest.approx(1.88e-8, rel=5e-3)


@pytest.mark.parametrize("law", TIMES)
def test_times_to_five_bar(result, law):
    assert result.findings.fillings[law].time == pytest.approx(TIMES[law], rel=1e-3)


@pytest.mark.parametrize(("law", "end"), [("isothermal", 293.15), ("adiabatic", 380.009), ("isentrope", 464.3)])
def test_final_temperatures(result, law, end):
    assert abs(result.findings.fillings[law].end_temperature - end) <= 0.1


def test_wall_conductances_that_explain_the_reported_rise(result):
    walls = result.findings.walls
    assert tuple(wall.supply for wall in walls) == SUPPLIES
    assert [wall.for_peak for wall in walls] == pytest.approx(PEAK_WALLS, rel=5e-3)
    assert [wall.for_end for wall in walls] == pytest.approx(END_WALLS, rel=5e-3)
    assert all(32.5 <= wall.peak_time <= 35.5 for wall in walls)


def test_polytropic_exponent_of_the_reported_rise(result):
    assert abs(result.findings.exponent - 1.0 / (1.0 - np.log(311.15 / 293.15) / np.log(5.0))) <= 1e-5
    assert result.findings.exponent == pytest.approx(1.038, abs=5e-4)


def test_pressure_after_closing_falls_to_that_of_the_wall_temperature(result):
    end = result.findings.fillings["wall of the peak"].end_temperature
    assert abs(result.findings.pressure_drop - 5e5 * (1.0 - 293.15 / end)) <= 1.0


def test_main_stage(result):
    found = result.findings
    assert found.stroke_printed == pytest.approx(0.482e-3, rel=1e-3)
    assert found.exhaust_strokes == pytest.approx((-2e-5,) * 3, abs=1e-9)
    assert found.open_end == pytest.approx((7e5, 7e5), rel=1e-6)
    assert found.leak == pytest.approx(5.0034e-9 * 7e5 * 1.185, rel=1e-9)


def test_every_tank_of_figure_6_follows_the_required_value(result):
    run = result.findings.staircase
    assert (run.time[0], run.time[-1]) == (0.0, 120.0)
    for law in ("isentrope", "adiabatic", "wall", "isothermal"):
        for end, value in ((29.9, 2e5), (59.9, 3e5), (89.9, 4e5), (120.0, 5e5)):
            assert abs(run.interpolate(f"{law}.pressure", end) - value) <= 200.0


def test_the_order_of_the_tanks_is_that_of_the_heat_they_lose(result):
    at_ten = [float(result.findings.staircase.interpolate(f"{law}.pressure", 10.0)) for law in
              ("isentrope", "adiabatic", "wall", "isothermal")]  # fmt: skip
    assert at_ten == sorted(at_ten, reverse=True)


# --- verdicts ---


def verdict(checked, name: str) -> Verdict:
    (found,) = [one.verdict for one in checked if one.code == f"paper.{name}"]
    return found


@pytest.mark.parametrize(
    ("name", "expected"),
    [
        ("law", Verdict.HOLDS),
        ("downstream", Verdict.FAILS),
        ("range", Verdict.HOLDS),
        ("nonlinear", Verdict.HOLDS),
        ("drawn", Verdict.OPEN),
        ("closing", Verdict.FAILS),
        ("emptying", Verdict.HOLDS),
        ("fig5", Verdict.FAILS),
        ("following", Verdict.FAILS),
        ("slow", Verdict.HOLDS),
        ("faster", Verdict.OPEN),
        ("warming", Verdict.FAILS),
        ("no_heat", Verdict.FAILS),
        ("measured_slower", Verdict.HOLDS),
        ("heat", Verdict.HOLDS),
        ("polytropic", Verdict.HOLDS),
        ("precise", Verdict.HOLDS),
        ("staircase", Verdict.HOLDS),
        ("works_well", Verdict.OPEN),
    ],
)
def test_verdicts(result, name, expected):
    assert verdict(result.statements, name) is expected


def test_verdicts_follow_the_numbers(result):
    found = result.findings
    warm = dataclasses.replace(found.fillings["isentrope"], end_temperature=293.15 + 20.0, time=80.0)
    other = dataclasses.replace(
        found,
        fillings=found.fillings | {"isentrope": warm},
        open_end=(2e5, 5e5),
        stroke_fig5=found.stroke_printed,
        law_deviation=1e-3,
        exhaust_strokes=(-2e-5, -1e-5, 0.0),
    )
    changed = tuple(statements(other))
    assert verdict(changed, "warming") is Verdict.HOLDS
    assert verdict(changed, "following") is Verdict.HOLDS
    assert verdict(changed, "fig5") is Verdict.HOLDS
    assert verdict(changed, "measured_slower") is Verdict.FAILS
    assert verdict(changed, "law") is Verdict.FAILS
    assert verdict(changed, "emptying") is Verdict.FAILS


def test_every_finding_is_a_sentence_with_a_place(result):
    for one in result.statements:
        assert one.finding.endswith(".")
        assert re.search(r"section|abstract|fig\.", one.place)
        assert "nan" not in one.finding


# --- figures ---


def test_figures_have_the_axes_of_the_paper(result):
    with style("test"):
        third, fourth, sixth = figure_3(), figure_4(), figure_6(result.findings)
    assert (*third.axes[0].get_xlim(), *third.axes[0].get_ylim()) == (0.0, 1.0, 0.4, 2.0)
    assert (*fourth.axes[0].get_xlim(), *fourth.axes[0].get_ylim()) == (0.0, 1.0, 0.35, 0.75)
    assert (*sixth.axes[0].get_xlim(), *sixth.axes[0].get_ylim()) == (0.0, 120.0, 1.0, 5.5)


def test_figure_3_shows_the_table_and_the_doubtful_digit_as_a_hypothesis(result):
    with style("test"):
        axes = figure_3().axes[0]
    (points,) = [line for line in axes.lines if line.get_marker() == "o"]
    assert points.get_xdata() == pytest.approx([1e3 * x for x in STROKES])
    assert points.get_ydata() == pytest.approx(TABLE_C, abs=5.1e-5)
    assert any("hypothesis" in text.get_text() for text in axes.texts)


def test_figure_6_names_every_tank(result):
    with style("test"):
        legend = figure_6(result.findings).axes[0].get_legend()
    labels = [text.get_text() for text in legend.get_texts()]
    assert labels[0] == "required value"
    assert len(labels) == 5


# --- files ---


def test_all_files_are_there(result):
    names = {path.name for path in result.folder.iterdir()}
    tables = {f"{name}.csv" for name in ("strokes", "tank_laws", "wall_conductances", "statements", "fig6")}
    pictures = {f"{name}.{suffix}" for name in FIGURES for suffix in ("svg", "png")}
    assert names == {"report.html", "results.json"} | tables | pictures
    assert {path.name for path in result.files} == names
    assert result.files[0].name == "report.html"


def test_the_page_needs_nothing_else(page):
    needs_nothing_else(page)


def test_the_page_opens_with_a_headline_and_the_three_figures(result, page):
    body = page[page.index("<main>") :]
    counts = Counter(one.verdict for one in result.statements)
    headline = body[: body.index("</p>", body.index('class="headline"'))]
    assert [int(n) for n in re.findall(r"\b\d+\b", headline.rpartition(">")[2])] == [
        len(result.statements), counts[Verdict.HOLDS], counts[Verdict.FAILS], counts[Verdict.OPEN],
    ]  # fmt: skip
    places = [body.index(f'id="{name}-') for name in ("fig3", "fig4", "fig6")]
    assert body.index('class="headline"') < places[0] < places[1] < places[2] < body.index('class="verdict')
    assert len(plots(page)) == 3


def test_marks_inside_the_page_are_unique_and_resolve(page):
    marks = re.findall(r' id="([^"]+)"', page)
    assert len(marks) == len(set(marks))
    assert set(re.findall(r'href="#([^"]+)"', page)) <= set(marks)
    assert set(re.findall(r"url\(#([^)]+)\)", page)) <= set(marks)


def test_the_page_is_well_formed_and_says_everything(page, result):
    body = page[page.index("<main>") : page.index("</main>")] + "</main>"
    text = " ".join("".join(ElementTree.fromstring(body).itertext()).split())
    for one in result.statements:
        assert " ".join(one.finding.split()) in text
    assert "so only the axes and statements can be compared" in text
    assert "therefore uses the regulator mode" in text
    assert page.count("<svg") == len(FIGURES)


def test_results_hold_all_digits(result):
    read = json.loads((result.folder / "results.json").read_text(encoding="utf-8"))
    assert read["tank_laws"]["isothermal"]["time"] == result.findings.fillings["isothermal"].time
    assert read["numbers"]["exponent"] == result.findings.exponent
    assert {one["verdict"] for one in read["statements"]} == {verdict.value for verdict in Verdict}


def test_tables_can_be_read_back(result):
    for name, table in result.tables.items():
        rows = list(csv.reader(io.StringIO((result.folder / f"{name}.csv").read_text(encoding="utf-8"))))
        assert rows[0] == table.headings
        assert len(rows) == len(table.rows) + 1
    strokes = np.loadtxt(result.folder / "strokes.csv", delimiter=",", skiprows=1)
    assert tuple(1e-8 * strokes[:, 1]) == pytest.approx(result.findings.conductances, rel=1e-15)


def test_the_terminal_shows_tables_and_verdicts(result):
    text = result.table()
    assert re.search(r"isothermal +71\.11 +1\.86 +293\.15", text)
    assert re.search(r"7\.0 +54\.1 +34\.\d +50\.3", text)
    assert text.count("does not hold") == sum(one.verdict is Verdict.FAILS for one in result.statements)
    assert text.endswith("report.html")


def test_the_report_is_the_same_every_time(result, tmp_path):  # the runs, and every byte of figures and tables
    again = write_paper(tmp_path)
    for path in again.files:
        assert path.read_bytes() == (result.folder / path.name).read_bytes(), path.name


def test_progress_is_told(told, result):
    assert told[0] == "tank laws"
    assert "figure 6, isentrope" in told


def test_a_file_in_the_way_is_named(tmp_path):
    (tmp_path / "paper").write_text("mine")
    with pytest.raises(InputError) as caught:
        write_paper(tmp_path / "paper")
    assert caught.value.code == "paper.folder"
    assert (tmp_path / "paper").read_text() == "mine"


def test_without_the_drawing_package_nothing_is_begun(monkeypatch, tmp_path):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(MissingDependencyError) as caught:
        write_paper(tmp_path / "paper")
    assert caught.value.facts["package"] == "matplotlib"
    assert not Path(tmp_path / "paper").exists()


# --- circuits ---


@pytest.fixture(scope="module")
def circuits(tmp_path_factory):
    """Circuits that the command writes, by name."""
    folder = tmp_path_factory.mktemp("circuits")
    return {path.stem: load(path) for path in write_circuits(folder)}


def test_the_circuits_are_those_of_figures_3_to_6(circuits):
    assert [*circuits] == ["figure3", "figure4", "figure5", "figure6"]


def test_circuit_of_figure_3_gives_the_curve_and_the_table(circuits, result):
    run = circuits["figure3"].simulate()
    stroke, conductance = run["valve.stroke"], run["valve.mass_flow_rate"] / (7e5 * 1.185)
    drawn = library.characteristic("varga2012").sonic_conductance_at(stroke)
    assert conductance == pytest.approx(drawn, rel=1e-12)
    assert np.interp(STROKES, stroke, conductance) == pytest.approx(result.findings.conductances, rel=1e-12)


def test_circuit_of_figure_4_gives_the_curve_and_the_table(circuits, result):
    run = circuits["figure4"].simulate()
    stroke = run["subsonic.stroke"]
    square = 1.0 - (run["subsonic.mass_flow_rate"] / run["choked.mass_flow_rate"]) ** 2
    ratio = (0.8 - np.sqrt(square)) / (1.0 - np.sqrt(square))
    assert ratio == pytest.approx(library.characteristic("varga2012").critical_ratio_at(stroke), rel=1e-9)
    assert np.interp(STROKES, stroke, ratio) == pytest.approx(result.findings.ratios, rel=1e-9)


def test_circuit_of_figure_5_is_the_block_diagram(circuits, result):
    run = circuits["figure5"].simulate()
    assert run["valve.stroke"][-1] == pytest.approx(result.findings.stroke_printed, rel=1e-6)
    # The valve is open from the start, with nearly the conductance of 0.5 mm: 38.2 s to 5 bar.
    reached = float(np.interp(5e5, run["tank.pressure"], run.time))
    assert reached == pytest.approx(result.findings.fillings["isentrope"].time, rel=5e-3)
    of_report = runs.main_stage_circuit("paper", Steps([0.0], [4e5]), thermal="isentrope").simulate(80.0, 0.1, 1e-6)
    assert run["tank.pressure"] == pytest.approx(of_report["tank.pressure"], rel=1e-6)


@pytest.mark.parametrize(
    ("tank", "change"),
    [
        ("wall", {}),
        ("isentrope", {"tank.thermal": "isentrope"}),
        ("isothermal", {"tank.thermal": "isothermal"}),
        ("adiabatic", {"tank.wall_conductance": 0.0}),
    ],
)
def test_circuit_of_figure_6_gives_each_curve(circuits, result, tank, change):
    run = circuits["figure6"].with_values(change).simulate()
    staircase = result.findings.staircase
    assert run.time == pytest.approx(staircase.time)
    # Both runs have a local tolerance of 1e-6, and different steps: the file has a leak of 0.
    assert run["tank.pressure"] == pytest.approx(staircase[f"{tank}.pressure"], rel=1e-4)
    assert run["tank.temperature"] == pytest.approx(staircase[f"{tank}.temperature"], rel=1e-4)


def test_another_tank_and_a_leak_change_the_curve_of_figure_6(circuits):
    # A tenth of the volume follows at least as fast, and a leak lowers the pressure at the end of each step.
    paper = circuits["figure6"].simulate()
    changed = circuits["figure6"].with_values({"tank.volume": 0.02, "leak.sonic_conductance": 1e-9}).simulate()
    early = np.searchsorted(paper.time, 10.0)
    assert changed["tank.pressure"][early] > 1.2 * paper["tank.pressure"][early]
    assert changed["leak.mass_flow_rate"][-1] > 0.0
    assert changed["valve.supply_mass_flow_rate"][-1] == pytest.approx(changed["leak.mass_flow_rate"][-1], rel=0.05)

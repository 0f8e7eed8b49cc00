"""The first hours run, cell by cell, in an empty folder and without Jupyter."""

from __future__ import annotations

import re
import shlex
from pathlib import Path
from typing import Any

import pytest

import poppet
from poppet.cli import main

HOURS = Path(__file__).parents[2] / "website" / "pages" / "first_hours"
PAGES = sorted(path.stem for path in HOURS.glob("*.md") if path.stem != "index")
VALVES = "CKD M4GA2R", "SMC SY3500"
CELL = re.compile(r"^```\{code-cell\} ipython3\n(?:---\n.*?^---\n|(?::[^\n]*\n)*)(.*?)^```$", re.MULTILINE | re.DOTALL)


def command(line: str) -> None:
    """A line of a terminal."""
    name, *words = shlex.split(line)
    assert (name, main.run(words)) == ("poppet", 0), line


def run(page: str) -> dict[str, Any]:
    """Run the cells of a page; the names that they leave."""
    names: dict[str, Any] = {"_command": command}
    for cell in CELL.findall((HOURS / f"{page}.md").read_text(encoding="utf-8")):
        if written := re.match(r"%%writefile (\S+)\n", cell):
            Path(written[1]).write_text(cell[written.end() :], encoding="utf-8")
            continue
        code = re.sub(r"^!(poppet .*)$", lambda line: f"_command({line[1]!r})", cell, flags=re.MULTILINE)
        exec(compile(code, page, "exec"), names)
    return names


@pytest.fixture
def empty(tmp_path, monkeypatch):
    """An empty folder to work in, and a drawing that opens no window and closes its figures."""
    pyplot = pytest.importorskip("matplotlib.pyplot", reason="the hours draw")
    pytest.importorskip("IPython", reason="the hours are read in a notebook")
    pyplot.switch_backend("agg")
    monkeypatch.chdir(tmp_path)
    yield tmp_path
    pyplot.close("all")


def test_every_hour_is_in_the_contents():
    contents = (HOURS / "index.md").read_text(encoding="utf-8")
    assert all(f":link: {page}\n" in contents and f"\n{page}\n" in contents for page in PAGES)
    assert all("## Exercises" in (HOURS / f"{page}.md").read_text(encoding="utf-8") for page in PAGES)


def test_no_command_of_a_notebook_waits_for_an_answer():
    """Commands of a notebook have a terminal that nobody answers, so that a question would stop the notebook."""
    lines = [
        line for page in PAGES for line in re.findall("^!(poppet .*)$", (HOURS / f"{page}.md").read_text("utf-8"), re.M)
    ]
    assert len(lines) > 10
    assert [line for line in lines if "--from" in line and "--yes" not in line] == []


def test_the_bench_engineer_is_told_what_to_record_next(empty):
    from poppet.identify import read_result

    run("bench")
    monday, tuesday = (read_result(f"{day}_result.toml").parameters for day in ("monday", "tuesday"))
    assert monday["valve.critical_ratio"].verdict == "not determined"
    assert monday["valve.sonic_conductance"].verdict == "determined"
    assert all(number.verdict == "determined" for number in tuesday.values())
    assert tuesday["valve.sonic_conductance"].low < 1.1e-8 < tuesday["valve.sonic_conductance"].high
    assert tuesday["valve.critical_ratio"].low < 0.32 < tuesday["valve.critical_ratio"].high


def test_the_student_sees_why_the_tank_is_too_fast(empty):
    times = [run.time[-1] for run in run("student")["tanks"].values()]
    assert times == pytest.approx([38.2, 50.8, 66.3, 71.1], abs=0.1)
    assert (empty / "paper" / "report.html").exists()


def test_the_builder_finds_the_smallest_valve(empty):
    """The valve of the catalogue moves the load in time; the next smaller one of the table does not."""
    names = run("builder")
    assert names["by_hand"] == pytest.approx(1e3 * names["run"].figures.air_used, rel=0.1)
    text = (empty / "drive.toml").read_text()
    strokes = {model: poppet.loads(text.replace("CKD M4GA2R", model)).simulate().figures.strokes for model in VALVES}
    slowest = {model: max(stroke.from_command for stroke in strokes[model]) for model in VALVES}
    assert [slowest[model] <= 0.5 for model in VALVES] == [True, False]
    assert (empty / "valves.html").stat().st_size > 10_000


def test_the_designer_finds_where_it_hums(empty):
    names = run("designer")
    growth = {volume: point.eigenvalues().real.max() for volume, point in [("20 l", names["points"][-1])]}
    assert growth["20 l"] < 0.0 < names["points"][0].eigenvalues().real.max()
    assert (empty / "series" / "manifest.json").exists()


def test_the_control_engineer_takes_a_tuned_loop_along(empty):
    names = run("control")
    late = {name: names[name].simulate()["tank.pressure"][700] for name in ("loop", "tuned")}
    assert abs(late["tuned"] - 4e5) < abs(late["loop"] - 4e5)
    assert "FUNCTION_BLOCK" in (empty / "controller.st").read_text()


def test_the_researcher_sees_the_joint_follow(empty):
    recording = run("soft_robotics")["recording"]
    assert recording["arm.position"][590] == pytest.approx(0.698, abs=0.01)  # 40 degrees, before the last step
    assert (empty / "joint.html").stat().st_size < 400_000

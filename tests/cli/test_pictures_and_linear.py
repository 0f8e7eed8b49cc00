"""Tests of `poppet draw`, `plot`, `linearise` and `paper`."""

from __future__ import annotations

import json
import math
from types import SimpleNamespace

import numpy as np
import pytest

import poppet as house
from poppet.report.varga2012.paper_circuits import CIRCUITS


@pytest.fixture
def fill(poppet, tanks):
    """A recording of the two tanks."""
    assert poppet("simulate", "tanks.toml", "-o", "fill.csv", "--quiet").code == 0
    return "fill.csv"


@pytest.mark.parametrize("suffix", ["svg", "png"])
def test_draw(poppet, tanks, tmp_path, suffix):
    pytest.importorskip("matplotlib")
    code, out, err = poppet("draw", "tanks.toml", "-o", f"tanks.{suffix}")
    assert (code, out, err) == (0, f"tanks.{suffix}: 3 parts drawn.\n", "")
    assert (tmp_path / f"tanks.{suffix}").stat().st_size > 2000


def test_draw_names_the_parts(poppet, tanks, tmp_path):
    pytest.importorskip("matplotlib")
    poppet("draw", "tanks.toml", "-o", "tanks.svg")
    text = (tmp_path / "tanks.svg").read_text(encoding="utf-8")
    assert [name for name in ("high", "hole", "low") if name not in text] == []


def test_draw_refusals(poppet, tanks):
    assert poppet("draw", "tanks.toml").codes == ["cli.usage"]
    assert poppet("draw", "tanks.toml", "-o", "tanks.bmp").codes == ["files.suffix"]
    assert poppet("draw", "missing.toml", "-o", "tanks.svg").codes == ["toml.no_file"]


def test_plot_shows_recordings_in_common_axes(poppet, fill, tmp_path):
    pytest.importorskip("matplotlib")
    poppet("simulate", "tanks.toml", "--set", "high.volume=20 l", "-o", "other.csv")
    options = ("--select", "*.pressure", "--units", "bar,low.pressure=kPa")
    code, out, err = poppet("plot", fill, "other.csv", "-o", "both.svg", *options)
    assert (code, out, err) == (0, "both.svg: 2 recordings drawn.\n", "")
    assert (tmp_path / "both.svg").stat().st_size > 5000


def test_the_default_plot_file_is_named_after_the_first_recording(poppet, fill, tmp_path):
    pytest.importorskip("matplotlib")
    code, out, _ = poppet("plot", fill)
    assert (code, out) == (0, "fill.png: 1 recording drawn.\n")
    assert (tmp_path / "fill.png").exists()


def test_plot_recognises_internal_outputs_of_a_csv_file(poppet, fill, tmp_path):
    pytest.importorskip("matplotlib")
    for name, options in (("first.svg", ()), ("all.svg", ("--all",)), ("mass.svg", ("--select", "*.mass"))):
        assert poppet("plot", fill, "-o", name, *options).code == 0
    first, every, mass = ((tmp_path / f"{name}.svg").stat().st_size for name in ("first", "all", "mass"))
    assert every > first  # mass and heat flow of the tanks
    assert mass > 5000


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (("missing.csv",), "files.unreadable"),
        (("fill.csv", "-o", "fill.txt"), "files.suffix"),
        (("fill.csv", "--select", "high.presure"), "names.unknown"),
        (("fill.csv", "--units", "bra"), "unit.misspelt"),
        (("tanks.toml",), "files.suffix"),
    ],
)
def test_plot_refusals(poppet, fill, tmp_path, arguments, code):
    pytest.importorskip("matplotlib")
    answer = poppet("plot", *arguments)
    assert (answer.code, answer.out, answer.codes) == (2, "", [code])
    assert sorted(path.name for path in tmp_path.iterdir()) == ["fill.csv", "tanks.toml"]


class Linear:
    """A linear model with known eigenvalues."""

    states, inputs, outputs = ("high.mass", "high.pressure"), ("hole.opening",), ("tank.pressure",)
    x = np.array([0.1, 2e5])

    def eigenvalues(self):
        return np.array([-0.5, 6e-17, 2.0, -3.0 + 4.0j, -3.0 - 4.0j])

    poles = eigenvalues

    def save(self, path):
        path.write_text(json.dumps({"states": self.states}))


@pytest.fixture
def asked(monkeypatch):
    """Record the arguments of `Circuit.linearise`."""
    calls = []

    def linearise(self, inputs=None, *, at=None):
        calls.append((inputs, at))
        return Linear()

    monkeypatch.setattr("poppet.circuit.circuit.BaseCircuit.linearise", linearise)
    return calls


def test_linearise_prints_time_constants_frequencies_and_damping(poppet, tanks, asked):
    code, out, _ = poppet("linearise", "tanks.toml")
    assert (code, asked) == (0, [(None, None)])
    rows = [line.split() for line in out.splitlines()]
    assert ["-0.5", "2"] in rows
    assert ["0", "integrates"] in rows  # rounding is not taken for an instability
    assert ["high.mass", "kg", "0.1"] in rows
    assert ["2", "unstable,", "0.5"] in rows
    assert ["-3", "+-", "4i", "0.33333", f"{5 / (2 * math.pi):.5g}", "0.6"] in rows
    assert "2 states, 1 input, 1 output" in out


def test_linearise_at_inputs_in_any_unit(poppet, asked):
    poppet("new", "valve-fill")
    code, _, _ = poppet("linearise", "valve-fill.toml", "--set-input", "valve.pilot_pressure=2 bar g")
    assert (code, asked) == (0, [({"valve.pilot_pressure": "2 bar g"}, None)])


def test_linearise_at_the_end_of_a_recording_and_save(poppet, fill, asked, tmp_path):
    code, out, _ = poppet("linearise", "tanks.toml", "--at", fill, "-o", "linear.json")
    assert code == 0
    assert out.endswith("linear.json: written.\n")
    assert asked[0][1].last() == house.Recording.read(fill).last()
    assert json.loads((tmp_path / "linear.json").read_text()) == {"states": list(Linear.states)}


@pytest.mark.parametrize(
    ("arguments", "mistake"),
    [
        (("--set-input", "hole.openin=1"), ("names.unknown", "hole.openin", None, "hole.opening")),
        (("--set-input", "hole.opening=1 bar"), ("quantity.other_quantity", "hole.opening", None, "")),
        (("--set-input", "hole.opening"), ("cli.assignment", "", None, "")),
        (("--set-input", "hole.opening=1", "--at", "fill.csv"), ("cli.usage", "", None, "")),
        (("--at", "missing.csv"), ("files.unreadable", "", None, "")),
        (("-o", "linear.csv"), ("files.suffix", "", None, "")),
    ],
)
def test_linearise_refusals(poppet, tanks, arguments, mistake):
    answer = poppet("linearise", "tanks.toml", *arguments)
    assert (answer.code, answer.out, answer.errors) == (2, "", [mistake])


def test_paper_prints_the_table_and_reports_steps_on_stderr(poppet, tmp_path, monkeypatch):
    paper = pytest.importorskip("poppet.report.varga2012.paper")

    def write_paper(folder, progress):
        progress("figure 3")
        return SimpleNamespace(table=lambda: f"table of {folder}")

    monkeypatch.setattr(paper, "write_paper", write_paper)
    assert poppet("paper", "-o", "figures") == (0, "table of figures\n", "figure 3\n")
    (tmp_path / "file").write_text("")
    assert poppet("paper", "-o", "file").codes == ["paper.folder_is_file"]


def test_a_changed_circuit_is_kept_unless_forced(poppet, tmp_path):
    changed = tmp_path / "circuits" / "figure6.toml"
    assert poppet("paper", "--circuits", "circuits").code == 0
    assert poppet("paper", "--circuits", "circuits").code == 0  # unchanged files are no reason to refuse
    changed.write_text("mine")
    (tmp_path / "circuits" / "figure3.toml").unlink()
    answer = poppet("paper", "--circuits", "circuits")
    assert (answer.code, answer.codes) == (2, ["paper.circuit_exists"])
    assert changed.read_text() == "mine"
    assert not (tmp_path / "circuits" / "figure3.toml").exists()
    assert poppet("paper", "--circuits", "circuits", "--force").code == 0
    assert changed.read_bytes() == CIRCUITS["figure6.toml"].read_bytes()

"""The table of parity: every target within its limit, one that is wrong found out, one that cannot run says why."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from poppet.circuit.file import load
from poppet.cli.main import run
from poppet.deploy.parity import parity, table, targets
from poppet.deploy.parity.page import parity_page
from poppet.deploy.parity.targets import Found, NotRun
from refusals import refused

EXAMPLES = Path(__file__).parents[3] / "examples"
COMPILED = ("c adaptive", "c 1 kHz", "c 10 kHz")
needs_compiler = pytest.mark.skipif(
    not any(map(shutil.which, ("cc", "gcc", "clang"))), reason="there is no C compiler on this machine"
)


def short(name="pressure_control", duration="0.1 s"):
    """A short run in which something moves from the start."""
    moved = {"tank.initial_pressure": "3 bar"} if name == "pressure_control" else {}
    return load(EXAMPLES / f"{name}.toml").with_values({"run.duration": duration, "run.output_step": "5 ms", **moved})


@pytest.fixture(scope="module")
def found():
    return parity(short())


@needs_compiler
def test_every_target_is_within_its_limit(found):
    rows = {row.name: row for row in found.rows}
    assert [*rows] == [each.name for each in table.TARGETS]
    assert found.is_well
    assert all(row.greatest <= row.limit for row in found.rows if row.why is None)
    ran = {name for name, row in rows.items() if row.why is None}
    assert {"scipy", "cvodes", "structured text", *COMPILED} <= ran
    assert all(rows[name].seconds > 0.0 for name in ran)
    # Not a difference of nothing from nothing: another method differs, and by less than its limit.
    assert 1e-14 < rows["scipy"].greatest < rows["scipy"].limit
    assert 0.0 < rows["kernel moved"].greatest < 1e-9
    assert rows["c adaptive"].differences.keys() == found.sizes.keys()
    assert rows["structured text"].differences["regulator.command"] < 1e-12


def test_a_target_that_is_wrong_is_found_out(monkeypatch):
    def wrong(reference, folder):
        values = reference.run.values.copy()
        values[reference.names.index("tank.pressure")] *= 1.0 + 1e-6
        values[reference.names.index("tank.temperature"), 3] = np.nan
        return Found(values, 1.0)

    first = table.TARGETS[1]._replace(run=wrong)
    both = (
        first._replace(name="all of it", limit=1e-9, of="all"),
        first._replace(name="gas alone", limit=1e-5, of="gas"),
    )
    monkeypatch.setattr(table, "TARGETS", both)
    found = parity(short(), only=["all of it", "gas alone"])
    every, gas = found.rows
    assert (every.worst, every.greatest, every.is_well) == ("tank.temperature", np.inf, False)
    assert gas.worst == "tank.pressure"
    assert np.isclose(gas.greatest, 1e-6, rtol=1e-3)
    assert gas.is_well
    assert not found.is_well


def test_what_rounding_becomes_is_allowed_output_by_output(monkeypatch):
    """As far from the kernel as the kernel from itself, and one output as far again a hundred times."""
    moved = lambda reference, folder: Found(reference.run.values * (1.0 + 1e-7), 1.0)  # noqa: E731
    monkeypatch.setattr(targets, "kernel_moved", moved)
    target = table.TARGETS[1]._replace(name="other", limit=1e-9, of="all", run=moved)

    def wrong(reference, folder):
        values = reference.run.values * (1.0 + 1e-7)
        values[reference.names.index("tank.mass")] *= 1.0 + 1e-5
        return Found(values, 1.0)

    monkeypatch.setattr(table, "TARGETS", (target, target._replace(name="wrong", run=wrong)))
    other, bad = parity(short()).rows
    assert (other.is_well, bad.is_well, bad.worst) == (True, False, "tank.mass")
    assert other.greatest > other.limit


def test_what_cannot_run_says_why(monkeypatch):
    monkeypatch.setattr(targets.shutil, "which", lambda name: None)
    monkeypatch.setattr(targets, "MOST_INSTANTS", 10)
    rows = {row.name: row for row in parity(short(), only=["scipy", "c adaptive"]).rows}
    assert rows["scipy"].why.code == "deploy.parity.instants"
    assert rows["scipy"].why.facts == {"count": 50, "most": 10}
    assert rows["c adaptive"].why.code == "deploy.parity.no_compiler"
    assert rows["c adaptive"].is_well
    (row,) = parity(short(), only=["wasm"]).rows
    assert row.why.code == "deploy.parity.no_node"
    monkeypatch.undo()
    monkeypatch.setenv("CC", "false")
    (row,) = parity(short(), only=["c 1 kHz"]).rows
    assert row.why.code == "deploy.parity.not_compiled"
    (row,) = parity(short("two_tanks", "0.1 s"), only=["structured text"]).rows
    assert row.why.code == "deploy.parity.no_controller"
    with refused("deploy.parity.unknown", "dymola"):
        parity(short(), only=["dymola"])
    assert NotRun("other_system", system="win32").note.facts == {"system": "win32"}


def test_the_command_and_its_page(tmp_path, capsys, monkeypatch):
    page = tmp_path / "parity.html"
    file = str(EXAMPLES / "pressure_control.toml")
    common = [
        "export",
        "check",
        file,
        "--set",
        "tank.initial_pressure=3e5",
        "--duration",
        "0.1 s",
        "--only",
        "cvodes,structured text",
    ]
    assert run([*common, "--report", str(page)]) == 0
    shown = capsys.readouterr().out
    assert "structured text" in shown
    assert page.stat().st_size < 100_000
    assert page.read_text(encoding="utf-8").count(">within<") == 2
    monkeypatch.setattr(table, "TARGETS", tuple(each._replace(limit=1e-300) for each in table.TARGETS))
    assert run(common) == 1
    assert "beyond" in capsys.readouterr().out


def test_hostile_titles_stay_text():
    from dataclasses import replace

    circuit = replace(short("two_tanks", "0.1 s"), title="<script>alert(1)</script>")
    text = parity_page(parity(circuit, only=["cvodes"]))
    assert "<script>alert" not in text
    assert "&lt;script&gt;alert" in text

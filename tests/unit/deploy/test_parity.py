"""Tests of the parity table: targets within limits, wrong targets, targets that are not run."""

from __future__ import annotations

import shutil
from pathlib import Path

import numpy as np
import pytest

from poppet import load
from poppet.cli.main import run
from poppet.deploy import comparison
from poppet.deploy.parity import host_runs, parity_table
from poppet.deploy.parity.parity_check import NotRunError, TargetResult
from poppet.deploy.parity.parity_table import all_checks, compare_targets, parity_page, run_kernel
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


@needs_compiler
def test_every_target_is_within_its_limit():
    found = compare_targets(short())
    rows = {row.name: row for row in found.rows}
    assert [*rows] == [*all_checks()]
    ran = {name for name, row in rows.items() if row.why is None}
    assert {"scipy", "cvodes", "controllers", *COMPILED} <= ran
    assert {row.verdict for row in found.rows} <= {"within", "not run"}
    assert all(rows[name].seconds > 0.0 for name in ran)
    assert all(rows[name].until == pytest.approx(0.1, abs=0.006) for name in ran)
    # Not a difference of nothing from nothing: another method differs, and by less than its limit.
    assert 1e-14 < rows["scipy"].greatest < 1e-5
    assert 0.0 < rows["kernel moved"].greatest < 1e-9
    # The same arithmetic has the same bits.
    same = {"c adaptive", "fmu cs", "fmu 3 cs", "fmu cs (second host)", "wasm"} & ran
    assert {name: rows[name].overall for name in same} == dict.fromkeys(same, 0.0)
    assert rows["c adaptive"].differences.keys() == found.sizes.keys()
    assert rows["controllers"].differences["regulator.command"] < 1e-12


def test_another_solver_is_within_its_limit():
    (row,) = compare_targets(short("two_tanks", "1 s"), only=["cvodes"]).rows
    assert (row.verdict, row.until, row.share) == ("within", 1.0, 1.0)
    assert 0.0 < row.overall < 1e-5


def make_check(change_rows, **fields):
    """Return a check whose target gives the changed rows of the kernel."""

    def run(reference, folder):
        return TargetResult(change_rows(reference.rows.values.copy(), reference), 1.0)

    return all_checks()["scipy"]._replace(run=run, **fields)


def test_a_wrong_target_is_beyond_its_limit(monkeypatch):
    def wrong(values, reference):
        values[reference.names.index("tank.pressure")] *= 1.0 + 1e-6
        values[reference.names.index("tank.temperature"), 3] = np.nan
        return values

    every = make_check(wrong, name="all of it", limit=1e-9, scope="all", cause="rounding")
    gas = make_check(wrong, name="gas alone", limit=1e-5, scope="gas")
    step = make_check(wrong, name="a step", limit=1e-9, scope="gas", cause="step")
    monkeypatch.setattr(parity_table, "all_checks", lambda: {check.name: check for check in (every, gas, step)})
    found = compare_targets(short(), only=["all of it", "gas alone", "a step"])
    every, gas, step = found.rows
    assert (every.worst, every.greatest, every.verdict) == ("tank.temperature", np.inf, "beyond")
    assert (gas.worst, gas.verdict) == ("tank.pressure", "within")
    assert np.isclose(gas.greatest, 1e-6, rtol=1e-3)
    assert step.verdict == "coarse"
    assert not found.is_within_limits


def test_effects_of_rounding_are_allowed_for_each_output():
    """Ten times what small changes become may be there, in that output, and no more."""
    problem = short().problem(short().run)
    of = comparison.run_reference(problem, problem.grid.size - 1)
    every = np.ones(of.values.shape, dtype=bool)
    grown = np.full(of.values.shape, 1e-9)
    found = comparison.compare_runs(of.values * (1.0 + 3e-9), of, grown, 1e-10, every)
    assert found.n_rows == of.values.shape[1]
    assert found.is_compared.all()
    assert found.max_ratios().max() == pytest.approx(0.3, rel=1e-3)
    grown[:, :5] = 1e-12
    found = comparison.compare_runs(of.values * (1.0 + 3e-9), of, grown, 1e-10, every)
    assert found.max_ratios().max() == pytest.approx(30.0, rel=1e-3)


def test_the_comparison_ends_when_changed_kernels_diverge():
    problem = short().problem(short().run)
    of = comparison.run_reference(problem, problem.grid.size - 1)
    every = np.ones(of.values.shape, dtype=bool)
    gas, other = of.gas.argmax(), (~of.gas).argmax()
    lost = of.values.copy()
    lost[:, 12:] *= 1.5
    # One output that cannot be followed is left alone, a state of gas takes all others with it.
    grown = np.full(of.values.shape, 1e-13)
    grown[other, 8:] = 0.5
    found = comparison.compare_runs(lost, of, grown, 1e-9, every)
    assert (found.n_rows, found.max_ratios().max() > 1.0) == (of.values.shape[1], True)
    assert not found.is_compared[other, 8:].any()
    grown[gas, 12:] = 1e-3
    found = comparison.compare_runs(lost, of, grown, 1e-9, every)
    assert (found.n_rows, found.max_ratios().max()) == (12, 0.0)
    assert found.max_differences(whole_run=True).max() == pytest.approx(0.5)


def test_a_limit_cycle_is_compared_until_changed_kernels_diverge():
    """A change of the size of rounding leads to another run of the valve after 65 ms."""
    reference = run_kernel(load(EXAMPLES / "muscle_joint.toml").with_values({"run.duration": "0.2 s"}))
    of = reference.rows
    moved = comparison.change_effects(of, comparison.rounding_changes(reference.unfused_problem))
    found = comparison.compare_runs(reference.run.values, of, moved, 1e-9, np.ones(of.values.shape, dtype=bool))
    assert 5 < found.n_rows < of.values.shape[1]
    assert found.max_ratios().max() < 1.0
    assert found.max_differences().max() < 1e-5 < found.max_differences(whole_run=True).max()


def test_the_rest_of_a_run_is_compared_with_the_effect_of_changes(monkeypatch):
    """States of the whole run are held to what changes of the kernel make of them; three times that is no mistake."""
    circuit = load(EXAMPLES / "muscle_joint.toml").with_values({"run.duration": "0.3 s"})

    def off(times):
        def run(values, reference):
            moved = comparison.change_effects(reference.rows, comparison.rounding_changes(reference.unfused_problem))
            values[:, -20:] += times * moved[:, -1:] * reference.rows.sizes[:, None]
            return values

        return run

    near, far = (
        make_check(off(times), name=f"{times}", limit=1e-9, scope="all", cause="rounding") for times in (3, 30)
    )
    monkeypatch.setattr(parity_table, "all_checks", lambda: {check.name: check for check in (near, far)})
    near, far = compare_targets(circuit).rows
    assert near.until == far.until < 0.2
    assert (near.greatest, near.verdict) == (far.greatest, "within") == (0.0, "within")
    assert far.verdict == "beyond"
    assert near.drift == pytest.approx(0.1 * far.drift)
    assert near.moved == far.moved > 1e-6


def test_targets_that_are_not_run_have_a_reason(monkeypatch):
    monkeypatch.setattr(host_runs.shutil, "which", lambda name: None)
    monkeypatch.setattr(host_runs, "MAX_INSTANTS", 10)
    rows = {row.name: row for row in compare_targets(short(), only=["scipy", "c adaptive"]).rows}
    assert rows["scipy"].why.code == "deploy.parity.instants"
    assert rows["scipy"].why.facts == {"count": 50, "most": 10}
    assert rows["c adaptive"].why.code == "deploy.parity.no_compiler"
    assert rows["c adaptive"].verdict == "not run"
    (row,) = compare_targets(short(), only=["wasm"]).rows
    assert row.why.code == "deploy.parity.no_node"
    monkeypatch.undo()
    monkeypatch.setenv("CC", "false")
    (row,) = compare_targets(short(), only=["c 1 kHz"]).rows
    assert row.why.code == "deploy.parity.not_compiled"
    (row,) = compare_targets(short("two_tanks", "0.1 s"), only=["controllers"]).rows
    assert row.why.code == "deploy.parity.no_controller"
    uneven = short().with_values({"run.output_step": "3.3333333333 ms"})
    (row,) = compare_targets(uneven, only=["fmu cs (second host)"]).rows
    assert row.why.code == "deploy.parity.no_nanoseconds"
    with refused("fields.not_an_option", "target", value="dymola"):
        compare_targets(short(), only=["dymola"])
    with refused("deploy.fmu.no_archive", name="two_tanks.toml"):
        compare_targets(short(), fmu=EXAMPLES / "two_tanks.toml")
    assert NotRunError("other_system", system="win32").note.facts == {"system": "win32"}


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
        "cvodes,controllers",
    ]
    assert run([*common, "--report", str(page)]) == 0
    shown = capsys.readouterr().out
    assert "controllers" in shown
    assert page.stat().st_size < 100_000
    assert page.read_text(encoding="utf-8").count(">within<") == 2
    strict = {name: check._replace(limit=1e-300, cause="rounding") for name, check in all_checks().items()}
    monkeypatch.setattr(parity_table, "all_checks", lambda: strict)
    assert run(common) == 1
    assert "beyond" in capsys.readouterr().out


def test_special_characters_in_titles_are_escaped():
    from dataclasses import replace

    circuit = replace(short("two_tanks", "0.1 s"), title="<script>alert(1)</script>")
    text = parity_page(compare_targets(circuit, only=["cvodes"]))
    assert "<script>alert" not in text
    assert "&lt;script&gt;alert" in text

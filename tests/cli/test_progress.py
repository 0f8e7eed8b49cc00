"""Tests of the progress display of commands that take longer than a second."""

from __future__ import annotations

import io

import pytest

from poppet.circuit.options import Run
from poppet.cli import progress
from poppet.cli.progress import EnsembleProgress, FitProgress, SizingProgress, Spinner
from poppet.engine.problem import Outcome
from poppet.engine.solve import solve


class Terminal(io.StringIO):
    """Something that calls itself a terminal."""

    def isatty(self):
        return True


@pytest.mark.parametrize(
    ("stream", "is_quiet", "is_shown"),
    [(Terminal(), False, True), (Terminal(), True, False), (io.StringIO(), False, False)],
)
def test_spinner_shows_its_text(monkeypatch, stream, is_quiet, is_shown):
    monkeypatch.setattr("sys.stderr", stream)
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    with Spinner("The model is made ready", is_quiet=is_quiet) as waiting:
        if waiting._timer is not None:
            waiting._timer.join()
    assert ("The model is made ready" in stream.getvalue()) == is_shown


def test_first_step_is_shown_before_any_progress(monkeypatch):
    """A model that compiles for longer than the patience is shown, then a bar of the runs replaces the text."""
    stream = Terminal()
    monkeypatch.setattr("sys.stderr", stream)
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    with SizingProgress() as running:
        running._timer.join()
        running(0, 200, "runs")
    assert progress.FIRST_TEXT in stream.getvalue()
    with SizingProgress() as running:
        running._timer.join()
        running(17, 200, "runs")
        (task,) = running._line.tasks
        assert (task.completed, task.total, task.description) == (17, 200, "17 of about 200 runs")


def test_a_short_command_shows_no_progress(monkeypatch):
    stream = Terminal()
    monkeypatch.setattr("sys.stderr", stream)
    monkeypatch.setattr(progress, "PATIENCE", 60.0)
    with Spinner("The model is made ready"):
        pass
    assert stream.getvalue() == ""


def test_stages_show_the_completed_fraction(monkeypatch):
    stream = Terminal()
    monkeypatch.setattr("sys.stderr", stream)
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    with FitProgress() as counting:
        counting(280, 497.5)
        assert counting._latest[0].startswith("Fit: 280 evaluations, cost 497.5;")
        counting.stages("bootstrap fits", 3, 200)
    assert "After the fit: 3 of 200 bootstrap fits, 0 s" in stream.getvalue()


def test_ensemble_progress_counts_the_requested_runs(monkeypatch):
    stream = Terminal()
    monkeypatch.setattr("sys.stderr", stream)
    monkeypatch.setattr(progress, "PATIENCE", 0.0)
    with EnsembleProgress() as running:
        running(512, 1000, "runs")
        (task,) = running._line.tasks
        assert (task.completed, task.total) == (512, 1000)
        assert task.description.startswith("512 of 1000 runs, ")
        running(0, 4096, "indices")
        assert (task.completed, task.total) == (0, 4096)


@pytest.mark.parametrize("solver", ["rosenbrock", "cvodes", "lsoda", "bdf", "radau"])
def test_every_solver_reports_the_simulated_time(tank_circuit, solver):
    times = []
    run = solve(tank_circuit.problem(Run(duration=5.0)), solver, times.append)
    assert run.outcome is Outcome.DONE
    assert times == sorted(times)
    assert times[-1] == pytest.approx(5.0)


@pytest.fixture
def tank_circuit():
    from poppet import Chamber, Circuit, Orifice, Reservoir

    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-9, critical_ratio=0.3),
        "tank": Chamber(volume="10 l"),
    }
    return Circuit(parts)

"""Tests of the step metrics with closed forms, and of fair and repeatable comparisons."""

from __future__ import annotations

import csv
import dataclasses
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet import InputError, OutOfRangeError, control
from poppet.control import METRICS, compare, step_metrics
from poppet.core.errors import InputErrors
from poppet.report.control_report import plot_comparison
from poppet.signals import Sine

EXAMPLES = Path(__file__).parents[3] / "examples"
FILES = {"pid": "pressure_control", "scheduled": "pressure_control_scheduled", "law": "pressure_control_linearising"}
VARY = {"tank.volume": 0.2, "fill.sonic_conductance": 0.2, "supply.pressure": 0.1, "regulator.sensor.lag": 0.5}


@pytest.fixture(scope="module")
def circuits():
    return {name: poppet.load(EXAMPLES / f"{file}.toml") for name, file in FILES.items()}


@pytest.fixture(scope="module")
def comparison(circuits):
    return compare(circuits, vary=VARY, draws=12, seed=3)


def exponential(tau=0.05, size=2.0, begin=0.25):
    time = np.linspace(0.0, 2.0, 20001)
    since = np.maximum(time - begin, 0.0)
    setpoint = np.where(time < begin, 1.0, 1.0 + size)
    return time, setpoint, np.where(time < begin, 1.0, 1.0 + size * (1.0 - np.exp(-since / tau)))


def test_metrics_of_an_exponential():
    tau, size = 0.05, -2.0
    time, setpoint, pressure = exponential(tau, size)
    metrics = step_metrics(time, setpoint, pressure, 0.0 * time, 0.0 * time)
    assert metrics["IAE"] == pytest.approx(abs(size) * tau, rel=2e-3)
    assert metrics["ITAE"] == pytest.approx(abs(size) * tau**2, rel=1e-3)
    assert metrics["rise_time"] == pytest.approx(tau * np.log(9.0), rel=1e-4)
    assert metrics["settling_time"] == pytest.approx(tau * np.log(50.0), abs=2e-4)
    assert metrics["overshoot"] == metrics["travel"] == metrics["switches"] == 0.0


def test_metrics_of_an_oscillation():
    """A second order with damping zeta has an overshoot of exp(-pi zeta/sqrt(1 - zeta^2))."""
    time = np.linspace(0.0, 3.0, 30001)
    zeta, omega = 0.5, 40.0
    since = np.maximum(time - 0.1, 0.0)
    damped = omega * np.sqrt(1.0 - zeta**2)
    wave = np.exp(-zeta * omega * since) * (np.cos(damped * since) + zeta * omega / damped * np.sin(damped * since))
    pressure = np.where(time < 0.1, 0.0, 1.0 - wave)
    metrics = step_metrics(time, np.where(time < 0.1, 0.0, 1.0), pressure, 0.0 * time, 0.0 * time)
    assert metrics["overshoot"] == pytest.approx(100.0 * np.exp(-np.pi * zeta / np.sqrt(1.0 - zeta**2)), rel=1e-4)


def test_travel_includes_both_valves():
    time = np.arange(6.0)
    fill, vent = np.array([0.0, 1.0, 0.5, 0.0, 0.0, 0.0]), np.array([0.0, 0.0, 0.0, 0.3, 0.0, 0.0])
    metrics = step_metrics(time, 0.0 * time, 0.0 * time, fill, vent)
    assert metrics["travel"] == pytest.approx(2.6)
    assert metrics["switches"] == 3.0


def test_times_of_unreached_setpoint_are_infinite():
    time = np.linspace(0.0, 1.0, 101)
    metrics = step_metrics(time, np.where(time < 0.1, 0.0, 1.0), 0.5 * time, 0.0 * time, 0.0 * time)
    assert metrics["rise_time"] == metrics["settling_time"] == np.inf


def test_all_controllers_run_on_the_same_plants(comparison, circuits):
    assert comparison.draws == 12
    assert set(comparison.factors) == set(VARY)
    for address, size in VARY.items():
        factors = comparison.factors[address]
        assert factors[0] == 1.0
        assert np.all(np.abs(factors - 1.0) <= size)
        assert np.ptp(factors) > 0.5 * size
    # The first draw, run by hand.
    values = {a: f[1] * circuits["law"].parameters[a] for a, f in comparison.factors.items()}
    recording = circuits["law"].with_values(values).simulate("6.5 s", "2 ms")
    assert np.array_equal(recording["tank.pressure"], comparison.responses["law"][1])


def test_equal_seeds_give_equal_metrics(comparison, circuits):
    repeated = compare({"law": circuits["law"]}, vary=VARY, draws=12, seed=3)
    other_seed = compare({"law": circuits["law"]}, vary=VARY, draws=12, seed=4)
    for key in METRICS:
        assert np.array_equal(repeated.figures["law"][key], comparison.figures["law"][key])
    assert not np.array_equal(other_seed.figures["law"]["IAE"], repeated.figures["law"]["IAE"])


def test_metrics_rank_the_controllers(comparison):
    for summary in comparison.summary().values():
        for nominal, median, worst in summary.values():
            assert np.isfinite([nominal, median, worst]).all()
            assert median <= worst
    # The linearising controller knows the laws: next to no overshoot, where the linear ones have some.
    assert comparison.summary()["law"]["overshoot"][0] < 0.1 < comparison.summary()["pid"]["overshoot"][0]
    assert comparison.failed == dict.fromkeys(FILES, 0)


def test_nominal_run_only_without_uncertain_parameters(circuits):
    nominal_comparison = compare({"pid": circuits["pid"]})
    assert nominal_comparison.draws == 0
    ((nominal, median, worst),) = {nominal_comparison.summary()["pid"]["IAE"]}
    assert nominal == median == worst


def test_failed_run_has_the_worst_metrics(circuits):
    stopping = dataclasses.replace(circuits["pid"].run, stop_when="tank.pressure > 4.5 bar")
    broken = compare({"pid": dataclasses.replace(circuits["pid"], run=stopping)})
    assert broken.failed == {"pid": 1}
    assert broken.figures["pid"]["IAE"][0] == np.inf


def test_progress_counts_the_runs(circuits):
    calls = []
    compare({"pid": circuits["pid"]}, vary={"tank.volume": 0.1}, draws=2, progress=lambda *counts: calls.append(counts))
    assert calls == [(1, 3), (2, 3), (3, 3)]


def changed(circuit, **values):
    return circuit.with_values({address.replace("__", "."): value for address, value in values.items()})


@pytest.mark.parametrize(
    ("unfair", "differing"),
    [
        (lambda c: changed(c, tank__volume="2 l"), {"tank.volume": (2e-3, 1e-3)}),
        (lambda c: changed(c, regulator__sample_time="1 ms"), {"regulator.sample_time": (1e-3, 2e-3)}),
        (lambda c: changed(c, regulator__fill_limit=0.5), {"regulator.fill_limit": (0.5, 1.0)}),
        (lambda c: changed(c, regulator__sensor__lag=0.0), {"regulator.sensor.lag": (0.0, 3e-3)}),
        (lambda c: changed(c, regulator__acts="at_once"), {"acts": ("at_once", "next_sample")}),
        (lambda c: dataclasses.replace(c, run=dataclasses.replace(c.run, duration="6 s")), {"duration": (6.0, 6.5)}),
    ],
)
def test_unfair_differences_are_reported(circuits, unfair, differing):
    with pytest.raises(InputError) as caught:
        compare({"first": circuits["pid"], "other": unfair(circuits["pid"])})
    problems = caught.value.problems if isinstance(caught.value, InputErrors) else [caught.value]
    assert {problem.code for problem in problems} == {"control.unfair"}
    assert {problem.address: (problem.facts["value"], problem.facts["first"]) for problem in problems} == differing


def test_different_parts_and_signals_are_unfair(circuits):
    first = circuits["pid"]
    sine = dataclasses.replace(first, signals={"regulator.setpoint": Sine(3e5, 1e5, 1.0)})
    with pytest.raises(InputErrors) as caught:
        compare({"first": first, "parts": changed(first, tank__thermal="isothermal"), "signals": sine})
    errors = {(problem.code, problem.address) for problem in caught.value.problems}
    expected = {("unfair", "parts"), ("unfair", "signals"), ("no_staircase", "regulator.setpoint")}
    assert errors >= {(f"control.{code}", address) for code, address in expected}


def test_parameters_of_controllers_may_differ(circuits):
    harder = circuits["pid"].with_values({"regulator.gain": "12 1/bar"})
    comparison = compare({"first": circuits["pid"], "other": harder})
    assert comparison.figures["first"]["travel"][0] != comparison.figures["other"]["travel"][0]


@pytest.mark.parametrize(
    ("vary", "error", "code"),
    [
        ({"tank.volum": 0.2}, InputError, "names.unknown"),
        ({"regulator.gain": 0.2}, InputError, "control.vary.of_controller"),
        ({"regulator.sensor.offset": 0.2}, InputError, "control.vary.zero"),
        ({"tank.volume": 1.5}, OutOfRangeError, "fields.out_of_range"),
    ],
)
def test_invalid_variations_are_rejected(circuits, vary, error, code):
    with pytest.raises(error) as caught:
        compare({"pid": circuits["pid"]}, vary=vary)
    assert (caught.value.code, [caught.value.address]) == (code, list(vary))


def test_comparison_without_circuits_is_rejected():
    with pytest.raises(InputError) as caught:
        compare({})
    assert caught.value.code == "control.no_circuits"


def test_negative_draws_are_rejected(circuits):
    with pytest.raises(OutOfRangeError) as caught:
        compare({"pid": circuits["pid"]}, draws=-1)
    assert (caught.value.address, caught.value.facts["value"]) == ("draws", -1)


def test_the_table_has_a_row_for_every_run(comparison, tmp_path):
    text = comparison.save(tmp_path / "figures.csv").read_text(encoding="utf-8")
    rows = list(csv.DictReader(text.splitlines()))
    assert len(rows) == 3 * 13
    assert float(rows[14]["ITAE [Pa s^2]"]) == pytest.approx(comparison.figures["scheduled"]["ITAE"][1])
    assert float(rows[14]["tank.volume"]) == pytest.approx(comparison.factors["tank.volume"][1])


def test_figure_shows_every_controller(comparison, tmp_path):
    figure = plot_comparison(comparison, tmp_path / "spread.svg", title="three")
    titles = [axes.get_title(loc="left") for axes in figure.axes]
    assert titles[:6:2] == list(FILES)
    assert titles[6:] == ["ITAE [bar s²]", "settling time [s]", "overshoot [%]", "travel"]
    assert (tmp_path / "spread.svg").stat().st_size > 10_000
    with pytest.raises(InputError) as caught:
        plot_comparison(comparison, tmp_path / "spread.xyz")
    assert caught.value.code == "files.suffix"


@pytest.mark.parametrize(
    ("former", "name"), [("FIGURES", "METRICS"), ("figures_of", "step_metrics"), ("figures_in", "metrics_in")]
)
def test_former_names_are_deprecated(former, name):
    with pytest.warns(DeprecationWarning, match=name):
        assert getattr(control, former) is getattr(control, name)
    with pytest.raises(AttributeError):
        _ = control.no_such_name

"""Metrics of closed forms, independence of batches, units, and requirements."""

from __future__ import annotations

import math

import numpy as np
import pytest

from circuits_of_ensembles import tank
from poppet.ensemble import size
from poppet.ensemble.metrics import METRIC_KINDS, read_metric, read_requirement
from refusals import refused

OUTPUTS = {"tank.pressure": "Pa", "hole.mass_flow_rate": "kg/s", "valve.opening": "1", "tank.temperature": "K"}
TIME = np.linspace(0.0, 10.0, 10_001)


def metric(name="m", ambient=1e5, **fields):
    table = {"of": "tank.pressure", **fields}
    return read_metric(name, table, OUTPUTS, ambient, f"ensemble.metrics.{name}", ".", allow_python=True)


def value(rows, **fields):
    read = metric(**fields)
    return float(read.values(TIME, {read.of[0]: rows[np.newaxis]})[0])


FIRST_ORDER = 1e5 + 4e5 * (1.0 - np.exp(-TIME / 2.0))
SWING = 1.0 - np.exp(-TIME) * np.cos(4.0 * TIME)
"""The final value is first crossed at pi/8. The overshoot is the next peak, where tan(4 t) = -1/4."""


def test_times_of_a_first_order_step():
    assert value(FIRST_ORDER, metric="time_to", value="4 bar") == pytest.approx(2.0 * math.log(4.0), abs=1e-6)
    assert value(FIRST_ORDER, metric="time_to", value="3 bar g") == pytest.approx(2.0 * math.log(4.0), abs=1e-6)
    assert value(FIRST_ORDER, metric="time_to", value="6 bar") == math.inf
    assert value(6e5 - FIRST_ORDER, metric="time_to", value="2 bar") == pytest.approx(2.0 * math.log(4.0), abs=1e-6)
    rise = value(FIRST_ORDER, metric="rise_time", target="5 bar")
    assert rise == pytest.approx(2.0 * math.log(9.0), abs=1e-6)
    settled = value(FIRST_ORDER, metric="settling_time", target="5 bar", band=0.05)
    assert settled == pytest.approx(2.0 * math.log(20.0), abs=1e-5)
    assert value(FIRST_ORDER, metric="settling_time", target="5 bar", band=0.001) == math.inf
    # A constant output has no step and no settling band.
    for metric in ("settling_time", "rise_time", "overshoot"):
        assert math.isnan(value(np.full(TIME.size, 3e5), metric=metric))
        # Noise of the solver is no step either.
        assert math.isnan(value(3e5 * (1.0 + 1e-12 * np.sin(TIME)), metric=metric))
    assert value(FIRST_ORDER, metric="steady_error", target="5 bar") == pytest.approx(-4e5 * math.exp(-5.0))


def test_overshoot_of_a_swing():
    peak = (math.pi - math.atan(0.25)) / 4.0
    expected = -math.exp(-peak) * math.cos(4.0 * peak)
    assert value(SWING, of="valve.opening", metric="overshoot", target=1.0) == pytest.approx(100 * expected, abs=1e-4)
    assert value(FIRST_ORDER, metric="overshoot") == 0.0


def test_means_and_integrals():
    wave = 2e5 + 1e5 * np.sin(2.0 * math.pi * TIME)
    assert value(wave, metric="mean") == pytest.approx(2e5, rel=1e-9)
    assert value(wave, metric="rms", unit="bar") == pytest.approx(math.sqrt(4.5), rel=1e-6)
    assert value(wave, metric="mean", **{"from": "0 s", "until": "0.5 s"}) == pytest.approx(
        2e5 + 2e5 / math.pi, rel=1e-5
    )
    assert value(wave, metric="max", unit="bar g") == pytest.approx(2.0, rel=1e-9)
    assert value(wave, metric="min") == pytest.approx(1e5, rel=1e-9)
    assert value(wave, metric="final", until="0.25 s") == pytest.approx(3e5, rel=1e-9)
    # 1.185 kg/m^3 at ANR (ISO 8778).
    flow = np.full(TIME.size, 1.185e-3)
    assert value(flow, of="hole.mass_flow_rate", metric="integral", unit="l ANR") == pytest.approx(10.0, rel=1e-12)
    assert value(flow, of="hole.mass_flow_rate", metric="integral") == pytest.approx(1.185e-2, rel=1e-12)


@pytest.mark.parametrize("kind", METRIC_KINDS)
def test_metrics_do_not_depend_on_the_batch(kind):
    read = metric(metric=kind, **({"value": "2 bar"} if kind == "time_to" else {}))
    rows = np.random.default_rng(1).uniform(1e5, 5e5, (37, 501))
    time = np.linspace(0.0, 10.0, 501)
    expected = read.values(time, {"tank.pressure": rows})
    # As in the engine: rows of one output are not contiguous.
    strided = np.random.default_rng(1).uniform(1e5, 5e5, (37, 3, 501))
    strided[:, 1] = rows
    for first, last in ((0, 1), (5, 6), (3, 30), (36, 37)):
        assert (read.values(time, {"tank.pressure": rows[first:last]}) == expected[first:last]).all()
        assert (read.values(time, {"tank.pressure": strided[first:last, 1]}) == expected[first:last]).all()


def test_functions_of_the_user(tmp_path):
    read = metric(metric=lambda time, rows: rows[-1] - rows[0])
    assert read.values(TIME, {"tank.pressure": FIRST_ORDER[np.newaxis]})[0] == pytest.approx(4e5, rel=1e-2)
    (tmp_path / "ripple.py").write_text("def ripple(time, p, q):\n    return float((p * q).max())\n", encoding="utf-8")
    fields = {"of": ["tank.pressure", "valve.opening"], "metric": "ripple.py:ripple", "unit": "Pa"}
    read = read_metric("m", fields, OUTPUTS, 1e5, "m", str(tmp_path), allow_python=True)
    rows = {"tank.pressure": FIRST_ORDER[np.newaxis], "valve.opening": 0.0 * TIME[np.newaxis] + 0.5}
    assert read.values(TIME, rows)[0] == 0.5 * FIRST_ORDER.max()
    first_hash = read.facts()["function"]
    (tmp_path / "ripple.py").write_text("def ripple(time, p, q):\n    return 1.0\n", encoding="utf-8")
    assert read.facts()["function"] != first_hash
    with refused("ensemble.no_function", "other.py:f"):
        metric(metric="other.py:f").facts()


def test_python_files_require_permission_in_python(tmp_path):
    (tmp_path / "own.py").write_text("raise SystemExit('executed')", encoding="utf-8")
    own = {"own": {"of": "tank.pressure", "metric": "own.py:f"}}
    with refused("ensemble.python_forbidden", "ensemble.metrics.own.metric", location="own.py:f"):
        tank(folder=tmp_path).ensemble(runs=4, metrics=own, requirements={})
    with refused("ensemble.python_forbidden", "ensemble.metrics.own.metric", location="own.py:f"):
        size(tank(folder=tmp_path), "tank.volume", metrics=own)
    (tmp_path / "own.py").write_text("def f(time, p):\n    return p[-1]\n", encoding="utf-8")
    ensemble = tank(folder=tmp_path).ensemble(runs=4, metrics=own, requirements={}, allow_python=True)
    assert ensemble.plan.python_functions == ("own.py:f",)
    assert [(note.code, note.facts["functions"]) for note in ensemble.remarks()] == [
        ("ensemble.executed", ("own.py:f",))
    ]
    sizing = size(
        tank(folder=tmp_path), "tank.volume", metrics=own, requirements={"low": "own < 3e5"}, allow_python=True
    )
    assert ("ensemble.executed", ("own.py:f",)) in [(note.code, note.facts.get("functions")) for note in sizing.remarks]


def last_value(time, pressure):
    return pressure[-1]


def test_functions_of_the_caller_require_no_permission():
    own = {"own": {"of": "tank.pressure", "metric": last_value}}
    ensemble = tank().ensemble(runs=4, metrics=own, requirements={})
    assert ensemble.plan.python_functions == ()
    assert ensemble.done == 4


@pytest.mark.parametrize(
    ("code", "fields"),
    [
        ("fields.not_an_option", {"metric": "maximum"}),
        ("fields.not_an_option", {"metric": "max", "of": "tank.presure"}),
        ("ensemble.of", {"metric": "max", "of": ["tank.pressure", "valve.opening"]}),
        ("ensemble.not_of_metric", {"metric": "max", "value": "2 bar"}),
        ("ensemble.no_value", {"metric": "time_to"}),
        ("ensemble.window", {"metric": "max", "from": "3 s", "until": "2 s"}),
        ("fields.unknown", {"metric": "max", "form": "3 s"}),
        ("unit.other_quantity", {"metric": "max", "unit": "kg"}),
        ("quantity.point_of_scale", {"metric": "steady_error", "of": "tank.temperature", "unit": "degC"}),
        ("quantity.other_quantity", {"metric": "time_to", "value": "2 s"}),
    ],
)
def test_invalid_metrics_are_rejected(code, fields):
    with refused(code):
        metric(**fields)


@pytest.mark.parametrize(
    "body",
    [
        "def f(t, p):\n    raise KeyError('p')",
        "def f(t, p):\n    return p",
        "def f(t, p):\n    p[:] = 0.0\n    return 1.0",
        "def f(t):\n    return 1.0",
        "def f(t, p:",
    ],
)
def test_failing_function_of_the_user_is_an_input_error(tmp_path, body):
    """The arguments are read-only, because other metrics use the same rows."""
    (tmp_path / "own.py").write_text(body, encoding="utf-8")
    fields = {"of": "tank.pressure", "metric": "own.py:f"}
    with refused("ensemble.function_failed"):
        tank(folder=tmp_path).ensemble(runs=4, metrics={"own": fields}, requirements={}, allow_python=True)


METRICS = {
    "t": metric("t", metric="time_to", value="2 bar"),
    "peak": metric("peak", metric="max", unit="bar"),
    "air": metric("air", of="hole.mass_flow_rate", metric="integral", unit="l ANR"),
    "over": metric("over", metric="overshoot"),
    "größe": metric("größe", metric="max"),
}


def requirement(text):
    return read_requirement("r", text, METRICS, 1e5, "requirements.r")


def test_requirements_are_read_in_any_unit():
    assert requirement("t < 12 s").bounds == (("<", 12.0),)
    assert requirement("t>=200 ms").bounds == ((">=", 0.2),)
    assert requirement("over < 2 %").bounds == (("<", 2.0),)
    assert requirement("größe < 2 bar").bounds == (("<", 2e5),)
    assert requirement("peak <= 500000").bounds == (("<=", 5.0),)
    assert requirement("air < 3 l ANR").bounds[0][1] == pytest.approx(3.0, rel=1e-12)
    relations, bounds = zip(*requirement("1 bar < peak <= 6 bar g").bounds, strict=True)
    assert relations == ("<=", ">")
    assert bounds == pytest.approx((7.0, 1.0))


def test_requirement_met_and_margin():
    read = requirement("1 bar < peak <= 6 bar g")
    values = np.array([1.0, 1.1, 7.0, 7.1, np.nan, np.inf])
    assert read.met(values).tolist() == [False, True, True, False, False, False]
    assert read.margin(values[:4]) == pytest.approx([0.0, 0.1, 0.0, -0.1], abs=1e-12)


@pytest.mark.parametrize(
    ("code", "text"),
    [
        ("ensemble.requirement", "t is short"),
        ("ensemble.requirement", "__import__('os').system('true') < 1"),
        ("ensemble.requirement", "1 s < t > 2 s"),
        ("ensemble.requirement", 5),
        ("fields.not_an_option", "time < 12 s"),
        ("ensemble.bound", "t < 12 bar"),
        ("ensemble.bound", "t < 1_000 s"),
        ("ensemble.bound", "t < twelve"),
    ],
)
def test_invalid_requirements_are_rejected(code, text):
    with refused(code, "requirements.r"):
        requirement(text)


def test_metrics_equal_those_of_single_runs():
    circuit = tank()
    ensemble = circuit.ensemble(runs=4, sampling="latin")
    rows = ensemble.dataset.columns("runs")
    for k in range(4):
        numbers = {address: float(rows[address][k]) for address in ensemble.plan.addresses}
        recording = circuit.with_values(numbers).simulate()
        assert rows["end"][k] == pytest.approx(recording["tank.pressure"][-1] / 1e5, rel=1e-9)
        p, t = recording["tank.pressure"], recording.time
        j = int(np.argmax(p <= 1.5e5))
        empty = t[j - 1] + (1.5e5 - p[j - 1]) / (p[j] - p[j - 1]) * (t[j] - t[j - 1])
        assert rows["empty"][k] == pytest.approx(empty, rel=1e-9)
        air = np.trapezoid(recording["hole.mass_flow_rate"], t) / 1.185 * 1e3
        assert rows["air"][k] == pytest.approx(air, rel=1e-9)

"""Linear reference models: fits to their own simulations, steady start and scores."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from poppet.core.errors import InputError
from poppet.identify.baseline_models import (
    FirstOrder,
    Response,
    SecondOrderArx,
    baselines,
    fit_arx,
    fit_first_order,
    responses_of,
    score_model,
    score_table,
)
from poppet.identify.fit.fit_plan import read_fit_file
from poppet.identify.fit.identify_fit import identify_fit
from poppet.timeseries.measurements import read_measurement
from refusals import refused

STEP = 0.02


def blank(seed: int = 0, *, uneven: bool = False, first: float = 1.0) -> Response:
    rng = np.random.default_rng(seed)
    time = np.arange(0.0, 20.0, STEP)
    if uneven:
        time = np.sort(np.concatenate([[0.0], rng.uniform(0.0, 20.0, 999)]))
    begin = np.arange(0.0, 20.0, 1.0)
    return Response("a.p", time, np.zeros(time.size), begin, rng.uniform(0.0, 5.0, begin.size), first)


def test_first_order_lag_fulfils_its_differential_equation():
    response, model = blank(), FirstOrder(0.33, 0.4, 2.0, -1.0)

    def slope(t: float, y: np.ndarray) -> np.ndarray:
        drive = 2.0 * response.commanded(np.array([t - 0.33]))[0] - 1.0 if t >= 0.33 else y[0]
        return (drive - y) / 0.4

    exact = solve_ivp(slope, (0.0, 19.98), [1.0], t_eval=response.time, max_step=0.01, rtol=1e-8, atol=1e-10).y[0]
    assert np.max(np.abs(model.simulate(response) - exact)) < 0.02


def test_commands_before_the_window_act_after_the_dead_time():
    response = Response(
        "a.p", np.linspace(0.0, 2.0, 41), np.zeros(41), np.array([-1.0, 0.0]), np.array([3.0, 0.0]), 0.0
    )
    simulated = FirstOrder(0.5, 0.1, 1.0, 0.0).simulate(response)
    assert simulated[10] == pytest.approx(3.0 * (1.0 - np.exp(-5.0)), rel=1e-9)
    assert simulated[-1] == pytest.approx(simulated[10] * np.exp(-15.0), rel=1e-6)


@pytest.mark.parametrize("uneven", [False, True])
def test_fit_recovers_first_order_lag(uneven):
    true = FirstOrder(0.23, 0.6, 1.1, 0.4)
    empty = blank(uneven=uneven)
    noise = np.random.default_rng(1).normal(0.0, 0.01, empty.time.size)
    model = fit_first_order([replace(empty, measured=true.simulate(empty) + noise)])
    assert model.dead_time == pytest.approx(0.23, abs=0.01)
    assert model.time_constant == pytest.approx(0.6, rel=0.02)
    assert (model.gain, model.offset) == pytest.approx((1.1, 0.4), rel=0.02)


def test_fit_recovers_arx_model_with_dead_time():
    true = SecondOrderArx(STEP, 7, np.array([1.6, -0.65]), np.array([0.03, 0.02]), 0.01)
    empty = blank()
    model = fit_arx([replace(empty, measured=true.simulate(empty))])
    assert model.dead_steps == 7
    assert model.step == pytest.approx(STEP)
    assert np.allclose([*model.a, *model.b, model.constant], [1.6, -0.65, 0.03, 0.02, 0.01], atol=1e-6)
    predicted, measured = model.one_step(replace(empty, measured=true.simulate(empty)))
    assert np.max(np.abs(predicted - measured)) < 1e-6


def test_arx_model_is_steady_before_the_first_command_acts():
    model = SecondOrderArx(STEP, 10, np.array([1.2, -0.3]), np.array([0.1, 0.0]), 0.0)
    simulated = model.simulate(blank(first=2.5))
    assert np.allclose(simulated[:10], 2.5)
    assert abs(simulated[-1] - 2.5) > 0.1


def test_unstable_arx_model_is_not_selected():
    """The least-squares poles of a growing series are unstable; the simulation error excludes such a model."""
    empty = blank()
    grown = replace(empty, measured=np.exp(0.2 * empty.time))
    model = fit_arx([grown])
    assert np.isfinite(score_model("a.p", "ARX", False, model.simulate(grown), grown.measured).nrmse)


def test_scores_agree_with_their_definitions():
    measured, simulated = np.array([0.0, 1.0, 2.0, 5.0]), np.array([1.0, 1.0, 2.0, 5.0])
    score = score_model("a.p", "m", True, simulated, measured)
    assert score.rms == pytest.approx(0.5)
    assert score.nrmse == pytest.approx(0.1)
    assert score.fit == pytest.approx(100.0 * (1.0 - 1.0 / np.sqrt(14.0)))
    assert score_model("a.p", "m", True, simulated, np.ones(4)).nrmse == np.inf


CIRCUIT = """
[parts.line]
kind = "reservoir"
pressure = "3 bar"
[parts.inlet]
kind = "orifice"
from = "line"
to = "tank"
sonic_conductance = "2e-9 m^3/(s Pa)"
[parts.outlet]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = "1e-9 m^3/(s Pa)"
[parts.tank]
kind = "chamber"
thermal = "isothermal"
volume = "0.2 l"
"""

FIT = """
circuit = "circuit.toml"
[recordings.seen]
file = "bench.csv"
until = "12 s"
start = { "tank.initial_pressure" = "first" }
"tank.pressure" = { column = "p", unit = "bar" }
inputs = { "inlet.opening" = { column = "u", unit = "1", hold = true } }
[recordings.held]
file = "bench.csv"
use = "validation"
skip = "12 s"
start = { "tank.initial_pressure" = "first" }
"tank.pressure" = { column = "p", unit = "bar" }
inputs = { "inlet.opening" = { column = "u", unit = "1", hold = true } }
[free]
"inlet.sonic_conductance" = { start = "1e-9 m^3/(s Pa)" }
"outlet.sonic_conductance" = { start = "2e-9 m^3/(s Pa)" }
"""


@pytest.fixture
def bench(tmp_path: Path) -> Path:
    import poppet

    (tmp_path / "circuit.toml").write_text(CIRCUIT, encoding="utf-8")
    signal = '[signals."inlet.opening"]\nkind = "steps"\ntimes = [0, 1, 4, 6, 9, 11, 14, 18]\n'
    signal += "values = [0, 1, 0, 0.5, 0, 0.2, 1, 0]\n[run]\nduration = 20\noutput_step = 0.02\n"
    (tmp_path / "true.toml").write_text(CIRCUIT + signal, encoding="utf-8")
    run = poppet.load(tmp_path / "true.toml").simulate()
    noise = np.random.default_rng(0).normal(0.0, 100.0, run.time.size)
    rows = np.column_stack([run.time, run["inlet.opening"], (run["tank.pressure"] + noise) / 1e5])
    np.savetxt(tmp_path / "bench.csv", rows, "%.9g", ",", header="time,u,p", comments="")
    (tmp_path / "fit.toml").write_text(FIT, encoding="utf-8")
    return tmp_path / "fit.toml"


def test_circuit_fits_its_own_simulation_better_than_both_baselines(bench):
    scores = baselines(read_fit_file(bench), {"tank.pressure": "inlet.opening"}, identify_fit(bench))
    validation = {s.model: s for s in scores if s.held_out}
    assert validation["circuit"].nrmse < 0.005
    assert validation["circuit"].nrmse < 0.2 * min(validation["first order + dead time"].nrmse, validation["ARX"].nrmse)
    assert {s.response for s in scores} == {"seen.tank.pressure", "held.tank.pressure"}
    table = score_table(scores).splitlines()
    assert len(table) == 4
    assert table[3].startswith("| held.tank.pressure | held out | 0.")


def test_unknown_command_and_channel_are_rejected(bench):
    with pytest.raises(InputError) as error:
        baselines(read_fit_file(bench), {"tank.pressure": "inlet.opneing"})
    assert (error.value.code, error.value.facts["suggestion"].names) == ("names.unknown", ["inlet.opening"])
    with pytest.raises(InputError) as error:
        baselines(read_fit_file(bench), {"tank.presure": "inlet.opening"})
    assert (error.value.code, error.value.address) == ("names.unknown", "tank.presure")


def read_recording(folder: Path, **fields: object) -> object:
    command = "t,u,p\n" + "\n".join(f"{0.1 * k:g},{5 if k < 10 else 1},{k}" for k in range(20))
    (folder / "c.csv").write_text(command, encoding="utf-8")
    item = {"column": "u", "unit": "psi g", **fields}
    table = {"file": "c.csv", "time": {"column": "t", "unit": "s"}, "inputs": {"v.setpoint_pressure": item}}
    return read_measurement("r", {**table, "t.pressure": {"column": "p", "unit": "bar"}}, folder, ambient_pressure=1e5)


def test_command_is_constant_between_samples(tmp_path):
    from poppet.identify.fit.fit_series import shift_series

    (response,) = responses_of(read_recording(tmp_path, hold=True), {"t.pressure": "v.setpoint_pressure"})
    psi = 6894.757293168361
    assert np.allclose(response.commanded(np.array([0.0, 0.95, 1.0, 1.9])), 1e5 + psi * np.array([5.0, 5.0, 1.0, 1.0]))
    time, values = shift_series(response.command_time, response.command, 0.95, hold=True)
    assert values[0] == pytest.approx(1e5 + 5.0 * psi)
    assert time[1] == pytest.approx(0.05)


def test_command_before_the_recording_can_be_stated(tmp_path):
    (response,) = responses_of(read_recording(tmp_path, hold=True, before=1), {"t.pressure": "v.setpoint_pressure"})
    psi = 6894.757293168361
    assert np.allclose(response.commanded(np.array([-0.5, 0.0])), 1e5 + psi * np.array([1.0, 5.0]))
    with refused("fields.other_type", "recordings.r.inputs.v.setpoint_pressure.before"):
        read_recording(tmp_path, before="low")
    with refused("fields.other_type", "recordings.r.inputs.v.setpoint_pressure.hold"):
        read_recording(tmp_path, hold=1)

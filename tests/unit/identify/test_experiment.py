"""Model of a recording in a fit: sensors, delays and lags of inputs, and derivatives."""

from __future__ import annotations

import dataclasses
import itertools
import signal
import threading
from concurrent.futures import ThreadPoolExecutor

import numpy as np
import pytest

from poppet import Chamber, Circuit, FlowSource, Orifice, loads
from poppet.core.errors import InputError
from poppet.engine.call import RepeatedCall
from poppet.engine.lane_kernel import LockstepLanes
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.fit_plan import FitPlan, recording_parameters
from poppet.identify.fit.fit_series import apply_lag, first_value, shift_series
from poppet.identify.fit.intervals import add_bootstrap
from poppet.identify.fit.search import SearchSettings, count_restart_rounds, optimise
from poppet.identify.free_parameter import FreeParameter, read_free
from poppet.identify.result import Result
from poppet.signals import SampledSignal, Steps
from poppet.timeseries.measurements import Channel, InputChannel, Measurement

TIME = np.arange(0.0, 60.0, 0.1)
FLOW = 1e-3 * (np.clip((TIME - 5.0) / 3.0, 0.0, 1.0) - np.clip((TIME - 30.0) / 4.0, 0.0, 1.0))
PARTS = {"inlet": FlowSource(to="tank"), "tank": Chamber(volume="8 l", wall_conductance=6.0)}
FREE = (
    FreeParameter("tank.volume", "tank.volume", "m^3", 7e-3, 1e-4, 1.0),
    FreeParameter("tank.wall_conductance", "tank.wall_conductance", "W/K", 3.0, 0.0, 1e3),
)


def simulate_pressure() -> np.ndarray:
    circuit = Circuit(PARTS, {"inlet.mass_flow_rate": SampledSignal(TIME, FLOW, "truth")})
    noise = np.random.default_rng(1).normal(0.0, 300.0, TIME.size)
    return circuit.simulate(60.0, 0.1, 1e-9).interpolate("tank.pressure", TIME) + noise


def make_recording(flow: np.ndarray, **instrument: float | None) -> Measurement:
    return Measurement(
        "run",
        (Channel("tank.pressure", TIME, simulate_pressure(), "Pa", noise=300.0),),
        (InputChannel("inlet.mass_flow_rate", TIME, flow, "kg/s", **instrument),),
        duration=float(TIME[-1]),
    )


def fit_values(measurement: Measurement) -> dict[str, float]:
    circuit = Circuit(PARTS)
    free = (*FREE, *recording_parameters([measurement], [circuit], ["fit"]))
    optimum = optimise([Experiment(circuit.instance, measurement, free)], free)
    return {f.name: float(v) for f, v in zip(free, optimum.x, strict=True)}


def test_fit_recovers_the_lag_of_a_flow_meter():
    values = fit_values(make_recording(apply_lag(TIME, FLOW, 0.8), lag=None))
    assert values["run.inlet.mass_flow_rate.lag"] == pytest.approx(0.8, abs=0.05)
    assert values["tank.volume"] == pytest.approx(8e-3, rel=2e-3)
    assert values["tank.wall_conductance"] == pytest.approx(6.0, rel=2e-2)


def test_fit_recovers_the_delay_of_a_flow_meter():
    delayed_flow = np.interp(TIME - 1.3, TIME, FLOW)
    values = fit_values(make_recording(delayed_flow, delay=None))
    assert values["run.inlet.mass_flow_rate.delay"] == pytest.approx(1.3, abs=0.05)
    assert values["tank.volume"] == pytest.approx(8e-3, rel=2e-3)


SAMPLING = """
[parts.supply]
kind = "reservoir"
pressure = "4 bar"
[parts.fill]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "1e-9 m^3/(s Pa)"
critical_ratio = 0.3
[parts.vent]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = "1e-9 m^3/(s Pa)"
critical_ratio = 0.3
[parts.tank]
kind = "chamber"
thermal = "isothermal"
volume = "0.5 l"
[parts.controller]
kind = "electronics"
scaling = { high = "3 bar g" }
setpoint_delay = "0.12 s"
outer = { gain = 0.0, pilot_limit = "5 bar", sample_time = "10 ms" }
inner = { gain = 1e-4, vent_delay = "0.5 s", sample_time = "10 ms", hold_band = "1 kPa" }
[connections]
"fill.opening" = "controller.fill_duty"
"vent.opening" = "controller.vent_duty"
"controller.outlet_pressure" = "tank.pressure"
"controller.pilot_pressure" = "tank.pressure"
"""


def test_fit_recovers_parameters_of_a_sampled_controller():
    """The controller acts at sample instants: small differences would not show the effect of delay and gain."""
    circuit, grid = loads(SAMPLING), np.arange(0.0, 12.0, 0.03)
    # The last command before the run acts until the delay of the setpoint has passed.
    time, command = np.array([-1.0, 0.0, 2.0, 5.0, 7.0, 9.0]), np.array([1.2e5, 2.5e5, 1.5e5, 3e5, 2e5, 1.1e5])
    truth = dataclasses.replace(
        circuit.with_values({"controller.setpoint_delay": 0.0, "tank.initial_pressure": 1.2e5}),
        signals={"controller.setpoint": Steps(np.append(0.0, time[1:] + 0.12), command)},
    )
    clean = truth.simulate(12.0, 0.03, 1e-9).interpolate("tank.pressure", grid)
    noise = np.random.default_rng(0).normal(0.0, 300.0, grid.size)
    channel = Channel("tank.pressure", grid, clean + noise, "Pa", noise=300.0)
    driving = InputChannel("controller.setpoint", time, command, "Pa", hold=True)
    measurement = Measurement(
        "run", (channel,), (driving,), start={"tank.initial_pressure": 1.2e5}, duration=float(grid[-1])
    )
    starts = {
        "fill.sonic_conductance": (1.5e-9, 1e-9),
        "vent.sonic_conductance": (0.7e-9, 1e-9),
        "controller.inner.gain": (2e-4, 1e-4),
        "controller.inner.vent_delay": (0.3, 0.5),
        "controller.setpoint_delay": (0.05, 0.12),
    }
    free = tuple(read_free(name, {"start": start}, circuit) for name, (start, _) in starts.items())
    optimum = optimise([Experiment(circuit.instance, measurement, free)], free)
    for f, value in zip(free, optimum.x, strict=True):
        assert value == pytest.approx(starts[f.name][1], rel=0.02)
    assert optimum.cost == pytest.approx(0.5 * grid.size, rel=0.3)


def test_runs_on_threads_equal_single_runs_exactly(monkeypatch):
    circuit = loads(SAMPLING)
    channel = Channel("tank.pressure", TIME[:20], 1e5 + TIME[:20], "Pa", noise=300.0)
    starts = {"fill.sonic_conductance": 1.5e-9, "controller.inner.gain": 2e-4, "controller.setpoint_delay": 0.05}
    free = tuple(read_free(name, {"start": start}, circuit) for name, start in starts.items())
    experiment = Experiment(circuit.instance, Measurement("run", (channel,), duration=float(TIME[19])), free)
    slopes_by_threads = []
    for threads in (1, 2, 7):
        monkeypatch.setattr("poppet.identify.fit.experiment.usable_cores", lambda threads=threads: threads)
        slopes_by_threads.append(experiment.slopes(starts, 0.1)[0])
    assert all(np.array_equal(slopes, slopes_by_threads[0]) for slopes in slopes_by_threads)
    for f, column in zip(free, slopes_by_threads[0].T, strict=True):
        low, high = 0.9 * f.start, 1.1 * f.start
        down, up = (experiment.outputs({**starts, f.name: value})[0] for value in (low, high))
        assert column == pytest.approx((up - down) / (high - low), rel=1e-6)


def test_interruption_of_runs_on_threads_keeps_the_best_point(monkeypatch):
    """The main thread receives the signal while it waits for others; runs that are not started do not start."""
    steps = Steps(np.array([0.0, 0.1]), np.array([1e5, 3e5]))
    circuit = dataclasses.replace(loads(SAMPLING), signals={"controller.setpoint": steps})
    starts = {"fill.sonic_conductance": 1.5e-9, "controller.inner.gain": 2e-4}
    truth = circuit.with_values({"fill.sonic_conductance": 1e-9, "controller.inner.gain": 1e-4})
    channel = Channel("tank.pressure", TIME[:20], truth.simulate(1.9, 0.1)["tank.pressure"], "Pa", noise=300.0)
    free = tuple(read_free(name, {"start": start}, circuit) for name, start in starts.items())
    experiment = Experiment(circuit.instance, Measurement("run", (channel,), duration=float(TIME[19])), free)
    original_run, expected_slopes = RepeatedCall.run, experiment.slopes(starts, 0.1)[0]
    started_runs, costs, numbers, is_shut = [], [], itertools.count(1), threading.Event()

    class Pool(ThreadPoolExecutor):
        def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
            super().shutdown(wait=False, cancel_futures=cancel_futures)
            is_shut.set()
            super().shutdown(wait=wait)

    def run(runs: RepeatedCall) -> np.ndarray:
        if threading.current_thread() is not threading.main_thread():
            started_runs.append(len(costs))
            # Interrupt the derivatives at the third point of the search. Each run has its own number on all threads.
            if next(numbers) == 2 * 4 + 1:
                is_shut.clear()
                signal.pthread_kill(threading.main_thread().ident, signal.SIGINT)
                # Otherwise this thread can complete the other runs before the main thread cancels them.
                assert is_shut.wait(60.0)
        return original_run(runs)

    monkeypatch.setattr("poppet.identify.fit.experiment.usable_cores", lambda: 1)
    monkeypatch.setattr("poppet.identify.fit.experiment.ThreadPoolExecutor", Pool)
    monkeypatch.setattr(RepeatedCall, "run", run)
    # A process that a shell starts in the background ignores the signal.
    handler = signal.signal(signal.SIGINT, signal.default_int_handler)
    try:
        optimum = optimise([experiment], free, progress=lambda count, cost: costs.append(cost))
    finally:
        signal.signal(signal.SIGINT, handler)
    assert optimum.interrupted
    assert optimum.cost == costs[-1] < costs[0]
    # Four runs at each of two points, the interrupted run, and four runs for the statistics at the end.
    assert len(started_runs) == 2 * 4 + 1 + 4
    assert np.array_equal(experiment.slopes(starts, 0.1)[0], expected_slopes)


def test_bootstrap_fits_use_the_loss_of_the_fit_without_restarts(monkeypatch):
    """The fits start at the optimum and resample independent residuals: any correlation is random."""
    experiment = Experiment(Circuit(PARTS).instance, make_recording(FLOW), FREE)
    plan = FitPlan((experiment,), FREE, settings=SearchSettings(loss="huber"))
    result, settings_of_fits = Result("fit", "", {}, {}), []

    def optimise_and_store(bootstrapped, free, settings, **arguments):
        settings_of_fits.append((settings.loss, count_restart_rounds(settings, bootstrapped)))
        return optimise(bootstrapped, free, settings, **arguments)

    optimum = optimise(plan.experiments, FREE, plan.settings)
    monkeypatch.setattr("poppet.identify.fit.fit_plan.optimise", optimise_and_store)
    bootstrapped = add_bootstrap(plan, optimum, result, 2, lambda stage, done, total: None)
    assert settings_of_fits == [("huber", 0)] * 2
    assert [note.facts["fits"] for note in bootstrapped.remarks] == [2, 2]


def test_values_of_a_table_have_physical_bounds():
    table = {"kind": "table", "stroke": [0.0, 5e-4, 1e-3], "sonic_conductance": [0.0, 1e-9, 2e-9]}
    valve = Orifice(from_="tank", to="ambient", characteristic={**table, "critical_ratio": [0.3, 0.3, 0.2]})
    circuit = Circuit({"tank": Chamber(volume="8 l"), "valve": valve})
    conductance = read_free("valve.characteristic.sonic_conductance.y1", {}, circuit)
    ratio = read_free("valve.characteristic.critical_ratio.y1", {}, circuit)
    assert (conductance.start, conductance.low, conductance.high) == (1e-9, 0.0, np.inf)
    assert (ratio.start, ratio.low, ratio.high) == (0.3, 0.0, 1.0)
    paper = Orifice(from_="tank", to="ambient", characteristic="varga2012")
    circuit = Circuit({"tank": Chamber(volume="8 l"), "valve": paper})
    assert read_free("valve.characteristic.sonic_conductance.k1", {}, circuit).low == -np.inf


@pytest.fixture(params=["1", "4", "8"])
def lanes(request, monkeypatch):
    """Run a test with the scalar kernel and with lanes."""
    monkeypatch.setenv("POPPET_LANES", request.param)


@pytest.mark.usefixtures("lanes")
def test_derivatives_agree_with_central_differences():
    circuit, measurement = Circuit(PARTS), make_recording(FLOW)
    experiment = Experiment(circuit.instance, measurement, FREE, relative_tolerance=1e-9)
    values = {"tank.volume": 7.5e-3, "tank.wall_conductance": 5.0}
    slopes = experiment.slopes(values)
    for k, f in enumerate(FREE):
        step = 1e-3 * values[f.name]
        up, down = (experiment.outputs({**values, f.name: values[f.name] + sign * step})[0] for sign in (1.0, -1.0))
        central = (up - down) / (2.0 * step)
        assert np.max(np.abs(slopes[0][:, k] - central)) < 1e-4 * np.max(np.abs(central))


def test_derivatives_by_parameters_with_dependent_parameters():
    """The conductance depends on Kv and b, which have no index in the arrays of a run."""
    valve = Orifice(from_="tank", to="ambient", flow_coefficient_kv=0.04, critical_ratio=0.3, subsonic_index=0.5)
    tank = Chamber(volume="8 l", initial_pressure=5e5, wall_conductance=6.0)
    names = ("valve.flow_coefficient_kv", "valve.critical_ratio", "tank.volume")
    circuit = Circuit({"tank": tank, "valve": valve})
    free = tuple(read_free(name, {}, circuit) for name in names)
    channel = Channel("tank.pressure", TIME, np.full(TIME.size, 1e5), "Pa", noise=300.0)
    experiment = Experiment(
        circuit.instance, Measurement("run", (channel,), duration=60.0), free, relative_tolerance=1e-9
    )
    assert [name for name, slots in experiment.slots.items() if slots is None] == [
        "valve.flow_coefficient_kv",
        "valve.critical_ratio",
    ]
    values = {f.name: f.start for f in free}
    (slopes,) = experiment.slopes(values)
    for k, name in enumerate(names):
        up, down = (
            circuit.with_values({name: values[name] * factor}).simulate(60.0, 0.1, 1e-9)
            for factor in (1.0 + 1e-3, 1.0 - 1e-3)
        )
        central = np.diff([run.interpolate("tank.pressure", TIME) for run in (down, up)], axis=0)[0]
        central /= 2e-3 * values[name]
        assert np.max(np.abs(slopes[:, k] - central)) < 1e-3 * np.max(np.abs(central))


def test_lag_of_a_step_and_of_a_ramp():
    step = np.where(TIME < 1.0, 0.0, 1.0)
    response = apply_lag(TIME, step, 2.0)
    is_after_step = TIME > 1.5
    assert np.max(np.abs(response[is_after_step] - (1.0 - np.exp(-(TIME[is_after_step] - 0.95) / 2.0)))) < 2e-3
    assert apply_lag(TIME, TIME, 2.0)[-1] == pytest.approx(TIME[-1] - 2.0, abs=1e-9)
    assert np.array_equal(apply_lag(TIME, step, 0.0), step)


def test_shifted_recording_begins_at_zero():
    time, values = shift_series(np.array([0.0, 1.0, 2.0]), np.array([0.0, 10.0, 20.0]), 0.5)
    assert time.tolist() == [0.0, 0.5, 1.5]
    assert values.tolist() == [5.0, 10.0, 20.0]
    time, values = shift_series(np.array([0.0, 1.0]), np.array([3.0, 4.0]), -1.0)
    assert time.tolist() == [0.0, 1.0, 2.0]
    assert values.tolist() == [3.0, 3.0, 4.0]


def test_unknown_channel_is_rejected():
    measurement = Measurement("run", (Channel("tank.presure", TIME, FLOW, "Pa"),), duration=60.0)
    with pytest.raises(InputError) as error:
        Experiment(Circuit(PARTS).instance, measurement, FREE)
    assert (error.value.code, error.value.address) == ("names.unknown", "recordings.run.tank.presure")
    assert error.value.facts["suggestion"].names[0] == "tank.pressure"


def test_invalid_free_parameters_are_rejected():
    circuit = Circuit(PARTS)

    def problems_of(table, address="tank.volume"):
        with pytest.raises(InputError) as error:
            read_free(address, table, circuit)
        return [(e.code, e.address) for e in error.value.problems]

    assert problems_of({}, "tank.volum") == [("names.unknown", "free.tank.volum")]
    assert problems_of({"strt": 1.0}) == [("fields.unknown", "free.tank.volume.strt")]
    assert problems_of({"start": "9 l", "max": "8 l"}) == [("free.bounds", "free.tank.volume")]
    assert problems_of({"prior": {"mean": "8 l"}}) == [("fields.missing", "free.tank.volume.prior.sd")]
    assert problems_of({"prior": {"mean": "8 l", "sd": 0.0}}) == [("fields.out_of_range", "free.tank.volume.prior.sd")]
    assert problems_of({"prior": 3.0}) == [("fields.no_table", "free.tank.volume.prior")]
    assert problems_of({"start": "3 kg", "min": "1 s"}) == [
        ("quantity.other_quantity", "free.tank.volume.start"),
        ("quantity.other_quantity", "free.tank.volume.min"),
    ]


def test_standard_deviation_of_a_prior_is_a_difference():
    free = read_free("tank.initial_pressure", {"prior": {"mean": "5 bar g", "sd": "0.1 bar"}}, Circuit(PARTS))
    assert (free.prior.mean, free.prior.sd) == (pytest.approx(6e5), pytest.approx(1e4))


def test_first_value_is_smoothed_if_there_are_many_samples():
    truth = 7e5 * np.exp(-TIME / 30.0)
    errors = []
    for seed in range(50):
        noise = np.random.default_rng(seed).normal(0.0, 700.0, TIME.size)
        errors.append(first_value(Channel("tank.pressure", TIME, truth + noise, "Pa")) - 7e5)
    assert np.std(errors) < 0.8 * 700.0
    assert abs(np.mean(errors)) < 200.0
    sparse_channel = Channel("tank.pressure", TIME[::40], truth[::40] + 5.0, "Pa")
    assert first_value(sparse_channel) == 700005.0
    jump = np.where(TIME < 0.25, 1e5, 6e5)
    assert first_value(Channel("tank.pressure", TIME, jump, "Pa")) == 1e5


def test_free_start_value_without_channel_starts_at_the_value_of_the_circuit():
    measurement = Measurement(
        "run",
        (Channel("tank.pressure", TIME, simulate_pressure(), "Pa"),),
        (InputChannel("inlet.mass_flow_rate", TIME, FLOW, "kg/s"),),
        start={"tank.initial_temperature": "free"},
        duration=float(TIME[-1]),
    )
    circuit = Circuit(PARTS)
    (free,) = recording_parameters([measurement], [circuit], ["fit"])
    assert free.start == 293.15
    assert Experiment(circuit.instance, measurement, (free,)).free == (free,)


@pytest.mark.parametrize(("lanes", "runner"), [("1", RepeatedCall), ("4", LockstepLanes)])
def test_outputs_after_an_interrupted_run_are_not_reused(monkeypatch, lanes, runner):
    """A run overwrites the arrays of the previous run, whose outputs must not be used afterwards."""
    monkeypatch.setenv("POPPET_LANES", lanes)
    experiment = Experiment(Circuit(PARTS).instance, make_recording(FLOW), FREE)
    first_values, other_values = ({"tank.volume": v, "tank.wall_conductance": 5.0} for v in (7e-3, 9e-3))
    expected = experiment.outputs(first_values)[0]
    run = runner.run

    def interrupted(runs: RepeatedCall | LockstepLanes) -> np.ndarray:
        run(runs)
        raise KeyboardInterrupt

    monkeypatch.setattr(runner, "run", interrupted)
    with pytest.raises(KeyboardInterrupt):
        experiment.outputs(other_values)
    monkeypatch.setattr(runner, "run", run)
    assert np.array_equal(experiment.outputs(first_values)[0], expected)


def test_tiny_start_value_is_not_used_as_scale():
    """A search divides the bounds by the scale: a tiny scale would make them infinite."""
    free = FreeParameter("outlet.critical_ratio", "outlet.critical_ratio", "1", 1e-320, 0.0, 1.0)
    assert 1.0 / free.scale == pytest.approx(1e12)
    assert dataclasses.replace(free, start=1e-9).scale == 1e-9
    assert dataclasses.replace(free, start=0.0).scale == 1.0

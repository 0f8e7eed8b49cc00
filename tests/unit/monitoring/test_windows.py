"""Windows of samples: equality with a Kalman filter on a linear plant, outliers, missing samples, hypotheses.

The linear plant is an isothermal tank with choked flows: the valve fills it from a reservoir, and a nozzle empties it
to the ambient. Its pressure follows p' = a C p_s - b p, linear in p and in the sonic conductance C of the valve.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

import poppet
from exact.independent_watch_tank import (
    CIRCUIT,
    HEALTHY,
    ONE_PERCENT,
    Sensors,
    random_openings,
    readings,
    simulate,
)
from poppet.engine.estimator_call import EstimatorCall
from poppet.engine.problem import Outcome
from poppet.engine.state_start import model_from_state
from poppet.monitoring.plan import WatchPlan, read_plan
from poppet.monitoring.window_model import Samples
from poppet.monitoring.windows import Arrival, Window, WindowFit
from poppet.timeseries.signals import SampledSignal, Steps

SUPPLY, OUT, VOLUME, TEMPERATURE = 20e5, 4e-9, 1e-3, 293.15
GAS_CONSTANT, DENSITY_ANR = 287.05, 1.185
NOISE, INTERVAL, SAMPLES = 500.0, 0.1, 120
VALVE = 1.1e-9

PLANT = f"""
[parts.supply]
kind = "reservoir"
pressure = {SUPPLY}
[parts.valve]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = {VALVE}
critical_ratio = 0.5
[parts.nozzle]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = {OUT}
critical_ratio = 0.5
[parts.tank]
kind = "chamber"
thermal = "isothermal"
volume = {VOLUME}
initial_pressure = 5e5
[run]
duration = 1
"""


def plan_of(**offset: float) -> WatchPlan:
    """Return the plan with the conductance of the valve as fault, and the offset of the gauge as nuisance."""
    return read_plan(
        poppet.loads(PLANT),
        {"tank.pressure": {"noise": NOISE, **offset}},
        {"valve": {"address": "valve.sonic_conductance", "alarm": 0.01 * VALVE}},
    )


def transition(dt: float) -> tuple[np.ndarray, float]:
    """Return the exact transition of (p, C, offset) in a time, and the decay of the pressure."""
    rate = GAS_CONSTANT * TEMPERATURE / VOLUME * DENSITY_ANR
    decay = np.exp(-rate * OUT * dt)
    return np.array([[decay, SUPPLY / OUT * (1.0 - decay), 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]), decay


def kalman(
    mean: np.ndarray, covariance: np.ndarray, readings: np.ndarray, *, walk: float = 0.0
) -> tuple[np.ndarray, np.ndarray, np.ndarray, np.ndarray]:
    """Return the estimates at the end by a Kalman filter, and those at the start by a Rauch-Tung-Striebel smoother."""
    f, h = transition(INTERVAL)[0], np.array([[1.0, 0.0, 1.0]])
    q = np.diag([0.0, walk * INTERVAL, 0.0])
    past = [(mean, covariance)]
    ahead = []
    for reading in readings:
        mean, covariance = f @ mean, f @ covariance @ f.T + q
        ahead.append((mean, covariance))
        if np.isfinite(reading):
            gain = covariance @ h.T / (h @ covariance @ h.T + NOISE**2)
            mean = mean + (gain * (reading - h @ mean)).ravel()
            covariance = (np.eye(3) - gain @ h) @ covariance
        past.append((mean, covariance))
    smooth, spread = past[-1]
    for (mean, covariance), (predicted, uncertain) in zip(past[-2::-1], ahead[::-1], strict=True):
        gain = covariance @ f.T @ np.linalg.inv(uncertain)
        smooth = mean + gain @ (smooth - predicted)
        spread = covariance + gain @ (spread - uncertain) @ gain.T
    return *past[-1], smooth, spread


PRIOR = np.array([5e5, VALVE, 0.0])
SPREAD = np.array(
    [[3000.0**2, 0.3 * 3000.0 * 2e-11, 0.0], [0.3 * 3000.0 * 2e-11, 2e-11**2, 0.0], [0.0, 0.0, 1000.0**2]]
)
"""Arrival prior with a correlation between state and fault."""


def record(*, missing: float = 0.0, change: float = 1.5e-11) -> Samples:
    generator = np.random.default_rng(7)
    truth = np.array([5.02e5, VALVE + change, 700.0])
    readings = np.full(SAMPLES + 1, np.nan)
    for k in range(1, SAMPLES + 1):
        truth = transition(INTERVAL)[0] @ truth
        readings[k] = truth[0] + truth[2] + generator.normal(0.0, NOISE)
    readings[generator.random(readings.size) < missing] = np.nan
    times = 1000.0 + INTERVAL * np.arange(SAMPLES + 1)
    return Samples(times, readings[:, None], np.zeros((SAMPLES + 1, 0)))


TO_MODEL = np.diag([VOLUME / (GAS_CONSTANT * TEMPERATURE), 1.0, 1.0])
"""The state of the model is the mass of the gas, that of the Kalman filter its pressure."""


def arrival_of(time: float) -> Arrival:
    return Arrival(time, TO_MODEL @ PRIOR, TO_MODEL @ SPREAD @ TO_MODEL)


def fit(samples: Samples) -> WindowFit:
    return Window(plan_of(offset=1000.0), tolerance=1e-10).fit(samples, arrival_of(samples.times[0]))


def assert_same(mean: np.ndarray, covariance: np.ndarray, expected: np.ndarray, spread: np.ndarray) -> None:
    """Check a mean in standard deviations, and a covariance in units of its diagonal."""
    sigmas = np.sqrt(np.diag(spread))
    assert np.max(np.abs(mean - expected) / sigmas) < 1e-5
    assert np.max(np.abs(covariance - spread) / np.outer(sigmas, sigmas)) < 1e-6


def in_sigmas(values: np.ndarray, expected: np.ndarray, covariance: np.ndarray) -> float:
    return float(np.max(np.abs(values - expected) / np.sqrt(np.diag(covariance))))


@pytest.mark.parametrize("missing", [0.0, 0.5])
def test_a_window_equals_the_kalman_filter_at_its_end_and_the_smoother_at_its_start(missing: float) -> None:
    samples = record(missing=missing)
    mean, covariance, smooth, spread = kalman(PRIOR, SPREAD, samples.readings[1:, 0])
    result, from_model = fit(samples), np.linalg.inv(TO_MODEL)
    assert result.is_complete
    assert_same(from_model @ result.arrival.mean, from_model @ result.arrival.covariance @ from_model, mean, covariance)
    start = np.append(result.start, result.theta)
    assert_same(from_model @ start, from_model @ result.covariance @ from_model, smooth, spread)


def test_a_window_equals_the_estimator_of_the_filter() -> None:
    """The filter of poppet without process noise; its transition is exact for a linear plant, except for its steps."""
    samples, plan = record(missing=0.3), plan_of(offset=1000.0)
    instance = plan.instance
    model = model_from_state(instance.model)
    outputs = [[name for name, _ in model.outputs].index(channel.address) for channel in plan.channels]
    filter_ = EstimatorCall(
        model, outputs, plan.free.places.tolist(), plan.touched_inputs.tolist(), plan.directions, plan.effects,
        tolerance=1e-10,
    )  # fmt: skip
    numbers = instance.numbers()
    filter_.p[: numbers.size] = numbers
    filter_.base[:], filter_.reference[:] = filter_.p[plan.free.places], plan.reference
    filter_.u[:] = instance.held_inputs({})
    filter_.low[:], filter_.high[:], filter_.gates[:] = -np.inf, np.inf, np.inf
    filter_.noise[:], filter_.cap[:], filter_.walk[:] = NOISE**2, np.inf, 0.0
    arrival = arrival_of(samples.times[0])
    filter_.mean[:], filter_.covariance[:] = arrival.mean, arrival.covariance
    for reading in samples.readings[1:]:
        filter_.readings[:] = reading
        assert filter_.update(INTERVAL) is Outcome.DONE
    result = fit(samples)
    assert_same(result.arrival.mean, result.arrival.covariance, filter_.mean, filter_.covariance)


def test_two_windows_in_a_row_equal_one() -> None:
    samples, half = record(), SAMPLES // 2
    window = Window(plan_of(offset=1000.0), tolerance=1e-10)
    start = arrival_of(samples.times[0])
    first = window.fit(Samples(*(column[: half + 1] for column in samples)), start)
    # The readings up to the arrival time are in the prior: none counts twice.
    second, whole = window.fit(samples, first.arrival), window.fit(samples, start)
    assert second.times.size + first.times.size == whole.times.size
    assert in_sigmas(second.arrival.mean, whole.arrival.mean, whole.arrival.covariance) < 1e-5
    assert np.allclose(np.diag(second.arrival.covariance), np.diag(whole.arrival.covariance), rtol=1e-5)


def test_a_walk_within_the_window_is_the_only_difference_from_a_filter_with_a_walk() -> None:
    """A window has constant numbers, so its standard deviation is below that of a filter whose fault walks."""
    samples = record()
    walking = kalman(PRIOR, SPREAD, samples.readings[1:, 0], walk=(1e-12) ** 2)
    result, from_model = fit(samples), np.linalg.inv(TO_MODEL)
    assert result.arrival.covariance[1, 1] < walking[1][1, 1]
    assert 1e-4 < in_sigmas(from_model @ result.arrival.mean, walking[0], walking[1]) < 1.0


# A tank with valve, consumer and leak, simulated without poppet -------------------------------------------------------

MINUTE = 601


def tank_plan(**settings: object) -> WatchPlan:
    measured = {"tank.pressure": {"noise": 500.0}, "valve.opening": {}, "use.opening": {}}
    faults = {"leak": {"address": "leak.sonic_conductance", "alarm": ONE_PERCENT, "direction": "up"}}
    faults["use"] = {"address": "use.sonic_conductance", "alarm": 0.05 * HEALTHY.use}
    nuisances = {"valve.sonic_conductance": {"relative_sigma": 0.05}, "supply.pressure": {"sigma": "10 kPa"}}
    return read_plan(poppet.loads(CIRCUIT), measured, faults, nuisances, settings)


def tank_record(*, leak: float = HEALTHY.leak, sensors: Sensors | None = None, seed: int = 3) -> Samples:
    openings = random_openings(range(seed, seed + 1), MINUTE)
    course = simulate(replace(HEALTHY, leak=leak), openings)
    values = readings(HEALTHY, course, sensors or Sensors(), range(seed, seed + 1))[0]
    return Samples(course.time, values, openings[0])


def tank_arrival(plan: WatchPlan) -> Arrival:
    """Return the estimate of a filter on the healthy plant, which knows pressure and temperature."""
    start = np.array([HEALTHY.initial_pressure, HEALTHY.initial_pressure * HEALTHY.volume / (GAS_CONSTANT * 293.15)])
    spread = [200.0, 5e-4 * start[1], *np.minimum(plan.prior, [0.01 * ONE_PERCENT, 0.01 * HEALTHY.use, np.inf, np.inf])]
    return Arrival(0.0, np.append(start, plan.reference), np.diag(spread) ** 2)


@pytest.fixture(scope="module")
def tank() -> Window:
    return Window(tank_plan())


def test_a_healthy_window_finds_the_truth(tank: Window) -> None:
    result = tank.fit(tank_record(), tank_arrival(tank.plan))
    assert np.all(np.abs(result.theta - tank.plan.reference) < 4.0 * result.sigmas)
    assert result.probability > 1e-3
    assert result.whiteness[0] > 1e-3
    assert result.residuals.shape == (MINUTE - 1, 1)
    assert result.slopes.shape == (MINUTE - 1, 1, 6)


def test_the_derivatives_are_those_of_the_residuals(tank: Window) -> None:
    record, arrival = tank_record(), tank_arrival(tank.plan)
    model = tank.model.runs(record, 0.0, np.arange(6), np.zeros(0))
    steps = 1e-3 * np.append([1e5, 1e-3], tank.plan.prior)
    base = model.run(arrival.mean, tank.high)
    for k, step in enumerate(steps):
        ahead, behind = (model.run(arrival.mean + sign * step * np.eye(6)[k], tank.high) for sign in (1.0, -1.0))
        for name, slopes in (("readings", base.slopes[:, :, k]), ("end", base.end_slopes[:, k])):
            central = (getattr(ahead, name) - getattr(behind, name)) / (2.0 * step)
            assert np.max(np.abs(slopes - central)) < 1e-3 * np.max(np.abs(central))


def test_outliers_and_missing_readings_do_not_change_the_result(tank: Window) -> None:
    arrival = tank_arrival(tank.plan)
    clean = tank.fit(tank_record(), arrival)
    spoilt = tank_record(sensors=Sensors(outliers=0.01, missing=0.5))
    result = tank.fit(spoilt, arrival)
    is_spike = np.abs(spoilt.readings[1:] - tank_record().readings[1:]) > 2e4
    assert is_spike.any()
    assert np.all(result.used[is_spike] == -1)
    assert np.all(result.used[np.isnan(spoilt.readings[1:])] == 0)
    assert np.all(np.abs(result.theta - clean.theta) < 4.0 * result.sigmas)
    assert result.probability > 1e-3


def test_a_large_fault_is_fitted_and_not_extrapolated(tank: Window) -> None:
    """The arrival prior, from before the fault, is 1000 standard deviations away: it does not bind the hypothesis."""
    record, arrival = tank_record(leak=HEALTHY.leak + 10.0 * ONE_PERCENT), tank_arrival(tank.plan)
    leak, use, healthy = (tank.fit(record, arrival, free=free) for free in (["leak"], ["use"], []))
    assert abs(leak.theta[0] - HEALTHY.leak - 10.0 * ONE_PERCENT) < 4.0 * leak.sigmas[0]
    assert leak.probability > 1e-3 > use.probability
    assert leak.cost + 100.0 < use.cost < healthy.cost
    assert leak.theta[1] == tank.plan.reference[1]
    assert leak.sigmas[1] == 0.0


def test_scatter_frees_the_other_faults_a_little(tank: Window) -> None:
    record, arrival = tank_record(leak=HEALTHY.leak + ONE_PERCENT), tank_arrival(tank.plan)
    strict, loose = (tank.fit(record, arrival, free=["leak"], scatter=scatter) for scatter in (0.0, 0.05))
    assert 0.0 < loose.sigmas[1] <= 0.05 * 0.05 * HEALTHY.use
    assert loose.sigmas[0] > strict.sigmas[0]
    assert loose.cost <= strict.cost


def test_a_leak_far_below_zero_ends_at_the_limit(tank: Window) -> None:
    """A consumer that takes less than the circuit states looks like a leak below zero."""
    record = tank_record(leak=0.0)
    record = record._replace(inputs=record.inputs * [1.0, 1.4])
    result = tank.fit(record, tank_arrival(tank.plan), free=["leak"])
    assert result.theta[0] == tank.plan.low[0]


def test_a_second_start_finds_a_fault_that_the_first_one_misses(tank: Window) -> None:
    record = tank_record(leak=HEALTHY.leak + 100.0 * ONE_PERCENT)
    far = tank.plan.reference.copy()
    far[0] = 1e4 * ONE_PERCENT
    result = tank.fit(record, tank_arrival(tank.plan), free=["leak"], begin=far)
    assert abs(result.theta[0] - HEALTHY.leak - 100.0 * ONE_PERCENT) < 5.0 * result.sigmas[0]


TWO_TANKS = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.valve]
kind = "spool_valve"
supply = "supply"
a = "first"
b = "second"
exhaust_a = "ambient"
exhaust_b = "ambient"
sonic_conductance = "0.2 dm^3/(s bar)"
delay = {delay}
[parts.first]
kind = "chamber"
volume = "1 l"
wall_conductance = 1.0
[parts.second]
kind = "chamber"
volume = "1 l"
wall_conductance = 1.0
[run]
duration = 6
output_step = 0.1
relative_tolerance = 1e-9
"""


@pytest.mark.parametrize("hold", [True, False])
@pytest.mark.parametrize("delay", [0.0, 0.25])
def test_the_inputs_of_a_window_are_those_of_a_run(delay: float, hold: bool) -> None:
    """The second window begins after a delayed change that has not yet come into effect."""
    circuit = poppet.loads(TWO_TANKS.format(delay=delay))
    measured = {name: {"noise": 500.0} for name in ("first.pressure", "second.pressure")}
    measured["valve.command"] = {"hold": hold}
    plan = read_plan(circuit, measured, {"valve": {"address": "valve.sonic_conductance", "alarm": 1e-11}})
    times, generator = 0.1 * np.arange(61), np.random.default_rng(5)
    command = np.repeat(generator.uniform(-1.0, 1.0, 21), 3)[:61]
    signal = Steps(times, command) if hold else SampledSignal(times, command, "command")
    run = circuit.with_signals({"valve.command": signal}).simulate()
    expected = np.column_stack([run["first.pressure"], run["second.pressure"]])
    command[19] = np.nan  # a missing value in the middle of an interval of constant or linear inputs
    record = Samples(times, np.full((61, 2), np.nan), command[:, None])
    window = Window(plan, tolerance=1e-9)
    n = window.model.n_states
    begin = Arrival(0.0, np.append(circuit.instance.start()[0][:n], plan.reference), np.zeros((n + 1, n + 1)))
    first = window.model.runs(Samples(*(c[:34] for c in record)), 0.0, np.zeros(0, dtype=np.int64), np.zeros(0))
    early = first.run(begin.mean, window.high)
    later = window.model.runs(record, float(times[33]), np.zeros(0, dtype=np.int64), np.zeros(0))
    late = later.run(np.append(early.end, plan.reference), window.high)
    assert np.max(np.abs(early.readings - expected[:34])) < 1.0
    assert np.max(np.abs(late.readings - expected[33:])) < 1.0


def test_runs_one_after_the_other_equal_those_in_lanes(tank: Window, monkeypatch: pytest.MonkeyPatch) -> None:
    record, arrival = tank_record(), tank_arrival(tank.plan)
    lanes = tank.fit(record, arrival)
    monkeypatch.setattr("poppet.monitoring.window_model.LockstepLanes.can_run", lambda problem: False)
    calls = tank.fit(record, arrival)
    assert np.all(np.abs(calls.theta - lanes.theta) < 1e-3 * lanes.sigmas)
    assert np.allclose(calls.sigmas, lanes.sigmas, rtol=1e-3)


def test_a_run_that_fails_is_not_complete(tank: Window) -> None:
    """The mass of the gas is negative in the arrival prior, so no run starts."""
    arrival = tank_arrival(tank.plan)
    arrival.mean[0] = np.nan
    result = tank.fit(tank_record(), arrival)
    assert not result.is_complete
    assert result.probability == 0.0


@pytest.mark.parametrize("is_in_lanes", [True, False])
def test_a_run_with_too_many_steps_fails(tank: Window, monkeypatch: pytest.MonkeyPatch, is_in_lanes: bool) -> None:
    if not is_in_lanes:
        monkeypatch.setattr("poppet.monitoring.window_model.LockstepLanes.can_run", lambda problem: False)
    assert tank.fit(tank_record(), tank_arrival(tank.plan)).is_complete
    monkeypatch.setattr("poppet.monitoring.window_model.MOST_ATTEMPTS", 5)
    monkeypatch.setattr("poppet.monitoring.window_model.ATTEMPTS_PER_ROW", 0)
    assert not tank.fit(tank_record(), tank_arrival(tank.plan)).is_complete


CONTROLLED = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.fill]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "0.5 dm^3/(s bar)"
[parts.vent]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = "0.5 dm^3/(s bar)"
[parts.tank]
kind = "chamber"
volume = "1 l"
wall_conductance = 1.5
initial_pressure = "3 bar"
[parts.regulator]
kind = "pid"
gain = "9 1/bar"
integral_time = "70 ms"
sample_time = "7 ms"
[connections]
"regulator.measurement" = "tank.pressure"
"fill.opening" = "regulator.fill_command"
"vent.opening" = "regulator.vent_command"
"""


def test_a_sampled_controller_in_the_model_continues_from_its_discrete_state() -> None:
    """The window begins at a time that is no sample instant; the timer of the controller has the clock of the plant."""
    circuit = poppet.loads(CONTROLLED)
    measured = {"tank.pressure": {"noise": 300.0}, "regulator.setpoint": {}}
    conductance = circuit.numbers()["fill.sonic_conductance"].value
    plan = read_plan(circuit, measured, {"fill": {"address": "fill.sonic_conductance", "alarm": 0.01 * conductance}})
    times = 0.02 * np.arange(151)
    setpoint = np.where(times % 2.0 < 1.0, 3e5, 4e5)
    driven = circuit.with_signals({"regulator.setpoint": Steps(times, setpoint)})
    truth = driven.with_values({"fill.sonic_conductance": 1.05 * conductance}).simulate(3.0, 0.02, 1e-8)
    readings = truth["tank.pressure"] + np.random.default_rng(1).normal(0.0, 300.0, times.size)
    instance = driven.instance
    state, p = instance.start()
    window, count = Window(plan), len(instance.model.states)
    memory = p[len(instance.model.parameters) :].copy()
    memory[: instance.model.n_timers] += 100.0
    spread = np.append(np.full(count, 1e-4) * state[:count], plan.prior)
    arrival = Arrival(100.0, np.append(state[:count], plan.reference), np.diag(spread**2), memory)
    result = window.fit(Samples(times + 100.0, readings[:, None], setpoint[:, None]), arrival)
    assert result.is_complete
    # The differences of sampled circuits are coarse: 5 % of a change of 5 %.
    assert abs(result.theta[0] / conductance - 1.05) < 4.0 * result.sigmas[0] / conductance + 0.0025
    assert result.sigmas[0] < 0.01 * conductance
    # The next sample instant after the window of 3 s, and the discrete state of the controller.
    assert 103.0 < result.arrival.memory[0] <= 103.0 + 0.007 + 1e-9
    assert result.arrival.memory.shape == memory.shape

"""The estimator of states and free numbers: its transition, its filter, its limits, and its bits in C."""

from __future__ import annotations

import numpy as np
import pytest

from circuits_of_exports import TEN
from estimators import estimator_of, move_to_c
from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.circuit.free_numbers import free_numbers
from poppet.engine.estimator_call import EstimatorCall
from poppet.engine.estimator_job import EstimatorJob
from poppet.engine.job import address
from poppet.engine.problem import Outcome
from poppet.timeseries.signals import Points

OF_CIRCUIT = {
    "staircase": (["valve.upper_spring.preload", "tank.volume"], ["tank.pressure", "tank.temperature"]),
    "two tanks": (["pipe.sonic_conductance", "low.wall_conductance"], ["high.pressure", "low.pressure"]),
    "regulator": (["supply.pressure", "tank.volume"], ["tank.pressure"]),
    "check and relief": (["vessel.wall_conductance", "relief.sonic_conductance"], ["vessel.pressure"]),
    "cylinder": (["slide.friction.coulomb_force", "supply.pressure"], ["cylinder.cap.pressure", "slide.position"]),
}


def run_of(call, count: int, interval: float, seed: int = 1) -> list[np.ndarray]:
    """Estimates and covariances of a filter with readings that scatter about its own forecast."""
    rng, rows = np.random.default_rng(seed), []
    for _ in range(count):
        assert call.advance(interval) is Outcome.DONE
        call.readings[:] = np.nan
        call.correct()
        call.readings[:] = call.expected + np.sqrt(call.noise) * rng.normal(size=call.noise.size)
        assert call.correct() is Outcome.DONE
        rows.append(np.concatenate([call.mean, call.covariance.ravel(), [call.nis], call.deviations]))
    return rows


def started(call) -> None:
    call.covariance[:] = np.diag((1e-3 * np.abs(call.mean) + 1e-9) ** 2)
    call.correct()
    call.noise[:] = (1e-3 * np.abs(call.expected) + 1e-6) ** 2


@pytest.mark.parametrize("name", OF_CIRCUIT)
def test_the_estimator_in_c_gives_the_same_bits(name, tmp_path):
    circuit: Circuit = TEN[name]()
    addresses, outputs = OF_CIRCUIT[name]
    calls = [estimator_of(circuit, addresses, outputs, fuses=False) for _ in range(2)]
    free = free_numbers(circuit.instance, addresses)
    places = [[o for o, _ in circuit.symbolic_model.outputs].index(output) for output in outputs]
    move_to_c(calls[1], places, free.places.tolist(), free.inputs.tolist(), tmp_path)
    for call in calls:
        started(call)
        call.walk[-2:] = (1e-3 * call.reference) ** 2
    theirs, mine = (run_of(call, 60, 0.01) for call in calls)
    assert np.array_equal(theirs, mine)
    assert np.isfinite(theirs).all()


# Predictions ------------------------------------------------------------------------------------------------------

PARTS = {
    "supply": Reservoir(pressure="7 bar"),
    "valve": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
    "tank": Chamber(volume="10 l", wall_conductance=4.0, initial_pressure="5 bar"),
    "use": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3),
    "leak": Orifice(from_="tank", to="ambient", sonic_conductance=1e-10, critical_ratio=0.3),
}
FREE = ["leak.sonic_conductance", "valve.sonic_conductance", "supply.pressure"]


def tank(tolerance: float = 1e-6) -> EstimatorCall:
    call = estimator_of(Circuit(PARTS), FREE, ["tank.pressure", "valve.mass_flow_rate"], tolerance)
    started(call)
    return call


def opening(call: EstimatorCall, part: str) -> int:
    return [item.name for item in call.kernel.model.inputs].index(f"{part}.opening")


def test_inputs_that_change_linearly_are_signals_of_straight_lines():
    times, openings = np.linspace(0.0, 10.0, 6), np.array([0.0, 1.0, 0.2, 0.2, 0.9, 0.0])
    circuit, call = Circuit(PARTS, {"valve.opening": Points(times, openings)}), tank(1e-9)
    recording = circuit.simulate(10.0, 2.0, 1e-10)
    for k in range(5):
        call.u[:, opening(call, "valve")] = openings[k : k + 2]
        assert call.advance(2.0) is Outcome.DONE
        assert call.mean[0] == pytest.approx(recording["tank.pressure"][k + 1], rel=1e-7)


def test_the_length_of_intervals_does_not_matter():
    calls = tank(1e-10), tank(1e-10)
    transition = np.eye(5)
    for _ in range(100):
        assert calls[0].advance(0.05) is Outcome.DONE
        step = np.eye(5)
        step[:2] = calls[0].transition
        transition = step @ transition
    assert calls[1].advance(5.0) is Outcome.DONE
    assert calls[0].mean == pytest.approx(calls[1].mean, rel=1e-8)
    assert calls[1].transition == pytest.approx(transition[:2], rel=1e-4)
    assert calls[0].covariance == pytest.approx(calls[1].covariance, rel=1e-4)
    assert calls[0].time[0] == pytest.approx(5.0)


def test_sampled_controllers_act_as_in_a_run():
    circuit = TEN["regulator"]()
    signal = Points([0.0, 1.0], [2e5, 2e5])
    recording = circuit.with_signals({"valve.setpoint": signal}).simulate("2 s", "0.2 s", 1e-8)
    call = estimator_of(circuit.with_signals({"valve.setpoint": signal}), ["tank.volume"], ["tank.pressure"], 1e-8)
    call.u[:, [item.name for item in call.kernel.model.inputs].index("valve.setpoint")] = 2e5
    call.readings[:] = np.nan
    pressures = []
    for _ in range(10):
        assert call.update(0.2) is Outcome.DONE
        pressures.append(call.expected[0])
    assert recording["tank.pressure"][-1] > 1.1 * recording["tank.pressure"][0]
    assert pressures == pytest.approx(recording["tank.pressure"][1:], rel=1e-4)


def test_a_circuit_without_states_has_free_numbers_only():
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": Orifice(from_="supply", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3),
    }
    call = estimator_of(Circuit(parts), ["valve.sonic_conductance"], ["valve.mass_flow_rate"])
    call.covariance[0, 0], call.noise[0], call.walk[0], call.readings[0] = 1e-18, 1e-8, 1e-20, np.nan
    assert call.update(1.0) is Outcome.DONE
    flow = call.expected[0]
    call.readings[0] = 1.1 * flow
    prior, slope = call.covariance[0, 0], flow / 1e-8
    assert prior == pytest.approx(1.01e-18)
    assert call.correct() is Outcome.DONE
    variance = slope * slope * prior + 1e-8
    assert call.mean[0] == pytest.approx(1e-8 + prior * slope / variance * 0.1 * flow, rel=1e-9)
    assert call.nis == pytest.approx((0.1 * flow) ** 2 / variance, rel=1e-9)


def test_a_variance_without_readings_grows_to_its_cap():
    call = tank()
    call.walk[2:], call.cap[2:] = (0.1 * call.reference) ** 2, (0.2 * call.reference) ** 2
    for _ in range(10):
        assert call.advance(1.0) is Outcome.DONE
    assert np.diag(call.covariance)[2:] == pytest.approx((0.2 * call.reference) ** 2)
    assert np.linalg.eigvalsh(correlation(call.covariance)).min() > 0.0


# Corrections ------------------------------------------------------------------------------------------------------


def correlation(covariance: np.ndarray) -> np.ndarray:
    sizes = np.sqrt(np.diag(covariance))
    return covariance / np.outer(sizes, sizes)


def test_an_outlier_is_rejected_and_the_other_channel_is_used():
    calls = tank(), tank()
    for call in calls:
        call.advance(0.1)
        call.gates[:] = 9.0
        call.readings[:] = np.nan
        call.correct()
    expected, deviations = calls[0].expected.copy(), calls[0].deviations.copy()
    calls[0].readings[:] = expected + np.array([3.1, 2.0]) * deviations
    calls[1].readings[:] = [np.nan, expected[1] + 2.0 * deviations[1]]
    for call in calls:
        assert call.correct() is Outcome.DONE
    assert calls[0].used.tolist() == [-1.0, 1.0]
    assert calls[1].used.tolist() == [0.0, 1.0]
    assert np.array_equal(calls[0].mean, calls[1].mean)
    assert np.array_equal(calls[0].covariance, calls[1].covariance)
    assert calls[0].nis == pytest.approx(4.0)


def test_a_limit_gives_the_most_probable_estimate_with_this_limit():
    calls = tank(), tank()
    for call in calls:
        call.covariance[2:, 2:] = np.diag([(1e-9) ** 2, (1e-9) ** 2, (5e3) ** 2])
        assert call.advance(1.0) is Outcome.DONE
        call.readings[:] = np.nan
        call.correct()
        call.readings[0] = call.expected[0] + 4.0 * call.deviations[0]
    calls[0].low[:] = -np.inf
    for call in calls:
        assert call.correct() is Outcome.DONE
    free, limited = (call.mean for call in calls)
    assert free[2] < 0.0
    # Lagrange multiplier of the constraint theta_0 = 0 in the metric of the covariance.
    covariance = calls[0].covariance
    assert np.array_equal(covariance, calls[1].covariance)
    assert limited == pytest.approx(free - covariance[:, 2] / covariance[2, 2] * free[2], rel=1e-12, abs=1e-24)


def test_positive_states_remain_positive():
    call = tank()
    call.covariance[:2, :2] = np.diag((10.0 * call.mean[:2]) ** 2)
    call.readings[:] = [-1e6, np.nan]
    before = call.mean.copy()
    assert call.correct() is Outcome.DONE
    assert (call.mean[:2] >= 0.1 * before[:2]).all()
    assert call.advance(0.1) is Outcome.DONE


@pytest.mark.parametrize("count", [pytest.param(1_000_000, marks=pytest.mark.slow), 10_000])
def test_the_covariance_remains_positive(count):
    """Without state noise, and with constant numbers."""
    call, rng = tank(), np.random.default_rng(29)
    call.low[:] = 0.2 * call.reference
    call.covariance[2:, 2:] = np.diag((0.3 * call.reference) ** 2)
    scatter = rng.normal(size=(1000, 2)) * np.sqrt(call.noise)
    for k in range(count):
        if k % 50 == 0:
            call.u[:, opening(call, "valve")], call.u[:, opening(call, "use")] = rng.uniform(0.0, 1.0, 2)
            call.readings[:] = np.nan
            call.correct()
        call.readings[:] = call.expected + scatter[k % 1000]
        assert call.update(0.1) is Outcome.DONE
        if k % 1000 == 0:
            assert np.linalg.eigvalsh(correlation(call.covariance)).min() > 0.0
            assert np.array_equal(call.covariance, call.covariance.T)


# Failures ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("failure", ["attempts", "state", "interval", "negative", "reading", "covariance"])
def test_a_failure_changes_nothing(failure):
    call = tank()
    call.readings[:] = call.expected
    expected = Outcome.NOT_FINITE
    if failure == "attempts":
        call._limits[1], expected = 2, Outcome.TOO_MANY
    if failure == "state":
        call.mean[0], expected = np.nan, Outcome.STALLED
    if failure == "covariance":
        call.covariance[0, 0] = np.inf
    if failure == "reading":
        call.mean[0] = np.inf
    before = call.time.copy(), call.mean.copy(), call.covariance.copy(), call.p.copy()
    dt = {"interval": np.nan, "negative": -0.1}.get(failure, 1.0)
    assert (call.correct() if failure == "reading" else call.advance(dt)) is expected
    after = call.time, call.mean, call.covariance, call.p
    assert all(np.array_equal(a, b, equal_nan=True) for a, b in zip(before, after, strict=True))


def test_a_filter_continues_after_a_failure():
    calls = tank(), tank()
    calls[0]._limits[1] = 1
    assert calls[0].advance(1.0) is Outcome.TOO_MANY
    for call in calls:
        call.restart()
        assert call.advance(1.0) is Outcome.DONE
    assert np.array_equal(calls[0].mean, calls[1].mean)


@pytest.mark.parametrize("name", OF_CIRCUIT)
def test_the_memory_of_the_job_suffices(name):
    addresses, outputs = OF_CIRCUIT[name]
    call = estimator_of(TEN[name](), addresses, outputs, onsets=2, faults=1)
    started(call)
    field = EstimatorJob._fields.index("memory")
    size = call._block.size - (call._jobs[0][field] - address(call._block)) // 8
    guarded = np.zeros(size + 100)
    guarded[size:] = 1.25
    for row in call._jobs:
        row[field] = address(guarded)
    run_of(call, 3, 0.01)
    assert np.all(guarded[size:] == 1.25)
    # The last array are the inputs at the end of the last interval.
    n_u = call.u.shape[1]
    assert np.array_equal(guarded[size - n_u : size], call.u[1])

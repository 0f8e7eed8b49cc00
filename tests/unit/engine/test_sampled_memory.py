"""Sampled memory in the kernel: exact at its instants, in their order, with rows, stop conditions and resumed runs."""

from __future__ import annotations

import sys
from decimal import Decimal
from pathlib import Path

import numpy as np
import pytest

from poppet import Circuit
from poppet.circuit.options import Run
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.engine.problem import Outcome
from poppet.engine.reference_solvers import track
from poppet.engine.solve import solve
from poppet.parts import Chamber, FlowSource, MainStage, Orifice, ProportionalValve, Reservoir
from poppet.signals import Points, Square, Steps
from refusals import refused

sys.path.insert(0, str(Path(__file__).parents[1]))
from sampled_parts import Chain, Clocks, Feeder, Lag, Proportional

GAS_CONSTANT, TEMPERATURE = 287.05, 293.15


def fed_chamber(gain: float, sample_time: float, wanted: Steps, **chamber: object) -> Circuit:
    """An isothermal chamber whose flow source is under sampled proportional control."""
    parts = {
        "tank": Chamber(**{"volume": "1 l", "thermal": "isothermal", **chamber}),
        "feed": FlowSource(to="tank"),
        "control": Feeder(gain=gain, sample_time=sample_time),
    }
    connections = {"control.measured": "tank.pressure", "feed.mass_flow_rate": "control.output"}
    return Circuit(parts, {"control.wanted": wanted}, connections=connections)


def observed(signal: object, sample_time: float = 0.1, gain: float = 1.0) -> Circuit:
    """A controller alone, which samples its setpoint."""
    parts = {"control": Proportional(gain=gain, sample_time=sample_time)}
    return Circuit(parts, {"control.wanted": signal})


# --- Exact at the instants ---


@pytest.mark.parametrize(("gain", "sample_time"), [(2e-8, 0.1), (5e-9, 0.03), (1.8e-6, 0.01), (1e-8, 1 / 7)])
def test_a_chamber_under_sampled_control_follows_the_exact_recursion(gain, sample_time):
    run = fed_chamber(gain, sample_time, Steps([0.0, 0.4], [3e5, 1.5e5])).simulate(1.0, 0.01)
    # m' is constant between instants, and p = m R T / V.
    slope = GAS_CONSTANT * TEMPERATURE / 1e-3 * gain
    grid, instant, before, pressure, expected = run.time, 0.0, 0.0, 1e5, []
    count, rate = 0, 0.0
    for t in grid:
        while instant <= t + track.rounding(t) and instant < 1.0 - 1e-12:
            pressure += rate * (instant - before)
            rate = slope * ((3e5 if instant < 0.4 - 1e-12 else 1.5e5) - pressure)
            before, count = instant, count + 1
            instant = count * sample_time
        expected.append(pressure + rate * (t - before))
    assert np.max(np.abs(run["tank.pressure"] / np.array(expected) - 1.0)) < 1e-9


@pytest.mark.parametrize("time_constant", [1e-3, 0.05, 3.0])
def test_a_lag_behind_a_sampler_follows_the_exact_recursion(time_constant):
    parts = {"control": Proportional(gain=0.9, sample_time=0.07), "lag": Lag(time_constant=time_constant)}
    connections = {"control.measured": "lag.output", "lag.input": "control.output"}
    circuit = Circuit(parts, {"control.wanted": Steps([0.0], [1.0])}, connections=connections)
    run = circuit.simulate(2.0, 0.07, 1e-10)
    decay, x, total = np.exp(-0.07 / time_constant), 0.0, 0.0
    for k in range(28):
        assert run["lag.output"][k] == pytest.approx(x, abs=1e-9)
        assert run["lag.integral"][k] == pytest.approx(total, abs=1e-9)
        u = 0.9 * (1.0 - x)
        assert run["control.output"][k] == pytest.approx(u, abs=1e-9)
        x, total = u + (x - u) * decay, total + 0.07 * u


def test_a_part_without_states_remembers_exactly():
    run = observed(Points([0.0, 1.0], [2.0, 3.0]), 0.1, 2.0).simulate(1.0, 0.05)
    held = 2.0 * (2.0 + 0.1 * (np.arange(21) // 2))
    held[-1] = held[-2]
    np.testing.assert_allclose(run["control.output"], held, rtol=1e-14)
    assert run.statistics == {"accepted_steps": 0, "rejected_steps": 0}


# --- Clocks ---


@pytest.mark.parametrize("periods", [(0.1, 0.1 * 2**0.5), (0.0137, 1 / 3), (0.01, 0.0100001), (0.3, 0.7)])
def test_incommensurate_clocks_tick_at_multiples_of_their_periods(periods):
    first, second = periods
    clocks = Circuit({"clocks": Clocks(first_period=first, second_period=second)})
    run = clocks.simulate(5.0, 0.003)
    for name, period in zip(("first", "second"), periods, strict=True):
        ticked = np.floor(run.time[:-1] / period * (1.0 + 1e-13)) + 1.0
        assert np.array_equal(run[f"clocks.{name}_count"][:-1], ticked)


@pytest.mark.parametrize(("first", "second"), [(0.0137, 0.0291), (0.0291, 0.0137), (0.1, 0.1 * 2**0.5)])
def test_clocks_tick_in_the_order_of_their_instants(first, second):
    # The second clock writes down how often the first has ticked before it.
    run = Circuit({"clocks": Clocks(first_period=first, second_period=second)}).simulate(3.0, 1e-3)
    latest = (run["clocks.second_count"] - 1.0) * second
    assert np.array_equal(run["clocks.seen"], np.floor(latest / first + 1e-9) + 1.0)


@pytest.mark.parametrize(("first", "second", "phase"), [(0.1, 0.3, 0.0), (0.1, 0.3, 0.7), (1 / 3, 1.0, 0.0)])
def test_at_a_common_instant_the_lower_rank_acts_first(first, second, phase):
    # The second clock, declared first, has the higher rank; 3 * 0.1 and 0.3 differ by rounding.
    circuit = Circuit({"clocks": Clocks(first_period=first, second_period=second, phase=phase)})
    run = circuit.simulate(20.05, 0.05)
    late = run["clocks.second_count"] > 0.0
    assert np.all(run["clocks.order"][late] == 1.0)
    assert np.array_equal(run["clocks.common"], run["clocks.second_count"])


def test_clocks_that_do_not_meet_have_no_common_instant():
    run = Circuit({"clocks": Clocks(first_period=0.1, second_period=0.1, phase=0.05)}).simulate(2.0, 0.01)
    assert run["clocks.second_count"][-1] == 20.0
    assert np.all(run["clocks.common"] == 0.0)


def test_a_timer_may_be_set_to_the_same_instant_again():
    run = Circuit({"chain": Chain(links=3, period=0.25)}).simulate(2.0, 0.05)
    ticks = np.floor(run.time / 0.25 + 1e-9) + 1.0
    ticks[-1] = 8.0
    assert np.array_equal(run["chain.ticks"], ticks)
    assert np.array_equal(run["chain.total"], 3.0 * ticks)


def test_late_instants_are_not_shifted_by_rounding():
    run = observed(Points([0.0, 1000.0], [0.0, 1000.0]), 1e-3).simulate(1000.0, 9.7)
    inside = run.time[:-1]
    assert np.max(np.abs(run["control.output"][:-1] - np.floor(inside * 1000.0 + 1e-6) * 1e-3)) < 1e-9


# --- Steps, rows and the end ---


@pytest.mark.parametrize("period", ["0.1", "0.35", "0.07", "0.001", "0.0123"])
def test_a_step_on_an_instant_is_seen_at_that_instant(period):
    # n T as a float lies on either side of the decimal, or on it.
    for count in (1, 3, 6, 7, 29, 58):
        step = float(count * Decimal(period))
        circuit = observed(Steps([0.0, step], [1.0, 2.0]), float(period))
        run = circuit.simulate(float((count + 1) * Decimal(period)), float(period))
        assert run["control.output"].tolist() == [1.0] * count + [2.0, 2.0]


def test_rows_on_an_instant_show_the_value_after_it_and_the_last_row_the_one_before():
    run = observed(Points([0.0, 1.0], [0.0, 1.0]), 0.1).simulate(1.0, 0.1)
    assert run["control.count"].tolist() == [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 10]
    with_states = fed_chamber(1e-8, 0.1, Steps([0.0], [2e5])).simulate(1.0, 0.1)
    assert with_states["control.count"].tolist() == run["control.count"].tolist()


def test_rows_between_steps_show_the_memory_of_their_time():
    # The chamber is at rest, so that a step of the integrator passes over many instants.
    parts = {"tank": Chamber(volume="1 l"), "feed": FlowSource(to="tank"), "control": Proportional(sample_time=1e-3)}
    circuit = Circuit(parts, {"control.wanted": Points([0.0, 1.0], [0.0, 1.0])})
    run = circuit.simulate(1.0, 1e-4)
    assert run.statistics["accepted_steps"] < 100
    ticks = np.floor(run.time[:-1] * 1e3 + 1e-6)
    np.testing.assert_allclose(run["control.output"][:-1], ticks * 1e-3, atol=1e-12)


# --- Stop conditions ---


@pytest.mark.parametrize("solver", ["rosenbrock", "cvodes", "lsoda", "radau"])
class TestStopping:
    def test_where_a_state_crosses_between_instants(self, solver):
        circuit = fed_chamber(2e-8, 0.1, Steps([0.0], [3e5]))
        run = circuit.simulate(5.0, 0.1, stop_when="tank.pressure > 1.5 bar", solver=solver)
        slope, pressure, k = GAS_CONSTANT * TEMPERATURE / 1e-3 * 2e-8, 1e5, 0
        while pressure + 0.1 * slope * (3e5 - pressure) < 1.5e5:
            pressure, k = pressure + 0.1 * slope * (3e5 - pressure), k + 1
        assert run.time[-1] == pytest.approx(0.1 * k + (1.5e5 - pressure) / (slope * (3e5 - pressure)), rel=1e-8)
        assert run["tank.pressure"][-1] == pytest.approx(1.5e5, rel=1e-9)

    def test_on_the_instant_at_which_the_memory_meets_it(self, solver):
        circuit = fed_chamber(2e-8, 0.1, Steps([0.0], [3e5]))
        run = circuit.simulate(5.0, 0.1, stop_when="control.count > 7.5", solver=solver)
        assert run.time[-1] == pytest.approx(0.7, rel=1e-12)
        assert run["control.count"][-1] == 8.0

    def test_at_the_start_it_sees_the_first_sample(self, solver):
        circuit = fed_chamber(2e-8, 0.1, Steps([0.0], [3e5]))
        past = circuit.simulate(0.3, 0.1, stop_when="control.count < 0.5", solver=solver)
        assert past.time[-1] == 0.3
        at_once = circuit.simulate(0.3, 0.1, stop_when="control.count > 0.5", solver=solver)
        assert at_once.time.tolist() == [0.0]

    def test_in_a_circuit_without_states(self, solver):
        circuit = observed(Points([0.0, 1.0], [0.0, 1.0]), 0.1)
        run = circuit.simulate(1.0, 0.05, stop_when="control.output > 0.35", solver=solver)
        assert run.time[-1] == pytest.approx(0.4, rel=1e-12)
        assert run["control.output"][-1] == pytest.approx(0.4)
        ramp = circuit.simulate(1.0, 0.05, stop_when="control.wanted > 0.333", solver=solver)
        assert ramp.time[-1] == pytest.approx(0.333, rel=1e-6)


def test_an_input_without_memory_stops_a_circuit_without_states():
    parts = {
        "a": Reservoir(pressure="2 bar"),
        "b": Reservoir(pressure="1 bar"),
        "link": Orifice(from_="a", to="b", sonic_conductance=1e-8, critical_ratio=0.3),
    }
    circuit = Circuit(parts, {"a.pressure": Points([0.0, 1.0], [2e5, 3e5])})
    run = circuit.simulate(1.0, 0.1, stop_when="a.pressure > 2.333 bar")
    assert run.time[-1] == pytest.approx(0.333, rel=1e-12)
    assert np.array_equal(run.time[:-1], np.arange(4) / 10)


# --- Steps that pass over instants ---


def valve_on_tank(**changes: object) -> Circuit:
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": ProportionalValve(data="vppm_6l", supply="supply", outlet="tank", exhaust="ambient"),
        "tank": Chamber(volume="1 l", wall_conductance=1.0),
    }
    circuit = Circuit(parts, {"valve.setpoint": Steps([0.0, 1.0, 2.0], [2e5, 4e5, 2.5e5])})
    # A wide dead band that is crossed slowly: there are idle instants, and single pulses move the pressure little.
    numbers = {"outer.dead_band": 1e3, "outer.dead_zone": 0.0, "outer.correction_limit": 0.0, "inner.minimum_duty": 0.1}
    calm = {f"valve.electronics.{name}": value for name, value in numbers.items()}
    return circuit.with_values({"valve.electronics.converter.bits": 0.0, **calm, **changes})


@pytest.mark.parametrize("drive", ["averaged", "switched"])
def test_passing_over_idle_instants_changes_nothing(drive):
    circuit = valve_on_tank(**{"valve.pilot.drive": drive})
    options = {"duration": "3 s", "output_step": "1 ms", "relative_tolerance": 1e-9}
    free = solve(circuit.problem(Run(**options)))
    landed = solve(circuit.problem(Run(**options, maximum_step="1 ms")))
    assert free.attempts < landed.attempts
    names = [name for name, _ in circuit.model.outputs]
    for name in ("tank.pressure", "valve.pilot_pressure", "valve.integral"):
        row = names.index(name)
        assert np.max(np.abs(free.values[row] - landed.values[row])) < 0.01


def test_a_sampler_that_drives_nothing_costs_no_steps_and_reads_the_interpolant():
    parts = {
        "full": Chamber(volume="1 l", initial_pressure="6 bar"),
        "empty": Chamber(volume="2 l"),
        "link": Orifice(from_="full", to="empty", sonic_conductance=1e-9, critical_ratio=0.3),
        "reader": Feeder(gain=-1.0, sample_time=1e-3),
    }
    circuit = Circuit(parts, connections={"reader.measured": "full.pressure"})
    with_reader = circuit.simulate(10.0, 1e-3)
    without = Circuit({name: part for name, part in parts.items() if name != "reader"}).simulate(10.0, 1e-3)
    assert with_reader.statistics["accepted_steps"] < 3 * without.statistics["accepted_steps"] < 1000
    assert np.max(np.abs(with_reader["reader.output"] / without["full.pressure"] - 1.0)[:-1]) < 1e-6


# --- Fast clocks and stalls ---


def test_clock_of_a_microsecond_does_not_stall():
    circuit = fed_chamber(2e-8, 1e-6, Steps([0.0], [3e5]))
    run = circuit.simulate(0.05, 1e-3)
    assert run.outcome == str(Note(Outcome.DONE.value))
    assert run.statistics["accepted_steps"] >= 50_000
    rate = GAS_CONSTANT * TEMPERATURE / 1e-3 * 2e-8
    np.testing.assert_allclose(run["tank.pressure"], 3e5 - 2e5 * (1.0 - rate * 1e-6) ** (run.time / 1e-6), rtol=1e-9)


def test_pulses_with_many_rejected_steps_do_not_stall():
    """Every pulse throws the plate against its stops; the run gets from edge to edge all the same."""
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": MainStage(supply="supply", outlet="tank", exhaust="ambient", data="varga2012", mode="regulator"),
        "vent": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3),
        "tank": Chamber(volume="0.05 l", wall_conductance=1.0),
    }
    signals = {"valve.pilot_pressure": Square(2e5, 5e5, 100.0), "vent.opening": Square(0.0, 1.0, 100.0 / 3.0)}
    run = Circuit(parts, signals).simulate(duration=4.0, output_step=0.04, relative_tolerance=1e-3)
    rejected, accepted = run.statistics["rejected_steps"], run.statistics["accepted_steps"]
    assert rejected > 0.3 * (accepted + rejected)  # at fewer nothing would be looked at
    assert "run.repeated" not in [note.code for note in run.remarks]


@pytest.mark.parametrize("sample_time", [1e-6, 1e-3, 10.0])
def test_an_emptied_store_stalls_between_instants(sample_time):
    parts = {
        "tank": Chamber(volume="1 l"),
        "pull": FlowSource(to="tank"),
        "control": Feeder(gain=-1e-3, sample_time=sample_time),
    }
    circuit = Circuit(
        parts, {"control.wanted": Steps([0.0], [100.0])}, connections={"pull.mass_flow_rate": "control.output"}
    )
    run = solve(circuit.problem(Run(duration="1 s")), repeats_stalled=False)
    assert run.outcome is Outcome.STALLED
    assert run.time[-1] == pytest.approx(1.19e-3 / 0.1, abs=2e-3)


def test_stalled_run_is_repeated_with_its_initial_memory(monkeypatch):
    from dataclasses import replace

    from poppet.engine import solve as simulate

    circuit = fed_chamber(2e-8, 0.1, Steps([0.0], [3e5]))
    whole = circuit.simulate(1.0, 0.1)
    kernel = simulate.run_kernel
    monkeypatch.setattr(simulate, "run_kernel", lambda *given: replace(kernel(*given), outcome=Outcome.STALLED))
    again = circuit.simulate(1.0, 0.1)
    assert any("repeated with the solver cvodes" in note for note in again.notes)
    np.testing.assert_allclose(again["tank.pressure"], whole["tank.pressure"], rtol=1e-6)
    assert np.array_equal(again["control.count"], whole["control.count"])


def test_a_stalled_run_is_first_repeated_with_a_tighter_tolerance(monkeypatch):
    from dataclasses import replace

    from poppet.engine import solve as simulate

    circuit = fed_chamber(2e-8, 0.1, Steps([0.0], [3e5]))
    kernel = simulate.run_kernel

    def stalling(problem, progress):
        run = kernel(problem, progress)
        return run if problem.relative_tolerance < 2e-8 else replace(run, outcome=Outcome.STALLED)

    monkeypatch.setattr(simulate, "run_kernel", stalling)
    run = circuit.simulate(1.0, 0.1)
    repeated = "The run was repeated with a relative tolerance of 1e-08."
    assert any("stopped after 1 s, because" in n and repeated in n for n in run.notes)


def test_run_does_not_change_the_memory_of_its_problem():
    circuit = fed_chamber(2e-8, 0.1, Steps([0.0], [3e5]))
    problem = circuit.problem(Run(duration="1 s"))
    p = problem.p.copy()
    runs = [solve(problem, solver) for solver in ("rosenbrock", "rosenbrock", "cvodes", "radau")]
    assert np.array_equal(problem.p, p)
    assert np.array_equal(runs[0].values, runs[1].values)


def test_kernel_and_reference_round_instants_equally():
    pytest.importorskip("numba", reason="only developers need numba")
    from poppet.engine import stepping

    times = [0.0, 1e-9, 0.3, 123.4, 1e6]
    assert [stepping.rounding.py_func(t) for t in times] == [track.rounding(t) for t in times]


# --- Replayed steps, resumed runs, refusals ---


def test_a_replay_lands_on_instants_that_have_moved():
    from poppet.engine.call import RepeatedCall

    circuit = valve_on_tank(**{"valve.pilot.drive": "switched", "tank.volume": "0.1 l"})
    row = [name for name, _ in circuit.model.outputs].index("valve.pilot_pressure")
    place = circuit.model.parameters.index("valve.electronics.inner.gain")

    def slope(tolerance: float, step: float, *, is_replayed: bool) -> np.ndarray:
        """Derivative of the pilot pressure with respect to the logarithm of a gain, which moves the ends of pulses."""
        run = Run(duration="0.3 s", output_step="1 ms", relative_tolerance=tolerance)
        repeated = RepeatedCall(circuit.problem(run), np.zeros(1_000_000))
        base = repeated.run()[row].copy()
        assert repeated.is_scripted
        assert np.max(np.abs(repeated.replay()[row] / base - 1.0)) < 1e-12
        repeated.p[place] *= 1.0 + step
        return ((repeated.replay() if is_replayed else repeated.run())[row] - base) / step

    true = slope(1e-12, 1e-5, is_replayed=False)
    replayed = slope(1e-8, 1e-6, is_replayed=True)
    # At 1e-8 and this step the difference of two free runs is noise as large as the slope.
    assert np.max(np.abs(replayed - true)) < 0.2 * np.max(np.abs(true))
    assert np.max(np.abs(slope(1e-8, 1e-5, is_replayed=True) - replayed)) < 0.02 * np.max(np.abs(true))


def test_resumed_run_continues_with_the_integral():
    circuit = valve_on_tank()
    held = Circuit(circuit.parts, {"valve.setpoint": Steps([0.0], [3e5])})
    whole = held.simulate(4.0, 0.01)
    first = held.simulate(2.0, 0.01)
    second = held.simulate(2.0, 0.01, start=first)
    assert abs(first["valve.integral"][-1]) > 10.0
    # One sample of the loop is added at once: gain * error * T / T_i.
    assert second["valve.integral"][0] == pytest.approx(first["valve.integral"][-1], abs=20.0)
    assert np.max(np.abs(second["tank.pressure"] - whole["tank.pressure"][200:])) < 500.0
    lost = held.with_values({"valve.electronics.initial_integral": 0.0}).simulate(2.0, 0.01)
    assert lost["valve.integral"][0] == 0.0


def test_connections_in_a_loop_of_two_are_named():
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "tank": Chamber(volume="1 l"),
        "one": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
        "two": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
    }
    loop = {"one.opening": "two.mass_flow_rate", "two.opening": "one.mass_flow_rate"}
    with pytest.raises(InputError) as caught:
        Circuit(parts, connections=loop).model  # noqa: B018
    assert (caught.value.code, sorted(caught.value.facts["names"])) == ("wiring.loop", ["one.opening", "two.opening"])


@pytest.mark.parametrize(
    ("time", "code"),
    [(float("nan"), "quantity.not_finite"), *((time, "fields.out_of_range") for time in (0.0, -1e-3, 0.9e-6))],
)
def test_invalid_sample_time_is_refused(time, code):
    with refused(code, "sample_time"):
        Proportional(sample_time=time)


@pytest.mark.parametrize("sample_time", [0.1, 0.5, 2.5])
def test_the_linear_model_of_a_chamber_under_sampled_control_is_the_exact_recursion(sample_time):
    """p(k+1) - w = (1 - R T / V K T_s) (p(k) - w): slowly, to and fro, and away from it."""
    circuit = fed_chamber(1e-8, sample_time, Steps([0.0], [2e5]))
    factor = 1.0 - GAS_CONSTANT * TEMPERATURE / 1e-3 * 1e-8 * sample_time
    linear = circuit.linearise()
    assert sorted(abs(linear.eigenvalues())) == pytest.approx([0.0, abs(factor)], rel=1e-9)
    assert circuit.steady_state().y["tank.pressure"] == pytest.approx(2e5, rel=1e-9)
    assert circuit.steady_state().is_stable == (abs(factor) < 1.0)
    assert linear.poles()[0] == pytest.approx(np.log(complex(factor)) / sample_time, rel=1e-9)


def test_attempts_of_the_last_solver_are_limited(monkeypatch):
    from dataclasses import replace

    from poppet.engine import solve as simulate
    from poppet.engine.reference_solvers import solvers

    allowed = []

    def stalling(problem, *given):
        run = simulate.run_kernel(problem)
        if given[:1]:
            allowed.append((given[0], problem.most_attempts))
        return replace(run, outcome=Outcome.STALLED)

    problem = fed_chamber(2e-8, 0.1, Steps([0.0], [3e5])).problem(Run(duration="1 s"))
    monkeypatch.setattr(solvers, "solve_with_reference", stalling)
    kernel = simulate.run_kernel
    monkeypatch.setattr(simulate, "run_kernel", lambda *given: replace(kernel(*given), outcome=Outcome.STALLED))
    run = solve(replace(problem, most_attempts=100_000))
    assert allowed == [("cvodes", 100_000), ("radau", 2_000)]
    assert run.notes[-1].code == "run.no_way_on"

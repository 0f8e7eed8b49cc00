"""Runs: rows, jumps, accuracy, progress, interruption, failures that keep what they have."""

from __future__ import annotations

import os
import signal
import threading
from typing import Any, ClassVar

import numpy as np
import pytest

from poppet import Circuit
from poppet.circuit.options import Run
from poppet.core.codes import Note
from poppet.core.errors import SimulationError
from poppet.engine.balances import Residual, residuals
from poppet.engine.problem import Outcome
from poppet.engine.solve import solve
from poppet.parts import Chamber, FlowSource, MainStage, Orifice, Reservoir
from poppet.signals import Chirp, Points, Sine, Steps
from refusals import refused

SIZE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}


def filling(signals: Any = None, **tank: Any) -> Circuit:
    return Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", **SIZE),
            "tank": Chamber(**{"volume": "10 l", "thermal": "isothermal", **tank}),
        },
        signals or {},
    )


def draining(rate: float = -1e-3, **tank: Any) -> Circuit:
    return Circuit({"tank": Chamber(**{"volume": "1 l", **tank}), "pull": FlowSource(to="tank", mass_flow_rate=rate)})


class TestRows:
    def test_at_multiples_of_the_output_step(self):
        assert filling().simulate("12 s", "0.1 s").time.tolist() == [k / 10 for k in range(121)]

    def test_last_row_at_the_duration(self):
        assert filling().simulate("1 s", "0.3 s").time.tolist() == [0.0, 0.3, 0.6, 0.9, 1.0]

    def test_first_row_is_the_initial_state(self):
        recording = filling(initial_pressure="3 bar").simulate("1 s")
        assert recording["tank.pressure"][0] == pytest.approx(3e5, rel=1e-14)

    @pytest.mark.parametrize("step", ["0.1 s", "1 ms", "0.1 ms"])
    def test_on_a_jump_they_show_the_value_after_it(self, step):
        times = [0.0, 0.3, 0.7, 0.9]
        values = [7e5, 2e5, 5e5, 1e5]
        recording = filling({"supply.pressure": Steps(times, values)}).simulate("1 s", step)
        for time, before, after in zip(times[1:], values, values[1:], strict=False):
            row = int(np.searchsorted(recording.time, time))
            assert recording.time[row] == time
            assert recording["supply.pressure"][[row - 1, row]].tolist() == [before, after]

    def test_flows_jump_with_the_input_and_states_do_not(self):
        recording = filling({"supply.pressure": Steps([0.0, 0.5], [7e5, 5e5])}).simulate("1 s", "0.1 s")
        flow, mass = recording["fill.mass_flow_rate"], recording["tank.mass"]
        assert flow[5] == pytest.approx(5.0 / 7.0 * flow[4], rel=1e-12)
        assert mass[5] - mass[4] == pytest.approx(0.1 * flow[4], rel=1e-9)

    def test_a_jump_at_the_end_belongs_to_no_run(self):
        recording = filling({"supply.pressure": Steps([0.0, 1.0], [7e5, 3e5])}).simulate("1 s", "0.1 s")
        assert recording["supply.pressure"][-1] == 7e5

    def test_inputs_between_rows(self):
        recording = filling({"supply.pressure": Sine(6e5, 1e5, 2.0, 0.4)}).simulate("1 s", "0.01 s")
        known = 6e5 + 1e5 * np.sin(2.0 * np.pi * 2.0 * recording.time + 0.4)
        assert np.abs(recording["supply.pressure"] - known).max() < 1e-6

    def test_columns_keep_17_digits(self, tmp_path):
        recording = filling().simulate("1 s", "0.1 s")
        lines = recording.save(tmp_path / "out.csv").read_text(encoding="utf-8").splitlines()
        place = 1 + recording.names.index("tank.pressure")
        read = [float(line.split(",")[place]) for line in lines[1:]]
        assert read == recording["tank.pressure"].tolist()
        assert any(len(line.split(",")[place].replace(".", "")) >= 16 for line in lines[1:])

    def test_a_step_shorter_than_the_output_step_is_not_missed(self):
        pulse = Steps([0.0, 0.501, 0.502], [0.0, 1e-2, 0.0])
        circuit = Circuit(
            {"tank": Chamber(volume="1 l"), "source": FlowSource(to="tank")}, {"source.mass_flow_rate": pulse}
        )
        recording = circuit.simulate("1 s", "0.5 s")
        assert recording["tank.mass"][-1] - recording["tank.mass"][0] == pytest.approx(1e-5, rel=1e-9)


class TestAccuracy:
    @pytest.mark.parametrize("tolerance", [1e-4, 1e-6, 1e-8])
    def test_isothermal_filling_is_within_the_tolerance(self, tolerance):
        """r = r0 + K t while choked, then r = b + (1 - b) sin(K (t - tb)/(1 - b))."""
        recording = filling().simulate("9 s", "0.05 s", tolerance)
        k = 287.05 * 293.15 * 1e-8 * 1.185 / 10e-3
        t, b = recording.time, 0.3
        tb = (b - 1.0 / 7.0) / k
        choked = 1.0 / 7.0 + k * t
        known = 7e5 * np.where(
            t < tb, choked, b + (1.0 - b) * np.sin(np.minimum(k * (t - tb) / (1.0 - b), np.pi / 2.0))
        )
        near_end = known > 0.998 * 7e5  # the regularised zone
        assert np.abs(recording["tank.pressure"] / known - 1.0)[~near_end].max() < 10.0 * tolerance

    def test_longest_step_is_kept(self):
        circuit = filling().with_values({"run.maximum_step": "10 ms"})
        assert circuit.simulate("1 s").statistics["accepted_steps"] >= 100

    def test_a_tighter_run_takes_more_steps(self):
        steps = [
            filling().simulate("5 s", relative_tolerance=rtol).statistics["accepted_steps"] for rtol in (1e-4, 1e-8)
        ]
        assert steps[1] > steps[0]


class TestProgress:
    slow: ClassVar = {"valve.pilot_pressure": Chirp(3e5, 1e5, 20.0, 400.0)}

    def circuit(self) -> Circuit:
        """Minutes of a swept valve: seconds of work."""
        parts = {
            "supply": Reservoir(pressure="7 bar"),
            "tank": Chamber(volume="20 l"),
            "valve": MainStage(supply="supply", outlet="tank", exhaust="ambient", data="varga2012"),
        }
        return Circuit(parts, self.slow)

    def test_is_called_with_the_time_reached(self):
        seen: list[float] = []
        recording = filling().simulate("5 s", progress=seen.append)
        assert seen == sorted(seen)
        assert seen[-1] == 5.0
        plain = filling().simulate("5 s")
        assert np.array_equal(recording.values, plain.values)

    def test_interrupt_keeps_the_rows_so_far(self):
        def interrupt(time: float) -> None:
            if time > 0.0:
                raise KeyboardInterrupt

        recording = self.circuit().simulate("2000 s", "1 s", 1e-9, progress=interrupt, throw=False)
        assert recording.outcome.startswith("The run was interrupted after t = ")
        assert recording.outcome.endswith("The results up to that time are kept.")
        assert 0.0 <= recording.time[-1] < 2000.0
        assert np.all(np.isfinite(recording.values))

    def test_ctrl_c_while_waiting_leaves_no_thread_behind(self):
        """A signal that comes while the run is waited for, not while its progress is shown."""
        # A process that a shell began in the background ignores the signal until it is told otherwise.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        sent: list[threading.Timer] = []

        def announce(time: float) -> None:
            if not sent:
                sent.append(threading.Timer(0.03, os.kill, [os.getpid(), signal.SIGINT]))
                sent[0].start()

        try:
            recording = self.circuit().simulate("2000 s", "1 s", 1e-9, progress=announce, throw=False)
        finally:
            signal.signal(signal.SIGINT, before)
        assert recording.outcome.startswith("The run was interrupted")
        assert np.all(np.isfinite(recording.values))

    def test_interrupt_raises_with_the_partial_recording(self):
        def interrupt(time: float) -> None:
            raise KeyboardInterrupt

        with refused("run.ended.interrupted", kind=SimulationError) as caught:
            self.circuit().simulate("2000 s", "1 s", 1e-9, progress=interrupt)
        assert caught.value.recording.names == self.circuit().model.columns[0]
        assert caught.value.exit_code == 1

    def test_a_callback_that_fails_stops_the_run(self):
        def fail(time: float) -> None:
            raise RuntimeError("the display is gone")

        with pytest.raises(RuntimeError, match="the display is gone"):
            self.circuit().simulate("2000 s", "1 s", 1e-9, progress=fail)


class TestFailures:
    def test_emptied_chamber_ends_the_run(self):
        """Air of 1 bar in 1 l is gone after 1.19 s."""
        with pytest.raises(SimulationError) as caught:
            draining().simulate("10 s", "0.01 s")
        recording = caught.value.recording
        empty = 1e5 * 1e-3 / (287.05 * 293.15) / 1e-3
        assert recording.time[-1] == pytest.approx(empty, abs=0.011)
        assert recording.time.tolist() == [k / 100 for k in range(recording.time.size)]
        assert str(caught.value) == recording.outcome
        assert "tank.mass has fallen to" in recording.outcome
        assert "Check whether a flow source empties this gas volume" in recording.outcome
        assert np.all(recording["tank.pressure"] > 0.0)
        assert np.diff(recording["tank.mass"]) == pytest.approx(np.full(recording.time.size - 1, -1e-5), rel=1e-6)

    def test_partial_recording_without_raising(self):
        recording = draining().simulate("10 s", "0.01 s", throw=False)
        assert recording.outcome.startswith("The solver stopped after t = 1.18 s")
        assert any("CVODES and Radau failed as well" in note for note in recording.notes)

    def test_more_steps_than_allowed(self):
        import dataclasses

        circuit = filling()
        problem = dataclasses.replace(circuit.problem(Run(duration="5 s")), most_attempts=3)
        run = solve(problem)
        assert run.outcome is Outcome.TOO_MANY
        assert run.attempts == 3

    def test_unknown_solver(self):
        with refused("fields.not_an_option", "solver"):
            filling().simulate("1 s", solver="rk45")

    def test_missing_duration(self):
        with refused("fields.missing", "run.duration"):
            filling().simulate()


class TestResiduals:
    def test_every_store_has_its_balances(self):
        recording = filling(thermal="energy", wall_conductance="5 W/K").simulate("10 s")
        assert [(r.name, r.unit) for r in recording.residuals] == [("tank mass", "kg"), ("tank energy", "J")]
        mass, energy = recording.residuals
        assert mass.error <= 1e-12 * mass.through
        assert energy.error <= 1e-9 * energy.through
        gained = recording["tank.mass"][-1] - recording["tank.mass"][0]
        assert mass.through == pytest.approx(gained, rel=1e-6)

    def test_prescribed_laws_keep_mass(self):
        (residual,) = filling().simulate("10 s").residuals
        assert residual.name == "tank mass"
        assert residual.is_kept

    def test_wrong_balance_exceeds_its_limit(self):
        assert not Residual("tank", "mass", "kg", 1e-3, 1.0, 1.0).is_kept
        assert Residual("tank", "mass", "kg", 1e-13, 1.0, 1.0).is_kept
        assert Residual("tank", "energy", "J", 1e-8, 1.0, 1.0).is_kept

    def test_they_are_computed_from_the_raw_run(self):
        import dataclasses

        circuit = filling()
        problem = circuit.problem(Run(duration="1 s"))
        run = solve(problem)
        assert all(residual.is_kept for residual in residuals(problem, run))
        wrong = run.x.copy()
        wrong[0] *= 1.001
        assert not residuals(problem, dataclasses.replace(run, x=wrong))[0].is_kept


@pytest.mark.parametrize("solver", ["cvodes", "lsoda", "bdf", "radau"])
def test_independent_solvers_agree(solver):
    circuit = filling(
        {"supply.pressure": Points([0.0, 2.0, 4.0], [7e5, 4e5, 8e5])}, thermal="energy", wall_conductance="3 W/K"
    )
    mine, his = circuit.simulate("5 s", "0.1 s", 1e-8), circuit.simulate("5 s", "0.1 s", 1e-8, solver=solver)
    assert np.array_equal(mine.time, his.time)
    for name in ("tank.pressure", "tank.temperature"):
        assert np.abs(his[name] / mine[name] - 1.0).max() < 1e-6


def test_outcomes_are_codes_with_words():
    assert all(str(Note(outcome.value)).endswith(".") for outcome in Outcome)
    assert {outcome for outcome in Outcome if outcome.is_success} == {Outcome.DONE, Outcome.STOPPED}


def test_a_run_leaves_nothing_behind():
    """The same circuit gives the same digits again, whatever ran between."""
    circuit = filling(thermal="energy")
    first = circuit.simulate("5 s")
    circuit.simulate("1 s", relative_tolerance=1e-4)
    draining().simulate("10 s", throw=False)
    assert np.array_equal(first.values, circuit.simulate("5 s").values)

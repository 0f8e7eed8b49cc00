"""Sampled circuits: clocks, steady states, kinks, and the discrete linear model with its files."""

from __future__ import annotations

import json
from functools import cache

import numpy as np
import pytest

from poppet import Circuit
from poppet.bench.sine_rig import without_bands
from poppet.circuit.linear_model import SteadyState
from poppet.circuit.sampled import sampled_steady_state as rest_module
from poppet.circuit.sampled.point import SampledPoint
from poppet.circuit.sampled.sample_map import eigenvalues_of
from poppet.circuit.sampled.sampled_model import SampledModel, sampled_model
from poppet.circuit.sampled.sampled_steady_state import oscillation, rest_near
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.parts import Chamber, Orifice, ProportionalValve, Reservoir
from poppet.signals import Constant

PLAIN = {"valve.electronics.outer.derivative_time": 0.0}
LEAK = {"valve.pilot.exhaust_leak.sonic_conductance": 2e-11}


def whole(load: float = 2e-9, setpoint: float = 4e5, **fields) -> Circuit:
    """Return a regulator valve with default parameters that feeds a consumer."""
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l", **fields),
        "tank": Chamber(volume="1 l", wall_conductance=1.0, initial_pressure="4 bar"),
        "load": Orifice(from_="tank", to="ambient", sonic_conductance=load, critical_ratio=0.3),
    }
    return Circuit(parts, {"valve.setpoint": Constant(setpoint)})


def smooth(**changes) -> Circuit:
    return without_bands(whole()).with_values(LEAK | changes)


@cache
def smooth_rest() -> SteadyState:
    """Return the steady state, which tests must not change."""
    return smooth().steady_state()


@cache
def smooth_model() -> SampledModel:
    return sampled_model(smooth().instance, smooth_rest())


OUTER, INNER = "valve.electronics.outer.sample_time", "valve.electronics.inner.sample_time"


def bends(note: Note) -> list[str]:
    """Return the variables with a kink."""
    return [each.address for each in note.facts["what"]]


class TestClocks:
    def point(self, circuit: Circuit) -> SampledPoint:
        return SampledPoint(circuit.instance, np.array([7e5, 293.15, 4e5, 1.0, 1.0, 1.0])[: len(circuit.model.inputs)])

    def test_only_timers_and_counters_are_clocks(self):
        model = smooth().model
        clocks = {name for (name, _), is_clock in zip(model.memory, model.counting(), strict=True) if is_clock}
        assert clocks == {f"valve.electronics.{name}" for name in ("outer", "inner", "outer_count", "inner_count")}

    def test_period_of_two_clocks_is_the_least_common_multiple(self):
        clock = self.point(smooth(**{OUTER: 3e-3, INNER: 2e-3})).clock
        assert clock.sample_time == pytest.approx(6e-3, rel=1e-12)
        assert clock.times == pytest.approx([0.0, 2e-3, 3e-3, 4e-3], abs=1e-15)
        assert clock.fired.tolist() == [[1, 1, 0], [0, 1, 0], [1, 0, 0], [0, 1, 0]]

    def test_equal_sample_times_have_common_instants(self):
        clock = self.point(smooth()).clock
        assert (clock.sample_time, clock.times.tolist(), clock.fired.tolist()) == (1e-3, [0.0], [[1, 1, 0]])

    def test_sample_times_without_a_common_period_are_rejected(self):
        with pytest.raises(SimulationError) as caught:
            smooth(**{OUTER: np.sqrt(2.0) * 1e-3}).linearise()
        assert caught.value.note.code == "sampled.no_common_period"


class TestRest:
    def test_steady_state_includes_states_and_discrete_states(self):
        rest = smooth_rest()
        assert rest.is_stable
        assert [note.code for note in rest.found] == ["rest.settled"]
        assert rest.residual < 1e-9
        assert rest.y["tank.pressure"] == pytest.approx(4e5, rel=1e-9)
        assert rest.memory["valve.integral"] == pytest.approx(rest.y["valve.integral"], rel=1e-12)
        assert rest.memory["valve.electronics.outer"] == 0.0
        # What leaks out of the pilot comes in through the filling solenoid.
        assert rest.y["valve.vent_duty"] == 0.0
        assert 0.01 < rest.y["valve.fill_duty"] < 0.2
        # The supply fills what the consumer takes.
        assert rest.y["valve.supply_mass_flow_rate"] == pytest.approx(rest.y["load.mass_flow_rate"], rel=1e-9)

    def test_kinks_limit_the_validity_of_the_model(self):
        circuit = without_bands(whole()).with_values(PLAIN)
        rest = circuit.steady_state()
        (duty,) = [note for note in rest.notes if "valve.fill_duty" in bends(note)]
        assert (duty.code, duty.address, duty.facts["upward"]) == (
            "linear.kink_ahead", "valve.outlet_sensor_pressure", True,
        )  # fmt: skip
        # With this little leak the filling side ends where the error of the pilot pressure is used up.
        error = rest.y["valve.pilot_setpoint"] - rest.y["valve.pilot_sensor_pressure"]
        assert duty.facts["size"] == pytest.approx(error, rel=0.02)

    def test_larger_leak_increases_the_distance_of_the_kink(self):
        assert not any("duty" in name for note in smooth(**PLAIN).steady_state().notes for name in bends(note))

    @pytest.mark.parametrize("longest", [20.0, pytest.param(1000.0, marks=pytest.mark.slow)])
    def test_oscillation_is_reported_with_amplitude_and_period(self, longest, monkeypatch):
        monkeypatch.setattr(rest_module, "TRANSIENTS", (10.0, longest))
        with pytest.raises(SimulationError) as caught:
            whole().with_values(LEAK).steady_state()
        assert caught.value.note.code == "rest.banded"
        swings = caught.value.note.facts["motion"].facts["swings"]
        assert {(swing.code, swing.facts["unit"]) for swing in swings} == {("rest.swings", "Pa")}
        assert all(swing.facts["amplitude"] > 0.0 and swing.facts["period"] > 0.0 for swing in swings)

    @pytest.mark.slow  # the bands below are the brother of every day
    def test_switched_solenoids_have_no_steady_state(self):
        with pytest.raises(SimulationError) as caught:
            without_bands(whole()).with_values(LEAK | {"valve.pilot.drive": "switched"}).steady_state()
        assert caught.value.note.code == "rest.switched"
        assert "valve.pilot.fill_release" in caught.value.note.facts["timers"]

    def test_steady_state_in_a_hold_band_is_the_end_of_the_run(self):
        """With a tight pilot and no consumer, both solenoids are closed and nothing leaks."""
        tight = {"valve.pilot.exhaust_leak.sonic_conductance": 0.0, "load.sonic_conductance": 0.0}
        rest = whole().with_values(tight).steady_state()
        assert (rest.y["valve.fill_duty"], rest.y["valve.vent_duty"]) == (0.0, 0.0)
        assert rest.y["tank.pressure"] == pytest.approx(4e5, abs=3e3)

    def test_steady_state_near_a_guess_needs_no_run(self):
        circuit, rest = smooth(), smooth_rest()
        point = SampledPoint(circuit.instance, np.array(list(rest.u.values())))
        v = point.v(rest.x, np.array(list(rest.memory.values())))
        found = rest_near(point, v * (1.0 + 1e-4))
        assert found == pytest.approx(v, rel=1e-6, abs=1e-9)

    def test_ripple_does_not_change_the_period(self):
        t = np.linspace(0.0, 20.0, 20_001)
        y = np.sin(2.0 * np.pi * t / 4.0) + 0.1 * np.sin(2.0 * np.pi * t / 0.03)
        amplitude, period = oscillation(t, y)
        assert amplitude == pytest.approx(1.1, abs=0.01)
        assert period == pytest.approx(4.0, rel=0.01)
        assert oscillation(t, t) == (10.0, np.inf)


class TestModel:
    def test_model_has_states_and_discrete_states_without_clocks(self):
        model = smooth_model()
        assert model.sample_time == 1e-3
        assert model.states[:2] == ("valve.stroke", "valve.velocity")
        assert "valve.integral" in model.states
        assert not any("count" in name for name in model.states)
        assert model.A.shape == (len(model.states),) * 2
        assert np.max(np.abs(model.rates)) < 1e-4

    def test_steady_gain_follows_from_the_map(self):
        """The integral action keeps the outlet at the setpoint."""
        model = smooth_model()
        row, column = model.outputs.index("tank.pressure"), model.inputs.index("valve.setpoint")
        scaled = model.A * model.sizes[None, :] / model.sizes[:, None]
        rest = np.linalg.solve(np.eye(len(scaled)) - scaled, model.B[:, column] / model.sizes)
        gain = model.C[row] @ (rest * model.sizes) + model.D[row, column]
        assert gain == pytest.approx(1.0, rel=1e-6)
        assert abs(model.frequency_response(1e-4, "valve.setpoint", "tank.pressure")[0]) == pytest.approx(1.0, rel=1e-4)

    def test_poles_are_logarithms_of_eigenvalues(self):
        model = smooth_model()
        values = model.eigenvalues()
        assert np.all(np.diff(np.abs(values)) <= 1e-12)
        assert np.sum(values == 0.0) >= 4
        kept = values[np.abs(values) > 1e-12]
        assert sorted(np.exp(model.poles() * 1e-3).real) == pytest.approx(sorted(kept.real), rel=1e-9)

    def test_zero_eigenvalues_are_exact(self):
        chain = np.diag([1.0, 1.0], 1)
        assert eigenvalues_of(chain).tolist() == [0.0, 0.0, 0.0]
        assert eigenvalues_of(np.diag([0.5, 0.0])).tolist() == [0.5, 0.0]

    def test_state_response_equals_that_of_state_outputs(self):
        model = smooth_model()
        place = model.states.index("tank.pressure")
        every = model.state_response(20.0, "valve.setpoint")
        assert every[place] == pytest.approx(
            complex(model.frequency_response(20.0, "valve.setpoint", "tank.pressure")[0]), rel=1e-9
        )

    def test_saves_its_sample_time(self, tmp_path):
        model = smooth_model()
        model.save(tmp_path / "linear.json")
        data = json.loads((tmp_path / "linear.json").read_text())
        assert data["sample_time"] == 1e-3
        assert np.array(data["A"]) == pytest.approx(model.A)

    def test_for_python_control_is_discrete(self):
        pytest.importorskip("control")
        model = smooth_model()
        system = model.to_control()
        assert system.dt == 1e-3
        assert np.sort(np.abs(system.poles())) == pytest.approx(np.sort(np.abs(model.eigenvalues())), abs=1e-6)

    def test_linearisation_at_a_recording_is_rejected(self):
        circuit = smooth()
        with pytest.raises(InputError) as caught:
            circuit.linearise(at=circuit.simulate("10 ms"))
        assert caught.value.code == "linear.no_memory"

    def test_unknown_addresses(self):
        with pytest.raises(InputError) as caught:
            smooth_model().frequency_response(1.0, "valve.setpiont", "tank.pressure")
        assert (caught.value.code, caught.value.facts["suggestion"].names[:1]) == ("names.unknown", ["valve.setpoint"])


def test_command_prints_poles_and_kinks(capsys, tmp_path, monkeypatch):
    from poppet.cli.main import run

    monkeypatch.chdir(tmp_path)
    (tmp_path / "valve.toml").write_text(FILE)
    assert run(["linearise", "valve.toml", "-o", "linear.json"]) == 0
    out = capsys.readouterr().out
    assert "Linear model over samples of 0.001 s" in out
    assert "pole [1/s]" in out
    assert "Eigenvalues over a sample:" in out
    assert "times 0 (recomputed in every sample)" in out
    assert "- The linear model is valid only for small changes" in out
    assert "rate of change of tank.pressure" in out
    assert json.loads((tmp_path / "linear.json").read_text())["sample_time"] == 1e-3


FILE = """
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.valve]
kind = "proportional_valve"
data = "vppm_6l"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
[parts.valve.pilot]
exhaust_leak = { sonic_conductance = 2e-11 }
fill = { opening_delay = 0, closing_delay = 0 }
vent = { opening_delay = 0, closing_delay = 0 }
[parts.valve.electronics]
converter = { bits = 0 }
inner = { hold_band = 0, minimum_duty = 0 }
outer = { dead_band = 0, correction_limit = 0, integral_band = 0, integral_limit = 0 }
[parts.tank]
kind = "chamber"
volume = "1 l"
wall_conductance = 1
initial_pressure = "4 bar"
[parts.load]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = 2e-9
critical_ratio = 0.3
[signals]
"valve.setpoint" = "4 bar"
"""

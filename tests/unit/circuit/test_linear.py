"""Steady states and linear models: exact derivatives, closed forms, conserved gas, files, python-control."""

from __future__ import annotations

import json
import sys
from dataclasses import replace
from functools import cache

import numpy as np
import pytest

from poppet import Circuit
from poppet.circuit import linear
from poppet.core.errors import InputError, InputErrors, MissingDependencyError, SimulationError
from poppet.parts import Chamber, DirectionalValve, FlowSource, MainStage, Orifice, Reservoir
from poppet.signals import Chirp, Constant, Steps

SIZE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}
SUPPLY, ROOM = Reservoir(pressure="7 bar"), Reservoir(pressure="1 bar")


def stage(mode: str, tank: Chamber, *, load: float = 0.0, pilot: float | None = None, **changes) -> Circuit:
    valve = MainStage(
        supply="supply", outlet="tank", exhaust="room", data="varga2012", mode=mode, pilot_pressure=pilot, **changes
    )
    parts = {"supply": SUPPLY, "room": ROOM, "valve": valve, "tank": tank}
    if load:
        parts["load"] = Orifice(from_="tank", to="room", sonic_conductance=load, critical_ratio=0.3)
    return Circuit(parts)


def through_flow(thermal: str = "energy", **tank) -> Circuit:
    """Return a tank between two orifices, whose steady state has a flow."""
    parts = {
        "supply": SUPPLY,
        "inlet": Orifice(from_="supply", to="tank", **SIZE),
        "tank": Chamber(volume="5 l", thermal=thermal, **tank),
        "outlet": Orifice(from_="tank", to="ambient", **SIZE),
    }
    return Circuit(parts)


def two_tanks() -> Circuit:
    parts = {
        "full": Chamber(volume="2 l", initial_pressure="7 bar"),
        "warm": Chamber(volume="5 l", initial_temperature="320 K"),
        "bridge": Orifice(from_="full", to="warm", **SIZE),
    }
    return Circuit(parts)


def hunting() -> Circuit:
    """Return a regulator that hunts because its tank is small."""
    return stage("regulator", Chamber(volume="0.1 l", wall_conductance=1.0), load=6e-9, pilot=4e5)


def directional() -> Circuit:
    """Return a circuit that moves from exhaust to supply."""
    valve = DirectionalValve(supply="supply", outlet="tank", exhaust="room", command=1.0, initial_position=0.2, **SIZE)
    tank = Chamber(volume="1 l", initial_pressure="3 bar")
    return Circuit({"supply": SUPPLY, "room": ROOM, "valve": valve, "tank": tank})


class TestSteadyState:
    @pytest.mark.parametrize(("seat_balance", "pressure"), [(0.0, 5.20e5), (1.0, 5.11e5)])
    def test_of_the_regulator(self, seat_balance, pressure):
        tank = Chamber(volume="0.2 m^3", thermal="polytropic", polytropic_exponent=1.04)
        circuit = stage("regulator", tank, seat_balance=seat_balance)
        steady = circuit.steady_state({"valve.pilot_pressure": "4.4 bar g"})
        assert steady.y["tank.pressure"] == pytest.approx(pressure, abs=0.005e5)
        assert steady.u["valve.pilot_pressure"] == pytest.approx(5.4e5, rel=1e-15)
        assert steady.residual < 1e-9
        assert [note.code for note in steady.found] == ["rest.settled"]

    def test_paper_valve_ends_at_the_supply_pressure(self):
        steady = stage("paper", Chamber(volume="0.2 m^3", wall_conductance="45 W/K")).steady_state(
            {"valve.pilot_pressure": "2 bar g"}
        )
        assert steady.y["tank.pressure"] == pytest.approx(7e5, rel=1e-12)
        assert steady.y["tank.temperature"] == pytest.approx(293.15, rel=1e-9)
        assert steady.y["valve.stroke"] == pytest.approx(0.310e-3, abs=0.5e-6)

    def test_flow_path_in_series_has_the_series_conductance(self):
        from poppet.iso6358 import mass_flow_rate

        steady = through_flow(wall_conductance=1.0).steady_state()
        flow = steady.y["inlet.mass_flow_rate"]
        assert flow == pytest.approx(steady.y["outlet.mass_flow_rate"], rel=1e-12)
        assert flow == pytest.approx(mass_flow_rate(7e5, steady.y["tank.pressure"], 293.15, **SIZE), rel=1e-12)
        assert steady.y["tank.temperature"] == pytest.approx(293.15, rel=1e-9)

    def test_keeps_the_gas_of_a_closed_network(self):
        circuit = two_tanks()
        steady = circuit.steady_state()
        start = circuit.simulate("1 ms", relative_tolerance=1e-9)
        mass = sum(float(start[f"{name}.mass"][0]) for name in ("full", "warm"))
        energy = 7e5 * 2e-3 + 1e5 * 5e-3
        assert steady.y["full.mass"] + steady.y["warm.mass"] == pytest.approx(mass, rel=1e-10)
        assert steady.y["full.pressure"] == pytest.approx(energy / 7e-3, rel=1e-10)
        assert steady.y["warm.pressure"] == pytest.approx(energy / 7e-3, rel=1e-10)

    def test_search_from_a_nearly_steady_state(self):
        tank = Chamber(volume="0.2 m^3", thermal="polytropic", polytropic_exponent=1.04)
        circuit = stage("regulator", tank, pilot=5.4e5)
        resumed = circuit.resumed(circuit.simulate("1000 s"))
        assert resumed.steady_state().y["tank.pressure"] == pytest.approx(
            circuit.steady_state().y["tank.pressure"], rel=1e-6
        )

    def test_steady_initial_state_is_the_result(self):
        circuit = Circuit({"tank": Chamber(volume="1 l"), "feed": FlowSource(to="tank")})
        steady = circuit.steady_state()
        assert steady.y["tank.pressure"] == 1e5
        assert steady.residual == 0.0

    def test_without_any_state(self):
        circuit = Circuit({"supply": SUPPLY, "leak": Orifice(from_="supply", to="ambient", **SIZE)})
        steady = circuit.steady_state()
        assert steady.x.size == 0
        assert steady.y["leak.mass_flow_rate"] == pytest.approx(1e-8 * 1.185 * 7e5, rel=1e-12)
        assert circuit.linearise().eigenvalues().size == 0

    def test_steady_state_of_a_hunting_valve_has_a_note(self, monkeypatch):
        circuit = hunting()
        steady = circuit.steady_state()
        monkeypatch.setattr(linear, "steady_state", lambda *_: steady)  # found once: it takes seconds
        model = circuit.linearise()
        assert [note.code for note in steady.found] == ["rest.slowed"]
        assert steady.y["valve.supply_mass_flow_rate"] == pytest.approx(steady.y["load.mass_flow_rate"], rel=1e-9)
        assert np.max(model.eigenvalues().real) > 100.0

    def test_circuit_without_mechanics_does_not_use_slow_gas(self, monkeypatch):
        monkeypatch.setattr(linear, "TRANSIENT_STEPS", 3)
        steady = through_flow().steady_state()
        assert [note.code for note in steady.found] == ["rest.settled"]
        assert steady.residual < 1e-6

    def test_tank_with_constant_inflow_has_no_steady_state(self):
        fed = Circuit({"tank": Chamber(volume="1 l"), "feed": FlowSource(to="tank", mass_flow_rate="1 g/s")})
        with pytest.raises(SimulationError) as caught:
            fed.steady_state()
        assert (caught.value.note.code, caught.value.note.address) == ("rest.endless", "tank.pressure")
        assert caught.value.note.facts["rate"] > 0.0

    def test_emptied_tank_has_no_steady_state(self):
        emptied_tank = Circuit({"tank": Chamber(volume="1 l"), "pull": FlowSource(to="tank", mass_flow_rate="-1 g/s")})
        with pytest.raises(SimulationError) as caught:
            emptied_tank.steady_state()
        assert caught.value.note.code == "rest.emptied"


class TestInputs:
    def test_default_input_is_the_signal_at_the_start_or_the_parameter(self):
        circuit = replace(through_flow(), signals={"supply.pressure": Steps([0.0, 1.0], [5e5, 9e5])})
        steady = circuit.steady_state()
        assert steady.u == {
            "supply.pressure": 5e5, "supply.temperature": 293.15, "inlet.opening": 1.0, "outlet.opening": 1.0,
        }  # fmt: skip

    def test_chirp_has_its_value_at_the_start(self):
        circuit = replace(through_flow(), signals={"supply.pressure": Chirp(5e5, 1e5, 1.0, 9.0, phase=np.pi / 2)})
        assert circuit.steady_state().u["supply.pressure"] == pytest.approx(6e5, rel=1e-12)

    def test_gauge_values_refer_to_the_ambient_pressure(self):
        circuit = replace(through_flow(), ambient=replace(through_flow().ambient, pressure="0.9 bar"))
        assert circuit.steady_state({"supply.pressure": "6 bar g"}).u["supply.pressure"] == pytest.approx(6.9e5)

    def test_all_errors_are_reported_together(self):
        with pytest.raises(InputErrors) as caught:
            through_flow().steady_state({"suply.pressure": 1e5, "inlet.opening": 2.0, "supply.temperature": "1 bar"})
        assert {problem.code: problem.address for problem in caught.value.problems} == {
            "names.unknown": "suply.pressure",
            "inputs.outside": "inlet.opening",
            "quantity.other_quantity": "supply.temperature",
        }


@cache
def moving(name: str):
    """Return a circuit, its recording, and the linear model at the end of the recording."""
    circuit, duration = {
        "stage": (stage("paper", Chamber(volume="1 l", wall_conductance=1.0), load=3e-9, pilot=3e5), 5e-4),
        "regulator": (stage("regulator", Chamber(volume="1 l"), load=3e-9, pilot=4e5), 8e-3),
        "two tanks": (two_tanks(), 0.1),
        "directional": (directional(), 2e-3),
        "through flow": (through_flow("polytropic", polytropic_exponent=1.2), 0.5),
    }[name]
    recording = circuit.simulate(duration, relative_tolerance=1e-9)
    return circuit, recording, circuit.linearise(at=recording)


def central_differences(circuit: Circuit, model, name: str, count: int):
    """Return the derivatives of a compiled function with respect to x and u."""
    kernel = circuit.kernel
    p = np.array(list(circuit.parameters.values()))
    padding = np.zeros(kernel.model.n_quadratures)

    def at(x, u):
        values = np.empty(kernel.model.size if name == "rates" else len(kernel.model.outputs))
        kernel.call(name, np.zeros(1), np.concatenate([x, padding]), np.ascontiguousarray(u), p, values)
        return values[:count]

    def columns(point, move):
        sizes = np.maximum(np.abs(point), 1e-6) * 1e-6
        return np.array(
            [(move(h * e) - move(-h * e)) / (2.0 * h) for h, e in zip(sizes, np.eye(point.size), strict=True)]
        )

    by_x = columns(model.x, lambda d: at(model.x + d, model.u))
    by_u = columns(model.u, lambda d: at(model.x, model.u + d))
    return by_x.T, by_u.T


NAMES = ("stage", "regulator", "two tanks", "directional", "through flow")


@pytest.mark.parametrize("name", NAMES)
class TestDerivatives:
    def test_derivatives_equal_those_of_compiled_functions(self, name):
        circuit, _, model = moving(name)
        by_x, by_u = central_differences(circuit, model, "rates", len(model.states))
        for exact, difference in ((model.A, by_x), (model.B, by_u)):
            np.testing.assert_allclose(exact, difference, rtol=1e-5, atol=1e-6 * np.max(np.abs(exact)))
        by_x, by_u = central_differences(circuit, model, "outputs", len(model.outputs))
        for exact, difference in ((model.C, by_x), (model.D, by_u)):
            scale = np.max(np.abs(exact), axis=1, keepdims=True)
            assert np.all(np.abs(exact - difference) <= 1e-5 * scale + 1e-9)

    def test_operating_point_is_the_end_of_the_recording(self, name):
        circuit, recording, model = moving(name)
        last = recording.last()
        for state, value in zip(model.states, model.x, strict=True):
            assert value == pytest.approx(last[state], rel=1e-12, abs=1e-18)
        for output, value in zip(model.outputs, model.y, strict=True):
            assert value == pytest.approx(last[output], rel=1e-9, abs=1e-9)
        assert model.inputs == tuple(item.name for item in circuit.model.inputs)
        assert np.any(np.abs(model.rates) > 0.0)


class TestAt:
    def test_given_inputs_replace_those_of_the_recording(self):
        circuit = replace(through_flow(), signals={"supply.pressure": Steps([0.0, 0.5], [5e5, 6e5])})
        recording = circuit.simulate("1 s")
        assert circuit.linearise(at=recording).u[0] == 6e5
        assert circuit.linearise({"supply.pressure": "8 bar"}, at=recording).u[0] == 8e5

    def test_recording_without_a_state(self):
        circuit = through_flow()
        with pytest.raises(InputError) as caught:
            circuit.linearise(at=circuit.simulate("1 s").select("tank.pressure"))
        assert caught.value.code == "circuit.no_series"
        assert "tank.temperature" in caught.value.facts["missing"]


class TestLinearModel:
    def test_natural_frequency_of_the_paper_s_valve(self):
        model = stage("paper", Chamber(volume="0.2 m^3")).linearise({"valve.pilot_pressure": "3 bar g"})
        pair = model.eigenvalues()[-2:]
        # sqrt((k1 + k2)/m_p)/(2 pi) and d/(2 sqrt((k1 + k2) m_p)) of set A: 2.85e5 N/m, 20 g, 106 N s/m
        assert np.abs(pair) / (2.0 * np.pi) == pytest.approx(np.sqrt(2.85e5 / 0.020) / (2.0 * np.pi), rel=1e-9)
        assert np.abs(pair) / (2.0 * np.pi) == pytest.approx(600.0, rel=2e-3)
        assert -pair.real / np.abs(pair) == pytest.approx(106.0 / (2.0 * np.sqrt(2.85e5 * 0.020)), rel=1e-9)

    def test_closed_network_has_zero_eigenvalues(self):
        values = two_tanks().linearise().eigenvalues()
        assert np.all(np.abs(values[:3]) < 1e-9)
        assert values[3].real < -1.0

    def test_frequency_response_of_a_tank_is_a_first_order_lag(self):
        model = through_flow("isothermal").linearise()
        gain = model.frequency_response([0.0, 2.0, 50.0], "supply.pressure", "tank.pressure")
        pole = -model.eigenvalues()[0].real
        lag = gain[0] / (1.0 + 2j * np.pi * np.array([0.0, 2.0, 50.0]) / pole)
        np.testing.assert_allclose(gain, lag, rtol=1e-12)
        assert 0.0 < gain[0].real < 1.0
        assert gain[0].imag == 0.0

    def test_static_gain_is_the_slope_of_the_steady_state(self):
        circuit = through_flow(wall_conductance=1.0)
        gain = circuit.linearise().frequency_response(0.0, "supply.pressure", "tank.pressure")[0]
        ends = [circuit.steady_state({"supply.pressure": 7e5 + step}).y["tank.pressure"] for step in (-500.0, 500.0)]
        assert gain.real == pytest.approx((ends[1] - ends[0]) / 1000.0, rel=1e-6)

    def test_unknown_signals(self):
        model = through_flow().linearise()
        wrong = {"input": ("suply.pressure", "tank.pressure"), "output": ("supply.pressure", "tank.presure")}
        for kind, names in wrong.items():
            with pytest.raises(InputError) as caught:
                model.frequency_response(1.0, *names)
            assert caught.value.code == "names.unknown"
            assert kind in caught.value.facts["meaning"]
            assert caught.value.facts["suggestion"].names

    @pytest.mark.parametrize("suffix", [".json", ".mat", ".npz"])
    def test_saved_files_contain_matrices_and_names(self, tmp_path, suffix):
        model = through_flow().linearise()
        path = model.save(tmp_path / f"linear{suffix}")
        if suffix == ".json":
            content = json.loads(path.read_text())
        elif suffix == ".npz":
            content = np.load(path)
        else:
            from scipy.io import loadmat

            content = loadmat(path, chars_as_strings=True)
        for name in ("A", "B", "C", "D"):
            np.testing.assert_array_equal(np.array(content[name]), getattr(model, name))
        np.testing.assert_array_equal(np.ravel(content["x"]), model.x)
        states = [str(np.squeeze(state)) for state in np.ravel(content["states"])]
        assert states == list(model.states)
        assert [file.name for file in tmp_path.iterdir()] == [path.name]

    def test_unknown_suffix(self, tmp_path):
        with pytest.raises(InputError) as caught:
            through_flow().linearise().save(tmp_path / "linear.csv")
        assert caught.value.code == "files.suffix"


class TestPythonControl:
    def test_small_step_response_equals_the_nonlinear_one(self):
        control = pytest.importorskip("control", reason="python-control is not installed")
        circuit = through_flow(wall_conductance=1.0)
        steady = circuit.steady_state()
        begun = {
            "tank.initial_pressure": steady.y["tank.pressure"],
            "tank.initial_temperature": steady.y["tank.temperature"],
        }
        step = 20.0
        stepped = replace(circuit.with_values(begun), signals={"supply.pressure": Constant(7e5 + step)})
        recording = stepped.simulate("2 s", "10 ms", 1e-10)
        system = circuit.linearise().to_control()
        response = control.step_response(system["tank__pressure", "supply__pressure"], recording.time)
        rise = recording["tank.pressure"] - steady.y["tank.pressure"]
        assert rise[-1] > 0.3 * step
        np.testing.assert_allclose(rise, step * response.outputs, rtol=0.0, atol=1e-3 * step)

    def test_signals_are_named(self):
        pytest.importorskip("control", reason="python-control is not installed")
        system = through_flow().linearise().to_control()
        assert system.state_labels == ["tank__pressure", "tank__mass"]
        assert system.input_labels[0] == "supply__pressure"
        assert "tank__temperature" in system.output_labels

    def test_missing_package(self, monkeypatch):
        monkeypatch.setitem(sys.modules, "control", None)
        with pytest.raises(MissingDependencyError) as caught:
            through_flow().linearise().to_control()
        assert caught.value.extra == "control"

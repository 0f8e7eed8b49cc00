"""Pressure regulator and compressor: values, limits, energy, second law, steps of settled circuits, continued runs."""

from __future__ import annotations

import dataclasses
import math
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from poppet import Chamber, Circuit, Compressor, FlowSource, Orifice, PressureRegulator, Reservoir
from poppet.circuit.options import Ambient
from poppet.parts.part import GasState, Scope, Surroundings
from poppet.signals import Steps
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
SIZE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}
LIMITS = {"start_pressure": "6 bar", "stop_pressure": "8 bar"}
PUMP: dict[str, Any] = {"free_air_delivery": "240 l/min ANR", **LIMITS}
GASES = st.builds(GasState, st.floats(1e4, 1e6), st.floats(250.0, 400.0))


def flows_of(part: Any, states: dict[str, float], *gas: GasState, air: Surroundings = AIR) -> Any:
    numbers = part.parameters(air)
    inputs = {item.name: numbers[item.default] for item in part.inputs()}
    return part.flows(Scope(numbers, states, inputs, air), dict(zip(part.ports(), gas, strict=True)))


def regulator(**fields: Any) -> PressureRegulator:
    return PressureRegulator(supply="net", outlet="line", **{"setpoint": "5 bar", **SIZE, **fields})


def line(**fields: Any) -> Circuit:
    parts = {
        "net": Reservoir(pressure="8 bar"),
        "regulator": regulator(**fields),
        "line": Chamber(volume="1 l"),
        "tool": Orifice(from_="line", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3, opening=0.0),
    }
    return Circuit(parts)


class TestRegulator:
    def test_defaults_of_the_relief(self):
        numbers = regulator().parameters(AIR)
        assert (numbers["exhaust_conductance"], numbers["exhaust_ratio"]) == (1e-8, 0.3)
        assert [note.code for note in regulator().notes()] == ["supply.assumed_relief"]
        assert regulator(exhaust_conductance=1e-9).notes() == ()
        assert regulator().ports() == {"supply": "net", "outlet": "line", "exhaust": "ambient"}

    def test_gauge_setpoints_are_absolute_inside(self):
        assert regulator(setpoint="4 bar g").parameters(AIR)["setpoint"] == pytest.approx(5e5)

    @pytest.mark.parametrize(("position", "supply", "exhaust"), [(1, 1, 0), (0.25, 0.25, 0), (0, 0, 0), (-0.6, 0, 0.1)])
    def test_openings(self, position, supply, exhaust):
        part = regulator(droop="0.2 bar", relief_offset="0.1 bar")
        gas = GasState(8e5, 300.0), GasState(5e5, 300.0), GasState(1e5, 300.0)
        outputs = flows_of(part, {"position": position}, gas[2], gas[0], gas[1]).outputs
        assert outputs["supply_opening"][0] == supply
        assert outputs["exhaust_opening"][0] == pytest.approx(exhaust)

    @pytest.mark.parametrize("address", ["droop", "lag"])
    def test_zero_is_rejected(self, address):
        with refused("fields.out_of_range", address):
            regulator(**{address: 0.0})

    def test_a_regulator_without_hysteresis_regulates(self):
        parts = {**line().parts, "regulator": regulator(hysteresis=0.0)}
        run = Circuit(parts).with_values({"tool.opening": 1.0}).simulate(5.0)
        assert 4.7e5 < run["line.pressure"][-1] < 5e5

    def test_a_closed_line_is_settled_with_few_steps(self):
        short, long = (line().simulate(duration) for duration in (10.0, 1000.0))
        assert long.statistics["accepted_steps"] < short.statistics["accepted_steps"] + 30
        assert abs(long["line.pressure"][-1] - 5e5) < 5e3
        assert long["regulator.supply_opening"][-1] == long["regulator.exhaust_opening"][-1] == 0.0

    def test_a_constant_flow_is_settled_with_few_steps(self):
        circuit = line().with_values({"tool.opening": 1.0})
        short, long = (circuit.simulate(duration) for duration in (20.0, 2000.0))
        assert long.statistics["accepted_steps"] < short.statistics["accepted_steps"] + 60

    def test_a_lower_setpoint_relieves_down_to_the_offset(self):
        parts = {**line().parts, "regulator": regulator(hysteresis=0.0, relief_offset="0.2 bar")}
        signals = {"regulator.setpoint": Steps([0.0, 5.0], [5e5, 3e5])}
        relieved = Circuit(parts, signals).simulate(30.0)
        assert relieved["line.pressure"][-1] == pytest.approx(3.2e5, abs=2e3)
        parts["regulator"] = dataclasses.replace(parts["regulator"], exhaust_conductance=0.0)
        kept = Circuit(parts, signals).simulate(30.0)
        assert kept["line.pressure"][-1] == pytest.approx(kept["line.pressure"][kept.time == 4.98][0], rel=1e-3)

    def test_a_run_continues(self):
        circuit = line().with_values({"tool.opening": 1.0})
        whole, first = circuit.simulate(0.4), circuit.simulate(0.2)
        assert first["regulator.position"][-1] > 0.0
        second = circuit.resumed(first).simulate(0.2)
        for name in ("regulator.position", "line.pressure"):
            assert second[name][-1] == pytest.approx(whole[name][-1], rel=1e-4)

    @given(st.floats(-2.0, 1.0), st.lists(GASES, min_size=3, max_size=3))
    def test_entropy_does_not_decrease(self, position, states):
        part = regulator()
        gas = dict(zip(part.ports(), states, strict=True))
        result = flows_of(part, {"position": position}, *states)
        for flow in result.flows:
            assert entropy_production(flow, gas) >= -1e-12


def entropy_production(flow: Any, gas: dict[str, GasState]) -> float:
    """Entropy that both gas nodes gain per time, from their masses and energies [W/K]."""
    cp, r = 1004.675, 287.05
    total = 0.0
    for end, sign in ((flow.source, -1.0), (flow.target, 1.0)):
        state = gas[end]
        # dS = dH/T - m' (h/T - s), with s = cp ln T - R ln p.
        entropy = cp * math.log(state.temperature) - r * math.log(state.pressure)
        total += sign * (flow.enthalpy / state.temperature - flow.mass * (cp - entropy))
    return total


class TestCompressor:
    def test_delivery_at_anr_is_that_of_the_catalogue(self):
        result = flows_of(Compressor("tank", **PUMP), {"position": 1.0, "work": 0.0}, GasState(7e5, 300.0))
        assert result.outputs["mass_flow_rate"][0] == pytest.approx(4e-3 * 1.185)
        (flow,) = result.flows
        assert flow.enthalpy == pytest.approx(flow.mass * 1004.675 * 293.15)

    def test_delivery_follows_the_density_of_the_ambient_gas(self):
        air = Surroundings(0.8e5, 313.15, 296.8, 1.4, 1.0)
        result = flows_of(Compressor("tank", **PUMP), {"position": 1.0, "work": 0.0}, GasState(7e5, 300.0), air=air)
        expected = 4e-3 * 1.185 * 0.8 * 293.15 / 313.15 * 287.05 / 296.8
        assert result.outputs["mass_flow_rate"][0] == pytest.approx(expected)

    def test_the_whole_power_is_in_uncooled_air(self):
        part = Compressor("tank", **PUMP, cooling="none", efficiency=0.75)
        result = flows_of(part, {"position": 0.5, "work": 0.0}, GasState(9e5, 350.0))
        (flow,), power = result.flows, result.outputs["power"][0]
        assert flow.enthalpy - flow.mass * 1004.675 * 293.15 == pytest.approx(power)
        assert power == pytest.approx(flow.mass * 1004.675 * 293.15 * (9.0 ** (0.4 / 1.4) - 1.0) / 0.75)

    @given(st.floats(1e5, 5e6), st.floats(0.05, 1.0), st.sampled_from(["aftercooler", "none"]))
    def test_power_is_at_least_the_exergy_of_the_delivered_air(self, pressure, efficiency, cooling):
        part = Compressor("tank", **PUMP, cooling=cooling, efficiency=efficiency)
        result = flows_of(part, {"position": 1.0, "work": 0.0}, GasState(pressure, 300.0))
        (flow,) = result.flows
        temperature = flow.enthalpy / (flow.mass * 1004.675)
        entropy = 1004.675 * math.log(temperature / 293.15) - 287.05 * math.log(pressure / 1e5)
        exergy = flow.enthalpy - flow.mass * 293.15 * (1004.675 + entropy)
        assert result.outputs["power"][0] >= exergy * (1.0 - 1e-9) - 1e-9

    def test_a_stopped_compressor_is_tight(self):
        result = flows_of(Compressor("tank", **PUMP), {"position": 0.0, "work": 0.0}, GasState(7e5, 300.0))
        assert result.flows[0].mass == result.flows[0].enthalpy == result.outputs["power"][0] == 0.0

    @pytest.mark.parametrize(
        ("start", "stop"), [("8 bar", "6 bar"), ("7 bar", "7 bar"), ("7 bar g", "7.5 bar"), (7e5, 6e5)]
    )
    def test_limits_that_are_exchanged_are_rejected(self, start, stop):
        parts = {
            "pump": Compressor("tank", free_air_delivery="200 l/min ANR", start_pressure=start, stop_pressure=stop),
            "tank": Chamber(volume="10 l"),
        }
        with refused("supply.start_above_stop", "pump.start_pressure"):
            Circuit(parts)

    @pytest.mark.parametrize("field", ["free_air_delivery", "start_pressure", "efficiency"])
    def test_zero_is_rejected(self, field):
        with refused("fields.out_of_range", field):
            Compressor("tank", **{**PUMP, field: 0.0})

    def test_a_full_tank_is_settled_with_few_steps(self):
        circuit = Circuit({"pump": Compressor("tank", **PUMP), "tank": Chamber(volume="10 l")})
        short, long = (circuit.simulate(duration) for duration in (60.0, 6000.0))
        assert short["pump.position"][-1] == pytest.approx(0.0, abs=1e-9)
        assert 8e5 < short["tank.pressure"][-1] < 8.1e5
        assert long.statistics["accepted_steps"] < short.statistics["accepted_steps"] + 30
        assert long["pump.work"][-1] == pytest.approx(short["pump.work"][-1], rel=1e-9)

    def test_a_run_continues(self):
        parts = {
            "pump": Compressor("tank", **PUMP),
            "tank": Chamber(volume="10 l", initial_pressure="6.5 bar"),
            "consumer": FlowSource(to="tank", mass_flow_rate="-2 g/s"),
        }
        circuit = Circuit(parts)
        whole, first = circuit.simulate(30.0), circuit.simulate(15.0)
        second = circuit.resumed(first).simulate(15.0)
        assert first["pump.work"][-1] > 0.0
        for name in ("pump.position", "pump.work", "tank.pressure"):
            assert second[name][-1] == pytest.approx(whole[name][-1], rel=1e-4)

    def test_thin_air_fills_more_slowly(self):
        parts = {"pump": Compressor("tank", **PUMP), "tank": Chamber(volume="10 l", thermal="isothermal")}
        high = Circuit(parts, ambient=Ambient(pressure="0.8 bar")).simulate(5.0)
        low = Circuit(parts).simulate(5.0)
        gains = [run["tank.pressure"][-1] - run["tank.pressure"][0] for run in (high, low)]
        assert gains[0] / gains[1] == pytest.approx(0.8, rel=1e-3)

    def test_steady_state_of_a_full_tank(self):
        parts = {"pump": Compressor("tank", **PUMP), "tank": Chamber(volume="10 l", initial_pressure="7 bar")}
        assert Circuit(parts).steady_state().y["tank.pressure"] == pytest.approx(7e5)

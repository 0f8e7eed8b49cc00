"""Flow control valve, piloted check valve and filter: static characteristics, inputs and invalid fields."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from poppet import (
    Chamber,
    CheckValve,
    Circuit,
    Filter,
    FlowControlValve,
    Orifice,
    PilotedCheckValve,
    Reservoir,
    iso6358,
)
from poppet.parts.part import GasState, Scope, Surroundings
from poppet.signals import Points, Steps
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
SIZE = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}
ENDS = {"from_": "line", "to": "load"}
THROTTLE = {"throttle_conductance": 0.4e-8, "throttle_ratio": 0.45}


def result(part: Any, first: float, second: float, pilot: float = 1e5, **inputs: float) -> Any:
    """Flows at pressures of the ports; the temperatures are 300 K at `from` and 320 K at `to`."""
    numbers = part.parameters(AIR)
    gas = {"from": GasState(first, 300.0), "to": GasState(second, 320.0), "pilot": GasState(pilot, 293.15)}
    defaults = {item.name: numbers[item.default] for item in part.inputs()}
    return part.flows(Scope(numbers, {}, defaults | inputs, AIR), {port: gas[port] for port in part.ports()})


def flow_of(part: Any, *pressures: float, **inputs: float) -> float:
    return result(part, *pressures, **inputs).outputs["mass_flow_rate"][0]


def law(first: float, second: float, conductance: float = 2e-8, ratio: float = 0.3, **more: Any) -> float:
    return iso6358.mass_flow_rate(
        first, second, 300.0, 320.0, sonic_conductance=conductance, critical_ratio=ratio, **more
    )


class TestFlowControlValve:
    valve = FlowControlValve(**ENDS, **SIZE, **THROTTLE, cracking_pressure="0.2 bar")

    @pytest.mark.parametrize("first", [4.3e5, 5e5, 9e5, 20e5])
    def test_size_is_that_of_the_free_direction(self, first):
        known = law(first, 4e5, cracking_pressure=2e4, one_way=True)
        assert flow_of(self.valve, first, 4e5) == pytest.approx(known, rel=1e-14)

    @pytest.mark.parametrize("opening", [0.0, 0.3, 1.0])
    @pytest.mark.parametrize(("first", "second"), [(1e5, 9e5), (3.9e5, 4e5), (4.1e5, 4e5)])
    def test_throttle_has_the_flow_of_the_other_direction_and_below_cracking(self, opening, first, second):
        known = law(first, second, 0.4e-8 * opening, 0.45)
        assert flow_of(self.valve, first, second, opening=opening) == pytest.approx(known, rel=1e-14)

    def test_flow_is_continuous_and_increases_with_the_pressure(self):
        first = np.linspace(3e5, 6e5, 3001)
        flows = np.array([flow_of(self.valve, pressure, 4e5) for pressure in first])
        assert np.all(np.diff(flows) > 0.0)
        assert np.diff(flows).max() < 0.01 * (flows.max() - flows.min())

    def test_enthalpy_is_that_of_the_upstream_gas(self):
        for first, second, temperature in ((6e5, 4e5, 300.0), (4.1e5, 4e5, 300.0), (2e5, 4e5, 320.0)):
            (flow,) = result(self.valve, first, second).flows
            assert flow.enthalpy == pytest.approx(AIR.heat_capacity_pressure * temperature * flow.mass, rel=1e-14)

    @pytest.mark.parametrize(
        ("first", "second", "regime"), [(9e5, 1e5, 3), (5e5, 4e5, 2), (4e5, 5e5, -2), (1e5, 9e5, -3)]
    )
    def test_regime_is_that_of_the_larger_flow(self, first, second, regime):
        assert result(self.valve, first, second).outputs["regime"][0] == regime

    def test_closed_throttle_has_no_regime(self):
        parts = {"line": Reservoir(pressure="1 bar"), "valve": self.valve}
        parts["load"] = Chamber(volume="1 l", initial_pressure="8 bar")
        recording = Circuit(parts, {"valve.opening": Steps([0.0, 0.5], [0.0, 1.0])}).simulate(1.0, 0.5)
        assert recording["valve.regime"][[0, 1]].tolist() == [0, -3]

    def test_throttle_has_the_critical_ratio_of_the_size(self):
        valve = FlowControlValve(**ENDS, effective_area="10 mm^2", throttle_conductance=1e-9)
        assert valve.parameters(AIR)["throttle_ratio"] == pytest.approx(0.528, abs=1e-3)

    def test_pair_of_check_valve_and_throttle_fills_faster_by_the_throttle(self):
        """The flow of a parallel pair is the sum of both; this part states the total."""
        parts = {"line": Reservoir(pressure="7 bar"), "load": Chamber(volume="1 l", thermal="isothermal")}
        one = Circuit(parts | {"valve": FlowControlValve(**ENDS, **SIZE, throttle_conductance=0.4e-8)})
        pair = {"check": CheckValve(**ENDS, **SIZE), "throttle": Orifice(**ENDS, sonic_conductance=0.4e-8)}
        filled = [circuit.simulate(0.1, 0.01)["load.mass"] for circuit in (one, Circuit(parts | pair))]
        ratio = (filled[1][-1] - filled[1][0]) / (filled[0][-1] - filled[0][0])
        assert ratio == pytest.approx(1.2, abs=0.01)

    def test_opening_follows_a_signal(self):
        parts = {
            "line": Reservoir(pressure="1 bar"),
            "valve": FlowControlValve(**ENDS, **SIZE, **THROTTLE),
            "load": Chamber(volume="1 l", thermal="isothermal", initial_pressure="8 bar"),
        }
        recording = Circuit(parts, {"valve.opening": Steps([0.0, 0.5], [0.0, 1.0])}).simulate(1.0, 0.01)
        assert recording["load.pressure"][49] == pytest.approx(8e5, rel=1e-9)
        assert recording["valve.mass_flow_rate"][50] == pytest.approx(-0.4e-8 * 1.185 * 8e5, rel=1e-6)


class TestPilotedCheckValve:
    valve = PilotedCheckValve(
        **ENDS, pilot="pilot", **SIZE, pilot_ratio=4.0, cracking_pressure="0.2 bar", pilot_band="0.4 bar"
    )

    def test_forward_flow_is_that_of_a_check_valve(self):
        known = law(6e5, 4e5, cracking_pressure=2e4, one_way=True)
        assert flow_of(self.valve, 6e5, 4e5, 1e5) == pytest.approx(known, rel=1e-14)
        assert flow_of(self.valve, 4.1e5, 4e5, 1e5) == 0.0

    @pytest.mark.parametrize(("pilot", "opening"), [(1e5, 0.0), (2.3e5, 0.0), (2.35e5, 0.5), (2.4e5, 1.0), (9e5, 1.0)])
    def test_pilot_opens_against_the_closing_pressure(self, pilot, opening):
        """With 1 bar at `from` and 6 bar at `to`, the pilot needs 1 + (5 + 0.2)/4 bar."""
        outputs = result(self.valve, 1e5, 6e5, pilot).outputs
        assert outputs["opening"][0] == pytest.approx(opening, abs=1e-9)
        assert outputs["mass_flow_rate"][0] == pytest.approx(law(1e5, 6e5, 2e-8 * opening), rel=1e-8)

    def test_opened_valve_has_no_cracking_pressure(self):
        assert flow_of(self.valve, 4.1e5, 4e5, 9e5) == pytest.approx(law(4.1e5, 4e5), rel=1e-14)

    def test_back_pressure_acts_against_the_pilot(self):
        assert result(self.valve, 3e5, 6e5, 3.5e5).outputs["opening"][0] == 0.0
        assert result(self.valve, 3e5, 6e5, 3.9e5).outputs["opening"][0] == 1.0

    @pytest.mark.parametrize("ratio", [1e-3, 1.0, 1e6])
    def test_extreme_ratios_simulate(self, ratio):
        recording = self.locked_load(Points([0.0, 1.0], [1e5, 5e5]), pilot_ratio=ratio)
        opened = recording["load.pressure"][-1] < 1.1e5
        assert opened == (ratio > 1.0)
        assert recording.statistics["accepted_steps"] < 1000

    def test_valve_holds_the_load_until_the_pilot_opens_it(self):
        recording = self.locked_load(Steps([0.0, 0.5], [1e5, 5e5]))
        assert recording["load.pressure"][49] == pytest.approx(6e5, rel=1e-12)
        assert recording["load.pressure"][-1] < 1.1e5
        assert recording["pilot.pressure"][-1] == pytest.approx(5e5)
        assert all(residual.is_kept for residual in recording.residuals)

    @staticmethod
    def locked_load(pilot: Any, **fields: Any) -> Any:
        parts = {
            "pilot": Reservoir(pressure="1 bar"),
            "lock": PilotedCheckValve(from_="ambient", to="load", pilot="pilot", **SIZE, **fields),
            "load": Chamber(volume="0.5 l", initial_pressure="6 bar", thermal="isothermal"),
        }
        return Circuit(parts, {"pilot.pressure": pilot}).simulate(1.0, 0.01)

    def test_pilot_port_has_no_flow_and_no_effect_on_its_gas_node(self):
        parts = {
            "line": Reservoir(pressure="7 bar"),
            "lock": PilotedCheckValve(**ENDS, pilot="signal", **SIZE),
            "load": Chamber(volume="1 l"),
            "signal": Chamber(volume="1 cm^3", initial_pressure="9 bar"),
        }
        recording = Circuit(parts).simulate(1.0, 0.1)
        assert recording["signal.pressure"] == pytest.approx(np.full(11, 9e5), rel=1e-14)

    def test_same_node_at_both_ends_is_rejected_but_not_at_the_pilot(self):
        parts = {"load": Chamber(volume="1 l"), "signal": Chamber(volume="1 l")}
        loop = PilotedCheckValve(from_="load", to="load", pilot="signal", **SIZE)
        with refused("wiring.joined_twice", "parts.lock"):
            Circuit(parts | {"lock": loop})
        Circuit(parts | {"lock": PilotedCheckValve(from_="load", to="signal", pilot="load", **SIZE)})


class TestFilter:
    @pytest.mark.parametrize("clogging", [0.0, 0.25, 1.0])
    def test_clogging_reduces_the_conductance(self, clogging):
        part = Filter(**ENDS, **SIZE)
        known = law(6e5, 4e5, 2e-8 * (1.0 - clogging))
        assert flow_of(part, 6e5, 4e5, clogging=clogging) == pytest.approx(known, rel=1e-14)
        assert flow_of(part, 4e5, 6e5, clogging=clogging) == pytest.approx(law(4e5, 6e5, 2e-8 * (1.0 - clogging)))

    def test_clogging_follows_a_signal(self):
        parts = {
            "line": Reservoir(pressure="7 bar"),
            "filter": Filter(**ENDS, **SIZE),
            "load": Chamber(volume="1 m^3", thermal="isothermal"),
        }
        recording = Circuit(parts, {"filter.clogging": Points([0.0, 10.0], [0.0, 1.0])}).simulate(10.0, 0.1)
        known = 2e-8 * 1.185 * 7e5 * (1.0 - recording.time / 10.0)
        assert recording["filter.mass_flow_rate"] == pytest.approx(known, rel=1e-9, abs=1e-12)


@pytest.mark.parametrize(
    ("kind", "fields", "code"),
    [
        (FlowControlValve, {}, "fields.missing"),
        (FlowControlValve, {**THROTTLE, "opening": 1.1}, "fields.out_of_range"),
        (FlowControlValve, {**THROTTLE, "throttle_ratio": 1.0}, "fields.out_of_range"),
        (FlowControlValve, {**THROTTLE, "cracking_pressure": -1.0}, "fields.out_of_range"),
        (FlowControlValve, {**THROTTLE, "to": None}, "fields.missing_port"),
        (PilotedCheckValve, {}, "fields.missing_port"),
        (PilotedCheckValve, {"pilot": "signal", "pilot_ratio": 0.0}, "fields.out_of_range"),
        (PilotedCheckValve, {"pilot": "signal", "pilot_band": 0.0}, "fields.out_of_range"),
        (Filter, {"clogging": -0.1}, "fields.out_of_range"),
    ],
)
def test_invalid_fields(kind, fields, code):
    with refused(code):
        kind(**{**ENDS, **SIZE, **fields})


@pytest.mark.parametrize(
    ("kind", "fields"), [(FlowControlValve, THROTTLE), (PilotedCheckValve, {"pilot": "signal"}), (Filter, {})]
)
def test_characteristics_are_rejected(kind, fields):
    with refused("parts.no_stroke_to_follow", "characteristic"):
        kind(**ENDS, **fields, characteristic="varga2012")

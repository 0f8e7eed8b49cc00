"""Valves that pressures switch: paths, switching with hysteresis, symmetry, and wiring errors."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, InputErrors, QuickExhaustValve, Reservoir, ShuttleValve, TwoPressureValve, iso6358
from poppet.parts.part import AMBIENT, GasState, Scope, Surroundings
from poppet.signals import Points
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
SIZE = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}
INLETS = {"a": "left", "b": "right", "outlet": "load"}
QUICK = {"inlet": "line", "outlet": "load"}
TWO_INLETS = [ShuttleValve, TwoPressureValve]


def result(part: Any, position: float, **pressures: float) -> Any:
    """Flows and speed of a valve with its element at a position; ports without a pressure have 1 bar."""
    states = {port: GasState(pressures.get(port, 1e5), 300.0 + 10.0 * k) for k, port in enumerate(part.ports())}
    return part.flows(Scope(part.parameters(AIR), {"position": position}, {}, AIR), states)


def law(first: float, second: float, conductance: float = 2e-8, ratio: float = 0.3, **more: Any) -> float:
    """Mass flow rate with temperatures 300 K and 320 K, those of the first and third port."""
    return iso6358.mass_flow_rate(
        first, second, 300.0, 320.0, sonic_conductance=conductance, critical_ratio=ratio, **more
    )


def inlet_b(first: float, second: float, conductance: float) -> float:
    """Mass flow rate from inlet b with 310 K to the outlet with 320 K."""
    return iso6358.mass_flow_rate(first, second, 310.0, 320.0, sonic_conductance=conductance, critical_ratio=0.3)


def reservoirs(valve: Any, a: Any, b: Any, duration: float = 2.0, step: float = 1e-3, volume: str = "0.1 l") -> Any:
    """Recording of a valve between two inlets with prescribed pressures and a chamber."""
    parts = {"left": Reservoir(pressure="1 bar"), "right": Reservoir(pressure="1 bar"), "valve": valve}
    parts["load"] = Chamber(volume=volume, thermal="isothermal")
    return Circuit(parts, {"left.pressure": a, "right.pressure": b}).simulate(duration, step)


EARLY = [(0.0, 1.0, 0.0), (0.3, 1.0, 0.2), (0.5, 1.0, 1.0), (0.7, 0.2, 1.0), (0.75, 0.0, 1.0), (1.0, 0.0, 1.0)]
LATE = [(0.0, 1.0, 0.0), (0.1, 0.6, 0.0), (0.25, 0.0, 0.0), (0.5, 0.0, 0.0), (0.9, 0.0, 0.6), (1.0, 0.0, 1.0)]


@pytest.mark.parametrize(("kind", "outlet"), [(ShuttleValve, 2e5), (TwoPressureValve, 9e5)])
@pytest.mark.parametrize(("position", "a", "b"), EARLY)
def test_inlets_that_lose_their_drive_by_the_flow_are_open_together(kind, outlet, position, a, b):
    outputs = result(kind(**INLETS, **SIZE), position, a=6e5, b=5e5, outlet=outlet).outputs
    known = law(6e5, outlet, 2e-8 * a), inlet_b(5e5, outlet, 2e-8 * b)
    found = outputs["a_mass_flow_rate"][0], outputs["b_mass_flow_rate"][0]
    assert found == pytest.approx(known, rel=1e-9, abs=1e-15)


@pytest.mark.parametrize(("kind", "outlet"), [(ShuttleValve, 9e5), (TwoPressureValve, 2e5)])
@pytest.mark.parametrize(("position", "a", "b"), LATE)
def test_inlets_that_gain_drive_by_the_flow_are_never_open_together(kind, outlet, position, a, b):
    outputs = result(kind(**INLETS, **SIZE), position, a=6e5, b=5e5, outlet=outlet).outputs
    known = law(6e5, outlet, 2e-8 * a), inlet_b(5e5, outlet, 2e-8 * b)
    found = outputs["a_mass_flow_rate"][0], outputs["b_mass_flow_rate"][0]
    assert found == pytest.approx(known, rel=1e-9, abs=1e-15)


@pytest.mark.parametrize("kind", TWO_INLETS)
@pytest.mark.parametrize("outlet", [1e5, 4.5e5, 5.5e5, 9e5])
def test_gas_never_flows_from_one_inlet_to_the_other(kind, outlet):
    for position in np.linspace(0.0, 1.0, 101):
        for a, b in ((6e5, 3e5), (3e5, 6e5), (5e5, 5e5)):
            outputs = result(kind(**INLETS, **SIZE), position, a=a, b=b, outlet=outlet).outputs
            assert outputs["a_mass_flow_rate"][0] * outputs["b_mass_flow_rate"][0] >= 0.0


@pytest.mark.parametrize(("kind", "side"), [(ShuttleValve, 1.0), (TwoPressureValve, -1.0)])
def test_element_moves_outside_its_hysteresis_only(kind, side):
    valve = kind(**INLETS, **SIZE, switching_pressure="0.2 bar", switching_time="5 ms")
    start = 0.5 - 0.5 * side
    assert result(valve, start, a=3e5, b=3.21e5).rates["position"] == pytest.approx(side * 10.0)
    for b in (3.4e5, 9e5):
        assert result(valve, start, a=3e5, b=b).rates["position"] == pytest.approx(side * 200.0)
    for position in (0.0, 1.0):
        for b in (2.801e5, 3e5, 3.199e5):
            assert result(valve, position, a=3e5, b=b).rates["position"] == 0.0


@pytest.mark.parametrize("kind", TWO_INLETS)
def test_exchanged_inlets_give_the_mirror_image(kind):
    rise, fall = Points([0.0, 1.0, 2.0], [1e5, 6e5, 2e5]), Points([0.0, 1.5, 2.0], [5e5, 1e5, 4e5])
    first = reservoirs(kind(**INLETS, **SIZE, initial_position=1.0), rise, fall)
    second = reservoirs(kind(**INLETS, **SIZE, initial_position=0.0), fall, rise)
    assert first["load.pressure"] == pytest.approx(second["load.pressure"], rel=1e-5)
    assert first["valve.a_mass_flow_rate"] == pytest.approx(second["valve.b_mass_flow_rate"], rel=1e-3, abs=2e-7)
    assert np.abs(first["valve.position"] + second["valve.position"] - 1.0).max() < 1e-4


@pytest.mark.parametrize(("kind", "choose"), [(ShuttleValve, np.fmax), (TwoPressureValve, np.fmin)])
def test_outlet_follows_the_selected_inlet(kind, choose):
    a, b = Points([0.0, 1.0, 2.0], [1e5, 6e5, 2e5]), Points([0.0, 1.5, 2.0], [5e5, 1e5, 4e5])
    recording = reservoirs(kind(**INLETS, **SIZE), a, b, volume="1 cm^3")
    left, right = recording["left.pressure"], recording["right.pressure"]
    is_settled = (np.abs(left - right) > 0.15e5) & (recording.time > 0.01)
    selected = choose(left, right)
    assert np.abs(recording["load.pressure"] / selected - 1.0)[is_settled].max() < 5e-3
    assert np.abs(recording["valve.position"] - (selected == right))[is_settled].max() < 1e-6


class TestQuickExhaustValve:
    valve = QuickExhaustValve(**QUICK, **SIZE, exhaust_conductance=5e-8, exhaust_ratio=0.5)

    def test_fills_through_the_inlet(self):
        outputs = result(self.valve, 0.0, inlet=6e5, outlet=4e5).outputs
        assert outputs["inlet_mass_flow_rate"][0] == pytest.approx(law(6e5, 4e5, one_way=True), rel=1e-12)
        assert outputs["exhaust_mass_flow_rate"][0] == 0.0

    def test_vents_through_the_exhaust(self):
        outputs = result(self.valve, 1.0, inlet=1e5, outlet=4e5).outputs
        known = iso6358.mass_flow_rate(4e5, 1e5, 310.0, 320.0, sonic_conductance=5e-8, critical_ratio=0.5)
        assert outputs["exhaust_mass_flow_rate"][0] == pytest.approx(known, rel=1e-12)
        assert outputs["inlet_mass_flow_rate"][0] == 0.0

    @pytest.mark.parametrize("position", [0.0, 0.2, 0.8])
    def test_no_gas_returns_to_the_inlet(self, position):
        assert result(self.valve, position, inlet=2e5, outlet=5e5).outputs["inlet_mass_flow_rate"][0] == 0.0

    def test_seal_moves_outside_its_hysteresis_only(self):
        assert result(self.valve, 0.0, inlet=3e5, outlet=3.11e5).rates["position"] == pytest.approx(500.0)
        assert result(self.valve, 1.0, inlet=3.11e5, outlet=3e5).rates["position"] == pytest.approx(-500.0)
        for position in (0.0, 1.0):
            for outlet in (2.951e5, 3e5, 3.049e5):
                assert result(self.valve, position, inlet=3e5, outlet=outlet).rates["position"] == 0.0

    def test_exhaust_has_defaults(self):
        valve = QuickExhaustValve(**QUICK, **SIZE)
        assert valve.ports() == {**QUICK, "exhaust": AMBIENT}
        numbers = valve.parameters(AIR)
        assert (numbers["exhaust_conductance"], numbers["exhaust_ratio"]) == (2e-8, 0.3)

    def test_size_of_the_exhaust_follows_other_sizes(self):
        numbers = QuickExhaustValve(**QUICK, effective_area="10 mm^2").parameters(AIR)
        assert numbers["exhaust_conductance"] == numbers["sonic_conductance"]
        assert numbers["exhaust_ratio"] == numbers["critical_ratio"] == pytest.approx(0.528, abs=1e-3)

    def test_load_fills_and_vents_directly(self):
        parts = {
            "line": Reservoir(pressure="1 bar"),
            "valve": QuickExhaustValve(**QUICK, **SIZE),
            "load": Chamber(volume="0.1 l"),
        }
        pulse = Points([0.0, 0.01, 0.5, 0.51], [1e5, 7e5, 7e5, 1e5])
        recording = Circuit(parts, {"line.pressure": pulse}).simulate(1.0, 1e-3)
        assert recording["load.pressure"][500] == pytest.approx(7e5, rel=1e-3)
        assert recording["load.pressure"][-1] == pytest.approx(1e5, rel=1e-3)
        drawn = np.trapezoid(recording["valve.inlet_mass_flow_rate"], recording.time)
        vented = np.trapezoid(recording["valve.exhaust_mass_flow_rate"], recording.time)
        assert drawn - vented == pytest.approx(recording["load.mass"][-1] - recording["load.mass"][0], abs=5e-6)
        assert recording["valve.inlet_mass_flow_rate"].min() == 0.0
        assert all(residual.is_kept for residual in recording.residuals)


def test_recorded_position_is_between_the_seats():
    """Also where the state exceeds a seat by the tolerance, so that a run can continue from any row."""
    ramp = Points([0.0, 0.2, 0.4, 0.6, 0.8, 1.0], [1e5, 6e5, 1e5, 6e5, 1e5, 6e5])
    recording = reservoirs(ShuttleValve(**INLETS, **SIZE), Points([0.0, 1.0], [3e5, 3e5]), ramp, duration=1.0)
    position = recording["valve.position"]
    assert 0.0 <= position.min() < 1e-6
    assert 1.0 - 1e-6 < position.max() <= 1.0


def test_run_continues_with_the_position():
    valve = ShuttleValve(**INLETS, **SIZE)
    parts = {"left": Reservoir(pressure="2 bar"), "right": Reservoir(pressure="3 bar"), "valve": valve}
    circuit = Circuit(parts | {"load": Chamber(volume="1 l")})
    resumed = circuit.resumed(circuit.simulate(0.1, 0.01))
    assert resumed.parameters["valve.initial_position"] == pytest.approx(1.0, abs=1e-9)


@pytest.mark.parametrize("kind", TWO_INLETS)
def test_wiring_errors(kind):
    parts = {
        "rail": Reservoir(pressure="7 bar"),
        "load": Chamber(volume="1 l"),
        "equal": kind(a="rail", b="rail", outlet="load", **SIZE),
        "back": kind(a="rail", b="load", outlet="load", **SIZE),
        "lost": kind(a="rail", b="nowhere", outlet="load", **SIZE),
        "quick": QuickExhaustValve(inlet="load", outlet="load", **SIZE),
    }
    with pytest.raises(InputErrors) as caught:
        Circuit(parts)
    assert {(error.code, error.address) for error in caught.value.problems} == {
        ("wiring.equal_inlets", "parts.equal"),
        ("wiring.joined_twice", "parts.back"),
        ("fields.not_an_option", "parts.lost.b"),
        ("wiring.joined_twice", "parts.quick"),
    }


@pytest.mark.parametrize(
    ("fields", "code"),
    [
        ({"switching_pressure": 0.0}, "fields.out_of_range"),
        ({"switching_pressure": "0.1 bar g"}, "quantity.gauge_difference"),
        ({"switching_time": "0 s"}, "fields.out_of_range"),
        ({"initial_position": 1.5}, "fields.out_of_range"),
        ({"outlet": None}, "fields.missing_port"),
    ],
)
def test_invalid_fields(fields, code):
    for kind in TWO_INLETS:
        with refused(code):
            kind(**{**INLETS, **SIZE, **fields})
    with refused(code):
        QuickExhaustValve(**{**QUICK, **SIZE, **fields})


@pytest.mark.parametrize("kind", [*TWO_INLETS, QuickExhaustValve])
def test_characteristics_are_rejected(kind):
    with refused("parts.no_stroke_to_follow", "characteristic"):
        kind(**(QUICK if kind is QuickExhaustValve else INLETS), characteristic="varga2012")

"""The directional valve with five ports: its edges, its spool, and what it says to wrong wiring."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, InputErrors, Orifice, Reservoir, SpoolValve, iso6358
from poppet.parts.part import GasState, Scope, Surroundings
from poppet.signals import Steps
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
PORTS = {"supply": "rail", "a": "first", "b": "second"}
SIZE = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}
GAS = {
    "supply": GasState(7e5, 300.0), "a": GasState(4e5, 310.0), "b": GasState(3e5, 280.0),
    "exhaust_a": GasState(1e5, 293.15), "exhaust_b": GasState(1.1e5, 293.15),
}  # fmt: skip
EDGES = {
    "supply_a": ("supply", "a"), "supply_b": ("supply", "b"),
    "exhaust_a": ("a", "exhaust_a"), "exhaust_b": ("b", "exhaust_b"),
}  # fmt: skip


def flows(position: float, **fields: Any) -> dict[str, float]:
    """Mass flow rate of each edge with the spool at a position."""
    valve = SpoolValve(**PORTS, **SIZE, **fields)
    scope = Scope(valve.parameters(AIR), {"position": position}, {"command": 0.0}, AIR)
    outputs = valve.flows(scope, GAS).outputs
    return {edge: outputs[f"{edge}_mass_flow_rate"][0] for edge in EDGES}


def by_law(edge: str, conductance: float, ratio: float) -> float:
    first, second = (GAS[port] for port in EDGES[edge])
    return iso6358.mass_flow_rate(
        first.pressure, second.pressure, first.temperature, second.temperature,
        sonic_conductance=conductance, critical_ratio=ratio,
    )  # fmt: skip


def run(driven: Any, duration: float = 0.1, **fields: Any) -> Any:
    parts = {
        "rail": Reservoir(pressure="7 bar"),
        "first": Chamber(volume="1 l"),
        "second": Chamber(volume="0.5 l"),
        "valve": SpoolValve(**PORTS, **SIZE, **fields),
    }
    signals = {} if driven is None else {"valve.command": driven}
    return Circuit(parts, signals).simulate(duration, 1e-3)


@pytest.mark.parametrize(
    ("position", "openings"),
    [
        (1.0, {"supply_a": 1.0, "exhaust_b": 1.0}),
        (0.4, {"supply_a": 0.4, "exhaust_b": 0.4}),
        (0.0, {}),
        (-0.7, {"supply_b": 0.7, "exhaust_a": 0.7}),
        (1.2, {"supply_a": 1.0, "exhaust_b": 1.0}),  # a spool that overshoots opens no further
    ],
)
def test_the_spool_opens_two_edges_and_shuts_the_others(position, openings):
    expected = {edge: by_law(edge, 2e-8 * openings.get(edge, 0.0), 0.3) for edge in EDGES}
    assert flows(position) == pytest.approx(expected, rel=1e-12)


def test_each_edge_has_its_own_size():
    own = {"supply_b_conductance": 1e-8, "supply_b_ratio": 0.2, "exhaust_a_conductance": 5e-9, "exhaust_a_ratio": 0.4}
    assert flows(-1.0, **own)["supply_b"] == pytest.approx(by_law("supply_b", 1e-8, 0.2), rel=1e-12)
    assert flows(-1.0, **own)["exhaust_a"] == pytest.approx(by_law("exhaust_a", 5e-9, 0.4), rel=1e-12)
    # The other exhaust is like the first one, unless it is said.
    assert flows(1.0, **own)["exhaust_b"] == pytest.approx(by_law("exhaust_b", 5e-9, 0.4), rel=1e-12)


@pytest.mark.parametrize(
    ("fields", "position", "supplies", "exhausts"),
    [
        ({"overlap": 0.2}, 0.2, 0.0, 0.0),
        ({"overlap": 0.2}, 0.6, 0.5, 0.5),
        ({"overlap": 0.2, "exhaust_overlap": -0.25}, 0.0, 0.0, 0.2),  # exhausted at the centre
        ({"overlap": -0.25, "exhaust_overlap": 0.1}, 0.0, 0.2, 0.0),  # under pressure at the centre
    ],
)
def test_overlaps_decide_the_centre(fields, position, supplies, exhausts):
    found = flows(position, **fields)
    assert found["supply_a"] == pytest.approx(by_law("supply_a", 2e-8 * supplies, 0.3), rel=1e-12, abs=1e-15)
    assert found["exhaust_b"] == pytest.approx(by_law("exhaust_b", 2e-8 * exhausts, 0.3), rel=1e-12, abs=1e-15)
    if position == 0.0:  # both sides alike
        assert found["exhaust_a"] == pytest.approx(by_law("exhaust_a", 2e-8 * exhausts, 0.3), rel=1e-12, abs=1e-15)


def test_a_shut_edge_leaks():
    found = flows(1.0, leak_conductance=1e-11)
    assert found["supply_b"] == pytest.approx(by_law("supply_b", 1e-11, 0.3), rel=1e-12)
    assert found["supply_a"] == pytest.approx(by_law("supply_a", 2e-8, 0.3), rel=1e-12)


def test_a_spool_of_first_order_and_its_delay():
    recording = run(Steps([0.0, 0.01], [0.0, 1.0]), lag="5 ms", delay="4 ms")
    after = np.maximum(recording.time - 0.014, 0.0)
    assert np.abs(recording["valve.position"] - (1.0 - np.exp(-after / 5e-3))).max() < 1e-5


def test_the_overshoot_of_a_second_order_spool_matches_its_damping():
    recording = run(Steps([0.0, 0.01], [0.0, 0.5]), dynamics="second_order", natural_frequency="50 Hz", damping=0.4)
    damped = math.sqrt(1.0 - 0.4**2)
    turn, after = 2.0 * math.pi * 50.0, np.maximum(recording.time - 0.01, 0.0)
    wave = np.cos(damped * turn * after) + 0.4 / damped * np.sin(damped * turn * after)
    assert np.abs(recording["valve.position"] - 0.5 * (1.0 - np.exp(-0.4 * turn * after) * wave)).max() < 1e-5


@pytest.mark.parametrize("fields", [{"lag": "0.1 ms"}, {"dynamics": "second_order", "natural_frequency": "2 kHz"}])
def test_a_switched_spool_takes_its_time_from_end_to_end(fields):
    recording = run(Steps([0.0, 0.02], [-1.0, 1.0]), switching_time="20 ms", command=-1.0, **fields)
    assert recording["valve.position"][[0, 20, 40]] == pytest.approx([-1.0, -1.0, 0.0], abs=1e-2)
    assert recording["valve.position"][-1] == pytest.approx(1.0, abs=1e-6)


def test_a_chamber_fills_while_the_other_empties_and_no_gas_is_lost():
    recording = run(None, duration=1.0, command=-1.0)
    assert recording["second.pressure"][-1] == pytest.approx(7e5, rel=1e-3)
    assert recording["first.pressure"][-1] == pytest.approx(1e5, rel=1e-3)
    assert recording["valve.position"][0] == -1.0
    assert all(residual.is_kept for residual in recording.residuals)


def test_wiring_errors_are_reported_together():
    parts = {
        "rail": Reservoir(pressure="7 bar"),
        "first": Chamber(volume="1 l"),
        "end": Chamber(volume="1 l"),
        "join": Orifice(from_="first", to="end", **SIZE),
        "twice": SpoolValve(supply="rail", a="first", b="first", **SIZE),
        "back": SpoolValve(supply="rail", a="rail", b="first", **SIZE),
        "lost": SpoolValve(supply="rail", a="first", b="nowhere", exhaust_a="end", exhaust_b="none", **SIZE),
    }
    with pytest.raises(InputErrors) as caught:
        Circuit(parts)
    assert {(each.code, each.address) for each in caught.value.problems} == {
        ("wiring.joined_twice", "parts.twice"),
        ("wiring.joined_twice", "parts.back"),
        ("fields.not_an_option", "parts.lost.b"),
        ("fields.not_an_option", "parts.lost.exhaust_b"),
    }


@pytest.mark.parametrize(
    ("fields", "code"),
    [
        ({"overlap": 1.0}, "fields.out_of_range"),
        ({"dynamics": "third_order"}, "fields.not_an_option"),
        ({"lag": "0 s"}, "fields.out_of_range"),
        ({"command": 2.0}, "fields.out_of_range"),
        ({"a": None}, "fields.missing_port"),
    ],
)
def test_numbers_that_cannot_be(fields, code):
    with refused(code):
        SpoolValve(**{**PORTS, **SIZE, **fields})

"""Examples of `docs/logic_valves.md`: the values of its tables, and the steps of circuits at rest."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from poppet import Chamber, Circuit, DirectionalValve, Orifice, Reservoir, ShuttleValve, load
from poppet.signals import Steps

EXAMPLES = Path(__file__).parents[3] / "examples"


def test_quick_exhaust_valve_shortens_the_return_stroke():
    circuit = load(EXAMPLES / "quick_exhaust.toml")
    hose = replace(circuit.parts["hose_cap"], to="fitting.from")
    fitting = Orifice(from_="hose_cap", to="cylinder.cap", nominal_flow="300 l/min ANR")
    parts = {name: part for name, part in circuit.parts.items() if name != "quick"}
    without = Circuit(parts | {"hose_cap": hose, "fitting": fitting}, circuit.signals, run=circuit.run)
    small = circuit.with_values({"quick.exhaust_conductance": "1 dm^3/(s bar)"})
    times = [
        [stroke.from_command for stroke in variant.simulate().figures.strokes] for variant in (without, small, circuit)
    ]
    assert [extended for extended, _ in times] == pytest.approx([0.385] * 3, abs=1e-3)
    assert [returned for _, returned in times] == pytest.approx([0.514, 0.378, 0.209], abs=1e-3)


def test_clamp_closes_with_both_buttons_or_the_pedal():
    recording = load(EXAMPLES / "two_hand_control.toml").simulate()
    is_closed = dict(zip(recording.time.round(3), recording["jaw.position"] > 20e-3, strict=True))
    expected = {0.59: False, 1.0: True, 1.5: True, 1.95: False, 2.45: False, 3.0: True, 3.3: True, 3.9: False}
    assert {time: is_closed[time] for time in expected} == expected
    first, second, *_ = recording.figures.strokes
    assert (first.duration, second.duration) == pytest.approx((0.227, 0.100), abs=1e-3)


@pytest.mark.parametrize("name", ["quick_exhaust", "two_hand_control"])
def test_circuit_at_rest_takes_large_steps(name):
    circuit = load(EXAMPLES / f"{name}.toml")
    end = float(circuit.run.duration)
    steps = [sum(circuit.simulate(duration, 1.0).statistics.values()) for duration in (end, end + 1000.0)]
    assert steps[1] - steps[0] < 100
    assert steps[0] < 4000


def test_two_equal_signals_that_fill_a_tank_do_not_chatter():
    """Both lines lose pressure to the outlet, so that the element moves between them while the tank is filled."""
    valve = {"supply": "supply", "exhaust": "ambient", "nominal_flow": "100 l/min ANR"}
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "left": DirectionalValve(outlet="left_line", **valve),
        "right": DirectionalValve(outlet="right_line", **valve),
        "left_line": Chamber(volume="5 cm^3"),
        "right_line": Chamber(volume="5 cm^3"),
        "or": ShuttleValve(a="left_line", b="right_line", outlet="tank", nominal_flow="300 l/min ANR"),
        "tank": Chamber(volume="0.5 l"),
    }
    on = Steps([0.0, 0.1], [0.0, 1.0])
    recording = Circuit(parts, {"left.command": on, "right.command": on}).simulate(3.0, 1e-3)
    assert recording["tank.pressure"][-1] == pytest.approx(7e5, rel=1e-3)
    changes = np.abs(np.diff(recording["or.position"] > 0.5)).sum()
    assert changes > 5
    assert sum(recording.statistics.values()) < 6000

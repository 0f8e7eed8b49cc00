"""Examples of `docs/logic_valves.md`: the values of its tables, and the steps of circuits at rest."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, DirectionalValve, Orifice, Reservoir, ShuttleValve, TwoPressureValve, load
from poppet.signals import Constant, Steps

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


def two_lines(kind: type) -> dict[str, Any]:
    """Two equal signal lines, and a tank at the outlet of a valve."""
    valve = {"supply": "supply", "exhaust": "ambient", "nominal_flow": "100 l/min ANR"}
    return {
        "supply": Reservoir(pressure="7 bar"),
        "left": DirectionalValve(outlet="left_line", **valve),
        "right": DirectionalValve(outlet="right_line", **valve),
        "left_line": Chamber(volume="5 cm^3"),
        "right_line": Chamber(volume="5 cm^3"),
        "logic": kind(a="left_line", b="right_line", outlet="tank", nominal_flow="300 l/min ANR"),
        "tank": Chamber(volume="0.5 l", wall_conductance=1.0),
    }


@pytest.mark.parametrize("kind", [ShuttleValve, TwoPressureValve])
def test_two_equal_signals_fill_and_vent_a_tank_without_chatter(kind):
    """A flow changes the pressures of the lines, so that the element moves; this must not close the outlet."""
    pulse = Steps([0.0, 0.1, 3.0], [0.0, 1.0, 0.0])
    both = Circuit(two_lines(kind), {"left.command": pulse, "right.command": pulse}).simulate(9.0, 1e-3)
    assert both["tank.pressure"][3000] == pytest.approx(7e5, rel=2e-3)
    assert both["tank.pressure"][-1] == pytest.approx(1e5, rel=2e-3)
    assert np.ptp(both["logic.position"]) > 0.3
    assert sum(both.statistics.values()) < 5000
    # It is at least as fast as a single path.
    single = {"left.command": pulse, "right.command": pulse if kind is TwoPressureValve else Constant(0.0)}
    path = Orifice(from_="left_line", to="tank", nominal_flow="300 l/min ANR")
    one = Circuit({**two_lines(kind), "logic": path}, single).simulate(9.0, 1e-3)
    for level, rises in ((4e5, True), (2e5, False)):
        times = []
        for recording in (both, one):
            crossed = recording["tank.pressure"] > level if rises else recording["tank.pressure"] < level
            times.append(recording.time[np.flatnonzero(crossed & ((recording.time > 3.0) != rises))[0]])
        assert times[0] < times[1] + 0.02, level

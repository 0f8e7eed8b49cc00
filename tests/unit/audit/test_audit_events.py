"""Signals with an event, volumes of tubes, and reasons for which a pressure stays."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from poppet import Chamber, Circuit, DirectionalValve, Orifice, Reservoir, load
from poppet.audit.events import EventSignal, event_signals, read_events, with_switches
from poppet.audit.safety import audit_safety
from poppet.audit.volumes import volumes_of
from poppet.signals import Points, Pwm, Sine

EXAMPLES = Path(__file__).parents[3] / "examples"
FLOW = {"sonic_conductance": "1 dm^3/(s bar)", "critical_ratio": 0.3}


@pytest.mark.parametrize(
    "signal", [Sine(1.0, 0.5, 3.0), Points([0.2, 0.9], [1.0, 4.0]), Pwm(10.0, 0.3)], ids=["sine", "ramp", "pwm"]
)
@pytest.mark.parametrize("time", [0.0, 0.5, 0.6001, 2.0])
def test_a_signal_until_the_event_and_the_value_afterwards(signal, time):
    changed = EventSignal(signal, time, 7.0)
    grid = np.linspace(0.0, 1.0, 1001)[:-1]
    expected = np.where(grid < time, signal.table(1.0).evaluate(grid), 7.0)
    assert changed.table(1.0).evaluate(grid) == pytest.approx(expected)
    table = changed.table(1.0)
    if 0.0 < time < 1.0:
        # The integrator restarts at the event.
        assert table.jump[table.start == time].tolist() == [True]
    assert changed.bounds() == (min(signal.bounds()[0], 7.0), 7.0)


def test_an_event_that_never_happens_changes_no_signal():
    circuit = load(EXAMPLES / "two_cylinders.toml")
    events = read_events(circuit, {"valveA.command": 1})
    switched = with_switches(circuit, events)
    healthy = circuit.simulate("1 s")
    idle = switched.with_signals(event_signals(switched, events, math.inf)).simulate("1 s")
    for address in ("slideA.position", "cylinderA.cap.pressure", "valveA.command"):
        assert idle[address] == pytest.approx(healthy[address], rel=1e-9, abs=1e-9)


def test_the_cells_of_a_tube_are_one_volume():
    volumes = volumes_of(load(EXAMPLES / "long_tube.toml"))
    assert volumes["hose"][:2] == ("hose.1.pressure", "hose.2.pressure")
    assert volumes["chamber"] == ("chamber.pressure",)
    assert not [name for name in volumes if name.startswith("hose.")]


def test_volumes_with_an_open_path_between_them_are_trapped_together():
    parts = {
        "supply": Reservoir(pressure="6 bar g"),
        "valve": DirectionalValve(supply="supply", outlet="first", command=1.0, initial_position=1.0, **FLOW),
        "first": Chamber(volume="1 l", initial_pressure="6 bar g"),
        "pipe": Orifice(from_="first", to="second", **FLOW),
        "second": Chamber(volume="1 l", initial_pressure="6 bar g"),
        "drain": DirectionalValve(supply="second", outlet="ambient", command=0.0, **FLOW),
    }
    circuit = Circuit(parts).with_values({"run.duration": "1 s"})
    events = {"valve.command": 0, "supply.pressure": "0 bar g"}
    row = audit_safety(circuit, events, at="0.5 s", kinds=()).exhaust_of("second")
    # The valve closes within milliseconds: some gas returns to the supply, and the volumes equalise.
    assert (row.reason, set(row.by)) == ("trapped", {"valve", "drain"})
    open_drain = audit_safety(circuit, {**events, "drain.command": 1}, at="0.5 s", kinds=())
    assert open_drain.exhaust_of("first").is_exhausted

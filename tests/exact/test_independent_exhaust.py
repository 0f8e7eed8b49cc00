"""Exhaust times and travel after an event against an independent simulation: vented supply, command without voltage."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

import poppet

sys.path.insert(0, str(Path(__file__).parent))
from independent_exhaust import (
    AMBIENT,
    THRESHOLD,
    Event,
    Fault,
    Run,
    simulate,
    small_circuit,
    small_circuit_text,
    two_cylinders,
)

MACHINE = Path(poppet.__file__).parent / "cli" / "templates" / "machine.toml"
FINE = "[run]\noutput_step = 1e-3\nrelative_tolerance = 1e-8\n"


def recorded_run(recording: poppet.Recording, run: Run) -> Run:
    """Return the volumes and pistons of an independent run from a recording with the same output times."""
    assert recording.time == pytest.approx(run.time, abs=1e-12)
    return Run(
        run.time,
        {name: recording[f"{name}.pressure"] for name in run.pressures},
        {name: recording[f"slide{name}.position"] for name in run.positions},
        {},
        (),
    )


def compare(found: Run, expected: Run, event: float) -> None:
    """Compare exhaust times within 0.5 % or 1 ms, and distances within 0.5 % or 20 um."""
    for volume in expected.pressures:
        time = expected.exhaust_time(volume, event)
        assert found.exhaust_time(volume, event) == pytest.approx(time, rel=5e-3, abs=1e-3), volume
    for drive in expected.positions:
        distances = expected.travel(drive, event)
        assert found.travel(drive, event) == pytest.approx(distances, rel=5e-3, abs=2e-5), drive


@pytest.mark.parametrize("event", [0.33, 0.6, 0.8])
def test_the_machine_after_its_supply_is_vented(event: float) -> None:
    expected = simulate(two_cylinders(), 3.2, Event(event, {}, {"supply": AMBIENT}))
    text = MACHINE.read_text().replace('output_step = "2 ms"', "output_step = 1e-3\nrelative_tolerance = 1e-8")
    text += f'[signals."supply.pressure"]\nkind = "steps"\ntimes = [0.0, {event}]\nvalues = [9e5, 1e5]\n'
    recording = poppet.loads(text).simulate()
    steps = recording["plc.step"]
    rows = np.flatnonzero(np.diff(steps, prepend=0.0))
    names = ["wait", "A+", "B+", "B-", "A-", "fault"]
    assert [names[round(steps[k]) - 1] for k in rows] == [name for _, name in expected.steps]
    assert recording.time[rows] == pytest.approx([time for time, _ in expected.steps], abs=5e-3 + 1e-9)
    compare(recorded_run(recording, expected), expected, event)


def test_the_small_circuit_without_voltage() -> None:
    machine = small_circuit()
    expected = simulate(machine, 3.0, Event(1.0, {"valve": (0.0,)}, {}))
    text = small_circuit_text(machine) + FINE
    text += '[signals."valve.command"]\nkind = "steps"\ntimes = [0.0, 1.0]\nvalues = [1, 0]\n'
    found = recorded_run(poppet.loads(text).simulate(3.0), expected)
    compare(found, expected, 1.0)
    assert 1.0 < expected.exhaust_time("cylinder.cap", 1.0) < 1.5
    assert expected.exhaust_time("tank", 1.0) == np.inf
    assert expected.travel("", 1.0)[1] == pytest.approx(-0.1, abs=1e-3)


def test_a_stuck_valve_keeps_the_pressure() -> None:
    machine = small_circuit()
    run = simulate(machine, 3.0, Event(1.0, {"valve": (0.0,)}, {}), Fault("valve", "stuck", 1.0))
    assert run.exhaust_time("cylinder.cap", 1.0) == np.inf
    assert run.pressures["cylinder.cap"][-1] > THRESHOLD
    assert run.travel("", 1.0)[0] < 1e-3

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
    """Compare exhaust times within 0.001 % or 1 us, and distances within 0.001 % or 1 um."""
    for volume in expected.pressures:
        time = expected.exhaust_time(volume, event)
        assert found.exhaust_time(volume, event) == pytest.approx(time, rel=1e-5, abs=1e-6), volume
    for drive in expected.positions:
        distances = expected.travel(drive, event)
        assert found.travel(drive, event) == pytest.approx(distances, rel=1e-5, abs=1e-6), drive


def fine_machine() -> str:
    """Return the text of the machine template with the output times and the tolerance of the independent runs."""
    return MACHINE.read_text().replace('output_step = "2 ms"', "output_step = 1e-3\nrelative_tolerance = 1e-8")


def compare_steps(recording: poppet.Recording, expected: Run) -> None:
    """Compare the steps, and the samples at which they begin."""
    steps = recording["plc.step"]
    rows = np.flatnonzero(np.diff(steps, prepend=0.0))
    names = ["wait", "A+", "B+", "B-", "A-", "fault"]
    assert [names[round(steps[k]) - 1] for k in rows] == [name for _, name in expected.steps]
    assert recording.time[rows] == pytest.approx([time for time, _ in expected.steps], abs=1e-9)


@pytest.mark.parametrize("event", [0.33, 0.6, 0.8])
def test_the_machine_after_its_supply_is_vented(event: float) -> None:
    expected = simulate(two_cylinders(), 3.2, Event(event, {}, {"supply": AMBIENT}))
    text = fine_machine()
    text += f'[signals."supply.pressure"]\nkind = "steps"\ntimes = [0.0, {event}]\nvalues = [9e5, 1e5]\n'
    recording = poppet.loads(text).simulate()
    compare_steps(recording, expected)
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


WORDS = ("stuck_open", "stuck_closed", "stuck", "slow", "leak")


@pytest.mark.parametrize("valve", ["valveA", "valveB", "regulator"])
@pytest.mark.parametrize("word", WORDS)
def test_each_fault_of_the_machine(valve: str, word: str) -> None:
    expected = simulate(two_cylinders(), 3.2, fault=Fault(valve, word, 0.3))
    fields = f'[parts.{valve}]\nfault = "{word}"\nfault_start = 0.3\n'
    recording = poppet.loads(fine_machine().replace(f"[parts.{valve}]\n", fields)).simulate()
    compare_steps(recording, expected)
    found = recorded_run(recording, expected)
    for name, position in expected.positions.items():
        assert np.max(np.abs(found.positions[name] - position)) < 1e-6
    for name, pressure in expected.pressures.items():
        assert np.max(np.abs(found.pressures[name] - pressure)) < 50.0


@pytest.mark.parametrize("word", WORDS)
def test_each_fault_of_the_small_circuit(word: str) -> None:
    machine = small_circuit()
    expected = simulate(machine, 3.0, Event(1.0, {"valve": (0.0,)}, {}), Fault("valve", word, 1.0))
    text = small_circuit_text(machine, f'fault = "{word}"\nfault_start = 1.0') + FINE
    text += '[signals."valve.command"]\nkind = "steps"\ntimes = [0.0, 1.0]\nvalues = [1, 0]\n'
    found = recorded_run(poppet.loads(text).simulate(3.0), expected)
    compare(found, expected, 1.0)
    is_kept = expected.exhaust_time("cylinder.cap", 1.0) == np.inf
    assert is_kept == (word in ("stuck_open", "stuck", "leak"))

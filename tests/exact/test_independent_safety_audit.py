"""Safety audits against independent simulations: exhaust times and travels, without a fault and with stuck valves."""

from __future__ import annotations

import math
import sys
from pathlib import Path

import pytest

import poppet
from poppet.audit.safety import audit_safety
from poppet.audit.safety_result import SafetyAudit

sys.path.insert(0, str(Path(__file__).parent))
from independent_exhaust import (
    AMBIENT,
    Event,
    Fault,
    Numbers,
    simulate,
    small_circuit,
    small_circuit_text,
    two_cylinders,
)

MACHINE = Path(poppet.__file__).parent / "cli" / "templates" / "machine.toml"
STOP = {"valveA.command": 0.0, "valveB.command_a": 0.0, "valveB.command_b": 0.0, "supply.pressure": "0 bar g"}
STUCK = ("stuck_open", "stuck_closed", "stuck")


def compare(audit: SafetyAudit, machine: Numbers, event: Event, duration: float, fault: Fault | None = None) -> None:
    """Compare all exhaust times and travels with those of an independent run, within 0.5 %."""
    run = simulate(machine, event.time + duration, event, fault, rows_per_ms=10)
    name = "" if fault is None else f"{fault.valve}.{fault.word}"
    for volume in run.pressures:
        expected = run.exhaust_time(volume, event.time)
        assert audit.exhaust_of(volume, name).time == pytest.approx(expected, rel=5e-3, abs=1e-6), (volume, name)
    for drive in run.positions:
        path, net = run.travel(drive, event.time)
        found = audit.travel_of(f"slide{drive}", name)
        assert found.path == pytest.approx(path, rel=5e-3, abs=1e-6), (drive, name)
        assert found.net == pytest.approx(net, rel=5e-3, abs=1e-6), (drive, name)


@pytest.mark.parametrize("moment", [0.33, 0.6, 0.8])
def test_emergency_stop_of_the_machine(moment: float) -> None:
    event = Event(moment, {"valveA": (0.0,), "valveB": (0.0, 0.0)}, {"supply": AMBIENT})
    audit = audit_safety(poppet.load(MACHINE), STOP, at=moment, duration=1.5, kinds=STUCK)
    compare(audit, two_cylinders(), event, 1.5)
    for valve in ("valveA", "valveB", "regulator"):
        for word in STUCK:
            compare(audit, two_cylinders(), event, 1.5, Fault(valve, word, moment))


def test_the_sequence_continues_if_only_the_supply_is_vented() -> None:
    event = Event(0.6, {}, {"supply": AMBIENT})
    audit = audit_safety(poppet.load(MACHINE), {"supply.pressure": "0 bar g"}, at="600 ms", duration=3.0, kinds=STUCK)
    compare(audit, two_cylinders(), event, 3.0)
    compare(audit, two_cylinders(), event, 3.0, Fault("valveB", "stuck", 0.6))


@pytest.mark.parametrize("threshold", [0.5e5, 2e5])
def test_the_small_circuit(threshold: float) -> None:
    machine = small_circuit()
    circuit = poppet.loads(small_circuit_text(machine))
    audit = audit_safety(circuit, {"valve.command": 0.0}, at=1.0, threshold=threshold, duration=2.0, kinds=STUCK)
    for fault in (None, *(Fault("valve", word, 1.0) for word in STUCK)):
        run = simulate(machine, 3.0, Event(1.0, {"valve": (0.0,)}, {}), fault)
        name = "" if fault is None else f"valve.{fault.word}"
        for volume in run.pressures:
            expected = run.exhaust_time(volume, 1.0, AMBIENT + threshold)
            assert audit.exhaust_of(volume, name).time == pytest.approx(expected, rel=5e-3, abs=1e-6)
        assert audit.travel_of("slide", name).path == pytest.approx(run.travel("", 1.0)[0], rel=5e-3, abs=1e-6)
    # The tank has no other exhaust, and a stuck valve keeps the cylinder filled.
    assert math.isinf(audit.exhaust_of("tank").time)
    assert math.isinf(audit.exhaust_of("cylinder.cap", "valve.stuck").time)
    assert math.isfinite(audit.exhaust_of("cylinder.cap").time)

"""Safety audit of the template machine against an independent simulation of the machine."""

from __future__ import annotations

import math
import sys
from functools import cache
from pathlib import Path

import pytest

import poppet
from poppet.audit.safety import audit_safety
from poppet.audit.safety_result import SafetyAudit

sys.path.insert(0, str(Path(__file__).parent))
from independent_exhaust import AMBIENT, Event, Fault, simulate, small_circuit, small_circuit_text, two_cylinders

MACHINE = Path(poppet.__file__).parent / "cli" / "templates" / "machine.toml"


@cache
def machine_audit(event: float) -> SafetyAudit:
    return audit_safety(poppet.load(MACHINE), {"supply.pressure": "0 bar g"}, at=event, duration=2.0)


@pytest.mark.parametrize(
    ("event", "fault"), [(0.33, ""), (0.6, ""), (0.6, "valveB.stuck_closed"), (0.8, "valveA.stuck_open")]
)
def test_the_machine_after_its_supply_is_vented(event: float, fault: str) -> None:
    valve, _, word = fault.partition(".")
    failure = Fault(valve, word, event) if fault else None
    expected = simulate(two_cylinders(), event + 2.0, Event(event, {}, {"supply": AMBIENT}), failure)
    audit = machine_audit(event)
    for volume in expected.pressures:
        time = expected.exhaust_time(volume, event)
        assert audit.exhaust_of(volume, fault).time == pytest.approx(time, rel=1e-4, abs=1e-6), volume
    for drive in expected.positions:
        path, net = expected.travel(drive, event)
        travel = audit.travel_of(f"slide{drive}", fault)
        assert travel.net == pytest.approx(net, rel=1e-4, abs=1e-7), drive
        # The independent path is a sum over samples of 1 ms, which cuts the turns.
        assert path * (1.0 - 1e-4) <= travel.path < path * 1.005 + 1e-6, drive


def test_a_stuck_valve_traps_the_air_of_the_small_circuit() -> None:
    machine = small_circuit()
    circuit = poppet.loads(small_circuit_text(machine) + "[run]\nduration = 2.0\n")
    audit = audit_safety(circuit, {"valve.command": 0}, at=1.0, duration=2.0)
    for fault in ("", "valve.stuck"):
        failure = Fault("valve", "stuck", 1.0) if fault else None
        expected = simulate(machine, 3.0, Event(1.0, {"valve": (0.0,)}, {}), failure)
        for volume in expected.pressures:
            time = expected.exhaust_time(volume, 1.0)
            assert audit.exhaust_of(volume, fault).time == pytest.approx(time, rel=2e-4, abs=1e-6), (volume, fault)
    assert audit.exhaust_of("tank").reason == "trapped"
    assert audit.exhaust_of("cylinder.cap", "valve.stuck").time == math.inf

"""Findings that depend on a parameter are replaced if the data do not determine it."""

from __future__ import annotations

from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.core.codes import Note
from poppet.identify import FlowPoints, Result, TankTest, identify_flow, identify_tank
from poppet.identify.result import Estimate, Verdict, replace_uncertain_findings
from poppet.laws.iso6358 import mass_flow_rate


def codes(result: Result) -> set[str]:
    return {note.code for note in result.remarks}


@pytest.mark.parametrize(
    ("verdict", "expected"),
    [
        ("determined", ["finding.choking.never", "flow.unusual_conductance", "finding.sampled"]),
        ("weak", ["finding.choking.perhaps_never", "finding.sampled"]),
        ("not determined", ["finding.choking.perhaps_never", "finding.sampled"]),
        ("at bound", ["finding.choking.perhaps_never", "finding.sampled"]),
    ],
)
def test_finding_depends_on_the_verdict_on_its_parameter(verdict: Verdict, expected: list[str]) -> None:
    b = {"number": "v.critical_ratio", "value": 0.1, "low": 0.0, "high": 1.0}
    notes = [
        Note("finding.choking.never", "v", **b),
        Note("flow.unusual_conductance", "sonic_conductance", value=1.0),
        Note("finding.sampled", recordings=("a",)),
    ]
    estimates = {name: Estimate(0.1, "1", 0.1, 0.0, 1.0, verdict) for name in ("v.critical_ratio", "sonic_conductance")}
    replaced = replace_uncertain_findings(notes, estimates)
    assert [note.code for note in replaced] == expected
    assert all(str(note) for note in replaced)


def make_subsonic_test(noise: float, seed: int = 1) -> TankTest:
    """Return a discharge test from 1.5 bar, whose flow is never choked at b = 0.3."""
    parts = {
        "tank": Chamber(volume="20 l", initial_pressure="1.5 bar", wall_conductance=5.0),
        "valve": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3),
    }
    run = Circuit(parts).simulate("15 s", "0.05 s")
    pressure = run["tank.pressure"] + np.random.default_rng(seed).normal(0.0, noise, run.time.size)
    return TankTest(recordings={"a": {"time": run.time, "tank.pressure": pressure}}, volume="20 l")


def test_missing_choked_flow_is_uncertain_if_the_critical_ratio_is_not_determined() -> None:
    precise = identify_tank(make_subsonic_test(2.0))
    assert precise.parameters["valve.critical_ratio"].verdict == "determined"
    assert "finding.choking.never" in codes(precise)
    noisy = identify_tank(make_subsonic_test(1000.0))
    assert noisy.parameters["valve.critical_ratio"].verdict != "determined"
    assert "finding.choking.never" not in codes(noisy)


def test_missing_choked_point_is_uncertain_if_the_critical_ratio_is_not_determined() -> None:
    ratio = np.linspace(0.6, 0.95, 8)
    flow = mass_flow_rate(7e5, 7e5 * ratio, 293.15, sonic_conductance=2e-8, critical_ratio=0.3)
    scattered = flow * (1.0 + np.random.default_rng(3).normal(0.0, 0.02, ratio.size))
    exact, open_ = (identify_flow(FlowPoints(q, 7e5, 7e5 * ratio, 293.15)) for q in (flow, scattered))
    assert open_.parameters["critical_ratio"].verdict != "determined"
    assert "flow.none_choked" in codes(exact)
    assert "flow.none_choked" not in codes(open_)


def make_charge_test(**arguments: Any) -> TankTest:
    """Return a charge test of a tank evacuated to 0.1 bar; its noise hides the critical ratio."""
    parts = {
        "supply": Reservoir(pressure="1 bar"),
        "tank": Chamber(volume="20 l", initial_pressure="0.1 bar", wall_conductance=5.0),
        "valve": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
    }
    run = Circuit(parts).simulate("15 s", "0.1 s")
    pressure = run["tank.pressure"] + np.random.default_rng(1).normal(0.0, 3e3, run.time.size)
    recordings = {"a": {"time": run.time, "tank.pressure": pressure}}
    return TankTest(recordings=recordings, volume="20 l", direction="charge", supply_pressure="1 bar", **arguments)


def test_evacuated_tank_gives_no_finding_on_gauge_pressure() -> None:
    result = identify_tank(make_charge_test())
    assert result.parameters["valve.critical_ratio"].verdict != "determined"
    assert not {"finding.gauge", "suspicion.read_as_absolute"} & codes(result)

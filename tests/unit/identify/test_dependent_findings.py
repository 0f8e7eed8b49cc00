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
    ("verdict", "said"),
    [
        ("determined", ["finding.choking.never", "flow.unusual_conductance", "finding.sampled"]),
        ("weak", ["finding.choking.perhaps_never", "finding.sampled"]),
        ("not determined", ["finding.choking.perhaps_never", "finding.sampled"]),
        ("at bound", ["finding.choking.perhaps_never", "finding.sampled"]),
    ],
)
def test_a_finding_depends_on_its_parameter(verdict: Verdict, said: list[str]) -> None:
    b = {"number": "v.critical_ratio", "value": 0.1, "low": 0.0, "high": 1.0}
    notes = [
        Note("finding.choking.never", "v", **b),
        Note("flow.unusual_conductance", "sonic_conductance", value=1.0),
        Note("finding.sampled", recordings=("a",)),
    ]
    numbers = {name: Estimate(0.1, "1", 0.1, 0.0, 1.0, verdict) for name in ("v.critical_ratio", "sonic_conductance")}
    left = replace_uncertain_findings(notes, numbers)
    assert [note.code for note in left] == said
    assert all(str(note) for note in left)


def subsonic(noise: float, seed: int = 1) -> TankTest:
    """A discharge from 1.5 bar, which never chokes b = 0.3."""
    parts = {
        "tank": Chamber(volume="20 l", initial_pressure="1.5 bar", wall_conductance=5.0),
        "valve": Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3),
    }
    run = Circuit(parts).simulate("15 s", "0.05 s")
    pressure = run["tank.pressure"] + np.random.default_rng(seed).normal(0.0, noise, run.time.size)
    return TankTest(recordings={"a": {"time": run.time, "tank.pressure": pressure}}, volume="20 l")


def test_whether_a_passage_was_choked_is_asked_where_its_ratio_is_open() -> None:
    known = identify_tank(subsonic(2.0))
    assert known.parameters["valve.critical_ratio"].verdict == "determined"
    assert "finding.choking.never" in codes(known)
    unknown = identify_tank(subsonic(1000.0))
    assert unknown.parameters["valve.critical_ratio"].verdict != "determined"
    assert "finding.choking.never" not in codes(unknown)


def test_no_choked_point_is_a_perhaps_where_the_ratio_is_open() -> None:
    ratio = np.linspace(0.6, 0.95, 8)
    flow = mass_flow_rate(7e5, 7e5 * ratio, 293.15, sonic_conductance=2e-8, critical_ratio=0.3)
    scattered = flow * (1.0 + np.random.default_rng(3).normal(0.0, 0.02, ratio.size))
    exact, open_ = (identify_flow(FlowPoints(q, 7e5, 7e5 * ratio, 293.15)) for q in (flow, scattered))
    assert open_.parameters["critical_ratio"].verdict != "determined"
    assert "flow.none_choked" in codes(exact)
    assert "flow.none_choked" not in codes(open_)


def emptied(**more: Any) -> TankTest:
    """A tank that was evacuated to 0.1 bar fills from the room, too noisy for its critical ratio."""
    parts = {
        "supply": Reservoir(pressure="1 bar"),
        "tank": Chamber(volume="20 l", initial_pressure="0.1 bar", wall_conductance=5.0),
        "valve": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
    }
    run = Circuit(parts).simulate("15 s", "0.1 s")
    pressure = run["tank.pressure"] + np.random.default_rng(1).normal(0.0, 3e3, run.time.size)
    recordings = {"a": {"time": run.time, "tank.pressure": pressure}}
    return TankTest(recordings=recordings, volume="20 l", direction="charge", supply_pressure="1 bar", **more)


def test_an_evacuated_tank_is_not_taken_for_a_gauge() -> None:
    result = identify_tank(emptied())
    assert result.parameters["valve.critical_ratio"].verdict != "determined"
    assert not {"finding.gauge", "suspicion.read_as_absolute"} & codes(result)

"""Findings of tank tests: units of time, and advice that does not contradict itself."""

from __future__ import annotations

from functools import cache
from typing import Any

import numpy as np
import pytest

from exact.independent_tanks import AIR, ROOM, Tank, recorded
from poppet.identify import Result, TankTest, identify_tank
from poppet.report.identification.headline import next_step

CHARGE = Tank(True, 0.0235, 6.3e-8, 0.385, 200.0, 1e5, 7.85e5, 8.7, 13.4, noise=87.0)


@cache
def identify_charge(
    time_factor: float = 1.0, closes: float = CHARGE.closes, lag: float = 0.0, **changes: Any
) -> Result:
    record = recorded(CHARGE, 1)
    time, pressure = record["time"], record["pressure"].copy()
    if lag:
        weight = np.exp(-time[1] / lag)
        for k in range(1, pressure.size):
            pressure[k] = weight * pressure[k - 1] + (1.0 - weight) * pressure[k]
    recording = {"time": time_factor * time, "tank.pressure": pressure, "closes": closes}
    conditions = {"ambient_pressure": AIR, "ambient_temperature": ROOM, "supply_pressure": CHARGE.outside}
    return identify_tank(
        TankTest(recordings={"test": recording}, volume=CHARGE.volume, direction="charge", **conditions, **changes)
    )


def codes(result: Result) -> list[str]:
    return [note.code for note in result.remarks]


def test_milliseconds_are_suspected_in_all_times() -> None:
    result = identify_charge(1e3, 1e3 * CHARGE.closes)
    assert "finding.unusual.time" in codes(result)
    assert "seconds or milliseconds" in next_step(result)
    assert "finding.unusual.time" not in codes(identify_charge())


def test_milliseconds_are_suspected_if_only_closing_is_in_seconds() -> None:
    result = identify_charge(1e3)
    assert codes(result)[0] == "finding.unusual.closes"
    assert "seconds or milliseconds" in next_step(result)
    # A lag or a leak would imitate the wrong time.
    assert not [code for code in codes(result) if code.startswith("finding.other_model")]


@pytest.mark.parametrize("lag", [0.1, 0.3])
def test_advice_on_models_does_not_contradict_itself(lag: float) -> None:
    result = identify_charge(lag=lag)
    about_models = [code for code in codes(result) if code.startswith(("finding.other_model", "finding.wall"))]
    assert about_models == ["finding.other_model.clear"]
    (note,) = (note for note in result.remarks if note.code == "finding.other_model.clear")
    assert note.facts["models"] == ("pressure_lag",)


def test_notes_on_parameters_agree_with_their_intervals() -> None:
    """Equivalent models widen intervals after the fit."""
    result = identify_charge(lag=0.3)
    for note in result.remarks:
        if note.code.startswith("finding.number."):
            estimate = result.parameters[note.address]
            assert (note.facts["low"], note.facts["high"]) == (estimate.low, estimate.high)
            assert note.code.rpartition(".")[2] == estimate.verdict.replace(" ", "_")


def test_findings_appear_once() -> None:
    for result in (identify_charge(), identify_charge(lag=0.3), identify_charge(1e3)):
        assert len(set(result.findings)) == len(result.findings)

"""Numbers that leave a run as it is when they move together, or when two parts exchange theirs."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.identify import Result, TankTest, identify_tank
from poppet.identify.fit.fit_plan import plan_fit
from poppet.identify.fit.identify_fit import identify_fit
from poppet.identify.fit.search import SearchSettings
from poppet.identify.free_parameter import read_free
from poppet.timeseries.measurements import Channel, Measurement

SCALED = {"valve.sonic_conductance", "tank.volume", "tank.wall_conductance"}
SMALL = {"one.sonic_conductance": 4e-9, "one.critical_ratio": 0.1}
LARGE = {"other.sonic_conductance": 8e-9, "other.critical_ratio": 0.6}


@pytest.mark.parametrize("noise", [0.01, 500.0])
def test_conductance_volume_and_wall_scaled_together_are_not_determined(noise: float) -> None:
    """However precise the gauge: with 0.01 Pa the slopes are inexact by more than the noise."""
    tank = Chamber(volume="20 l", initial_pressure="7 bar", wall_conductance=6.0)
    valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.35, laminar_ratio=0.99999)
    run = Circuit({"tank": tank, "valve": valve}).simulate(60.0, 0.1, 1e-9)
    pressure = run["tank.pressure"] + np.random.default_rng(1).normal(0.0, noise, run.time.size)
    recording = {"time": run.time, "tank.pressure": pressure}
    result = identify_tank(TankTest(recordings={"a": recording}, volume={"start": "15 l"}))
    assert {name for name, e in result.parameters.items() if e.verdict == "not determined"} == SCALED
    assert result.parameters["valve.critical_ratio"].value == pytest.approx(0.35, abs=0.01)
    (note,) = (note for note in result.remarks if note.code == "finding.alike.scaled")
    assert set(note.facts["names"]) == SCALED
    first, *others = note.facts["shares"].values()
    assert others == pytest.approx([first, first], rel=1e-3)


def side_by_side(free: dict[str, float], **fixed: float) -> Result:
    """Two orifices side by side fill a tank; noise of 20 Pa."""
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "one": Orifice(from_="supply", to="tank", sonic_conductance=4e-9, critical_ratio=0.1),
        "other": Orifice(from_="supply", to="tank", sonic_conductance=8e-9, critical_ratio=0.6),
        "tank": Chamber(volume="5 l", initial_pressure="1 bar", thermal="isothermal"),
    }
    circuit = Circuit(parts).with_values(fixed)
    run = circuit.simulate(12.0, 0.02)
    pressure = run["tank.pressure"] + np.random.default_rng(1).normal(0.0, 20.0, run.time.size)
    measurement = Measurement("a", (Channel("tank.pressure", run.time, pressure, "Pa"),), duration=12.0)
    numbers = tuple(replace(read_free(name, {}, circuit), start=start) for name, start in free.items())
    plan = plan_fit([circuit], [measurement], ["fit"], numbers, settings=SearchSettings(), title="side by side")
    return identify_fit(plan)


def test_parts_that_may_be_exchanged_are_not_determined() -> None:
    truth = SMALL | LARGE
    result = side_by_side({name: value * 1.1 for name, value in truth.items()})
    assert len(result.optima) == 2
    for local in ("sonic_conductance", "critical_ratio"):
        for part in ("one", "other"):
            found = result.parameters[f"{part}.{local}"]
            assert found.verdict in ("weak", "not determined")
            assert found.low <= truth[f"one.{local}"] < truth[f"other.{local}"] <= found.high
    (note,) = (note for note in result.remarks if note.code == "finding.optima.other")
    assert set(note.facts["numbers"]) == set(truth)


def test_conductances_side_by_side_with_one_ratio_trade() -> None:
    free = {"one.sonic_conductance": 5e-9, "other.sonic_conductance": 7e-9}
    result = side_by_side(free, **{"one.critical_ratio": 0.3, "other.critical_ratio": 0.3})
    assert {e.verdict for e in result.parameters.values()} == {"not determined"}
    (note,) = (note for note in result.remarks if note.code == "finding.alike.changed")
    one, other = (result.parameters[name].value for name in free)
    # C1 + C2 stays: dC1 = -dC2.
    shares = note.facts["shares"]
    assert shares["one.sonic_conductance"] * one == pytest.approx(-shares["other.sonic_conductance"] * other, rel=1e-3)

"""Parameters that compensate each other, or that two parts can exchange."""

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
def test_conductance_volume_and_wall_conductance_are_not_determined_together(noise: float) -> None:
    """The result does not depend on the noise: at 0.01 Pa, the derivatives are less accurate than the sensor."""
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


def fit_parallel_orifices(free: dict[str, float], **fixed: float) -> Result:
    """Return a fit of a tank that two parallel orifices fill, with a noise of 20 Pa."""
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
    parameters = tuple(replace(read_free(name, {}, circuit), start=start) for name, start in free.items())
    plan = plan_fit([circuit], [measurement], ["fit"], parameters, settings=SearchSettings(), title="side by side")
    return identify_fit(plan)


def test_parameters_of_exchangeable_parts_are_not_determined() -> None:
    truth = SMALL | LARGE
    result = fit_parallel_orifices({name: value * 1.1 for name, value in truth.items()})
    assert len(result.optima) == 2
    for local in ("sonic_conductance", "critical_ratio"):
        for part in ("one", "other"):
            estimate = result.parameters[f"{part}.{local}"]
            assert estimate.verdict in ("weak", "not determined")
            assert estimate.low <= truth[f"one.{local}"] < truth[f"other.{local}"] <= estimate.high
    (note,) = (note for note in result.remarks if note.code == "finding.optima.other")
    assert set(note.facts["numbers"]) == set(truth)


def test_parallel_conductances_with_equal_critical_ratio_compensate_each_other() -> None:
    free = {"one.sonic_conductance": 5e-9, "other.sonic_conductance": 7e-9}
    result = fit_parallel_orifices(free, **{"one.critical_ratio": 0.3, "other.critical_ratio": 0.3})
    assert {e.verdict for e in result.parameters.values()} == {"not determined"}
    (note,) = (note for note in result.remarks if note.code == "finding.alike.changed")
    one, other = (result.parameters[name].value for name in free)
    # The sum C1 + C2 is constant: dC1 = -dC2.
    shares = note.facts["shares"]
    assert shares["one.sonic_conductance"] * one == pytest.approx(-shares["other.sonic_conductance"] * other, rel=1e-3)

"""Commissioning on recordings of an independent tank: healthy values, lack of fit, and recordings that are rejected."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

import poppet
from exact.independent_watch_tank import (
    CIRCUIT,
    HEALTHY,
    MODEL_ERRORS,
    ONE_PERCENT,
    Sensors,
    Tank,
    random_openings,
    readings,
    simulate,
    stepped_leak,
)
from poppet.core.errors import InputError
from poppet.monitoring.commissioning import commission
from poppet.monitoring.plan import WatchPlan, read_plan
from poppet.monitoring.window_model import Samples
from poppet.monitoring.windows import Window

MINUTES = 1801
"""Samples of three minutes at 10 Hz."""


def plan_of(**changes: Mapping[str, Any]) -> WatchPlan:
    tables: dict[str, Any] = {
        "measured": {"tank.pressure": {"noise": 500.0}, "valve.opening": {}, "use.opening": {}},
        "faults": {"leak": {"address": "leak.sonic_conductance", "alarm": ONE_PERCENT, "direction": "up"}},
        "nuisances": {
            "valve.sonic_conductance": {"relative_sigma": 0.05},
            "use.sonic_conductance": {"relative_sigma": 0.05},
            "tank.wall_conductance": {"relative_sigma": 0.3},
            "supply.pressure": {"sigma": "10 kPa"},
            "supply.temperature": {"sigma": "10 K"},
        },
        "settings": {"window": "60 s"},
    }
    return read_plan(poppet.loads(CIRCUIT), **(tables | changes))


def record(
    tank: Tank = HEALTHY, *, leak: np.ndarray | None = None, sensors: Sensors | None = None, samples: int = MINUTES
) -> Samples:
    openings = random_openings(range(1), samples)
    course = simulate(tank, openings, leak)
    return Samples(course.time, readings(tank, course, sensors or Sensors(), range(1))[0], openings[0])


def codes(error: pytest.ExceptionInfo[InputError]) -> list[str]:
    return [problem.code for problem in error.value.problems]


def test_a_healthy_plant_is_found() -> None:
    plan = plan_of()
    baseline = commission(plan, record(), recording="healthy.csv")
    assert np.all(np.abs(baseline.values - plan.reference) < 4.0 * baseline.sigmas)
    assert baseline.sigmas[0] < 0.2 * ONE_PERCENT
    assert 0.9 < baseline.misfit[0].ratio < 1.1
    assert baseline.misfit[0].correlation_time < 1.5
    assert baseline.duration == pytest.approx(180.0)
    assert baseline.readings == MINUTES - 1
    assert baseline.recording == "healthy.csv"
    assert baseline.remarks == ()
    assert baseline.temper == 1.0
    assert baseline.healthy_nis == pytest.approx(1.0, abs=0.1)


@pytest.mark.parametrize("name", ["supply gas +15 K", "wall conductance twice", "valve C -5 %", "supply -10 kPa"])
def test_a_plant_that_differs_from_its_circuit_has_no_leak(name: str) -> None:
    """The nuisances absorb the difference; their values are those of the plant."""
    plan, tank = plan_of(), MODEL_ERRORS[name]
    baseline = commission(plan, record(tank))
    assert abs(baseline.values[0] - HEALTHY.leak) < 4.0 * baseline.sigmas[0]
    truth = [tank.valve, tank.use, tank.wall_conductance, tank.supply_pressure, tank.supply_temperature]
    assert np.all(np.abs(baseline.values[1:] - truth) < 4.0 * baseline.sigmas[1:])


def test_a_leak_in_the_healthy_recording_is_reported() -> None:
    baseline = commission(plan_of(), record(replace(HEALTHY, leak=HEALTHY.leak + 3.0 * ONE_PERCENT)))
    note = next(remark for remark in baseline.remarks if remark.code == "baseline.contains")
    assert note.address == "leak.sonic_conductance"
    assert note.facts["sizes"] == pytest.approx(3.0, abs=0.3)


def test_a_leak_that_grows_is_no_baseline() -> None:
    growing = stepped_leak(HEALTHY.leak, HEALTHY.leak + ONE_PERCENT, 90.0, 1, MINUTES)
    with pytest.raises(InputError) as error:
        commission(plan_of(), record(leak=growing))
    assert codes(error) == ["baseline.changed"]
    facts = error.value.problems[0].facts
    assert facts["second"] - facts["first"] == pytest.approx(ONE_PERCENT, rel=0.3)


def test_a_leak_near_the_end_is_reported() -> None:
    """It changes the mean of the second half by less than the limit, but the filter sees it."""
    growing = stepped_leak(HEALTHY.leak, HEALTHY.leak + 1.5 * ONE_PERCENT, 168.0, 1, MINUTES)
    baseline = commission(plan_of(), record(leak=growing))
    note = next(remark for remark in baseline.remarks if remark.code == "baseline.step")
    assert note.facts["name"] == "leak"
    assert 168.0 < note.facts["time"] <= 180.0
    assert "alarm" in str(note)


def test_a_wrong_model_without_nuisances_has_a_lack_of_fit() -> None:
    """With a wrong volume and all conductances fixed, the residuals are correlated, and increase the noise."""
    plan = plan_of(nuisances={})
    baseline = commission(plan, record(MODEL_ERRORS["volume +3 %"]))
    assert baseline.misfit[0].factor > 2.0
    assert baseline.noise[0] == pytest.approx(500.0 * baseline.misfit[0].factor)
    assert "baseline.misfit" in [remark.code for remark in baseline.remarks]


def test_outliers_and_missing_readings_are_tolerated() -> None:
    plan = plan_of()
    baseline = commission(plan, record(sensors=Sensors(outliers=0.02, missing=0.3)))
    assert np.all(np.abs(baseline.values - plan.reference) < 4.0 * baseline.sigmas)
    (note,) = baseline.remarks
    assert note.code == "baseline.outliers"
    assert note.facts["fraction"] == pytest.approx(0.02, abs=0.01)
    assert "tank.pressure" in str(note)


def test_a_nuisance_that_changes_needs_a_drift() -> None:
    """The supply pressure rises by 5 kPa in the middle; without a drift, it is a constant."""
    first, second = record(), record(replace(HEALTHY, supply_pressure=HEALTHY.supply_pressure + 5e3))
    half = MINUTES // 2
    samples = first._replace(readings=np.concatenate([first.readings[:half], second.readings[half:]]))
    drifting = {"sigma": "10 kPa", "drift": "5 kPa"}
    nuisances = {"valve.sonic_conductance": {"relative_sigma": 0.05}}
    drifted = []
    for supply in ({"sigma": "10 kPa"}, drifting):
        plan = plan_of(nuisances={**nuisances, "supply.pressure": supply})
        remarks = commission(plan, samples).remarks
        drifted.append([str(note) for note in remarks if note.code == "baseline.drifted"])
    assert any("supply.pressure" in text for text in drifted[0])
    assert not any("supply.pressure" in text for text in drifted[1])


def test_a_circuit_that_cannot_be_simulated_is_reported(monkeypatch: pytest.MonkeyPatch) -> None:
    fit = Window.fit
    monkeypatch.setattr(Window, "fit", lambda *arguments: replace(fit(*arguments), is_complete=False))
    with pytest.raises(InputError) as error:
        commission(plan_of(), record())
    assert codes(error) == ["baseline.no_run"]
    assert error.value.facts["end"] == pytest.approx(90.0)


def test_a_quiet_plant_gives_no_information() -> None:
    """The valve is closed, so its conductance has no effect."""
    samples = record()
    samples = samples._replace(inputs=np.zeros_like(samples.inputs))
    generator = np.random.default_rng(3)
    course = simulate(replace(HEALTHY, leak=0.0), np.zeros((1, MINUTES, 2)))
    samples = samples._replace(readings=course.pressure.T + generator.normal(0.0, 500.0, (MINUTES, 1)))
    plan = plan_of(
        faults={"valve": {"address": "valve.sonic_conductance", "alarm": ONE_PERCENT}},
        nuisances={"leak.sonic_conductance": {"sigma": ONE_PERCENT}},
    )
    with pytest.raises(InputError) as error:
        commission(plan, samples)
    assert codes(error) == ["baseline.no_information"]
    assert error.value.facts["names"] == ["valve"]


def test_an_unknown_fault_number_is_reported() -> None:
    """The valve is open for one second only: its conductance is known, but not within a tenth of an alarm size."""
    openings = np.zeros((1, MINUTES, 2))
    openings[:, 100:110, 0] = 0.1
    course = simulate(HEALTHY, openings)
    values = readings(HEALTHY, course, Sensors(), range(1))[0]
    faults = {"valve": {"address": "valve.sonic_conductance", "alarm": "1e-10 m^3/(s Pa)"}}
    baseline = commission(plan_of(faults=faults, nuisances={}), Samples(course.time, values, openings[0]))
    note = next(remark for remark in baseline.remarks if remark.code == "baseline.undetermined")
    assert note.facts["name"] == "valve"


def test_short_recordings_and_empty_columns_are_rejected_together() -> None:
    samples = record(samples=100)
    with pytest.raises(InputError) as error:
        commission(plan_of(), samples._replace(readings=np.full_like(samples.readings, np.nan)))
    assert codes(error) == ["baseline.short", "baseline.few_readings"]


def test_an_empty_recording_is_too_short() -> None:
    empty = Samples(np.zeros(0), np.zeros((0, 1)), np.zeros((0, 2)))
    with pytest.raises(InputError) as error:
        commission(plan_of(), empty)
    assert codes(error) == ["baseline.short", "baseline.few_readings"]


def test_gauge_readings_that_are_declared_as_absolute_are_named() -> None:
    plan = plan_of(
        faults={"supply_low": {"address": "supply.pressure", "alarm": "3 bar", "direction": "down"}},
        nuisances={
            "valve.sonic_conductance": {"relative_sigma": 0.2},
            "use.sonic_conductance": {"relative_sigma": 0.2},
        },
    )
    baseline = commission(plan, record(sensors=Sensors(is_gauge=True)))
    (remark,) = (remark for remark in baseline.remarks if remark.code == "baseline.gauge")
    assert (remark.address, remark.facts["sensors"]) == ("supply_low", ["tank.pressure"])

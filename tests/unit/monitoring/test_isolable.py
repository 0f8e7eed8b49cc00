"""Predicted isolability of faults: closed forms, symmetries, invisible faults, additional sensors."""

from __future__ import annotations

import math
import tomllib
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import load, loads
from poppet.monitoring.fault_statistics import SCATTER
from poppet.monitoring.isolable import Isolability, isolable
from poppet.monitoring.plan import WatchPlan, read_plan
from watched_tank import TABLES, TANK

SECOND_LEAK = """
[parts.second]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = 0.0
critical_ratio = 0.3
"""
MOVING = """
[signals."consumer.opening"]
kind = "steps"
times = ["0 s", "5 s", "12 s"]
values = [0.2, 1.0, 0.0]
[run]
duration = "20 s"
output_step = "0.1 s"
"""
LEAK = {"address": "leak.sonic_conductance", "alarm": "1e-9 m^3/(s Pa)", "direction": "up"}
SECOND = {**LEAK, "address": "second.sonic_conductance"}


def plan(text: str = TANK + MOVING, **tables: Any) -> WatchPlan:
    return read_plan(loads(text), **{**TABLES, "nuisances": {}, **tables})


def test_deviation_of_a_leak_agrees_with_the_closed_form() -> None:
    """Choked isothermal discharge with a free start: the pressure is p0 exp(-k C t)."""
    discharge = """
    [parts.tank]
    kind = "chamber"
    volume = "10 l"
    thermal = "isothermal"
    initial_pressure = "16 bar"
    [parts.outlet]
    kind = "orifice"
    from = "tank"
    to = "ambient"
    sonic_conductance = "1e-8 m^3/(s Pa)"
    critical_ratio = 0.3
    [run]
    duration = "10 s"
    output_step = "0.1 s"
    """
    faults = {"outlet": {"address": "outlet.sonic_conductance", "alarm": "1e-10 m^3/(s Pa)"}}
    result = isolable(plan(discharge, measured={"tank.pressure": {"noise": "300 Pa"}}, faults=faults))
    time = 0.1 * np.arange(101)
    rate = 1.185 * 287.05 * 293.15 / 10e-3  # of ln p, over -C
    pressure = 16e5 * np.exp(-rate * 1e-8 * time)
    effect, start = -rate * time * pressure / 300.0, pressure / 300.0
    information = effect @ effect - (effect @ start) ** 2 / (start @ start)
    # Forward differences of 0.1 % of the alarm size.
    expected = math.hypot(information**-0.5, SCATTER * 1e-10)
    assert result.faults["outlet"].sd_alone == pytest.approx(expected, rel=1e-3)
    assert result.faults["outlet"].sd_free == pytest.approx(expected, rel=1e-3)
    assert result.signatures["outlet"][0] == pytest.approx(300.0 * effect * 1e-10, rel=1e-3)
    assert (result.samples, result.duration) == (101, 10.0)


def test_two_equal_leaks_in_parallel_cannot_be_told_apart() -> None:
    faults = {"leak": LEAK, "second": SECOND, "supply_low": TABLES["faults"]["supply_low"]}
    result = isolable(plan(TANK + SECOND_LEAK + MOVING, faults=faults))
    leak = result.faults["leak"]
    assert leak.is_visible
    assert not leak.is_isolable
    assert leak.confused_with == ("second",)
    assert leak.angle == 0.0
    assert math.isinf(leak.sd_free)
    assert math.isfinite(result.faults["supply_low"].sd_free)
    sensor = leak.separating["second"]
    # A pressure gauge cannot separate them, because both leaks see the same pressures.
    assert sensor is not None
    assert sensor.word == "flow meter"
    assert sensor.address in ("leak.mass_flow_rate", "second.mass_flow_rate")
    assert leak.note.code == "watch.isolable_with"
    assert (
        str(leak.note) == f"leak cannot be told apart from second; a flow meter at {sensor.address} would separate it."
    )


def test_no_sensor_separates_the_factors_of_a_product() -> None:
    faults = {
        "worn": {"address": "valve.sonic_conductance", "alarm": "1e-9 m^3/(s Pa)", "direction": "down"},
        "stuck": {"address": "valve.opening", "alarm": 0.1, "direction": "down"},
    }
    worn = isolable(plan(faults=faults)).faults["worn"]
    assert worn.confused_with == ("stuck",)
    assert worn.separating == {"stuck": None}
    assert worn.note.code == "watch.not_isolable"


def test_gauge_at_the_rail_separates_a_clogged_filter_from_a_worn_valve() -> None:
    rail = TANK.replace('from = "supply"', 'from = "rail"').replace("[parts.valve]", """
    [parts.filter]
    kind = "orifice"
    from = "supply"
    to = "rail"
    sonic_conductance = "2e-8 m^3/(s Pa)"
    critical_ratio = 0.3
    [parts.rail]
    kind = "chamber"
    volume = "1 l"
    initial_pressure = "7 bar"
    [parts.valve]""")  # fmt: skip
    faults = {
        "filter": {"address": "filter.sonic_conductance", "alarm": "2e-9 m^3/(s Pa)", "direction": "down"},
        "valve": {"address": "valve.sonic_conductance", "alarm": "1e-10 m^3/(s Pa)", "direction": "down"},
    }
    before = isolable(plan(rail + MOVING, faults=faults)).faults["filter"]
    assert before.confused_with == ("valve",)
    sensor = before.separating["valve"]
    assert sensor is not None
    assert sensor.separation > 4.0
    measured = {**TABLES["measured"], sensor.address: {"noise": sensor.noise, "offset": sensor.offset}}
    after = isolable(plan(rail + MOVING, faults=faults, measured=measured)).faults["filter"]
    # The prediction is that of a plan with this sensor; opposite effects are completely separate.
    assert after.is_isolable
    assert after.angle > 90.0
    assert after.alarm / after.sd_alone == pytest.approx(sensor.separation)


def test_faults_without_a_visible_effect_are_named() -> None:
    closed = MOVING.replace("[0.2, 1.0, 0.0]", "[0.0, 0.0, 0.0]")
    faults = {
        "consumer": {"address": "consumer.sonic_conductance", "alarm": "1e-9 m^3/(s Pa)"},
        "leak": {**LEAK, "alarm": "1e-14 m^3/(s Pa)"},
    }
    result = isolable(plan(TANK + closed, faults=faults))
    consumer, leak = result.faults.values()
    assert consumer.note.code == "watch.no_effect"
    assert math.isinf(consumer.sd_alone)
    assert not leak.is_visible
    assert leak.note.code == "watch.not_visible"
    assert leak.note.facts["times"] == pytest.approx(5.0 * leak.sd_alone / 1e-14)
    assert np.isnan(result.angles[0, 1])


def test_run_in_which_nothing_moves_is_reported() -> None:
    resting = TANK.replace('"5 bar"', '"7 bar"') + MOVING.replace("[0.2, 1.0, 0.0]", "[0.0, 0.0, 0.0]")
    assert isolable(plan(resting)).remarks[0].code == "watch.still_run"
    assert "watch.still_run" not in {remark.code for remark in isolable(plan()).remarks}


def test_recording_of_the_inputs_replaces_the_signals() -> None:
    own = isolable(plan())
    time = 0.1 * np.arange(201) + 100.0
    opening = np.select([time < 105.0 - 1e-9, time < 112.0 - 1e-9], [0.2, 1.0], 0.0)
    recorded = isolable(plan(TANK), time=time, inputs=opening[:, np.newaxis])
    assert recorded.faults["leak"].sd_alone == pytest.approx(own.faults["leak"].sd_alone, rel=1e-6)
    assert recorded.duration == pytest.approx(20.0)


def test_nuisances_and_offsets_increase_the_deviation() -> None:
    without = isolable(plan(measured={"tank.pressure": {"noise": "5 mbar"}, "consumer.opening": {}}))
    with_offset = isolable(plan())
    with_nuisance = isolable(plan(nuisances=TABLES["nuisances"]))
    sds = [result.faults["leak"].sd_alone for result in (without, with_offset, with_nuisance)]
    assert sds[0] < sds[1] < sds[2]


def test_sampled_circuits_use_whole_runs() -> None:
    circuit = load(Path(__file__).parents[3] / "examples" / "cylinder_position.toml")
    faults = {
        "supply_low": {"address": "supply.pressure", "alarm": "0.3 bar", "direction": "down"},
        "friction": {"address": "slide.friction.coulomb_force", "alarm": "4 N", "direction": "up"},
    }
    measured = {"slide.position": {"noise": "0.1 mm"}, "cylinder.cap.pressure": {"noise": "5 mbar"}}
    result = isolable(read_plan(circuit.with_signals({}), measured, faults))
    assert all(0.0 < fault.sd_alone < math.inf for fault in result.faults.values())


def result_of_tank() -> Isolability:
    return isolable(plan(nuisances=TABLES["nuisances"]))


def test_summary_contains_each_fault_with_its_unit_and_verdict() -> None:
    text = str(result_of_tank())
    header, leak, supply = text.splitlines()[1:4]
    assert header.split("  ")[0] == "fault"
    assert leak.startswith("leak ")
    assert supply.startswith("supply_low")
    assert "dm^3/(s bar)" in leak
    assert "bar (" in supply
    assert " x alarm)" in leak
    assert text.count("- ") == 2


def test_result_file_contains_the_table(tmp_path: Path) -> None:
    result = result_of_tank()
    result.save(tmp_path / "isolable.toml")
    content = tomllib.loads((tmp_path / "isolable.toml").read_text())
    assert content["faults"]["leak"]["sd_alone"] == result.faults["leak"].sd_alone
    assert content["findings"] == [str(remark) for remark in result.remarks]

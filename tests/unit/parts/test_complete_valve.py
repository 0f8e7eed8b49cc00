"""Pilot stage, electronics and the complete valve as parts: fields, wiring, messages, single samples."""

from __future__ import annotations

import dataclasses
from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet import Chamber, Circuit, Orifice, Reservoir, loads
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.parts import Electronics, MainStage, PilotStage, ProportionalValve
from poppet.parts.part import NEVER, Scope, Surroundings
from poppet.signals import Sine, Steps
from refusals import refused

EXAMPLES = Path(__file__).parents[3] / "examples"
AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)


def valve(**fields: object) -> ProportionalValve:
    return ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l", **fields)


def circuit(signals: dict[str, object] | None = None, volume: str = "1 l", **fields: object) -> Circuit:
    tank = Chamber(volume=volume, wall_conductance=1.0)
    return Circuit({"supply": Reservoir(pressure="7 bar"), "valve": valve(**fields), "tank": tank}, signals or {})


def electronics(**fields: object) -> Electronics:
    """Electronics without a library set, every number plain."""
    given: dict[str, object] = {
        "scaling": {"high": "6 bar g"},
        "outer": {"gain": 2.0, "pilot_limit": "8 bar"},
        "inner": {"gain": 1e-5},
    }
    return Electronics(**{**given, **fields})


def scope(part: Electronics, inputs: dict[str, float], memory: dict[str, float] | None = None) -> Scope:
    numbers = part.parameters(AIR)
    given = {"setpoint": numbers["setpoint"], "power": 1.0, "outlet_pressure": 1e5, "pilot_pressure": 1e5}
    given |= {"input_fault": 0.0} | inputs
    start = part.start(Scope(numbers, {}, given, AIR))
    states = {name: start[name] for name in ("outlet_sensor_pressure", "pilot_sensor_pressure")}
    held = {name: value for name, value in start.items() if name not in states}
    return Scope(numbers, states, given, AIR, held | (memory or {}))


# --- The whole and its members ---


def test_numbers_have_nested_addresses_and_sources():
    numbers = circuit().numbers()
    for address in ("valve.pilot.volume", "valve.electronics.outer.gain", "valve.main_stage.damping"):
        assert numbers[address].source.kind == "assumed"
        assert numbers[address].source.note
    assert numbers["valve.electronics.scaling.high"].source.kind == "datasheet"


def test_values_change_by_nested_address():
    changed = circuit().with_values({"valve.pilot.fill.frequency": 200, "valve.main_stage.upper_spring.rate": 3e3})
    numbers = changed.numbers()
    assert float(numbers["valve.pilot.fill.frequency"]) == 200.0
    assert float(numbers["valve.main_stage.upper_spring.rate"]) == 3e3
    assert numbers["valve.pilot.fill.frequency"].source.kind == "given"
    assert float(numbers["valve.pilot.vent.frequency"]) == 100.0


def test_a_change_of_preset_keeps_specified_numbers():
    first = circuit(preset="fast", electronics={"outer": {"gain": 7.0}})
    second = first.with_values({"valve.preset": "precise"})
    assert float(second.numbers()["valve.electronics.outer.gain"]) == 7.0
    expected = valve(preset="precise").numbers()["electronics.inner.gain"]
    assert second.numbers()["valve.electronics.inner.gain"] == expected
    assert expected != first.numbers()["valve.electronics.inner.gain"]


def test_a_number_never_compiles_and_a_preset_neither():
    first, second = circuit(preset="fast"), circuit(preset="precise", pilot={"volume": "8 cm^3"})
    assert first.kernel is second.kernel


def test_errors_of_all_members_are_reported_together():
    with pytest.raises(InputError) as caught:
        valve(
            pilot={"volume": -1.0, "volmue": 1.0}, electronics={"inner": {"sample_time": 0.0}}, main_stage={"mode": "x"}
        )
    text = str(caught.value)
    assert "pilot.volmue is not a valid field. Did you mean volume?" in text
    assert "pilot.volume = -1 m^3 is out of range" in text
    assert "electronics.inner.sample_time = 0 s is out of range" in text
    assert "main_stage.mode is not a valid field" in text


def test_a_missing_port_is_one_error():
    with pytest.raises(InputError) as caught:
        ProportionalValve(outlet="tank", exhaust="ambient", data="vppm_6l")
    assert str(caught.value).count("is missing") == 1


def test_a_member_that_is_not_a_table_is_rejected():
    with refused("fields.not_a_table", "pilot.pilot", value=3):
        valve(pilot=3)


def test_an_unknown_set_is_one_error():
    with refused("library.unknown", "data", name="vppm_6") as caught:
        ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6")
    (problem,) = caught.value.problems
    assert problem.facts["suggestion"].names == ["vppm_6l"]


def test_outputs_are_seen_under_the_name_of_the_whole():
    names = [name for name, _ in circuit().model.outputs]
    wanted = ["setpoint", "power", "input_fault", "pilot_pressure", "stroke", "actual_value", "fill_duty", "vent_duty"]
    wanted += [f"{way}_mass_flow_rate" for way in ("supply", "exhaust", "fill", "vent")]
    assert {f"valve.{name}" for name in wanted} <= set(names)
    assert not [name for name in names if name.count(".") > 1]
    assert len(names) == len(set(names))


def test_the_file_of_the_contract():
    text = """
    [parts.supply]
    kind = "reservoir"
    pressure = "7 bar"
    [parts.room]
    kind = "reservoir"
    pressure = "1 bar"
    [parts.valve]
    kind = "proportional_valve"
    data = "vppm_6l"
    preset = "universal"
    setpoint_type = "4-20 mA"
    supply = "supply"
    outlet = "tank"
    exhaust = "room"
    pilot = { volume = "6 cm^3" }
    [parts.valve.electronics.outer]
    gain = 1.5
    [parts.tank]
    kind = "chamber"
    volume = "1 l"
    [signals."valve.setpoint"]
    kind = "steps"
    times = [0, 1]
    values = ["8 mA", "12 mA"]
    """
    read = loads(text)
    assert float(read.numbers()["valve.pilot.volume"]) == pytest.approx(6e-6)
    assert float(read.numbers()["valve.electronics.outer.gain"]) == 1.5
    recording = read.simulate(2.0, 0.01)
    assert recording["valve.target_pressure"][[0, -1]] == pytest.approx([2.5e5, 4e5])
    assert recording["valve.actual_value"][-1] == pytest.approx(12e-3, abs=0.16e-3)


@pytest.mark.parametrize(
    ("line", "reached"), [('values = ["2 bar", "7.5 bar"]', 7.5e5), ('values = ["0.5 bar", "2 bar"]', 0.5e5)]
)
def test_a_setpoint_out_of_range_is_refused_with_its_line(line, reached):
    text = f"""
[parts.supply]
kind = "reservoir"
pressure = "7 bar"
[parts.valve]
kind = "proportional_valve"
data = "vppm_6l"
supply = "supply"
outlet = "tank"
exhaust = "ambient"
[parts.tank]
kind = "chamber"
volume = "1 l"
[signals."valve.setpoint"]
kind = "steps"
times = [0, 1]
{line}
"""
    with refused("wiring.signal_outside", "signals.valve.setpoint", value=reached, low=1e5, high=7e5) as caught:
        loads(text, name="bench.toml")
    assert caught.value.line == 14


@pytest.mark.parametrize("time", ["0 s", "-1 ms", "0.9 us"])
@pytest.mark.parametrize("loop", ["outer", "inner"])
def test_sample_times_below_a_microsecond_are_refused(loop, time):
    with refused("fields.out_of_range", f"electronics.{loop}.sample_time", limits=["at least 1e-06"], unit="s"):
        valve(electronics={loop: {"sample_time": time}})


def test_solenoids_that_cannot_open_and_close_in_a_period_are_refused():
    with refused("valve.no_time_to_open", "pilot.vent.frequency", periods=pytest.approx(1.08)):
        valve(pilot={"vent": {"frequency": "600 Hz"}})


def test_scaling_must_rise():
    with refused("valve.scaling_exchanged", "valve.electronics.scaling.high"):
        circuit(electronics={"scaling": {"low": "6 bar g", "high": "5 bar g"}}).parameters  # noqa: B018


# --- Single samples of the electronics ---


def test_the_outer_loop_is_the_printed_law():
    part = electronics(outer={"gain": 2.0, "pilot_limit": "8 bar", "feed_forward": 0.5, "bias": 1e4})
    new = part.update("outer", scope(part, {"setpoint": 4e5, "outlet_pressure": 3e5}))
    assert new["pilot_setpoint"] == pytest.approx(1e5 + 0.5 * 3e5 + 1e4 + 2.0 * 1e5)
    assert new["integral"] == 0.0
    assert new["actual_pressure"] == 3e5


def test_the_integral_sums_gain_times_error_and_takes_back_what_is_cut_off():
    loop = {"gain": 2.0, "pilot_limit": "8 bar", "integral_time": 0.5, "sample_time": 1e-3, "feed_forward": 0.0}
    part = electronics(outer=loop)
    free = part.update("outer", scope(part, {"setpoint": 3e5, "outlet_pressure": 2e5}))
    assert free["integral"] == pytest.approx(1e-3 / 0.5 * 2e5)
    cut = part.update("outer", scope(part, {"setpoint": 6e5, "outlet_pressure": 1e5}))
    wanted = 1e5 + 2.0 * 5e5
    assert cut["pilot_setpoint"] == 8e5
    assert cut["integral"] == pytest.approx(1e-3 / 0.5 * (2.0 * 5e5 + 8e5 - wanted))


def test_bands_and_limits_of_the_integral():
    loop = {"gain": 1.0, "pilot_limit": "8 bar", "integral_time": 1e-3, "dead_band": 1e3, "integral_band": 2e4}
    part = electronics(outer=loop | {"integral_limit": 5e3})
    inside = part.update("outer", scope(part, {"setpoint": 2e5, "outlet_pressure": 2e5 - 900.0}))
    assert inside["integral"] == 0.0
    beyond = part.update("outer", scope(part, {"setpoint": 2e5, "outlet_pressure": 1.5e5}, {"integral": 77.0}))
    assert beyond["integral"] == 77.0
    limited = part.update("outer", scope(part, {"setpoint": 2e5, "outlet_pressure": 1.9e5}, {"integral": 4e3}))
    assert limited["integral"] == 5e3


CROSSING = {"gain": 2.0, "pilot_limit": "8 bar", "dead_band": 400.0, "dead_zone": 8e3, "correction_limit": 1e4}


@pytest.mark.parametrize(
    ("error", "added"),
    [(400.0, 0.0), (-500.0, -2200.0), (800.0, 8800.0), (-900.0, -9e3), (1400.0, 1e4), (-1e5, -1e4)],
)
def test_the_dead_zone_is_crossed_within_a_second_dead_band_and_the_correction_is_limited(error, added):
    part = electronics(outer=CROSSING)
    new = part.update("outer", scope(part, {"setpoint": 3e5, "outlet_pressure": 3e5 - error}))
    assert new["pilot_setpoint"] == pytest.approx(3e5 + added)


def test_without_a_dead_band_there_is_no_crossing_and_without_a_limit_no_end():
    part = electronics(outer=CROSSING | {"dead_band": 0.0, "correction_limit": 0.0})
    new = part.update("outer", scope(part, {"setpoint": 3e5, "outlet_pressure": 2e5}))
    assert new["pilot_setpoint"] == pytest.approx(3e5 + 2.0 * 1e5)


def test_the_derivative_brakes_beyond_the_limit_and_the_integral_takes_back_what_that_cut():
    loop = CROSSING | {"derivative_time": 0.01, "integral_time": 0.5, "sample_time": 1e-3, "integral_band": 2e4}
    part = electronics(outer=loop | {"derivative_filter": 0.0})
    memory = {"outer_count": 1.0, "last_pressure": 2.9e5 - 100.0}
    new = part.update("outer", scope(part, {"setpoint": 3e5, "outlet_pressure": 2.9e5}, memory))
    assert new["pilot_setpoint"] == pytest.approx(3e5 + 1e4 - 2.0 * 0.01 * 100.0 / 1e-3)
    # K e plus what the limit took: the integral runs to where the correction just meets its limit.
    assert new["integral"] == pytest.approx(1e-3 / 0.5 * (1e4 - 8e3))
    beyond = part.update("outer", scope(part, {"setpoint": 3e5, "outlet_pressure": 2e5}, {"integral": 77.0}))
    assert beyond["integral"] == 77.0


def test_the_derivative_acts_on_the_measurement_from_the_second_sample_on():
    loop = {
        "gain": 2.0,
        "pilot_limit": "8 bar",
        "derivative_time": 0.01,
        "derivative_filter": 0.004,
        "sample_time": 0.001,
    }
    part = electronics(outer=loop)
    first = part.update("outer", scope(part, {"setpoint": 2e5, "outlet_pressure": 1.5e5}))
    assert first["derivative"] == 0.0
    memory = {"outer_count": 1.0, "last_pressure": 1.4e5, "derivative": 100.0}
    second = part.update("outer", scope(part, {"setpoint": 2e5, "outlet_pressure": 1.5e5}, memory))
    assert second["derivative"] == pytest.approx((0.004 * 100.0 - 2.0 * 0.01 * 1e4) / 0.005)


@pytest.mark.parametrize(
    ("error", "fill", "vent"),
    [(900.0, 0.0, 0.0), (-900.0, 0.0, 0.0), (2e4, 0.3, 0.0), (-2e4, 0.0, 0.3), (2e5, 1.0, 0.0), (-9e4, 0.0, 1.0)],
)
def test_the_inner_loop_fills_holds_or_vents(error, fill, vent):
    part = electronics(inner={"gain": 1e-5, "hold_band": 1e3, "minimum_duty": 0.1})
    new = part.update("inner", scope(part, {"setpoint": 4e5}, {"pilot_setpoint": 1e5 + error}))
    if error < -1e4 and vent == 1.0:
        assert new["vent_duty"] == pytest.approx(1.0)
    assert (new["fill_duty"], new["vent_duty"]) == pytest.approx((fill, vent))


def test_venting_waits_until_it_was_wanted_for_the_delay():
    part = electronics(inner={"gain": 1e-5, "vent_delay": 0.25})
    seen = scope(part, {}, {"pilot_setpoint": 8e4})
    first = part.update("inner", seen)
    assert (first["vent_wanted"], first["vent_duty"], first["vent"]) == pytest.approx((0.2, 0.0, 0.25))
    later = dataclasses.replace(seen, memory={**seen.memory, **first, "pilot_setpoint": 7e4}, time=0.1)
    second = part.update("inner", later)
    assert (second["vent_wanted"], second["vent_duty"], second["vent"]) == pytest.approx((0.3, 0.0, 0.25))
    opened = part.update("vent", dataclasses.replace(later, memory={**later.memory, **second}, time=0.25))
    assert (opened["vent_duty"], opened["vent_ready"]) == pytest.approx((0.3, 1.0))
    third = part.update("inner", dataclasses.replace(later, memory={**later.memory, **second, **opened}, time=0.3))
    assert third["vent_duty"] == pytest.approx(0.3)
    broken = {**later.memory, **second, "pilot_setpoint": 1e5}
    called_off = part.update("inner", dataclasses.replace(later, memory=broken, time=0.2))
    assert (called_off["vent_wanted"], called_off["vent_duty"], called_off["vent"]) == (0.0, 0.0, NEVER)


def test_near_zero_the_pilot_is_vented_and_the_integral_forgotten():
    part = electronics(zero_suppression=0.01)
    seen = scope(part, {"setpoint": 1e5 + 5e3}, {"integral": 300.0})
    assert part.update("outer", seen)["integral"] == 0.0
    assert part.update("outer", seen)["pilot_setpoint"] == 1e5
    assert part.update("inner", seen)["vent_duty"] == 1.0
    above = scope(part, {"setpoint": 1e5 + 7e3})
    assert part.update("inner", above)["vent_duty"] == 0.0


def test_the_converter_rounds_to_its_step():
    part = electronics(converter={"bits": 12, "span": "10 bar"})
    step = 1e6 / 4096
    new = part.update("outer", scope(part, {"outlet_pressure": 1e5 + 10.4 * step}))
    assert new["actual_pressure"] == pytest.approx(1e5 + 10.0 * step, abs=1e-9)
    off = part.update("outer", scope(electronics(), {"outlet_pressure": 1e5 + 10.4 * step}))
    assert off["actual_pressure"] == pytest.approx(1e5 + 10.4 * step)


@pytest.mark.parametrize(("kind", "setpoint", "target"), [("0-10 V", 5.0, 4e5), ("4-20 mA", 8e-3, 2.5e5)])
def test_setpoints_in_volts_and_milliamperes(kind, setpoint, target):
    part = electronics(setpoint_type=kind)
    shown = part.control(scope(part, {"setpoint": setpoint}, {"actual_pressure": target})).outputs
    assert shown["target_pressure"][0] == pytest.approx(target)
    assert shown["actual_value"][0] == pytest.approx(setpoint)


# --- Runs ---


def test_without_power_both_solenoids_close_and_the_pressure_is_held():
    tight = {"exhaust_leak": {"sonic_conductance": 0.0}}
    signals = {"valve.setpoint": Steps([0.0, 2.0], [3e5, 6e5]), "valve.power": Steps([0.0, 1.5], [1.0, 0.0])}
    recording = circuit(signals, pilot=tight).simulate(4.0, 0.01)
    after = recording.time > 1.51
    assert np.all(recording["valve.fill_duty"][after] == 0.0)
    assert np.all(recording["valve.vent_duty"][after] == 0.0)
    assert np.ptp(recording["valve.pilot_mass"][after]) < 1e-12
    assert recording["tank.pressure"][-1] == pytest.approx(3e5, rel=0.02)


def test_a_setpoint_of_zero_empties_the_tank():
    recording = circuit({"valve.setpoint": Steps([0.0, 1.0], [4e5, 1e5])}).simulate(8.0, 0.01)
    assert recording["valve.vent_duty"][-1] == 1.0
    assert recording["tank.pressure"][-1] == pytest.approx(1e5, abs=4e3)


def test_the_electronics_start_with_what_the_sensors_see():
    whole = circuit(pilot={"initial_pressure": "3 bar"}).with_values({"tank.initial_pressure": "2 bar"})
    recording = whole.simulate(1e-3, 1e-4)
    assert recording["valve.outlet_sensor_pressure"][0] == pytest.approx(2e5)
    assert recording["valve.pilot_sensor_pressure"][0] == pytest.approx(3e5)


def test_the_pilot_has_its_pressure_at_the_volume_that_it_begins_with():
    whole = circuit(pilot={"initial_pressure": "3 bar"}, main_stage={"initial_stroke": "0.9 mm"})
    recording = whole.simulate(1e-6, 1e-6)
    assert recording["valve.pilot_pressure"][0] == pytest.approx(3e5, rel=1e-9)
    assert recording["valve.pilot_temperature"][0] == pytest.approx(293.15, rel=1e-9)


def test_parts_on_their_own_do_what_the_whole_does():
    whole = circuit({"valve.setpoint": Steps([0.0, 0.5], [3e5, 2e5])})
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "main": MainStage(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l", mode="regulator"),
        "pilot": PilotStage(supply="supply", exhaust="ambient", data="vppm_6l"),
        "controller": Electronics(data="vppm_6l"),
        "tank": whole.parts["tank"],
    }
    connections = {
        "main.pilot_pressure": "pilot.pressure",
        "pilot.displacement": "main.displacement",
        "pilot.fill_duty": "controller.fill_duty",
        "pilot.vent_duty": "controller.vent_duty",
        "controller.outlet_pressure": "tank.pressure",
        "controller.pilot_pressure": "pilot.pressure",
    }
    signals = {"controller.setpoint": whole.signals["valve.setpoint"]}
    single = Circuit(parts, signals, connections=connections)
    a, b = whole.simulate(1.0, 1e-3), single.simulate(1.0, 1e-3)
    assert np.max(np.abs(a["tank.pressure"] - b["tank.pressure"])) < 1.0
    assert np.max(np.abs(a["valve.pilot_pressure"] - b["pilot.pressure"])) < 5.0
    # The speed of the plate is known to the pilot in both, so that its gas keeps its energy.
    assert np.max(np.abs(b["pilot.displacement_rate"])) > 1e-6
    for run, pilot in ((a, "valve.pilot"), (b, "pilot")):
        (energy,) = (each for each in run.residuals if each.store == pilot and each.quantity == "energy")
        assert energy.error < 1e-12 * (energy.through + energy.inventory)


def test_a_displacement_without_a_derivative_is_rejected():
    pilots = {name: PilotStage(supply="supply", exhaust="ambient", data="vppm_6l") for name in ("one", "other")}
    parts = {"supply": Reservoir(pressure="7 bar"), **pilots}
    circuit = Circuit(
        parts, {"one.displacement": Sine(0.0, 1e-6, 1.0)}, connections={"other.displacement": "one.volume"}
    )
    with refused("wiring.no_slope", "connections.other.displacement", source="one.volume"):
        circuit.simulate(0.1)


def test_the_whole_starts_again_where_a_run_ended():
    whole = circuit({"valve.setpoint": Steps([0.0], [3e5])})
    first = whole.simulate(1.0, 1e-3)
    second = whole.simulate(0.2, 1e-3, start=first)
    assert second["tank.pressure"][0] == pytest.approx(first["tank.pressure"][-1], rel=1e-6)
    assert second["valve.pilot_pressure"][0] == pytest.approx(first["valve.pilot_pressure"][-1], rel=1e-6)
    assert second["valve.stroke"][0] == pytest.approx(first["valve.stroke"][-1], abs=1e-9)


def directly_controlled(**electronics_fields: object) -> Circuit:
    """A tank that two orifices fill and vent as electronics without an outer loop tell them."""
    hole = {"sonic_conductance": 6e-9, "critical_ratio": 0.3}
    parts = {
        "supply": Reservoir(pressure="5 bar"),
        "fill": Orifice(from_="supply", to="tank", **hole),
        "vent": Orifice(from_="tank", to="ambient", **hole),
        "tank": Chamber(volume="0.5 l", thermal="isothermal", initial_pressure="3 bar"),
        "controller": electronics(outer={"gain": 0.0, "pilot_limit": "8 bar"}, **electronics_fields),
    }
    connections = {
        "fill.opening": "controller.fill_duty",
        "vent.opening": "controller.vent_duty",
        "controller.outlet_pressure": "tank.pressure",
        "controller.pilot_pressure": "tank.pressure",
    }
    signals = {"controller.setpoint": Steps([0.0, 0.1, 0.8], [3e5, 2e5, 2.5e5])}
    return Circuit(parts, signals, connections=connections)


def test_a_delay_between_samples_ends_where_it_ends():
    inner = {"gain": 1e-4, "sample_time": "10 ms", "vent_delay": 0.2537}
    recording = directly_controlled(inner=inner).simulate(1.0, 1e-4)
    opened = recording.time[np.argmax(recording["controller.vent_duty"] > 0.0)]
    # The outer loop sees the step at 0.1 s or one millisecond later, the inner one at its next sample.
    assert opened in (pytest.approx(0.3537, abs=2e-4), pytest.approx(0.3637, abs=2e-4))
    assert np.ptp(recording["tank.pressure"][recording.time < opened]) < 1.0
    assert recording["tank.pressure"][recording.time < 0.8][-1] < 2.1e5
    assert recording["tank.pressure"][-1] == pytest.approx(2.5e5, rel=0.01)


def test_a_signal_of_the_setpoint_may_act_later():
    inner = {"gain": 1e-3}
    early = directly_controlled(inner=inner).simulate(1.0, 1e-3)
    late = directly_controlled(inner=inner, setpoint_delay="50 ms").simulate(1.0, 1e-3)
    assert late["controller.setpoint"][149] == 3e5
    assert late["controller.setpoint"][151] == 2e5
    moved = early["tank.pressure"][:-50]
    assert np.max(np.abs(late["tank.pressure"][50:] - moved)) < 1e-3 * np.ptp(moved)


# --- What a run says ---


def test_a_target_above_the_supply_has_a_note():
    whole = circuit({"valve.setpoint": Steps([0.0, 1.0], [3e5, 6e5])}).with_values({"supply.pressure": "5 bar"})
    notes = {note.code: note for note in whole.simulate(4.0, 0.01).remarks}
    above, missed = notes["valve.out_of_reach"], notes["valve.not_reached"]
    assert above.address == missed.address == "valve"
    assert above.facts == {"target_bar": pytest.approx(6.0), "time": 1.0, "supply_bar": pytest.approx(5.0)}
    assert (missed.facts["target_bar"], missed.facts["time"]) == (pytest.approx(6.0), 4.0)


def test_a_target_that_is_reached_is_not_mentioned():
    assert not circuit({"valve.setpoint": Steps([0.0], [3e5])}).simulate(2.0, 0.01).notes


def test_an_unstable_tuning_is_reported():
    wild = {"outer": {"gain": 20.0}, "inner": {"gain": 1e-3}}
    notes = circuit({"valve.setpoint": Steps([0.0], [3e5])}, "0.1 l", electronics=wild).simulate(2.0, 1e-3).notes
    assert any("does not settle at the target of 3 bar" in note for note in notes)


# --- Connections ---

HOLE = Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3)


def joined(connections: dict[str, str], more: dict[str, object] | None = None, **fields: object) -> Circuit:
    parts = {"supply": Reservoir(pressure="7 bar"), "hole": HOLE, "tank": Chamber(volume="1 l"), "valve": valve()}
    return Circuit({**parts, **(more or {})}, connections=connections, **fields)


def mistake(made: Callable[[], object]) -> InputError:
    with pytest.raises(InputError) as caught:
        made()
    return caught.value


@pytest.mark.parametrize(
    ("connections", "code", "address"),
    [
        ({"hole.openin": "valve.fill_duty"}, "names.unknown", "connections.hole.openin"),
        ({"hole.opening": "valv.fill_duty"}, "wiring.no_output", "connections.hole.opening"),
        ({"hole.opening": 3}, "wiring.no_output", "connections.hole.opening"),
    ],
)
def test_connections_that_end_nowhere(connections, code, address):
    found = mistake(lambda: joined(connections))
    assert (found.code, found.address) == (code, address)


def test_an_output_that_no_part_has_shows_when_the_circuit_is_traced():
    found = mistake(lambda: joined({"hole.opening": "valve.fil_duty"}).model)
    assert (found.code, found.address) == ("fields.not_an_option", "connections.hole.opening")
    assert "valve.fill_duty" in found.facts["suggestion"].names


def test_a_signal_and_a_connection_on_one_input():
    signals = {"hole.opening": Steps([0.0], [0.5])}
    found = mistake(lambda: joined({"hole.opening": "valve.fill_duty"}, signals=signals))
    assert (found.code, found.address) == ("wiring.driven_twice", "signals.hole.opening")


@pytest.mark.parametrize(("source", "unit"), [("valve.pilot_pressure", "Pa"), ("tank.mass", "kg")])
def test_an_input_takes_no_output_of_another_quantity(source, unit):
    found = mistake(lambda: joined({"hole.opening": source}).model)
    assert (found.code, found.address) == ("wiring.other_unit", "connections.hole.opening")
    assert found.facts == {"source": source, "unit": unit, "wanted": "1"}


def test_an_output_cannot_feed_itself():
    found = mistake(lambda: joined({"hole.opening": "hole.mass_flow_rate"}).model)
    assert (found.code, found.facts["names"]) == ("wiring.loop", ["hole.opening"])


def test_a_controller_without_a_measurement_has_a_note():
    alone = Electronics(data="vppm_6l")
    run = Circuit({"controller": alone}, {"controller.pilot_pressure": Steps([0.0], [2e5])}).simulate(0.1, 0.01)
    assert run.remarks == (Note("circuit.uncontrolled", "controller.outlet_pressure", value=1e5, unit="Pa"),)
    loop = {"hole.opening": "regulator.command"}
    parts = {"regulator": poppet.parts.PID(gain=1e-5, setpoint="2 bar")}
    unheard = joined(loop, more=parts).simulate(0.1, 0.01)
    assert Note("circuit.uncontrolled", "regulator.measurement", value=1e5, unit="Pa") in unheard.remarks
    heard = joined({**loop, "regulator.measurement": "tank.pressure"}, more=parts).simulate(0.1, 0.01)
    assert not any(note.code == "circuit.uncontrolled" for note in heard.remarks)


def test_a_connected_input_is_an_output_and_no_input():
    model = joined({"hole.opening": "valve.vent_duty"}).model
    assert "hole.opening" not in [item.name for item in model.inputs]
    recording = joined({"hole.opening": "valve.vent_duty"}, run=poppet.Run(duration="0.1 s")).simulate()
    assert np.array_equal(recording["hole.opening"], recording["valve.vent_duty"])


def test_parts_are_frozen():
    with pytest.raises(dataclasses.FrozenInstanceError):
        valve().preset = "fast"  # type: ignore[misc]


def test_pages_state_the_count_of_assumed_parameters():
    from pathlib import Path

    numbers = valve().numbers().values()
    assumed = sum(number.source.kind == "assumed" for number in numbers)
    root = Path(__file__).parents[3]
    for page, words in (("README.md", "{} of its {} parameters"), ("docs/valve.md", "{} of its {} parameters")):
        assert words.format(assumed, len(numbers)) in (root / page).read_text(encoding="utf-8"), page


def test_a_forgotten_set_is_one_error():
    with refused("parts.forgotten_set", "data", set="vppm_6l") as caught:
        ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", preset="quick")
    forgotten, option = caught.value.problems
    assert forgotten.facts["count"] > len(forgotten.facts["first"])
    assert (option.code, option.address, option.facts["value"]) == ("fields.not_an_option", "preset", "quick")


def test_an_address_one_level_too_high_is_led_to_its_place():
    with pytest.raises(InputError) as caught:
        circuit().with_values({"valve.outer.gain": 2.0})
    assert caught.value.code == "names.unknown"
    assert "valve.electronics.outer.gain" in caught.value.facts["suggestion"].names


# --- What a picture shows first ---


def pictured(made: Circuit) -> set[str]:
    return set(made.instance.model.columns[0]) - made.instance.inner


def test_a_picture_shows_setpoint_pressures_flow_stroke_and_regimes():
    assert pictured(circuit()) == {
        *("supply.pressure", "supply.temperature", "tank.pressure", "tank.temperature"),
        *(f"valve.{name}" for name in ("setpoint", "power", "pilot_pressure", "stroke", "contact")),
        *(f"valve.{way}_{what}" for way in ("supply", "exhaust") for what in ("mass_flow_rate", "regime")),
    }


def test_every_inner_series_is_one_of_the_part():
    made = circuit()
    declared = {f"valve.{name}" for name in ProportionalValve.internal_outputs}
    assert declared <= set(made.instance.model.columns[0])


def test_of_a_setpoint_in_volts_the_target_is_shown():
    assert "valve.target_pressure" not in pictured(circuit())
    assert "valve.target_pressure" in pictured(circuit(setpoint_type="0-10 V"))


def test_an_input_that_takes_a_shown_series_is_not_shown_twice():
    made = poppet.load(EXAMPLES / "regulator_parts.toml")
    assert "controller.outlet_pressure" not in pictured(made)
    assert "tank.pressure" in pictured(made)


def test_the_recording_of_a_run_knows_them():
    made = circuit({"valve.setpoint": Steps([0.0], [2e5])})
    assert made.simulate(0.01).inner == made.instance.inner

"""Tests of `identify tank`: free parameters, sensor offsets, files, invalid input and doubtful results."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, Orifice, Reservoir
from poppet.core.errors import InputError, InputErrors
from poppet.identify import Result, TankTest, identify_tank, read_result, read_tank_file
from poppet.identify.fit.fit_series import apply_lag
from poppet.identify.tank.tank_plan import plan_tank_fit, read_runs
from poppet.signals import SampledSignal
from refusals import refused
from result_keys import undocumented

TRUTH = {"valve.sonic_conductance": 1e-8, "valve.critical_ratio": 0.35, "tank.wall_conductance": 6.0}
NOISE = 700.0


def simulate_recording(
    direction: str = "discharge",
    *,
    opens: float = 0.0,
    closes: float = 1e9,
    duration: float = 60.0,
    seed: int = 3,
    noise: float = NOISE,
) -> dict[str, Any]:
    """Return a recording of a 20 l tank between 1 and 7 bar, with noise of 0.1 %."""
    is_charge = direction == "charge"
    tank = Chamber(
        volume="20 l",
        initial_pressure="1 bar" if is_charge else "7 bar",
        wall_conductance=TRUTH["tank.wall_conductance"],
    )
    ports = ("supply", "tank") if is_charge else ("tank", "ambient")
    valve = Orifice(from_=ports[0], to=ports[1], sonic_conductance=1e-8, critical_ratio=0.35)
    parts = {"supply": Reservoir(pressure="7 bar"), "tank": tank, "valve": valve}
    parts = parts if is_charge else {"tank": tank, "valve": valve}
    edges = [-1e-6, 0.0]
    times = np.array([0.0, *(opens + 1.0 + np.array(edges)), *(closes + 1.0 + np.array(edges))])
    command = SampledSignal(times, np.array([0.0, 0.0, 1.0, 1.0, 0.0]), "command")
    run = Circuit(parts, {"valve.opening": command}).simulate(duration + 1.0, 0.1)
    is_selected = run.time >= 1.0 - 1e-9
    generator = np.random.default_rng(seed)
    return {
        "time": run.time[is_selected] - 1.0,
        "tank.pressure": run["tank.pressure"][is_selected] + generator.normal(0.0, noise, is_selected.sum()),
        "tank.temperature": run["tank.temperature"][is_selected] + generator.normal(0.0, 0.2, is_selected.sum()),
    }


def without_temperature(recording: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in recording.items() if key != "tank.temperature"}


def finding_codes(result: Result) -> list[str]:
    return [note.code for note in result.remarks]


def check_truth(parameters: Any, *names: str) -> None:
    for name in names or TRUTH:
        estimate, truth = parameters[name], TRUTH[name.removeprefix("a.").removeprefix("b.")]
        # Three standard errors, 5/3 of half the interval.
        assert abs(estimate.value - truth) < 3.0 * estimate.standard_error
        assert estimate.verdict == "determined"


def test_discharge_with_temperature_recovers_truth() -> None:
    result = identify_tank(TankTest(recordings={"a": simulate_recording()}, volume="20 l"))
    check_truth(result.parameters)
    assert result.method == "tank"
    assert set(result.residuals) == {"a.tank.pressure", "a.tank.temperature"}


def test_joint_fit_shares_valve_but_not_wall_conductance() -> None:
    recordings = {
        "a": {**without_temperature(simulate_recording("charge")), "direction": "charge", "supply_pressure": "6 bar g"},
        "b": without_temperature(simulate_recording("discharge", seed=4)),
    }
    parameters = identify_tank(TankTest(recordings=recordings, volume="20 l", uncertainties={"leak": 0})).parameters
    check_truth(parameters, "valve.sonic_conductance", "valve.critical_ratio")
    check_truth(parameters, "a.tank.wall_conductance", "b.tank.wall_conductance")


def test_delay_and_closing_within_recording() -> None:
    delayed = simulate_recording(opens=2.3)
    result = identify_tank(TankTest(recordings={"a": without_temperature(delayed)}, volume="20 l", valve_delay="free"))
    check_truth(result.parameters)
    assert result.parameters["a.valve.delay"].value == pytest.approx(2.3, abs=0.03)
    closed = without_temperature(simulate_recording(opens=2.0, closes=12.0)) | {"opens": "2 s", "closes": "12 s"}
    short = identify_tank(TankTest(recordings={"a": closed}, volume="20 l", critical_ratio=0.35))
    check_truth(short.parameters, "valve.sonic_conductance", "tank.wall_conductance")


def test_recorded_supply_pressure_replaces_stated_one(tmp_path: Path) -> None:
    run = simulate_recording("charge")
    sagging = 7e5 + 1e5 * np.exp(-run["time"] / 3.0)
    rows = np.column_stack([run["time"], sagging, run["tank.pressure"]])
    np.savetxt(tmp_path / "charge.csv", rows, delimiter=",", header="t,supply,tank", comments="")
    recording = {
        "direction": "charge",
        "file": "charge.csv",
        "time": {"column": "t", "unit": "s"},
        "tank.pressure": {"column": "tank", "unit": "Pa"},
        "inputs": {"supply.pressure": {"column": "supply", "unit": "Pa"}},
    }
    test = TankTest(recordings={"a": recording}, volume="20 l", folder=tmp_path)
    runs = read_runs(test)
    assert runs[0].supply_pressure == pytest.approx(8e5)
    inputs = plan_tank_fit(test, runs).experiments[0].measurement.inputs
    assert [channel.address for channel in inputs] == ["supply.pressure"]


def test_free_offset_recovers_sensor_offset() -> None:
    shifted = without_temperature(simulate_recording())
    shifted["tank.pressure"] = shifted["tank.pressure"] + 3000.0
    result = identify_tank(TankTest(recordings={"a": shifted}, volume="20 l", pressure_offset="free"))
    check_truth(result.parameters)
    offset = result.parameters["a.tank.pressure.offset"]
    assert abs(offset.value - 3000.0) < 3.0 * offset.standard_error


def test_offset_is_free_if_valve_closes_within_recording() -> None:
    shifted = without_temperature(simulate_recording(closes=30.0)) | {"closes": "30 s"}
    shifted["tank.pressure"] = shifted["tank.pressure"] + 3000.0
    result = identify_tank(TankTest(recordings={"a": shifted}, volume="20 l", uncertainties={"leak": 0}))
    check_truth(result.parameters)
    offset = result.parameters["a.tank.pressure.offset"]
    assert abs(offset.value - 3000.0) < 3.0 * offset.standard_error
    fixed = identify_tank(TankTest(recordings={"a": shifted}, volume="20 l", pressure_offset=0.0))
    assert "a.tank.pressure.offset" not in fixed.parameters


def test_stated_offset_is_prior() -> None:
    shifted = without_temperature(simulate_recording())
    channel = {"values": shifted["tank.pressure"] + 3000.0}
    offsets = {}
    for stated in (1.0, 5000.0):
        test = TankTest(recordings={"a": {**shifted, "tank.pressure": {**channel, "offset": stated}}}, volume="20 l")
        offsets[stated] = identify_tank(test).parameters["a.tank.pressure.offset"]
    assert abs(offsets[1.0].value) < 3.0
    assert abs(offsets[5000.0].value - 3000.0) < 3.0 * offsets[5000.0].standard_error


def test_free_volume_is_not_determined() -> None:
    test = TankTest(recordings={"a": without_temperature(simulate_recording())}, volume={"start": "15 l"})
    result = identify_tank(test)
    assert result.parameters["tank.volume"].verdict == "not determined"
    assert "finding.tell_apart.volume" in finding_codes(result)
    ratio = next(n for n in result.remarks if (n.code, n.address) == ("finding.ratio", "valve.sonic_conductance"))
    assert ratio.facts["over"] == "tank.volume"
    assert ratio.facts["value"] == pytest.approx(1e-8 / 0.02, rel=0.01)


@pytest.mark.parametrize(("thermal", "free"), [("isothermal", set()), ("polytropic", {"tank.polytropic_exponent"})])
def test_simple_thermal_laws_report_large_residuals(thermal: str, free: set[str]) -> None:
    test = TankTest(recordings={"a": without_temperature(simulate_recording())}, volume="20 l", thermal=thermal)
    result = identify_tank(test)
    assert set(result.parameters) == {*list(TRUTH)[:2], "tank.initial_pressure", *free}
    assert {"finding.residuals.large", "finding.residuals.not_white"} & set(finding_codes(result))


def test_file_and_arrays_give_same_estimates(tmp_path: Path) -> None:
    run = simulate_recording()
    rows = np.column_stack([1e3 * run["time"], 1e-5 * run["tank.pressure"] - 1.0, run["tank.temperature"] - 273.15])
    np.savetxt(tmp_path / "bench.csv", rows, delimiter=";", header="t;p;T", comments="", fmt="%.9f")
    (tmp_path / "tank.toml").write_text(
        """
volume = "20 l"
part = "fitting"
[recordings.a]
file = "bench.csv"
time = { column = "t", unit = "ms" }
"tank.pressure" = { column = "p", unit = "bar g" }
"tank.temperature" = { column = "T", unit = "degC" }
"""
    )
    read, direct = identify_tank(tmp_path / "tank.toml"), identify_tank(TankTest(recordings={"a": run}, volume="20 l"))
    for name, estimate in direct.parameters.items():
        estimate_of_file = read.parameters[name.replace("valve", "fitting")]
        assert abs(estimate_of_file.value - estimate.value) < 0.01 * estimate.standard_error
    read.save(tmp_path / "result.toml")
    assert read_result(tmp_path / "result.toml").parameters == read.parameters


def input_error(run: dict[str, Any], **test: Any) -> InputError:
    with pytest.raises(InputError) as error:
        identify_tank(TankTest(recordings={"a": run}, **{"volume": "20 l", **test}))
    return error.value


def test_invalid_recordings_are_rejected() -> None:
    run = without_temperature(simulate_recording())
    charge = without_temperature(simulate_recording("charge"))
    contrary = input_error(run, direction="charge", supply_pressure="7 bar")
    assert (contrary.code, contrary.facts["other"]) == ("tank.contrary", "discharge")
    assert input_error(charge).facts["direction"] == "discharge"
    still = {**run, "tank.pressure": 3e5 + np.random.default_rng(1).normal(0.0, NOISE, run["time"].size)}
    assert input_error(still).code == "tank.still"
    above_supply = input_error(charge, direction="charge", supply_pressure="6 bar")
    assert (above_supply.code, above_supply.facts["supply"]) == ("tank.above_supply", 6e5)
    rests = input_error(without_temperature(simulate_recording(opens=2.3)))
    assert (rests.code, rests.facts["rest"]) == ("tank.rests", pytest.approx(2.3, abs=0.15))
    delayed = input_error(
        without_temperature(simulate_recording("charge", opens=1.5)), direction="charge", supply_pressure="7 bar"
    )
    assert delayed.code == "tank.rests"
    assert input_error(charge, direction="charge").code == "fields.missing"
    assert input_error(run, volume="free").code == "tank.no_start"
    assert input_error({**run, "tank.pressure": run["time"][:5]}).code == "tank.shapes"
    assert input_error({**run, "tank.pressure": "1e9 l"}).code == "tank.no_samples"
    assert input_error({**run, "tank.pressure": {"noise": 1.0}}).code == "fields.missing"
    assert input_error({"time": run["time"]}).code == "fields.missing"
    assert input_error(run, pressure_offset=3.0).code == "tank.offset"
    for recordings, code in (({}, "fields.missing"), ({"a": 3}, "fields.no_table")):
        with refused(code):
            identify_tank(TankTest(recordings=recordings, volume="20 l"))
    delayed = input_error({**run, "opens": "3 s", "closes": "2 s"})
    assert (delayed.code, delayed.address) == ("tank.closes", "recordings.a.closes")


def test_all_errors_are_reported_together() -> None:
    run = without_temperature(simulate_recording())
    with pytest.raises(InputErrors) as error:
        TankTest(recordings={"a": run}, volume="20 l", direction="suck", thermal="warm", part="tank")
    assert [(e.code, e.address) for e in error.value.problems] == [
        ("fields.not_an_option", "direction"),
        ("fields.not_an_option", "thermal"),
        ("tank.part", "part"),
    ]
    misspelt = {"time": run["time"], "tank.pressure": {"value": run["tank.pressure"], "lagg": 1.0}, "tank.presure": 1}
    with pytest.raises(InputErrors) as error:
        identify_tank(TankTest(recordings={"a": misspelt}, volume="20 l"))
    assert [(e.code, e.address) for e in error.value.problems] == [
        ("fields.unknown", "recordings.a.tank.presure"),
        ("fields.unknown", "recordings.a.tank.pressure.value"),
        ("fields.unknown", "recordings.a.tank.pressure.lagg"),
    ]


def test_empty_cells_and_repeated_times_are_reported() -> None:
    run = without_temperature(simulate_recording())
    run["time"][5] = run["time"][4]
    run["tank.pressure"][9] = np.nan
    findings = identify_tank(TankTest(recordings={"a": run}, volume="20 l")).findings
    assert any("1 of 601 samples were skipped" in sentence for sentence in findings)
    assert any("1 samples have the same time as another sample" in sentence for sentence in findings)


def test_errors_of_file_have_line_numbers(tmp_path: Path) -> None:
    path = tmp_path / "tank.toml"
    path.write_text('volum = "20 l"\ndirection = "charge"\nstartz = 3\n[recordings.a]\nfile = "bench.csv"\n')
    with pytest.raises(InputErrors) as error:
        read_tank_file(path)
    assert [(e.code, e.line) for e in error.value.problems] == [("fields.unknown", 1), ("fields.unknown", 3)]
    assert error.value.problems[0].facts["suggestion"].names == ["volume"]


def test_title_is_converted_to_text(tmp_path: Path) -> None:
    path = tmp_path / "tank.toml"
    path.write_text('title = inf\nvolume = "20 l"\n[recordings.a]\nfile = "bench.csv"\n')
    assert read_tank_file(path).title == "inf"


def charge_test(**changes: Any) -> TankTest:
    """Return a charge test with changed fields."""
    fields = {"volume": "20 l", "direction": "charge", "supply_pressure": "7 bar"} | changes
    return TankTest(recordings={"a": simulate_recording("charge")}, **fields)


@pytest.mark.parametrize(
    ("changes", "name", "truth"),
    [
        ({"supply_pressure": "free"}, "supply.pressure", 7e5),
        ({"supply_pressure": {"start": "6.8 bar", "prior": {"mean": "7 bar", "sd": "1 kPa"}}}, "supply.pressure", 7e5),
        ({"supply_temperature": "free"}, "supply.temperature", 293.15),
        ({"subsonic_index": "free"}, "valve.subsonic_index", 0.5),
        ({"wall_temperature": "free"}, "tank.wall_temperature", 293.15),
        ({"initial_temperature": "free"}, "tank.initial_temperature", 293.15),
    ],
)
def test_usually_known_parameters_can_be_free(changes: dict[str, Any], name: str, truth: float) -> None:
    estimate = identify_tank(charge_test(**changes)).parameters[name]
    assert abs(estimate.value - truth) < 3.0 * estimate.standard_error
    assert estimate.standard_error < 0.1 * truth


def test_charges_can_have_different_supply_pressures() -> None:
    recordings = {
        "a": {**simulate_recording("charge"), "direction": "charge", "supply_pressure": "free"},
        "b": {**simulate_recording("charge", seed=4), "direction": "charge", "supply_pressure": "7 bar"},
        "c": simulate_recording(seed=5),
    }
    # The wall conductance is fixed, because it is correlated with the supply pressure.
    test = TankTest(recordings=recordings, volume="20 l", wall_conductance=TRUTH["tank.wall_conductance"])
    parameters = identify_tank(test).parameters
    assert {name for name in parameters if "supply" in name} == {"a.supply.pressure"}
    assert parameters["a.supply.pressure"].value == pytest.approx(7e5, rel=1e-3)


def test_conductance_above_bore_weakens_verdict() -> None:
    """Use C = 1e-8 m^3/(s Pa), the conductance of a nozzle with 5.02 mm^2 and a bore of 2.528 mm."""
    narrow, wide, unsure = (
        identify_tank(
            TankTest(recordings={"a": simulate_recording()}, volume="20 l", bore=bore, bore_uncertainty=sigma)
        )
        for bore, sigma in (("2.5 mm", 0.0), ("2.9 mm", 0.0), ("2.5 mm", "0.02 mm"))
    )
    assert narrow.comparison["discharge_coefficient"]["value"] == pytest.approx((2.528 / 2.5) ** 2, abs=0.005)
    assert narrow.parameters["valve.sonic_conductance"].verdict == "weak"
    assert narrow.conditions["capped"]["valve.sonic_conductance"] == ["finding.area"]
    assert {"finding.area", "finding.capped"} <= set(finding_codes(narrow))
    assert undocumented(narrow) == []
    for result in (wide, unsure):
        assert result.parameters["valve.sonic_conductance"].verdict == "determined"
        assert "capped" not in result.conditions
    assert wide.comparison["discharge_coefficient"]["value"] == pytest.approx(0.76, abs=0.005)


def test_sensor_lag_is_best_alternative_model() -> None:
    run = without_temperature(simulate_recording(noise=0.0))
    lagged = apply_lag(run["time"], run["tank.pressure"], 1.5)
    noisy = {**run, "tank.pressure": lagged + np.random.default_rng(1).normal(0.0, 300.0, lagged.size)}
    result = identify_tank(TankTest(recordings={"a": noisy}, volume="20 l"))
    alternatives = result.comparison["alternatives"]
    assert undocumented(result) == []
    assert next(iter(alternatives)) == "pressure_lag"
    assert alternatives["pressure_lag"]["aicc_difference"] < -10.0
    assert alternatives["pressure_lag"]["free"]["a.tank.pressure.lag"]["value"] == pytest.approx(1.5, rel=0.02)
    assert "determined" not in {e.verdict for k, e in result.parameters.items() if k in TRUTH}
    assert "finding.other_model.clear" in finding_codes(result)
    # Models that this one contradicts give no advice.
    assert "finding.other_models" not in finding_codes(result)
    # A stated lag is part of the model.
    stated = identify_tank(TankTest(recordings={"a": noisy}, volume="20 l", pressure_lag="1.5 s"))
    assert "capped" not in stated.conditions


def test_volume_in_wrong_unit_is_reported() -> None:
    """Scale C, V and wall conductance by one factor, which does not change the pressure or the residuals."""
    result = identify_tank(TankTest(recordings={"a": simulate_recording()}, volume="21 m^3"))
    assert {"finding.unusual.conductance", "finding.unusual.volume"} <= {*finding_codes(result)}
    assert result.parameters["valve.sonic_conductance"].verdict == "weak"


def test_time_in_wrong_unit_is_reported() -> None:
    slow = without_temperature(simulate_recording())
    result = identify_tank(TankTest(recordings={"a": {**slow, "time": 1e3 * slow["time"]}}, volume="20 l"))
    (note,) = (remark for remark in result.remarks if remark.code == "finding.unusual.wall")
    assert note.facts["coefficient"] == pytest.approx(6e-3 / (6 * 0.02 ** (2 / 3)), rel=0.1)
    assert result.parameters["valve.sonic_conductance"].verdict == "weak"


def test_repeated_recording_is_rejected() -> None:
    recording = simulate_recording()
    with refused("fit.same_twice", "recordings.b", other="a"):
        identify_tank(TankTest(recordings={"a": recording, "b": recording}, volume="20 l"))
    with refused("fit.same_twice", "recordings.b", other="a"):
        identify_tank(TankTest(recordings={"a": recording, "b": {**recording, "use": "validation"}}, volume="20 l"))


def test_reserved_part_names_are_rejected() -> None:
    for name in ("tank", "supply", "leak"):
        assert input_error(without_temperature(simulate_recording()), part=name).code == "tank.part"


@pytest.mark.parametrize("stride", [1, 75])
def test_start_value_is_close_for_few_samples(stride: int) -> None:
    """Check also nine samples; at the second, the pressure has changed by two fifths of its total change."""
    run = {key: series[::stride] for key, series in without_temperature(simulate_recording(noise=100.0)).items()}
    test = TankTest(recordings={"a": run}, volume="20 l")
    free_parameter = plan_tank_fit(test, read_runs(test)).free[0]
    assert (free_parameter.name, free_parameter.start) == ("valve.sonic_conductance", pytest.approx(1e-8, rel=0.6))


def test_negative_volume_is_rejected():
    error = input_error(simulate_recording(duration=5.0), volume=-1.0)
    assert (error.code, error.address, error.facts["value"]) == ("fields.out_of_range", "volume", -1.0)

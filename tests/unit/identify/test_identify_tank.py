"""Tank tests: the shorter way in, and what it refuses."""

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


def recorded(
    direction: str = "discharge",
    *,
    opens: float = 0.0,
    closes: float = 1e9,
    duration: float = 60.0,
    seed: int = 3,
    noise: float = NOISE,
) -> dict[str, Any]:
    """A tank of 20 litres between 7 and 1 bar; noise of 0.1 %."""
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
    kept = run.time >= 1.0 - 1e-9
    generator = np.random.default_rng(seed)
    return {
        "time": run.time[kept] - 1.0,
        "tank.pressure": run["tank.pressure"][kept] + generator.normal(0.0, noise, kept.sum()),
        "tank.temperature": run["tank.temperature"][kept] + generator.normal(0.0, 0.2, kept.sum()),
    }


def pressure_only(recording: dict[str, Any]) -> dict[str, Any]:
    return {key: value for key, value in recording.items() if key != "tank.temperature"}


def codes(result: Result) -> list[str]:
    return [note.code for note in result.remarks]


def check_truth(parameters: Any, *names: str) -> None:
    for name in names or TRUTH:
        estimate, truth = parameters[name], TRUTH[name.removeprefix("a.").removeprefix("b.")]
        # Three standard errors, 5/3 of half the interval.
        assert abs(estimate.value - truth) < 3.0 * estimate.standard_error
        assert estimate.verdict == "determined"


def test_a_discharge_with_its_temperature() -> None:
    result = identify_tank(TankTest(recordings={"a": recorded()}, volume="20 l"))
    check_truth(result.parameters)
    assert result.method == "tank"
    assert set(result.residuals) == {"a.tank.pressure", "a.tank.temperature"}


def test_charge_and_discharge_jointly_have_one_component_and_two_walls() -> None:
    recordings = {
        "a": {**pressure_only(recorded("charge")), "direction": "charge", "supply_pressure": "6 bar g"},
        "b": pressure_only(recorded("discharge", seed=4)),
    }
    parameters = identify_tank(TankTest(recordings=recordings, volume="20 l")).parameters
    check_truth(parameters, "valve.sonic_conductance", "valve.critical_ratio")
    check_truth(parameters, "a.tank.wall_conductance", "b.tank.wall_conductance")


def test_an_unknown_start_time_and_the_drift_after_closing() -> None:
    late = recorded(opens=2.3)
    found = identify_tank(TankTest(recordings={"a": pressure_only(late)}, volume="20 l", valve_delay="free"))
    check_truth(found.parameters)
    assert found.parameters["a.valve.delay"].value == pytest.approx(2.3, abs=0.03)
    closed = pressure_only(recorded(opens=2.0, closes=12.0)) | {"opens": "2 s", "closes": "12 s"}
    short = identify_tank(TankTest(recordings={"a": closed}, volume="20 l", critical_ratio=0.35))
    check_truth(short.parameters, "valve.sonic_conductance", "tank.wall_conductance")


def test_a_supply_that_was_recorded_needs_no_other_pressure(tmp_path: Path) -> None:
    run = recorded("charge")
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
    driven = plan_tank_fit(test, runs).experiments[0].measurement.inputs
    assert [each.address for each in driven] == ["supply.pressure"]


def test_a_wrong_zero_of_the_sensor_is_found() -> None:
    shifted = pressure_only(recorded())
    shifted["tank.pressure"] = shifted["tank.pressure"] + 3000.0
    result = identify_tank(TankTest(recordings={"a": shifted}, volume="20 l", pressure_offset="free"))
    check_truth(result.parameters)
    offset = result.parameters["a.tank.pressure.offset"]
    assert abs(offset.value - 3000.0) < 3.0 * offset.standard_error


def test_the_zero_of_the_sensor_is_free_where_the_record_tells_it() -> None:
    shifted = pressure_only(recorded(closes=30.0)) | {"closes": "30 s"}
    shifted["tank.pressure"] = shifted["tank.pressure"] + 3000.0
    result = identify_tank(TankTest(recordings={"a": shifted}, volume="20 l"))
    check_truth(result.parameters)
    offset = result.parameters["a.tank.pressure.offset"]
    assert abs(offset.value - 3000.0) < 3.0 * offset.standard_error
    held = identify_tank(TankTest(recordings={"a": shifted}, volume="20 l", pressure_offset=0.0))
    assert "a.tank.pressure.offset" not in held.parameters


def test_a_stated_zero_of_the_sensor_is_a_prior() -> None:
    shifted = pressure_only(recorded())
    known = {"values": shifted["tank.pressure"] + 3000.0}
    zeros = {}
    for stated in (1.0, 5000.0):
        told = TankTest(recordings={"a": {**shifted, "tank.pressure": {**known, "offset": stated}}}, volume="20 l")
        zeros[stated] = identify_tank(told).parameters["a.tank.pressure.offset"]
    assert abs(zeros[1.0].value) < 3.0
    assert abs(zeros[5000.0].value - 3000.0) < 3.0 * zeros[5000.0].standard_error


def test_a_free_volume_is_told_to_be_unseen() -> None:
    test = TankTest(recordings={"a": pressure_only(recorded())}, volume={"start": "15 l"})
    result = identify_tank(test)
    assert result.parameters["tank.volume"].verdict == "not determined"
    assert "finding.tell_apart.volume" in codes(result)
    ratio = next(n for n in result.remarks if (n.code, n.address) == ("finding.ratio", "valve.sonic_conductance"))
    assert ratio.facts["over"] == "tank.volume"
    assert ratio.facts["value"] == pytest.approx(1e-8 / 0.02, rel=0.01)


@pytest.mark.parametrize(("thermal", "free"), [("isothermal", set()), ("polytropic", {"tank.polytropic_exponent"})])
def test_simpler_thermal_laws_own_up_to_their_misfit(thermal: str, free: set[str]) -> None:
    test = TankTest(recordings={"a": pressure_only(recorded())}, volume="20 l", thermal=thermal)
    result = identify_tank(test)
    assert set(result.parameters) == {*list(TRUTH)[:2], "tank.initial_pressure", *free}
    assert {"finding.residuals.large", "finding.residuals.not_white"} & set(codes(result))


def test_a_file_says_the_same_as_its_arrays(tmp_path: Path) -> None:
    run = recorded()
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
        other = read.parameters[name.replace("valve", "fitting")]
        assert abs(other.value - estimate.value) < 0.01 * estimate.standard_error
    read.save(tmp_path / "result.toml")
    assert read_result(tmp_path / "result.toml").parameters == read.parameters


def refusal(run: dict[str, Any], **test: Any) -> InputError:
    with pytest.raises(InputError) as error:
        identify_tank(TankTest(recordings={"a": run}, **{"volume": "20 l", **test}))
    return error.value


def test_what_is_no_such_test_is_refused() -> None:
    run = pressure_only(recorded())
    charge = pressure_only(recorded("charge"))
    contrary = refusal(run, direction="charge", supply_pressure="7 bar")
    assert (contrary.code, contrary.facts["other"]) == ("tank.contrary", "discharge")
    assert refusal(charge).facts["direction"] == "discharge"
    still = {**run, "tank.pressure": 3e5 + np.random.default_rng(1).normal(0.0, NOISE, run["time"].size)}
    assert refusal(still).code == "tank.still"
    above = refusal(charge, direction="charge", supply_pressure="6 bar")
    assert (above.code, above.facts["supply"]) == ("tank.above_supply", 6e5)
    rests = refusal(pressure_only(recorded(opens=2.3)))
    assert (rests.code, rests.facts["rest"]) == ("tank.rests", pytest.approx(2.3, abs=0.15))
    late = refusal(pressure_only(recorded("charge", opens=1.5)), direction="charge", supply_pressure="7 bar")
    assert late.code == "tank.rests"
    assert refusal(charge, direction="charge").code == "fields.missing"
    assert refusal(run, volume="free").code == "tank.no_start"
    assert refusal({**run, "tank.pressure": run["time"][:5]}).code == "tank.shapes"
    assert refusal({**run, "tank.pressure": "1e9 l"}).code == "tank.no_samples"
    assert refusal({**run, "tank.pressure": {"noise": 1.0}}).code == "fields.missing"
    assert refusal({"time": run["time"]}).code == "fields.missing"
    assert refusal(run, pressure_offset=3.0).code == "tank.offset"
    for recordings, code in (({}, "fields.missing"), ({"a": 3}, "fields.no_table")):
        with refused(code):
            identify_tank(TankTest(recordings=recordings, volume="20 l"))
    late = refusal({**run, "opens": "3 s", "closes": "2 s"})
    assert (late.code, late.address) == ("tank.closes", "recordings.a.closes")


def test_all_mistakes_of_a_test_are_told_at_once() -> None:
    run = pressure_only(recorded())
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


def test_empty_cells_and_repeated_stamps_are_counted() -> None:
    run = pressure_only(recorded())
    run["time"][5] = run["time"][4]
    run["tank.pressure"][9] = np.nan
    findings = identify_tank(TankTest(recordings={"a": run}, volume="20 l")).findings
    assert any("1 of 601 samples have an empty cell" in sentence for sentence in findings)
    assert any("1 samples with repeated times were merged" in sentence for sentence in findings)


def test_a_misspelt_file_names_its_lines(tmp_path: Path) -> None:
    path = tmp_path / "tank.toml"
    path.write_text('volum = "20 l"\ndirection = "charge"\nstartz = 3\n[recordings.a]\nfile = "bench.csv"\n')
    with pytest.raises(InputErrors) as error:
        read_tank_file(path)
    assert [(e.code, e.line) for e in error.value.problems] == [("fields.unknown", 1), ("fields.unknown", 3)]
    assert error.value.problems[0].facts["near"].names == ["volume"]


def test_a_title_is_a_text_whatever_stands_there(tmp_path: Path) -> None:
    path = tmp_path / "tank.toml"
    path.write_text('title = inf\nvolume = "20 l"\n[recordings.a]\nfile = "bench.csv"\n')
    assert read_tank_file(path).title == "inf"


def charged(**more: Any) -> TankTest:
    """A charge of which the supply's pressure, and whatever else is named, is free."""
    given = {"volume": "20 l", "direction": "charge", "supply_pressure": "7 bar"} | more
    return TankTest(recordings={"a": recorded("charge")}, **given)


@pytest.mark.parametrize(
    ("given", "name", "truth"),
    [
        ({"supply_pressure": "free"}, "supply.pressure", 7e5),
        ({"supply_pressure": {"start": "6.8 bar", "prior": {"mean": "7 bar", "sd": "1 kPa"}}}, "supply.pressure", 7e5),
        ({"supply_temperature": "free"}, "supply.temperature", 293.15),
        ({"subsonic_index": "free"}, "valve.subsonic_index", 0.5),
        ({"wall_temperature": "free"}, "tank.wall_temperature", 293.15),
        ({"initial_temperature": "free"}, "tank.initial_temperature", 293.15),
    ],
)
def test_what_is_usually_known_may_be_free(given: dict[str, Any], name: str, truth: float) -> None:
    found = identify_tank(charged(**given)).parameters[name]
    assert abs(found.value - truth) < 3.0 * found.standard_error
    assert found.standard_error < 0.1 * truth


def test_each_charge_may_come_from_a_supply_of_its_own() -> None:
    recordings = {
        "a": {**recorded("charge"), "direction": "charge", "supply_pressure": "free"},
        "b": {**recorded("charge", seed=4), "direction": "charge", "supply_pressure": "7 bar"},
        "c": recorded(seed=5),
    }
    # The wall is held: what heat and supply have to say to each other is another test.
    test = TankTest(recordings=recordings, volume="20 l", wall_conductance=TRUTH["tank.wall_conductance"])
    parameters = identify_tank(test).parameters
    assert {name for name in parameters if "supply" in name} == {"a.supply.pressure"}
    assert parameters["a.supply.pressure"].value == pytest.approx(7e5, rel=1e-3)


def test_more_flow_than_the_bore_lets_through_costs_the_verdict() -> None:
    """C = 1e-8 m^3/(s Pa) are 5.02 mm^2 of a nozzle, a bore of 2.528 mm."""
    narrow, wide, unsure = (
        identify_tank(TankTest(recordings={"a": recorded()}, volume="20 l", bore=bore, bore_uncertainty=sigma))
        for bore, sigma in (("2.5 mm", 0.0), ("2.9 mm", 0.0), ("2.5 mm", "0.02 mm"))
    )
    assert narrow.comparison["discharge_coefficient"]["value"] == pytest.approx((2.528 / 2.5) ** 2, abs=0.005)
    assert narrow.parameters["valve.sonic_conductance"].verdict == "weak"
    assert narrow.conditions["capped"]["valve.sonic_conductance"] == ["finding.area"]
    assert {"finding.area", "finding.capped"} <= set(codes(narrow))
    assert undocumented(narrow) == []
    for result in (wide, unsure):
        assert result.parameters["valve.sonic_conductance"].verdict == "determined"
        assert "capped" not in result.conditions
    assert wide.comparison["discharge_coefficient"]["value"] == pytest.approx(0.76, abs=0.005)


def test_a_slow_gauge_is_told_from_what_the_model_lacks() -> None:
    run = pressure_only(recorded(noise=0.0))
    shown = apply_lag(run["time"], run["tank.pressure"], 1.5)
    noisy = {**run, "tank.pressure": shown + np.random.default_rng(1).normal(0.0, 300.0, shown.size)}
    result = identify_tank(TankTest(recordings={"a": noisy}, volume="20 l"))
    others = result.comparison["alternatives"]
    assert undocumented(result) == []
    assert next(iter(others)) == "pressure_lag"
    assert others["pressure_lag"]["aicc_difference"] < -10.0
    assert others["pressure_lag"]["free"]["a.tank.pressure.lag"]["value"] == pytest.approx(1.5, rel=0.02)
    assert "determined" not in {e.verdict for k, e in result.parameters.items() if k in TRUTH}
    assert {"finding.other_model.clear", "finding.other_models"} <= set(codes(result))
    # Stated, it is part of the model.
    stated = identify_tank(TankTest(recordings={"a": noisy}, volume="20 l", pressure_lag="1.5 s"))
    assert "capped" not in stated.conditions


def test_litres_written_as_cubic_metres_are_doubted() -> None:
    """C, V and wall conductance scaled together leave the pressure as it is: no residual can tell."""
    result = identify_tank(TankTest(recordings={"a": recorded()}, volume="21 m^3"))
    assert {"finding.unusual.conductance", "finding.unusual.volume"} <= {*codes(result)}
    assert result.parameters["valve.sonic_conductance"].verdict == "weak"


def test_milliseconds_read_as_seconds_are_doubted() -> None:
    slow = pressure_only(recorded())
    result = identify_tank(TankTest(recordings={"a": {**slow, "time": 1e3 * slow["time"]}}, volume="20 l"))
    (note,) = (each for each in result.remarks if each.code == "finding.unusual.wall")
    assert note.facts["coefficient"] == pytest.approx(6e-3 / (6 * 0.02 ** (2 / 3)), rel=0.1)
    assert result.parameters["valve.sonic_conductance"].verdict == "weak"


def test_a_recording_that_counts_twice_is_refused() -> None:
    once = recorded()
    with refused("fit.same_twice", "recordings.b", other="a"):
        identify_tank(TankTest(recordings={"a": once, "b": once}, volume="20 l"))
    with refused("fit.same_twice", "recordings.b", other="a"):
        identify_tank(TankTest(recordings={"a": once, "b": {**once, "use": "validation"}}, volume="20 l"))


def test_a_part_may_not_be_called_as_the_bench_is() -> None:
    for name in ("tank", "supply", "leak"):
        assert refusal(pressure_only(recorded()), part=name).code == "tank.part"


@pytest.mark.parametrize("every", [1, 75])
def test_a_search_begins_near_however_few_samples_there_are(every: int) -> None:
    """By the second of nine samples it has lost two fifths of what it will lose."""
    run = {key: series[::every] for key, series in pressure_only(recorded(noise=100.0)).items()}
    test = TankTest(recordings={"a": run}, volume="20 l")
    first = plan_tank_fit(test, read_runs(test)).free[0]
    assert (first.name, first.start) == ("valve.sonic_conductance", pytest.approx(1e-8, rel=0.6))


def test_a_volume_that_cannot_be_is_refused_before_anything_follows_from_it():
    error = refusal(recorded(duration=5.0), volume=-1.0)
    assert (error.code, error.address, error.facts["value"]) == ("fields.out_of_range", "volume", -1.0)

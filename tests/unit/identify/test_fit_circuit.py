"""Fit of a circuit in one call: recordings, arguments, errors, and agreement with fit files."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet import Chamber, Circuit, InputError, MainStage, Orifice, Recording, Reservoir, Run
from poppet.identify import identify_fit, read_result
from poppet.signals import Steps

pd = pytest.importorskip("pandas")
EXAMPLES = Path(__file__).parents[3] / "examples"
VALVE = "valve.sonic_conductance"
TRUTH = {VALVE: 1e-8, "valve.critical_ratio": 0.3}


def tank(**fields: object) -> Circuit:
    """Return a tank that empties through a valve."""
    valve = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    chamber = Chamber(**{"volume": "20 l", "initial_pressure": "7 bar", "wall_conductance": "5 W/K", **fields})
    return Circuit({"tank": chamber, "valve": valve}, run=Run(duration="20 s", output_step="0.1 s"), title="tank")


def noisy(run: Recording, seed: int = 1, sigma: float = 300.0) -> np.ndarray:
    """Return the tank pressure of a run with noise [Pa]."""
    return run["tank.pressure"] + np.random.default_rng(seed).normal(0.0, sigma, run.time.size)


@pytest.fixture(scope="module")
def measured() -> Recording:
    run = tank().simulate()
    return Recording.from_series(run.time, {"tank.pressure [Pa]": noisy(run)}, title="bench")


@pytest.fixture(scope="module")
def frame(measured: Recording) -> pd.DataFrame:
    return pd.DataFrame({"time [s]": measured.time, "tank.pressure [Pa]": measured["tank.pressure"]})


def code_of(error: pytest.ExceptionInfo[InputError]) -> str:
    assert error.value.hint, "an error has a hint"
    return error.value.code


def assert_equal_results(first: poppet.identify.Result, second: poppet.identify.Result) -> None:
    assert first.parameters.keys() == second.parameters.keys()
    for name, estimate in first.parameters.items():
        other = second.parameters[name]
        for key in ("value", "standard_error", "low", "high"):
            assert getattr(estimate, key) == pytest.approx(getattr(other, key), rel=1e-9), (name, key)
        assert estimate.verdict == other.verdict


# Agreement with fit files ---------------------------------------------------------------------------------------------


def test_fit_of_six_parameters_agrees_with_the_fit_file(tmp_path: Path) -> None:
    text = (EXAMPLES / "fill_staircase.toml").read_text(encoding="utf-8")
    (tmp_path / "circuit.toml").write_text(text, encoding="utf-8")
    circuit = poppet.load(tmp_path / "circuit.toml")
    run = circuit.simulate()
    recording = Recording.from_series(run.time, {"tank.pressure [Pa]": noisy(run, sigma=700.0)})
    recording.save(tmp_path / "run.csv")
    starts = {
        name: factor * circuit.parameters[name]
        for name, factor in {
            "valve.plate_area": 1.02,
            "valve.lower_spring.preload": 0.95,
            "valve.exhaust_seat.sonic_conductance": 1.1,
            "tank.volume": 0.95,
            "tank.wall_conductance": 0.8,
            "tank.wall_temperature": 1.005,
        }.items()
        if name in circuit.parameters
    } or {}
    missing = 6 - len(starts)
    more = [name for name in ("bleed.sonic_conductance", "tank.initial_pressure") if name in circuit.parameters]
    starts |= {name: 1.01 * circuit.parameters[name] for name in more[:missing]}
    assert len(starts) == 6
    free = "\n".join(f'"{name}" = {{ start = {value!r} }}' for name, value in starts.items())
    (tmp_path / "fit.toml").write_text(
        'circuit = "circuit.toml"\n[recordings.recording]\nfile = "run.csv"\n'
        f'time = {{ column = "time", unit = "s" }}\n"tank.pressure" = {{ column = "tank.pressure", unit = "Pa" }}\n'
        f"[free]\n{free}\n",
        encoding="utf-8",
    )
    assert_equal_results(circuit.fit(recording, starts), identify_fit(tmp_path / "fit.toml"))


def test_fit_of_two_recordings_agrees_with_the_fit_file(tmp_path: Path) -> None:
    circuit = tank()
    (tmp_path / "circuit.toml").write_text(
        'title = "tank"\n[parts.tank]\nkind = "chamber"\nvolume = "20 l"\ninitial_pressure = "7 bar"\n'
        'wall_conductance = "5 W/K"\n[parts.valve]\nkind = "orifice"\nfrom = "tank"\nto = "ambient"\n'
        "sonic_conductance = 1e-8\ncritical_ratio = 0.3\n",
        encoding="utf-8",
    )
    recordings = {}
    for name, pressure in (("high", "7 bar"), ("low", "4 bar")):
        run = circuit.with_values({"tank.initial_pressure": pressure}).simulate()
        columns = {"tank.pressure [bar g]": 1e-5 * noisy(run, seed=len(name)) - 1.0}
        recordings[name] = pd.DataFrame({"time [s]": run.time, **columns})
        recordings[name].to_csv(tmp_path / f"{name}.csv", index=False)
    tables = "".join(
        f'[recordings.{name}]\nfile = "{name}.csv"\ntime = {{ column = "time", unit = "s" }}\n'
        'start = { "tank.initial_pressure" = "free" }\n'
        '"tank.pressure" = { column = "tank.pressure", unit = "bar g", noise = "2 kPa" }\n'
        for name in recordings
    )
    (tmp_path / "fit.toml").write_text(
        f'circuit = "circuit.toml"\n{tables}[free]\n"valve.sonic_conductance" = {{ start = 2e-8, max = 1e-6 }}\n'
        '"valve.critical_ratio" = { prior = { mean = 0.3, sd = 0.1 } }\n"tank.wall_conductance" = "3 W/K"\n',
        encoding="utf-8",
    )
    result = circuit.fit(
        recordings,
        {VALVE: 2e-8, "valve.critical_ratio": {}, "tank.wall_conductance": "3 W/K"},
        outputs=["tank.pressure"],
        bounds={VALVE: (None, 1e-6)},
        priors={"valve.critical_ratio": (0.3, 0.1)},
        start={"tank.initial_pressure": "free"},
        noise={"tank.pressure": "2 kPa"},
    )
    assert_equal_results(result, identify_fit(tmp_path / "fit.toml"))
    assert {"high.tank.initial_pressure", "low.tank.initial_pressure"} < result.parameters.keys()
    assert list(result.circuits) == ["high", "low"]
    for name, circuit in result.circuits.items():
        series = result.series[f"{name}.tank.pressure"]
        again = circuit.simulate().interpolate("tank.pressure", series["time"])
        np.testing.assert_allclose(again, series["model"], rtol=1e-5)


# Recordings -----------------------------------------------------------------------------------------------------------


def test_recording_frame_and_file_give_equal_fits(measured: Recording, frame: pd.DataFrame, tmp_path: Path) -> None:
    circuit, starts = tank(), {VALVE: 2e-8, "valve.critical_ratio": 0.2}
    first = circuit.fit(measured, starts)
    assert_equal_results(first, circuit.fit(frame, starts))
    assert_equal_results(first, circuit.fit({"recording": frame.set_index("time [s]")}, starts))
    assert_equal_results(first, circuit.fit(measured.to_pandas(), starts))
    measured.save(tmp_path / "bench.csv")
    assert_equal_results(first, circuit.fit(poppet.read(tmp_path / "bench.csv"), starts))
    for name, value in TRUTH.items():
        assert first[name].value == pytest.approx(value, rel=0.02)
    assert isinstance(first[VALVE].value, float)


def test_gauge_units_and_milliseconds(measured: Recording, frame: pd.DataFrame) -> None:
    gauge = pd.DataFrame(
        {"time [ms]": 1e3 * measured.time, "tank.pressure [bar g]": 1e-5 * measured["tank.pressure"] - 1.0}
    )
    first, second = (tank().fit(each, [VALVE]) for each in (frame, gauge))
    assert first[VALVE].value == pytest.approx(second[VALVE].value, rel=1e-8)


def test_a_file_with_other_columns_is_read_as_a_recording(tmp_path: Path) -> None:
    rows = "".join(f"{100 * k};{6.0 - 0.01 * k};x\n" for k in range(20))
    (tmp_path / "bench.csv").write_text(f"t;p_tank;remark\n{rows}", encoding="utf-8")
    recording = poppet.read(tmp_path / "bench.csv", time="t [ms]", columns={"tank.pressure": "p_tank [bar g]"})
    assert recording.units == ("Pa",)
    assert recording["tank.pressure"][0] == pytest.approx(7e5)
    assert recording.time[-1] == pytest.approx(1.9)
    with pytest.raises(InputError) as error:
        poppet.read(tmp_path / "bench.csv", time="t [ms]", columns={"tank.pressure": "p_tnk [bar g]"})
    assert "p_tank" in str(error.value)


def test_a_simulated_recording_with_all_its_series() -> None:
    circuit = tank()
    result = circuit.fit(circuit.simulate(), {VALVE: 2e-8, "valve.critical_ratio": 0.2})
    for name, value in TRUTH.items():
        assert result[name].value == pytest.approx(value, rel=1e-4)
    compared = {name.removeprefix("recording.") for name in result.residuals}
    assert {"tank.pressure", "tank.temperature"} <= compared
    assert not {name for name in compared if name.endswith(("regime", "opening", ".mass"))}
    assert any(note.code == "fit.not_compared" for note in result.remarks)


def test_rows_with_nan_are_omitted_and_noted(frame: pd.DataFrame) -> None:
    whole = tank().fit(frame, [VALVE])
    holes = frame.copy()
    holes.loc[5:9, "tank.pressure [Pa]"] = np.nan
    result = tank().fit(holes, [VALVE])
    assert result[VALVE].value == pytest.approx(whole[VALVE].value, rel=1e-2)
    assert any(note.code == "measured.empty_cells" for note in result.remarks)
    assert result.residuals["recording.tank.pressure"].samples == len(frame) - 5


def staircase() -> Circuit:
    """Return a main stage that fills a tank."""
    valve = MainStage(supply="supply", outlet="tank", exhaust="ambient", data="varga2012")
    parts = {"supply": Reservoir(pressure="7 bar"), "valve": valve, "tank": Chamber(volume="20 l")}
    return Circuit(parts, run=Run(duration="12 s", output_step="0.05 s"))


def driven(pilot: Steps) -> pd.DataFrame:
    run = staircase().with_signals({"valve.pilot_pressure": pilot}).simulate()
    return run.to_pandas()[["tank.pressure", "valve.pilot_pressure"]]


def test_recorded_inputs_drive_the_model_and_hold_their_value() -> None:
    frame = driven(Steps([0.0, 2.0, 7.0], [1.5e5, 2.5e5, 1.2e5]))
    circuit = staircase()
    fit_with_hold = circuit.fit(frame, {"tank.volume": "25 l"})
    assert fit_with_hold["tank.volume"].value == pytest.approx(0.02, rel=1e-4)
    coarse = frame.iloc[::10]
    fit_with_hold, ramped = (circuit.fit(coarse, {"tank.volume": "25 l"}, hold=hold) for hold in (True, False))
    rms = [result.residuals["recording.tank.pressure"].rms for result in (fit_with_hold, ramped)]
    assert rms[0] < 0.1 * rms[1]
    series = fit_with_hold.series["recording.tank.pressure"]
    repeated = fit_with_hold.circuit.simulate().interpolate("tank.pressure", series["time"])
    np.testing.assert_allclose(repeated, series["model"], rtol=1e-5)
    assert "valve.pilot_pressure" in fit_with_hold.circuit.signals


# The result -----------------------------------------------------------------------------------------------------------


def test_the_result_is_complete(measured: Recording, tmp_path: Path) -> None:
    result = tank().fit(measured, [VALVE], start={"tank.initial_pressure": "free"}, title="first test")
    assert set(result.parameters) == {VALVE, "tank.initial_pressure"}
    for name in result.parameters:
        number = result.circuit.numbers()[name]
        assert (float(number), number.source.kind) == (pytest.approx(result[name].value), "fitted")
    series = result.series["recording.tank.pressure"]
    again = result.circuit.simulate().interpolate("tank.pressure", series["time"])
    np.testing.assert_allclose(again, series["model"], rtol=1e-5)
    assert VALVE in result.summary()
    assert "first test" in result.summary()
    table = result.to_frame()
    assert table.loc[VALVE, "value"] == result[VALVE].value
    assert list(table.columns) == ["value", "unit", "standard_error", "low", "high", "verdict", "start"]
    figure = result.plot(tmp_path / "fit.png")
    assert len(figure.axes) == 1
    assert (tmp_path / "fit.png").stat().st_size > 1000
    result.save(tmp_path / "result.toml")
    again = read_result(tmp_path / "result.toml")
    assert again.parameters == result.parameters
    assert again.findings == result.findings
    assert tank().with_values(again.values()).parameters[VALVE] == pytest.approx(result[VALVE].value)
    with pytest.raises(InputError) as error:
        result["valve.sonic_conductanc"]
    assert code_of(error) == "names.unknown"


def test_offsets_validation_and_search_options(measured: Recording) -> None:
    run = tank().with_values({"tank.initial_pressure": "5 bar"}).simulate()
    shifted = Recording.from_series(run.time, {"tank.pressure [Pa]": noisy(run, 2) + 4e3})
    calls: list[int] = []
    result = tank().fit(
        {"a": measured, "b": shifted},
        [VALVE],
        start={"tank.initial_pressure": "first", "b": {"tank.initial_pressure": "5 bar"}},
        offsets={"tank.pressure": "3 kPa"},
        validation=["a"],
        loss="huber",
        starts=2,
        kicks=0,
        bootstrap=2,
        profile=[VALVE],
        progress=lambda evaluations, cost: calls.append(evaluations),
    )
    assert result["b.tank.pressure.offset"].value == pytest.approx(4e3, abs=400.0)
    assert result.conditions["validation"] == ["a"]
    assert result.conditions["starts"] == 2
    assert calls
    assert {note.code for note in result.remarks} >= {"finding.profile", "finding.bootstrap"}


# Errors ---------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ({"free": ["valve.sonic_conductanc"]}, "names.unknown"),
        ({"free": {VALVE: "3 bar"}}, "quantity.other_quantity"),
        ({"free": []}, "fit.nothing_free"),
        ({"outputs": ["tank.presure"]}, "names.unknown"),
        ({"outputs": ["valve.opening"]}, "fit.input_selected"),
        ({"bounds": {"tank.volume": (0.0, 1.0)}}, "names.unknown"),
        ({"bounds": {VALVE: 3e-8}}, "fit.no_pair"),
        ({"bounds": {VALVE: (2e-8, 3e-8)}}, "free.bounds"),
        ({"priors": {VALVE: (1e-8, -1.0)}}, "fields.out_of_range"),
        ({"noise": {"tank.temperature": "1 K"}}, "names.unknown"),
        ({"noise": {"tank.pressure": "1 K"}}, "quantity.other_quantity"),
        ({"offsets": {"tank.pressure": "-1 kPa"}}, "fields.out_of_range"),
        ({"start": {"tank.initial_presure": "free"}}, "names.unknown"),
        ({"start": {"tank.initial_temperature": "first"}}, "measured.no_first_sample"),
        ({"validation": ["other"]}, "fields.not_an_option"),
        ({"loss": "cubic"}, "fields.not_an_option"),
        ({"profile": ["tank.volume"]}, "names.unknown"),
    ],
)
def test_wrong_arguments_are_rejected_with_a_hint(measured: Recording, arguments: dict, code: str) -> None:
    with pytest.raises(InputError) as error:
        tank().fit(measured, **{"free": [VALVE], **arguments})
    assert code_of(error) == code


def test_unusable_recordings_are_rejected_with_a_hint(frame: pd.DataFrame) -> None:
    pressure = "tank.pressure [Pa]"
    cases = {
        "fit.no_rows": frame.iloc[:0],
        "fit.no_time": frame[[pressure]],
        "fit.column_twice": pd.concat([frame, frame[[pressure]]], axis=1),
        "fit.unknown_series": frame.rename(columns={pressure: "tank.presure"}),
        "fit.no_series": frame[["time [s]"]],
        "fit.no_recording": [1.0, 2.0],
        "fit.no_recordings": {},
        "fit.recording_name": {"tank": frame},
        "measured.few_samples": frame.iloc[:4],
        "measured.backwards": frame.iloc[::-1],
        "fit.same_twice": {"a": frame, "b": frame},
    }
    for code, recordings in cases.items():
        with pytest.raises(InputError) as error:
            tank().fit(recordings, [VALVE])
        assert code_of(error) == code
    with pytest.raises(InputError) as error:
        tank().fit(frame.rename(columns={pressure: "tank.pressure [K]"}), [VALVE])
    assert error.value.hint
    with pytest.raises(InputError) as error:
        tank().fit(frame.assign(**{pressure: np.nan}), [VALVE])
    assert error.value.hint


def test_a_parameter_without_effect_is_rejected(measured: Recording) -> None:
    leak = Orifice(from_="other", to="ambient", sonic_conductance=1e-9, critical_ratio=0.3)
    circuit = Circuit({**tank().parts, "other": Chamber(volume="1 l"), "leak": leak})
    with pytest.raises(InputError) as error:
        circuit.fit(measured, [VALVE, "other.volume"])
    assert (code_of(error), error.value.address) == ("fit.no_effect", "other.volume")


def test_missing_and_disjoint_inputs_are_rejected() -> None:
    frame = driven(Steps([0.0, 2.0], [1.5e5, 2.5e5]))
    circuit = staircase()
    with pytest.raises(InputError) as error:
        circuit.fit({"a": frame, "b": 1.01 * frame[["tank.pressure"]]}, ["tank.volume"])
    assert (code_of(error), error.value.address) == ("fit.missing_input", "recordings.b.valve.pilot_pressure")
    late = frame.copy()
    late.iloc[:120, 1] = np.nan
    late.iloc[100:, 0] = np.nan
    with pytest.raises(InputError) as error:
        circuit.fit(late, ["tank.volume"])
    assert code_of(error) == "fit.no_overlap"


# Types and help -------------------------------------------------------------------------------------------------------

SCRIPT = """
import poppet
from poppet import Circuit, Recording

circuit: Circuit = poppet.load("circuit.toml")
recording: Recording = poppet.read("bench.csv", time="t [s]", columns={"tank.pressure": "p [bar g]"})
result = circuit.fit({"test 1": recording}, ["valve.sonic_conductance"], outputs=["tank.pressure"])
reveal_type(result["valve.sonic_conductance"].value)
reveal_type(result.circuit)
reveal_type(result.findings)
reveal_type(result.summary())
"""


def test_a_typed_script_has_no_any(tmp_path: Path) -> None:
    pytest.importorskip("mypy")
    (tmp_path / "script.py").write_text(SCRIPT, encoding="utf-8")
    (tmp_path / "mypy.ini").write_text("[mypy]\nstrict = true\ndisallow_any_expr = true\n", encoding="utf-8")
    source = Path(poppet.__file__).parents[1]
    environment = {**os.environ, "MYPYPATH": str(source)}
    command = [sys.executable, "-m", "mypy", "--config-file", "mypy.ini", "--follow-imports=silent", "script.py"]
    run = subprocess.run(command, cwd=tmp_path, capture_output=True, text=True, check=False, env=environment)
    revealed = [line.partition("Revealed type is ")[2] for line in run.stdout.splitlines() if "Revealed" in line]
    assert revealed[0].strip('"') in ("builtins.float", "float"), run.stdout
    assert "Circuit" in revealed[1], run.stdout
    assert "Any" not in "".join(revealed), run.stdout
    assert "error" not in run.stdout, run.stdout


def test_the_help_of_a_fit_is_complete() -> None:
    import inspect

    text = inspect.getdoc(Circuit.fit) or ""
    for name in inspect.signature(Circuit.fit).parameters:
        assert name == "self" or f"\n{name} : " in text, name
    for heading in ("Returns", "Raises", "Examples"):
        assert f"\n{heading}\n---" in text

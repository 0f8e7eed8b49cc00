"""Tests of the dynamic limits: ranges, bandwidths, ideal parts, result, report, command."""

from __future__ import annotations

import contextlib
import io
import json
import math
import re
import tomllib
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pytest

from pages import needs_nothing_else
from poppet import Circuit
from poppet.bench.limits import maps as room
from poppet.bench.limits.bandwidth import GAIN, BandwidthPoint, bandwidth_point, find_crossing
from poppet.bench.limits.limits_plan import PARTS, ideal_part_changes, spring_and_damping_changes
from poppet.bench.limits.maps import LimitsResult, find_limits, limits_plan
from poppet.bench.limits.stability import Stability
from poppet.bench.sine_rig import SineRig, fundamental, without_bands
from poppet.cli.main import run
from poppet.core.codes import Note
from poppet.core.errors import InputError, InputErrors
from poppet.parts import Chamber, Orifice, ProportionalValve, Reservoir

FILE = """
title = "a valve"
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
wall_conductance = 1
[parts.load]
kind = "orifice"
from = "tank"
to = "ambient"
sonic_conductance = 2e-9
critical_ratio = 0.3
"""


def valve_circuit(**fields) -> Circuit:
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l", **fields),
        "tank": Chamber(volume="1 l", wall_conductance=1.0),
        "load": Orifice(from_="tank", to="ambient", sonic_conductance=2e-9, critical_ratio=0.3),
    }
    return Circuit(parts)


class CommandRun(NamedTuple):
    """Exit code, output and files of a run of the command."""

    code: int
    out: str
    folder: Path


@pytest.fixture(scope="module")
def command_run(tmp_path_factory) -> CommandRun:
    """Run the command for one point of each map."""
    pytest.importorskip("matplotlib")
    folder = tmp_path_factory.mktemp("limits")
    (folder / "valve.toml").write_text(FILE)
    files = [str(folder / "valve.toml"), "-o", str(folder / "r.toml"), "--report", str(folder / "r.html")]
    lists = ["--volumes", "1 l", "--amplitudes", "60 kPa", "--springs", "1", "--dampings", "2"]
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        code = run(["bench", "limits", *files, *lists])
    return CommandRun(code, printed.getvalue(), folder)


class TestPlan:
    def test_defaults_follow_the_circuit(self):
        plan = limits_plan(valve_circuit())
        assert (plan.valve, plan.outlet, plan.mean) == ("valve", "tank", 4e5)
        assert (plan.volumes[0], plan.volumes[-1]) == (1e-4, 1e-2)
        assert plan.amplitudes[-1] == 1.5e5
        assert plan.setpoint == "valve.setpoint"

    def test_reads_units_and_gauge(self):
        plan = limits_plan(
            valve_circuit(), mean="2 bar g", volumes=["2 l", "1 l"], amplitudes=["10 kPa"], springs=[2.0, 1.0]
        )
        assert (plan.mean, plan.volumes, plan.amplitudes) == (3e5, (1e-3, 2e-3), (1e4,))
        assert plan.springs == (1.0, 2.0)

    def test_setpoint_in_volts(self):
        plan = limits_plan(valve_circuit(setpoint_type="0-10 V"))
        assert plan.setpoint_for(4e5) == pytest.approx(5.0)
        assert plan.per_pascal == pytest.approx(10.0 / 6e5)
        case = plan.case(1e-3)
        rig = SineRig(case.instance, plan.setpoint, plan.pressure, settling=0.5)
        assert rig.level == pytest.approx(4e5, abs=1e4)

    def test_case_scales_wall_conductance_and_sets_initial_states(self):
        numbers = limits_plan(valve_circuit()).case(8e-3).parameters
        assert numbers["tank.volume"] == 8e-3
        assert numbers["tank.wall_conductance"] == pytest.approx(4.0)
        assert numbers["tank.initial_pressure"] == 4e5
        assert numbers["valve.pilot.initial_pressure"] == pytest.approx(4.113e5)

    def test_all_errors_are_reported_together(self):
        with pytest.raises(InputErrors) as caught:
            limits_plan(valve_circuit(), mean="4 baar", volumes=["-1 l"], amplitudes=["10 kPa", "x"], springs=[0.0])
        assert len(caught.value.problems) == 4

    def test_amplitude_outside_the_range_is_rejected(self):
        with pytest.raises(InputError) as caught:
            limits_plan(valve_circuit(), mean="2 bar", amplitudes=["1.5 bar"])
        assert caught.value.code == "limits.reach"

    @pytest.mark.parametrize("valve", ["vavle", "tank"])
    def test_unknown_valve_is_rejected(self, valve):
        with pytest.raises(InputError) as caught:
            limits_plan(valve_circuit(), valve)
        assert (caught.value.code, caught.value.facts["suggestion"].valid_names) == ("names.unknown", ["valve"])

    def test_several_valves_need_a_name(self):
        parts = valve_circuit().parts
        with pytest.raises(InputError) as caught:
            limits_plan(Circuit({**parts, "second": parts["valve"]}))
        assert (caught.value.code, caught.value.facts["valves"]) == ("rig.several_valves", ("valve", "second"))

    def test_missing_valve_or_chamber_is_rejected(self):
        parts = dict(valve_circuit().parts)
        with pytest.raises(InputError) as caught:
            limits_plan(Circuit({name: parts[name] for name in ("tank", "load")}))
        assert caught.value.code == "rig.no_valve"
        parts["tank"] = Reservoir(pressure="3 bar")
        with pytest.raises(InputError) as caught:
            limits_plan(Circuit(parts))
        assert caught.value.code == "limits.no_chamber"

    def test_ideal_parts_have_parameters_changed_by_ten(self):
        plan = limits_plan(valve_circuit())
        nominal = plan.case(1e-3).parameters
        changed = {}
        for part in PARTS:
            ideal_parameters = plan.case(1e-3, ideal_part_changes(plan, part)).parameters
            changed[part] = {
                key: ideal_parameters[key] / nominal[key]
                for key in ideal_parameters
                if ideal_parameters[key] != nominal[key]
            }
        v, e = "valve.main_stage.", "valve.electronics."
        assert changed["solenoids"] == pytest.approx(
            {f"valve.pilot.{n}.sonic_conductance": 10.0 for n in ("fill", "vent")}
        )
        assert changed["pilot volume"] == pytest.approx({"valve.pilot.volume": 0.1})
        assert changed["poppet"] == pytest.approx(
            {f"{v}moving_mass": 0.1, f"{v}emptying_mass": 0.1, f"{v}damping": 10.0**-0.5}
        )
        lags = ("outlet_sensor.lag", "pilot_sensor.lag", "outer.sample_time", "inner.sample_time")
        assert changed["sensors and sampling"] == pytest.approx({f"{e}{name}": 0.1 for name in lags})
        curve = (
            plan.case(1e-3, ideal_part_changes(plan, "sonic conductance")).parts["valve"].members["main_stage"].curve
        )
        main_curve = valve_circuit().parts["valve"].members["main_stage"].curve
        for stroke in (1e-5, 2e-4, 9e-4):
            assert curve.sonic_conductance_at(stroke) == pytest.approx(10.0 * main_curve.sonic_conductance_at(stroke))
            assert curve.critical_ratio_at(stroke) == main_curve.critical_ratio_at(stroke)

    def test_other_springs_keep_the_preload_forces(self):
        plan = limits_plan(valve_circuit())
        nominal, changed = (plan.case(1e-3, c).parameters for c in ({}, spring_and_damping_changes(plan, 4.0, 0.5)))
        for name in ("upper", "lower"):
            path = f"valve.main_stage.{name}_spring"
            assert changed[f"{path}.rate"] == 4.0 * nominal[f"{path}.rate"]
            force = nominal[f"{path}.rate"] * nominal[f"{path}.preload"]
            assert changed[f"{path}.rate"] * changed[f"{path}.preload"] == pytest.approx(force)
        assert changed["valve.main_stage.damping"] == 0.5 * nominal["valve.main_stage.damping"]


class TestCrossing:
    @pytest.mark.parametrize("guess", [0.02, 3.0, 50.0, 1e5])
    def test_bandwidth_of_low_pass(self, guess):
        """A first order with a corner at 7 Hz falls by 3 dB at 7 sqrt(10^0.3 - 1) Hz."""
        frequency = find_crossing(lambda f: 1.0 / math.hypot(1.0, f / 7.0), GAIN, guess, 0.1, 1000.0)
        assert frequency == pytest.approx(7.0 * math.sqrt(10.0**0.3 - 1.0), rel=0.01)

    def test_crossing_outside_the_range(self):
        def low_pass(f: float) -> float:
            return 1.0 / math.hypot(1.0, f / 7.0)

        assert find_crossing(low_pass, GAIN, 20.0, 10.0, 1000.0) == 0.0
        assert find_crossing(low_pass, GAIN, 1.0, 0.1, 5.0) == math.inf

    def test_fundamental_with_offset_drift_and_harmonic(self):
        t = np.arange(800) / 100.0
        y = 7.0 + 0.01 * t + 2.0 * np.sin(2 * np.pi * t + 0.7) + 0.6 * np.sin(6 * np.pi * t)
        wave, mean, residual = fundamental(t, y, 1.0)
        assert wave == pytest.approx(2.0 * np.exp(0.7j), rel=2e-3)
        assert mean == pytest.approx(7.04, abs=0.01)
        assert residual == pytest.approx(0.3, abs=0.01)


class TestPoints:
    def test_small_amplitude_has_bandwidth_of_linear_model(self):
        leak = {"valve.pilot.exhaust_leak.sonic_conductance": 2e-11}
        circuit = without_bands(valve_circuit()).with_values(leak)
        plan = limits_plan(circuit, volumes=["3 l"], amplitudes=["100 Pa"])
        point = bandwidth_point(plan, 3e-3, 100.0, parts=("load volume",))
        model = plan.case(3e-3).linearise()
        f = np.geomspace(1.0, 200.0, 4000)
        gain = model.frequency_response(f, plan.setpoint, plan.pressure)
        assert point.gain_frequency == pytest.approx(f[np.argmax(np.abs(gain) < GAIN)], rel=0.02)
        lag = -np.degrees(np.unwrap(np.angle(gain)))
        assert point.phase_frequency == pytest.approx(f[np.argmax(lag > 90.0)], rel=0.02)
        assert set(point.gains) == {"load volume"}

    @pytest.mark.slow
    def test_limiting_part_over_a_decade_of_volumes(self):
        """The solenoids limit small volumes at large amplitudes; the seat limits large volumes."""
        plan = limits_plan(valve_circuit(), volumes=["0.25 l", "5 l"], amplitudes=["60 kPa"])
        small, large = (bandwidth_point(plan, volume, 6e4) for volume in plan.volumes)
        assert small.limiting in ("solenoids", "pilot volume")
        assert min(small.gains["solenoids"], small.gains["pilot volume"]) > 1.3
        assert large.limiting in ("sonic conductance", "load volume")
        assert min(large.gains["sonic conductance"], large.gains["load volume"]) > 3.0
        assert max(large.gains[part] for part in ("solenoids", "pilot volume", "poppet")) < 1.1
        assert small.gain_frequency > 5.0 * large.gain_frequency
        assert small.rise_up < small.rise_down < large.rise_down
        assert small.rise_up < 0.2 * large.rise_up

    def test_limiting_part_depends_on_the_volume(self, command_run):
        """Two volumes near the change of the limit, one with the result of the command at 1 l."""
        pilot = ("solenoids", "pilot volume")
        plan = limits_plan(valve_circuit(), volumes=["0.25 l"], amplitudes=["60 kPa"])
        small = bandwidth_point(plan, 2.5e-4, 6e4, parts=pilot)
        data = tomllib.loads((command_run.folder / "r.toml").read_text(encoding="utf-8"))
        large = {part: values[0][0] for part, values in data["ideal"].items()}
        assert small.limiting in pilot
        assert min(small.gains[part] for part in pilot) > 1.3
        assert data["bandwidth"]["limiting"][0][0] in ("sonic conductance", "load volume")
        assert min(large["sonic conductance"], large["load volume"]) > 1.2
        assert max(large[part] for part in (*pilot, "poppet")) < 1.1
        assert small.gain_frequency > 1.2 * data["bandwidth"]["gain_frequency"][0][0]
        assert small.rise_up < small.rise_down < data["bandwidth"]["rise_down"][0][0]
        assert small.rise_up < data["bandwidth"]["rise_up"][0][0]


def result_with_points(outcome: str = "done") -> LimitsResult:
    """Return a result with constructed points."""
    plan = limits_plan(
        replace(valve_circuit(), title="a valve"),
        volumes=["1 l", "2 l"],
        amplitudes=["5 kPa", "50 kPa"],
        springs=[1.0],
        dampings=[1.0, 2.0],
    )
    gains = dict.fromkeys((*PARTS, "load volume"), 1.0)
    points = {
        (1e-3, 5e3): BandwidthPoint(40.0, 50.0, 0.01, 0.02, 0.1, gains | {"solenoids": 2.5}, "solenoids"),
        (1e-3, 5e4): BandwidthPoint(math.inf, math.inf, 0.01, math.nan, 0.1, {}, ""),
        (2e-3, 5e3): BandwidthPoint(
            20.0, 25.0, 0.03, 0.04, 0.1, gains | {"load volume": 3.0, "poppet": 2.0}, "load volume"
        ),
        (2e-3, 5e4): BandwidthPoint(2.0, 3.0, 0.2, 0.3, 0.1, gains, "controller"),
    }
    calm = Stability(-20.0 + 300.0j, True, "decays", 0.0, math.nan, 400.0, 2.0, True, Note("limits.hunts", points=None))
    hums = Stability(90.0 + 1800.0j, False, "oscillates", 200.0, 280.0, 500.0, 270.0, True)
    stability = {(1.0, 1.0, 1e-3): hums, (1.0, 1.0, 2e-3): calm, (1.0, 2.0, 1e-3): calm}
    return LimitsResult(plan, points, stability, outcome)


class TestResult:
    def test_findings_name_the_parts(self):
        facts = {(note.code, note.address): note.facts for note in result_with_points().findings}
        solenoids, load = (facts["limits.part", name] for name in ("solenoids", "load volume"))
        assert (solenoids["count"], solenoids["known"], solenoids["gain"]) == (1, 3, 2.5)
        assert (solenoids["volumes"], solenoids["amplitudes"], solenoids["best"]) == ((1e-3,), (5e3,), (1e-3, 5e3))
        assert (load["count"], load["gain"]) == (1, 3.0)
        assert facts["limits.controller", ""]["amplitudes"] == (5e4,)
        assert facts["limits.agreement", ""] == {"count": 3, "known": 3}
        unstable = facts["limits.unstable", ""]
        assert (unstable["count"], unstable["largest"], unstable["frequency"]) == (1, 1e-3, 280.0)
        assert unstable["pole"] == pytest.approx(1800.0 / (2.0 * math.pi))
        assert facts["limits.hunts", ""]["points"] == 2

    def test_findings_as_text(self):
        text = " ".join(map(str, result_with_points().findings))
        assert (
            "The solenoids limit the bandwidth of the valve at 1 of 3 evaluated points (outlet volumes 1 l, amplitudes"
            in text
        )
        assert "The load volume limits the bandwidth of the valve at 1 of 3 evaluated points" in text
        assert "permit a slow oscillation (hunting). This is the case at 2 points." in text

    @pytest.mark.parametrize("suffix", ["toml", "json"])
    def test_saved_result_is_readable(self, tmp_path, suffix):
        path = tmp_path / f"result.{suffix}"
        result_with_points().save(path)
        text = path.read_text(encoding="utf-8")
        data = tomllib.loads(text) if suffix == "toml" else json.loads(text)
        assert data["method"] == "limits"
        assert data["conditions"]["volumes"] == [1e-3, 2e-3]
        assert data["bandwidth"]["limiting"] == [["solenoids", ""], ["load volume", "controller"]]
        assert data["bandwidth"]["gain_frequency"][0][0] == 40.0
        assert float(data["bandwidth"]["gain_frequency"][0][1]) == math.inf
        assert data["ideal"]["solenoids"][0][0] == 2.5
        assert data["stability"]["spring 1"]["is_stable"] == [[False, True], [True, False]]
        assert data["stability"]["spring 1"]["growth"][0] == [90.0, -20.0]
        assert data["stability"]["spring 1"]["word"][0] == ["", str(Note("limits.hunts", points=None))]
        assert [table["code"] for table in data["codes"]] == [note.code for note in result_with_points().findings]

    def test_report_is_complete_and_has_findings(self, tmp_path):
        pytest.importorskip("matplotlib")
        from poppet.report.bench.limits_report import write_limits

        page = write_limits(result_with_points("interrupted"), tmp_path / "page.html").read_text(encoding="utf-8")
        assert page.count("<svg") == 5
        needs_nothing_else(page)
        assert "a valve: dynamic limits" in page
        assert "Interrupted: missing points are grey." in page
        assert "The solenoids limit the bandwidth of the valve at 1 of 3 evaluated points" in page
        with pytest.raises(InputError) as caught:
            write_limits(result_with_points(), tmp_path / "page.pdf")
        assert caught.value.code == "files.suffix"

    def test_report_without_stability(self):
        pytest.importorskip("matplotlib")
        from poppet.report.bench.limits_report import limits_page

        page = limits_page(replace(result_with_points(), stability={}))
        assert page.count("<svg") == 3
        assert "<h2>Stability" not in page

    def test_report_has_tables_of_the_maps(self):
        pytest.importorskip("matplotlib")
        from poppet.report.bench.limits_report import limits_page

        page = limits_page(result_with_points())
        rows = [re.findall(r"<td[^>]*>(.*?)</td>", row) for row in re.findall(r"<tr>(.*?)</tr>", page)]
        assert ["1 l, 5 kPa", "40", "50", "10", "20", "10", "solenoids"] in rows
        assert ["1 l, 50 kPa", "&gt; 400", "&gt; 400", "10", "-", "10", "-"] in rows
        assert ["x 1, x 1, 1 l", "90", "280 Hz", "500", "270"] in rows

    def test_cells_name_the_second_limit_after_the_load(self):
        pytest.importorskip("matplotlib")
        from poppet.report.bench.limits_report import bandwidth_figure

        texts = {text.get_text() for text in bandwidth_figure(result_with_points()).axes[0].texts}
        assert {"40", "solenoids", "> 400", "load, poppet", "controller"} <= texts


def test_interruption_keeps_completed_points(monkeypatch):
    point = next(iter(result_with_points().points.values()))
    calls = []

    def found(plan, volume, amplitude, guess=None):
        calls.append(guess)
        if len(calls) == 3:
            raise KeyboardInterrupt
        return point

    monkeypatch.setattr(room, "bandwidth_point", found)
    progress_calls = []
    result = find_limits(result_with_points().plan, lambda *progress: progress_calls.append(progress))
    assert result.outcome == "interrupted"
    assert list(result.points) == [(1e-3, 5e3), (1e-3, 5e4)]
    assert calls == [None, 40.0, None]
    assert progress_calls[0] == (0, 8, "bandwidth at 1 l, 5 kPa")
    assert progress_calls[-1] == (2, 8, "done")
    assert math.isnan(result.content()["bandwidth"]["gain_frequency"][1][0])


class TestCommand:
    def test_command_writes_result_and_report(self, command_run):
        assert command_run.code == 0
        assert "-3 dB [Hz]" in command_run.out
        assert "60 kPa" in command_run.out
        data = tomllib.loads((command_run.folder / "r.toml").read_text(encoding="utf-8"))
        assert data["outcome"] == "done"
        assert data["bandwidth"]["limiting"][0][0] in (*PARTS, "load volume", "controller")
        assert data["stability"]["spring 1"]["agrees"] == [[True]]
        assert (command_run.folder / "r.html").stat().st_size > 20_000

    @pytest.mark.parametrize(
        ("options", "said"),
        [
            (("--springs", "1, two"), "--springs 1, two must be a list of numbers"),
            (("--valve", "vavle"), "Did you mean valve?"),
            (("-o", "r.csv"), "is not a supported format"),
        ],
    )
    def test_invalid_options_are_rejected(self, tmp_path, capsys, options, said):
        (tmp_path / "valve.toml").write_text(FILE)
        assert run(["bench", "limits", str(tmp_path / "valve.toml"), *options]) == 2
        assert said in capsys.readouterr().err

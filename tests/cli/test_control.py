"""Tests of `poppet control`: tune, compare, invalid input."""

from __future__ import annotations

import json
import re
import shlex
import shutil
import tomllib
import zipfile
from pathlib import Path

import numpy as np
import pytest

from first_hours.test_control_engineer import T, plant_by_hand
from pages import lines, plots
from poppet import load
from poppet.control import Gains, margins, plant_of, schedule, tune
from poppet.core.units import quantity

EXAMPLES = Path(__file__).parents[2] / "examples"


@pytest.fixture
def files(tmp_path):
    """The three examples with short names."""
    for name, suffix in {"pid": "", "scheduled": "_scheduled", "law": "_linearising"}.items():
        shutil.copy(EXAMPLES / f"pressure_control{suffix}.toml", tmp_path / f"{name}.toml")
    return "pid.toml", "scheduled.toml", "law.toml"


def test_tune_writes_gains_for_the_circuit(poppet, files, tmp_path):
    code, out, err = poppet("control", "tune", "pid.toml", "--at", "3 bar", "--sensitivity", "1.6", "-o", "gains.toml")
    assert (code, err) == (0, "")
    assert "phase margin [deg]" in out
    assert "3 bar, vent" in out
    gains = tomllib.loads((tmp_path / "gains.toml").read_text(encoding="utf-8"))["parts"]["regulator"]
    changes = [f"--set=regulator.{name}={value}" for name, value in gains.items()]
    assert poppet("simulate", "pid.toml", *changes, "--quiet").code == 0
    out = poppet("control", "tune", "pid.toml", "--at", "3 bar", "--sensitivity", "1.6", "--with", "gains.toml").out
    tables = re.split(r"With the gains of pid.toml and --with:\n", out)
    rows = [[line for line in table.splitlines() if line.startswith("3 bar, ")] for table in tables]
    assert rows[0] == rows[1]


@pytest.mark.parametrize(("factor", "is_stable"), [(1.0, True), (40.0, False)])
def test_gains_that_tune_computes_have_a_table_and_a_note(poppet, files, factor, is_stable):
    gains = {"gain": f"{5.0 * factor:g} 1/bar", "integral_time": "80 ms", "vent_factor": "1.5"}
    changes = [f"--set=regulator.{name}={value}" for name, value in gains.items()]
    code, out, err = poppet("control", "tune", "pid.toml", "--at", "3 bar", *changes)
    assert code == 0
    assert "regulator.gain: the tuner computes this parameter" in err
    assert "on regulator.integral_time, regulator.vent_factor" in err
    second = out.split("With the gains of pid.toml and --set:")[1]
    # The same loops by the matrices of the plant, with the vent factor of the file.
    plant = plant_of(load("pid.toml"))
    point = plant.operating_point("3 bar")
    own = Gains(5e-5 * factor, 0.08, 0.0, 5e-3)
    for side, vent_factor in (("fill", 1.0), ("vent", 1.5)):
        loop = margins(plant.sampled(point, side, vent_factor), own)
        assert loop.is_stable == is_stable
        row = f"3 bar, {side}" + ("" if is_stable else ": unstable")
        cells = next(line for line in second.splitlines() if line.startswith(row))[len(row) :].split()
        if is_stable:
            expected = [loop.sensitivity, loop.complementary, loop.gain_margin]
            assert [float(cell) for cell in cells[:3]] == pytest.approx(expected, rel=1e-3)
        else:
            assert {*cells} == {"-"}


COLUMNS = {
    "pressure": [1.5e5, 3.5e5, 6e5],
    "gain": [4e-5, 9e-5, 6e-5],
    "integral_time": [0.15, 0.06, 0.09],
    "vent_factor": [3.0, 2.0, 1.2],
}
"""Schedule of the file, in SI."""
ROW = re.compile(r"^(\d) bar, (fill|vent)((?: +[\d.]+){6})$", re.MULTILINE)


@pytest.mark.parametrize("options", [("--schedule",), ()])
@pytest.mark.parametrize("is_scheduled", [True, False])
def test_margins_with_the_gains_of_the_file_at_each_operating_point(poppet, options, is_scheduled):
    """They are those of python-control for a plant by hand, with a schedule in the file or with constant gains."""
    control = pytest.importorskip("control", reason="python-control is not installed")
    assert poppet("new", "pressure-control").code == 0
    text = Path("pressure-control.toml").read_text(encoding="utf-8")
    columns = (
        COLUMNS
        if is_scheduled
        else {"pressure": [2e5], "gain": [9.21e-5], "integral_time": [71e-3], "vent_factor": [2.0]}
    )
    if is_scheduled:
        text, count = re.subn(r"^(gain|integral_time|vent_factor) = .*\n", "", text, flags=re.MULTILINE)
        assert count == 3
        table = "".join(f"{name} = {values}\n" for name, values in COLUMNS.items())
        text = text.replace("[connections]", f"[parts.regulator.schedule]\n{table}\n[connections]")
    Path("plant.toml").write_text(text, encoding="utf-8")
    code, out, err = poppet("control", "tune", "plant.toml", *options, "--report", "tuning.html")
    assert (code, err) == (0, "")
    rows = ROW.findall(out.split("With the gains of plant.toml:\n")[1])
    assert len(rows) == 8
    page = Path("tuning.html").read_text(encoding="utf-8")
    assert "With the gains of plant.toml:" in page
    magnitudes = lines(plots(page)[0]).items()
    curves = {name.split(": ")[1]: curve for name, curve in magnitudes if name.startswith("magnitude")}
    omega = 2.0 * np.pi * np.geomspace(0.1, 249.9, 6000)
    for pressure, side, cells in rows:
        names = "gain", "integral_time", "vent_factor"
        gain, integral_time, vent_factor = (
            np.interp(1e5 * float(pressure), columns["pressure"], columns[name]) for name in names
        )
        plant, delay = plant_by_hand(control, 1e5 * float(pressure), side)
        law = control.tf([gain, gain * (T / integral_time - 1.0)], [1.0, -1.0], T)
        sign = 1.0 if side == "fill" else -vent_factor
        loop = control.frequency_response(sign * plant * control.ss(delay) * control.ss(law), omega).complex.ravel()
        gain_margin, phase_margin, *_, crossover, _ = control.stability_margins(control.frd(loop, omega))
        sensitivity, complementary = (float(np.max(np.abs(v))) for v in (1.0 / (1.0 + loop), loop / (1.0 + loop)))
        expected = [sensitivity, complementary, gain_margin, phase_margin, crossover / (2.0 * np.pi)]
        found = [float(cell) for cell in cells.split()]
        assert [*found[:4], found[5]] == pytest.approx(expected, rel=5e-3), (pressure, side)
        assert all(cell in page for cell in cells.split())
        # The dashed line in the Bode plot of the report.
        frequency, level = curves[f"{pressure} bar, {side}, present gains"]
        decibels = np.interp(np.log(frequency), np.log(omega / (2.0 * np.pi)), 20.0 * np.log10(np.abs(loop)))
        is_inside = (frequency > 0.2) & (frequency < 200.0)
        assert np.max(np.abs(level - decibels)[is_inside]) < 0.05


def test_tune_reports_the_bounded_plant_with_a_leak(poppet, files):
    leak = '[parts.leak]\nkind = "orifice"\nfrom = "tank"\nto = "ambient"\nsonic_conductance = "0.001 dm^3/(s bar)"\n'
    text = Path("pid.toml").read_text(encoding="utf-8")
    Path("pid.toml").write_text(text + leak + "critical_ratio = 0.35\n", encoding="utf-8")
    strong = '--set=vent.sonic_conductance="5 dm^3/(s bar)"'
    code, out, err = poppet("control", "tune", "pid.toml", "--at", "5 bar", "--form", "p", strong)
    assert (code, err) == (0, "")
    for phrase in ("5 bar, fill", "5 bar, vent", "Ms, Mt <= 1.4 filling and venting at 5 bar", "0.00172", "pid.toml"):
        assert phrase in out
    assert float(out.split("vent_factor = ")[1].split()[0]) == pytest.approx(0.116, abs=2e-3)


def test_tune_reproduces_the_gains_of_the_examples(poppet, files, tmp_path):
    """The numbers in the example files are those that the command in their comments prints."""
    assert poppet("control", "tune", "pid.toml", "-o", "fixed.toml").code == 0
    assert poppet("control", "tune", "pid.toml", "--schedule", "-o", "table.toml").code == 0
    fixed, table = (
        tomllib.loads((tmp_path / name).read_text())["parts"]["regulator"] for name in ("fixed.toml", "table.toml")
    )
    assert quantity(fixed["gain"], "1/Pa").value == pytest.approx(9.21e-5, rel=5e-3)
    assert quantity(fixed["integral_time"], "s").value == pytest.approx(71e-3, rel=5e-3)
    assert fixed["setpoint_weight"] == 0.0
    assert fixed["vent_factor"] == pytest.approx(2.0, rel=5e-3)
    assert table["setpoint_weight"] == 0.4
    for name, unit, values in (
        ("pressure", "Pa", [2e5, 3e5, 4e5, 5e5]),
        ("gain", "1/Pa", [1.1e-4, 1.13e-4, 1.19e-4, 1.35e-4]),
        ("integral_time", "s", [43e-3, 44.5e-3, 44.5e-3, 44.5e-3]),
        ("vent_factor", "1", [3.6, 2.32, 1.65, 1.16]),
    ):
        column = [quantity(value, unit).value for value in table["schedule"][name]]
        assert column == pytest.approx(values, rel=1e-2)


def test_the_command_of_the_docs_for_a_valve_without_its_overlap(poppet):
    """The overlap of the example is refused on the linear model, with what to do; without it there are gains."""
    command = next(
        line.strip().strip("`.").split("`")[-1]
        for line in (EXAMPLES.parent / "docs" / "control.md").read_text(encoding="utf-8").splitlines()
        if "--set valve.overlap=0" in line
    )
    arguments = [argument.replace("examples", str(EXAMPLES)) for argument in shlex.split(command)[1:]]
    code, out, err = poppet(*arguments)
    assert code == 0
    assert "note: slide.friction: the lugre friction" in err
    assert "100 mm, command" in out
    refused = poppet(*arguments[: arguments.index("--set")])
    assert refused.code == 2
    assert "--amplitude" in refused.err


def test_a_loop_is_tuned_for_responses_to_sines(poppet, tmp_path):
    """Without an integral part, the body stops at an offset; the verification and a note report this."""
    shutil.copy(EXAMPLES / "position_control.toml", tmp_path)
    sines = "--form", "p", "--at", "100 mm", "--amplitude", "0.1", "--report", "page.html", "-o", "gains.toml"
    code, out, err = poppet("control", "tune", "position_control.toml", *sines)
    assert code == 0
    assert err.startswith("note: position (100 mm, sines of 0.1): the step response does not settle")
    present, step = [line for line in out.splitlines() if line.startswith("100 mm, sines of 0.1")][1:]
    assert "With the gains of position_control.toml:" in out.split(present)[0]
    assert "never" in step
    gains = tomllib.loads((tmp_path / "gains.toml").read_text())["parts"]["position"]
    assert float(step.split()[5]) == pytest.approx(100.0 / quantity(gains["gain"], "1/m").value, rel=2e-3)
    page = (tmp_path / "page.html").read_text(encoding="utf-8")
    assert "step there and back" in page
    assert all(cell.strip() in page for cell in present.split("  "))


def test_a_position_loop_is_tuned_and_compared_in_millimetres(poppet, tmp_path):
    """The gains are those of the example, a note on friction beside them; a unit of something else is refused."""
    for name in ("position_control.toml", "position_control_banded.toml"):
        shutil.copy(EXAMPLES / name, tmp_path)
    code, out, err = poppet("control", "tune", "position_control.toml", "-o", "gains.toml")
    assert code == 0
    assert "note: slide.friction: the lugre friction" in err
    for text in ("60 mm, command", "140 mm, back", "at 60, 100, 140 mm, at rest"):
        assert text in out
    gains = tomllib.loads((tmp_path / "gains.toml").read_text())["parts"]["position"]
    example_gains = tomllib.loads((EXAMPLES / "position_control.toml").read_text())["parts"]["position"]
    for name, unit in (("gain", "1/m"), ("integral_time", "s")):
        assert quantity(gains[name], unit).value == pytest.approx(quantity(example_gains[name], unit).value, rel=5e-3)
    assert gains["setpoint_weight"] == example_gains["setpoint_weight"]
    names = "position_control.toml", "position_control_banded.toml"
    answer = poppet("control", "compare", *names, "--vary", "slide.mass=40 %", "--draws", "1", "-o", "figures.csv")
    assert (answer.code, answer.err) == (0, "")
    assert "IAE [mm s]" in answer.out
    assert "IAE [m s]" in (tmp_path / "figures.csv").read_text()
    refused = poppet("control", "tune", "position_control.toml", "--at", "2 bar")
    assert (refused.code, refused.errors[0][0]) == (2, "quantity.other_quantity")
    refused = poppet("simulate", "position_control.toml", "--set=position.gain=2 N/m")
    assert (refused.code, refused.errors[0][:2]) == (2, ("quantity.other_quantity", "position.gain"))


def test_compare_shows_nominal_median_and_worst(poppet, files, tmp_path):
    pytest.importorskip("matplotlib")
    answer = poppet(
        "control", "compare", *files, "--vary", "tank.volume=20 %", "--vary", "supply.pressure=0.1", "--draws", "3",
        "--seed", "1", "--plot", "spread.png", "-o", "figures.csv",
    )  # fmt: skip
    assert (answer.code, answer.err) == (0, "")
    for text in ("nominal", "median", "worst", "ITAE [bar s^2]", "3 sampled plants, seed 1", "scheduled", "law"):
        assert text in answer.out
    assert len((tmp_path / "figures.csv").read_text().splitlines()) == 1 + 3 * 4
    assert (tmp_path / "spread.png").stat().st_size > 20_000


def test_compare_without_uncertain_parameters(poppet, files):
    code, out, _ = poppet("control", "compare", "pid.toml", "law.toml")
    assert code == 0
    assert "--vary ADDRESS=RANGE makes them uncertain" in out
    assert "median" not in out


def test_a_failed_comparison_gives_exit_code_1(poppet, files):
    text = Path("pid.toml").read_text(encoding="utf-8")
    Path("pid.toml").write_text(text + 'stop_when = "tank.pressure > 4.5 bar"\n', encoding="utf-8")
    code, out, _ = poppet("control", "compare", "pid.toml")
    assert code == 1
    assert "pid: 1 runs did not reach their end" in out


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        (["tune", "pid.toml", "--draws", "3"], "cli.option.misplaced"),
        (["compare", "pid.toml", "--form", "pid"], "cli.option.misplaced"),
        (["tune", "pid.toml", "law.toml"], "cli.one_circuit"),
        (["tune", "law.toml"], "tuning.no_pid"),
        (["tune", "pid.toml", "--sensitivity", "9"], "fields.out_of_range"),
        (["tune", "pid.toml", "-o", "gains.csv"], "files.suffix"),
        (["tune", "pid.toml", "--amplitude", "2"], "fields.out_of_range"),
        (["tune", "pid.toml", "--amplitude", "2 N"], "quantity.other_quantity"),
        (["tune", "pid.toml", "--at", "3"], "quantity.no_unit"),
        (["compare", "pid.toml", "law.toml", "--amplitude", "0.1"], "cli.option.misplaced"),
        (["compare", "pid.toml", "pid.toml"], "cli.same_name"),
        (["compare", "pid.toml", "--vary", "tank.volume=2 kg"], "quantity.other_quantity"),
        (["compare", "pid.toml", "--vary", "tank.volume"], "cli.assignment"),
        (["polish", "pid.toml"], "cli.usage"),
    ],
)
def test_refusals(poppet, files, arguments, code):
    answer = poppet("control", *arguments)
    assert (answer.code, answer.codes) == (2, [code])


def test_both_actions_write_reports(poppet, files, tmp_path):
    pytest.importorskip("matplotlib")
    assert poppet("control", "tune", "pid.toml", "--at", "3 bar", "--report", "tuning.html").code == 0
    assert poppet("control", "compare", "pid.toml", "law.toml", "--report", "comparison.html").code == 0
    for name in ("tuning", "comparison"):
        assert 'class="plot-data"' in (tmp_path / f"{name}.html").read_text(encoding="utf-8")


@pytest.mark.parametrize("tuned", [(), ("--schedule",)])
def test_gains_are_accepted_by_every_command(poppet, tmp_path, tuned):
    """As if the circuit file had them, a schedule in place of a gain or the other way; an FMU carries them."""
    from poppet.deploy.fmu.importers import circuit_resources, read_circuit

    for name in ("pressure_control.toml", "pressure_control_scheduled.toml"):
        shutil.copy(EXAMPLES / name, tmp_path)
    assert poppet("control", "tune", "pressure_control.toml", *tuned, "-o", "gains.toml").code == 0
    tuning = (schedule if tuned else tune)(load(tmp_path / "pressure_control.toml"))

    def gains(circuit):
        numbers = circuit.parts["regulator"].parameters(circuit.surroundings)
        return {name: value for name, value in numbers.items() if name.partition(".")[0] in tuning.fields()}

    expected = gains(tuning.applied(load(tmp_path / "pressure_control.toml")))
    for name in ("pressure_control.toml", "pressure_control_scheduled.toml"):
        code, out, _ = poppet("show", name, "--with", "gains.toml", "--json")
        values_by_address = {entry["address"]: entry["value"] for entry in json.loads(out)["numbers"]}
        applied = {key: values_by_address[f"regulator.{key}"] for key in expected}
        assert code == 0
        assert applied == pytest.approx(expected, rel=1e-5)
        assert ("regulator.gain" in values_by_address) is not bool(tuned)
    with zipfile.ZipFile(tmp_path / "some.fmu", "w") as archive:
        text = (tmp_path / "pressure_control.toml").read_text()
        resources = circuit_resources(text, {"tank.volume": "2 l"}, str(tmp_path / "gains.toml"))
        for name, content in resources.items():
            archive.writestr(name, content)
    carried = read_circuit(tmp_path / "some.fmu")
    assert gains(carried) == pytest.approx(expected, rel=1e-5)
    assert carried.parts["tank"].volume.value == pytest.approx(2e-3)


@pytest.mark.parametrize(
    ("text", "code"),
    [
        ('[parts.regulator]\ngian = "2 1/bar"\n', "names.unknown"),
        ('[parts.controller]\ngain = "2 1/bar"\n', "address.no_owner"),
        ('[parts.regulator]\ngain = "2 bar"\n', "quantity.other_quantity"),
        ("[parts]\nregulator = 2\n", "circuit.no_part"),
        ("parts = 2\n", "circuit.no_part"),
        ('[parts.regulator]\ngain = "2 1/bar"\n\n[signals]\n', "fields.unknown"),
        ("[gains]\nregulator = 2\n", "result.unreadable"),
    ],
)
def test_a_parameter_file_without_matching_address_is_refused(poppet, tmp_path, text, code):
    (tmp_path / "gains.toml").write_text(text)
    answer = poppet("show", str(EXAMPLES / "pressure_control.toml"), "--with", "gains.toml")
    assert answer.code == 2
    assert code in answer.codes


def test_tune_draws_bode_plots_and_steps(poppet, files, tmp_path):
    pytest.importorskip("matplotlib")
    assert poppet("control", "tune", "pid.toml", "--at", "3 bar", "--plot", "loops.svg").code == 0
    assert (tmp_path / "loops.svg").read_text(encoding="utf-8").count('id="axes_') == 5

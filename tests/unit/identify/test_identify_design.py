"""Test design: predicted standard errors against closed forms and fits, selection of tests, invalid files."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from poppet import load
from poppet.identify import Design, identify_design, identify_fit, read_design_file
from refusals import refused

CIRCUIT = """
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
"""
CONDUCTANCE, RATIO = "outlet.sonic_conductance", "outlet.critical_ratio"
FREE = f'[free]\n"{CONDUCTANCE}" = "1e-8 m^3/(s Pa)"\n'
SENSORS = '[sensors]\n"tank.pressure" = { noise = "300 Pa" }\n'
TIME = 0.1 * np.arange(101)
DECAY = 1.185 * 287.05 * 293.15 / 10e-3
"""d(ln p)/dt over -C of choked isothermal discharge [Pa/m^3]."""


def compute_design(folder: Path, text: str) -> Design:
    (folder / "bench.toml").write_text(CIRCUIT)
    (folder / "design.toml").write_text(f'circuit = "bench.toml"\nsample_time = "0.1 s"\n{text}')
    return identify_design(folder / "design.toml")


def choked_sensitivity() -> np.ndarray:
    """Return dp/dC of choked discharge in closed form, divided by the noise."""
    return -DECAY * TIME * 16e5 * np.exp(-DECAY * 1e-8 * TIME) / 300.0


def test_standard_error_of_one_parameter_agrees_with_the_closed_form(tmp_path: Path) -> None:
    prediction = compute_design(tmp_path, FREE + SENSORS).together[CONDUCTANCE]
    assert 16e5 * math.exp(-DECAY * 1e-8 * 10.0) * 0.3 > 101325.0  # choked to the end
    expected = (np.sum(choked_sensitivity() ** 2) + 1e16) ** -0.5
    assert prediction.standard_error == pytest.approx(expected, rel=1e-4)
    assert prediction.verdict == "determined"


@pytest.mark.parametrize("start", ["", 'start = { "tank.initial_pressure" = "free" }\n'])
@pytest.mark.parametrize("offset", ["", ', offset = "2 kPa"'])
def test_nuisance_parameters_increase_the_standard_error(tmp_path: Path, start: str, offset: str) -> None:
    text = f'{start}{FREE}[sensors]\n"tank.pressure" = {{ noise = "300 Pa"{offset} }}\n'
    prediction = compute_design(tmp_path, text).together[CONDUCTANCE]
    columns = [choked_sensitivity()]
    priors = [1e-8**-2]
    if start:
        columns.append(np.exp(-DECAY * 1e-8 * TIME) / 300.0)
        priors.append(0.0)
    if offset:
        columns.append(np.full(TIME.size, 1.0 / 300.0))
        priors.append(2e3**-2)
    # The full covariance; the code eliminates the nuisance parameters.
    slopes = np.column_stack(columns)
    covariance = np.linalg.inv(slopes.T @ slopes + np.diag(priors))
    assert prediction.standard_error == pytest.approx(math.sqrt(covariance[0, 0]), rel=1e-3)


def test_predicted_standard_error_agrees_with_a_fit(tmp_path: Path) -> None:
    text = (
        'start = { "tank.initial_pressure" = "free" }\n[free]\n'
        f'"{CONDUCTANCE}" = "2e-8 m^3/(s Pa)"\n"{RATIO}" = 0.3\n'
        '[sensors]\n"tank.pressure" = { noise = "300 Pa" }\n[tests.long]\n'
        f'"{CONDUCTANCE}" = "2e-8 m^3/(s Pa)"\nduration = "60 s"\n'
    )
    predicted = compute_design(tmp_path, text).together
    circuit = load(tmp_path / "bench.toml").with_values({CONDUCTANCE: 2e-8})
    run = circuit.simulate(duration=60.0, output_step=0.1)
    pressure = run["tank.pressure"] + np.random.default_rng(5).normal(0.0, 300.0, run.time.size)
    np.savetxt(tmp_path / "a.csv", np.column_stack([run.time, pressure]), delimiter=",", header="t,p", comments="")
    (tmp_path / "fit.toml").write_text(
        'circuit = "bench.toml"\n[recordings.a]\nfile = "a.csv"\ntime = { column = "t", unit = "s" }\n'
        'start = { "tank.initial_pressure" = "free" }\n'
        '"tank.pressure" = { column = "p", unit = "Pa", noise = "300 Pa" }\n'
        f'[free]\n"{CONDUCTANCE}" = "1.9e-8 m^3/(s Pa)"\n"{RATIO}" = 0.25\n'
    )
    fitted = identify_fit(tmp_path / "fit.toml").parameters
    for name, p in predicted.items():
        # The fit estimates the noise from 601 samples.
        assert fitted[name].standard_error == pytest.approx(p.standard_error, rel=0.15), name


def test_complementary_tests_are_selected(tmp_path: Path) -> None:
    """A short test is always choked and does not determine b; a test from a low pressure hardly determines C."""
    text = (
        f'select = 2\n[free]\n"{CONDUCTANCE}" = "1e-8 m^3/(s Pa)"\n"{RATIO}" = 0.3\n{SENSORS}'
        '[tests.high]\n"tank.initial_pressure" = "20 bar"\n'
        '[tests.low]\n"tank.initial_pressure" = "2 bar"\n"tank.volume" = "5 l"\n'
        '[tests.idle]\n"tank.initial_pressure" = "1.02 bar"\n'
    )
    design = compute_design(tmp_path, text)
    assert sorted(design.chosen) == ["high", "low"]
    assert list(design.tests)[-1] == "idle"
    design_without_low = compute_design(
        tmp_path, text.replace("select = 2", 'criterion = "volume"').partition("[tests.low]")[0]
    )
    assert [(r.code, r.address) for r in design_without_low.remarks] == [("design.by_none", RATIO)]
    assert design.tests["high"][RATIO].verdict == "not determined"
    assert design.together[RATIO].standard_error < design.tests["low"][RATIO].standard_error
    assert not design.remarks


def test_parameters_that_no_test_determines_are_reported(tmp_path: Path) -> None:
    """The pressures do not change if C and V are multiplied by the same factor."""
    text = f'[free]\n"{CONDUCTANCE}" = "1e-8 m^3/(s Pa)"\n"tank.volume" = "10 l"\n{SENSORS}'
    text += '[vary]\nduration = ["5 s", "10 s"]\n"tank.initial_pressure" = ["4 bar", "8 bar"]\n'
    design = compute_design(tmp_path, text)
    assert len(design.tests) == 4
    assert [(r.code, r.address) for r in design.remarks] == [
        ("design.by_none", CONDUCTANCE),
        ("design.by_none", "tank.volume"),
    ]
    # The priors of both are 100 %, and the tests determine the ratio: the prior of the common factor is 100 %/sqrt(2).
    assert design.together["tank.volume"].standard_error == pytest.approx(10e-3 / math.sqrt(2.0), rel=1e-3)


def test_earlier_result_is_prior_information(tmp_path: Path) -> None:
    first = compute_design(tmp_path, FREE + SENSORS).together[CONDUCTANCE].standard_error
    (tmp_path / "known.toml").write_text(
        f'method = "fit"\ntitle = "before"\n[parameters."{CONDUCTANCE}"]\nvalue = 1e-8\nunit = "m^3/(s Pa)"\n'
        f'standard_error = {first!r}\nlow = 0.9e-8\nhigh = 1.1e-8\nverdict = "determined"\n'
    )
    second = compute_design(tmp_path, f'known = "known.toml"\n{FREE}{SENSORS}').together[CONDUCTANCE].standard_error
    assert second == pytest.approx(first / math.sqrt(2.0), rel=1e-3)


def test_samples_of_a_prior_show_dependent_predictions(tmp_path: Path) -> None:
    """It depends on b whether the flow is choked throughout the test."""
    text = (
        f'draws = 20\n[free]\n"{RATIO}" = {{ start = 0.35, prior = {{ mean = 0.35, sd = 0.1 }} }}\n{SENSORS}'
        '[tests.short]\nduration = "2 s"\n"tank.initial_pressure" = "2.8 bar"\n'
    )
    design = compute_design(tmp_path, text)
    assert design.together[RATIO].largest > 2.0 * design.together[RATIO].standard_error
    assert "design.depends" in [r.code for r in design.remarks]


def test_all_errors_are_reported_together(tmp_path: Path) -> None:
    text = f'selct = 2\n{FREE}[sensors]\n"tank.presure" = {{ noise = "300 Pa" }}\n"tank.pressure" = {{ lag = "1 s" }}\n'
    with refused("fields.unknown", "selct"):
        compute_design(tmp_path, text)
    with refused("names.unknown", "sensors.tank.presure") as caught:
        compute_design(tmp_path, text.replace("selct", "select"))
    assert [e.code for e in caught.value.problems] == ["names.unknown", "fields.missing"]


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (f"select = 0\n{FREE}{SENSORS}", "fields.out_of_range"),
        (f'criterion = "best"\n{FREE}{SENSORS}', "fields.not_an_option"),
        (f"{FREE}", "fields.missing"),
        (f"{SENSORS}", "fields.missing"),
        (f'{FREE}[sensors]\n"tank.pressure" = {{ noise = "1 Pa", drift = 1 }}\n', "fields.unknown"),
        (f'{FREE}{SENSORS}[vary]\n"tank.volume" = "2 l"\n', "design.no_list"),
        (f'{FREE}{SENSORS}[vary]\n"tank.volme" = ["2 l"]\n', "names.unknown"),
        (f'{FREE}{SENSORS}[tests.a]\nsensors = ["tank.temperature"]\n', "fields.not_an_option"),
        (f'{FREE}{SENSORS}[tests.a]\nstart = {{ "tank.initial_pressure" = "2 bar" }}\n', "design.start"),
        (f'{FREE}{SENSORS}[tests.a]\nduration = "-1 s"\n', "fields.out_of_range"),
        (f'{FREE}{SENSORS}[tests.a]\nsample_time = "1 us"\n', "design.too_many_samples"),
        (f'{FREE}[sensors]\n"tank.pressure" = {{ noise = "0 Pa" }}\n', "fields.out_of_range"),
        (f'{FREE}[sensors]\n"tank.pressure" = {{ noise = "1 Pa", lag = "-1 s" }}\n', "fields.out_of_range"),
        (f"{FREE}{SENSORS}[vary]\nduration = [{', '.join(map(str, range(1, 600)))}]\n", "design.too_many"),
    ],
)
def test_invalid_design_files_are_rejected(tmp_path: Path, text: str, code: str) -> None:
    with refused(code):
        compute_design(tmp_path, text)


def test_circuit_and_duration_are_required(tmp_path: Path) -> None:
    (tmp_path / "design.toml").write_text(FREE + SENSORS)
    with refused("fields.missing"):
        identify_design(tmp_path / "design.toml")
    (tmp_path / "bench.toml").write_text(CIRCUIT.partition("[run]")[0])
    (tmp_path / "design.toml").write_text(f'circuit = "bench.toml"\n{FREE}{SENSORS}')
    with refused("fields.missing"):
        identify_design(tmp_path / "design.toml")


def test_undetermined_parameters_differ_from_parameters_that_no_test_determines(tmp_path: Path) -> None:
    """Each test determines one of the two parameters, and only one test is selected."""
    text = (
        f'[free]\n"{CONDUCTANCE}" = {{ start = "1e-8 m^3/(s Pa)" }}\n"{RATIO}" = 0.3\n{SENSORS}'
        '[tests.high]\n"tank.initial_pressure" = "20 bar"\n[tests.low]\n"tank.initial_pressure" = "2 bar"\n'
        '"tank.volume" = "5 l"\n'
    )
    design = compute_design(tmp_path, text.replace("300 Pa", "30 Pa") + 'duration = "1 s"\n')
    assert design.chosen == ("high",)
    assert [r.code for r in design.remarks] == ["design.still_open"]


def test_design_file_has_the_content_of_the_design(tmp_path: Path) -> None:
    from poppet.core.toml_file import TomlFile

    design = compute_design(tmp_path, FREE + SENSORS)
    design.save(tmp_path / "found.toml")
    written = TomlFile.read(tmp_path / "found.toml").tables
    assert written["chosen"] == ["the test"]
    assert written["together"][CONDUCTANCE]["standard_error"] == design.together[CONDUCTANCE].standard_error
    assert read_design_file(tmp_path / "design.toml").candidates[0].duration == 10.0


def test_interrupted_design_keeps_the_evaluated_tests(tmp_path: Path) -> None:
    compute_design(tmp_path, f'{FREE}{SENSORS}[vary]\nduration = ["5 s", "10 s"]\n')

    def stop(done: int, total: int, name: str) -> None:
        if done == 1:
            raise KeyboardInterrupt

    design = identify_design(tmp_path / "design.toml", progress=stop)
    assert design.interrupted
    assert list(design.tests) == ["duration 5 s"]

"""Test design: predicted standard errors against closed forms and fits, selection of tests, invalid files."""

from __future__ import annotations

import math
from pathlib import Path

import numpy as np
import pytest

from poppet import load
from poppet.identify import Design, Prediction, identify_design, identify_fit, read_design_file
from poppet.report.identification.design_report import design_text
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
        (f'{FREE}[sensors]\n"tank.pressure" = {{ noise = "1 Pa", offset = "often" }}\n', "quantity.no_number"),
        (f"fits = -1\n{FREE}{SENSORS}", "fields.out_of_range"),
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


RANKED = (
    f'seed = 3\n[free]\n"{CONDUCTANCE}" = {{ start = "1e-8 m^3/(s Pa)", '
    'prior = { mean = "1e-8 m^3/(s Pa)", sd = "3e-9 m^3/(s Pa)" } }\n'
    f'"{RATIO}" = {{ start = 0.3, prior = {{ mean = 0.3, sd = 0.1 }} }}\n'
    f'[sensors]\n"tank.pressure" = {{ noise = "300 Pa", offset = "1 kPa" }}\n'
    '[vary]\n"tank.volume" = ["2 l", "3 l", "5 l", "8 l", "12 l", "20 l"]\nduration = ["8 s", "20 s"]\n'
)


@pytest.mark.parametrize("criterion", ["intervals", "worst"])
def test_ranking_agrees_with_the_printed_table(tmp_path: Path, criterion: str) -> None:
    design = compute_design(tmp_path, f'criterion = "{criterion}"\nfits = 0\n{RANKED}')
    combine = np.max if criterion == "worst" else lambda row: np.exp(np.mean(np.log(row)))
    rows = {
        test: [100.0 * 1.96 * row[name].typical / start for name, start in ((CONDUCTANCE, 1e-8), (RATIO, 0.3))]
        for test, row in design.tests.items()
    }
    for test, value in design.ranked_by().items():
        assert value == pytest.approx(combine(rows[test]), rel=1e-9), test
    assert list(design.ranked_by().values()) == sorted(design.ranked_by().values())
    assert design.chosen == (next(iter(design.tests)),)
    # The terminal shows the same values, in the same order, and names the criterion.
    text = design_text(design)
    assert "The criterion is the " in text
    lines = text.splitlines()
    heading = next(k for k, line in enumerate(lines) if line.startswith("test") and "criterion [%]" in line)
    printed = [[float(cell) for cell in line.split()[-3:]] for line in lines[heading + 1 : heading + 1 + len(rows)]]
    for cells, (test, row) in zip(printed, rows.items(), strict=True):
        assert cells == pytest.approx([*row, design.ranked_by()[test]], rel=0.06), test


def test_errors_at_the_assumed_values_can_contradict_the_mean_over_the_priors(tmp_path: Path) -> None:
    """Rank by the mean over the priors; a table of errors at the assumed values only would have another order."""
    design = compute_design(tmp_path, f"fits = 0\n{RANKED}")
    at_assumed = [float(np.mean(np.log([p.standard_error for p in row.values()]))) for row in design.tests.values()]
    assert at_assumed[0] > min(at_assumed)
    assert all(p.standard_error <= p.largest for row in design.tests.values() for p in row.values())


def test_criterion_of_the_joint_region_is_a_mean_of_semi_axes(tmp_path: Path) -> None:
    design = compute_design(tmp_path, f'criterion = "volume"\nfits = 0\n{FREE}{SENSORS}')
    p = design.together[CONDUCTANCE]
    assert design.ranked_by() == {"the test": pytest.approx(100.0 * 1.96 * p.standard_error / 1e-8, rel=1e-9)}


def test_free_offset_without_prior_is_eliminated(tmp_path: Path) -> None:
    free = '[sensors]\n"tank.pressure" = { noise = "300 Pa", offset = "free" }\n'
    prediction = compute_design(tmp_path, f"fits = 0\n{FREE}{free}").together[CONDUCTANCE]
    slopes = np.column_stack([choked_sensitivity(), np.full(TIME.size, 1.0 / 300.0)])
    covariance = np.linalg.inv(slopes.T @ slopes + np.diag([1e16, 0.0]))
    assert prediction.standard_error == pytest.approx(math.sqrt(covariance[0, 0]), rel=1e-3)


def test_simulated_fits_agree_with_the_prediction_if_there_is_one_optimum(tmp_path: Path) -> None:
    design = compute_design(tmp_path, f"select = 2\nfits = 3\n{RANKED}")
    for name, p in design.together.items():
        fitted = design.simulated[name]
        assert (fitted.fits, fitted.determined, fitted.verdict) == (3, 3, "determined"), name
        assert fitted.standard_error == pytest.approx(p.standard_error, rel=0.15), name
        assert fitted.deviation < 4.0 * p.standard_error, name
    assert "design.fits_differ" not in [r.code for r in design.remarks]
    assert "simulated fits" in design_text(design)


CHARGE = """
[parts.supply]
kind = "reservoir"
pressure = "8 bar"
[parts.tank]
kind = "chamber"
volume = "10 l"
initial_pressure = "1 bar"
wall_conductance = "1 mW/K"
[parts.valve]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "1e-8 m^3/(s Pa)"
critical_ratio = 0.3
[run]
duration = "8 s"
"""


def test_simulated_fits_find_the_other_optimum_of_an_adiabatic_charge(tmp_path: Path) -> None:
    """The sensitivities at the assumed values do not show that an isothermal tank has the same pressure."""
    (tmp_path / "bench.toml").write_text(CHARGE)
    (tmp_path / "design.toml").write_text(
        'circuit = "bench.toml"\nsample_time = "0.04 s"\nfits = 3\nstart = { "tank.initial_pressure" = "free" }\n'
        "[free]\n"
        '"valve.sonic_conductance" = "1e-8 m^3/(s Pa)"\n"valve.critical_ratio" = 0.3\n'
        '"tank.wall_conductance" = "1 mW/K"\n[sensors]\n"tank.pressure" = { noise = "1 kPa", offset = "1 kPa" }\n'
    )
    design = identify_design(tmp_path / "design.toml")
    assert design.together["valve.sonic_conductance"].verdict == "determined"
    assert design.simulated["valve.sonic_conductance"].verdict == "weak"
    remark = next(r for r in design.remarks if r.code == "design.fits_differ")
    assert (remark.address, remark.facts["determined"]) == ("valve.sonic_conductance", 0)
    assert remark.facts["times"] > 50.0


def test_fits_are_not_simulated_with_an_earlier_result(tmp_path: Path) -> None:
    (tmp_path / "known.toml").write_text(
        f'method = "fit"\ntitle = "before"\n[parameters."{CONDUCTANCE}"]\nvalue = 1e-8\nunit = "m^3/(s Pa)"\n'
        'standard_error = 1e-10\nlow = 0.9e-8\nhigh = 1.1e-8\nverdict = "determined"\n'
    )
    assert compute_design(tmp_path, f'known = "known.toml"\n{FREE}{SENSORS}').simulated == {}
    assert compute_design(tmp_path, FREE + SENSORS).simulated[CONDUCTANCE].fits == 5


def test_interruption_of_the_simulated_fits_keeps_the_ranking(tmp_path: Path) -> None:
    compute_design(tmp_path, f"fits = 0\n{FREE}{SENSORS}")
    (tmp_path / "design.toml").write_text((tmp_path / "design.toml").read_text().replace("fits = 0", "fits = 4"))

    def stop(done: int, total: int, name: str) -> None:
        if "simulated" in name and done == 1:
            raise KeyboardInterrupt

    design = identify_design(tmp_path / "design.toml", progress=stop)
    assert design.interrupted
    assert list(design.tests) == ["the test"]
    assert design.simulated == {}


def test_former_names_of_half_widths_give_a_warning() -> None:
    prediction = Prediction(1.0, "m^3", 0.1, 0.2, 0.3, "determined")
    with pytest.warns(DeprecationWarning, match="typical_half_width"):
        assert getattr(prediction, "half_typical") == prediction.typical_half_width  # noqa: B009
    with pytest.warns(DeprecationWarning, match="largest_half_width"):
        assert getattr(prediction, "half_at_most") == prediction.largest_half_width  # noqa: B009
    assert not hasattr(prediction, "half_best")

"""`identify design`: predicted errors against closed forms and real fits, the choice of tests, what is refused."""

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


def designed(folder: Path, text: str) -> Design:
    (folder / "bench.toml").write_text(CIRCUIT)
    (folder / "design.toml").write_text(f'circuit = "bench.toml"\nsample_time = "0.1 s"\n{text}')
    return identify_design(folder / "design.toml")


def slope_of_choked() -> np.ndarray:
    """dp/dC of the closed form, over the noise."""
    return -DECAY * TIME * 16e5 * np.exp(-DECAY * 1e-8 * TIME) / 300.0


def test_the_error_of_one_number_in_closed_form(tmp_path: Path) -> None:
    found = designed(tmp_path, FREE + SENSORS).together[CONDUCTANCE]
    assert 16e5 * math.exp(-DECAY * 1e-8 * 10.0) * 0.3 > 101325.0  # choked to the end
    expected = (np.sum(slope_of_choked() ** 2) + 1e16) ** -0.5
    assert found.standard_error == pytest.approx(expected, rel=1e-4)
    assert found.verdict == "determined"


@pytest.mark.parametrize("start", ["", 'start = { "tank.initial_pressure" = "free" }\n'])
@pytest.mark.parametrize("offset", ["", ', offset = "2 kPa"'])
def test_what_has_to_be_learnt_besides_makes_it_larger(tmp_path: Path, start: str, offset: str) -> None:
    text = f'{start}{FREE}[sensors]\n"tank.pressure" = {{ noise = "300 Pa"{offset} }}\n'
    found = designed(tmp_path, text).together[CONDUCTANCE]
    columns = [slope_of_choked()]
    priors = [1e-8**-2]
    if start:
        columns.append(np.exp(-DECAY * 1e-8 * TIME) / 300.0)
        priors.append(0.0)
    if offset:
        columns.append(np.full(TIME.size, 1.0 / 300.0))
        priors.append(2e3**-2)
    # The whole covariance at once, where the code takes the nuisances out.
    slopes = np.column_stack(columns)
    covariance = np.linalg.inv(slopes.T @ slopes + np.diag(priors))
    assert found.standard_error == pytest.approx(math.sqrt(covariance[0, 0]), rel=1e-3)


def test_a_real_fit_has_the_error_that_was_predicted(tmp_path: Path) -> None:
    text = (
        'start = { "tank.initial_pressure" = "free" }\n[free]\n'
        f'"{CONDUCTANCE}" = "2e-8 m^3/(s Pa)"\n"{RATIO}" = 0.3\n'
        '[sensors]\n"tank.pressure" = { noise = "300 Pa" }\n[tests.long]\n'
        f'"{CONDUCTANCE}" = "2e-8 m^3/(s Pa)"\nduration = "60 s"\n'
    )
    predicted = designed(tmp_path, text).together
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
        # The fit scales with the scatter that it saw of 601 samples.
        assert fitted[name].standard_error == pytest.approx(p.standard_error, rel=0.15), name


def test_tests_that_complete_each_other_are_chosen(tmp_path: Path) -> None:
    """A short test is choked throughout and says nothing of b; one that begins low says little of C."""
    text = (
        f'select = 2\n[free]\n"{CONDUCTANCE}" = "1e-8 m^3/(s Pa)"\n"{RATIO}" = 0.3\n{SENSORS}'
        '[tests.high]\n"tank.initial_pressure" = "20 bar"\n'
        '[tests.low]\n"tank.initial_pressure" = "2 bar"\n"tank.volume" = "5 l"\n'
        '[tests.idle]\n"tank.initial_pressure" = "1.02 bar"\n'
    )
    found = designed(tmp_path, text)
    assert sorted(found.chosen) == ["high", "low"]
    assert list(found.tests)[-1] == "idle"
    alone = designed(tmp_path, text.replace("select = 2", 'criterion = "volume"').partition("[tests.low]")[0])
    assert [(r.code, r.address) for r in alone.remarks] == [("design.by_none", RATIO)]
    assert found.tests["high"][RATIO].verdict == "not determined"
    assert found.together[RATIO].standard_error < found.tests["low"][RATIO].standard_error
    assert not found.remarks


def test_what_no_test_tells_is_said(tmp_path: Path) -> None:
    """C and V scaled together leave every pressure as it is."""
    text = f'[free]\n"{CONDUCTANCE}" = "1e-8 m^3/(s Pa)"\n"tank.volume" = "10 l"\n{SENSORS}'
    text += '[vary]\nduration = ["5 s", "10 s"]\n"tank.initial_pressure" = ["4 bar", "8 bar"]\n'
    found = designed(tmp_path, text)
    assert len(found.tests) == 4
    assert [(r.code, r.address) for r in found.remarks] == [
        ("design.by_none", CONDUCTANCE),
        ("design.by_none", "tank.volume"),
    ]
    # Both are known to 100 % beforehand, and their ratio well: their common size is known to 1/sqrt(2).
    assert found.together["tank.volume"].standard_error == pytest.approx(10e-3 / math.sqrt(2.0), rel=1e-3)


def test_what_is_known_already_counts(tmp_path: Path) -> None:
    first = designed(tmp_path, FREE + SENSORS).together[CONDUCTANCE].standard_error
    (tmp_path / "known.toml").write_text(
        f'method = "fit"\ntitle = "before"\n[parameters."{CONDUCTANCE}"]\nvalue = 1e-8\nunit = "m^3/(s Pa)"\n'
        f'standard_error = {first!r}\nlow = 0.9e-8\nhigh = 1.1e-8\nverdict = "determined"\n'
    )
    second = designed(tmp_path, f'known = "known.toml"\n{FREE}{SENSORS}').together[CONDUCTANCE].standard_error
    assert second == pytest.approx(first / math.sqrt(2.0), rel=1e-3)


def test_values_drawn_from_a_prior_show_what_depends_on_them(tmp_path: Path) -> None:
    """From 3.6 bar the flow is choked for the whole test or not at its end, as b will have it."""
    text = (
        f'draws = 20\n[free]\n"{RATIO}" = {{ start = 0.35, prior = {{ mean = 0.35, sd = 0.1 }} }}\n{SENSORS}'
        '[tests.short]\nduration = "2 s"\n"tank.initial_pressure" = "2.8 bar"\n'
    )
    found = designed(tmp_path, text)
    assert found.together[RATIO].largest > 2.0 * found.together[RATIO].standard_error
    assert "design.depends" in [r.code for r in found.remarks]


def test_mistakes_are_told_at_once(tmp_path: Path) -> None:
    text = f'selct = 2\n{FREE}[sensors]\n"tank.presure" = {{ noise = "300 Pa" }}\n"tank.pressure" = {{ lag = "1 s" }}\n'
    with refused("fields.unknown", "selct"):
        designed(tmp_path, text)
    with refused("names.unknown", "sensors.tank.presure") as caught:
        designed(tmp_path, text.replace("selct", "select"))
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
def test_what_is_refused(tmp_path: Path, text: str, code: str) -> None:
    with refused(code):
        designed(tmp_path, text)


def test_a_circuit_is_named_and_lasts(tmp_path: Path) -> None:
    (tmp_path / "design.toml").write_text(FREE + SENSORS)
    with refused("fields.missing"):
        identify_design(tmp_path / "design.toml")
    (tmp_path / "bench.toml").write_text(CIRCUIT.partition("[run]")[0])
    (tmp_path / "design.toml").write_text(f'circuit = "bench.toml"\n{FREE}{SENSORS}')
    with refused("fields.missing"):
        identify_design(tmp_path / "design.toml")


def test_numbers_that_stay_open_are_told_apart_from_those_that_none_tells(tmp_path: Path) -> None:
    """Each test tells one of the two, and only one test is to be made."""
    text = (
        f'[free]\n"{CONDUCTANCE}" = {{ start = "1e-8 m^3/(s Pa)" }}\n"{RATIO}" = 0.3\n{SENSORS}'
        '[tests.high]\n"tank.initial_pressure" = "20 bar"\n[tests.low]\n"tank.initial_pressure" = "2 bar"\n'
        '"tank.volume" = "5 l"\n'
    )
    found = designed(tmp_path, text.replace("300 Pa", "30 Pa") + 'duration = "1 s"\n')
    assert found.chosen == ("high",)
    assert [r.code for r in found.remarks] == ["design.still_open"]


def test_written_as_it_was_found(tmp_path: Path) -> None:
    from poppet.core.toml_file import TomlFile

    found = designed(tmp_path, FREE + SENSORS)
    found.save(tmp_path / "found.toml")
    written = TomlFile.read(tmp_path / "found.toml").tables
    assert written["chosen"] == ["the test"]
    assert written["together"][CONDUCTANCE]["standard_error"] == found.together[CONDUCTANCE].standard_error
    assert read_design_file(tmp_path / "design.toml").candidates[0].duration == 10.0


def test_an_interrupted_look_keeps_what_it_has(tmp_path: Path) -> None:
    designed(tmp_path, f'{FREE}{SENSORS}[vary]\nduration = ["5 s", "10 s"]\n')

    def stop(done: int, total: int, name: str) -> None:
        if done == 1:
            raise KeyboardInterrupt

    found = identify_design(tmp_path / "design.toml", progress=stop)
    assert found.interrupted
    assert list(found.tests) == ["duration 5 s"]

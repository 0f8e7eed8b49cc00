"""Tests of `poppet identify`: methods on the examples, and invalid data."""

from __future__ import annotations

import dataclasses
import importlib.util
import json
import re
import shutil
import sys
import tomllib
from pathlib import Path

import numpy as np
import pytest

import poppet as house
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.identify import (
    Result,
    TankTest,
    free_parameter,
    identify_fit,
    identify_friction,
    identify_tank,
    read_result,
)
from poppet.identify.characteristic import characteristic_file
from poppet.identify.design import design_file
from poppet.identify.fit import fit_plan
from poppet.identify.fit.experiment import Experiment
from poppet.identify.flow import flow_file
from poppet.identify.friction import friction_file
from poppet.identify.muscle import muscle_file
from poppet.identify.tank.tank_plan import OWN
from poppet.timeseries.measurements import mapping
from result_keys import undocumented

ROOT = Path(__file__).parents[2]
EXAMPLES = ROOT / "examples" / "identify"
PAGES = [ROOT / "README.md", ROOT / "examples" / "README.md", *sorted((ROOT / "docs").glob("*.md"))]
PAGES = [*(ROOT / "docs").glob("identify*.md"), ROOT / "docs" / "fit_file.md"]
DOCUMENTS = {path.stem: path.read_text(encoding="utf-8") for path in PAGES}
WAYS = ("fit", "tank", "flow", "characteristic", "muscle", "friction")


@pytest.fixture
def bench(tmp_path):
    """The examples in a folder of their own, under the path they have in the repository."""
    folder = tmp_path / "examples" / "identify"
    shutil.copytree(EXAMPLES, folder, ignore=shutil.ignore_patterns("__pycache__"))
    return folder


def remarks(result: Result, code: str) -> list[Note]:
    return [note for note in result.remarks if note.code == code]


# What the documents show ------------------------------------------------------------------------------------------


def test_an_undocumented_key_is_detected():
    keys = {"aicc": 1.0, "new": 2.0}, {"loss": "linear", "old": 1}
    result = Result("fit", "a title", {}, comparison=keys[0], conditions=keys[1])
    assert undocumented(result) == ["comparison.new", "conditions.old"]


def test_the_documentation_shows_all_methods():
    methods = {
        method
        for page in PAGES
        for method in re.findall(r"poppet identify (\w+) examples", page.read_text(encoding="utf-8"))
    }
    assert methods == {*WAYS, "design"}


def test_shown_files_are_those_of_the_examples():
    """Each page shows the start of an example without some of its comments, or links to the example."""

    def without_comments(text: str) -> list[str]:
        lines = [re.sub(r"(^|\s+)#.*$", "", line) for line in text.splitlines()]
        return [line for line in lines if line]

    text = "".join(DOCUMENTS.values())
    blocks = [
        without_comments(block)
        for block in re.findall(r"^```toml\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)
        if block.startswith("title = ")
    ]
    examples = [without_comments(path.read_text(encoding="utf-8")) for path in EXAMPLES.glob("*.toml")]
    links = {name for name in ("muscle", "friction") if f"(../examples/identify/{name}.toml) contains" in text}
    assert len(blocks) + len(links) == len(WAYS) + 1  # and of a design
    assert [block for block in blocks if not any(example[: len(block)] == block for example in examples)] == []


def test_a_design_is_printed_and_written(poppet, tmp_path):
    paths = [str(tmp_path / f"design.{suffix}") for suffix in ("toml", "html")]
    code, out, _ = poppet("identify", "design", str(EXAMPLES / "design.toml"), "-o", paths[0], "--report", paths[1])
    assert code == 0
    written = tomllib.loads(Path(paths[0]).read_text())
    assert f"  1. {written['chosen'][0]}" in out
    # From 50 l at 8 bar the flow is choked throughout.
    assert (
        written["tests"]["volume 50 l, initial_pressure 8 bar, sensors pressure"]["outlet.critical_ratio"]["verdict"]
        == "not determined"
    )
    page = Path(paths[1]).read_text()
    assert all(name in page for name in written["tests"])


def page_of(method: str) -> str:
    """Return the text of the page of a method, without its code blocks."""
    page = DOCUMENTS["fit_file" if method == "fit" else f"identify_{method}"]
    return re.sub(r"^```.*?^```$", "", page, flags=re.MULTILINE | re.DOTALL)


@pytest.mark.parametrize(
    ("method", "names"),
    [
        ("fit", fit_plan.TOP_LEVEL),
        ("fit", (*mapping._FIELDS, *mapping._OF_CHANNEL, *mapping._OF_INPUT, "use", *free_parameter.FIELDS)),
        ("tank", tuple(f.name for f in dataclasses.fields(TankTest) if f.name != "folder")),
        ("tank", OWN),
        ("flow", (*flow_file.TOP_LEVEL, *flow_file.CHANNEL_FIELDS)),
        ("muscle", (*muscle_file.TOP_LEVEL, "column", "unit")),
        ("friction", (*friction_file.TOP_LEVEL, *friction_file.CHANNEL_FIELDS)),
        ("design", (*design_file.TOP_LEVEL, "noise", "offset", "lag")),
        ("characteristic", (*characteristic_file.TOP_LEVEL, *characteristic_file.OF_TEST)),
    ],
)
def test_every_field_is_documented(method, names):
    documented = set(re.findall(r"\w+", " ".join(re.findall(r"`([^`\n]+)`", page_of(method)))))
    assert [name for name in names if name not in documented] == []


# What the ways find -----------------------------------------------------------------------------------------------


def test_recordings_equal_the_output_of_their_script(tmp_path):
    spec = importlib.util.spec_from_file_location("make_data", EXAMPLES / "make_data.py")
    assert spec
    assert spec.loader
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    module.main(tmp_path)
    names = sorted(str(path.relative_to(EXAMPLES)) for path in EXAMPLES.rglob("*.csv"))
    assert names == sorted(str(path.relative_to(tmp_path)) for path in tmp_path.rglob("*.csv"))
    for name in names:
        stored, generated = (np.loadtxt(folder / name, delimiter=",", skiprows=1) for folder in (EXAMPLES, tmp_path))
        # Another processor may round a sample to the next step of the recorder.
        assert np.max(np.abs(generated - stored)) <= 0.11


TRUTH = {
    "fit": {
        "outlet.sonic_conductance": (1.1e-8, 1e-3),
        "outlet.critical_ratio": (0.35, 1e-2),
        "tank.wall_conductance": (6.0, 1e-2),
        "discharge.tank.temperature.lag": (0.8, 2e-2),
    },
    "tank": {"valve.sonic_conductance": (2.1e-8, 2e-3), "valve.critical_ratio": (0.28, 1e-2)},
    "flow": {"valve.sonic_conductance": (2.1e-8, 1e-2), "valve.critical_ratio": (0.28, 3e-2)},
    "friction": {
        "slide.friction.coulomb_force": (6.0, 1e-2),
        "slide.friction.static_force": (9.0, 2e-3),
        "slide.friction.stribeck_velocity": (8e-3, 1e-2),
        "slide.friction.viscous_coefficient": (40.0, 5e-2),
        "slide.friction.bristle_stiffness": (3e4, 5e-2),
        "drive.seal_friction": (8e-6, 2e-3),
    },
}


def test_findings_name_the_explain_command(poppet, bench):
    done = poppet("identify", "flow", str(bench / "flow.toml"), "-o", "result.toml")
    (line,) = [line for line in done.out.splitlines() if line.startswith("more: poppet explain ")]
    codes = line.split()[3:]
    assert 1 <= len(codes) <= 3
    assert set(codes) <= {remark.code for remark in read_result("result.toml").remarks}


@pytest.mark.parametrize("way", TRUTH)
def test_true_parameters_of_the_examples_are_identified(poppet, bench, way):
    code, out, err = poppet("identify", way, str(bench / f"{way}.toml"), "-o", "result.toml")
    result = read_result("result.toml")
    assert (code, err, result.method) == (0, "", way)
    for name, (truth, tolerance) in TRUTH[way].items():
        assert result.parameters[name].value == pytest.approx(truth, rel=tolerance)
        assert result.parameters[name].verdict == "determined"
        assert re.search(rf"^  {re.escape(name)} .* determined$", out, re.MULTILINE)


def test_an_identified_characteristic_is_used_in_a_circuit(poppet, bench):
    file = str(bench / "characteristic.toml")
    code, out, err = poppet("identify", "characteristic", file, "--library", "seat.toml")
    assert (code, err) == (0, "")
    assert "seat.toml: written." in out
    seat = house.Orifice(from_="ambient", to="tank", characteristic="seat.toml", stroke="0.4 mm").characteristic
    truth = house.library.characteristic("varga2012")
    for stroke in np.linspace(0.05e-3, 1e-3, 39):
        ratio = seat.sonic_conductance_at(stroke) / truth.sonic_conductance_at(stroke)
        assert ratio == pytest.approx(1.0, abs=0.01)
        assert seat.critical_ratio_at(stroke) == pytest.approx(truth.critical_ratio_at(stroke), abs=0.02)


def test_too_short_strokes_are_reported(bench):
    """The example has 12 samples per stroke at 80 mm/s."""
    (note,) = remarks(identify_friction(bench / "friction.toml"), "friction.short_strokes")
    assert note.facts["count"] == 8


def test_a_spline_reports_that_the_data_reject_its_constraint(poppet, bench):
    path = bench / "characteristic.toml"
    path.write_text(path.read_text().replace('"polynomial"', '"spline"'))
    code, out, _ = poppet("identify", "characteristic", str(path))
    assert code == 0
    assert "but the data contradict this constraint" in out


# Results and options ----------------------------------------------------------------------------------------------


def test_a_result_is_used_by_simulate(poppet, bench, tmp_path):
    assert poppet("identify", "fit", str(bench / "fit.toml"), "-o", "result.toml", "--quiet").out == ""
    data = tomllib.loads((tmp_path / "result.toml").read_text())
    assert {"method", "findings", "parameters", "residuals", "comparison", "conditions"} <= set(data)
    code, _, err = poppet("simulate", str(bench / "bench.toml"), "--with", "result.toml", "-o", "run.csv")
    assert (code, err) == (0, "")
    with_result = house.Recording.read("run.csv")["tank.pressure"]
    measured = np.loadtxt(bench / "discharge.csv", delimiter=",", skiprows=1)[:, 1] * 1e5 + 0.987e5
    assert np.sqrt(np.mean((with_result - measured) ** 2)) < 1.1 * data["residuals"]["discharge.tank.pressure"]["rms"]


def test_a_json_result_contains_the_same_values(poppet, bench):
    for name in ("result.toml", "result.json"):
        assert poppet("identify", "flow", str(bench / "flow.toml"), "-o", name).code == 0
    assert read_result("result.toml").parameters == read_result("result.json").parameters
    assert json.loads(Path("result.json").read_text())["method"] == "flow"


def test_a_worse_model_is_reported(poppet, bench):
    files = str(bench / "fit.toml"), "--compare", str(bench / "fit_adiabatic.toml")
    assert poppet("identify", "fit", *files, "-o", "result.toml").code == 0
    assert undocumented(read_result("result.toml")) == []
    verdict, comparison = read_result("result.toml").remarks[0], read_result("result.toml").comparison
    assert verdict.code == "finding.models.clearly"
    assert "fit_adiabatic.toml" in verdict.facts["worse"]
    assert comparison["aicc_difference"] > 10.0
    assert comparison["AICc"] == comparison["aicc"]


def test_settings_after_the_free_parameters_are_settings(bench):
    """Lines appended to a fit file land in its last table."""
    path = bench / "fit.toml"
    path.write_text(path.read_text(encoding="utf-8") + 'starts = 3\nloss = "huber"\n', encoding="utf-8")
    plan = fit_plan.read_fit_file(path)
    assert (plan.settings.starts, plan.settings.loss, plan.settings.seed) == (3, "huber", 0)
    assert "starts" not in [f.name for f in plan.free]


def test_loss_and_starts_are_accepted_in_the_table_of_a_parameter(bench):
    path = bench / "fit.toml"
    text = path.read_text(encoding="utf-8").replace("{ start = 0.3 }", '{ start = 0.3, starts = 3, loss = "huber" }')
    path.write_text(text, encoding="utf-8")
    plan = fit_plan.read_fit_file(path)
    assert (plan.settings.starts, plan.settings.loss) == (3, "huber")
    path.write_text(text.replace("[free]", 'loss = "huber"\n[free]\nstarts = 2', 1), encoding="utf-8")
    with pytest.raises(InputError) as error:
        fit_plan.read_fit_file(path)
    assert (error.value.code, error.value.address) == ("fit.two_searches", "free.outlet.critical_ratio.starts")
    assert (error.value.facts["first"], error.value.facts["other"]) == ("free.starts", 2)
    assert error.value.line


READERS = {"fit": fit_plan.read_fit_file, "tank": identify_tank}


@pytest.mark.parametrize(
    ("way", "old", "new", "marked", "code"),
    [
        ("fit", '"1e-8 m^3/(s Pa)"', '"1e-8 m^3"', "outlet.sonic_conductance", "quantity.other_quantity"),
        ("fit", "start = 0.3", "start = 1.5", "outlet.critical_ratio", "free.bounds"),
        ("fit", "start = 0.3", "start = 0.3, prior = { mean = 1 }", "outlet.critical_ratio", "fields.missing"),
        ("fit", 'lag = "free"', 'lag = "0.8 m"', "tank.temperature", "quantity.other_quantity"),
        ("fit", '"tank.temperature"', '"tank.temprature"', "tank.temprature", "names.unknown"),
        (
            "fit",
            '"tank.initial_pressure" = "free"',
            '"tank.initial_pressure" = "3 kg"',
            "start =",
            "quantity.other_quantity",
        ),
        ("fit", '"tank.initial_pressure" = "free"', '"tank.initial" = "free"', "start =", "names.unknown"),
        ("fit", "[free]", '[free]\nloss = "hubr"', "loss =", "fields.not_an_option"),
        ("fit", "[free]", "[free]\nstarts = 0", "starts =", "fields.out_of_range"),
        ("fit", "[free]", "[free]\nseed = -1.5", "seed =", "fields.out_of_range"),
        ("fit", "[free]", '[free]\nkicks = "many"', "kicks =", "fields.other_type"),
        ("fit", "start = 0.3", "start = 0.3, prior = { men = 1, sd = 1 }", "outlet.critical_ratio", "fields.unknown"),
        ("fit", '"discharge.csv"', '"discharge.csv"\nuse = "validation"', "[recordings.", "fit.held_frees.start"),
        ("fit", '"bench.toml"', '"none.toml"', "circuit =", "toml.no_file"),
        ("tank", '"tank_charge.csv"', '"no.csv"', "file =", "files.unreadable"),
        ("tank", 'closes = "8 s"', 'closes = "8 m"', "closes =", "quantity.other_quantity"),
        ("tank", 'direction = "charge"', 'direction = "discharge"', "tank.pressure", "tank.contrary"),
        ("tank", '"7 bar g"', '"7 kg"', "supply_pressure =", "quantity.other_quantity"),
        ("tank", '"0.987 bar"', '"2 kg"', "ambient_pressure =", "quantity.other_quantity"),
        ("tank", '"20 l"', '"20 l"\ncritical_ratio = { strt = 0.3 }', "critical_ratio =", "fields.unknown"),
    ],
)
def test_errors_have_their_line_number(bench, way, old, new, marked, code):
    path = bench / f"{way}.toml"
    text = path.read_text(encoding="utf-8")
    assert old in text
    text = text.replace(old, new, 1)
    path.write_text(text, encoding="utf-8")
    line = next(n for n, row in enumerate(text.splitlines(), 1) if marked in row)
    with pytest.raises(InputError) as error:
        READERS[way](path)
    assert (error.value.code, error.value.file, error.value.line) == (code, str(path), line)


@pytest.mark.parametrize(
    ("way", "old", "wrong", "meant"), [("fit", "use =", "usee =", "use"), ("tank", "closes", "closs", "closes")]
)
def test_misspelt_keys_have_a_suggestion(bench, way, old, wrong, meant):
    path = bench / f"{way}.toml"
    path.write_text(path.read_text(encoding="utf-8").replace(old, wrong, 1), encoding="utf-8")
    with pytest.raises(InputError) as error:
        READERS[way](path)
    assert error.value.code == "fields.unknown"
    assert meant in error.value.facts["suggestion"].names


@pytest.mark.parametrize("way", READERS)
def test_errors_end_the_command_with_their_line(poppet, bench, way):
    path = bench / f"{way}.toml"
    path.write_text("starts = 0\n" + path.read_text(encoding="utf-8"), encoding="utf-8")
    code, out, err = poppet("identify", way, str(path))
    assert (code, out) == (2, "")
    assert f"{way}.toml:1: " in err


def test_an_invalid_value_of_the_fit_file_has_its_line(poppet, bench):
    path = bench / "fit.toml"
    text = path.read_text(encoding="utf-8").replace("[recordings", '[set]\n"tank.volum" = 3\n\n[recordings', 1)
    path.write_text(text, encoding="utf-8")
    line = next(n for n, row in enumerate(text.splitlines(), 1) if "tank.volum" in row)
    assert f"fit.toml:{line}: " in poppet("identify", "fit", str(path)).err


def test_a_gauge_pressure_read_as_absolute_is_reported(poppet, bench):
    path = bench / "tank.toml"
    path.write_text(path.read_text(encoding="utf-8").replace('unit = "bar g"', 'unit = "bar"'), encoding="utf-8")
    result = identify_tank(path)
    (finding,) = remarks(result, "finding.gauge")
    assert finding.address == "charge.tank.pressure"
    assert finding.facts["floor"] < 0.5 * finding.facts["ambient"] == pytest.approx(0.4935)
    assert (finding.facts["number"], finding.facts["verdict"]) == ("valve.critical_ratio", "at bound")
    assert len([note for note in remarks(result, "suspicion.read_as_absolute") if "discharge" in note.address]) == 1


def test_missing_matplotlib_is_reported_before_the_fit(poppet, bench, monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    result = bench / "result.toml"
    arguments = ("identify", "flow", str(bench / "flow.toml"), "-o", str(result), "--report", str(bench / "page.html"))
    code, out, err = poppet(*arguments)
    assert (code, out) == (2, "")
    assert "matplotlib" in err
    assert not result.exists()


def test_profiles_and_bootstrap_report_progress(bench):
    calls = []
    options = {"profile": ["valve.critical_ratio"], "repeats": 2}
    identify_tank(bench / "tank.toml", stages=lambda *parts: calls.append(parts), **options)
    assert [call for call in calls if call[0] == "bootstrap fits"] == [("bootstrap fits", k, 2) for k in (1, 2)]
    profile = [call for call in calls if call[0].startswith("ends of profiles (valve.critical_ratio: ")]
    assert [done for _, done, _ in profile] == sorted(done for _, done, _ in profile)
    assert {total for *_, total in profile} == {2}
    others = [call for call in calls if call[0] == "fits of alternative models"]
    assert [done for _, done, _ in others] == list(range(len(others)))
    assert {total for *_, total in others} <= {len(others)}
    assert len(profile) + 2 + len(others) == len(calls)


@pytest.mark.parametrize(
    ("after", "note"),
    [
        ("ends of profiles", Note("finding.stopped.profile", "valve.critical_ratio")),
        ("bootstrap", Note("finding.stopped.bootstrap", done=1, asked=3)),
        ("places of the contour", Note("finding.stopped.contour")),
    ],
)
def test_an_interrupt_after_the_fit_keeps_it(bench, monkeypatch, after, note):
    """The interrupt comes during the fit that follows the report, where a search catches it."""
    uninterrupted = identify_tank(bench / "tank.toml").parameters
    armed = []
    original = Experiment.outputs

    def outputs(self, values):
        if armed:
            armed.clear()
            raise KeyboardInterrupt
        return original(self, values)

    monkeypatch.setattr(Experiment, "outputs", outputs)
    result = identify_tank(
        bench / "tank.toml",
        profile=["valve.critical_ratio"] if after == "ends of profiles" else [],
        contour=after == "places of the contour",
        repeats=3,
        stages=lambda what, done, total: armed.append(1) if what.startswith(after) and done < 2 else None,
    )
    assert result.conditions["interrupted"] is True
    assert note in result.remarks
    assert result.parameters == uninterrupted


def test_a_constant_pressure_gives_a_finding(poppet, bench):
    """A recording that does not change has no range to compare with."""
    rows = "\n".join(f"{0.1 * k:.1f},5.0,20.0" for k in range(200))
    (bench / "discharge.csv").write_text("t,p_tank,T_gas\n" + rows, encoding="utf-8")
    path = bench / "fit.toml"
    text = re.sub(r"start = \{.*\}\n", 'start = { "tank.initial_pressure" = "8 bar g" }\n',
                  path.read_text(encoding="utf-8"), count=1)  # fmt: skip
    path.write_text(re.sub(r'"tank.temperature" = .*\n', "", text, count=1), encoding="utf-8")
    first = identify_fit(path).remarks[0]
    assert (first.code, first.address) == ("finding.unexplained.constant", "discharge.tank.pressure")
    assert first.facts["unit"] == "Pa"
    assert np.isfinite(first.facts["rms"])


def test_profile_and_bootstrap_add_intervals(poppet, bench):
    options = ("--profile", "valve.critical_ratio", "--bootstrap", "3")
    assert poppet("identify", "tank", str(bench / "tank.toml"), *options, "-o", "result.toml").code == 0
    result = read_result("result.toml")
    (profile,) = remarks(result, "finding.profile")
    assert profile.address == "valve.critical_ratio"
    assert profile.facts["low"] == pytest.approx(0.275, abs=0.005)
    # The interval of the result also includes the budget.
    assert profile.facts["low"] > result.parameters["valve.critical_ratio"].low > 0.27
    # A plain number has no unit behind it.
    assert str(profile).endswith(f"{profile.facts['linear_high']:.5g} by the linear model.")
    repeated = {note.address: note.facts for note in remarks(result, "finding.bootstrap")}
    assert set(repeated) == set(result.parameters)
    assert repeated["valve.sonic_conductance"]["low"] == pytest.approx(2.1e-8, rel=0.02)
    assert {facts["fits"] for facts in repeated.values()} == {3}


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (("flow", "flow.toml", "--compare", "fit.toml"), "--compare is not an option of `identify flow`"),
        (("tank", "tank.toml", "--library", "x.toml"), "--library is not an option of `identify tank`"),
        (("characteristic", "characteristic.toml", "--bootstrap", "9"), "--bootstrap is not an option"),
        (("fit", "fit.toml", "--bootstrap", "-1"), "the number of bootstrap fits must be at least 0"),
        (("fit", "fit.toml", "--profile", "outlet.ratio"), "outlet.ratio is not the name of a free parameter"),
        (("fit", "fit.toml", "-o", "x.xls"), "x.xls"),
        (("fit", "nowhere.toml"), "nowhere.toml"),
        (("fit", "tank.toml"), "is not a valid field of a fit file"),
        (("tank", "fit.toml"), "circuit is not a valid field of a tank test file"),
        (("flow", "tank.toml"), "is not a valid field of a flow bench file"),
        (("characteristic", "flow.toml"), "is not a valid field of a list of tests"),
    ],
)
def test_invalid_options_are_refused(poppet, bench, monkeypatch, arguments, message):
    monkeypatch.chdir(bench)
    code, out, err = poppet("identify", *arguments)
    assert (code, out) == (2, "")
    assert message in err


def test_an_interrupted_fit_returns_its_best_point(poppet, bench, monkeypatch):
    calls = []

    def interrupt(self, count, cost):
        calls.append(cost)
        if len(calls) == 6:
            raise KeyboardInterrupt

    monkeypatch.setattr("poppet.cli.progress.FitProgress.__call__", interrupt)
    code, out, _ = poppet("identify", "fit", str(bench / "fit.toml"), "-o", "result.toml")
    assert code == 130
    assert "interrupted" in out
    assert remarks(read_result("result.toml"), "finding.interrupted")
    assert read_result("result.toml").conditions["interrupted"] is True
    assert read_result("result.toml").parameters["outlet.sonic_conductance"].value == pytest.approx(1.1e-8, rel=0.5)


# Data that cannot be ----------------------------------------------------------------------------------------------


def rewrite(path: Path, change) -> None:
    """A recording with other rows."""
    head, *lines = path.read_text().splitlines()
    path.write_text("\n".join([head, *(",".join(row) for row in change([line.split(",") for line in lines]))]) + "\n")


def with_pressure(text):
    return lambda rows: [[row[0], text, *row[2:]] for row in rows]


def backwards(rows):
    return rows[:100] + rows[50:]


def rising(rows):
    return [[row[0], mirrored[1], *row[2:]] for row, mirrored in zip(rows, rows[::-1], strict=True)]


REFUSED = [
    (with_pressure("nan"), "contains no numbers"),
    (with_pressure("ERROR"), "contains text such as"),
    (backwards, "must not decrease"),
    (lambda rows: rows[:5], "has only 5 samples, but at least 8 are required"),
    (lambda rows: [], "contains no lines of numbers"),
]
RECORDINGS = [("fit", "discharge.csv"), ("tank", "tank_discharge.csv"), ("characteristic", "strokes/240.csv")]


@pytest.mark.parametrize(("way", "file"), RECORDINGS)
@pytest.mark.parametrize(("change", "message"), REFUSED)
def test_invalid_recordings_are_refused(poppet, bench, way, file, change, message):
    rewrite(bench / file, change)
    code, out, err = poppet("identify", way, str(bench / f"{way}.toml"), "-o", "result.toml")
    assert (code, out) == (2, "")
    assert message in err
    assert not Path("result.toml").exists()


@pytest.mark.parametrize(("way", "file"), [*RECORDINGS, ("flow", "flow_points.csv")])
def test_empty_files_are_refused(poppet, bench, way, file):
    (bench / file).write_text("")
    code, out, err = poppet("identify", way, str(bench / f"{way}.toml"))
    assert (code, out) == (2, "")
    assert "the file is empty" in err


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (with_pressure("5.0"), "is almost constant"),
        (rising, 'which contradicts direction = "discharge"'),
        (with_pressure("nan"), "contains no numbers"),
    ],
)
def test_a_tank_that_does_not_empty_is_refused(poppet, bench, change, message):
    rewrite(bench / "tank_discharge.csv", change)
    code, _, err = poppet("identify", "tank", str(bench / "tank.toml"))
    assert code == 2
    assert message in err


def test_a_tank_fuller_than_its_supply_is_refused(poppet, bench):
    path = bench / "tank.toml"
    path.write_text(path.read_text().replace('supply_pressure = "7 bar g"', 'supply_pressure = "4 bar"'))
    code, _, err = poppet("identify", "tank", str(path))
    assert code == 2
    assert "above the supply pressure of 400000 Pa" in err


@pytest.mark.parametrize(
    ("change", "message"),
    [
        (lambda rows: rows[:2], "are too few for a fit of 2 free parameters"),
        (with_pressure("nan"), "pressure_1"),
        (lambda rows: [[row[0], row[2], row[1], row[3]] for row in rows], "pressure_2"),
    ],
)
def test_implausible_points_are_refused(poppet, bench, change, message):
    rewrite(bench / "flow_points.csv", change)
    code, out, err = poppet("identify", "flow", str(bench / "flow.toml"))
    assert (code, out) == (2, "")
    assert message in err


@pytest.mark.parametrize("way", ["fit", "tank", "flow"])
@pytest.mark.parametrize(("unit", "message"), [("K", '"Pa"'), ("baar", "which is not a unit")])
def test_wrong_units_are_refused(poppet, bench, way, unit, message):
    path = bench / f"{way}.toml"
    path.write_text(path.read_text().replace('unit = "bar g"', f'unit = "{unit}"'))
    code, _, err = poppet("identify", way, str(path))
    assert code == 2
    assert message in err


def doubtful(path: Path) -> Result:
    """A recording that brings doubts to light is fitted all the same."""
    result = identify_fit(path)
    assert any(e.verdict != "determined" for e in result.parameters.values())
    return result


def test_a_constant_sensor_gives_a_finding(bench):
    rewrite(bench / "discharge.csv", with_pressure("5.0"))
    result = doubtful(bench / "fit.toml")
    assert "Check the connection of the sensor." in " ".join(result.findings)
    # Nothing flows, or so little that no number fits: the last digit decides.
    assert result.parameters["outlet.sonic_conductance"].verdict in ("not determined", "at bound")


def test_a_rising_pressure_in_a_discharge_gives_a_finding(bench):
    rewrite(bench / "discharge.csv", rising)
    (finding,) = remarks(doubtful(bench / "fit.toml"), "finding.residuals.not_white")[:1]
    assert finding.address == "discharge.tank.pressure"


def test_gauge_read_as_absolute_gives_a_finding(bench):
    path = bench / "fit.toml"
    path.write_text(path.read_text().replace('"bar g"', '"bar"'))
    assert "If the channel is a gauge pressure" in " ".join(doubtful(path).findings)


def test_repeated_stamps_are_merged_and_counted(bench):
    rewrite(bench / "discharge.csv", lambda rows: [row for row in rows for _ in range(2)])
    assert "301 samples have the same time as another sample" in " ".join(identify_fit(bench / "fit.toml").findings)

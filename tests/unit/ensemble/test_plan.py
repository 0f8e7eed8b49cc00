"""Tables of an ensemble: valid fields, and all errors with their addresses."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from circuits_of_ensembles import METRICS, NUMBERS, TABLES, TANK, tank
from poppet import ensemble, load
from poppet.core.errors import InputErrors
from poppet.ensemble import plan_of
from poppet.identify.result import Estimate, Result
from refusals import refused


def plan(**fields):
    return plan_of(tank(""), **{"runs": 10, "parameters": NUMBERS, "metrics": METRICS, **fields})


def test_tables_of_a_file_are_read():
    read = plan_of(tank())
    assert (read.runs, read.seed, read.sampling, read.keep) == (300, 1, "random", "metrics")
    assert read.addresses == ("tank.volume", "hole.sonic_conductance")
    assert [metric.name for metric in read.metrics] == ["end", "empty", "air"]
    assert [item.metric for item in read.requirements] == ["empty", "end"]
    assert plan_of(tank(), runs=20, sampling="sobol").runs == 20


def test_tables_do_not_change_single_runs():
    assert (tank().simulate()["tank.pressure"] == tank("").simulate()["tank.pressure"]).all()


def test_all_errors_are_reported_together(tmp_path):
    text = TANK + TABLES.replace("runs = 300", "runs = 0").replace('"tank.volume"', '"tank.volum"').replace(
        'metric = "final"', 'metric = "finale"').replace("empty < 0.5 s", "empti < 0.5 s").replace(
        'value = "0.5 bar g"', 'value = "0.5 kg"')  # fmt: skip
    path = tmp_path / "tank.toml"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(InputErrors) as caught:
        plan_of(load(path))
    assert [(item.code, item.address) for item in caught.value.problems] == [
        ("fields.out_of_range", "ensemble.runs"),
        ("names.unknown", "ensemble.parameters.tank.volum"),
        ("fields.not_an_option", "ensemble.metrics.end.metric"),
        ("quantity.other_quantity", "ensemble.metrics.empty.value"),
        ("fields.not_an_option", "requirements.fast"),
    ]


@pytest.mark.parametrize(
    ("code", "fields"),
    [
        ("fields.unknown", {"run": 5}),
        ("fields.out_of_range", {"runs": 1.5}),
        ("fields.out_of_range", {"seed": -1}),
        ("ensemble.power_of_two", {"indices": 1000}),
        ("fields.not_an_option", {"sampling": "halton"}),
        ("fields.not_an_option", {"keep": "everything"}),
        ("ensemble.no_metric", {"metrics": {}}),
        ("ensemble.name", {"metrics": {"a b": METRICS["end"]}}),
        *(
            ("ensemble.name_taken", {"metrics": {name: METRICS["end"]}})
            for name in ("run", "done", "outcome", "balance")
        ),
        ("ensemble.name", {"requirements": {"../../end": "end < 9 bar"}}),
        ("ensemble.name_taken", {"requirements": {"all": "end < 9 bar"}}),
        ("ensemble.beyond", {"metrics": {"end": METRICS["end"] | {"until": "1.1 s"}}}),
        ("ensemble.no_rows", {"metrics": {"end": METRICS["end"] | {"from": "1.1 s"}}}),
        ("ensemble.no_rows", {"metrics": {"end": METRICS["end"] | {"from": "0.501 s", "until": "0.502 s"}}}),
        ("ensemble.no_numbers", {"parameters": {}}),
        ("names.unknown", {"parameters": {"tank.pressure": NUMBERS["tank.volume"]}}),
        ("fields.not_an_option", {"curves": ["tank.volum"], "keep": "bands"}),
        ("ensemble.runs_follow", {"sampling": "grid", "levels": 4}),
        ("ensemble.no_file", {"sampling": "file"}),
        ("ensemble.not_of_file", {"file": "numbers.csv"}),
        ("ensemble.no_fit", {"parameters": {"from_fit": 3}}),
    ],
)
def test_invalid_fields_are_rejected(code, fields):
    with refused(code):
        plan(**fields)


def test_driven_parameter_is_rejected():
    driven = tank('[signals."hole.opening"]\nkind = "constant"\nvalue = 0.5\n')
    with refused("ensemble.driven", "ensemble.parameters.hole.opening"):
        plan_of(driven, runs=3, metrics=METRICS, parameters={"hole.opening": {"distribution": "uniform", "low": 0.1,
                "high": 0.9}})  # fmt: skip


def test_missing_number_of_runs_is_rejected():
    with refused("ensemble.no_runs", "ensemble.runs"):
        plan_of(tank(""), parameters=NUMBERS, metrics=METRICS)


def test_a_grid_has_all_combinations():
    read = plan(runs=9, sampling="grid", levels=3)
    assert len({tuple(row) for row in read.sample(0, 9)}) == 9
    assert plan_of(tank(""), parameters=NUMBERS, metrics=METRICS, sampling="grid").runs == 25


def table(folder: Path, text: str):
    (folder / "numbers.csv").write_text(text, encoding="utf-8")
    return plan_of(tank("", folder), metrics=METRICS, sampling="file", file="numbers.csv")


def test_parameters_of_a_file(tmp_path):
    read = table(tmp_path, "tank.volume [l],tank.initial_pressure [bar g]\n1,2\n2,3\n3,4.5\n")
    assert read.runs == 3
    assert read.sample(0, 3) == pytest.approx(np.array([[1e-3, 3e5], [2e-3, 4e5], [3e-3, 5.5e5]]))
    with refused("ensemble.impossible_rows", "ensemble.file: tank.volume", row=2, count=1):
        table(tmp_path, "tank.volume [l]\n1\n-2\n")
    with refused("names.unknown", "ensemble.file: tank.volum"):
        table(tmp_path, "tank.volum [l]\n1\n2\n")
    with refused("ensemble.column_twice", "ensemble.file: tank.volume"):
        table(tmp_path, "tank.volume [l],tank.volume [m^3]\n1,2\n2,3\n")
    for code, fields in (("file_and_numbers", {"parameters": NUMBERS}), ("indices_of_file", {"indices": 64})):
        (tmp_path / "numbers.csv").write_text("tank.volume [l]\n1\n2\n", encoding="utf-8")
        with refused(f"ensemble.{code}"):
            plan_of(tank("", tmp_path), metrics=METRICS, sampling="file", file="numbers.csv", **fields)
    with refused("quantity.other_quantity") as caught:
        table(tmp_path, "tank.volume [bar]\n1\n2\n")
    assert [item.code for item in caught.value.problems] == ["quantity.other_quantity"]


def test_other_sampling_method_ignores_the_file(tmp_path):
    circuit = tank('[ensemble]\nsampling = "file"\nfile = "numbers.csv"\n', tmp_path)
    fields = {"runs": 8, "parameters": {"tank.volume": {"distribution": "uniform", "relative_range": 0.1}}}
    assert plan_of(circuit, sampling="latin", metrics=METRICS, **fields).table is None
    with refused("ensemble.not_of_file"):
        plan_of(tank("", tmp_path), sampling="latin", file="numbers.csv", metrics=METRICS, **fields)


def fit(**changes):
    parameters = {
        "tank.volume": Estimate(2e-3, "m^3", 2e-5, 1.9e-3, 2.1e-3, "determined"),
        "hole.sonic_conductance": Estimate(2e-8, "m^3/(s Pa)", 4e-10, 1.9e-8, 2.1e-8, "determined"),
    }
    correlation = {"tank.volume": {"tank.volume": 1.0, "hole.sonic_conductance": 0.8}}
    return Result("fit", "bench 3", parameters | changes, correlation=correlation)


def test_the_joint_distribution_of_a_fit(tmp_path):
    fit().save(tmp_path / "result.toml")
    read = plan_of(tank("", tmp_path), runs=20_000, parameters={"from_fit": "result.toml"}, metrics=METRICS, seed=2)
    sample = read.sample(0, 20_000)
    assert sample.mean(axis=0) == pytest.approx([2e-3, 2e-8], rel=1e-3)
    assert sample.std(axis=0) == pytest.approx([2e-5, 4e-10], rel=0.02)
    assert np.corrcoef(sample.T)[0, 1] == pytest.approx(0.8, abs=0.01)
    assert (read.sample(777, 801) == sample[777:801]).all()


def test_undetermined_parameters_of_a_fit_are_rejected():
    doubtful = fit(**{"tank.volume": Estimate(2e-3, "m^3", np.inf, 0.0, 1.0, "not determined")})
    with refused("ensemble.undetermined", "ensemble.parameters.from_fit", name="tank.volume"):
        plan(parameters={"from_fit": doubtful})
    read = plan(parameters={"from_fit": doubtful, "tank.volume": NUMBERS["tank.volume"]})
    assert (tuple(read.alone), read.joint) == (("tank.volume",), ("hole.sonic_conductance",))
    wide = fit(**{"tank.volume": Estimate(2e-3, "m^3", 1e-3, 0.0, 1.0, "weak")})
    with refused("ensemble.impossible", "ensemble.parameters.from_fit", name="tank.volume"):
        plan(parameters={"from_fit": wide})


def test_the_old_names_of_parameters_work():
    circuit = tank(TABLES.replace("[ensemble.parameters]", "[ensemble.numbers]"))
    plan = plan_of(circuit)
    assert plan.addresses == plan_of(tank(TABLES)).addresses
    assert [note.code for note in plan.notes] == ["ensemble.old_numbers"]
    assert [note.code for note in circuit.ensemble(runs=2).remarks()] == ["ensemble.old_numbers"]
    with pytest.warns(DeprecationWarning, match="parameters"):
        renamed = plan_of(circuit, numbers=NUMBERS)
    assert renamed.alone == plan_of(circuit, parameters=NUMBERS).alone
    assert renamed.notes == ()


def test_old_and_new_names_together_are_an_error():
    text = TABLES.replace("[ensemble.parameters]", '[ensemble.numbers]\nfrom_fit = "a.toml"\n[ensemble.parameters]')
    with refused("ensemble.numbers_and_parameters", "ensemble.numbers"):
        plan_of(tank(text))
    with refused("ensemble.numbers_and_parameters"):
        plan_of(tank(), numbers=NUMBERS, parameters=NUMBERS)


def test_errors_in_the_old_table_have_its_address():
    text = TABLES.replace("[ensemble.parameters]", "[ensemble.numbers]").replace('"tank.volume"', '"tank.volum"')
    with refused("names.unknown", "ensemble.numbers.tank.volum"):
        plan_of(tank(text))


@pytest.mark.parametrize(
    ("old", "new"),
    [("Plan", "EnsemblePlan"), ("Index", "SobolIndex"), ("Range", "TornadoRange"), ("Case", "WorstCase")],
)
def test_old_class_names_work(old, new):
    with pytest.warns(DeprecationWarning, match=new):
        assert getattr(ensemble, old) is getattr(ensemble, new)
    with pytest.raises(AttributeError, match="Nothing"):
        ensemble.Nothing  # noqa: B018

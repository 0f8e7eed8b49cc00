"""Result files: exact round trips in both formats, including infinities and not-a-number."""

from __future__ import annotations

import json
import math
import subprocess
import sys
import tomllib

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputError
from poppet.core.toml import json_text, toml_text
from poppet.identify.result import Estimate, ResidualSummary, Result, read_result
from refusals import refused


@pytest.fixture
def result():
    return Result(
        "flow",
        'bench "A" \\ 20 degC',
        {
            "outlet.sonic_conductance": Estimate(2e-8, "m^3/(s Pa)", 1e-11, 1.9e-8, 2.1e-8, "determined", 1e-8),
            "outlet.critical_ratio": Estimate(math.nan, "1", math.inf, 0.2, 1.0, "not determined"),
            "run 1.outlet.lag": Estimate(0.5, "s", 0.1, -math.inf, math.inf, "weak", 0.0),
        },
        {"run 1.tank.pressure": ResidualSummary(2e3, 0.01, -1.0, "Pa", 120)},
        {"outlet.sonic_conductance": {"outlet.critical_ratio": -0.5}},
        {"aicc": -math.inf, "nested": {"deeper": {"value": 1e16}, "empty": {}}, "points": [0, 2], "flag": True},
        (
            Note("near.names", "outlet.critical_ratio", names=("b", "C"), sizes=(1.5, math.inf)),
            *notes_of(["b is not determined.", "p₂ \N{DELETE} \U0001f600 line\nbreak\ttab"]),
        ),
        {"recordings": ["run 1"], "samples": 120},
    )


def are_equal(first, second):
    """Return True if two tables are equal in any order; not-a-number equals itself."""
    return repr(sort_keys(first)) == repr(sort_keys(second))


def sort_keys(value):
    return {k: sort_keys(value[k]) for k in sorted(value)} if isinstance(value, dict) else value


@pytest.mark.parametrize("name", ["result.toml", "result.json"])
def test_saved_result_is_read_unchanged(result, name, tmp_path):
    result.save(tmp_path / name)
    read = read_result(tmp_path / name)
    assert are_equal(read.content(), result.content())
    assert read.remarks == result.remarks
    assert read.findings == result.findings == ("Did you mean b or C?", *result.findings[1:])
    assert math.isnan(read.parameters["outlet.critical_ratio"].value)
    assert read.parameters["run 1.outlet.lag"].low == -math.inf


def test_json_is_valid_for_strict_readers(result, tmp_path):
    result.save(tmp_path / "result.json")

    def refuse(constant):
        raise AssertionError(constant)

    data = json.loads((tmp_path / "result.json").read_text(encoding="utf-8"), parse_constant=refuse)
    assert data["parameters"]["outlet.critical_ratio"]["standard_error"] == "inf"


def test_values_omit_nuisance_parameters_and_not_a_number(result):
    values = result.values()
    assert list(values) == ["outlet.sonic_conductance"]
    assert values["outlet.sonic_conductance"].source.kind == "fitted"
    assert "determined" in values["outlet.sonic_conductance"].source.note


def test_numpy_numbers_are_written_as_numbers():
    content = {"a": np.float64(0.1), "b": np.int64(3), "c": np.bool_(True), "d": np.array([1.5, np.inf]), "e": {}}
    expected = {"a": 0.1, "b": 3, "c": True, "d": [1.5, math.inf], "e": {}}
    assert tomllib.loads(toml_text(content)) == expected
    assert json.loads(json_text(content)) == expected | {"d": [1.5, "inf"]}


texts = st.text(st.characters(codec="utf-8"), max_size=12)
plain = st.one_of(st.booleans(), st.integers(-(2**63), 2**63 - 1), st.floats(), texts)
tables = st.recursive(
    st.dictionaries(texts, st.one_of(plain, st.lists(plain, max_size=3)), max_size=3),
    lambda inner: st.dictionaries(texts, st.one_of(plain, inner), max_size=3),
    max_leaves=12,
)


@given(tables)
@settings(derandomize=True, deadline=None, max_examples=200)
def test_toml_text_of_any_table_is_read_unchanged(content):
    assert are_equal(tomllib.loads(toml_text(content)), content)


@pytest.mark.parametrize("remarks", ["", 'remarks = [{ code = "near.no_such_code", address = "" }]\n'])
def test_unknown_findings_remain_sentences(remarks, tmp_path):
    (tmp_path / "r.toml").write_text(f'findings = ["All is well."]\n{remarks}[parameters]\n', encoding="utf-8")
    assert read_result(tmp_path / "r.toml").remarks == (Note("said", text="All is well."),)


@pytest.mark.parametrize(
    ("name", "text"),
    [
        ("a.toml", "x = 1"),
        ("a.toml", "x = "),
        ("a.json", "[1]"),
        ("a.json", "{"),
        ("a.toml", "parameters = 3"),
        ("a.toml", "[parameters.x]\nvalue = 1.0"),
    ],
)
def test_other_files_are_rejected(name, text, tmp_path):
    (tmp_path / name).write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as error:
        read_result(tmp_path / name)
    assert error.value.code == "result.unreadable"


def test_unknown_verdict_is_rejected(result, tmp_path):
    result.save(tmp_path / "r.toml")
    text = (tmp_path / "r.toml").read_text(encoding="utf-8").replace('"weak"', '"week"')
    (tmp_path / "r.toml").write_text(text, encoding="utf-8")
    with pytest.raises(InputError) as error:
        read_result(tmp_path / "r.toml")
    assert (error.value.code, error.value.address) == ("fields.not_an_option", "parameters.run 1.outlet.lag.verdict")
    assert error.value.facts["suggestion"].names == ["weak"]


def test_other_formats_are_rejected(result, tmp_path):
    with refused("files.suffix"):
        result.save(tmp_path / "result.yaml")


def test_former_names_are_deprecated():
    from poppet import identify

    for former, name in {"Free": "FreeParameter", "Predicted": "Prediction", "Settings": "SearchSettings"}.items():
        with pytest.warns(DeprecationWarning, match=name):
            assert getattr(identify, former) is getattr(identify, name)
    with pytest.raises(AttributeError, match="nothing"):
        _ = identify.nothing


def test_public_names_are_imported_on_first_use():
    from poppet import identify

    assert all(getattr(identify, name).__name__ == name for name in identify.__all__)
    script = "import sys, poppet.identify; print([m for m in sys.modules if m.startswith('poppet.identify.')])"
    run = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, check=True)
    assert run.stdout.strip() == "[]"

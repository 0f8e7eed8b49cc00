"""JSON schema of the tables of an ensemble: it accepts and rejects the same files as the reader."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from poppet import loads
from poppet.core.errors import InputError
from poppet.ensemble import plan_of
from poppet.ensemble.distributions import FORMS
from poppet.ensemble.ensemble_schema import file_schema
from poppet.ensemble.metrics import METRIC_KINDS

EXAMPLE = (Path(__file__).parents[3] / "examples/ensemble.toml").read_text(encoding="utf-8")


@pytest.fixture(scope="module")
def validator() -> Any:
    jsonschema = pytest.importorskip("jsonschema", reason="jsonschema is not installed")
    return jsonschema.Draft202012Validator(file_schema())


TEXTS = {  # text of the example to invalid replacements
    "runs = 500": ["runs = 0", 'runs = "500"', "runs = true", "rnus = 500"],
    "seed = 1": ["seed = -1", "seed = 1.5"],
    '"sobol"': ['"sobel"'],
    '"bands"': ['"band"'],
    "indices = 64": ["indices = 65", "indices = -2"],
    '"normal", relative_sigma = 0.03': [
        '"normal"',
        '"normal", rel_sigma = 0.03',
        '"gauss", sigma = 0.03',
        '"lognormal", sigma = 0.03',
        '"lognormal", median = "1 l"',
        '"uniform", low = "1 l"',
        '"triangular", low = "1 l"',
    ],
    'metric = "time_to", value = "3.9 bar"': [
        'metric = "time_to"',
        'metric = "time_too", value = "3.9 bar"',
        'metric = "final", value = "3.9 bar"',
        'metric = "max", band = 0.1',
        'value = "3.9 bar"',
    ],
    "[ensemble.parameters]": ["[ensemble.numbers]\n[ensemble.parameters]"],
    'quiet = "overshoot < 4.2 %"': ['quiet = "overshoot 4.2 %"', "quiet = 4.2", 'quiet = "< 4.2 %"'],
    '"tank.volume" = {': ["volume = {"],
    "overshoot = {": ['"over shoot" = {', "balance = {"],
    'quiet = "overshoot': ['"../quiet" = "overshoot', 'all = "overshoot'],
}


@pytest.mark.parametrize(
    ("valid", "invalid"), [(valid, invalid) for valid, replacements in TEXTS.items() for invalid in replacements]
)
def test_schema_and_reader_reject_the_same_files(validator, valid, invalid):
    assert valid in EXAMPLE
    text = EXAMPLE.replace(valid, invalid, 1)
    assert not validator.is_valid(tomllib.loads(text))
    with pytest.raises(InputError):
        plan_of(loads(text))


@pytest.mark.parametrize(
    ("valid", "replacement"),
    [
        ("relative_sigma = 0.03", 'relative_sigma = "3 %"'),
        ('"normal", relative_sigma = 0.03', '"lognormal", log_sigma = 0.03'),
        ('"normal", relative_sigma = 0.03', '"uniform", relative_range = 0.1, low = 0.0009'),
        ('"normal", relative_sigma = 0.03', '"uniform", relative_range = 0.1'),
        ('"normal", relative_sigma = 0.03', '"triangular", low = "0.9 l", high = "1.1 l"'),
        ('"normal", relative_sigma = 0.03', '"normal", mean = 0.001, sigma = "0.1 l", low = "0.5 l"'),
        ('metric = "time_to", value = "3.9 bar", from = "0.1 s", unit = "ms"', 'metric = "steady_error"'),
        ('metric = "time_to", value = "3.9 bar", from = "0.1 s", unit = "ms"', 'metric = "own.py:ripple"'),
        ('quiet = "overshoot < 4.2 %"', 'quiet = "0 < overshoot <= 4.2 %"'),
        ("indices = 64", "indices = 0\ncurves = 'tank.pressure'"),
        ("indices = 64", "curves = ['tank.pressure']"),
    ],
)
def test_schema_and_reader_accept_the_same_files(validator, valid, replacement):
    assert valid in EXAMPLE
    text = EXAMPLE.replace(valid, replacement, 1).replace('fast = "rise < 450 ms"', "")
    assert [error.message for error in validator.iter_errors(tomllib.loads(text))] == []
    if "relative_range = 0.1, low" in replacement:  # a schema cannot express this
        with pytest.raises(InputError):
            plan_of(loads(text))
    else:
        assert plan_of(loads(text), allow_python=True).runs == 500


def test_schema_contains_all_distributions_and_metrics_with_descriptions():
    definitions = file_schema()["$defs"]
    assert definitions["distribution"]["properties"]["distribution"]["enum"] == list(FORMS)
    assert definitions["metric"]["properties"]["metric"]["anyOf"][0]["enum"] == list(METRIC_KINDS)
    for name, metric_kind in METRIC_KINDS.items():
        properties = definitions[f"metric_{name}"]["properties"]
        assert set(properties) == {"metric", "of", "unit", "from", "until", *metric_kind.fields}
        assert properties["metric"]["description"] == metric_kind.meaning
        assert all(field["description"] for field in properties.values())


def test_the_old_name_of_parameters_is_valid(validator):
    assert validator.is_valid(tomllib.loads(EXAMPLE.replace("[ensemble.parameters]", "[ensemble.numbers]")))


@pytest.mark.parametrize(("place", "is_valid"), [({"x": 1, "y": 2.5}, True), ({"x": 1, "y": 2, "rotation": 45}, False)])
def test_positions_in_a_drawing(place, is_valid):
    from jsonschema import Draft202012Validator

    content = {"parts": {"room": {"kind": "reservoir", "pressure": 1e5}}, "drawing": {"room": place}}
    assert Draft202012Validator(file_schema()).is_valid(content) == is_valid

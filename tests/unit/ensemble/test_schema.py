"""The JSON schema of the tables of an ensemble: it takes what the reader takes, and refuses what that refuses."""

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


@pytest.mark.parametrize(("good", "bad"), [(good, bad) for good, every in TEXTS.items() for bad in every])
def test_what_the_reader_refuses(validator, good, bad):
    assert good in EXAMPLE
    text = EXAMPLE.replace(good, bad, 1)
    assert not validator.is_valid(tomllib.loads(text))
    with pytest.raises(InputError):
        plan_of(loads(text))


@pytest.mark.parametrize(
    ("good", "other"),
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
def test_what_the_reader_takes(validator, good, other):
    assert good in EXAMPLE
    text = EXAMPLE.replace(good, other, 1).replace('fast = "rise < 450 ms"', "")
    assert [error.message for error in validator.iter_errors(tomllib.loads(text))] == []
    if "relative_range = 0.1, low" in other:  # which no schema of fields can know
        with pytest.raises(InputError):
            plan_of(loads(text))
    else:
        assert plan_of(loads(text)).runs == 500


def test_every_distribution_and_metric_is_known_with_what_it_means():
    known = file_schema()["$defs"]
    assert known["distribution"]["properties"]["distribution"]["enum"] == list(FORMS)
    assert known["metric"]["properties"]["metric"]["anyOf"][0]["enum"] == list(METRIC_KINDS)
    for name, way in METRIC_KINDS.items():
        own = known[f"metric_{name}"]["properties"]
        assert set(own) == {"metric", "of", "unit", "from", "until", *way.fields}
        assert own["metric"]["description"] == way.meaning
        assert all(field["description"] for field in own.values())


def test_the_old_name_of_parameters_is_valid(validator):
    assert validator.is_valid(tomllib.loads(EXAMPLE.replace("[ensemble.parameters]", "[ensemble.numbers]")))

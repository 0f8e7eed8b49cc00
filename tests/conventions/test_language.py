"""The countable rules of plain language hold for the package."""

from __future__ import annotations

import runpy
from functools import cache
from pathlib import Path
from typing import Any

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
MEASURE = runpy.run_path(str(REPOSITORY / "tools" / "measure_language.py"))["measure"]
LIMITS = {
    "vague names per 1000": 15.0,
    "classes that are not nouns": 5,
    "class names defined more than once": 0,
    "module basenames used more than twice": 0,
    "summaries that start with a question word": 0,
    "... in percent ": 4.0,  # summaries without a verb or noun phrase first
    "summaries without a full stop": 0,
    "dialect words per 1000 words of docstrings and comments": 0.3,
}


@cache
def measured() -> tuple[dict[str, Any], dict[str, list[str]]]:
    return MEASURE(REPOSITORY / "src" / "poppet")


@pytest.mark.parametrize("indicator", LIMITS)
def test_the_package_is_within_the_limits(indicator):
    values, hits = measured()
    assert values[indicator] <= LIMITS[indicator], hits


def test_the_tool_finds_what_it_counts(tmp_path):
    module = '"""What this is."""\n\nclass Found:\n    """Of a thing."""\n\ndef f(given):\n    """Return it anew."""\n'
    for folder in ("a", "b", "c"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "run.py").write_text(module, encoding="utf-8")
    values, _ = MEASURE(tmp_path)
    assert values["vague names per 1000"] == 1000.0
    assert values["classes that are not nouns"] == 3
    assert values["class names defined more than once"] == 1
    assert values["module basenames used more than twice"] == 1
    assert values["summaries that start with a question word"] == 3
    assert values["... in percent "] == pytest.approx(66.7)
    assert values["dialect words per 1000 words of docstrings and comments"] > 0.3

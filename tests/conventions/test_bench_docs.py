"""Tests of the bench pages: they describe values, tests and channels as the program does."""

from __future__ import annotations

import re
from pathlib import Path

from poppet.bench.iso10094 import valve_recordings
from poppet.bench.iso10094.bench_result import DEFINITIONS, TESTS, BenchResult
from poppet.bench.iso10094.evaluation import VERIFY

ROOT = Path(__file__).parents[2]
TEXT = "".join((ROOT / "docs" / name).read_text(encoding="utf-8") for name in ("bench.md", "bench_definitions.md"))


def rows(columns: int) -> list[tuple[str, ...]]:
    """Return the rows of all tables with this number of columns."""
    lines = [line for line in TEXT.splitlines() if line.startswith("| `") and line.count(" | ") == columns - 1]
    return [tuple(cell.strip() for cell in line.strip("|").split(" | ")) for line in lines]


def test_definitions_equal_those_of_the_program():
    expected = [(f"`{d.name}`", d.unit, d.text, f"`{d.of.name}`") for d in DEFINITIONS.values()]
    assert [row for row in rows(4) if row[-1].startswith("`")] == expected


def test_limits_of_definitions_equal_those_of_the_program():
    limits = [(name, text) for names, text in rows(2) for name in names.split(", ")]
    assert [d.name for d in DEFINITIONS.values() if (f"`{d.name}`", d.limits) not in limits] == []


def test_parts_of_the_standard_are_documented():
    for part in {d.of.part for d in DEFINITIONS.values()}:
        (names,) = re.findall(rf"^- (.*): {re.escape(part)}\.$", TEXT, re.MULTILINE)
        tests = dict.fromkeys(f"`{d.of.name}`" for d in DEFINITIONS.values() if d.of.part == part)
        assert sorted(names.split(", ")) == sorted(tests)


def test_every_test_is_documented():
    assert [name for name, test in TESTS.items() if (f"`{name}`", test.meaning) not in rows(2)] == []
    assert [name for name in TESTS if f"- **{name}**: " not in TEXT] == []


def test_every_channel_is_documented():
    assert [
        name for name, meaning in valve_recordings.CHANNELS.items() if (f'`"{name}"`', meaning) not in rows(2)
    ] == []


def test_every_field_is_documented():
    words = set(re.findall(r"\w+", " ".join(re.findall(r"`([^`\n]+)`", TEXT))))
    assert {*valve_recordings.TOP_LEVEL, *valve_recordings.OF_RECORDING, *valve_recordings.UNUSED} <= words
    result = BenchResult("", "circuit", {}, rows={test: [{}] for test in TESTS}, curves={}).content()
    assert set(result) - {"curves"} <= words


def test_unread_standard_is_marked():
    assert all(VERIFY in d.standard for d in DEFINITIONS.values())
    assert "The standard was not read" in TEXT


def test_definitions_have_text_limits_and_unit():
    assert [name for name, d in DEFINITIONS.items() if not (d.text and d.limits and d.unit)] == []

"""Result of a test bench, with its TOML and JSON files.

A result contains characteristic values, tables of cases, curves and notes.
"""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import product
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np

from poppet.bench.iso10094.characteristic import CHARACTERISTIC
from poppet.bench.iso10094.evaluation import BenchTest, CharacteristicValue, Definition, PlottedCurve
from poppet.bench.iso10094.flow import FLOW
from poppet.bench.iso10094.frequency import FREQUENCY
from poppet.bench.iso10094.resolution import RESOLUTION
from poppet.bench.iso10094.step import STEP
from poppet.bench.iso10094.supply import LEAKAGE, SUPPLY
from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputError
from poppet.core.notebook import HtmlMixin
from poppet.core.toml import ResultFileMixin, from_json

_ALL = (CHARACTERISTIC, RESOLUTION, FLOW, SUPPLY, LEAKAGE, STEP, FREQUENCY)
TESTS: Mapping[str, BenchTest] = MappingProxyType({test.name: test for test in _ALL})  # tests by name, as in `--tests`
DEFINITIONS: Mapping[str, Definition] = MappingProxyType(
    {name: definition for test in _ALL for name, definition in test.definitions.items()}
)
"""Definition of each characteristic value by name, in the order of the tests."""


METHOD = "iso10094"
MOST_POINTS = 240


@dataclass(frozen=True)
class BenchResult(ResultFileMixin, HtmlMixin):
    """Result of the bench for one test valve: characteristic values, tables, curves and notes."""

    title: str
    source: str  # `circuit`, `recordings` or `stand-in`
    figures: Mapping[str, CharacteristicValue]
    rows: Mapping[str, list[dict[str, Any]]] = field(default_factory=dict)  # mapping from test to cases
    curves: Mapping[str, list[PlottedCurve]] = field(default_factory=dict)  # mapping from test to curves
    notes: Mapping[str, tuple[Note, ...]] = field(default_factory=dict)  # by test; general notes under `bench`
    conditions: Mapping[str, Any] = field(default_factory=dict)  # conditions of a test under its name
    comparison: Mapping[str, Any] = field(default_factory=dict)  # result of `compare_bench_results`
    outcome: str = "done"  # `done`, `failed` if a test could not be run, or `interrupted`

    def content(self) -> dict[str, Any]:
        """Return the content of the result file as nested dictionaries.

        The dictionaries have the same keys as the TOML and JSON files.
        """
        figures = {
            name: {"value": f.value, "unit": f.unit, "definition": f.definition, "standard": DEFINITIONS[name].standard}
            | ({"bound": f.bound} if f.bound else {})
            | ({"uncertainty": f.uncertainty} if f.uncertainty is not None else {})
            | ({"interval": list(f.interval)} if f.interval is not None else {})
            | ({"conditions": dict(f.conditions)} if f.conditions else {})
            for name, f in self.figures.items()
        }
        tables = {TESTS[test].table or test: rows for test, rows in self.rows.items() if rows}
        curves = {
            test: {f"{c.case} / {c.name}": {"x": _thinned(c.x), "y": _thinned(c.y)} for c in test_curves}
            for test, test_curves in self.curves.items()
        }
        return {
            "method": METHOD, "title": self.title, "source": self.source, "outcome": self.outcome,
            "notes": [f"{test}: {note}" for test, notes in self.notes.items() for note in notes],
            "codes": [{"test": test} | note.plain() for test, notes in self.notes.items() for note in notes],
            "conditions": dict(self.conditions), "figures": figures,
            "comparison": {k: [str(n) for n in v] if k == "notes" else v for k, v in self.comparison.items()},
            **tables, "curves": curves,
        }  # fmt: skip


def _thinned(values: Any) -> list[float]:
    indices = np.unique(np.linspace(0, len(values) - 1, min(len(values), MOST_POINTS)).astype(int))
    return [float(f"{value:.7g}") for value in np.asarray(values)[indices]]


def read_bench_result(path: str | Path) -> BenchResult:
    """Read a bench result from a TOML or JSON file."""
    from poppet.core.toml_file import TomlFile

    path = Path(path)
    file = TomlFile.read(path)
    try:
        data = from_json(json.loads(file.text)) if path.suffix.lower() == ".json" else file.tables
        if not is_result(data):
            raise ValueError(f"method is not {METHOD}")
        figures = {
            name: CharacteristicValue(
                float(f["value"]), f["unit"], f["definition"], f.get("bound", ""), f.get("conditions", {}),
                f.get("uncertainty"), tuple(f["interval"]) if "interval" in f else None,
            )
            for name, f in data["figures"].items()
        }  # fmt: skip
        unknown = [name for name in figures if name not in DEFINITIONS]
        if unknown:
            raise ValueError(f"unknown figures: {', '.join(unknown)}")
        curves: dict[str, list[PlottedCurve]] = {}
        for test, test_curves in data.get("curves", {}).items():
            for heading, points in test_curves.items():
                case, _, name = heading.rpartition(" / ")
                x, y = (np.array(points[key], dtype=float) for key in ("x", "y"))
                curves.setdefault(test, []).append(PlottedCurve(name, case, x, y))
        rows = {name: data[test.table or name] for name, test in TESTS.items() if (test.table or name) in data}
        conditions, comparison = data.get("conditions", {}), data.get("comparison", {})
        pairs: list[tuple[str, Any]] = [(entry["test"], {**entry}) for entry in data.get("codes", ())]
        for _, table in pairs:
            del table["test"]  # the remaining fields are the note
        # A file without note codes contains sentences, each of which begins with the name of its test.
        pairs = pairs or [(entry.partition(": ")[0], entry.partition(": ")[2]) for entry in data.get("notes", ())]
        notes = {test: notes_of(note for owner, note in pairs if owner == test) for test in dict.fromkeys(dict(pairs))}
        outcome = data.get("outcome", "done")
        return BenchResult(data["title"], data["source"], figures, rows, curves, notes, conditions, comparison, outcome)
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise InputError("bench.no_result", path=str(path), why=str(error)) from None


def is_result(data: Mapping[str, Any]) -> bool:
    """Return True if the content of a TOML or JSON file is a bench result."""
    return data.get("method") == METHOD


def compare_bench_results(result: BenchResult, other_result: BenchResult) -> dict[str, Any]:
    """Compare the characteristic values of two bench results.

    The result contains the title of `other_result`, notes, and one entry per characteristic value. An entry has the
    unit, both values, and their difference: the value of `result` minus that of `other_result`. Bounds have no
    difference. The notes name the conditions of the tests that differ and affect the comparison, such as the supply
    pressure.

    Examples
    --------
    >>> figure = CharacteristicValue(2.0, "s", "")
    >>> there = BenchResult("b", "circuit", {"delay": CharacteristicValue(1.0, "s", "")})
    >>> compare_bench_results(BenchResult("a", "circuit", {"delay": figure}), there)["figures"]["delay"]["difference"]
    1.0
    """
    rows: dict[str, dict[str, Any]] = {}
    for name in DEFINITIONS:
        value, reference = result.figures.get(name), other_result.figures.get(name)
        if value is None and reference is None:
            continue
        row: dict[str, Any] = {"unit": DEFINITIONS[name].unit}
        present = {key: f for key, f in (("value", value), ("other", reference)) if f is not None}
        row |= {key: f.value for key, f in present.items()}
        row |= {f"{key}_bound": f.bound for key, f in present.items() if f.bound}
        if value is not None and reference is not None and not value.bound and not reference.bound:
            row["difference"] = value.value - reference.value
        rows[name] = row
    # Different conditions that affect the comparison.
    notes = []
    for key in ("full_scale", "supply_pressure", "volumes"):
        here, there = (candidate.conditions.get(key) for candidate in (result, other_result))
        if here is not None and there is not None and not np.allclose(here, there, rtol=1e-3, atol=0.0):
            notes.append(Note(f"bench.differs.{key}", here=here, there=there))
    for test, key in product(TESTS, ("flow_drawn", "flow_fed", "amplitude", "mean")):
        here, there = (candidate.conditions.get(test, {}).get(key) for candidate in (result, other_result))
        if here and there and abs(here - there) > 0.02 * abs(here):
            notes.append(Note(f"bench.differs.{key}", test, here=here, there=there))
    return {"other": other_result.title, "notes": notes, "figures": rows}

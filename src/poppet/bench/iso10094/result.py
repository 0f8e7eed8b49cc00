"""What a bench ends in: figures with their definitions, tables of cases, sentences; as TOML or JSON."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from poppet.bench.iso10094.definitions import DEFINITIONS, TESTS
from poppet.bench.iso10094.evaluation import Curve, Figure
from poppet.ground.errors import InputError
from poppet.ground.files import by_suffix, write_whole
from poppet.ground.toml import from_json, json_text, toml_text

METHOD = "iso10094"
TABLES: Mapping[str, str] = {
    "characteristic": "characteristic",
    "resolution": "resolution",
    "flow": "flow",
    "supply": "supply",
    "leakage": "leakage",
    "step": "steps",
    "frequency": "frequencies",
}
"""Test to the table of its cases in a result."""
MOST_POINTS = 240


@dataclass(frozen=True)
class BenchResult:
    """Outcome of a bench.

    Parameters
    ----------
    title : str
        For people.
    source : str
        `circuit`, `recordings` or `stand-in`.
    figures : mapping
        Name to figure.
    rows : mapping
        Test to its cases.
    curves : mapping
        Test to its curves.
    notes : mapping
        Test to sentences: findings, and why a figure is absent. Those of the whole bench stand under `bench`.
    conditions : mapping
        Ranges, supply, volumes, files; those of a test stand under its name.
    comparison : mapping
        Name of a figure to its value here, there, and the difference; with `other`, the title.
    outcome : str
        `done`, `failed` where a test could not be run, or `interrupted`.
    """

    title: str
    source: str
    figures: Mapping[str, Figure]
    rows: Mapping[str, list[dict[str, Any]]] = field(default_factory=dict)
    curves: Mapping[str, list[Curve]] = field(default_factory=dict)
    notes: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    conditions: Mapping[str, Any] = field(default_factory=dict)
    comparison: Mapping[str, Any] = field(default_factory=dict)
    outcome: str = "done"

    def content(self) -> dict[str, Any]:
        """Everything that is written to a file, as plain tables."""
        figures = {
            name: {"value": f.value, "unit": f.unit, "definition": f.definition, "standard": DEFINITIONS[name].standard}
            | ({"bound": f.bound} if f.bound else {})
            | ({"conditions": dict(f.conditions)} if f.conditions else {})
            for name, f in self.figures.items()
        }
        tables = {TABLES[test]: _complete(rows) for test, rows in self.rows.items() if rows}
        curves = {
            test: {f"{c.case} / {c.name}": {"x": _thinned(c.x), "y": _thinned(c.y)} for c in found}
            for test, found in self.curves.items()
        }
        return {
            "method": METHOD,
            "title": self.title,
            "source": self.source,
            "outcome": self.outcome,
            "notes": [f"{test}: {sentence}" for test, sentences in self.notes.items() for sentence in sentences],
            "conditions": dict(self.conditions),
            "figures": figures,
            "comparison": dict(self.comparison),
            **tables,
            "curves": curves,
        }

    def save(self, path: str | Path) -> None:
        """Write the result, `.toml` or `.json`, aside and renamed."""
        text = by_suffix(Path(path), {".toml": toml_text, ".json": json_text})(self.content())
        write_whole(Path(path), lambda stream: stream.write(text.encode("utf-8")))


def _complete(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Rows without what only the evaluation needs."""
    return [{key: value for key, value in row.items() if not key.startswith("_")} for row in rows]


def _thinned(values: Any) -> list[float]:
    kept = np.unique(np.linspace(0, len(values) - 1, min(len(values), MOST_POINTS)).astype(int))
    return [float(f"{value:.7g}") for value in np.asarray(values)[kept]]


def read_bench_result(path: str | Path) -> BenchResult:
    """Read a result of the bench."""
    from poppet.ground.toml_file import read_text

    path = Path(path)
    text = read_text(path)
    try:
        data = from_json(json.loads(text)) if path.suffix.lower() == ".json" else tomllib.loads(text)
        return _result(data)
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise InputError(str(path), f"is not a result of `poppet bench`: {error}.", "Name its RESULT.toml.") from None


def is_result(data: Mapping[str, Any]) -> bool:
    """True for the tables of a result of the bench."""
    return data.get("method") == METHOD


def _result(data: Mapping[str, Any]) -> BenchResult:
    if not is_result(data):
        raise ValueError(f"method is not {METHOD}")
    figures = {
        name: Figure(float(f["value"]), f["unit"], f["definition"], f.get("bound", ""), f.get("conditions", {}))
        for name, f in data["figures"].items()
    }
    unknown = [name for name in figures if name not in DEFINITIONS]
    if unknown:
        raise ValueError(f"unknown figures: {', '.join(unknown)}")
    curves: dict[str, list[Curve]] = {}
    for test, named in data.get("curves", {}).items():
        for heading, points in named.items():
            case, _, name = heading.rpartition(" / ")
            x, y = (np.array(points[key], dtype=float) for key in ("x", "y"))
            curves.setdefault(test, []).append(Curve(name, case, x, y))
    return BenchResult(
        data["title"],
        data["source"],
        figures,
        {test: data[table] for test, table in TABLES.items() if table in data},
        curves,
        _notes(data.get("notes", [])),
        data.get("conditions", {}),
        data.get("comparison", {}),
        data.get("outcome", "done"),
    )


def _notes(sentences: list[str]) -> dict[str, tuple[str, ...]]:
    """Sentences of a file by the test that they begin with."""
    found: dict[str, list[str]] = {}
    for sentence in sentences:
        test, _, text = sentence.partition(": ")
        found.setdefault(test, []).append(text)
    return {test: tuple(texts) for test, texts in found.items()}


def compared(result: BenchResult, other: BenchResult) -> dict[str, Any]:
    """Figures of two results beside each other.

    Examples
    --------
    >>> figure = Figure(2.0, "s", "")
    >>> there = BenchResult("b", "circuit", {"delay": Figure(1.0, "s", "")})
    >>> compared(BenchResult("a", "circuit", {"delay": figure}), there)["figures"]["delay"]["difference"]
    1.0
    """
    rows: dict[str, dict[str, Any]] = {}
    for name in DEFINITIONS:
        here, there = result.figures.get(name), other.figures.get(name)
        if here is None and there is None:
            continue
        row: dict[str, Any] = {"unit": DEFINITIONS[name].unit}
        row |= {key: f.value for key, f in (("value", here), ("other", there)) if f is not None}
        row |= {f"{key}_bound": f.bound for key, f in (("value", here), ("other", there)) if f is not None and f.bound}
        if here is not None and there is not None and not here.bound and not there.bound:
            row["difference"] = here.value - there.value
        rows[name] = row
    return {"other": other.title, "notes": _unfair(result, other), "figures": rows}


def _unfair(result: BenchResult, other: BenchResult) -> list[str]:
    """Conditions in which two results differ, and which their figures depend on."""
    sentences = []
    for key, unit in (("full_scale", "Pa"), ("supply_pressure", "Pa"), ("volumes", "m^3")):
        here, there = (each.conditions.get(key) for each in (result, other))
        if here is not None and there is not None and not np.allclose(here, there, rtol=1e-3, atol=0.0):
            sentences.append(f"{key.replace('_', ' ')} differs: {_shown(here)} here, {_shown(there)} there [{unit}].")
    for test in TESTS:
        for key in ("flow_drawn", "flow_fed", "amplitude", "mean"):
            here, there = (each.conditions.get(test, {}).get(key) for each in (result, other))
            if here and there and abs(here - there) > 0.02 * abs(here):
                sentences.append(f"{test}: {key.replace('_', ' ')} differs: {here:.4g} here, {there:.4g} there.")
    return sentences


def _shown(values: Any) -> str:
    return ", ".join(f"{float(value):.5g}" for value in np.atleast_1d(values))

"""What a bench ends in: figures with their definitions, tables of cases, sentences; as TOML or JSON."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from poppet.bench.iso10094.definitions import DEFINITIONS, TESTS
from poppet.bench.iso10094.evaluation import CharacteristicValue, Curve
from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputError
from poppet.core.files import by_suffix, write_whole
from poppet.core.notebook import HtmlMixin
from poppet.core.toml import from_json, json_text, toml_text

METHOD = "iso10094"
MOST_POINTS = 240


@dataclass(frozen=True)
class BenchResult(HtmlMixin):
    """Outcome of a bench."""

    title: str
    source: str  # `circuit`, `recordings` or `stand-in`
    figures: Mapping[str, CharacteristicValue]
    rows: Mapping[str, list[dict[str, Any]]] = field(default_factory=dict)  # test to its cases
    curves: Mapping[str, list[Curve]] = field(default_factory=dict)  # test to its curves
    notes: Mapping[str, tuple[Note, ...]] = field(default_factory=dict)  # by test; of the whole bench under `bench`
    conditions: Mapping[str, Any] = field(default_factory=dict)  # those of a test stand under its name
    comparison: Mapping[str, Any] = field(default_factory=dict)  # as `compared` makes it
    outcome: str = "done"  # `done`, `failed` where a test could not be run, or `interrupted`

    def content(self) -> dict[str, Any]:
        """Everything that is written to a file, as plain tables."""
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
            test: {f"{c.case} / {c.name}": {"x": _thinned(c.x), "y": _thinned(c.y)} for c in found}
            for test, found in self.curves.items()
        }
        return {
            "method": METHOD,
            "title": self.title,
            "source": self.source,
            "outcome": self.outcome,
            "notes": [f"{test}: {note}" for test, notes in self.notes.items() for note in notes],
            "codes": [{"test": test} | note.plain() for test, notes in self.notes.items() for note in notes],
            "conditions": dict(self.conditions),
            "figures": figures,
            "comparison": {
                key: [str(note) for note in value] if key == "notes" else value
                for key, value in self.comparison.items()
            },
            **tables,
            "curves": curves,
        }

    def save(self, path: str | Path) -> None:
        """Write the result, `.toml` or `.json`, aside and renamed."""
        text = by_suffix(Path(path), {".toml": toml_text, ".json": json_text})(self.content())
        write_whole(Path(path), lambda stream: stream.write(text.encode("utf-8")))


def _thinned(values: Any) -> list[float]:
    kept = np.unique(np.linspace(0, len(values) - 1, min(len(values), MOST_POINTS)).astype(int))
    return [float(f"{value:.7g}") for value in np.asarray(values)[kept]]


def read_bench_result(path: str | Path) -> BenchResult:
    """Read a result of the bench."""
    from poppet.core.toml_file import TomlFile

    path = Path(path)
    file = TomlFile.read(path)
    try:
        data = from_json(json.loads(file.text)) if path.suffix.lower() == ".json" else file.tables
        return _result(data)
    except (ValueError, KeyError, TypeError, AttributeError, RecursionError) as error:
        raise InputError("bench.no_result", path=str(path), why=str(error)) from None


def is_result(data: Mapping[str, Any]) -> bool:
    """True for the tables of a result of the bench."""
    return data.get("method") == METHOD


def _result(data: Mapping[str, Any]) -> BenchResult:
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
        {test: data[each.table or test] for test, each in TESTS.items() if (each.table or test) in data},
        curves,
        _notes(data),
        data.get("conditions", {}),
        data.get("comparison", {}),
        data.get("outcome", "done"),
    )


def _notes(data: Mapping[str, Any]) -> dict[str, tuple[Note, ...]]:
    """Notes of a file by their test; files without codes have sentences that begin with it."""
    pairs: list[tuple[str, Any]] = [(each["test"], {**each}) for each in data.get("codes", ())]
    for _, table in pairs:
        del table["test"]  # the rest is the note
    pairs = pairs or [(each.partition(": ")[0], each.partition(": ")[2]) for each in data.get("notes", ())]
    return {test: notes_of(each for owner, each in pairs if owner == test) for test in dict.fromkeys(dict(pairs))}


def compared(result: BenchResult, other: BenchResult) -> dict[str, Any]:
    """Figures of two results beside each other.

    Examples
    --------
    >>> figure = CharacteristicValue(2.0, "s", "")
    >>> there = BenchResult("b", "circuit", {"delay": CharacteristicValue(1.0, "s", "")})
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


def _unfair(result: BenchResult, other: BenchResult) -> list[Note]:
    """Conditions in which two results differ, and which their figures depend on."""
    notes = []
    for key in ("full_scale", "supply_pressure", "volumes"):
        here, there = (each.conditions.get(key) for each in (result, other))
        if here is not None and there is not None and not np.allclose(here, there, rtol=1e-3, atol=0.0):
            notes.append(Note(f"bench.differs.{key}", here=here, there=there))
    for test in TESTS:
        for key in ("flow_drawn", "flow_fed", "amplitude", "mean"):
            here, there = (each.conditions.get(test, {}).get(key) for each in (result, other))
            if here and there and abs(here - there) > 0.02 * abs(here):
                notes.append(Note(f"bench.differs.{key}", test, here=here, there=there))
    return notes

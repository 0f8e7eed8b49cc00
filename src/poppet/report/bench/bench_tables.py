"""Tables of a bench's page: figures with their definitions, cases of each test, conditions."""

from __future__ import annotations

import html
from collections.abc import Callable, Mapping
from typing import Any

from poppet.bench.iso10094.bench_result import BenchResult
from poppet.bench.iso10094.definitions import TESTS
from poppet.bench.iso10094.evaluation import CharacteristicValue
from poppet.report.bench.bench_text import NOTHING, SECTIONS, conditions_text, figure_text, name_text, value_text
from poppet.report.html_page import table


def figure_table(result: BenchResult, other: BenchResult | None = None) -> str:
    """Every figure with what it is; beside it that of another valve."""
    width = 5 if other else 3
    rows: list[list[str]] = []
    for test, each in TESTS.items():
        known = [name for name in each.definitions if any(name in r.figures for r in (result, other) if r)]
        if known:
            rows.append([f"<strong>{html.escape(SECTIONS[test].title)}</strong>", *([""] * (width - 1))])
        rows += [_figure_row(name, result, other) for name in known]
    headings = ["figure", _short(result.title) if other else "value ± 95 %"]
    headings += [_short(other.title), "ratio"] if other else []
    return table([*headings, "holds for; definition"], rows, numbers=(1, 2, 3) if other else (1,))


def _figure_row(name: str, result: BenchResult, other: BenchResult | None) -> list[str]:
    here, there = (None if each is None else each.figures.get(name) for each in (result, other))
    row = [html.escape(name_text(name)), _whole(figure_text(here))]
    if other is not None:
        row += [_whole(figure_text(there)), _ratio(here, there)]
    shown = here or there
    assert shown is not None
    where = html.escape(conditions_text(shown))
    return [*row, (f"{where}<br>" if where else "") + f'<span class="lead">{html.escape(shown.definition)}</span>']


def _whole(text: str) -> str:
    """A cell that is not broken."""
    return html.escape(text).replace(" ", "&nbsp;")


def _short(title: str) -> str:
    return title if len(title) <= 28 else f"{title[:27]}…"


def _ratio(here: CharacteristicValue | None, there: CharacteristicValue | None) -> str:
    if here is None or there is None or here.bound or there.bound:
        return "-"
    # Over a percentage that is nothing but the rounding of a solver a ratio would say nothing.
    is_nothing = there.value == 0.0 or (there.unit in ("% FS", "%") and abs(there.value) < NOTHING)
    return "-" if is_nothing else f"{here.value / there.value:.2f}"


def case_table(result: BenchResult, test: str) -> str:
    """The cases of a test."""
    section, rows = SECTIONS[test], result.rows.get(test, ())
    keys = [key for key in section.columns if any(key in row for row in rows)]
    if not keys:
        return ""
    headings, units = zip(*map(section.column, keys), strict=True)
    body = [[_whole(_cell(row, *pair)) for pair in zip(keys, units, strict=True)] for row in rows]
    return table(headings, body, numbers=[k for k, unit in enumerate(units) if unit != "word"])


def _cell(row: Mapping[str, Any], key: str, unit: str) -> str:
    if key not in row:
        return "-"
    return str(row[key]) if unit == "word" else value_text(row[key], unit, row.get(f"{key}_bound", ""))


def condition_table(result: BenchResult) -> str:
    """What the tests were done with."""
    c = result.conditions
    unit = str(c.get("setpoint_unit", ""))
    shown: tuple[tuple[str, str, Callable[[Any], str]], ...] = (
        ("setpoint_range", "setpoint range", lambda ends: _range(ends, unit)),
        ("full_scale", "full scale", lambda ends: f"{_range(ends, 'Pa')}, absolute"),
        ("supply_pressure", "supply pressure", lambda value: f"{value_text(value, 'Pa')}, absolute"),
        ("volumes", "volumes at the outlet", lambda values: ", ".join(value_text(v, "m^3") for v in values)),
        ("circuit", "circuit", str),
        ("valve", "valve", str),
        ("changed", "changed", ", ".join),
    )
    rows = [[heading, text(c[key])] for key, heading, text in shown if key in c]
    rows += [[f"recordings, {test}", ", ".join(names)] for test, names in c.get("recordings", {}).items()]
    sweep = c.get("characteristic", {})
    if "sweep_rate" in sweep:
        branches = f"{sweep['branches_up']} up, {sweep['branches_down']} down"
        rows.append(["sweep of the setpoint", f"{sweep['sweep_rate']:.3g} % FS/s, {branches}"])
    flow = c.get("flow", {})
    rows += [
        [f"rated flow {way}", value_text(flow[key], "kg/s")]
        for key, way in (("flow_drawn", "out"), ("flow_fed", "in"))
        if key in flow
    ]
    return table([], [[html.escape(cell) for cell in row] for row in rows]) if rows else ""


def _range(ends: Any, unit: str) -> str:
    return f"{value_text(float(ends[0]), unit)} to {value_text(float(ends[1]), unit)}"

"""Tables of a bench's page: figures with their definitions, cases of each test, conditions."""

from __future__ import annotations

import html
from collections.abc import Mapping
from typing import Any

from poppet.bench.iso10094.definitions import DEFINITIONS
from poppet.bench.iso10094.evaluation import Figure
from poppet.bench.iso10094.result import BenchResult
from poppet.report.bench.words import SECTIONS, conditions_text, figure_text, name_text, value_text
from poppet.report.page import table


def figure_table(result: BenchResult, other: BenchResult | None = None) -> str:
    """Every figure with what it is; beside it that of another valve."""
    rows: list[list[str]] = []
    last = ""
    width = 5 if other else 3
    for name, definition in DEFINITIONS.items():
        here, there = result.figures.get(name), (other.figures.get(name) if other else None)
        if here is None and there is None:
            continue
        if definition.of.name != last:
            last = definition.of.name
            rows.append([f"<strong>{html.escape(SECTIONS[last].title)}</strong>", *([""] * (width - 1))])
        rows.append(_figure_row(name, here, there, result, other))
    headings = ["figure", _short(result.title) if other else "value"]
    headings += [_short(other.title), "ratio"] if other else []
    return table([*headings, "holds for; definition"], rows, numbers=(1, 2, 3) if other else (1,))


def _figure_row(
    name: str, here: Figure | None, there: Figure | None, result: BenchResult, other: BenchResult | None
) -> list[str]:
    row = [html.escape(name_text(name)), _whole(figure_text(here))]
    if other is not None:
        row += [_whole(figure_text(there)), html.escape(_ratio(result, other, name))]
    shown = here if here is not None else there
    assert shown is not None
    where = html.escape(conditions_text(shown))
    return [*row, (f"{where}<br>" if where else "") + f'<span class="lead">{html.escape(shown.definition)}</span>']


def _whole(text: str) -> str:
    """A cell that is not broken."""
    return html.escape(text).replace(" ", "&nbsp;")


def _short(title: str) -> str:
    return title if len(title) <= 28 else f"{title[:27]}…"


def _ratio(result: BenchResult, other: BenchResult, name: str) -> str:
    here, there = result.figures.get(name), other.figures.get(name)
    if (
        here is None
        or there is None
        or here.bound
        or there.bound
        or abs(there.value) < 1e-4 * (there.unit in ("% FS", "%"))
        or there.value == 0.0
    ):
        return "-"
    return f"{here.value / there.value:.2f}"


def case_table(result: BenchResult, test: str) -> str:
    """The cases of a test."""
    rows = list(result.rows.get(test, ()))
    cells = [cell for cell in SECTIONS[test].columns if any(cell[0] in row for row in rows)]
    if not rows or not cells:
        return ""
    headings = [heading for _, heading, _ in cells]
    body = [[_whole(_cell(row, key, unit)) for key, _, unit in cells] for row in rows]
    numbers = [k for k, (_, _, unit) in enumerate(cells) if unit != "word"]
    return table(headings, body, numbers=numbers)


def _cell(row: Mapping[str, Any], key: str, unit: str) -> str:
    if key not in row:
        return "-"
    return str(row[key]) if unit == "word" else value_text(row[key], unit, row.get(f"{key}_bound", ""))


def condition_table(result: BenchResult) -> str:
    """What the tests were done with."""
    c = result.conditions
    unit = str(c.get("setpoint_unit", ""))
    rows = [["setpoint range", _range(c["setpoint_range"], unit)]] if "setpoint_range" in c else []
    rows += [["full scale", f"{_range(c['full_scale'], 'Pa')}, absolute"]] if "full_scale" in c else []
    if "supply_pressure" in c:
        rows.append(["supply pressure", f"{value_text(c['supply_pressure'], 'Pa')}, absolute"])
    if "volumes" in c:
        rows.append(["volumes at the outlet", ", ".join(value_text(v, "m^3") for v in c["volumes"])])
    rows += [[key, str(c[key])] for key in ("circuit", "valve") if key in c]
    if "changed" in c:
        rows.append(["changed", ", ".join(c["changed"])])
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

"""HTML report of a bench test on a valve: characteristic values, tests and conditions."""

from __future__ import annotations

import html
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.bench.iso10094.bench_result import TESTS, BenchResult
from poppet.bench.iso10094.evaluation import VERIFY, CharacteristicValue
from poppet.report.bench import bench_figures
from poppet.report.bench.bench_text import DESCRIPTIONS, NOTHING, conditions_text, figure_text, value_text, verdict
from poppet.report.html_page import Section, document, findings, head, paragraph, picture, write_page
from poppet.report.styles import stylesheet
from poppet.report.tables import Column, Markup, ReportTable, numeric, with_detail
from poppet.timeseries.plotting.figures import style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_FIGURES: Mapping[str, Callable[[BenchResult, BenchResult | None], Figure]] = {
    "characteristic": bench_figures.characteristic_figure,
    "resolution": bench_figures.resolution_figure,
    "flow": bench_figures.flow_figure,
    "supply": bench_figures.supply_figure,
    "step": bench_figures.step_figure,
    "frequency": bench_figures.bode_figure,
}
_SOURCES = {
    "circuit": "Virtual test bench: characteristic values of a simulated model.",
    "recordings": "Characteristic values of a valve from recordings of a bench.",
    "stand-in": "Characteristic values of a virtual valve with known properties.",
}
_WARNINGS = {"failed": "A test was not completed.", "interrupted": "The bench was interrupted."}
_STANDARD = (
    "<p>The tests follow the ideas of ISO 10094-1 and -2 (Pneumatic fluid power, electro-pneumatic pressure control "
    "valves). The definitions on this page were written without access to the standard. To state values according to "
    f"it, {VERIFY} first. The table above contains the definitions, bands and rates of these tests.</p>\n"
)


def write_bench(result: BenchResult, path: str | Path, other: BenchResult | None = None) -> Path:
    """Write the HTML report of a bench test; equal results give equal bytes.

    `other` is the result of a reference valve.
    """
    return write_page(path, lambda: bench_page(result, other))


def bench_page(result: BenchResult, other: BenchResult | None = None) -> str:
    """Return the report of a bench test as HTML.

    `other` is the result of a reference valve, whose values are also shown.
    """
    with style("A report of a bench"):
        tests = [test for test in TESTS if test in result.rows]
        sections = [
            Section("", _head(result, other, tests)),
            Section("Characteristic values", figure_table(result, other)),
            *(Section(DESCRIPTIONS[test].title, _test(result, other, test)) for test in tests),
            Section("Conditions", _condition_table(result)),
            Section("About the standard", _STANDARD),
        ]
    return document(result.title, sections, style=stylesheet("bench"))


def _head(result: BenchResult, reference: BenchResult | None, tests: list[str]) -> str:
    lines = "".join(
        f"<p><strong>{DESCRIPTIONS[test].title}</strong> <span>{html.escape(text)}</span></p>\n"
        for test in tests
        if (text := verdict(result, test))
    )
    lead = _SOURCES.get(result.source, result.source) + (f" Compared with: {reference.title}." if reference else "")
    notes = [*result.notes.get("bench", ()), *result.comparison.get("notes", ())]
    warning = paragraph(_WARNINGS.get(result.outcome, ""), bold=True)
    return f'{head(result.title, lead)}{warning}<div class="summary">{lines}</div>\n{findings(notes)}'


def _test(result: BenchResult, reference: BenchResult | None, test: str) -> list[str | ReportTable]:
    description, meaning = DESCRIPTIONS[test], TESTS[test].meaning
    figure = ""
    if result.curves.get(test) and test in _FIGURES:
        has_reference = reference is not None and reference.curves.get(test)
        caption = description.caption + (f" Dashed: {reference.title}." if reference and has_reference else "")
        figure = picture(_FIGURES[test](result, reference), test, caption, label=description.title)
    text = paragraph(f"{meaning[:1].upper() + meaning[1:]}.")
    return [text, figure, findings(result.notes.get(test, ())), _case_table(result, test)]


def figure_table(result: BenchResult, reference: BenchResult | None = None) -> ReportTable:
    """Return all characteristic values with their definitions.

    The values of a reference valve are in a second column.
    """
    rows: list[list[Any]] = []
    headings = ["value ± 95 %"] if reference is None else [*map(_short, (result.title, reference.title)), "ratio"]
    for test, definition in TESTS.items():
        names = [name for name in definition.definitions if any(name in r.figures for r in (result, reference) if r)]
        if names:
            title = Markup(f"<strong>{html.escape(DESCRIPTIONS[test].title)}</strong>")
            rows.append([title, *([""] * (len(headings) + 1))])
        for name in names:
            values = [None if valve is None else valve.figures.get(name) for valve in (result, reference)]
            value = values[0] or values[1]
            assert value is not None
            cells = [_unbroken(figure_text(v)) for v in values[: 1 if reference is None else 2]]
            cells += [] if reference is None else [_ratio(*values)]
            rows.append([name.replace("_", " "), *cells, with_detail(conditions_text(value), value.definition)])
    return ReportTable(("quantity", *numeric(*headings), "conditions; definition"), rows, css_class="figures")


def _unbroken(text: str) -> str:
    """Return a text with non-breaking spaces, so that it stays on one line."""
    return text.replace(" ", "\N{NO-BREAK SPACE}")


def _short(title: str) -> str:
    return title if len(title) <= 28 else f"{title[:27]}…"


def _ratio(value: CharacteristicValue | None, reference: CharacteristicValue | None) -> str:
    if value is None or reference is None or value.bound or reference.bound:
        return "-"
    # A percentage at the level of rounding has no meaningful ratio.
    is_zero = reference.value == 0.0 or (reference.unit in ("% FS", "%") and abs(reference.value) < NOTHING)
    return "-" if is_zero else f"{value.value / reference.value:.2f}"


def _case_table(result: BenchResult, test: str) -> ReportTable:
    """Return the results of one test: one row for each case (test condition)."""
    description, rows = DESCRIPTIONS[test], result.rows.get(test, ())
    keys = [key for key in description.columns if any(key in row for row in rows)]
    columns = [description.column(key) for key in keys]
    cells = [[_unbroken(_cell(row, key, unit)) for key, (_, unit) in zip(keys, columns, strict=True)] for row in rows]
    return ReportTable(
        [Column(heading, "" if unit == "word" else "s") for heading, unit in columns], cells if keys else ()
    )


def _cell(row: Mapping[str, Any], key: str, unit: str) -> str:
    if key not in row:
        return "-"
    return str(row[key]) if unit == "word" else value_text(row[key], unit, row.get(f"{key}_bound", ""))


def _condition_table(result: BenchResult) -> ReportTable:
    """Return the conditions under which the tests were made."""
    c = result.conditions
    unit = str(c.get("setpoint_unit", ""))
    formats: tuple[tuple[str, str, Callable[[Any], str]], ...] = (
        ("setpoint_range", "setpoint range", lambda ends: _range(ends, unit)),
        ("full_scale", "full scale", lambda ends: f"{_range(ends, 'Pa')}, absolute"),
        ("supply_pressure", "supply pressure", lambda value: f"{value_text(value, 'Pa')}, absolute"),
        ("volumes", "volumes at the outlet", lambda values: ", ".join(value_text(v, "m^3") for v in values)),
        ("circuit", "circuit", str),
        ("valve", "valve", str),
        ("changed", "changed", ", ".join),
    )
    rows = [(heading, text(c[key])) for key, heading, text in formats if key in c]
    rows += [(f"recordings, {test}", ", ".join(names)) for test, names in c.get("recordings", {}).items()]
    sweep, flow = c.get("characteristic", {}), c.get("flow", {})
    if "sweep_rate" in sweep:
        branches = f"{sweep['branches_up']} up, {sweep['branches_down']} down"
        rows.append(("sweep of the setpoint", f"{sweep['sweep_rate']:.3g} % FS/s, {branches}"))
    directions = ("flow_drawn", "out"), ("flow_fed", "in")
    rows += [(f"rated flow {text}", value_text(flow[key], "kg/s")) for key, text in directions if key in flow]
    return ReportTable(("", ""), rows)


def _range(ends: Any, unit: str) -> str:
    return f"{value_text(float(ends[0]), unit)} to {value_text(float(ends[1]), unit)}"

"""A bench as one page that needs nothing else: figures, pictures, words."""

from __future__ import annotations

import html
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.bench.iso10094.bench_result import BenchResult
from poppet.bench.iso10094.definitions import TESTS
from poppet.bench.iso10094.evaluation import VERIFY
from poppet.report.bench import bench_figures
from poppet.report.bench.bench_tables import case_table, condition_table, figure_table
from poppet.report.bench.bench_text import SECTIONS, verdict
from poppet.report.html_page import document, findings, head, picture, write_page
from poppet.timeseries.plotting.figures import style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

_STYLE = """
.summary { border: 1px solid var(--line); border-left: .4rem solid #1f5fa8; border-radius: .4rem;
  background: var(--wash); padding: .7rem 1.1rem; margin: 1.2rem 0 1.6rem; }
.summary p { margin: .35rem 0; max-width: none; }
main { max-width: 70rem; } .figures table { width: 100%; }
.figures td:last-child { font-size: .86rem; line-height: 1.4; }
.figures td:first-child { white-space: nowrap; } .figures td strong { display: inline-block; padding-top: .6rem; }
.summary p { display: grid; grid-template-columns: 12rem 1fr; } p { max-width: 56rem; }
@media (max-width: 40rem) { .summary { padding: .4rem .7rem; } .summary p { display: block; }
  .summary strong { display: block; } .figures td:last-child { flex-basis: 100%; } }
.findings { max-width: 56rem; } .findings li { margin: .3rem 0; }
"""
_PICTURES: Mapping[str, Callable[[BenchResult, BenchResult | None], Figure]] = {
    "characteristic": bench_figures.characteristic_figure,
    "resolution": bench_figures.resolution_figure,
    "flow": bench_figures.flow_figure,
    "supply": bench_figures.supply_figure,
    "step": bench_figures.step_figure,
    "frequency": bench_figures.bode_figure,
}
_SOURCES = {
    "circuit": "The virtual test bench: figures of a model, simulated.",
    "recordings": "Figures of a valve from recordings of a bench.",
    "stand-in": "Figures of a stand-in whose truth is known.",
}
_STANDARD = (
    "<p>The tests follow the ideas of ISO 10094-1 and -2 (Pneumatic fluid power, electro-pneumatic pressure control "
    "valves). The standard itself was not at hand when the definitions on this page were written: where figures are to "
    f"be stated after it, {VERIFY} first. The definitions, bands and rates used here stand in the table above.</p>\n"
)


def write_bench(result: BenchResult, path: str | Path, other: BenchResult | None = None) -> Path:
    """Write a bench as one page that needs nothing else; the same result gives the same bytes."""
    return write_page(path, lambda: bench_page(result, other))


def bench_page(result: BenchResult, other: BenchResult | None = None) -> str:
    """The page as text."""
    with style("A report of a bench"):
        tests = [test for test in TESTS if test in result.rows]
        sections = [
            ("", _head(result, other, tests)),
            ("Figures", f'<div class="figures">{figure_table(result, other)}</div>\n'),
            *((SECTIONS[test].title, _test(result, other, test)) for test in tests),
            ("Conditions", condition_table(result)),
            ("About the standard", _STANDARD),
        ]
    return document(result.title, sections, style=_STYLE)


def _head(result: BenchResult, other: BenchResult | None, tests: list[str]) -> str:
    words = {test: verdict(result, test) for test in tests}
    rows = "".join(
        f"<p><strong>{SECTIONS[test].title}</strong> <span>{html.escape(text)}</span></p>\n"
        for test, text in words.items()
        if text
    )
    source = _SOURCES.get(result.source, result.source)
    beside = f" Compared with: {other.title}." if other else ""
    ended = {"failed": "A test could not be run to its end.", "interrupted": "The bench was interrupted."}
    warning = f"<p><strong>{ended[result.outcome]}</strong></p>\n" if result.outcome in ended else ""
    notes = [*result.notes.get("bench", ()), *result.comparison.get("notes", ())]
    return f'{head(result.title, source + beside)}{warning}<div class="summary">{rows}</div>\n{findings(notes)}'


def _test(result: BenchResult, other: BenchResult | None, test: str) -> str:
    """Words, picture, findings and cases of a test."""
    section, meaning = SECTIONS[test], TESTS[test].meaning
    text = f"<p>{html.escape(meaning[:1].upper() + meaning[1:])}.</p>\n"
    if result.curves.get(test) and test in _PICTURES:
        dashed = f" Dashed: {other.title}." if other is not None and other.curves.get(test) else ""
        text += picture(_PICTURES[test](result, other), test, section.caption + dashed, label=section.title)
    return text + findings(result.notes.get(test, ())) + case_table(result, test)

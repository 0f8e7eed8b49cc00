"""Results of identification and bench in a notebook: the answer, its numbers, and what a reader has to know."""

from __future__ import annotations

import html
import math

from poppet.bench.iso10094.bench_result import BenchResult
from poppet.bench.limits.maps import LimitsResult
from poppet.identify.result import Result
from poppet.report.bench.bench_tables import figure_table
from poppet.report.html_page import table
from poppet.report.identification.headline import headline, next_step, sorted_out
from poppet.report.identification.identification_tables import parameter_table
from poppet.report.notebook.card import card, folded, notes


def shown(result: Result | BenchResult | LimitsResult) -> str:
    """A result as HTML."""
    if isinstance(result, Result):
        return _identification(result)
    return _bench(result) if isinstance(result, BenchResult) else _limits(result)


def _identification(result: Result) -> str:
    said, read = sorted_out(result.remarks)
    step = next_step(result)
    return card(
        result.title,
        f"Identification, {result.method}",
        f"<p><strong>{html.escape(headline(result))}</strong></p>",
        f"<p>Next: {html.escape(step)}</p>" if step else "",
        parameter_table(result.parameters) if result.parameters else "",
        notes(said),
        folded("how the recordings were read", notes(read)) if read else "",
    )


def _bench(result: BenchResult) -> str:
    ended = {"failed": " A test could not be run to its end.", "interrupted": " It was interrupted."}
    said = [note for test in result.notes.values() for note in test]
    lead = f"Bench: {len(result.figures)} figures, from a {result.source}.{ended.get(result.outcome, '')}"
    return card(result.title, lead, figure_table(result) if result.figures else "", notes(said))


def _limits(result: LimitsResult) -> str:
    plan = result.plan
    headings = ["volume", *(f"± {amplitude / 1e5:.3g} bar" for amplitude in plan.amplitudes)]
    cells = zip(plan.volumes, result.grid("gain_frequency"), result.grid("limiting"), strict=True)
    rows = [[f"{volume * 1e3:.3g} l", *map(_bandwidth, *at)] for volume, *at in cells] if result.points else []
    lead = f"Dynamic limits of {plan.valve} at {plan.mean / 1e5:.3g} bar: -3 dB frequency, and what limits it."
    blocks = [table(headings, rows) if rows else "", notes(result.findings)]
    return card(plan.circuit.title or plan.valve, lead, *blocks)


def _bandwidth(frequency: float, limiting: str) -> str:
    text = f"{frequency:.3g} Hz" if math.isfinite(frequency) else "-"
    return html.escape(f"{text}, {limiting}" if limiting else text)

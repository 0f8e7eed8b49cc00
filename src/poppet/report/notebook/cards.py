"""HTML output (card) of each class in notebooks.

The modules of the classes are imported when an object is displayed, so no function imports more than it needs.
"""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING
from zlib import crc32

import numpy as np

from poppet.core.errors import MissingDependencyError
from poppet.core.number_format import USUAL, pretty
from poppet.core.units import convert
from poppet.report.html_page import folded, inline_svg, paragraph
from poppet.report.notebook.card import MAX_ROWS, card, note_list, plural
from poppet.report.notebook.plot import plot
from poppet.report.tables import ReportTable, code, numeric
from poppet.timeseries.recording import Recording

if TYPE_CHECKING:
    from poppet.bench.iso10094.bench_result import BenchResult
    from poppet.bench.limits.maps import LimitsResult
    from poppet.circuit.circuit import BaseCircuit
    from poppet.circuit.linear_model import LinearModel
    from poppet.ensemble import Ensemble
    from poppet.identify.result import Result

MAX_PARTS = 40
"""Maximum number of parts in a drawing; larger drawings take seconds and are not readable in a notebook."""
ROUNDING = 1e-12
"""Fraction of the largest value of a series below which a table shows 0."""
_COLOURS = {
    "#1b1f24": "currentColor",
    "#49525e": "color-mix(in srgb, currentColor 72%, transparent)",
    "#6b7280": "color-mix(in srgb, currentColor 60%, transparent)",
    "#ffffff": "var(--paper)",
    "#eaf2fb": "color-mix(in srgb, #3b82c4 14%, var(--paper))",
    "#f3f4f6": "color-mix(in srgb, currentColor 7%, var(--paper))",
    "#f4effa": "color-mix(in srgb, #7d4fa3 14%, var(--paper))",
    "#fdeee4": "color-mix(in srgb, #c2410c 14%, var(--paper))",
    "#c2410c": "color-mix(in srgb, #c2410c 70%, currentColor)",
}
"""Mapping from the colours of a schematic to the colours of the notebook."""
_POINTS_PER_INCH = 72.0
_SCALE = 1.12
"""Size of a drawing in pixels relative to points."""


def circuit_card(circuit: BaseCircuit) -> str:
    """Return a circuit as HTML: schematic, assumed values and notes."""
    assumed = {address: number for address, number in circuit.numbers().items() if number.source.kind == "assumed"}
    rows = [(code(address), number.display(), number.source.note) for address, number in assumed.items()]
    table = ReportTable(("parameter", *numeric("value"), "reason"), rows)
    summary = f"{len(rows)} assumed value{'s' * (len(rows) != 1)}"
    values = folded(summary, table, is_open=len(rows) <= MAX_ROWS)
    values = values or paragraph("No value is assumed.", css_class="lead")
    lead = f"Circuit: {plural(len(circuit.parts), 'part')}, {plural(len(circuit.signals), 'driven input')}."
    return card(circuit.title, lead, _drawing(circuit), values, note_list(circuit.static_notes))


def _drawing(circuit: BaseCircuit) -> str:
    from poppet.report.circuit.schematic import draw_circuit
    from poppet.timeseries.plotting.figures import figure_bytes

    if len(circuit.parts) > MAX_PARTS:
        return ""
    try:
        figure = draw_circuit(replace(circuit, title="", like=circuit))  # the card shows the title
    except MissingDependencyError as error:
        return paragraph(str(error), css_class="lead")
    figure.patch.set_visible(False)
    svg = figure_bytes(figure, "svg", "notebook").decode("utf-8")
    # All drawings of a notebook share one page, so their identifiers must be unique.
    svg = inline_svg(svg, f"poppet{crc32(svg.encode()):08x}", f"Circuit {circuit.title}".strip())
    for colour, mixed in _COLOURS.items():
        svg = svg.replace(colour, mixed)
    svg = re.sub(r"<!--.*?-->|<defs>\s*<style.*?</style>\s*</defs>", "", svg, flags=re.DOTALL)
    svg = re.sub(r">\s+<", "><", svg)
    width = _SCALE * _POINTS_PER_INCH * figure.get_figwidth()
    svg = svg.replace("<svg ", f'<svg style="width:{width:.0f}px;max-width:none" ', 1)
    return f'<div class="scroll poppet-picture" tabindex="0">{svg}</div>'


def recording_card(recording: Recording) -> str:
    """Return a recording as HTML: plot, and first, last and extreme values of every output."""
    rows, columns = recording.time.size, len(recording)
    span = f"{recording.time[0]:.6g} ... {recording.time[-1]:.6g} s" if rows else "no samples"
    lead = f"Recording: {rows} rows, {columns} series, {span}. {recording.outcome}".rstrip()
    blocks: list[str | ReportTable] = []
    if rows and columns:
        names = sorted(recording.names, key=recording.inner.__contains__)
        more = names[MAX_ROWS:]
        blocks = [plot(recording), _series_table(recording, names[:MAX_ROWS])]
        blocks.append(folded(f"{len(more)} more series", _series_table(recording, more)))
    return card(recording.title, lead, *blocks, note_list(recording.remarks))


def _series_table(recording: Recording, names: Sequence[str]) -> ReportTable:
    rows = []
    for name in names:
        si_unit, values = recording.unit(name), recording[name]
        unit = USUAL.get(si_unit, si_unit)
        valid = values[~np.isnan(values)] if np.isnan(values).any() else values
        ends = np.array([values[0], values[-1], valid.min(initial=np.inf), valid.max(initial=-np.inf)])
        if unit != si_unit:
            ends = convert(ends, si_unit, unit, ambient_pressure=recording.ambient_pressure)
        threshold = ROUNDING * float(np.max(np.abs(ends[2:])))
        texts = ("0" if abs(value) < threshold else f"{value:z.5g}" for value in ends)
        rows.append((code(name), "" if unit == "1" else pretty(unit), *texts))
    return ReportTable(("series", "unit", *numeric("first", "last", "min", "max")), rows)


def linear_card(linear: LinearModel) -> str:
    """Return a linear model as HTML: numbers of states, inputs and outputs, modes, operating point."""
    from poppet.report.result_tables import mode_table

    sample_time = getattr(linear, "sample_time", 0.0)
    sizes = {"state": linear.states, "input": linear.inputs, "output": linear.outputs}
    lead = ", ".join(plural(len(names), noun) for noun, names in sizes.items())
    lead += f"; from one sample of {sample_time:.6g} s to the next" if sample_time else ""
    rows = [
        (kind, code(name), f"{value:z.6g}")
        for kind, names, values in (("state", linear.states, linear.x), ("input", linear.inputs, linear.u))
        for name, value in zip(names, values, strict=True)
    ]
    point = ReportTable(("", "address", *numeric("value")), rows)
    operating_point = folded("operating point, SI", point, is_open=len(rows) <= MAX_ROWS)
    return card("Linear model", lead, mode_table(linear), operating_point, note_list(getattr(linear, "notes", ())))


def ensemble_card(ensemble: Ensemble) -> str:
    """Return an ensemble as HTML: yield of the requirements and statistics of the metrics."""
    from poppet.report.ensemble.ensemble_report import metric_table, yield_table

    lead = f"Ensemble of {ensemble.done} runs"
    return card(ensemble.plan.circuit.title, lead, yield_table(ensemble), metric_table(ensemble))


def identification_card(result: Result) -> str:
    """Return an identification as HTML: headline, parameters and findings."""
    from poppet.report.identification.headline import headline, next_step, split_notes
    from poppet.report.identification.identification_tables import parameter_table

    findings, reading_notes = split_notes(result.remarks)
    step = next_step(result)
    return card(
        result.title,
        f"Identification, {result.method}",
        paragraph(headline(result), bold=True),
        paragraph(f"Next: {step}" if step else ""),
        parameter_table(result.parameters),
        note_list(findings),
        folded("reading of the recordings", note_list(reading_notes)),
    )


def bench_card(result: BenchResult) -> str:
    """Return a bench result as HTML: characteristic values and notes."""
    from poppet.report.bench.bench_report import figure_table

    outcomes = {"failed": " A test was not completed.", "interrupted": " It was interrupted."}
    notes = [note for test in result.notes.values() for note in test]
    outcome = outcomes.get(result.outcome, "")
    lead = f"Bench: {len(result.figures)} characteristic values, from a {result.source}.{outcome}"
    return card(result.title, lead, figure_table(result), note_list(notes))


def limits_card(result: LimitsResult) -> str:
    """Return the dynamic limits of a valve as HTML.

    The table has the bandwidth and the limiting part by load volume and amplitude.
    """
    plan, rows = result.plan, []
    grid = zip(plan.volumes, result.grid("gain_frequency"), result.grid("limiting"), strict=True)
    for volume, frequencies, parts in grid if result.points else ():
        texts = [f"{frequency:.3g} Hz" if math.isfinite(frequency) else "-" for frequency in frequencies]
        cells = (f"{text}, {part}" if part else text for text, part in zip(texts, parts, strict=True))
        rows.append((f"{volume * 1e3:.3g} l", *cells))
    columns = "volume", *(f"± {amplitude / 1e5:.3g} bar" for amplitude in plan.amplitudes)
    lead = f"Dynamic limits of {plan.valve} at {plan.mean / 1e5:.3g} bar: -3 dB frequency and the limiting part."
    return card(plan.circuit.title or plan.valve, lead, ReportTable(columns, rows), note_list(result.findings))

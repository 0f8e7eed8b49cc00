"""HTML output (card) of each class in notebooks, with a small SVG plot of recordings.

The modules of the classes are imported when an object is displayed, so no function imports more than it needs.

Text inherits the colour of the notebook; lines and backgrounds are mixed from it. The output therefore suits light and
dark themes of classic notebooks, JupyterLab and VS Code.
"""

from __future__ import annotations

import html
import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from typing import TYPE_CHECKING
from zlib import crc32

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import MissingDependencyError
from poppet.core.note_groups import grouped
from poppet.core.number_format import USUAL, pretty
from poppet.core.units import convert
from poppet.report.html_page import Content, folded, inline_svg, items, paragraph, render
from poppet.report.styles import stylesheet
from poppet.report.tables import ReportTable, code, numeric
from poppet.timeseries.columns import Columns
from poppet.timeseries.plotting.panels import Panel, Series, code_styles, panels_of, shown_series, thinned
from poppet.timeseries.plotting.plots import axis_unit, home_colours, panel_colours, time_unit
from poppet.timeseries.plotting.tube_bands import band_outputs, with_bands
from poppet.timeseries.recording import Recording

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from poppet.bench.iso10094.bench_result import BenchResult
    from poppet.bench.limits.maps import LimitsResult
    from poppet.circuit.circuit import BaseCircuit
    from poppet.circuit.linear_model import LinearModel
    from poppet.control.tuning import Tuning
    from poppet.ensemble import Ensemble
    from poppet.identify.result import Result

STYLE = stylesheet("notebook")
MAX_ROWS = 12
"""Maximum number of rows of an unfolded table."""
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
MAX_PANELS, MAX_LINES = 4, 6
COLUMNS = 200
"""Columns of a plot; a line has the first, last, lowest and highest sample of each."""
WIDTH, HEIGHT = 1000, 100
"""Size of the drawing, which is stretched to the available width."""
_POINTS_PER_INCH = 72.0
_SCALE = 1.12
"""Size of a drawing in pixels relative to points."""


def card(title: str, lead: str, *blocks: Content) -> str:
    """Return the HTML block with which a notebook shows one object.

    `title` and `lead` are texts. The further arguments are HTML texts or tables.

    Examples
    --------
    >>> card("a < b", "Recording").partition("</style>")[2]
    '<p><span class="poppet-head">a &lt; b</span> <span class="lead">Recording</span></p></div>'
    """
    name = f'<span class="poppet-head">{html.escape(title)}</span> ' if title else ""
    head = f'<p>{name}<span class="lead">{html.escape(lead)}</span></p>'
    return f'<div class="poppet-card"><style>{STYLE}</style>{head}{"".join(map(render, blocks))}</div>'


def note_list(notes: Iterable[Note]) -> str:
    """Return notes as an HTML list that the reader can unfold.

    A list of up to three notes is unfolded.
    """
    texts = grouped(notes)
    return folded(plural(len(texts), "note"), items(texts), is_open=len(texts) <= 3)


def plural(count: int, noun: str) -> str:
    """Return a number with its noun, in singular or plural, such as `2 notes`."""
    return f"{count} {noun}{'s' * (count != 1)}"


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

    if len(circuit.parts) > MAX_PARTS:
        return ""
    try:
        figure = draw_circuit(replace(circuit, title="", like=circuit))  # the card shows the title
    except MissingDependencyError as error:
        return paragraph(str(error), css_class="lead")
    return themed_svg(figure, f"Circuit {circuit.title}".strip())


def recording_card(recording: Recording) -> str:
    """Return a recording as HTML: a plot, and a table of its series.

    The table contains first, last, minimum and maximum value.
    """
    rows, columns = recording.time.size, len(recording)
    span = f"{recording.time[0]:.6g} ... {recording.time[-1]:.6g} s" if rows else "no samples"
    lead = f"Recording: {rows} rows, {columns} series, {span}. {recording.outcome}".rstrip()
    blocks: list[str | ReportTable] = []
    if rows and columns:
        names = sorted(recording.names, key=recording.inner.__contains__)
        more = names[MAX_ROWS:]
        blocks = [svg_plot(recording), _series_table(recording, names[:MAX_ROWS])]
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
    """Return a linear model as HTML: sizes, modes and operating point."""
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
    from poppet.report.ensemble_report import metric_table, yield_table

    lead = f"Ensemble of {ensemble.done} runs"
    return card(ensemble.plan.circuit.title, lead, yield_table(ensemble), metric_table(ensemble))


def tuning_card(tuning: Tuning) -> str:
    """Return a tuning as HTML: gains, Bode plot and step responses with margins."""
    from poppet.control.loop_figures import bode_figure, step_figure
    from poppet.report.control_report import margin_table

    gains = f"<pre>{html.escape(tuning.text())}</pre>"
    try:
        figures = [
            themed_svg(bode_figure(tuning), "Bode plot of the open loops"),
            themed_svg(step_figure(tuning), "Responses to setpoint and disturbance steps"),
        ]
    except MissingDependencyError as error:
        figures = [paragraph(str(error), css_class="lead")]
    lead = f"Tuning of {tuning.controller}: {tuning.bound_text}."
    return card("", lead, gains, *figures, folded("margins", margin_table(tuning)), note_list(tuning.notes))


def themed_svg(figure: Figure, label: str) -> str:
    """Return a figure as HTML whose colours suit a light and a dark notebook.

    `label` is the text for screen readers. Grey colours are mixed from the colour of the text.
    """
    from poppet.timeseries.plotting.figures import PALETTE, figure_bytes

    figure.patch.set_visible(False)
    for axes in figure.axes:
        axes.patch.set_visible(False)
    svg = figure_bytes(figure, "svg", "notebook").decode("utf-8")
    # All drawings of a notebook share one page, so their identifiers must be unique.
    svg = inline_svg(svg, f"poppet{crc32(svg.encode()):08x}", label)
    mixed = {colour: f"color-mix(in srgb, {colour} 72%, currentColor)" for colour in PALETTE}
    for colour, shown in ({"#e6e8ec": "color-mix(in srgb, currentColor 14%, transparent)"} | mixed | _COLOURS).items():
        svg = svg.replace(colour, shown)
    svg = re.sub(r"<!--.*?-->|<defs>\s*<style.*?</style>\s*</defs>", "", svg, flags=re.DOTALL)
    svg = re.sub(r">\s+<", "><", svg)
    width = _SCALE * _POINTS_PER_INCH * figure.get_figwidth()
    svg = svg.replace("<svg ", f'<svg style="width:{width:.0f}px;max-width:none" ', 1)
    return f'<div class="scroll poppet-picture" tabindex="0">{svg}</div>'


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

    The table has the bandwidth and the limiting part, with one row per load volume and one column per amplitude.
    """
    plan, rows = result.plan, []
    grid = zip(plan.volumes, result.bandwidth_map("gain_frequency"), result.bandwidth_map("limiting"), strict=True)
    for volume, frequencies, parts in grid if result.points else ():
        texts = [f"{frequency:.3g} Hz" if math.isfinite(frequency) else "-" for frequency in frequencies]
        cells = (f"{text}, {part}" if part else text for text, part in zip(texts, parts, strict=True))
        rows.append((f"{volume * 1e3:.3g} l", *cells))
    columns = "volume", *(f"± {amplitude / 1e5:.3g} bar" for amplitude in plan.amplitudes)
    lead = f"Dynamic limits of {plan.valve} at {plan.mean / 1e5:.3g} bar: -3 dB frequency and the limiting part."
    return card(plan.circuit.title or plan.valve, lead, ReportTable(columns, rows), note_list(result.findings))


def svg_plot(recording: Columns) -> str:
    """Return a plot of all outputs that change, as HTML with SVG.

    The text is empty if no output changes.
    """
    if recording.time.size < 2:
        return ""
    pairs = zip(recording.names, recording.units, strict=True)
    names = [name for name, unit in pairs if code_styles(name, unit, recording[name]) is None]  # no codes
    # Internal outputs are omitted if there are other outputs.
    names = [name for name in names if name not in recording.inner] or names
    tubes = band_outputs(names)
    cells = {cell for group in tubes.values() for cell in group}
    series = _thinned_series(recording, [name for name in names if name not in cells])
    series += [_thinned_band(recording, group) for group in tubes.values()]
    order = {name: k for k, name in enumerate(names)}
    first_cells = {name: group[0] for name, group in tubes.items()}
    series.sort(key=lambda item: order[first_cells.get(item.name, item.name)])
    panels, _ = panels_of(series)
    panels = [panel for panel in panels if any(not line.is_still for line in panel.series)][:MAX_PANELS]
    homes = home_colours(panels)
    start, end = float(recording.time[0]), float(recording.time[-1])
    unit, size = time_unit(end - start)
    times = "".join(f"<span>{text}</span>" for text in (f"{start / size:.5g}", f"time [{unit}]", f"{end / size:.5g}"))
    body = "".join(_panel_html(panel, panel_colours(panel, homes), (start, end)) for panel in panels)
    return f'{body}<div class="poppet-time">{times}</div>' if body else ""


def _thinned_series(recording: Columns, names: Sequence[str]) -> list[Series]:
    """Return series in their usual units, with only the samples that a plot shows."""
    thin = []
    for name in names:
        rows = thinned(recording.time, recording[name], COLUMNS)
        values, units = recording[name][rows].reshape(1, -1), (recording.unit(name),)
        thin.append(Columns(recording.time[rows], (name,), units, values, ambient_pressure=recording.ambient_pressure))
    return shown_series(thin, None, None)


def _thinned_band(recording: Columns, cells: Sequence[str]) -> Series:
    """Return the band of the cells of a tube, with only the samples that a plot shows."""
    values = np.array([recording[name] for name in cells])
    (low, high) = (thinned(recording.time, edge, COLUMNS) for edge in (values.min(axis=0), values.max(axis=0)))
    rows, units = np.union1d(low, high), tuple(recording.unit(name) for name in cells)
    thin = Columns(
        recording.time[rows], tuple(cells), units, values[:, rows], ambient_pressure=recording.ambient_pressure
    )
    (band,) = with_bands(shown_series([thin], None, None))
    return band


def _panel_html(panel: Panel, colours: dict[str, str], span: tuple[float, float]) -> str:
    """Return one panel of a notebook plot as HTML.

    It contains the legend, the ends of the scale and the curves. `colours` maps outputs to colours, and `span` contains
    both ends of the time axis [s].
    """
    # First the first lines of all parts, then the second lines.
    counts: dict[str, int] = {}
    ranks: dict[str, int] = {}
    for line in panel.series:
        part = line.name.partition(".")[0]
        ranks[line.name] = counts[part] = counts.get(part, -1) + 1
    series = sorted(panel.series, key=lambda line: ranks[line.name])[:MAX_LINES]
    edges = [edge for line in series for edge in (line.values, line.high) if edge is not None]
    finite = np.concatenate([edge[np.isfinite(edge)] for edge in edges])
    low, high = float(finite.min()), float(finite.max())
    paths, keys = [], []
    for line in series:
        colour = f"color-mix(in srgb, {colours[line.name]} 72%, currentColor)"
        scale = low, high if high > low else low + 1.0
        points = svg_path(line, span, scale)
        # The first colour is for browsers without `color-mix`.
        paths.append(f'<path stroke="{colours[line.name]}" style="stroke:{colour}" d="{points}"/>')
        if line.high is not None:
            upper = svg_path(replace(line, values=line.high), span, scale)
            back = svg_path(replace(line, time=line.time[::-1], values=line.high[::-1]), span, scale)
            paths.append(f'<path stroke="{colours[line.name]}" style="stroke:{colour}" d="{upper}"/>')
            area = f"fill:{colour};fill-opacity:.3;stroke:none"
            paths.append(f'<path style="{area}" d="{points}L{back[1:]}Z"/>')
        mark = f'<i style="background:{colours[line.name]};background:{colour}"></i>'
        keys.append(f"<span>{mark}{html.escape(panel.labels[line.name])}</span>")
    n_omitted = len(panel.series) - len(series)
    keys += [f'<span class="lead">and {n_omitted} more</span>'] if n_omitted else []
    label = html.escape(f"{panel.quantity} over time", quote=True)
    return (
        f'<div class="poppet-panel"><div class="poppet-key"><b>{html.escape(panel.quantity)}</b> '
        f'{html.escape(axis_unit(panel))}{"".join(keys)}</div><div class="poppet-plot"><div class="poppet-ends">'
        f"<span>{_end_of_scale(high, high - low)}</span><span>{_end_of_scale(low, high - low)}</span></div>"
        f'<svg role="img" aria-label="{label}" viewBox="0 -2 {WIDTH} {HEIGHT + 4}" preserveAspectRatio="none">'
        f"{''.join(paths)}</svg></div></div>"
    )


def _end_of_scale(value: float, span: float) -> str:
    """Return the value at one end of a scale as text.

    `span` is the length of the scale. The value is rounded to about a thousandth of it.
    """
    decimals = 3 - math.floor(math.log10(span)) if span > 0.0 else 6
    return f"{round(value, decimals):z.6g}"


def svg_path(series: Series, span: tuple[float, float], scale: tuple[float, float]) -> str:
    """Return a curve as the text of an SVG path.

    `span` contains the ends of the time axis, and `scale` the ends of the vertical axis. The path has a width of 1000
    and a height of 100. NaN interrupts it.

    Examples
    --------
    >>> time, values = np.array([0.0, 1.0, 2.0]), np.array([0.0, 5.0, 10.0])
    >>> svg_path(Series("a", 0, time, values, "1", "", 0), (0.0, 2.0), (0.0, 10.0))
    'M0 100L500 50L1000 0'
    """
    x = np.round((series.time - span[0]) / (span[1] - span[0]) * WIDTH).astype(int)
    y = np.round(HEIGHT * (1.0 - (series.values - scale[0]) / (scale[1] - scale[0])), 1)
    parts: list[str] = []
    is_down, previous = False, 0.0
    # Omit repeated points and inner points of horizontal lines.
    level = np.where(np.isfinite(y), y, -1e9)
    distinct = np.flatnonzero((np.diff(x, prepend=-1) != 0) | (np.diff(level, prepend=np.nan) != 0.0))
    level = level[distinct]
    is_inner = (level[1:-1] == level[:-2]) & (level[1:-1] == level[2:])
    for k in distinct[np.concatenate(([True], ~is_inner, [True]))[: len(distinct)]]:
        if not np.isfinite(y[k]):
            is_down = False
        elif not is_down:
            parts.append(f"M{x[k]} {y[k]:g}")
            is_down = True
        else:
            # A step is horizontal first.
            parts.append(f"H{x[k]}V{y[k]:g}" if series.is_staircase and y[k] != previous else f"L{x[k]} {y[k]:g}")
        previous = y[k]
    return "".join(parts)

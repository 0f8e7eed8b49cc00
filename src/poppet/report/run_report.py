"""The page of a run: what was simulated, with which numbers, what came out, and whether the balances hold."""

from __future__ import annotations

import html
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from poppet.core.number_format import USUAL, digits_of, pretty, with_unit
from poppet.core.provenance import LEAST_CERTAIN_FIRST, Number
from poppet.report.circuit.schematic import draw_circuit
from poppet.report.html_page import document, findings, head, picture, table, write_page
from poppet.report.loads import ENERGY, STROKES, energy_rows, stroke_rows
from poppet.report.tables import Column, Table
from poppet.timeseries.plotting.figures import style
from poppet.timeseries.plotting.plots import plot_recordings
from poppet.timeseries.recording import Recording

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

_STYLE = """
details { margin: .6rem 0; } summary { cursor: pointer; }
code { font: .92em/1.4 ui-monospace, "DejaVu Sans Mono", Menlo, Consolas, monospace; }
.numbers td:last-child { color: var(--soft); min-width: 14rem; }
"""
_NOT_TO_READ = "regime", "contact", "friction_state"
"""Ends of the names of codes, of which a table of values says nothing."""


def write_run(
    circuit: Circuit, recording: Recording, path: str | Path, *, select: str | Iterable[str] | None = None,
    units: Mapping[str, str] | Sequence[str] | str | None = None, inner: bool = False,
) -> Path:  # fmt: skip
    """Write a run as one page that needs nothing else.

    Parameters
    ----------
    circuit : Circuit
        What was simulated.
    recording : Recording
        What came out.
    path : str or Path
        Ends in `.html`.
    select, units, inner : optional
        Which series are drawn, in which units, and whether inner ones are, as `plot_recordings` takes them.

    Returns
    -------
    Path
        Where it was written.

    Examples
    --------
    >>> import tempfile
    >>> from poppet import Chamber, Circuit, Orifice
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> circuit = Circuit({"tank": Chamber(volume="10 l", initial_pressure="5 bar"), "vent": vent})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     page = write_run(circuit, circuit.simulate(1.0), f"{folder}/run.html")
    ...     "Numbers" in page.read_text(encoding="utf-8")
    True
    """
    return write_page(path, lambda: run_page(circuit, recording, select=select, units=units, inner=inner))


def run_page(
    circuit: Circuit, recording: Recording, *, select: str | Iterable[str] | None = None,
    units: Mapping[str, str] | Sequence[str] | str | None = None, inner: bool = False,
) -> str:  # fmt: skip
    """The page as text."""
    title = circuit.title or "A run"
    with style("A report of a run"):
        drawn = ""
        if recording.time.size:
            figure = plot_recordings({"": recording}, select=select, units=units, inner=inner)
            figure.texts[0].set_visible(not recording.title)  # the page has its title
            drawn = picture(figure, "run", "The run; bars at the foot say how each passage flowed.")
        sections = [
            ("", _head(title, recording)),
            ("What is asked first", _figures(recording)),
            ("Run", drawn),
            ("Circuit", picture(draw_circuit(circuit), "circuit", "The circuit; assumed numbers carry a star.")),
            ("Values", _values(recording).html() if recording.time.size else ""),
            ("Balances", _balances(recording)),
            ("How it was run", _conditions(circuit, recording)),
            ("Numbers", _numbers(circuit)),
        ]
    return document(title, sections, style=_STYLE)


def _head(title: str, recording: Recording) -> str:
    lead = f"{len(recording)} series"
    if recording.time.size:
        lead = f"{recording.time[0]:.6g} to {recording.time[-1]:.6g} s, {recording.time.size} rows of {lead}"
    ended = f"<p><strong>{html.escape(recording.outcome)}</strong></p>\n" if recording.outcome else ""
    return head(title, lead) + ended + findings(recording.remarks)


def _figures(recording: Recording) -> str:
    """Strokes, air, work and efficiency of a run with loads."""
    figures = recording.figures
    if figures is None:
        return ""
    heads, *strokes = stroke_rows(figures)
    shown = [[html.escape(row[0]), *row[1:]] for row in strokes]
    text = f"<p>{STROKES}</p>\n{table(heads, shown, numbers=range(1, 7))}" if strokes else ""
    energy = [[html.escape(what), f"{value} {unit}"] for what, value, unit in energy_rows(figures)]
    return text + table([], energy, numbers=(1,), caption=ENERGY)


def _values(recording: Recording) -> Table:
    """First, last, lowest and highest value of every series that has values, what is inner last."""
    series = [
        (name, unit) for name, unit in zip(recording.names, recording.units, strict=True)
        if not name.endswith(_NOT_TO_READ)
    ]  # fmt: skip
    shown = recording.select([name for name, _ in series])
    shown = shown.converted({name: USUAL[unit] for name, unit in series if unit in USUAL})
    rows = []
    for name, unit in sorted(zip(shown.names, shown.units, strict=True), key=lambda each: each[0] in shown.inner):
        row = shown[name]
        low, high = int(np.argmin(row)), int(np.argmax(row))
        largest = float(np.max(np.abs(row)))
        figures = (digits_of(float(v), largest) for v in (row[0], row[-1], row[low], row[high]))
        first, last, least, most = figures
        times = (f"{shown.time[k]:.5g}" for k in (low, high))
        rows.append((name, pretty(unit) if unit != "1" else "", first, last, least, next(times), most, next(times)))
    heads = ("first", "last", "lowest", "at [s]", "highest", "at [s]")
    columns = Column("series"), Column("unit"), *(Column(text, "s") for text in heads)
    return Table("values", "", columns, tuple(rows))


def _numbers(circuit: Circuit) -> str:
    """The numbers of the circuit by their source, the least certain first."""
    text, every = "", circuit.numbers()
    for kind in LEAST_CERTAIN_FIRST:
        group = {address: number for address, number in every.items() if number.source.kind == kind}
        if not group:
            continue
        rows = [_number(address, number, circuit) for address, number in group.items()]
        body = table(["number", "as written", "SI", "where from"], rows, numbers=(2,), kind="numbers")
        is_open = " open" if kind == "assumed" else ""
        text += f"<details{is_open}><summary>{kind} ({len(group)})</summary>\n{body}</details>\n"
    return text


def _number(address: str, number: Number, circuit: Circuit) -> list[str]:
    value = number.absolute(circuit.surroundings.pressure)
    source = "; ".join(text for text in (number.source.locator, number.source.note) if text)
    cells = number.display(), with_unit(f"{value:.6g}", number.unit), source
    return [f"<code>{html.escape(address)}</code>", *map(html.escape, cells)]


def _balances(recording: Recording) -> str:
    rows = [
        [html.escape(each.name), f"{each.error:.2g} {each.unit}", f"{each.allowed:.2g} {each.unit}",
         f"{each.through:.4g} {each.unit}", "kept" if each.is_kept else "<strong>NOT kept</strong>"]
        for each in recording.residuals if each.allowed > 0.0
    ]  # fmt: skip
    if not rows:
        return ""
    words = "What a store has gained, less what the integrals of its flows say went in."
    return table(["balance", "residual", "allowed", "went through", ""], rows, numbers=(1, 2, 3), caption=words)


def _conditions(circuit: Circuit, recording: Recording) -> str:
    run = circuit.run
    steps = recording.statistics
    rows = [
        ["solver", html.escape(run.solver)],
        ["relative tolerance", f"{run.numbers()['relative_tolerance'].value:.3g}"],
        ["steps", f"{steps.get('accepted_steps', 0):.0f} accepted, {steps.get('rejected_steps', 0):.0f} rejected"],
        ["ambient pressure", f"{recording.ambient_pressure / 1e5:.6g} bar"],
    ]
    return table([], rows)

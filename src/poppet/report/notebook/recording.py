"""A recording in a notebook: a small plot, and first, last, least and greatest value of every series."""

from __future__ import annotations

import html
from collections.abc import Sequence

import numpy as np

from poppet.core.number_format import USUAL, pretty
from poppet.core.units import convert
from poppet.report.html_page import table
from poppet.report.notebook.card import MOST_ROWS, card, folded, notes
from poppet.report.notebook.plot import plot
from poppet.timeseries.recording import Recording

ROUNDING = 1e-12
"""Part of a series' largest value below which a table shows 0."""
_HEADINGS = ("series", "unit", "first", "last", "min", "max")


def _rows(recording: Recording, names: Sequence[str]) -> str:
    """A table of some of the series, in the units in which people read."""
    rows = []
    for name in names:
        given, row = recording.unit(name), recording[name]
        unit = USUAL.get(given, given)
        known = row[~np.isnan(row)] if np.isnan(row).any() else row
        ends = np.array([row[0], row[-1], known.min(initial=np.inf), known.max(initial=-np.inf)])
        if unit != given:
            ends = convert(ends, given, unit, ambient_pressure=recording.ambient_pressure)
        least = ROUNDING * float(np.max(np.abs(ends[2:])))
        figures = ["0" if abs(value) < least else f"{value:z.5g}" for value in ends]
        rows.append([f"<code>{html.escape(name)}</code>", html.escape("" if unit == "1" else pretty(unit)), *figures])
    return table(_HEADINGS, rows, numbers=range(2, 6))


def shown(recording: Recording) -> str:
    """A recording as HTML."""
    count, n = len(recording), recording.time.size
    span = f"{recording.time[0]:.6g} ... {recording.time[-1]:.6g} s" if n else "no samples"
    lead = f"Recording: {n} rows, {count} series, {span}. {recording.outcome}".rstrip()
    blocks = [notes(recording.remarks)]
    if n and count:
        names = sorted(recording.names, key=recording.inner.__contains__)
        first, rest = names[:MOST_ROWS], names[MOST_ROWS:]
        blocks = [plot(recording), _rows(recording, first), *blocks]
        if rest:
            blocks.insert(2, folded(f"{len(rest)} more series", _rows(recording, rest)))
    return card(recording.title, lead, *blocks)

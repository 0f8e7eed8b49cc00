"""A linear model in a notebook: how large it is, its modes, its point."""

from __future__ import annotations

import html

from poppet.circuit.linear_model import LinearModel
from poppet.core.codes import Note
from poppet.report.html_page import table
from poppet.report.modes import mode_rows
from poppet.report.notebook.card import MOST_ROWS, card, folded, notes


def shown(linear: LinearModel) -> str:
    """A linear model as HTML."""
    sample = getattr(linear, "sample_time", 0.0)
    sizes = {"state": linear.states, "input": linear.inputs, "output": linear.outputs}
    lead = ", ".join(f"{len(names)} {word}{'s' * (len(names) != 1)}" for word, names in sizes.items())
    lead += f"; from one sample of {sample:.6g} s to the next" if sample else ""
    headings, *modes = mode_rows(linear)
    point = [
        [kind, f"<code>{html.escape(name)}</code>", f"{value:z.6g}"]
        for kind, names, values in (("state", linear.states, linear.x), ("input", linear.inputs, linear.u))
        for name, value in zip(names, values, strict=True)
    ]
    said: tuple[Note, ...] = getattr(linear, "notes", ())
    at = table(("", "address", "value"), point, numbers=(2,))
    blocks = [
        table(headings, modes, numbers=(1, 2, 3)) if modes else "",
        folded("the point, in SI", at, is_open=len(point) <= MOST_ROWS) if point else "",
        notes(said),
    ]
    return card("Linear model", lead, *blocks)

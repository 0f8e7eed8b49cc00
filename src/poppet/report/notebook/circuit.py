"""A circuit in a notebook: its drawing in the colours of the notebook, its assumed numbers, its notes."""

from __future__ import annotations

import html
import re
from dataclasses import replace
from zlib import crc32

from poppet.circuit.circuit import Circuit
from poppet.core.errors import MissingDependencyError
from poppet.report.circuit.schematic import draw_circuit
from poppet.report.html_page import inline_svg, table
from poppet.report.notebook.card import MOST_ROWS, card, folded, notes
from poppet.timeseries.plotting.figures import figure_bytes

MOST_PARTS = 40
"""More are not drawn unasked: it would take seconds, and nobody could read it in a notebook."""
_INKS = {
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
"""Colours of the drawing to those of the notebook."""
_INCH = 72.0  # points of a picture, which are shown as picture elements a little larger
_SIZE = 1.12


def shown(circuit: Circuit) -> str:
    """A circuit as HTML."""
    count = len(circuit.parts)
    lead = f"Circuit: {count} part{'s' * (count != 1)}, inputs driven: {len(circuit.signals)}."
    return card(circuit.title, lead, _drawing(circuit), _assumed(circuit), notes(circuit.static_notes))


def _drawing(circuit: Circuit) -> str:
    if len(circuit.parts) > MOST_PARTS:
        return ""
    try:
        figure = draw_circuit(replace(circuit, title="", like=circuit))  # the card has one above
    except MissingDependencyError as error:
        return f'<p class="lead">{html.escape(str(error))}</p>'
    figure.patch.set_visible(False)
    svg = figure_bytes(figure, "svg", "notebook").decode("utf-8")
    # Several circuits of one notebook share their page, and their names must not.
    svg = inline_svg(svg, f"poppet{crc32(svg.encode()):08x}", f"Circuit {circuit.title}".strip())
    for plain, mixed in _INKS.items():
        svg = svg.replace(plain, mixed)
    svg = re.sub(r"<!--.*?-->|<defs>\s*<style.*?</style>\s*</defs>", "", svg, flags=re.DOTALL)
    svg = re.sub(r">\s+<", "><", svg)
    width = _SIZE * _INCH * figure.get_figwidth()
    svg = svg.replace("<svg ", f'<svg style="width:{width:.0f}px;max-width:none" ', 1)
    return f'<div class="scroll poppet-picture" tabindex="0">{svg}</div>'


def _assumed(circuit: Circuit) -> str:
    found = {address: number for address, number in circuit.numbers().items() if number.source.kind == "assumed"}
    rows = [
        [f"<code>{html.escape(address)}</code>", html.escape(number.display()), html.escape(number.source.note)]
        for address, number in found.items()
    ]
    if not rows:
        return '<p class="lead">No number is assumed.</p>'
    summary = f"{len(rows)} assumed number{'s' * (len(rows) != 1)}"
    return folded(summary, table(("number", "value", "why"), rows, numbers=(1,)), is_open=len(rows) <= MOST_ROWS)

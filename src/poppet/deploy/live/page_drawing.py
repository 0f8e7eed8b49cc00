"""Drawing of a live page: the schematic of a circuit, with positions of values and of moving symbols."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from poppet.report.circuit.schematic import EmptyLine, draw_with_empty_lines
from poppet.report.html_page import inline_svg
from poppet.timeseries.plotting.figures import figure_bytes

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

_SYMBOLS = {"Pa": "p", "m": "x", "rad": "angle", "N": "F", "N m": "M", "kg/s": "qm"}
"""Symbols of the quantities in the boxes of the schematic, by SI unit, in the order of preference."""
_MAX_LINES, _MIN_WIDTH = 3, 1.3  # of a box; width [in]
_MOVES = {"stroke": "poppet", "position": "piston", "piston_position": "piston"}


def page_drawing(circuit: BaseCircuit, outputs: Sequence[tuple[str, str]]) -> dict[str, Any]:
    """Return the schematic as SVG text, with positions of values and of moving symbols.

    The positions are empty lines inside the boxes of the parts.

    Parameters
    ----------
    circuit : Circuit
        Circuit.
    outputs : sequence of pairs of str
        Address and SI unit of each output of the page.
    """
    values_of: dict[str, list[dict[str, Any]]] = {}
    for unit, symbol in _SYMBOLS.items():
        for k, (address, output_unit) in enumerate(outputs):
            path, _, name = address.rpartition(".")
            part = path.partition(".")[0]
            if output_unit != unit or address in circuit.inner or part not in circuit.parts:
                continue
            values_of.setdefault(part, []).append({"output": k, "sign": symbol, "name": name.replace("_", " ")})
    values_of = {part: values[:_MAX_LINES] for part, values in values_of.items()}
    movers: dict[str, dict[str, Any]] = {}
    domains = circuit.domains
    for k, (address, output_unit) in enumerate(outputs):
        part, _, name = address.rpartition(".")
        if part in values_of and part not in movers and name in _MOVES and output_unit in ("m", "rad"):
            stops = domains.get(address, (None, None))[1]
            kind = "lever" if output_unit == "rad" else _MOVES[name]
            movers[part] = {"output": k, "kind": kind, "stops": _finite(stops)}
    n_lines = {part: len(values) + 2 * (part in movers) for part, values in values_of.items()}
    # The page has the title.
    figure, empty_lines = draw_with_empty_lines(replace(circuit, title="", like=circuit), n_lines, _MIN_WIDTH)
    title = f"The circuit {circuit.title}"
    svg = inline_svg(figure_bytes(figure, "svg", "circuit").decode("utf-8"), "circuit", title)
    lines_of: dict[str, list[EmptyLine]] = {
        part: [line for line in empty_lines if line.part == part] for part in n_lines
    }
    placed_values = []
    for part, values in values_of.items():
        lines = lines_of[part]
        if part in movers:
            (first, second), lines = lines[:2], lines[2:]
            movers[part] |= {
                "x": first.x,
                "y": (first.y + second.y) / 2,
                "width": first.width,
                "height": 1.7 * first.height,
            }
        placed_values += [value | {"x": line.x, "y": line.y} for value, line in zip(values, lines, strict=True)]
    return {"svg": svg, "values": placed_values, "movers": [movers[part] for part in values_of if part in movers]}


def _finite(stops: tuple[float, float] | None) -> list[float] | None:
    """Return the end stops of a body, or None if a side has none."""
    return list(stops) if stops and all(map(math.isfinite, stops)) else None

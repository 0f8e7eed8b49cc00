"""Positions of the parts in the drawing of the editor: those of the file, and an automatic layout of all others."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from poppet.edit.operations import is_coordinate
from poppet.parts.sources import Reservoir
from poppet.report.circuit.layout import BoxPosition, Edge, Graph, Layout, assign_layers

SIZE = (4.0, 4.0)
"""Width and height of a part without a stated size, in grid units."""
GAPS = (4.0, 3.0)
"""Horizontal and vertical distance of automatically placed parts, in grid units."""
WIDEST = 120.0
"""Width above which an automatic layout is divided into rows, in grid units."""
ASPECT = 1.6
"""Ratio of width to height that a layout of several rows approaches."""


def places_of(view: Mapping[str, Any], sizes: Mapping[str, tuple[float, float]] | None = None) -> dict[str, Any]:
    """Return the position of each part, the centre of its symbol in grid units.

    Positions in the file are unchanged. The other parts are arranged in layers from the supplies, below the parts with
    a position. A long chain of parts is divided into rows.

    Parameters
    ----------
    view : mapping
        View of a valid document, see `poppet.edit.document.Document.view`.
    sizes : mapping, optional
        Width and height of the symbols in grid units, by name of the part.
    """
    parts, drawing = view["parts"], view["drawing"]
    boxes = {name: SIZE if sizes is None else sizes.get(name, SIZE) for name in parts}
    stated = {name: drawing[name] for name in parts if _is_place(drawing.get(name))}
    free = [name for name in parts if name not in stated]
    if not free:
        return stated
    edges: list[Edge] = []
    for name in free:
        for port, target in parts[name]["ports"].items():
            edges.append((name, port, str(target).partition(".")[0]))
    for target, source in view["connections"].items():
        name, _, local = target.partition(".")
        edges.append((name, local, str(source).partition(".")[0]))
    edges = [edge for edge in edges if edge[0] in free and edge[2] in free and edge[0] != edge[2]]
    nodes = tuple(dict.fromkeys(edge[2] for edge in edges))
    graph = Graph(nodes, tuple(name for name in free if name not in nodes), tuple(edges))
    layers = assign_layers(graph, [name for name in nodes if parts[name]["kind"] == Reservoir.kind])
    layout = Layout(graph, layers, {name: boxes[name] for name in free}, GAPS, {})
    bottoms = [place["y"] + boxes[name][1] / 2.0 for name, place in stated.items()]
    top = math.ceil(max(bottoms) + GAPS[1]) if bottoms else 0
    positions = _in_rows({name: layout.positions[name] for name in free}, boxes)
    return stated | {name: {"x": round(x), "y": top + round(y)} for name, (x, y) in positions.items()}


def _in_rows(
    positions: Mapping[str, BoxPosition], boxes: Mapping[str, tuple[float, float]]
) -> dict[str, tuple[float, float]]:
    """Return positions measured from the upper left corner; a wide layout is divided into rows below each other."""
    lefts: dict[int, float] = {}
    for name, position in positions.items():
        left = position.x - boxes[name][0] / 2.0
        lefts[position.layer] = min(left, lefts.get(position.layer, left))
    width = max(position.x + boxes[name][0] / 2.0 for name, position in positions.items())
    height = max(position.y + boxes[name][1] / 2.0 for name, position in positions.items())
    count = round(math.sqrt(width / (ASPECT * (height + GAPS[1])))) if width > WIDEST else 1
    rows = {layer: int(left * max(count, 1) / width) for layer, left in lefts.items()}
    starts = {row: min(lefts[layer] for layer in lefts if rows[layer] == row) for row in rows.values()}
    result = {}
    for name, position in positions.items():
        row = rows[position.layer]
        # The layout has its origin at the lower left corner, a drawing at the upper left one.
        result[name] = position.x - starts[row], row * (height + GAPS[1]) + height - position.y
    return result


def _is_place(place: Any) -> bool:
    return isinstance(place, Mapping) and is_coordinate(place.get("x")) and is_coordinate(place.get("y"))

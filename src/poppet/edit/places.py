"""Positions of the parts in the drawing of the editor: those of the file, and an automatic layout of all others."""

from __future__ import annotations

import math
from collections.abc import Mapping
from typing import Any

from poppet.edit.operations import is_coordinate
from poppet.parts.sources import Reservoir
from poppet.report.circuit.layout import Edge, Graph, Layout, assign_layers

SIZE = (4.0, 4.0)
"""Width and height of a part without a stated size, in grid units."""
GAPS = (4.0, 3.0)
"""Horizontal and vertical distance of automatically placed parts, in grid units."""


def places_of(view: Mapping[str, Any], sizes: Mapping[str, tuple[float, float]] | None = None) -> dict[str, Any]:
    """Return the position of each part, the centre of its symbol in grid units.

    Positions in the file are unchanged. The other parts are arranged in layers from the supplies, below the parts with
    a position.

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
    height = max(layout.positions[name].y + boxes[name][1] / 2.0 for name in free)
    # The layout has its origin at the lower left corner, a drawing at the upper left one.
    return stated | {
        name: {"x": round(layout.positions[name].x), "y": top + round(height - layout.positions[name].y)}
        for name in free
    }


def _is_place(place: Any) -> bool:
    return isinstance(place, Mapping) and is_coordinate(place.get("x")) and is_coordinate(place.get("y"))

"""Sankey diagram as SVG: the width of each link is proportional to its value."""

from __future__ import annotations

import html
import re
from collections.abc import Sequence
from dataclasses import dataclass, field
from graphlib import TopologicalSorter
from itertools import pairwise
from typing import NamedTuple

from poppet.timeseries.plotting.figures import GREY, INK, text_width

WIDE, NARROW = 960.0, 330.0
"""Widths of the drawing for screens and for phones, in CSS pixels."""
FLOW_HEIGHT = 300.0
"""Height of the column with the largest sum of links, in CSS pixels."""
HAIRLINE = 0.8
"""Width in CSS pixels below which links have an outline, so that they remain visible."""

_BAR, _GAP, _LINE, _TEXT, _MARGIN = 9.0, 12.0, 15.0, 12.5, 8.0
_BREAKS = re.compile(r"(?<=[ ._-])")


class SankeyNode(NamedTuple):
    """Node of a Sankey diagram, with label, printed value and colour."""

    name: str
    label: str
    text: str = ""  # printed value
    colour: str = GREY


class SankeyLink(NamedTuple):
    """Link of a Sankey diagram: a flow from one node to another.

    A negative value is a flow in the opposite direction.
    """

    source: str
    target: str
    value: float
    text: str = ""  # printed value


@dataclass(eq=False)
class _Place:
    """Place of links in a column: a node with its label, or the passage of one link between two nodes."""

    column: int
    height: float
    node: SankeyNode | None = None
    lines: Sequence[str] = ()
    top: float = 0.0
    sources: list[_Place] = field(default_factory=list)

    @property
    def slot(self) -> float:
        return max(self.height, _LINE * len(self.lines))

    @property
    def middle(self) -> float:
        return self.top + 0.5 * self.height


class _Piece(NamedTuple):
    """Part of a link between two neighbouring columns."""

    link: SankeyLink
    start: _Place
    end: _Place


def draw_sankey(nodes: Sequence[SankeyNode], links: Sequence[SankeyLink], width: float = WIDE) -> str:
    """Return a Sankey diagram as the text of an SVG file.

    Parameters
    ----------
    nodes : sequence of SankeyNode
        Nodes; their order is that of the drawing, from top to bottom. Nodes without links are omitted.
    links : sequence of SankeyLink
        Links, which must not form a closed loop. A link with a negative value is drawn from its target to its source,
        and a link with the value 0 is omitted.
    width : float, optional
        Width of the drawing in CSS pixels.

    Returns
    -------
    str
        The drawing; empty if no link has a value.

    Notes
    -----
    All links have one scale: the width of a link is its value times the number of pixels per unit, without a minimum.
    Links below 0.8 pixels also have an outline, which makes them visible.

    Examples
    --------
    >>> nodes = [SankeyNode("in", "Supplied"), SankeyNode("work", "Work"), SankeyNode("loss", "Loss")]
    >>> svg = draw_sankey(nodes, [SankeyLink("in", "work", 1.0), SankeyLink("in", "loss", 2.0)])
    >>> svg.count("<path"), svg.count("<rect")
    (2, 3)
    """
    flows = [
        SankeyLink(*(link[:2] if link.value > 0.0 else link[1::-1]), abs(link.value), link.text)
        for link in links
        if link.value != 0.0
    ]
    return _Sankey(nodes, flows, width).draw() if flows else ""


class _Sankey:
    """Layout of a diagram: columns of stops, and ribbons between them."""

    def __init__(self, nodes: Sequence[SankeyNode], links: Sequence[SankeyLink], width: float) -> None:
        columns = _columns(links)
        count = max(columns.values()) + 1
        self.width, self.label_width = width, min(0.34 * width, 210.0)
        self.step = (width - self.label_width - _BAR) / (count - 1)
        self.columns: list[list[_Place]] = [[] for _ in range(count)]
        self.stops: dict[str, _Place] = {}
        self.nodes = {node.name: node for node in nodes if node.name in columns}
        for node in self.nodes.values():
            flows = (sum(link.value for link in links if node.name == link[end]) for end in (0, 1))
            self._add_stop(columns[node.name], max(flows), node)
        self.routes = {id(link): self._route(link) for link in links}
        self.links = links
        self.scale = FLOW_HEIGHT / max(sum(stop.height for stop in column) for column in self.columns)
        for column in self.columns:
            for stop in column:
                stop.height *= self.scale
        self._place()
        pieces = [_Piece(link, *ends) for link in links for ends in pairwise(self.routes[id(link)])]
        self.starts = self._stacked(pieces, is_start=True)
        self.ends = self._stacked(pieces, is_start=False)

    def _add_stop(self, column: int, height: float, node: SankeyNode | None = None) -> _Place:
        lines: list[str] = []
        if node is not None:
            room = (self.label_width if column == len(self.columns) - 1 else self.step - _BAR) - _MARGIN
            lines = [*_wrapped(node.label, room), *filter(None, [node.text])]
        stop = _Place(column, height, node, lines)
        if node is not None:
            self.stops[node.name] = stop
        self.columns[column].append(stop)
        return stop

    def _route(self, link: SankeyLink) -> list[_Place]:
        """Return the stops of a link, with one passage in each column that it crosses."""
        start, end = self.stops[link.source], self.stops[link.target]
        passages = [self._add_stop(column, link.value) for column in range(start.column + 1, end.column)]
        route = [start, *passages, end]
        for source, stop in pairwise(route):
            stop.sources.append(source)
        return route

    def _place(self) -> None:
        """Sort the stops of each column by the positions of their sources, and stack them."""
        heights = [sum(stop.slot for stop in column) + _GAP * (len(column) - 1) for column in self.columns]
        self.height = max(heights)
        for column, height in zip(self.columns, heights, strict=True):
            column.sort(key=_source_position)
            top = 0.5 * (self.height - height)
            for stop in column:
                stop.top = top + 0.5 * (stop.slot - stop.height)
                top += stop.slot + _GAP

    def _stacked(self, pieces: Sequence[_Piece], *, is_start: bool) -> dict[tuple[int, int], float]:
        """Return the upper edge of each piece at its start or end; the order is that of the other ends."""
        edges: dict[tuple[int, int], float] = {}
        filled: dict[int, float] = {}
        for link, start, end in sorted(pieces, key=lambda piece: (piece.end if is_start else piece.start).middle):
            stop = start if is_start else end
            edges[id(link), stop.column] = stop.top + filled.get(id(stop), 0.0)
            filled[id(stop)] = filled.get(id(stop), 0.0) + link.value * self.scale
        return edges

    def draw(self) -> str:
        """Return the drawing as SVG: ribbons, then bars, then labels."""
        shapes = [*map(self._ribbon, self.links), *map(self._bar, self.stops.values())]
        shapes += map(self._text, self.stops.values())
        height = self.height + 2.0
        size = f'width="{self.width:g}" height="{height:.2f}" viewBox="0 -1 {self.width:g} {height:.2f}"'
        font = f'font-family="sans-serif" font-size="{_TEXT:g}" style="fill:{INK}"'
        return f'<svg xmlns="http://www.w3.org/2000/svg" {size} {font}>\n{"".join(shapes)}</svg>\n'

    def _x(self, column: int) -> float:
        return column * self.step

    def _ribbon(self, link: SankeyLink) -> str:
        """Return a link as a path of constant vertical width: the upper edge forwards, the lower edge back."""
        points = []
        for start, end in pairwise(self.routes[id(link)]):
            points += [
                (self._x(start.column) + _BAR, self.starts[id(link), start.column]),
                (self._x(end.column), self.ends[id(link), end.column]),
            ]
        width = link.value * self.scale
        lower = [(x, y + width) for x, y in reversed(points)]
        path = f"M{_point(points[0])}{_curves(points)}L{_point(lower[0])}{_curves(lower)}Z"
        source, target = self.nodes[link.source], self.nodes[link.target]
        outline = f";stroke:{target.colour};stroke-width:{HAIRLINE:g}" if width < HAIRLINE else ""
        title = html.escape(f"{source.label} to {target.label}: {link.text or f'{link.value:.4g}'}")
        look = f"fill:{target.colour};fill-opacity:0.45{outline}"
        return f'<path d="{path}" style="{look}"><title>{title}</title></path>\n'

    def _bar(self, stop: _Place) -> str:
        assert stop.node is not None
        height = max(stop.height, HAIRLINE)
        place = f'x="{self._x(stop.column):.2f}" y="{stop.middle - 0.5 * height:.3f}"'
        return f'<rect {place} width="{_BAR:g}" height="{height:.3f}" style="fill:{stop.node.colour}"/>\n'

    def _text(self, stop: _Place) -> str:
        """Return the label of a node, right of its bar and in the middle of its height."""
        x = self._x(stop.column) + _BAR + 0.6 * _MARGIN
        first = stop.middle - 0.5 * _LINE * len(stop.lines) + 0.75 * _LINE
        spans = ""
        for k, line in enumerate(stop.lines):
            bold = ' font-weight="600"' if stop.node and line == stop.node.text else ""
            spans += f'<tspan x="{x:.2f}" y="{first + k * _LINE:.2f}"{bold}>{html.escape(line)}</tspan>'
        halo = 'stroke="white" stroke-opacity="0.75" stroke-width="3" stroke-linejoin="round" paint-order="stroke"'
        return f"<text {halo}>{spans}</text>\n"


def _columns(links: Sequence[SankeyLink]) -> dict[str, int]:
    """Return the column of each node: the number of links on the longest path to it."""
    sources: dict[str, set[str]] = {}
    for link in links:
        sources.setdefault(link.source, set())
        sources.setdefault(link.target, set()).add(link.source)
    columns: dict[str, int] = {}
    for name in TopologicalSorter(sources).static_order():
        columns[name] = max((columns[source] + 1 for source in sources[name]), default=0)
    return columns


def _source_position(stop: _Place) -> float:
    return sum(source.middle for source in stop.sources) / len(stop.sources) if stop.sources else 0.0


def _point(point: tuple[float, float]) -> str:
    return f"{point[0]:.2f} {point[1]:.4f}"


def _curves(points: Sequence[tuple[float, float]]) -> str:
    """Return the curves through points, horizontal at each of them."""
    text = ""
    for (x0, y0), (x1, y1) in pairwise(points):
        middle = 0.5 * (x0 + x1)
        text += f"C{_point((middle, y0))} {_point((middle, y1))} {_point((x1, y1))}"
    return text


def _wrapped(label: str, room: float) -> list[str]:
    """Return a label in lines of a maximum width; it breaks after spaces, dots and underscores."""
    lines = [""]
    for piece in _BREAKS.split(label):
        if lines[-1] and 72.0 * text_width((lines[-1] + piece).rstrip(), _TEXT) > room:
            lines.append("")
        lines[-1] += piece
    return [line.rstrip() for line in lines]

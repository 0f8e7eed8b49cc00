"""The picture of a circuit: stores and passages as boxes, joined from port to port."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.parts import Part, Reservoir, Store, Tube
from poppet.parts.part import AMBIENT, Body, Controller
from poppet.report.circuit.captions import ASSUMED, caption, connection_caption, shown_value, signal_caption
from poppet.report.circuit.layout import Drawing, Edge, Graph, Place, layers_of
from poppet.report.circuit.symbols import Pen, symbol, variable_restriction, vent
from poppet.timeseries.plotting.figures import (
    ACCENT,
    GREY,
    INK,
    check_format,
    new_figure,
    save_figure,
    style,
    text_width,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from poppet.circuit.circuit import Circuit

# Sizes in inches, text in points.
_NAME_TEXT, _TEXT, _NOTE_TEXT = 9.0, 7.5, 7.0
_LINE, _PAD, _SYMBOL, _PORT_STEP, _TAG, _VENT = 0.145, 0.1, 0.42, 0.2, 0.2, 0.3
_GAPS = (0.62, 0.3)
_MARGIN = 0.2
_PORT_NUMBERS = {
    "supply": "1 supply", "outlet": "2 outlet", "exhaust": "3 exhaust",
    "a": "4 a", "b": "2 b", "exhaust_a": "5 exhaust", "exhaust_b": "3 exhaust",
}  # fmt: skip
_STORE_FILL, _RESERVOIR_FILL, _PASSAGE_FILL, _PIPE = "#eaf2fb", "#f3f4f6", "white", "#49525e"
_CONTROLLER_FILL, _BODY_FILL = "#f4effa", "#fbf6e9"
BODY = "body"
"""The edge from an actuator to what it moves."""


def draw_circuit(circuit: Circuit, path: str | Path | None = None) -> Figure:
    """Draw a circuit: where gas comes from at the left, where it goes at the right.

    Notes
    -----
    Arrows show the direction that counts as positive flow, not how the gas flows. Symbols follow the habit of
    ISO 1219-1; the picture explains a circuit and is no circuit diagram of that standard.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, Orifice
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> figure = draw_circuit(Circuit({"tank": Chamber(volume="10 l"), "vent": vent}))
    >>> "10 l" in [text.get_text() for text in figure.axes[0].texts]
    True
    """
    if path is not None:
        check_format(path)
    with style("A picture of a circuit"):
        figure = _Picture(circuit).draw()
    if path is not None:
        save_figure(figure, path)
    return figure


class Room(NamedTuple):
    """A free line in the box of a part: its centre, and its size, in points of the picture from its upper left."""

    part: str
    x: float
    y: float
    width: float
    height: float


def draw_with_room(circuit: Circuit, lines: Mapping[str, int], wide: float) -> tuple[Figure, list[Room]]:
    """A circuit whose boxes have free lines, at least so wide [in], and where these are."""
    with style("A picture of a circuit"):
        picture = _Picture(circuit, lines, wide)
        figure = picture.draw()
    left, top = picture.axes.get_xlim()[0], picture.axes.get_ylim()[1]
    return figure, [
        Room(name, 72.0 * (x - left), 72.0 * (top - y), 72.0 * width, 72.0 * _LINE)
        for name, x, y, width in picture.room
    ]


@dataclass(frozen=True)
class _Box:
    """What stands in a box, and how large it is [in]."""

    name: str
    lines: tuple[str, ...]
    tags: tuple[str, ...]
    width: float
    height: float
    symbol_height: float = 0.0

    @property
    def body(self) -> float:
        """Height without the tags of the signals above."""
        return self.height - _TAG * len(self.tags)

    @property
    def port_height(self) -> float:
        """Where pipes meet it, above its centre."""
        middle = self.body - _PAD - self.symbol_height / 2.0 if self.symbol_height else self.body / 2.0
        return middle - self.height / 2.0


class _Picture:
    def __init__(self, circuit: Circuit, free: Mapping[str, int] | None = None, wide: float = 0.0) -> None:
        self.circuit, self.free, self.wide = circuit, free or {}, wide
        self.room: list[tuple[str, float, float, float]] = []  # centres and widths of the free lines [in]
        self.graph = _graph(circuit)
        layers = layers_of(self.graph, [name for name in self.graph.stores if _is_source(circuit.parts.get(name))])
        self.sides = {edge: layers[edge[2]] < layers[edge[0]] for edge in self.graph.edges}  # True: left of the passage
        self.boxes = {name: self._box(name) for name in layers}
        sizes = {name: (box.width, box.height) for name, box in self.boxes.items()}
        anchors = {name: box.port_height for name, box in self.boxes.items()}
        self.drawing = Drawing(self.graph, layers, sizes, _GAPS, anchors)
        self.ends = self._ends()

    def draw(self) -> Figure:
        """Make the picture."""
        places, notes = self.drawing.places, self._notes()
        right = max(place.x + self.drawing.sizes[name][0] / 2.0 for name, place in places.items())
        top = max(place.y + self.drawing.sizes[name][1] / 2.0 for name, place in places.items())
        head, foot = 0.32 * bool(self.circuit.title), 0.14 * len(notes) + 0.08
        words = [text_width(note, _NOTE_TEXT) for note in notes] + [text_width(self.circuit.title, 11, bold=True)]
        width, height = max(right, *words) + 2 * _MARGIN, top + head + foot + 2 * _MARGIN
        figure = new_figure(width, height)
        self.axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        self.axes.set_xlim(-_MARGIN, width - _MARGIN)
        self.axes.set_ylim(-_MARGIN - foot, height - _MARGIN - foot)
        self.axes.set_axis_off()
        for edge in self.graph.edges:
            self._pipe(edge)
        for name, box in self.boxes.items():
            self._draw_box(name, box, places[name])
        for edge in self.graph.edges:
            (x, y), is_left = self.ends[edge, edge[0]], self.sides[edge]
            look = {"ha": "left" if is_left else "right", "color": GREY, "zorder": 3}
            self._text(x + (0.05 if is_left else -0.05), y, _port_label(edge[1]), 6.5, **look)
            self._name_inner_store(edge)
        if self.circuit.title:
            self._text(0.0, top + head, self.circuit.title, 11, ha="left", va="top", fontweight="bold")
        for k, note in enumerate(notes):
            self._text(0.0, -0.12 - 0.14 * k, note, _NOTE_TEXT, ha="left", va="top", color=GREY)
        return figure

    def _name_inner_store(self, edge: Edge) -> None:
        """At the end of a pipe which of the places where a part holds gas it leads to."""
        store = self.circuit.parts[edge[0]].ports().get(edge[1], "").partition(".")[2]
        if store:
            (x, y), is_left = self.ends[edge, edge[2]], not self.sides[edge]
            look = {"ha": "left" if is_left else "right", "color": GREY, "zorder": 3}
            self._text(x + (0.05 if is_left else -0.05), y, store, 6.5, **look)

    # What is in a box ---------------------------------------------------------------------------------------

    def _box(self, name: str) -> _Box:
        part = self.circuit.parts.get(name)
        if part is None:
            return _Box("", (), (), 0.55, _VENT)
        lines = (*caption(self.circuit, name), *[""] * self.free.get(name, 0))
        tags = tuple(signal_caption(self.circuit, key) for key in self.circuit.signals if key.startswith(f"{name}."))
        joined = [key for key in self.circuit.connections if key.startswith(f"{name}.")]
        tags += tuple(connection_caption(self.circuit, key) for key in joined)
        words = [text_width(name, _NAME_TEXT, bold=True), *(text_width(line, _TEXT) for line in lines)]
        words += [text_width(tag, _TEXT) + 0.1 for tag in tags]
        words += [self.wide] * (name in self.free)
        ports = [edge for edge in self.graph.edges if name in (edge[0], edge[2])]
        most = max(sum(self.sides[edge] is side for edge in ports) for side in (True, False)) if ports else 0
        high = max(_SYMBOL, _PORT_STEP * most) + 0.06 if name in self.graph.passages else 0.0
        if high:
            labels = [
                max((text_width(_port_label(e[1]), 6.5) for e in ports if self.sides[e] is s), default=0.0)
                for s in (True, False)
            ]
            words.append(2.0 * max(labels) + 1.6 * _SYMBOL)
        body = high + _LINE * len(lines) + 0.17 + 2.0 * _PAD
        body = max(body, _PORT_STEP * len(ports))
        return _Box(name, lines, tags, max(words) + 2.0 * _PAD, body + _TAG * len(tags), high)

    def _notes(self) -> list[str]:
        notes = []
        texts = [line for box in self.boxes.values() for line in box.lines]
        if any(ASSUMED in text for text in texts):
            notes.append(f"{ASSUMED} assumed")
        if any(box.tags for box in self.boxes.values()):
            notes.append("Orange: inputs driven by a signal or by another part.")
        air = self.circuit.surroundings
        notes.append(
            f"Pressures absolute unless marked g. Ambient {shown_value(air.pressure, 'Pa')}, "
            f"{shown_value(air.temperature, 'K')}. Gas constant {air.gas_constant:g} J/(kg K), "
            f"isentropic exponent {air.isentropic_exponent:g}."
        )
        return notes

    # Where pipes end ----------------------------------------------------------------------------------------

    def _ends(self) -> dict[tuple[Edge, str], tuple[float, float]]:
        """Where every pipe meets its boxes: spread over a side in the order of what they lead to."""
        groups: dict[tuple[str, bool], list[tuple[float, Edge]]] = defaultdict(list)
        for edge, chain in self.drawing.chains.items():
            for name, other, is_left in (
                (edge[0], chain[1], self.sides[edge]),
                (edge[2], chain[-2], not self.sides[edge]),
            ):
                groups[name, is_left].append((self.drawing.places[other].y, edge))
        ends = {}
        for (name, is_left), members in groups.items():
            place, box = self.drawing.places[name], self.boxes[name]
            x = place.x + (-0.5 if is_left else 0.5) * box.width
            middle = place.y + box.port_height
            step = _PORT_STEP if box.symbol_height else min(_PORT_STEP, box.body / len(members))
            for k, (_, edge) in enumerate(sorted(members, key=lambda item: -item[0])):
                ends[edge, name] = (x, middle + (0.5 * (len(members) - 1) - k) * step)
        return ends

    # Drawing ------------------------------------------------------------------------------------------------

    def _pipe(self, edge: Edge) -> None:
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path as Outline

        points = [self.ends[edge, edge[0]]]
        for name in self.drawing.chains[edge]:
            place = self.drawing.places[name]
            half = self.drawing.column_width(place.layer) / 2.0
            y = self.ends[edge, name][1] if (edge, name) in self.ends else place.y
            sides = [(place.x - half, y), (place.x + half, y)]
            points += sides[::-1] if self.sides[edge] else sides
        points = [points[0], *points[2:-1], self.ends[edge, edge[2]]]
        vertices, codes = [points[0]], [Outline.MOVETO]
        for k, (start, end) in enumerate(pairwise(points)):
            if k % 2:  # between two layers; the others run straight along a layer
                middle = (start[0] + end[0]) / 2.0
                vertices += [(middle, start[1]), (middle, end[1]), end]
                codes += [Outline.CURVE4] * 3
            else:
                vertices.append(end)
                codes.append(Outline.LINETO)
        # A rod is drawn as two lines.
        for width, color in ((4.5, INK), (3.0, "white")) if edge[1] == BODY else ((1.7, _PIPE),):
            self.axes.add_patch(PathPatch(Outline(vertices, codes), facecolor="none", edgecolor=color, linewidth=width))
        if edge[1] != BODY:
            self._arrow(edge, points[1], points[2])

    def _arrow(self, edge: Edge, near: tuple[float, float], far: tuple[float, float]) -> None:
        """The direction of positive flow, halfway to the next layer."""
        a, b = complex(*near), complex(*far)
        slope = complex((b - a).real / 2.0, (b - a).imag)  # of the curve at its middle
        ports = [other for other in self.graph.edges if other[0] == edge[0]]
        is_inlet = len(ports) > 1 and ports[0] == edge  # positive flow enters a passage at the first of its ports
        along = slope / (-abs(slope) if is_inlet else abs(slope))
        tip, back, wing = (a + b) / 2.0 + 0.07 * along, (a + b) / 2.0 - 0.07 * along, 0.055j * along
        corners = (tip, back + wing, back - wing)
        self.axes.fill([c.real for c in corners], [c.imag for c in corners], color=_PIPE, linewidth=0.0, zorder=3)

    def _draw_box(self, name: str, box: _Box, place: Place) -> None:
        left, bottom = place.x - box.width / 2.0, place.y - box.height / 2.0
        if not box.name:
            vent(Pen(self.axes, left, place.y - _VENT / 2.0, _VENT))
            self._text(left, place.y - _VENT / 2.0, AMBIENT, 6.5, ha="left", va="top", color=GREY)
            return
        self._outline(name, left, bottom, box)
        top = bottom + box.body - _PAD
        if box.symbol_height:
            draw = variable_restriction if self._is_adjusted(name) else symbol(self.circuit.parts[name].kind)
            low = top - (box.symbol_height + _SYMBOL) / 2.0
            draw(Pen(self.axes, place.x - _SYMBOL / 2.0, low, _SYMBOL, self._is_mirrored(name)))
            top -= box.symbol_height
        free = top - bottom - _PAD - 0.17 - _LINE * len(box.lines)
        top -= free / 2.0
        self._text(place.x, top - 0.08, name, _NAME_TEXT, fontweight="bold")
        for k, line in enumerate(box.lines):
            y = top - 0.17 - _LINE * (k + 0.5)
            if line:
                self._text(place.x, y, line, _TEXT)
            else:
                self.room.append((name, place.x, y, box.width - 2.0 * _PAD))
        for k, tag in enumerate(box.tags):
            self._tag(place.x, bottom + box.body + _TAG * (k + 0.5), tag, box.width)

    def _is_mirrored(self, name: str) -> bool:
        """Where the gas that counts as positive comes from the right, or goes to the left from a source."""
        ports = [edge for edge in self.graph.edges if edge[0] == name]
        return self.sides[ports[0]] == (len(ports) == 1)

    def _is_adjusted(self, name: str) -> bool:
        """An orifice whose opening or stroke can move."""
        part = self.circuit.parts[name]
        driven = any(key.startswith(f"{name}.") for key in (*self.circuit.signals, *self.circuit.connections))
        return part.kind == "orifice" and (driven or getattr(part, "characteristic", None) is not None)

    def _outline(self, name: str, left: float, bottom: float, box: _Box) -> None:
        from matplotlib.patches import FancyBboxPatch

        part = self.circuit.parts[name]
        fill = _PASSAGE_FILL if box.symbol_height else _RESERVOIR_FILL if _is_fixed(part) else _STORE_FILL
        fill = _CONTROLLER_FILL if isinstance(part, Controller) else _BODY_FILL if isinstance(part, Body) else fill
        is_angular = box.symbol_height or _is_fixed(part) or isinstance(part, Controller)
        corner = 0.02 if is_angular else min(0.22, box.body / 2.0)
        outline: dict[str, Any] = {"facecolor": fill, "edgecolor": INK, "zorder": 2}
        outline["linewidth"] = 0.9 if box.symbol_height else 1.5
        shape = f"round,pad=0,rounding_size={corner}"
        self.axes.add_patch(FancyBboxPatch((left, bottom), box.width, box.body, boxstyle=shape, **outline))

    def _tag(self, x: float, y: float, text: str, width: float) -> None:
        from matplotlib.patches import FancyBboxPatch

        low, left = y - _TAG / 2.0 + 0.025, x - width / 2.0
        look: dict[str, Any] = {"facecolor": "#fdeee4", "edgecolor": ACCENT, "linewidth": 0.8, "zorder": 2}
        self.axes.add_patch(FancyBboxPatch((left, low), width, _TAG - 0.025, boxstyle="square,pad=0", **look))
        self._text(x, low + (_TAG - 0.025) / 2.0, text, _TEXT, color=ACCENT)

    def _text(self, x: float, y: float, text: str, size: float, **options: Any) -> None:
        how: dict[str, Any] = {"ha": "center", "va": "center", "color": INK, "zorder": 4} | options
        self.axes.text(x, y, text, fontsize=size, parse_math=False, **how)


def _graph(circuit: Circuit) -> Graph:
    """Every joint to the open air becomes an end of its own, drawn where it is; a body hangs on its actuators."""
    edges = []
    for name, part in circuit.parts.items():
        for port, store in part.ports().items():
            if isinstance(part, Tube) and store in part.outer_ports():
                continue  # drawn from the port that names the tube
            owner = store.partition(".")[0]
            edges.append((name, port, f"{AMBIENT} at {name}.{port}" if store == AMBIENT else owner))
        body = part.body_name()
        edges += [] if body is None else [(name, BODY, body)]
    passages = tuple(dict.fromkeys(edge[0] for edge in edges))
    stores = [name for name in circuit.parts if name not in passages]
    ends = [edge[2] for edge in edges if edge[2] not in passages]  # a tube is both: gas flows into it and through it
    return Graph(tuple(dict.fromkeys([*stores, *ends])), passages, tuple(edges))


def _is_fixed(part: Part | None) -> bool:
    """True for a reservoir, and for the open air, which is no part."""
    return not isinstance(part, Store) or isinstance(part, Reservoir)


def _is_source(part: Part | None) -> bool:
    """Where gas comes from or goes to, and what stands beside it all."""
    return part is None or isinstance(part, Reservoir | Controller)


def _port_label(port: str) -> str:
    return "" if port == BODY else _PORT_NUMBERS.get(port, port.rstrip("_"))

"""Schematic of a circuit: boxes for gas nodes and flow paths, with pipes between their ports."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Mapping
from dataclasses import dataclass
from itertools import pairwise
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.parts import Reservoir, Store, Tube
from poppet.parts.captions import ASSUMED, CaptionNumbers, format_value
from poppet.parts.faults import HEALTHY, Valve
from poppet.parts.part import AMBIENT, Body, Controller
from poppet.parts.symbols import OPEN_END, Symbol, horizontal_ends, rectangle
from poppet.report.circuit.layout import BoxPosition, Edge, Graph, Layout, assign_layers
from poppet.timeseries.plotting.figures import ACCENT, GREY, INK, new_figure, save_figure, style, text_width

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from poppet.circuit.circuit import BaseCircuit

# Sizes in inches, text in points.
_NAME_TEXT, _TEXT, _NOTE_TEXT = 9.0, 7.5, 7.0
_LINE, _PAD, _SYMBOL, _PORT_STEP, _TAG, _VENT = 0.145, 0.1, 0.42, 0.2, 0.2, 0.3
_GAPS = (0.62, 0.3)
_MARGIN = 0.2
_PORT_NUMBERS = {
    "supply": "1 supply", "inlet": "1 inlet", "outlet": "2 outlet", "exhaust": "3 exhaust",
    "a": "4 a", "b": "2 b", "exhaust_a": "5 exhaust", "exhaust_b": "3 exhaust",
    "pilot_a": "14 pilot", "pilot_b": "12 pilot",
}  # fmt: skip
_STORE_FILL, _RESERVOIR_FILL, _PASSAGE_FILL, _PIPE = "#eaf2fb", "#f3f4f6", "white", "#49525e"
_CONTROLLER_FILL, _BODY_FILL = "#f4effa", "#fbf6e9"
_LINE_WIDTH = 1.1  # of symbols [pt]
BODY = "body"
"""Port name of the edge from an actuator to its body."""


def draw_circuit(circuit: BaseCircuit, path: str | Path | None = None) -> Figure:
    """Draw the schematic of a circuit, with the gas supplies at the left.

    Notes
    -----
    Arrows show the direction of positive flow, not the flow of a run. The symbols follow ISO 1219-1, but the drawing is
    not a circuit diagram of that standard.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, Orifice
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> figure = draw_circuit(Circuit({"tank": Chamber(volume="10 l"), "vent": vent}))
    >>> "10 l" in [text.get_text() for text in figure.axes[0].texts]
    True
    """
    with style("A picture of a circuit", path):
        return save_figure(_Schematic(circuit).draw(), path)


class EmptyLine(NamedTuple):
    """Empty line of text in the box of a part, with position and size [pt].

    `x` and `y` are the centre of the line, measured from the upper left corner of the figure.
    """

    part: str
    x: float
    y: float
    width: float
    height: float


def draw_with_empty_lines(
    circuit: BaseCircuit, counts: Mapping[str, int], min_width: float
) -> tuple[Figure, list[EmptyLine]]:
    """Draw a schematic in which boxes contain empty lines for values.

    The result contains the figure and the lines. `counts` maps parts to numbers of empty lines, and `min_width` is the
    minimum width of a line [in].
    """
    with style("A picture of a circuit"):
        schematic = _Schematic(circuit, counts, min_width)
        figure = schematic.draw()
    left, top = schematic.axes.get_xlim()[0], schematic.axes.get_ylim()[1]
    return figure, [
        EmptyLine(name, 72.0 * (x - left), 72.0 * (top - y), 72.0 * width, 72.0 * _LINE)
        for name, x, y, width in schematic.empty_lines
    ]


def signal_caption(circuit: BaseCircuit, address: str) -> str:
    """Return the kind and the range of the signal that drives an input.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, Orifice
    >>> from poppet.timeseries.signals import Steps
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> tank = Chamber(volume="10 l")
    >>> steps = Steps([0.0, 1.0], [0.0, 0.5])
    >>> signal_caption(Circuit({"tank": tank, "vent": vent}, {"vent.opening": steps}), "vent.opening")
    'opening: steps, 0 ... 0.5'
    """
    signal = circuit.signals[address]
    part, _, local = address.partition(".")
    unit = next(item.unit for item in circuit.parts[part].inputs() if item.name == local)
    low, high = (format_value(bound, unit) for bound in signal.bounds())
    limits = high if low == high else f"{low.partition(' ')[0]} ... {high}"  # the unit once, behind both
    return f"{local.replace('_', ' ')}: {type(signal).__name__.lower()}, {limits}"


def part_caption(circuit: BaseCircuit, name: str) -> list[str]:
    """Return the lines of text that describe a part in a schematic."""
    signals = frozenset(key.partition(".")[2] for key in circuit.signals if key.startswith(f"{name}."))

    def parameter(local: str) -> float:
        return circuit.parameters[f"{name}.{local}"]

    part = circuit.parts[name]
    fault = []
    if isinstance(part, Valve) and part.fault != HEALTHY:
        fault = [f"fault: {part.fault.replace('_', ' ')}"]
    return [*part.caption(CaptionNumbers(parameter, signals, circuit.surroundings.pressure)), *fault]


@dataclass(frozen=True)
class _Box:
    """Box of a part in a schematic: text, signal labels (tags) and size [in]."""

    name: str
    lines: tuple[str, ...]
    tags: tuple[str, ...]
    width: float
    height: float
    symbol_height: float = 0.0

    @property
    def body_height(self) -> float:
        """Height of the box [in], without the signal labels above it."""
        return self.height - _TAG * len(self.tags)

    @property
    def port_height(self) -> float:
        """Height of the pipe ends relative to the centre of the box [in]."""
        middle = self.body_height - _PAD - self.symbol_height / 2.0 if self.symbol_height else self.body_height / 2.0
        return middle - self.height / 2.0


class _Schematic:
    def __init__(self, circuit: BaseCircuit, counts: Mapping[str, int] | None = None, min_width: float = 0.0) -> None:
        self.circuit, self.counts, self.min_width = circuit, counts or {}, min_width
        self.empty_lines: list[tuple[str, float, float, float]] = []  # centres and widths [in]
        edges = []
        for name, part in circuit.parts.items():
            for port, store in part.ports().items():
                if isinstance(part, Tube) and store in part.outer_ports():
                    continue  # the port that names the tube has this edge
                owner = store.partition(".")[0]
                edges.append((name, port, f"{AMBIENT} at {name}.{port}" if store == AMBIENT else owner))
            body = part.body_name()
            edges += [] if body is None else [(name, BODY, body)]
        passages = tuple(dict.fromkeys(edge[0] for edge in edges))
        stores = [name for name in circuit.parts if name not in passages]
        ends = [edge[2] for edge in edges if edge[2] not in passages]  # a tube is a gas node and a flow path
        inlet_ports = {name: (*part.inlet_ports, *part.pilot_ports) for name, part in circuit.parts.items()}
        inlets = frozenset(edge for edge in edges if edge[1] in inlet_ports[edge[0]])
        self.graph = Graph(tuple(dict.fromkeys([*stores, *ends])), passages, tuple(edges), inlets)
        parts = {name: circuit.parts.get(name) for name in self.graph.stores}  # None: the ambient
        sources = [name for name, part in parts.items() if part is None or isinstance(part, Reservoir | Controller)]
        layers = assign_layers(self.graph, sources)
        self.sides = {edge: layers[edge[2]] < layers[edge[0]] for edge in self.graph.edges}  # True: left of the passage
        self.boxes = {name: self._box(name) for name in layers}
        sizes = {name: (box.width, box.height) for name, box in self.boxes.items()}
        anchors = {name: box.port_height for name, box in self.boxes.items()}
        self.layout = Layout(self.graph, layers, sizes, _GAPS, anchors)
        self.ends = self._pipe_ends()

    def draw(self) -> Figure:
        """Draw all boxes and pipes, and return the figure."""
        positions, notes = self.layout.positions, self._notes()
        right = max(position.x + self.layout.sizes[name][0] / 2.0 for name, position in positions.items())
        top = max(position.y + self.layout.sizes[name][1] / 2.0 for name, position in positions.items())
        head, foot = 0.32 * bool(self.circuit.title), 0.14 * len(notes) + 0.08
        widths = [text_width(note, _NOTE_TEXT) for note in notes] + [text_width(self.circuit.title, 11, bold=True)]
        width, height = max(right, *widths) + 2 * _MARGIN, top + head + foot + 2 * _MARGIN
        figure = new_figure(width, height)
        self.axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        self.axes.set_xlim(-_MARGIN, width - _MARGIN)
        self.axes.set_ylim(-_MARGIN - foot, height - _MARGIN - foot)
        self.axes.set_axis_off()
        for edge in self.graph.edges:
            self._pipe(edge)
        for name, box in self.boxes.items():
            self._draw_box(name, box, positions[name])
        for edge in self.graph.edges:
            self._label_end(self.ends[edge, edge[0]], self.sides[edge], self._port_label(edge))
            if node := self._node_label(edge):
                self._label_end(self.ends[edge, edge[2]], not self.sides[edge], node)
        if self.circuit.title:
            self._text(0.0, top + head, self.circuit.title, 11, ha="left", va="top", fontweight="bold")
        for k, note in enumerate(notes):
            self._text(0.0, -0.12 - 0.14 * k, note, _NOTE_TEXT, ha="left", va="top", color=GREY)
        return figure

    def _label_end(self, end: tuple[float, float], is_left: bool, text: str) -> None:
        options = {"ha": "left" if is_left else "right", "color": GREY, "zorder": 3}
        self._text(end[0] + (0.05 if is_left else -0.05), end[1], text, 6.5, **options)

    # Content of boxes ---------------------------------------------------------------------------------------

    def _box(self, name: str) -> _Box:
        part = self.circuit.parts.get(name)
        if part is None:
            return _Box("", (), (), 0.55, _VENT)
        lines = (*part_caption(self.circuit, name), *[""] * self.counts.get(name, 0))
        prefix = f"{name}."
        tags = tuple(signal_caption(self.circuit, key) for key in self.circuit.signals if key.startswith(prefix))
        connected = {k.removeprefix(prefix): v for k, v in self.circuit.connections.items() if k.startswith(prefix)}
        tags += tuple(f"{target.replace('_', ' ')} = {source}" for target, source in connected.items())
        widths = [text_width(name, _NAME_TEXT, bold=True), *(text_width(line, _TEXT) for line in lines)]
        widths += [text_width(tag, _TEXT) + 0.1 for tag in tags]
        widths += [self.min_width] * (name in self.counts)
        ports = [edge for edge in self.graph.edges if name in (edge[0], edge[2])]
        max_ports = max(sum(self.sides[edge] is side for edge in ports) for side in (True, False)) if ports else 0
        # Parts of plugins without a symbol have a labelled box if they have ports.
        has_symbol = name in self.graph.passages or bool(part.symbol)
        symbol_height = max(_SYMBOL, _PORT_STEP * max_ports) + 0.06 if has_symbol else 0.0
        if symbol_height:
            texts = (self._port_label(edge) if edge[0] == name else self._node_label(edge) for edge in ports)
            label = max((text_width(text, 6.5) for text in texts), default=0.0)
            symbol, symbol_width = part.symbol_for(False), 1.8  # of the labelled box
            if not isinstance(symbol, str):
                # The label of a port is beside the outermost point of the symbol.
                left, right = horizontal_ends(symbol)
                symbol_width = max(1.0, right - left)
            widths.append(2.0 * label + (symbol_width + 0.6) * _SYMBOL)
        body = symbol_height + _LINE * len(lines) + 0.17 + 2.0 * _PAD
        body = max(body, _PORT_STEP * len(ports))
        return _Box(name, lines, tags, max(widths) + 2.0 * _PAD, body + _TAG * len(tags), symbol_height)

    def _notes(self) -> list[str]:
        notes = []
        texts = [line for box in self.boxes.values() for line in box.lines]
        if any(ASSUMED in text for text in texts):
            notes.append(f"{ASSUMED} assumed")
        if any(box.tags for box in self.boxes.values()):
            notes.append("Orange: inputs driven by a signal or by another part.")
        ambient = self.circuit.surroundings
        notes.append(
            f"Pressures absolute unless marked g. Ambient {format_value(ambient.pressure, 'Pa')}, "
            f"{format_value(ambient.temperature, 'K')}. Gas constant {ambient.gas_constant:g} J/(kg K), "
            f"isentropic exponent {ambient.isentropic_exponent:g}."
        )
        return notes

    # Ends of pipes ----------------------------------------------------------------------------------------

    def _pipe_ends(self) -> dict[tuple[Edge, str], tuple[float, float]]:
        """Return the positions at which pipes end at boxes [in].

        The keys are pairs of a connection and a box. At each box, the ends are in the order of the boxes at the other
        ends of the pipes.
        """
        groups: dict[tuple[str, bool], list[tuple[float, Edge]]] = defaultdict(list)
        for edge, chain in self.layout.chains.items():
            positions, is_left = self.layout.positions, self.sides[edge]
            groups[edge[0], is_left].append((positions[chain[1]].y, edge))
            groups[edge[2], not is_left].append((positions[chain[-2]].y, edge))
        ends = {}
        for (name, is_left), members in groups.items():
            position, box = self.layout.positions[name], self.boxes[name]
            x = position.x + (-0.5 if is_left else 0.5) * box.width
            middle = position.y + box.port_height
            step = _PORT_STEP if box.symbol_height else min(_PORT_STEP, box.body_height / len(members))
            for k, (_, edge) in enumerate(sorted(members, key=lambda item: -item[0])):
                ends[edge, name] = (x, middle + (0.5 * (len(members) - 1) - k) * step)
        return ends

    # Drawing ------------------------------------------------------------------------------------------------

    def _pipe(self, edge: Edge) -> None:
        from matplotlib.patches import PathPatch
        from matplotlib.path import Path as Outline

        points = [self.ends[edge, edge[0]]]
        for name in self.layout.chains[edge]:
            position = self.layout.positions[name]
            half = self.layout.column_width(position.layer) / 2.0
            y = self.ends[edge, name][1] if (edge, name) in self.ends else position.y
            sides = [(position.x - half, y), (position.x + half, y)]
            points += sides[::-1] if self.sides[edge] else sides
        points = [points[0], *points[2:-1], self.ends[edge, edge[2]]]
        vertices, codes = [points[0]], [Outline.MOVETO]
        for k, (start, end) in enumerate(pairwise(points)):
            if k % 2:  # between two layers; other sections are horizontal
                middle = (start[0] + end[0]) / 2.0
                vertices += [(middle, start[1]), (middle, end[1]), end]
                codes += [Outline.CURVE4] * 3
            else:
                vertices.append(end)
                codes.append(Outline.LINETO)
        part = self.circuit.parts[edge[0]]
        is_pilot = edge[1] in part.pilot_ports
        line: dict[str, Any] = {"facecolor": "none", "linestyle": (0, (2.5, 1.8)) if is_pilot else "-"}
        # A rod is drawn as two lines.
        for width, color in ((4.5, INK), (3.0, "white")) if edge[1] == BODY else ((1.7, _PIPE),):
            self.axes.add_patch(PathPatch(Outline(vertices, codes), edgecolor=color, linewidth=width, **line))
        if edge[1] == BODY or is_pilot:
            return
        # An arrow in the direction of positive flow, halfway to the next layer.
        a, b = complex(*points[1]), complex(*points[2])
        slope = complex((b - a).real / 2.0, (b - a).imag)  # of the curve at its middle
        ports = [candidate for candidate in self.graph.edges if candidate[0] == edge[0]]
        is_inlet = edge[1] in (part.inlet_ports or (ports[0][1],)) and len(ports) > 1
        direction = slope / (-abs(slope) if is_inlet else abs(slope))
        tip, back, wing = (a + b) / 2.0 + 0.07 * direction, (a + b) / 2.0 - 0.07 * direction, 0.055j * direction
        corners = (tip, back + wing, back - wing)
        self.axes.fill([c.real for c in corners], [c.imag for c in corners], color=_PIPE, linewidth=0.0, zorder=3)

    def _draw_box(self, name: str, box: _Box, position: BoxPosition) -> None:
        from matplotlib.patches import FancyBboxPatch

        left, bottom = position.x - box.width / 2.0, position.y - box.height / 2.0
        if not box.name:
            self._strokes(OPEN_END, left, position.y - _VENT / 2.0, _VENT)
            self._text(left, position.y - _VENT / 2.0, AMBIENT, 6.5, ha="left", va="top", color=GREY)
            return
        part = self.circuit.parts[name]
        is_path = not isinstance(part, Store | Controller | Body) or name in self.graph.passages
        is_chamber = not is_path and isinstance(part, Store) and not isinstance(part, Reservoir)
        fill = _PASSAGE_FILL if is_path else _STORE_FILL if is_chamber else _RESERVOIR_FILL
        fill = _CONTROLLER_FILL if isinstance(part, Controller) else _BODY_FILL if isinstance(part, Body) else fill
        shape = f"round,pad=0,rounding_size={min(0.22, box.body_height / 2.0) if is_chamber else 0.02}"
        outline: dict[str, Any] = {"facecolor": fill, "edgecolor": INK, "zorder": 2}
        outline["linewidth"] = 0.9 if is_path else 1.5
        self.axes.add_patch(FancyBboxPatch((left, bottom), box.width, box.body_height, boxstyle=shape, **outline))
        top = bottom + box.body_height - _PAD
        if box.symbol_height:
            self._symbol(name, position.x, top - box.symbol_height / 2.0)
            top -= box.symbol_height
        top -= (top - bottom - _PAD - 0.17 - _LINE * len(box.lines)) / 2.0  # centred
        self._text(position.x, top - 0.08, name, _NAME_TEXT, fontweight="bold")
        for k, line in enumerate(box.lines):
            y = top - 0.17 - _LINE * (k + 0.5)
            if line:
                # A live page marks the lines of a changed part.
                self._text(position.x, y, line, _TEXT, gid=f"caption.{name}.{k}")
            else:
                self.empty_lines.append((name, position.x, y, box.width - 2.0 * _PAD))
        height = _TAG - 0.025
        tag_style: dict[str, Any] = {"facecolor": "#fdeee4", "edgecolor": ACCENT, "linewidth": 0.8, "zorder": 2}
        for k, tag in enumerate(box.tags):
            low = bottom + box.body_height + _TAG * k + 0.025
            self.axes.add_patch(FancyBboxPatch((left, low), box.width, height, boxstyle="square,pad=0", **tag_style))
            self._text(position.x, low + height / 2.0, tag, _TEXT, color=ACCENT)

    def _symbol(self, name: str, x: float, y: float) -> None:
        """Draw the symbol of a part, centred on `x` and `y` [in].

        A part without a symbol is drawn as a box with a label.
        """
        part = self.circuit.parts[name]
        is_driven = any(key.startswith(f"{name}.") for key in (*self.circuit.signals, *self.circuit.connections))
        symbol = part.symbol_for(is_driven)
        left, bottom = x - _SYMBOL / 2.0, y - _SYMBOL / 2.0
        if not isinstance(symbol, str):
            ports = [edge for edge in self.graph.edges if edge[0] == name]
            # Positive flow enters at the right, or leaves a source at the left. A reservoir points to its pipes.
            is_mirrored = bool(ports) and self.sides[ports[0]] == (len(ports) == 1)
            if isinstance(part, Reservoir):
                is_mirrored = not any(self.sides[edge] for edge in self.graph.edges if edge[2] == name)
            offset = (0.5 - 0.5 * sum(horizontal_ends(symbol))) * _SYMBOL * (-1.0 if is_mirrored else 1.0)
            self._strokes(symbol, left + offset, bottom, _SYMBOL, is_mirrored=is_mirrored)
            return
        label = symbol or part.kind.replace("_", " ")
        self._strokes(rectangle(-0.5, 0.2, 2.0, 0.6), left, bottom, _SYMBOL)
        self._text(x, y, label, min(6.5, 6.5 * 1.9 * _SYMBOL / text_width(label, 6.5)))

    def _strokes(self, symbol: Symbol, left: float, bottom: float, size: float, *, is_mirrored: bool = False) -> None:
        """Draw the lines of a symbol in a square.

        `left` and `bottom` are the coordinates of the lower left corner of the square, and `size` is the length of a
        side of the square [in]. If the keyword `is_mirrored` is True, left and right are exchanged.
        """
        for stroke in symbol:
            x = [left + size * (1.0 - u if is_mirrored else u) for u, _ in stroke.points]
            y = [bottom + size * v for _, v in stroke.points]
            if stroke.is_closed:
                fill = INK if stroke.is_filled else "white"
                self.axes.fill(x, y, facecolor=fill, edgecolor=INK, linewidth=_LINE_WIDTH, zorder=3)
            else:
                dashes = (0, (2.5, 1.8)) if stroke.is_dashed else "-"
                self.axes.plot(x, y, color=INK, linewidth=_LINE_WIDTH, linestyle=dashes, zorder=3)

    def _text(self, x: float, y: float, text: str, size: float, **options: Any) -> None:
        properties: dict[str, Any] = {"ha": "center", "va": "center", "color": INK, "zorder": 4} | options
        self.axes.text(x, y, text, fontsize=size, parse_math=False, **properties)

    def _node_label(self, edge: Edge) -> str:
        """Return the local name of the gas node at the end of a pipe, which is empty if it is the part itself."""
        return self.circuit.parts[edge[0]].ports().get(edge[1], "").partition(".")[2]

    def _port_label(self, edge: Edge) -> str:
        part, port = self.circuit.parts[edge[0]], edge[1]
        # Inlets have no number: a and b are outlets of directional valves only.
        return "" if port == BODY else port if port in part.inlet_ports else _PORT_NUMBERS.get(port, port.rstrip("_"))

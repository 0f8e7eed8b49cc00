"""Small pictures of the gallery: the symbols of a circuit and one curve, as SVG text whose colours follow the page."""

from __future__ import annotations

import html
import math
from dataclasses import replace
from itertools import pairwise

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.core.number_format import USUAL, pretty
from poppet.core.units import convert
from poppet.edit.svg_symbols import MODULES, svg_text
from poppet.parts import Reservoir
from poppet.parts.part import Body, Controller
from poppet.parts.symbols import OPEN_END, horizontal_ends
from poppet.report.circuit.layout import BoxPosition, Edge, Layout
from poppet.report.circuit.schematic import BODY, _Box, _Schematic
from poppet.timeseries.plotting.panels import thinned
from poppet.timeseries.recording import Recording

SYMBOL, PAD, PORT_STEP, GAPS = 0.42, 0.07, 0.16, (0.45, 0.16)  # [in]
WIDTH, CURVE_HEIGHT, DRAWING_HEIGHT = 320.0, 118.0, 130.0  # of a picture [px]
MAX_SCALE = 62.0  # [px/in]
MARGINS = {"left": 40.0, "right": 10.0, "top": 22.0, "bottom": 20.0}  # of a curve [px]


class CardSchematic(_Schematic):
    """Schematic of a circuit with boxes that contain symbols only.

    Parts without pipes, such as controllers, are in a row below the others.
    """

    def __init__(self, circuit: BaseCircuit) -> None:
        super().__init__(circuit)
        connected = {name for edge in self.graph.edges for name in (edge[0], edge[2])}
        self.single = [name for name in self.boxes if name not in connected]
        self.graph = replace(self.graph, stores=tuple(name for name in self.graph.stores if name in connected))
        layers = {name: layer for name, layer in self.layout.layers.items() if name in connected}
        sizes = {name: (self.boxes[name].width, self.boxes[name].height) for name in layers}
        self.layout = Layout(self.graph, layers, sizes, GAPS, {})
        self.ends = self._pipe_ends()

    def _box(self, name: str) -> _Box:
        part = self.circuit.parts.get(name)
        if part is None:
            return _Box("", (), (), 0.3, 0.3)
        symbol = part.symbol_for(False)
        left, right = (0.0, 1.6) if isinstance(symbol, str) else horizontal_ends(symbol)
        ports = [edge for edge in self.graph.edges if name in (edge[0], edge[2])]
        side = max((sum(self.sides[edge] is is_left for edge in ports) for is_left in (True, False)), default=0)
        height = max(SYMBOL, PORT_STEP * side)
        # A symbol height that is smaller by two paddings of the schematic puts the ports at the middle.
        return _Box(name, (), (), (right - left) * SYMBOL + 2.0 * PAD, height + 2.0 * PAD, height + 2.0 * PAD - 0.2)

    def svg(self, title: str) -> str:
        """Return the drawing as SVG text."""
        positions, sizes = self.layout.positions, self.layout.sizes
        left = 0.0
        for name in self.single:
            box = self.boxes[name]
            positions[name], sizes[name] = BoxPosition(left + box.width / 2.0, -0.35, -1), (box.width, box.height)
            left += box.width + 0.2
        right = max(position.x + sizes[name][0] / 2.0 for name, position in positions.items())
        bottom = -0.65 if self.single else 0.0
        top = max(position.y + sizes[name][1] / 2.0 for name, position in positions.items()) - bottom
        scale = min(MAX_SCALE, WIDTH / (right + 0.1), DRAWING_HEIGHT / (top + 0.1))
        self.origin = (WIDTH - scale * right) / 2.0, (DRAWING_HEIGHT + scale * top) / 2.0 + scale * bottom, scale
        pipes = "".join(self._pipe_path(edge) for edge in self.graph.edges)
        boxes = "".join(self._box_svg(name) for name in self.boxes)
        return _svg(DRAWING_HEIGHT, "drawing", title, pipes + boxes)

    def _at(self, x: float, y: float) -> tuple[float, float]:
        left, bottom, scale = self.origin
        return round(left + scale * x, 1), round(bottom - scale * y, 1)

    def _pipe_path(self, edge: Edge) -> str:
        points = [self._at(*point) for point in self._pipe_points(edge)]
        path = f"M{points[0][0]:g} {points[0][1]:g}"
        for k, (start, end) in enumerate(pairwise(points)):
            middle = (start[0] + end[0]) / 2.0
            # Between two layers the pipe is curved, elsewhere horizontal.
            curve = f"C{middle:g} {start[1]:g} {middle:g} {end[1]:g} {end[0]:g} {end[1]:g}"
            path += curve if k % 2 else f"L{end[0]:g} {end[1]:g}"
        is_pilot = edge[1] in self.circuit.parts[edge[0]].pilot_ports
        name = "rod" if edge[1] == BODY else "pilot" if is_pilot else "pipe"
        return f'<path class="{name}" d="{path}"/>'

    def _pipe_points(self, edge: Edge) -> list[tuple[float, float]]:
        points = [self.ends[edge, edge[0]]]
        for name in self.layout.chains[edge]:
            position = self.layout.positions[name]
            half = self.layout.column_width(position.layer) / 2.0
            y = self.ends[edge, name][1] if (edge, name) in self.ends else position.y
            sides = [(position.x - half, y), (position.x + half, y)]
            points += sides[::-1] if self.sides[edge] else sides
        return [points[0], *points[2:-1], self.ends[edge, edge[2]]]

    def _box_svg(self, name: str) -> str:
        box, position, scale = self.boxes[name], self.layout.positions[name], self.origin[2]
        x, y = self._at(position.x, position.y)
        part = self.circuit.parts.get(name)
        if part is None:
            return self._symbol_svg(svg_text(OPEN_END), x, y, 0.3)
        width, height = scale * box.width, scale * box.height
        kind = "control" if isinstance(part, Controller) else "moving" if isinstance(part, Body) else "gas"
        frame = (
            f'<rect class="{kind}" x="{x - width / 2.0:.1f}" y="{y - height / 2.0:.1f}" width="{width:.1f}" '
            f'height="{height:.1f}" rx="4"><title>{html.escape(name)}</title></rect>'
        )
        is_driven = any(key.startswith(f"{name}.") for key in (*self.circuit.signals, *self.circuit.connections))
        symbol = part.symbol_for(is_driven)
        if isinstance(symbol, str):
            return (
                f'{frame}<text x="{x:g}" y="{y + 3.5:g}" class="middle small">{html.escape(symbol or part.kind)}</text>'
            )
        ports = [edge for edge in self.graph.edges if edge[0] == name]
        is_mirrored = bool(ports) and self.sides[ports[0]] == (len(ports) == 1)
        if isinstance(part, Reservoir):
            is_mirrored = not any(self.sides[edge] for edge in self.graph.edges if edge[2] == name)
        shift = (0.5 - 0.5 * sum(horizontal_ends(symbol))) * SYMBOL * (-1.0 if is_mirrored else 1.0)
        return frame + self._symbol_svg(svg_text(symbol), x + scale * shift, y, SYMBOL, is_mirrored=is_mirrored)

    def _symbol_svg(self, strokes: str, x: float, y: float, size: float, *, is_mirrored: bool = False) -> str:
        module = self.origin[2] * size / MODULES
        across = -module if is_mirrored else module
        return f'<g transform="translate({x:g} {y:g}) scale({across:.3g} {module:.3g})">{strokes}</g>'


def card_drawing(circuit: BaseCircuit) -> str:
    """Return the symbols of a circuit with their pipes as SVG text."""
    return CardSchematic(circuit).svg(f"Symbols of the circuit: {circuit.title}")


def card_curve(recording: Recording, address: str, *, dashed: str = "") -> str:
    """Return one curve with its axes as SVG text; a second output of the same quantity can be drawn dashed."""
    units = dict(zip(recording.names, recording.units, strict=True))
    unit = "deg" if units[address] == "rad" else USUAL.get(units[address], units[address])
    time = np.asarray(recording.time, dtype=float)
    duration = float(time[-1])
    series = {name: np.asarray(convert(recording[name], units[name], unit)) for name in (address, dashed) if name}
    low = min(float(values.min()) for values in series.values())
    high = max(float(values.max()) for values in series.values())
    step = _nice_step((high - low) or abs(high) or 1.0)
    # Small overshoots, for example of a body at its end stop, do not add a division.
    low, high = step * math.floor(low / step + 0.1), step * math.ceil(high / step - 0.1)
    high += step * (high == low)
    factor, time_unit = (1e3, "ms") if duration < 1.0 else (1.0, "s") if duration < 600.0 else (1.0 / 60.0, "min")

    def x_of(t: float) -> float:
        return MARGINS["left"] + (WIDTH - MARGINS["left"] - MARGINS["right"]) * t / duration

    def y_of(value: float) -> float:
        return (
            CURVE_HEIGHT
            - MARGINS["bottom"]
            - (CURVE_HEIGHT - MARGINS["top"] - MARGINS["bottom"]) * (value - low) / (high - low)
        )

    parts = []
    for k in range(round((high - low) / step) + 1):
        value = low + k * step
        parts.append(f'<path class="grid" d="M{MARGINS["left"]:g} {y_of(value):.1f}H{WIDTH - MARGINS["right"]:g}"/>')
        parts.append(
            f'<text class="end" x="{MARGINS["left"] - 5:g}" y="{y_of(value) + 4:.1f}">{_tick(value, step)}</text>'
        )
    for name, values in reversed(series.items()):
        rows = thinned(time, values, 160)
        points = "L".join(f"{x_of(time[k]):.1f} {y_of(values[k]):.1f}" for k in rows)
        parts.append(f'<path class="{"dashed" if name == dashed else "curve"}" d="M{points}"/>')
    part, _, quantity = address.rpartition(".")
    label = f"{quantity.replace('_', ' ')} of {part.replace('_', ' ')}" + f" [{pretty(unit)}]" * (unit != "1")
    end = f"{factor * duration:.3g} {time_unit}"
    parts.append(f'<text x="2" y="12" class="name">{html.escape(label)}</text>')
    if dashed:
        owner, _, other = dashed.rpartition(".")
        text = (owner if other == quantity else other).replace("_", " ")
        parts.append(f'<text class="end second" x="{WIDTH - MARGINS["right"]:g}" y="12">{html.escape(text)}</text>')
    parts.append(f'<text class="end" x="{WIDTH - MARGINS["right"]:g}" y="{CURVE_HEIGHT - 5:g}">{end}</text>')
    parts.append(f'<text x="{MARGINS["left"]:g}" y="{CURVE_HEIGHT - 5:g}">0</text>')
    return _svg(CURVE_HEIGHT, "curve-picture", f"Curve: {label} versus time", "".join(parts))


def _nice_step(span: float) -> float:
    """Return a step of 1, 2 or 5 times a power of ten that divides a span into two to four parts."""
    power = 10.0 ** math.floor(math.log10(span / 2.0))
    return max(step * power for step in (1.0, 2.0, 5.0) if step * power <= span / 2.0)


def _tick(value: float, step: float) -> str:
    text = f"{value:.{max(0, -math.floor(math.log10(step)))}f}"
    return text.removeprefix("-") if abs(value) < step / 2.0 else text


def _svg(height: float, name: str, title: str, content: str) -> str:
    label = html.escape(title, quote=True)
    return f'<svg class="{name}" viewBox="0 0 {WIDTH:g} {height:g}" role="img" aria-label="{label}">{content}</svg>'

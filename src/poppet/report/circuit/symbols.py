"""Symbols of passages, drawn after the habit of ISO 1219-1: each a few strokes in a box of 1 by 1."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.timeseries.plotting.figures import INK

_THIN = 1.1  # line width [pt]
Stroke = Sequence[tuple[float, float]]


@dataclass(frozen=True)
class Pen:
    """Draws in a box of its own, 0..1 both ways."""

    axes: Any  # with equal scales [in]
    left: float  # of the box on the axes [in]
    bottom: float
    size: float
    is_mirrored: bool = False  # gas enters at the right

    def line(self, points: Stroke, *, dashed: bool = False) -> None:
        """A polyline."""
        x, y = self._at(points)
        style = (0, (2.5, 1.8)) if dashed else "-"
        self.axes.plot(x, y, color=INK, linewidth=_THIN, linestyle=style, zorder=3)

    def shape(self, points: Stroke, *, filled: bool = False) -> None:
        """A closed outline."""
        x, y = self._at(points)
        self.axes.fill(x, y, facecolor=INK if filled else "white", edgecolor=INK, linewidth=_THIN, zorder=3)

    def circle(self, x: float, y: float, radius: float) -> None:
        """A circle, white inside."""
        self.shape(_round(x, y, radius, np.linspace(0.0, 2.0 * np.pi, 49)))

    def arc(self, x: float, y: float, radius: float, start: float, end: float) -> None:
        """Part of a circle."""
        self.line(_round(x, y, radius, np.radians(np.linspace(start, end, 25))))

    def arrow(self, start: tuple[float, float], end: tuple[float, float]) -> None:
        """A line with a filled head at its end."""
        self.line([start, end])
        along = np.subtract(end, start) / np.hypot(*np.subtract(end, start))
        across = np.array([-along[1], along[0]])
        base = np.array(end) - 0.14 * along
        self.shape([end, tuple(base + 0.06 * across), tuple(base - 0.06 * across)], filled=True)

    def valve(self) -> None:
        """Two squares, flow in one and none in the other."""
        self.square(0.02, 0.24, 0.48, 0.52)
        self.square(0.5, 0.24, 0.48, 0.52)
        self.arrow((0.14, 0.24), (0.38, 0.76))
        for low, stop in ((0.24, 0.38), (0.76, 0.62)):
            self.line([(0.74, low), (0.74, stop)])
            self.line([(0.66, stop), (0.82, stop)])

    def spool_valve(self) -> None:
        """Three squares of a valve with five ports: ways parallel, shut, crossed; between lines, with two operators."""
        for left in (-0.28, 0.24, 0.76):
            self.square(left, 0.24, 0.52, 0.52)
        self.arrow((-0.14, 0.24), (-0.14, 0.76))
        self.arrow((0.1, 0.76), (0.1, 0.24))
        self.arrow((0.86, 0.24), (1.18, 0.76))
        self.arrow((0.86, 0.76), (1.18, 0.24))
        for low, stop in ((0.24, 0.36), (0.76, 0.64)):
            for x in (0.38, 0.62):
                self.line([(x, low), (x, stop)])
                self.line([(x - 0.07, stop), (x + 0.07, stop)])
        for y in (0.16, 0.84):
            self.line([(-0.28, y), (1.28, y)])
        for left in (-0.5, 1.28):
            _coil(self, left, 0.36)

    def continuous_valve(self) -> None:
        """The same between two lines: it may stand anywhere between its ends."""
        self.valve()
        self.line([(0.02, 0.84), (0.98, 0.84)])
        self.line([(0.02, 0.16), (0.98, 0.16)])

    def spring(self, left: float, right: float, y: float) -> None:
        """A zigzag."""
        x = np.linspace(left, right, 7)
        self.line([(float(a), y + (0.07 if k % 2 else -0.07)) for k, a in enumerate(x)])

    def square(self, left: float, bottom: float, width: float, height: float) -> None:
        """An upright rectangle, white inside."""
        right, top = left + width, bottom + height
        self.shape([(left, bottom), (right, bottom), (right, top), (left, top)])

    def _at(self, points: Stroke) -> tuple[list[float], list[float]]:
        x, y = zip(*points, strict=True)
        return [self.left + self.size * (1.0 - v if self.is_mirrored else v) for v in x], [
            self.bottom + self.size * v for v in y
        ]


def _round(x: float, y: float, radius: float, turn: Any) -> Stroke:
    return list(zip(x + radius * np.cos(turn), y + radius * np.sin(turn), strict=True))


def _restriction(pen: Pen) -> None:
    pen.line([(0.0, 0.5), (1.0, 0.5)])
    pen.arc(0.5, 0.98, 0.4, 220.0, 320.0)
    pen.arc(0.5, 0.02, 0.4, 40.0, 140.0)


def variable_restriction(pen: Pen) -> None:
    """A restriction that something adjusts."""
    _restriction(pen)
    pen.arrow((0.14, 0.08), (0.88, 0.94))


def _check_valve(pen: Pen) -> None:
    pen.line([(0.0, 0.5), (0.3, 0.5)])
    pen.line([(0.68, 0.5), (1.0, 0.5)])
    pen.line([(0.48, 0.76), (0.3, 0.5), (0.48, 0.24)])
    pen.circle(0.53, 0.5, 0.15)


def _relief_valve(pen: Pen) -> None:
    pen.line([(0.0, 0.5), (1.0, 0.5)])
    pen.square(0.22, 0.16, 0.56, 0.6)
    pen.arrow((0.22, 0.36), (0.78, 0.36))
    pen.line([(0.1, 0.5), (0.1, 0.05), (0.5, 0.05), (0.5, 0.16)], dashed=True)
    pen.spring(0.4, 0.66, 0.87)


def _main_stage(pen: Pen) -> None:
    pen.continuous_valve()
    pen.shape([(-0.22, 0.36), (0.02, 0.5), (-0.22, 0.64)])
    pen.spring(0.98, 1.26, 0.5)


def _coil(pen: Pen, left: float, bottom: float) -> None:
    """The operator of a solenoid; the second stroke marks a proportional one."""
    pen.square(left, bottom, 0.22, 0.28)
    pen.line([(left, bottom), (left + 0.22, bottom + 0.28)])


def _proportional_valve(pen: Pen) -> None:
    pen.continuous_valve()
    _coil(pen, -0.2, 0.36)
    pen.arrow((-0.26, 0.3), (0.06, 0.72))
    pen.spring(0.98, 1.26, 0.5)


def _pilot_stage(pen: Pen) -> None:
    pen.line([(0.0, 0.5), (1.0, 0.5)])
    pen.square(0.06, 0.3, 0.3, 0.4)
    pen.square(0.64, 0.3, 0.3, 0.4)
    _coil(pen, 0.1, 0.7)
    _coil(pen, 0.68, 0.7)
    pen.circle(0.5, 0.5, 0.1)


def _flow_source(pen: Pen) -> None:
    pen.line([(0.0, 0.5), (1.0, 0.5)])
    pen.circle(0.5, 0.5, 0.32)
    pen.shape([(0.34, 0.28), (0.34, 0.72), (0.8, 0.5)], filled=True)


def _silencer(pen: Pen) -> None:
    pen.line([(0.0, 0.5), (0.2, 0.5)])
    pen.square(0.2, 0.26, 0.48, 0.48)
    for x in (0.32, 0.44, 0.56):
        pen.line([(x, 0.26), (x, 0.74)], dashed=True)
    pen.shape([(0.74, 0.34), (0.74, 0.66), (0.98, 0.5)])


def _anything(pen: Pen) -> None:
    pen.line([(0.0, 0.5), (1.0, 0.5)])
    pen.square(0.2, 0.2, 0.6, 0.6)


def vent(pen: Pen) -> None:
    """The open air: a triangle that points outward."""
    pen.line([(0.0, 0.5), (0.35, 0.5)])
    pen.shape([(0.35, 0.2), (0.35, 0.8), (0.85, 0.5)])


def _cylinder(pen: Pen) -> None:
    """A barrel with piston and rod."""
    pen.square(0.0, 0.3, 0.75, 0.4)
    pen.line([(0.3, 0.3), (0.3, 0.7)])
    pen.line([(0.3, 0.5), (1.05, 0.5)])


def _muscle(pen: Pen) -> None:
    """Two threads of a braid between its ends."""
    for high in (0.25, 0.75):
        pen.line([(-0.05, 0.5), (0.1, 0.5), (0.3, high), (0.5, 1.0 - high), (0.7, high), (0.9, 0.5), (1.05, 0.5)])


def _tube(pen: Pen) -> None:
    """A long pipe."""
    for y in (0.38, 0.62):
        pen.line([(-0.3, y), (1.3, y)])


SYMBOLS: dict[str, Callable[[Pen], None]] = {
    "cylinder": _cylinder,
    "muscle": _muscle,
    "tube": _tube,
    "orifice": _restriction,
    "check_valve": _check_valve,
    "relief_valve": _relief_valve,
    "directional_valve": Pen.valve,
    "spool_valve": Pen.spool_valve,
    "main_stage": _main_stage,
    "proportional_valve": _proportional_valve,
    "pilot_stage": _pilot_stage,
    "flow_source": _flow_source,
    "silencer": _silencer,
}


def symbol(kind: str) -> Callable[[Pen], None]:
    """What draws a kind of passage; a plain box for kinds without a symbol of their own."""
    return SYMBOLS.get(kind, _anything)

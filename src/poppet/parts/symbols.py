"""Symbols of parts after ISO 1219-1: lines in a square of side length 1 for schematics.

The side of a valve square is 0.5, which is 4 times the module of the standard. The ports of valve squares and the
pilots thus have the distances of the standard.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple


class Stroke(NamedTuple):
    """Line of a schematic symbol: an open polyline or a closed outline."""

    points: tuple[tuple[float, float], ...]
    is_closed: bool = False
    is_filled: bool = False
    is_dashed: bool = False


Symbol = tuple[Stroke, ...]


def horizontal_ends(symbol: Symbol) -> tuple[float, float]:
    """Return the coordinates of the left and of the right end of a schematic symbol."""
    coordinates = [x for stroke in symbol for x, _ in stroke.points]
    return min(coordinates), max(coordinates)


def line(*points: tuple[float, float], dashed: bool = False) -> Symbol:
    """Return a schematic symbol that consists of one open polyline.

    `points` are the corners (x, y), in a square of side length 1. If `dashed` is True, the line is dashed.
    """
    return (Stroke(points, is_dashed=dashed),)


def outline(*points: tuple[float, float], filled: bool = False) -> Symbol:
    """Return a schematic symbol that consists of one closed outline.

    `points` are the corners (x, y), in a square of side length 1. If `filled` is True, the interior is filled.
    """
    return (Stroke(points, is_closed=True, is_filled=filled),)


def rectangle(left: float, bottom: float, width: float, height: float) -> Symbol:
    """Return a schematic symbol that is a rectangle with horizontal and vertical sides."""
    right, top = left + width, bottom + height
    return outline((left, bottom), (right, bottom), (right, top), (left, top))


def arc(x: float, y: float, radius: float, start: float, end: float) -> Symbol:
    """Return a schematic symbol that is a circular arc between the angles `start` and `end` [deg]."""
    angles = (math.radians(start + (end - start) * k / 24) for k in range(25))
    return line(*((x + radius * math.cos(angle), y + radius * math.sin(angle)) for angle in angles))


def circle(x: float, y: float, radius: float) -> Symbol:
    """Return a schematic symbol that is a circle."""
    angles = (math.tau * k / 48 for k in range(49))
    return outline(*((x + radius * math.cos(angle), y + radius * math.sin(angle)) for angle in angles))


def arrow(start: tuple[float, float], end: tuple[float, float], head: float = 0.14) -> Symbol:
    """Return a schematic symbol that is a line with a filled arrowhead of length `head` at its end."""
    (x0, y0), (x, y) = start, end
    length = math.hypot(x - x0, y - y0)
    dx, dy = (x - x0) / length, (y - y0) / length
    base_x, base_y = x - head * dx, y - head * dy
    width = head * 3.0 / 7.0
    corners = [(base_x - side * dy, base_y + side * dx) for side in (width, -width)]
    return line(start, end) + outline(end, *corners, filled=True)


def spring(left: float, right: float, y: float) -> Symbol:
    """Return the schematic symbol of a spring, a horizontal zigzag line."""
    return line(*((left + (right - left) * k / 6, y + (0.07 if k % 2 else -0.07)) for k in range(7)))


def coil(left: float, bottom: float) -> Symbol:
    """Return the schematic symbol of the coil of a proportional solenoid.

    `left` and `bottom` are the coordinates of its lower left corner.
    """
    return rectangle(left, bottom, 0.22, 0.28) + line((left, bottom), (left + 0.22, bottom + 0.28))


_PATH = line((0.0, 0.5), (1.0, 0.5))
RESTRICTION = _PATH + arc(0.5, 0.98, 0.4, 220.0, 320.0) + arc(0.5, 0.02, 0.4, 40.0, 140.0)
VARIABLE_RESTRICTION = RESTRICTION + arrow((0.14, 0.08), (0.88, 0.94))
CHECK_VALVE = (
    line((0.0, 0.5), (0.3, 0.5))
    + line((0.68, 0.5), (1.0, 0.5))
    + line((0.48, 0.76), (0.3, 0.5), (0.48, 0.24))
    + circle(0.53, 0.5, 0.15)
)
FLOW_CONTROL_VALVE = (
    # The check valve above the adjustable restriction.
    line((0.0, 0.5), (0.1, 0.5))
    + line((0.42, 0.74), (0.1, 0.74), (0.1, 0.26), (0.9, 0.26), (0.9, 0.74), (0.64, 0.74))
    + line((0.9, 0.5), (1.0, 0.5))
    + line((0.54, 0.92), (0.42, 0.74), (0.54, 0.56))
    + circle(0.57, 0.74, 0.1)
    + arc(0.5, 0.54, 0.24, 220.0, 320.0)
    + arc(0.5, -0.02, 0.24, 40.0, 140.0)
    + arrow((0.28, -0.02), (0.74, 0.52))
)
PILOTED_CHECK_VALVE = CHECK_VALVE + line((0.1, 0.5), (0.1, 0.12), (0.4, 0.12), (0.4, 0.36), dashed=True)
FILTER = (
    line((0.0, 0.5), (0.14, 0.5))
    + line((0.86, 0.5), (1.0, 0.5))
    + outline((0.14, 0.5), (0.5, 0.86), (0.86, 0.5), (0.5, 0.14))
    + line((0.5, 0.86), (0.5, 0.14), dashed=True)
)
RELIEF_VALVE = (
    _PATH
    + rectangle(0.22, 0.16, 0.56, 0.6)
    + arrow((0.22, 0.36), (0.78, 0.36))
    + line((0.1, 0.5), (0.1, 0.05), (0.5, 0.05), (0.5, 0.16), dashed=True)
    + spring(0.4, 0.66, 0.87)
)

# Two inlets at the left and at the right, the outlet at the top.
_TWO_INLETS = (
    rectangle(0.0, 0.27, 1.0, 0.46)
    + line((-0.14, 0.5), (0.16, 0.5))
    + line((0.84, 0.5), (1.14, 0.5))
    + line((0.5, 0.73), (0.5, 0.99))
)
SHUTTLE_VALVE = (
    _TWO_INLETS
    + line((0.3, 0.69), (0.16, 0.5), (0.3, 0.31))
    + line((0.7, 0.69), (0.84, 0.5), (0.7, 0.31))
    + circle(0.36, 0.5, 0.13)
)
TWO_PRESSURE_VALVE = (
    _TWO_INLETS
    + line((0.16, 0.41), (0.16, 0.59))
    + line((0.84, 0.41), (0.84, 0.59))
    + line((0.3, 0.35), (0.3, 0.65))
    + line((0.7, 0.35), (0.7, 0.65))
    + line((0.3, 0.5), (0.7, 0.5))
)
QUICK_EXHAUST_VALVE = (
    rectangle(0.0, 0.27, 1.0, 0.46)
    + line((-0.14, 0.5), (0.16, 0.5))
    + line((0.5, 0.73), (0.5, 0.99))
    + line((0.84, 0.5), (1.0, 0.5))
    + outline((1.0, 0.38), (1.0, 0.62), (1.22, 0.5))
    + line((0.3, 0.69), (0.16, 0.5), (0.3, 0.31))
    + line((0.7, 0.69), (0.84, 0.5), (0.7, 0.31))
    + circle(0.64, 0.5, 0.13)
)


_SQUARE = 0.5
_LOW, _HIGH = 0.5 - 0.5 * _SQUARE, 0.5 + 0.5 * _SQUARE
# Ports at the bottom and at the top of a valve square by number, as distances from its left side.
_FIVE_PORTS = ({5: 0.125, 1: 0.25, 3: 0.375}, {4: 0.125, 2: 0.375})
_THREE_PORTS = ({1: 0.125, 3: 0.375}, {2: 0.125})
_TWO_PORTS = ({1: 0.125}, {2: 0.125})
# Ports that flows of a position connect.
_PATHS = {
    "a": ((1, 4), (2, 3)), "b": ((1, 2), (4, 5)),
    "": (), "exhaust": ((4, 5), (2, 3)), "supply": ((1, 4), (1, 2)),
    "filled": ((1, 2),), "vented": ((2, 3),),
}  # fmt: skip


def _positions(names: Sequence[str], ports: tuple[dict[int, float], dict[int, float]] = _FIVE_PORTS) -> Symbol:
    """Return the squares of a valve, of which the second is at the same place for two and for three positions.

    `names` are keys of `_PATHS`. A path between ports that the valve lacks is omitted.
    """
    symbol: Symbol = ()
    for k, name in enumerate(names):
        square = (k - 0.5) * _SQUARE if len(ports[0]) == 3 else k * _SQUARE  # coordinate of its left side
        ends = {port: (square + x, y) for row, y in zip(ports, (_LOW, _HIGH), strict=True) for port, x in row.items()}
        paths = [path for path in _PATHS[name] if {*path} <= ends.keys()]
        symbol += rectangle(square, _LOW, _SQUARE, _SQUARE)
        for start, end in paths:
            symbol += arrow(ends[start], ends[end], 0.11)
        for port in sorted(ends.keys() - {port for path in paths for port in path}):
            x, y = ends[port]
            stop = y + (0.1 if y < 0.5 else -0.1)
            symbol += line((x, y), (x, stop)) + line((x - 0.05, stop), (x + 0.05, stop))
    return symbol


def directional_valve(has_exhaust: bool, is_open: bool) -> Symbol:
    """Return the schematic symbol of a 3/2 or 2/2 valve with solenoid and spring; `is_open` is its state at rest."""
    names = ("vented", "filled") if is_open else ("filled", "vented")
    return _positions(names, _THREE_PORTS if has_exhaust else _TWO_PORTS) + coil(-0.22, 0.36) + spring(1.0, 1.24, 0.5)


CONTINUOUS_VALVE = (
    _positions(("filled", "vented"), _THREE_PORTS) + line((0.0, 0.84), (1.0, 0.84)) + line((0.0, 0.16), (1.0, 0.16))
)
SPOOL_VALVE = (
    _positions(("a", "", "b"))
    + line((-0.25, 0.16), (1.25, 0.16))
    + line((-0.25, 0.84), (1.25, 0.84))
    + coil(-0.47, 0.36)
    + coil(1.25, 0.36)
)


def _pilot(tip: float, direction: float) -> Symbol:
    """Return the schematic symbol of a pneumatic pilot, whose triangle touches a valve at `tip`."""
    base = tip - 0.16 * direction
    return outline((base, 0.525), (base, 0.725), (tip, 0.625)) + line(
        (base, 0.625), (base - 0.14 * direction, 0.625), dashed=True
    )


def switched_valve(positions: int, open_at_centre: str, pilots: tuple[bool, bool], has_spring: bool) -> Symbol:
    """Return the schematic symbol of a valve with five ports and two or three positions.

    `open_at_centre` is "supply", "exhaust" or empty. `pilots` contains True for each side with a pneumatic pilot
    instead of a solenoid, side a first. `has_spring` is True if a spring replaces the actuation of the second side.
    """
    symbol = _positions(("a", open_at_centre, "b") if positions == 3 else ("a", "b"))
    left = -0.5 * _SQUARE
    right = left + _SQUARE * positions
    symbol += _pilot(left, 1.0) if pilots[0] else coil(left - 0.22, 0.485)
    if not has_spring:
        symbol += _pilot(right, -1.0) if pilots[1] else coil(right, 0.485)
    springs = spring(right, right + 0.24, 0.35)
    return (
        symbol
        + (springs if has_spring or positions == 3 else ())
        + (spring(left - 0.24, left, 0.35) if positions == 3 else ())
    )


MAIN_STAGE = CONTINUOUS_VALVE + outline((-0.24, 0.36), (0.0, 0.5), (-0.24, 0.64)) + spring(1.0, 1.28, 0.5)
PROPORTIONAL_VALVE = CONTINUOUS_VALVE + coil(-0.22, 0.36) + arrow((-0.28, 0.3), (0.04, 0.72)) + spring(1.0, 1.28, 0.5)
PILOT_STAGE = (
    _PATH
    + rectangle(0.06, 0.3, 0.3, 0.4)
    + rectangle(0.64, 0.3, 0.3, 0.4)
    + coil(0.1, 0.7)
    + coil(0.68, 0.7)
    + circle(0.5, 0.5, 0.1)
)
FLOW_SOURCE = line((0.82, 0.5), (1.0, 0.5)) + circle(0.5, 0.5, 0.32) + arrow((0.26, 0.5), (0.76, 0.5), 0.2)
SILENCER = (
    line((0.0, 0.5), (0.2, 0.5))
    + rectangle(0.2, 0.26, 0.48, 0.48)
    + line((0.32, 0.26), (0.32, 0.74), dashed=True)
    + line((0.44, 0.26), (0.44, 0.74), dashed=True)
    + line((0.56, 0.26), (0.56, 0.74), dashed=True)
    + outline((0.74, 0.34), (0.74, 0.66), (0.98, 0.5))
)
CYLINDER = rectangle(0.0, 0.3, 0.75, 0.4) + line((0.3, 0.3), (0.3, 0.7)) + line((0.3, 0.5), (1.05, 0.5))
GRIPPER = (
    rectangle(0.0, 0.3, 0.5, 0.4)
    + line((0.2, 0.3), (0.2, 0.7))
    + line((0.2, 0.5), (0.66, 0.5))
    + line((0.66, 0.2), (0.66, 0.8))
    + line((0.66, 0.8), (1.05, 0.8), (1.05, 0.62))
    + line((0.66, 0.2), (1.05, 0.2), (1.05, 0.38))
)
# A stepped cylinder with two coupled pistons: the large one is driven, the small one compresses.
PRESSURE_BOOSTER = (
    outline((0.0, 0.16), (0.5, 0.16), (0.5, 0.32), (1.0, 0.32), (1.0, 0.68), (0.5, 0.68), (0.5, 0.84), (0.0, 0.84))
    + line((0.26, 0.16), (0.26, 0.84))
    + line((0.26, 0.5), (0.74, 0.5))
    + line((0.74, 0.32), (0.74, 0.68))
    + outline((0.04, 0.42), (0.04, 0.58), (0.16, 0.5))
    + outline((0.84, 0.42), (0.84, 0.58), (0.96, 0.5))
)
# A half disc with the shaft and a double arrow along the arc of its motion.
ROTARY_ACTUATOR = (
    arc(0.4, 0.5, 0.36, -90.0, 90.0)
    + line((0.4, 0.14), (0.4, 0.86))
    + line((0.4, 0.5), (1.05, 0.5))
    + arc(1.18, 0.5, 0.32, 130.0, 230.0)
)
MUSCLE = line(
    (-0.05, 0.5), (0.1, 0.5), (0.3, 0.25), (0.5, 0.75), (0.7, 0.25), (0.9, 0.5), (1.05, 0.5)
) + line((-0.05, 0.5), (0.1, 0.5), (0.3, 0.75), (0.5, 0.25), (0.7, 0.75), (0.9, 0.5), (1.05, 0.5))  # fmt: skip
TUBE = rectangle(-0.25, 0.38, 1.5, 0.24)
OPEN_END = line((0.0, 0.5), (0.35, 0.5)) + outline((0.35, 0.2), (0.35, 0.8), (0.85, 0.5))
PRESSURE_REGULATOR = (
    _PATH
    + rectangle(0.22, 0.22, 0.56, 0.56)
    + arrow((0.22, 0.5), (0.78, 0.5))
    + line((0.9, 0.5), (0.9, 0.06), (0.5, 0.06), (0.5, 0.22), dashed=True)
    + line((0.5, 0.78), (0.42, 0.83), (0.58, 0.89), (0.42, 0.95), (0.58, 1.01), (0.5, 1.06))
    + arrow((0.28, 0.8), (0.74, 1.08))
    + outline((0.22, 0.32), (0.22, 0.18), (0.1, 0.25))
)
COMPRESSOR = line((0.82, 0.5), (1.0, 0.5)) + circle(0.5, 0.5, 0.32) + outline((0.34, 0.28), (0.34, 0.72), (0.8, 0.5))
VACUUM_EJECTOR = (
    line((0.0, 0.5), (0.12, 0.5))
    + line((0.88, 0.5), (1.0, 0.5))
    + rectangle(0.12, 0.22, 0.76, 0.56)
    + outline((0.12, 0.3), (0.12, 0.7), (0.5, 0.5))
    + line((0.58, 0.57), (0.88, 0.7))
    + line((0.58, 0.43), (0.88, 0.3))
    + line((0.5, 0.22), (0.5, 0.04))
)
SUCTION_CUP = line((0.0, 0.5), (0.5, 0.5)) + line(
    (0.86, 0.16), (0.74, 0.16), (0.5, 0.4), (0.5, 0.6), (0.74, 0.84), (0.86, 0.84)
)

# The outlined triangle of a pneumatic energy source.
RESERVOIR = line((0.62, 0.5), (1.0, 0.5)) + outline((0.2, 0.26), (0.2, 0.74), (0.62, 0.5))
# The oval of an air receiver.
CHAMBER = (
    line((0.0, 0.5), (0.12, 0.5))
    + line((0.88, 0.5), (1.0, 0.5))
    + outline(
        *(
            point
            for x, start in ((0.67, -90.0), (0.33, 90.0))
            for point in arc(x, 0.5, 0.21, start, start + 180.0)[0].points
        )
    )
)
MASS = (
    line((0.0, 0.5), (0.2, 0.5))
    + rectangle(0.2, 0.3, 0.6, 0.42)
    + circle(0.34, 0.22, 0.08)
    + circle(0.66, 0.22, 0.08)
    + line((0.06, 0.14), (0.94, 0.14))
)
# A pulley with its pivot and the rope of two actuators.
JOINT = (
    line((0.0, 0.875), (0.5, 0.875))
    + line((0.0, 0.125), (0.5, 0.125))
    + circle(0.5, 0.5, 0.375)
    + circle(0.5, 0.5, 0.07)
    + line((0.57, 0.5), (1.0, 0.5))
)
GUIDE = (
    line((0.0, 0.5), (0.3, 0.5))
    + line((0.12, 0.76), (1.0, 0.76))
    + line((0.12, 0.24), (1.0, 0.24))
    + rectangle(0.3, 0.32, 0.3, 0.36)
    + arrow((0.66, 0.5), (0.98, 0.5))
)

# Controllers have no symbol in ISO 1219-1: a box with a pictogram.
_CONTROLLER = rectangle(0.0, 0.125, 1.0, 0.75)
# The triangle of an amplifier (IEC 60617).
ELECTRONICS = _CONTROLLER + outline((0.34, 0.28), (0.34, 0.72), (0.72, 0.5))
# The response of a PID controller to a step.
PID = (
    _CONTROLLER
    + line((0.18, 0.76), (0.18, 0.24), (0.84, 0.24))
    + line((0.18, 0.3), (0.3, 0.3), (0.3, 0.76), (0.36, 0.42), (0.8, 0.68))
)
# A pressure gauge.
PRESSURE_CONTROLLER = _CONTROLLER + circle(0.5, 0.5, 0.28) + arrow((0.36, 0.36), (0.66, 0.66))


def _small_muscle(x: float, y: float, width: float, height: float) -> Symbol:
    """Return the crossed fibres of a small muscle; `x` and `y` are the left end of its axis."""
    symbol: Symbol = ()
    for side in (height, -height):
        symbol += line(
            *((x + width * u, y + side * v) for u, v in ((0, 0), (0.15, 0), (0.38, 1), (0.62, -1), (0.85, 0), (1, 0)))
        )
    return symbol


INVERSE_MUSCLE = _CONTROLLER + _small_muscle(0.12, 0.5, 0.76, 0.18)
ANTAGONIST = (
    _CONTROLLER
    + _small_muscle(0.1, 0.68, 0.56, 0.1)
    + _small_muscle(0.1, 0.32, 0.56, 0.1)
    + arc(0.66, 0.5, 0.18, -90.0, 90.0)
    + circle(0.66, 0.5, 0.05)
)
# An open contact (IEC 60617).
SWITCH = _CONTROLLER + line((0.14, 0.42), (0.34, 0.42), (0.68, 0.66)) + line((0.66, 0.42), (0.86, 0.42))
# A block with inputs and outputs.
FMU = (
    _CONTROLLER
    + rectangle(0.36, 0.36, 0.28, 0.28)
    + line((0.18, 0.56), (0.36, 0.56))
    + line((0.18, 0.44), (0.36, 0.44))
    + line((0.64, 0.5), (0.82, 0.5))
)
# An initial step, a transition and a step (IEC 60848).
SEQUENCE = (
    _CONTROLLER
    + rectangle(0.16, 0.36, 0.28, 0.28)
    + rectangle(0.2, 0.4, 0.2, 0.2)
    + line((0.44, 0.5), (0.6, 0.5))
    + line((0.52, 0.38), (0.52, 0.62))
    + rectangle(0.6, 0.36, 0.28, 0.28)
)

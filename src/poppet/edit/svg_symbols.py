"""SVG text of symbols, in modules of ISO 1219-1.

The origin is the centre of the symbol, and the vertical axis points down. One unit of length is one module, 1/8 of the
side of a symbol.
"""

from __future__ import annotations

from itertools import pairwise

from poppet.parts.symbols import Stroke, Symbol

MODULES = 8
"""Modules per side of a symbol."""
Point = tuple[float, float]


def points_in_modules(stroke: Stroke) -> tuple[Point, ...]:
    """Return the corners of a stroke in modules, rounded to 1/1000.

    Examples
    --------
    >>> points_in_modules(Stroke(((0.0, 0.5), (1.0, 0.75))))
    ((-4.0, 0.0), (4.0, -2.0))
    """
    # The sum with 0.0 removes the sign of a zero.
    return tuple((round(MODULES * (x - 0.5), 3) + 0.0, round(MODULES * (0.5 - y), 3) + 0.0) for x, y in stroke.points)


def svg_text(symbol: Symbol) -> str:
    """Return the strokes of a symbol as SVG elements, one path per stroke.

    The classes are `line`, `dashed`, `outline` and `filled`. Colours and widths are those of the style sheet of the
    page.

    Examples
    --------
    >>> svg_text((Stroke(((0.0, 0.5), (1.0, 0.5)), is_dashed=True),))
    '<path class="dashed" d="M-4 0L4 0"/>'
    """
    return "".join(_path(stroke) for stroke in symbol)


def _path(stroke: Stroke) -> str:
    name = "filled" if stroke.is_filled else "outline" if stroke.is_closed else "dashed" if stroke.is_dashed else "line"
    corners = "L".join(f"{x:g} {y:g}" for x, y in points_in_modules(stroke))
    return f'<path class="{name}" d="M{corners}{"Z" if stroke.is_closed else ""}"/>'


def ends_of(*symbols: Symbol) -> tuple[float, float, float, float]:
    """Return the left, top, right and bottom ends of symbols that are drawn at the same position."""
    points = [point for symbol in symbols for stroke in symbol for point in points_in_modules(stroke)]
    across, down = [x for x, _ in points], [y for _, y in points]
    return min(across), min(down), max(across), max(down)


def distance_to(symbol: Symbol, start: Point, direction: Point) -> float | None:
    """Return the distance from a point to the first stroke of a symbol in a horizontal or vertical direction.

    Single lines across the direction are ignored if there are other strokes: pipes cross the lines that mark a
    continuous valve. The result is None if there is no stroke in this direction.
    """
    hits = [(stroke, hit) for stroke in symbol for hit in _distances(stroke, start, direction) if hit >= 0.0]
    kept = [hit for stroke, hit in hits if not _is_across(stroke, direction)]
    return min(kept or [hit for _, hit in hits], default=None)


def _is_across(stroke: Stroke, direction: Point) -> bool:
    (x0, y0), (x1, y1) = stroke.points[0], stroke.points[-1]
    return len(stroke.points) == 2 and (x1 - x0) * direction[0] == (y1 - y0) * direction[1] == 0.0


def _distances(stroke: Stroke, start: Point, direction: Point) -> list[float]:
    """Return the distances from a point to all points in one direction at which it crosses a stroke."""
    (x, y), (dx, dy) = start, direction
    points, distances = points_in_modules(stroke), []
    for a, b in pairwise((*points, points[0]) if stroke.is_closed else points):
        # Coordinates along the direction, and across it.
        along = [(px - x) * dx + (py - y) * dy for px, py in (a, b)]
        across = [(px - x) * dy - (py - y) * dx for px, py in (a, b)]
        if across[0] == across[1] == 0.0:
            distances += along
        elif across[0] * across[1] <= 0.0:
            distances.append(along[0] + across[0] / (across[0] - across[1]) * (along[1] - along[0]))
    return distances

"""Draw a house: floors with their rooms on the left, on the right what each floor uses of those below."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import matplotlib as mpl
from matplotlib.colors import LinearSegmentedColormap, to_rgb
from matplotlib.figure import Figure
from matplotlib.font_manager import FontProperties
from matplotlib.patches import Circle, FancyBboxPatch, Polygon, Rectangle
from matplotlib.textpath import text_to_path

# Inches and points.
BODY, LABEL, MARGIN, ROOF, STEP = 7.6, 1.3, 0.4, 1.1, 0.34
ROWS = 4
LINE, GAP, PAD = 0.235, 0.055, 0.1
NAME, TITLE, TEXT, COUNT = 12.5, 8.0, 7.2, 6.0
INK, GREY, GUIDE, RED = "#22303c", "#66727e", "#d5dae0", "#d1242f"
EARTH_TO_SKY = ("#8c5a2e", "#b58a2a", "#6d8f3a", "#2c8a6c", "#2a7f9f", "#4864a6", "#77589a")
STYLE = {"svg.hashsalt": "house", "svg.fonttype": "path", "font.family": "DejaVu Sans"}
FULL = 450
"""Lines at which a brick is darkest."""

Rgb = tuple[float, float, float]


@dataclass(frozen=True)
class Brick:
    name: str
    lines: int

    @property
    def width(self) -> float:
        return width_of(self.name, TEXT) + 0.13


@dataclass(frozen=True)
class Room:
    """Files of one folder; those that lie on the floor itself have no title."""

    title: str
    note: str
    bricks: Sequence[Brick]

    def rows(self, width: float) -> list[list[Brick]]:
        rows: list[list[Brick]] = [[]]
        for brick in self.bricks:
            if rows[-1] and sum(each.width + GAP for each in rows[-1]) + brick.width > width - 2 * PAD:
                rows.append([])
            rows[-1].append(brick)
        return rows

    def height(self, width: float) -> float:
        return LINE * (len(self.rows(width)) + bool(self.title)) + 1.2 * PAD

    def least_width(self, rows: int) -> float:
        title = width_of(self.title, TITLE, "bold") + PAD + width_of(self.note, COUNT) if self.title else 0.0
        width = max([title, *(brick.width for brick in self.bricks)]) + 2.01 * PAD
        while len(self.rows(width)) > rows:
            width += 0.02
        return width


@dataclass(frozen=True)
class Floor:
    name: str
    summary: str
    note: str
    rooms: Sequence[Room]

    def least_width(self, rows: int) -> float:
        return sum(room.least_width(rows) + PAD for room in self.rooms) + PAD

    def widths(self, body: float) -> list[float]:
        """Rooms side by side, in as few rows of bricks as the floor is wide enough for; what is left over is shared."""
        rows = next(rows for rows in itertools.count(1) if rows >= ROWS or self.least_width(rows) <= body)
        least = [room.least_width(rows) for room in self.rooms]
        return [width * (body - PAD * (len(least) + 1)) / sum(least) for width in least]

    def height(self, body: float) -> float:
        rooms = max((r.height(w) for r, w in zip(self.rooms, self.widths(body), strict=True)), default=0.0)
        return max(rooms + LINE * bool(self.summary) + 2.4 * PAD, 0.66)


@dataclass(frozen=True)
class Roof:
    title: str
    note: str
    door: str


@cache
def width_of(text: str, size: float, weight: str = "normal") -> float:
    font = FontProperties(family=STYLE["font.family"], size=size, weight=weight)
    return float(text_to_path.get_text_width_height_descent(text, font, False)[0]) / 72.0


def light(colour: Rgb, share: float) -> Rgb:
    """So much of a colour on white."""
    red, green, blue = (1.0 - share * (1.0 - part) for part in colour)
    return red, green, blue


def picture(roof: Roof, floors: Sequence[Floor], uses: Mapping[tuple[str, str], int], out: Path) -> None:
    ramp = LinearSegmentedColormap.from_list("house", EARTH_TO_SKY)
    colours = {floor.name: to_rgb(ramp(k / max(len(floors) - 1, 1))) for k, floor in enumerate(floors)}
    body = max([BODY, *(max(f.least_width(ROWS), width_of(f.summary, TEXT) + 4 * PAD) for f in floors)])
    heights = [floor.height(body) for floor in floors]
    bottoms = [0.75 + sum(heights[:k]) for k in range(len(floors))]
    levels = {f.name: y + h / 2 for f, y, h in zip(floors, bottoms, heights, strict=True)}
    top = bottoms[-1] + heights[-1]
    wall = MARGIN + LABEL + body
    size = (wall + 1.0 + STEP * len(floors) + MARGIN, top + ROOF + 0.3)
    with mpl.rc_context(STYLE):
        figure = Figure(figsize=size, facecolor="white")
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0), xlim=(0.0, size[0]), ylim=(0.0, size[1]))
        axes.set_axis_off()
        _roof(axes, roof, top, wall)
        for floor, bottom, height in zip(floors, bottoms, heights, strict=True):
            _floor(axes, floor, (MARGIN, bottom), (LABEL + body, height), colours[floor.name])
        _shafts(axes, levels, colours, uses, wall)
        _words(axes, size, bottoms[0], top, wall, _ups(levels, uses))
        metadata = {"Date": None, "Creator": None} if out.suffix == ".svg" else None
        figure.savefig(out, dpi=150, metadata=metadata)


def _write(axes: Any, x: float, y: float, text: str, size: float, **how: Any) -> None:
    axes.text(x, y, text, **{"fontsize": size, "color": INK, "va": "center_baseline", "zorder": 6} | how)


def _box(axes: Any, x: float, y: float, width: float, height: float, **how: Any) -> None:
    axes.add_patch(FancyBboxPatch((x, y), width, height, boxstyle="round,pad=0,rounding_size=0.045", **how))


def _roof(axes: Any, roof: Roof, eaves: float, wall: float) -> None:
    middle = (MARGIN + wall) / 2
    corners = ((MARGIN - 0.22, eaves), (middle, eaves + ROOF), (wall + 0.22, eaves))
    axes.add_patch(Polygon(corners, facecolor=light(to_rgb(INK), 0.9), edgecolor="none"))
    _write(axes, middle, eaves + 0.62, roof.title, 17, color="white", ha="center", weight="bold")
    _write(axes, middle, eaves + 0.37, roof.note, TITLE, color="white", ha="center")
    # The roof narrows upwards: what is too long for its last line is left to the figures.
    if width_of(roof.door, TEXT) < (wall - MARGIN) * 0.75:
        _write(axes, middle, eaves + 0.16, roof.door, TEXT, color=light(to_rgb(INK), 0.2), ha="center")


def _floor(axes: Any, floor: Floor, corner: tuple[float, float], size: tuple[float, float], colour: Rgb) -> None:
    (left, bottom), (width, height) = corner, size
    axes.add_patch(Rectangle(corner, width, height, facecolor=light(colour, 0.1), edgecolor="none"))
    axes.add_patch(Rectangle(corner, 0.09, height, facecolor=colour, edgecolor="none"))
    axes.plot([left, left + width], [bottom + height] * 2, color="white", linewidth=2.5, zorder=2)
    middle = bottom + height / 2
    _write(axes, left + 0.24, middle + 0.15, floor.name, NAME, color=colour, weight="bold")
    for drop, line in zip((0.06, 0.2), floor.note.split(" · "), strict=True):
        _write(axes, left + 0.24, middle - drop, line, TEXT, color=GREY)
    x, up = left + LABEL + PAD, bottom + height - PAD
    if floor.summary:
        _write(axes, x + PAD, up - 0.1, floor.summary, TEXT, color=GREY, style="italic")
        up -= LINE
    for room, wide in zip(floor.rooms, floor.widths(width - LABEL), strict=True):
        _room(axes, room, (x, bottom + 1.1 * PAD), (wide, up - bottom - 1.1 * PAD), colour)
        x += wide + PAD


def _room(axes: Any, room: Room, corner: tuple[float, float], size: tuple[float, float], colour: Rgb) -> None:
    (left, bottom), (width, height) = corner, size
    y = bottom + height - 0.6 * PAD
    if room.title:
        _box(axes, left, bottom, width, height, facecolor="white", edgecolor=light(colour, 0.55), linewidth=0.7)
        _write(axes, left + PAD, y - LINE / 2, room.title, TITLE, weight="bold", color=colour)
        after = left + 2 * PAD + width_of(room.title, TITLE, "bold")
        _write(axes, after, y - LINE / 2, room.note, COUNT, color=GREY)
        y -= LINE
    for row in room.rows(width):
        x = left + PAD
        for brick in row:
            shade = light(colour, 0.1 + 0.4 * min(brick.lines / FULL, 1.0))
            _box(axes, x, y - LINE + GAP / 2, brick.width, LINE - GAP, facecolor=shade, edgecolor="none", zorder=4)
            _write(axes, x + brick.width / 2, y - LINE / 2, brick.name, TEXT, ha="center")
            x += brick.width + GAP
        y -= LINE


def _ups(levels: Mapping[str, float], uses: Mapping[tuple[str, str], int]) -> int:
    return sum(number for (user, used), number in uses.items() if levels[used] > levels[user])


def _shafts(
    axes: Any, levels: Mapping[str, float], colours: Mapping[str, Rgb], uses: Mapping[tuple[str, str], int], wall: float
) -> None:
    """Each floor has a shaft that ends there, with a bubble wherever it is used; that of the ground is outermost."""
    names = list(levels)
    at = {name: wall + 1.0 + STEP * (len(names) - 1 - k) for k, name in enumerate(names)}
    most = max(uses.values(), default=1)
    for name, x in at.items():
        level = levels[name]
        last = max([x, *(at[used] for user, used in uses if user == name)])
        axes.plot([wall + 0.1, last], [level, level], color=GUIDE, linewidth=0.7, zorder=1)
        users = [levels[user] for user, used in uses if used == name]
        for end, colour in ((max([level, *users]), colours[name]), (min([level, *users]), RED)):
            axes.plot([x, x], [level, end], color=colour, linewidth=1.2, zorder=2, solid_capstyle="butt")
        _landing(axes, name, x, level, colours[name])
    for (user, used), number in sorted(uses.items()):
        colour = RED if levels[used] > levels[user] else colours[used]
        x, y, radius = at[used], levels[user], 0.085 + 0.055 * (number / most) ** 0.5
        axes.add_patch(Circle((x, y), radius, facecolor=colour, edgecolor="white", linewidth=0.8, zorder=5))
        _write(axes, x, y, str(number), COUNT, color="white", ha="center", weight="bold")


def _landing(axes: Any, name: str, x: float, y: float, colour: Rgb) -> None:
    head = ((x - 0.075, y + 0.075), (x + 0.075, y + 0.075), (x, y - 0.06))
    axes.add_patch(Polygon(head, facecolor=colour, edgecolor="white", linewidth=0.8, zorder=5))
    back = {"facecolor": "white", "edgecolor": "none", "pad": 1.5}
    _write(axes, x - 0.13, y, name, TITLE, color=colour, weight="bold", ha="right", bbox=back)


def _words(axes: Any, size: tuple[float, float], ground: float, top: float, wall: float, ups: int) -> None:
    axes.plot([MARGIN - 0.22, size[0] - MARGIN + 0.1], [ground] * 2, color=INK, linewidth=2.0, zorder=5)
    legend = f"A brick is a file (__init__.py is counted, not shown): the darker, the more lines, up to {FULL}."
    _write(axes, MARGIN, ground - 0.3, legend, TEXT, color=GREY)
    right = size[0] - MARGIN + 0.1
    _write(axes, right, top + 0.62, "Which floor uses which", NAME, ha="right", weight="bold")
    _write(axes, right, top + 0.37, "bubbles: imports between files; a line lands on the floor used", TEXT, ha="right")
    verdict = f"{ups} imports run up (red)" if ups else "all run down"
    _write(axes, right, top + 0.16, verdict, TEXT, ha="right", color=RED if ups else GREY)

"""A figure of recordings on its way: what is in it, where it goes, how it is drawn from top to bottom."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from poppet.core.codes import Note
from poppet.core.number_format import pretty, with_unit
from poppet.core.units import convert, same_dimension
from poppet.timeseries.columns import Columns
from poppet.timeseries.plotting.figures import GREY, INK, PALETTE, axes_in, new_figure, widest
from poppet.timeseries.plotting.panels import (
    AFTER_LOADS,
    Panel,
    Series,
    bodies_of,
    chosen_names,
    draw_thinned,
    panels_of,
    shown_series,
    thinned,
)
from poppet.timeseries.plotting.timeline import BANDS, CodeStyle, bands_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

LINE_STYLES: tuple[Any, ...] = (
    *("-", (0, (5, 2)), (0, (1.2, 1.4)), (0, (6, 1.5, 1.2, 1.5)), (0, (9, 2))),
    *((0, (3, 1, 1, 1, 1, 1)), (0, (2, 3)), (0, (8, 2, 2, 2, 2, 2))),
)
COLUMNS = 1400
"""Picture elements across a panel: finer detail is drawn as the range it covers."""

# Sizes in inches, text in points.
_WIDTH, _LEFT, _GAP, _BAND, _ROW, _NOTE_ROW = 10.0, 1.0, 0.16, 0.2, 0.17, 0.15
_LABEL, _TIME_AXIS, _SECOND_AXIS, _NARROWEST, _KEY, _KEY_ROW = 0.54, 0.5, 0.6, 5.5, 0.65, 0.22
_TEXT, _SMALL_TEXT, _NOTE_LENGTH = 8.5, 7.5, 150
_LEGEND: dict[str, Any] = {
    "loc": "upper left",
    "borderpad": 0.0,
    "borderaxespad": 0.0,
    "handletextpad": 0.5,
    "fontsize": _TEXT,
}
_TIME_UNITS = ((1.0, "ms", 1e-3), (1800.0, "s", 1.0), (14400.0, "min", 60.0), (float("inf"), "h", 3600.0))


class Sheet:
    """What goes into one figure; names or patterns of series select, `units` are by name or pattern, or alone."""

    def __init__(
        self,
        recordings: Mapping[str, Columns],
        select: str | Iterable[str] | None,
        units: Mapping[str, str] | Sequence[str] | str | None,
        title: str,
        inner: bool = False,
    ) -> None:
        self.keys, shown = list(recordings), list(recordings.values())
        self.title = title or (shown[0].title if len(shown) == 1 else "")
        names = chosen_names(shown, select)
        self.bands = bands_of(shown, names, COLUMNS)
        coded = {band.name for band in self.bands}
        series = [one for one in shown_series(shown, names, units) if one.name not in coded]
        # What nobody asked for by name and no reader needs first; where there is nothing else, it is shown.
        hidden = set() if inner or names is not None else {n for each in shown for n in each.inner if n in each}
        bodies = bodies_of(shown)
        if bodies and not inner and names is None:
            hidden |= {one.name for one in series if any(same_dimension(one.unit, unit) for unit in AFTER_LOADS)}
        self.bands = [band for band in self.bands if band.name not in hidden]
        hidden = hidden if self.bands or any(one.name not in hidden for one in series) else set()
        self.inner = sorted(hidden)
        series = [one for one in series if one.name not in hidden]
        self.panels, self.left_out = panels_of(series, keep_still=names is not None, bodies=bodies)
        homes = home_colours(self.panels)
        self.colours = [panel_colours(panel, homes) for panel in self.panels]
        self.is_air = not any(note.address == "gas" for one in shown for note in one.remarks)
        start, end = min(float(one.time[0]) for one in shown), max(float(one.time[-1]) for one in shown)
        self.time_name, self.time_size = time_unit(end - start)
        self.limits = start / self.time_size, end / self.time_size

    def draw(self) -> Figure:
        """Make the figure."""
        heights = [self._height(panel) for panel in self.panels] + [_BAND * len(self.bands)] * bool(self.bands)
        notes, keys = self._notes(), self._keys()
        margin = self._margin()
        self.across = max(_WIDTH, _LEFT + _NARROWEST + margin)
        self.width = self.across - _LEFT - margin
        rows = self._recording_rows()
        head = 0.16 + 0.3 * bool(self.title) + _KEY_ROW * len(rows)
        foot = _TIME_AXIS + _KEY_ROW * len(keys) + _NOTE_ROW * len(notes) + 0.06
        self.figure = new_figure(self.across, head + sum(heights) + _GAP * (len(heights) - 1) + foot)
        self._head(rows)
        axes: Any = None
        top = head
        for place, height in enumerate(heights):
            if axes is not None:
                axes.tick_params(labelbottom=False)
            axes = axes_in(self.figure, _LEFT, top, self.width, height, sharex=axes)
            if place < len(self.panels):
                self._panel(axes, place)
            else:
                self._timeline(axes)
            top += height + _GAP
        if self.limits[0] < self.limits[1]:  # a single sample has no span, and matplotlib would warn
            axes.set_xlim(*self.limits)
        axes.set_xlabel(f"time [{self.time_name}]")
        self._foot(top - _GAP + _TIME_AXIS, keys, notes)
        return self.figure

    @property
    def _is_overlay(self) -> bool:
        return len(self.keys) > 1

    # Sizes --------------------------------------------------------------------------------------------------

    def _height(self, panel: Panel) -> float:
        usual = 1.6 if len(self.panels) <= 4 else 1.25
        return max(usual, _ROW * len(panel.names) + 0.1)

    def _margin(self) -> float:
        """Room on the right: the second axis of flows and the longest label."""
        labels = [label for panel in self.panels for label in panel.labels.values()]
        return self._legend_gap() + 0.45 + widest(labels + self._band_labels(), _TEXT)

    def _legend_gap(self) -> float:
        return 0.12 + _SECOND_AXIS * any(self._has_second_axis(panel) for panel in self.panels)

    def _has_second_axis(self, panel: Panel) -> bool:
        return self.is_air and same_dimension(panel.unit, "kg/s") and "ANR" not in panel.unit

    # Head and foot ------------------------------------------------------------------------------------------

    def _recording_rows(self) -> list[list[int]]:
        """Recordings of an overlay, as many in a line as there is room for."""
        rows: list[list[int]] = []
        left = 0.0
        for source, key in enumerate(self.keys if self._is_overlay else []):
            wide = _KEY + widest([key], _TEXT)
            if not rows or left < wide:
                rows.append([])
                left = self.across - _LEFT
            rows[-1].append(source)
            left -= wide
        return rows

    def _head(self, rows: Sequence[Sequence[int]]) -> None:
        from matplotlib.lines import Line2D

        top, up = 0.12, self.figure.get_size_inches()[1]
        if self.title:
            look: dict[str, Any] = {"fontsize": 11, "fontweight": "bold", "va": "top", "parse_math": False}
            title = textwrap.shorten(self.title, 100, placeholder=" ...")
            self.figure.text(_LEFT / self.across, 1.0 - top / up, title, **look)
            top += 0.28
        for row in rows:
            lines = [Line2D([], [], color=INK, linestyle=LINE_STYLES[source]) for source in row]
            self._row(lines, [self.keys[source] for source in row], 1.0 - top / up, handlelength=3.2)
            top += _KEY_ROW

    def _row(self, handles: Sequence[Any], texts: Sequence[str], up: float, handlelength: float) -> None:
        """A legend in one line under or over the axes."""
        place = {"bbox_to_anchor": (_LEFT / self.across, up), "handlelength": handlelength}
        _legend(self.figure, handles, texts, **place, ncols=len(texts), columnspacing=1.4)

    def _foot(self, top: float, keys: Sequence[Sequence[CodeStyle]], notes: Sequence[str]) -> None:
        from matplotlib.patches import Patch

        up = self.figure.get_size_inches()[1]
        for looks in keys:
            patches = [Patch(**_fill(look)) for look in looks]
            self._row(patches, [look.text for look in looks], 1.0 - top / up, handlelength=1.6)
            top += _KEY_ROW
        for note in notes:
            place = {"x": _LEFT / self.across, "y": 1.0 - top / up, "va": "top"}
            self.figure.text(**place, s=note, fontsize=_SMALL_TEXT, color=GREY, parse_math=False)
            top += _NOTE_ROW

    def _keys(self) -> list[list[CodeStyle]]:
        """What the colours of the timeline mean, in a row for each kind."""
        rows = []
        for _, looks in BANDS:
            used = {span.code for band in self.bands if band.looks is looks for span in band.spans}
            rows.append([look for code, look in looks.items() if code in used])
        return [row for row in rows if row]

    def _notes(self) -> list[str]:
        notes = []
        if self.left_out:
            values = {one.name: with_unit(f"{one.values[0]:z.6g}", one.unit) for one in self.left_out}
            notes.append(str(Note("drawing.left_out", values=values)))
        if self.inner:
            notes.append(str(Note("drawing.inner", count=len(self.inner), first=self.inner[:2])))
        if any(band.is_thinned for band in self.bands):
            notes.append(str(Note("drawing.thinned")))
        return [line for note in notes for line in textwrap.wrap(note, _NOTE_LENGTH)]

    # Panels -------------------------------------------------------------------------------------------------

    def _panel(self, axes: Any, place: int) -> None:
        from matplotlib.lines import Line2D

        panel, colours = self.panels[place], self.colours[place]
        for one in panel.series:
            label = panel.labels[one.name]
            self._line(
                axes, one, colours[one.name], f"{label} ({self.keys[one.source]})" if self._is_overlay else label
            )
        axes.set_ylabel(f"{panel.quantity}\n{axis_unit(panel)}", linespacing=1.3, parse_math=False)
        axes.yaxis.set_label_coords(-_LABEL / self.width, 0.5)
        axes.margins(y=0.06)
        # Fewer ticks in a low panel, where their numbers would touch.
        axes.locator_params(axis="y", nbins=5 if axes.bbox.height < 250 else 8)
        handles = [Line2D([], [], color=colours[name], linewidth=2.0) for name in panel.names]
        corner = (1.0 + self._legend_gap() / self.width, 1.0)
        texts = [panel.labels[name] for name in panel.names]
        _legend(axes, handles, texts, bbox_to_anchor=corner, handlelength=1.1, labelspacing=0.32)
        if self._has_second_axis(panel):
            factor = convert(1.0, panel.unit, "l/min ANR")
            second = axes.secondary_yaxis("right", functions=(lambda q: q * factor, lambda q: q / factor))
            second.set_ylabel("l/min ANR")

    def _line(self, axes: Any, one: Series, colour: str, label: str) -> None:
        kept = thinned(one.time, one.values, COLUMNS)
        draw_thinned(
            axes,
            one.time / self.time_size,
            one.values,
            kept,
            color=colour,
            label=label,
            # Thinner where a line shows the range of its samples, which would fill up else.
            linewidth=1.4 if len(kept) == len(one.time) else 1.0,
            linestyle=LINE_STYLES[one.source],
            drawstyle="steps-post" if one.is_staircase else "default",
            marker="o" if len(one.time) == 1 else None,
            markersize=4,
        )

    # Timeline -----------------------------------------------------------------------------------------------

    def _band_labels(self) -> list[str]:
        return [f"{band.label} ({self.keys[band.source]})" if self._is_overlay else band.label for band in self.bands]

    def _timeline(self, axes: Any) -> None:
        for row, (band, label) in enumerate(zip(self.bands, self._band_labels(), strict=True)):
            for code, look in band.looks.items():
                spans = [each for each in band.spans if each.code == code]
                times = [(each.start / self.time_size, each.width / self.time_size) for each in spans]
                if times:
                    axes.broken_barh(times, (row - 0.36, 0.72), label=look.text, **_fill(look))
            right = 1.0 + self._legend_gap() / self.width
            place = {"x": right, "y": row, "transform": axes.get_yaxis_transform()}
            axes.text(**place, s=label, va="center", fontsize=_TEXT, parse_math=False)
        axes.set_ylim(len(self.bands) - 0.5, -0.5)
        axes.set_yticks([])
        axes.grid(visible=False)
        axes.spines["left"].set_visible(False)
        for text, looks in BANDS:
            rows = [row for row, band in enumerate(self.bands) if band.looks is looks]
            if rows:
                text = text if len(rows) > 1 else text.replace("\n", " ")
                place = {"x": -0.1 / self.width, "y": sum(rows) / len(rows), "transform": axes.get_yaxis_transform()}
                axes.text(**place, s=text, ha="right", va="center")


def home_colours(panels: Sequence[Panel]) -> dict[str, str]:
    """A colour for each part: it keeps it from panel to panel, and parts of one panel differ."""
    together = [dict.fromkeys(name.partition(".")[0] for name in panel.names) for panel in panels]
    homes: dict[str, str] = {}
    for part in dict.fromkeys(part for parts in together for part in parts):
        taken = {homes.get(other) for parts in together if part in parts for other in parts}
        free = (colour for colour in PALETTE if colour not in taken)
        homes[part] = next(free, PALETTE[len(homes) % len(PALETTE)])
    return homes


def panel_colours(panel: Panel, homes: Mapping[str, str]) -> dict[str, str]:
    """Colours of the series of a panel: its part's own for the first of a part, a free one for any other."""
    colours: dict[str, str] = {}
    others = []
    for name in panel.names:
        home = homes[name.partition(".")[0]]
        if home in colours.values():
            others.append(name)
        else:
            colours[name] = home
    free = [colour for colour in PALETTE if colour not in colours.values()] or list(PALETTE)
    return colours | {name: free[k % len(free)] for k, name in enumerate(others)}


def _legend(owner: Any, handles: Sequence[Any], texts: Sequence[str], **options: Any) -> None:
    for text in owner.legend(handles, texts, **_LEGEND, **options).get_texts():
        text.set_parse_math(False)  # a name may hold dollars


def _fill(look: CodeStyle) -> dict[str, Any]:
    """How a patch of the timeline is drawn."""
    if look.is_hatched:
        return {"facecolor": look.colour, "edgecolor": "white", "linewidth": 0.0, "hatch": "////"}
    return {"facecolor": look.colour, "edgecolor": "none", "linewidth": 0.0}


def time_unit(span: float) -> tuple[str, float]:
    """Unit in which a time axis so long [s] is read, and its size [s]."""
    return next((name, size) for longest, name, size in _TIME_UNITS if span < longest)


def axis_unit(panel: Panel) -> str:
    """Unit of an axis in brackets, with the reference of pressures."""
    if panel.unit in ("1", ""):
        return "[1]"
    is_pressure = panel.quantity == "pressure" and not panel.unit.endswith("g")
    return f"[{panel.unit}, absolute]" if is_pressure else f"[{pretty(panel.unit)}]"

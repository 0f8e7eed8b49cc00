"""Figures of recordings: panels by quantity over one time axis, and a timeline of flow regimes."""

from __future__ import annotations

import textwrap
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, OutOfRangeError
from poppet.core.number_format import pretty, with_unit
from poppet.core.units import convert, same_dimension
from poppet.timeseries.columns import Columns
from poppet.timeseries.plotting.figures import (
    ACCENT,
    GREY,
    INK,
    PALETTE,
    axes_in,
    check_format,
    new_figure,
    save_figure,
    style,
    widest,
)
from poppet.timeseries.plotting.panels import (
    AFTER_LOADS,
    BANDS,
    CodeStyle,
    Panel,
    Series,
    bands_of,
    bodies_of,
    chosen_names,
    draw_thinned,
    panels_of,
    shown_series,
    thinned,
)
from poppet.timeseries.plotting.tube_bands import band_outputs, with_bands

if TYPE_CHECKING:
    from matplotlib.figure import Figure


MOST_RECORDINGS = 8  # number of distinguishable line styles


def plot_recordings(
    recordings: Mapping[str, Columns], path: str | Path | None = None, *, select: str | Iterable[str] | None = None,
    units: Mapping[str, str] | Sequence[str] | str | None = None, title: str = "", inner: bool = False,
) -> Figure:  # fmt: skip
    """Draw recordings over a common time axis.

    There is one panel for each quantity, and a timeline for flow regimes and other codes.

    Notes
    -----
    Staircase series are drawn as steps, all others with straight lines. If there are more samples than pixels, each
    pixel column shows the range of its samples, so no peak is lost. The figure omits constant series and names them
    below, unless they are selected. It also omits internal outputs, unless the keyword `inner` is True.

    With moving bodies, the order is positions, velocities, pressures, forces. The timeline then shows sticking and
    slipping, and temperatures, heat flows and masses are omitted in the same way as internal outputs.
    The cells of a tube are one band from minimum to maximum, unless they are selected or `inner` is True.
    Mass flows of air have a second axis in l/min ANR.

    Examples
    --------
    >>> rec = Columns.from_series([0.0, 1.0, 2.0], {"tank.pressure [Pa]": [1e5, 2e5, 3e5]})
    >>> figure = plot_recordings({"fill": rec})
    >>> figure.axes[0].get_ylabel()
    'pressure\\n[bar, absolute]'
    """
    if path is not None:
        check_format(path)
    if not recordings:
        raise InputError("drawing.nothing")
    for name, recording in recordings.items():
        if not recording.time.size or not len(recording):
            raise InputError("drawing.no_samples", name=name)
    if len(recordings) > MOST_RECORDINGS:
        raise OutOfRangeError("drawing.too_many", count=len(recordings), most=MOST_RECORDINGS)
    with style("A figure"):
        return save_figure(Sheet(recordings, select, units, title, inner).draw(), path)


LINE_STYLES: tuple[Any, ...] = (
    *("-", (0, (5, 2)), (0, (1.2, 1.4)), (0, (6, 1.5, 1.2, 1.5)), (0, (9, 2))),
    *((0, (3, 1, 1, 1, 1, 1)), (0, (2, 3)), (0, (8, 2, 2, 2, 2, 2))),
)
COLUMNS = 1400  # pixel columns of a panel; each column shows the range of its samples

# Sizes in inches, text in points.
_WIDTH, _LEFT, _GAP, _BAND, _ROW, _NOTE_ROW = 10.0, 1.0, 0.16, 0.2, 0.17, 0.15
_LABEL, _TIME_AXIS, _SECOND_AXIS, _NARROWEST, _KEY, _KEY_ROW = 0.54, 0.5, 0.6, 5.5, 0.65, 0.22
_TEXT, _SMALL_TEXT, _NOTE_LENGTH = 8.5, 7.5, 150
_LEGEND: dict[str, Any] = {
    "loc": "upper left", "borderpad": 0.0, "borderaxespad": 0.0, "handletextpad": 0.5, "fontsize": _TEXT,
}  # fmt: skip
_TIME_UNITS = ((1.0, "ms", 1e-3), (1800.0, "s", 1.0), (14400.0, "min", 60.0), (float("inf"), "h", 3600.0))


class Sheet:
    """Figure of one or several recordings: its content and its layout.

    `select` contains names or patterns of the series to draw. `units` maps names or patterns to units, or is a list
    of units, each for all series of its quantity. If `inner` is True, internal outputs are drawn as well.
    """

    def __init__(
        self, recordings: Mapping[str, Columns], select: str | Iterable[str] | None,
        units: Mapping[str, str] | Sequence[str] | str | None, title: str, inner: bool = False,
    ) -> None:  # fmt: skip
        self.keys, items = list(recordings), list(recordings.values())
        self.title = title or (items[0].title if len(items) == 1 else "")
        names = chosen_names(items, select)
        self.bands = bands_of(items, names, COLUMNS)
        coded = {band.name for band in self.bands}
        series = [item for item in shown_series(items, names, units) if item.name not in coded]
        # Internal outputs are hidden unless they are selected or nothing else remains.
        is_complete = inner or names is not None
        hidden = {n for recording in items for n in recording.inner if n in recording and not is_complete}
        bodies = bodies_of(items)
        if bodies and not is_complete:
            hidden |= {item.name for item in series if any(same_dimension(item.unit, unit) for unit in AFTER_LOADS)}
        self.bands = [band for band in self.bands if band.name not in hidden]
        hidden = hidden if self.bands or any(item.name not in hidden for item in series) else set()
        self.inner = sorted(hidden)
        series = [item for item in series if item.name not in hidden]
        # The cells of a tube are one band, unless the user wants all series.
        self.cells = {} if is_complete else band_outputs(item.name for item in series)
        self.tubes = [*dict.fromkeys(name.rpartition(".")[0] for name in self.cells)]
        series = with_bands(series) if self.tubes else series
        self.panels, self.left_out = panels_of(series, keep_still=names is not None, bodies=bodies)
        homes = home_colours(self.panels)
        self.colours = [panel_colours(panel, homes) for panel in self.panels]
        self.is_air = not any(note.address == "gas" for item in items for note in item.remarks)
        start, end = min(float(item.time[0]) for item in items), max(float(item.time[-1]) for item in items)
        self.time_name, self.time_size = time_unit(end - start)
        self.limits = start / self.time_size, end / self.time_size

    def draw(self) -> Figure:
        """Draw all panels, the timeline and the legends, and return the figure."""
        from matplotlib.patches import Patch

        usual = 1.6 if len(self.panels) <= 4 else 1.25
        heights = [max(usual, _ROW * len(panel.names) + 0.1) for panel in self.panels]
        heights += [_BAND * len(self.bands)] * bool(self.bands)
        notes, keys = self._notes(), []  # keys: the colours of the timeline, one row per kind
        for _, styles in BANDS:
            codes = {span.code for band in self.bands if band.looks is styles for span in band.spans}
            keys += [[style for code, style in styles.items() if code in codes]] * bool(codes & styles.keys())
        # The right margin contains the second axis of flows and the longest label.
        labels = [label for panel in self.panels for label in panel.labels.values()]
        margin = self._legend_gap() + 0.45 + widest(labels + self._band_labels(), _TEXT)
        self.across = max(_WIDTH, _LEFT + _NARROWEST + margin)
        self.width = self.across - _LEFT - margin
        rows: list[list[int]] = []  # the recordings of an overlay, in rows that fit the width
        free_width = 0.0
        for source, key in enumerate(self.keys if self._is_overlay else []):
            width = _KEY + widest([key], _TEXT)
            if not rows or free_width < width:
                rows.append([])
                free_width = self.across - _LEFT
            rows[-1].append(source)
            free_width -= width
        head = 0.16 + 0.3 * bool(self.title) + _KEY_ROW * len(rows)
        foot = _TIME_AXIS + _KEY_ROW * len(keys) + _NOTE_ROW * len(notes) + 0.06
        self.figure = new_figure(self.across, head + sum(heights) + _GAP * (len(heights) - 1) + foot)
        self._head(rows)
        axes: Any = None
        top = head
        for index, height in enumerate(heights):
            if axes is not None:
                axes.tick_params(labelbottom=False)
            axes = axes_in(self.figure, _LEFT, top, self.width, height, sharex=axes)
            if index < len(self.panels):
                self._panel(axes, index)
            else:
                self._timeline(axes)
            top += height + _GAP
        if self.limits[0] < self.limits[1]:  # a single sample has no span, for which Matplotlib warns
            axes.set_xlim(*self.limits)
        axes.set_xlabel(f"time [{self.time_name}]")
        top = top - _GAP + _TIME_AXIS
        page_height = self.figure.get_size_inches()[1]
        for row in keys:
            patches = [Patch(**_fill_options(style)) for style in row]
            self._row(patches, [style.text for style in row], 1.0 - top / page_height, handlelength=1.6)
            top += _KEY_ROW
        for note in notes:
            options = {"x": _LEFT / self.across, "y": 1.0 - top / page_height, "va": "top"}
            self.figure.text(**options, s=note, fontsize=_SMALL_TEXT, color=GREY, parse_math=False)
            top += _NOTE_ROW
        return self.figure

    @property
    def _is_overlay(self) -> bool:
        return len(self.keys) > 1

    # Sizes --------------------------------------------------------------------------------------------------

    def _legend_gap(self) -> float:
        return 0.12 + _SECOND_AXIS * any(self._has_second_axis(panel) for panel in self.panels)

    def _has_second_axis(self, panel: Panel) -> bool:
        return self.is_air and same_dimension(panel.unit, "kg/s") and "ANR" not in panel.unit

    # Head and foot ------------------------------------------------------------------------------------------

    def _head(self, rows: Sequence[Sequence[int]]) -> None:
        from matplotlib.lines import Line2D

        top, height = 0.12, self.figure.get_size_inches()[1]
        if self.title:
            options: dict[str, Any] = {"fontsize": 11, "fontweight": "bold", "va": "top", "parse_math": False}
            title = textwrap.shorten(self.title, 100, placeholder=" ...")
            self.figure.text(_LEFT / self.across, 1.0 - top / height, title, **options)
            top += 0.28
        for row in rows:
            lines = [Line2D([], [], color=INK, linestyle=LINE_STYLES[source]) for source in row]
            self._row(lines, [self.keys[source] for source in row], 1.0 - top / height, handlelength=3.2)
            top += _KEY_ROW

    def _row(self, handles: Sequence[Any], texts: Sequence[str], y: float, handlelength: float) -> None:
        """Draw a legend outside the axes, with all entries in one row.

        `y` is its height as a fraction of the figure height. `handles` are the drawn symbols, `texts` their labels, and
        `handlelength` is the length of a symbol in multiples of the font size.
        """
        options = {"bbox_to_anchor": (_LEFT / self.across, y), "handlelength": handlelength}
        _legend(self.figure, handles, texts, **options, ncols=len(texts), columnspacing=1.4)

    def _notes(self) -> list[str]:
        notes = []
        if self.left_out:
            values = {series.name: with_unit(f"{series.values[0]:z.6g}", series.unit) for series in self.left_out}
            notes.append(str(Note("drawing.left_out", values=values)))
        if self.inner:
            notes.append(str(Note("drawing.inner", count=len(self.inner), first=self.inner[:2])))
        if self.tubes:
            notes.append(str(Note("drawing.cells", tubes=self.tubes)))
        if any(band.is_thinned for band in self.bands):
            notes.append(str(Note("drawing.thinned")))
        return [line for note in notes for line in textwrap.wrap(note, _NOTE_LENGTH)]

    # Panels -------------------------------------------------------------------------------------------------

    def _panel(self, axes: Any, index: int) -> None:
        from matplotlib.lines import Line2D

        panel, colours = self.panels[index], self.colours[index]
        for series in panel.series:
            label = panel.labels[series.name]
            label = f"{label} ({self.keys[series.source]})" if self._is_overlay else label
            draw = self._line if series.high is None else self._cells
            draw(axes, series, colours[series.name], label)
        axes.set_ylabel(f"{panel.quantity}\n{axis_unit(panel)}", linespacing=1.3, parse_math=False)
        axes.yaxis.set_label_coords(-_LABEL / self.width, 0.5)
        axes.margins(y=0.06)
        # Low panels have fewer ticks, so that the labels do not overlap.
        axes.locator_params(axis="y", nbins=5 if axes.bbox.height < 250 else 8)
        handles = [Line2D([], [], color=colours[name], linewidth=2.0) for name in panel.names]
        corner = (1.0 + self._legend_gap() / self.width, 1.0)
        texts = [panel.labels[name] for name in panel.names]
        _legend(axes, handles, texts, bbox_to_anchor=corner, handlelength=1.1, labelspacing=0.32)
        if self._has_second_axis(panel):
            factor = convert(1.0, panel.unit, "l/min ANR")
            second = axes.secondary_yaxis("right", functions=(lambda q: q * factor, lambda q: q / factor))
            second.set_ylabel("l/min ANR")

    def _line(self, axes: Any, series: Series, colour: str, label: str) -> None:
        indices = thinned(series.time, series.values, COLUMNS)
        draw_thinned(
            axes,
            series.time / self.time_size,
            series.values,
            indices,
            color=colour,
            label=label,
            # A thinner line if it shows ranges of samples, which would otherwise fill the area.
            linewidth=1.4 if len(indices) == len(series.time) else 1.0,
            linestyle=LINE_STYLES[series.source],
            drawstyle="steps-post" if series.is_staircase else "default",
            marker="o" if len(series.time) == 1 else None,
            markersize=4,
        )

    def _cells(self, axes: Any, series: Series, colour: str, label: str) -> None:
        """Draw the band of the cells of a tube, with thin lines at its edges."""
        assert series.high is not None
        time = series.time / self.time_size
        edges = [(values, thinned(series.time, values, COLUMNS)) for values in (series.values, series.high)]
        rows = np.unique(np.concatenate([indices for _, indices in edges]))
        area = time[rows], series.values[rows], series.high[rows]
        axes.fill_between(*area, color=colour, alpha=0.28, linewidth=0.0, label=label)
        # The edges have the label of the area, so that a page hides both.
        options = {"color": colour, "label": label, "linewidth": 0.8, "linestyle": LINE_STYLES[series.source]}
        for values, indices in edges:
            draw_thinned(axes, time, values, indices, **options)

    # Timeline -----------------------------------------------------------------------------------------------

    def _band_labels(self) -> list[str]:
        return [f"{band.label} ({self.keys[band.source]})" if self._is_overlay else band.label for band in self.bands]

    def _timeline(self, axes: Any) -> None:
        for row, (band, label) in enumerate(zip(self.bands, self._band_labels(), strict=True)):
            for code, code_style in band.looks.items():
                spans = [span for span in band.spans if span.code == code]
                times = [(span.start / self.time_size, span.width / self.time_size) for span in spans]
                if times:
                    axes.broken_barh(times, (row - 0.36, 0.72), label=code_style.text, **_fill_options(code_style))
            right = 1.0 + self._legend_gap() / self.width
            options = {"x": right, "y": row, "transform": axes.get_yaxis_transform()}
            axes.text(**options, s=label, va="center", fontsize=_TEXT, parse_math=False)
        axes.set_ylim(len(self.bands) - 0.5, -0.5)
        axes.set_yticks([])
        axes.grid(visible=False)
        axes.spines["left"].set_visible(False)
        for text, styles in BANDS:
            rows = [row for row, band in enumerate(self.bands) if band.looks is styles]
            if rows:
                text = text if len(rows) > 1 else text.replace("\n", " ")
                options = {"x": -0.1 / self.width, "y": sum(rows) / len(rows), "transform": axes.get_yaxis_transform()}
                axes.text(**options, s=text, ha="right", va="center")


def home_colours(panels: Sequence[Panel]) -> dict[str, str]:
    """Assign a colour to each part of the circuit, and return the colours by part.

    A part has the same colour in all panels, and the parts of one panel have different colours.
    """
    together = [dict.fromkeys(name.partition(".")[0] for name in panel.names) for panel in panels]
    homes: dict[str, str] = {}
    for part in dict.fromkeys(part for parts in together for part in parts):
        neighbour_colours = {homes.get(neighbour) for parts in together if part in parts for neighbour in parts}
        free = (colour for colour in PALETTE if colour not in neighbour_colours)
        homes[part] = next(free, PALETTE[len(homes) % len(PALETTE)])
    return homes


def panel_colours(panel: Panel, homes: Mapping[str, str]) -> dict[str, str]:
    """Return the colour of each series in a panel.

    `homes` contains the colour of each part of the circuit. The first series of a part has this colour, and its other
    series have unused colours.
    """
    colours: dict[str, str] = {}
    remaining = []
    for name in panel.names:
        colour = homes[name.partition(".")[0]]
        if colour in colours.values():
            remaining.append(name)
        else:
            colours[name] = colour
    free = [colour for colour in PALETTE if colour not in colours.values()] or list(PALETTE)
    return colours | {name: free[k % len(free)] for k, name in enumerate(remaining)}


def _legend(owner: Any, handles: Sequence[Any], texts: Sequence[str], **options: Any) -> None:
    for text in owner.legend(handles, texts, **_LEGEND, **options).get_texts():
        text.set_parse_math(False)  # a name can contain dollar signs


def _fill_options(style: CodeStyle) -> dict[str, Any]:
    """Return the Matplotlib options of the coloured area for a state code, such as a flow regime."""
    if style.is_hatched:
        return {"facecolor": style.colour, "edgecolor": "white", "linewidth": 0.0, "hatch": "////"}
    return {"facecolor": style.colour, "edgecolor": "none", "linewidth": 0.0}


def time_unit(span: float) -> tuple[str, float]:
    """Return the unit of a time axis, and the length of this unit in seconds.

    `span` is the length of the time axis [s].
    """
    return next((name, size) for longest, name, size in _TIME_UNITS if span < longest)


def axis_unit(panel: Panel) -> str:
    """Return the text of an axis label for the unit of a panel, in brackets.

    For absolute pressures, the text includes the word "absolute".
    """
    if panel.unit in ("1", ""):
        return "[1]"
    is_pressure = panel.quantity == "pressure" and not panel.unit.endswith("g")
    return f"[{panel.unit}, absolute]" if is_pressure else f"[{pretty(panel.unit)}]"


WIDTH, HEIGHT = 7.0, 2.2  # width of the figure and height of a panel [in]


def plot_fitted_series(
    tables: Mapping[str, Mapping[str, Any]], path: str | Path | None = None, *, title: str = ""
) -> Figure:
    """Draw measured and fitted series.

    Each table has a panel of its own. It contains `measured` and `model` over `time` or `x`. The optional columns `low`
    and `high` are the limits of a band around the model.

    Examples
    --------
    >>> table = {"time": [0.0, 1.0], "measured": [1.0, 2.1], "model": [1.0, 2.0], "unit": "Pa"}
    >>> plot_fitted_series({"test.tank.pressure": table}).axes[0].get_ylabel()
    'Pa'
    """
    if not tables:
        raise InputError("drawing.nothing")
    with style("A figure", path):
        figure = new_figure(WIDTH, HEIGHT * len(tables) + 0.4)
        panels = figure.subplots(len(tables), squeeze=False)[:, 0]
        for panel, (name, table) in zip(panels, tables.items(), strict=True):
            x = table["time"] if "time" in table else table["x"]
            panel.plot(x, table["measured"], ".", color=GREY, markersize=3.0, label="measured")
            if "low" in table:
                panel.fill_between(x, table["low"], table["high"], color=ACCENT, alpha=0.25, linewidth=0.0)
            panel.plot(x, table["model"], color=ACCENT, label="model")
            panel.set_title(name, loc="left")
            panel.set_ylabel(table["unit"])
        panels[0].legend(loc="best")
        # All tables of a result have the same axis.
        label = "time [s]" if "time" in table else f"{table.get('x_name', 'x')} [{table.get('x_unit', '1')}]"
        panels[-1].set_xlabel(label)
        figure.suptitle(title)
        figure.set_layout_engine("tight")
        return save_figure(figure, path)

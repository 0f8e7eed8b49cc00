"""Interactive plots: data of Matplotlib figures, and the scripts and style sheets that a page contains completely."""

from __future__ import annotations

import base64
import hashlib
import json
import math
import re
from collections.abc import Sequence
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.report.styles import stylesheet
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.plotting.panels import thinned, whole_of

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MARK = 'class="plot-data"'
"""Attribute of the data elements of plots."""
# uPlot needs a valid language; browsers without a locale report an invalid one.
_LOCALE = (
    'try{new Intl.NumberFormat(navigator.language)}catch{Object.defineProperty(navigator,"language",{value:"en-US"})}'
)
MAX_POINTS = 4000
"""Maximum number of points of a line in a page; longer lines are reduced to extremes."""
DIGITS = 5
"""Number of decimal digits of a column, relative to the range of its values."""
_NO_MARKER = ("None", "none", "", " ", None)
_ALIGN = {"left": "left", "center": "center", "right": "right"}
_BASELINE = {"top": "top", "center": "middle", "bottom": "bottom", "baseline": "alphabetic"}


def plot_data(figure: Figure) -> dict[str, Any] | None:
    """Return the data of a figure for an interactive plot.

    The result is None for figures without curves, such as maps and drawings.

    Examples
    --------
    >>> from poppet.timeseries.plotting.figures import axes_in, new_figure, style
    >>> with style("An example"):
    ...     figure = new_figure(4.0, 3.0)
    ...     _ = axes_in(figure, 0.5, 0.5, 3.0, 2.0).plot([0.0, 1.0, 2.0, 3.0], [5.0, 7.0, 7.0, 5.0], label="a")
    >>> data = plot_data(figure)
    >>> data["columns"]
    [{'from': 0.0, 'step': 1.0, 'count': 4}, [5.0, 7.0, 7.0, 5.0]]
    """
    from matplotlib.collections import LineCollection, PolyCollection

    for axes in figure.axes:
        # Maps, drawings and unknown scales cannot become interactive.
        has_known_artists = all(isinstance(artist, LineCollection | PolyCollection) for artist in axes.collections)
        has_known_scales = {axes.get_xscale(), axes.get_yscale()} <= {"linear", "log"}
        if not (axes.axison and has_known_artists and has_known_scales) or axes.images:
            return None
    if not figure.axes:
        return None
    columns, width = _DataColumns(), float(figure.get_size_inches()[0])
    lefts = sorted({round(_axes_position(figure, axes)[0], 3) for axes in figure.axes})
    edges = [0.0, *(left - lefts[0] for left in lefts[1:]), width]
    panels = []
    # Reading order: from top to bottom, from left to right.
    for axes in sorted(figure.axes, key=lambda panel: [round(v, 2) for v in _axes_position(figure, panel)[1::-1]]):
        box = _axes_position(figure, axes)
        column = lefts.index(round(box[0], 3))
        # A panel across several columns has the full width.
        free = not any(left > box[0] and left < box[0] + box[2] for left in lefts)
        share = (edges[column + 1] - edges[column]) / width if free and len(lefts) > 1 else 1.0
        panels.append(_panel(axes, columns) | {"box": [round(v, 3) for v in box], "share": round(share, 4)})
    notes = " ".join(text.get_text() for text in figure.texts if text.get_fontweight() != "bold")
    return {"columns": columns.series, "panels": panels, "notes": [" ".join(notes.split())] * bool(notes.strip())}


def _axes_position(figure: Figure, axes: Any) -> list[float]:
    """Return the position of axes in a figure [in]: left, top, width and height."""
    width, height = figure.get_size_inches()
    box = axes.get_position()
    return [float(v) for v in (box.x0 * width, (1.0 - box.y1) * height, box.width * width, box.height * height)]


class _DataColumns:
    """Collection of different columns of numbers.

    The plots of a page refer to the columns by their indices.
    """

    def __init__(self) -> None:
        self.series: list[Any] = []
        self._indices: dict[bytes, int] = {}

    def add(self, values: FloatArray, *, is_log: bool = False) -> int:
        """Add a column of numbers if it is new, and return its index.

        Equidistant numbers are stored as first value, step and count. Other numbers are rounded to the digits that an
        enlarged plot can show. NaN becomes None.
        """
        key = values.tobytes() + bytes([is_log])
        if key in self._indices:
            return self._indices[key]
        finite = values[np.isfinite(values)]
        size = float(np.ptp(finite)) if finite.size else 0.0
        is_even = finite.size == values.size >= 4 and bool(values[-1] > values[0])
        if is_even:
            even = np.linspace(values[0], values[-1], values.size)
            is_even = bool(np.max(np.abs(values - even)) <= 1e-9 * (values[-1] - values[0]))
        column: Any
        if is_even:
            step = float(values[-1] - values[0]) / (values.size - 1)
            column = {"from": float(values[0]), "step": float(f"{step:.15g}"), "count": values.size}
        elif is_log or size == 0.0:
            column = [float(f"{v:.6g}") if math.isfinite(v) else None for v in values]
        else:
            decimals = DIGITS - math.floor(math.log10(size))
            column = [round(v, decimals) if math.isfinite(v) else None for v in values.tolist()]
        self._indices[key] = len(self.series)
        self.series.append(column)
        return self._indices[key]


def _panel(axes: Any, columns: _DataColumns) -> dict[str, Any]:
    panels: list[Any] = axes.figure.axes
    # Index of the first panel that shares the horizontal axis.
    group = min(panels.index(panel) for panel in axes.get_shared_x_axes().get_siblings(axes) if panel in panels)
    panel: dict[str, Any] = {"group": group, "x": _axis(axes, "x"), "y": _axis(axes, "y")}
    title = axes.get_title(loc="left") or axes.get_title()
    panel["lines"], panel["rules"] = _curves_and_lines(axes, columns)
    panel["bands"], panel["boxes"], panel["segments"] = _filled_shapes(axes, columns)
    texts, rows = [], []
    for text in axes.texts:
        x, y = (float(v) for v in text.get_position())
        in_x, in_y = text.get_transform().contains_branch_seperately(axes.transData)
        if in_x and in_y:
            alignment = _ALIGN[text.get_ha()], _BASELINE.get(text.get_va(), "alphabetic")
            texts.append([x, y, text.get_text(), _colour(text.get_color())["colour"], *alignment])
        elif in_y and x > 1.0:
            rows.append([y, text.get_text()])
    panel["texts"], panel["rows"] = texts, rows
    if panel["rows"]:
        title = title or next((t.get_text().replace("\n", " ") for t in axes.texts if t.get_position()[0] < 0.0), "")
    panel["title"] = title
    return {key: value for key, value in panel.items() if value != [] and value != ""}


def _axis(axes: Any, name: str) -> dict[str, Any]:
    axis, limits = getattr(axes, f"{name}axis"), getattr(axes, f"get_{name}lim")()
    # Panels that share an axis have one label on paper; in a page each panel has its own.
    siblings = [axes, *(panel for panel in axes.get_shared_y_axes().get_siblings(axes) if name == "y")]
    labels = (getattr(panel, f"{name}axis").get_label_text() for panel in siblings)
    entry: dict[str, Any] = {
        "label": next(filter(None, labels), "").replace("\n", " "),
        "range": [float(f"{v:.9g}") for v in limits],
    }
    if axis.get_scale() == "log":
        entry["log"] = True
    else:
        from matplotlib.ticker import FixedFormatter, FuncFormatter

        # Keep tick labels that are names; the plot computes the ticks of numbers.
        if isinstance(axis.get_major_formatter(), FixedFormatter | FuncFormatter):
            entry["ticks"] = [
                [float(v) for v in axis.get_ticklocs()], [label.get_text() for label in axis.get_ticklabels()]
            ]  # fmt: skip
    if name == "x" and not axis.get_tick_params().get("labelbottom", True):
        entry["silent"] = True
    second = [child for child in axes.child_axes if hasattr(child, "set_functions")]
    if name == "y" and second:
        factor = second[0].get_ylim()[1] / limits[1] if limits[1] else 1.0
        entry["second"] = {"label": second[0].get_ylabel(), "factor": float(f"{factor:.6g}")}
    return entry


def _label(artist: Any) -> str:
    text = str(artist.get_label())
    return "" if text.startswith("_") else text


def _colour(value: Any, alpha: float | None = None) -> dict[str, Any]:
    from matplotlib.colors import to_hex, to_rgba

    opacity = to_rgba(value)[3] if alpha is None else alpha
    return {"colour": to_hex(value)} | ({"alpha": round(float(opacity), 3)} if opacity < 1.0 else {})


def _curves_and_lines(axes: Any, columns: _DataColumns) -> tuple[list[dict[str, Any]], list[dict[str, Any]]]:
    """Return the curves of a panel, and the horizontal or vertical lines that cross it."""
    lines, rules = [], []
    for line in axes.lines:
        stroke = line.get_linestyle()
        width = float(line.get_linewidth()) if stroke not in _NO_MARKER else 0.0
        entry = {"label": _label(line)} | _colour(line.get_color(), line.get_alpha()) | {"width": width}
        dashes = line._unscaled_dash_pattern[1] if stroke not in (*_NO_MARKER, "-") else None
        entry |= {"dash": [round(2.0 * float(v), 2) for v in dashes]} if dashes else {}
        in_x, in_y = line.get_transform().contains_branch_seperately(axes.transData)
        if not (in_x and in_y):
            level = line.get_xdata()[0] if in_x else line.get_ydata()[0]
            rules.append(entry | {"axis": "x" if in_x else "y", "at": float(level)})
            continue
        x, y = (np.asarray(values, dtype=float) for values in whole_of(line))
        if not x.size:
            continue
        if x.size > MAX_POINTS and np.all(np.diff(x) > 0.0):
            rows = thinned(x, y, MAX_POINTS // 5)
            entry, x, y = entry | {"of": int(x.size)}, x[rows], y[rows]
        marker = line.get_marker()
        if marker not in _NO_MARKER:
            entry |= {"marker": str(marker), "size": float(line.get_markersize())}
            fill = line.get_markerfacecolor()
            entry |= {} if isinstance(fill, str) and fill == "none" else {"fill": _colour(fill)["colour"]}
            entry |= {"edge": _colour(line.get_markeredgecolor())["colour"]} if line.get_markeredgewidth() else {}
        if line.get_drawstyle() == "steps-post":
            entry["step"] = True
        is_log = axes.get_xscale() == "log", axes.get_yscale() == "log"
        lines.append(entry | {"x": columns.add(x, is_log=is_log[0]), "y": columns.add(y, is_log=is_log[1])})
    return lines, rules


def _filled_shapes(axes: Any, columns: _DataColumns) -> tuple[list[Any], list[Any], list[Any]]:
    """Return the bands, the boxes and the separate line segments of a panel.

    A band is the area between two curves.
    """
    from matplotlib.collections import LineCollection
    from matplotlib.patches import Rectangle

    bands, boxes, segments = [], [], []
    for artist in axes.collections:
        if isinstance(artist, LineCollection):
            ends = [v for piece in artist.get_segments() for v in np.asarray(piece)[:2].ravel()]
            width = float(np.atleast_1d(artist.get_linewidth())[0])
            segments.append(_colour(artist.get_colors()[0]) | {"width": width, "at": _flat(ends)})
            continue
        entry = {"label": _label(artist)} | _colour(artist.get_facecolors()[0])
        shapes = [path.vertices for path in artist.get_paths()]
        if all(len(shape) <= 5 for shape in shapes):
            corners = [v for s in shapes for v in (*s.min(axis=0), *s.max(axis=0))]
            boxes.append(entry | ({"hatch": True} if artist.get_hatch() else {}) | {"at": _flat(corners)})
            continue
        for shape in shapes:
            # The outline follows the lower line, then the upper one backwards, with corners between them.
            count = (len(shape) - 3) // 2
            low, high = shape[1 : count + 1], shape[count + 2 : 2 * count + 2][::-1]
            indices = [columns.add(np.ascontiguousarray(v)) for v in (low[:, 0], low[:, 1], high[:, 1])]
            bands.append(entry | dict(zip(("x", "low", "high"), indices, strict=True)))
    bars: dict[tuple[str, Any], list[Any]] = {}
    for patch in axes.patches:
        if isinstance(patch, Rectangle):
            in_x, in_y = patch.get_data_transform().contains_branch_seperately(axes.transData)
            (a, b), (c, d) = patch.get_xy(), (patch.get_x() + patch.get_width(), patch.get_y() + patch.get_height())
            corners_of_bar = [a if in_x else None, b if in_y else None, c if in_x else None, d if in_y else None]
            key = _label(patch), patch.get_facecolor()
            bars.setdefault(key, []).extend(corners_of_bar)
    boxes += [{"label": label} | _colour(fill) | {"at": _flat(corners)} for (label, fill), corners in bars.items()]
    return bands, boxes, segments


def _flat(values: Sequence[Any]) -> list[float | None]:
    return [None if v is None or not math.isfinite(v) else float(f"{v:.7g}") for v in values]


def data_element(data: dict[str, Any]) -> str:
    """Return the data of a figure as an HTML element.

    Special characters are escaped for HTML and XML.

    Examples
    --------
    >>> print(data_element({"a": "</script>"}))
    <script type="application/json" class="plot-data">{"a":"\\u003c/script\\u003e"}</script>
    """
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    for sign in "<>&":
        text = text.replace(sign, f"\\u{ord(sign):04x}")
    return f'<script type="application/json" {MARK}>{text}</script>'


@cache
def script() -> str:
    """Return the JavaScript program of the interactive plots.

    It contains the library uPlot.
    """
    folder = files("poppet.report.plots")
    plots = minify((folder / "plots.js").read_text(encoding="utf-8"))
    library = (folder / "uplot" / "uPlot.iife.min.js").read_text(encoding="utf-8")
    return f"{_LOCALE}\n{library.strip()}\n{plots}"


def minify(script: str) -> str:
    """Return a script without its comments and indentation."""
    lines = (line.strip() for line in re.sub(r"/\*.*?\*/", "", script, flags=re.DOTALL).splitlines())
    return "\n".join(filter(None, lines)) + "\n"


@cache
def style() -> str:
    """Return the style sheets of uPlot and of the plots."""
    text = (files("poppet.report.plots") / "uplot" / "uPlot.min.css").read_text(encoding="utf-8")
    return f"{text.strip()}\n{stylesheet('plots').strip()}\n"


def policy(*scripts: str, computes: bool = False, connects: str = "") -> str:
    """Return a content security policy (CSP) that permits only the given scripts.

    If the keyword `computes` is True, the policy also permits WebAssembly. The keyword `connects` contains the sources
    to which scripts can connect; without it, there are none.
    """
    hashes = (base64.b64encode(hashlib.sha256(text.encode()).digest()).decode() for text in scripts)
    allowed = " ".join(f"'sha256-{digest}'" for digest in hashes) or "'none'"
    allowed += " 'wasm-unsafe-eval'" * computes
    rules = f"default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src {allowed}; base-uri 'none'"
    rules += f"; connect-src {connects}" * bool(connects)
    return f'<meta http-equiv="Content-Security-Policy" content="{rules}; form-action \'none\'">\n'

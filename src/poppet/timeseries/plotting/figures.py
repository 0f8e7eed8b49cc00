"""Common functions of all figures: import of Matplotlib, style, reproducible files."""

from __future__ import annotations

import io
import warnings
from collections.abc import Iterator, Sequence
from contextlib import AbstractContextManager, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.core.errors import needed
from poppet.core.files import by_suffix, write_whole
from poppet.core.number_format import printable

if TYPE_CHECKING:
    from matplotlib.figure import Figure

INK, GREY, FAINT, ACCENT = "#1b1f24", "#6b7280", "#d5d9df", "#c2410c"
PALETTE = (
    *("#1f5fa8", "#c8452c", "#2e8b57", "#7d4fa3", "#c98a06", "#0f8b9d", "#a63a6f", "#6b6b1e", "#5c6b7a", "#8a5a3b"),
    *("#7fb0e6", "#f0a08f", "#8fd0ac", "#bfa0dc", "#f2cf6b", "#7ed3de", "#e29abf", "#bcbc62", "#a9b6c2", "#cfa78e"),
)  # fmt: skip
"""Ten dark colours that differ in print, and their light variants."""

# Sizes in points. Text in SVG files becomes paths, so it looks the same in all viewers.
_STYLE: dict[str, Any] = {
    "font.family": "DejaVu Sans",
    **dict.fromkeys(("font.size", "axes.labelsize"), 9.0),
    **dict.fromkeys(("xtick.labelsize", "ytick.labelsize", "legend.fontsize"), 8.5),
    **dict.fromkeys(("text.color", "axes.labelcolor", "xtick.labelcolor", "ytick.labelcolor"), INK),
    **dict.fromkeys(("axes.edgecolor", "xtick.color", "ytick.color"), GREY),
    **dict.fromkeys(("hatch.color", "figure.facecolor", "savefig.facecolor"), "white"),
    **dict.fromkeys(("axes.grid", "axes.axisbelow", "axes.unicode_minus"), True),
    **dict.fromkeys(("axes.spines.top", "axes.spines.right", "axes.formatter.useoffset", "legend.frameon"), False),
    **dict.fromkeys(("grid.linewidth", "hatch.linewidth"), 0.7),
    "axes.titlesize": 10.0,
    "axes.linewidth": 0.8,
    "grid.color": "#e6e8ec",
    "lines.linewidth": 1.4,
    "lines.solid_capstyle": "round",
    "svg.fonttype": "path",
    "pdf.fonttype": 42,
}
# Dates and versions are omitted, so the same figure gives the same file.
_METADATA: dict[str, dict[str, None]] = {
    "png": {"Software": None},
    "svg": {"Date": None, "Creator": None},
    "pdf": {"CreationDate": None, "Producer": None, "Creator": None},
}
_DOTS_PER_INCH = 150
_HINTED = 1.05  # maximum width of letters that are fitted to pixels, relative to their outlines


def style(purpose: str, path: str | Path | None = None) -> AbstractContextManager[None]:
    """Return a context manager that applies the common style of all figures.

    `purpose` describes the task, for the error message if Matplotlib is not installed. `path` is the file of the
    figure, whose suffix is checked before the figure is drawn.
    """
    if path is not None:
        check_format(path)
    with needed("matplotlib", purpose, "plot"):
        import matplotlib as mpl
    context: AbstractContextManager[None] = mpl.rc_context(_STYLE)
    return context


def new_figure(width: float, height: float) -> Figure:
    """Return an empty figure with a given width and height [in].

    The figure has no window and does not change the global state of pyplot.
    """
    from matplotlib.backends.backend_agg import FigureCanvasAgg
    from matplotlib.figure import Figure

    # Not with pyplot, which keeps its figures and can require a window system.
    figure = Figure(figsize=(width, height))
    FigureCanvasAgg(figure)
    return figure


def axes_in(figure: Figure, left: float, top: float, width: float, height: float, **options: Any) -> Any:
    """Add axes to a figure at a given position [in].

    `left` and `top` are distances from the upper left corner of the figure.
    """
    figure_width, figure_height = figure.get_size_inches()
    box = (left / figure_width, 1.0 - (top + height) / figure_height, width / figure_width, height / figure_height)
    return figure.add_axes(box, **options)


@contextmanager
def _without_font_warnings() -> Iterator[None]:
    """Suppress warnings about characters that the font does not contain.

    Matplotlib draws such characters as empty boxes.
    """
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", "Glyph .* missing from font", UserWarning)
        yield


def text_width(text: str, size: float, *, bold: bool = False) -> float:
    """Return the width of one line of text [in].

    `size` is the font size in points.
    """
    import numpy as np
    from matplotlib.font_manager import FontProperties
    from matplotlib.textpath import TextPath

    if not text.strip():
        return 0.0
    font = FontProperties(family="DejaVu Sans", weight="bold" if bold else "normal")
    with _without_font_warnings():
        outline = TextPath((0.0, 0.0), text.replace("$", r"\$"), size=size, prop=font)
    # `get_extents` of the outline takes 100 times longer, because it evaluates each curve separately.
    x, codes = outline.vertices[:, 0], outline.codes
    middle = np.flatnonzero(codes == outline.CURVE3)[::2]  # this font has only quadratic curves
    a, b, c = x[middle - 1], x[middle], x[middle + 1]
    bend = a - 2.0 * b + c
    turn = np.clip((a - b) / np.where(bend == 0.0, np.inf, bend), 0.0, 1.0)  # parameter of the extreme point of a curve
    ends = np.delete(x, np.append(middle, np.flatnonzero(codes == outline.CLOSEPOLY)))
    reach = np.append(ends, a * (1.0 - turn) ** 2 + 2.0 * b * turn * (1.0 - turn) + c * turn**2)
    return _HINTED * float(np.ptp(reach)) / 72.0


def widest(texts: Sequence[str], size: float) -> float:
    """Return the width of the longest of several lines of text [in].

    `size` is the font size in points.
    """
    return max((text_width(text, size) for text in texts), default=0.0)


def check_format(path: str | Path) -> None:
    """Raise an error if the suffix of a path is not a figure format."""
    by_suffix(Path(path), dict.fromkeys((f".{name}" for name in _METADATA), str))


def save_figure(figure: Figure, path: str | Path | None) -> Figure:
    """Return a figure, after writing it to a file if a path is given.

    Equal figures give identical bytes. An existing file is replaced completely or not at all.
    """
    if path is not None:
        check_format(path)
        target = Path(path)
        content = figure_bytes(figure, target.suffix[1:].lower(), target.stem)
        write_whole(target, lambda stream: stream.write(content))
    return figure


def figure_bytes(figure: Figure, file_format: str, name: str) -> bytes:
    """Return the content of a figure file in a given format.

    `name` makes the identifiers of SVG elements unique if a page contains several figures.
    """
    import matplotlib as mpl

    stream = io.BytesIO()
    # Names of SVG elements are hashes; the salt makes them unique on a page.
    with mpl.rc_context(_STYLE | {"svg.hashsalt": f"poppet {name}"}), _without_font_warnings():
        figure.savefig(stream, format=file_format, dpi=_DOTS_PER_INCH, metadata=_METADATA[file_format])
    content = stream.getvalue()
    # The SVG file has the texts as comments next to their outlines.
    return printable(content.decode()).encode() if file_format == "svg" else content

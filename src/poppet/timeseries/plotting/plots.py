"""Recordings as a figure: panels by quantity over one time axis, and a timeline of the flow regimes."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.core.errors import InputError, OutOfRangeError
from poppet.timeseries.columns import Columns
from poppet.timeseries.plotting.figures import check_format, save_figure, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MOST_RECORDINGS = 8
"""More line styles than these cannot be told apart."""


def plot_recordings(
    recordings: Mapping[str, Columns],
    path: str | Path | None = None,
    *,
    select: str | Iterable[str] | None = None,
    units: Mapping[str, str] | Sequence[str] | str | None = None,
    title: str = "",
    inner: bool = False,
) -> Figure:
    """Draw recordings over one time axis: a panel for each quantity, and a timeline of regimes and contacts.

    Notes
    -----
    Series that jump and rest are drawn as steps, all others straight between samples. Where there are more
    samples than picture elements, each element shows the range of its samples: no peak is lost. Constant
    series are left out and named below, unless they are selected; so are those that a part calls inner, which are drawn
    when they are selected, or all with `inner`. Where bodies move, their positions and speeds come first, then
    pressures and forces, on the timeline where they stick and slip; temperatures, heat flows and masses are left out as
    inner ones are. The second axis of mass flow, l/min ANR, is
    of air and left out where the gas is another one.

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
        from poppet.timeseries.plotting.sheet import Sheet

        figure = Sheet(recordings, select, units, title, inner).draw()
    if path is not None:
        save_figure(figure, path)
    return figure

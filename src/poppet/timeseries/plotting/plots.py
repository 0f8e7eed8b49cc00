"""Figure of recordings: panels by quantity over one time axis, and a timeline of flow regimes."""

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
"""Number of distinguishable line styles."""


def plot_recordings(
    recordings: Mapping[str, Columns],
    path: str | Path | None = None,
    *,
    select: str | Iterable[str] | None = None,
    units: Mapping[str, str] | Sequence[str] | str | None = None,
    title: str = "",
    inner: bool = False,
) -> Figure:
    """Draw recordings over one time axis: one panel per quantity, and a timeline of regimes.

    Notes
    -----
    Staircase series are drawn as steps, all others with straight lines. If there are more samples than pixels, each
    pixel column shows the range of its samples, so no peak is lost. The figure omits constant series and names them
    below, unless they are selected. It also omits internal outputs; `inner` draws them.

    With moving bodies, the order is positions, velocities, pressures, forces. The timeline then shows sticking and
    slipping, and temperatures, heat flows and masses are omitted in the same way as internal outputs.
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
        from poppet.timeseries.plotting.sheet import Sheet

        figure = Sheet(recordings, select, units, title, inner).draw()
    if path is not None:
        save_figure(figure, path)
    return figure

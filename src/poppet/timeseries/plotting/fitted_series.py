"""Figure of measured series and fitted curves."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.core.errors import InputError
from poppet.timeseries.plotting.figures import ACCENT, GREY, check_format, new_figure, save_figure, style

if TYPE_CHECKING:
    from matplotlib.figure import Figure

WIDTH, HEIGHT = 7.0, 2.2
"""Width of the figure and height of a panel [in]."""


def plot_fitted_series(
    tables: Mapping[str, Mapping[str, Any]], path: str | Path | None = None, *, title: str = ""
) -> Figure:
    """Draw one panel for each table of `measured` and `model` over `time` or `x`.

    `low` and `high` are the edges of a band about the model.

    Examples
    --------
    >>> table = {"time": [0.0, 1.0], "measured": [1.0, 2.1], "model": [1.0, 2.0], "unit": "Pa"}
    >>> plot_fitted_series({"test.tank.pressure": table}).axes[0].get_ylabel()
    'Pa'
    """
    if not tables:
        raise InputError("drawing.nothing")
    if path is not None:
        check_format(path)
    with style("A figure"):
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
    if path is not None:
        save_figure(figure, path)
    return figure

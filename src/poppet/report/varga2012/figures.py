"""Figures 3, 4 and 6 of Varga & Keski-Honkola 2012, drawn from the simulator on the axes of the paper."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from poppet import library
from poppet.report.varga2012.circuits import STEPS_END, STROKES, suspected
from poppet.report.varga2012.runs import Findings
from poppet.series.drawing.figures import FAINT, GREY, INK, PALETTE, axes_in, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Axes as the tick labels of the figures print them.
FIG3_AXES = (0.0, 1.0, 0.4, 2.0)  # stroke [mm], C [1e-8 m^3/(s Pa)]
FIG4_AXES = (0.0, 1.0, 0.35, 0.75)  # stroke [mm], b [1]
FIG6_AXES = (0.0, STEPS_END, 1.0, 5.5)  # time [s], pressure [bar]

_BLUE, _RED, _GREEN, _VIOLET, _AMBER = PALETTE[:5]
_TANKS = (
    ("isentrope", "isentrope (the paper's tank)", _RED, "-"),
    ("adiabatic", "energy balance, adiabatic", _AMBER, (0, (5, 2))),
    ("wall", "energy balance with wall heat", _BLUE, "-"),
    ("isothermal", "isothermal", _GREEN, (0, (1.2, 1.4))),
)


def figure_3() -> Figure:
    """Sonic conductance over the stroke."""
    figure, axes = _sheet(FIG3_AXES, "sonic conductance C  [1e-8 m³/(s Pa)]")
    strokes = np.concatenate((np.linspace(0.0, 0.03e-3, 121), np.linspace(0.03e-3, 1e-3, 400)))
    printed, closed = library.characteristic("varga2012"), library.characteristic("varga2012.closed")
    alternative = 1e8 * np.asarray(suspected().sonic_conductance_at(strokes))
    axes.plot(1e3 * strokes, alternative, color="#b9bec7", linestyle=(0, (5, 2.5)), linewidth=1.3)
    axes.plot(1e3 * strokes, 1e8 * printed.sonic_conductance_at(strokes), color=_BLUE, linewidth=2.0)
    near = strokes[strokes <= closed.numbers()["closing"].value]
    axes.plot(1e3 * near, 1e8 * closed.sonic_conductance_at(near), color=_RED, linestyle=(0, (2.2, 1.2)))
    points = [1e8 * float(printed.sonic_conductance_at(x)) for x in STROKES]
    _points(axes, points, _BLUE)
    axes.text(0.985, 1.925, "hypothesis: k5 = -2.2229e-6", ha="right", color=GREY, fontsize=8.5)
    axes.text(0.44, 1.52, "polynomial of Table 1 as printed", color=_BLUE, fontsize=8.5, va="top")
    _pointer(
        axes,
        "closed variant: C = 0 at x = 0,\nas printed from 0.02 mm on",
        (0.0135, 0.45),
        (0.09, 0.56),
        _RED,
    )
    return figure


def figure_4() -> Figure:
    """Critical pressure ratio over the stroke."""
    figure, axes = _sheet(FIG4_AXES, "critical pressure ratio b  [1]")
    strokes = np.linspace(0.0, 1e-3, 500)
    printed = library.characteristic("varga2012")
    axes.plot(1e3 * strokes, printed.critical_ratio_at(strokes), color=_BLUE, linewidth=2.0)
    _points(axes, [float(printed.critical_ratio_at(x)) for x in STROKES], _BLUE)
    axes.text(0.1, 0.57, "polynomial of Table 1 as printed", color=_BLUE, fontsize=8.5)
    return figure


def figure_6(findings: Findings) -> Figure:
    """Tank pressure over time on the axes of fig. 6, and below it the temperature of the gas."""
    figure = new_figure(7.4, 5.9)
    upper = axes_in(figure, 0.75, 0.15, 6.45, 3.3)
    lower = axes_in(figure, 0.75, 3.65, 6.45, 1.7, sharex=upper)
    run = findings.staircase
    look: dict[str, Any] = {"color": INK, "linewidth": 1.2, "drawstyle": "steps-post"}
    upper.plot(run.time, 1e-5 * run["required.pressure"], label="required value", **look)
    for name, label, colour, line in _TANKS:
        note = f" ({findings.wall.for_peak:.1f} W/K)" if name == "wall" else ""
        look = {"color": colour, "linestyle": line, "linewidth": 1.5}
        upper.plot(run.time, 1e-5 * run[f"{name}.pressure"], label=label + note, **look)
        lower.plot(run.time, run[f"{name}.temperature"] - 273.15, **look)
    lower.axhline(20.0 + 18.0, color=GREY, linewidth=0.8, linestyle=(0, (2, 2)))
    lower.text(119.0, 43.0, "20 °C + 18 °C, the rise the paper reports", color=GREY, fontsize=8, ha="right")
    upper.axis(FIG6_AXES)
    upper.set_yticks(np.arange(1.0, 5.6, 0.5))
    upper.tick_params(labelbottom=False)
    upper.legend(loc="lower right", fontsize=8.5, facecolor="white", frameon=True, edgecolor=FAINT, framealpha=1.0)
    upper.set_ylabel("tank pressure  [bar, absolute]")
    lower.set_ylabel("gas temperature  [°C]")
    lower.set_xlabel("time  [s]")
    figure.align_ylabels([upper, lower])
    return figure


def _sheet(limits: tuple[float, float, float, float], label: str) -> tuple[Figure, Any]:
    figure = new_figure(6.2, 3.9)
    axes = axes_in(figure, 0.7, 0.15, 5.3, 3.2)
    axes.axis(limits)
    axes.set_xticks(np.arange(0.0, 1.01, 0.1))
    axes.set_xlabel("stroke of the poppet x  [mm]")
    axes.set_ylabel(label)
    return figure, axes


def _points(axes: Any, values: list[float], colour: str) -> None:
    strokes = [1e3 * x for x in STROKES]
    axes.plot(strokes, values, "o", color=colour, markerfacecolor="white", markersize=4.5, clip_on=False, zorder=4)


def _pointer(axes: Any, text: str, at: tuple[float, float], stands: tuple[float, float], colour: str) -> None:
    arrow = {"arrowstyle": "-", "color": colour, "linewidth": 0.8, "shrinkB": 2}
    axes.annotate(text, at, stands, color=colour, fontsize=8.5, va="center", arrowprops=arrow)

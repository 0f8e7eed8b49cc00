"""Figures of a bench test: characteristic, resolution, flow, supply, steps and Bode plot.

Each figure can also show the curves of a reference valve.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.bench.iso10094.bench_result import BenchResult
from poppet.bench.iso10094.characteristic import RANGE
from poppet.bench.iso10094.evaluation import PlottedCurve
from poppet.bench.iso10094.frequency import GAIN_DB, PHASE_DEG
from poppet.bench.iso10094.step import BAND
from poppet.core.number_format import readable_unit
from poppet.core.units import convert
from poppet.timeseries.plotting.figures import FAINT, GREY, PALETTE, axes_in, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Sizes in inches.
_WIDTH, _LEFT, _RIGHT, _TOP, _FOOT, _GAP = 10.0, 0.8, 0.15, 0.36, 0.55, 0.85
_HIGH = 2.9
_HALF = (_WIDTH - _LEFT - _RIGHT - _GAP) / 2.0
_UP, _DOWN = PALETTE[0], PALETTE[1]
_OTHER: dict[str, Any] = {"linestyle": (0, (4, 2)), "linewidth": 1.0, "alpha": 0.75}
_MAX_CASES = 6
CurveValues = list[tuple[PlottedCurve, Any, Any]]
"""Curves, each with its abscissas and ordinates in the units of the figure."""


def curves_of(result: BenchResult | None, test: str) -> list[PlottedCurve]:
    """Return the curves of one test in a bench result.

    The list is empty if `result` is None.
    """
    return list(result.curves.get(test, ())) if result is not None else []


def _figure_with_two_axes() -> tuple[Figure, tuple[Any, Any]]:
    """Return an empty figure with two axes side by side."""
    figure = new_figure(_WIDTH, _TOP + _HIGH + _FOOT)
    left, right = (axes_in(figure, edge, _TOP, _HALF, _HIGH) for edge in (_LEFT, _LEFT + _HALF + _GAP))
    return figure, (left, right)


def _single(high: float) -> tuple[Figure, Any]:
    figure = new_figure(_WIDTH, _TOP + high + _FOOT)
    return figure, axes_in(figure, _LEFT, _TOP, _WIDTH - _LEFT - _RIGHT, high)


def _key(axes: Any, columns: int = 4) -> None:
    handles, labels = axes.get_legend_handles_labels()
    if handles:
        axes.legend(
            handles, labels, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=columns, borderpad=0.2,
            borderaxespad=0.1, handlelength=1.6, columnspacing=1.2,
        )  # fmt: skip


def _cases(curves: Iterable[PlottedCurve]) -> list[str]:
    return list(dict.fromkeys(curve.case for curve in curves))[:_MAX_CASES]


def characteristic_figure(result: BenchResult, reference: BenchResult | None = None) -> Figure:
    """Draw the outlet pressure versus the setpoint, and its deviation from the nominal line.

    `reference` is the result of a second valve, drawn with dashed lines for comparison.
    """
    figure, (left, right) = _figure_with_two_axes()
    colours = {"up": _UP, "down": _DOWN}
    left.plot([0, 100], [0, 100], color=GREY, linewidth=0.8, label="nominal")
    right.axhline(0.0, color=GREY, linewidth=0.8)
    right.axvspan(-3, RANGE[0], color=FAINT, alpha=0.35, linewidth=0)
    right.axvspan(RANGE[1], 103, color=FAINT, alpha=0.35, linewidth=0)
    for curve in curves_of(result, "characteristic"):
        colour = colours[curve.name.split()[0]]
        if curve.case == "cycles":
            right.plot(curve.x, curve.y - curve.x, color=colour, linewidth=0.7, alpha=0.35)
            continue
        left.plot(curve.x, curve.y, color=colour, label=curve.name)
        right.plot(curve.x, curve.y - curve.x, color=colour, label=curve.name)
    for curve in curves_of(reference, "characteristic"):
        if curve.case != "cycles":
            label = f"{curve.name}, reference"
            right.plot(curve.x, curve.y - curve.x, color=colours[curve.name], label=label, **_OTHER)
    fit = result.conditions.get("characteristic", {})
    if "slope" in fit:
        x = np.array(RANGE)
        line = fit["slope"] * x + fit["offset"] - x
        right.plot(x, line, color=GREY, linestyle=(0, (1.5, 1.5)), linewidth=1.2, label="best line")
    for axes, label in ((left, "outlet [% FS]"), (right, "outlet - nominal [% FS]")):
        axes.set(xlim=(-3, 103), xlabel="setpoint [% FS]", ylabel=label)
    # Values outside the evaluated setpoint range, such as a dead zone near zero, can be outside the axis.
    curves = [c for c in curves_of(result, "characteristic") if c.case != "cycles"]
    evaluated = [(c.y - c.x)[(c.x >= RANGE[0]) & (c.x <= RANGE[1])] for c in curves]
    values = np.concatenate([errors for errors in evaluated if errors.size] or [np.zeros(1)])
    margin = max(0.6 * float(np.ptp(values)), 0.1)
    all_errors = np.concatenate([c.y - c.x for c in curves if c.x.size] or [np.zeros(1)])
    low = max(float(np.min(values)) - margin, float(np.min(all_errors)) - 0.05)
    high = min(float(np.max(values)) + margin, float(np.max(all_errors)) + 0.05)
    right.set_ylim(min(low, -0.05), max(high, 0.05))
    _key(left)
    _key(right, 5)
    return figure


def resolution_figure(result: BenchResult, reference: BenchResult | None = None) -> Figure:
    """Draw the response of the outlet pressure to a small staircase of the setpoint.

    `reference` is the result of a second valve, drawn with dashed lines for comparison.
    """
    figure, axes = _single(2.4)
    curves = curves_of(result, "resolution")
    for curve in curves:
        if curve.case in _cases(curves)[:1]:
            style = {"color": GREY, "linewidth": 1.0} if curve.name == "setpoint" else {"color": _UP}
            axes.plot(curve.x, curve.y, label=curve.name, **style)
    for curve in [curve for curve in curves_of(reference, "resolution") if curve.name == "outlet"][:1]:
        axes.plot(curve.x, curve.y, color=_DOWN, label="outlet, reference", **_OTHER)
    axes.set(xlabel="time [s]", ylabel="[% FS]")
    _key(axes)
    return figure


def _draw_both_directions(axes: Any, curves: CurveValues, reference: CurveValues, thick: tuple[str, ...]) -> None:
    """Draw the outlet pressure at increasing and at decreasing flow or supply pressure.

    All curves of one test condition (case) have the same colour. Curves at increasing flow or pressure are thick, and
    the others are thin; `thick` contains the names of the former. For the reference valve, only curves at increasing
    flow or pressure are drawn, as dashed lines.
    """
    cases = _cases(curve for curve, _, _ in curves)
    for group, is_other in ((curves, False), (reference, True)):
        for curve, x, y in group:
            is_there = curve.name in thick
            if curve.case not in cases or (is_other and not is_there):
                continue
            style = _OTHER if is_other else {"linewidth": 1.6 if is_there else 0.9}
            label = curve.case if curve.name == thick[0] and not is_other else None
            axes.plot(x, y, color=PALETTE[cases.index(curve.case)], label=label, **style)
    _key(axes, 6)


def flow_figure(result: BenchResult, reference: BenchResult | None = None) -> Figure:
    """Draw the outlet pressure versus the forward and the relief flow.

    `reference` is the result of a second valve, drawn with dashed lines for comparison.
    """
    figure, axes = _single(3.4)
    curves = curves_of(result, "flow")
    unit = readable_unit("kg/s", max((float(np.max(np.abs(c.x), initial=0.0)) for c in curves), default=1.0))
    groups = curves, curves_of(reference, "flow")
    measured, references = ([(c, convert(c.x, "kg/s", unit), c.y) for c in group] for group in groups)
    axes.set(xlabel=f"forward flow [{unit}]; negative: relief flow", ylabel="outlet [% FS]")
    _draw_both_directions(axes, measured, references, ("drawn going", "fed going"))
    axes.axvline(0.0, color=GREY, linewidth=0.8)
    return figure


def supply_figure(result: BenchResult, reference: BenchResult | None = None) -> Figure:
    """Draw the outlet pressure, minus its mean, versus the supply pressure.

    `reference` is the result of a second valve, drawn with dashed lines for comparison.
    """
    figure, axes = _single(2.4)

    def deviations(curves: list[PlottedCurve]) -> CurveValues:
        middle = {case: float(np.mean([np.mean(c.y) for c in curves if c.case == case])) for case in _cases(curves)}
        return [(c, convert(c.x, "Pa", "bar"), c.y - middle[c.case]) for c in curves if c.case in middle]

    measured, references = (deviations(curves_of(source, "supply")) for source in (result, reference))
    _draw_both_directions(axes, measured, references, ("rising",))
    low, high = axes.get_ylim()
    if high - low < 0.02:  # rounding must not fill the figure
        axes.set_ylim(0.5 * (low + high) - 0.01, 0.5 * (low + high) + 0.01)
    axes.set(xlabel="supply pressure [bar, absolute]", ylabel="outlet - its mean [% FS]")
    return figure


def step_figure(result: BenchResult, reference: BenchResult | None = None) -> Figure:
    """Draw all step responses of the outlet pressure, relative to its total change.

    Steps up are at the left, steps down at the right. Each load volume has one row of axes. `reference` is the result
    of a second valve, drawn with dashed lines for comparison.
    """
    curves = curves_of(result, "step")
    volumes = list(dict.fromkeys(_volume_suffix(c.case) for c in curves)) or [""]
    sizes = list(dict.fromkeys(_step_size(c.case) for c in curves))[:_MAX_CASES]
    row = _TOP + 2.5 + _FOOT
    figure = new_figure(_WIDTH, len(volumes) * row)
    for k, volume in enumerate(volumes):
        for column, sign in enumerate("+-"):
            axes = axes_in(figure, _LEFT + column * (_HALF + _GAP), k * row + _TOP, _HALF, 2.5)
            same = [c for c in curves if _volume_suffix(c.case) == volume and c.case.startswith(sign)]
            cases = {c.case for c in same}
            unit = readable_unit("s", max((float(c.x[-1]) for c in same), default=1.0))
            for curve in (*same, *(c for c in curves_of(reference, "step") if c.case in cases)):
                size = _step_size(curve.case)
                if size in sizes:
                    is_own = curve in same
                    style = {"label": f"{size} % FS"} if is_own else _OTHER
                    axes.plot(convert(curve.x, "s", unit), curve.y, color=PALETTE[sizes.index(size)], **style)
            axes.axhspan(100.0 - 100.0 * BAND, 100.0 + 100.0 * BAND, color=FAINT, alpha=0.5, linewidth=0)
            axes.axvline(0.0, color=GREY, linewidth=0.8)
            label = f"time after the step {'up' if sign == '+' else 'down'}{volume} [{unit}]"
            axes.set(xlabel=label, ylabel="fraction of the change [%]")
            _key(axes, 4)
    return figure


def _step_size(case: str) -> str:
    """Return the size of a step in the name of a case, without sign.

    For `+80 % FS, 1 l` the result is `80`.
    """
    return case[1:].partition(" ")[0]


def _volume_suffix(case: str) -> str:
    """Return the load volume in the name of a case, with the comma before it.

    For `+80 % FS, 1 l` the result is `, 1 l`. The text is empty if the name contains no volume.
    """
    return case.partition(",")[1] + case.partition(",")[2]


def bode_figure(result: BenchResult, reference: BenchResult | None = None) -> Figure:
    """Draw gain and phase of the valve versus frequency.

    `reference` is the result of a second valve, drawn with dashed lines for comparison.
    """
    figure, (gain, phase) = _figure_with_two_axes()
    curves = curves_of(result, "frequency")
    cases = _cases(curves)
    gain.axhline(GAIN_DB, color=GREY, linewidth=0.8)
    phase.axhline(PHASE_DEG, color=GREY, linewidth=0.8)
    for group, is_other in ((curves, False), (curves_of(reference, "frequency"), True)):
        names = _cases(group)
        for curve in group:
            if curve.case not in names:
                continue
            axes = gain if curve.name == "gain" else phase
            colour = PALETTE[(cases if curve.case in cases else names).index(curve.case)]
            if is_other:
                axes.semilogx(curve.x, curve.y, color=colour, label="reference", **_OTHER)
            else:
                axes.semilogx(curve.x, curve.y, "o-", color=colour, markersize=3.0, label=f"± {curve.case}")
    for axes, label in ((gain, "gain, relative [dB]"), (phase, "phase [deg]")):
        axes.set(xlabel="frequency [Hz]", ylabel=label)
        axes.grid(visible=True, which="both", axis="x")
    low = min((float(np.min(c.y)) for c in curves if c.name == "gain"), default=-20.0)
    gain.set_ylim(max(low - 2.0, -40.0), None)
    _key(gain, 2)
    _key(phase, 2)
    return figure

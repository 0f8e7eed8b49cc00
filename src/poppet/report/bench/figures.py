"""Figures of a bench: characteristic, stairs, flow, supply, steps, Bode; beside those of another valve."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.bench.iso10094.characteristic import RANGE
from poppet.bench.iso10094.evaluation import Curve
from poppet.bench.iso10094.frequency import GAIN_DB, PHASE_DEG
from poppet.bench.iso10094.result import BenchResult
from poppet.bench.iso10094.step import BAND
from poppet.ground.readable import readable_unit
from poppet.ground.units import convert
from poppet.series.drawing.figures import FAINT, GREY, PALETTE, axes_in, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Sizes in inches.
_WIDTH, _LEFT, _RIGHT, _TOP, _FOOT, _GAP = 10.0, 0.8, 0.15, 0.36, 0.55, 0.85
_HIGH = 2.9
_UP, _DOWN = PALETTE[0], PALETTE[1]
_OTHER: dict[str, Any] = {"linestyle": (0, (4, 2)), "linewidth": 1.0, "alpha": 0.75}
_MOST_CASES = 6


def curves_of(result: BenchResult | None, test: str) -> list[Curve]:
    """The curves of a test; none without a result."""
    return list(result.curves.get(test, ())) if result is not None else []


def _pair(high: float = _HIGH, right_axis: bool = True) -> tuple[Figure, list[Any]]:
    """A figure with two axes side by side."""
    figure = new_figure(_WIDTH, _TOP + high + _FOOT)
    width = (_WIDTH - _LEFT - _RIGHT - _GAP) / 2.0
    left = axes_in(figure, _LEFT, _TOP, width, high)
    right = axes_in(figure, _LEFT + width + _GAP, _TOP, width, high) if right_axis else None
    return figure, [left, right]


def _key(axes: Any, columns: int = 4) -> None:
    handles, labels = axes.get_legend_handles_labels()
    if handles:
        axes.legend(
            handles, labels, loc="lower left", bbox_to_anchor=(0.0, 1.0), ncols=columns, borderpad=0.2,
            borderaxespad=0.1, handlelength=1.6, columnspacing=1.2,
        )  # fmt: skip


def _cases(curves: Iterable[Curve]) -> list[str]:
    return list(dict.fromkeys(curve.case for curve in curves))[:_MOST_CASES]


def characteristic_figure(result: BenchResult, other: BenchResult | None = None) -> Figure:
    """The characteristic, and its distance from the nominal line, magnified."""
    figure, (left, right) = _pair()
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
    for curve in curves_of(other, "characteristic"):
        if curve.case != "cycles":
            right.plot(curve.x, curve.y - curve.x, color=colours[curve.name], label=f"{curve.name}, other", **_OTHER)
    found = result.conditions.get("characteristic", {})
    if "slope" in found:
        x = np.array(RANGE)
        line = found["slope"] * x + found["offset"] - x
        right.plot(x, line, color=GREY, linestyle=(0, (1.5, 1.5)), linewidth=1.2, label="best line")
    for axes in (left, right):
        axes.set_xlim(-3, 103)
        axes.set_xlabel("setpoint [% FS]")
    left.set_ylabel("outlet [% FS]")
    right.set_ylabel("outlet - nominal [% FS]")
    _focus(right, [c for c in curves_of(result, "characteristic") if c.case != "cycles"])
    _key(left)
    _key(right, 5)
    return figure


def _focus(axes: Any, curves: Sequence[Curve]) -> None:
    """The range of ordinates that the judged range needs; a dead zone at zero may leave it."""
    inside = [c.y - c.x for c in curves]
    judged = [d[(c.x >= RANGE[0]) & (c.x <= RANGE[1])] for c, d in zip(curves, inside, strict=True)]
    values = np.concatenate([d for d in judged if d.size] or [np.zeros(1)])
    low, high = float(np.min(values)), float(np.max(values))
    margin = max(0.6 * (high - low), 0.1)
    every = np.concatenate(inside or [np.zeros(1)])
    low, high = max(low - margin, float(np.min(every)) - 0.05), min(high + margin, float(np.max(every)) + 0.05)
    axes.set_ylim(min(low, -0.05), max(high, 0.05))


def resolution_figure(result: BenchResult, other: BenchResult | None = None) -> Figure:
    """The small staircase and the outlet."""
    figure = new_figure(_WIDTH, _TOP + 2.4 + _FOOT)
    axes = axes_in(figure, _LEFT, _TOP, _WIDTH - _LEFT - _RIGHT, 2.4)
    curves = curves_of(result, "resolution")
    for case in _cases(curves)[:1]:
        for curve in curves:
            if curve.case == case:
                style = {"color": GREY, "linewidth": 1.0} if curve.name == "setpoint" else {"color": _UP}
                axes.plot(curve.x, curve.y, label=curve.name, **style)
    others = [c for c in curves_of(other, "resolution") if c.name == "outlet"][:1]
    for curve in others:
        axes.plot(curve.x, curve.y, color=_DOWN, label="outlet, other", **_OTHER)
    axes.set_xlabel("time [s]")
    axes.set_ylabel("[% FS]")
    _key(axes)
    return figure


def flow_figure(result: BenchResult, other: BenchResult | None = None) -> Figure:
    """Outlet pressure against flow, both ways."""
    figure = new_figure(_WIDTH, _TOP + 3.4 + _FOOT)
    axes = axes_in(figure, _LEFT, _TOP, _WIDTH - _LEFT - _RIGHT, 3.4)
    curves = curves_of(result, "flow")
    unit = readable_unit("kg/s", max((float(np.max(np.abs(c.x), initial=0.0)) for c in curves), default=1.0))
    cases = _cases(curves)
    for found, is_other in ((curves, False), (curves_of(other, "flow"), True)):
        for curve in found:
            if curve.case not in cases or (is_other and curve.name.endswith("coming")):
                continue
            colour = PALETTE[cases.index(curve.case)]
            way = {"linewidth": 1.6} if curve.name.endswith("going") else {"linewidth": 0.9}
            label = curve.case if curve.name == "drawn going" and not is_other else None
            axes.plot(
                convert(curve.x, "kg/s", unit), curve.y, color=colour, label=label, **(_OTHER if is_other else way)
            )
    axes.axvline(0.0, color=GREY, linewidth=0.8)
    axes.set_xlabel(f"flow out of the outlet [{unit}]; below zero: fed in")
    axes.set_ylabel("outlet [% FS]")
    _key(axes, 6)
    return figure


def supply_figure(result: BenchResult, other: BenchResult | None = None) -> Figure:
    """What the supply does to the outlet."""
    figure = new_figure(_WIDTH, _TOP + 2.4 + _FOOT)
    axes = axes_in(figure, _LEFT, _TOP, _WIDTH - _LEFT - _RIGHT, 2.4)
    curves = curves_of(result, "supply")
    cases = _cases(curves)
    for found, is_other in ((curves, False), (curves_of(other, "supply"), True)):
        middle = {case: float(np.mean([np.mean(c.y) for c in found if c.case == case])) for case in _cases(found)}
        for curve in found:
            if curve.case not in cases or (is_other and curve.name == "falling"):
                continue
            way = {"linewidth": 1.6} if curve.name == "rising" else {"linewidth": 0.9}
            label = curve.case if curve.name == "rising" and not is_other else None
            place, away = convert(curve.x, "Pa", "bar"), curve.y - middle[curve.case]
            axes.plot(place, away, color=PALETTE[cases.index(curve.case)], label=label, **(_OTHER if is_other else way))
    low, high = axes.get_ylim()
    if high - low < 0.02:
        axes.set_ylim(0.5 * (low + high) - 0.01, 0.5 * (low + high) + 0.01)
    axes.set_xlabel("supply pressure [bar, absolute]")
    axes.set_ylabel("outlet - its mean [% FS]")
    _key(axes, 6)
    return figure


def step_figure(result: BenchResult, other: BenchResult | None = None) -> Figure:
    """All steps as parts of the change of the outlet, up on the left, down on the right, a row per volume."""
    curves = curves_of(result, "step")
    volumes = list(dict.fromkeys(_volume_of(c.case) for c in curves)) or [""]
    sizes = list(dict.fromkeys(_size_of(c.case) for c in curves))[:_MOST_CASES]
    figure = new_figure(_WIDTH, len(volumes) * (_TOP + 2.5 + _FOOT))
    width = (_WIDTH - _LEFT - _RIGHT - _GAP) / 2.0
    others = curves_of(other, "step")
    for row, volume in enumerate(volumes):
        for column, sign in enumerate("+-"):
            top = row * (_TOP + 2.5 + _FOOT) + _TOP
            axes = axes_in(figure, _LEFT + column * (width + _GAP), top, width, 2.5)
            same = [c for c in curves if _volume_of(c.case) == volume and c.case.startswith(sign)]
            drawn = {c.case for c in same}
            unit = readable_unit("s", max((float(c.x[-1]) for c in same), default=1.0))
            _one_step(axes, same, sizes, unit, is_other=False)
            _one_step(axes, [c for c in others if c.case in drawn], sizes, unit, is_other=True)
            axes.axhspan(100.0 - 100.0 * BAND, 100.0 + 100.0 * BAND, color=FAINT, alpha=0.5, linewidth=0)
            axes.axvline(0.0, color=GREY, linewidth=0.8)
            axes.set_xlabel(f"time after the step {'up' if sign == '+' else 'down'}{volume} [{unit}]")
            axes.set_ylabel("part of the change [%]")
            _key(axes, 4)
    return figure


def _one_step(axes: Any, curves: Sequence[Curve], sizes: Sequence[str], unit: str, *, is_other: bool) -> None:
    for curve in curves:
        size = _size_of(curve.case)
        if size not in sizes:
            continue
        style = _OTHER if is_other else {}
        label = None if is_other else f"{size} % FS"
        axes.plot(convert(curve.x, "s", unit), curve.y, color=PALETTE[sizes.index(size)], label=label, **style)


def _size_of(case: str) -> str:
    """Size of a step without its sign, `80` of `+80 % FS, 1 l`."""
    return case[1:].partition(" ")[0]


def _volume_of(case: str) -> str:
    """Volume of a step as it stands behind a comma, or nothing."""
    return case.partition(",")[1] + case.partition(",")[2]


def bode_figure(result: BenchResult, other: BenchResult | None = None) -> Figure:
    """Gain and phase over the frequency."""
    figure, (gain, phase) = _pair()
    curves = curves_of(result, "frequency")
    cases = _cases(curves)
    gain.axhline(GAIN_DB, color=GREY, linewidth=0.8)
    phase.axhline(PHASE_DEG, color=GREY, linewidth=0.8)
    for found, is_other in ((curves, False), (curves_of(other, "frequency"), True)):
        names = _cases(found)
        for curve in found:
            if curve.case not in names:
                continue
            axes = gain if curve.name == "gain" else phase
            colour = PALETTE[(cases if curve.case in cases else names).index(curve.case)]
            if is_other:
                axes.semilogx(curve.x, curve.y, color=colour, label="other", **_OTHER)
            else:
                axes.semilogx(curve.x, curve.y, "o-", color=colour, markersize=3.0, label=f"± {curve.case}")
    for axes, label in ((gain, "gain, relative [dB]"), (phase, "phase [deg]")):
        axes.set_xlabel("frequency [Hz]")
        axes.set_ylabel(label)
        axes.grid(visible=True, which="both", axis="x")
    low = min((float(np.min(c.y)) for c in curves if c.name == "gain"), default=-20.0)
    gain.set_ylim(max(low - 2.0, -40.0), None)
    _key(gain, 2)
    _key(phase, 2)
    return figure

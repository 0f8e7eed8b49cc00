"""Maps of a valve's dynamic limits: bandwidth, step response, ideal parts, stability."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.bench.limits.bandwidth import WORTH
from poppet.bench.limits.maps import CONTROLLER, LOAD, PARTS, LimitsResult
from poppet.bench.limits.stability import DECAYS, OSCILLATES
from poppet.series.drawing.figures import GREY, INK, PALETTE, axes_in, new_figure

if TYPE_CHECKING:
    from matplotlib.figure import Figure

# Sizes in inches.
STILL = 1.0
"""Amplitude at the outlet below which the valve rests [Pa]."""
_WIDTH, _LEFT, _TOP, _FOOT, _BAR, _SIDE = 10.0, 0.75, 0.4, 0.62, 0.16, 0.75
_CELL, _GAP, _BETWEEN = 0.44, 0.55, 0.85
_COLOURS = {part: PALETTE[k] for k, part in enumerate((*PARTS, LOAD))} | {CONTROLLER: GREY}
NOISY = 0.5
"""What is beside the fundamental, over it, from which a bandwidth is marked as rough."""
SHORT = {
    "solenoids": "solenoids",
    "pilot volume": "pilot vol.",
    "poppet": "poppet",
    "sonic conductance": "seat C",
    "sensors and sampling": "sensing",
    "load volume": "load",
    CONTROLLER: "controller",
}
"""Part to the word in a cell."""


def bandwidth_figure(result: LimitsResult) -> Figure:
    """Bandwidth over load volume and amplitude, with the part that limits written into each cell."""
    plan = result.plan
    height = len(plan.volumes) * 0.62
    figure = new_figure(_WIDTH, _TOP + height + _FOOT)
    axes = axes_in(figure, _LEFT, _TOP, _WIDTH - _LEFT - _SIDE - 0.35, height)
    values = np.array(result.grid("gain_frequency"), dtype=float)
    mesh, mark = _heat(axes, values, (plan.lowest, plan.highest))
    _volume_axes(axes, plan.volumes, plan.amplitudes)
    names, noise = _limiting(result), result.grid("noise")
    for row in range(values.shape[0]):
        for column in range(values.shape[1]):
            text, colour = _hertz(values[row, column], plan.lowest, plan.highest), mark(values[row, column])
            text = f"~{text}" if noise[row][column] > NOISY else text
            axes.text(column, row + 0.13, text, ha="center", va="center", fontsize=9.5, fontweight="bold", color=colour)
            word = names[row][column]
            axes.text(column, row - 0.24, word, ha="center", va="center", fontsize=7.5, color=colour)
    axes.set_title("-3 dB frequency [Hz], and the part that limits it", loc="left")
    _bar(figure, mesh, _WIDTH - _SIDE - 0.15, _TOP, height, "")
    return figure


def response_figure(result: LimitsResult) -> Figure:
    """Frequency of 90 degrees of lag, and times of steps up and down."""
    plan = result.plan
    times = [np.array(result.grid(name), dtype=float) for name in ("rise_up", "rise_down")]
    known = np.concatenate([each[np.isfinite(each)] for each in times] or [np.ones(1)])
    span = (float(np.min(known, initial=10.0)), float(np.max(known, initial=1e-3)))
    phase = np.array(result.grid("phase_frequency"), dtype=float)
    panels: list[tuple[str, Any, tuple[float, float], Callable[[float], str]]] = [
        ("-90 deg frequency [Hz]", phase, (plan.lowest, plan.highest), lambda v: _hertz(v, plan.lowest, plan.highest)),
        ("step up, 90 % [ms]", times[0], span, _milliseconds),
        ("step down, 90 % [ms]", times[1], span, _milliseconds),
    ]
    height = len(plan.volumes) * _CELL
    figure = new_figure(_WIDTH, _TOP + height + _FOOT)
    width = (_WIDTH - _LEFT - 0.15 - 2 * 0.25) / 3
    for k, (title, values, limits, text) in enumerate(panels):
        axes = axes_in(figure, _LEFT + k * (width + 0.25), _TOP, width, height)
        _, mark = _heat(axes, values, limits, "viridis" if k == 0 else "viridis_r")
        _volume_axes(axes, plan.volumes, plan.amplitudes, is_first=k == 0)
        _cells(axes, values, text, mark)
        axes.set_title(title, loc="left")
    return figure


def ideal_figure(result: LimitsResult) -> Figure:
    """For every part what the bandwidth would gain by an ideal one."""
    plan = result.plan
    parts = (*PARTS, LOAD)
    height, across = len(plan.volumes) * 0.36, 3
    width = (_WIDTH - _LEFT - _SIDE - 2 * 0.25 - 0.2) / across
    figure = new_figure(_WIDTH, 2 * (_TOP + height) + _FOOT + 0.1)
    for k, part in enumerate(parts):
        left, top = _LEFT + (k % across) * (width + 0.25), _TOP + (k // across) * (_TOP + height)
        axes = axes_in(figure, left, top, width, height)
        values = np.array(result.gains(part), dtype=float)
        mesh, mark = _heat(axes, values, (0.1, 10.0), "RdBu")
        _volume_axes(axes, plan.volumes, plan.amplitudes, is_first=k % across == 0, is_last=k // across == 1)
        _cells(axes, values, lambda v: f"{v:.2g}", mark, size=7.5)
        axes.set_title(part, loc="left", color=_COLOURS[part])
    _bar(figure, mesh, _WIDTH - _SIDE - 0.1, _TOP, 2 * height + _TOP, "bandwidth, ideal / real")
    return figure


def stability_figure(result: LimitsResult) -> Figure:
    """Growth rate of the linear model over volume and damping, and what the full one does after a push."""
    from matplotlib.colors import SymLogNorm

    norm = SymLogNorm(10.0, vmin=-2000.0, vmax=2000.0)
    figure, panels = _spring_panels(result)
    mesh: Any = None
    for axes, spring in panels:
        growth = np.array(result.map("growth", spring), dtype=float)
        mesh = axes.pcolormesh(_edges(growth.shape[1]), _edges(growth.shape[0]), growth, cmap="RdBu_r", norm=norm)
        does = result.map("smooth", spring)
        hum = np.array(result.map("smooth_frequency", spring), dtype=float)
        for row in range(growth.shape[0]):
            for column in range(growth.shape[1]):
                value = growth[row, column]
                light = "white" if abs(value) > 300.0 else INK
                text = f"{value:.3g}" if math.isfinite(value) else "?"
                axes.text(column, row + 0.17, text, ha="center", va="center", fontsize=8.0, color=light)
                word = _does(does[row][column], hum[row, column])
                axes.text(column, row - 0.22, word, ha="center", va="center", fontsize=7.0, color=light)
    _bar(figure, mesh, _WIDTH - _SIDE - 0.1, _TOP, _panel_height(result), "growth of the linear model [1/s]")
    return figure


def hum_figure(result: LimitsResult) -> Figure:
    """What the valve with its bands does by itself: amplitude and frequency at the outlet."""
    figure, panels = _spring_panels(result)
    mesh: Any = None
    for axes, spring in panels:
        amplitude = np.array(result.map("amplitude", spring), dtype=float)
        frequency = np.array(result.map("frequency", spring), dtype=float)
        mesh, mark = _heat(axes, amplitude, (10.0, 1e4), "viridis_r")
        for row in range(amplitude.shape[0]):
            for column in range(amplitude.shape[1]):
                value, colour = amplitude[row, column], mark(amplitude[row, column])
                text = _swing(value)
                axes.text(column, row + 0.17, text, ha="center", va="center", fontsize=8.0, color=colour)
                hertz = frequency[row, column]
                often = (
                    (f"{hertz:.2g} Hz" if hertz < 10.0 else f"{hertz:.0f} Hz") if hertz > 0.0 and value >= STILL else ""
                )
                axes.text(column, row - 0.22, often, ha="center", va="center", fontsize=7.0, color=colour)
    _bar(figure, mesh, _WIDTH - _SIDE - 0.1, _TOP, _panel_height(result), "amplitude at the outlet [Pa]")
    return figure


def _swing(value: float) -> str:
    if not math.isfinite(value):
        return "?"
    if value < STILL:
        return "rests"
    return f"{value:.3g}" if value < 1e3 else f"{value:.0f}"


def _limiting(result: LimitsResult) -> list[list[str]]:
    """The word of each cell: the part that limits, and where that is the load the part of the valve that comes next."""
    rows = []
    for volume in result.plan.volumes:
        words = []
        for amplitude in result.plan.amplitudes:
            point = result.points.get((volume, amplitude))
            word = SHORT.get(point.limiting, "") if point else ""
            if point and point.limiting == LOAD:
                own = {part: gain for part, gain in point.gains.items() if part != LOAD}
                then = max(own, key=lambda part: own[part])
                word += f", {SHORT[then]}" if own[then] >= WORTH else ""
            words.append(word)
        rows.append(words)
    return rows


# Pieces ----------------------------------------------------------------------------------------------------------


def _panel_height(result: LimitsResult) -> float:
    return len(result.plan.dampings) * 0.52


def _spring_panels(result: LimitsResult) -> tuple[Figure, list[tuple[Any, float]]]:
    """One panel per factor on the spring rates, dampings up and volumes across."""
    plan = result.plan
    count, height = len(plan.springs), _panel_height(result)
    figure = new_figure(_WIDTH, _TOP + height + _FOOT)
    width = (_WIDTH - _LEFT - _SIDE - 0.2 - (count - 1) * 0.2) / count
    panels = []
    for k, spring in enumerate(plan.springs):
        axes = axes_in(figure, _LEFT + k * (width + 0.2), _TOP, width, height)
        axes.grid(visible=False)
        axes.set_xticks(range(len(plan.volumes)), [f"{v * 1e3:.2g}" for v in plan.volumes])
        axes.set_yticks(range(len(plan.dampings)), [f"x {d:g}" for d in plan.dampings] if k == 0 else [])
        axes.set_xlabel("load volume [l]")
        axes.set_title(f"spring rate x {spring:g}", loc="left")
        if k == 0:
            axes.set_ylabel("damping")
        panels.append((axes, spring))
    return figure, panels


def _edges(count: int) -> Any:
    return np.arange(count + 1) - 0.5


def _heat(
    axes: Any, values: Any, limits: tuple[float, float], colours: str = "viridis"
) -> tuple[Any, Callable[[float], str]]:
    """A heat map on a logarithmic scale, and the colour in which to write onto it."""
    from matplotlib import colormaps
    from matplotlib.colors import LogNorm

    low, high = limits if limits[0] < limits[1] else (0.5 * limits[0], 2.0 * limits[0])
    norm = LogNorm(low, high, clip=True)
    palette = colormaps[colours].with_extremes(bad="#eceef1")
    shown = np.where(np.isnan(values), np.nan, np.clip(values, low, high))
    mesh = axes.pcolormesh(_edges(values.shape[1]), _edges(values.shape[0]), shown, cmap=palette, norm=norm)
    axes.grid(visible=False)

    def mark(value: float) -> str:
        if math.isnan(value):
            return INK
        red, green, blue, _ = palette(float(norm(min(max(value, low), high))))
        return "white" if 0.3 * red + 0.59 * green + 0.11 * blue < 0.5 else INK

    return mesh, mark


def _volume_axes(
    axes: Any, volumes: Sequence[float], amplitudes: Sequence[float], *, is_first: bool = True, is_last: bool = True
) -> None:
    axes.set_xticks(range(len(amplitudes)), [f"{a / 1e3:.3g}" for a in amplitudes] if is_last else [])
    axes.set_yticks(range(len(volumes)), [f"{v * 1e3:.2g}" for v in volumes] if is_first else [])
    if is_last:
        axes.set_xlabel("amplitude of the setpoint [kPa]")
    if is_first:
        axes.set_ylabel("load volume [l]")


def _cells(
    axes: Any, values: Any, text: Callable[[float], str], mark: Callable[[float], str], size: float = 8.0
) -> None:
    for row in range(values.shape[0]):
        for column in range(values.shape[1]):
            value = float(values[row, column])
            shown = "-" if math.isnan(value) else text(value)
            axes.text(column, row, shown, ha="center", va="center", fontsize=size, color=mark(value))


def _bar(figure: Figure, mesh: Any, left: float, top: float, height: float, label: str) -> None:
    bar = figure.colorbar(mesh, cax=axes_in(figure, left, top, _BAR, height))
    bar.outline.set_visible(False)
    bar.ax.grid(visible=False)
    if label:
        bar.set_label(label)


def _hertz(value: float, lowest: float, highest: float) -> str:
    if math.isnan(value):
        return "-"
    if value == 0.0:
        return f"< {lowest:g}"
    return f"> {highest:g}" if math.isinf(value) else f"{value:.2g}" if value < 100.0 else f"{value:.0f}"


def _milliseconds(value: float) -> str:
    return f"{1e3 * value:.2g}" if value < 0.0995 else f"{1e3 * value:.0f}"


def _does(word: str, frequency: float) -> str:
    if word == OSCILLATES:
        return f"{frequency:.0f} Hz" if math.isfinite(frequency) and frequency > 0.0 else "oscillates"
    return "calm" if word == DECAYS else word

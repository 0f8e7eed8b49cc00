"""Report of the dynamic limits of a valve, with maps of bandwidth, step response, ideal parts and stability."""

from __future__ import annotations

import math
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.bench.limits.bandwidth import WORTH
from poppet.bench.limits.maps import CONTROLLER, INTERRUPTED, LOAD, PARTS, LimitsPlan, LimitsResult
from poppet.bench.limits.stability import DECAYS, OSCILLATES
from poppet.report.html_page import Section, document, findings, folded, head, paragraph, picture, write_page
from poppet.report.tables import ReportTable, numeric
from poppet.timeseries.plotting.figures import GREY, INK, PALETTE, axes_in, new_figure, style

if TYPE_CHECKING:
    from matplotlib.collections import QuadMesh
    from matplotlib.figure import Figure

Array = NDArray[np.float64]
Scale = tuple[str, list[str]]
"""Name and tick labels of an axis."""
STILL = 1.0
"""Amplitude at the outlet below which the valve is at rest [Pa]."""
# Sizes in inches.
_WIDTH, _LEFT, _TOP, _FOOT, _BAR, _SIDE = 10.0, 0.75, 0.4, 0.62, 0.16, 0.75
_CELL, _MAX_COLUMNS = 0.44, 3
_VOLUME = "load volume [l]"
_COLOURS = {part: PALETTE[k] for k, part in enumerate((*PARTS, LOAD))} | {CONTROLLER: GREY}
NOISY = 0.5
"""Motion relative to the fundamental above which a bandwidth is marked as approximate."""
SHORT = {
    "solenoids": "solenoids",
    "pilot volume": "pilot vol.",
    "poppet": "poppet",
    "sonic conductance": "seat C",
    "sensors and sampling": "sensing",
    "load volume": "load",
    CONTROLLER: "controller",
}
"""Mapping from the name of a part to the short name in a cell."""
_IDEALISATIONS = {
    "solenoids": "ten times the sonic conductance of both solenoids",
    "pilot volume": "a tenth of it",
    "poppet": "a tenth of the moving masses, the damping at the same ratio to the critical one",
    "sonic conductance": "ten times C of supply and exhaust seat over the whole stroke",
    "sensors and sampling": "a tenth of both sensors' lags and of both sample times",
    "load volume": "a tenth of it",
}
_EXPLANATION = (
    "<p>Bandwidth: the setpoint is a sine about the mean, and the full model is simulated. A regression over whole "
    "periods after the transient gives the fundamental of the outlet pressure. The bandwidth is the frequency at which "
    "the fundamental is -3 dB of the amplitude of the setpoint, or lags by 90 degrees. Steps go from mean minus "
    "amplitude to mean plus amplitude, and back. Their time is that to 90 % of the change.</p>\n"
    "<p>One part at a time is ideal, and the parameters of the controller do not change. A faster part increases the "
    "gain of its loop: a ratio below one means that the loop is less damped.</p>\n"
    "<p>Growth is the real part of the dominant pole of the linear model over one sample at rest. The linear model has "
    "no hold and dead bands, least duties, delays and quantisation. The second line of each cell shows the full model "
    "without these effects in the two seconds after a disturbance of a few Pa. The last map shows the complete valve."
    "</p>\n"
)


def write_limits(result: LimitsResult, path: str | Path) -> Path:
    """Write the report of the dynamic limits of a valve as a self-contained HTML page."""
    return write_page(path, lambda: limits_page(result))


def limits_page(result: LimitsResult) -> str:
    """Return the report of the dynamic limits of a valve as HTML."""
    plan = result.plan
    title = f"{plan.circuit.title or plan.valve}: dynamic limits"
    lead = (
        f"Valve {plan.valve} at {plan.mean / 1e5:.3g} bar, filling {plan.outlet}: the limiting part by load volume and "
        "amplitude, and limit cycles."
    )
    is_stopped = result.outcome == INTERRUPTED
    with style("A report of dynamic limits"):
        sections = [
            Section("", head(title, lead) + paragraph("Interrupted: missing points are grey." if is_stopped else "")),
            Section("Findings", findings(result.findings)),
            Section("Bandwidth", _bandwidth(result) if result.points else ""),
            Section("Ideal parts", _ideal_parts(result) if result.points else ""),
            Section("Stability", _stability(result) if result.stability else ""),
            Section("Explanation", _EXPLANATION),
        ]
    return document(title, sections, style="details { margin: .6rem 0; } summary { cursor: pointer; }\n")


def _bandwidth(result: LimitsResult) -> list[str]:
    caption = (
        "-3 dB frequency of the full model. Second line: the part whose ideal form increases the bandwidth most "
        "(behind the load, the second part of the valve), or controller if no part increases it by "
        f"{100.0 * (WORTH - 1.0):.0f} %. The sign ~ marks points at which the rest of the motion is more than half of "
        "the fundamental."
    )
    response_caption = "Frequency of 90 degrees of lag, and times to 90 % of a step of twice the amplitude."
    rows = []
    for (volume, amplitude), p in result.points.items():
        frequencies = (
            "-" if math.isnan(value) else frequency_text(result.plan, value)
            for value in (p.gain_frequency, p.phase_frequency)
        )
        times = ("-" if math.isnan(value) else time_text(value) for value in (p.rise_up, p.rise_down))
        noise = "-" if math.isnan(p.noise) else f"{100.0 * p.noise:.2g}"
        case = f"{volume * 1e3:.3g} l, {amplitude / 1e3:.3g} kPa"
        rows.append((case, *frequencies, *times, noise, p.limiting or "-"))
    headings = "-3 dB [Hz]", "-90 deg [Hz]", "step up [ms]", "step down [ms]", "residual motion [%]"
    return [
        picture(bandwidth_figure(result), "bandwidth", caption),
        picture(response_figure(result), "response", response_caption),
        folded("The values as a table", ReportTable(("load, amplitude", *numeric(*headings), "limited by"), rows)),
    ]


def _ideal_parts(result: LimitsResult) -> list[str | ReportTable]:
    rows = []
    for part in (*PARTS, LOAD):
        gains = [value for row in result.gains(part) for value in row if math.isfinite(value)]
        n_limited = sum(point.limiting == part for point in result.points.values())
        span = f"{min(gains):.2g} to {max(gains):.2g}" if gains else "-"
        rows.append((part, _IDEALISATIONS[part], span, str(n_limited)))
    table = ReportTable(("part", "ideal form", *numeric("bandwidth, ideal / real", "limits at points")), rows)
    caption = "Bandwidth with one ideal part divided by that of the real valve; blue: larger, red: smaller."
    return [table, picture(ideal_figure(result), "ideal", caption)]


def _stability(result: LimitsResult) -> list[str | ReportTable]:
    caption = (
        "Growth rate of the linear model; red: unstable. Second line: full model without bands after a small "
        "disturbance: calm, or the frequency of its limit cycle."
    )
    cycle_caption = "The complete valve at a constant setpoint: amplitude and frequency of the outlet pressure."
    rows = [
        (
            f"x {s:g}, x {d:g}, {v * 1e3:.3g} l",
            f"{point.growth:.3g}" if math.isfinite(point.growth) else "?",
            motion_text(point.smooth, point.smooth_frequency),
            amplitude_text(point.amplitude),
            f"{point.frequency:.3g}" if math.isfinite(point.frequency) else "-",
        )
        for (s, d, v), point in result.stability.items()
    ]
    cases, motion = numeric("growth [1/s]"), numeric("complete valve [Pa]", "at [Hz]")
    values = ReportTable(("spring, damping, volume", *cases, "after a disturbance", *motion), rows)
    differing = [
        (f"{s:g}", f"{d:g}", f"{v * 1e3:.3g} l", point.word)
        for (s, d, v), point in result.stability.items()
        if not point.agrees
    ]
    text = "<p>Cases in which the linear model and the full model without bands disagree:</p>\n" if differing else ""
    return [
        picture(stability_figure(result), "stability", caption),
        picture(limit_cycle_figure(result), "hum", cycle_caption),
        folded("The values as a table", values),
        text,
        ReportTable((*numeric("spring", "damping", "volume"), "reason"), differing),
    ]


def bandwidth_figure(result: LimitsResult) -> Figure:
    """Draw a map of the bandwidth by load volume and amplitude of the setpoint.

    Each cell also names the part that limits the bandwidth.
    """
    plan = result.plan
    height = len(plan.volumes) * 0.62
    figure, (axes,) = _figure_with_panels(1, height, _SIDE + 0.35, 0.0)
    values, noise = (_array(result.bandwidth_map(name)) for name in ("gain_frequency", "noise"))
    mesh, mark = _draw_heat_map(axes, values, (plan.lowest, plan.highest))
    _volume_axes(axes, plan)
    hertz = _cell_formatter(values, lambda v: frequency_text(plan, v))
    rough = _CellLine(0.13, 9.5, lambda cell: f"~{hertz(cell)}" if noise[cell] > NOISY else hertz(cell), "bold")

    def limiting_part(cell: tuple[int, int]) -> str:
        point = result.points.get((plan.volumes[cell[0]], plan.amplitudes[cell[1]]))
        if point is None or not point.limiting:
            return ""
        # Behind the load, the valve part with the largest effect.
        gains = {part: gain for part, gain in point.gains.items() if part != LOAD}
        second = max(gains, key=lambda part: gains[part]) if point.limiting == LOAD else ""
        return SHORT[point.limiting] + (f", {SHORT[second]}" if second and gains[second] >= WORTH else "")

    _write(axes, values, mark, rough, _CellLine(-0.24, 7.5, limiting_part))
    axes.set_title("-3 dB frequency [Hz], and the part that limits it", loc="left")
    _bar(figure, mesh, _WIDTH - _SIDE - 0.15, height, "")
    return figure


def response_figure(result: LimitsResult) -> Figure:
    """Draw maps of the frequency with 90 degrees of lag and of step times.

    The axes of each map are amplitude and load volume. There is one map for steps up and one for steps down.
    """
    plan = result.plan
    phase, up, down = (_array(result.bandwidth_map(name)) for name in ("phase_frequency", "rise_up", "rise_down"))
    times = np.concatenate([grid[np.isfinite(grid)] for grid in (up, down)])
    # Both steps have one scale. Without times the minimum exceeds the maximum; `_draw_heat_map` corrects this.
    span = (float(np.min(times, initial=10.0)), float(np.max(times, initial=1e-3)))
    maps: list[tuple[str, Array, tuple[float, float], str, Callable[[float], str]]] = [
        ("-90 deg frequency [Hz]", phase, (plan.lowest, plan.highest), "viridis", lambda v: frequency_text(plan, v)),
        ("step up, 90 % [ms]", up, span, "viridis_r", time_text),
        ("step down, 90 % [ms]", down, span, "viridis_r", time_text),
    ]
    figure, panels = _figure_with_panels(3, len(plan.volumes) * _CELL, 0.15, 0.25)
    for k, (axes, (title, values, limits, colours, text)) in enumerate(zip(panels, maps, strict=True)):
        _, mark = _draw_heat_map(axes, values, limits, colours)
        _volume_axes(axes, plan, is_first=k == 0)
        _write(axes, values, mark, _CellLine(0.0, 8.0, _cell_formatter(values, text)))
        axes.set_title(title, loc="left")
    return figure


def ideal_figure(result: LimitsResult) -> Figure:
    """Draw maps of the bandwidth with one ideal part, relative to the real bandwidth.

    There is one map per part. Its axes are amplitude and load volume.
    """
    plan = result.plan
    height = len(plan.volumes) * 0.36
    figure, panels = _figure_with_panels(2 * _MAX_COLUMNS, height, _SIDE + 0.2, 0.25)
    for k, (axes, part) in enumerate(zip(panels, (*PARTS, LOAD), strict=True)):
        values = _array(result.gains(part))
        mesh, mark = _draw_heat_map(axes, values, (0.1, 10.0), "RdBu")
        _volume_axes(axes, plan, is_first=k % _MAX_COLUMNS == 0, is_last=k >= _MAX_COLUMNS)
        _write(axes, values, mark, _CellLine(0.0, 7.5, _cell_formatter(values, lambda v: f"{v:.2g}")))
        axes.set_title(part, loc="left", color=_COLOURS[part])
    _bar(figure, mesh, _WIDTH - _SIDE - 0.1, 2 * height + _TOP, "bandwidth, ideal / real")
    return figure


def stability_figure(result: LimitsResult) -> Figure:
    """Draw maps of the growth rate of the linear model, one for each spring factor.

    Each cell also describes the motion of the nonlinear model after a disturbance.
    """
    from matplotlib.colors import SymLogNorm

    norm = SymLogNorm(10.0, vmin=-2000.0, vmax=2000.0)

    def draw(axes: Any, spring: float) -> QuadMesh:
        growth, hum = (_array(result.stability_map(name, spring)) for name in ("growth", "smooth_frequency"))
        does = np.array(result.stability_map("smooth", spring))
        _write(
            axes, growth, lambda v: "white" if abs(v) > 300.0 else INK,
            _CellLine(0.17, 8.0, lambda cell: f"{growth[cell]:.3g}" if math.isfinite(growth[cell]) else "?"),
            _CellLine(-0.22, 7.0, lambda cell: motion_text(does[cell], hum[cell])),
        )  # fmt: skip
        return _mesh(axes, growth, cmap="RdBu_r", norm=norm)

    return _spring_figure(result, draw, "growth of the linear model [1/s]")


def limit_cycle_figure(result: LimitsResult) -> Figure:
    """Draw maps of the limit cycles of the complete valve, one for each spring factor.

    Limit cycles are self-excited oscillations. Each cell contains amplitude and frequency.
    """

    def draw(axes: Any, spring: float) -> QuadMesh:
        amplitude, frequency = (_array(result.stability_map(name, spring)) for name in ("amplitude", "frequency"))
        mesh, mark = _draw_heat_map(axes, amplitude, (10.0, 1e4), "viridis_r")

        def frequency_word(cell: Any) -> str:
            hertz = frequency[cell]
            if not hertz > 0.0 or not amplitude[cell] >= STILL:
                return ""
            return f"{hertz:.2g} Hz" if hertz < 10.0 else f"{hertz:.0f} Hz"

        first = _CellLine(0.17, 8.0, lambda cell: amplitude_text(amplitude[cell]))
        _write(axes, amplitude, mark, first, _CellLine(-0.22, 7.0, frequency_word))
        return mesh

    return _spring_figure(result, draw, "amplitude at the outlet [Pa]")


def amplitude_text(value: float) -> str:
    """Return an amplitude of the outlet pressure [Pa] as text.

    The text is `rests` if the amplitude is below 1 Pa, and `?` if `value` is NaN or infinite.
    """
    if not math.isfinite(value):
        return "?"
    if value < STILL:
        return "rests"
    return f"{value:.3g}" if value < 1e3 else f"{value:.0f}"


class _CellLine(NamedTuple):
    """Line of text in each cell of a map: position, size and content."""

    up: float  # distance from the centre
    size: float  # of the font
    text: Callable[[Any], str]  # text of a cell
    weight: str = "normal"


def _write(axes: Any, values: Array, colour: Callable[[float], str], *lines: _CellLine) -> None:
    for cell, value in np.ndenumerate(values):
        alignment = {"ha": "center", "va": "center", "color": colour(float(value))}
        for up, size, text, weight in lines:
            axes.text(cell[1], cell[0] + up, text(cell), fontsize=size, fontweight=weight, **alignment)


def _cell_formatter(values: Array, text: Callable[[float], str]) -> Callable[[Any], str]:
    """Return a function that formats the value of a cell, given its index.

    The function returns a dash for NaN, and otherwise the result of `text`.
    """
    return lambda cell: "-" if math.isnan(values[cell]) else text(float(values[cell]))


def _array(grid: list[list[Any]]) -> Array:
    return np.array(grid, dtype=float)


def _figure_with_panels(count: int, height: float, right: float, gap: float) -> tuple[Figure, list[Any]]:
    """Return an empty figure, and a list of `count` axes of equal size in this figure.

    `height` is the height of each of the axes, `right` is the right margin of the figure, and `gap` is the horizontal
    distance between neighbouring axes [in]. The axes are in one row, or in two rows if `count` is six.
    """
    columns = _MAX_COLUMNS if count == 2 * _MAX_COLUMNS else count
    rows = count // columns
    figure = new_figure(_WIDTH, rows * (_TOP + height) + _FOOT + 0.1 * (rows - 1))
    width = (_WIDTH - _LEFT - right - (columns - 1) * gap) / columns
    cells = [divmod(k, columns) for k in range(count)]
    return figure, [
        axes_in(figure, _LEFT + column * (width + gap), _TOP + row * (_TOP + height), width, height)
        for row, column in cells
    ]


def _spring_figure(result: LimitsResult, draw: Callable[[Any, float], Any], label: str) -> Figure:
    """Draw one map for each factor on the spring rates.

    The axes of a map are load volume and damping factor. The function `draw` draws one map, and `label` is the label of
    the colour bar.
    """
    plan = result.plan
    height = len(plan.dampings) * 0.52
    figure, panels = _figure_with_panels(len(plan.springs), height, _SIDE + 0.2, 0.2)
    for k, (axes, spring) in enumerate(zip(panels, plan.springs, strict=True)):
        mesh = draw(axes, spring)
        y_scale = ("damping", [f"x {d:g}" for d in plan.dampings])
        _label_axes(axes, (_VOLUME, _liters(plan)), y_scale, is_first=k == 0)
        axes.set_title(f"spring rate x {spring:g}", loc="left")
    _bar(figure, mesh, _WIDTH - _SIDE - 0.1, height, label)
    return figure


def _mesh(axes: Any, values: Array, **options: Any) -> QuadMesh:
    x, y = (np.arange(count + 1) - 0.5 for count in values.shape[::-1])  # cells about whole numbers
    mesh: QuadMesh = axes.pcolormesh(x, y, values, **options)
    return mesh


def _draw_heat_map(
    axes: Any, values: Array, limits: tuple[float, float], colours: str = "viridis"
) -> tuple[QuadMesh, Callable[[float], str]]:
    """Draw a map of values in colours on a logarithmic scale.

    `values` has shape (rows, columns), and `limits` are the ends of the colour scale. The second item of the result is
    a function that returns a readable text colour for a value.
    """
    from matplotlib import colormaps
    from matplotlib.colors import LogNorm

    low, high = limits if limits[0] < limits[1] else (0.5 * limits[0], 2.0 * limits[0])
    norm = LogNorm(low, high, clip=True)
    palette = colormaps[colours].with_extremes(bad="#eceef1")
    # Infinite values have the last colour of the scale. Only missing values are grey.
    mesh = _mesh(axes, np.clip(values, low, high), cmap=palette, norm=norm)

    def mark(value: float) -> str:
        if math.isnan(value):
            return INK
        # Luminance: green looks brighter than red, and red looks brighter than blue.
        red, green, blue, _ = palette(float(norm(min(max(value, low), high))))
        return "white" if 0.3 * red + 0.59 * green + 0.11 * blue < 0.5 else INK

    return mesh, mark


def _volume_axes(axes: Any, plan: LimitsPlan, *, is_first: bool = True, is_last: bool = True) -> None:
    x_scale = ("amplitude of the setpoint [kPa]", [f"{a / 1e3:.3g}" for a in plan.amplitudes])
    _label_axes(axes, x_scale, (_VOLUME, _liters(plan)), is_first=is_first, is_last=is_last)


def _liters(plan: LimitsPlan) -> list[str]:
    return [f"{v * 1e3:.2g}" for v in plan.volumes]


def _label_axes(axes: Any, x_scale: Scale, y_scale: Scale, *, is_first: bool = True, is_last: bool = True) -> None:
    """Set the names and tick labels of both axes of a map.

    The keyword `is_first` is False if the panel is not the first of its row: it then has no labels at the left. The
    keyword `is_last` is False if there is another panel below: the panel then has no labels at the bottom.
    """
    axes.grid(visible=False)
    (x_name, x), (y_name, y) = x_scale, y_scale
    axes.set_xticks(range(len(x)), x if is_last else [])
    axes.set_yticks(range(len(y)), y if is_first else [])
    axes.set(xlabel=x_name if is_last else "", ylabel=y_name if is_first else "")


def _bar(figure: Figure, mesh: Any, left: float, height: float, label: str) -> None:
    bar = figure.colorbar(mesh, cax=axes_in(figure, left, _TOP, _BAR, height))
    bar.outline.set_visible(False)
    bar.ax.grid(visible=False)
    bar.set_label(label)


def frequency_text(plan: LimitsPlan, value: float) -> str:
    """Return a frequency [Hz] as text.

    The value 0 stands for a frequency below the search range, and infinity for one above it.
    """
    if value == 0.0:  # below the range
        return f"< {plan.lowest:g}"
    return f"> {plan.highest:g}" if math.isinf(value) else f"{value:.2g}" if value < 100.0 else f"{value:.0f}"


def time_text(value: float) -> str:
    """Return a time [s] as text in milliseconds, without the unit."""
    return f"{1e3 * value:.2g}" if value < 0.0995 else f"{1e3 * value:.0f}"


def motion_text(motion: str, frequency: float) -> str:
    """Return the motion of the nonlinear model after a disturbance as text.

    The text is the frequency [Hz] of an oscillation, `calm` for a decay, or `motion` itself.
    """
    if motion == OSCILLATES:
        return f"{frequency:.0f} Hz" if math.isfinite(frequency) and frequency > 0.0 else "oscillates"
    return "calm" if motion == DECAYS else motion

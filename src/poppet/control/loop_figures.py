"""Figures of tuned loops: Bode plot with margins, and step responses with overshoot and settling time."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

import numpy as np

from poppet.control.loop import Array, Gains, LoopPlant, Margins, SampledPlant, disturbance_response, step_response
from poppet.control.metrics import readable_unit_of
from poppet.control.verification import Verification
from poppet.core.number_format import pretty
from poppet.core.units import convert
from poppet.parts.quantities import COMMANDS, QUANTITIES
from poppet.timeseries.plotting.figures import (
    ACCENT,
    GREY,
    INK,
    PALETTE,
    axes_in,
    new_figure,
    save_figure,
    style,
    widest,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

MAX_SAMPLES = 2000
"""Maximum number of samples of a step response."""
BAND = 0.02
"""Half width of the band in which a response has settled, as a fraction of the step or of the largest deviation."""
DECADES = 2.0
"""Width of the frequency range below the lowest crossover [decades]."""
POINTS = 600
"""Number of frequencies of a curve."""
_WIDTH, _LEFT, _HEIGHT, _GAP, _AXIS, _LEGEND_ROW = 10.0, 1.0, 1.7, 0.25, 0.3, 0.2


class TuningResult(Protocol):
    """Result of a tuning that the figures show; `poppet.control.Tuning` has its attributes."""

    @property
    def points(self) -> Sequence[Any]:
        """Operating points with gains, plants, margins and verifications."""

    @property
    def sensitivity(self) -> float:
        """Bound of Ms and Mt."""

    @property
    def quantity(self) -> str:
        """Controlled quantity."""

    @property
    def command_quantity(self) -> str:
        """Commanded quantity."""

    @property
    def is_verified(self) -> bool:
        """True if the plant was measured with sines."""


class TunedLoop(NamedTuple):
    """Loop of one operating point and one side of the command, with its label and colour."""

    name: str
    plant: LoopPlant
    gains: Gains
    setpoint_weight: float
    margins: Margins
    colour: str


class StepCourse(NamedTuple):
    """Response of a loop to a step, with its metrics.

    `peak` is the index of the largest value, and `settling_time` the time after which the response remains in the band
    [s]; it is infinite if the response does not settle.
    """

    name: str
    time: Array
    values: Array
    peak: int
    settling_time: float


def tuning_figure(tuning: TuningResult, path: str | Path | None = None) -> Figure:
    """Draw the Bode plots and the step responses of a tuning in one figure."""
    with style("A figure of a tuning", path):
        loops = [*_loops(tuning)]
        figure, (bode, *steps) = _stacked(loops, (3, *_step_groups(tuning)))
        _draw_bode(bode, loops, tuning.sensitivity)
        _draw_steps([panel for group in steps for panel in group], loops, tuning)
        return save_figure(figure, path)


def bode_figure(
    tuning: TuningResult, path: str | Path | None = None, *, present: Mapping[str, Gains] | None = None
) -> Figure:
    """Draw the open loops of a tuning: magnitude and phase with margins, and the sensitivity with its bound.

    Circles mark the crossovers, squares the frequencies that determine the gain margins. Vertical lines show the
    smallest margins of all loops. The loops are those of the sampled controller with its delay. Thin dashed lines show
    the loops with other gains, `present`, by the label of a loop.
    """
    with style("A Bode plot", path):
        loops = [*_loops(tuning)]
        figure, (panels,) = _stacked(loops, (3,))
        _draw_present(panels, loops, present or {})
        _draw_bode(panels, loops, tuning.sensitivity)
        return save_figure(figure, path)


def step_figure(tuning: TuningResult, path: str | Path | None = None) -> Figure:
    """Draw the responses to a step of the setpoint and of a disturbance, with overshoot and settling time.

    The largest overshoot and the longest settling time are marked. The responses are those of the linear sampled loops.
    For plants that were measured with sines, the figure shows the simulated setpoint steps instead.
    """
    with style("A figure of step responses", path):
        loops = [*_loops(tuning)]
        figure, groups = _stacked(loops, _step_groups(tuning))
        _draw_steps([panel for group in groups for panel in group], loops, tuning)
        return save_figure(figure, path)


def _step_groups(tuning: TuningResult) -> tuple[int, ...]:
    return (1,) if tuning.is_verified else (1, 1)


def _draw_bode(panels: Sequence[Any], loops: list[TunedLoop], bound: float) -> None:
    """Draw magnitude, phase and sensitivity of all loops into three panels."""
    upper, middle, lower = panels
    for loop in loops:
        frequencies = _frequencies(loops, loop.plant)
        response = _open_loop(loop, frequencies)
        phase = phase_of(response)
        line: dict[str, Any] = {"color": loop.colour, "linewidth": 1.2, "label": loop.name}
        upper.plot(frequencies, 20.0 * np.log10(np.abs(response)), **line)
        middle.plot(frequencies, phase, **line)
        lower.plot(frequencies, np.abs(1.0 / (1.0 + response)), **line)
        _mark(upper, middle, loop, frequencies, phase)
    lower.axhline(bound, color=GREY, linewidth=0.9, linestyle=(0, (2, 2)), label="bound")
    upper.axhline(0.0, color=GREY, linewidth=0.9)
    middle.axhline(-180.0, color=GREY, linewidth=0.9)
    for axes in (upper, middle, lower):
        axes.set_xscale("log")
        axes.set_xlim(*_limits(loops))
    lowest = min(middle.get_ylim()[0], -200.0)
    middle.set_ylim(max(lowest, -360.0), middle.get_ylim()[1])
    upper.set_ylim(max(upper.get_ylim()[0], -60.0), upper.get_ylim()[1])
    _mark_smallest(upper, middle, loops)
    upper.set_ylabel("magnitude |L|\n[dB]")
    middle.set_ylabel("phase of L\n[deg]")
    lower.set(xlabel="frequency [Hz]", ylabel="sensitivity\n|S| [1]")


def _draw_present(panels: Sequence[Any], loops: list[TunedLoop], present: Mapping[str, Gains]) -> None:
    """Draw thin dashed lines of the loops with other gains; an unstable loop has no sensitivity."""
    upper, middle, lower = panels
    for loop in loops:
        if loop.name not in present:
            continue
        frequencies = _frequencies(loops, loop.plant)
        response = _open_loop(loop._replace(gains=present[loop.name]), frequencies)
        line: dict[str, Any] = {"color": loop.colour, "linewidth": 0.7, "linestyle": "--"}
        line["label"] = f"{loop.name}, present gains"
        upper.plot(frequencies, 20.0 * np.log10(np.abs(response)), **line)
        middle.plot(frequencies, phase_of(response), **line)
        if loop.plant.is_stable_with(present[loop.name]):
            lower.plot(frequencies, np.abs(1.0 / (1.0 + response)), **line)


def _draw_steps(axes: Sequence[Any], loops: list[TunedLoop], tuning: TuningResult) -> None:
    """Draw the responses to setpoint steps, and in a second panel those to disturbances."""
    setpoint = step_courses(tuning)
    colours = {loop.name: loop.colour for loop in loops}
    for course in setpoint:
        colour = colours.get(course.name, INK)
        axes[0].plot(course.time, course.values, color=colour, linewidth=1.2, label=course.name)
    axes[0].axhline(1.0, color=GREY, linewidth=0.8)
    axes[0].axhspan(1.0 - BAND, 1.0 + BAND, color=GREY, alpha=0.18, linewidth=0.0)
    axes[0].set_ylabel("measurement per\nsetpoint step [1]")
    _mark_setpoint(axes[0], setpoint)
    disturbed = disturbance_courses(tuning)
    if disturbed:
        for course in disturbed:
            axes[1].plot(course.time, course.values, color=colours[course.name], linewidth=1.2, label=course.name)
        axes[1].axhline(0.0, color=GREY, linewidth=0.8)
        axes[1].set_ylabel(f"measurement per\ncommand step\n[{_disturbance_unit(tuning)}]", parse_math=False)
        _mark_disturbance(axes[1], disturbed, _disturbance_unit(tuning))
    courses = [*setpoint, *disturbed]
    settled = max((c.settling_time for c in courses if math.isfinite(c.settling_time)), default=math.inf)
    for panel in axes:
        panel.set_xlim(0.0, min(2.5 * settled, max(float(course.time[-1]) for course in courses)))
    for panel in axes:
        panel.set_xlabel("time [s]")


def step_courses(tuning: TuningResult) -> list[StepCourse]:
    """Return the responses of all loops of a tuning to a unit step of the setpoint."""
    if tuning.is_verified:
        return [_verified_course(run) for point in tuning.points for run in point.verified]
    courses = []
    for loop, samples in _linear_loops(tuning):
        values = step_response(loop.plant, loop.gains, loop.setpoint_weight, samples)
        courses.append(_course(loop.name, loop.plant.sample_time * np.arange(samples), values, 1.0))
    return courses


def disturbance_courses(tuning: TuningResult) -> list[StepCourse]:
    """Return the responses of all loops to a unit step that is added to the command, in readable units.

    Plants that were measured with sines have none.
    """
    unit, command_unit = _units(tuning)
    factor = convert(1.0, unit, readable_unit_of(unit)) / convert(1.0, command_unit, readable_unit_of(command_unit))
    courses = []
    for loop, samples in _linear_loops(tuning):
        values = factor * disturbance_response(loop.plant, loop.gains, samples)
        courses.append(_course(loop.name, loop.plant.sample_time * np.arange(samples), values, 0.0))
    return courses


def _linear_loops(tuning: TuningResult) -> Iterator[tuple[Any, int]]:
    """Yield each loop with a linear plant, and the number of samples of its response."""
    for loop in _loops(tuning):
        if isinstance(loop.plant, SampledPlant):
            length = max(loop.gains.integral_time, 1.0 / (2.0 * math.pi * max(loop.margins.crossover, 1e-9)))
            yield loop, max(min(MAX_SAMPLES, int(12.0 * length / loop.plant.sample_time)), 2)


def _course(name: str, time: Array, values: Array, target: float) -> StepCourse:
    """Return a response with its peak and its settling time; `target` is the final value."""
    peak = int(np.argmax(values if target else np.abs(values)))
    size = abs(target) or abs(float(values[peak])) or 1.0
    is_outside = np.abs(values - target) > BAND * size
    last = int(np.flatnonzero(is_outside)[-1]) if is_outside.any() else -1
    settling_time = float(time[last + 1]) if last + 1 < len(time) else math.inf
    return StepCourse(name, time, values, peak, settling_time)


def _verified_course(run: Verification) -> StepCourse:
    time, values = run.time - run.time[0], (run.measured - run.setpoint[0]) / run.step
    # The first step only; its reverse follows.
    is_first = run.setpoint == run.setpoint[len(run.setpoint) // 4]
    end = int(np.flatnonzero(is_first)[-1]) + 1
    return _course(run.at, time[:end], values[:end], 1.0)


def _units(tuning: TuningResult) -> tuple[str, str]:
    return QUANTITIES[tuning.quantity].unit, COMMANDS[tuning.command_quantity].unit


def _disturbance_unit(tuning: TuningResult) -> str:
    unit, command_unit = (pretty(readable_unit_of(name)) for name in _units(tuning))
    return unit if command_unit == "1" else f"{unit} per {command_unit}"


def _loops(tuning: TuningResult) -> Iterator[TunedLoop]:
    colours = iter(PALETTE * 4)
    for point in tuning.points:
        for name, plant in point.plants.items():
            yield TunedLoop(name, plant, point.gains, point.setpoint_weight, point.margins[name], next(colours))


def _stacked(loops: list[TunedLoop], groups: Sequence[int]) -> tuple[Figure, list[list[Any]]]:
    """Return a figure with groups of panels one below the other, and a legend of the loops above them.

    `groups` contains the number of panels in each group; the panels of a group share their horizontal axis.
    """
    from matplotlib.lines import Line2D

    columns = max(1, int((_WIDTH - _LEFT) / (0.5 + widest([loop.name for loop in loops], 8.0))))
    top = 0.15 + _LEGEND_ROW * -(-len(loops) // columns)
    figure = new_figure(_WIDTH, top + sum(groups) * (_HEIGHT + _GAP) + len(groups) * _AXIS)
    panels: list[list[Any]] = []
    for count in groups:
        group: list[Any] = []
        for k in range(count):
            box = _LEFT, top, _WIDTH - _LEFT - 0.2, _HEIGHT
            group.append(axes_in(figure, *box, sharex=group[0] if group else None))
            group[-1].tick_params(labelbottom=k == count - 1)
            top += _HEIGHT + _GAP
        top += _AXIS
        panels.append(group)
    handles = [Line2D([], [], color=loop.colour, label=loop.name) for loop in loops]
    place = {"loc": "upper left", "bbox_to_anchor": (_LEFT / _WIDTH, 1.0), "borderaxespad": 0.0}
    figure.legend(handles=handles, **place, ncols=columns, fontsize=8.0)
    return figure, panels


def _frequencies(loops: list[TunedLoop], plant: LoopPlant) -> Array:
    low, _ = _limits(loops)
    return np.geomspace(low, 0.5 / plant.sample_time, POINTS)


def _limits(loops: list[TunedLoop]) -> tuple[float, float]:
    """Return the ends of the frequency axis [Hz]: below the lowest crossover, and half the sampling frequency."""
    highest = 0.5 / loops[0].plant.sample_time
    crossovers = [loop.margins.crossover for loop in loops if loop.margins.crossover > 0.0]
    return min(crossovers, default=highest / 10.0**DECADES) / 10.0**DECADES, highest


def _open_loop(loop: TunedLoop, frequencies: Array) -> Any:
    z = loop.plant.at(frequencies)
    return loop.gains.response(z, loop.plant.sample_time) * loop.plant.response(z)


def phase_of(response: Any) -> Array:
    """Return the continuous phase of a response [deg], which begins between -315 and 45 degrees.

    Heat exchange with the wall can let the phase of a proportional loop begin above 0.
    """
    phase = np.degrees(np.unwrap(np.angle(response)))
    return np.asarray(phase - 360.0 * math.ceil((phase[0] - 45.0) / 360.0))


def _phase_at(frequency: float, frequencies: Array, phase: Array) -> float:
    return float(np.interp(math.log(frequency), np.log(frequencies), phase))


def _mark(upper: Any, middle: Any, loop: TunedLoop, frequencies: Array, phase: Array) -> None:
    """Mark the crossover of a loop and the frequencies of its gain margins in both panels."""
    margins = loop.margins
    for frequency, level, marker in (
        (margins.phase_frequency, 0.0, "o"),
        (margins.gain_frequency, -20.0 * math.log10(margins.gain_margin), "s"),
        (margins.lower_gain_frequency, -20.0 * math.log10(margins.lower_gain_margin or 1.0), "s"),
    ):
        if frequency > 0.0:
            point: dict[str, Any] = {"color": loop.colour, "markersize": 4.5, "linestyle": "none", "marker": marker}
            upper.plot([frequency], [level], **point)
            middle.plot([frequency], [_phase_at(frequency, frequencies, phase)], **point)


def _mark_smallest(upper: Any, middle: Any, loops: list[TunedLoop]) -> None:
    """Draw the smallest gain margin and the smallest phase margin as vertical lines with their values."""
    text: dict[str, Any] = {"fontsize": 8.0, "color": ACCENT, "ha": "right"}
    line: dict[str, Any] = {"color": ACCENT, "linewidth": 2.0}
    by_gain = min(loops, key=lambda loop: loop.margins.gain_margin)
    by_phase = min(loops, key=lambda loop: loop.margins.phase_margin)
    if math.isfinite(by_gain.margins.gain_margin):
        margins = by_gain.margins
        level = 20.0 * math.log10(margins.gain_margin)
        upper.plot([margins.gain_frequency] * 2, [-level, 0.0], **line)
        label = f"gain margin {margins.gain_margin:.3g} = {level:.3g} dB ({by_gain.name})"
        if lower := max(loop.margins.lower_gain_margin for loop in loops):
            label += f", lower {lower:.3g}"
        # Above the curve, which falls.
        upper.text(upper.get_xlim()[1], 0.75 * upper.get_ylim()[1], f"{label} ", va="center", **text)
    if math.isfinite(by_phase.margins.phase_margin):
        margins = by_phase.margins
        frequencies = _frequencies(loops, by_phase.plant)
        phase = _phase_at(margins.phase_frequency, frequencies, phase_of(_open_loop(by_phase, frequencies)))
        nearest = 360.0 * round((phase + 180.0) / 360.0) - 180.0
        middle.plot([margins.phase_frequency] * 2, [nearest, phase], **line)
        label = f"phase margin {margins.phase_margin:.3g}° at {margins.phase_frequency:.3g} Hz ({by_phase.name})"
        # Below the limit of stability, from the left edge: the text also fits on a telephone.
        level = nearest - 0.3 * (nearest - middle.get_ylim()[0])
        middle.text(middle.get_xlim()[0], level, f" {label}", va="center", **{**text, "ha": "left"})


def _mark_setpoint(axes: Any, courses: list[StepCourse]) -> None:
    """Mark the largest overshoot and the longest settling time of setpoint steps."""
    text: dict[str, Any] = {"fontsize": 8.0, "color": ACCENT}
    highest = max(courses, key=lambda course: float(course.values[course.peak]))
    peak, when = float(highest.values[highest.peak]), float(highest.time[highest.peak])
    if peak > 1.0 + 1e-3:
        axes.plot([when] * 2, [1.0, peak], color=ACCENT, linewidth=2.0)
        axes.text(when, peak, f" overshoot {100.0 * (peak - 1.0):.2g} % ({highest.name})", va="bottom", **text)
    _mark_settling(axes, courses, 0.45)
    low, high = axes.get_ylim()
    axes.set_ylim(low, max(high, peak + 0.12))


def _mark_disturbance(axes: Any, courses: list[StepCourse], unit: str) -> None:
    """Mark the largest deviation and the longest settling time after disturbances."""
    highest = max(courses, key=lambda course: abs(float(course.values[course.peak])))
    value, when = float(highest.values[highest.peak]), float(highest.time[highest.peak])
    axes.plot([when], [value], "o", color=ACCENT, markersize=4.5)
    label = f"  maximum {value:.3g} {unit} ({highest.name})"
    axes.text(when, value, label, fontsize=8.0, color=ACCENT, va="center")
    _mark_settling(axes, courses, 0.6 * value)


def _mark_settling(axes: Any, courses: list[StepCourse], height: float) -> None:
    slowest = max(courses, key=lambda course: course.settling_time)
    if math.isfinite(slowest.settling_time):
        axes.axvline(slowest.settling_time, color=ACCENT, linewidth=1.0, linestyle=(0, (4, 2)))
        label = f"settled within {100.0 * BAND:g} % after {slowest.settling_time:.3g} s ({slowest.name})"
        axes.text(slowest.settling_time, height, f" {label}", fontsize=8.0, color=ACCENT, va="center")

"""Function diagram of a step sequence: displacements and outputs versus steps and versus time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.errors import InputError, NameSuggestion
from poppet.parts import Cylinder, Sequence
from poppet.parts.part import Body
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.plotting.figures import (
    FAINT,
    GREY,
    INK,
    PALETTE,
    axes_in,
    check_format,
    new_figure,
    save_figure,
    style,
    text_width,
    widest,
)

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from poppet.circuit.circuit import BaseCircuit
    from poppet.timeseries.recording import Recording

MOST_COLUMNS = 60
"""Maximum number of steps in the displacement-step diagram."""
MARGIN = 0.02
"""Margin above and below a displacement, as a fraction of the stroke."""

# Sizes in inches, text in points.
_WIDTH, _RIGHT, _ROW, _SIGNAL, _GAP, _BLOCK = 10.0, 0.3, 0.62, 0.2, 0.14, 0.95
_TEXT, _SMALL_TEXT = 8.5, 7.5


@dataclass(frozen=True)
class StepRun:
    """Recorded steps of a sequence, with displacements and outputs.

    `numbers` and `times` contain number and time of each entry of a step. `displacements` are fractions of the stroke
    by body, `outputs` are 0 or 1 by name.
    """

    names: tuple[str, ...]  # names of all steps
    time: FloatArray
    numbers: tuple[int, ...]
    times: tuple[float, ...]
    displacements: Mapping[str, FloatArray]
    outputs: Mapping[str, FloatArray]

    def cycle(self) -> tuple[int, int]:
        """Return the first entry of the last complete cycle, and the first entry after it.

        If no cycle is complete, the result contains all entries. A cycle starts with the first step of the recording.
        """
        starts = [k for k, number in enumerate(self.numbers) if number == self.numbers[0]]
        return (starts[-2], starts[-1]) if len(starts) > 1 else (0, len(self.numbers))

    def at(self, values: FloatArray, times: list[float]) -> FloatArray:
        """Return the values at the rows of given times."""
        rows = np.searchsorted(self.time, np.asarray(times) - 1e-9 * max(abs(self.time[-1]), 1.0))
        result: FloatArray = values[np.minimum(rows, self.time.size - 1)]
        return result


def draw_step_diagram(
    circuit: BaseCircuit, recording: Recording, path: str | Path | None = None, *, sequence: str = ""
) -> Figure:
    """Draw the displacement-step diagram and the displacement-time diagram of a step sequence.

    Parameters
    ----------
    circuit : Circuit
        The simulated circuit.
    recording : Recording
        The result of the simulation. Steps shorter than the time between its rows are omitted.
    path : str or Path, optional
        File of the figure: .png, .svg or .pdf.
    sequence : str, optional
        Name of the sequence. By default, it is the first of the circuit.

    Returns
    -------
    matplotlib.figure.Figure
        The figure.

    Raises
    ------
    InputError
        If the circuit has no sequence of this name, or the recording has no rows.

    Notes
    -----
    The upper diagram shows the last complete cycle. Its columns are the steps, and straight lines connect the
    displacements at their starts, as in VDI 3260. The lower diagram shows the motion during the whole recording. Both
    show the outputs of the sequence. The displacement is the piston position as a fraction of the stroke, from 0
    (retracted) to 1 (extended).
    """
    if path is not None:
        check_format(path)
    run = step_run(circuit, recording, sequence)
    with style("A step diagram"):
        return save_figure(_Diagram(run, circuit.title).draw(), path)


def sequences_of(circuit: BaseCircuit) -> list[str]:
    """Return the names of all step sequences of a circuit."""
    return [name for name, part in circuit.parts.items() if isinstance(part, Sequence)]


def find_sequence(circuit: BaseCircuit, name: str = "") -> str:
    """Return the name of a step sequence, by default of the first in the circuit.

    Raises
    ------
    InputError
        If the circuit has no sequence, or none with this name.
    """
    sequences = sequences_of(circuit)
    if not sequences:
        raise InputError("drawing.no_sequence")
    if name and name not in sequences:
        raise InputError("names.unknown", name, meaning="a sequence", suggestion=NameSuggestion(name, sequences))
    return name or sequences[0]


def step_run(circuit: BaseCircuit, recording: Recording, sequence: str = "") -> StepRun:
    """Return the recorded steps of a sequence, and the displacements of the bodies that its conditions read.

    If the conditions read no body, the result contains all bodies of cylinders. `sequence` is the name of the sequence,
    by default the first of the circuit.
    """
    sequences = [name for name, part in circuit.parts.items() if part.kind == "sequence"]
    if not sequences:
        raise InputError("drawing.no_sequence")
    if sequence and sequence not in sequences:
        raise InputError(
            "names.unknown", sequence, meaning="a sequence", suggestion=NameSuggestion(sequence, sequences)
        )
    if not recording.time.size:
        raise InputError("drawing.no_samples", name=circuit.title)
    name = sequence or sequences[0]
    part: Any = circuit.parts[name]
    step = np.rint(recording[f"{name}.step"]).astype(int)
    rows = np.flatnonzero(np.diff(step, prepend=step[0] - 1))
    bodies = dict.fromkeys(
        body for reading, _ in part.program.readings().values() for body in _bodies_of(circuit, reading.address)
    )
    bodies = bodies or dict.fromkeys(str(part.body) for part in circuit.parts.values() if isinstance(part, Cylinder))
    return StepRun(
        tuple(step.name for step in part.program.steps),
        recording.time,
        tuple(int(number) for number in step[rows]),
        tuple(float(time) for time in recording.time[rows]),
        dict(_displacement(circuit, recording, body) for body in bodies),
        {output: recording[f"{name}.{output}"] for output in part.program.form.outputs},
    )


def _bodies_of(circuit: BaseCircuit, address: str) -> Iterator[str]:
    """Yield the bodies whose motion an output depends on directly: that of its part, or of its measurement."""
    name = address.partition(".")[0]
    part = circuit.parts.get(name)
    if isinstance(part, Body):
        yield name
    elif part is not None and part.kind in _COMPOUNDS:
        yield f"{name}.{_COMPOUNDS[part.kind][0]}"
    elif part is not None and getattr(part, "body", None):
        yield str(part.body)  # type: ignore[attr-defined]
    elif part is not None and f"{name}.measurement" in circuit.connections:
        yield from _bodies_of(circuit, circuit.connections[f"{name}.measurement"])


_COMPOUNDS = {"gripper": ("jaws", "jaw_stroke"), "rotary_actuator": ("shaft", "swivel_angle")}
"""Body in a compound part by its kind, and the field with its stroke."""


def _displacement(circuit: BaseCircuit, recording: Recording, body: str) -> tuple[str, FloatArray]:
    """Return the label of a body and its displacement as a fraction of its stroke.

    The stroke is that of the first cylinder of the body, or of the compound part that contains the body. Without both,
    it is the distance of the stops, or the range of the recorded positions.
    """
    cylinders = [
        (name, part) for name, part in circuit.parts.items() if isinstance(part, Cylinder) and part.body == body
    ]
    if cylinders:
        name, cylinder = cylinders[0]
        position, stroke = recording[f"{name}.piston_position"], float(cylinder.stroke_length)  # type: ignore[arg-type]
        return name if len(cylinders) == 1 else body, position / stroke
    position, owner = recording[f"{body}.position"], body.partition(".")[0]
    if owner != body:
        stroke = float(getattr(circuit.parts[owner], _COMPOUNDS[circuit.parts[owner].kind][1]))
        return owner, position / stroke
    stops = [getattr(circuit.parts[body], f"{side}_stop", None) for side in ("lower", "upper")]
    low, high = float(np.min(position)), float(np.max(position))
    if None not in stops:
        low, high = (float(stop.position) for stop in stops)  # type: ignore[union-attr]
    return body, (position - low) / (high - low if high > low else 1.0)


class _Diagram:
    """Layout of the figure: two blocks of rows, one for each body and each output."""

    def __init__(self, run: StepRun, title: str) -> None:
        self.run, self.title = run, title
        self.left = 0.35 + widest([*run.displacements, *run.outputs], _TEXT)
        self.rows = [*((name, True) for name in run.displacements), *((name, False) for name in run.outputs)]
        self.height = sum(_ROW if is_body else _SIGNAL for _, is_body in self.rows) + _GAP * (len(self.rows) - 1)
        first, last = run.cycle()
        self.entries = range(first, min(last, first + MOST_COLUMNS))
        self.is_cut = last - first > MOST_COLUMNS
        self.is_cycle = last < len(run.numbers)
        column = (_WIDTH - self.left - _RIGHT) / max(len(self.entries), 1)
        names = [run.names[run.numbers[k] - 1] for k in self.entries]
        self.is_upright = widest(names, _SMALL_TEXT) > column - 0.08
        self.names_height = 0.3 + (widest(names, _SMALL_TEXT) if self.is_upright else 0.0)

    def draw(self) -> Figure:
        """Draw both blocks and return the figure."""
        head = 0.2 + 0.3 * bool(self.title)
        first_top = head + 0.25 + self.names_height
        second_top = first_top + self.height + _BLOCK
        self.figure = new_figure(_WIDTH, second_top + self.height + 0.55)
        if self.title:
            self._text(self.left, 0.12, self.title, fontsize=11, fontweight="bold")
        cycle = "last complete cycle" if self.is_cycle else "all steps"
        cut = f", first {MOST_COLUMNS} steps" if self.is_cut else ""
        self._text(self.left, head - 0.05, f"Displacement-step diagram: {cycle}{cut}", fontsize=9.5)
        self._steps(first_top)
        self._text(self.left, second_top - 0.42, "Displacement-time diagram", fontsize=9.5)
        self._times(second_top)
        return self.figure

    def _text(self, left: float, top: float, text: str, **options: Any) -> None:
        width, height = self.figure.get_size_inches()
        self.figure.text(left / width, 1.0 - top / height, text, va="top", parse_math=False, **options)

    def _axes(self, top: float) -> list[tuple[str, bool, Any]]:
        """Return name, kind and axes of all rows of a block, from top to bottom."""
        rows, axes = [], None
        for name, is_body in self.rows:
            height = _ROW if is_body else _SIGNAL
            axes = axes_in(self.figure, self.left, top, _WIDTH - self.left - _RIGHT, height, sharex=axes)
            axes.grid(visible=False)
            lowest = 0.0 if is_body else min(float(np.min(self.run.outputs[name])), 0.0)
            axes.set_ylim(*((-MARGIN, 1.0 + MARGIN) if is_body else (lowest, 1.15)))
            axes.set_yticks([0.0, 1.0] if is_body else [])
            axes.tick_params(labelbottom=False, bottom=False, labelsize=_SMALL_TEXT, length=2)
            for side in ("left", "bottom"):
                axes.spines[side].set_visible(False)
            if is_body:
                for level in (0.0, 1.0):
                    axes.axhline(level, color=FAINT, linewidth=0.8, zorder=0)
            else:
                axes.axhline(0.0, color=GREY, linewidth=0.8, zorder=0)
            options: dict[str, Any] = {"x": -0.28 / (_WIDTH - self.left - _RIGHT), "y": 0.5, "ha": "right"}
            axes.text(s=name, transform=axes.transAxes, va="center", fontsize=_TEXT, parse_math=False, **options)
            rows.append((name, is_body, axes))
            top += height + _GAP
        return rows

    def _draw_row(self, name: str, is_body: bool, axes: Any, x: FloatArray, y: FloatArray) -> None:
        if is_body:
            colour = PALETTE[list(self.run.displacements).index(name) % len(PALETTE)]
            axes.plot(x, y, color=colour, linewidth=1.8, clip_on=False)
        else:
            axes.fill_between(x, 0.0, y, step="post", color=INK, alpha=0.75, linewidth=0.0)

    def _steps(self, top: float) -> None:
        run, count = self.run, len(self.entries)
        ends = [*self.entries, self.entries[-1] + 1]
        times = [run.times[k] if k < len(run.times) else float(run.time[-1]) for k in ends]
        x = np.arange(1.0, count + 2.0)
        rows = self._axes(top)
        for name, is_body, axes in rows:
            for edge in x:
                axes.axvline(edge, color=FAINT, linewidth=0.8, zorder=0)
            values = run.at((run.displacements if is_body else run.outputs)[name], times)
            self._draw_row(name, is_body, axes, x, values)
        axes = rows[0][2]
        axes.set_xlim(1.0, count + 1.0)
        options: dict[str, Any] = {"transform": axes.get_xaxis_transform(), "ha": "center", "va": "bottom"}
        height = _ROW if rows[0][1] else _SIGNAL
        for place, k in enumerate(self.entries, 1):
            number = run.numbers[k]
            axes.text(place + 0.5, 1.0 + 0.24 / height, run.names[number - 1], fontsize=_SMALL_TEXT,
                      rotation=90 if self.is_upright else 0, parse_math=False, **options)  # fmt: skip
            axes.text(place + 0.5, 1.0 + 0.06 / height, f"{number}", fontsize=_TEXT, fontweight="bold", **options)

    def _times(self, top: float) -> None:
        run = self.run
        rows = self._axes(top)
        for name, is_body, axes in rows:
            for time in run.times[1:]:
                axes.axvline(time, color=FAINT, linewidth=0.8, zorder=0)
            self._draw_row(name, is_body, axes, run.time, (run.displacements if is_body else run.outputs)[name])
        axes = rows[0][2]
        axes.set_xlim(float(run.time[0]), float(run.time[-1]) if run.time[-1] > run.time[0] else run.time[0] + 1.0)
        height = _ROW if rows[0][1] else _SIGNAL
        ends = [*run.times[1:], float(run.time[-1])]
        scale = (_WIDTH - self.left - _RIGHT) / max(float(run.time[-1] - run.time[0]), 1e-12)
        options: dict[str, Any] = {"transform": axes.get_xaxis_transform(), "ha": "center", "va": "bottom"}
        for number, start, end in zip(run.numbers, run.times, ends, strict=True):
            # Numbers of steps that are too short for their text are omitted.
            if (end - start) * scale > text_width(f"{number}", _SMALL_TEXT, bold=True) + 0.04:
                axes.text(0.5 * (start + end), 1.0 + 0.06 / height, f"{number}", fontsize=_SMALL_TEXT,
                          fontweight="bold", **options)  # fmt: skip
        last = rows[-1][2]
        last.tick_params(labelbottom=True, bottom=True)
        last.set_xlabel("time [s]")

"""Function `simulate`: a run with its summary, metrics, notes, chosen series and figure."""

from __future__ import annotations

import base64
import time
from collections.abc import Callable, Sequence
from typing import Annotated, Any

import numpy as np

from poppet.assist.arguments import Argument
from poppet.assist.circuits import NONE, File, Result, Text, Values, load_circuit
from poppet.assist.folder import Folder
from poppet.assist.limits import (
    LIST_ROWS,
    LONGEST_LIMIT,
    RUN_ROWS,
    RUN_VALUES,
    SERIES_ROWS,
    SERIES_VALUES,
    TIME_LIMIT,
    TIMES,
)
from poppet.assist.replies import Json, note_row, note_rows, number, plain, quantity
from poppet.core.codes import Note
from poppet.core.errors import InputError, OutOfRangeError
from poppet.core.number_format import USUAL

TimeLimit = Annotated[
    float,
    Argument("time limit of the call [s]; never longer than that of the server", low=0.1, high=LONGEST_LIMIT),
]
Replace = Annotated[bool, Argument("replace existing files")]
PICTURES = {"png": "image/png", "svg": "image/svg+xml"}
"""Media types of figures."""
RECORDINGS = (".csv", ".parquet", ".mat")


def simulate(
    folder: Folder,
    *,
    file: File = "",
    text: Text = "",
    set: Values = NONE,
    with_result: Result = "",
    duration: Annotated[str, Argument('duration of the run: "60 s" (default: that of the file)', longest=40)] = "",
    output_step: Annotated[
        str, Argument('time between rows: "10 ms" (default: a thousandth of the duration)', longest=40)
    ] = "",
    tolerance: Annotated[float, Argument("relative tolerance", low=1e-13, high=0.1)] = 1e-6,
    stop_when: Annotated[
        Sequence[str], Argument('conditions that end the run: ["tank.pressure > 5 bar"]', longest=20)
    ] = (),
    select: Annotated[
        Sequence[str], Argument('outputs of summary, series and figure: ["tank.*", "valve.stroke"] (default: all)')
    ] = (),
    units: Annotated[
        Sequence[str],
        Argument('units, each for all outputs of its quantity: ["bar", "degC"] (default: usual units)', longest=20),
    ] = (),
    rows: Annotated[int, Argument("largest number of rows of the series; 0: no series", low=0, high=SERIES_ROWS)] = 0,
    times: Annotated[
        Sequence[float], Argument("times at which the selected outputs are listed [s]", longest=TIMES)
    ] = (),
    inner: Annotated[bool, Argument("include internal outputs of the parts")] = False,
    figure: Annotated[str, Argument("format of a figure in the result", choices=("none", *PICTURES))] = "none",
    output: Annotated[str, Argument("file for the whole recording: .csv, .parquet or .mat", longest=200)] = "",
    replace: Replace = False,
    time_limit: TimeLimit = TIME_LIMIT,
) -> Json:
    """Simulate a circuit, and return outcome, extremes of each output, metrics, notes, and series on request.

    Pressures are absolute. A run beyond the time limit returns its part up to then.
    """
    deadline = time.monotonic() + time_limit
    target = folder.target(output, "output", replace, RECORDINGS) if output else None
    change = load_circuit(folder, file, text, set, with_result)
    circuit = change.circuit
    values: dict[str, Any] = {"run.relative_tolerance": tolerance} if tolerance != 1e-6 else {}
    values |= {"run.duration": duration} if duration else {}
    values |= {"run.output_step": output_step} if output_step else {}
    values |= {"run.stop_when": [*circuit.run.stop_texts, *stop_when]} if stop_when else {}
    circuit = circuit.with_values(values) if values else circuit
    check_size(circuit)
    try:
        recording = circuit.simulate(progress=stop_after(deadline), throw=False)
    except InputError as error:
        raise change.located(error) from None
    is_stopped = recording.ending is not None and recording.ending.code == "run.ended.interrupted"
    selection = _selected(recording, select, units, inner)
    if target is not None and recording.time.size:
        recording.save(target)
    notes = [*change.notes, *recording.remarks]
    result: Json = {
        "title": recording.title,
        "outcome": note_row(recording.ending) if recording.ending else {},
        "is_stopped": is_stopped,
        "duration": quantity(recording.time[-1] if recording.time.size else 0.0, "s"),
        "rows": int(recording.time.size),
        "summary": _summary(selection),
        "metrics": _metrics(recording),
        "balances_kept": all(balance.is_kept for balance in recording.residuals),
        "notes": note_rows([*([Note("assist.stopped", limit=time_limit)] if is_stopped else ()), *notes]),
    }
    if len(selection) > LIST_ROWS:
        result["omitted_outputs"] = len(selection) - LIST_ROWS
    if rows and selection.time.size:
        result["series"] = _series(selection, rows)
    if times and selection.time.size:
        result["values_at"] = _values_at(selection, times)
    if target is not None and recording.time.size:
        result["output"] = output
    if figure != "none" and selection.time.size:
        result["figure"] = _figure(recording, figure, select, units, inner)
    return result


def check_size(circuit: Any) -> None:
    """Raise an error if a run has too many rows or values."""
    run = circuit.run
    if run.duration is None:
        run.grid()  # raises the error about a missing duration
    count = 1000 if run.output_step is None else float(run.duration) / float(run.output_step)
    limit = min(RUN_ROWS, RUN_VALUES // max(len(circuit.symbolic_model.outputs), 1))
    if count > limit:
        raise OutOfRangeError("assist.too_many_rows", "run.output_step", rows=count, most=limit)


def stop_after(deadline: float) -> Callable[..., None]:
    """Return a callback that ends a run at a time of `time.monotonic` in the same way as Ctrl-C."""

    def check(*_: Any) -> None:
        if time.monotonic() > deadline:
            raise KeyboardInterrupt

    return check


def _selected(recording: Any, select: Sequence[str], units: Sequence[str], inner: bool) -> Any:
    """Return the selected outputs in the selected units."""
    if select:
        recording = recording.select(select)
    elif not inner:
        recording = recording.select([name for name in recording.names if name not in recording.inner])
    names = zip(recording.names, recording.units, strict=True)
    recording = recording.converted({name: USUAL[unit] for name, unit in names if unit in USUAL})
    return recording.converted(units) if units else recording


def _summary(selection: Any) -> Json:
    rows = {}
    if not selection.time.size:
        return {}
    for name, unit, values in list(zip(selection.names, selection.units, selection.values, strict=True))[:LIST_ROWS]:
        low, high = int(np.argmin(values)), int(np.argmax(values))
        rows[name] = {
            "unit": unit, "first": number(values[0]), "last": number(values[-1]),
            "min": number(values[low]), "min_time": number(selection.time[low]),
            "max": number(values[high]), "max_time": number(selection.time[high]),
        }  # fmt: skip
    return rows


def _series(selection: Any, rows: int) -> Json:
    """Return evenly spaced rows of the series, with the first and the last one."""
    rows = max(min(rows, SERIES_VALUES // (len(selection) + 1)), 2)
    index = np.unique(np.linspace(0, selection.time.size - 1, min(rows, selection.time.size)).round().astype(int))
    series = {
        name: {"unit": unit, "values": [number(value) for value in values[index]]}
        for name, unit, values in zip(selection.names, selection.units, selection.values, strict=True)
    }
    return {"time": {"unit": "s", "values": [number(value) for value in selection.time[index]]}} | series


def _values_at(selection: Any, times: Sequence[float]) -> Json:
    """Return interpolated values at the requested times."""
    if len(selection) * len(times) > SERIES_VALUES:
        raise InputError("assist.too_long", "times", length=len(selection) * len(times), most=SERIES_VALUES)
    series = {
        name: {"unit": unit, "values": [number(value) for value in selection.interpolate(name, times)]}
        for name, unit in zip(selection.names, selection.units, strict=True)
    }
    return {"time": {"unit": "s", "values": list(times)}} | series


def _metrics(recording: Any) -> Json:
    """Return the metrics of moved loads; empty if nothing moves."""
    metrics = recording.figures
    if not metrics:
        return {}
    strokes = []
    for stroke in metrics.strokes:
        speeds = {name: quantity(getattr(stroke, name), f"{stroke.unit}/s") for name in ("mean_speed", "peak_speed")}
        times = {"start": quantity(stroke.start, "s"), "duration": quantity(stroke.duration, "s")}
        travel = {"travel": quantity(stroke.travel, stroke.unit)}
        strokes.append({"body": stroke.body, **times, **travel, **speeds, "command": stroke.command})
    return {
        "strokes": plain(strokes), "strokes_count": len(strokes),
        "air_used": quantity(1e3 * metrics.air_used, "l ANR"), "exergy": quantity(metrics.exergy, "J"),
        "work": quantity(metrics.work, "J"), "efficiency": quantity(metrics.efficiency, "1"),
    }  # fmt: skip


def _figure(recording: Any, file_format: str, select: Sequence[str], units: Sequence[str], inner: bool) -> Json:
    """Return a figure of the recording, encoded in base64."""
    from poppet.timeseries.plotting.figures import figure_bytes

    drawing = recording.plot(select=select or None, units=units or None, inner=inner)
    data = figure_bytes(drawing, file_format, "assistant")
    return {"media_type": PICTURES[file_format], "base64": base64.b64encode(data).decode()}

"""Content of the page of a served circuit: drawing, curves, inputs, faults and the estimates of a watch."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from poppet.core.number_format import USUAL, pretty, printable
from poppet.deploy.live.live_page import (
    BAND,
    CURVES,
    cell_rows,
    empty_figure,
    output_rows,
    page_style,
    panel_rows,
    read_page_file,
    series_name,
)
from poppet.deploy.live.page_drawing import page_drawing
from poppet.deploy.live.page_inputs import affine, default_range
from poppet.monitoring.plan import Fault
from poppet.parts.faults import HEALTHY
from poppet.report.html_page import document, head
from poppet.report.plots.interactive import minify
from poppet.serve.points import Point, PointRole, ServedCircuit
from poppet.timeseries.plotting.figures import style
from poppet.timeseries.plotting.plots import Sheet
from poppet.timeseries.recording import Recording

MAX_LINES = 6
"""Curves of a panel at the start; the user can add others."""
RARE = "K", "kg", "W", "J"
"""SI units of panels that are empty until the user adds a curve."""
MAX_RANGE = 1e300
COLOURS = "#1f77b4", "#d62728", "#2ca02c", "#9467bd", "#8c564b", "#17becf"
_LEAD = "Values of the running machine. Change an input or switch a fault, and the machine follows."


def served_page(served: ServedCircuit, faults: Sequence[Fault] = ()) -> str:
    """Return the HTML text of the page of a served circuit.

    Parameters
    ----------
    served : ServedCircuit
        Circuit.
    faults : sequence of Fault, optional
        Faults that a watch estimates.
    """
    circuit = served.circuit
    hidden = {location.input for location in served.fault_locations.values()}
    columns = [
        (name, unit or "1")
        for name, unit in zip(served.columns, served.column_units, strict=True)
        if name not in hidden
    ]
    index_of = {name: k for k, (name, _) in enumerate(columns)}
    # The panels are those of a recording in which all outputs move.
    names, units = zip(*columns, strict=True) if columns else ((), ())
    moving = np.tile([0.0, 1.0], (len(columns), 1))
    recording = Recording(
        np.array([0.0, 1.0]), names, units, moving, inner=circuit.inner,
        ambient_pressure=circuit.surroundings.pressure,
    )  # fmt: skip
    outputs = output_rows(columns, circuit.surroundings.pressure)
    sheet = Sheet({"": recording}, None, None, "") if columns else None
    panels = panel_rows(sheet, index_of) if sheet else []
    tubes = (
        []
        if sheet is None
        else [
            {"label": series_name(name, sheet), **cell_rows(cells, index_of), **BAND}
            for name, cells in sheet.cells.items()
        ]
    )
    for panel in panels:
        output = outputs[panel["lines"][0]["output"]]
        panel["unit"], panel["lines"] = output["unit"], panel["lines"][: 0 if output["si"] in RARE else MAX_LINES]
    # The last panel has the time axis, so empty panels are above the others.
    panels.sort(key=lambda panel: bool(panel["lines"]))
    with style("The page of a served circuit"):
        # The idle faults of the served circuit do not appear in the drawing.
        idle = {f"{valve}.fault": fault for valve, fault in served.initial_faults.items() if fault == HEALTHY}
        drawing = page_drawing(circuit.with_values(idle), columns)
    content = {"title": circuit.title, "time": ["s", 1.0], "outputs": outputs, "tubes": tubes, "drawing": drawing}
    curves = empty_figure(content | {"panels": [*panels, *_watch_panels(faults)], "bands": []}, 60.0)
    title = circuit.title or "A served circuit"
    data = json.dumps(content, allow_nan=False, separators=(",", ":")).replace("<", "\\u003c")
    sections = [
        ("", head(title, _LEAD) + read_page_file("connected.html").replace(CURVES, curves)),
        ("", f'<script type="application/json" id="content">{data}</script>\n'),
    ]
    program = minify(read_page_file("drawing.js") + read_page_file("connected.js") + _START)
    return printable(document(title, sections, style=page_style(), program=program, connects="'self'"))


_START = """
const server = `${location.protocol === "https:" ? "wss" : "ws"}://${location.host}`;
new ConnectedPage(JSON.parse(document.getElementById("content").textContent), { server, token: "" });
"""


def _watch_panels(faults: Sequence[Fault]) -> list[dict[str, Any]]:
    """Return the panel of the estimates: changes of all faults from the baseline, in alarm sizes."""
    if not faults:
        return []
    lines, bands = [], []
    for k, fault in enumerate(faults):
        look = {"fault": fault.name, "colour": COLOURS[k % len(COLOURS)]}
        lines.append({**look, "label": fault.name})
        bands.append({**look, "alpha": 0.18, "x": 0, "low": 1, "high": 1})
    limits = {sign for fault in faults for sign in (-1, 1) if sign * fault.direction >= 0}
    rules = [{"label": "", "axis": "y", "at": sign, "colour": "#6b7280", "dash": [4, 4]} for sign in sorted(limits)]
    return [{"y": {"label": "estimated change [alarm sizes]"}, "lines": lines, "bands": bands, "rules": rules}]


def machine_facts(served: ServedCircuit, row_names: Sequence[str], row_units: Sequence[str]) -> dict[str, Any]:
    """Return the columns, inputs and faults of a machine, with which a page shows and changes it."""
    ambient = served.circuit.surroundings.pressure
    inputs = [point for point in served.points if point.role is PointRole.INPUT]
    return {
        "title": served.circuit.title,
        "columns": [[name, unit or "1"] for name, unit in zip(row_names, row_units, strict=True)],
        "inputs": [_input_row(point, ambient) for point in inputs],
        "faults": {valve: list(words) for valve, words in served.faults.items()},
    }


def _input_row(point: Point, ambient: float) -> dict[str, Any]:
    unit = USUAL.get(point.unit, point.unit)
    factor, shift = affine(point.unit, unit, ambient)
    if math.isfinite(point.low) and math.isfinite(point.high):
        low, high = point.low, point.high
    else:
        low, high = default_range(point.initial, point.low, point.high, point.unit)
    return {
        "address": point.address, "doc": point.doc, "is_flag": point.is_flag, "initial": point.initial,
        "unit": "" if unit == "1" else pretty(unit), "factor": factor, "shift": shift,
        "low": finite(point.low), "high": finite(point.high), "range": [low, high] if low < high else None,
    }  # fmt: skip


def watch_facts(faults: Sequence[Fault], ambient: float) -> list[dict[str, Any]]:
    """Return names, units and alarm sizes of the faults of a watch. `ambient` is the ambient pressure [Pa]."""
    rows = []
    for fault in faults:
        unit = USUAL.get(fault.unit, fault.unit)
        factor, shift = affine(fault.unit, unit, ambient)
        rows.append(
            {"name": fault.name, "address": fault.address, "alarm": fault.alarm, "factor": factor, "shift": shift,
             "unit": "" if unit == "1" else pretty(unit)}
        )  # fmt: skip
    return rows


def finite(value: float) -> float | None:
    """Return a value, or None if it is not finite, because JSON has no such numbers."""
    return value if abs(value) < MAX_RANGE else None


def encode(content: Mapping[str, Any]) -> str:
    """Return a message of the server as text."""
    return json.dumps(content, allow_nan=False, separators=(",", ":"))

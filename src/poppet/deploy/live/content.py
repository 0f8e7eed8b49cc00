"""Content of a live page as JSON data: curves and bars of the outputs, schematic, sliders."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import asdict, replace
from typing import TYPE_CHECKING, Any

from poppet.core.number_format import USUAL, pretty
from poppet.core.units import convert
from poppet.deploy.export_model import ExportModel
from poppet.deploy.live.page_inputs import Slider, affine
from poppet.report.circuit.schematic import EmptyLine, draw_with_empty_lines
from poppet.report.html_page import inline_svg
from poppet.timeseries.plotting.figures import figure_bytes
from poppet.timeseries.plotting.panels import STILL
from poppet.timeseries.plotting.plots import Sheet, axis_unit

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit
    from poppet.timeseries.recording import Recording

_SYMBOLS = {"Pa": "p", "m": "x", "rad": "angle", "N": "F", "N m": "M", "kg/s": "qm"}
"""Symbols of the quantities in the boxes of the schematic, by SI unit, in the order of preference."""
_MAX_LINES, _MIN_WIDTH = 3, 1.3  # of a box; width [in]
_MOVES = {"stroke": "poppet", "position": "piston", "piston_position": "piston"}
_INPUT_UNITS = {
    "Pa": ("Pa", "kPa", "MPa", "mbar", "bar", "psi", "bar g", "kPa g", "mbar g", "psi g"),
    "K": ("K", "degC", "degF"),
    "m": ("m", "cm", "mm", "um"),
    "m/s": ("m/s", "mm/s"),
    "rad": ("rad", "deg"),
    "rad/s": ("rad/s", "deg/s"),
    "kg/s": ("kg/s", "g/s", "kg/h", "l/min ANR", "m^3/h ANR", "l/min N"),
    "N": ("N", "kN"),
    "N m": ("N m",),
    "kg": ("kg", "g"),
    "m^3": ("m^3", "l"),
    "1": ("1", "%"),
    "s": ("s", "ms", "min", "h"),
}
"""Units that the user can select for a column of measured values, by SI unit."""


def page_content(
    export_model: ExportModel, circuit: BaseCircuit, recording: Recording, sliders: Sequence[Slider]
) -> dict[str, Any]:
    """Return the data of a live page except the kernel and its arrays."""
    ambient = circuit.surroundings.pressure
    sheet = Sheet({"": recording}, None, None, "", inner=False)
    index_of = {output.address: k for k, output in enumerate(export_model.outputs)}
    return {
        "title": export_model.title,
        "time": [sheet.time_name, sheet.time_size],
        "sliders": [_slider(slider, ambient) for slider in sliders],
        "outputs": [_output(output.address, output.unit, ambient) for output in export_model.outputs],
        "panels": _panels(sheet, index_of),
        "bands": _bands(sheet, index_of),
        "left_out": [series.name for series in sheet.left_out],
        "drawing": _drawing(export_model, circuit),
        "units": {si: [[name, *affine(name, si, ambient)] for name in names] for si, names in _INPUT_UNITS.items()},
        "n_inputs": max(1, len(export_model.inputs)),
    }


def _slider(slider: Slider, ambient: float) -> dict[str, Any]:
    factor, shift = slider.scale(ambient)
    fields = asdict(slider)
    for name in ("low", "high", "least", "most"):
        # JSON has no infinity.
        fields[name] = min(max(fields[name], -1e300), 1e300)
    return fields | {"factor": factor, "shift": shift, "shown": pretty(slider.unit) if slider.unit != "1" else ""}


def _output(address: str, unit: str, ambient: float) -> dict[str, Any]:
    display_unit = USUAL.get(unit, unit)
    factor, shift = affine(unit, display_unit, ambient)
    return {"address": address, "si": unit, "unit": display_unit, "factor": factor, "shift": shift}


def _panels(sheet: Sheet, index_of: dict[str, int]) -> list[dict[str, Any]]:
    """Return the curve panels as data for `plots.js`.

    Each line refers to an output by index.
    """
    panels = []
    for panel, colours in zip(sheet.panels, sheet.colours, strict=True):
        lines = [
            {"output": index_of[series.name], "label": panel.labels[series.name], "colour": colours[series.name],
             "step": series.is_staircase}
            for series in panel.series
        ]  # fmt: skip
        y: dict[str, Any] = {"label": " ".join((panel.quantity, axis_unit(panel))).strip()}
        if sheet._has_second_axis(panel):
            y["second"] = {"label": "l/min ANR", "factor": float(convert(1.0, panel.unit, "l/min ANR"))}
        panels.append({"y": y, "lines": lines})
    return panels


def _bands(sheet: Sheet, index_of: dict[str, int]) -> list[dict[str, Any]]:
    """Return the bars that show codes (integer outputs such as a flow regime) versus time.

    Each bar has the index of its output, a text and colour for each code, and, for a flow regime, the index of the
    flow.
    """
    bars = []
    for band in sheet.bands:
        flow = index_of.get(f"{band.name.removesuffix('regime')}mass_flow_rate", -1) if "regime" in band.name else -1
        styles = [[code, style.text, style.colour, style.is_hatched] for code, style in band.looks.items()]
        bars.append({"output": index_of[band.name], "label": band.label, "looks": styles, "flow": flow, "still": STILL})
    return bars


def _drawing(export_model: ExportModel, circuit: BaseCircuit) -> dict[str, Any]:
    """Return the schematic as SVG, with the positions of values and of moving bodies in its boxes."""
    inner = export_model.instance.inner
    values_of: dict[str, list[dict[str, Any]]] = {}
    for unit, symbol in _SYMBOLS.items():
        for k, output in enumerate(export_model.outputs):
            path, _, name = output.address.rpartition(".")
            part = path.partition(".")[0]
            if output.unit != unit or output.address in inner or part not in circuit.parts:
                continue
            values_of.setdefault(part, []).append({"output": k, "sign": symbol, "name": name.replace("_", " ")})
    values_of = {part: values[:_MAX_LINES] for part, values in values_of.items()}
    movers = {part: mover for part in values_of if (mover := _mover(export_model, part))}
    n_lines = {part: len(values) + 2 * (part in movers) for part, values in values_of.items()}
    # The page has the title.
    figure, empty_lines = draw_with_empty_lines(replace(circuit, title="", like=circuit), n_lines, _MIN_WIDTH)
    title = f"The circuit {export_model.title}"
    svg = inline_svg(figure_bytes(figure, "svg", "circuit").decode("utf-8"), "circuit", title)
    lines_of: dict[str, list[EmptyLine]] = {
        part: [line for line in empty_lines if line.part == part] for part in n_lines
    }
    placed_values = []
    for part, values in values_of.items():
        lines = lines_of[part]
        if part in movers:
            (first, second), lines = lines[:2], lines[2:]
            movers[part] |= {
                "x": first.x,
                "y": (first.y + second.y) / 2,
                "width": first.width,
                "height": 1.7 * first.height,
            }
        placed_values += [value | {"x": line.x, "y": line.y} for value, line in zip(values, lines, strict=True)]
    return {"svg": svg, "values": placed_values, "movers": list(movers.values())}


def _mover(export_model: ExportModel, part: str) -> dict[str, Any] | None:
    """Return the data of the moving body of a part, or None if the part has no moving body.

    The data are the index of the position output, the symbol and, if defined, the end stops.
    """
    for k, output in enumerate(export_model.outputs):
        path, _, name = output.address.rpartition(".")
        if path == part and name in _MOVES and output.unit in ("m", "rad"):
            kind = "lever" if output.unit == "rad" else _MOVES[name]
            stops = export_model.instance.domains.get(output.address, (None, None))[1]
            return {"output": k, "kind": kind, "stops": list(stops) if stops else None}
    return None

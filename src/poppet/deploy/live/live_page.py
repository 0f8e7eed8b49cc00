"""HTML page that simulates a circuit in the browser, without a network connection."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import asdict, replace
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from poppet.core.number_format import USUAL, pretty, printable
from poppet.core.units import convert
from poppet.deploy.export_model import ExportModel, build_export_model
from poppet.deploy.live.page_drawing import page_drawing
from poppet.deploy.live.page_inputs import Slider, affine, select_sliders
from poppet.deploy.live.page_kernel import kernel_script, pack_base64, run_data
from poppet.deploy.targets import MODEL_ELEMENT, CircuitSource, Export
from poppet.report.html_page import document, findings, head
from poppet.report.plots.interactive import data_element, minify
from poppet.timeseries.plotting.figures import style
from poppet.timeseries.plotting.panels import STILL
from poppet.timeseries.plotting.plots import Sheet, axis_unit
from poppet.timeseries.plotting.tube_bands import cell_range

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit
    from poppet.timeseries.recording import Recording

_LEAD = "The model itself runs in this page. Change a parameter, and curves, bars and the drawing follow; * is assumed."
CURVES = "<!-- curves -->"
"""Place of the figure of a page."""
BAND = {"high": 1, "width": 0.8, "area": 0.28}
"""Look of the band of a tube: column of its upper edge, width of its edges and opacity of its area."""
LOOPBACK = "ws://127.0.0.1:* ws://localhost:*"
"""Servers to which an exported page can connect: served circuits on the same computer."""
MAX_ROWS = 2001
"""Maximum number of rows that a page computes; a longer run has a larger output step on the page."""
MAX_ATTEMPTS = 500_000
"""Maximum number of solver steps on a page, because the user waits for the result."""
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


def export_live(circuit: BaseCircuit, source: CircuitSource, *, parameters: Sequence[str] = ()) -> Export:
    """Export a circuit as a live page: an HTML page that simulates the circuit.

    The keyword `parameters` contains the texts of the option `--parameter`.
    """
    page = printable(live_page(circuit, parameters=parameters)).encode()
    return Export({"page.html": page}, f"{len(page) / 1000:.0f} kB; runs in any browser, without a network connection.")


def live_page(circuit: BaseCircuit, *, parameters: Sequence[str] = (), bar: str = "") -> str:
    """Return the HTML text of a page that simulates a circuit.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a duration.
    parameters : sequence of str, optional
        Addresses of the parameters and inputs with a slider, with a range if the default range is not suitable:
        ``"tank.volume=50 l..400 l"``. The default is the inputs with signals, then the parameters with
        the greatest influence on the curves.
    bar : str, optional
        HTML above the title, for example links. The buttons in it with the attribute `data-copy` copy its value.

    Returns
    -------
    str

    Raises
    ------
    InputErrors
        If a parameter is unknown, or if it must not change while the model runs.

    Examples
    --------
    >>> from poppet import Chamber, Circuit, Orifice
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> circuit = Circuit({"tank": Chamber(volume="10 l", initial_pressure="5 bar"), "vent": vent})
    >>> len(live_page(circuit.with_values({"run.duration": "20 s"}))) < 400_000
    True
    """
    grid = circuit.run.grid()
    if grid.size > MAX_ROWS:
        circuit = circuit.with_values({"run.output_step": float(grid[-1]) / (MAX_ROWS - 1)})
    export_model = build_export_model(circuit)
    recording = circuit.simulate(throw=False)
    sheet = Sheet({"": recording}, None, None, "")
    names = [series.name for panel in sheet.panels for series in panel.series]
    displayed = [cell for name in names for cell in sheet.cells.get(name, [name])]
    sliders, mapping = select_sliders(export_model, circuit, parameters, displayed)
    header, blobs = run_data(replace(export_model.problem, most_attempts=MAX_ATTEMPTS), mapping)
    with style("A live page"):
        content = page_content(export_model, circuit, recording, sliders)
    data = pack_base64({**header, **content}, blobs)
    omitted = content["left_out"]
    notes = [f"Constant in the file's run, and without a curve here: {', '.join(omitted)}."] if omitted else []
    title, curves = circuit.title or "A circuit", empty_figure(content, float(grid[-1]))
    sections = [
        ("", bar + head(title, _LEAD) + read_page_file("body.html").replace(CURVES, curves)),
        ("Notes of the run as in the file", findings([*recording.remarks, *notes])),
        ("", f"{MODEL_ELEMENT}{data}</script>\n"),
    ]
    program = minify(
        kernel_script() + read_page_file("drawing.js") + read_page_file("connected.js") + read_page_file("live.js")
    )
    return document(title, sections, style=minify(page_style()), program=program, connects=LOOPBACK)


def page_content(
    export_model: ExportModel, circuit: BaseCircuit, recording: Recording, sliders: Sequence[Slider]
) -> dict[str, Any]:
    """Return the data of a live page, except the compiled model.

    Curves and bars refer to outputs by index. A bar shows the codes of an output over time, such as a flow regime. The
    bar of a flow regime also has the index of the flow.
    """
    ambient = circuit.surroundings.pressure
    sheet = Sheet({"": recording}, None, None, "")
    index_of = {output.address: k for k, output in enumerate(export_model.outputs)}
    slider_data = []
    for slider in sliders:
        factor, shift = slider.scale(ambient)
        fields = asdict(slider) | {"factor": factor, "shift": shift}
        for name in ("low", "high", "least", "most"):
            # JSON has no infinity.
            fields[name] = min(max(fields[name], -1e300), 1e300)
        slider_data.append(fields | {"shown": pretty(slider.unit) if slider.unit != "1" else ""})
    bars = []
    for band in sheet.bands:
        flow = index_of.get(f"{band.name.removesuffix('regime')}mass_flow_rate", -1) if "regime" in band.name else -1
        styles = [[code, look.text, look.colour, look.is_hatched] for code, look in band.looks.items()]
        bars.append({"output": index_of[band.name], "label": band.label, "looks": styles, "flow": flow, "still": STILL})
    return {
        "title": export_model.title,
        "time": [sheet.time_name, sheet.time_size],
        "sliders": slider_data,
        "outputs": output_rows(((output.address, output.unit) for output in export_model.outputs), ambient),
        "panels": panel_rows(sheet, index_of),
        "bands": bars,
        "left_out": [series_name(series.name, sheet) for series in sheet.left_out],
        "drawing": page_drawing(circuit, [(output.address, output.unit) for output in export_model.outputs]),
        "units": {si: [[name, *affine(name, si, ambient)] for name in names] for si, names in _INPUT_UNITS.items()},
        "n_inputs": max(1, len(export_model.inputs)),
    }


def output_rows(outputs: Iterable[tuple[str, str]], ambient: float) -> list[dict[str, Any]]:
    """Return address, SI unit and display unit of each output, with the conversion between them.

    `outputs` contains pairs of address and SI unit, and `ambient` is the ambient pressure [Pa].
    """
    rows = []
    for address, si in outputs:
        unit = USUAL.get(si, si)
        factor, shift = affine(si, unit, ambient)
        rows.append({"address": address, "si": si, "unit": unit, "factor": factor, "shift": shift})
    return rows


def series_name(name: str, sheet: Sheet) -> str:
    """Return the name of a series. For the band of a tube, it contains the numbers of the cells."""
    return f"{name}, {cell_range(sheet.cells[name])}" if name in sheet.cells else name


def cell_rows(cells: Sequence[str], index_of: Mapping[str, int]) -> dict[str, Any]:
    """Return the outputs of the band of a tube.

    `output` is that of the first cell; the others have the same unit. `index_of` contains the index of each output.
    """
    return {"output": index_of[cells[0]], "cells": [index_of[cell] for cell in cells]}


def panel_rows(sheet: Sheet, index_of: Mapping[str, int]) -> list[dict[str, Any]]:
    """Return the panels of a page without curves. `index_of` contains the index of each output.

    The cells of a tube are one line with two edges.
    """
    panels = []
    for panel, colours in zip(sheet.panels, sheet.colours, strict=True):
        lines: list[dict[str, Any]] = []
        for series in panel.series:
            name, label = series.name, panel.labels[series.name]
            line = {"label": label, "colour": colours[name], "step": series.is_staircase}
            if name in sheet.cells:
                cells = sheet.cells[name]
                line |= {"label": f"{label}, {cell_range(cells)}", **cell_rows(cells, index_of), **BAND}
            else:
                line["output"] = index_of[name]
            lines.append(line)
        y: dict[str, Any] = {"label": " ".join((panel.quantity, axis_unit(panel))).strip()}
        if sheet._has_second_axis(panel):
            y["second"] = {"label": "l/min ANR", "factor": float(convert(1.0, panel.unit, "l/min ANR"))}
        panels.append({"y": y, "lines": lines})
    return panels


def empty_figure(content: dict[str, Any], duration: float) -> str:
    """Return the HTML of the figure of a live page, without curves and bars.

    The script of the page adds them. `content` is the result of `page_content`, and `duration` the duration of the run
    [s].
    """
    name, size = content["time"]
    x: dict[str, Any] = {"label": f"time [{name}]", "range": [0.0, duration / size]}
    common: dict[str, Any] = {"group": 0, "share": 1.0}
    panels = []
    for k, panel in enumerate(content["panels"]):
        lines = [{"x": 0, "y": 1, "width": 1.4, **line} for line in panel["lines"]]
        # The lines of variant A have the same colours.
        variant = {"width": 1.1, "dash": [5, 3], "isKept": True}
        lines += [
            {**line, **variant, "label": f"{line['label']} (A)", **({"area": 0.12} if "area" in line else {})}
            for line in lines
        ]
        y = {"range": [0.0, 1.0], **panel["y"]}
        panels.append({**panel, **common, "x": x, "y": y, "lines": lines, "box": [1.0, 2.0 * k, 7.0, 1.6]})
    if content["bands"]:
        styles = {text: (colour, hatch) for band in content["bands"] for _, text, colour, hatch in band["looks"]}
        boxes = [
            {"label": text, "colour": colour, "hatch": hatch, "at": []} for text, (colour, hatch) in styles.items()
        ]
        rows = [[float(k), band["label"]] for k, band in enumerate(content["bands"])]
        y = {"label": "", "range": [len(rows) - 0.5, -0.5]}
        panels.append({**common, "x": x, "y": y, "boxes": boxes, "rows": rows, "box": [1.0, 99.0, 7.0, 1.0]})
    for panel in panels[:-1]:
        panel["x"] = {**x, "label": "", "silent": True}
    data = {"columns": [[], []], "panels": panels}
    return f'<figure id="curves" aria-label="Curves and bars over time">{data_element(data)}</figure>\n'


def page_style() -> str:
    """Return the style sheets of a live page."""
    return read_page_file("live.css") + read_page_file("connected.css")


@cache
def read_page_file(name: str) -> str:
    """Return the text of a file of the live pages."""
    return (files("poppet.deploy.live") / name).read_text(encoding="utf-8")

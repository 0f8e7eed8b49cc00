"""HTML page that simulates a circuit in the browser, without a network connection."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING, Any

from poppet.core.number_format import printable
from poppet.deploy.export_model import build_export_model
from poppet.deploy.live.content import page_content
from poppet.deploy.live.page_inputs import select_sliders
from poppet.deploy.live.page_kernel import pack, run_data
from poppet.deploy.targets import CircuitSource, Export
from poppet.report.html_page import document, findings, head
from poppet.report.plots.interactive import data_element, tight
from poppet.timeseries.plotting.figures import style

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

_LEAD = "The model itself runs in this page. Change a number, and curves, bars and the drawing follow; * is assumed."
_CURVES = "<!-- curves -->"
MAX_ROWS = 2001
"""Maximum number of rows that a page computes; a longer run has a larger output step on the page."""
MAX_ATTEMPTS = 500_000
"""Maximum number of solver steps on a page, because the user waits for the result."""


def export_live(circuit: BaseCircuit, source: CircuitSource, *, parameters: Sequence[str] = ()) -> Export:
    """Export a circuit as a live page.

    `parameters` contains the values of the option --parameter.
    """
    page = printable(live_page(circuit, parameters=parameters)).encode()
    return Export({"page.html": page}, f"{len(page) / 1000:.0f} kB; runs in any browser, without a network connection.")


def live_page(circuit: BaseCircuit, *, parameters: Sequence[str] = ()) -> str:
    """Return the HTML text of a page that simulates a circuit.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a duration.
    parameters : sequence of str, optional
        Addresses of the parameters and inputs with a slider, with a range if the default range is not suitable:
        ``"tank.volume=50 l..400 l"``. The default is the inputs with signals, then the first parameters of the file.

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
    sliders = select_sliders(export_model, circuit, parameters)
    recording = circuit.simulate(throw=False)
    header, blobs = run_data(replace(export_model.problem, most_attempts=MAX_ATTEMPTS))
    with style("A live page"):
        content = page_content(export_model, circuit, recording, sliders)
    data = pack({**header, **content}, blobs)
    omitted = content["left_out"]
    notes = [f"Constant in the file's run, and without a curve here: {', '.join(omitted)}."] if omitted else []
    title, curves = circuit.title or "A circuit", _figure(content, float(grid[-1]))
    sections = [
        ("", head(title, _LEAD) + _read("body.html").replace(_CURVES, curves)),
        ("Notes of the run as in the file", findings([*recording.remarks, *notes])),
        ("", f'<script type="application/octet-stream" id="model">{data}</script>\n'),
    ]
    program = tight(_read("kernel.js") + _read("live.js"))
    return document(title, sections, style=tight(_read("live.css")), program=program)


def _figure(content: dict[str, Any], duration: float) -> str:
    """Return the HTML of the figure with curves and bars.

    The script of the page fills in the values.
    """
    name, size = content["time"]
    x: dict[str, Any] = {"label": f"time [{name}]", "range": [0.0, duration / size]}
    common: dict[str, Any] = {"group": 0, "share": 1.0}
    panels = []
    for k, panel in enumerate(content["panels"]):
        lines = [{"x": 0, "y": 1, "width": 1.4, **line} for line in panel["lines"]]
        # The lines of variant A have the same colours.
        variant = {"width": 1.1, "dash": [5, 3], "isKept": True}
        lines += [{**line, **variant, "label": f"{line['label']} (A)"} for line in lines]
        y = {"range": [0.0, 1.0], **panel["y"]}
        panels.append({**common, "x": x, "y": y, "lines": lines, "box": [1.0, 2.0 * k, 7.0, 1.6]})
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


@cache
def _read(name: str) -> str:
    return (files("poppet.deploy.live") / name).read_text(encoding="utf-8")

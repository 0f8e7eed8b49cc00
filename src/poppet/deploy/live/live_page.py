"""The live page: one file in which the model itself runs; nothing is asked of anybody."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.deploy.export_model import build_export_model
from poppet.deploy.live.content import content
from poppet.deploy.live.packing import packed, run_blobs
from poppet.deploy.live.page_inputs import chosen
from poppet.report.html_page import document, findings, head, write_page
from poppet.report.plots.scripts import data_element, tight
from poppet.timeseries.plotting.figures import style

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

_LEAD = "The model itself runs in this page. Change a number, and curves, bars and the drawing follow; * is assumed."
_CURVES = "<!-- curves -->"
MOST_ROWS = 2001
"""Rows that a page computes; a run with more has its rows further apart there."""
MOST_ATTEMPTS = 500_000
"""Steps after which a page gives up: a reader who drags waits for them."""


def write_live(circuit: Circuit, path: str | Path, *, numbers: Sequence[str] = ()) -> Path:
    """Write a page in which the circuit itself runs.

    Parameters
    ----------
    circuit : Circuit
        With a duration.
    path : str or Path
        Ends in `.html`.
    numbers : sequence of str, optional
        Addresses of the numbers and inputs that a reader may change, with a range where the usual one does not do:
        ``"tank.volume=50 l..400 l"``. By default the inputs that signals drive, and the first numbers that were
        written.

    Returns
    -------
    Path

    Raises
    ------
    InputErrors
        If a number is unknown, or cannot be changed while the model runs.

    Examples
    --------
    >>> import tempfile
    >>> from poppet import Chamber, Circuit, Orifice
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> circuit = Circuit({"tank": Chamber(volume="10 l", initial_pressure="5 bar"), "vent": vent})
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     page = write_live(circuit.with_values({"run.duration": "20 s"}), f"{folder}/page.html")
    ...     page.stat().st_size < 400_000
    True
    """
    return write_page(path, lambda: live_page(circuit, numbers=numbers))


def live_page(circuit: Circuit, *, numbers: Sequence[str] = ()) -> str:
    """The page as text."""
    grid = circuit.run.grid()
    if grid.size > MOST_ROWS:
        circuit = circuit.with_values({"run.output_step": float(grid[-1]) / (MOST_ROWS - 1)})
    given = build_export_model(circuit)
    sliders = chosen(given, circuit, numbers)
    recording = circuit.simulate(throw=False)
    header, blobs = run_blobs(replace(given.problem, most_attempts=MOST_ATTEMPTS))
    with style("A live page"):
        shown = content(given, circuit, recording, sliders)
    figure = _figure(shown, float(grid[-1]))
    model = f'<script type="application/octet-stream" id="model">{packed({**header, **shown}, blobs)}</script>\n'
    left_out, title = _left_out(shown["left_out"]), circuit.title or "A circuit"
    sections = [
        ("", head(title, _LEAD) + _text("body.html").replace(_CURVES, figure)),
        ("Notes of the run as in the file", findings([*recording.remarks, *left_out])),
        ("", model),
    ]
    program = tight(_text("kernel.js") + _text("live.js"))
    return document(title, sections, style=tight(_text("live.css")), program=program)


def _left_out(names: Sequence[str]) -> list[str]:
    return [f"Constant in the file's run, and without a curve here: {', '.join(names)}."] if names else []


def _figure(shown: dict[str, Any], duration: float) -> str:
    """The plot of curves and bars, whose columns the page fills."""
    name, size = shown["time"]
    x: dict[str, Any] = {"label": f"time [{name}]", "range": [0.0, duration / size]}
    common: dict[str, Any] = {"group": 0, "share": 1.0}
    panels = []
    for k, panel in enumerate(shown["panels"]):
        lines = [{"x": 0, "y": 1, "width": 1.4, **line} for line in panel["lines"]]
        # Of variant A, under the same colours.
        apart = {"width": 1.1, "dash": [5, 3], "isKept": True}
        lines += [{**line, **apart, "label": f"{line['label']} (A)"} for line in lines]
        y = {"range": [0.0, 1.0], **panel["y"]}
        panels.append({**common, "x": x, "y": y, "lines": lines, "box": [1.0, 2.0 * k, 7.0, 1.6]})
    if shown["bands"]:
        looks = {text: (colour, hatch) for band in shown["bands"] for _, text, colour, hatch in band["looks"]}
        boxes = [{"label": text, "colour": colour, "hatch": hatch, "at": []} for text, (colour, hatch) in looks.items()]
        rows = [[float(k), band["label"]] for k, band in enumerate(shown["bands"])]
        y = {"label": "", "range": [len(rows) - 0.5, -0.5]}
        panels.append({**common, "x": x, "y": y, "boxes": boxes, "rows": rows, "box": [1.0, 99.0, 7.0, 1.0]})
    for panel in panels[:-1]:
        panel["x"] = {**x, "label": "", "silent": True}
    data = {"columns": [[], []], "panels": panels}
    return f'<figure id="curves" aria-label="Curves and bars over time">{data_element(data)}</figure>\n'


@cache
def _text(name: str) -> str:
    """A file of the page's own."""
    return (files("poppet.deploy.live") / name).read_text(encoding="utf-8")

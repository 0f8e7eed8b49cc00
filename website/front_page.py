"""Front page of the website: a model with two sliders, its drawing and its plot, in one file without requests."""

from __future__ import annotations

import re
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import Any

import poppet
from poppet.deploy.export_model import build_export_model
from poppet.deploy.live.page_inputs import select_sliders
from poppet.deploy.live.page_kernel import kernel_script, pack_base64, run_data
from poppet.report.plots.interactive import minify

FOLDER = Path(__file__).resolve().parent / "front"
TEMPLATE = "valve-fill"
"""Template of `poppet new` that the page simulates."""
PILOT, VOLUME = "valve.pilot_pressure", "tank.volume"
OUTPUTS = {
    "supply": "supply.pressure", "pilot": PILOT, "tank": "tank.pressure", "temperature": "tank.temperature",
    "stroke": "valve.stroke", "fill": "valve.supply_mass_flow_rate", "exhaust": "valve.exhaust_mass_flow_rate",
    "leak": "bleed.mass_flow_rate",
}  # fmt: skip
"""Outputs of the drawing and of the plot, by their names in the script."""
HIGHEST_PILOT = 3.0  # gauge pressure [bar]
VOLUMES = (50, 400)  # [l]


@cache
def parts() -> dict[str, str]:
    """Return style, script, drawing and model of the front page as texts of an HTML page."""
    return {
        "style": re.sub(r"/\*.*?\*/", "", _text("front.css"), flags=re.DOTALL),
        "script": minify(kernel_script() + _text("front.js")),
        "model": _model(),
        "figure": _text("figure.html").replace("<!-- sketch -->", _text("sketch.svg")),
    }


def _model() -> str:
    """Return the compiled model of the template and the data of its sliders, as text."""
    template = (files("poppet.cli.templates") / f"{TEMPLATE}.toml").read_text(encoding="utf-8")
    # The steps of the output are as fine as the pixels of the plot.
    circuit = poppet.loads(template).with_values({"run.output_step": 0.2})
    export_model = build_export_model(circuit)
    sliders, mapping = select_sliders(export_model, circuit, [f"{VOLUME}={VOLUMES[0]} l..{VOLUMES[1]} l", PILOT])
    volume, pilot = sliders
    header, blobs = run_data(export_model.problem, mapping)
    addresses = [output.address for output in export_model.outputs]
    content: dict[str, Any] = {
        "outputs": {name: addresses.index(address) for name, address in OUTPUTS.items()},
        "volume": {"number": volume.number, "high": 1e3 * volume.high},
        "pilot": {**(pilot.course or {}), "input": pilot.inputs[0], "ambient": circuit.surroundings.pressure},
    }
    return pack_base64({**header, **content}, blobs)


def _text(name: str) -> str:
    return (FOLDER / name).read_text(encoding="utf-8")

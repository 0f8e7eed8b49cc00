"""What a page shows of a circuit, as data: panels and bars of its outputs, its drawing, its numbers."""

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
from poppet.timeseries.plotting.sheet import Sheet, axis_unit

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit
    from poppet.timeseries.recording import Recording

_SHOWN = {"Pa": "p", "m": "x", "rad": "angle", "N": "F", "N m": "M", "kg/s": "qm"}
"""Quantities that stand in the boxes of the drawing, by SI unit, the first ones first."""
_MOST_SHOWN, _WIDE = 3, 1.3  # lines of a box, and how wide it is at least [in]
_MOVES = {"stroke": "poppet", "position": "piston", "piston_position": "piston"}
_UNITS = {
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
"""Units in which a column of measured values may be given, by SI unit."""


def content(of: ExportModel, circuit: Circuit, recording: Recording, sliders: Sequence[Slider]) -> dict[str, Any]:
    """Everything besides the kernel and its arrays."""
    ambient = circuit.surroundings.pressure
    sheet = Sheet({"": recording}, None, None, "", inner=False)
    places = {each.address: k for k, each in enumerate(of.outputs)}
    return {
        "title": of.title,
        "time": [sheet.time_name, sheet.time_size],
        "sliders": [_slider(slider, ambient) for slider in sliders],
        "outputs": [_output(each.address, each.unit, ambient) for each in of.outputs],
        "panels": _panels(sheet, places, ambient),
        "bands": _bands(sheet, places),
        "left_out": [one.name for one in sheet.left_out],
        "drawing": _drawing(of, circuit, ambient),
        "units": {si: [[name, *affine(name, si, ambient)] for name in names] for si, names in _UNITS.items()},
        "n_inputs": max(1, len(of.inputs)),
    }


def _slider(slider: Slider, ambient: float) -> dict[str, Any]:
    factor, shift = slider.scale(ambient)
    found = asdict(slider)
    for name in ("low", "high", "least", "most"):
        # JSON has no infinite numbers.
        found[name] = min(max(found[name], -1e300), 1e300)
    return found | {"factor": factor, "shift": shift, "shown": pretty(slider.unit) if slider.unit != "1" else ""}


def _output(address: str, unit: str, ambient: float) -> dict[str, Any]:
    shown = USUAL.get(unit, unit)
    factor, shift = affine(unit, shown, ambient)
    return {"address": address, "si": unit, "unit": shown, "factor": factor, "shift": shift}


def _panels(sheet: Sheet, places: dict[str, int], ambient: float) -> list[dict[str, Any]]:
    """Panels as `plots.js` takes them; the lines name their outputs."""
    found = []
    for panel, colours in zip(sheet.panels, sheet.colours, strict=True):
        lines = [
            {"output": places[one.name], "label": panel.labels[one.name], "colour": colours[one.name],
             "step": one.is_staircase}
            for one in panel.series
        ]  # fmt: skip
        y: dict[str, Any] = {"label": " ".join((panel.quantity, axis_unit(panel))).strip()}
        if sheet._has_second_axis(panel):
            y["second"] = {"label": "l/min ANR", "factor": float(convert(1.0, panel.unit, "l/min ANR"))}
        found.append({"y": y, "lines": lines})
    return found


def _bands(sheet: Sheet, places: dict[str, int]) -> list[dict[str, Any]]:
    """Bars of codes: which output, what its codes mean, and the flow whose noise is no flow."""
    found = []
    for band in sheet.bands:
        flow = places.get(f"{band.name.removesuffix('regime')}mass_flow_rate", -1) if "regime" in band.name else -1
        looks = [[code, look.text, look.colour, look.is_hatched] for code, look in band.looks.items()]
        found.append({"output": places[band.name], "label": band.label, "looks": looks, "flow": flow, "still": STILL})
    return found


def _drawing(of: ExportModel, circuit: Circuit, ambient: float) -> dict[str, Any]:
    """The picture of the circuit with room in its boxes, what is shown there, and what moves."""
    inner = of.instance.inner
    shown: dict[str, list[dict[str, Any]]] = {}
    for unit, sign in _SHOWN.items():
        for k, each in enumerate(of.outputs):
            part, _, last = each.address.rpartition(".")
            part = part.partition(".")[0]
            if each.unit != unit or each.address in inner or part not in circuit.parts:
                continue
            shown.setdefault(part, []).append({"output": k, "sign": sign, "name": last.replace("_", " ")})
    shown = {part: items[:_MOST_SHOWN] for part, items in shown.items()}
    movers = {part: mover for part in shown if (mover := _mover(of, part))}
    free = {part: len(items) + 2 * (part in movers) for part, items in shown.items()}
    # The page has the title.
    figure, rooms = draw_with_empty_lines(replace(circuit, title="", like=circuit), free, _WIDE)
    svg = inline_svg(figure_bytes(figure, "svg", "circuit").decode("utf-8"), "circuit", f"The circuit {of.title}")
    by_part: dict[str, list[EmptyLine]] = {part: [room for room in rooms if room.part == part] for part in free}
    values = []
    for part, items in shown.items():
        lines = by_part[part]
        if part in movers:
            first, second = lines[:2]
            movers[part] |= {
                "x": first.x,
                "y": (first.y + second.y) / 2,
                "width": first.width,
                "height": 1.7 * first.height,
            }
            lines = lines[2:]
        values += [item | {"x": line.x, "y": line.y} for item, line in zip(items, lines, strict=True)]
    return {"svg": svg, "values": values, "movers": list(movers.values())}


def _mover(of: ExportModel, part: str) -> dict[str, Any] | None:
    """What moves in a part: its output, what it looks like, and its end stops where they are known."""
    for k, each in enumerate(of.outputs):
        owner, _, last = each.address.rpartition(".")
        if owner != part:
            continue
        if last in _MOVES and each.unit in ("m", "rad"):
            kind = "lever" if each.unit == "rad" else _MOVES[last]
            stops = of.instance.domains.get(each.address, (None, None))[1]
            return {"output": k, "kind": kind, "stops": list(stops) if stops else None}
    return None

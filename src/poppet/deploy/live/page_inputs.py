"""What a page lets its reader change: numbers and inputs with their ranges, in the units of whoever wrote them."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.number_format import USUAL, readable_unit
from poppet.core.provenance import Number
from poppet.core.units import convert, quantity
from poppet.deploy.export_model import ExportInput, ExportModel, ExportParameter
from poppet.timeseries.signals import Points, Steps

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

USUAL_CHOICE = 8
"""Numbers and inputs that a page offers where none are named."""
MOST_POINTS = 200
"""Points of a course that a page shows as a table."""
_TEMPERATURES = ("K", "degC")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*(.*)", re.DOTALL)


@dataclass(frozen=True)
class Slider:
    """A number or an input that may be changed, in SI; `unit` is what people read."""

    address: str
    value: float
    low: float  # of the slider
    high: float
    least: float  # that the number may have
    most: float
    si: str
    unit: str
    meaning: str
    source: str
    is_assumed: bool
    number: int  # place in p, -1 for none
    inputs: tuple[int, ...]  # inputs that take the number, or the one that it is
    is_driven: bool  # an input that a signal drives until somebody holds it
    # Where a reader may give it a course over time: that of the file as "steps" or "points", or none to begin with.
    course: dict[str, Any] | None = None
    delay: float = 0.0  # by which its course comes later [s]

    def scale(self, ambient_pressure: float) -> tuple[float, float]:
        """Factor and shift from SI to the unit."""
        return affine(self.si, self.unit, ambient_pressure)


def affine(unit: str, shown: str, ambient_pressure: float = 1e5) -> tuple[float, float]:
    """Factor and shift of a value from one unit to another."""
    at_zero, at_one = (float(convert(v, unit, shown, ambient_pressure=ambient_pressure)) for v in (0.0, 1.0))
    return at_one - at_zero, at_zero


def chosen(of: ExportModel, circuit: Circuit, texts: Sequence[str]) -> list[Slider]:
    """The sliders of a page: those named, as `ADDRESS` or `ADDRESS=LOW..HIGH`, or a choice of the usual ones."""
    if not texts:
        return _usual(of, circuit)
    found = []
    with ErrorCollector() as errors:
        for text in texts:
            address, _, span = (part.strip() for part in text.partition("="))
            with errors.collecting():
                slider = _slider(of, circuit, address)
                found.append(_within(slider, span, circuit) if span else slider)
    return list({slider.address: slider for slider in found}.values())


def _usual(of: ExportModel, circuit: Circuit) -> list[Slider]:
    """Driven inputs, then what was written with a unit, then what was assumed; temperatures and starts are left out."""
    written = circuit.numbers()
    plain = [
        each.address for each in of.numbers
        if each.is_free and each.value and each.unit not in _TEMPERATURES and each.address in written
        and not re.search(r"(^|[._])(initial|ambient|gas)_?", each.address) and each.unit != "1"
    ]  # fmt: skip
    kinds = {address: written[address].source.kind for address in plain}
    driven = [item.address for item in of.inputs if item.is_driven and item.slope_of < 0][:2]
    driven = [address for address in driven if not _is_guided(of, address)]
    ordered = [
        *driven,
        *(a for a in plain if kinds[a] == "given"),
        *(a for a in plain if kinds[a] == "assumed"),
        *plain,
    ]
    return [_slider(of, circuit, address) for address in list(dict.fromkeys(ordered))[:USUAL_CHOICE]]


def _is_guided(of: ExportModel, address: str) -> bool:
    """An input whose slope is another one: held, it would not move as the file says."""
    return any(item.slope_of >= 0 and of.inputs[item.slope_of].address == address for item in of.inputs)


def _slider(of: ExportModel, circuit: Circuit, address: str) -> Slider:
    inputs = {item.address: item for item in of.inputs}
    numbers = {each.address: each for each in of.numbers}
    # An input that nothing drives is its number.
    if address in inputs and (inputs[address].is_driven or inputs[address].number < 0):
        if _is_guided(of, address) or inputs[address].slope_of >= 0:
            raise InputError("deploy.live.guided", address)
        return _of_input(of, inputs[address], list(inputs).index(address), circuit)
    if address in inputs:
        address = of.numbers[inputs[address].number].address
    if address not in numbers:
        near = NameSuggestion(address, [*numbers, *inputs])
        raise InputError("names.unknown", address, meaning="a parameter or input of the circuit", near=near)
    if not numbers[address].is_free:
        raise InputError(f"deploy.live.{numbers[address].fixed}", address)
    return _of_number(of, numbers[address], circuit)


def _of_number(of: ExportModel, each: ExportParameter, circuit: Circuit) -> Slider:
    own = circuit.numbers()[each.address]
    place = of.model.parameters.index(each.address)
    takes = tuple(k for k, item in enumerate(of.inputs) if item.number == place and not item.is_driven)
    is_input = len(takes) == 1 and of.inputs[takes[0]].address == each.address and not _is_guided(of, each.address)
    low, high = _range(each.value, each.low, each.high, each.unit)
    source = "; ".join(filter(None, (own.source.kind, own.source.locator, own.source.note)))
    return Slider(
        each.address, each.value, low, high, each.low, each.high, each.unit, _unit_of(own, each.value), each.meaning,
        source, own.source.kind == "assumed", place, takes, is_driven=False,
        **(_course(of, circuit, takes[0]) if is_input else {}),
    )  # fmt: skip


def _of_input(of: ExportModel, item: ExportInput, place: int, circuit: Circuit) -> Slider:
    signal = circuit.signals.get(item.address)
    low, high = signal.bounds() if signal else (item.value, item.value)
    if not (math.isfinite(low) and math.isfinite(high) and low < high):
        low, high = _range(item.value, item.low, item.high, item.unit)
    else:
        low, high = max(item.low, low - 0.25 * (high - low)), min(item.high, high + 0.25 * (high - low))
    return Slider(
        item.address, item.value, low, high, item.low, item.high, item.unit, USUAL.get(item.unit, item.unit),
        "input, held while you say so", "a signal of the file", is_assumed=False, number=-1, inputs=(place,),
        is_driven=True, **_course(of, circuit, place),
    )  # fmt: skip


def _course(of: ExportModel, circuit: Circuit, place: int) -> dict[str, Any]:
    """The course of an input in the file, and its delay."""
    item, signal = of.model.inputs[place], circuit.signals.get(of.inputs[place].address)
    course: dict[str, Any] = {"kind": "steps", "times": [], "values": []}
    if isinstance(signal, (Steps, Points)) and len(signal.times) <= MOST_POINTS:
        course |= {"times": list(map(float, signal.times)), "values": list(map(float, signal.values))}
        course["kind"] = "steps" if isinstance(signal, Steps) else "points"
    return {"course": course, "delay": of.instance.parameters[item.delay] if item.delay else 0.0}


def _range(value: float, least: float, most: float, unit: str) -> tuple[float, float]:
    """Where a slider ends by itself: half and twice a value, 30 K about a temperature, within what is allowed."""
    if unit in _TEMPERATURES:
        low, high = value - 30.0, value + 30.0
    elif value == 0.0:
        low, high = (least if math.isfinite(least) else -1.0), (most if math.isfinite(most) else 1.0)
    else:
        low, high = sorted((0.5 * value, 2.0 * value))
    # Ends that do not belong to what is allowed lie a hair inside.
    margin = 1e-3 * (high - low)
    low = low if low > least else least + (0.0 if least == value else margin)
    high = high if high < most else most - (0.0 if most == value else margin)
    return low, high


def _unit_of(own: Number, value: float) -> str:
    """The unit in which a number was written, else one that is easy to read."""
    found = _NUMBER.fullmatch(own.text.strip())
    if found and found[1]:
        return found[1]
    return "degC" if own.unit == "K" and own.reference == "absolute" else readable_unit(own.unit, value)


def _within(slider: Slider, span: str, circuit: Circuit) -> Slider:
    """A slider between two values, as in `50 l..400 l`."""
    from dataclasses import replace

    low, dots, high = span.partition("..")
    if not dots:
        raise InputError("deploy.live.range", slider.address, text=span)
    ends = []
    for text in (low, high):
        kind = {"Pa": "pressure", "K": "temperature", "kg/s": "mass_flow"}.get(slider.si, "plain")
        read = quantity(_typed(text.strip()), slider.si, kind=kind, name=slider.address)  # type: ignore[arg-type]
        ends.append(read.value + (circuit.surroundings.pressure if read.reference == "gauge" else 0.0))
    if not slider.least <= ends[0] < ends[1] <= slider.most:
        raise InputError("deploy.live.range", slider.address, text=span)
    return replace(slider, low=ends[0], high=ends[1])


def _typed(text: str) -> float | str:
    try:
        return float(text)
    except ValueError:
        return text

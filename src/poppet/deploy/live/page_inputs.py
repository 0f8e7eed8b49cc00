"""Parameters and inputs with a slider on a page, with their ranges and display units."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from contextlib import suppress
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.circuit.onset import Onset, onset_field
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.number_format import USUAL, readable_unit
from poppet.core.provenance import Number, Source
from poppet.core.units import Kind, convert, quantity
from poppet.deploy.export_model import ExportModel, next_float, parameter_specs
from poppet.deploy.live.influence import STEP, influences
from poppet.deploy.live.parameter_map import TOLERANCE, ParameterMap, trace_parameters
from poppet.parts.fields import NumberSpec, attribute, specs
from poppet.timeseries.signals import Points, Steps

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

DEFAULT_COUNT = 8
"""Number of sliders if none are requested."""
MAX_POINTS = 200
"""Maximum number of points of a signal that the page shows as a table."""
_COEFFICIENT = re.compile(r"\.[a-z]\d+$")
_TEMPERATURES = ("K", "degC")
_NUMBER = re.compile(r"[+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?\s*(.*)", re.DOTALL)
_KINDS: dict[str, Kind] = {"Pa": "pressure", "K": "temperature", "kg/s": "mass_flow"}


@dataclass(frozen=True)
class Slider:
    """Slider of a live page for a parameter or an input.

    Values are in SI units, and `unit` is the display unit. The script of the page reads these fields by name.
    """

    address: str
    value: float
    low: float  # of the slider
    high: float
    least: float  # of the parameter
    most: float
    si: str
    unit: str
    meaning: str
    source: str
    is_assumed: bool
    number: int  # index in the values of the parameter map; -1 for an input that is not a parameter
    inputs: tuple[int, ...]  # indices of the inputs that take the parameter, or of the input itself
    is_driven: bool  # an input that a signal drives until the user sets it
    # Signal that the user can edit, with kind "steps" or "points"; no points if the file has no signal.
    course: dict[str, Any] | None = None
    delay: float = 0.0  # of the signal [s]
    above: float | None = None  # the value must be greater; None if `least` is permitted
    below: float | None = None  # the value must be less; None if `most` is permitted
    reference: str = ""  # "gauge" if the value and its limits are gauge pressures
    is_settable: bool = True  # False if only a signal can set the input

    def scale(self, ambient_pressure: float) -> tuple[float, float]:
        """Return factor and offset that convert SI values to the display unit."""
        return affine(self.si, self.unit, 0.0 if self.reference == "gauge" else ambient_pressure)


def affine(unit: str, display_unit: str, ambient_pressure: float = 1e5) -> tuple[float, float]:
    """Return factor and offset that convert values of a unit to a display unit.

    Gauge pressures are relative to the ambient pressure [Pa].
    """
    at_zero, at_one = (float(convert(v, unit, display_unit, ambient_pressure=ambient_pressure)) for v in (0.0, 1.0))
    return at_one - at_zero, at_zero


def select_sliders(
    export_model: ExportModel, circuit: BaseCircuit, texts: Sequence[str], displayed: Sequence[str] = ()
) -> tuple[list[Slider], ParameterMap]:
    """Return the sliders that the user requested, or a default selection, and their effect on the parameters.

    Each text is `ADDRESS` or `ADDRESS=LOW..HIGH`. `displayed` contains the addresses of the outputs that the page
    shows, or nothing for all outputs.
    """
    if not texts:
        texts = _default_addresses(export_model, circuit, displayed)
    sliders: dict[str, Slider] = {}
    with ErrorCollector() as errors:
        for text in texts:
            address, _, span = (part.strip() for part in text.partition("="))
            with errors.collecting():
                slider = _slider(export_model, circuit, address)
                if span:
                    slider = _with_range(slider, span, circuit.surroundings.pressure)
                elif slider.number >= 0:
                    slider = _within_valid_range(circuit, slider)
                if slider.number >= 0:
                    _check_continuity(circuit, slider)
                try:
                    circuit.with_values({slider.address: slider.value})
                except InputError:  # an input that is not also a parameter
                    slider = replace(slider, is_settable=False)
                sliders[slider.address] = slider
    # The value of an input with a signal is also a parameter, on which the start of the run can depend.
    own = [s.address for s in sliders.values() if s.number >= 0 or s.address in circuit.numbers()]
    mapping = trace_parameters(export_model, circuit, own)
    result = [replace(s, number=own.index(s.address)) if s.address in own else s for s in sliders.values()]
    with ErrorCollector() as errors:
        for slider in result:
            with errors.collecting():
                if slider.number >= 0:
                    _check_map(circuit, mapping, slider)
    return result, mapping


def _default_addresses(export_model: ExportModel, circuit: BaseCircuit, displayed: Sequence[str]) -> list[str]:
    """Return the addresses of the default sliders.

    They are two inputs with signals, then the numbers of the parts with the greatest influence on the curves. Flags
    such as `input_fault`, coefficients of curves, and numbers with the value 0, which gives no range, are omitted.
    """
    flags = {address for address, item in circuit.inputs.items() if item.is_flag}
    driven = [
        item.address
        for item in export_model.inputs
        if item.is_driven and item.slope_of < 0 and item.address not in flags
        and not _is_guided(export_model, item.address)
    ][:2]  # fmt: skip
    sliders = []
    for address, number in circuit.numbers().items():
        is_candidate = number.value and address.partition(".")[0] in circuit.parts and not _COEFFICIENT.search(address)
        if is_candidate and address not in driven:
            with suppress(InputError):
                sliders.append(_slider(export_model, circuit, address))
    sliders = [slider for slider in sliders if slider.number >= 0]
    outputs = [output.address for output in export_model.outputs]
    places = [outputs.index(address) for address in displayed] or list(range(len(outputs)))
    neighbours: list[list[BaseCircuit]] = [[] for _ in sliders]
    for slider, copies in zip(sliders, neighbours, strict=True):
        step = STEP * (slider.high - slider.low)
        for value in (slider.value + step, slider.value - step):
            with suppress(InputError):
                copies.append(changed_circuit(circuit, slider, value))
    ranks = influences(circuit, neighbours, places)
    order = sorted(range(len(sliders)), key=lambda k: -ranks[k])  # stable: equal ranks have the order of the file
    addresses = []
    for k in order:
        if ranks[k] > 0.0:
            with suppress(InputError):
                _check_continuity(circuit, _within_valid_range(circuit, sliders[k]))
                addresses.append(sliders[k].address)
    return [*driven, *addresses[: DEFAULT_COUNT - len(driven)]]


def changed_circuit(circuit: BaseCircuit, slider: Slider, value: float) -> BaseCircuit:
    """Return a copy of the circuit with another value of a slider, in SI units."""
    number = Number(value, slider.si, Source("given"), circuit.numbers()[slider.address].reference)
    return circuit.with_values({slider.address: number})


def _is_valid(circuit: BaseCircuit, slider: Slider, value: float) -> bool:
    try:
        changed_circuit(circuit, slider, value)
    except InputError:
        return False
    return True


def _within_valid_range(circuit: BaseCircuit, slider: Slider) -> Slider:
    """Return the slider with a range in which the circuit accepts all values.

    Other parameters can limit the range. For example, the bore of a cylinder limits its rod diameter. The ends of the
    range are then changed to these limits.
    """

    def last_valid(end: float) -> float:
        if _is_valid(circuit, slider, end):
            return end
        valid, invalid = slider.value, end
        for _ in range(40):
            middle = 0.5 * (valid + invalid)
            valid, invalid = (middle, invalid) if _is_valid(circuit, slider, middle) else (valid, middle)
        return valid

    low, high = last_valid(slider.low), last_valid(slider.high)
    if low > slider.low:
        slider = replace(slider, low=low, least=low, above=None)
    if high < slider.high:
        slider = replace(slider, high=high, most=high, below=None)
    return slider


def _check_continuity(circuit: BaseCircuit, slider: Slider) -> None:
    """Raise `InputError` if the circuit rejects values between the ends of a slider."""
    values = [slider.low + fraction * (slider.high - slider.low) for fraction in (0.0, 0.21, 0.48, 0.77, 1.0)]
    if slider.low >= slider.high or not all(_is_valid(circuit, slider, value) for value in values):
        raise InputError("deploy.live.single", slider.address)


def _check_map(circuit: BaseCircuit, mapping: ParameterMap, slider: Slider) -> None:
    """Raise `InputError` if the map differs from the circuit at the ends of a slider."""
    base, structure = np.array(list(circuit.parameters.values())), circuit.structure
    values = list(mapping.values)
    fixed = [k for k in range(base.size) if k not in mapping.places]
    places, conditions = list(mapping.places), circuit.problem(circuit.run).stop_conditions
    for value in (slider.low, slider.high):
        if slider.is_driven and not _is_valid(circuit, slider, value):
            continue
        changed = changed_circuit(circuit, slider, value)
        values[slider.number] = value
        expected = np.array(list(changed.parameters.values()))
        is_equal = changed.structure == structure and np.array_equal(expected[fixed], base[fixed])
        if not is_equal or not np.allclose(mapping.evaluate(values), expected[places], rtol=TOLERANCE, atol=0.0):
            raise InputError("deploy.live.tied", slider.address)
        for k, (old, new) in enumerate(zip(conditions, changed.problem(changed.run).stop_conditions, strict=True)):
            if old.weights != new.weights and k not in mapping.conditions:
                raise InputError("deploy.live.condition", slider.address)


def _is_guided(export_model: ExportModel, address: str) -> bool:
    """Return True if an input prescribes the motion of a body.

    The rate of change of such an input is a further input. A slider cannot set an input that prescribes a motion,
    because a constant value would not move the body.
    """
    inputs = export_model.inputs
    return any(item.slope_of >= 0 and inputs[item.slope_of].address == address for item in inputs)


def _slider(export_model: ExportModel, circuit: BaseCircuit, address: str) -> Slider:
    inputs = {item.address: item for item in export_model.inputs}
    parameters = {parameter.address: parameter for parameter in export_model.parameters}
    # An input without a signal is its parameter.
    numbers, item = circuit.numbers(), inputs.get(address)
    default = parameters.get(export_model.parameters[item.parameter].address) if item and item.parameter >= 0 else None
    if item is not None and (item.is_driven or default is None or default.address not in numbers):
        if _is_guided(export_model, address) or item.slope_of >= 0:
            raise InputError("deploy.live.guided", address)
        index, signal = list(inputs).index(address), circuit.signals.get(address)
        low, high = signal.bounds() if signal else (item.value, item.value)
        if not (math.isfinite(low) and math.isfinite(high) and low < high):
            low, high = default_range(item.value, item.low, item.high, item.unit)
        else:
            low, high = max(item.low, low - 0.25 * (high - low)), min(item.high, high + 0.25 * (high - low))
        source = "a signal of the file" if item.is_driven else "without a signal"
        return Slider(
            address, item.value, low, high, item.low, item.high, item.unit, USUAL.get(item.unit, item.unit),
            "input, constant while the slider sets it", source, is_assumed=False, number=-1, inputs=(index,),
            is_driven=item.is_driven, **_signal_and_delay(export_model, index),
        )  # fmt: skip
    if default is not None:
        address = default.address
    for onset, declared in circuit.inputs.items():
        if declared.is_onset and onset_field(onset, declared) == address:
            raise InputError("deploy.live.onset", address, input=onset)
    if address not in numbers:
        if address in parameters:
            raise InputError("deploy.live.derived", address)
        if _is_field(circuit, address):
            raise InputError("deploy.live.structure", address)
        near = NameSuggestion(address, [*numbers, *inputs])
        raise InputError("names.unknown", address, meaning="a parameter or input of the circuit", suggestion=near)
    if address in parameters and parameters[address].fixed == "driven":
        raise InputError("deploy.live.guided", address)
    number, spec = numbers[address], parameter_specs(circuit).get(address) or NumberSpec("1", address)
    # Limits are absolute; the value of a gauge pressure stays a gauge value.
    shift = circuit.surroundings.pressure if number.reference == "gauge" else 0.0
    value, least, most = number.value, spec.ends[0] - shift, spec.ends[1] - shift
    above = spec.above - shift if math.isfinite(spec.above) else None
    below = spec.below - shift if math.isfinite(spec.below) else None
    least = max(least, next_float(spec.above, 1.0) - shift)
    most = min(most, next_float(spec.below, -1.0) - shift)
    place = list(parameters).index(address) if address in parameters else None
    setters = tuple(k for k, i in enumerate(export_model.inputs) if i.parameter == place and not i.is_driven)
    is_input = len(setters) == 1 and list(inputs)[setters[0]] == address and not _is_guided(export_model, address)
    low, high = default_range(value, least, most, number.unit)
    source = "; ".join(filter(None, (number.source.kind, number.source.locator, number.source.note)))
    match = _NUMBER.fullmatch(number.text.strip())
    # The unit in which the user wrote the parameter, or a practical unit.
    if match and match[1]:
        unit = match[1]
    else:
        is_temperature = number.unit == "K" and number.reference == "absolute"
        unit = "degC" if is_temperature else readable_unit(number.unit, value)
        unit += " g" if number.reference == "gauge" else ""
    return Slider(
        address, value, low, high, least, most, number.unit, unit, spec.meaning, source,
        number.source.kind == "assumed", number=0, inputs=setters, is_driven=False, above=above, below=below,
        reference=number.reference,
        **(_signal_and_delay(export_model, setters[0]) if is_input else {}),
    )  # fmt: skip


def _is_field(circuit: BaseCircuit, address: str) -> bool:
    """Return True if an address belongs to a field of a part, or to a field of a section of the circuit file."""
    name, *path = address.split(".")
    owner = circuit.parts.get(name) or {"run": circuit.run, "gas": circuit.gas}.get(name)
    for field in path:
        if owner is None or field not in specs(type(owner)):
            return False
        owner = getattr(owner, attribute(field))
    return bool(path)


def _signal_and_delay(export_model: ExportModel, index: int) -> dict[str, Any]:
    """Return the signal and the delay of the input with the given index.

    The keys of the result are `course` and `delay`, the names of fields of a slider.
    """
    item = export_model.model.inputs[index]
    delay, signal = export_model.instance.parameters.get(item.delay, 0.0), export_model.instance.signals.get(item.name)
    if isinstance(signal, Onset):
        signal, delay = signal.delayed(delay), 0.0
    course: dict[str, Any] = {"kind": "steps", "times": [], "values": []}
    if isinstance(signal, (Steps, Points)) and len(signal.times) <= MAX_POINTS:
        course |= {"times": list(map(float, signal.times)), "values": list(map(float, signal.values))}
        course["kind"] = "steps" if isinstance(signal, Steps) else "points"
    return {"course": course, "delay": delay}


def default_range(value: float, lower_limit: float, upper_limit: float, unit: str) -> tuple[float, float]:
    """Return a default range for a slider, within the limits of the parameter.

    The range is half to twice the value, or 30 K on either side of a temperature. For the value 0, it extends to the
    limits; an infinite limit is replaced by -1 or 1.
    """
    if unit in _TEMPERATURES:
        low, high = value - 30.0, value + 30.0
    elif value == 0.0:
        low = lower_limit if math.isfinite(lower_limit) else -1.0
        high = upper_limit if math.isfinite(upper_limit) else 1.0
    else:
        low, high = sorted((0.5 * value, 2.0 * value))
    # A limit may be excluded: keep a small distance.
    margin = 1e-3 * (high - low)
    low = low if low > lower_limit else lower_limit + (0.0 if lower_limit == value else margin)
    high = high if high < upper_limit else upper_limit - (0.0 if upper_limit == value else margin)
    return low, high


def _with_range(slider: Slider, span: str, ambient_pressure: float) -> Slider:
    """Return the slider with the range of the text `span`, such as `50 l..400 l`."""
    if ".." not in span:
        raise InputError("deploy.live.range", slider.address, text=span)
    ends = []
    for text in map(str.strip, span.split("..", 1)):
        try:
            raw: float | str = float(text)
        except ValueError:
            raw = text
        end = quantity(raw, slider.si, kind=_KINDS.get(slider.si, "plain"), name=slider.address)
        ends.append(end.value + (ambient_pressure if end.reference == "gauge" else 0.0))
    if slider.reference == "gauge":
        ends = [end - ambient_pressure for end in ends]
    if not slider.least <= ends[0] < ends[1] <= slider.most:
        raise InputError("deploy.live.range", slider.address, text=span)
    return replace(slider, low=ends[0], high=ends[1])

"""Command `poppet convert`: conversion of units and of flow capacities such as C, Kv and Cv."""

from __future__ import annotations

import argparse
import math
import re
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.cli.assignments import read_value
from poppet.cli.commands import SIZES
from poppet.core.codes import Note
from poppet.core.errors import InputError, OutOfRangeError, UnitError

if TYPE_CHECKING:
    from poppet.laws.iso6358 import Conductance

_NAMES = {name.casefold(): name for name in SIZES} | {"effective_area": "area"}
"""Mapping from the lower-case name of a flow capacity to its name."""
_SI = {"C": "m^3/(s Pa)", "qNn": "m^3/s ANR", "area": "m^2"}
_SECOND_UNITS = {"C": "dm^3/(s bar)", "qNn": "m^3/s ANR", "area": "m^2"}
"""Second unit in which the result of a conversion is also printed, by flow capacity."""


def execute(options: argparse.Namespace) -> None:
    """Run the command `convert`: print a value in another unit, or as another flow capacity such as Kv."""
    from poppet.core.units import counted_at, with_state

    # A regular expression, because `float` would also accept `nan`, `inf` and `1_000`.
    match = re.fullmatch(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*", options.value)
    if not match:
        raise InputError("convert.no_number", value=options.value)
    # "1,2 bar" would be read as 1 of an unknown unit.
    if re.match(r",\d", match[2]):
        raise InputError(
            "convert.decimal_comma", value=options.value, mended=options.value.strip().replace(",", ".", 1)
        )
    if not match[2]:
        raise UnitError("convert.no_unit", value=options.value)
    number = float(match[1])
    if not math.isfinite(number):
        raise OutOfRangeError("convert.too_large", value=options.value)
    unit, to = match[2], options.to
    if not to.strip():
        raise UnitError("convert.no_target", sizes=tuple(SIZES))
    context, notes = _Context.read(options), []
    # A conversion between volume flows needs no reference state (for example ANR). Any other conversion does.
    if {counted_at(unit), counted_at(to)} != {"open"}:
        texts, (unit, to) = (unit, to), (with_state(unit), with_state(to))
        assumed = {raw: read for raw, read in zip(texts, (unit, to), strict=True) if raw != read}
        notes = [str(Note("doubt.read_as", unit=raw, read=read)) for raw, read in assumed.items()]
    source, target = _capacity_of(unit), _capacity_of(to)
    has_name = unit.casefold() in _NAMES or options.to.casefold() in _NAMES
    if has_name and source in _SI and unit.casefold() in _NAMES:
        code = "convert.name_or_celsius" if source == "C" else "convert.name"
        raise UnitError(code, value=options.value, name=unit, unit=SIZES[source])
    if has_name and (source is None or target is None):
        raise UnitError("convert.apart", value=options.value, to=options.to, sizes=tuple(SIZES))
    # Two units of one measure differ by the unit only; a name requests the conversion by C and b.
    if source is None or target is None or (source == target and not has_name):
        lines = _convert_unit(number, unit, to, context.ambient)
    else:
        target_unit = SIZES[target] if to.casefold() in _NAMES else to
        lines = _convert_capacity(number, (source, unit), (target, target_unit), context)
    print("\n  ".join([*lines, *notes]))


def _capacity_of(unit: str) -> str | None:
    """Return the kind of flow capacity (`C`, `Kv`, `Cv`, `qNn` or `area`) for its name or a unit.

    The result is None if the text is neither the name nor a unit of a flow capacity.
    """
    from poppet.core.units import counted_at, same_dimension

    if unit.casefold() in _NAMES:
        return _NAMES[unit.casefold()]
    for capacity in ("C", "area"):
        if same_dimension(unit, SIZES[capacity]):
            return capacity
    # A flow is a nominal flow only if its reference atmosphere is stated.
    return "qNn" if counted_at(unit) in ("ANR", "normal") else None


def _convert_unit(number: float, unit: str, to: str, ambient: float | None) -> list[str]:
    """Convert a value from one unit to another, and return the lines to print.

    `number` is the value in the unit `unit`, and `to` the requested unit. `ambient` is the absolute ambient pressure
    for gauge values [Pa]. If it is None, 1 bar is used.
    """
    from poppet.core.units import ANR, NORMAL, check_unit, convert, counted_at, same_dimension

    check_unit(unit)
    check_unit(to)
    # A line of the output states the default where it matters.
    ambient_pressure = 1e5 if ambient is None else ambient
    result = convert(number, unit, to, ambient_pressure=ambient_pressure)
    if not math.isfinite(result):
        raise OutOfRangeError("convert.too_large_in", number=number, unit=unit, to=to)
    for kind, si in (("pressure", "Pa"), ("temperature", "K")):
        if same_dimension(unit, si) and convert(number, unit, si, ambient_pressure=ambient_pressure) < 0.0:
            raise OutOfRangeError("convert.below_zero", number=number, unit=unit, kind=kind)
    lines = [f"{number:.10g} {unit} = {result:.10g} {to}"]
    if _is_gauge(unit) != _is_gauge(to):
        lines.append(f"gauge pressures refer to an ambient pressure of {ambient_pressure / 1e5:.7g} bar absolute")
    for state, atmosphere in (("ANR", ANR), ("normal", NORMAL)):
        if state in (counted_at(unit), counted_at(to)):
            lines.append(f"{state}: {atmosphere.source}; air of {atmosphere.density:.4g} kg/m^3")
    return lines


def _is_gauge(unit: str) -> bool:
    """Return True for a unit of gauge pressures, whose conversion depends on the ambient pressure."""
    from poppet.core.units import convert, same_dimension

    return same_dimension(unit, "Pa") and convert(0.0, unit, "Pa", ambient_pressure=1e5) != 0.0


class _Context(NamedTuple):
    """Options that affect the conversion between two kinds of flow capacity."""

    critical_ratio: float | None
    ambient: float | None
    definition: Any
    gas_name: str
    gas: dict[str, float]  # isentropic exponent and gas constant; empty for air

    @classmethod
    def read(cls, options: argparse.Namespace) -> _Context:
        """Read and check the options of the command line."""
        from poppet import library
        from poppet.core.tables import Field
        from poppet.core.units import quantity

        ratio = ambient = None
        if options.critical_ratio is not None:
            field = Field(unit="1", low=0.0, below=1.0, meaning="critical back-pressure ratio")
            ratio = float(field.read(options.critical_ratio, "--critical-ratio"))
        if options.ambient is not None:
            pressure = quantity(read_value(options.ambient), "Pa", kind="pressure", name="--ambient")
            if pressure.reference == "gauge":
                raise UnitError("convert.gauge_ambient", pressure=options.ambient)
            ambient = pressure.value
        if options.gas is None:
            return cls(ratio, ambient, options.definition, "", {})
        gas = library.gas(options.gas)
        constants = {"isentropic_exponent": float(gas.isentropic_exponent), "gas_constant": float(gas.gas_constant)}
        return cls(ratio, ambient, options.definition, gas.name, constants)

    def keywords(self, capacity: str) -> dict[str, Any]:
        """Return the keyword arguments for the conversion function of a kind of flow capacity, such as `Kv`."""
        if capacity in ("Kv", "Cv"):
            return {"definition": self.definition}
        if capacity == "area":
            return self.gas
        # The ambient pressure of gauge values; the conversion functions have the default.
        return {"atmosphere": self.ambient} if capacity == "qNn" and self.ambient is not None else {}

    def factors_from_air(self, capacity: str) -> tuple[float, float]:
        """Return factor and shift that convert C and b to the selected gas, see `iso6358.factors_from_air`.

        They are 1 and 0 if the gas is air, or if the kind of flow capacity does not refer to air or water.
        """
        from poppet.laws import iso6358

        is_of_air = self.gas and capacity in ("Kv", "Cv", "qNn")
        return iso6358.factors_from_air(**self.gas) if is_of_air else (1.0, 0.0)


def _convert_capacity(number: float, source: tuple[str, str], target: tuple[str, str], context: _Context) -> list[str]:
    """Convert a value between two kinds of flow capacity, and return the lines to print.

    `source` and `target` contain the kind, such as `Kv`, and the unit. The value is first converted to sonic
    conductance and critical pressure ratio.
    """
    from poppet.core.units import ANR, convert
    from poppet.laws import iso6358

    (source_name, source_unit), (target_name, target_unit) = source, target

    def format_value(value: float, unit: str) -> str:
        # Kv and Cv have no unit.
        return f"{convert(value, _SI[target_name], unit) if unit else value:.8g} {unit or target_name}"

    source_value = float(convert(number, source_unit, _SI[source_name])) if source_name in _SI else number
    conductance = _convert_to_conductance(source_name, source_value, context)
    b = conductance.critical_ratio
    factor, shift = context.factors_from_air(target_name)
    target_conductance, target_ratio = conductance.sonic_conductance / factor, (b - shift) / (1.0 - shift)
    functions: dict[str, Callable[..., float]] = {
        "C": lambda c, b: c,
        "area": lambda c, b, **gas: iso6358.effective_area_from_conductance(c, **gas),
        "Kv": iso6358.flow_coefficient_kv_from_conductance,
        "Cv": iso6358.flow_coefficient_cv_from_conductance,
        "qNn": iso6358.nominal_flow_from_conductance,
    }
    target_value = functions[target_name](target_conductance, target_ratio, **context.keywords(target_name))
    texts = [format_value(target_value, target_unit)]
    if target_unit == SIZES[target_name] and target_name in _SECOND_UNITS:
        texts.append(format_value(target_value, _SECOND_UNITS[target_name]))
    # The note of the inverse conversion states the definition and atmosphere of the target.
    inverse_note = _convert_to_conductance(target_name, target_value, context._replace(critical_ratio=b)).note
    ratio_note = "" if conductance.critical_ratio_assumed else f"b = {b:.4g}"
    notes = dict.fromkeys(filter(None, (conductance.note, inverse_note, ratio_note)))
    if "C" in (source_name, target_name) and context.gas:
        notes[f"C and b = {b:.4g} are those with {context.gas_name}"] = None
    if "qNn" in (source_name, target_name):
        notes[f"ANR: {ANR.source}"] = None
    return [f"{number:.10g} {source_unit} = {' = '.join(texts)}", *notes]


def _convert_to_conductance(capacity: str, value: float, context: _Context) -> Conductance:
    """Convert a flow capacity in SI units to sonic conductance and critical pressure ratio, with a note.

    They are valid for the selected gas. `capacity` is the kind of flow capacity, such as `Kv`. The note describes the
    conversion.
    """
    from poppet.laws import iso6358

    b = context.critical_ratio
    if capacity == "C":
        if b is not None:
            return iso6358.Conductance(value, b, "", False)
        b = iso6358.ASSUMED_CRITICAL_RATIO
        return iso6358.Conductance(value, b, f"b = {b:g} is assumed: C does not give it", True)
    functions: dict[str, Callable[..., Conductance]] = {
        "Kv": iso6358.conductance_from_flow_coefficient_kv,
        "Cv": iso6358.conductance_from_flow_coefficient_cv,
        "qNn": iso6358.conductance_from_nominal_flow,
        "area": iso6358.conductance_from_effective_area,
    }
    with_air = functions[capacity](value, critical_ratio=b, **context.keywords(capacity))
    factor, shift = context.factors_from_air(capacity)
    return replace(
        with_air,
        sonic_conductance=factor * with_air.sonic_conductance,
        critical_ratio=with_air.critical_ratio + (1.0 - with_air.critical_ratio) * shift,
    )

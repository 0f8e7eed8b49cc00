"""`poppet convert`: units, and the ways to say how much a passage lets through."""

from __future__ import annotations

import argparse
import math
import re
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any, NamedTuple

from poppet.cli.assignments import value
from poppet.cli.parser import Option
from poppet.core.codes import Note
from poppet.core.errors import InputError, OutOfRangeError, UnitError

if TYPE_CHECKING:
    from poppet.laws.iso6358 import Conductance

EXAMPLES = (
    'poppet convert "6 bar g" --to psi --ambient "1.013 bar"',
    'poppet convert "1.2 Kv" --to C --critical-ratio 0.35',
    'poppet convert "380 l/min ANR" --to C',
    'poppet convert "1 mm^2" --to C --gas helium',
)
SIZES = {
    "C": "m^3/(s Pa)",
    "Kv": "",
    "Cv": "",
    "qNn": "l/min ANR",
    "area": "mm^2",
}
"""Names of what can be asked for, with the unit that is printed when none is given."""
OPTIONS = (
    Option("VALUE", 'number and unit: "6 bar g", "1.2 Kv", "380 l/min ANR"'),
    Option("--to UNIT", f"a unit, or one of {', '.join(SIZES)}", more={"required": True}),
    Option("--ambient PRESSURE", "what gauge pressures refer to [Pa], with unit"),
    Option("--critical-ratio B", "critical ratio b of the passage; assumed when left out"),
    Option(
        "--definition NAME",
        "of Kv and Cv",
        choices={"pneumatic": "of pneumatic catalogues (default)", "small_dp": "of a liquid test"},
        more={"default": "pneumatic"},
    ),
    Option("--gas NAME", "gas that C and b are for (default air); Kv, Cv and qNn are stated with water or air"),
)
_NAMES = {name.casefold(): name for name in SIZES} | {"effective_area": "area"}
"""What a size may be called, in lower case."""
_SI = {"C": "m^3/(s Pa)", "qNn": "m^3/s ANR", "area": "m^2"}
_ALSO = {"C": "dm^3/(s bar)", "qNn": "m^3/s ANR", "area": "m^2"}


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    number, unit = _split(options.value)
    if not options.to.strip():
        raise UnitError("convert.no_target", sizes=tuple(SIZES))
    (unit, to), told = _stated(unit, options.to)
    ratio, ambient = _ratio(options.critical_ratio), _ambient(options.ambient)
    terms = _Terms(ratio, ambient, options.definition, *_gas(options.gas))
    source, target = _size_of(unit), _size_of(to)
    is_named = unit.casefold() in _NAMES or options.to.casefold() in _NAMES
    if is_named:
        _refuse_misfits(options, unit, source, target)
    # Between two units of one size nothing but the unit changes; a name asks for the way by C and b.
    if source is None or target is None or (source == target and not is_named):
        lines = _plain(number, unit, to, terms.ambient)
    else:
        wanted = SIZES[target] if to.casefold() in _NAMES else to
        lines = _passage(number, (source, unit), (target, wanted), terms)
    print("\n  ".join([*lines, *told]))
    return 0


def _stated(unit: str, to: str) -> tuple[list[str], list[str]]:
    """Both units with the state at which volume flows are counted, and what was taken for granted of it."""
    from poppet.core.units import counted_at, with_state

    # From one volume flow to another no state is needed.
    if {counted_at(unit), counted_at(to)} == {"open"}:
        return [unit, to], []
    stated = [with_state(unit), with_state(to)]
    told = {given: read for given, read in zip((unit, to), stated, strict=True) if given != read}
    return stated, [str(Note("doubt.read_as", unit=given, read=read)) for given, read in told.items()]


def _refuse_misfits(options: argparse.Namespace, unit: str, source: str | None, target: str | None) -> None:
    """Refuse a name instead of a unit, and a size together with something that is none."""
    if source in _SI and unit.casefold() in _NAMES:
        code = "convert.name_or_celsius" if source == "C" else "convert.name"
        raise UnitError(code, value=options.value, name=unit, unit=SIZES[source])
    if source is None or target is None:
        raise UnitError("convert.apart", value=options.value, to=options.to, sizes=tuple(SIZES))


def _split(text: str) -> tuple[float, str]:
    """Number and unit."""
    # By hand: `float` would also take `nan`, `inf` and `1_000`.
    found = re.fullmatch(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*?)\s*", text)
    if not found:
        raise InputError("convert.no_number", value=text)
    # "1,2 bar" would be read as 1 of an unknown unit.
    if re.match(r",\d", found[2]):
        raise InputError("convert.decimal_comma", value=text, mended=text.strip().replace(",", ".", 1))
    if not found[2]:
        raise UnitError("convert.no_unit", value=text)
    number = float(found[1])
    if not math.isfinite(number):
        raise OutOfRangeError("convert.too_large", value=text)
    return number, found[2]


def _ratio(text: str | None) -> float | None:
    from poppet.core.units import quantity

    if text is None:
        return None
    ratio = quantity(text, "1", name="--critical-ratio").value
    if not 0.0 <= ratio < 1.0:
        raise OutOfRangeError("convert.critical_ratio", ratio=text)
    return ratio


def _ambient(text: str | None) -> float | None:
    from poppet.core.units import quantity

    if text is None:
        return None
    read = quantity(value(text), "Pa", kind="pressure", name="--ambient")
    if read.reference == "gauge":
        raise UnitError("convert.gauge_ambient", pressure=text)
    return read.value


def _gas(name: str | None) -> tuple[str, dict[str, float]]:
    """Name, isentropic exponent and gas constant; nothing for air."""
    from poppet import library

    if name is None:
        return "", {}
    gas = library.gas(name)
    numbers = {"isentropic_exponent": float(gas.isentropic_exponent), "gas_constant": float(gas.gas_constant)}
    return gas.name, numbers


def _size_of(unit: str) -> str | None:
    """Which size of a passage a unit or name belongs to, if any."""
    from poppet.core.units import counted_at, same_dimension

    if unit.casefold() in _NAMES:
        return _NAMES[unit.casefold()]
    for size in ("C", "area"):
        if same_dimension(unit, SIZES[size]):
            return size
    # A flow of air is one of nominal flow only where its reference atmosphere is named.
    return "qNn" if counted_at(unit) in ("ANR", "normal") else None


def _plain(number: float, unit: str, to: str, ambient: float | None) -> list[str]:
    """A change of unit only."""
    from poppet.core.units import ANR, NORMAL, check_unit, convert, counted_at, same_dimension

    for given in (unit, to):
        check_unit(given)
    # A line below names it where it matters.
    gauge = 1e5 if ambient is None else ambient
    result = convert(number, unit, to, ambient_pressure=gauge)
    if not math.isfinite(result):
        raise OutOfRangeError("convert.too_large_in", number=number, unit=unit, to=to)
    for kind, si in (("pressure", "Pa"), ("temperature", "K")):
        if same_dimension(unit, si) and convert(number, unit, si, ambient_pressure=gauge) < 0.0:
            raise OutOfRangeError("convert.below_zero", number=number, unit=unit, kind=kind)
    lines = [f"{number:.10g} {unit} = {result:.10g} {to}"]
    if _is_gauge(unit) != _is_gauge(to):
        lines.append(f"gauge pressures refer to an ambient pressure of {gauge / 1e5:.7g} bar absolute")
    for mark, atmosphere in (("ANR", ANR), ("normal", NORMAL)):
        if mark in (counted_at(unit), counted_at(to)):
            lines.append(f"{mark}: {atmosphere.source}; air of {atmosphere.density:.4g} kg/m^3")
    return lines


def _is_gauge(unit: str) -> bool:
    """True when the unit marks a gauge pressure: it moves with the ambient pressure."""
    from poppet.core.units import convert, same_dimension

    return same_dimension(unit, "Pa") and convert(0.0, unit, "Pa", ambient_pressure=1e5) != 0.0


class _Terms(NamedTuple):
    """What C, Kv, Cv, qNn and areas depend on beside each other."""

    critical_ratio: float | None
    ambient: float | None
    definition: Any
    gas_name: str
    gas: dict[str, float]

    def of(self, size: str) -> dict[str, Any]:
        """Those on which the conversion of a size depends."""
        if size in ("Kv", "Cv"):
            return {"definition": self.definition}
        if size == "area":
            return self.gas
        # What the gauge pressures of the nominal flow refer to; as in the house where nothing is given.
        return {"atmosphere": self.ambient} if size == "qNn" and self.ambient is not None else {}

    def of_air(self, size: str) -> tuple[float, float]:
        """Factor and shift from C and b with air, or a liquid, to those with the gas, where a size is stated so."""
        from poppet.laws import iso6358

        return iso6358.factors_from_air(**self.gas) if self.gas and size in ("Kv", "Cv", "qNn") else (1.0, 0.0)


def _passage(number: float, given: tuple[str, str], to: tuple[str, str], terms: _Terms) -> list[str]:
    """From one way to say how much a passage lets through to another, by way of C and b."""
    from poppet.core.units import ANR, convert

    (source, unit), (target, wanted) = given, to

    def shown(value: float, unit: str) -> str:
        # Kv and Cv have no unit of their own.
        return f"{convert(value, _SI[target], unit) if unit else value:.8g} {unit or target}"

    size = float(convert(number, unit, _SI[source])) if source in _SI else number
    conductance = _conductance(source, size, terms)
    b = conductance.critical_ratio
    found = _size(target, conductance, terms)
    texts = [shown(found, wanted)]
    if wanted == SIZES[target] and target in _ALSO:
        texts.append(shown(found, _ALSO[target]))
    # The note of the way back names the target's definition and atmosphere; nothing is assumed again.
    back = _conductance(target, found, terms._replace(critical_ratio=b)).note
    known = "" if conductance.critical_ratio_assumed else f"b = {b:.4g}"
    notes = dict.fromkeys(filter(None, (conductance.note, back, known)))
    if "C" in (source, target) and terms.gas:
        notes[f"C and b = {b:.4g} are those with {terms.gas_name}"] = None
    if "qNn" in (source, target):
        notes[f"ANR: {ANR.source}"] = None
    return [f"{number:.10g} {unit} = {' = '.join(texts)}", *notes]


def _conductance(source: str, size: float, terms: _Terms) -> Conductance:
    """C and b of a size in SI, with the words that say how."""
    from poppet.laws import iso6358

    b = terms.critical_ratio
    if source == "C":
        if b is not None:
            return iso6358.Conductance(size, b, "", False)
        b = iso6358.ASSUMED_CRITICAL_RATIO
        return iso6358.Conductance(size, b, f"b = {b:g} is assumed: C does not give it", True)
    ways: dict[str, Callable[..., Conductance]] = {
        "Kv": iso6358.conductance_from_flow_coefficient_kv,
        "Cv": iso6358.conductance_from_flow_coefficient_cv,
        "qNn": iso6358.conductance_from_nominal_flow,
        "area": iso6358.conductance_from_effective_area,
    }
    by_air = ways[source](size, critical_ratio=b, **terms.of(source))
    factor, shift = terms.of_air(source)
    return replace(
        by_air,
        sonic_conductance=factor * by_air.sonic_conductance,
        critical_ratio=by_air.critical_ratio + (1.0 - by_air.critical_ratio) * shift,
    )


def _size(target: str, conductance: Conductance, terms: _Terms) -> float:
    """The size asked for, in SI."""
    from poppet.laws import iso6358

    factor, shift = terms.of_air(target)
    c, b = conductance.sonic_conductance / factor, (conductance.critical_ratio - shift) / (1.0 - shift)
    if target == "C":
        return c
    if target == "area":
        return iso6358.effective_area_from_conductance(c, **terms.gas)
    ways: dict[str, Callable[..., float]] = {
        "Kv": iso6358.flow_coefficient_kv_from_conductance,
        "Cv": iso6358.flow_coefficient_cv_from_conductance,
        "qNn": iso6358.nominal_flow_from_conductance,
    }
    return ways[target](c, b, **terms.of(target))

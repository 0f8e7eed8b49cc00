"""Conversion of values with units: gauge and absolute pressure, ANR and normal volume flow.

`poppet.core.unit_table` defines the notation of units. A text is converted in exact arithmetic and rounded once.
"""

from __future__ import annotations

import math
import re
from contextlib import suppress
from dataclasses import dataclass
from fractions import Fraction
from functools import lru_cache
from numbers import Real
from typing import Any, Literal, TypeVar, get_args

import numpy as np

from poppet.core.errors import InputError, OutOfRangeError, UnitError
from poppet.core.provenance import Reference
from poppet.core.unit_table import (
    CONDUCTANCE,
    MASS_FLOW,
    ONE,
    PRESSURE,
    SPELLINGS,
    TABLE,
    VOLUME_FLOW,
    Dimension,
    Unit,
    read_unit,
)

Kind = Literal[
    "plain", "pressure", "pressure_difference", "temperature", "temperature_difference", "mass_flow", "volume_flow_anr"
]
KINDS: tuple[Kind, ...] = get_args(Kind)

FloatOrArray = TypeVar("FloatOrArray", float, np.ndarray[Any, np.dtype[Any]])


@dataclass(frozen=True, slots=True)
class ReferenceAtmosphere:
    """Reference state of air for a volume flow.

    Parameters
    ----------
    temperature : float
        Absolute temperature [K].
    pressure : float
        Absolute pressure [Pa].
    density : float
        Density of air in this state [kg/m^3].
    source : str
        The standard that defines it.
    """

    temperature: float
    pressure: float
    density: float
    source: str


ANR = ReferenceAtmosphere(293.15, 100000.0, 1.185, "ISO 8778: 20 degC, 100 kPa, 65 % relative humidity")
NORMAL = ReferenceAtmosphere(
    273.15,
    101325.0,
    # The same air as ANR, so that a flow keeps its mass when it is restated: 1 m^3 ANR = 0.9196 m^3 normal.
    ANR.density * (ANR.temperature / 273.15) * (101325.0 / ANR.pressure),
    "DIN 1343: 0 degC, 101.325 kPa",
)


@dataclass(frozen=True, slots=True)
class Quantity:
    """Value in SI with its unit and reference.

    Parameters
    ----------
    value : float
        Value in `unit`. For a gauge pressure, it is the gauge value.
    unit : str
        The requested SI unit.
    reference : str
        `absolute`, `gauge` or `difference` for pressures and temperatures, else empty.
    """

    value: float
    unit: str
    reference: Reference


_Mark = Literal["", "gauge", "absolute", "ANR", "normal", "standard"]
_MARKS: dict[str, _Mark] = {
    **dict.fromkeys(("g", "gauge"), "gauge"),
    **dict.fromkeys(("a", "abs", "absolute"), "absolute"),
    "ANR": "ANR",
    "N": "normal",
}
_MARKED_DIMENSION = {"gauge": PRESSURE, "absolute": PRESSURE, "ANR": VOLUME_FLOW, "normal": VOLUME_FLOW}
# From decimal digits: factors are short fractions, and a conversion is rounded once.
_DENSITY = {"ANR": Fraction(repr(ANR.density)), "normal": Fraction(repr(NORMAL.density))}
# According to SEMI E12, standard litres have the state of normal litres; callers of `counted_at` add a note.
_DENSITY["standard"] = _DENSITY["normal"]
_MARKED = re.compile(r"(.*\S)\s*(?:\(\s*(gauge|absolute|abs|ANR|N|g|a)\s*\)|\s(gauge|absolute|abs|ANR|N|g|a))\s*")
_ATTACHED = re.compile(r"\s*([A-Za-z]+)([ga])\s*")
_NORMAL = re.compile(r"N(l|L|m\^?3)\s*(/.+)")
_ABBREVIATED: dict[str, tuple[str, _Mark]] = {
    "lpm": ("l/min", ""),
    "nlpm": ("l/min", "normal"),
    **dict.fromkeys(("slpm", "slm", "sl/min"), ("l/min", "standard")),
    "sccm": ("cm^3/min", "standard"),
}
"""Abbreviations of flow units on instruments, in lower case."""


@lru_cache(maxsize=4096)
def _unit_and_mark(text: str) -> tuple[Unit, _Mark]:
    """Return the unit in a text, and its mark: gauge, absolute, ANR or another reference.

    The letter `g` marks a gauge pressure, and `N` the normal state of a volume flow. In other positions, `g` is a gram
    and `N` a newton. The mark is empty if the text contains none.
    """
    text = text.translate(SPELLINGS).strip()
    if text.casefold() in _ABBREVIATED:
        written, mark = _ABBREVIATED[text.casefold()]
        return read_unit(written), mark
    match = _MARKED.fullmatch(text)
    if match:
        mark = _MARKS[match[2] or match[3]]
        head = None
        with suppress(UnitError):
            head = read_unit(match[1])
        if (
            head and head.dimension == _MARKED_DIMENSION[mark]
        ):  # otherwise `m N` is a torque, `m g` a length times a mass
            return head, mark
        if head and mark == "ANR" and head.dimension == CONDUCTANCE:
            raise UnitError("unit.conductance_marked", unit=text, plain=match[1])
    match = _NORMAL.fullmatch(text)
    if match:
        with suppress(UnitError):
            head = read_unit(match[1].replace("m3", "m^3") + match[2])
            if head.dimension == VOLUME_FLOW:
                return head, "normal"
    match = _ATTACHED.fullmatch(text)  # psig, bara
    if match and text not in TABLE and match[1] in TABLE and TABLE[match[1]].dimension == PRESSURE:
        return TABLE[match[1]], _MARKS[match[2]]
    return read_unit(text), ""


def is_known(unit: str) -> bool:
    """Return True if a text is a valid unit.

    Parameters
    ----------
    unit : str
        For example `m^3/(s Pa)`, `bar g`, `l/min ANR`.

    Returns
    -------
    bool

    Examples
    --------
    >>> is_known("l/min ANR"), is_known("furlong")
    (True, False)
    """
    try:
        _unit_and_mark(unit)
    except UnitError:
        return False
    return True


def unmarked_unit(unit: str) -> Unit:
    """Return a unit without its mark: `m^3/s ANR` becomes m^3/s, `bar g` becomes bar.

    Parameters
    ----------
    unit : str
        For example `m^3/s ANR`.

    Returns
    -------
    Unit
        Scale and dimension.

    Examples
    --------
    >>> unmarked_unit("l/min ANR") == unmarked_unit("l/min")
    True
    """
    return _unit_and_mark(unit)[0]


def stated_reference(unit: str) -> str:
    """Return the reference that a unit of pressure states: `gauge`, `absolute`, or an empty text.

    Parameters
    ----------
    unit : str
        Valid unit, for example `bar g` or `psi`.

    Examples
    --------
    >>> stated_reference("bar g"), stated_reference("psia"), stated_reference("kPa")
    ('gauge', 'absolute', '')
    """
    mark = _unit_and_mark(unit)[1]
    return mark if mark in ("gauge", "absolute") else ""


def check_unit(unit: str) -> None:
    """Raise an error if a text is not a valid unit.

    Parameters
    ----------
    unit : str
        For example `m^3/(s Pa)`, `bar g`, `l/min ANR`.

    Raises
    ------
    UnitError
        If the unit is invalid; the error suggests the closest unit.
    """
    _unit_and_mark(unit)


def same_dimension(first: str, second: str) -> bool:
    """Return True if both units are valid and `convert` can convert between them.

    Parameters
    ----------
    first, second : str
        Units.

    Returns
    -------
    bool

    Examples
    --------
    >>> same_dimension("bar g", "Pa"), same_dimension("l/min ANR", "kg/s"), same_dimension("rad/s", "Hz")
    (True, True, False)
    """
    return is_known(first) and is_known(second) and _flow_dimension(first) == _flow_dimension(second)


def unit_in(text: Any, unit: str) -> str:
    """Return the unit in the text of a value.

    Parameters
    ----------
    text : str
        Text such as `500 l/min ANR`; a value of another type has no unit.
    unit : str
        Unit of the expected dimension.

    Returns
    -------
    str
        The unit as written; empty if the text has no unit of this dimension.

    Examples
    --------
    >>> unit_in("500 l/min ANR", "m^3/s ANR"), unit_in("500", "m^3/s ANR"), unit_in("2 mm", "s")
    ('l/min ANR', '', '')
    """
    match = _NUMBER.fullmatch(text) if isinstance(text, str) else None
    written = match[2].strip() if match else ""
    return written if written and is_known(written) and same_dimension(written, unit) else ""


def _flow_dimension(unit: str) -> Dimension:
    """Return the physical dimension of a unit.

    A volume flow with a reference state has the dimension of a mass flow, because it can be converted to one.
    """
    parsed, mark = _unit_and_mark(unit)
    return MASS_FLOW if mark in _DENSITY else parsed.dimension


def counted_at(text: str) -> str:
    """Return the reference state of a volume flow.

    Parameters
    ----------
    text : str
        For example `380 l/min ANR`.

    Returns
    -------
    str
        `ANR`, `normal`, `standard` (slpm: manufacturers differ), `open` (l/min: not specified), or empty if the unit is
        not a volume flow.

    Examples
    --------
    >>> [counted_at(text) for text in ("380 l/min", "380 Nl/min", "380 slpm", "6 bar", "0.2")]
    ['open', 'normal', 'standard', '', '']
    """
    number = _NUMBER.fullmatch(text)
    try:
        parsed, mark = _unit_and_mark(number[2] if number else text)
    except UnitError:
        return ""
    return (mark or "open") if parsed.dimension == VOLUME_FLOW else ""


def with_state(text: str) -> str:
    """Return a volume flow with its reference state: normal for slpm, otherwise ANR.

    Parameters
    ----------
    text : str
        A unit, or a number with its unit, for example `380 l/min`.

    Returns
    -------
    str
        Unit with a reference state; the text itself if it needs none.

    Examples
    --------
    >>> with_state("l/min"), with_state("380 slpm"), with_state("l/min N"), with_state("bar")
    ('l/min ANR', '380 l/min N', 'l/min N', 'bar')
    """
    mark = {"open": " ANR", "standard": " N"}.get(counted_at(text))
    return f"{_without_abbreviations(text)}{mark}" if mark else text


def _without_abbreviations(text: str) -> str:
    """Replace an instrument abbreviation such as `slpm` in a volume flow by the unit, `l/min`."""
    number = _NUMBER.fullmatch(text)
    unit = (number[2] if number else text).strip()
    plain_unit = _ABBREVIATED.get(unit.casefold(), (unit, ""))[0]
    return f"{number[1]} {plain_unit}" if number else plain_unit


def convert(value: FloatOrArray, from_unit: str, to_unit: str, *, ambient_pressure: float = 100000.0) -> FloatOrArray:
    r"""Convert a value to another unit.

    .. math:: p = p_\mathrm{gauge} + p_\mathrm{ambient}, \qquad q_m = \rho_0\, q_{V,\mathrm{ANR}}

    Parameters
    ----------
    value : float or (...) array
        In `from_unit`.
    from_unit, to_unit : str
        Units. An unmarked pressure is absolute; `g` marks a gauge pressure. `ANR` and `N` (normal) mark the reference
        state of a volume flow. `Nl/min` is short for `l/min N`; `slpm` raises an error because its reference state is
        ambiguous.
    ambient_pressure : float, optional
        Absolute pressure to which gauge values refer [Pa].

    Returns
    -------
    float or (...) array
        In `to_unit`.

    Notes
    -----
    degC and degF are temperatures, not differences. ANR and normal flows are flows of air: the two densities are not
    valid for another gas.

    References
    ----------
    ISO 8778 (ANR), DIN 1343 (normal), ISO 6358-1 (density 1.185 kg/m^3 at ANR).

    Examples
    --------
    >>> convert(6.0, "bar g", "Pa")
    700000.0
    >>> round(convert(1.0, "m^3/h ANR", "m^3/h N"), 4)
    0.9196
    """
    if from_unit == to_unit:
        return value
    (source, source_mark), (target, target_mark) = _unit_and_mark(from_unit), _unit_and_mark(to_unit)
    if "standard" in (source_mark, target_mark):
        raise UnitError("unit.standard_flow", unit=from_unit if source_mark == "standard" else to_unit)
    if _flow_dimension(from_unit) != _flow_dimension(to_unit):
        lacks_state = {source.dimension, target.dimension} == {VOLUME_FLOW, MASS_FLOW}
        code = "unit.flow_without_state" if lacks_state else "unit.other_quantity"
        raise UnitError(code, unit=from_unit, asked=to_unit)
    source_shift, target_shift = _shift(source_mark, ambient_pressure), _shift(target_mark, ambient_pressure)
    factor = _si_factor(source, source_mark) / _si_factor(target, target_mark)
    # One sum: equal references cancel exactly, and a conversion without shift is one product.
    shift = source.offset * factor - target.offset + (source_shift - target_shift) / target.scale
    # Two roundings of exact numbers keep more digits than one of a rounded factor.
    is_exact = factor.numerator < 2**53 and factor.denominator < 2**53
    # Overflow becomes infinite, in arrays and floats.
    with np.errstate(over="ignore"):
        result = value * float(factor.numerator) / float(factor.denominator) if is_exact else value * float(factor)
        return result + float(shift) if shift else result


def exact_scale(unit: str) -> tuple[Unit, bool]:
    """Return the exact factor and offset of a unit, and True if it is a gauge pressure.

    A volume flow with a reference state has the factor and the dimension of its mass flow.

    Parameters
    ----------
    unit : str
        For example `l/min ANR`; a volume flow without a reference state has the factor of m^3/s.

    Returns
    -------
    tuple of Unit and bool

    Examples
    --------
    >>> scale, is_gauge = exact_scale("mbar g")
    >>> scale.scale, is_gauge
    (Fraction(100, 1), True)
    """
    parsed, mark = _unit_and_mark(unit)
    return Unit(_flow_dimension(unit), _si_factor(parsed, mark), parsed.offset), mark == "gauge"


def _shift(mark: _Mark, ambient_pressure: float) -> Fraction:
    return Fraction(ambient_pressure) if mark == "gauge" else Fraction(0)


def _si_factor(unit: Unit, mark: _Mark) -> Fraction:
    """Return the factor that converts a unit to SI.

    A volume flow with a reference state becomes a mass flow.
    """
    return unit.scale * _DENSITY.get(mark, Fraction(1))


_NUMBER = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)(.*)", re.DOTALL)
_DECIMAL_COMMA = re.compile(r"\s*([+-]?\d+),(\d+)(.*)", re.DOTALL)
_THOUSANDS = re.compile(r"\s*[+-]?[1-9]\d{0,2}(,\d{3})+(?!\d)")
_ALLOWED_MARKS: dict[Kind, tuple[_Mark, ...]] = {
    "pressure": ("", "gauge", "absolute"),
    "mass_flow": ("", "ANR", "normal", "standard"),
    "volume_flow_anr": ("ANR", "normal", "standard"),
}
_REFERENCE: dict[Kind, Reference] = {
    "pressure": "absolute",
    "pressure_difference": "difference",
    "temperature": "absolute",
    "temperature_difference": "difference",
}

SMALLEST, LARGEST = 1e-30, 1e30
_RANGES = {
    "Pa": (1e-9, 1e12),
    "K": (1e-3, 1e6),
    "s": (1e-12, 1e12),
    "Hz": (1e-12, 1e9),
    "m": (1e-12, 1e6),
    "m^2": (1e-20, 1e4),
    "m^3": (1e-18, 1e9),
    "kg": (1e-15, 1e9),
    "kg/s": (1e-20, 1e6),
    "m^3/s ANR": (1e-20, 1e6),
    "m^3/(s Pa)": (1e-20, 1.0),
    "N": (1e-12, 1e12),
    "N/m": (1e-12, 1e15),
    "N s/m": (1e-12, 1e12),
    "J/K": (1e-15, 1e15),
    "W/K": (1e-15, 1e9),
}
"""Plausibility limits by SI unit: a value outside is a typing error, and its model would take minutes. The lower limits
apply to values that must be above zero."""


def sizes_of(unit: str) -> tuple[float, float]:
    """Return the smallest and the largest plausible magnitude for an SI unit.

    poppet rejects quantities above the largest magnitude. A quantity that must be positive is also rejected below the
    smallest one.

    Parameters
    ----------
    unit : str
        SI unit as fields declare it, `m^3/(s Pa)`.

    Returns
    -------
    tuple of float
        Smallest and largest magnitude, in the unit; 1e-30 and 1e30 if the unit has no defined range.
    """
    return _RANGES.get(unit, (SMALLEST, LARGEST))


def quantity(
    argument: str | float | int, unit: str, *, kind: Kind = "plain", name: str = "value", is_told: bool = False
) -> Quantity:
    """Convert a value with a unit, or a bare number, to SI.

    Parameters
    ----------
    argument : str or float
        Value with a unit, `"6 bar g"`, or a bare number in SI; a bare pressure is absolute.
    unit : str
        SI unit of the field, `m^3/(s Pa)`; `1` if it is dimensionless.
    kind : str, optional
        Kind of quantity: see Notes.
    name : str, optional
        Name or address of the field, for messages.
    is_told : bool, optional
        True to accept flows without a reference state: `l/min` is read at ANR, `slpm` at 0 degC and 1.01325 bar. The
        caller must then add a note. If False, such flows raise an error.

    Returns
    -------
    Quantity
        In `unit`.

    Raises
    ------
    UnitError
        If the unit is missing, unknown, of another quantity or of another reference.
    InputError
        If the value is not a finite number.
    OutOfRangeError
        If an absolute pressure or temperature is below zero, or a value exceeds the plausibility limit.

    Notes
    -----
    Kinds of quantities:

    - `pressure` accepts gauge pressures (`6 bar g`, `6 bar(g)`, `6 barg`) and returns the gauge value.
    - `pressure_difference` has no reference.
    - `temperature` accepts degC and degF, `temperature_difference` only K.
    - `mass_flow` also accepts volume flows of air: `380 l/min ANR`, or `380 l/min N` and `380 Nl/min` (normal).
    - `volume_flow_anr` accepts only such volume flows.

    Examples
    --------
    >>> quantity("6 bar g", "Pa", kind="pressure")
    Quantity(value=600000.0, unit='Pa', reference='gauge')
    >>> quantity("20 degC", "K", kind="temperature").value
    293.15
    >>> quantity("1.65 dm^3/(s bar)", "m^3/(s Pa)").value
    1.65e-08
    """
    try:
        if isinstance(argument, str):
            return _from_text(argument, unit, kind, is_told)
        # Python treats True as an integer.
        if isinstance(argument, (bool, np.bool_)) or not isinstance(argument, Real):
            raise InputError("quantity.not_a_number", example=_example(unit, kind))
        try:
            value = float(argument)
        except OverflowError:  # an integer of more than 308 digits
            value = math.inf
        return _checked(value, unit, kind, "")
    except InputError as problem:
        display = f'"{argument}"' if isinstance(argument, str) else repr(argument)
        raise type(problem)(problem.code, name, shown=display, **problem.facts) from None


@lru_cache(maxsize=4096)
def _from_text(text: str, unit: str, kind: Kind, is_told: bool) -> Quantity:
    if _DECIMAL_COMMA.fullmatch(text):
        with_point, without = text.strip().replace(",", ".", 1), text.strip().replace(",", "")
        if _THOUSANDS.match(text):  # 1,500 is ambiguous
            raise InputError("quantity.comma", with_point=with_point, without=without)
        raise InputError("quantity.decimal_comma", with_point=with_point)
    match = _NUMBER.fullmatch(text)
    if match is None:
        raise InputError("quantity.no_number", example=_example(unit, kind))
    number, unit_text = match[1], match[2]
    if unit_text.startswith("_"):  # only Python accepts 1_000
        raise InputError("quantity.underscore")
    if not unit_text.strip():
        if _unit_and_mark(unit)[0].dimension != ONE:
            raise UnitError("quantity.no_unit", number=number, unit=unit)
        return _checked(float(number), unit, kind, "")
    try:
        parsed, mark = _unit_and_mark(unit_text)
    except UnitError as problem:
        raise UnitError("quantity.unreadable_unit", cause=problem) from None
    if kind in ("mass_flow", "volume_flow_anr") and parsed.dimension == VOLUME_FLOW and mark in ("", "standard"):
        if not is_told:
            code = "quantity.standard_flow" if mark else "quantity.flow_without_state"
            raise UnitError(code, flow=_without_abbreviations(text), stated=with_state(text))
        mark = mark or "ANR"
    _check_unit(text, parsed, mark, unit, kind)
    return _checked(_in_si(number, parsed, mark, unit), unit, kind, mark)


def _check_unit(text: str, parsed: Unit, mark: _Mark, unit: str, kind: Kind) -> None:
    """Raise an error if a unit cannot be converted to the required unit.

    `parsed` is the unit in `text`, `mark` its reference (such as gauge), and `unit` the required unit. `kind` is the
    kind of quantity, for example a pressure difference.
    """
    target = _unit_and_mark(unit)[0].dimension
    if mark in ("gauge", "absolute") and kind != "pressure" and target == PRESSURE:
        raise UnitError("quantity.gauge_difference" if mark == "gauge" else "quantity.absolute_difference")
    dimension = MASS_FLOW if kind == "mass_flow" and mark else parsed.dimension
    if mark not in _ALLOWED_MARKS.get(kind, ("",)) or dimension != target:
        raise UnitError("quantity.other_quantity", unit=unit, example=_example(unit, kind))
    if parsed.offset and kind != "temperature":
        raise UnitError("quantity.point_of_scale")


def _in_si(number: str, parsed: Unit, mark: _Mark, unit: str) -> float:
    # As a float first: a fraction of 1e999999999 would be written out digit by digit, and -0 would lose its sign.
    if not math.isfinite(float(number)) or (float(number) == 0.0 and not parsed.offset):
        return float(number)
    target, target_mark = _unit_and_mark(unit)
    try:
        return float((Fraction(number) + parsed.offset) * _si_factor(parsed, mark) / _si_factor(target, target_mark))
    except OverflowError:
        return math.inf


def _checked(value: float, unit: str, kind: Kind, mark: _Mark) -> Quantity:
    if not math.isfinite(value):
        raise InputError("quantity.not_finite")
    if abs(value) > (limit := sizes_of(unit)[1]):
        raise OutOfRangeError("quantity.too_large", most=limit, unit=unit)
    if kind in ("pressure", "temperature") and mark != "gauge" and value < 0.0:
        is_pressure = kind == "pressure"
        raise OutOfRangeError("quantity.pressure_below_zero" if is_pressure else "quantity.temperature_below_zero")
    return Quantity(value, unit, "gauge" if mark == "gauge" else _REFERENCE.get(kind, ""))


_EXAMPLES: dict[Kind, str] = {
    "pressure": '"6 bar" or "6 bar g"',
    "temperature": '"293.15 K" or "20 degC"',
    "mass_flow": '"0.0075 kg/s" or "380 l/min ANR"',
    "volume_flow_anr": '"380 l/min ANR"',
}


def _example(unit: str, kind: Kind) -> str:
    return _EXAMPLES.get(kind, '"0.2"' if unit == "1" else f'"0.2 {unit}"')

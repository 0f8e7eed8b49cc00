"""Tariff of compressed air: cost and CO2 of a volume of air, per year of operation."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, UnitError
from poppet.core.provenance import Number
from poppet.core.units import convert, same_dimension
from poppet.parts.fields import NumberSpec, default_number, read_number, split_source

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

FIELDS = {
    "specific_energy": NumberSpec(
        doc="electrical energy of the compressor station per volume of air",
        unit="J/m^3",
        above=0.0,
        usual_unit="kWh/m^3",
        default="0.12 kWh/m^3",
        note="screw compressor with dryer at 7 bar g",
    ),
    "emission": NumberSpec(
        doc="emission of CO2 per electrical energy", unit="kg/J", low=0.0, usual_unit="kg/kWh", optional=True
    ),
    "hours": NumberSpec(
        doc="operating time per year",
        unit="s",
        above=0.0,
        high=366 * 86400.0,
        usual_unit="h",
        default="4000 h",
        note="two shifts",
    ),
}
"""Fields of a tariff, except its price."""
EXAMPLES = ("0.20 EUR/kWh", "0.02 EUR/m^3")
UNIT_EXAMPLES = {"specific_energy": "0.12 kWh/m^3", "emission": "0.4 kg/kWh", "hours": "4000 h"}
_PRICE = re.compile(r"\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*([^\W\d_]+|[$€£¥])\s*/\s*(\S.*?)\s*")


@dataclass(frozen=True)
class Tariff:
    """Tariff that converts volumes of air to electricity, cost and CO2.

    Volumes of air are at ANR. The function `read_tariff` creates a tariff from texts.

    Parameters
    ----------
    price : Number or None
        Price per energy or per volume of air, with a unit such as `EUR/J` or `EUR/m^3`. The result of `cost` is NaN
        without a price.
    specific_energy : Number
        Electrical energy of the compressor station per volume of air [J/m^3].
    emission : Number or None
        Emission of CO2 per electrical energy [kg/J]. The result of `co2` is NaN without this value.
    hours : Number
        Operating time per year [s].
    """

    price: Number | None
    specific_energy: Number
    emission: Number | None
    hours: Number

    @property
    def currency(self) -> str:
        """Currency of the price, as the user wrote it; empty without a price."""
        return self.price.unit.partition("/")[0] if self.price else ""

    def electricity(self, volume: float) -> float:
        """Return the electrical energy [J] for a volume of air [m^3 ANR]."""
        return volume * float(self.specific_energy)

    def cost(self, volume: float) -> float:
        """Return the cost of a volume of air [m^3 ANR] in the currency of the price; NaN without a price."""
        if self.price is None:
            return math.nan
        is_air_price = self.price.unit.endswith("/m^3")
        return float(self.price) * (volume if is_air_price else self.electricity(volume))

    def co2(self, volume: float) -> float:
        """Return the mass of CO2 [kg] for a volume of air [m^3 ANR]; NaN without an emission."""
        return math.nan if self.emission is None else self.electricity(volume) * float(self.emission)

    def cycles_per_year(self, duration: float) -> float:
        """Return the number of cycles of a given duration [s] in the operating time of a year."""
        return float(self.hours) / duration

    def numbers(self) -> Iterator[tuple[str, Number]]:
        """Yield name and value of each field that the tariff has."""
        for name, number in (("tariff", self.price), *((name, getattr(self, name)) for name in FIELDS)):
            if number is not None:
                yield name, number

    def content(self) -> dict[str, Any]:
        """Return the fields as texts with units, with their sources, for result files."""
        return {name: {"value": number.display(), "source": str(number.source)} for name, number in self.numbers()}


def read_tariff(table: Mapping[str, Any] | None = None, address: str = "") -> Tariff:
    """Return the tariff that a table of texts describes.

    Parameters
    ----------
    table : mapping, optional
        Fields `tariff` (`0.20 EUR/kWh` for electricity, `0.02 EUR/m^3` for air at ANR), `specific_energy`
        (`0.12 kWh/m^3`), `emission` (`0.4 kg/kWh`) and `hours` (`4000 h`, per year). A value can be a table with the
        fields `value`, `source`, `locator` and `note`.
    address : str, optional
        Address of the table, for messages.

    Returns
    -------
    Tariff
        Tariff with the given fields. Missing fields have their default, which is an assumption, or None.

    Raises
    ------
    InputError
        If a field is unknown, has no unit, or has a unit of another quantity.

    Examples
    --------
    >>> tariff = read_tariff({"tariff": "0.20 EUR/kWh", "specific_energy": "0.12 kWh/m^3"})
    >>> round(tariff.cost(1000.0), 9), tariff.currency, tariff.co2(1000.0)
    (24.0, 'EUR', nan)
    """
    table = table or {}
    prefix = f"{address}." if address else ""
    values: dict[str, Number | None] = {"price": None}
    with ErrorCollector() as errors:
        if not isinstance(table, Mapping):
            raise InputError("fields.no_table", address, value=table)
        for key in table.keys() - {"tariff", *FIELDS}:
            suggestion = NameSuggestion(key, ("tariff", *FIELDS))
            errors.add("fields.unknown", f"{prefix}{key}", table="tariff", suggestion=suggestion)
        if table.get("tariff") is not None:
            with errors.collecting():
                values["price"] = _read_price(f"{prefix}tariff", table["tariff"])
        for name, spec in FIELDS.items():
            values[name] = default_number(name, spec)
            if table.get(name) is not None:
                with errors.collecting():
                    value, _ = split_source(f"{prefix}{name}", table[name])
                    # In SI units, these numbers have unusual sizes, so a number without a unit is most likely wrong.
                    if _is_bare(value):
                        facts: dict[str, Any] = {"value": value, "example": UNIT_EXAMPLES[name]}
                        raise UnitError("tariff.bare_number", f"{prefix}{name}", **facts)
                    values[name] = _read_field(f"{prefix}{name}", name, table[name])
    return Tariff(**values)  # type: ignore[arg-type]


def _read_field(address: str, name: str, argument: Any) -> Number:
    """Return the number of a field; errors have examples in its usual unit."""
    spec = FIELDS[name]
    try:
        return read_number(address, spec, argument)
    except InputError as error:
        if "example" in error.facts:
            error.facts["example"] = f'"{UNIT_EXAMPLES[name]}"'
            error.facts |= {"unit": spec.usual_unit} if "unit" in error.facts else {}
        raise


def _is_bare(value: Any) -> bool:
    """Return True for a finite number without a unit, also as text."""
    if isinstance(value, bool) or not isinstance(value, int | float | str):
        return False
    try:
        return math.isfinite(float(value))
    except (ValueError, OverflowError):
        return False


def tariff_of(circuit: BaseCircuit, values: Mapping[str, Any] | None = None) -> Tariff:
    """Return the tariff in the table [audit] of a circuit file, in which `values` replace fields.

    Parameters
    ----------
    circuit : Circuit
        A circuit. Without this table, the tariff has `values` and defaults.
    values : mapping, optional
        Fields of `read_tariff`; a value of None does not replace the field.

    Returns
    -------
    Tariff

    Raises
    ------
    InputError
        If a field is unknown, has no unit, or has a unit of another quantity.
    """
    table = {} if circuit.origin is None else circuit.origin.tables.get("audit", {})
    replaced = {name: value for name, value in (values or {}).items() if value is not None}
    return read_tariff({**table, **replaced} if isinstance(table, Mapping) else table, "audit")


def _read_price(address: str, argument: Any) -> Number:
    """Return a price per joule or per cubic metre of air at ANR."""
    value, source = split_source(address, argument)
    match = _PRICE.fullmatch(value) if isinstance(value, str) else None
    if match is None:
        raise UnitError("tariff.no_unit", address, value=value, examples=EXAMPLES)
    amount, currency, unit = float(match[1]), match[2], match[3].removesuffix("ANR").strip()
    for target in ("J", "m^3"):
        if same_dimension(unit, target):
            if math.isinf(amount):
                raise InputError("quantity.not_finite", address, shown=value)
            if amount < 0.0:
                raise InputError("tariff.negative", address, value=value)
            return Number(amount / convert(1.0, unit, target), f"{currency}/{target}", source, "", value)
    raise UnitError("tariff.other_unit", address, value=value, unit=unit, examples=EXAMPLES)

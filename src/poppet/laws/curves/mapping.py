"""Reader of flow characteristics from tables of a circuit file."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, raise_errors
from poppet.core.provenance import SOURCE_KINDS, Number, Source
from poppet.core.tables import Field, missing_field
from poppet.core.units import convert, quantity
from poppet.laws.curves.characteristic import EDGES, Characteristic, Edge
from poppet.laws.curves.curve import Curve
from poppet.laws.curves.shapes import ConstantCurve, PolynomialCurve, TableCurve

_COMMON = ("kind", "sonic_conductance", "critical_ratio", "edge", "closing", "monotone", "source", "note")
_FIELDS = {
    "constant": (*_COMMON, "domain"),
    "polynomial": (*_COMMON, "domain", "argument_unit"),
    "table": (*_COMMON, "stroke"),
}
_UNITS = {"sonic_conductance": "m^3/(s Pa)", "critical_ratio": "1"}
_LETTERS = {"sonic_conductance": "k", "critical_ratio": "p"}


def characteristic_from_mapping(table: Mapping[str, Any], *, name: str) -> Characteristic:
    """Read a flow characteristic from a table of a circuit file.

    Parameters
    ----------
    table : mapping of str to object
        The field `kind` is `constant`, `polynomial` or `table`. The fields `sonic_conductance` and `critical_ratio` are
        lists, or single values for a constant curve. The lists of a polynomial contain its coefficients, highest power
        first; its fields `argument_unit` (unit of the stroke in the polynomial) and `domain` (two strokes) are
        required. A table requires the field `stroke`, a list of the same length. Optional fields are `edge`, `closing`,
        `monotone`, `source` (kind of source, comma, reference) and `note`.
    name : str
        Name of the characteristic in messages.

    Returns
    -------
    Characteristic
        Characteristic whose parameters have the source that the table states, by default `given`.

    Raises
    ------
    InputError
        If the table is invalid; all errors are reported together.

    Examples
    --------
    >>> bench = characteristic_from_mapping(
    ...     {
    ...         "kind": "table",
    ...         "stroke": ["0 mm", "0.5 mm", "1 mm"],
    ...         "sonic_conductance": ["0 dm^3/(s bar)", "1.2 dm^3/(s bar)", "1.5 dm^3/(s bar)"],
    ...         "critical_ratio": 0.35,
    ...         "source": "measured, bench 3",
    ...     },
    ...     name="bench",
    ... )
    >>> print(f"{bench.sonic_conductance_at(0.5e-3):.3g} m^3/(s Pa), {bench.source}")
    1.2e-08 m^3/(s Pa), measured: bench 3
    """
    kind = table.get("kind")
    if kind not in _FIELDS:
        code = "curves.kind" if "kind" in table else "curves.no_kind"
        raise InputError(code, name, value=kind, suggestion=NameSuggestion(str(kind), _FIELDS))
    reader = _CharacteristicReader(table, name, str(kind))
    # From here on, errors are collected, so one pass over the file reports all of them.
    reader.reject_unknown()
    fields = reader.common()
    curves: dict[str, Any] = {field: reader.curve(field) for field in _UNITS}
    domain = reader.domain()
    raise_errors(reader.errors.collected)
    try:
        return Characteristic(**curves, domain=domain, name=name, **fields)
    except InputError as problem:
        raise problem.within(name) from None


class _CharacteristicReader:
    """Reader of the fields of one flow characteristic, which collects all errors."""

    def __init__(self, table: Mapping[str, Any], name: str, kind: str) -> None:
        self.table, self.name, self.kind = table, name, kind
        self.errors = ErrorCollector()
        self.source = self._source()

    def complain(self, code: str, field: str, **facts: Any) -> None:
        """Add an error about a field of the characteristic to the collected errors."""
        self.errors.add(code, f"{self.name}.{field}", field=field, **facts)

    def complain_missing(self, field: str, meaning: str, example: str = "") -> None:
        """Add an error about a missing field to the collected errors.

        The message contains `meaning` and `example` of the field.
        """
        self.errors.extend([missing_field(f"{self.name}.{field}", Field(meaning=meaning, example=example))])

    def reject_unknown(self) -> None:
        valid = _FIELDS[self.kind]
        for field in self.table:
            if field not in valid:
                table = f"characteristic of kind {self.kind}"
                self.complain("fields.unknown", field, table=table, suggestion=NameSuggestion(field, valid))

    def number(self, raw: Any, unit: str, field: str) -> Number | None:
        with self.errors.collecting():
            read = quantity(raw, unit, name=f"{self.name}.{field}")
            return Number(read.value, unit, self.source, text=str(raw))
        return None

    def numbers(self, field: str, unit: str) -> tuple[Number, ...] | None:
        """Return the list in the field `field` as numbers with the SI unit `unit`.

        The result is None if any entry is invalid. The errors are collected.
        """
        read = [self.number(entry, unit, f"{field}[{i}]") for i, entry in enumerate(self.table[field])]
        numbers = tuple(number for number in read if number is not None)
        return numbers if len(numbers) == len(read) else None

    def curve(self, field: str) -> Curve | None:
        if field not in self.table:
            self.complain_missing(field, f"{field} of a {self.kind}")
        else:
            with self.errors.collecting(f"{self.name}.{field}"):
                return self._curve(field)
        return None

    def _curve(self, field: str) -> Curve | None:
        raw, unit = self.table[field], _UNITS[field]
        if self.kind == "constant" or not _is_list(raw):
            number = self.number(raw, unit, field)
            return None if number is None else ConstantCurve(number)
        numbers = self.numbers(field, unit)
        if numbers is None:
            return None
        if self.kind == "polynomial":
            scale = self._argument_scale
            return None if scale is None else PolynomialCurve(numbers, scale, _LETTERS[field])
        return None if self._strokes is None else TableCurve(self._strokes, numbers)

    def domain(self) -> tuple[float, float]:
        """Return the lowest and the highest stroke at which the characteristic is valid [m].

        They are the first and last stroke of a table. They are infinite if the field `domain` is omitted or invalid.
        """
        unbounded = (-math.inf, math.inf)
        if self.kind == "table":
            return (self._strokes[0], self._strokes[-1]) if self._strokes else unbounded
        given = self.table.get("domain")
        if given is None:
            if self.kind == "polynomial":
                self.complain_missing("domain", "range in which the polynomial was fitted", 'domain = ["0 mm", "1 mm"]')
            return unbounded
        if not _is_list(given) or len(given) != 2:
            self.complain("curves.not_a_pair", "domain", value=given)
            return unbounded
        numbers = self.numbers("domain", "m")
        return unbounded if numbers is None else (float(numbers[0]), float(numbers[1]))

    def common(self) -> dict[str, Any]:
        """Return the arguments of `Characteristic` that all kinds have: edge, closing, monotone and source."""
        closing = self.number(self.table["closing"], "m", "closing") if "closing" in self.table else None
        monotone = self.table.get("monotone", False)
        if not isinstance(monotone, bool):
            self.complain("curves.not_a_truth", "monotone", value=monotone)
        edge: Edge = self.table.get("edge", "hold")
        if edge not in EDGES:
            near = NameSuggestion(str(edge), EDGES)
            self.complain("fields.not_an_option", "edge", meaning="edge policy", value=edge, suggestion=near)
        return {"edge": edge, "closing": closing, "monotone": monotone, "source": self.source}

    def _source(self) -> Source:
        written = self.table.get("source", "given")
        note = self.table.get("note", "")
        for field, text in (("source", written), ("note", note)):
            if not isinstance(text, str):
                self.complain("curves.not_a_text", field, value=text)
                return Source("given")
        kind, _, locator = (part.strip() for part in written.partition(","))
        if kind not in SOURCE_KINDS:
            self.complain("curves.source", "source", value=written, suggestion=NameSuggestion(kind, SOURCE_KINDS))
            return Source("given")
        return Source(kind, locator, note)

    # Both curves share the unit of the argument and the strokes, whose errors are reported once.

    @cached_property
    def _argument_scale(self) -> float | None:
        unit, address = self.table.get("argument_unit"), f"{self.name}.argument_unit"
        if unit is None:
            self.complain_missing("argument_unit", "unit of x in a polynomial", 'argument_unit = "mm"')
            return None
        try:
            return float(convert(1.0, "m", unit))
        except InputError as problem:
            self.errors.extend([problem.located(address=address)])
            return None

    @cached_property
    def _strokes(self) -> tuple[float, ...] | None:
        """Strokes at which a characteristic of kind `table` has points [m].

        The value is None if the field `stroke` is missing or contains an invalid stroke.
        """
        if not _is_list(self.table.get("stroke")):
            if "stroke" in self.table:
                self.complain("curves.not_strokes", "stroke", value=self.table["stroke"])
            else:
                self.complain_missing("stroke", "stroke of a table", 'stroke = ["0 mm", "0.5 mm", "1 mm"]')
            return None
        numbers = self.numbers("stroke", "m")
        return None if numbers is None else tuple(float(number) for number in numbers)


def _is_list(value: Any) -> bool:
    return isinstance(value, Sequence) and not isinstance(value, str)

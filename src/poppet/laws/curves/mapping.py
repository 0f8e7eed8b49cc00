"""A characteristic out of a table of a circuit file."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from poppet.ground.errors import InputError, InputErrors, Near, collect
from poppet.ground.provenance import SOURCE_KINDS, Number, Source
from poppet.ground.units import convert, quantity
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
    """Read a characteristic from a table of a circuit file.

    Parameters
    ----------
    table : mapping of str to object
        `kind` is `constant`, `polynomial` (coefficients from the highest power down, `argument_unit`,
        `domain`) or `table` (`stroke`). `sonic_conductance` and `critical_ratio` are lists; a single value
        stands for a constant. Optional: `edge`, `closing`, `monotone`, `source` (a kind, then after a comma
        where to look it up), `note`.
    name : str
        Name of the characteristic for messages.

    Returns
    -------
    Characteristic
        Every number carries the table's source, `given` when it names none.

    Raises
    ------
    InputError
        All mistakes of the table at once.

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
        raise InputError(code, name, value=kind, near=Near(str(kind), _FIELDS))
    reader = _Reader(table, name)
    reader.refuse_unknown(_FIELDS[str(kind)])
    fields = reader.common()
    curves: dict[str, Any] = {field: reader.curve(field, str(kind)) for field in _UNITS}
    domain = reader.domain(required=kind == "polynomial") if kind != "table" else reader.table_domain()
    collect(reader.problems)
    try:
        return Characteristic(**curves, domain=domain, name=name, **fields)
    except InputError as problem:
        raise _below(problem, name) from None


class _Reader:
    """Reads the fields of one table and keeps what is wrong with them."""

    def __init__(self, table: Mapping[str, Any], name: str) -> None:
        self.table, self.name = table, name
        self.problems: list[InputError] = []
        self.source = self._source()

    def complain(self, code: str, field: str, **facts: Any) -> None:
        """The mistakes of a file name the field, and their address the characteristic as well."""
        self.problems.append(InputError(code, f"{self.name}.{field}", field=field, **facts))

    def refuse_unknown(self, known: Sequence[str]) -> None:
        for field in self.table:
            if field not in known:
                self.complain("curves.unknown_field", field, kind=self.table["kind"], near=Near(field, known))

    def number(self, given: Any, unit: str, field: str, shown: str = "") -> Number | None:
        try:
            read = quantity(given, unit, name=f"{self.name}.{shown or field}")
        except InputError as problem:
            self.problems.append(problem)
            return None
        return Number(read.value, unit, self.source, text=str(given))

    def numbers(self, field: str, unit: str) -> tuple[Number, ...]:
        """The entries of a list; those that cannot be read are reported and left out."""
        given = self.table[field]
        read = [self.number(entry, unit, field, f"{field}[{i}]") for i, entry in enumerate(given)]
        return tuple(number for number in read if number is not None)

    def curve(self, field: str, kind: str) -> Curve | None:
        if field not in self.table:
            self.complain("curves.missing", field, kind=kind)
            return None
        before = len(self.problems)
        try:
            curve = self._constant(field) if self._is_single(field, kind) else self._of_list(field, kind)
        except InputError as problem:
            self.problems.append(_below(problem, f"{self.name}.{field}"))
            return None
        return curve if len(self.problems) == before else None

    def domain(self, *, required: bool) -> tuple[float, float]:
        given = self.table.get("domain")
        if given is None:
            if required:
                self.complain("curves.missing_domain", "domain")
            return (-math.inf, math.inf)
        if not _is_list(given) or len(given) != 2:
            self.complain("curves.not_a_pair", "domain", value=given)
            return (-math.inf, math.inf)
        numbers = self.numbers("domain", "m")
        return (float(numbers[0]), float(numbers[1])) if len(numbers) == 2 else (-math.inf, math.inf)

    def table_domain(self) -> tuple[float, float]:
        strokes = self._strokes()
        return (strokes[0], strokes[-1]) if strokes else (-math.inf, math.inf)

    def common(self) -> dict[str, Any]:
        """The fields every kind may have, under the names of `Characteristic`."""
        closing = self.number(self.table["closing"], "m", "closing") if "closing" in self.table else None
        monotone = self.table.get("monotone", False)
        if not isinstance(monotone, bool):
            self.complain("curves.not_a_truth", "monotone", value=monotone)
        edge: Edge = self.table.get("edge", "hold")
        if edge not in EDGES:
            self.complain("curves.edge", "edge", value=edge, near=Near(str(edge), EDGES))
        return {"edge": edge, "closing": closing, "monotone": monotone, "source": self.source}

    def _source(self) -> Source:
        written = self.table.get("source", "given")
        note = self.table.get("note", "")
        for field, text in (("source", written), ("note", note)):
            if not isinstance(text, str):
                self.complain("curves.not_a_text", field, value=text)
                return Source("given")
        kind, _, locator = (part.strip() for part in written.partition(","))
        known = {str(known): known for known in SOURCE_KINDS}
        if kind not in known:
            self.complain("curves.source", "source", value=written, near=Near(kind, known))
            return Source("given")
        return Source(known[kind], locator, note)

    def _is_single(self, field: str, kind: str) -> bool:
        return kind == "constant" or not _is_list(self.table[field])

    def _constant(self, field: str) -> Curve | None:
        number = self.number(self.table[field], _UNITS[field], field)
        return None if number is None else ConstantCurve(number)

    def _of_list(self, field: str, kind: str) -> Curve | None:
        numbers = self.numbers(field, _UNITS[field])
        if len(numbers) < len(self.table[field]):
            return None
        if kind == "polynomial":
            scale = self._argument_scale()
            return None if scale is None else PolynomialCurve(numbers, scale, _LETTERS[field])
        strokes = self._strokes()
        return TableCurve(strokes, numbers) if strokes else None

    def _argument_scale(self) -> float | None:
        unit = self.table.get("argument_unit")
        try:
            if unit is None:
                raise InputError("curves.missing_argument_unit")
            return float(convert(1.0, "m", unit))
        except InputError as problem:
            self._once(problem.located(address=f"{self.name}.argument_unit"))
            return None

    def _strokes(self) -> tuple[float, ...]:
        """The knots of a table; empty when they cannot be read, which is reported once."""
        given: Any = self.table.get("stroke")
        if not _is_list(given):
            code = "curves.not_strokes" if "stroke" in self.table else "curves.missing_strokes"
            self._once(InputError(code, f"{self.name}.stroke", value=given))
            return ()
        found: list[InputError] = []
        read: list[float] = []
        for i, entry in enumerate(given):
            try:
                read.append(quantity(entry, "m", name=f"{self.name}.stroke[{i}]").value)
            except InputError as problem:
                found.append(problem)
        for known in found:
            self._once(known)
        return () if found else tuple(read)

    def _once(self, problem: InputError) -> None:
        """Both curves share the strokes and the argument's unit: report what is wrong with them once."""
        if (problem.code, problem.address) not in {(known.code, known.address) for known in self.problems}:
            self.problems.append(problem)


def _is_list(given: Any) -> bool:
    return isinstance(given, Sequence) and not isinstance(given, str)


def _below(problem: InputError, name: str) -> InputError:
    """Put the owner's name in front of the addresses of a problem or of several."""
    for one in problem.problems if isinstance(problem, InputErrors) else (problem,):
        one.address = f"{name}.{one.address}" if one.address else name
    return problem

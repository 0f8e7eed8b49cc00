"""Declarations of the fields of tables.

A declaration reads a field, reports its errors, and provides its JSON schema.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property
from typing import Any, Literal

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.units import Kind, convert, quantity, sizes_of

_TYPES: dict[str, tuple[tuple[type, ...], str, str | list[str]]] = {
    "string": ((str,), "text", "string"),
    "boolean": ((bool,), "true or false, without quotes", "boolean"),
    "number": ((int, float), "a number without a unit", "number"),
    "name": ((str, int), "a name or an index", ["string", "integer"]),
}
"""Python types, meaning and JSON type of the strict types of fields."""


@dataclass(frozen=True, kw_only=True)
class NumberRange:
    """Limits of a number in SI units.

    `low` and `high` are the smallest and the largest valid value. `above` and `below` are limits that the number must
    not reach: it must be greater than `above` and less than `below`.
    """

    unit: str
    low: float = -math.inf
    high: float = math.inf
    above: float = -math.inf
    below: float = math.inf
    usual_unit: str = ""  # of limits in messages; SI if empty

    @cached_property
    def ends(self) -> tuple[float, float]:
        """Smallest and largest valid value, limited to the plausible values of the unit.

        The function `poppet.core.units.sizes_of` returns these plausible values.
        """
        smallest, largest = sizes_of(self.unit)
        return smallest if self.above == 0.0 else self.low, min(self.high, largest)

    def holds(self, value: float) -> bool:
        """Return True if a value is within the limits.

        The result for NaN is False.
        """
        low, high = self.ends
        return low <= value <= high and self.above < value < self.below

    def check_range(self, address: str, value: float, text: str, meaning: str) -> None:
        """Raise `OutOfRangeError` if a value is outside the limits.

        `text` is the value as the user wrote it, and `meaning` describes the field.
        """
        if self.holds(value):
            return
        (low, high), limits = self.ends, []
        unit = self.usual_unit or self.unit

        def shown(limit: float) -> str:
            return f"{convert(limit, self.unit, unit) if self.usual_unit else limit:g}"

        if low > -math.inf or self.above > -math.inf:
            is_open = self.above >= self.low and not self.above < value < low
            limits += [f"greater than {shown(self.above)}" if is_open else f"at least {shown(low)}"]
        if min(self.high, self.below) < math.inf or value > high:
            limits += [f"at most {shown(high)}" if high < self.below else f"less than {shown(self.below)}"]
        facts: dict[str, Any] = {"value": value, "shown": text, "meaning": meaning, "limits": limits}
        raise OutOfRangeError("fields.out_of_range", address, **facts, unit="" if unit == "1" else unit)


@dataclass(frozen=True, kw_only=True)
class Field(NumberRange):
    """Declaration of one field of a table.

    A field with a `unit` is a number. If a number field also has `choices`, these are words that are valid instead of a
    number. A field without a unit is not converted: it must be one of its `choices`, or have its `type`. For the type
    `text`, values of other types are converted to text.
    """

    unit: str = ""
    kind: Kind = "plain"
    type: Literal["value", "text", "integer", "table", "string", "boolean", "number", "name"] = "value"
    choices: tuple[str, ...] = ()
    is_required: bool = False
    default: Any = None
    meaning: str = ""
    example: str = ""  # TOML text that the message about a missing field shows

    def read(self, raw: Any, address: str, ambient_pressure: float = 0.0) -> Any:
        """Check the raw value of a field, and return it in SI units.

        A gauge pressure becomes absolute. A field without a unit is not converted.
        """
        name = address.rpartition(".")[2]
        meaning = self.meaning or name.replace("_", " ")
        if raw in self.choices:
            return raw
        if self.unit:
            number = quantity(raw, self.unit, kind=self.kind, name=address)
            value = number.value + (ambient_pressure if number.reference == "gauge" else 0.0)
            self.check_range(address, value, str(raw), meaning)
            return value
        if self.choices:
            suggestion = NameSuggestion(str(raw), self.choices)
            raise InputError("fields.not_an_option", address, value=raw, meaning=meaning, suggestion=suggestion)
        if self.type == "table" and not isinstance(raw, Mapping):
            raise InputError("fields.no_table", address, value=raw)
        if self.type in _TYPES:
            types, expected, _ = _TYPES[self.type]
            is_wrong_boolean = isinstance(raw, bool) and self.type != "boolean"  # in Python, True is an int
            if not isinstance(raw, types) or is_wrong_boolean or (isinstance(raw, float) and not math.isfinite(raw)):
                raise InputError("fields.other_type", address, value=raw, meaning=meaning, expected=expected)
        if self.type == "integer" and isinstance(raw, str):
            expected = "an integer, without quotes"
            raise InputError("fields.other_type", address, value=raw, meaning=meaning, expected=expected)
        is_integer = isinstance(raw, int) and not isinstance(raw, bool)
        if self.type == "integer" and not (is_integer and self.low <= raw <= self.high):
            limits = ["an integer", f"at least {self.low:g}", f"at most {self.high:g}"]
            facts = {"value": raw, "shown": str(raw), "meaning": meaning, "limits": limits, "unit": ""}
            raise OutOfRangeError("fields.out_of_range", address, **facts)
        return str(raw) if self.type == "text" else raw

    def schema(self) -> dict[str, Any]:
        """Return the JSON schema of the field."""
        schema: dict[str, Any] = {}
        if self.unit:
            schema = {"type": ["number", "string", "object"]}
        elif self.choices:
            schema = {"enum": list(self.choices)}
        elif self.type != "value":
            names = {"text": "string", "table": "object", "integer": "integer"}
            schema = {"type": names[self.type] if self.type in names else _TYPES[self.type][2]}
        if self.type == "integer":
            schema |= {"minimum": self.low, "maximum": self.high}
        if self.default is not None:
            schema["default"] = self.default
        description = f"{self.meaning}{f' [{self.unit}]' if self.unit else ''}".strip()
        return schema | ({"description": description} if description else {})


def read_fields(
    errors: ErrorCollector,
    raw: Any,
    fields: Mapping[str, Field],
    address: str = "",
    *,
    table: str = "",
    ambient_pressure: float = 0.0,
) -> dict[str, Any]:
    """Read the table `raw` according to the declarations of its fields, and collect all errors.

    The result contains the valid fields, and the defaults of the other fields. Gauge pressures become absolute. The
    keyword `table` is the name of the table for messages about unknown fields, for example "fit file".

    Examples
    --------
    >>> fields = {"opens": Field(unit="s"), "use": Field(choices=("fit", "validation"), default="fit")}
    >>> with ErrorCollector() as errors:
    ...     print(read_fields(errors, {"opens": "20 ms"}, fields))
    {'opens': 0.02, 'use': 'fit'}
    """
    if not isinstance(raw, Mapping):
        errors.add("fields.no_table", address, value=raw)
        return {}
    prefix = f"{address}." if address else ""
    unknown = [key for key in raw if key not in fields]
    for key in unknown:
        errors.add("fields.unknown", f"{prefix}{key}", table=table, suggestion=NameSuggestion(key, fields))
    values = {}
    for key, field in fields.items():
        if key in raw and not (field.type == "table" and field.is_required and raw[key] == {}):
            with errors.collecting():
                values[key] = field.read(raw[key], f"{prefix}{key}", ambient_pressure)
        elif field.default is not None:
            values[key] = field.default
        # A misspelt name is one error, not two.
        elif field.is_required and not get_close_matches(key, unknown, n=1):
            errors.extend([missing_field(f"{prefix}{key}", field)])
    return values


def missing_field(address: str, field: Field) -> InputError:
    """Return the error for a required field that a table does not contain."""
    meaning = field.meaning or address.rpartition(".")[2].replace("_", " ")
    unit = "" if field.unit == "1" else field.unit
    facts: dict[str, Any] = {"meaning": meaning, "unit": "" if field.example else unit, "plain": field.unit == "1"}
    return InputError("fields.missing", address, **facts, example=field.example)


def table_schema(fields: Mapping[str, Field], required: Sequence[str] = ()) -> dict[str, Any]:
    """Return the JSON schema of a table from the declarations of its fields.

    Examples
    --------
    >>> table_schema({"seed": Field(type="integer", low=0, high=9, is_required=True)})["properties"]
    {'seed': {'type': 'integer', 'minimum': 0, 'maximum': 9}}
    """
    return {
        "type": "object",
        "properties": {name: field.schema() for name, field in fields.items()},
        "required": [name for name, field in fields.items() if field.is_required or name in required],
        "additionalProperties": False,
    }

"""Tables that people write, read as they are declared: every mistake of a table at once, numbers in SI."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from difflib import get_close_matches
from typing import Any

from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.core.units import Kind, quantity


@dataclass(frozen=True)
class Field:
    """What may stand in one field of a table."""

    is_required: bool = False
    choices: tuple[str, ...] = ()  # where it has a unit, words that stand for a number
    unit: str = ""  # SI unit of a number; empty where it is none, and is handed on as it was written
    kind: Kind = "plain"  # what else a number may be, as `quantity` takes it
    meaning: str = ""  # for editors
    is_table: bool = False  # it has fields of its own, which are read elsewhere


def read_fields(
    errors: ErrorCollector,
    given: Any,
    fields: Mapping[str, Field],
    room: str,
    address: str = "",
    *,
    ambient_pressure: float = 0.0,
) -> dict[str, Any]:
    """What a table says, as far as it is no mistake; gauge pressures become absolute.

    The words of unknown fields stand under `unknown` of a room, those of a missing one under its name in `missing`.

    Examples
    --------
    >>> fields = {"opens": Field(unit="s"), "use": Field(choices=("fit", "validation"))}
    >>> with ErrorCollector() as errors:
    ...     print(read_fields(errors, {"opens": "20 ms", "use": "fit"}, fields, "tank"))
    {'opens': 0.02, 'use': 'fit'}
    """
    if not isinstance(given, Mapping):
        errors.add("entry.form", address, value=given)
        return {}
    prefix = f"{address}." if address else ""
    unknown = [key for key in given if key not in fields]
    for key in unknown:
        errors.add(f"{room}.unknown", f"{prefix}{key}", near=NameSuggestion(key, fields))
    found = {}
    for key, field in fields.items():
        place = f"{prefix}{key}"
        if key not in given or (field.is_table and field.is_required and given[key] == {}):
            # A misspelt field is one mistake, not two.
            if field.is_required and not get_close_matches(key, unknown, n=1):
                errors.add(f"{room}.missing.{key}", place)
        elif field.unit and given[key] not in field.choices:
            with errors.collecting():
                read = quantity(given[key], field.unit, kind=field.kind, name=place)
                found[key] = read.value + (ambient_pressure if read.reference == "gauge" else 0.0)
        elif field.is_table and not isinstance(given[key], Mapping):
            errors.add("entry.form", place, value=given[key])
        elif field.choices and given[key] not in field.choices:
            errors.add("entry.choice", place, value=given[key], near=NameSuggestion(str(given[key]), field.choices))
        else:
            found[key] = given[key]
    return found

"""Fields of the tables of circuit files and identification files, from their declarations."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache
from typing import Any

from poppet.assist.replies import Json


@cache
def described_tables() -> Mapping[str, Json]:
    """Return the fields of each table by the name of the table.

    Besides the tables `ensemble` and `audit`, these are the metrics, the distributions and the identification files,
    with names such as `metric max`, `distribution normal` and `identify tank`.
    """
    from poppet.audit.tariff import FIELDS
    from poppet.ensemble.ensemble_schema import file_schema
    from poppet.identify.methods import BUILT_IN

    schema = file_schema()
    tables = {"ensemble": _fields(schema["properties"]["ensemble"])}
    for kind in ("metric", "distribution"):
        beginning = f"{kind}_"
        tables |= {
            f"{kind} {name.removeprefix(beginning)}": _fields(definition)
            for name, definition in schema["$defs"].items()
            if name.startswith(beginning) and name != "metric_function"
        }
    price: Json = {"tariff": {"meaning": 'price: "0.20 EUR/kWh" or, of air, "0.02 EUR/m^3"'}}
    tables["audit"] = price | {name: {"meaning": field.doc, "unit": field.unit} for name, field in FIELDS.items()}
    return tables | {f"identify {method.name}": _fields(method.file_schema()) for method in BUILT_IN}


def _fields(schema: Mapping[str, Any]) -> Json:
    """Return the fields of the JSON schema of a table."""
    required = schema.get("required", ())
    return {
        name: {"meaning": field.get("description", "")}
        | ({"choices": list(field["enum"])} if len(field.get("enum", ())) > 1 else {})
        | ({"value": field["const"]} if "const" in field else {})
        | ({"default": field["default"]} if "default" in field else {})
        | ({"is_required": True} if name in required else {})
        for name, field in schema["properties"].items()
        if not field.get("deprecated")
    }

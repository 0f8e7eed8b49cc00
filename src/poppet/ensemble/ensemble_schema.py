"""The JSON schema of circuit files with the tables of an ensemble, from the declarations that read these."""

from __future__ import annotations

from collections.abc import Mapping

from poppet.circuit.schema import Schema, by_kind, circuit_schema, closed
from poppet.core.tables import Field
from poppet.ensemble.distributions import FORMS, MIDDLES, Form
from poppet.ensemble.ensemble_plan import ALL, COUNTS, FIELDS, TAKEN
from poppet.ensemble.metrics import FUNCTION, WAYS
from poppet.ensemble.metrics import SHARED as OF_METRICS
from poppet.ensemble.requirements import FORM

_VALUE: Schema = {"$ref": "#/$defs/value"}
_TEXT: Schema = {"type": "string"}
_TEXTS: Schema = {"anyOf": [_TEXT, {"type": "array", "items": _TEXT, "minItems": 1}]}
_OTHERS: dict[str, Schema] = {"file": _TEXT, "unit": _TEXT, "curves": _TEXTS, "of": _TEXTS}
"""Fields that are no number with a unit."""


def file_schema() -> Schema:
    """The JSON schema of circuit files, for editors.

    Examples
    --------
    >>> file_schema()["properties"]["ensemble"]["properties"]["sampling"]["enum"]
    ['random', 'latin', 'sobol', 'grid', 'file']
    """
    schema = circuit_schema()
    numbers = {"from_fit": {"type": "string", "description": "result file of an identification"}}
    tables = {
        "numbers": {
            "type": "object",
            "properties": numbers,
            "additionalProperties": {"$ref": "#/$defs/distribution"},
            "propertyNames": {"pattern": rf"^({'|'.join(numbers)}|.+\..+)$"},
            "description": "address to distribution",
        },
        "metrics": {
            "type": "object",
            "additionalProperties": {"$ref": "#/$defs/metric"},
            "propertyNames": _names(*TAKEN),
            "description": "name to metric",
        },
    }
    requirement = {"type": "string", "pattern": f"^{FORM.pattern}$"}
    schema["properties"] |= {
        "ensemble": closed(_fields(FIELDS) | _counts() | tables, (), "uncertain numbers and metrics of many runs"),
        "requirements": {
            "type": "object",
            "additionalProperties": requirement,
            "propertyNames": _names(ALL),
            "description": "on metrics",
        },
    }
    schema["$defs"] |= {
        "distribution": by_kind("distribution", {kind: f"distribution_{kind}" for kind in FORMS}, "distribution"),
        **{f"distribution_{kind}": _distribution(kind, form) for kind, form in FORMS.items()},
        "metric": _metric(),
        **{f"metric_{kind}": _metric_of(kind) for kind in WAYS},
        "metric_function": closed(_fields(OF_METRICS) | {"metric": {"pattern": FUNCTION}}, ["of", "metric"]),
    }
    return schema


def _names(*taken: str) -> Schema:
    return {"pattern": rf"^(?!({'|'.join(taken)})$)[^\W\d]\w*$"}


def _fields(fields: Mapping[str, Field]) -> Schema:
    """What is declared of the fields of a table."""
    found: Schema = {}
    for name, field in fields.items():
        own = {"enum": list(field.choices), "default": field.choices[0]} if field.choices else _OTHERS.get(name, _VALUE)
        unit = f" [{field.unit}]" if field.unit else ""
        found[name] = own | ({"description": f"{field.meaning}{unit}"} if field.meaning else {})
    return found


def _counts() -> Schema:
    found: Schema = {}
    for name, (low, high) in COUNTS.items():
        found[name] = {"type": "integer", "minimum": low, "maximum": high, "description": FIELDS[name].meaning}
    # A power of two.
    powers = [2**k for k in range(COUNTS["indices"][1].bit_length())]
    return found | {"indices": {"enum": [0, *powers], "description": FIELDS["indices"].meaning}}


def _distribution(kind: str, form: Form) -> Schema:
    given = [name for name in form.fields if name not in MIDDLES]
    fields: Schema = {"distribution": {"const": kind}} | dict.fromkeys(form.names, _VALUE)
    if not form.relative:
        return closed(fields, ["distribution", *given])
    return closed(fields, ["distribution"]) | {"anyOf": [{"required": given}, {"required": [form.relative]}]}


def _metric() -> Schema:
    schema = by_kind("metric", {kind: f"metric_{kind}" for kind in WAYS}, "metric")
    schema["properties"]["metric"] = {
        "anyOf": [schema["properties"]["metric"], {"type": "string", "pattern": FUNCTION}],
        "description": "what is worked out, or FILE.py:FUNCTION",
    }
    is_own = {"properties": {"metric": {"pattern": FUNCTION}}, "required": ["metric"]}
    schema["allOf"].append({"if": is_own, "then": {"$ref": "#/$defs/metric_function"}})
    return schema


def _metric_of(kind: str) -> Schema:
    way = WAYS[kind]
    fields = _fields(OF_METRICS) | {"of": {"type": "string", "description": OF_METRICS["of"].meaning}}
    fields |= {"metric": {"const": kind, "description": way.meaning}} | _fields(way.fields)
    # A level has no default, as a target has.
    return closed(fields, ["of", "metric", *(name for name in way.fields if way.fields[name].is_required)], way.meaning)

"""JSON schema of circuit files, including the tables of an ensemble."""

from __future__ import annotations

from collections.abc import Mapping

from poppet.circuit.schema import Schema, by_kind, circuit_schema, closed
from poppet.core.tables import Field
from poppet.ensemble.distributions import FORMS, MIDDLES, Form
from poppet.ensemble.ensemble_plan import ALL, COUNTS, FIELDS, RESERVED
from poppet.ensemble.metrics import FORM, FUNCTION, METRIC_KINDS
from poppet.ensemble.metrics import SHARED as OF_METRICS

_VALUE: Schema = {"$ref": "#/$defs/value"}
_TEXT: Schema = {"type": "string"}
_TEXTS: Schema = {"anyOf": [_TEXT, {"type": "array", "items": _TEXT, "minItems": 1}]}
_OTHERS: dict[str, Schema] = {"file": _TEXT, "unit": _TEXT, "curves": _TEXTS, "of": _TEXTS}
"""Fields that are not values with a unit."""


def file_schema() -> Schema:
    """Return the JSON schema of circuit files for editors.

    Examples
    --------
    >>> file_schema()["properties"]["ensemble"]["properties"]["sampling"]["enum"]
    ['random', 'latin', 'sobol', 'grid', 'file']
    """
    schema = circuit_schema()
    parameters = {
        "type": "object",
        "properties": {"from_fit": {"type": "string", "description": "result file of an identification"}},
        "additionalProperties": {"$ref": "#/$defs/distribution"},
        "propertyNames": {"pattern": r"^(from_fit|.+\..+)$"},
        "description": "address to distribution",
    }
    tables = {
        "parameters": parameters,
        "numbers": parameters | {"description": "old name of `parameters`", "deprecated": True},
        "metrics": {
            "type": "object",
            "additionalProperties": {"$ref": "#/$defs/metric"},
            "propertyNames": _names(*RESERVED),
            "description": "name to metric",
        },
    }
    requirement = {"type": "string", "pattern": f"^{FORM.pattern}$"}
    ensemble = closed(_fields(FIELDS) | _counts() | tables, (), "uncertain parameters and metrics of many runs")
    schema["properties"] |= {
        "ensemble": ensemble | {"not": {"required": ["numbers", "parameters"]}},
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
        **{f"metric_{kind}": _metric_of(kind) for kind in METRIC_KINDS},
        "metric_function": closed(_fields(OF_METRICS) | {"metric": {"pattern": FUNCTION}}, ["of", "metric"]),
    }
    return schema


def _names(*reserved: str) -> Schema:
    return {"pattern": rf"^(?!({'|'.join(reserved)})$)[^\W\d]\w*$"}


def _fields(fields: Mapping[str, Field]) -> Schema:
    """Return the JSON schema of the fields of a table."""
    properties: Schema = {}
    for name, field in fields.items():
        choices = {"enum": list(field.choices), "default": field.choices[0]} if field.choices else None
        schema = choices or _OTHERS.get(name, _VALUE)
        unit = f" [{field.unit}]" if field.unit else ""
        properties[name] = schema | ({"description": f"{field.meaning}{unit}"} if field.meaning else {})
    return properties


def _counts() -> Schema:
    properties = {
        name: {"type": "integer", "minimum": low, "maximum": high, "description": FIELDS[name].meaning}
        for name, (low, high) in COUNTS.items()
    }
    powers = [2**k for k in range(COUNTS["indices"][1].bit_length())]
    return properties | {"indices": {"enum": [0, *powers], "description": FIELDS["indices"].meaning}}


def _distribution(kind: str, form: Form) -> Schema:
    required = [name for name in form.fields if name not in MIDDLES]
    fields: Schema = {"distribution": {"const": kind}} | dict.fromkeys(form.names, _VALUE)
    if not form.relative:
        return closed(fields, ["distribution", *required])
    return closed(fields, ["distribution"]) | {"anyOf": [{"required": required}, {"required": [form.relative]}]}


def _metric() -> Schema:
    schema = by_kind("metric", {kind: f"metric_{kind}" for kind in METRIC_KINDS}, "metric")
    schema["properties"]["metric"] = {
        "anyOf": [schema["properties"]["metric"], {"type": "string", "pattern": FUNCTION}],
        "description": "kind of metric, or FILE.py:FUNCTION",
    }
    is_own = {"properties": {"metric": {"pattern": FUNCTION}}, "required": ["metric"]}
    schema["allOf"].append({"if": is_own, "then": {"$ref": "#/$defs/metric_function"}})
    return schema


def _metric_of(kind: str) -> Schema:
    metric_kind = METRIC_KINDS[kind]
    fields = _fields(OF_METRICS) | {"of": {"type": "string", "description": OF_METRICS["of"].meaning}}
    fields |= {"metric": {"const": kind, "description": metric_kind.meaning}} | _fields(metric_kind.fields)
    required = [name for name, field in metric_kind.fields.items() if field.is_required]
    return closed(fields, ["of", "metric", *required], metric_kind.meaning)

"""JSON schema of circuit files, including the tables of an ensemble."""

from __future__ import annotations

from collections.abc import Mapping

from poppet.circuit.schema import Schema, by_kind, circuit_schema, closed
from poppet.core.tables import Field
from poppet.ensemble.distributions import FORMS, MIDDLES
from poppet.ensemble.ensemble_plan import ALL, FIELDS, RESERVED
from poppet.ensemble.metrics import FORM, FUNCTION, METRIC_KINDS
from poppet.ensemble.metrics import SHARED as OF_METRICS

_VALUE: Schema = {"$ref": "#/$defs/value"}
_TEXT: Schema = {"type": "string"}
_TEXTS: Schema = {"anyOf": [_TEXT, {"type": "array", "items": _TEXT, "minItems": 1}]}
_OTHERS: dict[str, Schema] = {"file": _TEXT, "unit": _TEXT, "curves": _TEXTS, "of": _TEXTS}
"""Fields that are not values with a unit."""


def file_schema() -> Schema:
    """Return the JSON schema of circuit files, with which editors check them.

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
    powers = [2**k for k in range(int(FIELDS["indices"].high).bit_length())]
    counts = {"indices": {"enum": [0, *powers], "description": FIELDS["indices"].meaning}}
    requirement = {"type": "string", "pattern": f"^{FORM.pattern}$"}
    ensemble = closed(_fields(FIELDS) | counts | tables, (), "uncertain parameters and metrics of many runs")
    schema["properties"] |= {
        "ensemble": ensemble | {"not": {"required": ["numbers", "parameters"]}},
        "requirements": {
            "type": "object",
            "additionalProperties": requirement,
            "propertyNames": _names(ALL),
            "description": "on metrics",
        },
    }
    metric = by_kind("metric", {kind: f"metric_{kind}" for kind in METRIC_KINDS}, "metric")
    metric["properties"]["metric"] = {
        "anyOf": [metric["properties"]["metric"], {"type": "string", "pattern": FUNCTION}],
        "description": "kind of metric, or FILE.py:FUNCTION",
    }
    is_own = {"properties": {"metric": {"pattern": FUNCTION}}, "required": ["metric"]}
    metric["allOf"].append({"if": is_own, "then": {"$ref": "#/$defs/metric_function"}})
    schema["$defs"] |= {
        "distribution": by_kind("distribution", {kind: f"distribution_{kind}" for kind in FORMS}, "distribution"),
        "metric": metric,
        "metric_function": closed(_fields(OF_METRICS) | {"metric": {"pattern": FUNCTION}}, ["of", "metric"]),
    }
    for kind, form in FORMS.items():
        centred = [name for name in form.fields if name not in MIDDLES]
        fields: Schema = {"distribution": {"const": kind}} | dict.fromkeys(form.names, _VALUE)
        required = ["distribution"] if form.relative else ["distribution", *centred]
        options = {"anyOf": [{"required": centred}, {"required": [form.relative]}]} if form.relative else {}
        schema["$defs"][f"distribution_{kind}"] = closed(fields, required) | options
    for kind, metric_kind in METRIC_KINDS.items():
        fields = _fields(OF_METRICS) | {"of": {"type": "string", "description": OF_METRICS["of"].meaning}}
        fields |= {"metric": {"const": kind, "description": metric_kind.meaning}} | _fields(metric_kind.fields)
        required = ["of", "metric", *(name for name, field in metric_kind.fields.items() if field.is_required)]
        schema["$defs"][f"metric_{kind}"] = closed(fields, required, metric_kind.meaning)
    return schema


def _names(*reserved: str) -> Schema:
    return {"pattern": rf"^(?!({'|'.join(reserved)})$)[^\W\d]\w*$"}


def _fields(fields: Mapping[str, Field]) -> Schema:
    """Return the JSON schema of each field of a table by name, from the declarations of the fields."""
    properties: Schema = {}
    for name, field in fields.items():
        if field.type == "integer":
            schema = field.schema()
        elif field.choices:
            schema = {"enum": list(field.choices), "default": field.choices[0]}
        else:
            schema = _OTHERS.get(name, _VALUE)
        unit = f" [{field.unit}]" if field.unit else ""
        properties[name] = schema | ({"description": f"{field.meaning}{unit}"} if field.meaning else {})
    return properties

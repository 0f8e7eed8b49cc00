"""JSON schema of circuit files for editors, generated from the declarations of fields."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import replace
from typing import Any

from poppet import library
from poppet.circuit import signal_tables
from poppet.circuit.file import ABOVE
from poppet.circuit.modbus_table import modbus_schema
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.core.provenance import SOURCE_KINDS
from poppet.library.components import components
from poppet.parts import KINDS
from poppet.parts.components import MODEL
from poppet.parts.conditions import MAX_LENGTH
from poppet.parts.fields import OFF_ON, BodySpec, GroupSpec, MemberSpec, NumberSpec, OptionSpec, PortSpec, Spec, specs
from poppet.parts.quantities import QUANTITIES
from poppet.parts.rows import ForceRows, FrictionFactor, GainSchedule, SuctionRows
from poppet.parts.spool_curves import CURVE_FIELDS
from poppet.parts.spool_edges import EDGE_TABLES
from poppet.parts.spool_functions import command_properties
from poppet.parts.steps import MAX_STEPS, NAME, STEP_NAME

DRAFT = "https://json-schema.org/draft/2020-12/schema"
Schema = dict[str, Any]

_LIST: Schema = {"type": "array", "minItems": 1, "items": {"$ref": "#/$defs/value"}}
_TEXT: Schema = {"type": "string"}
_TIME_COLUMN: Schema = {
    "anyOf": [_TEXT, {"type": "object", "properties": {"column": _TEXT, "unit": _TEXT}, "additionalProperties": False}]
}
_SIGNAL_FIELDS: dict[str, Schema] = {
    "times": _LIST,
    "values": _LIST,
    "seed": {"type": "integer"},
    "duty": {"anyOf": [{"$ref": "#/$defs/value"}, {"$ref": "#/$defs/signal"}]},
    "path": _TEXT,
    "column": _TEXT,
    "unit": _TEXT,
    "time": _TIME_COLUMN,
}
"""Schemas of fields of signals that are not a single value."""


def circuit_schema() -> Schema:
    """Return the JSON schema of circuit files, without the tables of `poppet.ensemble.ensemble_schema`.

    Examples
    --------
    >>> schema = circuit_schema()
    >>> schema["$defs"]["orifice"]["properties"]["critical_ratio"]["description"]
    'critical ratio b [1]'
    """
    parts = {"type": "object", "additionalProperties": {"$ref": "#/$defs/part"}, "minProperties": 1}
    nested_inputs = {"allOf": [{"type": "object"}, {"$ref": "#/$defs/input"}]}
    definitions = {
        "value": {"type": ["number", "string"], "description": 'SI number, or text with unit: "6 bar g"'},
        "part": by_kind("part", {name: name for name in KINDS}),
        "signal": by_kind("signal", {kind: f"signal_{kind}" for kind in signal_tables.KINDS}),
        "connected": {"type": "object", "additionalProperties": {"type": "string"}},
        "input": {
            "description": "a constant, a signal, or signals of inputs further down the address",
            # Not `anyOf`: for one error an editor would show the errors of all branches.
            "if": {"type": "object"},
            "then": {
                "if": {"required": ["kind"]},
                "then": {"$ref": "#/$defs/signal"},
                # [signals.valve.pilot_pressure] without quotes is a table in a table
                "else": {"minProperties": 1, "additionalProperties": nested_inputs},
            },
            "else": {"$ref": "#/$defs/value"},
        },
    }
    for name, part in KINDS.items():
        declared = specs(part)
        required = ["kind"]
        for field, spec in declared.items():
            is_connection = isinstance(spec, PortSpec | BodySpec) and not spec.optional
            # A library set (`data`) or a component (`model`) can supply omitted values.
            is_value = isinstance(spec, NumberSpec) and not spec.optional and spec.default is None
            if is_connection or (is_value and not {"data", "model"} & declared.keys()):
                required.append(field)
        fields = {"kind": {"const": name, "description": part.summary}}
        fields |= {field: _field(field, spec, part) for field, spec in declared.items()}
        definitions[name] = closed(fields, required, part.summary)
    for kind in signal_tables.KINDS:
        needed, optional = signal_tables.fields_of(kind)
        fields = {field: _SIGNAL_FIELDS.get(field, {"$ref": "#/$defs/value"}) for field in (*needed, *optional)}
        definitions[f"signal_{kind}"] = closed({"kind": {"const": kind}} | fields, ["kind", *needed], f"{kind} signal")
    return {
        "$schema": DRAFT,
        "title": "poppet circuit file",
        **closed(
            {
                "title": {"type": "string", "description": "shown with every result"},
                "components": {
                    "type": "array",
                    "items": _TEXT,
                    "description": "component files, for the names in the fields `model`",
                },
                "parts": parts,
                "signals": {"type": "object", "additionalProperties": {"$ref": "#/$defs/input"}},
                "connections": {
                    "type": "object",
                    "additionalProperties": {"anyOf": [{"type": "string"}, {"$ref": "#/$defs/connected"}]},
                    "description": "input to the output that it takes",
                },
                "ambient": _section(Ambient, "surroundings, to which gauge values refer"),
                "gas": {"anyOf": [_gas_name(), _section(GasChoice, "gas in the circuit")]},
                "run": _section(Run, "how to run"),
                **{key: {"type": "object"} for key in ABOVE},
                "drawing": _drawing(),
                "modbus": modbus_schema(),
            },
            required=["parts"],
        ),
        "$defs": definitions,
    }


def by_kind(noun: str, definitions: dict[str, str], field: str = "kind") -> Schema:
    """Return the JSON schema of an object whose other fields depend on one field, usually `kind`.

    `noun` describes the object in texts. `definitions` maps each value of this field to the name of the definition that
    applies.
    """
    branches = [
        {"if": {"properties": {field: {"const": kind}}, "required": [field]}, "then": {"$ref": f"#/$defs/{definition}"}}
        for kind, definition in definitions.items()
    ]
    kind = {"enum": list(definitions), "description": f"what {noun} this is"}
    return {"type": "object", "properties": {field: kind}, "required": [field], "allOf": branches}


def _section(kind: type, description: str) -> Schema:
    return closed({field: _field(field, spec, kind) for field, spec in specs(kind).items()}, (), description)


def closed(properties: Schema, required: Any = (), description: str = "") -> Schema:
    """Return the JSON schema of an object that can have only the given fields.

    `properties` maps the names of the fields to their schemas, and `required` contains the names of required fields.
    """
    schema: Schema = {"type": "object", "properties": properties, "additionalProperties": False}
    if required:
        schema["required"] = list(required)
    return schema | ({"description": description} if description else {})


def _field(name: str, spec: Spec, owner: type) -> Schema:
    match spec:
        case NumberSpec():
            return _number_schema(spec, owner)
        case OptionSpec(choices=choices) if choices == OFF_ON:
            return {"type": "boolean", "default": False, "description": spec.doc}
        case OptionSpec():
            return {"enum": list(spec.choices), "default": spec.choices[0], "description": spec.doc}
        case PortSpec():
            return {"type": "string", "description": f"{spec.doc}; name of a part, or ambient"}
        case BodySpec():
            return {"type": "string", "description": f"{spec.doc}; name of a mass, joint or guide"}
        case GroupSpec():
            fields = {local: _field(local, inner, owner) for local, inner in specs(spec.group).items()}
            return closed(fields, (), spec.doc)
        case MemberSpec():
            members = specs(spec.part).items()
            fields = {local: _field(local, s, spec.part) for local, s in members if local not in spec.inherited}
            return closed(fields, (), spec.doc)
    if name == MODEL:
        return _TEXT | {"examples": _models(getattr(owner, "kind", "")), "description": spec.doc}
    reference = _REFERENCES.get(f"{getattr(owner, 'kind', '')}.{name}") or _REFERENCES[name]
    return reference() | {"description": spec.doc}


def _number_schema(spec: NumberSpec, owner: type) -> Schema:
    """Return the JSON schema of a numeric field of the class `owner`.

    The field is a number in SI units within limits, a text with a unit, or a table with value and source.
    """
    if spec.varies is command_properties or (spec.varies is not None and hasattr(owner, "quantity")):
        # Another quantity or another type of setpoint has other units and limits.
        spec = replace(spec, unit=f"{spec.unit} by default", low=-math.inf, high=math.inf, default=None, varies=None)
    # The limits are in SI and do not apply to text, which can have another unit.
    limits = {"minimum": spec.low, "maximum": spec.high, "exclusiveMinimum": spec.above, "exclusiveMaximum": spec.below}
    number: Schema = {"type": "number"} | {name: limit for name, limit in limits.items() if math.isfinite(limit)}
    sourced = {
        "value": {"anyOf": [number, _TEXT]},
        "source": {"enum": list(SOURCE_KINDS)},
        "locator": {"type": "string", "description": "where to look it up: work, table, page"},
        "note": _TEXT,
    }
    schema: Schema = {
        "anyOf": [number, _TEXT, closed(sourced, ["value"])],
        "description": f"{spec.doc} [{spec.unit}]" + ("" if spec.default is None else f"; default {spec.default}"),
    }
    return schema if spec.default is None else schema | {"default": spec.default}


def _models(kind: str) -> list[str]:
    """Return the names of the components that a part of a kind can represent, for the completion of editors."""
    return [*dict.fromkeys(name for component in components() if kind in component.kinds for name in component.names)]


def _drawing() -> Schema:
    """Return the JSON schema of the positions of parts, and of the points of wires, in the drawing of an editor."""
    place = closed(
        {
            "x": {"type": "number"},
            "y": {"type": "number"},
            "rotation": {"enum": [0, 90, 180, 270], "default": 0},
            "mirror": {"type": "boolean", "default": False},
        },
        ["x", "y"],
    )
    point = {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2}
    wire = closed({"points": {"type": "array", "items": point, "minItems": 1}}, ["points"])
    return {
        "type": "object",
        # The address of a port or input contains a dot, the name of a part does not.
        "patternProperties": {r"\.": wire},
        "additionalProperties": place,
        "description": "positions of parts and points of wires; no effect on a run",
    }


def _gas_name() -> Schema:
    return {"type": "string", "examples": list(library.gas_names())}


def _names(pattern: str) -> Schema:
    return {"type": "array", "items": {"type": "string", "pattern": f"^{pattern}$"}, "uniqueItems": True}


def _step() -> Schema:
    """Return the JSON schema of one step of a sequence."""
    value = {"$ref": "#/$defs/value"}
    condition = {"type": "string", "maxLength": MAX_LENGTH, "examples": ["slide.position > 98 mm and elapsed > 0.1 s"]}
    fields = {
        "on": _names(NAME.pattern) | {"description": "outputs that are 1 during the step"},
        "set": {"type": "object", "additionalProperties": value, "description": "outputs with other values, -1 to 1"},
        "next": {"type": "object", "additionalProperties": condition, "description": "next step to its condition"},
        "timeout": closed({"after": value, "to": _TEXT}, ["after", "to"], "next step after a time in this step"),
    }
    return closed(fields, (), "step of a sequence")


def _edge_table_schema() -> Schema:
    """Return the schema of a table of a metering edge, or of its path."""
    column: Schema = {"anyOf": [{"$ref": "#/$defs/value"}, _LIST]}
    fields = dict.fromkeys(CURVE_FIELDS, column) | {"kind": {"const": "table"}, "source": _TEXT, "note": _TEXT}
    return {"anyOf": [_TEXT, closed(fields, ["sonic_conductance", "critical_ratio"])]}


_REFERENCES: dict[str, Callable[[], Schema]] = {
    "data": lambda: {"enum": [name for name in library.sets() if name != "gases"]},
    "characteristic": lambda: {
        "anyOf": [
            {"type": "string", "examples": list(library.characteristics())},
            {
                "type": "object",
                "properties": {"kind": {"enum": ["constant", "polynomial", "table"]}},
                "required": ["kind"],
            },
        ]
    },
    **dict.fromkeys(("spool_valve.characteristic", *EDGE_TABLES), _edge_table_schema),
    # The first column of a schedule has the name of the controlled quantity.
    "schedule": lambda: closed(
        dict.fromkeys((*QUANTITIES, *GainSchedule.column_specs("pressure", "opening")), _LIST),
        ["gain", "integral_time"],
    ),
    "force_table": lambda: {
        "type": "object",
        "required": list(ForceRows.column_specs()),
        "properties": dict.fromkeys(ForceRows.column_specs(), _LIST),
    },
    "position_factor": lambda: closed(
        dict.fromkeys(FrictionFactor.column_specs(), _LIST), FrictionFactor.column_specs()
    ),
    "suction_curve": lambda: closed(dict.fromkeys(SuctionRows.column_specs(), _LIST), SuctionRows.column_specs()),
    "name": _gas_name,
    "profile": lambda: {"type": "object", "additionalProperties": {"$ref": "#/$defs/value"}},
    "stop_when": lambda: {"anyOf": [_TEXT, {"type": "array", "items": _TEXT}]},
    "measurement": lambda: _TEXT,
    "outputs": lambda: _names(NAME.pattern),
    "inputs": lambda: _names(NAME.pattern),
    "start": lambda: _TEXT,
    "fmu.path": lambda: {"type": "string", "minLength": 1, "examples": ["drive.fmu"]},
    "fmu.start": lambda: {
        "type": "object",
        "additionalProperties": {"anyOf": [{"$ref": "#/$defs/value"}, {"type": ["boolean", "object"]}]},
    },
    "fmu.units": lambda: {"type": "object", "additionalProperties": _TEXT},
    "emergency": lambda: _TEXT,
    "steps": lambda: {
        "type": "object",
        "minProperties": 1,
        "maxProperties": MAX_STEPS,
        "propertyNames": {"pattern": f"^{STEP_NAME.pattern}$"},
        "additionalProperties": _step(),
    },
}
"""Schemas of the fields that contain the name of an object."""

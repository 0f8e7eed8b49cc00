"""Functions about declarations: kinds of parts, their fields, inputs and outputs, signals, and codes of messages."""

from __future__ import annotations

import json
import math
from collections.abc import Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Annotated, Any

from poppet.assist.arguments import Argument
from poppet.assist.circuits import NATIVE
from poppet.assist.file_tables import described_tables
from poppet.assist.folder import Folder
from poppet.assist.replies import Json
from poppet.core.errors import InputError, NameSuggestion

SERIES = Path(__file__).with_name("series.json")
"""Inputs and outputs of the parts in the examples, by kind, with SI units; `tools/assistant_reference.py` writes it."""
SECTIONS = ("run", "ambient", "gas")
"""Tables of a circuit file with fields, besides those of parts."""


def list_kinds(folder: Folder) -> Json:
    """List the kinds of parts with their meaning, of signals, and the tables that `describe_kind` describes."""
    from poppet.circuit import signal_tables
    from poppet.circuit.file import ABOVE, TOP_LEVEL

    return {
        "kinds": {name: kind.summary for name, kind in built_in_kinds().items()},
        "signals": list(signal_tables.KINDS),
        "tables": [*TOP_LEVEL, *ABOVE],
        "described_tables": [*SECTIONS, *described_tables()],
    }


def describe_kind(
    folder: Folder, kind: Annotated[str, Argument("kind of part or of signal, or a table of `list_kinds`", longest=100)]
) -> Json:
    """Describe a kind of part, or a table: fields with unit, default and limits; inputs and outputs with SI units."""
    from poppet.circuit import signal_tables
    from poppet.circuit.options import Ambient, GasChoice, Run

    sections: dict[str, Any] = {"run": Run, "ambient": Ambient, "gas": GasChoice}
    if kind in sections:
        return {"kind": kind, "fields": fields_of(sections[kind])}
    if kind in signal_tables.KINDS:
        return {"kind": kind, "fields": signal_fields(kind)}
    if kind in described_tables():
        return {"kind": kind, "fields": described_tables()[kind]}
    kinds = built_in_kinds()
    if kind not in kinds:
        suggestion = NameSuggestion(kind, [*kinds, *signal_tables.KINDS, *sections, *described_tables()])
        raise InputError("fields.not_an_option", "kind", value=kind, meaning="kind of part", suggestion=suggestion)
    series = series_of_kinds().get(kind, {})
    return {
        "kind": kind,
        "summary": kinds[kind].summary,
        "fields": fields_of(kinds[kind]),
        "exactly_one_of": list(kinds[kind].sizes),
        "inputs": series.get("inputs", {}),
        "outputs": series.get("outputs", {}),
    }


def explain(
    folder: Folder,
    name: Annotated[str, Argument("code of a message, first part of codes, verdict, or kind of part", longest=200)],
) -> Json:
    """Explain the code of an error, note or finding, or a verdict, by cause and remedy; or describe a kind of part."""
    from poppet.core.explanations import explanation, renamed_codes, verdict_explanations
    from poppet.core.message_format import every_code, topics

    codes, titles = every_code(), topics()
    new = renamed_codes().get(name, name)
    members = [code for code in codes if code.startswith(f"{name}.")]
    if new in codes or new in verdict_explanations():
        return {"code": new, **explanation(new)}
    if name in built_in_kinds():
        return describe_kind(folder, name)
    if members:
        return {"name": name, "title": titles.get(name, ""), "codes": members}
    raise InputError(
        "cli.code",
        "name",
        code=name,
        suggestion=NameSuggestion(name, codes if "." in name else [*titles, *verdict_explanations()]),
    )


def built_in_kinds() -> Mapping[str, Any]:
    """Return the kinds of parts that a circuit of an assistant can contain, without those of plugins."""
    from poppet.parts import KINDS

    # The classes of plugins are objects, those of the package are texts.
    names = [name for name, location in KINDS.data.items() if isinstance(location, str) and name not in NATIVE]
    return {name: KINDS[name] for name in names}


@cache
def series_of_kinds() -> Mapping[str, Any]:
    """Return inputs and outputs of the parts in the examples by kind, with SI units."""
    content: Mapping[str, Any] = json.loads(SERIES.read_text(encoding="utf-8"))
    return content


def signal_fields(kind: str) -> dict[str, Json]:
    """Return the fields of a kind of signal."""
    from poppet.circuit import signal_tables

    required, optional = signal_tables.fields_of(kind)
    return {name: {"is_required": name in required} for name in (*required, *optional)}


def fields_of(owner: Any) -> dict[str, Json]:
    """Return the fields of a part or section by name, those of groups and members with dotted names."""
    return dict(_fields(owner, "", (), ""))


def _fields(owner: Any, prefix: str, skipped: tuple[str, ...], optional: str) -> Iterator[tuple[str, Json]]:
    """Yield the fields of a part or group; `optional` is the address of the optional group that contains it, if any."""
    from poppet.parts.fields import BodySpec, GroupSpec, MemberSpec, NumberSpec, OptionSpec, PortSpec, specs

    declared = specs(owner)
    for name, spec in declared.items():
        if name in skipped:
            continue
        row: Json = {"meaning": spec.doc}
        if isinstance(spec, GroupSpec):
            yield from _fields(spec.group, f"{prefix}{name}.", (), f"{prefix}{name}" if spec.optional else optional)
            continue
        if isinstance(spec, MemberSpec):
            outer = f"{prefix}{name}" if spec.optional else optional
            yield from _fields(spec.part, f"{prefix}{name}.", tuple(spec.inherited), outer)
            continue
        if isinstance(spec, NumberSpec):
            # A library set (`data`) or a component (`model`) can supply omitted values.
            sources = [f"`{name}`" for name in ("data", "model") if name in declared]
            is_required: Any = not spec.optional and spec.default is None
            if is_required and sources:
                is_required = f"unless {' or '.join(sources)} supplies it"
            row |= {"type": "number", "unit": spec.unit, "is_required": is_required}
            row |= {} if spec.default is None else {"default": spec.default, "source": spec.source}
            ends = {key: getattr(spec, key) for key in ("low", "high", "above", "below")}
            row |= {key: end for key, end in ends.items() if math.isfinite(end)}
        elif isinstance(spec, OptionSpec):
            row |= {"type": "option", "choices": list(spec.choices), "default": spec.choices[0]}
        elif isinstance(spec, PortSpec):
            row |= {"type": "name of a reservoir, chamber or ambient", "is_required": not spec.optional}
        elif isinstance(spec, BodySpec):
            row |= {"type": "name of a mass, joint or guide", "is_required": not spec.optional}
        else:
            row |= {"type": getattr(spec, "form", "")} | _library_names(owner, name)
        if optional and row.get("is_required") is True:
            row["is_required"] = f"with {optional}"
        yield f"{prefix}{name}", row


def _library_names(owner: Any, name: str) -> Json:
    """Return the names of the library that a field can contain."""
    from poppet import library
    from poppet.circuit.options import GasChoice

    names: dict[str, Any] = {"data": library.sets, "characteristic": library.characteristics}
    names |= {"name": library.gas_names} if owner is GasChoice else {}
    return {"names": [entry for entry in names[name]() if entry != "gases"]} if name in names else {}

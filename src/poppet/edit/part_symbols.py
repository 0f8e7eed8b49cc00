"""Symbols of the parts in a circuit, where their options change the symbol of the palette."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from functools import cache
from typing import Any

from poppet.circuit.component_files import own_component
from poppet.core.errors import InputError
from poppet.edit.palette import blank_part, palette, symbol_of
from poppet.edit.part_names import part_kind
from poppet.edit.starting_values import starting_fields
from poppet.library.components import CatalogueComponent
from poppet.parts import Part
from poppet.parts.components import MODEL
from poppet.parts.fields import BodySpec, OptionSpec, PortSpec, from_table, specs
from poppet.parts.part import AMBIENT

Entry = Mapping[str, Any]

_KNOWN: dict[tuple[str, str, bool], Entry | None] = {}
"""Symbols by kind, table and drive, since most parts are unchanged by a change of a circuit."""
_MOST = 2000


@cache
def palette_entries() -> Mapping[str, Entry]:
    """Return the entries of the palette by kind."""
    return {entry["kind"]: entry for entry in palette()}


def symbols_of(content: Mapping[str, Any], components: Iterable[CatalogueComponent] = ()) -> dict[str, Entry]:
    """Return `box`, `svg` and `ports` of the parts whose symbol or ports differ from those of the palette.

    Incomplete parts have symbols too, because a user draws them before they are complete.

    Parameters
    ----------
    content : mapping
        Tables of a circuit file.
    components : iterable of CatalogueComponent
        Components of the circuit, in addition to those of the library.
    """
    parts = content.get("parts", {})
    driven = {name for section in ("signals", "connections") for name in _owners(content.get(section, {}))}
    components = tuple(components)
    symbols = {}
    if len(_KNOWN) > _MOST:
        _KNOWN.clear()
    for name, table in parts.items() if isinstance(parts, Mapping) else ():
        kind = part_kind(table)
        if kind is None:
            continue
        key = kind.kind, json.dumps(table, default=repr), name in driven
        if key not in _KNOWN or components:
            _KNOWN[key] = _symbol(_part(kind, table, components), name in driven)
        if (symbol := _KNOWN[key]) is not None:
            symbols[name] = symbol
    return symbols


def _owners(table: Any) -> set[str]:
    """Return the names of the parts whose inputs a table contains."""
    return {str(address).partition(".")[0] for address in table} if isinstance(table, Mapping) else set()


def _part(kind: type[Part], table: Mapping[str, Any], components: Iterable[CatalogueComponent]) -> Part:
    """Return a part with the fields of a table; missing ports and numbers are replaced."""
    declared: Mapping[str, Any] = specs(kind)
    ends = {
        name: AMBIENT if isinstance(spec, PortSpec) else "body"
        for name, spec in declared.items()
        if isinstance(spec, PortSpec | BodySpec) and not spec.optional
    }
    values = {
        name: value
        for name, value in starting_fields(kind.kind).items()
        if not isinstance(declared.get(name), OptionSpec)
    }
    fields = {name: value for name, value in table.items() if name != "kind"}
    if isinstance(fields.get(MODEL), str):
        fields[MODEL] = own_component(fields[MODEL], components)
    for complete in ({**ends, **fields}, {**ends, **values, **fields}):
        try:
            return from_table(kind, complete)
        except InputError:
            pass
    blank: Part = blank_part(kind, table)
    return blank


def _symbol(part: Part, is_driven: bool) -> Entry | None:
    """Return the symbol of a part, or None if it is that of the palette."""
    entry = palette_entries()[part.kind]
    try:
        symbol = symbol_of(part, is_driven=is_driven)
    except Exception:  # an incomplete part can fail anywhere; it has the symbol of the palette
        return None
    names = [port["name"] for port in symbol["ports"]]
    is_usual = symbol["svg"] in (entry["svg"], entry["svg_driven"])
    return None if is_usual and names == [port["name"] for port in entry["ports"]] else symbol

"""Places of a circuit file that contain names of parts: renaming, and references to removed parts."""

from __future__ import annotations

import re
from collections.abc import Callable, Collection, Iterable, Iterator, Mapping
from contextlib import suppress
from typing import Any, NamedTuple

from poppet.core.errors import InputError
from poppet.core.toml import value_text
from poppet.edit.toml_edits import remove, remove_items
from poppet.edit.toml_text import Path, Splice, TomlKey, TomlText, TomlValue, key_text, read_value, spliced
from poppet.parts import KINDS, Part
from poppet.parts.fields import BodySpec, MemberSpec, PortSpec, Spec, from_table, specs
from poppet.parts.part import AMBIENT
from poppet.parts.sequence import Sequence
from poppet.parts.steps import condition_texts

_WORDS = re.compile(
    r"""(?P<text>"[^"]*")
    |(?P<number>(?:\d[\d.,]*|\.\d+)(?:[eE][+-]?\d+)?\s*(?:[A-Za-z%][\w./^*]*)?)  # with its unit, which can be "N.m"
    |(?P<owner>[A-Za-z_][\w-]*)(?P<rest>(?:\.[\w-]+)*)""",
    re.VERBOSE,
)


class Reference(NamedTuple):
    """Name of a part within the table of another part.

    `path` contains the names from the table of the part to the field. If `is_text` is True, the field is a text that
    can contain several addresses, such as a condition.
    """

    path: Path
    owners: frozenset[str]
    is_text: bool = False


def part_kind(table: Any) -> type[Part] | None:
    """Return the class of a part, or None if the kind is not valid."""
    kind = table.get("kind") if isinstance(table, Mapping) else None
    return KINDS.get(kind) if isinstance(kind, str) else None


def wired_fields(kind: type[Part], table: Mapping[str, Any]) -> Iterator[tuple[Path, Spec, Any]]:
    """Yield path, declaration and value of each stated port and body, those of members included."""
    for name, spec in specs(kind).items():
        value = table.get(name)
        if isinstance(spec, PortSpec | BodySpec) and value is not None:
            yield (name,), spec, value
        elif isinstance(spec, MemberSpec) and isinstance(value, Mapping):
            for path, inner, address in wired_fields(spec.part, value):
                yield (name, *path), inner, address


def stated_sources(kind: type[Part], table: Mapping[str, Any]) -> Iterator[tuple[str, str]]:
    """Yield place and address of each output that the fields of a part name."""
    stated = [connection for connection, _ in kind.stated_connections(table).values()]
    if not stated and kind.connections is not Part.connections:
        with suppress(InputError):  # an invalid part
            part = from_table(kind, {key: value for key, value in table.items() if key != "kind"})
            stated = [*part.connections().values()]
    for connection in stated:
        yield connection.place, connection.source


def references(table: Any, names: Collection[str] = ()) -> Iterator[Reference]:
    """Yield all names of parts in the table of a part.

    `names` contains the names of all parts: if the kind is invalid, fields with such a name are references.
    """
    if not isinstance(table, Mapping):
        return
    kind = part_kind(table)
    if kind is None:
        for key, value in table.items():
            if isinstance(value, str) and value.partition(".")[0] in names:
                yield Reference((key,), frozenset({value.partition(".")[0]}))
        return
    for path, _, value in wired_fields(kind, table):
        if isinstance(value, str) and value != AMBIENT:
            yield Reference(path, frozenset({value.partition(".")[0]}))
    # Conditions of sequences that are not valid, too.
    conditions = dict(condition_texts(table)) if issubclass(kind, Sequence) else {}
    for place, text in conditions.items():
        if isinstance(text, str):
            yield Reference(_at(table, place)[0], frozenset(_owners(text)), is_text=True)
    for place, source in stated_sources(kind, table) if not conditions else ():
        path, text = _at(table, place)
        if isinstance(text, str):
            yield Reference(path, frozenset(_owners(text)), is_text=text.strip() != source)


_REGISTERS = ("modbus", "registers")
_ADDRESSED = (("ensemble", "parameters"), ("ensemble", "numbers"), _REGISTERS)
"""Tables below the top level whose keys are addresses."""


def renamed(text: TomlText, content: Mapping[str, Any], old: str, new: str) -> str:
    """Return a text in which a part has another name, in all places."""

    def in_address(address: str) -> str:
        owner, dot, rest = address.partition(".")
        return f"{new}{dot}{rest}" if owner == old else address

    def in_words(words: str) -> str:
        return _with_owners(words, lambda owner: new if owner == old else owner)

    changes: list[Splice] = []
    for path, key in text.names():
        if _is_name(path) and key.name == old:
            changes.append(_key_splice(text, key, new))
        elif _is_address(path) and in_address(key.name) != key.name:
            changes.append(_key_splice(text, key, in_address(key.name)))
    values = dict(_values(text))
    for path, change in _address_values(values, in_address, in_words):
        changes += _text_changes(text, values[path], change)
    parts = content.get("parts", {})
    for name, table in parts.items() if isinstance(parts, Mapping) else ():
        for reference in references(table, parts):
            value = values.get(("parts", name, *reference.path))
            if old in reference.owners and value is not None:
                changes += _text_changes(text, value, in_words if reference.is_text else in_address)
    return spliced(text.text, {change.start: change for change in changes}.values())


def without_references(text: TomlText, content: Mapping[str, Any], removed: Collection[str]) -> str:
    """Return a text without ports, signals, connections, wires, registers and stop conditions of some parts.

    Conditions of sequences remain, because they are written by the user.
    """
    paths: set[Path] = {("drawing", name) for name in removed}
    for path, key in text.names():
        is_of_part = (len(path) == 2 and path[0] in ("signals", "connections", "drawing")) or path[:-1] == _REGISTERS
        if is_of_part and key.name.partition(".")[0] in removed:
            paths.add(path)
    for entry in text.entries():
        if entry.path[0] == "connections" and set(_owners(_text(text, entry.value))) & {*removed}:
            paths |= {entry.path, ("drawing", ".".join(map(str, entry.path[1:])))}
    parts = content.get("parts", {})
    for name, table in parts.items() if isinstance(parts, Mapping) else ():
        if name not in removed:
            for reference in references(table, parts):
                if not reference.is_text and reference.owners & {*removed}:
                    address = ".".join(map(str, (name, *reference.path)))
                    paths |= {("parts", name, *reference.path), ("drawing", address)}
    conditions = next((entry.value for entry in text.entries() if entry.path == ("run", "stop_when")), None)
    if conditions is not None:
        items = conditions.items if conditions.items is not None else (conditions,)
        indices = [k for k, item in enumerate(items) if set(_owners(_text(text, item))) & {*removed}]
        if len(indices) == len(items) > 0:
            paths.add(("run", "stop_when"))
        elif indices:
            text = TomlText(remove_items(text, conditions, indices))
    return remove(text, paths)


def _is_name(path: Path) -> bool:
    return len(path) == 2 and path[0] in ("parts", "drawing")


def _is_address(path: Path) -> bool:
    is_input_or_wire = len(path) == 2 and path[0] in ("signals", "connections", "drawing")
    return is_input_or_wire or (len(path) == 3 and path[:2] in _ADDRESSED)


def _address_values(
    values: Iterable[Path], in_address: Callable[[str], str], in_words: Callable[[str], str]
) -> Iterator[tuple[Path, Callable[[str], str]]]:
    """Yield the paths of the values outside the parts that contain addresses, each with its kind of replacement."""
    for path in values:
        is_metric = len(path) == 4 and path[:2] == ("ensemble", "metrics") and path[3] in ("of", "target")
        if path[0] == "connections" or is_metric or path == ("ensemble", "curves"):
            yield path, in_address
        elif path == ("run", "stop_when"):
            yield path, in_words


def _values(text: TomlText) -> Iterator[tuple[Path, TomlValue]]:
    for entry in text.entries():
        yield entry.path, entry.value


def _text_changes(text: TomlText, value: TomlValue, change: Callable[[str], str]) -> Iterator[Splice]:
    """Yield the changes of a text, or of all texts in a list."""
    for item in value.items if value.items is not None else (value,):
        old = _text(text, item)
        if not old or change(old) == old:
            continue
        raw = text.raw(item)
        quotes = next(quotes for quotes in ('"""', "'''", '"', "'") if raw.startswith(quotes))
        inner = raw[len(quotes) : -len(quotes)]
        is_literal = quotes[0] == "'" or "\\" not in inner
        yield Splice(
            item.start, item.end, f"{quotes}{change(inner)}{quotes}" if is_literal else value_text(change(old))
        )


def _text(text: TomlText, value: TomlValue) -> str:
    """Return a value that is a text, otherwise an empty text."""
    raw = text.raw(value)
    if raw[0] not in "\"'":
        return ""
    return str(read_value(raw))


def _key_splice(text: TomlText, key: TomlKey, new: str) -> Splice:
    quote = text.text[key.start]
    is_plain = quote in "\"'" and re.fullmatch(r"[\w. -]*", new)
    return Splice(key.start, key.end, f"{quote}{new}{quote}" if is_plain else key_text(new))


def _at(table: Mapping[str, Any], place: str) -> tuple[Path, Any]:
    """Return path and value of a dotted place in a table, whose names can contain dots."""
    for name, value in table.items():
        if place == name:
            return (name,), value
        if place.startswith(f"{name}.") and isinstance(value, Mapping):
            path, inner = _at(value, place[len(name) + 1 :])
            if path:
                return (name, *path), inner
    return (), None


def _owners(words: str) -> Iterator[str]:
    """Yield the names of the parts whose outputs a text names."""
    for match in _WORDS.finditer(words):
        if match["owner"] and match["rest"]:
            yield match["owner"]


def _with_owners(words: str, change: Callable[[str], str]) -> str:
    def replace(match: re.Match[str]) -> str:
        return f"{change(match['owner'])}{match['rest']}" if match["owner"] and match["rest"] else match[0]

    return _WORDS.sub(replace, words)

"""Operations of the editor on the text of a circuit file.

An operation is a JSON object whose field `op` is its name. Each function below performs one of them; it takes the
present text and the other fields, and returns the new text.
"""

from __future__ import annotations

import inspect
import math
import re
from collections.abc import Callable, Collection, Mapping
from functools import cached_property
from typing import Any

from poppet.circuit.file import ABOVE, TOP_LEVEL
from poppet.circuit.wiring import RESERVED, check_name
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.toml import toml_text
from poppet.core.toml_file import TomlFile
from poppet.edit.part_names import part_kind, references, renamed, stated_sources, wired_fields, without_references
from poppet.edit.toml_edits import add_table, is_stated, remove, set_value
from poppet.edit.toml_text import Path, TomlText
from poppet.parts import KINDS
from poppet.parts.fields import BodySpec, MemberSpec, PortSpec, Spec, specs
from poppet.parts.part import AMBIENT, TUBE

ORDER = (*TOP_LEVEL, *ABOVE)
"""Names at the top level of a circuit file in the usual order."""
MAX_POSITION = 1e5
"""Largest coordinate in a drawing, in grid units."""
MAX_DEPTH = 20
"""Largest depth of lists and tables in a value."""


class CircuitText:
    """Valid TOML text of a circuit file, its content, and the locations of its content."""

    def __init__(self, text: str) -> None:
        self.text = text

    @cached_property
    def toml(self) -> TomlText:
        """Locations of tables and values."""
        return TomlText(self.text)

    @cached_property
    def content(self) -> dict[str, Any]:
        """Tables of the file; a text that is not TOML raises an error."""
        return TomlFile(self.text, "").tables

    def table(self, name: str) -> Mapping[str, Any]:
        """Return a table of the top level; the result is empty if the file has none."""
        table = self.content.get(name)
        return table if isinstance(table, Mapping) else {}

    @property
    def parts(self) -> Mapping[str, Any]:
        """Tables of the parts by name."""
        return self.table("parts")

    def part(self, name: str) -> Mapping[str, Any]:
        """Return the table of a part, which must exist."""
        if name not in self.parts:
            suggestion = NameSuggestion(name, self.parts)
            raise InputError("names.unknown", name, meaning="a part of this circuit", suggestion=suggestion)
        table = self.parts[name]
        if not isinstance(table, Mapping):
            raise InputError("circuit.no_part", f"parts.{name}", value=table)
        return table


# --- Parts ---


def add(
    circuit: CircuitText,
    kind: str,
    name: str | None = None,
    place: Mapping[str, Any] | None = None,
    fields: Mapping[str, Any] | None = None,
) -> str:
    """Add a part with some fields behind the last part, named after its kind by default."""
    if kind not in KINDS:
        suggestion = NameSuggestion(kind, KINDS)
        raise InputError("fields.not_an_option", "kind", value=kind, meaning="kind of part", suggestion=suggestion)
    if name is None:
        name = free_name(kind, circuit.parts)
    _check_new_name(circuit, name)
    text = add_table(circuit.toml, ("parts", name), {"kind": kind}, ORDER)
    for address, value in (fields or {}).items():
        text = set_field(CircuitText(text), f"{name}.{address}", value)
    return text if place is None else set_place(CircuitText(text), name, **_place_of(name, place))


def remove_parts(circuit: CircuitText, parts: list[Any]) -> str:
    """Remove parts, with their signals, connections, positions and the ports of other parts that name them."""
    names = [str(name) for name in parts]
    for name in names:
        if name not in circuit.parts:
            circuit.part(name)
    text = without_references(circuit.toml, circuit.content, names)
    return remove(TomlText(text), [("parts", name) for name in names])


def rename(circuit: CircuitText, part: str, name: str) -> str:
    """Give a part another name, in all places that contain the name."""
    if part not in circuit.parts:
        circuit.part(part)
    if name == part:
        return circuit.text
    _check_new_name(circuit, name)
    return renamed(circuit.toml, circuit.content, part, name)


def paste(circuit: CircuitText, parts: Mapping[str, Any], drawing: Mapping[str, Any] | None = None) -> str:
    """Add copies of parts, with the connections among them; names that exist already are changed."""
    for name, table in parts.items():
        check_name(name)
        if not isinstance(table, Mapping):
            raise InputError("circuit.no_part", f"parts.{name}", value=table)
        check_value(f"parts.{name}", table)
    copies = CircuitText(toml_text({"parts": parts}))
    outside = {owner for table in parts.values() for reference in references(table) for owner in reference.owners}
    copies = CircuitText(without_references(copies.toml, copies.content, outside - {*parts}))
    names = {}
    for name in parts:
        names[name] = name
        if name in circuit.parts:
            base = re.sub(r"_\d+\Z", "", name) or name
            names[name] = free_name(base, {*circuit.parts, *parts, *names.values()})
            copies = CircuitText(renamed(copies.toml, copies.content, name, names[name]))
    text = circuit.text
    for name, table in copies.parts.items():
        text = add_table(TomlText(text), ("parts", name), table, ORDER)
    for address, entry in (drawing or {}).items():
        name, dot, local = address.partition(".")
        if name in names and local:
            points = entry.get("points") if isinstance(entry, Mapping) else None
            text = route(CircuitText(text), f"{names[name]}{dot}{local}", points if isinstance(points, list) else [])
        elif name in names:
            text = set_place(CircuitText(text), names[name], **_place_of(name, entry))
    return text


def set_place(
    circuit: CircuitText, part: str, x: float, y: float, rotation: int | None = None, mirror: bool | None = None
) -> str:
    """Set the position of a part in the drawing; rotation and mirror are unchanged if they are not stated."""
    if part not in circuit.parts:
        circuit.part(part)
    old = circuit.table("drawing").get(part)
    place = dict(old) if isinstance(old, Mapping) else {}
    for key, value in {"x": x, "y": y, "rotation": rotation, "mirror": mirror}.items():
        if value is not None:
            place[key] = int(value) if isinstance(value, float) and value.is_integer() else value
    if not all(is_coordinate(place.get(key)) for key in "xy") or place.get("rotation", 0) not in (0, 90, 180, 270):
        raise InputError("edit.no_position", f"drawing.{part}", value=place)
    # The usual orientation is not written.
    place = {key: value for key, value in place.items() if key in "xy" or value}
    return _set_table(circuit.text, ("drawing", part), place)


def route(circuit: CircuitText, port: str, points: list[Any] | None = None) -> str:
    """Set the points through which the wire of a port or input passes; None removes them."""
    _check_input(circuit, port)
    if points is None:
        return remove(circuit.toml, [("drawing", port)])
    is_valid = points and all(isinstance(point, list) and len(point) == 2 for point in points)
    if not is_valid or not all(is_coordinate(value) for point in points for value in point):
        raise InputError("edit.no_points", f"drawing.{port}", value=points)
    whole = [[int(value) if float(value).is_integer() else value for value in point] for point in points]
    return _set_table(circuit.text, ("drawing", port), {"points": whole})


# --- Values ---


def set_field(circuit: CircuitText, address: str, value: Any) -> str:
    """Set a field of a part, or of a table such as `run`; None removes it."""
    path = _path_of(circuit, address)
    if value is None:
        return _without_empty_groups(remove(circuit.toml, [path]), path[:-1])
    check_value(address, value)
    return set_value(circuit.toml, path, value, ORDER)


def set_signal(circuit: CircuitText, address: str, table: Any = None) -> str:
    """Set the signal of an input, a table or a constant, in place of a connection; None removes it."""
    _check_input(circuit, address)
    stated = _stated_path(circuit, "signals", address)
    if table is None:
        return remove(circuit.toml, [stated] if stated else [])
    check_value(f"signals.{address}", table)
    connection = _stated_path(circuit, "connections", address)
    text = remove(circuit.toml, [connection, ("drawing", address)]) if connection else circuit.text
    path = stated or ("signals", address)
    if isinstance(table, Mapping):
        return _set_table(text, path, table)
    return set_value(TomlText(text), path, table, ORDER)


def link(circuit: CircuitText, input: str, output: str) -> str:
    """Connect an input of a part to an output of another one, in place of a signal."""
    _check_input(circuit, input)
    circuit.part(output.partition(".")[0])
    path = _source_field(circuit, input) or _stated_path(circuit, "connections", input) or ("connections", input)
    text, signal = _without_route(circuit, input, output), _stated_path(circuit, "signals", input)
    return set_value(TomlText(remove(TomlText(text), [signal] if signal else [])), path, output, ORDER)


def unlink(circuit: CircuitText, input: str) -> str:
    """Remove the connection of an input, with the points of its wire."""
    _check_input(circuit, input)
    paths = (_source_field(circuit, input), _stated_path(circuit, "connections", input), ("drawing", input))
    return remove(circuit.toml, [path for path in paths if path])


# --- Ports ---


def connect(circuit: CircuitText, port: str, to: str) -> str:
    """Connect a port to a gas node, to a body, or to the end of a tube."""
    for end in (port, to):
        if end != AMBIENT:
            circuit.part(end.partition(".")[0])
    if _port_spec(circuit, port) is None and _port_spec(circuit, to) is not None:
        port, to = to, port
    spec = _port_spec(circuit, port)
    if spec is None:
        owner, _, local = port.partition(".")
        if local and (kind := part_kind(circuit.part(owner))) is not None:
            suggestion = NameSuggestion(local, _port_names(kind))
            raise InputError("fields.not_an_option", port, value=local, meaning="port", suggestion=suggestion)
        raise InputError("edit.no_port", port=port, to=to)
    if _port_spec(circuit, to) is None:
        targets = {port: to}
    else:  # one of two ports is the end of a tube, and each names the other part
        tube, other = (port, to) if _is_tube(circuit, port) else (to, port)
        if not _is_tube(circuit, tube) or _is_tube(circuit, other) or isinstance(spec, BodySpec):
            raise InputError("edit.two_ports", port=port, to=to)
        targets = {tube: other, other: tube.partition(".")[0]}
    former = {end for port in targets for end in _wire_ends(circuit, port)} - {*targets}
    text = _without_ends(circuit, former)
    for end, target in targets.items():
        text = set_value(TomlText(_without_route(CircuitText(text), end, target)), _port_path(end), target, ORDER)
    return text


def disconnect(circuit: CircuitText, port: str) -> str:
    """Remove the connection of a port and the points of its wire, at both ports if one is the end of a tube."""
    circuit.part(port.partition(".")[0])
    return _without_ends(circuit, _wire_ends(circuit, port))


def _wire_ends(circuit: CircuitText, port: str) -> list[str]:
    """Return the ports at the ends of a wire: the port itself, and the other one if one of them is that of a tube."""
    ends = [port]
    for name, table in circuit.parts.items():
        kind = part_kind(table)
        for path, _, value in wired_fields(kind, table) if kind else ():
            end = ".".join(map(str, (name, *path)))
            if not _is_tube(circuit, end) or not isinstance(value, str):
                continue
            if value == port:
                ends.append(end)
            elif end == port and _port_spec(circuit, value) is not None:
                ends.append(value)
    return ends


def _without_ends(circuit: CircuitText, ends: Collection[str]) -> str:
    """Return a text without the connections of ports and without the points of their wires."""
    paths = [path for end in ends for path in (_port_path(end), ("drawing", end))]
    return remove(circuit.toml, [path for path in paths if is_stated(circuit.toml, path)])


OPERATIONS: dict[str, Callable[..., str]] = {
    "add": add,
    "remove": remove_parts,
    "rename": rename,
    "paste": paste,
    "place": set_place,
    "route": route,
    "set": set_field,
    "signal": set_signal,
    "link": link,
    "unlink": unlink,
    "connect": connect,
    "disconnect": disconnect,
}
"""Operations by name."""
EXAMPLES: dict[str, str] = {
    "add": '{"op": "add", "kind": "orifice"}',
    "remove": '{"op": "remove", "parts": ["tank"]}',
    "rename": '{"op": "rename", "part": "tank", "name": "vessel"}',
    "paste": '{"op": "paste", "parts": {"tank": {"kind": "chamber"}}}',
    "place": '{"op": "place", "part": "tank", "x": 12, "y": 4}',
    "route": '{"op": "route", "port": "valve.supply", "points": [[12, 4], [12, 8]]}',
    "set": '{"op": "set", "address": "tank.volume", "value": "10 l"}',
    "signal": '{"op": "signal", "address": "valve.command", "table": null}',
    "link": '{"op": "link", "input": "valve.command", "output": "plc.clamp"}',
    "unlink": '{"op": "unlink", "input": "valve.command"}',
    "connect": '{"op": "connect", "port": "valve.supply", "to": "tank"}',
    "disconnect": '{"op": "disconnect", "port": "valve.supply"}',
}
"""Examples of all operations."""
_TYPES: dict[str, tuple[type, ...]] = {
    "str": (str,),
    "str | None": (str, type(None)),
    "float": (int, float),
    "int | None": (int, float, type(None)),
    "bool | None": (bool, type(None)),
    "list[Any]": (list,),
    "list[Any] | None": (list, type(None)),
    "Mapping[str, Any]": (Mapping,),
    "Mapping[str, Any] | None": (Mapping, type(None)),
    "Any": (object,),
}


def apply_operation(circuit: CircuitText, operation: Any) -> CircuitText:
    """Return the text after one operation."""
    name = operation.get("op") if isinstance(operation, Mapping) else operation
    if not isinstance(operation, Mapping) or not isinstance(name, str) or name not in OPERATIONS:
        raise InputError("edit.no_operation", value=name, suggestion=NameSuggestion(str(name), OPERATIONS))
    fields = {key: value for key, value in operation.items() if key != "op"}
    parameters = [*inspect.signature(OPERATIONS[name]).parameters.values()][1:]
    for parameter in parameters:
        is_missing = parameter.name not in fields and (parameter.default is parameter.empty)
        value = fields.get(parameter.name)
        is_flag = isinstance(value, bool) and parameter.annotation in ("float", "int | None")
        if (
            is_missing
            or is_flag
            or (parameter.name in fields and not isinstance(value, _TYPES[str(parameter.annotation)]))
        ):
            wanted = _wanted(str(parameter.annotation))
            raise InputError("edit.no_field", parameter.name, operation=name, wanted=wanted, example=EXAMPLES[name])
    for key in fields:
        names = [parameter.name for parameter in parameters]
        if key not in names:
            raise InputError("fields.unknown", str(key), table="operation", suggestion=NameSuggestion(str(key), names))
    changed = CircuitText(OPERATIONS[name](circuit, **fields))
    try:
        changed.text.encode("utf-8")
        changed.content  # noqa: B018 - raises if the text is not valid
    except (InputError, UnicodeEncodeError):
        raise InputError("edit.not_valid", operation=name) from None
    return changed


def free_name(base: str, taken: Collection[str]) -> str:
    """Return the first of the names `orifice`, `orifice_2`, `orifice_3`, ... that is not taken.

    Examples
    --------
    >>> free_name("orifice", {"orifice", "tank"})
    'orifice_2'
    """
    number, name = 1, base
    while name in taken or name in RESERVED:
        number += 1
        name = f"{base}_{number}"
    return name


def check_value(address: str, value: Any, depth: int = 0) -> None:
    """Raise InputError if a value cannot be written in a TOML file."""
    is_integer = isinstance(value, int) and not isinstance(value, bool)
    if depth > MAX_DEPTH or (is_integer and abs(value) >= 2**63):
        raise InputError("edit.no_value", address, value="a deep or large value")
    if isinstance(value, Mapping):
        for key, inner in value.items():
            check_value(f"{address}.{key}", inner, depth + 1)
    elif isinstance(value, list):
        for inner in value:
            check_value(address, inner, depth + 1)
    elif not isinstance(value, bool | int | float | str):
        raise InputError("edit.no_value", address, value=value)


def _wanted(annotation: str) -> str:
    names = {"str": "a text", "float": "a number", "int": "a number", "bool": "true or false", "list[Any]": "a list"}
    return names.get(annotation.removesuffix(" | None"), "a table")


def _check_new_name(circuit: CircuitText, name: str) -> None:
    check_name(name)
    if name in circuit.parts:
        raise InputError("edit.name_taken", f"parts.{name}", name=name)


def _place_of(name: str, place: Any) -> dict[str, Any]:
    if not isinstance(place, Mapping) or not {"x", "y"} <= {*place} <= {"x", "y", "rotation", "mirror"}:
        raise InputError("edit.no_position", f"drawing.{name}", value=place)
    return dict(place)


def is_coordinate(value: Any) -> bool:
    """Return True if a value is a coordinate of a drawing."""
    is_number = isinstance(value, int | float) and not isinstance(value, bool)
    return is_number and math.isfinite(value) and abs(value) <= MAX_POSITION


def _path_of(circuit: CircuitText, address: str) -> Path:
    """Return the path of an address: `tank.volume`, `run.duration`, `title`."""
    names = tuple(address.removeprefix("parts.").split("."))
    if not all(names):
        raise InputError("edit.no_address", address)
    if names[0] in circuit.parts:
        # Names of steps can contain dots.
        return _existing(circuit.parts[names[0]], ("parts", names[0]), names[1:], address)
    if names[0] in ORDER and names[0] not in ("parts", "signals", "connections", "drawing"):
        return _existing(circuit.content.get(names[0]), names[:1], names[1:], address, is_section=True)
    suggestion = NameSuggestion(names[0], [*circuit.parts, *(name for name in ORDER if name not in RESERVED)])
    raise InputError("names.unknown", address, meaning="a part or a table of this circuit", suggestion=suggestion)


def _existing(table: Any, start: Path, rest: Path, address: str, *, is_section: bool = False) -> Path:
    """Return the path of an address in a table, in which names with dots are recognised if they exist."""
    if not rest and not is_section:
        raise InputError("edit.no_address", address)
    path: Path = start
    while rest:
        keys = table if isinstance(table, Mapping) else {}
        joined = [".".join(map(str, rest[:count])) for count in range(len(rest), 0, -1)]
        name = next((name for name in joined if name in keys), str(rest[0]))
        path, rest = (*path, name), rest[name.count(".") + 1 :]
        table = keys.get(name)
    return path


def _without_empty_groups(text: str, path: Path) -> str:
    """Return a text without the group of fields at a path, and without those around it, if they are empty."""
    smallest = 3 if path[0] == "parts" else 2  # a part remains, and so does a table of the top level
    while len(path) >= smallest:
        table: Any = CircuitText(text).content
        for name in path:
            table = table.get(name) if isinstance(table, Mapping) else None
        if table != {}:
            break
        text, path = remove(TomlText(text), [path]), path[:-1]
    return text


def _check_input(circuit: CircuitText, address: str) -> None:
    owner, _, local = address.partition(".")
    circuit.part(owner)
    if not local:
        raise InputError("edit.no_address", address)


def _stated_path(circuit: CircuitText, section: str, address: str) -> Path | None:
    """Return the path of an input in `signals` or `connections`, whose name can be one key or several."""
    table: Any = circuit.table(section)
    path: Path = (section,)
    rest = address
    while isinstance(table, Mapping):
        if rest in table:
            return (*path, rest)
        name, _, rest = rest.partition(".")
        if name not in table or not rest:
            return None
        path, table = (*path, name), table[name]
    return None


def _source_field(circuit: CircuitText, address: str) -> Path | None:
    """Return the path of the field of a part that names the source of an input, if it is stated."""
    owner, _, local = address.partition(".")
    table = circuit.part(owner)
    kind = part_kind(table)
    places = [place for place, _ in stated_sources(kind, table)] if kind else []
    return ("parts", owner, local) if local in places and isinstance(table.get(local), str) else None


def _set_table(text: str, path: Path, table: Mapping[str, Any]) -> str:
    """Set the entries of a table, in the form that it has: below a header, with dotted keys, or inline."""
    toml = TomlText(text)
    if not is_stated(toml, path):
        if path[0] == "drawing":
            return set_value(toml, path, table, ORDER)
        return add_table(toml, path, table, ORDER)
    if any(entry.path == path for entry in toml.entries()):
        return set_value(toml, path, table, ORDER)
    present: Any = CircuitText(text).content
    for name in path:
        present = present[name]
    text = remove(toml, [(*path, key) for key in present if key not in table])
    for key, value in table.items():
        if present.get(key) != value or type(present.get(key)) is not type(value):
            text = set_value(TomlText(text), (*path, key), value, ORDER)
    return text


def _without_route(circuit: CircuitText, port: str, target: str) -> str:
    """Return the text without the points of a wire that has another target until now."""
    owner, _, local = port.partition(".")
    present: Any = circuit.part(owner)
    for name in local.split("."):
        present = present.get(name) if isinstance(present, Mapping) else None
    stated = _stated_path(circuit, "connections", port)
    source: Any = circuit.content if stated else None
    for key in stated or ():
        source = source[key]
    has_other = any(end not in (None, target) for end in (present, source))
    return remove(circuit.toml, [("drawing", port)]) if has_other else circuit.text


def _port_path(port: str) -> Path:
    return ("parts", *port.split("."))


def _port_spec(circuit: CircuitText, end: str) -> Spec | None:
    """Return the declaration of a port or body field, or None if the end is not one."""
    owner, _, local = end.partition(".")
    table = circuit.parts.get(owner)
    kind = part_kind(table)
    if kind is None or not local:
        return None
    declared: Mapping[str, Spec] = specs(kind)
    *members, name = local.split(".")
    for member in members:
        outer = declared.get(member)
        if not isinstance(outer, MemberSpec):
            return None
        declared = specs(outer.part)
    spec = declared.get(name)
    return spec if isinstance(spec, PortSpec | BodySpec) else None


def _port_names(kind: Any) -> list[str]:
    return [name for name, spec in specs(kind).items() if isinstance(spec, PortSpec | BodySpec)]


def _is_tube(circuit: CircuitText, end: str) -> bool:
    kind = part_kind(circuit.parts.get(end.partition(".")[0]))
    return kind is not None and kind.kind == TUBE

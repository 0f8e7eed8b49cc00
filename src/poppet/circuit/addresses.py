"""Changes of the values of a circuit by their addresses.

Examples of addresses are `tank.volume`, `valve.lower_spring.rate`, `ambient.pressure` and `run.duration`.
"""

from __future__ import annotations

import dataclasses
from collections import defaultdict
from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from typing import TYPE_CHECKING, Any, TypeVar

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.provenance import Number, Source
from poppet.core.units import Kind, quantity
from poppet.parts.fields import GroupSpec, MemberSpec, Spec, attribute, specs
from poppet.parts.part import Part

if TYPE_CHECKING:
    from _typeshed import DataclassInstance

_Owner = TypeVar("_Owner", bound="DataclassInstance")


def change_values(owners: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """Return copies of the parts and sections of a circuit with changed fields.

    `owners` maps names to parts, and to the sections `ambient`, `gas` and `run`. `values` maps addresses such as
    `tank.volume` to new values. Parts and sections without a new value are returned unchanged.
    """
    if not isinstance(values, Mapping):
        raise InputError("address.no_mapping", values=values)
    result = dict(owners)
    changes_by_owner: dict[str, dict[str, Any]] = defaultdict(dict)
    with ErrorCollector() as errors:
        for address, value in values.items():
            name, _, path = address.partition(".") if isinstance(address, str) else (address, "", "")
            if name in owners and path:
                changes_by_owner[name][path] = value
                continue
            address = str(address)
            addresses = [f"{name}.{key}" for name, owner in owners.items() for key in specs(type(owner))]
            # Similar addresses first, then addresses that contain the single word.
            suggestions = get_close_matches(address, addresses, n=3) or [
                candidate
                for word in (address, *get_close_matches(address, {a.partition(".")[2] for a in addresses}, n=1))
                for candidate in addresses
                if word in candidate.split(".")
            ]
            if suggestions:
                errors.add("address.meant", address, names=suggestions[:3])
            else:
                errors.add("address.no_owner", address, owners=[*owners])
        # All changes of a part together: two values can be valid only in combination.
        for name, changes in changes_by_owner.items():
            with errors.collecting():
                result[name] = _change_owner(owners[name], name, changes)
    return result


def _change_owner(owner: _Owner, name: str, changes: Mapping[str, Any], inherited: Sequence[str] = ()) -> _Owner:
    """Return a copy of a part or section with changed fields.

    `owner` is the part or section, and `name` its name. The keys of `changes` are addresses inside it, such as
    `volume`. The fields in `inherited` cannot be changed, because the enclosing compound part sets them.
    """
    changes_by_field: dict[str, dict[str, Any]] = defaultdict(dict)
    for path, value in changes.items():
        field, _, subpath = path.partition(".")
        changes_by_field[field][subpath] = value
    fields = {}
    with ErrorCollector() as errors:
        for field, subchanges in changes_by_field.items():
            with errors.collecting():
                # Here, not in the constructor: errors of several fields are reported together.
                fields[attribute(field)] = _change_field(owner, name, field, subchanges, inherited)
    try:
        return dataclasses.replace(owner, **fields)
    except InputError as error:
        raise error.within(name) from None


def _change_field(owner: Any, name: str, field: str, changes: Mapping[str, Any], inherited: Sequence[str]) -> object:
    """Return the new value of one field of a part.

    The keys of `changes` are addresses inside the field. A value with an empty key replaces the whole field. `owner` is
    the part with the address `name` that contains the field. The fields in `inherited` cannot be changed, because the
    enclosing compound part sets them.
    """
    if field in inherited:
        raise InputError("address.told", f"{name}.{field}", whole=name.rpartition(".")[0])
    valid = [key for key in specs(type(owner)) if key not in inherited]
    if field not in valid:
        # Only signals can drive an input that is not a parameter.
        if isinstance(owner, Part) and field in {item.name for item in owner.inputs()}:
            raise InputError("address.is_input", f"{name}.{field}")
        # A missing group name is as common as a misspelt field.
        path = next(f"{field}.{subpath}" if subpath else field for subpath in changes)
        nested = [key for key in getattr(owner, "numbers", dict)() if key.endswith(f".{path}")]
        raise _unknown_field(name, path, nested or valid)
    if "" in changes:
        if len(changes) > 1:
            raise InputError("address.whole_and_part", f"{name}.{field}")
        return changes[""]
    spec, current = specs(type(owner))[field], getattr(owner, attribute(field))
    if isinstance(spec, MemberSpec):
        return _change_owner(current, f"{name}.{field}", changes, spec.inherited)
    with ErrorCollector() as errors:
        for path, value in changes.items():
            with errors.collecting():
                current = _change_nested(current, spec, f"{name}.{field}", path, value)
    return current


def _change_nested(current: Any, spec: Spec, name: str, path: str, value: Any) -> object:
    """Return a copy of a group or characteristic in which one parameter is changed.

    `current` is the present group or characteristic, or None if the part has none. `path` is the name of the parameter
    inside it, and `spec` is the declaration of the field.
    """
    if hasattr(current, "with_numbers"):
        numbers = current.numbers()
        if path not in numbers:
            raise _unknown_field(name, path, numbers)
        if not isinstance(value, Number):
            unit, text = numbers[path].unit, value if isinstance(value, str) else ""
            kind: Kind = current.number_specs()[path].kind if hasattr(current, "number_specs") else "plain"
            read = quantity(value, unit, kind=kind, name=f"{name}.{path}")
            # The text is stored: the value is displayed in its original form.
            value = Number(read.value, unit, Source("given"), read.reference, text)
        try:
            return current.with_numbers({path: value})
        except InputError as error:
            raise error.at(f"{name}.{path}") from None
    valid = specs(spec.group) if isinstance(spec, GroupSpec) else {}
    head, _, rest = path.partition(".")
    if rest and hasattr(table := getattr(current, attribute(head), None), "with_numbers"):
        table = _change_nested(table, valid[head], f"{name}.{head}", rest, value)
        return dataclasses.replace(current, **{attribute(head): table})
    if not isinstance(spec, GroupSpec) or path not in valid:
        raise _unknown_field(name, path, valid)
    # An omitted group is created with this value.
    group = spec.group() if current is None else current
    return dataclasses.replace(group, **{attribute(path): value})


def _unknown_field(name: str, path: str, valid: Iterable[str]) -> InputError:
    suggestion = NameSuggestion(f"{name}.{path}", [f"{name}.{key}" for key in valid])
    return InputError("names.unknown", f"{name}.{path}", meaning="an address of this circuit", suggestion=suggestion)

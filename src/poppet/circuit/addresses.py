"""Change numbers by address: `tank.volume`, `valve.lower_spring.rate`, `ambient.pressure`, `run.duration`."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from typing import Any

from poppet.ground.errors import InputError, collect, prefixed, suggestion
from poppet.ground.provenance import Number, Source
from poppet.ground.units import quantity
from poppet.parts.fields import GroupSpec, MemberSpec, attribute, specs
from poppet.parts.part import Part


def replaced(owners: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """Frozen parts with some of their fields changed."""
    if not isinstance(values, Mapping):
        raise InputError(f"values = {values!r}", "do not name what to change.", 'Write {"tank.volume": "0.1 m^3"}.')
    result = dict(owners)
    by_owner: dict[str, dict[str, Any]] = {}
    problems: list[InputError] = []
    for address, value in values.items():
        name, _, path = address.partition(".")
        if name not in owners or not path:
            cure = _nearest_address(address, owners)
            problems.append(InputError(address, "is no address of this circuit.", cure, address=address))
        else:
            by_owner.setdefault(name, {})[path] = value
    for name, changes in by_owner.items():
        try:
            result[name] = _changed(owners[name], name, changes)
        except InputError as error:
            problems.append(error)
    collect(problems)
    return result


def _nearest_address(given: str, owners: Mapping[str, Any]) -> str:
    """A cure for what begins with no owner's name, or is nothing but one."""
    known = [f"{name}.{key}" for name, owner in owners.items() for key in specs(type(owner))]
    near = get_close_matches(given, known, n=3) or [
        address
        for word in (given, *get_close_matches(given, {address.partition(".")[2] for address in known}, n=1))
        for address in known
        if word in address.split(".")
    ]
    return f"Did you mean {' or '.join(near[:3])}?" if near else f"Begin with one of: {', '.join(owners)}."


def _changed(owner: Any, name: str, changes: Mapping[str, Any], told: Sequence[str] = ()) -> Any:
    """A part with changes of its fields, except those that the part around it tells it."""
    known = {key: spec for key, spec in specs(type(owner)).items() if key not in told}
    fields: dict[str, Any] = {}
    problems: list[InputError] = []
    for head, inner in _by_field(changes).items():
        try:
            if head in told:
                raise _told(name, head)
            if head in _inputs(owner):
                raise _no_number(f"{name}.{head}")
            if head not in known:
                path = next(f"{head}.{rest}" if rest else head for rest in inner)
                deeper = [key for key in getattr(owner, "numbers", dict)() if key.endswith(f".{path}")]
                raise _no_address(f"{name}.", path, deeper or known)
            fields[head] = _field(owner, name, head, inner)
        except InputError as error:
            problems.append(error)
    collect(problems)
    try:
        return dataclasses.replace(owner, **{attribute(key): value for key, value in fields.items()})
    except InputError as error:
        raise prefixed(error, f"{name}.") from None


def _by_field(changes: Mapping[str, Any]) -> dict[str, dict[str, Any]]:
    """Field to what is changed of it: the rest of the path to its value, an empty one for the field itself."""
    fields: dict[str, dict[str, Any]] = {}
    for path, value in changes.items():
        head, _, rest = path.partition(".")
        fields.setdefault(head, {})[rest] = value
    return fields


def _field(owner: Any, name: str, head: str, changes: Mapping[str, Any]) -> Any:
    """A field of a part after its changes, which belong together: one alone may contradict what others mend."""
    if "" in changes:
        if len(changes) > 1:
            given = f"{name}.{head}"
            raise InputError(given, "is changed as a whole and in part.", "Write all of it in one.", address=given)
        return changes[""]
    spec = specs(type(owner))[head]
    if isinstance(spec, MemberSpec):
        return _changed(getattr(owner, attribute(head)), f"{name}.{head}", changes, spec.told)
    result: Any = None
    problems: list[InputError] = []
    for rest, value in changes.items():
        try:
            result = _inner(owner, result, name, head, rest, value)
        except InputError as error:
            problems.append(error)
    collect(problems)
    return result


def _inputs(owner: Any) -> set[str]:
    """Inputs of a part that are no numbers as well: signals drive them, and nothing else."""
    if not isinstance(owner, Part):
        return set()
    return {item.name for item in owner.inputs()} - set(specs(type(owner)))


def _no_number(address: str) -> InputError:
    cure = f'Write it under [signals]: "{address}" = ...'
    return InputError(address, "is an input without a number of its own.", cure, address=address)


def _told(name: str, field: str) -> InputError:
    """The mistake of a change of what the part around a member decides."""
    whole, given = name.rpartition(".")[0], f"{name}.{field}"
    return InputError(given, f"is decided by {whole}.", f"Change the fields of {whole} itself.", address=given)


def _inner(owner: Any, begun: Any, name: str, head: str, rest: str, value: Any) -> Any:
    """The group or characteristic `head` of a part with one of its numbers changed."""
    current = begun if begun is not None else getattr(owner, attribute(head))
    if hasattr(current, "with_numbers"):
        numbers = current.numbers()
        if rest not in numbers:
            raise _no_address(f"{name}.{head}.", rest, numbers)
        given = value if isinstance(value, Number) else _like(f"{name}.{head}.{rest}", numbers[rest], value)
        return current.with_numbers({rest: given})
    spec = specs(type(owner))[head]
    known = specs(spec.group) if isinstance(spec, GroupSpec) else {}
    if not isinstance(spec, GroupSpec) or rest not in known:
        raise _no_address(f"{name}.{head}.", rest, known)
    # A group that was left out begins with the number that is set.
    group = spec.group() if current is None else current
    return dataclasses.replace(group, **{attribute(rest): value})


def _no_address(start: str, given: str, known: Iterable[str]) -> InputError:
    cure = suggestion(start + given, [start + name for name in known])
    return InputError(start + given, "is no address of this circuit.", cure, address=start + given)


def _like(address: str, number: Number, value: Any) -> Number:
    read = quantity(value, number.unit, name=address)
    return Number(read.value, number.unit, Source("given"), read.reference, value if isinstance(value, str) else "")

"""Change numbers by address: `tank.volume`, `valve.lower_spring.rate`, `ambient.pressure`, `run.duration`."""

from __future__ import annotations

import dataclasses
from collections.abc import Mapping
from difflib import get_close_matches
from typing import Any

from poppet.errors import InputError, collect, prefixed, suggestion
from poppet.parts.fields import GroupSpec, MemberSpec, attribute, specs
from poppet.provenance import Number, Source
from poppet.units import quantity


def replaced(owners: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """Frozen parts with some of their fields changed.

    Parameters
    ----------
    owners : mapping
        Name to part (or ambient, gas, run).
    values : mapping
        Address to new value.

    Returns
    -------
    dict
        Name to part, the changed ones made anew and checked.

    Raises
    ------
    InputErrors
        With every unknown address and impossible value.
    """
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


def _changed(owner: Any, name: str, changes: Mapping[str, Any]) -> Any:
    known = specs(type(owner))
    fields: dict[str, Any] = {}
    problems: list[InputError] = []
    for path, value in changes.items():
        head, _, rest = path.partition(".")
        if head not in known:
            problems.append(_no_address(f"{name}.", path, known))
            continue
        try:
            fields[head] = _inner(owner, fields.get(head), name, head, rest, value) if rest else value
        except InputError as error:
            problems.append(error)
    collect(problems)
    try:
        return dataclasses.replace(owner, **{attribute(key): value for key, value in fields.items()})
    except InputError as error:
        raise prefixed(error, f"{name}.") from None


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
    if isinstance(spec, MemberSpec):
        return _changed(current, f"{name}.{head}", {rest: value})
    known = specs(spec.group) if isinstance(spec, GroupSpec) else {}
    if not isinstance(spec, GroupSpec) or rest not in known:
        raise _no_address(f"{name}.{head}.", rest, known)
    # A group that was left out begins with the number that is set.
    group = spec.group() if current is None else current
    return dataclasses.replace(group, **{attribute(rest): value})


def _no_address(start: str, given: str, known: Mapping[str, Any]) -> InputError:
    cure = suggestion(start + given, [start + name for name in known])
    return InputError(start + given, "is no address of this circuit.", cure, address=start + given)


def _like(address: str, number: Number, value: Any) -> Number:
    read = quantity(value, number.unit, name=address)
    return Number(read.value, number.unit, Source("given"), read.reference, value if isinstance(value, str) else "")

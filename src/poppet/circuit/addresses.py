"""Change numbers by address: `tank.volume`, `valve.lower_spring.rate`, `ambient.pressure`, `run.duration`."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from difflib import get_close_matches
from typing import Any

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.provenance import Number, Source
from poppet.core.units import quantity
from poppet.parts.fields import GroupSpec, MemberSpec, Spec, attribute, specs
from poppet.parts.part import Part


def replaced(owners: Mapping[str, Any], values: Mapping[str, Any]) -> dict[str, Any]:
    """Frozen parts with some of their fields changed."""
    if not isinstance(values, Mapping):
        raise InputError("address.no_mapping", values=values)
    result = dict(owners)
    by_owner: dict[str, dict[str, Any]] = {}
    with ErrorCollector() as errors:
        for address, value in values.items():
            name, _, path = address.partition(".") if isinstance(address, str) else (address, "", "")
            if name not in owners or not path:
                errors.extend([_nowhere(address, owners)])
            else:
                by_owner.setdefault(name, {})[path] = value
        # All changes of a part at once: two that only fit together must not meet the old value of each other.
        for name, changes in by_owner.items():
            with errors.collecting():
                result[name] = _changed(owners[name], name, changes)
    return result


def _nowhere(given: Any, owners: Mapping[str, Any]) -> InputError:
    """The mistake of what begins with no owner's name, or is nothing but one."""
    known = [f"{name}.{key}" for name, owner in owners.items() for key in specs(type(owner))]
    # First what is nearly right, then the addresses of which one word was written.
    given = str(given)
    near = get_close_matches(given, known, n=3) or [
        address
        for word in (given, *get_close_matches(given, {address.partition(".")[2] for address in known}, n=1))
        for address in known
        if word in address.split(".")
    ]
    if near:
        return InputError("address.meant", given, names=near[:3])
    return InputError("address.no_owner", given, owners=[*owners])


def _changed(owner: Any, name: str, changes: Mapping[str, Any], told: Sequence[str] = ()) -> Any:
    """A part with changes of its fields, except those that the part around it tells it."""
    by_field: dict[str, dict[str, Any]] = {}
    for path, value in changes.items():
        head, _, rest = path.partition(".")
        by_field.setdefault(head, {})[rest] = value
    fields = {}
    with ErrorCollector() as errors:
        for head, inner in by_field.items():
            with errors.collecting():
                _check_field(owner, name, head, inner, told)
                # Read here and not in the constructor, so that mistakes of several fields are told together.
                fields[attribute(head)] = _field(owner, name, head, inner)
    try:
        return dataclasses.replace(owner, **fields)
    except InputError as error:
        raise error.within(name) from None


def _check_field(owner: Any, name: str, head: str, changes: Mapping[str, Any], told: Sequence[str]) -> None:
    if head in told:
        raise InputError("address.told", f"{name}.{head}", whole=name.rpartition(".")[0])
    known = [key for key in specs(type(owner)) if key not in told]
    # Inputs that are no numbers as well: signals drive them, and nothing else.
    if isinstance(owner, Part) and head not in known and head in {item.name for item in owner.inputs()}:
        raise InputError("address.is_input", f"{name}.{head}")
    if head not in known:
        # Where a number inside a group was meant, its group is left out as often as its name is misspelt.
        path = next(f"{head}.{rest}" if rest else head for rest in changes)
        deeper = [key for key in getattr(owner, "numbers", dict)() if key.endswith(f".{path}")]
        raise _unknown(name, path, deeper or known)


def _field(owner: Any, name: str, head: str, changes: Mapping[str, Any]) -> Any:
    """A field of a part after its changes, which belong together: one alone may contradict what others mend."""
    if "" in changes:
        if len(changes) > 1:
            raise InputError("address.whole_and_part", f"{name}.{head}")
        return changes[""]
    spec, current = specs(type(owner))[head], getattr(owner, attribute(head))
    if isinstance(spec, MemberSpec):
        return _changed(current, f"{name}.{head}", changes, spec.inherited)
    with ErrorCollector() as errors:
        for path, value in changes.items():
            with errors.collecting():
                current = _with_inner(current, spec, f"{name}.{head}", path, value)
    return current


def _with_inner(current: Any, spec: Spec, name: str, path: str, value: Any) -> Any:
    """A group or characteristic with one of its numbers changed."""
    if hasattr(current, "with_numbers"):
        numbers = current.numbers()
        if path not in numbers:
            raise _unknown(name, path, numbers)
        if not isinstance(value, Number):
            unit, text = numbers[path].unit, value if isinstance(value, str) else ""
            read = quantity(value, unit, name=f"{name}.{path}")
            # What was typed stays with the number: it is shown as it was written.
            value = Number(read.value, unit, Source("given"), read.reference, text)
        return current.with_numbers({path: value})
    known = specs(spec.group) if isinstance(spec, GroupSpec) else {}
    if not isinstance(spec, GroupSpec) or path not in known:
        raise _unknown(name, path, known)
    # A group that was left out begins with the number that is set.
    group = spec.group() if current is None else current
    return dataclasses.replace(group, **{attribute(path): value})


def _unknown(name: str, path: str, known: Iterable[str]) -> InputError:
    near = NameSuggestion(f"{name}.{path}", [f"{name}.{key}" for key in known])
    return InputError("address.unknown", f"{name}.{path}", near=near)

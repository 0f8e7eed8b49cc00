"""Compounds: parts that consist of other parts (members) with dotted names."""

from __future__ import annotations

import dataclasses
from collections.abc import Hashable, Iterable, Mapping
from contextlib import suppress
from typing import Any, ClassVar

from poppet import library
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, raise_errors
from poppet.core.provenance import Number
from poppet.core.symbolic import SymbolicValueError
from poppet.parts.fields import (
    MemberSpec,
    NumberSpec,
    PortSpec,
    ReferenceSpec,
    attribute,
    complete,
    specs,
    unknown_field,
)
from poppet.parts.part import Body, Input, Part, State, Surroundings

MIN_MISSING = 4
"""Count of missing numbers above which a missing library set is reported instead."""


class Compound(Part):
    """Part that consists of connected member parts, and has no equations itself.

    A subclass declares its members with `fields.member`, the fields that it sets in them (`inherited_fields`), their
    connections (`links`), and the names of its inputs (`inlets`) and outputs (`outlets`). A subclass whose members
    depend on its numbers, such as a tube with a number of cells, overrides `members`, `stores`, `outside` and
    `numbers`.
    """

    links: ClassVar[Mapping[str, str]] = {}
    """Mapping from inputs of members to the outputs that drive them, such as `pilot.pressure`."""
    inlets: ClassVar[Mapping[str, str]] = {}
    """Mapping from outer names of inputs to the inputs of members."""
    outlets: ClassVar[Mapping[str, str]] = {}
    """Mapping from outer names of outputs to the outputs of members, in the order of recordings."""

    def inherited_fields(self, member: str) -> dict[str, Any]:
        """Return the field values that the compound sets in the member with a given name.

        Examples are the ports, and the name of a published parameter set.
        """
        return {}

    def __post_init__(self) -> None:
        errors, has_numbers = ErrorCollector(), False
        with errors.collecting():
            numbers = self.component_numbers()
            has_numbers = True
            complete(self, numbers)
        for name, spec in self._member_specs():
            if spec.optional and not self.has(name):
                if getattr(self, attribute(name)) is not None:
                    errors.add("parts.no_such_member", name, meaning=spec.meaning, options=self.options())
                continue
            with errors.collecting(name):
                object.__setattr__(self, attribute(name), self._member(name, spec))
        # An invalid value that several members inherit is one error of the compound.
        inherited = [(f"{name}.{key}", key) for name, spec in self._member_specs() for key in spec.inherited]
        for problem in [*errors.collected]:
            address = problem.address or ""
            key = next((key for whole, key in inherited if f"{address}.".startswith(f"{whole}.")), None)
            if key is None or problem.code == "fields.unknown":
                continue
            problem.address, problem.place = address[address.index(key) :], ""
            # The compound computes other inherited values from its fields, which are reported if they are missing.
            if problem.code == "fields.missing" and key not in specs(type(self)):
                errors.collected.remove(problem)
        problems = list({(problem.code, problem.address): problem for problem in errors.collected}.values())
        if not has_numbers:  # a valid model states numbers that are missing now
            problems = [problem for problem in problems if problem.code != "fields.missing"]
        missing = [p for p in problems if p.code == "fields.missing" and "." in (p.address or "")]
        if getattr(self, "data", "") is None and len(missing) >= MIN_MISSING:
            # Without a library set, all missing numbers are one error.
            addresses = [p.address for p in missing[:2]]
            example = library.complete_sets(*(spec.part.kind for _, spec in self._member_specs()))[0]
            error = InputError("parts.forgotten_set", "data", count=len(missing), first=addresses, set=example)
            problems = [error, *(p for p in problems if p not in missing)]
        raise_errors(problems)
        # A symbol in place of a number has no value to check.
        with suppress(SymbolicValueError):
            self.check()

    def _member_specs(self) -> Iterable[tuple[str, MemberSpec]]:
        return ((name, spec) for name, spec in specs(type(self)).items() if isinstance(spec, MemberSpec))

    def _member(self, name: str, spec: MemberSpec) -> Part:
        argument, member_specs = getattr(self, attribute(name)), specs(spec.part)
        inherited = self.inherited_fields(name)
        assert set(inherited) == set(spec.inherited), name
        # The compound has reported its missing ports already.
        required = [key for key, field in member_specs.items() if isinstance(field, PortSpec) and not field.optional]
        inherited |= {key: name for key in required if key in inherited and inherited[key] is None}
        if isinstance(argument, Part):
            # The ports of a copy of the compound can differ: its members inherit them again.
            member: Part = dataclasses.replace(argument, **inherited)  # type: ignore[type-var]
            return member
        if argument is not None and not isinstance(argument, Mapping):
            raise InputError("fields.not_a_table", name, value=argument, meaning=spec.meaning, fields=[*member_specs])
        valid = {key: field for key, field in member_specs.items() if key not in inherited}
        fields = {attribute(key): value for key, value in (argument or {}).items() if key in valid}
        with ErrorCollector() as errors:
            errors.extend(unknown_field(key, key, valid) for key in argument or () if key not in valid)
            return spec.part(**fields, **inherited)  # type: ignore[no-any-return]

    @property
    def members(self) -> dict[str, Part]:
        """Mapping from the name of each member to the member part.

        The order is that of declaration. Optional members that are absent are not included.
        """
        parts = {name: getattr(self, attribute(name)) for name, _ in self._member_specs()}
        return {name: part for name, part in parts.items() if part is not None}

    def has(self, member: str) -> bool:
        """Return True if the compound has the optional member whose name is `member`."""
        return True

    def outside(self) -> dict[str, str]:
        """Return a mapping from names of inputs and outputs of the compound to names in its members.

        For example, `setpoint` is mapped to `electronics.setpoint`. The inputs come first.
        """
        names = {**self.inlets, **self.outlets}
        return {name: inner for name, inner in names.items() if inner.partition(".")[0] in self.members}

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        ranges = {}
        for name, inner in self.outside().items():
            member, _, local = inner.partition(".")
            member_ranges = self.members[member].output_ranges()
            if local in member_ranges:
                low, high = (
                    end if isinstance(end, float) else f"{'-' * end.startswith('-')}{member}.{end.removeprefix('-')}"
                    for end in member_ranges[local]
                )
                ranges[name] = low, high
        return ranges

    def stores(self) -> tuple[str, ...]:
        return tuple(name for name, spec in self._member_specs() if spec.is_open and name in self.members)

    def inner_bodies(self) -> tuple[str, ...]:
        return tuple(name for name, part in self.members.items() if isinstance(part, Body))

    def numbers(self) -> dict[str, Number]:
        numbers = super().numbers()
        inherited = {f"{name}.{key}" for name, spec in self._member_specs() for key in spec.inherited}
        for name, part in self.members.items():
            numbers |= {f"{name}.{key}": number for key, number in part.numbers().items()}
        # Inherited numbers have an address in the compound only.
        groups = tuple(f"{address}." for address in inherited)
        return {key: number for key, number in numbers.items() if key not in inherited and not key.startswith(groups)}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values: dict[str, float] = {}
        for name, part in self.members.items():
            try:
                member_values = part.parameters(ambient)
            except InputError as error:
                raise error.within(name) from None
            values |= {f"{name}.{key}": value for key, value in member_values.items()}
        return values

    def notes(self) -> tuple[Note, ...]:
        return tuple(note.within(name) for name, part in self.members.items() for note in part.notes())

    def structure(self) -> Hashable:
        return super().structure(), tuple((name, part.structure()) for name, part in self.members.items())

    def states(self) -> tuple[State, ...]:
        """Return the states of all members.

        Each name begins with the name of the member.
        """
        states = ((name, state) for name, part in self.members.items() for state in part.states())
        return tuple(dataclasses.replace(state, name=f"{name}.{state.name}") for name, state in states)

    def inputs(self) -> tuple[Input, ...]:
        """Return the inputs of the compound, which signals and outputs of other parts can drive.

        Their names are the keys of `inlets`.
        """
        inputs = []
        for outer, inner in self.outside().items():
            if outer not in self.inlets:
                continue
            name, _, local = inner.partition(".")
            item = next(item for item in self.members[name].inputs() if item.name == local)
            # Names of parameters of the member have its name in front outside.
            values = {key: getattr(item, key) for key in ("default", "low", "high", "delay")}
            names = {key: value for key, value in values.items() if isinstance(value, str) and value}
            addresses: dict[str, Any] = {key: f"{name}.{value}" for key, value in names.items()}
            inputs.append(dataclasses.replace(item, name=outer, **addresses))
        return tuple(inputs)

    def can_resume(self, target: str) -> bool:
        name, _, local = target.partition(".")
        return name in self.members and self.members[name].can_resume(local)

    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        outer_names = {inner: name for name, inner in self.outside().items() if name in self.outlets}
        domains = {f"{n}.{key}": curve for n, part in self.members.items() for key, curve in part.domains().items()}
        return {outer_names.get(key, key): curve for key, curve in domains.items()}


def number_spec(part: Part, path: str) -> NumberSpec:
    """Return the declaration (unit, limits, default) of a number of a part.

    `path` is the dotted name of the number, such as `pilot.fill.frequency`. The number can be a field of the part, of a
    group or of a member.
    """
    kind: Any = type(part)
    *heads, last = path.split(".")
    for head in heads:
        spec: Any = specs(kind)[head]
        if isinstance(spec, ReferenceSpec):  # it checks its values
            return NumberSpec("1", spec.doc)
        kind = spec.part if isinstance(spec, MemberSpec) else spec.group
    spec = specs(kind)[last]
    assert isinstance(spec, NumberSpec)
    return spec


def expand_compounds(
    parts: Mapping[str, Part], connections: Mapping[str, str]
) -> tuple[dict[str, Part], dict[str, str], dict[str, str]]:
    """Replace each compound part of a circuit by its members.

    The result contains all parts that are not compounds, all connections between them, and a mapping from the addresses
    of outputs of members to the addresses under which the compounds publish them.
    """
    flat: dict[str, Part] = {}
    flat_connections: dict[str, str] = {}
    outer: dict[str, str] = {}
    inner: dict[str, str] = {}
    for name, part in parts.items():
        if not isinstance(part, Compound):
            flat[name] = part
            continue
        flat |= {f"{name}.{key}": member for key, member in part.members.items()}
        flat_connections |= {f"{name}.{target}": f"{name}.{source}" for target, source in part.links.items()}
        for outer_name, inner_name in part.outside().items():
            inner[f"{name}.{outer_name}"] = f"{name}.{inner_name}"
            # An output with several names outside has the first one in recordings.
            outer.setdefault(f"{name}.{inner_name}", f"{name}.{outer_name}")
    flat_connections |= {inner.get(target, target): inner.get(source, source) for target, source in connections.items()}
    return flat, flat_connections, outer

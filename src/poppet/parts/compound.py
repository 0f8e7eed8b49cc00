"""Parts that are made of parts: their members are traced as parts of their own, under dotted names."""

from __future__ import annotations

import dataclasses
from collections.abc import Hashable, Iterable, Mapping
from typing import Any, ClassVar

from poppet import library
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, collect
from poppet.core.provenance import Number
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
from poppet.parts.part import Input, Part, State, Surroundings

SEVERAL = 4
"""Missing numbers from which on a forgotten library set is what is meant."""


class Compound(Part):
    """A part that joins others to one: wiring, and no equation of its own.

    A subclass declares its members with `fields.member`, and says what each of them is told by the whole (`inherited`),
    which of their inputs take which of their outputs (`links`), and how inputs and outputs are called outside. Where
    the members follow from its numbers it makes them itself (`members`, `stores`, `outside`, `numbers`).
    """

    links: ClassVar[Mapping[str, str]] = {}
    """Input of a member to the output of a member that it takes: `main_stage.pilot_pressure` to `pilot.pressure`."""
    inlets: ClassVar[Mapping[str, str]] = {}
    """Name of an input outside to the member's input."""
    outlets: ClassVar[Mapping[str, str]] = {}
    """Name of an output outside, in the order of the output, to the member's output."""

    def inherited_fields(self, member: str) -> dict[str, Any]:
        """Fields of a member that follow from the whole: its ports, its library set."""
        return {}

    def __post_init__(self) -> None:
        errors = ErrorCollector()
        with errors.collecting():
            complete(self, {})
        for name, spec in self._member_specs():
            if spec.optional and not self.has(name):
                if getattr(self, attribute(name)) is not None:
                    errors.add("parts.no_such_member", name, meaning=spec.doc, options=self.options())
                continue
            with errors.collecting(name):
                object.__setattr__(self, attribute(name), self._member(name, spec))
        # What the whole tells its members wrongly is one mistake, of the whole.
        told = {f"{name}.{key}": key for name, spec in self._member_specs() for key in spec.inherited}
        for problem in errors.collected:
            if problem.address in told and problem.code != "fields.unknown":
                problem.address, problem.place = told[problem.address], ""
        own = {(problem.code, problem.address): problem for problem in errors.collected}
        collect(self._without_set(list(own.values())))
        self.check()

    def _without_set(self, problems: list[InputError]) -> list[InputError]:
        """Mistakes with all numbers that a forgotten library set leaves missing told as one."""
        missing = [p for p in problems if p.code == "fields.missing" and "." in (p.address or "")]
        if getattr(self, "data", "") is not None or len(missing) < SEVERAL:
            return problems
        first, known = (
            [p.address for p in missing[:2]],
            library.complete_sets(*(spec.part.kind for _, spec in self._member_specs()))[0],
        )
        told = InputError("parts.forgotten_set", "data", count=len(missing), first=first, set=known)
        return [told, *(p for p in problems if p not in missing)]

    def _member_specs(self) -> Iterable[tuple[str, MemberSpec]]:
        return ((name, spec) for name, spec in specs(type(self)).items() if isinstance(spec, MemberSpec))

    def _member(self, name: str, spec: MemberSpec) -> Part:
        given, known = getattr(self, attribute(name)), specs(spec.part)
        told = self.inherited_fields(name)
        assert set(told) == set(spec.inherited), name
        # A missing port is a mistake of the whole, which has been told already.
        needed = [key for key, each in known.items() if isinstance(each, PortSpec) and not each.optional]
        told |= {key: name for key in needed if key in told and told[key] is None}
        if isinstance(given, Part):
            # A copy of the whole brings its members along: they are told anew, for its ports may be others now.
            again: Part = dataclasses.replace(given, **told)  # type: ignore[type-var]
            return again
        if given is not None and not isinstance(given, Mapping):
            raise InputError("fields.not_a_table", name, value=given, meaning=spec.doc, fields=[*known])
        free = {key: s for key, s in known.items() if key not in told}
        fields = {attribute(key): value for key, value in (given or {}).items() if key in free}
        with ErrorCollector() as errors:
            errors.extend(unknown_field(key, key, free) for key in given or () if key not in free)
            made: Part = spec.part(**fields, **told)
        return made

    @property
    def members(self) -> dict[str, Part]:
        """Name to part, in the order of declaration; without those that this form of the whole does not have."""
        made = {name: getattr(self, attribute(name)) for name, _ in self._member_specs()}
        return {name: part for name, part in made.items() if part is not None}

    def has(self, member: str) -> bool:
        """Whether this form of the whole has an optional member."""
        return True

    def outside(self) -> dict[str, str]:
        """Names outside of inputs, then of outputs, to the names inside."""
        every = {**self.inlets, **self.outlets}
        return {name: inside for name, inside in every.items() if inside.partition(".")[0] in self.members}

    def stores(self) -> tuple[str, ...]:
        return tuple(name for name, spec in self._member_specs() if spec.is_open and name in self.members)

    def numbers(self) -> dict[str, Number]:
        found = super().numbers()
        told = {f"{name}.{key}" for name, spec in self._member_specs() for key in spec.inherited}
        for name, part in self.members.items():
            found |= {f"{name}.{key}": number for key, number in part.numbers().items()}
        # What the whole tells its members stands with the whole.
        groups = tuple(f"{address}." for address in told)
        return {key: number for key, number in found.items() if key not in told and not key.startswith(groups)}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        values: dict[str, float] = {}
        for name, part in self.members.items():
            try:
                own = part.parameters(ambient)
            except InputError as error:
                raise error.within(name) from None
            values |= {f"{name}.{key}": value for key, value in own.items()}
        return values

    def notes(self) -> tuple[Note, ...]:
        return tuple(note.within(name) for name, part in self.members.items() for note in part.notes())

    def structure(self) -> Hashable:
        return super().structure(), tuple((name, part.structure()) for name, part in self.members.items())

    def states(self) -> tuple[State, ...]:
        """States of the members, under dotted names."""
        return tuple(
            dataclasses.replace(state, name=f"{name}.{state.name}")
            for name, part in self.members.items()
            for state in part.states()
        )

    def inputs(self) -> tuple[Input, ...]:
        """Inputs that are seen outside, under the names of `inlets`."""
        found = []
        for outside, inside in self.outside().items():
            if outside not in self.inlets:
                continue
            name, _, local = inside.partition(".")
            item = next(item for item in self.members[name].inputs() if item.name == local)
            # Defaults and limits may name numbers of the member, which outside have its name in front.
            named = {key: getattr(item, key) for key in ("default", "low", "high", "delay")}
            within: dict[str, Any] = {
                key: f"{name}.{each}" for key, each in named.items() if isinstance(each, str) and each
            }
            found.append(dataclasses.replace(item, name=outside, **within))
        return tuple(found)

    def can_resume(self, target: str) -> bool:
        name, _, local = target.partition(".")
        return name in self.members and self.members[name].can_resume(local)

    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        outside = {inside: name for name, inside in self.outside().items() if name in self.outlets}
        return {
            outside.get(f"{name}.{key}", f"{name}.{key}"): curve
            for name, part in self.members.items()
            for key, curve in part.domains().items()
        }


def number_spec(part: Part, path: str) -> NumberSpec:
    """Declaration of a number of a part, a group or a member by its dotted name."""
    kind: Any = type(part)
    *heads, last = path.split(".")
    for head in heads:
        spec: Any = specs(kind)[head]
        if isinstance(spec, ReferenceSpec):  # it has limits of its own
            return NumberSpec("1", spec.doc)
        kind = spec.part if isinstance(spec, MemberSpec) else spec.group
    spec = specs(kind)[last]
    assert isinstance(spec, NumberSpec)
    return spec


def expanded(
    parts: Mapping[str, Part], connections: Mapping[str, str]
) -> tuple[dict[str, Part], dict[str, str], dict[str, str]]:
    """The elementary parts of a circuit."""
    flat: dict[str, Part] = {}
    joined: dict[str, str] = {}
    shown: dict[str, str] = {}
    inner: dict[str, str] = {}
    for name, part in parts.items():
        if not isinstance(part, Compound):
            flat[name] = part
            continue
        flat |= {f"{name}.{member}": made for member, made in part.members.items()}
        joined |= {f"{name}.{target}": f"{name}.{source}" for target, source in part.links.items()}
        for outside, inside in part.outside().items():
            inner[f"{name}.{outside}"] = f"{name}.{inside}"
            # One output may have several names outside; it is shown under the first.
            shown.setdefault(f"{name}.{inside}", f"{name}.{outside}")
    joined |= {inner.get(target, target): inner.get(source, source) for target, source in connections.items()}
    return flat, joined, shown

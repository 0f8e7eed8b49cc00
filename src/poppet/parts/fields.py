"""How a part declares what can be written about it: numbers, options, ports and groups of numbers.

One declaration serves the Python constructor, the circuit file, `--set`, the JSON schema and the passport of a circuit.
A part is a frozen dataclass; `complete` turns what was given into `Number`s and reports all mistakes at once.
"""

from __future__ import annotations

import dataclasses
from collections.abc import Callable, Mapping, Sequence
from copy import copy
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cache
from types import MappingProxyType
from typing import Any, TypeVar

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, UnitError
from poppet.core.provenance import SOURCE_KINDS, Number, Source, SourceKind
from poppet.core.tables import NumberRange
from poppet.core.units import Kind, quantity

Made = TypeVar("Made")
MISSING = (
    "fields.missing",
    "fields.missing_port",
    "fields.missing_body",
    "parts.no_characteristic",
    "parts.forgotten_set",
)
"""Mistakes of what was not given, or was given under another name."""
NumberLike = Number | float | str | Mapping[str, Any] | None
"""What a number field takes: SI value, text with unit, `Number`, or a table with value, source, locator, note."""


@dataclass(frozen=True)
class NumberSpec(NumberRange):
    """Declaration of a number: unit, limits, default and meaning."""

    unit: str
    doc: str
    kind: Kind = "plain"
    default: str | float | None = None
    source: SourceKind = "assumed"
    note: str = ""
    optional: bool = False
    varies: Callable[[Any], Mapping[str, Any]] | None = None  # changes of the declaration under the choices of a part

    def within(self, part: Any) -> NumberSpec:
        """Return the declaration that is valid for a part with its choices."""
        return self if self.varies is None else _varied(self, tuple(self.varies(part).items()))

    def check(self, name: str, value: float, shown: str) -> None:
        """Raise `OutOfRangeError` if a value is outside the limits."""
        self.check_range(name, value, shown, self.doc)


@cache
def _varied(spec: NumberSpec, changes: tuple[tuple[str, Any], ...]) -> NumberSpec:
    return dataclasses.replace(spec, varies=None, **dict(changes))


@dataclass(frozen=True)
class OptionSpec:
    """A choice between named forms; changing it changes the model, not only a number."""

    choices: tuple[str, ...]
    doc: str


@dataclass(frozen=True)
class PortSpec:
    """The name of the store that a port is joined to."""

    doc: str
    optional: bool = False


@dataclass(frozen=True)
class BodySpec:
    """The name of the body that an actuator moves."""

    doc: str
    optional: bool = False


@dataclass(frozen=True)
class GroupSpec:
    """Numbers that belong together and are addressed with one more dot, `lower_spring.rate`."""

    group: type
    doc: str
    optional: bool = False


@dataclass(frozen=True)
class ReferenceSpec:
    """The name of a library set, or a table that describes the same thing."""

    doc: str


@dataclass(frozen=True)
class MemberSpec:
    """A part inside a part; the whole tells it some of its fields."""

    part: Any  # class of the part
    doc: str
    inherited: tuple[str, ...]
    is_open: bool = False  # ports outside may be joined to it
    optional: bool = False  # the whole may be without it


Spec = NumberSpec | OptionSpec | PortSpec | BodySpec | GroupSpec | ReferenceSpec | MemberSpec


def number(
    unit: str, default: str | float | None = None, *, doc: str, source: SourceKind = "assumed", note: str = "",
    **limits: Any,
) -> Any:  # fmt: skip
    """Declare a number; without a default it must be given, unless `optional=True`."""
    assert source in SOURCE_KINDS
    return _field(NumberSpec(unit, doc, default=default, source=source, note=note or "default", **limits))


def anr_temperature(doc: str) -> Any:
    """Declare a temperature that is 20 degC unless it is given."""
    return number("K", "20 degC", doc=doc, kind="temperature", above=0.0, source="standard", note="ISO 8778, ANR")


def anr_pressure(doc: str) -> Any:
    """Declare a pressure that is 1 bar, absolute, unless it is given."""
    return number("Pa", "1 bar", doc=doc, kind="pressure", above=0.0, source="standard", note="ISO 8778, ANR")


def subsonic_index_m(source: SourceKind = "standard", note: str = "ISO 6358:1989, the ellipse") -> Any:
    """Declare the exponent of the subsonic law."""
    return number("1", 0.5, doc="subsonic index m", above=0.0, high=2.0, source=source, note=note)


def laminar_limit() -> Any:
    """Declare the pressure ratio above which the flow law is regularised."""
    doc = "laminar ratio, where the regularisation begins"
    return number("1", 0.999, low=0.5, below=1.0, doc=doc, note="width of the C1 zone")


def option(default: str, *choices: str, doc: str) -> Any:
    """Declare a choice; the first argument is the default."""
    return _field(OptionSpec((default, *choices), doc), default)


OFF_ON = ("false", "true")
"""Choices of a switch, for which a circuit file has words of its own."""


def switch(*, doc: str) -> Any:
    """Declare a choice between false, the default, and true; kept as text, as every choice is."""
    return option(*OFF_ON, doc=doc)


def port(doc: str, *, optional: bool = False) -> Any:
    """Declare a port."""
    return _field(PortSpec(doc, optional))


def body(doc: str) -> Any:
    """Declare the body that an actuator moves."""
    return _field(BodySpec(doc))


def group(kind: type, *, doc: str, optional: bool = False) -> Any:
    """Declare a group of numbers."""
    return _field(GroupSpec(kind, doc, optional))


def member(kind: type, *, doc: str, inherited: Sequence[str], is_open: bool = False, optional: bool = False) -> Any:
    """Declare a part inside a part; `inherited` are the fields that the whole fills in."""
    return _field(MemberSpec(kind, doc, tuple(inherited), is_open, optional))


def reference(*, doc: str) -> Any:
    """Declare a reference to the library."""
    return _field(ReferenceSpec(doc))


def _field(spec: Spec, default: str | None = None) -> Any:
    # A required number defaults to None as well, so that a missing one is reported together with all other mistakes.
    return dataclasses.field(default=default, metadata={"spec": spec})


def specs(kind: Any) -> Mapping[str, Spec]:
    """What can be written about a part, by the name used in a circuit file (`from`, not `from_`)."""
    # A function of its own, because type checkers do not take a class for something that a cache can hash.
    return _specs(kind)


@cache
def _specs(kind: Any) -> Mapping[str, Spec]:
    found = {f.name.rstrip("_"): f.metadata["spec"] for f in dataclasses.fields(kind) if "spec" in f.metadata}
    return MappingProxyType(found)


@cache
def declared(kind: Any, *wanted: type) -> tuple[tuple[str, str, Any], ...]:
    """Name, Python attribute and declaration of the fields of a class, of all or of those of some kinds."""
    # A changed number builds its part anew and a run reads every part: what the class alone decides is decided once.
    return tuple((n, attribute(n), spec) for n, spec in _specs(kind).items() if not wanted or isinstance(spec, wanted))


def attribute(name: str) -> str:
    """The Python attribute of a field name: `from` is a keyword and becomes `from_`."""
    return "from_" if name == "from" else name


def read_number(name: str, spec: NumberSpec, given: NumberLike) -> Number:
    """Make a checked `Number` of what was given."""
    # A part that is copied brings its numbers as they stand: they need no reading, and no text for a mistake.
    if type(given) is Number and given.unit == spec.unit and given.reference != "gauge" and spec.holds(given.value):
        return given
    source = Source("given")
    if isinstance(given, Mapping):
        unknown = [key for key in given if key not in ("value", "source", "locator", "note")]
        if unknown or "value" not in given:
            first = unknown[0] if unknown else ""
            raise InputError("fields.source_form", name, value=dict(given), unknown=first, empty=not unknown)
        kind = str(given.get("source", "given"))
        if kind not in SOURCE_KINDS:
            raise InputError("fields.source_kind", name, value=kind, near=NameSuggestion(kind, SOURCE_KINDS))
        source = Source(kind, str(given.get("locator", "")), str(given.get("note", "")))
        given = given["value"]
    if isinstance(given, Number):
        result = given
        if given.unit != spec.unit:
            raise InputError("fields.other_unit", name, shown=given.display(), unit=spec.unit)
        if given.reference == "gauge" and spec.kind != "pressure":
            raise UnitError("fields.gauge_difference", name, shown=given.display())
    else:
        try:
            read = quantity(given, spec.unit, kind=spec.kind, name=name, is_told=True)  # type: ignore[arg-type]
        except InputError as error:
            raise error.located(address=name) from None
        result = Number(read.value, spec.unit, source, read.reference, given if isinstance(given, str) else "")
    # Limits are absolute: a gauge pressure waits until the ambient pressure is known (`Part.parameters`).
    if result.reference != "gauge" and not spec.holds(result.value):
        spec.check(name, result.value, result.display())
    return result


def forget(part: Any, sets: Sequence[Mapping[str, Number]], path: str = "") -> None:
    """Take out what a copy of a part carries over from a library set: it follows the set that is named now."""
    if not sets:
        return
    for name, own, spec in declared(part.__class__, NumberSpec, GroupSpec):
        value = getattr(part, own)
        if isinstance(value, Number):
            address = f"{path}{name}"
            # `in` asks for identity first: most numbers are the library's own, and comparing their texts costs more.
            if value in [known.get(address) for known in sets]:
                object.__setattr__(part, own, None)
        elif isinstance(spec, GroupSpec) and isinstance(value, spec.group):
            # The group may be shared with the part that was copied.
            inner: Any = copy(value)
            forget(inner, sets, f"{path}{name}.")
            object.__setattr__(part, own, inner)


# Read once: parts that say nothing of a number share its default, which also makes `forget` quick.
@cache
def default_number(name: str, spec: NumberSpec) -> Number | None:
    """The declared default with its source, or None."""
    if spec.default is None:
        return None
    return dataclasses.replace(read_number(name, spec, spec.default), source=Source(spec.source, note=spec.note))


def from_table(kind: type[Made], table: Any) -> Made:
    """What a class of declared fields describes, made of a table of a file; all mistakes of the table at once."""
    if not isinstance(table, Mapping):
        raise InputError("fields.no_table", value=table)
    known, made = specs(kind), None
    unknown = [key for key in table if key not in known]
    with ErrorCollector() as errors:
        errors.extend(unknown_field(key, key, known) for key in unknown)
        try:
            made = kind(**{attribute(key): value for key, value in table.items() if key in known})
        except InputError as error:
            errors.extend(problem for problem in error.problems if not _is_misspelt(problem, unknown))
    assert made is not None
    return made


def _is_misspelt(problem: InputError, unknown: Sequence[str]) -> bool:
    """True for a missing field that was given under a name much like it: one mistake, not two."""
    name = (problem.address or "").rpartition(".")[2]
    return problem.code in MISSING and bool(get_close_matches(name, unknown, n=1))


def complete(part: Any, library: Mapping[str, Number]) -> None:
    """Read every field of a frozen part in place: given value, else library value, else default, else a mistake."""
    with ErrorCollector() as errors:
        _complete(part, library, "", errors, part)


def _complete(part: Any, library: Mapping[str, Number], path: str, errors: ErrorCollector, whole: Any) -> None:
    for name, own, spec in declared(part.__class__):
        given, address = getattr(part, own), f"{path}{name}"
        try:
            value = _completed(given, spec, address, library, errors, whole)
        except InputError as error:
            errors.extend([error.located(address=address)])
            continue
        if value is not given:
            object.__setattr__(part, own, value)


def _completed(
    given: Any, spec: Spec, address: str, library: Mapping[str, Number], errors: ErrorCollector, whole: Any
) -> Any:
    match spec:
        case NumberSpec():
            spec = spec.within(whole)
            if given is not None:
                return read_number(address, spec, given)
            value = library.get(address) or default_number(address, spec)
            if value is None and not spec.optional:
                unit = "" if spec.unit == "1" else spec.unit
                raise InputError("fields.missing", address, meaning=spec.doc, unit=unit, plain=not unit, example="")
            return value
        case GroupSpec():
            return _completed_group(given, spec, address, library, errors, whole)
        case OptionSpec():
            if isinstance(given, bool) and spec.choices == OFF_ON:
                return OFF_ON[given]
            if given not in spec.choices:
                near = NameSuggestion(str(given), spec.choices)
                raise InputError("fields.not_an_option", address, value=given, meaning=spec.doc, near=near)
        case PortSpec() | BodySpec():
            if given is None and not spec.optional:
                code = "fields.missing_port" if isinstance(spec, PortSpec) else "fields.missing_body"
                raise InputError(code, address, meaning=spec.doc)
            if given is not None and not isinstance(given, str):
                raise InputError("fields.not_a_name", address, value=given)
    return given


def _completed_group(
    given: Any, spec: GroupSpec, address: str, library: Mapping[str, Number], errors: ErrorCollector, whole: Any
) -> Any:
    known = specs(spec.group)
    if given is None and spec.optional and not any(key.startswith(f"{address}.") for key in library):
        return None
    if isinstance(given, Mapping):
        errors.extend(unknown_field(f"{address}.{key}", key, known) for key in given if key not in known)
        given = spec.group(**{attribute(key): value for key, value in given.items() if key in known})
    elif given is None:
        given = spec.group()
    elif not isinstance(given, spec.group):
        raise InputError("fields.not_a_table", address, value=given, meaning=spec.doc, fields=[*known])
    result = copy(given)
    _complete(result, library, f"{address}.", errors, whole)
    return result


def unknown_field(address: str, name: str, known: Mapping[str, Any]) -> InputError:
    """The mistake of a field that a part does not have."""
    return InputError("fields.unknown", address, table="", near=NameSuggestion(name, known))


def flatten(part: Any, path: str = "", whole: Any = None) -> list[tuple[str, NumberSpec, Number]]:
    """All numbers of a completed part, or of a group of it, with their dotted names."""
    whole = part if whole is None else whole
    found: list[tuple[str, NumberSpec, Number]] = []
    for name, own, spec in declared(part.__class__, NumberSpec, GroupSpec, MemberSpec):
        value = getattr(part, own)
        if value is None:
            continue
        if type(spec) is NumberSpec:
            found.append((path + name, spec.within(whole), value))
        else:
            found += flatten(value, f"{path}{name}.", None if type(spec) is MemberSpec else whole)
    return found

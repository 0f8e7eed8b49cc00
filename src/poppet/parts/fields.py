"""Declarations of the fields of parts: numbers, options, ports, bodies, groups, members and references.

One declaration serves the Python constructor, its docstring, the circuit file, `--set`, the JSON schema and `poppet
show`. A part is a frozen dataclass; `complete` reads the arguments of its fields and reports all errors together.
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
from poppet.core.provenance import SOURCE_KINDS, ComponentSource, Number, Source, SourceKind
from poppet.core.symbolic import is_symbolic
from poppet.core.tables import NumberRange
from poppet.core.units import Kind, quantity

T = TypeVar("T")
MISSING = (
    "fields.missing", "fields.missing_port", "fields.missing_body", "parts.no_characteristic", "parts.forgotten_set",
)  # fmt: skip
"""Codes of errors of a missing or misspelt field."""
NumberLike = Number | float | str | Mapping[str, Any] | None
"""Argument of a number field: SI value, text with unit, `Number`, or a table with value, source, locator and note."""


@dataclass(frozen=True)
class Declaration:
    """Base class of the declaration of one field of a part.

    `doc` contains the meaning of the field as a noun phrase. Details can follow after a semicolon.
    """

    doc: str
    optional: bool = dataclasses.field(default=False, kw_only=True)

    @property
    def meaning(self) -> str:
        """Meaning of the field as a noun phrase, which messages and labels contain.

        It is the part of `doc` before the first semicolon.
        """
        return self.doc.partition("; ")[0]

    def is_final(self, argument: Any, library: Mapping[str, Number]) -> bool:
        """Return True if an argument is evidently the final value of the field; this makes copies of parts fast."""
        return False


@dataclass(frozen=True)
class NumberSpec(Declaration, NumberRange):
    """Declaration of a field with a number: unit, limits, default and meaning."""

    unit: str
    kind: Kind = "plain"
    default: str | float | None = None
    source: SourceKind = "assumed"
    note: str = ""
    varies: Callable[[Any], Mapping[str, Any]] | None = None  # changes of the declaration under the choices of a part

    def within(self, part: Any) -> NumberSpec:
        """Return the declaration that is valid for the present options of a part.

        For example, the unit of a controller gain depends on the controlled quantity.
        """
        changes = None if self.varies is None else self.varies(part)
        return _changed_spec(self, tuple(changes.items())) if changes else self

    def check(self, name: str, value: float, text: str) -> None:
        """Raise `OutOfRangeError` if a value is outside the declared limits.

        `name` is the name of the field, and `text` the value as the user wrote it.
        """
        self.check_range(name, value, text, self.meaning)

    def is_final(self, argument: Any, library: Mapping[str, Number]) -> bool:
        return argument is None and self.optional and self.default is None and self.varies is None and not library


@cache
def _changed_spec(spec: NumberSpec, changes: tuple[tuple[str, Any], ...]) -> NumberSpec:
    """Return a declaration with changed properties; cached, because each copy of a part requests it."""
    return dataclasses.replace(spec, varies=None, **dict(changes))


@dataclass(frozen=True)
class OptionSpec(Declaration):
    """Declaration of an option, a field whose value is one of several words.

    The choice determines the equations of the part.
    """

    choices: tuple[str, ...]

    def is_final(self, argument: Any, library: Mapping[str, Number]) -> bool:
        return type(argument) is str and argument in self.choices


class PortSpec(Declaration):
    """Declaration of a field that names the gas node connected to a port."""

    def is_final(self, argument: Any, library: Mapping[str, Number]) -> bool:
        return type(argument) is str


class BodySpec(Declaration):
    """Declaration of a field that names the body on which an actuator acts."""


@dataclass(frozen=True)
class GroupSpec(Declaration):
    """Declaration of a field that contains a group of numbers.

    Their addresses begin with the name of the group, such as `lower_spring.rate`. `group` is the class of the group.
    """

    group: type


@dataclass(frozen=True)
class ReferenceSpec(Declaration):
    """Declaration of a field that contains a name from the parameter library, or a table of values.

    `form` is the type of the argument in docstrings.
    """

    form: str = "str or mapping"

    def is_final(self, argument: Any, library: Mapping[str, Number]) -> bool:
        return True


@dataclass(frozen=True)
class MemberSpec(Declaration):
    """Declaration of a member, which is a part within a compound part.

    `inherited` contains the names of the fields of the member that the compound sets. If `optional` is True, a compound
    can lack this member.
    """

    part: Any  # class of the part
    inherited: tuple[str, ...]
    is_open: bool = False  # ports of other parts can be connected to it


Spec = NumberSpec | OptionSpec | PortSpec | BodySpec | GroupSpec | ReferenceSpec | MemberSpec


def number(
    unit: str, default: str | float | None = None, *, doc: str, source: SourceKind = "assumed", note: str = "",
    **limits: Any,
) -> NumberLike:  # fmt: skip
    """Declare a field that is a number with the SI unit `unit`.

    The number is required if `default` is None and `optional` is not set. The keyword arguments are further properties
    of `NumberSpec`, such as limits.
    """
    assert source in SOURCE_KINDS
    return _field(NumberSpec(unit, doc, default=default, source=source, note=note or "default", **limits), None)


def anr_temperature(doc: str) -> NumberLike:
    """Declare a field for a temperature whose default is 20 degC."""
    return number("K", "20 degC", doc=doc, kind="temperature", above=0.0, source="standard", note="ISO 8778, ANR")


def anr_pressure(doc: str) -> NumberLike:
    """Declare a field for a pressure whose default is 1 bar absolute."""
    return number("Pa", "1 bar", doc=doc, kind="pressure", above=0.0, source="standard", note="ISO 8778, ANR")


def subsonic_index_m(source: SourceKind = "standard", note: str = "ISO 6358:1989, the ellipse") -> NumberLike:
    """Declare the field for the exponent m of the subsonic flow law, with the default 0.5."""
    return number("1", 0.5, doc="subsonic index m", above=0.0, high=2.0, source=source, note=note)


def laminar_limit() -> NumberLike:
    """Declare the field for the pressure ratio p2/p1 above which the flow law is regularised."""
    doc = "laminar ratio; pressure ratio p2/p1 above which the flow law is regularised"
    return number("1", 0.999, low=0.5, below=1.0, doc=doc, note="width of the C1 zone")


class DefaultWord(str):
    """Word of an option that is not specified; `complete` replaces it by an ordinary text."""

    __slots__ = ()


def option(default: str, *choices: str, doc: str) -> str:
    """Declare a field whose value is one of several words.

    `default` is the default, and the further arguments are the other valid words. The keyword `doc` is the meaning of
    the field.
    """
    return _field(OptionSpec(doc, (default, *choices)), DefaultWord(default))


OFF_ON = ("false", "true")
"""Choices of a switch; a circuit file has booleans for them."""


def switch(*, doc: str) -> str:
    """Declare an option whose choices are the words `false` (default) and `true`.

    A boolean in a circuit file is converted to the word.
    """
    return option(*OFF_ON, doc=doc)


def port(doc: str, *, optional: bool = False) -> str | None:
    """Declare a field that names the gas node to which a port is connected."""
    return _field(PortSpec(doc, optional=optional), None)


def body(doc: str) -> str | None:
    """Declare a field that names the body on which an actuator acts."""
    return _field(BodySpec(doc), None)


def group(kind: type, *, doc: str, optional: bool = False) -> Any:
    """Declare a field that contains a group of numbers, an object of the class `kind`."""
    return _field(GroupSpec(doc, kind, optional=optional), None)


def member(kind: type, *, doc: str, inherited: Sequence[str], is_open: bool = False, optional: bool = False) -> Any:
    """Declare a field of a compound part that contains one of its member parts.

    `kind` is the class of the member. The keyword `inherited` contains the names of the fields of the member that the
    compound sets.
    """
    return _field(MemberSpec(doc, kind, tuple(inherited), is_open, optional=optional), None)


def reference(*, doc: str, form: str = "str or mapping") -> Any:
    """Declare a field that contains a name from the parameter library, or a table of values.

    `form` is the type of the argument in docstrings.
    """
    return _field(ReferenceSpec(doc, form), None)


def model() -> Any:
    """Declare the field for a component by catalogue number, which states the other fields."""
    return reference(doc='component; manufacturer and model, such as "SMC SY5000"', form="str or CatalogueComponent")


def _field(spec: Spec, default: T) -> T:
    # A required number defaults to None too, so that a missing number is reported together with all other errors.
    return dataclasses.field(default=default, metadata={"spec": spec})


def specs(kind: Any) -> Mapping[str, Spec]:
    """Return the declarations of all fields of the part class `kind` by field name.

    The names are the same as in a circuit file: `from`, not the Python attribute `from_`.
    """
    # A separate function: type checkers do not accept a class as an argument of a cached function.
    return _specs(kind)


@cache
def _specs(kind: Any) -> Mapping[str, Spec]:
    declared_fields = (field for field in dataclasses.fields(kind) if "spec" in field.metadata)
    return MappingProxyType({field.name.rstrip("_"): field.metadata["spec"] for field in declared_fields})


@cache
def declared(kind: Any, *types: type) -> tuple[tuple[str, str, Any], ...]:
    """Return the fields of a part class `kind`.

    Each item contains the name, the Python attribute and the declaration of a field. Each argument in `types` is a
    class of declarations, such as `NumberSpec`. If `types` is not empty, only fields with declarations of these classes
    are included.
    """
    # Cached: a changed number makes its part again, and a run reads every part.
    return tuple((n, attribute(n), spec) for n, spec in _specs(kind).items() if not types or isinstance(spec, types))


def attribute(name: str) -> str:
    """Return the name of the Python attribute that contains the field `name`.

    Both names are equal, except for names of which Python or the class `Part` has another use: the attribute of `from`
    is `from_`.
    """
    return f"{name}_" if name in _OTHER_USE else name


_OTHER_USE = ("from", "inputs", "start")
"""Names of fields that are Python keywords or methods of parts."""


class ParameterDocstring:
    """Docstring of a part class, extended by the section "Parameters".

    The section is generated from the declarations of the fields when the docstring is read.
    """

    def __init__(self, text: str) -> None:
        self.text = text

    def __get__(self, instance: Any, owner: type) -> str:
        # The decorator of dataclasses reads the docstring before it sets this attribute: no time for it on import.
        return _with_parameters(owner, self.text) if "__match_args__" in vars(owner) else self.text


@cache
def _with_parameters(owner: Any, text: str) -> str:
    import inspect

    lines = ["Parameters", "----------"]
    arguments = inspect.signature(owner).parameters
    for name, attribute_name, spec in declared(owner):
        # The meaning with the unit of a number, or the names of the fields of a group.
        unit = f" [{spec.unit}]" if isinstance(spec, NumberSpec) and spec.unit != "1" else ""
        meaning = f"{spec.meaning[:1].upper()}{spec.meaning[1:]}{unit}{spec.doc.removeprefix(spec.meaning)}"
        if isinstance(spec, GroupSpec):
            meaning += f": {', '.join(specs(spec.group))}"
        elif isinstance(spec, MemberSpec):
            meaning += f": {', '.join(name for name in specs(spec.part) if name not in spec.inherited)}"
        argument = name if name in arguments else attribute_name
        lines += [f"{argument} : {_type_text(spec)}", f"    {meaning}."]
    head, rule, rest = inspect.cleandoc(text).partition("\n-----")
    if len(lines) == 2:
        return head + rule + rest
    head, _, title = head.rpartition("\n") if rule else (head, "", "")
    return f"{head.rstrip()}\n\n" + "\n".join(lines) + (f"\n\n{title}{rule}{rest}" if rule else "\n")


def _type_text(spec: Any) -> str:
    """Return type and default of a parameter in the format of numpydoc."""
    match spec:
        case OptionSpec(choices=choices):
            values = ", ".join(choices if choices == OFF_ON else map(repr, choices))
            return f"{{{values}}}, default {values.partition(',')[0]}"
        case NumberSpec(default=default) if default is not None:
            is_bare = not isinstance(default, str) and default != 0.0 and spec.unit != "1"
            return f"number, default {default}{f' {spec.unit}' if is_bare else ''}"
        case ReferenceSpec():
            return f"{spec.form}, optional"
        case GroupSpec() | MemberSpec():
            return "mapping, optional" if spec.optional or isinstance(spec, MemberSpec) else "mapping"
    return ("number" if isinstance(spec, NumberSpec) else "str") + (", optional" if spec.optional else "")


def read_number(name: str, spec: NumberSpec, argument: NumberLike) -> Number:
    """Convert a user's value of a numeric field to a `Number`, and check it.

    `name` is the name of the field, and `spec` its declaration.
    """
    # A copied part has numbers that were read before.
    is_number = type(argument) is Number and argument.unit == spec.unit and argument.reference != "gauge"
    is_number = is_number and not is_symbolic(argument.value)  # type: ignore[union-attr]
    if is_number and spec.holds(argument.value):  # type: ignore[union-attr]
        return argument  # type: ignore[return-value]
    # The value of a symbol is not known, so it is not checked.
    if isinstance(argument, Number) and is_symbolic(argument.value):
        return argument
    argument, source = split_source(name, argument)
    if isinstance(argument, Number):
        result = argument
        if argument.unit != spec.unit:
            raise InputError("fields.other_unit", name, shown=argument.display(), unit=spec.unit)
        if argument.reference == "gauge" and spec.kind != "pressure":
            raise UnitError("fields.gauge_difference", name, shown=argument.display())
    else:
        try:
            parsed = quantity(argument, spec.unit, kind=spec.kind, name=name, is_told=True)  # type: ignore[arg-type]
        except InputError as error:
            raise error.located(address=name) from None
        text = argument if isinstance(argument, str) else ""
        result = Number(parsed.value, spec.unit, source, parsed.reference, text)
    # Limits are absolute: `Part.parameters` checks gauge values when the ambient pressure is known.
    if result.reference != "gauge" and not spec.holds(result.value):
        spec.check(name, result.value, result.display())
    return result


def split_source(name: str, argument: Any) -> tuple[Any, Source]:
    """Return the value of a user's argument, and its source.

    An argument with a source is a table with the field `value`. The source of other arguments is `given`. `name` is the
    name of the field.
    """
    if not isinstance(argument, Mapping):
        return argument, Source("given")
    unknown = [key for key in argument if key not in ("value", "source", "locator", "note")]
    if unknown or "value" not in argument:
        first = unknown[0] if unknown else ""
        raise InputError("fields.source_form", name, value=dict(argument), unknown=first, empty=not unknown)
    kind = str(argument.get("source", "given"))
    if kind not in SOURCE_KINDS:
        near = NameSuggestion(kind, SOURCE_KINDS)
        raise InputError(
            "fields.not_an_option", f"{name}.source", value=kind, meaning="kind of source", suggestion=near
        )
    return argument["value"], Source(kind, str(argument.get("locator", "")), str(argument.get("note", "")))


def forget_library(part: Any, sets: Sequence[Mapping[str, Number]], path: str = "") -> None:
    """Reset to None all numbers of a copied part that come from the parameter library.

    `sets` contains the numbers of all parameter sets for this kind of part. The selected parameter set then supplies
    new numbers. `path` is the prefix of the names in the sets.
    """
    if not sets:
        return
    for name, attribute_name, spec in declared(part.__class__, NumberSpec, GroupSpec):
        value = getattr(part, attribute_name)
        if isinstance(value, Number) and not is_symbolic(value.value):
            address = f"{path}{name}"
            # `in` compares identity first: most numbers are the same objects as in the library.
            if value in [numbers.get(address) for numbers in sets]:
                object.__setattr__(part, attribute_name, None)
        elif isinstance(spec, GroupSpec) and isinstance(value, spec.group):
            # The original of the copy can share the group.
            inner: Any = copy(value)
            forget_library(inner, sets, f"{path}{name}.")
            object.__setattr__(part, attribute_name, inner)


def forget_component(part: Any, stated: Mapping[str, Number]) -> None:
    """Reset to None all numbers of a copied part that a component states, so that the selected one applies.

    `stated` contains the numbers of the selected component. Defaults that they replace are reset as well.
    """
    for name, attribute_name, spec in declared(part.__class__, NumberSpec):
        value = getattr(part, attribute_name)
        if type(value) is not Number:
            continue
        source = value.source
        # Most parts have no component: the other tests are skipped.
        if not (isinstance(source, ComponentSource) or name in stated) or is_symbolic(value.value):
            continue
        if isinstance(source, ComponentSource):
            is_replaced = source.stated == value.value
        else:
            is_replaced = value == default_number(name, spec.within(part))
        if is_replaced:
            object.__setattr__(part, attribute_name, None)


# Cached: parts share the default of a number that they do not specify. This also makes `forget_library` fast.
@cache
def default_number(name: str, spec: NumberSpec) -> Number | None:
    """Return the declared default of a number, with its source.

    The result is None if there is no default.
    """
    if spec.default is None:
        return None
    return dataclasses.replace(read_number(name, spec, spec.default), source=Source(spec.source, note=spec.note))


def from_table(kind: type[T], table: Any) -> T:
    """Create an object of the class `kind` from a table of a TOML file.

    The keys of the table are the names of the fields. All errors are reported together.
    """
    if not isinstance(table, Mapping):
        raise InputError("fields.no_table", value=table)
    valid, result = specs(kind), None
    unknown = [key for key in table if key not in valid]
    with ErrorCollector() as errors:
        errors.extend(unknown_field(key, key, valid) for key in unknown)
        try:
            result = kind(**{attribute(key): value for key, value in table.items() if key in valid})
        except InputError as error:
            for problem in error.problems:
                # A missing field with a similar unknown name is one error, not two.
                name = (problem.address or "").rpartition(".")[2]
                if problem.code not in MISSING or not get_close_matches(name, unknown, n=1):
                    errors.extend([problem])
    assert result is not None
    return result


def complete(part: Any, library: Mapping[str, Number]) -> None:
    """Set all fields of a new part to their final values.

    A field whose argument is None gets the value from `library`, the numbers of the selected parameter set, or else its
    default. A required field without any of these values is an error. The function changes the part in place, although
    its class is frozen.
    """
    with ErrorCollector() as errors:
        _complete(part, library, "", errors, part)


def _complete(part: Any, library: Mapping[str, Number], path: str, errors: ErrorCollector, owner: Any) -> None:
    # The declarations of numbers depend on options, which can have any value until they are read.
    unread: dict[str, Any] = {}
    for _, attribute_name, spec in declared(part.__class__, OptionSpec):
        argument = getattr(part, attribute_name)
        if not isinstance(argument, str):
            unread[attribute_name] = argument
            is_switch = isinstance(argument, bool) and spec.choices == OFF_ON
            object.__setattr__(part, attribute_name, spec.choices[argument if is_switch else 0])
    for name, attribute_name, spec in declared(part.__class__):
        argument = unread.get(attribute_name, getattr(part, attribute_name))
        if spec.is_final(argument, library):
            continue
        address = f"{path}{name}"
        try:
            value = _read_field(argument, spec, address, library, errors, owner)
        except InputError as error:
            errors.extend([error.located(address=address)])
            continue
        if value is not argument:
            object.__setattr__(part, attribute_name, value)


def _read_field(
    argument: Any, spec: Spec, address: str, library: Mapping[str, Number], errors: ErrorCollector, owner: Any
) -> object:
    match spec:
        case NumberSpec():
            spec = spec.within(owner)
            if argument is not None:
                return read_number(address, spec, argument)
            value = library.get(address) or default_number(address, spec)
            if value is None and not spec.optional:
                unit = "" if spec.unit == "1" else spec.unit
                raise InputError("fields.missing", address, meaning=spec.meaning, unit=unit, plain=not unit, example="")
            return value
        case GroupSpec():
            valid = specs(spec.group)
            if argument is None and spec.optional and not any(key.startswith(f"{address}.") for key in library):
                return None
            if isinstance(argument, Mapping):
                errors.extend(unknown_field(f"{address}.{key}", key, valid) for key in argument if key not in valid)
                argument = spec.group(**{attribute(key): value for key, value in argument.items() if key in valid})
            elif argument is None:
                argument = spec.group()
            elif not isinstance(argument, spec.group):
                raise InputError("fields.not_a_table", address, value=argument, meaning=spec.meaning, fields=[*valid])
            result = copy(argument)
            _complete(result, library, f"{address}.", errors, owner)
            return result
        case OptionSpec():
            if isinstance(argument, bool) and spec.choices == OFF_ON:
                return OFF_ON[argument]
            if argument not in spec.choices:
                near = NameSuggestion(str(argument), spec.choices)
                raise InputError("fields.not_an_option", address, value=argument, meaning=spec.meaning, suggestion=near)
            return str(argument)
        case PortSpec() | BodySpec():
            if argument is None and not spec.optional:
                code = "fields.missing_port" if isinstance(spec, PortSpec) else "fields.missing_body"
                raise InputError(code, address, meaning=spec.meaning)
            if argument is not None and not isinstance(argument, str):
                raise InputError("fields.not_a_name", address, value=argument)
    return argument


def unknown_field(address: str, name: str, valid: Mapping[str, Any]) -> InputError:
    """Return the error for a field name that a part does not have.

    `address` is the address of the field, `name` its name, and `valid` contains the valid names.
    """
    return InputError("fields.unknown", address, table="", suggestion=NameSuggestion(name, valid))


def flatten(part: Any, path: str = "", owner: Any = None) -> list[tuple[str, NumberSpec, Number]]:
    """Return dotted name, declaration and value of each number of a part or of a group.

    `path` is the prefix of the names. `owner` is the part that contains the group; None if `part` is a part.
    """
    owner = part if owner is None else owner
    numbers: list[tuple[str, NumberSpec, Number]] = []
    for name, attribute_name, spec in declared(part.__class__, NumberSpec, GroupSpec, MemberSpec):
        value = getattr(part, attribute_name)
        if value is None:
            continue
        if type(spec) is NumberSpec:
            numbers.append((path + name, spec.within(owner), value))
        else:
            numbers += flatten(value, f"{path}{name}.", None if type(spec) is MemberSpec else owner)
    return numbers

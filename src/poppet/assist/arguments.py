"""Arguments of functions: their declaration in the signature, JSON schema and check."""

from __future__ import annotations

import inspect
import math
import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from copy import deepcopy
from dataclasses import dataclass, replace
from functools import cache
from typing import Annotated, Any, get_args, get_origin

from poppet.assist.limits import TEXT, TIMES
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.tables import Field, NumberRange, read_fields

ENTRY = 200
"""Largest number of characters of a text in a list."""
LARGEST = 1e30
"""Largest number in a table of values."""


@dataclass(frozen=True)
class Argument:
    """Meaning and limits of an argument, in the annotation of its type: `Annotated[int, Argument("...", low=1)]`.

    `choices` are the valid texts, `low` and `high` the limits of a number, and `longest` the largest number of
    characters or entries (default: 1 MiB for texts, 200 for lists and tables).
    """

    meaning: str
    choices: tuple[str, ...] = ()
    low: float = -math.inf
    high: float = math.inf
    longest: int = 0

    @property
    def noun(self) -> str:
        """First part of the meaning, for messages."""
        return re.split(r"[;:(]", self.meaning)[0].strip()


@dataclass(frozen=True)
class DeclaredArgument:
    """Argument of a function with its type and default."""

    name: str
    type: Any
    argument: Argument
    default: Any
    is_required: bool

    def schema(self) -> dict[str, Any]:
        """Return the JSON schema of the argument."""
        about = self.argument
        schema: dict[str, Any] = deepcopy(_SCHEMAS[self.type])
        if about.choices:
            target = schema["items"] if self.type == Sequence[str] else schema
            target["enum"] = list(about.choices)
        schema |= {"minimum": about.low} if math.isfinite(about.low) else {}
        schema |= {"maximum": about.high} if math.isfinite(about.high) else {}
        default = list(self.default) if isinstance(self.default, tuple) else self.default
        schema |= {"default": default} if default else {}
        return schema | {"description": about.meaning}

    def read(self, raw: Any) -> Any:
        """Check the value of the argument, and return it."""
        if self.type is str:
            return self._read_text(raw)
        if self.type is bool:
            self._check_type(raw, isinstance(raw, bool), "true or false")
            return raw
        if self.type in (int, float):
            return self._read_number(raw)
        if get_origin(self.type) is Mapping:
            self._check_type(raw, isinstance(raw, Mapping), "a table of names and values")
            self._check_length(len(raw), self.argument.longest or TIMES)
            return {str(key): _checked_value(f"{self.name}.{key}", value) for key, value in raw.items()}
        self._check_type(raw, isinstance(raw, list), "a list")
        self._check_length(len(raw), self.argument.longest or TIMES)
        (entry,), about = get_args(self.type), replace(self.argument, longest=ENTRY)
        with ErrorCollector() as errors:
            values = []
            for k, value in enumerate(raw):
                with errors.collecting():
                    values.append(replace(self, name=f"{self.name}[{k}]", type=entry, argument=about).read(value))
        return values

    def _read_text(self, raw: Any) -> str:
        self._check_type(raw, isinstance(raw, str), "text")
        text = str(raw)
        self._check_length(len(text), self.argument.longest or TEXT)
        check_text(text, self.name)
        choices = self.argument.choices
        if choices and text not in choices:
            suggestion = NameSuggestion(text[:100], choices)
            facts: dict[str, Any] = {"value": _short(text), "meaning": self.argument.noun, "suggestion": suggestion}
            raise InputError("fields.not_an_option", self.name, **facts)
        return text

    def _read_number(self, raw: Any) -> float:
        types = (int,) if self.type is int else (int, float)
        is_number = isinstance(raw, types) and not isinstance(raw, bool)
        is_number = is_number and not (isinstance(raw, float) and not math.isfinite(raw))
        self._check_type(raw, is_number, "an integer" if self.type is int else "a number")
        about = self.argument
        limits = NumberRange(unit="1", low=about.low, high=about.high)
        limits.check_range(self.name, raw, str(_short(str(raw))), about.noun)
        return raw if self.type is int else float(raw)

    def _check_type(self, raw: Any, is_valid: bool, expected: str) -> None:
        if not is_valid:
            facts: dict[str, Any] = {"value": _short(raw), "meaning": self.argument.noun, "expected": expected}
            raise InputError("fields.other_type", self.name, **facts)

    def _check_length(self, length: int, limit: int) -> None:
        if length > limit:
            raise InputError("assist.too_long", self.name, length=length, most=limit)


_SCHEMAS: dict[Any, dict[str, Any]] = {
    str: {"type": "string"},
    bool: {"type": "boolean"},
    int: {"type": "integer"},
    float: {"type": "number"},
    Sequence[str]: {"type": "array", "items": {"type": "string"}},
    Sequence[float]: {"type": "array", "items": {"type": "number"}},
    Mapping[str, str | float]: {"type": "object", "additionalProperties": {"type": ["string", "number", "boolean"]}},
    Mapping[str, str]: {"type": "object", "additionalProperties": {"type": "string"}},
}
"""JSON schemas of the types of arguments."""


@cache
def declared_arguments(function: Callable[..., Any]) -> tuple[DeclaredArgument, ...]:
    """Return the arguments of a function that have an `Argument` in their annotation."""
    return tuple(_declared(function))


def _declared(function: Callable[..., Any]) -> Iterator[DeclaredArgument]:
    for name, parameter in inspect.signature(function, eval_str=True).parameters.items():
        if get_origin(parameter.annotation) is Annotated:
            value_type, argument = get_args(parameter.annotation)
            is_required = parameter.default is inspect.Parameter.empty
            yield DeclaredArgument(name, value_type, argument, None if is_required else parameter.default, is_required)


def arguments_schema(function: Callable[..., Any]) -> dict[str, Any]:
    """Return the JSON schema of the arguments of a function.

    Examples
    --------
    >>> def wait(time: Annotated[float, Argument("duration [s]", low=0.0)] = 1.0) -> None: ...
    >>> arguments_schema(wait)["properties"]
    {'time': {'type': 'number', 'minimum': 0.0, 'default': 1.0, 'description': 'duration [s]'}}
    """
    arguments = declared_arguments(function)
    return {
        "type": "object",
        "properties": {argument.name: argument.schema() for argument in arguments},
        "required": [argument.name for argument in arguments if argument.is_required],
        "additionalProperties": False,
    }


def read_arguments(function: Callable[..., Any], raw: Any) -> dict[str, Any]:
    """Check the arguments of a call, and return them; all errors are reported together.

    An argument that is null counts as omitted.
    """
    arguments = {argument.name: argument for argument in declared_arguments(function)}
    if not isinstance(raw, Mapping | None):
        raise InputError("fields.no_table", "arguments", value=_short(raw))
    raw = {str(key): value for key, value in (raw or {}).items() if value is not None}
    with ErrorCollector() as errors:
        fields = {name: Field(is_required=a.is_required, meaning=a.argument.noun) for name, a in arguments.items()}
        values_by_name = read_fields(errors, raw, fields, table=f"call of {function.__name__}")
        values = {}
        for name, value in values_by_name.items():
            with errors.collecting():
                values[name] = arguments[name].read(value)
    return values


def check_text(text: str, name: str) -> None:
    """Raise an error if a text contains a null character or half of a surrogate pair."""
    try:
        text.encode("utf-8")
    except UnicodeEncodeError:
        raise InputError("assist.no_text", name) from None
    if "\0" in text:
        raise InputError("assist.no_text", name)


def _checked_value(name: str, value: Any) -> str | float | bool:
    """Check a value of a table: a text, a number, or true or false."""
    if isinstance(value, str):
        check_text(value, name)
        return value
    if isinstance(value, bool) or (isinstance(value, int | float) and abs(value) <= LARGEST):
        return value
    expected = "a text, a number, or true or false"
    raise InputError("fields.other_type", name, value=_short(value), meaning="value", expected=expected)


def _short(value: Any) -> Any:
    """Return a value for a message, without long content."""
    text = str(value)
    return value if len(text) <= 60 and isinstance(value, str | int | float | None) else f"{text[:60]}..."

"""Numbers and options of parts from the component that the field `model` selects."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import lru_cache
from types import MappingProxyType
from typing import Any

from poppet.core.errors import ErrorCollector, InputError
from poppet.core.provenance import ComponentSource, Number
from poppet.library.components import CatalogueComponent, find_variants
from poppet.parts.fields import (
    DefaultWord,
    NumberSpec,
    OptionSpec,
    PortSpec,
    attribute,
    declared,
    read_number,
    specs,
)

MODEL = "model"
"""Field of a part that selects a component."""


def select_component(part: Any) -> CatalogueComponent:
    """Return the component that the field `model` of a new part selects.

    The options of the part select one of several variants of a component. An option that is not specified gets the word
    of the component, if the component has only one.
    """
    model = part.model
    if isinstance(model, str):
        try:
            variants: Sequence[CatalogueComponent] = find_variants(model)
        except InputError as error:
            raise error.located(address=MODEL) from None
    else:
        variants = (model,) if isinstance(model, CatalogueComponent) else model
        if not (
            isinstance(variants, tuple) and variants and all(isinstance(item, CatalogueComponent) for item in variants)
        ):
            raise InputError("components.not_a_name", MODEL, value=model)
    name = model if isinstance(model, str) else variants[0].name
    fitting = [variant for variant in variants if part.kind in variant.kinds]
    if not fitting:
        kinds = [*dict.fromkeys(kind for variant in variants for kind in variant.kinds)]
        raise InputError("components.other_kind", MODEL, name=name, kind=part.kind, kinds=kinds)
    for option in dict.fromkeys(option for variant in fitting for option in variant.options):
        fitting = _with_option(part, option, fitting, name)
    component = fitting[0]
    for port, port_attribute, _ in declared(part.__class__, PortSpec):
        if component.ports and port not in component.ports and getattr(part, port_attribute) is not None:
            raise InputError("components.no_port", port, name=name, ports=[*component.ports])
    return component


def _with_option(part: Any, option: str, variants: list[CatalogueComponent], name: str) -> list[CatalogueComponent]:
    """Return the variants of a component that are valid with an option of a part; set the option if it is open."""
    spec, word = specs(type(part))[option], getattr(part, attribute(option))
    assert isinstance(spec, OptionSpec)
    words = [*dict.fromkeys(word for variant in variants for word in variant.options.get(option, spec.choices))]
    if word not in spec.choices:  # an error, which is reported with those of the other fields
        return variants
    if word not in words:
        if not isinstance(word, DefaultWord):
            raise InputError("components.other_option", option, name=name, word=word, words=words)
        if len(words) > 1:
            raise InputError("components.no_option", option, name=name, words=words)
        object.__setattr__(part, attribute(option), words[0])
        return variants
    return [variant for variant in variants if word in variant.options.get(option, spec.choices)]


def numbers_of(component: CatalogueComponent, kind: Any) -> Mapping[str, Number]:
    """Return the numbers of a component for a part class, by field.

    Fields of other kinds of parts are omitted.
    """
    # A separate function: type checkers do not accept a class as an argument of a cached function.
    return _numbers_of(component, kind)


# Cached: a changed number makes its part again.
@lru_cache(maxsize=1024)
def _numbers_of(component: CatalogueComponent, kind: Any) -> Mapping[str, Number]:
    valid, numbers = specs(kind), {}
    with ErrorCollector() as errors:
        for name, value in component.fields.items():
            spec = valid.get(name)
            if not isinstance(spec, NumberSpec):
                continue
            with errors.collecting():
                numbers[name] = _sourced(read_number(name, spec, value), component)
    return MappingProxyType(numbers)


def _sourced(number: Number, component: CatalogueComponent) -> Number:
    """Return a number of a component with its document as the source."""
    source = number.source
    note = "; ".join(filter(None, (source.note, *(f"doubt: {doubt}" for doubt in component.doubts))))
    stated = ComponentSource(
        "datasheet" if source.kind == "given" else source.kind,
        source.locator or component.locator,
        note,
        component.name,
        number.value,
        component.doubts,
    )
    return Number(number.value, number.unit, stated, number.reference, number.text)

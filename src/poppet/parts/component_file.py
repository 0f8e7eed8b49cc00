"""Component files, with all numbers and options checked against the declarations of parts."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.core.toml_file import TomlFile
from poppet.library.components import CatalogueComponent, read_component_file
from poppet.parts import KINDS
from poppet.parts.components import MODEL, numbers_of
from poppet.parts.fields import NumberSpec, OptionSpec, PortSpec, specs, unknown_field


def read_components(path: str | Path) -> tuple[CatalogueComponent, ...]:
    """Read the components of a file, and check the numbers and options against the declarations of parts.

    Parameters
    ----------
    path : str or Path
        TOML file with the components of one manufacturer.

    Returns
    -------
    tuple of CatalogueComponent
        Components in the order of the file.

    Raises
    ------
    InputError
        If the file is invalid. The error contains all errors of the file with their lines.
    """
    found = read_component_file(path)
    file = TomlFile.read(path)
    with file.errors() as errors:
        for component in found:
            with errors.collecting():
                _check(errors, component)
    return found


def _check(errors: ErrorCollector, component: CatalogueComponent) -> None:
    address = f"components.{component.key}"
    for kind in component.kinds:
        if kind not in KINDS or MODEL not in specs(KINDS[kind]):
            valid = [name for name in KINDS if MODEL in specs(KINDS[name])]
            near = NameSuggestion(kind, valid)
            facts: dict[str, Any] = {"value": kind, "meaning": "kind of part with a model", "suggestion": near}
            errors.add("fields.not_an_option", f"{address}.kinds", **facts)
            return
    declared_by_kind = [specs(KINDS[kind]) for kind in component.kinds]
    numbers = {name: spec for each in declared_by_kind for name, spec in each.items() if isinstance(spec, NumberSpec)}
    options = {name: spec for each in declared_by_kind for name, spec in each.items() if isinstance(spec, OptionSpec)}
    ports = {name for each in declared_by_kind for name, spec in each.items() if isinstance(spec, PortSpec)}
    errors.extend(unknown_field(f"{address}.fields.{n}", n, numbers) for n in component.fields if n not in numbers)
    errors.extend(unknown_field(f"{address}.options.{n}", n, options) for n in component.options if n not in options)
    errors.extend(
        unknown_field(f"{address}.ports", port, dict.fromkeys(ports)) for port in component.ports if port not in ports
    )
    for option, words in component.options.items():
        for word in words if option in options else ():
            if word not in options[option].choices:
                near = NameSuggestion(word, options[option].choices)
                facts = {"value": word, "meaning": options[option].meaning, "suggestion": near}
                errors.add("fields.not_an_option", f"{address}.options.{option}", **facts)
    for kind in component.kinds:
        with errors.collecting(f"{address}.fields"):
            numbers_of(component, KINDS[kind])

"""Component files of a circuit, which its list `components` names."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.core.errors import ErrorCollector, InputError

if TYPE_CHECKING:
    from poppet.library.components import CatalogueComponent


def read_circuit_components(paths: Any, folder: Path) -> tuple[CatalogueComponent, ...]:
    """Read the component files of a circuit.

    `paths` is the list of the paths, which are relative to `folder`. Two components of one name are an error, also if
    one of them is in the library.
    """
    if not isinstance(paths, Sequence) or isinstance(paths, str) or not all(isinstance(path, str) for path in paths):
        raise InputError("components.no_files", "components", value=paths)
    if not paths:
        return ()
    from poppet.library.components import check_names, components
    from poppet.parts.component_file import read_components

    found: list[CatalogueComponent] = []
    with ErrorCollector() as errors:
        for path in dict.fromkeys(paths):
            with errors.collecting():
                try:
                    found += read_components(folder / path)
                except InputError as error:
                    # Errors inside a component file have this file; a missing one is an error of the circuit file.
                    for problem in error.problems:
                        problem.address = problem.address if problem.file else "components"
                    raise
        check_names(errors, [*components(), *found])
    return tuple(found)


def own_component(name: str, components: Iterable[CatalogueComponent]) -> Any:
    """Return the components of the circuit with a name, or the name itself if it belongs to the library."""
    from poppet.library.components import variants_of

    return variants_of(name, components) or name


def with_own_components(values: Mapping[str, Any], tables: Mapping[str, Any], folder: Path) -> Mapping[str, Any]:
    """Return new values of a circuit in which the names of its own components are replaced by the components.

    `tables` and `folder` are those of the circuit file. The keys of `values` are addresses.
    """
    paths = tables.get("components", [])
    names = {a: value for a, value in values.items() if str(a).endswith(".model") and isinstance(value, str)}
    if not paths or not names:
        return values
    components = read_circuit_components(paths, folder)
    return {**values, **{address: own_component(name, components) for address, name in names.items()}}

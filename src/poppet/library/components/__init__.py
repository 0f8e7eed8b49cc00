"""Components by catalogue number: one TOML file per manufacturer, and files of users and plugins.

A component states numbers and options of a part, and where they come from. `poppet.parts.components` applies them.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cache, cached_property
from pathlib import Path
from types import MappingProxyType
from typing import Any

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.files import confined_to
from poppet.core.plugins import Registry
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile

__all__ = ["CatalogueComponent", "NominalFlow", "component_names", "components", "find_variants", "read_component_file"]

DATA = Path(__file__).with_name("data")
FILES: Registry[Path] = Registry(
    "poppet.components",
    {name: DATA / f"{name}.toml" for name in ("aventics", "camozzi", "ckd", "festo", "smc")},
    lambda name, value: isinstance(value, Path),
)
"""Component files by manufacturer. A file is read when a component of this manufacturer is requested."""

_FILE = {
    "manufacturer": Field(type="string", is_required=True, example='manufacturer = "SMC"', meaning="manufacturer"),
    "documents": Field(type="table", default={}, meaning="documents by name"),
    "components": Field(type="table", is_required=True, example='[components."SY5000"]', meaning="components"),
}
_DOCUMENT = {
    "title": Field(
        type="string", is_required=True, example='title = "data sheet 123"', meaning="title of the document"
    ),
    "year": Field(type="text", default="", meaning="year or date of the document"),
    "copy": Field(type="string", default="", meaning="kind of copy that was read"),
}
_COMPONENT = {
    "model": Field(type="string", meaning="catalogue number"),
    "aliases": Field(default=[], meaning="other names of the component"),
    "series": Field(type="string", default="", meaning="series"),
    "kinds": Field(is_required=True, example='kinds = ["check_valve"]', meaning="kinds of parts"),
    "options": Field(type="table", default={}, meaning="valid words of options"),
    "ports": Field(default=[], meaning="ports that the component has"),
    "fields": Field(
        type="table", is_required=True, example='fields = { bore = "32 mm" }', meaning="numbers of the part"
    ),
    "flow": Field(type="table", default={}, meaning="printed nominal flow"),
    "printed": Field(type="table", default={}, meaning="further printed facts"),
    "document": Field(type="string", is_required=True, example='document = "data sheet 123"', meaning="document"),
    "page": Field(type="text", default="", meaning="page of the document"),
    "doubts": Field(default=[], meaning="reasons why numbers are uncertain"),
    "remarks": Field(default=[], meaning="remarks"),
}
_FLOW = {
    "value": Field(unit="m^3/s ANR", kind="volume_flow_anr", above=0.0, is_required=True, meaning="nominal flow"),
    "inlet_pressure": Field(unit="Pa", kind="pressure", above=0.0, is_required=True, meaning="inlet pressure"),
    "outlet_pressure": Field(unit="Pa", kind="pressure", above=0.0, is_required=True, meaning="outlet pressure"),
}
ATMOSPHERE = 101325.0
"""Ambient pressure that converts gauge pressures of a nominal flow to absolute pressures [Pa]."""


@dataclass(frozen=True)
class NominalFlow:
    """Flow of air that a document states, and the pressures at which it applies.

    Parameters
    ----------
    value : float
        Flow [m^3/s ANR].
    inlet_pressure, outlet_pressure : float
        Absolute pressures [Pa].
    texts : mapping of str
        The three values as written in the file.
    """

    value: float
    inlet_pressure: float
    outlet_pressure: float
    texts: Mapping[str, str]


@dataclass(frozen=True, eq=False)
class CatalogueComponent:
    """Component of a manufacturer: numbers of a part with their document.

    Parameters
    ----------
    manufacturer, model : str
        Name of the component: `model = "SMC SY5000"`.
    kinds : tuple of str
        Kinds of parts that can represent the component.
    fields : mapping
        Numbers of the part by field: values with units, or tables with `value`, `source` and `note`.
    document, year, copy, page : str
        Source of the numbers. `copy` is the kind of copy that was read, for example a scan or a transcription.
    series : str, optional
        Series of the component.
    aliases : tuple of str, optional
        Other models with the same numbers, or other names.
    options : mapping of str to tuple of str, optional
        Words of options with which the numbers are valid, for example functions of a valve.
    ports : tuple of str, optional
        Ports of the component; empty if all ports of the part can be connected.
    flow : NominalFlow, optional
        Nominal flow in the document.
    printed : mapping, optional
        Further facts in the document, which no field of a part contains.
    doubts, remarks : tuple of str, optional
        Reasons why the numbers are uncertain, and other remarks.
    key, path : str, optional
        Table of the component in its file, and the path of this file.
    """

    manufacturer: str
    model: str
    kinds: tuple[str, ...]
    fields: Mapping[str, Any]
    document: str
    year: str = ""
    copy: str = ""
    page: str = ""
    series: str = ""
    aliases: tuple[str, ...] = ()
    options: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    ports: tuple[str, ...] = ()
    flow: NominalFlow | None = None
    printed: Mapping[str, Any] = field(default_factory=dict)
    doubts: tuple[str, ...] = ()
    remarks: tuple[str, ...] = ()
    key: str = ""
    path: str = ""

    @property
    def name(self) -> str:
        """Manufacturer and model."""
        return f"{self.manufacturer} {self.model}"

    @cached_property
    def names(self) -> tuple[str, ...]:
        """All names of the component with its manufacturer."""
        return self.name, *(f"{self.manufacturer} {alias}" for alias in self.aliases)

    @property
    def place(self) -> str:
        """Document, date and page."""
        page = f"page {self.page}" if self.page[:1].isdigit() else self.page
        return ", ".join(filter(None, (self.document, self.year, page)))

    @property
    def locator(self) -> str:
        """Component, document, date and page, as the source of its numbers."""
        return f"{self.name}: {self.place}"

    def __str__(self) -> str:
        return self.name


def read_component_file(path: str | Path) -> tuple[CatalogueComponent, ...]:
    """Read the components of a file.

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
        If the file is invalid. The error contains all errors of the file with their lines. The values of `fields` are
        checked by `poppet.parts.component_file.read_components`.
    """
    file = TomlFile.read(path, "components")
    with file.errors() as errors:
        head = read_fields(errors, file.content, _FILE, table="component file")
        manufacturer, tables = head.get("manufacturer", ""), head.get("components", {})
        documents = {
            key: read_fields(errors, table, _DOCUMENT, f"documents.{key}", table="document")
            for key, table in head.get("documents", {}).items()
        }
        found = []
        for key, table in tables.items():
            component = _component(errors, f"components.{key}", key, table, manufacturer, documents, file.name)
            found += [] if component is None else [component]
        check_names(errors, found)
    return tuple(found)


def _component(
    errors: ErrorCollector,
    address: str,
    key: str,
    table: Any,
    manufacturer: str,
    documents: Mapping[str, Mapping[str, str]],
    path: str,
) -> CatalogueComponent | None:
    """Return the component of one table, or None if required fields are missing."""
    values = read_fields(errors, table, _COMPONENT, address, table="component")
    has_no_kind = values.get("kinds") == []
    lists: dict[str, Any] = {
        name: _texts(errors, values.pop(name, []), f"{address}.{name}")
        for name in ("aliases", "kinds", "ports", "doubts", "remarks")
    }
    options = {
        name: _texts(errors, words, f"{address}.options.{name}") for name, words in values.pop("options", {}).items()
    }
    flow = _nominal_flow(errors, values.pop("flow", {}), f"{address}.flow")
    if has_no_kind:
        errors.add("components.no_texts", f"{address}.kinds", value=[])
    if not {"fields", "document"} <= values.keys() or not lists["kinds"]:
        return None
    title = values.pop("document")
    document = documents.get(title, {"title": title})
    origin = {name: document.get(name, "") for name in ("year", "copy")}
    # A document without a title is an error.
    origin["document"] = document.get("title", title)
    model = values.pop("model", key)
    return CatalogueComponent(
        manufacturer, model, options=options, flow=flow, key=key, path=path, **lists, **origin, **values
    )


def _nominal_flow(errors: ErrorCollector, table: Any, address: str) -> NominalFlow | None:
    """Return a printed flow with its pressures, or None if the table is empty or invalid."""
    if not table:
        return None
    numbers = read_fields(errors, table, _FLOW, address, table="nominal flow", ambient_pressure=ATMOSPHERE)
    if len(numbers) < len(_FLOW):
        return None
    if numbers["outlet_pressure"] >= numbers["inlet_pressure"]:
        texts = {name: str(table[f"{name}_pressure"]) for name in ("inlet", "outlet")}
        errors.add("components.no_pressure_drop", f"{address}.outlet_pressure", **texts)
    return NominalFlow(**numbers, texts={name: str(table[name]) for name in _FLOW})


def _texts(errors: ErrorCollector, value: Any, address: str) -> tuple[str, ...]:
    """Return a list of texts; a single text is a list with one member."""
    members = [value] if isinstance(value, str) else value
    if isinstance(members, Sequence) and all(isinstance(text, str) and text for text in members):
        return tuple(members)
    errors.add("components.no_texts", address, value=value)
    return ()


def check_names(errors: ErrorCollector, found: Iterable[CatalogueComponent]) -> None:
    """Collect an error for each pair of components with the same name, a common kind and the same options."""
    by_name: dict[str, list[CatalogueComponent]] = {}
    for component in found:
        for name in component.names:
            for other in by_name.setdefault(_key(name), []):
                if _overlap(component, other):
                    files = sorted({component.path, other.path})
                    address = f"components.{component.model}"
                    errors.add("components.same_name", address, name=name, files=files, count=len(files))
            by_name[_key(name)].append(component)


def _overlap(first: CatalogueComponent, second: CatalogueComponent) -> bool:
    """Return True if a part could be either of two components with one name."""
    common = set(first.options) & set(second.options)
    has_common_words = all(set(first.options[name]) & set(second.options[name]) for name in common)
    return bool(set(first.kinds) & set(second.kinds)) and has_common_words


def find_variants(name: str, others: Iterable[CatalogueComponent] = ()) -> tuple[CatalogueComponent, ...]:
    """Return the components with a name, one for each variant such as a function of a valve.

    Parameters
    ----------
    name : str
        Manufacturer and model. Case and repeated blanks have no effect.
    others : iterable of CatalogueComponent, optional
        Components of files of the user.

    Returns
    -------
    tuple of CatalogueComponent
        At least one component.

    Raises
    ------
    InputError
        If there is no component with this name.

    Examples
    --------
    >>> find_variants("SMC SY5000")[0].kinds
    ('spool_valve',)
    """
    key = _key(name)
    found = [*variants_of(name, others)]
    # Built-in files by the first word, so that a circuit reads the files of its manufacturers only.
    built_in = [path for maker, path in FILES.data.items() if key.startswith(f"{maker.replace('_', ' ')} ")]
    for path in built_in:
        found += _by_name(path).get(key, ())
    if not found and not built_in:
        found = [component for path in FILES.values() for component in _by_name(path).get(key, ())]
    if not found:
        raise _unknown(name, others)
    return tuple(found)


def variants_of(name: str, components: Iterable[CatalogueComponent]) -> tuple[CatalogueComponent, ...]:
    """Return all components with a name among the given ones."""
    key = _key(name)
    return tuple(component for component in components if key in map(_key, component.names))


def _unknown(name: str, others: Iterable[CatalogueComponent]) -> InputError:
    valid = [*components(), *others]
    key = _key(name)
    # A name without its manufacturer, or the beginning of a catalogue number, is as common as a misspelt one.
    matching = (tuple(n for n in component.names if key and key in _key(n)) for component in valid)
    similar = [*dict.fromkeys(min(names, key=len) for names in matching if names)]
    names = similar[:3] or NameSuggestion(name, [name for component in valid for name in component.names]).names
    return InputError("components.unknown", name=name, names=names)


@cache
def _by_name(path: Path) -> Mapping[str, tuple[CatalogueComponent, ...]]:
    """Return the components of a built-in file or of a plugin by name."""
    found: dict[str, tuple[CatalogueComponent, ...]] = {}
    for component in _components(path):
        for name in component.names:
            found[_key(name)] = *found.get(_key(name), ()), component
    return MappingProxyType(found)


@cache
def _components(path: Path) -> tuple[CatalogueComponent, ...]:
    with confined_to():  # the limit of a circuit file does not apply to the library
        return read_component_file(path)


def components() -> tuple[CatalogueComponent, ...]:
    """Return all components of the library and of plugins.

    Returns
    -------
    tuple of CatalogueComponent
        Components in the order of their manufacturers.
    """
    return tuple(component for name in sorted(FILES) for component in _components(FILES[name]))


def component_names() -> tuple[str, ...]:
    """Return the names of all components of the library and of plugins.

    Returns
    -------
    tuple of str
        Valid values of the field `model`.
    """
    return tuple(dict.fromkeys(name for component in components() for name in component.names))


def _key(name: str) -> str:
    return " ".join(name.split()).casefold()

"""Reader of the model description of an FMU, which executes nothing of the FMU."""

from __future__ import annotations

import math
import os
import platform
import re
import sys
import xml.etree.ElementTree as ElementTree
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path
from typing import Any

from poppet.core.errors import InputError
from poppet.core.files import check_path
from poppet.cosim.archive import DESCRIPTION, check_entries, open_archive
from poppet.cosim.fmu_units import NUMBER, FmuUnit, unit_of_description

MAX_DESCRIPTION, MAX_ELEMENTS, MAX_VARIABLES = 32 * 2**20, 1_000_000, 1000
"""Maximum size of a model description in bytes, of its elements, and of the inputs and outputs of an FMU."""
REALS = ("Real", "Float64", "Float32")
TYPES = {
    "Real": "Float64", "Integer": "Int32", "Enumeration": "Int32", "Boolean": "Boolean", "String": "String",
    **{name: name for name in (
        "Float64", "Float32", "Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64",
    )},
}  # fmt: skip
"""Element of a variable or type in FMI 2.0 and 3.0 to the type of its values."""
_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")
_UNSUITABLE = re.compile(r"[^A-Za-z0-9_]+")
_TRUE = ("true", "1")


@dataclass(frozen=True)
class FmuVariable:
    """Number among the variables of an FMU: an input, an output or a parameter, or one element of an array."""

    name: str  # in the FMU
    local: str  # in addresses of a circuit
    causality: str
    type: str  # value of `TYPES`
    reference: int
    array: str  # name without index
    index: int = 0  # position in its array
    size: int = 1  # of its array
    is_continuous: bool = False
    unit: FmuUnit = NUMBER
    start: Any = None  # in the unit of the FMU
    nominal: float = 1.0  # in the unit of the FMU
    low: float = -math.inf  # SI
    high: float = math.inf
    meaning: str = ""


@dataclass(frozen=True)
class FmuDescription:
    """Properties and variables of an FMU for co-simulation.

    `feedthrough` maps the name of an output to the names of the variables on which it depends directly, or to None if
    the FMU does not state them. The names are those of arrays, without index.
    """

    path: Path
    version: int  # of FMI, 2 or 3
    title: str
    token: str  # identifies the model
    identifier: str  # name of its library
    platforms: tuple[str, ...]  # folders with a library
    can_roll_back: bool
    can_interpolate: bool
    has_variable_step: bool
    step: float | None  # suggested communication step [s]
    variables: tuple[FmuVariable, ...]
    feedthrough: Mapping[str, frozenset[str] | None]

    @property
    def inputs(self) -> tuple[FmuVariable, ...]:
        """Inputs of the FMU."""
        return tuple(v for v in self.variables if v.causality == "input")

    @property
    def outputs(self) -> tuple[FmuVariable, ...]:
        """Outputs of the FMU."""
        return tuple(v for v in self.variables if v.causality == "output")

    @property
    def library(self) -> str:
        """Entry of the archive with the library for the present platform."""
        suffix = {"win32": ".dll", "darwin": ".dylib"}.get(sys.platform, ".so")
        return f"binaries/{present_platform(self.version)}/{self.identifier}{suffix}"

    def with_units(self, units: Mapping[str, FmuUnit]) -> FmuDescription:
        """Return a description in which some variables, by local name, have other units."""
        variables = [replace(v, unit=units[v.local]) if v.local in units else v for v in self.variables]
        return replace(self, variables=tuple(variables))


def present_platform(version: int) -> str:
    """Return the name of the present platform in FMI 2.0 or 3.0."""
    is_wide = sys.maxsize > 2**32
    if version == 2:
        return {"win32": "win", "darwin": "darwin"}.get(sys.platform, "linux") + ("64" if is_wide else "32")
    machine = platform.machine().lower()
    machine = {"amd64": "x86_64", "arm64": "aarch64"}.get(machine, machine)
    return f"{machine}-{ {'win32': 'windows', 'darwin': 'darwin'}.get(sys.platform, 'linux') }"


def read_fmu(path: str | Path) -> FmuDescription:
    """Read the model description of an FMU for co-simulation; nothing of the FMU is executed.

    Parameters
    ----------
    path : str or Path
        Path of the FMU.

    Returns
    -------
    FmuDescription

    Raises
    ------
    InputError
        If the file is not an FMU for co-simulation in FMI 2.0 or 3.0, or exceeds a limit.
    """
    check_path(path)
    try:
        status = os.stat(path)
    except OSError as problem:
        raise InputError("files.unreadable", path=str(path), why=problem.strerror or str(problem)) from None
    key = os.path.realpath(path), status.st_mtime_ns, status.st_size
    if key not in _CACHE:
        while len(_CACHE) >= _MOST_CACHED:
            del _CACHE[next(iter(_CACHE))]
        _CACHE[key] = _read(Path(path))
    return _CACHE[key]


_CACHE: dict[tuple[str, int, int], FmuDescription] = {}
_MOST_CACHED = 32


def _read(path: Path) -> FmuDescription:
    with open_archive(path) as archive:
        check_entries(archive, path.name)
        names = archive.namelist()
        if DESCRIPTION not in names:
            raise InputError("deploy.fmu.no_fmu", name=path.name)
        if archive.getinfo(DESCRIPTION).file_size > MAX_DESCRIPTION:
            raise InputError("fmu.description_size", name=path.name, most=MAX_DESCRIPTION // 2**20)
        content = archive.read(DESCRIPTION)
    try:
        return _DescriptionReader(path, _parse(content, path), names).read()
    except (KeyError, ValueError, OverflowError, AttributeError) as problem:
        if isinstance(problem, InputError):
            raise
        raise InputError("fmu.description", name=path.name, why=str(problem)) from problem


class _LimitedBuilder(ElementTree.TreeBuilder):
    """Builder of an element tree that rejects document types and too many elements."""

    count = 0

    def start(self, tag: Any, attrs: Any, /) -> ElementTree.Element:
        self.count += 1
        if self.count > MAX_ELEMENTS:
            raise ValueError(f"more than {MAX_ELEMENTS} elements")
        return super().start(tag, attrs)

    def doctype(self, name: str, public: str, system: str) -> None:
        """Reject a document type, whose entities can expand to any size or include other files."""
        raise ValueError("document type")


def _parse(content: bytes, path: Path) -> ElementTree.Element:
    try:
        return ElementTree.fromstring(content, ElementTree.XMLParser(target=_LimitedBuilder()))
    except (ElementTree.ParseError, LookupError) as problem:
        raise InputError("fmu.description", name=path.name, why=str(problem)) from problem


class _DescriptionReader:
    """Reader of the elements of one model description."""

    def __init__(self, path: Path, root: ElementTree.Element, entries: list[str]) -> None:
        self.path, self.root, self.entries = path, root, entries

    def read(self) -> FmuDescription:
        """Return the description."""
        root, path = self.root, self.path
        text = root.get("fmiVersion", "")
        version = {"2": 2, "3": 3}.get(text.partition(".")[0])
        if root.tag != "fmiModelDescription" or version is None:
            raise InputError("fmu.version", name=path.name, version=text)
        interface = root.find("CoSimulation")
        if interface is None:
            kinds = [kind for kind in ("ModelExchange", "ScheduledExecution") if root.find(kind) is not None]
            raise InputError("fmu.no_cosimulation", name=path.name, kinds=kinds)
        identifier = interface.get("modelIdentifier", "")
        if not _IDENTIFIER.fullmatch(identifier):
            raise InputError("deploy.fmu.identifier", name=path.name, identifier=identifier)

        def has(flag: str) -> bool:
            return interface.get(flag, "false") in _TRUE

        experiment = root.find("DefaultExperiment")
        step = None if experiment is None else experiment.get("stepSize")
        step = step or interface.get("fixedInternalStepSize")
        read = float(step) if step else math.nan
        elements = list(self._elements(version))
        variables = _with_distinct_names(
            [v for element in elements for v in self._numbers(element, version, elements)], path
        )
        return FmuDescription(
            path=path, version=version, title=root.get("modelName", ""),
            token=root.get("guid" if version == 2 else "instantiationToken", ""), identifier=identifier,
            platforms=tuple(dict.fromkeys(name.split("/")[1] for name in self.entries if _is_library(name))),
            can_roll_back=has("canGetAndSetFMUstate" if version == 2 else "canGetAndSetFMUState"),
            can_interpolate=version == 2 and has("canInterpolateInputs"),
            has_variable_step=has("canHandleVariableCommunicationStepSize"),
            step=read if 0.0 < read < math.inf else None, variables=tuple(variables),
            feedthrough=self._feedthrough(version, elements),
        )  # fmt: skip

    def _elements(self, version: int) -> Iterator[tuple[ElementTree.Element, ElementTree.Element]]:
        """Yield the element of each variable, and the element with its type."""
        for element in self.root.iterfind("ModelVariables/*"):
            if version == 3:
                yield element, element
            else:
                yield element, next((child for child in element if child.tag in TYPES), element)

    def _numbers(
        self,
        pair: tuple[ElementTree.Element, ElementTree.Element],
        version: int,
        elements: list[tuple[ElementTree.Element, ElementTree.Element]],
    ) -> Iterator[FmuVariable]:
        """Yield the numbers of one variable, several if it is an array."""
        element, kind = pair
        causality, type_ = element.get("causality", "local"), TYPES.get(kind.tag)
        if version == 3 and kind.tag == "Enumeration":
            type_ = "Int64"
        if causality not in ("input", "output", "parameter") or type_ is None:
            return
        if type_ == "String" and causality != "parameter":
            return
        attributes = dict(self._type_attributes(kind.get("declaredType", ""), kind.tag)) | dict(kind.attrib)
        is_real = kind.tag in REALS
        unit = self._unit(attributes) if is_real else NUMBER
        shape = tuple(self._dimension(child, elements) for child in element.iterfind("Dimension"))
        size = math.prod(shape)
        if size > MAX_VARIABLES:
            raise InputError("fmu.variables", name=self.path.name, count=size, most=MAX_VARIABLES)
        starts = attributes.get("start", "").split() if shape else [attributes.get("start")]
        name = element.attrib["name"]

        def limit(key: str, default: float) -> float:
            return unit.to_si(float(attributes[key])) if key in attributes and is_real else default

        for k, place in enumerate(product(*(range(1, length + 1) for length in shape))):
            start = starts[k] if k < len(starts) else starts[0] if len(starts) == 1 else None
            index = f"[{','.join(map(str, place))}]" if shape else ""
            yield FmuVariable(
                name + index, local_name(name + index), causality, type_, int(element.attrib["valueReference"]),
                name, k, size, is_real and element.get("variability", "continuous") == "continuous", unit,
                None if start is None else read_value(start, type_), abs(float(attributes.get("nominal", 1.0))) or 1.0,
                limit("min", -math.inf), limit("max", math.inf), element.get("description", ""),
            )  # fmt: skip

    def _dimension(
        self, child: ElementTree.Element, elements: list[tuple[ElementTree.Element, ElementTree.Element]]
    ) -> int:
        if "start" in child.attrib:
            return int(child.attrib["start"])
        reference = child.attrib["valueReference"]
        return next(int(e.attrib["start"]) for e, _ in elements if e.get("valueReference") == reference)

    def _type_attributes(self, name: str, tag: str) -> Mapping[str, str]:
        """Return the attributes of a declared type."""
        if not hasattr(self, "_types"):
            self._types: dict[str, Mapping[str, str]] = {}
            for element in self.root.iterfind("TypeDefinitions/*"):
                inner = next((child for child in element if child.tag in TYPES), element)
                self._types[element.get("name", "")] = inner.attrib
        attributes = dict(self._types.get(name, {}))
        attributes.pop("name", None)
        return attributes if tag != "Enumeration" else {}

    def _unit(self, attributes: Mapping[str, str]) -> FmuUnit:
        if not hasattr(self, "_units"):
            self._units: dict[str, FmuUnit] = {}
            for element in self.root.iterfind("UnitDefinitions/Unit"):
                base = element.find("BaseUnit")
                name = element.get("name", "")
                self._units[name] = unit_of_description(name, None if base is None else base.attrib)
        if "unit" not in attributes:
            return NUMBER
        unit = self._units.get(attributes["unit"]) or unit_of_description(attributes["unit"], None)
        return unit.difference() if attributes.get("relativeQuantity", "false") in _TRUE else unit

    def _feedthrough(
        self, version: int, elements: list[tuple[ElementTree.Element, ElementTree.Element]]
    ) -> dict[str, frozenset[str] | None]:
        """Return the direct dependences of the outputs on inputs."""
        by_index = {str(k): e.attrib["name"] for k, (e, _) in enumerate(elements, 1)}
        if version == 3:
            by_index = {e.attrib["valueReference"]: e.attrib["name"] for e, _ in elements}
        path, key = ("ModelStructure/Outputs/Unknown", "index") if version == 2 else ("ModelStructure/Output", "")
        result: dict[str, frozenset[str] | None] = {}
        for element in self.root.iterfind(path):
            name, stated = by_index.get(element.get(key or "valueReference", ""), ""), element.get("dependencies")
            result[name] = None if stated is None else frozenset(by_index.get(k, "") for k in stated.split())
        return result


def local_name(name: str) -> str:
    """Return the name of an FMU variable in addresses of a circuit.

    Each sequence of characters other than letters, digits and underscores becomes one underscore.

    Examples
    --------
    >>> local_name("body.v[1]"), local_name("der(x)"), local_name("2nd stage")
    ('body_v_1', 'der_x', 'v2nd_stage')
    """
    local = _UNSUITABLE.sub("_", name).strip("_") or "v"
    return f"v{local}" if local[0].isdigit() else local


def read_value(text: str, type_: str) -> Any:
    """Return a value of a model description as a number or text."""
    if type_ == "Boolean":
        return float(text in _TRUE)
    return text if type_ == "String" else float(text)


def _is_library(entry: str) -> bool:
    return entry.startswith("binaries/") and entry.endswith((".so", ".dll", ".dylib")) and entry.count("/") == 2


def _with_distinct_names(variables: list[FmuVariable], path: Path) -> list[FmuVariable]:
    """Return the variables with a number added to local names that occur again."""
    coupled = sum(v.causality != "parameter" for v in variables)
    if coupled > MAX_VARIABLES:
        raise InputError("fmu.variables", name=path.name, count=coupled, most=MAX_VARIABLES)
    taken: set[str] = set()
    result = []
    for variable in variables:
        local, k = variable.local, 2
        while local in taken:
            local, k = f"{variable.local}_{k}", k + 1
        taken.add(local)
        result.append(replace(variable, local=local))
    return result

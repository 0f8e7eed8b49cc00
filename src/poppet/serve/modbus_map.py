"""Map from Modbus addresses to the inputs, outputs and faults of a served circuit.

The table `[modbus]` of a circuit file, or a default map, assigns registers and bits to addresses of the circuit.
"""

from __future__ import annotations

import csv
import io
import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from difflib import get_close_matches
from functools import cached_property, partial
from typing import Any

from poppet.circuit.modbus_table import AREAS, FIELDS, MAX_ADDRESS, REGISTER_FIELDS, TYPES
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.tables import read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import SMALLEST, convert, exact_scale, quantity
from poppet.parts.conditions import KIND_OF_UNIT
from poppet.parts.faults import FAULTS, HEALTHY
from poppet.serve.points import Point, PointRole, ServedCircuit
from poppet.serve.registers import Representation

WRITABLE = ("coil", "holding")
BITS = ("coil", "discrete")
FAULT = "fault"
"""Local name under which a register contains the code of the fault of a valve."""
CODES = {fault: float(code) for code, fault in enumerate((HEALTHY, *FAULTS))}
"""Codes of the faults in registers."""
FIRST_FAULT = 10_000
"""Address of the first fault in the default map: a program that writes all inputs in one request omits the faults."""
TIME = Point("time", "s", PointRole.OUTPUT, -math.inf, math.inf, math.nan, "time of the machine")
"""Time of the machine, which a map can contain besides the points of the circuit."""
REPRESENTATION = ("type", "unit", "raw", "range", "word_order")
"""Fields of numbers in registers."""
FAULT_TYPE = "uint16"
"""Type of the code of a fault."""
COLUMNS = ("address", "area", "register", "number", "type", "unit", "raw", "range", "access", "meaning")
"""Columns of the printed map."""


@dataclass(frozen=True)
class FaultTarget:
    """Faults of a valve that a register represents by their codes, or the single fault that a bit represents."""

    valve: str
    faults: tuple[str, ...]
    is_bit: bool = False

    @property
    def meaning(self) -> str:
        """Meaning of the value of the register or bit."""
        if self.is_bit:
            return f"1: {self.faults[0]}"
        return ", ".join(f"{CODES[fault]:.0f} {fault}" for fault in (HEALTHY, *self.faults))


@dataclass(frozen=True)
class MapEntry:
    """Quantity of the served circuit at one Modbus address."""

    address: str  # of the quantity
    area: str
    first: int  # zero-based address of its first register, or of its bit
    target: Point | FaultTarget
    representation: Representation | None  # None for a bit
    type_name: str = "bit"
    unit: str = ""
    raw: tuple[int, int] | None = None
    span: tuple[str, str] = ("", "")  # values at both ends of raw

    @property
    def count(self) -> int:
        """Number of registers or bits."""
        return 1 if self.representation is None else self.representation.type.words

    def row(self) -> tuple[str, ...]:
        """Return the cells of the columns `COLUMNS`."""
        meaning = self.target.doc if isinstance(self.target, Point) else self.target.meaning
        raw = "" if self.raw is None else f"{self.raw[0]} to {self.raw[1]}"
        span = " to ".join(self.span) if self.raw else ""
        access = "read, write" if self.area in WRITABLE else "read"
        number = f"{AREAS[self.area]}{self.first + 1:05d}"
        return (self.address, self.area, str(self.first), number, self.type_name, self.unit, raw, span, access, meaning)


@dataclass(frozen=True)
class ModbusMap:
    """Entries of a Modbus map, sorted by area and address."""

    entries: tuple[MapEntry, ...]

    @cached_property
    def cells(self) -> Mapping[str, Mapping[int, tuple[MapEntry, int]]]:
        """Mapping from area and address to the entry, and to the index of the register within the entry."""
        cells: dict[str, dict[int, tuple[MapEntry, int]]] = {area: {} for area in AREAS}
        for entry in self.entries:
            for k in range(entry.count):
                cells[entry.area][entry.first + k] = entry, k
        return cells

    def csv(self) -> str:
        """Return the map as CSV text."""
        text = io.StringIO()
        writer = csv.writer(text, lineterminator="\n")
        writer.writerows([COLUMNS, *(entry.row() for entry in self.entries)])
        return text.getvalue()

    def markdown(self) -> str:
        """Return the map as a table in Markdown."""
        rows = [COLUMNS, ("---",) * len(COLUMNS), *(entry.row() for entry in self.entries)]
        return "".join(f"| {' | '.join(cell.replace('|', '/') for cell in row)} |\n" for row in rows)


def read_modbus_map(
    table: Any, points: Sequence[Point], faults: Mapping[str, Sequence[str]], ambient_pressure: float
) -> ModbusMap:
    """Read the table `[modbus]` of a circuit file.

    Parameters
    ----------
    table : dict or None
        Table of the file; the result is the default map if it is None, or has no registers.
    points : sequence of Point
        Inputs, outputs and parameters of the served circuit.
    faults : mapping
        Possible faults of each valve.
    ambient_pressure : float
        Absolute pressure to which gauge values refer [Pa].

    Returns
    -------
    ModbusMap

    Raises
    ------
    InputErrors
        All errors of the table; their addresses begin with `modbus`.
    """
    with ErrorCollector() as errors:
        reader = _MapReader(errors, points, faults, ambient_pressure)
        settings = read_fields(errors, {} if table is None else table, FIELDS, "modbus", table="table modbus")
        registers = settings.get("registers")
        if registers is None:
            registers = default_registers(points, faults)
        for address, entry in _flat(registers):
            with errors.collecting():
                reader.add(address, entry, settings.get("word_order", "big"))
        reader.check_overlaps()
    order = list(AREAS)
    return ModbusMap(tuple(sorted(reader.entries, key=lambda entry: (order.index(entry.area), entry.first))))


def map_of_circuit(served: ServedCircuit, file: str | None = None) -> ModbusMap:
    """Return the Modbus map of a served circuit: that of its file, or the default map.

    With the name of the file, errors contain their lines.
    """
    circuit = served.circuit
    try:
        table = circuit.origin.tables.get("modbus")
        return read_modbus_map(table, served.points, served.faults, circuit.surroundings.pressure)
    except InputError as error:
        raise error if file is None else TomlFile.read(file).located(error) from None


def default_registers(points: Iterable[Point], faults: Mapping[str, Sequence[str]]) -> dict[str, dict[str, Any]]:
    """Return the table `registers` of the default map.

    Outputs are input registers, and inputs are holding registers, both of type float32 in SI units. Values that are 0
    or 1 are discrete inputs and coils. The first input registers contain the time as float64, and the holding registers
    from `FIRST_FAULT` the faults of the valves.
    """
    registers: dict[str, dict[str, Any]] = {TIME.address: {"input": 0, "type": "float64"}}
    counts = Counter({"input": TYPES["float64"].words})
    for point in points:
        if point.role is PointRole.PARAMETER:
            continue
        is_input = point.role is PointRole.INPUT
        area = ("coil" if is_input else "discrete") if point.is_flag else ("holding" if is_input else "input")
        registers[point.address] = {area: counts[area]}
        counts[area] += 1 if point.is_flag else TYPES["float32"].words
    if counts["holding"] > FIRST_FAULT or counts["input"] > MAX_ADDRESS + 1:
        raise InputError("modbus.full", "modbus", count=counts["input"] + counts["holding"])
    for k, valve in enumerate(faults):
        registers[f"{valve}.{FAULT}"] = {"holding": FIRST_FAULT + k}
    return registers


def _flat(registers: Mapping[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Yield pairs of address and entry; an address without quotes creates nested tables."""
    for key, value in registers.items():
        if isinstance(value, Mapping) and value and all(isinstance(inner, Mapping) for inner in value.values()):
            yield from _flat(value, f"{prefix}{key}.")
        else:
            yield f"{prefix}{key}", value


class _MapReader:
    """Reader of the entries of a map; it collects all errors."""

    def __init__(
        self,
        errors: ErrorCollector,
        points: Iterable[Point],
        faults: Mapping[str, Sequence[str]],
        ambient_pressure: float,
    ) -> None:
        self.errors, self.ambient_pressure = errors, ambient_pressure
        self.targets: dict[str, Point | FaultTarget] = {point.address: point for point in (TIME, *points)}
        for valve, possible in faults.items():
            self.targets[f"{valve}.{FAULT}"] = FaultTarget(valve, tuple(possible))
            self.targets |= {f"{valve}.{fault}": FaultTarget(valve, (fault,), is_bit=True) for fault in possible}
        self.entries: list[MapEntry] = []

    def add(self, address: str, table: Any, word_order: str) -> None:
        """Read one entry, and add it to `entries`."""
        location, areas = f"modbus.registers.{address}", [*AREAS]
        with ErrorCollector() as errors:
            fields = read_fields(errors, table, REGISTER_FIELDS, location, table="Modbus register")
            if isinstance(table, Mapping):
                areas = [area for area in AREAS if area in table]
                misspelt = [key for key in table if key not in REGISTER_FIELDS]
                if len(areas) != 1 and not any(get_close_matches(str(key), AREAS, n=1) for key in misspelt):
                    errors.add("modbus.areas", location, given=areas, areas=[*AREAS])
            if address not in self.targets:
                suggestion = NameSuggestion(address, self.targets)
                errors.add("modbus.unknown", location, name=address, suggestion=suggestion)
        (area,), target = areas, self.targets[address]
        with ErrorCollector() as errors:
            errors.extend(_access_problems(location, area, target))
            names = REPRESENTATION if area in BITS else REPRESENTATION[1:] if isinstance(target, FaultTarget) else ()
            code = "modbus.bit" if area in BITS else "modbus.fault_field"
            errors.extend(
                InputError(code, f"{location}.{name}", area=area, field=name) for name in names if name in fields
            )
        make_entry = partial(MapEntry, address, area, fields[area], target)
        if area in BITS:
            entry = make_entry(None)
        elif isinstance(target, Point):
            entry = self._number_entry(make_entry, location, target, {"word_order": word_order} | fields)
        elif fields.get("type", FAULT_TYPE) != FAULT_TYPE:
            raise InputError("modbus.fault_type", f"{location}.type", value=fields["type"])
        else:
            entry = make_entry(Representation(TYPES[FAULT_TYPE]), FAULT_TYPE)
        if entry.first + entry.count - 1 > MAX_ADDRESS:
            facts: dict[str, Any] = {"first": entry.first, "count": entry.count, "type": entry.type_name}
            raise InputError("modbus.beyond", f"{location}.{area}", **facts)
        self.entries.append(entry)

    def _number_entry(
        self, make_entry: Callable[..., MapEntry], location: str, point: Point, fields: Mapping[str, Any]
    ) -> MapEntry:
        """Return the entry of a point in registers."""
        type_name = fields.get("type", "int16" if "raw" in fields else "float32")
        kind, is_little = TYPES[type_name], fields["word_order"] == "little"
        unit = fields.get("unit", point.unit)
        try:
            zero = convert(0.0, unit, point.unit, ambient_pressure=self.ambient_pressure)
        except InputError as error:
            raise error.at(f"{location}.unit") from None
        if ("raw" in fields) != ("range" in fields):
            missing, present = ("range", "raw") if "raw" in fields else ("raw", "range")
            raise InputError("modbus.half_scaling", f"{location}.{present}", given=present, missing=missing)
        if "raw" not in fields:
            scale = float(exact_scale(unit)[0].scale / exact_scale(point.unit)[0].scale)
            unit_text = "" if unit == "1" else unit
            return make_entry(Representation(kind, scale, zero, is_little=is_little), type_name, unit_text)
        raw = _raw_ends(f"{location}.raw", fields["raw"], type_name)
        span, texts = self._range(f"{location}.range", fields["range"], point.unit, unit)
        scale = (span[1] - span[0]) / (raw[1] - raw[0])
        representation = Representation(kind, scale, span[0] - raw[0] * scale, min(raw), max(raw), is_little)
        return make_entry(representation, type_name, raw=raw, span=texts)

    def _range(self, location: str, value: Any, si_unit: str, unit: str) -> tuple[tuple[float, float], tuple[str, str]]:
        """Return the ends of a range in SI, and their texts."""
        if not (isinstance(value, list) and len(value) == 2):
            raise InputError("modbus.range", location, value=value)
        ends = []
        for item in value:
            if isinstance(item, str):
                end = quantity(item, si_unit, kind=KIND_OF_UNIT.get(si_unit, "plain"), name=location)
                ends.append(end.value + (self.ambient_pressure if end.reference == "gauge" else 0.0))
            else:
                number = quantity(item, "1", name=location).value
                ends.append(convert(number, unit, si_unit, ambient_pressure=self.ambient_pressure))
        if not abs(ends[1] - ends[0]) > SMALLEST:
            raise InputError("modbus.range", location, value=value)
        texts = [item if isinstance(item, str) else f"{item:g} {'' if unit == '1' else unit}".strip() for item in value]
        return (ends[0], ends[1]), (texts[0], texts[1])

    def check_overlaps(self) -> None:
        """Collect an error for each entry whose registers another entry also uses."""
        owners: dict[tuple[str, int], MapEntry] = {}
        for entry in self.entries:
            cells = [(entry.area, entry.first + k) for k in range(entry.count)]
            shared = next((cell for cell in cells if cell in owners), None)
            if shared is not None:
                self.errors.add(
                    "modbus.overlap", f"modbus.registers.{entry.address}.{entry.area}", name=entry.address,
                    other=owners[shared].address, area=entry.area, register=shared[1],
                )  # fmt: skip
            owners |= dict.fromkeys(cells, entry)


def _raw_ends(location: str, value: Any, type_name: str) -> tuple[int, int]:
    """Return the integers at both ends of a range."""
    kind = TYPES[type_name]
    if not kind.is_integer:
        raise InputError("modbus.raw_type", location, type=type_name)
    is_pair = isinstance(value, list) and len(value) == 2 and all(type(item) is int for item in value)
    if not is_pair or value[0] == value[1] or not all(kind.low <= item <= kind.high for item in value):
        raise InputError("modbus.raw", location, value=value, type=type_name, low=kind.low, high=kind.high)
    return value[0], value[1]


def _access_problems(location: str, area: str, target: Point | FaultTarget) -> list[InputError]:
    """Return the errors of an area that is not possible for a quantity."""
    if isinstance(target, FaultTarget):
        if (area in BITS) == target.is_bit:
            return []
        areas = ("coil", "discrete") if target.is_bit else ("holding", "input")
        facts: dict[str, Any] = {"is_bit": target.is_bit, "is_code": not target.is_bit, "areas": [*areas]}
        return [InputError("modbus.fault_area", f"{location}.{area}", **facts)]
    if area in WRITABLE and target.role is not PointRole.INPUT:
        return [InputError("modbus.not_writable", f"{location}.{area}", name=target.address, area=area,
                           other="discrete" if area == "coil" else "input")]  # fmt: skip
    if area == "coil" and not (target.low <= 0.0 and target.high >= 1.0):
        limits: dict[str, Any] = {"low": target.low, "high": target.high, "unit": target.unit}
        return [InputError("modbus.no_coil", f"{location}.coil", name=target.address, **limits)]
    return []

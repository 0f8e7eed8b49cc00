"""Map from Modbus addresses to a served circuit: default map, errors and representation of values."""

from __future__ import annotations

import contextlib
import csv
import io
import math
import struct
from pathlib import Path
from typing import Any

import pytest

from modbus_stub import FAULTS, POINTS, map_of, point
from poppet.circuit.modbus_table import REGISTER_FIELDS, TYPES
from poppet.core.errors import InputError
from poppet.serve.modbus_map import ModbusMap, read_modbus_map
from poppet.serve.registers import Representation


def entry_of(registers: dict[str, Any], **more: Any) -> Any:
    (entry,) = map_of(registers, **more).entries
    return entry


def problems_of(registers: Any, **more: Any) -> list[tuple[str, str]]:
    with pytest.raises(InputError) as caught:
        map_of(registers, **more)
    return [(problem.code, problem.address or "") for problem in caught.value.problems]


def encoded(entry: Any, value: float) -> bytes:
    return entry.representation.encode(value)  # type: ignore[no-any-return]


def test_default_map_has_each_input_output_and_fault() -> None:
    places = {entry.address: (entry.area, entry.first, entry.type_name) for entry in map_of().entries}
    assert places == {
        "time": ("input", 0, "float64"),
        "tank.pressure": ("input", 4, "float32"),
        "tank.temperature": ("input", 6, "float32"),
        "slide.position": ("input", 8, "float32"),
        "end.state": ("discrete", 0, "bit"),
        "valve.opening": ("holding", 0, "float32"),
        "valve.setpoint": ("holding", 2, "float32"),
        "plc.run": ("coil", 0, "bit"),
        "valve.fault": ("holding", 10_000, "uint16"),
        "check.fault": ("holding", 10_001, "uint16"),
    }


def test_values_have_the_stated_unit_and_reference() -> None:
    entry = entry_of({"tank.pressure": {"input": 0, "type": "float32", "unit": "bar g"}})
    assert struct.unpack(">f", encoded(entry, 350_000.0)) == (2.5,)
    assert entry.representation.decode(struct.pack(">f", 2.5)) == 350_000.0
    entry = entry_of({"tank.temperature": {"input": 0, "type": "float64", "unit": "degC"}})
    assert struct.unpack(">d", encoded(entry, 293.15)) == pytest.approx((20.0,), abs=1e-9)
    assert entry.count == 4


def test_integers_without_raw_are_rounded_in_their_unit_and_saturate() -> None:
    entry = entry_of({"slide.position": {"input": 7, "type": "int16", "unit": "mm"}})
    assert [struct.unpack(">h", encoded(entry, x))[0] for x in (0.0986, -0.0015, 40.0, -40.0)] == [
        99,
        -2,
        32767,
        -32768,
    ]


def test_raw_values_scale_and_saturate() -> None:
    table = {"input": 0, "type": "int16", "raw": [0, 27648], "range": ["0 bar", "10 bar"]}
    entry = entry_of({"tank.pressure": table})
    raw = [struct.unpack(">h", encoded(entry, p))[0] for p in (0.0, 5e5, 10e5, 12e5, -1e5)]
    assert raw == [0, 13824, 27648, 27648, 0]
    assert entry.representation.decode(struct.pack(">h", 27648)) == pytest.approx(10e5, rel=1e-15)
    # Beyond the range, a writing is invalid.
    assert entry.representation.decode(struct.pack(">h", 27649)) is None
    assert entry.representation.decode(struct.pack(">h", -1)) is None


def test_a_falling_range_and_gauge_ends() -> None:
    table = {"input": 0, "raw": [4000, 20000], "range": ["10 bar g", "0 bar g"], "type": "uint16"}
    entry = entry_of({"tank.pressure": table})
    assert [struct.unpack(">H", encoded(entry, p))[0] for p in (1e5, 11e5, 6e5)] == [20000, 4000, 12000]
    numbers = entry_of({"tank.pressure": table | {"range": [10, 0], "unit": "bar g"}})
    assert encoded(numbers, 6e5) == encoded(entry, 6e5)


@pytest.mark.parametrize("name", TYPES)
def test_the_little_word_order_reverses_words_and_not_bytes(name: str) -> None:
    kind, value = TYPES[name], 12345.0
    big, little = (Representation(kind, is_little=is_little).encode(value) for is_little in (False, True))
    assert big == struct.pack(f">{kind.code}", int(value) if kind.is_integer else value)
    words = [big[k : k + 2] for k in range(0, len(big), 2)]
    assert little == b"".join(reversed(words))
    assert Representation(kind, is_little=True).decode(little) == value


@pytest.mark.parametrize(
    ("name", "raw"),
    [("int16", -(2**15)), ("uint16", 2**16 - 1), ("int32", -(2**31)), ("uint32", 2**32 - 1)],
)
def test_a_value_that_is_not_a_number_has_the_integer_of_sunspec(name: str, raw: int) -> None:
    """SunSpec Information Model: 0x8000, 0xFFFF, 0x80000000 and 0xFFFFFFFF; also outside the range of `raw`."""
    kind = TYPES[name]
    for representation in (Representation(kind), Representation(kind, 0.5, 3.0, low=0, high=27648)):
        assert struct.unpack(f">{kind.code}", representation.encode(math.nan)) == (raw,)
    assert Representation(kind, 0.5, 3.0, low=0, high=27648).decode(struct.pack(f">{kind.code}", raw)) is None


@pytest.mark.parametrize("name", ["float32", "float64"])
def test_a_value_that_is_not_a_number_remains_one_as_a_float(name: str) -> None:
    kind = TYPES[name]
    assert math.isnan(struct.unpack(f">{kind.code}", Representation(kind).encode(math.nan))[0])


def test_the_word_order_of_the_table_applies_to_entries_without_one() -> None:
    registers = {"tank.pressure": {"input": 0}, "tank.temperature": {"input": 2, "word_order": "big"}}
    first, second = map_of(registers, word_order="little").entries
    assert (first.representation.is_little, second.representation.is_little) == (True, False)


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -float("inf")])
def test_a_float_that_is_not_finite_is_invalid(value: float) -> None:
    entry = entry_of({"valve.setpoint": {"holding": 0}})
    assert entry.representation.decode(struct.pack(">f", value)) is None


@pytest.mark.parametrize(
    ("registers", "code", "address"),
    [
        ({"tank.presure": {"input": 0}}, "modbus.unknown", "tank.presure"),
        ({"tank.pressure": {}}, "modbus.areas", "tank.pressure"),
        ({"tank.pressure": {"input": 0, "holding": 1}}, "modbus.areas", "tank.pressure"),
        ({"tank.pressure": 3}, "fields.no_table", "tank.pressure"),
        ({"tank.pressure": {"input": -1}}, "fields.out_of_range", "tank.pressure.input"),
        ({"tank.pressure": {"input": 65536}}, "fields.out_of_range", "tank.pressure.input"),
        ({"tank.pressure": {"input": "0"}}, "fields.other_type", "tank.pressure.input"),
        ({"tank.pressure": {"inptu": 20}}, "fields.unknown", "tank.pressure.inptu"),
        ({"tank.pressure": {"input": 65535}}, "modbus.beyond", "tank.pressure.input"),
        ({"tank.pressure": {"input": 0, "typ": "int16"}}, "fields.unknown", "tank.pressure.typ"),
        ({"tank.pressure": {"input": 0, "type": "int8"}}, "fields.not_an_option", "tank.pressure.type"),
        ({"tank.pressure": {"input": 0, "unit": "mm"}}, "unit.other_quantity", "tank.pressure.unit"),
        ({"tank.pressure": {"holding": 0}}, "modbus.not_writable", "tank.pressure.holding"),
        ({"end.state": {"coil": 0}}, "modbus.not_writable", "end.state.coil"),
        ({"tank.volume": {"holding": 0}}, "modbus.not_writable", "tank.volume.holding"),
        ({"valve.setpoint": {"coil": 0}}, "modbus.no_coil", "valve.setpoint.coil"),
        ({"plc.run": {"coil": 0, "unit": "1"}}, "modbus.bit", "plc.run.unit"),
        ({"tank.pressure": {"input": 0, "raw": [0, 27648]}}, "modbus.half_scaling", "tank.pressure.raw"),
        ({"tank.pressure": {"input": 0, "range": [0, 1]}}, "modbus.half_scaling", "tank.pressure.range"),
        (
            {"tank.pressure": {"input": 0, "type": "float32", "raw": [0, 1], "range": [0, 1]}},
            "modbus.raw_type", "tank.pressure.raw",
        ),
        ({"tank.pressure": {"input": 0, "raw": [0, 40000], "range": [0, 1]}}, "modbus.raw", "tank.pressure.raw"),
        ({"tank.pressure": {"input": 0, "raw": [0, 27648.0], "range": [0, 1]}}, "modbus.raw", "tank.pressure.raw"),
        ({"tank.pressure": {"input": 0, "raw": [5, 5], "range": [0, 1]}}, "modbus.raw", "tank.pressure.raw"),
        ({"tank.pressure": {"input": 0, "raw": [0, 5], "range": [1, 1]}}, "modbus.range", "tank.pressure.range"),
        ({"tank.pressure": {"input": 0, "raw": [0, 5], "range": [0, 1e-320]}}, "modbus.range", "tank.pressure.range"),
        (
            {"tank.pressure": {"input": 0, "raw": [0, 5], "range": [0, True]}},
            "quantity.not_a_number", "tank.pressure.range",
        ),
        ({"tank.pressure": {"input": 0, "raw": [0, 5], "range": "1 bar"}}, "modbus.range", "tank.pressure.range"),
        (
            {"tank.pressure": {"input": 0, "raw": [0, 5], "range": ["1 bar", "2 mm"]}},
            "quantity.other_quantity", "tank.pressure.range",
        ),
        ({"valve.fault": {"coil": 0}}, "modbus.fault_area", "valve.fault.coil"),
        ({"valve.stuck": {"holding": 0}}, "modbus.fault_area", "valve.stuck.holding"),
        ({"valve.fault": {"holding": 0, "type": "float32"}}, "modbus.fault_type", "valve.fault.type"),
        ({"valve.fault": {"holding": 0, "unit": "bar"}}, "modbus.fault_field", "valve.fault.unit"),
        ({"check.slow": {"coil": 0}}, "modbus.unknown", "check.slow"),
    ],
)  # fmt: skip
def test_an_invalid_entry_has_a_code_and_its_address(registers: Any, code: str, address: str) -> None:
    assert problems_of(registers) == [(code, f"modbus.registers.{address}")]


def test_overlaps_are_errors_within_an_area_only() -> None:
    registers = {"tank.pressure": {"input": 0}, "tank.temperature": {"input": 1}, "valve.opening": {"holding": 0}}
    assert problems_of(registers) == [("modbus.overlap", "modbus.registers.tank.temperature.input")]
    with pytest.raises(InputError) as caught:
        map_of(registers)
    assert caught.value.facts["other"] == "tank.pressure"
    assert caught.value.facts["register"] == 1


def test_all_errors_are_reported_together() -> None:
    registers = {"tank.presure": {"input": 0}, "plc.run": {"holding": 0, "type": "x"}}
    assert {code for code, _ in problems_of(registers, word_order="middle", register=1)} == {
        "modbus.unknown", "fields.not_an_option", "fields.unknown",
    }  # fmt: skip


def test_inputs_and_parameters_can_be_read_only() -> None:
    registers = {"valve.opening": {"input": 0}, "tank.volume": {"input": 2, "unit": "l"}, "plc.run": {"discrete": 0}}
    assert {entry.address: entry.area for entry in map_of(registers).entries} == {
        "valve.opening": "input", "tank.volume": "input", "plc.run": "discrete",
    }  # fmt: skip


def test_the_printed_map_contains_the_usual_numbers() -> None:
    modbus_map = map_of({
        "tank.pressure": {"input": 4, "type": "int16", "raw": [0, 27648], "range": ["0 bar", "10 bar"]},
        "valve.stuck_closed": {"coil": 8}, "check.fault": {"holding": 0},
    })  # fmt: skip
    rows = {row["address"]: row for row in csv.DictReader(io.StringIO(modbus_map.csv()))}
    pressure = rows["tank.pressure"]
    assert (pressure["register"], pressure["number"], pressure["access"]) == ("4", "300005", "read")
    assert (pressure["raw"], pressure["range"]) == ("0 to 27648", "0 bar to 10 bar")
    assert rows["valve.stuck_closed"]["number"] == "000009"
    assert rows["check.fault"]["meaning"] == "0 none, 1 stuck_open, 5 leak"
    lines = modbus_map.markdown().splitlines()
    assert len(lines) == 5
    assert {line.count("|") for line in lines} == {11}


def test_an_empty_table_has_no_registers() -> None:
    assert map_of({}) == ModbusMap(())


def test_more_registers_than_addresses_are_an_error() -> None:
    points = [point(f"tank{k}.pressure", "Pa") for k in range(32_767)]
    with pytest.raises(InputError) as caught:
        read_modbus_map(None, points, {}, 1e5)
    assert (caught.value.code, caught.value.facts["count"]) == ("modbus.full", 4 + 2 * 32_767)


def test_an_address_without_quotes_is_valid() -> None:
    assert map_of({"tank": {"pressure": {"input": 0}}}) == map_of({"tank.pressure": {"input": 0}})
    assert problems_of({"tank": {"presure": {"input": 0}}}) == [("modbus.unknown", "modbus.registers.tank.presure")]


JUNK = [None, True, -1, 0, 70_000, 10**400, 1.5, float("nan"), "", "7", "\0", [], [1], [1, 2], [[1], 2], ["1 bar", "2"],
        [float("inf"), 0], [10**400, 0], {}, {"a": 1}, {"a": {}}]  # fmt: skip


@pytest.mark.parametrize("field", [*REGISTER_FIELDS, "other"])
def test_values_of_any_type_are_read_or_rejected(field: str) -> None:
    valid = {"tank.pressure": {"input": 0}, "valve.opening": {"holding": 0}, "plc.run": {"coil": 0},
             "valve.fault": {"holding": 8}, "valve.stuck": {"coil": 4}}  # fmt: skip
    for address, entry in valid.items():
        for value in JUNK:
            for more in ({}, {"range": [0, 1]}, {"raw": [0, 1]}):
                with contextlib.suppress(InputError):
                    map_of({address: {**entry, **more, field: value}})


@pytest.mark.parametrize("value", JUNK)
def test_tables_of_any_type_are_read_or_rejected(value: Any) -> None:
    for table in (value, {"registers": value}, {"registers": {"tank.pressure": value}}, {"word_order": value}):
        with contextlib.suppress(InputError):
            read_modbus_map(table, POINTS, FAULTS, 1e5)


def test_the_documentation_contains_each_field_and_type() -> None:
    text = (Path(__file__).parents[3] / "docs" / "circuit_file.md").read_text(encoding="utf-8")
    section = text.partition("### `[modbus]`")[2].partition("\n## ")[0]
    for name in (*REGISTER_FIELDS, *TYPES):
        assert f"`{name}`" in section, name

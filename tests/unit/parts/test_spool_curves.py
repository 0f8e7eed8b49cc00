"""Tables of metering edges: reading, parameters, and rejected tables."""

from __future__ import annotations

import pytest

from poppet import Chamber, Circuit, InputErrors, Reservoir, SpoolValve, load
from poppet.circuit.schema import circuit_schema
from poppet.library import characteristic
from poppet.parts.captions import CaptionNumbers
from poppet.parts.part import Surroundings
from refusals import refused

AIR = Surroundings(1e5, 293.15, 287.05, 1.4, 1.0)
PORTS = {"supply": "rail", "a": "first", "b": "second"}
TABLE = {
    "position": [-1, 0, 0.1, 1],
    "sonic_conductance": ["0 l/(s bar)", "0.01 l/(s bar)", "0.3 l/(s bar)", "2.9 l/(s bar)"],
    "critical_ratio": [0.3, 0.3, 0.25, 0.2],
    "source": "measured, bench 3",
}


def valve(**fields):
    return SpoolValve(**{**PORTS, "characteristic": TABLE, **fields})


def test_numbers_have_the_source_of_the_table():
    numbers = valve().numbers()
    number = numbers["characteristic.sonic_conductance.y3"]
    assert (number.value, number.unit, str(number.source)) == (2.9e-8, "m^3/(s Pa)", "measured: bench 3")
    assert "overlap" in numbers
    assert "sonic_conductance" not in numbers


def test_one_ratio_for_all_positions():
    part = valve(characteristic=TABLE | {"critical_ratio": 0.35})
    assert part.numbers()["characteristic.critical_ratio.value"].value == 0.35


def test_a_value_of_a_table_can_change():
    parts = {"rail": Reservoir(pressure="7 bar"), "first": Chamber(volume="1 l"), "second": Chamber(volume="1 l")}
    circuit = Circuit({**parts, "valve": valve(exhaust_a_characteristic=TABLE)})
    for address in ("valve.characteristic.sonic_conductance.y3", "valve.exhaust_a_characteristic.critical_ratio.y0"):
        changed = circuit.with_values({address: 0.11 if "ratio" in address else 1e-8})
        assert changed.parameters[address] != circuit.parameters[address]
        assert changed.structure == circuit.structure
    assert Circuit({**parts, "valve": valve()}).structure != circuit.structure


def test_the_table_is_read_from_a_file(tmp_path):
    (tmp_path / "edge.toml").write_text(
        'command = ["0 V", "5 V", "10 V"]\nsonic_conductance = [0, 0, 2e-8]\ncritical_ratio = 0.3\n', encoding="utf-8"
    )
    (tmp_path / "circuit.toml").write_text(
        """
[parts.rail]
kind = "reservoir"
pressure = "7 bar"
[parts.first]
kind = "chamber"
volume = "1 l"
[parts.second]
kind = "chamber"
volume = "1 l"
[parts.valve]
kind = "spool_valve"
setpoint_type = "0-10 V"
supply = "rail"
a = "first"
b = "second"
characteristic = "edge.toml"
exhaust_a_characteristic = "edge.toml"
""",
        encoding="utf-8",
    )
    circuit = load(tmp_path / "circuit.toml")
    assert circuit.parameters["valve.command"] == 5.0
    assert circuit.parameters["valve.exhaust_a_characteristic.sonic_conductance.x1"] == 0.0
    with refused("parts.unreadable_file", "characteristic"):
        valve(characteristic="missing.toml")


@pytest.mark.parametrize(
    ("changes", "code", "address"),
    [
        ({"position": [-1, 0.1, 0.1, 1]}, "spool.not_rising", "characteristic.position"),
        ({"position": [1, 0.1, 0, -1]}, "spool.not_rising", "characteristic.position"),
        ({"position": [0, 0.1, 0.2, 1]}, "spool.not_covered", "characteristic.position"),
        ({"position": [-1, 0, 0.1, 0.9]}, "spool.not_covered", "characteristic.position"),
        ({"position": [-1, 0, 0.1, 1.2]}, "spool.not_covered", "characteristic.position"),
        ({"position": [-1, 0, 1]}, "spool.unequal_lengths", "characteristic.sonic_conductance"),
        ({"position": [1]}, "spool.not_a_column", "characteristic.position"),
        ({"position": "0 to 1"}, "spool.not_a_column", "characteristic.position"),
        ({"command": [-1, 0, 0.1, 1]}, "spool.two_columns", "characteristic"),
        ({"stroke": [0, 1]}, "fields.unknown", "characteristic.stroke"),
        ({"critical_ratio": [0.3, 0.3, 1.1, 0.2]}, "spool.impossible_value", None),
        ({"sonic_conductance": [0, -1e-9, 1e-9, 2e-9]}, "spool.impossible_value", None),
        ({"kind": "polynomial"}, "fields.not_an_option", "characteristic.kind"),
        ({"source": "rumour"}, "curves.source", "characteristic.source"),
    ],
)
def test_invalid_tables(changes, code, address):
    with refused(code, address):
        valve(characteristic=TABLE | changes)


def test_missing_columns():
    with refused("fields.missing", "characteristic.position"):
        valve(characteristic={key: value for key, value in TABLE.items() if key != "position"})
    with refused("fields.missing", "characteristic.critical_ratio"):
        valve(characteristic={key: value for key, value in TABLE.items() if key != "critical_ratio"})


@pytest.mark.parametrize("argument", ["varga2012", 3.0, [1, 2]])
def test_other_arguments(argument):
    with refused("spool.not_a_table", "characteristic"):
        valve(characteristic=argument)


def test_characteristic_of_a_stroke_is_not_that_of_a_position():
    seat = characteristic("varga2012.table")
    with refused("spool.not_covered", "characteristic"):
        valve(characteristic=seat)
    # That of another spool valve is.
    assert valve(characteristic=valve().characteristic).numbers() == valve().numbers()
    assert valve(characteristic=TABLE | {"kind": "table"}).numbers() == valve().numbers()


def test_volts_outside_the_range_are_not_positions():
    columns = {key: value for key, value in TABLE.items() if key != "position"}
    with refused("spool.not_covered", "characteristic.command"):
        valve(characteristic=columns | {"command": ["0 V", "5 V", "6 V", "9 V"]}, setpoint_type="0-10 V")


@pytest.mark.parametrize(
    ("fields", "code", "address"),
    [
        (
            {"exhaust_a_characteristic": TABLE, "exhaust_a_conductance": 1e-8},
            "spool.two_sizes",
            "exhaust_a_conductance",
        ),
        ({"exhaust_a_characteristic": TABLE, "exhaust_a_ratio": 0.2}, "spool.two_sizes", "exhaust_a_ratio"),
        ({"supply_b_ratio": 0.2}, "spool.two_sizes", "supply_b_ratio"),
        ({"supply_b_conductance": 1e-8}, "spool.no_ratio", "supply_b_ratio"),
        ({"sonic_conductance": 1e-8}, "parts.several_sizes", None),
        ({"overlap": 0.1}, "spool.idle_with_curves", "overlap"),
        ({"exhaust_overlap": 0.1}, "spool.idle_with_curves", "exhaust_overlap"),
        ({"leak_conductance": 1e-12}, "spool.idle_with_curves", "leak_conductance"),
    ],
)
def test_contradictory_sizes(fields, code, address):
    with refused(code, address):
        valve(**fields)


def test_errors_of_several_tables_are_reported_together():
    with pytest.raises(InputErrors) as caught:
        valve(supply_b_characteristic=TABLE | {"position": [0, 0.1, 0.2, 1]}, exhaust_a_characteristic=3)
    assert {error.code for error in caught.value.problems} == {"spool.not_covered", "spool.not_a_table"}


def test_switched_valve_with_tables():
    part = valve(function="5/2 monostable")
    assert part.caption(CaptionNumbers(part.parameters(AIR).__getitem__))[:2] == [
        "5/2 monostable", "C and b: tables of the position",
    ]  # fmt: skip


def test_proportional_caption_names_the_setpoint():
    part = valve(setpoint_type="0-10 V")
    assert part.caption(CaptionNumbers(part.parameters(AIR).__getitem__))[-1] == "setpoint: 0-10 V"


@pytest.mark.parametrize(
    ("setpoint_type", "low", "high", "unit"), [("0-10 V", 0.0, 10.0, "V"), ("4-20 mA", 4e-3, 20e-3, "A")]
)
def test_setpoint_types(setpoint_type, low, high, unit):
    part = valve(setpoint_type=setpoint_type)
    (item,) = part.inputs()
    assert (item.low, item.high, item.unit) == (low, high, unit)
    assert part.parameters(AIR)["command"] == pytest.approx(0.5 * (low + high), rel=1e-12)
    assert part.parameters(AIR)["initial_position"] == pytest.approx(0.0, abs=1e-12)
    with refused("fields.out_of_range", "command"):
        valve(setpoint_type=setpoint_type, command=f"{1.1 * high} {unit}")


def test_schema_accepts_tables_and_setpoints():
    fields = circuit_schema()["$defs"]["spool_valve"]["properties"]
    assert "maximum" not in fields["command"]["anyOf"][0]
    assert fields["lag"]["default"] == "5 ms"
    for name in ("characteristic", "exhaust_b_characteristic"):
        assert set(TABLE) <= set(fields[name]["anyOf"][1]["properties"])


def test_an_idle_field_can_be_symbolic():
    from dataclasses import replace

    from poppet.core.symbolic import new_symbol

    part = valve()
    symbol = new_symbol("overlap")
    changed = replace(part, overlap=replace(part.overlap, value=symbol))
    assert changed.parameters(AIR)["overlap"] is symbol

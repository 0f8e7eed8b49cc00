"""New parts of the editor are valid as soon as their ports are connected."""

import pytest

from poppet import parts
from poppet.circuit.file import loads
from poppet.core.errors import InputError
from poppet.edit.document import Document
from poppet.edit.palette import palette
from poppet.edit.starting_values import NOTE, STARTING_VALUES, starting_fields

PLANT = """\
[parts.supply]
kind = "reservoir"
pressure = "6 bar g"

[parts.store]
kind = "chamber"
volume = "1 l"

[parts.outlet]
kind = "chamber"
volume = "1 l"

[parts.hole]
kind = "orifice"
from = "supply"
to = "store"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3

[parts.drain]
kind = "orifice"
from = "outlet"
to = "ambient"
sonic_conductance = "1 dm^3/(s bar)"
critical_ratio = 0.3

[run]
duration = "10 ms"
"""
STORES = ["supply", "store", "outlet"]
ENTRIES = {entry["kind"]: entry for entry in palette()}


def connections(kind):
    """Operations that connect the ports of a new part, or connect the plant to the part."""
    ports = [port for port in ENTRIES[kind]["ports"] if port["required"] or port["type"] == "store"]
    flow = [port["name"] for port in ports if port["type"] in ("port", "tube")]
    operations = [
        {"op": "connect", "port": f"new.{name}", "to": store} for name, store in zip(flow, STORES, strict=False)
    ]
    for k, name in enumerate(port["name"] for port in ports if port["type"] == "store"):
        operations += [
            {"op": "add", "kind": "orifice", "name": f"line_{k}", "fields": starting_fields("orifice")},
            {"op": "connect", "port": f"line_{k}.from", "to": "supply"},
            {"op": "connect", "port": f"line_{k}.to", "to": f"new.{name}" if name else "new"},
        ]
    for name in (port["name"] for port in ports if port["type"] == "body"):
        operations += [
            {"op": "add", "kind": "mass", "name": "load", "fields": starting_fields("mass")},
            {"op": "connect", "port": f"new.{name}", "to": "load"},
        ]
    if kind in ("mass", "guide", "joint"):
        actuator = "muscle" if kind == "joint" else "cylinder"
        operations += [
            {"op": "add", "kind": actuator, "name": "actuator", "fields": starting_fields(actuator)},
            {"op": "connect", "port": "actuator.body", "to": "new"},
        ]
    if kind in ("switch", "pid", "pressure_controller"):
        operations.append({"op": "link", "input": "new.measurement", "output": "store.pressure"})
    return operations


# An FMU needs a file: a new one is invalid until the file exists.
@pytest.mark.parametrize("kind", [kind for kind in ENTRIES if kind != "fmu"])
def test_a_new_part_is_valid_once_its_ports_are_connected(kind):
    new = {"op": "add", "kind": kind, "name": "new", "fields": starting_fields(kind)}
    document = Document(PLANT).apply([new, *connections(kind)])
    assert type(loads(document.text).parts["new"]) is parts.KINDS[kind]


@pytest.mark.parametrize("kind", sorted(STARTING_VALUES.keys() - {"fmu"}))
def test_the_source_of_each_parameter_is_assumed(kind):
    new = {"op": "add", "kind": kind, "name": "new", "fields": starting_fields(kind)}
    document = Document(PLANT).apply([new, *connections(kind)])
    options = ("data", "mode", "function", "outputs", "start", "steps")
    stated = {f"new.{field}" for field in starting_fields(kind) if field not in options}
    numbers = loads(document.text).numbers()
    new_numbers = {address: number for address, number in numbers.items() if address.startswith("new.")}
    assert stated == {address for address, number in new_numbers.items() if number.source.note == NOTE}
    assert {numbers[address].source.kind for address in stated} <= {"assumed"}


def test_all_kinds_of_the_palette_have_starting_values():
    assert set(STARTING_VALUES) == set(ENTRIES)


@pytest.mark.parametrize("fields", [{"volume": 2**70}, {"": 1}, {"volume": None, "a..b": 1}])
def test_fields_that_cannot_be_written_leave_the_text_unchanged(fields):
    with pytest.raises(InputError):
        Document(PLANT).apply([{"op": "add", "kind": "chamber", "fields": fields}])

"""Part `fmu`: its fields, and its inputs and outputs in a circuit; nothing of an FMU is executed."""

from __future__ import annotations

import pytest

import poppet
from poppet import FMU, Circuit
from poppet.core.errors import InputError
from poppet.signals import Steps
from small_fmus import DESCRIPTION, write_fmu


@pytest.fixture
def path(tmp_path):
    text = DESCRIPTION.format(rolls="true", interpolates="true", variable="true")
    return write_fmu(tmp_path / "m.fmu", text.replace('<Real start="0"/>', '<Real start="0" unit="N" max="5"/>', 1))


@pytest.mark.parametrize(
    ("fields", "code", "address"),
    [
        ({"path": None}, "fields.missing", "path"),
        ({"path": 3}, "fields.not_a_name", "path"),
        ({"path": "absent.fmu"}, "files.unreadable", "path"),
        ({"start": {"rat": 1.0}}, "fields.not_an_option", "start.rat"),
        ({"start": {"y": 1.0}}, "fmu.start_of_output", "start.y"),
        ({"start": {"u": "9 N"}}, "fields.out_of_range", "start.u"),
        ({"start": {"u": "9 m"}}, "quantity.other", "start.u"),
        ({"start": 3}, "fmu.no_table", "start"),
        ({"units": {"z": 3}}, "fields.not_a_name", "units.z"),
        ({"units": {"z": "furlong"}}, "unit.unknown", "units.z"),
        ({"units": {"u": "bar"}}, "fmu.unit_stated", "units.u"),
        ({"step": 1e-9}, "fields.out_of_range", "step"),
        ({"coupling": "loose"}, "fields.not_an_option", "coupling"),
    ],
)
def test_invalid_fields(path, fields, code, address):
    with pytest.raises(InputError) as error:
        FMU(**({"path": path} | fields))
    assert error.value.address == address
    assert error.value.code.startswith(code.partition(".")[0])
    if not code.startswith(("quantity", "unit")):
        assert error.value.code == code


def test_only_variables_that_can_be_set_are_suggested(path):
    with pytest.raises(InputError) as error:
        FMU(path, start={"yy": 1})
    names = error.value.facts["suggestion"].valid_names
    assert {"rate", "u"} <= {*names}
    assert "y" not in names


def test_all_errors_are_reported_together(path):
    with pytest.raises(InputError) as error:
        FMU(path, start={"a": 1, "fault": 1}, units={"b": "m"})
    assert [problem.address for problem in error.value.problems] == ["units.b", "start.a"]


def test_names_of_the_fmu_and_of_addresses_are_equivalent(path):
    assert dict(FMU(path, start={"initial[y]": 2.0}).start_) == dict(FMU(path, start={"initial_y": 2.0}).start_)


def test_start_values_can_be_changed(path):
    circuit = Circuit({"a": FMU(path, start={"rate": {"value": 2.0, "source": "measured"}})})
    assert circuit.numbers()["a.start.rate"].source.kind == "measured"
    changed = circuit.with_values({"a.start.rate": 3.0, "a.start.gain": 4.0, "a.step": "1 ms"})
    numbers = changed.numbers()
    assert [numbers[f"a.{name}"].value for name in ("start.rate", "start.gain", "step")] == [3.0, 4.0, 1e-3]
    assert changed.parameters["a.start.u"] == 0.0


def test_units_of_variables(path):
    circuit = Circuit({"a": FMU(path, units={"z": "bar"})})
    assert circuit.inputs["a.z"].unit == "Pa"
    assert circuit.inputs["a.u"].unit == "N"
    assert circuit.inputs["a.u"].high == 5.0


def test_outputs_of_an_fmu_cannot_be_driven(path):
    with pytest.raises(InputError) as error:
        Circuit({"a": FMU(path)}, {"a.y": Steps([0.0], [1.0])})
    assert (error.value.code, error.value.address) == ("fmu.driven_output", "signals.a.y")
    with pytest.raises(InputError) as error:
        Circuit({"a": FMU(path), "b": FMU(path)}, connections={"a.y": "b.y"})
    assert (error.value.code, error.value.address) == ("fmu.driven_output", "connections.a.y")


def test_a_connection_needs_equal_units(path):
    circuit = Circuit({"a": FMU(path), "b": FMU(path)}, connections={"a.u": "b.y"})
    with pytest.raises(InputError) as error:
        _ = circuit.symbolic_model
    assert (error.value.code, error.value.address) == ("wiring.other_unit", "connections.a.u")


def test_a_platform_without_a_binary(path):
    pytest.importorskip("fmpy", reason="running an FMU needs FMPy")
    circuit = Circuit({"a": FMU(path)}).with_values({"run.duration": "1 s"})
    with pytest.raises(InputError) as error:
        circuit.simulate(allow_native=True)
    assert (error.value.code, error.value.address) == ("fmu.no_binary", "a")


def test_paths_are_relative_to_the_circuit_file(path, tmp_path):
    file = tmp_path / "circuit.toml"
    file.write_text('[parts.a]\nkind = "fmu"\npath = "m.fmu"\n', encoding="utf-8")
    assert poppet.load(file).parts["a"].path == str(path)

"""Model descriptions: variables, units, names and limits; nothing of an FMU is executed."""

from __future__ import annotations

import pytest

from poppet.core.errors import InputError
from poppet.cosim import description
from poppet.cosim.description import local_name, read_fmu
from poppet.cosim.fmu_units import unit_of_description, unit_of_text
from small_fmus import write_fmu

HEAD2 = '<fmiModelDescription fmiVersion="2.0" modelName="m" guid="g">'
HEAD3 = '<fmiModelDescription fmiVersion="3.0" modelName="m" instantiationToken="t">'
COSIM = '<CoSimulation modelIdentifier="m"{more}/>'


def fmu2(variables: str, further: str = "", more: str = "") -> str:
    return (
        f"{HEAD2}{COSIM.format(more=more)}{further}<ModelVariables>{variables}</ModelVariables></fmiModelDescription>"
    )


def scalar(name: str, causality: str, kind: str = "Real", reference: int = 1, **attributes: str) -> str:
    text = "".join(f' {key}="{value}"' for key, value in attributes.items())
    return (
        f'<ScalarVariable name="{name}" valueReference="{reference}" causality="{causality}"><{kind}{text}/>'
        "</ScalarVariable>"
    )


@pytest.mark.parametrize(
    ("name", "local"),
    [("force", "force"), ("body.v[1]", "body_v_1"), ("der(x)", "der_x"), ("2nd", "v2nd"), ("...", "v"), ("é", "v")],
)
def test_names_in_addresses(name, local):
    assert local_name(name) == local


def test_equal_names_in_addresses_are_numbered(tmp_path):
    path = write_fmu(
        tmp_path / "m.fmu", fmu2(scalar("a.b", "input") + scalar("a b", "output") + scalar("a_b", "output"))
    )
    assert [v.local for v in read_fmu(path).variables] == ["a_b", "a_b_2", "a_b_3"]


UNITS = """<UnitDefinitions>
  <Unit name="bar"><BaseUnit kg="1" m="-1" s="-2" factor="1e5"/></Unit>
  <Unit name="degC"><BaseUnit K="1" offset="273.15"/></Unit>
  <Unit name="N.m"><BaseUnit kg="1" m="2" s="-2"/></Unit>
  <Unit name="J"><BaseUnit kg="1" m="2" s="-2"/></Unit>
  <Unit name="l/min"/>
  <Unit name="lumen"/>
</UnitDefinitions>"""


def test_values_are_converted_to_si(tmp_path):
    variables = [
        scalar("p", "output", unit="bar"),
        scalar("t", "input", unit="degC", start="20", min="0"),
        scalar("d", "input", unit="degC", start="20", relativeQuantity="true"),
        scalar("torque", "output", unit="N.m"),
        scalar("energy", "output", unit="J"),
        scalar("flow", "output", unit="l/min"),
        scalar("light", "output", unit="lumen"),
    ]
    fmu = {v.name: v for v in read_fmu(write_fmu(tmp_path / "m.fmu", fmu2("".join(variables), UNITS))).variables}
    assert {name: v.unit.name for name, v in fmu.items()} == {
        "p": "Pa", "t": "K", "d": "K", "torque": "N m", "energy": "J", "flow": "m^3/s", "light": "1"
    }  # fmt: skip
    assert fmu["p"].unit.to_si(2.0) == 2e5
    assert fmu["t"].unit.to_si(20.0) == pytest.approx(293.15)
    assert fmu["t"].low == pytest.approx(273.15)
    assert fmu["d"].unit.to_si(20.0) == 20.0
    assert fmu["flow"].unit.from_si(1e-3) == pytest.approx(60.0)


def test_units_of_any_dimension_have_a_name():
    assert unit_of_description("x", {"kg": "1", "m": "2", "s": "-5"}).name == "m^2 kg/s^5"
    assert unit_of_description("x", {"kg": "-1", "s": "-1"}).name == "1/(kg s)"
    assert unit_of_text("mm/s").name == "m/s"


def test_arrays_of_fmi_3(tmp_path):
    variables = """<UInt64 name="n" valueReference="1" causality="structuralParameter" start="2"/>
      <Float64 name="u" valueReference="2" causality="input" start="1 2 3 4"><Dimension start="2"/>
        <Dimension valueReference="1"/></Float64>
      <Float32 name="y" valueReference="3" causality="output" variability="discrete"/>
      <Boolean name="b" valueReference="4" causality="input" start="true"/>"""
    structure = '<ModelStructure><Output valueReference="3" dependencies="2"/></ModelStructure>'
    text = (
        f"{HEAD3}{COSIM.format(more='')}<ModelVariables>{variables}</ModelVariables>{structure}</fmiModelDescription>"
    )
    fmu = read_fmu(write_fmu(tmp_path / "m.fmu", text))
    assert [(v.name, v.start) for v in fmu.inputs] == [
        ("u[1,1]", 1.0), ("u[1,2]", 2.0), ("u[2,1]", 3.0), ("u[2,2]", 4.0), ("b", 1.0)
    ]  # fmt: skip
    assert [v.is_continuous for v in fmu.variables] == [True] * 4 + [False, False]
    assert fmu.feedthrough == {"y": frozenset({"u"})}


BOMB = '<!DOCTYPE x [<!ENTITY a "aaaaaaaaaa"><!ENTITY b "&a;&a;&a;&a;">]>'


@pytest.mark.parametrize(
    ("text", "code"),
    [
        (BOMB + fmu2(""), "fmu.description"),
        ("<fmiModelDescription", "fmu.description"),
        (fmu2('<ScalarVariable valueReference="1" causality="input"><Real/></ScalarVariable>'), "fmu.description"),
        (fmu2(scalar("u", "input", start="x")), "fmu.description"),
        (HEAD2.replace("2.0", "1.0") + "</fmiModelDescription>", "fmu.version"),
        ("<other/>", "fmu.version"),
        (HEAD2 + '<ModelExchange modelIdentifier="m"/></fmiModelDescription>', "fmu.no_cosimulation"),
        (fmu2("").replace('"m"/>', '"../m"/>'), "deploy.fmu.identifier"),
        (fmu2("".join(scalar(f"u{k}", "input") for k in range(1001))), "fmu.variables"),
    ],
)
def test_invalid_descriptions(tmp_path, text, code):
    with pytest.raises(InputError) as error:
        read_fmu(write_fmu(tmp_path / "m.fmu", text))
    assert error.value.code == code


def test_limits_of_size(tmp_path, monkeypatch):
    path = write_fmu(tmp_path / "m.fmu", fmu2("".join(scalar(f"u{k}", "local") for k in range(100))))
    monkeypatch.setattr(description, "MAX_ELEMENTS", 50)
    with pytest.raises(InputError) as error:
        read_fmu(path)
    assert error.value.code == "fmu.description"
    monkeypatch.setattr(description, "MAX_DESCRIPTION", 100)
    with pytest.raises(InputError) as error:
        read_fmu(path)
    assert error.value.code == "fmu.description_size"


@pytest.mark.parametrize("entry", ["../outside", "/absolute", "a/../../b", "c:\\x"])
def test_paths_out_of_the_archive(tmp_path, entry):
    with pytest.raises(InputError) as error:
        read_fmu(write_fmu(tmp_path / "m.fmu", fmu2(""), {entry: b""}))
    assert error.value.code == "deploy.fmu.entry_path"


def test_a_changed_file_is_read_again(tmp_path):
    path = write_fmu(tmp_path / "m.fmu", fmu2(scalar("u", "input")))
    assert [v.name for v in read_fmu(path).variables] == ["u"]
    write_fmu(path, fmu2(scalar("another", "input")))
    assert [v.name for v in read_fmu(path).variables] == ["another"]

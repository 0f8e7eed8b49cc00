"""The recipes of CONTRIBUTING.md, each followed with a toy: the places that they list are all that is touched."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any, ClassVar

import casadi as ca
import numpy as np
import pytest

import poppet
from poppet import identify, library, loads
from poppet.circuit.schema import circuit_schema
from poppet.cli import main
from poppet.cli.main import run
from poppet.core import message_format
from poppet.core.command_options import Option
from poppet.core.errors import ErrorCollector, InputError, OutOfRangeError
from poppet.core.plugins import import_object
from poppet.core.provenance import printed
from poppet.core.symbolic import where
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.deploy.export_model import build_export_model
from poppet.deploy.parity.parity_check import KernelReference, ParityCheck, TargetResult
from poppet.deploy.parity.parity_table import compare_targets
from poppet.deploy.targets import TARGETS, CircuitSource, Export, Target
from poppet.identify import Estimate, Result
from poppet.identify.methods import METHODS, Method
from poppet.laws.iso6358.domain import Domain, check
from poppet.library import gases
from poppet.parts import KINDS
from poppet.parts.fields import NumberLike, number, port
from poppet.parts.part import Flow, GasState, Passage, PassageFlows, Scope
from poppet.report.html_page import Section, document, findings, write_page
from poppet.report.tables import ReportTable
from poppet.timeseries.tables import reading
from poppet.timeseries.tables.table import Table

GUIDE = (Path(__file__).parents[2] / "CONTRIBUTING.md").read_text(encoding="utf-8")

# A law: one function of floats, arrays and symbols, with the range in which it holds.

PERMEANCE = Domain("toy.permeance", "kg/(s Pa)")


def permeation(pressure_1: Any, pressure_2: Any, permeance: Any) -> Any:
    """Mass flow rate through a membrane, proportional to the pressure drop, and blocked backwards."""
    check({"permeance": permeance}, {"permeance": PERMEANCE})
    drop = pressure_1 - pressure_2
    return permeance * where(drop > 0.0, drop, 0.0 * drop)


# A part: one frozen dataclass, and one line in the register.


@dataclass(frozen=True)
class Membrane(Passage):
    """A membrane between two stores."""

    kind: ClassVar[str] = "membrane"
    summary: ClassVar[str] = "a toy"

    from_: str | None = port("store at the first port")
    to: str | None = port("store at the second port")
    permeance: NumberLike = number("kg/(s Pa)", 1e-9, doc="permeance", low=0.0, note="a toy")

    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        flow = permeation(gas["from"].pressure, gas["to"].pressure, scope["permeance"])
        enthalpy = scope.surroundings.heat_capacity_pressure * gas["from"].temperature * flow
        return PassageFlows((Flow("flow", "from", "to", flow, enthalpy),), {"mass_flow_rate": (flow, "kg/s")})


SIZE = 'sonic_conductance = "1 dm^3/(s bar)"\ncritical_ratio = 0.3'
CIRCUIT = """
[parts.supply]
kind = "reservoir"
pressure = "2 bar"
[parts.skin]
kind = "membrane"
from = "supply"
to = "tank"
[parts.tank]
kind = "chamber"
volume = "1 l"
thermal = "isothermal"
[run]
duration = "10 s"
"""


def test_a_law(monkeypatch):
    assert "## Adding a law" in GUIDE
    drops = np.array([-1e5, 0.0, 1e5])
    values = permeation(2e5 + drops, 2e5, 1e-9)
    assert values.tolist() == [permeation(2e5 + drop, 2e5, 1e-9) for drop in drops] == [0.0, 0.0, pytest.approx(1e-4)]
    p1, p2 = ca.SX.sym("p1"), ca.SX.sym("p2")
    traced = ca.Function("f", [p1, p2], [permeation(p1, p2, 1e-9)])
    assert [float(traced(2e5 + drop, 2e5)) for drop in drops] == values.tolist()
    words = {"permeance": {"given": "{address} = {value:g} {unit}", "reason": "cannot be.", "hint": "Give more."}}
    monkeypatch.setattr(message_format, "_templates", lambda topic: {"toy": words}[topic])
    with pytest.raises(OutOfRangeError) as caught:
        permeation(2e5, 1e5, -1.0)
    assert (caught.value.code, caught.value.address, caught.value.facts["value"]) == (
        "toy.permeance",
        "permeance",
        -1.0,
    )
    assert str(caught.value) == "permeance = -1 kg/(s Pa) cannot be. Give more."


def test_a_part(monkeypatch):
    assert "## Adding a part" in GUIDE
    monkeypatch.setitem(KINDS, "membrane", Membrane)
    circuit = loads(CIRCUIT)
    recording = circuit.simulate()
    # dp/dt = R T K (2 bar - p) / V, from 1 bar
    rate = 287.05 * 293.15 * 1e-9 / 1e-3
    assert recording["tank.pressure"][-1] == pytest.approx(2e5 - 1e5 * np.exp(-10.0 * rate), rel=1e-5)
    assert all(residual.is_kept for residual in recording.residuals)
    assert circuit.numbers()["skin.permeance"].source.kind == "assumed"
    faster = circuit.with_values({"skin.permeance": "2e-9 kg/(s Pa)"}).simulate()
    assert faster["tank.pressure"][-1] > recording["tank.pressure"][-1]
    assert '"membrane"' in str(circuit_schema()).replace("'", '"')
    assert circuit.linearise(at=recording).A.shape[0] == len(circuit.model.states)


def test_a_gas(monkeypatch):
    assert "## Adding a gas" in GUIDE
    toy = gases._from_molar_mass("toy gas", 0.05, 1.25, gases.NOT_FOR_THIS, gases.GASES["argon"].real)
    monkeypatch.setattr(gases, "GASES", {**gases.GASES, toy.name: toy})
    assert "toy gas" in library.gas_names()
    assert library.gas("Toy_Gas") is toy
    assert "toy gas: an ideal gas" in library.describe("toy gas")
    circuit = loads('[gas]\nname = "toy gas"\n' + CIRCUIT.replace('kind = "membrane"', 'kind = "orifice"\n' + SIZE))
    assert circuit.surroundings.gas_constant == pytest.approx(8.314462618 / 0.05)
    assert circuit.numbers()["gas.gas_constant"].source.kind == "standard"


def test_a_parameter_set(monkeypatch):
    assert "## Adding a parameter set" in GUIDE
    volume = printed(7e-6, "m^3", "a toy, page 1")
    toy = library.ParameterSet(
        "a toy", {"pilot_stage": {"": library.numbers("vppm_6l", "pilot_stage") | {"volume": volume}}}
    )
    monkeypatch.setitem(library._SETS, "toy_set", toy)
    assert "toy_set" in library.sets()
    pilot = poppet.PilotStage(supply="supply", exhaust="ambient", data="toy_set")
    assert pilot.volume == volume
    assert replace(pilot, data="vppm_6l").volume == library.numbers("vppm_6l", "pilot_stage")["volume"]


def test_a_format_of_recordings(monkeypatch, tmp_path):
    assert "## Adding a format of recordings" in GUIDE

    def read(path: Path) -> Table:
        rows = np.array([[float(cell) for cell in line.split("|")] for line in path.read_text().splitlines()])
        return Table(("t", "p"), tuple(rows.T), ("s", "bar"))

    monkeypatch.setitem(reading.READERS, ".toy", read)
    (tmp_path / "bench.toy").write_text("0|1.5\n1|2.5\n")
    found = reading.read_table(tmp_path / "bench.toy")
    assert (found.names, found.units, found.columns[1].tolist()) == (("t", "p"), ("s", "bar"), [1.5, 2.5])


def test_a_report(tmp_path):
    assert "## Adding a report" in GUIDE
    recording = poppet.Recording.from_series([0.0, 1.0], {"p [bar]": [1.0, 2.0]}, notes=("Cold & wet.",))

    def page() -> str:
        rows = [[name, f"{recording[name].max():g}"] for name in recording]
        highest = Section("Highest", ReportTable(("series", "value"), rows))
        return document("Toy", [highest, Section("Notes", findings(recording.remarks))])

    text = write_page(tmp_path / "toy.html", page).read_text(encoding="utf-8")
    assert "<td>2</td>" in text.replace(' class="number"', "")
    assert "Cold &amp; wet." in text


def export_names(circuit: Any, source: CircuitSource, *, separator: str | None = None) -> Export:
    """Export the addresses of the parameters."""
    export_model = build_export_model(circuit)
    addresses = [parameter.address for parameter in export_model.parameters if parameter.is_free]
    return Export({"names.txt": (separator or "\n").join(addresses)}, f"{len(addresses)} parameters")


def run_toy(reference: KernelReference, folder: Path) -> TargetResult:
    """Return the values of the kernel as those of the target."""
    return TargetResult(reference.rows.values, 1.0)


NAMES = Target(
    "names",
    "export the addresses of the parameters",
    export_names,
    (Option("--separator TEXT", "separator of the addresses"),),
    ("poppet export names tank.toml -o names.txt",),
    (".txt",),
    limitations=("Parameters on which others depend are omitted.",),
    checks=lambda: [ParityCheck("names", "a toy", 1e-9, "all", run_toy)],
)


def test_an_export_target(monkeypatch, tmp_path, capsys):
    assert "## Adding an export target" in GUIDE
    monkeypatch.chdir(tmp_path)
    monkeypatch.setitem(TARGETS, "names", NAMES)
    Path("tank.toml").write_text(CIRCUIT.replace("membrane", 'orifice"\neffective_area = "1 mm^2'), encoding="utf-8")
    assert run(["export", "names", "tank.toml", "--set", "tank.volume=2 l", "--separator", ",", "-o", "names.txt"]) == 0
    assert capsys.readouterr().out == "11 parameters\nnames.txt: written.\n"
    assert "tank.volume" in Path("names.txt").read_text(encoding="utf-8").split(",")
    assert run(["export", "names", "--help"]) == 0
    text = capsys.readouterr().out
    assert "Parameters on which others depend are omitted." in text
    assert text.endswith("  poppet export names tank.toml -o names.txt\n")
    assert run(["export"]) == 2
    assert "export the addresses" in capsys.readouterr().out
    (row,) = compare_targets(poppet.load("tank.toml"), only=["names"]).rows
    assert (row.verdict, row.greatest) == ("within", 0.0)


def test_a_printer():
    """Its toy is the reader in C of the tests of the engine."""
    assert "## Adding a printer for the model" in GUIDE
    reader = Path(__file__).parents[1] / "unit" / "engine" / "test_second_printer.py"
    assert "poppet.engine.printers.instructions" in reader.read_text(encoding="utf-8")
    assert str(reader.relative_to(Path(__file__).parents[2]).as_posix()) in GUIDE


# An identification method: declarations of the fields of its file, a reader, a function and one declaration.

LEAK_FIELDS = {
    "title": Field(type="text", default="Leak test"),
    "volume": Field(unit="m^3", above=0.0, is_required=True, example='volume = "2 l"'),
    "rates": Field(is_required=True, meaning="list of pressure rates", example="rates = [-10.0, -11.0]"),
}


def read_leak_file(path: Path) -> dict[str, Any]:
    """Read a leak test."""
    file = TomlFile.read(path)
    with file.errors() as errors:
        return read_fields(errors, file.content, LEAK_FIELDS, table="leak test file")


def identify_leak(path: Path) -> Result:
    """Identify the leak of a closed volume from its pressure rates [Pa/s]."""
    fields = read_leak_file(path)
    flows = -fields["volume"] * np.array(fields["rates"]) / (287.05 * 293.15)
    mean, error = float(np.mean(flows)), float(np.std(flows, ddof=1) / np.sqrt(flows.size))
    estimate = Estimate(mean, "kg/s", error, mean - 2.0 * error, mean + 2.0 * error, "determined")
    return Result("leak", fields["title"], {"tank.leak": estimate})


LEAK = Method(
    "leak",
    "leak of a closed volume",
    run=identify_leak,
    read=read_leak_file,
    fields=LEAK_FIELDS,
    description="Leak of a closed volume from pressure rates.",
    intervals="The interval is two standard errors of the mean.",
)


def test_an_identification_method(monkeypatch, tmp_path, capsys):
    assert "## Adding an identification method" in GUIDE
    monkeypatch.setitem(METHODS, "leak", LEAK)
    path = tmp_path / "leak.toml"
    path.write_text('volume = "2 l"\nrates = [-10.0, -12.0, -11.0]\n')
    result, page = tmp_path / "result.toml", tmp_path / "leak.html"
    assert main.run(["identify", "leak", str(path), "-o", str(result), "--report", str(page)]) == 0
    assert "tank.leak" in capsys.readouterr().out
    assert identify.read_result(result).parameters["tank.leak"].value == pytest.approx(2e-3 * 11.0 / (287.05 * 293.15))
    text = page.read_text(encoding="utf-8")
    assert LEAK.description in text
    assert LEAK.intervals in text
    assert main.run(["identify", "--help"]) == 0
    assert "leak of a closed volume" in " ".join(capsys.readouterr().out.split())
    assert LEAK.file_schema()["properties"]["volume"]["description"] == "[m^3]"
    path.write_text('volum = "2 l"\nrates = [-10.0, -12.0]\n')
    with pytest.raises(InputError) as caught:
        METHODS["leak"].identify(path)
    assert [(problem.code, problem.line) for problem in caught.value.problems] == [("fields.unknown", 1)]
    with pytest.raises(InputError) as caught, ErrorCollector() as errors:
        read_fields(errors, {"volume": "-2 l"}, LEAK_FIELDS)
    assert {problem.code for problem in caught.value.problems} == {"fields.out_of_range", "fields.missing"}


def test_every_method_has_its_functions_and_a_schema():
    for name, method in METHODS.items():
        for reference in (method.run, method.read, method.report, method.text):
            assert callable(import_object(reference)), (name, reference)
        properties = method.file_schema()["properties"]
        assert "title" in properties, name

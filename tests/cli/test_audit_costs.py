"""Cost, leaks and savings in `poppet audit energy`; `poppet audit leaks`."""

from __future__ import annotations

import json
import tomllib
from pathlib import Path

import pytest

EXAMPLES = Path(__file__).parents[2] / "examples"
MACHINE = str(EXAMPLES / "two_cylinders.toml")
AUDIT = """
[audit]
tariff = { value = "0.02 CHF/m^3", source = "measured", locator = "bill" }
hours = "1000 h"
"""


def test_the_result_has_cost_leaks_and_savings(poppet, tmp_path):
    output, report = tmp_path / "result.toml", tmp_path / "energy.html"
    code, out, _ = poppet(
        "audit", "energy", MACHINE, "--tariff", "0.20 EUR/kWh", "--emission", "0.4 kg/kWh", "--hours", "2000 h",
        "--leak", "valveA.supply_a", "--saving", "cylinderA.bore=25 mm, cylinderB.bore=32 mm", "-o", str(output),
        "--report", str(report),
    )  # fmt: skip
    assert code == 0
    content = tomllib.loads(output.read_text(encoding="utf-8"))
    cycle = content["cycle"]
    energy = cycle["air_l_anr"] * 1e-3 * 0.12  # kWh
    assert cycle["cost"] == pytest.approx(0.20 * energy, rel=1e-12)
    assert cycle["co2_kg"] == pytest.approx(0.4 * energy, rel=1e-12)
    assert cycle["currency"] == "EUR"
    (leak,) = content["leaks"]
    assert leak["cost_per_year"] == pytest.approx(
        leak["air_l_anr_per_min"] * 1e-3 * 60.0 * 2000.0 * 0.12 * 0.20, rel=1e-9
    )
    saving, bound = content["savings"]
    assert saving["measure"] == "cylinderA.bore=25 mm, cylinderB.bore=32 mm"
    assert 0.0 < saving["air_l_anr"] < cycle["air_l_anr"]
    assert saving["cost_per_year"] == pytest.approx(
        saving["air_l_anr"] * 1e-3 * 0.12 * 0.20 * 2000.0 * 3600.0 / cycle["duration_s"], rel=1e-9
    )
    assert (saving["is_bound"], bound["is_bound"]) == (False, True)
    assert "reuse of exhaust air, upper bound" in out
    assert "<h2>Savings</h2>" in report.read_text(encoding="utf-8")


def test_a_named_leak_is_not_reusable_exhaust_air(poppet, tmp_path):
    output = tmp_path / "result.json"
    bounds = []
    for options in ((), ("--leak", "valveA.exhaust_a")):
        assert (
            poppet("audit", "energy", MACHINE, "--saving", "cylinderA.bore=25 mm", "-o", str(output), *options)[0] == 0
        )
        content = json.loads(output.read_text(encoding="utf-8"))
        bounds.append(content["savings"][-1]["exergy_j"])
    (path,) = (row for row in content["flow_paths"] if row["name"] == "valveA.exhaust_a_mass_flow_rate")
    assert bounds[0] - bounds[1] == pytest.approx(path["throttling_j"], rel=1e-9)


def test_the_circuit_file_has_a_tariff_that_options_override(poppet, tmp_path):
    file, output = tmp_path / "machine.toml", tmp_path / "result.json"
    file.write_text(Path(MACHINE).read_text(encoding="utf-8") + AUDIT, encoding="utf-8")
    command = ("audit", "energy", str(file), "--no-savings", "-o", str(output))
    costs = []
    for options in ((), ("--tariff", "0.06 CHF/m^3")):
        assert poppet(*command, *options)[0] == 0
        content = json.loads(output.read_text(encoding="utf-8"))
        assert content["savings"] == []
        costs.append(content["cycle"]["cost"])
    assert costs[1] == pytest.approx(3.0 * costs[0], rel=1e-9)
    assert "in 1000 h" in poppet(*command)[1]


@pytest.mark.parametrize(
    ("options", "message"),
    [
        (("--tariff", "0.20"), "the unit to which the price refers"),
        (("--tariff", "0.20 EUR/kW"), "requires a unit of energy"),
        (("--tariff", "3"), "--tariff = '3' must consist of"),
        (("--emission", "0.4"), "--emission = 0.4 has no unit"),
        (("--specific-energy", "0 kWh/m^3"), "--specific-energy = 0 kWh/m^3 is out of range"),
        (("--leak", "valveA.supply"), "Did you mean valveA.supply_"),
        (("--saving", "cylinderA.bore"), "--saving"),
    ],
)
def test_invalid_options_are_rejected_before_a_result_is_written(poppet, tmp_path, options, message):
    output = tmp_path / "result.toml"
    code, _, errors = poppet("audit", "energy", MACHINE, "-o", str(output), *options)
    assert code == 2
    assert message in errors
    assert not output.exists()


def test_an_invalid_tariff_of_a_file_is_rejected_with_its_line(poppet, tmp_path):
    file = tmp_path / "machine.toml"
    text = Path(MACHINE).read_text(encoding="utf-8") + AUDIT.replace("0.02 CHF/m^3", "0.02")
    file.write_text(text, encoding="utf-8")
    line = next(number for number, line in enumerate(text.splitlines(), 1) if line.startswith("tariff"))
    for command in (("audit", "energy"), ("check",)):
        code, _, errors = poppet(*command, str(file))
        assert code == 2
        assert f"machine.toml:{line}: audit.tariff" in errors


def test_a_survey_is_printed_and_written(poppet, tmp_path):
    output = tmp_path / "survey.toml"
    code, out, _ = poppet("audit", "leaks", str(EXAMPLES / "audit" / "leak_survey.toml"), "-o", str(output))
    assert code == 0
    content = tomllib.loads(output.read_text(encoding="utf-8"))
    assert content["leaks"][0]["leak"] == "hole_in_pipe"
    assert f"{content['total']['cost_per_year']:.2f}" in out
    assert "saves 40 % of the electricity" in out


def test_a_survey_without_price_shows_no_cost(poppet, tmp_path):
    file = tmp_path / "survey.toml"
    file.write_text('[leaks.a]\nmethod = "estimate"\nflow = "30 l/min ANR"\n', encoding="utf-8")
    code, out, _ = poppet("audit", "leaks", str(file))
    assert code == 0
    assert "30.00" in out
    assert "cost" not in out


def test_a_misspelt_measure_is_an_error(poppet):
    code, out, err = poppet("audit", "energy", MACHINE, "--saving", "cylinderA.boore=25 mm")
    assert (code, out) == (2, "")
    assert "cylinderA.boore" in err
    assert "cylinderA.bore" in err

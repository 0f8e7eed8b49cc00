"""Files of leak surveys: all methods with units, and all errors with their lines."""

from __future__ import annotations

from pathlib import Path

import pytest

from poppet.audit.leak_file import read_survey
from refusals import refused

EXAMPLE = Path(__file__).parents[3] / "examples" / "audit" / "leak_survey.toml"
AMO = """
ambient_pressure = "14.7 psi"
[audit]
tariff = "0.12 USD/kWh"
specific_energy = "339.0075988 kW/(m^3/min)"
hours = "8640 h"
"""
METHODS = {
    "estimate": ('flow = "2.8316846592 l/min ANR"', 0.1),
    "bag": ('diameter = "10 in"\nheight = "15 in"\nfill_time = "12 s"\ncount = 2', 6.8176923906),
    "decibel": (
        'pressure = "130 psi g"\nlevel = 25\npressures = ["150 psi g", "125 psi g"]\nlevels = [20, 30]\n'
        'flows = [["29.44952045568 l/min ANR", "33.9802159104 l/min ANR"], '
        '["52.3861661952 l/min ANR", "46.7227968768 l/min ANR"]]',
        1.429,
    ),
    "orifice": (
        'diameter = "0.375 in"\npressure = "100 psi g"\ntemperature = "550 degF"\n'
        "discharge_coefficient = 1.0\ncount = 4",
        1295.1250307181,
    ),
}


def survey(tmp_path, text):
    path = tmp_path / "survey.toml"
    path.write_text(text, encoding="utf-8")
    return read_survey(path)


@pytest.mark.parametrize("method", METHODS)
def test_each_method_gives_the_flow_of_amo_tools(tmp_path, method):
    fields, cfm = METHODS[method]
    result = survey(tmp_path, f'{AMO}[leaks.a]\nmethod = "{method}"\n{fields}\n')
    assert result.total.flow * 60.0 / 0.3048**3 == pytest.approx(cfm, rel=1e-9)


def test_the_example_sums_its_leaks():
    result = read_survey(EXAMPLE)
    assert {row.leak.method for row in result.leaks} == set(METHODS)
    content = result.content()
    for key in ("air_l_anr_per_min", "cost_per_year", "co2_kg_per_year", "saved_cost_per_year"):
        assert content["total"][key] == pytest.approx(sum(row[key] for row in content["leaks"]), rel=1e-12)
    assert content["leaks"][1]["air_l_anr_per_min"] == pytest.approx(90.0)


def test_all_errors_of_a_file_have_their_line(tmp_path):
    text = """titel = "a"
[audit]
tariff = "0.2"
[leaks.a]
count = 0
[leaks.b]
method = "bag"
diameter = "1 bar"
height = "1 m"
fill_time = "1 s"
[leaks.c]
method = "decibel"
pressure = "6 bar g"
level = 25
pressures = ["5 bar g"]
levels = [20, 30]
flows = [["1 l/min ANR", "2 l/min ANR"], ["3 l/min ANR", "4 l/min ANR"]]
[leaks.d]
method = "orifice"
diameter = "1 mm"
pressure = "0.5 bar g"
[leaks.e]
method = "orfice"
"""
    with refused("fields.unknown", "titel") as caught:
        survey(tmp_path, text)
    assert [(problem.code, problem.address, problem.line) for problem in caught.value.problems] == [
        ("fields.unknown", "titel", 1),
        ("tariff.no_unit", "audit.tariff", 3),
        ("fields.missing", "leaks.a.method", 4),
        ("quantity.other_quantity", "leaks.b.diameter", 8),
        ("leaks.no_pair", "leaks.c.pressures", 15),
        ("leaks.not_choked", "leaks.d.pressure", 21),
        ("fields.not_an_option", "leaks.e.method", 23),
    ]


def test_a_flow_without_reference_state_is_rejected(tmp_path):
    with refused("quantity.flow_without_state", "leaks.a.flow"):
        survey(tmp_path, '[leaks.a]\nmethod = "estimate"\nflow = "30 l/min"\n')


@pytest.mark.parametrize("text", ['title = "a"\n', "[leaks]\n"])
def test_a_survey_has_leaks(tmp_path, text):
    with refused("fields.missing", "leaks"):
        survey(tmp_path, text)


def test_a_leak_is_a_table(tmp_path):
    with refused("fields.no_table", "leaks.a"):
        survey(tmp_path, '[leaks]\na = "30 l/min ANR"\n')

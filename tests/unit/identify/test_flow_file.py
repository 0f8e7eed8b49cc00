"""Tests of flow bench files: units, uncertainties, and the line of each error."""

from __future__ import annotations

import pytest

from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputErrors
from poppet.identify.flow.flow_file import read_flow_file
from poppet.identify.flow.identify_flow import identify_flow
from poppet.identify.flow.points import Instrument
from refusals import refused

TEXT = """\
title = "valve A"
part = "outlet"
file = "points.csv"
mass_flow_rate = { column = "q", unit = "l/min ANR", relative_uncertainty = 0.01, calibration = 0.005 }
pressure_1 = { column = "p1", unit = "bar g", uncertainty = "2 kPa", offset = "1 kPa" }
pressure_2 = { column = "p2" }
temperature_1 = { value = "20 degC", uncertainty = "1 K" }
ambient_pressure = "1.013 bar"
subsonic_index = 0.5
cracking_pressure = "0 Pa"
"""
POINTS = "q;p1;p2 [bar]\n1200,0;9,0;0,5\n1200,0;9,0;1,013\n1200,0;9,0;2,0\n1000,0;9,0;7,0\n700,0;9,0;9,0\n"


@pytest.fixture
def write_file(tmp_path):
    def write(text=TEXT, points=POINTS):
        (tmp_path / "points.csv").write_text(points, encoding="utf-8")
        (tmp_path / "flow.toml").write_text(text, encoding="utf-8")
        return tmp_path / "flow.toml"

    return write


def test_file_gives_points_in_si_units_with_uncertainties(write_file):
    points, options = read_flow_file(write_file())
    assert points.mass_flow_rate[0] == pytest.approx(1.2 * 1.185 / 60.0)
    assert points.pressure_1 == pytest.approx([10.013e5] * 5)
    assert points.pressure_2[:2] == pytest.approx([0.5e5, 1.013e5])
    assert points.temperature_1 == pytest.approx([293.15] * 5)
    assert points.u_mass_flow_rate == Instrument(relative=0.01, calibration=0.005)
    assert points.u_pressure_1 == Instrument(absolute=2e3, offset=1e3)
    assert points.u_pressure_2 == Instrument()
    assert points.u_temperature_1 == Instrument(offset=1.0)  # one value for all points
    assert {k: options[k] for k in ("title", "part", "subsonic_index", "cracking_pressure")} == {
        "title": "valve A",
        "part": "outlet",
        "subsonic_index": 0.5,
        "cracking_pressure": 0.0,
    }


def test_options_of_a_file_are_arguments_of_identify_flow(write_file):
    points, options = read_flow_file(write_file(TEXT.replace("= 0.5\n", '= "free"\n').replace('"0 Pa"', '"free"')))
    assert options["subsonic_index"] == options["cracking_pressure"] == "free"
    result = identify_flow(points, **{**options, "cracking_pressure": 0.0})
    assert result.title == "valve A"
    assert "outlet.subsonic_index" in result.parameters
    assert set(notes_of(options["notes"])) <= set(result.remarks)


def test_path_gives_the_result_of_its_points_and_keywords_override_it(write_file):
    points, options = read_flow_file(path := write_file())
    assert points.lines == [2, 3, 4, 5, 6]
    assert identify_flow(path).content() == identify_flow(points, **options).content()
    assert identify_flow(points=str(path), title="another").title == "another"


def test_barometer_affects_only_gauge_pressures(write_file):
    text = TEXT + 'ambient_pressure_uncertainty = "0.5 kPa"\n'
    points, _ = read_flow_file(write_file(text))
    assert points.u_ambient_pressure == 0.0
    assert points.u_pressure_1.offset == pytest.approx((1e6 + 0.25e6) ** 0.5)
    two_gauge_pressures = text.replace('column = "p2"', 'column = "p2", unit = "bar g"')
    points, _ = read_flow_file(write_file(two_gauge_pressures))
    assert points.u_ambient_pressure == 500.0
    assert points.u_pressure_1.offset == 1e3


def test_assumed_ambient_pressure_is_noted(write_file):
    _, options = read_flow_file(write_file(TEXT.replace('ambient_pressure = "1.013 bar"\n', "")))
    assert options["notes"][-1] == Note("flow.ambient_assumed", "ambient_pressure", uncertainty_kpa=2.0)
    _, options = read_flow_file(write_file())
    assert "flow.ambient_assumed" not in [note.code for note in notes_of(options["notes"])]


@pytest.mark.parametrize(
    ("unit", "read"), [("l/min", "l/min ANR"), ("slpm", "l/min N"), ("Nl/min", None), ("l/min ANR", None)]
)
def test_ambiguous_flow_unit_is_noted(write_file, unit, read):
    points, options = read_flow_file(write_file(TEXT.replace('unit = "l/min ANR"', f'unit = "{unit}"')))
    reference, _ = read_flow_file(write_file(TEXT.replace('unit = "l/min ANR"', f'unit = "{read or unit}"')))
    assert points.mass_flow_rate.tolist() == reference.mass_flow_rate.tolist()
    notes = [note for note in notes_of(options["notes"]) if note.code == "doubt.read_as"]
    assert notes == ([Note("doubt.read_as", "mass_flow_rate", unit=unit, read=read)] if read else [])


@pytest.mark.parametrize(
    ("old", "new", "line", "message"),
    [
        ('unit = "l/min ANR"', 'unit = "l"', 4, "quantity.other_quantity"),
        ('column = "p1"', 'column = "p_1"', 5, "table.misspelt"),
        ('uncertainty = "2 kPa"', 'uncertainty = "2 kPa g"', 5, "quantity.gauge_difference"),
        ("calibration = 0.005", "calibraton = 0.005", 4, "fields.unknown"),
        ('{ column = "p2" }', '"p2"', 6, "fields.no_table"),
        ('{ column = "p2" }', '{ unit = "bar" }', 6, "flow.column_or_value"),
        ('"20 degC", uncertainty', '"20 bar", uncertainty', 7, "quantity.other_quantity"),
        ('"1.013 bar"', '"1.013 bar g"', 8, "options.gauge_ambient"),
        ("subsonic_index = 0.5", 'subsonic_index = "half"', 9, "quantity.no_number"),
        ("subsonic_index = 0.5", "subsonc_index = 0.5", 9, "fields.unknown"),
        (
            "relative_uncertainty = 0.01",
            "relative_uncertainty = -0.01",
            4,
            "fields.out_of_range",
        ),
        ('"1 kPa"', '"1 K"', 5, "quantity.other_quantity"),
    ],
)
def test_each_error_has_its_line(write_file, old, new, line, message):
    assert old in TEXT
    with refused(message) as caught:
        read_flow_file(write_file(TEXT.replace(old, new)))
    assert caught.value.line == line
    assert caught.value.file.endswith("flow.toml")


def test_all_errors_of_a_file_are_raised_together(write_file):
    with pytest.raises(InputErrors) as caught:
        read_flow_file(write_file("titel = 1\nmass_flow_rate = 3\n"))
    assert {(problem.code, problem.address) for problem in caught.value.problems} >= {
        ("fields.unknown", "titel"),
        ("fields.missing", "file"),
        ("fields.missing", "pressure_1"),
        ("fields.no_table", "mass_flow_rate"),
    }


def test_missing_unit_is_rejected(write_file):
    with refused("flow.no_unit", "pressure_2"):
        read_flow_file(write_file(points=POINTS.replace(" [bar]", "")))


def test_invalid_toml_is_rejected(write_file):
    with refused("toml.invalid"):
        read_flow_file(write_file("file = "))

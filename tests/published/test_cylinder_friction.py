"""Friction and leaks of a 25 mm cylinder (EvaZillen/3D-printed-pneumatic-actuator, CC0), as in docs/friction.md."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from poppet.core.number_format import scaled
from poppet.identify import Result, TankTest, identify_friction, identify_tank

DATA = Path(__file__).resolve().parents[3] / "shared" / "data" / "cylinder_25mm"
PAGE = (Path(__file__).resolve().parents[2] / "docs" / "friction.md").read_text(encoding="utf-8")
pytestmark = pytest.mark.skipif(not DATA.is_dir(), reason="the measured data are not beside this checkout")


@pytest.fixture(scope="module")
def result(tmp_path_factory) -> Result:
    return identify_page_file(tmp_path_factory.mktemp("friction"))


def identify_page_file(folder: Path) -> Result:
    """Return the result of the file that the page shows."""
    (text,) = re.findall(r"^```toml\n(.*?)^```$", PAGE, re.MULTILINE | re.DOTALL)
    file = folder / "friction.toml"
    file.write_text(text.replace('"friction_oring', f'"{DATA}/friction_oring'))
    return identify_friction(file)


def test_estimates_equal_those_of_the_page(result):
    assert (result.comparison["law"], result.comparison["levels"]) == ("lugre", "coulomb")
    rows = {
        name: (value, ends) for name, value, ends in re.findall(r"^\| `(\w+)` \| ([\d.]+) N.*? \| (.*?) N", PAGE, re.M)
    }
    units = {"coulomb_force": "N", "seal_friction": "N/bar", "bristle_stiffness": "N/mm"}
    assert rows.keys() == units.keys()
    for address, estimate in result.parameters.items():
        name = address.rpartition(".")[2]
        value, ends = rows[name]
        printed = [float(value), *map(float, ends.split(" ... "))]
        unit = units[name]
        assert [scaled(v, estimate.unit, unit) for v in (estimate.value, estimate.low, estimate.high)] == pytest.approx(
            printed, rel=0.03
        )
        assert estimate.verdict == ("not determined" if name == "coulomb_force" else "weak")


def test_parameters_without_evidence_are_not_determined(result):
    bounds = {note.address: note.facts for note in result.remarks if note.code == "friction.bounded"}
    assert bounds["friction.viscous_coefficient"]["verdict"] == "not determined"
    assert bounds["friction.stribeck_velocity"]["verdict"] == "not determined"
    (coarse,) = [note.facts for note in result.remarks if note.code == "friction.damping_coarse"]
    assert (coarse["step"], coarse["high"]) == pytest.approx((0.01, 780.0), rel=0.02)
    assert "slide.friction.bristle_damping" not in result.parameters
    codes = {note.code for note in result.remarks}
    assert {"friction.narrow", "friction.sides_open", "friction.places", "friction.bristles"} <= codes


def test_half_the_force_difference_exceeds_the_friction(result):
    """The data set reports half the force difference; a quarter of it is a force of the pressure."""
    rows = result.comparison["recordings"]
    assert [row["half_of_force"] for row in rows] == pytest.approx([5.3, 7.1, 8.4, 10.4], rel=0.1)
    assert [row["level"] for row in rows] == pytest.approx([3.99, 5.57, 7.25, 8.12], rel=0.01)


def test_leak_tests_give_the_ratio_of_conductance_and_volume():
    recording = {"file": str(DATA / "leak_aluminium.csv"), "time": {"column": "t_s", "unit": "s"},
                 "tank.pressure": {"column": "p_bar", "unit": "bar g"}, "until": "60 s"}  # fmt: skip
    results = [
        identify_tank(
            TankTest(recordings={"leak": recording}, volume=volume, thermal="isothermal", pressure_offset=0)
        ).parameters
        for volume in ("0.1 l", "0.3 l")
    ]
    ratio = [e["valve.sonic_conductance"].value / v for e, v in zip(results, (1e-4, 3e-4), strict=True)]
    assert ratio[0] == pytest.approx(ratio[1], rel=1e-3)
    assert 1e5 * ratio[0] == pytest.approx(2.9e-5, rel=0.15)

"""Tests with the measured force map of a DMSP-20-300 (Martens & Boblan, Actuators 2017, 6(4), 33, CC BY 4.0)."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from poppet import Muscle
from poppet.identify import MusclePoints, Result, identify_muscle

MAP = Path(__file__).resolve().parents[3] / "shared" / "data" / "muscle_dmsp20_300" / "force_map.csv"
pytestmark = pytest.mark.skipif(not MAP.is_file(), reason="the measured data are not beside this checkout")


def library_errors() -> tuple[np.ndarray, np.ndarray]:
    """Return the errors of the law of the library at the taut points, and the forces at these points."""
    _, contraction, pressure, force = np.loadtxt(MAP, delimiter=",", skiprows=2).T
    is_taut = force > 0.0
    law = Muscle(body="slide", data="dmsp_20_300").force_law()
    return (law.force(pressure, contraction) - force)[is_taut], force[is_taut]


def identified_muscle() -> Result:
    _, contraction, pressure, force = np.loadtxt(MAP, delimiter=",", skiprows=2).T
    return identify_muscle(MusclePoints(pressure, contraction, force, 0.3, 0.02))


def test_library_set_agrees_with_map():
    """Check the rms error, 6.2 N at taut points (0.37 % of the largest force), and less than 40 N at slack points."""
    error, force = library_errors()
    rms = float(np.sqrt(np.mean(error**2)))
    assert rms == pytest.approx(6.2, abs=0.1)
    assert rms / force.max() == pytest.approx(0.0037, abs=1e-4)


def test_map_determines_published_law():
    """Check an error of 0.5 % of the largest force at taut points, and the ranking from Sarosi to the braid law."""
    result, (_, force) = identified_muscle(), library_errors()
    assert result.residuals["points.force"].samples == force.size
    assert result.residuals["points.force"].rms / force.max() < 0.005
    ranked = [row["law"] for row in result.comparison["forces"]]
    assert ranked == ["sarosi", "table", "tondu_lopez", "chou_hannaford"]
    held_out = [row["held_out_of_largest"] for row in result.comparison["forces"]]
    assert held_out == pytest.approx([0.0071, 0.024, 0.078, 0.097], rel=0.03)
    proportional = next(n.facts for n in result.remarks if n.code == "force_map.proportional")
    assert proportional["high"] < -100.0


def test_table_error_is_below_half_a_percent():
    """Check lines versus pressure at five contractions; the maximum error of the law of Sarosi is 1.1 %."""
    _, contraction, pressure, force = np.loadtxt(MAP, delimiter=",", skiprows=2).T
    points = MusclePoints(pressure, contraction, force, 0.3, 0.02)
    result = identify_muscle(points, law="table")
    row = next(row for row in result.comparison["forces"] if row["law"] == "table")
    assert row["worst"] / force.max() == pytest.approx(0.0034, abs=1e-4)
    assert row["worst_by_pressure"] / force.max() == pytest.approx(0.0040, abs=1e-4)
    assert row["worst_by_contraction"] / force.max() > 0.05
    taut = force > 0.0
    slopes, passives = (
        [result.parameters[f"force_table.{name}_{k}"].value for k in range(1, 6)]
        for name in ("force_per_pressure", "passive_force")
    )
    rows = np.unique(contraction[taut])
    expected = pressure * np.interp(contraction, rows, slopes) + np.interp(contraction, rows, passives)
    assert np.max(np.abs(expected - force)[taut]) / force.max() < 0.005

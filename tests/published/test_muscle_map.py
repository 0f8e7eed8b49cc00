"""The measured force map of a DMSP-20-300 (Martens & Boblan, Actuators 2017, 6(4), 33, CC BY 4.0)."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from poppet import Muscle
from poppet.identify import MusclePoints, identify_muscle

MAP = Path(__file__).resolve().parents[3] / "shared" / "data" / "muscle_dmsp20_300" / "force_map.csv"
pytestmark = pytest.mark.skipif(not MAP.is_file(), reason="the measured data are not beside this checkout")


def test_the_library_set_follows_the_map():
    """Over taut points 6.2 N, 0.37 % of the largest force; where the map is slack, less than 40 N are left."""
    _, contraction, pressure, force = np.loadtxt(MAP, delimiter=",", skiprows=2).T
    law = Muscle(body="slide", data="dmsp_20_300").force_law()
    error, is_taut = law.force(pressure, contraction) - force, force > 0.0
    rms = float(np.sqrt(np.mean(error[is_taut] ** 2)))
    assert rms == pytest.approx(6.2, abs=0.1)
    assert rms / force.max() == pytest.approx(0.0037, abs=1e-4)


def test_the_law_is_found_again_from_the_map():
    """Within 0.5 % of the largest force over taut points; Sarosi's law first, the braid's last."""
    _, contraction, pressure, force = np.loadtxt(MAP, delimiter=",", skiprows=2).T
    result = identify_muscle(MusclePoints(pressure, contraction, force, 0.3, 0.02))
    assert result.residuals["points.force"].samples == int((force > 0.0).sum())
    assert result.residuals["points.force"].rms / force.max() < 0.005
    ranked = [row["law"] for row in result.comparison["forces"]]
    assert ranked == ["sarosi", "table", "tondu_lopez", "chou_hannaford"]
    held_out = [row["held_out_of_largest"] for row in result.comparison["forces"]]
    assert held_out == pytest.approx([0.0071, 0.024, 0.078, 0.097], rel=0.03)
    proportional = next(n.facts for n in result.remarks if n.code == "force_map.proportional")
    assert proportional["high"] < -100.0

"""Exergy of tanks that empty and fill: closed forms, and quadrature by SciPy."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest

sys.path.insert(0, str(Path(__file__).parent))
from independent_exergy import GAS, TERMS, WARM, adiabatic_discharge, tank

VOLUME, SIZE = 5e-3, (2e-8, 0.3)
CASES = [(7e5, 0.0, None), (7e5, 1.5, None), (1e5, 0.0, 8e5), (1e5, 1.5, 8e5)]


@pytest.mark.parametrize(("start", "wall", "supply"), CASES)
def test_the_terms_close(start: float, wall: float, supply: float | None) -> None:
    terms = tank(VOLUME, start, *SIZE, wall, 4.0, supply)
    total = sum(terms[name] for name in TERMS[1:]) + terms["stored"]
    assert total == pytest.approx(terms["supplied"], abs=1e-7 * abs(terms["stored"]))
    assert all(terms[name] >= 0.0 for name in TERMS)


@pytest.mark.parametrize("duration", [0.3, 2.0])
def test_an_adiabatic_discharge_has_the_closed_form(duration: float) -> None:
    terms = tank(VOLUME, 7e5, *SIZE, 0.0, duration)
    mass_ratio = terms["p"] * VOLUME / (GAS * terms["t"]) / (7e5 * VOLUME / (GAS * WARM))
    closed = adiabatic_discharge(VOLUME, 7e5, mass_ratio)
    for name, value in closed.items():
        assert terms[name] == pytest.approx(value, rel=1e-7, abs=1e-7 * abs(closed["stored"])), name
    assert closed["throttling"] + closed["exhausted"] == pytest.approx(-closed["stored"], rel=1e-12)

"""Tests of the agreement of linear and nonlinear stability over springs, dampings and volumes."""

from __future__ import annotations

import math

import pytest

from poppet import Circuit
from poppet.bench.limits.maps import limits_plan
from poppet.bench.limits.stability import stability_point
from poppet.parts import Chamber, Orifice, ProportionalValve, Reservoir

PARTS = {
    "supply": Reservoir(pressure="7 bar"),
    "valve": ProportionalValve(supply="supply", outlet="tank", exhaust="ambient", data="vppm_6l"),
    "tank": Chamber(volume="1 l", wall_conductance=1.0),
    "load": Orifice(from_="tank", to="ambient", sonic_conductance=2e-9, critical_ratio=0.3),
}
PLAN = limits_plan(Circuit(PARTS))
GRID = [(s, d, v) for s in (0.5, 2.0) for d in (0.25, 1.0, 4.0) for v in (1e-4, 6e-4, 2e-3, 1e-2)]
FEW = [
    *((2.0, d, v) for d in (0.25, 1.0, 4.0) for v in (6e-4, 1e-2)),
    (2.0, 1.0, 1e-4),
    (2.0, 4.0, 1e-4),
    (0.5, 0.25, 2e-3),
    (0.5, 1.0, 6e-4),
]
"""Points on both sides of the stability limit, and points far from it."""


@pytest.fixture(
    scope="module", params=[pytest.param(GRID, marks=pytest.mark.slow, id="grid"), pytest.param(FEW, id="few")]
)
def points(request):
    return {key: stability_point(PLAN, *key) for key in request.param}


def test_linear_and_nonlinear_model_agree_on_a_grid(points):
    assert [key for key, point in points.items() if not point.agrees] == []
    assert {point.smooth for point in points.values()} >= {"oscillates", "decays"}


def test_limit_cycle_near_stability_limit_has_the_pole_frequency(points):
    """Far beyond the limit, the poppet hits its seat and the frequency falls."""
    close = {key: point for key, point in points.items() if 0.0 < point.pole.real < 200.0}
    assert close
    for point in close.values():
        assert point.smooth_frequency == pytest.approx(abs(point.pole.imag) / (2.0 * math.pi), rel=0.1)


def test_damping_and_volume_stabilise_the_valve(points):
    growth = {key: point.pole.real for key, point in points.items()}
    for s in {key[0] for key in growth if (key[0], 4.0, 6e-4) in growth}:
        assert growth[s, 0.25, 6e-4] > growth[s, 1.0, 6e-4] > growth[s, 4.0, 6e-4]
        assert growth[s, 1.0, 1e-4] > growth[s, 1.0, 6e-4]


def test_controller_bands_explain_motion_of_stable_points(points):
    moving = [point for point in points.values() if point.is_stable and point.amplitude > 25.0]
    assert moving
    assert {point.note.code for point in moving} <= {"limits.hums", "limits.hunts"}

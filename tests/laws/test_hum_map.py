"""Linear and full model say the same about stability over springs, dampings and volumes."""

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
"""The edge of stability on both sides, and what lies well within."""


@pytest.fixture(
    scope="module", params=[pytest.param(GRID, marks=pytest.mark.slow, id="grid"), pytest.param(FEW, id="few")]
)
def found(request):
    return {key: stability_point(PLAN, *key) for key in request.param}


def test_they_agree_on_a_grid(found):
    assert [key for key, each in found.items() if not each.agrees] == []
    assert {each.smooth for each in found.values()} >= {"oscillates", "decays"}


def test_hum_close_to_the_edge_has_the_frequency_of_the_pole(found):
    """Far beyond it the limit cycle is large, the poppet meets its seat, and the frequency falls."""
    close = {key: each for key, each in found.items() if 0.0 < each.pole.real < 200.0}
    assert close
    for each in close.values():
        assert each.smooth_frequency == pytest.approx(abs(each.pole.imag) / (2.0 * math.pi), rel=0.1)


def test_damping_and_volume_calm_it(found):
    growth = {key: each.pole.real for key, each in found.items()}
    for s in {key[0] for key in growth if (key[0], 4.0, 6e-4) in growth}:
        assert growth[s, 0.25, 6e-4] > growth[s, 1.0, 6e-4] > growth[s, 4.0, 6e-4]
        assert growth[s, 1.0, 1e-4] > growth[s, 1.0, 6e-4]


def test_the_bands_explain_what_moves_where_small_motions_decay(found):
    moving = [each for each in found.values() if each.is_stable and each.amplitude > 25.0]
    assert moving
    assert {each.note.code for each in moving} <= {"limits.hums", "limits.hunts"}

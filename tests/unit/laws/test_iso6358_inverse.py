"""Inverses of the flow law: known answers, undetermined cases, messages."""

from __future__ import annotations

import numpy as np
import pytest

from poppet.core.errors import OutOfRangeError
from poppet.iso6358 import (
    critical_ratio_from_point,
    downstream_pressure,
    effective_conductance,
    mass_flow_rate,
    sonic_conductance_from_flow,
    upstream_pressure,
)
from refusals import refused

VALVE = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}
CHOKED = 2e-8 * 1.185 * 5e5


def test_choked_flow_leaves_the_downstream_pressure_undetermined():
    with refused("iso6358.choked", "mass_flow_rate", kind=OutOfRangeError):
        downstream_pressure(CHOKED, 5e5, 293.15, **VALVE)
    with refused("iso6358.choked", "mass_flow_rate[1]", kind=OutOfRangeError):
        downstream_pressure([0.001, 0.012], 5e5, 293.15, **VALVE)


def test_choked_flow_determines_the_upstream_pressure():
    assert upstream_pressure(CHOKED, 1e5, 293.15, **VALVE) == pytest.approx(5e5, rel=1e-14)
    assert upstream_pressure(CHOKED, 0.0, 293.15, **VALVE) == pytest.approx(5e5, rel=1e-14)


def test_zero_flow_gives_the_pressure_at_which_it_stops():
    assert downstream_pressure(0.0, 5e5, 293.15, **VALVE) == pytest.approx(5e5, rel=1e-15)
    assert downstream_pressure(0.0, 5e5, 293.15, cracking_pressure=1e4, **VALVE) == pytest.approx(4.9e5)
    assert downstream_pressure(0.0, 5e5, 293.15, cracking_pressure=6e5, **VALVE) == 0.0
    assert upstream_pressure(0.0, 5e5, 293.15, **VALVE) == pytest.approx(5e5, rel=1e-15)
    assert upstream_pressure(0.0, 5e5, 293.15, cracking_pressure=1e4, **VALVE) == pytest.approx(5.1e5)
    assert upstream_pressure(0.0, 0.0, 293.15, **VALVE) == 0.0


def test_flow_that_a_vacuum_cannot_draw():
    with refused("iso6358.below_vacuum", "mass_flow_rate", kind=OutOfRangeError):
        downstream_pressure(0.9 * CHOKED, 5e5, 293.15, cracking_pressure=4.9999e5, **VALVE)


def test_no_upstream_pressure():
    with refused("iso6358.no_upstream", "pressure_1", kind=OutOfRangeError):
        downstream_pressure(0.001, 0.0, 293.15, **VALVE)
    with refused("iso6358.upstream", "pressure_1", kind=OutOfRangeError):
        effective_conductance(0.001, 0.0, 293.15)


def test_reversed_flow_and_closed_passage_are_refused():
    with refused("iso6358.flow_backwards", "mass_flow_rate", kind=OutOfRangeError):
        downstream_pressure(-0.001, 5e5, 293.15, **VALVE)
    with refused("iso6358.fixes_no_pressure", "sonic_conductance", kind=OutOfRangeError):
        upstream_pressure(0.001, 5e5, 293.15, sonic_conductance=0.0, critical_ratio=0.3)


@pytest.mark.parametrize("ratio", [0.0, 0.3, 0.5, 0.6, 0.95])
@pytest.mark.parametrize("r", [0.0, 0.2, 0.5, 0.7, 0.99, 0.9992, 0.99999])
def test_upstream_closed_form_and_bisection_agree(ratio, r):
    numbers = {"sonic_conductance": 2e-8, "critical_ratio": ratio}
    q = mass_flow_rate(5e5, r * 5e5, 310.0, **numbers)
    assert upstream_pressure(q, r * 5e5, 310.0, **numbers) == pytest.approx(5e5, rel=1e-12)
    # an index next to 0.5 takes the other way through the same law
    nearly = upstream_pressure(q, r * 5e5, 310.0, subsonic_index=0.5 + 1e-12, **numbers)
    assert nearly == pytest.approx(5e5, rel=1e-10)


def test_conductance_from_choked_and_subsonic_points():
    assert sonic_conductance_from_flow(CHOKED, 5e5, 1e5, 293.15, critical_ratio=0.21) == pytest.approx(2e-8)
    assert effective_conductance(CHOKED, 5e5, 293.15) == pytest.approx(2e-8)
    q = mass_flow_rate(5e5, [1e5, 4e5, 6e5], 293.15, 350.0, **VALVE)
    found = sonic_conductance_from_flow(q, 5e5, [1e5, 4e5, 6e5], 293.15, 350.0, critical_ratio=0.3)
    assert found == pytest.approx(np.full(3, 2e-8))


def test_conductance_needs_a_flow_along_the_pressure_drop():
    with refused("iso6358.closed_here", "mass_flow_rate", kind=OutOfRangeError):
        sonic_conductance_from_flow(0.001, 5e5, 5e5, 293.15, critical_ratio=0.3)
    with refused("iso6358.runs_uphill", "mass_flow_rate", kind=OutOfRangeError):
        sonic_conductance_from_flow(0.001, 1e5, 5e5, 293.15, critical_ratio=0.3)


@pytest.mark.parametrize("index", [0.4, 0.5, 0.8])
def test_critical_ratio_of_exact_points(index):
    r = np.array([0.4, 0.6, 0.9, 0.99])
    q = mass_flow_rate(5e5, r * 5e5, 293.15, subsonic_index=index, **VALVE)
    assert critical_ratio_from_point(r, q / CHOKED, index) == pytest.approx(np.full(4, 0.3), rel=1e-10)


def test_critical_ratio_refuses_what_says_nothing():
    with refused("iso6358.subsonic_point", "flow_ratio", kind=OutOfRangeError):
        critical_ratio_from_point(0.4, 1.0)
    with refused("iso6358.subsonic_point", "pressure_ratio", kind=OutOfRangeError):
        critical_ratio_from_point(1.0, 0.5)
    with refused("iso6358.below_the_curve", "flow_ratio[1]", kind=OutOfRangeError):
        critical_ratio_from_point([0.8, 0.8], [0.7, 0.3])

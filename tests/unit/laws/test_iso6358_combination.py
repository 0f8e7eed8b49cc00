"""Passages in series and parallel against the pair itself; tubes."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.optimize import brentq

from poppet.core.errors import OutOfRangeError
from poppet.iso6358 import mass_flow_rate, parallel, parallel_of, series, series_of, tube
from refusals import refused

PAIRS = [
    (1.65e-8, 0.43, 3e-8, 0.30),
    (3e-8, 0.30, 1.65e-8, 0.43),
    (1e-8, 0.0, 1e-8, 0.2),
    (1e-8, 0.5, 5e-8, 0.1),
    (2e-8, 0.5, 1e-8, 0.5),
    (4e-9, 0.4, 2.5e-9, 0.57),
]


def flow_of(passage, pressure_1, pressure_2, laminar_ratio=1.0 - 1e-9):
    conductance, ratio = passage
    return mass_flow_rate(
        pressure_1,
        pressure_2,
        293.15,
        sonic_conductance=conductance,
        critical_ratio=ratio,
        laminar_ratio=laminar_ratio,
    )


def flow_of_pair(first, second, pressure_1, pressure_2):
    """Both passages with the pressure between them solved for."""

    def imbalance(between):
        return flow_of(first, pressure_1, between) - flow_of(second, between, pressure_2)

    between = brentq(imbalance, pressure_2, pressure_1, xtol=1e-9, rtol=1e-15)
    return flow_of(first, pressure_1, between)


@pytest.mark.parametrize("pair", PAIRS)
def test_series_conductance_is_that_of_the_choked_pair(pair):
    conductance, _ = series(*pair)
    choked = flow_of_pair(pair[:2], pair[2:], 5e5, 0.0)
    assert conductance * 1.185 * 5e5 == pytest.approx(choked, rel=1e-10)


@pytest.mark.parametrize("pair", PAIRS)
def test_series_is_exact_for_small_pressure_drops(pair):
    whole = series(*pair)
    pressure_2 = 5e5 * (1.0 - 1e-5)
    assert flow_of(whole, 5e5, pressure_2) == pytest.approx(flow_of_pair(pair[:2], pair[2:], 5e5, pressure_2), rel=2e-5)


@pytest.mark.parametrize("pair", PAIRS)
def test_series_ellipse_stays_near_the_pair(pair):
    whole = series(*pair)
    choked = whole[0] * 1.185 * 5e5
    errors = [
        abs(flow_of(whole, 5e5, r * 5e5) - flow_of_pair(pair[:2], pair[2:], 5e5, r * 5e5)) / choked
        for r in np.linspace(0.0, 0.999, 60)
    ]
    assert max(errors) < 0.014


@pytest.mark.parametrize("ratio", [1e-3, 1e-6, 1e-12])
def test_series_with_vanishing_first_ratio_has_a_limit(ratio):
    at_zero = series(1e-8, 0.0, 2e-8, 0.4)
    assert series(1e-8, ratio, 2e-8, 0.4) == pytest.approx(at_zero, rel=10.0 * ratio)
    # k = 1/2 and b1 = 0: C = C1 sqrt(1/(1 + k^2))
    assert at_zero[0] == pytest.approx(1e-8 / np.sqrt(1.25), rel=1e-14)


def test_small_first_passage_chokes_the_series():
    assert series(1e-8, 0.5, 2.5e-8, 0.3) == pytest.approx((1e-8, 0.5 - 0.7 * 0.16), rel=1e-14)


def test_many_passages_in_series():
    passages = [(1.65e-8, 0.43), (3e-8, 0.3), (2e-8, 0.2)]
    assert series_of(passages) == series(*series(*passages[0], *passages[1]), *passages[2])
    assert series_of(iter(passages[:1])) == passages[0]


@pytest.mark.parametrize("r", [0.0, 0.2, 0.9999])
def test_parallel_is_the_sum_where_it_is_exact(r):
    first, second = (1e-8, 0.2), (2e-8, 0.5)
    both = flow_of(first, 5e5, r * 5e5) + flow_of(second, 5e5, r * 5e5)
    assert flow_of(parallel(*first, *second), 5e5, r * 5e5) == pytest.approx(both, rel=2e-4)


def test_parallel_of_equal_passages_keeps_the_ratio():
    assert parallel_of([(1e-8, 0.3)] * 5) == pytest.approx((5e-8, 0.3), rel=1e-14)


def test_tube_loses_with_length():
    lengths = np.array([0.0, 0.1, 1.0, 10.0])
    found = np.array([tube(length, 4e-3) for length in lengths])
    assert np.all(np.diff(found, axis=0) < 0.0)
    assert found[0, 1] == pytest.approx(474.0 * 0.029 / np.sqrt(510.0))


def test_mistakes_name_the_passage():
    with refused("iso6358.closed_passage", "sonic_conductance_1", value=0.0) as caught:
        series(0.0, 0.3, 1e-8, 1.0)
    assert (caught.value.problems[1].code, caught.value.problems[1].address) == (
        "iso6358.critical_ratio",
        "critical_ratio_2",
    )
    with refused("iso6358.no_passages", "passages"):
        parallel_of([])
    with refused("iso6358.bore", "diameter", kind=OutOfRangeError):
        tube(1.0, 0.0)
    with refused("iso6358.length", "length", kind=OutOfRangeError):
        tube(-1.0, 4e-3)

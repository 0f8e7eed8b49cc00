"""The flow law: values, shapes, both directions, edges of its domain, messages."""

from __future__ import annotations

import math

import numpy as np
import pytest

from poppet.core.errors import InputErrors, OutOfRangeError
from poppet.iso6358 import (
    REGIMES,
    flow,
    flow_regime,
    mass_flow_rate,
    upstream_temperature,
)
from refusals import refused

VALVE = {"sonic_conductance": 2e-8, "critical_ratio": 0.3}
CHOKED = 2e-8 * 1.185 * 5e5  # at 293.15 K and 5 bar [kg/s]


def standard(pressure_1, pressure_2, temperature_1, conductance, ratio, index=0.5, cracking=0.0):
    """The law as the standard prints it, forward only."""
    choked = conductance * 1.185 * pressure_1 * math.sqrt(293.15 / temperature_1)
    r, closed = pressure_2 / pressure_1, 1.0 - cracking / pressure_1
    if r >= closed:
        return 0.0
    return choked if r <= ratio else choked * (1.0 - ((r - ratio) / (closed - ratio)) ** 2) ** index


def test_choked_flow_is_the_printed_product():
    assert mass_flow_rate(5e5, 1e5, 293.15, **VALVE) == pytest.approx(CHOKED, rel=1e-15)
    assert mass_flow_rate(5e5, 1e5, 586.3, **VALVE) == pytest.approx(CHOKED / math.sqrt(2.0), rel=1e-15)


@pytest.mark.parametrize("ratio", [0.0, 0.2, 0.3, 0.5, 0.9, 0.998, 0.999])
@pytest.mark.parametrize("index", [0.3, 0.5, 0.62, 1.0])
def test_outside_the_zone_it_is_the_standard(ratio, index):
    for r in np.linspace(0.0, 0.999, 41):
        expected = standard(5e5, r * 5e5, 310.0, 2e-8, ratio, index)
        given = mass_flow_rate(5e5, r * 5e5, 310.0, sonic_conductance=2e-8, critical_ratio=ratio, subsonic_index=index)
        assert given == pytest.approx(expected, rel=2e-12)


@pytest.mark.parametrize("cracking", [1e3, 5e4, 2e5])
def test_cracking_pressure_is_the_standard_s(cracking):
    edge = 0.999 - cracking / 5e5
    for r in np.linspace(0.0, edge, 41):
        given = mass_flow_rate(5e5, r * 5e5, 293.15, cracking_pressure=cracking, **VALVE)
        assert given == pytest.approx(standard(5e5, r * 5e5, 293.15, 2e-8, 0.3, 0.5, cracking), rel=1e-12)
    assert mass_flow_rate(5e5, 5e5 - cracking, 293.15, cracking_pressure=cracking, **VALVE) == 0.0
    assert mass_flow_rate(5e5 - 0.5 * cracking, 5e5, 293.15, cracking_pressure=cracking, **VALVE) == 0.0


def test_huge_cracking_pressure_keeps_the_passage_shut():
    # 1 - dpc/p1 = 0.1 < b: choked as soon as it opens, zone included
    assert mass_flow_rate(5e5, 1e5, 293.15, cracking_pressure=4.5e5, **VALVE) == 0.0
    assert mass_flow_rate(5e5, 0.0, 293.15, cracking_pressure=4.5e5, **VALVE) == pytest.approx(CHOKED)
    assert mass_flow_rate(5e5, 0.0, 293.15, cracking_pressure=6e5, **VALVE) == 0.0


def test_one_way_passes_forward_only():
    assert mass_flow_rate(5e5, 1e5, 293.15, one_way=True, **VALVE) == pytest.approx(CHOKED)
    assert mass_flow_rate(1e5, 5e5, 293.15, one_way=True, **VALVE) == 0.0
    q, temperature = flow(4.9999e5, 5e5, 300.0, 280.0, one_way=True, **VALVE)
    assert (q, temperature) == (0.0, 300.0)


def test_reversed_flow_takes_the_temperature_of_port_2():
    q, temperature = flow(1e5, 5e5, 250.0, 400.0, **VALVE)
    assert temperature == 400.0
    assert q == pytest.approx(-standard(5e5, 1e5, 400.0, 2e-8, 0.3), rel=1e-14)


def test_one_temperature_serves_both_ways():
    assert mass_flow_rate(1e5, 5e5, 400.0, **VALVE) == -mass_flow_rate(5e5, 1e5, 400.0, **VALVE)


@pytest.mark.parametrize("cracking", [0.0, 1e4])
@pytest.mark.parametrize("one_way", [False, True])
def test_vacuum_on_both_sides_is_no_flow(cracking, one_way):
    numbers = VALVE | {"cracking_pressure": cracking, "one_way": one_way}
    assert mass_flow_rate(0.0, 0.0, 293.15, **numbers) == 0.0
    assert mass_flow_rate(np.zeros(3), np.zeros(3), 293.15, **numbers).tolist() == [0.0, 0.0, 0.0]
    assert flow_regime(0.0, 0.0, critical_ratio=0.3, cracking_pressure=cracking, one_way=one_way) == 0


def test_critical_ratio_inside_the_zone():
    numbers = {"sonic_conductance": 2e-8, "critical_ratio": 0.9995}
    assert mass_flow_rate(5e5, 0.999 * 5e5, 293.15, **numbers) == pytest.approx(CHOKED, rel=1e-12)
    assert 0.0 < mass_flow_rate(5e5, 0.9995 * 5e5, 293.15, **numbers) < CHOKED


def test_result_has_the_broadcast_shape():
    rows, columns = np.linspace(2e5, 7e5, 3)[:, None], np.linspace(1e5, 2e5, 4)
    q, temperature = flow(rows, columns, 293.15, **VALVE)
    assert q.shape == temperature.shape == (3, 4)
    assert mass_flow_rate([5e5, 6e5], 1e5, 293.15, **VALVE).shape == (2,)
    assert mass_flow_rate(np.empty((0, 2)), 1e5, 293.15, **VALVE).shape == (0, 2)
    assert isinstance(mass_flow_rate(np.array(5e5), 10**5, 293.15, **VALVE), float)


def test_blocks_meet_without_a_seam():
    upstream = np.linspace(1e5, 7e5, 20_001)
    whole = mass_flow_rate(upstream, 3e5, 293.15, 300.0, **VALVE)
    parts = [mass_flow_rate(piece, 3e5, 293.15, 300.0, **VALVE) for piece in np.array_split(upstream, 7)]
    assert np.array_equal(whole, np.concatenate(parts))


def test_array_of_cracking_pressures_mixes_both_closings():
    cracking = np.array([0.0, 100.0])
    given = mass_flow_rate(5e5, 4.998e5, 293.15, cracking_pressure=cracking, **VALVE)
    single = [mass_flow_rate(5e5, 4.998e5, 293.15, cracking_pressure=value, **VALVE) for value in cracking.tolist()]
    assert given == pytest.approx(single, rel=1e-13)
    assert single[1] < single[0]


def test_upstream_temperature_outside_the_zone_is_exact():
    assert upstream_temperature(5e5, 4.9e5, 300.1, 280.3) == 300.1
    assert upstream_temperature(4.9e5, 5e5, 300.1, 280.3) == 280.3
    assert upstream_temperature(5e5, [4.9999e5, 5.0001e5], 300.0, 280.0).tolist() == [300.0, 280.0]


def test_upstream_temperature_turns_where_no_entropy_is_destroyed_either_way():
    still = np.log(300.0 / 280.0) / (1.0 / 280.0 - 1.0 / 300.0)
    assert upstream_temperature(5e5, 5e5, 300.0, 280.0) == pytest.approx(still, rel=1e-6)
    assert upstream_temperature(5e5, 5e5, 280.0, 300.0) == pytest.approx(still, rel=1e-6)
    assert upstream_temperature(5e5, 5e5, 300.0, 300.0) == 300.0


@pytest.mark.parametrize(("pressure_2", "code"), [(1e5, 3), (1.5e5, 3), (3e5, 2), (4.995e5, 2), (4.999e5, 1), (5e5, 0)])
def test_regimes_both_ways(pressure_2, code):
    assert flow_regime(5e5, pressure_2, critical_ratio=0.3) == code
    assert flow_regime(pressure_2, 5e5, critical_ratio=0.3) == -code
    assert flow_regime(pressure_2, 5e5, critical_ratio=0.3, one_way=True) == 0
    assert code in REGIMES
    assert -code in REGIMES


def test_regimes_with_cracking_pressure_and_arrays():
    codes = flow_regime(5e5, [0.0, 4.4e5, 4.49e5, 4.4999e5, 4.5e5], critical_ratio=0.3, cracking_pressure=5e4)
    assert codes.dtype.kind == "i"
    assert codes.tolist() == [3, 2, 2, 1, 0]
    assert flow_regime(5e5, 4.9999e5, critical_ratio=0.99999) == 1


def test_negative_pressure_asks_for_gauge():
    with refused("iso6358.pressure", "pressure_2", kind=OutOfRangeError):
        mass_flow_rate(5e5, -0.5e5, 293.15, **VALVE)
    with refused("iso6358.pressure", "pressure_1[1]", kind=OutOfRangeError):
        mass_flow_rate(np.array([5e5, -1.0]), 1e5, 293.15, **VALVE)
    with refused("iso6358.pressure", "pressure_1[0, 1]", kind=OutOfRangeError):
        flow_regime(np.array([[5e5, np.nan]]), 1e5, critical_ratio=0.3)


@pytest.mark.parametrize(
    ("name", "value", "message"),
    [
        ("sonic_conductance", -1e-9, "iso6358.sonic_conductance"),
        ("critical_ratio", 1.0, "iso6358.critical_ratio"),
        ("critical_ratio", -0.1, "iso6358.critical_ratio"),
        ("subsonic_index", 0.0, "iso6358.subsonic_index"),
        ("subsonic_index", 3.1, "iso6358.subsonic_index"),
        ("cracking_pressure", -1.0, "iso6358.cracking_pressure"),
        ("laminar_ratio", 1.0, "iso6358.laminar_ratio"),
        ("laminar_ratio", 0.0, "iso6358.laminar_ratio"),
        ("reference_density", 0.0, "iso6358.reference_density"),
        ("reference_temperature", float("nan"), "iso6358.temperature"),
    ],
)
def test_numbers_outside_their_domain(name, value, message):
    with refused(message, kind=OutOfRangeError):
        mass_flow_rate(5e5, 1e5, 293.15, **(VALVE | {name: value}))


def test_all_mistakes_at_once():
    with pytest.raises(InputErrors) as caught:
        mass_flow_rate(5e5, 1e5, -20.0, 0.0, sonic_conductance=2e-8, critical_ratio=1.5)
    assert [problem.given for problem in caught.value.problems] == [
        "temperature_1 = -20 K",
        "temperature_2 = 0 K",
        "critical_ratio = 1.5",
    ]

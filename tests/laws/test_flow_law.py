"""What holds for every passage: monotone, homogeneous, reversible, blind when choked, C1, invertible."""

from __future__ import annotations

import sys
from functools import partial
from pathlib import Path

import casadi as ca
import numpy as np
import pytest
from hypothesis import assume
from hypothesis import strategies as st

from poppet.iso6358 import (
    conductance_from_effective_area,
    conductance_from_flow_coefficient_cv,
    conductance_from_flow_coefficient_kv,
    conductance_from_nominal_flow,
    critical_ratio_from_point,
    downstream_pressure,
    effective_area_from_conductance,
    flow,
    flow_coefficient_cv_from_conductance,
    flow_coefficient_kv_from_conductance,
    flow_regime,
    mass_flow_rate,
    nominal_flow_from_conductance,
    nozzle_critical_ratio,
    nozzle_mass_flow_rate,
    parallel,
    series,
    sonic_conductance_from_flow,
    upstream_pressure,
    upstream_temperature,
)

sys.path.insert(0, str(Path(__file__).parent))
from repeated_laws import law as repeated_law

law = partial(repeated_law, few=40, many=300)

pressures = st.floats(1.0, 2e6)
temperatures = st.floats(200.0, 500.0)
ratios = st.one_of(st.just(0.0), st.floats(0.0, 0.99), st.floats(0.998, 0.9999))
indices = st.one_of(st.just(0.5), st.floats(0.2, 3.0))
laminar_ratios = st.floats(0.9, 0.9999)
cracking_pressures = st.one_of(st.just(0.0), st.floats(1.0, 1e6))
near_one = st.one_of(st.floats(0.0, 1.0), st.floats(0.99, 1.0), st.floats(0.999, 1.0))


@st.composite
def passages(draw):
    return {
        "sonic_conductance": draw(st.floats(1e-10, 1e-6)),
        "critical_ratio": draw(ratios),
        "subsonic_index": draw(indices),
        "cracking_pressure": draw(cracking_pressures),
        "laminar_ratio": draw(laminar_ratios),
        "one_way": draw(st.booleans()),
    }


def choked(passage, pressure_1, temperature_1=293.15):
    return passage["sonic_conductance"] * 1.185 * pressure_1 * np.sqrt(293.15 / temperature_1)


@law(passages(), pressures, near_one, st.floats(0.0, 0.1), temperatures)
def test_falls_with_p2_and_rises_with_p1(passage, pressure_1, r, step, temperature):
    pressure_2 = r * pressure_1
    q = mass_flow_rate(pressure_1, pressure_2, temperature, **passage)
    tiny = 1e-13 * choked(passage, pressure_1, temperature)
    assert mass_flow_rate(pressure_1, pressure_2 * (1.0 + step), temperature, **passage) <= q + tiny
    assert mass_flow_rate(pressure_1 * (1.0 + step), pressure_2, temperature, **passage) >= q - 2 * tiny


@law(passages(), pressures, pressures, temperatures, temperatures, st.floats(1e-3, 1e3))
def test_homogeneous_of_degree_one_in_the_pressures(passage, pressure_1, pressure_2, t1, t2, scale):
    q = mass_flow_rate(pressure_1, pressure_2, t1, t2, **passage)
    scaled = passage | {"cracking_pressure": scale * passage["cracking_pressure"]}
    larger = mass_flow_rate(scale * pressure_1, scale * pressure_2, t1, t2, **scaled)
    assert larger == pytest.approx(scale * q, rel=1e-9, abs=1e-11 * scale * choked(passage, pressure_1))


@law(passages(), pressures, near_one, temperatures, temperatures)
def test_reversal_swaps_the_sign(passage, pressure_1, r, t1, t2):
    passage |= {"one_way": False}
    q, temperature = flow(pressure_1, r * pressure_1, t1, t2, **passage)
    back, same = flow(r * pressure_1, pressure_1, t2, t1, **passage)
    assert (back, same) == pytest.approx((-q, temperature), rel=1e-13)


widths_of_the_zone = st.one_of(st.floats(-1.0, 1.0), st.floats(-9.0, 0.0).map(lambda d: 10.0**d))


@law(passages(), pressures, widths_of_the_zone, temperatures, st.floats(0.7, 1.4), st.booleans())
def test_a_passage_never_destroys_entropy(passage, pressure, z, temperature, ratio, swapped):
    """Second law between two stores of ideal gas: what the passage takes from one side, the other gets.

    d(S1 + S2)/dt = q [cp ln(T2/T1) - R ln(p2/p1) + cp T (1/T2 - 1/T1)] with kappa = 1.4, from dS = (dU - g dm)/T.
    """
    other = pressure * (1.0 - z * (1.0 - passage["laminar_ratio"])) if z > 0.0 else pressure * (1.0 + z)
    pressures_, temperatures_ = (pressure, other), (temperature, ratio * temperature)
    if swapped:
        pressures_ = pressures_[::-1]
    (p1, p2), (t1, t2) = pressures_, temperatures_
    assume(min(p1, p2) > 0.0)
    q, carried = flow(p1, p2, t1, t2, **passage)
    made = q * (3.5 * (np.log(t2 / t1) + carried / t2 - carried / t1) - np.log(p2 / p1))
    # Round-off, and the series of the carried temperature where the flow is below 1e-6 of the zone's.
    assert made >= -1e-10 * choked(passage, max(p1, p2), min(t1, t2))


@law(passages(), st.one_of(st.just(0.0), pressures), temperatures, temperatures)
def test_zero_at_equal_pressure(passage, pressure, t1, t2):
    assert mass_flow_rate(pressure, pressure, t1, t2, **passage) == 0.0
    assert flow_regime(pressure, pressure, **regime_numbers(passage)) == 0


@law(passages(), pressures, st.floats(0.0, 1.0))
def test_choked_flow_is_blind_to_p2(passage, pressure_1, part):
    cracking = passage["cracking_pressure"] / pressure_1
    limit = min(passage["critical_ratio"], passage["laminar_ratio"] - cracking) - 1e-9
    assume(limit > 0.0)
    q = mass_flow_rate(pressure_1, part * limit * pressure_1, 300.0, **passage)
    assert q == mass_flow_rate(pressure_1, 0.0, 300.0, **passage)
    assert q == pytest.approx(choked(passage, pressure_1, 300.0), rel=1e-14)
    assert flow_regime(pressure_1, part * limit * pressure_1, **regime_numbers(passage)) == 3


@law(passages(), pressures, pressures)
def test_regime_agrees_with_the_flow(passage, pressure_1, pressure_2):
    code = flow_regime(pressure_1, pressure_2, **regime_numbers(passage))
    q = mass_flow_rate(pressure_1, pressure_2, 300.0, **passage)
    fraction = abs(q) / choked(passage, max(pressure_1, pressure_2), 300.0)
    assert np.sign(code) == np.sign(q) or fraction < 1e-12
    assert (abs(code) == 3) <= (fraction > 1.0 - 1e-12)


@law(passages(), pressures, near_one, temperatures, temperatures)
def test_never_more_than_choked_and_temperature_between(passage, pressure_1, r, t1, t2):
    q, temperature = flow(pressure_1, r * pressure_1, t1, t2, **passage)
    assert 0.0 <= q <= choked(passage, pressure_1, temperature) * (1.0 + 1e-13)
    assert min(t1, t2) * (1.0 - 1e-15) <= temperature <= max(t1, t2) * (1.0 + 1e-15)
    if not passage["one_way"]:
        laminar_ratio = passage["laminar_ratio"]
        assert temperature == upstream_temperature(pressure_1, r * pressure_1, t1, t2, laminar_ratio=laminar_ratio)


NAMES = ["pressure_1", "pressure_2", "temperature_1", "temperature_2"]
PARAMETERS = ["sonic_conductance", "critical_ratio", "subsonic_index", "cracking_pressure", "laminar_ratio"]


def traced(one_way):
    """The law as a compiled expression of symbols, with its exact derivatives by every argument."""
    symbols = {name: ca.SX.sym(name) for name in NAMES + PARAMETERS}
    q, temperature = flow(**symbols, one_way=one_way)
    arguments = ca.vertcat(*symbols.values())
    return ca.Function("flow", [arguments], [q, temperature, ca.jacobian(q, arguments)])


TRACED = {one_way: traced(one_way) for one_way in (False, True)}


@law(passages(), st.one_of(st.just(0.0), pressures), near_one, temperatures, temperatures, st.booleans())
def test_float_array_and_symbol_agree(passage, upstream, r, t1, t2, swap):
    pressure = (r * upstream, upstream) if swap else (upstream, r * upstream)
    q, temperature = flow(*pressure, t1, t2, **passage)
    many = flow(np.full(3, pressure[0]), np.full(3, pressure[1]), np.full(3, t1), np.full(3, t2), **passage)
    values = [*pressure, t1, t2, *(passage[name] for name in PARAMETERS)]
    symbolic = TRACED[passage["one_way"]](values)
    limit = 1e-14 * choked(passage, upstream, min(t1, t2))
    assert np.all(np.abs(many[0] - q) <= limit)
    assert np.all(many[1] == pytest.approx(temperature, rel=1e-15))
    assert abs(float(symbolic[0]) - q) <= limit
    assert float(symbolic[1]) == pytest.approx(temperature, rel=1e-15)
    assert np.all(np.isfinite(np.array(symbolic[2])))


@law(passages(), pressures, near_one, temperatures, temperatures, st.booleans())
def test_numbers_and_symbols_as_parameters_agree(passage, upstream, r, t1, t2, swap):
    """Numbers shorten the expression (no cracking pressure, a root for m = 0.5); the law stays the same."""
    pressure = (r * upstream, upstream) if swap else (upstream, r * upstream)
    symbols = [ca.SX.sym(name) for name in NAMES]
    q, temperature = flow(*symbols, **passage)
    exact = ca.jacobian(q, ca.vertcat(*symbols))
    short = ca.Function("short", [ca.vertcat(*symbols)], [q, temperature, exact])([*pressure, t1, t2])
    values = [*pressure, t1, t2, *(passage[name] for name in PARAMETERS)]
    full = TRACED[passage["one_way"]](values)
    assert float(short[0]) == pytest.approx(float(full[0]), rel=1e-9, abs=1e-14 * choked(passage, upstream, 200.0))
    assert float(short[1]) == pytest.approx(float(full[1]), rel=1e-14)
    slopes, scale = np.array(full[2]).ravel()[:2], choked(passage, upstream, 200.0) / upstream
    assert np.array(short[2]).ravel()[:2] == pytest.approx(slopes, rel=1e-6, abs=1e-9 * scale / 1e-4)


@law(passages(), st.floats(1e4, 1e6), temperatures, temperatures, st.sampled_from(["b", "edge", "closed"]))
def test_c1_where_branches_meet(passage, pressure_1, t1, t2, seam):
    """The exact derivative just before a seam equals the one just behind it."""
    cracking = passage["cracking_pressure"] / pressure_1
    places = {
        "b": min(passage["critical_ratio"], passage["laminar_ratio"] - cracking),
        "edge": passage["laminar_ratio"] - cracking,
        "closed": 1.0 - cracking,
    }
    assume(places[seam] > 1e-3)
    # the branches curve over the zone's width, over the span down to b where that is shorter, and with the
    # temperature over a thousandth of the zone
    step = 2e-11
    span = max(1.0 - cracking - passage["critical_ratio"], 1.0 - passage["laminar_ratio"])
    slopes = []
    for r in (places[seam] - step, places[seam] + step):
        values = [pressure_1, r * pressure_1, t1, t2, *(passage[name] for name in PARAMETERS)]
        slopes.append(float(TRACED[passage["one_way"]](values)[2][1]) * pressure_1)
    scale = choked(passage, pressure_1, t1) / min(span, 1.0 - passage["laminar_ratio"])
    assert slopes[0] == pytest.approx(slopes[1], abs=1e-3 * scale)


@law(passages(), st.floats(1e4, 1e6), st.floats(0.01, 1.2), temperatures, temperatures)
def test_exact_derivative_is_the_slope(passage, pressure_1, r, t1, t2):
    """Away from seams, with bounded second derivatives, differences meet the traced derivative."""
    pressure_2 = r * pressure_1
    upstream, cracking = max(pressure_1, pressure_2), passage["cracking_pressure"]
    drop, width = abs(pressure_1 - pressure_2) / upstream, 1.0 - passage["laminar_ratio"]
    excess = drop - cracking / upstream
    span = 1.0 - cracking / upstream - passage["critical_ratio"]
    assume(min(abs(excess), abs(drop - width), abs(excess - width), abs(excess - span)) > 1e-3 * width)
    values = [pressure_1, pressure_2, t1, t2, *(passage[name] for name in PARAMETERS)]
    exact = np.array(TRACED[passage["one_way"]](values)[2]).ravel()[:2]
    step = 1e-6 * width * upstream

    def slope(of_1, of_2):
        ahead = mass_flow_rate(pressure_1 + of_1 * step, pressure_2 + of_2 * step, t1, t2, **passage)
        behind = mass_flow_rate(pressure_1 - of_1 * step, pressure_2 - of_2 * step, t1, t2, **passage)
        return (ahead - behind) / (2.0 * step)

    scale = choked(passage, upstream, min(t1, t2)) / upstream / width
    assert slope(1, 0) == pytest.approx(exact[0], rel=1e-5, abs=1e-6 * scale)
    assert slope(0, 1) == pytest.approx(exact[1], rel=1e-5, abs=1e-6 * scale)


@pytest.mark.parametrize("one_way", [False, True])
@pytest.mark.parametrize("cracking", [0.0, 2e4])
def test_derivative_at_equal_pressures(one_way, cracking):
    """A model often starts there: the slope is the cubic's, both ways, and zero where the passage closes."""
    values = [5e5, 5e5, 300.0, 300.0, 1e-8, 0.3, 0.5, cracking, 0.999]
    slope = np.array(TRACED[one_way](values)[2]).ravel()[:2]
    edge = 1e-3 / 0.7
    at_edge = 1e-8 * 1.185 * 5e5 * np.sqrt(293.15 / 300.0 * edge * (2.0 - edge))
    expected = at_edge * (1.0 + 0.5 * (1.0 - (1.0 - edge) / (2.0 - edge))) / (1e-3 * 5e5)
    expected = 0.0 if one_way or cracking else expected
    assert slope == pytest.approx([expected, -expected], rel=1e-12)


@law(passages(), pressures, near_one, temperatures)
def test_downstream_pressure_inverts(passage, pressure_1, r, temperature):
    q = mass_flow_rate(pressure_1, r * pressure_1, temperature, **passage)
    assume(0.0 < q < (1.0 - 1e-9) * choked(passage, pressure_1, temperature))
    found = downstream_pressure(q, pressure_1, temperature, **passage)
    # near choking and near closing the flow hardly tells the pressure, so compare the flow it gives
    again = mass_flow_rate(pressure_1, found, temperature, **passage)
    assert again == pytest.approx(q, rel=1e-6, abs=1e-9 * choked(passage, pressure_1, temperature))


@law(passages(), pressures, st.floats(0.3, 0.9999), temperatures)
def test_downstream_pressure_is_the_same_pressure(passage, pressure_1, r, temperature):
    passage |= {"critical_ratio": 0.2, "cracking_pressure": 0.0, "one_way": False}
    q = mass_flow_rate(pressure_1, r * pressure_1, temperature, **passage)
    found = downstream_pressure(q, pressure_1, temperature, **passage)
    assert found == pytest.approx(r * pressure_1, rel=1e-11)


@law(passages(), pressures, near_one, temperatures)
def test_upstream_pressure_inverts(passage, pressure_1, r, temperature):
    pressure_2 = r * pressure_1
    q = mass_flow_rate(pressure_1, pressure_2, temperature, **passage)
    assume(q > 0.0)
    found = upstream_pressure(q, pressure_2, temperature, **passage)
    again = mass_flow_rate(found, pressure_2, temperature, **passage)
    assert again == pytest.approx(q, rel=1e-6, abs=1e-9 * choked(passage, pressure_1, temperature))


@law(passages(), pressures, pressures, temperatures, temperatures)
def test_conductance_from_flow_inverts(passage, pressure_1, pressure_2, t1, t2):
    q = mass_flow_rate(pressure_1, pressure_2, t1, t2, **passage)
    assume(abs(q) > 1e-12 * choked(passage, max(pressure_1, pressure_2)))
    others = {name: value for name, value in passage.items() if name != "sonic_conductance"}
    found = sonic_conductance_from_flow(q, pressure_1, pressure_2, t1, t2, **others)
    assert found == pytest.approx(passage["sonic_conductance"], rel=1e-12)


@law(st.floats(0.0, 0.9), st.floats(0.01, 0.99), st.floats(0.2, 2.0))
def test_critical_ratio_from_point_inverts(ratio, part, index):
    r = ratio + part * (0.998 - ratio)
    q = mass_flow_rate(1.0, r, 293.15, sonic_conductance=1.0, critical_ratio=ratio, subsonic_index=index)
    assume(q / 1.185 < 1.0 - 1e-6)
    assert critical_ratio_from_point(r, q / 1.185, index) == pytest.approx(ratio, abs=1e-8)


@law(st.floats(1e-10, 1e-6), st.floats(0.0, 0.9), st.sampled_from(["pneumatic", "small_dp"]))
def test_conversions_come_back(conductance, ratio, definition):
    cv = flow_coefficient_cv_from_conductance(conductance, ratio, definition=definition)
    kv = flow_coefficient_kv_from_conductance(conductance, ratio, definition=definition)
    nominal = nominal_flow_from_conductance(conductance, ratio)
    found = [
        conductance_from_flow_coefficient_cv(cv, critical_ratio=ratio, definition=definition),
        conductance_from_flow_coefficient_kv(kv, critical_ratio=ratio, definition=definition),
        conductance_from_nominal_flow(nominal, critical_ratio=ratio),
        conductance_from_effective_area(effective_area_from_conductance(conductance), critical_ratio=ratio),
    ]
    assert [one.sonic_conductance for one in found] == pytest.approx([conductance] * 4, rel=1e-14)


@law(st.floats(1e-9, 1e-7), st.floats(0.0, 0.99), st.floats(1e-9, 1e-7), st.floats(0.0, 0.99))
def test_combinations_stay_passages(first, ratio_1, second, ratio_2):
    conductance, ratio = series(first, ratio_1, second, ratio_2)
    assert 0.0 < conductance <= min(first, second) * (1.0 + 1e-14)
    assert -1e-12 <= ratio < 1.0
    conductance, ratio = parallel(first, ratio_1, second, ratio_2)
    assert conductance == first + second
    assert min(ratio_1, ratio_2) - 1e-12 <= ratio <= max(ratio_1, ratio_2) + 1e-12


def test_ellipse_stands_for_the_nozzle():
    """With b = 0.5283 the ellipse differs from the nozzle by at most 0.152 % of the choked flow."""
    r = np.linspace(0.0, 0.999, 2000)
    valve = conductance_from_effective_area(1e-6)
    ellipse = mass_flow_rate(
        5e5,
        r * 5e5,
        293.15,
        sonic_conductance=valve.sonic_conductance,
        critical_ratio=nozzle_critical_ratio(),
    )
    nozzle = nozzle_mass_flow_rate(5e5, r * 5e5, 293.15, effective_area=1e-6)
    error = np.abs(ellipse / nozzle[0] - nozzle / nozzle[0])
    assert 0.0015 < error.max() < 0.00152
    assert r[error.argmax()] == pytest.approx(0.872, abs=2e-3)


def regime_numbers(passage):
    names = ("critical_ratio", "cracking_pressure", "laminar_ratio", "one_way")
    return {name: passage[name] for name in names}

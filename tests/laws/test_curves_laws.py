"""Laws that hold for any characteristic: monotone, bounded, held, the same for floats, arrays and symbols."""

from __future__ import annotations

import sys
from functools import partial
from pathlib import Path

import casadi as ca
import numpy as np
from hypothesis import assume
from hypothesis import strategies as st
from scipy.interpolate import PchipInterpolator

from poppet.core.provenance import assumed
from poppet.laws.curves import (
    Characteristic,
    ConstantCurve,
    PolynomialCurve,
    TableCurve,
    pchip_slopes,
    rising_intervals,
)

sys.path.insert(0, str(Path(__file__).parent))
from repeated_laws import law as repeated_law

law = partial(repeated_law, few=25, many=150)
RATIO = ConstantCurve(assumed(0.35, "1", "test"))
values = st.floats(0.0, 5.0).map(lambda value: round(value, 6))


@st.composite
def tables(draw, least: int = 2):
    steps = draw(st.lists(st.floats(1e-5, 1e-3), min_size=least - 1, max_size=9))
    strokes = tuple(np.cumsum([draw(st.floats(-1e-3, 1e-3)), *steps]).tolist())
    chosen = draw(st.lists(values, min_size=len(strokes), max_size=len(strokes)))
    return TableCurve(strokes, tuple(assumed(value, "m^3/(s Pa)", "test") for value in chosen))


@st.composite
def polynomials(draw):
    """Positive on 0..1 mm: raised by what it lacks."""
    chosen = draw(st.lists(st.floats(-5.0, 5.0), min_size=2, max_size=8))
    lowest = float(np.min(np.polyval(chosen, np.linspace(0.0, 1.0, 2001))))
    chosen[-1] += max(0.0, -lowest) + 0.1
    return PolynomialCurve(tuple(assumed(value, "m^3/(s Pa)", "test") for value in chosen))


def owner(curve, **options) -> Characteristic:
    domain = curve.support if isinstance(curve, TableCurve) else (0.0, 1e-3)
    return Characteristic(curve, RATIO, domain=domain, **options)


def across(characteristic: Characteristic, points: int = 401) -> np.ndarray:
    low, high = characteristic.domain
    return np.linspace(low - 0.2 * (high - low), high + 0.2 * (high - low), points)


@law(tables())
def test_a_table_goes_through_its_points_and_never_overshoots(curve):
    points = np.array([float(number) for number in curve.values])
    scale = max(np.max(np.abs(points)), 1e-300)
    assert np.max(np.abs(curve(np.array(curve.strokes)) - points)) <= 1e-14 * scale
    x = np.linspace(curve.strokes[0], curve.strokes[-1], 301)
    segment = np.clip(np.searchsorted(curve.strokes, x, side="right") - 1, 0, len(points) - 2)
    low, high = np.minimum(points[:-1], points[1:])[segment], np.maximum(points[:-1], points[1:])[segment]
    assert np.all(curve(x) >= low - 1e-14 * scale)
    assert np.all(curve(x) <= high + 1e-14 * scale)


@law(tables())
def test_a_table_is_the_pchip_of_scipy(curve):
    points = [float(number) for number in curve.values]
    reference = PchipInterpolator(curve.strokes, points)
    x = np.linspace(curve.strokes[0], curve.strokes[-1], 101)
    assert np.max(np.abs(curve(x) - reference(x))) <= 1e-12 * max(1e-300, *np.abs(points))
    slopes = np.array(pchip_slopes(curve.strokes, points))
    expected = reference.derivative()(curve.strokes)
    assert np.max(np.abs(slopes - expected)) <= 1e-9 * max(1e-300, np.max(np.abs(expected)))


@law(st.one_of(tables(), polynomials()))
def test_running_maximum(curve):
    """It is the maximum so far, at every stroke, and rises nowhere else."""
    run = owner(curve, monotone=True)
    low, high = run.domain
    knots = np.array([low, high, *curve.turning_points(low, high)])
    x = np.unique(np.concatenate([np.linspace(low, high, 801), knots]))
    expected = np.maximum.accumulate(curve(x))
    scale = np.max(np.abs(expected))
    assert np.max(np.abs(run.sonic_conductance_at(x) - expected)) <= 1e-11 * max(scale, 1e-300)


@law(st.one_of(tables(), polynomials()))
def test_rising_intervals_are_disjoint_ordered_and_few(curve):
    low, high = owner(curve).domain
    rises = rising_intervals(curve, low, high)
    edges = [edge for rise in rises for edge in rise]
    assert edges == sorted(edges)
    assert all(low <= edge <= high for edge in edges)
    assert len(rises) <= (curve.pieces + 1) // 2


@law(st.one_of(tables(), polynomials()), st.booleans(), st.booleans())
def test_floats_arrays_and_symbols_agree(curve, monotone, closes):
    closing = assumed(1e-4, "m", "test") if closes else None
    chosen = owner(curve, monotone=monotone, closing=closing)
    stroke = ca.SX.sym("x")
    symbols = {name: ca.SX.sym(name) for name in chosen.parameters()}
    traced = ca.Function("f", [stroke, *symbols.values()], [chosen.sonic_conductance_at(stroke, symbols)])
    x = across(chosen, 21)
    array = chosen.sonic_conductance_at(x)
    own = chosen.parameters().values()
    scale = max(np.max(np.abs(array)), 1e-300)
    assert np.max(np.abs(array - [chosen.sonic_conductance_at(float(each)) for each in x])) <= 1e-13 * scale
    assert np.max(np.abs(array - [float(traced(each, *own)) for each in x])) <= 1e-12 * scale


@law(st.one_of(tables(), polynomials()))
def test_held_outside(curve):
    chosen = owner(curve)
    low, high = chosen.domain
    width = high - low
    beyond = chosen.sonic_conductance_at(np.array([low - width, low, high, high + width]))
    assert beyond[0] == beyond[1]
    assert beyond[2] == beyond[3]


@law(tables(least=3), st.floats(1e-5, 2e-4))
def test_closing_is_continuous_bounded_and_shut(curve, width):
    assume(curve.strokes[0] < 0.0 < curve.strokes[-1])
    bare, closed = owner(curve), owner(curve, closing=assumed(width, "m", "test"))
    x = across(closed, 2001)
    value, open_value = closed.sonic_conductance_at(x), bare.sonic_conductance_at(x)
    assert np.all(np.abs(value[x <= 0.0]) == 0.0)
    assert np.array_equal(value[x >= width], open_value[x >= width])
    assert np.all(np.abs(value) <= np.abs(open_value))


@law(st.one_of(tables(), polynomials()), st.data())
def test_a_changed_number_changes_values_but_neither_names_nor_structure(curve, data):
    chosen = owner(curve, monotone=True)
    name = data.draw(st.sampled_from([each for each in chosen.numbers() if each.startswith("sonic")]))
    raised = assumed(float(chosen.numbers()[name]) + 0.5, "m^3/(s Pa)", "test")
    changed = chosen.with_numbers({name: raised})
    assert changed.numbers()[name] == raised
    assert list(changed.parameters()) == list(chosen.parameters())
    assert changed.structure() == chosen.structure()

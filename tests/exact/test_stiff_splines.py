"""Splines of C(x) with default knots, compared with closed curves that share no code with the product."""

from __future__ import annotations

import numpy as np
import pytest

from exact.independent_characteristics import SHAPES, draw_curves
from poppet.identify.characteristic.identify_characteristic import identify_characteristic
from poppet.identify.characteristic.stroke_tests import StrokePoint

NAMES = ("sonic_conductance", "critical_ratio")


def identify_drawn(seed, shape="", form="spline"):
    """Return the result of noisy tests of a random valve, its curves, and the uncertainties of C (relative) and b."""
    *curves, strokes, u_conductance, u_ratio, generator = draw_curves(seed, shape)
    conductance, ratio = (curve(strokes) for curve in curves)
    errors = generator.standard_normal((strokes.size, 2)) * (u_conductance, u_ratio)
    measured = conductance * (1.0 + errors[:, 0]), ratio + errors[:, 1]
    rows = np.column_stack([strokes, *measured, u_conductance * conductance]).tolist()
    tests = [StrokePoint(*row, u_ratio) for row in rows]
    return identify_characteristic(tests, form=form), curves, strokes, u_conductance, u_ratio


@pytest.mark.parametrize("count", [2, pytest.param(60, marks=pytest.mark.slow)])
def test_default_knots_agree_with_the_curve_at_the_strokes(count):
    worst = []
    for seed in range(count):
        result, (conductance, _), strokes, u_conductance, _ = identify_drawn(seed)
        curve = result.series["sonic_conductance"]
        fitted, truth = (np.interp(strokes, curve["x"], y) for y in (curve["y"], conductance(curve["x"])))
        worst.append(float(np.max(np.abs(fitted / truth - 1.0)) / u_conductance))
        assert np.isfinite(result.comparison["aicc"])
    print(np.round(worst, 1))
    assert np.mean(np.array(worst) > 4.0) <= 0.05


def bands_of(shape, seeds):
    """Return the fraction of the range in which the bands of C and b contain the curve, and their relative width.

    The width is the median half width, divided by the standard uncertainty of one test.
    """
    rows = []
    for seed in seeds:
        result, curves, _, u_conductance, u_ratio = identify_drawn(seed, shape)
        for name, curve, error in zip(NAMES, curves, (u_conductance, u_ratio), strict=True):
            band = result.series[name]
            true, half = curve(band["x"]), 0.5 * (band["high"] - band["low"])
            scale = error * (true if name == NAMES[0] else 1.0)
            rows.append((np.mean((band["low"] <= true) & (true <= band["high"])), np.median(half / scale)))
    fractions, widths = (table.reshape(-1, 2).mean(axis=0) for table in np.array(rows).T)
    print(f"{shape}: {np.round(fractions, 3)} covered, median half width {np.round(widths, 2)} sigma")
    return fractions, widths


@pytest.mark.parametrize("count", [1, pytest.param(40, marks=pytest.mark.slow)])
def test_bands_of_splines_contain_95_percent_of_the_strokes(count):
    fractions, widths = zip(*[bands_of(shape, range(2000, 2000 + count)) for shape in SHAPES], strict=True)
    total = np.mean(fractions, axis=0)
    print(f"all: {np.round(total, 3)}")
    tolerance = 0.15 / count
    assert np.all(total >= 0.93 - tolerance)
    assert np.all(total <= 0.98 + tolerance)
    assert all(np.all(covered >= 0.90 - 3.0 * tolerance) for covered in fractions)
    # One test alone has a half width of 1.96 sigma; only the abrupt opening after a dead zone needs more.
    assert all(np.all(width < 3.5) for width in widths)


def test_polynomials_that_do_not_describe_the_tests_have_bands_with_the_curve():
    result, (conductance, _), *_ = identify_drawn(2000, "kinked", "polynomial")
    band = result.series["sonic_conductance"]
    true = conductance(band["x"])
    assert any(note.code == "characteristic.misfit" for note in result.remarks)
    assert np.mean((band["low"] <= true) & (true <= band["high"])) > 0.9


def test_aicc_is_finite_with_knots_at_all_strokes():
    conductance, ratio, strokes, u_conductance, u_ratio, _ = draw_curves(3)
    values = zip(strokes, conductance(strokes), ratio(strokes), strict=True)
    tests = [StrokePoint(float(x), float(c), float(b), float(u_conductance * c), u_ratio) for x, c, b in values]
    result = identify_characteristic(tests, form="spline", knots=strokes.tolist())
    assert np.isfinite(result.comparison["aicc"])

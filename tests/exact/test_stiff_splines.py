"""Splines of C(x) with default knots, compared with closed curves that share no code with the product."""

from __future__ import annotations

import numpy as np
import pytest

from exact.independent_characteristics import draw_curves
from poppet.identify.characteristic.identify_characteristic import identify_characteristic
from poppet.identify.characteristic.stroke_tests import StrokePoint


@pytest.mark.parametrize("count", [2, pytest.param(60, marks=pytest.mark.slow)])
def test_default_knots_agree_with_the_curve_at_the_strokes(count):
    worst = []
    for seed in range(count):
        conductance, ratio, strokes, u_conductance, u_ratio, generator = draw_curves(seed)
        errors = generator.standard_normal((strokes.size, 2))
        tests = [
            StrokePoint(float(x), float(c * (1.0 + u_conductance * e[0])), float(b + u_ratio * e[1]), float(u), u_ratio)
            for x, c, b, u, e in zip(
                strokes, conductance(strokes), ratio(strokes), u_conductance * conductance(strokes), errors, strict=True
            )
        ]
        result = identify_characteristic(tests, form="spline")
        curve = result.series["sonic_conductance"]
        fitted, truth = (np.interp(strokes, curve["x"], y) for y in (curve["y"], conductance(curve["x"])))
        worst.append(float(np.max(np.abs(fitted / truth - 1.0)) / u_conductance))
        assert np.isfinite(result.comparison["aicc"])
    print(np.round(worst, 1))
    assert np.mean(np.array(worst) > 4.0) <= 0.05


def test_aicc_is_finite_with_knots_at_all_strokes():
    conductance, ratio, strokes, u_conductance, u_ratio, _ = draw_curves(3)
    values = zip(strokes, conductance(strokes), ratio(strokes), strict=True)
    tests = [StrokePoint(float(x), float(c), float(b), float(u_conductance * c), u_ratio) for x, c, b in values]
    result = identify_characteristic(tests, form="spline", knots=strokes.tolist())
    assert np.isfinite(result.comparison["aicc"])

"""How much the regularised zone costs: the order of its error in the zone's width, and its size."""

from __future__ import annotations

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from poppet.iso6358 import mass_flow_rate

WIDTHS = np.array([8e-3, 4e-3, 2e-3, 1e-3, 5e-4])
RATIO = 0.3


def flow_ratio(r, width, ratio=RATIO):
    """Flow over choked flow at unit pressure."""
    return mass_flow_rate(
        1.0,
        r,
        1.0,
        sonic_conductance=1.0,
        critical_ratio=ratio,
        laminar_ratio=1.0 - width,
        reference_density=1.0,
        reference_temperature=1.0,
    )


def exact_flow_ratio(r, ratio=RATIO):
    return np.sqrt(1.0 - ((r - ratio) / (1.0 - ratio)) ** 2)


def orders(errors):
    return np.diff(np.log(errors)) / np.diff(np.log(WIDTHS))


def filling_error(width):
    """Largest pressure error of a tank filled isothermally from r = b on, over the supply pressure; K = 1.

    Exact: r = b + (1 - b) sin(t/(1 - b)) until full at t = (1 - b) pi/2; the two part at the zone's edge.
    """
    start = (1.0 - RATIO) * np.arcsin((1.0 - width - RATIO) / (1.0 - RATIO))
    full = (1.0 - RATIO) * np.pi / 2.0
    times = np.linspace(start, 2.0 * full - start, 2001)
    exact = RATIO + (1.0 - RATIO) * np.sin(np.minimum(times, full) / (1.0 - RATIO))
    solution = solve_ivp(
        lambda t, r: [flow_ratio(float(r[0]), width)],
        (times[0], times[-1]),
        [1.0 - width],
        t_eval=times,
        rtol=1e-10,
        atol=1e-14,
    )
    return np.max(np.abs(solution.y[0] - exact))


def test_tank_pressure_is_first_order_in_the_width():
    errors = np.array([filling_error(width) for width in WIDTHS])
    assert np.all((orders(errors) > 0.99) & (orders(errors) < 1.01))
    assert np.all(errors / WIDTHS < 0.112)


def test_flow_in_the_zone_errs_with_the_root_of_the_width():
    z = np.linspace(0.0, 1.0, 2001)
    errors = np.array([np.max(np.abs(flow_ratio(1.0 - w * z, w) - exact_flow_ratio(1.0 - w * z))) for w in WIDTHS])
    assert np.all((orders(errors) > 0.48) & (orders(errors) < 0.52))
    assert errors[WIDTHS == 1e-3] < 0.011


@pytest.mark.parametrize("ratio", [0.0, 0.3, 0.5])
def test_no_error_outside_the_zone(ratio):
    r = np.linspace(ratio, 1.0 - WIDTHS.max(), 101)
    for width in WIDTHS:
        assert flow_ratio(r, width, ratio) == pytest.approx(exact_flow_ratio(r, ratio), rel=1e-13)


def test_area_under_the_remaining_drop_is_better_than_first_order():
    """The supply's pressure less the tank's, integrated over the filling time: what a fit of pressures sees.

    Exact from r = b on, with u = (r - b)/(1 - b): (1 - b)^2 times the integral of
    (1 - u)/sqrt(1 - u^2) du, which is pi/2 - 1.
    """
    exact = (1.0 - RATIO) ** 2 * (np.pi / 2.0 - 1.0)
    errors = []
    for width in WIDTHS:
        zone = 1.0 - width * np.linspace(1.0, 1e-9, 2001)
        r = np.concatenate([np.linspace(RATIO, 1.0 - width, 40_000, endpoint=False), zone])
        errors.append(abs(np.trapezoid((1.0 - r) / flow_ratio(r, width), r) - exact))
    assert np.all((orders(np.array(errors)) > 1.45) & (orders(np.array(errors)) < 1.55))

"""Varga & Keski-Honkola 2012, Table 1: the printed polynomials and the facts that follow from them."""

from __future__ import annotations

import numpy as np
import pytest

from poppet import library
from poppet.core.errors import OutOfRangeError
from poppet.core.provenance import Number
from poppet.core.symbolic import smoothstep

PRINTED_B = [3.16180, -8.31770, 7.68470, -2.73840, 0.71748]
PRINTED_C = [-1.1858e-6, 4.5064e-6, -6.9209e-6, 5.4385e-6, -2.2269e-6, 3.7653e-7, 2.1902e-8, 5.0034e-9]

# stroke [mm], C [1e-8 m^3/(s Pa)], b, and half a unit of the last digit shown
POINTS = [
    (0.0, 0.50034, 0.71748, 5e-6),
    (0.1, 0.9211, 0.5125, 5e-5),
    (0.2, 1.3390, 0.4157, 5e-5),
    (0.3, 1.5595, 0.3886, 5e-5),
    (0.4, 1.6358, 0.4003, 5e-5),
    (0.5, 1.65010, 0.4274, 5e-5),
    (0.6, 1.6401, 0.4541, 5e-5),
    (0.7, 1.6114, 0.4723, 5e-5),
    (0.8, 1.5746, 0.4814, 5e-5),
    (0.9, 1.5493, 0.4884, 5e-5),
    (1.0, 1.47354, 0.50788, 5e-6),
]
FINE = np.linspace(0.0, 1e-3, 1_000_001)


@pytest.fixture(scope="module")
def printed():
    return library.characteristic("varga2012")


def rounded_to(curve, digits: int):
    """The characteristic with its coefficients cut to so many significant digits."""
    cut = {
        name: Number(float(f"{number.value:.{digits - 1}e}"), number.unit, number.source)
        for name, number in curve.numbers().items()
    }
    return curve.with_numbers(cut)


def test_coefficients_are_the_printed_ones(printed):
    numbers = printed.numbers()
    assert [numbers[f"critical_ratio.p{i}"].value for i in range(1, 6)] == PRINTED_B
    assert [numbers[f"sonic_conductance.k{i}"].value for i in range(1, 9)] == PRINTED_C


@pytest.mark.parametrize(("millimetres", "conductance", "ratio", "digit"), POINTS)
@pytest.mark.parametrize("variant", ["varga2012", "varga2012.table"])
def test_eleven_points(variant, millimetres, conductance, ratio, digit):
    chosen = library.characteristic(variant)
    assert abs(chosen.sonic_conductance_at(millimetres * 1e-3) * 1e8 - conductance) <= digit
    assert abs(chosen.critical_ratio_at(millimetres * 1e-3) - ratio) <= digit


def test_polynomials_against_numpy_in_millimetres(printed):
    x = FINE[::1000]
    assert np.max(np.abs(printed.sonic_conductance_at(x) - np.polyval(PRINTED_C, 1e3 * x))) < 1e-21
    assert np.max(np.abs(printed.critical_ratio_at(x) - np.polyval(PRINTED_B, 1e3 * x))) < 1e-14


def test_there_is_no_closed_state(printed):
    assert printed.sonic_conductance_at(0.0) == 5.0034e-9


def test_conductance_peaks_at_half_stroke_and_falls_by_a_tenth(printed):
    conductance = printed.sonic_conductance_at(FINE)
    peak = conductance.argmax()
    assert FINE[peak] * 1e3 == pytest.approx(0.49901, abs=5e-6)
    assert conductance[peak] == pytest.approx(1.650097e-8, abs=5e-15)
    assert 1.0 - conductance[-1] / conductance[peak] == pytest.approx(0.107, abs=5e-4)


def test_the_ratio_has_its_minimum_at_a_third_of_the_stroke(printed):
    ratio = printed.critical_ratio_at(FINE)
    assert FINE[ratio.argmin()] * 1e3 == pytest.approx(0.30863, abs=5e-6)
    assert ratio.min() == pytest.approx(0.38848, abs=5e-6)


def test_outside_the_polynomial_is_meaningless_and_not_used(printed):
    assert printed.sonic_conductance(1.2e-3) == pytest.approx(-1.16e-8, abs=5e-11)
    assert printed.sonic_conductance_at(1.2e-3) == printed.sonic_conductance_at(1e-3)


def test_the_error_edge_says_so(printed):
    strict = type(printed)(
        printed.sonic_conductance,
        printed.critical_ratio,
        domain=printed.domain,
        edge="error",
        name=printed.name,
        source=printed.source,
    )
    with pytest.raises(OutOfRangeError) as caught:
        strict.sonic_conductance_at(1.2e-3)
    assert str(caught.value) == (
        "stroke = 1.20 mm is outside the range 0 ... 1.00 mm, in which C(x) was fitted (varga2012, Table 1). "
        'At this stroke, the polynomial would give C = -1.16e-08 m^3/(s Pa). Limit the stroke, or set edge = "hold" '
        "to use the value at the nearest end of the range."
    )


def test_no_digit_may_be_dropped(printed):
    """Four digits move C(1 mm) by 9 %; the printed five are needed."""
    cut = rounded_to(printed, 4)
    assert abs(cut.sonic_conductance_at(1e-3) / printed.sonic_conductance_at(1e-3) - 1.0) == pytest.approx(
        0.09, abs=0.005
    )


def test_the_suspected_misprint(printed):
    """With k5 = -2.2229e-6 the maximum would be 1.88e-8; the default never uses it."""
    k5 = printed.numbers()["sonic_conductance.k5"]
    suspected = printed.with_numbers({"sonic_conductance.k5": Number(-2.2229e-6, k5.unit, k5.source)})
    assert suspected.sonic_conductance_at(FINE).max() == pytest.approx(1.88e-8, abs=5e-11)
    assert k5.value == -2.2269e-6
    assert "-2.2229e-6" in k5.source.note


# --- variants ---


def test_closed_variant(printed):
    closed = library.characteristic("varga2012.closed")
    assert np.max(np.abs(closed.sonic_conductance_at(np.array([-1e-3, -1e-6, 0.0])))) == 0.0
    x = FINE[:40_000]
    expected = printed.sonic_conductance_at(x) * smoothstep(x, 0.0, 2e-5)
    assert np.max(np.abs(closed.sonic_conductance_at(x) - expected)) == 0.0
    assert closed.sonic_conductance_at(2e-5) == printed.sonic_conductance_at(2e-5)


def test_monotone_variant(printed):
    monotone = library.characteristic("varga2012.monotone")
    x = FINE[20_000:]  # beyond the closing
    expected = np.maximum.accumulate(printed.sonic_conductance_at(x))
    assert np.max(np.abs(monotone.sonic_conductance_at(x) - expected)) < 1e-20
    assert monotone.sonic_conductance_at(1e-3) == pytest.approx(1.650097e-8, abs=5e-15)
    assert np.all(np.diff(monotone.sonic_conductance_at(FINE)) >= 0.0)
    assert monotone.sonic_conductance_at(0.0) == 0.0
    assert np.array_equal(monotone.critical_ratio_at(x), printed.critical_ratio_at(x))


def test_table_variant_stays_near_the_polynomial(printed):
    table = library.characteristic("varga2012.table")
    difference = np.abs(table.sonic_conductance_at(FINE) - printed.sonic_conductance_at(FINE))
    assert difference.max() == pytest.approx(0.0205 * 1.650097e-8, rel=0.01)

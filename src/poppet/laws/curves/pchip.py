"""Slopes of a monotone piecewise cubic interpolation (PCHIP)."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import pairwise

import numpy as np


def pchip_slopes(x: Sequence[float], y: Sequence[float]) -> list[float]:
    r"""Return the slopes of a monotone piecewise cubic interpolation at its knots.

    At an inner knot, the slope d is the weighted harmonic mean of the slopes m of the neighbouring chords, whose widths
    are h. It is zero if the slopes m differ in sign or if one of them is zero.

    .. math:: d_i = \frac{w_1 + w_2}{w_1/m_{i-1} + w_2/m_i},\quad
              w_1 = 2 h_i + h_{i-1},\quad w_2 = h_i + 2 h_{i-1}

    Parameters
    ----------
    x : sequence of float, shape (n,)
        Strictly increasing knots [m].
    y : sequence of float, shape (n,)
        Values at the knots, in any unit.

    Returns
    -------
    list of float, shape (n,)
        Slopes at the knots, in the unit of `y` per metre.

    Notes
    -----
    scipy.interpolate.PchipInterpolator uses the same slopes. At the ends, the slope is that of the parabola through
    three points, limited so that the first and the last segment are monotone.

    References
    ----------
    Fritsch & Butland 1984, SIAM J. Sci. Stat. Comput. 5, 300-304; the ends after Moler 2004, Numerical
    Computing with MATLAB, section 3.4.

    Examples
    --------
    >>> pchip_slopes([0.0, 1.0, 2.0], [0.0, 1.0, 2.0])
    [1.0, 1.0, 1.0]
    """
    h = [right - left for left, right in pairwise(x)]
    m = [(right - left) / width for (left, right), width in zip(pairwise(y), h, strict=True)]
    if len(m) == 1:
        return [m[0], m[0]]
    inner = []
    for (h0, h1), (m0, m1) in zip(pairwise(h), pairwise(m), strict=True):
        # A zero slope at an extremum of the points prevents overshoot of the curve.
        is_extremum = m0 == 0.0 or m1 == 0.0 or (m0 > 0.0) != (m1 > 0.0)
        w1, w2 = 2.0 * h1 + h0, h1 + 2.0 * h0
        inner.append(0.0 if is_extremum else (w1 + w2) / (w1 / m0 + w2 / m1))
    return [_end_slope(h[0], h[1], m[0], m[1]), *inner, _end_slope(h[-1], h[-2], m[-1], m[-2])]


def _end_slope(h0: float, h1: float, m0: float, m1: float) -> float:
    """Return the slope at an end of the interpolation, from three points.

    `h0` and `h1` are the lengths of the first two segments, and `m0` and `m1` the slopes of their chords. The slope is
    limited so that the first segment is monotone.
    """
    slope = ((2.0 * h0 + h1) * m0 - h0 * m1) / (h0 + h1)
    if np.sign(slope) != np.sign(m0):
        return 0.0
    if np.sign(m0) != np.sign(m1) and abs(slope) > 3.0 * abs(m0):
        return 3.0 * m0
    return slope

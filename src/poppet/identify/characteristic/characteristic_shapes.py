"""Curve shapes for C(x) and b(x), polynomials and monotone cubic splines, with scaled parameters."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from poppet.laws.curves import pchip_slopes
from poppet.timeseries.checks import FloatArray as Array

MILLIMETRES = 1e3
LARGEST_RATIO = 0.999
"""Upper bound of b at the knots of a spline."""
STEP = 1e-7
"""Step of the forward differences, relative to the largest free parameter."""


@dataclass(frozen=True)
class PolynomialShape:
    """Curve that is a polynomial of the stroke.

    The polynomial is a Chebyshev series over the domain, because powers of the stroke are ill-conditioned. From 0 to 1
    mm, powers up to degree 7 have a condition number of about 1e5, and Chebyshev polynomials of about 2.
    """

    degree: int
    domain: tuple[float, float]  # first and last stroke [m]
    scale: float = 1.0

    @property
    def size(self) -> int:
        """Number of free parameters of the polynomial."""
        return self.degree + 1

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds of the free parameters of the polynomial, (size,) each."""
        return np.full(self.size, -np.inf), np.full(self.size, np.inf)

    @cached_property
    def numbers_matrix(self) -> Array:
        """Matrix that converts Chebyshev coefficients to coefficients of powers of the stroke in mm.

        The resulting coefficients must still be multiplied by the scale of the curve.
        """
        from numpy.polynomial import Chebyshev, Polynomial

        window = [MILLIMETRES * x for x in self.domain]
        columns = np.zeros((self.size, self.size))
        for k in range(self.size):
            powers = Chebyshev.basis(k, domain=window).convert(kind=Polynomial).coef
            columns[self.size - powers.size :, k] = powers[::-1]
        return columns

    def numbers(self, theta: Array) -> Array:
        """Return the coefficients of the polynomial, highest power first.

        The argument of the polynomial is the stroke in mm. `theta` contains the free parameters.
        """
        return np.asarray(self.scale * (self.numbers_matrix @ theta))

    def values(self, theta: Array, x: Array) -> Array:
        """Return the curve at the strokes `x`, (n,), in the unit of the curve.

        `theta` contains the free parameters.
        """
        return np.asarray(self.slopes(theta, x) @ theta)

    def slopes(self, theta: Array, x: Array) -> Array:
        """Return the derivatives of the curve by its free parameters, (n, size).

        `theta` contains the free parameters, and `x` the strokes, (n,).
        """
        low, high = self.domain
        powers = np.polynomial.chebyshev.chebvander((2.0 * x - low - high) / (high - low), self.degree)
        return np.asarray(self.scale * powers, dtype=float)


@dataclass(frozen=True)
class SplineShape:
    """Monotone piecewise cubic curve (PCHIP) through values at knots.

    The free parameters are the values at the free knots. For a curve that must not fall, they are the first value and
    the increments between knots. The curve is extrapolated linearly below the first free knot, and is constant above
    the last.
    """

    knots: tuple[float, ...]  # strictly increasing strokes at which values are free [m]
    rises: bool  # True if the free parameters are increments between knots, False if they are values
    constrained: bool = True  # True if increments must not be negative
    upper: float = np.inf  # upper bound of the values at the knots; the lower bound is 0
    scale: float = 1.0
    first: float = np.inf  # first stroke of the curve; the next field is the last one [m]
    last: float = -np.inf

    @property
    def size(self) -> int:
        """Number of free parameters of the spline."""
        return len(self.knots)

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds of the free parameters of the spline, (size,) each."""
        low = np.full(self.size, 0.0 if self.constrained or not self.rises else -np.inf)
        low[0] = 0.0
        return low, np.full(self.size, self.upper / self.scale)

    @property
    def table_knots(self) -> tuple[float, ...]:
        """Strokes of all knots, including added knots at the ends of the domain [m]."""
        start_knots = (self.first,) if self.first < self.knots[0] else ()
        end_knots = (self.last,) if self.last > self.knots[-1] else ()
        return (*start_knots, *self.knots, *end_knots)

    @cached_property
    def numbers_matrix(self) -> Array:
        """Matrix that converts the free parameters of the spline to its values at all knots.

        The resulting values must still be multiplied by the scale of the curve.
        """
        free = np.tril(np.ones((self.size, self.size))) if self.rises else np.eye(self.size)
        rows = [free]
        if self.first < self.knots[0]:
            reach = (self.knots[0] - self.first) / (self.knots[1] - self.knots[0])
            rows.insert(0, (free[0] - reach * (free[1] - free[0]))[None, :])
        if self.last > self.knots[-1]:
            rows.append(free[-1:])
        return np.vstack(rows)

    def numbers(self, theta: Array) -> Array:
        """Return the values of the spline at all knots, in the unit of the curve.

        `theta` contains the free parameters.
        """
        values = self.scale * self._at_knots(theta)
        # Rounding errors could make sums of increments fall.
        return np.maximum.accumulate(values) if self.rises and self.constrained else values

    def _at_knots(self, theta: Array) -> Array:
        # The extrapolation before the first knot must stay within the bounds.
        values = self.numbers_matrix @ theta
        if self.first < self.knots[0]:
            values[0] = np.clip(values[0], 0.0, self.upper / self.scale)
        return np.asarray(values)

    def values(self, theta: Array, x: Array) -> Array:
        """Return the curve at the strokes `x`, (n,), in the unit of the curve.

        `theta` contains the free parameters.
        """
        return self.scale * pchip(self.table_knots, self._at_knots(theta), x)

    def slopes(self, theta: Array, x: Array) -> Array:
        """Return the derivatives of the curve by its free parameters, (n, size).

        `theta` contains the free parameters, and `x` the strokes, (n,).
        """
        base = self.values(theta, x)
        step = STEP * max(float(np.max(np.abs(theta))), 1e-3)
        shifted = [self.values(theta + step * row, x) for row in np.eye(self.size)]
        return (np.column_stack(shifted) - base[:, None]) / step


Shape = PolynomialShape | SplineShape
"""Curve versus stroke whose free parameters are of order one."""


def start_parameters(shape: Shape, x: Array, y: Array, weight: Array) -> Array:
    """Return start values of the free parameters of a curve, from a weighted linear fit to points.

    `x`, `y` and `weight` are the positions, the values and the weights of the points. The result is limited to the
    bounds.
    """
    low, high = shape.bounds
    rows = shape.slopes(np.clip(np.full(shape.size, 0.5), low, high), x) * weight[:, None]
    return np.clip(np.linalg.lstsq(rows, y * weight, rcond=1e-10)[0], low, high)


def pchip(knots: tuple[float, ...], values: Array, x: Array) -> Array:
    """Evaluate a monotone piecewise cubic curve through `values` at `knots`, at the positions `x`.

    Beyond the knots the curve is constant. The curve class `TableCurve` uses the same interpolation.

    Examples
    --------
    >>> pchip((0.0, 1.0, 2.0), np.array([0.0, 1.0, 2.0]), np.array([0.5, 3.0])).tolist()
    [0.5, 2.0]
    """
    positions, slopes = np.asarray(knots), np.asarray(pchip_slopes(knots, values.tolist()))
    left = np.clip(np.searchsorted(positions, x, side="right") - 1, 0, positions.size - 2)
    width = positions[left + 1] - positions[left]
    t = np.clip((x - positions[left]) / width, 0.0, 1.0)
    chord = values[left + 1] - values[left]
    start_parameters, end = width * slopes[left], width * slopes[left + 1]
    return np.asarray(
        values[left]
        + t
        * (
            start_parameters
            + t * (3.0 * chord - 2.0 * start_parameters - end + t * (start_parameters + end - 2.0 * chord))
        )
    )


def select_knots(strokes: Array, count: int) -> tuple[float, ...]:
    """Select evenly distributed knots from the tested strokes.

    The result contains `count` strokes, with the first and the last.
    """
    indices = np.round(np.linspace(0, strokes.size - 1, count)).astype(int)
    return tuple(strokes[indices].tolist())

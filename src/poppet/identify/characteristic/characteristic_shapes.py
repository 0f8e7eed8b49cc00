"""Shapes of C(x) and b(x) with free numbers of order one: polynomials, and monotone cubics with bounds."""

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
"""Of the forward differences in the values at the knots, over the largest of them."""


@dataclass(frozen=True)
class PolynomialShape:
    """A polynomial, kept as a Chebyshev series over the domain.

    Over 0..1 mm the powers of degree 7 have a condition number of some 1e5, the Chebyshev polynomials of about 2.
    """

    degree: int
    domain: tuple[float, float]  # first and last stroke [m]
    scale: float = 1.0

    @property
    def size(self) -> int:
        """Number of free numbers."""
        return self.degree + 1

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds of the free numbers, (size,) each."""
        return np.full(self.size, -np.inf), np.full(self.size, np.inf)

    @cached_property
    def numbers_matrix(self) -> Array:
        """What turns the free numbers into those of a characteristic, without the scale."""
        from numpy.polynomial import Chebyshev, Polynomial

        window = [MILLIMETRES * x for x in self.domain]
        columns = np.zeros((self.size, self.size))
        for k in range(self.size):
            powers = Chebyshev.basis(k, domain=window).convert(kind=Polynomial).coef
            columns[self.size - powers.size :, k] = powers[::-1]
        return columns

    def numbers(self, theta: Array) -> Array:
        """Coefficients, highest power first."""
        return np.asarray(self.scale * (self.numbers_matrix @ theta))

    def values(self, theta: Array, x: Array) -> Array:
        """The curve at strokes, (n,), in its unit."""
        return np.asarray(self.slopes(theta, x) @ theta)

    def slopes(self, theta: Array, x: Array) -> Array:
        """Derivatives of the curve by the free numbers, (n, size)."""
        low, high = self.domain
        powers = np.polynomial.chebyshev.chebvander((2.0 * x - low - high) / (high - low), self.degree)
        return np.asarray(self.scale * powers, dtype=float)


@dataclass(frozen=True)
class SplineShape:
    """A monotone piecewise cubic (PCHIP) through knots; a rising one has non-negative increments as free numbers.

    Beyond the free knots the curve goes straight on before the first, and is held after the last.
    """

    knots: tuple[float, ...]  # strictly increasing strokes at which values are free [m]
    rises: bool  # the free numbers are the increments from knot to knot, else the values
    constrained: bool = True  # increments are not negative
    upper: float = np.inf  # bound of the values at the knots; they are never negative
    scale: float = 1.0
    first: float = np.inf  # ends of the curve [m]
    last: float = -np.inf

    @property
    def size(self) -> int:
        """Number of free numbers."""
        return len(self.knots)

    @property
    def bounds(self) -> tuple[Array, Array]:
        """Lower and upper bounds of the free numbers, (size,) each."""
        low = np.full(self.size, 0.0 if self.constrained or not self.rises else -np.inf)
        low[0] = 0.0
        return low, np.full(self.size, self.upper / self.scale)

    @property
    def table_knots(self) -> tuple[float, ...]:
        """Knots of the curve, those at its ends that are not free included [m]."""
        before = (self.first,) if self.first < self.knots[0] else ()
        after = (self.last,) if self.last > self.knots[-1] else ()
        return (*before, *self.knots, *after)

    @cached_property
    def numbers_matrix(self) -> Array:
        """What turns the free numbers into those of a characteristic, without the scale."""
        free = np.tril(np.ones((self.size, self.size))) if self.rises else np.eye(self.size)
        rows = [free]
        if self.first < self.knots[0]:
            reach = (self.knots[0] - self.first) / (self.knots[1] - self.knots[0])
            rows.insert(0, (free[0] - reach * (free[1] - free[0]))[None, :])
        if self.last > self.knots[-1]:
            rows.append(free[-1:])
        return np.vstack(rows)

    def numbers(self, theta: Array) -> Array:
        """Values at the knots."""
        values = self.scale * self._at_knots(theta)
        # Sums of increments may fall by a rounding error.
        return np.maximum.accumulate(values) if self.rises and self.constrained else values

    def _at_knots(self, theta: Array) -> Array:
        # Going straight on before the first knot must not leave what is possible.
        values = self.numbers_matrix @ theta
        if self.first < self.knots[0]:
            values[0] = np.clip(values[0], 0.0, self.upper / self.scale)
        return np.asarray(values)

    def values(self, theta: Array, x: Array) -> Array:
        """The curve at strokes, (n,), in its unit."""
        return self.scale * pchip(self.table_knots, self._at_knots(theta), x)

    def slopes(self, theta: Array, x: Array) -> Array:
        """Derivatives of the curve by the free numbers, (n, size)."""
        base = self.values(theta, x)
        step = STEP * max(float(np.max(np.abs(theta))), 1e-3)
        moved = [self.values(theta + step * row, x) for row in np.eye(self.size)]
        return (np.column_stack(moved) - base[:, None]) / step


Shape = PolynomialShape | SplineShape
"""A curve over the stroke whose free numbers are of order one."""


def start(shape: Shape, x: Array, y: Array, weight: Array) -> Array:
    """Free numbers of a weighted straight fit, inside the bounds."""
    low, high = shape.bounds
    rows = shape.slopes(np.clip(np.full(shape.size, 0.5), low, high), x) * weight[:, None]
    return np.clip(np.linalg.lstsq(rows, y * weight, rcond=1e-10)[0], low, high)


def pchip(knots: tuple[float, ...], values: Array, x: Array) -> Array:
    """Monotone piecewise cubic through points, held beyond them; the curve of `TableCurve`, on plain arrays.

    Examples
    --------
    >>> pchip((0.0, 1.0, 2.0), np.array([0.0, 1.0, 2.0]), np.array([0.5, 3.0])).tolist()
    [0.5, 2.0]
    """
    at, slopes = np.asarray(knots), np.asarray(pchip_slopes(knots, values.tolist()))
    left = np.clip(np.searchsorted(at, x, side="right") - 1, 0, at.size - 2)
    width = at[left + 1] - at[left]
    t = np.clip((x - at[left]) / width, 0.0, 1.0)
    chord = values[left + 1] - values[left]
    start, end = width * slopes[left], width * slopes[left + 1]
    return np.asarray(
        values[left] + t * (start + t * (3.0 * chord - 2.0 * start - end + t * (start + end - 2.0 * chord)))
    )


def spread_knots(strokes: Array, count: int) -> tuple[float, ...]:
    """Some of the tested strokes, spread evenly over them, the first and the last included."""
    places = np.round(np.linspace(0, strokes.size - 1, count)).astype(int)
    return tuple(strokes[places].tolist())

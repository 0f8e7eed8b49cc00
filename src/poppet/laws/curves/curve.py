"""Interface of curves: scalar functions of a stroke."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Hashable, Mapping
from itertools import pairwise
from typing import Any, ClassVar, Self

from poppet.core.errors import InputError, NameSuggestion, raise_errors
from poppet.core.provenance import Number


class Curve(ABC):
    """Base class of a quantity that is a function of the stroke."""

    known: ClassVar[str]
    """Verb in messages about the range of the curve, for example "was fitted"."""
    extrapolates: ClassVar[bool] = False
    """True if the formula gives a meaningless value beyond the range, which an error can show."""

    @abstractmethod
    def numbers(self) -> dict[str, Number]:
        """Return the parameters of the curve, with unit and source, by name, such as `k1`."""

    @abstractmethod
    def parameters(self) -> dict[str, float]:
        """Return all values in the equation of the curve, by name.

        They are the parameters as floats in SI units, and values that are computed from them, such as slopes.
        """

    @abstractmethod
    def evaluate(self, x: Any, parameters: Mapping[str, Any]) -> Any:
        """Return the value of the curve at a stroke for given parameters.

        Parameters
        ----------
        x : float, array or symbol
            Stroke [m].
        parameters : mapping of str to float or symbol
            Values under the names that the method `parameters` returns.

        Returns
        -------
        float, array or symbol
            Value in the unit of the curve.
        """

    @abstractmethod
    def turning_points(self, low: float, high: float) -> tuple[float, ...]:
        """Return the strokes at which the curve can change between rising and falling.

        Parameters
        ----------
        low, high : float
            Range of strokes that is searched [m].

        Returns
        -------
        tuple of float
            Strokes in ascending order, strictly between `low` and `high` [m].
        """

    @property
    @abstractmethod
    def pieces(self) -> int:
        """Maximum number of monotone pieces of the curve for any values of its parameters."""

    @property
    def support(self) -> tuple[float, float]:
        """Lowest and highest stroke at which the curve is known [m].

        Both are infinite for a formula, which has a value at any stroke.
        """
        return (-math.inf, math.inf)

    @abstractmethod
    def structure(self) -> Hashable:
        """Return a hashable key of the equation of the curve.

        Curves with equal keys differ only in the values of their parameters.
        """

    @abstractmethod
    def with_numbers(self, changes: Mapping[str, Number]) -> Self:
        """Return the curve with some parameters replaced.

        Parameters
        ----------
        changes : mapping of str to Number
            New parameters, under the names that the method `numbers` returns.

        Returns
        -------
        Curve
            Copy with the new parameters.
        """

    def _changed_numbers(self, changes: Mapping[str, Number]) -> dict[str, Number]:
        """Return all parameters of the curve by name, some of them replaced.

        Unknown names in `changes` are rejected.
        """
        numbers = self.numbers()
        unknown = [name for name in changes if name not in numbers]
        meaning = "a parameter of this curve"
        raise_errors(
            [InputError("names.unknown", n, meaning=meaning, suggestion=NameSuggestion(n, numbers)) for n in unknown]
        )
        return {**numbers, **changes}

    def __call__(self, x: Any) -> Any:
        """Return the value of the curve at stroke `x` [m]."""
        return self.evaluate(x, self.parameters())


def rising_intervals(curve: Curve, low: float, high: float) -> list[tuple[float, float]]:
    """Return the intervals of the stroke in which the running maximum of a curve increases.

    The running maximum at a stroke is the largest value up to this stroke.

    Parameters
    ----------
    curve : Curve
        Curve that may rise and fall.
    low, high : float
        Range of strokes; the running maximum begins at `low` [m].

    Returns
    -------
    list of tuple of float, shape (n, 2)
        Start and end stroke of each interval, in ascending order [m].

    Examples
    --------
    >>> from poppet.laws.curves import TableCurve
    >>> from poppet.core.provenance import assumed
    >>> values = tuple(assumed(value, "1", "example") for value in (0.0, 2.0, 1.0, 3.0))
    >>> rises = rising_intervals(TableCurve((0.0, 1.0, 2.0, 3.0), values), 0.0, 3.0)
    >>> [(round(start, 3), round(end, 3)) for start, end in rises]
    [(0.0, 1.0), (2.68, 3.0)]
    """
    # The curve is monotone between turning points. A piece that ends below the level has no rise.
    level = float(curve(low))
    rises: list[tuple[float, float]] = []
    for left, right in pairwise([low, *curve.turning_points(low, high), high]):
        if float(curve(right)) <= level:
            continue
        start = left if float(curve(left)) >= level else _stroke_of_level(curve, level, left, right)
        # A turning point within a rise (a knot of a rising table) does not divide the rise.
        if rises and rises[-1][1] == start:
            start = rises.pop()[0]
        rises.append((start, right))
        level = float(curve(right))
    return rises


def _stroke_of_level(curve: Curve, level: float, left: float, right: float) -> float:
    """Return the stroke at which a rising curve reaches a level.

    The curve rises between the strokes `left` and `right` [m]. `level` is in the unit of the curve. The result is the
    next floating-point number above the exact stroke.
    """
    while True:
        middle = 0.5 * (left + right)
        if not left < middle < right:
            return right
        if float(curve(middle)) < level:
            left = middle
        else:
            right = middle

"""What every scalar function of a stroke offers, and where its running maximum rises."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from collections.abc import Hashable, Mapping, Sequence
from itertools import pairwise
from typing import Any, ClassVar, Self

from poppet.core.errors import InputError, NameSuggestion, collect
from poppet.core.provenance import Number


class Curve(ABC):
    """A scalar function of a stroke."""

    known: ClassVar[str]
    """How its range came about, as a report says it: `C(x)` "was fitted"."""
    extrapolates: ClassVar[bool] = False
    """Whether the formula gives a (meaningless) value beyond the range, worth telling in an error."""

    @abstractmethod
    def numbers(self) -> dict[str, Number]:
        """The numbers of the curve under the last part of their address, `k1`."""

    @abstractmethod
    def parameters(self) -> dict[str, float]:
        """What `evaluate` reads: the numbers in SI, and what is derived from them."""

    @abstractmethod
    def evaluate(self, x: Any, parameters: Mapping[str, Any]) -> Any:
        """Value at a stroke with the given parameters.

        Parameters
        ----------
        x : float, array or symbol
            Stroke [m].
        parameters : mapping of str to float or symbol
            Values under the names of `parameters()`.

        Returns
        -------
        float, array or symbol
            The curve's value, in its own unit.
        """

    @abstractmethod
    def turning_points(self, low: float, high: float) -> tuple[float, ...]:
        """Strokes that split the curve into monotone pieces.

        Parameters
        ----------
        low, high : float
            Strokes at which the first piece starts and the last one ends [m].

        Returns
        -------
        tuple of float
            In order, strictly between the two [m].
        """

    @property
    @abstractmethod
    def pieces(self) -> int:
        """Upper bound of the number of monotone pieces; independent of the numbers' values."""

    @property
    def support(self) -> tuple[float, float]:
        """First and last stroke [m] about which the curve knows anything; a formula knows all."""
        return (-math.inf, math.inf)

    @abstractmethod
    def structure(self) -> Hashable:
        """What of the curve is compiled in: curves that agree in it differ only in run-time parameters."""

    @abstractmethod
    def _with_values(self, values: Sequence[Number]) -> Self:
        """The same curve with other numbers, in the order of `numbers()`."""

    def with_numbers(self, changes: Mapping[str, Number]) -> Self:
        """The same curve with some numbers replaced.

        Parameters
        ----------
        changes : mapping of str to Number
            New numbers under the names of `numbers()`.

        Returns
        -------
        Curve
            A new curve of the same kind.
        """
        numbers = self.numbers()
        unknown = [name for name in changes if name not in numbers]
        collect([InputError("curves.no_number_of_curve", name, near=NameSuggestion(name, numbers)) for name in unknown])
        return self._with_values(list({**numbers, **changes}.values()))

    def __call__(self, x: Any) -> Any:
        """Value at stroke `x` [m] with the curve's own numbers."""
        return self.evaluate(x, self.parameters())


def rising_intervals(curve: Curve, low: float, high: float) -> list[tuple[float, float]]:
    """Intervals over which the running maximum of a curve rises; between them it stays.

    Parameters
    ----------
    curve : Curve
        Any curve with turning points.
    low, high : float
        Strokes at which the running maximum starts and ends [m].

    Returns
    -------
    list of tuple of float, shape (n, 2)
        Start and end of each rise, in order [m].

    Examples
    --------
    >>> from poppet.laws.curves import TableCurve
    >>> from poppet.core.provenance import assumed
    >>> values = tuple(assumed(value, "1", "example") for value in (0.0, 2.0, 1.0, 3.0))
    >>> rises = rising_intervals(TableCurve((0.0, 1.0, 2.0, 3.0), values), 0.0, 3.0)
    >>> [(round(start, 3), round(end, 3)) for start, end in rises]
    [(0.0, 1.0), (2.68, 3.0)]
    """
    # Between two turning points the curve is monotone: a piece whose end is no higher than the level has no rise.
    level = float(curve(low))
    rises: list[tuple[float, float]] = []
    for left, right in pairwise([low, *curve.turning_points(low, high), high]):
        if float(curve(right)) <= level:
            continue
        start = left if float(curve(left)) >= level else _crossing(curve, level, left, right)
        # A turning point within a rise (a knot of a rising table) does not cut it in two.
        if rises and rises[-1][1] == start:
            start = rises.pop()[0]
        rises.append((start, right))
        level = float(curve(right))
    return rises


def _crossing(curve: Curve, level: float, left: float, right: float) -> float:
    """Where a rising piece reaches `level`, to the last bit."""
    while True:
        middle = 0.5 * (left + right)
        if not left < middle < right:
            return right
        if float(curve(middle)) < level:
            left = middle
        else:
            right = middle

"""Curves over a stroke: a constant, a polynomial and a monotone table.

Each curve accepts floats, NumPy arrays and CasADi symbols. The parameters can be symbols too, because a compiled model
reads them at run time. `Characteristic` treats strokes outside the range of a curve.
"""

from __future__ import annotations

import math
from collections.abc import Hashable, Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Any, ClassVar, Self, final

import numpy as np

from poppet.core.errors import ErrorCollector, InputError, raise_errors
from poppet.core.provenance import Number
from poppet.core.symbolic import maximum, minimum
from poppet.laws.curves.curve import Curve
from poppet.laws.curves.pchip import pchip_slopes


@final
@dataclass(frozen=True)
class ConstantCurve(Curve):
    """Curve with the same value at every stroke.

    Parameters
    ----------
    value : Number
        Value of the curve in any unit.

    Examples
    --------
    >>> from poppet.core.provenance import Number, Source
    >>> ConstantCurve(Number(0.35, "", Source("assumed", note="example")))(1e-3)
    0.35
    """

    value: Number
    known: ClassVar[str] = "is given"

    def numbers(self) -> dict[str, Number]:
        return {"value": self.value}

    def parameters(self) -> dict[str, float]:
        return {"value": float(self.value)}

    def evaluate(self, x: Any, parameters: Mapping[str, Any]) -> Any:
        return parameters["value"] + 0.0 * x  # takes the shape of x

    def turning_points(self, low: float, high: float) -> tuple[float, ...]:
        return ()

    @property
    def pieces(self) -> int:
        return 1

    def structure(self) -> Hashable:
        return ("constant",)

    def with_numbers(self, changes: Mapping[str, Number]) -> Self:
        return replace(self, value=self._changed_numbers(changes)["value"])


@final
@dataclass(frozen=True)
class PolynomialCurve(Curve):
    r"""Curve that is a polynomial of the scaled stroke.

    .. math:: y(x) = \sum_{i=1}^{n} k_i\, (s x)^{n-i}

    Parameters
    ----------
    coefficients : tuple of Number
        Coefficients, highest power first. All have the unit of the result, because the argument `s x` has no unit.
    argument_scale : float
        Factor s from the stroke to the argument of the polynomial, 1000 for an argument in millimetres [1/m].
    letter : str
        First letter of the names of the coefficients: `k1`, `k2`, ...

    Examples
    --------
    The square of the stroke in millimetres, at 0.5 mm:

    >>> from poppet.core.provenance import Number, Source
    >>> numbers = tuple(Number(value, "", Source("assumed", note="example")) for value in (1.0, 0.0, 0.0))
    >>> PolynomialCurve(numbers)(0.5e-3)
    0.25
    """

    coefficients: tuple[Number, ...]
    argument_scale: float = 1e3
    letter: str = "k"
    known: ClassVar[str] = "was fitted"
    extrapolates: ClassVar[bool] = True

    def __post_init__(self) -> None:
        if not self.coefficients:
            raise InputError("curves.no_coefficients")
        if not 0.0 < self.argument_scale < math.inf:
            raise InputError("curves.argument_scale", "argument_scale", value=self.argument_scale)

    def numbers(self) -> dict[str, Number]:
        return {f"{self.letter}{i}": number for i, number in enumerate(self.coefficients, start=1)}

    def parameters(self) -> dict[str, float]:
        return {name: float(number) for name, number in self.numbers().items()}

    def evaluate(self, x: Any, parameters: Mapping[str, Any]) -> Any:
        argument = x * self.argument_scale
        value = 0.0 * argument + parameters[f"{self.letter}1"]
        for i in range(2, len(self.coefficients) + 1):
            value = value * argument + parameters[f"{self.letter}{i}"]
        return value

    def turning_points(self, low: float, high: float) -> tuple[float, ...]:
        slope = np.polyder(np.array([float(number) for number in self.coefficients]))
        reach = max(abs(low), abs(high)) * self.argument_scale
        terms = np.abs(slope) * reach ** np.arange(len(slope) - 1, -1, -1.0)
        # A leading term that is negligible in the domain would only make the companion matrix ill-conditioned.
        felt = np.flatnonzero(terms > 1e-15 * np.max(terms, initial=0.0))
        roots = np.roots(slope[felt[0] :] if felt.size else slope[:0])
        real = roots.real[np.abs(roots.imag) <= 1e-9 * np.abs(roots)] / self.argument_scale
        return tuple(sorted(float(x) for x in real if low < x < high))

    @property
    def pieces(self) -> int:
        return max(1, len(self.coefficients) - 1)

    def structure(self) -> Hashable:
        return ("polynomial", len(self.coefficients), self.argument_scale, self.letter)

    def with_numbers(self, changes: Mapping[str, Number]) -> Self:
        return replace(self, coefficients=tuple(self._changed_numbers(changes).values()))


@final
@dataclass(frozen=True)
class TableCurve(Curve):
    r"""Monotone piecewise cubic (PCHIP) through points, constant beyond the first and last point.

    On each segment, with its width :math:`h_i`, :math:`t = (x - x_i)/h_i`, the difference
    :math:`\Delta_i = y_{i+1} - y_i` and the slopes :math:`d_i` of `pchip_slopes`,

    .. math:: y = y_i + h_i d_i t + (3 \Delta_i - 2 h_i d_i - h_i d_{i+1}) t^2
              + (h_i d_i + h_i d_{i+1} - 2 \Delta_i) t^3

    Parameters
    ----------
    strokes : tuple of float
        Strictly increasing knots, at least two [m].
    values : tuple of Number
        One value for each knot, in the unit of the result.

    Notes
    -----
    The curve is continuously differentiable, has no extremum between two knots and does not overshoot the points. Its
    value is a sum over all segments, without a search, because symbols need an expression without branches.

    References
    ----------
    Fritsch & Carlson 1980, SIAM J. Numer. Anal. 17, 238-246; the slopes as in `pchip_slopes`.

    Examples
    --------
    >>> from poppet.core.provenance import Number, Source
    >>> values = tuple(Number(value, "", Source("assumed", note="example")) for value in (0.0, 1.0, 4.0))
    >>> float(TableCurve((0.0, 1e-3, 2e-3), values)(1e-3))
    1.0
    """

    strokes: tuple[float, ...]
    values: tuple[Number, ...]
    known: ClassVar[str] = "has points"

    def __post_init__(self) -> None:
        errors = ErrorCollector()
        if len(self.strokes) < 2:
            errors.add("curves.too_few_points", "stroke", count=len(self.strokes))
        if len(self.values) != len(self.strokes):
            errors.add("curves.unequal_lengths", values=len(self.values), strokes=len(self.strokes))
        for index, (left, right) in enumerate(pairwise(self.strokes), start=2):
            if not left < right < math.inf:
                errors.add("curves.not_rising", place=index, right_mm=right * 1e3, left_mm=left * 1e3)
        raise_errors(errors.collected)

    def numbers(self) -> dict[str, Number]:
        return {f"y{i}": number for i, number in enumerate(self.values)}

    def parameters(self) -> dict[str, float]:
        values = [float(number) for number in self.values]
        slopes = pchip_slopes(self.strokes, values)
        columns = {"y": values, "x": self.strokes, "d": slopes}
        return {f"{letter}{i}": value for letter, column in columns.items() for i, value in enumerate(column)}

    def evaluate(self, x: Any, parameters: Mapping[str, Any]) -> Any:
        value = 0.0 * x + parameters["y0"]
        for i in range(len(self.strokes) - 1):
            left, right = parameters[f"x{i}"], parameters[f"x{i + 1}"]
            width = right - left
            # At a knot, the derivatives of both neighbours must add up to one derivative. CasADi halves it at ties
            # (old versions assign it to the first argument). This order of arguments is correct in both cases.
            t = maximum(0.0, minimum((x - left) / width, 1.0))
            chord = parameters[f"y{i + 1}"] - parameters[f"y{i}"]
            start, end = width * parameters[f"d{i}"], width * parameters[f"d{i + 1}"]
            # Below the segment, this term is 0; above it, it is the difference between the values at both ends.
            value = value + t * (start + t * (3.0 * chord - 2.0 * start - end + t * (start + end - 2.0 * chord)))
        return value

    def turning_points(self, low: float, high: float) -> tuple[float, ...]:
        return tuple(x for x in self.strokes if low < x < high)

    @property
    def pieces(self) -> int:
        return len(self.strokes) - 1

    @property
    def support(self) -> tuple[float, float]:
        return (self.strokes[0], self.strokes[-1])

    def structure(self) -> Hashable:
        return ("table", len(self.strokes))

    def with_numbers(self, changes: Mapping[str, Number]) -> Self:
        return replace(self, values=tuple(self._changed_numbers(changes).values()))

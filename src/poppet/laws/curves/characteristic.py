"""The flow characteristic of a variable passage: C(x), b(x), a domain, an edge policy and a closing law."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal, Self, TypeVar, get_args

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, OutOfRangeError, collect
from poppet.core.provenance import Number, Source
from poppet.core.symbolic import clip, is_symbolic, minimum, smoothstep, where
from poppet.laws.curves.curve import Curve, rising_intervals
from poppet.laws.curves.shapes import ConstantCurve

T = TypeVar("T")
Edge = Literal["hold", "error"]
EDGES: tuple[Edge, ...] = get_args(Edge)
GIVEN = Source("given")
OUTSIDE_TOLERANCE = 0.01
"""Part of the domain's width by which a run may leave the domain before it is reported [1]."""
STOP_PLAY = 0.05
"""The same where an end stop stands within the domain: what it gives way is its contact, no further opening [1].

A twentieth of 1 mm takes 2.5 kN at the stops of the library, a hundred and more times what its springs exert."""
ANYWHERE = (-math.inf, math.inf)
"""End stops of a stroke that has none [m]."""

_CURVES = {"sonic_conductance": ("C", "m^3/(s Pa)"), "critical_ratio": ("b", "")}


@dataclass(frozen=True)
class Characteristic:
    r"""Sonic conductance and critical pressure ratio as functions of the stroke.

    .. math:: C(x) = \sigma(x)\, C_0(\xi),\quad b(x) = b_0(\bar x),\quad \bar x = \min(\max(x, x_a), x_b)

    with the closing law :math:`\sigma` (a smoothstep over 0..closing, or 1), and :math:`\xi = \bar x`, or for
    the monotone variant the stroke up to :math:`\bar x` at which :math:`C_0` is largest.

    Parameters
    ----------
    sonic_conductance : Curve
        C over the stroke [m^3/(s Pa)].
    critical_ratio : Curve
        b over the stroke [1].
    domain : tuple of float, shape (2,)
        Strokes between which both are known [m].
    edge : str
        `hold` keeps the edge values outside the domain, `error` refuses floats and arrays outside it.
    closing : Number, optional
        Width of the closing law: C falls to zero from this stroke to 0 and stays zero below [m].
    monotone : bool
        Replace C by its running maximum, so that opening further never lowers it.
    name : str
        Name for messages, `varga2012`.
    source : Source, optional
        Where the curves come from.

    Notes
    -----
    Outside the domain nothing is known and nothing is extrapolated. On symbols both edge policies hold the
    edge values; whoever runs the model compares the strokes reached with the domain and reports
    `outside(...)`.

    Examples
    --------
    >>> from poppet.laws.curves import ConstantCurve
    >>> from poppet.core.provenance import assumed
    >>> conductance = ConstantCurve(assumed(1e-8, "m^3/(s Pa)", "example"))
    >>> ratio = ConstantCurve(assumed(0.3, "1", "example"))
    >>> seat = Characteristic(conductance, ratio, domain=(0.0, 1e-3), closing=assumed(2e-5, "m", "example"))
    >>> [seat.sonic_conductance_at(x) for x in (-1e-5, 1e-5, 5e-5)]
    [0.0, 5e-09, 1e-08]
    """

    sonic_conductance: Curve
    critical_ratio: Curve
    domain: tuple[float, float] = (-math.inf, math.inf)
    edge: Edge = "hold"
    closing: Number | None = None
    monotone: bool = False
    name: str = "characteristic"
    source: Source = GIVEN

    def __post_init__(self) -> None:
        # Only of curves that are well formed: evaluating others over the domain would fail.
        collect([*self._form_problems()])
        collect([*self._value_problems()])

    def sonic_conductance_at(self, x: Any, parameters: Mapping[str, Any] | None = None) -> Any:
        """Sonic conductance at a stroke.

        Parameters
        ----------
        x : float, array or symbol
            Stroke [m].
        parameters : mapping of str to float or symbol, optional
            Values under the names of `parameters()`; the characteristic's own when not given.

        Returns
        -------
        float, array or symbol
            Sonic conductance [m^3/(s Pa)].

        Raises
        ------
        OutOfRangeError
            The stroke lies outside the domain and the edge policy is `error`.
        """
        given = self._own if parameters is None else parameters
        x = self._operand(x, "sonic_conductance")
        stroke = self._highest_up_to(self._held(x, given), given) if self.monotone else self._held(x, given)
        value = self.sonic_conductance.evaluate(stroke, _under("sonic_conductance", given))
        # With the stroke itself, not the held one: the domain may begin above the seat.
        return value if self.closing is None else value * smoothstep(x, 0.0, given["closing"])

    def critical_ratio_at(self, x: Any, parameters: Mapping[str, Any] | None = None) -> Any:
        """Critical pressure ratio at a stroke.

        Parameters
        ----------
        x : float, array or symbol
            Stroke [m].
        parameters : mapping of str to float or symbol, optional
            Values under the names of `parameters()`; the characteristic's own when not given.

        Returns
        -------
        float, array or symbol
            Critical pressure ratio [1].

        Raises
        ------
        OutOfRangeError
            The stroke lies outside the domain and the edge policy is `error`.
        """
        given = self._own if parameters is None else parameters
        x = self._operand(x, "critical_ratio")
        return self.critical_ratio.evaluate(self._held(x, given), _under("critical_ratio", given))

    def numbers(self) -> dict[str, Number]:
        """Every number that can be set, fitted or shown, `sonic_conductance.k1`, `critical_ratio.p1`, ..."""
        named = _joined({name: self._curve(name).numbers() for name in _CURVES})
        return named if self.closing is None else {**named, "closing": self.closing}

    def parameters(self) -> dict[str, float]:
        """What a compiled model takes as run-time values: the numbers in SI, and what is derived from them.

        The names do not depend on the values, so a changed number never changes the compiled model.
        """
        return dict(self._own)

    def structure(self) -> Hashable:
        """What of the characteristic is compiled in; those that agree in it may share one compiled model."""
        curves = self.sonic_conductance.structure(), self.critical_ratio.structure()
        return (*curves, self._bounded, self.monotone, self.closing is not None)

    def with_numbers(self, changes: Mapping[str, Number]) -> Self:
        """The same characteristic with some numbers replaced.

        Parameters
        ----------
        changes : mapping of str to Number
            New numbers under the names of `numbers()`.

        Returns
        -------
        Characteristic
            What is derived from the numbers follows them.
        """
        known = self.numbers()
        unknown = [key for key in changes if key not in known]
        collect(
            [InputError("curves.no_number", key, name=self.name, near=NameSuggestion(key, known)) for key in unknown]
        )
        curves: dict[str, Any] = {curve: self._curve(curve).with_numbers(_under(curve, changes)) for curve in _CURVES}
        return replace(self, **curves, closing=changes.get("closing", self.closing))

    def limits(self, stops: tuple[float, float] = ANYWHERE) -> tuple[float, float]:
        """Strokes from which on a run has left the domain.

        Parameters
        ----------
        stops : tuple of float, shape (2,)
            Strokes at which end stops are met [m].

        Returns
        -------
        tuple of float, shape (2,)
            The domain, give or take 1 % of its width; 5 % on a side where a stop stands within the domain, for a
            stop gives way by its contact [m]. Without a lower limit where `closing` is given and the domain begins
            at 0: the conductance of a closed passage is known to be zero.
        """
        low, high = self.domain
        slack = OUTSIDE_TOLERANCE * (high - low)
        play = [STOP_PLAY if low - slack <= stop <= high + slack else OUTSIDE_TOLERANCE for stop in stops]
        return self._lowest - play[0] * (high - low), high + play[1] * (high - low)

    def outside(self, x_min: float, x_max: float, stops: tuple[float, float] = ANYWHERE) -> Note | None:
        """The note for a report when the strokes of a run left the domain.

        Parameters
        ----------
        x_min, x_max : float
            Smallest and largest stroke reached [m].
        stops : tuple of float, shape (2,)
            Strokes at which end stops are met [m].

        Returns
        -------
        Note or None
            None while the run stayed within `limits`; else with the strokes that were reached outside, and by how
            much the farthest of them is beyond the domain.
        """
        low, high = self.limits(stops)
        # How far beyond the domain each stroke outside is.
        beyond = {x_min: self.domain[0] - x_min} if x_min < low else {}
        beyond |= {x_max: x_max - self.domain[1]} if x_max > high else {}
        if not beyond:
            return None
        ran = {"strokes_mm": tuple(1e3 * x for x in beyond), "beyond_mm": 1e3 * max(beyond.values())}
        return Note("curves.left_domain", **ran, domain=_span(*self.domain), known=self._known("sonic_conductance"))

    @cached_property
    def _own(self) -> dict[str, float]:
        own = _joined({name: self._curve(name).parameters() for name in _CURVES})
        if self._bounded:
            own |= {"domain_start": self.domain[0], "domain_end": self.domain[1]}
            # Where C rises stands among the parameters: a fit moves its turning points without compiling anew.
            own |= self._rises() if self.monotone else {}
        if self.closing is not None:
            own["closing"] = float(self.closing)
        return own

    @property
    def _bounded(self) -> bool:
        return math.isfinite(self.domain[1] - self.domain[0])

    @property
    def _lowest(self) -> float:
        """First stroke [m] at which the values are known: any, where a closing law covers what lies below."""
        return -math.inf if self.closing is not None and self.domain[0] <= 0.0 else self.domain[0]

    @property
    def _rise_count(self) -> int:
        # At most every other of the monotone pieces rises; fixed by the structure, so that numbers may change freely.
        return (self.sonic_conductance.pieces + 1) // 2

    def _curve(self, name: str) -> Curve:
        curve: Curve = getattr(self, name)
        return curve

    def _held(self, x: Any, parameters: Mapping[str, Any]) -> Any:
        return clip(x, parameters["domain_start"], parameters["domain_end"]) if self._bounded else x

    def _rises(self) -> dict[str, float]:
        """Where the running maximum of C rises: as many intervals as any values of the numbers can need."""
        low, high = self.domain
        rises = rising_intervals(self.sonic_conductance, low, high) or [(low, low)]
        never = high + (high - low)  # no held stroke reaches it
        rises += [(never, never)] * (self._rise_count - len(rises))
        named: dict[str, float] = {}
        for i, (start, end) in enumerate(rises):
            named |= {f"rise{i}_start": start, f"rise{i}_end": end}
        return named

    def _highest_up_to(self, x: Any, parameters: Mapping[str, Any]) -> Any:
        """The stroke up to `x` where C is largest: `x` on a rise, on a plateau the end of the last rise."""
        if not self._bounded:
            return x
        stroke = clip(x, parameters["rise0_start"], parameters["rise0_end"])
        for i in range(1, self._rise_count):
            start, end = parameters[f"rise{i}_start"], parameters[f"rise{i}_end"]
            stroke = where(x >= start, minimum(x, end), stroke)
        return stroke

    def _operand(self, x: Any, curve: str) -> Any:
        """`x` as something to calculate with; a number that is none, or not allowed here, is refused."""
        if is_symbolic(x):
            return x
        values = np.atleast_1d(np.asarray(x, dtype=float))
        if np.isnan(values).any():
            raise InputError("curves.not_a_number", "stroke")
        if self.edge == "error" and values.size:
            beyond = np.maximum(values - self.domain[1], self._lowest - values)
            if beyond.max() > 0.0:
                raise self._out_of_range(float(values.flat[int(beyond.argmax())]), curve)
        return np.asarray(x, dtype=float) if isinstance(x, (list, tuple)) else x

    def _out_of_range(self, x: float, name: str) -> OutOfRangeError:
        curve, (symbol, unit) = self._curve(name), _CURVES[name]
        facts: dict[str, Any] = {
            "stroke_mm": _millimetres(x),
            "domain": _span(*self.domain),
            "known": self._known(name),
        }
        if not curve.extrapolates:
            return OutOfRangeError("curves.outside", **facts)
        return OutOfRangeError("curves.outside_polynomial", **facts, symbol=symbol, value=float(curve(x)), unit=unit)

    def _known(self, name: str) -> str:
        where_from = ", ".join(part for part in (self.name, self.source.locator) if part)
        return f"{_CURVES[name][0]}(x) {self._curve(name).known} ({where_from})"

    def _form_problems(self) -> Iterable[InputError]:
        low, high = self.domain
        for key, number in self.numbers().items():
            if not math.isfinite(float(number)):
                yield InputError("curves.not_finite", key, shown=str(number))
        if not low < high:
            yield InputError("curves.empty_domain", domain=_span(*self.domain))
        elif not self._bounded and not all(isinstance(self._curve(name), ConstantCurve) for name in _CURVES):
            yield InputError("curves.no_domain", name=self.name)
        for name, (symbol, _) in _CURVES.items():
            first, last = self._curve(name).support
            if low < first or high > last:
                points = _span(first, last)
                yield OutOfRangeError("curves.beyond_points", domain=_span(*self.domain), symbol=symbol, points=points)
        if self.edge not in EDGES:
            yield InputError("curves.edge", value=self.edge, near=NameSuggestion(self.edge, EDGES))
        if self.closing is not None and not 0.0 < float(self.closing) < math.inf:
            yield OutOfRangeError("curves.closing", shown=self.closing.display())

    def _value_problems(self) -> Iterable[InputError]:
        """C < 0 or b outside 0..1 anywhere in the domain; extremes lie at its ends or at a turning point."""
        for name, (symbol, unit) in _CURVES.items():
            curve = self._curve(name)
            strokes = [*self.domain, *curve.turning_points(*self.domain)] if self._bounded else [0.0]
            values = {x: float(curve(x)) for x in strokes}
            lowest, highest = min(values, key=values.__getitem__), max(values, key=values.__getitem__)
            # Summing a table's segments leaves rounding where a point is exactly zero.
            if values[lowest] < -1e-12 * abs(values[highest]):
                worst, limits = lowest, "negative"
            elif name == "critical_ratio" and values[highest] >= 1.0:
                worst, limits = highest, "1 or more"
            else:
                continue
            facts: dict[str, Any] = {"value": values[worst], "unit": unit, "stroke_mm": 1e3 * worst, "limits": limits}
            yield OutOfRangeError("curves.impossible_value", name, **facts, symbol=symbol, name=self.name)


def _joined(parts: Mapping[str, Mapping[str, T]]) -> dict[str, T]:
    return {f"{prefix}.{key}": value for prefix, part in parts.items() for key, value in part.items()}


def _under(prefix: str, named: Mapping[str, Any]) -> dict[str, Any]:
    start = f"{prefix}."
    return {key.removeprefix(start): value for key, value in named.items() if key.startswith(start)}


def _millimetres(x: float) -> str:
    """Exact enough to show that 1.0001 mm lies outside 1.00 mm."""
    value = 1e3 * x
    if value == 0.0:
        return "0"
    return f"{value:.2f}" if math.isclose(value, round(value, 2), rel_tol=1e-12) else f"{value:.12g}"


def _span(low: float, high: float) -> str:
    return f"{_millimetres(low)} ... {_millimetres(high)} mm"

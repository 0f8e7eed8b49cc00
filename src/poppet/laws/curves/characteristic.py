"""Flow characteristic of a variable flow path: C and b as functions of the stroke."""

from __future__ import annotations

import math
from collections.abc import Hashable, Iterable, Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal, Self, TypeVar, get_args

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, OutOfRangeError, raise_errors
from poppet.core.provenance import Number, Source
from poppet.core.symbolic import clip, is_symbolic, minimum, smoothstep, where
from poppet.laws.curves.curve import Curve, rising_intervals
from poppet.laws.curves.shapes import ConstantCurve

T = TypeVar("T")
Edge = Literal["hold", "error"]
EDGES: tuple[Edge, ...] = get_args(Edge)
GIVEN = Source("given")
OUTSIDE_TOLERANCE = 0.01
"""Distance beyond the domain, relative to its width, from which a note is given [1]."""
STOP_PLAY = 0.05
"""Distance for the note at a side with an end stop within the domain; the stop deflects by this distance [1].

A deflection of 0.05 mm takes 2.5 kN at the stops of the library, more than 100 times the force of the springs."""
ANYWHERE = (-math.inf, math.inf)
"""Positions of the end stops of a stroke that is not limited [m]."""

_CURVES = {"sonic_conductance": ("C", "m^3/(s Pa)"), "critical_ratio": ("b", "")}


@dataclass(frozen=True)
class Characteristic:
    r"""Sonic conductance and critical pressure ratio as functions of the stroke.

    .. math:: C(x) = \sigma(x)\, C_0(\xi),\quad b(x) = b_0(\bar x),\quad \bar x = \min(\max(x, x_a), x_b)

    Here :math:`C_0` and :math:`b_0` are the two curves, and :math:`x_a` and :math:`x_b` the ends of the domain. The
    closing law :math:`\sigma` rises smoothly from 0 at stroke 0 to 1 at the stroke `closing`; without `closing` it is
    1. :math:`\xi` is :math:`\bar x`, or, if `monotone` is True, the stroke up to :math:`\bar x` at which :math:`C_0` is
    largest.

    Parameters
    ----------
    sonic_conductance : Curve
        Sonic conductance C as a function of the stroke [m^3/(s Pa)].
    critical_ratio : Curve
        Critical pressure ratio b as a function of the stroke [1].
    domain : tuple of float, shape (2,)
        Range of strokes in which both curves are known [m].
    edge : str
        Policy for strokes outside the domain: `hold` uses the value at the nearest end of the domain, `error` rejects
        floats and arrays.
    closing : Number, optional
        Stroke below which C falls smoothly to zero at stroke 0; C is zero for negative strokes [m].
    monotone : bool
        If True, the running maximum of C replaces C, so a larger stroke never reduces C.
    name : str
        Name in messages, for example `varga2012`.
    source : Source, optional
        Source of the curves.

    Notes
    -----
    The curves are not extrapolated beyond the domain. For symbols, both policies use the value at the nearest end,
    because the value of a symbol is not known. After a run, the method `outside` compares the strokes with the domain
    and returns a note if necessary.

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
        # Only valid curves can be evaluated over the domain.
        raise_errors([*self._form_problems()])
        problems = []
        for name, (symbol, unit) in _CURVES.items():
            curve = self._curve(name)
            # C is not negative, and b is in 0..1. Extreme values occur at the ends of the domain or at turning points.
            strokes = [*self.domain, *curve.turning_points(*self.domain)] if self._bounded else [0.0]
            values = {x: float(curve(x)) for x in strokes}
            lowest, highest = min(values, key=values.__getitem__), max(values, key=values.__getitem__)
            # The sum of the segments of a table has rounding errors at points that are exactly zero.
            if values[lowest] < -1e-12 * abs(values[highest]):
                worst, limits = lowest, "negative"
            elif name == "critical_ratio" and values[highest] >= 1.0:
                worst, limits = highest, "1 or more"
            else:
                continue
            facts: dict[str, Any] = {"value": values[worst], "unit": unit, "stroke_mm": 1e3 * worst, "limits": limits}
            problems.append(OutOfRangeError("curves.impossible_value", name, **facts, symbol=symbol, name=self.name))
        raise_errors(problems)

    def sonic_conductance_at(self, x: Any, parameters: Mapping[str, Any] | None = None) -> Any:
        """Return the sonic conductance at a stroke.

        Parameters
        ----------
        x : float, array or symbol
            Stroke [m].
        parameters : mapping of str to float or symbol, optional
            Values under the names that the method `parameters` returns (default: values of this characteristic).

        Returns
        -------
        float, array or symbol
            Sonic conductance [m^3/(s Pa)].

        Raises
        ------
        OutOfRangeError
            If the stroke is outside the domain and the attribute `edge` is `error`.
        """
        values = self._own if parameters is None else parameters
        x = self._operand(x, "sonic_conductance")
        held = stroke = self._held(x, values)
        if self.monotone and self._bounded:
            # The stroke up to `held` at which C has its maximum: `held` on a rise, the end of the last rise elsewhere.
            stroke = clip(held, values["rise0_start"], values["rise0_end"])
            for i in range(1, self._rise_count):
                start, end = values[f"rise{i}_start"], values[f"rise{i}_end"]
                stroke = where(held >= start, minimum(held, end), stroke)
        value = self.sonic_conductance.evaluate(stroke, _under("sonic_conductance", values))
        # The closing law uses the unlimited stroke, because the domain can begin above the seat.
        return value if self.closing is None else value * smoothstep(x, 0.0, values["closing"])

    def critical_ratio_at(self, x: Any, parameters: Mapping[str, Any] | None = None) -> Any:
        """Return the critical back-pressure ratio at a stroke.

        Parameters
        ----------
        x : float, array or symbol
            Stroke [m].
        parameters : mapping of str to float or symbol, optional
            Values under the names that the method `parameters` returns (default: values of this characteristic).

        Returns
        -------
        float, array or symbol
            Critical pressure ratio [1].

        Raises
        ------
        OutOfRangeError
            If the stroke is outside the domain and the attribute `edge` is `error`.
        """
        values = self._own if parameters is None else parameters
        x = self._operand(x, "critical_ratio")
        return self.critical_ratio.evaluate(self._held(x, values), _under("critical_ratio", values))

    def numbers(self) -> dict[str, Number]:
        """Return all parameters, with unit and source, by name, for example `sonic_conductance.k1`."""
        numbers = _joined({name: self._curve(name).numbers() for name in _CURVES})
        return numbers if self.closing is None else {**numbers, "closing": self.closing}

    def parameters(self) -> dict[str, float]:
        """Return all values in the equations of the characteristic, by name.

        They are the parameters as floats in SI units, and values that are computed from them, such as slopes at the
        points of a table. The names do not depend on the values, so a changed parameter requires no new compilation.
        """
        return dict(self._own)

    def structure(self) -> Hashable:
        """Return a hashable key of the equations of the characteristic.

        Characteristics with equal keys differ only in the values of their parameters, and can share compiled code.
        """
        curves = self.sonic_conductance.structure(), self.critical_ratio.structure()
        return (*curves, self._bounded, self.monotone, self.closing is not None)

    def with_numbers(self, changes: Mapping[str, Number]) -> Self:
        """Return the characteristic with some parameters replaced.

        Parameters
        ----------
        changes : mapping of str to Number
            New parameters, under the names that the method `numbers` returns.

        Returns
        -------
        Characteristic
            Copy with the new parameters.
        """
        numbers = self.numbers()
        meaning, unknown = f"a parameter of {self.name}", [key for key in changes if key not in numbers]
        raise_errors(
            [InputError("names.unknown", k, meaning=meaning, suggestion=NameSuggestion(k, numbers)) for k in unknown]
        )
        curves: dict[str, Any] = {curve: self._curve(curve).with_numbers(_under(curve, changes)) for curve in _CURVES}
        return replace(self, **curves, closing=changes.get("closing", self.closing))

    def limits(self, stops: tuple[float, float] = ANYWHERE) -> tuple[float, float]:
        """Return the lowest and the highest stroke that a run may reach without a note.

        Parameters
        ----------
        stops : tuple of float, shape (2,)
            Positions of the end stops [m].

        Returns
        -------
        tuple of float, shape (2,)
            Ends of the domain, moved outwards by 1 % of its width [m]. An end is moved by 5 % if the end stop on its
            side is within the domain, because the stop deflects. The lower limit is minus infinity if `closing` is
            given and the domain begins at stroke 0, because C is zero at lower strokes.
        """
        low, high = self.domain
        slack = OUTSIDE_TOLERANCE * (high - low)
        play = [STOP_PLAY if low - slack <= stop <= high + slack else OUTSIDE_TOLERANCE for stop in stops]
        return self._lowest - play[0] * (high - low), high + play[1] * (high - low)

    def outside(self, x_min: float, x_max: float, stops: tuple[float, float] = ANYWHERE) -> Note | None:
        """Return a note if strokes of a run were outside `limits`, the domain with a margin.

        Parameters
        ----------
        x_min, x_max : float
            Smallest and largest stroke of the run [m].
        stops : tuple of float, shape (2,)
            Positions of the end stops [m].

        Returns
        -------
        Note or None
            Note with these strokes and their largest distance from the domain. None if there are no such strokes.
        """
        low, high = self.limits(stops)
        # Distance of each outside stroke from the domain.
        distances = {x_min: self.domain[0] - x_min} if x_min < low else {}
        distances |= {x_max: x_max - self.domain[1]} if x_max > high else {}
        if not distances:
            return None
        ran = {"strokes_mm": tuple(1e3 * x for x in distances), "beyond_mm": 1e3 * max(distances.values())}
        return Note("curves.left_domain", **ran, domain=_span(*self.domain), known=self._known("sonic_conductance"))

    @cached_property
    def _own(self) -> dict[str, float]:
        own = _joined({name: self._curve(name).parameters() for name in _CURVES})
        if self._bounded:
            low, high = self.domain
            own |= {"domain_start": low, "domain_end": high}
            if self.monotone:
                # The rises of C are parameters, so a fit can move the turning points without a new compilation. Their
                # count is the maximum for any values; unused rises are outside the domain.
                rises = rising_intervals(self.sonic_conductance, low, high) or [(low, low)]
                never = high + (high - low)  # beyond every limited stroke
                rises += [(never, never)] * (self._rise_count - len(rises))
                for i, (start, end) in enumerate(rises):
                    own |= {f"rise{i}_start": start, f"rise{i}_end": end}
        if self.closing is not None:
            own["closing"] = float(self.closing)
        return own

    @property
    def _bounded(self) -> bool:
        return math.isfinite(self.domain[1] - self.domain[0])

    @property
    def _lowest(self) -> float:
        """Lowest stroke at which C and b are known [m].

        It is minus infinity if a closing law is given and the domain begins at stroke 0 or below.
        """
        return -math.inf if self.closing is not None and self.domain[0] <= 0.0 else self.domain[0]

    @property
    def _rise_count(self) -> int:
        # At most every second monotone piece rises. The structure fixes the count, so parameters can change.
        return (self.sonic_conductance.pieces + 1) // 2

    def _curve(self, name: str) -> Curve:
        curve: Curve = getattr(self, name)
        return curve

    def _held(self, x: Any, parameters: Mapping[str, Any]) -> Any:
        return clip(x, parameters["domain_start"], parameters["domain_end"]) if self._bounded else x

    def _operand(self, x: Any, name: str) -> Any:
        """Check the stroke `x`, and return it; lists and tuples become arrays.

        NaN is rejected, and with the edge policy `error` also a stroke outside the domain. A symbol is not checked.
        `name` is the name of the curve for error messages.
        """
        if is_symbolic(x):
            return x
        values = np.atleast_1d(np.asarray(x, dtype=float))
        if np.isnan(values).any():
            raise InputError("curves.not_a_number", "stroke")
        if self.edge == "error" and values.size:
            beyond = np.maximum(values - self.domain[1], self._lowest - values)
            if beyond.max() > 0.0:
                stroke = float(values.flat[int(beyond.argmax())])
                facts: dict[str, Any] = {"stroke_mm": _millimetres(stroke), "domain": _span(*self.domain)}
                facts["known"] = self._known(name)
                if not self._curve(name).extrapolates:
                    raise OutOfRangeError("curves.outside", **facts)
                (symbol, unit), value = _CURVES[name], float(self._curve(name)(stroke))
                raise OutOfRangeError("curves.outside_polynomial", **facts, symbol=symbol, value=value, unit=unit)
        return np.asarray(x, dtype=float) if isinstance(x, (list, tuple)) else x

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
            near = NameSuggestion(self.edge, EDGES)
            yield InputError("fields.not_an_option", "edge", meaning="edge policy", value=self.edge, suggestion=near)
        if self.closing is not None and not 0.0 < float(self.closing) < math.inf:
            yield OutOfRangeError("curves.closing", shown=self.closing.display())


def _joined(parts: Mapping[str, Mapping[str, T]]) -> dict[str, T]:
    return {f"{prefix}.{key}": value for prefix, part in parts.items() for key, value in part.items()}


def _under(prefix: str, values: Mapping[str, Any]) -> dict[str, Any]:
    start = f"{prefix}."
    return {key.removeprefix(start): value for key, value in values.items() if key.startswith(start)}


def _millimetres(x: float) -> str:
    """Return the stroke `x` [m] as text in millimetres.

    The text has two decimals if they are exact, and otherwise up to 12 digits: 1.0001 mm must not appear as 1.00 mm.
    """
    value = 1e3 * x
    if value == 0.0:
        return "0"
    return f"{value:.2f}" if math.isclose(value, round(value, 2), rel_tol=1e-12) else f"{value:.12g}"


def _span(low: float, high: float) -> str:
    return f"{_millimetres(low)} ... {_millimetres(high)} mm"

"""Combinations of flow paths in series and in parallel, and tubes: total C and b.

All formulas are those of the 1989 edition: subsonic index 0.5 and no cracking pressure.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from functools import reduce
from typing import Any

from poppet.core.errors import InputError
from poppet.core.symbolic import is_symbolic, maximum, minimum, sqrt, where
from poppet.laws.iso6358.domain import DOMAINS, Domain, check

_OPEN = Domain("iso6358.closed_passage", "m^3/(s Pa)", open_low=True)
_LENGTH = Domain("iso6358.length", "m")
_DIAMETER = Domain("iso6358.bore", "m", open_low=True)
_NO_PRESSURE = 1e-300


def series(
    sonic_conductance_1: float, critical_ratio_1: float, sonic_conductance_2: float, critical_ratio_2: float
) -> tuple[float, float]:
    r"""Return sonic conductance C and critical ratio b of two flow paths in series.

    Flow path 1 is upstream of flow path 2.

    .. math::

        C_{12} = C_1 \ \text{for}\ k = C_1/C_2 \le b_1, \quad\text{else}\quad
        C_{12} = C_1 \frac{b_1 k + (1 - b_1) \sqrt{k^2 + 1 - 2 b_1}}{k^2 + (1 - b_1)^2}

    .. math:: b_{12} = 1 - C_{12}^2 \left(\frac{1 - b_1}{C_1^2} + \frac{1 - b_2}{C_2^2}\right)

    Parameters
    ----------
    sonic_conductance_1, critical_ratio_1 : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of the upstream flow path.
    sonic_conductance_2, critical_ratio_2 : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of the downstream flow path.

    Returns
    -------
    sonic_conductance, critical_ratio : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of the pair.

    Notes
    -----
    The assumptions are a subsonic index of m = 0.5, no cracking pressure, no heat exchange between the flow paths
    (equal stagnation temperature), no pressure recovery and no interaction of the flows. C is exact: it gives the
    choked flow of the pair. b is exact for small pressure drops. At intermediate pressure ratios, the flow by the
    combined C and b differs from that of the pair by 1.1 % of the choked flow in the example, and by up to 1.4 % for b
    up to 0.6 (tests/unit). The formula of the standard with a = C1/(b1 C2) is equivalent; the form with k is also valid
    for b1 = 0. The result depends on the order of the flow paths. The approximation 1/C^2 = sum of 1/C_i^2
    underestimates C by 1 to 11 %.

    References
    ----------
    ISO 6358:1989, series connection; ISO 6358-3:2014, assemblies.

    Examples
    --------
    >>> C, b = series(1.65e-8, 0.43, 3.0e-8, 0.30)
    >>> round(C * 1e8, 4), round(b, 3)
    (1.6191, 0.247)
    """
    _check_passages([(sonic_conductance_1, critical_ratio_1), (sonic_conductance_2, critical_ratio_2)])
    k, b1 = sonic_conductance_1 / sonic_conductance_2, critical_ratio_1
    conductance = sonic_conductance_1
    # Below this limit, the upstream flow path alone chokes, and the other one accepts its flow.
    if k > b1:
        root = math.sqrt(k * k + 1.0 - 2.0 * b1)
        conductance *= (b1 * k + (1.0 - b1) * root) / (k * k + (1.0 - b1) ** 2)
    # For small drops, q^2 is about 2 C^2 p dp/(1 - b), so the drops, (1 - b)/C^2 for one flow, are additive.
    first = (1.0 - b1) * (conductance / sonic_conductance_1) ** 2
    second = (1.0 - critical_ratio_2) * (conductance / sonic_conductance_2) ** 2
    return conductance, 1.0 - first - second


def series_of(passages: Iterable[tuple[float, float]]) -> tuple[float, float]:
    r"""Return sonic conductance C and critical ratio b of several flow paths in series.

    They are combined from upstream to downstream.

    .. math:: (C, b)_{1 \dots n} = \operatorname{series}\left((C, b)_{1 \dots n-1}, (C, b)_n\right)

    Parameters
    ----------
    passages : iterable of (float, float)
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of each flow path, upstream first.

    Returns
    -------
    sonic_conductance, critical_ratio : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of the combination.

    Notes
    -----
    The assumptions of `series` apply. With three or more flow paths, C is approximate too, because the law of the first
    pair with the combined C and b is an approximation.

    Examples
    --------
    >>> C, b = series_of([(1.65e-8, 0.43), (3.0e-8, 0.30)])
    >>> round(C * 1e8, 4), round(b, 3)
    (1.6191, 0.247)
    """
    return reduce(lambda combined, following: series(*combined, *following), _check_passages(passages))


def parallel(
    sonic_conductance_1: float, critical_ratio_1: float, sonic_conductance_2: float, critical_ratio_2: float
) -> tuple[float, float]:
    r"""Return sonic conductance C and critical ratio b of two flow paths in parallel.

    .. math::

        C = C_1 + C_2, \qquad
        b = 1 - \left(\frac{C}{C_1/\sqrt{1 - b_1} + C_2/\sqrt{1 - b_2}}\right)^2

    Parameters
    ----------
    sonic_conductance_1, critical_ratio_1 : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of the first flow path.
    sonic_conductance_2, critical_ratio_2 : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of the second flow path.

    Returns
    -------
    sonic_conductance, critical_ratio : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of the pair.

    Notes
    -----
    The assumptions are a subsonic index of m = 0.5 and no cracking pressure. The result is exact if all flow paths are
    choked and for small pressure drops, and approximate between these limits.

    References
    ----------
    ISO 6358:1989, parallel connection; ISO 6358-3:2014, assemblies.

    Examples
    --------
    >>> C, b = parallel(1e-8, 0.2, 2e-8, 0.5)
    >>> round(C * 1e8, 4), round(b, 4)
    (3.0, 0.4221)
    """
    return parallel_of([(sonic_conductance_1, critical_ratio_1), (sonic_conductance_2, critical_ratio_2)])


def parallel_of(passages: Iterable[tuple[float, float]]) -> tuple[float, float]:
    r"""Return sonic conductance C and critical ratio b of several flow paths in parallel.

    .. math:: C = \sum C_i, \qquad b = 1 - \left(\frac{C}{\sum C_i/\sqrt{1 - b_i}}\right)^2

    Parameters
    ----------
    passages : iterable of (float, float)
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of each flow path.

    Returns
    -------
    sonic_conductance, critical_ratio : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of the combination.

    Notes
    -----
    The assumptions of `parallel` apply.

    Examples
    --------
    >>> C, b = parallel_of([(1e-8, 0.3)] * 4)
    >>> round(C * 1e8, 4), round(b, 4)
    (4.0, 0.3)
    """
    pairs = _check_passages(passages)
    # Choked flows are additive in C, flows at small drops in C/sqrt(1 - b); both sums give C and b.
    total = sum(conductance for conductance, _ in pairs)
    weighted = sum(conductance / math.sqrt(1.0 - ratio) for conductance, ratio in pairs)
    return total, 1.0 - (total / weighted) ** 2


def tube(length: float, diameter: float) -> tuple[float, float]:
    r"""Return sonic conductance C and critical ratio b of a straight smooth tube.

    .. math:: C = \frac{0.029\,d^2}{\sqrt{L/d^{1.25} + 510}}, \qquad b = 474\,\frac{C}{d^2}

    Parameters
    ----------
    length, diameter : float
        Length L and bore d [m].

    Returns
    -------
    sonic_conductance, critical_ratio : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1]; b has its maximum of 0.609 at length 0.

    Notes
    -----
    The formula is an empirical fit in SI units for turbulent flow of air through smooth plastic tubes, with a subsonic
    index of m = 0.5. The term 510 represents inlet and outlet. The source does not state the range of the fit, so the
    result is an estimate. Bends and fittings are not included; add them in series. The formula describes steady flow:
    represent the volume of the tube by a chamber, and the travel time in a long tube by a delay.

    References
    ----------
    The formula is in common use for pneumatic tubes (Eckersten; Gidlund) and is quoted in Beater, Pneumatic Drives,
    Springer 2007.

    Examples
    --------
    >>> C, b = tube(1.0, 4e-3)
    >>> round(C * 1e8, 3), round(b, 3)
    (1.196, 0.354)
    """
    check({"length": length, "diameter": diameter}, {"length": _LENGTH, "diameter": _DIAMETER})
    conductance = 0.029 * diameter**2 / sqrt(length / diameter**1.25 + 510.0)
    return conductance, 474.0 * conductance / diameter**2


def divided(conductance: float, critical_ratio: float, weights: Sequence[float]) -> list[tuple[float, float]]:
    r"""Divide a long flow path into pieces in series, and return the flow capacity of each.

    .. math:: \frac{1 - b_i}{C_i^2} = \frac{w_i}{\sum w} \, \frac{1 - b}{C^2}, \qquad
              C_i = \min(k, k_\mathrm{end}) \, C

    Parameters
    ----------
    conductance, critical_ratio : float
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of the complete flow path.
    weights : sequence of float, shape (n,)
        Weight w of each piece in the pressure loss; for a tube, the length of the piece.

    Returns
    -------
    list of (float, float)
        Sonic conductance C [m^3/(s Pa)] and critical pressure ratio b [1] of each piece, upstream first.

    Notes
    -----
    C and b without index belong to the complete flow path. The first equation makes the pressure drops of the pieces at
    small flow add up to the drop of the complete flow path. :math:`k_\mathrm{end}` has one value for the first and one
    for the last piece: with these values, the pieces choke at the choked flow of the complete flow path in both
    directions. Inner pieces use the smaller value. k is the factor at which b of a piece is 0.

    All C are then reduced by half of the relative excess flow at intermediate pressure ratios. Without heat exchange,
    the flow of the pieces differs from that of the complete flow path by less than 1.5 % for all pressure ratios, b up
    to 0.61 and up to 200 pieces (tests/unit). For comparison, n equal pieces with :math:`\sqrt{n}\,C` pass up to
    :math:`1/\sqrt{1 - b}` times the choked flow.

    Examples
    --------
    >>> [(round(C * 1e8, 3), round(b, 3)) for C, b in divided(1.2e-8, 0.35, [0.5, 1.0, 1.0, 0.5])]
    [(1.857, 0.734), (1.857, 0.469), (1.857, 0.469), (1.857, 0.734)]
    """
    _check_passages([(conductance, critical_ratio)])
    if len(weights) < 2:
        return [(conductance, critical_ratio)] * len(weights)
    # For C = 1 and pressures relative to the upstream pressure.
    drops = [(1.0 - critical_ratio) * weight / sum(weights) for weight in weights]
    ends = [2.0, 2.0]
    for _ in range(3):  # the iteration converges quickly, because the upstream piece has little effect on choking
        ends[1] = _bisect(1.0, 50.0, lambda k: _excess_capacity(_divide_into_pieces(drops, ends[0], k)))
        ends[0] = _bisect(1.0, 50.0, lambda k: _excess_capacity(_divide_into_pieces(drops, k, ends[1])[::-1]))
    pieces = _divide_into_pieces(drops, *ends)
    middle = critical_ratio + 0.27 * (1.0 - critical_ratio)  # pressure ratio of the largest excess flow
    row = _bisect(0.5, 1.5, lambda q: middle - _outlet_pressure(pieces, q))
    factor = conductance / (1.0 + 0.5 * (row / math.sqrt(1.0 - 0.27**2) - 1.0))
    return [(factor * size, ratio) for size, ratio in pieces]


def _divide_into_pieces(drops: Sequence[Any], first: Any, last: Any) -> list[tuple[Any, Any]]:
    """Divide a flow path into pieces in series.

    The result contains sonic conductance C and critical ratio b of each piece. All C are divided by the C of the
    complete flow path. `drops` contains (1 - b)/C^2 of each piece, which determines its pressure drop at small flow.
    `first` and `last` are the largest permitted C of the first and the last piece.
    """
    smaller = minimum if is_symbolic(first, last, drops[0]) else min  # the latter is much faster
    sizes = [first, *[smaller(first, last)] * (len(drops) - 2), last]
    return [(smaller(k, drop**-0.5), 1.0 - smaller(1.0, drop * k * k)) for k, drop in zip(sizes, drops, strict=True)]


def _excess_capacity(pieces: Sequence[tuple[Any, Any]]) -> Any:
    """Return the choked flow of the last piece minus the flow through all pieces.

    `pieces` contains sonic conductance and critical pressure ratio of each piece. Conductances and flows are relative
    to the complete flow path, so the flow is 1. The result is -1 if this flow is above the choked flow of another
    piece.
    """
    pressure = _outlet_pressure(pieces[:-1], 1.0)
    return pieces[-1][0] * pressure - 1.0


def _outlet_pressure(pieces: Sequence[tuple[Any, Any]], flow: Any) -> Any:
    """Return the outlet pressure of pieces in series, for an upstream pressure of 1.

    `pieces` contains sonic conductance and critical pressure ratio of each piece. The result is 0 if `flow` is above
    the choked flow of any piece.
    """
    pressure: Any = 1.0
    if not is_symbolic(flow, *pieces[0]):
        for size, ratio in pieces:
            share = flow / (size * pressure)
            if share > 1.0:
                return 0.0
            pressure *= ratio + (1.0 - ratio) * math.sqrt(1.0 - share * share)
        return pressure
    for size, ratio in pieces:
        # The limits prevent a division by zero after a choked piece, and the square root of a negative number.
        share = minimum(flow / maximum(size * pressure, _NO_PRESSURE), 2.0)
        ratio = ratio + (1.0 - ratio) * sqrt(maximum(1.0 - share * share, 0.0))
        pressure = where(share > 1.0, 0.0, pressure * ratio)
    return pressure


def _bisect(low: Any, high: Any, rising: Callable[[Any], Any]) -> Any:
    """Return the root of the increasing function `rising` between `low` and `high`, by bisection."""
    for _ in range(40):
        middle = 0.5 * (low + high)
        is_below = rising(middle) < 0.0
        if is_symbolic(is_below):
            low, high = where(is_below, middle, low), where(is_below, high, middle)
        else:
            low, high = (middle, high) if is_below else (low, middle)
    return high


def _check_passages(passages: Iterable[tuple[float, float]]) -> list[tuple[float, float]]:
    """Check conductance and critical ratio of several flow paths, and return them as a list of pairs.

    All errors are reported together, each with the index of its flow path.
    """
    pairs = list(passages)
    if not pairs:
        raise InputError("iso6358.no_passages", "passages")
    values: dict[str, float] = {}
    domains: dict[str, Domain] = {}
    for index, (conductance, ratio) in enumerate(pairs, start=1):
        values |= {f"sonic_conductance_{index}": conductance, f"critical_ratio_{index}": ratio}
        domains |= {f"sonic_conductance_{index}": _OPEN, f"critical_ratio_{index}": DOMAINS["critical_ratio"]}
    check(values, domains)
    return pairs

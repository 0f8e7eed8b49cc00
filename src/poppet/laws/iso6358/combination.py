"""Passages one after the other, side by side, and tubes: C and b of the whole.

All forms are those of the 1989 edition: subsonic index 0.5 and no cracking pressure.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Sequence
from functools import reduce

from poppet.core.errors import InputError
from poppet.laws.iso6358.domain import DOMAINS, Domain, check

_OPEN = Domain("iso6358.closed_passage", "m^3/(s Pa)", open_low=True)
_LENGTH = Domain("iso6358.length", "m")
_DIAMETER = Domain("iso6358.bore", "m", open_low=True)


def series(
    sonic_conductance_1: float, critical_ratio_1: float, sonic_conductance_2: float, critical_ratio_2: float
) -> tuple[float, float]:
    r"""Two passages one after the other, 1 upstream of 2.

    .. math::

        C_{12} = C_1 \ \text{for}\ k = C_1/C_2 \le b_1, \quad\text{else}\quad
        C_{12} = C_1 \frac{b_1 k + (1 - b_1) \sqrt{k^2 + 1 - 2 b_1}}{k^2 + (1 - b_1)^2}

    .. math:: b_{12} = 1 - C_{12}^2 \left(\frac{1 - b_1}{C_1^2} + \frac{1 - b_2}{C_2^2}\right)

    Parameters
    ----------
    sonic_conductance_1, critical_ratio_1 : float
        C [m^3/(s Pa)] and b of the upstream passage.
    sonic_conductance_2, critical_ratio_2 : float
        C [m^3/(s Pa)] and b of the downstream passage.

    Returns
    -------
    sonic_conductance, critical_ratio : float
        C [m^3/(s Pa)] and b of both together.

    Notes
    -----
    m = 0.5, no cracking pressure, no heat exchange between the two (the stagnation temperature is the same)
    and no recovery or mutual disturbance of the flows. C is exact: it is the choked flow of the pair. b makes
    small pressure drops exact; between the two ends the ellipse differs from the pair by 1.1 % of the choked
    flow for the example and by up to 1.4 % for b up to 0.6 (tests/unit). The form printed in the standard,
    with a = C1/(b1 C2), is the same one; written with k it holds for b1 = 0 as well. The order matters; the
    shortcut 1/C^2 = sum of 1/C_i^2 is 1 to 11 % low.

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
    # Up to there the upstream passage alone chokes the pair: the other takes what it delivers.
    if k > b1:
        root = math.sqrt(k * k + 1.0 - 2.0 * b1)
        conductance *= (b1 * k + (1.0 - b1) * root) / (k * k + (1.0 - b1) ** 2)
    # At small drops q^2 is about 2 C^2 p dp/(1 - b), so that the drops, (1 - b)/C^2 for one flow, add up.
    first = (1.0 - b1) * (conductance / sonic_conductance_1) ** 2
    second = (1.0 - critical_ratio_2) * (conductance / sonic_conductance_2) ** 2
    return conductance, 1.0 - first - second


def series_of(passages: Iterable[tuple[float, float]]) -> tuple[float, float]:
    r"""Any number of passages one after the other, combined pairwise from upstream to downstream.

    .. math:: ((1, 2), 3), \dots

    Parameters
    ----------
    passages : iterable of (float, float)
        C [m^3/(s Pa)] and b of each, the upstream one first.

    Returns
    -------
    sonic_conductance, critical_ratio : float
        C [m^3/(s Pa)] and b of all together.

    Notes
    -----
    As for `series`; from the third passage on C is an approximation too, because the first pair's ellipse is
    one.

    Examples
    --------
    >>> C, b = series_of([(1.65e-8, 0.43), (3.0e-8, 0.30)])
    >>> round(C * 1e8, 4), round(b, 3)
    (1.6191, 0.247)
    """
    return reduce(lambda whole, following: series(*whole, *following), _check_passages(passages))


def parallel(
    sonic_conductance_1: float, critical_ratio_1: float, sonic_conductance_2: float, critical_ratio_2: float
) -> tuple[float, float]:
    r"""Two passages side by side.

    .. math::

        C = C_1 + C_2, \qquad
        b = 1 - \left(\frac{C}{C_1/\sqrt{1 - b_1} + C_2/\sqrt{1 - b_2}}\right)^2

    Parameters
    ----------
    sonic_conductance_1, critical_ratio_1 : float
        C [m^3/(s Pa)] and b of the first passage.
    sonic_conductance_2, critical_ratio_2 : float
        C [m^3/(s Pa)] and b of the second passage.

    Returns
    -------
    sonic_conductance, critical_ratio : float
        C [m^3/(s Pa)] and b of both together.

    Notes
    -----
    m = 0.5, no cracking pressure. Exact when all are choked, exact for small pressure drops, an ellipse
    between.

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
    r"""Any number of passages side by side, under the conditions of `parallel`.

    .. math:: C = \sum C_i, \qquad b = 1 - \left(\frac{C}{\sum C_i/\sqrt{1 - b_i}}\right)^2

    Parameters
    ----------
    passages : iterable of (float, float)
        C [m^3/(s Pa)] and b of each.

    Returns
    -------
    sonic_conductance, critical_ratio : float
        C [m^3/(s Pa)] and b of all together.

    Examples
    --------
    >>> C, b = parallel_of([(1e-8, 0.3)] * 4)
    >>> round(C * 1e8, 4), round(b, 4)
    (4.0, 0.3)
    """
    pairs = _check_passages(passages)
    # Choked flows add up as C, those at small drops as C/sqrt(1 - b): two sums, and from them C and b.
    total = sum(conductance for conductance, _ in pairs)
    weighted = sum(conductance / math.sqrt(1.0 - ratio) for conductance, ratio in pairs)
    return total, 1.0 - (total / weighted) ** 2


def tube(length: float, diameter: float) -> tuple[float, float]:
    r"""C and b of a straight smooth tube.

    .. math:: C = \frac{0.029\,d^2}{\sqrt{L/d^{1.25} + 510}}, \qquad b = 474\,\frac{C}{d^2}

    Parameters
    ----------
    length, diameter : float
        Length L and bore d [m].

    Returns
    -------
    sonic_conductance, critical_ratio : float
        C [m^3/(s Pa)] and b, which is at most 0.609 (length 0).

    Notes
    -----
    An empirical fit in SI units for turbulent flow of air through smooth plastic tube, m = 0.5; the term 510 stands
    for its inlet and outlet. The range it was fitted on is not stated with it, so take it as an estimate.
    Bends and fittings are not contained: put them in series. It is a stationary law: the volume of the tube
    needs a chamber, a long line a delay.

    References
    ----------
    The estimate in common use for pneumatic tubing with ISO 6358 numbers (Eckersten; Gidlund); quoted in
    Beater, Pneumatic Drives, Springer 2007.

    Examples
    --------
    >>> C, b = tube(1.0, 4e-3)
    >>> round(C * 1e8, 3), round(b, 3)
    (1.196, 0.354)
    """
    check({"length": length, "diameter": diameter}, {"length": _LENGTH, "diameter": _DIAMETER})
    conductance = 0.029 * diameter**2 / math.sqrt(length / diameter**1.25 + 510.0)
    return conductance, 474.0 * conductance / diameter**2


def divided(conductance: float, critical_ratio: float, weights: Sequence[float]) -> list[tuple[float, float]]:
    r"""A long passage as a row of shorter ones with gas between them: C and b of each.

    .. math:: \frac{1 - b_i}{C_i^2} = \frac{w_i}{\sum w} \, \frac{1 - b}{C^2}, \qquad
              C_i = \min(k, k_\mathrm{end}) \, C

    Parameters
    ----------
    conductance, critical_ratio : float
        C [m^3/(s Pa)] and b of the whole.
    weights : sequence of float, shape (n,)
        Share of each piece in the loss, by length for a tube.

    Returns
    -------
    list of (float, float)
        C [m^3/(s Pa)] and b of each piece, the upstream one first.

    Notes
    -----
    n passages with C of the whole times the root of n are not the whole: they would pass up to :math:`1/\sqrt{1 - b}`
    times its choked flow. Here the drops of small flows add up to that of the whole, and C of the two outer pieces are
    such that the row chokes at its flow, both ways; the inner ones have the smaller of both, or b = 0. All C are then
    lowered by half of what the row exceeds the whole in between. The flow of the row, with no heat exchange, is within
    1.5 % of that of the whole for all pressure ratios, b up to 0.61 and up to 200 pieces (tests/unit).

    Examples
    --------
    >>> [(round(C * 1e8, 3), round(b, 3)) for C, b in divided(1.2e-8, 0.35, [0.5, 1.0, 1.0, 0.5])]
    [(1.857, 0.734), (1.857, 0.469), (1.857, 0.469), (1.857, 0.734)]
    """
    _check_passages([(conductance, critical_ratio)])
    if len(weights) < 2:
        return [(conductance, critical_ratio)] * len(weights)
    # For C = 1 and pressures over that upstream.
    drops = [(1.0 - critical_ratio) * weight / sum(weights) for weight in weights]
    ends = [2.0, 2.0]
    for _ in range(3):  # the upstream piece hardly matters for choking: the two settle quickly
        ends[1] = _bisected(1.0, 50.0, lambda k: _excess(_pieces(drops, ends[0], k)))
        ends[0] = _bisected(1.0, 50.0, lambda k: _excess(_pieces(drops, k, ends[1])[::-1]))
    pieces = _pieces(drops, *ends)
    middle = critical_ratio + 0.27 * (1.0 - critical_ratio)  # where the row exceeds the ellipse most
    row = _bisected(0.5, 1.5, lambda q: middle - (_outlet_pressure(pieces, q) or 0.0))
    factor = conductance / (1.0 + 0.5 * (row / math.sqrt(1.0 - 0.27**2) - 1.0))
    return [(factor * size, ratio) for size, ratio in pieces]


def _pieces(drops: Sequence[float], first: float, last: float) -> list[tuple[float, float]]:
    """C and b of pieces with given drops of small flows, of which the outer ones have given C where b allows it."""
    sizes = [first, *[min(first, last)] * (len(drops) - 2), last]
    return [(min(k, drop**-0.5), 1.0 - min(1.0, drop * k * k)) for k, drop in zip(sizes, drops, strict=True)]


def _excess(pieces: Sequence[tuple[float, float]]) -> float:
    """What the last piece could pass more than the flow 1; below zero where less, or where another one chokes."""
    pressure = _outlet_pressure(pieces[:-1], 1.0)
    return -1.0 if pressure is None else pieces[-1][0] * pressure - 1.0


def _outlet_pressure(pieces: Iterable[tuple[float, float]], flow: float) -> float | None:
    """Pressure behind pieces with an upstream pressure of 1, or None where one of them is choked."""
    pressure = 1.0
    for size, ratio in pieces:
        share = flow / (size * pressure)
        if share > 1.0:
            return None
        pressure *= ratio + (1.0 - ratio) * math.sqrt(1.0 - share * share)
    return pressure


def _bisected(low: float, high: float, rising: Callable[[float], float]) -> float:
    """Root of a rising function."""
    for _ in range(40):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if rising(middle) < 0.0 else (low, middle)
    return high


def _check_passages(passages: Iterable[tuple[float, float]]) -> list[tuple[float, float]]:
    """The passages as a list, all mistakes reported at once with the passage's place."""
    pairs = list(passages)
    if not pairs:
        raise InputError("iso6358.no_passages", "passages")
    values: dict[str, float] = {}
    domains: dict[str, Domain] = {}
    for place, (conductance, ratio) in enumerate(pairs, start=1):
        values |= {f"sonic_conductance_{place}": conductance, f"critical_ratio_{place}": ratio}
        domains |= {f"sonic_conductance_{place}": _OPEN, f"critical_ratio_{place}": DOMAINS["critical_ratio"]}
    check(values, domains)
    return pairs

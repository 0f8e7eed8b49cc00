"""Passages one after the other, side by side, and tubes: C and b of the whole.

All forms are those of the 1989 edition: subsonic index 0.5 and no cracking pressure.
"""

from __future__ import annotations

import math
from collections.abc import Iterable
from functools import reduce

from poppet.ground.errors import InputError
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

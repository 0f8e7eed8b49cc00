"""Statistics and probabilities of single faults from joint estimates of all fault numbers."""

from __future__ import annotations

import math
from itertools import combinations
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

SCATTER = 0.02
"""Standard deviation by which each fault number of a healthy plant can differ from its baseline, in alarm sizes."""
WIDE = 100.0
"""Prior standard deviation of a fault that is present, in alarm sizes."""
PRIOR = 1e-3
"""Prior probability that a fault is present."""
DECADES = 3.0
"""Range of the sizes of a fault, whose logarithm has a uniform prior distribution, in powers of ten."""
CEILING = 0.99
"""Largest probability of a fault. The rest is for causes that are not in the list of faults."""
SET = 0.95
"""Probability of the set of faults that an alarm names."""
IMPROBABLE = 3.719
"""Normal quantile of the probability 1e-4, below which the rest that a hypothesis leaves is improbable."""


class OnsetBank(NamedTuple):
    """Evidence for steps of the faults at several possible onsets, of which the filter knows nothing.

    A unit step of a fault at an onset changes the innovations of the filter by a known signature. The sums of
    signatures times innovations, and of signatures times signatures, divided by the variances of the innovations,
    contain all evidence for the size of the step. The filter estimates the nuisances, so they are marginalised.

    References
    ----------
    Willsky & Jones 1976, IEEE Trans. Autom. Control 21, 108-112.
    """

    ages: Array  # (o,) time since the onset [s]
    numerators: Array  # (o, f) sums of signature times innovation; zero for an unused onset
    gram: Array  # (o, f, f) sums of signature times signature


class FaultStatistics(NamedTuple):
    """Statistics of the hypotheses of a single fault; sizes are in alarm sizes.

    Each fault has the onset with the largest evidence.
    """

    sizes: Array  # (f,) size of each fault if it is the only one
    z: Array  # (f,) evidence for it in its direction, in standard deviations
    rests: Array  # (f,) evidence against each single fault, chi-square with f - 1 degrees of freedom
    onsets: NDArray[np.int64]  # (f,) index of the onset of each fault
    joint: float  # evidence against a healthy plant, chi-square with f degrees of freedom
    joint_onset: int  # index of the onset at which all faults together explain most
    precision: Array  # (f, f) inverse covariance of the changes at this onset
    gains: Array  # (f,) precision times the joint estimate of all changes


def fault_statistics(
    numerators: Array, gram: Array, alarms: Array, directions: Array, temper: float = 1.0
) -> FaultStatistics:
    r"""Return the statistics of single faults from the evidence at several possible onsets.

    Parameters
    ----------
    numerators : (o, f) array
        Evidence for the size of each fault; for an estimate with its covariance, the inverse covariance times the
        change.
    gram : (o, f, f) array
        Information on the sizes; for an estimate, the inverse covariance.
    alarms : (f,) array
        Alarm sizes.
    directions : (f,) array
        1, -1 or 0 for both directions.
    temper : float, optional
        Factor on all variances, from the lack of fit on healthy cycles.

    Returns
    -------
    FaultStatistics

    Notes
    -----
    With the evidence g and the information :math:`\Lambda`, fault i alone has the size :math:`g_i / \Lambda_{ii}`. It
    explains :math:`G_i = g_i^2 / \Lambda_{ii}` of the joint statistic :math:`T = g^T \Lambda^{-1} g`, the generalised
    likelihood ratio. The numbers of healthy plants scatter by s = 0.02 alarm sizes: :math:`\Lambda` is
    :math:`(\Lambda_0^{-1} + s^2 I)^{-1}`. A change far below the alarm size is therefore no evidence of a fault.
    """
    indices, identity = np.arange(alarms.size), np.eye(alarms.size)
    information = gram * (alarms[:, np.newaxis] * alarms / temper)
    evidence = numerators * (alarms / temper)
    # Without the inverse of the information, which is singular for onsets without readings.
    right = np.concatenate([information, evidence[:, :, np.newaxis]], axis=2)
    scattered = np.linalg.solve(identity + SCATTER**2 * information, right)
    gains, precisions = scattered[:, :, -1], scattered[:, :, :-1] + WIDE**-2 * identity
    diagonals = precisions[:, indices, indices]
    roots = gains / np.sqrt(diagonals)
    signed = np.where(directions == 0, np.abs(roots), directions * roots)
    onsets = np.argmax(signed, axis=0)
    z = signed[onsets, indices]
    joints = np.sum(gains * np.linalg.solve(precisions, gains[:, :, np.newaxis])[:, :, 0], axis=1)
    best = int(np.argmax(joints))
    joint = float(joints[best])
    sizes, rests = (gains / diagonals)[onsets, indices], joint - np.maximum(z, 0.0) ** 2
    return FaultStatistics(sizes, z, rests, onsets, joint, best, precisions[best], gains[best])


class PairFit(NamedTuple):
    """Hypothesis of two faults at once."""

    rest: float  # evidence against it, chi-square with f - 2 degrees of freedom
    sizes: Array  # (2,) in alarm sizes
    misfit: float = 0.0  # mean square that it leaves, relative to healthy cycles and at least 1; 0 if unknown


def fits_of_pairs(statistics: FaultStatistics, directions: Array) -> dict[tuple[int, int], PairFit]:
    """Return the fits of all pairs of faults, by their indices.

    A pair is omitted if the size of one of its faults has the wrong sign.
    """
    precision, gains = statistics.precision, statistics.gains
    fits = {}
    for pair in combinations(range(gains.size), 2):
        members = np.array(pair)
        sizes = np.linalg.solve(precision[np.ix_(members, members)], gains[members])
        if np.all(sizes * directions[members] >= 0.0):
            fits[pair] = PairFit(statistics.joint - float(gains[members] @ sizes), sizes)
    return fits


def chi_square_limit(freedom: int, quantile: float = IMPROBABLE) -> float:
    """Return a quantile of the chi-square distribution by the approximation of Wilson and Hilferty.

    `quantile` is the normal quantile of the same probability. The limit is up to 7 % too large for one degree of
    freedom, and 2 % for five.
    """
    if freedom < 1:
        return 0.0
    width = 2.0 / (9.0 * freedom)
    return float(freedom * (1.0 - width + quantile * math.sqrt(width)) ** 3)


def fault_probabilities(z: Array, joint: float, rests: Array) -> Array:
    r"""Return the probability of each single fault, (f,); the remainder is the healthy plant or an unknown cause.

    Parameters
    ----------
    z : (f,) array
        Evidence for each fault in its direction, in standard deviations.
    joint : float
        Evidence against a healthy plant, a chi-square.
    rests : (f,) array
        Evidence against each single fault, a chi-square.

    Returns
    -------
    (f,) array

    Notes
    -----
    The posterior weight of fault i is

    .. math:: w_i = \frac{\pi}{f} \, \frac{\sqrt{2 \pi}}{z_i \ln 1000} \, e^{-r_i / 2}

    with the rest :math:`r_i`. The fraction is the ratio of the uncertainty of its size to the range of possible sizes,
    whose logarithm is uniformly distributed over three decades; it is at most 1. The weight of a healthy plant is
    :math:`(1 - \pi) e^{-T / 2}`. An unknown cause has the weight of a fault whose rest has a probability of 0.1 %.
    """
    f = z.size
    is_possible = z >= 0.0
    spread = math.sqrt(2.0 * math.pi) / (DECADES * math.log(10.0))
    occam = np.log(np.minimum(1.0, spread / np.maximum(z, spread)))
    logarithms = np.where(is_possible, math.log(PRIOR / f) + occam - 0.5 * rests, -np.inf)
    healthy = math.log1p(-PRIOR) - 0.5 * joint
    unknown = math.log(PRIOR / f) + float(np.min(occam)) - 0.5 * chi_square_limit(f - 1, 3.09) if f > 1 else -np.inf
    largest = max(float(np.max(logarithms)), healthy, unknown)
    weights = np.exp(logarithms - largest)
    total = float(np.sum(weights)) + math.exp(healthy - largest) + math.exp(unknown - largest)
    return np.asarray(CEILING * weights / total)


def probable_set(probabilities: Array) -> list[int]:
    """Return the indices of the smallest set of faults with a probability of 95 % that one of them is the fault.

    The set assumes that one of the faults is present. The most probable fault is first.
    """
    order = np.argsort(-probabilities, kind="stable")
    total = float(np.sum(probabilities))
    if not total > 0.0:
        return []
    count = int(np.searchsorted(np.cumsum(probabilities[order]), SET * total * (1.0 - 1e-12))) + 1
    return [int(k) for k in order[:count]]

"""The stiffness of bristles from what happens behind reversals.

Behind a reversal the bristles of the LuGre model bend over a way of the order of g/sigma_0, whatever the time that it
takes. Where g hardly changes on that way their law has the solution

    sigma_0 z(d) = g - (g + g_0) exp(-sigma_0 int dd/g)

so that no equation has to be integrated. The levels g are those of the steady rows; what is sought is sigma_0, and
where the way begins, for a turning point is the extreme of a position with noise.
"""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.identify.friction.coordinate import COULOMB, SEAL, STATIC, STRIBECK, VISCOUS
from poppet.identify.friction.fit import Solution
from poppet.identify.friction.motion import BENT, WAYS, Motion, Reversal
from poppet.identify.gum import coverage_factor
from poppet.laws.physics.friction import sliding_level
from poppet.series.checks import FloatArray

FEWEST, STEPS = 3, 48
"""Reversals, and stiffnesses that are tried."""
SHIFTS = np.linspace(-2.0, 2.0, 9)
"""Begins of the way that are tried, in resolutions of the position."""
FINE, SHARP = 3.0, 4.0
"""Resolutions that the bristles have to bend over for their stiffness to be seen, and roundings of the corner."""


@dataclass(frozen=True)
class Bristles:
    """What the reversals say of the stiffness."""

    stiffness: float  # [N/m]
    low: float
    high: float
    error: float
    way: float  # over which they bend, g/sigma_0 [m]
    resolution: float  # of the position, one sigma [m]
    rms: float  # missed behind reversals with bristles [N]
    rms_without: float  # and with a force that changes sides at once
    reversals: int

    @property
    def is_seen(self) -> bool:
        """True where the position resolves the bending."""
        return self.way > FINE * self.resolution and math.isfinite(self.high)


def bristles_of(motions: Sequence[Motion], levels: Solution, distance: float) -> Bristles | None:
    """The stiffness at which friction behind reversals follows the LuGre model; None where there are too few.

    `distance` is that behind which everything slides; so much is compared.
    """
    turns = usable(motions, levels, distance)
    if len(turns) < FEWEST or distance <= 0.0:
        return None
    level = float(np.mean([each.level[-1] for each in turns]))
    resolution = max(motion.resolution for motion in motions)
    ways = np.geomspace(distance, max(resolution / FINE, 1e-3 * distance), STEPS)
    shifts = resolution * SHIFTS
    # (n_ways, n_shifts, n_turns)
    costs = np.stack([np.stack([each.costs(level / ways, x) for x in shifts], axis=1) for each in turns], axis=2)
    samples = np.array([each.wanted.size for each in turns])
    logarithms = np.log(level / ways)
    group = [each.record for each in turns]
    group = group if len(set(group)) >= FEWEST else [*range(len(turns))]
    known = sorted(set(group))

    def lowest(which: Any) -> float:
        return _lowest(logarithms, costs[:, :, which].sum(axis=2).min(axis=1))

    best = lowest(slice(None))
    left = np.array([lowest(np.array(group) != k) for k in known])
    count = len(known)
    # Over the logarithm: a stiffness is known to a factor.
    error = math.sqrt((count - 1) / count * float(np.sum((left - left.mean()) ** 2)))
    # The corner of a reversal is rounded off, which no scatter shows: half of that way is taken as unknown.
    rounded = 0.5 * float(np.mean([each.rounding for each in turns])) / (level / math.exp(best))
    half = math.hypot(coverage_factor(count - 1.0) * error, rounded)
    # What the begin of the way changes is not known: the interval holds the answer without a shift too.
    unshifted = _lowest(logarithms, costs[:, SHIFTS.size // 2].sum(axis=1))
    is_end = best >= logarithms[-1] - 1e-9
    without = np.array([each.at_once() for each in turns])
    stiffness = math.exp(best)
    return Bristles(
        stiffness=stiffness,
        low=math.exp(min(best, unshifted) - half),
        high=math.inf if is_end else math.exp(min(max(best, unshifted) + half, 700.0)),
        error=stiffness * error,
        way=level / stiffness,
        resolution=resolution,
        rms=math.sqrt(float(costs.sum(axis=2).min() / samples.sum())),
        rms_without=math.sqrt(float(without.sum() / samples.sum())),
        reversals=len(turns),
    )


def usable(motions: Sequence[Motion], levels: Solution, distance: float) -> list[Turn]:
    """Reversals between strokes long enough, whose corner the samples show."""
    decay = distance / (WAYS * -math.log(0.5 * (1.0 - BENT)))
    turns = [
        Turn.of(each, levels, distance)
        for motion in motions
        for each in motion.reversals
        if each.before > 2.0 * distance and SHARP * each.rounding < decay
    ]
    return [each for each in turns if each.wanted.size >= FEWEST]


@dataclass(frozen=True, eq=False)
class Turn:
    """A reversal as the model needs it, arrays of shape (n,)."""

    way: FloatArray  # [m]
    level: FloatArray  # g at its speed [N]
    wanted: FloatArray  # what the bristles hold, along the motion [N]
    record: int
    rounding: float  # of its corner [m]

    @classmethod
    def of(cls, turn: Reversal, levels: Solution, distance: float) -> Turn:
        """From the samples of a reversal up to a distance, and the levels of sliding."""
        own = turn.distance <= distance
        value = levels.values
        more = value.get(SEAL, 0.0) * turn.pressure[own]
        dry = value[COULOMB], value.get(STATIC, value[COULOMB])
        level = np.maximum(sliding_level(turn.velocity[own], *dry, value.get(STRIBECK, 1.0)) + more, 1e-9)
        rest = levels.offsets.get(turn.record, 0.0) + value.get(VISCOUS, 0.0) * turn.velocity[own]
        return cls(turn.distance[own], level, turn.sign * (turn.friction[own] - rest), turn.record, turn.rounding)

    def costs(self, stiffness: FloatArray, shift: float) -> FloatArray:
        """Sum of squares of what the bristles miss, the way begun at a shift, for each stiffness."""
        way = np.maximum(self.way - shift, 0.0)
        bent = np.outer(stiffness, np.cumsum(np.diff(way, prepend=0.0) / self.level))
        held = self.level - (self.level + self.level[0]) * np.exp(-bent)
        return np.asarray(np.sum((held - self.wanted) ** 2, axis=1))

    def at_once(self) -> float:
        """The same of a force that changes sides where the way begins."""
        held = np.where(self.way > 0.0, self.level, -self.level)
        return float(np.sum((held - self.wanted) ** 2))


def _lowest(places: FloatArray, costs: FloatArray) -> float:
    """Where a cost is least: the vertex of the parabola through the lowest place and its neighbours."""
    k = int(np.argmin(costs))
    if k in (0, costs.size - 1):
        return float(places[k])
    a, b, c = costs[k - 1 : k + 2]
    bend = a - 2.0 * b + c
    step = float(places[k + 1] - places[k])
    return float(places[k]) + (0.5 * step * float(a - c) / float(bend) if bend > 0.0 else 0.0)

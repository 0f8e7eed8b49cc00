"""Stiffness and damping of bristles from what happens behind reversals.

Behind a reversal the bristles of the LuGre model bend over a way of the order of g/sigma_0, whatever the time that it
takes. Where g hardly changes on that way their law has the solution

    sigma_0 z(d) = g - (g + g_0) exp(-sigma_0 int dd/g)

so that no equation has to be integrated; small strokes behind a large one begin where the one before ended. The damping
adds sigma_1 times the rate of z. The levels g are those of the steady rows; what is sought is sigma_0, sigma_1, and
where the way begins, for a turning point is the extreme of a position with noise.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.identify.friction.coordinate import COULOMB, SEAL, STATIC, STRIBECK, VISCOUS
from poppet.identify.friction.friction_fit import Solution
from poppet.identify.friction.motion import BENT, WAYS, RecordedMotion, Reversal
from poppet.identify.gum import coverage_factor
from poppet.identify.result import WEAK
from poppet.laws.physics.friction import sliding_level
from poppet.timeseries.checks import FloatArray

FEWEST, STEPS = 3, 48
"""Reversals, and stiffnesses that are tried."""
SHIFTS = np.linspace(-2.0, 2.0, 9)
"""Begins of the way that are tried, in resolutions of the position."""
FINE, SHARP = 3.0, 4.0
"""Resolutions that the bristles have to bend over for their stiffness to be seen, and roundings of the corner."""
SMEARED = 0.5
"""Window of the velocities over the time in which bristles bend, above which their damping is smoothed away."""


@dataclass(frozen=True)
class Bristles:
    """What the reversals say of stiffness and damping."""

    stiffness: float  # [N/m]
    low: float
    high: float
    error: float
    way: float  # over which they bend, g/sigma_0 [m]
    resolution: float  # of the position, one sigma [m]
    rms: float  # missed behind reversals with bristles [N]
    rms_without: float  # and with a force that changes sides at once
    reversals: int
    damping: float  # [N s/m]
    damping_low: float
    damping_high: float
    damping_error: float
    late: float  # damping that a sample between force and position looks like [N s/m]
    window: float  # of the velocities behind reversals [s]
    bending: float  # how long the bristles take to bend over [s]

    @property
    def is_seen(self) -> bool:
        """True where the position resolves the bending."""
        return self.way > FINE * self.resolution and math.isfinite(self.high)

    @property
    def is_coarse(self) -> bool:
        """True where samples or velocities are too far apart for the damping, whatever comes out."""
        return self.window > SMEARED * self.bending or self.late > WEAK * abs(self.damping_high)

    @property
    def is_late(self) -> bool:
        """True where the force follows the bending, which no damping does."""
        return self.damping_high < 0.0

    @property
    def is_damped(self) -> bool:
        """True where the damping is known to be above zero."""
        return self.is_seen and not self.is_coarse and self.damping_low > 0.0


def bristles_of(motions: Sequence[RecordedMotion], levels: Solution, distance: float) -> Bristles | None:
    """Stiffness and damping at which friction behind reversals follows the LuGre model; None with too few of them.

    `distance` is that behind which everything slides; so much is compared.
    """
    turns = usable(motions, levels, distance)
    if len(turns) < FEWEST or distance <= 0.0:
        return None
    level = float(np.mean([each.level[-1] for each in turns]))
    resolution = max(motion.resolution for motion in motions)
    ways = np.geomspace(distance, max(resolution / FINE, 1e-3 * distance), STEPS)
    sums = _sums(turns, level / ways, resolution * SHIFTS)
    group = [each.record for each in turns]
    group = group if len(set(group)) >= FEWEST else [*range(len(turns))]
    known, logarithms = sorted(set(group)), np.log(level / ways)
    best, unshifted = _answer(logarithms, sums), _answer(logarithms, sums[:, SHIFTS.size // 2 : SHIFTS.size // 2 + 1])
    left = np.array([_answer(logarithms, sums[:, :, np.array(group) != k])[:2] for k in known])
    scatter = np.sqrt((len(known) - 1) / len(known) * np.sum((left - left.mean(axis=0)) ** 2, axis=0))
    cover = coverage_factor(len(known) - 1.0)
    stiffness = math.exp(best[0])
    # The corner of a reversal is rounded off, which no scatter shows: half of that way is taken as unknown.
    rounded = 0.5 * float(np.mean([each.rounding for each in turns])) / (level / stiffness)
    # Over the logarithm: a stiffness is known to a factor. What the begin of the way changes is not known: the
    # interval holds the answer without a shift too.
    half = math.hypot(cover * scatter[0], rounded)
    late = stiffness * max(each.step for each in turns)
    bending = level / stiffness / max(float(np.median([each.speed for each in turns])), 1e-300)
    window = float(np.median([each.window for each in turns]))
    # A velocity is smoothed over its window, in which the bristles bend on.
    damped = math.hypot(cover * scatter[1], late, window / bending * best[1])
    is_end = best[0] >= logarithms[-1] - 1e-9
    samples = sum(each.wanted.size for each in turns)
    return Bristles(
        stiffness=stiffness,
        low=math.exp(min(best[0], unshifted[0]) - half),
        high=math.inf if is_end else math.exp(min(max(best[0], unshifted[0]) + half, 700.0)),
        error=stiffness * float(scatter[0]),
        way=level / stiffness,
        resolution=resolution,
        rms=math.sqrt(max(best[2], 0.0) / samples),
        rms_without=math.sqrt(sum(each.at_once() for each in turns) / samples),
        reversals=len(turns),
        damping=best[1],
        damping_low=min(best[1], unshifted[1]) - damped,
        damping_high=max(best[1], unshifted[1]) + damped,
        damping_error=float(scatter[1]),
        late=late,
        window=window,
        bending=bending,
    )


def usable(motions: Sequence[RecordedMotion], levels: Solution, distance: float) -> list[Turn]:
    """Reversals whose corner the samples show, behind strokes on which all bristles bent over, or in a row from one."""
    decay = distance / (WAYS * -math.log(0.5 * (1.0 - BENT)))
    turns: list[Turn] = []
    for motion in motions:
        last = -2
        for each in motion.reversals:
            is_long = each.before > 2.0 * distance
            if (is_long or each.stroke == last + 1) and SHARP * each.rounding < decay:
                turn = Turn.of(each, levels, distance, is_chained=not is_long)
                if turn.wanted.size >= FEWEST:
                    turns.append(turn)
                    last = each.stroke
    return turns


@dataclass(frozen=True, eq=False)
class Turn:
    """A reversal as the model needs it, arrays of shape (n,)."""

    way: FloatArray  # [m]
    level: FloatArray  # g at its speed [N]
    wanted: FloatArray  # what the bristles hold, along the motion [N]
    rate: FloatArray  # speed along the motion as far as the damping has not faded with it [m/s]
    lead: FloatArray  # ways from sample to sample before the reversal, for bristles that follow the speed [m]
    lead_level: FloatArray  # [N]
    record: int
    rounding: float  # of its corner [m]
    step: float  # from sample to sample [s]
    speed: float  # the usual one [m/s]
    window: float  # of the velocity [s]
    is_chained: bool  # the bristles begin as the reversal before left them

    @classmethod
    def of(cls, turn: Reversal, levels: Solution, distance: float, *, is_chained: bool) -> Turn:
        """From the samples of a reversal up to a distance, and the levels of sliding."""
        own, value, last = turn.distance <= distance, levels.values, turn.last
        assert last is not None
        # Behind a small stroke the bristles go on from where its own samples ended, else from sliding.
        lead = last.distance > (distance if is_chained else turn.before - distance)
        speed = turn.velocity[own]
        rest = levels.offsets.get(turn.record, 0.0) + value.get(VISCOUS, 0.0) * speed
        fading = np.exp(-((speed / value[STRIBECK]) ** 2)) if STRIBECK in value else np.ones(speed.size)
        return cls(
            turn.distance[own],
            _levels(turn, own, value),
            turn.sign * (turn.friction[own] - rest),
            fading * np.maximum(turn.sign * speed, 0.0),
            np.maximum(np.diff(last.distance[lead], prepend=distance if is_chained else 0.0), 0.0),
            _levels(last, lead, value),
            turn.record,
            turn.rounding,
            turn.step,
            float(np.median(np.abs(speed))),
            turn.window,
            is_chained,
        )

    def squares(self, stiffness: FloatArray, shifts: FloatArray, held: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Sums of squares and products of what the bristles miss and of their rate, (3, n_shifts, n_stiffnesses).

        They `held` so much when the samples before ended; what they hold at the end comes behind.
        """
        if not self.is_chained:
            held = np.full(held.shape, (self.lead_level if self.lead_level.size else self.level)[0])
        for way, level in zip(self.lead.tolist(), self.lead_level.tolist(), strict=True):
            held = level + (held - level) * np.exp(-stiffness / level * way)
        held = -held
        ways = np.diff(np.maximum(self.way[:, None] - shifts, 0.0), axis=0, prepend=0.0)
        sums = np.zeros((3, *held.shape))
        for k, level in enumerate(self.level.tolist()):
            held = level + (held - level) * np.exp(-stiffness / level * ways[k][:, None])
            missed, rate = self.wanted[k] - held, self.rate[k] * (1.0 - held / level)
            sums += missed * missed, missed * rate, rate * rate
        return sums, held

    def at_once(self) -> float:
        """Sum of squares missed by a force that changes sides where the way begins."""
        held = np.where(self.way > 0.0, self.level, -self.level)
        return float(np.sum((held - self.wanted) ** 2))


def _levels(turn: Reversal, which: Any, value: Mapping[str, float]) -> FloatArray:
    """Dry friction at the speeds of some samples [N]."""
    dry = value[COULOMB], value.get(STATIC, value[COULOMB]), value.get(STRIBECK, 1.0)
    more = value.get(SEAL, 0.0) * turn.pressure[which]
    return np.asarray(np.maximum(sliding_level(turn.velocity[which], *dry) + more, 1e-9))


def _sums(turns: Sequence[Turn], stiffness: FloatArray, shifts: FloatArray) -> FloatArray:
    """`Turn.squares` of all, shape (3, n_shifts, n_turns, n_stiffnesses)."""
    found, held = [], np.zeros((shifts.size, stiffness.size))
    for turn in turns:
        sums, held = turn.squares(stiffness, shifts, held)
        found.append(sums)
    return np.stack(found, axis=2)


def _answer(places: FloatArray, sums: FloatArray) -> tuple[float, float, float]:
    """Logarithm of the stiffness, damping and cost where the cost is least, over shifts too."""
    square, product, rates = sums.sum(axis=2)
    damping = product / np.maximum(rates, 1e-300)  # below zero where the force comes late
    costs = square - damping * (2.0 * product - damping * rates)
    shift, best = np.argmin(costs, axis=0), costs.min(axis=0)
    place = _lowest(places, best)
    return place, float(np.interp(place, places, damping[shift, np.arange(places.size)])), float(best.min())


def _lowest(places: FloatArray, costs: FloatArray) -> float:
    """Where a cost is least: the vertex of the parabola through the lowest place and its neighbours."""
    k = int(np.argmin(costs))
    if k in (0, costs.size - 1):
        return float(places[k])
    a, b, c = costs[k - 1 : k + 2]
    bend = a - 2.0 * b + c
    step = float(places[k + 1] - places[k])
    return float(places[k]) + (0.5 * step * float(a - c) / float(bend) if bend > 0.0 else 0.0)

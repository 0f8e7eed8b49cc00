"""Stiffness and damping of bristles from the friction after reversals.

After a reversal, the bristles of the LuGre model deflect within a distance of about g/sigma_0, independent of time. If
g is almost constant over this distance, the solution is

    sigma_0 z(d) = g - (g + g_0) exp(-sigma_0 int dd/g)

and needs no integration. Small strokes after a large stroke start at the deflection at which the previous stroke
ended. The damping adds sigma_1 times the rate of z. The levels g are those of the steady rows. The unknowns are
sigma_0, sigma_1 and the start of the distance, because the turning point is the extreme of a noisy position.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.identify.friction.motion import BENT, WAYS, RecordedMotion, Reversal
from poppet.identify.friction.records import COULOMB, SEAL, SEAL_EXCESS, STATIC, STRIBECK, VISCOUS
from poppet.identify.gum import coverage_factor
from poppet.identify.result import WEAK
from poppet.laws.physics.friction import sliding_level
from poppet.timeseries.checks import FloatArray

FEWEST, STEPS = 3, 48
"""Minimum number of reversals, and number of stiffnesses on the grid."""
SHIFTS = np.linspace(-2.0, 2.0, 9)
"""Shifts of the start of the distance, in resolutions of the position."""
FINE, SHARP = 3.0, 4.0
"""Minimum bending distance, in resolutions of the position and in roundings of the corner."""
SMEARED = 0.5
"""Ratio of velocity window to bending time above which the damping is not identifiable."""


@dataclass(frozen=True)
class Bristles:
    """Estimated stiffness and damping of the bristles, the elastic contact in the LuGre friction model."""

    stiffness: float  # [N/m]
    low: float
    high: float
    error: float
    way: float  # bending distance g/sigma_0 [m]
    resolution: float  # standard deviation of the position [m]
    rms: float  # rms error after reversals with bristles [N]
    rms_without: float  # rms error with a sudden change of the force [N]
    reversals: int
    damping: float  # [N s/m]
    damping_low: float
    damping_high: float
    damping_error: float
    late: float  # apparent damping that a delay of one sample would cause [N s/m]
    window: float  # window of the velocities after reversals [s]
    bending: float  # bending time [s]

    @property
    def is_resolved(self) -> bool:
        """True if the deflection of the bristles is larger than the position resolution."""
        return self.way > FINE * self.resolution and math.isfinite(self.high)

    @property
    def is_coarse(self) -> bool:
        """True if the sample time or the velocity window is too large for an estimate of the damping."""
        return self.window > SMEARED * self.bending or self.late > WEAK * abs(self.damping_high)

    @property
    def is_late(self) -> bool:
        """True if the force signal is delayed: the estimated damping is then negative."""
        return self.damping_high < 0.0

    @property
    def is_damped(self) -> bool:
        """True if the damping of the bristles is significantly above zero."""
        return self.is_resolved and not self.is_coarse and self.damping_low > 0.0


def fit_bristles(
    motions: Sequence[RecordedMotion], values: Mapping[str, float], offsets: Mapping[int, float], distance: float
) -> Bristles | None:
    """Fit stiffness and damping of the bristles in the LuGre friction model to the friction after reversals.

    `motions` contains the recordings. The fit uses the samples up to `distance` after a reversal; beyond it the body
    slides. `values` contains the parameters of steady sliding by name. `offsets` contains the force offset of each
    recording. The result is None if there are too few reversals.
    """
    turns = usable_reversals(motions, values, offsets, distance)
    if len(turns) < FEWEST or distance <= 0.0:
        return None
    level = float(np.mean([turn.level[-1] for turn in turns]))
    resolution = max(motion.resolution for motion in motions)
    distances = np.geomspace(distance, max(resolution / FINE, 1e-3 * distance), STEPS)
    sums_of_turns, force = [], np.zeros((SHIFTS.size, STEPS))
    for turn in turns:
        sums_of_turn, force = turn.squares(level / distances, resolution * SHIFTS, force)
        sums_of_turns.append(sums_of_turn)
    sums = np.stack(sums_of_turns, axis=2)  # (3, n_shifts, n_turns, n_stiffnesses)
    group_of_turn = np.array([turn.reversal.record for turn in turns])
    group_of_turn = group_of_turn if np.unique(group_of_turn).size >= FEWEST else np.arange(len(turns))
    groups, logarithms = np.unique(group_of_turn), np.log(level / distances)
    best = _find_minimum(logarithms, sums)
    unshifted = _find_minimum(logarithms, sums[:, SHIFTS == 0.0])
    jackknife = np.array([_find_minimum(logarithms, sums[:, :, group_of_turn != k])[:2] for k in groups])
    scatter = np.sqrt((len(groups) - 1) / len(groups) * np.sum((jackknife - jackknife.mean(axis=0)) ** 2, axis=0))
    cover = coverage_factor(len(groups) - 1.0)
    stiffness = math.exp(best[0])
    # The scatter does not show the rounding of the corner: half of it is an uncertainty.
    rounded = 0.5 * float(np.mean([turn.reversal.rounding for turn in turns])) / (level / stiffness)
    # The interval is logarithmic and includes the estimate without a shift, because the start is uncertain.
    half = math.hypot(cover * scatter[0], rounded)
    apparent_damping = stiffness * max(turn.reversal.step for turn in turns)
    bending = level / stiffness / max(float(np.median([turn.speed for turn in turns])), 1e-300)
    window = float(np.median([turn.reversal.window for turn in turns]))
    # The window smooths the velocity while the bristles deflect.
    half_damping = math.hypot(cover * scatter[1], apparent_damping, window / bending * best[1])
    is_end = best[0] >= logarithms[-1] - 1e-9
    # Without bristles, the friction changes its sign suddenly.
    squares = [(np.where(turn.distance > 0.0, turn.level, -turn.level) - turn.measured) ** 2 for turn in turns]
    samples = sum(turn.measured.size for turn in turns)
    return Bristles(
        stiffness=stiffness,
        low=math.exp(min(best[0], unshifted[0]) - half),
        high=math.inf if is_end else math.exp(min(max(best[0], unshifted[0]) + half, 700.0)),
        error=stiffness * float(scatter[0]),
        way=level / stiffness,
        resolution=resolution,
        rms=math.sqrt(max(best[2], 0.0) / samples),
        rms_without=math.sqrt(float(np.sum(np.concatenate(squares))) / samples),
        reversals=len(turns),
        damping=best[1],
        damping_low=min(best[1], unshifted[1]) - half_damping,
        damping_high=max(best[1], unshifted[1]) + half_damping,
        damping_error=float(scatter[1]),
        late=apparent_damping,
        window=window,
        bending=bending,
    )


def usable_reversals(
    motions: Sequence[RecordedMotion], values: Mapping[str, float], offsets: Mapping[int, float], distance: float
) -> list[ReversalData]:
    """Return the reversals at which the bristle deflection of the LuGre model is known.

    The deflection at a reversal is known after a stroke longer than twice `distance`, and after a shorter stroke that
    follows a usable reversal. The samples after the reversal must also resolve the change of the deflection. The other
    arguments are those of `fit_bristles`.
    """
    decay = distance / (WAYS * -math.log(0.5 * (1.0 - BENT)))
    turns: list[ReversalData] = []
    for motion in motions:
        last = -2
        for reversal in motion.reversals:
            is_long = reversal.previous_length > 2.0 * distance
            if (is_long or reversal.stroke == last + 1) and SHARP * reversal.rounding < decay:
                model = ReversalData.of(reversal, values, offsets, distance, is_chained=not is_long)
                if model.measured.size >= FEWEST:
                    turns.append(model)
                    last = reversal.stroke
    return turns


@dataclass(frozen=True, eq=False)
class ReversalData:
    """Samples after one reversal of the motion, for the fit of bristles in the LuGre friction model.

    The arrays have the shape (n,).
    """

    reversal: Reversal
    distance: FloatArray  # [m]
    level: FloatArray  # g at the speed of each sample [N]
    measured: FloatArray  # measured bristle force along the motion [N]
    rate: FloatArray  # speed along the motion, times the decay of the damping with speed [m/s]
    lead_steps: FloatArray  # distances between samples before the reversal [m]
    lead_level: FloatArray  # g before the reversal [N]
    speed: float  # median speed [m/s]
    is_chained: bool  # True if the bristles start at the deflection of the previous reversal

    @classmethod
    def of(
        cls,
        turn: Reversal,
        values: Mapping[str, float],
        offsets: Mapping[int, float],
        distance: float,
        *,
        is_chained: bool,
    ) -> ReversalData:
        """Return the samples up to `distance` after a reversal.

        `turn` is the stroke that begins with the reversal. `values` contains the parameters of sliding friction, and
        `offsets` the force offset of each recording. The keyword `is_chained` is True if the bristles start at the
        deflection at which the previous stroke ended.
        """
        is_within, last = turn.distance <= distance, turn.last
        assert last is not None
        # After a small stroke, the bristles start at its final deflection, otherwise at sliding.
        is_lead = last.distance > (distance if is_chained else turn.previous_length - distance)
        velocity = turn.velocity[is_within]
        offset_and_viscous = offsets.get(turn.record, 0.0) + values.get(VISCOUS, 0.0) * velocity
        fading = np.exp(-((velocity / values[STRIBECK]) ** 2)) if STRIBECK in values else 1.0
        return cls(
            turn,
            turn.distance[is_within],
            _dry_friction(turn, is_within, values),
            turn.sign * (turn.friction[is_within] - offset_and_viscous),
            fading * np.maximum(turn.sign * velocity, 0.0),
            np.maximum(np.diff(last.distance[is_lead], prepend=distance if is_chained else 0.0), 0.0),
            _dry_friction(last, is_lead, values),
            float(np.median(np.abs(velocity))),
            is_chained,
        )

    def squares(self, stiffness: FloatArray, shifts: FloatArray, force: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Return sums for the least-squares fit of the damping, (3, n_shifts, n_stiffnesses).

        The three rows are the sums of the squared error, of error times rate, and of the squared rate of deflection.
        The error is measured minus modelled bristle force. `shifts` contains shifts of the start of the stroke [m].
        `force` is the bristle force at the end of the previous stroke. The second item is the force at the end of this
        stroke.
        """
        if not self.is_chained:
            force = np.full(force.shape, (self.lead_level if self.lead_level.size else self.level)[0])
        for step, level in zip(self.lead_steps.tolist(), self.lead_level.tolist(), strict=True):
            force = level + (force - level) * np.exp(-stiffness / level * step)
        force = -force
        steps = np.diff(np.maximum(self.distance[:, None] - shifts, 0.0), axis=0, prepend=0.0)
        sums = np.zeros((3, *force.shape))
        for k, level in enumerate(self.level.tolist()):
            force = level + (force - level) * np.exp(-stiffness / level * steps[k][:, None])
            missed, rate = self.measured[k] - force, self.rate[k] * (1.0 - force / level)
            sums += missed * missed, missed * rate, rate * rate
        return sums, force


def _dry_friction(turn: Reversal, selected: Any, values: Mapping[str, float]) -> FloatArray:
    """Return the dry friction at some samples after a reversal, at their speeds [N].

    `selected` is the mask of these samples. `values` contains the parameters of the friction law.
    """
    pressure, static = turn.pressure[selected], values.get(STATIC, values[COULOMB])
    coulomb = values[COULOMB] + values.get(SEAL, 0.0) * pressure
    static = static + (values.get(SEAL, 0.0) + values.get(SEAL_EXCESS, 0.0)) * pressure
    level = sliding_level(turn.velocity[selected], coulomb, static, values.get(STRIBECK, 1.0))
    return np.asarray(np.maximum(level, 1e-9))


def _find_minimum(grid: FloatArray, sums: FloatArray) -> tuple[float, float, float]:
    """Return the logarithm of the stiffness, the damping, and the cost at the minimum of the cost.

    `grid` contains logarithms of stiffnesses, and `sums` the sums of `ReversalData.squares` for each of them. The
    minimum is taken over the stiffnesses and over shifts of the distance.
    """
    square, product, rates = sums.sum(axis=2)
    damping = product / np.maximum(rates, 1e-300)  # negative if the force is delayed
    costs = square - damping * (2.0 * product - damping * rates)
    shift, lowest_costs = np.argmin(costs, axis=0), costs.min(axis=0)
    k = int(np.argmin(lowest_costs))
    optimum = float(grid[k])
    if 0 < k < grid.size - 1:
        # Minimum of a parabola through the lowest point and its neighbours.
        a, b, c = lowest_costs[k - 1 : k + 2].tolist()
        bend = a - 2.0 * b + c
        optimum += 0.5 * float(grid[k + 1] - grid[k]) * (a - c) / bend if bend > 0.0 else 0.0
    return optimum, float(np.interp(optimum, grid, damping[shift, np.arange(grid.size)])), float(lowest_costs.min())

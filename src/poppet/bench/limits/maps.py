"""Maps of bandwidth, step response and stability of the nonlinear model over volume and amplitude."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import product
from operator import attrgetter
from typing import Any

from poppet.bench.limits.bandwidth import BandwidthPoint, bandwidth_point
from poppet.bench.limits.limits_plan import CONTROLLER, LOAD, PARTS, SEVERAL, LimitsPlan, limits_plan
from poppet.bench.limits.stability import Stability, stability_point
from poppet.core.codes import Note
from poppet.core.notebook import HtmlMixin
from poppet.core.toml import ResultFileMixin

__all__ = ["CONTROLLER", "LOAD", "PARTS", "LimitsPlan", "LimitsResult", "find_limits", "limits_plan"]

METHOD = "limits"
DONE, INTERRUPTED = "done", "interrupted"


@dataclass
class LimitsResult(ResultFileMixin, HtmlMixin):
    """Dynamic limits of a valve at all points of a plan that were computed."""

    plan: LimitsPlan
    points: dict[tuple[float, float], BandwidthPoint] = field(
        default_factory=dict
    )  # by volume [m^3] and amplitude [Pa]
    # By factors on spring rates and damping, and by volume [m^3].
    stability: dict[tuple[float, float, float], Stability] = field(default_factory=dict)
    outcome: str = DONE  # `done` or `interrupted`

    def bandwidth_map(self, name: str) -> list[list[Any]]:
        """Return one field of `BandwidthPoint` for all volumes and amplitudes.

        `name` is the name of the field. The result has one inner list per volume, with one value per amplitude.
        """
        return self._over(attrgetter(name), "" if name == "limiting" else math.nan)

    def gains(self, part: str) -> list[list[float]]:
        """Return the factor by which an ideal part increases the bandwidth.

        `part` is the name of the part. The result has one inner list per volume, with one factor per amplitude.
        """
        return self._over(lambda point: point.gains.get(part, math.nan), math.nan)

    def _over(self, value: Callable[[BandwidthPoint], Any], missing: Any) -> list[list[Any]]:
        rows = [[self.points.get((v, a)) for a in self.plan.amplitudes] for v in self.plan.volumes]
        return [[missing if point is None else value(point) for point in row] for row in rows]

    def stability_map(self, name: str, spring: float) -> list[list[Any]]:
        """Return one field of `Stability` for all damping factors and volumes.

        `name` is the name of the field, and `spring` the factor on the spring rates. The result has one inner list per
        damping factor, with one value per volume.
        """
        missing: Any = "" if name in ("smooth", "word") else False if name in ("is_stable", "agrees") else math.nan
        rows = []
        for damping in self.plan.dampings:
            row = [self.stability.get((spring, damping, volume)) for volume in self.plan.volumes]
            rows.append([missing if point is None else getattr(point, name) for point in row])
        return rows

    @property
    def findings(self) -> tuple[Note, ...]:
        """Notes on the parts that limit the bandwidth, and on stability."""
        limited = {key: point for key, point in self.points.items() if point.limiting}
        notes = []
        for part in (*PARTS, LOAD, CONTROLLER):
            keys = [key for key, point in limited.items() if point.limiting == part]
            if not keys:
                continue
            volumes, amplitudes = zip(*keys, strict=True)
            facts = {
                "count": len(keys),
                "known": len(limited),
                "volumes": _smallest_and_largest(volumes),
                "amplitudes": _smallest_and_largest(amplitudes),
            }
            if part == CONTROLLER:
                notes.append(Note("limits.controller", **facts))
                continue
            best = max(keys, key=lambda key: limited[key].gains[part])
            members, gain = 2 if part in SEVERAL else 1, limited[best].gains[part]
            notes.append(Note("limits.part", part, members=members, gain=gain, best=best, **facts))
        return (*notes, *_stability(self))

    def content(self) -> dict[str, Any]:
        """Return the content of the result file as nested dictionaries.

        The dictionaries have the same keys as the TOML and JSON files.
        """
        plan = self.plan
        names = ("gain_frequency", "phase_frequency", "rise_up", "rise_down", "noise", "limiting")
        fields = (
            "growth", "pole_frequency", "is_stable", "smooth", "smooth_amplitude", "smooth_frequency", "amplitude",
            "frequency", "agrees", "word",
        )  # fmt: skip
        return {
            "method": METHOD,
            "title": plan.circuit.title or plan.valve,
            "outcome": self.outcome,
            "findings": [str(note) for note in self.findings],
            "codes": [note.plain() for note in self.findings],
            "conditions": {
                "valve": plan.valve, "outlet": plan.outlet, "mean": plan.mean, "volumes": plan.volumes,
                "amplitudes": plan.amplitudes, "springs": plan.springs, "dampings": plan.dampings,
                "lowest_frequency": plan.lowest, "highest_frequency": plan.highest,
            },
            "bandwidth": {name: self.bandwidth_map(name) for name in names},
            "ideal": {part: self.gains(part) for part in (*PARTS, LOAD)},
            "stability": {
                f"spring {spring:g}": {name: self.stability_map(name, spring) for name in fields}
                for spring in plan.springs
            },
        }  # fmt: skip


def find_limits(plan: LimitsPlan, progress: Callable[[int, int, str], Any] | None = None) -> LimitsResult:
    """Compute bandwidths and stability of a valve at all points of a plan.

    Ctrl-C ends the computation; the result then contains the completed points. The function `progress` is called with
    the number of completed points, the total number and a text.
    """
    result = LimitsResult(plan)
    total = len(plan.volumes) * (len(plan.amplitudes) + len(plan.springs) * len(plan.dampings))
    done = 0

    def report(text: str) -> None:
        if progress is not None:
            progress(done, total, text)

    try:
        for volume in plan.volumes:
            guess: float | None = None
            for amplitude in plan.amplitudes:
                report(f"bandwidth at {volume * 1e3:.3g} l, {amplitude / 1e3:.3g} kPa")
                point = bandwidth_point(plan, volume, amplitude, guess)
                result.points[volume, amplitude] = point
                # A larger amplitude has a lower bandwidth, so the last result is a start value.
                guess, done = point.gain_frequency or None, done + 1
        for spring, damping, volume in product(plan.springs, plan.dampings, plan.volumes):
            report(f"stability at spring x {spring:g}, damping x {damping:g}, {volume * 1e3:.3g} l")
            result.stability[spring, damping, volume] = stability_point(plan, spring, damping, volume)
            done += 1
    except KeyboardInterrupt:
        result.outcome = INTERRUPTED
    report("done")
    return result


def _smallest_and_largest(values: Sequence[float]) -> tuple[float, ...]:
    """Return the smallest and the largest value, or one value if both are equal."""
    return tuple(sorted({min(values), max(values)}))


def _stability(result: LimitsResult) -> list[Note]:
    points = result.stability
    if not points:
        return []
    agreeing = sum(point.agrees for point in points.values())
    notes = [Note("limits.agreement", count=agreeing, known=len(points))]
    unstable = [key for key, point in points.items() if not point.is_stable and math.isfinite(point.growth)]
    if unstable:
        worst = max(unstable, key=lambda key: points[key].growth)
        spring, damping, volume = worst
        point = points[worst]
        notes.append(
            Note(
                "limits.unstable", count=len(unstable), largest=max(key[2] for key in unstable), spring=spring,
                damping=damping, volume=volume, pole=point.pole_frequency, frequency=point.smooth_frequency,
                amplitude=point.smooth_amplitude,
            )
        )  # fmt: skip
    else:
        notes.append(Note("limits.stable"))
    counted = Counter(point.note for point in points.values() if point.note is not None)
    notes += [Note(note.code, note.address, **(note.facts | {"points": n})) for note, n in counted.items()]
    return notes

"""Which part limits a valve: maps of bandwidth, step response and stability of the full model."""

from __future__ import annotations

import math
from collections import Counter
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field
from itertools import product
from operator import attrgetter
from pathlib import Path
from typing import Any

from poppet.bench.limits.bandwidth import Point, bandwidth_point
from poppet.bench.limits.limits_plan import CONTROLLER, LOAD, PARTS, SEVERAL, LimitsPlan, limits_plan
from poppet.bench.limits.stability import Stability, stability_point
from poppet.core.codes import Note
from poppet.core.files import by_suffix, write_whole
from poppet.core.notebook import HtmlMixin
from poppet.core.toml import json_text, toml_text

__all__ = ["CONTROLLER", "LOAD", "PARTS", "LimitsPlan", "LimitsResult", "find_limits", "limits_plan"]

METHOD = "limits"
DONE, INTERRUPTED = "done", "interrupted"


@dataclass
class LimitsResult(HtmlMixin):
    """Dynamic limits of a valve, as far as they were found."""

    plan: LimitsPlan
    points: dict[tuple[float, float], Point] = field(default_factory=dict)  # by volume [m^3] and amplitude [Pa]
    # By factors on spring rates and damping, and by volume [m^3].
    stability: dict[tuple[float, float, float], Stability] = field(default_factory=dict)
    outcome: str = DONE  # `done` or `interrupted`

    def grid(self, name: str) -> list[list[Any]]:
        """A field of the points over volumes (rows) and amplitudes (columns)."""
        return self._over(attrgetter(name), "" if name == "limiting" else math.nan)

    def gains(self, part: str) -> list[list[float]]:
        """Bandwidth with a part ideal over that without, over volumes (rows) and amplitudes (columns)."""
        return self._over(lambda point: point.gains.get(part, math.nan), math.nan)

    def _over(self, value: Callable[[Point], Any], missing: Any) -> list[list[Any]]:
        rows = [[self.points.get((v, a)) for a in self.plan.amplitudes] for v in self.plan.volumes]
        return [[missing if point is None else value(point) for point in row] for row in rows]

    def map(self, name: str, spring: float) -> list[list[Any]]:
        """A field of the stability over dampings (rows) and volumes (columns)."""
        missing: Any = "" if name in ("smooth", "word") else False if name in ("is_stable", "agrees") else math.nan
        rows = []
        for damping in self.plan.dampings:
            row = [self.stability.get((spring, damping, volume)) for volume in self.plan.volumes]
            rows.append([missing if each is None else getattr(each, name) for each in row])
        return rows

    @property
    def findings(self) -> tuple[Note, ...]:
        """What people should know of the maps."""
        return (*_limiting(self), *_stability(self))

    def content(self) -> dict[str, Any]:
        """Everything that is written to a file, as plain tables."""
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
            "bandwidth": {name: self.grid(name) for name in names},
            "ideal": {part: self.gains(part) for part in (*PARTS, LOAD)},
            "stability": {
                f"spring {spring:g}": {name: self.map(name, spring) for name in fields} for spring in plan.springs
            },
        }  # fmt: skip

    def save(self, path: str | Path) -> None:
        """Write the result, `.toml` or `.json`, aside and renamed."""
        text = by_suffix(Path(path), {".toml": toml_text, ".json": json_text})(self.content())
        write_whole(Path(path), lambda stream: stream.write(text.encode("utf-8")))


def find_limits(plan: LimitsPlan, progress: Callable[[int, int, str], Any] | None = None) -> LimitsResult:
    """Look for the dynamic limits of a valve."""
    result = LimitsResult(plan)
    total = len(plan.volumes) * (len(plan.amplitudes) + len(plan.springs) * len(plan.dampings))
    done = 0

    def tell(what: str) -> None:
        if progress is not None:
            progress(done, total, what)

    try:
        for volume in plan.volumes:
            guess: float | None = None
            for amplitude in plan.amplitudes:
                tell(f"bandwidth at {volume * 1e3:.3g} l, {amplitude / 1e3:.3g} kPa")
                point = bandwidth_point(plan, volume, amplitude, guess)
                result.points[volume, amplitude] = point
                # A larger amplitude has the lower bandwidth: the search goes on from the one just found.
                guess, done = point.gain_frequency or None, done + 1
        for spring, damping, volume in product(plan.springs, plan.dampings, plan.volumes):
            tell(f"stability at spring x {spring:g}, damping x {damping:g}, {volume * 1e3:.3g} l")
            result.stability[spring, damping, volume] = stability_point(plan, spring, damping, volume)
            done += 1
    except KeyboardInterrupt:
        result.outcome = INTERRUPTED
    tell("done")
    return result


def _limiting(result: LimitsResult) -> list[Note]:
    """For every part the points that it limits."""
    known = {key: point for key, point in result.points.items() if point.limiting}
    notes = []
    for part in (*PARTS, LOAD, CONTROLLER):
        places = [key for key, point in known.items() if point.limiting == part]
        if not places:
            continue
        volumes, amplitudes = zip(*places, strict=True)
        where = {"count": len(places), "known": len(known), "volumes": _ends(volumes), "amplitudes": _ends(amplitudes)}
        if part == CONTROLLER:
            notes.append(Note("limits.controller", **where))
            continue
        best = max(places, key=lambda key: known[key].gains[part])
        members, gain = 2 if part in SEVERAL else 1, known[best].gains[part]
        notes.append(Note("limits.part", part, members=members, gain=gain, best=best, **where))
    return notes


def _ends(values: Sequence[float]) -> tuple[float, ...]:
    """The least and the greatest, or the only one."""
    return tuple(sorted({min(values), max(values)}))


def _stability(result: LimitsResult) -> list[Note]:
    found = result.stability
    if not found:
        return []
    agreeing = sum(each.agrees for each in found.values())
    notes = [Note("limits.agreement", count=agreeing, known=len(found))]
    unstable = [key for key, each in found.items() if not each.is_stable and math.isfinite(each.growth)]
    if unstable:
        worst = max(unstable, key=lambda key: found[key].growth)
        spring, damping, volume = worst
        each = found[worst]
        notes.append(
            Note(
                "limits.unstable", count=len(unstable), largest=max(key[2] for key in unstable), spring=spring,
                damping=damping, volume=volume, pole=each.pole_frequency, frequency=each.smooth_frequency,
                amplitude=each.smooth_amplitude,
            )
        )  # fmt: skip
    else:
        notes.append(Note("limits.stable"))
    counted = Counter(each.note for each in found.values() if each.note is not None)
    notes += [Note(note.code, note.address, **(note.facts | {"points": n})) for note, n in counted.items()]
    return notes

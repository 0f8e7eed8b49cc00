"""From records to fitted laws: what slides, what is held out, which law the data support."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any

import numpy as np

from poppet.core.errors import ErrorCollector, InputError
from poppet.identify.friction.bristles import Bristles, bristles_of
from poppet.identify.friction.coordinate import Coordinate
from poppet.identify.friction.friction_fit import LAWS, Data, LawFit, fit_law, supported
from poppet.identify.friction.motion import (
    RecordedMotion,
    Rows,
    bending_distances,
    is_steady,
    of_motion,
    of_table,
    stacked,
)
from poppet.identify.friction.records import FrictionRecord
from poppet.timeseries.checks import FloatArray

LUGRE = "lugre"
NARROW = 5.0
"""Fastest over slowest speed below which neither a viscous part nor a Stribeck velocity can be told apart."""
LEVELS_DIFFER, LEAST_PRESSURE = 0.1, 2e3
"""Part of the largest pressure difference over which they have to go for the seals' part to be sought, and a pressure
that gauges resolve [Pa]."""


@dataclass(frozen=True, eq=False)
class FrictionFits:
    """Everything that was found, for findings, pictures and the result."""

    records: tuple[FrictionRecord, ...]
    motions: tuple[RecordedMotion, ...]
    data: Data
    distance: float  # way behind a reversal that is no steady sliding, the usual one [m]
    fits: Mapping[str, LawFit]
    supported: str  # the simplest law that no other beats
    alike: tuple[str, ...]  # laws that cannot be told from the best
    chosen: str
    is_zero_given: bool = True  # of the force, or free: else it was taken for right

    @property
    def coordinate(self) -> Coordinate:
        """How the body moves."""
        return self.records[0].coordinate

    @property
    def is_one_way(self) -> bool:
        """True where all data slide in one direction."""
        return bool(np.ptp(self.data.rows.sign) == 0.0)

    @property
    def fit(self) -> LawFit:
        """The law that was taken."""
        return self.fits[self.chosen]

    @cached_property
    def speeds(self) -> tuple[float, float]:
        """The slowest and the fastest, but for the outermost fiftieths [m/s]."""
        low, high = np.quantile(np.abs(self.data.rows.velocity), [0.02, 0.98]).tolist()
        return low, high

    @property
    def is_narrow(self) -> bool:
        """True where the speeds do not tell the parts of friction."""
        return self.speeds[1] < NARROW * self.speeds[0]

    @cached_property
    def all_rows(self) -> Rows:
        """Those in which bristles bend among them."""
        return stacked([motion.rows for motion in self.motions])

    @cached_property
    def bristles(self) -> Bristles | None:
        """What reversals say of the bristles."""
        return bristles_of(self.motions, self.fit.solution, self.distance)

    @property
    def reversals(self) -> int:
        """How often a body turned round."""
        return sum(len(motion.reversals) for motion in self.motions)


def found_in(
    records: Sequence[FrictionRecord],
    law: str,
    offset: float | str | None,
    smoothing: float | None,
    within: tuple[float, float] | None,
    mass: float,
) -> FrictionFits:
    """All laws fitted to what slides in some records."""
    records = tuple(_less(record, offset) for record in records)
    motions, strokes = [], 0
    for place, record in enumerate(records):
        motion = of_motion(record, place, strokes, smoothing, mass) if record.is_motion else of_table(record, place)
        strokes = int(np.max(motion.rows.stroke, initial=strokes - 1)) + 1
        motions.append(motion)
    distances = bending_distances(motions)
    distance = float(np.median(list(distances.values()))) if distances else 0.0
    rows = stacked([motion.rows for motion in motions])
    behind = np.array([distances[int(k)] for k in rows.stroke])
    slides = (rows.distance > behind) & (rows.sign != 0.0) & is_steady(rows, behind)
    if within is not None:
        slides &= np.isnan(rows.position) | ((rows.position >= within[0]) & (rows.position <= within[1]))
    rows = rows.of(slides)
    unknown = [k for k, r in enumerate(records) if offset == "free" or (offset is None and r.is_motion)]
    with ErrorCollector() as errors:
        for one, other in itertools.combinations(records, 2):
            if all(_same(getattr(one, name), getattr(other, name)) for name in ("force", "velocity", "position")):
                errors.add("friction.same_twice", "file", name=one.name, other=other.name)
        for k, record in enumerate(records):
            if record.body != records[0].body:
                errors.add("friction.bodies", record.name, body=record.body, other=records[0].body)
            own = rows.record == k
            signs = set(rows.sign[own].tolist())
            if not rows.velocity[own].any():
                errors.add("friction.at_rest", "position" if record.is_motion else "velocity", name=record.name)
            elif k in unknown and len(signs) < 2:
                errors.add("friction.one_way", "offset", name=record.name, unit=record.coordinate.effort_unit)
            elif len(signs) > 1 and not np.ptp(record.force):
                own_facts = {"value": float(record.force[0]), "unit": record.coordinate.effort_unit}
                errors.add("friction.still", record.coordinate.effort, name=record.name, **own_facts)
            elif _helps(rows.of(own), is_free=k in unknown):
                errors.add("friction.helps", record.coordinate.effort, name=record.name)
    span = float(np.ptp(rows.pressure)) if len(rows) else 0.0
    has_pressure = span > max(LEVELS_DIFFER * float(np.max(rows.pressure, initial=0.0)), LEAST_PRESSURE)
    data = Data.of(rows, unknown, has_pressure=has_pressure)
    fits = {name: fit for name, each in LAWS.items() if (fit := fit_law(data, each)) is not None}
    if not fits:
        raise InputError("friction.no_law", records[0].coordinate.effort, count=len(rows))
    simplest, alike = supported(fits)
    chosen = simplest if law in ("best", LUGRE) else law
    if chosen not in fits:
        raise InputError("friction.law_not_told", "law", value=chosen)
    is_zero_given = offset is not None or any(record.is_motion for record in records)
    return FrictionFits(records, tuple(motions), data, distance, fits, simplest, tuple(alike), chosen, is_zero_given)


def _same(one: FloatArray | None, other: FloatArray | None) -> bool:
    return one is other is None or (one is not None and other is not None and np.array_equal(one, other))


def _helps(rows: Rows, *, is_free: bool) -> bool:
    """True where what should be friction acts along the motion: some sign is wrong."""
    ways = [float(np.mean(rows.friction[rows.sign == way])) for way in (1.0, -1.0) if (rows.sign == way).any()]
    zero = float(np.mean(ways)) if is_free else 0.0
    along = rows.sign * (rows.friction - zero)
    return float(np.mean(along)) < -0.5 * float(np.sqrt(np.mean(along**2)))


def _less(record: FrictionRecord, offset: float | str | None) -> FrictionRecord:
    """A record without a zero of its force that is known."""
    if not isinstance(offset, float | int) or offset == 0.0:
        return record
    given = {name: getattr(record, name) for name in record.__dataclass_fields__}
    return FrictionRecord(**given | {"force": record.force - float(offset)})


def levels_of(found: FrictionFits) -> list[dict[str, Any]]:
    """Each table or recording for itself: its level of friction, where the law puts it, and what the force says."""
    rows, solution, result = found.data.rows, found.fit.solution, []
    missed = solution.missed(rows)
    for k, record in enumerate(found.records):
        own = rows.record == k
        sign, ways = rows.sign[own], [rows.sign[own] > 0.0, rows.sign[own] < 0.0]
        line = float(np.mean(sign * solution.friction(rows)[own]))
        row = {"name": record.name, "pressure": float(np.mean(rows.pressure[own])), "rows": int(own.sum())}
        row |= {"level": line - float(np.mean(sign * missed[own])), "line": line}
        row |= {"offset": solution.offsets.get(k, 0.0)}
        row |= {"speeds": [float(np.mean(np.abs(rows.velocity[own][way]))) for way in ways if way.any()]}
        if all(way.any() for way in ways):
            row["half_of_force"] = 0.5 * float(-np.diff([np.mean(rows.force[own][way]) for way in ways])[0])
            row["moves"] = 0.5 * float(-np.diff([np.mean(rows.pressure[own][way]) for way in ways])[0])
        result.append(row)
    return result

"""Selection of rows of steady sliding from friction records, and fits of all friction laws to them."""

from __future__ import annotations

import itertools
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np

from poppet.core.errors import ErrorCollector, InputError
from poppet.identify.friction.bristles import Bristles, fit_bristles
from poppet.identify.friction.friction_fit import LAWS, FrictionData, FrictionLawFit, fit_friction_law, select_law
from poppet.identify.friction.motion import (
    RecordedMotion,
    SlidingRows,
    bending_distances,
    is_steady,
    rows_of_recording,
    rows_of_table,
    stack_rows,
)
from poppet.identify.friction.records import Coordinate, FrictionRecord

LUGRE = "lugre"
NARROW = 5.0
"""Ratio of speeds below which a viscous part and a Stribeck velocity are not identifiable."""
LEVELS_DIFFER, LEAST_PRESSURE = 0.1, 2e3
"""Minimum range of pressure differences for a fit of the seal friction: relative to the maximum, and absolute [Pa]."""


@dataclass(frozen=True, eq=False)
class FrictionFits:
    """Fits of all friction laws, with the data that findings, figures and the result need."""

    records: tuple[FrictionRecord, ...]
    motions: tuple[RecordedMotion, ...]
    data: FrictionData
    distance: float  # median distance after a reversal before steady sliding [m]
    fits: Mapping[str, FrictionLawFit]
    supported: str  # simplest law that no other law improves significantly
    equivalent: tuple[str, ...]  # laws that the best law does not improve significantly
    selected: str  # law that the result uses
    is_offset_known: bool = True  # True if the offset of the force is given or free

    @property
    def coordinate(self) -> Coordinate:
        """Kind of motion of the body: translation or rotation."""
        return self.records[0].coordinate

    @property
    def is_one_way(self) -> bool:
        """True if all rows have the same direction of sliding."""
        return bool(np.ptp(self.data.rows.sign) == 0.0)

    @property
    def fit(self) -> FrictionLawFit:
        """Fit of the selected law."""
        return self.fits[self.selected]

    @cached_property
    def ranked(self) -> list[str]:
        """Names of the laws, in the order of their validation errors."""
        return sorted(self.fits, key=lambda name: self.fits[name].held_out_rms)

    @cached_property
    def speeds(self) -> tuple[float, float]:
        """Speeds below which 2 % and 98 % of the rows are [m/s]."""
        low, high = np.quantile(np.abs(self.data.rows.velocity), [0.02, 0.98]).tolist()
        return low, high

    @cached_property
    def mean_friction(self) -> float:
        """Mean magnitude of the modelled friction, above 0 [N]."""
        return max(float(np.mean(np.abs(self.fit.solution.friction(self.data.rows)))), 1e-300)

    @property
    def is_narrow(self) -> bool:
        """True if the range of speeds is too small to separate the terms of a friction law."""
        return self.speeds[1] < NARROW * self.speeds[0]

    @cached_property
    def all_rows(self) -> SlidingRows:
        """All rows of all records, including rows with deflecting bristles after a reversal."""
        return stack_rows([motion.rows for motion in self.motions])

    @cached_property
    def bristles(self) -> Bristles | None:
        """Estimates of bristle stiffness and damping; None if there are too few reversals."""
        return fit_bristles(self.motions, self.fit.solution, self.distance)

    @property
    def reversals(self) -> int:
        """Number of reversals in all recordings."""
        return sum(len(motion.reversals) for motion in self.motions)


def fit_records(
    records: Sequence[FrictionRecord],
    law: str,
    offset: float | str | None,
    smoothing: float | None,
    within: tuple[float, float] | None,
    mass: float,
) -> FrictionFits:
    """Select rows of steady sliding from records and fit all friction laws to them."""
    records = tuple(records)
    if isinstance(offset, float | int) and offset != 0.0:
        records = tuple(replace(record, force=record.force - float(offset)) for record in records)
    motions, strokes = [], 0
    for index, record in enumerate(records):
        if record.is_motion:
            motion = rows_of_recording(record, index, strokes, smoothing, mass)
        else:
            motion = rows_of_table(record, index)
        strokes = int(np.max(motion.rows.stroke, initial=strokes - 1)) + 1
        motions.append(motion)
    distances = bending_distances(motions)
    distance = float(np.median(list(distances.values()))) if distances else 0.0
    rows = stack_rows([motion.rows for motion in motions])
    distance_of_row = np.array([distances[int(k)] for k in rows.stroke])
    slides = (rows.distance > distance_of_row) & (rows.sign != 0.0) & is_steady(rows, distance_of_row)
    if within is not None:
        slides &= np.isnan(rows.position) | ((rows.position >= within[0]) & (rows.position <= within[1]))
    rows = rows.of(slides)
    free_offsets = [k for k, r in enumerate(records) if offset == "free" or (offset is None and r.is_motion)]
    with ErrorCollector() as errors:
        for first, second in itertools.combinations(records, 2):
            # An absent channel is None, which equals only None.
            if all(np.array_equal(getattr(first, n), getattr(second, n)) for n in ("force", "velocity", "position")):
                errors.add("friction.same_twice", "file", name=first.name, other=second.name)
        for k, record in enumerate(records):
            if record.body != records[0].body:
                errors.add("friction.bodies", record.name, body=record.body, other=records[0].body)
            record_rows, unit = rows.of(rows.record == k), record.coordinate.effort_unit
            levels = [np.mean(record_rows.friction[record_rows.sign == sign]) for sign in np.unique(record_rows.sign)]
            zero = np.mean(levels) if levels and k in free_offsets else 0.0
            along = record_rows.sign * (record_rows.friction - zero)
            if not record_rows.velocity.any():
                errors.add("friction.at_rest", "position" if record.is_motion else "velocity", name=record.name)
            elif k in free_offsets and len(levels) < 2:
                errors.add("friction.one_way", "offset", name=record.name, unit=unit)
            elif len(levels) > 1 and not np.ptp(record.force):
                force = float(record.force[0])
                errors.add("friction.still", record.coordinate.effort, name=record.name, value=force, unit=unit)
            elif np.mean(along) < -0.5 * np.sqrt(np.mean(along**2)):  # the friction acts along the motion
                errors.add("friction.helps", record.coordinate.effort, name=record.name)
    span = float(np.ptp(rows.pressure)) if len(rows) else 0.0
    has_pressure = span > max(LEVELS_DIFFER * float(np.max(rows.pressure, initial=0.0)), LEAST_PRESSURE)
    data = FrictionData.of(rows, free_offsets)
    candidates = {name: replace(candidate, has_pressure=has_pressure) for name, candidate in LAWS.items()}
    fits = {name: fit for name, candidate in candidates.items() if (fit := fit_friction_law(data, candidate))}
    if not fits:
        raise InputError("friction.no_law", records[0].coordinate.effort, count=len(rows))
    simplest, equivalent = select_law(fits)
    selected = simplest if law in ("best", LUGRE) else law
    if selected not in fits:
        raise InputError("friction.law_not_told", "law", value=selected)
    is_offset_known = offset is not None or any(record.is_motion for record in records)
    return FrictionFits(
        records, tuple(motions), data, distance, fits, simplest, tuple(equivalent), selected, is_offset_known
    )


def levels_of(analysis: FrictionFits) -> list[dict[str, Any]]:
    """Return one table for each record, with measured and modelled mean friction."""
    solution, levels = analysis.fit.solution, []
    for k, record in enumerate(analysis.records):
        rows = analysis.data.rows.of(analysis.data.rows.record == k)
        line = float(np.mean(rows.sign * solution.friction(rows)))
        directions = [rows.of(rows.sign == sign) for sign in (1.0, -1.0) if (rows.sign == sign).any()]
        row = {
            "name": record.name,
            "pressure": float(np.mean(rows.pressure)),
            "rows": len(rows),
            "level": line - float(np.mean(rows.sign * solution.missed(rows))),
            "line": line,
            "offset": solution.offsets.get(k, 0.0),
            "speeds": [float(np.mean(np.abs(one_way.velocity))) for one_way in directions],
        }
        if len(directions) == 2:
            forward, backward = directions
            row["half_of_force"] = 0.5 * float(np.mean(forward.force) - np.mean(backward.force))
            row["moves"] = 0.5 * float(np.mean(forward.pressure) - np.mean(backward.pressure))
        levels.append(row)
    return levels

"""Findings of a friction identification: the law that the data support, and limits of the data."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator

import numpy as np

from poppet.core.codes import Note
from poppet.core.message_format import facts_of
from poppet.identify.friction.friction_fit import LAWS
from poppet.identify.friction.friction_fits import FrictionFits, levels_of
from poppet.identify.friction.motion import FEWEST, HALF_POWER, SHORTEST
from poppet.identify.friction.records import SEAL, STATIC, STRIBECK, VISCOUS
from poppet.identify.gum import clustered, coverage_factor
from poppet.identify.result import judged

SMEARED = 1.5
"""Residual of lines through the windows, in standard deviations, above which the window is too long."""
ZONES, UNEVEN = 8, 0.05
"""Number of ranges of the stroke, and minimum relative difference of their friction that is reported."""


def findings(analysis: FrictionFits, requested_law: str) -> Iterator[Note]:
    """Yield the findings, the most important first, with the units that their messages need."""
    units = {name: getattr(analysis.coordinate, name) for name in ("effort", "effort_unit", "length", "speed")}
    checks = _bounds, _bristles, _pressure, _sides, _break_away, _positions, _noise, _velocity, _zeros
    for note in itertools.chain(_verdict(analysis, requested_law), *(check(analysis) for check in checks)):
        yield Note(note.code, note.address, **note.facts, **{n: units[n] for n in facts_of(note.code) & units.keys()})


def _zeros(analysis: FrictionFits) -> Iterator[Note]:
    at_zero = [analysis.coordinate.name(name) for name, value in analysis.fit.values.items() if value <= 0.0]
    if at_zero:
        yield Note("friction.at_zero", names=at_zero)


def _verdict(analysis: FrictionFits, requested_law: str) -> Iterator[Note]:
    fits, best = analysis.fits, min(analysis.fits, key=lambda name: analysis.fits[name].held_out_rms)
    errors = {name: fits[name].held_out_rms for name in sorted(fits, key=lambda name: fits[name].held_out_rms)}
    facts = {
        "law": analysis.supported,
        "errors": errors,
        "axis": analysis.data.axis,
        "groups": int(analysis.data.groups.size),
    }
    equivalent = [name for name in analysis.equivalent if name != analysis.supported]
    worse = [name for name in fits if name not in analysis.equivalent]
    yield Note("friction.supported", **facts, others=equivalent, worse=worse, best=best)
    if analysis.selected != analysis.supported and requested_law in fits:
        yield Note("friction.not_supported", chosen=analysis.selected, law=analysis.supported)
    if left_out := [name for name in LAWS if name not in fits]:
        yield Note("friction.not_told", laws=left_out)
    minima = analysis.fit.other_minima
    equivalent_minima = [
        minimum
        for minimum in minima
        if minimum.cost <= max(e.cost for e in [*analysis.fit.allowed, analysis.fit.solution])
    ]
    if equivalent_minima:
        best_values = {
            analysis.coordinate.name(name).partition(".")[2]: value for name, value in analysis.fit.values.items()
        }
        other_values = {
            analysis.coordinate.name(name).partition(".")[2]: value
            for name, value in equivalent_minima[0].values.items()
        }
        yield Note("friction.other_minimum", here=best_values, there=other_values)


def _bounds(analysis: FrictionFits) -> Iterator[Note]:
    """Yield upper bounds on parameters that the selected law does not contain."""
    low, high = analysis.speeds
    if analysis.is_narrow:
        yield Note("friction.narrow", low=low, high=high, ratio=high / low)
    missing = [name for name in (VISCOUS, STATIC, STRIBECK) if name not in analysis.fit.values]
    richer = {VISCOUS: "coulomb_viscous", STATIC: "stribeck", STRIBECK: "stribeck"}
    for name in missing:
        law = "stribeck_viscous" if VISCOUS in analysis.fit.values or STATIC in analysis.fit.values else richer[name]
        if law in analysis.fits:
            fit = analysis.fits[law]
            _, bottom, top = fit.interval(name)
            verdict = judged(max(top - fit.values[name], fit.values[name] - bottom), fit.values[name])
            adds = top * high if name == VISCOUS else None
            bounds = {"low": bottom, "high": top, "unit": analysis.coordinate.unit(name), "adds": adds}
            yield Note("friction.bounded", analysis.coordinate.name(name), **bounds, law=law, verdict=verdict)


def _bristles(analysis: FrictionFits) -> Iterator[Note]:
    bristles = analysis.bristles
    if bristles is None:
        yield Note("friction.no_reversals", count=analysis.reversals)
    elif bristles.is_seen:
        facts = {"way": bristles.way, "rms": bristles.rms, "without": bristles.rms_without}
        yield Note("friction.bristles", **facts, count=bristles.reversals, resolution=bristles.resolution)
        if bristles.is_late:
            yield Note("friction.force_late", lag=-bristles.damping / bristles.stiffness)
        elif bristles.is_coarse:
            facts = {"step": bristles.late / bristles.stiffness, "late": bristles.late, "high": bristles.damping_high}
            yield Note("friction.damping_coarse", **facts, window=bristles.window, bending=bristles.bending)
        elif not bristles.is_damped:
            yield Note("friction.damping_open", high=bristles.damping_high)
    else:
        yield Note("friction.bristles_unresolved", resolution=bristles.resolution, low=bristles.low)


def _pressure(analysis: FrictionFits) -> Iterator[Note]:
    rows = analysis.data.rows
    levels = levels_of(analysis)
    if SEAL not in analysis.fit.values:
        if any(record.pressure is not None for record in analysis.records):
            yield Note("friction.one_pressure", pressure=float(np.mean(rows.pressure)))
        else:
            yield Note("friction.no_pressure")
    elif len(levels) > 1:
        deviations = [row["level"] - row["line"] for row in levels]
        worst = int(np.argmax(np.abs(deviations)))
        yield Note("friction.between", off=deviations[worst], name=levels[worst]["name"], count=len(levels))
        if len(levels) == 2:
            yield Note("friction.two_pressures")
    bidirectional = [row for row in levels if "moves" in row and analysis.records[0].pressure_force is not None]
    differences = [row["half_of_force"] - row["level"] for row in bidirectional]
    if bidirectional and max(map(abs, differences)) > UNEVEN * max(row["level"] for row in bidirectional):
        crude = [row["half_of_force"] for row in bidirectional]
        moves = 2.0 * max(abs(row["moves"]) for row in bidirectional)
        yield Note("friction.pressure_moves", crude=crude, level=[row["level"] for row in bidirectional], moves=moves)


def _sides(analysis: FrictionFits) -> Iterator[Note]:
    """Yield findings on a difference of friction between the two directions of motion."""
    data, rows = analysis.data, analysis.data.rows
    if analysis.is_one_way:
        yield Note("friction.one_side", assumed=not analysis.is_offset_known)
        return
    if data.free_offsets:
        yield Note("friction.sides_open", offsets=[*analysis.fit.solution.offsets.values()])
        return
    matrix = np.column_stack([np.ones(len(rows)), analysis.fit.solution.design(rows)]) * np.sqrt(rows.weight)[:, None]
    linear, *_ = np.linalg.lstsq(matrix, rows.friction * np.sqrt(rows.weight), rcond=None)
    errors = matrix @ linear - rows.friction * np.sqrt(rows.weight)
    spread = clustered(matrix, errors, data.group, 1)
    half = coverage_factor(float(spread.freedom[0])) * math.sqrt(float(spread.covariance[0, 0]))
    level = max(float(np.mean(np.abs(analysis.fit.solution.friction(rows)))), 1e-300)
    facts = {"value": float(linear[0]), "half": half, "part": 100.0 * float(linear[0]) / level}
    yield Note("friction.lopsided" if abs(linear[0]) > half else "friction.even", **facts)


def _break_away(analysis: FrictionFits) -> Iterator[Note]:
    """Yield a finding on friction that is higher at the start of strokes than in the middle."""
    rows, solution, excess, levels = analysis.all_rows, analysis.fit.solution, [], []
    friction_along_motion = rows.sign * (rows.friction - solution.zero(rows))
    for k in np.unique(rows.stroke[rows.stroke >= 0]):
        indices = np.flatnonzero(rows.stroke == k)
        first = indices[rows.distance[indices] <= 3.0 * analysis.distance]
        steady = indices[rows.distance[indices] > 3.0 * analysis.distance]
        if first.size >= 2 and steady.size >= 2 * first.size:
            middle = (steady.size - first.size) // 2
            control = steady[middle : middle + first.size]
            excess.append(float(np.max(friction_along_motion[first]) - np.max(friction_along_motion[control])))
            levels.append(float(np.median(friction_along_motion[steady])))
    if len(excess) < 4:
        return
    mean, error = float(np.mean(excess)), float(np.std(excess, ddof=1)) / math.sqrt(len(excess))
    if mean > coverage_factor(len(excess) - 1.0) * error and mean > UNEVEN * float(np.mean(levels)):
        yield Note("friction.break_away", excess=mean, error=error, level=float(np.mean(levels)), count=len(excess))


def _positions(analysis: FrictionFits) -> Iterator[Note]:
    """Yield a finding on friction that depends on the position of the body."""
    rows = analysis.data.rows
    if np.isnan(rows.position).any() or (rows.stroke < 0).all():
        return
    ends = np.quantile(rows.position, [0.0, 1.0])
    zone = np.minimum((ZONES * (rows.position - ends[0]) / np.ptp(ends)).astype(int), ZONES - 1)
    excess = -rows.sign * analysis.fit.errors  # measurement minus law
    means = np.array([np.mean(excess[zone == k]) if (zone == k).sum() > 3 else math.nan for k in range(ZONES)])
    if np.isnan(means).all():
        return
    level = max(float(np.mean(np.abs(analysis.fit.solution.friction(rows)))), 1e-300)
    worst = int(np.nanargmax(np.abs(means)))
    if abs(means[worst]) > UNEVEN * level:
        range_of_positions = [float(ends[0] + (worst + end) / ZONES * np.ptp(ends)) for end in (0, 1)]
        yield Note(
            "friction.places",
            off=float(means[worst]),
            part=100.0 * float(means[worst]) / level,
            place=range_of_positions,
        )


def _noise(analysis: FrictionFits) -> Iterator[Note]:
    stated = [record.uncertainty for record in analysis.records if record.uncertainty is not None]
    if stated:
        noise, rms = float(np.median(np.concatenate(stated))), float(np.sqrt(np.mean(analysis.fit.errors**2)))
        if rms > 2.0 * noise:
            yield Note("friction.misfit", rms=rms, noise=noise, factor=rms / noise)


def _velocity(analysis: FrictionFits) -> Iterator[Note]:
    timed = [(r.name, m) for r, m in zip(analysis.records, analysis.motions, strict=True) if r.is_motion]
    if not timed:
        return
    windows = [value for _, motion in timed for value in motion.windows]
    noise = max(value for _, motion in timed for value in motion.velocity_noise)
    facts = {
        "windows": [min(windows), max(windows)],
        "bandwidths": [HALF_POWER / w for w in (max(windows), min(windows))],
    }
    yield Note("friction.velocity", **facts, noise=noise, distance=analysis.distance)
    if left_out := sum(motion.left_out for _, motion in timed):
        yield Note("friction.short_strokes", count=left_out, least=FEWEST * SHORTEST)
    if smeared := [name for name, motion in timed if motion.smear > SMEARED]:
        yield Note("friction.smeared", names=smeared, factor=max(m.smear for _, m in timed))

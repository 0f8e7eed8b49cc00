"""What a reader has to know of a friction that was found: the verdict on its law, and what the data do not say."""

from __future__ import annotations

import math
from collections.abc import Iterator

import numpy as np

from poppet.core.codes import Note
from poppet.core.message_format import facts_of
from poppet.identify.clusters import clustered
from poppet.identify.friction.coordinate import STATIC, STRIBECK, VISCOUS
from poppet.identify.friction.friction_fit import LAWS, design
from poppet.identify.friction.friction_fits import FrictionFits, levels_of
from poppet.identify.friction.motion import FEWEST, HALF_POWER, SHORTEST
from poppet.identify.gum import coverage_factor
from poppet.identify.result import judged

SMEARED = 1.5
"""Misfit of lines over the windows, in noises, above which a motion is faster than its smoothing."""
PLACES, UNEVEN = 8, 0.05
"""Parts of the stroke that are compared, and the part of friction by which they have to differ to be said."""


def findings(found: FrictionFits, asked: str) -> Iterator[Note]:
    """The most important first, each with the units that its words show."""
    own = found.coordinate
    units = {"effort": own.effort, "effort_unit": own.effort_unit, "length": own.length, "speed": own.speed}
    for note in _findings(found, asked):
        yield Note(note.code, note.address, **note.facts, **{n: units[n] for n in facts_of(note.code) & units.keys()})


def _findings(found: FrictionFits, asked: str) -> Iterator[Note]:
    yield from _verdict(found, asked)
    yield from _open(found)
    yield from _bristles(found)
    yield from _pressure(found)
    yield from _sides(found)
    yield from _break_away(found)
    yield from _places(found)
    yield from _noise(found)
    yield from _velocity(found)
    at_zero = [found.coordinate.name(name) for name, value in found.fit.values.items() if value <= 0.0]
    if at_zero:
        yield Note("friction.at_zero", names=at_zero)


def _verdict(found: FrictionFits, asked: str) -> Iterator[Note]:
    fits, best = found.fits, min(found.fits, key=lambda name: found.fits[name].held_out_rms)
    errors = {name: fits[name].held_out_rms for name in sorted(fits, key=lambda name: fits[name].held_out_rms)}
    facts = {"law": found.supported, "errors": errors, "axis": found.data.axis, "groups": int(found.data.groups.size)}
    others = [name for name in found.alike if name != found.supported]
    worse = [name for name in fits if name not in found.alike]
    yield Note("friction.supported", **facts, others=others, worse=worse, best=best)
    if found.chosen != found.supported and asked in fits:
        yield Note("friction.not_supported", chosen=found.chosen, law=found.supported)
    if left_out := [name for name in LAWS if name not in fits]:
        yield Note("friction.not_told", laws=left_out)
    others_at = found.fit.others
    within = [each for each in others_at if each.cost <= max(e.cost for e in [*found.fit.allowed, found.fit.solution])]
    if within:
        here = {found.coordinate.name(name).partition(".")[2]: value for name, value in found.fit.values.items()}
        there = {found.coordinate.name(name).partition(".")[2]: value for name, value in within[0].values.items()}
        yield Note("friction.other_minimum", here=here, there=there)


def _open(found: FrictionFits) -> Iterator[Note]:
    """Numbers that the law does not have, as far as the data bound them."""
    low, high = found.speeds
    if found.is_narrow:
        yield Note("friction.narrow", low=low, high=high, ratio=high / low)
    missing = [name for name in (VISCOUS, STATIC, STRIBECK) if name not in found.fit.values]
    richer = {VISCOUS: "coulomb_viscous", STATIC: "stribeck", STRIBECK: "stribeck"}
    for name in missing:
        law = "stribeck_viscous" if VISCOUS in found.fit.values or STATIC in found.fit.values else richer[name]
        if law in found.fits:
            fit = found.fits[law]
            _, bottom, top = fit.interval(name)
            verdict = judged(max(top - fit.values[name], fit.values[name] - bottom), fit.values[name])
            adds = top * high if name == VISCOUS else None
            bounds = {"low": bottom, "high": top, "unit": found.coordinate.unit(name), "adds": adds}
            yield Note("friction.bounded", found.coordinate.name(name), **bounds, law=law, verdict=verdict)


def _bristles(found: FrictionFits) -> Iterator[Note]:
    bristles = found.bristles
    if bristles is None:
        yield Note("friction.no_reversals", count=found.reversals)
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


def _pressure(found: FrictionFits) -> Iterator[Note]:
    rows = found.data.rows
    levels = levels_of(found)
    if not found.data.has_pressure:
        if any(record.pressure is not None for record in found.records):
            yield Note("friction.one_pressure", pressure=float(np.mean(rows.pressure)))
        else:
            yield Note("friction.no_pressure")
    elif len(levels) > 1:
        off = [each["level"] - each["line"] for each in levels]
        worst = int(np.argmax(np.abs(off)))
        yield Note("friction.between", off=off[worst], name=levels[worst]["name"], count=len(levels))
        if len(levels) == 2:
            yield Note("friction.two_pressures")
    told = [each for each in levels if "moves" in each and found.records[0].pressure_force is not None]
    moved = [each["half_of_force"] - each["level"] for each in told]
    if told and max(map(abs, moved)) > UNEVEN * max(each["level"] for each in told):
        crude = [each["half_of_force"] for each in told]
        moves = 2.0 * max(abs(each["moves"]) for each in told)
        yield Note("friction.pressure_moves", crude=crude, level=[e["level"] for e in told], moves=moves)


def _sides(found: FrictionFits) -> Iterator[Note]:
    """Whether friction is the same both ways, as far as the zero of the force is known."""
    data, rows = found.data, found.data.rows
    if found.is_one_way:
        yield Note("friction.one_side", assumed=not found.is_zero_given)
        return
    if data.free_offsets:
        yield Note("friction.sides_open", offsets=[*found.fit.solution.offsets.values()])
        return
    law, values = found.fit.solution.law, found.fit.values
    columns = design(rows, law, values.get(STRIBECK, 1.0), (), has_pressure=data.has_pressure)
    matrix = np.column_stack([np.ones(len(rows)), columns]) * np.sqrt(rows.weight)[:, None]
    linear, *_ = np.linalg.lstsq(matrix, rows.friction * np.sqrt(rows.weight), rcond=None)
    errors = matrix @ linear - rows.friction * np.sqrt(rows.weight)
    spread = clustered(matrix, errors, data.group, 1)
    half = coverage_factor(float(spread.freedom[0])) * math.sqrt(float(spread.covariance[0, 0]))
    level = max(float(np.mean(np.abs(found.fit.solution.friction(rows)))), 1e-300)
    facts = {"value": float(linear[0]), "half": half, "part": 100.0 * float(linear[0]) / level}
    yield Note("friction.lopsided" if abs(linear[0]) > half else "friction.even", **facts)


def _break_away(found: FrictionFits) -> Iterator[Note]:
    """Peaks at the begin of strokes, over what chance makes of as many blocks in their middle."""
    rows, solution, excess, levels = found.all_rows, found.fit.solution, [], []
    along = rows.sign * (rows.friction - solution.zero(rows))
    for k in np.unique(rows.stroke[rows.stroke >= 0]):
        own = np.flatnonzero(rows.stroke == k)
        first = own[rows.distance[own] <= 3.0 * found.distance]
        rest = own[rows.distance[own] > 3.0 * found.distance]
        if first.size >= 2 and rest.size >= 2 * first.size:
            middle = (rest.size - first.size) // 2
            control = rest[middle : middle + first.size]
            excess.append(float(np.max(along[first]) - np.max(along[control])))
            levels.append(float(np.median(along[rest])))
    if len(excess) < 4:
        return
    mean, error = float(np.mean(excess)), float(np.std(excess, ddof=1)) / math.sqrt(len(excess))
    if mean > coverage_factor(len(excess) - 1.0) * error and mean > UNEVEN * float(np.mean(levels)):
        yield Note("friction.break_away", excess=mean, error=error, level=float(np.mean(levels)), count=len(excess))


def _places(found: FrictionFits) -> Iterator[Note]:
    """Whether friction is the same all over the stroke."""
    rows = found.data.rows
    if np.isnan(rows.position).any() or (rows.stroke < 0).all():
        return
    ends = np.quantile(rows.position, [0.0, 1.0])
    part = np.minimum((PLACES * (rows.position - ends[0]) / np.ptp(ends)).astype(int), PLACES - 1)
    more = -rows.sign * found.fit.errors  # measurement above the law
    means = np.array([np.mean(more[part == k]) if (part == k).sum() > 3 else math.nan for k in range(PLACES)])
    if np.isnan(means).all():
        return
    level = max(float(np.mean(np.abs(found.fit.solution.friction(rows)))), 1e-300)
    worst = int(np.nanargmax(np.abs(means)))
    if abs(means[worst]) > UNEVEN * level:
        place = [float(ends[0] + (worst + each) / PLACES * np.ptp(ends)) for each in (0, 1)]
        yield Note("friction.places", off=float(means[worst]), part=100.0 * float(means[worst]) / level, place=place)


def _noise(found: FrictionFits) -> Iterator[Note]:
    stated = [record.uncertainty for record in found.records if record.uncertainty is not None]
    if stated:
        noise, rms = float(np.median(np.concatenate(stated))), float(np.sqrt(np.mean(found.fit.errors**2)))
        if rms > 2.0 * noise:
            yield Note("friction.misfit", rms=rms, noise=noise, factor=rms / noise)


def _velocity(found: FrictionFits) -> Iterator[Note]:
    timed = [(r.name, m) for r, m in zip(found.records, found.motions, strict=True) if r.is_motion]
    if not timed:
        return
    windows = [each for _, motion in timed for each in motion.windows]
    noise = max(each for _, motion in timed for each in motion.velocity_noise)
    facts = {
        "windows": [min(windows), max(windows)],
        "bandwidths": [HALF_POWER / w for w in (max(windows), min(windows))],
    }
    yield Note("friction.velocity", **facts, noise=noise, distance=found.distance)
    if left_out := sum(motion.left_out for _, motion in timed):
        yield Note("friction.short_strokes", count=left_out, least=FEWEST * SHORTEST)
    if smeared := [name for name, motion in timed if motion.smear > SMEARED]:
        yield Note("friction.smeared", names=smeared, factor=max(m.smear for _, m in timed))

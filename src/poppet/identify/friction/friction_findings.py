"""Findings of a friction identification: the law that the data support, and limits of the data."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator

import numpy as np

from poppet.core.codes import Note
from poppet.core.message_format import facts_of
from poppet.identify.friction.friction_fit import GROWING_LAWS, LAWS, FrictionFits, levels_of
from poppet.identify.friction.motion import FEWEST, HALF_POWER, SHORTEST, stack_rows
from poppet.identify.friction.records import SEAL, SEAL_EXCESS, STATIC, STRIBECK, VISCOUS
from poppet.identify.gum import cluster_covariance, coverage_factor
from poppet.identify.result import verdict_on_interval

SMEARED = 1.5
"""Residual of lines through the windows, in standard deviations, above which the window is too long."""
ZONES, UNEVEN = 8, 0.05
"""Number of ranges of the stroke, and minimum relative difference of their friction that is reported."""


def findings(analysis: FrictionFits) -> Iterator[Note]:
    """Yield all findings on friction, the most important first."""
    units = {name: getattr(analysis.coordinate, name) for name in ("effort", "effort_unit", "length", "speed")}
    checks = _law_notes, _seal_and_bristle_notes, _motion_notes, _recording_notes
    for note in itertools.chain.from_iterable(check(analysis) for check in checks):
        shown = facts_of(note.code)
        yield Note(note.code, note.address, **note.facts, **{n: unit for n, unit in units.items() if n in shown})


def _law_notes(analysis: FrictionFits) -> Iterator[Note]:
    """Yield notes on the friction law that the data support, and on parameters that the selected law does not contain.

    The notes state upper bounds on these parameters.
    """
    fits, fit, ranked, coordinate = analysis.fits, analysis.fit, analysis.ranked, analysis.coordinate
    yield Note(
        "friction.supported",
        law=analysis.supported,
        errors={name: fits[name].held_out_rms for name in ranked},
        axis=analysis.data.axis,
        groups=int(analysis.data.groups.size),
        others=[name for name in analysis.equivalent if name != analysis.supported],
        worse=[name for name in fits if name not in analysis.equivalent],
        best=ranked[0],
    )
    if analysis.selected != analysis.supported:
        yield Note("friction.not_supported", chosen=analysis.selected, law=analysis.supported)
    if left_out := [name for name in LAWS if name not in fits]:
        yield Note("friction.not_told", laws=left_out)
    limit = max(solution.cost for solution in [*fit.equivalent_solutions, fit.solution])
    if equivalent_minima := [minimum for minimum in fit.other_minima if minimum.cost <= limit]:
        best_values, other_values = (
            {coordinate.name(name).partition(".")[2]: value for name, value in solution.values.items()}
            for solution in (fit.solution, equivalent_minima[0])
        )
        yield Note("friction.other_minimum", here=best_values, there=other_values)
    low, high = analysis.speeds
    if analysis.is_narrow:
        yield Note("friction.narrow", low=low, high=high, ratio=high / low)
    richer = {VISCOUS: "coulomb_viscous", STATIC: "stribeck", STRIBECK: "stribeck"}
    if VISCOUS in fit.values or STATIC in fit.values:
        law = "stribeck_seal_viscous" if analysis.selected in GROWING_LAWS else "stribeck_viscous"
        richer = dict.fromkeys(richer, law)
    for name, law in richer.items():
        if name not in fit.values and law in fits:
            value, (_, bottom, top) = fits[law].values[name], fits[law].interval(name)
            adds = top * high if name == VISCOUS else None
            bounds = {"low": bottom, "high": top, "unit": coordinate.unit(name), "adds": adds}
            verdict = verdict_on_interval(max(top - value, value - bottom), value)
            yield Note("friction.bounded", coordinate.name(name), **bounds, law=law, verdict=verdict)


def _seal_and_bristle_notes(analysis: FrictionFits) -> Iterator[Note]:
    """Yield findings on the bristles (elastic contact) and on the dependence of the friction on the pressure."""
    bristles, levels = analysis.bristles, levels_of(analysis)
    if bristles is None:
        yield Note("friction.no_reversals", count=analysis.reversals)
    elif bristles.is_resolved:
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
    if SEAL not in analysis.fit.values:
        if any(record.pressure is not None for record in analysis.records):
            yield Note("friction.one_pressure", pressure=float(np.mean(analysis.data.rows.pressure)))
        else:
            yield Note("friction.no_pressure")
    elif len(levels) > 1:
        worst = max(levels, key=lambda row: abs(row["level"] - row["line"]))
        yield Note("friction.between", off=worst["level"] - worst["line"], name=worst["name"], count=len(levels))
        if len(levels) == 2:
            yield Note("friction.two_pressures")
    if SEAL_EXCESS in analysis.fit.values:
        value, (_, low, high) = analysis.fit.values[SEAL_EXCESS], analysis.fit.interval(SEAL_EXCESS)
        pressure = float(np.max(analysis.data.rows.pressure))
        bounds = {"value": value * pressure, "low": low * pressure, "high": high * pressure, "pressure": pressure}
        yield Note("friction.seal_excess", **bounds, law=analysis.selected)
    elif analysis.grows:
        yield Note("friction.pressure_speed", law=analysis.selected, other=analysis.supported)
    if analysis.lacks_viscous_pressure_term:
        yield Note("friction.pressure_viscous", law=analysis.selected)
    bidirectional = [row for row in levels if "moves" in row and analysis.records[0].pressure_force is not None]
    crude, level = ([row[name] for row in bidirectional] for name in ("half_of_force", "level"))
    if bidirectional and np.max(np.abs(np.subtract(crude, level))) > UNEVEN * max(level):
        moves = 2.0 * max(abs(row["moves"]) for row in bidirectional)
        yield Note("friction.pressure_moves", crude=crude, level=level, moves=moves)


def _motion_notes(analysis: FrictionFits) -> Iterator[Note]:
    """Yield findings on friction that differs between directions, at the start of strokes, or along the stroke."""
    data, rows, solution = analysis.data, analysis.data.rows, analysis.fit.solution
    if analysis.is_one_way:
        yield Note("friction.one_side", assumed=not analysis.is_offset_known)
    elif data.free_offsets:
        yield Note("friction.sides_open", offsets=[*solution.offsets.values()])
    else:
        root = np.sqrt(rows.weight)
        matrix = np.column_stack([np.ones(len(rows)), solution.design(rows)]) * root[:, None]
        linear, *_ = np.linalg.lstsq(matrix, rows.friction * root, rcond=None)
        spread = cluster_covariance(matrix, matrix @ linear - rows.friction * root, data.group, 1)
        half = coverage_factor(float(spread.freedom[0])) * math.sqrt(float(spread.covariance[0, 0]))
        facts = {"value": float(linear[0]), "half": half, "part": 100.0 * float(linear[0]) / analysis.mean_friction}
        yield Note("friction.lopsided" if abs(linear[0]) > half else "friction.even", **facts)
    # All rows, including rows with deflecting bristles after a reversal.
    rows, excess, levels = stack_rows([motion.rows for motion in analysis.motions]), [], []
    friction_along_motion = rows.sign * (rows.friction - solution.force_offset(rows))
    for k in np.unique(rows.stroke[rows.stroke >= 0]):
        is_stroke, is_start = rows.stroke == k, rows.distance <= 3.0 * analysis.distance
        start, steady = friction_along_motion[is_stroke & is_start], friction_along_motion[is_stroke & ~is_start]
        if start.size >= 2 and steady.size >= 2 * start.size:
            middle = (steady.size - start.size) // 2
            excess.append(float(np.max(start) - np.max(steady[middle : middle + start.size])))
            levels.append(float(np.median(steady)))
    if len(excess) >= 4:
        mean, error = float(np.mean(excess)), float(np.std(excess, ddof=1)) / math.sqrt(len(excess))
        if mean > coverage_factor(len(excess) - 1.0) * error and mean > UNEVEN * float(np.mean(levels)):
            yield Note("friction.break_away", excess=mean, error=error, level=float(np.mean(levels)), count=len(excess))
    rows = data.rows
    if np.isnan(rows.position).any() or (rows.stroke < 0).all():
        return
    low, span = float(np.min(rows.position)), float(np.ptp(rows.position))
    zone = np.minimum((ZONES * (rows.position - low) / span).astype(int), ZONES - 1)
    deviations = -rows.sign * analysis.fit.errors  # measurement minus law
    means = np.array([np.mean(deviations[zone == k]) if (zone == k).sum() > 3 else 0.0 for k in range(ZONES)])
    worst = int(np.argmax(np.abs(means)))
    if abs(means[worst]) > UNEVEN * analysis.mean_friction:
        facts = {"off": float(means[worst]), "part": 100.0 * float(means[worst]) / analysis.mean_friction}
        yield Note("friction.places", **facts, place=[low + (worst + end) / ZONES * span for end in (0, 1)])


def _recording_notes(analysis: FrictionFits) -> Iterator[Note]:
    """Yield findings on the quality of the recordings.

    They concern noise, the smoothing of velocities, omitted strokes, and parameters that the fit has set to zero.
    """
    stated = [record.uncertainty for record in analysis.records if record.uncertainty is not None]
    if stated:
        noise, rms = float(np.median(np.concatenate(stated))), float(np.sqrt(np.mean(analysis.fit.errors**2)))
        if rms > 2.0 * noise:
            yield Note("friction.misfit", rms=rms, noise=noise, factor=rms / noise)
    timed = [(r.name, m) for r, m in zip(analysis.records, analysis.motions, strict=True) if r.is_motion]
    if timed:
        windows = [window for _, motion in timed for window in motion.windows]
        ends = [min(windows), max(windows)]
        facts = {"windows": ends, "bandwidths": [HALF_POWER / window for window in reversed(ends)]}
        noise = max(noise for _, motion in timed for noise in motion.velocity_noise)
        yield Note("friction.velocity", **facts, noise=noise, distance=analysis.distance)
    if left_out := sum(motion.left_out for _, motion in timed):
        yield Note("friction.short_strokes", count=left_out, least=FEWEST * SHORTEST)
    if smeared := [name for name, motion in timed if motion.smear > SMEARED]:
        yield Note("friction.smeared", names=smeared, factor=max(m.smear for _, m in timed))
    if at_zero := [analysis.coordinate.name(name) for name, value in analysis.fit.values.items() if value <= 0.0]:
        yield Note("friction.at_zero", names=at_zero)

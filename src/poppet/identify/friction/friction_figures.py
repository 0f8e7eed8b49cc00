"""Curves of friction for reports: versus time, speed and pressure, and after reversals."""

from __future__ import annotations

from typing import Any

import numpy as np

from poppet.identify.friction.bristles import usable_reversals
from poppet.identify.friction.coordinate import COULOMB, SEAL, STATIC, STRIBECK, VISCOUS
from poppet.identify.friction.friction_fits import FrictionFits
from poppet.identify.gum import coverage_factor
from poppet.laws.physics.friction import sliding_level

MOST = 1500
"""Maximum number of points of a curve."""


def series(analysis: FrictionFits) -> dict[str, Any]:
    """Return the curves of a result by name."""
    result, unit = {}, analysis.coordinate.effort_unit
    rows, solution = analysis.data.rows, analysis.fit.solution
    zero, model = solution.zero(rows), solution.friction(rows)
    for k, record in enumerate(analysis.records):
        if record.is_motion:
            is_record = rows.record == k
            columns = {"time": rows.time, "measured": rows.friction - zero, "model": model}
            result[f"{record.name}.friction"] = {n: values[is_record] for n, values in columns.items()} | {"unit": unit}
    parameters = analysis.fit.values
    friction_along_motion = rows.sign * (rows.friction - zero)
    speed = np.abs(rows.velocity)
    x = np.linspace(0.0, 1.02 * float(speed.max()), 120)
    dry = parameters[COULOMB], parameters.get(STATIC, parameters[COULOMB]), parameters.get(STRIBECK, 1.0)
    selected = _select_points(len(rows))
    result["speed.friction"] = {
        "x": x,
        "y": sliding_level(x, *dry) + parameters.get(VISCOUS, 0.0) * x,
        "points_x": speed[selected],
        "points_y": (friction_along_motion - parameters.get(SEAL, 0.0) * rows.pressure)[selected],
        "unit": analysis.coordinate.effort_unit,
        "x_unit": analysis.coordinate.speed,
        "x_name": "speed",
    }
    if analysis.data.has_pressure:
        result["pressure.friction"] = _pressure_curve(analysis, friction_along_motion)
    if analysis.bristles is not None:
        result["reversal.friction"] = _reversal_curve(analysis)
    return result


def _pressure_curve(analysis: FrictionFits, friction_along_motion: Any) -> dict[str, Any]:
    """Return friction versus pressure, with one point for each recording, or all rows of a single recording."""
    rows, parameters = analysis.data.rows, analysis.fit.values
    residual = friction_along_motion - (
        analysis.fit.solution.friction(rows) * rows.sign - parameters[COULOMB] - parameters[SEAL] * rows.pressure
    )
    groups = [np.flatnonzero(rows.record == k) for k in np.unique(rows.record)]
    if len(groups) < 2:
        groups = [np.array([k]) for k in _select_points(len(rows))]
    x = np.linspace(0.0, 1.05 * float(rows.pressure.max()), 80)
    covariance, order = analysis.fit.spread.covariance, list(analysis.fit.values)
    pair = np.ix_(*[[order.index(COULOMB), order.index(SEAL)]] * 2)
    base = np.stack([np.ones_like(x), x], axis=1)
    line = parameters[COULOMB] + parameters[SEAL] * x
    freedom = float(min(analysis.fit.spread.freedom[pair[0][:, 0]]))
    half = coverage_factor(freedom) * np.sqrt(np.einsum("ij,jk,ik->i", base, covariance[pair], base))
    is_known = bool(np.isfinite(half).all())
    return {
        "x": x,
        "y": line,
        **({"low": line - half, "high": line + half} if is_known else {}),
        "points_x": np.array([float(np.mean(rows.pressure[indices])) for indices in groups]),
        "points_y": np.array([float(np.mean(residual[indices])) for indices in groups]),
        "unit": analysis.coordinate.effort_unit,
        "x_unit": "Pa",
        "x_name": "pressure difference",
    }


def _reversal_curve(analysis: FrictionFits) -> dict[str, Any]:
    """Return the friction versus the distance after a reversal, scaled to the mean level."""
    bristles = analysis.bristles
    assert bristles is not None
    turns = [
        turn
        for turn in usable_reversals(analysis.motions, analysis.fit.solution, analysis.distance)
        if not turn.is_chained
    ]
    level = bristles.stiffness * bristles.way
    distance = np.concatenate([turn.distance for turn in turns])
    friction_along_motion = level * np.concatenate([turn.measured / turn.level for turn in turns])
    selected = _select_points(distance.size)
    x = np.linspace(0.0, analysis.distance, 200)
    return {
        "x": x,
        "y": level * (1.0 - 2.0 * np.exp(-x / bristles.way)),
        "points_x": distance[selected],
        "points_y": friction_along_motion[selected],
        "unit": analysis.coordinate.effort_unit,
        "x_unit": analysis.coordinate.length,
        "x_name": "way behind a reversal",
    }


def _select_points(count: int) -> Any:
    return np.unique(np.linspace(0, count - 1, min(count, MOST)).round().astype(int))

"""What the page draws of friction: over time, speed and pressure, and behind reversals."""

from __future__ import annotations

from typing import Any

import numpy as np

from poppet.identify.friction.bristles import usable
from poppet.identify.friction.coordinate import COULOMB, SEAL, STATIC, STRIBECK, VISCOUS
from poppet.identify.friction.friction_fits import FrictionFits
from poppet.identify.gum import coverage_factor
from poppet.laws.physics.friction import sliding_level

MOST = 1500
"""Points of a picture over speed or way."""


def series(found: FrictionFits) -> dict[str, Any]:
    """By name, as a result takes them."""
    result, unit = {}, found.coordinate.effort_unit
    rows, solution = found.data.rows, found.fit.solution
    zero, model = solution.zero(rows), solution.friction(rows)
    for k, record in enumerate(found.records):
        if record.is_motion:
            own = rows.record == k
            columns = {"time": rows.time, "measured": rows.friction - zero, "model": model}
            result[f"{record.name}.friction"] = {n: each[own] for n, each in columns.items()} | {"unit": unit}
    value = found.fit.values
    along = rows.sign * (rows.friction - zero)
    speed = np.abs(rows.velocity)
    x = np.linspace(0.0, 1.02 * float(speed.max()), 120)
    dry = value[COULOMB], value.get(STATIC, value[COULOMB]), value.get(STRIBECK, 1.0)
    kept = _thinned(len(rows))
    result["speed.friction"] = {
        "x": x,
        "y": sliding_level(x, *dry) + value.get(VISCOUS, 0.0) * x,
        "points_x": speed[kept],
        "points_y": (along - value.get(SEAL, 0.0) * rows.pressure)[kept],
        "unit": found.coordinate.effort_unit,
        "x_unit": found.coordinate.speed,
        "x_name": "speed",
    }
    if found.data.has_pressure:
        result["pressure.friction"] = _over_pressure(found, along)
    if found.bristles is not None:
        result["reversal.friction"] = _behind_reversals(found)
    return result


def _over_pressure(found: FrictionFits, along: Any) -> dict[str, Any]:
    """One point for each recording where there are several; of one all rows."""
    rows, value = found.data.rows, found.fit.values
    more = along - (found.fit.solution.friction(rows) * rows.sign - value[COULOMB] - value[SEAL] * rows.pressure)
    places = [np.flatnonzero(rows.record == k) for k in np.unique(rows.record)]
    if len(places) < 2:
        places = [np.array([k]) for k in _thinned(len(rows))]
    x = np.linspace(0.0, 1.05 * float(rows.pressure.max()), 80)
    covariance, order = found.fit.spread.covariance, list(found.fit.values)
    pair = np.ix_(*[[order.index(COULOMB), order.index(SEAL)]] * 2)
    base = np.stack([np.ones_like(x), x], axis=1)
    line = value[COULOMB] + value[SEAL] * x
    freedom = float(min(found.fit.spread.freedom[pair[0][:, 0]]))
    half = coverage_factor(freedom) * np.sqrt(np.einsum("ij,jk,ik->i", base, covariance[pair], base))
    is_known = bool(np.isfinite(half).all())
    return {
        "x": x,
        "y": line,
        **({"low": line - half, "high": line + half} if is_known else {}),
        "points_x": np.array([float(np.mean(rows.pressure[each])) for each in places]),
        "points_y": np.array([float(np.mean(more[each])) for each in places]),
        "unit": found.coordinate.effort_unit,
        "x_unit": "Pa",
        "x_name": "pressure difference",
    }


def _behind_reversals(found: FrictionFits) -> dict[str, Any]:
    """Friction along the motion over the way behind a reversal, each at its speed scaled to the usual level."""
    bristles = found.bristles
    assert bristles is not None
    turns = [each for each in usable(found.motions, found.fit.solution, found.distance) if not each.is_chained]
    level = bristles.stiffness * bristles.way
    distance = np.concatenate([turn.way for turn in turns])
    along = level * np.concatenate([turn.wanted / turn.level for turn in turns])
    kept = _thinned(distance.size)
    x = np.linspace(0.0, found.distance, 200)
    return {
        "x": x,
        "y": level * (1.0 - 2.0 * np.exp(-x / bristles.way)),
        "points_x": distance[kept],
        "points_y": along[kept],
        "unit": found.coordinate.effort_unit,
        "x_unit": found.coordinate.length,
        "x_name": "way behind a reversal",
    }


def _thinned(count: int) -> Any:
    return np.unique(np.linspace(0, count - 1, min(count, MOST)).round().astype(int))

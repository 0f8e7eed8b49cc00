"""Method `identify friction`, which selects a dry friction law by validation errors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.codes import Note, notes_of
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.identify.data_file import or_file
from poppet.identify.friction.bristles import usable_reversals
from poppet.identify.friction.friction_file import read_friction_file
from poppet.identify.friction.friction_findings import findings
from poppet.identify.friction.friction_fit import LAWS
from poppet.identify.friction.friction_fits import LUGRE, FrictionFits, fit_records, levels_of
from poppet.identify.friction.motion import HALF_POWER
from poppet.identify.friction.records import (
    BRISTLES,
    COORDINATES,
    COULOMB,
    DAMPING,
    SEAL,
    STATIC,
    STRIBECK,
    TURNING,
    VISCOUS,
    FrictionRecord,
)
from poppet.identify.gum import correlations, coverage_factor
from poppet.identify.result import VERDICTS, Estimate, ResidualSummary, Result, judged
from poppet.laws.physics.friction import sliding_level

MOST = 1500
"""Maximum number of points of a curve."""


@or_file(read_friction_file)
def identify_friction(
    records: FrictionRecord | Sequence[FrictionRecord] | str | Path,
    *,
    law: str = "best",
    offset: float | str | None = None,
    smoothing: float | None = None,
    within: tuple[float, float] | None = None,
    mass: float = 0.0,
    inertia: float = 0.0,
    pulley_radius: float | None = None,
    part: str = "",
    cylinder: str = "",
    title: str = "friction",
    notes: Sequence[Note] = (),
) -> Result:
    """Identify the friction law from velocity-force tables or recordings of a moved body.

    Parameters
    ----------
    records : FrictionRecord, sequence of them, str or Path
        Tables or recordings, possibly at several pressures, or a file for `read_friction_file`.
    law : str, optional
        `best` (default) is the simplest law that no other law improves significantly. Alternatives are `coulomb`,
        `coulomb_viscous`, `stribeck`, `stribeck_viscous`, and `lugre` for the best of these with bristles.
    offset : float or str, optional
        Offset of the force [N] or torque [N m]; `free` estimates it for each recording. The default is `free` for
        recordings and 0 for tables.
    smoothing : float, optional
        Window of the velocities [s]; the default is the shortest window with a velocity noise of 3 %.
    within : (float, float), optional
        Range of positions that the fit uses [m] or [rad].
    mass, inertia : float, optional
        Accelerated mass [kg], or moment of inertia of a joint [kg m^2].
    pulley_radius : float, optional
        Radius of the pulley of a joint, at which the seals act [m].
    part, cylinder : str, optional
        Names of body and cylinder in a circuit; the addresses of the estimates begin with them.
    title : str, optional
        Title of the result.
    notes : sequence of Note, optional
        Notes on the records.

    Returns
    -------
    Result
        Parameters of body and cylinder with intervals; `comparison["laws"]` has all laws.

    Raises
    ------
    InputError
        Unknown law, a mass together with a joint, no sliding, one direction only with a free offset, too few rows.

    Notes
    -----
    A row is a point of a table, or one window of a recording. Bristles deflect for a short distance after a reversal.
    Rows within this distance are not steady sliding. They determine only the stiffness of the bristles.

    The method selects the simplest law that no other law improves significantly, by the errors at withheld recordings
    or strokes. The intervals are based on the number of these groups, not of samples.

    References
    ----------
    Hastie, Tibshirani & Friedman 2009, The elements of statistical learning, section 7.10, for the selection
    of the simplest law; Canudas de Wit et al. 1995, IEEE Trans. Automatic Control 40, 419-425.

    Examples
    --------
    >>> speed = np.array([0.01, 0.02, 0.04, 0.08, 0.16, 0.32])
    >>> result = identify_friction(FrictionRecord(force=20.0 + 30.0 * speed, velocity=speed))
    >>> {name: round(found.value, 6) for name, found in result.parameters.items()}
    {'friction.coulomb_force': 20.0, 'friction.viscous_coefficient': 30.0}
    """
    valid = ("best", *LAWS, LUGRE)
    if law not in valid:
        raise InputError("fields.not_an_option", "law", value=law, meaning="law", near=NameSuggestion(law, valid))
    assert not isinstance(records, str | Path)  # `or_file` has read a file
    record_list = [records] if isinstance(records, FrictionRecord) else [*records]
    coordinate = record_list[0].coordinate
    with ErrorCollector() as errors:
        opposite = next(estimate for estimate in COORDINATES.values() if estimate is not coordinate)
        if {"mass": mass, "inertia": inertia}[opposite.inertia]:
            errors.add(
                "friction.of_other_body",
                opposite.inertia,
                body=opposite.body,
                effort=coordinate.effort,
                other=coordinate.body,
            )
        if (
            pulley_radius is None
            and coordinate is TURNING
            and any(record.pressure is not None for record in record_list)
        ):
            errors.add("friction.no_radius", "pulley_radius")
    analysis = fit_records(record_list, law, offset, smoothing, within, mass or inertia)
    is_seen = analysis.bristles is not None and analysis.bristles.is_seen
    if law == LUGRE and not is_seen:
        raise InputError("friction.no_bristles", "law", reversals=analysis.reversals)

    def addressed(name: str) -> str:
        owner = cylinder if name == SEAL else part
        return f"{owner}.{coordinate.name(name)}" if owner else coordinate.name(name)

    estimates = {addressed(name): estimate for name, estimate in _estimates(analysis, pulley_radius or 1.0).items()}
    covariance, order = analysis.fit.spread.covariance, [addressed(name) for name in analysis.fit.values]
    is_finite = np.isfinite(np.diag(covariance))
    finite_names = [name for name, is_in in zip(order, is_finite, strict=True) if is_in]
    return Result(
        method="friction",
        title=title,
        parameters=estimates,
        residuals=_residuals(analysis),
        correlation=correlations(finite_names, covariance[np.ix_(is_finite, is_finite)]) if finite_names else {},
        comparison=_comparison(analysis, estimates),
        remarks=(*findings(analysis, law), *notes_of(notes)),
        conditions=_conditions(analysis, mass or inertia),
        series=_curves(analysis),
    )


def _estimates(analysis: FrictionFits, radius: float) -> dict[str, Estimate]:
    estimates, viscous_law = {}, f"{analysis.selected}_viscous"
    richer = analysis.fits[viscous_law] if viscous_law in analysis.equivalent else None
    for name, value in analysis.fit.values.items():
        error, low, high = analysis.fit.interval(name)
        if richer is not None and name in (COULOMB, STATIC, STRIBECK):
            # A possible viscous part reduces the Coulomb force.
            _, bottom, top = richer.interval(name)
            low, high = min(low, bottom), high if name == COULOMB else max(high, top)
        if name == COULOMB and analysis.is_narrow and VISCOUS not in analysis.fit.values:
            # In a narrow range of speeds, viscous and static parts look like Coulomb friction.
            viscous = analysis.fits.get("coulomb_viscous")
            is_told = viscous is not None and any(LAWS[candidate].is_falling for candidate in analysis.fits)
            low = min(low, viscous.interval(name)[1]) if viscous is not None and is_told else 0.0
        verdict = judged(max(high - value, value - low), value) if value > 0.0 else "at bound"
        if name in (COULOMB, STATIC) and analysis.is_one_way and not analysis.is_offset_known:
            verdict = max(verdict, "weak", key=VERDICTS.index)  # an offset of the force counts as friction
        lever = radius if name == SEAL else 1.0  # seals act at the radius of the pulley
        sizes = value / lever, analysis.coordinate.unit(name), error / lever, low / lever, high / lever
        estimates[name] = Estimate(*sizes, verdict)
    bristles = analysis.bristles
    if bristles is not None and bristles.is_seen:
        size = bristles.stiffness, analysis.coordinate.unit(BRISTLES), bristles.error, bristles.low, bristles.high
        # The interval is logarithmic.
        estimates[BRISTLES] = Estimate(*size, judged((bristles.high / bristles.low) ** 0.5 - 1.0, 1.0))
    if bristles is not None and bristles.is_damped:
        about = bristles.damping, analysis.coordinate.unit(DAMPING), bristles.damping_error
        ends = bristles.damping_low, bristles.damping_high
        verdict = judged(0.5 * (ends[1] - ends[0]), bristles.damping)
        estimates[DAMPING] = Estimate(*about, *ends, verdict)
    return estimates


def _residuals(analysis: FrictionFits) -> dict[str, ResidualSummary]:
    rows, model = analysis.data.rows, analysis.fit.solution
    modelled, result = model.friction(rows) + model.zero(rows), {}
    for k, record in enumerate(analysis.records):
        is_record = rows.record == k
        result[f"{record.name}.friction"] = ResidualSummary.of(
            modelled[is_record], rows.friction[is_record], analysis.coordinate.effort_unit
        )
    return result


def _comparison(analysis: FrictionFits, estimates: Mapping[str, Estimate]) -> dict[str, Any]:
    bristles = analysis.bristles
    is_seen = bristles is not None and bristles.is_seen
    laws = [
        {
            "law": name,
            "held_out": fit.held_out_rms,
            "rms": float(np.sqrt(np.mean(fit.errors**2))),
            "numbers": len(fit.values),
            "alike": name in analysis.equivalent,
        }
        for name, fit in sorted(analysis.fits.items(), key=lambda item: item[1].held_out_rms)
    ]
    comparison: dict[str, Any] = {"law": LUGRE if is_seen else analysis.selected, "levels": analysis.selected}
    comparison |= {
        "body": analysis.coordinate.body,
        "supported": analysis.supported,
        "held_out_by": analysis.data.axis,
        "laws": laws,
    }
    if bristles is not None:
        comparison["bristles"] = dict(vars(bristles)) | {"is_seen": bristles.is_seen, "is_damped": bristles.is_damped}
    return comparison | {"recordings": levels_of(analysis), "ready": circuit_lines(estimates)}


def circuit_lines(estimates: Mapping[str, Estimate]) -> str:
    """Return the estimates as text lines for the body and the cylinder of a circuit file."""
    friction_fields, lines = [], []
    for address, estimate in estimates.items():
        *owner, name = address.split(".")
        if name == SEAL:
            lines.append(f'{name} = "{1e5 * estimate.value:.4g} N/bar"')
        elif "friction" in owner:
            friction_fields.append(f'{name} = "{estimate.value:.4g} {estimate.unit}"')
    return "\n".join([f'friction = {{ kind = "lugre", {", ".join(friction_fields)} }}', *lines])


def _conditions(analysis: FrictionFits, inertia: float) -> dict[str, Any]:
    rows, timed = analysis.data.rows, [motion for motion in analysis.motions if motion.windows]
    speed = np.abs(rows.velocity)
    conditions: dict[str, Any] = {
        "recordings": [record.name for record in analysis.records],
        "samples": sum(len(record) for record in analysis.records),
        "rows": len(rows),
        "groups": int(analysis.data.groups.size),
        "speed": [float(speed.min()), float(speed.max())],
    }
    if rows.pressure.any():
        conditions["pressure_difference"] = [float(rows.pressure.min()), float(rows.pressure.max())]
    if timed:
        conditions |= {
            "smoothing": _range([window for motion in timed for window in motion.windows]),
            "bandwidth": _range([HALF_POWER / window for motion in timed for window in motion.windows]),
            "velocity_noise": _range([window for motion in timed for window in motion.velocity_noise]),
            "reversals": analysis.reversals,
            "bending_distance": analysis.distance,
        }
    return conditions | ({analysis.coordinate.inertia: inertia} if inertia else {})


def _range(values: Sequence[float]) -> list[float]:
    return [min(values), max(values)]


def _curves(analysis: FrictionFits) -> dict[str, Any]:
    """Return the curves that the report shows, by name."""
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
    """Return friction versus pressure.

    The curve has one point for each recording, or all rows if there is only one recording.
    """
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
    """Return friction versus the distance after a reversal, scaled to the mean sliding level."""
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

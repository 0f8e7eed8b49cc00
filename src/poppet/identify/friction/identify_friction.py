"""Method `identify friction`, which selects a dry friction law by validation errors."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note, notes_of
from poppet.core.errors import ErrorCollector, InputError
from poppet.core.tables import Field
from poppet.identify.data_file import or_file
from poppet.identify.friction.bristles import usable_reversals
from poppet.identify.friction.friction_file import read_friction_file
from poppet.identify.friction.friction_findings import findings
from poppet.identify.friction.friction_fit import GROWING_LAWS, LAWS, LUGRE, FrictionFits, fit_records, levels_of
from poppet.identify.friction.motion import HALF_POWER
from poppet.identify.friction.records import (
    BRISTLES,
    COULOMB,
    DAMPING,
    SEAL,
    SEAL_EXCESS,
    STATIC,
    STRIBECK,
    TURNING,
    VISCOUS,
    FrictionRecord,
)
from poppet.identify.gum import correlations, coverage_factor
from poppet.identify.result import VERDICTS, Estimate, ResidualSummary, Result, verdict_on_interval
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
        `coulomb_viscous`, `stribeck`, `stribeck_viscous`, `stribeck_seal` and `stribeck_seal_viscous`. In the last
        two, static and Coulomb friction depend on the pressure by different coefficients. `lugre` adds bristles
        (elastic contact) to the best of these laws.
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
    Field(choices=("best", *LAWS, *GROWING_LAWS, LUGRE)).read(law, "law")
    assert not isinstance(records, str | Path)  # `or_file` has read a file
    record_list = [records] if isinstance(records, FrictionRecord) else [*records]
    coordinate = record_list[0].coordinate
    with ErrorCollector() as errors:
        opposite = coordinate.opposite
        if {"mass": mass, "inertia": inertia}[opposite.inertia]:
            facts = {"body": opposite.body, "effort": coordinate.effort, "other": coordinate.body}
            errors.add("friction.of_other_body", opposite.inertia, **facts)
        has_pressure = any(record.pressure is not None for record in record_list)
        if pulley_radius is None and coordinate is TURNING and has_pressure:
            errors.add("friction.no_radius", "pulley_radius")
    analysis = fit_records(record_list, law, offset, smoothing, within, mass or inertia)
    is_resolved = analysis.bristles is not None and analysis.bristles.is_resolved
    if law == LUGRE and not is_resolved:
        raise InputError("friction.no_bristles", "law", reversals=analysis.reversals)

    def addressed(name: str) -> str:
        owner = cylinder if name in (SEAL, SEAL_EXCESS) else part
        return f"{owner}.{coordinate.name(name)}" if owner else coordinate.name(name)

    estimates = {addressed(name): estimate for name, estimate in _estimates(analysis, pulley_radius or 1.0).items()}
    seal_excess = estimates.pop(addressed(SEAL_EXCESS), None)  # not a parameter of circuits
    covariance, order = analysis.fit.spread.covariance, [addressed(name) for name in analysis.fit.values]
    is_finite = np.isfinite(np.diag(covariance)) & np.array([name != addressed(SEAL_EXCESS) for name in order])
    finite_names = [name for name, is_in in zip(order, is_finite, strict=True) if is_in]
    rows, solution = analysis.data.rows, analysis.fit.solution
    modelled = solution.friction(rows) + solution.force_offset(rows)
    residuals = {}
    for k, record in enumerate(record_list):
        pair = modelled[rows.record == k], rows.friction[rows.record == k]
        residuals[f"{record.name}.friction"] = ResidualSummary.of(*pair, coordinate.effort_unit)
    return Result(
        method="friction",
        title=title,
        parameters=estimates,
        residuals=residuals,
        correlation=correlations(finite_names, covariance[np.ix_(is_finite, is_finite)]) if finite_names else {},
        comparison=_comparison(analysis, estimates)
        | ({"seal_excess": vars(seal_excess).copy()} if seal_excess else {}),
        remarks=(*findings(analysis), *notes_of(notes)),
        conditions=_conditions(analysis, mass or inertia),
        series=_report_curves(analysis),
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
            is_told = viscous is not None and any(fit.solution.law.is_falling for fit in analysis.fits.values())
            low = min(low, viscous.interval(name)[1]) if viscous is not None and is_told else 0.0
        verdict = verdict_on_interval(max(high - value, value - low), value) if value > 0.0 else "at bound"
        if name in (COULOMB, STATIC) and analysis.is_one_way and not analysis.is_offset_known:
            verdict = max(verdict, "weak", key=VERDICTS.index)  # an offset of the force counts as friction
        misses_pressure = (
            analysis.grows and SEAL_EXCESS not in analysis.fit.values
        ) or analysis.lacks_viscous_pressure_term
        if misses_pressure and name != SEAL_EXCESS:
            verdict = max(verdict, "weak", key=VERDICTS.index)  # the law lacks an effect of the pressure
        lever = radius if name in (SEAL, SEAL_EXCESS) else 1.0  # seals act at the radius of the pulley
        sizes = value / lever, analysis.coordinate.unit(name), error / lever, low / lever, high / lever
        estimates[name] = Estimate(*sizes, verdict)
    bristles = analysis.bristles
    if bristles is not None and bristles.is_resolved:
        # The interval is logarithmic.
        verdict = verdict_on_interval((bristles.high / bristles.low) ** 0.5 - 1.0, 1.0)
        unit, ends = analysis.coordinate.unit(BRISTLES), (bristles.low, bristles.high)
        estimates[BRISTLES] = Estimate(bristles.stiffness, unit, bristles.error, *ends, verdict)
    if bristles is not None and bristles.is_damped:
        unit, ends = analysis.coordinate.unit(DAMPING), (bristles.damping_low, bristles.damping_high)
        verdict = verdict_on_interval(0.5 * (ends[1] - ends[0]), bristles.damping)
        estimates[DAMPING] = Estimate(bristles.damping, unit, bristles.damping_error, *ends, verdict)
    return estimates


def _comparison(analysis: FrictionFits, estimates: Mapping[str, Estimate]) -> dict[str, Any]:
    bristles = analysis.bristles
    flags = {"is_seen": bristles.is_resolved, "is_damped": bristles.is_damped} if bristles else {}
    friction_fields, lines = [], []
    for address, estimate in estimates.items():
        *owner, name = address.split(".")
        if name == SEAL:
            lines.append(f'{name} = "{1e5 * estimate.value:.4g} N/bar"')
        elif "friction" in owner:
            friction_fields.append(f'{name} = "{estimate.value:.4g} {estimate.unit}"')
    return {
        "law": LUGRE if flags.get("is_seen") else analysis.selected,
        "levels": analysis.selected,
        "body": analysis.coordinate.body,
        "supported": analysis.supported,
        "held_out_by": analysis.data.axis,
        "laws": [
            {
                "law": name,
                "held_out": fit.held_out_rms,
                "rms": float(np.sqrt(np.mean(fit.errors**2))),
                "numbers": len(fit.values),
                "alike": name in analysis.equivalent,
            }
            for name, fit in ((name, analysis.fits[name]) for name in analysis.ranked)
        ],
        **({"bristles": vars(bristles) | flags} if bristles else {}),
        "recordings": levels_of(analysis),
        # Lines for the body and the cylinder of a circuit file.
        "ready": "\n".join([f'friction = {{ kind = "lugre", {", ".join(friction_fields)} }}', *lines]),
    }


def _conditions(analysis: FrictionFits, inertia: float) -> dict[str, Any]:
    rows, timed = analysis.data.rows, [motion for motion in analysis.motions if motion.windows]
    windows = [window for motion in timed for window in motion.windows]
    ranges = {
        "speed": np.abs(rows.velocity),
        "pressure_difference": rows.pressure if rows.pressure.any() else [],
        "smoothing": windows,
        "bandwidth": [HALF_POWER / window for window in windows],
        "velocity_noise": [noise for motion in timed for noise in motion.velocity_noise],
    }
    return {
        "recordings": [record.name for record in analysis.records],
        "samples": sum(len(record) for record in analysis.records),
        "rows": len(rows),
        "groups": int(analysis.data.groups.size),
        **{name: [float(np.min(values)), float(np.max(values))] for name, values in ranges.items() if len(values)},
        **({"reversals": analysis.reversals, "bending_distance": analysis.distance} if timed else {}),
        **({analysis.coordinate.inertia: inertia} if inertia else {}),
    }


def _report_curves(analysis: FrictionFits) -> dict[str, Any]:
    """Return measured and modelled friction for the figures of the report, by name of the figure."""
    rows, solution, parameters = analysis.data.rows, analysis.fit.solution, analysis.fit.values
    bristles, unit = analysis.bristles, analysis.coordinate.effort_unit
    measured, model, curves = rows.friction - solution.force_offset(rows), solution.friction(rows), {}
    for k, record in enumerate(analysis.records):
        if record.is_motion:
            columns = {"time": rows.time, "measured": measured, "model": model}
            curves[f"{record.name}.friction"] = {n: v[rows.record == k] for n, v in columns.items()} | {"unit": unit}
    speed, selected = np.abs(rows.velocity), _select_points(len(rows))
    x = np.linspace(0.0, 1.02 * float(speed.max()), 120)
    dry = parameters[COULOMB], parameters.get(STATIC, parameters[COULOMB]), parameters.get(STRIBECK, 1.0)
    pressure_part = parameters.get(SEAL, 0.0) * rows.pressure
    pressure_part += parameters.get(SEAL_EXCESS, 0.0) * rows.pressure * np.exp(-((speed / dry[2]) ** 2))
    curves["speed.friction"] = {
        "x": x,
        "y": sliding_level(x, *dry) + parameters.get(VISCOUS, 0.0) * x,
        "points_x": speed[selected],
        "points_y": (rows.sign * measured - pressure_part)[selected],
        "x_unit": analysis.coordinate.speed,
        "x_name": "speed",
    }
    if SEAL in parameters:
        # One point for each recording, or all samples of a single recording.
        groups = [np.flatnonzero(rows.record == k) for k in np.unique(rows.record)]
        groups = groups if len(groups) > 1 else [np.array([k]) for k in selected]
        x, spread = np.linspace(0.0, 1.05 * float(rows.pressure.max()), 80), analysis.fit.spread
        pair = [list(parameters).index(name) for name in (COULOMB, SEAL)]
        base, line = np.stack([np.ones_like(x), x], axis=1), parameters[COULOMB] + parameters[SEAL] * x
        variance = np.einsum("ij,jk,ik->i", base, spread.covariance[np.ix_(pair, pair)], base)
        half = coverage_factor(float(min(spread.freedom[pair]))) * np.sqrt(variance)
        friction = rows.sign * (measured - model) + parameters[COULOMB] + parameters[SEAL] * rows.pressure
        curves["pressure.friction"] = {
            "x": x,
            "y": line,
            **({"low": line - half, "high": line + half} if np.isfinite(half).all() else {}),
            "points_x": np.array([float(np.mean(rows.pressure[indices])) for indices in groups]),
            "points_y": np.array([float(np.mean(friction[indices])) for indices in groups]),
            "x_unit": "Pa",
            "x_name": "pressure difference",
        }
    if bristles is not None:
        turns = usable_reversals(analysis.motions, parameters, solution.offsets, analysis.distance)
        turns = [turn for turn in turns if not turn.is_chained]
        level = bristles.stiffness * bristles.way  # mean sliding level
        distance = np.concatenate([turn.distance for turn in turns])
        selected = _select_points(distance.size)
        x = np.linspace(0.0, analysis.distance, 200)
        curves["reversal.friction"] = {
            "x": x,
            "y": level * (1.0 - 2.0 * np.exp(-x / bristles.way)),
            "points_x": distance[selected],
            "points_y": level * np.concatenate([turn.measured / turn.level for turn in turns])[selected],
            "x_unit": analysis.coordinate.length,
            "x_name": "way behind a reversal",
        }
    return {name: curve | {"unit": unit} for name, curve in curves.items()}


def _select_points(count: int) -> NDArray[np.int_]:
    return np.unique(np.linspace(0, count - 1, min(count, MOST)).round().astype(int))

"""Identification of dry friction; validation errors rank the laws."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.codes import Note, notes_of
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.identify.file_argument import or_file
from poppet.identify.friction import friction_figures, friction_findings
from poppet.identify.friction.coordinate import (
    BRISTLES,
    COORDINATES,
    COULOMB,
    DAMPING,
    SEAL,
    STATIC,
    STRIBECK,
    TURNING,
    VISCOUS,
)
from poppet.identify.friction.friction_file import read_friction_file
from poppet.identify.friction.friction_fit import LAWS
from poppet.identify.friction.friction_fits import LUGRE, FrictionFits, fit_records, levels_of
from poppet.identify.friction.motion import HALF_POWER
from poppet.identify.friction.records import FrictionRecord
from poppet.identify.gum import correlations
from poppet.identify.result import VERDICTS, Estimate, ResidualSummary, Result, judged


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
        Names of body and cylinder in a circuit; they become the first part of each address.
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
    A row is a point of a table, or one window of a recording. Rows with deflecting bristles after a reversal are not
    steady sliding: they determine the stiffness of the bristles only.

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
        remarks=(*friction_findings.findings(analysis, law), *notes_of(notes)),
        conditions=_conditions(analysis, mass or inertia),
        series=friction_figures.series(analysis),
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
    """Return the estimates as fields of a body and a cylinder in a circuit file."""
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

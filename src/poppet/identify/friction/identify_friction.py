"""Identify friction: every law fitted, ranked by what it misses of held-out recordings or strokes."""

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
from poppet.identify.friction.friction_fits import LUGRE, FrictionFits, found_in, levels_of
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
    """Find the law of friction from velocity-force tables, or from recordings of a body that is pulled.

    Parameters
    ----------
    records : FrictionRecord, sequence of them, str or Path
        Tables or recordings, at several pressures perhaps, or a file as `read_friction_file` reads it.
    law : str, optional
        `best` (default): the simplest law that no other beats. Or one of `coulomb`, `coulomb_viscous`, `stribeck`,
        `stribeck_viscous`; `lugre` asks for the best of these with bristles.
    offset : float or str, optional
        Zero of the force [N] or torque [N m]; `free` finds it in each recording. Default free for recordings, 0 for
        tables.
    smoothing : float, optional
        Window over which velocities are taken [s]; by default the shortest that knows them to 3 %.
    within : (float, float), optional
        Positions between which sliding counts [m] or [rad].
    mass, inertia : float, optional
        What the measured force or torque accelerates: mass [kg], moment of inertia of a joint [kg m^2].
    pulley_radius : float, optional
        Of a joint: where the seals rub that are under pressure [m].
    part, cylinder : str, optional
        Names of body and cylinder in circuits; put before the addresses of the result.
    title : str, optional
        For people.
    notes : sequence of Note, optional
        What was said while reading.

    Returns
    -------
    Result
        Numbers of the law as a body and its cylinder take them, with intervals; all laws under `comparison["laws"]`.

    Raises
    ------
    InputError
        Unknown law, a mass and a joint together, nothing that slides,
        one direction only where the zero of the force is free, too few rows.

    Notes
    -----
    A row is a point of a table, or what a recording says over one window. Rows in which bristles still bend behind a
    reversal are not steady sliding: they tell the stiffness of the bristles, and nothing of the levels.

    The simplest law is taken that no other beats by more than chance, in what both miss of recordings, or strokes, that
    they have not seen. Intervals count such groups, not samples.

    References
    ----------
    Hastie, Tibshirani & Friedman 2009, The elements of statistical learning, section 7.10, for the choice of the
    simplest law within the scatter of the best; Canudas de Wit et al. 1995, IEEE Trans. Automatic Control 40, 419-425.

    Examples
    --------
    >>> speed = np.array([0.01, 0.02, 0.04, 0.08, 0.16, 0.32])
    >>> result = identify_friction(FrictionRecord(force=20.0 + 30.0 * speed, velocity=speed))
    >>> {name: round(found.value, 6) for name, found in result.parameters.items()}
    {'friction.coulomb_force': 20.0, 'friction.viscous_coefficient': 30.0}
    """
    known = ("best", *LAWS, LUGRE)
    if law not in known:
        raise InputError("fields.not_an_option", "law", value=law, meaning="law", near=NameSuggestion(law, known))
    assert not isinstance(records, str | Path)  # a file was read at the door
    given = [records] if isinstance(records, FrictionRecord) else [*records]
    own = given[0].coordinate
    with ErrorCollector() as errors:
        other = next(each for each in COORDINATES.values() if each is not own)
        if {"mass": mass, "inertia": inertia}[other.inertia]:
            errors.add("friction.of_other_body", other.inertia, body=other.body, effort=own.effort, other=own.body)
        if pulley_radius is None and own is TURNING and any(record.pressure is not None for record in given):
            errors.add("friction.no_radius", "pulley_radius")
    found = found_in(given, law, offset, smoothing, within, mass or inertia)
    is_seen = found.bristles is not None and found.bristles.is_seen
    if law == LUGRE and not is_seen:
        raise InputError("friction.no_bristles", "law", reversals=found.reversals)

    def addressed(name: str) -> str:
        owner = cylinder if name == SEAL else part
        return f"{owner}.{own.name(name)}" if owner else own.name(name)

    estimates = {addressed(name): each for name, each in _estimates(found, pulley_radius or 1.0).items()}
    covariance, order = found.fit.spread.covariance, [addressed(name) for name in found.fit.values]
    seen = np.isfinite(np.diag(covariance))
    known_names = [name for name, is_in in zip(order, seen, strict=True) if is_in]
    return Result(
        method="friction",
        title=title,
        parameters=estimates,
        residuals=_residuals(found),
        correlation=correlations(known_names, covariance[np.ix_(seen, seen)]) if known_names else {},
        comparison=_comparison(found, estimates),
        remarks=(*friction_findings.findings(found, law), *notes_of(notes)),
        conditions=_conditions(found, mass or inertia),
        series=friction_figures.series(found),
    )


def _estimates(found: FrictionFits, radius: float) -> dict[str, Estimate]:
    estimates, viscous_law = {}, f"{found.chosen}_viscous"
    richer = found.fits[viscous_law] if viscous_law in found.alike else None
    for name, value in found.fit.values.items():
        error, low, high = found.fit.interval(name)
        if richer is not None and name in (COULOMB, STATIC, STRIBECK):
            # Where data do not deny a viscous part: it leaves less to the Coulomb force, never more.
            _, bottom, top = richer.interval(name)
            low, high = min(low, bottom), high if name == COULOMB else max(high, top)
        if name == COULOMB and found.is_narrow and VISCOUS not in found.fit.values:
            # At speeds that are alike a viscous part looks like Coulomb's, and so does a static force.
            viscous = found.fits.get("coulomb_viscous")
            is_told = viscous is not None and any(LAWS[each].is_falling for each in found.fits)
            low = min(low, viscous.interval(name)[1]) if viscous is not None and is_told else 0.0
        verdict = judged(max(high - value, value - low), value) if value > 0.0 else "at bound"
        if name in (COULOMB, STATIC) and found.is_one_way and not found.is_zero_given:
            verdict = max(verdict, "weak", key=VERDICTS.index)  # a zero of the force counts as friction
        lever = radius if name == SEAL else 1.0  # seals rub where the air pushes
        sizes = value / lever, found.coordinate.unit(name), error / lever, low / lever, high / lever
        estimates[name] = Estimate(*sizes, verdict)
    bristles = found.bristles
    if bristles is not None and bristles.is_seen:
        size = bristles.stiffness, found.coordinate.unit(BRISTLES), bristles.error, bristles.low, bristles.high
        # Known to a factor.
        estimates[BRISTLES] = Estimate(*size, judged((bristles.high / bristles.low) ** 0.5 - 1.0, 1.0))
    if bristles is not None and bristles.is_damped:
        about = bristles.damping, found.coordinate.unit(DAMPING), bristles.damping_error
        ends = bristles.damping_low, bristles.damping_high
        verdict = judged(0.5 * (ends[1] - ends[0]), bristles.damping)
        estimates[DAMPING] = Estimate(*about, *ends, verdict)
    return estimates


def _residuals(found: FrictionFits) -> dict[str, ResidualSummary]:
    rows, model = found.data.rows, found.fit.solution
    modelled, result = model.friction(rows) + model.zero(rows), {}
    for k, record in enumerate(found.records):
        own = rows.record == k
        result[f"{record.name}.friction"] = ResidualSummary.of(
            modelled[own], rows.friction[own], found.coordinate.effort_unit
        )
    return result


def _comparison(found: FrictionFits, estimates: Mapping[str, Estimate]) -> dict[str, Any]:
    bristles = found.bristles
    is_seen = bristles is not None and bristles.is_seen
    laws = [
        {
            "law": name,
            "held_out": fit.held_out_rms,
            "rms": float(np.sqrt(np.mean(fit.errors**2))),
            "numbers": len(fit.values),
            "alike": name in found.alike,
        }
        for name, fit in sorted(found.fits.items(), key=lambda each: each[1].held_out_rms)
    ]
    told: dict[str, Any] = {"law": LUGRE if is_seen else found.chosen, "levels": found.chosen}
    told |= {"body": found.coordinate.body, "supported": found.supported, "held_out_by": found.data.axis, "laws": laws}
    if bristles is not None:
        told["bristles"] = dict(vars(bristles)) | {"is_seen": bristles.is_seen, "is_damped": bristles.is_damped}
    return told | {"recordings": levels_of(found), "ready": circuit_lines(estimates)}


def circuit_lines(estimates: Mapping[str, Estimate]) -> str:
    """The numbers as fields of a body and a cylinder in a circuit file."""
    told, lines = [], []
    for address, found in estimates.items():
        *owner, name = address.split(".")
        if name == SEAL:
            lines.append(f'{name} = "{1e5 * found.value:.4g} N/bar"')
        elif "friction" in owner:
            told.append(f'{name} = "{found.value:.4g} {found.unit}"')
    return "\n".join([f'friction = {{ kind = "lugre", {", ".join(told)} }}', *lines])


def _conditions(found: FrictionFits, inertia: float) -> dict[str, Any]:
    rows, timed = found.data.rows, [motion for motion in found.motions if motion.windows]
    speed = np.abs(rows.velocity)
    told: dict[str, Any] = {
        "recordings": [record.name for record in found.records],
        "samples": sum(len(record) for record in found.records),
        "rows": len(rows),
        "groups": int(found.data.groups.size),
        "speed": [float(speed.min()), float(speed.max())],
    }
    if rows.pressure.any():
        told["pressure_difference"] = [float(rows.pressure.min()), float(rows.pressure.max())]
    if timed:
        told |= {
            "smoothing": _range([each for motion in timed for each in motion.windows]),
            "bandwidth": _range([HALF_POWER / each for motion in timed for each in motion.windows]),
            "velocity_noise": _range([each for motion in timed for each in motion.velocity_noise]),
            "reversals": found.reversals,
            "bending_distance": found.distance,
        }
    return told | ({found.coordinate.inertia: inertia} if inertia else {})


def _range(values: Sequence[float]) -> list[float]:
    return [min(values), max(values)]

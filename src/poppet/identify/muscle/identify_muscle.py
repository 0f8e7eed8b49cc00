"""Method `identify muscle`, which selects a force law by validation errors."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.codes import Note, notes_of
from poppet.core.errors import InputError, NameSuggestion
from poppet.identify.data_file import or_file
from poppet.identify.gum import correlations, coverage_factor
from poppet.identify.muscle.muscle_file import MusclePoints, levels, read_muscle_file
from poppet.identify.muscle.muscle_fit import CANDIDATES, HYSTERESIS, ForceLawFit, error_at, fit_force_law, rms
from poppet.identify.result import Estimate, ResidualSummary, Result, verdict_on_interval

ALIKE = 1.2
"""Ratio of validation errors below which two laws are not distinguishable."""
CURVES = 6
"""Maximum number of curves in the report."""
ATMOSPHERE = 1e5
"""Error of gauge pressures that were read as absolute [Pa]."""
BETTER = 2.0
"""Ratio of rms errors above which shifted pressures are reported."""
CLIPPED = 3
"""Number of points with exactly the maximum force that suggests a saturated sensor."""
USUAL_FORCE = 0.1, 100.0
"""Plausible ratio of the maximum force to the maximum pressure times the inner section."""
LEAST_CONTRACTION = 0.01
"""Maximum contraction below which the unit of the contractions is probably wrong."""
PROPORTIONAL = ("chou_hannaford", "tondu_lopez")


@or_file(read_muscle_file)
def identify_muscle(
    points: MusclePoints | str | Path,
    *,
    law: str = "best",
    part: str = "",
    title: str = "muscle",
    notes: Sequence[Note] = (),
) -> Result:
    """Identify the force law of a pneumatic muscle from a force map or recordings.

    Parameters
    ----------
    points : MusclePoints, str or Path
        Points, or a file for `read_muscle_file`.
    law : str, optional
        `best` (default) or the name of a law, `sarosi`, `table`, `tondu_lopez`, `chou_hannaford`.
    part : str, optional
        Name of the muscle in a circuit; the addresses of the estimates begin with it.
    title : str, optional
        Title of the result.
    notes : sequence of Note, optional
        Notes on the points.

    Returns
    -------
    Result
        Parameters of the law with intervals; `comparison["forces"]` has all laws.

    Raises
    ------
    InputError
        Unknown law, or too few points for any law.

    Notes
    -----
    The fit uses taut points only: the force of a slack muscle is zero, whatever the law gives.

    Each group of points (recording or level of pressure) is withheld once; on a map, the inner levels of contraction
    are also withheld. The rms of all validation errors ranks the laws. The intervals follow from a
    jackknife over the recordings or levels of pressure, with Student's t.

    References
    ----------
    Efron & Tibshirani 1993, An introduction to the bootstrap, section 11.5: the jackknife over groups.

    Examples
    --------
    >>> import numpy as np
    >>> from poppet.laws.physics.muscle import TonduLopez
    >>> pressure, contraction = (each.ravel() for each in np.meshgrid([1e5, 2e5, 3e5, 4e5], [0.0, 0.06, 0.12, 0.18]))
    >>> force = TonduLopez(0.02, 0.4, 1.3).force(pressure, contraction)
    >>> result = identify_muscle(MusclePoints(pressure, contraction, force, 0.3, 0.02), law="tondu_lopez")
    >>> {name: round(found.value, 6) for name, found in result.parameters.items()}
    {'braid_angle': 0.4, 'end_factor': 1.3}
    """
    assert isinstance(points, MusclePoints)  # `or_file` has read a file
    if law not in ("best", *CANDIDATES):
        near = NameSuggestion(law, ["best", *CANDIDATES])
        raise InputError("fields.not_an_option", "law", value=law, meaning="law", suggestion=near)
    fits = {name: fit for name in CANDIDATES if (fit := fit_force_law(points, name)) is not None}
    if law not in ("best", *fits) or not fits:
        raise InputError("force_map.too_few", "force", count=int(points.taut.sum()), least=len(points.groups[0]))
    ranked = sorted(fits, key=lambda name: fits[name].score)
    selected = ranked[0] if law == "best" else law
    fit, prefix = fits[selected], f"{part}." if part else ""
    doubts = (*_doubts(points, fit),)
    estimates = {f"{prefix}{name}": estimate for name, estimate in _estimates(fit, is_doubted=bool(doubts)).items()}
    taut = points.taut
    return Result(
        method="muscle",
        title=title,
        parameters=estimates,
        residuals={"points.force": ResidualSummary.of(fit.modelled[taut], points.force[taut], "N")},
        correlation=correlations([*estimates], fit.covariance),
        comparison={"law": selected, "held_out_by": [*fit.held_out], "forces": _table(fits, ranked, points)},
        remarks=(*doubts, *_findings(points, fits, ranked, selected), *notes_of(notes)),
        conditions=_conditions(points, fit),
        series=_report_curves(points, fit),
    )


def _doubts(points: MusclePoints, fit: ForceLawFit) -> Iterator[Note]:
    """Yield findings that cast doubt on all estimates of a muscle, for example wrong units."""
    taut = points.taut
    pressure, force = points.pressure[taut], points.force[taut]
    maximum = float(np.max(force))
    shifts = {"force_map.gauge_as_absolute": ATMOSPHERE, "force_map.absolute_as_gauge": -ATMOSPHERE}
    # A shift also improves a proportional law if there is a force without pressure.
    for code, shift in shifts.items() if fit.candidate.name not in PROPORTIONAL else ():
        factor = rms(fit.errors) / max(error_at(fit, shift), 1e-9 * maximum)
        if factor > BETTER:
            yield Note(code, "pressure", shift=shift, factor=factor)
    at_top = force == maximum
    if at_top.sum() >= CLIPPED and np.ptp(pressure[at_top]) > 0.0:
        yield Note("force_map.clipped", "force", value=maximum, count=int(at_top.sum()), total=len(points))
    ratio = maximum / max(0.25 * math.pi * points.nominal_diameter**2 * float(np.max(pressure)), 1e-300)
    if not USUAL_FORCE[0] <= ratio <= USUAL_FORCE[1]:
        yield Note("force_map.unusual", "force", value=maximum, ratio=ratio)
    if (largest := float(np.max(np.abs(points.contraction)))) < LEAST_CONTRACTION:
        yield Note("force_map.small", "contraction", percent=100.0 * largest)


def _estimates(fit: ForceLawFit, *, is_doubted: bool) -> dict[str, Estimate]:
    units = fit.candidate.units() | HYSTERESIS
    factor = coverage_factor(len(fit.without) - 1)
    estimates = {}
    for (name, value), error in zip(fit.values.items(), np.sqrt(np.diag(fit.covariance)), strict=True):
        half = factor * float(error)
        verdict = "at bound" if fit.is_at_bound(name) else verdict_on_interval(half, abs(value))
        if is_doubted and verdict == "determined":
            verdict = "weak"
        estimates[name] = Estimate(value, units[name], float(error), value - half, value + half, verdict)
    return estimates


def _table(fits: Mapping[str, ForceLawFit], ranked: Sequence[str], points: MusclePoints) -> list[dict[str, Any]]:
    largest = float(np.max(points.force))
    return [
        {
            "law": name,
            "held_out": fits[name].score,
            "held_out_of_largest": fits[name].score / largest,
            **{f"held_out_by_{axis}": rms(errors) for axis, errors in fits[name].held_out.items()},
            **{f"worst_by_{axis}": float(np.max(np.abs(errors))) for axis, errors in fits[name].held_out.items()},
            "rms": rms(fits[name].errors),
            "rms_of_largest": rms(fits[name].errors) / largest,
            "worst": float(np.max(np.abs(fits[name].errors))),
            "numbers": len(fits[name].values),
        }
        for name in ranked
    ]


def _findings(
    points: MusclePoints, fits: Mapping[str, ForceLawFit], ranked: Sequence[str], selected: str
) -> Iterator[Note]:
    """Yield findings on the comparison of the force laws, and on the measured points.

    `ranked` contains the names of the laws, the best first. `selected` is the name of the law that the result uses.
    """
    largest, best = float(np.max(points.force)), fits[ranked[0]]
    errors = {name: fits[name].score for name in ranked}
    facts = {"law": ranked[0], "error": best.score, "part": 100.0 * best.score / largest, "errors": errors}
    yield Note("force_map.ranked", **facts, axes=[*best.held_out])
    if selected != ranked[0]:
        yield Note("force_map.not_the_best", chosen=selected, law=ranked[0], factor=errors[selected] / best.score)
    elif len(ranked) > 1 and errors[ranked[1]] < ALIKE * best.score:
        yield Note("force_map.alike", law=ranked[0], other=ranked[1], factor=errors[ranked[1]] / best.score)
    # Reasons why laws have larger validation errors than the best law.
    inferior = [name for name in ranked[1:] if errors[name] > ALIKE * best.score]
    proportional = [name for name in inferior if name in PROPORTIONAL]
    if proportional and ranked[0] not in PROPORTIONAL:
        taut = points.taut
        passive = best.law.passive(points.contraction[taut])
        drive = np.abs(points.pressure[taut] * best.law.slope(points.contraction[taut]))
        ends = {"low": float(np.min(passive)), "high": float(np.max(passive))}
        yield Note("force_map.proportional", laws=proportional, **ends, part=100.0 * float(rms(passive) / rms(drive)))
    if "table" in inferior and "contraction" in fits["table"].held_out:
        error_by_axis = {axis: rms(errors) for axis, errors in fits["table"].held_out.items()}
        at_levels = error_by_axis.get("pressure", math.nan)
        yield Note("force_map.straight", between=error_by_axis["contraction"], at=at_levels)
    if "sarosi" in inferior:
        yield Note("force_map.other_shape", numbers=6, error=errors["sarosi"])
    left_out = [name for name in CANDIDATES if name not in fits]
    if left_out:
        yield Note("force_map.not_told", laws=left_out)
    slack = ~points.taut
    if slack.any():
        highest = float(np.max(fits[selected].modelled[slack]))
        facts = {"count": int(slack.sum()), "total": len(points), "below": points.slack_force, "above": highest}
        yield Note("force_map.slack", **facts)
    if points.time is not None and points.direction is None:
        yield Note("force_map.at_rest")


def _conditions(points: MusclePoints, fit: ForceLawFit) -> dict[str, Any]:
    taut = points.taut
    ranges = {
        key: [float(np.min(getattr(points, name)[taut])), float(np.max(getattr(points, name)[taut]))]
        for key, name in (("gauge_pressure", "pressure"), ("contraction", "contraction"), ("force", "force"))
    }
    rows = {"rows_of_contraction": fit.candidate.rows} if hasattr(fit.candidate, "rows") else {}
    return {
        "samples": len(points),
        "taut": int(taut.sum()),
        "groups": len(fit.without),
        **ranges,
        **rows,
        "nominal_length": points.nominal_length,
        "nominal_diameter": points.nominal_diameter,
    }


def _report_curves(points: MusclePoints, fit: ForceLawFit) -> dict[str, Any]:
    """Return the curves of the report: force versus contraction or pressure, with measured points.

    There is one curve for each of several levels, which are nearly constant pressures or contractions. If the points
    have no levels, the result contains all points.
    """
    axis, taut = points.groups[0], points.taut
    if axis not in ("pressure", "contraction"):
        order = np.argsort(points.contraction[taut], kind="stable")
        columns = (column[taut][order] for column in (points.contraction, points.force, fit.modelled))
        names = dict(zip(("x", "measured", "model"), columns, strict=True))
        return {"points.force": names | {"unit": "N", "x_unit": "1", "x_name": "contraction"}}
    x_axis = "contraction" if axis == "pressure" else "pressure"
    level = levels(getattr(points, axis))
    # A curve needs two points.
    selected = np.array([k for k in np.unique(level[taut]) if np.sum(level[taut] == k) > 1], dtype=int)
    if not selected.size:
        return {}
    selected = selected[np.unique(np.linspace(0, selected.size - 1, CURVES).round().astype(int))][::-1]
    span = getattr(points, x_axis)[taut]
    curves = {}
    for k in selected:
        is_curve = taut & (level == k)
        level_value = float(np.mean(getattr(points, axis)[is_curve]))
        x = np.linspace(float(span.min()), float(getattr(points, x_axis)[is_curve].max()), 80)
        law = fit.law.force(level_value, x) if axis == "pressure" else fit.law.force(x, level_value)
        label = f"{level_value / 1e5:.4g} bar g" if axis == "pressure" else f"contraction {level_value:.4g}"
        row = {"x": x, "y": law, "points_x": getattr(points, x_axis)[is_curve], "points_y": points.force[is_curve]}
        curves[f"{label}.force"] = row | {
            "unit": "N",
            "x_unit": "1" if x_axis == "contraction" else "Pa",
            "x_name": x_axis,
        }
    return curves

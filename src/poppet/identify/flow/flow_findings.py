"""Findings on a flow bench and its fit, the most important first."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.identify.flow.flow_fit import DOUBT, FlowFit, FlowModel, fit_flow
from poppet.identify.flow.points import FlowPoints
from poppet.identify.flow.standard_formulas import critical_ratio_uncertainty
from poppet.identify.gum import studentised
from poppet.identify.result import Estimate

USUAL_CONDUCTANCE = (1e-12, 1e-5)
"""Plausible sonic conductances, from a pinhole of 5 um to a valve of DN 200 [m^3/(s Pa)]."""

ATMOSPHERE = 101325.0
NEAR_VACUUM = 2e4  # downstream pressure below which a fit with gauge pressures is tried [Pa]
BELOW_ATMOSPHERE = 7e4  # downstream pressure of a vacuum bench, or a gauge pressure [Pa]
NEAR_ONE = 0.99
UNUSUAL_RATIO = 0.1
"""Critical ratio of a long narrow tube, or of gauge pressures that were read as absolute."""
ALIKE = 1.1
"""Ratio of residuals up to which two interpretations of the pressures (gauge, absolute) fit equally well."""
OUTLYING = 0.01
"""Probability of an outlier in a valid table below which the point is reported."""
EXACT = 0.01
"""Chi-square over its degrees of freedom below which the points are exact."""


def findings(
    fit: FlowFit,
    estimates: Mapping[str, Estimate],
    tests: Mapping[str, Any],
    influence: Mapping[str, list[float]],
    choked: bool,
) -> tuple[Note, ...]:
    """Return the findings that limit the use of the result, the most important first."""
    notes = [*(_choked_only(fit, estimates) if choked else _no_choked_point(fit, estimates))]
    notes += [*_bounds(estimates), *_misfit(fit, tests), *_near_one(fit)]
    needed = [(size, effect) for size, effect in fit.model.common_errors(fit.x) if abs(size) > 2.0]
    notes += [Note("flow.error_needed", size=size, source=effect.source) for size, effect in needed]
    notes += [*_outlier(fit), *_influential(fit, influence)]
    lowest = float(np.min(fit.model.points.pressure_2))
    if lowest < BELOW_ATMOSPHERE:
        notes.append(Note("flow.below_atmosphere", "pressure_2", lowest_kpa=lowest / 1e3))
    return tuple(notes)


def suspicions(
    fit: FlowFit, estimates: Mapping[str, Estimate], tests: Mapping[str, Any], alternative: tuple[str, FlowFit] | None
) -> tuple[Note, ...]:
    """Return the findings that cast doubt on all estimates: wrong units or an unsuitable flow law."""
    notes = [*_gauge(fit, estimates, tests)]
    if alternative:
        name, better = alternative
        names = {"sonic_conductance": "conductance", "critical_ratio": "ratio", name: "value"}
        facts = {fact: better.values[key] for key, fact in names.items()}
        notes.append(Note("flow.other_law", name, **facts, held=fit.values[name], gain=fit.aicc - better.aicc))
    value = estimates["sonic_conductance"].value
    if not USUAL_CONDUCTANCE[0] <= value <= USUAL_CONDUCTANCE[1]:
        notes.append(Note("flow.unusual_conductance", "sonic_conductance", value=value))
    too_large = tests["chi_square_probability"] < DOUBT
    # Without residuals that are too large, the runs test needs a lower probability.
    if tests["runs_probability"] < (DOUBT if too_large else 0.1 * DOUBT):
        free = [f'{name} = "free"' for name in ("subsonic_index", "cracking_pressure") if name in fit.model.fixed]
        code = "flow.pattern_free" if free else "flow.pattern"
        notes.append(Note(code, probability=tests["runs_probability"], free=free))
    return tuple(notes)


def most_informative_ratio(critical_ratio: float, u_pressure_ratio: float = 1e-3, u_flow_ratio: float = 5e-3) -> float:
    """Return the p2/p1 at which one more point reduces the uncertainty of b most.

    Examples
    --------
    >>> round(most_informative_ratio(0.3), 2)
    0.72
    """
    position = np.linspace(0.05, 0.995, 400)
    ratio = critical_ratio + (1.0 - critical_ratio) * position
    spread = critical_ratio_uncertainty(ratio, np.sqrt(1.0 - position**2), u_pressure_ratio, u_flow_ratio)
    return float(ratio[np.argmin(spread)])


def _choked_only(fit: FlowFit, estimates: Mapping[str, Estimate]) -> Iterator[Note]:
    ratio = fit.model.points.pressure_ratio
    low = estimates["critical_ratio"].low
    span = {"lowest": float(np.min(ratio)), "highest": float(np.max(ratio))}
    yield Note("flow.choked_only", "critical_ratio", **span, low=low, telling=most_informative_ratio(max(low, 0.2)))
    open_names = [name for name in estimates if name not in ("sonic_conductance", "critical_ratio")]
    if open_names:
        yield Note("flow.choked_says_nothing", open_names[0], names=open_names)
    conductance = estimates["sonic_conductance"]
    if conductance.verdict != "determined":
        yield Note("flow.perhaps_none_choked", "sonic_conductance", low=conductance.low, high=conductance.high)


def _no_choked_point(fit: FlowFit, estimates: Mapping[str, Estimate]) -> Iterator[Note]:
    lowest = float(np.min(fit.model.points.pressure_ratio))
    b = estimates["critical_ratio"]
    if lowest > b.value and b.verdict != "at bound":
        names = list(fit.model.free)
        row = fit.gain[0][[names.index("sonic_conductance"), names.index("critical_ratio")]]
        correlation = float(row[0] @ row[1] / max(np.linalg.norm(row[0]) * np.linalg.norm(row[1]), 1e-300))
        facts = {"lowest": lowest, "value": b.value, "low": b.low, "high": b.high, "correlation": correlation}
        yield Note("flow.none_choked", "critical_ratio", **facts, telling=0.7 * max(b.low, 0.1))
    if b.verdict in ("weak", "not determined"):
        telling = most_informative_ratio(min(max(b.value, 0.0), 0.9))
        yield Note("flow.ratio_open", "critical_ratio", verdict=b.verdict, low=b.low, high=b.high, telling=telling)


def _bounds(estimates: Mapping[str, Estimate]) -> Iterator[Note]:
    for name, estimate in estimates.items():
        if estimate.verdict == "at bound" and name == "cracking_pressure":
            yield Note("flow.no_cracking_pressure", name, high=estimate.high)
        elif estimate.verdict == "at bound":
            yield Note("flow.at_bound", name, value=estimate.value, low=estimate.low, high=estimate.high)


def _gauge(fit: FlowFit, estimates: Mapping[str, Estimate], tests: Mapping[str, Any]) -> Iterator[Note]:
    """Yield findings on pressures whose reference (gauge or absolute) was probably confused."""
    points = fit.model.points
    lowest = float(np.min(points.pressure_2))
    doubtful = tests["chi_square_probability"] < DOUBT or tests["runs_probability"] < DOUBT
    doubtful = doubtful or estimates["critical_ratio"].verdict == "at bound"
    for code, shift in (("flow.gauge_as_absolute", ATMOSPHERE), ("flow.absolute_as_gauge", -ATMOSPHERE)):
        if not doubtful and not (shift > 0.0 and lowest < NEAR_VACUUM):
            continue
        if (shifted_fit := _fit_shifted(fit, shift)) and (
            factor := _residual(fit) / max(_residual(shifted_fit), 1e-300)
        ) > 2.0:
            yield Note(code, shift_kpa=shift / 1e3, factor=factor)
            return
    # At one inlet pressure, gauge pressures follow exactly the law of absolute pressures with a lower b.
    if estimates["critical_ratio"].high < UNUSUAL_RATIO and (shifted_fit := _fit_shifted(fit, ATMOSPHERE)):
        conductance, ratio = shifted_fit.values["sonic_conductance"], shifted_fit.values["critical_ratio"]
        if _residual(shifted_fit) < ALIKE * _residual(fit) and ratio > UNUSUAL_RATIO:
            facts = {"value": fit.values["critical_ratio"], "shift_kpa": ATMOSPHERE / 1e3}
            yield Note("flow.gauge_twin", "critical_ratio", **facts, conductance=conductance, ratio=ratio)


def _residual(fit: FlowFit) -> float:
    return float(np.linalg.norm(fit.modelled - fit.model.points.mass_flow_rate))


def _fit_shifted(fit: FlowFit, shift: float) -> FlowFit | None:
    """Return the fit to pressures that are shifted by `shift`.

    The result is None if the shifted pressures are invalid.
    """
    points = fit.model.points
    if min(float(np.min(points.pressure_1)), float(np.min(points.pressure_2))) + shift < 0.0:
        return None
    try:
        shifted_points: FlowPoints = replace(
            points, pressure_1=points.pressure_1 + shift, pressure_2=points.pressure_2 + shift
        )
    except InputError:
        return None
    return fit_flow(FlowModel(shifted_points, fit.model.fixed))


def _misfit(fit: FlowFit, tests: Mapping[str, Any]) -> Iterator[Note]:
    probability = tests["chi_square_probability"]
    if math.isnan(probability):
        yield Note("flow.scatter_estimated")
    elif probability < DOUBT:
        yield Note("flow.residuals_too_large", factor=fit.inflation, probability=probability)
    elif probability > 1.0 - 0.1 * DOUBT:
        yield Note("flow.residuals_too_small", probability=probability)
    if not fit.model.effects:
        yield Note("flow.scatter_only")


def _near_one(fit: FlowFit) -> Iterator[Note]:
    points = fit.model.points
    drop = points.pressure_1 - points.pressure_2
    u_drop = np.zeros(len(points))
    for name in ("pressure_1", "pressure_2"):
        stated, reading = points.instrument(name), getattr(points, name)
        for part in (stated.absolute, stated.offset, stated.relative * reading, stated.calibration * reading):
            u_drop = np.hypot(u_drop, part)
    is_near = (drop < 5.0 * u_drop) if u_drop.any() else (points.pressure_ratio > NEAR_ONE)
    if is_near.any():
        code = "flow.near_one_uncertain" if u_drop.any() else "flow.near_one"
        yield Note(code, **_point_facts(np.flatnonzero(is_near), points))


def _outlier(fit: FlowFit) -> Iterator[Note]:
    """Yield a finding on the point with the largest residual if it is an outlier.

    A point is an outlier if the scatter of the other points does not explain its residual.
    """
    from scipy.special import stdtr

    points, freedom = fit.model.points, fit.degrees_of_freedom
    # The residuals of exact data are rounding errors.
    if freedom < 2 or fit.chi_square < EXACT * freedom:
        return
    scores = np.abs(studentised(fit.jacobian, fit.residuals, fit.gain[0], freedom)[: len(points)])
    if not np.isfinite(scores).any():
        return
    k = int(np.nanargmax(scores))
    # Bonferroni correction for the largest of all residuals.
    probability = min(1.0, len(points) * 2.0 * float(stdtr(freedom - 1, -scores[k])))
    if probability < OUTLYING:
        off = float(points.mass_flow_rate[k] - fit.modelled[k])
        size = 100.0 * off / float(fit.modelled[k]) if fit.modelled[k] > 0.0 else float("inf")
        location = {"row": k + 1, "line": int(points.lines[k]) if len(points.lines) else None}
        facts = {"ratio": float(points.pressure_ratio[k]), "percent": size, "off": off, "errors": float(scores[k])}
        yield Note("flow.outlier", "mass_flow_rate", **location, **facts, probability=probability)


def _influential(fit: FlowFit, influence: Mapping[str, list[float]]) -> Iterator[Note]:
    for name, shifts in influence.items():
        sizes = np.abs(np.nan_to_num(np.array(shifts), nan=math.inf))
        k = int(np.argmax(sizes))
        if sizes[k] <= 1.0:
            continue
        location = _point_facts(np.array([k]), fit.model.points)
        if math.isinf(sizes[k]):
            yield Note("flow.only_one_point", name, **location)
        else:
            yield Note("flow.one_point", name, **location, errors=float(sizes[k]))


def _point_facts(indices: Any, points: FlowPoints) -> dict[str, Any]:
    """Return the first of the given points with their p2/p1, and the number of further points."""
    texts = [f"{k} at {points.pressure_ratio[k]:.4g}" for k in indices[:4]]
    return {"points": texts, "more": max(len(indices) - 4, 0) or None}

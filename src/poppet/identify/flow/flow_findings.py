"""Findings on a flow bench and its fit, the most important first."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.identify.flow.flow_fit import BETTER, DOUBT, FlowFit, FlowModel, fit_flow
from poppet.identify.flow.points import CHANNELS, FlowPoints
from poppet.identify.flow.standard_formulas import critical_ratio_uncertainty
from poppet.identify.gum import leave_one_out, studentised
from poppet.identify.result import Estimate
from poppet.timeseries.checks import FloatArray

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
USUAL_TEMPERATURES = (278.15, 318.15)
"""Usual mean temperatures of a flow bench, 5 to 45 degC; 20 degC read as 20 degF is outside [K]."""
REFERENCES = {"sonic_conductance": ("mass_flow_rate", "pressure_1"), "critical_ratio": ("pressure_1", "pressure_2")}
"""Instruments whose common errors shift a parameter; other parameters depend on those of b."""
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
    alternative: tuple[str, FlowFit] | None = None,
) -> Iterator[Note]:
    """Yield findings that limit the use of the result, the most important first.

    `tests` contains the statistical tests, and `influence` the influence of each point. `choked` is True if all points
    may be choked. `alternative` is the name of a parameter and a fit of the law with this parameter free, if that law
    is better. Outliers are then residuals of the better law.
    """
    points = fit.model.points
    yield from _choking_notes(fit, estimates, choked)
    for name, estimate in estimates.items():
        if estimate.verdict == "at bound" and name == "cracking_pressure":
            yield Note("flow.no_cracking_pressure", name, high=estimate.high)
        elif estimate.verdict == "at bound":
            yield Note("flow.at_bound", name, value=estimate.value, low=estimate.low, high=estimate.high)
    probability = tests["chi_square_probability"]
    if math.isnan(probability):
        yield Note("flow.scatter_estimated")
    elif probability < DOUBT:
        yield Note("flow.residuals_too_large", factor=fit.inflation, probability=probability)
    elif probability > 1.0 - 0.1 * DOUBT:
        yield Note("flow.residuals_too_small", probability=probability)
    channels, names = uncalibrated(points, estimates)
    if names:
        yield Note("flow.scatter_only", channels=channels, names=names)
    u_drop = np.zeros(len(points))
    for name in ("pressure_1", "pressure_2"):
        stated, reading = points.instrument(name), getattr(points, name)
        for part in (stated.absolute, stated.offset, stated.relative * reading, stated.calibration * reading):
            u_drop = np.hypot(u_drop, part)
    is_stated = bool(u_drop.any())
    drop = points.pressure_1 - points.pressure_2
    is_near = (drop < 5.0 * u_drop) if is_stated else (points.pressure_ratio > NEAR_ONE)
    if is_near.any():
        code = "flow.near_one_uncertain" if is_stated else "flow.near_one"
        yield Note(code, **_point_facts(np.flatnonzero(is_near), points))
    for size, effect in fit.model.common_errors(fit.x):
        if abs(size) > 2.0:
            yield Note("flow.error_needed", size=size, source=effect.source)
    tested, influence_on_tested = fit, influence
    if alternative is not None:
        # Test single points with the better law, unless an error of one point explains the residuals better. Both
        # explanations have one more free parameter than the law.
        better, left = alternative[1], 1.0 - np.einsum("ij,ji->i", fit.jacobian, fit.gain[0])
        squares = fit.residuals**2 / np.where(left > 1e-9, left, np.inf)
        if not fit.chi_square - float(np.max(squares[: len(points)])) < _chi_square(better, fit.sigma):
            tested, influence_on_tested = better, influence_of(better)
    yield from _point_notes(tested, influence_on_tested)
    lowest = float(np.min(points.pressure_2))
    is_suspicious = lowest < BELOW_ATMOSPHERE and not points.is_absolute
    shifted_fit = _fit_shifted(fit, ATMOSPHERE) if is_suspicious else None
    if shifted_fit is not None:
        # A clearly worse fit excludes that gauge pressures were read as absolute.
        worse = _chi_square(shifted_fit, fit.sigma) / max(fit.chi_square, 1e-300)
        gain = fit.chi_square * (worse - 1.0) if fit.scatter_is_known else len(points) * math.log(worse)
        if not gain > 2.0 * BETTER:
            yield Note("flow.below_atmosphere", "pressure_2", lowest_kpa=lowest / 1e3)
    temperature = points.temperature_1
    if not USUAL_TEMPERATURES[0] <= float(np.mean(temperature)) <= USUAL_TEMPERATURES[1]:
        facts = {"low": float(np.min(temperature)), "high": float(np.max(temperature))}
        yield Note("flow.unusual_temperature", "temperature_1", **facts, celsius=float(np.mean(temperature)) - 273.15)


def uncalibrated(points: FlowPoints, names: Iterable[str]) -> tuple[list[str], list[str]]:
    """Return the channels without a stated calibration error or offset, and the parameters that such errors change."""
    missing = {channel for channel in CHANNELS if not points.instrument(channel).is_calibrated}
    if points.u_ambient_pressure:
        missing -= {"pressure_1", "pressure_2"}
    by_name = {name: missing & set(REFERENCES.get(name, REFERENCES["critical_ratio"])) for name in names}
    affected = [name for name, channels in by_name.items() if channels]
    return [channel for channel in CHANNELS if any(channel in by_name[name] for name in affected)], affected


def limit_verdicts(estimates: Mapping[str, Estimate], remarks: Iterable[Note]) -> dict[str, Estimate]:
    """Return estimates whose verdict `determined` is reduced to `weak` if a finding requires it."""
    limited: set[str] = set()
    for note in remarks:
        limited |= set(note.facts["names"] if note.code == "flow.scatter_only" else ())
        limited |= set(estimates if note.code in LIMITING else ())
    return {
        name: replace(e, verdict="weak") if name in limited and e.verdict == "determined" else e
        for name, e in estimates.items()
    }


LIMITING = ("flow.residuals_too_large", "flow.below_atmosphere", "flow.unusual_temperature")
"""Findings with which no parameter is determined: the errors are not those that the intervals assume."""


def suspicions(
    fit: FlowFit, estimates: Mapping[str, Estimate], tests: Mapping[str, Any], alternative: tuple[str, FlowFit] | None
) -> Iterator[Note]:
    """Yield findings that cast doubt on all estimates of a flow bench.

    They concern wrong units, or an unsuitable flow law.
    """
    too_large, runs = tests["chi_square_probability"] < DOUBT, tests["runs_probability"]
    ratio = estimates["critical_ratio"]
    is_doubtful = too_large or runs < DOUBT or ratio.verdict == "at bound"
    is_vacuum = float(np.min(fit.model.points.pressure_2)) < NEAR_VACUUM
    # A wrong reference of the pressures, gauge or absolute.
    shifts = {"flow.gauge_as_absolute": ATMOSPHERE, "flow.absolute_as_gauge": -ATMOSPHERE}
    for code, shift in shifts.items():
        shifted_fit = _fit_shifted(fit, shift) if is_doubtful or (shift > 0.0 and is_vacuum) else None
        if shifted_fit and (factor := fit.misfit / max(shifted_fit.misfit, 1e-300)) > 2.0:
            yield Note(code, shift_kpa=shift / 1e3, factor=factor)
            break
    else:
        # At one inlet pressure, gauge pressures follow exactly the law of absolute pressures with a lower b.
        shifted_fit = _fit_shifted(fit, ATMOSPHERE) if ratio.high < UNUSUAL_RATIO else None
        if shifted_fit and shifted_fit.misfit < ALIKE * fit.misfit:
            values = shifted_fit.values
            facts = {"conductance": values["sonic_conductance"], "ratio": values["critical_ratio"]}
            if facts["ratio"] > UNUSUAL_RATIO:
                facts |= {"value": fit.values["critical_ratio"], "shift_kpa": ATMOSPHERE / 1e3}
                yield Note("flow.gauge_twin", "critical_ratio", **facts)
    if alternative:
        name, better = alternative
        names = {"sonic_conductance": "conductance", "critical_ratio": "ratio", name: "value"}
        facts = {fact: better.values[key] for key, fact in names.items()}
        yield Note("flow.other_law", name, **facts, held=fit.values[name], gain=fit.aicc - better.aicc)
    value = estimates["sonic_conductance"].value
    if not USUAL_CONDUCTANCE[0] <= value <= USUAL_CONDUCTANCE[1]:
        yield Note("flow.unusual_conductance", "sonic_conductance", value=value)
    # Without residuals that are too large, the runs test needs a lower probability.
    if runs < (DOUBT if too_large else 0.1 * DOUBT):
        free = [f'{name} = "free"' for name in ("subsonic_index", "cracking_pressure") if name in fit.model.fixed]
        yield Note("flow.pattern_free" if free else "flow.pattern", probability=runs, free=free)


def most_informative_ratio(critical_ratio: float, u_pressure_ratio: float = 1e-3, u_flow_ratio: float = 5e-3) -> float:
    """Return the p2/p1 at which one more point reduces the uncertainty of b most.

    The last two arguments are the standard uncertainties of p2/p1, and of the flow divided by the choked flow.

    Examples
    --------
    >>> round(most_informative_ratio(0.3), 2)
    0.72
    """
    position = np.linspace(0.05, 0.995, 400)
    ratio = critical_ratio + (1.0 - critical_ratio) * position
    spread = critical_ratio_uncertainty(ratio, np.sqrt(1.0 - position**2), u_pressure_ratio, u_flow_ratio)
    return float(ratio[np.argmin(spread)])


def _choking_notes(fit: FlowFit, estimates: Mapping[str, Estimate], choked: bool) -> Iterator[Note]:
    """Yield findings on a flow that is choked at all points, or at no point."""
    ratio, b, conductance = fit.model.points.pressure_ratio, estimates["critical_ratio"], estimates["sonic_conductance"]
    lowest = float(np.min(ratio))
    if choked:
        facts = {"lowest": lowest, "highest": float(np.max(ratio)), "low": b.low}
        yield Note("flow.choked_only", "critical_ratio", **facts, telling=most_informative_ratio(max(b.low, 0.2)))
        if open_names := [name for name in estimates if name not in ("sonic_conductance", "critical_ratio")]:
            yield Note("flow.choked_says_nothing", open_names[0], names=open_names)
        if conductance.verdict != "determined":
            yield Note("flow.perhaps_none_choked", "sonic_conductance", low=conductance.low, high=conductance.high)
        return
    if lowest > b.value and b.verdict != "at bound":
        first, second = (fit.gain[0][fit.model.free.index(name)] for name in ("sonic_conductance", "critical_ratio"))
        correlation = float(first @ second / max(np.linalg.norm(first) * np.linalg.norm(second), 1e-300))
        facts = {"lowest": lowest, "value": b.value, "low": b.low, "high": b.high, "correlation": correlation}
        yield Note("flow.none_choked", "critical_ratio", **facts, telling=0.7 * max(b.low, 0.1))
    if b.verdict in ("weak", "not determined"):
        telling = most_informative_ratio(min(max(b.value, 0.0), 0.9))
        yield Note("flow.ratio_open", "critical_ratio", verdict=b.verdict, low=b.low, high=b.high, telling=telling)


def _fit_shifted(fit: FlowFit, shift: float) -> FlowFit | None:
    """Return a fit to the same points with all pressures increased by `shift` [Pa].

    The result is None if the shifted pressures are invalid, or if the readings are certainly absolute.
    """
    points = fit.model.points
    if min(float(np.min(points.pressure_1)), float(np.min(points.pressure_2))) + shift < 0.0:
        return None
    if points.is_absolute:
        return None
    try:
        shifted_points: FlowPoints = replace(
            points, pressure_1=points.pressure_1 + shift, pressure_2=points.pressure_2 + shift
        )
    except InputError:
        return None
    return fit_flow(FlowModel(shifted_points, fit.model.fixed))


def _chi_square(fit: FlowFit, sigma: FloatArray) -> float:
    """Return chi-square of a fit if the points have the standard deviations `sigma` [kg/s]."""
    residuals = fit.model.residuals(fit.x, sigma)
    return float(residuals @ residuals)


def influence_of(fit: FlowFit) -> dict[str, list[float]]:
    """Return the change of each parameter if one point is omitted, in standard errors.

    The result maps the name of each parameter to a list with one change for each point.
    """
    shifts = leave_one_out(fit.jacobian, fit.residuals, fit.gain[0])[:, : len(fit.model.points)]
    shifts /= np.maximum(np.linalg.norm(fit.gain[0], axis=1), 1e-300)[:, None]
    # Common errors follow the free parameters and are omitted here.
    return {name: row.tolist() for name, row in zip(fit.model.free, shifts, strict=False)}


def _point_notes(fit: FlowFit, influence: Mapping[str, list[float]]) -> Iterator[Note]:
    """Yield findings on an outlier, and on parameters that depend on one single point."""
    from scipy.special import stdtr

    points, freedom = fit.model.points, fit.degrees_of_freedom
    # The residuals of exact data are rounding errors.
    if freedom >= 2 and fit.chi_square >= EXACT * freedom:
        scores = np.abs(studentised(fit.jacobian, fit.residuals, fit.gain[0], freedom)[: len(points)])
        k = int(np.argmax(np.nan_to_num(scores)))
        # An outlier is a residual that the scatter of the other points does not explain. Bonferroni correction for the
        # largest of all residuals.
        probability = min(1.0, len(points) * 2.0 * float(stdtr(freedom - 1, -scores[k])))
        if probability < OUTLYING:
            modelled, off = float(fit.modelled[k]), float(points.mass_flow_rate[k] - fit.modelled[k])
            facts = {
                "row": k + 1,
                "line": int(points.lines[k]) if len(points.lines) else None,
                "ratio": float(points.pressure_ratio[k]),
                "percent": 100.0 * off / modelled if modelled > 0.0 else math.inf,
                "off": off,
                "errors": float(scores[k]),
            }
            yield Note("flow.outlier", "mass_flow_rate", **facts, probability=probability)
    for name, shifts in influence.items():
        sizes = np.abs(np.nan_to_num(np.array(shifts), nan=math.inf))
        k = int(np.argmax(sizes))
        location = _point_facts(np.array([k]), points)
        if math.isinf(sizes[k]):
            yield Note("flow.only_one_point", name, **location)
        elif sizes[k] > 1.0:
            yield Note("flow.one_point", name, **location, errors=float(sizes[k]))


def _point_facts(indices: Any, points: FlowPoints) -> dict[str, Any]:
    """Return the facts of a message that lists some points of a flow bench.

    The facts contain the numbers of the first points (counted from 1) with their p2/p1, and the number of further
    points.
    """
    texts = [f"point {k + 1} (p2/p1 = {points.pressure_ratio[k]:.4g})" for k in indices[:4]]
    return {"points": texts, "more": max(len(indices) - 4, 0) or None}

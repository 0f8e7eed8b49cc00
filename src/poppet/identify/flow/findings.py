"""What a reader of a flow bench's result has to know, in sentences, the most important first."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.ground.errors import InputError
from poppet.identify.flow.fit import DOUBT, FlowFit, FlowModel, fit_flow
from poppet.identify.flow.points import FlowPoints
from poppet.identify.flow.standard_formulas import critical_ratio_uncertainty
from poppet.identify.result import Estimate

USUAL_CONDUCTANCE = (1e-12, 1e-5)
"""From a pinhole of 5 um to a valve of DN 200; outside, a unit is suspected [m^3/(s Pa)]."""

ATMOSPHERE = 101325.0
NEAR_VACUUM = 2e4  # a downstream pressure below this is worth a second fit with gauge pressures [Pa]
BELOW_ATMOSPHERE = 7e4  # a downstream pressure below this is a vacuum bench, or gauge [Pa]
NEAR_ONE = 0.99


def findings(
    fit: FlowFit,
    estimates: Mapping[str, Estimate],
    tests: Mapping[str, Any],
    influence: Mapping[str, list[float]],
    choked: bool,
) -> tuple[str, ...]:
    """Everything that limits the result."""
    sentences = [
        *(_choked_only(fit, estimates) if choked else _no_choked_point(fit, estimates)),
        *_bounds(estimates),
        *_misfit(fit, tests),
        *_near_one(fit),
        *_common(fit),
        *_influential(fit, influence),
        *_below_atmosphere(fit),
    ]
    return tuple(sentences)


def suspicions(fit: FlowFit, estimates: Mapping[str, Estimate], tests: Mapping[str, Any]) -> tuple[str, ...]:
    """What makes every number doubtful, however narrow its interval: wrong units, a law that does not fit."""
    return (*_gauge(fit, estimates, tests), *_unit(estimates), *_shape(fit, tests))


def most_telling_ratio(critical_ratio: float, u_pressure_ratio: float = 1e-3, u_flow_ratio: float = 5e-3) -> float:
    """The p2/p1 at which one more point tells most about b.

    Examples
    --------
    >>> round(most_telling_ratio(0.3), 2)
    0.72
    """
    position = np.linspace(0.05, 0.995, 400)
    ratio = critical_ratio + (1.0 - critical_ratio) * position
    spread = critical_ratio_uncertainty(ratio, np.sqrt(1.0 - position**2), u_pressure_ratio, u_flow_ratio)
    return float(ratio[np.argmin(spread)])


def _choked_only(fit: FlowFit, estimates: Mapping[str, Estimate]) -> Iterator[str]:
    ratio = fit.model.points.pressure_ratio
    low = estimates["critical_ratio"].low
    yield (
        f"The critical ratio is not determined: all points, p2/p1 = {np.min(ratio):.3g} ... {np.max(ratio):.3g}, "
        f"may be choked, so the data only say b >= {low:.2g}. "
        f"A point at p2/p1 = {most_telling_ratio(max(low, 0.2)):.2f} or so would resolve it."
    )
    others = [name for name in estimates if name not in ("sonic_conductance", "critical_ratio")]
    if others:
        yield f"Choked points say nothing about {' and '.join(others)} either."
    conductance = estimates["sonic_conductance"]
    if conductance.verdict != "determined":
        yield (
            f"Nor is it certain that any point is choked, so C may lie anywhere in {conductance.low:.4g} ... "
            f"{conductance.high:.4g} m^3/(s Pa). A point at p2/p1 of 0.1 would tell."
        )


def _no_choked_point(fit: FlowFit, estimates: Mapping[str, Estimate]) -> Iterator[str]:
    lowest = float(np.min(fit.model.points.pressure_ratio))
    b = estimates["critical_ratio"]
    if lowest > b.value and b.verdict != "at bound":
        names = list(fit.model.free)
        row = fit.gain[0][[names.index("sonic_conductance"), names.index("critical_ratio")]]
        correlation = float(row[0] @ row[1] / max(np.linalg.norm(row[0]) * np.linalg.norm(row[1]), 1e-300))
        yield (
            f"No point is choked: the lowest p2/p1 is {lowest:.3g}, b = {b.value:.3g}. C and b are extrapolated and "
            f"correlated ({correlation:+.3f}): a larger C with a smaller b fits almost as well. A point at "
            f"p2/p1 of {0.7 * max(b.low, 0.1):.2f} or less would part them."
        )
    if b.verdict in ("weak", "not determined"):
        yield (
            f"The critical ratio is {b.verdict}: {b.low:.2f} ... {b.high:.2f} is possible. A point at p2/p1 = "
            f"{most_telling_ratio(min(max(b.value, 0.0), 0.9)):.2f} or so tells most about it."
        )


def _bounds(estimates: Mapping[str, Estimate]) -> Iterator[str]:
    for name, estimate in estimates.items():
        if estimate.verdict == "at bound" and name == "cracking_pressure":
            yield f"The points show no cracking pressure; it is below {estimate.high:.3g} Pa."
        elif estimate.verdict == "at bound":
            yield (
                f"{name} = {estimate.value:.4g} lies at its bound ({estimate.low:.3g} ... {estimate.high:.3g} is "
                "possible): the law cannot follow these points any further. "
                "Check the pressures (gauge or absolute, transducers swapped, tapping points) and the leak tightness."
            )


def _gauge(fit: FlowFit, estimates: Mapping[str, Estimate], tests: Mapping[str, Any]) -> Iterator[str]:
    """Evidence that gauge pressures were read as absolute ones, or the other way round."""
    points = fit.model.points
    lowest = float(np.min(points.pressure_2))
    doubtful = tests["chi_square_probability"] < DOUBT or tests["runs_probability"] < DOUBT
    doubtful = doubtful or estimates["critical_ratio"].verdict == "at bound"
    shifts = {"gauge pressures read as absolute": ATMOSPHERE, "absolute pressures read as gauge": -ATMOSPHERE}
    for meaning, shift in shifts.items():
        if not doubtful and not (shift > 0.0 and lowest < NEAR_VACUUM):
            continue
        factor = _better_by(fit, shift)
        if factor > 2.0:
            yield (
                f"The pressures look like {meaning}: with {shift / 1e3:+.1f} kPa the residuals are {factor:.1f} times "
                "smaller. Check the units of both columns."
            )
            return


def _below_atmosphere(fit: FlowFit) -> Iterator[str]:
    lowest = float(np.min(fit.model.points.pressure_2))
    if lowest < BELOW_ATMOSPHERE:
        yield (
            f"pressure_2 goes down to {lowest / 1e3:.3g} kPa absolute. Unless the bench exhausts into a vacuum these "
            "are gauge pressures, and then C is too high and b too low."
        )


def _better_by(fit: FlowFit, shift: float) -> float:
    """How many times smaller the residuals are with all pressures moved; 0 where that cannot be."""
    points = fit.model.points
    if min(float(np.min(points.pressure_1)), float(np.min(points.pressure_2))) + shift < 0.0:
        return 0.0
    try:
        moved: FlowPoints = replace(points, pressure_1=points.pressure_1 + shift, pressure_2=points.pressure_2 + shift)
    except InputError:
        return 0.0
    other = fit_flow(FlowModel(moved, fit.model.fixed))
    first, second = (float(np.linalg.norm(f.modelled - points.mass_flow_rate)) for f in (fit, other))
    return first / second if second > 0.0 else math.inf


def _misfit(fit: FlowFit, tests: Mapping[str, Any]) -> Iterator[str]:
    probability = tests["chi_square_probability"]
    if math.isnan(probability):
        yield (
            "No scatter of the flow meter was stated: it was estimated from the residuals, so chi-square cannot judge "
            "the fit."
        )
    elif probability < DOUBT:
        yield (
            f"The residuals are {fit.inflation:.2g} times larger than the stated scatter allows (chi-square, "
            f"probability {probability:.1g}): the intervals were widened accordingly. "
            "Either the instruments are worse than stated or the law does not hold."
        )
    elif probability > 1.0 - 0.1 * DOUBT:
        yield "The residuals are much smaller than the stated scatter (chi-square): it looks overestimated."
    if not fit.model.effects:
        yield "No calibration or zero error of the instruments was stated: the intervals contain scatter only."


def _shape(fit: FlowFit, tests: Mapping[str, Any]) -> Iterator[str]:
    too_large = tests["chi_square_probability"] < DOUBT
    if tests["runs_probability"] < (DOUBT if too_large else 0.1 * DOUBT):
        free = [f'{name} = "free"' for name in ("subsonic_index", "cracking_pressure") if name in fit.model.fixed]
        yield (
            "The residuals follow a pattern over p2/p1 (runs test, probability "
            f"{tests['runs_probability']:.1g}): the shape of the law does not fit, and the intervals are too narrow."
            + (f" Try {' or '.join(free)}." if free else "")
        )


def _near_one(fit: FlowFit) -> Iterator[str]:
    points = fit.model.points
    drop = points.pressure_1 - points.pressure_2
    known = np.zeros(len(points))
    for name in ("pressure_1", "pressure_2"):
        instrument, reading = points.instrument(name), getattr(points, name)
        for part in (
            instrument.absolute,
            instrument.offset,
            instrument.relative * reading,
            instrument.calibration * reading,
        ):
            known = np.hypot(known, part)
    near = (drop < 5.0 * known) if known.any() else (points.pressure_ratio > NEAR_ONE)
    if near.any():
        reason = (
            "their pressure drop is under five times its uncertainty; they enter with large variance"
            if known.any()
            else "there a small pressure error is a large flow error, and no pressure uncertainty was stated"
        )
        yield f"Points near p2/p1 = 1 ({_listed(np.flatnonzero(near), points)}) say little: {reason}."


def _common(fit: FlowFit) -> Iterator[str]:
    for size, effect in zip(fit.x[len(fit.model.free) :].tolist(), fit.model.effects, strict=True):
        if abs(size) > 2.0:
            yield (
                f"The fit needs an error of {size:+.1f} standard deviations in the {effect.source}: check that "
                "instrument, or whether the law holds near p2/p1 = 1."
            )


def _influential(fit: FlowFit, influence: Mapping[str, list[float]]) -> Iterator[str]:
    for name, shifts in influence.items():
        sizes = np.abs(np.nan_to_num(np.array(shifts), nan=math.inf))
        k = int(np.argmax(sizes))
        if sizes[k] <= 1.0:
            continue
        where = _listed(np.array([k]), fit.model.points)
        if math.isinf(sizes[k]):
            yield f"Only one point ({where}) determines {name}."
        else:
            yield f"One point ({where}) alone moves {name} by {sizes[k]:.1f} standard errors: measure it again."


def _unit(estimates: Mapping[str, Estimate]) -> Iterator[str]:
    value = estimates["sonic_conductance"].value
    if not USUAL_CONDUCTANCE[0] <= value <= USUAL_CONDUCTANCE[1]:
        yield (
            f"sonic_conductance = {value:.3g} m^3/(s Pa) lies outside what pneumatic components have (1e-12 ... 1e-5): "
            "check the units of the flow and the pressures."
        )


def _listed(indices: Any, points: FlowPoints) -> str:
    shown = [f"{k} at {points.pressure_ratio[k]:.4g}" for k in indices[:4]]
    return "number " + ", ".join(shown) + (f" and {len(indices) - 4} more" if len(indices) > 4 else "")

"""Confidence intervals that need no linear model: profile likelihood and bootstrap."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.identify.fit.fit_findings import error_model_of
from poppet.identify.fit.fit_plan import FitPlan, refit
from poppet.identify.fit.search import Optimum
from poppet.identify.fit.statistics import influences
from poppet.identify.free_parameter import NormalPrior, by_name, with_starts
from poppet.identify.result import CONFIDENCE, Result, mark_interrupted
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel

Stages = Callable[[str, int, int], Any]
"""Called with the name of a stage after the fit, the completed steps and their total number."""

FARTHEST = 40
"""Maximum number of doublings, and of halvings, on each side of a profile."""
SHOWN = (-2.6, -1.9, -1.3, -0.7, 0.7, 1.3, 1.9, 2.6)
"""Points of a profile at each optimum, in standard deviations from it."""

BETWEEN = 8
"""Number of points of a profile between two optima."""


def add_profiles(plan: FitPlan, optimum: Optimum, result: Result, names: Sequence[str], stages: Stages) -> Result:
    """Replace the intervals of the parameters `names` by intervals from the profile likelihood.

    The profile of a parameter is the least cost at each of its values, with all other parameters fitted again.
    """
    spread = error_model_of(plan, optimum)
    estimates, series = dict(result.parameters), dict(result.series)
    remarks: list[Note] = []
    for number, name in enumerate(names):
        valid = [f.name for f in plan.free]
        if name not in valid:
            raise InputError("names.unknown", name, meaning="a free parameter", suggestion=NameSuggestion(name, valid))
        k, estimate = valid.index(name), estimates[name]

        def report(fits: int, ends: int, name: str = name, number: int = number) -> None:
            stages(f"ends of profiles ({name}: {fits} fits)", 2 * number + ends, 2 * len(names))

        try:
            low, high, curve = _compute_profile(plan, optimum, k, spread.factor(spread.influences[k]), report)
        except KeyboardInterrupt:
            result = mark_interrupted(result, Note("finding.stopped.profile", name), *remarks)
            return replace(result, parameters=estimates, series=series)
        estimates[name] = replace(estimate, low=low, high=high)
        facts: dict[str, Any] = {"low": low, "high": high, "unit": estimate.unit}
        facts |= {"linear_low": estimate.low, "linear_high": estimate.high}
        remarks.append(Note("finding.profile", name, **facts))
        series[f"profile.{name}"] = curve | facts | {"best": estimate.value}
    return replace(result, parameters=estimates, series=series, remarks=(*result.remarks, *remarks))


def _compute_profile(
    plan: FitPlan, optimum: Optimum, k: int, variance_factor: float, progress: Callable[[int, int], None]
) -> tuple[float, float, dict[str, Any]]:
    """Return both ends of the 95 % interval of a parameter, and points of its profile likelihood.

    `k` is the index of the parameter. If there are several equivalent optima, the interval contains all of them.
    """
    from scipy.special import chdtri

    free = plan.free[k]
    # The cost is half a sum of squares, which exceeds its least value by chi-square.
    allowed = 0.5 * float(chdtri(1, 1.0 - CONFIDENCE)) * variance_factor
    n_fits = 0
    equivalent = [o for o in (optimum, *optimum.others) if o.excess < allowed]
    points = {float(o.x[k]): float(o.cost) for o in equivalent}
    ends: list[float] = []

    def cost(value: float) -> float:
        nonlocal n_fits
        points[value] = min(refit(plan, o.x, optimum.sigmas, {free.name: value}).cost for o in equivalent)
        n_fits += 1
        progress(n_fits, len(ends))
        return points[value]

    for side, bound in ((-1.0, free.low), (1.0, free.high)):
        outermost = max(equivalent, key=lambda o: side * float(o.x[k]))
        curvature = float(outermost.jacobian[:, k] @ outermost.jacobian[:, k])
        step = np.sqrt(variance_factor / curvature) if curvature > 0.0 else free.scale
        limit = outermost.cost + allowed - outermost.excess
        ends.append(_find_crossing(cost, float(outermost.x[k]), side * step, bound, limit))
    # Additional points near each optimum and between optima.
    additional: list[float] = []
    for o in equivalent:
        error = np.sqrt(variance_factor) * float(np.linalg.norm(influences(o)[k]))
        additional += [*np.clip(o.x[k] + error * np.array(SHOWN), free.low, free.high)] if np.isfinite(error) else []
    for a, b in pairwise(sorted(float(o.x[k]) for o in equivalent)):
        # Wall conductances can differ by decades.
        additional += [*(np.geomspace(max(a, 1e-4 * b), b, BETWEEN) if a >= 0.0 < b else np.linspace(a, b, BETWEEN))]
    for value in {float(value) for value in additional} - points.keys():
        cost(value)
    x = np.array(sorted(points))
    rise = 2.0 * (np.array([points[value] for value in x]) - min(points.values())) / variance_factor
    curve = {
        "x": x,
        "rise": rise,
        "limit": 2.0 * allowed / variance_factor,
        "answers": [float(o.x[k]) for o in equivalent],
    }
    return ends[0], ends[1], curve


def _find_crossing(cost: Callable[[float], float], best: float, step: float, bound: float, limit: float) -> float:
    """Return the parameter value at which the cost exceeds a limit.

    `cost` returns the cost for a parameter value. The search starts at `best` with `step`. The result is `bound` if the
    cost stays below the limit.
    """
    inner, outer = best, best + step
    for _ in range(FARTHEST):
        is_beyond = outer <= bound if step < 0.0 else outer >= bound
        outer = bound if is_beyond else outer
        if outer == inner:
            return bound
        if cost(outer) > limit:
            break
        if is_beyond:
            return bound
        inner, outer = outer, best + 2.0 * (outer - best)
    else:
        return bound
    for _ in range(FARTHEST):
        if abs(outer - inner) <= 1e-3 * abs(outer - best):
            break
        middle = 0.5 * (inner + outer)
        if cost(middle) > limit:
            outer = middle
        else:
            inner = middle
    return inner


def add_bootstrap(plan: FitPlan, optimum: Optimum, result: Result, repeats: int, stages: Stages) -> Result:
    """Add bootstrap intervals to a result.

    Each bootstrap fit uses the model plus residuals that are drawn at random. `repeats` is the number of fits.
    """
    generator = np.random.default_rng(plan.settings.seed)
    start = with_starts(plan.free, optimum.x)
    models = [e.outputs(by_name(plan.free, optimum.x)) for e in plan.experiments]

    def resample(channel: Channel, model: FloatArray) -> FloatArray:
        residual = channel.values - model
        resampled = residual[generator.integers(0, residual.size, residual.size)]
        # Subtract the mean: a bias would shift all repetitions alike.
        return np.asarray(model + resampled - residual.mean())

    estimates: list[FloatArray] = []
    try:
        while len(estimates) < repeats:
            resampled = tuple(
                e.with_samples([*map(resample, e.measurement.channels, series)], start)
                for e, series in zip(plan.experiments, models, strict=True)
            )
            # A prior is a measurement as well: with fixed means, the intervals would be too narrow.
            free = tuple(
                replace(f, prior=NormalPrior(generator.normal(x, f.prior.sd), f.prior.sd)) if f.prior else f
                for f, x in zip(start, optimum.x, strict=True)
            )
            estimates.append(refit(replace(plan, experiments=resampled, free=free), optimum.x, optimum.sigmas).x)
            stages("bootstrap fits", len(estimates), repeats)
    except KeyboardInterrupt:
        result = mark_interrupted(result, Note("finding.stopped.bootstrap", done=len(estimates), asked=repeats))
    if not estimates:
        return result
    low, high = np.quantile(estimates, [0.025, 0.975], axis=0)
    remarks = [
        Note("finding.bootstrap", f.name, fits=len(estimates), low=float(a), high=float(b), unit=f.unit)
        for f, a, b in zip(plan.free, low, high, strict=True)
    ]
    return replace(result, remarks=(*result.remarks, *remarks))

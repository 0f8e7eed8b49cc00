"""Intervals on request that do not rest on a linear model: profile likelihood and bootstrap."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.fit_findings import spread_of
from poppet.identify.fit.fit_plan import FitPlan
from poppet.identify.fit.search import Optimum, SearchSettings, optimise
from poppet.identify.fit.statistics import pulls, shown
from poppet.identify.free_parameter import FreeParameter, begun_at, by_name
from poppet.identify.result import CONFIDENCE, Result
from poppet.timeseries.checks import FloatArray

Stages = Callable[[str, int, int], Any]
"""Told what follows a fit, how much of it is done, and of how much."""

FARTHEST = 40
"""Most steps of doubling and halving on each side of a profile."""
SHOWN = (-2.6, -1.9, -1.3, -0.7, 0.7, 1.3, 1.9, 2.6)
"""Sigmas from an optimum at which a profile has points in any case."""

BETWEEN = 8
"""Points of a profile from one optimum to the next."""


def profiled(plan: FitPlan, optimum: Optimum, result: Result, names: Sequence[str], stages: Stages) -> Result:
    """A result whose intervals of some numbers are by profile likelihood: all others are fitted anew at each value."""
    spread = spread_of(plan.experiments, optimum, plan.settings)
    found, series = dict(result.parameters), dict(result.series)
    remarks: list[Note] = []
    for place, name in enumerate(names):
        known = [f.name for f in plan.free]
        if name not in known:
            raise InputError("names.unknown", name, meaning="a free parameter", near=NameSuggestion(name, known))
        k, before = known.index(name), found[name]

        def told(fits: int, ends: int, name: str = name, place: int = place) -> None:
            stages(f"ends of profiles ({name}: {fits} fits)", 2 * place + ends, 2 * len(names))

        try:
            low, high, curve = _profile(plan, optimum, k, spread.factor(spread.pulls[k]), told)
        except KeyboardInterrupt:
            done = replace(result, parameters=found, series=series, remarks=(*result.remarks, *remarks))
            return _stopped(done, Note("finding.stopped.profile", name))
        found[name] = replace(before, low=low, high=high)
        facts = {"low": low, "high": high, "linear_low": before.low, "linear_high": before.high, "unit": before.unit}
        remarks.append(Note("finding.profile", name, **facts))
        series[f"profile.{name}"] = curve | facts | {"best": before.value}
    return replace(result, parameters=found, series=series, remarks=(*result.remarks, *remarks))


def _profile(
    plan: FitPlan, optimum: Optimum, k: int, widening: float, progress: Callable[[int, int], None]
) -> tuple[float, float, dict[str, Any]]:
    """Ends of the 95 % interval of one number, of the outermost optima where several are alike, and its profile."""
    from scipy.special import chdtri

    free = plan.free[k]
    # The cost is half a sum of squares, which exceeds its least value by chi-square.
    allowed = 0.5 * float(chdtri(1, 1.0 - CONFIDENCE)) * widening
    quiet = SearchSettings(plan.settings.loss)
    fits = 0
    alike = [o for o in (optimum, *optimum.others) if o.excess < allowed]
    begun = [begun_at(plan.free, o.x) for o in alike]
    points = {float(o.x[k]): float(o.cost) for o in alike}
    found: list[float] = []

    def cost(value: float) -> float:
        nonlocal fits
        least = np.inf
        for each in begun:
            other = optimise(plan.experiments, each, quiet, sigmas=optimum.sigmas, held={free.name: value})
            if other.interrupted:
                raise KeyboardInterrupt
            least = min(least, other.cost)
        fits += 1
        progress(fits, len(found))
        points[value] = least
        return least

    for side, bound in ((-1.0, free.low), (1.0, free.high)):
        outermost = max(alike, key=lambda o: side * float(o.x[k]))
        curvature = float(outermost.jacobian[:, k] @ outermost.jacobian[:, k])
        step = np.sqrt(widening / curvature) if curvature > 0.0 else free.scale
        limit = outermost.cost + allowed - outermost.excess
        found.append(_crossing(cost, float(outermost.x[k]), side * step, bound, limit))
    for value in _shown_at(alike, k, free, np.sqrt(widening)) - points.keys():
        cost(value)
    x = np.array(sorted(points))
    rise = 2.0 * (np.array([points[value] for value in x]) - min(points.values())) / widening
    curve = {"x": x, "rise": rise, "limit": 2.0 * allowed / widening, "answers": [float(o.x[k]) for o in alike]}
    return found[0], found[1], curve


def _shown_at(alike: Sequence[Optimum], k: int, free: FreeParameter, sigma: float) -> set[float]:
    """Where a profile has points besides those of the search for its ends: at every optimum, and between."""
    found: list[float] = []
    for o in alike:
        error = sigma * float(np.linalg.norm(pulls(o)[k]))
        found += list(np.clip(o.x[k] + error * np.array(SHOWN), free.low, free.high)) if np.isfinite(error) else []
    for a, b in pairwise(sorted(float(o.x[k]) for o in alike)):
        # Wall heats lie decades apart.
        found += list(np.geomspace(max(a, 1e-4 * b), b, BETWEEN) if a >= 0.0 < b else np.linspace(a, b, BETWEEN))
    return {float(value) for value in found}


def _crossing(cost: Callable[[float], float], best: float, step: float, bound: float, limit: float) -> float:
    """Where the profile crosses the limit on one side; the bound where it does not."""
    inside, outside = best, best + step
    for _ in range(FARTHEST):
        beyond = outside <= bound if step < 0.0 else outside >= bound
        outside = bound if beyond else outside
        if outside == inside:
            return bound
        if cost(outside) > limit:
            break
        if beyond:
            return bound
        inside, outside = outside, best + 2.0 * (outside - best)
    else:
        return bound
    for _ in range(FARTHEST):
        if abs(outside - inside) <= 1e-3 * abs(outside - best):
            break
        middle = 0.5 * (inside + outside)
        if cost(middle) > limit:
            outside = middle
        else:
            inside = middle
    return inside


def bootstrapped(plan: FitPlan, optimum: Optimum, result: Result, repeats: int, stages: Stages) -> Result:
    """A result with intervals from fits of recordings that are made of the model and resampled residuals."""
    generator = np.random.default_rng(plan.settings.seed)
    begun = begun_at(plan.free, optimum.x)
    models = [each.model for each in shown(plan.experiments, by_name(plan.free, optimum.x))]
    # Each begins at the optimum, and what is resampled is white: there is no false minimum to leave.
    quiet = SearchSettings(plan.settings.loss, kicks=0)
    found: list[FloatArray] = []
    while len(found) < repeats:
        left = iter(models)
        again = [_resampled(e, left, begun, generator) for e in plan.experiments]
        other = optimise(again, begun, quiet, sigmas=optimum.sigmas)
        if other.interrupted:
            result = _stopped(result, Note("finding.stopped.bootstrap", done=len(found), asked=repeats))
            break
        found.append(other.x)
        stages("bootstrap fits", len(found), repeats)
    if not found:
        return result
    low, high = np.quantile(found, [0.025, 0.975], axis=0)
    remarks = [
        Note("finding.bootstrap", f.name, fits=len(found), low=float(a), high=float(b), unit=f.unit)
        for f, a, b in zip(plan.free, low, high, strict=True)
    ]
    return replace(result, remarks=(*result.remarks, *remarks))


def _resampled(
    experiment: Experiment, models: Any, free: tuple[FreeParameter, ...], generator: np.random.Generator
) -> Experiment:
    samples = []
    for channel in experiment.measurement.channels:
        model = next(models)
        residual = channel.values - model
        # Centred below: a bias would move all repetitions the same way.
        drawn = residual[generator.integers(0, residual.size, residual.size)]
        samples.append(model + drawn - residual.mean())
    return experiment.with_samples(samples, free)


def _stopped(result: Result, note: Note) -> Result:
    """What there is of a result after an interrupt."""
    return replace(result, conditions={**result.conditions, "interrupted": True}, remarks=(*result.remarks, note))

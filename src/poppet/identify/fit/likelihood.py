"""Intervals on request that do not rest on a linear model: profile likelihood and bootstrap."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from poppet.ground.errors import InputError, suggestion
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.search import Optimum, Settings, optimise
from poppet.identify.free import Free
from poppet.identify.result import CONFIDENCE

Array = NDArray[np.float64]

FARTHEST = 40
"""Most steps of doubling and halving on each side of a profile."""


def profile_interval(
    experiments: Sequence[Experiment],
    free: tuple[Free, ...],
    optimum: Optimum,
    name: str,
    *,
    settings: Settings | None = None,
    widening: float = 1.0,
    progress: Callable[[int, int], object] | None = None,
) -> tuple[float, float]:
    """95 % interval of one number by profile likelihood: all others are fitted anew at each of its values."""
    from scipy.stats import chi2

    names = [f.name for f in free]
    if name not in names:
        raise InputError(f"profile = {name}", "is not free.", suggestion(name, names))
    k = names.index(name)
    limit = optimum.cost + 0.5 * float(chi2.ppf(CONFIDENCE, 1)) * widening
    begun = tuple(replace(f, start=float(v)) for f, v in zip(free, optimum.x, strict=True))
    quiet = Settings((settings or Settings()).loss)

    fits = ends = 0

    def cost(value: float) -> float:
        nonlocal fits
        found = optimise(experiments, begun, quiet, sigmas=optimum.sigmas, held={name: value})
        if found.interrupted:
            raise KeyboardInterrupt
        fits += 1
        if progress:
            progress(fits, ends)
        return found.cost

    curvature = float(optimum.jacobian[:, k] @ optimum.jacobian[:, k])
    step = np.sqrt(widening / curvature) if curvature > 0.0 else free[k].scale
    low = _crossing(cost, float(optimum.x[k]), -step, free[k].low, limit)
    ends = 1
    return low, _crossing(cost, float(optimum.x[k]), step, free[k].high, limit)


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


def bootstrap(
    experiments: Sequence[Experiment],
    free: tuple[Free, ...],
    optimum: Optimum,
    *,
    repeats: int = 200,
    seed: int = 0,
    block: int = 1,
    progress: Callable[[int, float], object] | None = None,
) -> Array:
    """Fits of recordings made of the model and resampled residuals."""
    generator = np.random.default_rng(seed)
    values = {f.name: float(v) for f, v in zip(free, optimum.x, strict=True)}
    begun = tuple(replace(f, start=float(v)) for f, v in zip(free, optimum.x, strict=True))
    models = [e.outputs({f.name: values[f.name] for f in e.free}) for e in experiments]
    found = np.empty((repeats, len(free)))
    for n in range(repeats):
        again = [_resampled(e, m, begun, generator, block) for e, m in zip(experiments, models, strict=True)]
        other = optimise(again, begun, sigmas=optimum.sigmas)
        if other.interrupted:
            return found[:n]
        found[n] = other.x
        if progress:
            progress(n + 1, other.cost)
    return found


def _resampled(
    experiment: Experiment, models: list[Array], free: tuple[Free, ...], generator: np.random.Generator, block: int
) -> Experiment:
    channels = []
    for channel, model in zip(experiment.measurement.channels, models, strict=True):
        residual = channel.values - model
        count = -(-residual.size // block)
        starts = generator.integers(0, max(1, residual.size - block + 1), count)
        drawn = np.concatenate([residual[s : s + block] for s in starts])[: residual.size]
        channels.append(replace(channel, values=model + drawn - residual.mean()))
    return experiment.with_measurement(replace(experiment.measurement, channels=tuple(channels)), free)

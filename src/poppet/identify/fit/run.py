"""`identify fit`: from a fit file to a result with intervals, verdicts, residuals and findings."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.ground.codes import notes_of
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.file import FitPlan, read_fit_file
from poppet.identify.fit.findings import (
    choking_findings,
    direction_findings,
    estimate_findings,
    local_findings,
    offset_findings,
    reference_findings,
    residual_findings,
    said_of,
    sampled_findings,
)
from poppet.identify.fit.likelihood import bootstrap, profile_interval
from poppet.identify.fit.search import Optimum, Settings, optimise
from poppet.identify.fit.spread import Spread, pulls
from poppet.identify.fit.statistics import aicc, correlation, estimates
from poppet.identify.fit.widths import rounds
from poppet.identify.free import Free
from poppet.identify.result import Estimate, ResidualSummary, Result, behind

Array = NDArray[np.float64]
Progress = Callable[[int, float], Any]
Stages = Callable[[str, int, int], Any]

MISFIT_NOISE, MISFIT_RANGE = 5.0, 0.02
"""A channel is missed when its rms is more than so many times its noise and more than that part of its range."""
TRIAL_RATIOS = (0.3, 0.53, 0.7)
"""Critical ratios at which the fit is repeated where the data do not determine one."""


def identify_fit(
    path: str | Path,
    *,
    compare: str | Path | None = None,
    profile: Sequence[str] = (),
    repeats: int = 0,
    progress: Progress | None = None,
    stages: Stages | None = None,
) -> Result:
    """Fit the free numbers of a circuit to recordings.

    Parameters
    ----------
    path : str or Path
        A fit file.
    compare : str or Path, optional
        Another fit file over the same recordings, to be judged against this one.
    profile : sequence of str, optional
        Free numbers whose interval is to be found by profile likelihood.
    repeats : int, optional
        Number of bootstrap fits; 0 for none.
    progress : callable, optional
        Called with the number of evaluations and the least cost so far.
    stages : callable, optional
        Called with what follows the fit (profiles, bootstrap), how much of it is done, and of how much.

    Returns
    -------
    Result
        Estimates with 95 % intervals and verdicts, residuals, findings.
    """
    plan = read_fit_file(path)
    result = fit_plan(plan, profile=profile, repeats=repeats, progress=progress, stages=stages)
    if compare is None:
        return result
    from poppet.identify.fit.comparison import compared

    return compared(result, fit_plan(read_fit_file(compare), progress=progress), Path(compare).name)


def fit_plan(
    plan: FitPlan,
    *,
    profile: Sequence[str] = (),
    repeats: int = 0,
    progress: Progress | None = None,
    stages: Stages | None = None,
) -> Result:
    """Fit a plan that was read or made."""
    optimum = optimise(plan.experiments, plan.free, plan.settings, progress=progress)
    result = describe(plan.experiments, plan.validation, plan.free, plan.settings, optimum, plan.title)
    stages = stages or _untold
    if profile and not optimum.interrupted:
        result = _profiled(plan, optimum, result, profile, stages)
    if repeats and not result.conditions["interrupted"]:
        result = _bootstrapped(plan, optimum, result, repeats, stages)
    return result


def _untold(what: str, done: int, total: int) -> None:
    """Nobody wants to know."""


def _of_profile(stages: Stages, name: str, place: int, count: int) -> Callable[[int, int], Any]:
    """What a profile reports, as a part of all profiles."""
    return lambda fits, ends: stages(f"ends of profiles ({name}: {fits} fits)", 2 * place + ends, 2 * count)


def _stopped(result: Result, what: str) -> Result:
    conditions = {**result.conditions, "interrupted": True}
    return replace(result, conditions=conditions, remarks=(*result.remarks, *notes_of([f"Interrupted: {what}."])))


def _profiled(plan: FitPlan, optimum: Optimum, result: Result, names: Sequence[str], stages: Stages) -> Result:
    spread = _judged(plan.experiments, optimum, plan.settings)[1]
    factors = {f.name: spread.factor(pull) for f, pull in zip(plan.free, pulls(optimum), strict=True)}
    changed = dict(result.parameters)
    sentences: list[str] = []
    for n, name in enumerate(names):
        try:
            low, high = profile_interval(
                plan.experiments,
                plan.free,
                optimum,
                name,
                settings=plan.settings,
                widening=factors.get(name, 1.0),
                progress=_of_profile(stages, name, n, len(names)),
            )
        except KeyboardInterrupt:
            done = replace(result, parameters=changed, remarks=(*result.remarks, *notes_of(sentences)))
            return _stopped(done, f"the interval of {name} is that of the linear model")
        before = changed[name]
        changed[name] = replace(before, low=low, high=high)
        sentences.append(
            f"{name}: by profile likelihood {low:.5g} ... {high:.5g}, by the linear model {before.low:.5g} ... "
            f"{before.high:.5g}{behind(before.unit)} (95 %)."
        )
    return replace(result, parameters=changed, remarks=(*result.remarks, *notes_of(sentences)))


def _bootstrapped(plan: FitPlan, optimum: Optimum, result: Result, repeats: int, stages: Stages) -> Result:
    found = bootstrap(
        plan.experiments,
        plan.free,
        optimum,
        repeats=repeats,
        seed=plan.settings.seed,
        progress=lambda done, _: stages("bootstrap fits", done, repeats),
    )
    if len(found) < repeats:
        result = _stopped(result, f"{len(found)} of {repeats} bootstrap fits are done")
    if not len(found):
        return result
    low, high = np.quantile(found, [0.025, 0.975], axis=0)
    sentences = [
        f"{f.name}: by {len(found)} bootstrap fits {a:.5g} ... {b:.5g}{behind(f.unit)} (95 %)."
        for f, a, b in zip(plan.free, low, high, strict=True)
    ]
    return replace(result, remarks=(*result.remarks, *notes_of(sentences)))


def describe(
    experiments: Sequence[Experiment],
    validation: Sequence[Experiment],
    free: tuple[Free, ...],
    settings: Settings,
    optimum: Optimum,
    title: str,
    *,
    method: str = "fit",
    trials: bool = True,
) -> Result:
    """Everything there is to say about an optimum."""
    values = {f.name: float(v) for f, v in zip(free, optimum.x, strict=True)}
    residuals, series, pieces = _channels(experiments, values)
    judged, spread = _judged(experiments, optimum, settings)
    found = estimates(free, optimum, spread)
    findings = ["The fit was interrupted: these are the best values so far."] if optimum.interrupted else []
    names = [(f"{e.name}.{c.address}", c.unit) for e in experiments for c in e.measurement.channels]
    findings += offset_findings(names, free, optimum, spread) + local_findings(free, optimum, spread)
    doubt = _doubt(experiments, residuals)
    if doubt:
        findings.insert(0, doubt)
        found = {name: _doubted(estimate) for name, estimate in found.items()}
    findings += sampled_findings(experiments) + reference_findings(experiments, free, found)
    findings += choking_findings(experiments, free, values) + direction_findings(free, optimum, spread)
    findings += estimate_findings(free, found) + judged + said_of(experiments)
    if trials:
        findings += _trial_findings(experiments, free, settings, optimum, found)
    held, held_series, _ = _channels(validation, values)
    findings += [f"Held out: {name} has an NRMSE of {100.0 * r.nrmse:.2f} %." for name, r in held.items()]
    return Result(
        method,
        title,
        found,
        residuals | held,
        correlation(free, optimum),
        _criterion(pieces, len(free)),
        notes_of(dict.fromkeys(findings)),
        _conditions(experiments, validation, optimum, settings),
        series | held_series,
    )


def _criterion(pieces: Sequence[Array], n_free: int) -> dict[str, Any]:
    """What models are compared by, under its name here and as it is written in the literature."""
    value = aicc(pieces, n_free)
    return {"aicc": value, "AICc": value, "free_numbers": n_free, "samples": sum(p.size for p in pieces)}


def _channels(
    experiments: Sequence[Experiment], values: dict[str, float]
) -> tuple[dict[str, ResidualSummary], dict[str, Any], list[Array]]:
    residuals, series, pieces = {}, {}, []
    for e in experiments:
        for channel, model in zip(
            e.measurement.channels, e.outputs({f.name: values[f.name] for f in e.free}), strict=True
        ):
            name = f"{e.name}.{channel.address}"
            difference = model - channel.values
            rms, span = float(np.sqrt(np.mean(difference**2))), float(np.ptp(channel.values))
            nrmse = rms / span if span > 0.0 else float("inf")
            residuals[name] = ResidualSummary(rms, nrmse, float(np.mean(difference)), channel.unit, int(model.size))
            series[name] = {"time": channel.time, "measured": channel.values, "model": model, "unit": channel.unit}
            pieces.append(difference)
    return residuals, series, pieces


def _doubt(experiments: Sequence[Experiment], residuals: Mapping[str, ResidualSummary]) -> str:
    """A sentence where the model explains no channel: then no number can be trusted, however narrow its interval."""
    from poppet.series.measured import noise_of

    ratios = {}
    for e in experiments:
        for channel in e.measurement.channels:
            name = f"{e.name}.{channel.address}"
            noise = noise_of(channel.values, channel.time)
            ratios[name] = residuals[name].nrmse if residuals[name].rms > MISFIT_NOISE * noise else 0.0
    name = min(ratios, key=lambda each: ratios[each])
    if ratios[name] <= MISFIT_RANGE:
        return ""
    r = residuals[name]
    missed = f"{100.0 * r.nrmse:.1f} % of its range" if np.isfinite(r.nrmse) else f"{r.rms:.4g}{behind(r.unit)}"
    more = "far more than its noise" if np.isfinite(r.nrmse) else "although its recording does not change at all"
    return (
        f"The model does not explain these data: even {name} is missed by {missed}, {more}. No number of "
        "this fit can be trusted. Check gauge against absolute, the units, the direction of the flow, the start values "
        "and what was held fixed."
    )


def _doubted(estimate: Estimate) -> Estimate:
    return replace(estimate, verdict="weak") if estimate.verdict == "determined" else estimate


def _judged(experiments: Sequence[Experiment], optimum: Optimum, settings: Settings) -> tuple[list[str], Spread]:
    """Findings on the residuals, and how far these move the numbers; the widening is the mean over all samples."""
    sentences, widenings, sizes, place = [], [], [], 0
    channels = [(f"{e.name}.{channel.address}", channel) for e in experiments for channel in e.measurement.channels]
    for (name, channel), sigma in zip(channels, optimum.sigmas, strict=True):
        piece = optimum.residual[place : place + channel.time.size]
        place += piece.size
        more, widening = residual_findings(name, piece, sigma, channel.unit)
        sentences += more
        widenings.append(widening)
        sizes.append(piece.size)
    return sentences, Spread(optimum, sizes, float(np.average(widenings, weights=sizes)), settings.loss)


def _trial_findings(
    experiments: Sequence[Experiment], free: tuple[Free, ...], settings: Settings, optimum: Optimum, found: Any
) -> list[str]:
    """How well the recordings are fitted with other critical ratios, where they do not determine one."""
    sentences = []
    for f in free:
        if not f.address.endswith(".critical_ratio") or found[f.name].verdict == "determined":
            continue
        shown = [f"{_first_rms(experiments, free, optimum)} with it free"]
        for ratio in TRIAL_RATIOS:
            begun = tuple(replace(g, start=float(v)) for g, v in zip(free, optimum.x, strict=True))
            held = {f.name: ratio}
            trial = optimise(experiments, begun, Settings(settings.loss), sigmas=optimum.sigmas, held=held)
            shown.append(f"{_first_rms(experiments, free, trial)} at {ratio:g}")
        name = f"{experiments[0].name}.{experiments[0].measurement.channels[0].address}"
        sentences.append(f"{f.name} held at other values: rms of {name} is {', '.join(shown)}.")
    return sentences


def _first_rms(experiments: Sequence[Experiment], free: tuple[Free, ...], optimum: Optimum) -> str:
    values = {f.name: float(v) for f, v in zip(free, optimum.x, strict=True)}
    summary = next(iter(_channels(experiments[:1], values)[0].values()))
    return f"{summary.rms:.4g}{behind(summary.unit)}"


def _conditions(
    experiments: Sequence[Experiment], validation: Sequence[Experiment], optimum: Optimum, settings: Settings
) -> dict[str, Any]:
    noise = {}
    k = 0
    for e in experiments:
        for channel in e.measurement.channels:
            noise[f"{e.name}.{channel.address}"] = float(optimum.sigmas[k])
            k += 1
    return {
        "recordings": [e.name for e in (*experiments, *validation)],
        "validation": [e.name for e in validation],
        "loss": settings.loss,
        "starts": settings.starts,
        "seed": settings.seed,
        "kicks": rounds(settings.kicks, experiments),
        "fixed": _fixed_numbers(experiments),
        "evaluations": optimum.evaluations,
        "noise": noise,
        "interrupted": optimum.interrupted,
    }


def _fixed_numbers(experiments: Sequence[Experiment]) -> dict[str, str]:
    """Numbers of the parts that the fit took as they are, with their source."""
    first = experiments[0]
    free = {each for f in first.free for each in (f.address, f.name)}
    own = {f"{name}.{key}": n for name, part in first.circuit.parts.items() for key, n in part.numbers().items()}
    return {
        address: f"{number.display()} ({number.source.kind})"
        for address, number in own.items()
        if address not in free and ".characteristic." not in address
    }

"""`identify fit`: from a fit file to a result with intervals, verdicts, residuals and findings."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import zip_longest
from pathlib import Path
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.identify.fit.contour import conductance_and_wall, contoured
from poppet.identify.fit.equivalent_optima import local_estimates, searched, tables, told, united
from poppet.identify.fit.experiment import Experiment, channels_of
from poppet.identify.fit.fit_file import read_fit_file
from poppet.identify.fit.fit_findings import CompletedFit, findings, spread_of, trials, unexplained
from poppet.identify.fit.fit_plan import FitPlan, check_effects
from poppet.identify.fit.intervals import Stages, bootstrapped, profiled
from poppet.identify.fit.optima import optima
from poppet.identify.fit.search import Optimum, kick_rounds
from poppet.identify.fit.statistics import Band, ChannelFit, aicc, bands, correlation, shown
from poppet.identify.free_parameter import by_name
from poppet.identify.result import Result

Progress = Callable[[int, float], Any]
"""Told the number of evaluations and the least cost so far."""

CLEAR, STRONG = 2.0, 10.0
"""Differences of AICc below which two models are alike, and above which one is clearly better."""


def identify_fit(
    plan: FitPlan | str | Path,
    *,
    compare: FitPlan | str | Path | None = None,
    profile: Sequence[str] = (),
    repeats: int = 0,
    contour: bool = False,
    progress: Progress | None = None,
    stages: Stages | None = None,
) -> Result:
    """Fit the free numbers of a circuit to recordings.

    Parameters
    ----------
    plan : FitPlan, str or Path
        What to fit, or a fit file.
    compare : FitPlan, str or Path, optional
        Another one over the same recordings, to be judged against this one.
    profile : sequence of str, optional
        Free numbers whose interval is to be found by profile likelihood.
    repeats : int, optional
        Number of bootstrap fits; 0 for none.
    contour : bool, optional
        Whether the misfit is wanted over conductance and wall heat: `contour` of the series, and findings.
    progress : callable, optional
        Called with the number of evaluations and the least cost so far.
    stages : callable, optional
        Called with what follows the fit (profiles, bootstrap), how much of it is done, and of how much.

    Returns
    -------
    Result
        Estimates with 95 % intervals and verdicts, residuals, findings.
    """
    first = plan if isinstance(plan, FitPlan) else read_fit_file(plan)
    result = run_fit(first, profile=profile, repeats=repeats, contour=contour, progress=progress, stages=stages)
    if compare is None:
        return result
    second, name = (
        (compare, compare.title) if isinstance(compare, FitPlan) else (read_fit_file(compare), Path(compare).name)
    )
    return compared(result, run_fit(second, progress=progress), name)


def run_fit(
    plan: FitPlan,
    *,
    profile: Sequence[str] = (),
    repeats: int = 0,
    contour: bool = False,
    progress: Progress | None = None,
    stages: Stages | None = None,
) -> Result:
    """Return the result of a plan: optimum, intervals and findings."""
    if contour:
        conductance_and_wall(plan.free)  # before the work of the fit
    check_effects(plan)
    optimum = optima(plan.experiments, plan.free, plan.settings, progress=progress)
    result = describe(plan, optimum)
    stages = stages or (lambda what, done, total: None)
    if profile and not optimum.interrupted:
        result = profiled(plan, optimum, result, profile, stages)
    if contour and not result.conditions["interrupted"]:
        result = contoured(plan, optimum, result, stages)
    if repeats and not result.conditions["interrupted"]:
        result = bootstrapped(plan, optimum, result, repeats, stages)
    return result


def describe(plan: FitPlan, optimum: Optimum, *, with_trials: bool = True) -> Result:
    """Everything there is to say about an optimum; trials of other critical ratios cost further searches."""
    values = by_name(plan.free, optimum.x)
    fitted, held = shown(plan.experiments, values), shown(plan.validation, values)
    spread = spread_of(plan.experiments, optimum, plan.settings)
    local = local_estimates(plan, optimum)
    found = united(plan, local)
    remarks: list[Note] = []
    doubt = unexplained(fitted)
    if doubt:
        remarks.append(doubt)
        found = {k: replace(e, verdict="weak") if e.verdict == "determined" else e for k, e in found.items()}
    remarks += told(plan, optimum)
    fit = CompletedFit(plan.experiments, plan.free, plan.settings, optimum, spread, fitted, found)
    remarks += findings(fit)
    if with_trials:
        remarks += trials(fit)
    remarks += [Note("finding.held_out", each.name, percent=100.0 * each.summary().nrmse) for each in held]
    pieces = [each.model - each.channel.values for each in fitted]
    criterion = aicc(pieces, len(plan.free))
    return Result(
        "fit",
        plan.title,
        found,
        residuals={each.name: each.summary() for each in (*fitted, *held)},
        correlation=correlation(plan.free, optimum),
        comparison={
            "aicc": criterion,
            "AICc": criterion,  # as it is written in the literature
            "free_numbers": len(plan.free),
            "samples": sum(piece.size for piece in pieces),
        },
        remarks=tuple(dict.fromkeys(remarks)),
        conditions=_conditions(plan, optimum),
        optima=tables(plan, optimum, local),
        series={each.name: _series(each, band) for each, band in zip_longest((*fitted, *held), bands(optimum, spread))},
    )


def _series(shown: ChannelFit, band: Band | None) -> dict[str, Any]:
    """A channel for the report; what is held out of the fit has no band."""
    channel, model = shown.channel, shown.model
    found = {"time": channel.time, "measured": channel.values, "model": model, "unit": channel.unit}
    if band is not None:
        found |= {"low": model - band.model, "high": model + band.model}
        found |= {"samples_low": model - band.samples, "samples_high": model + band.samples}
    return found


def _conditions(plan: FitPlan, optimum: Optimum) -> dict[str, Any]:
    sigmas = zip(channels_of(plan.experiments), optimum.sigmas, strict=True)
    return {
        "recordings": [e.name for e in (*plan.experiments, *plan.validation)],
        "validation": [e.name for e in plan.validation],
        "loss": plan.settings.loss,
        "starts": plan.settings.starts,
        "seed": plan.settings.seed,
        "kicks": kick_rounds(plan.settings, plan.experiments),
        "fixed": _fixed_numbers(plan.experiments[0]),
        "evaluations": optimum.evaluations,
        "noise": {each.name: float(sigma) for each, sigma in sigmas},
        "interrupted": optimum.interrupted,
        "searches": searched(plan, optimum),
    }


def _fixed_numbers(experiment: Experiment) -> dict[str, str]:
    """Numbers of the parts that the fit took as they are, with their source."""
    free = {each for f in experiment.free for each in (f.address, f.name)}
    return {
        address: f"{number.display()} ({number.source.kind})"
        for address, number in experiment.instance.sources.items()
        if address not in free and ".characteristic." not in address
    }


def compared(first: Result, second: Result, name: str) -> Result:
    """The first result with the second, of the file `name`, judged against it by AICc."""
    if first.comparison["samples"] != second.comparison["samples"] or set(first.residuals) != set(second.residuals):
        raise InputError("fit.compare", "compare", other=name)
    difference = float(second.comparison["aicc"]) - float(first.comparison["aicc"])
    size, titles = abs(difference), (first.title, f"{second.title} ({name})")
    if size < CLEAR:
        verdict = Note("finding.models.alike", first=titles[0], second=titles[1], size=size)
    else:
        better, worse = titles if difference > 0.0 else titles[::-1]
        word = "clearly" if size > STRONG else "somewhat"
        verdict = Note(f"finding.models.{word}", better=better, worse=worse, size=size)
    comparison = {
        **first.comparison,
        "other": name,
        "other_aicc": float(second.comparison["aicc"]),
        "other_free_numbers": second.comparison["free_numbers"],
        "aicc_difference": difference,
        "other_rms": {channel: summary.rms for channel, summary in second.residuals.items()},
        "verdict": str(verdict),
    }
    return replace(first, comparison=comparison, remarks=(verdict, *first.remarks))

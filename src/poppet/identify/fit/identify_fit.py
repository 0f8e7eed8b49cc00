"""Method `identify fit`, which turns a plan into a result with intervals, verdicts and findings."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import zip_longest
from pathlib import Path
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.identify.fit.contour import add_contour, contour_indices
from poppet.identify.fit.experiment import channels_of
from poppet.identify.fit.fit_findings import (
    CompletedFit,
    critical_ratio_notes,
    error_model_of,
    finding_notes,
    unexplained_note,
)
from poppet.identify.fit.fit_plan import FitPlan, check_effects, read_fit_file
from poppet.identify.fit.intervals import Stages, add_bootstrap, add_profiles
from poppet.identify.fit.optima import (
    find_optima,
    local_estimates,
    optima_notes,
    optimum_tables,
    search_tables,
    unite_estimates,
)
from poppet.identify.fit.search import Optimum, count_restart_rounds
from poppet.identify.fit.statistics import ChannelFit, ConfidenceBand, aicc, channel_fits, confidence_bands, correlation
from poppet.identify.free_parameter import by_name
from poppet.identify.result import Result

Progress = Callable[[int, float], Any]
"""Called with the number of evaluations and the least cost so far."""

CLEAR, STRONG = 2.0, 10.0
"""Differences of AICc below which two models are equivalent, and above which one is clearly better."""


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
    """Fit free parameters of a circuit to recordings.

    Parameters
    ----------
    plan : FitPlan, str or Path
        Plan of the fit, or a fit file.
    compare : FitPlan, str or Path, optional
        Another plan for the same recordings, which is compared with this one.
    profile : sequence of str, optional
        Free parameters whose intervals are computed from the profile likelihood.
    repeats : int, optional
        Number of bootstrap fits; 0 for none.
    contour : bool, optional
        If True, add the chi-square contour over conductance and wall conductance to the series, and its findings.
    progress : callable, optional
        Function that is called with the number of evaluations and the least cost so far.
    stages : callable, optional
        Function that is called with the stage after the fit (profiles, contour, bootstrap), the number of completed
        steps and their total number.

    Returns
    -------
    Result
        Estimates with 95 % intervals and verdicts, residuals, findings.
    """
    plan = plan if isinstance(plan, FitPlan) else read_fit_file(plan)
    if contour:
        contour_indices(plan.free)  # before the work of the fit
    check_effects(plan)
    optimum = find_optima(plan, progress=progress)
    result = describe_optimum(plan, optimum)
    stages = stages or (lambda stage, completed, total: None)
    if profile and not optimum.interrupted:
        result = add_profiles(plan, optimum, result, profile, stages)
    if contour and not result.interrupted:
        result = add_contour(plan, optimum, result, stages)
    if repeats and not result.interrupted:
        result = add_bootstrap(plan, optimum, result, repeats, stages)
    if compare is None:
        return result
    name = compare.title if isinstance(compare, FitPlan) else Path(compare).name
    return compare_results(result, identify_fit(compare, progress=progress), name)


def describe_optimum(plan: FitPlan, optimum: Optimum, *, with_trials: bool = True) -> Result:
    """Return the result of a fit from its optimum: estimates, residuals and findings.

    If the keyword `with_trials` is True, the findings include refits with other critical ratios.
    """
    values = by_name(plan.free, optimum.x)
    fitted, validation = channel_fits(plan.experiments, values), channel_fits(plan.validation, values)
    spread = error_model_of(plan, optimum)
    local = local_estimates(plan, optimum)
    estimates = unite_estimates(plan, local)
    remarks: list[Note] = []
    doubt_note = unexplained_note(fitted)
    if doubt_note:
        remarks.append(doubt_note)
        estimates = {k: replace(e, verdict="weak") if e.verdict == "determined" else e for k, e in estimates.items()}
    remarks += optima_notes(plan, optimum)
    fit = CompletedFit(plan, optimum, spread, fitted, estimates)
    remarks += finding_notes(fit)
    if with_trials:
        remarks += critical_ratio_notes(fit)
    remarks += [
        Note("finding.held_out", channel_fit.name, percent=100.0 * channel_fit.summary().nrmse)
        for channel_fit in validation
    ]
    residuals = [channel_fit.model - channel_fit.channel.values for channel_fit in fitted]
    criterion = aicc(residuals, len(plan.free))
    return Result(
        "fit",
        plan.title,
        estimates,
        residuals={channel_fit.name: channel_fit.summary() for channel_fit in (*fitted, *validation)},
        correlation=correlation(plan.free, optimum),
        comparison={
            "aicc": criterion,
            "AICc": criterion,  # spelling of the literature
            "free_numbers": len(plan.free),
            "samples": sum(piece.size for piece in residuals),
        },
        remarks=tuple(dict.fromkeys(remarks)),
        conditions=_conditions(plan, optimum),
        optima=optimum_tables(plan, optimum, local),
        series={
            channel_fit.name: _series_table(channel_fit, band)
            for channel_fit, band in zip_longest((*fitted, *validation), confidence_bands(optimum, spread))
        },
    )


def _series_table(channel_fit: ChannelFit, band: ConfidenceBand | None) -> dict[str, Any]:
    """Return measured and simulated series of a channel for the report.

    `band` contains the confidence bands of the channel; it is None for validation data.
    """
    channel, model = channel_fit.channel, channel_fit.model
    table = {"time": channel.time, "measured": channel.values, "model": model, "unit": channel.unit}
    if band is not None:
        table |= {"low": model - band.model, "high": model + band.model}
        table |= {"samples_low": model - band.samples, "samples_high": model + band.samples}
    return table


def _conditions(plan: FitPlan, optimum: Optimum) -> dict[str, Any]:
    sigmas = zip(channels_of(plan.experiments), optimum.sigmas, strict=True)
    first = plan.experiments[0]
    free = {name for f in first.free for name in (f.address, f.name)}
    return {
        "recordings": [e.name for e in (*plan.experiments, *plan.validation)],
        "validation": [e.name for e in plan.validation],
        "loss": plan.settings.loss,
        "starts": plan.settings.starts,
        "seed": plan.settings.seed,
        "kicks": count_restart_rounds(plan.settings, plan.experiments),
        "fixed": {
            address: f"{number.display()} ({number.source.kind})"
            for address, number in first.instance.sources.items()
            if address not in free and "characteristic." not in address
        },
        "evaluations": optimum.evaluations,
        "noise": {fitted.name: float(sigma) for fitted, sigma in sigmas},
        "interrupted": optimum.interrupted,
        "searches": search_tables(plan, optimum),
    }


def compare_results(first: Result, second: Result, name: str) -> Result:
    """Return the result `first`, with a comparison of its AICc with that of the result `second`.

    `name` identifies the second result. An error is raised if the results belong to different data.
    """
    if first.comparison["samples"] != second.comparison["samples"] or set(first.residuals) != set(second.residuals):
        raise InputError("fit.compare", "compare", other=name)
    difference = float(second.comparison["aicc"]) - float(first.comparison["aicc"])
    size, titles = abs(difference), (first.title, f"{second.title} ({name})")
    if size < CLEAR:
        verdict = Note("finding.models.alike", first=titles[0], second=titles[1], size=size)
    else:
        better, worse = titles if difference > 0.0 else titles[::-1]
        degree = "clearly" if size > STRONG else "somewhat"
        verdict = Note(f"finding.models.{degree}", better=better, worse=worse, size=size)
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

"""Findings of a fit, with facts, and proposals for tests that would resolve an ambiguity."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.identify.fit.experiment import channels_of
from poppet.identify.fit.fit_plan import LARGEST_OFFSET, SURELY, FitPlan
from poppet.identify.fit.residuals import correlation_time, is_white, staircase
from poppet.identify.fit.search import Optimum, SearchSettings, optimise
from poppet.identify.fit.statistics import ChannelFit, ErrorModel, SensorLimits, channel_fits
from poppet.identify.free_parameter import FreeParameter, by_name, with_starts
from poppet.identify.result import Estimate, replace_uncertain_findings
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import noise_of
from poppet.timeseries.measurements.verdicts import is_evacuated

MISFIT_NOISE, MISFIT_RANGE = 5.0, 0.02
"""Limits above which a channel is not explained: rms over its noise, and rms over its range."""
TRIAL_RATIOS = (0.3, 0.53, 0.7)
"""Critical ratios of repeated fits if the data do not determine the critical ratio."""
BELOW = 0.5
"""Fraction of the ambient pressure below which a steady pressure is unusual."""
UNSEEN_TOGETHER = 4.0
"""Sensitivity to a relative change, in sigmas, below which a combination is not identifiable."""
TOLD, VISIBLE = 0.1, 0.4
"""Limits for the report of an offset: relative increase of an interval, and bias in sigmas."""
LOCAL = 1.5
"""Factor on an interval above which a local lack of fit is reported."""
LOST = ("at bound", "not determined")
IDEAL_RATIO = 0.53
"""Critical ratio of an ideal nozzle for a diatomic gas, rounded up."""


@dataclass(frozen=True)
class CompletedFit:
    """Data of a completed fit: plan, optimum, error model and estimates."""

    plan: FitPlan
    optimum: Optimum
    spread: ErrorModel  # error model of the estimates
    channels: Sequence[ChannelFit]  # all channels with their models, in the order of the residuals
    estimates: Mapping[str, Estimate]

    @property
    def values(self) -> dict[str, float]:
        """Mapping from the name of each free parameter to its fitted value."""
        return by_name(self.plan.free, self.optimum.x)


def finding_notes(fit: CompletedFit) -> list[Note]:
    """Return the findings of a fit, the most important first.

    Notes on other critical ratios are not included, because they need further searches.
    """
    experiments = fit.plan.experiments
    sampled = tuple(e.name for e in experiments if e.samples)
    notes = [
        *([Note("finding.interrupted")] if fit.optimum.interrupted else []),
        *(note.within(e.name) for e in experiments for note in e.measurement.findings),
        *offset_notes(fit),
        *local_misfit_notes(fit),
        *([Note("finding.sampled", recordings=sampled)] if sampled else []),
        *gauge_reference_notes(fit),
        *choking_notes(fit),
        *correlation_notes(fit),
        *parameter_notes(fit.plan.free, fit.estimates),
        *unusual_ratio_notes(fit.plan.free, fit.estimates),
        *residual_notes(fit),
        *(note.within(e.name) for e in experiments for note in e.measurement.notes),
    ]
    return [*replace_uncertain_findings(notes, fit.estimates)]


# The fit as a whole -----------------------------------------------------------------------------------------------


def unexplained_note(channels: Sequence[ChannelFit]) -> Note | None:
    """Return a note if the model describes none of the channels.

    The result is None if it describes at least one channel.
    """

    def unexplained_fraction(channel_fit: ChannelFit) -> float:
        noise = noise_of(channel_fit.channel.values, channel_fit.channel.time)
        residual = channel_fit.summary()
        return residual.nrmse if residual.rms > MISFIT_NOISE * noise else 0.0

    fractions = [unexplained_fraction(channel_fit) for channel_fit in channels]
    if min(fractions) <= MISFIT_RANGE:
        return None
    best = channels[fractions.index(min(fractions))]
    summary = best.summary()
    if np.isfinite(summary.nrmse):
        return Note("finding.unexplained.range", best.name, percent=100.0 * summary.nrmse)
    return Note("finding.unexplained.constant", best.name, rms=summary.rms, unit=summary.unit)


# Residuals --------------------------------------------------------------------------------------------------------


def offset_notes(fit: CompletedFit) -> Iterator[Note]:
    """Yield a note on each channel whose sensor seems to have an offset.

    The note states the offset, and how much it widens the intervals of the parameters.
    """
    for offset in fit.spread.offsets:
        growth = {}
        for f, pull in zip(fit.plan.free, fit.spread.influences, strict=True):
            error_without_offset = fit.spread.deviation(pull, offsets=())
            error_with_offset = fit.spread.deviation(pull, offsets=(offset,))
            if 0.0 < error_without_offset < np.inf and error_with_offset >= (1.0 + TOLD) * error_without_offset:
                growth[f.name] = error_with_offset / error_without_offset
        if not offset.is_possible or (not growth and abs(offset.bias) < VISIBLE):
            continue
        channel_fit, sigma = fit.channels[offset.channel], fit.optimum.sigmas[offset.channel]
        facts: dict[str, Any] = {
            "bias": abs(offset.bias) * sigma,
            "is_above": offset.bias > 0.0,
            "size": abs(offset.size) * sigma,
            "is_high": offset.size > 0.0,
            "unit": channel_fit.channel.unit,
        }
        if growth:
            widest_first = dict(sorted(growth.items(), key=lambda item: -item[1]))
            yield Note("finding.offset.widens", channel_fit.name, **facts, growth=widest_first)
        else:
            yield Note("finding.offset.small", channel_fit.name, **facts, percent=100.0 * TOLD)


def local_misfit_notes(fit: CompletedFit) -> Iterator[Note]:
    """Yield a note on parameters that depend mainly on a few samples with a large lack of fit."""
    pairs = zip(fit.plan.free, fit.spread.influences, strict=True)
    names = tuple(f.name for f, pull in pairs if fit.spread.is_local(pull, LOCAL))
    if names:
        yield Note("finding.local", names=names)


def widening_of(residual: FloatArray) -> float:
    """Return the factor by which a lack of fit increases variances, from the residuals of a channel.

    It follows from the mean square and the correlation time of the residuals. `residual` contains the residuals divided
    by the noise.
    """
    return max(1.0, float(np.mean(residual**2))) * (1.0 if is_white(residual) else correlation_time(residual))


def residual_findings(name: str, residual: FloatArray, sigma: float, unit: str) -> Iterator[Note]:
    """Yield notes on a channel whose residuals are not white noise of the expected size.

    `residual` contains the residuals, divided by the noise `sigma`.
    """
    spread, samples = float(np.mean(residual**2)), correlation_time(residual)
    if spread > 2.0:
        yield Note("finding.residuals.large", name, times=float(np.sqrt(spread)), noise=sigma, unit=unit)
    if samples > 1.5 and not is_white(residual):
        yield Note("finding.residuals.not_white", name, samples=samples)


def residual_notes(fit: CompletedFit) -> Iterator[Note]:
    """Yield notes on channels of a fit whose residuals are not white noise of the expected size."""
    for fitted, sigma in zip(channels_of(fit.plan.experiments), fit.optimum.sigmas, strict=True):
        yield from residual_findings(fitted.name, fit.optimum.residual[fitted.rows], sigma, fitted.channel.unit)


def error_model_of(plan: FitPlan, optimum: Optimum) -> ErrorModel:
    """Return the error model of a fit, which gives the standard errors of the estimates.

    Its variance factor is the mean of the factors of all channels, weighted by their numbers of samples.
    """
    variance_factors, sizes, gauges = [], [], []
    for (_, channel, rows), sigma in zip(channels_of(plan.experiments), optimum.sigmas, strict=True):
        residual, quantum = optimum.residual[rows], channel.quantum
        variance_factors.append(widening_of(residual))
        sizes.append(channel.time.size)
        # A constant reading gives no limit on the offset of the sensor.
        range_limit = LARGEST_OFFSET * float(np.ptp(channel.values)) or np.inf
        largest = range_limit if channel.offset in (None, np.inf) else SURELY * channel.offset
        steps = None
        if quantum > 0.0:
            # Both contain the rounding; only the residuals contain a lack of fit.
            total_noise = min(noise_of(channel.values, channel.time), sigma * float(np.sqrt(np.mean(residual**2))))
            noise = float(np.sqrt(max(0.0, total_noise**2 - quantum**2 / 12.0)))
            steps = staircase(channel.values / sigma + residual, quantum / sigma, noise / sigma)
        gauges.append(SensorLimits(steps, largest / sigma))
    mean_factor = float(np.average(variance_factors, weights=sizes))
    return ErrorModel(optimum, sizes, mean_factor, plan.settings.loss, gauges)


# Numbers ----------------------------------------------------------------------------------------------------------


def parameter_notes(free: Sequence[FreeParameter], estimates: Mapping[str, Estimate]) -> Iterator[Note]:
    """Yield notes on parameters whose estimates are not reliable.

    The estimate of such a parameter is at a bound or equal to its start value, or the data determine it weakly or not
    at all.
    """
    for f in free:
        e = estimates[f.name]
        is_low = e.value - f.low <= f.high - e.value
        cases = {
            "bound": e.verdict == "at bound",
            "not_determined": e.verdict == "not determined",
            "not_moved": e.value == f.start,
            "weak": e.verdict == "weak",
        }
        # Report only the first case that is true.
        if case := next((case for case, holds in cases.items() if holds), None):
            facts = {"value": e.value, "error": e.standard_error, "low": e.low, "high": e.high, "unit": f.unit}
            yield Note(f"finding.number.{case}", f.name, **facts, **({"is_low": is_low} if case == "bound" else {}))


def unusual_ratio_notes(free: Sequence[FreeParameter], estimates: Mapping[str, Estimate]) -> Iterator[Note]:
    """Yield notes on critical ratios above the critical ratio of an ideal nozzle."""
    for f in free:
        e = estimates[f.name]
        if f.address.endswith("critical_ratio") and e.value > IDEAL_RATIO and e.verdict not in LOST:
            yield Note("finding.unusual.ratio", f.name, value=e.value)


def choking_notes(fit: CompletedFit) -> Iterator[Note]:
    """Yield notes on flow paths in which the flow is always or never choked."""
    for f in fit.plan.free:
        owner, _, local = f.address.rpartition(".")
        if local != "critical_ratio":
            continue
        regimes = np.zeros(0)
        for experiment in fit.plan.experiments:
            run, outputs = experiment.all_outputs(fit.values)
            if f"{owner}.regime" in outputs:
                regimes = np.append(regimes, run.values[outputs.index(f"{owner}.regime")])
        flowing = np.abs(regimes[regimes != 0.0])  # 0: no flow
        if flowing.size and np.all(flowing == 3.0):
            yield Note("finding.choking.throughout", f.name, passage=owner)
        elif flowing.size and not np.any(flowing == 3.0) and fit.values[f.name] > f.low:
            e = fit.estimates[f.name]
            yield Note("finding.choking.never", owner, number=f.name, value=e.value, low=e.low, high=e.high)


def gauge_reference_notes(fit: CompletedFit) -> Iterator[Note]:
    """Yield notes on gauge pressures that were probably read as absolute.

    The criterion is a tank that seems to empty to a vacuum, together with a critical ratio that is not determined.
    Tanks that are evacuated at the start and circuits with a vacuum are excluded.
    """
    undetermined = [
        f.name for f in fit.plan.free if f.address.endswith(".critical_ratio") and fit.estimates[f.name].verdict in LOST
    ]
    pressures = [(e, c) for e in fit.plan.experiments for c in e.measurement.channels if c.unit == "Pa"]
    for e, channel in pressures if undetermined else []:
        floor, ambient = float(np.min(channel.values)), float(e.measurement.ambient_pressure)
        is_said = any(
            (note.code, note.address) == ("suspicion.read_as_absolute", channel.address)
            for note in e.measurement.findings
        )
        is_low = floor < BELOW * ambient and not is_evacuated(channel.values, ambient)
        # A circuit with a vacuum has a fixed pressure far below the ambient pressure.
        unknown = {f.address for f in e.free}
        unknown |= {address for address, start in e.measurement.start.items() if start in ("first", "free")}
        has_vacuum = any(
            value < BELOW * ambient
            for a, value in e.instance.parameters.items()
            if a not in unknown and a.endswith((".pressure", ".initial_pressure"))
        )
        if is_low and not is_said and not has_vacuum:
            number, verdict = undetermined[0], fit.estimates[undetermined[0]].verdict
            facts = {"floor": 1e-5 * floor, "ambient": 1e-5 * ambient, "number": number, "verdict": verdict}
            yield Note("finding.gauge", f"{e.name}.{channel.address}", **facts)


def correlation_notes(fit: CompletedFit) -> Iterator[Note]:
    """Yield notes on a combination of parameters that the data cannot separate.

    The notes include the ratio of such parameters if the data determine this ratio.
    """
    x = fit.optimum.x
    indices = [k for k in range(len(fit.plan.free)) if fit.optimum.active[k] == 0 and x[k] != 0.0]
    if len(indices) < 2:
        return
    u, s, vt = np.linalg.svd(fit.optimum.jacobian[:, indices] * x[indices], full_matrices=False)
    if s[-1] > UNSEEN_TOGETHER and s[-1] > 1e-4 * s[0]:
        return
    direction = vt[-1] / np.max(np.abs(vt[-1]))
    weights = {k: float(weight) for k, weight in enumerate(direction) if abs(weight) > 0.2}
    if len(weights) < 2:
        return
    names = [fit.plan.free[k].name for k in indices]
    is_scaled = len({weight > 0.0 for weight in weights.values()}) == 1
    changes = {names[k]: weight for k, weight in weights.items()}
    change = "scaled" if is_scaled else "changed"
    yield Note(f"finding.alike.{change}", names=tuple(changes), shares=changes, sigmas=0.01 * float(s[-1]))
    kinds = {name.rpartition(".")[2] for name in changes}
    remedy = "ratio" if "critical_ratio" in kinds else "other"
    if kinds & {"sonic_conductance", "effective_area"}:
        remedy = "volume" if "volume" in kinds else "wall" if "wall_conductance" in kinds else remedy
    yield Note(f"finding.tell_apart.{remedy}", names=tuple(changes))
    if not is_scaled:
        return
    # Report the ratios that the data do determine; in logarithms a ratio is a difference.
    influence = (vt[:-1].T / s[:-1]) @ u[:, :-1].T
    denominator = next((k for k in weights if names[k].endswith(".volume")), next(iter(weights)))
    for numerator in weights:
        # The ratio is constant only if both change by the same factor.
        if numerator == denominator or not 0.9 < weights[numerator] / weights[denominator] < 1.1:
            continue
        error = 1.96 * fit.spread.deviation(influence[numerator] - influence[denominator])
        if error < np.log(2.0):
            ratio, factor = float(x[indices[numerator]] / x[indices[denominator]]), float(np.exp(error))
            units = {"unit": fit.plan.free[indices[numerator]].unit, "per": fit.plan.free[indices[denominator]].unit}
            facts = {"value": ratio, "low": ratio / factor, "high": ratio * factor, **units}
            yield Note("finding.ratio", names[numerator], over=names[denominator], **facts)


# Recordings and repetitions ---------------------------------------------------------------------------------------


def critical_ratio_notes(fit: CompletedFit) -> Iterator[Note]:
    """Yield a note on each critical ratio that the data do not determine.

    The note compares the rms residual of the fit with the rms residuals of refits at other critical ratios.
    """

    def first_rms(x: FloatArray) -> float:
        return channel_fits(fit.plan.experiments[:1], by_name(fit.plan.free, x))[0].summary().rms

    start = with_starts(fit.plan.free, fit.optimum.x)
    settings = SearchSettings(fit.plan.settings.loss)
    for f in fit.plan.free:
        if not f.address.endswith(".critical_ratio") or fit.estimates[f.name].verdict == "determined":
            continue
        refits = [
            optimise(fit.plan.experiments, start, settings, sigmas=fit.optimum.sigmas, fixed={f.name: ratio}).x
            for ratio in TRIAL_RATIOS
        ]
        first = fit.channels[0]
        facts = {"rms": first_rms(fit.optimum.x), "others": tuple(map(first_rms, refits)), "unit": first.channel.unit}
        yield Note("finding.trials", f.name, channel=first.name, ratios=TRIAL_RATIOS, **facts)

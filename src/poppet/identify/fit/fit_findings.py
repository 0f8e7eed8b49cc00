"""What a reader of a fit has to know: for each condition a note with numbers, and the test that resolves it."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.identify.fit.experiment import Experiment, FittedChannel, channels_of
from poppet.identify.fit.rounding import Staircase, staircase
from poppet.identify.fit.search import Optimum, SearchSettings, optimise
from poppet.identify.fit.statistics import ChannelFit, ErrorModel, Gauge, shown
from poppet.identify.fit.whiteness import correlation_time, is_white
from poppet.identify.free_parameter import FreeParameter, begun_at, by_name
from poppet.identify.result import Estimate, replace_uncertain_findings
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import noise_of
from poppet.timeseries.measurements.verdicts import is_evacuated

MISFIT_NOISE, MISFIT_RANGE = 5.0, 0.02
"""A channel is missed when its rms is more than so many times its noise and more than that part of its range."""
TRIAL_RATIOS = (0.3, 0.53, 0.7)
"""Critical ratios at which the fit is repeated where the data do not determine one."""
BELOW = 0.5
"""Part of the ambient pressure: circuits for compressed air seldom rest below."""
UNSEEN_TOGETHER = 4.0
"""Change of the fit, in sigmas over all samples per relative change of one, below which a direction is unseen."""
TOLD, VISIBLE = 0.1, 0.4
"""An offset is named where it widens an interval by that part, or where the model is off by so many sigmas."""
LOCAL = 1.5
"""Factor on an interval from which misfit in few samples is named."""
LOST = ("at bound", "not determined")
LARGEST_OFFSET = 0.1
"""Of the range of a recording: how far a sensor may be off of which nothing is known."""
SURELY = 3.0
"""Sigmas of a sensor's zero as stated that it may be off."""


@dataclass(frozen=True)
class CompletedFit:
    """A fit that is done: what there is to find something in."""

    experiments: Sequence[Experiment]  # those that were fitted
    free: tuple[FreeParameter, ...]
    settings: SearchSettings
    optimum: Optimum
    spread: ErrorModel  # what moves the numbers
    channels: Sequence[ChannelFit]  # every channel with its model, in the order of the residual
    estimates: Mapping[str, Estimate]

    @property
    def values(self) -> dict[str, float]:
        """Free numbers by name."""
        return by_name(self.free, self.optimum.x)


def findings(fit: CompletedFit) -> list[Note]:
    """All findings, the most important first."""
    return [*replace_uncertain_findings((note for collect in COLLECTORS for note in collect(fit)), fit.estimates)]


# The fit as a whole -----------------------------------------------------------------------------------------------


def unexplained(channels: Sequence[ChannelFit]) -> Note | None:
    """Where the model explains no channel: then no number can be trusted, however narrow its interval."""

    def part_missed(each: ChannelFit) -> float:
        noise = noise_of(each.channel.values, each.channel.time)
        residual = each.summary()
        return residual.nrmse if residual.rms > MISFIT_NOISE * noise else 0.0

    parts = [part_missed(each) for each in channels]
    if min(parts) <= MISFIT_RANGE:
        return None
    best = channels[parts.index(min(parts))]
    summary = best.summary()
    if np.isfinite(summary.nrmse):
        return Note("finding.unexplained.range", best.name, percent=100.0 * summary.nrmse)
    return Note("finding.unexplained.constant", best.name, rms=summary.rms, unit=summary.unit)


def interruption(fit: CompletedFit) -> Iterator[Note]:
    """The search was ended by the user."""
    if fit.optimum.interrupted:
        yield Note("finding.interrupted")


def sampling(fit: CompletedFit) -> Iterator[Note]:
    """What intervals do not hold where a program samples."""
    names = tuple(e.name for e in fit.experiments if e.samples)
    if names:
        yield Note("finding.sampled", recordings=names)


# Residuals --------------------------------------------------------------------------------------------------------


def offsets(fit: CompletedFit) -> Iterator[Note]:
    """Channels that are missed by a constant, and what this adds to the intervals."""
    for offset in fit.spread.offsets:
        growth = {}
        for f, pull in zip(fit.free, fit.spread.pulls, strict=True):
            before = fit.spread.deviation(pull, offsets=())
            after = fit.spread.deviation(pull, offsets=(offset,))
            if 0.0 < before < np.inf and after >= (1.0 + TOLD) * before:
                growth[f.name] = after / before
        if not offset.is_possible or (not growth and abs(offset.bias) < VISIBLE):
            continue
        each, sigma = fit.channels[offset.channel], fit.optimum.sigmas[offset.channel]
        facts: dict[str, Any] = {
            "bias": abs(offset.bias) * sigma,
            "is_above": offset.bias > 0.0,
            "size": abs(offset.size) * sigma,
            "is_high": offset.size > 0.0,
            "unit": each.channel.unit,
        }
        if growth:
            widest_first = dict(sorted(growth.items(), key=lambda item: -item[1]))
            yield Note("finding.offset.widens", each.name, **facts, growth=widest_first)
        else:
            yield Note("finding.offset.small", each.name, **facts, percent=100.0 * TOLD)


def local_misfit(fit: CompletedFit) -> Iterator[Note]:
    """Numbers that the misfit moves more than its mean over all samples says."""
    pairs = zip(fit.free, fit.spread.pulls, strict=True)
    names = tuple(f.name for f, pull in pairs if fit.spread.is_local(pull, LOCAL))
    if names:
        yield Note("finding.local", names=names)


def widening_of(residual: FloatArray) -> float:
    """Factor on variances that residuals, in sigmas, call for: by their size, and by how many of them count as one."""
    return max(1.0, float(np.mean(residual**2))) * (1.0 if is_white(residual) else correlation_time(residual))


def residual_findings(name: str, residual: FloatArray, sigma: float, unit: str) -> Iterator[Note]:
    """Whether the residuals of a channel, in sigmas, are white and small as the noise."""
    spread, samples = float(np.mean(residual**2)), correlation_time(residual)
    if spread > 2.0:
        yield Note("finding.residuals.large", name, times=float(np.sqrt(spread)), noise=sigma, unit=unit)
    if samples > 1.5 and not is_white(residual):
        yield Note("finding.residuals.not_white", name, samples=samples)


def residuals(fit: CompletedFit) -> Iterator[Note]:
    """Channels whose residuals are no noise."""
    for each, sigma in zip(channels_of(fit.experiments), fit.optimum.sigmas, strict=True):
        yield from residual_findings(each.name, fit.optimum.residual[each.rows], sigma, each.channel.unit)


def spread_of(experiments: Sequence[Experiment], optimum: Optimum, settings: SearchSettings) -> ErrorModel:
    """What moves the numbers of a fit; the widening is the mean over all samples."""
    channels = channels_of(experiments)
    pieces = [optimum.residual[each.rows] for each in channels]
    judged = [widening_of(piece) for piece in pieces]
    sizes = [each.channel.time.size for each in channels]
    gauges = [_gauge(*each) for each in zip(channels, pieces, optimum.sigmas, strict=True)]
    return ErrorModel(optimum, sizes, float(np.average(judged, weights=sizes)), settings.loss, gauges)


def _gauge(each: FittedChannel, residual: FloatArray, sigma: float) -> Gauge:
    """What is known of the sensor of a channel."""
    stated, span = each.channel.offset, float(np.ptp(each.channel.values))
    # Of a sensor that does not move nothing is known at all.
    largest = SURELY * stated if stated is not None else LARGEST_OFFSET * span or np.inf
    return Gauge(_steps(each, residual, sigma), largest / sigma)


def _steps(each: FittedChannel, residual: FloatArray, sigma: float) -> Staircase | None:
    """What the steps of a coarse gauge add, in sigmas of its channel."""
    values, quantum = each.channel.values, each.channel.quantum
    if not quantum > 0.0:
        return None
    # Rounding is part of both; a misfit is part of the residuals only.
    whole = min(noise_of(values, each.channel.time), sigma * float(np.sqrt(np.mean(residual**2))))
    noise = float(np.sqrt(max(0.0, whole**2 - quantum**2 / 12.0)))
    return staircase(values / sigma + residual, quantum / sigma, noise / sigma)


# Numbers ----------------------------------------------------------------------------------------------------------


def numbers(fit: CompletedFit) -> Iterator[Note]:
    """Numbers at a bound, that did not move, or that the data do not determine."""
    for f in fit.free:
        e = fit.estimates[f.name]
        is_low = e.value <= f.low + 1e-6 * f.scale
        cases = {
            "bound": e.verdict == "at bound",
            "not_determined": e.verdict == "not determined",
            "not_moved": e.value == f.start,
            "weak": e.verdict == "weak",
        }
        # The first that holds: of a number at its bound nothing else is worth a word.
        if case := next((case for case, holds in cases.items() if holds), None):
            facts = {"value": e.value, "error": e.standard_error, "low": e.low, "high": e.high, "unit": f.unit}
            yield Note(f"finding.number.{case}", f.name, **facts, **({"is_low": is_low} if case == "bound" else {}))


def choking(fit: CompletedFit) -> Iterator[Note]:
    """Critical ratios of passages that were choked, or were never choked, in all recordings."""
    for f in fit.free:
        owner, _, local = f.address.rpartition(".")
        if local != "critical_ratio":
            continue
        regimes = np.concatenate([_regimes(e, owner, fit.values) for e in fit.experiments] or [np.zeros(0)])
        seen = np.abs(regimes[regimes != 0.0])  # 0: no flow
        if seen.size and np.all(seen == 3.0):
            yield Note("finding.choking.throughout", f.name, passage=owner)
        elif seen.size and not np.any(seen == 3.0) and fit.values[f.name] > f.low:
            e = fit.estimates[f.name]
            yield Note("finding.choking.never", owner, number=f.name, value=e.value, low=e.low, high=e.high)


def _regimes(experiment: Experiment, owner: str, values: Mapping[str, float]) -> FloatArray:
    run, outputs = experiment.everything(values)
    return np.asarray(run.values[outputs.index(f"{owner}.regime")]) if f"{owner}.regime" in outputs else np.zeros(0)


def references(fit: CompletedFit) -> Iterator[Note]:
    """Gauge pressures read as absolute, where the critical ratio suffers: a tank then seems to empty to a vacuum.

    Not where it was evacuated indeed: it rises from there, or the circuit knows of a pressure as low.
    """
    lost = [f.name for f in fit.free if f.address.endswith(".critical_ratio") and fit.estimates[f.name].verdict in LOST]
    pressures = [(e, c) for e in fit.experiments for c in e.measurement.channels if c.unit == "Pa"]
    for e, channel in pressures if lost else []:
        floor, ambient = float(np.min(channel.values)), float(e.measurement.ambient_pressure)
        is_said = any(
            (note.code, note.address) == ("suspicion.read_as_absolute", channel.address)
            for note in e.measurement.findings
        )
        is_low = floor < BELOW * ambient and not is_evacuated(channel.values, ambient) and not _has_vacuum(e)
        if is_low and not is_said:
            number, verdict = lost[0], fit.estimates[lost[0]].verdict
            facts = {"floor": 1e-5 * floor, "ambient": 1e-5 * ambient, "number": number, "verdict": verdict}
            yield Note("finding.gauge", f"{e.name}.{channel.address}", **facts)


def _has_vacuum(e: Experiment) -> bool:
    """Whether a pressure that was given, not fitted or recorded, lies far below the ambient."""
    open_ = {f.address for f in e.free} | {a for a, given in e.measurement.start.items() if given in ("first", "free")}
    given = [a for a in e.instance.parameters if a not in open_ and a.endswith((".pressure", ".initial_pressure"))]
    return any(e.instance.parameters[a] < BELOW * e.measurement.ambient_pressure for a in given)


def alike(fit: CompletedFit) -> Iterator[Note]:
    """The combination of numbers that the data see least, where it matters, and what they see instead."""
    x = fit.optimum.x
    inside = [k for k in range(len(fit.free)) if fit.optimum.active[k] == 0 and x[k] != 0.0]
    if len(inside) < 2:
        return
    u, s, vt = np.linalg.svd(fit.optimum.jacobian[:, inside] * x[inside], full_matrices=False)
    if s[-1] > UNSEEN_TOGETHER and s[-1] > 1e-4 * s[0]:
        return
    direction = vt[-1] / np.max(np.abs(vt[-1]))
    shares = {k: float(share) for k, share in enumerate(direction) if abs(share) > 0.2}
    if len(shares) < 2:
        return
    names = [fit.free[k].name for k in inside]
    is_scaled = len({share > 0.0 for share in shares.values()}) == 1
    changes = {names[k]: share for k, share in shares.items()}
    way = "scaled" if is_scaled else "changed"
    yield Note(f"finding.alike.{way}", names=tuple(changes), shares=changes, sigmas=0.01 * float(s[-1]))
    yield Note(f"finding.tell_apart.{_remedy(changes)}", names=tuple(changes))
    if not is_scaled:
        return
    # Ratios of numbers that are scaled together, where the data determine these; in logarithms a ratio is a difference.
    moved = (vt[:-1].T / s[:-1]) @ u[:, :-1].T
    below = next((k for k in shares if names[k].endswith(".volume")), next(iter(shares)))
    for above in shares:
        # Only where both move by the same factor does their ratio stay as it is.
        if above == below or not 0.9 < shares[above] / shares[below] < 1.1:
            continue
        error = 1.96 * fit.spread.deviation(moved[above] - moved[below])
        if error < np.log(2.0):
            ratio, factor = float(x[inside[above]] / x[inside[below]]), float(np.exp(error))
            units = {"unit": fit.free[inside[above]].unit, "per": fit.free[inside[below]].unit}
            facts = {"value": ratio, "low": ratio / factor, "high": ratio * factor, **units}
            yield Note("finding.ratio", names[above], over=names[below], **facts)


def _remedy(names: Mapping[str, float]) -> str:
    kinds = {name.rpartition(".")[2] for name in names}
    if "volume" in kinds and kinds & {"sonic_conductance", "effective_area"}:
        return "volume"
    if "wall_conductance" in kinds and kinds & {"sonic_conductance", "effective_area"}:
        return "wall"
    return "ratio" if "critical_ratio" in kinds else "other"


# Recordings and repetitions ---------------------------------------------------------------------------------------


def suspicions(fit: CompletedFit) -> Iterator[Note]:
    """What looks wrong with the recordings."""
    return (note.within(e.name) for e in fit.experiments for note in e.measurement.findings)


def recorded(fit: CompletedFit) -> Iterator[Note]:
    """What was guessed, merged or left out in reading them."""
    return (note.within(e.name) for e in fit.experiments for note in e.measurement.notes)


def trials(fit: CompletedFit) -> Iterator[Note]:
    """How well the recordings are fitted with other critical ratios, where they do not determine one."""

    def first_rms(x: FloatArray) -> float:
        return shown(fit.experiments[:1], by_name(fit.free, x))[0].summary().rms

    begun = begun_at(fit.free, fit.optimum.x)
    quiet = SearchSettings(fit.settings.loss)
    for f in fit.free:
        if not f.address.endswith(".critical_ratio") or fit.estimates[f.name].verdict == "determined":
            continue
        others = [
            optimise(fit.experiments, begun, quiet, sigmas=fit.optimum.sigmas, held={f.name: ratio}).x
            for ratio in TRIAL_RATIOS
        ]
        first = fit.channels[0]
        facts = {"rms": first_rms(fit.optimum.x), "others": tuple(map(first_rms, others)), "unit": first.channel.unit}
        yield Note("finding.trials", f.name, channel=first.name, ratios=TRIAL_RATIOS, **facts)


COLLECTORS: tuple[Callable[[CompletedFit], Iterator[Note]], ...] = (
    interruption,
    suspicions,
    offsets,
    local_misfit,
    sampling,
    references,
    choking,
    alike,
    numbers,
    residuals,
    recorded,
)
"""Where findings come from, the most important first; `trials` cost further searches and are asked for."""

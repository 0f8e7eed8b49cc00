"""What a reader of a fit has to know, in sentences with numbers, and the test that would resolve what stays open."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.search import Optimum
from poppet.identify.fit.spread import Offset, Spread, pulls
from poppet.identify.fit.whiteness import correlation_time, is_white
from poppet.identify.free import Free
from poppet.identify.result import Estimate, behind

Array = NDArray[np.float64]

BELOW = 0.5
"""Part of the ambient pressure: circuits for compressed air seldom rest below."""
BLIND = 3e-3
"""Change of the fit, in sigmas over all samples per relative change of one, below which a direction is unseen."""
TOLD, VISIBLE = 0.1, 0.4
"""An offset is named where it widens an interval by that part, or where the model is off by so many sigmas."""
LOCAL = 1.5
"""Factor on an interval from which misfit in few samples is named."""
LOST = ("at bound", "not determined")
_GAS = ("sonic_conductance", "volume", "wall_conductance", "effective_area", "wall_heat_capacity")


def direction_findings(free: Sequence[Free], optimum: Optimum, spread: Spread) -> list[str]:
    """The combination of numbers that the data see least, where it matters, and what they see instead."""
    inside = [k for k in range(len(free)) if optimum.active[k] == 0 and optimum.x[k] != 0.0]
    if len(inside) < 2:
        return []
    relative = optimum.jacobian[:, inside] * optimum.x[inside]
    _, s, vt = np.linalg.svd(relative, full_matrices=False)
    if s[-1] > 1.0 / 0.25 and s[-1] > 1e-4 * s[0]:
        return []
    direction = vt[-1] / np.max(np.abs(vt[-1]))
    together = [(free[k].name, float(d)) for k, d in zip(inside, direction, strict=True) if abs(d) > 0.2]
    if len(together) < 2:
        return []
    names = [name for name, _ in together]
    same = all(d > 0 for _, d in together) or all(d < 0 for _, d in together)
    how = "scaled together" if same else "changed together (" + ", ".join(f"{n} {d:+.2f}" for n, d in together) + ")"
    sentence = (
        f"These data cannot tell {_listed(names)} apart: {how} they leave the fit as it is "
        f"(1 % of each changes it by {0.01 * s[-1]:.2g} sigma over all samples). {_remedy(names)}"
    )
    return [sentence, *_ratios(together, free, optimum, relative, inside, spread)] if same else [sentence]


def _ratios(
    together: Sequence[tuple[str, float]],
    free: Sequence[Free],
    optimum: Optimum,
    relative: Array,
    inside: Sequence[int],
    spread: Spread,
) -> list[str]:
    """Ratios of numbers that the data cannot tell apart, where they determine these; from logarithms."""
    u, s, vt = np.linalg.svd(relative, full_matrices=False)
    moved = (vt[:-1].T / s[:-1]) @ u[:, :-1].T
    names = [free[k].name for k in inside]
    below = next((name for name, _ in together if name.endswith(".volume")), together[0][0])
    weight = dict(together)
    sentences = []
    for above, _ in together:
        # Only where both move by the same factor does their ratio stay as it is.
        if above == below or not 0.9 < weight[above] / weight[below] < 1.1:
            continue
        a, b = names.index(above), names.index(below)
        error = 1.96 * spread.deviation(moved[a] - moved[b])
        ratio = float(optimum.x[inside[a]] / optimum.x[inside[b]])
        if error < np.log(2.0):
            sentences.append(
                f"What they determine: {above} / {below} = {ratio:.4g} ({ratio * np.exp(-error):.4g} ... "
                f"{ratio * np.exp(error):.4g}, 95 %), in {free[inside[a]].unit} per {free[inside[b]].unit}."
            )
    return sentences


def _listed(names: Sequence[str]) -> str:
    return " and ".join([", ".join(names[:-1]), names[-1]]) if len(names) > 1 else names[0]


def _remedy(names: Sequence[str]) -> str:
    kinds = {name.rsplit(".", 1)[-1] for name in names}
    if "volume" in kinds and kinds & {"sonic_conductance", "effective_area"}:
        return "Measure the volume (or a mass flow rate) and fix it."
    if "wall_conductance" in kinds and kinds & {"sonic_conductance", "effective_area"}:
        return "Record the gas temperature, or go on recording the pressure after the flow has stopped."
    if "critical_ratio" in kinds:
        return "Add samples on both sides of the choking limit."
    return "Fix one of them, or add a recording in which they act differently."


def estimate_findings(free: Sequence[Free], found: Mapping[str, Estimate]) -> list[str]:
    """Numbers at a bound, that did not move, or that the data do not determine."""
    sentences = []
    for f in free:
        e = found[f.name]
        unit = behind(f.unit)
        if e.verdict == "at bound":
            bound = "lower" if e.value <= f.low + 1e-6 * f.scale else "upper"
            sentences.append(f"{f.name} ran to its {bound} bound, {e.value:.6g}{unit}: its value is not to be trusted.")
        elif e.verdict == "not determined":
            sentences.append(
                f"{f.name} is not determined by these data: {e.value:.4g} +/- {e.standard_error:.2g}{unit}."
            )
        elif e.value == f.start:
            sentences.append(f"{f.name} has not moved from its start, {f.start:.6g}{unit}.")
        elif e.verdict == "weak":
            sentences.append(f"{f.name} is weakly determined: {e.low:.4g} ... {e.high:.4g}{unit} (95 %).")
    return sentences


def choking_findings(experiments: Sequence[Experiment], free: Sequence[Free], values: Mapping[str, float]) -> list[str]:
    """Critical ratios of passages that were choked, or were never choked, in all recordings."""
    sentences = []
    for f in free:
        owner, _, local = f.address.rpartition(".")
        if local != "critical_ratio":
            continue
        codes = [_regimes(e, owner, values) for e in experiments]
        seen = np.concatenate(codes) if codes else np.zeros(0)
        seen = np.abs(seen[seen != 0.0])
        if seen.size and np.all(seen == 3.0):
            sentences.append(
                f"{f.name} is not determined: {owner} was choked throughout, and choked flow does not depend on it. "
                "Go on until the downstream pressure is near the upstream one."
            )
        elif seen.size and not np.any(seen == 3.0) and values[f.name] > f.low:
            sentences.append(
                f"{owner} was never choked in these data: its conductance and critical ratio rest on subsonic flow "
                "alone. Add a test with a larger pressure ratio."
            )
    return sentences


def sampled_findings(experiments: Sequence[Experiment]) -> list[str]:
    """What intervals do not hold where a program samples."""
    names = [e.name for e in experiments if e.samples]
    if not names:
        return []
    return [
        f"{', '.join(names)}: a program samples in the circuit, so that the answer is smooth in the numbers on the "
        "whole only. The intervals hold the noise and not these pieces: they may be too narrow by several times. Fit "
        "a second recording and see how far the numbers move."
    ]


def reference_findings(
    experiments: Sequence[Experiment], free: Sequence[Free], found: Mapping[str, Estimate]
) -> list[str]:
    """Gauge pressures read as absolute, where the critical ratio suffers: a tank then seems to empty to a vacuum."""
    lost = [f.name for f in free if f.address.endswith(".critical_ratio") and found[f.name].verdict in LOST]
    sentences = []
    pressures = [(e, c) for e in experiments for c in e.measurement.channels if c.unit == "Pa"]
    for e, channel in pressures if lost else []:
        floor, ambient = float(np.min(channel.values)), float(e.measurement.ambient_pressure)
        is_said = any(
            (note.code, note.address) == ("suspicion.read_as_absolute", channel.address)
            for note in e.measurement.findings
        )
        if floor < BELOW * ambient and not is_said:
            sentences.append(
                f"{e.name}.{channel.address} goes down to {1e-5 * floor:.3g} bar absolute, far below the ambient of "
                f"{1e-5 * ambient:.4g} bar, and {lost[0]} is {found[lost[0]].verdict}: a gauge pressure read as "
                'absolute? Then write its unit with "g", "bar g".'
            )
    return sentences


def _regimes(experiment: Experiment, owner: str, values: Mapping[str, float]) -> Array:
    run, outputs = experiment.everything({f.name: values[f.name] for f in experiment.free})
    return np.asarray(run.values[outputs.index(f"{owner}.regime")]) if f"{owner}.regime" in outputs else np.zeros(0)


def residual_findings(name: str, residual: Array, sigma: float, unit: str) -> tuple[list[str], float]:
    """Whether the residuals of a channel are white and as small as the noise; and the widening they call for."""
    sentences = []
    spread = float(np.mean(residual**2))
    widening = max(1.0, spread)
    if spread > 2.0:
        sentences.append(
            f"{name}: the residuals are {np.sqrt(spread):.2g} times the noise ({sigma:.3g}{behind(unit)}): the model "
            "misses something, and the intervals are widened by as much."
        )
    if not is_white(residual):
        samples = correlation_time(residual)
        widening *= samples
        if samples > 1.5:
            sentences.append(
                f"{name}: the residuals are not white ({samples:.1f} samples count as one): the model "
                "misses something, and the intervals are widened for it."
            )
    return sentences, widening


def offset_findings(
    names: Sequence[tuple[str, str]], free: Sequence[Free], optimum: Optimum, spread: Spread
) -> list[str]:
    """Channels that are missed by a constant, and what this adds to the intervals."""
    rows, sentences = pulls(optimum), []
    for offset in spread.offsets:
        (name, unit), sigma = names[offset.channel], optimum.sigmas[offset.channel]
        growth = _growth(free, rows, spread, offset)
        told = [(n, g) for n, g in growth.items() if g >= 1.0 + TOLD]
        if not told and abs(offset.bias) < VISIBLE:
            continue
        told = sorted(told, key=lambda each: -each[1])
        shares = _listed([f"of {n} {g:.3g} times" for n, g in told]) if told else ""
        effect = f"makes the interval {shares} as wide" if told else f"adds less than {100.0 * TOLD:.0f} % to any"
        bias, size = (f"{abs(each) * sigma:.3g}{behind(unit)}" for each in (offset.bias, offset.size))
        sentences.append(
            f"{name}: the model lies {bias} {'above' if offset.bias > 0.0 else 'below'} the measurement on the whole: "
            f"a sensor's offset, perhaps. If this sensor alone is off, it reads {size} too "
            f"{'high' if offset.size > 0.0 else 'low'}. The intervals include it; that {effect}."
        )
    return sentences


def _growth(free: Sequence[Free], rows: Array, spread: Spread, offset: Offset) -> dict[str, float]:
    """By what factor an offset widens the interval of each number."""
    growth = {}
    for f, pull in zip(free, rows, strict=True):
        before = spread.deviation(pull, offsets=())
        if 0.0 < before < np.inf:
            growth[f.name] = spread.deviation(pull, offsets=(offset,)) / before
    return growth


def local_findings(free: Sequence[Free], optimum: Optimum, spread: Spread) -> list[str]:
    """Numbers that the misfit moves more than its mean over all samples says."""
    names = [f.name for f, pull in zip(free, pulls(optimum), strict=True) if spread.is_local(pull, LOCAL)]
    if not names:
        return []
    return [
        f"The misfit acts on {_listed(names)} more than its mean says: it lies where the data determine them, or "
        "lasts. Their intervals are widened for it, but their values may be biased: look at the residuals, and free "
        "what is held fixed."
    ]


def said_of(experiments: Sequence[Any]) -> list[str]:
    """What reading the recordings brought to light."""
    return [f"{e.name}: {text}" for e in experiments for text in (*e.measurement.findings, *e.measurement.notes)]

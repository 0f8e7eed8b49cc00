"""What a reader of a fit has to know, in sentences with numbers, and the test that would resolve what stays open."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.identify.experiment import Experiment
from poppet.identify.fit import Optimum
from poppet.identify.free import Free
from poppet.identify.result import Estimate
from poppet.identify.whiteness import correlation_time, is_white

Array = NDArray[np.float64]

BLIND = 3e-3
"""Change of the fit, in sigmas over all samples per relative change of one, below which a direction is unseen."""
STRONG = 0.95
_GAS = ("sonic_conductance", "volume", "wall_conductance", "effective_area", "wall_heat_capacity")


def direction_findings(free: Sequence[Free], optimum: Optimum, widening: float = 1.0) -> list[str]:
    """The combination of numbers that the data see least, where it matters, and what they see instead.

    Parameters
    ----------
    free : sequence of Free
        Free numbers.
    optimum : Optimum
        Where the search ended.
    widening : float, optional
        Factor on the variances.

    Returns
    -------
    list of str
        Sentences.
    """
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
    return [sentence, *_ratios(together, free, optimum, relative, inside, widening)] if same else [sentence]


def _ratios(
    together: Sequence[tuple[str, float]],
    free: Sequence[Free],
    optimum: Optimum,
    relative: Array,
    inside: Sequence[int],
    widening: float,
) -> list[str]:
    """Ratios of numbers that the data cannot tell apart, where they determine these; from logarithms."""
    _, s, vt = np.linalg.svd(relative, full_matrices=False)
    seen = vt[:-1] / s[:-1, None]
    names = [free[k].name for k in inside]
    below = next((name for name, _ in together if name.endswith(".volume")), together[0][0])
    weight = dict(together)
    sentences = []
    for above, _ in together:
        # Only where both move by the same factor does their ratio stay as it is.
        if above == below or not 0.9 < weight[above] / weight[below] < 1.1:
            continue
        a, b = names.index(above), names.index(below)
        error = 1.96 * float(np.linalg.norm(seen[:, a] - seen[:, b])) * float(np.sqrt(widening))
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
        unit = "" if f.unit == "1" else f" {f.unit}"
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


def _regimes(experiment: Experiment, owner: str, values: Mapping[str, float]) -> Array:
    run, outputs = experiment.everything({f.name: values[f.name] for f in experiment.free})
    return np.asarray(run.values[outputs.index(f"{owner}.regime")]) if f"{owner}.regime" in outputs else np.zeros(0)


def residual_findings(name: str, residual: Array, sigma: float, unit: str) -> tuple[list[str], float]:
    """Whether the residuals of a channel are white and as small as the noise; and the widening they call for.

    Parameters
    ----------
    name : str
        Channel.
    residual : (n,) array
        Model minus measurement, in sigmas.
    sigma : float
        Noise, in `unit`.
    unit : str
        SI unit.

    Returns
    -------
    tuple of (list of str, float)
        Sentences and the factor on the variances.
    """
    sentences = []
    spread = float(np.mean(residual**2))
    widening = max(1.0, spread)
    if spread > 2.0:
        sentences.append(
            f"{name}: the residuals are {np.sqrt(spread):.2g} times the noise ({sigma:.3g} {unit}): the model misses "
            "something, and the intervals are widened by as much."
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


def notes_of(experiments: Sequence[Any]) -> list[str]:
    """What reading the recordings brought to light."""
    return [f"{e.name}: {text}" for e in experiments for text in (*e.measurement.findings, *e.measurement.notes)]

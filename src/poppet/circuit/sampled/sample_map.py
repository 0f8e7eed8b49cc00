"""The linear map over one sample: instants and matrix exponentials between them."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.linear_model import balance
from poppet.circuit.sampled.point import IntersampleModel, SampledPoint

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Phase:
    """An instant and the time until the next, in units of the variables' sizes."""

    duration: float  # until the next instant or the end of the sample [s]
    # What the instant makes of v, and what the inputs add
    at_v: Array
    at_u: Array
    # Rates between instants; those of the memory are zero
    rates_v: Array
    rates_u: Array
    # What the time until the next instant makes of v, and what held inputs add
    flow_v: Array
    flow_u: Array


def phases_of(point: SampledPoint, v: Array, between: IntersampleModel | None = None) -> tuple[Phase, ...]:
    """The phases of one sample at a rest."""
    b = between or point.between(v)
    n, size, clock = v.size, point.size, point.clock
    # Rows of the memory stay zero: nothing changes it between instants.
    rates_v, rates_u = np.zeros((n, n)), np.zeros((n, point.u.size))
    rates_v[: point.n] = b.rates_by_v * size[None, :] / size[: point.n, None]
    rates_u[: point.n] = b.rates_by_u / size[: point.n, None]
    phases = []
    for fired, duration in zip(clock.fired, np.diff([*clock.times, clock.sample_time]), strict=True):
        _, w_v, w_u = point.instant(v, fired)
        at_v, at_u = np.eye(n), np.zeros((n, point.u.size))
        at_v[point.n :] = w_v * size[None, :] / size[point.n :, None]
        at_u[point.n :] = w_u / size[point.n :, None]
        phases.append(Phase(float(duration), at_v, at_u, rates_v, rates_u, *_flow(rates_v, rates_u, float(duration))))
    return tuple(phases)


def _flow(rates_v: Array, rates_u: Array, duration: float) -> tuple[Array, Array]:
    """Exponential of the continuous part, with inputs held."""
    from scipy.linalg import expm

    n, m = rates_u.shape
    whole = np.zeros((n + m, n + m))
    # Inputs have units of their own: brought to the size of what they do.
    scale = np.maximum(np.abs(rates_u).max(axis=0, initial=0.0), 1e-300)
    whole[:n, :n], whole[:n, n:] = rates_v, rates_u / scale
    result = expm(whole * duration)
    return result[:n, :n], result[:n, n:] * scale


def sample_map(point: SampledPoint, phases: tuple[Phase, ...]) -> tuple[Array, Array]:
    """A and B over one sample, in units of the sizes of the variables."""
    a, b = np.eye(point.size.size), np.zeros((point.size.size, point.u.size))
    for phase in phases:
        a, b = phase.at_v @ a, phase.at_v @ b + phase.at_u
        a, b = phase.flow_v @ a, phase.flow_v @ b + phase.flow_u
    return a, b


def eigenvalues_of(a: Array) -> NDArray[np.complex128]:
    """Eigenvalues of a map over a sample."""
    kept = np.arange(len(a))
    while True:
        part = a[np.ix_(kept, kept)]
        used = (np.abs(part).max(axis=0, initial=0.0) > 0.0) & (np.abs(part).max(axis=1, initial=0.0) > 0.0)
        if used.all():
            break
        kept = kept[used]
    values = np.zeros(len(a), dtype=np.complex128)
    if kept.size:
        # Rows or columns of zeros are taken out before: balancing would divide by their size.
        scale = balance(part)
        values[: kept.size] = np.linalg.eigvals(part * scale[None, :] / scale[:, None])
    return values

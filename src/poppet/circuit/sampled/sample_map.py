"""Linear map of the variables over one sample.

It is a product of the maps at sample instants and of matrix exponentials between them.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.linear_model import balancing_scale
from poppet.circuit.sampled.point import IntersampleModel, SampledPoint

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Phase:
    """Linear maps of the variables from one sample instant to the next.

    All variables are in units of their typical sizes.
    """

    duration: float  # until the next instant or the end of the sample [s]
    # v after the instant, by v and by the inputs
    at_v: Array
    at_u: Array
    # Rates between instants; zero for discrete states
    rates_v: Array
    rates_u: Array
    # v before the next instant, by v and by constant inputs
    flow_v: Array
    flow_u: Array


def phases_of(point: SampledPoint, v: Array, between: IntersampleModel | None = None) -> tuple[Phase, ...]:
    """Return the linear maps of all phases of one sample period.

    A phase is a sample instant with the time until the next instant. The maps are valid near the steady state `v`.
    `between` contains the derivatives between instants if they have already been computed.
    """
    from scipy.linalg import expm

    b = between or point.between(v)
    n, size, clock = v.size, point.size, point.clock
    # Rows of discrete states remain zero: they are constant between instants.
    rates_v, rates_u = np.zeros((n, n)), np.zeros((n, point.u.size))
    rates_v[: point.n] = b.rates_by_v * size[None, :] / size[: point.n, None]
    rates_u[: point.n] = b.rates_by_u / size[: point.n, None]
    # The maps of variables and constant inputs over a duration are blocks of the matrix exponential of the rates.
    # Columns of inputs are scaled to unit size.
    scale = np.maximum(np.abs(rates_u).max(axis=0, initial=0.0), 1e-300)
    combined = np.zeros((n + point.u.size, n + point.u.size))
    combined[:n, :n], combined[:n, n:] = rates_v, rates_u / scale
    phases = []
    for fired, duration in zip(clock.fired, np.diff([*clock.times, clock.sample_time]), strict=True):
        _, w_v, w_u = point.instant(v, fired)
        at_v, at_u = np.eye(n), np.zeros((n, point.u.size))
        at_v[point.n :] = w_v * size[None, :] / size[point.n :, None]
        at_u[point.n :] = w_u / size[point.n :, None]
        flow = expm(combined * float(duration))
        phases.append(Phase(float(duration), at_v, at_u, rates_v, rates_u, flow[:n, :n], flow[:n, n:] * scale))
    return tuple(phases)


def sample_map(point: SampledPoint, phases: tuple[Phase, ...]) -> tuple[Array, Array]:
    """Return the matrices A and B that map states and inputs from one sample to the next.

    `phases` are the linear maps within one sample period.
    """
    a, b = np.eye(point.size.size), np.zeros((point.size.size, point.u.size))
    for phase in phases:
        a, b = phase.at_v @ a, phase.at_v @ b + phase.at_u
        a, b = phase.flow_v @ a, phase.flow_v @ b + phase.flow_u
    return a, b


def eigenvalues_of(a: Array) -> NDArray[np.complex128]:
    """Return the eigenvalues of a matrix.

    `a` maps the variables from one sample to the next, so some of its rows and columns can be zero.
    """
    # Without rows or columns of zeros: balancing would divide by their size.
    rows = np.arange(len(a))
    while True:
        part = a[np.ix_(rows, rows)]
        is_used = (np.abs(part).max(axis=0, initial=0.0) > 0.0) & (np.abs(part).max(axis=1, initial=0.0) > 0.0)
        if is_used.all():
            break
        rows = rows[is_used]
    values = np.zeros(len(a), dtype=np.complex128)
    if rows.size:
        scale = balancing_scale(part)
        values[: rows.size] = np.linalg.eigvals(part * scale[None, :] / scale[:, None])
    return values

"""Parameter values of all runs: random sample, tornado chart and Sobol indices."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from poppet.ensemble.ensemble_plan import Array, EnsemblePlan
from poppet.ensemble.sampling import points

KINDS = ("runs", "tornado", "indices")
LOW, HIGH = 0.05, 0.95
"""Low and high probability of the quantiles of a parameter in a tornado chart."""


@dataclass(frozen=True)
class RunDesign:
    """Runs of one kind: number of runs, runs per shard, and parameter values."""

    size: int
    shard: int
    values: Callable[[int, int], Array]  # parameters of the runs from a first to a last one, (m, n)


def design_of(plan: EnsemblePlan, kind: str) -> RunDesign:
    """Return the design of the runs of one kind: `runs`, `tornado` or `indices`."""
    if kind == "runs":
        return RunDesign(plan.runs, plan.shard, plan.sample)
    if kind == "tornado":
        n = len(plan.addresses)
        return RunDesign(2 * n + 1, 1024, lambda first, last: _tornado(plan)[first:last])
    size = plan.indices * (len(plan.factors) + 2)
    return RunDesign(size, min(plan.shard, 4096), lambda first, last: _saltelli(plan, first, last))


def _tornado(plan: EnsemblePlan) -> Array:
    """Return the parameter values of the runs for a tornado chart.

    The first run has the median of all parameters. Two further runs for each parameter have a low and a high quantile
    of it, with the medians of all other parameters.
    """
    middle = np.array([plan.quantile(address, 0.5) for address in plan.addresses])
    values = np.tile(middle, (2 * len(middle) + 1, 1))
    for k, address in enumerate(plan.addresses):
        values[1 + 2 * k, k], values[2 + 2 * k, k] = (plan.quantile(address, u) for u in (LOW, HIGH))
    return values


def _saltelli(plan: EnsemblePlan, first: int, last: int) -> Array:
    """Return the parameter values of the runs for Sobol indices, from run `first` up to run `last` (excluded).

    The runs form blocks: A, B, and one block for each factor. The block of a factor is a copy of A with the columns of
    that factor from B.

    A and B are halves of one Sobol sequence of twice the dimension (Saltelli et al., Comput. Phys. Commun. 181, 2010).
    """
    n, base = len(plan.addresses), plan.indices
    runs = np.arange(first, last)
    block, row = runs // base, runs % base
    values = np.empty((runs.size, n))
    factors = list(plan.factors.values())
    for block_index in np.unique(block):
        rows = row[block == block_index]
        # Another seed: the points must differ from those of the sample.
        points_ab = points("sobol", plan.seed + 1, base, 2 * n, int(rows[0]), int(rows[-1]) + 1, ())
        u = points_ab[:, n:].copy() if block_index == 1 else points_ab[:, :n].copy()
        if block_index >= 2:
            columns = list(factors[block_index - 2])
            u[:, columns] = points_ab[:, n:][:, columns]
        values[block == block_index] = plan.values(u)
    return values

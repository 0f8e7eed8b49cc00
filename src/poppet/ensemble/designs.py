"""Which numbers the runs of an ensemble have: those of the sample, and of what tells the influence of each number."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from poppet.ensemble.ensemble_plan import Array, EnsemblePlan
from poppet.ensemble.sampling import points

KINDS = ("runs", "tornado", "indices")
LOW, HIGH = 0.05, 0.95
"""Quantiles of a number between which a tornado moves it."""


@dataclass(frozen=True)
class Design:
    """Runs of a kind."""

    size: int
    shard: int
    values: Callable[[int, int], Array]  # numbers of some of the runs, (m, n)


def design_of(plan: EnsemblePlan, kind: str) -> Design:
    """The runs of a kind: `runs`, `tornado`, `indices`."""
    if kind == "runs":
        return Design(plan.runs, plan.shard, plan.sample)
    if kind == "tornado":
        n = len(plan.addresses)
        return Design(2 * n + 1, 1024, lambda first, last: _tornado(plan)[first:last])
    size = plan.indices * (len(plan.factors) + 2)
    return Design(size, min(plan.shard, 4096), lambda first, last: _saltelli(plan, first, last))


def _tornado(plan: EnsemblePlan) -> Array:
    """All medians, then each number at its low and its high quantile beside the medians of the others."""
    middle = np.array([plan.quantile(address, 0.5) for address in plan.addresses])
    found = np.tile(middle, (2 * len(middle) + 1, 1))
    for k, address in enumerate(plan.addresses):
        found[1 + 2 * k, k], found[2 + 2 * k, k] = (plan.quantile(address, u) for u in (LOW, HIGH))
    return found


def _saltelli(plan: EnsemblePlan, first: int, last: int) -> Array:
    """Blocks of A, of B, and for each factor of A with the columns of that factor from B.

    A and B are halves of one Sobol sequence of twice the dimension (Saltelli et al., Comput. Phys. Commun. 181, 2010).
    """
    n, base = len(plan.addresses), plan.indices
    runs = np.arange(first, last)
    block, row = runs // base, runs % base
    found = np.empty((runs.size, n))
    factors = list(plan.factors.values())
    for each in np.unique(block):
        own = row[block == each]
        # A stream of its own: the sample must not repeat itself here.
        both = points("sobol", plan.seed + 1, base, 2 * n, int(own[0]), int(own[-1]) + 1, ())
        u = both[:, n:].copy() if each == 1 else both[:, :n].copy()
        if each >= 2:
            columns = list(factors[each - 2])
            u[:, columns] = both[:, n:][:, columns]
        found[block == each] = plan.values(u)
    return found

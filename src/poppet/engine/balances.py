"""Conservation over a run: what a store has gained must be the sum of what the integrals say went in."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from poppet.engine.model import Balance
from poppet.engine.problem import Array, Problem, RawRun

ALLOWED = {"mass": 1e-9, "energy": 1e-7, "motion": 1e-4}
"""Part of what went through that may be missing in a balance of a correct run: rounding, and for the energy of a body,
which is not linear in the states, the tolerance."""
FLOOR = {"mass": 0.0, "energy": 0.0, "motion": 1e-7}
"""And beyond that: the speed of a body that hardly moves is known no better than its absolute tolerance [SI]."""
STORED = 1e-12
"""And part of the inventory."""
UNITS = {"mass": "kg", "energy": "J", "motion": "J"}


class Residual(NamedTuple):
    """Conservation over a run."""

    store: str
    quantity: str  # mass, energy or motion
    unit: str
    error: float  # |change of inventory - integral of the flows|
    through: float  # integral of |flows|
    inventory: float  # largest inventory of start and end

    @property
    def name(self) -> str:
        """Store and quantity, `tank mass`."""
        return f"{self.store} {self.quantity}"

    @property
    def allowed(self) -> float:
        """What a correct run may show: 1e-9 of the mass and 1e-7 of the energy that went through, and 1e-12 of the
        inventory; of the energy of a body 1e-4 of what was done on it and 1e-7 J."""
        return float(allowed(self.quantity, self.through, self.inventory))

    @property
    def is_kept(self) -> bool:
        """True when the balance holds."""
        return self.error <= self.allowed


def allowed(quantity: str, through: Any, inventory: Any) -> Any:
    """`Residual.allowed`, of numbers and of arrays alike."""
    return ALLOWED[quantity] * through + FLOOR[quantity] + STORED * inventory


def missing(balance: Balance, start: Any, end: Any, x: Any, through: Any) -> tuple[Any, Any]:
    """What is missing in a balance, and what went through; each element of a sequence may be one of many runs.

    Given are inventories at start and end, and of each state the value at the end and the sum of |change|.
    """
    net: Any = 0.0
    gross: Any = 0.0
    for sign, place in balance.integrals:
        net += sign * x[place]
        gross += through[place]
    return abs(end[balance.inventory] - start[balance.inventory] - net), gross


def residuals(problem: Problem, run: RawRun) -> tuple[Residual, ...]:
    """Mass residual of every store with a mass and energy residual of every store with an energy balance."""
    # Python floats: single elements of arrays take ten times as long to read.
    x, through = run.x.tolist(), run.through.tolist()
    before = problem.x0.tolist(), *energies(problem, problem.x0, run.x)
    found = []
    for b in problem.kernel.model.balances:
        start, end = (before[0], x) if b.quantity == "mass" else before[1:]
        error, gross = missing(b, start, end, x, through)
        inventory = max(start[b.inventory], end[b.inventory])
        found.append(Residual(b.store, b.quantity, UNITS[b.quantity], error, gross, inventory))
    return tuple(found)


def energies(problem: Problem, *states: Array) -> list[list[float]]:
    """Energies of the stores that have a balance of it, in several states."""
    model = problem.kernel.model
    energy, x = np.empty(model.n_energies), np.empty(model.size)
    if not energy.size:
        return [[] for _ in states]
    t, u, found = np.zeros(1), np.zeros(len(model.inputs) or 1), []
    call = problem.kernel.caller("energy", t, x, u, problem.p, energy)
    # Into the same arrays, whose addresses the caller has already.
    for state in states:
        x[:] = state
        call()
        found.append(energy.tolist())
    return found

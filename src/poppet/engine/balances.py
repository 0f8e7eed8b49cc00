"""Conservation over a run: what a store has gained must be the sum of what the integrals say went in."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

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
        return ALLOWED[self.quantity] * self.through + FLOOR[self.quantity] + STORED * self.inventory

    @property
    def is_kept(self) -> bool:
        """True when the balance holds."""
        return self.error <= self.allowed


def residuals(problem: Problem, run: RawRun) -> tuple[Residual, ...]:
    """Mass residual of every store with a mass and energy residual of every store with an energy balance."""
    # Python floats: single elements of arrays take ten times as long to read.
    x, through = run.x.tolist(), run.through.tolist()
    before = problem.x0.tolist(), *_energies(problem, problem.x0, run.x)
    found = []
    for b in problem.kernel.model.balances:
        start, end = (before[0], x) if b.quantity == "mass" else before[1:]
        net = gross = 0.0
        for sign, place in b.integrals:
            net += sign * x[place]
            gross += through[place]
        error = abs(end[b.inventory] - start[b.inventory] - net)
        inventory = max(start[b.inventory], end[b.inventory])
        found.append(Residual(b.store, b.quantity, UNITS[b.quantity], error, gross, inventory))
    return tuple(found)


def _energies(problem: Problem, *states: Array) -> list[list[float]]:
    """Energies of the stores that have a balance of it, in several states."""
    model = problem.kernel.model
    energy, x = np.empty(sum(store.has_energy for store in model.stores) + len(model.bodies)), np.empty(model.size)
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

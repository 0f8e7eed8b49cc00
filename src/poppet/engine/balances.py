"""Balances of a run: the change of a store must equal the sum of the integrals of its flows."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy as np

from poppet.engine.model import InventoryBalance
from poppet.engine.problem import Array, Problem, RawRun

ALLOWED = {"mass": 1e-9, "energy": 1e-7, "motion": 1e-4}
"""Relative limits of the error of a balance, per throughput: rounding errors for mass and energy of gas.

The energy of a body is not linear in the states, so its error depends on the tolerance."""
FLOOR = {"mass": 0.0, "energy": 0.0, "motion": 1e-7}
"""Absolute limits, which are added: the speed of a slow body is accurate to its absolute tolerance [SI]."""
STORED = 1e-12
"""Relative limit per inventory, which is added."""
UNITS = {"mass": "kg", "energy": "J", "motion": "J"}


class Residual(NamedTuple):
    """Residual of one balance over a run."""

    store: str
    quantity: str  # mass, energy or motion
    unit: str
    error: float  # |change of inventory - integral of the flows|
    through: float  # integral of |flows|
    inventory: float  # largest inventory of start and end

    @property
    def name(self) -> str:
        """Store and quantity, for example `tank mass`."""
        return f"{self.store} {self.quantity}"

    @property
    def allowed(self) -> float:
        """Limit of the error for a correct run.

        Gas: 1e-9 of the mass and 1e-7 of the energy that flowed, and 1e-12 of the inventory. Bodies: 1e-4 of the work
        and 1e-7 J.
        """
        return float(allowed(self.quantity, self.through, self.inventory))

    @property
    def is_kept(self) -> bool:
        """True if the error is within the limit."""
        return self.error <= self.allowed


def allowed(quantity: str, through: Any, inventory: Any) -> Any:
    """Return `Residual.allowed` for numbers or arrays."""
    return ALLOWED[quantity] * through + FLOOR[quantity] + STORED * inventory


def imbalance(balance: InventoryBalance, start: Any, end: Any, x: Any, through: Any) -> tuple[Any, Any]:
    """Return the error and the throughput of a balance.

    Arguments are the inventories at start and end, and for each state its final value and its sum of |change|. Elements
    can be numbers, or arrays with one element per run.
    """
    net: Any = 0.0
    gross: Any = 0.0
    for sign, index in balance.integrals:
        net += sign * x[index]
        gross += through[index]
    return abs(end[balance.inventory] - start[balance.inventory] - net), gross


def residuals(problem: Problem, run: RawRun) -> tuple[Residual, ...]:
    """Return the residuals of all balances of a run."""
    # Python floats: access to single array elements is ten times slower.
    x, through = run.x.tolist(), run.through.tolist()
    masses, initial_energies, final_energies = problem.x0.tolist(), *energies(problem, problem.x0, run.x)
    result = []
    for b in problem.kernel.model.balances:
        start, end = (masses, x) if b.quantity == "mass" else (initial_energies, final_energies)
        error, gross = imbalance(b, start, end, x, through)
        inventory = max(start[b.inventory], end[b.inventory])
        result.append(Residual(b.store, b.quantity, UNITS[b.quantity], error, gross, inventory))
    return tuple(result)


def energies(problem: Problem, *states: Array) -> list[list[float]]:
    """Return the energies of all stores and bodies with an energy balance, for each state."""
    model = problem.kernel.model
    energy, x = np.empty(model.n_energies), np.empty(model.size)
    if not energy.size:
        return [[] for _ in states]
    t, u, result = np.zeros(1), np.zeros(len(model.inputs) or 1), []
    call = problem.kernel.caller("energy", t, x, u, problem.p, energy)
    # In the same arrays, whose addresses are constant.
    for state in states:
        x[:] = state
        call()
        result.append(energy.tolist())
    return result

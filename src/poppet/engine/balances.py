"""Balances of mass and energy over a run.

The change of the content of a gas node or body must equal the sum of the integrals of its flows.
"""

from __future__ import annotations

from typing import Any, NamedTuple, TypeVar

import numpy as np

from poppet.engine.model import InventoryBalance
from poppet.engine.problem import Array, Problem, RawRun

ALLOWED = {"mass": 1e-9, "energy": 1e-7, "motion": 1e-4}
"""Limits of the error of a balance, relative to the throughput.

Errors of mass and energy of gas are rounding errors. The energy of a body is not linear in the
states, so the error of its balance depends on the tolerance."""
FLOOR = {"mass": 0.0, "energy": 0.0, "motion": 1e-7}
"""Absolute limits of the error of a balance, added to the relative ones [SI].

The speed of a slow body is accurate only to its absolute tolerance."""
STORED = 1e-12
"""Limit of the error relative to the inventory, added to the others."""
_ValueT = TypeVar("_ValueT", float, Array)
UNITS = {"mass": "kg", "energy": "J", "motion": "J"}


class Residual(NamedTuple):
    """Error of the mass or energy balance of one gas node or body over a run.

    The field `through` is the integral of the absolute flows. The field `inventory` is the mass or energy of the gas
    node or body. Both determine the largest permitted error.
    """

    store: str
    quantity: str  # mass, energy or motion
    unit: str
    error: float  # |change of inventory - integral of the flows|
    through: float  # integral of |flows|
    inventory: float  # largest inventory of start and end

    @property
    def name(self) -> str:
        """Name of the balance, for example `tank mass`.

        It consists of the gas node or body, and the quantity.
        """
        return f"{self.store} {self.quantity}"

    @property
    def allowed(self) -> float:
        """Largest permitted error of the balance.

        Gas: 1e-9 of the mass and 1e-7 of the energy that flowed, plus 1e-12 of the inventory. Bodies: 1e-4 of the work,
        plus 1e-7 J and 1e-12 of the energy of the body.
        """
        return float(allowed(self.quantity, self.through, self.inventory))

    @property
    def is_kept(self) -> bool:
        """True if the error of the balance is at most `allowed`."""
        return self.error <= self.allowed


def allowed(quantity: str, through: _ValueT, inventory: _ValueT) -> _ValueT:
    """Return the largest permitted error of a balance, as `Residual.allowed` describes it.

    `quantity` is `mass`, `energy` or `motion`. `through` is the integral of the absolute flows, and `inventory` the
    mass or energy of the gas node or body. Both can be numbers or arrays.
    """
    return ALLOWED[quantity] * through + FLOOR[quantity] + STORED * inventory


def imbalance(balance: InventoryBalance, start: Any, end: Any, x: Any, through: Any) -> tuple[Any, Any]:
    """Return the error of one balance, and the integral of its absolute flows.

    `start` and `end` are the inventories (masses or energies) at the start and the end of the run. `x` is the final
    state, and `through` the sum of |change| of each state. Elements can be numbers, or arrays with one element per run.
    """
    net: Any = 0.0
    gross: Any = 0.0
    for sign, index in balance.integrals:
        net += sign * x[index]
        gross += through[index]
    return abs(end[balance.inventory] - start[balance.inventory] - net), gross


def residuals(problem: Problem, run: RawRun) -> tuple[Residual, ...]:
    """Return the errors of all balances of a run."""
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
    """Return the energies of gas nodes and bodies in several states [J].

    Gas nodes and bodies without an energy balance are not included.
    """
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

"""Conservation over a run: what a store has gained must be the sum of what the integrals say went in."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np

from poppet.engine.model import Model
from poppet.engine.problem import Array, Problem, RawRun

ALLOWED = {"mass": 1e-9, "energy": 1e-7}
"""Part of what went through that rounding may take from a balance of a correct run."""
STORED = 1e-12
"""And part of the inventory."""


@dataclass(frozen=True)
class Residual:
    """Conservation over a run.

    Parameters
    ----------
    store, quantity : str
        Name of the part, and `mass` or `energy`.
    unit : str
        Its unit.
    error : float
        |change of inventory - integral of the flows|.
    through : float
        Integral of |flows|.
    inventory : float
        Largest inventory of start and end.
    """

    store: str
    quantity: str
    unit: str
    error: float
    through: float
    inventory: float

    @property
    def name(self) -> str:
        """Store and quantity, `tank mass`."""
        return f"{self.store} {self.quantity}"

    @property
    def allowed(self) -> float:
        """What a correct run may show: 1e-9 of the mass and 1e-7 of the energy that went through, and 1e-12 of the
        inventory."""
        return ALLOWED[self.quantity] * self.through + STORED * self.inventory

    @property
    def is_kept(self) -> bool:
        """True when the balance holds."""
        return self.error <= self.allowed


@dataclass(frozen=True)
class _Balance:
    """Inventory of a store at both ends of a run, and the integrals that account for its change: sign, place in x."""

    store: str
    quantity: str
    unit: str
    start: float
    end: float
    integrals: tuple[tuple[float, int], ...]


def residuals(problem: Problem, run: RawRun) -> tuple[Residual, ...]:
    """Mass residual of every store with a mass and energy residual of every store with an energy balance."""
    x, through = run.x.tolist(), run.through.tolist()
    return tuple(
        Residual(
            b.store, b.quantity, b.unit,
            error=abs(b.end - b.start - sum(sign * x[place] for sign, place in b.integrals)),
            through=sum(through[place] for _, place in b.integrals),
            inventory=max(b.start, b.end),
        )
        for b in _balances(problem, run)
    )  # fmt: skip


def _balances(problem: Problem, run: RawRun) -> Iterator[_Balance]:
    model = problem.kernel.model
    energies = zip(_energies(problem, problem.x0), _energies(problem, run.x), strict=True)
    for store, ends in zip(model.stores, model.ends, strict=True):
        mass = float(problem.x0[store.mass]), float(run.x[store.mass])
        yield _Balance(store.name, "mass", "kg", *mass, tuple((sign, flow.mass) for flow, sign in ends))
        if store.has_energy:
            # Another way to give a store energy (work of a moving wall) is one more integral here.
            integrals = *((sign, flow.enthalpy) for flow, sign in ends), (1.0, store.heat)
            yield _Balance(store.name, "energy", "J", *next(energies), integrals)


def _energies(problem: Problem, x: Array) -> list[float]:
    model: Model = problem.kernel.model
    energy = np.empty(sum(store.has_energy for store in model.stores))
    if energy.size:
        u = np.zeros(max(1, len(model.inputs)))
        problem.kernel.call("energy", np.zeros(1), x, u, problem.p, energy)
    return energy.tolist()

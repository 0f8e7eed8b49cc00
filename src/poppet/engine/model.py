"""The flat model of a circuit: named states, inputs, parameters and outputs over symbolic expressions.

``x' = f(t, x, u, p)``, ``y = g(t, x, u, p)``, ``x(0) = x0(p)``; argument order (t, x, u, p) everywhere. Behind the
states that the error control watches stand quadratures, integrals of the flows and heats: the integrator carries them
along by the same formula, so that the conservation residuals of a run hold to round-off.

What is sampled or switched has memory z behind the numbers in p: first timers, each the time of its next instant, then
what is remembered. Between instants z is constant; when timers have come to their time, ``z+ = h(t, x, u, p)`` of those
that have.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from functools import cached_property
from itertools import count
from typing import Any, NamedTuple


class StateInfo(NamedTuple):
    """A state that the error control watches, by address."""

    name: str
    unit: str
    nominal: float  # usual size
    tolerance: float  # factor on the relative tolerance
    floor: float  # absolute tolerance per relative tolerance and size
    positive: bool  # a step that makes it zero or less is rejected


class InputInfo(NamedTuple):
    """An input, by address; text in place of a number is the address of a parameter."""

    name: str
    unit: str
    kind: str  # as in `poppet.core.units.quantity`
    default: str | float  # its value without a signal
    low: str | float
    high: str | float
    delay: str  # parameter by which its signal comes later; empty for none
    slope_of: str = ""  # input whose time derivative it is: it has no signal of its own


class FlowInfo(NamedTuple):
    """A flow between stores, None being outside the circuit, and the places of its integrals in the state vector."""

    name: str
    source: str | None
    target: str | None
    mass: int
    enthalpy: int


class StoreInfo(NamedTuple):
    """A store whose balance is checked: places of its mass and of the integral of its heat in the state vector."""

    name: str
    mass: int
    heat: int
    has_energy: bool  # linear in the states, so that the balance of energy is checked too
    work: int | None = None  # place of the integral of the work done on its gas


class Balance(NamedTuple):
    """The inventory of a store changes by the sum of some integrals."""

    store: str
    quantity: str  # mass, energy or motion
    inventory: int  # place of a mass in the state vector, or of an energy among those of the model
    integrals: tuple[tuple[float, int], ...]  # sign and place in the state vector


@dataclass(frozen=True)
class Model:
    """A traced circuit."""

    states: tuple[StateInfo, ...]  # controlled states, in the order of x; quadratures follow them
    n_quadratures: int
    inputs: tuple[InputInfo, ...]  # in the order of u
    parameters: tuple[str, ...]  # addresses in the order of p
    outputs: tuple[tuple[str, str], ...]  # address and SI unit, in the order of y
    # Bookkeeping for the conservation residuals.
    flows: tuple[FlowInfo, ...]
    stores: tuple[StoreInfo, ...]
    # CasADi symbols `t`, `x`, `u`, `p` (numbers, then memory) and `fired` (1 for each timer that has come)
    symbols: dict[str, Any] = field(repr=False)
    # CasADi expressions `rates` (all of x), `outputs`, `start`, `energy` (of each store with an energy balance,
    # then of each body), `memory_start` and `update` (all of z)
    expressions: dict[str, Any] = field(repr=False)
    memory: tuple[tuple[str, str], ...] = ()  # address and unit of each element of z
    n_timers: int = 0  # how many of them, the first, are timers
    # Name of each body with energy, and the places of the integrals of the powers that act on it.
    bodies: tuple[tuple[str, tuple[int, ...]], ...] = ()

    @property
    def size(self) -> int:
        """Length of x, quadratures included."""
        return len(self.states) + self.n_quadratures

    @property
    def n_energies(self) -> int:
        """Number of energies in balances."""
        return sum(store.has_energy for store in self.stores) + len(self.bodies)

    @cached_property
    def acting(self) -> tuple[bool, ...]:
        """For each element of z whether the rates depend on it."""
        if not self.memory:
            return ()
        import casadi as ca

        # Memory that moves no rate, as a held command in its band, need not end a step.
        z = self.symbols["p"][len(self.parameters) :]
        dependence = ca.jacobian_sparsity(self.expressions["rates"], self.symbols["p"])
        columns = set(dependence.get_col())
        return tuple(len(self.parameters) + k in columns for k in range(z.shape[0]))

    @cached_property
    def counting(self) -> tuple[bool, ...]:
        """For each element of z whether it is a clock or its counter: it follows nothing but itself, numbers, time."""
        if not self.memory:
            return ()
        import casadi as ca

        update, first = self.expressions["update"], len(self.parameters)
        needs: dict[int, set[int]] = {k: set() for k in range(len(self.memory))}
        for row, column in zip(*ca.jacobian_sparsity(update, self.symbols["p"]).get_triplet(), strict=True):
            needs[row] |= {column - first} if column >= first else set()
        driven = {
            row for each in ("x", "u") for row in ca.jacobian_sparsity(update, self.symbols[each]).get_triplet()[0]
        }
        # What follows something driven is driven itself, however many steps away.
        while more := {row for row, columns in needs.items() if columns & driven} - driven:
            driven |= more
        return tuple(k not in driven for k in needs)

    @cached_property
    def columns(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Addresses and SI units of the outputs."""
        return tuple(name for name, _ in self.outputs), tuple(unit for _, unit in self.outputs)

    @cached_property
    def balances(self) -> tuple[Balance, ...]:
        """What must hold over any run: mass of every store, energy where it is linear in the states."""
        found, energies = [], count()
        for store in self.stores:
            signs = [
                (flow, sign)
                for flow in self.flows
                for name, sign in ((flow.source, -1.0), (flow.target, 1.0))
                if name == store.name
            ]
            masses = tuple((sign, flow.mass) for flow, sign in signs)
            found.append(Balance(store.name, "mass", store.mass, masses))
            if store.has_energy:
                given = [*((sign, flow.enthalpy) for flow, sign in signs), (1.0, store.heat)]
                given += [] if store.work is None else [(1.0, store.work)]
                found.append(Balance(store.name, "energy", next(energies), tuple(given)))
        for name, places in self.bodies:
            found.append(Balance(name, "motion", next(energies), tuple((1.0, place) for place in places)))
        return tuple(found)

    @cached_property
    def linear_function(self) -> Any:
        """A CasADi function (t, x, u, p) -> (f, y, A, B, C, D) over the controlled states, by exact derivatives."""
        import casadi as ca

        s, n = self.symbols, len(self.states)
        rates, outputs = self.expressions["rates"][:n], self.expressions["outputs"]
        x = s["x"]
        found = [rates, outputs, ca.jacobian(rates, x)[:, :n], ca.jacobian(rates, s["u"])]
        found += [ca.jacobian(outputs, x)[:, :n], ca.jacobian(outputs, s["u"])]
        return ca.Function("linear", [s["t"], x, s["u"], s["p"]], [ca.densify(each) for each in found])

    @cached_property
    def sampled_functions(self) -> tuple[Any, Any]:
        """Two CasADi functions of a model with memory, by exact derivatives, over states and memory (x, z).

        The first is (t, x, u, p) -> (f, y, df/d(x, z), df/du, dy/d(x, z), dy/du), the second, an instant, is
        (t, x, u, p, fired) -> (z+, dz+/d(x, z), dz+/du).
        """
        import casadi as ca

        s, n, numbers = self.symbols, len(self.states), len(self.parameters)
        arguments = [s[name] for name in ("t", "x", "u", "p")]

        def slopes(expression: Any) -> list[Any]:
            by_x = ca.jacobian(expression, s["x"])[:, :n]
            both = ca.horzcat(by_x, ca.jacobian(expression, s["p"])[:, numbers:])
            return [ca.densify(both), ca.densify(ca.jacobian(expression, s["u"]))]

        rates, outputs, update = self.expressions["rates"][:n], self.expressions["outputs"], self.expressions["update"]
        # Together, for rates, outputs and slopes have most of their subexpressions in common.
        between = ca.cse([ca.densify(rates), ca.densify(outputs), *slopes(rates), *slopes(outputs)])
        instant = ca.cse([ca.densify(update), *slopes(update)])
        return (
            ca.Function("between", arguments, between),
            ca.Function("instant", [*arguments, s["fired"]], instant),
        )

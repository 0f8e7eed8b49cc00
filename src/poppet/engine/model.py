"""Symbolic model of a circuit: states, inputs, parameters and outputs with their expressions.

``x' = f(t, x, u, p)``, ``y = g(t, x, u, p)``, ``x(0) = x0(p)``; the order of arguments is always (t, x, u, p). Vector x
contains the states with error control, then quadratures: integrals of flows and heats. The integrator applies the same
formula to quadratures, so the balances of a run are exact except for rounding errors.

Vector p contains the parameters, then the discrete state z of sampled or switched parts: first timers (the time of the
next instant of each), then stored values. Between instants z is constant. At an instant, the timers that are due change
it: ``z+ = h(t, x, u, p)``.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from itertools import count
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import casadi


class StateInfo(NamedTuple):
    """State with error control, with its address, unit, size and tolerances."""

    name: str  # address
    unit: str
    nominal: float  # typical size
    tolerance: float  # factor on the relative tolerance
    floor: float  # absolute tolerance per relative tolerance and size
    positive: bool  # steps to zero or below are rejected


class InputInfo(NamedTuple):
    """Input of the model.

    A default value or limit is a number, or the address of a parameter with this value.
    """

    name: str  # address
    unit: str
    kind: str  # as in `poppet.core.units.quantity`
    default: str | float  # value without a signal
    low: str | float
    high: str | float
    delay: str  # parameter with the delay of its signal, or empty
    slope_of: str = ""  # address of another input, if this input is its time derivative
    at_rest: float | None = None  # value in steady states, unless a signal or the user sets another


class FlowInfo(NamedTuple):
    """Gas flow from `source` to `target`, with the indices of its integrals in x.

    `source` or `target` is None if the flow comes from or goes to the outside of the circuit.
    """

    name: str
    source: str | None
    target: str | None
    mass: int
    enthalpy: int


class StoreInfo(NamedTuple):
    """Gas node that has a balance.

    It contains the indices of its mass, and of the integral of its heat flow, in the vector x.
    """

    name: str
    mass: int
    heat: int
    has_energy: bool  # has an energy balance, because its energy is linear in the states
    work: int | None = None  # index of the integral of the work on its gas


class InventoryBalance(NamedTuple):
    """Balance of an inventory, which is the mass or energy of a gas node or body.

    The change of the inventory must equal a sum of integrals with signs.
    """

    store: str
    quantity: str  # mass, energy or motion
    inventory: int  # index of a mass in x, or of an energy among the energies of the model
    integrals: tuple[tuple[float, int], ...]  # sign and index in x


@dataclass(frozen=True, eq=False)
class Model:
    """Symbolic model of a circuit with CasADi symbols and expressions."""

    states: tuple[StateInfo, ...]  # controlled states, in the order of x; quadratures follow them
    n_quadratures: int
    inputs: tuple[InputInfo, ...]  # in the order of u
    parameters: tuple[str, ...]  # addresses in the order of p
    outputs: tuple[tuple[str, str], ...]  # address and SI unit, in the order of y
    # For the balances.
    flows: tuple[FlowInfo, ...]
    stores: tuple[StoreInfo, ...]
    # CasADi symbols `t`, `x`, `u`, `p` (parameters, then z) and `fired` (1 for each timer that is due)
    symbols: dict[str, Any] = field(repr=False)
    # CasADi expressions `rates` (of x), `outputs`, `start`, `energy` (of each gas node with an energy balance, then of
    # each body), `memory_start` and `update` (of z)
    expressions: dict[str, Any] = field(repr=False)
    memory: tuple[tuple[str, str], ...] = ()  # address and unit of each element of z
    n_timers: int = 0  # number of timers, the first elements of z
    # Name of each body with energy, and the indices of the integrals of the powers on it.
    bodies: tuple[tuple[str, tuple[int, ...]], ...] = ()
    _counting: dict[tuple[float, ...], tuple[bool, ...]] = field(default_factory=dict, init=False, repr=False)

    @property
    def size(self) -> int:
        """Length of the state vector x, including quadratures (integrals of flows)."""
        return len(self.states) + self.n_quadratures

    @property
    def n_energies(self) -> int:
        """Number of energies of gas nodes and bodies that have a balance."""
        return sum(store.has_energy for store in self.stores) + len(self.bodies)

    @cached_property
    def acting(self) -> tuple[bool, ...]:
        """Mask of the discrete states z that affect the rates, (n_memory,)."""
        if not self.memory:
            return ()
        import casadi as ca

        # A change of another element, for example of a command within its band, does not end a step.
        z = self.symbols["p"][len(self.parameters) :]
        dependence = ca.jacobian_sparsity(self.expressions["rates"], self.symbols["p"])
        columns = set(dependence.get_col())
        return tuple(len(self.parameters) + k in columns for k in range(z.shape[0]))

    @cached_property
    def influences(self) -> tuple[frozenset[int], frozenset[int]]:
        """Indices of the parameters and of the inputs that affect rates, outputs or discrete states after the start."""
        import casadi as ca

        e, parameters = self.expressions, set(range(len(self.parameters)))
        results = ca.vertcat(e["rates"][: len(self.states)], e["outputs"], *([e["update"]] if self.memory else []))
        p, u = (set(ca.jacobian_sparsity(results, self.symbols[name]).get_col()) for name in ("p", "u"))
        return frozenset(p & parameters), frozenset(u)

    def counting(self, u: Sequence[float] = ()) -> tuple[bool, ...]:
        """Return a mask of the discrete states z that do not depend on the circuit, (n_memory,).

        They are clocks, counters, and states that inputs hold, such as those of a halted sequence. The next value of
        such a state depends only on discrete states of this kind, parameters and time. u contains the constant inputs;
        without it, no state is held.
        """
        if not self.memory:
            return ()
        # Only inputs with a value at rest decide whether a state is held.
        resting = {k: u[k] for k, item in enumerate(self.inputs) if item.at_rest is not None and len(u)}
        key = tuple(resting.values())
        if key in self._counting:
            return self._counting[key]
        import casadi as ca

        first, update = len(self.parameters), self.expressions["update"]
        if resting:
            values = ca.SX(self.symbols["u"])
            for k, value in resting.items():
                values[k] = value
            update = ca.substitute([update], [self.symbols["u"]], [values])[0]
        dependencies: dict[int, set[int]] = {k: set() for k in range(len(self.memory))}
        for row, column in zip(*ca.jacobian_sparsity(update, self.symbols["p"]).get_triplet(), strict=True):
            dependencies[row] |= {column - first} if column >= first else set()
        driven = {
            row for name in ("x", "u") for row in ca.jacobian_sparsity(update, self.symbols[name]).get_triplet()[0]
        }
        # Also elements that depend on driven elements, in any number of steps.
        while added_rows := {row for row, columns in dependencies.items() if columns & driven} - driven:
            driven |= added_rows
        self._counting[key] = tuple(k not in driven for k in dependencies)
        return self._counting[key]

    @cached_property
    def columns(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Addresses of all outputs, and their SI units."""
        return tuple(name for name, _ in self.outputs), tuple(unit for _, unit in self.outputs)

    @cached_property
    def balances(self) -> tuple[InventoryBalance, ...]:
        """Balances that every run must satisfy.

        They are the mass balance of each gas node, and all energy balances that are linear in the states.
        """
        balances, energies = [], count()
        for store in self.stores:
            signs = [
                (flow, sign)
                for flow in self.flows
                for name, sign in ((flow.source, -1.0), (flow.target, 1.0))
                if name == store.name
            ]
            masses = tuple((sign, flow.mass) for flow, sign in signs)
            balances.append(InventoryBalance(store.name, "mass", store.mass, masses))
            if store.has_energy:
                integrals = [*((sign, flow.enthalpy) for flow, sign in signs), (1.0, store.heat)]
                integrals += [] if store.work is None else [(1.0, store.work)]
                balances.append(InventoryBalance(store.name, "energy", next(energies), tuple(integrals)))
        for name, powers in self.bodies:
            integrals = [(1.0, index) for index in powers]
            balances.append(InventoryBalance(name, "motion", next(energies), tuple(integrals)))
        return tuple(balances)

    @cached_property
    def linear_function(self) -> casadi.Function:
        """CasADi function of the linear model without quadratures (integrals of flows).

        Its arguments are time t, states x, inputs u and parameters p. Its results are rates f, outputs y and the
        matrices A, B, C and D.
        """
        import casadi as ca

        s, n = self.symbols, len(self.states)
        rates, outputs = self.expressions["rates"][:n], self.expressions["outputs"]
        x = s["x"]
        results = [rates, outputs, ca.jacobian(rates, x)[:, :n], ca.jacobian(rates, s["u"])]
        results += [ca.jacobian(outputs, x)[:, :n], ca.jacobian(outputs, s["u"])]
        return ca.Function("linear", [s["t"], x, s["u"], s["p"]], [ca.densify(result) for result in results])

    @cached_property
    def sampled_functions(self) -> tuple[Any, Any]:
        """CasADi functions of a sampled model with exact derivatives.

        The arguments are time t, states x, inputs u and parameters p, which end with the discrete states z. The first
        function is valid between instants: (t, x, u, p) -> (f, y, df/d(x, z), df/du, dy/d(x, z), dy/du) with rates f
        and outputs y. The second describes an instant at which timers are due: (t, x, u, p, fired) -> (z+, dz+/d(x, z),
        dz+/du).
        """
        import casadi as ca

        s, n, numbers = self.symbols, len(self.states), len(self.parameters)
        arguments = [s[name] for name in ("t", "x", "u", "p")]

        def derivatives(expression: Any) -> list[Any]:
            by_x = ca.jacobian(expression, s["x"])[:, :n]
            by_xz = ca.horzcat(by_x, ca.jacobian(expression, s["p"])[:, numbers:])
            return [ca.densify(by_xz), ca.densify(ca.jacobian(expression, s["u"]))]

        rates, outputs, update = self.expressions["rates"][:n], self.expressions["outputs"], self.expressions["update"]
        # Together, because rates, outputs and derivatives share most subexpressions.
        intersample = ca.cse([ca.densify(rates), ca.densify(outputs), *derivatives(rates), *derivatives(outputs)])
        instant = ca.cse([ca.densify(update), *derivatives(update)])
        return (
            ca.Function("between", arguments, intersample),
            ca.Function("instant", [*arguments, s["fired"]], instant),
        )

"""What a part is: stores hold gas, passages move it, controllers sample. All are frozen dataclasses that know their
equations.

A part never sees symbols of other parts. While a circuit is traced, a store turns its states into a gas state, a
passage turns the gas states at its ports into flows, and the store turns the sum of its flows into rates. What is
sampled or switched lives in a part's memory, which changes at instants only. The same methods run on floats.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Hashable, Mapping, Sequence
from dataclasses import dataclass, field, fields
from typing import Any, ClassVar

from poppet.errors import InputError
from poppet.parts.fields import OptionSpec, PortSpec, attribute, complete, flatten, forget, specs
from poppet.provenance import Number


@dataclass(frozen=True)
class State:
    """One element of the state vector.

    Parameters
    ----------
    name, unit : str
        Local name and SI unit.
    nominal : float
        Usual size, in `unit`; the absolute tolerance follows it or the initial value.
    tolerance : float
        Factor on the relative tolerance; mechanics may be looser than gas.
    floor : float
        Absolute tolerance per relative tolerance and size of the state.
    positive : bool
        A step that makes it zero or less is rejected.
    """

    name: str
    unit: str
    nominal: float
    tolerance: float = 1.0
    floor: float = 1e-3
    positive: bool = False


@dataclass(frozen=True)
class Input:
    """A quantity that a signal may drive.

    Parameters
    ----------
    name, unit : str
        Local name and SI unit.
    default : str or float
        Name of the number it takes without a signal, or its value.
    kind : str
        Kind of quantity, as in `poppet.units.quantity`.
    low, high : str or float
        Limits of its values, or names of the numbers that are.
    delay : str
        Name of a number by which the signal comes later; empty for none.
    """

    name: str
    unit: str
    default: str | float
    kind: str = "plain"
    low: str | float = float("-inf")
    high: str | float = float("inf")
    delay: str = ""


@dataclass(frozen=True)
class Memory:
    """An element of sampled memory, constant between instants.

    Parameters
    ----------
    name, unit : str
        Local name and SI unit.
    """

    name: str
    unit: str


@dataclass(frozen=True)
class Timer:
    """The next instant at which a part acts; the part sets it anew at every instant, or to `NEVER`.

    Parameters
    ----------
    name : str
        Local name; its value is a time [s].
    rank : int
        At a common instant timers act in this order, those of one rank in the order of the parts.
    """

    name: str
    rank: int = 0


AMBIENT = "ambient"
"""Reserved name of the open air, to which any port may be joined."""
NEVER = 1e300
"""Time of a timer that waits for another to set it [s]."""
SELF = "self"
"""End of a flow at the part that moves the gas, when it is a store as well."""


@dataclass(frozen=True)
class Gas:
    """State of the gas that a store offers: pressure [Pa] and temperature [K]."""

    pressure: Any
    temperature: Any


@dataclass(frozen=True)
class Flow:
    """Gas on its way from one port to another; a port of None is outside the circuit.

    Parameters
    ----------
    name : str
        Local name of the mass flow rate's output.
    source, target : str or None
        Ports, or `SELF`; positive flow goes from the first to the second.
    mass, enthalpy : float or symbol
        Mass flow rate [kg/s] and enthalpy flow rate [W].
    """

    name: str
    source: str | None
    target: str | None
    mass: Any
    enthalpy: Any


Quantities = dict[str, tuple[Any, str]]
"""Outputs: local name to value and unit."""


@dataclass(frozen=True)
class Passing:
    """What a passage does in a given state: flows, outputs, rates of its own states.

    Parameters
    ----------
    flows : tuple of Flow
        Between its ports.
    outputs : dict
        Name to value and unit.
    rates : dict
        Name of each state to its rate.
    hidden : dict
        Outputs that connections may take and no recording shows.
    """

    flows: tuple[Flow, ...]
    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    hidden: Quantities = field(default_factory=dict)


@dataclass(frozen=True)
class Balance:
    """What a store does with its flows: rates of its states, outputs, and the heat taken from its wall [W]."""

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    heat: Any = None
    energy: Any = None


@dataclass(frozen=True)
class Control:
    """What a controller shows between instants: outputs, and rates of its own states."""

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Surroundings:
    """Numbers that all parts share.

    Parameters
    ----------
    pressure : float or symbol
        Ambient pressure [Pa].
    temperature : float or symbol
        Ambient temperature [K].
    gas_constant : float or symbol
        Specific gas constant [J/(kg K)].
    isentropic_exponent : float or symbol
        Ratio of heat capacities.
    conductance_factor : float or symbol
        Factor on sonic conductances that were measured with another gas.
    """

    pressure: Any
    temperature: Any
    gas_constant: Any
    isentropic_exponent: Any
    conductance_factor: Any

    @property
    def heat_capacity_pressure(self) -> Any:
        """Specific heat capacity at constant pressure [J/(kg K)]."""
        return self.isentropic_exponent * self.heat_capacity_volume

    @property
    def heat_capacity_volume(self) -> Any:
        """Specific heat capacity at constant volume [J/(kg K)]."""
        return self.gas_constant / (self.isentropic_exponent - 1.0)


@dataclass(frozen=True)
class Scope:
    """What one part sees: its numbers, states, inputs and memory (floats or symbols), surroundings and time [s]."""

    numbers: Mapping[str, Any]
    states: Mapping[str, Any]
    inputs: Mapping[str, Any]
    surroundings: Surroundings
    memory: Mapping[str, Any] = field(default_factory=dict)
    time: Any = 0.0

    def __getitem__(self, name: str) -> Any:
        return self.numbers[name]

    def __contains__(self, name: str) -> bool:
        return name in self.numbers


class Part(ABC):
    """A named thing in a circuit."""

    kind: ClassVar[str]
    summary: ClassVar[str]
    resume: ClassVar[dict[str, str]] = {}
    """Outputs that say where a run may start again, with the number that each of them becomes."""

    def __post_init__(self) -> None:
        forget(self, self.library_sets())
        complete(self, self.library_numbers())
        self.check()

    def library_sets(self) -> Sequence[Mapping[str, Number]]:
        """All sets of which a copy of the part may carry numbers; they give way to `library_numbers`."""
        return ()

    def library_numbers(self) -> Mapping[str, Number]:
        """Numbers of a library set, used for fields that were not given."""
        return {}

    def check(self) -> None:  # noqa: B027 - most parts have no rule beyond those of their fields
        """Raise `InputError` where fields contradict each other."""

    def notes(self) -> tuple[str, ...]:
        """What a reader of any result has to know about the fields that were given, without the part's name."""
        return ()

    def numbers(self) -> dict[str, Number]:
        """Every number of the part by its dotted local name."""
        return {name: value for name, _, value in flatten(self)}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        """Run-time values of the part's numbers and of what derives from them, SI and absolute.

        Parameters
        ----------
        ambient : Surroundings
            Plain floats.

        Returns
        -------
        dict
            Local name to value; the set of names depends on the structure only.
        """
        values = {}
        for name, spec, value in flatten(self):
            try:
                values[name] = value.absolute(ambient.pressure)
            except InputError as error:
                raise type(error)(f"{name} = {error.given}", error.reason, error.cure, address=name) from None
            if value.reference == "gauge":
                spec.check(name, values[name], f"{value.display()} ({values[name]:g} Pa absolute)")
        return values

    def ports(self) -> dict[str, str]:
        """Port name to the name of the store it is joined to."""
        named = {
            name: getattr(self, attribute(name)) for name, s in specs(type(self)).items() if isinstance(s, PortSpec)
        }
        return {name: store for name, store in named.items() if store is not None}

    def options(self) -> dict[str, str]:
        """Choices that shape the model."""
        return {name: getattr(self, name) for name, s in specs(type(self)).items() if isinstance(s, OptionSpec)}

    def structure(self) -> Hashable:
        """Everything but values: two parts of equal structure share one compiled model."""
        return self.kind, tuple(self.options().items()), tuple(sorted(self.ports().items()))

    def states(self) -> tuple[State, ...]:
        """States of the part."""
        return ()

    def inputs(self) -> tuple[Input, ...]:
        """Inputs of the part."""
        return ()

    def memory(self) -> tuple[Memory, ...]:
        """Sampled memory of the part, its timers not among them."""
        return ()

    def timers(self) -> tuple[Timer, ...]:
        """Instants at which the memory changes."""
        return ()

    def start(self, scope: Scope) -> dict[str, Any]:
        """Initial values of states, memory and timers; `scope.states` and `scope.memory` are empty here."""
        return {}

    def at_instant(self, timer: str, scope: Scope) -> dict[str, Any]:
        """New values of memory and timers at an instant; what is not named keeps its value.

        Parameters
        ----------
        timer : str
            Whose time has come.
        scope : Scope
            The part's own values at that instant, the inputs from the right.

        Returns
        -------
        dict
            Name to value; the timer itself must be among them.
        """
        raise NotImplementedError(f"{self.kind} has no timers")

    def can_resume(self, target: str) -> bool:
        """True when the number of that name has a meaning for this part's form."""
        return target != "wall_temperature" or any(state.name == target for state in self.states())

    def domains(self) -> dict[str, Any]:
        """State or input name to the characteristic that holds only over a range of it."""
        return {}


class Store(Part):
    """A part that holds gas and offers its state."""

    @abstractmethod
    def gas(self, scope: Scope) -> Gas:
        """The gas at its ports."""

    @abstractmethod
    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> Balance:
        """Rates and outputs.

        Parameters
        ----------
        scope : Scope
            The part's own values.
        flows : tuple of (mass, enthalpy)
            Every flow, positive into the store [kg/s], [W].

        Returns
        -------
        Balance
            Rates of the states and outputs.
        """


class Passage(Part):
    """A part that moves gas between stores."""

    @abstractmethod
    def passing(self, scope: Scope, gas: Mapping[str, Gas]) -> Passing:
        """Flows, rates and outputs for the gas states at its ports.

        Parameters
        ----------
        scope : Scope
            The part's own values.
        gas : mapping
            Port name to gas state.

        Returns
        -------
        Passing
            Flows, rates, outputs.
        """


def field_names(kind: type[Part]) -> tuple[str, ...]:
    """Names that a circuit file may use for a kind of part."""
    return tuple(f.name.rstrip("_") for f in fields(kind))  # type: ignore[arg-type]


def contradiction(given: str, reason: str, cure: str, address: str) -> InputError:
    """The mistake of fields that exclude each other."""
    return InputError(given, reason, cure, address=address)


class Controller(Part):
    """A part that moves no gas: it reads, remembers and gives signals."""

    @abstractmethod
    def control(self, scope: Scope) -> Control:
        """Outputs, and rates of the part's own states.

        Parameters
        ----------
        scope : Scope
            The part's own values.

        Returns
        -------
        Control
            Outputs and rates.
        """


def ticked(scope: Scope, timer: str, period: Any, phase: Any = 0.0) -> dict[str, Any]:
    """A clock set to its next instant, counted from the start so that no rounding adds up.

    Parameters
    ----------
    scope : Scope
        Of the part that has the timer and a memory element `<timer>_count`.
    timer : str
        Its name.
    period, phase : float or symbol
        Distance of the instants and the first of them [s].

    Returns
    -------
    dict
        New values of timer and count.
    """
    count = scope.memory[f"{timer}_count"] + 1.0
    return {timer: phase + count * period, f"{timer}_count": count}

"""The terms in which parts speak of themselves: states, inputs, memory; gas, flows, balances; what a part sees."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any


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
        Kind of quantity, as in `poppet.ground.units.quantity`.
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

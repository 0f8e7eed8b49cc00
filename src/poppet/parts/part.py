"""What a part is: stores hold gas, passages move it, bodies move, actuators push them, controllers sample. All are
frozen dataclasses that know their equations.

A part never sees symbols of other parts. While a circuit is traced, a body turns its states into a motion, a store
turns its states (and the motion of the body that moves its wall) into a gas state, a passage turns the gas states at
its ports into flows, an actuator turns them into a force, the store turns the sum of its flows into rates, and the body
the sum of its forces. What is sampled or switched lives in a part's memory, which changes at instants only. The same
methods run on floats.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, ClassVar

from poppet import library
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.provenance import Number
from poppet.parts.fields import BodySpec, OptionSpec, PortSpec, complete, declared, flatten, forget

# --- The terms in which parts speak of themselves ---

AMBIENT = "ambient"
"""Reserved name of the open air, to which any port may be joined."""
NEVER = 1e300
"""Time of a timer that waits for another to set it [s]."""
SELF = "self"
"""End of a flow at the part that moves the gas, when it is a store as well."""
TUBE = "tube"
"""Kind of the part whose ends may name ports of other parts."""
PORTS = ("from", "to", "supply", "outlet", "exhaust", "pilot_exhaust", "a", "b", "exhaust_a", "exhaust_b")
"""Names of ports: an end of a tube that ends in one of them is a port that names the tube itself."""

Quantities = dict[str, tuple[Any, str]]
"""Outputs: local name to value and unit."""


@dataclass(frozen=True)
class State:
    """One element of the state vector, by its local name and SI unit."""

    name: str
    unit: str
    nominal: float  # usual size; the absolute tolerance follows it or the initial value
    tolerance: float = 1.0  # factor on the relative tolerance: mechanics may be looser than gas
    floor: float = 1e-3  # absolute tolerance per relative tolerance and size of the state
    positive: bool = False  # a step that makes it zero or less is rejected


@dataclass(frozen=True)
class Input:
    """A quantity that a signal may drive, by its local name and SI unit."""

    name: str
    unit: str
    default: str | float  # what it takes without a signal: a value, or the name of a number
    kind: str = "plain"  # of quantity, as in `poppet.core.units.quantity`
    low: str | float = float("-inf")  # limits of its values, or names of the numbers that are
    high: str | float = float("inf")
    delay: str = ""  # name of a number by which the signal comes later
    slope_of: str = ""  # the input whose time derivative it is: nobody drives it, it follows that one's signal
    by_signal: bool = False  # nothing but a signal may drive it


@dataclass(frozen=True)
class DiscreteState:
    """An element of sampled memory, constant between instants, by its local name and SI unit."""

    name: str
    unit: str


@dataclass(frozen=True)
class Timer:
    """The next instant [s] at which a part acts; the part sets it anew at every instant, or to `NEVER`."""

    name: str
    rank: int = 0  # at a common instant timers act in this order, those of one rank in the order of the parts


@dataclass(frozen=True)
class GasState:
    """State of the gas that a store offers: pressure [Pa] and temperature [K]."""

    pressure: Any
    temperature: Any


@dataclass(frozen=True)
class BodyMotion:
    """How a body moves where its actuators hold it: travel [m] and speed [m/s]."""

    position: Any
    velocity: Any


@dataclass(frozen=True)
class ActuatorForce:
    """What an actuator does to its body: force towards larger positions and what it adds to its friction [N]."""

    force: Any
    outputs: Quantities = field(default_factory=dict)
    rates: dict[str, Any] = field(default_factory=dict)
    friction: Any = 0.0


@dataclass(frozen=True)
class BodyDynamics:
    """What a body does under its forces: outputs, rates, its energy [J] and the powers of what drives it, its load
    taken off, and of its friction and stops [W]."""

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    energy: Any = None
    powers: tuple[Any, ...] = ()


@dataclass(frozen=True)
class Flow:
    """Gas on its way from one port to another, positive from source to target."""

    name: str  # of the mass flow rate's output
    source: str | None  # a port or `SELF`; None is outside the circuit
    target: str | None
    mass: Any  # mass flow rate [kg/s]
    enthalpy: Any  # enthalpy flow rate [W]


@dataclass(frozen=True)
class PassageFlows:
    """What a passage does in a given state: flows between its ports, outputs, rates of its own states."""

    flows: tuple[Flow, ...]
    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    hidden: Quantities = field(default_factory=dict)  # connections may take them, and no recording shows them


@dataclass(frozen=True)
class GasBalance:
    """What a store does with its flows: rates of its states, outputs, the heat taken from its wall and the work done on
    it [W], and its energy where that is linear in the states [J]."""

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    heat: Any = None
    energy: Any = None
    work: Any = None
    totals: Quantities = field(default_factory=dict)  # outputs that come last in a recording: sums of what others show


@dataclass(frozen=True)
class ControlOutputs:
    """What a controller shows between instants: outputs, and rates of its own states."""

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Surroundings:
    """Numbers that all parts share, floats or symbols: ambient pressure [Pa] and temperature [K], and the gas."""

    pressure: Any
    temperature: Any
    gas_constant: Any  # specific [J/(kg K)]
    isentropic_exponent: Any
    conductance_factor: Any  # on sonic conductances, which were measured with another gas
    ratio_shift: Any = 0.0  # the part of 1 - b by which this gas raises critical ratios

    @property
    def heat_capacity_pressure(self) -> Any:
        """Specific heat capacity at constant pressure [J/(kg K)]."""
        return self.isentropic_exponent * self.heat_capacity_volume

    @property
    def heat_capacity_volume(self) -> Any:
        """Specific heat capacity at constant volume [J/(kg K)]."""
        return self.gas_constant / (self.isentropic_exponent - 1.0)

    def size_with_gas(self, conductance: Any, ratio: Any) -> tuple[Any, Any]:
        """C and b that a flow has, of the ones that stand in the circuit."""
        return conductance * self.conductance_factor, ratio + (1.0 - ratio) * self.ratio_shift

    def stated_size(self, conductance: float, ratio: float) -> tuple[float, float]:
        """C and b that `size_with_gas` makes these."""
        return conductance / self.conductance_factor, (ratio - self.ratio_shift) / (1.0 - self.ratio_shift)


@dataclass(frozen=True)
class Scope:
    """What one part sees: its numbers, states, inputs and memory (floats or symbols), surroundings and time [s]."""

    numbers: Mapping[str, Any]
    states: Mapping[str, Any]
    inputs: Mapping[str, Any]
    surroundings: Surroundings
    memory: Mapping[str, Any] = field(default_factory=dict)
    time: Any = 0.0
    motion: BodyMotion | None = None  # of the body that the part holds

    @property
    def body(self) -> BodyMotion:
        """The motion of the part's body, which it must have."""
        assert self.motion is not None
        return self.motion

    def __getitem__(self, name: str) -> Any:
        return self.numbers[name]

    def __contains__(self, name: str) -> bool:
        return name in self.numbers


# --- Parts ---


class Part(ABC):
    """A named thing in a circuit."""

    kind: ClassVar[str] = ""
    summary: ClassVar[str]
    resume: ClassVar[dict[str, str]] = {}
    """Outputs that say where a run may start again, with the number that each of them becomes."""
    internal_outputs: ClassVar[tuple[str, ...]] = ()
    """Series that show how the part works inside: a picture has them by name, or when all are asked for."""

    def __post_init__(self) -> None:
        # First, so that a copy with another `data` or `mode` does not keep the numbers of the old set as given ones.
        forget(self, self.library_sets())
        try:
            known = self.library_numbers()
        except InputError as error:
            raise error.located(address="data") from None
        complete(self, known)
        self.check()

    def library_sets(self) -> Sequence[Mapping[str, Number]]:
        """All sets of which a copy of the part may carry numbers; they give way to `library_numbers`."""
        return library.every_set(self.kind) if hasattr(self, "data") else ()

    def library_numbers(self) -> Mapping[str, Number]:
        """Numbers of a library set, used for fields that were not given."""
        data = getattr(self, "data", None)
        return {} if data is None else library.numbers(str(data), self.kind, self.variant())

    def variant(self) -> str:
        """Which numbers of its library set a part takes, where the set has several for it."""
        return ""

    def check(self) -> None:  # noqa: B027 - most parts have no rule beyond those of their fields
        """Raise `InputError` where fields contradict each other."""

    def check_start(self, travel: float) -> None:  # noqa: B027 - most parts hold no body
        """Raise `InputError` where the part cannot be with its body's travel at the start [m]."""

    def notes(self) -> tuple[Note, ...]:
        """What a reader of any result has to know about the fields that were given, with addresses within the part."""
        return ()

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        """What a reader of a run has to know; `series` gives the (n_times,) array of an output, or of `time`."""
        return ()

    def numbers(self) -> dict[str, Number]:
        """Every number of the part by its dotted local name."""
        return {name: value for name, _, value in flatten(self)}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        """Run-time values, SI and absolute, of numbers and what derives from them; the names follow the structure."""
        values = {}
        for name, spec, value in flatten(self):
            try:
                values[name] = value.absolute(ambient.pressure)
            except InputError as error:
                raise error.located(address=name) from None
            if value.reference == "gauge":
                # Only now is its absolute value known, to which the limits refer.
                spec.check(name, values[name], f"{value.display()} ({values[name]:g} Pa absolute)")
        return values

    def ports(self) -> dict[str, str]:
        """Port name to the name of the store it is joined to."""
        named = ((name, getattr(self, own)) for name, own, _ in declared(type(self), PortSpec))
        return {name: store for name, store in named if store is not None}

    def outer_ports(self) -> dict[str, str]:
        """Port of another part that names this one, to the store of this one that it is joined to."""
        return {}

    def stores(self) -> tuple[str, ...]:
        """Local names of the gas states that ports may be joined to; the empty name is the part itself."""
        return ()

    def body_name(self) -> str | None:
        """Name of the body that the part moves or is moved by."""
        return next((getattr(self, own) for _, own, _ in declared(type(self), BodySpec)), None)

    def list_internal_outputs(self) -> tuple[str, ...]:
        """Inner series of the part in its form."""
        return self.internal_outputs

    def options(self) -> dict[str, str]:
        """Choices that shape the model."""
        return {name: getattr(self, own) for name, own, _ in declared(type(self), OptionSpec)}

    def structure(self) -> Hashable:
        """Everything but values: two parts of equal structure share one compiled model."""
        return self.kind, tuple(self.options().items()), tuple(sorted(self.ports().items())), self.body_name()

    def replaced_fields(self, fields: Iterable[str]) -> tuple[str, ...]:
        """Fields that go where a file of numbers brings others which they cannot stand beside."""
        return ()

    def states(self) -> tuple[State, ...]:
        """States of the part."""
        return ()

    def inputs(self) -> tuple[Input, ...]:
        """Inputs of the part."""
        return ()

    def memory(self) -> tuple[DiscreteState, ...]:
        """Sampled memory of the part, its timers not among them."""
        return ()

    def timers(self) -> tuple[Timer, ...]:
        """Instants at which the memory changes."""
        return ()

    def start(self, scope: Scope) -> dict[str, Any]:
        """Initial values of states, memory and timers."""
        # The scope has neither states nor memory yet; inputs have the values that they begin with.
        return {}

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        """New values of memory and timers, that timer among them; what is not named keeps its value."""
        raise NotImplementedError(f"{self.kind} has no timers")

    def can_resume(self, target: str) -> bool:
        """True when the number of that name has a meaning for this part's form."""
        return target != "wall_temperature" or any(state.name == target for state in self.states())

    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        """State or input name to the characteristic that holds only over a range of it, and its end stops."""
        return {}


class Store(Part):
    """A part that holds gas and offers its state."""

    def stores(self) -> tuple[str, ...]:
        return ("",)

    @abstractmethod
    def gas(self, scope: Scope) -> GasState:
        """The gas at its ports."""

    @abstractmethod
    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        """Rates and outputs for all flows, (mass [kg/s], enthalpy [W]), positive into the store."""


class Passage(Part):
    """A part that moves gas between stores."""

    @abstractmethod
    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        """Flows, rates and outputs for the gas states at its ports, by port name."""


class Actuator(Part):
    """A part that pushes a body."""

    @abstractmethod
    def actuator_force(self, scope: Scope, gas: Mapping[str, GasState]) -> ActuatorForce:
        """Force on its body for the gas states at its ports, and at itself under `SELF` when it is a store."""


class Body(Part):
    """A part that moves."""

    @abstractmethod
    def initial_travel(self) -> float:
        """Travel at the start [m]; a signal may say otherwise."""

    @abstractmethod
    def motion(self, scope: Scope) -> BodyMotion:
        """Travel and speed of the point that its actuators hold."""

    @abstractmethod
    def dynamics(self, scope: Scope, force: Any, friction: Any) -> BodyDynamics:
        """Rates and outputs under the sum of the actuators' forces and of what they add to its friction [N]."""


class Controller(Part):
    """A part that moves no gas: it reads, remembers and gives signals."""

    measured: ClassVar[tuple[str, ...]] = ()
    """Inputs without which it controls nothing: a run in which they are left alone says so."""

    def sensors(self) -> dict[str, tuple[str, str]]:
        """State of each sensor to the input that it follows, and the group of its numbers: no part of a program."""
        return {}

    @abstractmethod
    def control(self, scope: Scope) -> ControlOutputs:
        """Outputs, and rates of the part's own states."""


def is_port(end: str) -> bool:
    """Whether an end of a tube is a port of another part, `valve.outlet`, and no store."""
    return end.partition(".")[2] in PORTS


def advance_clock(scope: Scope, timer: str, period: Any, phase: Any = 0.0) -> dict[str, Any]:
    """A clock set to its next instant, counted from the start so that no rounding adds up."""
    count = scope.memory[f"{timer}_count"] + 1.0
    return {timer: phase + count * period, f"{timer}_count": count}

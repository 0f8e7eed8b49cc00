"""Base classes of parts and the quantities that they exchange.

Gas nodes (`Store`) contain gas, flow paths (`Passage`) move it between them, actuators act on bodies, and controllers
sample. Parts are frozen dataclasses with their equations.

A part does not use symbols of other parts. The trace of a circuit calls the methods of parts in this order:

1. a body returns its motion for its states,
2. a gas node returns its gas state for its states and the motion of its body,
3. a flow path returns its flows, and an actuator its force, for the gas states at their ports,
4. a gas node returns its rates for the sum of its flows, and a body its rates for the sum of its forces.

Discrete states change at sample instants only. The same methods accept floats.
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
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import (
    BodySpec,
    OptionSpec,
    ParameterDocstring,
    PortSpec,
    complete,
    declared,
    flatten,
    forget_library,
)
from poppet.parts.symbols import Symbol

AMBIENT = "ambient"
"""Reserved name of the ambient, to which any port can be connected."""
NEVER = 1e300
"""Time of a timer that is inactive [s]."""
SELF = "self"
"""End of a flow at the part itself, if the part is a gas node too."""
TUBE = "tube"
"""Kind of the parts whose ends can name ports of other parts."""
PORTS = ("from", "to", "supply", "outlet", "exhaust", "pilot_exhaust", "a", "b", "exhaust_a", "exhaust_b")
"""Names of ports that the end of a tube can refer to: `valve.outlet`."""

Quantities = dict[str, tuple[Any, str]]
"""Outputs: local name to value and unit."""


@dataclass(frozen=True)
class State:
    """Element of the state vector with its local name and SI unit."""

    name: str
    unit: str
    nominal: float  # nominal size, a lower bound of the size to which the absolute tolerance refers
    tolerance: float = 1.0  # factor on the relative tolerance; larger for mechanics than for gas
    floor: float = 1e-3  # absolute tolerance per relative tolerance and nominal size
    positive: bool = False  # reject steps to zero or below


@dataclass(frozen=True)
class Input:
    """Quantity that a signal or a connection can drive, with its local name and SI unit."""

    name: str
    unit: str
    default: str | float  # value without a signal, or the name of the parameter with this value
    kind: str = "plain"  # of quantity, see `poppet.core.units.quantity`
    low: str | float = float("-inf")  # limits of the values, or names of parameters
    high: str | float = float("inf")
    delay: str = ""  # name of the parameter that delays a signal
    slope_of: str = ""  # input whose time derivative it is; it cannot be driven on its own
    by_signal: bool = False  # only a signal can drive it


@dataclass(frozen=True)
class DiscreteState:
    """Quantity that is constant between sample instants, with its local name and SI unit."""

    name: str
    unit: str


@dataclass(frozen=True)
class Timer:
    """Next sample instant of a part [s]; the part sets a new time, or `NEVER`, at each instant."""

    name: str
    rank: int = 0  # order at a common instant; equal ranks act in the order of the parts


@dataclass(frozen=True)
class GasState:
    """Pressure [Pa] and temperature [K] of a gas node."""

    pressure: Any
    temperature: Any


@dataclass(frozen=True)
class BodyMotion:
    """Travel [m] and speed [m/s] of a body at the point where its actuators act."""

    position: Any
    velocity: Any


@dataclass(frozen=True)
class ActuatorForce:
    """Force on a body towards larger positions [N], and an addition to the friction of the body [N]."""

    force: Any
    outputs: Quantities = field(default_factory=dict)
    rates: dict[str, Any] = field(default_factory=dict)
    friction: Any = 0.0


@dataclass(frozen=True)
class BodyDynamics:
    """Outputs, rates and energy [J] of a body.

    `powers` are those of the actuators minus the load, and of friction and stops [W].
    """

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    energy: Any = None
    powers: tuple[Any, ...] = ()


@dataclass(frozen=True)
class Flow:
    """Flow of gas between two ports, positive from source to target."""

    name: str  # output of the mass flow rate
    source: str | None  # a port or `SELF`; None is outside the circuit
    target: str | None
    mass: Any  # mass flow rate [kg/s]
    enthalpy: Any  # enthalpy flow rate [W]


@dataclass(frozen=True)
class PassageFlows:
    """Flows between the ports of a flow path, with its outputs and the rates of its states."""

    flows: tuple[Flow, ...]
    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    hidden: Quantities = field(default_factory=dict)  # available to connections, absent from recordings


@dataclass(frozen=True)
class GasBalance:
    """Outputs and rates of a gas node for its flows.

    `heat` is the heat from the wall and `work` the work on the gas [W]. `energy` is given only if it is linear in the
    states [J].
    """

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    heat: Any = None
    energy: Any = None
    work: Any = None
    totals: Quantities = field(default_factory=dict)  # sums of other outputs; last columns of a recording


@dataclass(frozen=True)
class ControlOutputs:
    """Outputs of a controller between sample instants, and the rates of its continuous states."""

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Surroundings:
    """Ambient pressure [Pa], ambient temperature [K] and gas of a circuit, as floats or symbols."""

    pressure: Any
    temperature: Any
    gas_constant: Any  # specific [J/(kg K)]
    isentropic_exponent: Any
    conductance_factor: Any  # ratio of the sonic conductance with this gas to that with air
    ratio_shift: Any = 0.0  # fraction of 1 - b by which this gas increases critical ratios

    @property
    def heat_capacity_pressure(self) -> Any:
        """Specific heat capacity at constant pressure [J/(kg K)]."""
        return self.isentropic_exponent * self.heat_capacity_volume

    @property
    def heat_capacity_volume(self) -> Any:
        """Specific heat capacity at constant volume [J/(kg K)]."""
        return self.gas_constant / (self.isentropic_exponent - 1.0)

    def size_with_gas(self, conductance: Any, ratio: Any) -> tuple[Any, Any]:
        """Return C and b with this gas for C and b of the circuit file."""
        return conductance * self.conductance_factor, ratio + (1.0 - ratio) * self.ratio_shift

    def stated_size(self, conductance: float, ratio: float) -> tuple[float, float]:
        """Return C and b of the circuit file for C and b with this gas; inverse of `size_with_gas`."""
        return conductance / self.conductance_factor, (ratio - self.ratio_shift) / (1.0 - self.ratio_shift)


@dataclass(frozen=True)
class Scope:
    """Parameters, states, inputs and discrete states of one part (floats or symbols), surroundings and time [s]."""

    numbers: Mapping[str, Any]
    states: Mapping[str, Any]
    inputs: Mapping[str, Any]
    surroundings: Surroundings
    memory: Mapping[str, Any] = field(default_factory=dict)
    time: Any = 0.0
    motion: BodyMotion | None = None  # of the body of the part

    @property
    def body(self) -> BodyMotion:
        """Motion of the body of the part; the part must have one."""
        assert self.motion is not None
        return self.motion

    def __getitem__(self, name: str) -> Any:
        return self.numbers[name]

    def __contains__(self, name: str) -> bool:
        return name in self.numbers


# --- Parts ---


class Part(ABC):
    """Component of a circuit with a name."""

    kind: ClassVar[str] = ""
    summary: ClassVar[str]
    symbol: ClassVar[Symbol | str] = ""
    """Strokes of the symbol, or the text of a labelled box; an empty text stands for the kind."""
    resume: ClassVar[dict[str, str]] = {}
    """Outputs from which a run can continue, with the initial value that each of them sets."""
    internal_outputs: ClassVar[tuple[str, ...]] = ()
    """Outputs that plots omit unless they are requested by name or all outputs are."""

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        if isinstance(text := vars(cls).get("__doc__"), str):
            cls.__doc__ = ParameterDocstring(text)  # type: ignore[assignment]

    def __post_init__(self) -> None:
        # First, so that a copy with another `data` or `mode` does not keep the numbers of the previous set.
        forget_library(self, self.library_sets())
        try:
            library_numbers = self.library_numbers()
        except InputError as error:
            raise error.located(address="data") from None
        complete(self, library_numbers)
        self.check()

    def library_sets(self) -> Sequence[Mapping[str, Number]]:
        """Return all sets from which a copy of the part can have numbers; `library_numbers` replaces these."""
        return library.every_set(self.kind) if hasattr(self, "data") else ()

    def library_numbers(self) -> Mapping[str, Number]:
        """Return the numbers of a library set, for fields without a value."""
        data = getattr(self, "data", None)
        return {} if data is None else library.numbers(str(data), self.kind, self.variant())

    def variant(self) -> str:
        """Return the variant of the library set that applies to the part."""
        return ""

    def check(self) -> None:  # noqa: B027 - most parts have no rule beyond those of their fields
        """Raise `InputError` if fields contradict each other."""

    def check_start(self, travel: float) -> None:  # noqa: B027 - most parts have no body
        """Raise `InputError` if the initial travel of the body [m] is not possible for the part."""

    def notes(self) -> tuple[Note, ...]:
        """Return notes on the fields for the reader of any result, with addresses within the part."""
        return ()

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        """Return notes on a run; `series` returns the (n_times,) array of an output, or of `time`."""
        return ()

    def numbers(self) -> dict[str, Number]:
        """Return all numbers of the part by dotted local name."""
        return {name: value for name, _, value in flatten(self)}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        """Return the run-time parameters: numbers and derived values, in SI and absolute.

        The names depend on the structure only.
        """
        values = {}
        for name, spec, value in flatten(self):
            try:
                values[name] = value.absolute(ambient.pressure)
            except InputError as error:
                raise error.located(address=name) from None
            if value.reference == "gauge":
                # The limits refer to the absolute value, which is known only here.
                spec.check(name, values[name], f"{value.display()} ({values[name]:g} Pa absolute)")
        return values

    def ports(self) -> dict[str, str]:
        """Return the gas node that is connected to each port."""
        connected = ((name, getattr(self, attribute)) for name, attribute, _ in declared(type(self), PortSpec))
        return {name: node for name, node in connected if node is not None}

    def outer_ports(self) -> dict[str, str]:
        """Return the ports of other parts that name this part, with the gas node of this part for each."""
        return {}

    def stores(self) -> tuple[str, ...]:
        """Return the local names of the gas nodes to which ports can be connected; empty for the part itself."""
        return ()

    def body_name(self) -> str | None:
        """Return the name of the body on which the part acts."""
        return next((getattr(self, attribute) for _, attribute, _ in declared(type(self), BodySpec)), None)

    def list_internal_outputs(self) -> tuple[str, ...]:
        """Return the internal outputs of the part with its options."""
        return self.internal_outputs

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        """Return the lines in the box of the part in a schematic."""
        first = list(self.numbers().items())[:3]
        values = (f"{name.replace('_', ' ')} {numbers.text(number)}" for name, number in first)
        return [self.kind.replace("_", " "), *values]

    def symbol_for(self, is_driven: bool) -> Symbol | str:
        """Return the symbol; `is_driven` is True if a signal or a connection drives an input."""
        return self.symbol

    def options(self) -> dict[str, str]:
        """Return the options that determine the form of the model."""
        return {name: getattr(self, attribute) for name, attribute, _ in declared(type(self), OptionSpec)}

    def structure(self) -> Hashable:
        """Return all that determines the compiled model, without values."""
        return self.kind, tuple(self.options().items()), tuple(sorted(self.ports().items())), self.body_name()

    def replaced_fields(self, fields: Iterable[str]) -> tuple[str, ...]:
        """Return the fields to remove because a file sets `fields`, which contradict them."""
        return ()

    def states(self) -> tuple[State, ...]:
        """Return the states of the part."""
        return ()

    def inputs(self) -> tuple[Input, ...]:
        """Return the inputs of the part."""
        return ()

    def memory(self) -> tuple[DiscreteState, ...]:
        """Return the discrete states of the part, without its timers."""
        return ()

    def timers(self) -> tuple[Timer, ...]:
        """Return the timers at which discrete states change."""
        return ()

    def start(self, scope: Scope) -> dict[str, Any]:
        """Return initial values of states, discrete states and timers."""
        # The scope has no states yet. Inputs have their initial values.
        return {}

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        """Return new values of discrete states and timers, including this timer; others keep their values."""
        raise NotImplementedError(f"{self.kind} has no timers")

    def can_resume(self, target: str) -> bool:
        """Return True if the part with its options uses the initial value `target`."""
        return target != "wall_temperature" or any(state.name == target for state in self.states())

    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        """Return, for states and inputs, the characteristic with a limited domain and the end stops."""
        return {}


class Store(Part):
    """Gas node: a part that contains gas."""

    def stores(self) -> tuple[str, ...]:
        return ("",)

    @abstractmethod
    def gas(self, scope: Scope) -> GasState:
        """Return the gas state at the ports."""

    @abstractmethod
    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        """Return rates and outputs for all flows, (mass [kg/s], enthalpy [W]), positive into the node."""


class Passage(Part):
    """Flow path: a part that moves gas between gas nodes."""

    @abstractmethod
    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        """Return flows, rates and outputs for the gas states by port name."""


class Actuator(Part):
    """Part that exerts a force on a body."""

    @abstractmethod
    def actuator_force(self, scope: Scope, gas: Mapping[str, GasState]) -> ActuatorForce:
        """Return the force for the gas states by port name; `SELF` is the gas of the actuator itself."""


class Body(Part):
    """Part that moves."""

    @abstractmethod
    def initial_travel(self) -> float:
        """Return the travel at the start without a signal [m]."""

    @abstractmethod
    def motion(self, scope: Scope) -> BodyMotion:
        """Return travel and speed of the point where the actuators act."""

    @abstractmethod
    def dynamics(self, scope: Scope, force: Any, friction: Any) -> BodyDynamics:
        """Return rates and outputs for the sums of the actuators' forces and additions to friction [N]."""


class Controller(Part):
    """Part without gas flows that measures, samples and drives inputs of other parts."""

    measured: ClassVar[tuple[str, ...]] = ()
    """Inputs that the controller needs; a run notes each of them that is not connected."""

    def sensors(self) -> dict[str, tuple[str, str]]:
        """Return the measured input and the parameter group of each sensor, by state.

        Sensors are not part of an exported controller.
        """
        return {}

    @abstractmethod
    def control(self, scope: Scope) -> ControlOutputs:
        """Return outputs, and rates of the continuous states."""


def is_port(end: str) -> bool:
    """Return True if the end of a tube is a port of another part, `valve.outlet`, instead of a gas node."""
    return end.partition(".")[2] in PORTS


def advance_clock(scope: Scope, timer: str, period: Any, phase: Any = 0.0) -> dict[str, Any]:
    """Return the next instant of a clock and its counter; counting from the start avoids accumulated rounding."""
    count = scope.memory[f"{timer}_count"] + 1.0
    return {timer: phase + count * period, f"{timer}_count": count}

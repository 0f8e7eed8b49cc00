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
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any, ClassVar, NamedTuple

from poppet import library
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.provenance import Number
from poppet.core.symbolic import SymbolicValueError, is_symbolic, new_symbol, where
from poppet.laws.iso6358 import REGIMES
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import (
    BodySpec,
    OptionSpec,
    ParameterDocstring,
    PortSpec,
    complete,
    declared,
    flatten,
    forget_component,
    forget_library,
)
from poppet.parts.symbols import Symbol

AMBIENT = "ambient"
"""Reserved name of the ambient, to which any port can be connected."""
NEVER = 1e300
"""Time of a timer that is inactive [s]."""
SELF = "self"
"""Name of the end of a flow in the part itself, for parts that are also gas nodes."""
TUBE = "tube"
"""Kind of the parts whose ends can name ports of other parts."""
PORTS = (
    "from", "to", "supply", "inlet", "outlet", "exhaust", "pilot", "pilot_exhaust", "a", "b", "exhaust_a",
    "exhaust_b", "pilot_a", "pilot_b", "drive_supply", "vacuum", "port",
)  # fmt: skip
"""Names of ports that the end of a tube can refer to: `valve.outlet`."""

Quantities = dict[str, tuple[Any, str]]
"""Mapping from the local name of each output to value and unit."""


@dataclass(frozen=True)
class State:
    """Declaration of a continuous state of a part, with its name within the part and its SI unit."""

    name: str
    unit: str
    nominal: float  # nominal size, a lower bound of the size to which the absolute tolerance refers
    tolerance: float = 1.0  # factor on the relative tolerance; larger for mechanics than for gas
    floor: float = 1e-3  # absolute tolerance per relative tolerance and nominal size
    positive: bool = False  # reject steps to zero or below


@dataclass(frozen=True)
class Input:
    """Declaration of an input of a part, which a signal or the output of another part can drive."""

    name: str
    unit: str
    default: str | float  # value without a signal, or the name of the parameter with this value
    kind: str = "plain"  # of quantity, see `poppet.core.units.quantity`
    low: str | float = float("-inf")  # limits of the values, or names of parameters
    high: str | float = float("inf")
    delay: str = ""  # name of the parameter that delays a signal
    slope_of: str = ""  # input whose time derivative it is; it cannot be driven on its own
    by_signal: bool = False  # only a signal can drive it
    is_command: bool = False  # setpoint or command that a user changes to move a body
    is_flag: bool = False  # 0 or 1, a Boolean in exported programs
    is_onset: bool = False  # without a signal, 0 before its delay, and its default afterwards
    at_rest: float | None = None  # value in steady states, unless another value is requested
    is_coupled: bool = False  # output of an FMU, which only a co-simulation sets


@dataclass(frozen=True)
class DiscreteState:
    """Declaration of a state of a part that changes at sample instants only."""

    name: str
    unit: str


@dataclass(frozen=True)
class Timer:
    """Declaration of a timer of a part, whose value is the time of its next sample instant [s].

    At each sample instant, the part sets a new time. The time `NEVER` stops the timer.
    """

    name: str
    rank: int = 0  # order at a common instant; equal ranks act in the order of the parts
    is_simultaneous: bool = False  # its update uses the discrete states before the instant


@dataclass(frozen=True)
class GasState:
    """Pressure [Pa] and temperature [K] of the gas in a gas node."""

    pressure: Any
    temperature: Any


@dataclass(frozen=True)
class BodyMotion:
    """Travel [m] and speed [m/s] of a body at the point on which its actuators act."""

    position: Any
    velocity: Any


@dataclass(frozen=True)
class ActuatorForce:
    """Force of an actuator on a body, and additional dry friction of the body [N].

    The force is positive towards larger positions. The class also contains outputs of the actuator and the time
    derivatives of its states. The power of the gas minus the power of the force is the sum of `losses`, by name [W],
    and of the time derivative of `energy`, which is the elastic energy of the actuator [J].
    """

    force: Any
    outputs: Quantities = field(default_factory=dict)
    rates: dict[str, Any] = field(default_factory=dict)
    friction: Any = 0.0
    losses: dict[str, Any] = field(default_factory=dict)
    energy: Any = 0.0


@dataclass(frozen=True)
class BodyDynamics:
    """Outputs of a body, time derivatives of its states (`rates`), and its energy [J].

    `powers` contains the power of the actuators minus the power of the load, and the power of friction and stops [W].
    `loads` and `losses` contain the same powers of load, weight, friction and stops by name, positive if they take
    energy from the body [W].
    """

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    energy: Any = None
    powers: tuple[Any, ...] = ()
    loads: dict[str, Any] = field(default_factory=dict)
    losses: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Flow:
    """Mass and enthalpy flow rate of gas between two ports.

    Both are positive from `source` to `target`.
    """

    name: str  # output of the mass flow rate
    source: str | None  # a port or `SELF`; None is outside the circuit
    target: str | None
    mass: Any  # mass flow rate [kg/s]
    enthalpy: Any  # enthalpy flow rate [W]


@dataclass(frozen=True)
class PassageFlows:
    """Gas flows of a flow path, its outputs, and the time derivatives of its states (`rates`)."""

    flows: tuple[Flow, ...]
    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    hidden: Quantities = field(default_factory=dict)  # available to connections, absent from recordings


@dataclass(frozen=True)
class GasBalance:
    """Outputs of a gas node, and time derivatives of its states (`rates`).

    `heat` is the heat flow rate from the wall to the gas, and `work` the power of the volume change on the gas [W].
    `energy` is the energy of the gas [J], or None if it is not linear in the states.
    """

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    heat: Any = None
    energy: Any = None
    work: Any = None
    totals: Quantities = field(default_factory=dict)  # sums of other outputs; last columns of a recording


@dataclass(frozen=True)
class ControlOutputs:
    """Outputs of a controller, and time derivatives of its continuous states (`rates`).

    They are valid between two sample instants.
    """

    outputs: Quantities
    rates: dict[str, Any] = field(default_factory=dict)
    hidden: Quantities = field(default_factory=dict)  # available to connections, absent from recordings


@dataclass(frozen=True)
class PartConnection:
    """Connection of an input of a part to an output of the circuit.

    `source` is the address of the output, and `place` the address of the field of the part that names the output. If
    `is_integer` is True, the values of the output must be integers.
    """

    source: str
    place: str
    is_integer: bool = False


@dataclass(frozen=True)
class Surroundings:
    """Ambient pressure, ambient temperature and gas properties of a circuit.

    The values are floats or symbols in SI units.
    """

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

    def capacity_in_circuit_gas(self, conductance: Any, ratio: Any) -> tuple[Any, Any]:
        """Convert C [m^3/(s Pa)] and b [1] as stated in a circuit file to the gas of the circuit.

        The file can state values that were measured with air.
        """
        return conductance * self.conductance_factor, ratio + (1.0 - ratio) * self.ratio_shift

    def capacity_as_stated(self, conductance: float, ratio: float) -> tuple[float, float]:
        """Convert C [m^3/(s Pa)] and b [1] for the gas of the circuit to the form in a circuit file.

        The file can state values that were measured with air. This is the inverse of `capacity_in_circuit_gas`.
        """
        return conductance / self.conductance_factor, (ratio - self.ratio_shift) / (1.0 - self.ratio_shift)


class Case(NamedTuple):
    """Values of results for one value of a selector, for example for one step of a sequence."""

    title: str  # comment in exported code
    values: Mapping[str, Any]  # results that are not 0


@dataclass(frozen=True)
class Selection:
    """Results that a selector determines, which exported code computes in a CASE or switch statement.

    Parameters
    ----------
    selector : float or symbol
        Number of the case; the first case has the number 1.
    cases : tuple of Case
        Cases in the order of their numbers.
    symbols : dict
        Mapping from the name of each result to the symbol that stands for it in other expressions.
    flags : frozenset of str
        Names of the results that are 0 or 1.
    titles : dict
        Mapping from a value of a result to a comment, for example from the number of a step to its name.
    """

    selector: Any
    cases: tuple[Case, ...]
    symbols: Mapping[str, Any]
    flags: frozenset[str] = frozenset()
    titles: Mapping[int, str] = field(default_factory=dict)


@dataclass(frozen=True)
class Scope:
    """Values that the equations of one part use, as floats or symbols in SI units.

    They are the parameters (`numbers`), states, inputs and discrete states (`memory`) of the part, the ambient
    conditions, the time [s], and the motion of its body.
    """

    numbers: Mapping[str, Any]
    states: Mapping[str, Any]
    inputs: Mapping[str, Any]
    surroundings: Surroundings
    memory: Mapping[str, Any] = field(default_factory=dict)
    time: Any = 0.0
    motion: BodyMotion | None = None  # of the body of the part
    has_relative_time: bool = False  # timers contain the time that remains until their instants
    labels: dict[str, tuple[Any, str]] = field(default_factory=dict)  # see `label`
    selections: list[Selection] = field(default_factory=list)  # see `select`

    @property
    def body(self) -> BodyMotion:
        """Travel and speed of the body on which the part acts.

        Only the scope of a part that acts on a body has this property.
        """
        assert self.motion is not None
        return self.motion

    def label(self, name: str, value: Any, meaning: str) -> None:
        """Name an intermediate value of the equations in exported code.

        `meaning` is its description with unit, which becomes a comment.
        """
        self.labels[name] = value, meaning

    def select(
        self,
        selector: Any,
        cases: Sequence[Case],
        *,
        flags: Iterable[str] = (),
        titles: Mapping[int, str] | None = None,
    ) -> dict[str, Any]:
        """Return the results of the case with the number `selector`.

        Exported code computes them in a CASE or switch statement; a simulation in nested choices.

        Parameters
        ----------
        selector : float or symbol
            Number of the case, an integer from 1 to the number of cases.
        cases : sequence of Case
            Cases in the order of their numbers.
        flags : iterable of str, optional
            Names of the results that are 0 or 1.
        titles : mapping, optional
            Comments in exported code by the value of a result.

        Returns
        -------
        dict
            Mapping from the name of each result to its value. A result is 0 if its case has no value.

        Examples
        --------
        >>> cases = [Case("extend", {"a": 1.0}), Case("retract", {"b": 1.0})]
        >>> Scope({}, {}, {}, None).select(2.0, cases)
        {'a': 0.0, 'b': 1.0}
        """
        names = tuple(dict.fromkeys(name for case in cases for name in case.values))
        results = {name: _value_of_case(selector, cases, name) for name in names}
        # Initial values, for which there is no memory, are not selections of a program.
        if not (self.has_relative_time and self.memory and is_symbolic(selector)):
            return results
        symbols = {name: new_symbol(name) for name, value in results.items() if is_symbolic(value)}
        if symbols:
            chosen = frozenset(name for name in flags if name in symbols)
            self.selections.append(Selection(selector, tuple(cases), symbols, chosen, titles or {}))
        return results | symbols

    def __getitem__(self, name: str) -> Any:
        return self.numbers[name]

    def __contains__(self, name: str) -> bool:
        return name in self.numbers


def _value_of_case(selector: Any, cases: Sequence[Case], name: str) -> Any:
    """Return one result of the case with the number `selector`."""
    result = cases[-1].values.get(name, 0.0)
    for number in range(len(cases) - 1, 0, -1):
        value = cases[number - 1].values.get(name, 0.0)
        # Equal values of successive cases need no choice.
        are_equal = value is result or (not is_symbolic(value, result) and value == result)
        result = result if are_equal else where(selector < number + 0.5, value, result)
    return result


# --- Parts ---


class Part(ABC):
    """Base class of all components of a circuit."""

    kind: ClassVar[str] = ""
    summary: ClassVar[str]
    symbol: ClassVar[Symbol | str] = ""
    """Strokes of the symbol, or the text of a labelled box; an empty text stands for the kind."""
    inlet_ports: ClassVar[tuple[str, ...]] = ()
    """Ports at which positive flow enters the part; if empty, the first of several ports."""
    pilot_ports: ClassVar[tuple[str, ...]] = ()
    """Ports whose pressure acts on the part, but through which no gas flows."""
    resume: ClassVar[dict[str, str]] = {}
    """Mapping from each output from which a run can continue to the field of the initial value."""
    sizes: ClassVar[tuple[str, ...]] = ()
    """Fields of which exactly one states the size of the part, unless a component does."""
    is_switching: ClassVar[bool] = False
    """True for controllers whose outputs jump from one value to another, such as a sequence."""
    internal_outputs: ClassVar[tuple[str, ...]] = ()
    """Outputs that plots omit unless they are requested by name or all outputs are."""

    def __init_subclass__(cls) -> None:
        super().__init_subclass__()
        if isinstance(text := vars(cls).get("__doc__"), str):
            cls.__doc__ = ParameterDocstring(text)  # type: ignore[assignment]

    def __post_init__(self) -> None:
        # First, so that a copy with another `data` or `mode` does not keep the numbers of the previous set.
        forget_library(self, self.library_sets())
        stated = self.component_numbers()
        try:
            library_numbers = self.library_numbers()
        except InputError as error:
            raise error.located(address="data") from None
        complete(self, {**library_numbers, **stated} if stated else library_numbers)
        # A symbol in place of a number has no value to check.
        with suppress(SymbolicValueError):
            self.check()

    def library_sets(self) -> Sequence[Mapping[str, Number]]:
        """Return the numbers of all published parameter sets for this kind of part.

        If a copy of the part selects another parameter set, numbers from these sets are replaced.
        """
        return library.every_set(self.kind) if hasattr(self, "data") else ()

    def library_numbers(self) -> Mapping[str, Number]:
        """Return the numbers of the published parameter set that the field `data` selects.

        They are used for fields without an argument. The result is empty if `data` is None.
        """
        data = getattr(self, "data", None)
        return {} if data is None else library.numbers(str(data), self.kind, self.variant())

    def component_numbers(self) -> Mapping[str, Number]:
        """Return the numbers of the component that the field `model` selects.

        They are used for fields without an argument. Numbers of a component that was selected before are removed, and
        options that the component determines are set. The result is empty if there is no component.
        """
        stated: Mapping[str, Number] = {}
        if not hasattr(self, "model"):
            return stated
        if self.model is not None:
            from poppet.parts.components import numbers_of, select_component

            stated = numbers_of(select_component(self), type(self))
        forget_component(self, stated)
        return self.usable_numbers(stated) if stated else stated

    def usable_numbers(self, stated: Mapping[str, Number]) -> Mapping[str, Number]:
        """Return the numbers of a component without those that other fields of the part exclude.

        `stated` contains all numbers of the component by field.
        """
        return stated

    def variant(self) -> str:
        """Return the variant of the parameter set for the options of the part, such as a preset.

        It is empty for parts without variants.
        """
        return ""

    def check(self) -> None:  # noqa: B027 - most parts have no rule beyond those of their fields
        """Raise `InputError` if the values of several fields contradict each other."""

    def check_start(self, travel: float) -> None:  # noqa: B027 - most parts have no body
        """Raise `InputError` if the part cannot start at the initial travel of its body.

        `travel` is this initial travel [m].
        """

    def notes(self) -> tuple[Note, ...]:
        """Return notes on the fields of the part, for example on an assumed value.

        Every result contains them. Their addresses are relative to the part.
        """
        return ()

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        """Return notes on a finished run, for example on a limit that was exceeded.

        `name` is the name of the part. `series` is a function that returns the recorded values, shape (n_times,), for
        the address of an output or for `time`.
        """
        return ()

    def numbers(self) -> dict[str, Number]:
        """Return all numbers of the part by dotted name, for example `lower_spring.rate`."""
        return {name: value for name, _, value in flatten(self)}

    def parameters(self, ambient: Surroundings) -> dict[str, float]:
        """Return the values of all parameters in the equations of the part, by name.

        They are the numbers of the part, and values that are computed from them. All values are in SI units, and
        pressures are absolute. The names do not depend on the values.
        """
        values = {}
        for name, spec, value in flatten(self):
            try:
                values[name] = value.absolute(ambient.pressure)
            except InputError as error:
                raise error.located(address=name) from None
            if value.reference == "gauge" and not is_symbolic(values[name]):
                # The limits refer to the absolute value, which is known only here.
                spec.check(name, values[name], f"{value.display()} ({values[name]:g} Pa absolute)")
        return values

    def ports(self) -> dict[str, str]:
        """Return a mapping from the name of each connected port to the name of its gas node."""
        connected = ((name, getattr(self, attribute)) for name, attribute, _ in declared(type(self), PortSpec))
        return {name: node for name, node in connected if node is not None}

    def outer_ports(self) -> dict[str, str]:
        """Return a mapping from ports of other parts to the gas nodes of this part.

        It contains the ports that a field of this part names, such as an end of a tube.
        """
        return {}

    def stores(self) -> tuple[str, ...]:
        """Return the names of the gas nodes within the part, to which ports can be connected.

        An empty name is the part itself.
        """
        return ()

    def body_name(self) -> str | None:
        """Return the name of the body on which the part acts, or None if it acts on no body."""
        return next((getattr(self, attribute) for _, attribute, _ in declared(type(self), BodySpec)), None)

    def inner_bodies(self) -> tuple[str, ...]:
        """Return the names of the bodies within the part."""
        return ()

    def integer_outputs(self) -> tuple[str, ...]:
        """Return the names of the outputs whose values are always integers."""
        return tuple(item.name for item in self.inputs() if item.is_flag)

    def lost_at_resume(self) -> tuple[str, ...]:
        """Return the names of discrete states that a resumed run cannot continue."""
        return ()

    def list_internal_outputs(self) -> tuple[str, ...]:
        """Return the names of the outputs that plots omit by default."""
        return self.internal_outputs

    def caption(self, numbers: CaptionNumbers) -> list[str]:
        """Return the lines of text with which a schematic describes the part."""
        first = list(self.numbers().items())[:3]
        values = (f"{name.replace('_', ' ')} {numbers.text(number)}" for name, number in first)
        return [self.kind.replace("_", " "), *values]

    def symbol_for(self, is_driven: bool) -> Symbol | str:
        """Return the symbol of the part in a schematic, or the text of its box.

        `is_driven` is True if a signal or a connection drives an input of the part.
        """
        return self.symbol

    def options(self) -> dict[str, str]:
        """Return the selected word of each option by name; the options determine the equations of the part."""
        return {name: getattr(self, attribute) for name, attribute, _ in declared(type(self), OptionSpec)}

    def structure(self) -> Hashable:
        """Return a hashable key of the equations of the part.

        Parts with equal keys have the same equations and differ only in the values of their numbers.
        """
        return self.kind, tuple(self.options().items()), tuple(sorted(self.ports().items())), self.body_name()

    def replaced_fields(self, fields: Iterable[str]) -> tuple[str, ...]:
        """Return the names of fields that contradict newly set fields and must be removed.

        `fields` are the names of the newly set fields.
        """
        return ()

    def states(self) -> tuple[State, ...]:
        """Return the declarations of the continuous states of the part."""
        return ()

    def inputs(self) -> tuple[Input, ...]:
        """Return the declarations of the inputs of the part, which signals or other parts can drive."""
        return ()

    def connections(self) -> dict[str, PartConnection]:
        """Return the connections that fields of the part specify, by name of the input.

        Each of these fields names an output of the circuit, which then drives the input. The circuit adds these
        connections to the connections of its table `connections`.
        """
        return {}

    @classmethod
    def stated_connections(cls, table: Mapping[str, Any]) -> dict[str, tuple[PartConnection, str]]:
        """Return the connections that the table of an invalid part declares, each with the unit of its input.

        Invalid fields are omitted. The outputs can thus be checked together with the other errors of a circuit file.
        """
        return {}

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        """Return the ranges of outputs that are limited, by name.

        A limit is a number in SI units or the name of a parameter, with a minus sign for its negative value. Outputs
        that are not in the result can have any value.
        """
        return {}

    def memory(self) -> tuple[DiscreteState, ...]:
        """Return the declarations of the discrete states of the part, without its timers."""
        return ()

    def timers(self) -> tuple[Timer, ...]:
        """Return the declarations of the timers that determine the sample instants of the part."""
        return ()

    def start(self, scope: Scope) -> dict[str, Any]:
        """Return the initial values of all states, discrete states and timers of the part by name."""
        # The scope has no states yet. Inputs have their initial values.
        return {}

    def update(self, timer: str, scope: Scope) -> dict[str, Any]:
        """Return the new discrete states and timers at a sample instant.

        `timer` is the name of the timer that is due. The result contains its next time. Discrete states that the result
        does not contain are unchanged.
        """
        raise NotImplementedError(f"{self.kind} has no timers")

    def can_resume(self, target: str) -> bool:
        """Return True if the parameter `target` is an initial value with the present options of the part.

        For example, a wall temperature is an initial value only if the part has it as a state.
        """
        return target != "wall_temperature" or any(state.name == target for state in self.states())

    def domains(self) -> dict[str, tuple[Any, tuple[float, float]]]:
        """Return a mapping from each state or input that is a stroke to its flow characteristic.

        Each value contains the characteristic and the positions of the two end stops [m]. A run has a note if the
        stroke leaves the domain of the characteristic.
        """
        return {}


class Store(Part):
    """Base class of gas nodes: parts that contain gas."""

    def stores(self) -> tuple[str, ...]:
        return ("",)

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        return super().output_ranges() | {"pressure": (0.0, float("inf")), "temperature": (1.0, float("inf"))}

    @abstractmethod
    def gas(self, scope: Scope) -> GasState:
        """Return pressure and temperature of the gas at the ports of the node."""

    @abstractmethod
    def balance(self, scope: Scope, flows: tuple[tuple[Any, Any], ...]) -> GasBalance:
        """Return the outputs of the gas node, and the time derivatives of its states.

        `flows` contains all its gas flows. Each flow is a pair of mass flow rate [kg/s] and enthalpy flow rate [W],
        positive into the node.
        """


class Passage(Part):
    """Base class of flow paths: parts through which gas flows between gas nodes."""

    regimes: ClassVar[tuple[str, ...]] = ("regime",)
    """Outputs with the code of a flow regime."""

    def output_ranges(self) -> dict[str, tuple[str | float, str | float]]:
        codes = float(min(REGIMES)), float(max(REGIMES))
        return super().output_ranges() | dict.fromkeys(self.regimes, codes)

    def integer_outputs(self) -> tuple[str, ...]:
        return (*super().integer_outputs(), *self.regimes)

    @abstractmethod
    def flows(self, scope: Scope, gas: Mapping[str, GasState]) -> PassageFlows:
        """Return the gas flows and outputs of the flow path, and the time derivatives of its states.

        `gas` maps each port name to the gas state at this port.
        """


class Actuator(Part):
    """Base class of parts that exert a force on a body."""

    @abstractmethod
    def actuator_force(self, scope: Scope, gas: Mapping[str, GasState]) -> ActuatorForce:
        """Return the force of the actuator on its body, its outputs, and the time derivatives of its states.

        `gas` maps each port name to the gas state at this port; `SELF` is the gas in the actuator.
        """


class Body(Part):
    """Base class of bodies, on which actuators act."""

    @abstractmethod
    def initial_travel(self) -> float:
        """Return the initial travel of the body if no signal drives it [m]."""

    @abstractmethod
    def motion(self, scope: Scope) -> BodyMotion:
        """Return travel and speed of the body at the point on which its actuators act."""

    @abstractmethod
    def dynamics(self, scope: Scope, force: Any, friction: Any) -> BodyDynamics:
        """Return the outputs of the body, and the time derivatives of its states.

        `force` is the sum of the forces of all actuators [N], and `friction` the sum of the dry friction of their seals
        [N].
        """


class Controller(Part):
    """Base class of controllers, which contain no gas and set inputs of other parts."""

    measured: ClassVar[tuple[str, ...]] = ()
    """Inputs that the controller needs; a run notes each of them that is not connected."""

    def ascending_parameters(self) -> tuple[tuple[str, str], ...]:
        """Return pairs of parameters of which the first must be below the second.

        Exported programs check them, because their parameters can change at run time.
        """
        return ()

    def commands(self) -> tuple[str, ...]:
        """Return the names of the outputs that have no effect unless another part reads them."""
        return ()

    def flags(self) -> tuple[str, ...]:
        """Return the names of the outputs and discrete states that are 0 or 1.

        Exported programs declare them as Booleans.
        """
        return ()

    def integer_outputs(self) -> tuple[str, ...]:
        return (*super().integer_outputs(), *self.flags())

    def sensors(self) -> dict[str, tuple[str, str]]:
        """Return the measured input and the parameter group of each sensor, by the name of its state.

        The sensors are not part of an exported controller.
        """
        return {}

    @abstractmethod
    def control(self, scope: Scope) -> ControlOutputs:
        """Return the outputs of the controller, and the time derivatives of its continuous states."""


def is_port(end: str) -> bool:
    """Return True if the end of a tube names a port of another part.

    An example is `valve.outlet`. An end that is not a port names a gas node.
    """
    return end.partition(".")[2] in PORTS


def advance_clock(scope: Scope, timer: str, period: Any, phase: Any = 0.0) -> dict[str, Any]:
    """Return the next sample instant of a periodic timer, and its incremented counter, by name.

    The instant [s] is computed from the counter, so rounding errors do not accumulate. A program with relative time
    adds the period to the time that remains, because a clock of single precision would become coarse.
    """
    count = scope.memory[f"{timer}_count"] + 1.0
    instant = scope.memory[timer] + period if scope.has_relative_time else phase + count * period
    return {timer: instant, f"{timer}_count": count}

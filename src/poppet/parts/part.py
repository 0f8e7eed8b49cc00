"""What a part is: stores hold gas, passages move it, controllers sample. All are frozen dataclasses that know their
equations.

A part never sees symbols of other parts. While a circuit is traced, a store turns its states into a gas state, a
passage turns the gas states at its ports into flows, and the store turns the sum of its flows into rates. What is
sampled or switched lives in a part's memory, which changes at instants only. The same methods run on floats.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Callable, Hashable, Mapping, Sequence
from dataclasses import fields
from typing import Any, ClassVar

from poppet.ground.codes import Note
from poppet.ground.errors import InputError
from poppet.ground.provenance import Number
from poppet.parts.fields import OptionSpec, PortSpec, complete, declared, flatten, forget
from poppet.parts.terms import (
    AMBIENT,
    NEVER,
    SELF,
    Balance,
    Control,
    Flow,
    Gas,
    Input,
    Memory,
    Passing,
    Quantities,
    Scope,
    State,
    Surroundings,
    Timer,
)

__all__ = [
    "AMBIENT",
    "NEVER",
    "SELF",
    "Balance",
    "Control",
    "Controller",
    "Flow",
    "Gas",
    "Input",
    "Memory",
    "Part",
    "Passage",
    "Passing",
    "Quantities",
    "Scope",
    "State",
    "Store",
    "Surroundings",
    "Timer",
    "field_names",
    "ticked",
]


class Part(ABC):
    """A named thing in a circuit."""

    kind: ClassVar[str]
    summary: ClassVar[str]
    resume: ClassVar[dict[str, str]] = {}
    """Outputs that say where a run may start again, with the number that each of them becomes."""

    def __post_init__(self) -> None:
        forget(self, self.library_sets())
        try:
            known = self.library_numbers()
        except InputError as error:
            raise error.located(address="data") from None
        complete(self, known)
        self.check()

    def library_sets(self) -> Sequence[Mapping[str, Number]]:
        """All sets of which a copy of the part may carry numbers; they give way to `library_numbers`."""
        return ()

    def library_numbers(self) -> Mapping[str, Number]:
        """Numbers of a library set, used for fields that were not given."""
        return {}

    def check(self) -> None:  # noqa: B027 - most parts have no rule beyond those of their fields
        """Raise `InputError` where fields contradict each other."""

    def notes(self) -> tuple[Note, ...]:
        """What a reader of any result has to know about the fields that were given, with addresses within the part."""
        return ()

    def remarks(self, name: str, series: Callable[[str], Any]) -> tuple[Note, ...]:
        """What a reader of a run has to know about its results.

        Parameters
        ----------
        name : str
            Of the part in its circuit.
        series : callable
            Address of an output, or `time`, to its (n_times,) array.

        Returns
        -------
        tuple of Note
            Their addresses are those within the part.
        """
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
                raise error.located(address=name) from None
            if value.reference == "gauge":
                spec.check(name, values[name], f"{value.display()} ({values[name]:g} Pa absolute)")
        return values

    def ports(self) -> dict[str, str]:
        """Port name to the name of the store it is joined to."""
        named = ((name, getattr(self, own)) for name, own, _ in declared(type(self), PortSpec))
        return {name: store for name, store in named if store is not None}

    def options(self) -> dict[str, str]:
        """Choices that shape the model."""
        return {name: getattr(self, own) for name, own, _ in declared(type(self), OptionSpec)}

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
        """Initial values of states, memory and timers.

        Parameters
        ----------
        scope : Scope
            Without states and memory; inputs have the values that they begin with: what they take without a signal,
            or the start of what is connected.

        Returns
        -------
        dict
            Name to value.
        """
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


class Controller(Part):
    """A part that moves no gas: it reads, remembers and gives signals."""

    measured: ClassVar[tuple[str, ...]] = ()
    """Inputs without which it controls nothing: a run in which they are left alone says so."""

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
    """A clock set to its next instant, counted from the start so that no rounding adds up."""
    count = scope.memory[f"{timer}_count"] + 1.0
    return {timer: phase + count * period, f"{timer}_count": count}

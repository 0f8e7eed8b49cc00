"""What of a circuit is what in an FMU: inputs, parameters, states, outputs, each with its value reference."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import ErrorCollector, NameSuggestion
from poppet.deploy.export_model import ExportModel

Flags = NDArray[np.bool_]

NUMBER, CONSTANT, PORT, DRIVEN = range(4)
"""Where an input takes its value: a number in p, its own default, the host, and the host or the circuit's signal."""
UNCHANGED, FIXED, TUNABLE, INPUT = range(4)
"""What a host may do with a number: nothing, set it before the run, during it, or drive it."""
FOLLOWS = "follow_signals"
TIME_REFERENCE, FOLLOWS_REFERENCE, FIRST_REFERENCE = range(3)


class Variable(NamedTuple):
    """A variable of the FMU; `start` is none where it is calculated."""

    name: str
    reference: int
    causality: str
    variability: str
    initial: str = ""
    start: float | bool | None = None
    unit: str = ""
    low: float = -np.inf
    high: float = np.inf
    meaning: str = ""
    state: int = -1  # reference of the state whose derivative it is


@dataclass(frozen=True, eq=False)
class FmuLayout:
    """Roles and references of all that is carried."""

    carried: ExportModel
    named: frozenset[str]  # inputs and numbers that the host drives, besides those with signals

    # Roles --------------------------------------------------------------------------------------------------------

    @cached_property
    def sources(self) -> tuple[int, ...]:
        """For each input where it takes its value."""
        found = []
        for item, told in zip(self.carried.inputs, self.carried.model.inputs, strict=True):
            if item.is_driven:
                found.append(DRIVEN)
            elif item.address in self.named or told.slope_of in self.named:
                found.append(PORT)
            else:
                found.append(NUMBER if item.number >= 0 else CONSTANT)
        return tuple(found)

    @cached_property
    def roles(self) -> tuple[int, ...]:
        """For each number what a host may do with it."""
        of_inputs = {i.number for i, source in zip(self.carried.inputs, self.sources, strict=True) if source == NUMBER}
        ports = {item.address for item, source in zip(self.carried.inputs, self.sources, strict=True) if source >= PORT}
        runs, starts = self.run_needs, self.start_needs
        found = []
        for k, number in enumerate(self.carried.numbers):
            if number.fixed or number.address in ports:
                found.append(UNCHANGED)
            elif number.address in self.named and k not in of_inputs:
                found.append(INPUT)
            elif runs[k] or k in of_inputs:
                found.append(TUNABLE)
            else:
                found.append(FIXED if starts[k] else UNCHANGED)
        return tuple(found)

    @cached_property
    def run_needs(self) -> Flags:
        """Which numbers rates, outputs and instants look at."""
        return np.asarray(np.vstack([self._by("p", name) for name in ("rates", "outputs", "update")]).any(axis=0))

    @cached_property
    def start_needs(self) -> Flags:
        """Which numbers the initial state looks at."""
        return np.asarray(np.vstack([self._by("p", name) for name in ("start", "memory_start")]).any(axis=0))

    # Dependencies -------------------------------------------------------------------------------------------------

    def _by(self, symbol: str, expression: str) -> Flags:
        """Which elements of an expression need which of a symbol, without what stands behind states and numbers."""
        return self._pattern(expression, symbol)[:, : self._width(symbol)]

    def _width(self, symbol: str) -> int:
        model = self.carried.model
        return {"x": len(model.states), "u": len(model.inputs), "p": len(model.parameters)}[symbol]

    def _pattern(self, expression: str, symbol: str) -> Flags:
        import casadi as ca

        model = self.carried.model
        value = ca.SX(model.expressions[expression])
        value = value[: len(model.states)] if expression in ("rates", "start") else value
        pattern = np.zeros((value.shape[0], model.symbols[symbol].shape[0]), dtype=bool)
        if value.shape[0]:
            rows, columns = ca.jacobian_sparsity(value, model.symbols[symbol]).get_triplet()
            pattern[rows, columns] = True
        return pattern

    @cached_property
    def needs(self) -> dict[str, tuple[Flags, Flags, Flags]]:
        """Which states, inputs and numbers rates and outputs need, those through the memory too."""
        n_p = self._width("p")
        memory = [self._by("x", "update"), self._by("u", "update"), self._by("p", "update")]
        through = self._pattern("update", "p")[:, n_p:]
        for _ in range(through.shape[0]):  # what an instant leaves, a later one takes up
            more = [each | (through.astype(int) @ each.astype(int) > 0) for each in memory]
            if all(np.array_equal(a, b) for a, b in zip(memory, more, strict=True)):
                break
            memory = more
        found = {}
        for name in ("rates", "outputs"):
            by_memory = self._pattern(name, "p")[:, n_p:].astype(int)
            found[name] = tuple(
                self._by(symbol, name) | (by_memory @ each.astype(int) > 0)
                for symbol, each in zip("xup", memory, strict=True)
            )
        return found

    def dependencies(self, name: str) -> list[list[int]]:
        """For each rate or output the references of states and driven values that it needs."""
        x, u, p = self.needs[name]
        u, p = self._handed(u, p)
        return [self._references(x[k], u[k], p[k], lambda role: role == INPUT) for k in range(len(x))]

    def initial_dependencies(self, name: str) -> list[list[int]]:
        """For each state, rate or output at the start the references of inputs and parameters that it needs."""
        n_p = self._width("p")
        start = self._by("p", "start")
        if name == "start":
            u, p = np.zeros((len(start), self._width("u")), dtype=bool), start
        else:
            x, u, p = self.needs[name]
            memory = self._pattern(name, "p")[:, n_p:].astype(int) @ self._by("p", "memory_start").astype(int) > 0
            p = p | (x.astype(int) @ start.astype(int) > 0) | memory
        for number, item in self.guided:
            u = u.copy()
            u[:, item] |= p[:, number]
        u, p = self._handed(u, p)
        none = np.zeros(0, dtype=bool)
        return [self._references(none, u[k], p[k], lambda role: role != UNCHANGED) for k in range(len(p))]

    def _handed(self, u: Flags, p: Flags) -> tuple[Flags, Flags]:
        """What needs an input that takes a number needs that number."""
        u, p = u.copy(), p.copy()
        for k, (item, source) in enumerate(zip(self.carried.inputs, self.sources, strict=True)):
            if source == NUMBER:
                p[:, item.number] |= u[:, k]
            if source < PORT:
                u[:, k] = False
        return u, p

    def _references(self, x: Flags, u: Flags, p: Flags, counts: Any) -> list[int]:
        states = {number: k for k, number in self.begun.items()}
        of_p = [
            self.state_reference(states[k]) if k in states else self.number_reference(k)
            for k in map(int, np.flatnonzero(p))
            if counts(self.roles[k])
        ]
        of_u = [self.input_reference(int(k)) for k in np.flatnonzero(u)]
        return [*of_p, *of_u, *(self.state_reference(int(k)) for k in np.flatnonzero(x))]

    @cached_property
    def guided(self) -> list[tuple[int, int]]:
        """Numbers that keep the first value of an input that guides a body, with that input."""
        names = [item.name for item in self.carried.model.inputs]
        bases = sorted({item.slope_of for item in self.carried.model.inputs if item.slope_of})
        found = [(self.carried.instance.place(base), names.index(base)) for base in bases if base in names]
        return [each for each in found if self.sources[each[1]] >= PORT]

    n_indicators = 0

    # References ---------------------------------------------------------------------------------------------------

    def number_reference(self, k: int) -> int:
        """Of a number in p."""
        return FIRST_REFERENCE + int(k)

    def input_reference(self, k: int) -> int:
        """Of an input in u."""
        return self.number_reference(len(self.carried.numbers)) + k

    def state_reference(self, k: int) -> int:
        """Of a state in x."""
        return self.input_reference(len(self.carried.inputs)) + k

    def rate_reference(self, k: int) -> int:
        """Of the derivative of a state."""
        return self.state_reference(len(self.carried.states)) + k

    def output_reference(self, k: int) -> int:
        """Of an output in y."""
        return self.rate_reference(len(self.carried.states)) + k

    # Variables ----------------------------------------------------------------------------------------------------

    @cached_property
    def same(self) -> dict[int, int]:
        """Outputs that are a state of the same address."""
        import casadi as ca

        model = self.carried.model
        places = {state.name: k for k, state in enumerate(model.states)}
        y, x = model.expressions["outputs"], model.symbols["x"]
        return {
            k: places[address]
            for k, (address, _) in enumerate(model.outputs)
            if address in places and ca.is_equal(y[k], x[places[address]])
        }

    @cached_property
    def begun(self) -> dict[int, int]:
        """States, each with the number of the same address that it begins with and that nothing else looks at."""
        places = {number.address: k for k, number in enumerate(self.carried.numbers)}
        found = {k: places.get(state.address, -1) for k, state in enumerate(self.carried.states)}
        return {k: number for k, number in found.items() if number >= 0 and self.roles[number] == FIXED}

    @cached_property
    def own_outputs(self) -> set[str]:
        """Addresses of states, and of outputs but those that show an input of the same address."""
        import casadi as ca

        model = self.carried.model
        places = {item.name: k for k, item in enumerate(model.inputs)}
        y, u = model.expressions["outputs"], model.symbols["u"]
        shown = {a for k, (a, _) in enumerate(model.outputs) if a not in places or not ca.is_equal(y[k], u[places[a]])}
        return shown | {state.name for state in model.states}

    @cached_property
    def variables(self) -> list[Variable]:
        """All variables, each address once."""
        found = [Variable("time", TIME_REFERENCE, "independent", "continuous", unit="s", meaning="time")]
        if DRIVEN in self.sources:
            text = "the inputs follow the signals of the circuit, and what is set is not looked at"
            found.append(Variable(FOLLOWS, FOLLOWS_REFERENCE, "parameter", "fixed", "exact", False, meaning=text))
        found += [self._port(k) for k, source in enumerate(self.sources) if source >= PORT]
        taken = {each.name for each in found}
        begin_states = set(self.begun.values())
        for k, number in enumerate(self.carried.numbers):
            is_idle = not (self.run_needs[k] or self.start_needs[k])
            is_shown_otherwise = number.address in self.own_outputs
            if structured(number.address) in taken or k in begin_states or (is_idle and is_shown_otherwise):
                continue
            each = self._number(k)
            found.append(each._replace(name=f"{each.name}.number") if is_shown_otherwise else each)
        taken = {each.name for each in found}
        for k in range(len(self.carried.states)):
            found += self._state(k, taken)
        for k, quantity in enumerate(self.carried.outputs):
            if k not in self.same and structured(quantity.address) not in taken:
                found.append(self._output(k))
        return found

    def _port(self, k: int) -> Variable:
        item, told = self.carried.inputs[k], self.carried.model.inputs[k]
        start = 0.0 if told.slope_of else item.value
        meaning = f"time derivative of {told.slope_of}" if told.slope_of else ""
        if told.delay and self.carried.instance.parameters[told.delay]:
            meaning = f"acts at once: {told.delay} delays the signal of the circuit only"
        return Variable(
            structured(item.address), self.input_reference(k), "input", "continuous", "", start, item.unit,
            item.low, item.high, meaning,
        )  # fmt: skip

    def _number(self, k: int) -> Variable:
        number = self.carried.numbers[k]
        causality, variability, initial = {
            UNCHANGED: ("local", "constant", "exact"),
            FIXED: ("parameter", "fixed", "exact"),
            TUNABLE: ("parameter", "tunable", "exact"),
            INPUT: ("input", "continuous", ""),
        }[self.roles[k]]
        return Variable(
            structured(number.address), self.number_reference(k), causality, variability, initial, number.value,
            number.unit, number.low, number.high, number.meaning,
        )  # fmt: skip

    def _state(self, k: int, taken: set[str]) -> list[Variable]:
        state = self.carried.states[k]
        name = structured(state.address)
        name = f"{name}.state" if name in taken or self._differs(k) else name
        unit = "1/s" if state.unit == "1" else f"{state.unit}/s"
        unit = {"m/s/s": "m/s^2", "rad/s/s": "rad/s^2"}.get(unit, unit)
        reference = self.state_reference(k)
        number = self.carried.numbers[self.begun[k]] if k in self.begun else None
        initial, start = ("exact", number.value) if number else ("calculated", None)
        return [
            Variable(name, reference, self._shown(state.address), "continuous", initial, start, state.unit),
            Variable(
                f"der({name})", self.rate_reference(k), "local", "continuous", "calculated", None, unit, state=reference
            ),
        ]

    def _differs(self, k: int) -> bool:
        """True of a state whose address an output of another value has."""
        address = self.carried.states[k].address
        return k not in self.same.values() and any(each.address == address for each in self.carried.outputs)

    def _output(self, k: int) -> Variable:
        quantity = self.carried.outputs[k]
        return Variable(
            structured(quantity.address), self.output_reference(k), self._shown(quantity.address), "continuous",
            "calculated", None, quantity.unit,
        )  # fmt: skip

    def _shown(self, address: str) -> str:
        return "local" if address in self.carried.instance.inner else "output"


_IDENTIFIER = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")


def structured(address: str) -> str:
    """An address after the naming convention `structured`, in which other names are quoted.

    Examples
    --------
    >>> structured("tank.volume"), structured("tank-1.volume")
    ('tank.volume', "'tank-1'.volume")
    """
    return ".".join(each if _IDENTIFIER.fullmatch(each) else f"'{each}'" for each in address.split("."))


def plan_of(carried: ExportModel, inputs: Sequence[str] = ()) -> FmuLayout:
    """Roles in an FMU.

    Parameters
    ----------
    carried : Carried
    inputs : sequence of str
        Addresses of inputs and numbers that the host is to drive, besides the inputs that have signals.

    Returns
    -------
    Plan

    Raises
    ------
    InputErrors
        For an address that is unknown, or of a number that may not change during a run.
    """
    known = {item.address: "" for item in carried.inputs}
    known = {number.address: number.fixed for number in carried.numbers} | known
    with ErrorCollector() as errors:
        for address in inputs:
            if address not in known:
                near = NameSuggestion(address, known)
                errors.add("names.unknown", address, meaning="an input or parameter of this circuit", near=near)
            elif known[address]:
                errors.add("deploy.fmu.fixed_input", address, why=known[address])
    return FmuLayout(carried, frozenset(inputs))

"""Compiled model with parameter values and signals, for solvers and analyses."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any, Protocol, Self

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.options import Run
from poppet.circuit.stop_conditions import domain_conditions, parse_stop_condition
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.provenance import Number
from poppet.core.units import quantity
from poppet.engine.kernel import Kernel
from poppet.engine.lru_cache import LruCache
from poppet.engine.model import InputInfo, Model
from poppet.engine.problem import Problem
from poppet.parts.part import Surroundings
from poppet.timeseries.recording import Recording
from poppet.timeseries.segments import MergedSegments, SegmentTable, Signal, held, merge

Array = NDArray[np.float64]
Series = Callable[[str], Array]
"""Function from the address of an output, or `time`, to its values at the output times of a run."""
LENGTHS = 4
"""Number of run durations for which the segments of signals are cached."""
TIES = 8
"""Number of sets of parameters for which the result of `Instance.tied` is cached."""


class Drive:
    """Signals of all inputs of a circuit, divided into segments for the integrator.

    The segments are stored for each duration. Circuits with equal signals share one object.
    """

    def __init__(self, signals: Mapping[str, Signal]) -> None:
        self.signals = signals
        self._cache: LruCache[MergedSegments] = LruCache(LENGTHS)

    def segments(self, inputs: tuple[InputInfo, ...], delays: tuple[float, ...], duration: float) -> MergedSegments:
        """Return the segments of all input signals for a run of given duration [s].

        `inputs` are the declarations of the inputs, and `delays` are their delays [s]. An input without a signal is
        zero. The arrays are read-only.
        """

        def table(item: InputInfo, delay: float) -> SegmentTable:
            signal = self.signals.get(item.slope_of or item.name)
            if signal is None:
                return held(0.0)
            if item.slope_of:  # rate of change of another input
                return signal.table(duration).derivative(f"signals.{item.slope_of}")
            return (signal.delayed(delay) if delay > 0.0 else signal).table(duration)

        def make_segments() -> MergedSegments:
            return merge([table(item, delay) for item, delay in zip(inputs, delays, strict=True)] or [held(0.0)])

        # The key contains the delays because they move breakpoints; other parameters do not change the segments.
        return self._cache.get((tuple(item.name for item in inputs), delays, duration), make_segments)


class CircuitVariants(Protocol):
    """Interface of a circuit for its `Instance`, which requests modified copies and notes."""

    @property
    def instance(self) -> Instance:
        """Compiled model with the parameter values and signals of this circuit."""

    def drives(self) -> Mapping[str, Mapping[str, bool]]:
        """Return the inputs that can move each body; see `BaseCircuit.drives`."""

    def with_values(self, values: Mapping[str, Any]) -> Self:
        """Return a copy of the circuit with other values at the given addresses."""

    def with_signals(self, signals: Mapping[str, Signal]) -> Self:
        """Return a copy of the circuit with other signals.

        The signals in `signals` replace all present signals.
        """

    def resumed(self, recording: Recording) -> Self:
        """Return a copy of the circuit that starts in the final state of a recording."""

    def result_notes(self, series: Series) -> Iterable[Note]:
        """Yield notes on the gas and the parts in a run.

        The function `series` returns the values of an output over time for its address.
        """


@dataclass(frozen=True, eq=False)
class Instance:
    """Compiled model with parameter values, signals and ambient conditions.

    Unlike a circuit, an instance contains no parts. For changes that affect the parts, its field `circuit` returns
    changed circuits.
    """

    kernel: Kernel
    parameters: Mapping[str, float]  # address to run-time value, SI and absolute, in the order of p
    drive: Drive
    surroundings: Surroundings
    circuit: CircuitVariants
    title: str = ""
    notes: tuple[Note, ...] = ()  # notes on the values of parameters and signals
    # address of a stroke to its characteristic with a limited domain, and to its end stops
    domains: Mapping[str, tuple[Any, tuple[float, float]]] = field(default_factory=dict)
    initial: Mapping[str, str] = field(default_factory=dict)  # address of an output to the parameter of its start value
    inner: frozenset[str] = frozenset()  # internal outputs, which figures omit by default
    sources: Mapping[str, Number] = field(default_factory=dict)  # address to value with unit and source, of the parts
    bodies: Mapping[str, str] = field(default_factory=dict)  # actuator to the body that it moves
    changes: Mapping[str, float] = field(default_factory=dict)  # parameters that differ from `circuit`
    _ties: LruCache[frozenset[str]] = field(default_factory=lambda: LruCache(TIES), init=False, repr=False)

    @property
    def model(self) -> Model:
        """Symbolic model: states, inputs, parameters, outputs."""
        return self.kernel.model

    @property
    def signals(self) -> Mapping[str, Signal]:
        """Mapping from input addresses to signals."""
        return self.drive.signals

    @property
    def input_names(self) -> tuple[str, ...]:
        """Addresses of the inputs, in the order of the input vector u."""
        return tuple(item.name for item in self.model.inputs)

    def numbers(self) -> Array:
        """Return the parameter values, the first elements of the parameter vector p."""
        return np.array(list(self.parameters.values()), dtype=np.float64)

    def place(self, address: str) -> int:
        """Return the index of the parameter with a given address in the parameter vector p."""
        return self.model.parameters.index(address)

    def start(self) -> tuple[Array, Array]:
        """Return the initial state vector x and the vector p of a run.

        x ends with the quadratures (integrals of flows for balances). p contains the parameters, followed by the
        initial discrete states.
        """
        numbers = self.numbers()
        # The gas in a guided cylinder starts with the volume at t = 0. The parameter gets the value of the signal: the
        # input is driven, so nothing else reads the parameter, and repeated runs of a fit start from p alone.
        for address in {item.slope_of for item in self.model.inputs if item.slope_of in self.signals}:
            numbers[self.place(address)] = float(self.signals[address].table(1.0).evaluate(0.0))
        p = self.kernel.with_memory(numbers)
        return self.kernel.start(p), p

    # Variants ----------------------------------------------------------------------------------------------------

    def with_values(self, values: Mapping[str, Any]) -> Instance:
        """Return an instance with other values or options at the given addresses.

        The parts read and check the values.
        """
        return self.circuit.with_values({**self.changes, **values}).instance

    def with_signals(self, signals: Mapping[str, Signal]) -> Instance:
        """Return a copy of the instance with other signals.

        The signals in `signals` replace all present signals.
        """
        return self._changed_circuit().with_signals(signals).instance

    def with_numbers(self, numbers: Mapping[str, float]) -> Instance:
        """Return a copy of the instance with other parameter values, which are not checked.

        `numbers` maps addresses to values in SI units, absolute. Other parameters keep their values. If some of them
        depend on the changed parameters (see `tied`), use `with_values` instead.
        """
        return replace(self, parameters={**self.parameters, **numbers}, changes={**self.changes, **numbers})

    def resumed(self, recording: Recording) -> Instance:
        """Return an instance that starts in the final state of a recording."""
        return self._changed_circuit().resumed(recording).instance

    def _changed_circuit(self) -> CircuitVariants:
        return self.circuit.with_values(self.changes) if self.changes else self.circuit

    def tied(self, changes: Mapping[str, float]) -> frozenset[str]:
        """Return the addresses of parameters on which other parameters depend.

        `changes` contains the addresses to test. Its values must differ from the present values of the parameters.
        """

        def has_dependents(values: dict[str, float]) -> bool:
            return bool(self.with_values(values).parameters != {**self.parameters, **values})

        def find_tied() -> frozenset[str]:
            # Usually no parameter is tied: one check of all is enough.
            candidates = changes.items() if has_dependents(dict(changes)) else ()
            return frozenset(address for address, value in candidates if has_dependents({address: value}))

        # All recordings of a fit have the same candidates.
        return self._ties.get(tuple(changes.items()), find_tied)

    # Inputs ------------------------------------------------------------------------------------------------------

    def held_inputs(self, values: Mapping[str, Any]) -> Array:
        """Return the constant input vector for a steady state or a linear model.

        `values` maps addresses of inputs to values in SI units, or to texts with a unit. Any other input has the value
        of its signal at t = 0. Without a signal it has its value at rest, such as 1 for the halt of a sequence, or else
        its default.
        """
        inputs = {item.name: item for item in self.model.inputs}
        u: list[float] = []
        with ErrorCollector() as errors:
            for name in values:
                if name not in inputs:
                    suggestion = NameSuggestion(name, inputs)
                    errors.add("names.unknown", name, meaning="an input of this circuit", suggestion=suggestion)
            for name, item in inputs.items():
                signal = self.signals.get(name)
                if name in values:
                    with errors.collecting():
                        u.append(self._read(item, values[name]))
                elif signal is not None:
                    delay = self.parameters[item.delay] if item.delay else 0.0
                    u.append(float(signal.delayed(delay).table(1.0).evaluate(0.0)))
                else:
                    u.append(self._number(item.default) if item.at_rest is None else item.at_rest)
        return np.array(u, dtype=float)

    def _read(self, item: InputInfo, argument: Any) -> float:
        read = quantity(argument, item.unit, kind=item.kind, name=item.name)  # type: ignore[arg-type]
        value = read.value + (self.surroundings.pressure if read.reference == "gauge" else 0.0)
        low, high = self._number(item.low), self._number(item.high)
        if not low <= value <= high:
            raise InputError("inputs.outside", item.name, given=argument, low=low, high=high, unit=item.unit)
        return value

    def _number(self, value: str | float) -> float:
        return self.parameters[value] if isinstance(value, str) else value

    # Runs --------------------------------------------------------------------------------------------------------

    def problem(self, run: Run) -> Problem:
        """Return the data of one run as arrays; `run` must have a duration."""
        grid, inputs = run.grid(), self.model.inputs
        delays = tuple(self.parameters[item.delay] if item.delay else 0.0 for item in inputs)
        starts, courses, coefficients, jumps = self.drive.segments(inputs, delays, float(grid[-1]))
        # A copy: other runs share the segments, and values of inputs without a signal are written below.
        coefficients = coefficients.copy()
        for k, item in enumerate(inputs):
            if item.name not in self.signals and not item.slope_of:
                coefficients[:, k, 0] = self._number(item.default)
        outputs = dict(self.model.outputs)
        conditions = [parse_stop_condition(text, outputs, self.surroundings.pressure) for text in run.stop_texts]
        for address, (curve, stops) in self.domains.items():
            # After the conditions of the user, which have priority if two become true in the same step.
            if curve.edge == "error":
                conditions += domain_conditions(address, curve.limits(stops), outputs)
        x, p = self.start()
        return Problem(
            self.kernel, p, x, starts, courses, coefficients, jumps, grid,
            run.tolerance, tuple(conditions), run.longest_step,
        )  # fmt: skip

"""An instance of a model: what solvers and analyses need of a circuit, without the parts it was made of."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field, replace
from typing import Any

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
from poppet.engine.problem import Problem, StopCondition
from poppet.parts.part import Surroundings
from poppet.timeseries.recording import Recording
from poppet.timeseries.segments import MergedSegments, SegmentTable, Signal, held, merge

Array = NDArray[np.float64]
Series = Callable[[str], Array]
"""Address of an output, or `time`, to its values at the rows of a run."""
LENGTHS = 4
"""Lengths of runs for which the segments of signals are kept."""
TIES = 8
"""Sets of numbers for which it is kept what follows from them."""


class Drive:
    """The signals of a circuit; their segments are made once for every length of run and shared by its variations."""

    def __init__(self, signals: Mapping[str, Signal]) -> None:
        self.signals = signals
        self._kept: LruCache[MergedSegments] = LruCache(LENGTHS)

    def segments(self, inputs: tuple[InputInfo, ...], delays: tuple[float, ...], duration: float) -> MergedSegments:
        """Segments of every input over a run, not to be written to; inputs without a signal are held at zero."""

        def table(item: InputInfo, delay: float) -> SegmentTable:
            if item.slope_of:
                return self._moving(item.slope_of, duration)
            signal = self.signals.get(item.name)
            if signal is None:
                return held(0.0)
            return (signal.delayed(delay) if delay > 0.0 else signal).table(duration)

        def make() -> MergedSegments:
            return merge([table(*each) for each in zip(inputs, delays, strict=True)] or [held(0.0)])

        # Delays are in the key because they move breakpoints; other numbers leave the segments alone.
        return self._kept.get((tuple(item.name for item in inputs), delays, duration), make)

    def _moving(self, address: str, duration: float) -> SegmentTable:
        """How fast an input changes."""
        signal = self.signals.get(address)
        if signal is None:
            return held(0.0)
        return signal.table(duration).derivative(f"signals.{address}")


@dataclass(frozen=True, eq=False)
class Instance:
    """A compiled model with numbers, signals and surroundings of its own."""

    kernel: Kernel
    parameters: Mapping[str, float]  # address of every number to its run-time value, SI and absolute, in the order of p
    drive: Drive
    surroundings: Surroundings
    remarks: Callable[[Series], Iterable[Note]]  # from the series of a run to what the parts have to say about it
    # other values and other signals, as keywords, to an instance that was made and checked anew
    vary: Callable[..., Instance]
    resume: Callable[[Recording], Instance]  # a recording to the instance that starts where it ends
    title: str = ""  # shown with every result
    notes: tuple[Note, ...] = ()  # what a reader of any result has to know about the numbers
    # address of each stroke to the characteristic that holds over a range of it, and its end stops
    domains: Mapping[str, tuple[Any, tuple[float, float]]] = field(default_factory=dict)
    initial: Mapping[str, str] = field(default_factory=dict)  # address of an output to the number that it begins at
    # series that a picture leaves out: what parts do inside, and inputs that take what another part shows
    inner: frozenset[str] = frozenset()
    # every number of the parts by its address, as it was given: with its source
    sources: Mapping[str, Number] = field(default_factory=dict)
    holders: Mapping[str, str] = field(default_factory=dict)  # actuator to the body that it moves
    _ties: LruCache[frozenset[str]] = field(default_factory=lambda: LruCache(TIES), init=False, repr=False)

    @property
    def model(self) -> Model:
        """The traced model: states, inputs, parameters, outputs."""
        return self.kernel.model

    @property
    def signals(self) -> Mapping[str, Signal]:
        """Address of an input to its signal."""
        return self.drive.signals

    @property
    def input_names(self) -> tuple[str, ...]:
        """Addresses in the order of u."""
        return tuple(item.name for item in self.model.inputs)

    def numbers(self) -> Array:
        """Run-time numbers, the first part of p."""
        return np.array(list(self.parameters.values()), dtype=np.float64)

    def place(self, address: str) -> int:
        """Index of a number in p."""
        return self.model.parameters.index(address)

    def start(self) -> tuple[Array, Array]:
        """Initial state with its quadratures, and p: numbers, behind them the memory at the start."""
        # The compiled start reads the numbers only, and writes the memory behind them.
        numbers = self.numbers()
        # Gas in a guided cylinder begins in the volume of the first moment. The number keeps that value: its input is
        # driven, so that nothing else reads it, and repeated runs of a fit start from p alone.
        for address in {item.slope_of for item in self.model.inputs if item.slope_of in self.signals}:
            numbers[self.place(address)] = float(self.signals[address].table(1.0).evaluate(0.0))
        p = self.kernel.with_memory(numbers)
        return self.kernel.start(p), p

    # Variations --------------------------------------------------------------------------------------------------

    def with_values(self, values: Mapping[str, Any]) -> Instance:
        """The same with other numbers or options, read and checked by the parts."""
        return self.vary(values=values)

    def with_signals(self, signals: Mapping[str, Signal]) -> Instance:
        """The same driven by other signals instead of its own."""
        return self.vary(signals=signals)

    def with_numbers(self, numbers: Mapping[str, float]) -> Instance:
        """The same with other values in p, SI and absolute, that nobody checks: limits, notes, what follows from them.

        Numbers from which others follow are `tied`, and want `with_values`.
        """

        # What is varied later starts from these numbers; a value that is given then prevails.
        def vary(values: Mapping[str, Any] | None = None, signals: Mapping[str, Signal] | None = None) -> Instance:
            return self.vary(values={**numbers, **(values or {})}, signals=signals)

        return replace(self, parameters={**self.parameters, **numbers}, vary=vary)

    def tied(self, moved: Mapping[str, float]) -> frozenset[str]:
        """Which numbers others follow from; `moved` has another value for each that is asked about."""
        # Every recording of a fit asks the same.
        return self._ties.get(tuple(moved.items()), lambda: self._tied(moved))

    def _tied(self, moved: Mapping[str, float]) -> frozenset[str]:

        def others_follow(values: dict[str, float]) -> bool:
            return bool(self.with_values(values).parameters != {**self.parameters, **values})

        # One look at all of them is the rule, and enough.
        if not others_follow(dict(moved)):
            return frozenset()
        return frozenset(address for address, value in moved.items() if others_follow({address: value}))

    # Inputs ------------------------------------------------------------------------------------------------------

    def held_inputs(self, given: Mapping[str, Any]) -> Array:
        """Every input as given (SI, or text with a unit), else as its signal is at t = 0, else its number."""
        known = {item.name: item for item in self.model.inputs}
        values: list[float] = []
        with ErrorCollector() as errors:
            for name in given:
                if name not in known:
                    errors.add("inputs.unknown", name, near=NameSuggestion(name, known))
            for name, item in known.items():
                signal = self.signals.get(name)
                if name in given:
                    with errors.collecting():
                        values.append(self._read(item, given[name]))
                else:
                    values.append(self._default(item) if signal is None else float(signal.table(1.0).evaluate(0.0)))
        return np.array(values, dtype=float)

    def _read(self, item: InputInfo, given: Any) -> float:
        read = quantity(given, item.unit, kind=item.kind, name=item.name)  # type: ignore[arg-type]
        value = read.value + (self.surroundings.pressure if read.reference == "gauge" else 0.0)
        low, high = self._number(item.low), self._number(item.high)
        if not low <= value <= high:
            raise InputError("inputs.outside", item.name, given=given, low=low, high=high, unit=item.unit)
        return value

    def _default(self, item: InputInfo) -> float:
        return self._number(item.default)

    def _number(self, given: str | float) -> float:
        return self.parameters[given] if isinstance(given, str) else given

    # Runs --------------------------------------------------------------------------------------------------------

    def problem(self, run: Run) -> Problem:
        """The plain arrays of one run, which has a duration."""
        grid, inputs = run.grid(), self.model.inputs
        delays = tuple(self.parameters[item.delay] if item.delay else 0.0 for item in inputs)
        starts, courses, coefficients, jumps = self.drive.segments(inputs, delays, float(grid[-1]))
        # Shared with other runs, and the inputs without a signal are about to be written into them.
        coefficients = coefficients.copy()
        for k, item in enumerate(inputs):
            if item.name not in self.signals and not item.slope_of:
                coefficients[:, k, 0] = self._default(item)
        x, p = self.start()
        return Problem(
            self.kernel, p, x, starts, courses, coefficients, jumps, grid,
            run.tolerance, self._stop_conditions(run), run.longest_step,
        )  # fmt: skip

    def _stop_conditions(self, run: Run) -> tuple[StopCondition, ...]:
        outputs = dict(self.model.outputs)
        conditions = [parse_stop_condition(text, outputs, self.surroundings.pressure) for text in run.stop_texts]
        for address, (curve, stops) in self.domains.items():
            # Behind those that were asked for: where two hold at once, the run ends as its user wanted.
            if curve.edge == "error":
                conditions += domain_conditions(address, curve.limits(stops), outputs)
        return tuple(conditions)

"""What every target carries of a circuit: numbers, inputs with their courses, states, memory, outputs, tolerances."""

from __future__ import annotations

import sys
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from poppet.core.errors import InputError
from poppet.deploy.export_files import identifier, identifiers
from poppet.engine.printers.instructions import traced_functions
from poppet.identify.free_parameter import number_specs
from poppet.parts.fields import NumberSpec, flatten

if TYPE_CHECKING:
    from typing import Any

    from poppet.circuit.circuit import Circuit
    from poppet.circuit.instance import Instance
    from poppet.engine.model import Model
    from poppet.engine.problem import Problem

MOST_SEGMENTS = 100_000
"""Segments of the signals of a run; a target carries them as constants."""


class ExportParameter(NamedTuple):
    """A number of p, SI and absolute."""

    address: str
    identifier: str
    unit: str
    value: float
    low: float
    high: float
    meaning: str
    shown: str  # as it was written, `6 bar g`
    # Why it may not be changed at run time: `tied`, others follow from it; `delay`, it moves the breakpoints of a
    # signal; `derived`, it follows from others itself; `driven`, a signal decides it. Empty where it may.
    fixed: str

    @property
    def is_free(self) -> bool:
        """True where it may be changed at run time."""
        return not self.fixed


class ExportInput(NamedTuple):
    """An input of u, SI and absolute."""

    address: str
    identifier: str
    unit: str
    value: float  # at the start
    low: float
    high: float
    number: int  # place in p of the number that it takes without a signal, -1 for none
    is_driven: bool  # by a signal of the circuit
    slope_of: int  # place in u of the input whose slope it is, -1 for none


class Quantity(NamedTuple):
    """A state, an element of the memory or an output."""

    address: str
    identifier: str
    unit: str
    value: float  # at the start; of an output NaN


@dataclass(frozen=True, eq=False)
class ExportModel:
    """A circuit as its targets take it: names, units, places, start values; courses and tolerances in the problem."""

    name: str  # an identifier
    title: str
    instance: Instance
    problem: Problem
    numbers: tuple[ExportParameter, ...]  # in the order of p
    inputs: tuple[ExportInput, ...]  # in the order of u
    states: tuple[Quantity, ...]  # controlled ones, in the order of x
    memory: tuple[Quantity, ...]  # behind the numbers in p; the first `model.n_timers` are timers
    outputs: tuple[Quantity, ...]  # in the order of y

    @property
    def model(self) -> Model:
        """The traced model."""
        return self.instance.model

    @cached_property
    def functions(self) -> dict[str, Any]:
        """The traced functions, to be read by a printer."""
        return traced_functions(self.model)


def build_export_model(circuit: Circuit, name: str = "") -> ExportModel:
    """What targets carry of a circuit.

    Parameters
    ----------
    circuit : Circuit
        With a duration, over which its signals are carried.
    name : str, optional
        Of the model; default its title. An identifier is made of it.

    Returns
    -------
    Carried

    Raises
    ------
    InputErrors
        If it has no duration, or signals of more than 100,000 segments.
    """
    # What costs nothing is refused before anything is compiled.
    circuit.run.grid()
    instance = circuit.instance
    problem, model = instance.problem(circuit.run), instance.model
    if problem.starts.size > MOST_SEGMENTS:
        raise InputError("deploy.segments", "signals", count=int(problem.starts.size), most=MOST_SEGMENTS)
    n, numbers = len(model.parameters), _numbers(circuit, instance, problem)
    states = zip(model.states, problem.x0[: len(model.states)], strict=True)
    memory = zip(model.memory, problem.p[n:], strict=True)
    return ExportModel(
        identifier(name or circuit.title or "model"), circuit.title, instance, problem, numbers,
        _inputs(instance, problem),
        _quantities((s.name, s.unit, x) for s, x in states),
        _quantities((*of, z) for of, z in memory),
        _quantities((*of, np.nan) for of in model.outputs),
    )  # fmt: skip


def _quantities(rows: Iterable[tuple[str, str, float]]) -> tuple[Quantity, ...]:
    found = list(rows)
    own = identifiers([address for address, _, _ in found])
    return tuple(Quantity(a, own[k], unit, float(value)) for k, (a, unit, value) in enumerate(found))


def _numbers(circuit: Circuit, instance: Instance, problem: Problem) -> tuple[ExportParameter, ...]:
    specs, written = number_specs(circuit), circuit.numbers()
    for section in ("ambient", "gas"):
        specs |= {f"{section}.{key}": spec for key, spec, _ in flatten(getattr(circuit, section))}
    delays = {item.delay for item in instance.model.inputs if item.delay}
    guided = {item.slope_of for item in instance.model.inputs if item.slope_of in instance.signals}
    own, found = identifiers(instance.model.parameters), []
    for k, address in enumerate(instance.model.parameters):
        value, number = float(problem.p[k]), written.get(address)
        spec = specs.get(address) or NumberSpec("1", address)
        if number is None:
            fixed = "derived"
        elif address in delays:
            fixed = "delay"
        elif address in guided:
            fixed = "driven"
        else:
            fixed = "tied" if _is_tied(circuit, address, value, spec) else ""
        low, high = max(spec.ends[0], _beside(spec.above, 1.0)), min(spec.ends[1], _beside(spec.below, -1.0))
        unit, shown = (number.unit, number.display()) if number else (spec.unit, "")
        found.append(ExportParameter(address, own[k], unit, value, low, high, spec.meaning, shown, fixed))
    return tuple(found)


def _beside(end: float, way: float) -> float:
    """The number next to an end that is none itself; next to zero one that no processor takes for zero."""
    return end + way * max(abs(end) * sys.float_info.epsilon, sys.float_info.min) if np.isfinite(end) else end


def _is_tied(circuit: Circuit, address: str, value: float, spec: NumberSpec) -> bool:
    """Whether something else follows from a number: other numbers, or the structure."""
    # Not `Instance.tied`, which makes the instance of every variation: a target asks about all numbers one by one.
    tried = [value * (1.0 + sign * 1e-6) if value else sign * 1e-6 for sign in (1.0, -1.0)]
    probe = next((v for v in tried if spec.holds(v)), None)
    if probe is None:
        return True
    try:
        moved = circuit.with_values({address: probe})
    except InputError:  # alone it cannot move
        return True
    same = {**circuit.parameters, address: moved.parameters[address]}
    return moved.parameters != same or moved.parameters[address] != probe or moved.structure != circuit.structure


def _inputs(instance: Instance, problem: Problem) -> tuple[ExportInput, ...]:
    names, found = instance.input_names, []
    own = identifiers(names)
    first = problem.coefficients[problem.courses[0]]
    u = first[:, 0] + first[:, 2] * np.sin(first[:, 5])
    for k, item in enumerate(instance.model.inputs):
        low, high = (instance.parameters[e] if isinstance(e, str) else e for e in (item.low, item.high))
        is_driven = (item.slope_of or item.name) in instance.signals
        place = instance.place(item.default) if isinstance(item.default, str) and not item.slope_of else -1
        slope_of = names.index(item.slope_of) if item.slope_of else -1
        found.append(ExportInput(item.name, own[k], item.unit, float(u[k]), low, high, place, is_driven, slope_of))
    return tuple(found)


def without_signals(of: ExportModel) -> ExportModel:
    """The same with inputs that are held where they begin, for targets whose host drives them."""
    from poppet.engine.problem import constant_coefficients

    u = np.array([item.value for item in of.inputs])
    start, course, jump = np.zeros(1), np.zeros(1, dtype=np.int64), np.zeros(1, dtype=np.bool_)
    problem = replace(of.problem, starts=start, courses=course, coefficients=constant_coefficients(u), jumps=jump)
    return replace(of, problem=problem)

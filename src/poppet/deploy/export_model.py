"""Model of a circuit in the form that all export targets use.

It contains parameters, inputs with signals, states, outputs and tolerances.
"""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import TYPE_CHECKING, NamedTuple

import numpy as np

from poppet.circuit.addresses import change_values
from poppet.circuit.number_specs import number_specs
from poppet.circuit.wiring import check_starts
from poppet.core.errors import ErrorCollector, InputError
from poppet.deploy.export_files import identifier, identifiers
from poppet.engine.printers.instructions import trace_functions
from poppet.parts.compound import Compound
from poppet.parts.fields import NumberSpec, flatten
from poppet.parts.part import Part, Surroundings

if TYPE_CHECKING:
    import casadi

    from poppet.circuit.circuit import BaseCircuit
    from poppet.circuit.instance import Instance
    from poppet.engine.model import Model
    from poppet.engine.problem import Problem

MAX_SEGMENTS = 100_000
"""Maximum number of segments of all signals; a target stores them as constants."""


class ExportParameter(NamedTuple):
    """Parameter of the exported model: one element of the vector p.

    Values are in SI units, and pressures and temperatures are absolute.
    """

    address: str
    identifier: str
    unit: str
    value: float
    low: float
    high: float
    above: float | None  # the value must be greater than this limit; None if `low` is permitted
    below: float | None  # the value must be less than this limit; None if `high` is permitted
    meaning: str
    # Reason for which the value must not change at run time: `tied` (other parameters depend on it), `delay` (it moves
    # the breakpoints of a signal), `derived` (it depends on other parameters), `driven` (a signal sets it), or empty.
    fixed: str

    @property
    def is_free(self) -> bool:
        """True if the exported program can change the value at run time."""
        return not self.fixed


class ExportInput(NamedTuple):
    """Input of the exported model: one element of the vector u.

    Values are in SI units, and pressures and temperatures are absolute.
    """

    address: str
    identifier: str
    unit: str
    value: float  # at the start
    low: float
    high: float
    parameter: int  # index in p of the value without a signal; -1 if there is none
    is_driven: bool  # by a signal of the circuit
    slope_of: int  # index in u of the input whose slope it is; -1 if there is none


class ExportQuantity(NamedTuple):
    """State, discrete state or output of the exported model, with name and unit."""

    address: str
    identifier: str
    unit: str
    value: float  # at the start; NaN for an output


@dataclass(frozen=True, eq=False)
class ExportModel:
    """Circuit in the form that all export targets use.

    It contains names, units, indices and start values of all quantities. The field `problem` contains the signals and
    tolerances of the run.
    """

    name: str  # an identifier
    title: str
    instance: Instance
    problem: Problem
    parameters: tuple[ExportParameter, ...]  # in the order of p
    inputs: tuple[ExportInput, ...]  # in the order of u
    states: tuple[ExportQuantity, ...]  # with error control, in the order of x
    memory: tuple[ExportQuantity, ...]  # discrete states, after the parameters in p; first `model.n_timers` timers
    outputs: tuple[ExportQuantity, ...]  # in the order of y

    @property
    def model(self) -> Model:
        """Symbolic (CasADi) model of the circuit."""
        return self.instance.model

    @cached_property
    def functions(self) -> dict[str, casadi.Function]:
        """CasADi functions of the model by name, from which the targets print code."""
        return trace_functions(self.model)


def build_export_model(circuit: BaseCircuit, name: str = "") -> ExportModel:
    """Return the model of a circuit for the export targets.

    Parameters
    ----------
    circuit : Circuit
        Circuit with a duration, over which the signals are exported.
    name : str, optional
        Name of the model, which becomes an identifier (default: title of the circuit).

    Returns
    -------
    ExportModel

    Raises
    ------
    InputErrors
        If the circuit has no duration, or its signals have more than 100,000 segments.
    """
    # Checks without cost come before the compilation.
    circuit.run.grid()
    instance = circuit.instance
    problem, model = instance.problem(circuit.run), instance.model
    if problem.starts.size > MAX_SEGMENTS:
        raise InputError("deploy.segments", "signals", count=int(problem.starts.size), most=MAX_SEGMENTS)
    names, inputs = instance.input_names, []
    first = problem.coefficients[problem.courses[0]]
    start_values = first[:, 0] + first[:, 2] * np.sin(first[:, 5])
    for item, input_name, value in zip(model.inputs, identifiers(names), start_values, strict=True):
        low, high = (instance.parameters[end] if isinstance(end, str) else end for end in (item.low, item.high))
        is_driven = (item.slope_of or item.name) in instance.signals
        parameter = instance.place(item.default) if isinstance(item.default, str) and not item.slope_of else -1
        slope_of = names.index(item.slope_of) if item.slope_of else -1
        inputs.append(
            ExportInput(item.name, input_name, item.unit, float(value), low, high, parameter, is_driven, slope_of)
        )
    specs, numbers, tied = parameter_specs(circuit), circuit.numbers(), find_tied(circuit)
    delays = {item.delay for item in model.inputs if item.delay}
    guided = {item.slope_of for item in model.inputs if item.slope_of in instance.signals}
    parameters, values = [], problem.p[: len(model.parameters)]
    for address, parameter_name, value in zip(model.parameters, identifiers(model.parameters), values, strict=True):
        number, spec = numbers.get(address), specs.get(address) or NumberSpec("1", address)
        if number is None:
            fixed = "derived"
        elif address in delays:
            fixed = "delay"
        elif address in guided:
            fixed = "driven"
        else:
            fixed = "tied" if address in tied else ""
        low, high = max(spec.ends[0], next_float(spec.above, 1.0)), min(spec.ends[1], next_float(spec.below, -1.0))
        above = spec.above if low > spec.ends[0] else None
        below = spec.below if high < spec.ends[1] else None
        unit = number.unit if number else spec.unit
        limits = low, high, above, below
        parameters.append(ExportParameter(address, parameter_name, unit, float(value), *limits, spec.meaning, fixed))
    discrete_start = problem.p[len(model.parameters) :]
    states = zip(model.states, problem.x0[: len(model.states)], strict=True)
    return ExportModel(
        identifier(name or circuit.title or "model"), circuit.title, instance, problem,
        tuple(parameters),
        tuple(inputs),
        _export_quantities((state.name, state.unit, value) for state, value in states),
        _export_quantities((*row, value) for row, value in zip(model.memory, discrete_start, strict=True)),
        _export_quantities((*row, np.nan) for row in model.outputs),
    )  # fmt: skip


def _export_quantities(rows: Iterable[tuple[str, str, float]]) -> tuple[ExportQuantity, ...]:
    rows = list(rows)
    names = identifiers([address for address, _, _ in rows])
    return tuple(ExportQuantity(a, name, unit, float(v)) for name, (a, unit, v) in zip(names, rows, strict=True))


def parameter_specs(circuit: BaseCircuit) -> dict[str, NumberSpec]:
    """Return the declarations of all parameters of a circuit by address.

    A declaration contains unit, limits and meaning.
    """
    specs = number_specs(circuit)
    for section in ("ambient", "gas"):
        specs |= {f"{section}.{key}": spec for key, spec, _ in flatten(getattr(circuit, section))}
    return specs


def next_float(limit: float, direction: float) -> float:
    """Return the floating-point number next to a limit that is excluded from a range.

    `direction` is 1 for the next larger number and -1 for the next smaller one. An infinite limit is returned
    unchanged.
    """
    if not np.isfinite(limit):
        return limit
    return limit + direction * max(abs(limit) * sys.float_info.epsilon, sys.float_info.min)


def find_tied(circuit: BaseCircuit) -> frozenset[str]:
    """Return the addresses of parameters that cannot be changed alone (tied parameters).

    A parameter is tied if other parameters or the structure of the circuit depend on it, or if no neighbouring value is
    valid. To find out, each parameter is changed slightly. A parameter of a part affects this part alone, so the change
    is made within the part; parts without derived values and checks have no tied parameters. The ambient conditions and
    the gas affect all parts.
    """
    specs, values = parameter_specs(circuit), circuit.parameters
    tied = {f"{name}.{key}" for name in circuit.parts for key in tied_of_part(circuit, name, specs)}
    for section in ("ambient", "gas"):
        for key, neighbour in _neighbours(circuit, section, specs).items():
            address = f"{section}.{key}"
            try:
                changed = None if neighbour is None else circuit.with_values({address: neighbour})
            except InputError:
                changed = None
            if changed is None or changed.parameters != {**values, address: neighbour}:
                tied.add(address)
    return frozenset(tied)


def tied_of_part(circuit: BaseCircuit, name: str, specs: Mapping[str, NumberSpec]) -> frozenset[str]:
    """Return the tied parameters of one part by their names inside it, see `find_tied`.

    `specs` is the result of `parameter_specs`.
    """

    def check(changed: Part) -> None:
        with ErrorCollector() as errors:
            check_starts(errors, {**circuit.parts, name: changed}, circuit.signals)

    neighbours = _neighbours(circuit, name, specs)
    valid = {key: value for key, value in neighbours.items() if value is not None}
    tied = _tied_in_part(circuit.parts[name], valid, circuit.surroundings, check)
    return frozenset(tied | (neighbours.keys() - valid.keys()))


def _neighbours(circuit: BaseCircuit, name: str, specs: Mapping[str, NumberSpec]) -> dict[str, float | None]:
    """Return a slightly changed value of each parameter of a part or a section, None if no such value is valid."""
    values, numbers, neighbours = _values_within(circuit.parameters, name), circuit.numbers(), {}
    for key, value in values.items():
        if f"{name}.{key}" in numbers:
            spec = specs.get(f"{name}.{key}") or NumberSpec("1", key)
            candidates = [value * (1.0 + sign * 1e-6) if value else sign * 1e-6 for sign in (1.0, -1.0)]
            neighbours[key] = next((candidate for candidate in candidates if spec.holds(candidate)), None)
    return neighbours


def _values_within(values: Mapping[str, float], name: str) -> dict[str, float]:
    """Return the values of one part or section by their names inside it.

    `values` maps complete addresses to values. Those that begin with `name` and a dot are selected.
    """
    return {key.removeprefix(f"{name}."): value for key, value in values.items() if key.startswith(f"{name}.")}


def _tied_in_part(
    part: Part, neighbours: Mapping[str, float], surroundings: Surroundings, check: Callable[[Part], None]
) -> set[str]:
    """Return the names of the parameters of a part that cannot be changed alone.

    `neighbours` maps each parameter to a slightly changed value. `check` raises an error if the changed part is not
    valid.
    """
    tied: set[str] = set()
    values = part.parameters(surroundings)
    if isinstance(part, Compound) and type(part).parameters is Compound.parameters:
        # The values of a member depend on the member and on the parameters of the compound itself.
        for name, member in part.members.items():
            keys = _tied_in_part(member, _values_within(neighbours, name), surroundings, lambda changed: None)
            tied |= {f"{name}.{key}" for key in keys}
        neighbours = {key: v for key, v in neighbours.items() if key.partition(".")[0] not in part.members}
    elif set(values) <= set(part.numbers()) and type(part).check is Part.check:
        return tied
    for key, neighbour in neighbours.items():
        try:
            changed = change_values({"part": part}, {f"part.{key}": neighbour})["part"]
            check(changed)
            is_tied = changed.parameters(surroundings) != {**values, key: neighbour}
        except InputError:
            is_tied = True
        if is_tied or changed.structure() != part.structure():
            tied.add(key)
    return tied

"""Map from the values of sliders to the parameters of the model that depend on them.

The parts compute their parameters from the numbers of the circuit file. The same methods, called with symbols instead
of numbers, give the expressions that the page needs.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, fields, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.addresses import change_values
from poppet.circuit.stop_conditions import parse_stop_condition
from poppet.circuit.trace import SURROUNDINGS
from poppet.core.errors import ErrorCollector, InputError
from poppet.core.provenance import Number
from poppet.core.symbolic import is_symbolic
from poppet.deploy.export_model import ExportModel
from poppet.laws.iso6358 import factors_from_air
from poppet.parts.part import Part, Surroundings
from poppet.timeseries.segments import SegmentTable

if TYPE_CHECKING:
    import casadi

    from poppet.circuit.circuit import BaseCircuit

TOLERANCE = 1e-10
"""Largest relative difference between a value of the map and that of Python."""
_FAILURES = (InputError, TypeError, ValueError, RuntimeError)
"""Errors of a check or a function that requires the value of a symbol; the last one is that of CasADi."""
MAX_SEGMENTS = 10_000
"""Largest number of segments of a signal whose delay a page changes."""
MAX_INSTRUCTIONS = 200_000
"""Largest number of instructions of the map on a page."""


@dataclass(frozen=True)
class ParameterMap:
    """Parameters of the model as a function of the values of all sliders.

    The function has one argument, the values of the sliders in the order of `addresses`. Its result contains the
    elements of p with the indices `places`, then the thresholds of the stop conditions with the indices `conditions`.
    Values are in SI units. A gauge pressure in the circuit file remains a gauge value.
    """

    function: casadi.Function
    addresses: tuple[str, ...]
    values: tuple[float, ...]  # in the circuit file
    places: tuple[int, ...]
    conditions: tuple[int, ...]
    links: tuple[tuple[int, int], ...]  # of each input: indices in p of its constant value and of its delay, or -1
    signals: Mapping[int, SegmentTable]  # of inputs with a delay that a slider changes, without the delay

    def evaluate(self, values: Sequence[float]) -> NDArray[np.float64]:
        """Return the elements of p with the indices `places` for given values of the sliders."""
        return np.array(self.function(np.array(values, dtype=float))).ravel()[: len(self.places)]

    def header(self) -> dict[str, Any]:
        """Return the data with which the script of a page calls the function.

        A row of a signal contains time, value, slope, jump, amplitude, frequency, chirp rate and phase.
        """
        columns = ("start", "value", "slope", "jump", "amplitude", "frequency", "chirp_rate", "phase")
        signals = {
            str(k): [list(row) for row in zip(*(getattr(table, name).tolist() for name in columns), strict=True)]
            for k, table in self.signals.items()
        }
        return {
            "values": self.values, "places": self.places, "conditions": self.conditions, "links": self.links,
            "signals": signals,
        }  # fmt: skip


def trace_parameters(export_model: ExportModel, circuit: BaseCircuit, addresses: Sequence[str]) -> ParameterMap:
    """Return the map from the numbers at given addresses to the parameters that depend on them.

    Parameters
    ----------
    export_model : ExportModel
        Model of the circuit.
    circuit : Circuit
        Circuit of the numbers.
    addresses : sequence of str
        Addresses of numbers of the circuit.

    Returns
    -------
    ParameterMap

    Raises
    ------
    InputErrors
        If a parameter of the model depends on a number in a way that cannot be written as an expression.
    """
    import casadi as ca

    numbers, symbols = circuit.numbers(), ca.SX.sym("s", len(addresses))
    elements: Any = ca.vertsplit(symbols)
    symbol_of = {
        address: replace(numbers[address], value=element, text="")
        for address, element in zip(addresses, elements, strict=True)
    }
    surroundings = _surroundings(circuit, symbol_of)
    shared = dict(zip(SURROUNDINGS, (getattr(surroundings, f.name) for f in fields(surroundings)), strict=True))
    is_shared = is_symbolic(*shared.values())
    expressions: dict[str, Any] = dict(circuit.parameters) | shared
    free = {parameter.address for parameter in export_model.parameters if parameter.is_free}
    with ErrorCollector() as errors:
        for name, part in circuit.parts.items():
            own = {address: number for address, number in symbol_of.items() if address.startswith(f"{name}.")}
            if own or is_shared:
                with errors.collecting():
                    expressions |= _part_parameters(name, part, own, surroundings, free)
    places, results = [], []
    for k, parameter in enumerate(export_model.parameters):
        # A signal that prescribes a motion, not the parameter, determines its start.
        if is_symbolic(expressions[parameter.address]) and parameter.fixed != "driven":
            places.append(k)
            results.append(expressions[parameter.address])
    conditions = []
    for k, text in enumerate(circuit.run.stop_texts):
        weight = parse_stop_condition(text, dict(export_model.model.outputs), surroundings.pressure).weights[2]
        if is_symbolic(weight):
            conditions.append(k)
            results.append(weight)
    result = ca.cse([ca.densify(ca.vertcat(*results))]) if results else [ca.SX(0, 1)]
    function = ca.Function("mapped", [symbols], result)
    if function.n_instructions() > MAX_INSTRUCTIONS:
        raise InputError("deploy.live.tied", addresses[0])
    values = tuple(numbers[address].value for address in addresses)
    links, signals = _links(export_model, circuit, set(places))
    return ParameterMap(function, tuple(addresses), values, tuple(places), tuple(conditions), links, signals)


def _links(
    export_model: ExportModel, circuit: BaseCircuit, changed: Set[int]
) -> tuple[tuple[tuple[int, int], ...], dict[int, SegmentTable]]:
    """Return the links of all inputs, and the signals whose delay is one of the parameters with indices `changed`."""
    links, signals, duration = [], {}, float(circuit.run.grid()[-1])
    for k, (item, declared) in enumerate(zip(export_model.inputs, export_model.model.inputs, strict=True)):
        delay = export_model.instance.place(declared.delay) if declared.delay and not declared.slope_of else -1
        links.append((-1 if item.is_driven else item.parameter, delay))
        # The start of a fault, which has no signal of the circuit, cannot have a slider.
        if item.address in circuit.signals and delay in changed:
            signals[k] = circuit.signals[item.address].table(duration)
            if len(signals[k]) > MAX_SEGMENTS:
                raise InputError("deploy.live.delay", export_model.parameters[delay].address)
    return tuple(links), signals


def _surroundings(circuit: BaseCircuit, numbers: Mapping[str, Number]) -> Surroundings:
    """Return the ambient conditions and the gas of a circuit, with symbols for the values in `numbers`."""
    given = circuit.surroundings
    names = ("ambient.pressure", "ambient.temperature", "gas.gas_constant", "gas.isentropic_exponent")
    pressure, temperature, gas_constant, exponent = (
        numbers[name].value if name in numbers else getattr(given, field.name)
        for name, field in zip(names, fields(given), strict=False)
    )
    factors = given.conductance_factor, given.ratio_shift
    if circuit.gas.conductances == "from air" and is_symbolic(gas_constant, exponent):
        factors = factors_from_air(exponent, gas_constant)
    return Surroundings(pressure, temperature, gas_constant, exponent, *factors)


def _part_parameters(
    name: str, part: Part, numbers: Mapping[str, Number], surroundings: Surroundings, free: Set[str]
) -> dict[str, Any]:
    """Return all parameters of a part by address, with symbols for some of its numbers.

    The addresses in `free` are those of parameters on which no other parameter depends. If a check of the part requires
    the value of such a number, its parameter is the number itself.
    """

    def parameters(numbers: Mapping[str, Number]) -> dict[str, Any]:
        changed = change_values({name: part}, numbers)[name]
        return {f"{name}.{key}": value for key, value in changed.parameters(surroundings).items()}

    try:
        return parameters(numbers)
    except _FAILURES:
        pass
    traceable, plain = {}, {}
    for address, number in numbers.items():
        try:
            parameters({address: number})
            traceable[address] = number
        except _FAILURES:
            if address not in free:
                raise InputError("deploy.live.tied", address) from None
            plain[address] = number.absolute(surroundings.pressure)
    return parameters(traceable) | plain

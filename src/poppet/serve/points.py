"""Points of a served circuit: its inputs, outputs and parameters, and the faults of its valves."""

from __future__ import annotations

import enum
import math
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.audit.valve_faults import ValveFault, with_idle_faults
from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.coupled_run import require_permission
from poppet.circuit.onset import onset_inputs
from poppet.parts.faults import HEALTHY, Valve
from poppet.parts.part import Controller, Input

Array = NDArray[np.float64]
PUBLISHED_FIRST, PUBLISHED_LAST = "time", "lateness"
"""Names of the first and the last column of the rows of a machine; the outputs are between them."""


class PointRole(enum.Enum):
    """Role of a point: writable input, output or parameter."""

    INPUT = "input"
    OUTPUT = "output"
    PARAMETER = "parameter"


@dataclass(frozen=True)
class Point:
    """One quantity of a served circuit that clients can read.

    Parameters
    ----------
    address : str
        Address of the quantity, `tank.pressure`.
    unit : str
        SI unit, `1` for a number. Pressures are absolute.
    role : PointRole
        Clients can write inputs only.
    low, high : float
        Range of valid values; infinite for outputs and parameters.
    initial : float
        Value at the start; NaN for an output, whose first value is that of the first period.
    doc : str
        Short description.
    is_flag : bool, optional
        True if the value is 0 or 1.
    """

    address: str
    unit: str
    role: PointRole
    low: float
    high: float
    initial: float
    doc: str
    is_flag: bool = False


@dataclass(frozen=True, eq=False)
class FaultLocation:
    """Location of the fault of a valve in its model: the input that starts it, and the parameter that selects it."""

    input: str
    code: str


@dataclass(frozen=True, eq=False)
class ServedCircuit:
    """Circuit whose valves all can have a fault, with the points that clients read and write.

    `ServedCircuit.of` makes it. It can be pickled, and needs no machine code.

    Parameters
    ----------
    circuit : BaseCircuit
        Circuit with an idle fault in each valve.
    faults : mapping
        Mapping from the name of each valve to the faults that it can have.
    initial_faults : mapping
        Mapping from the name of each valve to its fault in the circuit file, or `none`.
    """

    circuit: BaseCircuit
    faults: Mapping[str, tuple[str, ...]]
    initial_faults: Mapping[str, str]

    @classmethod
    def of(cls, circuit: BaseCircuit, *, allow_native: bool = False) -> ServedCircuit:
        """Return the served form of a circuit, which is unchanged.

        `allow_native` permits FMUs of the circuit to execute native code; without it, they raise an error.
        """
        if not allow_native:
            require_permission(circuit)
        valves = {
            name: part
            for name, part in circuit.parts.items()
            if isinstance(part, Valve) and f"{name}.fault" not in circuit.connections
        }
        idle = [ValveFault(name, part.faults[0]) for name, part in valves.items() if part.fault == HEALTHY]
        return cls(
            with_idle_faults(circuit, idle),
            {name: part.faults for name, part in valves.items()},
            {name: part.fault for name, part in valves.items()},
        )

    def __reduce__(self) -> tuple[Any, ...]:
        # Another process derives the points again.
        return type(self), (self.circuit, dict(self.faults), dict(self.initial_faults))

    @cached_property
    def columns(self) -> tuple[str, ...]:
        """Addresses of the outputs of a run, in the order of the model."""
        return self.circuit.symbolic_model.columns[0]

    @cached_property
    def column_units(self) -> tuple[str, ...]:
        """SI units of the outputs."""
        return self.circuit.symbolic_model.columns[1]

    @cached_property
    def fault_locations(self) -> Mapping[str, FaultLocation]:
        """Mapping from the name of each valve to the location of its fault in the model."""
        locations = {}
        for address, item in self.circuit.inputs.items():
            name = address.partition(".")[0]
            if item.is_onset and name in self.faults:
                owner = f"{name}.{item.delay}".rpartition(".")[0]
                locations[name] = FaultLocation(address, f"{owner}.fault_code")
        return locations

    @cached_property
    def writable(self) -> tuple[str, ...]:
        """Addresses of the inputs that clients can write: neither connected nor driven by a signal."""
        circuit, fault_inputs = self.circuit, {location.input for location in self.fault_locations.values()}
        onsets = onset_inputs(circuit.inputs, circuit.signals, circuit.connections)
        of_fmus = {f"{name}.{v.local}" for name, part in circuit.fmus.items() for v in part.description.outputs}
        excluded = {*circuit.signals, *onsets, *fault_inputs, *of_fmus}
        return tuple(
            item.name for item in circuit.symbolic_model.inputs if not item.slope_of and item.name not in excluded
        )

    @cached_property
    def points(self) -> tuple[Point, ...]:
        """All points: the writable inputs, the outputs, and the parameters."""
        return (*self._input_points(), *self._output_points(), *self._parameter_points())

    @cached_property
    def by_address(self) -> Mapping[str, Point]:
        """Mapping from addresses to points."""
        return MappingProxyType({point.address: point for point in self.points})

    def _input_points(self) -> Iterator[Point]:
        parameters = self.circuit.parameters
        declared = {item.name: item for item in self.circuit.symbolic_model.inputs}

        def number(value: str | float) -> float:
            return parameters[value] if isinstance(value, str) else float(value)

        for address in self.writable:
            item, part_input = declared[address], self._input(address)
            yield Point(
                address, item.unit or "1", PointRole.INPUT, number(item.low), number(item.high), number(item.default),
                self._doc(address), is_flag=part_input is not None and part_input.is_flag,
            )  # fmt: skip

    def _output_points(self) -> Iterator[Point]:
        hidden = {*self.writable, *(location.input for location in self.fault_locations.values())}
        for address, unit in zip(self.columns, self.column_units, strict=True):
            if address not in hidden:
                yield Point(
                    address, unit or "1", PointRole.OUTPUT, -math.inf, math.inf, math.nan, self._doc(address),
                    is_flag=self._is_flag(address),
                )  # fmt: skip

    def _parameter_points(self) -> Iterator[Point]:
        excluded, numbers = {*self.writable, *self.columns}, self.circuit.numbers()
        ambient = self.circuit.surroundings.pressure
        for address, number in numbers.items():
            if address not in excluded and not address.endswith((".fault_start",)):
                value = number.value + (ambient if number.reference == "gauge" else 0.0)
                yield Point(
                    address, number.unit or "1", PointRole.PARAMETER, -math.inf, math.inf, value, self._doc(address)
                )  # fmt: skip

    def _input(self, address: str) -> Input | None:
        return self.circuit.inputs.get(address)

    def _is_flag(self, address: str) -> bool:
        """Return True if an output is 0 or 1: a flag of a controller or an input, or a step of a sequence."""
        name, _, local = address.partition(".")
        part, item = self.circuit.parts.get(name), self._input(address)
        is_flag_of_part = isinstance(part, Controller) and local in part.flags()
        return is_flag_of_part or ":" in local or (item is not None and item.is_flag)

    def _doc(self, address: str) -> str:
        name, _, local = address.partition(".")
        part = self.circuit.parts.get(name)
        text = local.replace("_", " ").replace(".", " ")
        return f"{text} of {name} ({part.summary})" if part is not None else f"{text} ({name})"

"""Numbers of a circuit that change while it runs, and their effect on parameters and inputs of the compiled model."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import cast

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.instance import Instance
from poppet.circuit.number_specs import number_specs
from poppet.circuit.options import Ambient, GasChoice
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.parts.fields import NumberSpec, declared

Array = NDArray[np.float64]
Integers = NDArray[np.int64]
STEP = 1e-3
"""Relative change of a number for the derivatives of the numbers that depend on it."""
CURVATURE = 1e-6
"""Maximum relative difference of the derivative over two steps."""


@dataclass(frozen=True, eq=False)
class FreeNumbers:
    """Numbers of a circuit that can change during a run, and their linear effect on the arrays of the model.

    With the numbers `theta`, the touched elements of the parameter vector p, followed by the touched elements of the
    input vector u, are ``base + directions @ (theta - values)``, where `base` contains their present values.
    """

    addresses: tuple[str, ...]
    units: tuple[str, ...]
    values: Array  # (m,) present values, SI, absolute
    low: Array  # (m,) limits of the parts
    high: Array
    sizes: Array  # (m,) typical sizes, never zero
    places: Integers  # (k,) indices of the touched elements of p
    inputs: Integers  # (j,) indices of the touched elements of u
    directions: Array  # (k + j, m)

    def base(self, p: Array, u: Array) -> Array:
        """Return the touched elements of a parameter vector p and an input vector u, (k + j,)."""
        return np.concatenate([p[self.places], u[self.inputs]])

    def write(self, numbers: Array, base: Array, p: Array, u: Array) -> None:
        """Write the elements that follow from the values `numbers`, (m,), into p and u.

        `base` contains the touched elements for the present values.
        """
        touched = base + self.directions @ (numbers - self.values)
        p[self.places], u[self.inputs] = touched[: self.places.size], touched[self.places.size :]


def free_numbers(instance: Instance, addresses: Sequence[str]) -> FreeNumbers:
    """Return the effect of free numbers on the parameters and inputs of a compiled model.

    A number on which others depend changes them too: the conductance of the second way of a valve, the gauge pressures
    of a circuit whose ambient pressure is free, or the constant pressure of a reservoir. The effect must be linear.

    Parameters
    ----------
    instance : Instance
        Compiled model with parameter values and signals. An input with a signal does not depend on its parameter.
    addresses : sequence of str
        Addresses of numbers of the parts, or of sections such as `ambient.pressure`.

    Raises
    ------
    InputErrors
        If an address is unknown, or names an option or an input. If it is given twice. If the number affects neither
        rates nor outputs, or affects other numbers nonlinearly. All errors are reported together.
    """
    model, circuit = instance.model, cast(BaseCircuit, instance.circuit.with_values(instance.changes))
    numbers = circuit.numbers()
    specs = {a: spec for a, spec in [*number_specs(circuit).items(), *_section_specs()] if a in numbers}
    values = {a: numbers[a].absolute(circuit.surroundings.pressure) for a in addresses if a in specs}
    read_parameters, read_inputs = model.influences
    parameter_of = {
        k: instance.place(item.default)
        for k, item in enumerate(model.inputs)
        if isinstance(item.default, str) and item.name not in instance.signals and not item.slope_of
    }
    # Other parameters are needed at the start of a run only.
    is_read = np.zeros(len(instance.parameters), dtype=np.bool_)
    is_read[[*read_parameters, *(parameter_of[k] for k in read_inputs & parameter_of.keys())]] = True
    columns, sizes = list[Array](), list[float]()
    with ErrorCollector() as errors:
        for k, address in enumerate(addresses):
            with errors.collecting():
                if address not in specs:
                    raise _not_a_number(address, circuit, specs)
                if address in addresses[:k]:
                    raise InputError("free.twice", address)
                # A number that is zero has the size of the others with its unit.
                spec, alike = specs[address], [abs(n.value) for n in numbers.values() if n.unit == specs[address].unit]
                size = abs(values[address]) or max(alike) or 1.0
                column, is_linear = _slopes(instance, address, values[address], STEP * size, spec)
                sizes.append(size)
                bent = [n for n, is_bent in zip(instance.parameters, is_read & ~is_linear, strict=True) if is_bent]
                if bent:
                    raise _not_linear(instance, address, bent)
                if not column[is_read].any():
                    raise InputError("free.no_effect", address)
                columns.append(column)
    slopes = np.array(columns).reshape(len(columns), is_read.size).T
    touched = set(np.flatnonzero(slopes.any(axis=1)).tolist())
    places = sorted(touched & read_parameters)
    inputs = [k for k, index in parameter_of.items() if k in read_inputs and index in touched]
    low, high = np.array([_limits(specs[a]) for a in addresses]).reshape(-1, 2).T
    return FreeNumbers(
        addresses=tuple(addresses),
        units=tuple(specs[a].unit for a in addresses),
        values=np.array([values[a] for a in addresses], dtype=np.float64),
        low=low,
        high=high,
        sizes=np.array(sizes),
        places=np.array(places, dtype=np.int64),
        inputs=np.array(inputs, dtype=np.int64),
        directions=np.ascontiguousarray(slopes[[*places, *(parameter_of[k] for k in inputs)]]),
    )


def _section_specs() -> Iterator[tuple[str, NumberSpec]]:
    """Yield the address and the declaration of each number of the sections `ambient` and `gas`."""
    for section, kind in (("ambient", Ambient), ("gas", GasChoice)):
        for name, _, spec in declared(kind, NumberSpec):
            yield f"{section}.{name}", spec


def _limits(spec: NumberSpec) -> tuple[float, float]:
    return max(spec.low, spec.above), min(spec.high, spec.below)


def _not_a_number(address: str, circuit: BaseCircuit, specs: Mapping[str, NumberSpec]) -> InputError:
    """Return the error of an address that does not name a number of the circuit."""
    if address in circuit.inputs:
        return InputError("address.is_input", address)
    name, _, option = address.rpartition(".")
    if name in circuit.parts and option in circuit.parts[name].options():
        return InputError("free.option", address, value=circuit.parts[name].options()[option])
    return InputError(
        "names.unknown", address, meaning="a number of this circuit", suggestion=NameSuggestion(address, specs)
    )


def _not_linear(instance: Instance, address: str, names: list[str]) -> InputError:
    """Return the error of a number on which the numbers `names` depend nonlinearly."""
    settings = {name: instance.parameters[name] for name in names}
    try:
        instance.with_values(settings)
    except InputError:
        # A part computes them; they are no fields of their own.
        return InputError("free.not_linear_inside", address, names=names)
    return InputError(
        "free.not_linear", address, names=names, settings=[f"{name} = {value:.6g}" for name, value in settings.items()]
    )


def _slopes(
    instance: Instance, address: str, value: float, step: float, spec: NumberSpec
) -> tuple[Array, NDArray[np.bool_]]:
    """Return the derivatives of all parameters by one number, and a mask of the parameters that are linear in it.

    The parts compute the parameters for the present value of the number and for two others, at most two `step` away.
    """
    low, high = _limits(spec)
    step = min(step, 0.25 * (high - low))
    if not value + 2.0 * step < high:
        step = -step
    present, first, second = (
        np.array(list(instance.with_values({address: value + k * step}).parameters.values())) for k in range(3)
    )
    slopes = (second - present) / (2.0 * step)
    rounding = 1e-14 * np.abs(present) / abs(step)
    is_linear = np.abs((first - present) / step - slopes) <= CURVATURE * np.abs(slopes) + rounding
    # Without the rounding errors of the differences.
    integers = np.round(slopes)
    slopes = np.where(np.abs(slopes - integers) <= np.where(integers == 0.0, rounding, 1e-9), integers, slopes)
    return slopes, is_linear

"""Values of a circuit's inputs while they are held."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from poppet.engine.model import InputInfo
from poppet.ground.errors import InputError, collect, suggestion
from poppet.ground.units import quantity

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

Array = NDArray[np.float64]


def input_values(circuit: Circuit, given: Mapping[str, Any]) -> Array:
    """Every input: as given, else as its signal is at t = 0, else its number."""
    known = {item.name: item for item in circuit.model.inputs}
    problems = [
        InputError(f"inputs: {name}", "is no input of this circuit.", suggestion(name, known), address=name)
        for name in given
        if name not in known
    ]
    values = []
    for name, item in known.items():
        try:
            values.append(_given_value(circuit, item, given[name]) if name in given else _default_value(circuit, item))
        except InputError as error:
            problems.append(error)
    collect(problems)
    return np.array(values, dtype=float)


def _given_value(circuit: Circuit, item: InputInfo, given: Any) -> float:
    read = quantity(given, item.unit, kind=item.kind, name=item.name)  # type: ignore[arg-type]
    value = read.value + (circuit.surroundings.pressure if read.reference == "gauge" else 0.0)
    low, high = (circuit.parameters[each] if isinstance(each, str) else each for each in (item.low, item.high))
    if not low <= value <= high:
        raise InputError(
            f"inputs: {item.name} = {given}",
            f"is outside {low:g} ... {high:g}{'' if item.unit == '1' else f' {item.unit}'}.",
            "Give a value inside.",
            address=item.name,
        )
    return value


def _default_value(circuit: Circuit, item: InputInfo) -> float:
    signal = circuit.signals.get(item.name)
    if signal is not None:
        return float(signal.table(1.0).evaluate(0.0))
    return circuit.parameters[item.default] if isinstance(item.default, str) else item.default

"""Order and result of a task, and the operations with which the editor applies a result."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from poppet.api import Circuit, loads
from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import InputError
from poppet.core.number_format import readable_unit
from poppet.core.provenance import Number
from poppet.core.units import convert, unit_in
from poppet.edit.document import MARK, Document
from poppet.parts.fields import NumberSpec

_CLOSE = 1e-4
"""Largest relative difference between a result and the value that its operation sets."""

Report = Callable[[str, float, float | None], None]
"""Function that a task calls with the name of a step, the completed amount of work and the total if it is known."""


@dataclass(frozen=True)
class TaskOrder:
    """Order of a task: the circuit file as text, and the options of the user.

    Parameters
    ----------
    text : str
        Text of the circuit file.
    name : str
        Name of the circuit file without suffix; the names of result files begin with it.
    folder : Path
        Folder of the circuit file, to which relative paths refer.
    output : Path
        Empty folder for the result files.
    uploads : Path
        Folder of the recordings that the user has dropped.
    options : mapping
        Checked options of the task.
    report : callable
        Function that receives the progress.
    """

    text: str
    name: str
    folder: Path
    output: Path
    uploads: Path
    options: Mapping[str, Any]
    report: Report

    @cached_property
    def circuit(self) -> Circuit:
        """Circuit of the text; an invalid text raises all its errors."""
        return circuit_of(self.text, self.folder)

    def path(self, ending: str) -> Path:
        """Return the path of a result file, whose name is the name of the circuit file with an ending."""
        return self.output / f"{self.name}{ending}"

    def count(self, step: str) -> Callable[[int, int, str], None]:
        """Return a callback that reports completed runs of all runs."""
        return lambda done, total, _: self.report(step, done, total)


@dataclass(frozen=True)
class TaskResult:
    """Result of a task.

    Parameters
    ----------
    text : str
        Tables and sentences for the user.
    notes : tuple of str
        Notes on the result.
    operations : tuple of dict
        Operations of the editor that apply the result to the circuit.
    data : mapping
        Content that the page draws, or from which it makes a form.
    """

    text: str = ""
    notes: tuple[str, ...] = ()
    operations: tuple[dict[str, Any], ...] = ()
    data: Mapping[str, Any] = field(default_factory=dict)


def written_value(
    value: float, unit: str, like: Number | None = None, digits: int = 6, ambient: float = 1e5
) -> str | float:
    """Return an absolute SI value as text with a unit, that of the present value if it has one.

    A dimensionless value is a number. `ambient` is the ambient pressure, to which gauge pressures refer [Pa].

    Examples
    --------
    >>> written_value(0.0123, "m^3"), written_value(0.3, "1")
    ('12.3 l', 0.3)
    """
    if unit in ("", "1"):
        return float(f"{value:.{digits}g}")
    shown = shown_unit(value, unit, like)
    return f"{convert(value, unit, shown, ambient_pressure=ambient):.{digits}g} {shown}"


def shown_unit(value: float, unit: str, like: Number | None = None) -> str:
    """Return the unit in which the user has written a number, otherwise a unit that suits the value."""
    return unit_in(like.text if like is not None else "", unit) or readable_unit(unit, value)


def default_range(circuit: BaseCircuit, address: str, spec: NumberSpec) -> tuple[float, float]:
    """Return the range in which a parameter is sized by default, absolute in SI: a third to three times its value."""
    present = circuit.numbers()[address].absolute(circuit.surroundings.pressure)
    low, high = spec.ends
    return min(max(present / 3.0, low), high), min(max(3.0 * present, low), high)


def sourced(number: Number, like: Number | None = None, ambient: float = 1e5) -> dict[str, Any]:
    """Return a number as a value of a circuit file, with its source."""
    source = number.source
    stated = {"source": source.kind, "locator": source.locator, "note": source.note}
    value = written_value(number.value, number.unit, like, ambient=ambient)
    return {"value": value, **{key: text for key, text in stated.items() if text}}


def value_operations(order: TaskOrder, values: Mapping[str, Number]) -> tuple[dict[str, Any], ...]:
    """Return the operations that set parameters of the circuit.

    A parameter that the text of a circuit file cannot set, such as a coefficient of a characteristic, has no operation.
    """
    present, ambient = order.circuit.numbers(), order.circuit.surroundings.pressure
    operations: list[dict[str, Any]] = []
    for address, number in values.items():
        operation = {"op": "set", "address": address, "value": sourced(number, present.get(address), ambient)}
        if sets_value(order, [*operations, operation], address, number.value):
            operations.append(operation)
    return tuple(operations)


def sets_value(order: TaskOrder, operations: Iterable[Mapping[str, Any]], address: str, value: float) -> bool:
    """Return True if a parameter has a value, in SI and absolute, after operations on the text."""
    try:
        changed = changed_circuit(order, operations)
        number = changed.numbers()[address].absolute(changed.surroundings.pressure)
    except (InputError, KeyError):
        return False
    return math.isclose(number, value, rel_tol=_CLOSE)


def changed_circuit(order: TaskOrder, operations: Iterable[Mapping[str, Any]]) -> Circuit:
    """Return the circuit after operations on the text."""
    return circuit_of(Document(order.text).apply(operations).text, order.folder)


def circuit_of(text: str, folder: Path) -> Circuit:
    """Return the circuit of a text."""
    # Without a name: the errors of this text have no file.
    return loads(text.removeprefix(MARK), name="", folder=folder)

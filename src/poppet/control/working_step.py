"""Verification of tuned gains by a setpoint step of working size, with limits, dead zones and friction."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

import numpy as np

from poppet.control.describing_function import MeasuredLoop
from poppet.control.loop import Gains
from poppet.control.plant import Plant, point_label
from poppet.control.verification import Verification, verify_step
from poppet.core.codes import Note
from poppet.core.errors import InputError, SimulationError
from poppet.timeseries.signals import Points, Steps

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit

_CODES = ("tuning.grows", "tuning.swings")
"""Notes on a step of working size; overshoot and friction belong to the small steps."""


def largest_step(circuit: BaseCircuit, controller: str, values: Sequence[float]) -> tuple[float, float]:
    """Return the largest step from an operating point to a level of the setpoint signal.

    The result contains the operating point, one of `values`, and the size of the step, SI. The size is zero if the
    circuit has no setpoint signal with levels.
    """
    signal = circuit.signals.get(f"{controller}.setpoint")
    levels = np.asarray(signal.values, dtype=float).tolist() if isinstance(signal, Steps | Points) else []
    steps = [(value, level - value) for value in values for level in levels]
    return max(steps, key=lambda step: abs(step[1]), default=(0.0, 0.0))


def verify_working_step(
    plant: Plant, circuit: BaseCircuit, step: tuple[float, float], gains: Gains, crossover: float
) -> tuple[Verification | None, tuple[Note, ...]]:
    """Simulate a tuned loop with a setpoint step of the size that occurs in operation.

    `step` contains the operating point and the size of the step, SI. The result contains the verification, or None if
    the run fails, and its notes. A loop with a linear plant starts at the initial state of the circuit.
    """
    value, size = step
    label = point_label(plant, value, "a step of {value:.4g} {unit}".format(**plant.readable_value(size)))
    steady_run = plant.settled[value].rest if isinstance(plant, MeasuredLoop) else None
    if steady_run is None and plant.begins:
        circuit = circuit.with_values({plant.begins: value})
    try:
        run = verify_step(circuit, plant.controller, steady_run, value, size, gains, crossover, label)
    except SimulationError as error:
        return None, (error.note,)
    except InputError:
        return None, ()  # such as an initial position beyond a stop
    return run, tuple(note for note in run.notes(plant.controller) if note.code in _CODES)

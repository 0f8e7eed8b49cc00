"""Moments of an event in the run of a circuit: stated times, steps of its sequences, or an even division."""

from __future__ import annotations

from typing import Any

import numpy as np

from poppet.audit.safety_result import Moment
from poppet.audit.visits import Visit, visits_of
from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.units import quantity
from poppet.parts.sequence import Sequence
from poppet.timeseries.recording import Recording

STEPS = "steps"
"""Word for the moments of all steps."""
PER_STEP = 4
"""Number of moments per step: its start, and the ends of its first three quarters."""
EVEN_MOMENTS = 20
"""Number of moments in a circuit without a sequence."""
_ROW_STEP, _MAX_ROWS = 1e-3, 20_000
"""Smallest time between the rows of the run without an event [s], and the maximum number of rows."""


def read_times(circuit: BaseCircuit, at: Any) -> tuple[float, ...]:
    """Return stated times of an event [s], and report all errors together.

    `at` is a time, a list of times, None, or the word `steps`. The result is empty for None and for the word. An
    InputError reports a time outside the run, or the word for a circuit without a sequence.
    """
    if at is None or at == STEPS:
        if at == STEPS and not _sequences(circuit):
            raise InputError("safety.no_sequence", "at")
        return ()
    arguments = at if isinstance(at, list | tuple) else [at]
    times: list[float] = []
    end = None if circuit.run.duration is None else float(circuit.run.duration)  # type: ignore[arg-type]
    with ErrorCollector() as errors:
        for value in arguments:
            with errors.collecting():
                if isinstance(value, str) and value != STEPS and value.isalpha():
                    raise InputError(
                        "names.unknown",
                        value,
                        meaning="a moment of the event",
                        suggestion=NameSuggestion(value, [STEPS]),
                    )
                time = quantity(value, "s", name="at").value
                if time < 0.0 or (end is not None and time >= end):
                    raise InputError("safety.outside_run", "at", subject="event", time=time, end=end)
                times.append(time)
    return tuple(dict.fromkeys(times))


def healthy_run(circuit: BaseCircuit, times: tuple[float, ...]) -> Recording:
    """Return the run of a circuit without an event, with rows that are close enough for moments.

    `times` are the stated times of the event [s]. The last of them determines the duration if the circuit has none.
    """
    duration = circuit.run.duration
    if duration is None and times:
        duration = max(times) + _ROW_STEP
    elif duration is not None:
        duration = float(duration)  # type: ignore[arg-type]
    return circuit.simulate(duration, None if duration is None else row_step(duration), stop_when=())


def row_step(duration: float) -> float:
    """Return the time between rows for a run of given duration [s], independent of the output step of the circuit."""
    return min(max(_ROW_STEP, duration / _MAX_ROWS), duration)


def find_moments(circuit: BaseCircuit, healthy: Recording, times: tuple[float, ...]) -> tuple[Moment, ...]:
    """Return the moments of the event in the order of time.

    Stated times are the moments. Without them, each step of a sequence has four moments in its last visit that ends
    before the end of the run, or in its only visit. Without a sequence, 20 moments divide the run evenly.
    """
    end = float(healthy.time[-1])
    if not times and _sequences(circuit):
        times = tuple(time for name in _sequences(circuit) for time in _step_times(healthy, name))
    elif not times:
        times = tuple(end * k / EVEN_MOMENTS for k in range(EVEN_MOMENTS))
    return tuple(Moment(time, _active_step(circuit, healthy, time)) for time in sorted(dict.fromkeys(times)))


def present_value(healthy: Recording, address: str, time: float, default: float) -> float:
    """Return the value of an input at a time of the run without an event [s].

    `default` is the value of an input that is not an output of the circuit.
    """
    return float(healthy[address][_row(healthy, time)]) if address in healthy else default


def _row(healthy: Recording, time: float) -> int:
    """Return the last row at or before a time [s]."""
    return max(int(np.searchsorted(healthy.time, time * (1.0 + 1e-9), side="right")) - 1, 0)


def _sequences(circuit: BaseCircuit) -> list[str]:
    return [name for name, part in circuit.parts.items() if isinstance(part, Sequence)]


def _active_step(circuit: BaseCircuit, healthy: Recording, time: float) -> str:
    """Return the name of the active step of the first sequence at a time [s]; empty without a sequence."""
    name = next(iter(_sequences(circuit)), "")
    if not name:
        return ""
    sequence: Any = circuit.parts[name]
    step: str = sequence.program.names[int(healthy[f"{name}.step"][_row(healthy, time)]) - 1]
    return step


def _step_times(healthy: Recording, name: str) -> list[float]:
    """Return the moments of all steps of a sequence [s]."""
    visits, chosen = visits_of(healthy, name), dict[int, Visit]()
    for visit in visits:
        if visit is not visits[-1] or visit.step not in chosen:
            chosen[visit.step] = visit
    return [
        round(visit.start + (visit.end - visit.start) * part / PER_STEP, 9)
        for visit in chosen.values()
        for part in range(PER_STEP)
    ]

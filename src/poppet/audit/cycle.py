"""Machine cycle of a run: between two entries of a step of a sequence, the period of a signal, or stated times."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

import numpy as np

from poppet.audit.energy_result import Cycle
from poppet.audit.visits import visits_of
from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.instance import Array
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.units import quantity
from poppet.engine.model import Model
from poppet.parts.sequence import Sequence as StepSequence
from poppet.timeseries.recording import Recording
from poppet.timeseries.signals import Pwm, Sine, Square


def read_cycle(text: str, name: str = "--cycle") -> Cycle:
    """Return the cycle that a text states: its start and its end, `0.5 s, 1.9 s`.

    `name` is the name of the option in errors.

    Raises
    ------
    InputError
        If the text does not contain two times with units, or the start is not before the end.

    Examples
    --------
    >>> read_cycle("0.5 s, 1900 ms").duration
    1.4
    """
    times = [quantity(part.strip(), "s", name=name).value for part in text.split(",")]
    if len(times) != 2 or not 0.0 <= times[0] < times[1]:
        raise InputError("cycle.stated", name, value=text)
    return Cycle(times[0], times[1])


def find_cycle(circuit: BaseCircuit, recording: Recording, *, step: str = "", count: int = 1) -> Cycle:
    """Return the last `count` whole cycles of a run.

    A cycle begins with a step of a sequence: with `step`, or by default with the first step that the sequence enters
    twice. In a circuit without such a step, a cycle is the longest period of a signal.

    Parameters
    ----------
    circuit : Circuit
        The simulated circuit.
    recording : Recording
        Recording of the run. It contains at least one row in each visit to the step.
    step : str, optional
        Name of a step, or SEQUENCE.STEP.
    count : int, optional
        Number of cycles.

    Returns
    -------
    Cycle

    Raises
    ------
    InputError
        If the step is unknown, the run contains fewer cycles, or nothing in the circuit repeats.
    """
    sequences = [name for name, part in circuit.parts.items() if isinstance(part, StepSequence)]
    names = {name: [item.name for item in circuit.parts[name].program.steps] for name in sequences}  # type: ignore[attr-defined]
    if step:
        owners = [name for name in sequences if step in (*names[name], *(f"{name}.{item}" for item in names[name]))]
        if not owners:
            near = NameSuggestion(step, [item for name in sequences for item in names[name]])
            raise InputError("names.unknown", step, meaning="a step of a sequence", suggestion=near)
        if len(owners) > 1:
            raise InputError("cycle.several_steps", "--cycle-from", step=step, names=[f"{n}.{step}" for n in owners])
        first = step.removeprefix(f"{owners[0]}.")
        return _sequence_cycle(recording, owners[0], names[owners[0]], first, count)
    for name in sequences:
        visits = [visit.step for visit in visits_of(recording, name)]
        repeated = [number for number in visits if visits.count(number) > 1]
        if repeated:
            return _sequence_cycle(recording, name, names[name], names[name][repeated[0] - 1], count)
    if (cycle := _signal_cycle(circuit, float(recording.time[-1]), count)) is not None:
        return cycle
    if not sequences:
        raise InputError("cycle.no_source")
    name = sequences[0]
    entered = dict.fromkeys(names[name][visit.step - 1] for visit in visits_of(recording, name))
    raise InputError("cycle.no_repetition", name, steps=list(entered), end=float(recording.time[-1]))


def _sequence_cycle(recording: Recording, name: str, steps: Sequence[str], first: str, count: int) -> Cycle:
    visits = visits_of(recording, name)
    entries = [k for k, visit in enumerate(visits) if steps[visit.step - 1] == first]
    if len(entries) <= count:
        facts: dict[str, Any] = {"step": first, "visits": len(entries), "count": count}
        raise InputError("cycle.too_few", name, **facts, end=float(recording.time[-1]))
    begin, end = entries[-1 - count], entries[-1]
    visited = tuple(steps[visit.step - 1] for visit in visits[begin:end])
    return Cycle(visits[begin].start, visits[end].start, count, "sequence", name, visited)


def _signal_cycle(circuit: BaseCircuit, duration: float, count: int) -> Cycle | None:
    """Return the last periods of the slowest periodic signal, or None if no signal is periodic."""
    periods = {a: 1.0 / s.frequency for a, s in circuit.signals.items() if isinstance(s, Square | Pwm | Sine)}
    if not periods:
        return None
    address = max(periods, key=lambda key: periods[key])
    period = periods[address]
    last = int(duration / period * (1.0 + 1e-12))
    if last < count:
        raise InputError("cycle.too_short", address, period=period, count=count, end=duration)
    return Cycle((last - count) * period, min(last * period, duration), count, "signal", address)


def with_change(cycle: Cycle, model: Model, states: Array) -> Cycle:
    """Return a cycle with the largest change of a state from its start to its end.

    `states`, (n_states, n_times), contains the states of the model during the cycle. The change is relative to the
    largest value of a positive state such as a pressure, and to the range of any other state. States that affect no
    other state, such as counters of work, are excluded.
    """
    import casadi as ca

    if not states.size:
        return cycle
    rates, x = model.expressions["rates"], model.symbols["x"]
    affects = set(ca.jacobian_sparsity(rates, x).get_col())
    changes = {}
    for k, state in enumerate(model.states):
        size = float(np.abs(states[k]).max() if state.positive else np.ptp(states[k]))
        if k in affects and size > 1e-6 * state.nominal:
            changes[state.name] = abs(float(states[k, -1] - states[k, 0])) / size
    changed = max(changes, key=lambda name: changes[name], default="")
    return replace(cycle, change=changes.get(changed, 0.0), changed=changed)

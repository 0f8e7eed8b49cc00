"""Creation of the recording of a run, with its notes."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache, partial

import numpy as np

from poppet.circuit.ideal_gas import STATE_CODES
from poppet.circuit.instance import Array, Instance
from poppet.circuit.load_metrics import LoadData, load_metrics
from poppet.core.codes import Note
from poppet.engine.balances import Residual, residuals
from poppet.engine.problem import Outcome, Problem, RawRun, ending, is_failure
from poppet.parts.part import AMBIENT
from poppet.timeseries.recording import Recording


def make_recording(instance: Instance, problem: Problem, raw: RawRun) -> Recording:
    """Return the recording of a run, even if the run failed.

    `instance` is the compiled circuit, `problem` is the definition of the run, and `raw` contains the result arrays of
    the solver. Balance residuals and notes are computed at first use, because this computation takes a quarter of the
    time of a short run.
    """
    names, units = problem.kernel.model.columns
    balances = lru_cache(maxsize=1)(partial(residuals, problem, raw))
    return Recording(
        raw.time,
        names,
        units,
        raw.values,
        title=instance.title,
        notes=lambda: (*run_notes(instance, problem, raw, balances()), *raw.notes),
        outcome=ending(problem, raw),
        statistics={"accepted_steps": raw.accepted, "rejected_steps": raw.rejected},
        residuals=balances,
        ambient_pressure=instance.surroundings.pressure,
        inner=instance.inner,
        figures=partial(load_metrics, LoadData.of(instance, raw)) if problem.kernel.model.bodies else None,
    )


def run_notes(instance: Instance, problem: Problem, raw: RawRun, balances: tuple[Residual, ...] = ()) -> Iterator[Note]:
    """Yield all notes on a run.

    `raw` contains the result arrays of the solver. Notes of the circuit come first. Notes on signals, limits of
    characteristics, parts and balances follow.
    """
    # Notes on gas states at the start are replaced by notes on the gas states of the run.
    yield from (note for note in instance.notes if not (raw.time.size and note.code in STATE_CODES))
    # A run that failed in its first step has no row, but its signals can have notes.
    end = float(raw.time[-1] if raw.time.size else problem.grid[-1])
    for item in problem.kernel.model.inputs:
        if item.name in instance.signals:
            delay = instance.parameters[item.delay] if item.delay else 0.0
            yield from instance.signals[item.name].notes(end, item.name, delay)
    # Characteristics that were used outside their domains. For states, the check covers all steps of the solver,
    # because rows may miss an excursion between them. For other outputs, it covers the output times.
    model = problem.kernel.model
    state_index = {state.name: k for k, state in enumerate(model.states)}
    for address, (curve, stops) in instance.domains.items():
        if address in state_index:
            low, high = raw.extremes[:, state_index[address]]
        else:
            values = raw.values[model.columns[0].index(address)]
            low, high = (values.min(), values.max()) if values.size else (0.0, 0.0)
        if note := curve.outside(float(low), float(high), stops):
            yield note.within(address)
    if raw.time.size:
        indices = {name: k for k, (name, _) in enumerate(problem.kernel.model.outputs)}

        def series(address: str) -> Array:
            if address == "time":
                return raw.time
            if address in indices:
                row: Array = raw.values[indices[address]]
                return row
            assert address == f"{AMBIENT}.pressure", address
            return np.full(raw.time.size, instance.surroundings.pressure)

        yield from instance.circuit.result_notes(series)
    # A condition that is true at the start has usually the wrong direction.
    if raw.outcome is Outcome.STOPPED and raw.time.size == 1 and not is_failure(problem, raw):
        yield Note("run.nothing_ran", **problem.stop_conditions[raw.stop].reason.facts)
    if raw.outcome.is_success:
        for r in balances:
            if not r.is_kept:
                facts = {"quantity": r.quantity, "error": r.error, "unit": r.unit, "allowed": r.allowed}
                yield Note("run.not_conserved", r.store, **facts)

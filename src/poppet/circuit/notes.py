"""From the arrays of a run to a recording that says what a reader has to know."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.engine.balances import Residual, residuals
from poppet.engine.problem import Outcome, Problem, RawRun, ending, is_failure
from poppet.ground.codes import Note
from poppet.parts.part import AMBIENT
from poppet.series.recording import Recording

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit


def recording_of(circuit: Circuit, problem: Problem, raw: RawRun) -> tuple[Recording, str]:
    """Make the recording of a run, and the sentence of its failure (empty when it succeeded)."""
    model = problem.kernel.model
    names, units = model.columns
    how = str(ending(problem, raw))
    balances = residuals(problem, raw)
    recording = Recording(
        raw.time,
        names,
        units,
        raw.values,
        title=circuit.title,
        notes=(*_run_notes(circuit, problem, raw, balances), *map(str, raw.notes)),
        outcome=how,
        statistics={"accepted_steps": raw.accepted, "rejected_steps": raw.rejected},
        residuals=balances,
        ambient_pressure=circuit.surroundings.pressure,
    )
    return recording, how if is_failure(problem, raw) else ""


def _run_notes(circuit: Circuit, problem: Problem, raw: RawRun, balances: tuple[Residual, ...]) -> list[Note | str]:
    notes = list(circuit.static_notes)
    end = float(raw.time[-1] if raw.time.size else problem.grid[-1])
    for item in problem.kernel.model.inputs:
        if item.name in circuit.signals:
            delay = circuit.parameters[item.delay] if item.delay else 0.0
            notes += circuit.signals[item.name].notes(end, item.name, delay)
    notes += _domain_notes(circuit, problem, raw)
    notes += _remarks(circuit, problem, raw)
    if raw.outcome is Outcome.STOPPED and raw.time.size == 1 and not is_failure(problem, raw):
        notes.append(str(Note("run.nothing_ran", **problem.stop_conditions[raw.stop].reason.facts)))
    if raw.outcome.is_success:
        notes += [
            str(Note("run.not_conserved", r.store, quantity=r.quantity, error=r.error, unit=r.unit, allowed=r.allowed))
            for r in balances
            if not r.is_kept
        ]
    return notes


def _remarks(circuit: Circuit, problem: Problem, raw: RawRun) -> list[Note]:
    places = {name: k for k, (name, _) in enumerate(problem.kernel.model.outputs)}
    held = {f"{AMBIENT}.pressure": circuit.surroundings.pressure}

    def series(address: str) -> Any:
        if address == "time":
            return raw.time
        return raw.values[places[address]] if address in places else np.full(raw.time.size, held[address])

    if not raw.time.size:
        return []
    return [remark.within(name) for name, part in circuit.parts.items() for remark in part.remarks(name, series)]


def _domain_notes(circuit: Circuit, problem: Problem, raw: RawRun) -> list[Note]:
    notes = []
    places = {state.name: k for k, state in enumerate(problem.kernel.model.states)}
    for address, curve in circuit.domains.items():
        if address in places:
            low, high = raw.extremes[:, places[address]]
        else:
            row = raw.values[[name for name, _ in problem.kernel.model.outputs].index(address)]
            low, high = (row.min(), row.max()) if row.size else (0.0, 0.0)
        note = curve.outside(float(low), float(high))
        if note:
            notes.append(note.within(address))
    return notes

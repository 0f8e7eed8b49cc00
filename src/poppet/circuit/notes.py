"""From the arrays of a run to a recording that says what a reader has to know."""

from __future__ import annotations

from typing import Any

import numpy as np

from poppet.circuit.instance import Instance
from poppet.engine.solve import Outcome, Problem, RawRun, Residual, residuals
from poppet.ground.codes import Note
from poppet.parts.part import AMBIENT
from poppet.series.recording import Recording


def recording_of(instance: Instance, problem: Problem, raw: RawRun) -> tuple[Recording, str]:
    """Make the recording of a run, and the sentence of its failure (empty when it succeeded)."""
    model = problem.kernel.model
    names, units = model.columns
    left = _left_domain(problem, raw)
    failure = left or ("" if raw.outcome.is_success else _failure(problem, raw))
    balances = residuals(problem, raw)
    recording = Recording(
        raw.time,
        names,
        units,
        raw.values,
        title=instance.title,
        notes=(*_run_notes(instance, problem, raw, balances), *raw.notes),
        outcome=failure or _sentence(problem, raw),
        statistics={"accepted_steps": raw.accepted, "rejected_steps": raw.rejected},
        residuals=balances,
        ambient_pressure=instance.surroundings.pressure,
    )
    return recording, failure


def _sentence(problem: Problem, raw: RawRun) -> str:
    if raw.outcome is Outcome.STOPPED:
        return f"{raw.outcome.value} {problem.stop_conditions[raw.stop].text} at t = {raw.time[-1]:.6g} s."
    return str(raw.outcome.value)


def _left_domain(problem: Problem, raw: RawRun) -> str:
    """The failure of a run that left a characteristic with edge = "error"."""
    if raw.outcome is not Outcome.STOPPED:
        return ""
    text = problem.stop_conditions[raw.stop].text
    if not text.endswith("leaves its domain"):
        return ""
    return (
        f"The run ended at t = {raw.time[-1]:.6g} s: {text}, where its characteristic was fitted. "
        'Limit the stroke, or choose edge = "hold".'
    )


def _failure(problem: Problem, raw: RawRun) -> str:
    reached = float(raw.time[-1]) if raw.time.size else 0.0
    model = problem.kernel.model
    n = len(model.states)
    low = [(raw.x[k], s.name) for k, s in enumerate(model.states[:n]) if s.positive and raw.x[k] < 1e-6 * problem.x0[k]]
    hint = "Try a looser relative_tolerance, or a larger volume of the smallest chamber."
    if raw.outcome is Outcome.INTERRUPTED:
        hint = "The rows so far are kept."
    elif low:
        hint = f"{min(low)[1]} has fallen to {min(low)[0]:.3g}: a flow source may be drawing an empty store."
    return f"{raw.outcome.value} It ended after t = {reached:.6g} s, {raw.attempts} step attempts. {hint}"


def _run_notes(instance: Instance, problem: Problem, raw: RawRun, balances: tuple[Residual, ...]) -> list[Note | str]:
    notes: list[Note | str] = list(instance.notes)
    end = float(raw.time[-1] if raw.time.size else problem.grid[-1])
    for item in problem.kernel.model.inputs:
        if item.name in instance.signals:
            delay = instance.parameters[item.delay] if item.delay else 0.0
            notes += instance.signals[item.name].notes(end, item.name, delay)
    notes += _domain_notes(instance, problem, raw)
    notes += _remarks(instance, problem, raw)
    if raw.outcome is Outcome.STOPPED and raw.time.size == 1:
        text = problem.stop_conditions[raw.stop].text
        notes.append(f"{text} holds at the start already, so nothing ran. A bare number in a condition is in SI.")
    if raw.outcome.is_success:
        notes += [
            f"{r.name} is not conserved: {r.error:.3g} {r.unit}, allowed {r.allowed:.3g}."
            for r in balances
            if not r.is_kept
        ]
    return notes


def _remarks(instance: Instance, problem: Problem, raw: RawRun) -> list[Note]:
    places = {name: k for k, (name, _) in enumerate(problem.kernel.model.outputs)}
    held = {f"{AMBIENT}.pressure": instance.surroundings.pressure}

    def series(address: str) -> Any:
        if address == "time":
            return raw.time
        return raw.values[places[address]] if address in places else np.full(raw.time.size, held[address])

    if not raw.time.size:
        return []
    return list(instance.remarks(series))


def _domain_notes(instance: Instance, problem: Problem, raw: RawRun) -> list[str]:
    notes = []
    places = {state.name: k for k, state in enumerate(problem.kernel.model.states)}
    for address, curve in (instance.domains or {}).items():
        if address in places:
            low, high = raw.extremes[:, places[address]]
        else:
            row = raw.values[[name for name, _ in problem.kernel.model.outputs].index(address)]
            low, high = (row.min(), row.max()) if row.size else (0.0, 0.0)
        sentence = curve.outside(float(low), float(high))
        if sentence:
            notes.append(f"{address}: {sentence}")
    return notes

"""Tasks that simulate the circuit once or several times: reports, audits and exports."""

from __future__ import annotations

import zipfile
from collections.abc import Iterable
from dataclasses import replace
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.note_groups import grouped
from poppet.edit.tasks.order import TaskOrder, TaskResult
from poppet.timeseries.plotting.figures import style


def write_report(order: TaskOrder) -> TaskResult:
    """Simulate the circuit, and write an HTML report and the recording."""
    from poppet.report.run_report import write_run

    style("A report of a run")  # an error before the run if Matplotlib is missing
    circuit = order.circuit
    end = float(circuit.problem(circuit.run).grid[-1])
    recording = circuit.simulate(progress=lambda time: order.report("simulation", time, end), throw=False)
    if recording.time.size:
        order.report("report", 0.0, None)
        recording.save(order.path(".csv"))
        write_run(circuit, recording, order.path(".html"))
    return TaskResult(recording.outcome, sentences(recording.remarks))


def audit_energy(order: TaskOrder) -> TaskResult:
    """Audit air, energy and exergy of one machine cycle."""
    from poppet.audit.circuit_leaks import find_leaks
    from poppet.audit.energy import audit_energy as audit
    from poppet.audit.tariff import tariff_of
    from poppet.report.audit.energy_report import balance_table, write_energy

    style("A report of an audit")
    circuit = order.circuit
    end = float(circuit.problem(circuit.run).grid[-1])
    settings: dict[str, Any] = {"tariff": tariff_of(circuit), "cycle": order.options.get("cycle")}
    result = audit(circuit, **settings, progress=lambda time: order.report("simulation", time, end))
    leaks, leak_notes = find_leaks(circuit, result, lambda changed: audit(changed, **settings), [])
    result = replace(result, leaks=leaks, notes=(*result.notes, *leak_notes))
    order.report("report", 0.0, None)
    write_energy(result, order.path("-energy.html"), circuit)
    return TaskResult(balance_table(result).text(), sentences(result.notes))


def audit_safety(order: TaskOrder) -> TaskResult:
    """Compute exhaust times and travels after an event, with each single fault of a valve."""
    from poppet.audit.safety import audit_safety as audit
    from poppet.report.audit.safety_report import write_safety
    from poppet.report.audit.safety_text import safety_text

    style("A report of an audit")
    result = audit(order.circuit, order.options["event"], progress=order.count("runs"))
    order.report("report", 0.0, None)
    write_safety(result, order.path("-safety.html"))
    return TaskResult(safety_text(result), sentences(result.notes))


def list_faults(order: TaskOrder) -> TaskResult:
    """Compute the consequences of every single fault of the valves."""
    from poppet.audit.fault_table import fault_table
    from poppet.report.audit.faults_report import write_faults
    from poppet.report.audit.safety_text import faults_text

    style("A report of an audit")
    result = fault_table(order.circuit, progress=order.count("runs"))
    order.report("report", 0.0, None)
    write_faults(result, order.path("-faults.html"))
    return TaskResult(faults_text(result), sentences(result.notes))


def export_circuit(order: TaskOrder) -> TaskResult:
    """Export the circuit to another program; an export of several files is a ZIP archive."""
    from poppet.deploy.targets import TARGETS, CircuitSource

    name = order.options["target"]
    if name not in TARGETS:
        near = NameSuggestion(name, TARGETS)
        raise InputError("fields.not_an_option", "target", value=name, meaning="target of an export", suggestion=near)
    target = TARGETS[name]
    known = {option.name for option in target.options}
    settings: dict[str, Any] = {key: value for key, value in order.options.items() if key != "target"}
    for key in settings.keys() - known:
        raise InputError("fields.unknown", key, table=f"export to {name}", suggestion=NameSuggestion(key, known))
    order.report("export", 0.0, None)
    export = target.make(order.circuit, CircuitSource(order.text, order.name), **settings)
    contents = {path: data if isinstance(data, bytes) else data.encode() for path, data in export.files.items()}
    if target.suffixes:
        (data,) = contents.values()
        order.path(target.suffixes[0]).write_bytes(data)
    else:
        with zipfile.ZipFile(order.path(f"-{name}.zip"), "w", zipfile.ZIP_DEFLATED) as archive:
            for path, data in contents.items():
                archive.writestr(f"{order.name}-{name}/{path}", data)
    return TaskResult(export.summary, sentences(export.notes))


def sentences(notes: Iterable[Note]) -> tuple[str, ...]:
    """Return notes as sentences; similar notes are combined."""
    return tuple(map(str, grouped(notes)))

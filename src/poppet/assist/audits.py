"""Functions for audits of a machine: energy, leaks, safety and faults."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import replace as changed
from typing import Annotated, Any

from poppet.assist.arguments import Argument
from poppet.assist.circuits import NONE, File, Result, Text, Values, load_circuit
from poppet.assist.folder import Folder
from poppet.assist.limits import TIME_LIMIT
from poppet.assist.replies import Json, note_rows, plain
from poppet.assist.simulation import Replace, TimeLimit, check_size
from poppet.assist.studies import RESULTS, ResultFile
from poppet.core.errors import InputError

FAULTS = ("stuck_open", "stuck_closed", "stuck", "slow", "leak")
"""Faults of valves."""
Kinds = Annotated[Sequence[str], Argument("faults of valves", choices=FAULTS)]
Threshold = Annotated[str, Argument("gauge pressure below which a volume is exhausted", longest=40)]


def audit_energy(
    folder: Folder,
    *,
    file: File = "",
    text: Text = "",
    set: Values = NONE,
    with_result: Result = "",
    cycle: Annotated[str, Argument('start and end of the cycle: "0.5 s, 1.9 s" (default: the last)', longest=60)] = "",
    cycle_from: Annotated[str, Argument("step of a sequence with which the cycle begins", longest=100)] = "",
    cycles: Annotated[int, Argument("number of cycles of which the mean is evaluated", low=1, high=1000)] = 1,
    duration: Annotated[str, Argument('duration of the run: "60 s" (default: that of the file)', longest=40)] = "",
    tariff: Annotated[str, Argument('price: "0.20 EUR/kWh" or, of air, "0.02 EUR/m^3"', longest=40)] = "",
    savings: Annotated[bool, Argument("simulate the default measures that save air")] = False,
    output: ResultFile = "",
    replace: Replace = False,
    time_limit: TimeLimit = TIME_LIMIT,
) -> Json:
    """Audit air, energy and exergy of one machine cycle: balance, losses and consumption of each part, leaks, cost."""
    from poppet.audit.circuit_leaks import find_leaks
    from poppet.audit.energy import audit_energy as audit
    from poppet.audit.savings import find_savings
    from poppet.audit.tariff import tariff_of

    target = folder.target(output, "output", replace, RESULTS) if output else None
    change = load_circuit(folder, file, text, set, with_result)
    circuit = change.circuit.with_values({"run.duration": duration}) if duration else change.circuit
    check_size(circuit)
    try:
        settings: dict[str, Any] = {
            "cycle": cycle or None, "step": cycle_from, "count": cycles,
            "tariff": tariff_of(circuit, {"tariff": tariff} if tariff else {}),
        }  # fmt: skip

        def run(variant: Any) -> Any:
            return audit(variant, **settings)

        result = run(circuit)
        leaks, leak_notes = find_leaks(circuit, result, run, [])
        result = changed(result, leaks=leaks, notes=(*result.notes, *leak_notes))
        if savings:
            rows, saving_notes = find_savings(circuit, result, run, None)
            result = changed(result, savings=rows, notes=(*result.notes, *saving_notes))
    except InputError as error:
        raise change.located(error) from None
    if target is not None:
        result.save(target)
    content = result.content()
    for name in ("findings", "balance", "flow_paths"):
        content.pop(name)
    totals = {
        category: {"energy_j": result.total(category, quantity="energy"), "exergy_j": result.total(category)}
        for category in dict.fromkeys(row.category for row in result.rows)
    }
    notes = note_rows([*change.notes, *result.notes])
    return plain(content | {"balance": totals, "notes": notes} | ({"output": output} if output else {}))  # type: ignore[no-any-return]


def audit_leaks(
    folder: Folder,
    *,
    file: Annotated[str, Argument("leak survey in the folder (.toml)", longest=200)],
) -> Json:
    """Compute flow and cost of the leaks in a leak survey of a plant."""
    from poppet.audit.leak_file import read_survey

    return plain(read_survey(folder.existing(file, "file", (".toml",))).content())  # type: ignore[no-any-return]


def audit_safety(
    folder: Folder,
    *,
    event: Annotated[
        Mapping[str, str | float],
        Argument('inputs and their values from the event on: {"supply.pressure": "0 bar g"}', longest=50),
    ],
    file: File = "",
    text: Text = "",
    set: Values = NONE,
    at: Annotated[
        Sequence[str], Argument('times of the event: ["0.5 s"], or ["steps"] (default: of the circuit)', longest=20)
    ] = (),
    threshold: Threshold = "0.5 bar",
    duration: Annotated[str, Argument("simulated time after the event", longest=40)] = "10 s",
    kinds: Kinds = FAULTS[:3],
    samples: Annotated[int, Argument("samples of the uncertain parameters; 0: none", low=0, high=500)] = 0,
    output: ResultFile = "",
    replace: Replace = False,
    time_limit: TimeLimit = TIME_LIMIT,
) -> Json:
    """Compute exhaust times and travels after an event, in normal operation and with each single fault of a valve."""
    from poppet.audit.safety import audit_safety as audit

    target = folder.target(output, "output", replace, RESULTS) if output else None
    change = load_circuit(folder, file, text, set)
    result = audit(
        change.circuit, event, at="steps" if list(at) == ["steps"] else list(at) or None, threshold=threshold,
        duration=duration, kinds=kinds, samples=samples,
    )  # fmt: skip
    if target is not None:
        result.save(target)
    content = result.content() | {"notes": note_rows([*change.notes, *result.notes])}
    return plain(content | ({"output": output} if output else {}))  # type: ignore[no-any-return]


def audit_faults(
    folder: Folder,
    *,
    file: File = "",
    text: Text = "",
    set: Values = NONE,
    at: Annotated[str, Argument("start of each fault", longest=40)] = "0 s",
    duration: Annotated[str, Argument("duration of each run (default: that of the file)", longest=40)] = "",
    threshold: Threshold = "0.5 bar",
    kinds: Kinds = FAULTS,
    output: ResultFile = "",
    replace: Replace = False,
    time_limit: TimeLimit = TIME_LIMIT,
) -> Json:
    """Run a circuit with each single fault of each valve, and list the consequences."""
    from poppet.audit.fault_table import fault_table

    target = folder.target(output, "output", replace, RESULTS) if output else None
    change = load_circuit(folder, file, text, set)
    circuit = change.circuit.with_values({"run.duration": duration}) if duration else change.circuit
    check_size(circuit)
    result = fault_table(circuit, kinds=kinds, start=at, threshold=threshold)
    if target is not None:
        result.save(target)
    content = result.content() | {"notes": note_rows([*change.notes, *result.notes])}
    return plain(content | ({"output": output} if output else {}))  # type: ignore[no-any-return]

"""Tasks that compute parameters: tuning of controllers, and identification from a dropped recording."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from difflib import SequenceMatcher
from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.provenance import Number
from poppet.core.units import same_dimension, stated_reference
from poppet.edit.document import Document
from poppet.edit.tasks.order import TaskOrder, TaskResult, changed_circuit, sourced, value_operations
from poppet.edit.tasks.runs import sentences
from poppet.parts.rows import GainSchedule
from poppet.timeseries.plotting.figures import style
from poppet.timeseries.tables.reading import Table, read_table

RECORDING = "recording"
"""Name of the recording in the results of a fit."""
SIMILAR = 0.6
"""Smallest similarity of the heading of a column and an address for which the column is proposed."""
TIMES = ("time", "t", "zeit", "timestamp")
"""Usual headings of the column of the time."""
_ENDINGS = {"p": "pressure", "t": "temperature", "x": "position", "v": "velocity", "q": "flow"}
"""Meaning of one-letter words in headings."""


def tune_controller(order: TaskOrder) -> TaskResult:
    """Tune the gains of a controller."""
    from poppet.control import schedule, tune
    from poppet.report.control_report import file_margin_table, margin_table, write_tuning

    style("A report of a tuning")
    circuit, options = order.circuit, dict(order.options)
    compute = schedule if options.pop("schedule", False) else tune
    order.report("gains", 0.0, None)
    tuning = compute(circuit, options.pop("controller", None), **options)
    order.report("report", 0.0, None)
    order.path("-gains.toml").write_text(tuning.text(), encoding="utf-8")
    write_tuning(tuning, circuit, order.path("-tuning.html"))
    present = circuit.numbers()
    stated = {name.partition(".")[0] for name in Document(order.text).view()["parts"][tuning.controller]["fields"]}
    operations = tuple(
        {"op": "set", "address": f"{tuning.controller}.{name}", "value": value}
        for name, value in _field_values(tuning.controller, tuning.fields(), present)
        if value is not None or name in stated
    )
    changed_circuit(order, operations)  # the circuit must be valid with the tuned fields
    text = f"{tuning.text()}\n{margin_table(tuning).text()}"
    if (margins := file_margin_table(tuning, circuit)) is not None:
        text += f"\n\nWith the present gains:\n{margins.text()}"
    return TaskResult(text, sentences((*tuning.notes, *tuning.margin_notes(circuit))), operations)


def _field_values(
    controller: str, fields: Mapping[str, Any], present: Mapping[str, Number]
) -> Iterator[tuple[str, Any]]:
    """Yield the name and the new value of each tuned field of a controller; None removes the field."""
    for name, value in fields.items():
        if isinstance(value, GainSchedule):
            columns = value.columns.items()
            yield name, {key: [sourced(number)["value"] for number in column] for key, column in columns}
        elif isinstance(value, Number):
            yield name, sourced(value, present.get(f"{controller}.{name}"))
        else:
            yield name, None


def list_columns(order: TaskOrder) -> TaskResult:
    """List the columns of a recording, and propose the quantities that they contain."""
    table = read_table(upload_path(order.uploads, order.options["recording"]))
    circuit = order.circuit
    quantities = dict(circuit.model.outputs) | {address: item.unit for address, item in circuit.inputs.items()}
    time = next((k for k, name in enumerate(table.names) if name.strip().lower() in TIMES), 0)
    proposed = propose_columns(table, quantities, time)
    columns = [
        {
            "name": name, "unit": unit, "address": proposed.get(k, ""), "is_time": k == time,
            "low": _finite(np.nanmin, column), "high": _finite(np.nanmax, column),
        }
        for k, (name, unit, column) in enumerate(zip(table.names, table.units, table.columns, strict=True))
    ]  # fmt: skip
    return TaskResult(notes=sentences(table.notes), data={"columns": columns})


def propose_columns(table: Table, quantities: Mapping[str, str], time: int) -> dict[int, str]:
    """Return a mapping from the index of a column to the address of a quantity with a similar name and the same unit.

    `quantities` maps addresses to SI units. Each quantity has at most one column: the most similar one. `time` is the
    index of the column of the time.
    """
    scores = [
        (_similarity(name, address), k, address)
        for k, (name, unit) in enumerate(zip(table.names, table.units, strict=True))
        if k != time
        for address, si in quantities.items()
        if not unit or same_dimension(unit, si)
    ]
    proposed: dict[int, str] = {}
    for score, k, address in sorted(scores, key=lambda row: -row[0]):
        if score >= SIMILAR and k not in proposed and address not in proposed.values():
            proposed[k] = address
    return proposed


def fit_parameters(order: TaskOrder) -> TaskResult:
    """Fit parameters of the circuit to a recording."""
    from poppet.identify.fit.fit_plan import offset_parameters, plan_fit, recording_parameters
    from poppet.identify.fit.identify_fit import identify_fit
    from poppet.identify.fit.search import SearchSettings
    from poppet.identify.free_parameter import read_free
    from poppet.report.identification.headline import result_summary
    from poppet.report.identification.identification_report import write_identification
    from poppet.timeseries.measurements import read_measurement

    style("A report of an identification")
    circuit = order.circuit
    measurement = read_measurement(
        RECORDING, recording_table(order), order.uploads, ambient_pressure=circuit.surroundings.pressure
    )
    with ErrorCollector() as errors:
        free = []
        for address in order.options["free"]:
            with errors.collecting():
                free.append(read_free(str(address), {}, circuit))
    circuits, roles = [circuit], ["fit"]
    free += recording_parameters([measurement], circuits, roles)
    free += offset_parameters([measurement], circuits, roles)
    title = circuit.title or order.name
    plan = plan_fit(circuits, [measurement], roles, free, settings=SearchSettings(), title=title)
    result = identify_fit(plan, progress=lambda count, _: order.report("evaluations", count, None))
    order.report("report", 0.0, None)
    result.save(order.path("-fit.toml"))
    write_identification(result, order.path("-fit.html"))
    operations = value_operations(order, {a: n for a, n in result.values().items() if a in circuit.numbers()})
    return TaskResult(result_summary(result), operations=operations)


def recording_table(order: TaskOrder) -> dict[str, Any]:
    """Return the table of a recording in a fit file: the time, the measured outputs and the inputs of the model."""
    options = order.options
    circuit = order.circuit
    outputs, inputs = dict(circuit.model.outputs), circuit.inputs
    table: dict[str, Any] = {"file": upload_path(order.uploads, options["recording"]).name, "inputs": {}, "start": {}}
    table["time"] = _column(options["time"], "time")
    for address, column in options["columns"].items():
        if address in outputs:
            table[address] = _column(column, address)
        elif address in inputs:
            table["inputs"][address] = _column(column, address)
        else:
            near = NameSuggestion(address, [*outputs, *inputs])
            raise InputError("names.unknown", address, meaning="an output or input of this circuit", suggestion=near)
    if options.get("start", "first") != "circuit":
        numbers = circuit.numbers()
        starts = {address: "{}.initial_{}".format(*address.rsplit(".", 1)) for address in table if "." in address}
        table["start"] = {start: options.get("start", "first") for start in starts.values() if start in numbers}
    return {key: value for key, value in table.items() if value != {}}


def upload_path(uploads: Path, name: str) -> Path:
    """Return the path of a dropped recording; a name that is not one of them is an error."""
    names = [path.name for path in uploads.iterdir() if not path.name.startswith(".")]
    if name not in names:
        raise InputError("names.unknown", name, meaning="a dropped recording", suggestion=NameSuggestion(name, names))
    return uploads / name


def _column(raw: Any, address: str) -> dict[str, Any]:
    """Return column and unit of a quantity; other fields, such as a file, are not accepted.

    The unit of a pressure must state gauge or absolute. Recordings of poppet, whose headings are addresses, are
    absolute.
    """
    if not isinstance(raw, Mapping) or not {"column"} <= raw.keys() <= {"column", "unit"}:
        raise InputError("edit.no_column", address, value=raw)
    unit = raw.get("unit") or "1"
    if same_dimension(unit, "Pa") and not stated_reference(unit) and raw["column"] != address:
        raise InputError("edit.no_reference", address, unit=unit)
    return {key: value for key, value in raw.items() if value != ""}


def _similarity(heading: str, address: str) -> float:
    """Return the similarity of a heading and an address, from 0 to 1.

    Examples
    --------
    >>> _similarity("tank.pressure", "tank.pressure"), _similarity("p_tank", "tank.pressure") > SIMILAR
    (1.0, True)
    """
    if heading.strip().lower() == address.lower():
        return 1.0
    first, second = _words(heading), _words(address)
    common = first & second
    share = len(common) / max(len(first), len(second), 1)
    ratio = SequenceMatcher(None, " ".join(sorted(first)), " ".join(sorted(second))).ratio()
    return 0.99 * max(share, ratio)


def _words(name: str) -> set[str]:
    words = "".join(letter if letter.isalnum() else " " for letter in name.lower()).split()
    return {_ENDINGS.get(word, word) for word in words}


def _finite(compute: Any, column: Any) -> float | None:
    return float(compute(column)) if np.isfinite(column).any() else None

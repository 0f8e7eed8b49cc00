"""Application of parameters from a file to a circuit: identification results or controller gains."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.toml_file import TomlFile
from poppet.identify.result import Result, read_result
from poppet.parts import Muscle
from poppet.parts.muscle_law import REQUIRED, MuscleLawPart

UNTRUSTED = ("not determined", "at bound")
"""Verdicts of unreliable estimates."""


def with_numbers(circuit: BaseCircuit, path: str | Path) -> tuple[BaseCircuit, list[str]]:
    """Return a circuit with the parameter values from a result file, and a list of unreliable estimates.

    Parameters
    ----------
    circuit : Circuit
        Circuit before the change.
    path : str or Path
        Result of an identification (`.toml`, `.json`), or a TOML file with fields of parts as in a circuit file,
        `[parts.regulator]`. The result of a muscle also sets its law, size and limits. A field removes the fields that
        conflict with it: a gain removes a schedule.

    Returns
    -------
    Circuit
        Circuit with the values of the file.
    list of str
        Address and verdict of each unreliable parameter.

    Raises
    ------
    InputError
        If the file has another format, or if it does not match the parts of the circuit.
    """
    file = TomlFile.read(path)
    if Path(path).suffix.lower() != ".toml" or "parts" not in file.tables:
        result = read_result(path)
        doubtful = [f"{name} ({e.verdict})" for name, e in result.parameters.items() if e.verdict in UNTRUSTED]
        return circuit.with_values(_muscle_fields(circuit, result) or result.values()), doubtful
    with file.errors() as errors:
        for key in file.content:
            if key != "parts":
                errors.add("fields.unknown", key, table="parameter file", suggestion=NameSuggestion(key, ("parts",)))
        parts = file.content["parts"]
        tables = parts if isinstance(parts, Mapping) else {"": parts}
        for name, table in tables.items():
            if not isinstance(table, Mapping):
                errors.add("circuit.no_part", f"parts.{name}", value=table)
    values: dict[str, Any] = {}
    for name, fields in tables.items():
        part = circuit.parts.get(name)
        replaced_fields = part.replaced_fields(fields) if part else ()
        values |= {f"{name}.{key}": None for key in replaced_fields} | {f"{name}.{k}": v for k, v in fields.items()}
    try:
        return circuit.with_values(values), []
    except InputError as error:
        for problem in error.problems:
            problem.located(file=file.name, line=file.line_of(f"parts.{problem.address}"))
        raise


def change_circuit(
    circuit: BaseCircuit, values: Mapping[str, Any], result: str | Path | None = None
) -> tuple[BaseCircuit, list[Note]]:
    """Return a copy of a circuit with other values, and notes on the changes.

    The estimates in the result file `result` are applied first, then `values` by address. The notes are about
    unreliable estimates, and about signals that were removed because they drove an input in `values`.
    """
    notes = []
    if result is not None:
        circuit, doubtful = with_numbers(circuit, result)
        notes += [Note("cli.not_trusted", file=str(result), names=doubtful)] if doubtful else []
    circuit = circuit.with_values(values) if values else circuit
    dropped = [address for address in values if address in circuit.signals]
    # The value is the default of an input: it would have no effect while a signal drives the input.
    if dropped:
        circuit = replace(circuit, signals={k: v for k, v in circuit.signals.items() if k not in dropped})
    return circuit, notes + [Note("cli.signal_left_out", address, value=values[address]) for address in dropped]


def _muscle_fields(circuit: BaseCircuit, result: Result) -> dict[str, Any]:
    """Return the fields of a muscle part that describe a fitted muscle: law, parameters and size.

    The keys are the addresses of the fields. The fields are empty if the identification is not that of a muscle.
    """
    law, values = result.comparison.get("law"), result.values()
    name = next(iter(values), "").partition(".")[0]
    muscles = {name: part for name, part in circuit.parts.items() if isinstance(part, MuscleLawPart)}
    if result.method != "muscle" or law not in REQUIRED or name in REQUIRED.values() or not muscles:
        return {}
    if name not in muscles:
        raise InputError("muscle.not_here", name, known=[*muscles])
    fields_by_name = {address.removeprefix(f"{name}."): number for address, number in values.items()}
    conditions = result.conditions
    fields: dict[str, Any] = {"law": law, **{key: conditions[key] for key in ("nominal_length", "nominal_diameter")}}
    if law == "table":
        columns = {
            column: [number for key, number in fields_by_name.items() if key.startswith(f"force_table.{column}_")]
            for column in ("force_per_pressure", "passive_force")
        }
        fields["force_table"] = {"contraction": conditions["rows_of_contraction"], **columns}
    elif law == "sarosi":
        fields["sarosi"] = {key.removeprefix("sarosi."): number for key, number in fields_by_name.items()}
    else:
        fields |= fields_by_name
    if isinstance(muscles[name], Muscle):  # where the map was measured
        fields = {"data": None, "sarosi": None, "force_table": None, **fields}
        (shortest, longest), (low, high) = (
            conditions["contraction"],
            (f"{1e-5 * pressure:.6g} bar g" for pressure in conditions["gauge_pressure"]),
        )
        fields["limits"] = {
            "lowest_contraction": shortest, "highest_contraction": longest, "highest_force": conditions["force"][1],
            "lowest_pressure": low, "highest_pressure": high,
        }  # fmt: skip
    return {f"{name}.{key}": value for key, value in fields.items()}

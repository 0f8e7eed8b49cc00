"""Numbers of a file laid over a circuit: what `poppet identify` found, or gains of `poppet control tune`."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from poppet.circuit.circuit import Circuit
from poppet.ground.errors import InputError, Near
from poppet.ground.toml_file import TomlFile
from poppet.identify.result import read_result

UNTRUSTED = ("not determined", "at bound")
"""Verdicts of an identification that a user of its numbers is reminded of."""


def with_numbers(circuit: Circuit, path: str | Path) -> tuple[Circuit, list[str]]:
    """A circuit with the numbers of a file, and which of them are not to be trusted.

    Parameters
    ----------
    circuit : Circuit
        That is changed; this one stays as it is.
    path : str or Path
        A result of an identification (`.toml`, `.json`), or a TOML file with fields of parts as a circuit file has
        them, `[parts.regulator]`. What cannot stay beside such a field goes: a schedule where a gain comes.

    Returns
    -------
    Circuit
        A new one.
    list of str
        Address and verdict of numbers that the recordings did not determine.

    Raises
    ------
    InputError
        If the file is neither, or what it says fits no part of this circuit.
    """
    file = TomlFile.read(path)
    is_of_parts = Path(path).suffix.lower() == ".toml" and "parts" in file.tables
    if is_of_parts:
        return _with_fields(circuit, file), []
    result = read_result(path)
    doubtful = [f"{name} ({e.verdict})" for name, e in result.parameters.items() if e.verdict in UNTRUSTED]
    return circuit.with_values(result.values()), doubtful


def _with_fields(circuit: Circuit, file: TomlFile) -> Circuit:
    with file.mistakes() as mistakes:
        content = file.content
        mistakes.take(
            InputError("circuit.unknown_table", key, near=Near(key, ("parts",))) for key in content if key != "parts"
        )
        tables = content["parts"] if isinstance(content["parts"], Mapping) else {"": content["parts"]}
        mistakes.take(
            InputError("circuit.no_part", f"parts.{name}", value=table)
            for name, table in tables.items()
            if not isinstance(table, Mapping)
        )
    values: dict[str, Any] = {}
    for name, fields in tables.items():
        part = circuit.parts.get(name)
        gone = part.giving_way(fields) if part else ()
        values |= {f"{name}.{field}": None for field in gone} | {f"{name}.{key}": v for key, v in fields.items()}
    try:
        return circuit.with_values(values)
    except InputError as error:
        for problem in error.problems:
            problem.located(file=file.name, line=file.line_of(f"parts.{problem.address}"))
        raise

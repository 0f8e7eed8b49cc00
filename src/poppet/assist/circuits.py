"""Circuits of the functions: reading with the restrictions for assistants, check and parameters."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from types import MappingProxyType
from typing import Annotated, Any

from poppet.assist.arguments import Argument
from poppet.assist.folder import Folder
from poppet.assist.limits import LIST_ROWS
from poppet.assist.replies import Json, note_rows, quantity
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError

File = Annotated[str, Argument("name of the circuit file in the folder, such as plant.toml; or use `text`")]
Text = Annotated[str, Argument("content of a circuit file in TOML, instead of `file`")]
Values = Annotated[
    Mapping[str, str | float],
    Argument('parameters and options to change first: {"tank.volume": "20 l"}; a number without unit is SI'),
]
Result = Annotated[str, Argument("result file of `identify` in the folder, whose parameters are applied before `set`")]

NONE: Mapping[str, str | float] = MappingProxyType({})
"""Default of tables of values."""
NATIVE = ("fmu",)
"""Kinds of parts that execute native code of the user."""


@dataclass(frozen=True)
class CircuitChange:
    """Circuit with the values of a call, and the notes on these changes."""

    circuit: Any
    notes: tuple[Note, ...]
    source: Any  # TomlFile

    def located(self, error: InputError) -> InputError:
        """Return an error with the lines of the circuit file."""
        located: InputError = self.source.located(error)
        return located


def read_source(folder: Folder, file: str, text: str) -> Any:
    """Return the content of a circuit file of the folder, or of a text, after a check of its kinds of parts."""
    from poppet.core.toml_file import TomlFile

    if bool(file) == bool(text.strip()):
        raise InputError("assist.one_circuit", "file")
    # An error of the text has no file.
    source = TomlFile(folder.read(file, "file") if file else text, file, folder.path)
    try:
        _check_native(source)
    except InputError as error:  # invalid syntax has no address
        raise error.located(address=file or "text") from None
    return source


def _check_native(source: Any) -> None:
    """Raise errors for parts that would execute native code."""
    parts = source.content.get("parts")
    with ErrorCollector() as errors:
        for name, table in parts.items() if isinstance(parts, Mapping) else ():
            if isinstance(table, Mapping) and table.get("kind") in NATIVE:
                line = source.line_of(f"parts.{name}")
                errors.extend([InputError("assist.native", f"parts.{name}", kind=table["kind"], line=line)])


def load_circuit(
    folder: Folder, file: str, text: str, values: Mapping[str, Any] | None = None, result: str = ""
) -> CircuitChange:
    """Return the circuit of a file or a text with changed values."""
    from poppet.api import Circuit
    from poppet.circuit.file import read_circuit
    from poppet.identify.parameter_file import change_circuit

    source = read_source(folder, file, text)
    circuit = read_circuit(source, Circuit)
    path = folder.existing(result, "with_result", (".toml", ".json")) if result else None
    changed, notes = change_circuit(circuit, values or {}, path)
    return CircuitChange(changed, tuple(notes), source)


def check(folder: Folder, file: File = "", text: Text = "") -> Json:
    """Check a circuit without a simulation: all errors with code, address, line and hint; otherwise its contents.

    The contents are parts, inputs, outputs with SI units, and notes on assumptions.
    """
    from poppet.serve.file_check import check_file

    change = load_circuit(folder, file, text)
    try:
        result = check_file(change.circuit)
    except InputError as error:
        raise change.located(error) from None
    circuit = change.circuit
    driven = dict.fromkeys(circuit.signals, "signal") | dict(circuit.connections)
    inputs = {address: {"unit": item.unit} for address, item in circuit.inputs.items()}
    for address, row in inputs.items():
        row["driven_by"] = str(driven.get(address, ""))
    return {
        "is_valid": True,
        "title": circuit.title,
        "counts": {name.replace(" ", "_") + "s": count for name, count in result.counts().items()},
        "parts": dict(_first({name: part.kind for name, part in circuit.parts.items()})),
        "inputs": dict(_first(inputs)),
        "outputs": dict(_first(result.outputs)),
        "notes": note_rows(result.notes),
    }


def parameters(
    folder: Folder,
    file: File = "",
    text: Text = "",
    set: Values = NONE,
    part: Annotated[str, Argument("name of a part, whose parameters are listed; empty for all")] = "",
    source: Annotated[str, Argument("kind of source, such as assumed or datasheet; empty for all")] = "",
) -> Json:
    """List the parameters of a circuit by address, with value, SI value and source; assumed ones are guesses."""
    from poppet.core.provenance import LEAST_CERTAIN_FIRST

    circuit = load_circuit(folder, file, text, set).circuit
    ambient = circuit.surroundings.pressure
    rows = {
        address: {
            "written": number.display(),
            **quantity(number.absolute(ambient), number.unit),
            "source": number.source.kind,
            "locator": "; ".join(filter(None, (number.source.locator, number.source.note))),
        }
        for address, number in circuit.numbers().items()
        if (not part or address.partition(".")[0] == part) and (not source or number.source.kind == source)
    }
    rows = dict(sorted(rows.items(), key=lambda row: LEAST_CERTAIN_FIRST.index(row[1]["source"])))
    return {"title": circuit.title, "count": len(rows), "parameters": dict(_first(rows))}


def _first(rows: Mapping[str, Any], limit: int = 3 * LIST_ROWS) -> list[tuple[str, Any]]:
    """Return the first rows of a long table."""
    return list(rows.items())[:limit]

"""The circuit file that an FMU carries, so that it can be held beside Python by whoever has nothing else."""

from __future__ import annotations

import json
import tempfile
import tomllib
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.core.errors import InputError

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

CIRCUIT, CHANGES, NUMBERS = "resources/circuit.toml", "resources/changes.toml", "resources/numbers"


def origin(text: str, values: Mapping[str, float | str], numbers: str | None = None) -> dict[str, bytes]:
    """Resources of an FMU: a circuit file, and what was changed in it before the export, by a file of numbers first."""
    # Strings and numbers of JSON are strings and numbers of TOML.
    changes = "".join(f"{json.dumps(address)} = {json.dumps(value)}\n" for address, value in values.items())
    found = {CIRCUIT: text.encode()} | ({CHANGES: changes.encode()} if changes else {})
    return found | ({f"{NUMBERS}{Path(numbers).suffix}": Path(numbers).read_bytes()} if numbers else {})


def circuit_of(path: Path) -> Circuit:
    """The circuit that an FMU carries.

    Raises
    ------
    InputError
        Where it carries none, or one that needs files which are not there.
    """
    from poppet.circuit.file import loads
    from poppet.identify.parameter_file import with_numbers

    with zipfile.ZipFile(path) as archive:
        names = set(archive.namelist())
        if CIRCUIT not in names:
            raise InputError("deploy.fmu.no_circuit", name=path.name)
        text = archive.read(CIRCUIT).decode()
        changes = tomllib.loads(archive.read(CHANGES).decode()) if CHANGES in names else {}
        circuit = loads(text, name=path.name, folder=path.parent)
        for name in {f"{NUMBERS}.toml", f"{NUMBERS}.json"} & names:
            with tempfile.TemporaryDirectory() as folder:
                circuit, _ = with_numbers(circuit, archive.extract(name, folder))
    return circuit.with_values(changes)

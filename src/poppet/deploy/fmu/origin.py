"""The circuit file that an FMU carries, so that it can be held beside Python by whoever has nothing else."""

from __future__ import annotations

import json
import tomllib
import zipfile
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.ground.errors import InputError

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

CIRCUIT, CHANGES = "resources/circuit.toml", "resources/changes.toml"


def origin(text: str, values: Mapping[str, float | str]) -> dict[str, bytes]:
    """Resources of an FMU: a circuit file, and what was changed in it before the export."""
    # Strings and numbers of JSON are strings and numbers of TOML.
    changes = "".join(f"{json.dumps(address)} = {json.dumps(value)}\n" for address, value in values.items())
    return {CIRCUIT: text.encode(), **({CHANGES: changes.encode()} if changes else {})}


def circuit_of(path: Path) -> Circuit:
    """The circuit that an FMU carries.

    Raises
    ------
    InputError
        Where it carries none, or one that needs files which are not there.
    """
    from poppet.circuit.file import loads

    with zipfile.ZipFile(path) as archive:
        names = set(archive.namelist())
        if CIRCUIT not in names:
            raise InputError("deploy.fmu.no_circuit", name=path.name)
        text = archive.read(CIRCUIT).decode()
        changes = tomllib.loads(archive.read(CHANGES).decode()) if CHANGES in names else {}
    return loads(text, name=path.name, folder=path.parent).with_values(changes)

"""Functions that assistants call, by name."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from poppet.assist import audits, catalogue, circuits, files, kinds, simulation, studies
from poppet.assist.arguments import arguments_schema, declared_arguments
from poppet.assist.folder import Folder
from poppet.assist.replies import Json
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.files import confined_to


@dataclass(frozen=True)
class Function:
    """Function that an assistant calls.

    A quick function runs in the server, any other one in a process that can be killed.
    """

    run: Callable[..., Json]
    is_quick: bool = False
    writes: bool = False  # True if it can write files
    is_partial: bool = False  # True if it returns a partial result at its time limit

    @property
    def summary(self) -> str:
        """Description of the function, from its docstring."""
        return " ".join((self.run.__doc__ or "").split())

    @property
    def schema(self) -> dict[str, Any]:
        """JSON schema of the arguments."""
        return arguments_schema(self.run)

    @property
    def has_time_limit(self) -> bool:
        """True if a call can state a time limit."""
        return any(argument.name == "time_limit" for argument in declared_arguments(self.run))


FUNCTIONS: Mapping[str, Function] = {
    "check": Function(circuits.check),
    "parameters": Function(circuits.parameters),
    "simulate": Function(simulation.simulate, writes=True, is_partial=True),
    "identify": Function(studies.identify, writes=True),
    "size": Function(studies.size, writes=True),
    "ensemble": Function(studies.ensemble),
    "audit_energy": Function(audits.audit_energy, writes=True),
    "audit_leaks": Function(audits.audit_leaks),
    "audit_safety": Function(audits.audit_safety, writes=True),
    "audit_faults": Function(audits.audit_faults, writes=True),
    "explain": Function(kinds.explain, is_quick=True),
    "list_kinds": Function(kinds.list_kinds, is_quick=True),
    "describe_kind": Function(kinds.describe_kind, is_quick=True),
    "find_components": Function(catalogue.find_components, is_quick=True),
    "list_files": Function(files.list_files, is_quick=True),
    "read_file": Function(files.read_file, is_quick=True),
    "write_file": Function(files.write_file, is_quick=True, writes=True),
}


def find_function(name: Any) -> Function:
    """Return a function by its name."""
    if not isinstance(name, str) or name not in FUNCTIONS:
        suggestion = NameSuggestion(str(name)[:100], FUNCTIONS)
        raise InputError("names.unknown", str(name)[:100], meaning="a function", suggestion=suggestion)
    return FUNCTIONS[name]


def perform(folder: Folder, function: Function, arguments: Mapping[str, Any], *further: Path) -> Json:
    """Call a function with checked arguments; all its file access is confined to the folder and `further` ones."""
    with confined_to(folder.path, *further):
        return function.run(folder, **arguments)

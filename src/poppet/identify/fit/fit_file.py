"""Reader of fit files, which describe recordings, free parameters and settings of a fit."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.file import load
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, relocated
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.identify.fit.fit_plan import ROLES, FitPlan, plan_fit, recording_parameters
from poppet.identify.fit.search import SearchSettings
from poppet.identify.free_parameter import FreeParameter, read_free
from poppet.timeseries.measurements import Measurement, read_measurement

SEARCH = ("loss", "starts", "seed", "kicks")
TOP_LEVEL = {
    "circuit": Field(is_required=True, meaning="circuit file", example='circuit = "bench.toml"'),
    "recordings": Field(
        type="table",
        is_required=True,
        meaning="list of recordings",
        example="[recordings.NAME] with file, time and channels",
    ),
    "free": Field(
        type="table", is_required=True, meaning="list of free parameters", example='[free] with "part.parameter" = 0.3'
    ),
    "set": Field(type="table"),
    "title": Field(type="text"),
    **dict.fromkeys(SEARCH, Field()),
}


def read_fit_file(path: str | Path) -> FitPlan:
    """Read a fit file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see `docs/identify.md`.

    Returns
    -------
    FitPlan
        Checked plan; nothing is fitted.

    Raises
    ------
    InputErrors
        With all errors, each with its line if available.
    """
    file = TomlFile.read(path, "recordings")
    with file.errors():
        return _read_plan(file)


def _read_plan(file: TomlFile) -> FitPlan:
    # The required tables come first: all others are read with them.
    with ErrorCollector() as errors:
        data = read_fields(errors, file.content, TOP_LEVEL, table="fit file")
    circuit = read_circuit(data, file.folder)
    settings, tables = _search(data)
    measurements, roles = _measurements(data["recordings"], file.folder, circuit)
    free: list[FreeParameter] = []
    with ErrorCollector() as errors:
        for address, table in tables.items():
            with errors.collecting():
                free.append(read_free(address, table, circuit))
    circuits = [circuit] * len(roles)
    free += recording_parameters(measurements, circuits, roles)
    title = str(data.get("title", circuit.title or Path(file.name).stem))
    return plan_fit(circuits, measurements, roles, free, settings=settings, title=title)


def read_circuit(data: Mapping[str, Any], folder: Path) -> BaseCircuit:
    """Return the circuit that a file refers to, with the changed values of the table `set`.

    Errors refer to the location in that file.
    """
    try:
        circuit = load(folder / str(data["circuit"]))
    except InputError as error:
        raise relocated(error, lambda _: "circuit") from None
    try:
        return circuit.with_values(data.get("set", {}))
    except InputError as error:
        raise relocated(error, "set.{}".format) from None


def _search(data: Mapping[str, Any]) -> tuple[SearchSettings, dict[str, Any]]:
    """Return the search settings, and the tables of the free parameters without these settings.

    The settings can be in both tables, but must agree.
    """
    parameters = {k: dict(v) if isinstance(v, Mapping) else v for k, v in data["free"].items() if k not in SEARCH}
    tables = {"": data, "free.": data["free"]} | {f"free.{k}.": v for k, v in parameters.items() if isinstance(v, dict)}
    settings: dict[str, tuple[Any, str]] = {}
    for prefix, table in tables.items():
        for key in SEARCH:
            if key not in table:
                continue
            value, first = settings.setdefault(key, (table[key], f"{prefix}{key}"))
            if value != table[key]:
                raise InputError("fit.two_searches", f"{prefix}{key}", value=table[key], first=first, other=value)
    for table in parameters.values():
        for key in SEARCH if isinstance(table, dict) else ():
            table.pop(key, None)
    try:
        return SearchSettings(**{key: value for key, (value, _) in settings.items()}), parameters
    except InputError as error:
        raise relocated(error, lambda key: settings[key][1]) from None


def _measurements(tables: Mapping[str, Any], folder: Path, circuit: BaseCircuit) -> tuple[list[Measurement], list[str]]:
    """Return the recordings, and the role of each (fit or validation)."""
    measurements, roles = [], []
    with ErrorCollector() as errors:
        for name, table in tables.items():
            fields = dict(table) if isinstance(table, Mapping) else table
            role = fields.pop("use", ROLES[0]) if isinstance(fields, dict) else ROLES[0]
            if role not in ROLES:
                near, address = NameSuggestion(str(role), ROLES), f"recordings.{name}.use"
                errors.add("fields.not_an_option", address, value=role, meaning="use", near=near)
            with errors.collecting():
                ambient = circuit.surroundings.pressure
                measurements.append(
                    read_measurement(name, fields, folder, ambient_pressure=ambient, other_fields=("use",))
                )
                roles.append(role)
    return measurements, roles

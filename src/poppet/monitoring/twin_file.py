"""Twin file of a running plant: circuit, sensors, faults, nuisances and baseline, as a plan."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from poppet.core.errors import ErrorCollector, InputError
from poppet.core.tables import Field, read_fields, table_schema
from poppet.core.toml_file import TomlFile
from poppet.core.units import convert
from poppet.identify.fit.fit_plan import read_circuit
from poppet.monitoring.plan import DIRECTIONS, SETTINGS, WatchPlan, read_plan

TOP_LEVEL = {
    "title": Field(type="text", meaning="title of the report"),
    "circuit": Field(type="string", is_required=True, meaning="circuit file", example='circuit = "plant.toml"'),
    "set": Field(type="table", meaning="values that replace those of the circuit file, by address"),
    "baseline": Field(
        type="string",
        is_required=True,
        meaning="baseline file",
        example='baseline = "healthy.toml"',
    ),
    "time": Field(default="time", meaning="column of the time"),
    "measured": Field(
        type="table",
        is_required=True,
        meaning="table of the measured quantities",
        example='[measured] with "tank.pressure" = { column = "p", unit = "bar g", noise = "5 mbar" }',
    ),
    "faults": Field(
        type="table",
        is_required=True,
        meaning="table of the faults",
        example='[faults] with NAME = { address = "...", alarm = "..." }',
    ),
    "nuisance": Field(type="table", meaning="parameters that vary without being a fault, by address"),
    "watch": Field(type="table", meaning="settings"),
}
"""Fields of a twin file."""
CLOCK = {
    "column": Field(type="string", default="time", meaning="name of the column or key of the time"),
    "unit": Field(type="string", default="s", meaning="unit of the time"),
}
"""Fields of the table `time`."""


@dataclass(frozen=True)
class ClockColumn:
    """Column of the time in recordings and streams.

    Parameters
    ----------
    column : str
        Name of the column, or key of the samples.
    unit : str
        Unit of the times.
    scale : float
        Factor that converts a time to seconds.
    """

    column: str = "time"
    unit: str = "s"
    scale: float = 1.0


@dataclass(frozen=True, eq=False)
class Twin:
    """Content of a twin file.

    Parameters
    ----------
    plan : WatchPlan
        Sensors, faults, nuisances and settings, checked with the circuit.
    clock : ClockColumn
        Column of the time.
    baseline : Path
        File of the baseline, which may not exist yet.
    name : str
        Name of the twin file.
    title : str
        Title of the report.
    """

    plan: WatchPlan
    clock: ClockColumn
    baseline: Path
    name: str
    title: str


def read_twin_file(path: str | Path) -> Twin:
    """Read a twin file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see `docs/watch.md`.

    Returns
    -------
    Twin
        Checked content. The baseline is not read.

    Raises
    ------
    InputErrors
        If the file is invalid. The exception contains all errors, each with its line if available.
    """
    file = TomlFile.read(path, "faults")
    with file.errors() as errors:
        data = read_fields(errors, file.content, TOP_LEVEL, table="twin file")
        clock = read_clock(errors, data["time"])
        if "circuit" in data:
            with errors.collecting():
                circuit = read_circuit(data, file.folder)
                if {"measured", "faults"} <= data.keys():
                    plan = read_plan(circuit, data["measured"], data["faults"], data.get("nuisance"), data.get("watch"))
    title = str(data.get("title", circuit.title or Path(file.name).stem))
    return Twin(plan, clock, file.folder / data["baseline"], file.name, title)


def read_clock(errors: ErrorCollector, raw: Any) -> ClockColumn:
    """Read the field `time`: the name of the column, or a table with the fields of `CLOCK`."""
    read = read_fields(errors, {"column": raw} if isinstance(raw, str) else raw, CLOCK, "time", table="time column")
    with errors.collecting():
        try:
            return ClockColumn(read["column"], read["unit"], convert(1.0, read["unit"], "s"))
        except InputError as error:
            raise error.at("time.unit") from None
        except KeyError:  # reported by the reader of the fields
            pass
    return ClockColumn()


def twin_schema() -> dict[str, Any]:
    """Return the JSON schema of twin files."""
    difference = {"type": ["number", "string"]}
    sensor = {"column": {"type": "string"}, "unit": {"type": "string"}, "noise": difference, "offset": difference}
    tables = {
        "measured": {**sensor, "gate": {"type": "number"}, "hold": {"type": "boolean"}},
        "faults": {"address": {"type": "string"}, "alarm": difference, "direction": {"enum": list(DIRECTIONS)}},
        "nuisance": dict.fromkeys(("sigma", "drift"), difference)
        | {key: {"type": "number", "exclusiveMinimum": 0} for key in ("relative_sigma", "relative_drift")},
    }
    schema = table_schema(TOP_LEVEL)
    for name, fields in tables.items():
        entry = {"type": "object", "properties": fields, "additionalProperties": False}
        schema["properties"][name]["additionalProperties"] = entry
    schema["properties"]["faults"]["additionalProperties"]["required"] = ["address", "alarm"]
    schema["properties"]["time"] = {"anyOf": [{"type": "string"}, table_schema(CLOCK)]}
    schema["properties"]["watch"] = table_schema(SETTINGS)
    return {"$schema": "https://json-schema.org/draft/2020-12/schema", "title": "poppet watch"} | schema

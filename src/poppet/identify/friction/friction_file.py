"""Reader of files with measured friction: columns of time, position or velocity, force and pressure."""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import Kind, quantity
from poppet.identify.data_file import FILE_FIELDS, channel_field, open_table, read_ambient, read_column
from poppet.identify.friction.records import ON_LINE, TURNING, Coordinate, FrictionRecord

if TYPE_CHECKING:
    from poppet.timeseries.tables.reading import Table

PRESSURES = ("pressure", "counter_pressure")
COLUMNS = ("time", "position", "velocity", "force", "torque", *PRESSURES)
TOP_LEVEL = {
    **FILE_FIELDS,
    **dict.fromkeys(("cylinder", "law"), Field(type="text")),
    "within": Field(),
    **{name: channel_field(name) for name in COLUMNS},
    **dict.fromkeys(("bore", "rod_diameter", "pulley_radius"), Field(unit="m")),
    "area": Field(unit="m^2"),
    "direction": Field(unit="1", default=1.0),
    "mass": Field(unit="kg"),
    "inertia": Field(unit="kg m^2"),
    "offset": Field(),
    "smoothing": Field(unit="s"),
    "skip": Field(unit="s", default=0.0),
    "until": Field(unit="s", default=math.inf),
}
_FORCE = Field(
    type="table",
    is_required=True,
    meaning="force or torque",
    example='force = { column = "F", unit = "N" }, or torque = { column = "M", unit = "N m" }',
)
CHANNEL_FIELDS = ("column", "value", "unit", "uncertainty")
OPTIONS = ("title", "within", "smoothing", "mass", "inertia", "pulley_radius", "offset", "cylinder", "law", "part")


def read_friction_file(path: str | Path) -> tuple[list[FrictionRecord], dict[str, Any]]:
    """Read a file that names tables or recordings of friction.

    Parameters
    ----------
    path : str or Path
        A TOML file as in the example.

    Returns
    -------
    records : list of FrictionRecord
        In SI units, in the order of the file.
    options : dict
        The keywords of `identify_friction`.

    Raises
    ------
    InputErrors
        All errors of the file, each with its line.

    Notes
    -----
    `file` is a table that `poppet` reads, or a list of tables, relative to the file. Each channel names a `column`; it
    needs a `unit` if the heading has none. A pressure can also be a `value`, or a list with one value for each file.
    Positive forces act towards larger positions. With a `bore` or an `area`, the force of the pressure is subtracted;
    it acts towards larger positions if `direction` is 1.

    A file with a `torque` instead of a force describes a joint. Its positions are angles, `inertia` replaces the mass,
    and a pressure acts at a `pulley_radius`.

    Examples
    --------
    >>> import tempfile
    >>> text = '''
    ... file = "points.csv"
    ... velocity = { column = "v", unit = "mm/s" }
    ... force = { column = "F", unit = "N" }
    ... pressure = { value = "3 bar g" }
    ... '''
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = (Path(folder) / "points.csv").write_text("v,F\\n10,5\\n20,6\\n40,8\\n")
    ...     _ = (Path(folder) / "friction.toml").write_text(text)
    ...     (record,), options = read_friction_file(Path(folder) / "friction.toml")
    >>> record.velocity.tolist(), record.pressure.round().tolist(), options["title"]
    ([0.01, 0.02, 0.04], [300000.0, 300000.0, 300000.0], 'friction')
    """
    file = TomlFile.read(path, "force")
    with file.errors():
        content = file.content
        coordinate = TURNING if "torque" in content else ON_LINE
        opposite = coordinate.opposite
        with ErrorCollector() as errors:
            offset = {"offset": Field(unit=coordinate.effort_unit, choices=("free",))}
            force = {} if coordinate is TURNING else {"force": _FORCE}
            fields = read_fields(errors, content, TOP_LEVEL | offset | force, table="friction file")
            if "force" in content and "torque" in content:
                errors.add("friction.force_and_torque", "torque")
            for name in (opposite.inertia, *["pulley_radius"] * (coordinate is ON_LINE)):
                if name in content:
                    facts = {"body": opposite.body, "effort": coordinate.effort, "other": coordinate.body}
                    errors.add("friction.of_other_body", name, **facts)
            if coordinate is TURNING and "pressure" in content and "pulley_radius" not in content:
                errors.add("friction.no_radius", "pulley_radius")
            if "velocity" not in fields and not {"position", "time"} <= fields.keys():
                errors.add("friction.no_velocity", "velocity")
            if "bore" in fields and "area" in fields:
                errors.add("friction.bore_or_area", "area")
            if abs(fields.get("direction", 1.0)) != 1.0:
                errors.add("bodies.direction", "direction", value=fields["direction"])
            if "within" in fields:
                with errors.collecting():
                    is_pair = isinstance(fields["within"], list) and len(fields["within"]) == 2
                    ends = fields["within"] if is_pair else (0.0, 0.0)
                    low, high = (quantity(end, coordinate.length, name="within").value for end in ends)
                    if not low < high:
                        raise InputError("friction.within", "within", value=fields["within"])
                    fields["within"] = low, high
            files = fields.get("file", "")
            fields["file"] = files if isinstance(files, list) else [files]
            ambient_pressure = 0.0
            with errors.collecting():
                ambient_pressure = read_ambient(fields)
            fields["ambient_pressure"] = ambient_pressure
            fields |= {
                channel: _read_channel(errors, channel, fields, coordinate) for channel in COLUMNS if channel in fields
            }
        records, notes = [], list[Note]()
        with ErrorCollector() as errors:
            for index, name in enumerate(fields["file"]):
                with errors.collecting():
                    table = open_table(file.folder, name, fields)
                    notes += table.notes
                    records.append(_read_record(table, index, fields, coordinate, Path(str(name)).stem))
    options = {name: fields[name] for name in OPTIONS if name in fields}
    return records, {"title": Path(file.name).stem, "within": None} | options | {"notes": tuple(notes)}


def _read_channel(
    errors: ErrorCollector, channel: str, file_fields: Mapping[str, Any], coordinate: Coordinate
) -> dict[str, Any]:
    """Read and check the table of one channel.

    `channel` is the name of the channel, and `file_fields` contains all fields of the file, including the tables of the
    channels. `coordinate` is the kind of motion, translation or rotation. In the result, constant pressures are gauge
    pressures in SI units.
    """
    raw, n_files = file_fields[channel], len(file_fields["file"])
    declared = {"column": Field(is_required=True, example=f'{channel} = {{ column = "..." }}'), "unit": Field()}
    if channel in PRESSURES:
        declared |= dict.fromkeys(("column", "value"), Field())
    if channel == coordinate.effort:
        declared["uncertainty"] = Field(unit=coordinate.effort_unit)
    fields = read_fields(errors, raw, declared, channel, table="channel")
    if channel in PRESSURES and ("column" in raw) == ("value" in raw):
        errors.add("friction.column_or_value", channel)
    if "unit" in fields:
        _has_valid_unit(errors, channel, str(fields["unit"]), coordinate)
    if "value" in fields:
        values = fields["value"] if isinstance(fields["value"], list) else [fields["value"]] * n_files
        if len(values) != n_files:
            errors.add("friction.values", f"{channel}.value", count=len(values), files=n_files)
        with errors.collecting():
            pressures = [quantity(value, "Pa", kind="pressure", name=f"{channel}.value") for value in values]
            ambient_pressure = file_fields["ambient_pressure"]
            fields["value"] = [p.value - (0.0 if p.reference == "gauge" else ambient_pressure) for p in pressures]
    return fields


def _has_valid_unit(errors: ErrorCollector, channel: str, unit: str, coordinate: Coordinate) -> bool:
    """Return True if the unit of a channel fits the kind of motion.

    Otherwise, an error is added to `errors`. A rotation has the units of torque and angle.
    """
    opposite = coordinate.opposite
    with suppress(InputError):  # `read_column` reports an unknown unit
        if channel in ("position", "velocity", coordinate.effort) and opposite.accepts_unit(
            unit, opposite.effort if channel == coordinate.effort else channel
        ):
            errors.add("friction.mixture", channel, unit=unit, effort=coordinate.effort)
            return False
    return True


def _read_record(
    table: Table, index: int, fields: Mapping[str, Any], coordinate: Coordinate, name: str
) -> FrictionRecord:
    """Read one table of sliding friction or one recording of a moved body, in SI units.

    Samples before `skip` and after `until` are omitted. `index` is the index of the file, and `coordinate` the kind of
    motion.
    """
    units = {"time": "s", "position": coordinate.length, "velocity": coordinate.speed}
    units |= {coordinate.effort: coordinate.effort_unit} | dict.fromkeys(PRESSURES, "Pa")
    columns, ambient_pressure = dict[str, Any](), fields["ambient_pressure"]
    with ErrorCollector() as errors:
        for channel in filter(fields.__contains__, COLUMNS):
            if "value" in fields[channel]:
                columns[channel] = np.full(table.columns[0].size, fields[channel]["value"][index])
                continue
            with errors.collecting():
                kind: Kind = "pressure" if channel in PRESSURES else "plain"
                heading_unit = "" if "unit" in fields[channel] else table.units[table.index(fields[channel]["column"])]
                if _has_valid_unit(errors, channel, heading_unit, coordinate):
                    reading = read_column(channel, fields[channel], table, units[channel], kind, ambient_pressure)
                    columns[channel] = reading.values - (ambient_pressure if kind == "pressure" else 0.0)
    if "time" in columns:
        elapsed = columns["time"] - columns["time"][0]
        is_selected = (elapsed >= fields["skip"]) & (elapsed <= fields["until"])
        columns = {channel: values[is_selected] for channel, values in columns.items()}
    gauge, counter = (columns.pop(channel, None) for channel in PRESSURES)
    if gauge is not None:
        counter = np.zeros(gauge.shape) if counter is None else counter
        columns["pressure"] = gauge - counter
        area = fields.get("area", 0.25 * math.pi * fields.get("bore", 0.0) ** 2)
        annulus = area - 0.25 * math.pi * fields.get("rod_diameter", 0.0) ** 2
        if area > 0.0:
            lever = fields.get("pulley_radius", 1.0) * fields["direction"]
            columns["pressure_force"] = lever * (area * gauge - annulus * counter)
    uncertainty, body = fields[coordinate.effort].get("uncertainty"), coordinate.body
    return FrictionRecord(
        force=columns.pop(coordinate.effort), **columns, uncertainty=uncertainty, body=body, name=name
    )

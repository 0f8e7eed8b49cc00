"""Files that name measured friction: which columns are time, position or velocity, force and pressure."""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress
from difflib import get_close_matches
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError
from poppet.core.tables import Field, missing_field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import Kind, quantity
from poppet.identify import columns as shared
from poppet.identify.friction.coordinate import ON_LINE, TURNING, Coordinate
from poppet.identify.friction.records import FrictionRecord

if TYPE_CHECKING:
    from poppet.timeseries.tables.reading import Table

MOVED = ("position", "velocity")
PRESSURES = ("pressure", "counter_pressure")
COLUMNS = ("time", *MOVED, "force", "torque", *PRESSURES)
TOP_LEVEL = {
    **shared.TOP_LEVEL,
    **dict.fromkeys(("cylinder", "law", "within"), Field()),
    **dict.fromkeys(COLUMNS, Field(type="table")),
    **dict.fromkeys(("bore", "rod_diameter", "pulley_radius"), Field(unit="m")),
    "area": Field(unit="m^2"),
    "direction": Field(unit="1"),
    "mass": Field(unit="kg"),
    "inertia": Field(unit="kg m^2"),
    "offset": Field(),
    **dict.fromkeys(("smoothing", "skip", "until"), Field(unit="s")),
}
_FORCE = Field(
    meaning="force or torque",
    example='force = { column = "F", unit = "N" }, or torque = { column = "M", unit = "N m" }',
)
CHANNEL_FIELDS = ("column", "value", "unit", "uncertainty")
OPTIONS = ("smoothing", "mass", "inertia", "pulley_radius")


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
        With all mistakes, each with its line where it can be told.

    Notes
    -----
    `file` is a table that `poppet` reads, or a list of them, relative to the file. Each channel names a `column`,
    and its `unit` where the heading has none; a pressure may be a `value`, or a list with one for each file.
    With a `bore` or an `area` the pressure pushes the body, towards larger positions where `direction` is 1, and what
    it pushes is not friction. Positive forces act towards larger positions.

    A file with a `torque` instead of a force is of a joint: its positions are angles, its `inertia` takes the place of
    the mass, and a pressure acts over a `pulley_radius`.

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
        return _read(file)


def _read(file: TomlFile) -> tuple[list[FrictionRecord], dict[str, Any]]:
    content = file.content
    coordinate = TURNING if "torque" in content else ON_LINE
    with ErrorCollector() as errors:
        offset = {"offset": Field(unit=coordinate.effort_unit, choices=("free",))}
        data = read_fields(errors, content, TOP_LEVEL | offset, table="friction file")
        _check_body(errors, content, coordinate)
        if "velocity" not in data and not {"position", "time"} <= data.keys():
            errors.add("friction.no_velocity", "velocity")
        if "bore" in data and "area" in data:
            errors.add("friction.bore_or_area", "area")
        if abs(float(data.get("direction", 1.0))) != 1.0:
            errors.add("bodies.direction", "direction", value=float(data["direction"]))
        with errors.collecting():
            within = _within(data, coordinate)
        ambient, named_files = 0.0, data.get("file", "")
        given = named_files if isinstance(named_files, list) else [named_files]
        with errors.collecting():
            ambient = shared.ambient_of(data)
        own = {
            name: _own(errors, name, data[name], len(given), ambient, coordinate) for name in COLUMNS if name in data
        }
    records, notes = [], list[Note]()
    with ErrorCollector() as errors:
        for place, name in enumerate(given):
            with errors.collecting():
                table = shared.table_of(file.folder, name, data)
                notes += table.notes
                records.append(_record(data, own, table, place, ambient, coordinate, Path(str(name)).stem))
    named = {each: str(data[each]) for each in ("part", "cylinder", "law") if each in data}
    options = {name: data[name] for name in (*OPTIONS, "offset") if name in data} | named | {"notes": tuple(notes)}
    return records, options | {"title": str(data.get("title", Path(file.name).stem)), "within": within}


def _check_body(errors: ErrorCollector, content: Mapping[str, Any], own: Coordinate) -> None:
    """What moves the body, and nothing of the other kind of body."""
    if "force" in content and "torque" in content:
        errors.add("friction.force_and_torque", "torque")
    unknown = [name for name in content if name not in TOP_LEVEL]
    if own.effort not in content and not get_close_matches("force", unknown, n=1):
        errors.extend([missing_field("force", _FORCE)])
    other = ON_LINE if own is TURNING else TURNING
    for name in (other.inertia, *["pulley_radius"] * (own is ON_LINE)):
        if name in content:
            errors.add("friction.of_other_body", name, body=other.body, effort=own.effort, other=own.body)
    if own is TURNING and "pressure" in content and "pulley_radius" not in content:
        errors.add("friction.no_radius", "pulley_radius")


def _check_unit(errors: ErrorCollector, channel: str, unit: str, own: Coordinate) -> bool:
    """False where a unit is that of the same channel of the other kind of body."""
    other = ON_LINE if own is TURNING else TURNING
    with suppress(InputError):  # an unknown unit is said where the column is read
        if channel in (*MOVED, own.effort) and other.is_of(unit, other.effort if channel == own.effort else channel):
            errors.add("friction.mixture", channel, unit=unit, effort=own.effort)
            return False
    return True


def _within(data: Mapping[str, Any], own: Coordinate) -> tuple[float, float] | None:
    given = data.get("within")
    if given is None:
        return None
    with ErrorCollector() as errors:
        is_pair = isinstance(given, list) and len(given) == 2
        ends = [quantity(each, own.length, name="within").value for each in given] if is_pair else [0.0, 0.0]
        if not ends[0] < ends[1]:
            errors.add("friction.within", "within", value=given)
    return ends[0], ends[1]


def _own(
    errors: ErrorCollector, channel: str, given: Mapping[str, Any], files: int, ambient: float, coordinate: Coordinate
) -> dict[str, Any]:
    """What a channel says; the values of a pressure as a list, gauge."""
    fields = dict.fromkeys(("column", "unit"), Field())
    if channel in PRESSURES:
        fields["value"] = Field()
    if channel == coordinate.effort:
        fields["uncertainty"] = Field(unit=coordinate.effort_unit)
    own = read_fields(errors, given, fields, channel, table="channel")
    if ("column" in given) == ("value" in given):
        errors.add("friction.column_or_value" if channel in PRESSURES else "friction.no_column", channel)
    if "unit" in own:
        _check_unit(errors, channel, str(own["unit"]), coordinate)
    if "value" in own:
        values = own["value"] if isinstance(own["value"], list) else [own["value"]] * files
        if len(values) != files:
            errors.add("friction.values", f"{channel}.value", count=len(values), files=files)
        with errors.collecting():
            read = [quantity(each, "Pa", kind="pressure", name=f"{channel}.value") for each in values]
            own["value"] = [each.value - (0.0 if each.reference == "gauge" else ambient) for each in read]
    return own


def _record(
    data: Mapping[str, Any],
    own: Mapping[str, Mapping[str, Any]],
    table: Table,
    place: int,
    ambient: float,
    coordinate: Coordinate,
    name: str,
) -> FrictionRecord:
    """One table or recording, in SI, without what is skipped."""
    found: dict[str, Any] = {}
    units = {"time": "s", "position": coordinate.length, "velocity": coordinate.speed}
    with ErrorCollector() as errors:
        for channel, told in own.items():
            if "value" in told:
                found[channel] = np.full(table.columns[0].size, told["value"][place])
                continue
            with errors.collecting():
                kind: Kind = "pressure" if channel in PRESSURES else "plain"
                unit = "Pa" if channel in PRESSURES else units.get(channel, coordinate.effort_unit)
                heading = "" if "unit" in told else table.units[table.index(told["column"])]
                if _check_unit(errors, channel, heading, coordinate):
                    values, _, _ = shared.column(channel, told, table, unit, kind, ambient)
                    found[channel] = values - ambient if kind == "pressure" else values
    if "time" in found:
        since = found["time"] - found["time"][0]
        kept = (since >= data.get("skip", 0.0)) & (since <= data.get("until", math.inf))
        found = {channel: values[kept] for channel, values in found.items()}
    gauge, counter = (found.pop(each, None) for each in PRESSURES)
    more: dict[str, Any] = {}
    if gauge is not None:
        behind = np.zeros(gauge.shape) if counter is None else counter
        more["pressure"] = gauge - behind
        area = data.get("area", 0.25 * math.pi * data.get("bore", 0.0) ** 2)
        ring = area - 0.25 * math.pi * data.get("rod_diameter", 0.0) ** 2
        if area > 0.0:
            more["pressure_force"] = (
                data.get("pulley_radius", 1.0) * data.get("direction", 1.0) * (area * gauge - ring * behind)
            )
    if "uncertainty" in own[coordinate.effort]:
        more["uncertainty"] = own[coordinate.effort]["uncertainty"]
    more |= {"body": coordinate.body, "name": name}
    return FrictionRecord(force=found.pop(coordinate.effort), **found, **more)

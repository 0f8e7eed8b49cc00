"""Files that name measured friction: which columns are time, position or velocity, force and pressure."""

from __future__ import annotations

import math
from collections.abc import Mapping
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.ground.codes import Note
from poppet.ground.errors import Mistakes
from poppet.ground.tables import Field, read_fields
from poppet.ground.toml_file import TomlFile
from poppet.ground.units import Kind, quantity
from poppet.identify import columns as shared
from poppet.identify.friction.records import FrictionRecord
from poppet.series.checks import FloatArray

if TYPE_CHECKING:
    from poppet.series.tables.reading import Table

COLUMNS: dict[str, tuple[str, Kind]] = {
    "time": ("s", "plain"),
    "position": ("m", "plain"),
    "velocity": ("m/s", "plain"),
    "force": ("N", "plain"),
    "pressure": ("Pa", "pressure"),
    "counter_pressure": ("Pa", "pressure"),
}
PRESSURES = ("pressure", "counter_pressure")
TOP_LEVEL = {
    **shared.TOP_LEVEL,
    **dict.fromkeys(("cylinder", "law", "within"), Field()),
    **dict.fromkeys(COLUMNS, Field(is_table=True)),
    "force": Field(is_table=True, is_required=True),
    **dict.fromkeys(("bore", "rod_diameter"), Field(unit="m")),
    "area": Field(unit="m^2"),
    "direction": Field(unit="1"),
    "mass": Field(unit="kg"),
    "offset": Field(unit="N", choices=("free",)),
    **dict.fromkeys(("smoothing", "skip", "until"), Field(unit="s")),
}
CHANNEL_FIELDS = ("column", "value", "unit", "uncertainty")
OPTIONS = ("offset", "smoothing", "mass")


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
    with file.mistakes():
        return _read(file)


def _read(file: TomlFile) -> tuple[list[FrictionRecord], dict[str, Any]]:
    with Mistakes() as mistakes:
        data = read_fields(mistakes, file.content, TOP_LEVEL, "friction")
        if "velocity" not in data and not {"position", "time"} <= data.keys():
            mistakes.add("friction.no_velocity", "velocity")
        if "bore" in data and "area" in data:
            mistakes.add("friction.bore_or_area", "area")
        if abs(float(data.get("direction", 1.0))) != 1.0:
            mistakes.add("bodies.direction", "direction", value=float(data["direction"]))
        with mistakes.kept():
            within = _within(data)
        ambient, named_files = 0.0, data.get("file", "")
        given = named_files if isinstance(named_files, list) else [named_files]
        with mistakes.kept():
            ambient = shared.ambient_of(data)
        own = {name: _own(mistakes, name, data[name], len(given), ambient) for name in COLUMNS if name in data}
    records, notes = [], list[Note]()
    with Mistakes() as mistakes:
        for place, name in enumerate(given):
            with mistakes.kept():
                table = shared.table_of(file.folder, name, data)
                notes += table.notes
                records.append(_record(data, own, table, place, ambient, Path(str(name)).stem))
    named = {each: str(data[each]) for each in ("part", "cylinder", "law") if each in data}
    options = {name: data[name] for name in OPTIONS if name in data} | named | {"notes": tuple(notes)}
    return records, options | {"title": str(data.get("title", Path(file.name).stem)), "within": within}


def _within(data: Mapping[str, Any]) -> tuple[float, float] | None:
    given = data.get("within")
    if given is None:
        return None
    with Mistakes() as mistakes:
        is_pair = isinstance(given, list) and len(given) == 2
        ends = [quantity(each, "m", name="within").value for each in given] if is_pair else [0.0, 0.0]
        if not ends[0] < ends[1]:
            mistakes.add("friction.within", "within", value=given)
    return ends[0], ends[1]


def _own(mistakes: Mistakes, channel: str, given: Mapping[str, Any], files: int, ambient: float) -> dict[str, Any]:
    """What a channel says; the values of a pressure as a list, gauge."""
    fields = dict.fromkeys(("column", "unit"), Field())
    if channel in PRESSURES:
        fields["value"] = Field()
    if channel == "force":
        fields["uncertainty"] = Field(unit="N")
    own = read_fields(mistakes, given, fields, "friction.channel", channel)
    if ("column" in given) == ("value" in given):
        mistakes.add("friction.column_or_value" if channel in PRESSURES else "friction.no_column", channel)
    if "value" in own:
        values = own["value"] if isinstance(own["value"], list) else [own["value"]] * files
        if len(values) != files:
            mistakes.add("friction.values", f"{channel}.value", count=len(values), files=files)
        with mistakes.kept():
            read = [quantity(each, "Pa", kind="pressure", name=f"{channel}.value") for each in values]
            own["value"] = [each.value - (0.0 if each.reference == "gauge" else ambient) for each in read]
    return own


def _record(
    data: Mapping[str, Any], own: Mapping[str, Mapping[str, Any]], table: Table, place: int, ambient: float, name: str
) -> FrictionRecord:
    """One table or recording, in SI, without what is skipped."""
    found: dict[str, FloatArray] = {}
    with Mistakes() as mistakes:
        for channel, told in own.items():
            if "value" in told:
                found[channel] = np.full(table.columns[0].size, told["value"][place])
                continue
            with mistakes.kept():
                unit, kind = COLUMNS[channel]
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
            more["pressure_force"] = data.get("direction", 1.0) * (area * gauge - ring * behind)
    if "uncertainty" in own["force"]:
        more["uncertainty"] = own["force"]["uncertainty"]
    return FrictionRecord(**found, **more, name=name)

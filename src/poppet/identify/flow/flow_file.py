"""Flow bench files: which columns of which table are flow, pressures and temperature, and how well they were read."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import Kind, quantity
from poppet.identify import columns as shared
from poppet.identify.flow.points import CHANNELS, FlowPoints, Instrument

if TYPE_CHECKING:
    from poppet.timeseries.tables.reading import Table

LAW = {
    "subsonic_index": Field(unit="1", choices=("free",)),
    "cracking_pressure": Field(unit="Pa", kind="pressure_difference", choices=("free",)),
}
TOP_LEVEL = {
    **shared.TOP_LEVEL,
    **{
        name: Field(type="table", is_required=True, example=f'{name} = {{ column = "...", unit = "..." }}')
        for name in CHANNELS
    },
    "ambient_pressure_uncertainty": Field(unit="Pa", kind="pressure_difference"),
    **LAW,
}
ERRORS = {
    "uncertainty": "absolute",
    "relative_uncertainty": "relative",
    "offset": "offset",
    "calibration": "calibration",
}
"""Fields of a channel that say how well it was read, and what `Instrument` calls them."""
CHANNEL_FIELDS = ("column", "value", "unit", *ERRORS)
KINDS: dict[str, tuple[Kind, Kind]] = {
    "mass_flow_rate": ("mass_flow", "mass_flow"),
    "pressure_1": ("pressure", "pressure_difference"),
    "pressure_2": ("pressure", "pressure_difference"),
    "temperature_1": ("temperature", "temperature_difference"),
}
"""What a reading is, and what an error of it is: 1 degC of error is no 274.15 K."""


def read_flow_file(path: str | Path) -> tuple[FlowPoints, dict[str, Any]]:
    """Read a flow bench file.

    Parameters
    ----------
    path : str or Path
        A TOML file as in the example.

    Returns
    -------
    points : FlowPoints
        In SI units, pressures absolute.
    options : dict
        The keywords of `identify_flow`.

    Raises
    ------
    InputErrors
        With all mistakes, each with its line where it can be told.

    Notes
    -----
    `file` is any table that `poppet` reads, relative to the flow bench file. Every channel names a `column` (or a
    `value` for all points), its `unit` where the heading has none (`bar g` is gauge, `l/min ANR` a volume flow)
    and one-sigma uncertainties: `uncertainty` and `relative_uncertainty` from point to point, `offset` and
    `calibration` (a fraction) common to all points.

    Examples
    --------
    >>> import tempfile
    >>> text = '''
    ... file = "points.csv"
    ... mass_flow_rate = { column = "q", unit = "l/min ANR", relative_uncertainty = 0.01, calibration = 0.005 }
    ... pressure_1 = { column = "p1", unit = "bar g", uncertainty = "2 kPa", offset = "1 kPa" }
    ... pressure_2 = { column = "p2", unit = "bar g" }
    ... temperature_1 = { value = "20 degC" }
    ... ambient_pressure = "1.013 bar"
    ... subsonic_index = "free"
    ... '''
    >>> with tempfile.TemporaryDirectory() as folder:
    ...     _ = (Path(folder) / "points.csv").write_text("q,p1,p2\\n600,4,0\\n600,4,0.5\\n420,4,3\\n")
    ...     _ = (Path(folder) / "flow.toml").write_text(text)
    ...     points, options = read_flow_file(Path(folder) / "flow.toml")
    >>> points.pressure_1.round().tolist(), options["subsonic_index"]
    ([501300.0, 501300.0, 501300.0], 'free')
    """
    file = TomlFile.read(path, "mass_flow_rate")
    with file.errors():
        return _read(file)


def _read(file: TomlFile) -> tuple[FlowPoints, dict[str, Any]]:
    with ErrorCollector() as errors:
        data = read_fields(errors, file.content, TOP_LEVEL, table="flow bench file")
    ambient = shared.ambient_of(data)
    table = shared.table_of(file.folder, data["file"], data)
    columns: dict[str, Any] = {}
    notes = [*table.notes]
    known: dict[str, Any] = {}
    with ErrorCollector() as errors:
        for channel in CHANNELS:
            own = _own(errors, channel, data[channel], ambient)
            with errors.collecting():
                columns[channel] = _column(channel, own, table, ambient, notes)
            with errors.collecting(channel):
                known[channel] = Instrument(**{ours: own[name] for name, ours in ERRORS.items() if name in own})
    barometer = data.get("ambient_pressure_uncertainty", 0.0)
    gauge = [channel for channel in ("pressure_1", "pressure_2") if _is_gauge(data[channel], table)]
    if len(gauge) == 1:  # else the barometer moves both together
        alone = known[gauge[0]]
        known[gauge[0]], barometer = replace(alone, offset=math.hypot(alone.offset, barometer)), 0.0
    points = FlowPoints(
        **columns,
        **{f"u_{channel}": instrument for channel, instrument in known.items()},
        u_ambient_pressure=barometer if gauge else 0.0,
        lines=table.lines,
    )
    if gauge and "ambient_pressure" not in data:
        notes.append(Note("flow.ambient_assumed", "ambient_pressure"))
    named = {"title": str(data.get("title", Path(file.name).stem)), "part": str(data.get("part", ""))}
    return points, {**{name: data[name] for name in LAW if name in data}, **named, "notes": tuple(notes)}


def _own(errors: ErrorCollector, channel: str, given: Mapping[str, Any], ambient: float) -> dict[str, Any]:
    """What a channel says, in SI, pressures absolute."""
    unit, (kind, difference) = CHANNELS[channel], KINDS[channel]
    fields = {
        **dict.fromkeys(("column", "unit"), Field()),
        "value": Field(unit=unit, kind=kind),
        **dict.fromkeys(("uncertainty", "offset"), Field(unit=unit, kind=difference)),
        **dict.fromkeys(("relative_uncertainty", "calibration"), Field(unit="1")),
    }
    if ("column" in given) == ("value" in given):
        errors.add("flow.column_or_value", channel)
    return read_fields(errors, given, fields, channel, table="channel", ambient_pressure=ambient)


def _column(channel: str, own: Mapping[str, Any], table: Table, ambient: float, notes: list[Note]) -> Any:
    """Readings in SI, pressures absolute; a volume flow that leaves its state open is noted."""
    if "column" not in own:  # one value for all points, unless a mistake was found in it
        return own.get("value")
    values, written, stated = shared.column(channel, own, table, CHANNELS[channel], KINDS[channel][0], ambient)
    if stated != written:
        notes.append(Note("doubt.read_as", channel, unit=written, read=stated))
    return values


def _is_gauge(given: Mapping[str, Any], table: Table) -> bool:
    text = given.get("value") or f"1 {given.get('unit', '') or table.units[table.index(given['column'])]}"
    return quantity(text, "Pa", kind="pressure").reference == "gauge"

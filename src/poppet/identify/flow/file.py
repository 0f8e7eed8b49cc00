"""Flow bench files: which columns of which table are flow, pressures and temperature, and how well they were read."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.ground.codes import Note
from poppet.ground.errors import InputError, Mistakes, Near, UnitError, collect
from poppet.ground.toml_file import TomlFile
from poppet.ground.units import Kind, convert, quantity
from poppet.identify.flow.points import CHANNELS, FlowPoints, Instrument

if TYPE_CHECKING:
    from poppet.series.tables.reading import Table

TABLE_OPTIONS = ("separator", "decimal", "header_rows", "group")
TOP_LEVEL = (
    "title",
    "part",
    "file",
    *TABLE_OPTIONS,
    *CHANNELS,
    "ambient_pressure",
    "ambient_pressure_uncertainty",
    "subsonic_index",
    "cracking_pressure",
)
CHANNEL_FIELDS = ("column", "value", "unit", "uncertainty", "relative_uncertainty", "offset", "calibration")
KINDS: dict[str, Kind] = {"mass_flow_rate": "mass_flow", "temperature_1": "temperature"}
DIFFERENCES: dict[str, Kind] = {"mass_flow_rate": "mass_flow", "temperature_1": "temperature_difference"}


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
    path = Path(path)
    file = TomlFile.read(path)
    with file.mistakes():
        return _read(file.content, path)


def _read(data: Mapping[str, Any], path: Path) -> tuple[FlowPoints, dict[str, Any]]:
    from poppet.series.tables.reading import read_table

    collect(_key_mistakes(data))
    options = {name: data[name] for name in TABLE_OPTIONS if name in data}
    table = read_table(path.parent / str(data["file"]), **options)
    ambient, barometer = 1e5, 0.0
    columns: dict[str, Any] = {}
    known: dict[str, Any] = {}
    law: dict[str, Any] = {}
    with Mistakes() as mistakes:
        with mistakes.kept():
            ambient = _ambient(data)
        for channel in CHANNELS:
            with mistakes.kept():
                columns[channel] = _column(channel, data[channel], table, ambient)
            with mistakes.kept():
                known[channel] = _instrument(channel, data[channel])
        with mistakes.kept():
            barometer = _difference(data, "ambient_pressure_uncertainty", "Pa", "pressure_difference")
        with mistakes.kept():
            law = _law(data)
    gauge = [channel for channel in ("pressure_1", "pressure_2") if _is_gauge(data[channel], table)]
    if len(gauge) == 1:  # else the barometer moves both together
        alone = known[gauge[0]]
        known[gauge[0]], barometer = replace(alone, offset=math.hypot(alone.offset, barometer)), 0.0
    points = FlowPoints(
        **columns,
        **{f"u_{channel}": instrument for channel, instrument in known.items()},
        u_ambient_pressure=barometer if gauge else 0.0,
    )
    notes = [*table.notes]
    if gauge and "ambient_pressure" not in data:
        notes.append(Note("flow.ambient_assumed", "ambient_pressure"))
    named = {"title": str(data.get("title", path.stem)), "part": str(data.get("part", ""))}
    return points, {**law, **named, "notes": tuple(notes)}


def _key_mistakes(data: Mapping[str, Any]) -> list[InputError]:
    found = [InputError("flow.unknown_key", key, near=Near(key, TOP_LEVEL)) for key in data if key not in TOP_LEVEL]
    if "file" not in data:
        found.append(InputError("flow.missing_file", "file"))
    for key in CHANNELS:
        if key not in data:
            found.append(InputError("flow.missing_channel", key))
        elif not isinstance(data[key], Mapping):
            found.append(InputError("flow.not_a_table", key, value=data[key]))
        else:
            unknown = [name for name in data[key] if name not in CHANNEL_FIELDS]
            found += [InputError("flow.unknown_field", key, field=n, near=Near(n, CHANNEL_FIELDS)) for n in unknown]
            if ("column" in data[key]) == ("value" in data[key]):
                found.append(InputError("flow.column_or_value", key))
    return found


def _ambient(data: Mapping[str, Any]) -> float:
    if "ambient_pressure" not in data:
        return 1e5
    found = quantity(data["ambient_pressure"], "Pa", kind="pressure", name="ambient_pressure")
    if found.reference == "gauge":
        raise UnitError("flow.gauge_ambient", "ambient_pressure", value=data["ambient_pressure"])
    return found.value


def _column(channel: str, table: Mapping[str, Any], read: Table, ambient: float) -> Any:
    """Readings in SI, pressures absolute."""
    unit, kind = CHANNELS[channel], KINDS.get(channel, "pressure")
    try:
        if "value" in table:
            found = quantity(table["value"], unit, kind=kind, name=f"{channel}.value")
            return found.value + (ambient if found.reference == "gauge" else 0.0)
        place = read.index(table["column"])
        given = str(table.get("unit", read.units[place]))
        if not given:
            raise UnitError("flow.no_unit", channel, unit=unit)
        quantity(f"1 {given}", unit, kind=kind, name=f"{channel}.unit")  # refuses l/min without its state
        return np.asarray(convert(read.columns[place], given, unit, ambient_pressure=ambient))
    except InputError as problem:
        raise problem.located(address=channel) from None


def _is_gauge(table: Mapping[str, Any], read: Table) -> bool:
    text = table.get("value") or f"1 {table.get('unit', '') or read.units[read.index(table['column'])]}"
    return quantity(text, "Pa", kind="pressure").reference == "gauge"


def _instrument(channel: str, table: Mapping[str, Any]) -> Instrument:
    unit, kind = CHANNELS[channel], DIFFERENCES.get(channel, "pressure_difference")
    try:
        return Instrument(
            absolute=_difference(table, "uncertainty", unit, kind),
            relative=_difference(table, "relative_uncertainty", "1", "plain"),
            offset=_difference(table, "offset", unit, kind),
            calibration=_difference(table, "calibration", "1", "plain"),
        )
    except InputError as problem:
        raise problem.within(channel) from None


def _difference(table: Mapping[str, Any], name: str, unit: str, kind: Kind) -> float:
    return quantity(table[name], unit, kind=kind, name=name).value if name in table else 0.0


def _law(data: Mapping[str, Any]) -> dict[str, Any]:
    """Subsonic index and cracking pressure: numbers, or "free"."""
    found: dict[str, Any] = {}
    kinds: dict[str, tuple[str, Kind]] = {
        "subsonic_index": ("1", "plain"),
        "cracking_pressure": ("Pa", "pressure_difference"),
    }
    for name, (unit, kind) in kinds.items():
        if data.get(name) == "free":
            found[name] = "free"
        elif name in data:
            try:
                found[name] = quantity(data[name], unit, kind=kind, name=name).value
            except InputError as problem:
                raise problem.located(address=name) from None
    return found

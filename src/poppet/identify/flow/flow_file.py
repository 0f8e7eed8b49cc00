"""Reader of flow bench files: columns of flow, pressures and temperature, with their uncertainties."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import Kind, quantity
from poppet.identify.data_file import FILE_FIELDS, channel_field, open_table, read_ambient, read_column
from poppet.identify.flow.points import CHANNELS, FlowPoints, Instrument

LAW_FIELDS = {
    "subsonic_index": Field(unit="1", choices=("free",)),
    "cracking_pressure": Field(unit="Pa", kind="pressure_difference", choices=("free",)),
}
TOP_LEVEL = {
    **FILE_FIELDS,
    **{name: channel_field(name, is_required=True) for name in CHANNELS},
    "ambient_pressure_uncertainty": Field(unit="Pa", kind="pressure_difference"),
    **LAW_FIELDS,
}
UNCERTAINTIES = {
    "uncertainty": "absolute",
    "relative_uncertainty": "relative",
    "offset": "offset",
    "calibration": "calibration",
}
"""Fields for the uncertainty of a channel, with the parameters of `Instrument`."""
AMBIENT_UNCERTAINTY = 2e3
"""Standard uncertainty of an ambient pressure that is not stated: weather and altitudes up to about 300 m [Pa]."""
MARKED_ABSOLUTE = re.compile(r"(?:[ (]a|abs|bara|psia)\)?\s*$", re.IGNORECASE)
CHANNEL_FIELDS = ("column", "value", "unit", *UNCERTAINTIES)
KINDS: dict[str, tuple[Kind, Kind]] = {
    "mass_flow_rate": ("mass_flow", "mass_flow"),
    "pressure_1": ("pressure", "pressure_difference"),
    "pressure_2": ("pressure", "pressure_difference"),
    "temperature_1": ("temperature", "temperature_difference"),
}
"""Quantities of a reading and of an error. They differ, because an error of 1 degC is 1 K, not 274.15 K."""


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
        All errors of the file, each with its line.

    Notes
    -----
    `file` is any table that `poppet` reads, relative to the flow bench file. Each channel names a `column`, or one
    `value` for all points. The `unit` is needed if the heading has none: `bar g` is gauge, `l/min ANR` a volume flow.
    Uncertainties are standard uncertainties. `uncertainty` and `relative_uncertainty` are independent at each point;
    `offset` and `calibration` (a fraction) are common to all points.

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
        with ErrorCollector() as errors:
            fields = read_fields(errors, file.content, TOP_LEVEL, table="flow bench file")
        ambient_pressure = read_ambient(fields)
        table = open_table(file.folder, fields["file"], fields)
        notes = [*table.notes]
        columns: dict[str, Any] = {}
        instruments: dict[str, Any] = {}
        with ErrorCollector() as errors:
            for channel, unit in CHANNELS.items():
                kind, difference = KINDS[channel]
                declared = {
                    "column": Field(),
                    "unit": Field(),
                    "value": Field(unit=unit, kind=kind),
                    **dict.fromkeys(("uncertainty", "offset"), Field(unit=unit, kind=difference)),
                    **dict.fromkeys(("relative_uncertainty", "calibration"), Field(unit="1")),
                }
                if ("column" in fields[channel]) == ("value" in fields[channel]):
                    errors.add("flow.column_or_value", channel)
                values = read_fields(
                    errors, fields[channel], declared, channel, table="channel", ambient_pressure=ambient_pressure
                )
                columns[channel] = values.get("value")  # one value for all points, None if it is invalid
                with errors.collecting():
                    if "column" in values:
                        reading = read_column(channel, values, table, unit, kind, ambient_pressure)
                        columns[channel] = reading.values
                        if reading.unit != reading.written_unit:
                            notes.append(Note("doubt.read_as", channel, unit=reading.written_unit, read=reading.unit))
                with errors.collecting(channel):
                    instruments[channel] = Instrument(
                        **{parameter: values[key] for key, parameter in UNCERTAINTIES.items() if key in values}
                    )
        gauge, absolute = [], []
        for channel in ("pressure_1", "pressure_2"):
            raw = fields[channel]
            text = raw.get("value") or f"1 {raw.get('unit', '') or table.units[table.index(raw['column'])]}"
            if quantity(text, "Pa", kind="pressure").reference == "gauge":
                gauge.append(channel)
            elif MARKED_ABSOLUTE.search(text):  # absolute also without a mark, but then perhaps by mistake
                absolute.append(channel)
        is_assumed = bool(gauge) and "ambient_pressure" not in fields
        barometer = fields.get("ambient_pressure_uncertainty", AMBIENT_UNCERTAINTY if is_assumed else 0.0)
        if len(gauge) == 1:  # with two gauge pressures, the error of the barometer is common to both
            instrument = instruments[gauge[0]]
            instruments[gauge[0]] = replace(instrument, offset=math.hypot(instrument.offset, barometer))
        points = FlowPoints(
            **columns,
            **{f"u_{channel}": instrument for channel, instrument in instruments.items()},
            u_ambient_pressure=barometer if len(gauge) == 2 else 0.0,
            lines=table.lines,
            is_absolute=len(gauge) + len(absolute) == 2,
        )
        if is_assumed:
            notes.append(Note("flow.ambient_assumed", "ambient_pressure", uncertainty_kpa=barometer / 1e3))
        options = {name: fields[name] for name in (*LAW_FIELDS, "part") if name in fields}
        return points, options | {"title": fields.get("title", Path(file.name).stem), "notes": tuple(notes)}

"""Tables in TDMS files of LabVIEW."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import needed
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.tables.table import Table, groups_of, seconds, table_of

_UNIT_PROPERTIES = ("unit_string", "NI_UnitDescription", "Unit", "unit")


def read(path: Path, *, group: str | int | None = None) -> Table:
    """Read the channels of a TDMS file."""
    with needed("npTDMS", "A TDMS file", "measured"):
        from nptdms import TdmsFile
    file = TdmsFile.read(path)
    groups: dict[str, dict[str, FloatArray]] = {}
    units: dict[str, str] = {}
    notes: list[Note] = []
    for channel_group in file.groups():
        columns, missing = _columns(channel_group.channels())
        notes += [Note("table.channel_without_numbers", channel=name, group=channel_group.name) for name in missing]
        if columns:
            groups[channel_group.name] = columns
        for channel in channel_group.channels():
            unit = next((str(channel.properties[key]) for key in _UNIT_PROPERTIES if key in channel.properties), "")
            units[channel.name] = units[f"{channel_group.name}/{channel.name}"] = unit
    columns_of_file = groups_of(groups, group) if groups else {}
    stamps = {name: "s" for name in columns_of_file if name.rpartition("/")[2].rpartition(" ")[2] == "time"}
    return table_of(columns_of_file, stamps | {name: unit for name, unit in units.items() if unit}, notes)


def _columns(channels: list[Any]) -> tuple[dict[str, FloatArray], list[str]]:
    """Return the columns of a group with their times, and the names of channels without numbers."""
    columns, missing = {}, []
    bases: dict[str, tuple[float, float, int]] = {}
    for channel in channels:
        values: Any = np.asarray(channel[:])
        if not values.size or values.dtype.kind not in "iufbM":
            missing += [channel.name]
            continue
        columns[channel.name] = seconds(values) if values.dtype.kind == "M" else values.astype(float)
        if "wf_increment" in channel.properties:
            # The offset can be absent; time_track() of the package raises an error in this case.
            offset = float(channel.properties.get("wf_start_offset", 0.0))
            bases[channel.name] = (offset, float(channel.properties["wf_increment"]), values.size)
    # Each waveform has a clock; if all clocks are equal, they are the time of the group.
    common = len(set(bases.values())) == 1 and "time" not in columns
    for name, (offset, increment, count) in bases.items():
        base = offset + increment * np.arange(count)
        columns["time" if common else f"{name} time"] = base
    return columns, missing

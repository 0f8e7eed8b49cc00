"""Tables in ASAM MDF files of measuring computers and calibration tools."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from poppet.core.codes import Note
from poppet.core.errors import needed
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.tables.table import Table, groups_of, table_of


def read(path: Path, *, group: str | int | None = None) -> Table:
    """Read the channels of an MDF file."""
    with needed("asammdf", "An MDF file", "measured"):
        from asammdf import MDF
    path.open("rb").close()  # gives the usual error for a missing file
    with MDF(path) as file:
        groups, units, notes = _groups(file)
    columns = groups_of(groups, group) if groups else {}
    stamps = {name: "s" for name in columns if name.rpartition("/")[2] == "time"}
    return table_of(columns, units | stamps, notes)


def _groups(file: Any) -> tuple[dict[str, dict[str, FloatArray]], dict[str, str], list[Note]]:
    groups: dict[str, dict[str, FloatArray]] = {}
    units: dict[str, str] = {}
    notes: list[Note] = []
    for k in range(len(file.groups)):
        name = str(getattr(file.groups[k].channel_group, "acq_name", "") or "")
        name = name if name and name not in groups else f"group {k}"
        columns: dict[str, FloatArray] = {}
        for signal in _signals(file, k):
            if signal.samples.dtype.kind not in "iufb" or signal.samples.ndim != 1:
                notes.append(Note("table.channel_without_numbers", channel=signal.name, group=name))
                continue
            # All channels of a group share its clock.
            columns.setdefault("time", np.asarray(signal.timestamps, dtype=float))
            columns[signal.name] = signal.samples.astype(float)
            units[signal.name] = units[f"{name}/{signal.name}"] = signal.unit or ""
        if columns.get("time", np.empty(0)).size:
            groups[name] = columns
    return groups, units, notes


def _signals(file: Any, group: int) -> list[Any]:
    """Return the channels of a group without its master channel, the time."""
    master = file.masters_db.get(group)
    channels = [(None, group, k) for k in range(len(file.groups[group].channels)) if k != master]
    return list(file.select(channels)) if channels else []

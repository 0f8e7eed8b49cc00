"""Bands of the cells of a tube: from the minimum to the maximum of all cells at each time."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from poppet.timeseries.plotting.panels import Series

_CELL = re.compile(r"(?P<tube>.+)\.\d+\.(?P<output>[^.]+)")


def cells_of(names: Iterable[str]) -> dict[str, list[str]]:
    """Group the outputs of all cells of a tube by the common name without the number of the cell.

    Tubes of one cell are omitted.

    Examples
    --------
    >>> cells_of(["hose.1.pressure", "hose.2.pressure", "tank.pressure", "pipe.1.pressure"])
    {'hose.pressure': ['hose.1.pressure', 'hose.2.pressure']}
    """
    groups: dict[str, list[str]] = {}
    for name in names:
        if match := _CELL.fullmatch(name):
            groups.setdefault(f"{match['tube']}.{match['output']}", []).append(name)
    return {name: cells for name, cells in groups.items() if len(cells) > 1}


def with_bands(series: Sequence[Series]) -> list[Series]:
    """Replace the cells of each tube by one band, at the place of the first cell.

    Cells of different recordings or units have separate bands.
    """
    bands = {
        cell: name for name, cells in cells_of(dict.fromkeys(item.name for item in series)).items() for cell in cells
    }
    groups: dict[tuple[str, int, str], list[Series]] = {}
    for item in series:
        groups.setdefault((bands.get(item.name, item.name), item.source, item.unit), []).append(item)
    return [
        _band(name, members) if members[0].name in bands else members[0] for (name, _, _), members in groups.items()
    ]


def _band(name: str, cells: Sequence[Series]) -> Series:
    rows = np.array([cell.values for cell in cells])
    return replace(cells[0], name=name, values=rows.min(axis=0), high=rows.max(axis=0))

"""Bands of the cells of a tube: from the minimum to the maximum of all cells at each time."""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np

from poppet.timeseries.plotting.panels import Series

_CELL = re.compile(r"(?P<tube>.+)\.(?P<cell>\d+)\.(?P<output>[^.]+)")


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


def band_outputs(names: Iterable[str]) -> dict[str, list[str]]:
    """Group the outputs of each band of a tube by the name of the band.

    If an output has the name of the band, it belongs to the band. An example is the mass flow rate at the start of a
    tube: the cells have the other mass flow rates.

    Examples
    --------
    >>> band_outputs(["hose.mass_flow_rate", "hose.1.mass_flow_rate", "hose.2.mass_flow_rate"])
    {'hose.mass_flow_rate': ['hose.mass_flow_rate', 'hose.1.mass_flow_rate', 'hose.2.mass_flow_rate']}
    """
    names = list(names)
    band_of = {output: name for name, cells in cells_of(names).items() for output in (name, *cells)}
    groups: dict[str, list[str]] = {}
    for name in names:
        if name in band_of:
            groups.setdefault(band_of[name], []).append(name)
    return groups


def cell_range(outputs: Sequence[str]) -> str:
    """Return the numbers of the first and the last cell of a band, as text.

    Examples
    --------
    >>> cell_range(["hose.1.pressure", "hose.2.pressure", "hose.3.pressure"])
    'cells 1 to 3'
    """
    numbers = [int(match["cell"]) for match in map(_CELL.fullmatch, outputs) if match]
    return f"cells {min(numbers)} to {max(numbers)}"


def with_bands(series: Sequence[Series]) -> list[Series]:
    """Replace the cells of each tube by one band, at the place of the first cell.

    Cells of different recordings or units have separate bands.
    """
    groups_of = band_outputs(dict.fromkeys(item.name for item in series))
    bands = {output: name for name, outputs in groups_of.items() for output in outputs}
    groups: dict[tuple[str, int, str], list[Series]] = {}
    for item in series:
        groups.setdefault((bands.get(item.name, item.name), item.source, item.unit), []).append(item)
    return [
        _band(name, members) if members[0].name in bands else members[0] for (name, _, _), members in groups.items()
    ]


def _band(name: str, cells: Sequence[Series]) -> Series:
    rows = np.array([cell.values for cell in cells])
    return replace(cells[0], name=name, values=rows.min(axis=0), high=rows.max(axis=0))

"""Table of the measured force of a muscle: a line over pressure for each contraction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.laws.physics.muscle import ForceTable
from poppet.parts.fields import NumberSpec
from poppet.parts.rows import NumberTable

_COLUMNS = {
    "contraction": NumberSpec("1", "contraction", low=-0.2, below=1.0),
    "force_per_pressure": NumberSpec("N/Pa", "force per gauge pressure"),
    "passive_force": NumberSpec("N", "force without gauge pressure"),
}


@dataclass(frozen=True)
class ForceRows(NumberTable):
    """Force per gauge pressure and passive force by contraction, with linear interpolation.

    Parameters
    ----------
    columns : mapping
        Name of each column to its numbers, one for each contraction.

    Examples
    --------
    >>> rows = {"contraction": [0.0, 0.1], "force_per_pressure": ["300 N/bar", "100 N/bar"], "passive_force": [0, -99]}
    >>> table = ForceRows.read(rows)
    >>> round(table.law(table.parameters(1e5)).force(1e5, 0.1), 9)
    1.0
    """

    field: ClassVar[str] = "force_table"

    @classmethod
    def column_specs(cls, *form: str) -> Mapping[str, NumberSpec]:
        return _COLUMNS

    def law(self, values: Mapping[str, Any]) -> ForceTable:
        """Return the law for run-time values, floats or symbols."""
        return ForceTable(*(self.column(name, values) for name in _COLUMNS))

"""Gains of a controller that are interpolated between operating points."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from poppet.core.symbolic import clip
from poppet.parts.fields import NumberSpec
from poppet.parts.quantities import OPENING, QUANTITIES, gain_unit
from poppet.parts.rows import NumberTable

_DEFAULTS = {"derivative_time": 0.0, "vent_factor": 1.0}


@dataclass(frozen=True)
class GainSchedule(NumberTable):
    """Gains at operating points, with linear interpolation and constant extrapolation.

    Parameters
    ----------
    columns : mapping
        Name of each column to its numbers, one for each operating point.
    form : tuple of str
        Controlled quantity, which is the name of the first column, and commanded quantity.

    Examples
    --------
    >>> table = {"pressure": ["2 bar", "4 bar"], "gain": [1e-5, 3e-5], "integral_time": [0.1, 0.3]}
    >>> schedule = GainSchedule.read(table)
    >>> round(schedule.at(3e5, schedule.parameters(1e5))["gain"], 9)
    2e-05
    """

    field: ClassVar[str] = "schedule"

    @classmethod
    def column_specs(cls, *form: str) -> Mapping[str, NumberSpec]:
        quantity, command = form
        controlled = QUANTITIES[quantity]
        columns = {
            quantity: NumberSpec(controlled.unit, "operating point", kind=controlled.kind, low=controlled.low),
            "gain": NumberSpec(gain_unit(quantity, command), "gain"),
            "integral_time": NumberSpec("s", "integral time", above=0.0),
            "derivative_time": NumberSpec("s", "derivative time", low=0.0, optional=True),
        }
        factor = NumberSpec("1", "factor on commands to vent", above=0.0, optional=True)
        return columns | {"vent_factor": factor} if command == OPENING else columns

    @classmethod
    def read(cls, table: Any, *form: str) -> Self:
        return super().read(table, *(form or ("pressure", OPENING)))

    def at(self, point: Any, values: Mapping[str, Any]) -> dict[str, Any]:
        """Return the gains at an operating point."""
        point_column = self.form[0]
        gaps = range(1, len(self.columns[point_column]))
        steps = {name: [values[f"{name}_{k + 1}"] - values[f"{name}_{k}"] for k in gaps] for name in self.columns}
        # The fraction of each gap below the operating point: a sum, which is traced without a branch.
        widths = zip(gaps, steps.pop(point_column), strict=True)
        fractions = [clip((point - values[f"{point_column}_{k}"]) / width, 0.0, 1.0) for k, width in widths]
        gains: dict[str, Any] = dict(_DEFAULTS)
        for name, heights in steps.items():
            gains[name] = values[f"{name}_1"] + sum(a * b for a, b in zip(fractions, heights, strict=True))
        return gains

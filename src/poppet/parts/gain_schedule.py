"""Gains of a controller over operating points, interpolated."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar, Self

from poppet.core.symbolic import clip
from poppet.parts.fields import NumberSpec
from poppet.parts.quantities import OPENING, QUANTITIES, gain_unit
from poppet.parts.rows import NumberTable

_OTHERWISE = {"derivative_time": 0.0, "vent_factor": 1.0}


@dataclass(frozen=True)
class GainSchedule(NumberTable):
    """Gains at operating points; between them straight lines, beyond them those of the last point.

    Parameters
    ----------
    columns : mapping
        Name of each column to its numbers, one per operating point.
    form : tuple of str
        What is controlled, which is the name of the first column, and what is commanded.

    Examples
    --------
    >>> table = {"pressure": ["2 bar", "4 bar"], "gain": [1e-5, 3e-5], "integral_time": [0.1, 0.3]}
    >>> schedule = GainSchedule.read(table)
    >>> round(schedule.at(3e5, schedule.parameters(1e5))["gain"], 9)
    2e-05
    """

    field: ClassVar[str] = "schedule"

    @classmethod
    def known(cls, *form: str) -> Mapping[str, NumberSpec]:
        quantity, command = form
        of = QUANTITIES[quantity]
        found = {
            quantity: NumberSpec(of.unit, "operating point", kind=of.kind, low=of.low),
            "gain": NumberSpec(gain_unit(quantity, command), "gain"),
            "integral_time": NumberSpec("s", "integral time", above=0.0),
            "derivative_time": NumberSpec("s", "derivative time", low=0.0, optional=True),
        }
        factor = NumberSpec("1", "factor on commands to vent", above=0.0, optional=True)
        return found | {"vent_factor": factor} if command == OPENING else found

    @classmethod
    def read(cls, given: Any, *form: str) -> Self:
        return super().read(given, *(form or ("pressure", OPENING)))

    def at(self, point: Any, values: Mapping[str, Any]) -> dict[str, Any]:
        """Gains at an operating point."""
        rising = self.form[0]
        gaps = range(1, len(self.columns[rising]))
        steps = {name: [values[f"{name}_{k + 1}"] - values[f"{name}_{k}"] for k in gaps] for name in self.columns}
        # The part of each gap that lies below the operating point, 0..1: a sum, so that it traces without a branch.
        widths = zip(gaps, steps.pop(rising), strict=True)
        shares = [clip((point - values[f"{rising}_{k}"]) / width, 0.0, 1.0) for k, width in widths]
        found: dict[str, Any] = dict(_OTHERWISE)
        for name, heights in steps.items():
            found[name] = values[f"{name}_1"] + sum(a * b for a, b in zip(shares, heights, strict=True))
        return found

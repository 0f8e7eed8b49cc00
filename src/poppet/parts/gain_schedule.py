"""Gains of a controller over operating points, interpolated."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, ClassVar

from poppet.ground.symbolic import clip
from poppet.parts.fields import NumberSpec
from poppet.parts.rows import Rows

_OTHERWISE = {"derivative_time": 0.0, "vent_factor": 1.0}


@dataclass(frozen=True)
class GainSchedule(Rows):
    """Gains at operating points; between them straight lines, beyond them those of the last point.

    Parameters
    ----------
    columns : mapping
        Name of each column to its numbers, one per operating point.

    Examples
    --------
    >>> table = {"pressure": ["2 bar", "4 bar"], "gain": [1e-5, 3e-5], "integral_time": [0.1, 0.3]}
    >>> schedule = GainSchedule.read(table)
    >>> round(schedule.at(3e5, schedule.parameters(1e5))["gain"], 9)
    2e-05
    """

    field: ClassVar[str] = "schedule"
    known: ClassVar[Mapping[str, NumberSpec]] = {
        "pressure": NumberSpec("Pa", "operating point", kind="pressure", low=0.0),
        "gain": NumberSpec("1/Pa", "gain"),
        "integral_time": NumberSpec("s", "integral time", above=0.0),
        "derivative_time": NumberSpec("s", "derivative time", low=0.0),
        "vent_factor": NumberSpec("1", "factor on commands to vent", above=0.0),
    }
    needed: ClassVar[tuple[str, ...]] = ("pressure", "gain", "integral_time")

    def at(self, pressure: Any, values: Mapping[str, Any]) -> dict[str, Any]:
        """Gains at an operating point."""
        gaps = range(1, len(self.columns["pressure"]))
        steps = {name: [values[f"{name}_{k + 1}"] - values[f"{name}_{k}"] for k in gaps] for name in self.columns}
        # The part of each gap that lies below the operating point, 0..1: a sum, so that it traces without a branch.
        widths = zip(gaps, steps.pop("pressure"), strict=True)
        shares = [clip((pressure - values[f"pressure_{k}"]) / width, 0.0, 1.0) for k, width in widths]
        found: dict[str, Any] = dict(_OTHERWISE)
        for name, heights in steps.items():
            found[name] = values[f"{name}_1"] + sum(a * b for a, b in zip(shares, heights, strict=True))
        return found

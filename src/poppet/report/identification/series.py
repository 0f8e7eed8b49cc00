"""Series of an identification as its figures need them: whatever the method wrote, in one shape."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.identify import Result
from poppet.timeseries.checks import FloatArray


@dataclass(frozen=True, eq=False, kw_only=True)
class Trace:
    """One channel of an identification; arrays are empty where there is nothing."""

    name: str  # as in the result
    unit: str  # SI, of all values; `1` where they have none
    x: FloatArray  # where it was measured, (n,)
    measured: FloatArray  # (n,)
    curve_x: FloatArray  # where the model is known, (m,)
    model: FloatArray  # (m,)
    low: FloatArray  # band of the model, (m,)
    high: FloatArray
    samples: FloatArray  # half the band of single samples with their noise, (m,)
    x_unit: str  # SI
    x_name: str  # what `x` is; `time` where the samples follow each other
    error_low: FloatArray  # intervals of the points, (n,)
    error_high: FloatArray
    sigma: float = math.nan  # standard deviation of the noise; not a number where it is not known

    @property
    def is_timed(self) -> bool:
        """True for a recording."""
        return self.x_name == "time"

    @property
    def quantity(self) -> str:
        """What the values are, `pressure`."""
        return self.name.rpartition(".")[2].replace("_", " ")

    @property
    def residual(self) -> FloatArray:
        """Model minus measurement at the places of the measurement; empty where one is missing."""
        if not self.model.size or not self.measured.size:
            return np.zeros(0)
        if np.array_equal(self.x, self.curve_x):
            return self.model - self.measured
        return np.interp(self.x, self.curve_x, self.model, np.nan, np.nan) - self.measured


def traces_of(result: Result) -> list[Trace]:
    """The series of a result that can be drawn."""
    found = [_trace(result, name, table) for name, table in result.series.items() if isinstance(table, Mapping)]
    return [trace for trace in found if trace.measured.size or trace.model.size]


def _trace(result: Result, name: str, table: Mapping[str, Any]) -> Trace:
    """Points and model share their places, or a curve `x`, `y` has points of its own beside it."""

    def array(key: str, like: FloatArray | None = None) -> FloatArray:
        """A series of the table; empty where it is missing or does not fit the places `like`."""
        values = np.asarray(table.get(key, ()), dtype=float)
        return values if values.ndim == 1 and (like is None or values.shape == like.shape) else np.zeros(0)

    is_timed, is_curve = "time" in table, "points_x" in table
    curve_x = array("time" if is_timed else "x")
    x = array("points_x") if is_curve else curve_x
    residual = result.residuals.get(name)
    return Trace(
        name=name,
        unit=str(table.get("unit") or (residual.unit if residual else "1")),
        x=x,
        measured=array("points_y" if is_curve else "measured", x),
        curve_x=curve_x,
        model=array("y" if is_curve else "model", curve_x),
        low=array("low", curve_x),
        high=array("high", curve_x),
        samples=array("samples_high", curve_x) - array("model", curve_x) if "samples_high" in table else np.zeros(0),
        x_unit="s" if is_timed else str(table.get("x_unit", "1")),
        x_name="time" if is_timed else str(table.get("x_name", "x")),
        error_low=array("points_low", x),
        error_high=array("points_high", x),
        sigma=float(result.conditions.get("noise", {}).get(name, math.nan)),
    )

"""Series of an identification as its figures need them: whatever the method wrote, in one shape."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.identify import Result
from poppet.series.checks import FloatArray

_POINTS, _CURVES = {False: ("measured",), True: ("points_y",)}, {False: ("model",), True: ("y",)}
_PLACES = {"flow": ("p2/p1", "1"), "characteristic": ("stroke", "m")}
"""What a method's points stand over when they do not follow each other in time."""
_UNITS = {
    "pressure": "Pa",
    "temperature": "K",
    "mass_flow_rate": "kg/s",
    "conductance": "m^3/(s Pa)",
    "stroke": "m",
    "volume": "m^3",
}
"""Unit of a series that has none, by the end of its name."""


@dataclass(frozen=True, eq=False)
class Trace:
    """One channel of an identification.

    Parameters
    ----------
    name : str
        As in the result.
    unit : str
        SI unit of the values; `1` where it has none.
    x : (n,) array
        Where it was measured; empty where nothing was.
    measured : (n,) array
        In `unit`.
    curve_x : (m,) array
        Where the model is known.
    model : (m,) array
        In `unit`; empty where there is none.
    low, high : (m,) array
        Band of the model, in `unit`; empty where there is none.
    x_unit : str
        SI unit of `x`.
    x_name : str
        What `x` is; `time` where the samples follow each other.
    error_low, error_high : (n,) array
        Intervals of the points, in `unit`; empty where there are none.
    sigma : float
        Standard deviation of the noise, in `unit`; not a number where it is not known.
    """

    name: str
    unit: str
    x: FloatArray
    measured: FloatArray
    curve_x: FloatArray
    model: FloatArray
    low: FloatArray
    high: FloatArray
    x_unit: str
    x_name: str
    error_low: FloatArray
    error_high: FloatArray
    sigma: float = math.nan

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
    found = [_trace(result, name, entry) for name, entry in result.series.items()]
    return [trace for trace in found if trace is not None and (trace.measured.size or trace.model.size)]


def _trace(result: Result, name: str, entry: Any) -> Trace | None:
    table = _table(result, entry)
    if table is None:
        return None
    is_timed, is_curve = "time" in table, "points_x" in table
    curve_x = _array(table, "time" if is_timed else "x")
    x = _array(table, "points_x") if is_curve else curve_x
    noise = result.conditions.get("noise", {})
    measured, error_low, error_high = [
        _array(table, key, x) for key in (*_POINTS[is_curve], "points_low", "points_high")
    ]
    model, low, high = [_array(table, key, curve_x) for key in (*_CURVES[is_curve], "low", "high")]
    return Trace(
        name,
        str(table.get("unit") or _unit(result, name)),
        x,
        measured,
        curve_x,
        model,
        low,
        high,
        "s" if is_timed else str(table.get("x_unit") or _PLACES.get(result.method, ("", "1"))[1]),
        "time" if is_timed else str(table.get("x_name") or _PLACES.get(result.method, ("x", ""))[0]),
        error_low,
        error_high,
        float(noise.get(name, math.nan)) if isinstance(noise, Mapping) else math.nan,
    )


def _table(result: Result, entry: Any) -> Mapping[str, Any] | None:
    if isinstance(entry, Mapping):
        return entry
    if not isinstance(entry, Sequence) or len(entry) != 3:
        return None
    return dict(zip(("x" if result.method in _PLACES else "time", "measured", "model"), entry, strict=True))


def _array(table: Mapping[str, Any], name: str, like: FloatArray | None = None) -> FloatArray:
    """A series of the table; empty where it is missing or does not fit the places `like`."""
    given = table.get(name)
    values = np.asarray(() if given is None else given, dtype=float)
    return values if values.ndim == 1 and (like is None or values.shape == like.shape) else np.zeros(0)


def _unit(result: Result, name: str) -> str:
    if name in result.residuals:
        return result.residuals[name].unit
    return next((unit for ending, unit in _UNITS.items() if name.endswith(ending)), "1")

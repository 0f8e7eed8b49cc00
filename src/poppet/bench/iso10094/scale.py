"""Records of bench trials, and the scale of setpoint and outlet pressure."""

from __future__ import annotations

import math
from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import InputError, raise_errors
from poppet.core.tables import Field

FloatArray = NDArray[np.float64]
Mask = NDArray[np.bool_]
PERCENT = 100.0


@dataclass(frozen=True)
class Scale:
    """Range of the setpoint, and the range of the outlet pressure to which it corresponds.

    Full scale (FS) is the width of the range of the outlet pressure.

    Examples
    --------
    >>> scale = Scale(0.0, 10.0, "V", 1e5, 7e5)
    >>> float(scale.setpoint(50.0)), float(scale.percent(4e5)), scale.span
    (5.0, 50.0, 600000.0)
    """

    setpoint_low: float  # in `setpoint_unit`
    setpoint_high: float
    setpoint_unit: str  # SI: Pa (absolute), V, A or 1
    pressure_low: float  # absolute [Pa]
    pressure_high: float

    def __post_init__(self) -> None:
        setpoints = ("setpoint_range", self.setpoint_low, self.setpoint_high, self.setpoint_unit)
        pressures = ("full_scale", self.pressure_low, self.pressure_high, "Pa")
        wrong = [ends for ends in (setpoints, pressures) if not -math.inf < ends[1] < ends[2] < math.inf]
        raise_errors([InputError("bench.range.scale", name, low=a, high=b, unit=unit) for name, a, b, unit in wrong])

    @property
    def span(self) -> float:
        """Full scale FS: width of the range of the outlet pressure [Pa]."""
        return self.pressure_high - self.pressure_low

    def setpoint(self, percent: float | FloatArray) -> FloatArray:
        """Return the setpoint, in its unit, for a percentage of its range."""
        part = np.asarray(percent) / PERCENT
        return np.asarray(self.setpoint_low * (1.0 - part) + self.setpoint_high * part)  # exact at both ends

    def setpoint_percent(self, setpoint: float | FloatArray) -> FloatArray:
        """Return a setpoint as a percentage of the setpoint range."""
        width = self.setpoint_high - self.setpoint_low
        return np.asarray(PERCENT * (np.asarray(setpoint) - self.setpoint_low) / width)

    def pressure(self, percent: float | FloatArray) -> FloatArray:
        """Return the absolute outlet pressure [Pa] for a percentage of full scale."""
        return np.asarray(self.pressure_low + self.span * np.asarray(percent) / PERCENT)

    def percent(self, pressure: float | FloatArray) -> FloatArray:
        """Return an outlet pressure as a percentage of full scale."""
        return np.asarray(PERCENT * (np.asarray(pressure) - self.pressure_low) / self.span)

    def percents(self, record: Record) -> tuple[FloatArray, FloatArray]:
        """Return setpoint and outlet pressure of a record as percentages of their ranges.

        Both are called % FS.
        """
        return self.setpoint_percent(record.setpoint), self.percent(record.outlet)


@dataclass(frozen=True, eq=False)
class Record:
    """Measured or simulated channels of one trial, with a common time base."""

    name: str  # of the trial or the recording
    test: str
    time: FloatArray  # strictly increasing [s]
    setpoint: FloatArray  # in the unit of the scale
    outlet: FloatArray  # absolute pressure [Pa]
    # The following series are empty if they were not recorded.
    supply: FloatArray  # absolute pressure [Pa]
    flow: FloatArray  # forward flow; relief flow is negative [kg/s]
    consumption: FloatArray  # from the supply into the valve [kg/s]
    volume: float = math.nan  # at the outlet; NaN if unknown [m^3]
    # True for a model: a setpoint step occurs exactly at the sample that shows it.
    is_exact: bool = False
    clipped: Mapping[str, Mask] = field(default_factory=dict)  # clipped samples by series

    def has_clipped_samples(self, *series: str, part: slice = slice(None)) -> bool:
        """Return True if at least one channel has clipped samples.

        A clipped sample is at a limit of its channel, so the true value is unknown. The arguments are the names of the
        channels to check, by default all channels. The keyword `part` restricts the check to a slice of the samples.
        """
        return any(bool(mask[part].any()) for name, mask in self.clipped.items() if not series or name in series)

    @property
    def step(self) -> float:
        """Median time between samples [s]."""
        return float(np.median(np.diff(self.time)))


# Usual ranges of setpoints that are no pressures, by their SI unit.
ELECTRIC = {"V": (0.0, 10.0), "A": (0.004, 0.020), "1": (0.0, 1.0)}


def read_pressure(raw: Any, ambient: float, name: str) -> float:
    """Return the absolute pressure [Pa] from the text `raw` with a unit.

    Gauge pressures are relative to `ambient` [Pa]. `name` is the address in error messages.

    Examples
    --------
    >>> read_pressure("6 bar g", 1e5, "supply")
    700000.0
    """
    value: float = Field(unit="Pa", kind="pressure", low=0.0, meaning="pressure").read(raw, name, ambient)
    return value


def read_pressure_range(raw: Any, ambient: float, name: str = "full_scale") -> tuple[float, float]:
    """Return the absolute limits of a pressure range [Pa], read from texts with units.

    `raw` is a list of two texts, or one text with the upper limit. The lower limit is then the pressure `ambient` [Pa].
    `name` is the address in error messages.

    Examples
    --------
    >>> read_pressure_range("6 bar g", 1e5), read_pressure_range(["1 bar g", "6 bar g"], 1e5)
    ((100000.0, 700000.0), (200000.0, 700000.0))
    """
    parts = [part.strip() for part in raw.split(",")] if isinstance(raw, str) else raw
    parts = parts if isinstance(parts, list | tuple) else [parts]
    if len(parts) not in (1, 2):
        raise InputError("bench.range.ends", name, given=raw)
    low, high = [ambient, *(read_pressure(part, ambient, name) for part in parts)][-2:]
    if low >= high:
        raise InputError("bench.range.falls", name, given=raw)
    return low, high


def setpoint_scale(raw: Any, full_scale: tuple[float, float], ambient: float, unit: str = "Pa") -> Scale:
    """Return the scale that relates a setpoint range to a range of outlet pressures.

    `raw` contains the ends of the setpoint range as texts with units, and `full_scale` the absolute outlet pressures
    [Pa]. If `raw` is None, the result has the usual setpoint range for the SI unit `unit`.

    Examples
    --------
    >>> setpoint_scale(["0 V", "10 V"], (1e5, 7e5), 1e5).setpoint_unit
    'V'
    """
    if raw is None:
        low, high = full_scale if unit == "Pa" else ELECTRIC[unit]
        return Scale(low, high, unit, *full_scale)
    if not isinstance(raw, list | tuple) or len(raw) != 2:
        raise InputError("bench.range.setpoint", "setpoint_range", given=raw)
    (low, unit), (high, high_unit) = (_read_setpoint(end, ambient) for end in raw)
    if unit != high_unit:
        raise InputError("bench.range.two_quantities", "setpoint_range", given=raw)
    return Scale(low, high, unit, *full_scale)


def _read_setpoint(raw: Any, ambient: float) -> tuple[float, str]:
    """Return the value of a setpoint in its SI unit, and this unit.

    If `raw` is a text with a pressure unit, the setpoint is a pressure. Any other text is an electric signal, and a
    number is a ratio.
    """
    problem: InputError | None = None
    for unit in ("Pa", *ELECTRIC) if isinstance(raw, str) else ("1",):
        try:
            field = Field(unit=unit, kind="pressure" if unit == "Pa" else "plain")
            return field.read(raw, "setpoint_range", ambient), unit
        except InputError as error:
            problem = problem or error
    assert problem is not None
    raise problem


def read_quantity_list(raw: str, unit: str, name: str) -> tuple[float, ...]:
    """Return the positive values of the text `raw`, for example `"1 l, 5 l"`.

    The result is in the SI unit `unit`. Commas separate the values. `name` is the option in error messages.

    Examples
    --------
    >>> read_quantity_list("1 l, 5 l", "m^3", "--volume")
    (0.001, 0.005)
    """
    values, field = [], Field(unit=unit, above=0.0, meaning=name.lstrip("-"))
    for part in raw.split(","):
        number: Any = (text := part.strip())
        with suppress(ValueError):  # a bare number is in the SI unit
            number = float(text)
        values.append(field.read(number, name))
    return tuple(values)

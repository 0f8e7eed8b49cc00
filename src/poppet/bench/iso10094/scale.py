"""Records of the bench and their scale."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import InputError, collect

FloatArray = NDArray[np.float64]
Mask = NDArray[np.bool_]
PERCENT = 100.0


@dataclass(frozen=True)
class Scale:
    """Corresponding ranges of setpoint and outlet pressure; FS is the span of the pressure.

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
        collect([InputError("bench.range.scale", name, low=a, high=b, unit=unit) for name, a, b, unit in wrong])

    @property
    def span(self) -> float:
        """Full scale FS, the span of the outlet pressure [Pa]."""
        return self.pressure_high - self.pressure_low

    def setpoint(self, percent: float | FloatArray) -> FloatArray:
        """Return the setpoint at a percentage of its range."""
        part = np.asarray(percent) / PERCENT
        return np.asarray(self.setpoint_low * (1.0 - part) + self.setpoint_high * part)  # exact at both ends

    def setpoint_percent(self, setpoint: float | FloatArray) -> FloatArray:
        """Return a setpoint as a percentage of its range."""
        width = self.setpoint_high - self.setpoint_low
        return np.asarray(PERCENT * (np.asarray(setpoint) - self.setpoint_low) / width)

    def pressure(self, percent: float | FloatArray) -> FloatArray:
        """Return the outlet pressure at a percentage of full scale."""
        return np.asarray(self.pressure_low + self.span * np.asarray(percent) / PERCENT)

    def percent(self, pressure: float | FloatArray) -> FloatArray:
        """Return an outlet pressure as a percentage of full scale."""
        return np.asarray(PERCENT * (np.asarray(pressure) - self.pressure_low) / self.span)

    def percents(self, record: Record) -> tuple[FloatArray, FloatArray]:
        """Return setpoint and outlet of a record as percentages of their ranges."""
        return self.setpoint_percent(record.setpoint), self.percent(record.outlet)


@dataclass(frozen=True, eq=False)
class Record:
    """Run of a test of a model or a real valve: channels over one time base."""

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

    def cuts(self, *series: str, part: slice = slice(None)) -> bool:
        """Return True if a part has clipped samples, of any series by default."""
        return any(bool(mask[part].any()) for name, mask in self.clipped.items() if not series or name in series)

    @property
    def step(self) -> float:
        """Usual time between samples [s]."""
        return float(np.median(np.diff(self.time)))

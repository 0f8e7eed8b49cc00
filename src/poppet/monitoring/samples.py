"""Samples of a plant: values by column, converted to readings and inputs in SI units."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from itertools import permutations
from typing import Any, NamedTuple

import numpy as np

from poppet.core.errors import InputError
from poppet.core.number_format import printable
from poppet.core.units import convert, exact_scale, sizes_of
from poppet.monitoring.plan import WatchPlan
from poppet.monitoring.sensors import DrivenInput, Readings, SensorChannel
from poppet.monitoring.stream import EXCERPT
from poppet.monitoring.twin_file import ClockColumn
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.tables.time_stamps import nanoseconds_of

_UNITS = ("Pa", "mbar", "kPa", "psi", "bar", "MPa")
UNIT_RATIOS = np.array(sorted({ratio for pair in permutations(_UNITS, 2) if (ratio := convert(1.0, *pair)) >= 50.0}))
"""Ratios of two readings of one pressure in different units; smaller ratios also occur in plants."""
LEAST_RATIO = 0.25 * float(UNIT_RATIOS[0])
"""Ratio below which two readings have the same unit."""
RATIO_TOLERANCE = 0.03
LEAST_PRESSURE = 2e4
"""Smallest pressure that is compared [Pa]: near zero, a pressure can become many times as large in one sample."""
CONFIRMATIONS = 5
"""Number of successive readings in another unit after which a message reports the change."""
BEYOND = 0.05
"""Fraction of the range of an input by which noise can exceed its limits."""
ABSOLUTE = "Pa", "K"
"""Units of quantities that cannot be negative."""
LONGEST_TIME = 1e12
"""Largest magnitude of a time [s]."""


class Sample(NamedTuple):
    """Values of one sample in SI units; NaN for missing values."""

    time: float  # [s]
    values: Sequence[float]  # (n,) readings of the sensors, then driven inputs, which are infinite if they are invalid


class SampleReader:
    """Converter of the values of a sample to SI units.

    Invalid readings are missing, and invalid inputs are infinite. The method `read` reports them.
    """

    def __init__(self, plan: WatchPlan, clock: ClockColumn) -> None:
        self.clock = clock
        self.columns: tuple[Readings, ...] = (*plan.channels, *plan.inputs)
        self.ambient_pressure = plan.instance.surroundings.pressure
        self._limits = [_limits_of(column) for column in self.columns]
        self._guards = {k: _UnitGuard(channel) for k, channel in enumerate(plan.channels) if channel.si_unit == "Pa"}
        self._first_stamp: int | None = None
        # Recordings convert times with the same two roundings.
        seconds = exact_scale(clock.unit)[0].scale
        self._seconds = float(seconds.numerator), float(seconds.denominator)
        self._absent = {column.column: 0 for column in self.columns}

    @property
    def units(self) -> dict[str, str]:
        """Mapping from all columns, including the time, to their units."""
        return {self.clock.column: self.clock.unit} | {column.column: column.unit for column in self.columns}

    def read(self, values: Mapping[str, Any], problems: list[InputError]) -> Sample:
        """Convert the values of a sample, given by column.

        Problems of single values are added to the list `problems`.

        Raises
        ------
        InputError
            If the sample has no valid time.
        """
        if not isinstance(values, Mapping):
            raise InputError("stream.no_table", value=type(values).__name__)
        time = self._time(values)
        row = []
        for k, column in enumerate(self.columns):
            raw = values.get(column.column)
            row.append(math.nan if raw is None else self._value(k, column, raw, problems))
        return Sample(time, row)

    def _time(self, values: Mapping[str, Any]) -> float:
        column = self.clock.column
        raw = values.get(column)
        if isinstance(raw, str) and (stamp := nanoseconds_of(raw)) is not None:
            if self._first_stamp is None:
                self._first_stamp = stamp
            return (stamp - self._first_stamp) / 1e9
        time = _float_of(raw) * self._seconds[0] / self._seconds[1]
        if not abs(time) <= LONGEST_TIME:
            raise InputError("stream.no_time", column, value="nothing" if raw is None else _shown(raw))
        return time

    def _value(self, k: int, column: Readings, raw: Any, problems: list[InputError]) -> float:
        number = float(raw) if raw is True or raw is False else _float_of(raw)
        if math.isnan(number):
            if not isinstance(raw, float):
                problems.append(InputError("stream.no_number", column.column, value=_shown(raw)))
                return _invalid(column)
            return math.nan
        value = column.to_si(number)
        low, high = self._limits[k]
        if not low <= value <= high:
            return self._outside(k, value, problems)
        if k in self._guards and not self._guards[k].accepts(number, problems):
            return math.nan
        return value

    def _outside(self, k: int, value: float, problems: list[InputError]) -> float:
        """Return the limit of an input that is exceeded by noise, or an invalid value with a message."""
        column, (low, high) = self.columns[k], self._limits[k]
        slack = BEYOND * (high - low) if isinstance(column, DrivenInput) and math.isfinite(high - low) else 0.0
        if low - slack <= value <= high + slack:
            return min(max(value, low), high)
        limits: dict[str, Any] = {"low": low, "high": high, "si_unit": column.si_unit}
        number = column.from_si(value)
        problems.append(InputError("stream.too_large", column.column, value=number, unit=column.unit, **limits))
        return _invalid(column)

    def plausible(self, k: int, values: FloatArray, problems: list[InputError]) -> FloatArray:
        """Return the values of column k in SI units, (n,), without values outside limits or in another unit.

        Messages are added to `problems`.
        """
        values = values.copy()
        low, high = self._limits[k]
        for row in np.flatnonzero((values < low) | (values > high)):
            values[row] = self._outside(k, float(values[row]), problems)
        guard = self._guards.get(k)
        if guard is not None and np.nanmax(values, initial=0.0) > UNIT_RATIOS[0] * LEAST_PRESSURE:
            numbers = (values - guard.channel.shift) / guard.channel.scale
            for row in np.flatnonzero(np.isfinite(numbers)):
                if not guard.accepts(float(numbers[row]), problems):
                    values[row] = math.nan
        return values


class _UnitGuard:
    """Guard against a pressure sensor whose unit becomes smaller, such as mbar instead of bar.

    A reading is not accepted if its ratio to the last accepted one is the ratio of two units of pressure. The next
    readings are not accepted until one has the size of the last accepted one. Readings that become smaller are not
    checked: a chamber that is exhausted has such readings, too.
    """

    def __init__(self, channel: SensorChannel) -> None:
        self.channel = channel
        self._least = LEAST_PRESSURE / channel.scale
        self._last = math.nan
        self._count = 0

    def accepts(self, number: float, problems: list[InputError]) -> bool:
        """Return True if the unit of a reading is that of the last accepted one."""
        ratio = number / self._last if abs(self._last) >= self._least else 0.0
        if self._count:
            is_other = ratio > LEAST_RATIO
        else:
            is_other = ratio > LEAST_RATIO and bool(np.any(np.abs(ratio / UNIT_RATIOS - 1.0) < RATIO_TOLERANCE))
        if not is_other:
            self._last, self._count = number, 0
            return True
        self._count += 1
        if self._count == CONFIRMATIONS:
            facts: dict[str, Any] = {"before": self._last, "after": number, "unit": self.channel.unit}
            problems.append(InputError("stream.unit_changed", self.channel.column, **facts))
        return False


def _invalid(column: Readings) -> float:
    """Return the mark of an invalid value: the command of a valve has changed, and a sensor has no reading."""
    return math.inf if isinstance(column, DrivenInput) else math.nan


def _limits_of(column: Readings) -> tuple[float, float]:
    """Return the smallest and the largest plausible value of a column [SI]."""
    size = sizes_of(column.si_unit)[1]
    low = 0.0 if column.si_unit in ABSOLUTE else -size
    return (max(column.low, low), min(column.high, size)) if isinstance(column, DrivenInput) else (low, size)


def _float_of(raw: Any) -> float:
    """Return a number as a float; NaN for other values, and infinity for a huge integer."""
    if type(raw) is float:  # the usual case, without the slow test of other types
        return raw
    if isinstance(raw, bool) or not isinstance(raw, int | float | np.integer | np.floating):
        return math.nan
    try:
        return float(raw)
    except OverflowError:
        return math.inf


def _shown(raw: Any) -> str:
    # Nested lists can have too many levels for a text.
    text = repr(raw[:EXCERPT] if isinstance(raw, str) else raw) if isinstance(raw, str | int | float) else "..."
    return printable(text[:EXCERPT])

"""Sensors whose reading does not change although the model expects a change."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

from poppet.core.errors import InputError
from poppet.monitoring.sensors import SensorChannel
from poppet.timeseries.checks import FloatArray

EQUAL = 20
"""Number of successive equal readings from which a sensor can be stuck."""
FEW_EQUAL = 4
"""Number of successive equal readings from which a sensor may be stuck."""
MOVED, SUSPECTED = 10.0, 5.0
"""Expected change during equal readings above which the sensor is, and may be, stuck, in standard deviations of the
noise; a coarse sensor has steps of up to 3.5 such deviations."""


class StuckSensors:
    """Guard against sensors that repeat one reading.

    Readings of a sensor with noise differ. If one repeats and the expected reading has changed by ten standard
    deviations of the noise since then, its readings are missing until it changes. At rest, a coarse sensor can repeat
    its reading without being stuck.
    """

    def __init__(self, channels: Sequence[SensorChannel]) -> None:
        n = len(channels)
        self.channels = tuple(channels)
        self._last = [math.nan] * n
        self._first_expected, self._first_times = [0.0] * n, [math.nan] * n
        self._counts = [0] * n
        self._is_reported = [False] * n
        self.new: list[
            tuple[int, float]
        ] = []  # channels found to be stuck at this sample, and times of the last change
        self.is_suspected = False  # True if a sensor may be stuck, but has few equal readings

    @property
    def is_stuck(self) -> bool:
        """True if the last reading of a sensor was stuck."""
        return any(self._is_reported)

    def without_stuck(
        self, time: float, readings: Sequence[float], expected: FloatArray, problems: list[InputError]
    ) -> Sequence[float]:
        """Return the readings of a sample at a time [s], (c,), with NaN for stuck sensors.

        `expected` contains the readings that the model expected at the last sample, (c,).
        """
        stuck: list[int] = []
        self.new, self.is_suspected = [], False
        for k, reading in enumerate(readings):
            if reading == self._last[k]:
                self._counts[k] += 1
                change = abs(expected[k] - self._first_expected[k]) / self.channels[k].noise
                if self._is_reported[k] or (change > MOVED and self._counts[k] >= EQUAL):
                    stuck.append(k)
                elif change > SUSPECTED and self._counts[k] >= FEW_EQUAL:
                    self.is_suspected = True
            elif reading == reading:
                self._last[k], self._counts[k], self._is_reported[k] = reading, 0, False
                self._first_expected[k], self._first_times[k] = float(expected[k]), time
        if not stuck:
            return readings
        for k in stuck:
            if not self._is_reported[k]:
                self._is_reported[k] = True
                self.new.append((k, self._first_times[k]))
                channel = self.channels[k]
                facts: dict[str, Any] = {"count": self._counts[k] + 1, "unit": channel.unit}
                problems.append(
                    InputError("stream.stuck", channel.column, value=channel.from_si(self._last[k]), **facts)
                )
        return [math.nan if k in stuck else reading for k, reading in enumerate(readings)]

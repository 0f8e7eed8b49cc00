"""Columns without values: sensors that fail, and inputs that a stream never contains."""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence

from poppet.core.errors import InputError
from poppet.monitoring.sensors import Readings


class AbsentValues:
    """Reporter of columns without values.

    A sensor is reported if it has no valid reading for a window. An input is reported only if it has no value in the
    first window: a stream can contain a command only when it changes.

    Parameters
    ----------
    columns : sequence of Readings
        Sensors, then inputs.
    n_channels : int
        Number of sensors.
    window : float
        Time without values after which a column is reported [s].
    """

    def __init__(self, columns: Sequence[Readings], n_channels: int, window: float) -> None:
        self.columns, self.n_channels, self.window = columns, n_channels, window
        self._last: list[float] | None = None  # time of the last value of each column, infinite after its report

    @property
    def is_blind(self) -> bool:
        """True if no sensor has had a valid reading for a window."""
        return self._last is not None and all(time == math.inf for time in self._last[: self.n_channels])

    def check(self, time: float, values: Iterable[float], problems: list[InputError]) -> None:
        """Process the values of a sample at a time [s], and add messages to `problems`."""
        if self._last is None:
            self._last = [time] * len(self.columns)
        last = self._last
        for k, value in enumerate(values):
            is_sensor = k < self.n_channels
            if value == value:
                last[k] = time if is_sensor else math.inf
            elif time - last[k] > self.window:
                code = "stream.absent" if is_sensor else "stream.no_input"
                problems.append(InputError(code, self.columns[k].column, since=time - last[k]))
                last[k] = math.inf

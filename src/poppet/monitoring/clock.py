"""Clock of a stream of samples: late, repeated and lost samples, and clocks that are set."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import NamedTuple

from poppet.core.errors import InputError

CONFIRMATIONS = 3
"""Number of successive earlier samples with increasing times after which the clock was set back."""
STEPS = 100.0
"""Number of usual sample times after which a later sample must be confirmed by the next one."""
FORGET = 0.05
"""Weight of a new sample time in the mean."""


class PlacedSample(NamedTuple):
    """Sample on the clock of the filter."""

    time: float  # [s]
    values: Sequence[float]  # (n,) NaN for values that are not newer than the last value of their column


class StreamClock:
    """Clock that increases although times of samples jump.

    A value is used if it is newer than the last value of its column. A sample with older values of all columns is
    dropped. If three such samples follow each other with increasing times, the clock was set back. The time that has
    passed is then unknown, so the filter sees a gap. A sample far ahead is used if the next sample is later still.

    Plain floats instead of arrays: a sample has few values, and a stream can have thousands of samples per second.

    Parameters
    ----------
    count : int
        Number of columns.
    longest_gap : float
        Time between two samples above which the second one must be confirmed [s].
    """

    def __init__(self, count: int, longest_gap: float) -> None:
        self.longest_gap = longest_gap
        self.latest = -math.inf  # time of the newest sample on the clock of the filter [s]
        self.offset = 0.0  # time of the filter minus time of the samples [s]
        self.step = 0.0  # mean time between samples [s]
        self._last = [-math.inf] * count
        self._earlier: list[float] = []
        self._ahead: float | None = None

    def place(self, sample_time: float, values: Sequence[float], problems: list[InputError]) -> PlacedSample | None:
        """Return a sample on the clock of the filter, or None if it cannot be used.

        Parameters
        ----------
        sample_time : float
            Time of the sample [s].
        values : (n,) sequence of float
            Value of each column; NaN for missing values.
        problems : list of InputError
            Messages on the sample, which the method adds.
        """
        time = sample_time + self.offset
        latest = self.latest
        if latest == -math.inf:
            self.latest = time
            return self._accept(time, values)
        if time > latest + max(self.longest_gap, STEPS * self.step):
            return self._use_if_confirmed(time, values, problems)
        if self._ahead is not None:
            problems.append(InputError("stream.clock_ahead", time=self._ahead, last=latest - self.offset))
            self._ahead = None
        if time > latest:
            self._earlier.clear()
            return self._accept(time, values)
        last = self._last
        new = [value if time > last[k] else math.nan for k, value in enumerate(values)]
        n_present, n_new = (sum(value == value for value in row) for row in (values, new))
        if not n_new:
            return self._use_if_set_back(sample_time, values, problems)
        self._earlier.clear()
        if n_new < n_present:
            problems.append(InputError("stream.clock_partly", time=sample_time, last=latest - self.offset))
        return self._accept(time, new)

    def _accept(self, time: float, values: Sequence[float]) -> PlacedSample:
        last = self._last
        for k, value in enumerate(values):
            if value == value:
                last[k] = time
        if time > self.latest:
            self.step += (FORGET if self.step else 1.0) * (time - self.latest - self.step)
            self.latest = time
        return PlacedSample(time, values)

    def _use_if_confirmed(
        self, time: float, values: Sequence[float], problems: list[InputError]
    ) -> PlacedSample | None:
        """Use a sample that is far ahead if the sample before it was far ahead, too."""
        sample_time = time - self.offset
        if self._ahead is None or sample_time <= self._ahead:
            self._ahead = sample_time
            return None
        last, self._ahead = self.latest - self.offset, None
        problems.append(InputError("stream.gap", time=sample_time, last=last, gap=sample_time - last))
        self._earlier.clear()
        step = self.step
        placed = self._accept(time, values)
        self.step = step
        return placed

    def _use_if_set_back(
        self, sample_time: float, values: Sequence[float], problems: list[InputError]
    ) -> PlacedSample | None:
        """Use a sample that is too early if it is the third one with increasing times."""
        last = self.latest - self.offset
        if self._earlier and sample_time <= self._earlier[-1]:
            self._earlier.clear()
        self._earlier.append(sample_time)
        if len(self._earlier) < CONFIRMATIONS:
            code = "stream.clock_equal" if sample_time == last else "stream.clock_back"
            problems.append(InputError(code, time=sample_time, last=last))
            return None
        self._earlier.clear()
        problems.append(InputError("stream.clock_set", time=sample_time, last=last))
        step, time = self.step, self.latest + self.longest_gap
        self.offset = time - sample_time
        placed = self._accept(time, values)
        self.step = step
        return placed

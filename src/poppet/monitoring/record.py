"""Record of a watch: estimates, probabilities and alarms of each sample of a recording."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import IO, Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.files import write_whole
from poppet.monitoring.plan import WatchPlan

Array = NDArray[np.float64]

TIME = "time [s]"
"""Column of the time."""
BLOCK = 10_000
"""Number of rows that are converted to text together."""


def result_columns(plan: WatchPlan) -> tuple[str, ...]:
    """Return the names of the columns of the results, which are also the keys of JSON lines.

    They are the time, the value, standard deviation and probability of each fault, the NIS and the alarm.
    """
    columns = [TIME]
    for fault in plan.faults:
        columns += [f"{fault.name} [{fault.unit}]", f"{fault.name}.sigma", f"{fault.name}.probability"]
    return (*columns, "nis", "alarm")


def rounded_number(value: float) -> float | None:
    """Return a number with nine significant digits, or None if it is not finite."""
    return float(f"{value:.9g}") if math.isfinite(value) else None


@dataclass(frozen=True)
class AlarmEpisode:
    """Time from the start of an alarm to its end.

    Parameters
    ----------
    faults : tuple of str
        Names of the faults that can be the cause.
    start, end : float
        Times of the first and the last sample with the alarm [s].
    is_open : bool
        True if the record ends during the alarm.
    last : int
        Index of the last sample with the alarm.
    are_joint : bool
        True if the faults are present together. Otherwise one of them is the cause.
    """

    faults: tuple[str, ...]
    start: float
    end: float
    is_open: bool
    last: int
    are_joint: bool = False


@dataclass(frozen=True, eq=False)
class WatchRecord:
    """Estimates of a watch for all samples of a recording.

    Values are in SI units, and pressures are absolute. Samples that could not be used, because their time is not valid,
    have no row.

    Parameters
    ----------
    plan : WatchPlan
        Sensors, faults and settings.
    time : ndarray
        Times of the samples, (n,) [s].
    values, sigmas, probabilities : ndarray
        Value and standard deviation of each fault, and the probability that it is present, (n, n_faults).
    nis : ndarray
        Normalised innovation squared of each sample, (n,); NaN without readings.
    counts : ndarray
        Number of readings that the filter used, (n,): the mean of `nis` for a correct model.
    alarms : tuple of str
        Alarm of each sample: empty, names of possible faults joined by " or ", or of simultaneous ones by " and ".
    readings, expected, deviations : ndarray
        Readings, their predictions, and the standard deviations of the differences, (n, n_channels). A reading is NaN
        if it is missing.
    used : ndarray
        1 for readings that the filter used, 0 for missing ones, -1 for outliers, (n, n_channels).
    verdicts : tuple
        Pairs of a time and a note, for each change of the verdict.
    notes : tuple of Note
        Notes on the recording.
    title : str
        Title.
    is_complete : bool
        False if the user interrupted the evaluation.
    """

    plan: WatchPlan = field(repr=False)
    time: Array
    values: Array
    sigmas: Array
    probabilities: Array
    nis: Array
    counts: NDArray[np.int64]
    alarms: tuple[str, ...]
    readings: Array = field(repr=False)
    expected: Array = field(repr=False)
    deviations: Array = field(repr=False)
    used: NDArray[np.int8] = field(repr=False)
    verdicts: tuple[tuple[float, Note], ...] = ()
    notes: tuple[Note, ...] = ()
    title: str = ""
    is_complete: bool = True

    def __len__(self) -> int:
        return int(self.time.size)

    @property
    def columns(self) -> tuple[str, ...]:
        """Names of the columns of the CSV file."""
        return result_columns(self.plan)

    @property
    def episodes(self) -> tuple[AlarmEpisode, ...]:
        """Alarms with their start and end, in order of time."""
        episodes: list[AlarmEpisode] = []
        first = 0
        for k, alarm in enumerate(self.alarms):
            is_last = k + 1 == len(self.alarms)
            if alarm and (is_last or self.alarms[k + 1] != alarm):
                are_joint = " and " in alarm
                names = tuple(alarm.split(" and " if are_joint else " or "))
                start, end = float(self.time[first]), float(self.time[k])
                episodes.append(AlarmEpisode(names, start, end, is_last, k, are_joint))
            if not is_last and self.alarms[k + 1] != alarm:
                first = k + 1
        return tuple(episodes)

    def save(self, path: str | Path) -> None:
        """Write one row per sample to a `.csv` file.

        The columns are `time [s]`, for each fault `<fault> [unit]`, `<fault>.sigma` and `<fault>.probability`, then
        `nis` and `alarm`. The function replaces an existing file completely or not at all.

        Parameters
        ----------
        path : str or Path
            Output file.

        Raises
        ------
        InputError
            If the file cannot be written, or the record has no rows.
        """
        if not len(self):
            raise InputError("files.no_rows", path=str(path))
        write_whole(Path(path), self._write)

    def _write(self, stream: IO[bytes]) -> None:
        stream.write(_csv_rows([self.columns]))
        for first in range(0, len(self), BLOCK):
            stream.write(_csv_rows(self._rows(slice(first, first + BLOCK))))

    def _rows(self, rows: slice) -> Iterator[Sequence[Any]]:
        faults = np.stack([self.values[rows], self.sigmas[rows], self.probabilities[rows]], axis=2)
        numbers = np.column_stack([faults.reshape(len(faults), -1), self.nis[rows]])
        for time, row, alarm in zip(self.time[rows].tolist(), numbers.tolist(), self.alarms[rows], strict=True):
            yield [repr(time), *map(rounded_number, row), alarm]


def _csv_rows(rows: Any) -> bytes:
    text = io.StringIO()
    csv.writer(text, lineterminator="\n").writerows(rows)
    return text.getvalue().encode()

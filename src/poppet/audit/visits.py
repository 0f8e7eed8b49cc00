"""Visits of a sequence to its steps, from the recording of a run."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from poppet.timeseries.recording import Recording


class Visit(NamedTuple):
    """Visit of a sequence to a step; it can last to the end of the run."""

    step: int  # number of the step, from 1 on
    start: float  # [s]
    end: float


def visits_of(recording: Recording, name: str) -> list[Visit]:
    """Return the visits of a sequence to its steps.

    Their starts are exact, also between two rows. A visit without a row is omitted.
    """
    step, time = np.rint(recording[f"{name}.step"]).astype(int), recording.time
    rows = np.flatnonzero(np.diff(step, prepend=step[0] - 1))
    starts = np.maximum(time[rows] - recording[f"{name}.elapsed"][rows], 0.0)
    ends = np.append(starts[1:], time[-1])
    return [Visit(int(n), float(a), float(b)) for n, a, b in zip(step[rows], starts, ends, strict=True)]

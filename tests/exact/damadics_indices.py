"""Performance indices of the DAMADICS benchmark, from the integrals of appendix II of its definition (version 1.0).

The signals have one value per row, which is valid until the next row. An index that has no value is nan, where the
calculator of the benchmark library has -1.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

T_ON, T_FROM = 300.0, 900.0  # start of the scored time, and of the fault [s]


class Indices(NamedTuple):
    """Indices of one scenario, with the names of the definition."""

    t_dt: float  # detection time: from the start of the fault to the last leading edge of the detection [s]
    r_fd: float  # false detection rate: fraction of the time before the fault with a detection
    r_td: float  # true detection rate: fraction of the time after the start of the fault with a detection
    fs_d: float  # strength of the fault at the last leading edge of the detection
    t_it: float  # isolation time [s]
    r_fi: float  # false isolation rate
    r_ti: float  # true isolation rate
    r_mi: float  # mismatch isolation rate: mean number of other diagnoses in the decision
    fs_i: float  # strength of the fault at the last leading edge of the isolation
    d_acc: float  # diagnosis accuracy: 1 / number of faults in the decision at the last leading edge of the isolation


def indices(
    time: np.ndarray, strength: np.ndarray, detection: np.ndarray, primary: np.ndarray, other: np.ndarray,
    indicated: np.ndarray, t_hor: float, *, t_on: float = T_ON, t_from: float = T_FROM,
) -> Indices:  # fmt: skip
    """Return the indices of a scenario.

    `detection` and `primary` are true if a fault is detected, and if the decision contains the true diagnosis. `other`
    is the number of other diagnoses in the decision, and `indicated` the number of faults in it. The scored time is
    from `t_on` to `t_hor`; the fault starts at `t_from`.
    """

    def rate(signal: np.ndarray, start: float, end: float) -> float:
        low, high = np.clip(time, start, end), np.clip(np.append(time[1:], time[-1]), start, end)
        return float(np.sum((high - low) * signal) / (end - start))

    def last_edge(signal: np.ndarray) -> int | None:
        rises = np.flatnonzero(np.diff(np.concatenate([[0], signal.astype(int)])) > 0)
        rises = rises[(time[rises] >= t_from) & (time[rises] <= t_hor)]
        return int(rises[-1]) if rises.size else None

    def at(edge: int | None, values: np.ndarray) -> float:
        return float("nan") if edge is None else float(values[edge])

    detected, isolated = last_edge(detection), last_edge(primary)
    count = at(isolated, indicated)
    return Indices(
        t_dt=at(detected, time) - t_from,
        r_fd=rate(detection, t_on, t_from),
        r_td=rate(detection, t_from, t_hor),
        fs_d=at(detected, np.abs(strength)),
        t_it=at(isolated, time) - t_from,
        r_fi=rate(primary, t_on, t_from),
        r_ti=rate(primary, t_from, t_hor),
        r_mi=rate(other, t_on, t_hor),
        fs_i=at(isolated, np.abs(strength)),
        d_acc=1.0 / count if count > 0 else float("nan"),
    )

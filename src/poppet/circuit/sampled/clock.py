"""Clocks of a sampled circuit: periods, sample instants, and common sample time."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import gcd, lcm

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.core.errors import SimulationError
from poppet.engine.kernel import Kernel
from poppet.parts.part import NEVER

Array = NDArray[np.float64]

TICKS = 3
"""Minimum number of evaluated instants of each clock."""
MAX_INSTANTS = 20_000
MAX_RATIO = 1000
"""Largest denominator of the ratio of two sample times."""
SAME = 1e-9
"""Relative difference below which times are equal."""


@dataclass(frozen=True, eq=False)
class Clock:
    """Sequence of sample instants, which repeats after the common period of all clocks.

    Clocks are periodic timers of controllers.
    """

    sample_time: float  # period of the pattern of instants [s]
    times: Array  # (m,) instants since the beginning of a sample, the first is 0 [s]
    fired: Array  # (m, n_timers) 1 for each timer that acts at the instant
    counts: NDArray[np.bool_]  # (n_memory,) timers, counters and held states, which do not depend on the circuit
    memory: Array  # (n_memory,) discrete state at `start`; only the clocks are valid
    start: float  # beginning of a sample after the first ticks [s]: a controller can treat its first sample differently


def find_clock(kernel: Kernel, x: Array, u: Array, p: Array) -> Clock:
    """Return the sequence of sample instants of a circuit by running its timers.

    x, u and p are the initial state, the constant inputs and the parameter vector of `kernel`.
    """
    model = kernel.model
    counts = np.array(model.counting(u.tolist()), dtype=np.bool_)
    names = [name for name, _ in model.memory[: model.n_timers]]
    ticks, _ = _run_timers(kernel, x, u, p, counts)
    running = [k for k in range(model.n_timers) if ticks[k]]
    if not running:
        raise SimulationError(Note("sampled.no_clock"))
    periods = {}
    for k in running:
        lengths = np.diff(ticks[k])
        if not lengths.size or lengths[0] <= 0.0 or np.ptp(lengths) > SAME * lengths[0]:
            raise SimulationError(Note("sampled.irregular", names[k]))
        periods[k] = float(lengths[0])
    # The common period. Periods are decimals with rounding errors; their ratios are ratios of small integers, or there
    # is no common period.
    shortest = min(periods.values())
    ratios = {k: Fraction(period / shortest).limit_denominator(MAX_RATIO) for k, period in periods.items()}
    for k, ratio in ratios.items():
        if abs(float(ratio) * shortest - periods[k]) > SAME * periods[k]:
            first = min(periods, key=periods.__getitem__)
            facts = {"period": periods[k], "other": names[first], "shortest": shortest}
            raise SimulationError(Note("sampled.no_common_period", names[k], **facts))
    multiple = Fraction(lcm(*(r.numerator for r in ratios.values())), gcd(*(r.denominator for r in ratios.values())))
    repeats = {k: int(multiple / ratio) for k, ratio in ratios.items()}
    sample, instants = float(multiple) * shortest, sum(repeats.values())
    if instants > MAX_INSTANTS:
        raise SimulationError(Note("sampled.too_many_instants", period=sample, instants=instants))
    # At the start of a run, or at the first tick of the last clock.
    begin = max(ticks[k][0] for k in running)
    pattern: list[tuple[float, int]] = []
    for k in running:
        # Phases between clocks are constant.
        offset = (ticks[k][0] - begin) % periods[k]
        offset = 0.0 if min(offset, periods[k] - offset) < SAME * periods[k] else offset
        pattern += [(offset + j * periods[k], k) for j in range(repeats[k])]
    times: list[float] = []
    fired: list[Array] = []
    for time, k in sorted(pattern):
        if not times or time - times[-1] > SAME * sample / len(pattern):
            times.append(time)
            fired.append(np.zeros(model.n_timers))
        fired[-1][k] = 1.0
    # After all evaluated ticks, at the beginning of a sample.
    last = max(max(times_of_clock) for times_of_clock in ticks if times_of_clock)
    start = begin + np.ceil((last - begin) / sample + SAME) * sample
    _, memory = _run_timers(kernel, x, u, p, counts, end=start - SAME * sample)
    return Clock(sample, np.array(times), np.array(fired), counts, memory, float(np.min(memory[running])))


def _run_timers(
    kernel: Kernel, x: Array, u: Array, p: Array, counts: NDArray[np.bool_], end: float | None = None
) -> tuple[list[list[float]], Array]:
    """Run only the timers of a circuit.

    The result contains the instants of each timer, and the final discrete state. The states x, the inputs u and the
    parameters in p are constant. `counts` is a mask of the discrete states that are timers or counters. The timers run
    up to the time `end` [s]. If it is None, they run until each has at least `TICKS` instants.
    """
    n = kernel.model.n_timers
    p, z, fired = p.copy(), np.empty(len(kernel.model.memory)), np.zeros(n)
    memory = p[len(kernel.model.parameters) :]
    ticks: list[list[float]] = [[] for _ in range(n)]
    for _ in range(2 * MAX_INSTANTS):
        instants = np.where(counts[:n], memory[:n], np.inf)
        now = float(np.min(instants, initial=np.inf))
        # A timer that is set to NEVER does not tick.
        is_complete = all(len(ticks[k]) >= TICKS for k in range(n) if counts[k] and memory[k] < NEVER)
        if now >= NEVER or (is_complete if end is None else now >= end):
            break
        fired[:] = instants <= now + 1e-14 * now + 1e-15
        for k in np.flatnonzero(fired):
            ticks[k].append(now)
        kernel.call("update", np.array([now]), x, u, p, fired, z)
        memory[:] = z
    return ticks, memory.copy()

"""The clocks of a circuit: which elements of its memory only count, when they tick, and after what time all repeats."""

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
"""Instants of the slowest clock that are looked at."""
MOST_INSTANTS = 20_000
LARGEST_RATIO = 1000
"""Whole numbers up to this one are tried for the ratio of two sample times."""
SAME = 1e-9
"""Times that differ by less than this part are one."""


@dataclass(frozen=True, eq=False)
class Clock:
    """The instants of a circuit over one sample of all its clocks together."""

    sample_time: float  # time after which the pattern of instants repeats [s]
    times: Array  # (m,) instants from the beginning of a sample, the first is 0 [s]
    fired: Array  # (m, n_timers) 1 for each timer that acts then
    # (n_memory,) elements of the memory that are timers or counters of their own, whatever the circuit does
    counts: NDArray[np.bool_]
    memory: Array  # (n_memory,) memory at `start`, of which only the clocks mean something
    start: float  # beginning of a sample after the first ticks [s]: a program may treat its very first sample otherwise


def clock_of(kernel: Kernel, x: Array, u: Array, p: Array) -> Clock:
    """Watch the clocks of a circuit tick."""
    model = kernel.model
    counts = np.array(model.counting, dtype=np.bool_)
    names = [name for name, _ in model.memory[: model.n_timers]]
    ticks, _ = _ticks(kernel, x, u, p, counts)
    running = [k for k in range(model.n_timers) if ticks[k]]
    if not running:
        raise SimulationError(Note("sampled.no_clock"))
    periods = {k: _period(names[k], ticks[k]) for k in running}
    sample, repeats = _common(periods, names)
    # As at the start of a run, or where the last clock has begun.
    begin = max(ticks[k][0] for k in running)
    pattern: list[tuple[float, int]] = []
    for k in running:
        # Phases between clocks stay as they began.
        offset = (ticks[k][0] - begin) % periods[k]
        offset = 0.0 if min(offset, periods[k] - offset) < SAME * periods[k] else offset
        pattern += [(offset + j * periods[k], k) for j in range(repeats[k])]
    times, fired = _merged(sorted(pattern), sample, model.n_timers)
    # Past all ticks that were watched, on the border of a sample of all clocks together.
    last = max(max(each) for each in ticks if each)
    start = begin + np.ceil((last - begin) / sample + SAME) * sample
    _, memory = _ticks(kernel, x, u, p, counts, until=start - SAME * sample)
    return Clock(sample, times, fired, counts, memory, float(np.min(memory[running])))


def _ticks(
    kernel: Kernel, x: Array, u: Array, p: Array, counts: NDArray[np.bool_], until: float | None = None
) -> tuple[list[list[float]], Array]:
    """Instants of every clock from the start on, until the slowest has ticked `TICKS` times or a time has come."""
    n = kernel.model.n_timers
    p, z, fired = p.copy(), np.empty(len(kernel.model.memory)), np.zeros(n)
    memory = p[len(kernel.model.parameters) :]
    ticks: list[list[float]] = [[] for _ in range(n)]
    for _ in range(2 * MOST_INSTANTS):
        next_ = np.where(counts[:n], memory[:n], np.inf)
        now = float(np.min(next_, initial=np.inf))
        # A timer that is set to NEVER is no clock now, and must not be waited for.
        enough = all(len(ticks[k]) >= TICKS for k in range(n) if counts[k] and memory[k] < NEVER)
        if now >= NEVER or (enough if until is None else now >= until):
            break
        fired[:] = next_ <= now + 1e-14 * now + 1e-15
        for k in np.flatnonzero(fired):
            ticks[k].append(now)
        kernel.call("update", np.array([now]), x, u, p, fired, z)
        memory[:] = z
    return ticks, memory.copy()


def _period(name: str, ticks: list[float]) -> float:
    lengths = np.diff(ticks)
    if not lengths.size or lengths[0] <= 0.0 or np.ptp(lengths) > SAME * lengths[0]:
        raise SimulationError(Note("sampled.irregular", name))
    return float(lengths[0])


def _common(periods: dict[int, float], names: list[str]) -> tuple[float, dict[int, int]]:
    """The time after which all clocks tick together again, and how often each ticks in it."""
    shortest = min(periods.values())
    # Periods are decimals that no double holds; their ratios are small whole numbers or none.
    ratios = {k: Fraction(period / shortest).limit_denominator(LARGEST_RATIO) for k, period in periods.items()}
    for k, ratio in ratios.items():
        if abs(float(ratio) * shortest - periods[k]) > SAME * periods[k]:
            first = min(periods, key=lambda each: periods[each])
            facts = {"period": periods[k], "other": names[first], "shortest": shortest}
            raise SimulationError(Note("sampled.no_common_period", names[k], **facts))
    whole = Fraction(lcm(*(r.numerator for r in ratios.values())), gcd(*(r.denominator for r in ratios.values())))
    repeats = {k: int(whole / ratio) for k, ratio in ratios.items()}
    instants = sum(repeats.values())
    if instants > MOST_INSTANTS:
        raise SimulationError(Note("sampled.too_many_instants", period=float(whole) * shortest, instants=instants))
    return float(whole) * shortest, repeats


def _merged(pattern: list[tuple[float, int]], sample: float, n_timers: int) -> tuple[Array, Array]:
    times: list[float] = []
    fired: list[Array] = []
    for time, k in pattern:
        if not times or time - times[-1] > SAME * sample / len(pattern):
            times.append(time)
            fired.append(np.zeros(n_timers))
        fired[-1][k] = 1.0
    return np.array(times), np.array(fired)

"""Plausibility checks of a recording.

Each check returns notes on suspicions with their evidence, which the user must verify at the test bench.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from poppet.core.codes import Note
from poppet.core.units import convert, same_dimension
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements.delays import late_input, slow_sensor
from poppet.timeseries.measurements.measurement import Channel, InputChannel, noise_of

# Limits relative to the ambient pressure: _LOW, _NEAR, _ZERO.
_LOW = 0.3  # compressed-air circuits are rarely in steady state below this pressure
_HIGH = 16e5  # upper limit in data sheets of compressed-air components [Pa]
_COLDEST, _HOTTEST = 150.0, 800.0  # [K]
_NEAR = 0.05
_ZERO = 0.1  # largest offset of a gauge at ambient pressure; a gauge of a real bench showed 8 kPa
_LOWEST = 0.05  # fraction of the samples in the lowest level
_SHORTEST_RUN = 5  # samples at one extreme value
_DITHER = 0.5  # noise in steps that lets a mean resolve values between two steps
_GAP = 3.0  # in median steps
_UNEVEN = 0.5  # spread of the steps, relative to their median
_LONG_STEP, _MANY_STAMPS = 5.0, 30  # integer times with such steps [s] can be milliseconds


def verdicts(
    channels: Sequence[Channel], inputs: Sequence[InputChannel], ambient_pressure: float, gauge: frozenset[str]
) -> list[Note]:
    """Check a recording for implausible values, and return notes.

    `gauge` contains the addresses of channels that were recorded as gauge pressures.
    """
    notes: list[Note] = []
    doubtful: set[str] = set()
    for channel in channels:
        if channel.unit == "Pa":
            suspicions = pressure_verdicts(channel, ambient_pressure, is_gauge=channel.address in gauge)
            doubtful |= {channel.address} if suspicions else set()
            notes += suspicions
        lowest, highest = float(np.min(channel.values)), float(np.max(channel.values))
        if channel.unit == "K" and not _COLDEST <= lowest <= highest <= _HOTTEST:
            notes.append(Note("suspicion.no_temperature", channel.address, lowest=lowest, highest=highest))
        notes += value_verdicts(channel)
    notes += time_verdicts(channels)
    end = max(float(channel.time[-1]) for channel in channels)
    for item in inputs:
        first, last = float(item.time[0]), float(item.time[-1])
        slack = _GAP * float(np.median(np.diff(item.time))) if item.time.size > 1 else 0.0
        if first > slack or last < end - slack:
            notes.append(Note("suspicion.coverage", item.address, start=first, stop=last, end=end))
    # With a misread pressure, every flow looks late and every temperature sensor looks slow.
    sound = [channel for channel in channels if channel.address not in doubtful]
    for channel in channels:
        notes += slow_sensor(channel, sound)
    for item in inputs:
        notes += late_input(item, sound)
    return notes


def heading_verdicts(address: str, name: str, heading: str, unit: str) -> list[Note]:
    """Return a note if a column heading states another unit than the user.

    `unit` is the unit that the user states for the column `name`.

    Examples
    --------
    >>> heading_verdicts("tank.pressure", "P1", "psi", "psi g")
    []
    >>> heading_verdicts("tank.pressure", "P1", "psi", "bar g")
    [Note('suspicion.other_unit', 'tank.pressure', column='P1', heading='psi', unit='bar g')]
    """
    if not heading or (same_dimension(heading, unit) and _scale(heading, unit) == 1.0):
        return []
    return [Note("suspicion.other_unit", address, column=name, heading=heading, unit=unit)]


def _scale(first: str, second: str) -> float:
    return round(convert(1.0, first, second) - convert(0.0, first, second), 9)


def pressure_verdicts(channel: Channel, ambient_pressure: float, *, is_gauge: bool) -> list[Note]:
    """Check whether a pressure is plausible, and return notes.

    For example, a gauge pressure that was read as absolute gives a note.
    """
    lowest, highest, address = float(np.min(channel.values)), float(np.max(channel.values)), channel.address
    # The median of the lowest samples is robust to single noisy samples.
    level = float(np.median(np.sort(channel.values)[: max(3, int(_LOWEST * channel.values.size))]))
    if is_gauge and lowest < 0.0:
        return [Note("suspicion.below_vacuum", address, lowest=lowest)]
    is_low = level < _LOW * ambient_pressure and not is_evacuated(channel.values, ambient_pressure)
    if lowest < 0.0 or (not is_gauge and is_low):
        return [Note("suspicion.read_as_absolute", address, lowest=min(lowest, 0.0) or level, ambient=ambient_pressure)]
    if lowest > _HIGH:
        return [Note("suspicion.high_pressure", address, lowest=lowest, highest=highest)]
    # An absolute pressure at rest that was read as gauge equals the ambient pressure.
    rest_pressure = level - ambient_pressure
    moves = highest - level > 0.5 * ambient_pressure
    if is_gauge and moves and abs(rest_pressure - ambient_pressure) < _NEAR * ambient_pressure:
        return [Note("suspicion.read_as_gauge", address, lowest=rest_pressure, ambient=ambient_pressure)]
    return []


def is_evacuated(values: FloatArray, ambient_pressure: float) -> bool:
    """Return True if an absolute pressure starts in a vacuum and then rises.

    The first value must be near the minimum. It must also be too high for a gauge reading of 0, unless all values are
    below or near the ambient pressure.

    Examples
    --------
    >>> is_evacuated(np.linspace(0.2e5, 6e5, 1000), 1e5), is_evacuated(np.linspace(0.0, 1e5, 1000), 1e5)
    (True, True)
    >>> is_evacuated(np.linspace(0.0, 6e5, 1000), 1e5), is_evacuated(np.linspace(6e5, 0.1e5, 1000), 1e5)
    (False, False)
    """
    begin, highest = float(np.min(values[:3])), float(np.max(values))
    rises = begin - np.min(values) < 0.1 * (highest - np.min(values))
    return bool(rises and (begin > _ZERO * ambient_pressure or highest < (1.0 + _NEAR) * ambient_pressure))


def value_verdicts(channel: Channel) -> list[Note]:
    """Check whether a channel is constant, clipped or coarsely resolved, and return notes."""
    values, address, unit = channel.values, channel.address, channel.unit
    if float(np.ptp(values)) == 0.0:
        return [Note("suspicion.constant", address, value=float(values[0]), unit=unit, samples=values.size)]
    noise, range_ = noise_of(values, channel.time), float(np.ptp(values))
    notes = []
    if channel.quantum > 0.0 and noise < _DITHER * channel.quantum and channel.quantum > 1e-3 * range_:
        facts = {"step": channel.quantum, "share": channel.quantum / range_, "noise": noise, "unit": unit}
        notes.append(Note("suspicion.coarse", address, **facts))
    for level, extreme in ((float(np.max(values)), "highest"), (float(np.min(values)), "lowest")):
        runs = _runs(values, level)
        if not runs or level == 0.0:  # zero is a regular value: no flow, or closed
            continue
        step = max(channel.quantum, 1e-6 * range_)
        if is_stuck_at(values, level, channel.quantum) or any(cuts_a_peak(values, run, step) for run in runs):
            count = max(stop - start for start, stop in runs)
            notes.append(Note("suspicion.clipped", address, which=extreme, value=level, unit=unit, samples=count))
    return notes


def _runs(values: FloatArray, level: float) -> list[tuple[int, int]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[False], values == level, [False]]).astype(int)))
    shortest = max(_SHORTEST_RUN, values.size // 200)
    return [(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True) if b - a >= shortest]


def is_stuck_at(values: FloatArray, level: float, quantum: float) -> bool:
    """Return True if a noisy series remains at exactly one value for some time.

    `level` is this value, and `quantum` the resolution. Such a section indicates a clipped series. The result for the
    level 0 is False, because zero is a usual value.
    """
    runs = _runs(values, level)
    if not runs or level == 0.0:
        return False
    start, stop = max(runs, key=lambda run: run[1] - run[0])
    moving = np.concatenate([values[:start], values[stop:]])
    noise = noise_of(moving)
    # Without every second sample, noise stays the same, but a smooth curve has four times the curvature.
    return noise > max(quantum, 1e-6 * float(np.ptp(values))) and noise_of(moving[::2]) < 2.0 * noise


def cuts_a_peak(values: FloatArray, run: tuple[int, int], step: float) -> bool:
    """Return True if a constant section between two steep flanks indicates a clipped peak.

    `run` contains the first index of the section and the index after its last sample. `step` is the resolution of the
    values.
    """
    start, stop = run
    if start == 0 or stop == values.size:
        return False
    return bool(min(abs(values[start - 1] - values[start]), abs(values[stop] - values[start])) > 3.0 * step)


def time_verdicts(channels: Sequence[Channel]) -> list[Note]:
    """Check the sample times of all channels, and return notes.

    The notes report gaps, uneven steps, and milliseconds that were read as seconds. Channels with the same times are
    checked once.
    """
    notes: list[Note] = []
    clocks: dict[bytes, Channel] = {}
    for channel in channels:
        clocks.setdefault(channel.time.tobytes(), channel)
    for channel in clocks.values():
        address, time = channel.address, channel.time
        steps = np.diff(time)
        median = float(np.median(steps))
        gaps = np.flatnonzero(steps > _GAP * median)
        if gaps.size:
            k = int(gaps[np.argmax(steps[gaps])])
            facts = {"limit": _GAP, "median": median, "longest": float(steps[k]), "start": float(time[k])}
            notes.append(Note("suspicion.gaps", address, count=gaps.size, **facts))
        low, high = np.percentile(steps, [5.0, 95.0])
        if high - low > _UNEVEN * median:
            notes.append(Note("suspicion.uneven", address, shortest=float(low), longest=float(high), median=median))
        jitter = float(np.ptp(steps)) > 0.0
        if median >= _LONG_STEP and time.size >= _MANY_STAMPS and jitter and bool(np.all(steps == np.rint(steps))):
            notes.append(Note("suspicion.milliseconds", address, step=median, total=float(time[-1])))
    return notes

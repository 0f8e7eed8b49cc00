"""What looks wrong with a recording, in sentences with their evidence: suspicions, to be checked at the bench."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from poppet.ground.units import convert, same_dimension
from poppet.series.checks import FloatArray
from poppet.series.measured.lateness import late_input, slow_sensor
from poppet.series.measured.measurement import Channel, InputChannel
from poppet.series.measured.noise import noise_of, quantum_of

__all__ = ["heading_verdicts", "noise_of", "quantum_of", "verdicts"]

_LOW = 0.3  # of the ambient pressure: circuits for compressed air seldom rest below
_HIGH = 16e5  # Pa: where the data sheets of components for compressed air end
_COLDEST, _HOTTEST = 150.0, 800.0  # K
_NEAR = 0.05  # of the ambient pressure
_LOWEST = 0.05  # share of the samples that make the lowest level
_SHORTEST_RUN = 5  # samples at one extreme value
_DITHER = 0.5  # steps: noise of so much lets a mean resolve what lies between two steps
_GAP = 3.0  # steps
_UNEVEN = 0.5  # spread of the steps over their median
_LONG_STEP, _MANY_STAMPS = 5.0, 30  # s; whole seconds this far apart may be milliseconds


def verdicts(
    channels: Sequence[Channel], inputs: Sequence[InputChannel], ambient_pressure: float, gauge: frozenset[str]
) -> list[str]:
    """All suspicions about a recording."""
    found: list[str] = []
    doubtful: set[str] = set()
    for channel in channels:
        if channel.unit == "Pa":
            suspicions = pressure_verdicts(channel, ambient_pressure, is_gauge=channel.address in gauge)
            doubtful |= {channel.address} if suspicions else set()
            found += suspicions
        if channel.unit == "K":
            found += temperature_verdicts(channel)
        found += value_verdicts(channel)
    found += time_verdicts(channels)
    found += _coverage(channels, inputs)
    sound = [channel for channel in channels if channel.address not in doubtful]
    for channel in channels:
        found += slow_sensor(channel, sound)
    for item in inputs:
        found += late_input(item, sound)
    return found


def heading_verdicts(address: str, name: str, heading: str, unit: str) -> list[str]:
    """A heading that states another unit than the one in which its column is read.

    Examples
    --------
    >>> heading_verdicts("tank.pressure", "P1", "psi", "psi g")
    []
    >>> heading_verdicts("tank.pressure", "P1", "psi", "bar g")
    ['tank.pressure is read as bar g, but the heading of column "P1" says psi.']
    """
    if not heading or (same_dimension(heading, unit) and _scale(heading, unit) == 1.0):
        return []
    return [f'{address} is read as {unit}, but the heading of column "{name}" says {heading}.']


def _scale(first: str, second: str) -> float:
    return round(convert(1.0, first, second) - convert(0.0, first, second), 9)


def pressure_verdicts(channel: Channel, ambient_pressure: float, *, is_gauge: bool) -> list[str]:
    """Gauge against absolute, and numbers that are no pressures."""
    lowest, highest = float(np.min(channel.values)), float(np.max(channel.values))
    address, against = channel.address, f"{_bar(ambient_pressure)} of the ambient"
    level = _lowest_level(channel.values)
    if is_gauge and lowest < 0.0:
        return [f"{address} falls to {_bar(lowest)} absolute, below vacuum: was it recorded as gauge at all?"]
    if lowest < 0.0 or (not is_gauge and level < _LOW * ambient_pressure):
        shown = _bar(min(lowest, 0.0) or level)
        return [
            f"{address} falls to {shown} absolute against {against}: a gauge pressure read as absolute? "
            'Then write its unit with "g", "bar g".'
        ]
    if lowest > _HIGH:
        return [
            f"{address} reads {_bar(lowest)} to {_bar(highest)} absolute, above compressed air: is its column swapped, "
            "with a temperature say, or its unit another?"
        ]
    rest = level - ambient_pressure
    moves = highest - level > 0.5 * ambient_pressure
    if is_gauge and moves and abs(rest - ambient_pressure) < _NEAR * ambient_pressure:
        return [
            f"{address} does not fall below {_bar(rest)} gauge, which is about the {against}: an absolute pressure "
            'read as gauge? Then write its unit without "g".'
        ]
    return []


def _lowest_level(values: FloatArray) -> float:
    """Median of the lowest samples: one that is struck by noise does not decide."""
    count = max(3, int(_LOWEST * values.size))
    return float(np.median(np.sort(values)[:count]))


def temperature_verdicts(channel: Channel) -> list[str]:
    """Numbers that are no temperatures of a gas in use."""
    lowest, highest = float(np.min(channel.values)), float(np.max(channel.values))
    if lowest >= _COLDEST and highest <= _HOTTEST:
        return []
    return [
        f"{channel.address} reads {lowest:.4g} to {highest:.4g} K, which air in a circuit does not have: is its column "
        "swapped, with a pressure say, or its unit another?"
    ]


def value_verdicts(channel: Channel) -> list[str]:
    """A channel that does not move, is clipped, or was recorded in coarse steps."""
    values, address, unit = channel.values, channel.address, channel.unit
    if float(np.ptp(values)) == 0.0:
        return [f"{address} is {values[0]:.6g} {unit} in all {values.size} samples: is the sensor connected?"]
    noise = noise_of(values, channel.time)
    found = []
    if channel.quantum > 0.0 and noise < _DITHER * channel.quantum and channel.quantum > 1e-3 * float(np.ptp(values)):
        found.append(
            f"{address} is recorded in steps of {channel.quantum:.3g} {unit}, {_percent(channel.quantum, values)} of "
            f"its range, and its noise of {noise:.2g} {unit} does not smooth them: what is finer is not in the data."
        )
    for level, which in ((float(np.max(values)), "highest"), (float(np.min(values)), "lowest")):
        count = _clipped(values, level, channel.quantum)
        if count:
            found.append(
                f"{address} stays exactly at its {which} value, {level:.6g} {unit}, for {count} samples, although it "
                "moves and scatters around them: is the sensor or its amplifier clipped?"
            )
    return found


def _percent(part: float, values: FloatArray) -> str:
    return f"{100.0 * part / float(np.ptp(values)):.2g} %"


def _clipped(values: FloatArray, level: float, quantum: float) -> int:
    """Length of the longest run at an extreme that is no rest there; 0 where there is none."""
    edges = np.flatnonzero(np.diff(np.concatenate([[False], values == level, [False]]).astype(int)))
    least = max(_SHORTEST_RUN, values.size // 200)
    runs = [(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True) if b - a >= least]
    if not runs or level == 0.0:
        return 0
    step = max(quantum, 1e-6 * float(np.ptp(values)))
    start, stop = max(runs, key=lambda run: run[1] - run[0])
    moving = np.concatenate([values[:start], values[stop:]])
    noise = noise_of(moving)
    # Every second sample of noise is as noisy; of a smooth curve, it bends four times as much.
    is_noisy = noise > step and noise_of(moving[::2]) < 2.0 * noise
    return stop - start if is_noisy or any(_cuts_a_peak(values, run, step) for run in runs) else 0


def _cuts_a_peak(values: FloatArray, run: tuple[int, int], step: float) -> bool:
    """True for a run between two steep flanks: without noise, that is what remains of a peak."""
    start, stop = run
    if start == 0 or stop == values.size:
        return False
    return bool(min(abs(values[start - 1] - values[start]), abs(values[stop] - values[start])) > 3.0 * step)


def time_verdicts(channels: Sequence[Channel]) -> list[str]:
    """Gaps, uneven stamps, and milliseconds read as seconds, each clock judged once."""
    found, seen = [], set()
    for channel in channels:
        clock = channel.time.tobytes()
        if clock not in seen:
            found += _clock(channel.address, channel.time)
        seen.add(clock)
    return found


def _clock(address: str, time: FloatArray) -> list[str]:
    steps = np.diff(time)
    median = float(np.median(steps))
    found: list[str] = []
    gaps = np.flatnonzero(steps > _GAP * median)
    if gaps.size:
        k = int(gaps[np.argmax(steps[gaps])])
        many = "1 gap" if gaps.size == 1 else f"{gaps.size} gaps"
        found.append(
            f"{address} has {many} of more than {_GAP:g} median steps ({median:.3g} s); the longest, "
            f"{steps[k]:.3g} s, begins at {time[k]:.5g} s: samples are missing."
        )
    low, high = np.percentile(steps, [5.0, 95.0])
    if high - low > _UNEVEN * median:
        found.append(f"{address} is sampled unevenly: steps of {low:.3g} to {high:.3g} s, median {median:.3g} s.")
    jitter = float(np.ptp(steps)) > 0.0
    if median >= _LONG_STEP and time.size >= _MANY_STAMPS and jitter and bool(np.all(steps == np.rint(steps))):
        found.append(
            f"{address} has stamps in whole seconds, {median:.3g} s apart and {time[-1]:.6g} s in all: are they "
            'milliseconds? Then write unit = "ms".'
        )
    return found


def _coverage(channels: Sequence[Channel], inputs: Sequence[InputChannel]) -> list[str]:
    end = max(float(channel.time[-1]) for channel in channels)
    found = []
    for item in inputs:
        first, last = float(item.time[0]), float(item.time[-1])
        slack = _GAP * float(np.median(np.diff(item.time))) if item.time.size > 1 else 0.0
        if first > slack or last < end - slack:
            found.append(
                f"{item.address} was recorded from {first:.4g} to {last:.4g} s, but the channels run from 0 to "
                f"{end:.4g} s: outside, its nearest value is all there is."
            )
    return found


def _bar(pressure: float) -> str:
    return f"{1e-5 * pressure:.3f} bar"

"""Frequency response from sines: fundamental wave and harmonics by regression over whole periods."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from poppet.bench.iso10094.bench_settings import Trial
from poppet.bench.iso10094.evaluation import AT_LEAST, DYNAMIC, BenchTest, Curve, Evaluation, Row
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.uncertainty import SEED, Uncertainty, greatest, noise_about
from poppet.laws.curves.pchip import pchip_slopes
from poppet.timeseries.signals import Sine

GAIN_DB, PHASE_DEG = -3.0, -90.0
"""Where the two bandwidths are read."""
PERIODS, PER_PERIOD = 6, 200
"""Whole periods of a sine that are recorded, and rows of each."""
HIGHEST = 5
"""Harmonic up to which the distortion counts."""
FEWEST = 3
"""Whole periods that a sine must have to be judged."""
ASTRAY = 0.05
"""Distance from a sine, of its amplitude, at which another signal begins."""
ALIKE = 0.04
"""Periods that differ by less are of one sine."""
STEADY = 0.01
"""Change of the fundamental wave from period to period, of its size, at which the transient is over."""
UNSEEN = 1.15
"""Standard deviation of coloured noise over what the few periods of a sine let see of it."""
UNLIKE = 5.0
"""Standard errors of a period that no chance exceeds among the few of a sine."""
SAME = 1.15
"""Ratio of amplitudes that belong to one Bode plot."""
CLIPPED = ("bench.frequency.clipped", "bench.frequency.impure")
PURE = 0.03
"""Harmonics of the setpoint, over its fundamental wave, that are those of no sine."""
LONG = 2000
"""Samples from which the normal equations do for a regression; its columns are nearly orthogonal then."""
SINE_DRAWS = 100
"""Draws of noise from which the scatter of a bandwidth is known."""
BETWEEN = 0.15
"""What a monotone cubic may miss between two frequencies, as part of what a straight line does."""
IN_DB = 20.0 / math.log(10.0)
FAINT = 4.0
"""Fundamental waves below this many standard errors are not told from noise."""


def frequency_trial(
    scale: Scale, volume: float, frequency: float, hold: float, *, mean: float, amplitude: float
) -> Trial:
    """A sine of the setpoint about a mean."""
    lead = max(2.0, math.ceil(hold * frequency)) / frequency
    unit = (scale.setpoint_high - scale.setpoint_low) / 100.0
    signal = Sine(float(scale.setpoint(mean)), amplitude * unit, frequency)
    duration = lead + (PERIODS + 0.3) / frequency
    return Trial("frequency", f"{frequency:.4g} Hz", signal, duration, lead, 1.0 / (PER_PERIOD * frequency), volume)


@dataclass(frozen=True)
class SineComponent:
    """The fundamental wave of a series and its harmonics."""

    value: complex  # amplitude and phase against a sine from the start of the record on, in the unit of the series
    mean: float
    distortion: float  # root of the sum of squares of harmonics 2 to 5 over the fundamental
    error: float  # standard error of its amplitude


def _evaluate(found: Evaluation, records: Sequence[Record]) -> None:
    conclude(found, [row for record in records for row in sine_rows(found, record)])
    lost = [note.facts["frequency"] for note in found.notes if note.code in CLIPPED]
    if lost:
        found.lack("distortion")
        # Gains and phases are relative to the lowest frequency; what others than that show stands.
        is_relative = min(lost) < min((row["frequency"] for row in found.rows), default=math.inf)
        names = ("bandwidth_gain", "bandwidth_phase")
        found.withhold(*(name for name in names if is_relative or name not in found.figures))


def sine_rows(found: Evaluation, record: Record) -> list[Row]:
    """A row for every sine of a record."""
    x, y = found.scale.percents(record)
    parts = sines(record.time, x)
    if not parts:
        found.note("frequency.no_sine", record.name, fewest=FEWEST)
    rows = (_one(found, record, part, x[part], y[part]) for part in parts)
    return [row for row in rows if row is not None]


def conclude(found: Evaluation, rows: Sequence[Row]) -> None:
    """Bode plots and bandwidths of rows, one plot for each amplitude, mean and volume."""
    series: dict[str, list[Row]] = {}
    for row in rows:
        series.setdefault(_series(row, rows), []).append(row)
    for name, every in series.items():
        ordered = _relative(_merged(every))
        frequency = np.array([row["frequency"] for row in ordered])
        for curve, key in (("gain", "gain_db"), ("phase", "phase")):
            found.curves.append(Curve(curve, name, frequency, np.array([row[key] for row in ordered])))
        if not found.rows:  # the first series is the one that counts
            _bandwidths(found, ordered, frequency)
        found.rows += ordered
    if not series:
        found.absent("no_sine", "bandwidth_gain", "bandwidth_phase", "distortion")


def _sides(values: FloatArray) -> NDArray[np.int64]:
    """+1 above and -1 below the middle of a series, 0 near it: noise about the middle crosses it many times."""
    low, high = float(np.min(values)), float(np.max(values))
    middle, swing = 0.5 * (low + high), 0.25 * float(np.ptp(values))
    return np.where(values > middle + swing, 1, np.where(values < middle - swing, -1, 0))


def sines(time: FloatArray, setpoint: FloatArray) -> list[slice]:
    """Parts of a record in which the setpoint is a sine of one frequency.

    Examples
    --------
    >>> t = np.linspace(0.0, 10.0, 1001)
    >>> [(p.start, p.stop) for p in sines(t, 50.0 + 5.0 * np.sin(2.0 * np.pi * t - 0.5))]
    [(0, 1001)]
    """
    middle = 0.5 * (float(np.min(setpoint)) + float(np.max(setpoint)))
    side = _sides(setpoint)
    known = np.flatnonzero(side)
    rises = np.diff(side[known]) > 0
    # A crossing is the middle of the way from below to above.
    ways = zip(known[:-1][rises], known[1:][rises], strict=True)
    crossings = [float(np.interp(middle, setpoint[[a, b]], time[[a, b]])) for a, b in ways]
    periods = np.diff(crossings)
    found, begin = [], 0
    for k in range(1, periods.size + 1):
        if k == periods.size or abs(periods[k] / np.mean(periods[begin:k]) - 1.0) > ALIKE:
            ends = np.searchsorted(time, [crossings[begin], crossings[k]])
            period = (crossings[k] - crossings[begin]) / (k - begin)
            part = _whole(time, setpoint, slice(int(ends[0]), int(ends[1])), period)
            # Between two frequencies one period may look like a third one.
            is_alone = begin == 0 and k == periods.size
            if (is_alone or k - begin > 1) and time[part.stop - 1] - time[part.start] > (FEWEST - 0.1) * period:
                found.append(part)
            begin = k
    return found


def _whole(time: FloatArray, setpoint: FloatArray, part: slice, period: float) -> slice:
    """A sine from where it begins to where it ends, up to a period and a half about its rises."""
    if part.stop - part.start < 8:
        return part
    frequency = _frequency(time[part], setpoint[part], 1.0 / period)
    fit = wave(time[part], setpoint[part], frequency, highest=1)
    turn = 2.0 * math.pi * frequency * time
    away = np.abs(setpoint - fit.mean - fit.value.real * np.sin(turn) - fit.value.imag * np.cos(turn))
    noise = fit.error * math.sqrt(0.5 * (part.stop - part.start))
    foreign = away > ASTRAY * abs(fit.value) + 4.0 * noise
    foreign |= (time < time[part.start] - 1.5 * period) | (time > time[part.stop - 1] + 1.5 * period)
    before, after = np.flatnonzero(foreign[: part.start]), np.flatnonzero(foreign[part.stop :])
    return slice(int(before[-1]) + 1 if before.size else 0, part.stop + int(after[0]) if after.size else time.size)


def _one(found: Evaluation, record: Record, part: slice, x: FloatArray, y: FloatArray) -> Row | None:
    """The row of one sine, from its steady last part."""
    time = record.time[part]
    side = _sides(x)
    known = np.flatnonzero(side)
    crossed = 0.5 * (time[known[:-1]] + time[known[1:]])[np.diff(side[known]) != 0]
    frequency = _frequency(time, x, 0.5 * (crossed.size - 1) / float(crossed[-1] - crossed[0]))
    if record.cuts("setpoint", "outlet", part=part):
        found.note("frequency.clipped", record.name, frequency=frequency)
        return None
    count = _steady_periods(time, y, frequency)
    begin = int(np.searchsorted(time, time[-1] + 0.5 * record.step - count / frequency))
    if time.size - begin < 8 * count:
        samples = (time.size - begin) / count
        found.note("frequency.few_samples", record.name, frequency=frequency, samples=samples)
        return None
    asked, answered = (wave(time[begin:], series[begin:], frequency, is_coloured=True) for series in (x, y))
    if asked.distortion > PURE:
        found.note("frequency.impure", record.name, frequency=frequency, distortion=100.0 * asked.distortion)
        return None
    if abs(answered.value) < FAINT * answered.error:
        found.note("frequency.lost", record.name, frequency=frequency)
        return None
    row: Row = {
        "record": record.name, "frequency": frequency, "mean": asked.mean, "amplitude": abs(asked.value),
        "outlet_amplitude": abs(answered.value), "gain": abs(answered.value) / abs(asked.value),
        "phase": math.degrees(float(np.angle(answered.value / asked.value))),
        "distortion": 100.0 * answered.distortion, "periods": count, "is_steady": count >= FEWEST,
    }  # fmt: skip
    # One standard deviation of the logarithm of the gain, and of the phase [rad]: of both waves.
    row["relative_error"] = math.hypot(asked.error / abs(asked.value), answered.error / abs(answered.value))
    row["distortion_uncertainty"] = 100.0 * answered.error / abs(answered.value)
    if math.isfinite(record.volume):
        row["volume"] = record.volume
    if not row["is_steady"]:
        total = math.floor((time[-1] - time[0]) * frequency + 0.02)
        found.note("frequency.unsteady", record.name, frequency=frequency, count=count, total=total)
    return row


def _series(row: Row, rows: Sequence[Row]) -> str:
    """Name of the Bode plot to which a row belongs: that of the first row with the same amplitude, mean and volume."""
    first = next(each for each in rows if _is_alike(row, each))
    volume = f", {1e3 * first['volume']:.4g} l" if "volume" in first else ""
    return f"{first['amplitude']:.2g} % FS about {first['mean']:.3g} % FS{volume}"


def _is_alike(row: Row, other: Row) -> bool:
    sizes = row["amplitude"], other["amplitude"]
    is_near = max(sizes) < SAME * min(sizes) and abs(row["mean"] - other["mean"]) < 0.5 * max(sizes)
    return is_near and row.get("volume") == other.get("volume")


def _frequency(time: FloatArray, x: FloatArray, guess: float) -> float:
    """The frequency of a sine: where the phase does not drift from its first half to its second."""
    frequency = guess
    half = time.size // 2
    for _ in range(4):
        first, last = (wave(time[s], x[s], frequency, highest=1).value for s in (slice(half), slice(half, None)))
        drift = float(np.angle(last / first))
        apart = 0.5 * (time[-1] - time[0])
        frequency += drift / (2.0 * math.pi * apart)
    return float(frequency)


def wave(
    time: FloatArray, values: FloatArray, frequency: float, *, highest: int = HIGHEST, is_coloured: bool = False
) -> SineComponent:
    """The fundamental wave of a series by least squares, beside its harmonics, its mean and a drift.

    Examples
    --------
    >>> t = np.arange(400) / 100.0
    >>> found = wave(t, 3.0 + 2.0 * np.sin(2.0 * np.pi * t) + 0.1 * np.sin(4.0 * np.pi * t), 1.0)
    >>> round(abs(found.value), 6), round(found.distortion, 6), round(found.mean, 6)
    (2.0, 0.05, 3.0)
    """
    per_period = time.size / max(1.0, frequency * (time[-1] - time[0]))
    orders = range(1, max(1, min(highest, int(per_period / 2.5))) + 1)
    turn = 2.0 * math.pi * frequency * time
    middle, width = 0.5 * (time[0] + time[-1]), max(time[-1] - time[0], 1e-300)
    columns = [np.ones_like(time), (time - middle) / width]
    for k in orders:
        columns += [np.sin(k * turn), np.cos(k * turn)]
    matrix = np.stack(columns, axis=1)
    found = np.linalg.solve(matrix.T @ matrix, matrix.T @ values) if time.size > LONG else _least(matrix, values)
    left = values - matrix @ found
    sigma = math.sqrt(float(left @ left) / max(1, time.size - len(columns)))
    if is_coloured:
        # Higher harmonics, which are few, would take the slow part of its colour with them.
        few = matrix[:, :6]
        noise = noise_about([values - few @ _least(few, values)], 0)
        sigma = UNSEEN * max(noise.at(2.0 * math.pi / per_period), 0.3 * sigma)
    waves = found[2::2] + 1j * found[3::2]
    size = abs(waves[0])
    known = np.linalg.pinv(matrix.T @ matrix)
    error = sigma * math.sqrt(0.5 * float(known[2, 2] + known[3, 3]))
    # Noise adds its own square to that of each harmonic.
    own = float(np.sum(np.abs(waves[1:]) ** 2))
    rest = math.sqrt(max(own - 2.0 * waves[1:].size * error**2, 0.0))
    distortion = rest / float(size) if size > 0.0 else math.inf
    return SineComponent(complex(waves[0]), float(found[0]), distortion, error)


def _least(matrix: FloatArray, values: FloatArray) -> FloatArray:
    return np.asarray(np.linalg.lstsq(matrix, values, rcond=None)[0])


def _steady_periods(time: FloatArray, y: FloatArray, frequency: float) -> int:
    """Whole periods at the end over which the fundamental wave stays the same."""
    total = max(1, math.floor((time[-1] - time[0]) * frequency + 0.02))
    ends = time[-1] - np.arange(total + 1) / frequency
    cuts = np.searchsorted(time, ends + 1e-9 * (time[-1] - time[0]))
    cuts[0] = time.size
    found = [wave(time[b:a], y[b:a], frequency, highest=2) for a, b in pairwise(cuts) if a - b >= 8]
    if len(found) < 2:
        return max(1, len(found))
    last = np.mean([w.value for w in found[:2]])
    # A period alone hardly knows its noise, and nothing of its colour; the half that is settled for sure does.
    half = slice(int(cuts[(total + 1) // 2]), time.size)
    error = wave(time[half], y[half], frequency, is_coloured=True).error * math.sqrt((total + 1) // 2)
    for count, each in enumerate(found):
        if abs(each.value - last) > STEADY * abs(last) + UNLIKE * max(error, each.error if total < FEWEST else 0.0):
            return max(1, count)
    return len(found)


def _merged(rows: list[Row]) -> list[Row]:
    """One row per frequency, in order; of repeated ones the one with more periods."""
    kept: dict[float, Row] = {}
    for row in rows:
        key = float(f"{row['frequency']:.3g}")
        if key not in kept or row["periods"] > kept[key]["periods"]:
            kept[key] = row
    return sorted(kept.values(), key=lambda row: float(row["frequency"]))


def _relative(rows: list[Row]) -> list[Row]:
    """Phases that go on without jumps of a turn, from the lowest frequency on; gain in dB relative to it."""
    phases = np.degrees(np.unwrap(np.radians([row["phase"] for row in rows])))
    if phases[0] > 90.0:  # an answer is late, not early
        phases -= 360.0
    first = rows[0]["gain"]
    return [
        row | {"phase": float(phase), "gain_db": 20.0 * math.log10(row["gain"] / first)}
        for row, phase in zip(rows, phases, strict=True)
    ]


def _bandwidths(found: Evaluation, rows: list[Row], frequency: FloatArray) -> None:
    first, highest = rows[0], float(frequency[-1])
    found.conditions |= {
        "amplitude": first["amplitude"], "mean": first["mean"], "lowest": float(frequency[0]), "highest": highest,
        "gain_at_lowest": first["gain"],
    }  # fmt: skip
    case = {key: first[key] for key in ("amplitude", "mean", "volume") if key in first}
    for what, key, level, shown in (("gain", "gain_db", GAIN_DB, -GAIN_DB), ("phase", "phase", PHASE_DEG, PHASE_DEG)):
        values = np.array([row[key] for row in rows])
        name, value = f"bandwidth_{what}", falls_to(frequency, values, level)
        if not math.isnan(value):
            errors = np.array([row["relative_error"] for row in rows]) * (
                math.degrees(1.0) if what == "phase" else IN_DB
            )
            found.add(name, value, _doubt_of(frequency, values, errors, level, is_relative=what == "gain"), **case)
        elif values[0] > level and len(rows) > 1:
            found.note(f"frequency.low_{what}", name, level=shown, highest=highest)
            found.add(name, highest, bound=AT_LEAST, **case)
        else:
            found.absent(f"between_{what}", name, level=shown)
    if first["phase"] < -30.0:
        found.note("frequency.not_low", frequency=float(frequency[0]), phase=first["phase"])
    limit = found.figures["bandwidth_gain"].value if "bandwidth_gain" in found.figures else highest
    judged = [row for row in rows if row["frequency"] <= limit] or [first]
    value, doubt, k = greatest(
        [row["distortion"] for row in judged], [Uncertainty(row["distortion_uncertainty"]) for row in judged]
    )
    found.add_judged("distortion", value, doubt, frequency=judged[k]["frequency"], **case)


def _doubt_of(
    frequency: FloatArray, values: FloatArray, errors: FloatArray, level: float, *, is_relative: bool
) -> Uncertainty:
    """How well it is known where a series falls to a level: noise of its points, and what may be between them."""
    value = falls_to(frequency, values, level)
    random = np.random.default_rng(SEED)
    chance = errors * random.standard_normal((SINE_DRAWS, values.size))
    chance -= chance[:, :1] if is_relative else 0.0
    drawn = np.array([falls_to(frequency, values + each, level) for each in chance])
    drawn = drawn[np.isfinite(drawn)]
    if drawn.size < SINE_DRAWS // 2:
        return Uncertainty(math.nan)
    straight = math.exp(float(np.interp(-level, -np.minimum.accumulate(values), np.log(frequency))))
    return Uncertainty(float(np.std(drawn)), BETWEEN * abs(straight - value))


def falls_to(frequency: FloatArray, values: FloatArray, level: float) -> float:
    """Where a series first falls to a level, on a monotone cubic over the logarithm of the frequency.

    Examples
    --------
    >>> f = np.array([1.0, 2.0, 4.0, 8.0])
    >>> round(falls_to(f, np.array([0.0, -10.0, -20.0, -30.0]), -15.0) ** 2, 9)
    8.0
    """
    below = np.flatnonzero(values <= level)
    if not below.size or below[0] == 0:
        return math.nan
    k = int(below[0])
    x = np.log(frequency)
    slope = np.array(pchip_slopes(x.tolist(), values.tolist()))
    h = x[k] - x[k - 1]
    s = np.linspace(0.0, 1.0, 2001)
    cubic = (
        (1.0 + 2.0 * s) * (1.0 - s) ** 2 * values[k - 1]
        + s * (1.0 - s) ** 2 * h * slope[k - 1]
        + s * s * (3.0 - 2.0 * s) * values[k]
        + s * s * (s - 1.0) * h * slope[k]
    )
    return float(np.exp(x[k - 1] + h * np.interp(-level, -cubic, s)))


FREQUENCY = BenchTest(
    "frequency",
    _evaluate,
    {"bandwidth_gain": "Hz", "bandwidth_phase": "Hz", "distortion": "%"},
    {"gain": -GAIN_DB, "phase": -PHASE_DEG},
    table="frequencies",
    part=DYNAMIC,
)

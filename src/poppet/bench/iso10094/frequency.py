"""Frequency response from sines: fundamental wave and harmonics by regression over whole periods."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from poppet.bench.iso10094.definitions import GAIN_DB, PHASE_DEG
from poppet.bench.iso10094.evaluation import AT_LEAST, Curve, Evaluation
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.laws.curves.pchip import pchip_slopes

HIGHEST = 5
"""Harmonic up to which the distortion counts."""
FEWEST = 3
"""Whole periods that a sine must have to be judged."""
ALIKE = 0.04
"""Periods that differ by less are of one sine."""
STEADY = 0.01
"""Change of the fundamental wave from period to period, of its size, at which the transient is over."""
SAME = 1.15
"""Ratio of amplitudes that belong to one Bode plot."""
FAINT = 4.0
"""Fundamental waves below this many standard errors are not told from noise."""


@dataclass(frozen=True)
class Wave:
    """The fundamental wave of a series and its harmonics.

    Parameters
    ----------
    value : complex
        Amplitude and phase against a sine from the start of the record on, in the unit of the series.
    mean : float
        In the unit of the series.
    distortion : float
        Root of the sum of squares of harmonics 2 to 5 over the fundamental.
    error : float
        Standard error of the amplitude.
    """

    value: complex
    mean: float
    distortion: float
    error: float


def evaluate_frequency(records: Sequence[Record], scale: Scale) -> Evaluation:
    """Gain and phase of every sine in some records, and the bandwidths."""
    found = Evaluation("frequency")
    for record in records:
        x = scale.setpoint_percent(record.setpoint)
        parts = sines(record.time, x)
        if not parts:
            found.note(f"{record.name}: the setpoint holds no {FEWEST} periods of a sine.")
        for part in parts:
            _one(found, record, scale, part)
    series: dict[str, list[dict[str, Any]]] = {}
    for row in found.rows:
        series.setdefault(_series(row, found.rows), []).append(row)
    found.rows = []
    for name, every in series.items():
        rows = _merged(every)
        _relative(rows)
        _curves(found, rows, name)
        if not found.rows:
            _bandwidths(found, rows)
        found.rows += rows
    if not series:
        for figure in ("bandwidth_gain", "bandwidth_phase", "distortion"):
            found.add(figure, math.nan, reason="no sine can be judged")
    return found


def sines(time: FloatArray, setpoint: FloatArray) -> list[slice]:
    """Parts of a record in which the setpoint is a sine of one frequency.

    Examples
    --------
    >>> t = np.linspace(0.0, 10.0, 1001)
    >>> [(p.start, p.stop) for p in sines(t, 50.0 + 5.0 * np.sin(2.0 * np.pi * t - 0.5))]
    [(108, 908)]
    """
    middle = 0.5 * (float(np.min(setpoint)) + float(np.max(setpoint)))
    swing = 0.25 * float(np.ptp(setpoint))
    if swing <= 0.0:
        return []
    side = np.where(setpoint > middle + swing, 1, np.where(setpoint < middle - swing, -1, 0))
    known = np.flatnonzero(side)
    turns = known[1:][np.diff(side[known]) > 0]
    starts = known[:-1][np.diff(side[known]) > 0]
    # A crossing is the middle of the way from below to above; noise about the middle crosses it many times.
    crossings = [float(np.interp(middle, setpoint[[a, b]], time[[a, b]])) for a, b in zip(starts, turns, strict=True)]
    periods = np.diff(crossings)
    found, begin = [], 0
    for k in range(1, periods.size + 1):
        if k == periods.size or abs(periods[k] - periods[begin]) > ALIKE * periods[begin]:
            if k - begin >= FEWEST:
                ends = np.searchsorted(time, [crossings[begin], crossings[k]])
                found.append(slice(int(ends[0]), int(ends[1])))
            begin = k
    return found


def _one(found: Evaluation, record: Record, scale: Scale, part: slice) -> None:
    """The row of one sine, from its steady last part."""
    time = record.time[part]
    x, y = scale.setpoint_percent(record.setpoint[part]), scale.percent(record.outlet[part])
    crossed = _periods(time, x)
    frequency = _frequency(time, x, crossed / (time[-1] - time[0] + record.step))
    count = _steady_periods(time, y, frequency)
    begin = int(np.searchsorted(time, time[-1] + 0.5 * record.step - count / frequency))
    inside = slice(begin, time.size)
    if time.size - begin < 8 * count:
        found.note(
            f"{record.name}: {frequency:.4g} Hz has {(time.size - begin) / count:.3g} samples per period, too few."
        )
        return
    asked, answered = wave(time[inside], x[inside], frequency), wave(time[inside], y[inside], frequency)
    row: dict[str, Any] = {
        "record": record.name, "frequency": frequency, "mean": asked.mean, "amplitude": abs(asked.value),
        "outlet_amplitude": abs(answered.value), "gain": abs(answered.value) / abs(asked.value),
        "phase": math.degrees(float(np.angle(answered.value / asked.value))),
        "distortion": 100.0 * answered.distortion, "periods": count,
    }  # fmt: skip
    if math.isfinite(record.volume):
        row["volume"] = record.volume
    if abs(answered.value) < FAINT * answered.error:
        found.note(f"{record.name}: at {frequency:.4g} Hz the answer of the outlet is lost in the noise.")
        return
    row["is_steady"] = count >= FEWEST
    if not row["is_steady"]:
        found.note(f"{record.name}: at {frequency:.4g} Hz the answer is not the same from period to period.")
    found.rows.append(row)


def _series(row: dict[str, Any], rows: list[dict[str, Any]]) -> str:
    """Name of the Bode plot to which a row belongs: that of the first row with the same amplitude, mean and volume."""
    first = next(each for each in rows if _is_alike(row, each))
    volume = f", {1e3 * first['volume']:.4g} l" if "volume" in first else ""
    return f"{first['amplitude']:.2g} % FS about {first['mean']:.3g} % FS{volume}"


def _is_alike(row: dict[str, Any], other: dict[str, Any]) -> bool:
    sizes = row["amplitude"], other["amplitude"]
    is_near = max(sizes) < SAME * min(sizes) and abs(row["mean"] - other["mean"]) < 0.5 * max(sizes)
    return is_near and row.get("volume") == other.get("volume")


def _periods(time: FloatArray, x: FloatArray) -> float:
    """Whole periods in a part from crossing to crossing."""
    middle = 0.5 * (float(np.min(x)) + float(np.max(x)))
    swing = 0.25 * float(np.ptp(x))
    side = np.where(x > middle + swing, 1, np.where(x < middle - swing, -1, 0))
    side = side[side != 0]
    return float(np.count_nonzero(np.diff(side) < 0))


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


def wave(time: FloatArray, values: FloatArray, frequency: float, *, highest: int = HIGHEST) -> Wave:
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
    found = np.linalg.lstsq(matrix, values, rcond=None)[0]
    left = values - matrix @ found
    sigma = math.sqrt(float(left @ left) / max(1, time.size - len(columns)))
    waves = found[2::2] + 1j * found[3::2]
    size = abs(waves[0])
    rest = math.sqrt(float(np.sum(np.abs(waves[1:]) ** 2)))
    distortion = rest / float(size) if size > 0.0 else math.inf
    return Wave(complex(waves[0]), float(found[0]), distortion, sigma * math.sqrt(2.0 / time.size))


def _steady_periods(time: FloatArray, y: FloatArray, frequency: float) -> int:
    """Whole periods at the end over which the fundamental wave stays the same."""
    total = max(1, math.floor((time[-1] - time[0]) * frequency + 0.02))
    ends = time[-1] - np.arange(total + 1) / frequency
    cuts = np.searchsorted(time, ends + 1e-9 * (time[-1] - time[0]))
    cuts[0] = time.size
    found = [wave(time[b:a], y[b:a], frequency) for a, b in pairwise(cuts) if a - b >= 8]
    if len(found) < 2:
        return max(1, len(found))
    last = np.mean([w.value for w in found[:2]])
    for count, each in enumerate(found):
        if abs(each.value - last) > STEADY * abs(last) + 4.0 * each.error:
            return max(1, count)
    return len(found)


def _merged(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """One row per frequency, in order; of repeated ones the one with more periods."""
    kept: dict[float, dict[str, Any]] = {}
    for row in rows:
        key = float(f"{row['frequency']:.3g}")
        if key not in kept or row["periods"] > kept[key]["periods"]:
            kept[key] = row
    return sorted(kept.values(), key=lambda row: float(row["frequency"]))


def _relative(rows: list[dict[str, Any]]) -> None:
    """Phases that go on without jumps of a turn, from the lowest frequency on; gain in dB relative to it."""
    phases = np.degrees(np.unwrap(np.radians([row["phase"] for row in rows])))
    if phases[0] > 90.0:  # an answer is late, not early
        phases -= 360.0
    for row, phase in zip(rows, phases, strict=True):
        row["phase"] = float(phase)
        row["gain_db"] = 20.0 * math.log10(row["gain"] / rows[0]["gain"])


def _bandwidths(found: Evaluation, rows: list[dict[str, Any]]) -> None:
    frequency = np.array([row["frequency"] for row in rows])
    found.conditions |= {
        "amplitude": rows[0]["amplitude"], "mean": rows[0]["mean"], "lowest": float(frequency[0]),
        "highest": float(frequency[-1]), "gain_at_lowest": rows[0]["gain"],
    }  # fmt: skip
    case = {key: rows[0][key] for key in ("amplitude", "mean", "volume") if key in rows[0]}
    for name, key, level, what in (
        ("bandwidth_gain", "gain_db", GAIN_DB, f"the amplitude does not fall by {-GAIN_DB:g} dB"),
        ("bandwidth_phase", "phase", PHASE_DEG, f"the phase does not reach {PHASE_DEG:g} deg"),
    ):
        values = np.array([row[key] for row in rows])
        value = falls_to(frequency, values, level)
        if math.isnan(value) and values[0] > level and len(rows) > 1:
            found.note(f"{name}: {what} up to {frequency[-1]:.4g} Hz, the highest frequency that was judged.")
            found.add(name, float(frequency[-1]), bound=AT_LEAST, **case)
        else:
            found.add(name, value, reason=f"{what} between frequencies that were judged", **case)
    if rows[0]["phase"] < -30.0:
        found.note(
            f"The lowest frequency, {frequency[0]:.3g} Hz, is not low: its phase is {rows[0]['phase']:.0f} deg "
            "already, and gains are relative to it."
        )
    limit = found.figures["bandwidth_gain"].value if "bandwidth_gain" in found.figures else frequency[-1]
    worst = max((row for row in rows if row["frequency"] <= limit), key=lambda row: row["distortion"], default=rows[0])
    found.add("distortion", worst["distortion"], frequency=worst["frequency"], **case)


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


def _curves(found: Evaluation, rows: list[dict[str, Any]], name: str) -> None:
    frequency = np.array([row["frequency"] for row in rows])
    found.curves.append(Curve("gain", name, frequency, np.array([row["gain_db"] for row in rows])))
    found.curves.append(Curve("phase", name, frequency, np.array([row["phase"] for row in rows])))

"""Steps of the setpoint: delay, rise, settling, overshoot, and what the outlet does when it should rest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from poppet.bench.iso10094.evaluation import AT_LEAST, AT_MOST, DYNAMIC, BenchTest, Curve, Evaluation, Row, largest
from poppet.bench.iso10094.plan import Trial
from poppet.bench.iso10094.rest import hum_of
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import Jump, jumps, rested
from poppet.series.measured.noise import noise_of
from poppet.series.signals import Steps

LOW, HIGH = 0.1, 0.9
"""Fractions of a step between which it rises."""
BAND = 0.05
"""Half width of the band in which a step has settled, as a fraction of the step."""
LEAST_STEP = 2.0
"""Smallest change of the setpoint that counts as a step [% FS]."""
TAIL = 0.2
"""Last part of a hold, in which the outlet rests."""
FOLLOWS = 0.2
"""Part of the setpoint's step that the outlet must make."""
DRIFT = 0.01
"""Change between the halves of the tail, of the step, at which the outlet is not at rest."""
SHORT = 5.0
"""Distance from the setpoint at which it counts as not reached [% FS]."""
COARSE = 0.02
"""Time of the setpoint's step in a recording, over the delay, above which a note says so."""
POINTS = 400
MOST_ROWS = 40_000
"""Rows of a hold of a trial."""
CASE = {key: key for key in ("from", "to", "volume", "sampling")}
"""For which step a figure holds."""


def step_trial(scale: Scale, volume: float, amplitude: float, hold: float) -> Trial:
    """A step up and a step down about the middle of the range."""
    low, high = (float(scale.setpoint(50.0 + side * amplitude / 2.0)) for side in (-1.0, 1.0))
    lead = hold
    # Rows lie on the steps: both are multiples of a quarter of the hold.
    times = (0.0, lead + 0.25 * hold, lead + 1.25 * hold)
    name = f"step of {amplitude:g} % FS, {1e3 * volume:.4g} l"
    return Trial("step", name, Steps(times, (low, high, low)), lead + 2.25 * hold, lead, hold / MOST_ROWS, volume)


def _evaluate(found: Evaluation, records: Sequence[Record]) -> None:
    for record in records:
        x, y = found.scale.percents(record)
        steps = jumps(record.time, x, LEAST_STEP, is_exact=record.is_exact)
        if not steps:
            found.note("step.none", record.name, least=LEAST_STEP)
        for k, jump in enumerate(steps):
            begin = steps[k - 1].after if k else 0
            end = steps[k + 1].before + 1 if k + 1 < len(steps) else record.time.size
            _one(found, record, x, y, jump, slice(begin, jump.before + 1), slice(jump.after, end))
    _figures(found)


def _one(
    found: Evaluation, record: Record, x: FloatArray, y: FloatArray, jump: Jump, before: slice, after: slice
) -> None:
    """The row of one step, from the samples of the holds before and after it."""
    if min(before.stop - before.start, after.stop - after.start) < 5:
        found.note("step.no_samples", record.name, time=jump.time)
        return
    earlier, tail = rested(record.time, before, TAIL), rested(record.time, after, TAIL)
    start, end = float(np.mean(y[earlier])), float(np.mean(y[tail]))
    low, high = float(np.mean(x[earlier])), float(np.mean(x[tail]))
    row: Row = {
        "record": record.name, "from": low, "to": high, "amplitude": abs(high - low),
        "direction": "up" if high > low else "down", "outlet_from": start, "outlet_to": end,
    }  # fmt: skip
    if math.isfinite(record.volume):
        row["volume"] = record.volume
    if not record.is_exact:
        row["sampling"] = record.step
    found.rows.append(row)

    def note(code: str, **facts: Any) -> None:
        found.note(f"step.{code}", record.name, direction=row["direction"], start=low, end=high, **facts)

    if any(record.cuts("outlet", part=part) for part in (earlier, tail)):
        # From rest to rest: without both ends there is no part of the way.
        row["is_clipped"] = True
        note("clipped")
        return
    hum = hum_of(record.time[tail], y[tail])
    if hum is not None:
        row |= {"hum_amplitude": hum.amplitude, "hum_frequency": hum.frequency}
        note("swings", amplitude=hum.amplitude, frequency=hum.frequency)
    if abs(end - high) > SHORT:
        note("short", outlet=end)
    if (end - start) / (high - low) < FOLLOWS:
        note("hardly", moved=end - start)
        return
    clock, part = record.time[after] - jump.time, (y[after] - start) / (end - start)
    if not record.is_exact:  # the sample before shows where the outlet still was
        clock, part = np.append(0.0, clock), np.append(0.0, part)
    noise = noise_of(y) / abs(end - start)
    _times(row, clock, part, noise)
    if record.cuts("outlet", part=after):
        row["overshoot_bound"] = AT_LEAST
        note("clipped_peak")
    if hum is not None and hum.amplitude > BAND * abs(end - start):
        note("swings_out", band=100.0 * BAND)
    else:
        settled = _settled(clock, part, noise)
        row |= {"is_settled": False} if math.isnan(settled) else {"settling_time": settled}
        if math.isnan(settled):
            note("unsettled")
    row.setdefault("is_settled", True)
    if not record.is_exact and jump.duration > COARSE * row.get("delay", math.inf):
        note("coarse", error=0.5 * jump.duration, delay=row["delay"])
    _curve(found, record, row, y, jump, after.stop)


def _times(row: Row, clock: FloatArray, part: FloatArray, noise: float) -> None:
    """Delay, rise, response and overshoot, as far as the record shows them."""
    low, high = crossing(clock, part, LOW, noise), crossing(clock, part, HIGH, noise)
    if math.isfinite(low) and math.isfinite(high):
        row |= {"delay": low, "rise_time": high - low, "response_time": high}
    # Among thousands of samples one is beyond five standard deviations at most.
    is_seen = float(np.max(part)) - 1.0 > max(5.0 * noise, 1e-6)
    row["overshoot"] = 100.0 * max(0.0, _summit(clock, part, noise) - 1.0) if is_seen else 0.0
    row["overshoot_known_to"] = 500.0 * noise


def _settled(clock: FloatArray, part: FloatArray, noise: float) -> float:
    """Settling time; not a number where the record ends too early for one [s]."""
    begin = clock[-1] - TAIL * (clock[-1] - clock[0])
    last = part[clock >= begin]
    half = last.size // 2
    drift = abs(float(np.mean(last[half:]) - np.mean(last[:half])))
    settled = _settles(clock, part, noise)
    is_moving = drift > max(DRIFT, 4.0 * noise / math.sqrt(max(1, half)))
    return settled if settled < begin and not is_moving else math.nan


def crossing(clock: FloatArray, part: FloatArray, level: float, noise: float) -> float:
    """When a rising series first reaches a level.

    With noise a parabola through the samples around the crossing takes the place of a straight line between two.

    Examples
    --------
    >>> crossing(np.arange(4.0), np.array([0.0, 0.0, 0.4, 0.8]), 0.1, 0.0)
    1.25
    """
    above = np.flatnonzero(part >= level)
    if not above.size or above[0] == 0:
        return math.nan
    k = int(above[0])
    raw = clock[k - 1] + (level - part[k - 1]) / (part[k] - part[k - 1]) * (clock[k] - clock[k - 1])
    width = min(0.08, 6.0 * noise)
    if width < 1e-3:
        return float(raw)
    left, right = np.flatnonzero(part < level - width), np.flatnonzero(part > level + width)
    begin = int(left[left < k][-1]) if np.any(left < k) else 0
    end = int(right[right > k][0]) if np.any(right > k) else part.size - 1
    near = slice(begin, end + 1)
    if end - begin < 4:
        return float(raw)
    # Time as a parabola of the level would be biased by the noise in the level: the level is fitted over time.
    t = clock[near] - raw
    curve = np.polyfit(t, part[near] - level, 2 if end - begin > 7 else 1)
    roots = np.roots(curve)
    real = roots[np.abs(roots.imag) < 1e-12].real
    nearest = real[np.argmin(np.abs(real))] if real.size else 0.0
    return float(raw + nearest) if t[0] <= nearest <= t[-1] else float(raw)


def _summit(clock: FloatArray, part: FloatArray, noise: float) -> float:
    """Largest value, of a parabola through the samples about it where there is noise."""
    k = int(np.argmax(part))
    if noise < 1e-5:
        return float(part[k])
    depth = max(6.0 * noise, 0.1 * (part[k] - 1.0))
    below = np.flatnonzero(part < part[k] - depth)
    before, after = below[below < k], below[below > k]
    near = slice(int(before[-1]) if before.size else 0, (int(after[0]) if after.size else part.size - 1) + 1)
    if near.stop - near.start < 6:
        return float(part[k])
    t = clock[near] - clock[k]
    a, b, c = np.polyfit(t, part[near], 2)
    return float(c - b * b / (4.0 * a)) if a < 0.0 else float(part[k])


def _settles(clock: FloatArray, part: FloatArray, noise: float) -> float:
    """When the series enters the band about one for good [s]."""
    outside = np.flatnonzero(np.abs(part - 1.0) > BAND)
    if not outside.size or outside[-1] + 1 >= part.size:
        return float(clock[0]) if not outside.size else math.inf
    k = int(outside[-1])
    side = 1.0 if part[k] > 1.0 else -1.0
    # Backwards in time from rest it crosses the edge of the band once: the same search, mirrored.
    away = side * (part[::-1] - 1.0) / BAND
    back = -clock[::-1]
    begin = max(0, part.size - 1 - k - 1)
    inner = crossing(back[begin:], away[begin:], 1.0, noise / BAND) if noise < 0.2 * BAND else math.nan
    if math.isfinite(inner):
        return -inner
    edge = 1.0 + side * BAND
    return float(clock[k] + (edge - part[k]) / (part[k + 1] - part[k]) * (clock[k + 1] - clock[k]))


def _figures(found: Evaluation) -> None:
    _of_judged(found)
    if any("is_clipped" in row for row in found.rows):
        _lack(found)


def _lack(found: Evaluation) -> None:
    """What rests on steps that are clipped at rest: the largest of the others is a bound, others stand for nothing."""
    sizes = [row["amplitude"] for row in found.rows if "is_clipped" in row]
    names = {"settling_time", "overshoot"}
    for name, figure in list(found.figures.items()):
        step = abs(figure.conditions.get("to", math.nan) - figure.conditions.get("from", math.nan))
        if name not in names and not name.startswith("hum") and not step > 0.98 * max(sizes):
            del found.figures[name]
            names.add(name)
    found.lack(*names, *(name for name in _FIGURES if name not in found.figures and not name.startswith("hum")))
    if "hum_amplitude" not in found.figures:
        found.notes = [note for note in found.notes if note.code != "bench.step.rests"]
        found.absent("clipped", "hum_amplitude", "hum_frequency")


def _of_judged(found: Evaluation) -> None:
    volumes = list(dict.fromkeys(row.get("volume", math.nan) for row in found.rows))
    # Of a step that has not settled the end is not known, and so no part of the way to it.
    judged = [row for row in found.rows if "response_time" in row and row["is_settled"]]
    first = [row for row in judged if row.get("volume", math.nan) == volumes[0] or math.isnan(volumes[0])]
    size = max((row["amplitude"] for row in first), default=0.0)
    reference = [row for row in first if row["amplitude"] > 0.98 * size]
    ways = {way: [row for row in reference if row["direction"] == way] for way in ("up", "down")}
    if reference:
        found.add("delay", max(_mean(rows, "delay") for rows in ways.values() if rows), **_case(reference[0]))
    else:
        found.absent("unsettled", "delay")
    for way, rows in ways.items():
        for key in ("rise_time", "response_time"):
            if rows:
                found.add(f"{key}_{way}", _mean(rows, key), **_case(rows[0]))
            else:
                found.absent(f"unsettled_{way}", f"{key}_{way}")
    found.add_largest("settling_time", "settling_time", "unsettled", rows=first, **CASE)
    highest = largest(first, "overshoot")
    if highest is None:
        found.absent("no_step", "overshoot")
    elif highest["overshoot"] > 0.0:
        is_cut = any("overshoot_bound" in row for row in first)
        found.add("overshoot", highest["overshoot"], bound=AT_LEAST if is_cut else "", **_case(highest))
    else:
        least = max(row["overshoot_known_to"] for row in first)
        is_bound = least > 0.1
        found.add("overshoot", least if is_bound else 0.0, bound=AT_MOST if is_bound else "", **_case(highest))
    loudest = largest(found.rows, "hum_amplitude")
    if loudest is None:
        found.note("step.rests")
    else:
        for key in ("hum_amplitude", "hum_frequency"):
            found.add(key, loudest[key], **_case(loudest))


def _mean(rows: Sequence[Row], key: str) -> float:
    return float(np.mean([row[key] for row in rows]))


def _case(row: Row) -> Row:
    return {key: row[key] for key in CASE if key in row}


def _curve(found: Evaluation, record: Record, row: Row, y: FloatArray, jump: Jump, stop: int) -> None:
    """The outlet as a part of its change, from a little before the step on, as far as something happens."""
    lasts = max(2.0 * row.get("settling_time", 0.0), 3.0 * row.get("response_time", 0.0)) or math.inf
    before = 0.1 * min(lasts, record.time[stop - 1] - jump.time)
    start = max(0, int(np.searchsorted(record.time, jump.time - before)))
    end = min(stop, int(np.searchsorted(record.time, jump.time + lasts)) + 1)
    kept = np.unique(np.linspace(start, end - 1, POINTS).astype(int))
    part = 100.0 * (y[kept] - row["outlet_from"]) / (row["outlet_to"] - row["outlet_from"])
    volume = f", {1e3 * record.volume:.4g} l" if math.isfinite(record.volume) else ""
    case = f"{row['to'] - row['from']:+.3g} % FS{volume}"
    found.curves.append(Curve("outlet", case, record.time[kept] - jump.time, part))


_FIGURES = {
    "delay": "s", "rise_time_up": "s", "response_time_up": "s", "rise_time_down": "s", "response_time_down": "s",
    "settling_time": "s", "overshoot": "%", "hum_amplitude": "% FS", "hum_frequency": "Hz",
}  # fmt: skip
STEP = BenchTest(
    "step",
    _evaluate,
    _FIGURES,
    {"low": 100.0 * LOW, "high": 100.0 * HIGH, "band": 100.0 * BAND},
    table="steps",
    part=DYNAMIC,
)

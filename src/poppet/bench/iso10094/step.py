"""Steps of the setpoint: delay, rise, settling, overshoot, and what the outlet does when it should rest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np

from poppet.bench.iso10094.definitions import BAND, HIGH, LOW
from poppet.bench.iso10094.evaluation import AT_MOST, Curve, Evaluation, largest
from poppet.bench.iso10094.rest import Hum, hum_of
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import Jump, jumps, rested
from poppet.series.measured.noise import noise_of

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


def evaluate_step(records: Sequence[Record], scale: Scale) -> Evaluation:
    """Figures of all steps in some records."""
    found = Evaluation("step")
    for record in records:
        steps = _steps(record, scale)
        if not steps:
            found.note(f"{record.name}: the setpoint makes no step of {LEAST_STEP:g} % FS or more.")
        for k, jump in enumerate(steps):
            begin = steps[k - 1].after if k else 0
            end = steps[k + 1].before + 1 if k + 1 < len(steps) else record.time.size
            _one(found, record, scale, jump, slice(begin, jump.before + 1), slice(jump.after, end))
    _figures(found)
    return found


def _steps(record: Record, scale: Scale) -> list[Jump]:
    return jumps(record.time, scale.setpoint_percent(record.setpoint), LEAST_STEP, is_exact=record.is_exact)


def _one(found: Evaluation, record: Record, scale: Scale, jump: Jump, before: slice, after: slice) -> None:
    """The row of one step."""
    x, y = scale.setpoint_percent(record.setpoint), scale.percent(record.outlet)
    earlier, tail = rested(record.time, before, TAIL), rested(record.time, after, TAIL)
    if min(before.stop - before.start, after.stop - after.start) < 5:
        found.note(f"{record.name}: a step at {jump.time:.4g} s has no samples before or after it.")
        return
    start, end = float(np.mean(y[earlier])), float(np.mean(y[tail]))
    low, high = float(np.mean(x[earlier])), float(np.mean(x[tail]))
    asked = high - low
    row: dict[str, Any] = {
        "record": record.name, "from": low, "to": high, "amplitude": abs(asked),
        "direction": "up" if asked > 0.0 else "down", "outlet_from": start, "outlet_to": end,
    }  # fmt: skip
    if math.isfinite(record.volume):
        row["volume"] = record.volume
    if not record.is_exact:
        row["sampling"] = record.step
    found.rows.append(row)
    where = f"step {row['direction']} from {row['from']:.4g} to {row['to']:.4g} % FS{_volume(record)}"
    hum = hum_of(record.time[tail], y[tail])
    if hum is not None:
        row |= {"hum_amplitude": hum.amplitude, "hum_frequency": hum.frequency}
        found.note(
            f"{where}: the outlet does not rest but swings by +/- {hum.amplitude:.2g} % FS at {hum.frequency:.3g} Hz."
        )
    if abs(end - row["to"]) > SHORT:
        found.note(f"{where}: the setpoint is not reached, the outlet ends at {end:.4g} % FS.")
    if (end - start) / asked < FOLLOWS:
        found.note(f"{where}: the outlet moves by {end - start:.3g} % FS only; no times are given.")
        return
    clock, part = record.time[after] - jump.time, (y[after] - start) / (end - start)
    if not record.is_exact:  # the sample before shows where the outlet still was
        clock, part = np.append(0.0, clock), np.append(0.0, part)
    noise = noise_of(y) / abs(end - start)
    _times(found, row, where, clock, part, noise, hum)
    if not record.is_exact and jump.duration > COARSE * row.get("delay", math.inf):
        found.note(
            f"{where}: times are known to about {0.5e3 * jump.duration:.2g} ms, half of the time that the step of the "
            f"setpoint takes in the recording; the delay is {1e3 * row['delay']:.3g} ms."
        )
    _curves(found, record, scale, jump, after, f"{asked:+.3g} % FS{_volume(record)}")


def _volume(record: Record) -> str:
    return f", {1e3 * record.volume:.4g} l" if math.isfinite(record.volume) else ""


def _times(
    found: Evaluation, row: dict[str, Any], where: str, clock: FloatArray, part: FloatArray, noise: float,
    hum: Hum | None,
) -> None:  # fmt: skip
    """Delay, rise, response, settling and overshoot, as far as the record shows them."""
    low, high = crossing(clock, part, LOW, noise), crossing(clock, part, HIGH, noise)
    if math.isfinite(low) and math.isfinite(high):
        row |= {"delay": low, "rise_time": high - low, "response_time": high}
    peak = float(np.max(part)) - 1.0
    # Among thousands of samples one is beyond five standard deviations at most.
    is_seen = peak > max(5.0 * noise, 1e-6)
    row["overshoot"] = 100.0 * max(0.0, _summit(clock, part, noise) - 1.0) if is_seen else 0.0
    row["overshoot_known_to"] = 500.0 * noise
    begin = clock[-1] - TAIL * (clock[-1] - clock[0])
    last = part[clock >= begin]
    half = last.size // 2
    drift = abs(float(np.mean(last[half:]) - np.mean(last[:half])))
    settled = _settles(clock, part, noise)
    swings = hum is not None and hum.amplitude > BAND * abs(row["outlet_to"] - row["outlet_from"])
    if swings:
        found.note(f"{where}: settling_time is not determined, the swing at rest leaves the band of {100 * BAND:g} %.")
    elif drift > max(DRIFT, 4.0 * noise / math.sqrt(max(1, half))) or not settled < begin:
        row["is_settled"] = False
        found.note(f"{where}: the outlet has not settled when the record ends; its end value is not final.")
    else:
        row["settling_time"] = settled
    row.setdefault("is_settled", True)


def crossing(clock: FloatArray, part: FloatArray, level: float, noise: float) -> float:
    """When a rising series first reaches a level.

    Notes
    -----
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
    # Of a step that has not settled the end is not known, and so no part of the way to it.
    rows = [row for row in found.rows if "response_time" in row and row["is_settled"]]
    volumes = list(dict.fromkeys(row.get("volume", math.nan) for row in found.rows))
    first = [row for row in rows if row.get("volume", math.nan) == volumes[0] or math.isnan(volumes[0])]
    size = max((row["amplitude"] for row in first), default=0.0)
    reference = [row for row in first if row["amplitude"] > 0.98 * size]
    found.add("delay", *_mean_of(reference, "delay", None), reason="no step settles", **_of(reference))
    for way in ("up", "down"):
        same = [row for row in reference if row["direction"] == way]
        for figure in ("rise_time", "response_time"):
            found.add(f"{figure}_{way}", *_mean_of(same, figure, way), reason=f"no step {way} settles", **_of(same))
    slowest = largest(first, "settling_time")
    found.add(
        "settling_time", slowest["settling_time"] if slowest else math.nan, reason="no step settles", **_of([slowest])
    )
    _overshoot(found, first)
    loudest = largest(found.rows, "hum_amplitude")
    if loudest is None:
        found.note("No periodic motion of the outlet at rest stands out of the noise.")
    else:
        for figure in ("hum_amplitude", "hum_frequency"):
            found.add(figure, loudest[figure], **_of([loudest]))


def _overshoot(found: Evaluation, rows: list[dict[str, Any]]) -> None:
    highest = largest(rows, "overshoot")
    if highest is None:
        found.add("overshoot", math.nan, reason="no step can be judged")
        return
    if highest["overshoot"] > 0.0:
        found.add("overshoot", highest["overshoot"], **_of([highest]))
        return
    least = max(row["overshoot_known_to"] for row in rows)
    found.add("overshoot", least if least > 0.1 else 0.0, bound=AT_MOST if least > 0.1 else "", **_of([highest]))


def _mean_of(rows: list[dict[str, Any]], key: str, way: str | None) -> tuple[float]:
    """Mean of repeated steps; the longer direction where both are asked for."""
    ways = (way,) if way else ("up", "down")
    means = [np.mean([row[key] for row in rows if row["direction"] == each]) for each in ways if _has(rows, each)]
    return (float(max(means)),) if means else (math.nan,)


def _has(rows: list[dict[str, Any]], way: str) -> bool:
    return any(row["direction"] == way for row in rows)


def _of(rows: Sequence[Any]) -> dict[str, Any]:
    """For which case a figure holds."""
    row = next((row for row in rows if row), None)
    if row is None:
        return {}
    return {key: row[key] for key in ("from", "to", "volume", "sampling") if key in row}


def _curves(found: Evaluation, record: Record, scale: Scale, jump: Jump, after: slice, case: str) -> None:
    """The outlet as a part of its change, from a little before the step on, as far as something happens."""
    row = found.rows[-1]
    lasts = max(2.0 * row.get("settling_time", 0.0), 3.0 * row.get("response_time", 0.0)) or math.inf
    start = max(
        0, int(np.searchsorted(record.time, jump.time - 0.1 * min(lasts, record.time[after.stop - 1] - jump.time)))
    )
    end = min(after.stop, int(np.searchsorted(record.time, jump.time + lasts)) + 1)
    kept = np.unique(np.linspace(start, end - 1, POINTS).astype(int))
    clock = record.time[kept] - jump.time
    part = 100.0 * (scale.percent(record.outlet[kept]) - row["outlet_from"]) / (row["outlet_to"] - row["outlet_from"])
    found.curves.append(Curve("outlet", case, clock, part))

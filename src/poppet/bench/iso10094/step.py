"""Steps of the setpoint: delay, rise, settling, overshoot, and what the outlet does when it should rest."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from poppet.bench.iso10094.bench_settings import Trial
from poppet.bench.iso10094.evaluation import AT_LEAST, AT_MOST, DYNAMIC, BenchTest, Curve, Evaluation, Row
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import Jump, jumps, rested
from poppet.bench.iso10094.smoothing import SmoothedSeries, smoothed
from poppet.bench.iso10094.steady_values import hum_of
from poppet.bench.iso10094.uncertainty import NORMAL, Noise, Uncertainty, greatest, mean_of, noise_about
from poppet.timeseries.signals import Steps

LOW, HIGH = 0.1, 0.9
"""Fractions of a step between which it rises."""
BAND = 0.05
"""Half width of the band in which a step has settled, as a fraction of the step."""
SEEN = 5.0
"""Standard deviations that the largest of many smoothed samples does not reach by noise."""
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
        found.know(row, "hum_amplitude", hum.amplitude, Uncertainty(hum.amplitude_error))
        found.know(row, "hum_frequency", hum.frequency, Uncertainty(hum.frequency_error))
        note("swings", amplitude=hum.amplitude, frequency=hum.frequency)
    if abs(end - high) > SHORT:
        note("short", outlet=end)
    if (end - start) / (high - low) < FOLLOWS:
        note("hardly", moved=end - start)
        return
    answer = _Answer.of(record, y, jump, slice(before.start, after.stop), earlier, tail)
    answer.times(found, row)
    if record.cuts("outlet", part=after):
        row["overshoot_bound"] = AT_LEAST
        note("clipped_peak")
    if hum is not None and hum.amplitude > BAND * abs(end - start):
        note("swings_out", band=100.0 * BAND)
    elif not answer.is_at_rest():
        row["is_settled"] = False
        note("unsettled")
    elif not answer.settles(found, row):
        note("noisy", band=100.0 * BAND)
    row.setdefault("is_settled", True)
    if not record.is_exact and jump.duration > COARSE * row.get("delay", math.inf):
        note("coarse", error=0.5 * jump.duration, delay=row["delay"])
    _curve(found, record, row, y, jump, after.stop)


@dataclass(frozen=True, eq=False)
class _Answer:
    """The outlet as a part of its way from rest to rest, from the last sample before the step of the setpoint on."""

    smooth: SmoothedSeries
    part: FloatArray  # as recorded, on the same clock
    noise: Noise
    errors: tuple[float, float]  # one standard deviation of both rests
    jump: Uncertainty  # of the instant of the step

    @classmethod
    def of(cls, record: Record, y: FloatArray, jump: Jump, whole: slice, *rests: slice) -> _Answer:
        start, end = (float(np.mean(y[rest])) for rest in rests)
        part = (y[whole] - start) / (end - start)
        noise = noise_about([y[rest] for rest in rests])
        noise = Noise(noise.covariance / (end - start) ** 2)
        found = smoothed(record.time[whole] - jump.time, part, noise)
        first = jump.before - whole.start
        low, high = (noise.mean(rest.stop - rest.start) for rest in rests)
        instant = Uncertainty(0.0, 0.0 if record.is_exact else 0.5 * jump.duration)
        return cls(found.since(first), part[first:], noise, (low, high), instant)

    def crossing(self, level: float) -> tuple[float, Uncertainty]:
        extra = math.hypot((1.0 - level) * self.errors[0], level * self.errors[1])
        return self.smooth.crossing(level, extra)

    def times(self, found: Evaluation, row: Row) -> None:
        """Delay, rise, response and overshoot, as far as the record shows them."""
        (low, low_doubt), (high, high_doubt) = self.crossing(LOW), self.crossing(HIGH)
        if math.isfinite(low_doubt.standard) and math.isfinite(high_doubt.standard):
            found.know(row, "delay", low, low_doubt.plus(self.jump))
            found.know(row, "rise_time", high - low, low_doubt.plus(high_doubt))
            found.know(row, "response_time", high, high_doubt.plus(self.jump))
        summit, doubt = self.smooth.summit()
        beyond, doubt = summit - 1.0, doubt.wider(self.errors[1])
        error = doubt.standard
        # With nothing beyond its final value the largest of all samples is noise.
        is_seen = beyond > max(SEEN * error, 1e-6)
        found.know(row, "overshoot", 100.0 * beyond if is_seen else 0.0, Uncertainty(100.0 * error))
        row["overshoot_known_to"] = 100.0 * (max(beyond, 0.0) + NORMAL * error)

    def is_at_rest(self) -> bool:
        """False where the record ends too early to know the final value."""
        time = self.smooth.time
        last = self.part[time >= time[-1] - TAIL * (time[-1] - time[0])]
        half = last.size // 2
        drift = abs(float(np.mean(last[half:]) - np.mean(last[:half])))
        return drift <= max(DRIFT, 4.0 * math.sqrt(2.0) * self.noise.mean(half)) and math.isfinite(self._settled()[0])

    def _settled(self) -> tuple[float, Uncertainty]:
        return self.smooth.leaving(BAND, self.errors[1])

    def settles(self, found: Evaluation, row: Row) -> bool:
        """Enter the settling time; False where noise hides when the outlet stays in its band."""
        time, doubt = self._settled()
        clock = self.smooth.time
        begin = clock[-1] - TAIL * (clock[-1] - clock[0])
        if not math.isfinite(doubt.standard) or doubt.interval(time)[1] > begin:
            return False
        found.know(row, "settling_time", time, doubt.plus(self.jump))
        return True


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
        every = [mean_of(*found.known(rows, "delay")) for rows in ways.values() if rows]
        value, doubt, _ = greatest(*zip(*every, strict=True))
        found.add("delay", value, doubt, **_case(reference[0]))
    else:
        found.absent("unsettled", "delay")
    for way, rows in ways.items():
        for key in ("rise_time", "response_time"):
            if rows:
                found.add(f"{key}_{way}", *mean_of(*found.known(rows, key)), **_case(rows[0]))
            else:
                found.absent(f"unsettled_{way}", f"{key}_{way}")
    settled = [row for row in first if "settling_time" in row]
    if settled:
        value, doubt, k = greatest(*found.known(settled, "settling_time"))
        found.add("settling_time", value, doubt, **_case(settled[k]))
    else:
        found.absent("noisy" if first else "unsettled", "settling_time")
    _overshoot(found, first)
    humming = [row for row in found.rows if "hum_amplitude" in row]
    if not humming:
        found.note("step.rests")
        return
    value, doubt, k = greatest(*found.known(humming, "hum_amplitude"))
    found.add("hum_amplitude", value, doubt, **_case(humming[k]))
    row = humming[k]
    found.add("hum_frequency", row["hum_frequency"], found.doubts[id(row), "hum_frequency"], **_case(row))


def _overshoot(found: Evaluation, rows: Sequence[Row]) -> None:
    if not rows:
        found.absent("no_step", "overshoot")
        return
    seen = [row for row in rows if row["overshoot"] > 0.0] or list(rows)
    value, doubt, k = greatest(*found.known(seen, "overshoot"))
    if any("overshoot_bound" in row for row in rows):
        found.add("overshoot", max(row["overshoot"] for row in rows), bound=AT_LEAST, **_case(seen[k]))
    elif value > 0.0:
        found.add_judged("overshoot", value, doubt, **_case(seen[k]))
    else:
        least = max(row["overshoot_known_to"] for row in rows)
        is_bound = least > 1e-4
        found.add("overshoot", least if is_bound else 0.0, doubt, bound=AT_MOST if is_bound else "", **_case(seen[k]))


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

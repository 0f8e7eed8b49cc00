"""Test of setpoint steps: delay, rise time, settling time, overshoot and limit cycles."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

import numpy as np

from poppet.bench.iso10094.evaluation import AT_LEAST, AT_MOST, DYNAMIC, BenchTest, Evaluation, Row, Trial
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import Jump, find_jumps, steady_part
from poppet.bench.iso10094.smoothing import WIDTHS, parabola, smooth_response
from poppet.bench.iso10094.uncertainty import NORMAL, Noise, Uncertainty, estimate_noise, greatest, mean_of
from poppet.timeseries.measurements.measurement import noise_of
from poppet.timeseries.signals import Steps

LOW, HIGH = 0.1, 0.9  # fractions of a step at the start and end of the rise time
BAND = 0.05  # half width of the settling band, as a fraction of the step
FINE = 15.0  # settling band relative to the noise above which samples are not smoothed by wider parabolas
NARROWEST = 0.2  # half width of the widest parabola that keeps the shape of a response, as a fraction of the rise time
SEEN = 5.0  # limit of the noise of the largest smoothed sample, in standard deviations
LEAST_STEP = 2.0  # smallest change of the setpoint that counts as a step [% FS]
TAIL = 0.2  # last fraction of a hold, in which the outlet is in steady state
FOLLOWS = 0.2  # smallest change of the outlet, as a fraction of the setpoint step
DRIFT = 0.01  # change between the halves of the tail, as a fraction of the step, above which the outlet has not settled
SHORT = 5.0  # deviation from the setpoint above which the setpoint is not reached [% FS]
COARSE = 0.02  # duration of a recorded setpoint step relative to the delay, above which a note is given
ALIKE = 1.6  # largest ratio of the scatter in two holds with the same noise
POINTS = 400
MOST_ROWS = 40_000  # maximum number of rows of a hold
CASE = ("from", "to", "volume", "sampling")  # conditions of a step for its characteristic values


def step_trial(scale: Scale, volume: float, amplitude: float, hold: float) -> Trial:
    """Return a trial with a step up and a step down.

    The steps are symmetric about the middle of the range. `amplitude` is the height of each step [% FS], `hold` the
    time at each level [s], and `volume` the outlet volume [m^3].
    """
    low, high = (float(scale.setpoint(50.0 + side * amplitude / 2.0)) for side in (-1.0, 1.0))
    # The steps coincide with rows: both are multiples of a quarter of the hold.
    signal = Steps((0.0, hold + 0.25 * hold, hold + 1.25 * hold), (low, high, low))
    name = f"step of {amplitude:g} % FS, {1e3 * volume:.4g} l"
    return Trial("step", name, signal, hold + 2.25 * hold, hold, hold / MOST_ROWS, volume)


def _evaluate(evaluation: Evaluation, records: Sequence[Record]) -> None:
    for record in records:
        x, y = evaluation.scale.percents(record)
        steps = find_jumps(record.time, x, LEAST_STEP, is_exact=record.is_exact)
        if not steps:
            evaluation.note("step.none", record.name, least=LEAST_STEP)
        begins = [0, *(jump.after for jump in steps)]
        ends = [*(jump.before + 1 for jump in steps), record.time.size]
        holds = [slice(begin, end) for begin, end in zip(begins, ends, strict=True)]
        for jump, (before, after) in zip(steps, pairwise(holds), strict=True):
            _evaluate_step(evaluation, record, x, y, jump, before, after, holds)
    _add_characteristic_values(evaluation)


def _evaluate_step(
    evaluation: Evaluation, record: Record, x: FloatArray, y: FloatArray, jump: Jump, before: slice, after: slice,
    holds: Sequence[slice],
) -> None:  # fmt: skip
    """Evaluate one step of the setpoint, and add its row to the evaluation.

    `x` and `y` are setpoint and outlet pressure in % FS. `jump` is the step. `before` and `after` are the sections of
    constant setpoint before and after it, and `holds` all such sections of the record.
    """
    if min(before.stop - before.start, after.stop - after.start) < 5:
        evaluation.note("step.no_samples", record.name, time=jump.time)
        return
    earlier, tail = steady_part(record.time, before, TAIL), steady_part(record.time, after, TAIL)
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
    evaluation.rows.append(row)

    def note(code: str, **facts: Any) -> None:
        evaluation.note(f"step.{code}", record.name, direction=row["direction"], start=low, end=high, **facts)

    if any(record.has_clipped_samples("outlet", part=part) for part in (earlier, tail)):
        # Without both steady values, fractions of the step are undefined.
        row["is_clipped"] = True
        note("clipped")
        return
    hum = detect_limit_cycle(record.time[tail], y[tail])
    if hum is not None:
        evaluation.set_value(row, "hum_amplitude", hum.amplitude, Uncertainty(hum.amplitude_error))
        evaluation.set_value(row, "hum_frequency", hum.frequency, Uncertainty(hum.frequency_error))
        note("swings", amplitude=hum.amplitude, frequency=hum.frequency)
    if abs(end - high) > SHORT:
        note("short", outlet=end)
    if (end - start) / (high - low) < FOLLOWS:
        note("hardly", moved=end - start)
        return
    # Other steady parts contribute if they scatter alike: a short part underestimates slow noise.
    size = float(np.std(np.concatenate([y[part] - np.mean(y[part]) for part in (earlier, tail)])))
    rests = (steady_part(record.time, hold, TAIL) for hold in holds)
    others = (y[part] for part in rests if part.start not in (earlier.start, tail.start))
    alike = [part for part in others if part.size > 3 and size < ALIKE * float(np.std(part)) < ALIKE**2 * size]
    noise = estimate_noise([y[earlier], y[tail], *alike])
    section = slice(before.start, after.stop)
    reason = _add_times(evaluation, row, record, y, jump, section, noise, (earlier, tail))
    if record.has_clipped_samples("outlet", part=after):
        row["overshoot_bound"] = AT_LEAST
        note("clipped_peak")
    if reason:
        note(reason, **({} if reason == "unsettled" else {"band": 100.0 * BAND}))
    row["is_settled"] = reason != "unsettled"
    if not record.is_exact and jump.duration > COARSE * row.get("delay", math.inf):
        note("coarse", error=0.5 * jump.duration, delay=row["delay"])
    # The curve begins shortly before the step and ends after the outlet has settled.
    lasts = max(2.0 * row.get("settling_time", 0.0), 3.0 * row.get("response_time", 0.0)) or math.inf
    lead = 0.1 * min(lasts, record.time[after.stop - 1] - jump.time)
    first = max(0, int(np.searchsorted(record.time, jump.time - lead)))
    last = min(after.stop, int(np.searchsorted(record.time, jump.time + lasts)) + 1) - 1
    indices = np.unique(np.linspace(first, last, POINTS).astype(int))
    volume = f", {1e3 * record.volume:.4g} l" if math.isfinite(record.volume) else ""
    change = 100.0 * (y[indices] - start) / (end - start)  # in per cent of the total change
    evaluation.add_curve("outlet", f"{high - low:+.3g} % FS{volume}", record.time[indices] - jump.time, change)


def _add_times(
    evaluation: Evaluation, row: Row, record: Record, y: FloatArray, jump: Jump, section: slice, noise: Noise,
    holds: tuple[slice, slice],
) -> str:  # fmt: skip
    """Set the response times and the overshoot in a row of results.

    `y` is the outlet pressure in % FS. `section` is the part of the record with both holds, and `noise` the noise of
    the outlet. `holds` are the steady parts before and after the step. If the settling time cannot be determined, the
    result is the code of the note that states why.
    """
    start, end = row["outlet_from"], row["outlet_to"]
    noise = Noise(noise.covariance / (end - start) ** 2)
    # The step response from 0 (initial value) to 1 (final value), from the last sample before the step.
    time, relative = record.time[section] - jump.time, (y[section] - start) / (end - start)
    response = smooth_response(time, relative, noise).from_sample(jump.before - section.start)
    start_error, end_error = (noise.mean(hold.stop - hold.start) for hold in holds)
    # A setpoint from the clock of the recording changes exactly at a sample, in all repetitions alike.
    instant = Uncertainty(0.0, common=0.0 if record.is_exact else 0.5 * jump.duration)
    errors = [math.hypot((1.0 - level) * start_error, level * end_error) for level in (LOW, HIGH)]
    (low, low_doubt), (high, high_doubt) = map(response.crossing, (LOW, HIGH), errors)
    if math.isfinite(low_doubt.standard) and math.isfinite(high_doubt.standard):
        evaluation.set_value(row, "delay", low, low_doubt.plus(instant))
        evaluation.set_value(row, "rise_time", high - low, low_doubt.plus(high_doubt))
        evaluation.set_value(row, "response_time", high, high_doubt.plus(instant))
    # Single noisy samples must not leave the band: the parabolas are wide enough, if the rise time permits it.
    widths = [width for width in WIDTHS if width * record.step < NARROWEST * (high - low)]
    clear = (width for width in widths if FINE * noise.of(parabola(width)) < BAND)
    narrowest = 0 if FINE * noise.sigma < BAND else next(clear, max(widths, default=0))
    response = smooth_response(time, relative, noise, narrowest).from_sample(jump.before - section.start)
    summit, uncertainty = response.peak()
    excess, error = summit - 1.0, uncertainty.plus_normal(end_error).standard
    # Without overshoot, the largest sample is noise.
    is_seen = excess > max(SEEN * error, 1e-6)
    evaluation.set_value(row, "overshoot", 100.0 * excess if is_seen else 0.0, Uncertainty(100.0 * error))
    row["excess"] = 100.0 * max(excess, 0.0)
    row["overshoot_known_to"] = 100.0 * (max(excess, 0.0) + NORMAL * error)
    if row.get("hum_amplitude", 0.0) > BAND * abs(end - start):
        return "swings_out"
    begin = response.time[-1] - TAIL * (response.time[-1] - response.time[0])
    last = response.raw[response.time >= begin]
    half = last.size // 2
    drift = abs(float(np.mean(last[half:]) - np.mean(last[:half])))
    settling_time, uncertainty = response.settling_time(BAND, end_error)
    if drift > max(DRIFT, 4.0 * math.sqrt(2.0) * noise.mean(half)) or not math.isfinite(settling_time):
        return "unsettled"
    is_noisy = SEEN * float(np.max(response.errors)) > BAND
    if is_noisy or not math.isfinite(uncertainty.standard) or uncertainty.interval(settling_time)[1] > begin:
        return "noisy"
    evaluation.set_value(row, "settling_time", settling_time, uncertainty.plus(instant))
    return ""


def _add_characteristic_values(evaluation: Evaluation) -> None:
    """Add the characteristic values of all steps to the evaluation.

    If clipped steps were omitted, the largest values of the remaining steps are added as bounds.
    """
    volumes = list(dict.fromkeys(row.get("volume", math.nan) for row in evaluation.rows))
    # The final value of an unsettled step is unknown, and so are fractions of this step.
    evaluated = [row for row in evaluation.rows if "response_time" in row and row["is_settled"]]
    first = [row for row in evaluated if row.get("volume", math.nan) == volumes[0] or math.isnan(volumes[0])]
    size = max((row["amplitude"] for row in first), default=0.0)
    reference = [row for row in first if row["amplitude"] > 0.98 * size]
    # Without a step that the outlet follows, no outlet pressure can settle.
    reason = "unsettled" if any("response_time" in row for row in evaluation.rows) else "no_step"
    rows_by_direction = {way: [row for row in reference if row["direction"] == way] for way in ("up", "down")}
    if reference:
        _add_longest(evaluation, "delay", reference)
    else:
        evaluation.note_absence(reason, "delay")
    for direction, rows in rows_by_direction.items():
        for key in ("rise_time", "response_time"):
            if rows:
                evaluation.add(f"{key}_{direction}", *mean_of(*evaluation.values_of(rows, key)), **_case(rows[0]))
            else:
                cause = f"unsettled_{direction}" if reason == "unsettled" else reason
                evaluation.note_absence(cause, f"{key}_{direction}")
    settled = [row for row in first if "settling_time" in row]
    if settled:
        _add_longest(evaluation, "settling_time", settled)
    else:
        evaluation.note_absence("noisy" if first else reason, "settling_time")
    _overshoot(evaluation, first)
    row = evaluation.add_greatest("hum_amplitude", "hum_amplitude", conditions=CASE)
    if row is None:
        evaluation.note("step.rests")
    else:
        uncertainty = evaluation.uncertainties[id(row), "hum_frequency"]
        evaluation.add("hum_frequency", row["hum_frequency"], uncertainty, **_case(row))
    sizes = [row["amplitude"] for row in evaluation.rows if "is_clipped" in row]
    if not sizes:
        return
    names = {"settling_time", "overshoot"}
    for name, figure in list(evaluation.figures.items()):
        step = abs(figure.conditions.get("to", math.nan) - figure.conditions.get("from", math.nan))
        if name not in names and not name.startswith("hum") and not step > 0.98 * max(sizes):
            del evaluation.figures[name]
            names.add(name)
    absent = (name for name in _FIGURES if name not in evaluation.figures and not name.startswith("hum"))
    evaluation.limit_to_bounds(*names, *absent)
    if "hum_amplitude" not in evaluation.figures:
        evaluation.notes = [note for note in evaluation.notes if note.code != "bench.step.rests"]
        evaluation.note_absence("clipped", "hum_amplitude", "hum_frequency")


def _add_longest(evaluation: Evaluation, name: str, rows: Sequence[Row]) -> None:
    """Add the longest time of the rows to the evaluation.

    Repetitions of the same step count as one step, with their mean time.
    """
    groups = _repetitions(rows)
    means = [mean_of(*evaluation.values_of(group, name)) for group in groups]
    value, uncertainty, k = greatest(*zip(*means, strict=True))
    evaluation.add(name, value, uncertainty, **_case(groups[k][0]))


def _repetitions(rows: Sequence[Row]) -> list[list[Row]]:
    """Return the rows in groups of equal steps."""
    groups: list[list[Row]] = []
    for row in rows:
        alike = (group for group in groups if all(abs(group[0][key] - row[key]) < LEAST_STEP for key in ("from", "to")))
        group = next(alike, None)
        if group is None:
            groups.append([row])
        else:
            group.append(row)
    return groups


def _overshoot(evaluation: Evaluation, rows: Sequence[Row]) -> None:
    if not rows:
        evaluation.note_absence("no_step", "overshoot")
        return
    # The mean of the visible repetitions alone would be too large.
    groups = [group for group in _repetitions(rows) if any(row["overshoot"] > 0.0 for row in group)]
    visible = [group[0] for group in groups] or list(rows)
    if groups:
        means = [mean_of([row["excess"] for row in g], evaluation.values_of(g, "overshoot")[1]) for g in groups]
        value, uncertainty, k = greatest(*zip(*means, strict=True))
    else:
        value, uncertainty, k = greatest(*evaluation.values_of(visible, "overshoot"))
    if any("overshoot_bound" in row for row in rows):
        evaluation.add("overshoot", max(row["overshoot"] for row in rows), bound=AT_LEAST, **_case(visible[k]))
    elif value > 0.0:
        evaluation.add_nonnegative("overshoot", value, uncertainty, **_case(visible[k]))
    else:
        least = max(row["overshoot_known_to"] for row in rows)
        least, bound = (least, AT_MOST) if least > 1e-4 else (0.0, "")
        evaluation.add("overshoot", least, uncertainty, bound=bound, **_case(visible[k]))


def _case(row: Row) -> Row:
    return {key: row[key] for key in CASE if key in row}


_FIGURES = {
    "delay": "s", "rise_time_up": "s", "response_time_up": "s", "rise_time_down": "s", "response_time_down": "s",
    "settling_time": "s", "overshoot": "%", "hum_amplitude": "% FS", "hum_frequency": "Hz",
}  # fmt: skip
_LEVELS = {"low": 100.0 * LOW, "high": 100.0 * HIGH, "band": 100.0 * BAND}
STEP = BenchTest("step", _evaluate, _FIGURES, _LEVELS, table="steps", part=DYNAMIC)


WIDER = 1.15  # standard deviation of the noise, relative to the residual of a fitted sine
CHANCE = 1e-4  # probability that noise alone is detected as a limit cycle
FEWEST = 32
LEAST = 1e-2  # smallest amplitude of a limit cycle [% FS]
FIRST = 3  # smallest number of periods in a hold; fewer periods are a drift


@dataclass(frozen=True)
class LimitCycle:
    """Limit cycle: amplitude (half of the peak-to-peak value) [% FS] and frequency [Hz]."""

    amplitude: float
    frequency: float
    amplitude_error: float = 0.0  # standard uncertainties
    frequency_error: float = 0.0


def detect_limit_cycle(time: FloatArray, outlet: FloatArray) -> LimitCycle | None:
    """Return the limit cycle of an outlet pressure [% FS] in steady state.

    The result is None if noise can explain the motion. After removal of the drift, the largest line of the spectrum is
    compared with the mean of the other lines (Fisher's g test). The amplitude comes from the mean of all periods, so
    noise and waveform cause little bias.

    Examples
    --------
    >>> t = np.linspace(0.0, 1.0, 500)
    >>> hum = detect_limit_cycle(t, 40.0 + 0.3 * np.sin(2.0 * np.pi * 21.0 * t))
    >>> round(hum.amplitude, 2), round(hum.frequency, 1)
    (0.3, 21.0)
    """
    if time.size < FEWEST:
        return None
    even = np.linspace(time[0], time[-1], time.size)
    values = np.interp(even, time, outlet)
    values = values - np.polyval(np.polyfit(even - even[0], values, 1), even - even[0])
    if float(np.ptp(values)) < 2.0 * LEAST:
        return None
    power = np.abs(np.fft.rfft(values * np.hanning(values.size))) ** 2
    spectrum = power[FIRST:]
    index = int(np.argmax(spectrum))
    # The spectrum of a slowly settling outlet falls with frequency; a limit cycle is a local maximum.
    if power[FIRST + index - 1] >= spectrum[index]:
        return None
    line, total = float(np.sum(spectrum[max(index - 1, 0) : index + 2])), float(np.sum(spectrum))
    lines = spectrum.size / 1.5  # neighbouring lines of a windowed spectrum have common noise
    # Largest fraction of the power in one line of white noise, exceeded only with the probability `CHANCE`.
    if line < min(0.9, 3.0 * min(1.0, math.log(lines / CHANCE) / lines)) * total:
        return None
    index += FIRST
    # The frequency of the best fitting sine near the line.
    frequency, width = index / (even[-1] - even[0]), 1.0 / (even[-1] - even[0])
    for _ in range(5):
        trial = frequency + width * np.linspace(-1.0, 1.0, 21)
        phases = (2.0 * math.pi * f * (even - even[0]) for f in trial)
        powers = [float((values @ np.cos(phase)) ** 2 + (values @ np.sin(phase)) ** 2) for phase in phases]
        frequency = float(trial[np.argmax(powers)])
        width *= 0.1
    amplitude, residual = _half_swing(even, values, frequency, noise_of(values))
    if not amplitude > LEAST:
        return None
    # Standard errors of a sine in noise: D. C. Rife and R. R. Boorstyn, IEEE Trans. Inf. Theory 20 (1974) 591-598.
    span = float(even[-1] - even[0])
    noise = estimate_noise([residual], 0).at(2.0 * math.pi * frequency * span / even.size)
    error = WIDER * noise / math.sqrt(even.size)
    return LimitCycle(
        amplitude, frequency, math.sqrt(2.0) * error, math.sqrt(6.0) * error / (math.pi * amplitude * span)
    )


def _half_swing(time: FloatArray, values: FloatArray, frequency: float, noise: float) -> tuple[float, FloatArray]:
    """Return half of the peak-to-peak value of the mean period, and the residual.

    `frequency` is the frequency of the motion [Hz], and `noise` the standard deviation of the noise. The mean period is
    the sum of the fitted harmonics that exceed the noise. The residual is the series minus all fitted harmonics.
    """
    phase = 2.0 * math.pi * frequency * (time - time[0])
    per_period = values.size / (frequency * (time[-1] - time[0]))
    highest = max(1, min(10, int(per_period / 4.0)))
    orders = range(1, highest + 1)
    columns = [np.ones_like(phase), *(np.cos(k * phase) for k in orders), *(np.sin(k * phase) for k in orders)]
    coefficients = np.linalg.lstsq(np.stack(columns, axis=1), values, rcond=None)[0]
    turn = np.linspace(0.0, 2.0 * math.pi, 400, endpoint=False)
    wave = np.zeros_like(turn)
    floor = 4.0 * noise * math.sqrt(2.0 / values.size)
    for k, a, b in zip(orders, coefficients[1 : highest + 1], coefficients[highest + 1 :], strict=True):
        if k == 1 or math.hypot(a, b) > floor:
            wave += a * np.cos(k * turn) + b * np.sin(k * turn)
    return 0.5 * float(np.ptp(wave)), values - np.stack(columns, axis=1) @ coefficients

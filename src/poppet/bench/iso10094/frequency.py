"""Test of the frequency response: fundamental and harmonics of sinusoidal responses by regression."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from poppet.bench.iso10094.evaluation import AT_LEAST, DYNAMIC, BenchTest, Evaluation, Row, Trial
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.bench.iso10094.shapes import unmasked_section
from poppet.bench.iso10094.uncertainty import SEED, Uncertainty, greatest
from poppet.laws.curves.pchip import pchip_slopes
from poppet.timeseries.signals import Sine

GAIN_DB, PHASE_DEG = -3.0, -90.0  # gain and phase that define the two bandwidths
PERIODS, PER_PERIOD = 6, 200  # recorded whole periods of a sine, and rows per period
HIGHEST = 5  # highest harmonic of the distortion
FEWEST = 3  # smallest number of whole periods for an evaluation
ASTRAY = 0.05  # deviation from a sine, relative to its amplitude, at which another signal begins
ALIKE = 0.04  # relative difference of periods within one sine
STEADY = 0.01  # relative change of the fundamental between periods, below which the transient has ended
UNSEEN = 1.15  # factor on the standard deviation of noise at one frequency, because few neighbours estimate it
UNLIKE = 5.0  # limit of the noise of a period, in standard errors
SAME = 1.15  # largest ratio of amplitudes in one Bode plot
CLIPPED = ("bench.frequency.clipped", "bench.frequency.impure")
PURE = 0.03  # relative harmonics of the setpoint above which it is not a sine
LONG = 2000  # number of samples from which the normal equations are accurate, because the columns are nearly orthogonal
SINE_DRAWS = 100  # number of noise draws for the scatter of a bandwidth
BETWEEN = 0.25  # interpolation error of the monotone cubic, relative to that of a straight line
IN_DB = 20.0 / math.log(10.0)
FAINT = 4.0  # detection limit of a fundamental, in standard errors
OPPOSITE = 30.0  # deviation from a phase of -180 deg at the lowest frequency, below which the signal is inverted [deg]
LEADS, MOSTLY = (
    5.0,
    0.5,
)  # smallest lead of the outlet [deg], and fraction of the frequencies above which it is reported
UNMOVED = 1e-9  # smallest gain of an outlet that moves


def frequency_trial(
    scale: Scale, volume: float, frequency: float, hold: float, *, mean: float, amplitude: float
) -> Trial:
    """Return a trial with a sinusoidal setpoint about a mean value.

    The keywords `mean` and `amplitude` are in % FS, `frequency` is in Hz, `hold` is the settling time of the valve [s],
    and `volume` the outlet volume [m^3]. Six periods are recorded after the transient.
    """
    settling = max(2.0, math.ceil(hold * frequency)) / frequency
    unit = (scale.setpoint_high - scale.setpoint_low) / 100.0
    signal = Sine(float(scale.setpoint(mean)), amplitude * unit, frequency)
    duration = settling + (PERIODS + 0.3) / frequency
    return Trial("frequency", f"{frequency:.4g} Hz", signal, duration, settling, 1.0 / (PER_PERIOD * frequency), volume)


@dataclass(frozen=True)
class SineComponent:
    """Sine that was fitted to a series, with mean value and harmonic distortion."""

    value: complex  # complex amplitude relative to a sine from the start of the record, in the unit of the series
    mean: float
    distortion: float  # root of the sum of squares of harmonics 2 to 5 over the fundamental
    error: float  # standard error of its amplitude
    harmonic_error: float  # standard error of the amplitude of each harmonic


def _evaluate(evaluation: Evaluation, records: Sequence[Record]) -> None:
    rows = [row for record in records for row in sine_rows(evaluation, record)]
    add_frequency_results(evaluation, rows)
    lowest = min((row["frequency"] for row in rows), default=math.inf)
    lost = [note.facts["frequency"] for note in evaluation.notes if note.code == "bench.frequency.lost"]
    if lost and min(lost) < lowest:
        evaluation.note("frequency.dead", frequency=min(lost))
    leads = sorted((row for row in rows if row["phase"] > LEADS), key=lambda row: float(row["frequency"]))
    # A large lag looks like a lead, but not at the lowest frequency.
    if len(leads) > MOSTLY * len(rows) and leads[0]["frequency"] == lowest and leads[0]["phase"] < 90.0:
        facts = {"phase": leads[0]["phase"], "frequency": lowest}
        evaluation.note("frequency.leads", count=len(leads), total=len(rows), **facts)
    clipped_frequencies = [note.facts["frequency"] for note in evaluation.notes if note.code in CLIPPED]
    if clipped_frequencies:
        evaluation.limit_to_bounds("distortion")
        # Gains and phases are relative to the lowest frequency; other clipped frequencies do not affect them.
        is_relative = min(clipped_frequencies) < min((row["frequency"] for row in evaluation.rows), default=math.inf)
        names = ("bandwidth_gain", "bandwidth_phase")
        evaluation.remove_values(*(name for name in names if is_relative or name not in evaluation.figures))


def sine_rows(evaluation: Evaluation, record: Record) -> list[Row]:
    """Return one table row with the gain and phase of each sine in a record.

    Sines that cannot be evaluated are omitted, with a note.
    """
    x, y = evaluation.scale.percents(record)
    parts = find_sines(record.time, x)
    if not parts:
        evaluation.note("frequency.no_sine", record.name, fewest=FEWEST)
    rows = (_evaluate_sine(evaluation, record, part, x[part], y[part]) for part in parts)
    return [row for row in rows if row is not None]


def add_frequency_results(evaluation: Evaluation, rows: Sequence[Row]) -> None:
    """Add Bode plots, bandwidths and distortion to the evaluation.

    `rows` are the table rows of all sines. Sines with the same amplitude, mean and volume form one Bode plot. Its rows
    are sorted by frequency, with continuous phases, and with gains relative to the gain at the lowest frequency. If
    several rows have the same frequency, the row with the most periods is used. The bandwidths are read from the first
    Bode plot.
    """
    series: dict[str, list[Row]] = {}
    for row in rows:
        series.setdefault(_name_of_bode_plot(row, rows), []).append(row)
    for name, group in series.items():
        by_frequency: dict[float, Row] = {}
        for row in group:
            key = float(f"{row['frequency']:.3g}")
            if key not in by_frequency or row["periods"] > by_frequency[key]["periods"]:
                by_frequency[key] = row
        ordered = sorted(by_frequency.values(), key=lambda row: float(row["frequency"]))
        frequency = np.array([row["frequency"] for row in ordered])
        phases = np.degrees(np.unwrap(np.radians([row["phase"] for row in ordered])))
        phases -= 360.0 if phases[0] > 90.0 else 0.0  # a response lags
        gains = np.array([20.0 * math.log10(row["gain"] / ordered[0]["gain"]) for row in ordered])
        triples = zip(ordered, phases.tolist(), gains.tolist(), strict=True)
        ordered = [row | {"phase": phase, "gain_db": gain} for row, phase, gain in triples]
        evaluation.add_curve("gain", name, frequency, gains)
        evaluation.add_curve("phase", name, frequency, phases)
        if not evaluation.rows:  # the first series is the one that counts
            _add_bandwidths(evaluation, ordered, frequency)
        evaluation.rows += ordered
    if not series:
        evaluation.note_absence("no_sine", "bandwidth_gain", "bandwidth_phase", "distortion")


def _sides_of_middle(values: FloatArray) -> NDArray[np.int64]:
    """Return +1, -1 or 0 for each sample above, below or near the middle.

    The middle is halfway between the minimum and the maximum of the series. Samples within a quarter of the range on
    either side are near it, which avoids repeated crossings by noise.
    """
    low, high = float(np.min(values)), float(np.max(values))
    middle, swing = 0.5 * (low + high), 0.25 * float(np.ptp(values))
    return np.where(values > middle + swing, 1, np.where(values < middle - swing, -1, 0))


def find_sines(time: FloatArray, setpoint: FloatArray) -> list[slice]:
    """Return the sections of a setpoint that are sines of constant frequency.

    Each section is a slice of the samples.

    Examples
    --------
    >>> t = np.linspace(0.0, 10.0, 1001)
    >>> [(p.start, p.stop) for p in find_sines(t, 50.0 + 5.0 * np.sin(2.0 * np.pi * t - 0.5))]
    [(0, 1001)]
    """
    middle = 0.5 * (float(np.min(setpoint)) + float(np.max(setpoint)))
    side = _sides_of_middle(setpoint)
    indices = np.flatnonzero(side)
    rises = np.diff(side[indices]) > 0
    # A crossing is interpolated between the last sample below and the first sample above.
    pairs = zip(indices[:-1][rises], indices[1:][rises], strict=True)
    crossings = [float(np.interp(middle, setpoint[[a, b]], time[[a, b]])) for a, b in pairs]
    periods = np.diff(crossings)
    parts, begin = [], 0
    for k in range(1, periods.size + 1):
        if k == periods.size or abs(periods[k] / np.mean(periods[begin:k]) - 1.0) > ALIKE:
            ends = np.searchsorted(time, [crossings[begin], crossings[k]])
            period = (crossings[k] - crossings[begin]) / (k - begin)
            part = _extend_to_whole_sine(time, setpoint, slice(int(ends[0]), int(ends[1])), period)
            # At a change of frequency, one period can look like a third frequency.
            is_alone = begin == 0 and k == periods.size
            if (is_alone or k - begin > 1) and time[part.stop - 1] - time[part.start] > (FEWEST - 0.1) * period:
                parts.append(part)
            begin = k
    return parts


def _extend_to_whole_sine(time: FloatArray, setpoint: FloatArray, part: slice, period: float) -> slice:
    """Extend the section `part` of a setpoint to all samples of its sine.

    The section begins and ends at rising crossings of the mean. `period` is the period of the sine [s]. The extension
    is at most 1.5 periods on either side.
    """
    if part.stop - part.start < 8:
        return part
    frequency = _refine_frequency(time[part], setpoint[part], 1.0 / period)
    fit = fit_sine(time[part], setpoint[part], frequency, highest=1)
    turn = 2.0 * math.pi * frequency * time
    deviation = np.abs(setpoint - fit.mean - fit.value.real * np.sin(turn) - fit.value.imag * np.cos(turn))
    noise = fit.error * math.sqrt(0.5 * (part.stop - part.start))
    is_foreign = deviation > ASTRAY * abs(fit.value) + 4.0 * noise
    is_foreign |= (time < time[part.start] - 1.5 * period) | (time > time[part.stop - 1] + 1.5 * period)
    return unmasked_section(is_foreign, part.start, part.stop)


def _evaluate_sine(evaluation: Evaluation, record: Record, part: slice, x: FloatArray, y: FloatArray) -> Row | None:
    """Return the table row of one sine: gain and phase of its final steady periods.

    `x` and `y` are setpoint and outlet pressure [% FS] in the section `part`. If the sine cannot be evaluated, a note
    states the reason and the result is None.
    """
    time = record.time[part]
    side = _sides_of_middle(x)
    indices = np.flatnonzero(side)
    crossings = 0.5 * (time[indices[:-1]] + time[indices[1:]])[np.diff(side[indices]) != 0]
    frequency = _refine_frequency(time, x, 0.5 * (crossings.size - 1) / float(crossings[-1] - crossings[0]))
    if record.has_clipped_samples("setpoint", "outlet", part=part):
        evaluation.note("frequency.clipped", record.name, frequency=frequency)
        return None
    count = _steady_periods(time, y, frequency)
    begin = int(np.searchsorted(time, time[-1] + 0.5 * record.step - count / frequency))
    if time.size - begin < 8 * count:
        samples = (time.size - begin) / count
        evaluation.note("frequency.few_samples", record.name, frequency=frequency, samples=samples)
        return None
    setpoint_wave, outlet_wave = (
        fit_sine(time[begin:], series[begin:], frequency, is_coloured=True) for series in (x, y)
    )
    if setpoint_wave.distortion > PURE:
        distortion = 100.0 * setpoint_wave.distortion
        evaluation.note("frequency.impure", record.name, frequency=frequency, distortion=distortion)
        return None
    # Rounding gives a dead sensor a tiny fundamental.
    if abs(outlet_wave.value) <= max(FAINT * outlet_wave.error, UNMOVED * abs(setpoint_wave.value)):
        evaluation.note("frequency.lost", record.name, frequency=frequency)
        return None
    size, outlet_size = abs(setpoint_wave.value), abs(outlet_wave.value)
    row: Row = {
        "record": record.name, "frequency": frequency, "mean": setpoint_wave.mean, "amplitude": size,
        "outlet_amplitude": outlet_size, "gain": outlet_size / size,
        "phase": math.degrees(float(np.angle(outlet_wave.value / setpoint_wave.value))),
        "distortion": 100.0 * outlet_wave.distortion, "periods": count, "is_steady": count >= FEWEST,
    }  # fmt: skip
    # One standard deviation of the logarithm of the gain, and of the phase [rad]: of both waves.
    row["relative_error"] = math.hypot(setpoint_wave.error / size, outlet_wave.error / outlet_size)
    row["distortion_uncertainty"] = 100.0 * outlet_wave.harmonic_error / outlet_size
    if math.isfinite(record.volume):
        row["volume"] = record.volume
    if not row["is_steady"]:
        total = math.floor((time[-1] - time[0]) * frequency + 0.02)
        evaluation.note("frequency.unsteady", record.name, frequency=frequency, count=count, total=total)
    return row


def _name_of_bode_plot(row: Row, rows: Sequence[Row]) -> str:
    """Return the name of the Bode plot to which a table row belongs.

    The name contains amplitude, mean and volume. Rows with approximately the same values belong to one plot, which is
    named after the first of them.
    """

    def is_alike(candidate: Row) -> bool:
        sizes = row["amplitude"], candidate["amplitude"]
        is_near = max(sizes) < SAME * min(sizes) and abs(row["mean"] - candidate["mean"]) < 0.5 * max(sizes)
        return is_near and row.get("volume") == candidate.get("volume")

    first = next(filter(is_alike, rows))
    volume = f", {1e3 * first['volume']:.4g} l" if "volume" in first else ""
    return f"{first['amplitude']:.2g} % FS about {first['mean']:.3g} % FS{volume}"


def _refine_frequency(time: FloatArray, x: FloatArray, guess: float) -> float:
    """Return the frequency of a sine [Hz], refined from the estimate `guess` [Hz].

    The frequency is corrected until fits to both halves of the series `x` have the same phase.
    """
    frequency = guess
    half = time.size // 2
    for _ in range(4):
        first, last = (fit_sine(time[s], x[s], frequency, highest=1).value for s in (slice(half), slice(half, None)))
        drift = float(np.angle(last / first))
        spacing = 0.5 * (time[-1] - time[0])
        frequency += drift / (2.0 * math.pi * spacing)
    return float(frequency)


def fit_sine(
    time: FloatArray, values: FloatArray, frequency: float, *, highest: int = HIGHEST, is_coloured: bool = False
) -> SineComponent:
    """Fit a sine of known frequency [Hz] to a series by least squares.

    The fit includes harmonics up to the order `highest` (a keyword), a mean and a linear drift. If the keyword
    `is_coloured` is True, the standard error takes correlated noise into account.

    Examples
    --------
    >>> t = np.arange(400) / 100.0
    >>> found = fit_sine(t, 3.0 + 2.0 * np.sin(2.0 * np.pi * t) + 0.1 * np.sin(4.0 * np.pi * t), 1.0)
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
    coefficients = (
        np.linalg.solve(matrix.T @ matrix, matrix.T @ values)
        if time.size > LONG
        else np.asarray(np.linalg.lstsq(matrix, values, rcond=None)[0])
    )
    residual = values - matrix @ coefficients
    sigma = math.sqrt(float(residual @ residual) / max(1, time.size - len(columns)))
    waves = coefficients[2::2] + 1j * coefficients[3::2]
    size = abs(waves[0])
    covariance = np.linalg.pinv(matrix.T @ matrix)
    error = harmonic_error = sigma * math.sqrt(0.5 * float(covariance[2, 2] + covariance[3, 3]))
    factor = UNSEEN if is_coloured else 1.0
    if is_coloured:
        # The response to a sine has no power between its harmonics. The power of the residuals there, near the
        # fundamental and near the harmonics 2 to 5, is therefore noise.
        amplitudes = np.abs(np.fft.rfft(residual)) * (2.0 / residual.size)
        periods = round(time.size / per_period)
        order = np.arange(amplitudes.size) / periods
        is_between = (np.arange(amplitudes.size) % periods != 0) & (order < HIGHEST + 0.5)
        near = is_between & (order > 0.5) & (order < 2.5), is_between & (order > 1.5)
        error, harmonic_error = (
            float(np.sqrt(0.5 * np.mean(amplitudes[part] ** 2))) if part.any() else error for part in near
        )
    # The noise power adds to the power of each harmonic.
    power = float(np.sum(np.abs(waves[1:]) ** 2))
    harmonics = math.sqrt(max(power - 2.0 * waves[1:].size * harmonic_error**2, 0.0))
    distortion = harmonics / float(size) if size > 0.0 else math.inf
    return SineComponent(complex(waves[0]), float(coefficients[0]), distortion, factor * error, factor * harmonic_error)


def _steady_periods(time: FloatArray, y: FloatArray, frequency: float) -> int:
    """Return the number of steady periods at the end of a sinusoidal response.

    `y` is the outlet pressure, and `frequency` the frequency of the sine [Hz]. Steady periods have the same amplitude
    and phase within the noise.
    """
    total = max(1, math.floor((time[-1] - time[0]) * frequency + 0.02))
    ends = time[-1] - np.arange(total + 1) / frequency
    cuts = np.searchsorted(time, ends + 1e-9 * (time[-1] - time[0]))
    cuts[0] = time.size
    waves = [fit_sine(time[b:a], y[b:a], frequency, highest=2) for a, b in pairwise(cuts) if a - b >= 8]
    if len(waves) < 2:
        return max(1, len(waves))
    last = np.mean([w.value for w in waves[:2]])
    # A single period gives a poor noise estimate without colour; the settled half gives a better one.
    half = slice(int(cuts[(total + 1) // 2]), time.size)
    error = fit_sine(time[half], y[half], frequency, is_coloured=True).error * math.sqrt((total + 1) // 2)
    for count, component in enumerate(waves):
        spread = max(error, component.error if total < FEWEST else 0.0)
        if abs(component.value - last) > STEADY * abs(last) + UNLIKE * spread:
            return max(1, count)
    return len(waves)


def _add_bandwidths(evaluation: Evaluation, rows: list[Row], frequency: FloatArray) -> None:
    first, highest = rows[0], float(frequency[-1])
    evaluation.conditions |= {
        "amplitude": first["amplitude"], "mean": first["mean"], "lowest": float(frequency[0]), "highest": highest,
        "gain_at_lowest": first["gain"],
    }  # fmt: skip
    case = {key: first[key] for key in ("amplitude", "mean", "volume") if key in first}
    relative_errors = np.array([row["relative_error"] for row in rows])
    bands = (("gain", "gain_db", GAIN_DB, -GAIN_DB, IN_DB), ("phase", "phase", PHASE_DEG, PHASE_DEG, math.degrees(1.0)))
    for quantity, key, level, level_text, factor in bands:
        values = np.array([row[key] for row in rows])
        name, value = f"bandwidth_{quantity}", first_fall(frequency, values, level)
        if not math.isnan(value):
            # Noise of the points, and error of the interpolation between them.
            chance = relative_errors * factor * np.random.default_rng(SEED).standard_normal((SINE_DRAWS, values.size))
            chance -= chance[:, :1] if quantity == "gain" else 0.0  # gains are relative to the first one
            samples = np.array([first_fall(frequency, values + deviation, level) for deviation in chance])
            samples = samples[np.isfinite(samples)]
            straight = math.exp(float(np.interp(-level, -np.minimum.accumulate(values), np.log(frequency))))
            spread = float(np.std(samples)) if samples.size >= SINE_DRAWS // 2 else math.nan
            evaluation.add(name, value, Uncertainty(spread, BETWEEN * abs(straight - value)), **case)
        elif values[0] > level and len(rows) > 1:
            evaluation.note(f"frequency.low_{quantity}", name, level=level_text, highest=highest)
            evaluation.add(name, highest, bound=AT_LEAST, **case)
        else:
            evaluation.note_absence(f"between_{quantity}", name, level=level_text)
    if abs(first["phase"] + 180.0) < OPPOSITE:
        evaluation.note("frequency.opposite", frequency=float(frequency[0]), phase=first["phase"])
    elif first["phase"] < -30.0:
        evaluation.note("frequency.not_low", frequency=float(frequency[0]), phase=first["phase"])
    limit = evaluation.figures["bandwidth_gain"].value if "bandwidth_gain" in evaluation.figures else highest
    rows_in_band = [row for row in rows if row["frequency"] <= limit] or [first]
    uncertainties = [Uncertainty(row["distortion_uncertainty"]) for row in rows_in_band]
    value, uncertainty, k = greatest([row["distortion"] for row in rows_in_band], uncertainties)
    evaluation.add_nonnegative("distortion", value, uncertainty, frequency=rows_in_band[k]["frequency"], **case)


def first_fall(frequency: FloatArray, values: FloatArray, level: float) -> float:
    """Return the frequency at which a curve first falls to a level.

    `values` are the values of the curve at the frequencies [Hz]. Between them, the curve is a monotone cubic of the
    logarithm of the frequency. The result is NaN if the first value is already at or below the level, or if all values
    are above the level.

    Examples
    --------
    >>> f = np.array([1.0, 2.0, 4.0, 8.0])
    >>> round(first_fall(f, np.array([0.0, -10.0, -20.0, -30.0]), -15.0) ** 2, 9)
    8.0
    """
    fallen = np.flatnonzero(values <= level)
    if not fallen.size or fallen[0] == 0:
        return math.nan
    k = int(fallen[0])
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
    "frequency", _evaluate, {"bandwidth_gain": "Hz", "bandwidth_phase": "Hz", "distortion": "%"},
    {"gain": -GAIN_DB, "phase": -PHASE_DEG}, table="frequencies", part=DYNAMIC,
)  # fmt: skip

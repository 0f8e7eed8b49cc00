"""Plausibility checks of valve recordings: faulty samples, and probable errors of units, signs, columns and times."""

from __future__ import annotations

import math

import numpy as np

from poppet.bench.iso10094.scale import FloatArray, Mask, Record, Scale
from poppet.core.codes import Note
from poppet.timeseries.measurements.measurement import noise_of, quantum_of

WINDOW = 7  # samples of the median with which a sample is compared
LONGEST = 3  # samples of one spike
SPIKES = 1e-3  # largest fraction of the samples that can be spikes
OUTLYING, ALONE = 12.0, 4.0  # smallest spike, in standard deviations of the noise and in other deviations
EXTREMES = (2.0, 98.0)  # percentiles of the range of a series
MOVES = 5.0  # smallest change of the setpoint for a check of the outlet [% FS]
DEAD, SMALL = 0.02, 0.3  # change of the outlet relative to the setpoint: sensor without signal, wrong unit
OPPOSITE = -0.5  # correlation of setpoint and outlet below which the outlet is inverted
SLOW_STEP, SLOW_TOTAL = 0.25, 6.0 * 3600.0  # time between samples of a dynamic test, and duration of a sweep [s]
FAST_DYNAMIC, FAST_STATIC = 0.05, 0.5  # shortest duration of a recording [s]
FAST_STEP = 3e-5  # shortest time between samples [s]
MOVING = ("characteristic", "step", "frequency")  # tests in which the setpoint moves over a wide range
DYNAMIC = ("step", "frequency")


def without_spikes(values: FloatArray) -> tuple[FloatArray, Mask]:
    """Replace single faulty samples (spikes) of a series by interpolated values.

    The result contains the corrected series and a mask of the replaced samples. A spike differs from the median of its
    neighbours by much more than the noise, and by much more than all other samples do.

    Examples
    --------
    >>> values, is_spike = without_spikes(np.array([1.0, 1.1, 1.2, 60.0, 1.4, 1.5, 1.6, 1.7, 1.9, 2.0]))
    >>> int(is_spike.sum()), round(float(values[3]), 3)
    (1, 1.3)
    """
    from scipy.ndimage import median_filter

    none = np.zeros(values.size, dtype=bool)
    if values.size < WINDOW or float(np.ptp(values)) == 0.0:
        return values, none
    deviation = np.abs(values - median_filter(values, WINDOW, mode="nearest"))
    order = np.argsort(deviation)[::-1]
    count = max(LONGEST, int(SPIKES * values.size))
    sizes = deviation[order[: count + 1]]
    floor = max(OUTLYING * noise_of(values), 1e-9 * float(np.ptp(values)))
    # The largest gap in the sorted deviations separates the spikes from the other samples.
    gaps = np.flatnonzero((sizes[:-1] > ALONE * sizes[1:]) & (sizes[:-1] > floor))
    if not gaps.size:
        return values, none
    is_spike = none.copy()
    is_spike[order[: int(gaps[-1]) + 1]] = True
    edges = np.flatnonzero(np.diff(np.concatenate([[0], is_spike.astype(int), [0]])))
    if np.max(edges[1::2] - edges[::2]) > LONGEST:
        return values, none
    index, valid = np.arange(values.size), values[~is_spike]
    filled = np.interp(index, index[~is_spike], valid)
    step = quantum_of(valid)
    if step > 0.0:  # a value between two steps would change the resolution of the series
        filled = valid[0] + step * np.rint((filled - valid[0]) / step)
    return np.where(is_spike, filled, values), is_spike


def suspicion_notes(record: Record, scale: Scale) -> list[Note]:
    """Return notes on signs of a faulty measurement in a record.

    The signs are a sensor without signal, wrong units, inverted signals, exchanged columns and wrong times.
    """
    # Times that are probably in another unit, by a factor of about 1000.
    timing = {"total": float(record.time[-1] - record.time[0]), "step": record.step, "samples": record.time.size}
    is_dynamic, notes = record.test in DYNAMIC, list[Note]()
    if (is_dynamic and record.step > SLOW_STEP) or timing["total"] > SLOW_TOTAL:
        notes.append(Note("recordings.slow", record.name, **timing))
    elif record.step < FAST_STEP or timing["total"] < (FAST_DYNAMIC if is_dynamic else FAST_STATIC):
        notes.append(Note("recordings.fast", record.name, **timing))
    if record.test not in MOVING or record.time.size < WINDOW:
        return notes
    x, y = scale.percents(record)
    driven, moved = (float(np.ptp(np.percentile(series, EXTREMES))) for series in (x, y))
    if driven < MOVES or float(np.ptp(y)) == 0.0:  # a constant channel has a note of its own
        return notes
    is_quasistatic = record.test != "frequency"
    facts = {"moved": moved, "driven": driven}
    # The range of a noisy constant is four standard deviations.
    if is_quasistatic and moved < max(DEAD * driven, 5.0 * noise_of(y)) and moved < SMALL * driven:
        notes.append(Note("recordings.dead", record.name, **facts))
    elif is_quasistatic and float(np.corrcoef(x, y)[0, 1]) < OPPOSITE:
        notes.append(Note("recordings.inverted", record.name))
    elif is_quasistatic and moved < SMALL * driven:
        notes.append(Note("recordings.outlet_small", record.name, **facts))
    else:
        lead = _lead_of_outlet(record.time, x, y)
        if math.isfinite(lead):
            notes.append(Note("recordings.leads", record.name, lead=lead))
    return notes


def _lead_of_outlet(time: FloatArray, x: FloatArray, y: FloatArray) -> float:
    """Return the time by which the outlet pressure leads the setpoint [s].

    `x` is the setpoint, and `y` the outlet pressure. The function compares the times at which both series cross the
    middle of their ranges. The mean of rising and falling crossings does not depend on the shape of the characteristic.
    The result is NaN if the outlet does not clearly lead.
    """
    (x_up, x_down), (y_up, y_down) = (_crossings(time, series) for series in (x, y))
    leads = []
    for setpoint_times, outlet_times in ((x_up, y_up), (x_down, y_down)):
        if not setpoint_times.size or setpoint_times.size != outlet_times.size:
            return math.nan
        leads.append(setpoint_times - outlet_times)
    mean = 0.5 * float(np.mean(leads[0]) + np.mean(leads[1]))
    scatter = [float(np.var(lead, ddof=1)) / lead.size for lead in leads if lead.size > 1]
    error = math.sqrt(sum(scatter)) if scatter else 0.0
    spacing = float(np.min(np.diff(np.sort(np.concatenate([x_up, x_down])))))
    step = float(np.median(np.diff(time)))
    is_leading = mean > 2.0 * step + 3.0 * error and mean < 0.25 * spacing
    return mean if is_leading else math.nan


def _crossings(time: FloatArray, values: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Return the times at which a series crosses the middle of its range [s].

    The first item contains the upward crossings, the second the downward ones.
    """
    low, high = np.percentile(values, EXTREMES)
    middle, zone = 0.5 * (low + high), 0.15 * (high - low)
    side = np.where(values > middle + zone, 1, np.where(values < middle - zone, -1, 0))
    indices = np.flatnonzero(side)
    changes = np.flatnonzero(np.diff(side[indices]))
    times: dict[int, list[float]] = {1: [], -1: []}
    for first, last in zip(indices[changes], indices[changes + 1], strict=True):
        sign = int(side[last])
        times[sign].append(float(np.interp(sign * middle, sign * values[[first, last]], time[[first, last]])))
    return np.array(times[1]), np.array(times[-1])

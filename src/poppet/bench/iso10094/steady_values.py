"""Outlet at constant setpoint: noise, drift and limit cycles."""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np

from poppet.bench.iso10094.scale import FloatArray
from poppet.bench.iso10094.uncertainty import noise_about
from poppet.timeseries.measurements.noise import noise_of

WIDER = 1.15
"""Standard deviation of the noise over what is left of it beside a sine."""
CHANCE = 1e-4
"""Probability that noise alone makes a line of a spectrum that is taken for a hum."""
FEWEST = 32
LEAST = 1e-2
"""A hum of a smaller amplitude is none: nobody would see it [% FS]."""
FIRST = 3
"""Fewer periods than these in a hold are a drift, no hum."""


@dataclass(frozen=True)
class Hum:
    """Limit cycle: half of its peak-to-peak value [% FS] and its frequency [Hz]."""

    amplitude: float
    frequency: float
    amplitude_error: float = 0.0  # standard uncertainties
    frequency_error: float = 0.0


def hum_of(time: FloatArray, outlet: FloatArray) -> Hum | None:
    """Return a limit cycle about a steady state, None if noise can explain the motion.

    The largest line of the spectrum without drift is compared with the mean of the others (Fisher's g). The amplitude
    is that of the mean period, so noise and waveform cause little bias.

    The largest line of the spectrum, after a straight drift is taken out, is compared with the mean of the others
    (Fisher's g); the swing is that of the mean period, so that neither noise nor the form of the motion bias it much.

    Examples
    --------
    >>> t = np.linspace(0.0, 1.0, 500)
    >>> hum = hum_of(t, 40.0 + 0.3 * np.sin(2.0 * np.pi * 21.0 * t))
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
    # The slow end of a settling outlet falls from line to line; a hum stands above its neighbours.
    if power[FIRST + index - 1] >= spectrum[index]:
        return None
    line, total = float(np.sum(spectrum[max(index - 1, 0) : index + 2])), float(np.sum(spectrum))
    lines = spectrum.size / 1.5  # neighbours under a window share their noise
    # Part of all power that one of so many lines of white noise has at most, but for a small chance.
    if line < min(0.9, 3.0 * min(1.0, math.log(lines / CHANCE) / lines)) * total:
        return None
    index += FIRST
    frequency = _refined(even, values, index / (even[-1] - even[0]))
    amplitude, residual = _half_swing(even, values, frequency, noise_of(values))
    if not amplitude > LEAST:
        return None
    # Of the best fit of a sine in noise: D. C. Rife and R. R. Boorstyn, IEEE Trans. Inf. Theory 20 (1974) 591-598.
    span = float(even[-1] - even[0])
    noise = noise_about([residual], 0).at(2.0 * math.pi * frequency * span / even.size)
    error = WIDER * noise / math.sqrt(even.size)
    return Hum(amplitude, frequency, math.sqrt(2.0) * error, math.sqrt(6.0) * error / (math.pi * amplitude * span))


def _refined(time: FloatArray, values: FloatArray, frequency: float) -> float:
    """Return the frequency of the best fitting sine near a spectral line."""
    width = 1.0 / (time[-1] - time[0])
    for _ in range(5):
        trial = frequency + width * np.linspace(-1.0, 1.0, 21)
        frequency = float(trial[np.argmax([_power(time, values, f) for f in trial])])
        width *= 0.1
    return frequency


def _power(time: FloatArray, values: FloatArray, frequency: float) -> float:
    phase = 2.0 * math.pi * frequency * (time - time[0])
    return float((values @ np.cos(phase)) ** 2 + (values @ np.sin(phase)) ** 2)


def _half_swing(time: FloatArray, values: FloatArray, frequency: float, noise: float) -> tuple[float, FloatArray]:
    """Return half of the peak-to-peak value of the mean period, and the residual.

    Harmonics below the noise are excluded.
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

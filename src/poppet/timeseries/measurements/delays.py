"""Detection of delays in recordings: inputs recorded late, and slow temperature sensors."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from poppet.core.codes import Note
from poppet.laws.physics.gas import AIR_ISENTROPIC_EXPONENT
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements.measurement import Channel, InputChannel, noise_of

_WINDOW = 50  # steps of a compared change: long compared with noise, short compared with heating of the wall
_MAX_SAMPLES = 2000  # limit of compared samples; longer recordings are averaged to show delays of seconds
_MAX_DELAY = 40  # largest tested delay in both directions [steps]
_MIN_DELAY = 5  # smaller delays cannot be distinguished from heat transfer [steps]
_MAX_RATIO = 0.95  # cost ratio with and without delay above which there is no evidence
_ROUNDS = 10
_TINY = 1e-300  # avoids a division by zero
_CERTAIN = 5.0  # standard deviations
_SLIGHT = 0.01  # pressure change below which a pressure is constant, relative to its range

_CHANGE = 0.15  # relative change of the pressure in the window
_RESPONSE = 0.6  # limit of the response, relative to that of the gas
_MIN_RESPONSE = 3.0  # [K]


def late_input(item: InputChannel, channels: Sequence[Channel]) -> list[Note]:
    r"""Return a note if a recorded mass flow is late or early compared with recorded pressures.

    The list is empty if no delay is found. The check fits the changes of a pressure p by the mass flow q for a series
    of delays d. The constants a, b, c and e are fitted for each delay.

    .. math:: \Delta p \approx a\, \Delta m + b\, \Delta\!\int m\,dt + c\, \Delta\!\int p\,dt + e, \qquad
        m(t) = \int q(t + d)\,dt

    Notes
    -----
    The robust fit of changes over 50 samples reduces the weight of jumps with other causes. The integrals of m and p
    describe the heat flow to the wall as far as it is linear. The remaining heat flow looks like a delay of up to
    0.4 s in simulated tanks of 7.5 litres. The function reports delays of 5 to 39 samples. Recordings of more than
    2000 samples are averaged first.
    """
    pressures = []
    for channel in channels:
        if channel.unit == "Pa" and channel.time.size > 3 * _WINDOW:
            count = -(-channel.time.size // _MAX_SAMPLES)
            length = channel.time.size // count * count
            time, values = (row[:length].reshape(-1, count).mean(axis=1) for row in (channel.time, channel.values))
            pressures.append(replace(channel, time=time, values=values))
    if item.unit != "kg/s" or not pressures or not np.ptp(item.values):
        return []
    item = replace(item, time=item.time - (item.delay or 0.0))

    def explained_fraction(candidate: Channel) -> float:
        """Return the fraction of the pressure changes that the flow explains at its best delay.

        `candidate` is the channel of the pressure.
        """
        change, _, misfits = _fit_for_delays(item, candidate, stride=5)
        return 1.0 - float(np.min(misfits)) / max(float(np.mean(np.abs(change - np.median(change)))), _TINY)

    channel = max(pressures, key=explained_fraction)
    _, delays, misfits = _fit_for_delays(item, channel)
    k = int(np.argmin(misfits))
    delay, ratio = float(delays[k]), float(misfits[k] / max(misfits[_MAX_DELAY], _TINY))
    # The smallest residual at the end of the tested range is not a minimum.
    if abs(k - _MAX_DELAY) < _MIN_DELAY or ratio > _MAX_RATIO or k in (0, delays.size - 1):
        return []
    facts = {
        "shift": abs(delay), "stated": item.delay or None, "channel": channel.address, "gain": 1.0 - ratio,
        "silent_until": None, "moved": None, "is_fixed": item.delay is not None,
    }  # fmt: skip
    # A pressure change before the flow meter shows a flow.
    flowing = np.flatnonzero(np.abs(item.values) > 0.05 * float(np.max(np.abs(item.values))))
    begin = float(item.time[flowing[0]])
    earlier = channel.values[channel.time < begin]
    if earlier.size >= 2 * _WINDOW:
        rise = abs(float(np.mean(earlier[-5:])) - float(np.mean(earlier[:_WINDOW])))
        noise = noise_of(channel.values, channel.time)
        if rise > max(_CERTAIN * noise, _SLIGHT * float(np.ptp(channel.values))):
            facts |= {"silent_until": begin, "moved": rise}
    return [Note("suspicion.recorded_late" if delay > 0.0 else "suspicion.recorded_early", item.address, **facts)]


def _fit_for_delays(item: InputChannel, channel: Channel, stride: int = 1) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Return the residuals of fits of the pressure changes by the flow, for a series of delays.

    `item` is the flow and `channel` the pressure. The delays are multiples of `stride` samples. The result contains the
    pressure changes, the delays [s], and the mean residual of the robust fit for each delay.
    """
    step = float(np.median(np.diff(channel.time)))
    times, span = channel.time[:-_WINDOW], _WINDOW * step
    change = _changes(channel.time, channel.values, times, span)
    of_pressure = _changes(channel.time, _integral(channel.time, channel.values), times, span)
    flown = _integral(item.time, item.values)
    rows = (flown, _integral(item.time, flown))
    delays = np.array([step * k for k in range(-_MAX_DELAY, _MAX_DELAY + 1, stride)])
    misfits = []
    for delay in delays:
        of_flow = (_changes(item.time, row, times + delay, span) for row in rows)
        misfits.append(_misfit(np.stack([np.ones(times.size), *of_flow, of_pressure], axis=1), change))
    return change, delays, np.array(misfits)


def _misfit(columns: FloatArray, target: FloatArray) -> float:
    # Scaled, because the columns differ by orders of magnitude.
    columns = columns / np.maximum(np.max(np.abs(columns), axis=0), _TINY)
    weight = np.ones(target.size)
    for _ in range(_ROUNDS):
        root = np.sqrt(weight)
        fit = np.linalg.lstsq(columns * root[:, None], target * root, rcond=None)[0]
        residual = np.abs(target - columns @ fit)
        # Huber's weights: 1.345 standard deviations keep 95 % of the efficiency of least squares.
        limit = 1.345 * 1.4826 * max(float(np.median(residual)), _TINY)
        weight = limit / np.maximum(residual, limit)
    return float(np.mean(residual))


def _integral(time: FloatArray, values: FloatArray) -> FloatArray:
    areas = 0.5 * (values[1:] + values[:-1]) * np.diff(time)
    return np.concatenate([[0.0], np.cumsum(areas)])


def _changes(time: FloatArray, values: FloatArray, times: FloatArray, span: float) -> FloatArray:
    return np.asarray(np.interp(times + span, time, values) - np.interp(times, time, values))


def slow_sensor(channel: Channel, channels: Sequence[Channel]) -> list[Note]:
    r"""Return a note if a temperature sensor reacts more slowly than the gas, or an empty list.

    `channel` is the temperature. During the fastest change of the pressure of the same gas node in `channels`, the gas
    is assumed to be adiabatic:

    .. math:: \Delta T = \frac{\kappa - 1}{\kappa}\, T\, \Delta \ln p

    Notes
    -----
    The equation is the adiabatic law with kappa = 1.4 (air). It is valid for a discharge, and for the start of a charge
    with gas of the same temperature. A high heat flow to the wall also reduces the temperature change, so the note is
    only a suspicion.
    """
    owner = channel.address.rpartition(".")[0]
    pressure = next((c for c in channels if c.address == f"{owner}.pressure" and c.unit == "Pa"), None)
    if channel.unit != "K" or channel.lag != 0.0 or pressure is None or np.min(pressure.values) <= 0.0:
        return []
    is_common = (channel.time >= pressure.time[0]) & (channel.time <= pressure.time[-1])
    time, temperature = channel.time[is_common], channel.values[is_common]
    if time.size < 3:
        return []
    level = np.interp(time, pressure.time, np.log(pressure.values))
    noise = noise_of(pressure.values, pressure.time) / float(np.min(pressure.values))
    # The shortest window in which the level changes enough.
    change_of_level = max(_CHANGE, 8.0 * noise)
    shortest: tuple[float, int, int] | None = None
    last = 1
    for first in range(time.size - 1):
        last = max(last, first + 1)
        while last < time.size - 1 and abs(level[last] - level[first]) < change_of_level:
            last += 1  # the end never moves back, which is sufficient for a monotone pressure
        if abs(level[last] - level[first]) >= change_of_level:
            window = (float(time[last] - time[first]), first, last)
            shortest = min(shortest or window, window)
    if shortest is None:
        return []
    _, first, last = shortest
    kappa = AIR_ISENTROPIC_EXPONENT
    expected = (kappa - 1.0) / kappa * float(temperature[first]) * float(level[last] - level[first])
    change = float(temperature[last] - temperature[first])
    scatter = noise_of(temperature, time) if time.size > 4 * _WINDOW else 0.0
    if abs(expected) < max(_MIN_RESPONSE, _CERTAIN * scatter) or change / expected > _RESPONSE:
        return []
    facts = {"moved": change, "start": float(time[first]), "stop": float(time[last]), "expected": expected}
    return [Note("suspicion.slow_sensor", channel.address, **facts)]

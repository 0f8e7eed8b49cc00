"""Records that come late: inputs behind the pressure they make, thermometers behind the gas."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from poppet.core.codes import Note
from poppet.laws.physics.gas import AIR_ISENTROPIC_EXPONENT
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements.measurement import Channel, InputChannel
from poppet.timeseries.measurements.noise import noise_of

_WINDOW = 50  # steps over which changes are compared: long against the noise, short against the wall's warming
_MOST = 2000  # samples compared; of more, means are taken, so that seconds are seen in a fast recording
_FARTHEST = 40  # steps: the largest delay looked for, on either side
_LEAST = 5  # steps: a smaller one may as well be heat
_BETTER = 0.95  # of the misfit without delay: less is no evidence
_ROUNDS = 10
_TINY = 1e-300  # keeps a division by nothing finite
_CERTAIN = 5.0  # standard deviations
_SLIGHT = 0.01  # of the range: a pressure that moves by less has not moved

_CHANGE = 0.15  # of the pressure, relative
_RESPONSE = 0.6  # of what the gas itself does at once
_LEAST_RESPONSE = 3.0  # K


def late_input(item: InputChannel, channels: Sequence[Channel]) -> list[Note]:
    r"""A mass flow whose record is late against the pressure that it raises.

    .. math:: \Delta p \approx a\, \Delta m + b\, \Delta\!\int m\,dt + c\, \Delta\!\int p\,dt + e, \qquad
        m(t) = \int q(t + d)\,dt

    Notes
    -----
    The changes are those over 50 samples, fitted robustly, so that a jump that has another cause counts little. The
    integrals of m and p are the heat that the wall takes, as far as it is linear: what is left of it passes for a
    delay of up to 0.4 s in simulated tanks of 7.5 litres. Delays of 5 to 39 samples are told, in recordings of more
    than 2000 samples after means over several.
    """
    pressures = [_thinned(channel) for channel in channels if channel.unit == "Pa" and channel.time.size > 3 * _WINDOW]
    if item.unit != "kg/s" or not pressures or not np.ptp(item.values):
        return []
    item = replace(item, time=item.time - (item.delay or 0.0))
    channel = max(pressures, key=lambda each: _explained(item, each))
    _, delays, misfits = _misfits(item, channel)
    k = int(np.argmin(misfits))
    delay, ratio = float(delays[k]), float(misfits[k] / max(misfits[_FARTHEST], _TINY))
    # A best one at the end of what was looked at is no minimum.
    if abs(k - _FARTHEST) < _LEAST or ratio > _BETTER or k in (0, delays.size - 1):
        return []
    facts = {
        "shift": abs(delay),
        "stated": item.delay or None,
        "channel": channel.address,
        "gain": 1.0 - ratio,
        **_zero_while_rising(item, channel),
        "is_fixed": item.delay is not None,
    }
    return [Note("suspicion.recorded_late" if delay > 0.0 else "suspicion.recorded_early", item.address, **facts)]


def _thinned(channel: Channel) -> Channel:
    """Means over as many samples as leave a number that is quickly compared."""
    count = -(-channel.time.size // _MOST)
    whole = channel.time.size // count * count
    time, values = (row[:whole].reshape(-1, count).mean(axis=1) for row in (channel.time, channel.values))
    return replace(channel, time=time, values=values)


def _explained(item: InputChannel, channel: Channel) -> float:
    """Share of the pressure's changes that the flow explains, whatever its delay."""
    change, _, misfits = _misfits(item, channel, every=5)
    return 1.0 - float(np.min(misfits)) / max(float(np.mean(np.abs(change - np.median(change)))), _TINY)


def _zero_while_rising(item: InputChannel, channel: Channel) -> dict[str, float | None]:
    """Until when the meter read nothing, and what the pressure had done before, as evidence."""
    flowing = np.flatnonzero(np.abs(item.values) > 0.05 * float(np.max(np.abs(item.values))))
    begin = float(item.time[flowing[0]])
    before = channel.values[channel.time < begin]
    if before.size >= 2 * _WINDOW:
        rise = abs(float(np.mean(before[-5:])) - float(np.mean(before[:_WINDOW])))
        noise = noise_of(channel.values, channel.time)
        if rise > max(_CERTAIN * noise, _SLIGHT * float(np.ptp(channel.values))):
            return {"silent_until": begin, "moved": rise}
    return {"silent_until": None, "moved": None}


def _misfits(item: InputChannel, channel: Channel, every: int = 1) -> tuple[FloatArray, FloatArray, FloatArray]:
    """Changes of the pressure, delays [s], and for each the mean size of what a robust fit of the flow leaves."""
    step = float(np.median(np.diff(channel.time)))
    at, span = channel.time[:-_WINDOW], _WINDOW * step
    change = _changes(channel.time, channel.values, at, span)
    of_pressure = _changes(channel.time, _integral(channel.time, channel.values), at, span)
    flown = _integral(item.time, item.values)
    rows = (flown, _integral(item.time, flown))
    delays = np.array([step * k for k in range(-_FARTHEST, _FARTHEST + 1, every)])
    misfits = []
    for delay in delays:
        of_flow = (_changes(item.time, row, at + delay, span) for row in rows)
        misfits.append(_misfit(np.stack([np.ones(at.size), *of_flow, of_pressure], axis=1), change))
    return change, delays, np.array(misfits)


def _misfit(columns: FloatArray, wanted: FloatArray) -> float:
    # The columns differ by decades, which would cost digits.
    columns = columns / np.maximum(np.max(np.abs(columns), axis=0), _TINY)
    weight = np.ones(wanted.size)
    for _ in range(_ROUNDS):
        root = np.sqrt(weight)
        fit = np.linalg.lstsq(columns * root[:, None], wanted * root, rcond=None)[0]
        left = np.abs(wanted - columns @ fit)
        # Huber's weights: 1.345 standard deviations keep 95 % of the efficiency of least squares.
        limit = 1.345 * 1.4826 * max(float(np.median(left)), _TINY)
        weight = limit / np.maximum(left, limit)
    return float(np.mean(left))


def _integral(time: FloatArray, values: FloatArray) -> FloatArray:
    areas = 0.5 * (values[1:] + values[:-1]) * np.diff(time)
    return np.concatenate([[0.0], np.cumsum(areas)])


def _changes(time: FloatArray, values: FloatArray, at: FloatArray, span: float) -> FloatArray:
    return np.asarray(np.interp(at + span, time, values) - np.interp(at, time, values))


def slow_sensor(channel: Channel, channels: Sequence[Channel]) -> list[Note]:
    r"""A thermometer that does not show what the gas must do when its pressure changes fast.

    .. math:: \Delta T = \frac{\kappa - 1}{\kappa}\, T\, \Delta \ln p

    Notes
    -----
    The law holds for discharge, and for the first moments of a charge with gas of the same temperature; air,
    kappa = 1.4. A wall that takes much heat looks the same: it is a suspicion.
    """
    owner = channel.address.rpartition(".")[0]
    pressure = next((each for each in channels if each.address == f"{owner}.pressure" and each.unit == "Pa"), None)
    if channel.unit != "K" or channel.lag != 0.0 or pressure is None or np.min(pressure.values) <= 0.0:
        return []
    inside = (channel.time >= pressure.time[0]) & (channel.time <= pressure.time[-1])
    time, shown = channel.time[inside], channel.values[inside]
    if time.size < 3:
        return []
    level = np.interp(time, pressure.time, np.log(pressure.values))
    noise = noise_of(pressure.values, pressure.time) / float(np.min(pressure.values))
    window = _fastest(time, level, max(_CHANGE, 8.0 * noise))
    if window is None:
        return []
    first, last = window
    kappa = AIR_ISENTROPIC_EXPONENT
    expected = (kappa - 1.0) / kappa * float(shown[first]) * float(level[last] - level[first])
    moved = float(shown[last] - shown[first])
    scatter = noise_of(shown, time) if time.size > 4 * _WINDOW else 0.0
    if abs(expected) < max(_LEAST_RESPONSE, _CERTAIN * scatter) or moved / expected > _RESPONSE:
        return []
    facts = {"moved": moved, "start": float(time[first]), "stop": float(time[last]), "expected": expected}
    return [Note("suspicion.slow_sensor", channel.address, **facts)]


def _fastest(time: FloatArray, level: FloatArray, change: float) -> tuple[int, int] | None:
    """Ends of the shortest stretch over which a level changes by so much."""
    best: tuple[float, int, int] | None = None
    last = 1
    for first in range(time.size - 1):
        last = max(last, first + 1)
        while last < time.size - 1 and abs(level[last] - level[first]) < change:
            last += 1  # never back, which is enough where a pressure falls or rises throughout
        if abs(level[last] - level[first]) >= change:
            found = (float(time[last] - time[first]), first, last)
            best = min(best or found, found)
    return best and best[1:]

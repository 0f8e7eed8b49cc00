"""Series of a recording on their way to and from a model: lag of a sensor, late and held inputs, first values."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from poppet.timeseries.checks import FloatArray as Array
from poppet.timeseries.signals import SampledSignal, Steps

PER_START = 75
"""Samples of a recording for each one that its first value is taken from."""


def lagged(time: Array, values: Array, lag: float) -> Array:
    r"""Response of a first-order sensor to series, (..., n_times), that are straight between their samples.

    .. math:: \tau \dot y + y = u, \quad y(0) = u(0)

    Examples
    --------
    >>> ramp = np.linspace(0.0, 10.0, 101)
    >>> bool(abs(lagged(ramp, ramp, 0.5)[-1] - 9.5) < 1e-8)
    True
    """
    if lag <= 0.0:
        return values
    steps = np.diff(time)
    decay = np.exp(-steps / lag)
    slope = np.diff(values) / steps
    # Exact for straight pieces: the sensor trails a ramp by slope * lag.
    push = slope * steps - slope * lag * (1.0 - decay)
    term = np.concatenate([values[..., :1], values[..., :-1] * (1.0 - decay) + push], axis=-1)
    return recursion(np.append(0.0, decay), term)


def recursion(factor: Array, term: Array) -> Array:
    """Series y[k] = factor[k] y[k-1] + term[k] from y = 0, for each row of `term`.

    Examples
    --------
    >>> recursion(np.array([0.0, 0.5, 0.5]), np.array([1.0, 1.0, 1.0])).tolist()
    [1.0, 1.5, 1.75]
    """
    from scipy.linalg.lapack import dtbtrs

    # Two diagonals of ones and of factors; each column of the right-hand side is a series.
    band = np.array([np.ones(factor.size), np.append(-factor[1:], 0.0)])
    found, _ = dtbtrs(band, term.reshape(-1, factor.size).T, uplo="L", diag="U")
    return np.asarray(found.T).reshape(term.shape)


def shifted(time: Array, values: Array, late: float, *, hold: bool = False) -> tuple[Array, Array]:
    """A record that is late by some time, put right: its values happened that much earlier."""
    moved = time - late
    first = float(np.interp(0.0, moved, values))
    if hold:
        first = float(values[max(int(np.searchsorted(moved, 0.0, side="right")) - 1, 0)])
    inside = moved > 0.0
    return np.concatenate([[0.0], moved[inside]]), np.concatenate([[first], values[inside]])


def driving_signals(
    measurement: Any, delays: Mapping[str, float], lags: Mapping[str, float] | None = None
) -> dict[str, Any]:
    """Recorded inputs as signals, put right for the lateness and the lag of their instruments."""
    signals: dict[str, Any] = {}
    lags = lags or {}
    for item in measurement.inputs:
        values = item.values
        lag = lags.get(item.address, item.lag or 0.0)
        if lag:  # the law of the sensor turned round: u = y + lag dy/dt
            values = values + lag * np.gradient(values, item.time)
        time, values = shifted(item.time, values, delays.get(item.address, item.delay or 0.0), hold=item.hold)
        if item.hold:
            changed = np.diff(values, prepend=np.nan) != 0.0
            signals[item.address] = Steps(time[changed], values[changed])
        else:
            signals[item.address] = SampledSignal(time, values, f"{measurement.name}.{item.address}")
    return signals


def first_value(channel: Any) -> float:
    """A channel at its first sample: of many samples, what a line through the first few says, for the noise."""
    from poppet.timeseries.measurements import noise_of

    n = channel.values.size // PER_START
    if n < 3:
        return float(channel.values[0])
    time, values = channel.time[:n], channel.values[:n]
    line = np.polynomial.Polynomial.fit(time, values, 1)
    misfit = float(np.sqrt(np.mean((line(time) - values) ** 2)))
    is_straight = misfit <= 2.0 * max(noise_of(channel.values, channel.time), channel.quantum)
    return float(line(0.0)) if is_straight else float(channel.values[0])

"""Processing of recorded and modelled series: sensor lags, delays, inputs and first values."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from poppet.timeseries.checks import FloatArray as Array
from poppet.timeseries.signals import SampledSignal, Steps

PER_START = 75
"""Ratio of all samples to the samples from which the first value is estimated."""


def apply_lag(time: Array, values: Array, lag: float) -> Array:
    r"""Return series as a sensor with a first-order lag would record them.

    The series are piecewise linear, (..., n_times). In the formula, u is the series, y the reading, and tau the time
    constant `lag`.


    .. math:: \tau \dot y + y = u, \quad y(0) = u(0)

    Examples
    --------
    >>> ramp = np.linspace(0.0, 10.0, 101)
    >>> bool(abs(apply_lag(ramp, ramp, 0.5)[-1] - 9.5) < 1e-8)
    True
    """
    if lag <= 0.0:
        return values
    steps = np.diff(time)
    decay = np.exp(-steps / lag)
    slope = np.diff(values) / steps
    # Exact for linear segments: the error of the sensor on a ramp is slope * lag.
    push = slope * steps - slope * lag * (1.0 - decay)
    term = np.concatenate([values[..., :1], values[..., :-1] * (1.0 - decay) + push], axis=-1)
    return recursion(np.append(0.0, decay), term)


def recursion(factor: Array, term: Array) -> Array:
    """Return the solution of a linear recursion for each row of `term`.

    The recursion is y[k] = factor[k] y[k-1] + term[k]. Each solution starts from y = 0.

    Examples
    --------
    >>> recursion(np.array([0.0, 0.5, 0.5]), np.array([1.0, 1.0, 1.0])).tolist()
    [1.0, 1.5, 1.75]
    """
    from scipy.linalg.lapack import dtbtrs

    # Two diagonals of ones and of factors; each column of the right-hand side is a series.
    band = np.array([np.ones(factor.size), np.append(-factor[1:], 0.0)])
    series, _ = dtbtrs(band, term.reshape(-1, factor.size).T, uplo="L", diag="U")
    return np.asarray(series.T).reshape(term.shape)


def shift_series(time: Array, values: Array, delay: float, *, hold: bool = False) -> tuple[Array, Array]:
    """Return times and values of a series that is shifted to earlier times by `delay`, and starts at time 0.

    The value at time 0 is interpolated linearly. If the keyword `hold` is True, it is the last value before time 0.
    """
    shifted_time = time - delay
    first = float(np.interp(0.0, shifted_time, values))
    if hold:
        first = float(values[max(int(np.searchsorted(shifted_time, 0.0, side="right")) - 1, 0)])
    is_positive = shifted_time > 0.0
    return np.concatenate([[0.0], shifted_time[is_positive]]), np.concatenate([[first], values[is_positive]])


def driving_signals(
    measurement: Any, delays: Mapping[str, float], lags: Mapping[str, float] | None = None
) -> dict[str, Any]:
    """Return the recorded inputs, corrected for delays and sensor lags, as signals that drive the model."""
    signals: dict[str, Any] = {}
    lags = lags or {}
    for item in measurement.inputs:
        values = item.values
        lag = lags.get(item.address, item.lag or 0.0)
        if lag:  # inverse of the sensor model: u = y + lag dy/dt
            values = values + lag * np.gradient(values, item.time)
        time, values = shift_series(item.time, values, delays.get(item.address, item.delay or 0.0), hold=item.hold)
        if item.hold:
            changed = np.diff(values, prepend=np.nan) != 0.0
            signals[item.address] = Steps(time[changed], values[changed])
        else:
            signals[item.address] = SampledSignal(time, values, f"{measurement.name}.{item.address}")
    return signals


def first_value(channel: Any) -> float:
    """Return the value of a channel at the start of the recording.

    If there are many samples, a straight line is fitted to the first few. If they agree with the line within the noise,
    the result is the value of this line at time 0. Otherwise it is the first sample.
    """
    from poppet.timeseries.measurements import noise_of

    n = channel.values.size // PER_START
    if n < 3:
        return float(channel.values[0])
    time, values = channel.time[:n], channel.values[:n]
    line = np.polynomial.Polynomial.fit(time, values, 1)
    misfit = float(np.sqrt(np.mean((line(time) - values) ** 2)))
    is_straight = misfit <= 2.0 * max(noise_of(channel.values, channel.time), channel.quantum)
    return float(line(0.0)) if is_straight else float(channel.values[0])

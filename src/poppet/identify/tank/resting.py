"""Test for a rest of the tank pressure before the valve opens."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np

from poppet.timeseries.checks import FloatArray

Basis = Callable[[FloatArray, float], tuple[FloatArray, FloatArray]]
"""Two functions of time for a trial value."""
WINDOW = 0.25
"""Fraction of the total change that limits the window of the test."""
LEAST_WINDOW = 10
"""Least number of samples in the window."""
SAMPLES = 300
"""Largest number of samples in the window; more are thinned out."""
TIMES = 60
"""Number of trial values of the rest and of the lag."""
EVIDENCE, AGAINST_LAG = 25.0, 10.0
"""Least decrease of chi-square by a rest, compared with none, and with a first-order lag of the sensor."""
NEAR, LEAST_NEAR = 3.0, 30
"""Window of the final estimate, as a multiple of the first one, and its least number of samples."""
LEAST_REST = 0.01
"""Shortest rest that is reported, as a fraction of the window; it changes C by less than that."""


def rest_before_opening(time: FloatArray, values: FloatArray, noise: float) -> float:
    """Return how long the pressure is constant before it begins to change [s].

    The result is 0 if a constant start is not evident. `time` starts at 0, and `noise` is the standard deviation of the
    samples. Two models of the samples are compared: a constant start that is followed by a polynomial of degree 2, and
    a sensor lag, which also starts with a zero slope. The constant start must fit better.
    """
    begin = float(np.median(values[: min(3, 1 + time.size // 50)]))
    change = np.abs(values - begin)
    end = int(np.argmax(change >= WINDOW * np.max(change))) + 1
    if end < LEAST_WINDOW:
        return 0.0
    samples = slice(0, end, 1 + end // SAMPLES)
    t, y = time[samples] / time[end - 1], values[samples] / noise
    trials = np.linspace(0.0, 0.9, TIMES)[1:]
    least = _chi_square(t, t**2, y)
    by_rest = _best_trial(t, y, trials, _times_after_rest)
    if least - by_rest[0] < EVIDENCE:
        return 0.0
    step = trials[1] - trials[0]
    by_rest = _best_trial(t, y, np.linspace(max(by_rest[1] - step, 0.0), by_rest[1] + step, TIMES), _times_after_rest)
    by_lag = _best_trial(t, y, np.geomspace(0.003, 1.0, TIMES), _lagged_times)
    rest, is_resting = by_rest[1], by_lag[0] - by_rest[0] > AGAINST_LAG
    if not is_resting or rest < LEAST_REST or np.sum(t < rest) < 3:
        return 0.0
    # Close to the end of the rest, the polynomial is more accurate.
    is_near = t <= NEAR * rest
    if np.sum(is_near) > LEAST_NEAR:
        trials = np.linspace(0.8 * rest, 1.2 * rest, TIMES)
        rest = _best_trial(t[is_near], y[is_near], trials, _times_after_rest)[1]
    return float(rest * time[end - 1])


def rest_of_few_samples(time: FloatArray, values: FloatArray) -> float:
    """Return how long the pressure is constant at first, if few samples show its change [s].

    `rest_before_opening` needs ten samples of the first quarter of the change. With fewer, the first interval decides:
    a tank empties or fills fastest at the start. The result is 0 if its change is at least half the largest one.
    `time` starts at 0.
    """
    change = np.abs(values - values[0])
    end = int(np.argmax(change >= WINDOW * np.max(change))) + 1
    if end >= LEAST_WINDOW:
        return 0.0
    steps = np.abs(np.diff(values[: end + 1]))
    steepest = int(np.argmax(steps))
    return float(time[steepest]) if steps[0] < 0.5 * steps[steepest] else 0.0


def _times_after_rest(t: FloatArray, rest: float) -> tuple[FloatArray, FloatArray]:
    """Return the time since the end of a constant start, and its square, (n,) each.

    Both are 0 during the constant start. `t` contains the times, and `rest` is the duration of the constant start.
    """
    after = np.maximum(t - rest, 0.0)
    return after, after**2


def _lagged_times(t: FloatArray, lag: float) -> tuple[FloatArray, FloatArray]:
    """Return the responses of a first-order lag to the time and to its square, (n,) each.

    `t` contains the times, and `lag` is the time constant.
    """
    settled = lag * (1.0 - np.exp(-t / lag))
    return t - settled, t**2 - 2.0 * lag * (t - settled)


def _best_trial(t: FloatArray, y: FloatArray, trials: FloatArray, basis: Basis) -> tuple[float, float]:
    """Return the least chi-square of several trial values, and the trial value to which it belongs.

    `basis` is a function that returns two functions of time for a trial value. They are fitted to the samples `y` at
    the times `t`.
    """
    return min((_chi_square(*basis(t, trial), y), trial) for trial in trials.tolist())


def _chi_square(first: FloatArray, second: FloatArray, y: FloatArray) -> float:
    """Return the sum of squares that remains after a linear fit to `y`.

    The fit uses a constant and the functions `first` and `second`, which are given as values.
    """
    columns = np.linalg.qr(np.column_stack((np.ones_like(y), first, second)))[0]
    left = y - columns @ (columns.T @ y)
    return float(left @ left)

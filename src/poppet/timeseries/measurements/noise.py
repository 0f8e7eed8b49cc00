"""How finely and how quietly a channel was recorded."""

from __future__ import annotations

import math

import numpy as np

from poppet.timeseries.checks import FloatArray

_LEAST_LEVELS = 4  # different values from which a step can be told
_REPEATED = 0.9  # of the samples may differ: an even ramp has even steps, too, but no value twice
_ROUNDS = 6
_WITHIN = 3.0  # standard deviations that are noise; what goes beyond is a jump of the signal
# Of a normal distribution cut at three standard deviations, the one that remains is 0.9866 of the whole.
_CUT = math.sqrt(
    1.0 - 2.0 * _WITHIN * math.exp(-0.5 * _WITHIN**2) / math.sqrt(2.0 * math.pi) / math.erf(_WITHIN / 2**0.5)
)


def quantum_of(values: FloatArray) -> float:
    """The step in which values were recorded.

    Examples
    --------
    >>> round(quantum_of(np.array([0.1, 0.3, 0.4, 0.4, 0.7, 0.6])), 9)
    0.1
    >>> quantum_of(np.sin(np.arange(50.0)))
    0.0
    """
    levels = np.unique(values)
    if levels.size < _LEAST_LEVELS or levels.size > _REPEATED * values.size:
        return 0.0
    steps = np.diff(levels)
    steps = steps[steps > 1e-9 * float(np.max(np.abs(levels)))]  # smaller ones are the rounding of a conversion
    if steps.size < _LEAST_LEVELS - 1:
        return 0.0
    step = float(np.min(steps))
    counts = np.rint(steps / step)
    if np.mean(np.abs(steps / step - counts) < 0.05) < 0.95:
        return 0.0
    return float(np.sum(steps) / np.sum(counts))


def noise_of(values: FloatArray, time: FloatArray | None = None) -> float:
    r"""The standard deviation of the noise of a channel, from the scatter about its neighbours.

    .. math:: e_k = x_k - \frac{x_{k-1} + x_{k+1}}{2}, \qquad
        \sigma^2 = \tfrac{2}{3}\,\overline{e_k^2}

    Notes
    -----
    Jumps are left out as far as they are rare. Noise that a filter has smoothed is underestimated, and a signal
    that bends between three samples counts as noise.

    Examples
    --------
    >>> x = 5.0 * np.arange(2000.0) + np.random.default_rng(1).normal(0.0, 0.3, 2000)
    >>> abs(noise_of(x) - 0.3) < 0.02
    True
    """
    floor = quantum_of(values) / math.sqrt(12.0)
    if values.size < 3:
        return floor
    base = np.arange(values.size, dtype=float) if time is None else time
    # Weights of a straight line through the neighbours, wherever the sample stands between them.
    before = (base[2:] - base[1:-1]) / (base[2:] - base[:-2])
    scatter = values[1:-1] - before * values[:-2] - (1.0 - before) * values[2:]
    scatter = np.abs(scatter) / np.sqrt(1.0 + before**2 + (1.0 - before) ** 2)
    # The median to begin with, since jumps do not move it; for normal noise, sigma is 1.4826 of it.
    sigma = max(1.4826 * float(np.median(scatter)), floor)
    for _ in range(_ROUNDS):
        kept = scatter[scatter <= _WITHIN * sigma]
        if not kept.size:
            break
        sigma = max(float(np.sqrt(np.mean(kept**2))) / _CUT, floor)
    return sigma

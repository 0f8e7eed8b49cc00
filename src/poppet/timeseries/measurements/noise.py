"""Resolution and noise of a measured channel."""

from __future__ import annotations

import math

import numpy as np

from poppet.timeseries.checks import FloatArray

_MIN_LEVELS = 4  # distinct values needed to find a resolution
_MAX_DISTINCT = 0.9  # limit of distinct values, relative to the samples: a ramp has equal steps but no repeated value
_ROUNDS = 6
_WITHIN = 3.0  # limit of noise in standard deviations; larger deviations are jumps of the signal
# A normal distribution truncated at three standard deviations has 0.9866 times the standard deviation.
_CUT = math.sqrt(
    1.0 - 2.0 * _WITHIN * math.exp(-0.5 * _WITHIN**2) / math.sqrt(2.0 * math.pi) / math.erf(_WITHIN / 2**0.5)
)


def quantum_of(values: FloatArray) -> float:
    """Return the resolution of the values, 0 if there is no common step.

    Examples
    --------
    >>> round(quantum_of(np.array([0.1, 0.3, 0.4, 0.4, 0.7, 0.6])), 9)
    0.1
    >>> quantum_of(np.sin(np.arange(50.0)))
    0.0
    """
    levels = np.unique(values)
    if levels.size < _MIN_LEVELS or levels.size > _MAX_DISTINCT * values.size:
        return 0.0
    steps = np.diff(levels)
    steps = steps[steps > 1e-9 * float(np.max(np.abs(levels)))]  # smaller steps are rounding errors of a conversion
    if steps.size < _MIN_LEVELS - 1:
        return 0.0
    step = float(np.min(steps))
    counts = np.rint(steps / step)
    if np.mean(np.abs(steps / step - counts) < 0.05) < 0.95:
        return 0.0
    return float(np.sum(steps) / np.sum(counts))


def noise_of(values: FloatArray, time: FloatArray | None = None) -> float:
    r"""Return the standard deviation of the noise, from deviations between neighbouring samples.

    .. math:: e_k = x_k - \frac{x_{k-1} + x_{k+1}}{2}, \qquad
        \sigma^2 = \tfrac{2}{3}\,\overline{e_k^2}

    Notes
    -----
    Rare jumps are excluded. Filtered noise is underestimated, and curvature within three samples counts as noise.

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
    # Weights of linear interpolation between the neighbours.
    weight = (base[2:] - base[1:-1]) / (base[2:] - base[:-2])
    scatter = values[1:-1] - weight * values[:-2] - (1.0 - weight) * values[2:]
    scatter = np.abs(scatter) / np.sqrt(1.0 + weight**2 + (1.0 - weight) ** 2)
    # Start with the median, which is robust to jumps; for normal noise, sigma is 1.4826 times the median.
    sigma = max(1.4826 * float(np.median(scatter)), floor)
    for _ in range(_ROUNDS):
        inliers = scatter[scatter <= _WITHIN * sigma]
        if not inliers.size:
            break
        sigma = max(float(np.sqrt(np.mean(inliers**2))) / _CUT, floor)
    return sigma

"""Effect of the resolution of a sensor on slow signals."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from poppet.timeseries.checks import FloatArray as Array

HARMONICS = 24
"""Number of harmonics of the staircase; the omitted ones have 2 % of its variance."""
QUIET = 1e-3
"""Relative amplitude below which noise suppresses a harmonic."""


class Staircase(NamedTuple):
    r"""Part of the rounding error that noise does not average out.

    .. math:: e(x) = \sum_h a_h \sin\Big(\frac{2 \pi h x}{q} + \varphi_h\Big), \qquad
        a_h = \frac{q}{\pi h} \exp\Big(-\frac{2 \pi^2 h^2 \sigma^2}{q^2}\Big)

    The product of `waves`, (2 n_harmonics, n), and a series of weights gives terms; the sum of their squares is the
    variance of the weighted sum of e. `square` is the variance of e. Without noise and drift it is q^2/12, and the
    error is equal in all samples.

    References
    ----------
    JCGM 100:2008 (GUM), F.2.2.1; Widrow & Kollar 2008, Quantization Noise, chapter 4 (sigma of the dither).
    """

    waves: Array
    square: float

    def excess(self, weights: Array) -> float:
        """Return the variance of a weighted sum minus that of independent errors of equal size."""
        return float(np.sum((self.waves @ weights) ** 2)) - self.square * float(weights @ weights)


def staircase(values: Array, quantum: float, noise: float) -> Staircase | None:
    """Return the effect of rounding to steps of `quantum`; None if noise hides the steps."""
    order = np.arange(1, HARMONICS + 1)
    smooth = np.exp(-2.0 * (np.pi * order * noise / quantum) ** 2)
    order, smooth = order[smooth > QUIET], smooth[smooth > QUIET]
    if not order.size:
        return None
    phase = 2.0 * np.pi / quantum * order[:, None] * values
    size = (quantum / np.pi * smooth / order / np.sqrt(2.0))[:, None]
    return Staircase(np.vstack([size * np.cos(phase), size * np.sin(phase)]), float(np.sum(size**2)))

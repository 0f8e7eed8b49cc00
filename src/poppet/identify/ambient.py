"""Uncertainty of an unstated ambient temperature."""

from __future__ import annotations

import math
from dataclasses import replace

from poppet.identify.result import CONFIDENCE, Estimate

SPREAD = 3.0
"""One sigma of the temperature of a room about the usual one [K]."""


def widened(estimate: Estimate, share: float) -> Estimate:
    """Return an estimate with a further relative standard uncertainty."""
    from scipy.special import ndtri

    value, error = estimate.value, share * abs(estimate.value)
    half = float(ndtri(0.5 + 0.5 * CONFIDENCE)) * error
    return replace(
        estimate,
        standard_error=math.hypot(estimate.standard_error, error),
        low=max(0.0, value - math.hypot(value - estimate.low, half)),
        high=value + math.hypot(estimate.high - value, half),
    )

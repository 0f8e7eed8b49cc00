"""Detection of samples that a sensor or its converter has clipped, with and without noise."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from poppet.bench.iso10094.scale import FloatArray, Mask
from poppet.timeseries.measurements.noise import noise_of, quantum_of
from poppet.timeseries.measurements.verdicts import cuts_a_peak, stays_in_noise

SHORTEST = 5
"""Smallest number of equal samples at an extreme value."""
STEEP, SLOWER = 4.0, 0.3
"""Change per sample before clipping, in resolution steps, and its smallest ratio to the change before; a settling
series slows down."""
BELOW, BEYOND = 0.3, 1.0
"""Deviation from the setpoint at which an outlet cannot stop suddenly, and further change of the setpoint [% FS]."""
RETURNED = 0.003
"""Excursion of the outlet while its driver seems constant, relative to the range of the outlet."""
LOADED = 0.02
"""Change of the flow while the outlet is constant, relative to the range of the flow."""
CLEAR, RAMP = 6.0, 12.0
"""Smallest change of a ramp, in standard deviations of the noise and in resolution steps."""
FLOOR = 1.0
"""Outlet near its lower limit, where a constant outlet is normal [% FS]."""
MOST_LOOKED_AT = 200
"""Maximum number of samples before a run that are examined."""


def clipped(series: Mapping[str, FloatArray]) -> dict[str, Mask]:
    """Return the clipped samples of each series with any; setpoint and outlet in % FS.

    Examples
    --------
    >>> x = np.concatenate([np.linspace(0.0, 100.0, 500), np.linspace(100.0, 0.0, 500)])
    >>> found = clipped({"setpoint": x, "outlet": np.minimum(x, 75.0)})
    >>> {name: int(mask.sum()) for name, mask in found.items()}
    {'outlet': 250}
    """
    masks: dict[str, Mask] = {}
    for name, values in series.items():
        if not values.size or float(np.ptp(values)) == 0.0:
            continue
        mask = np.zeros(values.size, dtype=bool)
        for level, sign in ((float(np.max(values)), 1.0), (float(np.min(values)), -1.0)):
            if _is_cut(name, series, level, sign):
                mask |= values == level
        if mask.any():
            masks[name] = mask
    return masks


def _is_cut(name: str, series: Mapping[str, FloatArray], level: float, sign: float) -> bool:
    values = series[name]
    runs = _runs(values == level)
    if not runs or (name == "outlet" and sign < 0.0 and level <= FLOOR):
        return False
    # A digital setpoint has no noise to test.
    if name != "setpoint" and stays_in_noise(values, level, quantum_of(values)):
        return True
    if name in ("setpoint", "flow"):
        return any(_goes_on(sign * values, series["outlet"], run) for run in runs)
    return name == "outlet" and any(_is_stuck(series, sign, run) for run in runs)


def _is_stuck(series: Mapping[str, FloatArray], sign: float, run: slice) -> bool:
    """Return True if the outlet is constant although its drivers change."""
    y, x, flow = sign * series["outlet"], sign * series["setpoint"], series.get("flow", np.zeros(0))
    half = slice((run.start + run.stop) // 2, run.stop)
    is_held = _is_ramp(x, run) and float(np.ptp(x[half])) < max(BELOW, CLEAR * noise_of(x))
    is_peak = not is_held and cuts_a_peak(y, (run.start, run.stop), _step(y))
    is_loaded = bool(flow.size) and _is_left(-sign * flow, run, LOADED * float(np.ptp(flow)))
    return is_peak or is_loaded or _is_abrupt(y, x, run) or _is_left(x, run, BEYOND)


def _runs(mask: Mask) -> list[slice]:
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    return [slice(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True) if b - a >= SHORTEST]


def _step(values: FloatArray) -> float:
    return max(quantum_of(values), 1e-6 * float(np.ptp(values)))


def _before(run: slice) -> slice:
    return slice(max(0, run.start - min(run.stop - run.start, MOST_LOOKED_AT)), run.start + 1)


def _is_ramp(x: FloatArray, run: slice) -> bool:
    """Return True if a series approaches a run in steps and not with a jump."""
    approach = x[_before(run)]
    change = approach[-1] - approach[0]
    return bool(change > max(RAMP * _step(x), CLEAR * noise_of(x)) and np.max(np.diff(approach)) < 0.5 * change)


def _is_abrupt(y: FloatArray, x: FloatArray, run: slice) -> bool:
    """Return True if the outlet stops suddenly below its setpoint while the setpoint continues."""
    if run.start < 4 or float(np.max(x[run])) - y[run.start] < BELOW or _is_ramp(x, run):
        return False
    earlier, last = np.diff(y[run.start - 3 : run.start])
    return bool(min(earlier, last) > STEEP * _step(y) and last > SLOWER * earlier)


def _is_left(x: FloatArray, run: slice, threshold: float) -> bool:
    """Return True if the driver of the outlet continues while the outlet is constant."""
    return bool(float(np.max(x[run])) - x[run.start] > max(threshold, CLEAR * noise_of(x)))


def _goes_on(x: FloatArray, outlet: FloatArray, run: slice) -> bool:
    """Return True if the outlet moves away and returns while its driver seems constant after a ramp."""
    if run.start == 0 or not _is_ramp(x, run):
        return False
    width = max(1, (run.stop - run.start) // 20)
    y = np.convolve(outlet[run], np.full(width, 1.0 / width), "valid")
    peak = int(np.argmax(np.abs(y - y[0])))
    rise, fall = abs(y[peak] - y[0]), abs(y[peak] - y[-1])
    noise = CLEAR * noise_of(outlet) / width**0.5
    return bool(min(rise, fall) > max(RETURNED * float(np.ptp(outlet)), noise))

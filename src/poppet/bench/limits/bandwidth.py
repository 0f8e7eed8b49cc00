"""Bandwidth and step response of the nonlinear model, and the component that limits them."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, replace

import numpy as np

from poppet.bench.limits.limits_plan import CONTROLLER, IDEAL, LOAD, PARTS, Changes, LimitsPlan, ideal_part_changes
from poppet.bench.sine_rig import SineRig
from poppet.core.errors import SimulationError

GAIN = 10.0 ** (-3.0 / 20.0)  # gain that defines the bandwidth, -3 dB
LAG = 90.0  # phase lag that defines the bandwidth by phase [deg]
FACTOR = 1.6  # ratio of neighbouring frequencies of the search
REFINED = 2  # steps of the secant method within such a pair
RISEN = 0.9  # fraction of a step that defines the response time
LONGEST = 20.0  # time limit of a step response [s]
ATTEMPTS = 2  # maximum number of runs per sine; limit cycles of the controller may remain in the gains
# The search starts at the guess divided by this factor, because bands can cause a local minimum of the gain.
BELOW = 2.5
WORTH = 1.05  # ratio of bandwidths from which a part counts as limiting


@dataclass
class FrequencyResponse:
    """Frequency response of a circuit at one amplitude.

    Each frequency is simulated when it is first needed.
    """

    rig: SineRig  # nonlinear model in a settled state
    amplitude: float  # amplitude of the setpoint [Pa]
    per_pascal: float  # change of the setpoint per change of the pressure
    found: dict[float, complex] = field(default_factory=dict)  # complex gain, pressure per pressure, by frequency [Hz]
    largest_rest: float = 0.0  # largest relative rms outside the fundamental so far

    def gain(self, frequency: float) -> float:
        """Return the magnitude of the gain at a frequency [Hz].

        The magnitude is the amplitude of the outlet pressure divided by the amplitude of the requested pressure. The
        result is 0 if the simulation fails.
        """
        if frequency not in self.found:
            wave = self.rig.response(self.amplitude * self.per_pascal, frequency, attempts=ATTEMPTS)
            self.found[frequency] = wave.gain * self.per_pascal
            if math.isfinite(wave.rest):
                self.largest_rest = max(self.largest_rest, wave.rest)
        size = abs(self.found[frequency])
        return size if math.isfinite(size) else 0.0

    def lag(self, frequency: float) -> float:
        """Return the phase lag at a frequency [Hz], in the range -90 to 270 [deg]."""
        self.gain(frequency)
        angle = -math.degrees(float(np.angle(self.found[frequency])))
        return angle + 360.0 if angle < -90.0 else angle


def find_crossing(value: Callable[[float], float], limit: float, guess: float, lowest: float, highest: float) -> float:
    """Return the frequency [Hz] at which a falling function first goes below a limit.

    `value` is this function of frequency. The search starts at `guess` and is limited to the range from `lowest` to
    `highest`. The result is 0 if the function is already below the limit at `lowest`, and infinite if it is not below
    the limit at `highest`.
    """
    low = high = min(max(guess, lowest), highest)
    while value(low) < limit:
        if low <= lowest:
            return 0.0
        low, high = max(low / FACTOR, lowest), low
    while low == high or value(high) >= limit:
        if high >= highest and value(high) >= limit:
            return math.inf
        low, high = high, min(high * FACTOR, highest)
    for _ in range(REFINED):
        a, b = value(low), value(high)
        # Limited, because a secant step to an end of the interval gives no new value.
        share = min(max((a - limit) / (a - b), 0.1), 0.9)
        middle = low * (high / low) ** share
        low, high = (middle, high) if value(middle) >= limit else (low, middle)
    a, b = value(low), value(high)
    return float(low * (high / low) ** ((a - limit) / (a - b)))


@dataclass(frozen=True)
class BandwidthPoint:
    """Bandwidths and step times of a valve for one load volume and one amplitude."""

    # Frequencies [Hz] are 0 below the range and infinite above it.
    gain_frequency: float  # gain reduced by 3 dB
    phase_frequency: float  # phase lag of 90 degrees
    # Times to 90 % of a step of twice the amplitude, NaN if not reached [s].
    rise_up: float
    rise_down: float
    noise: float  # largest rms of the outlet pressure outside the fundamental, relative to the fundamental
    gains: dict[str, float]  # bandwidth ratio by ideal part
    limiting: str  # part with the largest ratio, or `controller`


def start_frequency(plan: LimitsPlan, volume: float, amplitude: float) -> float:
    """Return the frequency at which the search for the bandwidth starts [Hz].

    The estimate assumes that the outlet pressure changes by at most 1 MPa/s with a volume of 1 litre, and that this
    slope is inversely proportional to the volume. `volume` is in m^3 and `amplitude` in Pa.
    """
    return float(np.clip(1e6 * 1e-3 / volume / (2.0 * np.pi * amplitude), plan.lowest, 30.0))


def bandwidth_point(
    plan: LimitsPlan, volume: float, amplitude: float, guess: float | None = None, parts: Sequence[str] = (*PARTS, LOAD)
) -> BandwidthPoint:
    """Compute the bandwidths and step times for one volume [m^3] and one amplitude [Pa].

    To find the part that limits the bandwidth, each of `parts` is made nearly ideal, one at a time. `guess` is a start
    value of the bandwidth [Hz].
    """
    sweep = _settled_frequency_response(plan, volume, amplitude)
    if sweep is None:
        return BandwidthPoint(math.nan, math.nan, math.nan, math.nan, math.nan, {}, "")
    begin = guess if guess and math.isfinite(guess) else start_frequency(plan, volume, amplitude)
    end = _bandwidth(plan, sweep, begin)
    start = end if plan.lowest < end < plan.highest else begin
    lag = find_crossing(lambda f: -sweep.lag(f), -LAG, start, plan.lowest, plan.highest)
    times = []  # to 90 % of a step up and of a step down, symmetric about the mean pressure
    for change in (2.0 * amplitude, -2.0 * amplitude):
        low = _settled_frequency_response(replace(plan, mean=plan.mean - 0.5 * change), volume, amplitude)
        step = change * plan.per_pascal
        times.append(math.nan if low is None else low.rig.response_time(step, change, RISEN, LONGEST))
    up, down = times
    gains = {}  # the bandwidth with each part ideal, relative to the unchanged bandwidth
    for part in parts if 0.0 < end < math.inf else ():
        changes = ideal_part_changes(plan, part) if part in PARTS else None
        changed = _settled_frequency_response(plan, volume / IDEAL if part == LOAD else volume, amplitude, changes)
        if changed is not None:
            gains[part] = min(_bandwidth(plan, changed, end), plan.highest) / end
    best = max(gains, key=lambda part: gains[part], default="")
    limiting = (best if gains[best] >= WORTH else CONTROLLER) if gains else ""
    return BandwidthPoint(end, lag, up, down, sweep.largest_rest, gains, limiting)


def _bandwidth(plan: LimitsPlan, sweep: FrequencyResponse, guess: float) -> float:
    return find_crossing(sweep.gain, GAIN, guess / BELOW, plan.lowest, plan.highest)


def _settled_frequency_response(
    plan: LimitsPlan, volume: float, amplitude: float, changes: Changes | None = None
) -> FrequencyResponse | None:
    """Return the frequency response of a circuit after it has settled.

    `changes` maps addresses of parameters to new values. The result is None if the circuit does not settle.
    """
    try:
        return FrequencyResponse(plan.rig(volume, changes), amplitude, plan.per_pascal)
    except SimulationError:
        return None

"""What is done with a specimen in each test: setpoint, load and supply over time."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

import numpy as np

from poppet.bench.iso10094.scale import Record, Scale
from poppet.series.segments import Signal
from poppet.series.signals import Constant, Points, Sine, Steps

CYCLES = 3
SWEEP_PER_RESPONSE, SHORTEST_SWEEP, LONGEST_SWEEP = 200.0, 10.0, 60.0
"""Time of a sweep of the setpoint per response time, and its limits [s]."""
ROWS, MOST_ROWS = 4000, 40_000
"""Rows of a sweep from end to end, and of a hold."""
PER_PERIOD = 200
"""Rows of a period of a sine."""
SUPPLY_LOAD = 0.05
"""Load while the supply is swept."""
STAIR, STAIRS = 0.05, 60
"""Height of the stairs of the resolution test [% FS], and their number from the turn on."""


@dataclass(frozen=True)
class Trial:
    """One run of a specimen within a test.

    Parameters
    ----------
    kind : str
        One of `poppet.bench.iso10094.definitions.TESTS`.
    name : str
        For people.
    setpoint : Signal
        In the unit of the scale, from the beginning on.
    duration, lead : float
        Of the run, and of its first part, which only brings the specimen to rest [s].
    step : float
        Time between rows [s].
    volume : float
        At the outlet [m^3].
    supply : Signal
        Absolute supply pressure; none where it stays as it is [Pa].
    load : Signal
        From 1, all that the specimen can draw from its outlet, to -1, all that it can feed in; none for no flow.
    """

    kind: str
    name: str
    setpoint: Signal
    duration: float
    lead: float
    step: float
    volume: float
    supply: Signal | None = None
    load: Signal | None = None


class Specimen(Protocol):
    """What can be put on the bench and driven: a model, or a stand-in."""

    @property
    def title(self) -> str:
        """For people."""

    @property
    def scale(self) -> Scale:
        """Ranges of setpoint and outlet."""

    @property
    def supply(self) -> float:
        """Supply pressure, absolute [Pa]."""

    def respond(self, trial: Trial) -> Record:
        """Run a trial."""


@dataclass(frozen=True)
class Settings:
    """Choices of the bench.

    Parameters
    ----------
    volumes : tuple of float
        At the outlet; all static tests use the first one [m^3].
    amplitudes : tuple of float
        Of the steps about the middle of the range [% FS].
    sine_amplitude : float
        [% FS].
    sine_mean : float
        [% FS].
    frequencies : tuple of float
        Empty where the bench chooses them by the response time [Hz].
    setpoints : tuple of float
        Of the tests of flow, supply and leakage [% FS].
    sweep_time : float
        Of the setpoint from end to end; not a number where the bench chooses it by the response time [s].
    rated_flow : float
        At which droop and rise are read; not a number where it was not given [kg/s].
    longest_hold : float
        A specimen that has not come to rest after it never does [s].
    """

    volumes: tuple[float, ...] = (1e-3, 5e-3)
    amplitudes: tuple[float, ...] = (80.0, 50.0, 10.0)
    sine_amplitude: float = 5.0
    sine_mean: float = 50.0
    frequencies: tuple[float, ...] = ()
    setpoints: tuple[float, ...] = (25.0, 50.0, 75.0)
    sweep_time: float = math.nan
    rated_flow: float = math.nan
    longest_hold: float = 300.0


def step_trial(scale: Scale, volume: float, amplitude: float, hold: float) -> Trial:
    """A step up and a step down about the middle of the range."""
    low, high = (float(scale.setpoint(50.0 + side * amplitude / 2.0)) for side in (-1.0, 1.0))
    lead = hold
    step = hold / MOST_ROWS
    times = (0.0, lead + 0.25 * hold, lead + 1.25 * hold)
    # Rows lie on the steps: both are multiples of a quarter of the hold.
    name = f"step of {amplitude:g} % FS, {1e3 * volume:.4g} l"
    return Trial("step", name, Steps(times, (low, high, low)), lead + 2.25 * hold, lead, step, volume)


def characteristic_trial(scale: Scale, volume: float, sweep: float, hold: float) -> Trial:
    """Slow sweeps from end to end of the setpoint's range, up and down, with a hold at each end."""
    hold = max(hold, 0.05 * sweep)
    times, values = [0.0, 2.0 * hold], [0.0, 0.0]
    for _ in range(CYCLES):
        for end in (100.0, 0.0):
            times += [times[-1] + sweep, times[-1] + sweep + hold]
            values += [end, end]
    signal = Points(times, scale.setpoint(np.array(values)))
    return Trial("characteristic", "sweep of the setpoint", signal, times[-1], hold, sweep / ROWS, volume)


def resolution_trial(scale: Scale, volume: float, stair: float, hold: float, middle: float) -> Trial:
    """A small staircase up, then down, then up again."""
    lead = 20.0 * hold
    ways = np.concatenate([np.ones(STAIRS), -np.ones(STAIRS), np.ones(STAIRS)])
    levels = middle + stair * np.concatenate(([0.0], np.cumsum(ways)))
    # A step up ahead: the staircase begins with the last motion in its own direction.
    levels = np.concatenate(([middle - 10.0], levels))
    times = np.concatenate(([0.0], lead / 2.0 + np.arange(levels.size - 1) * hold))
    times[2:] += lead / 2.0
    signal = Steps(times, scale.setpoint(levels))
    name = f"stairs of {stair:g} % FS about {middle:g} % FS"
    return Trial("resolution", name, signal, times[-1] + hold, lead, hold / 50.0, volume)


def flow_trial(scale: Scale, volume: float, setpoint: float, sweep: float, hold: float, load: float) -> Trial:
    """A sweep of the load to one end and back at a constant setpoint."""
    held = Constant(float(scale.setpoint(setpoint)))
    times = np.cumsum([0.0, 2.0 * hold, sweep, hold, sweep, hold])
    signal = Points(times, np.array([0.0, 0.0, load, load, 0.0, 0.0]))
    name = f"flow {'out' if load > 0 else 'in'} at {setpoint:g} % FS"
    return Trial("flow", name, held, float(times[-1]), hold, sweep / ROWS, volume, load=signal)


def supply_trial(
    scale: Scale, volume: float, setpoint: float, sweep: float, hold: float, ends: tuple[float, float]
) -> Trial:
    """A sweep of the supply pressure up and down at a constant setpoint."""
    held = Constant(float(scale.setpoint(setpoint)))
    low, high = ends
    # One cycle ahead: what the valve remembers of its way to the setpoint is over.
    times = np.cumsum([0.0, hold, sweep, sweep, sweep, hold, sweep, hold])
    values = np.array([low, low, high, low, high, high, low, low])
    name = f"supply at {setpoint:g} % FS"
    lead = float(times[3])
    # A closed outlet would hold its pressure whatever the supply does.
    load = Points([0.0], [SUPPLY_LOAD])
    duration, signal = float(times[-1]), Points(times, values)
    return Trial("supply", name, held, duration, lead, sweep / ROWS, volume, supply=signal, load=load)


def leakage_trial(scale: Scale, volume: float, setpoint: float, hold: float) -> Trial:
    """A constant setpoint with the outlet closed."""
    held = Constant(float(scale.setpoint(setpoint)))
    return Trial("leakage", f"rest at {setpoint:g} % FS", held, 10.0 * hold, 5.0 * hold, 5.0 * hold / ROWS, volume)


def frequency_trial(
    scale: Scale, volume: float, frequency: float, hold: float, *, mean: float, amplitude: float, periods: int = 6
) -> Trial:
    """A sine of the setpoint about a mean."""
    lead = max(2.0, math.ceil(hold * frequency)) / frequency
    unit = (scale.setpoint_high - scale.setpoint_low) / 100.0
    signal = Sine(float(scale.setpoint(mean)), amplitude * unit, frequency)
    duration = lead + (periods + 0.3) / frequency
    return Trial("frequency", f"{frequency:.4g} Hz", signal, duration, lead, 1.0 / (PER_PERIOD * frequency), volume)


def preferred(frequency: float) -> float:
    """The nearest of ten preferred frequencies per decade.

    Examples
    --------
    >>> preferred(0.33), preferred(12.0)
    (0.315, 12.5)
    """
    series = (1.0, 1.25, 1.6, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0)
    place = round(10.0 * math.log10(frequency))
    return float(f"{series[place % 10] * 10.0 ** (place // 10):.6g}")

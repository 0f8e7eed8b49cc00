"""What is done with a specimen on the bench: one run of it, and the choices from which runs are made."""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Protocol

from poppet.bench.iso10094.scale import Record, Scale
from poppet.series.segments import Signal
from poppet.series.signals import Constant

ROWS = 4000
"""Rows of a sweep from end to end."""


@dataclass(frozen=True)
class Trial:
    """One run of a specimen within a test.

    Parameters
    ----------
    kind : str
        Name of the test.
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
    sine_amplitude, sine_mean : float
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


class Paced(Protocol):
    """A specimen of which it is known how fast it answers: what trials are planned by."""

    @property
    def specimen(self) -> Specimen:
        """What is tested."""

    @property
    def settings(self) -> Settings:
        """Choices."""

    def hold(self) -> float:
        """Time that it needs to come to rest at the first volume [s]."""

    def sweep(self) -> float:
        """Time for a sweep of the setpoint from end to end that is slow for it [s]."""


def held(scale: Scale, setpoint: float) -> Constant:
    """A setpoint in % FS that stays."""
    return Constant(float(scale.setpoint(setpoint)))

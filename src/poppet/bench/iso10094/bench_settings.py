"""What is done with a specimen on the bench: one run of it, and the choices from which runs are made."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, Protocol

from poppet.bench.iso10094.scale import Record, Scale
from poppet.timeseries.segments import Signal
from poppet.timeseries.signals import Constant

ROWS = 4000
"""Rows of a sweep from end to end."""


@dataclass(frozen=True)
class Trial:
    """One run of a specimen within a test."""

    kind: str  # name of the test
    name: str
    setpoint: Signal  # in the unit of the scale, from the beginning on
    duration: float  # [s]
    lead: float  # the first part of it, which only brings the specimen to rest [s]
    step: float  # time between rows [s]
    volume: float  # at the outlet [m^3]
    supply: Signal | None = None  # absolute pressure, None where it stays as it is [Pa]
    # From 1, all that can be drawn from the outlet, to -1, all that can be fed in; None for no flow.
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
class BenchSettings:
    """Choices of the bench."""

    volumes: tuple[float, ...] = (1e-3, 5e-3)  # static tests use the first one [m^3]
    amplitudes: tuple[float, ...] = (80.0, 50.0, 10.0)  # of the steps about the middle of the range [% FS]
    sine_amplitude: float = 5.0  # [% FS]
    sine_mean: float = 50.0  # [% FS]
    frequencies: tuple[float, ...] = ()  # where empty, the bench chooses them by the response time [Hz]
    setpoints: tuple[float, ...] = (25.0, 50.0, 75.0)  # of the tests of flow, supply and leakage [% FS]
    sweep_time: float = math.nan  # from end to end; where NaN, the bench chooses it by the response time [s]
    rated_flow: float = math.nan  # at which droop and rise are read; NaN where none was given [kg/s]
    longest_hold: float = 300.0  # a specimen that has not come to rest after it never does [s]


class Pace(NamedTuple):
    """How fast a specimen answers at the first volume: what trials are planned by."""

    specimen: Specimen
    settings: BenchSettings
    hold: float  # time that it needs to come to rest [s]
    sweep: Callable[[], float]  # time for a sweep of the setpoint from end to end that is slow for it [s]

    @property
    def volume(self) -> float:
        """At the outlet [m^3]."""
        return self.settings.volumes[0]


def held(scale: Scale, setpoint: float) -> Constant:
    """A setpoint in % FS that stays."""
    return Constant(float(scale.setpoint(setpoint)))

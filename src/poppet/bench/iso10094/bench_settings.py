"""Trials of a test valve on the bench, and the settings of the bench."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple, Protocol

from poppet.bench.iso10094.scale import Record, Scale
from poppet.timeseries.segments import Signal
from poppet.timeseries.signals import Constant

ROWS = 4000
"""Rows of a sweep over the full range."""


@dataclass(frozen=True)
class Trial:
    """Run of a test valve within a test."""

    kind: str  # name of the test
    name: str
    setpoint: Signal  # in the unit of the scale
    duration: float  # [s]
    lead: float  # initial part, in which the test valve settles [s]
    step: float  # time between rows [s]
    volume: float  # at the outlet [m^3]
    supply: Signal | None = None  # absolute pressure, None for a constant supply [Pa]
    # From 1 (maximum forward flow) to -1 (maximum relief flow); None for no flow.
    load: Signal | None = None


class Specimen(Protocol):
    """Interface of a test valve that the bench can drive: a model or a virtual valve."""

    @property
    def title(self) -> str:
        """Title for reports."""

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
    amplitudes: tuple[float, ...] = (80.0, 50.0, 10.0)  # steps about the middle of the range [% FS]
    sine_amplitude: float = 5.0  # [% FS]
    sine_mean: float = 50.0  # [% FS]
    frequencies: tuple[float, ...] = ()  # if empty, the bench selects them from the response time [Hz]
    setpoints: tuple[float, ...] = (25.0, 50.0, 75.0)  # for the tests of flow, supply and leakage [% FS]
    sweep_time: float = math.nan  # full range; NaN: the bench selects it from the response time [s]
    rated_flow: float = math.nan  # flow for droop and rise; NaN if not specified [kg/s]
    longest_hold: float = 300.0  # time limit for settling [s]


class Pace(NamedTuple):
    """Response times of a test valve with the first volume, for the durations of trials."""

    specimen: Specimen
    settings: BenchSettings
    hold: float  # settling time [s]
    sweep: Callable[[], float]  # duration of a slow sweep over the full range [s]

    @property
    def volume(self) -> float:
        """Volume at the outlet [m^3]."""
        return self.settings.volumes[0]


def held(scale: Scale, setpoint: float) -> Constant:
    """Return a constant setpoint in % FS."""
    return Constant(float(scale.setpoint(setpoint)))

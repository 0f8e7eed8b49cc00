"""Bench recording after reading: channels and inputs in SI units over one clock."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from poppet.core.codes import Note
from poppet.timeseries.checks import FloatArray


@dataclass(frozen=True, eq=False)
class Channel:
    """Measured signal of a circuit, in SI units with absolute pressures."""

    address: str  # `tank.pressure`
    time: FloatArray  # (n,), strictly increasing, from 0 at the first used sample of the recording [s]
    values: FloatArray  # (n,), in `unit`
    unit: str
    noise: float | None = None  # stated standard deviation; None: to be estimated
    lag: float | None = 0.0  # time constant of the sensor; None if free [s]
    quantum: float = 0.0  # resolution of the recording; 0 if unknown
    offset: float | None = None  # stated standard deviation of the sensor offset; None if not stated


@dataclass(frozen=True, eq=False)
class InputChannel:
    """Measured signal that drives the model, in SI units with absolute pressures."""

    address: str  # `inlet.mass_flow_rate`
    # (n,), on the clock of the channels; samples before their first used sample have negative times [s]
    time: FloatArray
    values: FloatArray  # (n,), in `unit`
    unit: str
    delay: float | None = 0.0  # an event at t was recorded at t + delay; None if free [s]
    lag: float | None = 0.0  # time constant of the sensor; None if free [s]
    hold: bool = False  # True: constant until the next sample (a sampled command); False: linear interpolation


@dataclass(frozen=True, eq=False)
class Measurement:
    """Recording of a test bench with its name in the file."""

    name: str
    channels: tuple[Channel, ...]  # compared with the model
    inputs: tuple[InputChannel, ...] = ()  # drive the model
    # Map from the address of an initial value to `first`, `free`, or the value as written.
    start: Mapping[str, str | float] = field(default_factory=dict)
    ambient_pressure: float = 101325.0  # absolute, to which gauge values refer [Pa]
    notes: tuple[Note, ...] = ()  # guesses, merged and omitted samples
    findings: tuple[Note, ...] = ()  # suspicions with their evidence
    duration: float = 0.0  # time of the last sample of a channel [s]

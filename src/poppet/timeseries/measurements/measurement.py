"""What a bench recording is once it is read: channels and inputs in SI over one clock."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from poppet.core.codes import Note
from poppet.timeseries.checks import FloatArray


@dataclass(frozen=True, eq=False)
class Channel:
    """One measured signal of a circuit, in SI, pressures absolute."""

    address: str  # `tank.pressure`
    time: FloatArray  # (n,), strictly increasing, from 0 at the first used sample of the recording [s]
    values: FloatArray  # (n,), in `unit`
    unit: str
    noise: float | None = None  # one standard deviation as stated; None where it is to be estimated
    lag: float | None = 0.0  # time constant of the sensor; None when it is free [s]
    quantum: float = 0.0  # step of the recording; 0 where none can be seen
    offset: float | None = None  # one standard deviation of the sensor's zero as stated; None where nobody says


@dataclass(frozen=True, eq=False)
class InputChannel:
    """One measured signal that drives the model, in SI, pressures absolute."""

    address: str  # `inlet.mass_flow_rate`
    # (n,), on the clock of the channels: what was recorded before their first used sample stays, at negative times [s]
    time: FloatArray
    values: FloatArray  # (n,), in `unit`
    unit: str
    delay: float | None = 0.0  # what happened at t was recorded at t + delay; None when it is free [s]
    lag: float | None = 0.0  # time constant of the sensor; None when it is free [s]
    hold: bool = False  # until the next sample, as a computer writes a command; else straight between samples


@dataclass(frozen=True, eq=False)
class Measurement:
    """One recording of a bench under the name that the user gave it."""

    name: str
    channels: tuple[Channel, ...]  # what a model is compared with
    inputs: tuple[InputChannel, ...] = ()  # what drives it
    # From the address of an initial value to `first`, `free`, or a value as it was written.
    start: Mapping[str, str | float] = field(default_factory=dict)
    ambient_pressure: float = 101325.0  # absolute, to which gauge values refer [Pa]
    notes: tuple[Note, ...] = ()  # what was guessed, merged or left out
    findings: tuple[Note, ...] = ()  # what looks wrong with it, with the evidence
    duration: float = 0.0  # time of the last sample of a channel [s]

"""What a bench recording is once it is read: channels and inputs in SI over one clock."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from poppet.ground.codes import Note
from poppet.series.checks import FloatArray


@dataclass(frozen=True, eq=False)
class Channel:
    """One measured signal of a circuit.

    Parameters
    ----------
    address : str
        Of the signal, `tank.pressure`.
    time : (n,) array
        Strictly increasing, from 0 at the first used sample of the recording [s].
    values : (n,) array
        In `unit`; pressures are absolute.
    unit : str
        SI.
    noise : float or None
        One standard deviation as stated, in `unit`; None where it is to be estimated.
    lag : float or None
        Time constant of the sensor; None when it is free [s].
    quantum : float
        Step of the recording, in `unit`; 0 where none can be seen.
    """

    address: str
    time: FloatArray
    values: FloatArray
    unit: str
    noise: float | None = None
    lag: float | None = 0.0
    quantum: float = 0.0


@dataclass(frozen=True, eq=False)
class InputChannel:
    """One measured signal that drives the model.

    Parameters
    ----------
    address : str
        Of the input, `inlet.mass_flow_rate`.
    time : (n,) array
        Strictly increasing, on the clock of the channels: what was recorded before their first used sample stays,
        at negative times [s].
    values : (n,) array
        In `unit`; pressures are absolute.
    unit : str
        SI.
    delay : float or None
        By how much the record is late: what happened at t was recorded at t + delay; None when it is free [s].
    lag : float or None
        Time constant of the sensor; None when it is free [s].
    hold : bool
        Each value holds until the next sample, as a computer writes a command; else straight between samples.
    """

    address: str
    time: FloatArray
    values: FloatArray
    unit: str
    delay: float | None = 0.0
    lag: float | None = 0.0
    hold: bool = False


@dataclass(frozen=True, eq=False)
class Measurement:
    """One recording of a bench.

    Parameters
    ----------
    name : str
        What the user called it.
    channels : tuple of Channel
        What a model is compared with.
    inputs : tuple of InputChannel
        What drives it.
    start : mapping
        From the address of an initial value to `first`, `free`, or a value as it was written.
    ambient_pressure : float
        Absolute pressure to which gauge values refer [Pa].
    notes : tuple of Note
        What was guessed, merged or left out.
    findings : tuple of Note
        What looks wrong with it, with the evidence.
    duration : float
        Time of the last sample of a channel [s].
    """

    name: str
    channels: tuple[Channel, ...]
    inputs: tuple[InputChannel, ...] = ()
    start: Mapping[str, str | float] = field(default_factory=dict)
    ambient_pressure: float = 101325.0
    notes: tuple[Note, ...] = ()
    findings: tuple[Note, ...] = ()
    duration: float = 0.0

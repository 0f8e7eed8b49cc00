"""Points of a steady flow bench: what was read, how well it was read, and readings that cannot be."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import ErrorCollector, InputError, OutOfRangeError, collect
from poppet.core.units import convert, sizes_of
from poppet.laws.iso6358 import mass_flow_rate
from poppet.timeseries.checks import FloatArray, numbers
from poppet.timeseries.recording import Recording

CHANNELS = {"mass_flow_rate": "kg/s", "pressure_1": "Pa", "pressure_2": "Pa", "temperature_1": "K"}
"""What a bench reads at every point, with SI units."""

TEMPERATURES = (200.0, 450.0)
"""Air of a flow bench; 20 degC read as 20 K lies far outside [K]."""


@dataclass(frozen=True)
class Instrument:
    """Standard uncertainties (one sigma) of the readings of one instrument.

    Parameters
    ----------
    absolute : float, optional
        Independent from point to point: noise, resolution; in the SI unit of the channel.
    relative : float, optional
        Independent from point to point, as a fraction of the reading.
    offset : float, optional
        The same for all points: zero error; in the SI unit of the channel.
    calibration : float, optional
        The same for all points, as a fraction of the reading: scale error.

    Notes
    -----
    A data sheet that states limits +- a without a distribution means a/sqrt(3) (GUM, 4.3.7).

    Examples
    --------
    >>> Instrument(relative=0.01, calibration=0.005).is_noisy
    True
    """

    absolute: float = 0.0
    relative: float = 0.0
    offset: float = 0.0
    calibration: float = 0.0

    def __post_init__(self) -> None:
        wrong = {name: value for name, value in vars(self).items() if not 0.0 <= value < np.inf}
        collect([OutOfRangeError("flow.uncertainty", name, value=value) for name, value in wrong.items()])

    @property
    def is_noisy(self) -> bool:
        """True when an uncertainty from point to point is known."""
        return self.absolute > 0.0 or self.relative > 0.0


@dataclass(frozen=True)
class Effect:
    """An error common to all points, of one standard deviation."""

    source: str  # for the budget
    channels: tuple[str, ...]  # readings that it moves
    offset: float  # by this much, in the SI unit of the channel,
    calibration: float  # and by this fraction of the reading


@dataclass(frozen=True, eq=False)
class FlowPoints:
    """Steady points of a flow bench, checked.

    Parameters
    ----------
    mass_flow_rate : (n,) array
        From port 1 to port 2, not below zero [kg/s].
    pressure_1 : (n,) array
        Absolute upstream stagnation pressure [Pa].
    pressure_2 : (n,) array
        Absolute downstream pressure, not above `pressure_1` where there is flow [Pa].
    temperature_1 : (n,) array or float
        Upstream stagnation temperature; one for all points or one each [K].
    u_mass_flow_rate : Instrument, optional
        Uncertainty of the flow meter; without a part from point to point the scatter is estimated.
    u_pressure_1 : Instrument, optional
        Of the upstream transducer.
    u_pressure_2 : Instrument, optional
        Of the downstream transducer.
    u_temperature_1 : Instrument, optional
        Of the thermometer.
    u_ambient_pressure : float, optional
        Standard uncertainty of the barometer where both pressures were read as gauge: it moves both together [Pa].
    lines : sequence of int, optional
        Line of each point in its file, from 1, for findings.

    Raises
    ------
    InputErrors
        Lengths that differ, values that are not finite, gauge pressures below zero, degC instead of K, flow
        against the pressure drop: all at once.

    Examples
    --------
    >>> points = FlowPoints([0.0120, 0.0119, 0.0084], 5e5, [1e5, 1.5e5, 4e5], 293.15)
    >>> points.pressure_ratio.tolist()
    [0.2, 0.3, 0.8]
    """

    mass_flow_rate: FloatArray
    pressure_1: FloatArray
    pressure_2: FloatArray
    temperature_1: FloatArray
    u_mass_flow_rate: Instrument = field(default_factory=Instrument)
    u_pressure_1: Instrument = field(default_factory=Instrument)
    u_pressure_2: Instrument = field(default_factory=Instrument)
    u_temperature_1: Instrument = field(default_factory=Instrument)
    u_ambient_pressure: float = 0.0
    lines: Sequence[int] = ()

    def __post_init__(self) -> None:
        given = {name: np.atleast_1d(numbers(name, getattr(self, name))) for name in CHANNELS}
        size = max(array.size for array in given.values())
        if not size:
            raise InputError("flow.no_points", "mass_flow_rate")
        with ErrorCollector() as errors:
            for name, array in given.items():
                # What a bench holds may be one number for all points; the flow is what is measured.
                if array.ndim != 1 or array.size not in ((size,) if name == "mass_flow_rate" else (1, size)):
                    errors.add("flow.shape", name, shape=str(array.shape), points=size)
        for name, array in given.items():
            object.__setattr__(self, name, np.broadcast_to(array, size).copy())
        # Values first: directions of values that cannot be say nothing.
        collect(_value_mistakes(self))
        collect(_direction_mistakes(self))

    @classmethod
    def from_recording(
        cls,
        recording: Recording,
        *,
        mass_flow_rate: str,
        pressure_1: str,
        pressure_2: str,
        temperature_1: str,
        **uncertainties: Instrument,
    ) -> FlowPoints:
        """One point per sample of a recording, whose series have units.

        Parameters
        ----------
        recording : Recording
            Of a bench that was steady at every sample.
        mass_flow_rate : str
            Name of the series of a mass flow rate, or a volume flow rate in ANR.
        pressure_1 : str
            Of the upstream pressure; gauge where its unit says so.
        pressure_2 : str
            Of the downstream pressure.
        temperature_1 : str
            Of the upstream temperature.
        **uncertainties
            As in `FlowPoints`.

        Returns
        -------
        FlowPoints
        """
        names = dict(zip(CHANNELS, (mass_flow_rate, pressure_1, pressure_2, temperature_1), strict=True))
        ambient = recording.ambient_pressure
        columns = {
            channel: convert(recording[name], recording.unit(name), CHANNELS[channel], ambient_pressure=ambient)
            for channel, name in names.items()
        }
        return cls(**columns, **uncertainties)  # type: ignore[arg-type]

    def __len__(self) -> int:
        return int(self.mass_flow_rate.size)

    @property
    def pressure_ratio(self) -> FloatArray:
        """p2/p1 of every point, shape (n,)."""
        return self.pressure_2 / self.pressure_1

    @property
    def effective_conductance(self) -> FloatArray:
        """Conductance that would carry the flow if it were choked, shape (n,) [m^3/(s Pa)]."""
        return conductance_of(self.mass_flow_rate, self.pressure_1, self.temperature_1)

    def instrument(self, channel: str) -> Instrument:
        """Uncertainty of one channel.

        Parameters
        ----------
        channel : str
            `mass_flow_rate`, `pressure_1`, `pressure_2` or `temperature_1`.

        Returns
        -------
        Instrument
        """
        found: Instrument = getattr(self, f"u_{channel}")
        return found

    def effects(self) -> Iterator[Effect]:
        """The errors common to all points that the instruments may have."""
        for channel in CHANNELS:
            known = self.instrument(channel)
            if known.calibration:
                yield Effect(f"calibration of {channel}", (channel,), 0.0, known.calibration)
            if known.offset:
                yield Effect(f"offset of {channel}", (channel,), known.offset, 0.0)
        if self.u_ambient_pressure:
            yield Effect("ambient pressure", ("pressure_1", "pressure_2"), self.u_ambient_pressure, 0.0)


def conductance_of(flow: FloatArray, pressure_1: FloatArray, temperature_1: FloatArray) -> FloatArray:
    """Effective conductance, without a check: a closed passage may read a little below zero."""
    choked = mass_flow_rate(pressure_1, 0.0, temperature_1, sonic_conductance=1.0, critical_ratio=0.0)
    return np.asarray(flow / choked)


def _value_mistakes(points: FlowPoints) -> list[InputError]:
    low, high = TEMPERATURES
    flow, p_1, p_2, temperature = (getattr(points, name) for name in CHANNELS)
    beyond = np.isfinite(temperature) & ((temperature < low) | (temperature > high))
    found: list[InputError] = []
    for name in CHANNELS:
        values, largest = getattr(points, name), sizes_of(CHANNELS[name])[1]
        found += _first("flow.not_finite", points, name, ~np.isfinite(values))
        found += _first(
            "flow.too_large", points, name, np.isfinite(values) & (np.abs(values) > largest), largest=largest
        )
    found += _first("flow.upstream", points, "pressure_1", p_1 <= 0.0)
    found += _first("flow.downstream", points, "pressure_2", p_2 < 0.0)
    found += _first("flow.temperature", points, "temperature_1", beyond, low=low, high=high)
    if np.isfinite(flow).all() and not (flow > 0.0).any():
        found.append(InputError("flow.no_flow", "mass_flow_rate"))
    return found


def _direction_mistakes(points: FlowPoints) -> list[InputError]:
    """Flow against the pressure drop, beyond what noise explains."""
    noise = 3.0 * (points.u_mass_flow_rate.absolute + points.u_mass_flow_rate.offset)
    least = np.maximum(noise, 0.01 * np.max(points.mass_flow_rate))
    backwards = points.mass_flow_rate < -least
    drop, transducers = points.pressure_1 - points.pressure_2, (points.u_pressure_1, points.u_pressure_2)
    against = points.mass_flow_rate > least
    against &= drop < -3.0 * sum(known.absolute + known.offset for known in transducers) - 1e-3 * points.pressure_1
    backward = _first("flow.backwards", points, "mass_flow_rate", backwards)
    return [*backward, *_first("flow.against", points, "pressure_2", against)]


def _first(code: str, points: FlowPoints, name: str, bad: NDArray[np.bool_], **facts: Any) -> list[InputError]:
    """The mistake at the first bad point, with how many more there are."""
    if not bad.any():
        return []
    k, count = int(np.argmax(bad)), int(np.sum(bad))
    facts |= {"value": float(getattr(points, name)[k]), "unit": CHANNELS[name], "place": k}
    return [OutOfRangeError(code, name, several=count if count > 1 else None, **facts)]


def refuse_rising_flow(points: FlowPoints) -> None:
    """Raise where the effective conductance rises with p2/p1, which no fixed passage does."""
    order = np.argsort(points.pressure_ratio)
    ratio, conductance = points.pressure_ratio[order], points.effective_conductance[order]
    third = max(len(points) // 3, 1)
    first, last = float(np.median(conductance[:third])), float(np.median(conductance[-third:]))
    ranks = np.argsort(np.argsort(conductance))
    rises = np.corrcoef(ranks, np.arange(len(points)))[0, 1] > 0.5
    meter = points.u_mass_flow_rate
    noise = 4.0 * meter.relative + 4.0 * meter.absolute / np.max(points.mass_flow_rate)
    if rises and ratio[-1] - ratio[0] > 0.02 and last > first * (1.02 + noise):
        ends = {"first": first, "first_ratio": ratio[0], "last": last, "last_ratio": ratio[-1]}
        raise InputError("flow.rises", "mass_flow_rate", **ends)

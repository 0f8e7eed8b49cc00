"""Points of a steady flow bench, with the uncertainties of the instruments."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import ErrorCollector, InputError, OutOfRangeError
from poppet.core.tables import NumberRange
from poppet.core.units import convert, sizes_of
from poppet.laws.iso6358 import mass_flow_rate
from poppet.timeseries.checks import FloatArray, numbers
from poppet.timeseries.recording import Recording

CHANNELS = {"mass_flow_rate": "kg/s", "pressure_1": "Pa", "pressure_2": "Pa", "temperature_1": "K"}
"""Quantities of each point, with their SI units."""

UNCERTAINTIES = NumberRange(unit="", low=0.0, below=np.inf)
TEMPERATURES = (233.15, 333.15)
"""Temperatures of a flow bench, -40 to 60 degC; they exclude 20 degC read as 20 K and 68 degF read as 68 degC [K]."""

PRESSURES = (1e4, 5e7)
"""Range of the largest upstream pressure of a flow bench; it excludes bar or kPa read as Pa, and the reverse [Pa]."""


@dataclass(frozen=True)
class Instrument:
    """Standard uncertainties of the readings of one instrument.

    Parameters
    ----------
    absolute : float, optional
        Standard uncertainty of errors that are independent at each point, in the SI unit of the channel.
    relative : float, optional
        Like `absolute`, but as a fraction of the reading.
    offset : float, optional
        Standard uncertainty of an offset that all points share (zero error), in the SI unit of the channel.
    calibration : float, optional
        Standard uncertainty of a scale error that all points share, as a fraction of the reading.

    Notes
    -----
    Limits +/- a without a distribution correspond to a standard uncertainty of a/sqrt(3) (GUM, 4.3.7).

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
        with ErrorCollector() as errors:
            for name, value in vars(self).items():
                with errors.collecting():
                    UNCERTAINTIES.check_range(name, value, f"{value:g}", "standard uncertainty")

    @property
    def is_noisy(self) -> bool:
        """True if `absolute` or `relative`, the uncertainties that are independent at each point, are stated."""
        return self.absolute > 0.0 or self.relative > 0.0

    @property
    def is_calibrated(self) -> bool:
        """True if `offset` or `calibration`, the uncertainties that all points share, are stated."""
        return self.offset > 0.0 or self.calibration > 0.0

    def of_one_reading(self) -> Instrument:
        """Return the uncertainties of an instrument whose single reading is used for all points.

        All its errors are then common to the points.
        """
        return Instrument(
            offset=math.hypot(self.absolute, self.offset), calibration=math.hypot(self.relative, self.calibration)
        )


@dataclass(frozen=True)
class Effect:
    """Change in the readings of all points that an error common to them causes.

    The error has the size of one standard deviation.
    """

    source: str  # name of the error in the uncertainty budget
    channels: tuple[str, ...]  # readings that the error shifts
    offset: float  # shift of the readings, in the SI unit of the channel
    calibration: float  # shift as a fraction of the reading

    def shift(self, reading: FloatArray) -> FloatArray:
        """Return the changes of the readings `reading` of one channel."""
        return self.offset + self.calibration * reading


@dataclass(frozen=True, eq=False)
class FlowPoints:
    """Steady operating points of a flow path, measured on a flow bench.

    Parameters
    ----------
    mass_flow_rate : (n,) array
        Mass flow rate from port 1 to port 2, not negative [kg/s].
    pressure_1 : (n,) array
        Absolute upstream stagnation pressure [Pa].
    pressure_2 : (n,) array
        Absolute downstream pressure, at most `pressure_1` at points with flow [Pa]. The error of a single value for all
        points is common to all points, also if it is stated as `absolute` or `relative`.
    temperature_1 : (n,) array or float
        Upstream stagnation temperature: one value, or one for each point [K].
    u_mass_flow_rate : Instrument, optional
        Uncertainty of the flow meter. If neither `absolute` nor `relative` is stated, the fit estimates the scatter.
    u_pressure_1 : Instrument, optional
        Uncertainty of the upstream sensor.
    u_pressure_2 : Instrument, optional
        Uncertainty of the downstream sensor.
    u_temperature_1 : Instrument, optional
        Uncertainty of the temperature sensor.
    u_ambient_pressure : float, optional
        Standard uncertainty of the ambient pressure if both pressures are gauge: its error is common to both [Pa].
    lines : sequence of int, optional
        Line number of each point in the file of the points, starting at 1. Findings refer to it.
    is_absolute : bool, optional
        True if the readings are certainly absolute: the fit then does not test if they are gauge pressures.

    Raises
    ------
    InputErrors
        All errors: different lengths, values that are not finite, gauge pressures below zero, degC instead of K, flow
        against the pressure drop.

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
    is_absolute: bool = False

    def __post_init__(self) -> None:
        arrays = {name: np.atleast_1d(numbers(name, getattr(self, name))) for name in CHANNELS}
        size = max(array.size for array in arrays.values())
        if not size:
            raise InputError("flow.no_points", "mass_flow_rate")
        with ErrorCollector() as errors:
            for name, array in arrays.items():
                # Conditions of the bench may be one value for all points; the flow needs one for each.
                if array.ndim != 1 or array.size not in ((size,) if name == "mass_flow_rate" else (1, size)):
                    errors.add("flow.shape", name, shape=str(array.shape), points=size)
        for name, array in arrays.items():
            object.__setattr__(self, name, np.broadcast_to(array, size).copy())
            if array.size < size:
                object.__setattr__(self, f"u_{name}", self.instrument(name).of_one_reading())
        low, high = TEMPERATURES
        flow, p_1, p_2, temperature = (getattr(self, name) for name in CHANNELS)
        is_implausible = np.isfinite(temperature) & ((temperature < low) | (temperature > high))
        with ErrorCollector() as errors:
            for name, unit in CHANNELS.items():
                values, largest = getattr(self, name), PRESSURES[1] if unit == "Pa" else sizes_of(unit)[1]
                is_large = np.isfinite(values) & (np.abs(values) > largest)
                self._add_error(errors, "flow.not_finite", name, ~np.isfinite(values))
                self._add_error(errors, "flow.too_large", name, is_large, largest=largest)
            self._add_error(errors, "flow.upstream", "pressure_1", p_1 <= 0.0)
            is_small = (p_1 > 0.0) & (np.max(p_1) < PRESSURES[0])
            self._add_error(errors, "flow.too_small", "pressure_1", is_small, least=PRESSURES[0])
            self._add_error(errors, "flow.downstream", "pressure_2", p_2 < 0.0)
            self._add_error(errors, "flow.temperature", "temperature_1", is_implausible, low=low, high=high)
            if np.isfinite(flow).all() and not (flow > 0.0).any():
                errors.add("flow.no_flow", "mass_flow_rate")
        # Values first: the direction of an invalid value has no meaning. A flow within the noise can be negative.
        noise = 3.0 * (self.u_mass_flow_rate.absolute + self.u_mass_flow_rate.offset)
        least = max(noise, 0.01 * float(np.max(flow)))
        noise = 3.0 * sum(sensor.absolute + sensor.offset for sensor in (self.u_pressure_1, self.u_pressure_2))
        with ErrorCollector() as errors:
            self._add_error(errors, "flow.backwards", "mass_flow_rate", flow < -least)
            self._add_error(errors, "flow.against", "pressure_2", (flow > least) & (p_1 - p_2 < -noise - 1e-3 * p_1))

    def _add_error(
        self, errors: ErrorCollector, code: str, name: str, is_invalid: NDArray[np.bool_], **facts: Any
    ) -> None:
        """Add an error for the first invalid point.

        `is_invalid` is the mask of invalid points, whose number is in the message. `name` is the channel.
        """
        if is_invalid.any():
            k, count = int(np.argmax(is_invalid)), int(np.sum(is_invalid))
            facts |= {"value": float(getattr(self, name)[k]), "unit": CHANNELS[name], "place": k}
            errors.extend([OutOfRangeError(code, name, several=count if count > 1 else None, **facts)])

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
        """Return one point for each sample of a recording.

        Parameters
        ----------
        recording : Recording
            Recording of a bench in steady flow at each sample; its series have units.
        mass_flow_rate : str
            Name of the series with the mass flow rate, or a volume flow rate in ANR.
        pressure_1 : str
            Name of the series with the upstream pressure; its unit can be gauge.
        pressure_2 : str
            Name of the series with the downstream pressure.
        temperature_1 : str
            Name of the series with the upstream temperature.
        **uncertainties
            Uncertainties of the instruments, which `FlowPoints` describes.

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
        """Pressure ratio p2/p1 of each point, shape (n,)."""
        return self.pressure_2 / self.pressure_1

    @property
    def effective_conductance(self) -> FloatArray:
        """Sonic conductance at which each measured flow would be choked [m^3/(s Pa)].

        The shape is (n,).
        """
        return conductance_of(self.mass_flow_rate, self.pressure_1, self.temperature_1)

    def instrument(self, channel: str) -> Instrument:
        """Return the stated uncertainties of the instrument of one channel.

        Parameters
        ----------
        channel : str
            `mass_flow_rate`, `pressure_1`, `pressure_2` or `temperature_1`.

        Returns
        -------
        Instrument
        """
        instrument: Instrument = getattr(self, f"u_{channel}")
        return instrument

    def effects(self) -> Iterator[Effect]:
        """Yield the errors that all points share, with their effect on the readings.

        They are calibration and offset of each instrument, and the ambient pressure.
        """
        for channel in CHANNELS:
            instrument = self.instrument(channel)
            if instrument.calibration:
                yield Effect(f"calibration of {channel}", (channel,), 0.0, instrument.calibration)
            if instrument.offset:
                yield Effect(f"offset of {channel}", (channel,), instrument.offset, 0.0)
        if self.u_ambient_pressure:
            yield Effect("ambient pressure", ("pressure_1", "pressure_2"), self.u_ambient_pressure, 0.0)


def conductance_of(flow: FloatArray, pressure_1: FloatArray, temperature_1: FloatArray) -> FloatArray:
    """Return the sonic conductance at which measured flows would be choked, (n,) [m^3/(s Pa)].

    The flows may be slightly below zero.
    """
    choked = mass_flow_rate(pressure_1, 0.0, temperature_1, sonic_conductance=1.0, critical_ratio=0.0)
    return np.asarray(flow / choked)


def reject_rising_flow(points: FlowPoints) -> None:
    """Raise an error if the effective conductance rises with p2/p1.

    Such a rise is impossible for a flow path that does not change.
    """
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

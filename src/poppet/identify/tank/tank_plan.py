"""Plan for the fit of a tank test: circuits, start values and checks of the recordings."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.options import Ambient
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, relocated
from poppet.core.tables import Field, missing_field, read_fields
from poppet.core.units import quantity
from poppet.identify.fit.fit_plan import ROLES, FitPlan, offset_parameter, plan_fit, recording_parameters
from poppet.identify.fit.search import SearchSettings
from poppet.identify.free_parameter import FreeParameter, NormalPrior, read_free
from poppet.identify.tank.resting import rest_before_opening
from poppet.identify.tank.test import DIRECTIONS, TankTest
from poppet.laws.iso6358.law import REFERENCE_DENSITY, REFERENCE_TEMPERATURE
from poppet.laws.physics.gas import AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT
from poppet.parts.chamber import Chamber
from poppet.parts.fields import NumberLike, NumberSpec, read_number, specs
from poppet.parts.flow_path import Orifice
from poppet.parts.part import Part
from poppet.parts.sources import Reservoir
from poppet.timeseries.measurements import Channel, InputChannel, Measurement, noise_of, quantum_of, read_measurement
from poppet.timeseries.measurements.measurement import LEAST_SAMPLES, ordered
from poppet.timeseries.measurements.verdicts import verdicts

OWN = {
    "direction": Field(choices=DIRECTIONS),
    "volume": Field(),
    "supply_pressure": Field(),
    "supply_temperature": Field(),
    "opens": Field(unit="s"),
    "closes": Field(unit="s"),
    "use": Field(choices=ROLES),
}
"""Fields of a tank test in a recording; the other fields of its table are those of a fit file."""
PRESSURE, TEMPERATURE, SUPPLY = "tank.pressure", "tank.temperature", "supply.pressure"
ARRAYS = {PRESSURE: "Pa", TEMPERATURE: "K"}
OF_ARRAYS = {"time": Field(), **dict.fromkeys(ARRAYS, Field()), "start": Field(type="table")}
OF_ARRAY = {
    "values": Field(is_required=True, meaning="list of samples in SI units"),
    **dict.fromkeys(("noise", "offset"), Field()),
}
OF_ARRAY["lag"] = Field(unit="s", choices=("free",))
_PRESSURE = Field(meaning="pressure of the tank", example='"tank.pressure" = { column = "p", unit = "bar" }')
_SUPPLY = Field(
    meaning="pressure of the supply",
    example='supply_pressure = "7 bar", or inputs = { "supply.pressure" = { column = "p_supply", unit = "bar g" } }',
)

COMMON_RATIO = 0.3
"""Start value of b: the mean of catalogue values."""
COMMON_EXPONENT, EXPONENTS = 1.2, {"min": 1.0, "max": AIR_ISENTROPIC_EXPONENT}
"""Start value of n, and its default bounds: isothermal and adiabatic."""
AREA_FACTOR, COMMON_COEFFICIENT = 6.0, 8.0
"""Start value of h A: the surface of a cube of the volume, and 8 W/(m^2 K) for free convection in air."""
LEAK_ADDRESS = "leak.sonic_conductance"
LEAK = 0.01
"""Start value of the leak, as a fraction of the conductance of the valve."""
NEARLY_TIGHT = 1e-3
"""Leak of a tight tank for derivatives by the leak, as a fraction of the conductance of the valve. The steps of a run
without a leak are too long for the start of the flow if the valve closes at ambient pressure."""
PLAUSIBLE_WALL = 5e3
"""Heat capacity per surface of a light vessel, 2 mm of aluminium [J/(m^2 K)]; it is 7.4e3 for 2 mm of steel."""
ONSET, COURSE = 0.02, 0.4
"""Fractions of the total change that limit the window for the start value of C; the first also marks the onset."""
LEAST_CHANGE, CONTRARY = 20.0, 5.0
"""Limits in sigmas of the noise: least change that can be fitted, and change in the wrong direction."""
NARROW_ZONE = 0.99999
"""Laminar ratio of the valve. While a tank cools with an open valve, the pressures are almost equal; the usual laminar
zone would change the pressure by up to 240 Pa and the wall conductance by several sigmas."""
RESTING, STIRRED = 0.1, 0.05
"""Check that the valve is open from the start: longest rest as a fraction of the window of the start value, and largest
fraction of the total change that noise can hide."""
ABOVE_SUPPLY = 1.02
"""Largest final pressure of a charge, as a fraction of the supply pressure."""
USUAL_ZERO = 0.01
"""Default standard deviation of a free sensor offset, as a fraction of the range of the recording."""


@dataclass(frozen=True)
class TankRun:
    """Recording of a tank test with its conditions, such as volume and supply pressure."""

    measurement: Measurement
    direction: str
    volume: Any
    supply_pressure: Any
    supply_temperature: Any
    opens: float = 0.0
    closes: float = math.inf
    use: str = "fit"

    @property
    def pressure(self) -> Channel:
        """Channel that contains the recorded tank pressure."""
        return next(channel for channel in self.measurement.channels if channel.address == PRESSURE)

    @property
    def supply(self) -> NumberLike:
        """Supply pressure of the recording, as stated.

        If the supply pressure is a free parameter, the value is its start value (default: highest recorded tank
        pressure).
        """
        return _start_value(self.supply_pressure, float(np.max(self.pressure.values)))

    @property
    def has_temperature(self) -> bool:
        """True if the recording contains the tank temperature."""
        return any(channel.address == TEMPERATURE for channel in self.measurement.channels)

    @property
    def place(self) -> str:
        """Address of the recording in the input file, which messages state."""
        return f"recordings.{self.measurement.name}"


def read_runs(test: TankTest) -> list[TankRun]:
    """Read and check the recordings of a tank test."""
    pressure = float(_ambient(test).pressure)  # type: ignore[arg-type]
    runs: list[TankRun] = []
    with ErrorCollector() as errors:
        for name, recording in test.recordings.items():
            with errors.collecting():
                runs.append(_read_run(test, name, recording, pressure))
    with ErrorCollector() as errors:
        for run in runs:
            with errors.collecting():
                _check_run(test, run, pressure)
    return runs


def plan_tank_fit(test: TankTest, runs: Sequence[TankRun]) -> FitPlan:
    """Return the plan of the fit to a tank test: circuits, recordings and free parameters."""
    ambient, complete_runs = _ambient(test), list[TankRun]()
    circuits = [_circuit(test, run, ambient) for run in runs]
    for run in runs:
        start: dict[str, Any] = {"tank.initial_pressure": "free"}
        if test.initial_temperature is None and run.has_temperature:
            start["tank.initial_temperature"] = "first"
        channels, inputs, duration = run.measurement.channels, run.measurement.inputs, run.measurement.duration
        if test.pressure_lag != 0.0 and run.pressure.lag == 0.0:
            is_known = not is_free(test.pressure_lag)
            lag = quantity(test.pressure_lag, "s", name="pressure_lag").value if is_known else None
            channels = tuple(replace(c, lag=lag) if c is run.pressure else c for c in channels)
        if test.valve_delay != 0.0 or run.opens != 0.0 or run.closes < math.inf:
            delay = 0.0 if test.valve_delay == "free" else quantity(test.valve_delay, "s", name="valve_delay").value
            edge = 1e-6 * duration
            times, values = [run.opens - edge, run.opens], [0.0, 1.0]
            if run.closes < math.inf:
                times, values = [*times, run.closes - edge, run.closes], [*values, 1.0, 0.0]
            # An input with a delayed effect is equivalent to an early recording.
            inputs += (InputChannel(f"{test.part}.opening", np.array(times), np.array(values), "1", -delay),)
        start |= run.measurement.start
        measurement = replace(run.measurement, channels=channels, inputs=inputs, start=start)
        complete_runs.append(replace(run, measurement=measurement))
    measurements, roles = [run.measurement for run in complete_runs], [run.use for run in runs]
    settings = SearchSettings(test.loss, test.starts, test.seed)
    free = _free_parameters(test, complete_runs, circuits)
    return plan_fit(circuits, measurements, roles, free, settings=settings, title=test.title)


def _ambient(test: TankTest) -> Ambient:
    try:
        return Ambient(pressure=test.ambient_pressure, temperature=test.effective_ambient_temperature)
    except InputError as error:
        raise relocated(error, "ambient_{}".format) from None


# Recordings -------------------------------------------------------------------------------------------------------


def _read_run(test: TankTest, name: str, recording: Any, ambient_pressure: float) -> TankRun:
    location = f"recordings.{name}"
    if not isinstance(recording, Mapping):
        raise InputError("fields.no_table", location, value=recording)
    table = {key: value for key, value in recording.items() if key not in OWN}
    with ErrorCollector() as errors:
        fields = read_fields(errors, {key: recording[key] for key in OWN if key in recording}, OWN, location)
        if PRESSURE not in table:
            errors.extend([missing_field(f"{location}.{PRESSURE}", _PRESSURE)])
    if isinstance(table.get("time"), str | int | Mapping | None):
        measurement = read_measurement(
            name, table, Path(test.folder), ambient_pressure=ambient_pressure, other_fields=tuple(OWN)
        )
    else:
        channels, notes = list[Channel](), list[Note]()
        with ErrorCollector() as errors:
            read_fields(errors, table, OF_ARRAYS, location, table="recording of arrays")
            for address in [address for address in ARRAYS if address in table]:
                with errors.collecting():
                    channel, channel_notes = _read_channel(address, table, f"{location}.{address}")
                    channels.append(channel)
                    notes += channel_notes
        findings = tuple(verdicts(channels, (), ambient_pressure, frozenset()))
        duration = max(float(channel.time[-1]) for channel in channels)
        start = dict(table.get("start", {}))
        measurement = Measurement(name, tuple(channels), (), start, ambient_pressure, tuple(notes), findings, duration)
    shared = {key: getattr(test, key) for key in ("direction", "volume", "supply_pressure", "supply_temperature")}
    supply = next((item for item in measurement.inputs if item.address == SUPPLY), None)
    if shared["supply_pressure"] is None and supply is not None:
        shared["supply_pressure"] = float(np.max(supply.values))
    run = TankRun(measurement, **{**shared, **fields})
    if not 0.0 <= run.opens < run.closes:
        raise InputError("tank.closes", f"{location}.closes", opens=run.opens, closes=run.closes)
    return run


def _read_channel(address: str, table: Mapping[str, Any], location: str) -> tuple[Channel, list[Note]]:
    """Return a channel from arrays, with notes on omitted or merged samples.

    `table` contains the times as `time`, and the array or the table of each channel by address. `address` selects the
    channel, and `location` is the location of the channel in messages.
    """
    with ErrorCollector() as errors:
        argument = table[address]
        raw = argument if isinstance(argument, Mapping) else {"values": argument}
        read = read_fields(errors, raw, OF_ARRAY, location, table="channel")
    try:
        time, values = (np.asarray(array, dtype=np.float64) for array in (table.get("time"), read["values"]))
    except (TypeError, ValueError, OverflowError):
        raise InputError("tank.no_samples", location, value=read["values"]) from None
    if time.ndim != 1 or time.shape != values.shape or time.size < LEAST_SAMPLES:
        raise InputError("tank.shapes", location, shape=values.shape, time=time.shape, least=LEAST_SAMPLES)
    samples = ordered(time - float(np.nanmin(time)), values)
    lag = read.get("lag", 0.0)
    noise, offset = (float(read[key]) if key in read else None for key in ("noise", "offset"))
    channel = Channel(
        address,
        samples.time,
        samples.values,
        ARRAYS[address],
        noise,
        None if lag == "free" else lag,
        quantum_of(samples.values),
        offset,
    )
    return channel, [note.within(address) for note in samples.notes]


def _check_run(test: TankTest, run: TankRun, ambient_pressure: float) -> None:
    """Raise an error if the recorded pressure contradicts the test.

    For example, it is constant at first although the valve is open.
    """
    channel, location = run.pressure, f"{run.place}.{PRESSURE}"
    values, noise = channel.values, max(noise_of(channel.values), 1e-9)
    span, count = float(np.ptp(values)), max(3, values.size // 50)
    begin, end = float(np.median(values[:count])), float(np.median(values[-count:]))
    if span < LEAST_CHANGE * noise:
        raise InputError("tank.still", location, change=span, noise=noise)
    if (end - begin if run.direction == "discharge" else begin - end) > CONTRARY * noise:
        opposite = next(direction for direction in DIRECTIONS if direction != run.direction)
        raise InputError("tank.contrary", location, begin=begin, end=end, direction=run.direction, other=opposite)
    if run.direction == "charge":
        if run.supply_pressure is None:
            raise missing_field(f"{run.place}.supply_pressure", _SUPPLY)
        supply = _pressure(run.supply, ambient_pressure)
        if not is_free(run.supply_pressure) and end > ABOVE_SUPPLY * supply:
            raise InputError("tank.above_supply", location, end=end, supply=supply)
    if test.valve_delay == 0.0 and run.opens == 0.0:
        rest = constant_start(channel, has_lag=test.pressure_lag != 0.0 or channel.lag != 0.0)
        if rest > 0.0:
            raise InputError("tank.rests", location, rest=rest)


def constant_start(channel: Channel, *, has_lag: bool = False) -> float:
    """Return how long a recorded pressure is constant before it begins to change [s].

    The result is 0 if a constant start is not evident. If `has_lag` is True, a sensor lag can also explain a short one.
    """
    values, time = channel.values, channel.time - channel.time[0]
    span, noise = float(np.ptp(values)), max(noise_of(values), 1e-9)
    share = max(6.0 * noise_of(values) / span, 0.002)
    if share > STIRRED:
        return 0.0
    if not has_lag:
        rest = rest_before_opening(time, values, max(noise, quantum_of(values) / 12**0.5))
        if rest > 0.0:
            return rest
    samples = [index_of_change(channel, fraction) for fraction in (share, 4.0 * share, ONSET, COURSE)]
    stirred, later, onset, course = (float(fraction) for fraction in time[samples])
    # The response of a slow sensor starts as a parabola: four times the fraction after twice the time.
    if samples[0] > 3 and later < 1.5 * stirred and stirred > (RESTING + share / (COURSE - ONSET)) * (course - onset):
        return float(time[samples[0] - 1])
    return 0.0


def _pressure(argument: Any, ambient_pressure: float) -> float:
    read = quantity(argument, "Pa", kind="pressure", name="supply_pressure")
    return read.value + (ambient_pressure if read.reference == "gauge" else 0.0)


# The circuit ------------------------------------------------------------------------------------------------------


def _circuit(test: TankTest, run: TankRun, ambient: Ambient) -> BaseCircuit:
    volume = _start_value(run.volume, None)
    if volume is None:
        raise InputError("tank.no_start", "volume", value=run.volume)
    declared = specs(Chamber)["volume"]
    assert isinstance(declared, NumberSpec)
    cubic_metres = read_number("volume", declared, volume).value
    common = {
        "energy": {
            "wall_conductance": COMMON_COEFFICIENT * AREA_FACTOR * cubic_metres ** (2.0 / 3.0),
            "wall_temperature": test.effective_ambient_temperature,
            "wall_heat_capacity": plausible_wall(cubic_metres),
        },
        "polytropic": {"polytropic_exponent": COMMON_EXPONENT},
    }.get(test.thermal, {})
    numbers: dict[str, Any] = {field: _start_value(getattr(test, field), value) for field, value in common.items()}
    if test.initial_temperature is not None or not run.has_temperature:
        argument = _start_value(test.initial_temperature, test.effective_ambient_temperature)
        numbers["initial_temperature"] = test.effective_ambient_temperature if argument is None else argument
    start_pressure = float(run.pressure.values[0])
    tank = Chamber(volume=volume, thermal=test.thermal, initial_pressure=start_pressure, **numbers)
    ports = ("tank", "ambient") if run.direction == "discharge" else ("supply", "tank")
    valve = Orifice(
        from_=ports[0],
        to=ports[1],
        sonic_conductance=_start_value(test.sonic_conductance, _initial_conductance(run, cubic_metres, ambient)),
        critical_ratio=_start_value(test.critical_ratio, COMMON_RATIO),
        subsonic_index=_start_value(test.subsonic_index, 0.5),
        laminar_ratio=NARROW_ZONE,
    )
    parts: dict[str, Part] = {"tank": tank, test.part: valve}
    if run.direction == "charge":
        argument = _start_value(run.supply_temperature, test.effective_ambient_temperature)
        temperature = test.effective_ambient_temperature if argument is None else argument
        parts = {"supply": Reservoir(pressure=run.supply, temperature=temperature)} | parts
    if has_leak(test):
        start = _start_value(test.leak_conductance, LEAK * float(valve.sonic_conductance))  # type: ignore[arg-type]
        parts["leak"] = Orifice(from_="tank", to="ambient", sonic_conductance=start, critical_ratio=COMMON_RATIO)
    return BaseCircuit(parts, ambient=ambient, title=test.title)


def plausible_wall(volume: float) -> float:
    """Return the estimated heat capacity of the wall of a light vessel with a given volume [J/K]."""
    return PLAUSIBLE_WALL * AREA_FACTOR * float(volume ** (2.0 / 3.0))


def _start_value(argument: Any, common: NumberLike) -> NumberLike:
    """Return the value of an argument of a tank test, or its start value if it is free.

    `common` is the start value if the argument does not state one.
    """
    value: NumberLike = argument.get("start", common) if isinstance(argument, Mapping) else argument
    return common if argument == "free" else value


def is_free(argument: Any) -> bool:
    """Return True if an argument of a tank test declares a free parameter."""
    return isinstance(argument, Mapping) or argument == "free"


def has_leak(test: TankTest) -> bool:
    """Return True if a tank test has a leak: a leak conductance that is free or stated and not zero."""
    if test.leak_conductance is None or is_free(test.leak_conductance):
        return test.leak_conductance is not None
    declared = specs(Orifice)["sonic_conductance"]
    assert isinstance(declared, NumberSpec)
    return read_number("leak_conductance", declared, test.leak_conductance).value > 0.0


def _initial_conductance(run: TankRun, volume: float, ambient: Ambient) -> float:
    """Return a start value of the sonic conductance from the recorded pressure [m^3/(s Pa)].

    It is calculated for choked flow and gas at constant temperature.
    """
    channel = run.pressure
    first, last = (index_of_change(channel, share) for share in (ONSET, COURSE))
    first = min(first, max(0, last - 1))  # one sample can reach both fractions
    span = max(float(channel.time[last] - channel.time[first]), 1e-9)
    high, low = float(channel.values[first]), float(channel.values[last])
    temperature = float(ambient.temperature)  # type: ignore[arg-type]
    if run.direction == "discharge":
        rate = math.log(max(high / low, 1.001)) / span
    else:
        rate = abs(low - high) / (span * _pressure(run.supply, float(ambient.pressure)))  # type: ignore[arg-type]
    factor = REFERENCE_DENSITY * AIR_GAS_CONSTANT * math.sqrt(REFERENCE_TEMPERATURE * temperature)
    return volume * rate / factor


def index_of_change(channel: Channel, share: float) -> int:
    """Return the index of the first sample at which a fraction of the total change of a channel is reached.

    `share` is this fraction.
    """
    # With few samples use only the first one: at the third, a tank can be half empty.
    begin = np.median(channel.values[: min(3, 1 + channel.time.size // 50)])
    change = np.abs(channel.values - begin)
    # Even in a steep curve, the onset is at an earlier sample than the end of the window.
    return min(int(np.argmax(change >= share * np.max(change))), channel.time.size - 2 + (share > ONSET))


# Free parameters --------------------------------------------------------------------------------------------------


def _free_parameters(
    test: TankTest, runs: Sequence[TankRun], circuits: Sequence[BaseCircuit]
) -> tuple[FreeParameter, ...]:
    shared = {
        f"{test.part}.sonic_conductance": test.sonic_conductance,
        f"{test.part}.critical_ratio": test.critical_ratio,
        f"{test.part}.subsonic_index": test.subsonic_index,
        "tank.volume": test.volume,
        LEAK_ADDRESS: test.leak_conductance,
    }
    if test.thermal == "energy":
        shared |= {"tank.wall_temperature": test.wall_temperature, "tank.wall_heat_capacity": test.wall_heat_capacity}
    if test.thermal == "polytropic" and is_free(test.polytropic_exponent):
        argument = test.polytropic_exponent if isinstance(test.polytropic_exponent, Mapping) else {}
        shared["tank.polytropic_exponent"] = EXPONENTS | dict(argument)
    parameters = [
        _read_free(address, argument, circuits[0]) for address, argument in shared.items() if is_free(argument)
    ]
    if test.thermal == "energy":
        is_shared = len({(run.direction, str(run.volume)) for run in runs}) == 1
        walls = [test.wall_conductance] * len(runs)
        parameters += _free_by_recording("tank.wall_conductance", walls, runs, circuits, is_shared=is_shared)
    for local in ("pressure", "temperature"):
        supplies = [getattr(run, f"supply_{local}") if run.direction == "charge" else None for run in runs]
        is_shared = all(run.direction == "charge" for run in runs) and len(set(map(str, supplies))) == 1
        parameters += _free_by_recording(f"supply.{local}", supplies, runs, circuits, is_shared=is_shared)
    temperatures = [test.initial_temperature] * len(runs)
    parameters += _free_by_recording("tank.initial_temperature", temperatures, runs, circuits)
    measurements, roles = [run.measurement for run in runs], [run.use for run in runs]
    parameters += recording_parameters(measurements, circuits, roles)
    for run in runs:
        name = run.measurement.name
        if test.valve_delay == "free":
            # The delay starts from the onset of the change.
            latest = run.measurement.duration - run.opens
            onset = run.pressure.time[index_of_change(run.pressure, ONSET)] - run.opens
            delay, address = float(np.clip(onset, 0.0, 0.5 * latest)), f"{test.part}.opening"
            parameters.append(
                FreeParameter(f"{name}.{test.part}.delay", address, "s", delay, 0.0, latest, "dead_time", name)
            )
        # The offset is free if the test requests it, if the recording states its uncertainty, or if the valve closes
        # within the recording.
        argument, sd = test.pressure_offset, run.pressure.offset
        has_reason = argument is not None or sd is not None or run.closes < run.measurement.duration
        if argument != 0.0 and has_reason:
            if argument is None and not sd:
                sd = USUAL_ZERO * float(np.ptp(run.pressure.values))
            parameters.append(offset_parameter(name, run.pressure, NormalPrior(0.0, sd) if sd else None))
    return tuple(parameters)


def _free_by_recording(
    address: str,
    arguments: Sequence[Any],
    runs: Sequence[TankRun],
    circuits: Sequence[BaseCircuit],
    *,
    is_shared: bool = False,
) -> list[FreeParameter]:
    """Return the free parameters of a tank test with a given address.

    `arguments` contains an argument for each recording of the test: the specification of the parameter. If the keyword
    `is_shared` is False, each recording whose argument is free has a free parameter. The name of this parameter begins
    with the name of the recording, unless there is only one recording. If `is_shared` is True, all recordings share the
    argument and the parameter of the first recording.
    """
    if is_shared:
        return [_read_free(address, arguments[0], circuits[0])] if is_free(arguments[0]) else []
    names = [run.measurement.name for run in runs]
    parameters = [
        _read_free(address, argument, c, recording=n)
        for n, argument, c in zip(names, arguments, circuits, strict=True)
        if is_free(argument)
    ]
    return parameters if len(runs) > 1 else [replace(f, name=address) for f in parameters]


def _read_free(address: str, argument: Any, circuit: BaseCircuit, *, recording: str = "") -> FreeParameter:
    table = argument if isinstance(argument, Mapping) else {}
    name = f"{recording}.{address}" if recording else ""
    return read_free(address, table, circuit, recording=recording, name=name, where=address.rpartition(".")[2])

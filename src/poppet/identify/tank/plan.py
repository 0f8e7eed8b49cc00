"""From a tank test to a plan of a fit: the circuits, where the search begins, and what speaks against the data."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.circuit.circuit import Circuit
from poppet.circuit.options import Ambient
from poppet.ground.codes import Note
from poppet.ground.errors import InputError, collect, relocated, suggestion
from poppet.ground.units import quantity
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.file import ROLES, FitPlan, recording_free
from poppet.identify.fit.search import Settings
from poppet.identify.free import Free, read_free
from poppet.laws.iso6358.law import REFERENCE_DENSITY, REFERENCE_TEMPERATURE
from poppet.laws.physics.gas import AIR_GAS_CONSTANT, AIR_ISENTROPIC_EXPONENT
from poppet.parts.chamber import Chamber
from poppet.parts.orifice import Orifice
from poppet.parts.part import Part
from poppet.parts.reservoir import Reservoir
from poppet.series.measured import Channel, InputChannel, Measurement, noise_of, quantum_of, read_measurement
from poppet.series.measured.clocks import LEAST_SAMPLES, ordered
from poppet.series.measured.verdicts import verdicts

if TYPE_CHECKING:
    from poppet.identify.tank.tank import TankTest

DIRECTIONS = ("discharge", "charge")
THERMAL = ("energy", "isothermal", "polytropic")
OWN = ("direction", "volume", "supply_pressure", "supply_temperature", "opens", "closes", "use")
"""What a recording may state for itself; all else in its table is read as in a fit file."""
PRESSURE, TEMPERATURE = "tank.pressure", "tank.temperature"
ARRAYS = {PRESSURE: "Pa", TEMPERATURE: "K"}
ARRAY_FIELDS = ("values", "noise", "lag")

COMMON_RATIO = 0.3
"""Where the search for b begins: the middle of what catalogues list."""
COMMON_EXPONENT, EXPONENTS = 1.2, {"min": 1.0, "max": AIR_ISENTROPIC_EXPONENT}
"""Where the search for n begins, and its bounds unless others are given: isothermal and adiabatic."""
AREA_FACTOR, COMMON_COEFFICIENT = 6.0, 8.0
"""Where the search for h A begins: the surface of a cube of the volume, and 8 W/(m^2 K), free convection in air."""
ONSET, COURSE = 0.02, 0.4
"""Shares of the whole change between which the first guess of C is made; the first marks the start as well."""
LEAST_CHANGE, CONTRARY = 20.0, 5.0
"""In sigmas of the noise: a change that is too small to fit, and one that has the wrong direction."""
ABOVE_SUPPLY = 1.02
"""Of the supply's pressure; a tank that is fuller than that does not fill from it."""
LARGEST_OFFSET = 0.1
"""Of the range of a recording: bounds of a free offset of the pressure."""


@dataclass(frozen=True)
class _Run:
    """One recording with what holds for it."""

    measurement: Measurement
    direction: str
    volume: Any
    supply_pressure: Any
    supply_temperature: Any
    opens: float
    closes: float
    role: str

    @property
    def pressure(self) -> Channel:
        return next(channel for channel in self.measurement.channels if channel.address == PRESSURE)

    @property
    def where(self) -> str:
        return f"recordings.{self.measurement.name}"


def tank_plan(test: TankTest) -> FitPlan:
    """Read the recordings of a tank test, check their course and build the circuits."""
    ambient = _ambient(test)
    pressure = float(ambient.pressure)  # type: ignore[arg-type]
    runs = _each(test.recordings.items(), lambda item: _run(test, item[0], item[1], pressure))
    _each(runs, lambda run: _check_course(run, ambient))
    circuits = [_circuit(test, run, ambient) for run in runs]
    runs = [replace(run, measurement=_completed(test, run)) for run in runs]
    free = _free(test, runs, circuits)
    every = [Experiment(c, run.measurement, free) for c, run in zip(circuits, runs, strict=True)]
    fitted, held = (tuple(e for e, run in zip(every, runs, strict=True) if run.role == role) for role in ROLES)
    if not fitted:
        raise InputError('use = "validation"', "holds for every recording.", "Leave one to fit.", address="recordings")
    settings = Settings(test.loss, test.starts, test.seed)
    return FitPlan(fitted, free, held, settings, test.title)


def _ambient(test: TankTest) -> Ambient:
    try:
        return Ambient(pressure=test.ambient_pressure, temperature=test.ambient_temperature)
    except InputError as error:
        raise relocated(error, "ambient_{}".format) from None


def _each(items: Any, action: Callable[[Any], Any]) -> list[Any]:
    """The results of an action on every item, or all its mistakes at once."""
    found, problems = [], []
    for item in items:
        try:
            found.append(action(item))
        except InputError as error:
            problems.append(error)
    collect(problems)
    return found


# Recordings -------------------------------------------------------------------------------------------------------


def _run(test: TankTest, name: str, given: Any, ambient_pressure: float) -> _Run:
    where = f"recordings.{name}"
    if not isinstance(given, Mapping):
        raise InputError(where, "is not a table.", "Give file, time and tank.pressure.", address=where)
    own = {key: given[key] for key in OWN if key in given}
    rest = {key: value for key, value in given.items() if key not in OWN}
    problems = [
        InputError(
            f"{where}.{key} = {own[key]!r}", "is unknown.", suggestion(str(own[key]), known), address=f"{where}.{key}"
        )
        for key, known in (("direction", DIRECTIONS), ("use", ROLES))
        if key in own and own[key] not in known
    ]
    if PRESSURE not in rest:
        cure = 'Add "tank.pressure" = { column = "p", unit = "bar" }.'
        problems.append(InputError(f"{where}.{PRESSURE}", "is missing.", cure, address=where))
    collect(problems)
    has_arrays = not isinstance(rest.get("time"), str | int | Mapping | None)
    measurement = (
        _from_arrays(name, rest, ambient_pressure)
        if has_arrays
        else read_measurement(name, rest, Path(test.folder), ambient_pressure=ambient_pressure)
    )
    opens, closes = (
        quantity(own[key], "s", name=f"{where}.{key}").value if key in own else default
        for key, default in (("opens", 0.0), ("closes", math.inf))
    )
    if not 0.0 <= opens < closes:
        raise InputError(f"{where}.closes = {closes:g} s", f"is not after opens = {opens:g} s.", "Correct one of them.")
    values = {key: own.get(key, getattr(test, key)) for key in ("direction", "volume", *OWN[2:4])}
    return _Run(measurement, opens=opens, closes=closes, role=own.get("use", "fit"), **values)


def _from_arrays(name: str, table: Mapping[str, Any], ambient_pressure: float) -> Measurement:
    where = f"recordings.{name}"
    unknown = [key for key in table if key not in ("time", "start", *ARRAYS)]
    if unknown:
        cure = suggestion(unknown[0], ("time", "start", *ARRAYS))
        raise InputError(f"{where}.{unknown[0]}", "is not a field of a recording in arrays.", cure, address=where)
    notes: list[Note] = []
    channels = tuple(_channel(where, address, table, notes) for address in ARRAYS if address in table)
    found = tuple(verdicts(channels, (), ambient_pressure, frozenset()))
    duration = max(float(channel.time[-1]) for channel in channels)
    start = dict(table.get("start", {}))
    return Measurement(name, channels, (), start, ambient_pressure, tuple(notes), found, duration)


def _channel(where: str, address: str, table: Mapping[str, Any], notes: list[Note]) -> Channel:
    given = table[address] if isinstance(table[address], Mapping) else {"values": table[address]}
    unknown = [key for key in given if key not in ARRAY_FIELDS]
    if unknown:
        raise InputError(f"{where}.{address}.{unknown[0]}", "is unknown.", suggestion(unknown[0], ARRAY_FIELDS))
    time, values = (np.asarray(each, dtype=np.float64) for each in (table["time"], given["values"]))
    if time.ndim != 1 or time.shape != values.shape or time.size < LEAST_SAMPLES:
        reason = f"has the shape {values.shape}, its time {time.shape}."
        raise InputError(f"{where}.{address}", reason, f"Give two arrays of the same {LEAST_SAMPLES} or more samples.")
    samples = ordered(time - float(np.nanmin(time)), values)
    notes += [note.within(address) for note in samples.notes]
    noise = given.get("noise")
    lag = None if given.get("lag") == "free" else quantity(given.get("lag", 0.0), "s", name=f"{where}.lag").value
    return Channel(
        address,
        samples.time,
        samples.values,
        ARRAYS[address],
        None if noise is None else float(noise),
        lag,
        quantum_of(samples.values),
    )


def _check_course(run: _Run, ambient: Ambient) -> None:
    """Refuse what is no charge or discharge, before a fit makes numbers of it."""
    values, noise = run.pressure.values, max(noise_of(run.pressure.values), 1e-9)
    count = max(3, values.size // 50)
    begin, end = float(np.median(values[:count])), float(np.median(values[-count:]))
    shown, address = f"{run.where}.{PRESSURE}", run.where
    if np.ptp(values) < LEAST_CHANGE * noise:
        raise InputError(
            shown,
            f"hardly changes: by {np.ptp(values):.4g} Pa, with a noise of {noise:.3g} Pa.",
            "Name the column of the tank's pressure, or record while the tank fills or empties.",
            address=address,
        )
    change = end - begin if run.direction == "discharge" else begin - end
    if change > CONTRARY * noise:
        other = "charge" if run.direction == "discharge" else "discharge"
        raise InputError(
            shown,
            f"goes from {begin:.6g} Pa to {end:.6g} Pa, which is no {run.direction}.",
            f'Write direction = "{other}", or name another column.',
            address=address,
        )
    if run.direction == "charge":
        _check_supply(run, end, float(ambient.pressure))  # type: ignore[arg-type]


def _check_supply(run: _Run, end: float, ambient_pressure: float) -> None:
    if run.supply_pressure is None:
        cure = 'Write supply_pressure = "7 bar".'
        raise InputError("supply_pressure", "is missing: a charge comes from a supply.", cure, address=run.where)
    supply = _pressure(run.supply_pressure, ambient_pressure)
    if end > ABOVE_SUPPLY * supply:
        raise InputError(
            f"{run.where}.{PRESSURE}",
            f"ends at {end:.6g} Pa, above the supply of {supply:.6g} Pa.",
            "Check which of the two is gauge, and the unit.",
            address=run.where,
        )


def _pressure(given: Any, ambient_pressure: float) -> float:
    read = quantity(given, "Pa", kind="pressure", name="supply_pressure")
    return read.value + (ambient_pressure if read.reference == "gauge" else 0.0)


# The circuit ------------------------------------------------------------------------------------------------------


def _circuit(test: TankTest, run: _Run, ambient: Ambient) -> Circuit:
    volume = _begin(run.volume, None)
    if volume is None:
        cure = 'Write volume = { start = "20 l" }, say.'
        raise InputError(f"volume = {run.volume!r}", "gives no place to begin.", cure, address="volume")
    numbers: dict[str, Any] = {"volume": volume, "thermal": test.thermal}
    cubic_metres = quantity(volume, "m^3", name="volume").value
    if test.thermal == "energy":
        common = COMMON_COEFFICIENT * AREA_FACTOR * cubic_metres ** (2.0 / 3.0)
        numbers["wall_conductance"] = _begin(test.wall_conductance, common)
        numbers["wall_temperature"] = test.wall_temperature
    if test.thermal == "polytropic":
        numbers["polytropic_exponent"] = _begin(test.polytropic_exponent, COMMON_EXPONENT)
    if test.initial_temperature is not None or TEMPERATURE not in _addresses(run):
        given = test.ambient_temperature if test.initial_temperature is None else test.initial_temperature
        numbers["initial_temperature"] = given
    tank = Chamber(initial_pressure=float(run.pressure.values[0]), **numbers)
    ports = ("tank", "ambient") if run.direction == "discharge" else ("supply", "tank")
    valve = Orifice(
        from_=ports[0],
        to=ports[1],
        sonic_conductance=_begin(test.sonic_conductance, _conductance(test, run, cubic_metres, ambient)),
        critical_ratio=_begin(test.critical_ratio, COMMON_RATIO),
        subsonic_index=_begin(test.subsonic_index, 0.5),
    )
    parts: dict[str, Part] = {"tank": tank, test.part: valve}
    if run.direction == "charge":
        temperature = test.ambient_temperature if run.supply_temperature is None else run.supply_temperature
        parts = {"supply": Reservoir(pressure=run.supply_pressure, temperature=temperature)} | parts
    return Circuit(parts, ambient=ambient, title=test.title)


def _begin(given: Any, common: Any) -> Any:
    """The value of a number, or where the search for it begins."""
    if isinstance(given, Mapping):
        return given.get("start", common)
    return common if given == "free" else given


def _is_free(given: Any) -> bool:
    return isinstance(given, Mapping) or given == "free"


def _addresses(run: _Run) -> list[str]:
    return [channel.address for channel in run.measurement.channels]


def _conductance(test: TankTest, run: _Run, volume: float, ambient: Ambient) -> float:
    """C as if the flow were choked and the gas isothermal; a place to begin."""
    channel = run.pressure
    before, after = (_when(channel, share) for share in (ONSET, COURSE))
    span = max(float(channel.time[after] - channel.time[before]), 1e-9)
    high, low = float(channel.values[before]), float(channel.values[after])
    temperature = float(ambient.temperature)  # type: ignore[arg-type]
    if run.direction == "discharge":
        rate = math.log(max(high / low, 1.001)) / span
    else:
        rate = abs(low - high) / (span * _pressure(run.supply_pressure, float(ambient.pressure)))  # type: ignore[arg-type]
    factor = REFERENCE_DENSITY * AIR_GAS_CONSTANT * math.sqrt(REFERENCE_TEMPERATURE * temperature)
    return volume * rate / factor


def _when(channel: Channel, share: float) -> int:
    """First sample at which a share of the whole change is done."""
    moved = np.abs(channel.values - np.median(channel.values[:3]))
    return min(int(np.argmax(moved >= share * np.max(moved))), channel.time.size - 2 + (share > ONSET))


def _completed(test: TankTest, run: _Run) -> Measurement:
    """The recording with its start values, and with the command of the valve where it is not open throughout."""
    start: dict[str, Any] = {"tank.initial_pressure": "free"}
    if test.initial_temperature is None and TEMPERATURE in _addresses(run):
        start["tank.initial_temperature"] = "first"
    measurement = replace(run.measurement, start={**start, **run.measurement.start})
    if test.valve_delay == 0.0 and run.opens == 0.0 and run.closes == math.inf:
        return measurement
    delay = 0.0 if test.valve_delay == "free" else quantity(test.valve_delay, "s", name="valve_delay").value
    edge = 1e-6 * measurement.duration
    times, values = [run.opens - edge, run.opens], [0.0, 1.0]
    if run.closes < math.inf:
        times, values = [*times, run.closes - edge, run.closes], [*values, 1.0, 0.0]
    # What acts late is, for an input, a record that is early.
    command = InputChannel(f"{test.part}.opening", np.array(times), np.array(values), "1", -delay)
    return replace(measurement, inputs=(*measurement.inputs, command))


# What is free -----------------------------------------------------------------------------------------------------


def _free(test: TankTest, runs: list[_Run], circuits: list[Circuit]) -> tuple[Free, ...]:
    shared = {
        f"{test.part}.sonic_conductance": test.sonic_conductance,
        f"{test.part}.critical_ratio": test.critical_ratio,
        f"{test.part}.subsonic_index": test.subsonic_index,
        "tank.volume": test.volume,
    }
    if test.thermal == "polytropic" and _is_free(test.polytropic_exponent):
        given = test.polytropic_exponent if isinstance(test.polytropic_exponent, Mapping) else {}
        shared["tank.polytropic_exponent"] = EXPONENTS | dict(given)
    found = [_read(address, given, circuits[0]) for address, given in shared.items() if _is_free(given)]
    if test.thermal == "energy" and _is_free(test.wall_conductance):
        found += _walls(test.wall_conductance, runs, circuits)
    measurements, roles = [run.measurement for run in runs], [run.role for run in runs]
    found += recording_free(measurements, circuits, roles)
    for run in runs:
        name = run.measurement.name
        if test.valve_delay == "free":
            found.append(_delay(f"{name}.{test.part}.delay", f"{test.part}.opening", run))
        if test.pressure_offset == "free":
            most = LARGEST_OFFSET * float(np.ptp(run.pressure.values))
            found.append(Free(f"{name}.{PRESSURE}.offset", PRESSURE, "Pa", 0.0, -most, most, "offset", name))
    return tuple(found)


def _walls(given: Any, runs: list[_Run], circuits: list[Circuit]) -> list[Free]:
    address = "tank.wall_conductance"
    if len({(run.direction, str(run.volume)) for run in runs}) == 1:
        return [_read(address, given, circuits[0])]
    names = [run.measurement.name for run in runs]
    return [_read(address, given, c, recording=n) for n, c in zip(names, circuits, strict=True)]


def _read(address: str, given: Any, circuit: Circuit, *, recording: str = "") -> Free:
    table = given if isinstance(given, Mapping) else {}
    name = f"{recording}.{address}" if recording else ""
    try:
        return read_free(address, table, circuit, recording=recording, name=name)
    except InputError as error:
        error.address = address.rpartition(".")[2]
        raise


def _delay(name: str, address: str, run: _Run) -> Free:
    """Begins where the pressure begins to move."""
    latest = run.measurement.duration - run.opens
    begin = float(np.clip(run.pressure.time[_when(run.pressure, ONSET)] - run.opens, 0.0, 0.5 * latest))
    return Free(name, address, "s", begin, 0.0, latest, "dead_time", run.measurement.name)

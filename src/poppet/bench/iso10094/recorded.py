"""Recordings of a real valve: which file is which test, and which column which channel."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from poppet.bench.iso10094.definitions import TESTS
from poppet.bench.iso10094.ranges import pressure, pressure_range, setpoint_scale
from poppet.bench.iso10094.scale import FloatArray, Record, Scale
from poppet.ground.errors import InputError, collect, suggestion
from poppet.ground.units import quantity
from poppet.series.measured import read_measurement
from poppet.series.measured.measurement import Channel, Measurement

TOP_LEVEL = ("title", "full_scale", "setpoint_range", "rated_flow", "ambient_pressure", "supply_pressure", "recordings")
OF_RECORDING = ("test", "volume", "setpoint")
"""What a recording has beside the fields of those of a fit file."""
UNUSED = ("inputs", "start")
BEYOND = 2.0
"""How far a setpoint may leave its range before a word is said [% FS]."""
SETPOINT, OUTLET, SUPPLY = "valve.setpoint", "outlet.pressure", "supply.pressure"
FLOW, CONSUMPTION = "outlet.mass_flow_rate", "supply.mass_flow_rate"
CHANNELS: Mapping[str, str] = {
    SETPOINT: "the setpoint, in any unit of its range",
    OUTLET: "the outlet pressure",
    SUPPLY: "the supply pressure",
    FLOW: "the mass flow rate out of the outlet, negative where gas is fed in",
    CONSUMPTION: "the mass flow rate from the supply into the valve",
}
"""Channels of a recording and what they are."""
NEEDED: Mapping[str, tuple[str, ...]] = {"flow": (FLOW,), "supply": (SUPPLY,), "leakage": (CONSUMPTION,)}
"""Channels that a test needs beside setpoint and outlet pressure."""
HELD = ("flow", "supply", "leakage")
"""Tests at a constant setpoint, which may be written instead of recorded."""
DEFAULT_AMBIENT = 101325.0


@dataclass(frozen=True)
class Recorded:
    """Recordings of a valve, read.

    Parameters
    ----------
    title : str
        For people.
    scale : Scale
        Ranges.
    records : mapping
        Test to its recordings.
    rated_flow : float
        Not a number where it was not given [kg/s].
    notes : tuple of str
        What was guessed, merged or looks wrong.
    conditions : mapping
        For the result.
    """

    title: str
    scale: Scale
    records: Mapping[str, list[Record]]
    rated_flow: float
    notes: tuple[str, ...]
    conditions: Mapping[str, Any]


def recorded(
    data: Mapping[str, Any], path: Path, *, full_scale: str | None = None, rated_flow: float = math.nan
) -> Recorded:
    """Read the tables of a file of recordings."""
    _check_top(data, full_scale)
    ambient = _ambient(data)
    ends = pressure_range(full_scale if full_scale is not None else data["full_scale"], ambient)
    scale = setpoint_scale(data.get("setpoint_range"), ends, ambient)
    if not math.isfinite(rated_flow) and "rated_flow" in data:
        rated_flow = quantity(data["rated_flow"], "kg/s", kind="mass_flow", name="rated_flow").value
    records: dict[str, list[Record]] = {test: [] for test in TESTS}
    problems: list[InputError] = []
    notes: list[str] = []
    for name, table in data["recordings"].items():
        try:
            test, record, found = _record(name, table, path.parent, ambient, scale)
        except InputError as error:
            problems.append(error)
            continue
        records[test].append(record)
        notes += [f"{name}: {sentence}" for sentence in found]
    collect(problems)
    conditions: dict[str, Any] = {
        "ambient_pressure": ambient,
        "recordings": {test: [record.name for record in found] for test, found in records.items() if found},
    }
    if "supply_pressure" in data:
        conditions["supply_pressure"] = pressure(data["supply_pressure"], ambient, "supply_pressure")
    volumes = sorted({r.volume for found in records.values() for r in found if math.isfinite(r.volume)})
    if volumes:
        conditions["volumes"] = volumes
    return Recorded(str(data.get("title", path.stem)), scale, records, rated_flow, tuple(notes), conditions)


def _check_top(data: Mapping[str, Any], full_scale: str | None) -> None:
    problems = [
        InputError(key, "is not a part of a file of recordings.", suggestion(key, TOP_LEVEL), address=key)
        for key in data
        if key not in TOP_LEVEL
    ]
    if not isinstance(data.get("recordings"), Mapping) or not data["recordings"]:
        cure = "Write [recordings.NAME] with test, file and channels."
        problems.append(
            InputError("recordings is missing:", "there is nothing to evaluate.", cure, address="recordings")
        )
    if full_scale is None and "full_scale" not in data:
        cure = 'Write full_scale = "6 bar g", the outlet pressure at full setpoint.'
        problems.append(InputError("full_scale is missing:", "figures are parts of it.", cure, address="full_scale"))
    collect(problems)


def _ambient(data: Mapping[str, Any]) -> float:
    given = data.get("ambient_pressure", DEFAULT_AMBIENT)
    read = quantity(given, "Pa", kind="pressure", name="ambient_pressure")
    if read.reference == "gauge" or read.value <= 0.0:
        cure = 'Write the barometer\'s reading: "1.013 bar".'
        reason = "is not an absolute pressure above zero."
        raise InputError(f"ambient_pressure = {given!r}", reason, cure, address="ambient_pressure")
    return read.value


def _record(name: str, table: Any, folder: Path, ambient: float, scale: Scale) -> tuple[str, Record, list[str]]:
    """One recording with its test, and what a reader has to know of it."""
    where = f"recordings.{name}"
    if not isinstance(table, Mapping):
        raise InputError(
            f"{where} = {table!r}", "is not a table.", f"Write [{where}] and fields below it.", address=where
        )
    own = {key: table[key] for key in OF_RECORDING if key in table}
    test = own.get("test")
    problems = [
        InputError(f"{where}.{key}", "has no meaning on a bench.", "Leave it out.", address=f"{where}.{key}")
        for key in UNUSED
        if key in table
    ]
    if test not in TESTS:
        given = f"{where}.test = {test!r}" if test is not None else f"{where}.test is missing:"
        reason = "is unknown." if test is not None else "nothing says what was done."
        problems.append(InputError(given, reason, suggestion(str(test), TESTS), address=f"{where}.test"))
    problems += _channel_mistakes(where, table, str(test), "setpoint" in own)
    collect(problems)
    rest = {key: value for key, value in table.items() if key not in OF_RECORDING}
    measurement = read_measurement(name, rest, folder, ambient_pressure=ambient)
    # A command rests at its ends: what would be a clipped sensor is a step.
    findings = [each for each in measurement.findings if (each.code, each.address) != ("suspicion.clipped", SETPOINT)]
    notes = [*map(str, (*measurement.notes, *findings)), *_lags(measurement)]
    record = _joined(name, str(test), measurement, own, where, ambient, scale)
    return str(test), record, notes + _beyond(record, scale)


def _channel_mistakes(where: str, table: Mapping[str, Any], test: str, is_held: bool) -> list[InputError]:
    problems = [
        InputError(f"{where}.{key}", "is no channel of the bench.", suggestion(key, CHANNELS), address=f"{where}.{key}")
        for key in table
        if "." in key and key not in CHANNELS
    ]
    if is_held and (SETPOINT in table or test not in HELD):
        cure = f'Record "{SETPOINT}" instead.' if test not in HELD else "Leave one of them out."
        reason = "is not constant in this test." if test not in HELD else f'stands beside the channel "{SETPOINT}".'
        problems.append(InputError(f"{where}.setpoint", reason, cure, address=f"{where}.setpoint"))
    needed = (OUTLET, *(() if is_held else (SETPOINT,)), *NEEDED.get(test, ()))
    problems += [
        InputError(
            f'{where}: "{key}" is missing:',
            f"the test {test} needs {CHANNELS[key]}.",
            f'Add "{key}" = {{ column = "...", unit = "..." }}.',
            address=where,
        )
        for key in needed
        if key not in table
    ]
    return problems


def _beyond(record: Record, scale: Scale) -> list[str]:
    """A setpoint far outside its range: the range is wrong, or the column, or its unit."""
    low, high = (float(scale.setpoint_percent(end)) for end in (record.setpoint.min(), record.setpoint.max()))
    if low >= -BEYOND and high <= 100.0 + BEYOND:
        return []
    return [f"the setpoint goes from {low:.4g} to {high:.4g} % FS, beyond its range; check setpoint_range and units."]


def _lags(measurement: Measurement) -> list[str]:
    return [
        f"{channel.address}: the lag of its sensor is not taken out of the figures."
        for channel in measurement.channels
        if channel.lag != 0.0
    ]


def _joined(
    name: str, test: str, measurement: Measurement, own: Mapping[str, Any], where: str, ambient: float, scale: Scale
) -> Record:
    """All channels on the clock of the outlet pressure, while all of them were recorded."""
    channels = {channel.address: channel for channel in measurement.channels}
    begin = max(float(channel.time[0]) for channel in channels.values())
    end = min(float(channel.time[-1]) for channel in channels.values())
    clock = channels[OUTLET].time
    clock = clock[(clock >= begin) & (clock <= end)]
    if clock.size < 3:
        raise InputError(
            where, "has channels that were not recorded at the same time.", "Check their times.", address=where
        )
    setpoint = _on(clock, channels.get(SETPOINT))
    if SETPOINT in channels and channels[SETPOINT].unit != scale.setpoint_unit:
        raise InputError(
            f'{where}: "{SETPOINT}" in {channels[SETPOINT].unit}',
            f"does not fit a setpoint range in {scale.setpoint_unit}.",
            'Write setpoint_range = ["0 V", "10 V"] at the top of the file, say.',
            address=f"{where}.{SETPOINT}",
        )
    if "setpoint" in own:
        setpoint = np.full(clock.size, _held_setpoint(own["setpoint"], f"{where}.setpoint", ambient, scale))
    volume = math.nan
    if "volume" in own:
        volume = quantity(own["volume"], "m^3", name=f"{where}.volume").value
    supply, flow, consumption = (_on(clock, channels.get(key)) for key in (SUPPLY, FLOW, CONSUMPTION))
    outlet = _on(clock, channels[OUTLET])
    return Record(name, test, clock - clock[0], setpoint, outlet, supply, flow, consumption, volume)


def _on(clock: FloatArray, channel: Channel | None) -> FloatArray:
    """A channel on another clock; empty where it was not recorded."""
    return np.zeros(0) if channel is None else np.interp(clock, channel.time, channel.values)


def _held_setpoint(given: Any, name: str, ambient: float, scale: Scale) -> float:
    if scale.setpoint_unit == "Pa":
        return pressure(given, ambient, name)
    return quantity(given, scale.setpoint_unit, name=name).value

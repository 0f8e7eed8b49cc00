"""Recordings of a real valve, with the assignment of columns to channels and tests."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from poppet.bench.iso10094.bench_result import TESTS
from poppet.bench.iso10094.plausibility import suspicion_notes, without_spikes
from poppet.bench.iso10094.scale import FloatArray, Mask, Record, Scale, read_pressure_range, setpoint_scale
from poppet.bench.iso10094.shapes import constant_sections
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, raise_errors
from poppet.core.message_format import sentence
from poppet.core.tables import Field, missing_field, read_fields
from poppet.core.units import quantity
from poppet.timeseries.measurements import read_measurement
from poppet.timeseries.measurements.measurement import Measurement, noise_of, quantum_of
from poppet.timeseries.measurements.verdicts import cuts_a_peak, is_stuck_at

TOP_LEVEL = {
    "title": Field(type="text"),
    "full_scale": Field(is_required=True, meaning="outlet pressure at full setpoint", example='full_scale = "6 bar g"'),
    **dict.fromkeys(("setpoint_range", "ambient_pressure"), Field()),
    "supply_pressure": Field(unit="Pa", kind="pressure", low=0.0),
    "rated_flow": Field(unit="kg/s", kind="mass_flow", default=math.nan),
    "recordings": Field(
        type="table", is_required=True, meaning="list of recordings",
        example="[recordings.NAME] with test, file and channels",
    ),
}  # fmt: skip
OF_RECORDING = {
    "test": Field(choices=tuple(TESTS), is_required=True, meaning="test", example=f'test = "{next(iter(TESTS))}"'),
    "volume": Field(unit="m^3"),
    "setpoint": Field(),  # in the unit of the setpoint range
}
"""Fields of a recording in addition to those of a fit file."""
UNUSED = ("inputs", "start")
BEYOND = 2.0  # deviation of a setpoint from its range, above which a note is given [% FS]
OVERSHOT = 30.0  # deviation of the outlet from full scale, above which a note is given [% FS]
AT_REST = 0.2  # change of the outlet within a hold relative to the change between holds, below which it is at rest
SERIES: Mapping[str, str] = {
    "setpoint": "valve.setpoint",
    "outlet": "outlet.pressure",
    "supply": "supply.pressure",
    "flow": "outlet.mass_flow_rate",
    "consumption": "supply.mass_flow_rate",
}
"""Mapping from each series of a record to the address of its channel in the file."""
SETPOINT, OUTLET = SERIES["setpoint"], SERIES["outlet"]
# Channels of a recording with their meaning.
CHANNELS: Mapping[str, str] = {channel: sentence(f"recordings.channel.{key}", {}) for key, channel in SERIES.items()}
DEFAULT_AMBIENT = 101325.0


@dataclass(frozen=True)
class ValveRecordings:
    """Recordings of a real valve, read from files and grouped by test."""

    title: str
    scale: Scale
    records: Mapping[str, list[Record]]  # mapping from test to records
    rated_flow: float  # NaN if not specified [kg/s]
    notes: tuple[Note, ...]  # guesses and suspicions
    conditions: Mapping[str, Any]


def read_valve_recordings(
    data: Mapping[str, Any], path: Path, *, full_scale: str | None = None, rated_flow: float = math.nan
) -> ValveRecordings:
    """Read all recordings that are listed in a recordings file.

    `data` is the content of the file, and `path` its path. The keywords `full_scale` and `rated_flow` [kg/s] replace
    the values in the file.
    """
    raw = data.get("ambient_pressure", DEFAULT_AMBIENT)
    read = quantity(raw, "Pa", kind="pressure", name="ambient_pressure")
    if read.reference == "gauge" or read.value <= 0.0:
        raise InputError("recordings.ambient", "ambient_pressure", given=raw)
    ambient = read.value
    with ErrorCollector() as errors:
        optional = {"full_scale": Field()} if full_scale is not None else {}
        fields = TOP_LEVEL | optional
        data = read_fields(errors, data, fields, table="file of recordings", ambient_pressure=ambient)
    ends = read_pressure_range(full_scale if full_scale is not None else data["full_scale"], ambient)
    scale = setpoint_scale(data.get("setpoint_range"), ends, ambient)
    if not math.isfinite(rated_flow):
        rated_flow = data["rated_flow"]
    records: dict[str, list[Record]] = {test: [] for test in TESTS}
    problems: list[InputError] = []
    notes: list[Note] = []
    for name, table in data["recordings"].items():
        try:
            record, found_notes = _read_recording(name, table, path.parent, ambient, scale)
        except InputError as error:
            problems.append(error)
            continue
        records[record.test].append(record)
        notes += found_notes
    raise_errors(problems)
    conditions: dict[str, Any] = {
        "ambient_pressure": ambient,
        "recordings": {test: [record.name for record in group] for test, group in records.items() if group},
    }
    conditions |= {key: data[key] for key in ("supply_pressure",) if key in data}
    volumes = sorted({r.volume for group in records.values() for r in group if math.isfinite(r.volume)})
    if volumes:
        conditions["volumes"] = volumes
    return ValveRecordings(str(data.get("title", path.stem)), scale, records, rated_flow, tuple(notes), conditions)


def _read_recording(name: str, table: Any, folder: Path, ambient: float, scale: Scale) -> tuple[Record, list[Note]]:
    """Read one recording, and return its record and notes.

    `table` is the TOML table that describes the recording, `folder` the folder of its data file, and `ambient` the
    ambient pressure [Pa].
    """
    address = f"recordings.{name}"
    if not isinstance(table, Mapping):
        raise InputError("fields.no_table", address, value=table)
    setpoint = Field(unit=scale.setpoint_unit)
    if scale.setpoint_unit == "Pa":
        setpoint = Field(unit="Pa", kind="pressure", low=0.0)
    with ErrorCollector() as errors:
        raw = {key: table[key] for key in OF_RECORDING if key in table}
        fields = read_fields(errors, raw, OF_RECORDING | {"setpoint": setpoint}, address, ambient_pressure=ambient)
        for key in table:
            if key in UNUSED:
                errors.add("recordings.unused", f"{address}.{key}")
            elif "." in key and key not in CHANNELS:
                near = NameSuggestion(key, CHANNELS)
                errors.add("names.unknown", f"{address}.{key}", meaning="a channel of the bench", suggestion=near)
        # Only tests at a constant setpoint require an additional series.
        needs = TESTS[fields["test"]].needs if "test" in fields else ""
        if "setpoint" in raw and not needs:
            errors.add("recordings.setpoint_moves", f"{address}.setpoint", channel=SETPOINT)
        elif "setpoint" in raw and SETPOINT in table:
            errors.add("recordings.setpoint_twice", f"{address}.setpoint", channel=SETPOINT)
        for series in ("outlet", *(() if "setpoint" in raw else ("setpoint",)), *((needs,) if needs else ())):
            if (channel := SERIES[series]) not in table:
                example = f'"{channel}" = {{ column = "...", unit = "..." }}'
                field = Field(meaning=CHANNELS[channel].removeprefix("The ").removesuffix("."), example=example)
                errors.extend([missing_field(f"{address}.{channel}", field)])
    own_names = tuple(OF_RECORDING)
    other_fields = {key: value for key, value in table.items() if key not in own_names}
    measurement = read_measurement(name, other_fields, folder, ambient_pressure=ambient, other_fields=own_names)
    record, n_spikes = _record_of_measurement(name, measurement, fields, address, scale)
    # Clipping is checked here with the meaning of the channels: an outlet follows the setpoint, a command has limits.
    findings = [finding for finding in measurement.findings if finding.code != "suspicion.clipped"]
    # If the outlet is at rest while the setpoint is constant, the steps of the setpoint are commands and not the
    # resolution of an analogue-to-digital converter.
    x, y = scale.percents(record)
    holds = constant_sections(x)
    thirds = [(hold, max(1, (hold.stop - hold.start) // 3)) for hold in holds]
    ends = np.array([[np.mean(y[hold][-third:]), np.mean(y[hold][third:-third])] for hold, third in thirds])
    if len(holds) > 1:
        inside, between = np.abs(ends[:, 0] - ends[:, 1]), np.abs(np.diff(ends[:, 0]))
        if np.median(inside) < AT_REST * np.median(between):
            findings = [note for note in findings if (note.code, note.address) != ("suspicion.coarse", SETPOINT)]
    notes = [note.within(name) for note in (*measurement.notes, *findings)]
    for series, mask in record.clipped.items():
        notes.append(Note("recordings.clipped", f"{name}.{SERIES[series]}", samples=int(mask.sum())))
    if n_spikes:
        notes.append(Note("recordings.spikes", f"{name}.{OUTLET}", samples=n_spikes))
    notes += suspicion_notes(record, scale)
    lagging = [channel.address for channel in measurement.channels if channel.lag != 0.0]
    notes += [Note("recordings.lag", name, channel=channel) for channel in lagging]
    low, high = (float(scale.setpoint_percent(end)) for end in (record.setpoint.min(), record.setpoint.max()))
    if low < -BEYOND or high > 100.0 + BEYOND:  # possible causes: wrong range, column or unit
        notes.append(Note("recordings.beyond", name, low=low, high=high))
    low, high = (float(scale.percent(end)) for end in (record.outlet.min(), record.outlet.max()))
    if low < -OVERSHOT or high > 100.0 + OVERSHOT:
        peak, full = float(record.outlet.max()) - ambient, scale.pressure_high - ambient
        notes.append(Note("recordings.outlet_beyond", name, low=low, high=high, peak=peak, full=full))
    return record, notes


def _record_of_measurement(
    name: str, measurement: Measurement, fields: Mapping[str, Any], address: str, scale: Scale
) -> tuple[Record, int]:
    """Return the channels of a measurement as a record, and the number of replaced spikes.

    All channels are interpolated at the sample instants of the outlet pressure, within the time range that all channels
    cover. `fields` contains the fields of the recording that are not channels, for example the outlet volume.
    """
    channels = {channel.address: channel for channel in measurement.channels}
    begin = max(float(channel.time[0]) for channel in channels.values())
    end = min(float(channel.time[-1]) for channel in channels.values())
    clock = channels[OUTLET].time
    clock = clock[(clock >= begin) & (clock <= end)]
    if clock.size < 3:
        raise InputError("recordings.apart", address)
    series = {key: np.zeros(0) for key in SERIES}  # empty if not recorded
    for key, channel in ((key, channels[name]) for key, name in SERIES.items() if name in channels):
        series[key] = np.interp(clock, channel.time, channel.values)
    unit = channels[SETPOINT].unit if SETPOINT in channels else scale.setpoint_unit
    if unit != scale.setpoint_unit:
        raise InputError("recordings.unit", f"{address}.{SETPOINT}", unit=unit, wanted=scale.setpoint_unit)
    if "setpoint" in fields:
        series["setpoint"] = np.full(clock.size, fields["setpoint"])
    series["outlet"], is_spike = without_spikes(series["outlet"])
    volume = fields.get("volume", math.nan)
    percent = {"setpoint": scale.setpoint_percent(series["setpoint"]), "outlet": scale.percent(series["outlet"])}
    cut = find_clipped_samples({**series, **percent})
    record = Record(name, fields["test"], clock - clock[0], **series, volume=volume, is_exact=False, clipped=cut)
    return record, int(is_spike.sum())


SHORTEST = 5  # smallest number of equal samples at an extreme value
# Change per sample before clipping, in resolution steps, and its smallest ratio to the change before; a settling
# series slows down.
STEEP, SLOWER = 4.0, 0.3
# Deviation from the setpoint at which an outlet cannot stop suddenly, and further change of the setpoint [% FS].
BELOW, ONWARD = 0.3, 1.0
RETURNED = 0.003  # excursion of the outlet while its driver seems constant, relative to the range of the outlet
LOADED = 0.02  # change of the flow while the outlet is constant, relative to the range of the flow
CLEAR, RAMP = 6.0, 12.0  # smallest change of a ramp, in standard deviations of the noise and in resolution steps
ROUGH = 6.0  # smallest excursion, in standard deviations of means about a smooth curve
FLOOR = 1.0  # outlet near its lower limit, where a constant outlet is normal [% FS]
MOST_LOOKED_AT = 200  # maximum number of samples before a run that are examined


def find_clipped_samples(series: Mapping[str, FloatArray]) -> dict[str, Mask]:
    """Return a mask of the clipped samples of each series that has any.

    A clipped sample is at a limit of its channel, so the true value is unknown. Setpoint and outlet must be in % FS.

    Examples
    --------
    >>> x = np.concatenate([np.linspace(0.0, 100.0, 500), np.linspace(100.0, 0.0, 500)])
    >>> found = find_clipped_samples({"setpoint": x, "outlet": np.minimum(x, 75.0)})
    >>> {name: int(mask.sum()) for name, mask in found.items()}
    {'outlet': 250}
    """
    masks: dict[str, Mask] = {}
    for name, values in series.items():
        if not values.size or float(np.ptp(values)) == 0.0:
            continue
        mask = np.zeros(values.size, dtype=bool)
        for level, sign in ((float(np.max(values)), 1.0), (float(np.min(values)), -1.0)):
            runs = _runs(values == level)
            if not runs or (name == "outlet" and sign < 0.0 and level <= FLOOR):
                continue
            # A digital setpoint has no noise to test.
            is_cut = name != "setpoint" and is_stuck_at(values, level, quantum_of(values))
            if not is_cut and name in ("setpoint", "flow"):
                is_cut = any(_outlet_moves_in_section(sign * values, series["outlet"], run) for run in runs)
            elif not is_cut and name == "outlet":
                is_cut = any(_is_stuck(series, sign, run) for run in runs)
            if is_cut:
                mask |= values == level
        if mask.any():
            masks[name] = mask
    return masks


def _is_stuck(series: Mapping[str, FloatArray], sign: float, run: slice) -> bool:
    """Return True if the outlet seems constant because its channel is clipped.

    `run` is the slice in which the outlet is constant at its upper limit (`sign` +1) or lower limit (`sign` -1). Signs
    of clipping are a cut peak, an abrupt stop, and a setpoint or flow that still changes.
    """
    y, x, flow = sign * series["outlet"], sign * series["setpoint"], series.get("flow", np.zeros(0))
    half = slice((run.start + run.stop) // 2, run.stop)
    is_held = _is_ramp(x, run) and float(np.ptp(x[half])) < max(BELOW, CLEAR * noise_of(x))
    is_peak = not is_held and cuts_a_peak(y, (run.start, run.stop), _step(y))
    is_loaded = bool(flow.size) and _rises_in_section(-sign * flow, run, LOADED * float(np.ptp(flow)))
    # A sudden stop while the outlet is still below the setpoint.
    is_abrupt = False
    if run.start >= 4 and float(np.max(x[run])) - y[run.start] >= BELOW and not _is_ramp(x, run):
        earlier, last = np.diff(y[run.start - 3 : run.start])
        is_abrupt = bool(min(earlier, last) > STEEP * _step(y) and last > SLOWER * earlier)
    return is_peak or is_loaded or is_abrupt or _rises_in_section(x, run, ONWARD)


def _runs(mask: Mask) -> list[slice]:
    edges = np.flatnonzero(np.diff(np.concatenate([[False], mask, [False]]).astype(int)))
    return [slice(int(a), int(b)) for a, b in zip(edges[::2], edges[1::2], strict=True) if b - a >= SHORTEST]


def _step(values: FloatArray) -> float:
    return max(quantum_of(values), 1e-6 * float(np.ptp(values)))


def _is_ramp(x: FloatArray, run: slice) -> bool:
    """Return True if the series `x` reaches a constant section gradually.

    `run` is the slice of this section. The result is False if the series reaches the section by a jump.
    """
    approach = x[max(0, run.start - min(run.stop - run.start, MOST_LOOKED_AT)) : run.start + 1]
    change = approach[-1] - approach[0]
    return bool(change > max(RAMP * _step(x), CLEAR * noise_of(x)) and np.max(np.diff(approach)) < 0.5 * change)


def _rises_in_section(x: FloatArray, run: slice, threshold: float) -> bool:
    """Return True if the series `x` rises while the outlet is constant.

    `x` is the setpoint or the flow, and `run` the slice in which the outlet is constant. The rise must exceed
    `threshold` and the noise.
    """
    return bool(float(np.max(x[run])) - x[run.start] > max(threshold, CLEAR * noise_of(x)))


def _outlet_moves_in_section(x: FloatArray, outlet: FloatArray, run: slice) -> bool:
    """Return True if the outlet moves although its driver `x` is constant after a ramp.

    `x` is the setpoint or the flow, constant in the slice `run`. A motion of the outlet away and back shows that `x` is
    clipped there.
    """
    if run.start == 0 or not _is_ramp(x, run):
        return False
    width = max(1, (run.stop - run.start) // 20)
    y = np.convolve(outlet[run], np.full(width, 1.0 / width), "valid")
    peak = int(np.argmax(np.abs(y - y[0])))
    rise, fall = abs(y[peak] - y[0]), abs(y[peak] - y[-1])
    # Correlated noise: scatter of the means about a smooth curve.
    clock = np.linspace(-1.0, 1.0, y.size)
    rough = float(np.std(y - np.polyval(np.polyfit(clock, y, min(4, y.size - 1)), clock)))
    noise = max(CLEAR * noise_of(outlet) * (2.0 / width) ** 0.5, ROUGH * rough)  # of a difference of two means
    return bool(min(rise, fall) > max(RETURNED * float(np.ptp(outlet)), noise))

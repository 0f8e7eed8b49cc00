"""Fit of a circuit to recordings in memory, in one call, and the result of this fit."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, Generic, Protocol, TypeAlias, TypeVar

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.identify.fit.experiment import start_values
from poppet.identify.fit.fit_plan import ROLES, FitPlan, offset_parameters, plan_fit, recording_parameters
from poppet.identify.fit.fit_series import driving_signals
from poppet.identify.fit.identify_fit import Progress, identify_fit
from poppet.identify.fit.intervals import Stages
from poppet.identify.fit.search import SearchSettings
from poppet.identify.free_parameter import FreeParameter, read_free
from poppet.identify.result import Result, fitted_number
from poppet.timeseries.checks import FloatArray, split_heading
from poppet.timeseries.measurements import Measurement, read_measurement
from poppet.timeseries.recording import Recording
from poppet.timeseries.tables.table import Table, seconds

DISCRETE = ("regime", "contact", "friction")
"""Last words of the names of outputs that are state codes. They are compared only if `outputs` contains them."""
OFFSET_MOMENTS = ("mean", "sd")
CARRIED = ("table", "measured", "doubt", "series")
"""Prefixes of the codes of notes on how a recording was read."""


class DataFrame(Protocol):
    """Interface of a table with column labels and an index, as in pandas."""

    @property
    def columns(self) -> Iterable[Any]:
        """Labels of the columns."""

    @property
    def index(self) -> Iterable[Any]:
        """Labels of the rows."""

    def __getitem__(self, key: Any, /) -> object: ...


Data: TypeAlias = Recording | DataFrame
CircuitT = TypeVar("CircuitT", bound=BaseCircuit)


@dataclasses.dataclass(frozen=True)
class FitResult(Result, Generic[CircuitT]):
    """Result of a fit of a circuit.

    Parameters
    ----------
    circuit : Circuit
        Circuit with the fitted values. After a fit of one recording it also has the inputs and the start values of that
        recording: `circuit.simulate` then repeats the fitted curves.
    circuits : mapping
        Mapping from the name of each recording to the fitted circuit with the inputs and start values of the recording.
    """

    circuit: CircuitT = dataclasses.field(kw_only=True, repr=False, compare=False)
    circuits: Mapping[str, CircuitT] = dataclasses.field(kw_only=True, repr=False, compare=False)

    @classmethod
    def of(cls, result: Result, circuit: CircuitT, plan: FitPlan) -> FitResult[CircuitT]:
        """Return the result of a fit together with the circuit that has the fitted values.

        Parameters
        ----------
        result : Result
            Result of the fit.
        circuit : Circuit
            Circuit before the fit.
        plan : FitPlan
            Plan of the fit.

        Returns
        -------
        FitResult
        """
        circuits: dict[str, CircuitT] = {}
        for e in (*plan.experiments, *plan.validation):
            values: dict[str, Any] = {a: n for a, n in result.values().items() if a in circuit.numbers()}
            values |= start_values(e.measurement, e.instance)
            shifts: dict[str, dict[str, float]] = {"delay": {}, "input_lag": {}}
            for parameter in e.free:
                estimate = result.parameters[parameter.name]
                if parameter.role in shifts:
                    shifts[parameter.role][parameter.address] = estimate.value
                elif parameter.role == "start":
                    values[parameter.address] = fitted_number(estimate, result.title)
            fitted = circuit.with_values(values)
            if fitted.run.duration is None:
                fitted = fitted.with_values({"run.duration": float(e.grid[-1])})
            driven = driving_signals(e.measurement, shifts["delay"], shifts["input_lag"])
            signals = {**fitted.signals, **driven}
            circuits[e.name] = dataclasses.replace(fitted, signals=signals, like=fitted) if driven else fitted
        fitted = circuits[plan.experiments[0].name] if len(circuits) == 1 else circuit.with_values(result.values())
        return FitResult(**vars(result), circuit=fitted, circuits=circuits)


def fit_circuit(
    circuit: CircuitT,
    recordings: Data | Mapping[str, Data],
    free: Sequence[str] | Mapping[str, Any],
    *,
    outputs: Sequence[str] | None = None,
    bounds: Mapping[str, Sequence[Any]] | None = None,
    priors: Mapping[str, Sequence[Any]] | None = None,
    start: Mapping[str, Any] | None = None,
    noise: Mapping[str, Any] | None = None,
    offsets: Mapping[str, Any] | None = None,
    hold: bool = True,
    validation: Sequence[str] = (),
    loss: str = "linear",
    starts: int = 1,
    seed: int = 0,
    kicks: int | None = None,
    profile: Sequence[str] = (),
    bootstrap: int = 0,
    contour: bool = False,
    title: str | None = None,
    progress: Progress | None = None,
    stages: Stages | None = None,
) -> FitResult[CircuitT]:
    """Fit parameters of a circuit to recordings.

    The public method `Circuit.fit` describes the arguments.
    """
    if not isinstance(free, Mapping):
        free = {address: {} for address in ([free] if isinstance(free, str) else free)}
    tables = {a: dict(value) if isinstance(value, Mapping) else {"start": value} for a, value in free.items()}
    reader = _RecordingReader(circuit, outputs, start or {}, noise or {}, offsets or {}, hold)
    measurements = reader.read_all(recordings)
    names = [measurement.name for measurement in measurements]
    for name in (name for name in validation if name not in names):
        near = NameSuggestion(name, names)
        raise InputError(
            "fields.not_an_option", "validation", value=name, meaning="name of a recording", suggestion=near
        )
    roles = [ROLES[name in validation] for name in names]
    free_starts = {address for m in measurements for address, value in m.start.items() if value == "free"}
    limits: dict[str, dict[str, Any]] = {address: {} for address in free_starts} | tables
    parameters: list[FreeParameter] = []
    with ErrorCollector() as errors:
        for argument, keys, pairs in (("bounds", ("min", "max"), bounds), ("priors", ("mean", "sd"), priors)):
            for address, pair in (pairs or {}).items():
                location = f"{argument}.{address}"
                if address not in limits:
                    near = NameSuggestion(address, limits)
                    errors.add("names.unknown", location, meaning="a free parameter", suggestion=near)
                elif not isinstance(pair, Mapping) and (isinstance(pair, str) or not isinstance(pair, Sequence)):
                    errors.add("fit.no_pair", location, value=pair, first=keys[0], second=keys[1])
                else:
                    table = pair if isinstance(pair, Mapping) else dict(zip(keys, pair, strict=False))
                    fields = {key: value for key, value in table.items() if value is not None}
                    limits[address].update(fields if argument == "bounds" else {"prior": fields})
        for address in (address for address in tables if address not in free_starts):
            with errors.collecting():
                parameters.append(read_free(address, limits[address], circuit, where=address))
    circuits = [circuit] * len(measurements)
    parameters += recording_parameters(measurements, circuits, roles, limits)
    parameters += offset_parameters(measurements, circuits, roles)
    if not parameters:
        raise InputError("fit.nothing_free", "free")
    settings = SearchSettings(loss, starts, seed, kicks)
    plan = plan_fit(
        circuits, measurements, roles, parameters, settings=settings, title=circuit.title if title is None else title
    )
    result = identify_fit(plan, profile=profile, repeats=bootstrap, contour=contour, progress=progress, stages=stages)
    return FitResult.of(result, circuit, plan)


class _RecordingReader:
    """Reader that assigns the series of recordings to inputs and outputs of a circuit."""

    def __init__(
        self,
        circuit: BaseCircuit,
        selected: Sequence[str] | None,
        start: Mapping[str, Any],
        noise: Mapping[str, Any],
        offsets: Mapping[str, Any],
        hold: bool,
    ) -> None:
        self.circuit, self.selected = circuit, [selected] if isinstance(selected, str) else selected
        self.start, self.noise, self.offsets, self.hold = start, noise, offsets, hold
        self.outputs = dict(circuit.model.outputs)
        self.inputs = {a: item for a, item in circuit.inputs.items() if a in circuit.instance.input_names}
        self.inputs = {address: item for address, item in self.inputs.items() if not item.slope_of}

    def read_all(self, recordings: Data | Mapping[str, Data]) -> list[Measurement]:
        """Return all recordings as measurements, after a check of the addresses.

        A single recording without a name is called `recording`.

        Raises
        ------
        InputErrors
            If any recording is invalid. The exception contains the errors of all recordings.
        """
        parts = self.circuit.parts
        if not isinstance(recordings, Mapping):
            recordings = {"recording" if "recording" not in parts else "measured": recordings}
        if not recordings:
            raise InputError("fit.no_recordings", "recordings")
        for name in recordings:
            if not isinstance(name, str) or name in parts or "." in name:
                raise InputError("fit.recording_name", f"recordings.{name}", name=name)
        measurements: list[Measurement] = []
        with ErrorCollector() as errors:
            for address in self.selected or ():
                if address in self.inputs:
                    errors.add("fit.input_selected", f"outputs.{address}")
                elif address not in self.outputs:
                    near = NameSuggestion(address, self.outputs)
                    errors.add(
                        "names.unknown", f"outputs.{address}", meaning="an output of this circuit", suggestion=near
                    )
        with ErrorCollector() as errors:
            for name, data in recordings.items():
                with errors.collecting():
                    measurements.append(self._read(name, data, recordings))
        compared = {channel.address for measurement in measurements for channel in measurement.channels}
        driving = {item.address for measurement in measurements for item in measurement.inputs}
        with ErrorCollector() as errors:
            for argument, keys in (("outputs", self.selected or ()), ("noise", self.noise), ("offsets", self.offsets)):
                for address in (address for address in keys if address not in compared):
                    near = NameSuggestion(address, compared)
                    errors.add("names.unknown", f"{argument}.{address}", meaning="a compared series", suggestion=near)
            for measurement in measurements:
                recorded = {item.address for item in measurement.inputs} | self.circuit.signals.keys()
                for address in sorted(driving - recorded):
                    errors.add("fit.missing_input", f"recordings.{measurement.name}.{address}")
                for item in measurement.inputs:
                    if item.time[0] > measurement.duration or item.time[-1] < min(0.0, item.time[0] + 1e-9):
                        span = float(item.time[0]), float(item.time[-1])
                        errors.add(
                            "fit.no_overlap", f"recordings.{measurement.name}.{item.address}",
                            first=span[0], last=span[1], end=measurement.duration,
                        )  # fmt: skip
        return measurements

    def _read(self, name: str, data: Data, recordings: Iterable[str]) -> Measurement:
        """Return one recording as a measurement in SI units.

        `data` is the recording or data frame. `recordings` contains the names of all recordings.
        """
        location = f"recordings.{name}"
        if isinstance(data, Recording):
            names, units = ("time", *data.names), ("s", *data.units)
            table = Table(names, (data.time, *data.values), units, data.remarks)
            internal, ambient_pressure = set(data.inner), data.ambient_pressure
        else:
            table, internal = frame_table(data, location), set()
            ambient_pressure = self.circuit.surroundings.pressure
        if not table.columns[0].size:
            raise InputError("fit.no_rows", location)
        fields, omitted = self._fields(table, internal, location)
        shared = {address: value for address, value in self.start.items() if address not in recordings}
        fields["start"] = shared | dict(self.start.get(name, {}))
        measurement = read_measurement(name, fields, Path(), ambient_pressure=ambient_pressure, source=table)
        notes = [note for note in table.notes if note.code.partition(".")[0] in CARRIED]
        notes += [Note("fit.not_compared", names=tuple(omitted))] if omitted else []
        doubts = [note for note in table.notes if note.code.startswith("suspicion.")]
        return dataclasses.replace(
            measurement,
            notes=(*notes, *measurement.notes),
            findings=(*doubts, *measurement.findings),
        )

    def _fields(self, table: Table, internal: set[str], location: str) -> tuple[dict[str, Any], list[str]]:
        """Return the specification of the channels of a recording, and the addresses of omitted series.

        The specification contains the column and the unit of the time, of each compared output and of each input.
        `table` is the recording, `internal` contains the addresses of internal outputs, and `location` is the location
        of the recording in messages. Series are omitted only if the user has not selected the outputs to compare.
        """
        recorded, omitted = dict(zip(table.names[1:], table.columns[1:], strict=True)), list[str]()
        if self.selected is not None:
            compared = [address for address in self.selected if address in recorded]
            if not compared:
                raise InputError("fit.no_series", location, suggestion=NameSuggestion(self.selected[0], recorded))
        else:
            valid = (*self.outputs, *self.inputs)
            with ErrorCollector() as errors:
                for address in recorded:
                    if address not in valid:
                        errors.add(
                            "fit.unknown_series", f"{location}.{address}", suggestion=NameSuggestion(address, valid)
                        )
            candidates = [address for address in recorded if address not in self.inputs]
            finite = {address: recorded[address][np.isfinite(recorded[address])] for address in candidates}
            varying = [a for a in candidates if a not in internal and (finite[a].size == 0 or np.ptp(finite[a]) > 0.0)]
            compared = [a for a in varying if a.rpartition(".")[2].rpartition("_")[2] not in DISCRETE] or candidates
            if not compared:
                raise InputError("fit.no_series", location, suggestion=NameSuggestion("", self.outputs))
            omitted = [address for address in candidates if address not in compared]
        # A column without a unit has the SI unit of the circuit.
        units = dict(zip(table.names, table.units, strict=True))
        fields: dict[str, Any] = {"time": {"column": 0, "unit": units["time"]}, "inputs": {}}
        for address in compared:
            unit = units[address] or self.outputs[address]
            fields[address] = {"column": table.names.index(address), "unit": unit}
            if address in self.noise:
                fields[address]["noise"] = self.noise[address]
            if address in self.offsets:
                offset = self.offsets[address]
                if not isinstance(offset, str | int | float | Mapping):
                    first, second = OFFSET_MOMENTS
                    if not isinstance(offset, Sequence) or len(offset) != 2:
                        name = f"offsets.{address}"
                        raise InputError("fit.no_pair", name, value=offset, first=first, second=second)
                    offset = {first: offset[0], second: offset[1]}
                fields[address]["offset"] = offset
        for address in (address for address in recorded if address in self.inputs):
            default, unit = self.inputs[address].default, self.inputs[address].unit
            if isinstance(default, str):
                default = self.circuit.parameters[f"{address.partition('.')[0]}.{default}"]
            is_default = units[address] in ("", unit) and np.all(recorded[address] == default)
            # Omit an input that equals its constant value in the circuit.
            if address in self.circuit.signals or not is_default:
                column = {"column": table.names.index(address), "unit": units[address] or unit, "hold": self.hold}
                fields["inputs"][address] = column
        return fields, omitted


def frame_table(frame: DataFrame, location: str) -> Table:
    """Convert a data frame to a table whose first column is the time.

    `location` identifies the data frame in messages.

    Raises
    ------
    InputError
        If a column occurs twice, if there is no time, or if the object is not a data frame.
    """
    if not hasattr(frame, "columns") or not hasattr(frame, "index"):
        raise InputError("fit.no_recording", location, value=type(frame).__name__)
    labels = list(frame.columns)
    headings = [split_heading(str(label)) for label in labels]
    names = [name for name, _ in headings]
    stated: Mapping[str, str] = getattr(frame, "attrs", {}).get("units", {})
    with ErrorCollector() as errors:
        for name in dict.fromkeys(name for name in names if names.count(name) > 1):
            errors.add("fit.column_twice", f"{location}.{name}")
    if "time" in names:
        time, unit = frame[labels[names.index("time")]], headings[names.index("time")][1]
    elif type(frame.index).__name__ == "RangeIndex":
        raise InputError("fit.no_time", location)
    else:
        label = getattr(frame.index, "name", None)
        time, unit = frame.index, split_heading(str(label))[1] if label else ""
    series = {name: (_column_as_floats(frame[label]), u) for label, (name, u) in zip(labels, headings, strict=True)}
    series.pop("time", None)
    return Table(
        ("time", *series),
        (_column_as_floats(time), *(column for column, _ in series.values())),
        (unit or "s", *(u or stated.get(name, "") for name, (_, u) in series.items())),
    )


def _column_as_floats(column: object) -> FloatArray:
    """Return a column of a data frame as floats.

    Dates become seconds since the first date, and text becomes NaN.
    """
    values = np.asarray(column)
    if values.dtype.kind == "M":
        return seconds(values)
    if values.dtype.kind == "m":
        return np.asarray(values / np.timedelta64(1, "s"), dtype=np.float64)
    try:
        return np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        return np.full(values.shape, np.nan)

"""Plan of a fit, with recordings, free parameters and search settings, and the reader of fit files."""

from __future__ import annotations

import itertools
import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.file import load
from poppet.core.errors import ErrorCollector, InputError, relocated
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.identify.fit.experiment import Experiment, starting_channel
from poppet.identify.fit.fit_series import first_value
from poppet.identify.fit.search import Optimum, SearchSettings, optimise
from poppet.identify.free_parameter import FreeParameter, NormalPrior, read_free, with_starts
from poppet.timeseries.checks import FloatArray
from poppet.timeseries.measurements import Channel, Measurement, read_measurement

ROLES = ("fit", "validation")
LATEST = 0.2
"""Bounds of a free delay, as a fraction of the recording."""
LARGEST_OFFSET = 0.1
"""Largest offset of a sensor without a stated offset, as a fraction of the range of the recording."""
SURELY = 3.0
"""Largest offset of a sensor, in stated standard deviations."""
FARTHEST = 5.0
"""Bounds of an offset in a fit, in stated standard deviations: at a bound, the other parameters would be biased."""
SEARCH = ("loss", "starts", "seed", "kicks")
CIRCUIT_FIELDS = {
    "circuit": Field(is_required=True, meaning="circuit file", example='circuit = "bench.toml"'),
    "free": Field(
        type="table", is_required=True, meaning="list of free parameters", example='[free] with "part.parameter" = 0.3'
    ),
    "set": Field(type="table"),
    "title": Field(type="text"),
}
"""Fields of a file that refers to a circuit with free parameters."""
TOP_LEVEL = {
    **CIRCUIT_FIELDS,
    "recordings": Field(
        type="table",
        is_required=True,
        meaning="list of recordings",
        example="[recordings.NAME] with file, time and channels",
    ),
    **dict.fromkeys(SEARCH, Field()),
}


@dataclass(frozen=True)
class FitPlan:
    """Definition of a fit: recordings with their models, free parameters and search settings."""

    experiments: tuple[Experiment, ...]  # recordings that are fitted, with their models
    free: tuple[FreeParameter, ...]  # parameters of single recordings last
    validation: tuple[Experiment, ...] = ()  # recordings that are only compared with the model
    settings: SearchSettings = field(default_factory=SearchSettings)
    title: str = ""


def read_fit_file(path: str | Path) -> FitPlan:
    """Read a fit file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see `docs/identify.md`.

    Returns
    -------
    FitPlan
        Checked plan; nothing is fitted.

    Raises
    ------
    InputErrors
        If the file is invalid. The exception contains all errors, each with its line if available.
    """
    file = TomlFile.read(path, "recordings")
    with file.errors():
        # The required tables come first: all others are read with them.
        with ErrorCollector() as errors:
            data = read_fields(errors, file.content, TOP_LEVEL, table="fit file")
        circuit = read_circuit(data, file.folder)
        settings, tables = _read_search_settings(data)
        measurements, roles = [], []
        with ErrorCollector() as errors:
            for name, table in data["recordings"].items():
                fields, role = table, ROLES[0]
                if isinstance(table, Mapping) and "use" in table:
                    fields = {key: value for key, value in table.items() if key != "use"}
                    with errors.collecting():
                        role = Field(choices=ROLES).read(table["use"], f"recordings.{name}.use")
                with errors.collecting():
                    ambient = circuit.surroundings.pressure
                    measurements.append(
                        read_measurement(name, fields, file.folder, ambient_pressure=ambient, other_fields=("use",))
                    )
                    roles.append(role)
        free: list[FreeParameter] = []
        with ErrorCollector() as errors:
            for address, table in tables.items():
                with errors.collecting():
                    free.append(read_free(address, table, circuit))
        circuits = [circuit] * len(roles)
        free += recording_parameters(measurements, circuits, roles)
        free += offset_parameters(measurements, circuits, roles)
        title = str(data.get("title", circuit.title or Path(file.name).stem))
        return plan_fit(circuits, measurements, roles, free, settings=settings, title=title)


def read_circuit(data: Mapping[str, Any], folder: Path) -> BaseCircuit:
    """Return the circuit that a file names, with the values of the table `set`.

    Error messages refer to the location in that file.
    """
    try:
        circuit = load(folder / str(data["circuit"]))
    except InputError as error:
        raise relocated(error, lambda _: "circuit") from None
    try:
        return circuit.with_values(data.get("set", {}))
    except InputError as error:
        raise relocated(error, "set.{}".format) from None


def _read_search_settings(data: Mapping[str, Any]) -> tuple[SearchSettings, dict[str, Any]]:
    """Return the search settings of a fit file, and the remaining tables.

    The remaining tables describe the free parameters. Settings can be in several tables, but must agree.
    """
    parameters = {k: dict(v) if isinstance(v, Mapping) else v for k, v in data["free"].items() if k not in SEARCH}
    tables = {"": data, "free.": data["free"]} | {f"free.{k}.": v for k, v in parameters.items() if isinstance(v, dict)}
    settings: dict[str, tuple[Any, str]] = {}
    for prefix, table in tables.items():
        for key in SEARCH:
            if key not in table:
                continue
            value, first = settings.setdefault(key, (table[key], f"{prefix}{key}"))
            if value != table[key]:
                raise InputError("fit.two_searches", f"{prefix}{key}", value=table[key], first=first, other=value)
    for table in parameters.values():
        for key in SEARCH if isinstance(table, dict) else ():
            table.pop(key, None)
    try:
        return SearchSettings(**{key: value for key, (value, _) in settings.items()}), parameters
    except InputError as error:
        raise relocated(error, lambda key: settings[key][1]) from None


def plan_fit(
    circuits: Sequence[BaseCircuit],
    measurements: Sequence[Measurement],
    roles: Sequence[str],
    free: Sequence[FreeParameter],
    *,
    settings: SearchSettings,
    title: str,
) -> FitPlan:
    """Return the plan of a fit of several recordings.

    Each recording has its circuit and its role (fit or validation). Fit files, `Circuit.fit` and tank tests use this
    function.

    Raises
    ------
    InputErrors
        If two recordings are equal, if no recording is fitted, or if a validation recording has a free start value, lag
        or delay.
    """
    with ErrorCollector() as errors:
        for first, second in itertools.combinations(measurements, 2):
            if is_same(first, second):
                errors.add("fit.same_twice", f"recordings.{second.name}", other=first.name)
        for measurement, role in zip(measurements, roles, strict=True):
            if role == "validation":
                free_fields = [("start", address) for address, start in measurement.start.items() if start == "free"]
                free_fields += [("lag", channel.address) for channel in measurement.channels if channel.lag is None]
                free_fields += [("lag", item.address) for item in measurement.inputs if item.lag is None]
                free_fields += [("delay", item.address) for item in measurement.inputs if item.delay is None]
                for kind, address in free_fields:
                    errors.add(f"fit.held_frees.{kind}", f"recordings.{measurement.name}", what=address)
    parameters = tuple(free)
    experiments = [
        Experiment(circuit.instance, measurement, parameters)
        for circuit, measurement in zip(circuits, measurements, strict=True)
    ]
    fitted, compared = (
        tuple(experiment for experiment, role in zip(experiments, roles, strict=True) if role == selected)
        for selected in ROLES
    )
    if not fitted:
        raise InputError("fit.all_held", "recordings")
    return FitPlan(fitted, parameters, compared, settings, title)


def refit(plan: FitPlan, x: FloatArray, sigmas: list[float], fixed: Mapping[str, float] | None = None) -> Optimum:
    """Repeat the search of a fit from the start point `x`.

    `sigmas` is the noise of each channel, and `fixed` maps names of parameters to fixed values.

    Raises
    ------
    KeyboardInterrupt
        If the user interrupted the search.
    """
    # The search starts at an optimum: a restart is not necessary.
    settings = SearchSettings(plan.settings.loss, kicks=0)
    optimum = optimise(plan.experiments, with_starts(plan.free, x), settings, sigmas=sigmas, fixed=fixed)
    if optimum.interrupted:
        raise KeyboardInterrupt
    return optimum


def is_same(first: Measurement, second: Measurement) -> bool:
    """Return True if two recordings have equal channels with equal samples."""
    pairs = zip(first.channels, second.channels, strict=False)
    return len(first.channels) == len(second.channels) and all(
        a.address == b.address and np.array_equal(a.values, b.values) and np.array_equal(a.time, b.time)
        for a, b in pairs
    )


def recording_parameters(
    measurements: Sequence[Measurement],
    circuits: Sequence[BaseCircuit],
    roles: Sequence[str],
    limits: Mapping[str, Mapping[str, Any]] | None = None,
) -> list[FreeParameter]:
    """Return the free parameters that belong to single recordings: initial values, lags and delays.

    `roles` states if a recording is fitted or used for validation. `limits` maps the address of an initial value to its
    bounds and prior.
    """
    parameters: list[FreeParameter] = []
    fitted = [measurement for measurement, role in zip(measurements, roles, strict=True) if role == "fit"]
    free_starts = [address for measurement in fitted for address, start in measurement.start.items() if start == "free"]
    for measurement, circuit in zip(measurements, circuits, strict=True):
        for address, start in measurement.start.items():
            if start == "free":
                # The address identifies a start value, unless several recordings have the same one free.
                name = address if free_starts.count(address) == 1 else f"{measurement.name}.{address}"
                channel = starting_channel(address, circuit.instance, measurement)[1]
                table = {"start": first_value(channel)} if channel is not None else {}
                table |= (limits or {}).get(address, {})
                parameters.append(read_free(address, table, circuit, recording=measurement.name, name=name))
        name, span = measurement.name, measurement.duration
        latest = LATEST * span
        # A lag cannot be negative; an input can be recorded early or late.
        lags = [c.address for c in measurement.channels if c.lag is None]
        delays = [item.address for item in measurement.inputs if item.delay is None]
        input_lags = [item.address for item in measurement.inputs if item.lag is None]
        parameters += [FreeParameter(f"{name}.{a}.lag", a, "s", 0.02 * span, 0.0, span, "lag", name) for a in lags]
        parameters += [FreeParameter(f"{name}.{a}.delay", a, "s", 0.0, -latest, latest, "delay", name) for a in delays]
        parameters += [
            FreeParameter(f"{name}.{a}.lag", a, "s", 0.01 * span, 0.0, span, "input_lag", name) for a in input_lags
        ]
    return parameters


def offset_parameters(
    measurements: Sequence[Measurement], circuits: Sequence[BaseCircuit], roles: Sequence[str]
) -> list[FreeParameter]:
    """Return the free sensor offsets of all recordings that are fitted.

    A channel has a free offset if its table states one.

    Raises
    ------
    InputErrors
        If the first sample of such a channel is a start value: it would contain the unknown offset.
    """
    parameters: list[FreeParameter] = []
    fitted = [pair for pair, role in zip(zip(measurements, circuits, strict=True), roles, strict=True) if role == "fit"]
    with ErrorCollector() as errors:
        for measurement, circuit in fitted:
            for address, start in measurement.start.items():
                channel = starting_channel(address, circuit.instance, measurement)[1]
                if start == "first" and channel is not None and channel.offset is not None:
                    location = f"recordings.{measurement.name}.start.{address}"
                    errors.add("fit.first_of_offset", location, channel=channel.address)
            parameters += [
                offset_parameter(measurement.name, channel, NormalPrior(0.0, channel.offset))
                for channel in measurement.channels
                if channel.offset is not None
            ]
    return parameters


def offset_parameter(recording: str, channel: Channel, prior: NormalPrior | None) -> FreeParameter:
    """Return the free parameter for the offset of one sensor.

    With a prior, the offset is limited to five standard deviations about its mean. The mean is relative to the expected
    offset that the channel states. Without a prior, the limits are a tenth of the range of the recorded channel on both
    sides of the expected offset.
    """
    prior = None if prior is None or not math.isfinite(prior.sd) else prior
    prior = None if prior is None else NormalPrior(prior.mean + channel.offset_mean, prior.sd)
    mean = channel.offset_mean if prior is None else prior.mean
    largest = LARGEST_OFFSET * float(np.ptp(channel.values)) if prior is None else FARTHEST * prior.sd
    name, address = f"{recording}.{channel.address}.offset", channel.address
    bounds = mean - largest, mean + largest
    return FreeParameter(name, address, channel.unit, mean, *bounds, "offset", recording, prior)


def check_effects(plan: FitPlan) -> None:
    """Raise an error for each free parameter that changes no simulated channel of the recordings.

    Circuits with sampled controllers are not checked, because their outputs are piecewise constant functions of the
    parameters.

    Raises
    ------
    InputErrors
        If a parameter has no effect. The exception contains one error for each such parameter.
    """
    if any(experiment.samples for experiment in plan.experiments):
        return
    start = {parameter.name: parameter.start for parameter in plan.free}
    candidates = {parameter.name for parameter in plan.free if parameter.role in ("number", "start")}
    for experiment in plan.experiments:
        candidates -= _effective_parameters(experiment, start)
    with ErrorCollector() as errors:
        for parameter in (parameter for parameter in plan.free if parameter.name in candidates):
            # Far from its start, a parameter can have an effect: a critical ratio if the flow is choked at the start.
            trials = {float(np.clip(factor * parameter.scale, *parameter.bounds)) for factor in (0.1, 0.5, 2.0, 10.0)}
            trials |= {bound for bound in parameter.bounds if math.isfinite(bound)}
            if not any(
                parameter.name in _effective_parameters(experiment, {**start, parameter.name: trial})
                for experiment in plan.experiments
                for trial in sorted(trials)
            ):
                errors.add("fit.no_effect", parameter.name, start=parameter.start, unit=parameter.unit)


def _effective_parameters(experiment: Experiment, values: Mapping[str, float]) -> set[str]:
    """Return the names of the free parameters that change a simulated channel of a recording.

    `values` maps the names of the free parameters to their present values.
    """
    # Not-a-number, from a run that failed at a bound, gives no information.
    slopes = [np.nan_to_num(slope) for slope in experiment.slopes(values)]
    return {parameter.name for k, parameter in enumerate(experiment.free) if any(slope[:, k].any() for slope in slopes)}

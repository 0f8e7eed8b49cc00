"""Plan of a fit: recordings with their circuits, free parameters and search settings."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import ErrorCollector, InputError
from poppet.identify.fit.experiment import Experiment, starting_channel
from poppet.identify.fit.fit_findings import LARGEST_OFFSET, SURELY
from poppet.identify.fit.fit_series import first_value
from poppet.identify.fit.search import SearchSettings
from poppet.identify.free_parameter import FreeParameter, NormalPrior, read_free
from poppet.timeseries.measurements import Channel, Measurement

ROLES = ("fit", "validation")
LATEST = 0.2
"""Bounds of a free delay, as a fraction of the recording."""


@dataclass(frozen=True)
class FitPlan:
    """Recordings with their models, free parameters and search settings of a fit."""

    experiments: tuple[Experiment, ...]  # recordings that are fitted, with their models
    free: tuple[FreeParameter, ...]  # parameters of single recordings last
    validation: tuple[Experiment, ...] = ()  # recordings that are only compared with the model
    settings: SearchSettings = field(default_factory=SearchSettings)
    title: str = ""


def plan_fit(
    circuits: Sequence[BaseCircuit],
    measurements: Sequence[Measurement],
    roles: Sequence[str],
    free: Sequence[FreeParameter],
    *,
    settings: SearchSettings,
    title: str,
) -> FitPlan:
    """Return the plan of a fit of recordings, each with its circuit and its role.

    Fit files, `Circuit.fit` and tank tests use this function.

    Raises
    ------
    InputErrors
        If two recordings are equal, if no recording is fitted, or if a recording that is only compared has a free
        start value, lag or delay.
    """
    with ErrorCollector() as errors:
        for first, second in itertools.combinations(measurements, 2):
            if is_same(first, second):
                errors.add("fit.same_twice", f"recordings.{second.name}", other=first.name)
        for measurement, role in zip(measurements, roles, strict=True):
            for kind, address in _free_of(measurement) if role == "validation" else ():
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


def is_same(first: Measurement, second: Measurement) -> bool:
    """Return True if two recordings have the same channels with the same samples."""
    pairs = zip(first.channels, second.channels, strict=False)
    return len(first.channels) == len(second.channels) and all(
        a.address == b.address and np.array_equal(a.values, b.values) and np.array_equal(a.time, b.time)
        for a, b in pairs
    )


def _free_of(measurement: Measurement) -> Iterator[tuple[str, str]]:
    """Yield kind and address of each free start value, lag and delay of a recording."""
    yield from (("start", address) for address, start in measurement.start.items() if start == "free")
    yield from (("lag", channel.address) for channel in measurement.channels if channel.lag is None)
    yield from (("lag", item.address) for item in measurement.inputs if item.lag is None)
    yield from (("delay", item.address) for item in measurement.inputs if item.delay is None)


def recording_parameters(
    measurements: Sequence[Measurement],
    circuits: Sequence[BaseCircuit],
    roles: Sequence[str],
    limits: Mapping[str, Mapping[str, Any]] | None = None,
) -> list[FreeParameter]:
    """Return the start values, lags and delays of recordings that are free.

    `limits` maps the address of a start value to its bounds and prior.
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


def offset_parameter(recording: str, channel: Channel, prior: NormalPrior | None) -> FreeParameter:
    """Return the free offset of a sensor, limited to three standard deviations of its prior.

    Without a prior, the limits are plus and minus a tenth of the range of the recorded channel.
    """
    mean = 0.0 if prior is None else prior.mean
    largest = LARGEST_OFFSET * float(np.ptp(channel.values)) if prior is None else SURELY * prior.sd
    name, address = f"{recording}.{channel.address}.offset", channel.address
    bounds = mean - largest, mean + largest
    return FreeParameter(name, address, channel.unit, mean, *bounds, "offset", recording, prior)


def check_effects(plan: FitPlan) -> None:
    """Raise an error for each free parameter that has no effect on the compared outputs.

    The check is omitted for sampled circuits: their outputs are piecewise constant in the parameters.

    Raises
    ------
    InputErrors
        With all parameters without effect.
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
    """Return the names of the parameters that change a compared output."""
    # Not-a-number, from a run that failed at a bound, gives no information.
    slopes = [np.nan_to_num(slope) for slope in experiment.slopes(values)]
    return {parameter.name for k, parameter in enumerate(experiment.free) if any(slope[:, k].any() for slope in slopes)}

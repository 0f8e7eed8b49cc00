"""Fit files: which circuit, which recordings, which numbers are free."""

from __future__ import annotations

import itertools
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

import numpy as np

from poppet.circuit.circuit import Circuit
from poppet.circuit.file import load
from poppet.circuit.instance import Instance
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, relocated
from poppet.core.tables import Field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.identify.fit.experiment import Experiment, starting_channel
from poppet.identify.fit.fit_series import first_value
from poppet.identify.fit.search import SearchSettings
from poppet.identify.free_parameter import FreeParameter, read_free
from poppet.timeseries.measurements import Measurement, read_measurement

SEARCH = ("loss", "starts", "seed", "kicks")
TOP_LEVEL = {
    "circuit": Field(is_required=True, meaning="circuit file", example='circuit = "bench.toml"'),
    "recordings": Field(
        type="table",
        is_required=True,
        meaning="list of recordings",
        example="[recordings.NAME] with file, time and channels",
    ),
    "free": Field(
        type="table", is_required=True, meaning="list of free parameters", example='[free] with "part.parameter" = 0.3'
    ),
    "set": Field(type="table"),
    "title": Field(type="text"),
    **dict.fromkeys(SEARCH, Field()),
}
ROLES = ("fit", "validation")
LATEST = 0.2
"""Bounds of a free delay, as a fraction of the recording."""


@dataclass(frozen=True)
class FitPlan:
    """What is to be fitted, and how."""

    experiments: tuple[Experiment, ...]  # recordings that are fitted, with their models
    free: tuple[FreeParameter, ...]  # those of recordings last
    validation: tuple[Experiment, ...] = ()  # recordings that are only compared
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
        Everything read and checked, nothing fitted.

    Raises
    ------
    InputErrors
        With all mistakes, each with its line where it can be told.
    """
    file = TomlFile.read(path, "recordings")
    with file.errors():
        return _plan(file)


def _plan(file: TomlFile) -> FitPlan:
    # What a fit cannot do without comes first: the rest is read with it.
    with ErrorCollector() as errors:
        data = read_fields(errors, file.content, TOP_LEVEL, table="fit file")
    circuit = read_circuit(data, file.folder)
    settings, tables = _search(data)
    measurements, roles = _measurements(data["recordings"], file.folder, circuit)
    free = (*_free(tables, circuit, measurements, roles), *recording_free(measurements, [circuit] * len(roles), roles))
    title = str(data.get("title", circuit.title or Path(file.name).stem))
    return plan_of([circuit.instance] * len(roles), measurements, roles, free, settings=settings, title=title)


def plan_of(
    instances: Sequence[Instance],
    measurements: Sequence[Measurement],
    roles: Sequence[str],
    free: tuple[FreeParameter, ...],
    *,
    settings: SearchSettings,
    title: str,
) -> FitPlan:
    """A plan of recordings with their models and roles."""
    with ErrorCollector() as errors:
        for one, other in itertools.combinations(measurements, 2):
            if is_same(one, other):
                errors.add("fit.same_twice", f"recordings.{other.name}", other=one.name)
    every = [Experiment(i, m, free) for i, m in zip(instances, measurements, strict=True)]
    fitted, held = (tuple(e for e, role in zip(every, roles, strict=True) if role == wanted) for wanted in ROLES)
    if not fitted:
        raise InputError("fit.all_held", "recordings")
    return FitPlan(fitted, free, held, settings, title)


def is_same(one: Measurement, other: Measurement) -> bool:
    """Whether two recordings hold the same samples of the same channels."""
    pairs = zip(one.channels, other.channels, strict=False)
    return len(one.channels) == len(other.channels) and all(
        a.address == b.address and np.array_equal(a.values, b.values) and np.array_equal(a.time, b.time)
        for a, b in pairs
    )


def read_circuit(data: Mapping[str, Any], folder: Path) -> Circuit:
    """The circuit that a file names, with the numbers that it sets; mistakes stand where that file has them."""
    try:
        circuit = load(folder / str(data["circuit"]))
    except InputError as error:
        raise relocated(error, lambda _: "circuit") from None
    try:
        return circuit.with_values(data.get("set", {}))
    except InputError as error:
        raise relocated(error, "set.{}".format) from None


def _search(data: Mapping[str, Any]) -> tuple[SearchSettings, dict[str, Any]]:
    """How to search, and the free numbers without it; both may stand in one table, for there is one search."""
    numbers = {k: dict(v) if isinstance(v, Mapping) else v for k, v in data["free"].items() if k not in SEARCH}
    tables = {"": data, "free.": data["free"]} | {f"free.{k}.": v for k, v in numbers.items() if isinstance(v, dict)}
    found: dict[str, tuple[Any, str]] = {}
    for place, table in tables.items():
        for key in SEARCH:
            if key not in table:
                continue
            value, first = found.setdefault(key, (table[key], f"{place}{key}"))
            if value != table[key]:
                raise InputError("fit.two_searches", f"{place}{key}", value=table[key], first=first, other=value)
    for table in numbers.values():
        for key in SEARCH if isinstance(table, dict) else ():
            table.pop(key, None)
    try:
        return SearchSettings(**{key: value for key, (value, _) in found.items()}), numbers
    except InputError as error:
        raise relocated(error, lambda key: found[key][1]) from None


def _measurements(tables: Mapping[str, Any], folder: Path, circuit: Circuit) -> tuple[list[Measurement], list[str]]:
    """Recordings and what each is used for."""
    measurements, roles = [], []
    with ErrorCollector() as errors:
        for name, table in tables.items():
            own = dict(table) if isinstance(table, Mapping) else table
            role = own.pop("use", ROLES[0]) if isinstance(own, dict) else ROLES[0]
            if role not in ROLES:
                errors.add(
                    "fields.not_an_option",
                    f"recordings.{name}.use",
                    value=role,
                    meaning="use",
                    near=NameSuggestion(str(role), ROLES),
                )
            with errors.collecting():
                measurements.append(
                    read_measurement(
                        name, own, folder, ambient_pressure=circuit.surroundings.pressure, other_fields=("use",)
                    )
                )
                roles.append(role)
    return measurements, roles


def _free(
    tables: Mapping[str, Any], circuit: Circuit, measurements: Sequence[Measurement], roles: Sequence[str]
) -> list[FreeParameter]:
    found: list[FreeParameter] = []
    with ErrorCollector() as errors:
        for address, table in tables.items():
            with errors.collecting():
                found.append(read_free(address, table, circuit))
        for m, role in zip(measurements, roles, strict=True):
            for what, address in _freed(m) if role == "validation" else ():
                errors.add(f"fit.held_frees.{what}", f"recordings.{m.name}", what=address)
    return found


def _freed(measurement: Measurement) -> Iterator[tuple[str, str]]:
    """What a recording leaves free, and of which address."""
    yield from (("start", address) for address, given in measurement.start.items() if given == "free")
    yield from (("lag", channel.address) for channel in measurement.channels if channel.lag is None)
    yield from (("lag", item.address) for item in measurement.inputs if item.lag is None)
    yield from (("delay", item.address) for item in measurement.inputs if item.delay is None)


def recording_free(
    measurements: Sequence[Measurement], circuits: Sequence[Circuit], roles: Sequence[str]
) -> list[FreeParameter]:
    """Start values, lags and delays that recordings leave free."""
    found: list[FreeParameter] = []
    fitted = [m for m, role in zip(measurements, roles, strict=True) if role == "fit"]
    starting = [address for m in fitted for address, given in m.start.items() if given == "free"]
    for m, circuit in zip(measurements, circuits, strict=True):
        for address, given in m.start.items():
            if given == "free":
                # Its own name tells a start apart, unless several recordings free the same one.
                name = address if starting.count(address) == 1 else f"{m.name}.{address}"
                channel = starting_channel(address, circuit.instance, m)[1]
                table = {"start": first_value(channel)} if channel is not None else {}
                found.append(read_free(address, table, circuit, recording=m.name, name=name))
        span, late = m.duration, LATEST * m.duration
        # A lag cannot be negative; a record may be early as well as late.
        lags, bounds = [c.address for c in m.channels if c.lag is None], (0.0, span)
        found += [FreeParameter(f"{m.name}.{a}.lag", a, "s", 0.02 * span, *bounds, "lag", m.name) for a in lags]
        delays = [i.address for i in m.inputs if i.delay is None]
        found += [FreeParameter(f"{m.name}.{a}.delay", a, "s", 0.0, -late, late, "delay", m.name) for a in delays]
        lags = [i.address for i in m.inputs if i.lag is None]
        found += [FreeParameter(f"{m.name}.{a}.lag", a, "s", 0.01 * span, *bounds, "input_lag", m.name) for a in lags]
    return found

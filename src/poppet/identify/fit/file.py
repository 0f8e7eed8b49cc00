"""Fit files: which circuit, which recordings, which numbers are free."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, TypeVar

from poppet.circuit.circuit import Circuit
from poppet.circuit.file import load
from poppet.ground.errors import InputError, collect, relocated, suggestion
from poppet.ground.toml_file import TomlFile
from poppet.identify.fit.experiment import Experiment
from poppet.identify.fit.search import Settings
from poppet.identify.fit.series import first_value
from poppet.identify.free import Free, read_free
from poppet.series.measured import read_measurement

Built = TypeVar("Built")

TOP_LEVEL = ("circuit", "title", "recordings", "free", "loss", "starts", "seed", "kicks", "set")
SEARCH = ("loss", "starts", "seed", "kicks")
ROLES = ("fit", "validation")
LATEST = 0.2
"""Bounds of a free delay, as a fraction of the recording."""


@dataclass(frozen=True)
class FitPlan:
    """What is to be fitted, and how.

    Parameters
    ----------
    experiments : tuple of Experiment
        Recordings that are fitted, with their circuits.
    free : tuple of Free
        Free numbers, those of recordings last.
    validation : tuple of Experiment
        Recordings that are only compared.
    settings : Settings
        How to search.
    title : str
        For people.
    """

    experiments: tuple[Experiment, ...]
    free: tuple[Free, ...]
    validation: tuple[Experiment, ...] = ()
    settings: Settings = field(default_factory=Settings)
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
    path = Path(path)
    return read_located(path, lambda data: _plan(data, path))


def read_located(path: Path, build: Callable[[dict[str, Any]], Built]) -> Built:
    """Read a TOML file and give every mistake in it its line."""
    file = TomlFile.read(path)
    with file.mistakes():
        try:
            return build(file.content)
        except InputError as error:
            for problem in error.problems if error.code != "toml.invalid" else ():
                # A message that begins with a key names it more closely than its address may.
                named = problem.given.partition(" = ")[0]
                problem.located(line=file.lines.get(named) or file.line_of(problem.address) or file.line_of(named))
            raise


def _plan(data: Mapping[str, Any], path: Path) -> FitPlan:
    problems = [
        InputError(f"[{key}]", "is not a part of a fit file.", suggestion(key, TOP_LEVEL), address=key)
        for key in data
        if key not in TOP_LEVEL
    ]
    problems += [
        InputError(f"{key} is missing:", f"a fit needs {what}.", cure, address=key)
        for key, what, cure in (
            ("circuit", "a model", 'Write circuit = "bench.toml".'),
            ("recordings", "data", "Write [recordings.NAME] with file, time and channels."),
            ("free", "free numbers", 'Write [free] and "part.number" = { start = ... } below it.'),
        )
        if not data.get(key)
    ]
    collect(problems)
    circuit = _circuit(data, path.parent)
    settings, free_table = _search(data)
    measurements, roles = _measurements(data["recordings"], path.parent, circuit)
    free = _free(free_table, circuit, measurements, roles)
    every = [Experiment(circuit, m, free) for m in measurements]
    fitted = tuple(e for e, role in zip(every, roles, strict=True) if role == "fit")
    compared = tuple(e for e, role in zip(every, roles, strict=True) if role == "validation")
    if not fitted:
        raise InputError('use = "validation"', "holds for every recording.", "Leave one to fit.", address="recordings")
    title = str(data.get("title", circuit.title or path.stem))
    return FitPlan(fitted, free, compared, settings, title)


def _circuit(data: Mapping[str, Any], folder: Path) -> Circuit:
    try:
        circuit = load(folder / str(data["circuit"]))
    except InputError as error:
        raise relocated(error, lambda _: "circuit") from None
    try:
        return circuit.with_values(data.get("set", {}))
    except InputError as error:
        raise relocated(error, "set.{}".format) from None


def _search(data: Mapping[str, Any]) -> tuple[Settings, dict[str, Any]]:
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
                raise InputError(
                    f"{place}{key} = {table[key]!r}", f"is not {first} = {value!r}, and a fit has one search.",
                    "Write it once; it holds for all numbers.", address=f"{place}{key}",
                )  # fmt: skip
    for table in numbers.values():
        for key in SEARCH if isinstance(table, dict) else ():
            table.pop(key, None)
    try:
        return Settings(**{key: value for key, (value, _) in found.items()}), numbers
    except InputError as error:
        raise relocated(error, lambda key: found[key][1]) from None


def _measurements(tables: Any, folder: Path, circuit: Circuit) -> tuple[list[Any], list[str]]:
    problems: list[InputError] = []
    measurements, roles = [], []
    for name, table in tables.items():
        own = dict(table) if isinstance(table, Mapping) else table
        role = own.pop("use", "fit") if isinstance(own, dict) else "fit"
        if role not in ROLES:
            problems.append(
                InputError(
                    f"recordings.{name}.use = {role!r}", "is unknown.", suggestion(str(role), ROLES),
                    address=f"recordings.{name}.use",
                )
            )  # fmt: skip
        try:
            measurements.append(read_measurement(name, own, folder, ambient_pressure=circuit.surroundings.pressure))
            roles.append(role)
        except InputError as error:
            problems.append(error)
    collect(problems)
    return measurements, roles


def _free(tables: Any, circuit: Circuit, measurements: list[Any], roles: list[str]) -> tuple[Free, ...]:
    problems: list[InputError] = []
    found: list[Free] = []
    for address, table in tables.items():
        try:
            found.append(read_free(address, table, circuit))
        except InputError as error:
            problems.append(error)
    problems += [
        InputError(
            f"recordings.{m.name} is held out, but frees {what}:",
            "a recording that is only compared fits nothing.",
            'Give a value, or "first" for a start.',
            address=f"recordings.{m.name}",
        )
        for m, role in zip(measurements, roles, strict=True)
        if role == "validation"
        for what in _freed(m)
    ]
    collect(problems)
    return (*found, *recording_free(measurements, [circuit] * len(measurements), roles))


def _freed(measurement: Any) -> list[str]:
    """What a recording leaves free."""
    starts = [f"start of {address}" for address, given in measurement.start.items() if given == "free"]
    lags = [f"the lag of {item.address}" for item in (*measurement.channels, *measurement.inputs) if item.lag is None]
    return [*starts, *lags, *(f"the delay of {item.address}" for item in measurement.inputs if item.delay is None)]


def recording_free(measurements: Sequence[Any], circuits: Sequence[Circuit], roles: Sequence[str]) -> list[Free]:
    """Start values, lags and delays that recordings leave free."""
    found: list[Free] = []
    starting = [
        a
        for m, role in zip(measurements, roles, strict=True)
        if role == "fit"
        for a, g in m.start.items()
        if g == "free"
    ]
    for m, circuit in zip(measurements, circuits, strict=True):
        for address, given in m.start.items():
            if given == "free":
                name = address if starting.count(address) == 1 else f"{m.name}.{address}"
                found.append(_start_free(address, name, m, circuit))
        span, late = m.duration, LATEST * m.duration
        found += [
            Free(f"{m.name}.{c.address}.lag", c.address, "s", 0.02 * span, 0.0, span, "lag", m.name)
            for c in m.channels
            if c.lag is None
        ]
        found += [
            Free(f"{m.name}.{i.address}.delay", i.address, "s", 0.0, -late, late, "delay", m.name)
            for i in m.inputs
            if i.delay is None
        ]
        found += [
            Free(f"{m.name}.{i.address}.lag", i.address, "s", 0.01 * span, 0.0, span, "input_lag", m.name)
            for i in m.inputs
            if i.lag is None
        ]
    return found


def _start_free(address: str, name: str, measurement: Any, circuit: Circuit) -> Free:
    """A free start value begins at the first sample of its channel, where there is one."""
    owner, _, local = address.partition(".")
    resume = getattr(circuit.parts.get(owner), "resume", {})
    output = next((k for k, v in resume.items() if v == local), local)
    channel = next((c for c in measurement.channels if c.address == f"{owner}.{output}"), None)
    table = {"start": first_value(channel)} if channel is not None else {}
    return read_free(address, table, circuit, recording=measurement.name, name=name)

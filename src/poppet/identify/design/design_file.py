"""Design files: which numbers are wanted, which sensors there are, and which tests could be made."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from poppet.circuit.circuit import Circuit
from poppet.core.errors import ErrorCollector, InputError, InputErrors, NameSuggestion, relocated
from poppet.core.tables import Field, missing_field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.core.units import Kind
from poppet.identify.fit.fit_file import read_circuit
from poppet.identify.free_parameter import FreeParameter, read_free
from poppet.identify.result import Result, read_result

CRITERIA = ("intervals", "worst", "volume")
OWN = ("duration", "sample_time", "sensors", "start")
"""What a test has beside numbers and options of the circuit."""
TOP_LEVEL = {
    "circuit": Field(is_required=True, meaning="circuit file", example='circuit = "bench.toml"'),
    "free": Field(
        type="table",
        is_required=True,
        meaning="list of free parameters",
        example='[free] with "valve.critical_ratio" = 0.3',
    ),
    "sensors": Field(
        type="table",
        is_required=True,
        meaning="list of sensors",
        example='[sensors] with "tank.pressure" = { noise = "300 Pa" }',
    ),
    **dict.fromkeys(("tests", "vary", "set", "start"), Field(type="table")),
    "title": Field(type="text"),
    "known": Field(),
    "select": Field(type="integer", low=1, high=20, default=1, meaning="number of tests to select"),
    "draws": Field(type="integer", low=0, high=200, default=8, meaning="number of samples of the priors"),
    "seed": Field(type="integer", low=0, high=2**31, default=1),
    **dict.fromkeys(("duration", "sample_time"), Field(unit="s")),
    "criterion": Field(choices=CRITERIA, default=CRITERIA[0]),
}
MOST_TESTS = 500
"""Candidates of one file: each costs a run and one more for every number."""
MOST_SAMPLES = 100_000
_DIFFERENCE: dict[str, Kind] = {"Pa": "pressure_difference", "K": "temperature_difference"}


@dataclass(frozen=True)
class Sensor:
    """What can be recorded, and how well."""

    address: str
    unit: str
    noise: float  # one standard deviation of a sample, in `unit`
    offset: float = 0.0  # one standard deviation of its zero, in `unit`
    lag: float | None = 0.0  # time constant; None where it has to be learnt too [s]


@dataclass(frozen=True)
class Candidate:
    """A test that could be made."""

    name: str
    circuit: Circuit
    duration: float  # [s]
    sample_time: float  # [s]
    sensors: tuple[Sensor, ...]
    start: Mapping[str, Any] = field(default_factory=dict)  # initial values that would have to be learnt too: "free"

    @property
    def samples(self) -> int:
        """How many each sensor takes."""
        return max(2, math.floor(self.duration / self.sample_time * (1.0 + 1e-9)) + 1)


@dataclass(frozen=True)
class DesignPlan:
    """What shall be learnt, from which tests.

    Parameters
    ----------
    title : str
        For people.
    free : tuple of Free
        The numbers sought, where they are believed to be, and what is known of them.
    candidates : tuple of Candidate
        Tests that could be made.
    criterion : str
        `intervals`, `worst` or `volume`, see `Design`.
    select : int
        Number of tests to propose.
    draws, seed : int
        Values drawn from the priors at which the slopes are taken too, and the seed of the draws.
    known : Result, optional
        What an identification has found already.
    """

    title: str
    free: tuple[FreeParameter, ...]
    candidates: tuple[Candidate, ...]
    criterion: str = "intervals"
    select: int = 1
    draws: int = 8
    seed: int = 1
    known: Result | None = None


def read_design_file(path: str | Path) -> DesignPlan:
    """Read a design file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see `docs/identify.md`.

    Returns
    -------
    DesignPlan
        Everything read and checked, nothing simulated.

    Raises
    ------
    InputErrors
        With all mistakes, each with its line where it can be told.
    """
    file = TomlFile.read(path, "tests")
    with file.errors():
        return _plan(file)


def _plan(file: TomlFile) -> DesignPlan:
    with ErrorCollector() as errors:
        data = read_fields(errors, file.content, TOP_LEVEL, table="design file")
    circuit = read_circuit(data, file.folder)
    free: list[FreeParameter] = []
    sensors: dict[str, Sensor] = {}
    units = dict(circuit.instance.model.outputs)
    with ErrorCollector() as errors:
        for address, table in data["free"].items():
            with errors.collecting():
                free.append(read_free(address, table, circuit))
        for address, table in data["sensors"].items():
            with errors.collecting():
                sensors[address] = _sensor(address, table, units)
    with ErrorCollector() as errors:
        candidates = list(_candidates(errors, data, circuit, sensors))
    known = read_result(file.folder / str(data["known"])) if "known" in data else None
    title = str(data.get("title", circuit.title or Path(file.name).stem))
    options = {key: data[key] for key in ("criterion", "select", "draws", "seed")}
    return DesignPlan(title, tuple(free), tuple(candidates), **options, known=known)


def _sensor(address: str, table: Any, units: Mapping[str, str]) -> Sensor:
    place = f"sensors.{address}"
    if address not in units:
        raise InputError(
            "names.unknown", place, meaning="an output of this circuit", near=NameSuggestion(address, units)
        )
    unit = units[address]
    deviation = Field(unit=unit, kind=_DIFFERENCE.get(unit, "plain"), low=0.0, default=0.0)
    fields = {
        "noise": replace(
            deviation, above=0.0, default=None, is_required=True, meaning="standard deviation of a sample",
            example='noise = "300 Pa"',
        ),
        "offset": replace(deviation, meaning="standard deviation of the offset"),
        "lag": Field(unit="s", choices=("free",), low=0.0, default=0.0, meaning="time constant of the sensor"),
    }  # fmt: skip
    with ErrorCollector() as errors:
        read = read_fields(errors, table, fields, place, table="sensor")
    return Sensor(address, unit, read["noise"], read["offset"], None if read["lag"] == "free" else read["lag"])


def _candidates(
    errors: ErrorCollector, data: Mapping[str, Any], circuit: Circuit, sensors: Mapping[str, Sensor]
) -> Iterator[Candidate]:
    """Each named test with every combination of what is varied."""
    named: dict[str, Mapping[str, Any]] = {}
    for name, table in data.get("tests", {"": {}}).items():
        if isinstance(table, Mapping):
            named[name] = table
        else:
            errors.add("fields.no_table", f"tests.{name}", value=table)
    varied: Mapping[str, Any] = data.get("vary", {})
    for address, values in varied.items():
        if not isinstance(values, list) or not values:
            errors.add("design.no_list", f"vary.{address}", value=values)
            return
    combinations = list(itertools.product(*varied.values()))
    if len(named) * len(combinations) > MOST_TESTS:
        errors.add("design.too_many", "vary", count=len(named) * len(combinations), most=MOST_TESTS)
        return
    short = _short([*varied, *sensors])
    shared = {key: data[key] for key in ("duration", "sample_time", "start") if key in data}
    for (name, table), values in itertools.product(named.items(), combinations):
        given = dict(zip(varied, values, strict=True))
        label = ", ".join(
            filter(None, (name, *(f"{short[key]} {_shown(value, short)}" for key, value in given.items())))
        )
        place = f"tests.{name}" if name else "vary"
        with errors.collecting():
            yield _candidate(label or "the test", {**shared, **table, **given}, circuit, sensors, place)


def _candidate(
    label: str, given: Mapping[str, Any], circuit: Circuit, sensors: Mapping[str, Sensor], place: str
) -> Candidate:
    changes = {key: value for key, value in given.items() if key not in OWN}
    try:
        changed = circuit.with_values(changes) if changes else circuit
    except (InputError, InputErrors) as error:
        raise relocated(error, f"{place}.{{}}".format) from None
    duration = _time(given, "duration", place, changed.run.duration)
    sample_time = _time(given, "sample_time", place, duration / 200.0)
    chosen = given.get("sensors", list(sensors))
    chosen = [chosen] if isinstance(chosen, str) else chosen
    if not isinstance(chosen, Sequence) or not chosen:
        raise InputError("design.no_list", f"{place}.sensors", value=chosen)
    for address in chosen:
        if address not in sensors:
            raise InputError("design.no_sensor", f"{place}.sensors", near=NameSuggestion(str(address), sensors))
    start = given.get("start", {})
    for address, value in start.items() if isinstance(start, Mapping) else ():
        if value != "free":
            raise InputError("design.start", f"{place}.start.{address}", value=value)
    found = Candidate(label, changed, duration, sample_time, tuple(sensors[a] for a in chosen), dict(start))
    if found.samples > MOST_SAMPLES:
        raise InputError("design.too_many_samples", f"{place}.sample_time", count=found.samples, most=MOST_SAMPLES)
    return found


def _time(given: Mapping[str, Any], key: str, place: str, default: Any) -> float:
    field = Field(unit="s", above=0.0, meaning=key.replace("_", " "), example=f'{key} = "20 s"')
    if key in given:
        return float(field.read(given[key], f"{place}.{key}"))
    if default is None:
        raise missing_field(f"{place}.{key}", field)
    return float(default)


def _short(addresses: Sequence[str]) -> dict[str, str]:
    """What addresses are called: by their last word, where no other has the same."""
    last = [address.rpartition(".")[2] for address in addresses]
    return {a: word if last.count(word) == 1 else a for a, word in zip(addresses, last, strict=True)}


def _shown(value: Any, short: Mapping[str, str]) -> str:
    values = value if isinstance(value, list) else [value]
    return " + ".join(short.get(str(each), str(each)) for each in values)

"""Reader of design files, which contain free parameters, sensors and possible tests."""

from __future__ import annotations

import itertools
import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import ErrorCollector, InputError, InputErrors, NameSuggestion, relocated
from poppet.core.tables import Field, missing_field, read_fields
from poppet.core.toml_file import TomlFile
from poppet.identify.fit.fit_plan import CIRCUIT_FIELDS, read_circuit
from poppet.identify.free_parameter import FreeParameter, read_free
from poppet.identify.result import Result, read_result
from poppet.timeseries.measurements.mapping import DIFFERENCE_KINDS

CRITERIA = ("intervals", "worst", "volume")
OWN = ("duration", "sample_time", "sensors", "start")
"""Fields of a test that are not parameters or options of the circuit."""
TOP_LEVEL = {
    **CIRCUIT_FIELDS,
    "sensors": Field(
        type="table",
        is_required=True,
        meaning="list of sensors",
        example='[sensors] with "tank.pressure" = { noise = "300 Pa" }',
    ),
    **dict.fromkeys(("tests", "vary", "start"), Field(type="table")),
    "known": Field(),
    "select": Field(type="integer", low=1, high=20, default=1, meaning="number of tests to select"),
    "draws": Field(type="integer", low=0, high=200, default=8, meaning="number of samples of the priors"),
    "seed": Field(type="integer", low=0, high=2**31, default=1),
    "fits": Field(type="integer", low=0, high=200, meaning="number of simulated fits of the selected tests"),
    **dict.fromkeys(("duration", "sample_time"), Field(unit="s")),
    "criterion": Field(choices=CRITERIA, default=CRITERIA[0]),
}
MOST_TESTS = 500
"""Maximum number of candidates; each one needs one run, and one more per free parameter."""
MOST_SAMPLES = 100_000


@dataclass(frozen=True)
class DesignSensor:
    """Sensor that a possible test can use.

    `address` is the address of the measured output.
    """

    address: str
    unit: str
    noise: float  # standard deviation of a sample, in `unit`
    offset: float = 0.0  # standard deviation of the offset, in `unit`; infinite for a free offset without prior
    lag: float | None = 0.0  # time constant of the lag [s]; None if the lag is a free parameter


@dataclass(frozen=True)
class TestCandidate:
    """Test that the design of an experiment can recommend: a circuit, its sensors and a duration."""

    name: str
    circuit: BaseCircuit
    duration: float  # [s]
    sample_time: float  # [s]
    sensors: tuple[DesignSensor, ...]
    start: Mapping[str, Any] = field(default_factory=dict)  # free initial values: address to "free"

    @property
    def samples(self) -> int:
        """Number of samples of each sensor in the test."""
        return max(2, math.floor(self.duration / self.sample_time * (1.0 + 1e-9)) + 1)


@dataclass(frozen=True)
class DesignPlan:
    """Possible tests, and the free parameters that they must determine.

    Parameters
    ----------
    title : str
        Title of the design.
    free : tuple of FreeParameter
        Free parameters with their assumed values and priors.
    candidates : tuple of TestCandidate
        Possible tests.
    criterion : str
        `intervals`, `worst` or `volume`, see `Design`.
    select : int
        Number of recommended tests.
    draws, seed : int
        Number of samples of the priors, and the seed of their random numbers.
    known : Result, optional
        Result of an earlier identification, used as prior information.
    fits : int, optional
        Number of simulated fits of the recommended tests. If it is None, the number is 5, or 0 if a fit is slow.
    """

    title: str
    free: tuple[FreeParameter, ...]
    candidates: tuple[TestCandidate, ...]
    criterion: str = "intervals"
    select: int = 1
    draws: int = 8
    seed: int = 1
    known: Result | None = None
    fits: int | None = None


def read_design_file(path: str | Path) -> DesignPlan:
    """Read a design file.

    Parameters
    ----------
    path : str or Path
        A TOML file; see `docs/identify.md`.

    Returns
    -------
    DesignPlan
        Checked plan; nothing is simulated.

    Raises
    ------
    InputErrors
        If the file is invalid. The exception contains all errors, each with its line if available.
    """
    file = TomlFile.read(path, "tests")
    with file.errors():
        with ErrorCollector() as errors:
            data = read_fields(errors, file.content, TOP_LEVEL, table="design file")
        circuit = read_circuit(data, file.folder)
        free: list[FreeParameter] = []
        sensors: dict[str, DesignSensor] = {}
        with ErrorCollector() as errors:
            for address, table in data["free"].items():
                with errors.collecting():
                    free.append(read_free(address, table, circuit))
            for address, table in data["sensors"].items():
                with errors.collecting():
                    sensors[address] = _read_sensor(address, table, dict(circuit.instance.model.outputs))
        with ErrorCollector() as errors:
            candidates = tuple(_read_candidates(errors, data, circuit, sensors))
        known = read_result(file.folder / str(data["known"])) if "known" in data else None
        title = str(data.get("title", circuit.title or Path(file.name).stem))
        options = {key: data[key] for key in ("criterion", "select", "draws", "seed")}
        return DesignPlan(title, tuple(free), candidates, **options, known=known, fits=data.get("fits"))


def _read_sensor(address: str, table: Any, units: Mapping[str, str]) -> DesignSensor:
    location = f"sensors.{address}"
    if address not in units:
        near = NameSuggestion(address, units)
        raise InputError("names.unknown", location, meaning="an output of this circuit", suggestion=near)
    unit = units[address]
    deviation = Field(unit=unit, kind=DIFFERENCE_KINDS.get(unit, "plain"), low=0.0, default=0.0)
    fields = {
        "noise": replace(
            deviation, above=0.0, default=None, is_required=True, meaning="standard deviation of a sample",
            example='noise = "300 Pa"',
        ),
        "offset": replace(deviation, choices=("free",), meaning="standard deviation of the offset"),
        "lag": Field(unit="s", choices=("free",), low=0.0, default=0.0, meaning="time constant of the sensor"),
    }  # fmt: skip
    with ErrorCollector() as errors:
        read = read_fields(errors, table, fields, location, table="sensor")
    offset = math.inf if read["offset"] == "free" else read["offset"]
    return DesignSensor(address, unit, read["noise"], offset, None if read["lag"] == "free" else read["lag"])


def _read_candidates(
    errors: ErrorCollector, data: Mapping[str, Any], circuit: BaseCircuit, sensors: Mapping[str, DesignSensor]
) -> Iterator[TestCandidate]:
    """Yield a possible test for each combination of the varied values.

    `data` is the content of the design file, and `circuit` the circuit without these values.
    """
    tests: dict[str, Mapping[str, Any]] = {}
    for name, table in data.get("tests", {"": {}}).items():
        if isinstance(table, Mapping):
            tests[name] = table
        else:
            errors.add("fields.no_table", f"tests.{name}", value=table)
    varied: Mapping[str, Any] = data.get("vary", {})
    for address, values in varied.items():
        if not isinstance(values, list) or not values:
            errors.add("design.no_list", f"vary.{address}", value=values)
            return
    combinations = list(itertools.product(*varied.values()))
    if len(tests) * len(combinations) > MOST_TESTS:
        errors.add("design.too_many", "vary", count=len(tests) * len(combinations), most=MOST_TESTS)
        return
    addresses = [*varied, *sensors]
    last = [address.rpartition(".")[2] for address in addresses]
    # The last word of an address identifies it if it is unique.
    short = {a: ending if last.count(ending) == 1 else a for a, ending in zip(addresses, last, strict=True)}
    shared = {key: data[key] for key in ("duration", "sample_time", "start") if key in data}
    for (name, table), values in itertools.product(tests.items(), combinations):
        values_by_name = dict(zip(varied, values, strict=True))
        label = ", ".join(
            filter(None, (name, *(f"{short[key]} {_label(value, short)}" for key, value in values_by_name.items())))
        )
        location = f"tests.{name}" if name else "vary"
        with errors.collecting():
            yield _read_candidate(
                label or "the test", {**shared, **table, **values_by_name}, circuit, sensors, location
            )


def _read_candidate(
    label: str, fields: Mapping[str, Any], circuit: BaseCircuit, sensors: Mapping[str, DesignSensor], location: str
) -> TestCandidate:
    changes = {key: value for key, value in fields.items() if key not in OWN}
    try:
        changed = circuit.with_values(changes) if changes else circuit
    except (InputError, InputErrors) as error:
        raise relocated(error, f"{location}.{{}}".format) from None
    duration = _read_time(fields, "duration", location, changed.run.duration)
    sample_time = _read_time(fields, "sample_time", location, duration / 200.0)
    selected = fields.get("sensors", list(sensors))
    selected = [selected] if isinstance(selected, str) else selected
    if not isinstance(selected, Sequence) or not selected:
        raise InputError("design.no_list", f"{location}.sensors", value=selected)
    for address in selected:
        if address not in sensors:
            near = NameSuggestion(str(address), sensors)
            raise InputError(
                "fields.not_an_option", f"{location}.sensors", value=address, meaning="sensor", suggestion=near
            )
    start = fields.get("start", {})
    for address, value in start.items() if isinstance(start, Mapping) else ():
        if value != "free":
            raise InputError("design.start", f"{location}.start.{address}", value=value)
    candidate = TestCandidate(label, changed, duration, sample_time, tuple(sensors[a] for a in selected), dict(start))
    if candidate.samples > MOST_SAMPLES:
        raise InputError(
            "design.too_many_samples", f"{location}.sample_time", count=candidate.samples, most=MOST_SAMPLES
        )
    return candidate


def _read_time(fields: Mapping[str, Any], key: str, location: str, default: Any) -> float:
    field = Field(unit="s", above=0.0, meaning=key.replace("_", " "), example=f'{key} = "20 s"')
    if key in fields:
        return float(field.read(fields[key], f"{location}.{key}"))
    if default is None:
        raise missing_field(f"{location}.{key}", field)
    return float(default)


def _label(value: Any, short: Mapping[str, str]) -> str:
    values = value if isinstance(value, list) else [value]
    return " + ".join(short.get(str(item), str(item)) for item in values)

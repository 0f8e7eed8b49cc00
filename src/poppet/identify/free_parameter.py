"""Free parameters of a fit: parameters of the circuit, start values and sensor parameters."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.number_specs import number_specs
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.tables import Field, read_fields
from poppet.core.units import Kind

Role = Literal["number", "start", "lag", "input_lag", "delay", "offset", "dead_time"]
FIELDS = ("start", "min", "max", "prior")
LIMITS = FIELDS[:3]
_DIFFERENCE: dict[Kind, Kind] = {"pressure": "pressure_difference", "temperature": "temperature_difference"}


@dataclass(frozen=True)
class NormalPrior:
    """Normal prior distribution of a parameter.

    Parameters
    ----------
    mean, sd : float
        Mean and standard deviation, in the unit of the parameter.
    """

    mean: float
    sd: float


@dataclass(frozen=True)
class FreeParameter:
    """Parameter whose value a fit determines.

    Parameters
    ----------
    name : str
        Address in the result.
    address : str
        Address of the circuit parameter, or of the channel or input to which the lag, delay or offset belongs.
    unit : str
        SI unit.
    start : float
        Start value of the search.
    low, high : float
        Lower and upper bound; by default the limits that the part of the circuit declares.
    role : str
        `number` (parameter of the circuit), `start` (start value of a recording), `lag` (sensor lag of a channel),
        `input_lag` (sensor lag of an input), `delay` (delay of the recorded input), `offset` (of the sensor of a
        channel) or `dead_time` (delay of the effect of an input).
    recording : str
        Name of the only recording to which the parameter applies; empty if it applies to all recordings.
    prior : NormalPrior, optional
        Prior distribution.
    """

    name: str
    address: str
    unit: str
    start: float
    low: float = -math.inf
    high: float = math.inf
    role: Role = "number"
    recording: str = ""
    prior: NormalPrior | None = None

    @property
    def bounds(self) -> tuple[float, float]:
        """Lower and upper bound of the parameter."""
        return self.low, self.high

    @cached_property
    def scale(self) -> float:
        """Typical size of the parameter, which is never zero."""
        span = self.high - self.low
        span = span if math.isfinite(span) and span > 0.0 else 0.0
        # A start value that is tiny compared with the bounds is not a typical size.
        return max(abs(self.start), 1e-12 * span) if self.start != 0.0 else span or 1.0


def by_name(free: Sequence[FreeParameter], x: Iterable[float]) -> dict[str, float]:
    """Return a mapping from the name of each free parameter to its value in `x`.

    `x` contains the values in the order of `free`.
    """
    return {f.name: float(v) for f, v in zip(free, x, strict=True)}


def with_starts(free: Sequence[FreeParameter], x: Iterable[float]) -> tuple[FreeParameter, ...]:
    """Return copies of the free parameters with the start values `x`."""
    return tuple(replace(f, start=float(v)) for f, v in zip(free, x, strict=True))


def read_free(
    address: str, table: Any, circuit: BaseCircuit, *, recording: str = "", name: str = "", where: str = ""
) -> FreeParameter:
    """Read one free parameter from its table in an input file, or from its start value alone.

    `address` is the address of the circuit parameter. The keyword `where` is the location of the table in the file, for
    messages.
    """
    # Use the circuit, not its instance: the parts declare units and limits.
    numbers = circuit.numbers()
    # Exclude fields that a part sets in its members: a change of one alone would make them inconsistent.
    specs = {name: spec for name, spec in number_specs(circuit).items() if name in numbers}
    location = where or (f"recordings.{recording}.start.{address}" if recording else f"free.{address}")
    if address not in specs:
        near = NameSuggestion(address, specs)
        raise InputError("names.unknown", location, meaning="a parameter of this circuit", suggestion=near)
    spec, ambient = specs[address], circuit.surroundings.pressure
    fields = {key: Field(unit=spec.unit, kind=spec.kind) for key in LIMITS} | {"prior": Field()}
    raw = table if isinstance(table, Mapping) else {"start": table}
    with ErrorCollector() as errors:
        read = read_fields(errors, raw, fields, location, table="free parameter", ambient_pressure=ambient)
        moments: dict[str, float] = {}
        if (raw_prior := read.get("prior")) is not None:
            mean = replace(fields["start"], is_required=True, meaning="mean of the prior")
            kind, meaning = _DIFFERENCE.get(mean.kind, mean.kind), "standard deviation of the prior"
            prior_fields = {"mean": mean, "sd": replace(mean, kind=kind, above=0.0, meaning=meaning)}
            moments = read_fields(
                errors, raw_prior, prior_fields, f"{location}.prior", table="prior", ambient_pressure=ambient
            )
    start = read.get("start", numbers[address].absolute(ambient))
    low = read.get("min", max(spec.low, spec.above))
    high = read.get("max", min(spec.high, spec.below))
    if not low <= start <= high or low >= high:
        raise OutOfRangeError("free.bounds", location, start=start, low=low, high=high, unit=spec.unit)
    role: Role = "start" if recording else "number"
    prior = NormalPrior(**moments) if moments else None
    return FreeParameter(name or address, address, spec.unit, start, low, high, role, recording, prior)

"""Free parameters of a fit: of the circuit, of start values, of sensors."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any, Literal

from poppet.circuit.circuit import BaseCircuit
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.tables import Field, read_fields
from poppet.core.units import Kind
from poppet.parts.fields import NumberSpec, flatten

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
        Mean and standard deviation, in the unit of the number.
    """

    mean: float
    sd: float


@dataclass(frozen=True)
class FreeParameter:
    """Free parameter.

    Parameters
    ----------
    name : str
        Address in the result.
    address : str
        What it changes: an address of the circuit, or the channel or input whose lag or delay it is.
    unit : str
        SI unit.
    start : float
        Where the search begins.
    low, high : float
        Bounds; physical ones where none were given.
    role : str
        `number`, `start` (of one recording), `lag` (of a channel), `input_lag`, `delay` (by which an input was recorded
        late), `offset` (by which a channel reads too high) or `dead_time` (by which an input acts late).
    recording : str
        The recording it belongs to; empty when it is shared.
    prior : Prior, optional
        What was known before.
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
        """Lower and upper bound."""
        return self.low, self.high

    @cached_property
    def scale(self) -> float:
        """Typical size of the parameter, never zero."""
        span = self.high - self.low
        span = span if math.isfinite(span) and span > 0.0 else 0.0
        # A start that is nothing beside its bounds measures nothing either.
        return max(abs(self.start), 1e-12 * span) if self.start != 0.0 else span or 1.0


def by_name(free: Sequence[FreeParameter], x: Iterable[float]) -> dict[str, float]:
    """Return the values of free parameters by name."""
    return {f.name: float(v) for f, v in zip(free, x, strict=True)}


def with_starts(free: Sequence[FreeParameter], x: Iterable[float]) -> tuple[FreeParameter, ...]:
    """Return the free parameters with other start values."""
    return tuple(replace(f, start=float(v)) for f, v in zip(free, x, strict=True))


def number_specs(circuit: BaseCircuit) -> dict[str, NumberSpec]:
    """Return the declaration of every parameter of the parts by address."""
    declared = {f"{name}.{key}": spec for name, part in circuit.parts.items() for key, spec, _ in flatten(part)}
    for name, part in circuit.parts.items():
        for key, number in part.numbers().items():
            declared.setdefault(f"{name}.{key}", _coefficient_spec(key, number.unit))
    return declared


def _coefficient_spec(key: str, unit: str) -> NumberSpec:
    """Return the declaration of a coefficient of a characteristic.

    Tabulated values of C and b have limits.
    """
    match = re.search(r"\b(sonic_conductance|critical_ratio)\.(value|y\d+)$", key)
    if match is None:
        return NumberSpec(unit, f"coefficient {key}")
    return NumberSpec(unit, f"value {key}", low=0.0, below=1.0 if match[1] == "critical_ratio" else math.inf)


def read_free(
    address: str, table: Any, circuit: BaseCircuit, *, recording: str = "", name: str = "", where: str = ""
) -> FreeParameter:
    """Read a free parameter; `where` is its location in the file, for messages."""
    # Of a circuit, not of its instance: units and limits are declared by the parts.
    numbers = circuit.numbers()
    # What a part tells its members is no number of theirs: alone it would tear them apart.
    specs = {name: spec for name, spec in number_specs(circuit).items() if name in numbers}
    location = where or (f"recordings.{recording}.start.{address}" if recording else f"free.{address}")
    if address not in specs:
        near = NameSuggestion(address, specs)
        raise InputError("names.unknown", location, meaning="a parameter of this circuit", near=near)
    spec, ambient = specs[address], circuit.surroundings.pressure
    fields = {key: Field(unit=spec.unit, kind=spec.kind) for key in LIMITS} | {"prior": Field()}
    raw = table if isinstance(table, Mapping) else {"start": table}
    with ErrorCollector() as errors:
        read = read_fields(errors, raw, fields, location, table="free parameter", ambient_pressure=ambient)
        prior = _prior(errors, read.get("prior"), fields["start"], f"{location}.prior", ambient)
    start = read.get("start", numbers[address].absolute(ambient))
    low = read.get("min", max(spec.low, spec.above))
    high = read.get("max", min(spec.high, spec.below))
    if not low <= start <= high or low >= high:
        raise OutOfRangeError("free.bounds", location, start=start, low=low, high=high, unit=spec.unit)
    role: Role = "start" if recording else "number"
    return FreeParameter(
        name or address, address, spec.unit, start, low, high, role=role, recording=recording, prior=prior
    )


def _prior(errors: ErrorCollector, raw: Any, value: Field, location: str, ambient: float) -> NormalPrior | None:
    if raw is None:
        return None
    spread = replace(
        value,
        kind=_DIFFERENCE.get(value.kind, value.kind),
        is_required=True,
        above=0.0,
        meaning="standard deviation of the prior",
    )
    fields = {"mean": replace(value, is_required=True, meaning="mean of the prior"), "sd": spread}
    read = read_fields(errors, raw, fields, location, table="prior", ambient_pressure=ambient)
    if len(read) < 2:
        return None
    return NormalPrior(read["mean"], read["sd"])

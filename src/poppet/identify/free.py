"""Numbers that a fit may change: of the circuit, of a recording's start, of its sensors."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import Any, Literal

from poppet.circuit.circuit import Circuit
from poppet.ground.errors import InputError, OutOfRangeError, suggestion
from poppet.ground.units import quantity
from poppet.identify.result import behind
from poppet.parts.fields import NumberSpec, flatten

Role = Literal["number", "start", "lag", "input_lag", "delay", "offset", "dead_time"]
FIELDS = ("start", "min", "max", "prior")


@dataclass(frozen=True)
class Prior:
    """What was known before: a normal distribution.

    Parameters
    ----------
    mean, sd : float
        Mean and standard deviation, in the unit of the number.
    """

    mean: float
    sd: float


@dataclass(frozen=True)
class Free:
    """One free number.

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
    prior: Prior | None = None

    @property
    def scale(self) -> float:
        """A size to measure steps with, never zero."""
        if self.start != 0.0:
            return abs(self.start)
        span = self.high - self.low
        return span if math.isfinite(span) and span > 0.0 else 1.0


def number_specs(circuit: Circuit) -> dict[str, NumberSpec]:
    """Declaration of every number of the parts by its address."""
    found = {f"{name}.{key}": spec for name, part in circuit.parts.items() for key, spec, _ in flatten(part)}
    for name, part in circuit.parts.items():
        for key, number in part.numbers().items():
            found.setdefault(f"{name}.{key}", _coefficient_spec(key, number.unit))
    return found


def _coefficient_spec(key: str, unit: str) -> NumberSpec:
    """Declaration of a number of a characteristic; what is a value of C or b, not a coefficient, has its limits."""
    if re.search(r"\bsonic_conductance\.(value|y\d+)$", key):
        return NumberSpec(unit, f"value {key}", low=0.0)
    if re.search(r"\bcritical_ratio\.(value|y\d+)$", key):
        return NumberSpec(unit, f"value {key}", low=0.0, below=1.0)
    return NumberSpec(unit, f"coefficient {key}")


def read_free(address: str, table: Any, circuit: Circuit, *, recording: str = "", name: str = "") -> Free:
    """Read one entry of a fit's `[free]` table."""
    specs = number_specs(circuit)
    where = f"recordings.{recording}.start.{address}" if recording else f"free.{address}"
    if address not in specs:
        raise InputError(where, "is no number of this circuit.", suggestion(address, specs), address=where)
    if not isinstance(table, Mapping):
        table = {"start": table}
    unknown = [key for key in table if key not in FIELDS]
    if unknown:
        raise InputError(
            f"{where}.{unknown[0]}", "is not a field of a free number.", suggestion(unknown[0], FIELDS), address=where
        )  # fmt: skip
    try:
        free = _read(address, table, circuit, specs[address])
    except InputError as error:
        raise error.located(address=where) from None
    return replace(free, name=name or address, role="start", recording=recording) if recording else free


def _read(address: str, table: Mapping[str, Any], circuit: Circuit, spec: NumberSpec) -> Free:
    """A number that belongs to no recording, its fields known."""
    ambient = circuit.surroundings.pressure

    def si(given: Any, what: str, kind: Any = None) -> float:
        read = quantity(given, spec.unit, kind=kind or spec.kind, name=f"free.{address}.{what}")
        return read.value + (ambient if read.reference == "gauge" else 0.0)

    current = circuit.numbers()[address].absolute(ambient) if address in circuit.numbers() else 0.0
    start = si(table["start"], "start") if "start" in table else current
    low = si(table["min"], "min") if "min" in table else max(spec.low, spec.above)
    high = si(table["max"], "max") if "max" in table else min(spec.high, spec.below)
    if not low <= start <= high or low >= high:
        raise OutOfRangeError(
            f"free.{address}: start = {start:g}{behind(spec.unit)}",
            f"is not between the bounds {low:g} and {high:g}{behind(spec.unit)}.",
            "Correct start, min or max.",
        )
    prior = _prior(table.get("prior"), si, f"free.{address}.prior")
    return Free(address, address, spec.unit, start, low, high, prior=prior)


def _prior(table: Any, si: Any, name: str) -> Prior | None:
    if table is None:
        return None
    if not isinstance(table, Mapping) or set(table) != {"mean", "sd"}:
        raise InputError(f"{name} = {table!r}", "needs mean and sd.", "Write prior = { mean = ..., sd = ... }.")
    sd = si(table["sd"], "prior.sd")
    if not sd > 0.0:
        raise OutOfRangeError(f"{name}.sd = {sd:g}", "is not positive.", "Give the standard deviation.")
    return Prior(si(table["mean"], "prior.mean"), sd)

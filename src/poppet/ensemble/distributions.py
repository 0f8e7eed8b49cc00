"""Distributions of uncertain parameters: quantile function and cumulative probability."""

from __future__ import annotations

import importlib
import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from types import ModuleType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, raise_errors
from poppet.core.provenance import Number
from poppet.core.tables import Field, missing_field, read_fields
from poppet.core.units import Kind, quantity
from poppet.parts.fields import NumberSpec

Array = NDArray[np.float64]
MAX_INVALID_PROBABILITY = 1e-12
"""Maximum probability of invalid values: on average, one in 1e5 ensembles of 1e7 samples contains such a value."""
DIFFERENCE: dict[Kind, Kind] = {"pressure": "pressure_difference", "temperature": "temperature_difference"}
"""Mapping from the kind of a quantity to the kind of a difference of two such quantities."""


class DistributionKind(NamedTuple):
    """Kind of distribution, such as `normal`, with names of fields and functions.

    The second argument of both functions contains the values of the fields by name.
    """

    fields: tuple[str, ...]  # names of the fields that define the distribution
    spreads: tuple[str, ...]  # names of the fields with the unit of a difference
    factors: tuple[str, ...]  # names of the fields without a unit
    relative: str  # name of the field for a spread relative to the centre; empty if there is no such field
    quantile: Callable[[Array, Mapping[str, float]], Array]  # quantiles at the probabilities in the first argument
    below: Callable[[float, Mapping[str, float]], float]  # probability of values below the first argument

    @property
    def names(self) -> tuple[str, ...]:
        """Names of all fields that this kind of distribution can have in a circuit file."""
        return tuple(dict.fromkeys((*self.fields, *((self.relative,) if self.relative else ()), "low", "high")))


def _special() -> ModuleType:
    return importlib.import_module("scipy.special")  # slow to import


def _triangular(u: Array, n: Mapping[str, float]) -> Array:
    low, mode, high = n["low"], n["mode"], n["high"]
    left = low + np.sqrt(u * (high - low) * (mode - low))
    right = high - np.sqrt((1.0 - u) * (high - low) * (high - mode))
    return np.where(u * (high - low) < mode - low, left, right)


def _below_triangular(x: float, n: Mapping[str, float]) -> float:
    low, mode, high = n["low"], n["mode"], n["high"]
    if not low < x < high:
        return float(x >= high)
    if x < mode:
        return (x - low) ** 2 / ((high - low) * (mode - low))
    return 1.0 - (high - x) ** 2 / ((high - low) * (high - mode))


FORMS = {
    "normal": DistributionKind(
        ("mean", "sigma"), ("sigma",), (), "relative_sigma",
        lambda u, n: np.asarray(n["mean"] + n["sigma"] * _special().ndtri(u)),
        lambda x, n: float(_special().ndtr((x - n["mean"]) / n["sigma"])),
    ),
    "lognormal": DistributionKind(
        ("median", "log_sigma"), (), ("log_sigma",), "",
        lambda u, n: np.asarray(n["median"] * np.exp(n["log_sigma"] * _special().ndtri(u))),
        lambda x, n: 0.0 if x <= 0.0 else float(_special().ndtr(math.log(x / n["median"]) / n["log_sigma"])),
    ),
    "uniform": DistributionKind(
        ("low", "high"), (), (), "relative_range",
        lambda u, n: np.asarray(n["low"] + u * (n["high"] - n["low"])),
        lambda x, n: float(np.clip((x - n["low"]) / (n["high"] - n["low"]), 0.0, 1.0)),
    ),
    "triangular": DistributionKind(("low", "mode", "high"), (), (), "", _triangular, _below_triangular),
}  # fmt: skip
"""Distributions by the name in a file."""
MIDDLES = "mean", "median", "mode"
"""Fields whose default is the value of the parameter in the circuit."""


@dataclass(frozen=True)
class Distribution:
    """Distribution of a parameter, truncated to the range from `low` to `high`.

    All values are in SI units, and pressures and temperatures are absolute.
    """

    kind: str
    numbers: Mapping[str, float]
    low: float = -math.inf
    high: float = math.inf

    def below(self, x: float) -> float:
        """Return the probability of values below x."""
        (a, b), form = self._cut, FORMS[self.kind]
        return float(np.clip((form.below(x, self.numbers) - a) / (b - a), 0.0, 1.0))

    def quantile(self, u: Array) -> Array:
        """Return the quantiles of the truncated distribution at the probabilities `u`.

        The probabilities are between 0 and 1 (excluded).
        """
        a, b = self._cut
        # Rounding must not move a value outside the limits.
        return np.clip(FORMS[self.kind].quantile(a + u * (b - a), self.numbers), self.low, self.high)

    def within(self, low: float, high: float) -> Distribution:
        """Return the distribution, truncated to the range from `low` to `high`.

        The present limits also remain in force.
        """
        return Distribution(self.kind, self.numbers, max(low, self.low), min(high, self.high))

    def outside(self, low: float, high: float) -> float:
        """Return the probability of values outside the range from `low` to `high`."""
        return self.below(low) + (1.0 - self.below(high))

    @property
    def _cut(self) -> tuple[float, float]:
        below = FORMS[self.kind].below
        return below(self.low, self.numbers), below(self.high, self.numbers)


def read_distribution(raw: Any, spec: NumberSpec, number: Number, address: str, ambient: float) -> Distribution:
    """Read the distribution of one parameter from its table in a circuit file.

    `raw` is the table, and `spec` declares the unit and the valid range of the parameter. `number` is its value in the
    circuit, which is the default centre. `ambient` is the ambient pressure [Pa].
    """
    with ErrorCollector() as errors:
        if not isinstance(raw, Mapping):
            errors.add("fields.no_table", address, value=raw)
        elif raw.get("distribution") not in FORMS:
            kind = raw.get("distribution", "")
            near = NameSuggestion(str(kind), FORMS)
            facts = {"value": kind, "meaning": "distribution", "suggestion": near}
            errors.add("fields.not_an_option", f"{address}.distribution", **facts)
    kind = raw["distribution"]
    form, relative = FORMS[kind], FORMS[kind].relative
    factor, value = Field(unit="1"), Field(unit=spec.unit, kind=spec.kind)
    spread = Field(unit=spec.unit, kind=DIFFERENCE.get(spec.kind, spec.kind))
    units = {**dict.fromkeys((*form.factors, relative), factor), **dict.fromkeys(form.spreads, spread)}
    fields = {"distribution": Field(), **{key: units.get(key, value) for key in form.names}}
    with ErrorCollector() as errors:
        read = read_fields(errors, raw, fields, address, ambient_pressure=ambient)
    middle = number.absolute(ambient)
    if relative in read:
        # A relative field of a gauge pressure refers to the gauge value.
        written = quantity(raw["mean"], spec.unit, kind=spec.kind) if "mean" in read else number
        half = read.pop(relative) * abs(written.value)
        derived = {"sigma": half} if kind == "normal" else {"low": middle - half, "high": middle + half}
        if twice := [key for key in derived if key in read]:
            raise InputError("ensemble.given_twice", address, names=[relative, *twice])
        read |= derived
    read |= {key: middle for key in MIDDLES if key in form.fields and key not in read}
    raise_errors([missing_field(f"{address}.{key}", fields[key]) for key in form.fields if key not in read])
    numbers = {key: float(read[key]) for key in form.fields}
    _check(numbers, read, address)
    limits = (read.get("low", -math.inf), read.get("high", math.inf)) if "low" not in form.fields else (-np.inf, np.inf)
    return Distribution(kind, numbers, *limits)


def _check(numbers: Mapping[str, float], read: Mapping[str, Any], address: str) -> None:
    for key in ("sigma", "log_sigma"):
        if key in numbers and not numbers[key] > 0.0:
            raise InputError("ensemble.no_spread", f"{address}.{key}", value=numbers[key])
    low, high = read.get("low", -math.inf), read.get("high", math.inf)
    middle = [numbers[key] for key in MIDDLES if key in numbers]
    if not low < high or not all(low <= value <= high for value in middle):
        facts = {"low": low, "high": high, "middle": middle}
        raise InputError("ensemble.limits", address, **facts)

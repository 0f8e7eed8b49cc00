"""Metrics: one number of each run, from the rows of a series, of many runs at once."""

from __future__ import annotations

import hashlib
import inspect
import re
import runpy
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.core.tables import Field, read_fields
from poppet.core.units import Kind, convert, quantity

Array = NDArray[np.float64]
Function = Callable[..., float]

KINDS: dict[str, Kind] = {"Pa": "pressure", "K": "temperature", "kg/s": "mass_flow"}
"""What else a value of a series may be, by its SI unit."""
_INTEGRALS = {"kg/s": "kg", "m^3/s": "m^3", "W": "J", "1": "s", "m/s": "m", "m^3/s ANR": "m^3 ANR"}
"""SI unit of a series to that of its integral, where that is not the unit with an s behind it."""
MARKED = re.compile(r"(.*\S)\s+(ANR|N)")


@dataclass(frozen=True)
class Metric:
    """A number of a run."""

    name: str
    kind: str  # one of `WAYS`, or `function`
    of: tuple[str, ...]  # addresses of outputs; several for a function
    unit: str  # of the column
    source: str = ""  # SI unit in which it is worked out
    begin: float = 0.0  # of the rows that are looked at [s]
    end: float = np.inf
    value: float = np.nan  # level of `time_to`, absolute
    target: float | str = np.nan  # value or address of an output that a step aims at; NaN for where it ends
    band: float = 0.02  # part of a step within which it has settled
    function: Function | str = ""  # or where it stands, `ripple.py:ripple`
    folder: str = ""  # to which that refers

    @property
    def outputs(self) -> tuple[str, ...]:
        """Addresses of all outputs that it looks at."""
        return (*self.of, self.target) if isinstance(self.target, str) else self.of

    def facts(self) -> dict[str, Any]:
        """What decides its value, as plain values."""
        found = {key: value for key, value in vars(self).items() if key not in ("function", "folder")}
        return found | ({"function": self._print()} if self.kind == "function" else {})

    def _print(self) -> str:
        """What tells functions apart: their text, or where that is not known their compiled code."""
        function = self.callable()
        if isinstance(self.function, str):
            text = (Path(self.folder) / self.function.rpartition(":")[0]).read_text(encoding="utf-8")
        else:
            try:
                text = inspect.getsource(function)
            except (OSError, TypeError):
                code = getattr(function, "__code__", None)
                text = repr((code.co_code, code.co_consts, code.co_names)) if code else repr(function)
        return hashlib.sha256(text.encode()).hexdigest()

    def callable(self) -> Function:
        """The function of the user."""
        return _loaded(self.folder, self.function) if isinstance(self.function, str) else self.function

    def values(self, time: Array, series: Mapping[str, Array]) -> Array:
        """Of runs whose rows are at the same times, (m,); `series` has (m, n) values by address."""
        first, last = np.searchsorted(time, (self.begin, self.end), side="left")
        last += int(last < time.size and time[last] == self.end)
        rows = {address: series[address][:, first:last] for address in self.outputs}
        m = len(rows[self.of[0]])
        if last <= first:
            return np.full(m, np.nan)
        t = time[first:last]
        if self.kind == "function":
            return np.array([self._called(t, *(rows[a][k] for a in self.of)) for k in range(m)])
        found = WAYS[self.kind].reckon(t, rows[self.of[0]], self._aim(rows), self)
        return np.asarray(self.in_unit(found), dtype=np.float64)

    def _called(self, *series: Array) -> float:
        """What the function of the user makes of one run."""
        for view in series:
            # Other metrics look at the same rows.
            view.flags.writeable = False
        try:
            return float(self.callable()(*series))
        except InputError:
            raise
        except Exception as error:
            cause = f"{type(error).__name__}: {error}"
            raise InputError("ensemble.function_failed", f"ensemble.metrics.{self.name}", cause=cause) from error

    def _aim(self, rows: Mapping[str, Array]) -> Array:
        if isinstance(self.target, str):
            return rows[self.target][:, -1]
        y = rows[self.of[0]]
        return y[:, -1] if np.isnan(self.target) else np.full(len(y), self.target)

    def in_unit(self, found: Array) -> Array:
        """Values in SI, in the unit of the column."""
        marked = MARKED.fullmatch(self.unit)
        # A volume at a reference state is known to the units as a flow only.
        if marked and self.source == "kg":
            return np.asarray(convert(found, "kg/s", f"{marked[1]}/s {marked[2]}"))
        return found if self.unit == self.source else np.asarray(convert(found, self.source, self.unit))


class MetricKind(NamedTuple):
    """How a metric is worked out."""

    unit: Callable[[str], str]  # SI unit from that of the series
    fields: Mapping[str, Field]  # beside those of all metrics
    # from times (n,), values (m, n), the value that each run aims at, (m,), and the metric, to (m,)
    reckon: Callable[[Array, Array, Array, Metric], Array]
    meaning: str


def _same(unit: str) -> str:
    return unit


def _integral_unit(unit: str) -> str:
    return _INTEGRALS.get(unit, f"{unit} s")


def _integral(t: Array, y: Array) -> Array:
    # Sums along rows, not a product with weights: the bits of that would depend on how many rows stand together.
    return np.asarray((0.5 * (y[:, 1:] + y[:, :-1]) * np.diff(t)).sum(axis=1))


def _mean(t: Array, y: Array) -> Array:
    return np.asarray(y[:, 0] if t.size == 1 else _integral(t, y) / (t[-1] - t[0]))


def _share(y: Array, aim: Array) -> Array:
    """Values as parts of the step from the first one to the aim."""
    with np.errstate(divide="ignore", invalid="ignore"):
        return np.asarray((y - y[:, :1]) / (aim[:, np.newaxis] - y[:, :1]))


def _first(t: Array, y: Array, level: float) -> Array:
    """When a level is first passed, straight between rows [s]; infinite where it never is."""
    # Whichever side a run begins on.
    passed = np.where(y[:, :1] < level, y >= level, y <= level)
    k = passed.argmax(axis=1)
    each = np.arange(len(y))
    before = np.maximum(k - 1, 0)
    low, high = y[each, before], y[each, k]
    with np.errstate(divide="ignore", invalid="ignore"):
        part = np.where(k > 0, (level - low) / (high - low), 0.0)
        found = t[before] + part * (t[k] - t[before])
    return np.where(passed[each, k], found, np.inf)


def _time_to(t: Array, y: Array, aim: Array, own: Metric) -> Array:
    return np.asarray(_first(t, y, own.value) - t[0])


def _rise_time(t: Array, y: Array, aim: Array, own: Metric) -> Array:
    share = _share(y, aim)
    with np.errstate(invalid="ignore"):
        return np.asarray(_first(t, share, 0.9) - _first(t, share, 0.1))


def _settling_time(t: Array, y: Array, aim: Array, own: Metric) -> Array:
    error = np.abs(_share(y, aim) - 1.0)
    outside = ~(error <= own.band)
    # The last row outside, and the way from there into the band.
    k = t.size - 1 - outside[:, ::-1].argmax(axis=1)
    each, after = np.arange(len(y)), np.minimum(k + 1, t.size - 1)
    with np.errstate(divide="ignore", invalid="ignore"):
        part = (error[each, k] - own.band) / (error[each, k] - error[each, after])
        found = t[k] + part * (t[after] - t[k]) - t[0]
    found = np.where(k == t.size - 1, np.inf, found)
    found = np.where(outside.any(axis=1), found, 0.0)
    # Of no step no part is a band.
    return np.where(np.isnan(error[:, 0]), np.nan, found)


def _overshoot(t: Array, y: Array, aim: Array, own: Metric) -> Array:
    return np.asarray(np.maximum(_share(y, aim).max(axis=1) - 1.0, 0.0))


FUNCTION = r"^.+\.py:\w+$"
"""Pattern of a function of the user."""
SHARED = {
    "of": Field(meaning="address of an output"),
    "unit": Field(meaning="of the metric"),
    "from": Field(unit="s", meaning="first of the rows that are looked at"),
    "until": Field(unit="s", meaning="last of the rows that are looked at"),
}
"""Fields of all metrics."""
_LEVEL = {"value": Field(is_required=True, meaning="level that is passed")}
_TARGET = {"target": Field(meaning="value, or address of an output of which the last value counts")}
_SETTLING = _TARGET | {"band": Field(unit="1", meaning="part of the step within which it stays")}
WAYS = {
    "final": MetricKind(_same, {}, lambda t, y, aim, own: y[:, -1], "last value"),
    "mean": MetricKind(_same, {}, lambda t, y, aim, own: _mean(t, y), "mean over the time"),
    "min": MetricKind(_same, {}, lambda t, y, aim, own: y.min(axis=1), "least value"),
    "max": MetricKind(_same, {}, lambda t, y, aim, own: y.max(axis=1), "greatest value"),
    "integral": MetricKind(_integral_unit, {}, lambda t, y, aim, own: _integral(t, y), "integral over the time"),
    "rms": MetricKind(_same, {}, lambda t, y, aim, own: np.sqrt(_mean(t, y**2)), "root of the mean square"),
    "time_to": MetricKind(lambda unit: "s", _LEVEL, _time_to, "until a value is first passed"),
    "rise_time": MetricKind(lambda unit: "s", _TARGET, _rise_time, "from 10 to 90 % of the step"),
    "settling_time": MetricKind(lambda unit: "s", _SETTLING, _settling_time, "until it stays near its target"),
    "overshoot": MetricKind(lambda unit: "1", _TARGET, _overshoot, "beyond the target, as a part of the step"),
    "steady_error": MetricKind(_same, _TARGET, lambda t, y, aim, own: y[:, -1] - aim, "last value less the target"),
}
"""By the name that a file uses. Times count from the first row that is looked at; sums are trapezia."""


def read_metric(name: str, given: Any, outputs: Mapping[str, str], ambient: float, place: str, folder: str) -> Metric:
    """Read one metric; `outputs` has the SI unit of every output."""
    if callable(given):
        given = {"metric": given}
    with ErrorCollector() as errors:
        fields = {"metric": Field(), **SHARED, "value": Field(), **_SETTLING}
        read = read_fields(errors, given, fields, place)
        kind, is_own = read.get("metric", ""), False
        if callable(kind) or (isinstance(kind, str) and ":" in kind):
            is_own = True
        elif kind not in WAYS:
            errors.add("ensemble.metric", f"{place}.metric", value=str(kind), near=NameSuggestion(str(kind), WAYS))
        of = read.get("of", ())
        of = (of,) if isinstance(of, str) else tuple(map(str, of))
        if not of or (len(of) > 1 and not is_own):
            errors.add("ensemble.of", f"{place}.of", value=given.get("of", "") if isinstance(given, Mapping) else "")
        unknown = [address for address in of if address not in outputs]
        for address in unknown:
            errors.add("ensemble.output", f"{place}.of", value=address, near=NameSuggestion(address, outputs))
        misplaced = [key for key in ("value", "target", "band") if key in read and key not in _fields(kind, is_own)]
        for key in misplaced:
            errors.add("ensemble.not_of_metric", f"{place}.{key}", metric=str(kind))
    if is_own:
        function = kind if callable(kind) else str(kind)
        # A file is run when the runs begin, not when somebody looks at the tables.
        found = Metric(name, "function", of, str(read.get("unit", "1")), function=function, folder=folder)
    else:
        unit = WAYS[kind].unit(outputs[of[0]])
        found = Metric(name, kind, of, read.get("unit", "%" if kind == "overshoot" else unit), unit)
    with ErrorCollector() as errors:
        more = _read_more(errors, read, found, outputs, ambient, place)
        with errors.collecting():
            _check_unit(found, place)
    begin, end = read.get("from", 0.0), read.get("until", np.inf)
    if not 0.0 <= begin < end:
        raise InputError("ensemble.window", place, begin=begin, end=end)
    return Metric(**{**vars(found), **more, "begin": begin, "end": end})


def _fields(kind: Any, is_own: bool) -> Mapping[str, Field]:
    return {} if is_own or kind not in WAYS else WAYS[kind].fields


def _read_more(
    errors: ErrorCollector,
    read: Mapping[str, Any],
    own: Metric,
    outputs: Mapping[str, str],
    ambient: float,
    place: str,
) -> dict[str, Any]:
    """Level, target and band."""
    found: dict[str, Any] = {"band": read["band"]} if "band" in read else {}
    if own.kind == "time_to" and "value" not in read:
        errors.add("ensemble.no_value", place)
    unit = outputs.get(own.of[0], "1")
    for key in ("value", "target"):
        given = read.get(key)
        if key == "target" and isinstance(given, str) and given in outputs:
            found[key] = given
        elif given is not None:
            with errors.collecting():
                value = quantity(given, unit, kind=KINDS.get(unit, "plain"), name=f"{place}.{key}")
                found[key] = value.value + (ambient if value.reference == "gauge" else 0.0)
    return found


def _check_unit(own: Metric, place: str) -> None:
    if own.kind == "function":
        return
    try:
        shift = own.in_unit(np.zeros(1))[0]
        if shift and own.kind == "steady_error":  # a point of a scale is no difference
            raise InputError("quantity.point_of_scale", shown=own.unit)
    except InputError as error:
        raise error.at(f"{place}.unit") from None


@lru_cache(maxsize=64)
def _loaded(folder: str, where: str) -> Function:
    """A function of a file beside the circuit."""
    file, _, name = where.rpartition(":")
    path = Path(folder) / file
    if not path.is_file():
        raise InputError("ensemble.no_function", where, path=str(path), name=name)
    try:
        found = runpy.run_path(str(path)).get(name)
    except Exception as error:
        raise InputError("ensemble.function_failed", where, cause=f"{type(error).__name__}: {error}") from error
    if not callable(found):
        raise InputError("ensemble.no_function", where, path=str(path), name=name)
    return found  # type: ignore[no-any-return]

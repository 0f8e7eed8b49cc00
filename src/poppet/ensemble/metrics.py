"""Metrics of runs, and requirements on them such as `1 bar < peak <= 6.2 bar g`.

A metric is computed for many runs together.
"""

from __future__ import annotations

import hashlib
import inspect
import operator
import os
import re
import runpy
from collections.abc import Callable, Mapping
from contextlib import suppress
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
"""Mapping from the SI unit of an output to the kind of quantity."""
_INTEGRALS = {"kg/s": "kg", "m^3/s": "m^3", "W": "J", "1": "s", "m/s": "m", "m^3/s ANR": "m^3 ANR"}
"""Mapping from the SI unit of an output to the SI unit of its integral over time, if that has a shorter name."""
MARKED = re.compile(r"(.*\S)\s+(ANR|N)")
REST = 1e-9
"""Largest step of an output at rest relative to its largest value: a smaller one is noise of the solver."""


@dataclass(frozen=True)
class Metric:
    """Single value that is computed from the outputs of a run over time, such as a maximum."""

    name: str
    kind: str  # one of `WAYS`, or `function`
    of: tuple[str, ...]  # addresses of outputs; several for a function
    unit: str  # of the column
    source: str = ""  # SI unit of the computation
    begin: float = 0.0  # of the evaluated rows [s]
    end: float = np.inf
    value: float = np.nan  # level of `time_to`, absolute
    target: float | str = np.nan  # final value of a step, or address of an output; NaN for the last value
    band: float = 0.02  # settling band relative to the step
    function: Function | str = ""  # or its location, `ripple.py:ripple`
    folder: str = ""  # of the location

    @property
    def python_location(self) -> str:
        """Location of the Python function in a file, for example `ripple.py:ripple`, or an empty text."""
        return self.function if isinstance(self.function, str) else ""

    @property
    def outputs(self) -> tuple[str, ...]:
        """Addresses of all outputs from which the metric is computed."""
        return (*self.of, self.target) if isinstance(self.target, str) else self.of

    def facts(self) -> dict[str, Any]:
        """Return all settings of the metric as plain values by name.

        For a function of the user, they contain a hash of its code.
        """
        facts = {key: value for key, value in vars(self).items() if key not in ("function", "folder")}
        if self.kind != "function":
            return facts
        function = self.callable()
        if isinstance(self.function, str):
            text = python_file(self.folder, self.function).read_text(encoding="utf-8")
        else:
            try:
                text = inspect.getsource(function)
            except (OSError, TypeError):  # there is no source text
                code = getattr(function, "__code__", None)
                text = repr((code.co_code, code.co_consts, code.co_names)) if code else repr(function)
        return facts | {"function": hashlib.sha256(text.encode()).hexdigest()}

    def callable(self) -> Function:
        """Return the user's function that computes the metric, loaded from its file if necessary."""
        if not isinstance(self.function, str):
            return self.function
        path, name = python_file(self.folder, self.function), self.function.rpartition(":")[2]
        if not path.is_file():
            raise InputError("ensemble.no_function", self.function, path=str(path), name=name)
        status = path.stat()
        return _load_function(os.path.realpath(path), name, self.function, (status.st_mtime_ns, status.st_size))

    def values(self, time: Array, series: Mapping[str, Array]) -> Array:
        """Return the values of the metric for m runs with equal output times, (m,).

        `time` contains the n output times. `series` maps the address of each output to its values in all runs, (m, n).
        """
        first, last = np.searchsorted(time, (self.begin, self.end), side="left")
        last += int(last < time.size and time[last] == self.end)
        rows = {address: series[address][:, first:last] for address in self.outputs}
        y = rows[self.of[0]]
        values = np.full(len(y), np.nan)
        if last <= first:
            return values
        t = time[first:last]
        if self.kind != "function":
            if isinstance(self.target, str):
                aim = rows[self.target][:, -1]
            else:
                aim = y[:, -1] if np.isnan(self.target) else np.full(len(y), self.target)
            # Without a step or a crossing, the result is NaN or infinite.
            with np.errstate(divide="ignore", invalid="ignore"):
                return np.asarray(self.in_unit(METRIC_KINDS[self.kind].compute(t, y, aim, self)), dtype=np.float64)
        function = self.callable()
        for k in range(len(y)):
            arguments = [t, *(rows[address][k] for address in self.of)]
            for view in arguments:
                # Other metrics use the same rows.
                view.flags.writeable = False
            try:
                values[k] = float(function(*arguments))
            except InputError:
                raise
            except Exception as error:
                cause = f"{type(error).__name__}: {error}"
                raise InputError("ensemble.function_failed", f"ensemble.metrics.{self.name}", cause=cause) from error
        return values

    def in_unit(self, values: Array) -> Array:
        """Convert values of the metric from SI to the unit of the metric."""
        marked = MARKED.fullmatch(self.unit)
        # A volume at a reference state is converted as a flow.
        if marked and self.source == "kg":
            return np.asarray(convert(values, "kg/s", f"{marked[1]}/s {marked[2]}"))
        return values if self.unit == self.source else np.asarray(convert(values, self.source, self.unit))


class MetricKind(NamedTuple):
    """Kind of metric, such as a maximum: its unit, its additional fields and its formula."""

    unit: Callable[[str], str]  # SI unit from that of the output
    fields: Mapping[str, Field]  # in addition to those of all metrics
    # times (n,), values (m, n), target of each run (m,) and the metric, to (m,)
    compute: Callable[[Array, Array, Array, Metric], Array]
    meaning: str


def _same(unit: str) -> str:
    return unit


def _integral(t: Array, y: Array) -> Array:
    # Sum along rows: the rounding of a matrix product would depend on the number of rows.
    return np.asarray((0.5 * (y[:, 1:] + y[:, :-1]) * np.diff(t)).sum(axis=1))


def _mean(t: Array, y: Array) -> Array:
    return np.asarray(y[:, 0] if t.size == 1 else _integral(t, y) / (t[-1] - t[0]))


def _relative_step(y: Array, aim: Array) -> Array:
    """Return responses as fractions of their steps from the first value to the target, (m, n).

    Each row of `y`, (m, n), is a response. `aim`, (m,), contains its target. A response without a step is NaN.
    """
    step = aim - y[:, 0]
    step = np.where(np.abs(step) <= REST * np.abs(y).max(axis=1), np.nan, step)
    return np.asarray((y - y[:, :1]) / step[:, np.newaxis])


def _first_crossing(t: Array, y: Array, level: float) -> Array:
    """Return the time at which each response first reaches a level [s], (m,).

    Each row of `y`, (m, n), is a response at the times `t`, (n,). Times are interpolated between samples. The result is
    infinite for a response that does not reach the level.
    """
    # A run can start on either side.
    passed = np.where(y[:, :1] < level, y >= level, y <= level)
    k = passed.argmax(axis=1)
    runs = np.arange(len(y))
    previous = np.maximum(k - 1, 0)
    low, high = y[runs, previous], y[runs, k]
    fraction = np.where(k > 0, (level - low) / (high - low), 0.0)
    times = t[previous] + fraction * (t[k] - t[previous])
    return np.where(passed[runs, k], times, np.inf)


def _settling_time(t: Array, y: Array, aim: Array, metric: Metric) -> Array:
    error = np.abs(_relative_step(y, aim) - 1.0)
    is_outside = ~(error <= metric.band)
    # Interpolate from the last row outside the band.
    k = t.size - 1 - is_outside[:, ::-1].argmax(axis=1)
    runs, following = np.arange(len(y)), np.minimum(k + 1, t.size - 1)
    fraction = (error[runs, k] - metric.band) / (error[runs, k] - error[runs, following])
    times = t[k] + fraction * (t[following] - t[k]) - t[0]
    times = np.where(k == t.size - 1, np.inf, times)
    times = np.where(is_outside.any(axis=1), times, 0.0)
    # Without a step there is no band.
    return np.where(np.isnan(error[:, 0]), np.nan, times)


def _overshoot(t: Array, y: Array, aim: Array, metric: Metric) -> Array:
    return np.asarray(np.maximum(_relative_step(y, aim).max(axis=1) - 1.0, 0.0))


FUNCTION = r"^.+\.py:\w+$"
"""Pattern of the location of a function."""
SHARED = {
    "of": Field(meaning="address of an output"),
    "unit": Field(meaning="of the metric"),
    "from": Field(unit="s", meaning="start of the evaluated rows"),
    "until": Field(unit="s", meaning="end of the evaluated rows"),
}
"""Fields of all metrics."""
_LEVEL = {"value": Field(is_required=True, meaning="level")}
_TARGET = {"target": Field(meaning="value, or address of an output whose last value is the target")}
_SETTLING = _TARGET | {"band": Field(unit="1", meaning="settling band relative to the step")}
METRIC_KINDS = {
    "final": MetricKind(_same, {}, lambda t, y, aim, metric: y[:, -1], "last value"),
    "mean": MetricKind(_same, {}, lambda t, y, aim, metric: _mean(t, y), "mean over time"),
    "min": MetricKind(_same, {}, lambda t, y, aim, metric: y.min(axis=1), "minimum"),
    "max": MetricKind(_same, {}, lambda t, y, aim, metric: y.max(axis=1), "maximum"),
    "integral": MetricKind(
        lambda unit: _INTEGRALS.get(unit, f"{unit} s"), {}, lambda t, y, aim, metric: _integral(t, y),
        "integral over time",
    ),
    "rms": MetricKind(_same, {}, lambda t, y, aim, metric: np.sqrt(_mean(t, y**2)), "root mean square"),
    "time_to": MetricKind(
        lambda unit: "s", _LEVEL, lambda t, y, aim, metric: np.asarray(_first_crossing(t, y, metric.value) - t[0]),
        "time to the first crossing of a level",
    ),
    "rise_time": MetricKind(
        lambda unit: "s", _TARGET,
        lambda t, y, aim, metric: np.subtract(*(_first_crossing(t, _relative_step(y, aim), u) for u in (0.9, 0.1))),
        "time from 10 to 90 % of the step",
    ),
    "settling_time": MetricKind(lambda unit: "s", _SETTLING, _settling_time, "time until the output stays in the band"),
    "overshoot": MetricKind(lambda unit: "1", _TARGET, _overshoot, "maximum beyond the target, relative to the step"),
    "steady_error": MetricKind(_same, _TARGET, lambda t, y, aim, metric: y[:, -1] - aim, "last value minus target"),
}  # fmt: skip
"""Kinds of metrics by name. Times are counted from the first evaluated time; integrals use the trapezoidal rule."""


def read_metric(
    name: str,
    raw: Any,
    outputs: Mapping[str, str],
    ambient: float,
    address: str,
    folder: str,
    *,
    allow_python: bool = False,
) -> Metric:
    """Read one metric from its table in the circuit file.

    `raw` is the table, and `address` its address. `outputs` maps the address of each output of the circuit to its SI
    unit. `ambient` is the ambient pressure [Pa], and `folder` the folder of files with Python functions. Without the
    keyword `allow_python`, a Python file raises an error. This function does not execute it.
    """
    if callable(raw):
        raw = {"metric": raw}
    with ErrorCollector() as errors:
        fields = {"metric": Field(), **SHARED, "value": Field(), **_SETTLING}
        read = read_fields(errors, raw, fields, address)
        kind, is_own = read.get("metric", ""), False
        if callable(kind) or (isinstance(kind, str) and ":" in kind):
            is_own = True
            if isinstance(kind, str):
                with errors.collecting():
                    python_file(folder, kind, f"{address}.metric")
                    if not allow_python:
                        raise InputError("ensemble.python_forbidden", f"{address}.metric", location=kind)
        elif kind not in METRIC_KINDS:
            near = NameSuggestion(str(kind), METRIC_KINDS)
            errors.add("fields.not_an_option", f"{address}.metric", value=str(kind), meaning="metric", suggestion=near)
        addresses = read.get("of", ())
        addresses = (addresses,) if isinstance(addresses, str) else tuple(map(str, addresses))
        if not addresses or (len(addresses) > 1 and not is_own):
            errors.add("ensemble.of", f"{address}.of", value=raw.get("of", "") if isinstance(raw, Mapping) else "")
        for output in addresses:
            if output in outputs:
                continue
            near = NameSuggestion(output, outputs)
            errors.add("fields.not_an_option", f"{address}.of", value=output, meaning="output", suggestion=near)
        valid = METRIC_KINDS[kind].fields if not is_own and kind in METRIC_KINDS else ()
        for key in ("value", "target", "band"):
            if key in read and key not in valid:
                errors.add("ensemble.not_of_metric", f"{address}.{key}", metric=str(kind))
    if is_own:
        function = kind if callable(kind) else str(kind)
        # The file is executed when the runs start.
        metric = Metric(name, "function", addresses, str(read.get("unit", "1")), function=function, folder=folder)
    else:
        unit = METRIC_KINDS[kind].unit(outputs[addresses[0]])
        metric = Metric(name, kind, addresses, read.get("unit", "%" if kind == "overshoot" else unit), unit)
    # The additional fields: settling band, level and target.
    options: dict[str, Any] = {"band": read["band"]} if "band" in read else {}
    with ErrorCollector() as errors:
        if metric.kind == "time_to" and "value" not in read:
            errors.add("ensemble.no_value", address)
        level = Field(unit=outputs[addresses[0]], kind=KINDS.get(outputs[addresses[0]], "plain"))
        for key in ("value", "target"):
            raw = read.get(key)
            if key == "target" and isinstance(raw, str) and raw in outputs:
                options[key] = raw
            elif raw is not None:
                with errors.collecting():
                    options[key] = level.read(raw, f"{address}.{key}", ambient)
        with errors.collecting():
            _check_unit(metric, address)
    begin, end = read.get("from", 0.0), read.get("until", np.inf)
    if not 0.0 <= begin < end:
        raise InputError("ensemble.window", address, begin=begin, end=end)
    return Metric(**{**vars(metric), **options, "begin": begin, "end": end})


def _check_unit(metric: Metric, address: str) -> None:
    if metric.kind == "function":
        return
    try:
        shift = metric.in_unit(np.zeros(1))[0]
        if shift and metric.kind == "steady_error":  # an offset scale has no differences
            raise InputError("quantity.point_of_scale", shown=metric.unit)
    except InputError as error:
        raise error.at(f"{address}.unit") from None


def python_file(folder: str, location: str, address: str = "") -> Path:
    """Return the path of a Python file in the folder of the circuit or below it.

    `location` has the form `FILE.py:FUNCTION`. A file elsewhere, also by a symbolic link, raises an error.
    """
    path = Path(folder) / location.rpartition(":")[0]
    real = Path(os.path.realpath(path))
    if not real.is_relative_to(os.path.realpath(folder)):
        raise InputError("ensemble.python_elsewhere", address or location, location=location)
    return path


@lru_cache(maxsize=64)
def _load_function(path: str, name: str, location: str, version: tuple[int, int]) -> Function:
    """Load the Python function `name` from a file.

    `location` is the text of the circuit file. `version` contains time and size of the file: a changed file is loaded
    again.
    """
    try:
        function = runpy.run_path(path).get(name)
    except Exception as error:
        raise InputError("ensemble.function_failed", location, cause=f"{type(error).__name__}: {error}") from error
    if not callable(function):
        raise InputError("ensemble.no_function", location, path=path, name=name)
    return function  # type: ignore[no-any-return]


# --- Requirements ---

_SIGN = "<=|>=|<|>"
FORM = re.compile(rf"\s*(?:([^<>=]+?)\s*(<=|<)\s*)?([^\W\d]\w*)\s*({_SIGN})\s*([^<>=]+?)\s*")
_RELATIONS = {"<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge}
_MIRRORED = {"<": ">", "<=": ">="}


@dataclass(frozen=True)
class Requirement:
    """Bounds on a metric that a run must satisfy."""

    name: str
    text: str
    metric: str
    bounds: tuple[tuple[str, float], ...]  # relation and bound, in the unit of the metric; all must hold

    def met(self, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Return a boolean array: True for each metric value that meets the requirement.

        NaN does not meet it.
        """
        is_met = np.ones(values.shape, dtype=np.bool_)
        with np.errstate(invalid="ignore"):
            for relation, bound in self.bounds:
                is_met &= _RELATIONS[relation](values, bound)
        return is_met

    def margin(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the distance of each metric value to the nearest bound, in the unit of the metric.

        The distance is negative if the value violates a bound.
        """
        sides = [bound - values if relation[0] == "<" else values - bound for relation, bound in self.bounds]
        return np.asarray(np.min(sides, axis=0))


def read_requirement(name: str, text: Any, metrics: Mapping[str, Metric], ambient: float, address: str) -> Requirement:
    """Read one requirement from its text, for example `peak <= 6.2 bar g`.

    `metrics` contains the metrics of the ensemble by name, and `ambient` is the ambient pressure [Pa].
    """
    match = FORM.fullmatch(text) if isinstance(text, str) else None
    if match is None:
        raise InputError("ensemble.requirement", address, text=str(text))
    left, sign, metric_name, relation, right = match.groups()
    if metric_name not in metrics:
        near = NameSuggestion(metric_name, metrics)
        raise InputError("fields.not_an_option", address, value=metric_name, meaning="metric", suggestion=near)
    metric = metrics[metric_name]
    if left and relation[0] != "<":  # 1 < x > 2 bounds one side twice
        raise InputError("ensemble.requirement", address, text=text)
    unit = metric.source or metric.unit
    # A difference has no reference.
    kind: Kind = "plain" if metric.kind == "steady_error" else KINDS.get(unit, "plain")
    bounds = []
    for sense, raw in [(relation, right), *([(_MIRRORED[sign], left)] if left else [])]:
        try:
            if unit == "kg" and (marked := MARKED.fullmatch(raw)):
                # A volume at a reference state is converted as a flow.
                bound = quantity(f"{marked[1]}/s {marked[2]}", "kg/s", kind="mass_flow", name=address)
            else:
                # A bound without a unit is in SI units. Python would read 1_000.
                argument: str | float = raw
                with suppress(ValueError):
                    argument = raw if "_" in raw else float(raw)
                bound = quantity(argument, unit, kind=kind, name=address)
        except InputError as error:
            raise InputError("ensemble.bound", address, text=text, bound=raw, cause=error) from None
        value = bound.value + (ambient if bound.reference == "gauge" else 0.0)
        bounds.append((sense, float(metric.in_unit(np.array([value]))[0]) if metric.source else value))
    return Requirement(name, text, metric.name, tuple(bounds))

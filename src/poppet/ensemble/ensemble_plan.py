"""Plan of an ensemble: uncertain parameters, metrics and requirements, read from tables.

A plan has three kinds of runs: the random sample, the runs of a tornado chart, and those of Sobol indices.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.number_specs import number_specs
from poppet.circuit.options import Ambient, GasChoice
from poppet.core.codes import Note
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.tables import Field, read_fields
from poppet.core.units import convert, quantity
from poppet.ensemble.distributions import MAX_INVALID_PROBABILITY, Distribution, read_distribution
from poppet.ensemble.metrics import Metric, Requirement, read_metric, read_requirement
from poppet.ensemble.sampling import MAX_SOBOL, METHODS, points
from poppet.identify.result import Result, read_result
from poppet.parts.fields import NumberSpec, declared
from poppet.timeseries.tables.reading import read_table

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

KINDS = ("runs", "tornado", "indices")
"""Kinds of runs."""
LOW, HIGH = 0.05, 0.95
"""Low and high probability of the quantiles of a parameter in a tornado chart."""
STORED = ("metrics", "bands", "all")
"""Choices of stored data: metrics of each run, also quantile bands of outputs, or also complete outputs."""
LEVELS = 5
"""Default number of values per parameter in a grid."""
MAX_RUNS = 2**31
_SHARDS, _LEAST, _LEAST_SAMPLED, _MOST, _MOST_CURVES = 32, 512, 64, 16_384, 2_048
"""Intended number of shards, and limits of the number of runs in a shard.

The limits are: minimum, minimum with discrete states, maximum, maximum with stored curves. Writing a file takes as long
as hundreds of runs. Runs with discrete states take a hundred times longer than others.
"""
FIELDS = {
    "runs": Field(type="integer", low=1, high=MAX_RUNS, meaning="number of runs; set by the grid or the file"),
    "seed": Field(
        type="integer", low=0, high=2**63,
        meaning="seed of the random numbers; the same seed gives bit-identical results",
    ),
    "sampling": Field(choices=METHODS, meaning="sampling method"),
    "levels": Field(type="integer", low=1, high=1_000_000, meaning="of a grid: values per parameter"),
    "file": Field(meaning="of sampling = file: a table whose columns are addresses with units"),
    "keep": Field(choices=STORED, meaning="stored data"),
    "curves": Field(meaning="addresses of the outputs whose bands or curves are stored"),
    "indices": Field(type="integer", low=0, high=2**20, meaning="base sample size of the Sobol indices"),
    "parameters": Field(type="table"),
    "numbers": Field(type="table"),  # old name of `parameters`
    "metrics": Field(type="table"),
}  # fmt: skip
"""Fields of the table `ensemble`."""


@dataclass(frozen=True)
class JointNormal:
    """Joint normal distribution of several parameters that an identification has estimated."""

    file: str
    mean: tuple[float, ...]
    sigma: tuple[float, ...]
    factor: tuple[tuple[float, ...], ...]  # lower triangle L of the correlation L L'


@dataclass(frozen=True)
class EnsemblePlan:
    """All settings that determine the runs of an ensemble.

    A sample is an array with one row for each run and one column for each uncertain parameter. The columns of
    independent parameters (`alone`) come first. The columns of jointly distributed parameters (`joint`) follow.
    """

    circuit: BaseCircuit = field(repr=False)
    runs: int
    seed: int
    sampling: str
    alone: Mapping[str, Distribution]  # by address
    joint: tuple[str, ...] = ()  # addresses of the parameters of `joint_normal`
    joint_normal: JointNormal | None = None
    table: tuple[tuple[str, ...], Array] | None = None  # addresses and values, (runs, n), of a file
    levels: int = LEVELS
    metrics: tuple[Metric, ...] = ()
    requirements: tuple[Requirement, ...] = ()
    keep: str = "metrics"
    curves: tuple[str, ...] = ()  # addresses of the outputs with stored bands or curves
    indices: int = 0  # base sample size of Sobol indices, 0 for none
    notes: tuple[Note, ...] = ()  # on the tables

    @cached_property
    def addresses(self) -> tuple[str, ...]:
        """Addresses of the uncertain parameters, in the order of the columns of `sample`."""
        return self.table[0] if self.table else (*self.alone, *self.joint)

    @cached_property
    def factors(self) -> dict[str, tuple[int, ...]]:
        """Mapping from each independent factor to the indices of its columns in `sample`.

        A factor is one parameter, or all parameters of the joint distribution together.
        """
        factors = {address: (k,) for k, address in enumerate(self.alone)}
        n = len(self.alone)
        return factors | ({"from_fit": tuple(range(n, n + len(self.joint)))} if self.joint else {})

    def values(self, u: Array) -> Array:
        """Convert probabilities to parameter values, (m, n).

        `u`, (m, n), contains a probability between 0 and 1 for each run and parameter. The quantile function of the
        parameter converts it to a value. Jointly distributed parameters are also correlated.
        """
        values = np.empty_like(u)
        n = len(self.alone)
        for k, distribution in enumerate(self.alone.values()):
            values[:, k] = distribution.quantile(u[:, k])
        if self.joint_normal is not None:
            from scipy.special import ndtri

            joint_normal, z = self.joint_normal, ndtri(u[:, n:])
            for k, row in enumerate(joint_normal.factor):
                # The order of summation must not depend on the number of rows, as in a matrix product.
                total = np.zeros(len(u))
                for j in range(k + 1):
                    total += row[j] * z[:, j]
                values[:, n + k] = joint_normal.mean[k] + joint_normal.sigma[k] * total
        return values

    def counts(self, kind: str) -> tuple[int, int]:
        """Return the number of runs of one kind, and the number of runs per shard.

        `kind` is `runs` (random sample), `tornado` (one parameter at a time) or `indices` (sensitivity indices). A
        shard is a file with the results of some runs.
        """
        if kind == "runs":
            return self.runs, self.shard
        if kind == "tornado":
            return 2 * len(self.addresses) + 1, 1024
        return self.indices * (len(self.factors) + 2), min(self.shard, 4096)

    def sample(self, first: int, last: int, kind: str = "runs") -> Array:
        """Return the parameter values of the runs of one kind from `first` up to `last` (excluded).

        The first run of a tornado chart has the median of all parameters. Two further runs for each parameter have a
        low and a high quantile of it, with the medians of all other parameters.

        The runs for Sobol indices form blocks: A, B, and one block for each factor. The block of a factor is a copy of
        A with the columns of that factor from B. A and B are halves of one Sobol sequence of twice the dimension
        (Saltelli et al., Comput. Phys. Commun. 181, 2010).
        """
        n = len(self.addresses)
        if kind == "tornado":
            values = np.tile([self.quantile(address, 0.5) for address in self.addresses], (2 * n + 1, 1))
            for k, address in enumerate(self.addresses):
                values[1 + 2 * k, k], values[2 + 2 * k, k] = (self.quantile(address, u) for u in (LOW, HIGH))
            return values[first:last]
        if kind == "indices":
            runs = np.arange(first, last)
            block, row = runs // self.indices, runs % self.indices
            values = np.empty((runs.size, n))
            for block_index in np.unique(block):
                rows = row[block == block_index]
                # Another seed: the points must differ from those of the sample.
                ab = points("sobol", self.seed + 1, self.indices, 2 * n, int(rows[0]), int(rows[-1]) + 1, ())
                u = ab[:, n:].copy() if block_index == 1 else ab[:, :n].copy()
                if block_index >= 2:
                    columns = list(list(self.factors.values())[block_index - 2])
                    u[:, columns] = ab[:, n:][:, columns]
                values[block == block_index] = self.values(u)
            return values
        if self.table is not None:
            return self.table[1][first:last]
        return self.values(points(self.sampling, self.seed, self.runs, n, first, last, (self.levels,) * n))

    def quantile(self, address: str, u: float) -> float:
        """Return the quantile of one parameter at the probability `u`.

        If a file contains the parameter values, the result is the quantile of these values.
        """
        if self.table is not None:
            return float(np.quantile(self.table[1][:, self.table[0].index(address)], u))
        if address in self.alone:
            return float(self.alone[address].quantile(np.array([u]))[0])
        assert self.joint_normal is not None
        k = self.joint.index(address)
        return float(_normal(self.joint_normal.mean[k], self.joint_normal.sigma[k]).quantile(np.array([u]))[0])

    @property
    def python_functions(self) -> tuple[str, ...]:
        """Locations of all Python functions in files that compute metrics, such as `ripple.py:ripple`."""
        return tuple(dict.fromkeys(metric.python_location for metric in self.metrics if metric.python_location))

    @cached_property
    def shard(self) -> int:
        """Number of runs in each shard, which is a power of two.

        A shard is a file with the results of some runs. The number depends on the runs, on the stored data and on the
        circuit, but not on the computer.
        """
        max_runs = _MOST if self.keep == "metrics" else _MOST_CURVES
        min_runs = _LEAST_SAMPLED if self.circuit.model.memory else _LEAST
        return int(min(max_runs, max(min_runs, 2 ** round(math.log2(max(self.runs / _SHARDS, 1.0))))))

    @cached_property
    def outputs(self) -> tuple[str, ...]:
        """Addresses of the outputs that metrics, stored histograms or stored curves require."""
        addresses = [address for metric in self.metrics for address in metric.outputs]
        return tuple(dict.fromkeys([*addresses, *self.curves]))


def read_plan(
    circuit: BaseCircuit,
    ensemble: Any,
    requirements: Any,
    folder: Path,
    *,
    allow_python: bool = False,
    is_nominal: bool = False,
) -> EnsemblePlan:
    """Read the tables `ensemble` and `requirements` of a circuit, and report all errors together.

    `folder` is the folder to which file names in the tables refer. Without the keyword `allow_python`, Python functions
    in files raise an error. Reading a plan executes none of them. If the keyword `is_nominal` is True, the plan
    needs no uncertain parameters.
    """
    outputs = dict(circuit.model.outputs)
    ambient = circuit.surroundings.pressure
    with ErrorCollector() as errors:
        read = read_fields(errors, ensemble, FIELDS, "ensemble")
        indices = read.get("indices", 0)
        if indices & (indices - 1):
            errors.add("ensemble.power_of_two", "ensemble.indices", value=indices)
        grid = np.zeros(0)
        with errors.collecting():
            grid = circuit.run.grid()
        numbers = _ParameterReader(errors, circuit, read, folder, is_nominal)
        metrics: dict[str, Metric] = {}
        raw_metrics = read.get("metrics", {})
        for name, raw in raw_metrics.items():
            with errors.collecting():
                address = f"ensemble.metrics.{name}"
                identifier = _identifier(name, address, RESERVED)
                metric = read_metric(identifier, raw, outputs, ambient, address, str(folder), allow_python=allow_python)
                if grid.size:
                    window: dict[str, Any] = {"begin": metric.begin, "end": metric.end, "duration": float(grid[-1])}
                    if math.isfinite(metric.end) and metric.end > grid[-1] * (1.0 + 1e-9):
                        raise InputError("ensemble.beyond", address, **window)
                    if not ((grid >= metric.begin) & (grid <= metric.end)).any():
                        raise InputError("ensemble.no_rows", address, **window)
                metrics[name] = metric
        required = []
        if not isinstance(requirements, Mapping):
            errors.add("fields.no_table", "requirements", value=requirements)
            requirements = {}
        for name, text in requirements.items():
            address = f"requirements.{name}"
            try:
                required.append(read_requirement(_identifier(name, address, (ALL,)), text, metrics, ambient, address))
            except InputError as error:
                if error.code == "fields.not_an_option":
                    if error.facts["value"] in raw_metrics:  # an invalid metric is one error, not two
                        continue
                    error.facts["suggestion"] = NameSuggestion(error.facts["value"], raw_metrics)
                errors.extend([error])
        keep, curves = read.get("keep", "metrics"), read.get("curves", ())
        curves = (curves,) if isinstance(curves, str) else tuple(map(str, curves))
        for address in curves:
            if address not in outputs:
                near = NameSuggestion(address, outputs)
                errors.add("fields.not_an_option", "ensemble.curves", value=address, meaning="output", suggestion=near)
        if not curves and keep != "metrics":
            curves = tuple(dict.fromkeys(metric.of[0] for metric in metrics.values()))
        if not metrics and not curves:
            errors.add("ensemble.no_metric", "ensemble.metrics")
    notes = (Note("ensemble.old_numbers", "ensemble.numbers"),) if "numbers" in read else ()
    plan = EnsemblePlan(
        circuit, 0, read.get("seed", 0), numbers.sampling, numbers.alone, numbers.joint, numbers.normal, numbers.table,
        read.get("levels", LEVELS), tuple(metrics.values()), tuple(required), keep,
        curves if keep != "metrics" else (), indices, notes,
    )  # fmt: skip
    runs = read.get("runs")
    n = len(plan.addresses)
    fixed = plan.levels**n if plan.sampling == "grid" else len(plan.table[1]) if plan.table is not None else runs
    if fixed is None:
        raise InputError("ensemble.no_runs", "ensemble.runs")
    if runs is not None and runs != fixed:
        raise InputError("ensemble.runs_follow", "ensemble.runs", runs=runs, fixed=fixed, sampling=plan.sampling)
    replace(FIELDS["runs"], high=2**30 if plan.sampling == "sobol" else MAX_RUNS).read(fixed, "ensemble.runs")
    if plan.sampling == "sobol" and n > MAX_SOBOL:
        raise OutOfRangeError("ensemble.dimensions", "ensemble.sampling", dimensions=n, most=MAX_SOBOL)
    if plan.indices and plan.table is not None:
        raise InputError("ensemble.indices_of_file", "ensemble.indices")
    return replace(plan, runs=fixed)


RESERVED = ("run", "done", "outcome", "notes", "balance")
"""Columns of every dataset in addition to parameters and metrics; metrics cannot have these names."""
ALL = "all"
"""Name that stands for all requirements together; no requirement can have this name."""


def _identifier(name: str, address: str, reserved: tuple[str, ...]) -> str:
    # A name becomes a file name, so it must not contain a path.
    if not name.isidentifier():
        raise InputError("ensemble.name", address, name=name)
    if name in reserved:
        raise InputError("ensemble.name_taken", address, name=name)
    return name


class _ParameterReader:
    """Reader of the distributions of all uncertain parameters from the table `ensemble` of a circuit file."""

    def __init__(
        self, errors: ErrorCollector, circuit: BaseCircuit, read: Mapping[str, Any], folder: Path, is_nominal: bool
    ) -> None:
        self.circuit, self.folder, self.ambient = circuit, folder, circuit.surroundings.pressure
        key = "numbers" if "numbers" in read and "parameters" not in read else "parameters"
        self.address = f"ensemble.{key}"
        if {"numbers", "parameters"} <= read.keys():
            errors.add("ensemble.numbers_and_parameters", "ensemble.numbers")
        # An invalid method is reported elsewhere.
        self.sampling = read.get("sampling", "random")
        self.specs = varied_specs(circuit)
        self.given = circuit.numbers()
        self.alone: dict[str, Distribution] = {}
        self.joint: tuple[str, ...] = ()
        self.normal: JointNormal | None = None
        self.table: tuple[tuple[str, ...], Array] | None = None
        parameters = dict(read.get(key, {}))
        if self.sampling == "file":
            with errors.collecting():
                if not isinstance(read.get("file"), str):
                    raise InputError("ensemble.no_file", "ensemble.file")
                if parameters:
                    errors.add("ensemble.file_and_numbers", self.address)
                table = read_table(self.folder / read["file"])
                columns = []
                for k, (name, unit, column) in enumerate(zip(table.names, table.units, table.columns, strict=True)):
                    location = f"ensemble.file: {name}"
                    with errors.collecting():
                        if name in table.names[:k]:
                            raise InputError("ensemble.column_twice", location)
                        spec = self._spec(name, location)
                        columns.append(_in_si(column, unit, spec, location, self.ambient))
                if not table.names:
                    raise InputError("ensemble.no_columns", "ensemble.file", path=read["file"])
                if len(columns) == len(table.names):
                    self.table = tuple(table.names), np.column_stack(columns)
            return
        if "file" in read:
            errors.add("ensemble.not_of_file", "ensemble.file", sampling=self.sampling)
        fit = parameters.pop("from_fit", None)
        if not parameters and fit is None and not is_nominal:
            errors.add("ensemble.no_numbers", self.address)
        for address, raw in parameters.items():
            with errors.collecting():
                location = f"{self.address}.{address}"
                spec = self._spec(address, location)
                distribution = read_distribution(raw, spec, self.given[address], location, self.ambient)
                self.alone[address] = restrict_to_valid(distribution, spec, location)
        if fit is not None:
            with errors.collecting():
                self._of_fit(errors, fit, parameters)

    def _spec(self, address: str, location: str) -> NumberSpec:
        if address not in self.specs:
            near = NameSuggestion(address, self.specs)
            raise InputError("names.unknown", location, meaning="a parameter of this circuit", suggestion=near)
        if address in self.circuit.signals or address in self.circuit.connections:
            raise InputError("ensemble.driven", location)
        return self.specs[address]

    def _of_fit(self, errors: ErrorCollector, raw: Any, listed: Mapping[str, Any]) -> None:
        location = f"{self.address}.from_fit"
        if not isinstance(raw, str | Result):
            raise InputError("ensemble.no_fit", location, value=raw)
        result = read_result(self.folder / raw) if isinstance(raw, str) else raw
        # A listed parameter has its own distribution.
        names = [name for name in result.values() if name not in listed]
        if not names:
            raise InputError("ensemble.empty_fit", location, fit=str(raw))
        for name in names:
            estimate = result.parameters[name]
            with errors.collecting():
                spec = self._spec(name, location)
                sigma = estimate.standard_error
                if not math.isfinite(sigma) or not sigma > 0.0:
                    raise InputError("ensemble.undetermined", location, name=name, verdict=estimate.verdict)
                restrict_to_valid(_normal(estimate.value, sigma), spec, location, name)
        sigmas = tuple(result.parameters[name].standard_error for name in names)
        table = result.correlation
        matrix = np.eye(len(names))
        for i, a in enumerate(names):
            for j, b in enumerate(names):
                matrix[i, j] = 1.0 if a == b else table.get(a, {}).get(b, table.get(b, {}).get(a, 0.0))
        try:
            factor = np.linalg.cholesky(matrix)
        except np.linalg.LinAlgError:
            # Use the nearest positive definite matrix.
            values, vectors = np.linalg.eigh(matrix)
            nearest = (vectors * np.maximum(values, 1e-12)) @ vectors.T
            size = np.sqrt(np.diag(nearest))
            factor = np.linalg.cholesky(nearest / size / size[:, np.newaxis])
        means = tuple(result.parameters[name].value for name in names)
        title = raw if isinstance(raw, str) else raw.title
        self.joint = tuple(names)
        self.normal = JointNormal(title, means, sigmas, tuple(tuple(map(float, row)) for row in factor))


def varied_specs(circuit: BaseCircuit) -> dict[str, NumberSpec]:
    """Return the declarations of all parameters of a circuit that can be uncertain, by address.

    A declaration contains the unit and the valid range.
    """
    specs = number_specs(circuit)
    for owner, kind in (("ambient", Ambient), ("gas", GasChoice)):
        specs |= {f"{owner}.{name}": spec for name, _, spec in declared(kind, NumberSpec)}
    numbers = circuit.numbers()
    return {address: spec for address, spec in specs.items() if address in numbers}


def restrict_to_valid(distribution: Distribution, spec: NumberSpec, location: str, name: str = "") -> Distribution:
    """Truncate a distribution to the valid range of its parameter.

    `spec` declares this range. An error is raised if the probability of invalid values exceeds
    `MAX_INVALID_PROBABILITY`. `location` and `name` identify the parameter in its message.
    """
    low, high = spec.ends[0], min(spec.ends[1], spec.below)
    share = distribution.outside(low, high)
    if share > MAX_INVALID_PROBABILITY:
        facts: dict[str, Any] = {"probability": share, "limits": (low, high), "unit": spec.unit, "name": name}
        raise OutOfRangeError("ensemble.impossible", location, **facts, meaning=spec.meaning)
    return distribution.within(low, high)


def _normal(mean: float, sigma: float) -> Distribution:
    return Distribution("normal", {"mean": mean, "sigma": sigma})


def _in_si(column: Array, unit: str, spec: NumberSpec, location: str, ambient: float) -> Array:
    """Convert a column of parameter values from a file to SI units, and check all values.

    `unit` is the unit in the column heading, and `spec` declares the SI unit and the valid range. `ambient` is the
    ambient pressure [Pa], for gauge pressures. Invalid values raise an error.
    """
    if unit:
        # Check unit and reference once; convert the whole column.
        quantity(f"1 {unit}", spec.unit, kind=spec.kind, name=location)
        column = np.asarray(convert(column, unit, spec.unit, ambient_pressure=ambient))
    rows = np.flatnonzero([not spec.holds(float(value)) for value in column])
    if rows.size:
        facts: dict[str, Any] = {"row": int(rows[0]) + 1, "value": float(column[rows[0]]), "count": int(rows.size)}
        raise OutOfRangeError("ensemble.impossible_rows", location, **facts, unit=spec.unit, meaning=spec.meaning)
    return np.asarray(column, dtype=np.float64)

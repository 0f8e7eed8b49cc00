"""The plan of an ensemble: what is uncertain, what is measured of each run, what is required; read from tables."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import Circuit
from poppet.circuit.options import Ambient, GasChoice
from poppet.core.errors import ErrorCollector, InputError, NameSuggestion, OutOfRangeError
from poppet.core.tables import Field, read_fields
from poppet.ensemble.distributions import POSSIBLE, Distribution, read_distribution
from poppet.ensemble.metrics import Metric, read_metric
from poppet.ensemble.requirements import Requirement, read_requirement
from poppet.ensemble.sampling import MOST_SOBOL, WAYS, points
from poppet.identify.free_parameter import number_specs
from poppet.identify.result import Result, read_result
from poppet.parts.fields import NumberSpec, declared

Array = NDArray[np.float64]
Integers = NDArray[np.int64]

KEPT = ("metrics", "bands", "all")
"""What is kept of a run: its metrics; with all others together, bands of its curves; the curves themselves."""
LEVELS = 5
"""Values of each number in a grid."""
MOST_RUNS = 2**31
_SHARDS, _LEAST, _LEAST_SAMPLED, _MOST, _MOST_CURVES = 32, 512, 64, 16_384, 2_048
"""Shards of an ensemble, and the runs that a shard has at least and at most: a file costs as much as hundreds of
runs, but those with sampled memory, which take a hundred times as long."""
FIELDS = {
    "runs": Field(meaning="number of runs; a grid and a file have theirs"),
    "seed": Field(meaning="the same seed gives the same bits"),
    "sampling": Field(choices=WAYS, meaning="how numbers are drawn"),
    "levels": Field(meaning="of a grid: values of each number"),
    "file": Field(meaning="of sampling = file: a table whose columns are addresses with units"),
    "keep": Field(choices=KEPT, meaning="what is kept of the runs"),
    "curves": Field(meaning="addresses of the outputs whose bands or curves are kept"),
    "indices": Field(meaning="base of the Sobol indices"),
    "numbers": Field(type="table"),
    "metrics": Field(type="table"),
}
"""Fields of the table `ensemble`."""


@dataclass(frozen=True)
class JointNormal:
    """The joint normal distribution of an identification."""

    file: str
    mean: tuple[float, ...]
    sigma: tuple[float, ...]
    factor: tuple[tuple[float, ...], ...]  # lower triangle L of the correlation L L'


@dataclass(frozen=True)
class EnsemblePlan:
    """All that decides the bits of an ensemble. Columns of numbers: first those by themselves, then joint ones."""

    circuit: Circuit = field(repr=False)
    runs: int
    seed: int
    sampling: str
    alone: Mapping[str, Distribution]  # by address
    joint: tuple[str, ...] = ()  # addresses of what `joint_normal` distributes
    joint_normal: JointNormal | None = None
    table: tuple[tuple[str, ...], Array] | None = None  # addresses and values, (runs, n), where these come from a file
    levels: int = LEVELS
    metrics: tuple[Metric, ...] = ()
    requirements: tuple[Requirement, ...] = ()
    keep: str = "metrics"
    curves: tuple[str, ...] = ()  # addresses of the outputs of which bands or curves are kept
    indices: int = 0  # runs of the base sample of Sobol indices, 0 for none

    @cached_property
    def addresses(self) -> tuple[str, ...]:
        """Of the varied numbers, in the order of their columns."""
        return self.table[0] if self.table else (*self.alone, *self.joint)

    @cached_property
    def factors(self) -> dict[str, tuple[int, ...]]:
        """What is independent of one another, with its columns: each number by itself, the joint ones together."""
        found = {address: (k,) for k, address in enumerate(self.alone)}
        n = len(self.alone)
        return found | ({"from_fit": tuple(range(n, n + len(self.joint)))} if self.joint else {})

    def values(self, u: Array) -> Array:
        """Values of the numbers, (m, n), at points of the open unit cube."""
        found = np.empty_like(u)
        n = len(self.alone)
        for k, each in enumerate(self.alone.values()):
            found[:, k] = each.quantile(u[:, k])
        if self.joint_normal is not None:
            from scipy.special import ndtri

            own, z = self.joint_normal, ndtri(u[:, n:])
            for k, row in enumerate(own.factor):
                # Summed in one order, whatever the number of rows: a product of matrices may not be.
                total = np.zeros(len(u))
                for j in range(k + 1):
                    total += row[j] * z[:, j]
                found[:, n + k] = own.mean[k] + own.sigma[k] * total
        return found

    def sample(self, first: int, last: int) -> Array:
        """Values of some of the runs."""
        if self.table is not None:
            return self.table[1][first:last]
        n = len(self.addresses)
        return self.values(points(self.sampling, self.seed, self.runs, n, first, last, (self.levels,) * n))

    def quantile(self, address: str, u: float) -> float:
        """Quantile of one number by itself, in its sample where that is a table."""
        if self.table is not None:
            return float(np.quantile(self.table[1][:, self.table[0].index(address)], u))
        if address in self.alone:
            return float(self.alone[address].quantile(np.array([u]))[0])
        assert self.joint_normal is not None
        k = self.joint.index(address)
        return float(_normal(self.joint_normal.mean[k], self.joint_normal.sigma[k]).quantile(np.array([u]))[0])

    @cached_property
    def shard(self) -> int:
        """Runs of a shard: a power of two, from the number of runs and the kind of circuit alone."""
        most = _MOST if self.keep == "metrics" else _MOST_CURVES
        least = _LEAST_SAMPLED if self.circuit.model.memory else _LEAST
        return int(min(most, max(least, 2 ** round(math.log2(max(self.runs / _SHARDS, 1.0))))))

    @cached_property
    def outputs(self) -> tuple[str, ...]:
        """Addresses of the outputs that are looked at."""
        own = [address for metric in self.metrics for address in metric.outputs]
        return tuple(dict.fromkeys([*own, *self.curves]))


def read_plan(circuit: Circuit, ensemble: Any, requirements: Any, folder: Path) -> EnsemblePlan:
    """Read the tables of an ensemble; all mistakes at once."""
    outputs = dict(circuit.model.outputs)
    ambient = circuit.surroundings.pressure
    with ErrorCollector() as errors:
        read = read_fields(errors, ensemble, FIELDS, "ensemble")
        counts = {key: _whole(errors, read, key, *limits) for key, limits in COUNTS.items() if key in read}
        grid = np.zeros(0)
        with errors.collecting():
            grid = circuit.run.grid()
        numbers = _Numbers(errors, circuit, read, folder)
        metrics: dict[str, Metric] = {}
        for name, given in read.get("metrics", {}).items():
            with errors.collecting():
                place = f"ensemble.metrics.{name}"
                own = _identifier(name, place, TAKEN)
                found = read_metric(own, given, outputs, ambient, place, str(folder))
                metrics[name] = _check_rows(found, grid, place) if grid.size else found
        wanted = _requirements(errors, requirements, read.get("metrics", {}), metrics, ambient)
        keep, curves = read.get("keep", "metrics"), read.get("curves", ())
        curves = (curves,) if isinstance(curves, str) else tuple(map(str, curves))
        for address in curves:
            if address not in outputs:
                errors.add("ensemble.output", "ensemble.curves", value=address, near=NameSuggestion(address, outputs))
        if not curves and keep != "metrics":
            curves = tuple(dict.fromkeys(metric.of[0] for metric in metrics.values()))
        if not metrics and not curves:
            errors.add("ensemble.no_metric", "ensemble.metrics")
    plan = EnsemblePlan(
        circuit, counts.get("runs", 0), counts.get("seed", 0), numbers.sampling, numbers.alone, numbers.joint,
        numbers.normal, numbers.table, counts.get("levels", LEVELS), tuple(metrics.values()), tuple(wanted), keep,
        curves if keep != "metrics" else (), counts.get("indices", 0),
    )  # fmt: skip
    return _counted(plan, counts)


COUNTS = {"runs": (1, MOST_RUNS), "seed": (0, 2**63), "levels": (1, 1_000_000), "indices": (0, 2**20)}


def _whole(errors: ErrorCollector, read: Mapping[str, Any], key: str, low: int, high: int) -> int:
    value = read[key]
    if isinstance(value, bool) or not isinstance(value, int) or not low <= value <= high:
        errors.extend([OutOfRangeError("ensemble.count", f"ensemble.{key}", value=value, low=low, high=high)])
        return low
    if key == "indices" and value & (value - 1):
        errors.add("ensemble.power_of_two", "ensemble.indices", value=value)
    return value


TAKEN = ("run", "done", "outcome", "notes", "balance")
"""Columns that every dataset has beside its metrics."""
ALL = "all"
"""What all requirements together are called."""


def _identifier(name: str, place: str, taken: tuple[str, ...]) -> str:
    # Requirements name files, which must not lie elsewhere.
    if not name.isidentifier():
        raise InputError("ensemble.name", place, name=name)
    if name in taken:
        raise InputError("ensemble.name_taken", place, name=name)
    return name


def _check_rows(metric: Metric, grid: Array, place: str) -> Metric:
    """Refuse a time of which no row would be looked at, or that the run does not reach."""
    facts: dict[str, Any] = {"begin": metric.begin, "end": metric.end, "duration": float(grid[-1])}
    if math.isfinite(metric.end) and metric.end > grid[-1] * (1.0 + 1e-9):
        raise InputError("ensemble.beyond", place, **facts)
    if not ((grid >= metric.begin) & (grid <= metric.end)).any():
        raise InputError("ensemble.no_rows", place, **facts)
    return metric


def _requirements(
    errors: ErrorCollector, given: Any, named: Mapping[str, Any], metrics: Mapping[str, Metric], ambient: float
) -> list[Requirement]:
    found = []
    if not isinstance(given, Mapping):
        errors.add("fields.no_table", "requirements", value=given)
        return []
    for name, text in given.items():
        with errors.collecting():
            place = f"requirements.{name}"
            try:
                found.append(read_requirement(_identifier(name, place, (ALL,)), text, metrics, ambient, place))
            except InputError as error:
                # A metric with a mistake of its own is no second one.
                if error.code != "ensemble.unknown_metric" or error.facts["name"] not in named:
                    error.facts["near"] = NameSuggestion(error.facts.get("name", ""), named)
                    raise
    return found


def _counted(plan: EnsemblePlan, counts: Mapping[str, int]) -> EnsemblePlan:
    """The plan with the number of runs that its sampling has."""
    n, runs = len(plan.addresses), counts.get("runs")
    if plan.sampling == "grid":
        fixed = plan.levels**n
    elif plan.sampling == "file":
        assert plan.table is not None
        fixed = len(plan.table[1])
    elif runs is None:
        raise InputError("ensemble.no_runs", "ensemble.runs")
    else:
        fixed = runs
    if runs is not None and runs != fixed:
        raise InputError("ensemble.runs_follow", "ensemble.runs", runs=runs, fixed=fixed, sampling=plan.sampling)
    if fixed > (2**30 if plan.sampling == "sobol" else MOST_RUNS):
        raise OutOfRangeError("ensemble.count", "ensemble.runs", value=fixed, low=1, high=MOST_RUNS)
    if plan.sampling == "sobol" and n > MOST_SOBOL:
        raise OutOfRangeError("ensemble.dimensions", "ensemble.sampling", dimensions=n, most=MOST_SOBOL)
    if plan.indices and plan.table is not None:
        raise InputError("ensemble.indices_of_file", "ensemble.indices")
    return EnsemblePlan(**{**vars_of(plan), "runs": fixed})


def vars_of(plan: EnsemblePlan) -> dict[str, Any]:
    """Fields of a plan, without what it has worked out."""
    return {name: getattr(plan, name) for name in plan.__dataclass_fields__}


# --- Numbers ---


class _Numbers:
    """What is uncertain, as the tables say it."""

    def __init__(self, errors: ErrorCollector, circuit: Circuit, read: Mapping[str, Any], folder: Path) -> None:
        self.circuit, self.folder, self.ambient = circuit, folder, circuit.surroundings.pressure
        # A way that is misspelt is a mistake already.
        self.sampling = read.get("sampling", "random")
        self.specs = varied_specs(circuit)
        self.given = circuit.numbers()
        self.alone: dict[str, Distribution] = {}
        self.joint: tuple[str, ...] = ()
        self.normal: JointNormal | None = None
        self.table: tuple[tuple[str, ...], Array] | None = None
        numbers = dict(read.get("numbers", {}))
        if self.sampling == "file":
            with errors.collecting():
                self._of_file(errors, read, numbers)
            return
        if "file" in read:
            errors.add("ensemble.not_of_file", "ensemble.file", sampling=self.sampling)
        fit = numbers.pop("from_fit", None)
        if not numbers and fit is None:
            errors.add("ensemble.no_numbers", "ensemble.numbers")
        for address, given in numbers.items():
            with errors.collecting():
                self.alone[address] = self._one(address, given)
        if fit is not None:
            with errors.collecting():
                self._of_fit(errors, fit, numbers)

    def _spec(self, address: str, place: str) -> NumberSpec:
        if address not in self.specs:
            raise InputError("ensemble.number", place, near=NameSuggestion(address, self.specs))
        if address in self.circuit.signals or address in self.circuit.connections:
            raise InputError("ensemble.driven", place)
        return self.specs[address]

    def _one(self, address: str, given: Any) -> Distribution:
        place = f"ensemble.numbers.{address}"
        spec = self._spec(address, place)
        found = read_distribution(given, spec, self.given[address], place, self.ambient)
        return possible(found, spec, place)

    def _of_fit(self, errors: ErrorCollector, given: Any, alone: Mapping[str, Any]) -> None:
        place = "ensemble.numbers.from_fit"
        if not isinstance(given, str | Result):
            raise InputError("ensemble.no_fit", place, value=given)
        result = read_result(self.folder / given) if isinstance(given, str) else given
        # What is given a distribution of its own keeps that.
        names = [name for name in result.values() if name not in alone]
        if not names:
            raise InputError("ensemble.empty_fit", place, fit=str(given))
        for name in names:
            estimate = result.parameters[name]
            with errors.collecting():
                spec = self._spec(name, place)
                sigma = estimate.standard_error
                if not math.isfinite(sigma) or not sigma > 0.0:
                    raise InputError("ensemble.undetermined", place, name=name, verdict=estimate.verdict)
                possible(_normal(estimate.value, sigma), spec, place, name)
        sigmas = tuple(result.parameters[name].standard_error for name in names)
        rows = [[1.0 if a == b else _correlation(result, a, b) for b in names] for a in names]
        means = tuple(result.parameters[name].value for name in names)
        title = given if isinstance(given, str) else given.title
        self.joint = tuple(names)
        self.normal = JointNormal(title, means, sigmas, _factor(np.array(rows)))

    def _of_file(self, errors: ErrorCollector, read: Mapping[str, Any], numbers: Mapping[str, Any]) -> None:
        if not isinstance(read.get("file"), str):
            raise InputError("ensemble.no_file", "ensemble.file")
        if numbers:
            errors.add("ensemble.file_and_numbers", "ensemble.numbers")
        from poppet.timeseries.tables.reading import read_table

        table = read_table(self.folder / read["file"])
        columns = []
        for k, (name, unit, column) in enumerate(zip(table.names, table.units, table.columns, strict=True)):
            with errors.collecting():
                if name in table.names[:k]:
                    raise InputError("ensemble.column_twice", f"ensemble.file: {name}")
                spec = self._spec(name, f"ensemble.file: {name}")
                columns.append(_in_si(column, unit, spec, name, self.ambient))
        if not table.names:
            raise InputError("ensemble.no_columns", "ensemble.file", path=read["file"])
        if len(columns) == len(table.names):
            self.table = tuple(table.names), np.column_stack(columns)


def varied_specs(circuit: Circuit) -> dict[str, NumberSpec]:
    """Declaration of every number that may be uncertain."""
    found = number_specs(circuit)
    for owner, kind in (("ambient", Ambient), ("gas", GasChoice)):
        found |= {f"{owner}.{name}": spec for name, _, spec in declared(kind, NumberSpec)}
    own = circuit.numbers()
    return {address: spec for address, spec in found.items() if address in own}


def possible(found: Distribution, spec: NumberSpec, place: str, name: str = "") -> Distribution:
    """A distribution given that its value is possible; refused where it often is not."""
    low, high = spec.ends[0], min(spec.ends[1], spec.below)
    share = found.outside(low, high)
    if share > POSSIBLE:
        facts: dict[str, Any] = {
            "probability": share,
            "limits": (low, high),
            "unit": spec.unit,
            "meaning": spec.meaning,
        }
        raise OutOfRangeError("ensemble.impossible", place, **facts, name=name)
    return found.within(low, high)


def _normal(mean: float, sigma: float) -> Distribution:
    return Distribution("normal", {"mean": mean, "sigma": sigma})


def _correlation(result: Result, a: str, b: str) -> float:
    table = result.correlation
    return float(table.get(a, {}).get(b, table.get(b, {}).get(a, 0.0)))


def _factor(correlation: Array) -> tuple[tuple[float, ...], ...]:
    """Lower triangle of the Cholesky factor; where rounding has made it indefinite, of its nearest."""
    try:
        factor = np.linalg.cholesky(correlation)
    except np.linalg.LinAlgError:
        values, vectors = np.linalg.eigh(correlation)
        near = (vectors * np.maximum(values, 1e-12)) @ vectors.T
        size = np.sqrt(np.diag(near))
        factor = np.linalg.cholesky(near / size / size[:, np.newaxis])
    return tuple(tuple(map(float, row)) for row in factor)


def _in_si(column: Array, unit: str, spec: NumberSpec, name: str, ambient: float) -> Array:
    """A column of a table of numbers; all of its values must be possible."""
    from poppet.core.units import convert, quantity

    place = f"ensemble.file: {name}"
    if unit:
        # Read once as a quantity, which knows references; the column is converted as a whole.
        quantity(f"1 {unit}", spec.unit, kind=spec.kind, name=place)
        column = np.asarray(convert(column, unit, spec.unit, ambient_pressure=ambient))
    bad = np.flatnonzero([not spec.holds(float(value)) for value in column])
    if bad.size:
        facts: dict[str, Any] = {"row": int(bad[0]) + 1, "value": float(column[bad[0]]), "count": int(bad.size)}
        raise OutOfRangeError("ensemble.impossible_rows", place, **facts, unit=spec.unit, meaning=spec.meaning)
    return np.asarray(column, dtype=np.float64)

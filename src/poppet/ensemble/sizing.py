"""Smallest or largest value of a parameter that meets the requirements.

The requirements are met by a single run, or by a fraction of the runs of an ensemble.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, OutOfRangeError
from poppet.core.tables import Field
from poppet.core.toml import ResultFileMixin
from poppet.core.units import quantity
from poppet.ensemble.ensemble_plan import Array, EnsemblePlan, varied_specs
from poppet.ensemble.ensemble_result import plan_of, with_parameters
from poppet.ensemble.executors import Progress
from poppet.ensemble.metrics import Requirement
from poppet.ensemble.shards import PreparedPlan
from poppet.ensemble.statistics import wilson

POINTS = 65
"""Number of parameter values in the first evaluation, which cover the range."""
ROUNDS, PIECES = 4, 17
"""Number of refinement rounds, and of pieces into which each round divides the gap to the nearest failing value.

The final gap is 17^-4, about 1e-5, of the first gap.
"""
PEAKS, REFINEMENTS = 3, 6
"""Number of local maxima of the margin that are refined, and maximum number of refinements of each maximum.

A valid value can be between two failing ones. The final resolution is about 1e-6 of the value.
"""
DECADES = 2.0
"""Half width of the default range in decades: the range is centred on the value in the circuit."""
MAX_RUNS = 4_000_000


@dataclass(frozen=True)
class Sizing(ResultFileMixin):
    """Result of a sizing: value of the free parameter, margins and metrics.

    Parameters
    ----------
    title : str
        Title of the circuit.
    address, unit : str
        Free parameter and its SI unit.
    is_largest : bool
        True if the largest value was requested instead of the smallest.
    value : float
        Smallest or largest value that meets all requirements, with an accuracy of `resolution`. It is NaN if there is
        no such value.
    resolution : float
        Relative distance to the nearest failing value; 0 at an end of the range.
    share : float
        Required fraction of runs that meet the requirements. It is 1 for a single run.
    interval : tuple of float
        95 % interval of the fraction at `value` (Wilson); both limits are 1 for a single circuit.
    margins : mapping
        Mapping from each requirement to its margin at `value`, in the unit of its metric. For several runs, the margin
        is the quantile of `share`.
    limiting : str
        Requirement that fails at the next value; empty if there is none.
    size : float
        Next standard size. It is NaN if no sizes are given, or no size is valid.
    values : (n,) array
        All evaluated values in ascending order.
    shares : (n,) array
        Fraction of runs that meet the requirements at each value.
    metrics : mapping
        Mapping from each metric to its values, (n,). For several runs, each value is a mean.
    units : mapping
        Mapping from each metric to its unit.
    holding : tuple of pairs of float
        Intervals in which the requirements are met, at the resolution of `values`.
    requirements : mapping
        Mapping from the name of each requirement to its text.
    bounds : mapping
        Mapping from each metric to the bounds of the requirements, in the unit of the metric.
    runs : int
        Number of runs at each value.
    remarks : tuple of Note
        Notes on the result.
    """

    title: str
    address: str
    unit: str
    is_largest: bool
    value: float
    resolution: float
    share: float
    interval: tuple[float, float]
    margins: Mapping[str, float]
    limiting: str
    size: float
    values: Array = field(repr=False)
    shares: Array = field(repr=False)
    metrics: Mapping[str, Array] = field(repr=False)
    units: Mapping[str, str] = field(repr=False)
    holding: tuple[tuple[float, float], ...]
    requirements: Mapping[str, str]
    bounds: Mapping[str, tuple[float, ...]]
    runs: int = 1
    remarks: tuple[Note, ...] = ()

    @property
    def is_met(self) -> bool:
        """True if a value in the range meets the requirements."""
        return math.isfinite(self.value)

    def content(self) -> dict[str, Any]:
        """Return the content of the result file of a sizing as nested tables."""
        content = ("title", "address", "unit", "is_largest", "value", "resolution", "share", "limiting", "size")
        return {
            "method": "size",
            **{name: getattr(self, name) for name in content},
            "interval": list(self.interval),
            "holding": [list(pair) for pair in self.holding],
            "requirements": dict(self.requirements),
            "margins": dict(self.margins),
            "findings": [str(remark) for remark in self.remarks],
            "curve": {"values": self.values.tolist(), "shares": self.shares.tolist()},
            "metrics": {name: row.tolist() for name, row in self.metrics.items()},
            "units": dict(self.units),
        }


def size(
    circuit: BaseCircuit,
    free: str,
    *,
    meet: Sequence[str] = (),
    between: tuple[Any, Any] | None = None,
    largest: bool = False,
    share: float | None = None,
    sizes: Sequence[Any] = (),
    progress: Progress | None = None,
    allow_python: bool = False,
    **fields: Any,
) -> Sizing:
    """Find the smallest or largest value of a parameter that meets the requirements.

    Parameters
    ----------
    circuit : Circuit
        Circuit with the tables `ensemble` (metrics) and `requirements`, unless `fields` contains them.
    free : str
        Address of the parameter.
    meet : sequence of str, optional
        Names of the requirements (default: all).
    between : pair, optional
        Search range, as SI values or text with units. The default is two decades on either side of the value in the
        circuit, within the limits of the parameter.
    largest : bool, optional
        Find the largest value instead of the smallest.
    share : float, optional
        Required fraction of runs that meet the requirements, 0 to 1. By default, the circuit is run only once at each
        value.
    sizes : sequence, optional
        Standard sizes; the result contains the next one that is valid.
    progress : callable, optional
        Function that is called with the number of completed rounds, their total number, and a description.
    allow_python : bool, optional
        Permit metrics by Python functions in files, `FILE.py:FUNCTION`, which executes these files.
    **fields
        Fields of the table `ensemble`, and `requirements`; they replace the entries of the file.

    Returns
    -------
    Sizing
        Value, margins, and metrics versus the parameter.

    Raises
    ------
    InputError
        For an unknown name, an invalid range, or a fraction without distributions.

    Notes
    -----
    The first evaluation has 65 values, with logarithmic spacing in a positive range. Requirements need not be monotonic
    in the parameter: the three failing values with the largest local margins are refined, which finds narrow valid
    intervals between two values. Then the gap before the first valid value is divided. With a fraction, all values use
    the same random samples, so differences are due to the parameter. If the parameter is also uncertain, the value is
    the median of its samples, and their relative spread is constant.
    """
    fields = with_parameters(fields)
    spec = varied_specs(circuit).get(free)
    if spec is None:
        near = NameSuggestion(free, varied_specs(circuit))
        raise InputError("names.unknown", free, meaning="a parameter of this circuit", suggestion=near)
    if free in circuit.signals or free in circuit.connections:
        raise InputError("ensemble.driven", free)
    ambient = circuit.surroundings.pressure
    nominal = circuit.numbers()[free].absolute(ambient)

    def read_value(raw: Any, address: str) -> float:
        parsed = quantity(raw, spec.unit, kind=spec.kind, name=address)
        return parsed.value + (ambient if parsed.reference == "gauge" else 0.0)

    standard = np.unique([read_value(raw, "sizes") for raw in sizes])
    for value in standard.tolist():
        spec.check_range("sizes", value, f"{value:g}", spec.meaning)
    lowest, highest = max(spec.low, spec.above), min(spec.high, spec.below)
    if between is not None:
        low, high = (read_value(raw, "range") for raw in between)
        if not lowest <= low < high <= highest:
            raise OutOfRangeError("size.range", free, low=low, high=high, least=lowest, most=highest)
    elif nominal > 0.0:
        low = max(nominal * 10.0**-DECADES, lowest)
        high = nominal * 10.0**DECADES
        high = min(high, highest - 1e-9 * nominal if math.isfinite(highest) else high)
    else:
        raise InputError("size.no_range", free)
    fields["allow_python"] = allow_python
    uncertain = plan_of(circuit, **fields) if share is not None else None
    if share is not None:
        Field(unit="1", above=0.0, below=1.0, meaning="required fraction").read(share, "share")
    sweep: dict[str, Any] = {"parameters": {free: {"distribution": "uniform", "low": low, "high": high}}, "runs": 1}
    plan = plan_of(circuit, **{**fields, **sweep, "sampling": "random", "keep": "metrics", "indices": 0})
    requirements = {requirement.name: requirement for requirement in plan.requirements}
    for name in meet:
        if name not in requirements:
            raise InputError(
                "names.unknown", name, meaning="a requirement", suggestion=NameSuggestion(name, requirements)
            )
    if not requirements:
        raise InputError("size.no_requirement", "requirements")
    selected = tuple(requirements[name] for name in dict.fromkeys(meet or requirements))
    evaluator = _Evaluator(circuit, plan, selected, free, nominal, uncertain, share or 1.0)
    first = np.geomspace(low, high, POINTS) if low > 0.0 else np.linspace(low, high, POINTS)
    results = evaluator.evaluate(first, progress, 0)
    results = _refine_peaks(evaluator, results, largest, progress)
    for round_index in range(ROUNDS):
        holds = _meets_requirements(results, evaluator.share)
        # The valid value at the end of the valid range, and the neighbouring failing value.
        k = int(np.flatnonzero(holds)[-1 if largest else 0]) if holds.any() else -1
        neighbour = k + 1 if largest else k - 1
        if k < 0 or not 0 <= neighbour < len(holds):
            break
        inner = np.linspace(results.values[k], results.values[neighbour], PIECES + 1)[1:-1]
        results = results.joined(evaluator.evaluate(inner, progress, round_index + 1))
    return _make_sizing(circuit, evaluator, results, standard, largest)


@dataclass(frozen=True)
class _Evaluations:
    """Results of all runs at several values of the parameter to be sized.

    The values are in ascending order.
    """

    values: Array
    shares: Array
    metrics: Array  # (n, n_metrics)
    margins: Array  # (n, n_requirements)
    worst: Array  # (n,) minimum of all margins relative to their bounds, for the run at the quantile

    def joined(self, other: _Evaluations) -> _Evaluations:
        order = np.argsort(np.concatenate([self.values, other.values]), kind="stable")
        rows = (np.concatenate(pair)[order] for pair in zip(vars(self).values(), vars(other).values(), strict=True))
        return _Evaluations(*rows)


class _Evaluator:
    """Function object that runs a circuit at values of the parameter to be sized.

    It returns the metrics of the runs, and the margins to the requirements.
    """

    def __init__(
        self,
        circuit: BaseCircuit,
        sweep: EnsemblePlan,
        requirements: tuple[Requirement, ...],
        free: str,
        nominal: float,
        uncertain: EnsemblePlan | None,
        share: float,
    ) -> None:
        self.plan, self.requirements, self.share = sweep, requirements, share
        names = [metric.name for metric in sweep.metrics]
        self.columns = [names.index(requirement.metric) for requirement in requirements]
        # Scales for the comparison of margins with different units.
        self.sizes = np.array([max(abs(bound) for _, bound in r.bounds) or 1.0 for r in requirements])
        if uncertain is None:
            self._ready, self.draws, self._column = PreparedPlan(sweep), np.ones((1, 1)), 0
            return
        draws = uncertain.sample(0, uncertain.runs)
        addresses = uncertain.addresses
        if uncertain.runs * (POINTS + ROUNDS * PIECES) > MAX_RUNS:
            raise InputError("size.too_many", "ensemble.runs", runs=uncertain.runs, most=MAX_RUNS // 200)
        # A parameter that is also uncertain keeps its relative spread.
        if free in addresses:
            median = uncertain.quantile(free, 0.5)
            if not median:
                raise InputError("size.about_zero", free)
            self._column, draws = addresses.index(free), draws.copy()
            draws[:, self._column] /= median
        else:
            self._column = len(addresses)
            draws, addresses = np.column_stack([draws, np.ones(len(draws))]), (*addresses, free)
        self.draws = draws
        table = replace(uncertain, sampling="file", table=(addresses, self._with(nominal)), alone={}, joint=())
        self._ready = PreparedPlan(replace(table, joint_normal=None, keep="metrics", curves=(), metrics=sweep.metrics))

    def _with(self, value: float) -> Array:
        draws = self.draws.copy()
        draws[:, self._column] *= value
        return draws

    def evaluate(self, values: Array, progress: Progress | None, round_index: int) -> _Evaluations:
        if progress is not None:
            progress(round_index, ROUNDS + 1, f"{len(values)} values")
        runs = len(self.draws)
        results = self._ready.run(np.concatenate([self._with(value) for value in values])).metrics
        metrics = results.reshape(len(values), runs, -1)
        met = np.ones((len(values), runs), dtype=np.bool_)
        margins = np.empty((len(values), len(self.requirements)))
        worst = np.full((len(values), runs), np.inf)
        # Index of the worst run that must not fail.
        decides = runs - math.ceil(self.share * runs - 1e-9)
        for k, (requirement, column) in enumerate(zip(self.requirements, self.columns, strict=True)):
            met &= requirement.met(metrics[:, :, column])
            margin = np.where(np.isnan(metrics[:, :, column]), -np.inf, requirement.margin(metrics[:, :, column]))
            worst = np.minimum(worst, margin / self.sizes[k])
            margins[:, k] = np.sort(margin, axis=1)[:, decides]
        worst = np.sort(worst, axis=1)[:, decides]
        return _Evaluations(np.asarray(values), met.mean(axis=1), metrics.mean(axis=1), margins, worst)


def _meets_requirements(results: _Evaluations, share: float) -> NDArray[np.bool_]:
    return results.shares >= share - 1e-12


def _refine_peaks(
    evaluator: _Evaluator, results: _Evaluations, largest: bool, progress: Progress | None
) -> _Evaluations:
    """Search near local maxima of the margin for a parameter value that meets all requirements.

    The result contains `results` and the new evaluations. The search begins at the largest margin, and its number of
    rounds is limited. If values that meet the requirements are known, only maxima below the smallest of them are
    refined; if `largest` is True, only maxima above the largest.
    """
    holds, worst = np.flatnonzero(_meets_requirements(results, evaluator.share)), results.worst
    left, right = np.append(-np.inf, worst[:-1]), np.append(worst[1:], -np.inf)
    is_peak = np.isfinite(worst) & (worst >= left) & (worst >= right) & (worst > np.minimum(left, right))
    if holds.size:
        is_peak[: holds[-1] + 1] &= not largest
        is_peak[holds[0] :] &= largest
    indices = np.flatnonzero(is_peak)
    peaks = indices[np.argsort(-worst[indices], kind="stable")][:PEAKS]
    for value in results.values[peaks].tolist():
        for _ in range(REFINEMENTS):
            k = int(np.searchsorted(results.values, value))
            low, high = results.values[max(k - 1, 0)], results.values[min(k + 1, len(results.values) - 1)]
            inner = np.setdiff1d(np.linspace(low, high, PIECES + 1)[1:-1], results.values)
            refined = evaluator.evaluate(inner, progress, 0)
            previous, results = results.worst[k], results.joined(refined)
            best = int(np.argmax(refined.worst))
            if _meets_requirements(refined, evaluator.share).any():
                break
            if refined.worst[best] > previous:
                value = float(refined.values[best])
            elif value in (low, high):  # an end of the range
                break
    return results


def _make_sizing(
    circuit: BaseCircuit, evaluator: _Evaluator, results: _Evaluations, standard: Array, largest: bool
) -> Sizing:
    plan, share = evaluator.plan, evaluator.share
    free = plan.addresses[0]
    holds = _meets_requirements(results, share)
    edges = np.flatnonzero(np.diff(holds.astype(int), prepend=0, append=0))
    pairs = zip(edges[::2], edges[1::2], strict=True)
    intervals = tuple((float(results.values[a]), float(results.values[b - 1])) for a, b in pairs)
    unit = varied_specs(circuit)[free].unit
    bounds: dict[str, tuple[float, ...]] = {}
    for r in evaluator.requirements:
        bounds[r.metric] = (*bounds.get(r.metric, ()), *(bound for _, bound in r.bounds))
    functions = plan.python_functions
    remarks = [Note("ensemble.executed", functions=functions)] if functions else []
    value = resolution = standard_size = math.nan
    margins = dict.fromkeys((requirement.name for requirement in evaluator.requirements), math.nan)
    limiting, interval = "", (math.nan, math.nan)
    if not holds.any():
        best = int(np.argmax(results.shares)) if results.shares.any() else int(np.argmax(results.worst))
        suffix = "upper" if best == len(holds) - 1 else "lower" if best == 0 else "inside"
        if not results.shares.any() and not np.isfinite(results.worst).any():
            suffix = "known"
        remarks.append(Note(f"size.none_{suffix}", free, value=float(results.values[best]), unit=unit))
    else:
        k = int(np.flatnonzero(holds)[-1 if largest else 0])
        value, neighbour = float(results.values[k]), k + 1 if largest else k - 1
        margins = {r.name: float(results.margins[k, j]) for j, r in enumerate(evaluator.requirements)}
        runs = len(evaluator.draws)
        interval = wilson(round(results.shares[k] * runs), runs) if share < 1.0 else (1.0, 1.0)
        if share < 1.0 and (1.0 - share) * runs < 1.0 - 1e-9:
            n_min = math.ceil(1.0 / (1.0 - share) * (1.0 - 1e-9))
            remarks.append(Note("size.few", "ensemble.runs", runs=runs, share=share, wanted=n_min))
        if 0 <= neighbour < len(holds):
            resolution = abs(float(results.values[neighbour]) - value) / abs(value)
            limiting = evaluator.requirements[int(np.argmin(results.margins[neighbour] / evaluator.sizes))].name
        else:
            resolution = 0.0
            remarks.append(Note("size.end", free, end="upper" if largest else "lower"))
        if len(intervals) > 1:
            remarks.append(Note("size.several", free, count=len(intervals)))
        if standard.size:
            fits = _meets_requirements(evaluator.evaluate(standard, None, 0), share)
            suitable = standard[fits & (standard <= value if largest else standard >= value)]
            if suitable.size:
                standard_size = float(suitable[-1 if largest else 0])
            else:
                remarks.append(Note("size.no_standard", free))
    return Sizing(
        circuit.title, free, unit, largest, value, resolution, share, interval, margins,
        limiting, standard_size, results.values, results.shares,
        {metric.name: results.metrics[:, j] for j, metric in enumerate(plan.metrics)},
        {metric.name: metric.unit for metric in plan.metrics},
        intervals, {r.name: r.text for r in evaluator.requirements}, bounds, len(evaluator.draws), tuple(remarks),
    )  # fmt: skip

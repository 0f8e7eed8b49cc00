"""The smallest or largest number of a circuit that meets its requirements, for the circuit as it is or for a share of
many."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from poppet.circuit.circuit import Circuit
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, OutOfRangeError
from poppet.core.files import by_suffix, write_whole
from poppet.core.toml import json_text, toml_text
from poppet.core.units import quantity
from poppet.ensemble.ensemble_plan import Array, EnsemblePlan, varied_specs
from poppet.ensemble.ensemble_result import plan_of
from poppet.ensemble.requirements import Requirement
from poppet.ensemble.shards import PreparedPlan
from poppet.ensemble.statistics import wilson

POINTS = 65
"""Values over the range that are looked at first; of them lies in a gap whatever is overlooked."""
ROUNDS, PIECES = 4, 17
"""Rounds in which the gap between the last value that fails and the first that holds is cut into so many pieces: 17^4
leaves 1e-5 of the gap of the first look."""
PEAKS, REFINEMENTS = 3, 6
"""Around so many values that fail, but are nearer to holding than their neighbours, it is looked closer so many times:
what holds may lie between two values. 8^6 leaves 1e-6 of the value."""
DECADES = 2.0
"""Without a range: so many decades to either side of the number as it is."""
MAX_RUNS = 4_000_000


@dataclass(frozen=True)
class Sizing:
    """The number that was sought, and what the requirements make of others.

    Parameters
    ----------
    title : str
        For people.
    address, unit : str
        The free number, and its SI unit.
    is_largest : bool
        Whether the largest value was sought instead of the smallest.
    value : float
        The smallest (largest) value that meets all requirements, to `resolution`; not-a-number where none does.
    resolution : float
        Distance to the nearest value that was seen to fail, relative; 0 where an end of the range holds.
    share : float
        Share of good runs that was asked for; 1 for the circuit as it is.
    interval : tuple of float
        95 % of the share at `value`, after Wilson; both 1 for the circuit as it is.
    margins : mapping
        Requirement to how far its metric is on the good side at `value`, in the metric's unit; of many runs the
        quantile that the share asks for.
    limiting : str
        The requirement that fails next to `value`; empty where none does.
    size : float
        The next of the sizes that were given; not-a-number without them or where none holds.
    values : (n,) array
        All values that were looked at, in order.
    shares : (n,) array
        Share of good runs at each.
    metrics : mapping
        Metric to its values, (n,): of many runs the mean.
    units : mapping
        Metric to its unit.
    holding : tuple of pairs of float
        Stretches of the range in which the requirements hold, as far as it was seen.
    requirements : mapping
        Name to text of the requirements that were to be met.
    bounds : mapping
        Metric to the bounds that these set, in its unit.
    runs : int
        Runs at each value.
    remarks : tuple of Note
        What a reader has to know.
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
        """Whether any value of the range holds."""
        return math.isfinite(self.value)

    def content(self) -> dict[str, Any]:
        """Everything that is written to a file, as plain tables."""
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

    def save(self, path: str | Path) -> None:
        """Write the sizing, `.toml` or `.json`, aside and renamed.

        Parameters
        ----------
        path : str or Path
            Where to.
        """
        text = by_suffix(Path(path), {".toml": toml_text, ".json": json_text})(self.content())
        write_whole(Path(path), lambda stream: stream.write(text.encode("utf-8")))


def size(
    circuit: Circuit,
    free: str,
    *,
    meet: Sequence[str] = (),
    between: tuple[Any, Any] | None = None,
    largest: bool = False,
    share: float | None = None,
    sizes: Sequence[Any] = (),
    progress: Callable[[int, int, str], Any] | None = None,
    **fields: Any,
) -> Sizing:
    """Find the smallest, or largest, value of a number with which requirements hold.

    Parameters
    ----------
    circuit : Circuit
        With the tables `ensemble` (metrics) and `requirements` of its file, unless `fields` has them.
    free : str
        Address of the number.
    meet : sequence of str, optional
        Names of the requirements; all of them by default.
    between : pair, optional
        Range to look in, numbers in SI or text with units; two decades to either side of the number as it is, within
        what it may be.
    largest : bool, optional
        Seek the largest value instead of the smallest.
    share : float, optional
        Share of good runs, 0 to 1, of the ensemble's distributions; without it the circuit as it is.
    sizes : sequence, optional
        Standard sizes: the next of them that holds is named.
    progress : callable, optional
        Called with the rounds that are done, of how many, and what is looked at.
    **fields
        Fields of the table `ensemble`, and `requirements`, that go before those of the file.

    Returns
    -------
    Sizing
        The value, margins, and the metrics over the number.

    Raises
    ------
    InputError
        For what is unknown, a range that is none, a share without distributions.

    Notes
    -----
    The range is looked at on 65 values, evenly spaced in logarithms where it is positive. Requirements need not be
    monotonic in the number: around values that fail and are nearer to holding than their neighbours, the three nearest,
    it is looked closer, so that a narrow stretch between two values is found where metrics lead to it. The gap before
    the first value that holds is then cut finer. With a share every value sees the same draws, so that it changes with
    the number and not by chance; a number that is free and uncertain at once is the median of its draws, and keeps
    their spread as a part of it.
    """
    spec = varied_specs(circuit).get(free)
    if spec is None:
        raise InputError("ensemble.number", free, near=NameSuggestion(free, varied_specs(circuit)))
    if free in circuit.signals or free in circuit.connections:
        raise InputError("ensemble.driven", free)
    ambient = circuit.surroundings.pressure
    nominal = circuit.numbers()[free].absolute(ambient)

    def read_value(raw: Any, address: str) -> float:
        parsed = quantity(raw, spec.unit, kind=spec.kind, name=address)
        return parsed.value + (ambient if parsed.reference == "gauge" else 0.0)

    standard = np.unique([read_value(raw, "sizes") for raw in sizes])
    for value in standard.tolist():
        if not spec.holds(value):
            raise OutOfRangeError("size.size", free, value=value, unit=spec.unit)
    low, high = _range(between, nominal, (max(spec.low, spec.above), min(spec.high, spec.below)), read_value, free)
    uncertain = plan_of(circuit, **fields) if share is not None else None
    if share is not None and not 0.0 < share < 1.0:
        raise OutOfRangeError("size.share", "share", value=share)
    sweep: dict[str, Any] = {"numbers": {free: {"distribution": "uniform", "low": low, "high": high}}, "runs": 1}
    plan = plan_of(circuit, **{**fields, **sweep, "sampling": "random", "keep": "metrics", "indices": 0})
    requirements = _select_requirements(plan, meet)
    evaluator = _Evaluator(circuit, plan, requirements, free, nominal, uncertain, share or 1.0)
    first = np.geomspace(low, high, POINTS) if low > 0.0 else np.linspace(low, high, POINTS)
    evaluations = evaluator.at(first, progress, 0)
    for value in _peaks(evaluations, largest, evaluator.share):
        evaluations = _refine(evaluator, evaluations, value, progress)
    for round_index in range(ROUNDS):
        gap = _gap(evaluations, largest, evaluator.share)
        if gap is None:
            break
        evaluations = evaluations.joined(evaluator.at(np.linspace(*gap, PIECES + 1)[1:-1], progress, round_index + 1))
    return _make_sizing(circuit, evaluator, evaluations, standard, largest)


@dataclass(frozen=True)
class _Evaluations:
    """What was seen at some values, in order."""

    values: Array
    shares: Array
    metrics: Array  # (n, n_metrics)
    margins: Array  # (n, n_requirements)
    worst: Array  # (n,) the least of all margins over their bounds, of the run that decides

    def joined(self, other: _Evaluations) -> _Evaluations:
        order = np.argsort(np.concatenate([self.values, other.values]), kind="stable")
        rows = (np.concatenate(pair)[order] for pair in zip(vars(self).values(), vars(other).values(), strict=True))
        return _Evaluations(*rows)


class _Evaluator:
    """Metrics and requirements at values of the free number."""

    def __init__(
        self,
        circuit: Circuit,
        sweep: EnsemblePlan,
        requirements: tuple[Requirement, ...],
        free: str,
        nominal: float,
        uncertain: EnsemblePlan | None,
        share: float,
    ) -> None:
        self.plan, self.wanted, self.share = sweep, requirements, share
        self.places = [[metric.name for metric in sweep.metrics].index(requirement.metric) for requirement in requirements]
        # Margins of different units are compared as parts of these.
        self.sizes = np.array([max(abs(bound) for _, bound in requirement.bounds) or 1.0 for requirement in requirements])
        if uncertain is None:
            self._ready, self.draws, self._at = PreparedPlan(sweep), np.ones((1, 1)), 0
            return
        draws = uncertain.sample(0, uncertain.runs)
        addresses = uncertain.addresses
        if uncertain.runs * (POINTS + ROUNDS * PIECES) > MAX_RUNS:
            raise InputError("size.too_many", "ensemble.runs", runs=uncertain.runs, most=MAX_RUNS // 200)
        # One that is uncertain itself keeps its spread, as a part of its median.
        if free in addresses:
            median = uncertain.quantile(free, 0.5)
            if not median:
                raise InputError("size.about_zero", free)
            self._at, draws = addresses.index(free), draws.copy()
            draws[:, self._at] /= median
        else:
            self._at = len(addresses)
            draws, addresses = np.column_stack([draws, np.ones(len(draws))]), (*addresses, free)
        self.draws = draws
        table = replace(uncertain, sampling="file", table=(addresses, self._with(nominal)), alone={}, joint=())
        self._ready = PreparedPlan(replace(table, joint_normal=None, keep="metrics", curves=(), metrics=sweep.metrics))

    def _with(self, value: float) -> Array:
        draws = self.draws.copy()
        draws[:, self._at] *= value
        return draws

    def at(self, values: Array, progress: Callable[[int, int, str], Any] | None, round_index: int) -> _Evaluations:
        if progress is not None:
            progress(round_index, ROUNDS + 1, f"{len(values)} values")
        runs = len(self.draws)
        results = self._ready.run(np.concatenate([self._with(value) for value in values])).metrics
        metrics = results.reshape(len(values), runs, -1)
        met = np.ones((len(values), runs), dtype=np.bool_)
        margins = np.empty((len(values), len(self.wanted)))
        worst = np.full((len(values), runs), np.inf)
        # Of the worst run that may not fail.
        decides = runs - math.ceil(self.share * runs - 1e-9)
        for k, (requirement, column) in enumerate(zip(self.wanted, self.places, strict=True)):
            met &= requirement.met(metrics[:, :, column])
            margin = np.where(np.isnan(metrics[:, :, column]), -np.inf, requirement.margin(metrics[:, :, column]))
            worst = np.minimum(worst, margin / self.sizes[k])
            margins[:, k] = np.sort(margin, axis=1)[:, decides]
        worst = np.sort(worst, axis=1)[:, decides]
        return _Evaluations(np.asarray(values), met.mean(axis=1), metrics.mean(axis=1), margins, worst)


def _range(
    ends: tuple[Any, Any] | None,
    nominal: float,
    limits: tuple[float, float],
    read_value: Callable[[Any, str], float],
    free: str,
) -> tuple[float, float]:
    """Ends of the range, within what the number may be."""
    if ends is None:
        if not nominal > 0.0:
            raise InputError("size.no_range", free)
        low, high = nominal * 10.0**-DECADES, nominal * 10.0**DECADES
        return max(low, limits[0]), min(high, limits[1] - 1e-9 * nominal if math.isfinite(limits[1]) else high)
    low, high = (read_value(raw, "range") for raw in ends)
    if not limits[0] <= low < high <= limits[1]:
        raise OutOfRangeError("size.range", free, low=low, high=high, least=limits[0], most=limits[1])
    return low, high


def _select_requirements(plan: EnsemblePlan, meet: Sequence[str]) -> tuple[Requirement, ...]:
    requirements = {requirement.name: requirement for requirement in plan.requirements}
    for name in meet:
        if name not in requirements:
            raise InputError("size.requirement", name, near=NameSuggestion(name, requirements))
    if not requirements:
        raise InputError("size.no_requirement", "requirements")
    return tuple(requirements[name] for name in dict.fromkeys(meet)) if meet else plan.requirements


def _holds(evaluations: _Evaluations, share: float) -> Any:
    return evaluations.shares >= share - 1e-12


def _peaks(evaluations: _Evaluations, largest: bool, share: float) -> list[float]:
    """Values beyond which none holds that are nearer to holding than those beside them, the nearest of all first."""
    holds, worst = np.flatnonzero(_holds(evaluations, share)), evaluations.worst
    left, right = np.append(-np.inf, worst[:-1]), np.append(worst[1:], -np.inf)
    is_peak = np.isfinite(worst) & (worst >= left) & (worst >= right) & (worst > np.minimum(left, right))
    if holds.size:
        is_peak[: holds[-1] + 1] &= not largest
        is_peak[holds[0] :] &= largest
    indices = np.flatnonzero(is_peak)
    return [float(evaluations.values[k]) for k in indices[np.argsort(-worst[indices], kind="stable")][:PEAKS]]


def _refine(
    evaluator: _Evaluator, evaluations: _Evaluations, value: float, progress: Callable[[int, int, str], Any] | None
) -> _Evaluations:
    """Look closer and closer around a value, or what is nearer to holding beside it, until one holds."""
    for _ in range(REFINEMENTS):
        k = int(np.searchsorted(evaluations.values, value))
        low, high = evaluations.values[max(k - 1, 0)], evaluations.values[min(k + 1, len(evaluations.values) - 1)]
        refined = evaluator.at(np.setdiff1d(np.linspace(low, high, PIECES + 1)[1:-1], evaluations.values), progress, 0)
        previous, evaluations = evaluations.worst[k], evaluations.joined(refined)
        best = int(np.argmax(refined.worst))
        if _holds(refined, evaluator.share).any():
            break
        if refined.worst[best] > previous:
            value = float(refined.values[best])
        elif value in (low, high):  # an end of the range, from where it only gets worse
            break
    return evaluations


def _gap(evaluations: _Evaluations, largest: bool, share: float) -> tuple[float, float] | None:
    """The last value that fails and the first that holds; nothing where none holds, or the end of the range does."""
    holds = _holds(evaluations, share)
    if not holds.any():
        return None
    k = int(np.flatnonzero(holds)[-1 if largest else 0])
    neighbour = k + 1 if largest else k - 1
    return (evaluations.values[k], evaluations.values[neighbour]) if 0 <= neighbour < len(holds) else None


def _make_sizing(circuit: Circuit, evaluator: _Evaluator, evaluations: _Evaluations, standard: Array, largest: bool) -> Sizing:
    plan, share = evaluator.plan, evaluator.share
    free = plan.addresses[0]
    holds = _holds(evaluations, share)
    stretches, unit = _intervals(evaluations.values, holds), varied_specs(circuit)[free].unit
    remarks: list[Note] = []
    value = resolution = standard_size = math.nan
    margins = dict.fromkeys((requirement.name for requirement in evaluator.wanted), math.nan)
    limiting, interval = "", (math.nan, math.nan)
    if not holds.any():
        best = int(np.argmax(evaluations.shares)) if evaluations.shares.any() else int(np.argmax(evaluations.worst))
        suffix = "upper" if best == len(holds) - 1 else "lower" if best == 0 else "inside"
        if not evaluations.shares.any() and not np.isfinite(evaluations.worst).any():
            suffix = "known"
        remarks.append(Note(f"size.none_{suffix}", free, value=float(evaluations.values[best]), unit=unit))
    else:
        k = int(np.flatnonzero(holds)[-1 if largest else 0])
        value, neighbour = float(evaluations.values[k]), k + 1 if largest else k - 1
        margins = {requirement.name: float(evaluations.margins[k, j]) for j, requirement in enumerate(evaluator.wanted)}
        runs = len(evaluator.draws)
        interval = wilson(round(evaluations.shares[k] * runs), runs) if share < 1.0 else (1.0, 1.0)
        if share < 1.0 and (1.0 - share) * runs < 1.0 - 1e-9:
            remarks.append(
                Note(
                    "size.few",
                    "ensemble.runs",
                    runs=runs,
                    share=share,
                    wanted=math.ceil(1.0 / (1.0 - share) * (1.0 - 1e-9)),
                )
            )
        if 0 <= neighbour < len(holds):
            resolution = abs(float(evaluations.values[neighbour]) - value) / abs(value)
            limiting = evaluator.wanted[int(np.argmin(evaluations.margins[neighbour] / evaluator.sizes))].name
        else:
            resolution = 0.0
            remarks.append(Note("size.end", free, end="upper" if largest else "lower"))
        if len(stretches) > 1:
            remarks.append(Note("size.several", free, count=len(stretches)))
        if standard.size:
            fits = _holds(evaluator.at(standard, None, 0), share)
            suitable = standard[fits & (standard <= value if largest else standard >= value)]
            if suitable.size:
                standard_size = float(suitable[-1 if largest else 0])
            else:
                remarks.append(Note("size.no_standard", free))
    return Sizing(
        circuit.title, free, unit, largest, value, resolution, share, interval, margins,
        limiting, standard_size, evaluations.values, evaluations.shares,
        {metric.name: evaluations.metrics[:, j] for j, metric in enumerate(plan.metrics)},
        {metric.name: metric.unit for metric in plan.metrics},
        tuple(stretches), {requirement.name: requirement.text for requirement in evaluator.wanted}, _bounds(evaluator.wanted), len(evaluator.draws),
        tuple(remarks),
    )  # fmt: skip


def _bounds(requirements: Sequence[Requirement]) -> dict[str, tuple[float, ...]]:
    bounds: dict[str, tuple[float, ...]] = {}
    for requirement in requirements:
        bounds[requirement.metric] = (*bounds.get(requirement.metric, ()), *(bound for _, bound in requirement.bounds))
    return bounds


def _intervals(values: Array, holds: Any) -> list[tuple[float, float]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[False], holds, [False]]).astype(int)))
    return [(float(values[a]), float(values[b - 1])) for a, b in zip(edges[::2], edges[1::2], strict=True)]

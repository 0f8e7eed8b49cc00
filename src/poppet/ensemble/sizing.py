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
ROUNDS, BETWEEN = 4, 17
"""Rounds in which the gap between the last value that fails and the first that holds is cut into so many pieces: 17^4
leaves 1e-5 of the gap of the first look."""
PEAKS, CLOSER = 3, 6
"""Around so many values that fail, but are nearer to holding than their neighbours, it is looked closer so many times:
what holds may lie between two values. 8^6 leaves 1e-6 of the value."""
DECADES = 2.0
"""Without a range: so many decades to either side of the number as it is."""
MOST_RUNS = 4_000_000


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
        plain = ("title", "address", "unit", "is_largest", "value", "resolution", "share", "limiting", "size")
        return {
            "method": "size",
            **{name: getattr(self, name) for name in plain},
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

    def read(given: Any, place: str) -> float:
        found = quantity(given, spec.unit, kind=spec.kind, name=place)
        return found.value + (ambient if found.reference == "gauge" else 0.0)

    standard = np.unique([read(given, "sizes") for given in sizes])
    for value in standard.tolist():
        if not spec.holds(value):
            raise OutOfRangeError("size.size", free, value=value, unit=spec.unit)
    low, high = _range(between, nominal, (max(spec.low, spec.above), min(spec.high, spec.below)), read, free)
    uncertain = plan_of(circuit, **fields) if share is not None else None
    if share is not None and not 0.0 < share < 1.0:
        raise OutOfRangeError("size.share", "share", value=share)
    sweep: dict[str, Any] = {"numbers": {free: {"distribution": "uniform", "low": low, "high": high}}, "runs": 1}
    plan = plan_of(circuit, **{**fields, **sweep, "sampling": "random", "keep": "metrics", "indices": 0})
    wanted = _wanted(plan, meet)
    look = _Look(circuit, plan, wanted, free, nominal, uncertain, share or 1.0)
    first = np.geomspace(low, high, POINTS) if low > 0.0 else np.linspace(low, high, POINTS)
    seen = look.at(first, progress, 0)
    for value in _peaks(seen, largest, look.share):
        seen = _closer(look, seen, value, progress)
    for number in range(ROUNDS):
        gap = _gap(seen, largest, look.share)
        if gap is None:
            break
        seen = seen.joined(look.at(np.linspace(*gap, BETWEEN + 1)[1:-1], progress, number + 1))
    return _told(circuit, look, seen, standard, largest)


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


class _Look:
    """Metrics and requirements at values of the free number."""

    def __init__(
        self,
        circuit: Circuit,
        sweep: EnsemblePlan,
        wanted: tuple[Requirement, ...],
        free: str,
        nominal: float,
        uncertain: EnsemblePlan | None,
        share: float,
    ) -> None:
        self.plan, self.wanted, self.share = sweep, wanted, share
        self.places = [[metric.name for metric in sweep.metrics].index(each.metric) for each in wanted]
        # Margins of different units are compared as parts of these.
        self.sizes = np.array([max(abs(bound) for _, bound in each.bounds) or 1.0 for each in wanted])
        if uncertain is None:
            self._ready, self.draws, self._at = PreparedPlan(sweep), np.ones((1, 1)), 0
            return
        draws = uncertain.sample(0, uncertain.runs)
        addresses = uncertain.addresses
        if uncertain.runs * (POINTS + ROUNDS * BETWEEN) > MOST_RUNS:
            raise InputError("size.too_many", "ensemble.runs", runs=uncertain.runs, most=MOST_RUNS // 200)
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
        found = self.draws.copy()
        found[:, self._at] *= value
        return found

    def at(self, values: Array, progress: Callable[[int, int, str], Any] | None, number: int) -> _Evaluations:
        if progress is not None:
            progress(number, ROUNDS + 1, f"{len(values)} values")
        runs = len(self.draws)
        found = self._ready.run(np.concatenate([self._with(value) for value in values])).metrics
        metrics = found.reshape(len(values), runs, -1)
        met = np.ones((len(values), runs), dtype=np.bool_)
        margins = np.empty((len(values), len(self.wanted)))
        worst = np.full((len(values), runs), np.inf)
        # Of the worst run that may not fail.
        decides = runs - math.ceil(self.share * runs - 1e-9)
        for k, (each, place) in enumerate(zip(self.wanted, self.places, strict=True)):
            met &= each.met(metrics[:, :, place])
            own = np.where(np.isnan(metrics[:, :, place]), -np.inf, each.margin(metrics[:, :, place]))
            worst = np.minimum(worst, own / self.sizes[k])
            margins[:, k] = np.sort(own, axis=1)[:, decides]
        worst = np.sort(worst, axis=1)[:, decides]
        return _Evaluations(np.asarray(values), met.mean(axis=1), metrics.mean(axis=1), margins, worst)


def _range(
    between: tuple[Any, Any] | None,
    nominal: float,
    limits: tuple[float, float],
    read: Callable[[Any, str], float],
    free: str,
) -> tuple[float, float]:
    """Ends of the range, within what the number may be."""
    if between is None:
        if not nominal > 0.0:
            raise InputError("size.no_range", free)
        low, high = nominal * 10.0**-DECADES, nominal * 10.0**DECADES
        return max(low, limits[0]), min(high, limits[1] - 1e-9 * nominal if math.isfinite(limits[1]) else high)
    low, high = (read(given, "range") for given in between)
    if not limits[0] <= low < high <= limits[1]:
        raise OutOfRangeError("size.range", free, low=low, high=high, least=limits[0], most=limits[1])
    return low, high


def _wanted(plan: EnsemblePlan, meet: Sequence[str]) -> tuple[Requirement, ...]:
    known = {each.name: each for each in plan.requirements}
    for name in meet:
        if name not in known:
            raise InputError("size.requirement", name, near=NameSuggestion(name, known))
    if not known:
        raise InputError("size.no_requirement", "requirements")
    return tuple(known[name] for name in dict.fromkeys(meet)) if meet else plan.requirements


def _holds(seen: _Evaluations, share: float) -> Any:
    return seen.shares >= share - 1e-12


def _peaks(seen: _Evaluations, largest: bool, share: float) -> list[float]:
    """Values beyond which none holds that are nearer to holding than those beside them, the nearest of all first."""
    holds, worst = np.flatnonzero(_holds(seen, share)), seen.worst
    left, right = np.append(-np.inf, worst[:-1]), np.append(worst[1:], -np.inf)
    is_peak = np.isfinite(worst) & (worst >= left) & (worst >= right) & (worst > np.minimum(left, right))
    if holds.size:
        is_peak[: holds[-1] + 1] &= not largest
        is_peak[holds[0] :] &= largest
    places = np.flatnonzero(is_peak)
    return [float(seen.values[k]) for k in places[np.argsort(-worst[places], kind="stable")][:PEAKS]]


def _closer(
    look: _Look, seen: _Evaluations, value: float, progress: Callable[[int, int, str], Any] | None
) -> _Evaluations:
    """Look closer and closer around a value, or what is nearer to holding beside it, until one holds."""
    for _ in range(CLOSER):
        k = int(np.searchsorted(seen.values, value))
        low, high = seen.values[max(k - 1, 0)], seen.values[min(k + 1, len(seen.values) - 1)]
        own = look.at(np.setdiff1d(np.linspace(low, high, BETWEEN + 1)[1:-1], seen.values), progress, 0)
        before, seen = seen.worst[k], seen.joined(own)
        best = int(np.argmax(own.worst))
        if _holds(own, look.share).any():
            break
        if own.worst[best] > before:
            value = float(own.values[best])
        elif value in (low, high):  # an end of the range, from where it only gets worse
            break
    return seen


def _gap(seen: _Evaluations, largest: bool, share: float) -> tuple[float, float] | None:
    """The last value that fails and the first that holds; nothing where none holds, or the end of the range does."""
    holds = _holds(seen, share)
    if not holds.any():
        return None
    k = int(np.flatnonzero(holds)[-1 if largest else 0])
    other = k + 1 if largest else k - 1
    return (seen.values[k], seen.values[other]) if 0 <= other < len(holds) else None


def _told(circuit: Circuit, look: _Look, seen: _Evaluations, standard: Array, largest: bool) -> Sizing:
    plan, share = look.plan, look.share
    free = plan.addresses[0]
    holds = _holds(seen, share)
    stretches, unit = _stretches(seen.values, holds), varied_specs(circuit)[free].unit
    remarks: list[Note] = []
    value = resolution = chosen = math.nan
    margins = dict.fromkeys((each.name for each in look.wanted), math.nan)
    limiting, interval = "", (math.nan, math.nan)
    if not holds.any():
        best = int(np.argmax(seen.shares)) if seen.shares.any() else int(np.argmax(seen.worst))
        near = "upper" if best == len(holds) - 1 else "lower" if best == 0 else "inside"
        if not seen.shares.any() and not np.isfinite(seen.worst).any():
            near = "known"
        remarks.append(Note(f"size.none_{near}", free, value=float(seen.values[best]), unit=unit))
    else:
        k = int(np.flatnonzero(holds)[-1 if largest else 0])
        value, other = float(seen.values[k]), k + 1 if largest else k - 1
        margins = {each.name: float(seen.margins[k, j]) for j, each in enumerate(look.wanted)}
        runs = len(look.draws)
        interval = wilson(round(seen.shares[k] * runs), runs) if share < 1.0 else (1.0, 1.0)
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
        if 0 <= other < len(holds):
            resolution = abs(float(seen.values[other]) - value) / abs(value)
            limiting = look.wanted[int(np.argmin(seen.margins[other] / look.sizes))].name
        else:
            resolution = 0.0
            remarks.append(Note("size.end", free, end="upper" if largest else "lower"))
        if len(stretches) > 1:
            remarks.append(Note("size.several", free, count=len(stretches)))
        if standard.size:
            fits = _holds(look.at(standard, None, 0), share)
            inside = standard[fits & (standard <= value if largest else standard >= value)]
            if inside.size:
                chosen = float(inside[-1 if largest else 0])
            else:
                remarks.append(Note("size.no_standard", free))
    return Sizing(
        circuit.title, free, unit, largest, value, resolution, share, interval, margins,
        limiting, chosen, seen.values, seen.shares,
        {metric.name: seen.metrics[:, j] for j, metric in enumerate(plan.metrics)},
        {metric.name: metric.unit for metric in plan.metrics},
        tuple(stretches), {each.name: each.text for each in look.wanted}, _bounds(look.wanted), len(look.draws),
        tuple(remarks),
    )  # fmt: skip


def _bounds(wanted: Sequence[Requirement]) -> dict[str, tuple[float, ...]]:
    found: dict[str, tuple[float, ...]] = {}
    for each in wanted:
        found[each.metric] = (*found.get(each.metric, ()), *(bound for _, bound in each.bounds))
    return found


def _stretches(values: Array, holds: Any) -> list[tuple[float, float]]:
    edges = np.flatnonzero(np.diff(np.concatenate([[False], holds, [False]]).astype(int)))
    return [(float(values[a]), float(values[b - 1])) for a, b in zip(edges[::2], edges[1::2], strict=True)]

"""Smallest or largest value of a parameter that meets the requirements.

The requirements are met by a single run, or by a fraction of the runs of an ensemble.
"""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from poppet.circuit.circuit import BaseCircuit
from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion, OutOfRangeError, UnitError
from poppet.core.number_format import readable_unit
from poppet.core.tables import Field
from poppet.core.toml import ResultFileMixin
from poppet.core.units import convert, quantity, unit_in
from poppet.ensemble.ensemble_plan import Array, EnsemblePlan, varied_specs
from poppet.ensemble.ensemble_result import plan_of, with_parameters
from poppet.ensemble.executors import Progress
from poppet.ensemble.metrics import Requirement
from poppet.ensemble.sizing_search import Evaluations, SizingEvaluator, meets_requirements, search_values
from poppet.ensemble.statistics import wilson
from poppet.laws.iso6358 import nominal_flow_from_conductance
from poppet.parts.flow_path import FlowPath

DECADES = 2.0
"""Half width of the default range in decades: the range is centred on the value in the circuit."""


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
    bounded : mapping
        Mapping from each requirement to the metric that it bounds.
    shown_unit : str
        Unit of the question: that of the search range, of the standard sizes, or of the value in the circuit. Texts and
        figures show the parameter in this unit.
    ambient_pressure : float
        Absolute pressure to which gauge values refer [Pa].
    critical_ratio : float
        Critical ratio b of the flow path whose sonic conductance is the parameter; NaN for other parameters.
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
    bounded: Mapping[str, str] = field(default_factory=dict)
    shown_unit: str = ""
    ambient_pressure: float = 1e5
    critical_ratio: float = math.nan

    @property
    def is_met(self) -> bool:
        """True if a value in the range meets the requirements."""
        return math.isfinite(self.value)

    @property
    def metrics_at_value(self) -> dict[str, float]:
        """Mapping from each metric to its value at `value`; empty if no value meets the requirements."""
        if not self.is_met:
            return {}
        k = int(np.flatnonzero(self.values == self.value)[0])
        return {name: float(row[k]) for name, row in self.metrics.items()}

    @property
    def nominal_flow(self) -> float:
        """Nominal flow of the sonic conductance at `value` [m^3/s ANR]; NaN for other parameters."""
        return nominal_flow_from_conductance(self.value, self.critical_ratio) if self.has_nominal_flow else math.nan

    @property
    def has_nominal_flow(self) -> bool:
        """True if the parameter is a sonic conductance, and a value meets the requirements."""
        return self.is_met and math.isfinite(self.critical_ratio)

    def shown(self, value: float) -> float:
        """Convert a value of the parameter from its SI unit to `shown_unit`."""
        return convert(value, self.unit, self.shown_unit or self.unit, ambient_pressure=self.ambient_pressure)

    def content(self) -> dict[str, Any]:
        """Return the content of the result file of a sizing as nested tables."""
        content = ("title", "address", "unit", "is_largest", "value", "resolution", "share", "limiting", "size")
        return {
            "method": "size",
            **{name: getattr(self, name) for name in content},
            "shown": {"value": self.shown(self.value), "unit": self.shown_unit or self.unit},
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
        Function that is called with the number of completed runs, the expected total, and the kind `runs`.
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
    See `poppet.ensemble.sizing_search.search_values` for the search. With a fraction, all values use
    the same random samples, so differences are due to the parameter. If the parameter is also uncertain, the value is
    the median of its samples, and their relative spread is constant.
    """
    fields = with_parameters(fields)
    spec = varied_specs(circuit).get(free)
    if spec is None:
        part, _, field_name = free.partition(".")
        owner = circuit.parts.get(part)
        if isinstance(owner, FlowPath) and field_name in owner.sizes:
            stated = next(name for name in owner.sizes if getattr(owner, name) is not None)
            raise InputError("size.other_capacity", free, stated=f"{part}.{stated}")
        near = NameSuggestion(free, varied_specs(circuit))
        raise InputError("names.unknown", free, meaning="a parameter of this circuit", suggestion=near)
    if free in circuit.signals or free in circuit.connections:
        raise InputError("ensemble.driven", free)
    ambient = circuit.surroundings.pressure
    nominal = circuit.numbers()[free].absolute(ambient)
    texts = (*(between or ()), *sizes, circuit.numbers()[free].text)
    written = next(filter(None, (unit_in(raw, spec.unit) for raw in texts)), "")

    def read_value(raw: Any, address: str) -> float:
        try:
            parsed = quantity(raw, spec.unit, kind=spec.kind, name=address)
        except UnitError as problem:
            if problem.code != "quantity.no_unit" or not written:
                raise
            # The hint proposes the unit of the other values.
            raise UnitError(problem.code, problem.address, **{**problem.facts, "unit": written}) from None
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
    selected = selected_requirements(plan, meet)
    evaluator = SizingEvaluator(circuit, plan, selected, free, nominal, uncertain, share or 1.0, progress)
    results = search_values(evaluator, low, high, largest=largest)
    sizing = _make_sizing(circuit, evaluator, results, standard, largest)
    sizing = replace(
        sizing, shown_unit=written or readable_unit(spec.unit, sizing.value), ambient_pressure=ambient,
        critical_ratio=_critical_ratio(circuit, free),
    )  # fmt: skip
    return replace(sizing, remarks=tuple(_with_shown_value(note, sizing) for note in sizing.remarks))


def _with_shown_value(note: Note, sizing: Sizing) -> Note:
    """Return a note on the best value with this value in the unit of the range."""
    if "shown" not in note.facts:
        return note
    value = note.facts["value"]
    unit = sizing.shown_unit if sizing.shown_unit != sizing.unit else readable_unit(sizing.unit, value)
    shown = convert(value, sizing.unit, unit, ambient_pressure=sizing.ambient_pressure)
    return Note(note.code, note.address, **{**note.facts, "shown": f"{shown:.4g} {unit}".removesuffix(" 1")})


def _critical_ratio(circuit: BaseCircuit, free: str) -> float:
    """Return b of the flow path whose C is the free parameter, or NaN for another parameter."""
    part = free.removesuffix("sonic_conductance")
    ratio = circuit.numbers().get(f"{part}critical_ratio") if part != free else None
    return math.nan if ratio is None else float(ratio)


def selected_requirements(plan: EnsemblePlan, names: Sequence[str]) -> tuple[Requirement, ...]:
    """Return the requirements of a plan with the given names, or all of them without names."""
    requirements = {requirement.name: requirement for requirement in plan.requirements}
    for name in names:
        if name not in requirements:
            near = NameSuggestion(name, requirements)
            raise InputError("names.unknown", name, meaning="a requirement", suggestion=near)
    if not requirements:
        raise InputError("size.no_requirement", "requirements")
    return tuple(requirements[name] for name in dict.fromkeys(names or requirements))


def _make_sizing(
    circuit: BaseCircuit, evaluator: SizingEvaluator, results: Evaluations, standard: Array, largest: bool
) -> Sizing:
    plan, share = evaluator.plan, evaluator.share
    free = plan.addresses[0]
    holds = meets_requirements(results, share)
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
        remarks.append(Note(f"size.none_{suffix}", free, value=float(results.values[best]), unit=unit, shown=""))
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
            fits = meets_requirements(evaluator.evaluate(standard), share)
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
        {r.name: r.metric for r in evaluator.requirements},
    )  # fmt: skip

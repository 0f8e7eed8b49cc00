"""Requirements on metrics: `fill_time < 12 s`, `1 bar < peak <= 6.2 bar g`."""

from __future__ import annotations

import operator
import re
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.core.errors import InputError, NameSuggestion
from poppet.core.units import quantity
from poppet.ensemble.metrics import KINDS, MARKED, Metric

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
        """Return True for each value that meets the requirement; NaN does not meet it."""
        is_met = np.ones(values.shape, dtype=np.bool_)
        with np.errstate(invalid="ignore"):
            for relation, bound in self.bounds:
                is_met &= _RELATIONS[relation](values, bound)
        return is_met

    def margin(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the distance to the nearest bound, positive if met, in the unit of the metric."""
        sides = [bound - values if relation[0] == "<" else values - bound for relation, bound in self.bounds]
        return np.asarray(np.min(sides, axis=0))


def read_requirement(name: str, text: Any, metrics: Mapping[str, Metric], ambient: float, address: str) -> Requirement:
    """Read one requirement."""
    match = FORM.fullmatch(text) if isinstance(text, str) else None
    if match is None:
        raise InputError("ensemble.requirement", address, text=str(text))
    left, sign, metric, relation, right = match.groups()
    if metric not in metrics:
        raise InputError(
            "ensemble.unknown_metric", address, text=text, name=metric, near=NameSuggestion(metric, metrics)
        )
    if left and relation[0] != "<":  # 1 < x > 2 bounds one side twice
        raise InputError("ensemble.requirement", address, text=text)
    bounds = [(relation, right), *([(_MIRRORED[sign], left)] if left else [])]
    metric_of = metrics[metric]
    return Requirement(
        name, text, metric, tuple((r, _bound(raw, metric_of, ambient, address, text)) for r, raw in bounds)
    )


def _bound(raw: str, metric: Metric, ambient: float, address: str, text: str) -> float:
    """Return a bound in the unit of the metric; a value without a unit is SI."""
    unit = metric.source or metric.unit
    # A difference has no reference.
    kind = "plain" if metric.kind == "steady_error" else KINDS.get(unit, "plain")
    try:
        if unit == "kg" and (marked := MARKED.fullmatch(raw)):
            # A volume at a reference state is converted as a flow.
            read = quantity(f"{marked[1]}/s {marked[2]}", "kg/s", kind="mass_flow", name=address)
        else:
            read = quantity(_bare(raw), unit, kind=kind, name=address)
    except InputError as error:
        raise InputError("ensemble.bound", address, text=text, bound=raw, cause=error) from None
    value = read.value + (ambient if read.reference == "gauge" else 0.0)
    return value if not metric.source else float(metric.in_unit(np.array([value]))[0])


def _bare(raw: str) -> str | float:
    """Return a number without a unit as float, other text as it is."""
    try:
        return raw if "_" in raw else float(raw)  # Python would read 1_000
    except ValueError:
        return raw

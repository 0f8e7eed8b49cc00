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
    """What a run must do to be good."""

    name: str
    text: str
    metric: str
    bounds: tuple[tuple[str, float], ...]  # relation and bound, in the unit of the metric; all must hold

    def met(self, values: NDArray[np.float64]) -> NDArray[np.bool_]:
        """Which values meet it; what is not a number, of a run that failed, does not."""
        found = np.ones(values.shape, dtype=np.bool_)
        with np.errstate(invalid="ignore"):
            for relation, bound in self.bounds:
                found &= _RELATIONS[relation](values, bound)
        return found

    def margin(self, values: NDArray[np.float64]) -> NDArray[np.float64]:
        """How far values are on the good side of the nearest bound, in the unit of the metric."""
        sides = [bound - values if relation[0] == "<" else values - bound for relation, bound in self.bounds]
        return np.asarray(np.min(sides, axis=0))


def read_requirement(name: str, text: Any, metrics: Mapping[str, Metric], ambient: float, place: str) -> Requirement:
    """Read one requirement."""
    match = FORM.fullmatch(text) if isinstance(text, str) else None
    if match is None:
        raise InputError("ensemble.requirement", place, text=str(text))
    left, sign, metric, relation, right = match.groups()
    if metric not in metrics:
        raise InputError("ensemble.unknown_metric", place, text=text, name=metric, near=NameSuggestion(metric, metrics))
    if left and relation[0] != "<":  # 1 < x > 2 bounds one side twice
        raise InputError("ensemble.requirement", place, text=text)
    bounds = [(relation, right), *([(_MIRRORED[sign], left)] if left else [])]
    own = metrics[metric]
    return Requirement(name, text, metric, tuple((r, _bound(given, own, ambient, place, text)) for r, given in bounds))


def _bound(given: str, metric: Metric, ambient: float, place: str, text: str) -> float:
    """A bound in the unit of the metric; a bare number is SI."""
    unit = metric.source or metric.unit
    # What is the difference of two values has no reference.
    kind = "plain" if metric.kind == "steady_error" else KINDS.get(unit, "plain")
    try:
        if unit == "kg" and (marked := MARKED.fullmatch(given)):
            # A volume at a reference state: the units know it as a flow.
            read = quantity(f"{marked[1]}/s {marked[2]}", "kg/s", kind="mass_flow", name=place)
        else:
            read = quantity(_bare(given), unit, kind=kind, name=place)
    except InputError as error:
        raise InputError("ensemble.bound", place, text=text, bound=given, cause=error) from None
    value = read.value + (ambient if read.reference == "gauge" else 0.0)
    return value if not metric.source else float(metric.in_unit(np.array([value]))[0])


def _bare(given: str) -> str | float:
    """A number without a unit as such, anything else as it is."""
    try:
        return given if "_" in given else float(given)  # Python would read 1_000
    except ValueError:
        return given

"""Conditions that end a run: `tank.pressure > 5 bar`, and a stroke beyond what its characteristic was fitted to."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.units import Kind, quantity
from poppet.engine.problem import StopCondition

_FORM = re.compile(r"\s*([A-Za-z][\w.-]*)\s*(<=|>=|<|>)\s*(.+?)\s*")
_KINDS: dict[str, Kind] = {"Pa": "pressure", "K": "temperature", "kg/s": "mass_flow"}
_ADDRESS = re.compile(r"[A-Za-z][\w-]*(\.[A-Za-z][\w-]*)+")


def parse_stop_condition(text: str, outputs: Mapping[str, str], ambient_pressure: float) -> StopCondition:
    """Read one condition; `outputs` has the unit of every output, in the order of y."""

    def mistake(code: str, **facts: Any) -> InputError:
        return InputError(code, "run.stop_when", text=text, **facts)

    match = _FORM.fullmatch(text)
    if not match:
        raise mistake("stop.no_condition")
    left, relation, right = match.groups()
    # "5 bar" is no address; "tank.presure" is one, misspelt, and no threshold.
    for name in (left, right) if _ADDRESS.fullmatch(right) else (left,):
        if name not in outputs:
            raise mistake("stop.unknown_output", name=name, near=NameSuggestion(name, outputs))
    places, unit = list(outputs), outputs[left]
    reason, sign = Note("run.condition_met", condition=text), 1.0 if relation in (">", ">=") else -1.0
    if right in outputs:
        if outputs[right] != unit:
            raise mistake("stop.other_unit", left=unit, right=outputs[right])
        # The kernel knows one form only: a weighted sum that becomes positive.
        return StopCondition(reason, (places.index(left), places.index(right)), (sign, -sign, 0.0))
    # A bare number is SI as everywhere; with a unit it is read as a quantity of the output.
    try:
        given: float | str = float(right)
    except ValueError:
        given = right
    try:
        read = quantity(given, unit, kind=_KINDS.get(unit, "plain"))
    except InputError as error:
        raise mistake("stop.no_threshold", threshold=right, mistake=error) from None
    threshold = read.value + (ambient_pressure if read.reference == "gauge" else 0.0)
    return StopCondition(reason, (places.index(left), -1), (sign, 0.0, -sign * threshold))


def domain_conditions(address: str, limits: tuple[float, float], outputs: Mapping[str, str]) -> list[StopCondition]:
    """Conditions that end a run where a characteristic with edge = "error" is left."""
    low, high = limits
    place = list(outputs).index(address)
    reason = Note("run.left_domain", address)
    above = StopCondition(reason, (place, -1), (1.0, 0.0, -high))
    # Below its domain a closing passage has no limit.
    return [above] if low == -math.inf else [above, StopCondition(reason, (place, -1), (-1.0, 0.0, low))]

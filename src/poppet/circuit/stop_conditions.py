"""Conditions that end a run early.

A condition compares an output with a value or another output (`tank.pressure > 5 bar`), or detects a stroke outside
the domain of its characteristic.
"""

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
    """Convert the text of a stop condition, for example `tank.pressure > 5 bar`, to a `StopCondition`.

    `outputs` maps the addresses of the outputs to their units, in the order of the output vector y.
    """

    def error(code: str, **facts: Any) -> InputError:
        return InputError(code, "run.stop_when", text=text, **facts)

    match = _FORM.fullmatch(text)
    if not match:
        raise error("stop.no_condition")
    left, relation, right = match.groups()
    # "tank.presure" is a misspelt address; "5 bar" is a threshold.
    for name in (left, right) if _ADDRESS.fullmatch(right) else (left,):
        if name not in outputs:
            raise error("stop.unknown_output", name=name, suggestion=NameSuggestion(name, outputs))
    names, unit = list(outputs), outputs[left]
    reason, sign = Note("run.condition_met", condition=text), 1.0 if relation in (">", ">=") else -1.0
    if right in outputs:
        if outputs[right] != unit:
            raise error("stop.other_unit", left=unit, right=outputs[right])
        # The kernel evaluates a weighted sum and stops if it becomes positive.
        return StopCondition(reason, (names.index(left), names.index(right)), (sign, -sign, 0.0))
    # A number without a unit is SI.
    try:
        number: float | str = float(right)
    except ValueError:
        number = right
    try:
        read = quantity(number, unit, kind=_KINDS.get(unit, "plain"))
    except InputError as cause:
        raise error("stop.no_threshold", threshold=right, mistake=cause) from None
    threshold = read.value + (ambient_pressure if read.reference == "gauge" else 0.0)
    return StopCondition(reason, (names.index(left), -1), (sign, 0.0, -sign * threshold))


def domain_conditions(address: str, limits: tuple[float, float], outputs: Mapping[str, str]) -> list[StopCondition]:
    """Return conditions that stop a run if a stroke leaves the domain of its characteristic.

    `address` is the address of the stroke. `limits` are the lowest and the highest stroke of the domain; a lower limit
    of -inf adds no condition. `outputs` contains all outputs of the circuit in order.
    """
    low, high = limits
    indices, reason = (list(outputs).index(address), -1), Note("run.left_domain", address)
    upper = StopCondition(reason, indices, (1.0, 0.0, -high))
    # A flow path that is closed below its domain has no lower limit.
    return [upper] if low == -math.inf else [upper, StopCondition(reason, indices, (-1.0, 0.0, low))]

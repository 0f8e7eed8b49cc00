"""Conditions that end a run: `tank.pressure > 5 bar`."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from poppet.engine.problem import StopCondition
from poppet.ground.codes import Note
from poppet.ground.errors import InputError, suggestion
from poppet.ground.units import Kind, quantity

_FORM = re.compile(r"\s*([A-Za-z][\w.-]*)\s*(<=|>=|<|>)\s*(.+?)\s*")
_KINDS: dict[str, Kind] = {"Pa": "pressure", "K": "temperature", "kg/s": "mass_flow"}
_ADDRESS = re.compile(r"[A-Za-z][\w-]*(\.[A-Za-z][\w-]*)+")


def parse_stop_condition(text: str, outputs: Mapping[str, str], ambient_pressure: float) -> StopCondition:
    """Read one condition."""
    match = _FORM.fullmatch(text)
    if not match:
        raise _mistake(text, "is not a condition.", 'Write it like "tank.pressure > 5 bar".')
    left, relation, right = match.groups()
    places = list(outputs)
    if left not in outputs:
        raise _mistake(text, f"names {left}, which is no output of this circuit.", suggestion(left, places))
    reason, sign = Note("run.condition_met", condition=text), 1.0 if relation.startswith(">") else -1.0
    if _ADDRESS.fullmatch(right):
        if right not in outputs:
            raise _mistake(text, f"names {right}, which is no output of this circuit.", suggestion(right, places))
        if outputs[right] != outputs[left]:
            raise _mistake(
                text, f"compares {outputs[left]} with {outputs[right]}.", "Compare quantities of the same unit."
            )
        return StopCondition(reason, (places.index(left), places.index(right)), (sign, -sign, 0.0))
    threshold = _threshold(text, right, outputs[left], ambient_pressure)
    return StopCondition(reason, (places.index(left), -1), (sign, 0.0, -sign * threshold))


def _threshold(text: str, right: str, unit: str, ambient_pressure: float) -> float:
    try:
        given: float | str = float(right)
    except ValueError:
        given = right
    try:
        read = quantity(given, unit, kind=_KINDS.get(unit, "plain"), name="value")
    except InputError as error:
        raise _mistake(text, f"compares with {right!r}, which {error.reason}", error.cure) from None
    return read.value + (ambient_pressure if read.reference == "gauge" else 0.0)


def _mistake(text: str, reason: str, cure: str) -> InputError:
    return InputError(f'stop_when = "{text}"', reason, cure, address="run.stop_when")


def domain_condition(address: str, curve: Any, outputs: Mapping[str, str]) -> list[StopCondition]:
    """Conditions that end a run where a characteristic with edge = "error" is left."""
    low, high = curve.domain
    play = 0.01 * (high - low)
    place = list(outputs).index(address)
    reason = Note("run.left_domain", address)
    above = StopCondition(reason, (place, -1), (1.0, 0.0, -(high + play)))
    if curve.closing is not None:
        return [above]
    return [above, StopCondition(reason, (place, -1), (-1.0, 0.0, low - play))]

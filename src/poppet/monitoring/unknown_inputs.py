"""Inputs whose last value was invalid, so that the readings cannot be compared with the model."""

from __future__ import annotations

import math
from collections.abc import Sequence

from poppet.core.codes import Note
from poppet.monitoring.sensors import DrivenInput
from poppet.monitoring.verdicts import VerdictKind, WatchVerdict


class UnknownInputs:
    """Guard against inputs with invalid values.

    An input without a value is held: a stream can contain a command only when it changes. An invalid value, such as a
    text, is a change to an unknown value. The input is then unknown until its next valid value.
    """

    def __init__(self, inputs: Sequence[DrivenInput]) -> None:
        self.columns = tuple(item.column for item in inputs)
        self._unknown: frozenset[str] = frozenset()
        self.verdict: WatchVerdict | None = None  # while an input is unknown

    def __bool__(self) -> bool:
        return bool(self._unknown)

    def valid(self, values: Sequence[float]) -> list[float]:
        """Return the inputs of a sample with NaN for invalid values, which are infinite."""
        is_invalid = list(map(math.isinf, values))
        if self._unknown or any(is_invalid):
            self._mark(values, is_invalid)
        return [math.nan if invalid else value for value, invalid in zip(values, is_invalid, strict=True)]

    def _mark(self, values: Sequence[float], is_invalid: Sequence[bool]) -> None:
        row = list(zip(self.columns, values, is_invalid, strict=True))
        known = {column for column, value, invalid in row if value == value and not invalid}
        unknown = (self._unknown - known) | {column for column, _, invalid in row if invalid}
        if unknown != self._unknown:
            kind, columns = VerdictKind.UNKNOWN_INPUT, tuple(column for column in self.columns if column in unknown)
            self._unknown = frozenset(unknown)
            self.verdict = WatchVerdict(kind, (), Note(kind.value, "", columns=columns)) if unknown else None

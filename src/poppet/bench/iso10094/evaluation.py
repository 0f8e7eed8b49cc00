"""What the evaluation of a test hands over: figures, rows for each case, curves, and sentences."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any

from poppet.bench.iso10094.definitions import DEFINITIONS
from poppet.bench.iso10094.scale import FloatArray

AT_MOST, AT_LEAST = "at most", "at least"


@dataclass(frozen=True)
class Figure:
    """A figure of a valve.

    Parameters
    ----------
    value : float
        In `unit`; finite.
    unit : str
        Of its definition.
    definition : str
        What it is, in words.
    bound : str
        `at most` or `at least` where the value is a limit of what the test can tell; empty for a value.
    conditions : mapping
        What it holds for.
    """

    value: float
    unit: str
    definition: str
    bound: str = ""
    conditions: Mapping[str, Any] = field(default_factory=dict)


@dataclass(frozen=True, eq=False)
class Curve:
    """A line of a picture.

    Parameters
    ----------
    name : str
        What it is: `up`, `down`, `setpoint`.
    case : str
        To which case it belongs; curves of one case share axes.
    x, y : (n,) array
        In the units of the test's axes.
    """

    name: str
    case: str
    x: FloatArray
    y: FloatArray


@dataclass
class Evaluation:
    """All that is found in the records of one test.

    Parameters
    ----------
    test : str
        One of `poppet.bench.iso10094.definitions.TESTS`.
    figures : dict
        Name to figure.
    rows : list
        One table per case.
    curves : list
        For pictures.
    notes : list
        Findings, and the reason of each figure that is absent.
    conditions : dict
        Of the test.
    """

    test: str
    figures: dict[str, Figure] = field(default_factory=dict)
    rows: list[dict[str, Any]] = field(default_factory=list)
    curves: list[Curve] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)
    conditions: dict[str, Any] = field(default_factory=dict)

    def add(self, name: str, value: float, *, bound: str = "", reason: str = "", **conditions: Any) -> None:
        """Enter a figure, or the reason why there is none."""
        definition = DEFINITIONS[name]
        if not math.isfinite(value):
            self.note(f"{name} is not determined: {reason or 'the records do not show it'}.")
            return
        self.figures[name] = Figure(float(value), definition.unit, definition.full, bound, conditions)

    def note(self, sentence: str) -> None:
        """Enter a finding once."""
        if sentence not in self.notes:
            self.notes.append(sentence)


def largest(rows: Sequence[Mapping[str, Any]], key: str) -> Mapping[str, Any] | None:
    """The row with the largest value of a key; None where no row has one."""
    return max((row for row in rows if key in row), key=lambda row: float(row[key]), default=None)

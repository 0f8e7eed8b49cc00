"""Kinks close to a rest: where the derivatives of rates or of the memory jump."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.sampled.point import SampledPoint
from poppet.core.codes import Note

Array = NDArray[np.float64]

DISTANCES = np.logspace(-9, -2, 15)
"""Distances that are looked at, per size of a variable."""
JUMP = 0.5
"""Change of a derivative, per its size, that makes a kink."""
BISECTIONS = 10


def kinks(point: SampledPoint, v: Array) -> tuple[Note, ...]:
    """Notes on the nearest kink of each equation."""
    here = _slopes(point, v)
    nearest: dict[int, tuple[float, int, float]] = {}
    for column in _moving(point, v):
        for sign in (1.0, -1.0):
            # Both ways: on a kink the derivative is that of one side, and only the other one tells.
            for row, distance in _first(point, v, here, column, sign):
                if row not in nearest or distance < nearest[row][0]:
                    nearest[row] = distance, column, sign
    # One kink shows in many equations; a reader wants to hear of it once.
    together: dict[tuple[str, int, float], list[int]] = {}
    for row in sorted(nearest):
        distance, column, sign = nearest[row]
        together.setdefault((f"{distance:.3g}", column, sign), []).append(row)
    return tuple(_kink(point, rows, nearest[rows[0]][0], column, sign) for (_, column, sign), rows in together.items())


def _slopes(point: SampledPoint, v: Array) -> Array:
    """Derivatives of the rates and of the memory after an instant of all clocks, in sizes."""
    _, jacobian = point.scaled(v)
    return jacobian


def _moving(point: SampledPoint, v: Array) -> list[int]:
    """Variables that the linear model moves: the states, and of the memory what is not held where it is."""
    _, by_v, by_u = point.instant(v, point.every_clock)
    held = ~(np.any(by_v, axis=1) | np.any(by_u, axis=1))
    return [k for k in range(v.size) if k < point.n or not held[k - point.n]]


def _moved(point: SampledPoint, v: Array, column: int, distance: float) -> Array:
    moved = v.copy()
    moved[column] += distance * point.size[column]
    return moved


def _jumped(point: SampledPoint, v: Array, here: Array, column: int, distance: float) -> NDArray[np.bool_]:
    """Rows whose derivative by a variable is another one a distance away."""
    there = _slopes(point, _moved(point, v, column, distance))[:, column]
    # Relative to the larger one: a derivative that vanishes on one side counts as a jump.
    largest = np.maximum(np.abs(there), np.abs(here[:, column]))
    result: NDArray[np.bool_] = np.abs(there - here[:, column]) > JUMP * largest
    return result & np.isfinite(there)


def _first(point: SampledPoint, v: Array, here: Array, column: int, sign: float) -> list[tuple[int, float]]:
    """Rows with a kink in one direction, and how far it is, per size."""
    found: dict[int, float] = {}
    low = 0.0
    for distance in DISTANCES:
        for row in np.flatnonzero(_jumped(point, v, here, column, sign * distance)):
            if row not in found:
                found[int(row)] = _bisected(point, v, here, column, sign, int(row), low, float(distance))
        low = float(distance)
    return list(found.items())


def _bisected(
    point: SampledPoint, v: Array, here: Array, column: int, sign: float, row: int, low: float, high: float
) -> float:
    if low == 0.0:
        return 0.0
    for _ in range(BISECTIONS):
        middle = 0.5 * (low + high)
        if _jumped(point, v, here, column, sign * middle)[row]:
            high = middle
        else:
            low = middle
    return high


def _kink(point: SampledPoint, rows: list[int], distance: float, column: int, sign: float) -> Note:
    what = [Note("linear.rate_of" if row < point.n else "linear.value_of", point.names[row]) for row in rows]
    code = "linear.kink_here" if distance == 0.0 else "linear.kink_ahead"
    return Note(
        code, point.names[column], what=what, count=len(rows), upward=sign > 0.0,
        size=distance * point.size[column], unit=point.units[column],
    )  # fmt: skip

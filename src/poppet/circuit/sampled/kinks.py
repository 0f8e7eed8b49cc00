"""Search for kinks near a steady state of a sampled circuit.

A kink is a jump in a derivative of the equations. A linear model is valid only up to the nearest kinks.
"""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.sampled.point import SampledPoint
from poppet.core.codes import Note

Array = NDArray[np.float64]

DISTANCES = np.logspace(-9, -2, 15)
"""Distances from the steady state at which derivatives are compared, per size of the changed variable."""
JUMP = 0.5
"""Minimum relative change of a derivative that counts as a kink."""
BISECTIONS = 10


def kink_notes(point: SampledPoint, v: Array) -> tuple[Note, ...]:
    """Return notes on kinks (jumps in slope) of the equations near a steady state.

    `v` is the steady state of the circuit `point`. For each equation, only the closest kink is reported.
    """
    search = _KinkSearch(point, v)
    # The linear model changes all states, and the discrete states that are not constant.
    _, by_v, by_u = point.instant(v, point.every_clock)
    is_variable = np.any(by_v, axis=1) | np.any(by_u, axis=1)
    nearest: dict[int, tuple[float, int, float]] = {}
    for column in range(v.size):
        # In both directions: on a kink, the derivative is that of one side.
        for sign in (1.0, -1.0) if column < point.n or is_variable[column - point.n] else ():
            for row, distance in search.distances(column, sign).items():
                if row not in nearest or distance < nearest[row][0]:
                    nearest[row] = distance, column, sign
    # One kink can affect many equations, but needs one note.
    groups: dict[tuple[str, int, float], list[int]] = {}
    for row in sorted(nearest):
        distance, column, sign = nearest[row]
        groups.setdefault((f"{distance:.3g}", column, sign), []).append(row)
    notes = []
    for (_, column, sign), rows in groups.items():
        distance = nearest[rows[0]][0]
        equations = [Note("linear.rate_of" if row < point.n else "linear.value_of", point.names[row]) for row in rows]
        code = "linear.kink_here" if distance == 0.0 else "linear.kink_ahead"
        size = distance * point.size[column]
        facts = {"what": equations, "count": len(rows), "upward": sign > 0.0, "size": size, "unit": point.units[column]}
        notes.append(Note(code, point.names[column], **facts))
    return tuple(notes)


class _KinkSearch:
    """Search for kinks (jumps in slope) along single variables, starting from a steady state v."""

    def __init__(self, point: SampledPoint, v: Array) -> None:
        self.point, self.v = point, v
        _, self.jacobian = point.scaled(v)

    def jumps(self, column: int, distance: float) -> NDArray[np.bool_]:
        """Return a mask of the equations whose slope differs between v and a shifted point.

        The slope is the derivative by the variable with index `column`. At the shifted point, this variable is larger
        by `distance` times its typical size.
        """
        v = self.v.copy()
        v[column] += distance * self.point.size[column]
        derivatives, reference = self.point.scaled(v)[1][:, column], self.jacobian[:, column]
        # Relative to the larger derivative: a derivative that is zero on one side counts as a jump.
        scale = np.maximum(np.abs(derivatives), np.abs(reference))
        result: NDArray[np.bool_] = np.abs(derivatives - reference) > JUMP * scale
        return result & np.isfinite(derivatives)

    def distances(self, column: int, sign: float) -> dict[int, float]:
        """Return the distance from v to the nearest kink of each equation that has one.

        Only the variable with index `column` is changed, in the direction `sign` (1 or -1). The keys are indices of
        equations. The distances are in units of the typical size of the variable.
        """
        result: dict[int, float] = {}
        low = 0.0
        for high in DISTANCES.tolist():
            for row in np.flatnonzero(self.jumps(column, sign * high)).tolist():
                if row in result:
                    continue
                lower, upper = low, high if low > 0.0 else 0.0
                for _ in range(BISECTIONS if low > 0.0 else 0):
                    middle = 0.5 * (lower + upper)
                    lower, upper = (lower, middle) if self.jumps(column, sign * middle)[row] else (middle, upper)
                result[row] = upper
            low = high
        return result

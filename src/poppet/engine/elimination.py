"""Sparse elimination for the integrator's matrix, worked out once per circuit.

The matrix of a Rosenbrock step is ``W = I/(h gamma) - J``. Its pattern never changes, so the elimination order and the
fill are found once (Markowitz, on the diagonal) and the arithmetic becomes a straight list of multiplications that is
printed like every other traced function. Two functions result, so that one factorisation serves all six stages.
Quadratures (states that nothing depends on) are eliminated first and cost no fill.

There is no pivoting at run time: for small steps W is diagonally dominant, and a step that meets a vanishing pivot
yields a value that is not finite, is rejected and tried again shorter.
"""

from __future__ import annotations

from typing import Any, NamedTuple


class Elimination(NamedTuple):
    """Order of the pivots and the pattern of the factors."""

    order: tuple[int, ...]
    rows: dict[int, tuple[int, ...]]  # pivot to the rows below it that hold an entry in its column
    columns: dict[int, tuple[int, ...]]  # pivot to the columns right of it that hold an entry in its row


def eliminate(pattern: set[tuple[int, int]], size: int) -> Elimination:
    """Choose the pivot order of least fill and record the pattern it produces."""
    in_row: list[set[int]] = [set() for _ in range(size)]
    in_column: list[set[int]] = [set() for _ in range(size)]
    for row, column in pattern:
        if row != column:
            in_row[row].add(column)
            in_column[column].add(row)
    remaining = set(range(size))
    order: list[int] = []
    rows: dict[int, tuple[int, ...]] = {}
    columns: dict[int, tuple[int, ...]] = {}
    while remaining:
        # The usual estimate of fill; ties go to the state that comes first.
        pivot = min(remaining, key=lambda k: (len(in_row[k]) * len(in_column[k]), k))
        remaining.discard(pivot)
        below, right = in_column[pivot], in_row[pivot]
        order.append(pivot)
        rows[pivot], columns[pivot] = tuple(sorted(below)), tuple(sorted(right))
        for row in below:
            in_row[row].discard(pivot)
            in_row[row].update(right - {row})
        for column in right:
            in_column[column].discard(pivot)
            in_column[column].update(below - {column})
    return Elimination(tuple(order), rows, columns)


def solver_functions(sparsity: Any) -> tuple[Any, Any]:
    """Trace the factorisation and the solution of ``(I*s - J) x = b``."""
    import casadi as ca

    size = sparsity.size1()
    places = list(zip(*sparsity.get_triplet(), strict=True))
    plan = eliminate({(int(r), int(c)) for r, c in places}, size)
    jacobian, shift = ca.SX.sym("j", len(places)), ca.SX.sym("s")
    # The shift stands on the whole diagonal, also where J has no entry.
    entries: dict[tuple[int, int], Any] = {(k, k): shift for k in range(size)}
    for number, (row, column) in enumerate(places):
        entries[row, column] = entries.get((row, column), 0) - jacobian[number]
    # Multipliers below, pivots inverted on the diagonal: a division once per step, none in the six solutions.
    for pivot in plan.order:
        inverse = entries[pivot, pivot] = 1 / entries[pivot, pivot]
        for row in plan.rows[pivot]:
            multiplier = entries[row, pivot] = entries[row, pivot] * inverse
            for column in plan.columns[pivot]:
                entries[row, column] = entries.get((row, column), 0) - multiplier * entries[pivot, column]
    keys = sorted(entries)
    lu = ca.SX.sym("lu", len(keys))
    right = ca.SX.sym("b", size)
    solution = _substitute(plan, {key: lu[k] for k, key in enumerate(keys)}, [right[k] for k in range(size)])
    factor = ca.Function("factor", [jacobian, shift], [ca.vertcat(*(entries[key] for key in keys))])
    return factor, ca.Function("solve", [lu, right], [ca.vertcat(*solution)])


def _substitute(plan: Elimination, lu: dict[tuple[int, int], Any], values: list[Any]) -> list[Any]:
    """Forward and backward substitution over symbols."""
    for pivot in plan.order:
        for row in plan.rows[pivot]:
            values[row] = values[row] - lu[row, pivot] * values[pivot]
    for pivot in reversed(plan.order):
        total = values[pivot]
        for column in plan.columns[pivot]:
            total = total - lu[pivot, column] * values[column]
        values[pivot] = total * lu[pivot, pivot]
    return values

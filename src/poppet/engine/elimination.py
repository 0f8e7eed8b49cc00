"""Sparse LU factorisation of the matrix of the integrator, planned once per circuit.

The matrix of a Rosenbrock step is ``W = I/(h gamma) - J``. Its pattern is constant, so the elimination order and the
additional nonzeros (fill) are determined once, by the Markowitz rule for diagonal pivots. The arithmetic becomes a
sequence of multiplications, which is printed like other traced functions. Factorisation and solution are separate
functions, because all six stages use one factorisation. Quadratures (states on which no rate depends) are eliminated
first and cause no fill.

There is no pivoting at run time. For small steps, W is diagonally dominant. A pivot of zero gives a result that is not
finite; the step is then rejected and repeated with a smaller length.
"""

from __future__ import annotations

from heapq import heapify, heappop, heappush
from typing import Any, NamedTuple

from poppet.engine.derivatives import apply_operation


class Elimination(NamedTuple):
    """Plan of a sparse LU factorisation: order of the pivots and positions of the nonzeros."""

    order: tuple[int, ...]
    rows: dict[int, tuple[int, ...]]  # pivot to the rows below it with an entry in its column
    columns: dict[int, tuple[int, ...]]  # pivot to the columns to its right with an entry in its row


def eliminate(pattern: set[tuple[int, int]], size: int) -> Elimination:
    """Return the plan of a sparse LU factorisation with few additional nonzeros.

    `pattern` contains pairs of row and column, and `size` is the number of rows.
    """
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

    def cost(state: int) -> tuple[int, int]:
        return len(in_row[state]) * len(in_column[state]), state

    heap = [cost(k) for k in range(size)]
    heapify(heap)
    while heap:
        # Markowitz's estimate of the fill; the first state has priority. An entry with an old estimate is obsolete.
        entry = heappop(heap)
        pivot = entry[1]
        if pivot not in remaining or entry != cost(pivot):
            continue
        remaining.discard(pivot)
        lower_rows, right_columns = in_column[pivot], in_row[pivot]
        order.append(pivot)
        rows[pivot], columns[pivot] = tuple(sorted(lower_rows)), tuple(sorted(right_columns))
        for row in lower_rows:
            in_row[row].discard(pivot)
            in_row[row].update(right_columns - {row})
        for column in right_columns:
            in_column[column].discard(pivot)
            in_column[column].update(lower_rows - {column})
        for neighbour in lower_rows | right_columns:
            heappush(heap, cost(neighbour))
    return Elimination(tuple(order), rows, columns)


def solver_functions(sparsity: Any) -> tuple[Any, Any]:
    """Return CasADi functions that solve the linear system ``(I*s - J) x = b``.

    One function factorises the matrix, and the other solves the system. `sparsity` is the pattern of nonzeros of J.
    """
    import casadi as ca

    def minus(first: Any, second: Any) -> Any:
        return apply_operation("OP_SUB", first, second)

    def times(first: Any, second: Any) -> Any:
        return apply_operation("OP_MUL", first, second)

    size, zero, one = sparsity.size1(), ca.SX(0), ca.SX(1)
    nonzeros = list(zip(*sparsity.get_triplet(), strict=True))
    plan = eliminate({(int(r), int(c)) for r, c in nonzeros}, size)
    jacobian, shift = ca.SX.sym("j", len(nonzeros)), ca.SX.sym("s")
    # The shift is on the whole diagonal, including zeros of J.
    entries: dict[tuple[int, int], Any] = {(k, k): shift for k in range(size)}
    for place, element in zip(nonzeros, jacobian.elements(), strict=True):
        entries[place] = minus(entries.get(place, zero), element)
    # Multipliers below the diagonal, inverse pivots on it: one division per step, none in the six solutions.
    for pivot in plan.order:
        inverse = entries[pivot, pivot] = apply_operation("OP_DIV", one, entries[pivot, pivot])
        for row in plan.rows[pivot]:
            multiplier = entries[row, pivot] = times(entries[row, pivot], inverse)
            for column in plan.columns[pivot]:
                product = times(multiplier, entries[pivot, column])
                entries[row, column] = minus(entries.get((row, column), zero), product)
    keys = sorted(entries)
    lu, right = ca.SX.sym("lu", len(keys)), ca.SX.sym("b", size)
    factors: dict[tuple[int, int], Any] = dict(zip(keys, lu.elements(), strict=True))
    values: list[Any] = right.elements()
    for pivot in plan.order:
        for row in plan.rows[pivot]:
            values[row] = minus(values[row], times(factors[row, pivot], values[pivot]))
    for pivot in reversed(plan.order):
        total = values[pivot]
        for column in plan.columns[pivot]:
            total = minus(total, times(factors[pivot, column], values[column]))
        values[pivot] = times(total, factors[pivot, pivot])
    factor = ca.Function("factor", [jacobian, shift], [ca.vertcat(*(entries[key] for key in keys))])
    return factor, ca.Function("solve", [lu, right], [ca.vertcat(*values)])

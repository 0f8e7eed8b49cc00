"""Jacobian of traced rates by elimination of intermediate values.

CasADi propagates the derivative by each state through all operations. In this module, each operation is a vertex of a
graph, and each edge is the derivative of an operation by one of its arguments. Elimination of a vertex multiplies its
incoming edges by its outgoing edges. When only states and rates remain, the edges between them are the Jacobian
(Griewank & Walther, Evaluating Derivatives, 2nd ed. 2008, chapter 9). The vertex with the fewest products is eliminated
first. This saves a quarter of the operations and half of the divisions.
"""

from __future__ import annotations

from functools import cache
from heapq import heapify, heappop, heappush
from typing import TYPE_CHECKING, Any, NamedTuple

if TYPE_CHECKING:
    import casadi


class Edge(NamedTuple):
    """Edge of a graph of derivatives: a partial derivative `value`, which can have a condition.

    If the condition is false, the derivative is zero. Without a condition (None), it is always `value`.
    """

    value: Any
    condition: Any = None

    def expression(self) -> casadi.SX:
        """Return the derivative as a symbolic expression.

        The expression is zero if the condition is false, even if `value` is infinite.
        """
        return self.value if self.condition is None else apply_operation("OP_IF_ELSE_ZERO", self.condition, self.value)

    def multiply(self, factor: Edge) -> Edge:
        """Return the product of this derivative and the derivative `factor` (chain rule)."""
        if self.condition is None:
            return Edge(apply_operation("OP_MUL", self.value, factor.value), factor.condition)
        return Edge(apply_operation("OP_MUL", self.value, factor.expression()), self.condition)


def apply_operation(operation: str, first: Any, second: Any) -> casadi.SX:
    """Return the symbolic result of a CasADi operation on two scalars.

    `operation` is the name of the operation. This function is twenty times faster than the operators of CasADi.
    """
    import casadi as ca

    return ca.SX.binary(getattr(ca, operation), first, second)


class DerivativeGraph:
    """Graph whose vertices are operations and whose edges are partial derivatives.

    `into` contains the incoming edges of each vertex, by source vertex. `out` contains the outgoing edges, by target
    vertex.
    """

    def __init__(self) -> None:
        self.into: list[dict[int, Edge]] = []
        self.out: list[dict[int, Edge]] = []

    def vertex(self) -> int:
        """Add a vertex to the graph, and return its index."""
        self.into.append({})
        self.out.append({})
        return len(self.into) - 1

    def join(self, source: int, target: int, edge: Edge) -> None:
        """Add an edge between two vertices.

        If there is an edge between them already, the derivatives are added.
        """
        existing = self.out[source].get(target)
        total = edge if existing is None else Edge(apply_operation("OP_ADD", existing.expression(), edge.expression()))
        self.out[source][target] = self.into[target][source] = total

    def eliminate(self, vertex: int) -> tuple[dict[int, Edge], dict[int, Edge]]:
        """Remove a vertex, connect its sources with its targets (chain rule), and return its edges.

        The result contains the incoming edges by source, and the outgoing edges by target.
        """
        into, out = self.into[vertex], self.out[vertex]
        self.into[vertex], self.out[vertex] = {}, {}
        for source in into:
            del self.out[source][vertex]
        for target in out:
            del self.into[target][vertex]
        for source, first in into.items():
            for target, second in out.items():
                self.join(source, target, first.multiply(second))
        return into, out

    def eliminate_all(self, vertices: set[int]) -> None:
        """Remove several vertices, always the one with the fewest multiplications first."""

        def cost(vertex: int) -> tuple[int, int]:
            return len(self.into[vertex]) * len(self.out[vertex]), vertex

        remaining, heap = set(vertices), [cost(vertex) for vertex in vertices]
        heapify(heap)
        while heap:
            products, vertex = heappop(heap)
            # An entry with an old cost is obsolete.
            if vertex not in remaining or cost(vertex)[0] != products:
                continue
            remaining.discard(vertex)
            for neighbour in set().union(*self.eliminate(vertex)) & remaining:
                heappush(heap, cost(neighbour))


@cache
def _partial_derivatives(operation: int, count: int) -> casadi.Function:
    """Return a CasADi function for the partial derivatives of an operation.

    `count` is the number of arguments of the operation.
    """
    import casadi as ca

    symbols = [ca.SX.sym(name) for name in "ab"[:count]]
    result = ca.SX.unary(operation, *symbols) if count == 1 else ca.SX.binary(operation, *symbols)
    return ca.Function("partials", symbols, [ca.densify(ca.jacobian(result, symbol)) for symbol in symbols])


def _edges_to_arguments(operation: int, arguments: list[Any]) -> list[Edge]:
    """Return the partial derivative of an operation by each of its arguments."""
    import casadi as ca

    if operation == ca.OP_MUL:
        return [Edge(argument) for argument in reversed(arguments)]
    if operation in (ca.OP_ADD, ca.OP_SUB):
        return [Edge(ca.SX(1)), Edge(ca.SX(1 if operation == ca.OP_ADD else -1))]
    if operation == ca.OP_IF_ELSE_ZERO:
        return [Edge(ca.SX(0)), Edge(ca.SX(1), arguments[0])]
    if operation in (ca.OP_FMIN, ca.OP_FMAX):
        low, high = arguments if operation == ca.OP_FMIN else reversed(arguments)
        # Equal arguments: the first is the maximum, the second the minimum.
        first = apply_operation("OP_LT" if operation == ca.OP_FMIN else "OP_LE", low, high)
        return [Edge(first), Edge(ca.SX.unary(ca.OP_NOT, first))]
    return [Edge(partial) for partial in _partial_derivatives(operation, len(arguments)).call(arguments)]


class _OperationGraph:
    """Graph of the derivatives of an expression by the states x and by time.

    The first vertices are the states, followed by time. The expression can also depend on inputs u and parameters p.
    """

    def __init__(self, expression: Any, symbols: tuple[Any, ...], slopes: Any) -> None:
        import casadi as ca

        self.graph, self.intermediates, n = DerivativeGraph(), set[int](), symbols[1].numel()
        for _ in range(n + 1):
            self.graph.vertex()
        elements, slope_elements = [symbol.elements() for symbol in symbols], slopes.elements()
        function = ca.Function("traced", list(symbols), [ca.cse(ca.densify(expression))])
        # Value and vertex, by slot of the function and by element of its result.
        slots, self.results = dict[int, tuple[Any, int | None]](), dict[int, tuple[Any, int | None]]()
        for k in range(function.n_instructions()):
            operation = function.instruction_id(k)
            read, written = function.instruction_input(k), function.instruction_output(k)
            if operation == ca.OP_OUTPUT:
                self.results[written[1]] = slots[read[0]]
                continue
            vertex = None
            if operation == ca.OP_CONST:
                value = ca.SX(function.instruction_constant(k))
            elif operation == ca.OP_INPUT:
                vector, element = read
                value = elements[vector][element]
                if vector == 1:
                    vertex = element
                elif vector in (0, 2):
                    # Within a step, inputs change with time.
                    vertex = self._add_vertex([(n, Edge(slope_elements[element] if vector else ca.SX(1)))])
            else:
                values = [slots[slot][0] for slot in read]
                value = ca.SX.unary(operation, *values) if len(read) == 1 else ca.SX.binary(operation, *values)
                sources = [slots[slot][1] for slot in read]
                if any(source is not None for source in sources):
                    edges = zip(sources, _edges_to_arguments(operation, values), strict=True)
                    vertex = self._add_vertex([(i, e) for i, e in edges if i is not None and not e.value.is_zero()])
            slots[written[0]] = value, vertex

    def _add_vertex(self, edges: list[tuple[int, Edge]]) -> int | None:
        """Add a vertex with the given incoming edges, and return its index.

        The result is None if `edges` is empty.
        """
        if not edges:
            return None
        vertex = self.graph.vertex()
        self.intermediates.add(vertex)
        for source, edge in edges:
            self.graph.join(source, vertex, edge)
        return vertex


def differentiate_rates(rates: Any, symbols: tuple[Any, Any, Any, Any], slopes: Any) -> tuple[Any, Any, Any]:
    """Return the rates with their sparse Jacobian and their drift, as CasADi expressions.

    `symbols` are time t, states x, inputs u and parameters p, and `slopes` are expressions for the time derivatives of
    u. The Jacobian is the derivative by x, and the drift is the time derivative for constant x. The rates are
    unchanged, and share operations with the derivatives.
    """
    import casadi as ca

    operations = _OperationGraph(rates, symbols, slopes)
    graph, (m, n) = operations.graph, (rates.numel(), symbols[1].numel())
    ends = {}
    for row, (_, vertex) in operations.results.items():
        if vertex is not None:
            ends[row] = graph.vertex()
            graph.join(vertex, ends[row], Edge(ca.SX(1)))
    graph.eliminate_all(operations.intermediates)
    nonzeros = [(row, column) for row, end in ends.items() for column in sorted(graph.into[end]) if column < n]
    values = [graph.into[ends[row]][column].expression() for row, column in nonzeros]
    rows, columns = ([nonzero[k] for nonzero in nonzeros] for k in (0, 1))
    jacobian = ca.SX.triplet(rows, columns, ca.vertcat(*values), m, n) if nonzeros else ca.SX(m, n)
    zero = Edge(ca.SX(0))
    drift = [graph.into[ends[row]].get(n, zero).expression() if row in ends else ca.SX(0) for row in range(m)]
    return ca.vertcat(*(operations.results[row][0] for row in range(m))), jacobian, ca.vertcat(*drift)

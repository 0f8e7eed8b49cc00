"""The Jacobian of traced rates, by elimination of what lies between states and rates.

CasADi carries the derivative by each state through every operation on its way. Here an operation is a vertex of a
graph, and an edge the derivative of what one makes by what it reads. A vertex is taken out by multiplying its edges in
with its edges out; when only states and rates are left, the edges between them are the Jacobian (Griewank & Walther,
Evaluating Derivatives, 2nd ed. 2008, chapter 9). Taking out what costs least products first, a quarter of the
operations and half of the divisions are saved.
"""

from __future__ import annotations

from functools import cache
from heapq import heapify, heappop, heappush
from typing import Any, NamedTuple


class Edge(NamedTuple):
    """A derivative that counts where a condition holds, or always."""

    value: Any
    condition: Any = None

    def shown(self) -> Any:
        """As an expression. What counts for nothing may be infinite."""
        return self.value if self.condition is None else _of_two("OP_IF_ELSE_ZERO", self.condition, self.value)

    def then(self, other: Edge) -> Edge:
        """Product."""
        if self.condition is None:
            return Edge(_of_two("OP_MUL", self.value, other.value), other.condition)
        return Edge(_of_two("OP_MUL", self.value, other.shown()), self.condition)


def _of_two(operation: str, first: Any, second: Any) -> Any:
    """An operation on scalars; CasADi's own operators take twenty times as long to find out that they are."""
    import casadi as ca

    return ca.SX.binary(getattr(ca, operation), first, second)


class Graph:
    """Edges by their ends, from both sides."""

    def __init__(self) -> None:
        self.into: list[dict[int, Edge]] = []
        self.out: list[dict[int, Edge]] = []

    def vertex(self) -> int:
        """A new one."""
        self.into.append({})
        self.out.append({})
        return len(self.into) - 1

    def join(self, source: int, target: int, edge: Edge) -> None:
        """Add an edge; to one that is there already it is added."""
        before = self.out[source].get(target)
        total = edge if before is None else Edge(_of_two("OP_ADD", before.shown(), edge.shown()))
        self.out[source][target] = self.into[target][source] = total

    def take_out(self, vertex: int) -> tuple[dict[int, Edge], dict[int, Edge]]:
        """Join what lies before a vertex with what lies behind it; returns the edges that it had."""
        into, out = self.into[vertex], self.out[vertex]
        self.into[vertex], self.out[vertex] = {}, {}
        for source in into:
            del self.out[source][vertex]
        for target in out:
            del self.into[target][vertex]
        for source, first in into.items():
            for target, second in out.items():
                self.join(source, target, first.then(second))
        return into, out

    def clear(self, inner: set[int]) -> None:
        """Take out vertices, the cheapest first."""

        def cost(vertex: int) -> tuple[int, int]:
            return len(self.into[vertex]) * len(self.out[vertex]), vertex

        left, heap = set(inner), [cost(vertex) for vertex in inner]
        heapify(heap)
        while heap:
            products, vertex = heappop(heap)
            # Those whose cost has changed have come again.
            if vertex not in left or cost(vertex)[0] != products:
                continue
            left.discard(vertex)
            for each in set().union(*self.take_out(vertex)) & left:
                heappush(heap, cost(each))


@cache
def _partials(operation: int, count: int) -> Any:
    """The derivatives of an operation by its arguments, as a CasADi function of them."""
    import casadi as ca

    symbols = [ca.SX.sym(name) for name in "ab"[:count]]
    made = ca.SX.unary(operation, *symbols) if count == 1 else ca.SX.binary(operation, *symbols)
    return ca.Function("partials", symbols, [ca.densify(ca.jacobian(made, each)) for each in symbols])


def _edges(operation: int, arguments: list[Any]) -> list[Edge]:
    """Of an operation from each of its arguments."""
    import casadi as ca

    if operation == ca.OP_MUL:
        return [Edge(each) for each in reversed(arguments)]
    if operation in (ca.OP_ADD, ca.OP_SUB):
        return [Edge(ca.SX(1)), Edge(ca.SX(1 if operation == ca.OP_ADD else -1))]
    if operation == ca.OP_IF_ELSE_ZERO:
        return [Edge(ca.SX(0)), Edge(ca.SX(1), arguments[0])]
    if operation in (ca.OP_FMIN, ca.OP_FMAX):
        low, high = arguments if operation == ca.OP_FMIN else reversed(arguments)
        # Of two that are equal the first is the greater one: both operations then agree on which is which.
        first = _of_two("OP_LT" if operation == ca.OP_FMIN else "OP_LE", low, high)
        return [Edge(first), Edge(ca.SX.unary(ca.OP_NOT, first))]
    return [Edge(each) for each in _partials(operation, len(arguments)).call(arguments)]


class _Traced:
    """The operations of a function of t, x, u, p as a graph; its vertices are first the states, then time."""

    def __init__(self, expression: Any, symbols: tuple[Any, ...], slopes: Any) -> None:
        import casadi as ca

        self.graph, self.inner, n = Graph(), set[int](), symbols[1].numel()
        for _ in range(n + 1):
            self.graph.vertex()
        elements, speeds = [each.elements() for each in symbols], slopes.elements()
        function = ca.Function("traced", list(symbols), [ca.cse(ca.densify(expression))])
        # By slot of the function, and by element of its result.
        made, self.results = dict[int, tuple[Any, int | None]](), dict[int, tuple[Any, int | None]]()
        for k in range(function.n_instructions()):
            operation = function.instruction_id(k)
            read, written = function.instruction_input(k), function.instruction_output(k)
            if operation == ca.OP_OUTPUT:
                self.results[written[1]] = made[read[0]]
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
                    # Inputs move with time within a step.
                    vertex = self._after([(n, Edge(speeds[element] if vector else ca.SX(1)))])
            else:
                values = [made[slot][0] for slot in read]
                value = ca.SX.unary(operation, *values) if len(read) == 1 else ca.SX.binary(operation, *values)
                moved = [made[slot][1] for slot in read]
                if any(each is not None for each in moved):
                    edges = zip(moved, _edges(operation, values), strict=True)
                    vertex = self._after([(i, e) for i, e in edges if i is not None and not e.value.is_zero()])
            made[written[0]] = value, vertex

    def _after(self, edges: list[tuple[int, Edge]]) -> int | None:
        """A vertex behind others, None where there are none."""
        if not edges:
            return None
        vertex = self.graph.vertex()
        self.inner.add(vertex)
        for source, edge in edges:
            self.graph.join(source, vertex, edge)
        return vertex


def rates_and_derivatives(rates: Any, symbols: tuple[Any, Any, Any, Any], slopes: Any) -> tuple[Any, Any, Any]:
    """Rates, their sparse Jacobian by x, and how fast they drift while x is held and u moves with its `slopes`.

    The symbols are t, x, u, p. The rates are what they were, of operations that they share with the others.
    """
    import casadi as ca

    traced = _Traced(rates, symbols, slopes)
    graph, (m, n) = traced.graph, (rates.numel(), symbols[1].numel())
    ends = {}
    for row, (_, vertex) in traced.results.items():
        if vertex is not None:
            ends[row] = graph.vertex()
            graph.join(vertex, ends[row], Edge(ca.SX(1)))
    graph.clear(traced.inner)
    places = [(row, column) for row, end in ends.items() for column in sorted(graph.into[end]) if column < n]
    values = [graph.into[ends[row]][column].shown() for row, column in places]
    rows, columns = ([place[k] for place in places] for k in (0, 1))
    jacobian = ca.SX.triplet(rows, columns, ca.vertcat(*values), m, n) if places else ca.SX(m, n)
    still = Edge(ca.SX(0))
    drift = [graph.into[ends[row]].get(n, still).shown() if row in ends else ca.SX(0) for row in range(m)]
    return ca.vertcat(*(traced.results[row][0] for row in range(m))), jacobian, ca.vertcat(*drift)

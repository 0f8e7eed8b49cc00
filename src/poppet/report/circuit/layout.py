"""Layout of a schematic in layers (columns) without overlapping boxes.

The layer of a part is its distance from the gas supplies, counted in connections.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

_SWEEPS = 24
Edge = tuple[str, str, str]
"""Edge of the graph: flow path, one port of the flow path, and the gas node at this port."""


@dataclass(frozen=True)
class Graph:
    """Parts of a circuit as a graph for the layout of a schematic.

    Each edge connects a port of a flow path to a gas node.
    """

    stores: tuple[str, ...]
    passages: tuple[str, ...]
    edges: tuple[Edge, ...]  # the first port of a flow path first
    inlets: frozenset[Edge] = frozenset()  # further ports that gas enters, and pilot ports


@dataclass(frozen=True)
class BoxPosition:
    """Layer (column) of a box in a schematic, and position of its centre [in].

    The origin is the lower left corner of the schematic.
    """

    x: float
    y: float
    layer: int


def assign_layers(graph: Graph, fixed: Iterable[str]) -> dict[str, int]:
    """Return the layer (column) of each part: its distance from the gas supplies.

    The distance is a number of connections. `fixed` contains the gas nodes with prescribed pressure, such as the
    supplies.

    Examples
    --------
    >>> edges = (("valve", "from", "supply"), ("valve", "to", "tank"))
    >>> assign_layers(Graph(("supply", "tank"), ("valve",), edges), ["supply"])
    {'supply': 0, 'tank': 2, 'valve': 1}
    """
    neighbours: dict[str, list[str]] = {name: [] for name in (*graph.stores, *graph.passages)}
    for passage, _, store in graph.edges:
        neighbours[passage].append(store)
        neighbours[store].append(passage)
    # Gas comes from the node at the first port: in reverse order, the first edge of a flow path remains.
    firsts = {*{passage: store for passage, _, store in reversed(graph.edges)}.values()}
    firsts |= {store for _, _, store in graph.inlets}
    closing = {passage for passage in graph.passages if len(neighbours[passage]) < 2}
    ends = {name for name in fixed if name not in firsts}
    supplies = [name for name in fixed if name in firsts]
    layers: dict[str, int] = {}
    _assign_reachable(supplies, neighbours, layers, ends | closing)
    for name in graph.stores:
        if name not in layers and name not in ends:
            _assign_reachable([name], neighbours, layers, ends | closing)
    for name in graph.passages:
        layers.setdefault(name, min((layers[store] for store in neighbours[name] if store in layers), default=0) - 1)
    for name in ends:
        layers[name] = max((layers[passage] for passage in neighbours[name]), default=-1) + 1
    _separate(graph, layers)
    lowest = min(layers.values(), default=0)
    return {name: layers[name] - lowest for name in (*graph.stores, *graph.passages)}


def _separate(graph: Graph, layers: dict[str, int]) -> None:
    """Move gas nodes to the next layer that have the layer of a flow path to which they are connected.

    An example is a cylinder that two flow paths reach after different numbers of connections.
    """
    for _ in layers:
        nodes = {store for passage, _, store in graph.edges if layers[passage] == layers[store]}
        if not nodes:
            return
        for name in nodes:
            layers[name] += 1


def _assign_reachable(
    start: Sequence[str], neighbours: Mapping[str, list[str]], layers: dict[str, int], skipped: set[str]
) -> None:
    """Assign layers to all parts that can be reached from the gas nodes in `start`.

    The search is breadth-first and does not enter parts in `skipped`. The results are added to `layers`.
    """
    layers.update(dict.fromkeys(start, 0))
    queue = list(start)
    while queue:
        name = queue.pop(0)
        for neighbour in neighbours[name]:
            if neighbour not in layers and neighbour not in skipped:
                layers[neighbour] = layers[name] + 1
                queue.append(neighbour)


class Layout:
    """Positions of all boxes in a schematic.

    An edge that crosses layers has a waypoint, an intermediate point, in each of them.
    """

    def __init__(
        self,
        graph: Graph,
        layers: Mapping[str, int],
        sizes: Mapping[str, tuple[float, float]],  # width and height [in]
        gaps: tuple[float, float],  # between layers, and between the boxes of a layer [in]
        anchors: Mapping[str, float],  # height of the ends of edges above the centre of a box, default 0 [in]
    ) -> None:
        self.layers, self.sizes, self.gaps = dict(layers), dict(sizes), gaps
        self.anchors = dict.fromkeys(layers, 0.0) | dict(anchors)
        self.rows: list[list[str]] = [[] for _ in range(max(layers.values(), default=0) + 1)]
        for name, layer in layers.items():
            self.rows[layer].append(name)
        self.chains: dict[Edge, list[str]] = {}  # points along each edge: flow path, waypoints, gas node
        for edge in graph.edges:
            passage, port, store = edge
            first, last = self.layers[passage], self.layers[store]
            step = 1 if last > first else -1
            waypoints = {f"{passage}.{port}.{layer}": layer for layer in range(first + step, last, step)}
            for name, layer in waypoints.items():
                # A waypoint has the height of two pipes, so that boxes of its layer keep a distance from it.
                self.layers[name], self.sizes[name], self.anchors[name] = layer, (0.0, 0.16), 0.0
                self.rows[layer].append(name)
            self.chains[edge] = [passage, *waypoints, store]
        self.links: dict[str, list[str]] = {name: [] for row in self.rows for name in row}
        for chain in self.chains.values():
            for start, end in pairwise(chain):
                self.links[start].append(end)
                self.links[end].append(start)
        self._sort_rows()
        self.positions = self._positions()

    def _sort_rows(self) -> None:
        """Sort the boxes within each layer so that few connections cross.

        In several passes, boxes are sorted by the mean position of their neighbours. The order with the fewest
        crossings is used.
        """
        best, min_crossings = [list(row) for row in self.rows], self._crossings()
        for sweep in range(_SWEEPS):
            layers, back = range(len(self.rows)), -1 if sweep % 2 == 0 else 1
            for layer in layers[::-back]:
                if layer + back in layers:
                    ranks = {name: float(k) for k, name in enumerate(self.rows[layer + back])}
                    row, barycentres = self.rows[layer], {}
                    for k, name in enumerate(row):
                        linked_ranks = [ranks[neighbour] for neighbour in self.links[name] if neighbour in ranks]
                        barycentres[name] = sum(linked_ranks) / len(linked_ranks) if linked_ranks else float(k)
                    row.sort(key=barycentres.__getitem__)
            if (crossings := self._crossings()) < min_crossings:
                best, min_crossings = [list(row) for row in self.rows], crossings
        self.rows = best

    def _crossings(self) -> int:
        total = 0
        for left, right in pairwise(self.rows):
            ranks = {name: k for k, name in enumerate(right)}
            ends = [(k, ranks[link]) for k, name in enumerate(left) for link in self.links[name] if link in ranks]
            total += sum((a - c) * (b - d) < 0 for k, (a, b) in enumerate(ends) for c, d in ends[:k])
        return total

    def _positions(self) -> dict[str, BoxPosition]:
        columns, edge = [], 0.0
        for layer in range(len(self.rows)):
            columns.append(edge + self.column_width(layer) / 2.0)
            edge += self.column_width(layer) + self.gaps[0]
        heights = {name: 0.0 for row in self.rows for name in row}
        for row in self.rows:
            heights |= self._separate(row, dict.fromkeys(row, 0.0))
        for sweep in range(_SWEEPS):
            for row in self.rows if sweep % 2 == 0 else reversed(self.rows):
                targets = {}
                for name in row:  # the edges to its neighbours are horizontal on average
                    ends = [heights[neighbour] + self.anchors[neighbour] for neighbour in self.links[name]]
                    targets[name] = sum(ends) / len(ends) - self.anchors[name] if ends else heights[name]
                heights |= self._separate(row, targets)
        floor = min((heights[name] - self.sizes[name][1] / 2.0 for name in heights), default=0.0)
        return {n: BoxPosition(columns[self.layers[n]], y - floor, self.layers[n]) for n, y in heights.items()}

    def column_width(self, layer: int) -> float:
        """Return the width of the widest box in a layer [in]."""
        return max((self.sizes[name][0] for name in self.rows[layer]), default=0.0)

    def _separate(self, row: Sequence[str], targets: Mapping[str, float]) -> dict[str, float]:
        """Return vertical positions [in] of the boxes in one layer without overlaps.

        `targets` contains the desired positions. The sum of the squared distances from them is minimal.
        """
        box_heights = [self.sizes[name][1] for name in row]
        offsets = [0.0, *accumulate((a + b) / 2.0 + self.gaps[1] for a, b in pairwise(box_heights))][: len(row)]
        # From the top down: the first box of a row is the highest.
        # Boxes that would overlap share the mean of their targets: isotonic regression.
        pools: list[list[float]] = []  # mean, count
        for offset, name in zip(offsets, row, strict=True):
            pools.append([-targets[name] - offset, 1.0])
            while len(pools) > 1 and pools[-2][0] > pools[-1][0]:
                mean, count = pools.pop()
                total = pools[-1][1] + count
                pools[-1] = [(pools[-1][0] * pools[-1][1] + mean * count) / total, total]
        levels = [mean for mean, count in pools for _ in range(int(count))]
        return {name: -(level + offset) for name, level, offset in zip(row, levels, offsets, strict=True)}

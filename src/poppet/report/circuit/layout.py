"""Where the parts of a circuit stand in its picture: layers by distance from the supplies, no overlap."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from itertools import accumulate, pairwise

_SWEEPS = 24
Edge = tuple[str, str, str]
"""A passage, one of its ports, and the store it is joined to."""


@dataclass(frozen=True)
class Graph:
    """What is joined to what: stores and passages only meet each other."""

    stores: tuple[str, ...]
    passages: tuple[str, ...]
    edges: tuple[Edge, ...]  # the first port of a passage comes first


@dataclass(frozen=True)
class Place:
    """Centre of a box [in], from the lower left, and its layer."""

    x: float
    y: float
    layer: int


def layers_of(graph: Graph, fixed: Iterable[str]) -> dict[str, int]:
    """Distance of every part from the supplies, stores and passages in turn.

    Examples
    --------
    >>> edges = (("valve", "from", "supply"), ("valve", "to", "tank"))
    >>> layers_of(Graph(("supply", "tank"), ("valve",), edges), ["supply"])
    {'supply': 0, 'tank': 2, 'valve': 1}
    """
    near: dict[str, list[str]] = {name: [] for name in (*graph.stores, *graph.passages)}
    for passage, _, store in graph.edges:
        near[passage].append(store)
        near[store].append(passage)
    # Gas comes from the store at a passage's first port: of edges written from the last on, the first one stays.
    firsts = {passage: store for passage, _, store in reversed(graph.edges)}.values()
    closing = {passage for passage in graph.passages if len(near[passage]) < 2}
    ends = {name for name in fixed if name not in firsts}
    supplies = [name for name in fixed if name in firsts]
    layers: dict[str, int] = {}
    _spread(supplies, near, layers, ends | closing)
    for name in graph.stores:
        if name not in layers and name not in ends:
            _spread([name], near, layers, ends | closing)
    for name in graph.passages:
        layers.setdefault(name, min((layers[store] for store in near[name] if store in layers), default=0) - 1)
    for name in ends:
        layers[name] = max((layers[passage] for passage in near[name]), default=-1) + 1
    lowest = min(layers.values(), default=0)
    return {name: layers[name] - lowest for name in (*graph.stores, *graph.passages)}


def _spread(start: Sequence[str], near: Mapping[str, list[str]], layers: dict[str, int], skipped: set[str]) -> None:
    """Breadth first from some stores; what is skipped is placed later."""
    layers.update(dict.fromkeys(start, 0))
    waiting = list(start)
    while waiting:
        name = waiting.pop(0)
        for other in near[name]:
            if other not in layers and other not in skipped:
                layers[other] = layers[name] + 1
                waiting.append(other)


class Drawing:
    """Parts in layers, with way points where an edge passes a layer."""

    def __init__(
        self,
        graph: Graph,
        layers: Mapping[str, int],
        sizes: Mapping[str, tuple[float, float]],  # width and height [in]
        gaps: tuple[float, float],  # between layers, and between the boxes of a layer [in]
        anchors: Mapping[str, float],  # height above the centre of a box at which edges meet it, else 0 [in]
    ) -> None:
        self.layers, self.sizes, self.gaps = dict(layers), dict(sizes), gaps
        self.anchors = dict.fromkeys(layers, 0.0) | dict(anchors)
        self.rows: list[list[str]] = [[] for _ in range(max(layers.values(), default=0) + 1)]
        for name, layer in layers.items():
            self.rows[layer].append(name)
        self.chains = {edge: self._chain(edge) for edge in graph.edges}
        self.links: dict[str, list[str]] = {name: [] for row in self.rows for name in row}
        for chain in self.chains.values():
            for one, other in pairwise(chain):
                self.links[one].append(other)
                self.links[other].append(one)
        self._order()
        self.places = self._places()

    def _chain(self, edge: Edge) -> list[str]:
        """Names from the passage to the store, way points of the layers between included."""
        passage, port, store = edge
        first, last = self.layers[passage], self.layers[store]
        step = 1 if last > first else -1
        chain = [passage]
        for layer in range(first + step, last, step):
            name = f"{passage}.{port}.{layer}"
            # A way point is as high as two pipes side by side: boxes of its layer make room for it.
            self.layers[name], self.sizes[name], self.anchors[name] = layer, (0.0, 0.16), 0.0
            self.rows[layer].append(name)
            chain.append(name)
        return [*chain, store]

    def _order(self) -> None:
        """Barycentre sweeps, forth and back: neighbours come to stand at the same height."""
        best, fewest = [list(row) for row in self.rows], self._crossings()
        for sweep in range(_SWEEPS):
            layers, back = range(len(self.rows)), -1 if sweep % 2 == 0 else 1
            for layer in layers[::-back]:
                if layer + back in layers:
                    self._sort(layer, layer + back)
            if (crossings := self._crossings()) < fewest:
                best, fewest = [list(row) for row in self.rows], crossings
        self.rows = best

    def _sort(self, layer: int, beside: int) -> None:
        place = {name: k for k, name in enumerate(self.rows[beside])}
        row = self.rows[layer]
        now = {name: float(k) for k, name in enumerate(row)}
        for name in row:
            near = [place[other] for other in self.links[name] if other in place]
            if near:
                now[name] = sum(near) / len(near)
        row.sort(key=now.__getitem__)

    def _crossings(self) -> int:
        total = 0
        for left, right in pairwise(self.rows):
            place = {name: k for k, name in enumerate(right)}
            ends = [(k, place[other]) for k, name in enumerate(left) for other in self.links[name] if other in place]
            total += sum((a - c) * (b - d) < 0 for k, (a, b) in enumerate(ends) for c, d in ends[:k])
        return total

    def _places(self) -> dict[str, Place]:
        columns, edge = [], 0.0
        for layer in range(len(self.rows)):
            columns.append(edge + self.column_width(layer) / 2.0)
            edge += self.column_width(layer) + self.gaps[0]
        heights = {name: 0.0 for row in self.rows for name in row}
        for row in self.rows:
            heights |= self._separated(row, dict.fromkeys(row, 0.0))
        for sweep in range(_SWEEPS):
            for row in self.rows if sweep % 2 == 0 else reversed(self.rows):
                heights |= self._separated(row, {name: self._pulled(name, heights) for name in row})
        floor = min((heights[name] - self.sizes[name][1] / 2.0 for name in heights), default=0.0)
        return {name: Place(columns[self.layers[name]], y - floor, self.layers[name]) for name, y in heights.items()}

    def _pulled(self, name: str, heights: Mapping[str, float]) -> float:
        """Where a box would stand if its edges were level on average."""
        near = [heights[other] + self.anchors[other] for other in self.links[name]]
        return sum(near) / len(near) - self.anchors[name] if near else heights[name]

    def column_width(self, layer: int) -> float:
        """Width of the widest box of a layer."""
        return max((self.sizes[name][0] for name in self.rows[layer]), default=0.0)

    def _separated(self, row: Sequence[str], wanted: Mapping[str, float]) -> dict[str, float]:
        """Heights nearest to those wanted, in least squares, at which the boxes of a layer do not overlap."""
        high = [self.sizes[name][1] for name in row]
        offsets = [0.0, *accumulate((a + b) / 2.0 + self.gaps[1] for a, b in pairwise(high))][: len(row)]
        # From the top down, so that the first of a row stands highest.
        # Boxes that would overlap are pooled and share the mean of what they want: isotonic regression.
        pools: list[list[float]] = []  # mean, count
        for offset, name in zip(offsets, row, strict=True):
            pools.append([-wanted[name] - offset, 1.0])
            while len(pools) > 1 and pools[-2][0] > pools[-1][0]:
                mean, count = pools.pop()
                total = pools[-1][1] + count
                pools[-1] = [(pools[-1][0] * pools[-1][1] + mean * count) / total, total]
        levels = [mean for mean, count in pools for _ in range(int(count))]
        return {name: -(level + offset) for name, level, offset in zip(row, levels, offsets, strict=True)}

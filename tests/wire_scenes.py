"""Scenes for the router of wires: parts of the palette at random places, nets between their ports."""

from __future__ import annotations

import random
from functools import cache
from itertools import pairwise
from typing import Any

from poppet.edit.palette import palette

TURNS = {"left": "top", "top": "right", "right": "bottom", "bottom": "left"}
OUTWARD = {"left": (-1, 0), "right": (1, 0), "top": (0, -1), "bottom": (0, 1)}

Scene = dict[str, Any]


@cache
def entries() -> list[dict[str, Any]]:
    """The palette without what has no port."""
    return [entry for entry in palette() if entry["ports"]]


def turned(entry: dict[str, Any], rotation: int) -> tuple[list[float], list[dict[str, Any]]]:
    """Box and ports of a symbol that is turned clockwise about its centre."""
    left, top, width, height = entry["box"]
    ports = [{**port, "also": list(port["also"])} for port in entry["ports"]]
    for _ in range(rotation // 90):
        left, top, width, height = -(top + height), left, height, width
        for port in ports:
            port["also"] = [_turned(place) for place in port["also"]]
            port.update(_turned(port))
    return [left, top, width, height], ports


def _turned(place: dict[str, Any]) -> dict[str, Any]:
    return {**place, "x": -place["y"], "y": place["x"], "side": TURNS[place["side"]]}


def random_scene(seed: int, *, parts: int | None = None, wires: int | None = None) -> Scene:
    """Parts that do not overlap, each port in at most one net, and waypoints of some wires."""
    rng = random.Random(seed)
    count = rng.randint(20, 60) if parts is None else parts
    limit = rng.randint(count, 80) if wires is None else wires
    columns = round((1.6 * count) ** 0.5)
    boxes, free = [], []
    for k in range(count):
        entry = rng.choice(entries())
        (left, top, width, height), ports = turned(entry, rng.choice((0, 90, 180, 270)))
        column, row = k % columns, k // columns
        x = 22 * column + rng.randint(-2, 2)
        y = 22 * row + rng.randint(-2, 2)
        boxes.append({"name": f"p{k}", "x": x + left, "y": y + top, "width": width, "height": height})
        for port in ports:
            places = [
                {"x": x + place["x"], "y": y + place["y"], "side": place["side"]} for place in (port, *port["also"])
            ]
            free.append({"name": f"p{k}.{port['name']}", **places[0], "also": places[1:], "cell": (column, row)})
    rng.shuffle(free)
    nets: list[dict[str, Any]] = []
    while len(free) > 1 and limit > 0:
        root = free.pop()
        # Neighbours, as in a drawing of a person; now and then anything.
        reach = 2 if rng.random() < 0.8 else 99
        near = [end for end in free if max(abs(end["cell"][k] - root["cell"][k]) for k in (0, 1)) <= reach]
        ends = near[: min(limit, rng.choice((1, 1, 1, 1, 2, 3, 4)))]
        if not ends:
            continue
        free = [end for end in free if end not in ends]
        limit -= len(ends)
        for end in ends:
            if rng.random() < 0.1:
                end["waypoints"] = [[rng.randint(0, 22 * columns), rng.randint(0, 22 * columns)]]
        nets.append({"id": f"n{len(nets)}", "ends": [root, *ends]})
    return {"boxes": boxes, "nets": nets, "labels": []}


def problems(scene: Scene, wires: dict[str, Any]) -> list[str]:
    """What is wrong with the wires of a scene."""
    found = []
    used: dict[tuple[Any, ...], str] = {}
    corners: dict[tuple[Any, ...], str] = {}
    for net in scene["nets"]:
        wire = wires[net["id"]]
        if len(wire["paths"]) != len(net["ends"]) - 1:
            found.append(f"{net['id']}: {len(wire['paths'])} paths")
        for k, path in enumerate(wire["paths"]):
            if k in wire["straight"]:
                continue
            end = net["ends"][k + 1]
            name = f"{net['id']} {end['name']}"
            found += [f"{name}: {problem}" for problem in _path_problems(scene, net, end, path, wire["paths"])]
            for (x1, y1), (x2, y2) in pairwise(path):
                for unit in _units(x1, y1, x2, y2):
                    if used.setdefault(unit, net["id"]) != net["id"]:
                        found.append(f"{name} shares {unit} with {used[unit]}")
            for corner in map(tuple, path):
                if corners.setdefault(corner, net["id"]) != net["id"]:
                    found.append(f"{name} has a corner at that of {corners[corner]}")
        for junction in map(tuple, wire["junctions"]):
            if corners.setdefault(junction, net["id"]) != net["id"]:
                found.append(f"{net['id']} has a junction at a corner of {corners[junction]}")
    for net in scene["nets"]:  # crossings are straight: no corner of one net on another net
        for path in wires[net["id"]]["paths"]:
            for (x1, y1), (x2, y2) in pairwise(path):
                for unit in _units(x1, y1, x2, y2):
                    for point in (unit[:2], unit[2:]):
                        if corners.get(point, net["id"]) != net["id"]:
                            found.append(f"{net['id']} passes a corner of {corners[point]}")
    return found


def _path_problems(scene: Scene, net: Any, end: Any, path: Any, paths: Any) -> list[str]:
    found = []
    places = [end, *end["also"]]
    start = next((place for place in places if [place["x"], place["y"]] == path[0]), None)
    if start is None:
        return [f"begins at {path[0]}"]
    steps = [(b[0] - a[0], b[1] - a[1]) for a, b in pairwise(path)]
    if any((dx != 0) == (dy != 0) for dx, dy in steps):
        found.append("has an oblique or empty segment")
    if _sign(steps[0]) != OUTWARD[start["side"]]:
        found.append(f"leaves by another side than {start['side']}")
    roots = [net["ends"][0], *net["ends"][0]["also"]]
    root = next((place for place in roots if [place["x"], place["y"]] == path[-1]), None)
    if root is not None:
        if _sign(steps[-1]) != tuple(-k for k in OUTWARD[root["side"]]):
            found.append(f"arrives at another side than {root['side']}")
    elif not any(_is_on(path[-1], other) for other in paths if other is not path):
        found.append(f"ends at {path[-1]}, where the net has nothing")
    points = {point for a, b in pairwise(path) for unit in _units(*a, *b) for point in (unit[:2], unit[2:])}
    points -= {tuple(path[0]), tuple(path[-1]) if root else ()}
    for box in scene["boxes"]:
        right, bottom = box["x"] + box["width"], box["y"] + box["height"]
        found += [
            f"passes {box['name']} at {x}, {y}" for x, y in points if box["x"] <= x <= right and box["y"] <= y <= bottom
        ]
    return found


def _sign(step: tuple[int, int]) -> tuple[int, int]:
    return (step[0] > 0) - (step[0] < 0), (step[1] > 0) - (step[1] < 0)


def _units(x1: int, y1: int, x2: int, y2: int) -> list[tuple[int, ...]]:
    """Segments of length 1 from left to right, from top to bottom."""
    (x1, x2), (y1, y2) = sorted((x1, x2)), sorted((y1, y2))
    if y1 == y2:
        return [(x, y1, x + 1, y1) for x in range(x1, x2)]
    return [(x1, y, x1, y + 1) for y in range(y1, y2)]


def _is_on(point: Any, path: Any) -> bool:
    x, y = point
    return any(
        min(x1, x2) <= x <= max(x1, x2) and min(y1, y2) <= y <= max(y1, y2) for (x1, y1), (x2, y2) in pairwise(path)
    )

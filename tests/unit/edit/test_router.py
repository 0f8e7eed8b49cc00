"""Routes of wires in the page of the editor: legal in random scenes, short, and unchanged where nothing changed."""

from __future__ import annotations

import copy
import random
from itertools import pairwise

import pytest

from javascript import needs_node, run_module
from wire_scenes import problems, random_scene

pytestmark = needs_node

SEEDS = range(50)
ROUTE = """
import { route } from "./router.js";
const shown = ({ wires, routed }) => ({ wires: Object.fromEntries(wires), routed });
"""
ALL = ROUTE + "console.log(JSON.stringify(DATA.map((scene) => shown(route(scene)))));"
STEPS = (
    ROUTE
    + """
let former = null;
console.log(JSON.stringify(DATA.map((scene) => shown((former = route(scene, former))))));
"""
)


@pytest.fixture(scope="module")
def scenes():
    return [random_scene(seed) for seed in SEEDS]


@pytest.fixture(scope="module")
def routes(scenes, tmp_path_factory):
    return run_module(tmp_path_factory.mktemp("router"), ALL, data=scenes)


def routed(tmp_path, *scenes):
    """Wires of scenes, each routed alone."""
    return [result["wires"] for result in run_module(tmp_path, ALL, data=scenes)]


def box(name, x, y, width=8, height=8):
    return {"name": name, "x": x, "y": y, "width": width, "height": height}


def end(name, x, y, side, **more):
    return {"name": name, "x": x, "y": y, "side": side, **more}


def scene_of(boxes, *nets, labels=()):
    ends = [[{"also": [], **end} for end in net] for net in nets]
    return {
        "boxes": boxes,
        "nets": [{"id": f"n{k}", "ends": net} for k, net in enumerate(ends)],
        "labels": list(labels),
    }


@pytest.mark.parametrize("seed", SEEDS)
def test_wires_of_random_scenes_are_legal(scenes, routes, seed):
    wires = routes[seed]["wires"]
    assert problems(scenes[seed], wires) == []
    assert not any(wire["straight"] for wire in wires.values())


def test_the_check_of_scenes_finds_faults(scenes, routes):
    """The check rejects wires through a box, wires on each other, oblique wires, and ends that are not at a port."""
    scene, wires = scenes[0], routes[0]["wires"]
    first, second = [net["id"] for net in scene["nets"] if not net["ends"][1].get("waypoints")][:2]
    for change, message in [
        (lambda path: [path[0], [path[0][0] + 1000, path[0][1] + 1], *path[1:]], "oblique"),
        (lambda path: [*path[:-1], [path[-1][0] + 1, path[-1][1]]], "nothing"),
        (lambda path: [[path[0][0] + 1, path[0][1]], *path[1:]], "begins at"),
        (lambda path: wires[second]["paths"][0], "shares"),
    ]:
        faulty = copy.deepcopy(wires)
        faulty[first]["paths"][0] = change(faulty[first]["paths"][0])
        assert any(message in problem for problem in problems(scene, faulty)), message
    ends = [end("a.from", 8, 4, "right"), end("b.from", 30, 4, "left")]
    crossed = scene_of([box("a", 0, 0), box("c", 15, 0), box("b", 30, 0)], ends)
    through = {"n0": {"paths": [[[30, 4], [8, 4]]], "junctions": [], "straight": []}}
    assert any("passes c" in problem for problem in problems(crossed, through))


def test_the_order_of_boxes_and_a_second_call_change_nothing(scenes, routes, tmp_path):
    for seed in (0, 7):
        other = {**scenes[seed], "boxes": scenes[seed]["boxes"][::-1]}
        again, reordered = routed(tmp_path, scenes[seed], other)
        assert again == reordered == routes[seed]["wires"]


@pytest.mark.parametrize("seed", range(8))
def test_a_moved_part_leaves_other_wires_as_they_are(scenes, seed, tmp_path):
    """The part moves in eight steps; wires stay legal, and those that are not near it stay the same."""
    rng = random.Random(seed)
    steps = [scenes[seed]]
    part = rng.choice(sorted({end["name"].partition(".")[0] for net in scenes[seed]["nets"] for end in net["ends"]}))
    dx, dy = rng.choice([(1, 0), (0, 1), (-1, 1), (-1, -1)])
    for _ in range(8):
        scene = copy.deepcopy(steps[-1])
        moved = [box for box in scene["boxes"] if box["name"] == part]
        ends = [end for net in scene["nets"] for end in net["ends"] if end["name"].startswith(f"{part}.")]
        for item in (*moved, *ends, *(place for end in ends for place in end["also"])):
            item["x"] += dx
            item["y"] += dy
        steps.append(scene)
    results = run_module(tmp_path, STEPS, data=steps)
    for scene, before, after in zip(steps[1:], results, results[1:], strict=False):
        boxes = scene["boxes"]
        this = next(box for box in boxes if box["name"] == part)
        if any(overlap(this, box) for box in boxes if box is not this):
            break
        assert problems(scene, after["wires"]) == []
        assert len(after["routed"]) < len(scene["nets"]) / 2
        for net in scene["nets"]:
            if net["id"] not in after["routed"]:
                assert after["wires"][net["id"]] == before["wires"][net["id"]]
            own = any(end["name"].startswith(f"{part}.") for end in net["ends"])
            assert not own or net["id"] in after["routed"]


def overlap(a, b):
    return all(a[k] - b[size] - 2 <= b[k] <= a[k] + a[size] + 2 for k, size in (("x", "width"), ("y", "height")))


def test_nothing_changes_without_a_change(scenes, tmp_path):
    first, second = run_module(tmp_path, STEPS, data=[scenes[3], scenes[3]])
    assert second["routed"] == []
    assert second["wires"] == first["wires"]


def test_the_shortest_ways(tmp_path):
    """Facing ports: a line. Ports in other directions: the fewest bends that their sides permit."""
    a, b = box("a", 0, 0), box("b", 30, 20)
    cases = {
        "line": ([a, box("b", 30, 0)], end("a.p", 8, 4, "right"), end("b.p", 30, 4, "left"), 0, 22),
        "step": ([a, b], end("a.p", 8, 4, "right"), end("b.p", 30, 24, "left"), 2, 42),
        "corner": ([a, b], end("a.p", 8, 4, "right"), end("b.p", 34, 20, "top"), 1, 42),
        "touching": ([a, box("b", 9, 0)], end("a.p", 8, 4, "right"), end("b.p", 9, 4, "left"), 0, 1),
    }
    wires = routed(tmp_path, *(scene_of(boxes, [root, wire]) for boxes, root, wire, _, _ in cases.values()))
    for (name, (*_, bends, length)), wire in zip(cases.items(), wires, strict=True):
        (path,) = wire["n0"]["paths"]
        assert len(path) - 2 == bends, name
        assert sum(abs(x2 - x1) + abs(y2 - y1) for (x1, y1), (x2, y2) in pairwise(path)) == length


def test_wires_of_a_net_join_at_a_junction(tmp_path):
    """Three ports in a row above a tank: a trunk, with two junctions."""
    boxes = [*(box(f"v{k}", 12 * k, 0) for k in range(3)), box("tank", 12, 30)]
    ends = [end(f"v{k}.to", 12 * k + 4, 8, "bottom") for k in range(3)]
    (wires,) = routed(tmp_path, scene_of(boxes, [end("tank.", 16, 30, "top"), *ends]))
    assert wires["n0"]["paths"][1] == [[16, 8], [16, 30]]
    assert [len(path) for path in wires["n0"]["paths"]] == [3, 2, 3]
    assert {x for x, _ in wires["n0"]["junctions"]} == {16}


def test_a_wire_ends_at_the_nearer_place_of_a_part(tmp_path):
    tank = end("tank.", 0, 4, "left", also=[{"x": 8, "y": 4, "side": "right"}])
    boxes = [box("tank", 0, 0), box("a", 20, 0), box("b", -20, 0)]
    (wires,) = routed(tmp_path, scene_of(boxes, [tank, end("a.from", 20, 4, "left"), end("b.from", -12, 4, "right")]))
    assert wires["n0"]["paths"] == [[[20, 4], [8, 4]], [[-12, 4], [0, 4]]]


def test_waypoints_are_passed_in_their_order(tmp_path):
    boxes = [box("a", 0, 0), box("b", 30, 0), box("c", 12, -20)]
    wire = end("b.p", 30, 4, "left", waypoints=[[20, 15], [14, 15], [16, -15]])
    (wires,) = routed(tmp_path, scene_of(boxes, [end("a.p", 8, 4, "right"), wire]))
    (path,) = wires["n0"]["paths"]
    passed = [k for x, y in ([20, 15], [14, 15]) for k in [segment_at(path, x, y)]]
    assert passed == sorted(passed)
    assert None not in passed
    # The last one is in a box, and has no effect.
    assert segment_at(path, 16, -15) is None
    assert wires["n0"]["straight"] == []


def segment_at(path, x, y):
    for k, ((x1, y1), (x2, y2)) in enumerate(pairwise(path)):
        if min(x1, x2) <= x <= max(x1, x2) and min(y1, y2) <= y <= max(y1, y2):
            return k
    return None


def test_labels_are_avoided_if_a_way_around_is_short(tmp_path):
    boxes = [box("a", 0, 0), box("b", 40, 10)]
    ends = [end("a.p", 8, 4, "right"), end("b.p", 40, 14, "left")]
    label = {"x": 22, "y": 2, "width": 4, "height": 14}
    (wires,) = routed(tmp_path, scene_of(boxes, ends, labels=[label]))
    (path,) = wires["n0"]["paths"]
    assert [x for x, _ in path if label["x"] <= x <= label["x"] + label["width"]] == []


def test_without_a_way_the_wire_is_a_straight_line(tmp_path):
    """A box covers the port; the other wire of the net has a way."""
    boxes = [box("a", 0, 0), box("b", 30, 0), box("lid", 9, 0), box("c", 30, 20)]
    (wires,) = routed(
        tmp_path,
        scene_of(boxes, [end("b.p", 30, 4, "left"), end("a.p", 8, 4, "right"), end("c.p", 30, 24, "left")]),
    )
    assert wires["n0"]["straight"] == [0]
    assert wires["n0"]["paths"][0] == [[8, 4], [30, 4]]
    assert wires["n0"]["paths"][1][0] == [30, 24]


def test_wires_make_way_for_each_other(tmp_path):
    """A port opens into a narrow passage, which the shorter wire of the other net takes first."""
    boxes = [box("above", 0, 0, 40, 9), box("below", 0, 11, 40, 9), box("c", -20, 6), box("d", 52, 6), box("a", 16, 90)]
    nets = (
        [end("below.p", 20, 11, "top"), end("a.p", 20, 98, "bottom")],
        [end("c.p", -12, 10, "right"), end("d.p", 52, 10, "left")],
    )
    alone = scene_of(boxes, nets[1])
    (wires,) = routed(tmp_path, alone)
    assert wires["n0"]["paths"] == [[[52, 10], [-12, 10]]]
    scene = scene_of(boxes, *nets)
    (wires,) = routed(tmp_path, scene)
    assert problems(scene, wires) == []
    assert not any(wire["straight"] for wire in wires.values())


def test_scenes_without_wires_and_distant_parts(tmp_path):
    distant = scene_of(
        [box("a", -90000, 5), box("b", 90000, -80000)],
        [end("a.p", -89992, 9, "right"), end("b.p", 90000, -79996, "left")],
        [end("a.q", -89996, 5, "top"), end("b.q", 90004, -80000, "top")],
    )
    broken = scene_of([box("a", 0.5, 0.25)], [end("a.p", 8.5, 4.25, "right"), end("a.q", 4.5, 8.25, "bottom")])
    empty, alone, far, fraction = routed(
        tmp_path, scene_of([]), scene_of([box("a", 0, 0)], [end("a.p", 8, 4, "right")]), distant, broken
    )
    assert empty == {}
    assert alone["n0"]["paths"] == []
    assert not any(wire["straight"] for wire in far.values())
    (path,) = fraction["n0"]["paths"]
    assert fraction["n0"]["straight"] == []
    assert path[0] == [4.5, 8.25]
    assert path[-1] == [8.5, 4.25]

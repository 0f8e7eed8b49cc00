"""Wires of the page of the editor: their nets, their points, and the drawings of all examples."""

from __future__ import annotations

import tomllib
from pathlib import Path

import pytest

from javascript import needs_node, run_module
from poppet.edit.document import Document
from poppet.edit.palette import palette
from poppet.edit.part_symbols import symbols_of
from poppet.edit.places import places_of
from wire_scenes import problems

pytestmark = needs_node

EXAMPLES = Path(__file__).parents[3] / "examples"
FILES = {
    path.relative_to(EXAMPLES).as_posix(): text
    for path in sorted(EXAMPLES.rglob("*.toml"))
    if "parts" in tomllib.loads(text := path.read_text(encoding="utf-8"))
}
SCENES = """
import { boxOf, endsOf, labelOf } from "./geometry.js";
import { sceneOf, wiresOf } from "./nets.js";
import { route } from "./router.js";
const results = DATA.circuits.map(({ view, places, symbols }) => {
  const ends = new Map(), boxes = [], labels = [];
  for (const [name, { kind }] of Object.entries(view.parts)) {
    const entry = { ...DATA.palette[kind], ...symbols[name] }, box = boxOf(entry, places[name]);
    const own = endsOf(name, entry, places[name]);
    for (const end of own) ends.set(end.address, [...ends.get(end.address) ?? [], end]);
    boxes.push({ name, ...box });
    labels.push(labelOf(name, box, own).box);
  }
  const wires = wiresOf(view, ends, boxes), scene = sceneOf(view, ends, wires, boxes, labels);
  return {
    wires: wires.map(({ key, kind, target }) => `${kind} ${key} ${target}`), scene,
    routes: Object.fromEntries(route(scene).wires),
  };
});
console.log(JSON.stringify(results));
"""


def drawn(tmp_path, *texts):
    """Wires, scene and routes of circuits."""
    kinds, circuits = {entry["kind"]: entry for entry in palette()}, []
    for text in texts:
        view, symbols = Document(text).view(), symbols_of(tomllib.loads(text))
        boxes = {name: (symbols.get(name) or kinds[part["kind"]])["box"] for name, part in view["parts"].items()}
        sizes = {name: (width + 2.0, height + 4.0) for name, (_, _, width, height) in boxes.items()}
        circuits.append({"view": view, "places": places_of(view, sizes), "symbols": symbols})
    data = {"palette": kinds, "circuits": circuits}
    return run_module(tmp_path, SCENES, data=data)


@pytest.fixture(scope="module")
def examples(tmp_path_factory):
    return dict(zip(FILES, drawn(tmp_path_factory.mktemp("wires"), *FILES.values()), strict=True))


@pytest.mark.parametrize("file", FILES)
def test_drawings_of_examples(examples, file):
    """Each connection of the file is one wire, and all wires are legal."""
    content, result = tomllib.loads(FILES[file]), examples[file]
    scene = {**result["scene"]}
    for net in scene["nets"]:
        for end in net["ends"]:
            end.setdefault("also", [])
    assert problems(scene, result["routes"]) == []
    assert not any(wire["straight"] for wire in result["routes"].values())
    keys = [wire.split()[1] for wire in result["wires"]]
    assert len({*keys}) == len(keys)
    links = Document(FILES[file]).view()["connections"]
    assert {*links} <= {*keys}
    for name, part in Document(FILES[file]).view()["parts"].items():
        for port, target in part["ports"].items():
            is_tube = content["parts"].get(target, {}).get("kind") == "tube"
            assert (f"{name}.{port}" in keys) == (target != "ambient" and not is_tube), (name, port)


CIRCUIT = """
[parts.supply]
kind = "reservoir"
[parts.tank]
kind = "chamber"
[parts.valve]
kind = "orifice"
from = "supply"
to = "hose"
[parts.hose]
kind = "tube"
from = "valve.to"
to = "tank"
[parts.vent]
kind = "orifice"
from = "tank"
to = "ambient"
[parts.cylinder]
kind = "cylinder"
body = "slide"
[parts.leak]
kind = "orifice"
from = "cylinder.cap"
to = "nothing"
[parts.slide]
kind = "mass"
[parts.pressed]
kind = "switch"
measurement = "cylinder.cap.pressure"
[parts.other]
kind = "pressure_controller"
[connections]
"vent.opening" = "pressed.state"
"other.measurement" = "cylinder.cap.pressure"
"""


def test_four_kinds_of_wires(tmp_path):
    """Both ends of a tube at a port are one wire; ports that are open to the atmosphere or to nothing have none."""
    (result,) = drawn(tmp_path, CIRCUIT)
    assert result["wires"] == [
        "pipe valve.from supply", "tube hose.from valve.to", "tube hose.to tank", "pipe vent.from tank",
        "body cylinder.body slide", "pipe leak.from cylinder.cap", "signal vent.opening pressed.state",
        "signal pressed.measurement cylinder.cap.pressure", "signal other.measurement cylinder.cap.pressure",
    ]  # fmt: skip
    nets = {net["id"]: [end["name"] for end in net["ends"]] for net in result["scene"]["nets"]}
    assert nets["pipe tank"] == ["tank", "hose.to", "vent.from"]
    assert nets["signal cylinder.cap.pressure"][1:] == ["pressed.measurement", "other.measurement"]
    vent = result["scene"]["labels"][-1]
    assert (vent["width"], vent["height"]) == (2.4, 2)


def test_outputs_without_a_port_begin_at_different_places(tmp_path):
    text = CIRCUIT.replace('"cylinder.cap.pressure"\n[', '"tank.mass"\n[').replace(
        '"other.measurement" = "cylinder.cap.pressure"', '"other.measurement" = "tank.pressure"'
    )
    (result,) = drawn(tmp_path, text)
    ends = {
        (end["x"], end["y"])
        for net in result["scene"]["nets"]
        if net["id"] in ("signal tank.mass", "signal tank.pressure")
        for end in [net["ends"][0], *net["ends"][0]["also"]]
    }
    assert len(ends) == 4 + 4
    taken = {(end["x"], end["y"]) for net in result["scene"]["nets"] for end in net["ends"][1:]}
    assert not ends & taken


MOVED = """
import { movedSegment, nearestSegment, arrowOf } from "./nets.js";
console.log(JSON.stringify(DATA.map(([path, points, k, to, isRoot]) => movedSegment(path, points, k, to, isRoot))));
"""
PATH = [[0, 0], [10, 0], [10, 20], [30, 20]]


@pytest.mark.parametrize(
    ("points", "k", "to", "is_root", "expected"),
    [
        ([], 1, 15, True, [[15, 0], [15, 20]]),
        ([], 0, 5, True, [[1, 5], [10, 5]]),
        ([], 2, 25, True, [[10, 25], [29, 25]]),
        ([], 2, 25, False, [[10, 25], [30, 25]]),
        # Points in other segments stay, in their order; those of the moved segment go.
        ([[5, 0], [10, 10], [20, 20]], 1, 15, True, [[5, 0], [15, 0], [15, 20], [20, 20]]),
        ([[10, 0], [10, 20]], 1, 12, True, [[12, 0], [12, 20]]),
        ([[10, 0], [10, 20]], 2, 22, True, [[10, 0], [10, 22], [29, 22]]),
    ],
)
def test_points_of_a_moved_segment(tmp_path, points, k, to, is_root, expected):
    assert run_module(tmp_path, MOVED, data=[[PATH, points, k, to, is_root]]) == [expected]

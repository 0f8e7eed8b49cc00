"""Modules of the drawing of the editor that need no browser: places, rules of connections, flows and colours."""

from __future__ import annotations

import itertools
import random
from pathlib import Path

import numpy as np
import pytest

from javascript import needs_node, run_module
from poppet.circuit import energy_trace
from poppet.circuit.file import load
from poppet.edit.document import Document
from poppet.edit.palette import palette

pytestmark = needs_node

ROOT = Path(__file__).parents[3]
PLACES = [
    {"x": 3, "y": -2, "rotation": turn, "mirror": mirror} for turn in (0, 90, 180, 270) for mirror in (False, True)
]


# --- Places ---


@pytest.fixture(scope="module")
def ends(tmp_path_factory):
    """Ends and boxes of all kinds in all orientations."""
    script = """
import { boxOf, endsOf, labelOf } from "./geometry.js";
const [entries, places] = DATA;
console.log(JSON.stringify(entries.map(entry => places.map(place => {
  const box = boxOf(entry, place), ends = endsOf("part", entry, place);
  return { box, ends, label: labelOf("part", box, ends).box };
}))));
"""
    return run_module(tmp_path_factory.mktemp("ends"), script, data=[palette(), PLACES])


def test_ports_are_on_the_border_of_the_box_at_their_side(ends):
    for entry, places in zip(palette(), ends, strict=True):
        for shown in places:
            box = shown["box"]
            borders = {
                "left": ("x", box["x"]), "right": ("x", box["x"] + box["width"]),
                "top": ("y", box["y"]), "bottom": ("y", box["y"] + box["height"]),
            }  # fmt: skip
            for end in shown["ends"]:
                axis, border = borders[end["side"]]
                assert end[axis] == border, (entry["kind"], end["address"])
                assert box["x"] <= end["x"] <= box["x"] + box["width"]
                assert box["y"] <= end["y"] <= box["y"] + box["height"]


def test_orientations_are_rotations_and_reflections(ends):
    for entry, places in zip(palette(), ends, strict=True):
        at_rest = np.array([[end["x"] - 3, end["y"] + 2] for end in places[0]["ends"]])
        for place, shown in zip(PLACES, places, strict=True):
            angle = np.radians(place["rotation"])
            matrix = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
            expected = at_rest @ (matrix @ np.diag([-1 if place["mirror"] else 1, 1])).T
            turned = np.array([[end["x"] - 3, end["y"] + 2] for end in shown["ends"]])
            assert np.allclose(turned, expected), entry["kind"]


def test_names_are_beside_the_box(ends):
    for shown in itertools.chain(*ends):
        box, label = shown["box"], shown["label"]
        across = label["x"] + label["width"] < box["x"] + 1e-9 or box["x"] + box["width"] < label["x"] + 1e-9
        down = label["y"] + label["height"] < box["y"] + 1e-9 or box["y"] + box["height"] < label["y"] + 1e-9
        assert across or down


def test_new_parts_have_the_nearest_free_place(tmp_path):
    rng = random.Random(5)
    entries = {entry["kind"]: entry for entry in palette()}
    scenes = []
    for kind in ("orifice", "tube", "joint", "spool_valve"):
        taken = [
            {
                "x": rng.randint(-40, 40),
                "y": rng.randint(-40, 40),
                "width": rng.randint(2, 16),
                "height": rng.randint(2, 9),
            }
            for _ in range(25)
        ]
        scenes.append([entries[kind], {"x": rng.uniform(-9, 9), "y": rng.uniform(-9, 9)}, taken])
    script = """
import { boxOf, freePlace, overlaps } from "./geometry.js";
const areFree = (entry, place, taken) => !taken.some(box => overlaps(boxOf(entry, place), box, 2));
console.log(JSON.stringify(DATA.map(([entry, wanted, taken]) => {
  const place = freePlace(entry, "", wanted, taken), nearer = [];
  const [x, y] = [Math.round(wanted.x), Math.round(wanted.y)], reach = Math.hypot(place.x - x, place.y - y);
  const alone = taken.filter(box => !overlaps(box, { ...box, width: 0 }, 0));
  for (let k = -60; k <= 60; k++) for (let j = -60; j <= 60; j++) {
    if (Math.hypot(k, j) >= reach - 1e-9) continue;
    const same = freePlace(entry, "", { x: x + k, y: y + j }, taken);
    if (same.x === x + k && same.y === y + j) nearer.push([k, j]);
  }
  return { isFree: areFree(entry, place, taken), nearer };
})));
"""
    assert run_module(tmp_path, script, data=scenes) == [{"isFree": True, "nearer": []}] * 4


def test_two_reflections_and_four_turns_about_a_point_change_nothing(tmp_path):
    script = """
import { mirroredPlace, rotatedPlace } from "./geometry.js";
const centre = { x: 7, y: 1 };
console.log(JSON.stringify(DATA.map(place => {
  const turns = [0, 1, 2, 3].reduce(found => rotatedPlace(found, centre), place);
  return [turns, mirroredPlace(mirroredPlace(place, centre), centre)];
})));
"""
    assert run_module(tmp_path, script, data=PLACES) == [[place, place] for place in PLACES]


# --- Connections ---

SCENE = [
    "reservoir", "chamber", "orifice", "orifice", "tube", "tube", "cylinder", "cylinder", "mass", "joint", "muscle",
    "spool_valve", "pid", "switch", "suction_cup",
]  # fmt: skip


def scene_with_connections():
    """Document with parts of several kinds, some of them connected."""
    document = Document("").apply([{"op": "add", "kind": kind} for kind in SCENE])
    return document.apply(
        [
            {"op": "connect", "port": "orifice.from", "to": "reservoir"},
            {"op": "connect", "port": "orifice.to", "to": "chamber"},
            {"op": "connect", "port": "tube.from", "to": "chamber"},
            {"op": "connect", "port": "cylinder.body", "to": "mass"},
            {"op": "link", "input": "orifice.opening", "output": "pid.fill_command"},
        ]
    )


PLANS = """
import { connection, outputsOf } from "./connections.js";
import { endsOf } from "./geometry.js";
const { view, kinds } = DATA, entries = new Map(kinds.map(entry => [entry.kind, entry]));
const all = Object.keys(view.parts).flatMap(name => endsOf(name, entries.get(view.parts[name].kind), { x: 0, y: 0 }));
const ends = [...new Map(all.map(end => [`${end.address} ${end.type}`, end])).values()];
const outputs = (source, input) => outputsOf(view, source, input, []);
console.log(JSON.stringify(ends.flatMap(from => ends.map(to => ({
  from, to, ...connection(view, from, to, outputs, "between"),
})))));
"""


@pytest.fixture(scope="module")
def plans(tmp_path_factory):
    data = {"view": scene_with_connections().view(), "kinds": palette()}
    return run_module(tmp_path_factory.mktemp("plans"), PLANS, data=data)


def test_every_planned_connection_can_be_made(plans):
    document = scene_with_connections()
    possible = [plan for plan in plans if "operations" in plan]
    assert len(possible) > 300
    for plan in random.Random(3).sample(possible, 150):
        inserted = [{"op": "add", "kind": plan["insert"], "name": "between"}] if "insert" in plan else []
        view = document.apply([*inserted, *plan["operations"]]).view()
        for operation in plan["operations"]:
            part, _, port = operation.get("port", ".").partition(".")
            if operation["op"] == "link":
                stated = view["connections"].get(operation["input"])
                assert stated == operation["output"], plan
            elif port in view["parts"][part]["ports"]:
                assert view["parts"][part]["ports"][port] in (operation["to"], operation["to"].partition(".")[0]), plan
            else:  # the port of a part is the target of the end of a tube
                tube, _, end = operation["to"].partition(".")
                assert view["parts"][tube]["ports"][end] == operation["port"], plan


def test_tubes_instead_of_chambers(plans):
    document = scene_with_connections()
    tubes = [plan for plan in plans if plan.get("tube")]
    assert tubes
    for plan in random.Random(4).sample(tubes, 20):
        view = document.apply([{"op": "add", "kind": "tube", "name": "between"}, *plan["tube"]]).view()
        for end in (plan["from"], plan["to"]):
            assert view["parts"][end["part"]]["ports"][end["port"]] == "between"


def test_ends_of_different_kinds_are_refused_with_a_reason(plans):
    medium = {"port": 0, "tube": 0, "store": 0, "body": 1, "input": 2, "output": 2}
    for plan in plans:
        start, end = (medium[plan[name]["type"]] for name in ("from", "to"))
        if start != end and 2 not in (start, end):
            assert plan["reason"] in ("drawing.no_body", "drawing.no_gas")
        if plan["from"] == plan["to"]:
            assert plan["reason"] == "drawing.no_itself"


def test_a_port_joins_the_gas_node_of_the_other_one(plans):
    found = {(plan["from"]["address"], plan["to"]["address"]): plan for plan in plans}
    assert found["spool_valve.a", "orifice.to"]["operations"] == [
        {"op": "connect", "port": "spool_valve.a", "to": "chamber"}
    ]
    assert found["spool_valve.a", "orifice_2.to"]["insert"] == "chamber"
    assert found["cylinder.body", "cylinder_2.body"]["insert"] == "mass"


# --- Flows ---


def flows_of(circuit):
    """Ports of each flow of a circuit, from the equations: {address of the port: {(series, sign)}}."""
    found = {}

    class Tracer(energy_trace._EnergyTracer):
        def _add_flows(self):
            for name, result in self.equations.passages.items():
                part, _, member = name.partition(".")
                ports = circuit.parts[part].ports()
                for flow in result.flows:
                    series = self.shown_address(f"{name}.{flow.name}")
                    for port, sign in ((flow.source, -1), (flow.target, 1)):
                        if port in ports and (not member or ports[port] == self.end_of(name, port)):
                            found.setdefault(f"{part}.{port}", set()).add((series, sign))

    tracer = Tracer(circuit.parts, circuit.connections, tuple(circuit.parameters))
    tracer.model()
    return found


@pytest.mark.parametrize(
    "name",
    ["cylinder_meter_out", "pick_and_place", "pressure_regulator", "regulator_parts", "muscle_lift", "bleed_regulator"],
)
def test_flows_at_ports_are_those_of_the_equations(tmp_path, name):
    path = ROOT / "examples" / f"{name}.toml"
    circuit = load(path)
    names = [output for output, _ in circuit.model.outputs]
    script = """
import { portFlows } from "./flows.js";
const { view, names } = DATA;
console.log(JSON.stringify(Object.keys(view.parts).flatMap(name => [...portFlows(view, name, names)])));
"""
    view = Document(path.read_text(encoding="utf-8")).view()
    shown = run_module(tmp_path, script, data={"view": view, "names": names})
    assert {port: {tuple(term) for term in terms} for port, terms in shown} == flows_of(circuit)


# --- Colours ---


def linear(rgb):
    share = np.asarray(rgb, dtype=float) / 255.0
    return np.where(share <= 0.04045, share / 12.92, ((share + 0.055) / 1.055) ** 2.4)


def luminance(rgb):
    return float(linear(rgb) @ [0.2126, 0.7152, 0.0722])


def lab(light):
    """CIE L*a*b* of linear sRGB."""
    matrix = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    x, y, z = np.cbrt(np.maximum(matrix @ light / [0.9505, 1.0, 1.089], 1e-6))
    return np.array([116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)])


@pytest.fixture(scope="module")
def colours(tmp_path_factory):
    script = """
import { colourOf } from "./colours.js";
const steps = [0, 1, 2, 3].map(k => k / 3);
const rgb = (share, isDark) => colourOf(share, isDark).match(/\\d+/g).map(Number);
console.log(JSON.stringify([false, true].map(isDark => steps.map(share => rgb(share, isDark)))));
"""
    return run_module(tmp_path_factory.mktemp("colours"), script)


@pytest.mark.parametrize(("scheme", "paper"), [(0, (255, 255, 255)), (1, (0x14, 0x17, 0x1B))])
def test_colours_of_pressures_are_readable(colours, scheme, paper):
    for colour in colours[scheme]:
        low, high = sorted((luminance(colour), luminance(paper)))
        assert (high + 0.05) / (low + 0.05) > 3.0  # WCAG 2.2, 1.4.11


@pytest.mark.parametrize("scheme", [0, 1])
@pytest.mark.parametrize(
    "blindness",
    [
        [[0.152286, 1.052583, -0.204868], [0.114503, 0.786281, 0.099216], [-0.003882, -0.048116, 1.051998]],
        [[0.367322, 0.860646, -0.227968], [0.280085, 0.672501, 0.047413], [-0.01182, 0.04294, 0.968881]],
        [[1.255528, -0.076749, -0.178779], [-0.078411, 0.930809, 0.147602], [0.004733, 0.691367, 0.3039]],
    ],
    ids=["protanopia", "deuteranopia", "tritanopia"],
)
def test_colours_of_pressures_are_distinct_for_the_colour_blind(colours, scheme, blindness):
    # Matrices of Machado, Oliveira and Fernandes (2009).
    seen = [lab(np.asarray(blindness) @ linear(colour)) for colour in colours[scheme]]
    for first, second in itertools.combinations(seen, 2):
        assert np.linalg.norm(first - second) > 10.0

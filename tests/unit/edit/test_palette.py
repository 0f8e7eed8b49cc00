"""Palette of the editor: symbols as SVG, places of ports, and declarations of fields for every kind of part."""

from __future__ import annotations

import json
import math
import re
import subprocess
import sys
import tomllib
import xml.etree.ElementTree as ElementTree
from fractions import Fraction
from itertools import pairwise
from pathlib import Path

import pytest

from poppet.circuit.file import load
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.core.errors import InputError
from poppet.core.units import quantity
from poppet.edit.palette import GROUPS, palette, sections, symbol_of, unit_table
from poppet.edit.svg_symbols import svg_text
from poppet.parts import KINDS, Cylinder, DirectionalValve, Orifice, Sequence, SpoolValve
from poppet.parts.fields import PortSpec, declared, specs
from poppet.parts.symbols import Stroke, line, outline

ENTRIES = {entry["kind"]: entry for entry in palette()}
EXAMPLES = Path(__file__).parents[3] / "examples"
INWARD = {"left": (1, 0), "right": (-1, 0), "top": (0, 1), "bottom": (0, -1)}


def places(entry) -> list[dict]:
    return [place for port in entry["ports"] for place in (port, *port["also"])]


def distance(point, stroke: Stroke) -> float:
    """Return the distance of a point from a stroke in modules of ISO 1219-1, whose symbols have a side of 8."""
    corners = [complex(8 * x - 4, 4 - 8 * y) for x, y in stroke.points]
    corners += corners[:1] if stroke.is_closed else []
    best = math.inf
    for start, end in pairwise(corners):
        length = abs(end - start) or 1.0
        axis = (end - start) / length
        along = ((complex(*point) - start) * axis.conjugate()).real
        best = min(best, abs(complex(*point) - start - axis * min(max(along, 0.0), length)))
    return best


def test_every_kind_is_in_the_palette_once():
    assert sorted(ENTRIES) == sorted(KINDS) == sorted(entry["kind"] for entry in palette())
    assert sorted(kind for kinds in GROUPS.values() for kind in kinds) == sorted(KINDS)
    assert [ENTRIES[kind]["group"] for kind in GROUPS["logic"]] == ["logic"] * len(GROUPS["logic"])


def test_palette_is_json():
    assert json.loads(json.dumps(palette(), allow_nan=False)) == palette()


@pytest.mark.parametrize("kind", KINDS)
def test_svg_is_the_strokes_of_the_schematic(kind):
    strokes = KINDS[kind].symbol
    paths = ElementTree.fromstring(f"<svg>{ENTRIES[kind]['svg']}</svg>").findall("path")
    assert len(paths) == len(strokes) > 0
    for path, stroke in zip(paths, strokes, strict=True):
        drawn = [tuple(map(float, pair.split())) for pair in re.split("[MLZ]", path.get("d")) if pair]
        expected = [(8 * x - 4, 4 - 8 * y) for x, y in stroke.points]
        assert [value for point in drawn for value in point] == pytest.approx(
            [value for point in expected for value in point], abs=1e-3
        )
        assert path.get("d").endswith("Z") == stroke.is_closed
        assert (path.get("class") == "filled") == stroke.is_filled


def test_strokes_have_classes():
    drawn = svg_text(outline((0, 0), (1, 0), (1, 1), filled=True) + line((0, 0.5), (1, 0.5), dashed=True))
    assert drawn == '<path class="filled" d="M-4 4L4 4L4 -4Z"/><path class="dashed" d="M-4 0L4 0"/>'


@pytest.mark.parametrize("kind", KINDS)
def test_ports_are_on_the_border_and_apart(kind):
    left, top, width, height = ENTRIES[kind]["box"]
    ends = {"left": left, "right": left + width, "top": top, "bottom": top + height}
    for place in places(ENTRIES[kind]):
        x, y, side = place["x"], place["y"], place["side"]
        assert {type(x), type(y)} == {int}
        assert ends[side] == (x if side in ("left", "right") else y)
        # The corners belong to two sides.
        assert left < x < left + width or top < y < top + height
    points = [(place["x"], place["y"]) for place in places(ENTRIES[kind])]
    assert len({*points}) == len(points)
    assert len({port["name"] for port in ENTRIES[kind]["ports"]}) == len(ENTRIES[kind]["ports"])


@pytest.mark.parametrize("kind", KINDS)
def test_lines_of_ports_reach_the_symbol(kind):
    for place in places(ENTRIES[kind]):
        (dx, dy), lead = INWARD[place["side"]], place["lead"]
        end = place["x"] + dx * lead, place["y"] + dy * lead
        assert min(distance(end, stroke) for stroke in KINDS[kind].symbol) < 0.01, place


@pytest.mark.parametrize("kind", KINDS)
def test_symbols_are_inside_the_box(kind):
    left, top, width, height = ENTRIES[kind]["box"]
    for drawn in filter(None, (ENTRIES[kind]["svg"], ENTRIES[kind]["svg_driven"])):
        numbers = [float(text) for text in re.findall(r"-?[\d.]+", "".join(re.findall(' d="([^"]*)"', drawn)))]
        assert left <= min(numbers[::2]) <= max(numbers[::2]) <= left + width
        assert top <= min(numbers[1::2]) <= max(numbers[1::2]) <= top + height


@pytest.mark.parametrize("kind", KINDS)
def test_required_ports_are_those_that_a_part_misses(kind):
    problems = ()
    try:
        KINDS[kind]()  # a guide needs no fields
    except InputError as error:
        problems = error.problems
    missing = {
        problem.address for problem in problems if problem.code in ("fields.missing_port", "fields.missing_body")
    }
    assert {port["name"] for port in ENTRIES[kind]["ports"] if port["required"]} == missing


def test_valve_ports_have_the_order_of_the_standard():
    """ISO 1219-1 and ISO 11727: 4 and 2 above 5, 1 and 3, and pilots 14 and 12 at the sides."""
    ports = {port["name"]: port for port in ENTRIES["spool_valve"]["ports"]}
    below = sorted((port["x"], name) for name, port in ports.items() if port["side"] == "bottom")
    above = sorted((port["x"], name) for name, port in ports.items() if port["side"] == "top")
    assert [name for _, name in below] == ["exhaust_a", "supply", "exhaust_b"]
    assert [name for _, name in above] == ["a", "b"]
    assert (ports["pilot_a"]["side"], ports["pilot_b"]["side"]) == ("left", "right")


FIXED = ["supply", "a", "b", "exhaust_a", "exhaust_b"]


@pytest.mark.parametrize("function", specs(SpoolValve)["function"].choices)
def test_ports_keep_their_places_with_every_function(function):
    valve = SpoolValve(supply="p", a="x", b="y", function=function, nominal_flow="500 l/min ANR")
    drawn = symbol_of(valve)
    where = {port["name"]: (port["x"], port["y"]) for port in drawn["ports"]}
    assert [where[name][0] for name in FIXED] == [
        port["x"] for name in FIXED for port in ENTRIES["spool_valve"]["ports"] if port["name"] == name
    ]
    assert len({*where.values()}) == len(where)
    left, top, width, height = drawn["box"]
    for x, y in where.values():
        assert x in (left, left + width) or y in (top, top + height)


def test_symbol_of_a_part_follows_its_options():
    size = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}
    two = symbol_of(DirectionalValve(supply="a", outlet="b", **size))
    three = symbol_of(DirectionalValve(supply="a", outlet="b", exhaust="ambient", **size))
    is_open = symbol_of(DirectionalValve(supply="a", outlet="b", normally="open", **size))
    assert len({two["svg"], three["svg"], is_open["svg"]}) == 3
    orifice = Orifice(from_="a", to="b", **size)
    assert symbol_of(orifice, is_driven=True)["svg"] == ENTRIES["orifice"]["svg_driven"] != symbol_of(orifice)["svg"]


def test_every_part_of_the_examples_has_its_ports():
    """Ports that a file connects, and inputs that it drives, have places of their own."""
    count = 0
    for path in EXAMPLES.glob("**/*.toml"):
        if "parts" not in tomllib.loads(path.read_text()):
            continue
        circuit = load(path)
        for name, part in circuit.parts.items():
            prefix = f"{name}."
            driven = {
                key.removeprefix(prefix) for key in (*circuit.signals, *circuit.connections) if key.startswith(prefix)
            }
            ports = symbol_of(part, is_driven=bool(driven))["ports"]
            connected = {port for port, _, _ in declared(type(part), PortSpec)} & part.ports().keys()
            assert {port["name"] for port in ports} >= connected | driven, (path, name)
            where = [(place["x"], place["y"]) for port in ports for place in (port, *port["also"])]
            assert len({*where}) == len(where), (path, name)
            count += 1
    assert count > 200


def test_ports_of_a_sequence_are_its_inputs_and_outputs():
    steps = {"wait": {"next": {"go": "run"}}, "go": {"on": ["a"], "next": {"wait": "slide.position > 8 mm"}}}
    drawn = symbol_of(Sequence(outputs=["a", "b"], inputs=["run"], start="wait", steps=steps))
    ports = {port["name"]: port["type"] for port in drawn["ports"]}
    assert {"a", "b"} == {name for name, port_type in ports.items() if port_type == "output"}
    assert ports["run"] == "input"
    sources = {port["name"]: port["source"] for port in drawn["ports"] if "source" in port}
    assert sources == {"slide_position": "slide.position"}


def test_single_acting_cylinder_has_one_chamber():
    cylinder = Cylinder(
        body="slide", bore="25 mm", stroke_length="50 mm", acting="single", cap={"dead_volume": "5 cm^3"}
    )
    assert [port["name"] for port in symbol_of(cylinder)["ports"] if port["type"] == "store"] == ["cap"]


@pytest.mark.parametrize("kind", KINDS)
def test_units_of_a_field_are_valid(kind):
    fields = [field for field in ENTRIES[kind]["fields"] if field["type"] == "number"]
    for field in fields:
        for unit in field["units"]:
            assert math.isfinite(quantity(f"1 {unit}".strip(), field["unit"], kind=field["quantity"]).value)


def test_sizes_are_those_of_the_message():
    with pytest.raises(InputError) as caught:
        KINDS["orifice"](from_="a", to="b")
    assert caught.value.code == "parts.no_size"
    assert ENTRIES["orifice"]["sizes"] == caught.value.facts["sizes"]
    for entry in ENTRIES.values():
        names = {field["name"] for field in entry["fields"]}
        assert names >= {*entry["sizes"]} | {size for group in entry["groups"] for size in group["sizes"]}


def test_models_are_components_of_the_kind():
    field = next(field for field in ENTRIES["spool_valve"]["fields"] if field["type"] == "model")
    assert "SMC SY5000" in field["choices"]
    SpoolValve(supply="p", a="x", b="y", model="SMC SY5000", function="5/2 monostable")
    other = next(field for field in ENTRIES["cylinder"]["fields"] if field["type"] == "model")
    assert other["choices"]
    assert not {*other["choices"]} & {*field["choices"]}


def test_fields_have_default_source_and_limits():
    fields = {field["name"]: field for field in ENTRIES["cylinder"]["fields"]}
    assert fields["bore"]["required"] is False  # a component can state it
    assert {field["name"]: field for field in ENTRIES["mass"]["fields"]}["mass"]["required"] is True
    ratio = next(field for field in ENTRIES["orifice"]["fields"] if field["name"] == "subsonic_index")
    assert (ratio["default"], ratio["source"], ratio["above"], ratio["high"]) == (0.5, "standard", 0.0, 2.0)
    assert "low" not in ratio
    friction = next(group for group in ENTRIES["mass"]["groups"] if group["name"] == "friction")
    assert friction["optional"]
    assert any(field["group"] == "friction" for field in ENTRIES["mass"]["fields"])


def test_palette_needs_no_heavy_package():
    heavy = "{'matplotlib', 'casadi', 'numba', 'llvmlite', 'scipy', 'pandas'}"
    script = f"import sys; from poppet.edit.palette import palette; palette(); print({heavy} & sys.modules.keys())"
    done = subprocess.run([sys.executable, "-c", script], capture_output=True, text=True, timeout=120)
    assert done.stdout == "set()\n", done.stderr


@pytest.mark.parametrize(
    ("unit", "factor", "offset", "gauge"),
    [
        ("mm", "1/1000", "0", False),
        ("psi", "8896443230521/1290320000", "0", False),  # lbf/in^2: 0.45359237 kg * 9.80665 m/s^2 / (0.0254 m)^2
        ("psi g", "8896443230521/1290320000", "0", True),
        ("degF", "5/9", "459.67", False),
        ("l/min ANR", "1.185e-3/60", "0", False),  # 1.185 kg/m^3
        ("", "1", "0", False),
    ],
)
def test_the_unit_table_is_exact(unit, factor, offset, gauge):
    top, _, bottom = factor.partition("/")
    entry = unit_table()[unit]
    assert Fraction(*map(int, entry["factor"])) == Fraction(top) / Fraction(bottom or 1)
    assert Fraction(*map(int, entry["offset"])) == Fraction(offset)
    assert entry["gauge"] is gauge


def test_flows_with_a_reference_state_can_be_converted_to_mass_flows():
    table = unit_table()
    assert table["l/min ANR"]["dimension"] == table["kg/s"]["dimension"] != table["l/min"]["dimension"]
    assert table["bar g"]["dimension"] == table["Pa"]["dimension"]


def test_the_unit_table_contains_the_units_of_all_fields_and_inputs():
    table = unit_table()
    for entry in palette():
        for field in entry["fields"]:
            assert {field.get("unit", ""), *field.get("units", ())} <= table.keys()
        assert {port["doc"] for port in entry["ports"] if port["type"] == "input"} <= table.keys()


def test_sections_contain_the_fields_of_the_options():
    names = {name: {field["name"] for field in fields} for name, fields in sections().items()}
    assert names == {"run": {*specs(Run)}, "ambient": {*specs(Ambient)}, "gas": {*specs(GasChoice)}}


def test_components_show_their_numbers():
    field = next(field for field in ENTRIES["tube"]["fields"] if field["name"] == "model")
    tube = next(item for item in field["components"] if "SMC TU0604" in item["names"])
    assert tube["sets"] == {"bore": "4 mm"}  # 6 mm outer, 4 mm inner diameter
    assert "TU" in tube["source"]
    for entry in ENTRIES.values():
        for field in entry["fields"]:
            if field["type"] == "model":
                assert {*field["choices"]} == {name for item in field["components"] for name in item["names"]}


def test_each_field_is_in_a_group_of_its_kind():
    for entry in ENTRIES.values():
        assert {field["group"] for field in entry["fields"]} - {""} <= {group["name"] for group in entry["groups"]}

"""Schematics of circuits: layers, layout, captions and symbols of every kind of part."""

from __future__ import annotations

import sys
import xml.etree.ElementTree as ElementTree
from dataclasses import dataclass
from itertools import combinations
from typing import ClassVar

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet import Circuit
from poppet.core.errors import InputError, MissingDependencyError
from poppet.core.provenance import Number, Source
from poppet.parts import (
    KINDS,
    PID,
    Antagonist,
    Chamber,
    CheckValve,
    Compressor,
    Cylinder,
    DirectionalValve,
    Electronics,
    Filter,
    FlowControlValve,
    FlowSource,
    Gripper,
    Guide,
    InverseMuscle,
    Joint,
    MainStage,
    Mass,
    Muscle,
    Orifice,
    PilotedCheckValve,
    PilotStage,
    PressureBooster,
    PressureController,
    PressureRegulator,
    ProportionalValve,
    QuickExhaustValve,
    ReliefValve,
    Reservoir,
    RotaryActuator,
    Sequence,
    ShuttleValve,
    Silencer,
    SpoolValve,
    SuctionCup,
    Switch,
    Tube,
    TwoPressureValve,
    VacuumEjector,
)
from poppet.parts.captions import CaptionNumbers
from poppet.parts.fields import NumberLike, number, port
from poppet.parts.part import Flow, Passage, PassageFlows
from poppet.report.circuit.layout import Graph, Layout, assign_layers
from poppet.report.circuit.schematic import draw_circuit, part_caption
from poppet.signals import Constant, Points, Steps

SIZE = {"sonic_conductance": "1 dm^3/(s bar)", "critical_ratio": 0.3}


def circuit_with_every_kind() -> Circuit:
    """Return a circuit with at least one part of every kind."""
    return Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "room": Reservoir(pressure="1 bar"),
            "stage": MainStage(supply="supply", outlet="rail", exhaust="ambient", data="varga2012"),
            "rail": Chamber(volume="0.2 l"),
            "switch": DirectionalValve(supply="rail", outlet="load", exhaust="room", **SIZE),
            "load": Chamber(volume="50 cm^3", thermal="polytropic", polytropic_exponent=1.2),
            "check": CheckValve(from_="rail", to="load", cracking_pressure="0.1 bar", **SIZE),
            "relief": ReliefValve(from_="rail", to="room", set_pressure="6 bar g", **SIZE),
            "silencer": Silencer(from_="load", to="ambient", **SIZE),
            "pump": FlowSource(to="rail", mass_flow_rate="20 l/min ANR"),
            "compressor": Compressor(
                "rail", free_air_delivery="200 l/min ANR", start_pressure="5 bar", stop_pressure="6 bar"
            ),
            "ejector": VacuumEjector(supply="load", vacuum="hose.1", exhaust="room", air_consumption="60 l/min ANR"),
            "cup": SuctionCup(port="hose.2", volume="5 cm^3", diameter="40 mm"),
            "reducer": PressureRegulator(supply="rail", outlet="load", exhaust="room", setpoint="4 bar", **SIZE),
            "leak": Orifice(from_="load", to="room", nominal_flow="10 l/min ANR"),
            "throttle": Orifice(from_="load", to="end", characteristic="varga2012", stroke="0.5 mm"),
            "end": Chamber(volume="0.2 m^3", thermal="isothermal"),
            "four": SpoolValve(supply="rail", a="load", b="end", **SIZE),
            "meter": FlowControlValve(from_="rail", to="end", throttle_conductance="0.5 dm^3/(s bar)", **SIZE),
            "lock": PilotedCheckValve(from_="rail", to="end", pilot="load", **SIZE),
            "clean": Filter(from_="supply", to="rail", **SIZE),
            "or": ShuttleValve(a="rail", b="load", outlet="end", **SIZE),
            "and": TwoPressureValve(a="rail", b="load", outlet="end", **SIZE),
            "quick": QuickExhaustValve(inlet="rail", outlet="end", **SIZE),
            "pilot": PilotStage(supply="supply", exhaust="ambient", data="vppm_6l"),
            "brain": Electronics(data="vppm_6l"),
            "hose": Tube(from_="end", to="load", length="3 m", bore="4 mm"),
            "regulator": ProportionalValve(supply="supply", outlet="end", exhaust="ambient", data="vppm_6l"),
            "gripper": Cylinder(
                body="arm",
                bore="25 mm",
                stroke_length="50 mm",
                cap={"dead_volume": "5 cm^3"},
                rod={"dead_volume": "5 cm^3"},
                direction=-1,
                offset="50 mm",
            ),
            "inlet": Orifice(from_="rail", to="gripper.cap", **SIZE),
            "booster": PressureBooster(
                supply="rail",
                outlet="end",
                pressure_ratio=2.0,
                bore="40 mm",
                stroke_length="40 mm",
                piston={"mass": "0.5 kg"},
                valve=SIZE,
                checks=SIZE,
            ),
            "hand": Gripper(
                bore="20 mm",
                jaw_stroke="5 mm",
                transmission=2.0,
                jaws={"mass": "0.2 kg"},
                cap={"dead_volume": "1 cm^3"},
                rod={"dead_volume": "1 cm^3"},
            ),
            "close": Orifice(from_="rail", to="hand.cap", **SIZE),
            "turner": RotaryActuator(
                displacement="20 cm^3/rad",
                swivel_angle="180 deg",
                shaft={"inertia": "0.05 kg m^2"},
                forward={"dead_volume": "10 cm^3"},
                backward={"dead_volume": "10 cm^3"},
            ),
            "turn": Orifice(from_="rail", to="turner.forward", **SIZE),
            "flexor": Muscle(body="arm", data="dmsp_20_300"),
            "nozzle": Orifice(from_="rail", to="flexor", **SIZE),
            "arm": Joint(inertia=0.02, pulley_radius="25 mm", friction={"kind": "lugre", "coulomb_torque": "0.5 N m"}),
            "slide": Mass(mass=1.0),
            "rig": Guide(),
            "pusher": Muscle(body="slide", data="dmsp_20_300"),
            "extensor": Muscle(body="rig", data="dmsp_20_300"),
            "feed": Orifice(from_="rail", to="pusher", **SIZE),
            "drain": Orifice(from_="rail", to="extensor", **SIZE),
            "loop": PID(gain="2 1/bar"),
            "linear": PressureController(
                time_constant="20 ms", volume="0.2 l", fill=SIZE, vent=SIZE, supply_pressure="7 bar"
            ),
            "inverse": InverseMuscle(data="dmsp_20_300"),
            "pair": Antagonist(data="dmsp_20_300", pulley_radius="25 mm"),
            "full": Switch(measurement="load.pressure", on_above="5 bar", off_below="4 bar"),
            "program": Sequence(
                outputs=["a"],
                start="wait",
                steps={"wait": {"next": {"go": "elapsed > 1 s"}}, "go": {"on": ["a"], "next": {}}},
            ),
        },
        {"stage.pilot_pressure": Constant(3e5), "switch.command": Steps([0.0, 1.0], [0.0, 1.0])},
        title="An island with one of each",
        connections={"pilot.fill_duty": "brain.fill_duty", "brain.outlet_pressure": "load.pressure"},
    )


@pytest.fixture(scope="module")
def schematic():
    """Return the schematic of the circuit, drawn once."""
    return draw_circuit(circuit_with_every_kind())


def texts(figure) -> list[str]:
    return [text.get_text() for text in figure.axes[0].texts]


# --- layout ---


def test_layers_increase_from_the_supply_to_the_outlet():
    edges = (
        ("valve", "supply", "supply"),
        ("valve", "outlet", "tank"),
        ("valve", "exhaust", "room"),
        ("bleed", "from", "tank"),
        ("bleed", "to", "room"),
    )
    graph = Graph(("supply", "room", "tank"), ("valve", "bleed"), edges)
    layers = assign_layers(graph, ["supply", "room"])
    assert layers == {"supply": 0, "valve": 1, "tank": 2, "bleed": 3, "room": 4}


def test_flow_source_precedes_its_tank():
    graph = Graph(("tank",), ("pump", "vent"), (("pump", "to", "tank"), ("vent", "from", "tank")))
    layers = assign_layers(graph, [])
    assert layers["pump"] < layers["tank"]


def test_unconnected_parts_have_layers():
    edges = (("pipe", "from", "a"), ("pipe", "to", "b"), ("other", "from", "c"), ("other", "to", "d"))
    assert assign_layers(Graph(tuple("abcd"), ("pipe", "other"), edges), []).keys() == {*"abcd", "pipe", "other"}


@st.composite
def graphs(draw) -> tuple[Graph, list[str]]:
    stores = tuple(f"store{k}" for k in range(draw(st.integers(2, 10))))
    passages = tuple(f"pipe{k}" for k in range(draw(st.integers(1, 10))))
    edges = []
    for passage in passages:
        ends = draw(st.lists(st.sampled_from(stores), min_size=1, max_size=3, unique=True))
        edges += [(passage, f"port{k}", end) for k, end in enumerate(ends)]
    fixed = draw(st.lists(st.sampled_from(stores), unique=True))
    return Graph(stores, passages, tuple(edges)), fixed


@settings(derandomize=True, deadline=None, max_examples=60)
@given(graphs(), st.randoms(use_true_random=False))
def test_boxes_do_not_overlap_and_edges_join_different_layers(graph_with_fixed, random):
    graph, fixed = graph_with_fixed
    layers = assign_layers(graph, fixed)
    assert layers.keys() == {*graph.stores, *graph.passages}
    assert min(layers.values()) == 0
    assert all(layers[passage] != layers[store] for passage, _, store in graph.edges)
    sizes = {name: (random.uniform(0.5, 2.5), random.uniform(0.3, 2.0)) for name in layers}
    layout = Layout(graph, layers, sizes, (0.6, 0.3), {name: random.uniform(-0.2, 0.2) for name in layers})
    for first, second in combinations(layout.positions, 2):
        a, b = layout.positions[first], layout.positions[second]
        min_x_distance = (layout.sizes[first][0] + layout.sizes[second][0]) / 2.0
        min_y_distance = (layout.sizes[first][1] + layout.sizes[second][1]) / 2.0
        assert abs(a.x - b.x) >= min_x_distance + 0.6 - 1e-9 or abs(a.y - b.y) >= min_y_distance + 0.3 - 1e-9


def test_chain_is_horizontal():
    edges = (("p", "from", "a"), ("p", "to", "b"), ("q", "from", "b"), ("q", "to", "c"))
    graph = Graph(tuple("abc"), ("p", "q"), edges)
    anchors = {"p": 0.2, "q": -0.1}
    sizes = dict.fromkeys("abcpq", (1.0, 1.0))
    layout = Layout(graph, assign_layers(graph, ["a"]), sizes, (0.5, 0.3), anchors)
    heights = [position.y + anchors.get(name, 0.0) for name, position in layout.positions.items()]
    assert max(heights) - min(heights) <= 1e-3


# --- schematic ---


def test_every_kind_of_part_has_a_symbol():
    with_symbol = {name for name, kind in KINDS.items() if kind.symbol}
    assert with_symbol == {*KINDS}
    # An FMU needs a file.
    assert {part.kind for part in circuit_with_every_kind().parts.values()} == with_symbol - {"fmu"}


def test_schematic_has_names_and_captions(schematic):
    captions = texts(schematic)
    for text in (
        "An island with one of each",
        *circuit_with_every_kind().parts,
        "7 bar",
        "200 cm³",
        "energy, adiabatic",
        "polytropic, n = 1.2",
        "C(x), b(x): varga2012",
        "x = 0.5 mm",
        "C = 1 dm³/(s bar)",
        "b = 0.3*",
        "opens at 6 bar g",
        "switches at 0.05 bar*",
        "throttle C = 0.5 dm³/(s bar)",
        "pilot ratio 3*",
        "3/2, normally closed",
        "pilot pressure: constant, 3 bar",
        "command: steps, 0 ... 1",
        "cylinder, double acting",
        "muscle, dmsp_20_300",
        "25 mm, stroke 50 mm",
        "turned round",
        "cap",
        "pulley 25 mm",
        "lugre friction 0.5 N m",
        "1 supply",
        "3 exhaust",
        "ambient",
        "* assumed",
    ):
        assert text in captions


def test_texts_are_inside_the_figure_and_do_not_overlap(schematic):
    renderer = schematic.canvas.get_renderer()
    frame = schematic.bbox
    boxes = [text.get_window_extent(renderer) for text in schematic.axes[0].texts]
    for box in boxes:
        assert frame.x0 <= box.x0 <= box.x1 <= frame.x1
        assert frame.y0 <= box.y0 <= box.y1 <= frame.y1
    overlapping = [pair for pair in combinations(boxes, 2) if overlap_fraction(*pair) > 0.1]
    assert overlapping == []


def overlap_fraction(first, second) -> float:
    """Return the fraction of the smaller box that the larger one covers."""
    width = min(first.x1, second.x1) - max(first.x0, second.x0)
    height = min(first.y1, second.y1) - max(first.y0, second.y0)
    if width <= 0.0 or height <= 0.0:
        return 0.0
    return width * height / min(first.width * first.height, second.width * second.height)


@pytest.mark.parametrize("count", [1, 9])
def test_schematic_of_a_chain_shows_all_parts(count):
    parts = {"supply": Reservoir(pressure="7 bar")}
    for k in range(count):
        parts[f"tank_{k}"] = Chamber(volume="1 l")
        parts[f"line_{k}"] = Orifice(from_=f"tank_{k - 1}" if k else "supply", to=f"tank_{k}", **SIZE)
    figure = draw_circuit(Circuit(parts))
    assert set(parts) <= set(texts(figure))


def test_signal_replaces_the_fixed_stroke():
    parts = {
        "tank": Chamber(volume="1 l"),
        "vent": Orifice(from_="tank", to="ambient", characteristic="varga2012", stroke="0.5 mm"),
    }
    driven = Circuit(parts, {"vent.stroke": Points([0.0, 1.0], [0.0, 1e-3])})
    assert "x = 0.5 mm" not in part_caption(driven, "vent")
    assert "stroke: points, 0 ... 1 mm" in texts(draw_circuit(driven))


@dataclass(frozen=True)
class Pump(Passage):
    """A part without a declared caption or symbol."""

    kind: ClassVar[str] = "rotary_pump"
    summary: ClassVar[str] = "a pump"

    to: str | None = port("gas node that receives the flow")
    speed: NumberLike = number("Hz", 10.0, doc="speed")

    def flows(self, scope, gas):
        """Return a flow in proportion to the speed."""
        mass = 1e-4 * scope["speed"]
        return PassageFlows((Flow("flow", None, "to", mass, 3e5 * mass),), {"mass_flow_rate": (mass, "kg/s")})


@dataclass(frozen=True)
class Sponge(Orifice):
    """A part with a labelled box."""

    kind: ClassVar[str] = "sponge"
    symbol: ClassVar[str] = "porous"


@pytest.mark.parametrize(("ends", "side"), [(("supply", "tank"), 1), (("tank", "supply"), -1)])
def test_symbol_points_in_the_direction_of_flow(ends, side):
    """The seat of a check valve is a corner on the side where gas enters."""
    check = {"from_": ends[0], "to": ends[1], "cracking_pressure": "0.1 bar", "sonic_conductance": 1e-8}
    circuit = Circuit(
        {
            "supply": Reservoir(pressure="7 bar"),
            "fill": Orifice(from_="supply", to="tank", sonic_conductance=1e-8, critical_ratio=0.3),
            "check": CheckValve(**check, critical_ratio=0.3),
            "tank": Chamber(volume="1 l"),
        }
    )
    axes = draw_circuit(circuit).axes[0]
    (seat,) = (line.get_xdata() for line in axes.lines if len(line.get_xdata()) == 3)
    assert (seat[0] - seat[1]) * side > 0.0


def test_kind_without_symbol_is_a_labelled_box():
    parts = {
        "tank": Chamber(volume="1 l"),
        "pump": Pump(to="tank"),
        "sponge": Sponge(from_="tank", to="ambient", **SIZE),
    }
    captions = texts(draw_circuit(Circuit(parts)))
    assert {"speed 10 Hz*", "C = 1 dm³/(s bar)", "porous"} <= set(captions)
    assert captions.count("rotary pump") == 2  # label and caption


@pytest.mark.parametrize(
    ("value", "unit", "text"),
    [
        (7e5, "Pa", "7 bar"),
        (293.15, "K", "20 °C"),
        (0.2, "m^3", "0.2 m³"),
        (2e-3, "m^3", "2 l"),
        (5e-5, "m^3", "50 cm³"),
        (1.65e-8, "m^3/(s Pa)", "1.65 dm³/(s bar)"),
        (45.0, "W/K", "45 W/K"),
        (0.3, "1", "0.3"),
    ],
)
def test_captions_use_readable_units(value, unit, text):
    numbers = CaptionNumbers({}.__getitem__)
    assert numbers.text(Number(value, unit, Source("given"))) == text
    assert numbers.text(Number(value, unit, Source("assumed"))) == f"{text}*"


@pytest.mark.parametrize("suffix", ["svg", "png"])
def test_equal_circuits_give_equal_files(tmp_path, suffix):
    circuit = Circuit({"tank": Chamber(volume="1 l"), "vent": Orifice(from_="tank", to="ambient", **SIZE)})
    contents = []
    for folder in ("one", "two"):
        path = tmp_path / folder / f"circuit.{suffix}"
        path.parent.mkdir()
        draw_circuit(circuit, path)
        contents.append(path.read_bytes())
    assert contents[0] == contents[1]
    if suffix == "svg":
        assert ElementTree.fromstring(contents[0]).tag.endswith("svg")


def test_unsupported_suffix_is_refused(tmp_path):
    with pytest.raises(InputError) as caught:
        draw_circuit(circuit_with_every_kind(), tmp_path / "circuit.txt")
    assert caught.value.code == "files.suffix"


def test_missing_matplotlib_is_reported(monkeypatch):
    monkeypatch.setitem(sys.modules, "matplotlib", None)
    with pytest.raises(MissingDependencyError) as caught:
        draw_circuit(circuit_with_every_kind())
    assert caught.value.facts["package"] == "matplotlib"


def test_tube_connects_the_port_that_names_it_and_its_other_end():
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": Orifice(from_="supply", to="hose", **SIZE),
        "hose": Tube(from_="valve.to", to="end", length="3 m", bore="4 mm", inertia=True),
        "end": Chamber(volume="1 l"),
    }
    captions = texts(draw_circuit(Circuit(parts)))
    assert {"hose", "3 m, bore 4 mm", "8 cells, with waves", "1"} <= {*captions}
    assert "ambient" not in captions

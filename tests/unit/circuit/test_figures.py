"""Load metrics: closed forms, the second law, independence of tolerance and output times."""

from __future__ import annotations

import json
import math
import pickle
import sys
from pathlib import Path

import numpy as np
import pytest

import poppet
from poppet import Circuit
from poppet.circuit.load_metrics import turning_points
from poppet.parts import Chamber, Cylinder, DirectionalValve, Guide, Joint, Mass, Orifice, Reservoir
from poppet.timeseries.signals import Points, Steps

sys.path.insert(0, str(Path(__file__).parents[2] / "laws"))
from seeded_machines import random_machine

EXAMPLES = Path(__file__).parents[3] / "examples"
BORE, STROKE, DEAD, SUPPLY = 0.04, 0.2, 2e-5, 6e5
AREA = math.pi / 4 * BORE**2
MASS = 20.0
SIZE = {"sonic_conductance": 1e-9, "critical_ratio": 0.3}


def lift(conductance: float = 1e4, signals=None, **fields) -> Circuit:
    """Return a circuit in which a single-acting cylinder lifts a mass, nearly isothermal, with low viscous friction."""
    side = {"dead_volume": DEAD, "wall_conductance": conductance}
    slide = Mass(mass=MASS, inclination="90 deg", friction={"viscous_coefficient": 300.0}, **fields)
    parts = {
        "supply": Reservoir(pressure=SUPPLY),
        "fill": Orifice(from_="supply", to="cylinder.cap", **SIZE),
        "cylinder": Cylinder(body="slide", bore=BORE, stroke_length=STROKE, acting="single", cap=side),
        "slide": slide,
    }
    return Circuit(parts, signals or {})


def test_work_and_air_of_an_isothermal_lift():
    recording = lift().simulate(20.0)
    figures, last = recording.figures, recording.last()
    height = last["slide.position"] - recording["slide.position"][0]
    assert height == pytest.approx(STROKE, rel=0.01)
    (work,) = figures.works
    assert work.on_load == pytest.approx(MASS * 9.80665 * height, rel=1e-9)
    # What the cap has taken, from ambient pressure on: p V over the density of the standard.
    volume = DEAD + AREA * height
    mass = (SUPPLY * volume - 1e5 * DEAD) / (287.05 * 293.15)
    assert figures.air == {"supply": pytest.approx(mass / 1.185, rel=1e-3)}
    assert figures.air_used == figures.air["supply"]
    assert figures.exergy == pytest.approx(mass * 287.05 * 293.15 * math.log(6.0), rel=1e-3)
    # Of what stays in the volume: p ln(p/p_a) - (p - p_a) times V, which was nothing before.
    assert figures.stored == pytest.approx(volume * (SUPPLY * math.log(6.0) - (SUPPLY - 1e5)), rel=1e-3)
    (arrival,) = figures.arrivals[:1]
    assert arrival.part == "cylinder"
    # The air pushes with p A all the way but for the start; viscous friction and the cover take the rest.
    assert work.done == pytest.approx(work.on_load + work.lost, rel=1e-6)
    assert work.returned == 0.0
    assert figures.efficiency == work.done / figures.exergy


def test_work_of_lifting_is_returned_by_lowering():
    weight = MASS * 9.80665
    circuit = lift(
        signals={"supply.pressure": Points([0.0, 0.5, 5.0, 10.0], [1e5, 3e5, 3e5, 1e5])}, initial_position=0.1
    )
    recording = circuit.simulate(12.0)
    (work,) = recording.figures.works
    first, last = recording["slide.position"][[0, -1]]
    assert work.on_load == pytest.approx(weight * (last - first), rel=1e-9, abs=1e-9)
    assert work.returned > 1.0
    gained = 0.5 * MASS * recording["slide.velocity"][-1] ** 2
    assert work.done - work.returned == pytest.approx(work.on_load + work.lost + gained, abs=1e-9)


def test_stroke_time_of_a_motion_at_constant_acceleration():
    side = {"dead_volume": "1 m^3"}
    hollow = Cylinder(body="slide", bore="1 mm", stroke_length="10 m", offset="5 m", cap=side, rod=side)
    circuit = Circuit({"slide": Mass(mass=2.0), "cylinder": hollow}, {"slide.load_force": Steps([0.0], [-4.0])})
    (stroke,) = circuit.simulate(1.0).figures.strokes
    assert stroke.travel == pytest.approx(1.0, rel=1e-4)
    # x = t^2, from 2 % to 98 %
    assert stroke.start == pytest.approx(math.sqrt(0.02), rel=1e-4)
    assert stroke.duration == pytest.approx(math.sqrt(0.98) - math.sqrt(0.02), rel=1e-4)
    assert stroke.mean_speed == pytest.approx(0.96 / stroke.duration, rel=1e-4)
    assert stroke.peak_speed == pytest.approx(2.0, rel=1e-4)


@pytest.mark.parametrize("step", [1e-3, 7e-3])
def test_impact_speed_does_not_depend_on_the_rows(step):
    side = {"dead_volume": "1 m^3"}
    hollow = Cylinder(body="slide", bore="1 mm", stroke_length="10 m", offset="5 m", cap=side, rod=side)
    stop = {"position": -0.5, "stiffness": 1e7, "dissipation": 2.0}
    slide = Mass(mass=2.0, inclination="90 deg", lower_stop=stop)
    recording = Circuit({"slide": slide, "cylinder": hollow}).simulate(0.4, step)
    first = recording.figures.arrivals[0]
    assert first.velocity == pytest.approx(-math.sqrt(2 * 9.80665 * 0.5), rel=1e-4)
    assert first.time == pytest.approx(math.sqrt(2 * 0.5 / 9.80665), rel=1e-4)
    note = next(note for note in recording.remarks if note.code == "bodies.met_stop")
    assert note.facts["speed"] == pytest.approx(abs(first.velocity))


@pytest.mark.parametrize("name", ["cylinder_meter_out", "vertical_load", "muscle_lift"])
def test_metrics_do_not_depend_on_the_tolerance(name):
    circuit = poppet.load(EXAMPLES / f"{name}.toml")
    usual, tight = (circuit.simulate(relative_tolerance=tolerance).figures for tolerance in (1e-6, 5e-7))
    assert len(usual.strokes) == len(tight.strokes) == 2
    for usual_metrics, tight_metrics in zip(usual.strokes, tight.strokes, strict=True):
        for field in ("start", "duration", "travel", "mean_speed", "peak_speed"):
            assert getattr(usual_metrics, field) == pytest.approx(getattr(tight_metrics, field), rel=5e-3), field
    # The first of each end; what comes after is a rebound.
    for sign in (1.0, -1.0):
        first = [
            next((a.velocity for a in metrics.arrivals if sign * a.velocity > 0.0), 0.0) for metrics in (usual, tight)
        ]
        assert first[0] == pytest.approx(first[1], rel=5e-3)
    scale = usual.work
    for usual_metrics, tight_metrics in zip(usual.works, tight.works, strict=True):
        for field in ("done", "returned", "on_load", "lost"):
            assert getattr(usual_metrics, field) == pytest.approx(
                getattr(tight_metrics, field), rel=5e-3, abs=1e-3 * scale
            ), field
    for field in ("air_used", "exergy", "work", "efficiency"):
        assert getattr(usual, field) == pytest.approx(getattr(tight, field), rel=5e-3), field


def test_work_does_not_exceed_the_exergy():
    generator = np.random.default_rng(77)
    for number in range(8):
        recording = random_machine(generator).simulate(1.0, 2e-3)
        figures = recording.figures
        net = sum(work.done - work.returned for work in figures.works)
        scale = abs(figures.exergy) + abs(figures.stored) + figures.work
        assert net <= figures.exergy - figures.stored + 1e-3 * scale, number
        assert all(work.lost >= -1e-3 * scale for work in figures.works), number


def test_turning_points_omit_small_reversals():
    back = 1.0 - 0.15 * np.sin(np.linspace(0.0, np.pi, 20))
    creeping = np.concatenate((np.linspace(0.0, 1.0, 50), back, np.linspace(1.0, 0.0, 50)))
    turns = turning_points(creeping, 0.2)
    assert [round(float(creeping[k]), 9) for k in turns] == [0.0, 1.0, 0.0]
    assert turning_points(np.zeros(5), 0.2) == []


def test_small_moves_are_strokes_with_their_own_impacts_and_commands():
    """Check moves of 10 mm back and 15 mm forth after one of 100 mm, whose times follow from the recorded rows."""
    circuit = poppet.load(EXAMPLES / "cylinder_position.toml")
    changes = [0.2, 1.5, 2.5]
    signals = {"position.setpoint": Steps([0.0, *changes], [0.05, 0.15, 0.14, 0.155])}
    recording = circuit.with_signals(signals).simulate(3.5, 1e-3)
    strokes = recording.figures.strokes
    assert [round(1e3 * stroke.travel, -1) for stroke in strokes] == [100.0, -10.0, 20.0]
    time, position = recording.time, recording["slide.position"]
    for stroke, change in zip(strokes, changes, strict=True):
        assert (stroke.command, stroke.command_time) == ("position.setpoint", change)
        rows = (time >= change) & (time < change + 0.9)
        way = np.abs(position[rows] - position[rows][0])
        arrival = time[rows][way >= 0.98 * way.max()][0]
        assert stroke.from_command == pytest.approx(arrival - change, abs=1.1e-3)
        assert stroke.start > change


def test_command_of_a_stroke_is_that_of_the_sequence():
    recording = poppet.load(EXAMPLES / "two_cylinders.toml").simulate(4.0)
    strokes = recording.figures.strokes
    assert len(strokes) >= 8
    for stroke in strokes:
        valve, step = {"slideA": ("valveA", "A"), "slideB": ("valveB", "B")}[stroke.body]
        assert stroke.command == f"{valve}.command"
        # The number of the step that begins with this command is in the row of the command.
        names = ["wait", "A+", "B+", "B-", "A-", "fault"]
        row = np.searchsorted(recording.time, stroke.command_time)
        assert names[int(recording["plc.step"][row]) - 1] == step + ("+" if stroke.travel > 0.0 else "-")


def test_command_of_a_bistable_valve_is_the_one_that_is_set():
    template = Path(poppet.__file__).parent / "cli" / "templates" / "machine.toml"
    strokes = [s for s in poppet.load(template).simulate(1.5).figures.strokes if s.body == "slideB"]
    # Both commands of the valve change at the beginning of the return stroke.
    assert [stroke.command for stroke in strokes] == ["valveB.command_a", "valveB.command_b"]


def test_peak_speed_of_few_rows_is_at_least_the_mean_speed():
    path = Path(poppet.__file__).parent / "cli" / "templates" / "machine.toml"
    strokes = poppet.load(path).simulate(1.5, output_step=0.2).figures.strokes
    assert len(strokes) >= 4
    assert all(stroke.peak_speed >= stroke.mean_speed for stroke in strokes)


def test_arrival_belongs_to_the_move_that_met_the_stop():
    side = {"dead_volume": "1 m^3"}
    hollow = Cylinder(body="slide", bore="1 mm", stroke_length="10 m", offset="5 m", cap=side, rod=side)
    stop = {"position": 1.0, "stiffness": 1e6, "dissipation": 20.0}
    circuit = Circuit(
        {"slide": Mass(mass=2.0, upper_stop=stop), "cylinder": hollow},
        # Up to the stop, then back for 0.4 s.
        {"slide.load_force": Steps([0.0, 8.0, 8.4], [-4.0, 2.0, -4.0])},
    )
    recording = circuit.simulate(12.0, 2e-3)
    figures, last = recording.figures, recording["slide.velocity"][recording.time > 8.4].max()
    speeds = [arrival and arrival.velocity for arrival in map(figures.met, figures.strokes)]
    assert speeds == [pytest.approx(2.0, rel=1e-3), None, pytest.approx(last, rel=0.01)]
    assert last < 0.8
    assert [stroke.command for stroke in figures.strokes] == [None] * 3


def test_commands_of_another_cylinder_cause_no_stroke():
    """Two drives at one finite supply: each stroke names the command of its own valve."""
    parts, signals = {"supply": Chamber(volume="50 l", initial_pressure="7 bar")}, {}
    for name, change in (("a", 0.3), ("b", 0.31)):
        valve = {"supply": "supply", "outlet": f"{name}.cap", "exhaust": "ambient", "switching_time": "10 ms"}
        parts[f"valve_{name}"] = DirectionalValve(**valve, **SIZE)
        parts[name] = Cylinder(body=f"slide_{name}", bore=BORE, stroke_length=STROKE, acting="single",
                               cap={"dead_volume": DEAD})  # fmt: skip
        parts[f"slide_{name}"] = Mass(mass=1.0, friction={"viscous_coefficient": 200.0})
        signals[f"valve_{name}.command"] = Steps([0.0, change], [0.0, 1.0])
    strokes = Circuit(parts, signals).simulate(1.0, 1e-3).figures.strokes
    assert {stroke.body: stroke.command for stroke in strokes if stroke.travel > 0.1} == {
        f"slide_{name}": f"valve_{name}.command" for name in "ab"
    }


def test_joints_have_metrics_of_torque_and_angle():
    side = {"dead_volume": DEAD, "initial_pressure": 3e5}
    cylinder = Cylinder(
        body="arm", bore=BORE, stroke_length=STROKE, offset=STROKE / 2, cap=side, rod={"dead_volume": 1.0}
    )
    circuit = Circuit({"arm": Joint(inertia=0.05, pulley_radius=0.05), "cylinder": cylinder})
    figures = circuit.simulate(0.03).figures
    assert figures.strokes[0].unit == "rad"
    assert figures.works[0].done > 1.0
    assert figures.works[0].lost == pytest.approx(0.0, abs=1e-3)
    assert math.isnan(figures.efficiency)
    assert figures.as_dict()["efficiency"] is None
    assert figures.air == {}


def test_only_runs_with_bodies_have_load_metrics():
    tank = Circuit({"tank": Chamber(volume="1 l"), "vent": Orifice(from_="tank", to="ambient", **SIZE)})
    assert tank.simulate(1.0).figures is None
    guide = Circuit({
        "slide": Guide(), "vent": Orifice(from_="cylinder.cap", to="ambient", **SIZE),
        "cylinder": Cylinder(body="slide", bore=BORE, stroke_length=STROKE, acting="single", cap={"dead_volume": DEAD}),
    })  # fmt: skip
    assert guide.simulate(1.0).figures is None
    recording = lift().simulate(1.0)
    restored = pickle.loads(pickle.dumps(recording)).figures
    assert restored == recording.figures == recording.converted(["bar"]).select("slide.*").figures
    assert json.loads(json.dumps(restored.as_dict()))["works"][0]["body"] == "slide"

"""Errors of bodies and actuators, by their codes."""

from __future__ import annotations

from typing import Any

import pytest

from poppet import Circuit, loads
from poppet.parts import Chamber, Cylinder, Guide, Joint, Mass, Orifice
from poppet.timeseries.signals import Chirp, Constant, Points, Steps
from refusals import refused

SIDE = {"dead_volume": "5 cm^3"}
SIZE: dict[str, Any] = {"bore": "25 mm", "stroke_length": "160 mm"}


def cylinder(**fields: Any) -> Cylinder:
    return Cylinder(**{"body": "slide", **SIZE, "cap": SIDE, "rod": SIDE, **fields})


def circuit(body: Any = None, signals: Any = None, **parts: Any) -> Circuit:
    return Circuit({"slide": body or Mass(mass=1.0), "cylinder": cylinder(), **parts}, signals or {})


def test_a_closed_cylinder_is_a_circuit():
    assert circuit().simulate(0.1).time[-1] == pytest.approx(0.1)


def test_inherited_parameter_of_a_member_is_rejected():
    names = set(cylinder().numbers())
    assert {"bore", "stroke_length", "leakage.sonic_conductance", "end_stop.stiffness", "cap.dead_volume"} <= names
    assert not {name for name in names if name.startswith("piston.")} - {
        "piston.subsonic_index",
        "piston.laminar_ratio",
    }
    assert "cap.outer_diameter" not in names


def test_invalid_bodies_are_rejected():
    with refused("fields.not_an_option", "parts.other.body", value="slid"):
        circuit(other=cylinder(body="slid"))
    with refused("wiring.no_body", "parts.other.body", body="cylinder"):
        circuit(other=cylinder(body="cylinder"))
    with refused("wiring.unmoved", "parts.idle"):
        circuit(idle=Mass(mass=1.0))
    with refused("fields.not_a_name", "body"):
        cylinder(body=["slide", "idle"])
    with refused("fields.missing_body", "body"):
        cylinder(body=None)


def test_invalid_chambers_are_rejected():
    leak = {"sonic_conductance": 1e-9, "critical_ratio": 0.3}
    with refused("wiring.several_stores", "parts.leak.to", stores=["cylinder.cap", "cylinder.rod"]):
        circuit(leak=Orifice(from_="ambient", to="cylinder", **leak))
    single = cylinder(acting="single", rod=None, body="slide")
    with refused("fields.not_an_option", "parts.leak.to", value="single.rod"):
        circuit(single=single, leak=Orifice(from_="ambient", to="single.rod", **leak))
    with refused("wiring.no_store", "parts.leak.to", store="slide"):
        circuit(leak=Orifice(from_="ambient", to="slide", **leak))
    with refused("wiring.alone", "parts.tank"):
        circuit(tank=Chamber(volume="1 l"))


def test_contradicting_parameters_are_rejected():
    with refused("cylinder.rod_too_thick", "rod_diameter"):
        cylinder(rod_diameter="30 mm")
    with refused("bodies.direction", "direction", value=0.5):
        cylinder(direction=0.5)
    with refused("parts.no_such_member", "rod"):
        cylinder(acting="single")
    with refused("fields.out_of_range", "cap.dead_volume"):
        cylinder(cap={"dead_volume": "-1 cm^3"})
    with refused("bodies.no_friction_force", "friction.coulomb_torque"):
        Joint(inertia=1.0, pulley_radius=0.1, friction={"kind": "lugre"})
    elastic = {"kind": "elasto_plastic", "coulomb_force": 10.0, "static_force": 15.0, "breakaway_displacement": 7e-6}
    with refused("bodies.breakaway", "friction.breakaway_displacement", value=7e-6, limit=pytest.approx(1e-4 / 15)):
        Mass(mass=1.0, friction=elastic)
    with refused("bodies.no_transition", "friction.transition_velocity"):
        Mass(mass=1.0, friction={"kind": "stribeck", "coulomb_force": 3.0})
    with refused("parts.stops_exchanged", "lower_stop.position"):
        Mass(mass=1.0, lower_stop={"position": 0.2}, upper_stop={"position": 0.1})
    with refused("bodies.beyond_stop", "initial_position", value=0.3):
        Mass(mass=1.0, initial_position=0.3, upper_stop={"position": 0.1})


@pytest.mark.parametrize("start", [0.17, -0.01])
def test_initial_position_outside_the_stroke_is_rejected(start):
    with refused("cylinder.beyond_cover", "cylinder.stroke_length", stroke=0.16):
        circuit(Mass(mass=1.0, initial_position=start))
    with refused("cylinder.beyond_cover", "cylinder.stroke_length"):
        circuit(Guide(), {"slide.position": Constant(start)})
    turned = cylinder(direction=-1, offset="160 mm")
    with refused("cylinder.beyond_cover", "turned.stroke_length"):
        circuit(Joint(inertia=1.0, pulley_radius=0.1, initial_position=10.0 * start), turned=turned)


def test_guide_accepts_only_signals_without_jumps():
    with refused("signals.jumps", "signals.slide.position", time=1.0):
        circuit(Guide(), {"slide.position": Steps([0.0, 1.0], [0.0, 0.1])}).simulate(2.0)
    with refused("signals.swept", "signals.slide.position"):
        sweep = Chirp(mean=0.05, amplitude=0.01, frequency=1.0, end_frequency=2.0, duration=1.0)
        circuit(Guide(), {"slide.position": sweep}).simulate(1.0)
    with refused("names.unknown", "signals.slide.velocity"):
        circuit(Guide(), {"slide.velocity": Constant(0.1)})
    with refused("wiring.signal_only", "connections.slide.position"):
        parts = {"slide": Guide(), "cylinder": cylinder(), "free": Mass(mass=1.0), "other": cylinder(body="free")}
        Circuit(parts, connections={"slide.position": "free.position"})


def test_velocity_of_a_guide_is_the_slope_of_its_signal():
    moving = circuit(Guide(), {"slide.position": Points([0.0, 1.0, 2.0], [0.0, 0.1, 0.05])}).simulate(2.0, 0.5)
    assert moving["slide.velocity"].tolist() == pytest.approx([0.1, 0.1, -0.05, -0.05, -0.05])


def test_all_errors_of_a_file_are_reported_with_units():
    text = """
[parts.slide]
kind = "mass"
mass = "4 kg"
friction = {kind = "lugre", coulomb_force = "20 N m"}
[parts.cylinder]
kind = "cylinder"
bore = "25 mm"
stroke_length = "160 mm"
body = "slid"
cap.dead_volume = "-5 cm^3"
rod.dead_volume = "5 cm^3"
"""
    with refused("fields.out_of_range", "parts.cylinder.cap.dead_volume") as caught:
        loads(text)
    codes = {problem.code for problem in caught.value.problems}
    assert codes == {"fields.out_of_range", "quantity.other_quantity", "fields.not_an_option"}


def test_tables_of_friction_over_the_position_are_checked():
    def slide(**table: Any) -> Mass:
        return Mass(mass=1.0, friction={"position_factor": table})

    with refused("schedule.not_a_table", "friction.position_factor"):
        Mass(mass=1.0, friction={"position_factor": 2.0})
    with refused("fields.unknown", "friction.position_factor.angle"):
        slide(angle=[0.0, 1.0], position=[0.0, 1.0], factor=[1.0, 2.0])
    with refused("schedule.unequal_lengths", "friction.position_factor"):
        slide(position=[0.0, 1.0], factor=[1.0])
    with refused("fields.out_of_range", "friction.position_factor.factor_2"):
        slide(position=[0.0, 1.0], factor=[1.0, 0.0])
    with refused("schedule.not_rising", "slide.friction.position_factor.position"):
        circuit(slide(position=[1.0, 0.0], factor=[1.0, 2.0]))
    friction = {"kind": "elasto_plastic", "coulomb_force": 10.0, "bristle_stiffness": 1e6}
    with refused("bodies.breakaway", "friction.breakaway_displacement", limit=2e-6):
        Mass(mass=1.0, friction={**friction, "negative_coulomb_force": 2.0, "breakaway_displacement": 5e-6})


def test_numbers_of_a_table_of_friction_have_addresses():
    before = circuit(Mass(mass=1.0, friction={"position_factor": {"position": [0.0, "50 mm"], "factor": [1.0, 2.0]}}))
    assert str(before.numbers()["slide.friction.position_factor.position_2"]) == "50 mm"
    after = before.with_values(
        {"slide.friction.position_factor.factor_2": 3.0, "slide.friction.viscous_coefficient": 5.0}
    )
    assert after.parameters["slide.friction.position_factor.factor_2"] == 3.0
    assert before.parameters["slide.friction.position_factor.factor_2"] == 2.0
    assert after.structure == before.structure
    with refused("names.unknown", "slide.friction.position_factor.factor_3"):
        before.with_values({"slide.friction.position_factor.factor_3": 3.0})


@pytest.mark.parametrize("kind", ["none", "viscous"])
def test_dry_friction_without_a_law_for_it_gives_a_note(kind):
    """The default law is viscous: a Coulomb force alone had no effect and no message."""
    friction = {"kind": kind, "coulomb_force": "20 N", "viscous_coefficient": "50 N s/m"}
    (note,) = [note for note in circuit(Mass(mass=1.0, friction=friction)).static_notes if "friction" in note.address]
    assert (note.code, note.address, note.facts["law"]) == (
        "bodies.idle_friction", "slide.friction.coulomb_force", kind,
    )  # fmt: skip
    for complete in (friction | {"kind": "elasto_plastic"}, {"viscous_coefficient": "50 N s/m"}):
        notes = circuit(Mass(mass=1.0, friction=complete)).static_notes
        assert not any(note.code == "bodies.idle_friction" for note in notes)

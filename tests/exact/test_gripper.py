"""Gripper: gripping force, opening, an equal cylinder with a mass, balances and exergy."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from poppet import Circuit, Cylinder, DirectionalValve, Gripper, InputErrors, Mass, Reservoir, SpoolValve
from poppet.timeseries.signals import Steps
from refusals import refused

SIDE = {"dead_volume": "1 cm^3"}
BORE, ROD, STROKE, JAWS = 0.02, 0.008, 0.005, 0.2
AREA, RING = (0.25 * math.pi * (BORE**2 - rod**2) for rod in (0.0, ROD))
PATH = {"sonic_conductance": 1e-9, "critical_ratio": 0.3}
VISCOUS = {"mass": JAWS, "friction": {"viscous_coefficient": 20.0}}
WIDTH = 0.004
CLOSE, OPEN = Steps([0.0], [1.0]), Steps([0.0], [-1.0])


def gripper(**fields: Any) -> Gripper:
    size = {"bore": BORE, "rod_diameter": ROD, "jaw_stroke": STROKE, "jaws": VISCOUS, "cap": SIDE, "rod": SIDE}
    return Gripper(**{**size, **fields})


def driven(command: Any = CLOSE, signals: Any = None, **fields: Any) -> Circuit:
    valve: Any = SpoolValve(supply="supply", a="gripper.cap", b="gripper.rod", **PATH)
    if fields.get("acting") == "single":
        valve = DirectionalValve(supply="supply", outlet="gripper.cap", exhaust="ambient", **PATH)
    parts = {"supply": Reservoir(pressure=7e5), "valve": valve, "gripper": gripper(**fields)}
    return Circuit(parts, {"valve.command": command, **(signals or {})})


@pytest.mark.parametrize(
    ("command", "fields", "force"),
    [
        (CLOSE, {"transmission": 2.0}, AREA * 6e5 / 4.0),
        (CLOSE, {"rated_force": 45.0}, 45.0),
        (CLOSE, {"rated_force": 45.0, "rated_pressure": "5 bar"}, 45.0 * 6.0 / 5.0),
        (OPEN, {"transmission": 2.0, "direction": -1}, RING * 6e5 / 4.0),
        (OPEN, {"rated_force": 45.0, "direction": -1}, 45.0),
        (OPEN, {"rated_force": 45.0, "gripping": "internal"}, 45.0),
        (CLOSE, {"rated_force": 45.0, "gripping": "internal", "direction": -1}, 45.0),
    ],
)
def test_gripping_force_and_opening(command, fields, force):
    start = {**VISCOUS, "initial_position": STROKE} if fields.get("gripping") == "internal" else VISCOUS
    workpiece = {"width": WIDTH, "stiffness": 1e8}
    last = driven(command, workpiece=workpiece, jaws=start, **fields).simulate(3.0).last()
    assert last["gripper.gripping_force"] == pytest.approx(force, rel=1e-5)
    depth = (force / 1e8) ** (2.0 / 3.0)
    sign = -1.0 if fields.get("gripping") == "internal" else 1.0
    assert last["gripper.opening"] == pytest.approx(WIDTH - sign * 2.0 * depth, rel=1e-5)
    assert last["gripper.opening"] == pytest.approx(2.0 * (STROKE - last["gripper.jaws.position"]), rel=1e-9)


@pytest.mark.parametrize(("direction", "command"), [(1, CLOSE), (-1, OPEN)])
def test_jaws_without_a_workpiece_close_completely(direction, command):
    last = driven(command, transmission=0.5, direction=direction, closed_opening="3 mm").simulate(3.0).last()
    depth = ((AREA if direction > 0 else RING) * 6e5 / 1e8) ** (2.0 / 3.0)  # of the piston into its cover
    assert last["gripper.opening"] == pytest.approx(0.003 - 2.0 * 0.5 * depth, rel=1e-5)
    assert last["gripper.gripping_force"] == 0.0


def test_a_spring_opens_a_single_acting_gripper():
    spring = {"rate": "2 N/mm", "preload": "5 mm"}
    fields = {"acting": "single", "rod": None, "spring": spring, "workpiece": {"width": WIDTH}, "transmission": 1.0}
    circuit = driven(Steps([0.0, 1.0], [1.0, 0.0]), **fields)
    recording = circuit.simulate(3.0, 0.5)
    travel = recording["gripper.piston_position"][1]
    expected = 0.5 * (AREA * 6e5 - 2000.0 * (0.005 + travel))
    assert recording["gripper.gripping_force"][1] == pytest.approx(expected, rel=1e-5)
    assert recording["gripper.opening"][-1] == pytest.approx(2.0 * STROKE, abs=1e-4)


def test_jaws_close_further_if_the_workpiece_is_removed():
    signals = {"gripper.workpiece": Steps([0.0, 1.0], [1.0, 0.0])}
    recording = driven(signals=signals, workpiece={"width": WIDTH}, transmission=1.0).simulate(3.0, 0.5)
    assert recording["gripper.opening"][1] == pytest.approx(WIDTH, abs=2e-4)
    assert recording["gripper.opening"][-1] == pytest.approx(0.0, abs=5e-4)
    assert recording["gripper.gripping_force"][[1, -1]] == pytest.approx([AREA * 6e5 / 2.0, 0.0], rel=1e-4)


def test_a_gripper_moves_as_a_cylinder_with_a_mass():
    """The transmission i changes masses by i^2, the stiffness of the contact of both jaws by 2 i^2.5."""
    ratio = 1.6
    workpiece = {"width": WIDTH, "stiffness": 1e7, "dissipation": 5.0}
    one = driven(transmission=ratio, workpiece=workpiece).simulate(0.2, 1e-3, 1e-8)
    slide = Mass(
        mass=JAWS * ratio**2,
        friction={"viscous_coefficient": 20.0 * ratio**2},
        upper_stop={
            "position": (STROKE - WIDTH / 2.0) / ratio, "stiffness": 2e7 * ratio**2.5, "dissipation": 5.0 * ratio
        },
    )  # fmt: skip
    cylinder = Cylinder(body="slide", bore=BORE, rod_diameter=ROD, stroke_length=STROKE / ratio, cap=SIDE, rod=SIDE)
    valve = SpoolValve(supply="supply", a="cylinder.cap", b="cylinder.rod", **PATH)
    parts = {"supply": Reservoir(pressure=7e5), "valve": valve, "cylinder": cylinder, "slide": slide}
    other = Circuit(parts, {"valve.command": CLOSE}).simulate(0.2, 1e-3, 1e-8)
    travel = ratio * other["slide.position"]
    assert np.ptp(travel) > 0.002
    assert np.abs(one["gripper.jaws.position"] - travel).max() < 1e-6 * np.ptp(travel)
    for name in ("cap.pressure", "rod.temperature", "force"):
        assert (
            np.abs(one[f"gripper.{name}"] - other[f"cylinder.{name}"]).max()
            < 1e-5 * np.abs(other[f"cylinder.{name}"]).max()
        )


def test_balances_exergy_and_notes_of_a_cycle():
    jaws = {"mass": JAWS, "friction": {"kind": "lugre", "coulomb_force": 2.0}}
    circuit = driven(Steps([0.0, 0.1, 1.0], [0.0, 1.0, -1.0]), jaws=jaws, workpiece={"width": WIDTH}, rated_force=45.0)
    recording = circuit.simulate(2.0, 1e-3)
    assert [residual for residual in recording.residuals if not residual.is_kept] == []
    assert {residual.quantity for residual in recording.residuals} == {"mass", "energy", "motion"}
    figures = recording.figures
    assert 0.0 < figures.work < figures.exergy - figures.stored
    assert [stroke.command for stroke in figures.strokes] == ["valve.command"] * 2
    # Only the return ends at a cover.
    (note,) = [note for note in recording.remarks if note.code == "bodies.met_stop"]
    assert (note.address, note.facts["count"]) == ("gripper.piston_velocity", 1)


def test_a_settled_gripper_takes_large_steps():
    jaws = {"mass": JAWS, "friction": {"kind": "lugre", "coulomb_force": 2.0}}
    circuit = driven(jaws=jaws, workpiece={"width": WIDTH}, rated_force=45.0)
    short, long = (circuit.simulate(duration).statistics["accepted_steps"] for duration in (3.0, 3000.0))
    assert long < short + 100


def test_a_run_continues_another_run():
    circuit = driven(workpiece={"width": WIDTH}, rated_force=45.0)
    first = circuit.simulate(3.0)
    again = circuit.resumed(first).simulate(0.1)
    for name in ("jaws.position", "jaws.velocity", "cap.pressure", "rod.temperature", "gripping_force"):
        assert again[f"gripper.{name}"][0] == pytest.approx(first[f"gripper.{name}"][-1], rel=1e-6)


def test_inputs_and_addresses():
    circuit = driven(workpiece={"width": WIDTH})
    assert {"gripper.workpiece", "gripper.jaws.load_force"} <= set(circuit.inputs)
    assert "gripper.workpiece" not in driven().inputs
    names = set(circuit.numbers())
    assert {"gripper.jaw_stroke", "gripper.jaws.mass", "gripper.workpiece.width", "gripper.cap.dead_volume"} <= names
    assert not {"gripper.jaws.jaw_stroke", "gripper.jaws.workpiece.width", "gripper.piston.bore"} & names
    wider = circuit.with_values({"gripper.workpiece.width": "6 mm", "gripper.jaw_stroke": "4 mm"})
    assert wider.parameters["gripper.jaws.workpiece.width"] == 0.006
    assert wider.parameters["gripper.piston.stroke_length"] == 0.004
    assert circuit.drives() == {"gripper.jaws": {"valve.command": True}}


def test_invalid_grippers_are_rejected():
    with refused("compounds.transmission_twice", "rated_force"):
        gripper(transmission=1.0, rated_force=45.0)
    with refused("compounds.beyond_end", "jaws.initial_position", value=0.006, stroke=STROKE):
        gripper(jaws={**VISCOUS, "initial_position": "6 mm"})
    with refused("bodies.direction", "direction"):
        gripper(direction=0.5)
    with refused("cylinder.rod_too_thick", "rod_diameter"):
        gripper(rod_diameter="20 mm")
    for name in ("bore", "jaw_stroke", "rated_force", "transmission"):
        with refused("fields.out_of_range", name):
            gripper(**{name: -1.0})
    with pytest.raises(InputErrors) as caught:
        Gripper(workpiece={})
    addresses = {problem.address for problem in caught.value.problems}
    needed = {"bore", "jaw_stroke", "workpiece.width", "jaws.mass", "cap.dead_volume", "rod.dead_volume"}
    assert addresses == needed

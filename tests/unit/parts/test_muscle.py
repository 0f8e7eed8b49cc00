"""Muscle: direction, rejected input, notes on runs, hysteresis, slack, table, library sets."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

from poppet import Circuit, InputError, Muscle, load
from poppet.laws.physics.muscle import taut
from poppet.parts import Guide, Joint, Mass
from poppet.timeseries.recording import Recording
from poppet.timeseries.signals import Points
from refusals import refused

EXAMPLES = Path(__file__).parents[3] / "examples"
TABLE = {"contraction": [0.0, 0.1, 0.2], "force_per_pressure": ["280 N/bar", "180 N/bar", "90 N/bar"],
         "passive_force": [100.0, -308.0, -310.0]}  # fmt: skip
PLAIN = {"body": "slide", "nominal_length": "300 mm", "nominal_diameter": "20 mm"}


def guided(times: list[float], positions: list[float], **fields: Any) -> Recording:
    muscle = Muscle(**{"body": "slide", "data": "dmsp_20_300", "wall_conductance": 1e4} | fields)
    parts = {"muscle": muscle, "slide": Guide()}
    signals = {"slide.position": Points(times, positions)}
    return Circuit(parts, signals=signals).simulate(duration=times[-1], output_step=times[-1] / 400)


def note(run: Recording, code: str, address: str) -> dict[str, Any]:
    (found,) = [n.facts for n in run.remarks if (n.code, n.address) == (code, address)]
    return dict(found)


@pytest.mark.parametrize("direction", [1, -1])
def test_pulls_into_its_direction(direction):
    run = guided([0.0, 1.0], [0.01, 0.01 + 0.03 * direction], direction=direction, offset=0.01, initial_pressure=6e5)
    assert run["muscle.contraction"][[0, -1]] == pytest.approx([0.0, 0.1], abs=1e-12)
    assert np.sign(run["slide.holding_force"]).tolist() == [-direction] * run.time.size


def test_a_joint_winds_it_over_its_pulley():
    muscle = Muscle(body="elbow", data="dmsp_20_300", offset="-30 mm", initial_pressure="4 bar")
    circuit = Circuit(
        {"muscle": muscle, "elbow": Joint(inertia=0.1, pulley_radius="20 mm", initial_position="0.5 rad")}
    )
    run = circuit.simulate(duration=1e-3)
    assert run["muscle.contraction"][0] == pytest.approx((0.03 + 0.5 * 0.02) / 0.3)


# What it refuses --------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "body",
    [Mass(mass=1.0, initial_position="1 mm"), Guide(position="1 mm"),
     Joint(inertia=1.0, pulley_radius="10 mm", initial_position="0.1 rad")],
    ids=["mass", "guide", "joint"],
)  # fmt: skip
def test_longer_than_its_nominal_length_at_the_start_is_refused(body):
    parts = {"flexor": Muscle(body="slide", data="dmsp_20_300", direction=-1), "slide": body}
    with refused("muscle.stretched", "flexor.offset") as caught:
        Circuit(parts)
    assert caught.value.problems[0].facts["excess"] == pytest.approx(1e-3)


def test_a_signal_that_starts_beyond_the_range_is_rejected():
    with refused("muscle.stretched", "muscle.offset"):
        guided([0.0, 1.0], [0.002, -0.01], direction=-1)


@pytest.mark.parametrize(
    ("fields", "address"),
    [
        ({}, "sarosi"),
        ({"law": "chou_hannaford"}, "braid_angle"),
        ({"law": "tondu_lopez"}, "braid_angle"),
        ({"law": "table"}, "force_table"),
        ({"data": "dmsp_10_250", "volume_law": "braid"}, "braid_angle"),
    ],
)
def test_a_law_without_its_parameters_is_rejected(fields, address):
    with refused("muscle.law_needs", address):
        Muscle(**PLAIN, **fields)


def test_a_direction_is_one_or_minus_one():
    with refused("bodies.direction", "direction"):
        Muscle(body="slide", data="dmsp_20_300", direction=0.5)


def test_a_table_that_does_not_rise_is_rejected():
    muscle = Muscle(**PLAIN, law="table", force_table=TABLE | {"contraction": [0.0, 0.2, 0.1]})
    with refused("schedule.not_rising", "muscle.force_table.contraction", kind=InputError):
        Circuit({"muscle": muscle, "slide": Guide()})


# What a run says --------------------------------------------------------------------------------------------------


def test_values_beyond_the_law_have_notes():
    run = guided([0.0, 1.0], [0.006, 0.09], initial_pressure="7.5 bar g")
    high = note(run, "muscle.beyond", "muscle.contraction")
    assert (high["worst"], high["limit"]) == (pytest.approx(0.3), 0.26)
    assert high["time"] == pytest.approx((0.26 * 0.3 - 0.006) / 0.084, abs=5e-3)
    assert note(run, "muscle.beyond", "muscle.force")["limit"] == 1500.0
    assert note(run, "muscle.beyond", "muscle.pressure")["limit"] == pytest.approx(7e5)


def test_no_notes_inside_the_range():
    run = guided([0.0, 1.0], [0.006, 0.03], initial_pressure="4 bar g")
    assert [n.code for n in run.remarks if n.code.startswith("muscle.")] == []


def test_a_slack_muscle_has_no_force_and_a_note():
    run = guided([0.0, 1.0], [0.006, 0.06], initial_pressure="1.5 bar g")
    assert run["muscle.force"][-1] == 0.0
    assert run["muscle.force"].min() == 0.0
    first = note(run, "muscle.slack", "muscle.force")["time"]
    loose = run.time[run["muscle.force"] == 0.0]
    assert first == loose[0]


def test_going_slack_has_no_corner():
    force, step = np.linspace(-3.0, 3.0, 6001), 1e-3
    slopes = np.diff(taut(force, 1.0)) / step
    assert np.abs(np.diff(slopes)).max() < 1e-3
    assert (taut(force, 1.0) >= np.maximum(force, 0.0)).all()


# Hysteresis -------------------------------------------------------------------------------------------------------

LOOP = ([0.0, 1.0, 2.0, 3.0], [0.02, 0.06, 0.02, 0.06])


@pytest.mark.parametrize("kind", ["coulomb", "maxwell"])
def test_a_loop_is_as_wide_as_its_numbers_say(kind):
    """On the same way out and back, far from the turning points, forces differ by twice force + part of pressure."""
    numbers = {"kind": kind, "force": 8.0, "force_per_pressure": "5 N/bar", "reach": "1 mm"}
    run = guided(*LOOP, initial_pressure="3 bar g", hysteresis=numbers)
    places = [int(np.argmin(np.abs(run.time - t))) for t in (1.5, 2.5)]
    back, out = (run["muscle.force"][k] for k in places)
    pressures = [(run["muscle.pressure"][k] - 1e5) / 1e5 for k in places]
    law = Muscle(body="slide", data="dmsp_20_300").force_law()
    static = [law.force(p * 1e5, run["muscle.contraction"][k]) for p, k in zip(pressures, places, strict=True)]
    assert back - static[0] == pytest.approx(8.0 + 5.0 * pressures[0], rel=1e-3)
    assert out - static[1] == pytest.approx(-8.0 - 5.0 * pressures[1], rel=1e-3)


def test_maxwell_elements_remember_turning_points():
    """A small loop inside a large one closes: the force comes back to where it left; that of one element does not."""
    law = Muscle(body="slide", data="dmsp_20_300").force_law()
    held = {}
    for kind in ("maxwell", "coulomb"):
        numbers = {"kind": kind, "force": 30.0, "reach": "4 mm"}
        way = [0.0, 1.0, 1.5, 2.0], [0.02, 0.04, 0.0385, 0.04]
        run = guided(*way, initial_pressure="5 bar g", hysteresis=numbers)
        static = law.force(run["muscle.pressure"] - 1e5, run["muscle.contraction"])
        held[kind] = (static - run["muscle.force"])[[200, 300, 400]]
    ideal = 30.0 * float(np.mean([1.0 - 1.5 / reach for reach in (1.0, 2.0, 3.0, 4.0)]))
    assert held["maxwell"][:2] == pytest.approx([30.0, ideal], rel=1e-3)
    assert held["maxwell"][2] == pytest.approx(30.0, rel=0.05)
    assert held["coulomb"][2] < 20.0


def test_damping_takes_force_while_it_contracts():
    still, damped = (guided([0.0, 1.0], [0.01, 0.04], initial_pressure="5 bar g", damping=d) for d in (0.0, 100.0))
    assert still["muscle.force"] - damped["muscle.force"] == pytest.approx(100.0 * 0.03, rel=1e-6)


# Table and sets ---------------------------------------------------------------------------------------------------


def test_a_table_is_straight_between_its_rows_and_its_numbers_have_addresses():
    circuit = Circuit({"muscle": Muscle(**PLAIN, law="table", force_table=TABLE, initial_pressure="3 bar"),
                       "slide": Guide(position="15 mm")})  # fmt: skip
    assert circuit.simulate(duration=1e-3)["muscle.force"][0] == pytest.approx(2.0 * 230.0 - 104.0)
    changed = circuit.with_values({"muscle.force_table.force_per_pressure_2": "200 N/bar"})
    assert changed.simulate(duration=1e-3)["muscle.force"][0] == pytest.approx(2.0 * 240.0 - 104.0)


def test_the_braid_gives_the_volume_where_it_is_asked_for():
    fields = {"volume_law": "braid", "braid_angle": "24 deg", "initial_pressure": "4 bar", "dead_volume": "5 cm^3"}
    run = guided([0.0, 1.0], [0.0, 0.06], **fields)
    thread, length = 0.3 / np.cos(np.radians(24.0)), 0.3 - np.array([0.0, 0.06])
    turns = thread * np.sin(np.radians(24.0)) / (np.pi * 0.02)
    expected = 5e-6 + length * (thread**2 - length**2) / (4.0 * np.pi * turns**2)
    assert run["muscle.volume"][[0, -1]] == pytest.approx(expected, rel=1e-12)


@pytest.mark.parametrize(
    ("name", "force", "source"),
    [("dmsp_10_250", 630.0, "fitted"), ("dmsp_20_300", 1500.0, "fitted"), ("dmsp_40_300", 6000.0, "assumed")],
)
def test_sets_say_what_was_measured(name, force, source):
    muscle = Muscle(body="slide", data=name)
    assert float(muscle.limits.highest_force) == force
    assert {muscle.numbers()[f"sarosi.a{k}"].source.kind for k in range(1, 7)} == {source}


def test_the_example_lifts_its_weight_and_puts_it_down():
    run = load(EXAMPLES / "muscle_lift.toml").simulate()
    k = int(np.argmin(np.abs(run.time - 2.4)))
    assert run["weight.position"][k] > 0.05
    assert run["weight.position"][-1] == pytest.approx(0.0, abs=1e-3)
    assert all(r.is_kept for r in run.residuals)

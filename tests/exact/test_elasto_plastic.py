"""The elasto-plastic friction law: an independent simulation, no drift, steady sliding and dissipation."""

from __future__ import annotations

import numpy as np
import pytest

from exact.independent_friction import simulate_elasto_plastic
from exact.test_cylinder import pulled
from poppet import Circuit
from poppet.laws.physics.friction import elasto_plastic_rate, lugre_force, sliding_level
from poppet.parts import Cylinder, Mass
from poppet.timeseries.signals import Points, Sine, Steps

MASS = 4.0
LAW = {"Fc": 10.0, "Fs": 15.0, "vs": 0.01, "s0": 1.5e6, "s1": 2000.0, "s2": 30.0, "zba": 6e-6}
NAMES = {
    "coulomb_force": "Fc", "static_force": "Fs", "stribeck_velocity": "vs", "bristle_stiffness": "s0",
    "bristle_damping": "s1", "viscous_coefficient": "s2", "breakaway_displacement": "zba",
}  # fmt: skip
FRICTION = {"kind": "elasto_plastic", **{name: LAW[key] for name, key in NAMES.items()}}


def test_break_away_sliding_and_reversal_agree_with_an_independent_simulation():
    times = np.linspace(0.0, 3.0, 301)
    corners, forces = [0.0, 0.5, 0.6, 1.2, 1.4, 2.2, 2.4, 3.0], [0.0, 12.0, 8.0, 18.0, -4.0, -19.0, 9.0, 9.0]
    expected = simulate_elasto_plastic(LAW, MASS, lambda t: np.interp(t, corners, forces), times)
    load = Points(corners, [-force for force in forces])
    recording = pulled(load, FRICTION, MASS).simulate(3.0, 0.01, 1e-8)
    found = [recording[f"slide.{name}"] for name in ("position", "velocity", "friction_force")]
    assert np.ptp(expected[0]) > 0.01
    for values, series in zip(found, expected, strict=True):
        assert np.abs(values - series).max() < 1e-4 * np.abs(series).max()


@pytest.mark.parametrize("frequency", [1.0, 20.0])
def test_no_drift_below_the_break_away_displacement(frequency):
    """Compare positions at equal loads, from the third period on: the first load jumps to 5 N."""
    load, drift = Sine(-5.0, 2.5, frequency), {}
    for kind, parameters in {"elasto_plastic": FRICTION, "lugre": {**FRICTION, "kind": "lugre"}}.items():
        recording = pulled(load, parameters, MASS).simulate(200.0 / frequency, 0.05 / frequency)
        position = recording["slide.position"][40::20]
        drift[kind] = abs(position[-1] - position[0])
        notes = [note for note in recording.remarks if note.code == "bodies.drift"]
        assert len(notes) == (kind == "lugre")
    assert drift["elasto_plastic"] < 1e-9
    assert drift["lugre"] > 1e-4
    facts = notes[0].facts
    assert facts["drift"] == pytest.approx(drift["lugre"], rel=0.05)
    assert (facts["level"], facts["high"]) == (15.0, pytest.approx(7.5, rel=0.05))


def test_drift_above_the_break_away_displacement_is_reported():
    recording = pulled(Sine(-10.5, 2.0, 20.0), FRICTION, MASS).simulate(5.0, 0.0025)
    position = recording["slide.position"][40::20]
    (note,) = [note for note in recording.remarks if note.code.startswith("bodies.")]
    assert note.code == "bodies.creep"
    assert note.facts["drift"] == pytest.approx(position[-1] - position[0], rel=0.1)


@pytest.mark.parametrize(
    ("kind", "load", "code"),
    [("lugre", 14.0, "drift"), ("elasto_plastic", 14.0, None), ("elasto_plastic", 20.0, None)],
)
def test_a_pressurised_seal_increases_the_force_without_drift(kind, load, code):
    """Compare peaks of 19 and 25 N with the limit of 0.95 (7 + 20.1) N; without the seal, it is 0.95 times 7 N."""
    seal = 10.0 * (3.01325 - 1.0)  # the reference of the pressure difference is the ambient, 1 bar
    law = {"kind": kind, "coulomb_force": 7.0, "static_force": 9.0, "stribeck_velocity": 0.01}
    volume = {"dead_volume": "1 m^3"}
    cylinder = Cylinder(
        body="slide", bore="1 mm", stroke_length="10 m", offset="5 m", seal_friction="10 N/bar",
        cap={**volume, "initial_pressure": "3.01325 bar"}, rod=volume,
    )  # fmt: skip
    parts = {"slide": Mass(mass=MASS, friction=law), "cylinder": cylinder}
    recording = Circuit(parts, {"slide.load_force": Sine(-load, 5.0, 20.0)}).simulate(5.0, 0.0025)
    position = recording["slide.position"][40::20]
    drift = abs(position[-1] - position[0])
    notes = {note.code: note.facts for note in recording.remarks if note.code.startswith("bodies.")}
    assert list(notes) == ([f"bodies.{code}"] if code else [])
    if code is None:
        assert drift < 1e-8
    else:
        assert notes[f"bodies.{code}"]["drift"] == pytest.approx(drift, rel=0.1)
        assert notes[f"bodies.{code}"]["level"] == pytest.approx(9.0 + seal)


def test_steady_sliding_has_the_stribeck_curve_of_lugre():
    speed = np.linspace(1e-4, 0.1, 50)
    level = sliding_level(speed, LAW["Fc"], LAW["Fs"], LAW["vs"])
    steady = level / LAW["s0"]
    rate = elasto_plastic_rate(steady, speed, level, LAW["s0"], LAW["zba"])
    assert np.abs(rate).max() < 1e-15
    assert lugre_force(steady, rate, speed, LAW["s0"], LAW["s1"], LAW["vs"]) == pytest.approx(level, rel=1e-12)
    speeds = [
        pulled(Steps([0.0], [-25.0]), {**FRICTION, "kind": kind}, MASS).simulate(5.0)["slide.velocity"][-1]
        for kind in ("lugre", "elasto_plastic")
    ]
    assert speeds == [pytest.approx(0.5, rel=1e-6)] * 2  # (25 N - Fc) / s2


def test_friction_never_returns_more_energy_than_the_bristles_store():
    generator = np.random.default_rng(5)
    speed = generator.normal(0.0, 2.0 * LAW["vs"], 100_000)
    level = sliding_level(speed, LAW["Fc"], LAW["Fs"], LAW["vs"])
    # Up to the deflection of break-away, beyond that of steady sliding at this speed.
    deflection = generator.uniform(-1.0, 1.0, speed.size) * LAW["Fs"] / LAW["s0"]
    rate = elasto_plastic_rate(deflection, speed, level, LAW["s0"], LAW["zba"])
    force = lugre_force(deflection, rate, speed, LAW["s0"], LAW["s1"], LAW["vs"])
    lost = force * speed - LAW["s0"] * deflection * rate
    assert lost.min() >= -1e-15 * np.abs(force * speed).max()
    assert (LAW["s1"] * np.exp(-((speed / LAW["vs"]) ** 2)) <= 4.0 * level / np.abs(speed)).all()

"""The elasto-plastic friction law: an independent simulation, no drift, steady sliding and dissipation."""

from __future__ import annotations

import numpy as np
import pytest

from exact.independent_friction import simulate_elasto_plastic
from exact.test_cylinder import pulled
from poppet.laws.physics.friction import elasto_plastic_rate, lugre_force, sliding_level
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

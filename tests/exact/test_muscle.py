"""Muscles against closed forms: work of every law, closed gas, a weight held, what two of them do to a joint."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest
from scipy.integrate import quad, solve_ivp
from scipy.optimize import brentq

from poppet import Circuit, Muscle, Orifice, Reservoir
from poppet.laws.physics.muscle import ChouHannaford, ForceLaw, ForceTable, Sarosi, TonduLopez
from poppet.parts import Guide, Joint, Mass
from poppet.parts.bodies import GRAVITY
from poppet.timeseries.signals import Points, Sine

ANGLE = math.radians(24.0)
BRAID = ChouHannaford(0.02, 0.3, ANGLE)
SAROSI = Sarosi(1.2789e-4, 419.4831, -56.66, -8.7013e-3, 2.67672e-3, -309.6031)
LAWS = {
    "chou_hannaford": BRAID,
    "tondu_lopez": TonduLopez(0.02, ANGLE, 1.2),
    "sarosi": SAROSI,
    "table": ForceTable([0.0, 0.05, 0.12, 0.3], [2.8e-3, 2.2e-3, 1.5e-3, -1e-4], [110.0, -285.0, -309.0, -320.0]),
}
EACH = pytest.mark.parametrize("law", LAWS.values(), ids=LAWS)
CONTRACTIONS = [-0.02, 0.003, 0.06, 0.2, 0.35]


@EACH
@pytest.mark.parametrize("contraction", CONTRACTIONS)
def test_the_volume_of_a_law_grows_with_the_work_of_its_force(law: ForceLaw, contraction: float):
    """-dV/dL = dF/dp: quadrature of the slope against the closed form of the volume."""
    expected = quad(law.slope, 0.0, contraction, epsabs=1e-15, points=[0.0, 0.05, 0.12, 0.3])[0]
    assert law.swept(contraction) == pytest.approx(expected, rel=1e-10)


@EACH
def test_the_pressure_for_a_force_is_the_inverse(law: ForceLaw):
    force = law.force(3e5, np.array([0.0, 0.1, 0.2]))
    assert law.pressure_for(force, np.array([0.0, 0.1, 0.2])) == pytest.approx(3e5, rel=1e-12)


def test_the_braid_is_the_one_of_the_paper():
    """Volume and force of Chou and Hannaford written with the thread: b, n, and the angle at each length."""
    thread = 0.3 / math.cos(ANGLE)
    turns = thread * math.sin(ANGLE) / (math.pi * 0.02)
    for contraction in CONTRACTIONS:
        length = 0.3 * (1.0 - contraction)
        cosine = length / thread
        force = thread**2 * (3.0 * cosine**2 - 1.0) / (4.0 * math.pi * turns**2)
        volume = length * (thread**2 - length**2) / (4.0 * math.pi * turns**2)
        assert BRAID.slope(contraction) == pytest.approx(force, rel=1e-12)
        still = 0.25 * math.pi * 0.02**2 * 0.3
        assert still + 0.3 * BRAID.swept(contraction) == pytest.approx(volume, rel=1e-12)
    magic = 1.0 - math.cos(math.radians(54.7356103172)) / math.cos(ANGLE)
    assert BRAID.slope(magic) == pytest.approx(0.0, abs=1e-12)
    assert math.degrees(math.acos((1.0 - magic) * math.cos(ANGLE))) == pytest.approx(54.74, abs=0.005)


# In circuits -----------------------------------------------------------------------------------------------------

LENGTH, STILL = 0.3, 0.25 * math.pi * 0.02**2 * 0.3
SWEEP = Points([0.0, 1.0, 2.0], [0.0, -0.06, -0.015])


def guided(signal: Any = SWEEP, **fields: Any) -> Circuit:
    muscle = Muscle(**{"body": "slide", "data": "dmsp_20_300", "direction": -1, "initial_pressure": "5 bar"} | fields)
    return Circuit({"muscle": muscle, "slide": Guide()}, signals={"slide.position": signal})


def test_closed_gas_without_heat_follows_its_isentrope():
    run = guided().simulate(duration=2.0, relative_tolerance=1e-9)
    volume = STILL + LENGTH * SAROSI.swept(run["muscle.contraction"])
    assert run["muscle.volume"] == pytest.approx(volume, rel=1e-12)
    assert run["muscle.pressure"] == pytest.approx(5e5 * (STILL / volume) ** 1.4, rel=1e-8)
    assert np.ptp(run["muscle.mass"]) < 1e-17


def test_closed_gas_with_heat_follows_an_independent_integration():
    circuit = guided(wall_conductance=0.5, volume_law="braid", braid_angle=ANGLE)
    run = circuit.simulate(duration=2.0, relative_tolerance=1e-9)
    gas_constant, mass = circuit.surroundings.gas_constant, 5e5 * STILL / (circuit.surroundings.gas_constant * 293.15)

    def rate(time: float, temperature: np.ndarray) -> np.ndarray:
        speed = 0.06 if time < 1.0 else -0.045
        contraction = (0.06 * time if time < 1.0 else 0.06 - 0.045 * (time - 1.0)) / LENGTH
        volume = STILL + LENGTH * BRAID.swept(contraction)
        pressure = mass * gas_constant * temperature / volume
        heat = 0.5 * (293.15 - temperature)
        return (heat - pressure * BRAID.slope(contraction) * speed) / (mass * gas_constant / 0.4)

    ends = [solve_ivp(rate, (0.0, 1.0), [293.15], rtol=1e-11, atol=1e-9, method="DOP853")]
    ends.append(solve_ivp(rate, (1.0 + 1e-15, 2.0), ends[0].y[:, -1], rtol=1e-11, atol=1e-9, method="DOP853"))
    for time, solution in zip((1.0, 2.0), ends, strict=True):
        k = int(np.argmin(np.abs(run.time - time)))
        assert run["muscle.temperature"][k] == pytest.approx(solution.y[0, -1], rel=1e-7)


def test_without_losses_the_force_gives_what_the_gas_gives():
    """Over any way of a braid: work on the body is that of the gauge pressure, integral p dV."""
    fields = {"data": None, "law": "chou_hannaford", "nominal_length": LENGTH, "nominal_diameter": 0.02}
    slow = Sine(mean=-0.03, amplitude=0.02, frequency=1.0)
    run = guided(slow, **fields, braid_angle=ANGLE).simulate(duration=0.7, output_step=1e-4, relative_tolerance=1e-9)
    way, force = LENGTH * run["muscle.contraction"], run["muscle.force"]
    pulled = np.trapezoid(force, way)
    given = np.trapezoid(run["muscle.pressure"] - 1e5, run["muscle.volume"])
    assert abs(pulled) > 0.1
    assert pulled == pytest.approx(given, rel=1e-6)
    assert run["slide.holding_force"] == pytest.approx(force, rel=1e-12)


def test_at_one_pressure_a_weight_hangs_where_the_law_says():
    parts = {
        "supply": Reservoir(pressure="4 bar g"),
        "hose": Orifice(from_="supply", to="muscle", sonic_conductance="1 dm^3/(s bar)", critical_ratio=0.3),
        "muscle": Muscle(body="weight", data="dmsp_20_300", damping=500.0, initial_pressure="4 bar g"),
        "weight": Mass(mass=40.0, inclination="90 deg"),
    }
    run = Circuit(parts).simulate(duration=10.0)
    expected = brentq(lambda contraction: SAROSI.force(4e5, contraction) - 40.0 * GRAVITY, 0.0, 0.25)
    assert run["muscle.contraction"][-1] == pytest.approx(expected, rel=1e-6)
    assert run["weight.position"][-1] == pytest.approx(LENGTH * expected, rel=1e-6)


def test_two_muscles_turn_a_joint_and_no_energy_is_lost():
    common = {"body": "elbow", "data": "dmsp_20_300", "damping": 50.0, "hysteresis": {"force": 10.0, "reach": 0.005}}
    parts = {
        "supply": Reservoir(pressure="5 bar g"),
        "fill": Orifice(from_="supply", to="biceps", sonic_conductance="0.1 dm^3/(s bar)", critical_ratio=0.3),
        "biceps": Muscle(**common, offset=-0.03, initial_pressure="3 bar"),
        "triceps": Muscle(**common, offset=0.03, direction=-1, initial_pressure="3 bar"),
        "elbow": Joint(inertia=0.2, pulley_radius=0.025),
    }
    run = Circuit(parts).simulate(duration=1.0)
    assert run["elbow.position"][-1] > 0.1
    assert run["biceps.contraction"] + run["triceps.contraction"] == pytest.approx(0.2, abs=1e-12)
    gas = [r for r in run.residuals if r.quantity in ("mass", "energy")]
    assert {r.store for r in gas} == {"biceps", "triceps"}
    assert max(abs(r.error) / (abs(r.inventory) + r.through) for r in gas) < 1e-12
    assert all(r.is_kept for r in run.residuals)

"""Cylinders on a guide that moves as a sine, against Cantera's reactors with moving walls; limits with closed forms."""

from __future__ import annotations

import math

import numpy as np
import pytest

from cantera_tanks import KAPPA, SIZE, advanced, ct, joined, reservoir, tank
from poppet import Circuit
from poppet.parts import Cylinder, Guide, Orifice, Reservoir
from poppet.timeseries.signals import Sine

BORE, ROD, STROKE, DEAD = 0.05, 0.02, 0.16, 3e-5
AREAS = {"cap": math.pi / 4 * BORE**2, "rod": math.pi / 4 * (BORE**2 - ROD**2)}
MIDDLE, SWING, FREQUENCY = 0.08, 0.06, 2.0
PULSE = 2.0 * math.pi * FREQUENCY


def cylinder(conductance: float, pressure: float, direction: int = 1) -> Cylinder:
    side = {"dead_volume": DEAD, "wall_conductance": conductance, "initial_pressure": pressure}
    # Turned round, position zero is where the piston stands at the other cover.
    turned = {"direction": -1, "offset": STROKE} if direction < 0 else {}
    return Cylinder(body="slide", bore=BORE, rod_diameter=ROD, stroke_length=STROKE, cap=side, rod=side, **turned)


def circuit(parts, **more) -> Circuit:
    motion = Sine(mean=MIDDLE, amplitude=SWING, frequency=FREQUENCY)
    return Circuit({"slide": Guide(), **parts, **more}, {"slide.position": motion})


def depth(side: str, direction: int = 1) -> float:
    """Of the chamber at the start."""
    from_cap = MIDDLE if direction > 0 else STROKE - MIDDLE
    return from_cap if side == "cap" else STROKE - from_cap


def vessels(pressure: float, conductance: float, direction: int = 1):
    """Reactors of both sides with what moves and warms them."""
    room, found, keep = reservoir(1e5), [], []
    for side, sign in (("cap", direction), ("rod", -direction)):
        area = AREAS[side]
        vessel = tank(DEAD + area * depth(side, direction), pressure)

        def speed(time: float, sign: int = sign) -> float:
            return sign * SWING * PULSE * math.cos(PULSE * time)

        # A wall moves from left to right when its speed is positive: the vessel stands left and grows.
        keep += [ct.Wall(vessel, room, A=area, velocity=speed), ct.Wall(room, vessel, A=1.0, U=conductance)]
        found.append(vessel)
    return found, keep


def apart(ours, reactors) -> float:
    """The largest relative difference in pressure, temperature and mass."""
    theirs = advanced(reactors, ours.time)
    quantities = ("pressure", "temperature", "mass")
    own = [[ours[f"cylinder.{side}.{quantity}"] for quantity in quantities] for side in ("cap", "rod")]
    return float(np.max(np.abs(np.moveaxis(own, -1, 0) / theirs - 1.0)))


def closed_run(conductance: float, direction: int = 1) -> float:
    """Both chambers shut: how far apart."""
    ours = circuit({"cylinder": cylinder(conductance, 3e5, direction)}).simulate(1.0, 0.01, 1e-9)
    reactors, keep = vessels(3e5, conductance, direction)
    assert np.ptp(ours["cylinder.cap.pressure"]) > 2e5
    assert all(residual.is_kept for residual in ours.residuals)
    assert len(keep) == 4
    return apart(ours, reactors)


def open_run(conductance: float) -> float:
    """One chamber fed, one vented: how far apart."""
    parts = {
        "cylinder": cylinder(conductance, 2e5),
        "supply": Reservoir(pressure="7 bar"),
        "fill": Orifice(from_="supply", to="cylinder.cap", **SIZE),
        "vent": Orifice(from_="cylinder.rod", to="ambient", **SIZE),
    }
    ours = circuit(parts).simulate(1.0, 0.01, 1e-9)
    (cap, rod), keep = vessels(2e5, conductance)
    supply, room = reservoir(7e5), reservoir(1e5)
    both_ways = [(supply, cap), (cap, supply), (rod, room), (room, rod)]
    keep += [joined(*ends) for ends in both_ways]
    # The flow turns, so that both directions count.
    assert ours["vent.mass_flow_rate"].min() < -1e-5 < 1e-5 < ours["vent.mass_flow_rate"].max()
    return apart(ours, (cap, rod))


@pytest.mark.parametrize("direction", [1, -1])
@pytest.mark.parametrize("conductance", [0.0, 0.5])
def test_closed(conductance, direction):
    assert closed_run(conductance, direction) < 2e-6


@pytest.mark.parametrize("conductance", [0.0, 0.5])
def test_open(conductance):
    assert open_run(conductance) < 2e-6


def test_without_heat_the_gas_is_isentropic_and_with_much_of_it_isothermal():
    for conductance, exponent, tolerance in ((0.0, KAPPA, 1e-7), (1e5, 1.0, 1e-3)):
        ours = circuit({"cylinder": cylinder(conductance, 3e5)}).simulate(1.0, 0.01, 1e-9)
        for side in AREAS:
            volume, pressure = ours[f"cylinder.{side}.volume"], ours[f"cylinder.{side}.pressure"]
            np.testing.assert_allclose(pressure * volume**exponent, pressure[0] * volume[0] ** exponent, rtol=tolerance)


def test_the_guide_holds_what_the_cylinder_pushes():
    ours = circuit({"cylinder": cylinder(0.0, 3e5)}).simulate(0.5, 0.01)
    np.testing.assert_allclose(ours["slide.holding_force"], -ours["cylinder.force"], atol=1e-9)
    force = AREAS["cap"] * ours["cylinder.cap.pressure"] - AREAS["rod"] * ours["cylinder.rod.pressure"]
    np.testing.assert_allclose(ours["cylinder.force"], force - 1e5 * math.pi / 4 * ROD**2, rtol=1e-12)

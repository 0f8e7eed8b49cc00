"""Cushions of a cylinder: against SciPy on equations written anew, and where closed forms say it."""

from __future__ import annotations

import math

import numpy as np
import pytest
from numpy.testing import assert_allclose
from scipy.integrate import solve_ivp

from poppet import Circuit
from poppet.parts import Cylinder, Guide, Mass, Orifice
from poppet.timeseries.signals import Points
from refusals import refused

BORE, ROD, STROKE, DEAD = 0.04, 0.016, 0.1, 8e-6
SPEAR, LENGTH, TRAPPED, CLOSING = 0.022, 0.02, 2e-6, 0.003
KAPPA, R, AMBIENT, WARM = 1.4, 287.05, 1e5, 293.15
THROTTLE, VENT, CHECK, OPEN = 2e-10, 4e-9, 1e-9, 2e-8
RATIO, EDGE = 0.3, 0.9999
MASS, SPEED, WALL, FIRST = 8.0, 1.5, 0.4, 1.2e5


def cushion(**more):
    return {
        "length": LENGTH, "diameter": SPEAR, "dead_volume": TRAPPED, "sonic_conductance": THROTTLE,
        "closing_length": CLOSING, "open_conductance": OPEN, "laminar_ratio": EDGE, **more,
    }  # fmt: skip


def circuit(side: str, body, conductance: float = WALL, signals=None, vent: float = VENT, **more) -> Circuit:
    """The piston near the middle, moving towards a vented side; the other side is single acting or open."""
    chamber = {"dead_volume": DEAD, "wall_conductance": conductance, "initial_pressure": FIRST}
    other = {"dead_volume": 1e3}
    sides = {"cap": chamber, "rod": other} if side == "cap" else {"cap": other, "rod": chamber}
    made = Cylinder(
        body="slide", bore=BORE, rod_diameter=ROD, stroke_length=STROKE, offset=STROKE / 2, **sides,
        **{f"{side}_cushion": cushion(**more)},
    )  # fmt: skip
    way = Orifice(
        from_=f"cylinder.{side}", to="ambient", sonic_conductance=vent, critical_ratio=RATIO, laminar_ratio=EDGE
    )
    return Circuit({"slide": body, "cylinder": made, "vent": way}, signals or {})


def flow(c: float, p1: float, t1: float, p2: float, t2: float) -> tuple[float, float]:
    """Mass flow from 1 to 2 after ISO 6358, and the temperature with which it comes."""
    if p1 < p2:
        q, t = flow(c, p2, t2, p1, t1)
        return -q, t
    r = min(p2 / p1, EDGE)  # beyond, a straight line to zero
    shape = 1.0 if r <= RATIO else math.sqrt(1.0 - ((r - RATIO) / (1.0 - RATIO)) ** 2)
    shape *= min(1.0, (1.0 - p2 / p1) / (1.0 - EDGE))
    return 1.185 * c * p1 * math.sqrt(293.15 / t1) * shape, t1


def sizes(side: str, y: float) -> tuple[float, float, float, float, float]:
    """Volumes of port and cushion at a distance from the cover, how they grow with it, and how far the bore is open."""
    inner = 0.0 if side == "cap" else ROD
    ring, spear = (math.pi / 4 * (d**2 - inner**2) for d in (BORE, SPEAR))
    s = min(max((y - LENGTH) / CLOSING, 0.0), 1.0)
    is_open = 3 * s**2 - 2 * s**3
    # The way of the spear by quadrature of its closed part.
    nodes, weights = np.polynomial.legendre.leggauss(4)
    t = 0.5 * s * (nodes + 1.0)
    way = min(y, LENGTH) + CLOSING * 0.5 * s * float(np.sum(weights * (1 - 3 * t**2 + 2 * t**3)))
    port = DEAD - TRAPPED + spear * way
    return port, DEAD + ring * y - port, spear * (1 - is_open), ring - spear * (1 - is_open), is_open


def independent(side: str, times, *, check: float, mass: float) -> np.ndarray:
    """y, its speed, and (T, m) of port and cushion; a mass of zero holds the speed."""
    cv = R / (KAPPA - 1)
    volumes = sizes(side, STROKE / 2)

    def state(volume, temperature, amount):
        return amount * R * temperature / volume

    def rates(time, x):
        y, speed, tp, mp, tc, mc = x
        vp, vc, gp, gc, is_open = sizes(side, y)
        pp, pc = state(vp, tp, mp), state(vc, tc, mc)
        out, t_out = flow(VENT, pp, tp, AMBIENT, WARM)
        c = THROTTLE + OPEN * is_open + (check if pp > pc else 0.0)
        into, t_in = flow(c, pp, tp, pc, tc)
        warm = cv * KAPPA
        up = (-out * (warm * t_out - cv * tp) - into * (warm * t_in - cv * tp) - pp * gp * speed) / (mp * cv)
        in_ = (into * (warm * t_in - cv * tc) + WALL * (WARM - tc) - pc * gc * speed) / (mc * cv)
        # The other side holds 1 bar on its whole area.
        force = pp * gp + pc * gc - AMBIENT * math.pi / 4 * (BORE**2 - (ROD**2 if side == "rod" else 0.0))
        return [speed, force / mass if mass else 0.0, up, -out - into, in_, into]

    first = [STROKE / 2, -SPEED, *(value for v in volumes[:2] for value in (WARM, FIRST * v / (R * WARM)))]
    found = solve_ivp(rates, (0.0, times[-1]), first, "BDF", times, rtol=1e-7, atol=1e-12)
    assert found.success
    return found.y


@pytest.mark.parametrize(("side", "check"), [("cap", 0.0), ("rod", CHECK)])
def test_a_mass_is_braked_as_by_scipy(side, check):
    towards = -SPEED if side == "cap" else SPEED
    recording = circuit(side, Mass(mass=MASS, initial_velocity=towards), check_conductance=check).simulate(
        0.1, 2e-3, 1e-8
    )
    y, speed, tp, mp, tc, mc = independent(side, recording.time, check=check, mass=MASS)
    ours = recording["slide.position"] * (1 if side == "cap" else -1) + STROKE / 2
    assert y.min() < 0.4 * LENGTH
    assert y.min() > 0.0  # it turns before the cover
    assert_allclose(ours, y, atol=2e-4 * STROKE)
    vp, vc = np.array([sizes(side, each)[:2] for each in y]).T
    assert_allclose(recording[f"cylinder.{side}_cushion.temperature"], tc, rtol=2e-4)
    assert_allclose(recording[f"cylinder.{side}_cushion.pressure"], mc * R * tc / vc, rtol=2e-4)
    assert_allclose(recording[f"cylinder.{side}.temperature"], tp, rtol=2e-4)
    assert_allclose(recording[f"cylinder.{side}.pressure"], mp * R * tp / vp, rtol=2e-4)
    assert not [residual.name for residual in recording.residuals if not residual.is_kept]
    assert speed.max() > 0.1


def test_a_guided_piston_gives_the_pressures_of_scipy():
    way = Points([0.0, 0.032], [0.0, -0.048])
    ours = circuit("cap", Guide(), signals={"slide.position": way}).simulate(0.032, 1e-3, 1e-8)
    y, _, tp, mp, tc, mc = independent("cap", ours.time, check=0.0, mass=0.0)
    vp, vc = np.array([sizes("cap", each)[:2] for each in y]).T
    for name, t, m, v in (("cap", tp, mp, vp), ("cap_cushion", tc, mc, vc)):
        assert_allclose(ours[f"cylinder.{name}.temperature"], t, rtol=2e-4)
        assert_allclose(ours[f"cylinder.{name}.pressure"], m * R * t / v, rtol=2e-4)
    # The spear shuts, and what is trapped rises far above the port.
    assert ours["cylinder.cap_cushion.pressure"].max() > 4 * ours["cylinder.cap.pressure"][-1]


def test_a_shut_throttle_makes_a_spring_of_gas():
    way = Points([0.0, 0.05, 0.1], [0.0, -0.049, 0.0])
    signals = {"slide.position": way}
    ours = circuit("cap", Guide(), 0.0, signals, sonic_conductance=0.0).simulate(0.1, 1e-4, 1e-9)
    shut = ours["slide.position"] + STROKE / 2 < LENGTH - 1e-4
    pressure, volume = (ours[f"cylinder.cap_cushion.{name}"][shut] for name in ("pressure", "volume"))
    assert_allclose(pressure * volume**KAPPA, pressure[0] * volume[0] ** KAPPA, rtol=1e-7)
    assert np.ptp(pressure) > 3e5


def test_an_open_throttle_is_no_cushion():
    body = Mass(mass=MASS, initial_velocity=-SPEED)
    wide = circuit("cap", body, 0.0, sonic_conductance=1e-6).simulate(0.1, 1e-3)
    chamber = {"dead_volume": DEAD, "initial_pressure": FIRST}
    plain = Cylinder(
        body="slide", bore=BORE, rod_diameter=ROD, stroke_length=STROKE, offset=STROKE / 2, cap=chamber,
        rod={"dead_volume": 1e3},
    )  # fmt: skip
    vent = Orifice(from_="cylinder.cap", to="ambient", sonic_conductance=VENT, critical_ratio=RATIO, laminar_ratio=EDGE)
    without = Circuit({"slide": body, "cylinder": plain, "vent": vent}).simulate(0.1, 1e-3)
    for name in ("slide.position", "cylinder.force"):
        assert_allclose(wide[name], without[name], atol=2e-3 * np.abs(without[name]).max())
    total = wide["cylinder.cap.volume"] + wide["cylinder.cap_cushion.volume"]
    assert_allclose(total, DEAD + math.pi / 4 * BORE**2 * (wide["slide.position"] + STROKE / 2), rtol=1e-9)


def test_the_work_on_the_piston_is_that_of_the_gas():
    ours = circuit("rod", Mass(mass=MASS, initial_velocity=SPEED), 0.0, length=0.03).simulate(0.1, 1e-3)
    names = [f"cylinder.{name}.work_rate" for name in ("cap", "rod", "rod_cushion")]
    on_the_gas = sum(ours[name] for name in names)
    # What the rod feels of the open air is no work of the gas.
    against_air = AMBIENT * math.pi / 4 * ROD**2 * ours["slide.velocity"]
    assert_allclose(ours["cylinder.force"] * ours["slide.velocity"], -on_the_gas - against_air, atol=1e-6)


def test_a_run_goes_on_where_another_ended():
    whole = circuit("cap", Mass(mass=MASS, initial_velocity=-SPEED))
    first = whole.simulate(0.05)
    second = whole.simulate(0.05, start=first)
    straight = whole.simulate(0.1)
    for name in ("cylinder.cap_cushion.pressure", "cylinder.cap.temperature", "slide.position"):
        assert second[name][-1] == pytest.approx(straight[name][-1], rel=1e-4)


def test_a_single_acting_cylinder_goes_on_too():
    chamber = {"dead_volume": DEAD, "initial_pressure": 2e5}
    made = Cylinder(body="slide", bore=BORE, stroke_length=STROKE, acting="single", cap=chamber)
    vent = Orifice(from_="cylinder.cap", to="ambient", sonic_conductance=VENT, critical_ratio=RATIO)
    single = Circuit({"slide": Mass(mass=MASS), "cylinder": made, "vent": vent})
    first = single.simulate(0.05)
    again = single.resumed(first).simulate(0.01)
    assert again["cylinder.cap.pressure"][0] == pytest.approx(first["cylinder.cap.pressure"][-1])


@pytest.mark.parametrize(
    ("field", "value", "code"),
    [
        ("diameter", BORE, "cylinder.spear"),
        ("diameter", ROD / 2, "cylinder.spear"),
        ("length", STROKE, "cylinder.cushion.length"),
        ("dead_volume", DEAD, "cylinder.cushion.dead_volume"),
    ],
)
def test_cushions_that_cannot_be_are_refused(field, value, code):
    with refused(code, f"rod_cushion.{field}"):
        circuit("rod", Mass(mass=1.0), **{field: value})


def test_a_single_acting_cylinder_has_no_cushion_at_its_rod():
    with refused("parts.no_such_member", "rod_cushion"):
        Cylinder(
            body="slide", bore=BORE, stroke_length=STROKE, acting="single", cap={"dead_volume": DEAD},
            rod_cushion=cushion(),
        )  # fmt: skip

"""Exergy of a tank that empties or fills: states and flows of Cantera against quadrature by SciPy."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import simpson

from cantera_tanks import ct, ideal_gas

sys.path.insert(0, str(Path(__file__).parents[1] / "exact"))
from independent_exergy import AMBIENT, TERMS, WARM, flow, tank

VOLUME, C, B = 5e-3, 2e-8, 0.3


ROOM, PROBE = ideal_gas(AMBIENT, WARM), ideal_gas(AMBIENT, WARM)


def exergy(phase, pressure: float | None = None, enclosed: bool = False) -> float:
    """Return the specific exergy of a flow, or of a gas at rest, from the properties that Cantera computes."""
    PROBE.TP = phase.T, pressure or phase.P
    thermal = -WARM * (PROBE.entropy_mass - ROOM.entropy_mass)
    if not enclosed:
        return PROBE.enthalpy_mass - ROOM.enthalpy_mass + thermal
    work = AMBIENT * (PROBE.volume_mass - ROOM.volume_mass)
    return PROBE.int_energy_mass - ROOM.int_energy_mass + thermal + work


def terms_of_cantera(start: float, wall: float, supply: float | None, duration: float) -> dict[str, float]:
    """Return the exergy terms of a tank from a network of reactors, by Simpson's rule over fine output times."""
    vessel = ct.IdealGasReactor(ideal_gas(start, WARM), volume=VOLUME, clone=False)
    room = ct.Reservoir(ideal_gas(AMBIENT, WARM), clone=False)
    source = room if supply is None else ct.Reservoir(ideal_gas(supply, WARM), clone=False)
    up, low = (vessel, room) if supply is None else (source, vessel)

    def rate(_: float = 0.0) -> float:
        return flow(up.phase.P, low.phase.P, up.T, low.T, C, B)[0]

    valve = ct.Valve(up, low, K=1.0)
    valve.pressure_function = rate
    ct.Wall(room, vessel, U=wall, A=1.0)
    net = ct.ReactorNet([vessel])
    net.rtol, net.atol = 1e-11, 1e-16
    first = vessel.mass * exergy(vessel.phase, enclosed=True)
    times, rows = np.linspace(0.0, duration, 1001), []
    for time in times:
        if time > 0.0:
            net.advance(time)
        q, phase = rate(), vessel.phase
        heat = wall * (WARM - phase.T) * (WARM / phase.T - 1.0)
        if supply is None:
            arriving = exergy(phase, AMBIENT)
            rows.append([0.0, q * (exergy(phase) - arriving), q * arriving, 0.0, heat])
        else:
            full, throttled = exergy(source.phase), exergy(source.phase, phase.P)
            # What mixing destroys: the exergy that arrives, minus that which gas at the state of the tank brings with
            # it, and minus the increase in the exergy of the tank by the remaining enthalpy.
            excess = (source.phase.enthalpy_mass - phase.enthalpy_mass) * (1.0 - WARM / phase.T)
            rows.append([q * full, q * (full - throttled), 0.0, q * (throttled - exergy(phase) - excess), heat])
    stored = vessel.mass * exergy(vessel.phase, enclosed=True) - first
    return dict(zip(TERMS, simpson(np.array(rows).T, x=times), strict=True)) | {"stored": stored}


@pytest.mark.parametrize("wall", [0.0, 1.5])
@pytest.mark.parametrize(("start", "supply"), [(7e5, None), (1e5, 8e5)])
def test_the_terms_agree(start: float, wall: float, supply: float | None) -> None:
    expected = terms_of_cantera(start, wall, supply, 1.5)
    found = tank(VOLUME, start, C, B, wall, 1.5, supply)
    scale = abs(expected["stored"])
    for name, value in expected.items():
        assert found[name] == pytest.approx(value, rel=1e-6, abs=1e-6 * scale), name

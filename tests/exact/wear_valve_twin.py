"""Twin of the pneumatic valve that wears, from parts of the package, with passages after ISO 6358."""

from __future__ import annotations

import numpy as np

import poppet

BORE = float(np.sqrt(4.0 * 8.1073196655599634694e-3 / np.pi))
NITROGEN = 8.314 / 28.01e-3  # [J/(kg K)]


def twin(port: dict[str, float], wall: float) -> poppet.Circuit:
    """Return the circuit of the twin for the size of its ports, and h A of the walls of its chambers [W/K]."""
    parts = {
        "supply": poppet.Reservoir(pressure=5.272420892278395e6, temperature=293.0),
        "stem": poppet.Mass(
            mass="50 kg", inclination="90 deg", friction={"kind": "viscous", "viscous_coefficient": "6000 N s/m"},
            lower_stop={"position": 0.0, "stiffness": 1e11}, upper_stop={"position": 0.0381, "stiffness": 1e11},
        ),
        "actuator": poppet.Cylinder(
            body="stem", bore=BORE, rod_diameter=0.0, stroke_length="60 mm",
            spring={"rate": "48000 N/m", "preload": "254 mm"},
            cap={"dead_volume": 8.107319665559963e-4, "wall_conductance": wall, "initial_pressure": 101325.0},
            rod={
                "dead_volume": 8.107319665559963e-4 - 0.25 * np.pi * BORE**2 * (0.060 - 0.0381),
                "wall_conductance": wall, "initial_pressure": 101325.0,
            },
            leakage={"sonic_conductance": 0.0, "critical_ratio": 0.528},
        ),
        "open": poppet.Orifice(from_="supply", to="actuator.cap", opening=0.0, **port),
        "close": poppet.Orifice(from_="actuator.cap", to="ambient", opening=1.0, **port),
        "breather": poppet.Orifice(from_="actuator.rod", to="ambient", **port),
        "bottom_leak": poppet.Orifice(from_="actuator.cap", to="ambient", sonic_conductance=0.0, critical_ratio=0.528),
    }  # fmt: skip
    ambient = poppet.Ambient(pressure=101325.0, temperature=293.0)
    return poppet.Circuit(parts, ambient=ambient, gas=poppet.GasChoice(gas_constant=NITROGEN))

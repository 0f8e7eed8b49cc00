"""Seeded random machines: cylinders of 6 to 100 mm bore, some cushioned, on masses and joints, with dry friction,
stops, jumping loads, and orifices that fill, vent and leak."""

from __future__ import annotations

from typing import Any

import numpy as np

from poppet import Circuit
from poppet.parts import Cylinder, Joint, Mass, Orifice, Reservoir
from poppet.timeseries.signals import Sine, Steps

FRICTIONS = ("none", "viscous", "stribeck", "lugre", "lugre")


def _logarithmic(generator: np.random.Generator, low: float, high: float) -> float:
    return float(np.exp(generator.uniform(np.log(low), np.log(high))))


def _friction(generator: np.random.Generator, effort: str, scale: float) -> dict[str, Any] | None:
    kind = FRICTIONS[generator.integers(len(FRICTIONS))]
    if kind == "none":
        return None
    viscous = {"kind": kind, "viscous_coefficient": _logarithmic(generator, 0.1, 10.0) * scale}
    if kind == "viscous":
        return viscous
    coulomb = _logarithmic(generator, 0.003, 0.2) * scale
    dry = {f"coulomb_{effort}": coulomb, f"static_{effort}": coulomb * generator.uniform(1.0, 2.0)}
    return viscous | dry | ({"transition_velocity": 2e-3} if kind == "stribeck" else {})


def random_machine(generator: np.random.Generator) -> Circuit:
    """One or two bodies, each with one or two cylinders that fight or help each other."""
    parts: dict[str, Any] = {"supply": Reservoir(pressure=generator.uniform(3e5, 1e6))}
    signals: dict[str, Any] = {}
    for b in range(int(generator.integers(1, 3))):
        bore, stroke = _logarithmic(generator, 6e-3, 0.1), _logarithmic(generator, 0.01, 0.5)
        force, turns = 6e5 * bore**2, generator.random() < 0.3
        effort, radius = ("torque", _logarithmic(generator, 0.01, 0.1)) if turns else ("force", 1.0)
        shared: dict[str, Any] = {"friction": _friction(generator, effort, force * radius)}
        if generator.random() < 0.4:
            shared["upper_stop"] = {"position": stroke * generator.uniform(0.3, 0.9) / radius}
        if turns:
            inertia = _logarithmic(generator, 0.05, 5.0) * bore**2 / 6e-4 * radius**2
            body: Any = Joint(inertia=inertia, pulley_radius=radius, **shared)
        else:
            incline = generator.choice([0.0, 0.0, np.pi / 2, -np.pi / 2])
            mass = _logarithmic(generator, 0.05, 5.0) * bore**2 / 6e-4
            body = Mass(mass=mass, inclination=float(incline), **shared)
        parts[f"body{b}"] = body
        loads = force * radius * generator.uniform(-0.5, 0.5, 3)
        signals[f"body{b}.load_{effort}"] = (
            Steps([0.0, 0.4, 0.7], loads) if generator.random() < 0.5 else Sine(loads[0], loads[1], 3.0)
        )
        for c in range(int(generator.integers(1, 3))):
            _add_cylinder(parts, generator, (b, c), bore, stroke)
    if not any(isinstance(part, Orifice) and part.from_ == "supply" for part in parts.values()):
        del parts["supply"]
    return Circuit(parts, signals)


def _cushion(generator: np.random.Generator, sizes: tuple[float, float, float], dead: float) -> dict[str, Any] | None:
    if generator.random() < 0.6:
        return None
    bore, rod, stroke = sizes
    return {
        "length": stroke * generator.uniform(0.02, 0.3),
        "diameter": rod + (bore - rod) * generator.uniform(0.1, 0.6),
        "dead_volume": dead * generator.uniform(0.1, 0.9),
        "sonic_conductance": bore**2 * stroke * _logarithmic(generator, 1e-8, 1e-5) / 1e-1,
        "check_conductance": bore**2 * 1e-6 * float(generator.choice([0.0, 1.0])),
    }


def _add_cylinder(
    parts: dict[str, Any], generator: np.random.Generator, place: tuple[int, int], bore: float, stroke: float
) -> None:
    b, c = place
    name, is_single, is_turned = f"cylinder{b}{c}", generator.random() < 0.3, c == 1
    volume = 0.25 * np.pi * bore**2 * stroke
    side = {
        "dead_volume": volume * generator.uniform(0.02, 0.3),
        "wall_conductance": float(generator.choice([0.0, 0.1, 1.0])),
        "initial_pressure": generator.uniform(1e5, 6e5),
    }
    turned = {"direction": -1, "offset": stroke} if is_turned else {}
    leak = {"sonic_conductance": float(generator.choice([0.0, 1e-11]))}
    rod = bore * generator.uniform(0.1, 0.6)
    parts[name] = Cylinder(
        body=f"body{b}", bore=bore, rod_diameter=rod, stroke_length=stroke,
        acting="single" if is_single else "double", cap=side, rod=None if is_single else side, leakage=leak,
        spring={"rate": 6e5 * bore**2 / stroke * 0.2} if is_single else None, **turned,
        cap_cushion=_cushion(generator, (bore, rod, stroke), side["dead_volume"]),
        rod_cushion=None if is_single else _cushion(generator, (bore, rod, stroke), side["dead_volume"]),
    )  # fmt: skip
    for chamber in ("cap",) if is_single else ("cap", "rod"):
        # The stroke in 0.05 s to 5 s.
        conductance = volume * _logarithmic(generator, 0.2, 20.0) / 1e5 / 2.0
        size = {"sonic_conductance": conductance, "critical_ratio": generator.uniform(0.1, 0.5)}
        source = "supply" if generator.random() < 0.5 else "ambient"
        parts[f"{name}_{chamber}_port"] = Orifice(from_=source, to=f"{name}.{chamber}", **size)

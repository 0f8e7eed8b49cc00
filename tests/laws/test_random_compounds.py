"""Second law and balances of random rotary actuators, grippers and boosters in closed, adiabatic circuits."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
import pytest

from poppet import Chamber, Circuit, Gripper, PressureBooster, RotaryActuator, SpoolValve
from poppet.timeseries.signals import Steps

SIZE = {"sonic_conductance": 1e-8, "critical_ratio": 0.3}
TANKS = {
    "rail": Chamber(volume=1e-3, initial_pressure=7e5), "out": Chamber(volume=1e-3, initial_pressure=2e5)
}  # fmt: skip
FRICTIONS: dict[str, Any] = {
    "lugre": {"kind": "lugre", "coulomb": 1.0, "static": 1.5, "negative_coulomb": 2.0},
    "elasto_plastic": {"kind": "elasto_plastic", "coulomb": 1.0, "negative_static": 2.0},
    "viscous": {"kind": "viscous", "viscous_coefficient": 1.0, "negative_viscous_coefficient": 2.0},
}


def friction(kind: str, effort: str, end: float) -> dict[str, Any]:
    """Friction by direction and position."""
    levels = ("coulomb", "static")
    fields = {f"{n}_{effort}" if n.endswith(levels) else n: value for n, value in FRICTIONS[kind].items()}
    return fields | {"position_factor": {"position": [0.0, 0.5 * end, end], "factor": [1.0, 0.8, 1.2]}}


def actuated(**fields: Any) -> Circuit:
    """An actuator named `part`, moved back and forth by a valve between two tanks."""
    part = fields["part"]
    names = [f"part.{name}" for name in part.stores()]
    valve = SpoolValve(supply="rail", a=names[0], b=names[1], exhaust_a="out", exhaust_b="out", **SIZE)
    signals = {"valve.command": Steps([0.0, 0.3, 0.6, 0.9], [1.0, -1.0, 0.4, -1.0])}
    return Circuit({**TANKS, "valve": valve, **fields}, signals)


def rotary(kind: str) -> Circuit:
    side = {"dead_volume": 1e-5}
    shaft = {"inertia": 0.02, "friction": friction(kind, "torque", math.pi)}
    return actuated(
        part=RotaryActuator(displacement=2e-5, swivel_angle=math.pi, shaft=shaft, forward=side, backward=side)
    )


def gripper(kind: str) -> Circuit:
    side = {"dead_volume": 2e-6}
    jaws = {"mass": 0.2, "friction": friction(kind, "force", 0.01)}
    part = Gripper(
        bore=0.02, rod_diameter=0.008, jaw_stroke=0.01, transmission=1.5, jaws=jaws, cap=side, rod=side,
        workpiece={"width": 0.01},
    )  # fmt: skip
    return actuated(part=part)


def booster(kind: str) -> Circuit:
    piston = {"mass": 0.5, "friction": friction(kind, "force", 0.04)}
    part = PressureBooster(
        supply="rail", outlet="tank", exhaust="out", pressure_ratio=2.0, bore=0.04, stroke_length=0.04, piston=piston,
        valve=SIZE, checks=SIZE,
    )  # fmt: skip
    return Circuit({**TANKS, "tank": Chamber(volume=5e-4), "part": part})


NUMBERS = {
    rotary: ("displacement", "shaft.inertia", "forward.dead_volume", "backward.dead_volume"),
    gripper: ("bore", "jaw_stroke", "transmission", "jaws.mass", "cap.dead_volume", "rod.dead_volume"),
    booster: ("bore", "stroke_length", "dead_fraction", "piston.mass", "valve.switching_time"),
}
"""Numbers of each circuit that are drawn, within a factor of 2.5."""


def gas_entropy(circuit: Circuit, recording: Any) -> Any:
    """Entropy of all gas relative to 1 bar and 20 degC."""
    total = 0.0
    for address in recording.names:
        name, _, quantity = address.rpartition(".")
        if quantity == "mass":
            temperature, pressure = recording[f"{name}.temperature"], recording[f"{name}.pressure"]
            specific = 1004.675 * np.log(temperature / 293.15) - 287.05 * np.log(pressure / 1e5)
            total = total + recording[address] * specific
    return total


@pytest.mark.parametrize("count", [33, pytest.param(1111, marks=pytest.mark.slow)])
@pytest.mark.parametrize("kind", list(FRICTIONS))
@pytest.mark.parametrize("make", list(NUMBERS))
def test_random_compounds_obey_the_second_law_and_keep_their_balances(make: Any, kind: str, count: int) -> None:
    base, generator = make(kind), np.random.default_rng([5, list(FRICTIONS).index(kind), list(NUMBERS).index(make)])
    moved = 0
    for number in range(count):
        values: dict[str, float] = {}
        for name in NUMBERS[make]:
            if f"part.{name}" in base.parameters:
                factor = math.exp(generator.uniform(-1.0, 1.0) * math.log(2.5))
                values[f"part.{name}"] = base.parameters[f"part.{name}"] * factor
        values["rail.initial_pressure"] = generator.uniform(3e5, 1e6)
        recording = base.with_values(values).simulate(1.2, 0.02)
        assert np.isfinite(recording.values).all(), number
        assert not [residual for residual in recording.residuals if not residual.is_kept], number
        entropy = gas_entropy(base, recording)
        assert np.diff(entropy).min() > -1e-6 * (abs(entropy).max() + np.ptp(entropy)), number
        position = next(name for name in recording.names if name.endswith((".position",)) and name.startswith("part."))
        moved += np.ptp(recording[position]) > 1e-3
    assert moved > 0.8 * count

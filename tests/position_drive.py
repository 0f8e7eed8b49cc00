"""A cylinder positioned by a sampled controller, whose linear model has a closed form."""

from __future__ import annotations

from poppet import Circuit, Cylinder, Mass, Orifice, Reservoir
from poppet.parts import PID, SpoolValve
from poppet.signals import Steps

TIME, LAG = 2e-3, 1e-3
BORE, STROKE, DEAD, LOAD, VISCOUS, LEVEL, SUPPLY, SONIC = 25e-3, 0.2, 1e-5, 2.0, 60.0, 3e5, 7e5, 1e-8
GAS, DENSITY = 287.05 * 293.15, 1.185


def drive(friction=None, *, spool=None, wall=1e5, rod="0 mm", mid=0.1, level=LEVEL, **fields):
    """A cylinder between four orifices that one command opens crosswise, or behind a valve with a spool."""
    side = {"dead_volume": DEAD, "initial_pressure": LEVEL, "wall_conductance": wall}
    parts = {
        "supply": Reservoir(pressure=SUPPLY),
        "cylinder": Cylinder(
            bore=BORE,
            rod_diameter=rod,
            stroke_length=STROKE,
            body="slide",
            cap=side,
            rod=side | {"initial_pressure": level},
        ),
        "slide": Mass(mass=LOAD, initial_position=mid, friction=friction or {"viscous_coefficient": VISCOUS}),
        "c": PID(**{"quantity": "position", "gain": "2 1/m", "sample_time": TIME, "sensor": {"lag": LAG}} | fields),
    }
    joined = {"c.measurement": "slide.position"}
    if spool is None:
        ends = {
            "cap_in": ("supply", "cylinder.cap", "fill"),
            "rod_out": ("cylinder.rod", "ambient", "fill"),
            "rod_in": ("supply", "cylinder.rod", "vent"),
            "cap_out": ("cylinder.cap", "ambient", "vent"),
        }
        for name, (a, b, way) in ends.items():
            parts[name] = Orifice(from_=a, to=b, sonic_conductance=SONIC, critical_ratio=0.45)
            joined[f"{name}.opening"] = f"c.{way}_command"
    else:
        parts["valve"] = SpoolValve(supply="supply", a="cylinder.cap", b="cylinder.rod", sonic_conductance=SONIC,
                                    critical_ratio=0.45, **spool)  # fmt: skip
        joined["valve.command"] = "c.command"
    return Circuit(parts, {"c.setpoint": Steps([0.0, 0.1], [0.1, 0.13])}, connections=joined)

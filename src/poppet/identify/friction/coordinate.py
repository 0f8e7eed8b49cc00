"""Coordinates of a body with friction: names and units for translation and rotation."""

from __future__ import annotations

from dataclasses import dataclass

from poppet.core.unit_table import read_unit

COULOMB, STATIC = "friction.coulomb_force", "friction.static_force"
STRIBECK, VISCOUS, SEAL = "friction.stribeck_velocity", "friction.viscous_coefficient", "seal_friction"
BRISTLES, DAMPING = "friction.bristle_stiffness", "friction.bristle_damping"


@dataclass(frozen=True)
class Coordinate:
    """Kind of motion of a body; a rotation has torques and angles."""

    body: str  # kind of the part
    length: str  # SI unit of a position
    effort: str  # name of the force or torque
    effort_unit: str
    inertia: str
    inertia_unit: str

    @property
    def speed(self) -> str:
        """SI unit of a velocity."""
        return f"{self.length}/s"

    def name(self, number: str) -> str:
        """Return the name of a parameter of a law for this body."""
        return number.replace("_force", f"_{self.effort}")

    def unit(self, number: str) -> str:
        """Return the SI unit of a parameter of a law."""
        effort, length = self.effort_unit, self.length
        units = {STRIBECK: self.speed, SEAL: "N/Pa", BRISTLES: f"{effort}/{length}"}
        units |= dict.fromkeys((VISCOUS, DAMPING), f"{effort} s/{length}")
        return units.get(number, effort)

    def is_of(self, unit: str, quantity: str) -> bool:
        """Return True if a unit is valid for `position`, `velocity` or the effort."""
        si_unit = {"position": self.length, "velocity": self.speed, self.effort: self.effort_unit}[quantity]
        return read_unit(unit).dimension == read_unit(si_unit).dimension


ON_LINE = Coordinate("mass", "m", "force", "N", "mass", "kg")
TURNING = Coordinate("joint", "rad", "torque", "N m", "inertia", "kg m^2")
COORDINATES = {coordinate.body: coordinate for coordinate in (ON_LINE, TURNING)}

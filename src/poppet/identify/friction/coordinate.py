"""What a friction is of, a body on a line or one that turns: names and units of its numbers."""

from __future__ import annotations

from dataclasses import dataclass

from poppet.core.unit_table import read_unit

COULOMB, STATIC = "friction.coulomb_force", "friction.static_force"
STRIBECK, VISCOUS, SEAL = "friction.stribeck_velocity", "friction.viscous_coefficient", "seal_friction"
BRISTLES, DAMPING = "friction.bristle_stiffness", "friction.bristle_damping"


@dataclass(frozen=True)
class Coordinate:
    """How a body moves; the laws are fitted alike, with torques and angles where it turns."""

    body: str  # kind of the part
    length: str  # SI unit of a position
    effort: str  # what moves it
    effort_unit: str
    inertia: str
    inertia_unit: str

    @property
    def speed(self) -> str:
        """SI unit of a velocity."""
        return f"{self.length}/s"

    def name(self, number: str) -> str:
        """A number of a law as the body calls it."""
        return number.replace("_force", f"_{self.effort}")

    def unit(self, number: str) -> str:
        """SI unit of a number of a law."""
        effort, length = self.effort_unit, self.length
        units = {STRIBECK: self.speed, SEAL: "N/Pa", BRISTLES: f"{effort}/{length}"}
        units |= dict.fromkeys((VISCOUS, DAMPING), f"{effort} s/{length}")
        return units.get(number, effort)

    def is_of(self, unit: str, wanted: str) -> bool:
        """True where a unit is one of what this coordinate calls `position`, `velocity` or its effort."""
        own = {"position": self.length, "velocity": self.speed, self.effort: self.effort_unit}[wanted]
        return read_unit(unit).dimension == read_unit(own).dimension


ON_LINE = Coordinate("mass", "m", "force", "N", "mass", "kg")
TURNING = Coordinate("joint", "rad", "torque", "N m", "inertia", "kg m^2")
COORDINATES = {each.body: each for each in (ON_LINE, TURNING)}

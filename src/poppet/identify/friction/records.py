"""Measured friction: tables of force versus velocity, and recordings of a moving body."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from poppet.core.errors import ErrorCollector, InputError
from poppet.core.tables import Field, NumberRange
from poppet.core.unit_table import read_unit
from poppet.timeseries.checks import FloatArray, first_bad_time, numbers

COULOMB, STATIC = "friction.coulomb_force", "friction.static_force"
STRIBECK, VISCOUS, SEAL = "friction.stribeck_velocity", "friction.viscous_coefficient", "seal_friction"
SEAL_EXCESS = "seal_friction_excess"
"""Stribeck excess per pressure difference; circuits have no such parameter."""
BRISTLES, DAMPING = "friction.bristle_stiffness", "friction.bristle_damping"


@dataclass(frozen=True)
class Coordinate:
    """Kind of motion of a body, translation or rotation, with its units and names.

    A rotation has torques and angles instead of forces and positions.
    """

    body: str  # kind of the part
    length: str  # SI unit of a position
    effort: str  # name of the force or torque
    effort_unit: str
    inertia: str
    inertia_unit: str

    @property
    def speed(self) -> str:
        """SI unit of a velocity of this kind of motion."""
        return f"{self.length}/s"

    @property
    def opposite(self) -> Coordinate:
        """The other kind of motion: rotation for a mass, translation for a joint."""
        return ON_LINE if self is TURNING else TURNING

    def name(self, number: str) -> str:
        """Return the name of a friction parameter for this kind of motion.

        `number` is its name for a translation. A rotation has `torque` instead of `force`.
        """
        return number.replace("_force", f"_{self.effort}")

    def unit(self, number: str) -> str:
        """Return the SI unit of a friction parameter for this kind of motion.

        `number` is the name of the parameter.
        """
        effort, length = self.effort_unit, self.length
        units = {STRIBECK: self.speed, SEAL: "N/Pa", SEAL_EXCESS: "N/Pa", BRISTLES: f"{effort}/{length}"}
        units |= dict.fromkeys((VISCOUS, DAMPING), f"{effort} s/{length}")
        return units.get(number, effort)

    def accepts_unit(self, unit: str, quantity: str) -> bool:
        """Return True if a unit is valid for a quantity of this kind of motion.

        The quantity is `position`, `velocity`, or the name of the force or torque.
        """
        si_unit = {"position": self.length, "velocity": self.speed, self.effort: self.effort_unit}[quantity]
        return read_unit(unit).dimension == read_unit(si_unit).dimension


ON_LINE = Coordinate("mass", "m", "force", "N", "mass", "kg")
TURNING = Coordinate("joint", "rad", "torque", "N m", "inertia", "kg m^2")
COORDINATES = {coordinate.body: coordinate for coordinate in (ON_LINE, TURNING)}


LEAST = 3
"""Minimum number of points."""
POSITIVE = NumberRange(unit="", above=0.0)


@dataclass(frozen=True, eq=False, kw_only=True)
class FrictionRecord:
    """Table of steady sliding, or recording of a moving body.

    Parameters
    ----------
    force : (n,) array
        Force on the body, positive towards larger positions [N]; for a joint a torque [N m].
    velocity : (n,) array, optional
        Velocity [m/s] or [rad/s]; optional for a recording with positions.
    position : (n,) array, optional
        Position in a recording [m] or [rad].
    time : (n,) array, optional
        Increasing times; they make the record a recording [s].
    pressure : (n,) array or float, optional
        Pressure difference across the seals [Pa].
    pressure_force : (n,) array, optional
        Force or torque of the gas on the body, positive towards larger positions [N] or [N m].
    uncertainty : float or (n,) array, optional
        Standard deviation of a force in a table; it gives the weights of the points [N] or [N m].
    body : str, optional
        `mass` (default) for translation, or `joint` for rotation; positions are then angles, and forces torques.
    name : str, optional
        Name for messages.

    Raises
    ------
    InputErrors
        Different lengths, values that are not finite, times that do not increase, no velocity and no positions.

    Examples
    --------
    >>> record = FrictionRecord(force=[5.0, 6.0, -5.0], velocity=[0.1, 0.2, -0.1])
    >>> record.is_motion, len(record)
    (False, 3)
    """

    force: FloatArray
    velocity: FloatArray | None = None
    position: FloatArray | None = None
    time: FloatArray | None = None
    pressure: FloatArray | None = None
    pressure_force: FloatArray | None = None
    uncertainty: FloatArray | None = None
    body: str = "mass"
    name: str = "table"

    def __post_init__(self) -> None:
        force = np.atleast_1d(numbers("force", self.force))
        arrays = {"force": force}
        for name in ("velocity", "position", "time", "pressure", "pressure_force", "uncertainty"):
            if (values := getattr(self, name)) is not None:
                array = numbers(name, values)
                arrays[name] = np.full(force.shape, float(array)) if array.ndim == 0 else array
        with ErrorCollector() as errors:
            with errors.collecting():
                Field(choices=tuple(COORDINATES)).read(self.body, "body")
            for name, array in arrays.items():
                if array.shape != force.shape:
                    errors.add("friction.shape", name, shape=str(array.shape), points=force.size)
                elif not np.isfinite(array).all():
                    errors.add("friction.not_finite", name, place=int(np.argmin(np.isfinite(array))))
            if force.size < LEAST:
                errors.add("friction.too_few", "force", count=force.size, least=LEAST)
            if "velocity" not in arrays and not {"position", "time"} <= arrays.keys():
                errors.add("friction.no_velocity", "velocity")
            if "uncertainty" in arrays:
                with errors.collecting():
                    lowest = float(np.min(arrays["uncertainty"]))
                    POSITIVE.check_range("uncertainty", lowest, f"{lowest:.3g}", "standard deviation")
            if "time" in arrays and (time_error := first_bad_time(arrays["time"], self.name)):
                errors.extend([time_error[1]])
        if not np.ptp(arrays.get("velocity", arrays.get("position", force))) and "time" in arrays:
            raise InputError("friction.at_rest", "position", name=self.name)
        for name, array in arrays.items():
            object.__setattr__(self, name, array)

    @property
    def coordinate(self) -> Coordinate:
        """Kind of motion of the body: translation or rotation."""
        return COORDINATES[self.body]

    def __len__(self) -> int:
        return int(self.force.size)

    @property
    def is_motion(self) -> bool:
        """True for a recording over time, and False for a table of steady sliding."""
        return self.time is not None

"""Measured friction: tables of force over velocity, and recordings of bodies that are pulled."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from poppet.core.errors import ErrorCollector, InputError, NameSuggestion
from poppet.identify.friction.coordinate import COORDINATES, Coordinate
from poppet.timeseries.checks import FloatArray, first_bad_time, numbers

LEAST = 3
"""Points, below which there is nothing to fit."""


@dataclass(frozen=True, eq=False, kw_only=True)
class FrictionRecord:
    """One table of steady sliding, or one recording of a body that is moved.

    Parameters
    ----------
    force : (n,) array
        What moves the body, positive towards larger positions [N]; of a joint a torque [N m].
    velocity : (n,) array, optional
        [m/s] or [rad/s]; of a recording it may be left out where there are positions.
    position : (n,) array, optional
        Of a recording [m] or [rad].
    time : (n,) array, optional
        Rising; makes it a recording [s].
    pressure : (n,) array or float, optional
        Pressure difference across the seals [Pa].
    pressure_force : (n,) array, optional
        Force or torque of the gas on the body, towards larger positions [N] or [N m].
    uncertainty : float or (n,) array, optional
        One sigma of a single force, in a table: points then weigh by it [N] or [N m].
    body : str, optional
        `mass` (default) on a line, or `joint`, which turns: then positions are angles and forces torques.
    name : str, optional
        For people.

    Raises
    ------
    InputErrors
        Lengths that differ, values that are not finite, times that do not rise, no velocity and no positions.

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
            if (given := getattr(self, name)) is not None:
                array = numbers(name, given)
                arrays[name] = np.full(force.shape, float(array)) if array.ndim == 0 else array
        with ErrorCollector() as errors:
            if self.body not in COORDINATES:
                errors.add(
                    "fields.not_an_option",
                    "body",
                    value=self.body,
                    meaning="body",
                    near=NameSuggestion(self.body, COORDINATES),
                )
            for name, array in arrays.items():
                if array.shape != force.shape:
                    errors.add("friction.shape", name, shape=str(array.shape), points=force.size)
                elif not np.isfinite(array).all():
                    errors.add("friction.not_finite", name, place=int(np.argmin(np.isfinite(array))))
            if force.size < LEAST:
                errors.add("friction.too_few", "force", count=force.size, least=LEAST)
            if "velocity" not in arrays and not {"position", "time"} <= arrays.keys():
                errors.add("friction.no_velocity", "velocity")
            if "uncertainty" in arrays and not (arrays["uncertainty"] > 0.0).all():
                errors.add("friction.no_uncertainty", "uncertainty", value=float(np.min(arrays["uncertainty"])))
            if "time" in arrays and (bad := first_bad_time(arrays["time"], self.name)):
                errors.extend([bad[1]])
        if not np.ptp(arrays.get("velocity", arrays.get("position", force))) and "time" in arrays:
            raise InputError("friction.at_rest", "position", name=self.name)
        for name, array in arrays.items():
            object.__setattr__(self, name, array)

    @property
    def coordinate(self) -> Coordinate:
        """How the body moves."""
        return COORDINATES[self.body]

    def __len__(self) -> int:
        return int(self.force.size)

    @property
    def is_motion(self) -> bool:
        """True for a recording: its samples follow each other."""
        return self.time is not None

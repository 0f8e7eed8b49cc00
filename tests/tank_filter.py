"""Textbook extended Kalman filter of a tank, in NumPy, on the independent laws of the tank: no code of `poppet`.

The transition is the central difference of a Runge-Kutta integration, the correction that of one scalar reading.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from exact.independent_watch_tank import GAS_CONSTANT, Tank, paths, rates

Array = NDArray[np.float64]
SUBSTEPS = 8


@dataclass
class TankFilter:
    """Estimates z = (pressure, mass, free numbers) with their covariance, `fields` of the tank and an offset."""

    tank: Tank
    fields: tuple[str, ...]
    mean: Array
    covariance: Array
    walk: Array  # variances per second
    sizes: Array  # of the differences
    noise: float
    offset: bool = False

    def flow(self, z: Array, openings: Array, dt: float) -> Array:
        """States after an interval with constant openings."""
        tank = replace(self.tank, **dict(zip(self.fields, z[2:], strict=False)))
        ends = paths(tank, 1)
        driven = np.array([[openings[0]], [openings[1]], [tank.leak]], dtype=float)
        state = np.array([[z[0]], [z[0] * tank.volume / (z[1] * GAS_CONSTANT)]])
        step = dt / SUBSTEPS
        for _ in range(SUBSTEPS):
            first = rates(tank, ends, state, driven)
            second = rates(tank, ends, state + 0.5 * step * first, driven)
            third = rates(tank, ends, state + 0.5 * step * second, driven)
            fourth = rates(tank, ends, state + step * third, driven)
            state = state + step / 6.0 * (first + 2.0 * second + 2.0 * third + fourth)
        pressure, temperature = state[:, 0]
        return np.array([pressure, pressure * tank.volume / (GAS_CONSTANT * temperature)])

    def transition(self, openings: Array, dt: float) -> Array:
        """Derivative of all estimates at the end by those at the start."""
        matrix = np.eye(self.mean.size)
        for k, size in enumerate(self.sizes):
            shift = np.zeros(self.mean.size)
            shift[k] = 1e-4 * size
            forward, backward = (self.flow(self.mean + sign * shift, openings, dt) for sign in (1.0, -1.0))
            matrix[:2, k] = (forward - backward) / (2.0 * shift[k])
        return matrix

    def predict(self, openings: Array, dt: float) -> None:
        matrix = self.transition(openings, dt)
        self.mean[:2] = self.flow(self.mean, openings, dt)
        self.covariance = matrix @ self.covariance @ matrix.T + np.diag(self.walk) * dt

    def correct(self, reading: float) -> float:
        """Use a reading of the pressure, and return its squared normalised innovation."""
        slope = np.zeros(self.mean.size)
        slope[0] = 1.0
        slope[-1] += float(self.offset)
        variance = slope @ self.covariance @ slope + self.noise**2
        gain = self.covariance @ slope / variance
        innovation = reading - slope @ self.mean
        self.mean = self.mean + gain * innovation
        self.covariance = self.covariance - np.outer(gain, gain) * variance
        return innovation**2 / variance

"""A sampled loop: a linear plant behind a hold and a PID controller; its frequency response, margins and stability."""

from __future__ import annotations

from abc import ABC, abstractmethod
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.linear_model import LinearModel
from poppet.core.errors import InputError

Array = NDArray[np.float64]
Complex = NDArray[np.complex128]

DECADES = 6.0
"""Frequencies that are looked at, below half the sampling frequency."""
DENSE = 4000
_UNSEEN = 1e-9
"""A mode whose share of the output is below this part is not seen by the controller."""


@dataclass(frozen=True)
class Gains:
    """Numbers of a PID controller, as the part `pid` has them.

    Parameters
    ----------
    gain : float
        K, command per measurement, SI.
    integral_time, derivative_time, derivative_filter : float
        T_i, T_d, T_f [s]; an integral time of 0 is none.
    """

    gain: float
    integral_time: float = 0.0
    derivative_time: float = 0.0
    derivative_filter: float = 0.0

    def response(self, z: Complex, sample_time: float) -> Complex:
        r"""From the measurement's fall to the command.

        .. math:: C(z) = K \left(1 + \frac{T}{T_i} \frac{1}{z-1} + \frac{T_d (z - 1)}{(T_f + T) z - T_f}\right)

        Parameters
        ----------
        z : (n,) array
            Points of the z plane.
        sample_time : float
            T [s].

        Returns
        -------
        (n,) array
            Complex, command per measurement, SI.
        """
        shape = np.ones_like(z)
        if self.integral_time > 0.0:
            shape = shape + sample_time / self.integral_time / (z - 1.0)
        filtered = self.derivative_filter
        derivative = self.derivative_time * (z - 1.0) / ((filtered + sample_time) * z - filtered)
        return np.asarray(self.gain * (shape + derivative), dtype=np.complex128)


class LoopPlant(ABC):
    """What a sampled controller meets: a frequency response, and when a loop around it is stable."""

    if TYPE_CHECKING:
        sample_time: float  # a field of each

    @property
    def frequencies(self) -> Array:
        """Where responses are looked at, up to half the sampling frequency [Hz]."""
        highest = 0.5 / self.sample_time
        return np.geomspace(highest * 10.0**-DECADES, highest, DENSE)

    def at(self, frequencies: Array) -> Complex:
        """The z plane's points of frequencies.

        Parameters
        ----------
        frequencies : (n,) array
            In [Hz].

        Returns
        -------
        (n,) array
            On the unit circle.
        """
        return np.asarray(np.exp(2j * np.pi * np.asarray(frequencies) * self.sample_time), dtype=np.complex128)

    @abstractmethod
    def response(self, z: Complex) -> Complex:
        """From the command to the measurement.

        Parameters
        ----------
        z : (n,) array
            Points of the z plane.

        Returns
        -------
        (n,) array
            Complex, measurement per command, SI.
        """

    @abstractmethod
    def is_stable_with(self, gains: Gains) -> bool:
        """True when all modes of the loop that the measurement shows decay.

        Parameters
        ----------
        gains : Gains
            Of the controller.

        Returns
        -------
        bool
        """


@dataclass(frozen=True, eq=False)
class SampledPlant(LoopPlant):
    r"""A plant between two instants: :math:`x_{k+1} = A x_k + B u_k,\ y_k = C x_k`.

    Parameters
    ----------
    A, B, C : (n, n), (n,), (n,) arrays
        In states of its own.
    sample_time : float
        T [s].
    delay : int
        Samples by which a command comes late.
    """

    A: Array
    B: Array
    C: Array
    sample_time: float
    delay: int = 0

    def response(self, z: Complex) -> Complex:
        matrices = z[:, None, None] * np.eye(len(self.B)) - self.A
        states = np.linalg.solve(matrices, np.broadcast_to(self.B[:, None].astype(complex), (*z.shape, len(self.B), 1)))
        return np.asarray((states[:, :, 0] @ self.C) * z ** -float(self.delay), dtype=np.complex128)

    def is_stable_with(self, gains: Gains) -> bool:
        a, _, y = closed_loop(self, gains)
        if gains.integral_time <= 0.0:  # an integral that is left out stays where it is
            keep = np.arange(len(a)) != len(self.B) + self.delay
            a, y = a[np.ix_(keep, keep)], y[keep]
        values, vectors = np.linalg.eig(a)
        shown = np.abs(y @ vectors) / (np.linalg.norm(y) * np.linalg.norm(vectors, axis=0))
        return bool(np.all(np.abs(values[shown > _UNSEEN]) < 1.0))


def sampled_plant(
    model: LinearModel, weights: dict[str, float], output: str, *, sample_time: float, sensor_lag: float = 0.0,
    delay: int = 0,
) -> SampledPlant:  # fmt: skip
    """A linear model behind a hold, with its sensor."""
    from scipy.linalg import expm

    columns = {name: model.inputs.index(name) for name in weights}
    row = model.outputs.index(output)
    # States of size one: pressures and masses are ten decades apart.
    size = np.where(model.x != 0.0, np.abs(model.x), 1.0)
    a = model.A * size[None, :] / size[:, None]
    b = sum((weights[name] * model.B[:, k] for name, k in columns.items()), np.zeros(len(size))) / size
    c = model.C[row] * size
    through = sum(weights[name] * model.D[row, k] for name, k in columns.items())
    if through != 0.0:
        raise InputError("plant.direct", output, inputs=tuple(weights))
    n = len(size)
    if sensor_lag > 0.0:
        a = np.block([[a, np.zeros((n, 1))], [c[None, :] / sensor_lag, np.array([[-1.0 / sensor_lag]])]])
        b, c, n = np.append(b, 0.0), np.append(np.zeros(n), 1.0), n + 1
    # The command is a state that stays: one matrix exponential gives both matrices of the held plant.
    both = np.zeros((n + 1, n + 1))
    both[:n, :n], both[:n, n] = a, b
    held = expm(both * sample_time)
    return SampledPlant(held[:n, :n], held[:n, n], c, sample_time, delay)


@dataclass(frozen=True)
class Margins:
    """How far a loop is from trouble.

    Parameters
    ----------
    is_stable : bool
        All modes that the controller sees decay.
    sensitivity : float
        Ms, greatest |1/(1 + L)|: the inverse of the least distance to -1.
    complementary : float
        Mt, greatest |L/(1 + L)|.
    gain_margin : float
        Factor on the gain that makes it unstable; inf for none.
    phase_margin : float
        At the crossover [deg].
    delay_margin : float
        Additional delay that makes it unstable [s].
    crossover : float
        Highest frequency with |L| = 1 [Hz]; 0 for none.
    """

    is_stable: bool
    sensitivity: float
    complementary: float
    gain_margin: float
    phase_margin: float
    delay_margin: float
    crossover: float


def margins(plant: LoopPlant, gains: Gains, *, response: Complex | None = None) -> Margins:
    """Margins of a loop, on a dense grid of frequencies up to half the sampling frequency.

    Parameters
    ----------
    plant : LoopPlant
        With its delay.
    gains : Gains
        Of the controller.
    response : (n,) array, optional
        The plant's own at its frequencies, where that has been worked out already.

    Returns
    -------
    Margins
        An unstable loop has figures too; they mean nothing but how the response runs.

    Examples
    --------
    An integrator under proportional control, without a delay: stable up to K T = 2.

    >>> plant = SampledPlant(np.eye(1), np.array([1e-3]), np.ones(1), 1e-3)
    >>> margins(plant, Gains(1000.0)).is_stable, margins(plant, Gains(2100.0)).is_stable
    (True, False)
    >>> round(margins(plant, Gains(500.0)).gain_margin, 4)
    4.0
    """
    frequencies = plant.frequencies
    z = plant.at(frequencies)
    loop = (plant.response(z) if response is None else response) * gains.response(z, plant.sample_time)
    crossing = np.flatnonzero((np.abs(loop[:-1]) >= 1.0) != (np.abs(loop[1:]) >= 1.0))
    phases, crossovers = [], []
    for k in crossing:
        # Between two frequencies loops are straight in the usual diagram: logarithms of size and frequency.
        share = np.log(np.abs(loop[k])) / (np.log(np.abs(loop[k])) - np.log(np.abs(loop[k + 1])))
        there = loop[k] * (loop[k + 1] / loop[k]) ** share
        crossovers.append(float(frequencies[k] * (frequencies[k + 1] / frequencies[k]) ** share))
        phases.append(float(np.angle(-there, deg=True)))
    delays = [np.radians(p % 360.0) / (2.0 * np.pi * f) for p, f in zip(phases, crossovers, strict=True)]
    return Margins(
        is_stable=plant.is_stable_with(gains),
        sensitivity=float(np.max(1.0 / np.abs(1.0 + loop))),
        complementary=float(np.max(np.abs(loop / (1.0 + loop)))),
        gain_margin=_gain_margin(loop),
        phase_margin=min(map(abs, phases), default=np.inf),
        delay_margin=float(min(delays, default=np.inf)),
        crossover=max(crossovers, default=0.0),
    )


def _gain_margin(loop: Complex) -> float:
    """Least factor above one with which the response goes through -1, half the sampling frequency included."""
    crosses = np.flatnonzero((loop.imag[:-1] >= 0.0) != (loop.imag[1:] >= 0.0))
    share = loop.imag[crosses] / (loop.imag[crosses] - loop.imag[crosses + 1])
    real = loop.real[crosses] + share * (loop.real[crosses + 1] - loop.real[crosses])
    real = np.append(real, loop.real[-1])
    found = -1.0 / real[(real < 0.0) & (real > -1.0)]
    return float(np.min(found, initial=np.inf))


def closed_loop(plant: SampledPlant, gains: Gains, setpoint_weight: float = 1.0) -> tuple[Array, Array, Array]:
    """The loop as one system from the setpoint to the measurement: its matrices x+ = a x + b w, y x.

    States: those of the plant, commands on their way, the integral, the filtered derivative, the last measurement.
    """
    n, d, time = len(plant.B), plant.delay, plant.sample_time
    k, filtered = gains.gain, gains.derivative_filter
    rate = k * time / gains.integral_time if gains.integral_time > 0.0 else 0.0
    share, push = filtered / (filtered + time), k * gains.derivative_time / (filtered + time)
    size = n + d + 3
    y = np.concatenate([plant.C, np.zeros(d + 3)])
    command = -(k + push) * y
    command[n + d :] += (1.0, share, push)
    derivative = -push * y
    derivative[n + d :] += (0.0, share, push)
    a, b = np.zeros((size, size)), np.zeros(size)
    a[:n, :n] = plant.A
    weight = k * setpoint_weight
    if d == 0:
        a[:n] += np.outer(plant.B, command)
        b[:n] = plant.B * weight
    else:  # the plant takes the oldest of the commands on their way, the newest goes to their end
        a[:n, n] = plant.B
        a[n : n + d - 1, n + 1 : n + d] = np.eye(d - 1)
        a[n + d - 1], b[n + d - 1] = command, weight
    a[n + d] = -rate * y
    a[n + d, n + d] += 1.0
    b[n + d] = rate
    a[n + d + 1], a[n + d + 2] = derivative, y
    return a, b, y


def step_response(plant: SampledPlant, gains: Gains, setpoint_weight: float, samples: int) -> Array:
    """Measurement after a unit step of the setpoint."""
    a, b, y = closed_loop(plant, gains, setpoint_weight)
    x, found = np.zeros(len(b)), np.empty(samples)
    for k in range(samples):
        found[k] = y @ x
        x = a @ x + b
    return found

"""Sampled loops of a linear plant and a PID controller: frequency response, margins and stability."""

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
"""Width of the range of evaluated frequencies, which ends at half the sampling frequency [decades]."""
DENSE = 4000
_UNOBSERVABLE = 1e-9
"""Fraction of the output below which a mode counts as not observable."""


@dataclass(frozen=True)
class Gains:
    """Gains of a PID controller, under the names that the part `pid` uses.

    Parameters
    ----------
    gain : float
        K, command per measurement, SI.
    integral_time, derivative_time, derivative_filter : float
        T_i, T_d, T_f [s]; an integral time of 0 disables the integral.
    """

    gain: float
    integral_time: float = 0.0
    derivative_time: float = 0.0
    derivative_filter: float = 0.0

    def response(self, z: Complex, sample_time: float) -> Complex:
        r"""Return the frequency response of the controller.

        The input is a decrease of the measurement, and the output is the command.

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
        unit_response = np.ones_like(z)
        if self.integral_time > 0.0:
            unit_response = unit_response + sample_time / self.integral_time / (z - 1.0)
        filter_time = self.derivative_filter
        derivative = self.derivative_time * (z - 1.0) / ((filter_time + sample_time) * z - filter_time)
        return np.asarray(self.gain * (unit_response + derivative), dtype=np.complex128)


class LoopPlant(ABC):
    """Plant of a sampled controller, with its frequency response and a stability test."""

    if TYPE_CHECKING:
        sample_time: float  # a field of each subclass

    @property
    def frequencies(self) -> Array:
        """Frequencies at which the loop is evaluated, up to half the sampling frequency [Hz]."""
        highest = 0.5 / self.sample_time
        return np.geomspace(highest * 10.0**-DECADES, highest, DENSE)

    def at(self, frequencies: Array) -> Complex:
        """Return the points of the z plane that correspond to frequencies.

        Parameters
        ----------
        frequencies : (n,) array
            Frequencies [Hz].

        Returns
        -------
        (n,) array
            Points on the unit circle.
        """
        return np.asarray(np.exp(2j * np.pi * np.asarray(frequencies) * self.sample_time), dtype=np.complex128)

    @abstractmethod
    def response(self, z: Complex) -> Complex:
        """Return the frequency response of the plant from the command to the measurement.

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
        """Return True if the closed loop of this plant and a controller is stable.

        Parameters
        ----------
        gains : Gains
            Gains of the controller.

        Returns
        -------
        bool
        """


@dataclass(frozen=True, eq=False)
class SampledPlant(LoopPlant):
    r"""Linear plant between sample instants: :math:`x_{k+1} = A x_k + B u_k,\ y_k = C x_k`.

    Parameters
    ----------
    A, B, C : (n, n), (n,), (n,) arrays
        Matrices for scaled states.
    sample_time : float
        T [s].
    delay : int
        Delay of a command [samples].
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
        if gains.integral_time <= 0.0:  # a disabled integral is constant
            kept_states = np.arange(len(a)) != len(self.B) + self.delay
            a, y = a[np.ix_(kept_states, kept_states)], y[kept_states]
        values, vectors = np.linalg.eig(a)
        observability = np.abs(y @ vectors) / (np.linalg.norm(y) * np.linalg.norm(vectors, axis=0))
        return bool(np.all(np.abs(values[observability > _UNOBSERVABLE]) < 1.0))


def sampled_plant(
    model: LinearModel, weights: dict[str, float], output: str, *, sample_time: float, sensor_lag: float = 0.0,
    delay: int = 0,
) -> SampledPlant:  # fmt: skip
    """Convert a linear model to a sampled plant with hold, delay and sensor.

    `weights` maps each input of the model to its factor on the command, and `output` is the name of the measured
    output. The keyword `sensor_lag` is the time constant of the sensor [s], and the keyword `delay` is a number of
    samples.
    """
    from scipy.linalg import expm

    columns = {name: model.inputs.index(name) for name in weights}
    row = model.outputs.index(output)
    # Scaled states: pressures and masses differ by ten decades.
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
    # The command is a constant state: one matrix exponential gives both matrices.
    augmented = np.zeros((n + 1, n + 1))
    augmented[:n, :n], augmented[:n, n] = a, b
    discrete = expm(augmented * sample_time)
    return SampledPlant(discrete[:n, :n], discrete[:n, n], c, sample_time, delay)


@dataclass(frozen=True)
class Margins:
    """Stability and robustness margins of a closed loop.

    Parameters
    ----------
    is_stable : bool
        True if all observable modes decay.
    sensitivity : float
        Ms, maximum of |1/(1 + L)|, where L is the open-loop response: the inverse of its smallest distance to -1.
    complementary : float
        Mt, maximum of |L/(1 + L)|.
    gain_margin : float
        Smallest factor above 1 on the gain for which L passes through -1; infinite if there is none.
    phase_margin : float
        Smallest phase margin of all crossovers [deg].
    delay_margin : float
        Smallest additional delay at the stability limit [s].
    crossover : float
        Highest frequency with |L| = 1 [Hz]; 0 if there is none.
    gain_frequency, phase_frequency : float
        Frequencies at which L determines the gain margin and the phase margin [Hz]; 0 if there is none.
    lower_gain_margin : float
        Largest factor below 1 on the gain for which L passes through -1; 0 if there is none. A conditionally stable
        loop becomes unstable below it.
    lower_gain_frequency : float
        Frequency of the lower gain margin [Hz]; 0 if there is none.
    """

    is_stable: bool
    sensitivity: float
    complementary: float
    gain_margin: float
    phase_margin: float
    delay_margin: float
    crossover: float
    gain_frequency: float = 0.0
    phase_frequency: float = 0.0
    lower_gain_margin: float = 0.0
    lower_gain_frequency: float = 0.0


def margins(plant: LoopPlant, gains: Gains, *, response: Complex | None = None) -> Margins:
    """Return stability and robustness margins of a control loop.

    The margins are evaluated at the frequencies of the plant. `response` is the frequency response of the plant if it
    is already known.

    Parameters
    ----------
    plant : LoopPlant
        Plant with its delay.
    gains : Gains
        Gains of the controller.
    response : (n,) array, optional
        Response of the plant at `plant.frequencies`, if it is available.

    Returns
    -------
    Margins
        Margins of the loop. For an unstable loop they only describe the frequency response.

    Examples
    --------
    An integrator with proportional control and without delay is stable up to K T = 2.

    >>> plant = SampledPlant(np.eye(1), np.array([1e-3]), np.ones(1), 1e-3)
    >>> margins(plant, Gains(1000.0)).is_stable, margins(plant, Gains(2100.0)).is_stable
    (True, False)
    >>> round(margins(plant, Gains(500.0)).gain_margin, 4)
    4.0
    """
    frequencies = plant.frequencies
    z = plant.at(frequencies)
    loop = (plant.response(z) if response is None else response) * gains.response(z, plant.sample_time)
    crossings = np.flatnonzero((np.abs(loop[:-1]) >= 1.0) != (np.abs(loop[1:]) >= 1.0))
    phases, crossovers = [], []
    for k in crossings:
        # Linear interpolation of the logarithms of magnitude and frequency.
        fraction = np.log(np.abs(loop[k])) / (np.log(np.abs(loop[k])) - np.log(np.abs(loop[k + 1])))
        crossing_value = loop[k] * (loop[k + 1] / loop[k]) ** fraction
        crossovers.append(float(frequencies[k] * (frequencies[k + 1] / frequencies[k]) ** fraction))
        phases.append(float(np.angle(-crossing_value, deg=True)))
    # The values at which the response crosses the real axis.
    crossings = np.flatnonzero((loop.imag[:-1] >= 0.0) != (loop.imag[1:] >= 0.0))
    fractions = loop.imag[crossings] / (loop.imag[crossings] - loop.imag[crossings + 1])
    real = loop.real[crossings] + fractions * (loop.real[crossings + 1] - loop.real[crossings])
    real = np.append(real, loop.real[-1])
    real_frequencies = frequencies[crossings] * (frequencies[crossings + 1] / frequencies[crossings]) ** fractions
    real_frequencies = np.append(real_frequencies, frequencies[-1])
    is_relevant = (real < 0.0) & (real > -1.0)
    limit = int(np.argmin(np.where(is_relevant, real, np.inf)))
    is_below = real < -1.0
    lower_limit = int(np.argmax(np.where(is_below, real, -np.inf)))
    delays = [np.radians(p % 360.0) / (2.0 * np.pi * f) for p, f in zip(phases, crossovers, strict=True)]
    return Margins(
        is_stable=plant.is_stable_with(gains),
        sensitivity=float(np.max(1.0 / np.abs(1.0 + loop))),
        complementary=float(np.max(np.abs(loop / (1.0 + loop)))),
        gain_margin=float(np.min(-1.0 / real[is_relevant], initial=np.inf)),
        phase_margin=min(map(abs, phases), default=np.inf),
        delay_margin=float(min(delays, default=np.inf)),
        crossover=max(crossovers, default=0.0),
        gain_frequency=float(real_frequencies[limit]) if is_relevant.any() else 0.0,
        phase_frequency=crossovers[int(np.argmin(np.abs(phases)))] if phases else 0.0,
        lower_gain_margin=float(np.max(-1.0 / real[is_below], initial=0.0)),
        lower_gain_frequency=float(real_frequencies[lower_limit]) if is_below.any() else 0.0,
    )


def closed_loop(plant: SampledPlant, gains: Gains, setpoint_weight: float = 1.0) -> tuple[Array, Array, Array]:
    """Return the matrices of the closed loop from setpoint to measurement.

    The result contains a, (n, n), b, (n,), and y, (n,). The loop is x+ = a x + b w, where x+ is the state one sample
    later and w the setpoint; the measurement is y x. The states are the states of the plant, delayed commands, the
    integral, the filtered derivative and the last measurement.
    """
    n, d, time = len(plant.B), plant.delay, plant.sample_time
    k, filter_time = gains.gain, gains.derivative_filter
    rate = k * time / gains.integral_time if gains.integral_time > 0.0 else 0.0
    filter_pole, derivative_gain = filter_time / (filter_time + time), k * gains.derivative_time / (filter_time + time)
    size = n + d + 3
    y = np.concatenate([plant.C, np.zeros(d + 3)])
    command = -(k + derivative_gain) * y
    command[n + d :] += (1.0, filter_pole, derivative_gain)
    derivative = -derivative_gain * y
    derivative[n + d :] += (0.0, filter_pole, derivative_gain)
    a, b = np.zeros((size, size)), np.zeros(size)
    a[:n, :n] = plant.A
    weight = k * setpoint_weight
    if d == 0:
        a[:n] += np.outer(plant.B, command)
        b[:n] = plant.B * weight
    else:  # delay line of commands
        a[:n, n] = plant.B
        a[n : n + d - 1, n + 1 : n + d] = np.eye(d - 1)
        a[n + d - 1], b[n + d - 1] = command, weight
    a[n + d] = -rate * y
    a[n + d, n + d] += 1.0
    b[n + d] = rate
    a[n + d + 1], a[n + d + 2] = derivative, y
    return a, b, y


def step_response(plant: SampledPlant, gains: Gains, setpoint_weight: float, samples: int) -> Array:
    """Return the response of the closed loop to a unit step of the setpoint.

    The result is the measurement at each of `samples` sample instants.
    """
    return _response(*closed_loop(plant, gains, setpoint_weight), samples)


def disturbance_response(plant: SampledPlant, gains: Gains, samples: int) -> Array:
    """Return the response of the closed loop to a unit step that is added to the command at the plant.

    The result is the measurement at each of `samples` sample instants, per unit of the command. The step is not
    delayed.
    """
    a, b, y = closed_loop(plant, gains)
    return _response(a, np.concatenate([plant.B, np.zeros(len(b) - len(plant.B))]), y, samples)


def _response(a: Array, b: Array, y: Array, samples: int) -> Array:
    x, measured = np.zeros(len(b)), np.empty(samples)
    for k in range(samples):
        measured[k] = y @ x
        x = a @ x + b
    return measured

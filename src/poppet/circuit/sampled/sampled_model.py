"""Discrete-time linear model of a sampled circuit."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.linear_model import ControlStateSpace, LinearModel, SteadyState, index_of
from poppet.circuit.sampled.point import SampledPoint
from poppet.circuit.sampled.sample_map import Phase, eigenvalues_of, phases_of, sample_map
from poppet.core.codes import Note

Array = NDArray[np.float64]

GONE = 1e-12
"""Absolute value of an eigenvalue of A below which a mode counts as decayed within one sample."""


@dataclass(frozen=True, eq=False)
class SampledModel(LinearModel):
    r"""Linear model of a sampled circuit for small changes about a steady state, over one sample.

    .. math:: \delta v_{k+1} = A\,\delta v_k + B\,\delta u_k, \qquad \delta y_k = C\,\delta v_k + D\,\delta u_k

    Parameters
    ----------
    A, B, C, D : (n, n), (n, n_u), (n_y, n), (n_y, n_u) arrays
        Exact derivatives, SI. v is the value just before a sample, y just after it; u is constant over the sample.
    states, inputs, outputs : tuple of str
        Addresses; `states` contains the states, then the discrete states except clocks.
    x, u, y : (n,), (n_u,), (n_y,) arrays
        Operating point, SI.
    rates : (n,) array
        Change of v over a sample, per second: zero for a steady state.
    sample_time : float
        Common period of all clocks [s].
    notes : tuple of Note
        Kinks that limit the validity of the model.
    phases : tuple of Phase
        Linear maps of each instant in a sample with the time after it, in units of `sizes`.
    sizes : (n,) array
        Typical sizes of v, SI.
    output_slopes : pair of arrays
        Derivatives of the outputs between instants, by v and by u, SI.

    Notes
    -----
    Between two instants the discrete states are constant, so the matrix exponential of the continuous part is exact.
    The map at an instant contains the derivatives of the controllers, whose clocks act in the order of their ranks.
    """

    sample_time: float = 0.0
    notes: tuple[Note, ...] = ()
    phases: tuple[Phase, ...] = field(default=(), repr=False)
    sizes: Array = field(default_factory=lambda: np.zeros(0), repr=False)
    output_slopes: tuple[Array, Array] = field(default=(np.zeros(0), np.zeros(0)), repr=False)

    more: ClassVar[tuple[str, ...]] = ("sample_time",)

    def eigenvalues(self) -> NDArray[np.complex128]:
        """Return the eigenvalues z of A, the discrete-time poles."""
        values = eigenvalues_of(self.A * self.sizes[None, :] / self.sizes[:, None])
        return values[np.lexsort((values.imag, -np.abs(values)))]

    def poles(self) -> NDArray[np.complex128]:
        r"""Return the poles in the s-plane [1/s], from the eigenvalues z of A.

        .. math:: s = \frac{\ln z}{T}
        """
        # A mode that decays within one sample has no pole: the logarithm is minus infinity.
        values = self.eigenvalues()
        poles = (np.log(values[np.abs(values) > GONE]) / self.sample_time).astype(np.complex128)
        return poles[np.lexsort((poles.imag, np.abs(poles)))]

    def frequency_response(self, frequencies: ArrayLike, input: str, output: str) -> NDArray[np.complex128]:
        r"""Return the frequency response of one output to one input, including the sample-and-hold.

        .. math:: G(\mathrm{i}\omega) = \frac{1}{T} \int_0^T y(t)\, e^{-\mathrm{i}\omega t}\,\mathrm{d}t,
                  \qquad u(t) = e^{\mathrm{i}\omega t}

        Notes
        -----
        The response is exact for the linear circuit: the input also changes between instants, and the output is
        averaged over the sample. Variables that are multiplied by exp(-i omega t) are periodic over a sample.
        """
        column, row = index_of(self.inputs, input, "input"), index_of(self.outputs, output, "output")
        by_v, by_u = self.output_slopes[0][row] * self.sizes, self.output_slopes[1][row, column]
        values = np.atleast_1d(np.asarray(frequencies, dtype=float))
        mean = [by_v @ self._rotating_mean(2.0 * np.pi * f, column) for f in values]
        return np.array(mean, dtype=np.complex128) + complex(by_u)

    def state_response(self, frequency: float, input: str) -> NDArray[np.complex128]:
        """Return the complex amplitudes of the states v in response to a unit sine at one input."""
        column = index_of(self.inputs, input, "input")
        return np.asarray(self._rotating_mean(2.0 * np.pi * frequency, column) * self.sizes, dtype=np.complex128)

    def _rotating_mean(self, omega: float, column: int) -> NDArray[np.complex128]:
        """Return the mean of v exp(-i omega t) over one sample period.

        `omega` is the angular frequency [rad/s] of a sine at the input with the index `column`. The result is in units
        of the typical sizes of v.
        """
        steps, n = [], self.sizes.size
        matrix, offset = np.eye(n, dtype=complex), np.zeros(n, dtype=complex)
        for phase in self.phases:
            rates = phase.rates_v - 1j * omega * np.eye(n)
            flow = phase.flow_v * np.exp(-1j * omega * phase.duration)
            shift = np.linalg.solve(rates, phase.rates_u[:, column].astype(complex))
            steps.append((phase, rates, flow, shift))
            matrix, offset = phase.at_v @ matrix, phase.at_v @ offset + phase.at_u[:, column]
            matrix, offset = flow @ matrix, flow @ (offset + shift) - shift
        # Periodic over a sample, in the frame that rotates with the input.
        v = np.linalg.solve(np.eye(n) - matrix, offset)
        total = np.zeros(n, dtype=complex)
        for phase, rates, flow, shift in steps:
            start = phase.at_v @ v + phase.at_u[:, column]
            v = flow @ (start + shift) - shift
            total += np.linalg.solve(rates, v - start) - shift * phase.duration
        return np.asarray(total / self.sample_time, dtype=np.complex128)

    def to_control(self) -> ControlStateSpace:
        """Return the model as a `control.StateSpace` in discrete time."""
        system = super().to_control()
        # The base class builds a model in continuous time.
        system.dt = self.sample_time
        return system


def sampled_model(instance: Instance, steady: SteadyState) -> SampledModel:
    """Return the discrete-time linear model of an instance at a steady state."""
    point = SampledPoint(instance, np.array(list(steady.u.values())))
    v = point.v(steady.x, np.array(list(steady.memory.values())))
    return model_at(point, v, steady.notes)


def model_at(point: SampledPoint, v: Array, notes: tuple[Note, ...] = ()) -> SampledModel:
    """Return the discrete-time linear model of a sampled circuit at a steady state v.

    `point` contains the equations of the circuit, and `notes` become the notes of the model.
    """
    intersample, size = point.between(v), point.size
    phases = phases_of(point, v, intersample)
    a, b = sample_map(point, phases)
    by_v, by_u = intersample.outputs_by_v, intersample.outputs_by_u
    # At an instant, a recording contains the outputs after it.
    first_v = phases[0].at_v * size[:, None] / size[None, :]
    c, d = by_v @ first_v, by_u + by_v @ (phases[0].at_u * size[:, None])
    f, _ = point.scaled(v)
    return SampledModel(
        a * size[:, None] / size[None, :], b * size[:, None], c, d,
        point.names, point.input_names, point.model.columns[0], v, point.u, intersample.outputs, f * size,
        point.clock.sample_time, notes, phases, size, (by_v, by_u),
    )  # fmt: skip

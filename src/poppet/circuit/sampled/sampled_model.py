"""The discrete linear model of a circuit with sampled memory."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.linear_model import ControlStateSpace, LinearModel, SteadyState, place
from poppet.circuit.sampled.point import SampledPoint
from poppet.circuit.sampled.sample_map import Phase, eigenvalues_of, phases_of, sample_map
from poppet.core.codes import Note

Array = NDArray[np.float64]

GONE = 1e-12
"""Size below which an eigenvalue over a sample is one of what is forgotten at once."""


@dataclass(frozen=True, eq=False)
class SampledModel(LinearModel):
    r"""A circuit with sampled memory for small changes about a rest, from one sample to the next.

    .. math:: \delta v_{k+1} = A\,\delta v_k + B\,\delta u_k, \qquad \delta y_k = C\,\delta v_k + D\,\delta u_k

    Parameters
    ----------
    A, B, C, D : (n, n), (n, n_u), (n_y, n), (n_y, n_u) arrays
        Exact derivatives, SI. v stands just before a sample, y just after it, u is held over it.
    states, inputs, outputs : tuple of str
        Addresses; `states` are those of the circuit and behind them its memory without the clocks.
    x, u, y : (n,), (n_u,), (n_y,) arrays
        The point, SI.
    rates : (n,) array
        Change of v over a sample, per second: zero at rest.
    sample_time : float
        Time after which all clocks tick together again [s].
    notes : tuple of Note
        Kinks beyond which the model does not hold.
    phases : tuple of Phase
        What happens inside a sample, in units of `sizes`.
    sizes : (n,) array
        Usual sizes of v, SI.
    output_slopes : pair of arrays
        Derivatives of the outputs between instants, by v and by u, SI.

    Notes
    -----
    Between two instants the memory is constant, so that the matrix exponential of the continuous part is exact; an
    instant is the derivative of what the program does, its clocks in the order of their ranks.
    """

    sample_time: float = 0.0
    notes: tuple[Note, ...] = ()
    phases: tuple[Phase, ...] = field(default=(), repr=False)
    sizes: Array = field(default_factory=lambda: np.zeros(0), repr=False)
    output_slopes: tuple[Array, Array] = field(default=(np.zeros(0), np.zeros(0)), repr=False)

    more: ClassVar[tuple[str, ...]] = ("sample_time",)

    def eigenvalues(self) -> NDArray[np.complex128]:
        """Eigenvalues of A, from one sample to the next."""
        values = eigenvalues_of(self.A * self.sizes[None, :] / self.sizes[:, None])
        return values[np.lexsort((values.imag, -np.abs(values)))]

    def poles(self) -> NDArray[np.complex128]:
        r"""Poles of the motion in time.

        .. math:: s = \frac{\ln z}{T}
        """
        # What is forgotten at once has no pole: its logarithm is minus infinity.
        values = self.eigenvalues()
        poles = (np.log(values[np.abs(values) > GONE]) / self.sample_time).astype(np.complex128)
        return poles[np.lexsort((poles.imag, np.abs(poles)))]

    def frequency_response(self, frequencies: ArrayLike, input: str, output: str) -> NDArray[np.complex128]:
        r"""Response of one output to a sine at one input, the hold between samples included.

        .. math:: G(\mathrm{i}\omega) = \frac{1}{T} \int_0^T y(t)\, e^{-\mathrm{i}\omega t}\,\mathrm{d}t,
                  \qquad u(t) = e^{\mathrm{i}\omega t}

        Notes
        -----
        Exact for the linear circuit: the input moves on between the instants, and the output is taken over all of the
        sample. In the frame that turns with the input everything repeats after a sample.
        """
        column, row = place(self.inputs, input, "input"), place(self.outputs, output, "output")
        by_v, by_u = self.output_slopes[0][row] * self.sizes, self.output_slopes[1][row, column]
        values = np.atleast_1d(np.asarray(frequencies, dtype=float))
        mean = [by_v @ self._turning_mean(2.0 * np.pi * f, column) for f in values]
        return np.array(mean, dtype=np.complex128) + complex(by_u)

    def state_response(self, frequency: float, input: str) -> NDArray[np.complex128]:
        """Response of all of v to a sine at one input."""
        column = place(self.inputs, input, "input")
        return np.asarray(self._turning_mean(2.0 * np.pi * frequency, column) * self.sizes, dtype=np.complex128)

    def _turning_mean(self, omega: float, column: int) -> NDArray[np.complex128]:
        """Mean of v exp(-i omega t) over a sample, in sizes."""
        steps, n = [], self.sizes.size
        turning, offset = np.eye(n, dtype=complex), np.zeros(n, dtype=complex)
        for phase in self.phases:
            slow = phase.rates_v - 1j * omega * np.eye(n)
            flow = phase.flow_v * np.exp(-1j * omega * phase.duration)
            rest = np.linalg.solve(slow, phase.rates_u[:, column].astype(complex))
            steps.append((phase, slow, flow, rest))
            turning, offset = phase.at_v @ turning, phase.at_v @ offset + phase.at_u[:, column]
            turning, offset = flow @ turning, flow @ (offset + rest) - rest
        # After a sample all is as before, in the frame that turns with the input.
        v = np.linalg.solve(np.eye(n) - turning, offset)
        total = np.zeros(n, dtype=complex)
        for phase, slow, flow, rest in steps:
            before = phase.at_v @ v + phase.at_u[:, column]
            v = flow @ (before + rest) - rest
            total += np.linalg.solve(slow, v - before) - rest * phase.duration
        return np.asarray(total / self.sample_time, dtype=np.complex128)

    def to_control(self) -> ControlStateSpace:
        """Return the model as a `control.StateSpace` in discrete time."""
        system = super().to_control()
        # The base class builds a model in continuous time.
        system.dt = self.sample_time
        return system


def sampled_model(instance: Instance, rest: SteadyState) -> SampledModel:
    """Linear model over one sample."""
    point = SampledPoint(instance, np.array(list(rest.u.values())))
    v = point.v(rest.x, np.array(list(rest.memory.values())))
    return model_at(point, v, rest.notes)


def model_at(point: SampledPoint, v: Array, notes: tuple[Note, ...] = ()) -> SampledModel:
    """Linear model over one sample at a rest that is known."""
    between, size = point.between(v), point.size
    phases = phases_of(point, v, between)
    a, b = sample_map(point, phases)
    by_v, by_u = between.outputs_by_v, between.outputs_by_u
    # Outputs of a recording at an instant are those after it.
    first_v = phases[0].at_v * size[:, None] / size[None, :]
    c, d = by_v @ first_v, by_u + by_v @ (phases[0].at_u * size[:, None])
    f, _ = point.scaled(v)
    return SampledModel(
        a * size[:, None] / size[None, :], b * size[:, None], c, d,
        point.names, point.input_names, point.model.columns[0], v, point.u, between.outputs, f * size,
        point.clock.sample_time, notes, phases, size, (by_v, by_u),
    )  # fmt: skip

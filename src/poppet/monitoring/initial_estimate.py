"""Initial estimate of a filter from the first readings, with its covariance."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.engine.kernel import compile_kernel
from poppet.monitoring.plan import WatchPlan

Array = NDArray[np.float64]

UNKNOWN = {"Pa": 1e5, "K": 20.0}
"""Standard deviations of initial pressures and temperatures without a sensor, in the unit.

Other initial values have the typical size of the state with the same address.
"""
STEP = 1e-6
"""Step of the differences of the initial state, relative to these standard deviations."""


def ordered_product(a: Array, b: Array) -> Array:
    """Return the product of a matrix and a matrix or vector, with the sums in sequence.

    The result has the bits of the exported C code; those of `@` depend on the processor.
    """
    total = np.zeros((a.shape[0], *b.shape[1:]))
    for k in range(a.shape[1]):
        total += np.multiply.outer(a[:, k], b[k])
    return total


class InitialEstimate(NamedTuple):
    """Estimate z = (x, theta) at the first sample, with the mask of the readings that it contains."""

    mean: Array  # (n + m,)
    covariance: Array  # (n + m, n + m)
    is_used: NDArray[np.bool_]  # (c,)


class InitialState:
    r"""Initial states of a plant, as a function of the first readings and the free numbers.

    The parts compute the initial state from initial pressures, temperatures and positions. A reading replaces the
    initial value of its output; all other initial values are those of the circuit, with large standard deviations. The
    estimate is linear in the errors of these values:

    .. math:: \delta x = S_r (\varepsilon - E\,\delta\theta) + S_u\,\eta + S_\theta\,\delta\theta

    with the noise of the readings, the errors of the other initial values, and the free numbers.
    """

    def __init__(self, plan: WatchPlan, noise: Array | None = None, *, fuses: bool = True) -> None:
        self.plan = plan
        self._noise = np.array([channel.noise for channel in plan.channels]) if noise is None else noise
        instance = plan.instance
        self._states = instance.model.states
        self._kernel = instance.kernel if fuses else compile_kernel(instance.model, fuses=False)
        _, self.p = instance.start()
        # A compound part also names chambers that it does not have, such as the rod side of a single-acting cylinder.
        self.places = {
            a: instance.place(target) for a, target in instance.initial.items() if target in instance.parameters
        }
        self.sizes = _sizes(instance)

    def estimate(self, readings: Array, theta: Array, covariance: Array) -> InitialEstimate:
        """Return the estimate from the readings of one sample, (c,), in which NaN is a missing reading.

        Parameters
        ----------
        readings : ndarray
            Readings in SI, (c,).
        theta, covariance : ndarray
            Free numbers and their covariance, (m,) and (m, m).
        """
        plan, n = self.plan, len(self._states)
        channels = [channel.address for channel in plan.channels]
        is_used = np.array([a in self.places for a in channels]) & np.isfinite(readings)
        effects = ordered_product(plan.effects, theta - plan.reference)
        p = self.p.copy()
        k = len(plan.free.places)
        p[plan.free.places] += ordered_product(plan.directions[:k], theta - plan.reference)
        rows = {channels[c]: c for c in np.flatnonzero(is_used).tolist()}
        for address, c in rows.items():
            p[self.places[address]] = readings[c] - effects[c]
        x = self._start(p)
        # Columns of the derivative of the estimate by independent errors.
        by_theta = np.vstack([np.zeros((n, theta.size)), np.eye(theta.size)])
        for j in range(theta.size):
            touched = p.copy()
            step = STEP * plan.prior[j]
            touched[plan.free.places] += plan.directions[:k, j] * step
            # An initial value that is measured does not follow a free number.
            for address in rows:
                touched[self.places[address]] = p[self.places[address]]
            by_theta[:n, j] = (self._start(touched) - x) / step
        columns = []
        for address, index in self.places.items():
            channel = rows.get(address)
            size = self.sizes[address] if channel is None else self._noise[channel]
            touched = p.copy()
            step = STEP * size
            touched[index] += step
            slope = (self._start(touched) - x) / step
            columns.append(slope * size)
            if channel is not None:
                by_theta[:n] -= np.outer(slope, plan.effects[channel])
        total = ordered_product(ordered_product(by_theta, covariance), by_theta.T)
        errors = np.array(columns).reshape(-1, n)
        total[:n, :n] += ordered_product(errors.T, errors)
        # No initial value determines these states.
        nominal = np.array([state.nominal for state in self._states])
        unknown = np.flatnonzero(~(np.diag(total)[:n] > (STEP * nominal) ** 2))
        total[unknown, unknown] += nominal[unknown] ** 2
        return InitialEstimate(np.append(x, theta), total, is_used)

    def _start(self, p: Array) -> Array:
        return self._kernel.start(p)[: len(self._states)]


def _sizes(instance: Instance) -> dict[str, float]:
    """Return the standard deviations of the initial values without a sensor, by the address of the output."""
    nominal = {state.name: state.nominal for state in instance.model.states}
    units = dict(instance.model.outputs)
    return {address: UNKNOWN.get(units.get(address, ""), nominal.get(address, 1.0)) for address in instance.initial}

"""Equations of a sampled circuit with constant inputs, and their derivatives.

They are the rates between sample instants, and the discrete states at sample instants.
"""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.newton import scaled_residual
from poppet.circuit.sampled.clock import find_clock
from poppet.engine.model_evaluation import ArrayFunction
from poppet.parts.part import NEVER

Array = NDArray[np.float64]

SIZES = {"Pa": 1e5, "K": 300.0, "m": 1e-3}
"""Typical size of a discrete state by its unit; 1 for other units."""


@dataclass(frozen=True, eq=False)
class IntersampleModel:
    """Rates and outputs between two sample instants, with their derivatives.

    The derivatives are taken with respect to the variables v = (x, w) of `SampledPoint`, and to the inputs u.
    """

    rates: Array
    outputs: Array
    rates_by_v: Array
    rates_by_u: Array
    outputs_by_v: Array
    outputs_by_u: Array


class SampledPoint:
    """Equations of a sampled circuit with constant inputs u.

    The variables are v = (x, w): x contains the states, w the discrete states except clocks (periodic timers).
    """

    def __init__(self, instance: Instance, u: Array) -> None:
        kernel = instance.kernel
        self.kernel, self.model, self.u = kernel, kernel.model, u
        self.input_names, self.numbers = instance.input_names, instance.numbers()
        self.full_start, p = instance.start()
        self.n = len(self.model.states)
        self.memory_start: Array = p[self.numbers.size :].copy()
        self.clock = find_clock(kernel, self.full_start, u if u.size else np.zeros(1), p)
        self.places = np.flatnonzero(~self.clock.counts)
        self.names = (
            *(state.name for state in self.model.states), *(self.model.memory[k][0] for k in self.places)
        )  # fmt: skip
        self.units = *(s.unit for s in self.model.states), *(self.model.memory[k][1] for k in self.places)
        self.start = np.concatenate([self.full_start[: self.n], self.memory_start[self.places]])
        self.positive = np.zeros(self.start.size, dtype=bool)
        self.positive[: self.n] = [state.positive for state in self.model.states]
        nominal = [s.nominal for s in self.model.states] + [SIZES.get(unit, 1.0) for unit in self.units[self.n :]]
        # As in `linear._LinearisationPoint`: only positive states have a typical initial value.
        self.size = np.where(self.positive, np.abs(self.start), np.array(nominal))
        self._between, self._instant = map(ArrayFunction, self.model.sampled_functions)
        # Without derivatives by clocks, which nothing changes.
        self._columns = np.concatenate([np.arange(self.n), self.n + self.places])
        self.every_clock: Array = np.zeros(self.model.n_timers)
        self.every_clock[: self.model.n_timers] = self.clock.counts[: self.model.n_timers]

    def p(self, v: Array) -> Array:
        """Return the parameter vector p: the parameters, followed by the discrete states.

        `v` contains the states and the discrete states except clocks. Clocks have their values at the time
        `clock.start`.
        """
        # A controller can treat its first sample differently.
        memory = self.clock.memory.copy()
        memory[self.places] = v[self.n :]
        return np.concatenate([self.numbers, memory])

    def at_clock(self, v: Array) -> tuple[Array, Array]:
        """Return state and parameter vector of a run that starts from v at the time `clock.start`.

        The state x includes the quadratures (integrals of flows).
        """
        return self._padded(v), self.p(v)

    def first(self) -> tuple[Array, Array]:
        """Return initial state and parameter vector of a run that starts at t = 0.

        The state x includes the quadratures (integrals of flows).
        """
        return self._padded(self.start), np.concatenate([self.numbers, self.memory_start])

    def all_discrete_states(self, v: Array) -> Array:
        """Return the values of all discrete states for the variables v.

        Clocks have their values at the start of a run.
        """
        memory = self.memory_start.copy()
        memory[self.places] = v[self.n :]
        return memory

    def v(self, x: Array, memory: Array) -> Array:
        """Return the variables v for states x and discrete states `memory`.

        `memory` contains all discrete states, including the clocks.
        """
        return np.concatenate([x[: self.n], memory[self.places]])

    def _padded(self, v: Array) -> Array:
        return np.concatenate([v[: self.n], np.zeros(self.model.n_quadratures)])

    def between(self, v: Array) -> IntersampleModel:
        """Return rates and outputs between two sample instants for the variables v, with derivatives."""
        f, y, fv, fu, yv, yu = self._between(0.0, self._padded(v), self.u, self.p(v))
        return IntersampleModel(f[:, 0], y[:, 0], fv[:, self._columns], fu, yv[:, self._columns], yu)

    def instant(self, v: Array, fired: Array) -> tuple[Array, Array, Array]:
        """Return the discrete states w after a sample instant for the variables v, with their derivatives.

        `fired` contains 1 for each timer that is due at this instant, and 0 for all others.
        """
        z, zv, zu = self._instant(0.0, self._padded(v), self.u, self.p(v), fired)
        return z[self.places, 0], zv[np.ix_(self.places, self._columns)], zu[self.places]

    def scaled(self, v: Array) -> tuple[Array, Array]:
        """Return the scaled rates of the variables v, and their Jacobian [1/s].

        Each variable is divided by its typical size in the results, but not in the argument v. The rate of a discrete
        state is its change over one sample, divided by the sample time.
        """
        b = self.between(v)
        w, wv, _ = self.instant(v, self.every_clock)
        sample = self.clock.sample_time
        change = np.concatenate([b.rates, (w - v[self.n :]) / sample])
        # The change over a sample is w+ - w.
        by_w = wv.copy()
        by_w[:, self.n :] -= np.eye(w.size)
        jacobian = np.vstack([b.rates_by_v, by_w / sample])
        return change / self.size, jacobian * self.size[None, :] / self.size[:, None]

    def scaled_by_u(self, v: Array) -> Array:
        """Return the derivatives of the scaled rates with respect to the inputs u, for the variables v."""
        _, _, by_u = self.instant(v, self.every_clock)
        return np.asarray(np.vstack([self.between(v).rates_by_u, by_u / self.clock.sample_time]) / self.size[:, None])

    def is_at_rest(self, v: Array) -> bool:
        """Return True if v is a steady state.

        This requires that states are constant between sample instants, that discrete states do not change at instants,
        and that no timer runs except the clocks.
        """
        residual, limit = scaled_residual(self.scaled, v, self.size)
        if not np.all(residual <= limit) or not self.is_idle(v):
            return False
        max_change = limit[self.n :] * self.size[self.n :] * self.clock.sample_time
        return all(
            bool(np.all(np.abs(self.instant(v, fired)[0] - v[self.n :]) <= max_change))
            for fired in np.unique(self.clock.fired, axis=0)
        )

    def is_idle(self, v: Array) -> bool:
        """Return True if no timer runs in v, except the clocks.

        A clock is a periodic timer, which triggers the samples.
        """
        timers = self.places < self.model.n_timers
        return bool(np.all(v[self.n :][timers] >= NEVER))

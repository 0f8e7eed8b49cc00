"""A circuit with memory and held inputs as a map: rates between instants, memory at them, and their derivatives."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.newton import residual_of
from poppet.circuit.sampled.clock import clock_of
from poppet.engine.model_evaluation import Evaluation
from poppet.parts.part import NEVER

Array = NDArray[np.float64]

SIZES = {"Pa": 1e5, "K": 300.0, "m": 1e-3}
"""Usual size of a remembered value by its unit; 1 for others."""


@dataclass(frozen=True, eq=False)
class IntersampleModel:
    """Rates and outputs between instants with their derivatives by v = (x, w) and by the inputs u."""

    rates: Array
    outputs: Array
    rates_by_v: Array
    rates_by_u: Array
    outputs_by_v: Array
    outputs_by_u: Array


class SampledPoint:
    """A circuit with memory whose inputs u are held.

    Its variables are v = (x, w): the states, and of the memory what is not a clock.
    """

    def __init__(self, instance: Instance, u: Array) -> None:
        kernel = instance.kernel
        self.kernel, self.model, self.u = kernel, kernel.model, u
        self.input_names, self.numbers = instance.input_names, instance.numbers()
        self.full_start, p = instance.start()
        self.n = len(self.model.states)
        self.memory_start: Array = p[self.numbers.size :].copy()
        self.clock = clock_of(kernel, self.full_start, self._inputs, p)
        self.places = np.flatnonzero(~self.clock.counts)
        self.names = (
            *(state.name for state in self.model.states), *(self.model.memory[k][0] for k in self.places)
        )  # fmt: skip
        self.units = *(s.unit for s in self.model.states), *(self.model.memory[k][1] for k in self.places)
        self.start = np.concatenate([self.full_start[: self.n], self.memory_start[self.places]])
        self.positive = np.zeros(self.start.size, dtype=bool)
        self.positive[: self.n] = [state.positive for state in self.model.states]
        nominal = [s.nominal for s in self.model.states] + [SIZES.get(unit, 1.0) for unit in self.units[self.n :]]
        # As in `linear._Point`: only what must stay positive has its size in its first value.
        self.size = np.where(self.positive, np.abs(self.start), np.array(nominal))
        self._between, self._instant = map(Evaluation, self.model.sampled_functions)
        # Derivatives by what the clocks hold are of no interest: nothing moves them.
        self._columns = np.concatenate([np.arange(self.n), self.n + self.places])
        self.every_clock: Array = np.zeros(self.model.n_timers)
        self.every_clock[: self.model.n_timers] = self.clock.counts[: self.model.n_timers]

    @property
    def _inputs(self) -> Array:
        return self.u if self.u.size else np.zeros(1)

    def p(self, v: Array) -> Array:
        """Numbers and memory, with clocks that have ticked a few times."""
        # A program may treat its very first sample otherwise: the clocks stand after some ticks.
        memory = self.clock.memory.copy()
        memory[self.places] = v[self.n :]
        return np.concatenate([self.numbers, memory])

    def at_clock(self, v: Array) -> tuple[Array, Array]:
        """State and (numbers, memory) from which a run begins at v, at the time `clock.start`."""
        return self._padded(v), self.p(v)

    def first(self) -> tuple[Array, Array]:
        """State and (numbers, memory) from which a run begins at time zero."""
        return self._padded(self.start), np.concatenate([self.numbers, self.memory_start])

    def remembered(self, v: Array) -> Array:
        """The whole memory, its clocks as at the start of a run."""
        memory = self.memory_start.copy()
        memory[self.places] = v[self.n :]
        return memory

    def v(self, x: Array, memory: Array) -> Array:
        """Variables from a state and a whole memory."""
        return np.concatenate([x[: self.n], memory[self.places]])

    def _padded(self, v: Array) -> Array:
        return np.concatenate([v[: self.n], np.zeros(self.model.n_quadratures)])

    def between(self, v: Array) -> IntersampleModel:
        """Rates and outputs at v."""
        f, y, fv, fu, yv, yu = self._between(0.0, self._padded(v), self.u, self.p(v))
        return IntersampleModel(f[:, 0], y[:, 0], fv[:, self._columns], fu, yv[:, self._columns], yu)

    def instant(self, v: Array, fired: Array) -> tuple[Array, Array, Array]:
        """What w becomes at an instant, and its derivatives by v and u."""
        z, zv, zu = self._instant(0.0, self._padded(v), self.u, self.p(v), fired)
        return z[self.places, 0], zv[np.ix_(self.places, self._columns)], zu[self.places]

    def scaled(self, v: Array) -> tuple[Array, Array]:
        """Rates of v per size [1/s], those of the memory being its change over a sample, and their Jacobian."""
        b = self.between(v)
        w, wv, _ = self.instant(v, self.every_clock)
        sample = self.clock.sample_time
        change = np.concatenate([b.rates, (w - v[self.n :]) / sample])
        # The change over a sample is w+ - w, so its derivative by w loses one.
        by_w = wv.copy()
        by_w[:, self.n :] -= np.eye(w.size)
        jacobian = np.vstack([b.rates_by_v, by_w / sample])
        return change / self.size, jacobian * self.size[None, :] / self.size[:, None]

    def scaled_by_u(self, v: Array) -> Array:
        """Derivatives of what `scaled` gives by the inputs."""
        _, _, by_u = self.instant(v, self.every_clock)
        return np.asarray(np.vstack([self.between(v).rates_by_u, by_u / self.clock.sample_time]) / self.size[:, None])

    def is_at_rest(self, v: Array) -> bool:
        """True when nothing changes any more, neither between instants nor at any of them."""
        residual, allowed = residual_of(self.scaled, v, self.size)
        if not np.all(residual <= allowed) or not self.waits(v):
            return False
        grant = allowed[self.n :] * self.size[self.n :] * self.clock.sample_time
        return all(
            bool(np.all(np.abs(self.instant(v, fired)[0] - v[self.n :]) <= grant))
            for fired in np.unique(self.clock.fired, axis=0)
        )

    def waits(self, v: Array) -> bool:
        """True when no timer but the clocks is under way."""
        timers = self.places < self.model.n_timers
        return bool(np.all(v[self.n :][timers] >= NEVER))

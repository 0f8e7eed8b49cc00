"""A circuit as plain functions of time and state, for any solver of differential equations."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from poppet.core.errors import InputError
from poppet.engine.problem import Problem
from poppet.engine.reference_solvers.track import Track, inputs_at, jacobian, rates, rounding, tolerances

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Stretch:
    """A part of a run in which no signal jumps and no memory changes.

    Parameters
    ----------
    begin, end : float
        Its ends [s].
    memory : (n_memory,) array
        Sampled memory in it, SI, to be given to the next stretch.
    """

    begin: float
    end: float
    memory: Array
    _problem: Problem
    _segment: int

    def f(self, t: float, x: Array) -> Array:
        """Rates.

        Parameters
        ----------
        t : float
            Time [s].
        x : (n,) array
            State, SI.

        Returns
        -------
        (n,) array
            SI per second.
        """
        return rates(self._problem, self._segment, t, self._whole(x))[: len(x)]

    def jac(self, t: float, x: Array) -> Array:
        """Exact derivatives of the rates by the states.

        Parameters
        ----------
        t : float
            Time [s].
        x : (n,) array
            State, SI.

        Returns
        -------
        (n, n) array
        """
        return jacobian(self._problem, self._segment, t, self._whole(x))[: len(x), : len(x)]

    def outputs(self, t: ArrayLike, x: Array) -> dict[str, Any]:
        """Outputs by their addresses.

        Parameters
        ----------
        t : float or (n_times,) array
            Time [s].
        x : (n,) or (n, n_times) array
            States, SI.

        Returns
        -------
        dict
            To a float or an (n_times,) array, SI.
        """
        times = np.atleast_1d(np.asarray(t, dtype=float))
        kernel = self._problem.kernel
        y = np.empty((times.size, len(kernel.model.outputs)))
        for row, time, state in zip(y, times, np.reshape(x, (len(x), times.size)).T, strict=True):
            u = inputs_at(self._problem, self._segment, time)
            kernel.call("outputs", np.array([time]), self._whole(state), u, self._problem.p, row)
        columns = y.T if np.ndim(t) else y[0]
        return dict(zip(kernel.model.columns[0], columns, strict=True))

    def _whole(self, x: Array) -> Array:
        """States with the quadratures behind them, on which nothing depends."""
        return np.concatenate([x, np.zeros(self._problem.x0.size - len(x))])


@dataclass(frozen=True, eq=False)
class Ode:
    r"""A circuit with its signals as :math:`\dot x = f(t, x)`, :math:`y = g(t, x)`.

    Parameters
    ----------
    x0 : (n,) array
        State at the start, SI.
    states : tuple of str
        Addresses, in the order of x.
    units : dict
        Address of every state and output to its SI unit.
    scale : (n,) array
        Absolute tolerance of each state per relative tolerance, SI: pressures and masses are ten decades apart, so that
        no single absolute tolerance serves them.
    breakpoints : (n_breakpoints,) array
        Times at which a signal jumps or has a kink, 0 among them [s].
    end : float
        Time up to which the signals hold [s].
    memory : tuple of str
        Addresses of the sampled memory; empty where nothing is sampled or switched.

    Notes
    -----
    At a breakpoint `f` is that of the time after it. A solver that steps over one loses digits; who wants them all
    integrates from stretch to stretch, as one must with sampled memory.

    Examples
    --------
    >>> from scipy.integrate import solve_ivp
    >>> from poppet import Chamber, Circuit, Orifice
    >>> tank = Chamber(volume="1 l", initial_pressure="3 bar", wall_conductance=1.0)
    >>> vent = Orifice(from_="tank", to="ambient", sonic_conductance=1e-8, critical_ratio=0.3)
    >>> ode = Circuit({"tank": tank, "vent": vent}).to_ode("2 s")
    >>> run = solve_ivp(ode.f, (0.0, ode.end), ode.x0, "BDF", jac=ode.jac, rtol=1e-8, atol=1e-8 * ode.scale)
    >>> round(1e-5 * float(ode.outputs(run.t, run.y)["tank.pressure"][-1]), 2)
    1.0
    """

    x0: Array
    states: tuple[str, ...]
    units: Mapping[str, str]
    scale: Array
    breakpoints: Array
    end: float
    memory: tuple[str, ...]
    _problem: Problem

    def f(self, t: float, x: Array) -> Array:
        """Rates of a circuit without sampled memory; as `Stretch.f`.

        Raises
        ------
        InputError
            If the circuit has sampled memory, which changes at instants: they end a stretch.
        """
        return self._at(t).f(t, x)

    def jac(self, t: float, x: Array) -> Array:
        """Exact derivatives of `f` by the states; as `Stretch.jac`."""
        return self._at(t).jac(t, x)

    def outputs(self, t: ArrayLike, x: Array) -> dict[str, Any]:
        """Outputs by their addresses; as `Stretch.outputs`, with the signals of each time."""
        if not np.ndim(t):
            time = float(np.asarray(t))
            return self._at(time).outputs(time, x)
        rows = [self.outputs(each, state) for each, state in zip(np.asarray(t, dtype=float), x.T, strict=True)]
        return {name: np.array([row[name] for row in rows]) for name in self._problem.kernel.model.columns[0]}

    def stretch(self, t: float, x: Array, memory: Array | None = None) -> Stretch:
        """What follows a time, up to where a signal jumps or the memory changes next.

        Parameters
        ----------
        t : float
            Where the last stretch ended, or 0 [s].
        x : (n,) array
            State there, SI.
        memory : (n_memory,) array, optional
            That of the last stretch; default the one at the start.

        Returns
        -------
        Stretch
            In which instants at `t` have acted already.
        """
        p, n = self._problem.p.copy(), self._problem.p.size - len(self.memory)
        if memory is not None:
            p[n:] = memory
        track = Track(replace(self._problem, p=p))
        track.x = np.concatenate([x, np.zeros(track.x.size - len(x))])
        segment = self._segment(t + rounding(t))
        track.enter(segment, t)
        ends = np.append(self.breakpoints[1:], self.end)
        return Stretch(t, track.next_instant(float(ends[segment])), p[n:], track.problem, segment)

    def _segment(self, t: float) -> int:
        return max(int(np.searchsorted(self.breakpoints, t, side="right")) - 1, 0)

    def _at(self, t: float) -> Stretch:
        if self.memory:
            raise InputError("tools.has_instants", self.memory[0])
        return Stretch(t, t, np.empty(0), self._problem, self._segment(t))


def to_ode(circuit: Circuit, duration: Any = None) -> Ode:
    """A circuit as plain functions of time and state: `Circuit.to_ode`."""
    instance = circuit.instance
    problem = instance.problem(circuit.run.changed(duration=duration))
    model = instance.model
    names, units = model.columns
    states = tuple(state.name for state in model.states)
    return Ode(
        problem.x0[: len(states)].copy(), states,
        dict(zip(names, units, strict=True)) | {state.name: state.unit for state in model.states},
        tolerances(problem), problem.starts, float(problem.grid[-1]), tuple(name for name, _ in model.memory), problem,
    )  # fmt: skip

"""Export of a circuit as functions of time and state, for any solver of differential equations."""

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
    from poppet.circuit.circuit import BaseCircuit

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Stretch:
    """Time interval in which no signal jumps and no discrete state changes.

    Parameters
    ----------
    begin, end : float
        Limits of the interval [s].
    memory : (n_memory,) array
        Discrete states, SI; the argument `memory` of the next interval.
    """

    begin: float
    end: float
    memory: Array
    _problem: Problem
    _segment: int

    def f(self, t: float, x: Array) -> Array:
        """Return the rates of change of the states.

        Parameters
        ----------
        t : float
            Time [s].
        x : (n,) array
            State, SI.

        Returns
        -------
        (n,) array
            Rates, SI per second.
        """
        return rates(self._problem, self._segment, t, self._with_quadratures(x))[: len(x)]

    def jac(self, t: float, x: Array) -> Array:
        """Return the Jacobian of the rates by the states.

        Parameters
        ----------
        t : float
            Time [s].
        x : (n,) array
            State, SI.

        Returns
        -------
        (n, n) array
            Derivatives; the row is the index of the rate.
        """
        return jacobian(self._problem, self._segment, t, self._with_quadratures(x))[: len(x), : len(x)]

    def outputs(self, t: ArrayLike, x: Array) -> dict[str, Any]:
        """Return the outputs by address.

        Parameters
        ----------
        t : float or (n_times,) array
            Time [s].
        x : (n,) or (n, n_times) array
            States, SI.

        Returns
        -------
        dict
            Float or (n_times,) array of each output by address, SI.
        """
        times = np.atleast_1d(np.asarray(t, dtype=float))
        kernel = self._problem.kernel
        y = np.empty((times.size, len(kernel.model.outputs)))
        for row, time, state in zip(y, times, np.reshape(x, (len(x), times.size)).T, strict=True):
            u = inputs_at(self._problem, self._segment, time)
            kernel.call("outputs", np.array([time]), self._with_quadratures(state), u, self._problem.p, row)
        columns = y.T if np.ndim(t) else y[0]
        return dict(zip(kernel.model.columns[0], columns, strict=True))

    def _with_quadratures(self, x: Array) -> Array:
        """Return the states, followed by zeros for the quadratures.

        Quadratures are integrals of flows, on which no rate depends.
        """
        return np.concatenate([x, np.zeros(self._problem.x0.size - len(x))])


@dataclass(frozen=True, eq=False)
class Ode:
    r"""Circuit with its signals as :math:`\dot x = f(t, x)`, :math:`y = g(t, x)`.

    Parameters
    ----------
    x0 : (n,) array
        State at the start, SI.
    states : tuple of str
        Addresses of the states, in the order of x.
    units : dict
        SI unit of each state and output by address.
    scale : (n,) array
        Ratio of the absolute tolerance of each state to the relative tolerance, SI. Pressures and masses differ by ten
        decades: no single absolute tolerance suits both.
    breakpoints : (n_breakpoints,) array
        Times at which a signal jumps or has a kink, including 0 [s].
    end : float
        End of the signals [s].
    memory : tuple of str
        Addresses of the discrete states; empty if the circuit has no sampled or switched part.

    Notes
    -----
    At a breakpoint, `f` uses the signal after it. A step across a breakpoint is less accurate. For full accuracy,
    integrate each interval of `stretch` separately. A circuit with discrete states requires this.

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
        """Return the rates of a circuit without discrete states.

        The method `Stretch.f` describes the arguments.

        Raises
        ------
        InputError
            If the circuit has discrete states, which change at sample instants: use `stretch`.
        """
        return self._at(t).f(t, x)

    def jac(self, t: float, x: Array) -> Array:
        """Return the Jacobian of `f` by the states.

        The method `Stretch.jac` describes the arguments.
        """
        return self._at(t).jac(t, x)

    def outputs(self, t: ArrayLike, x: Array) -> dict[str, Any]:
        """Return the outputs by address.

        The method `Stretch.outputs` describes the arguments. The signals are evaluated at each time.
        """
        if not np.ndim(t):
            time = float(np.asarray(t))
            return self._at(time).outputs(time, x)
        rows = [self.outputs(time, state) for time, state in zip(np.asarray(t, dtype=float), x.T, strict=True)]
        return {name: np.array([row[name] for row in rows]) for name in self._problem.kernel.model.columns[0]}

    def stretch(self, t: float, x: Array, memory: Array | None = None) -> Stretch:
        """Return the interval from `t` to the next discontinuity.

        A discontinuity is a jump or kink of a signal, or a change of a discrete state.

        Parameters
        ----------
        t : float
            End of the last interval, or 0 [s].
        x : (n,) array
            State at that time, SI.
        memory : (n_memory,) array, optional
            Discrete states of the last interval (default: those at the start).

        Returns
        -------
        Stretch
            Interval with the discrete states after `t`.
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


def to_ode(circuit: BaseCircuit, duration: Any = None) -> Ode:
    """Return a circuit as functions of time and state.

    The public method `Circuit.to_ode` describes the arguments.
    """
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

"""Progress of a run with a reference solver: rows, extremes, stop conditions, sample instants."""

from __future__ import annotations

from collections.abc import Callable
from typing import NamedTuple

import numpy as np

from poppet.engine.problem import Array, Outcome, Problem, RawRun

BISECTIONS = 60


class Leg(NamedTuple):
    """Solution over one time interval.

    It contains the ends of the interval [s], the states at both ends, and a function for the state between them.
    """

    begin: float
    end: float
    x0: Array
    x1: Array
    between: Callable[[float], Array]

    def at(self, t: float) -> Array:
        """Return the state at the time t [s], which must be within the integration step of this object."""
        if t in (self.begin, self.end):
            return self.x0 if t == self.begin else self.x1
        return np.ascontiguousarray(self.between(t))


def rounding(t: float) -> float:
    """Return the difference below which two times near t count as equal [s].

    The compiled integrator uses the same difference.
    """
    return 1e-14 * t + 1e-15


class Track:
    """Time, state and output rows of a run with a reference solver.

    The run changes the discrete states in p, so the problem must have its own copy of p.
    """

    def __init__(self, problem: Problem) -> None:
        self.problem, self.model = problem, problem.kernel.model
        self.segment, self.t, self.stop = 0, float(problem.starts[0]), -1
        self.x = problem.x0.copy()
        self.extremes, self.through = np.array([self.x, self.x]), np.zeros(self.x.size)
        self.times: list[float] = []
        self.rows: list[Array] = []
        self.positive = np.array([state.positive for state in self.model.states], dtype=bool)
        self.memory = problem.p[len(self.model.parameters) :]
        self.timers = self.memory[: self.model.n_timers]

    def has_finite_rates(self) -> bool:
        """Return True if the rates at the start are finite."""
        return bool(np.all(np.isfinite(rates(self.problem, 0, self.t, self.x))))

    def is_valid(self, x: Array) -> bool:
        """Return True if the state x is finite and physically possible.

        Elements such as pressures and masses must be positive.
        """
        return bool(np.all(np.isfinite(x))) and bool(np.all(x[: self.positive.size][self.positive] > 0.0))

    def enter(self, segment: int, begin: float) -> None:
        """Begin a segment of the inputs at the time `begin`, and evaluate the stop conditions."""
        self.segment, self.t = segment, begin
        self.act()
        self.stop = self._condition(self.t, self.x)

    def next_instant(self, end: float) -> float:
        """Return the time of the next sample instant [s].

        The result is the end of the segment if there is no earlier instant.
        """
        first = float(self.timers.min(initial=np.inf))
        return first if first < end - rounding(end) else end

    def act(self) -> None:
        """Execute all timers that are due; they change the discrete states."""
        due = self.t + rounding(self.t)
        # A timer can set another timer to the current time, for example a clock that switches a solenoid.
        while np.any(fired := self.timers <= due):
            u, updated = inputs_at(self.problem, self.segment, self.t), np.empty_like(self.memory)
            arrays = np.array([self.t]), self.x, u, self.problem.p, fired.astype(np.float64), updated
            self.problem.kernel.call("update", *arrays)
            self.memory[:] = updated

    def take(self, leg: Leg, fractions: tuple[float, ...]) -> None:
        """Accept a leg and write its output rows, up to the first true stop condition.

        Without a stop, the rows up to the end of the leg are written. Stop conditions are evaluated at the given
        fractions of the leg.
        """
        end, x1 = leg.end, leg.x1
        for fraction in fractions if self.problem.stop_conditions else ():
            t = leg.end if fraction == 1.0 else leg.begin + fraction * (leg.end - leg.begin)
            self.stop = self._condition(t, leg.at(t))
            if self.stop >= 0:
                # The condition becomes true between `low` and `t`, which become adjacent doubles.
                low = leg.begin
                for _ in range(BISECTIONS):
                    middle = 0.5 * (low + t)
                    if not low < middle < t:
                        break
                    low, t = (low, middle) if self._condition(middle, leg.at(middle)) >= 0 else (middle, t)
                end, x1 = t, leg.at(t)
                break
        grid, limit = self.problem.grid, end - rounding(end)
        while len(self.times) < grid.size and grid[len(self.times)] < limit:
            t = float(grid[len(self.times)])
            self._write(t, leg.at(max(t, leg.begin)))
        self.through += np.abs(x1 - self.x)
        self.t, self.x = end, x1.copy()
        self.extremes = np.array([np.minimum(self.extremes[0], x1), np.maximum(self.extremes[1], x1)])

    def result(self, outcome: Outcome, steps: tuple[int, int] = (0, 0)) -> RawRun:
        """Return the result of the run.

        A successful run has an additional output row at its end. `steps` contains the numbers of accepted and rejected
        steps.
        """
        if outcome.is_success:
            self._write(self.t, self.x)
        # An interruption can separate a row from its time.
        values = np.array(self.rows[: len(self.times)]).reshape(len(self.times), len(self.model.outputs)).T
        rows = np.array(self.times), np.ascontiguousarray(values)
        return RawRun(outcome, *rows, self.x, self.extremes, self.through, *steps, self.stop)

    def _write(self, t: float, x: Array) -> None:
        self.rows.append(self._outputs(t, x))
        self.times.append(t)

    def _outputs(self, t: float, x: Array) -> Array:
        y = np.empty(len(self.model.outputs))
        u = inputs_at(self.problem, self.segment, t)
        self.problem.kernel.call("outputs", np.array([t]), x, u, self.problem.p, y)
        return y

    def _condition(self, t: float, x: Array) -> int:
        """Return the index of the first stop condition that is true at the time t and the state x, or -1."""
        if not self.problem.stop_conditions:
            return -1
        y = self._outputs(t, x)
        for k, condition in enumerate(self.problem.stop_conditions):
            pairs = zip(condition.places, condition.weights[:2], strict=True)
            if sum(weight * y[index] for index, weight in pairs if index >= 0) + condition.weights[2] > 0.0:
                return k
        return -1


def inputs_at(problem: Problem, segment: int, t: float) -> Array:
    """Return the inputs at the time t, which is in a given segment.

    `segment` is the index of the segment. `poppet.timeseries.segments.SegmentTable` contains the formula.
    """
    value, slope, amplitude, frequency, chirp_rate, phase, origin = problem.coefficients[problem.courses[segment]].T
    tau = t - origin
    wave = amplitude * np.sin(2.0 * np.pi * np.remainder((frequency + 0.5 * chirp_rate * tau) * tau, 1.0) + phase)
    u: Array = value + slope * tau + wave
    return u


def rates(problem: Problem, segment: int, t: float, x: Array) -> Array:
    """Return the rates of all states at the time t and the state x.

    `segment` is the index of the segment of the inputs. Quadratures are included.
    """
    f = np.empty(x.size)
    u = inputs_at(problem, segment, t)
    problem.kernel.call("rates", np.array([t]), np.ascontiguousarray(x), u, problem.p, f)
    return f


def jacobian(problem: Problem, segment: int, t: float, x: Array) -> Array:
    """Return the derivatives of the rates with respect to the states as a dense matrix.

    The derivatives are evaluated at the time `t` and the state `x`. `segment` is the index of the input segment.
    """
    f, drift, entries = np.empty(x.size), np.empty(x.size), np.empty(problem.kernel.jacobian_size)
    u = inputs_at(problem, segment, t)
    arrays = np.array([t]), np.ascontiguousarray(x), u, np.zeros(u.size), problem.p, f, entries, drift
    problem.kernel.call("jacobian", *arrays)
    matrix = np.zeros((x.size, x.size))
    matrix[problem.kernel.pattern] = entries
    return matrix


def tolerances(problem: Problem) -> Array:
    """Return the absolute tolerance of each controlled state per relative tolerance.

    The compiled integrator uses the same values.
    """
    _, floor, nominal = problem.kernel.scales
    initial = np.abs(problem.x0[: nominal.size])
    size: Array = floor * np.where(problem.kernel.positive & (initial > 0.0), initial, nominal)
    return size

"""Reference solvers: CVODES of SUNDIALS, and LSODA, BDF and Radau of SciPy.

They share only the model with the Rosenbrock kernel; CVODES uses the traced expressions in place of the machine code.
They check results (`solver=`) and repeat runs on which the kernel stalls. They are not optimised for speed.

A solver returns its solution in *legs*. One loop converts them to rows, extremes and stop conditions with the rules of
the kernel: restart at each segment and sample instant; a row at a jump or instant shows the value after it; the last
row is at the end.
"""

from __future__ import annotations

import warnings
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any, TypeVar

import numpy as np

from poppet.engine.problem import Array, Outcome, Problem, RawRun
from poppet.engine.reference_solvers.track import Leg, Track, jacobian, rates, rounding, tolerances

_T = TypeVar("_T")

SOLVERS: tuple[str, ...] = ("cvodes", "lsoda", "bdf", "radau")

STRICTER = 0.1
"""Factor on the requested relative tolerance, because errors of steps add up."""
TIGHTEST = 1e-13
"""Tightest relative tolerance that double precision and SciPy permit."""
QUADRATURE_SIZE = 1e30
"""Size of quadratures, which excludes them from error control; Newton's method still computes them for the balances."""
ROWS = 64
"""Intervals of a CVODES call; missing intervals have zero length. With discrete states, a call has one interval."""
HALVINGS = 40
MAX_STEPS = 1_000_000
"""Maximum number of steps of a run with SciPy, and of CVODES between two rows: minutes."""
STEPS_AFTER_INSTANT = 100
"""Additional steps per sample instant: a restart needs ten to forty."""


def solve_with_reference(problem: Problem, solver: str, progress: Callable[[float], Any] | None = None) -> RawRun:
    """Run a problem with one of the reference solvers `SOLVERS`.

    `progress` is called with the time reached [s]. If it is given, Ctrl-C ends the run with a partial result.

    Notes
    -----
    The relative tolerance is a tenth of the requested tolerance for all states, including mechanics. CVODES evaluates
    stop conditions and extremes at rows; the other solvers evaluate them at steps, and stop conditions also in the
    middle of steps.
    """
    # The discrete state in p changes during the run.
    problem = replace(problem, p=problem.p.copy())
    track = Track(problem)
    if not track.has_finite_rates():
        return track.result(Outcome.NOT_FINITE)
    legs: _Legs
    if problem.x0.size == 0:
        legs = _StatelessLegs(problem)
    else:
        legs = _Cvodes(problem) if solver == "cvodes" else _Scipy(problem, solver)
    fractions = (1.0,) if solver == "cvodes" else (0.5, 1.0)
    if progress is not None:
        legs.check = lambda: progress(track.t)
    try:
        outcome = _run_segments(track, legs, fractions)
    except KeyboardInterrupt:
        if progress is None:
            raise
        outcome = Outcome.INTERRUPTED
    return track.result(outcome, (legs.accepted, legs.rejected))


class _Legs(ABC):
    """Base class of reference solvers, which yield the solution in pieces (legs).

    A leg is the solution over one time interval. If the legs end before the end of a segment, the solver has failed.
    """

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.accepted, self.rejected, self.failure = 0, 0, Outcome.STALLED
        # A step costs many times more than an attempt of the kernel.
        self.max_steps = min(problem.most_attempts, MAX_STEPS)
        self.rtol = max(STRICTER * problem.relative_tolerance, TIGHTEST)
        sizes = tolerances(problem)
        # In units of `scale`, each state has the absolute tolerance `rtol`.
        self.scale = np.concatenate([sizes, np.full(problem.x0.size - sizes.size, QUADRATURE_SIZE)])
        # Function that can interrupt the run; called often.
        self.check: Callable[[], Any] = lambda: None

    @abstractmethod
    def over(self, segment: int, begin: float, end: float, x: Array) -> Iterator[Leg]:
        """Yield the solution between two times of one segment of the inputs, in successive legs.

        `segment` is the index of the segment. x is the state at the time `begin`, and `end` is the last time [s].
        """

    def has_too_many_steps(self) -> bool:
        """Return True if the solver has used the maximum number of steps."""
        if self.accepted + self.rejected >= self.max_steps:
            self.failure = Outcome.TOO_MANY
        return self.failure is Outcome.TOO_MANY

    def _row_times(self, begin: float, end: float) -> Array:
        """Return the output times between `begin` and `end` [s], including both ends."""
        grid = self.problem.grid
        is_between = (grid > begin + rounding(begin)) & (grid < end - rounding(end))
        return np.concatenate([[begin], grid[is_between], [end]])


def _run_segments(track: Track, legs: _Legs, fractions: tuple[float, ...]) -> Outcome:
    """Run a solver through all segments of the inputs.

    The solver `legs` stops at each sample instant, and `track` stores the results. Stop conditions are evaluated at the
    given fractions of each leg.
    """
    starts, last = track.problem.starts, track.problem.grid[-1]
    for segment, (begin, end) in enumerate(zip(starts, np.append(starts[1:], last), strict=True)):
        track.enter(segment, float(begin))
        while track.stop < 0 and track.t < end:
            if legs.has_too_many_steps():
                return legs.failure
            target = track.next_instant(float(end))
            for leg in legs.over(segment, track.t, target, track.x):
                if not track.is_valid(leg.x1):
                    return Outcome.STALLED
                track.take(leg, fractions)
                legs.check()
                if track.stop >= 0:
                    return Outcome.STOPPED
            if track.t < target:
                return legs.failure
            if track.t < end:
                track.act()
                # Each restart begins with tiny steps, which must not count against the limit of a run.
                legs.max_steps = min(track.problem.most_attempts, legs.max_steps + STEPS_AFTER_INSTANT)
        if track.stop >= 0:
            return Outcome.STOPPED
    return Outcome.DONE


class _StatelessLegs(_Legs):
    """Reference solver for circuits without states, with one leg for each output time."""

    def over(self, segment: int, begin: float, end: float, x: Array) -> Iterator[Leg]:
        for first, last in pairwise(self._row_times(begin, end).tolist()):
            yield Leg(first, last, x, x, lambda _: x)


class _Scipy(_Legs):
    """Reference solver LSODA, BDF or Radau of SciPy.

    It yields one leg (piece of the solution) per step.
    """

    def __init__(self, problem: Problem, solver: str) -> None:
        from scipy.integrate import BDF, LSODA, Radau

        super().__init__(problem)
        self.solver = {"lsoda": LSODA, "bdf": BDF, "radau": Radau}[solver]
        # The interpolant of Radau has order 3, its steps order 5: the steps end at the rows.
        self.lands_on_rows = solver == "radau"

    def over(self, segment: int, begin: float, end: float, x: Array) -> Iterator[Leg]:
        method = self._quietly(
            lambda: self.solver(
                partial(rates, self.problem, segment), begin, x, end,
                rtol=self.rtol, atol=self.rtol * self.scale, max_step=self.problem.maximum_step,
                jac=partial(jacobian, self.problem, segment),
            )
        )  # fmt: skip
        if method is None:
            return
        for target in self._row_times(begin, end)[1:] if self.lands_on_rows else (end,):
            # The method keeps its history; a new one for each row would start with tiny steps.
            method.t_bound, method.status = float(target), "running"
            while method.status == "running":
                t0, x0 = method.t, method.y.copy()
                self._quietly(method.step)
                # Some methods fail with a step of zero length and no error.
                if method.status == "failed" or method.t == t0:
                    return
                self.accepted += 1
                yield Leg(float(t0), float(method.t), x0, method.y.copy(), method.dense_output())
                if method.status == "running" and self.has_too_many_steps():
                    return

    @staticmethod
    def _quietly(work: Callable[[], _T]) -> _T | None:
        """Call the function `work` without warnings of the solver, and return its result.

        The result is None after a numerical error.
        """
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            try:
                return work()
            except (ValueError, ArithmeticError, np.linalg.LinAlgError):
                return None


class _Cvodes(_Legs):
    """Solver CVODES with the traced expressions, with one leg per output time.

    One compiled CasADi integrator runs all segments; the coefficients of the inputs are its parameters. One unit of its
    time tau is the interval between two output times: ``t = start + offset + length * tau``. Offset and length are
    inputs of the integrator. Their changes restart CVODES, so they are constant if the output times are equidistant.
    """

    def __init__(self, problem: Problem) -> None:
        import casadi as ca

        super().__init__(problem)
        self.rows = 1 if problem.kernel.model.memory else ROWS

        model, symbols = problem.kernel.model, problem.kernel.model.symbols
        n_u = symbols["u"].shape[0]
        z, warp, tau, start = ca.SX.sym("z", model.size), ca.SX.sym("warp", 2), ca.SX.sym("tau"), ca.SX.sym("start")
        scale, c = ca.SX.sym("scale", model.size), ca.SX.sym("c", n_u, 7)
        since = warp[0] + warp[1] * tau
        elapsed = since + c[:, 6]
        phase = 2.0 * np.pi * (c[:, 3] + 0.5 * c[:, 4] * elapsed) * elapsed + c[:, 5]
        u = c[:, 0] + c[:, 1] * elapsed + c[:, 2] * ca.sin(phase)
        arguments = [symbols[name] for name in ("t", "x", "u", "p")]
        traced = ca.Function("rates", arguments, [model.expressions["rates"]])
        ode = warp[1] * traced(start + since, z * scale, u, symbols["p"]) / scale
        parameters = ca.veccat(symbols["p"], start, scale, c)
        dae = {"x": z, "t": tau, "u": warp, "p": parameters, "ode": ode}
        options: dict[str, Any] = {
            "reltol": self.rtol, "abstol": self.rtol, "linear_solver": "csparse", "max_num_steps": self.max_steps,
            "disable_internal_warnings": True, "show_eval_warnings": False,
        }  # fmt: skip
        if np.isfinite(problem.maximum_step):
            longest = np.diff(problem.grid).max(initial=problem.grid[0])
            options["max_step_size"] = problem.maximum_step / longest
        ends = np.arange(1.0, self.rows + 1.0).tolist()
        self.integrator = ca.integrator("cross_check", "cvodes", dae, 0.0, ends, options)

    def over(self, segment: int, begin: float, end: float, x: Array) -> Iterator[Leg]:
        stops = self._row_times(begin, end)
        parts = [stops[first : first + self.rows + 1] for first in range(0, stops.size - 1, self.rows)]
        yield from self._chain(segment, parts, x)

    def _chain(self, segment: int, parts: Sequence[Array], x: Array) -> Iterator[Leg]:
        """Yield the solution over several groups of intervals, until the solver fails.

        x is the state at the start. Each element of `parts` contains the start of the first interval of a group, and
        the ends of all its intervals [s].
        """
        for stops in parts:
            reached = stops[0]
            for leg in self._legs(segment, stops, x):
                x, reached = leg.x1, leg.end
                yield leg
                if self.has_too_many_steps():
                    return
            if reached < stops[-1]:
                return

    def _legs(self, segment: int, stops: Array, x: Array) -> Iterator[Leg]:
        """Yield the solution over successive intervals, which one call of CVODES integrates.

        x is the state at the start. `stops` contains the start of the first interval and the ends of all intervals [s].
        If the call fails, its intervals are divided into two calls.
        """
        if stops.size == 2:
            state = self._state(segment, float(stops[0]), x, float(stops[1]))
            states = None if state is None else [state]
        else:
            states = self._states(segment, stops, x)
        if states is None:
            half = stops.size // 2
            yield from self._chain(segment, (stops[: half + 1], stops[half:]) if stops.size > 2 else (), x)
            return
        for begin, end, x1 in zip(stops[:-1].tolist(), stops[1:].tolist(), states, strict=True):
            yield Leg(begin, end, x, x1, partial(self._between, segment, begin, x))
            x = x1

    def _state(self, segment: int, begin: float, x: Array, end: float, halvings: int = HALVINGS) -> Array | None:
        """Return the state at the end of one interval, which begins with the state x.

        The interval is the time from `begin` to `end`. If CVODES fails in it, for example at a kink, the interval is
        divided in half, at most `halvings` times in succession.
        """
        states = self._states(segment, np.array([begin, end]), x)
        if states is not None:
            return states[0]
        middle = 0.5 * (begin + end)
        if not halvings or not begin < middle < end or self.failure is Outcome.TOO_MANY:
            return None
        halfway = self._state(segment, begin, x, middle, halvings - 1)
        return None if halfway is None else self._state(segment, middle, halfway, end, halvings - 1)

    def _between(self, segment: int, begin: float, x: Array, t: float) -> Array:
        state = self._state(segment, begin, x, t)
        return np.full(x.size, np.nan) if state is None else state

    def _states(self, segment: int, stops: Array, x: Array) -> list[Array] | None:
        """Return the states at the ends of several intervals.

        x is the state at the start. `stops` contains the start of the first interval and the ends of all intervals. The
        result is None if CVODES fails.
        """
        self.check()
        start, n_u = self.problem.starts[segment], len(self.problem.kernel.model.inputs)
        coefficients = self.problem.coefficients[self.problem.courses[segment], :n_u].T.copy()
        coefficients[6] = start - coefficients[6]
        p = np.concatenate([self.problem.p, [start], self.scale, coefficients.ravel()])
        # Offset and length of each interval, (2, rows). Both are constant for equidistant rows: CasADi restarts CVODES
        # after a change.
        times, warp = stops - start, np.zeros((2, self.rows))
        lengths = np.diff(times)
        groups = np.cumsum(np.abs(np.diff(lengths, prepend=lengths[0])) > 1e-9 * lengths)
        for group in np.unique(groups):
            indices = np.flatnonzero(groups == group)
            first, last = indices[0], indices[-1] + 1
            length = (times[last] - times[first]) / indices.size
            warp[:, indices] = np.array([[times[first] - length * first], [length]])
        try:
            states = self.integrator(x0=x / self.scale, p=p, u=warp)["xf"].full()
        except RuntimeError as error:
            # Only the text of the error contains the reason.
            if "TOO_MUCH_WORK" in str(error):
                self.failure = Outcome.TOO_MANY
            return None
        statistics = self.integrator.stats()
        self.accepted += int(statistics["nsteps"])
        self.rejected += int(statistics["netfails"])
        return [np.ascontiguousarray(z * self.scale) for z in states.T[: stops.size - 1]]

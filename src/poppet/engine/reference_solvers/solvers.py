"""Independent solvers for the same compiled problem: CVODES of SUNDIALS, and LSODA, BDF and Radau of SciPy.

They share the model with the Rosenbrock kernel and nothing else: CVODES even works on the traced expressions, not on
the machine code. They check results (`solver=`) and take over a run on which the kernel stalls. Speed is no aim here.

A solver hands over its solution in *legs*; one loop turns them into rows, extremes and stop conditions as the kernel
does: restart at every segment and at every instant of the memory, a row on a jump or an instant shows the value after
it, a last row at the end always.
"""

from __future__ import annotations

import warnings
from abc import ABC, abstractmethod
from collections.abc import Callable, Iterator, Sequence
from dataclasses import replace
from functools import partial
from itertools import pairwise
from typing import Any

import numpy as np
from numpy.typing import NDArray

from poppet.engine.problem import Outcome, Problem, RawRun
from poppet.engine.reference_solvers.track import Leg, Track, jacobian, rates, rounding, tolerances

Array = NDArray[np.float64]

SOLVERS: tuple[str, ...] = ("cvodes", "lsoda", "bdf", "radau")

STRICTER = 0.1
"""Relative tolerance of these solvers per unit of the one asked for: the errors of their steps add up."""
TIGHTEST = 1e-13
"""Below it double precision leaves the solvers no room, and SciPy refuses."""
UNWATCHED = 1e30
"""Size given to quadratures: the error control does not see them, but Newton's method carries them along, so that the
conservation residuals hold."""
ROWS = 64
"""Stretches of a CVODES call; fewer are padded with stretches of no length. With memory a call has one."""
HALVINGS = 40
MOST_STEPS = 1_000_000
"""Steps of a whole run with SciPy, and of CVODES between two rows: minutes."""
STEPS_AFTER_INSTANT = 100
"""Added for every instant: a start takes ten to forty."""


def solve_with_reference(problem: Problem, solver: str, progress: Callable[[float], Any] | None = None) -> RawRun:
    """Run a problem with one of `SOLVERS`.

    Notes
    -----
    The relative tolerance is a tenth of the one asked for, for all states alike, mechanics included. CVODES looks at
    stop conditions and extremes at rows only, the others at steps (at stop conditions in their middle as well).
    """
    # The memory behind the numbers changes during the run.
    problem = replace(problem, p=problem.p.copy())
    track = Track(problem)
    if not track.has_finite_rates():
        return track.result(Outcome.NOT_FINITE)
    legs: _Legs
    if problem.x0.size == 0:
        legs = _StatelessLegs(problem)
    else:
        legs = _Cvodes(problem) if solver == "cvodes" else _Scipy(problem, solver)
    watched = (1.0,) if solver == "cvodes" else (0.5, 1.0)
    outcome = _follow(track, legs, watched, progress)
    return track.result(outcome, (legs.accepted, legs.rejected))


class _Legs(ABC):
    """What the solvers share. Legs that end before their segment mean that the solver failed."""

    def __init__(self, problem: Problem) -> None:
        self.problem = problem
        self.accepted, self.rejected, self.failure = 0, 0, Outcome.STALLED
        # The kernel may take twenty million attempts; here a step costs many times as much.
        self.most = min(problem.most_attempts, MOST_STEPS)
        self.rtol = max(STRICTER * problem.relative_tolerance, TIGHTEST)
        sizes = tolerances(problem)
        # In units of `scale` every state has the absolute tolerance `rtol`.
        self.scale = np.concatenate([sizes, np.full(problem.x0.size - sizes.size, UNWATCHED)])

    @abstractmethod
    def over(self, segment: int, begin: float, end: float, x: Array) -> Iterator[Leg]:
        """Legs of one segment, from state x on."""

    def is_spent(self) -> bool:
        """True when the steps allowed are used up."""
        if self.accepted + self.rejected >= self.most:
            self.failure = Outcome.TOO_MANY
        return self.failure is Outcome.TOO_MANY

    def _stops_at(self, begin: float, end: float) -> Array:
        """The ends of a stretch and the rows between."""
        grid = self.problem.grid
        between = (grid > begin + rounding(begin)) & (grid < end - rounding(end))
        return np.concatenate([[begin], grid[between], [end]])


def _follow(track: Track, legs: _Legs, watched: tuple[float, ...], progress: Callable[[float], Any] | None) -> Outcome:
    """Follow a solver through all segments, and in each from instant to instant."""
    starts, last = track.problem.starts, track.problem.grid[-1]
    for segment, (begin, end) in enumerate(zip(starts, np.append(starts[1:], last), strict=True)):
        track.enter(segment, float(begin))
        while track.stop < 0 and track.t < end:
            outcome = _stretch(track, legs, watched, progress, track.next_instant(float(end)))
            if outcome is not Outcome.DONE:
                return outcome
            if track.t < end:
                track.act()
                # Every restart begins with tiny steps, and thousands of instants must not use up what a run may take.
                legs.most = min(track.problem.most_attempts, legs.most + STEPS_AFTER_INSTANT)
        if track.stop >= 0:
            return Outcome.STOPPED
    return Outcome.DONE


def _stretch(
    track: Track, legs: _Legs, watched: tuple[float, ...], progress: Callable[[float], Any] | None, end: float
) -> Outcome:
    """Follow a solver over one stretch without jumps and instants."""
    if legs.is_spent():
        return legs.failure
    for leg in legs.over(track.segment, track.t, end, track.x):
        if not track.is_sound(leg.x1):
            return Outcome.STALLED
        track.take(leg, watched)
        if progress is not None:
            progress(track.t)
        if track.stop >= 0:
            return Outcome.STOPPED
    return Outcome.DONE if track.t >= end else legs.failure


class _StatelessLegs(_Legs):
    """For a circuit without states: there is nothing to solve, a leg for every row."""

    def over(self, segment: int, begin: float, end: float, x: Array) -> Iterator[Leg]:
        stops = self._stops_at(begin, end).tolist()
        for first, last in pairwise(stops):
            yield Leg(first, last, x, x, lambda _: x)


class _Scipy(_Legs):
    """LSODA, BDF or Radau, a leg for every step."""

    def __init__(self, problem: Problem, solver: str) -> None:
        from scipy.integrate import BDF, LSODA, Radau

        super().__init__(problem)
        self.solver = {"lsoda": LSODA, "bdf": BDF, "radau": Radau}[solver]
        # Radau's interpolant is of order 3 while its steps are of order 5: its steps end on the rows instead.
        self.lands_on_rows = solver == "radau"

    def over(self, segment: int, begin: float, end: float, x: Array) -> Iterator[Leg]:
        method = self._quietly(partial(self._method, segment, begin, end, x))
        if method is None:
            return
        for target in self._stops_at(begin, end)[1:] if self.lands_on_rows else (end,):
            # The method goes on with its history; a new one for each row would start with tiny steps.
            method.t_bound, method.status = float(target), "running"
            while method.status == "running":
                t0, x0 = method.t, method.y.copy()
                self._quietly(method.step)
                # Some methods fail without saying so, by a step of no length.
                if method.status == "failed" or method.t == t0:
                    return
                self.accepted += 1
                yield Leg(float(t0), float(method.t), x0, method.y.copy(), method.dense_output())
                if method.status == "running" and self.is_spent():
                    return

    def _method(self, segment: int, begin: float, end: float, x: Array) -> Any:
        return self.solver(
            partial(rates, self.problem, segment), begin, x, end,
            rtol=self.rtol, atol=self.rtol * self.scale, max_step=self.problem.maximum_step,
            jac=partial(jacobian, self.problem, segment),
        )  # fmt: skip

    @staticmethod
    def _quietly(work: Callable[[], Any]) -> Any:
        """Do a solver's work; numbers it cannot go on with end its steps instead of the program."""
        with warnings.catch_warnings(), np.errstate(all="ignore"):
            warnings.simplefilter("ignore")
            try:
                return work()
            except (ValueError, ArithmeticError, np.linalg.LinAlgError):
                return None


class _Cvodes(_Legs):
    """CVODES on the traced expressions, a leg for every row.

    One compiled integrator serves all segments: the coefficients of the inputs are parameters, and each unit of its
    own time tau stands for one stretch between rows, ``t = start + offset + length * tau``. A change of offset or
    length is a change of a control, at which CasADi restarts CVODES; between rows of equal distance there is none.
    """

    def __init__(self, problem: Problem) -> None:
        super().__init__(problem)
        self.rows = 1 if problem.kernel.model.memory else ROWS
        self.integrator = self._integrator()

    def _integrator(self) -> Any:
        import casadi as ca

        model, symbols = self.problem.kernel.model, self.problem.kernel.model.symbols
        n_u = symbols["u"].shape[0]
        z, warp, tau, start = ca.SX.sym("z", model.size), ca.SX.sym("warp", 2), ca.SX.sym("tau"), ca.SX.sym("start")
        scale, c = ca.SX.sym("scale", model.size), ca.SX.sym("c", n_u, 7)
        since = warp[0] + warp[1] * tau
        own = since + c[:, 6]
        phase = 2.0 * np.pi * (c[:, 3] + 0.5 * c[:, 4] * own) * own + c[:, 5]
        u = c[:, 0] + c[:, 1] * own + c[:, 2] * ca.sin(phase)
        arguments = [symbols[name] for name in ("t", "x", "u", "p")]
        traced = ca.Function("rates", arguments, [model.expressions["rates"]])
        ode = warp[1] * traced(start + since, z * scale, u, symbols["p"]) / scale
        parameters = ca.veccat(symbols["p"], start, scale, c)
        dae = {"x": z, "t": tau, "u": warp, "p": parameters, "ode": ode}
        return ca.integrator(
            "cross_check", "cvodes", dae, 0.0, np.arange(1.0, self.rows + 1.0).tolist(), self._options()
        )

    def _options(self) -> dict[str, Any]:
        options = {
            "reltol": self.rtol,
            "abstol": self.rtol,
            "linear_solver": "csparse",
            "max_num_steps": self.most,
            "disable_internal_warnings": True,
            "show_eval_warnings": False,
        }
        if np.isfinite(self.problem.maximum_step):
            longest = np.diff(self.problem.grid).max(initial=self.problem.grid[0])
            options["max_step_size"] = self.problem.maximum_step / longest
        return options

    def over(self, segment: int, begin: float, end: float, x: Array) -> Iterator[Leg]:
        stops = self._stops_at(begin, end)
        parts = [stops[first : first + self.rows + 1] for first in range(0, stops.size - 1, self.rows)]
        yield from self._chain(segment, parts, x)

    def _chain(self, segment: int, parts: Sequence[Array], x: Array) -> Iterator[Leg]:
        """Legs over several sets of stretches, as far as they go."""
        for stops in parts:
            reached = stops[0]
            for leg in self._legs(segment, stops, x):
                x, reached = leg.x1, leg.end
                yield leg
                if self.is_spent():
                    return
            if reached < stops[-1]:
                return

    def _legs(self, segment: int, stops: Array, x: Array) -> Iterator[Leg]:
        """Legs over the stretches of one call; a call that fails is cut in two."""
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
        """State at the end of one stretch; one that fails is halved, since CVODES gives up early at a kink."""
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
        """States at the end of each stretch, or None where CVODES fails."""
        start, n_u = self.problem.starts[segment], len(self.problem.kernel.model.inputs)
        coefficients = self.problem.coefficients[self.problem.courses[segment], :n_u].T.copy()
        coefficients[6] = start - coefficients[6]
        p = np.concatenate([self.problem.p, [start], self.scale, coefficients.ravel()])
        try:
            states = self.integrator(x0=x / self.scale, p=p, u=_warp(stops - start, self.rows))["xf"].full()
        except RuntimeError as error:
            # CasADi says it in words only.
            if "TOO_MUCH_WORK" in str(error):
                self.failure = Outcome.TOO_MANY
            return None
        statistics = self.integrator.stats()
        self.accepted += int(statistics["nsteps"])
        self.rejected += int(statistics["netfails"])
        return [np.ascontiguousarray(z * self.scale) for z in states.T[: stops.size - 1]]


def _warp(stops: Array, rows: int) -> Array:
    """Offset and length of each stretch, (2, rows); equal but for rounding where the rows are equally far apart."""
    lengths = np.diff(stops)
    groups = np.cumsum(np.abs(np.diff(lengths, prepend=lengths[0])) > 1e-9 * lengths)
    warp = np.zeros((2, rows))
    for group in np.unique(groups):
        places = np.flatnonzero(groups == group)
        first, last = places[0], places[-1] + 1
        length = (stops[last] - stops[first]) / places.size
        warp[:, places] = np.array([[stops[first] - length * first], [length]])
    return warp

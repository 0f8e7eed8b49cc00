r"""Co-simulation master: FMUs that exchange values at communication points, with iteration and rollback.

All FMUs are coupled through a hub, which is a circuit, or connections alone. Let y be the outputs of all FMUs in the
middle and at the end of a communication step, and G(y) the outputs that result if the hub assumes the parabola through
y. The master solves

.. math:: y = G(y)

in each communication step: it repeats the step from its saved start until both sides agree. The error of the coupling
is then of fourth order in the step, and of second order for an FMU that does not interpolate its inputs. An FMU that
cannot return to an earlier state takes each step once, for extrapolated outputs. The hub is then repeated with the
actual outputs.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from contextlib import ExitStack
from dataclasses import dataclass
from itertools import pairwise
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray

from poppet.core.codes import Note
from poppet.cosim.fmu_slave import FmuSetup, FmuSlave

Array = NDArray[np.float64]
MAX_PASSES = 30
"""Maximum number of passes of a communication step."""
AGREEMENT = 0.01
"""Tolerance of coupled values, relative to the tolerance of the run."""
SMALLEST = 1e-6
"""Size of a value, relative to its nominal value, below which its tolerance is absolute."""
MEMORY = 6
"""Number of earlier passes from which the next values are extrapolated."""


class Hub(Protocol):
    """Coupling of FMUs: a circuit, or connections alone.

    Vectors contain the outputs y of all FMUs, and the inputs u of all FMUs, in the order of the FMUs.
    """

    used: NDArray[np.bool_]
    """Mask of the outputs that act on the hub; the others are recorded only."""

    def initial_inputs(self, y: Array) -> Array:
        """Return the inputs of the FMUs at t = 0 for given outputs, which may be approximate."""

    def start(self, y: Array) -> None:
        """Start at t = 0 with the outputs that the FMUs have after their initialisation."""

    def advance(self, begin: float, end: float, first: Array, y: Array) -> Array:
        """Advance from the last accepted point.

        The outputs of the FMUs change from `first` to `y`, whose rows contain the values in the middle and at the end
        of the step. Discrete ones keep the values `first`. The result contains the inputs of the FMUs at the start, in
        the middle and at the end, (3, n).
        """

    def accept(self) -> bool:
        """Accept the last advance as final, and return False if the run has ended."""


@dataclass(frozen=True)
class StepSizes:
    """Communication points of a run."""

    step: float  # [s]
    times: Array  # (n + 1,) from 0 to the end [s]

    @classmethod
    def of(cls, step: float, duration: float, grid: Array) -> StepSizes:
        """Return equal steps, the last of which can be shorter.

        A point that differs from an output time in `grid` only by rounding is moved to it.
        """
        count = max(1, math.ceil(duration / step - 1e-9))
        times = np.minimum(np.arange(count + 1) * step, duration)
        times[-1] = duration
        nearest = np.clip(np.searchsorted(grid, times), 1, len(grid) - 1) if len(grid) > 1 else np.zeros(0, np.int64)
        for k in nearest, nearest - 1:
            if len(k):
                is_same = np.abs(grid[k] - times) <= 1e-9 * step
                times[is_same] = grid[k][is_same]
        return cls(step, times)

    @property
    def has_equal_steps(self) -> bool:
        """True if the last step has the length of all others."""
        return bool(abs(self.times[-1] - self.times[-2] - self.step) <= 1e-6 * self.step)


@dataclass
class Report:
    """Course of a co-simulation.

    `failure` is the note on an FMU that has ended the run, and `not_converged` the number of steps whose values did not
    agree.
    """

    time: float = 0.0  # of the last accepted point [s]
    steps: int = 0
    passes: int = 0
    not_converged: int = 0
    first_time: float = 0.0  # of the first step whose values did not agree [s]
    worst: str = ""  # variable that differed most in it
    end: Note | None = None  # of an FMU that has ended the simulation


class Master:
    """Loop of communication steps of several FMUs and their hub."""

    def __init__(self, slaves: Sequence[FmuSlave], hub: Hub, tolerance: float) -> None:
        self.slaves, self.hub, self.report = slaves, hub, Report()
        outputs = [(slave, v) for slave in slaves for v in slave.setup.description.outputs]
        self.names = [f"{slave.name}.{v.local}" for slave, v in outputs]
        is_continuous = [v.is_continuous and not slave.setup.is_sampled for slave, v in outputs]
        self.is_continuous = np.array(is_continuous, dtype=np.bool_)
        self.size = SMALLEST * np.array([abs(v.unit.factor) * v.nominal for _, v in outputs])
        self.agreement = AGREEMENT * tolerance
        ends = np.cumsum([0, *(len(slave.setup.description.outputs) for slave in slaves)])
        self._of_y = [slice(*ends[k : k + 2]) for k in range(len(slaves))]
        ends = np.cumsum([0, *(len(slave.setup.description.inputs) for slave in slaves)])
        self._of_u = [slice(*ends[k : k + 2]) for k in range(len(slaves))]
        self._is_compared = self.is_continuous & hub.used
        # Outputs on which the master iterates.
        self._is_solved = self._is_compared.copy()
        for slave, place in zip(slaves, self._of_y, strict=True):
            if not slave.can_roll_back:
                self._is_solved[place] = False
        self.y = np.zeros(len(outputs))
        self._last: tuple[float, Array, Array] | None = None  # duration and outputs of the last step

    def initialise(self, y: Array) -> None:
        """Compute consistent values at t = 0, from approximate outputs `y`."""
        for k in range(MAX_PASSES):
            u = self.hub.initial_inputs(y)
            last, y = y, self._initial_outputs(u, is_last=False)
            if k and self._agree(y - last, y):
                break
        self.y = self._initial_outputs(self.hub.initial_inputs(y), is_last=True)
        self._grow(self.y)
        self.hub.start(self.y)

    def _initial_outputs(self, u: Array, *, is_last: bool) -> Array:
        parts = [
            slave.initialise(u[place], is_last=is_last)
            for slave, place in zip(self.slaves, self._of_u, strict=True)
        ]  # fmt: skip
        return np.concatenate(parts) if parts else np.zeros(0)

    def run(self, steps: StepSizes, progress: Callable[[float], Any] | None = None) -> Report:
        """Run to the last communication point, or until an FMU or the hub ends the run."""
        for begin, end in pairwise(steps.times.tolist()):
            # Without the rounding of times: some FMUs count their internal steps.
            is_whole = abs(end - begin - steps.step) <= 1e-9 * steps.step
            if not self.advance(begin, end, steps.step if is_whole else end - begin):
                break
            if progress is not None:
                progress(end)
        return self.report

    def advance(self, begin: float, end: float, duration: float) -> bool:
        """Take one communication step, and return False if the run has ended."""
        report, first = self.report, self.y
        guess = self._predicted(duration)
        guesses, results = list[Array](), list[Array]()
        y, stops, is_settled = guess, list[tuple[float, str]](), False
        last: Array | None = None
        for k in range(MAX_PASSES):
            u = self.hub.advance(begin, end, first, guess)
            # Equal inputs give equal outputs, for example without a feedback.
            if last is not None and np.array_equal(u, last):
                is_settled = True
                break
            last = u
            y, stops = self._pass(begin, duration, u, y, is_repeated=k > 0)
            report.passes += 1
            if stops:
                break
            is_settled = self._agree(np.where(self._is_compared, y - guess, 0.0), y[-1])
            if is_settled or not self._is_solved.any():
                break
            guesses, results = [*guesses[-MEMORY:], guess], [*results[-MEMORY:], y]
            guess = np.where(self._is_solved, self._next_guess(guesses, results), y)
        if stops:
            return self._stop(begin, end, min(stops), y)
        if not is_settled and self._is_solved.any():
            self._note_difference(begin, np.where(self._is_solved, np.abs(y - guess), 0.0)[-1])
        if not is_settled or not results:
            # Outputs that are recorded only have not been compared.
            self.hub.advance(begin, end, first, y)
        self._grow(y[-1])
        self._last = duration, first, y
        self.y, report.time, report.steps = y[-1], end, report.steps + 1
        return self.hub.accept()

    def _predicted(self, duration: float) -> Array:
        """Return outputs in the middle and at the end of the next step, from the parabola of the last one."""
        if self._last is None:
            return np.stack([self.y, self.y])
        previous, first, (middle, last) = self._last
        result = []
        for end in (0.5, 1.0):
            s = 1.0 + end * duration / previous
            value = (2 * s * s - 3 * s + 1) * first + 4 * s * (1 - s) * middle + (2 * s * s - s) * last
            result.append(np.where(self.is_continuous, value, last))
        return np.stack(result)

    def _stop(self, begin: float, end: float, stop: tuple[float, str], y: Array) -> bool:
        """End the run, because an FMU has ended the simulation."""
        reached, name = stop
        self.report.end = Note("fmu.ended", name, time=reached)
        if begin < reached:
            middle = np.where(self.is_continuous, 0.5 * (self.y + y[-1]), self.y)
            self.hub.advance(begin, min(reached, end), self.y, np.stack([middle, y[-1]]))
            self.hub.accept()
            self.report.time = reached
        return False

    def _pass(
        self, begin: float, duration: float, u: Array, last: Array, *, is_repeated: bool
    ) -> tuple[Array, list[tuple[float, str]]]:
        """Take a step of all FMUs, and return their outputs and the ends of the simulation that they report."""
        y, stops, repeats = last.copy(), list[tuple[float, str]](), bool(self._is_solved.any())
        active = [
            (slave, of_y, of_u)
            for slave, of_y, of_u in zip(self.slaves, self._of_y, self._of_u, strict=True)
            if slave.can_roll_back or not is_repeated
        ]
        # The processes of the FMUs run at the same time.
        for slave, _, of_u in active:
            is_saved = repeats and slave.can_roll_back
            slave.begin_step(begin, duration, u[:, of_u], is_saved=is_saved, is_repeated=is_repeated)
        for slave, of_y, _ in active:
            middle, at_end, reached = slave.end_step()
            # Without a value in the middle, outputs change linearly.
            y[0, of_y] = 0.5 * (self.y[of_y] + at_end) if middle is None else middle
            y[1, of_y] = at_end
            if reached is not None:
                stops.append((reached, slave.name))
        return y, stops

    def _next_guess(self, guesses: Sequence[Array], results: Sequence[Array]) -> Array:
        """Return values for the next pass by Anderson's method from all earlier passes of this step."""
        # Steps of stiffly coupled FMUs diverge without it.
        if len(results) == 1:
            return results[-1]
        scale = np.maximum(self.size, np.abs(results[-1]))
        residuals = [((y - x) / scale)[:, self._is_solved].ravel() for x, y in zip(guesses, results, strict=True)]
        changes = np.array([r - residuals[-1] for r in residuals[:-1]]).T
        weights = -np.linalg.lstsq(changes, residuals[-1], rcond=1e-10)[0]
        guess = results[-1].copy()
        for weight, y in zip(weights, results[:-1], strict=True):
            guess += weight * (y - results[-1])
        return guess

    def _agree(self, difference: Array, y: Array) -> bool:
        return bool((np.abs(difference) <= self.agreement * np.maximum(self.size, np.abs(y))).all())

    def _grow(self, y: Array) -> None:
        """Increase the sizes of values to which their tolerance refers."""
        self.size = np.maximum(self.size, np.abs(y))

    def _note_difference(self, begin: float, difference: Array) -> None:
        report = self.report
        if not report.not_converged:
            report.first_time, report.worst = begin, self.names[int(np.argmax(difference / self.size))]
        report.not_converged += 1


class Connections:
    """Hub without a circuit: each input of an FMU is an output of an FMU, or constant.

    `sources` contains for each input the index of its output, or -1, and `values` the constants.
    """

    def __init__(self, sources: Sequence[int], values: Array, n_outputs: int) -> None:
        self.sources, self.values = np.array(sources, dtype=np.int64), values
        self.is_constant = self.sources < 0
        self.used = np.zeros(n_outputs, dtype=np.bool_)
        self.used[self.sources[~self.is_constant]] = True

    def initial_inputs(self, y: Array) -> Array:
        """Return the inputs for given outputs."""
        if not y.size:
            return self.values.copy()
        return np.where(self.is_constant, self.values, y[self.sources])

    def start(self, y: Array) -> None:
        """Do nothing: connections have no state."""

    def advance(self, begin: float, end: float, first: Array, y: Array) -> Array:
        """Return the inputs of the FMUs at the start, in the middle and at the end of the step."""
        return np.stack([self.initial_inputs(values) for values in (first, *y)])

    def accept(self) -> bool:
        """Accept the step."""
        return True


def start_slaves(stack: ExitStack, setups: Sequence[FmuSetup]) -> list[FmuSlave]:
    """Load FMUs, each in a child process that ends with the stack."""
    return [stack.enter_context(FmuSlave(setup)) for setup in setups]

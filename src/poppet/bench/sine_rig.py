"""A circuit that has settled, driven from there by sines and steps: the full model, as often as needed."""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.instance import Instance
from poppet.circuit.linear_model import SteadyState, index_of
from poppet.circuit.sampled.point import SampledPoint
from poppet.core.codes import Note
from poppet.core.errors import SimulationError
from poppet.engine.call import Call
from poppet.engine.problem import Problem, RawRun, StopCondition, constant_coefficients
from poppet.engine.solve import solve

Array = NDArray[np.float64]

ROWS = 64
"""Rows per period."""
PERIODS, SAMPLES = 4, 20
"""Periods over which a wave is fitted, or as many as hold this number of samples of the controller: its sidebands must
stay apart from the wave."""
SAME = 5e-3
"""Change of the gain from one stretch of periods to the next at which the transient counts as over."""
ATTEMPTS = 3
"""Runs, each twice as long as the one before, that are given to a transient."""
LOUD = 0.3
"""What is beside the fundamental, over it, from which a circuit moves by itself: more time would not settle it."""
MOST_ATTEMPTS = 1_500_000
"""Step attempts of a run: a minute and a half of a circuit that hums, or half an hour of a controller at 1 kHz."""


@dataclass(frozen=True)
class SineResponse:
    """What a circuit makes of a sine."""

    gain: complex  # fundamental of the output per amplitude of the input, in their units
    mean: float  # of the output, in its unit
    rest: float  # rms of harmonics and oscillations of its own, over that of the fundamental
    is_steady: bool  # two stretches of periods gave the same


class SineRig:
    """A circuit with memory that starts settled: at `rest`, or after a run of `settling` [s] with its inputs held.

    `input` and `output` are the addresses of what is driven and what is looked at.
    """

    def __init__(
        self, instance: Instance, input: str, output: str, rest: SteadyState | None = None, *, settling: float = 2.0,
        relative_tolerance: float = 1e-7,
    ) -> None:  # fmt: skip
        model = instance.model
        self.input = index_of(tuple(item.name for item in model.inputs), input, "input")
        self.output = index_of(model.columns[0], output, "output")
        self.kernel, self.tolerance = instance.kernel, relative_tolerance
        self.u = instance.held_inputs({}) if rest is None else np.array(list(rest.u.values()))
        self.point = SampledPoint(instance, self.u)
        if rest is None:
            self.x, self.p, self.begin = self._settled(settling)
        else:
            v = self.point.v(rest.x, np.array(list(rest.memory.values())))
            (self.x, self.p), self.begin = self.point.at_clock(v), self.point.clock.start

    @property
    def sample_time(self) -> float:
        """Time after which all clocks tick together again [s]."""
        return self.point.clock.sample_time

    def started_at(self, v: Array) -> SineRig:
        """The same rig starting at given states and memory."""
        other = copy(self)
        (other.x, other.p), other.begin = self.point.at_clock(v), self.point.clock.start
        return other

    @property
    def level(self) -> float:
        """Output at the start, in its unit."""
        y = np.empty(len(self.kernel.model.outputs))
        self.kernel.call("outputs", np.array([self.begin]), self.x, self.u, self.p, y)
        return float(y[self.output])

    def _settled(self, duration: float) -> tuple[Array, Array, float]:
        """State and memory after a run with held inputs, and the beginning of a sample at which it ends."""
        clock = self.point.clock
        end = clock.start + max(1, round(duration / clock.sample_time)) * clock.sample_time
        x, p = self.point.first()
        call = Call(self._problem(constant_coefficients(self.u), 0.0, np.array([end]), x, p))
        run = call.made()
        if not run.outcome.is_success:
            raise SimulationError(
                Note("limits.unsettled", outcome=run.outcome.value, text=str(Note(run.outcome.value)))
            )
        settled = np.concatenate([run.x[: self.point.n], np.zeros(self.kernel.model.n_quadratures)])
        return settled, np.concatenate([self.point.numbers, call.memory]), end

    def _problem(self, held: Array, begin: float, grid: Array, x: Array, p: Array, **more: object) -> Problem:
        """A run from a time on; the clocks go on from there."""
        return Problem(
            self.kernel, p.copy(), x.copy(), np.array([begin]), np.zeros(1, dtype=np.int64), held,
            np.zeros(1, dtype=bool), grid, self.tolerance, most_attempts=MOST_ATTEMPTS, **more,  # type: ignore[arg-type]
        )  # fmt: skip

    def run(self, amplitude: float, frequency: float, grid: Array) -> RawRun:
        """Drive the input with its held value plus a sine."""
        held = constant_coefficients(self.u, self.begin)
        held[0, self.input, 2:4] = amplitude, frequency
        return solve(self._problem(held, self.begin, self.begin + grid, self.x, self.p))

    def response(
        self, amplitude: float, frequency: float, *, rows: int = ROWS, attempts: int = ATTEMPTS
    ) -> SineResponse:
        """Fundamental of the output when the transient is over."""
        periods = max(PERIODS, int(np.ceil(SAMPLES * self.sample_time * frequency)))
        for k in range(attempts):
            part = periods * 2**k * rows
            grid = np.arange(1, 3 * part + 1) / (rows * frequency)
            run = self.run(amplitude, frequency, grid)
            if not run.outcome.is_success:
                return SineResponse(complex(np.nan), np.nan, np.nan, False)
            y = run.values[self.output]
            early = fundamental(grid[part : 2 * part], y[part : 2 * part], frequency)
            late = fundamental(grid[2 * part :], y[2 * part :], frequency)
            is_steady = abs(late[0] - early[0]) <= SAME * abs(late[0])
            if is_steady or late[2] > LOUD:
                break
        return SineResponse(late[0] / amplitude, late[1], late[2], is_steady)

    def rise(self, change: float, wanted: float, part: float, longest: float) -> float:
        """Time from a step of the input until the output has made its way."""
        held = constant_coefficients(self.u, self.begin)
        held[0, self.input, 0] += change
        sign = float(np.sign(wanted))
        goal = self.level + part * wanted
        stop = StopCondition(Note("run.stopped"), (self.output, -1), (sign, 0.0, -sign * goal))
        end = np.array([self.begin + longest])
        run = solve(self._problem(held, self.begin, end, self.x, self.p, stop_conditions=(stop,)))
        return float(run.time[-1]) - self.begin if run.stop >= 0 else float("nan")


def fundamental(time: Array, values: Array, frequency: float) -> tuple[complex, float, float]:
    """Wave of one frequency in a series, by least squares under a Hann window.

    The window keeps what repeats with the sampling, and a slow drift, out of the fundamental.

    Examples
    --------
    >>> t = np.arange(400) / 100.0
    >>> wave, mean, rest = fundamental(t, 5.0 + 2.0 * np.sin(2.0 * np.pi * t - 0.5), 1.0)
    >>> round(abs(wave), 9), round(float(np.angle(wave)), 9), round(mean, 9)
    (2.0, -0.5, 5.0)
    """
    angle = 2.0 * np.pi * frequency * time
    window = np.hanning(time.size + 2)[1:-1]
    columns = np.column_stack([np.ones(time.size), np.sin(angle), np.cos(angle)])
    found = np.linalg.lstsq(columns * window[:, None], values * window, rcond=None)[0]
    wave = complex(found[1], found[2])
    left = float(np.sqrt(np.mean((values - columns @ found) ** 2)))
    return wave, float(found[0]), left * np.sqrt(2.0) / abs(wave) if wave else np.inf

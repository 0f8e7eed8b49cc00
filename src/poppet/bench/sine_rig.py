"""Settled circuit with a sine or step at one input, for repeated runs of the nonlinear model."""

from __future__ import annotations

from copy import copy
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from poppet.circuit.circuit import BaseCircuit
from poppet.circuit.instance import Instance
from poppet.circuit.linear_model import SteadyState, index_of
from poppet.circuit.sampled.point import SampledPoint
from poppet.core.codes import Note
from poppet.core.errors import SimulationError
from poppet.engine.call import Call
from poppet.engine.problem import Problem, RawRun, StopCondition, constant_coefficients
from poppet.engine.solve import solve
from poppet.parts.compound import Compound

Array = NDArray[np.float64]

ROWS = 64  # rows per period
# Smallest number of periods in a fit, and smallest number of controller samples: with fewer samples, sampling sidebands
# are not separate from the sine.
PERIODS, SAMPLES = 4, 20
SAME = 5e-3  # relative change of the gain between two windows, below which the transient has ended
ATTEMPTS = 3  # maximum number of runs, each twice as long as the previous one, until a transient ends
# Residual relative to the fundamental, above which the circuit oscillates by itself: a longer run would not help.
LOUD = 0.3
# Limit of step attempts of a run: 90 s of a circuit with a limit cycle, or 30 min of a controller at 1 kHz.
MOST_ATTEMPTS = 1_500_000


@dataclass(frozen=True)
class SineResponse:
    """Response of an output to a sinusoidal input: complex gain, mean and residual."""

    gain: complex  # fundamental of the output per amplitude of the input, in the units of both
    mean: float  # mean of the output, in the unit of the output
    rest: float  # rms of harmonics and other oscillations, relative to the rms of the fundamental
    is_steady: bool  # True if two consecutive windows gave the same gain


class SineRig:
    """Sampled circuit for repeated runs with sines and steps, from one settled state.

    Each run starts from the steady state `rest`. Without `rest`, it starts from the state after `settling` seconds with
    constant inputs. `input` and `output` are the addresses of the varied input and of the observed output.
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
            # A run with constant inputs to a common sample instant of all controllers.
            clock = self.point.clock
            self.begin = clock.start + max(1, round(settling / clock.sample_time)) * clock.sample_time
            end = np.array([self.begin])
            call = Call(self._problem(constant_coefficients(self.u), 0.0, end, *self.point.first()))
            run = call.run()
            if not run.outcome.is_success:
                cause = run.outcome.value
                raise SimulationError(Note("limits.unsettled", outcome=cause, text=str(Note(cause))))
            self.x = np.concatenate([run.x[: self.point.n], np.zeros(model.n_quadratures)])
            self.p = np.concatenate([self.point.numbers, call.memory])
        else:
            v = self.point.v(rest.x, np.array(list(rest.memory.values())))
            (self.x, self.p), self.begin = self.point.at_clock(v), self.point.clock.start

    @property
    def sample_time(self) -> float:
        """Common period of all sampled controllers [s]."""
        return self.point.clock.sample_time

    def from_state(self, v: Array) -> SineRig:
        """Return a copy of this rig whose runs start from the state `v`.

        `v` contains states and discrete states.
        """
        rig = copy(self)
        (rig.x, rig.p), rig.begin = self.point.at_clock(v), self.point.clock.start
        return rig

    @property
    def level(self) -> float:
        """Value of the observed output in the start state, in the unit of the output."""
        y = np.empty(len(self.kernel.model.outputs))
        self.kernel.call("outputs", np.array([self.begin]), self.x, self.u, self.p, y)
        return float(y[self.output])

    def _problem(
        self, coefficients: Array, begin: float, grid: Array, x: Array, p: Array, **options: object
    ) -> Problem:
        """Return the definition of a run from the time `begin` [s] and the state `x`.

        `coefficients` define the inputs, `grid` contains the output times [s], and `p` the parameters and discrete
        states. The sampled controllers keep their clocks.
        """
        return Problem(
            self.kernel, p.copy(), x.copy(), np.array([begin]), np.zeros(1, dtype=np.int64), coefficients,
            np.zeros(1, dtype=bool), grid, self.tolerance, most_attempts=MOST_ATTEMPTS, **options,  # type: ignore[arg-type]
        )  # fmt: skip

    def run(self, amplitude: float, frequency: float, grid: Array) -> RawRun:
        """Simulate a sine that is added to the constant value of the varied input.

        `frequency` is in Hz. `grid` contains the output times, counted from the start of the run [s].
        """
        coefficients = constant_coefficients(self.u, self.begin)
        coefficients[0, self.input, 2:4] = amplitude, frequency
        return solve(self._problem(coefficients, self.begin, self.begin + grid, self.x, self.p))

    def response(
        self, amplitude: float, frequency: float, *, rows: int = ROWS, attempts: int = ATTEMPTS
    ) -> SineResponse:
        """Return the response to a sine after the transient has decayed.

        `frequency` is the frequency of the sine [Hz], and the keyword `rows` is the number of samples per period. At
        most `attempts` (a keyword) runs are made, each twice as long as the previous one.
        """
        periods = max(PERIODS, int(np.ceil(SAMPLES * self.sample_time * frequency)))
        for k in range(attempts):
            part = periods * 2**k * rows
            grid = np.arange(1, 3 * part + 1) / (rows * frequency)
            run = self.run(amplitude, frequency, grid)
            if not run.outcome.is_success:
                return SineResponse(complex(np.nan), np.nan, np.nan, False)
            y = run.values[self.output]
            first = fundamental(grid[part : 2 * part], y[part : 2 * part], frequency)
            second = fundamental(grid[2 * part :], y[2 * part :], frequency)
            is_steady = abs(second[0] - first[0]) <= SAME * abs(second[0])
            if is_steady or second[2] > LOUD:
                break
        return SineResponse(second[0] / amplitude, second[1], second[2], is_steady)

    def response_time(self, change: float, expected: float, part: float, longest: float) -> float:
        """Return the time in which the output responds to a step of the input [s].

        `change` is the step, `expected` the complete change of the output, and `part` the fraction of `expected` that
        counts as a response. The result is NaN if the time exceeds `longest` [s].
        """
        coefficients = constant_coefficients(self.u, self.begin)
        coefficients[0, self.input, 0] += change
        sign = float(np.sign(expected))
        goal = self.level + part * expected
        stop = StopCondition(Note("run.stopped"), (self.output, -1), (sign, 0.0, -sign * goal))
        end = np.array([self.begin + longest])
        run = solve(self._problem(coefficients, self.begin, end, self.x, self.p, stop_conditions=(stop,)))
        return float(run.time[-1]) - self.begin if run.stop >= 0 else float("nan")


def fundamental(time: Array, values: Array, frequency: float) -> tuple[complex, float, float]:
    """Fit a sine of one frequency [Hz] to a series.

    The result is the complex amplitude of the sine, the mean, and the rms of the residual relative to the rms of the
    sine. A Hann window separates sampling sidebands and slow drift from the sine.

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
    coefficients = np.linalg.lstsq(columns * window[:, None], values * window, rcond=None)[0]
    wave = complex(coefficients[1], coefficients[2])
    left = float(np.sqrt(np.mean((values - columns @ coefficients) ** 2)))
    return wave, float(coefficients[0]), left * np.sqrt(2.0) / abs(wave) if wave else np.inf


_BANDS = {
    "electronics": (
        "inner.hold_band", "inner.minimum_duty", "inner.vent_delay", "outer.dead_band", "outer.integral_band",
        "outer.integral_limit", "outer.correction_limit", "converter.bits",
    ),
    "pilot_stage": ("fill.opening_delay", "fill.closing_delay", "vent.opening_delay", "vent.closing_delay"),
}  # fmt: skip
"""Mapping from the kind of a part to the parameters that `without_bands` sets to zero."""
_OPTIONS = {"pilot_stage": {"drive": "averaged"}}


def without_bands(circuit: BaseCircuit) -> BaseCircuit:
    """Return a copy of the circuit without dead bands, delays and switching in its valves.

    Dead bands, hold bands, delays and the steps of converters are set to zero. Each pulsed solenoid valve has its mean
    flow over a period, so the circuit behaves smoothly for small motions.
    """
    changes: dict[str, float | str] = {}
    for name, part in circuit.parts.items():
        members = part.members if isinstance(part, Compound) else {"": part}
        for member, inner in members.items():
            path = f"{name}.{member}" if member else name
            changes |= {f"{path}.{key}": 0.0 for key in _BANDS.get(inner.kind, ())}
            changes |= {f"{path}.{key}": value for key, value in _OPTIONS.get(inner.kind, {}).items()}
    return circuit.with_values(changes)

"""A plant by its answers to sines of one size: where small steps say nothing, for valves rest in dead zones or hum.

The loop runs as it is, with the controller as a weak hold, and a sine is added to the command. What the measurement
and the command then have of that frequency is the sinusoidal describing function of all between them, at the size of
the command's own sine.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any

import numpy as np

from poppet.control.extraction import Loop, loop_of
from poppet.control.loop import Array, Complex, Gains, LoopPlant, Margins
from poppet.control.metrics import readable
from poppet.control.plant import OperatingPoint, Plant, place
from poppet.control.verification import Verification, verified
from poppet.core.codes import Note
from poppet.core.errors import OutOfRangeError, SimulationError
from poppet.core.units import convert, quantity
from poppet.parts.part import Scope
from poppet.parts.quantities import COMMANDS, command_of
from poppet.timeseries.signals import Constant, Sine

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit
    from poppet.timeseries.recording import Recording

ProgressCallback = Callable[[str], None]
_WEAK = 0.15
"""Part of the file's gain that holds the plant while it is measured."""
_ROWS = 64
"""Rows of a period that are kept at most."""
_FINER = 1.33
"""Ratio of neighbouring frequencies."""
_LAGS, _SPAN = -135.0, 15.0
"""Phase of the highest frequency that matters for a crossover [deg], and how far below it frequencies matter."""
_FLAT, _LESS = -8.0, 5.0
"""Phase that lags no more [deg], and the span that then will do."""
_PERIODS, _LONG, _LASTS = 4, 8, 5.0
"""Periods of a first run; how many are waited for at most, or how long, if that is more [s]."""
_ALIKE, _CLOSE = 0.01, 0.05
"""Part by which two halves of an answer may differ; and where more periods do not make them alike."""
_DISTORTED = 0.35
"""Part of an answer that is not the sine, from which it is none: sticking, or an end stop."""
_SIZE, _TRIES = 0.05, 3
"""Part by which the command's sine may miss its size, and how often it is corrected."""
_FEWEST, _ENOUGH, _LOST = 8, 3, 2
"""Answers without which there is no response, in all and where phases matter; how many then may come to nothing."""
_TURN, _SMALL = math.radians(20.0), 0.005
"""Phase between neighbours that asks for a frequency between them; part of the greatest answer that no loop feels."""
_EVERY = 4
"""Frequency of which one is looked at for stability."""
_RUNS, _QUIET = 8, 0.1
"""Runs in which a plant comes to rest, and the part of the sine by which its command may still move."""


@dataclass(frozen=True, eq=False)
class MeasuredPlant(LoopPlant):
    """A plant known by its answers to sines.

    Parameters
    ----------
    known : (n,) array
        Frequencies, rising [Hz].
    answers : (n,) array
        Measurement per command, complex, SI.
    sample_time : float
        T [s].
    held_by : Gains
        A controller whose loop is known to be stable: that which held the plant.

    Notes
    -----
    Between the frequencies size and phase follow a monotone cubic over the logarithm of the frequency. Above them the
    phase stays and the size goes on with its last slope; below them it goes on as a gain or as integrators.
    """

    known: Array
    answers: Complex
    sample_time: float
    held_by: Gains

    @cached_property
    def _curves(self) -> Callable[[Array], tuple[Array, Array]]:
        from scipy.interpolate import PchipInterpolator

        size, phase = np.log(np.abs(self.answers)), np.unwrap(np.angle(self.answers))
        phase -= 2.0 * np.pi * np.round(phase[0] / (2.0 * np.pi) - 0.05)
        both = PchipInterpolator(np.log(self.known), np.stack([size, phase], axis=1))

        (low, high), slopes = np.log(self.known[[0, -1]]), np.diff(size) / np.diff(np.log(self.known))
        # Towards zero the plant is a gain or integrators, by the nearest whole slope, and its phase a multiple of 90.
        slope = float(np.round(slopes[0]))
        end = 0.5 * np.pi * slope + np.pi * np.round((phase[0] - 0.5 * np.pi * slope) / np.pi)

        def at(logarithm: Array) -> tuple[Array, Array]:
            size, phase = both(np.clip(logarithm, low, high)).T
            below, above = np.minimum(logarithm - low, 0.0), np.maximum(logarithm - high, 0.0)
            return size + slope * below + slopes[-1] * above, end + (phase - end) * np.exp(below)

        return at

    def response(self, z: Complex) -> Complex:
        size, phase = self._curves(np.log(np.angle(z) / (2.0 * np.pi * self.sample_time)))
        return np.asarray(np.exp(size + 1j * phase), dtype=np.complex128)

    @cached_property
    def _seen(self) -> tuple[Complex, Complex]:
        z = self.at(self.frequencies[::-_EVERY][::-1])
        return z, self.response(z)

    def _turned(self, gains: Gains) -> float:
        """The angle by which 1 + L turns from the lowest frequency to half the sampling frequency."""
        z, answers = self._seen
        angle = np.unwrap(np.angle(1.0 + answers * gains.response(z, self.sample_time)))
        return float(angle[-1] - angle[0])

    @cached_property
    def _held(self) -> float:
        return self._turned(self.held_by)

    def is_stable_with(self, gains: Gains) -> bool:
        # Nyquist, whatever poles the plant has: it is as stable as the loop that held it, for 1 + L goes round as
        # often. Half of the pole at 1 that an integral brings adds a quarter of a turn.
        own = 0.5 * np.pi if gains.integral_time > 0.0 else 0.0
        return abs(self._turned(gains) - self._held - own) < 0.5 * np.pi

    def is_known_for(self, gains: Gains, bound: float) -> bool:
        """True where what lies beyond the known frequencies cannot break a bound, whatever its phase.

        Parameters
        ----------
        gains : Gains
            Of the controller.
        bound : float
            M of Ms and Mt.

        Returns
        -------
        bool
            Of a plant that is a gain below them the lowest frequency counts as enough.
        """
        low, high = np.abs(self.answers * gains.response(self.at(self.known), self.sample_time))[[0, -1]]
        is_gain = abs(np.angle(self.answers[0])) < 0.25 * np.pi
        return bool((low >= bound / (bound - 1.0) or is_gain) and high <= 1.0 - 1.0 / bound)


@dataclass(frozen=True, eq=False)
class SettledPlant:
    """A plant at rest under a weak hold, ready for sines."""

    circuit: Circuit  # begins at the rest
    rest: Recording
    value: float  # mean of the measurement there, SI
    command: float
    by: Gains
    loop: Loop

    def answer(self, samples: int, size: float) -> tuple[complex, complex] | None:
        """Measurement per command and the command's sine, after transients; None where no sine comes back."""
        every = max(1, math.ceil(samples / _ROWS))
        step, rows = every * self.loop.sample_time, samples // every
        name, period, count = self.loop.controller, samples * self.loop.sample_time, _PERIODS
        signals = {**self.circuit.signals, f"{name}.feedforward": Sine(0.0, size, 1.0 / period)}
        driven = replace(self.circuit, signals=signals, like=self.circuit)
        while True:
            try:
                run = driven.simulate(count * period, step)
            except SimulationError:
                return None
            series = np.stack([run[self.loop.shown], run[f"{name}.command"]])[:, : count * rows]
            quarters = series.reshape(2, 4, -1)
            third, last = (y / u for y, u in (_sine(quarters[:, k], rows)[0] for k in (2, 3)))
            apart = abs(last - third) / abs(last)
            if apart <= _ALIKE or count * period >= max(_LASTS, _LONG * period):
                break
            # On from where it has come to: gas that is shut in finds its mean pressure slowly.
            driven, count = driven.resumed(run), 2 * count
        (y, u), distortion = _sine(series[:, count * rows // 2 :], rows)
        if apart > _CLOSE or distortion > _DISTORTED:
            return None
        return complex(y / u), complex(u)


def _sine(series: Array, rows: int) -> tuple[Complex, float]:
    """Of each series the part with a period of so many rows, beside a drift; and what else the first one has."""
    k = np.arange(series.shape[1])
    angle, drift = 2.0 * np.pi * k / rows, k / k.size - 0.5
    base = np.stack([np.cos(angle), np.sin(angle), np.ones(k.size), drift], axis=1)
    if k.size > 8:
        base = np.column_stack([base, drift**2])
    found, *_ = np.linalg.lstsq(base, series.T, rcond=None)
    left = series[0] - base @ found[:, 0]
    parts = found[1] + 1j * found[0]
    return parts, float(np.sqrt(2.0 * np.mean(left**2)) / max(abs(parts[0]), 1e-300))


@dataclass(frozen=True, eq=False)
class MeasuredLoop(Plant):
    """A circuit whose controller holds it weakly while sines of one size or several are added to its command."""

    loop: Loop = None  # type: ignore[assignment]
    amplitudes: tuple[float, ...] = ()
    told: ProgressCallback = lambda text: None
    held: dict[float, SettledPlant] = field(default_factory=dict)

    @property
    def vent_factor(self) -> float:
        """That of the controller as it is, which is in the answers."""
        return self.loop.numbers.get("vent_factor", 1.0)

    def sampled(  # type: ignore[override]  # no state space
        self, point: OperatingPoint, branch: str, factor: float = 1.0
    ) -> LoopPlant:
        return point.models[branch]  # type: ignore[return-value]

    def named(self, amplitude: float) -> str:
        """A size of the command's sine as people read it."""
        unit = COMMANDS[command_of(self.part)].unit
        shown = readable(unit)
        return f"sines of {convert(amplitude, unit, shown):.4g}{'' if shown == '1' else f' {shown}'}"

    def operating_point(self, value: Any) -> OperatingPoint:
        wanted = self.read(value)
        held = self.held_at(wanted)
        self.held[held.value] = held
        models: Mapping[str, Any] = {self.named(size): self._swept(held, size) for size in self.amplitudes}
        return OperatingPoint(held.value, held.command, models, {name: {} for name in models})

    def verified(
        self, circuit: Circuit, value: float, gains: Gains, margins: Mapping[str, Margins]
    ) -> Iterator[Verification]:
        """Steps of a tuned loop there and back from an operating point, one for each size of sine."""
        for size in self.amplitudes:
            at = place(self, value, self.named(size))
            self.told(f"a step at {at}")
            rest, crossover = self.held[value].rest, margins[at].crossover
            yield verified(circuit, self.controller, rest, value, size, gains, crossover, at)

    def held_at(self, wanted: float) -> SettledPlant:
        """The plant at a rest of its loop as it is, under a weak hold."""
        name, circuit, numbers = self.controller, self.loop.circuit, self.loop.numbers
        part: Any = self.loop.part  # a PID
        signals = {a: s for a, s in circuit.signals.items() if a.partition(".")[0] != name}
        circuit = replace(circuit, run=replace(circuit.run, stop_when=None))
        if self.begins:
            circuit = circuit.with_values({self.begins: wanted})
        rest, value, command = self._come_to_rest(
            replace(circuit, signals={**signals, f"{name}.setpoint": Constant(wanted)}), wanted
        )
        own = part.gains_at(Scope(numbers, {}, {}, circuit.surroundings), value, value)
        ahead = float(own["derivative_time"])
        slow = numbers["derivative_filter"] if ahead > 0.0 else self.loop.sample_time
        by = Gains(_WEAK * float(own["gain"]), 0.0, ahead, slow)
        weak = replace(
            part, gain=by.gain, integral_time=None, derivative_time=ahead, schedule=None, feedforward=True,
            setpoint_weight=1.0, dead_band=0.0, integral_dead_band=None, bias=command,
        )  # fmt: skip
        held = replace(
            circuit, parts={**circuit.parts, name: weak}, signals={**signals, f"{name}.setpoint": Constant(value)}
        )
        held = held.resumed(rest).with_values({f"{name}.initial_integral": 0.0})
        return SettledPlant(held, rest, value, command, by, self.loop)

    def _come_to_rest(self, circuit: Circuit, wanted: float) -> tuple[Recording, float, float]:
        """Where a loop comes to rest: the end of its run, and the means of measurement and command there."""
        duration = max(float(circuit.run.duration or 0.0), 1000.0 * self.loop.sample_time)  # type: ignore[arg-type]
        before, start = np.inf, None
        self.told(f"the loop comes to rest at {'{value:.4g} {unit}'.format(**self.shown(wanted))}")
        for _ in range(_RUNS):
            run = start = circuit.simulate(duration, start=start)
            late = run.time > 0.5 * duration
            value, command = (
                float(np.mean(run[each][late])) for each in (self.loop.shown, f"{self.controller}.command")
            )
            if abs(command - before) <= _QUIET * min(self.amplitudes):
                return run, value, command
            before = command
        raise SimulationError(Note("tuning.not_held", self.measurement, **self.shown(wanted)))

    def _swept(self, held: SettledPlant, size: float) -> MeasuredPlant:
        """Answers from half the sampling frequency down to where they say no more."""
        found: dict[int, complex] = {}
        run: list[int] = []  # of answers in the range that matters, from high frequencies
        lost, time, samples = 0, self.loop.sample_time, 4
        while samples * time <= _LASTS or (run and lost == 0):
            answer = self._answer(held, samples, size, found)
            if answer is None:
                lost += 1
                if len(run) >= _ENOUGH and lost >= _LOST:
                    break  # what moves so far leaves its range
            else:
                found[samples], lost = answer, 0
                phase = math.degrees(np.angle(answer))
                run = [*run, samples] if _LAGS < phase < 20.0 else []
                if run and samples >= (_SPAN if phase < _FLAT else _LESS) * run[0]:
                    break
            samples = _next(samples)
        if len(found) < _FEWEST or len(run) < _ENOUGH:
            raise SimulationError(Note("tuning.not_followed", self.measurement, by=self.named(size)))
        for between in _rough(found):
            answer = self._answer(held, between, size, found)
            found |= {} if answer is None else {between: answer}
        order = sorted(found, reverse=True)
        frequencies = 1.0 / (time * np.array(order))
        delay = np.exp(-2j * np.pi * frequencies * time * self.delay)
        return MeasuredPlant(frequencies, np.array([found[n] for n in order]) * delay, time, held.by)

    def _answer(self, held: SettledPlant, samples: int, size: float, found: Mapping[int, complex]) -> complex | None:
        """The answer to a sine of the command that has its size in spite of the hold."""
        frequency = 1.0 / (samples * self.loop.sample_time)
        self.told(f"{frequency:.3g} Hz by {self.named(size)}")
        z = np.exp(2j * np.pi * np.array([1.0 / samples]))
        hold = held.by.response(z, self.loop.sample_time)[0]
        given = size * float(abs(1.0 + _guessed(found, samples) * hold))
        for _ in range(_TRIES):
            answer = held.answer(samples, given)
            if answer is None:
                return None
            if abs(abs(answer[1]) / size - 1.0) <= _SIZE:
                return answer[0]
            given *= size / abs(answer[1])
        return None


def measured_loop(
    circuit: Circuit, controller: str | None, amplitudes: Sequence[Any], progress: ProgressCallback | None
) -> MeasuredLoop:
    """The plant of a controller for sines of some sizes, least first.

    Parameters
    ----------
    circuit : Circuit
        With the controller.
    controller : str or None
        Its name.
    amplitudes : sequence of float or str
        Of its command, in its unit.
    progress : callable or None
        Called with what is being simulated.

    Returns
    -------
    MeasuredLoop

    Raises
    ------
    InputError
        As `plant_of`; and for a size that is none, or beyond the limits of the command.
    """
    loop = loop_of(circuit, controller)
    unit = COMMANDS[command_of(loop.part)].unit
    sizes = sorted(float(quantity(each, unit, name="amplitude").value) for each in amplitudes)
    numbers = loop.numbers
    low, high = (
        (-numbers["vent_limit"], numbers["fill_limit"])
        if loop.part.is_of_openings
        else (numbers["lower_limit"], numbers["upper_limit"])
    )
    most = 0.5 * (high - low)
    for size in sizes:
        if not 0.0 < size <= most:
            raise OutOfRangeError("tuning.amplitude", loop.controller, size=size, most=most, unit=unit)
    return MeasuredLoop(
        circuit.instance, loop.controller, loop.part, loop.measurement, loop.commands, loop.begins,
        loop=loop, amplitudes=tuple(sizes), told=progress or (lambda text: None),
    )  # fmt: skip


def _next(samples: int) -> int:
    """The next lower frequency, in samples of its period."""
    return _divided(max(samples + 1, _FINER * samples))


def _divided(samples: float) -> int:
    """The nearest period that has a whole number of rows."""
    every = max(1, math.ceil(samples / _ROWS))
    return every * round(samples / every)


def _guessed(found: Mapping[int, complex], samples: int) -> complex:
    """An answer, straight between or beyond the two nearest over logarithms; 0 where there are none."""
    near = sorted(found, key=lambda n: abs(math.log(n / samples)))[:2]
    if len(near) < 2:
        return 0.0
    share = math.log(samples / near[0]) / math.log(near[1] / near[0])
    return found[near[0]] * (found[near[1]] / found[near[0]]) ** share


def _rough(found: Mapping[int, complex]) -> list[int]:
    """Periods between neighbours whose answers lie far apart, where a loop feels them."""
    order, felt = sorted(found), _SMALL * max(map(abs, found.values()))
    far = [
        _divided(math.sqrt(low * high))
        for low, high in itertools.pairwise(order)
        if abs(np.angle(found[high] / found[low])) > _TURN and max(abs(found[low]), abs(found[high])) > felt
    ]
    return [samples for samples in far if samples not in found]

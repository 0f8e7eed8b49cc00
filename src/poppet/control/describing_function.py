"""Frequency responses of plants to sines of a given size, for plants without a useful linear model.

The loop runs with a weak controller, and a sine is added to the command. The complex ratio of measurement to command
at the frequency of the sine is the sinusoidal describing function of the plant. This function depends on the amplitude
of the command.
"""

from __future__ import annotations

import itertools
import math
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np

from poppet.control.extraction import Loop, loop_of
from poppet.control.loop import Array, Complex, Gains, LoopPlant, Margins
from poppet.control.metrics import readable_unit_of
from poppet.control.plant import OperatingPoint, Plant, point_label
from poppet.control.verification import Verification, verify_step
from poppet.core.codes import Note
from poppet.core.errors import SimulationError
from poppet.core.tables import Field
from poppet.core.units import convert
from poppet.parts.bodies import DRY_LAWS, Joint, Mass
from poppet.parts.part import Scope
from poppet.parts.quantities import COMMANDS, command_of
from poppet.timeseries.signals import Constant, Sine

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit
    from poppet.timeseries.recording import Recording

ProgressCallback = Callable[[str], None]
_WEAK = 0.15
"""Gain of the weak controller during the measurement, as a fraction of the gain in the circuit."""
_ROWS = 64
"""Maximum count of stored rows in a period of the sine."""
_FINER = 1.33
"""Ratio of neighbouring frequencies of a sweep."""
_LAGS, _SPAN = -135.0, 15.0
"""Phase at the highest relevant frequency [deg], and the range of relevant periods above that of this frequency."""
_FLAT, _LESS = -8.0, 5.0
"""Phase above which the lag counts as small [deg], and the range of periods that is then sufficient."""
_PERIODS, _LONG, _LASTS = 4, 8, 5.0
"""Periods of a first run; maximum count of periods, or maximum duration [s] if it is longer."""
_ALIKE, _CLOSE = 0.01, 0.05
"""Relative difference of two quarters of a response at which a run ends, and above which the response is rejected."""
_DISTORTED = 0.35
"""Fraction of a response that is not sinusoidal, above which it is rejected: stiction, or an end stop."""
_SLIDES, _FAST = 20.0, 5.0
"""Minimum amplitude of a sliding body, and minimum verification step, in deflections of the bristles; minimum velocity
of a sliding body in transition velocities. A body that creeps near these limits has a response that is up to 100 times
smaller than that of a sliding body."""
_SIZE, _TRIES = 0.05, 3
"""Relative tolerance of the size of the command's sine, and maximum count of corrections."""
_FEWEST, _ENOUGH, _LOST = 8, 3, 2
"""Minimum count of responses, of relevant responses, and count of failures that ends a sweep."""
_TURN, _SMALL = math.radians(20.0), 0.005
"""Phase difference that needs a frequency in between, and fraction of the largest response that is negligible."""
_EVERY = 4
"""The stability test uses every fourth frequency."""
_RUNS, _QUIET = 8, 0.1
"""Maximum count of runs to a steady state, and tolerance of the steady command as a fraction of the smallest sine."""


@dataclass(frozen=True, eq=False)
class MeasuredPlant(LoopPlant):
    """Plant that is described by its measured frequency response to sines of one amplitude.

    Parameters
    ----------
    known_frequencies : (n,) array
        Increasing measured frequencies [Hz].
    responses : (n,) array
        Complex responses, measurement per command, SI.
    sample_time : float
        T [s].
    stabilised_by : Gains
        Gains of the controller during the measurement, with which the loop is stable.
    sticks_above : bool, optional
        True if the measured body sticks above the highest measured frequency, where the response is then unknown.

    Notes
    -----
    Magnitude and phase are interpolated by monotone cubics over the logarithm of the frequency. Above the measured
    range, the phase is constant and the magnitude keeps its last slope. Below the range, the plant is a gain or a chain
    of integrators.
    """

    known_frequencies: Array
    responses: Complex
    sample_time: float
    stabilised_by: Gains
    sticks_above: bool = False

    @cached_property
    def _curves(self) -> Callable[[Array], tuple[Array, Array]]:
        from scipy.interpolate import PchipInterpolator

        size, phase = np.log(np.abs(self.responses)), np.unwrap(np.angle(self.responses))
        phase -= 2.0 * np.pi * np.round(phase[0] / (2.0 * np.pi) - 0.05)
        interpolator = PchipInterpolator(np.log(self.known_frequencies), np.stack([size, phase], axis=1))
        logarithms = np.log(self.known_frequencies)
        low, high, slopes = logarithms[0], logarithms[-1], np.diff(size) / np.diff(logarithms)
        # Towards zero frequency: the nearest integer slope, and a phase that is a multiple of 90 degrees.
        slope = float(np.round(slopes[0]))
        end = 0.5 * np.pi * slope + np.pi * np.round((phase[0] - 0.5 * np.pi * slope) / np.pi)

        def at(logarithm: Array) -> tuple[Array, Array]:
            size, phase = interpolator(np.clip(logarithm, low, high)).T
            decades_below, decades_above = np.minimum(logarithm - low, 0.0), np.maximum(logarithm - high, 0.0)
            size = size + slope * decades_below + slopes[-1] * decades_above
            return size, end + (phase - end) * np.exp(decades_below)

        return at

    def response(self, z: Complex) -> Complex:
        size, phase = self._curves(np.log(np.angle(z) / (2.0 * np.pi * self.sample_time)))
        return np.asarray(np.exp(size + 1j * phase), dtype=np.complex128)

    @cached_property
    def _stable_loop(self) -> tuple[Complex, Complex, float]:
        """Reference data for the stability test, from the loop during the measurement.

        They are coarse points of the z plane, the plant response at these points, and the change in the angle of 1 + L
        [rad], where L is the open-loop response.
        """
        z = self.at(self.frequencies[::-_EVERY][::-1])
        response = self.response(z)
        return z, response, _phase_change(response * self.stabilised_by.response(z, self.sample_time))

    def is_stable_with(self, gains: Gains) -> bool:
        z, response, phase_change = self._stable_loop
        # Nyquist for any poles of the plant: the loop is stable if 1 + L encircles the origin as often as in the
        # measured, stable loop. The pole at 1 of an integral adds a quarter of a turn.
        integral_turn = 0.5 * np.pi if gains.integral_time > 0.0 else 0.0
        change = _phase_change(response * gains.response(z, self.sample_time))
        return abs(change - phase_change - integral_turn) < 0.5 * np.pi

    def keeps_bound_outside(self, gains: Gains, bound: float) -> bool:
        """Return True if Ms and Mt keep the bound outside the measured frequency range.

        Ms and Mt are the maxima of the sensitivity and of the complementary sensitivity. The check uses only the
        magnitude of the open-loop response, so it is valid for any phase.

        Parameters
        ----------
        gains : Gains
            Gains of the controller.
        bound : float
            Bound M of Ms and Mt.

        Returns
        -------
        bool
            Below the measured range, the condition is also met if the plant is a constant gain.
        """
        low, high = np.abs(self.responses * gains.response(self.at(self.known_frequencies), self.sample_time))[[0, -1]]
        is_gain = abs(np.angle(self.responses[0])) < 0.25 * np.pi
        return bool((low >= bound / (bound - 1.0) or is_gain) and high <= 1.0 - 1.0 / bound)


def _phase_change(loop: Complex) -> float:
    """Return the change in the angle of 1 + L over the frequency range [rad].

    `loop` contains the open-loop response L at increasing frequencies.
    """
    angle = np.unwrap(np.angle(1.0 + loop))
    return float(angle[-1] - angle[0])


class Sticking(NamedTuple):
    """Limits of amplitude and velocity below which the measured body sticks.

    Without sticking friction, both limits are zero and `outputs` is empty.
    """

    outputs: tuple[str, ...] = ()  # position of the body
    deflection: float = 0.0  # largest deflection of the bristles, SI
    velocity: float = 0.0  # velocity of full friction, SI

    def slides(self, amplitude: float, angular_frequency: float) -> bool:
        """Return True if a body in sinusoidal motion slides and does not stick.

        `amplitude` is the amplitude of the position. It must exceed 20 deflections of the bristles of the friction
        model, and the velocity amplitude must exceed 5 times the velocity of full friction.
        """
        return amplitude > _SLIDES * self.deflection and amplitude * angular_frequency > _FAST * self.velocity


@dataclass(frozen=True, eq=False)
class SettledPlant:
    """Plant near a steady state, for measurements with sines that are added to its command.

    A weak controller keeps the plant near this state.
    """

    circuit: BaseCircuit  # starts at the steady state
    rest: Recording
    value: float  # mean of the measurement there, SI
    command: float
    weak_gains: Gains
    loop: Loop
    sticking: Sticking
    stuck: set[int] = field(default_factory=set)  # periods of the present sweep in which the body sticks [samples]

    def respond_to_sine(self, samples: int, size: float) -> tuple[complex, complex] | None:
        """Return the plant response to a sine, and the complex amplitude of the command.

        `samples` is the period of the added sine in samples, and `size` its amplitude. The plant response is the ratio
        of measurement to command. The result is None if the run fails, if the response is not sinusoidal, or if the
        measured body does not slide.
        """
        decimation = max(1, math.ceil(samples / _ROWS))
        step, rows = decimation * self.loop.sample_time, samples // decimation
        name, period, count = self.loop.controller, samples * self.loop.sample_time, _PERIODS
        signals = {**self.circuit.signals, f"{name}.feedforward": Sine(0.0, size, 1.0 / period)}
        driven = replace(self.circuit, signals=signals, like=self.circuit)
        while True:
            try:
                run = driven.simulate(count * period, step)
            except SimulationError:
                return None
            outputs = [self.loop.sensor_output, self.loop.command_output, *self.sticking.outputs]
            series = np.stack([run[output] for output in outputs])[:, : count * rows]
            quarters = series[:2].reshape(2, 4, -1)
            third, last = (y / u for y, u in (_fit_sine(quarters[:, k], rows)[0] for k in (2, 3)))
            difference = abs(last - third) / abs(last)
            if difference <= _ALIKE or count * period >= max(_LASTS, _LONG * period):
                break
            # Continue the run: trapped gas reaches its mean pressure slowly.
            driven, count = driven.resumed(run), 2 * count
        (y, u, *motion), distortion = _fit_sine(series[:, count * rows // 2 :], rows)
        if difference > _CLOSE or distortion > _DISTORTED:
            return None
        if motion and not self.sticking.slides(abs(motion[0]), 2.0 * np.pi / period):
            self.stuck.add(samples)
            return None
        return complex(y / u), complex(u)


def _fit_sine(series: Array, rows: int) -> tuple[Complex, float]:
    """Fit a sine to each series, and return complex amplitudes and a distortion.

    `series` has shape (series, rows), and `rows` is the period of the sine in rows. The distortion is the amplitude of
    the residuals of the first series, divided by the amplitude of its sine.
    """
    k = np.arange(series.shape[1])
    angle, drift = 2.0 * np.pi * k / rows, k / k.size - 0.5
    base = np.stack([np.cos(angle), np.sin(angle), np.ones(k.size), drift], axis=1)
    if k.size > 8:
        base = np.column_stack([base, drift**2])
    coefficients, *_ = np.linalg.lstsq(base, series.T, rcond=None)
    residuals = series[0] - base @ coefficients[:, 0]
    amplitudes = coefficients[1] + 1j * coefficients[0]
    return amplitudes, float(np.sqrt(2.0 * np.mean(residuals**2)) / max(abs(amplitudes[0]), 1e-300))


@dataclass(frozen=True, eq=False)
class MeasuredLoop(Plant):
    """Control loop whose plant is measured with sines that are added to the command.

    `amplitudes` contains the amplitudes of the sines. The plant has one frequency response for each amplitude.
    """

    loop: Loop = None  # type: ignore[assignment]
    amplitudes: tuple[float, ...] = ()
    report_progress: ProgressCallback = lambda text: None
    settled: dict[float, SettledPlant] = field(default_factory=dict)
    sticking: Sticking = field(default_factory=Sticking)

    @property
    def vent_factor(self) -> float:
        """Opening of the vent valve per unit of negative command during the measurement."""
        return self.loop.numbers.get("vent_factor", 1.0)

    def sampled(  # type: ignore[override]  # no state space
        self, point: OperatingPoint, branch: str, factor: float = 1.0
    ) -> LoopPlant:
        return point.models[branch]  # type: ignore[return-value]

    def sine_label(self, amplitude: float) -> str:
        """Return a label of a sine from its amplitude, such as `sines of 0.05`."""
        unit = COMMANDS[command_of(self.part)].unit
        shown_unit = readable_unit_of(unit)
        suffix = "" if shown_unit == "1" else f" {shown_unit}"
        return f"sines of {convert(amplitude, unit, shown_unit):.4g}{suffix}"

    def operating_point(self, value: Any) -> OperatingPoint:
        target = self.read(value)
        settled = self.settle(target)
        self.settled[settled.value] = settled
        models: Mapping[str, Any] = {self.sine_label(size): self._sweep(settled, size) for size in self.amplitudes}
        return OperatingPoint(settled.value, settled.command, models, {name: {} for name in models})

    def verify(
        self, circuit: BaseCircuit, value: float, gains: Gains, margins: Mapping[str, Margins]
    ) -> Iterator[Verification]:
        """Yield a simulated setpoint step with the tuned gains for each amplitude of the sines.

        The runs start at the operating point `value`, SI. `margins` maps labels of operating points to the margins of
        the tuned loop.
        """
        for size in self.amplitudes:
            label = point_label(self, value, self.sine_label(size))
            self.report_progress(f"a step at {label}")
            steady_run, crossover = self.settled[value].rest, margins[label].crossover
            # A step within the deflection of the bristles would verify springs.
            step = max(size / abs(gains.gain), _SLIDES * self.sticking.deflection)
            yield verify_step(circuit, self.controller, steady_run, value, step, gains, crossover, label)

    def settle(self, target: float) -> SettledPlant:
        """Run the loop to a steady state, then replace its controller by a weaker one.

        `target` is the setpoint of the run, SI. The weaker controller has 15 % of the gain and no integral part.
        """
        name, circuit, numbers = self.controller, self.loop.circuit, self.loop.numbers
        part: Any = self.loop.part  # a PID
        signals = {a: s for a, s in circuit.signals.items() if a.partition(".")[0] != name}
        circuit = replace(circuit, run=replace(circuit.run, stop_when=None))
        if self.begins:
            circuit = circuit.with_values({self.begins: target})
        controlled = replace(circuit, signals={**signals, f"{name}.setpoint": Constant(target)})
        duration = max(float(controlled.run.duration or 0.0), 1000.0 * self.loop.sample_time)  # type: ignore[arg-type]
        previous, steady_run = np.inf, None
        self.report_progress(f"the loop comes to rest at {'{value:.4g} {unit}'.format(**self.readable_value(target))}")
        # Until the mean command in the second half of a run is constant.
        for _ in range(_RUNS):
            steady_run = controlled.simulate(duration, start=steady_run)
            is_late = steady_run.time > 0.5 * duration
            outputs = self.loop.sensor_output, self.loop.command_output
            value, command = (float(np.mean(steady_run[output][is_late])) for output in outputs)
            if abs(command - previous) <= _QUIET * min(self.amplitudes):
                break
            previous = command
        else:
            raise SimulationError(Note("tuning.not_held", self.measurement, **self.readable_value(target)))
        gains = part.gains_at(Scope(numbers, {}, {}, circuit.surroundings), value, value)
        derivative_time = float(gains["derivative_time"])
        filter_time = numbers["derivative_filter"] if derivative_time > 0.0 else self.loop.sample_time
        weak_gains = Gains(_WEAK * float(gains["gain"]), 0.0, derivative_time, filter_time)
        weak = replace(
            part, gain=weak_gains.gain, integral_time=None, derivative_time=derivative_time, schedule=None,
            feedforward=True, setpoint_weight=1.0, dead_band=0.0, integral_dead_band=None, bias=command,
        )  # fmt: skip
        driven = replace(
            circuit, parts={**circuit.parts, name: weak}, signals={**signals, f"{name}.setpoint": Constant(value)}
        )
        driven = driven.resumed(steady_run).with_values({f"{name}.initial_integral": 0.0})
        return SettledPlant(driven, steady_run, value, command, weak_gains, self.loop, self.sticking)

    def _sweep(self, settled: SettledPlant, size: float) -> MeasuredPlant:
        """Measure the frequency response of the plant with sines of the amplitude `size`.

        The shortest period has four samples. The longest belongs to the lowest relevant frequency.
        """
        responses: dict[int, complex] = {}
        settled.stuck.clear()
        relevant: list[int] = []  # periods with a relevant phase, from high frequencies
        failures, time, samples = 0, self.loop.sample_time, 4
        while samples * time <= _LASTS or (relevant and failures == 0):
            answer = self._measure_response(settled, samples, size, responses)
            if answer is None:
                failures += 1
                if len(relevant) >= _ENOUGH and failures >= _LOST:
                    break  # the motion exceeds its range
            else:
                responses[samples], failures = answer, 0
                phase = math.degrees(np.angle(answer))
                relevant = [*relevant, samples] if _LAGS < phase < 20.0 else []
                if relevant and samples >= (_SPAN if phase < _FLAT else _LESS) * relevant[0]:
                    break
            samples = _round_period(max(samples + 1, _FINER * samples))
        if len(responses) < _FEWEST or len(relevant) < _ENOUGH:
            raise SimulationError(Note("tuning.not_followed", self.measurement, by=self.sine_label(size)))
        # Between neighbours with a large phase difference and a relevant magnitude.
        smallest_relevant = _SMALL * max(map(abs, responses.values()))
        finer = [
            _round_period(math.sqrt(low * high))
            for low, high in itertools.pairwise(sorted(responses))
            if abs(np.angle(responses[high] / responses[low])) > _TURN
            and max(abs(responses[low]), abs(responses[high])) > smallest_relevant
        ]
        for period in [period for period in finer if period not in responses]:
            answer = self._measure_response(settled, period, size, responses)
            responses |= {} if answer is None else {period: answer}
        order = sorted(responses, reverse=True)
        frequencies = 1.0 / (time * np.array(order))
        # Without compensation, the measured command is the delayed one.
        delay = np.exp(-2j * np.pi * frequencies * time * (0 if self.loop.has_dead_zone else self.delay))
        measured = np.array([responses[n] for n in order]) * delay
        sticks_above = min(settled.stuck, default=order[-1]) < order[-1]
        return MeasuredPlant(frequencies, measured, time, settled.weak_gains, sticks_above)

    def _measure_response(
        self, settled: SettledPlant, samples: int, size: float, responses: Mapping[int, complex]
    ) -> complex | None:
        """Return the complex plant response to a command with a sine of the amplitude `size`.

        `samples` is the period in samples. The added sine is corrected until the command has this amplitude.
        `responses` maps measured periods to responses, from which the first amplitude is estimated. The result is None
        without a sinusoidal response.
        """
        frequency = 1.0 / (samples * self.loop.sample_time)
        self.report_progress(f"{frequency:.3g} Hz by {self.sine_label(size)}")
        z = np.exp(2j * np.pi * np.array([1.0 / samples]))
        hold_response = settled.weak_gains.response(z, self.loop.sample_time)[0]
        # Estimate of the response at this period: a power law through the two nearest measured periods.
        estimate: complex = 0.0
        nearest = sorted(responses, key=lambda n: abs(math.log(n / samples)))[:2]
        if len(nearest) == 2:
            first, second = (responses[n] for n in nearest)
            estimate = first * (second / first) ** (math.log(samples / nearest[0]) / math.log(nearest[1] / nearest[0]))
        amplitude = size * float(abs(1.0 + estimate * hold_response))
        for _ in range(_TRIES):
            answer = settled.respond_to_sine(samples, amplitude)
            if answer is None:
                return None
            if abs(abs(answer[1]) / size - 1.0) <= _SIZE:
                return answer[0]
            amplitude *= size / abs(answer[1])
        return None


def make_measured_loop(
    circuit: BaseCircuit, controller: str | None, amplitudes: Sequence[Any], progress: ProgressCallback | None
) -> MeasuredLoop:
    """Return the loop of a controller for measurements with sines of given amplitudes.

    Parameters
    ----------
    circuit : Circuit
        Circuit with the controller.
    controller : str or None
        Name of the controller; None if the circuit has only one.
    amplitudes : sequence of float or str
        Amplitudes of the sines in the unit of the command.
    progress : callable or None
        Function that is called with a text about the current run.

    Returns
    -------
    MeasuredLoop

    Raises
    ------
    InputError
        As `plant_of`; and if an amplitude is not positive or exceeds the limits of the command.
    """
    loop = loop_of(circuit, controller)
    unit = COMMANDS[command_of(loop.part)].unit
    numbers = loop.numbers
    if loop.part.is_of_openings:
        largest = 0.5 * (numbers["fill_limit"] + numbers["vent_limit"])
    else:
        largest = 0.5 * (numbers["upper_limit"] - numbers["lower_limit"])
    field = Field(unit=unit, above=0.0, high=largest, meaning="amplitude, limited by the command,")
    sizes = sorted(field.read(amplitude, "amplitude") for amplitude in amplitudes)
    name = loop.measurement.partition(".")[0]
    part: Any = loop.circuit.parts.get(name)
    friction = getattr(part, "friction", None)
    if not isinstance(part, Mass | Joint) or friction is None or friction.kind not in DRY_LAWS:
        sticking = Sticking()
    else:
        values = part.parameters(loop.circuit.surroundings)
        if friction.kind == "stribeck":
            sticking = Sticking((f"{name}.position",), 0.0, values["friction.transition_velocity"])
        else:
            sticking = Sticking((f"{name}.position",), part.largest_deflection(values))
    return MeasuredLoop(
        circuit.instance, loop.controller, loop.part, loop.measurement, loop.commands, loop.begins,
        loop=loop, amplitudes=tuple(sizes), report_progress=progress or (lambda text: None),
        sticking=sticking,
    )  # fmt: skip


def _round_period(samples: float) -> int:
    """Return the nearest period, in samples, that is a whole number of stored rows."""
    decimation = max(1, math.ceil(samples / _ROWS))
    return decimation * round(samples / decimation)

"""The DAMADICS benchmark actuator, rebuilt from its published equations; shares no code with the package.

A spring-and-diaphragm actuator with a positioner closes a control valve for water. The equations and values are those
of the benchmark library DABLib 1.22 (M. Bartys, M. Syfert, "Using Damadics Actuator Benchmark Library", 2002; its
block diagram contains the values) and of M. Bartys, S. de las Heras, "Actuator simulation of the DAMADICS benchmark
actuator system", IFAC Safeprocess 2003. Times of the scenarios are those of the "Benchmark Definition" 1.0, 2002.

The flow law of the positioner is 2.5e-6 sqrt(dp) instead of ISO 6358, the chamber is isothermal, and friction is a
dead band without force. Two properties differ from the text of the benchmark and follow its block diagram: the leaks
of f9 and f10 have a tenth of the stated size, and the gain of the controller is 100 (the factor 0.5 scales an output
only). Mass and pressure of the gas are integrated separately, so the ideal gas law drifts with each stroke.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numba import njit

STEP = 0.0025  # step of the fixed-step solver (Runge-Kutta, order 4) [s]
STROKE = 0.0381  # [m]
AREA = 0.029  # of the diaphragm [m^2]
STIFFNESS = 60892.0  # of spring and diaphragm [N/m]
PRELOAD = 0.009525  # [m]
MASS = 2.0  # [kg]
VISCOUS = 1500.0  # [N s/m]
VOLUME = 0.0055  # of the chamber without stroke [m^3]
GAS_CONSTANT, TEMPERATURE, AMBIENT = 287.0, 293.0, 101325.0
SUPPLY = 600e3  # gauge pressure [Pa]
LEAST_SUPPLY = 120e3  # the positioner passes no lower supply pressure [Pa]
FLOW = 2.5e-6  # kg/s per sqrt(Pa)
LEAK = 2e-6  # kg/s per sqrt(Pa), times 0.1 for f9 and f10
LAG = 0.30  # each of two lags of the command [s]
GAIN, SAMPLE = 100.0, 0.035  # proportional controller, with its sample time [s]
EP_COMMAND = np.array([-1.0, -0.94, -0.54, 0.46, 0.86, 1.0])
EP_OPENING = np.array([-0.55, -0.55, -0.02, 0.02, 1.0, 1.0])
DEAD_BAND = 0.01  # of the stroke
FLOW_FACTOR, EXPONENT, PLUG = 120.0, 5.0, 0.050  # Kv, equal-percentage exponent, diameter of the plug [m]
RECOVERY = np.array([
    [0, 10, 20, 30, 40, 50, 60, 70, 80, 90, 99, 100],
    [1, 0.95, 0.9, 0.85, 0.785, 0.725, 0.67, 0.61, 0.555, 0.5, 0.45, 0.4],
])  # fmt: skip
CRITICAL_RATIO = np.array(
    [[0.0, 1723763, 3447527, 6895055, 13790111, 17237639, 20685166], [0.94, 0.87, 0.84, 0.79, 0.75, 0.725, 0.685]]
)
COMPRESSIBILITY = np.array([[0, 10, 20, 50, 110], [5.26e-10, 5.02e-10, 4.81e-10, 4.69e-10, 4.42e-10]])
RANGES = {"P1": 4e6, "P2": 4e6, "T1": 200.0, "X": 1.0, "F": 40.0}  # Pa, Pa, degC, 1, t/h
NOISE = np.sqrt(0.0025 * 2e-6 / STEP)  # standard deviation of the white noise of each transducer, of its range
HUM = 0.0025  # amplitude of a sine of 50 Hz; at whole seconds it is zero
T_ON, T_FROM, T_OVER = 300.0, 900.0, 600.0  # [s]
DAY, HOUR, SHORT = 84000.0, 3600.0, 900.0  # development times of incipient faults, from the definition [s]


@dataclass(frozen=True)
class Scenario:
    """Fault of the benchmark, with its strength (negative: in the negative direction) and its development time."""

    fault: int  # number from 1 to 19, or 0 for a healthy actuator
    strength: float = 0.0
    development: float = 0.0  # [s]; 0 is abrupt

    @property
    def name(self) -> str:
        if not self.fault:
            return "healthy"
        sizes = {0.25: "small", 0.5: "medium", 0.75: "big"}
        return f"f{self.fault} {'incipient' if self.development else sizes[abs(self.strength)]}"

    @property
    def horizon(self) -> float:
        """End of the scored time [s]."""
        return T_FROM + self.development + T_OVER


HEALTHY = Scenario(0)
SCENARIOS = tuple(
    [Scenario(fault, sign * size) for fault, sign, sizes in (
        (1, 1, (0.25, 0.5, 0.75)), (8, 1, (0.25, 0.5, 0.75)), (10, 1, (0.25, 0.5, 0.75)), (11, 1, (0.75,)),
        (12, -1, (0.25, 0.5, 0.75)), (13, 1, (0.25, 0.5, 0.75)), (14, -1, (0.25, 0.5, 0.75)), (15, 1, (0.75,)),
        (16, 1, (0.25, 0.5, 0.75)),
    ) for size in sizes]
    + [Scenario(4, 1.0, HOUR), Scenario(9, 1.0, DAY), Scenario(11, 1.0, DAY), Scenario(13, 1.0, SHORT)]
)  # fmt: skip
"""The 27 scenarios of Table 29 of the library whose faults concern stem, actuator, positioner and air supply."""


@dataclass(frozen=True)
class Drive:
    """Sines that drive the actuator: mean, amplitude, frequency [Hz] and phase [rad]. Defaults: the benchmark."""

    command: tuple[float, float, float, float] = (0.5, 0.25, 0.01, 0.0)
    upstream: tuple[float, float, float, float] = (3.5e6, 0.175e6, 0.1, 0.0)  # [Pa]
    downstream: tuple[float, float, float, float] = (2.6e6, 0.026e6, 1.0 / np.pi, 0.0)  # [Pa]
    temperature: float = 43.0  # of the water [degC]


BENCHMARK = Drive()


@dataclass(frozen=True)
class Recording:
    """Rows at 1 s: the measured quantities, the true ones, and the strength of the fault."""

    scenario: Scenario
    time: np.ndarray
    measured: dict[str, np.ndarray]  # CV, P1, P2, T1, X, F in units of RANGES
    true: dict[str, np.ndarray] = field(default_factory=dict)
    strength: np.ndarray = field(default_factory=lambda: np.empty(0))


def record(
    scenario: Scenario = HEALTHY, duration: float | None = None, seed: int = 0, drive: Drive = BENCHMARK
) -> Recording:
    """Simulate a scenario, from rest, and add the noise of the transducers."""
    duration = scenario.horizon if duration is None else duration
    rows = round(duration) + 1
    ramp = 1e30 if scenario.development == 0.0 else abs(scenario.strength) / scenario.development
    fault = (scenario.fault, abs(scenario.strength), ramp, float(np.sign(scenario.strength)))
    sines = np.array([drive.command, drive.upstream, drive.downstream])
    out = np.empty((rows, 9))
    _simulate(rows, np.random.default_rng([seed, 0]), fault, sines, drive.temperature, out)
    time = np.arange(rows, dtype=float)
    names = ("CV", "P1", "P2", "X", "F", "position", "pressure", "opening", "gas_mass")
    true: dict[str, Any] = dict(zip(names, out.T, strict=True))
    true["T1"] = np.full(rows, drive.temperature)
    generator = np.random.default_rng([seed, 1])
    measured = {"CV": true["CV"].copy()}
    for name, span in RANGES.items():
        reading = np.clip(true[name] / span, 0.0, 1.0) + NOISE * generator.standard_normal(rows)
        measured[name] = np.clip(reading, 0.0, 1.0) * span
    strength = np.clip((time - T_FROM) * ramp, 0.0, abs(scenario.strength)) if scenario.fault else np.zeros(rows)
    return Recording(scenario, time, measured, true, strength)


@njit(cache=True)
def _table(x, xs, ys):
    """Interpolate linearly, and extrapolate with the last slopes."""
    k = min(max(np.searchsorted(xs, x), 1), xs.size - 1)
    return ys[k - 1] + (ys[k] - ys[k - 1]) * (x - xs[k - 1]) / (xs[k] - xs[k - 1])


@njit(cache=True)
def _water_density(pressure, temperature):
    t = min(max(temperature, 0.0), 110.0)
    if t >= 30.0:
        density = 1000.0 - (t - 4.0) ** 2 / 466700.0 * (t + 273.0) * 1000.0 * (350.0 - t) / ((t + 67.0) * (365.0 - t))
    else:
        density = 1000.0 - (t - 4.0) ** 2 / 503570.0 * (t + 283.0) * 1000.0 / (t + 67.2)
    return density / (1.0 - _table(t, COMPRESSIBILITY[0], COMPRESSIBILITY[1]) * pressure)


@njit(cache=True)
def _valve(x, upstream, downstream, temperature):
    """Return the water flow [t/h] and the force of the vena contracta on the plug [N]; x is 0 (open) to 1."""
    vapour = 10.0 ** (10.7167 - 2141.0 / (temperature + 273.15))
    p1 = max(upstream, vapour)
    recovery = _table(100.0 * x, RECOVERY[0], RECOVERY[1])
    drop = p1 - downstream
    choked = max(recovery * (p1 - _table(p1, CRITICAL_RATIO[0], CRITICAL_RATIO[1]) * vapour), 0.0)
    density = _water_density(p1, temperature)
    capacity = np.exp(-EXPONENT * min(max(x, 0.0), 0.975))
    if x > 0.975:
        capacity -= capacity * (min(x, 1.0) - 0.975) / 0.025
    flow = 100.0 * FLOW_FACTOR * capacity * np.sqrt(abs(min(choked, drop)) * 1e-6 / density) * density / 1000.0
    return flow, drop / recovery * np.pi * PLUG**2 / 4.0


@njit(cache=True)
def _play(x, band, history):
    return min(max(history, x - band / 2.0), x + band / 2.0)


@njit(cache=True)
def _limit(x, low, high):
    return min(max(x, low), high)


@njit(cache=True)
def _simulate(rows, generator, fault, sines, temperature, out):
    number, largest, ramp, direction = fault
    two_pi = 2.0 * np.pi
    y = np.array([0.0, 0.0, AMBIENT * VOLUME / (GAS_CONSTANT * TEMPERATURE), AMBIENT, 0.0, 0.0])
    # States: command behind the first and the second lag, mass, pressure, velocity, position of the actuator.
    stage, total, rate = np.empty(6), np.empty(6), np.empty(6)
    stem, stem_play, lever_play, relative, at_stop = 0.0, 0.0, 0.0, 0.0, False
    command, next_sample = 0.0, 0.0
    per_row = round(1.0 / STEP)
    for step in range((rows - 1) * per_row + 1):
        t = step * STEP
        f = direction * _limit((t - T_FROM) * ramp, 0.0, largest) if t >= T_FROM else 0.0
        f1, f4, f8 = f * (number == 1), f * (number == 4), f * (number == 8)
        f9, f10, f11 = f * (number == 9), f * (number == 10), f * (number == 11)
        f12, f13, f15, f16 = f * (number == 12), f * (number == 13), f * (number == 15), f * (number == 16)
        area = AREA * (1.0 - f10)
        upper = STROKE * (1.0 - f1)
        band = _limit(STROKE * (DEAD_BAND + f4), 0.0, STROKE)
        band = _limit(band * (1.0 + 0.5 * f8 * (1.0 - stem / STROKE)), 0.0, STROKE)
        supply = SUPPLY * (1.0 - f16)
        supply = supply if supply >= LEAST_SUPPLY else 0.0
        # Noise enters with the command, before its lags.
        held_noise = NOISE * generator.standard_normal()
        memory_stem, memory_relative = stem, relative
        upstream = sines[1, 0] + sines[1, 1] * np.sin(two_pi * sines[1, 2] * t + sines[1, 3])
        downstream = sines[2, 0] + sines[2, 1] * np.sin(two_pi * sines[2, 2] * t + sines[2, 3])
        flow, plug_force = _valve(memory_stem / STROKE, upstream, downstream, temperature)
        # Positioner: sensor of the position, lever with backlash, proportional controller with a sample time.
        sensed = _limit(memory_stem * (1.0 + 1.25 * f13), -0.25 * STROKE, 1.25 * STROKE)
        lever_play = _play(_limit(sensed, -0.01, 0.05), f15 * STROKE, lever_play)
        angle = np.arcsin((lever_play - STROKE / 2.0) / STROKE) * 180.0 / np.pi
        if t >= next_sample - 1e-9:
            command = _limit(GAIN * (y[1] - (angle / 60.0 + 0.5)), -1.0, 1.0)
            next_sample += SAMPLE
        opening = _limit(_table(command, EP_COMMAND, EP_OPENING) * (1.0 - f12), -1.0, 1.0)
        if step % per_row == 0:
            row = step // per_row
            out[row, 0] = sines[0, 0] + sines[0, 1] * np.sin(two_pi * sines[0, 2] * t + sines[0, 3])
            out[row, 1], out[row, 2] = upstream, downstream
            out[row, 3], out[row, 4] = _limit(sensed, 0.0, STROKE) / STROKE, flow
            out[row, 5], out[row, 6], out[row, 7], out[row, 8] = stem / STROKE, y[3], opening, y[2]
        total[:] = 0.0
        for k in range(4):
            if k == 0:
                stage[:] = y
            else:
                stage[:] = y + (STEP if k == 3 else STEP / 2.0) * rate
            at = t + (0.0 if k == 0 else STEP if k == 3 else STEP / 2.0)
            set_point = sines[0, 0] + sines[0, 1] * np.sin(two_pi * sines[0, 2] * at + sines[0, 3])
            set_point += held_noise + HUM * np.sin(two_pi * 50.0 * at)
            played = _limit(_play(stage[5], band, stem_play), 0.0, upper)
            volume = VOLUME + area * played
            velocity = _limit(stage[4], -0.02, 0.02)
            source = supply if opening > 0.0 else 0.0
            drop = source - memory_relative
            inflow = FLOW * abs(opening) * np.sign(drop) * np.sqrt(abs(drop))
            inflow -= 0.1 * (f9 + f10) * LEAK * np.sqrt(abs(memory_relative))
            force = MASS * 9.81 + area * (stage[3] - AMBIENT) - plug_force - VISCOUS * stage[4]
            force -= STIFFNESS * (1.0 - f11) * (memory_stem + PRELOAD)
            if (memory_stem <= 0.0 and force <= 0.0) or (memory_stem >= upper and force > 0.0):
                force = 0.0
            rate[0] = (_limit(set_point, 0.0, 1.0) - stage[0]) / LAG
            rate[1] = (stage[0] - stage[1]) / LAG
            rate[2] = inflow
            rate[3] = stage[3] * (inflow / stage[2] - area * velocity / volume)
            rate[4] = force / MASS
            rate[5] = stage[4]
            total += rate * (1.0 if k == 0 or k == 3 else 2.0)
        y += STEP / 6.0 * total
        y[3] = _limit(y[3], 0.0, 700e3)
        y[5] = _limit(y[5], -0.05 * STROKE, 1.25 * STROKE)
        stem_play = _play(y[5], band, stem_play)
        was_at_stop = at_stop
        at_stop = stem_play >= upper or stem_play <= 0.0
        stem = _limit(stem_play, 0.0, upper)
        if at_stop != was_at_stop:
            y[4] = 0.0
        relative = y[3] - AMBIENT

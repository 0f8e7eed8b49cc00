"""Valves with distributed hysteresis and a curved characteristic: their recordings and true characteristic values.

The module shares no code with the package. The outlet is

    y = G(p) S(v(t - T_d)),  v = w_0 x + sum w_i play(x, r_i),  S(v) = v + a sin(2 pi v / 100),

a Prandtl-Ishlinskii hysteresis and an S-shaped characteristic before linear dynamics G of second or third order.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from scipy.optimize import brentq
from scipy.signal import cont2discrete, freqs, lfilter, step

NOISES = (0.002, 0.010, 0.030)  # [bar]
RATES = (50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0)  # [Hz]
SPAN = 6.0  # full scale [bar]
RADII = (0.2, 0.5, 1.0, 2.0, 4.0)  # of the plays [% FS]
FIGURES = {
    "characteristic": ("linearity", "hysteresis", "repeatability", "accuracy", "zero_offset", "sweep_lag"),
    "step": (
        "delay", "rise_time_up", "response_time_up", "rise_time_down", "response_time_down", "settling_time",
        "overshoot",
    ),
    "frequency": ("bandwidth_gain", "bandwidth_phase", "distortion"),
}  # fmt: skip


@dataclass
class Trace:
    """Recorded series: time [s], setpoint [V] and outlet pressure [bar, gauge]."""

    time: np.ndarray
    setpoint: np.ndarray
    outlet: np.ndarray


@dataclass
class IndependentValve:
    """Random valve with its sensor, its records by test, and its true characteristic values."""

    seed: int
    conditions: dict[str, float] = field(default_factory=dict)
    records: dict[str, list[Trace]] = field(default_factory=dict)
    truth: dict[str, float] = field(default_factory=dict)

    def __post_init__(self) -> None:
        random = np.random.default_rng([self.seed, 24])
        self.random = random
        self.noise = NOISES[self.seed % 3]
        self.colour = float(random.uniform(0.5, 0.95)) if self.seed // 3 % 2 else 0.0
        self.rate = float(RATES[self.seed // 2 % 6])
        self.quantum = float(random.choice([0.0, 0.001, 0.0024]))  # of the outlet [bar]
        self.has_spike = self.seed % 5 == 4
        self.is_synchronous = bool(random.random() < 0.5)  # setpoint and recording have the same clock
        weights = random.uniform(0.0, 1.0, len(RADII)) * (random.random(len(RADII)) < 0.7)
        gap = float(random.uniform(0.4, 2.5))  # of a long sweep before the S [% FS]
        total = 2.0 * float(weights @ np.array(RADII))
        self.weights = weights * gap / total if total > 0.0 else np.array([0.0, 0.0, gap / 2.0, 0.0, 0.0])
        self.bend = float(random.uniform(0.2, 1.2) * random.choice([-1.0, 1.0]))  # amplitude a [% FS]
        constant, damping = random.uniform(0.02, 0.08), random.uniform(0.45, 1.3)
        den = np.array([constant**2, 2.0 * damping * constant, 1.0])
        if random.random() < 0.5:
            den = np.polymul(den, [random.uniform(0.2, 0.8) * constant, 1.0])
        self.system = ([1.0], den.tolist())
        self.dead = float(random.uniform(0.004, 0.03))
        self.is_digital = bool(random.random() < 0.5)  # the recorded setpoint has no noise
        self.conditions = {
            "noise": self.noise, "colour": self.colour, "rate": self.rate, "bend": self.bend, "order": den.size - 1,
            "is_synchronous": self.is_synchronous, "has_spike": self.has_spike, "is_digital": self.is_digital,
        }  # fmt: skip

    def static(self, x: np.ndarray, before: np.ndarray) -> np.ndarray:
        """Return the steady-state outlet for a sequence of setpoints after the setpoints `before` [% FS]."""
        series = np.concatenate([before, x])
        v = (1.0 - float(self.weights.sum())) * series
        for radius, weight in zip(RADII, self.weights, strict=True):
            v += weight * play(series, radius)
        v = v[before.size :]
        return v + self.bend * np.sin(2.0 * np.pi * v / 100.0)

    def read(self, y: np.ndarray) -> np.ndarray:
        """Return a reading of the outlet [bar] for values in % FS."""
        white = self.random.normal(0.0, self.noise * math.sqrt(1.0 - self.colour**2), y.size + 200)
        reading = 0.01 * SPAN * y + lfilter([1.0], [1.0, -self.colour], white)[200:]
        return np.round(reading / self.quantum) * self.quantum if self.quantum else reading

    def command(self, x: np.ndarray) -> np.ndarray:
        """Return a reading of the setpoint [V] for values in % FS."""
        noise = 0.0 if self.is_digital else self.random.normal(0.0, 1e-3, x.size)
        return np.round((0.1 * x + noise) / 1e-3) * 1e-3

    def trace(self, time: np.ndarray, x: np.ndarray, y: np.ndarray) -> Trace:
        """Return a record, with one faulty sample of 60 bar if the sensor has spikes."""
        outlet = self.read(y)
        if self.has_spike:
            outlet[int(self.random.integers(time.size // 10, time.size))] = 60.0
        return Trace(time, self.command(x), outlet)


def play(values: np.ndarray, radius: float) -> np.ndarray:
    """Return a series after a play, whose output stays within `radius` of its input."""
    result, last, begin = np.empty_like(values), float(values[0]), 0
    turns = np.flatnonzero(np.diff(np.sign(np.diff(values)))) + 2
    for end in (*turns.tolist(), values.size):
        part = values[begin:end]
        rises = part[-1] >= part[0]
        limited = np.maximum(last, part - radius) if rises else np.minimum(last, part + radius)
        # The first sample of a section is the turning point, which still belongs to the previous direction.
        result[begin:end] = np.clip(limited, part - radius, part + radius)
        last, begin = float(result[end - 1]), end
    return result


def dynamic(system, values: np.ndarray, interval: float) -> np.ndarray:
    """Return the response of the linear dynamics to a piecewise linear series, from steady state."""
    num, den, _ = cont2discrete(system, interval, method="foh")
    return values[0] + lfilter(np.ravel(num), den, values - values[0])


def valve(seed: int, parts=tuple(FIGURES)) -> IndependentValve:
    made = IndependentValve(seed)
    for part, make in (("characteristic", _sweep), ("step", _steps), ("frequency", _sines)):
        if part in parts:
            made.random = np.random.default_rng([seed, *part.encode()])
            make(made)
    return made


def _sweep(made: IndependentValve) -> None:
    random = made.random
    sweep, hold = random.uniform(12.0, 25.0), random.uniform(1.5, 3.0)
    times, levels = [0.0, hold], [0.0, 0.0]
    for _ in range(3):
        for end in (100.0, 0.0):
            times += [times[-1] + sweep, times[-1] + sweep + hold]
            levels += [end, end]
    finer = max(1, math.ceil(1000.0 / made.rate))
    fine = np.arange(round(times[-1] * made.rate) * finer) / (made.rate * finer)
    before = np.concatenate([np.linspace(0.0, 100.0, 2001), np.linspace(100.0, 0.0, 2001)])
    target = made.static(np.interp(fine - made.dead, times, levels), before)
    y = dynamic(made.system, target, fine[1])
    made.records["characteristic"] = [made.trace(fine[::finer], np.interp(fine[::finer], times, levels), y[::finer])]
    place = np.linspace(0.0, 100.0, 8001)
    curve = made.static(np.concatenate([place, place[::-1]]), before)
    up, down = curve[: place.size], curve[place.size :][::-1]
    inner = (place >= 10.0) & (place <= 90.0)
    mean = 0.5 * (up + down)[inner]
    line = np.polyval(np.polyfit(place[inner], mean, 1), place[inner])
    stops = [int(np.searchsorted(fine, times[k])) for k in (2, 6, 10)]
    rests = [int(np.searchsorted(fine, times[k])) - 1 for k in (3, 7, 11)]
    made.truth |= {
        "hysteresis": float(np.max((down - up)[inner])),
        "repeatability": 0.0,
        "zero_offset": float(down[0]),
        "linearity": float(np.max(np.abs(mean - line))),
        "accuracy": float(max(np.max(np.abs(curve - place)[inner]) for curve in (up, down))),
        "sweep_lag": float(np.mean(y[rests] - y[stops])),
    }


def _steps(made: IndependentValve) -> None:
    random = made.random
    fine, part = step(made.system, T=np.linspace(0.0, 3.0, 60_001))
    records = []
    for size in (80.0, *([10.0] if made.seed % 4 == 0 else [])):
        low, high = 50.0 - 0.5 * size, 50.0 + 0.5 * size
        starts = np.cumsum([0.6, 2.0, 2.0, 2.0])
        time = np.arange(round(8.6 * made.rate)) / made.rate
        if made.is_synchronous:
            starts = np.ceil(starts * made.rate) / made.rate
        else:
            starts = starts + random.uniform(0.0, 0.2, 4)
        x, y = np.full(time.size, low), np.full(time.size, 0.0)
        ends = made.static(np.array([low, high, low, high, low, high, low]), np.array([0.0, 100.0, 0.0]))[2:]
        y += ends[0]
        for k, start in enumerate(starts):
            x = np.where(time >= start - 1e-9, high if k % 2 == 0 else low, x)
            y += (ends[k + 1] - ends[k]) * np.interp(time - start - made.dead, fine, part, 0.0)
        records.append(made.trace(time, x, y))
    made.records["step"] = records

    def reaches(level: float) -> float:
        k = int(np.argmax(part >= level))
        return float(np.interp(level, part[k - 1 : k + 1], fine[k - 1 : k + 1]))

    last = float(fine[np.flatnonzero(np.abs(part - 1.0) > 0.05)[-1]])
    made.truth |= {
        "delay": made.dead + reaches(0.1), "rise_time_up": reaches(0.9) - reaches(0.1),
        "rise_time_down": reaches(0.9) - reaches(0.1), "response_time_up": made.dead + reaches(0.9),
        "response_time_down": made.dead + reaches(0.9), "settling_time": made.dead + last,
        "overshoot": 100.0 * max(float(np.max(part)) - 1.0, 0.0),
    }  # fmt: skip


def _sines(made: IndependentValve) -> None:
    random, size = made.random, 10.0

    def linear(f: float) -> complex:
        return complex(freqs(*made.system, worN=[2.0 * np.pi * f])[1][0]) * np.exp(-2j * np.pi * f * made.dead)

    turn = np.linspace(0.0, 8.0 * np.pi, 16001)
    x = 50.0 + size * np.sin(turn)
    wave = made.static(x, np.array([0.0, 100.0, 0.0]))
    period = slice(12000, 16000)
    waves = [2.0 * np.mean(wave[period] * np.exp(-1j * k * turn[period])) for k in range(1, 6)]
    describing = waves[0] * 1j / size
    grid = np.geomspace(0.02, 200.0, 4001)
    responses = np.array([linear(f) for f in grid]) * describing
    phases = np.unwrap(np.angle(responses))
    phase = float(np.exp(np.interp(np.pi / 2.0, -phases, np.log(grid))))
    lowest = 0.12 * phase
    gain = brentq(lambda f: abs(linear(f)) - abs(linear(lowest)) * 10.0**-0.15, 0.5 * phase, 20.0 * phase)
    highest = min(1.5 * max(gain, phase), made.rate / 9.0)
    records = []
    for f in np.geomspace(lowest, highest, 14):
        finer = max(1, math.ceil(400.0 * f / made.rate))
        rows = round((random.integers(5, 9) + 3.0 + random.uniform()) / f * made.rate)
        fine = np.arange(rows * finer) / (made.rate * finer)
        start = random.uniform(0.0, 6.28)
        setpoint = 50.0 + size * np.sin(2.0 * np.pi * f * fine + start)
        delayed = 50.0 + size * np.sin(2.0 * np.pi * f * (fine - made.dead) + start)
        y = dynamic(made.system, made.static(delayed, np.array([0.0, 100.0, 0.0])), fine[1])
        since = int(np.searchsorted(fine[::finer], 3.0 / f))
        records.append(made.trace(fine[::finer][since:], setpoint[::finer][since:], y[::finer][since:]))
    made.records["frequency"] = records
    made.truth["distortion"] = max(
        100.0 * math.hypot(*(abs(waves[k - 1] * linear(k * f)) for k in range(2, 6))) / abs(waves[0] * linear(f))
        for f in np.geomspace(lowest, highest, 14) if f <= gain
    )  # fmt: skip
    if highest > 1.05 * gain:
        made.truth["bandwidth_gain"] = gain
    if highest > 1.05 * phase:
        made.truth["bandwidth_phase"] = phase

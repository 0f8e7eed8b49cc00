"""Valves in closed form: their recordings and true characteristic values.

Only the classes `Record` and `Scale` come from the package.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field

import numpy as np
from scipy.optimize import brentq
from scipy.signal import lfilter

from poppet.bench.iso10094.scale import Record, Scale

SCALE = Scale(0.0, 10.0, "V", 1e5, 7e5)
NOISES = (200.0, 1000.0, 3000.0)  # [Pa]
RATES = (50.0, 100.0, 200.0, 500.0, 1000.0, 2000.0)  # [Hz]
NONE = np.zeros(0)


@dataclass
class Sensor:
    """Noise and resolution of a recorded channel; the noise is white or coloured."""

    random: np.random.Generator
    noise: float  # of the outlet [% FS]
    rate: float  # [Hz]
    colour: float  # part of the noise of a sample that the next one has
    step: float  # of the converter [% FS]

    def read(self, values: np.ndarray) -> np.ndarray:
        white = self.random.normal(0.0, self.noise * math.sqrt(1.0 - self.colour**2), values.size + 50)
        noisy = values + lfilter([1.0], [1.0, -self.colour], white)[50:]
        return noisy if self.step == 0.0 else np.round(noisy / self.step) * self.step

    def clock(self, duration: float) -> np.ndarray:
        return np.arange(0.0, duration, 1.0 / self.rate)

    def command(self, percent: np.ndarray) -> np.ndarray:
        """Return a setpoint in volts with a noise of 1 mV."""
        return np.round((0.1 * percent + self.random.normal(0.0, 1e-3, percent.size)) / 1e-3) * 1e-3


@dataclass
class KnownValve:
    """Records of one valve by test, and its true characteristic values."""

    records: dict[str, list[Record]] = field(default_factory=dict)
    truth: dict[str, float] = field(default_factory=dict)


def valve(seed: int, parts=()) -> KnownValve:
    """Return a random valve with its records; the selection of parts does not change their values."""
    known_valve = KnownValve()
    for part, make in MADE_BY.items():
        if parts and part not in parts and not (part == "resolution" and "reversal" in parts):
            continue
        random = np.random.default_rng([seed, *part.encode()])
        noise, rate = NOISES[seed % 3] / 6e3, float(random.choice(RATES))
        colour, step = float(random.choice([0.0, 0.0, 0.3, 0.6])), float(random.choice([0.0, 0.0, 100.0, 500.0])) / 6e3
        make(known_valve, random, Sensor(random, noise, rate, colour, step))
    return known_valve


def record(test: str, time, x, y, **series) -> Record:
    more = {name: series.pop(name, NONE) for name in ("supply", "flow", "consumption")}
    return Record(series.pop("name", test), test, time, x, SCALE.pressure(y), **more, **series)


def behind(values: np.ndarray, step: float, constant: float) -> np.ndarray:
    """Return the response of a first order to a piecewise linear series."""
    a = math.exp(-step / constant)
    late = 1.0 - (1.0 - a) * constant / step
    first = values[0]
    return first + lfilter([late, 1.0 - a - late], [1.0, -a], values - first)


def play(values: np.ndarray, width: float) -> np.ndarray:
    out, last = np.empty_like(values), values[0]
    for k, value in enumerate(values.tolist()):
        last = min(max(last, value - width / 2.0), value + width / 2.0)
        out[k] = last
    return out


def _sweep(known_valve: KnownValve, random, sensor: Sensor) -> None:
    zone, width, bow = random.uniform(1.7, 2.5), random.uniform(0.4, 2.5), random.uniform(-2.0, 2.0)
    offset, constant = random.uniform(0.1, 1.0), random.uniform(0.02, 0.1)
    shifts = np.concatenate([[0.0], random.uniform(-0.6, 0.6, 1), random.uniform(-0.6, 0.6, 1)])
    up_time, hold = random.uniform(15.0, 30.0), random.uniform(1.5, 3.0)
    ends = [0.0, hold]
    for _ in range(6):
        ends += [ends[-1] + up_time, ends[-1] + up_time + hold]
    levels = [0.0, 0.0, *[100.0, 100.0, 0.0, 0.0] * 3]
    time = sensor.clock(ends[-1])
    x = np.interp(time, ends, levels)
    cycle = ((time - 0.5 * hold) / (2.0 * (up_time + hold))).astype(int)
    shift = shifts[np.clip(cycle, 0, 2)]

    def static(moved, by=0.0):
        above = np.maximum(moved - zone, 0.0) * 100.0 / (100.0 - zone)
        return (
            offset
            + above
            + bow * 4.0 * above / 100.0 * (1.0 - above / 100.0)
            + by * np.clip((above - 5.6) / 0.7, 0.0, 1.0)
        )

    y = behind(static(play(x, width), shift), 1.0 / sensor.rate, constant)
    known_valve.records["characteristic"] = [record("characteristic", time, sensor.command(x), sensor.read(y))]
    place = np.linspace(10.0, 90.0, 4001)
    up, down = static(place - width / 2.0), static(place + width / 2.0)
    mean = 0.5 * (up + down)
    weights = np.ones(place.size)
    weights[[0, -1]] = math.sqrt(0.5)
    line = np.polyval(np.polyfit(place, mean, 1, w=weights), place)
    top = (static(np.array([100.0 - width / 2.0])) - static(np.array([99.9 - width / 2.0])))[0] / 0.1
    known_valve.truth |= {
        "hysteresis": float(np.max(down - up)),
        "linearity": float(np.max(np.abs(mean - line))),
        "repeatability": float(np.ptp(shifts)),
        "accuracy": float(max(np.max(np.abs(each + s - place)) for each in (up, down) for s in shifts)),
        "zero_suppression": zone + width / 2.0,
        "zero_offset": offset,
        "sweep_lag": 100.0 / up_time * constant * top,
    }


def _answer(time: np.ndarray, constant: float, damping: float) -> np.ndarray:
    """Return the closed form of a step response of first or second order."""
    t = np.maximum(time, 0.0)
    if damping >= 1.0:
        return 1.0 - np.exp(-t / constant)
    own = math.sqrt(1.0 - damping**2)
    s = t / constant
    return 1.0 - np.exp(-damping * s) * (np.cos(own * s) + damping / own * np.sin(own * s))


def _steps(known_valve: KnownValve, random, sensor: Sensor) -> None:
    constant, dead = random.uniform(0.04, 0.15), random.uniform(0.005, 0.03)
    damping = 2.0 if random.random() < 0.4 else random.uniform(0.45, 0.65)
    constant = constant if damping > 1.0 else 0.5 * constant
    low, high = 10.0, 90.0
    starts = np.cumsum([0.6, 2.0, 2.0, 2.0]) + random.uniform(0.0, 0.1, 4)
    time = sensor.clock(starts[-1] + 2.0)
    x, y = np.full(time.size, low), np.full(time.size, low)
    for start, sign in zip(starts, (1.0, -1.0, 1.0, -1.0), strict=True):
        x += sign * (high - low) * (time >= start)
        y += sign * (high - low) * _answer(time - start - dead, constant, damping)
    known_valve.records["step"] = [record("step", time, sensor.command(x), sensor.read(y), volume=1e-3)]
    fine = np.linspace(0.0, 60.0 * constant, 600_001)
    part = _answer(fine, constant, damping)

    def reaches(level: float) -> float:
        k = int(np.argmax(part >= level))
        return float(np.interp(level, part[k - 1 : k + 1], fine[k - 1 : k + 1]))

    last = int(np.flatnonzero(np.abs(part - 1.0) > 0.05)[-1])
    rise = reaches(0.9) - reaches(0.1)
    known_valve.truth |= {
        "delay": dead + reaches(0.1),
        "rise_time_up": rise, "rise_time_down": rise,
        "response_time_up": dead + reaches(0.9), "response_time_down": dead + reaches(0.9),
        "settling_time": dead + float(fine[last]),
        "overshoot": 100.0 * (float(np.max(part)) - 1.0) if damping < 1.0 else 0.0,
    }  # fmt: skip


def _limit_cycles(known_valve: KnownValve, random, sensor: Sensor) -> None:
    size, frequency = random.uniform(0.2, 1.0), random.uniform(3.0, 0.2 * min(sensor.rate, 200.0))
    time = sensor.clock(21.0)
    x = np.where(time < 1.0003, 10.0, 60.0)
    y = 10.0 + 50.0 * _answer(time - 1.0003, 0.05, 2.0) + size * np.sin(2.0 * np.pi * frequency * time + 1.0)
    known_valve.records["hum"] = [record("step", time, sensor.command(x), sensor.read(y))]
    known_valve.truth |= {"hum_amplitude": size, "hum_frequency": frequency}


def _sines(known_valve: KnownValve, random, sensor: Sensor) -> None:
    constant, dead, harmonic = random.uniform(0.03, 0.1), random.uniform(0.002, 0.02), random.uniform(0.02, 0.1)

    def answer(f):
        return np.exp(-2j * np.pi * f * dead) / (1.0 + 2j * np.pi * f * constant)

    f1 = 0.2 / constant / (2.0 * math.pi)
    gain = brentq(lambda f: 20.0 * math.log10(abs(answer(f)) / abs(answer(f1))) + 3.0, 0.01, 100.0)
    phase = brentq(
        lambda f: 2.0 * math.pi * f * dead + math.atan(2.0 * math.pi * f * constant) - math.pi / 2.0, 0.01, 500.0
    )
    highest = min(1.6 * max(gain, phase), sensor.rate / 9.0)
    records = []
    for f in np.geomspace(f1, max(highest, 2.0 * f1), 14):
        time = sensor.clock((random.integers(5, 9) + random.uniform(0.0, 1.0)) / f)
        turn = 2.0 * np.pi * f * time + random.uniform(0.0, 6.28)
        at = answer(f)
        wave = 10.0 * abs(at) * np.sin(turn + np.angle(at))
        wave += harmonic * 10.0 * abs(at) * np.sin(2.0 * turn + 0.7)
        x = 50.0 + 10.0 * np.sin(turn)
        records.append(record("frequency", time, sensor.command(x), sensor.read(50.0 + wave), name=f"{f:.3g} Hz"))
    known_valve.records["frequency"] = records
    known_valve.truth["distortion"] = 100.0 * harmonic
    if highest > 1.05 * gain:
        known_valve.truth["bandwidth_gain"] = gain
    if highest > 1.05 * phase:
        known_valve.truth["bandwidth_phase"] = phase


def _flows(known_valve: KnownValve, random, sensor: Sensor) -> None:
    known_valve.records["flow"] = []
    for sign, change, hysteresis in (
        (1.0, "flow_droop", "flow_hysteresis"),
        (-1.0, "relief_rise", "relief_hysteresis"),
    ):
        top, fall, bend = random.uniform(0.005, 0.03), random.uniform(14.0, 25.0), random.uniform(0.0, 0.3)
        width = random.uniform(0.03, 0.12)
        ramp, hold = random.uniform(10.0, 20.0), 2.0
        ends = np.cumsum([0.0, hold, ramp, hold, ramp, hold])
        time = sensor.clock(ends[-1])
        load = np.interp(time, ends, [0.0, 0.0, 1.0, 1.0, 0.0, 0.0])

        def droop(q, fall=fall, bend=bend):
            return fall * ((1.0 - bend) * q + bend * q * q)

        moved = play(load, width)
        y = behind(50.0 - sign * droop(moved), 1.0 / sensor.rate, 0.04)
        flow = sign * top * load + random.normal(0.0, 2e-3 * top, time.size)
        known_valve.records["flow"].append(
            record("flow", time, np.full(time.size, 5.0), sensor.read(y), flow=flow, name=change)
        )
        half = width / 2.0
        known_valve.truth[change] = float(0.5 * (droop(0.5 - half) + droop(0.5 + half)))
        grid = np.linspace(0.1, 0.9, 2001)
        going, coming = droop(np.maximum(grid - half, 0.0)), droop(np.minimum(grid + half, 1.0 - half))
        known_valve.truth[hysteresis] = float(np.max(coming - going))
        if sign > 0.0:
            known_valve.truth["flow_capacity"] = top * (brentq(lambda q: droop(q) - 10.0, 0.0, 1.0) + half)


def _supply(known_valve: KnownValve, random, sensor: Sensor) -> None:
    slope, width = random.uniform(0.01, 0.05) * random.choice([-1.0, 1.0]), random.uniform(0.1, 0.6)
    ramp, hold = random.uniform(10.0, 20.0), 2.0
    ends = np.cumsum([0.0, hold, ramp, hold, ramp, hold, ramp, hold, ramp, hold])
    time = sensor.clock(ends[-1])
    supply = np.interp(time, ends, [5.5e5, 5.5e5, *[9e5, 9e5, 5.5e5, 5.5e5] * 2])
    # Half of the width to either side, as soon as the supply has turned by a hundredth of its range.
    turned = 3.5e3
    loose = (supply - play(np.concatenate([supply, supply]), 2.0 * turned)[time.size :]) / turned
    y = behind(50.0 + 100.0 * slope * (supply - 7e5) / 6e5 + 0.5 * width * loose, 1.0 / sensor.rate, 0.04)
    noisy = supply + random.normal(0.0, 500.0, time.size)
    known_valve.records["supply"] = [record("supply", time, np.full(time.size, 5.0), sensor.read(y), supply=noisy)]
    known_valve.truth |= {"supply_sensitivity": slope, "supply_hysteresis": width}


def _leak(known_valve: KnownValve, random, sensor: Sensor) -> None:
    leak = random.uniform(1e-6, 1e-5)
    time = sensor.clock(20.0)
    flow = leak + lfilter([1.0], [1.0, -sensor.colour], random.normal(0.0, 0.2 * leak, time.size))
    y = sensor.read(np.full(time.size, 50.0))
    known_valve.records["leakage"] = [record("leakage", time, np.full(time.size, 5.0), y, consumption=flow)]
    known_valve.truth["leakage"] = leak


def _stairs(known_valve: KnownValve, random, sensor: Sensor) -> None:
    stair = random.uniform(0.1, 0.2) * max(1.0, 15.0 * sensor.noise)
    hold = max(1.0, 60.0 / sensor.rate) * (2.0 if sensor.colour else 1.0)
    ways = np.concatenate([np.ones(40), -np.ones(40), np.ones(40)])
    levels = 40.0 + stair * np.concatenate([[0.0], np.cumsum(ways)])
    time = sensor.clock(hold * levels.size)
    x = levels[np.minimum((time / hold).astype(int), levels.size - 1)]
    threshold, width = stair * random.uniform(1.5, 8.0), stair * random.uniform(2.0, 10.0)
    stuck, last = np.empty(levels.size), levels[0]
    for k, level in enumerate(levels.tolist()):
        last = level if abs(level - last) >= threshold else last
        stuck[k] = last
    loose = play(np.concatenate([[levels[0] - 2.0 * width], levels]), width)[1:]
    for name, outlet in (("resolution", stuck), ("reversal", loose)):
        y = behind(outlet[np.minimum((time / hold).astype(int), levels.size - 1)], 1.0 / sensor.rate, 0.03)
        volts = np.round(0.1 * x / 1e-4) * 1e-4
        known_valve.records[name] = [record("resolution", time, volts, sensor.read(y))]
    known_valve.truth |= {"resolution": threshold, "reversal_threshold": width}


FIGURES_OF = {
    "characteristic": (
        "linearity", "hysteresis", "repeatability", "accuracy", "zero_suppression", "zero_offset", "sweep_lag",
    ),
    "step": (
        "delay", "rise_time_up", "response_time_up", "rise_time_down", "response_time_down", "settling_time",
        "overshoot",
    ),
    "hum": ("hum_amplitude", "hum_frequency"),
    "frequency": ("bandwidth_gain", "bandwidth_phase", "distortion"),
    "flow": ("flow_droop", "flow_hysteresis", "flow_capacity", "relief_rise", "relief_hysteresis"),
    "supply": ("supply_sensitivity", "supply_hysteresis"),
    "leakage": ("leakage",),
    "resolution": ("resolution",),
    "reversal": ("reversal_threshold",),
}  # fmt: skip
"""Mapping from each part to the characteristic values that its records determine."""
TEST_OF = {"hum": "step", "reversal": "resolution"}
MADE_BY = {
    "characteristic": _sweep, "step": _steps, "hum": _limit_cycles, "frequency": _sines, "flow": _flows,
    "supply": _supply, "leakage": _leak, "resolution": _stairs,
}  # fmt: skip

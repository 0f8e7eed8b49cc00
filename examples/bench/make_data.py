"""Write recordings of a virtual valve with known characteristic values, as a test bench would."""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

from poppet.bench.iso10094.evaluation import Trial
from poppet.bench.iso10094.flow import flow_trial
from poppet.bench.iso10094.scale import Scale
from poppet.bench.iso10094.virtual_valve import VirtualValve
from poppet.signals import Points, Steps

VOLTS = Scale(0.0, 10.0, "V", 1e5, 7e5)
TRUTH = VirtualValve(
    scale=VOLTS, time_constant=0.05, dead_time=0.01, dead_zone=2.0, play=0.8, bow=1.0, droop=6.0, full_flow=0.01
)
LINEAR = VirtualValve(scale=VOLTS, time_constant=0.05, dead_time=0.01)
FREQUENCIES = (0.5, 1.0, 2.0, 2.5, 3.15, 4.0, 5.0, 6.3, 8.0)
NOISE = {"w": (5e-4, 1e-3), "p2": (6e-4, 1.5e-4), "q": (2e-3, 1e-3)}
"""Standard deviation and resolution of each column: V, bar, g/s."""


def sweep() -> Trial:
    """Return three slow cycles."""
    times, values = [0.0, 2.0], [0.0, 0.0]
    for end in (10.0, 0.0) * 3:
        times += [times[-1] + 40.0, times[-1] + 42.0]
        values += [end, end]
    return Trial("characteristic", "sweep", Points(times, values), times[-1], 0.0, 0.025, 1e-3)


def steps() -> Trial:
    """Return a large and a small step, up and down."""
    times, values = [0.0, 0.5123, 1.5123, 2.5123, 3.5123], [1.0, 9.0, 1.0, 5.0, 1.0]
    return Trial("step", "steps", Steps(times, values), 4.5, 0.0, 2e-3, 1e-3)


def sines() -> Trial:
    """Return eight periods of each frequency in sequence, as a table of points."""
    clock, values, start = [], [], 0.0
    for frequency in FREQUENCIES:
        length = 8.0 / frequency
        part = np.arange(0.0, length, 1.0 / (100.0 * frequency))
        clock.append(start + part)
        values.append(5.0 + 0.5 * np.sin(2.0 * math.pi * frequency * part))
        start += length
    return Trial("frequency", "sines", Points(np.concatenate(clock), np.concatenate(values)), start, 0.0, 6e-3, 1e-3)


def write(folder: Path, name: str, valve: VirtualValve, trial: Trial, seed: int) -> None:
    """Simulate the response, add noise, round, and write the recording."""
    record, random = valve.respond(trial), np.random.default_rng(seed)
    columns = {"w": record.setpoint, "p2": (record.outlet - 1e5) / 1e5}
    if trial.kind == "flow":
        columns = {"p2": columns["p2"], "q": 1e3 * record.flow}
    lines = ["t," + ",".join(columns)]
    noisy = []
    for key, series in columns.items():
        noise, step = NOISE[key]
        noisy.append(np.round((series + random.normal(0.0, noise, series.size)) / step) * step)
    rows = zip(record.time, *noisy, strict=True)
    lines += [f"{row[0]:.4f}," + ",".join(f"{value:.5g}" for value in row[1:]) for row in rows]
    (folder / f"{name}.csv").write_text("\n".join(lines) + "\n", encoding="utf-8")


def main(folder: Path) -> None:
    """Write all recordings."""
    write(folder, "sweep", TRUTH, sweep(), 1)
    write(folder, "steps", LINEAR, steps(), 2)
    write(folder, "sines", LINEAR, sines(), 3)
    draw = replace(flow_trial(VOLTS, 1e-3, 50.0, 20.0, 1.0, 1.0), step=0.02)
    write(folder, "draw", TRUTH, draw, 4)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).parent)

"""Write the recordings of `examples/watch`, simulated by NumPy without `poppet`.

`python tests/watch_example.py examples/watch` writes both files.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).with_name("exact")))
from independent_watch_tank import HEALTHY, ONE_PERCENT, SAMPLE_TIME, Sensors, random_openings, readings, simulate

PLANT = replace(HEALTHY, barometer=1.004e5, valve=0.97 * HEALTHY.valve, wall_conductance=5.0, supply_temperature=291.15)
"""Plant that differs from its circuit file by nuisances."""
SENSORS = Sensors(noise=400.0, is_gauge=True, resolution=100.0)
LEAK_START, LEAK = 200.0, HEALTHY.leak + ONE_PERCENT
"""Start of the leak of the day [s] and its conductance [m^3/(s Pa)]."""
DURATIONS = {"healthy.csv": 240.0, "day.csv": 300.0}


def write(folder: Path) -> None:
    """Write the recordings of a healthy plant, and of a day on which a leak appears."""
    for seed, (name, duration) in enumerate(DURATIONS.items(), 290):
        samples = round(duration / SAMPLE_TIME)
        openings = np.round(random_openings(range(seed, seed + 1), samples), 2)
        time = SAMPLE_TIME * np.arange(samples)
        leak = np.where((name == "day.csv") & (time >= LEAK_START), LEAK, PLANT.leak)[np.newaxis]
        course = simulate(PLANT, openings, leak)
        pressure = readings(PLANT, course, SENSORS, range(seed, seed + 1))[0, :, 0] / 1e5
        columns = np.column_stack([time, pressure, course.openings[0]])
        np.savetxt(folder / name, columns, ("%.1f", "%.3f", "%.2f", "%.2f"), ",", header="t,p,u,w", comments="")


if __name__ == "__main__":
    write(Path(sys.argv[1]))

"""The complete valve at half the default tolerance: no figure of its staircase moves.

On tanks of a litre and less, the loops of the library set hunt: a sample on one side of a step of the converter or the
other makes another pulse, and figures of single runs there scatter by more than this, at any tolerance.
"""

from __future__ import annotations

import numpy as np
import pytest

from poppet import Circuit
from poppet.parts import Chamber, ProportionalValve, Reservoir
from poppet.signals import Steps
from poppet.timeseries.recording import Recording

TIMES, LEVELS = [0.0, 30.0, 60.0, 90.0], [2e5, 3e5, 4e5, 5e5]
STEP = 1e6 / 2**12
"""One step of the converter [Pa]."""


def staircase(preset: str) -> Circuit:
    parts = {
        "supply": Reservoir(pressure="7 bar"),
        "valve": ProportionalValve(data="vppm_6l", preset=preset, supply="supply", outlet="tank", exhaust="ambient"),
        "tank": Chamber(volume="0.2 m^3", wall_conductance="45 W/K"),
    }
    return Circuit(parts, {"valve.setpoint": Steps(TIMES, LEVELS)})


def figures(run: Recording) -> tuple[list[float], list[float]]:
    """Of every step the mean at its end and the peak [Pa], and the time from 10 % to 90 % [s]."""
    pressures, times = [], []
    for begin, end in zip(TIMES, [*TIMES[1:], 120.0], strict=True):
        inside = (run.time >= begin) & (run.time < end)
        time, pressure = run.time[inside], run["tank.pressure"][inside]
        final = float(np.mean(pressure[time > end - 5.0]))
        sign = np.sign(final - pressure[0])
        pressures += [final, float(sign * np.max(sign * pressure))]
        risen = sign * (pressure - pressure[0])
        crossings = []
        for part in (0.1, 0.9):
            k = int(np.argmax(risen >= part * abs(final - pressure[0])))
            crossings.append(np.interp(part * abs(final - pressure[0]), risen[k - 1 : k + 1], time[k - 1 : k + 1]))
        times.append(float(crossings[1] - crossings[0]))
    return pressures, times


@pytest.mark.parametrize("preset", ["universal", "fast", "precise"])
def test_half_the_tolerance_moves_no_figure(preset):
    circuit = staircase(preset)
    own, finer = (figures(circuit.simulate(120.0, 0.02, tolerance)) for tolerance in (1e-6, 5e-7))
    assert np.max(np.abs(np.subtract(own[0], finer[0]))) < STEP
    assert np.max(np.abs(np.divide(own[1], finer[1]) - 1.0)) < 5e-3
    assert np.max(np.abs(np.array(own[0][::2]) - LEVELS)) < 0.02e5

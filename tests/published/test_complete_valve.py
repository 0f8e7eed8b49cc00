"""The complete valve where the paper leaves off: a staircase into its tank, and how much pilot and electronics cost."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import pytest

import poppet
from poppet import Chamber, Circuit, Recording, Reservoir
from poppet.parts import MainStage, ProportionalValve
from poppet.parts.electronics import PRESETS
from poppet.signals import Steps

SPAN = 6e5
FILE = Path(__file__).parents[2] / "examples" / "pressure_regulator.toml"
PLATEAUS = ((0.0, 30.0, 2e5), (30.0, 60.0, 3e5), (60.0, 90.0, 4e5), (90.0, 120.0, 5e5))


def last_seconds(recording: Recording) -> list[float]:
    """Largest distance from each setpoint in the last five seconds of its plateau [Pa]."""
    p, t = recording["tank.pressure"], recording.time
    return [float(np.max(np.abs(p[(t >= end - 5.0) & (t < end)] - value))) for _, end, value in PLATEAUS]


@pytest.mark.parametrize("drive", ["averaged", "switched"])
@pytest.mark.parametrize("preset", PRESETS)
def test_the_staircase_is_reached_and_held(preset, drive):
    circuit = poppet.load(FILE).with_values({"valve.preset": preset, "valve.pilot.drive": drive})
    recording = circuit.simulate()
    assert max(last_seconds(recording)) < 0.01 * SPAN
    assert not recording.notes or all("outside 0 ... 1.00 mm" in note for note in recording.notes)


def test_where_the_conductance_does_not_allow_it_the_run_says_so():
    recording = poppet.load(FILE).with_values({"tank.volume": "0.4 m^3"}).simulate()
    missed = [note for note in recording.remarks if note.code == "valve.not_reached"]
    allowed = [error > 0.01 * SPAN for error in last_seconds(recording)]
    assert len(missed) == sum(allowed) > 0


def rise(recording: Recording, start: float, low: float, high: float) -> float:
    """Time from the step to 90 % of it [s]."""
    reached = recording["tank.pressure"] >= low + 0.9 * (high - low)
    return float(recording.time[np.argmax(reached)] - start)


def step(
    part: Any, signal: str, values: tuple[float, float], start_pressure: float, volume: float, span: float
) -> Recording:
    tank = Chamber(volume=volume, wall_conductance=45.0 * (volume / 0.2) ** (2 / 3), initial_pressure=start_pressure)
    parts = {"supply": Reservoir(pressure=7e5), "valve": part, "tank": tank}
    circuit = Circuit(parts, {signal: Steps([0.0, 0.1 * span], list(values))})
    return circuit.simulate(1.1 * span, span / 20000)


FACTORS = {
    (1e-4, 0.1): (0.6, 17.1), (1e-4, 0.5): (0.6, 5.61), (1e-4, 1.0): (0.6, 4.75),
    (1e-3, 0.1): (5.0, 1.72), (1e-3, 0.5): (5.0, 1.01), (1e-3, 1.0): (5.0, 1.00),
    (0.2, 0.1): (250.0, 1.00), (0.2, 0.5): (250.0, 1.00), (0.2, 1.0): (250.0, 1.00),
}  # fmt: skip
"""Volume [m3] and part of the span: length of the run [s], and how much slower the complete valve is."""


@pytest.mark.parametrize(("case", "expected"), FACTORS.items())
def test_pilot_and_electronics_make_the_valve_slower(case, expected):
    (volume, part), (span, factor) = case, expected
    low = 1.12e5 if part == 1.0 else 1.1e5 + (0.5 - part / 2.0) * 5.8e5
    high = 6.5e5 if part == 1.0 else low + part * 5.8e5
    ports = {"supply": "supply", "outlet": "tank", "exhaust": "ambient", "data": "vppm_6l"}
    valve = ProportionalValve(**ports, pilot={"initial_pressure": low + 1.13e4})
    whole = step(valve, "valve.setpoint", (low, high), low, volume, span)
    # The bare stage gets at once what holds the new pressure: 14 N of preload on 7.07 cm2 above it.
    bare = MainStage(**ports, mode="regulator")
    ideal = step(bare, "valve.pilot_pressure", (low + 1.13e4, high + 1.98e4), low, volume, span)
    found = rise(whole, 0.1 * span, low, high) / rise(ideal, 0.1 * span, low, high)
    # A large tank waits for the flow, not for the pilot, and the electronics hold the poppet open for longer.
    assert found > (1.05 if factor > 1.05 else 0.995)
    assert found == pytest.approx(factor, rel=0.05)


@pytest.mark.parametrize("volume", ["0.1 l", "1 l", "0.2 m^3"])
def test_halving_the_tolerance_moves_no_figure(volume):
    """Within 0.5 % of the span, or one step of the converter: 0.244 kPa."""
    circuit = poppet.load(FILE).with_values({"tank.volume": volume})
    loose, tight = (circuit.simulate(relative_tolerance=tolerance) for tolerance in (1e-6, 5e-7))
    ends = [int(np.searchsorted(loose.time, end - 0.05)) for _, end, _ in PLATEAUS]
    moved = np.abs(loose["tank.pressure"][ends] - tight["tank.pressure"][ends])
    assert np.max(moved) < 0.005 * SPAN

"""Random networks with logic valves and one-way valves: balances, entropy, and direction of each flow."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from poppet import Chamber, PilotedCheckValve
from poppet.timeseries.recording import Recording

sys.path.insert(0, str(Path(__file__).parent))
from seeded_logic import random_logic

MAX_STEPS = 50_000
"""Integration steps of one run; a valve between two chambers that it discharges in turn switches often."""


def entropy(recording: Recording, chambers: list[str]) -> np.ndarray:
    """Return the sum of m (cp ln T - R ln p) over all chambers."""
    values = (
        recording[f"{name}.mass"]
        * (1004.675 * np.log(recording[f"{name}.temperature"]) - 287.05 * np.log(recording[f"{name}.pressure"]))
        for name in chambers
    )
    return np.asarray(sum(values))


@pytest.mark.parametrize(
    ("topologies", "draws"), [(12, 25), pytest.param(100, 100, marks=pytest.mark.slow)], ids=["part", "all"]
)
def test_random_networks_keep_balances_and_the_second_law(topologies: int, draws: int) -> None:
    count = repeated = 0
    for circuit in random_logic(1219, topologies, draws):
        recording = circuit.simulate(1.0, 0.02)
        count += 1
        chambers = [name for name, part in circuit.parts.items() if isinstance(part, Chamber)]
        assert np.isfinite(recording.values).all(), count
        assert min(recording[f"{name}.pressure"].min() for name in chambers) > 0.0
        assert all(residual.is_kept for residual in recording.residuals), count
        mass = sum(recording[f"{name}.mass"] for name in chambers)
        assert np.abs(mass / mass[0] - 1.0).max() < 1e-9
        assert np.diff(entropy(recording, chambers)).min() > -1e-6 * mass[0] * 287.05, count
        assert sum(recording.statistics.values()) < MAX_STEPS, count
        repeated += any(note.code == "run.repeated" for note in recording.remarks)
        for name, part in circuit.parts.items():
            if name in chambers:
                continue
            ports = {port: node for port, node in part.ports().items() if port not in part.pilot_ports}
            paths = {"mass_flow_rate": tuple(ports)}
            if len(ports) == 3:
                last = "exhaust" if "exhaust" in ports else "b"
                first = "inlet" if "exhaust" in ports else "a"
                paths = {f"{first}_mass_flow_rate": (first, "outlet")}
                paths[f"{last}_mass_flow_rate"] = ("outlet", last) if last == "exhaust" else (last, "outlet")
            for output, (first, second) in paths.items():
                drop = recording[f"{ports[first]}.pressure"] - recording[f"{ports[second]}.pressure"]
                flow = recording[f"{name}.{output}"]
                assert np.all(flow * drop >= 0.0), (count, name)
                if first == "inlet" or isinstance(part, PilotedCheckValve):
                    closed = recording[f"{name}.opening"] == 0.0 if first != "inlet" else True
                    assert np.all(flow[closed & (drop < 0.0)] == 0.0), (count, name)
    assert count == topologies * draws
    assert repeated <= 0.02 * count

"""Random networks with logic valves and one-way valves: balances, entropy, and direction of each flow."""

from __future__ import annotations

import sys
from pathlib import Path

import numpy as np
import pytest

from poppet import Chamber, PilotedCheckValve, QuickExhaustValve
from poppet.parts.logic_valves import TwoInletValve
from poppet.parts.part import Part
from poppet.timeseries.recording import Recording

sys.path.insert(0, str(Path(__file__).parent))
from seeded_logic import random_logic

MAX_STEPS = 500_000
"""Steps of one run; an element with a switching pressure of a millibar can move to and fro for the whole run."""
REPEATED = 0.005
"""Fraction of runs that are repeated with a smaller tolerance."""


def entropy(recording: Recording, chambers: list[str]) -> np.ndarray:
    """Return the sum of m (cp ln T - R ln p) over all chambers."""
    values = (
        recording[f"{name}.mass"]
        * (1004.675 * np.log(recording[f"{name}.temperature"]) - 287.05 * np.log(recording[f"{name}.pressure"]))
        for name in chambers
    )
    return np.asarray(sum(values))


def paths(part: Part) -> dict[str, tuple[str, str]]:
    """Return the two ports of each flow of a part, by output."""
    if isinstance(part, TwoInletValve):
        ends = {"a_": ("a", "outlet"), "b_": ("b", "outlet")}
    elif isinstance(part, QuickExhaustValve):
        ends = {"inlet_": ("inlet", "outlet"), "exhaust_": ("outlet", "exhaust")}
    else:
        ends = {"": ("from", "to")}
    return {f"{prefix}mass_flow_rate": ports for prefix, ports in ends.items()}


def check_directions(recording: Recording, name: str, part: Part) -> None:
    """No flow against the pressure, none through a closed one-way path, and none between two inlets."""
    ports = part.ports()
    flows = {}
    for output, ends in paths(part).items():
        first, second = (recording[f"{ports[end]}.pressure"] for end in ends)
        flows[output] = recording[f"{name}.{output}"]
        assert np.all(flows[output] * (first - second) >= 0.0)
        if isinstance(part, PilotedCheckValve):
            assert np.all(flows[output][recording[f"{name}.opening"] == 0.0] >= 0.0)
        elif output == "inlet_mass_flow_rate":
            assert np.all(flows[output] >= 0.0)
    if isinstance(part, TwoInletValve):
        from_a, from_b = flows.values()
        assert np.all(from_a * from_b >= 0.0)


@pytest.mark.parametrize(
    ("topologies", "draws"), [(12, 25), pytest.param(100, 100, marks=pytest.mark.slow)], ids=["part", "all"]
)
def test_random_networks_keep_balances_and_the_second_law(topologies: int, draws: int) -> None:
    count = repeated = most = 0
    for circuit in random_logic(1219, topologies, draws):
        recording = circuit.simulate(1.0, 0.02)
        chambers = [name for name, part in circuit.parts.items() if isinstance(part, Chamber)]
        assert np.isfinite(recording.values).all(), count
        assert min(recording[f"{name}.pressure"].min() for name in chambers) > 0.0, count
        assert all(residual.is_kept for residual in recording.residuals), count
        mass = sum(recording[f"{name}.mass"] for name in chambers)
        assert np.abs(mass / mass[0] - 1.0).max() < 1e-9, count
        assert np.diff(entropy(recording, chambers)).min() > -1e-6 * mass[0] * 287.05, count
        for name, part in circuit.parts.items():
            if name not in chambers:
                check_directions(recording, name, part)
        most = max(most, sum(recording.statistics.values()))
        repeated += any(note.code == "run.repeated" for note in recording.remarks)
        count += 1
    assert count == topologies * draws
    assert most < MAX_STEPS
    assert repeated <= REPEATED * count

"""Laws of sampled circuits: random cascades follow a plain loop, random valves never fail."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from poppet import Circuit
from poppet.engine.balances import residuals
from poppet.engine.problem import Outcome
from poppet.engine.reference_solvers.track import rounding
from poppet.engine.solve import solve
from poppet.signals import Steps

sys.path.insert(0, str(Path(__file__).parent))
sys.path.insert(0, str(Path(__file__).parents[1] / "unit"))
from sampled_parts import Lag, Proportional
from seeded_valves import valves

DURATION, TOLERANCE = 2.0, 1e-10

periods = st.one_of(
    st.sampled_from([0.01, 0.03, 0.07, 0.1, 0.25, 0.3]), st.floats(0.01, 0.5), st.just(0.1 * 2**0.5), st.just(1 / 3)
)
stages = st.lists(st.tuples(st.floats(-0.9, 0.9), periods, st.floats(1e-3, 1.0)), min_size=1, max_size=3)
steps = st.lists(st.tuples(st.floats(0.01, 1.99), st.floats(-1.0, 1.0)), max_size=3, unique_by=lambda pair: pair[0])


def cascade(found: list[tuple[float, float, float]], signal: Steps) -> Circuit:
    """Controllers one behind the other, each around a lag of its own: its output is the next one's setpoint."""
    parts: dict[str, Any] = {}
    connections = {}
    for k, (gain, period, time_constant) in enumerate(found):
        parts |= {f"c{k}": Proportional(gain=gain, sample_time=period), f"l{k}": Lag(time_constant=time_constant)}
        connections |= {f"c{k}.measured": f"l{k}.output", f"l{k}.input": f"c{k}.output"}
        if k:
            connections[f"c{k}.wanted"] = f"c{k - 1}.output"
    return Circuit(parts, {"c0.wanted": signal}, connections=connections)


def plain_loop(found: list[tuple[float, float, float]], signal: Steps, until: float) -> tuple[list[float], list[float]]:
    """Outputs of controllers and lags at the end, by a loop over instants; lags move by their exact solution."""
    gains, sample_times, time_constants = (list(column) for column in zip(*found, strict=True))
    held, lags, counts, now = [0.0] * len(found), [0.0] * len(found), [0] * len(found), 0.0
    while True:
        instant = min(count * period for count, period in zip(counts, sample_times, strict=True))
        end = min(instant, until)
        for k, time_constant in enumerate(time_constants):
            lags[k] = held[k] + (lags[k] - held[k]) * float(np.exp(-(end - now) / time_constant))
        now = end
        if instant >= until - rounding(until):
            return held, lags
        place = int(np.searchsorted(signal.times, now + rounding(now), side="right")) - 1
        for k, period in enumerate(sample_times):
            if counts[k] * period <= now + rounding(now):
                wanted = held[k - 1] if k else float(signal.values[place])
                held[k], counts[k] = gains[k] * (wanted - lags[k]), counts[k] + 1


@settings(max_examples=150, deadline=None, derandomize=True)
@given(found=stages, values=steps)
def test_a_cascade_of_samplers_follows_a_plain_loop(found, values):
    times, levels = zip((0.0, 1.0), *sorted(values), strict=True)
    signal = Steps(list(times), list(levels))
    run = cascade(found, signal).simulate(DURATION, 0.1, TOLERANCE)
    held, lags = plain_loop(found, signal, DURATION)
    for k in range(len(found)):
        assert run[f"c{k}.output"][-1] == pytest.approx(held[k], abs=1e-8)
        assert run[f"l{k}.output"][-1] == pytest.approx(lags[k], abs=1e-8)


@pytest.mark.parametrize("count", [40, pytest.param(2000, marks=pytest.mark.slow)])
def test_random_valves_never_fail(count: int) -> None:
    for problem, drawn in valves(np.random.default_rng(2012), count):
        run = solve(problem, repeats_stalled=False)
        assert run.outcome is Outcome.DONE, drawn
        assert np.isfinite(run.values).all(), drawn
        assert all(residual.is_kept for residual in residuals(problem, run)), drawn
        assert np.all(run.extremes[0][: problem.kernel.positive.size][problem.kernel.positive] > 0.0), drawn

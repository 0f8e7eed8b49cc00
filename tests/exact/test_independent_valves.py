"""Tests of the bench with independent valves: distributed hysteresis, curved characteristic, second and third order."""

from __future__ import annotations

from collections import Counter

import numpy as np
import pytest

from exact.independent_valves import FIGURES, Trace, valve
from poppet.bench.iso10094.bench_result import TESTS
from poppet.bench.iso10094.plausibility import without_spikes
from poppet.bench.iso10094.scale import Record, Scale
from poppet.bench.iso10094.valve_recordings import find_clipped_samples

SCALE = Scale(0.0, 10.0, "V", 1e5, 7e5)
NONE = np.zeros(0)


def record_of(test: str, number: int, trace: Trace) -> Record:
    """Return a record of a trace as it is read from a file."""
    outlet, _ = without_spikes(1e5 + 1e5 * trace.outlet)
    cut = find_clipped_samples({"setpoint": SCALE.setpoint_percent(trace.setpoint), "outlet": SCALE.percent(outlet)})
    return Record(f"{test} {number}", test, trace.time, trace.setpoint, outlet, NONE, NONE, NONE, clipped=cut)


def count_covered(seeds, parts=tuple(FIGURES)) -> dict[str, Counter]:
    """Count the intervals of each value that contain the true value, those that do not, and the other results."""
    counts: dict[str, Counter] = {}
    for seed in seeds:
        known_valve = valve(seed, parts)
        for part in parts:
            records = [record_of(part, k, trace) for k, trace in enumerate(known_valve.records[part])]
            figures = TESTS[part].evaluate_records(records, SCALE).figures
            for name in (name for name in FIGURES[part] if name in known_valve.truth):
                figure, truth = figures.get(name), known_valve.truth[name]
                if figure is None or (figure.interval is None and not figure.bound):
                    result = "absent"
                elif figure.bound:
                    is_right = truth <= figure.value if figure.bound == "at most" else truth >= figure.value
                    result = "bound" if is_right else "wrong bound"
                else:
                    result = "held" if figure.interval[0] <= truth <= figure.interval[1] else "missed"
                counts.setdefault(name, Counter())[result] += 1
    return counts


def test_intervals_of_independent_valves_contain_the_true_values():
    """At least two of three intervals contain the true value."""
    for name, counts in count_covered(range(2000, 2003)).items():
        assert counts["missed"] + counts["wrong bound"] <= 1, name


@pytest.mark.parametrize("seed", [6, 30])
def test_lag_of_curved_characteristic_is_not_extrapolated(seed):
    """The sweep ends in the bend of the characteristic, and the noise is small."""
    counts = count_covered([seed], ("characteristic",))
    assert counts["sweep_lag"]["held"] == 1


def test_delay_of_synchronous_setpoint_is_within_its_interval():
    seeds = [seed for seed in range(36) if valve(seed, ()).is_synchronous][:4]
    assert count_covered(seeds, ("step",))["delay"]["missed"] == 0


def test_single_spike_is_no_settling_time():
    seeds = [seed for seed in range(20) if valve(seed, ()).has_spike]
    counts = count_covered(seeds, ("step",))["settling_time"]
    assert counts["held"] >= len(seeds) - 1


@pytest.mark.slow
def test_coverage_of_intervals_of_a_hundred_independent_valves():
    """The counts agree with docs/bench_definitions.md: at least 95 % less three standard deviations are right."""
    for name, counts in count_covered(range(8200, 8300)).items():
        print(f"| `{name}` |", " | ".join(str(counts[key]) for key in ("held", "missed", "bound", "wrong bound")), "|")
        right, total = counts["held"] + counts["bound"], counts.total() - counts["absent"]
        assert right >= 0.95 * total - 3.0 * np.sqrt(0.95 * 0.05 * total), name

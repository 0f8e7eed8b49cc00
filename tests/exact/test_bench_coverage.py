"""Tests of the coverage of the 95 % intervals with valves in closed form."""

from __future__ import annotations

from collections import Counter
from dataclasses import dataclass, field

import numpy as np
import pytest

from exact.known_valves import FIGURES_OF, SCALE, TEST_OF, KnownValve, valve
from poppet.bench.iso10094.bench_result import DEFINITIONS, TESTS


@dataclass
class CoverageCounts:
    """Counts of the evaluations of one characteristic value of many valves."""

    held: int = 0  # true values within the interval
    given: int = 0  # intervals
    bounds: Counter = field(default_factory=Counter)  # true to whether a bound was right
    withheld: int = 0
    distances: list[float] = field(default_factory=list)  # from the truth, in standard uncertainties

    def take(self, figure, truth: float) -> None:
        if figure is None or (figure.interval is None and not figure.bound):
            self.withheld += 1
        elif figure.bound:
            self.bounds[truth <= figure.value if figure.bound == "at most" else truth >= figure.value] += 1
        else:
            self.given += 1
            self.held += figure.interval[0] <= truth <= figure.interval[1]
            self.distances.append((figure.value - truth) / max(figure.uncertainty, 1e-300))


def count_covered(seeds, parts=tuple(FIGURES_OF)) -> dict[str, CoverageCounts]:
    counts_by_name: dict[str, CoverageCounts] = {}
    for seed in seeds:
        known_valve: KnownValve = valve(seed, parts)
        for part in parts:
            figures = TESTS[TEST_OF.get(part, part)].evaluate_records(known_valve.records[part], SCALE).figures
            for name in (name for name in FIGURES_OF[part] if name in known_valve.truth):
                counts_by_name.setdefault(name, CoverageCounts()).take(figures.get(name), known_valve.truth[name])
    return counts_by_name


def test_all_values_are_counted():
    assert sorted(name for names in FIGURES_OF.values() for name in names) == sorted(DEFINITIONS)


@pytest.mark.parametrize("part", FIGURES_OF)
def test_intervals_of_three_valves_contain_the_true_values(part):
    """At least two of three intervals contain the true value, and no deviation is large."""
    for name, counts in count_covered(range(9000, 9003), (part,)).items():
        assert counts.given + counts.bounds.total() + counts.withheld > 0, name
        assert counts.given - counts.held <= 1, name
        assert max(map(abs, counts.distances), default=0.0) < 6.0, name
        assert counts.bounds[False] <= 1, name


@pytest.mark.slow
def test_coverage_of_intervals_of_two_hundred_valves():
    """The counts agree with the table of docs/bench_definitions.md."""
    for name, counts in count_covered(range(9000, 9200)).items():
        share = 100.0 * counts.held / max(1, counts.given)
        rms = float(np.sqrt(np.mean(np.square(counts.distances)))) if counts.distances else 0.0
        bounds = f"{counts.bounds.total()} | {counts.bounds[False]} | {counts.withheld}"
        print(f"| `{name}` | {counts.given} | {share:.1f} | {rms:.2f} | {bounds} |")
        assert share >= 90.0, name

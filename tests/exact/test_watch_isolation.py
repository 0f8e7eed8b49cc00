"""Names and probabilities of faults of an independent cylinder, whose readings no code of `poppet` computes."""

from __future__ import annotations

import numpy as np
import pytest

from exact.isolation_battery import (
    EDGES,
    NAMES,
    SENSORS,
    Draw,
    Score,
    draws,
    judge_of,
    reliability,
)


def excess(results: list[Draw]) -> float:
    """Return the largest excess of a stated probability over its hit rate, less two standard errors."""
    classes = reliability(results, EDGES)
    return max(p - hits - 2.0 * np.sqrt(max(hits * (1.0 - hits), 0.01) / n) for p, hits, n in classes)


def test_faults_of_one_percent_are_named_on_one_cycle() -> None:
    results = [*draws(judge_of(SENSORS[0]), [1.0], [1], ["seal_leak", "leak_rod", "valve_slow", "mass"])]
    assert [draw.named for draw in results] == [(draw.fault,) for draw in results]
    for draw in results:
        assert abs(draw.sizes[NAMES.index(draw.fault)]) == pytest.approx(1.0, abs=0.25)
        assert 0.8 < draw.misfit < 1.2
    (healthy,) = draws(judge_of(SENSORS[0]), [0.0], [1])
    assert not healthy.is_alarm
    assert sum(healthy.probabilities) < 0.05


def test_two_faults_at_once_are_no_single_fault() -> None:
    draw = judge_of(SENSORS[0]).judge("seal_leak", 1.0, 2, {"coulomb_friction": 2.0})
    assert draw.pair == ("seal_leak", "coulomb_friction")


@pytest.mark.slow
@pytest.mark.parametrize("sensors", SENSORS)
def test_battery_of_faults(sensors: tuple[str, ...]) -> None:
    results = [*draws(judge_of(sensors), [0.0, 0.3, 1.0, 3.0], range(4))]
    scores = {size: Score.of([draw for draw in results if draw.size == size]) for size in (0.3, 1.0, 3.0)}
    assert all(score.contained >= 0.9 for score in scores.values())
    assert scores[1.0].named >= (0.9 if "cap" in sensors else 0.75)
    assert not any(draw.is_alarm for draw in results if not draw.fault)
    assert excess(results) < 0.05

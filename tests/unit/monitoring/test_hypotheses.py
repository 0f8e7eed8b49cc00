"""Fits of all hypotheses at once against separate fits of the window."""

from __future__ import annotations

from itertools import combinations
from typing import Any

import numpy as np
import pytest

from poppet import loads
from poppet.monitoring.fault_statistics import SCATTER
from poppet.monitoring.hypotheses import HypothesisSearch, fit_hypotheses
from poppet.monitoring.window_model import Samples
from poppet.monitoring.windows import Arrival, Window
from watched_tank import TANK, plan_of_tank

TIMES = 0.1 * np.arange(300)
OPENING = np.where(TIMES % 10.0 < 5.0, 1.0, 0.2)
FAULTS = {
    "leak": {"address": "leak.sonic_conductance", "alarm": "1e-10 m^3/(s Pa)", "direction": "up"},
    "worn": {"address": "valve.sonic_conductance", "alarm": "2e-10 m^3/(s Pa)", "direction": "down"},
    "supply_low": {"address": "supply.pressure", "alarm": "0.1 bar", "direction": "down"},
}
PLAN = plan_of_tank(faults=FAULTS, nuisances={"consumer.sonic_conductance": {"relative_sigma": 0.01}})
WINDOW = Window(PLAN)


def recorded(changes: dict[str, Any], seed: int, signals: str = "") -> Samples:
    """Simulate readings of a tank with other values."""
    times = np.arange(0.0, 30.0, 5.0).tolist()
    text = f'{TANK}[signals."consumer.opening"]\nkind = "steps"\ntimes = {times}\nvalues = {[1.0, 0.2] * 3}\n{signals}'
    run = loads(text).with_values(changes).simulate(duration=float(TIMES[-1]), output_step=0.1)
    noise = 500.0 * np.random.default_rng(seed).normal(size=TIMES.size)
    return Samples(TIMES, (run["tank.pressure"] + noise + 100.0)[:, None], OPENING[:, None])


def arrival() -> Arrival:
    x, _ = PLAN.instance.start()
    n = WINDOW.model.n_states
    nominal = np.array([state.nominal for state in PLAN.instance.model.states])
    sigmas = np.append(0.01 * nominal, PLAN.prior)
    return Arrival(-1e-9, np.append(x[:n], PLAN.reference), np.diag(sigmas**2))


LARGE_LEAK = {"leak.sonic_conductance": 3e-9}


@pytest.mark.parametrize(
    "changes", [{}, {"leak.sonic_conductance": 2e-10}, LARGE_LEAK, {"valve.sonic_conductance": 9.5e-9}]
)
def test_minima_are_those_of_separate_fits(changes: dict[str, float]) -> None:
    samples = recorded(changes, 3)
    hypotheses = [(), (0,), (1,), (2,), *combinations(range(3), 2)]
    evidence = fit_hypotheses(WINDOW, samples, arrival(), hypotheses)
    assert evidence is not None
    assert evidence.n_readings == TIMES.size
    separate = {
        h: WINDOW.fit(samples, arrival(), free=[PLAN.faults[k].name for k in h], scatter=SCATTER) for h in hypotheses
    }
    best, least = min(fit.cost for fit in evidence.fits.values()), min(fit.cost for fit in separate.values())
    for hypothesis, fit in evidence.fits.items():
        expected = separate[hypothesis]
        if fit.cost < best + 10.0:
            # A separate fit excludes outliers, which adds a constant.
            assert fit.cost - best == pytest.approx(expected.cost - least, abs=0.5)
            sizes, sigmas = (values[list(hypothesis)] for values in (expected.theta - PLAN.reference, expected.sigmas))
            assert np.all(np.abs(fit.sizes - sizes) < 0.2 * sigmas)
        else:
            # Hypotheses that are far worse than the best one have predicted minima.
            assert expected.cost > least + 8.0


def test_few_simulations_compare_all_hypotheses() -> None:
    search = HypothesisSearch(WINDOW, recorded(LARGE_LEAK, 4), arrival())
    fits = search.fit([(), (0,), (1,), (2,), (0, 1, 2)])
    assert search.evaluations <= 20
    assert fits[0,].sizes[0] == pytest.approx(3e-9, rel=0.02)
    assert fits[0,].cost < min(fits[()].cost, fits[1,].cost, fits[2,].cost) - 100.0
    # All faults together explain at least as much as one.
    assert fits[0, 1, 2].cost <= fits[0,].cost + 1e-6


@pytest.mark.parametrize("leak", [4e-9, 6e-9, 8e-9])
def test_very_large_faults_are_found_without_a_hint(leak: float) -> None:
    search = HypothesisSearch(WINDOW, recorded({"leak.sonic_conductance": leak}, 3), arrival())
    fits = search.fit([(), (0,), (1,), (2,), (0, 1, 2)])
    assert fits[0,].sizes[0] == pytest.approx(leak, rel=0.02)
    assert fits[0,].cost < min(fits[()].cost, fits[1,].cost, fits[2,].cost) - 100.0


@pytest.mark.parametrize("fall", [3e5, 4e5])
def test_faults_that_do_not_fit_are_simulated_within_their_limits(fall: float) -> None:
    # The linear model predicts a conductance below zero.
    fits = HypothesisSearch(WINDOW, recorded({"supply.pressure": 7e5 - fall}, 3), arrival()).fit([(), (0,), (1,), (2,)])
    assert fits[2,].sizes[0] == pytest.approx(-fall, rel=0.02)
    assert -PLAN.reference[1] < fits[1,].sizes[0] < 0.0


def test_a_small_known_change_before_the_fault_is_no_lack_of_fit() -> None:
    # The valve of the plant differs from the baseline by 0.4 alarm sizes, which the filter knows.
    start, worn = arrival(), WINDOW.model.n_states + 1
    start.mean[worn] -= 0.8e-10
    start.covariance[worn, worn] = (0.02 * 2e-10) ** 2
    start.covariance[worn + 2, worn + 2] = (1e-4 * 1e-8) ** 2  # the consumer is known
    samples = recorded({"valve.sonic_conductance": 1e-8 - 0.8e-10, "leak.sonic_conductance": 4e-10}, 3)
    fits = HypothesisSearch(WINDOW, samples, start).fit([(), (0,), (1,), (2,)])
    assert 2.0 * fits[0,].cost < 1.2 * TIMES.size
    assert fits[0,].sizes[0] == pytest.approx(4e-10, rel=0.15)
    # Sizes are changes from the baseline.
    healthy = recorded({"valve.sonic_conductance": 1e-8 - 0.8e-10}, 4)
    assert HypothesisSearch(WINDOW, healthy, start).fit([(1,)])[1,].sizes[0] == pytest.approx(-0.8e-10, rel=0.3)


def test_missing_readings_do_not_count() -> None:
    samples = recorded(LARGE_LEAK, 5)
    samples.readings[::2] = np.nan
    evidence = fit_hypotheses(WINDOW, samples, arrival(), [(), (0,)])
    assert evidence is not None
    assert evidence.n_readings == TIMES.size // 2
    assert evidence.fits[0,].sizes[0] == pytest.approx(3e-9, rel=0.05)


def test_outliers_have_little_influence() -> None:
    samples = recorded({}, 6)
    samples.readings[::50] += 5e4
    evidence = fit_hypotheses(WINDOW, samples, arrival(), [(), (0,)])
    assert evidence is not None
    # A leak explains less than 3 standard deviations.
    assert evidence.fits[()].cost - evidence.fits[0,].cost < 4.5


def test_pairs_of_two_faults_are_fitted() -> None:
    plan = plan_of_tank(faults={name: FAULTS[name] for name in ("leak", "worn")}, nuisances={})
    start = arrival()
    n = WINDOW.model.n_states
    prior = np.append(np.diag(start.covariance)[:n], plan.prior**2)
    known = Arrival(start.time, np.append(start.mean[:n], plan.reference), np.diag(prior))
    evidence = fit_hypotheses(Window(plan), recorded(LARGE_LEAK, 7), known, [(0, 1)])
    assert evidence is not None
    assert evidence.fits[0, 1].sizes[0] == pytest.approx(3e-9, rel=0.05)


def test_a_search_that_ends_early_has_an_unknown_cost(monkeypatch: pytest.MonkeyPatch) -> None:
    samples, hypotheses = recorded(LARGE_LEAK, 4), [(), (0,), (1,), (2,)]
    fits = HypothesisSearch(WINDOW, samples, arrival()).fit(hypotheses)
    assert all(fit.is_known for fit in fits.values())
    monkeypatch.setattr("poppet.monitoring.hypotheses.MOST_EVALUATIONS", 1)
    fits = HypothesisSearch(WINDOW, samples, arrival()).fit(hypotheses)
    assert not fits[0,].is_known
    assert not fits[2,].is_known


GROWTH = """
[signals."{name}"]
kind = "points"
times = [0.0, 29.9]
values = {values}
"""
GROWING = {
    0: (GROWTH.format(name="leak.opening", values=[0.2, 1.0]), {"leak.sonic_conductance": 1e-9}, [2e-10, 8e-10]),
    2: (GROWTH.format(name="supply.pressure", values=[7e5, 6.8e5]), {}, [0.0, -2e4]),
}
"""Growing faults: signals and values of the plant, change at the start and growth."""


@pytest.mark.parametrize("fault", GROWING)
def test_a_fault_that_grows_is_found_with_its_growth(fault: int) -> None:
    signals, changes, expected = GROWING[fault]
    hypotheses = [(), (0,), (1,), (2,), (0, 3), (1, 4), (2, 5)]
    search = HypothesisSearch(Window(PLAN, grows=True), recorded(changes, 3, signals), arrival())
    fits = search.fit(hypotheses)
    growing = fits[fault, fault + 3]
    assert growing.sizes == pytest.approx(expected, abs=0.1 * float(np.max(np.abs(expected))))
    assert 2.0 * growing.cost < 1.2 * TIMES.size
    assert growing.is_known
    assert growing.last < 1.5
    assert growing.cost < min(fit.cost for h, fit in fits.items() if h != (fault, fault + 3)) - 12.5


def test_the_fit_of_a_growing_fault_ends_at_its_last_size() -> None:
    signals, changes, (begin, growth) = GROWING[0]
    window, n = Window(PLAN, grows=True), WINDOW.model.n_states
    start = window.with_rates(arrival())
    variances = np.diag(start.covariance).copy()
    variances[[n, -3]] = (100.0 * PLAN.prior[0]) ** 2 / np.array([1.0, TIMES[-1] ** 2])
    fit = window.fit(recorded(changes, 3, signals), start._replace(covariance=np.diag(variances)))
    assert fit.is_complete
    error = fit.arrival.mean[n] - PLAN.reference[0] - begin - growth
    sigma = float(np.sqrt(fit.arrival.covariance[n, n]))
    assert abs(error) < 3.0 * sigma < 3e-10

"""Scores of `poppet watch` on the independent tank: false alarms, detection times, errors of the model, closed loops.

Quick versions run a few minutes of simulated time. The slow versions compute the rows of `exact.watch_tables`, whose
numbers are in `docs/watch_accuracy.md`.
"""

from __future__ import annotations

import numpy as np
import pytest

from exact import independent_watch_tank as tank
from exact.watch_batteries import Outcome, healthy_runs, leak_steps, masked_leaks, model_errors, silent_runs
from exact.watch_tables import DISTURBANCES, TABLES


def assert_silent(outcomes: list[Outcome]) -> None:
    """Assert that no run has an alarm."""
    assert [outcome.alarms for outcome in outcomes if outcome.alarms] == []


def test_ten_healthy_minutes_without_alarm():
    outcomes = [outcome for batch in (0, 1) for outcome in healthy_runs(batch, 1, 300.0)]
    assert sum(outcome.nis.size for outcome in outcomes) == 6000
    assert_silent(outcomes)
    assert np.mean([np.nanmean(outcome.nis) for outcome in outcomes]) == pytest.approx(1.0, abs=0.07)


@pytest.mark.parametrize("name", ["gas and wall +15 K", "wall conductance twice", "supply -10 kPa"])
def test_an_error_of_the_model_is_no_leak(name):
    assert_silent(model_errors([name], range(1), duration=180.0)[name])


@pytest.mark.parametrize(("size", "duty"), [(1.0, False), (10.0, False), (1.0, True)])
def test_a_leak_is_found(size, duty):
    """On a duty cycle, leak and supply temperature are confounded; the change of the leak is not."""
    detection = leak_steps(size, range(2), start=100.0, duration=120.0, duty=duty)
    assert detection.early == 0
    assert detection.delays.max() < 10.0
    assert detection.sizes / tank.ONE_PERCENT == pytest.approx(size, rel=0.1, abs=0.3)


def test_an_outlier_during_a_leak_does_not_delay_its_alarm():
    sensors = tank.Sensors(outliers=0.02)
    detection = leak_steps(1.0, range(3), start=100.0, duration=110.0, sensors=sensors)
    assert detection.early == 0
    assert detection.delays.max() < 6.0


@pytest.mark.parametrize("name", ["1 % outliers and 50 % missing", "gauge readings"])
def test_disturbed_readings_are_no_leak(name):
    assert_silent(silent_runs(DISTURBANCES[name], range(1), 180.0))


def test_a_controller_does_not_hide_a_leak():
    (outcome,) = masked_leaks(1.0, range(1), duration=140.0, start=100.0)
    assert [alarm.names for alarm in outcome.alarms[:1]] == [("leak",)]
    assert 100.0 < outcome.first < 125.0


# Complete batteries ---------------------------------------------------------------------------------------------------

LIMITS = {"0.3": 31.0, "1": 6.0, "3": 6.0, "10": 6.0}
"""Limits of the delay of 95 % of the alarms by the size of the leak in per cent [s]."""


@pytest.mark.slow
@pytest.mark.parametrize("batch", TABLES["healthy"])
def test_healthy_hours_without_alarm(batch):
    facts = TABLES["healthy"][batch]()
    assert facts["hours"] == pytest.approx(20.0)
    assert facts["alarms"] == []
    assert np.mean(facts["nis"]) == pytest.approx(1.0, abs=0.05)


@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in TABLES["errors"] if "no nuisance" not in name])
def test_errors_of_the_model_are_no_leaks(name):
    """A run without an alarm, or one whose model did not fit."""
    assert TABLES["errors"][name]()["unexplained"] == 0


@pytest.mark.slow
@pytest.mark.parametrize("name", TABLES["leaks"])
def test_leaks_are_found_in_time(name):
    facts, size = TABLES["leaks"][name](), name.partition(" ")[0]
    assert facts["early"] == 0
    assert facts["most"] <= LIMITS[size]
    assert abs(np.mean(facts["sizes"]) - float(size)) < 0.1


@pytest.mark.slow
@pytest.mark.parametrize("name", TABLES["disturbed"])
def test_disturbed_readings_are_no_leaks(name):
    facts = TABLES["disturbed"][name]()
    if name.startswith("healthy"):
        assert facts["alarms"] == []
    else:
        assert facts["early"] == 0
        assert facts["median"] < 6.0


@pytest.mark.slow
def test_bands_and_innovations():
    """The 95 % bands contain the true values at 93 to 97 % of the times, within two standard errors of 400 runs."""
    results = [TABLES["bands"][name]() for name in list(TABLES["bands"])[:4]]
    assert np.mean([facts["nis"] for facts in results]) == pytest.approx(1.0, abs=0.05)
    for name in results[0]["covered"]:
        assert 0.91 <= np.mean([facts["covered"][name] for facts in results]) <= 0.99
    assert 0.93 <= np.mean([facts["covered"]["leak"] for facts in results]) <= 0.97


@pytest.mark.slow
@pytest.mark.parametrize("name", TABLES["loops"])
def test_controllers_do_not_hide_leaks(name):
    delays = np.array(TABLES["loops"][name]()["delays"])
    assert np.isinf(delays).all() if name == "0 %" else 0.0 < delays.min() <= delays.max() < 31.0


@pytest.mark.slow
@pytest.mark.parametrize("name", TABLES["cylinder"])
def test_faults_of_the_cylinder_are_named(name):
    facts = TABLES["cylinder"][name]()
    assert facts["early"] == 0
    assert facts["wrong"] == 0
    if facts["faults"]:
        assert facts["end"] >= 0.9 * len(facts["results"])

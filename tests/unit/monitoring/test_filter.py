"""Filter of a plant against a textbook filter, and its treatment of irregular samples."""

from __future__ import annotations

import dataclasses
from types import SimpleNamespace

import numpy as np
import pytest

from exact.independent_watch_tank import ADDRESSES, CIRCUIT, HEALTHY, Sensors, random_openings, readings, simulate
from poppet import loads
from poppet.monitoring.filter import PlantFilter
from poppet.monitoring.plan import read_plan
from poppet.monitoring.verdicts import Adoption
from tank_filter import TankFilter

DT = 0.1
MEASURED = {
    "tank.pressure": {"noise": "500 Pa", "offset": "300 Pa"},
    "valve.opening": {},
    "use.opening": {},
}
LEAK = {"leak": {"address": ADDRESSES["leak"], "alarm": 3e-11, "direction": "up"}}
NUISANCES = {
    ADDRESSES["valve"]: {"relative_sigma": 0.05, "relative_drift": 0.1},
    ADDRESSES["supply_pressure"]: {"sigma": "10 kPa"},
}


def plan_of(measured=MEASURED, faults=LEAK, nuisances=NUISANCES, **settings):
    return read_plan(loads(CIRCUIT), measured, faults, nuisances, {"window": "120 s"} | settings)


@pytest.fixture(scope="module")
def plan():
    return plan_of()


@pytest.fixture(scope="module")
def recording():
    openings = random_openings(range(1), 400)
    course = simulate(HEALTHY, openings)
    return readings(HEALTHY, course, Sensors(), range(1))[0], openings[0]


def run(plan, values, openings, times=None, filter_=None):
    filter_ = filter_ or PlantFilter(plan)
    for k, (reading, opening) in enumerate(zip(values, openings, strict=True)):
        filter_.update(k * DT if times is None else times[k], reading, opening)
    return filter_


def same(first, second, within=1e-6):
    """Both filters have the same estimates, within a fraction of their standard deviations."""
    sigmas = np.sqrt(np.diag(second.covariance))
    assert (np.abs(first.mean - second.mean) <= within * sigmas).all()
    np.testing.assert_allclose(np.sqrt(np.diag(first.covariance)), sigmas, rtol=within)


def test_it_equals_a_textbook_filter(plan, recording):
    """The textbook filter has other laws (NumPy), another integration, and differences for the transition."""
    values, openings = recording
    filter_ = run(plan, values[:1], openings[:1])
    textbook = TankFilter(
        HEALTHY, ("leak", "valve", "supply_pressure"), filter_.mean.copy(), filter_.covariance.copy(),
        np.append((3e-5 * filter_.mean[:2]) ** 2, plan.walk), np.append(filter_.mean[:2], [1e-10, 1e-8, 1e5, 1e3]),
        500.0, offset=True,
    )  # fmt: skip
    for k in range(1, 60):
        textbook.predict(openings[k - 1], DT)
        nis = textbook.correct(values[k, 0])
        filter_.update(k * DT, values[k], openings[k])
        if filter_.used[0] < 0:
            pytest.fail("this recording has no outliers")
        assert filter_.nis == pytest.approx(nis, rel=1e-3, abs=1e-4)
    sigmas = np.sqrt(np.diag(textbook.covariance))
    assert (np.abs(filter_.mean - textbook.mean) < 1e-3 * sigmas).all()
    correlation = filter_.covariance / np.outer(sigmas, sigmas)
    np.testing.assert_allclose(correlation, textbook.covariance / np.outer(sigmas, sigmas), atol=1e-3)


def test_the_first_reading_starts_the_state(plan):
    filter_ = run(plan, np.array([[6e5]]), np.array([[0.0, 0.0]]))
    pressure, mass = filter_.mean[:2]
    assert pressure == 6e5
    assert mass == pytest.approx(6e5 * 0.01 / (287.05 * 293.15))
    # Reading = pressure + offset + noise, and the temperature is uncertain by 20 K.
    assert filter_.covariance[0, 0] == pytest.approx(500.0**2 + 300.0**2)
    assert filter_.covariance[0, -1] == pytest.approx(-(300.0**2))
    temperature = 20.0 / 293.15
    assert filter_.covariance[1, 1] == pytest.approx(mass**2 * (temperature**2 + 340e3 / 6e5**2), rel=1e-4)
    assert filter_.count == 0, "the reading is in the estimate already"


def test_a_missing_first_reading(plan):
    filter_ = run(plan, np.array([[np.nan]]), np.array([[0.0, 0.0]]))
    assert filter_.mean[0] == 5.5e5
    assert filter_.covariance[0, 0] == pytest.approx(1e10)


def test_missing_readings_are_predictions(plan, recording):
    values, openings = recording
    gaps = values[:60].copy()
    gaps[20:50] = np.nan
    one = run(plan, gaps, openings[:60])
    assert np.isnan(one.innovations).sum() == 0
    # The same without the empty rows, as far as the inputs do not change.
    changes = np.flatnonzero(np.any(np.diff(openings[:60], axis=0) != 0.0, axis=1)) + 1
    rows = [k for k in range(60) if not 20 <= k < 50 or k in changes]
    same(one, run(plan, gaps[rows], openings[rows], DT * np.array(rows)), within=1e-2)


def test_a_missing_input_keeps_its_value(plan, recording):
    values, openings = recording
    given = openings[:60].copy()
    given[1:][np.diff(openings[:60], axis=0) == 0.0] = np.nan
    same(run(plan, values[:60], given), run(plan, values[:60], openings[:60]))


def test_inputs_are_limited(plan, recording):
    values, openings = recording
    beyond = np.where(openings[:60] == 0.0, -0.2, openings[:60])
    same(run(plan, values[:60], beyond), run(plan, values[:60], openings[:60]))


def test_several_rates(recording):
    """Two sensors that alternate give the estimates of one sensor with all readings."""
    values, openings = recording
    channels = {f"tank.{name}": {"noise": noise} for name, noise in (("pressure", "500 Pa"), ("temperature", "1 K"))}
    plan = plan_of(measured={**channels, "valve.opening": {}, "use.opening": {}}, nuisances={})
    temperature = simulate(HEALTHY, random_openings(range(1), 400)).temperature[0]
    rows = np.column_stack([values[:60, 0], temperature[:60]])
    rows[::2, 1], rows[1::2, 0] = np.nan, np.nan
    filter_ = run(plan, rows, openings[:60])
    assert filter_.used.tolist() == [0.0, 1.0]
    assert filter_.sigmas[0] < 0.9 * plan.prior[0]


def test_late_samples_give_the_estimates_of_samples_in_order(recording):
    values, openings = recording
    measured = {**MEASURED, "tank.temperature": {"noise": "1 K"}}
    plan = plan_of(measured=measured)
    rows = np.column_stack([values[:80, 0], np.full(80, np.nan)])
    order = [*plan.channels].index(next(c for c in plan.channels if c.address == "tank.temperature"))
    assert order == 1
    in_order, late = PlantFilter(plan), PlantFilter(plan)
    for k in range(80):
        in_order.update(k * DT, rows[k], openings[k])
        late.update(k * DT, rows[k], openings[k])
        if k % 20 == 10:
            # A slow sensor, half a sample after a row of the others, that arrives three samples late.
            in_order.update((k + 0.5) * DT, np.array([np.nan, 295.0]))
        if k % 20 == 13:
            late.update((k - 2.5) * DT, np.array([np.nan, 295.0]))
    assert late.ignored == 0
    same(in_order, late)
    np.testing.assert_allclose(late.bank().gram, in_order.bank().gram, rtol=1e-6)


def test_very_late_samples_are_ignored(plan, recording):
    values, openings = recording
    filter_ = run(plan, values[:200], openings[:200])
    before = filter_.mean.copy()
    filter_.update(1.0, values[10], openings[10])
    assert filter_.ignored == 1
    assert (filter_.mean == before).all()
    assert filter_.time == pytest.approx(19.9)


def test_equal_times_are_further_readings(plan):
    filter_ = run(plan, np.array([[6e5], [6e5]]), np.zeros((2, 2)))
    variance = filter_.covariance[0, 0]
    filter_.update(filter_.time, np.array([6e5]), np.zeros(2))
    assert filter_.covariance[0, 0] < variance


def test_states_start_again_after_a_gap(plan, recording):
    values, openings = recording
    filter_ = run(plan, values[:100], openings[:100])
    sigmas = filter_.sigmas
    filter_.update(60.0, np.array([7e5]), openings[100])
    assert filter_.restarts == 1
    assert filter_.mean[0] == pytest.approx(7e5, abs=2e3)
    # What is known about the valve remains, but for its drift of 10 % in one hour.
    assert filter_.sigmas[1] == pytest.approx(np.hypot(sigmas[1], 1e-9 * np.sqrt(50.1 / 3600.0)), rel=1e-6)


def test_outliers_are_rejected_and_steps_accepted(plan, recording):
    values, openings = recording
    filter_ = run(plan, values[:150], openings[:150])
    filter_.update(150 * DT, np.array([np.nan]), np.zeros(2))  # the pressure hardly changes
    used = []
    for k in range(151, 157):
        filter_.update(k * DT, filter_.mean[:1] + (5e3 if k < 154 else 0.0), np.zeros(2))
        used.append(filter_.used[0])
    # The third reading on the same side is no outlier.
    assert used == [-1.0, -1.0, 1.0, 1.0, 1.0, 1.0]
    assert filter_.restarts == 0


def test_a_state_that_jumps_starts_again(plan, recording):
    values, openings = recording
    filter_ = run(plan, values[:150], openings[:150])
    filter_.update(150 * DT, np.array([np.nan]), np.zeros(2))
    theta, pressure = filter_.theta, filter_.mean[0]
    for k in range(151, 154):
        filter_.update(k * DT, np.array([pressure + 1e5]), np.zeros(2))
    assert filter_.restarts == 1
    assert filter_.mean[0] + filter_.theta[-1] == pytest.approx(pressure + 1e5)
    # The reading that shows the jump is in the state, not in the free numbers.
    assert (np.abs(filter_.theta - theta) < 1e-6 * plan.prior).all()


@pytest.mark.parametrize(("lost", "count"), [(0, 0), (2, 1)])
def test_a_change_of_an_input_in_lost_samples_starts_the_states_again(plan, recording, lost, count):
    values, openings = recording
    k = 150 + int(np.argmax((np.diff(openings[150:], axis=0) != 0.0).any(axis=1)))  # the last sample before a change
    filter_ = run(plan, values[: k + 1], openings[: k + 1])
    free = filter_.theta
    filter_.update((k + 1 + lost) * DT, values[k + 1 + lost], openings[k + 1 + lost])
    assert (filter_.restarts, filter_.lost_changes) == (count, count)
    if lost:
        # The readings show the change, and not an error of the free numbers.
        assert np.array_equal(filter_.theta, free)


def test_unknown_inputs_change_no_free_number(plan, recording):
    values, openings = recording
    filter_ = run(plan, values[:150], openings[:150])
    free = filter_.theta
    for k in range(150, 180):
        filter_.update(k * DT, np.array([np.nan]), np.full(2, np.nan))
    filter_.update(180 * DT, values[180], openings[180], is_gap=True)
    assert filter_.restarts == 1
    assert (np.abs(filter_.theta - free) < 1e-6 * plan.prior).all()


def test_readings_of_a_sensor_can_be_forgotten(plan, recording):
    (values, openings), n = recording, 185
    wrong, missing = values[:n].copy(), values[:n].copy()
    wrong[161:], missing[161:] = wrong[161:] + 2.0 * plan.channels[0].noise, np.nan
    filter_, expected = run(plan, wrong, openings[:n]), run(plan, missing, openings[:n])
    sigmas = np.sqrt(np.diag(expected.covariance))
    assert (np.abs(filter_.mean - expected.mean) > 1e-3 * sigmas).any()
    for since, is_kept in ((160 * DT, True), (5 * DT, False)):
        assert filter_.forget(0, since) == is_kept
        assert (np.abs(filter_.mean - expected.mean) < 1e-6 * sigmas).all()
        assert np.sqrt(np.diag(filter_.covariance)) == pytest.approx(sigmas, rel=1e-6)


def test_a_restart_begins_from_the_baseline(plan, recording):
    values, openings = recording
    filter_ = run(plan, values[:150], openings[:150])
    filter_.restart(np.array([1e-10]))
    assert filter_.theta[0] == pytest.approx(1.2e-10)
    assert filter_.theta[1] == plan.reference[1]
    posterior = filter_.fault_posterior()
    assert (posterior.change == 0.0).all()  # nothing is known until the fits of the first window


def test_a_single_outlier_changes_nothing(plan, recording):
    values, openings = recording
    disturbed, missing = values[:120].copy(), values[:120].copy()
    disturbed[100] += 5e4
    missing[100] = np.nan
    same(run(plan, disturbed, openings[:120]), run(plan, missing, openings[:120]), within=1e-3)


def predicted(plan, times, inputs):
    """Filter that has only the first reading."""
    values = np.full((len(times), 1), np.nan)
    values[0] = 5e5
    return run(plan, values, inputs, times)


def test_interpolated_inputs_equal_small_held_steps():
    times, fine = np.linspace(0.0, 2.0, 21), np.linspace(0.0, 2.0, 4001)
    opening = np.interp(fine + 0.25e-3, times, np.abs(np.sin(times)))
    one = predicted(plan_of(hold=False), times, np.column_stack([np.abs(np.sin(times)), np.full(21, 0.5)]))
    many = predicted(plan_of(), fine, np.column_stack([opening, np.full(4001, 0.5)]))
    assert one.mean[0] == pytest.approx(many.mean[0], rel=1e-6)
    held = predicted(plan_of(), times, np.column_stack([np.abs(np.sin(times)), np.full(21, 0.5)]))
    assert abs(held.mean[0] - many.mean[0]) > 1e-3 * many.mean[0]


@pytest.mark.parametrize("hold", [True, False])
def test_delayed_inputs_equal_earlier_samples(hold):
    """A delay of 2.5 samples: the fine grid has the delayed values themselves."""
    plan = plan_of(hold=hold)
    delayed = dataclasses.replace(plan, inputs=tuple(dataclasses.replace(item, delay=0.25) for item in plan.inputs))
    times, fine = 0.1 * np.arange(41), 0.05 * np.arange(81)
    openings = random_openings(range(1), 41)[0]
    late = predicted(delayed, times, openings)
    earlier = np.clip(fine - 0.25, 0.0, None)
    if hold:
        shifted = openings[np.floor(earlier / 0.1 + 1e-9).astype(int)]
    else:
        shifted = np.column_stack([np.interp(earlier, times, column) for column in openings.T])
    assert late.mean[0] == pytest.approx(predicted(plan, fine, shifted).mean[0], rel=1e-6)


def test_the_bank_measures_a_step_of_a_fault():
    openings = random_openings(range(1), 1500)
    leak = np.where(np.arange(1500) < 1400, 2e-11, 1.2e-10)[None, :]
    values = readings(HEALTHY, simulate(HEALTHY, openings, leak), Sensors(), range(1))[0]
    plan = plan_of(measured={**MEASURED, "tank.pressure": {"noise": "500 Pa"}}, window="60 s")
    filter_ = run(plan, values, openings[0])
    bank = filter_.bank()
    with np.errstate(invalid="ignore", divide="ignore"):
        z = bank.numerators[:, 0] / np.sqrt(bank.gram[:, 0, 0])
    best = int(np.nanargmax(z))
    size = bank.numerators[best, 0] / bank.gram[best, 0, 0]
    assert z[best] > 10.0
    assert bank.ages[best] == pytest.approx(10.0, abs=2.0)
    assert size == pytest.approx(1e-10, abs=4.0 / np.sqrt(bank.gram[best, 0, 0]))
    before = filter_.fault_posterior().change[0]
    filter_.adopt(Adoption(best, (0,), np.array([size])))
    after = filter_.fault_posterior().change[0]
    # The filter has followed a part of the step already, and its own signature contains this part.
    assert after > before
    assert after == pytest.approx(1e-10, abs=2e-11)
    assert (filter_.bank().numerators == 0.0).all()


def test_an_outlier_as_the_first_reading(plan, recording):
    values, openings = recording
    disturbed = values.copy()
    disturbed[0] += 5e4
    filter_ = run(plan, disturbed[:100], openings[:100])
    expected = run(plan, values[2:100], openings[2:100], DT * np.arange(2, 100))
    same(filter_, expected, within=1e-3)


def test_faults_remain_known_after_a_gap():
    samples = 700
    openings = random_openings(range(1), samples)
    values = readings(HEALTHY, simulate(HEALTHY, openings), Sensors(), range(1))[0]
    plan = plan_of(window="60 s")
    filter_ = run(plan, values[:450], openings[0, :450])
    before = filter_.fault_posterior()
    # Ten seconds are lost.
    run(plan, values[550:], openings[0, 550:], DT * np.arange(550, 700), filter_)
    after = filter_.fault_posterior()
    assert filter_.restarts == 1
    assert after.covariance[0, 0] <= 1.2 * before.covariance[0, 0]
    assert np.count_nonzero(filter_.bank().gram) > 10


def test_a_sensor_that_is_always_late_stops_neither_fits_nor_onsets(recording):
    values, openings = recording
    plan = plan_of(measured={**MEASURED, "tank.temperature": {"noise": "1 K"}}, window="30 s")
    temperature = simulate(HEALTHY, random_openings(range(1), 400)).temperature[0]
    filter_ = PlantFilter(plan)
    for k in range(300):
        filter_.update(k * DT, np.array([values[k, 0], np.nan]), openings[k])
        if k >= 3:
            filter_.update((k - 2.5) * DT, np.array([np.nan, temperature[k - 3 : k - 1].mean()]))
    assert filter_.ignored < 20
    assert np.count_nonzero(filter_.bank().gram) > 5
    assert filter_.fault_posterior().covariance[0, 0] < plan.prior[0] ** 2


def test_fits_at_the_start_do_not_hide_a_fault():
    """The leak begins between two of the fits, which then start again."""
    samples = 900
    openings = random_openings(range(1), samples)
    leak = np.where(np.arange(samples) < 150, 2e-11, 1.2e-10)[None, :]
    values = readings(HEALTHY, simulate(HEALTHY, openings, leak), Sensors(), range(1))[0]
    filter_ = run(plan_of(window="60 s"), values, openings[0])
    posterior = filter_.fault_posterior()
    assert posterior.change[0] == pytest.approx(1e-10, abs=3e-11)
    assert posterior.change[0] > 5.0 * np.sqrt(posterior.covariance[0, 0])


def test_results_are_copies(plan, recording):
    values, openings = recording
    filter_ = run(plan, values[:5], openings[:5])
    for name in ("mean", "covariance", "theta", "expected", "used"):
        getattr(filter_, name)[:] = 0.0
    assert filter_.mean[0] > 1e5


def test_nothing_is_known_before_the_last_fit(plan, recording):
    values, openings = recording
    filter_ = run(plan, values[:50], openings[:50])
    posterior = filter_.fault_posterior()
    assert posterior.change.tolist() == [0.0]
    assert posterior.covariance[0, 0] == pytest.approx(plan.cap[0] ** 2)
    assert (filter_.bank().gram == 0.0).all()


def test_a_baseline_is_the_start_of_the_free_numbers(plan, recording):
    values, openings = recording
    healthy = plan.reference.copy()
    healthy[0] = 5e-11
    noise = 3.0 * np.array([channel.noise for channel in plan.channels])
    baseline = SimpleNamespace(values=healthy, sigmas=np.full(healthy.size, 1e-11), noise=noise)
    filter_, stated = PlantFilter(plan, baseline), PlantFilter(plan)
    for k in (0, 1):
        filter_.update(DT * k, values[k], openings[k])
        stated.update(DT * k, values[k], openings[k])
    increase = filter_.deviations[0] ** 2 - stated.deviations[0] ** 2
    # The noise of this reading, and that of the first one in the estimate.
    assert increase == pytest.approx(2.0 * (3.0**2 - 1.0) * plan.channels[0].noise ** 2, rel=0.05)
    filter_ = PlantFilter(plan, baseline)
    filter_.update(0.0, values[0], openings[0])
    assert filter_.theta[0] == 5e-11
    assert filter_.sigmas[0] == pytest.approx(np.hypot(3e-11, 1e-11))


def test_snapshots_and_samples(plan, recording):
    values, openings = recording
    filter_ = run(plan, values, openings)
    arrival = filter_.snapshot(20.0)
    assert 20.0 - 120.0 / 32 - DT <= arrival.time <= 20.0
    samples = filter_.samples(arrival.time)
    assert samples.times[0] == pytest.approx(arrival.time)
    assert samples.times[-1] == filter_.time
    np.testing.assert_array_equal(samples.readings[-1], values[-1])
    np.testing.assert_array_equal(samples.inputs[-1], openings[-1])


@pytest.mark.parametrize("index", [203, 387])
def test_a_snapshot_between_kept_estimates_is_the_estimate_at_its_time(plan, recording, index):
    values, openings = recording
    before = run(plan, values[: index + 1], openings[: index + 1])
    filter_ = run(plan, values, openings)
    assert all(abs(arrival.time - index * DT) > 0.5 * DT for arrival in filter_._arrivals)
    arrival = filter_.snapshot((index + 0.5) * DT)
    assert arrival.time == before.time
    same(SimpleNamespace(mean=arrival.mean, covariance=arrival.covariance), before)
    assert arrival.squares == pytest.approx(before.snapshot(before.time).squares, rel=1e-6)
    # The filter itself has not changed, and keeps this estimate.
    same(filter_, run(plan, values, openings), within=0.0)
    assert filter_.snapshot((index + 0.5) * DT) is arrival

"""Alarms and verdicts from estimates: delay, hysteresis, refits, and the cases without an answer."""

from __future__ import annotations

import math
from collections.abc import Sequence
from typing import Any

import numpy as np
import pytest

from poppet.monitoring.evidence import Hypothesis, HypothesisFit, WindowEvidence
from poppet.monitoring.fault_statistics import SCATTER, OnsetBank
from poppet.monitoring.plan import Fault
from poppet.monitoring.verdicts import FaultMonitor, VerdictKind

FAULTS = (
    Fault("leak", "leak.sonic_conductance", "m^3/(s Pa)", 1, 1e-10),
    Fault("worn", "valve.sonic_conductance", "m^3/(s Pa)", -1, 1e-10),
    Fault("drift", "tank.volume", "m^3", 0, 1e-4),
)
ALARMS = np.array([fault.alarm for fault in FAULTS])
COVARIANCE = np.diag((0.05 * ALARMS) ** 2)


def monitor(**settings: Any) -> FaultMonitor:
    return FaultMonitor(FAULTS, **{"alarm_delay": 2.0, "window": 60.0, **settings})


class Plant:
    """Ideal filter of a plant whose faults have exact steps: a bank of one onset, and the steps that it has adopted."""

    def __init__(self, watched: FaultMonitor) -> None:
        self.watched, self.adopted, self.onset = watched, np.zeros(3), 0.0
        self.adoptions: list[tuple[int, ...]] = []

    def feed(
        self, start: float, end: float, sizes: Sequence[float], *, covariance: np.ndarray = COVARIANCE,
        ratio: float = 1.0,
    ) -> list[float]:  # fmt: skip
        """Update the monitor ten times a second, and return the times of changed verdicts; sizes in alarm sizes."""
        changed, steps, information = [], np.array(sizes) - self.adopted, np.linalg.inv(covariance)
        self.onset = start if steps.any() else self.onset
        for time in (np.arange(round(10 * start), round(10 * end)) / 10.0).tolist():
            evidence = information @ (np.array(sizes) * ALARMS - self.adopted * ALARMS)
            bank = OnsetBank(np.array([time - self.onset]), evidence[None], information[None])
            if self.watched.update(time, bank, self.adopted * ALARMS, COVARIANCE, 2.0 * ratio, 2):
                changed.append(time)
            if self.watched.adoption is not None:
                members, steps = self.watched.adoption.members, self.watched.adoption.sizes
                self.adopted[list(members)] += steps / ALARMS[list(members)]
                self.adoptions.append(members)
        return changed


def test_alarm_begins_after_its_delay_and_ends_with_hysteresis() -> None:
    watched = monitor()
    plant = Plant(watched)
    assert watched.verdict.kind is VerdictKind.NO_INFORMATION
    assert plant.feed(0.0, 10.0, [0.0, 0.0, 0.0]) == [0.0]
    assert watched.verdict.kind is VerdictKind.HEALTHY
    assert plant.feed(10.0, 20.0, [1.0, 0.0, 0.0]) == [12.0]
    assert (watched.alarm, watched.verdict.kind) == (("leak",), VerdictKind.FAULT)
    assert watched.probabilities[0] > 0.95
    assert watched.verdict.note.facts["times"] == pytest.approx(1.0)
    # Below the size at which an alarm begins, but above that at which it ends.
    assert plant.feed(20.0, 30.0, [0.4, 0.0, 0.0]) == []
    # The filter adopts the repair after the delay, and the alarm ends when the fault is absent for this time.
    assert plant.feed(30.0, 40.0, [0.1, 0.0, 0.0]) == [pytest.approx(34.1, abs=0.11)]
    assert plant.adopted == pytest.approx([0.1, 0.0, 0.0], abs=1e-3)
    assert watched.alarm == ()
    assert watched.verdict.kind is VerdictKind.HEALTHY


@pytest.mark.parametrize("sizes", [[0.45, 0.0, 0.0], [-3.0, 0.0, 0.0], [0.0, 3.0, 0.0]])
def test_small_changes_and_those_in_the_wrong_direction_are_no_faults(sizes: list[float]) -> None:
    watched = monitor()
    plant = Plant(watched)
    plant.feed(0.0, 20.0, sizes)
    assert watched.alarm == ()


def test_interrupted_evidence_begins_again() -> None:
    watched = monitor()
    plant = Plant(watched)
    for second in range(0, 12, 2):
        plant.feed(second, second + 1.9, [1.0, 0.0, 0.0])
        plant.feed(second + 1.9, second + 2, [0.0, 0.0, 0.0])
    assert watched.alarm == ()


def test_temper_reduces_the_evidence() -> None:
    watched = monitor(temper=16.0)
    plant = Plant(watched)
    plant.feed(0.0, 10.0, [0.9, 0.0, 0.0])
    assert watched.alarm == ()
    assert watched.statistics.z[0] == pytest.approx(0.9 / math.hypot(4.0 * 0.05, SCATTER), rel=1e-3)


def test_faults_with_almost_the_same_effect_are_named_together() -> None:
    # The sum of leak and wear is known well, their difference is not.
    basis = np.array([[1.0, 1.0, 0.0], [1.0, -1.0, 0.0], [0.0, 0.0, 1.0]]) / np.sqrt([2.0, 2.0, 1.0])[:, np.newaxis]
    covariance = basis.T @ np.diag([100.0, 0.0025, 0.0025]) @ basis * np.outer(ALARMS, ALARMS)
    watched = monitor(separating={frozenset({"leak", "worn"}): "a gauge at rail.pressure"})
    plant = Plant(watched)
    plant.feed(0.0, 5.0, [1.0, -0.9, 0.0], covariance=covariance)
    assert watched.verdict.kind is VerdictKind.NOT_ISOLABLE
    assert set(watched.alarm) == {"leak", "worn"}
    assert str(watched.verdict).endswith("; a gauge at rail.pressure would separate them.")
    assert np.all(watched.probabilities[:2] < 0.6)
    assert np.sum(watched.probabilities) <= 0.99


def test_two_faults_at_once_are_named_as_such() -> None:
    watched = monitor()
    plant = Plant(watched)
    plant.feed(0.0, 5.0, [2.0, -2.0, 0.0])
    assert watched.verdict.kind is VerdictKind.SEVERAL
    assert watched.alarm == ("leak", "worn")
    assert np.all(watched.probabilities < 0.01)


def test_changes_of_all_numbers_fit_no_hypothesis() -> None:
    watched = monitor()
    plant = Plant(watched)
    plant.feed(0.0, 5.0, [2.0, -2.0, 3.0])
    assert watched.verdict.kind is VerdictKind.NONE_FITS
    assert watched.alarm == ()


def test_large_innovations_are_a_lack_of_fit_and_prevent_alarms() -> None:
    watched = monitor()
    plant = Plant(watched)
    plant.feed(0.0, 20.0, [0.0, 0.0, 0.0], ratio=1.5)
    assert watched.verdict.kind is VerdictKind.HEALTHY
    plant.feed(20.0, 60.0, [0.0, 0.0, 0.0], ratio=3.0)
    assert watched.verdict.kind is VerdictKind.NONE_FITS
    # A fault that explains less than it leaves is no alarm, one that explains more is.
    wide = 36.0 * COVARIANCE
    plant.feed(60.0, 70.0, [2.0, 0.0, 0.0], ratio=3.0, covariance=wide)
    assert watched.verdict.kind is VerdictKind.NONE_FITS
    assert watched.alarm == ()
    assert np.all(watched.probabilities == 0.0)
    large = monitor()
    Plant(large).feed(0.0, 10.0, [2.0, 0.0, 0.0], ratio=3.0)
    assert large.alarm == ("leak",)
    # The healthy plant had the same innovations.
    usual = monitor(healthy_nis=3.0)
    Plant(usual).feed(0.0, 20.0, [2.0, 0.0, 0.0], ratio=3.0)
    assert usual.alarm == ("leak",)


def test_estimates_that_are_wider_than_the_alarm_sizes_contain_no_information() -> None:
    watched = monitor()
    plant = Plant(watched)
    plant.feed(0.0, 5.0, [0.0, 0.0, 0.0])
    plant.feed(5.0, 6.0, [0.0, 0.0, 0.0], covariance=4.0 * np.diag(ALARMS**2))
    assert watched.verdict.kind is VerdictKind.NO_INFORMATION


def fit_of(hypothesis: Hypothesis, cost: float, **facts: Any) -> HypothesisFit:
    """A fit with changes of three alarm sizes; a fault that grows does so from zero."""
    sizes = np.append(3.0 * np.array([1.0, -1.0, 1.0]) * ALARMS, np.zeros(3))
    for k in (member - 3 for member in hypothesis if member >= 3):
        sizes[3 + k], sizes[k] = sizes[k], 0.0
    return HypothesisFit(cost, sizes[list(hypothesis)], **facts)


class RecordedFits:
    """Fits whose costs are those of a change of one fault; the calls are recorded.

    If a fault grows, its cost is that of a constant fault.
    """

    def __init__(
        self, costs: dict[Hypothesis, float], n_readings: int = 40, unknown: Sequence[Hypothesis] = (),
        last: float = 1.0,
    ) -> None:  # fmt: skip
        self.calls: list[tuple[float, int]] = []
        self.costs, self._n_readings, self._unknown, self._last = costs, n_readings, unknown, last

    def __call__(
        self, since: float, hypotheses: Sequence[Hypothesis], steps: np.ndarray, *, is_quick: bool = False
    ) -> WindowEvidence | None:
        self.calls.append((since, len(hypotheses)))
        fits = {}
        for h in hypotheses:
            constant = tuple(k for k in h if k < 3)
            cost = self.costs.get(h, self.costs.get(constant, 500.0))
            fits[h] = fit_of(h, cost, is_known=h not in self._unknown, last=self._last)
        return WindowEvidence(fits, self._n_readings)


def test_hypotheses_are_fitted_when_an_alarm_is_due() -> None:
    fits = RecordedFits({(0, 1, 2): 20.0, (0,): 21.0, (): 800.0})
    watched = monitor(refit=fits)
    plant = Plant(watched)
    plant.feed(0.0, 5.0, [0.0, 0.0, 0.0])
    assert fits.calls == []
    plant.feed(5.0, 7.5, [3.0, 0.0, 0.0])
    # With the readings since the fault began: no fault, each fault alone, and all; then also each fault if it grows.
    assert fits.calls == [(5.0, 5), (5.0, 8)]
    assert watched.alarm == ("leak",)
    assert watched.probabilities[0] > 0.98
    assert plant.adoptions == []
    # A second comparison confirms the fault. A further one tests once whether it grows.
    plant.feed(7.5, 9.2, [3.0, 0.0, 0.0])
    assert fits.calls[2:] == [(5.0, 5), (5.0, 8), (5.0, 2)]
    plant.feed(9.2, 40.0, [3.0, 0.0, 0.0])
    assert fits.calls[5:] == [(5.0, 8), (5.0, 2)]
    assert plant.adoptions == [(0,)]


def test_first_comparison_names_all_faults_that_fit_almost_as_well() -> None:
    # Without the onset, one fault explains 99 % and another one 91 % of the evidence.
    watched = monitor(refit=RecordedFits({(0, 1, 2): 20.0, (0,): 60.0, (1,): 24.0, (): 440.0}))
    Plant(watched).feed(0.0, 2.1, [3.0, 0.0, 0.0])
    assert set(watched.alarm) == {"leak", "worn"}


def test_name_whose_estimate_returns_is_dropped() -> None:
    watched = monitor(refit=lambda since, hypotheses, steps, *, is_quick=False: None)
    plant = Plant(watched)
    plant.feed(0.0, 5.0, [2.0, -2.0, 0.0])
    assert watched.alarm == ("leak", "worn")
    plant.feed(5.0, 15.0, [2.0, 0.0, 0.0])
    assert watched.alarm == ("leak",)
    assert watched.verdict.kind is VerdictKind.FAULT


def test_alarms_that_are_not_confirmed_are_compared_again() -> None:
    fits = RecordedFits({(0, 1, 2): 20.0, (0,): 21.0, (1,): 21.5, (): 800.0})
    watched = monitor(refit=fits)
    plant = Plant(watched)
    plant.feed(0.0, 2.1, [3.0, -3.0, 0.0])
    assert set(watched.alarm) == {"leak", "worn"}
    # When the time since the beginning has doubled; also for the later onset of the bank.
    plant.feed(2.1, 17.0, [3.0, -3.0, 0.0])
    assert [call for call in fits.calls if call[0] == 0.0] == [(0.0, 5), (0.0, 8)] * 4


def test_confirmed_alarms_remain_although_the_model_does_not_fit_later() -> None:
    watched = monitor()
    plant = Plant(watched)
    plant.feed(0.0, 5.0, [2.0, 0.0, 0.0])
    plant.feed(5.0, 60.0, [2.0, 0.0, 0.0], ratio=10.0)
    assert watched.alarm == ("leak",)
    # A second fault is added.
    plant.feed(60.0, 70.0, [2.0, -3.0, 0.0])
    assert watched.verdict.kind is VerdictKind.SEVERAL
    assert watched.alarm == ("leak", "worn")
    # The repair of both ends the alarm.
    plant.feed(70.0, 80.0, [0.0, 0.0, 0.0])
    assert watched.alarm == ()


def test_changes_outside_the_limits_of_a_parameter_are_impossible() -> None:
    infinite = np.full(3, np.inf)
    bounds = np.array([-np.inf, -2.0, -np.inf]) * ALARMS, infinite
    for size, names in ((-1.5, ("worn",)), (-3.0, ())):
        watched = monitor(bounds=bounds)
        Plant(watched).feed(0.0, 5.0, [0.0, size, 0.0])
        assert watched.alarm == names


def test_empty_bank_changes_nothing() -> None:
    watched = monitor()
    plant = Plant(watched)
    plant.feed(0.0, 5.0, [2.0, 0.0, 0.0])
    empty = OnsetBank(np.zeros(1), np.zeros((1, 3)), np.zeros((1, 3, 3)))
    for time in np.arange(50, 100) / 10.0:
        watched.update(float(time), empty, 10.0 * ALARMS, COVARIANCE, 2.0, 2)
    assert watched.alarm == ("leak",)


def test_fits_decide_if_the_filter_suggests_another_fault() -> None:
    watched = monitor(refit=RecordedFits({(0, 1, 2): 20.0, (0,): 21.0, (): 800.0}))
    plant = Plant(watched)
    plant.feed(0.0, 2.1, [0.0, -3.0, 0.0])
    assert watched.alarm == ("leak",)


def test_fits_that_contradict_the_filter_prevent_the_alarm() -> None:
    watched = monitor(refit=RecordedFits(dict.fromkeys([(0, 1, 2), (0,), (1,), (2,), ()], 20.0)))
    plant = Plant(watched)
    plant.feed(0.0, 10.0, [3.0, 0.0, 0.0])
    assert watched.verdict.kind is VerdictKind.HEALTHY
    assert watched.alarm == ()


def test_fits_with_large_residuals_are_a_lack_of_fit() -> None:
    watched = monitor(refit=RecordedFits({(0, 1, 2): 395.0, (0,): 396.0, (): 500.0}))
    plant = Plant(watched)
    plant.feed(0.0, 10.0, [3.0, 0.0, 0.0])
    assert watched.verdict.kind is VerdictKind.NONE_FITS


def test_an_unknown_fault_has_no_name_although_each_fault_explains_the_last_readings() -> None:
    now = 0.0

    def refit(
        since: float, hypotheses: Sequence[Hypothesis], steps: np.ndarray, *, is_quick: bool = False
    ) -> WindowEvidence:
        # Two readings, or all of them since the unknown fault.
        is_young = now - since < 1.9
        costs: dict[Hypothesis, float] = {(): 100.0} if is_young else {(): 900.0, (0, 1, 2): 300.0}
        rest = 1.0 if is_young else 400.0
        fits = {h: fit_of(h, costs.get(h, rest)) for h in hypotheses}
        return WindowEvidence(fits, 2 if is_young else 40, before=600.0 if is_young else 0.0)

    watched = monitor(refit=refit)
    information = np.linalg.inv(COVARIANCE)
    for now in (np.arange(80) / 10.0).tolist():
        ages = np.array([now, min(now, 0.5)])
        sizes = np.array([[3.0, 0.0, 0.0], [3.0, 0.0, 0.0]]) * ALARMS
        watched.update(
            now, OnsetBank(ages, sizes @ information, np.stack([information] * 2)), np.zeros(3), COVARIANCE, 2.0, 2
        )
        assert watched.alarm == ()
    assert watched.verdict.kind is VerdictKind.NONE_FITS


def test_residuals_without_noise_are_those_of_a_stuck_sensor() -> None:
    watched = monitor(refit=RecordedFits({(0, 1, 2): 0.1, (0,): 0.2, (): 800.0}))
    Plant(watched).feed(0.0, 10.0, [3.0, 0.0, 0.0])
    assert watched.alarm == ()


def test_fits_of_pairs_find_two_faults_at_once() -> None:
    fits = RecordedFits({(0, 1, 2): 200.0, (0,): 280.0, (1,): 300.0, (0, 1): 201.0, (): 980.0}, n_readings=400)
    watched = monitor(refit=fits)
    plant = Plant(watched)
    plant.feed(0.0, 3.0, [3.0, 0.0, 0.0])
    assert watched.verdict.kind is VerdictKind.SEVERAL
    assert watched.alarm == ("leak", "worn")


def test_two_faults_are_found_although_no_single_one_fits() -> None:
    for cost, names in ((21.0, ("leak", "worn")), (90.0, ())):
        watched = monitor(refit=RecordedFits({(0, 1, 2): 20.0, (0,): 300.0, (1,): 320.0, (0, 1): cost, (): 900.0}))
        Plant(watched).feed(0.0, 3.0, [3.0, 0.0, 0.0])
        assert watched.alarm == names


def test_an_alarm_without_a_confirmed_fault_ends_when_nothing_fits_any_more() -> None:
    fits = RecordedFits({(0, 1, 2): 20.0, (0,): 21.0, (1,): 21.5, (): 800.0})
    watched = monitor(refit=fits)
    plant = Plant(watched)
    plant.feed(0.0, 2.1, [3.0, -3.0, 0.0])
    assert set(watched.alarm) == {"leak", "worn"}
    fits.costs = {(): 800.0}
    plant.feed(2.1, 10.0, [3.0, -3.0, 0.0])
    assert watched.verdict.kind is VerdictKind.NONE_FITS


@pytest.mark.parametrize(
    ("costs", "names"),
    [
        ({(0,): 21.0, (0, 1): 20.0}, ("leak",)),
        ({(1,): 21.0, (0, 1): 20.0}, ("worn",)),
        ({(0, 1): 20.0}, ("leak", "worn")),
        ({}, ()),
    ],
)
def test_a_further_step_is_one_of_the_named_fault_if_this_explains_it(
    costs: dict[Hypothesis, float], names: tuple[str, ...]
) -> None:
    fits = RecordedFits({(0, 1, 2): 20.0, (0,): 21.0, (): 800.0})
    watched = monitor(refit=fits)
    plant = Plant(watched)
    plant.feed(0.0, 10.0, [3.0, 0.0, 0.0])
    assert plant.adoptions == [(0,)]
    fits.costs = costs
    plant.feed(10.0, 20.0, [3.0, -3.0, 0.0])
    assert watched.alarm == names


def test_a_fault_that_grows_is_named_although_no_constant_one_fits() -> None:
    watched = monitor(refit=RecordedFits({(0, 1, 2): 300.0, (0,): 310.0, (0, 3): 20.0, (1, 4): 200.0, (): 900.0}))
    adoptions = []
    for time in (np.arange(50) / 10.0).tolist():
        information = np.linalg.inv(COVARIANCE)
        bank = OnsetBank(np.array([time]), (information @ [3e-10, 0.0, 0.0])[None], information[None])
        watched.update(time, bank, np.zeros(3), COVARIANCE, 2.0, 2)
        adoptions += [watched.adoption] if watched.adoption else []
    assert watched.alarm == ("leak",)
    assert adoptions[0].growths == pytest.approx([3e-10])


@pytest.mark.parametrize(("part", "grows"), [(0.2, False), (0.8, True)])
def test_a_fault_that_has_hardly_grown_is_sudden(part: float, grows: bool) -> None:
    fits = RecordedFits({(0, 1, 2): 20.0, (0,): 40.0, (0, 3): 20.0, (): 900.0})

    def refit(
        since: float, hypotheses: Sequence[Hypothesis], steps: np.ndarray, *, is_quick: bool = False
    ) -> WindowEvidence | None:
        evidence = fits(since, hypotheses, steps)
        assert evidence is not None
        size = 3.0 * ALARMS[0]
        grown = {
            h: fit._replace(sizes=np.array([1.0 - part, part]) * size)
            for h, fit in evidence.fits.items()
            if h == (0, 3)
        }
        return evidence._replace(fits={**evidence.fits, **grown})

    watched = monitor(refit=refit)
    information, adoptions = np.linalg.inv(COVARIANCE), []
    for time in (np.arange(50) / 10.0).tolist():
        bank = OnsetBank(np.array([time]), (information @ [3e-10, 0.0, 0.0])[None], information[None])
        watched.update(time, bank, np.zeros(3), COVARIANCE, 2.0, 2)
        adoptions += [watched.adoption] if watched.adoption else []
    assert bool(adoptions[0].growths.size) == grows


def test_a_fault_is_not_named_alone_if_another_one_could_grow() -> None:
    costs: dict[Hypothesis, float] = {(0, 1, 2): 20.0, (0,): 21.0, (1,): 300.0, (): 800.0}
    for growing, names in ((200.0, {"leak"}), (16.0, {"leak", "worn"})):
        watched = monitor(refit=RecordedFits({**costs, (1, 4): growing}))
        Plant(watched).feed(0.0, 2.1, [3.0, 0.0, 0.0])
        assert set(watched.alarm) == names


def test_a_fault_whose_fit_has_not_converged_is_a_possible_cause() -> None:
    costs: dict[Hypothesis, float] = {(0, 1, 2): 20.0, (0,): 21.0, (1,): 400.0, (): 800.0}
    for unknown, names in (((1,), ("leak", "worn")), ((0,), ("leak",))):
        watched = monitor(refit=RecordedFits(costs, unknown=[unknown]))
        plant = Plant(watched)
        plant.feed(0.0, 10.0, [3.0, 0.0, 0.0])
        assert watched.alarm == names
        # The cost of a simulated point confirms the best hypothesis.
        assert bool(plant.adoptions) == (len(names) == 1)


def test_two_faults_are_confirmed_by_a_second_comparison() -> None:
    watched = monitor(refit=RecordedFits({(0, 1, 2): 20.0, (0,): 300.0, (1,): 320.0, (0, 1): 21.0, (): 900.0}))
    plant = Plant(watched)
    plant.feed(0.0, 3.0, [3.0, -3.0, 0.0])
    assert (watched.alarm, plant.adoptions) == (("leak", "worn"), [])
    plant.feed(3.0, 5.0, [3.0, -3.0, 0.0])
    assert (watched.alarm, plant.adoptions) == (("leak", "worn"), [(0, 1)])


def test_first_sample_is_no_pause() -> None:
    watched = monitor()
    Plant(watched).feed(0.0, 1.0, [0.0, 0.0, 0.0])
    assert not math.isnan(watched._present_at)


def test_the_only_fault_of_a_watch_can_leave_a_lack_of_fit() -> None:
    watched = FaultMonitor(FAULTS[:1], alarm_delay=2.0, window=60.0, refit=RecordedFits({(0,): 300.0, (): 320.0}))
    information = np.array([[[1e4 / ALARMS[0] ** 2]]])
    for time in np.arange(50) / 10.0:
        bank = OnsetBank(np.array([time]), information[:, 0] * 3.0 * ALARMS[0], information)
        watched.update(float(time), bank, np.zeros(1), COVARIANCE[:1, :1], 2.0, 2)
    assert watched.verdict.kind is VerdictKind.NONE_FITS


def test_without_stored_readings_the_filter_decides() -> None:
    watched = monitor(refit=lambda since, hypotheses, steps, *, is_quick=False: None)
    plant = Plant(watched)
    plant.feed(0.0, 5.0, [1.0, 0.0, 0.0])
    assert watched.alarm == ("leak",)


def test_evidence_without_readings_does_not_become_an_alarm() -> None:
    watched = monitor()
    plant = Plant(watched)
    plant.feed(0.0, 1.5, [2.0, 0.0, 0.0])
    information = np.linalg.inv(COVARIANCE)
    bank = OnsetBank(np.zeros(1), (information @ (np.array([2.0, 0.0, 0.0]) * ALARMS))[None], information[None])
    for time in np.arange(15, 100) / 10.0:
        watched.update(float(time), bank, 0.0 * ALARMS, COVARIANCE, 0.0, 0)
    # The delay begins again after a long pause.
    plant.feed(10.0, 11.9, [2.0, 0.0, 0.0])
    assert watched.alarm == ()
    plant.feed(11.9, 13.0, [2.0, 0.0, 0.0])
    assert watched.alarm == ("leak",)


def test_baseline_without_noise_does_not_make_all_readings_a_lack_of_fit() -> None:
    watched = monitor(healthy_nis=1e-8)
    plant = Plant(watched)
    plant.feed(0.0, 5.0, [0.0, 0.0, 0.0], ratio=1e-8)
    plant.feed(5.0, 20.0, [2.0, 0.0, 0.0], ratio=0.1)
    assert watched.alarm == ("leak",)


def test_a_step_that_the_filter_cannot_adopt_is_not_confirmed() -> None:
    watched = monitor()
    plant, information = Plant(watched), np.linalg.inv(COVARIANCE)
    plant.feed(0.0, 10.0, [0.0, 0.0, 0.0])
    bank = OnsetBank(np.array([4.0]), (information @ np.array([1e-10, 0.0, 0.0]))[None], information[None])
    for time in np.arange(10.0, 13.0, 0.1).tolist():
        watched.update(time, bank, np.zeros(3), COVARIANCE, 2.0, 2)
        if watched.adoption is not None:
            break
    assert watched.alarm == ("leak",)
    assert watched.confirmed[0] == pytest.approx(1e-10, rel=0.01)
    watched.reject_adoption()
    assert watched.adoption is None
    assert watched.confirmed == pytest.approx([0.0, 0.0, 0.0], abs=1e-20)
    assert watched.verdict.kind is VerdictKind.NONE_FITS
    assert (watched.probabilities == 0.0).all()

"""The page of a watch: its numbers are those of the record, and incomplete records give a page too."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from poppet.core.codes import Note
from poppet.monitoring.baseline import Baseline
from poppet.monitoring.record import WatchRecord
from poppet.monitoring.twin_file import read_twin_file
from poppet.report.watch_figures import MOST_INTERVALS, intervals_of
from poppet.report.watch_report import watch_page, write_watch
from poppet.report.watch_text import alarm_rows, record_summary

TWIN = Path(__file__).parents[3] / "examples/watch/twin.toml"


@pytest.fixture(scope="module")
def baseline() -> Baseline:
    return Baseline.of_circuit(read_twin_file(TWIN).plan)


def record_of(baseline: Baseline, n: int, alarms: dict[int, str] | None = None, **changes: object) -> WatchRecord:
    plan = baseline.plan
    f, c = len(plan.faults), len(plan.channels)
    ones = np.ones((n, c))
    texts = [(alarms or {}).get(k, "") for k in range(n)]
    record = WatchRecord(
        plan=plan, time=0.1 * np.arange(n), values=np.tile(baseline.faults, (n, 1)),
        sigmas=np.tile([0.1 * fault.alarm for fault in plan.faults], (n, 1)),
        probabilities=np.full((n, f), 0.125), nis=np.ones(n), counts=np.full(n, c), alarms=tuple(texts),
        readings=6e5 * ones, expected=6e5 * ones, deviations=500.0 * ones, used=np.ones((n, c), dtype=np.int8),
        verdicts=((0.0, Note("watch.healthy")),), title="Tank <1>",
    )  # fmt: skip
    return replace(record, **changes)


def test_an_alarm_with_two_causes_has_two_rows(baseline: Baseline) -> None:
    record = record_of(baseline, 50, dict.fromkeys(range(20, 30), "leak or supply_low"))
    record.values[29] += [
        fault.alarm * fault.direction if fault.direction else fault.alarm for fault in record.plan.faults
    ]
    first, second = alarm_rows(record, baseline)
    assert first[:3] == ["leak", "2", "2.9"]
    assert '<td>leak</td><td class="number" data-name="from [s]">2</td>' in watch_page(record, baseline)
    assert second[:3] == ["or supply_low", "", ""]
    assert first[3] == f"+{first[4]}"
    assert second[3] == f"-{second[4]}"
    page = watch_page(record, baseline)
    assert all(f">{cell}<" in page for cell in (*first, *(cell for cell in second if cell)))
    assert "1 alarm." in page
    assert "1 alarm." in record_summary(record, baseline)


def test_change_and_alarm_size_have_the_same_unit(baseline: Baseline) -> None:
    record = record_of(baseline, 50, dict.fromkeys(range(20, 30), "leak"))
    record.values[29, 0] = baseline.faults[0] + 0.7 * record.plan.faults[0].alarm
    (row,) = alarm_rows(record, baseline)
    change, size = (cell.split(" ", 1) for cell in row[3:5])
    assert change[1] == size[1]
    assert float(change[0]) == pytest.approx(0.7 * float(size[0]), rel=0.01)


def test_texts_of_users_are_escaped_and_pages_are_reproducible(baseline: Baseline) -> None:
    record = record_of(baseline, 30)
    page = watch_page(record, baseline)
    assert "Tank &lt;1&gt;" in page
    assert "<1>" not in page
    assert "No alarm." in page
    assert page == watch_page(record, baseline)


def test_an_alarm_of_one_sample_is_visible_in_a_long_record(baseline: Baseline) -> None:
    n = 200_000
    record = record_of(baseline, n)
    record.probabilities[123_457, 0] = 0.999
    record.values[123_457, 0] += 5.0
    intervals = intervals_of(record)
    assert intervals.time.size <= MOST_INTERVALS
    assert intervals.highest(record.probabilities[:, 0]).max() == 0.999
    assert intervals.highest(record.values[:, 0]).max() == record.values[123_457, 0]
    assert len(watch_page(record, baseline)) < 1_500_000


@pytest.mark.parametrize("n", [0, 1, 2])
def test_records_with_few_samples_have_a_page(baseline: Baseline, n: int, tmp_path: Path) -> None:
    page = write_watch(record_of(baseline, n), baseline, tmp_path / "day.html").read_text(encoding="utf-8")
    assert ("No sample could be used." in page) == (n == 0)


def test_a_record_without_readings_has_a_page(baseline: Baseline) -> None:
    n = 40
    missing = np.full((n, len(baseline.plan.channels)), np.nan)
    unused = np.zeros_like(missing, dtype=np.int8)
    record = record_of(
        baseline, n, readings=missing, deviations=missing, used=unused, nis=np.full(n, np.nan),
        counts=np.zeros(n, dtype=np.int64),
    )  # fmt: skip
    page = watch_page(record, baseline)
    assert "not defined" in page
    assert f'<td class="number" data-name="missing">{n}</td>' in page


def test_an_interrupted_evaluation_is_stated(baseline: Baseline) -> None:
    assert "interrupted" in watch_page(record_of(baseline, 10, is_complete=False), baseline)

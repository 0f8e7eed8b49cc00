"""Records of a watch: alarms with their start and end, and the CSV file."""

from __future__ import annotations

import csv
from pathlib import Path

import numpy as np
import pytest

from poppet.monitoring.baseline import Baseline
from poppet.monitoring.record import AlarmEpisode, WatchRecord
from poppet.report.watch_text import alarm_rows, record_summary
from refusals import refused
from watched_tank import plan_of_tank

PLAN = plan_of_tank()


def record_of(alarms):
    n = len(alarms)
    readings = np.full((n, 1), 5e5)
    values = np.tile(PLAN.reference[:2], (n, 1))
    return WatchRecord(
        PLAN, np.arange(float(n)), values, 0.1 * np.abs(values) + 1e-12, np.full((n, 2), 0.4), np.full(n, np.nan),
        np.ones(n, dtype=np.int64), tuple(alarms), readings, readings, np.ones((n, 1)), np.ones((n, 1), dtype=np.int8),
    )  # fmt: skip


def test_alarms_have_a_start_and_an_end():
    record = record_of(["", "leak", "leak", "leak or supply_low", "", "leak and supply_low"])
    assert record.episodes == (
        AlarmEpisode(("leak",), 1.0, 2.0, is_open=False, last=2),
        AlarmEpisode(("leak", "supply_low"), 3.0, 3.0, is_open=False, last=3),
        AlarmEpisode(("leak", "supply_low"), 5.0, 5.0, is_open=True, last=5, are_joint=True),
    )
    first_cells = [row[0] for row in alarm_rows(record, Baseline.of_circuit(PLAN))]
    assert first_cells == ["leak", "leak", "or supply_low", "leak", "and supply_low"]


def test_a_record_without_alarms():
    assert record_of(["", ""]).episodes == ()
    assert record_of([]).episodes == ()
    assert "No sample" in record_summary(record_of([]), Baseline.of_circuit(PLAN))


def test_a_file_has_one_row_per_sample(tmp_path):
    path = tmp_path / "states.csv"
    record = record_of(["", "leak or supply_low"] * 12_000)
    record.save(path)
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    assert tuple(rows[0]) == record.columns
    assert len(rows) == 24_000
    assert (rows[1]["time [s]"], rows[1]["nis"], rows[1]["alarm"]) == ("1.0", "", "leak or supply_low")
    assert float(rows[-1]["supply_low [Pa]"]) == pytest.approx(7e5, rel=1e-8)


def test_an_empty_record_is_not_written(tmp_path):
    with refused("files.no_rows"):
        record_of([]).save(tmp_path / "states.csv")
    assert not list(Path(tmp_path).iterdir())

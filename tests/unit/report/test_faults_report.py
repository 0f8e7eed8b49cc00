"""Report of a fault table: consequences of each fault, and their counts."""

from __future__ import annotations

import re

import pytest

from pages import needs_nothing_else
from poppet.audit.fault_result import Consequence, FaultRow, FaultTable, OmittedFault
from poppet.report.audit.faults_report import effects_of, faults_page

WAITS = Consequence("waits", "plc", time=2.1, healthy=0.4, facts={"step": "extend"})
SHORT = Consequence("not_reached", "load", 0.1, 0.2, "m")
MOVES = Consequence("moves_without_command", "load", 0.05, None, "m", 1.3)
STAYS = Consequence("pressure_stays", "cylinder.cap", 5e5, 0.0, "Pa", 0.3, {"threshold": 5e4})
ROWS = (
    FaultRow("first", "stuck_open", (WAITS, SHORT)),
    FaultRow("first", "stuck_closed", (MOVES, STAYS)),
    FaultRow("first", "leak", (Consequence("none", "first"),)),
    FaultRow("second", "slow", (Consequence("cycle_time", "plc", 2.4, 2.1, "s"),)),
    FaultRow("second", "stuck", (Consequence("pressure_high", "tank", 8e5, 6e5, "Pa"),)),
)
TABLE = FaultTable("Press", 1.0, 10.0, 5e4, ROWS, (OmittedFault("check", "slow", "It has no switching time."),), 2.1)


@pytest.fixture(scope="module")
def page() -> str:
    return faults_page(TABLE)


def test_each_valve_has_a_section(page):
    headings = re.findall(r"<h2>(.*?)</h2>", page)
    assert headings == ["Faults of first", "Faults of second", "Faults without a run"]
    needs_nothing_else(page)


def test_every_consequence_is_a_sentence_of_the_page(page):
    for row in ROWS:
        for consequence in row.consequences:
            assert f"<li>{consequence.note}</li>" in page
    assert "It has no switching time." in page


def test_effects_are_counted(page):
    counts = dict(re.findall(r"<tr><td>([^<]*)</td><td class=\"number\">(\d) of 5</td></tr>", page))
    assert counts == {
        "The machine stops: a step waits or times out": "1",
        "A body moves without a command": "1",
        "A body does not reach its position, or passes it": "1",
        "A volume keeps its pressure": "1",
        "A pressure is too high": "1",
        "The fault remains hidden": "1",
    }
    assert [effects_of(row) for row in ROWS] == [
        {"stops", "position"}, {"moves_without_command", "pressure_stays"}, {"hidden"}, set(),
        {"pressure_high"},
    ]  # fmt: skip


def test_an_interrupted_table_says_so():
    page = faults_page(FaultTable("Press", 1.0, 10.0, 5e4, ROWS[:1], is_whole=False))
    assert "The runs were interrupted" in page
    assert "Faults without a run" not in page

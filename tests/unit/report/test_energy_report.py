"""Report of an energy audit: sections, printed numbers, and the Sankey diagram of the balance."""

from __future__ import annotations

import math
import re
from dataclasses import replace
from pathlib import Path

import pytest

import poppet
from pages import needs_nothing_else
from poppet.audit.energy import audit_energy
from poppet.audit.energy_result import (
    CATEGORIES,
    BalanceRow,
    Cycle,
    EnergyAudit,
    FlowPathAir,
    LeakRow,
    PartRow,
    SavingRow,
)
from poppet.audit.moves import find_moves
from poppet.audit.tariff import read_tariff
from poppet.cli.audit import energy_summary
from poppet.core.codes import Note
from poppet.report.audit.energy_report import (
    balance_table,
    energy_page,
    leak_table,
    move_table,
    part_table,
    sankey_of,
    saving_table,
)

EXAMPLES = Path(__file__).parents[3] / "examples"
ROWS = (
    ("supply", "supply", "supplied", 230.0, 453.25),
    ("load", "load", "work", 60.0, 60.0),
    ("cylinder", "cylinder", "friction", 25.0, 25.0),
    ("load", "load", "friction", 11.0, 11.0),
    ("valve.supply_a", "valve", "throttling", 0.0, 150.0),
    ("valve.exhaust_a", "valve", "throttling", 0.0, 61.0),
    ("throttle", "throttle", "throttling", 0.0, 98.0),
    ("fitting_1", "fitting_1", "throttling", 0.0, 1.25),
    ("fitting_2", "fitting_2", "throttling", 0.0, 2.0),
    ("cylinder.cap", "cylinder", "mixing", 0.0, 21.0),
    ("cylinder.cap", "cylinder", "heat", -30.0, 10.0),
    ("ambient", "ambient", "exhausted", 164.0, 10.0),
    ("cylinder.cap", "cylinder", "stored", 0.0, 4.0),
)


def audit(**changes: object) -> EnergyAudit:
    values = {
        "title": "Press",
        "cycle": Cycle(2.0, 4.1, 1, "sequence", "plc", ("out", "back")),
        "air": {"supply": 2.34e-3},
        "rows": tuple(BalanceRow(*row) for row in ROWS),
        "flow_paths": (FlowPathAir("valve.supply_a", "valve", "supply", "cylinder.cap", 1.2e-3, 1.25e-3, 150.0),),
        "parts": (PartRow("cylinder", 2.2e-3, 56.0, "friction"), PartRow("valve", 0.0, 211.0, "throttling")),
        "leaks": (LeakRow("leak", "leak.flow", 1.4e-4, 5.0, 12.3),),
        "savings": (
            SavingRow("supply.pressure = 5 bar g", 3.3e-4, 80.0, 31.0, 62.0, 2.3),
            SavingRow("reuse of exhaust air", 8e-4, 130.0, 75.0, 150.0, 2.1, is_bound=True),
        ),
        "tariff": read_tariff({"tariff": "0.20 EUR/kWh", "emission": "0.4 kg/kWh"}),
    }
    return EnergyAudit(**{**values, **changes})


@pytest.fixture(scope="module")
def page() -> str:
    return energy_page(audit())


def test_page_has_a_section_for_each_result(page):
    headings = re.findall(r"<h2>(.*?)</h2>", page)
    assert headings == ["Exergy flow", "Balance", "Parts", "Flow paths", "Leaks", "Savings", "Tariff"]
    needs_nothing_else(page)


def test_the_summary_prints_air_cost_and_co2(page):
    """2.34 l at 0.12 kWh/m^3 and 0.20 EUR/kWh, 4000 h a year and 2.1 s a cycle."""
    cost = 2.34e-3 * 0.12 * 0.20 * 4000 * 3600 / 2.1
    assert f">{cost:.4g} EUR<" in page
    assert f">{cost / 0.2 * 0.4:.4g} kg<" in page
    for text in ("2.34 l ANR", "66.86 l/min ANR", "453.2 J", "13.2 % of the exergy"):
        assert f">{text}<" in page


def test_links_of_the_sankey_diagram_sum_to_the_printed_balance():
    nodes, links = sankey_of(audit())
    printed = {row[0]: float(row[2]) for row in balance_table(audit()).cells()}
    labels = {node.name: node.label for node in nodes}
    inflow = {name: math.fsum(link.value for link in links if link.target == name) for name in labels}
    outflow = {name: math.fsum(link.value for link in links if link.source == name) for name in labels}
    assert inflow["cycle"] == pytest.approx(outflow["cycle"], rel=1e-12)
    assert inflow["cycle"] == pytest.approx(453.25, rel=1e-12)
    for category in CATEGORIES[1:-1]:
        assert inflow[category] == pytest.approx(printed[labels[category]], rel=5e-4)
        if category != "stored":  # below 1 % of the supply
            assert outflow[category] == pytest.approx(inflow[category], rel=1e-12)
    texts = {node.name: node.text for node in nodes}
    assert (texts["throttling"], texts["throttling/valve"], texts["throttling/2 others"]) == (
        "312.2 J",
        "211 J",
        "3.25 J",
    )


def test_the_drawn_widths_are_the_printed_numbers(page):
    drawn = re.search(r'<figure class="desk">.*?</figure>', page, re.DOTALL)[0]
    widths = {}
    for path, title in re.findall(r'<path d="(M.*?Z)".*?<title>(.*?)</title>', drawn):
        numbers = [float(text) for text in re.findall(r"-?\d+\.?\d*", path)]
        widths[title] = numbers[-1] - numbers[1]
    supply = widths["Supplied by supply to One cycle: 453.2 J"]
    for title, width in widths.items():
        assert width / supply * 453.25 == pytest.approx(float(title.split(": ")[1].removesuffix(" J")), abs=0.06)
    assert sum(widths[title] for title in widths if title.startswith("One cycle")) == pytest.approx(supply, abs=1e-3)


def test_released_exergy_flows_into_the_cycle():
    rows = [BalanceRow(*row) for row in ROWS]
    rows[-1] = replace(rows[-1], exergy=-6.0)
    nodes, links = sankey_of(audit(rows=tuple(rows)))
    assert next(node for node in nodes if node.name == "stored")[1:3] == ("Released by volumes", "6 J")
    assert next(node for node in nodes if node.name == "cycle").text == "459.2 J"
    assert not [link for link in links if link.source == "stored"]
    assert "Released by volumes to One cycle: 6 J" in energy_page(audit(rows=tuple(rows)))


def test_a_bound_is_marked_as_a_bound():
    first, second = saving_table(audit()).cells()
    assert first == ["supply.pressure = 5 bar g", "0.33", "80", "31 EUR", "62 kg", "14.1", "2.3 s"]
    assert second[1:5] == ["≤ 0.8", "≤ 130", "≤ 75 EUR", "≤ 150 kg"]


def test_leaks_have_a_flow_per_minute():
    assert leak_table(audit()).cells() == [["<code>leak.flow</code>", "0.14", "4", "5", "12.3 EUR"]]
    assert "No flow path leaks" in energy_page(audit(leaks=()))


def test_a_page_without_tariff_has_no_cost():
    page = energy_page(audit(tariff=None, leaks=(LeakRow("leak", "leak.flow", 1e-4, 5.0, math.nan),), savings=()))
    assert "Tariff" not in page
    assert "nan" not in page.replace("finance", "")


def test_large_machines_are_shown_in_kilojoules():
    rows = tuple(BalanceRow(n, p, c, 1e3 * e, 1e3 * x) for n, p, c, e, x in ROWS)
    assert ">453.2 kJ<" in energy_page(audit(rows=rows, notes=(Note("said", text="A note."),)))


def test_air_below_the_accuracy_of_its_division_is_zero():
    parts = (PartRow("cylinder", 2.2e-3, 56.0, "friction"), PartRow("rail", -1.4e-7, 0.1, "mixing"))
    result = audit(parts=parts)
    assert [row[1:3] for row in part_table(result).rows] == [("2.2", "94.0"), ("0", "0.0")]
    assert re.search(r"^rail +0\.00000 ", energy_summary(result), re.MULTILINE)
    assert result.content()["parts"][1]["air_l_anr"] == pytest.approx(-1.4e-4)


def test_notes_are_in_the_section_of_their_topic():
    notes = (Note("said", text="General."), Note("savings.failed", "half", reason="It sticks."))
    sections = re.split(r"<h2>", energy_page(audit(notes=notes)))
    assert "General." in sections[0]
    (savings,) = (section for section in sections if section.startswith("Savings"))
    assert "The measure half is not possible. It sticks." in savings


def test_moves_and_step_diagrams_of_a_machine():
    circuit = poppet.load(EXAMPLES / "two_cylinders.toml")
    result = audit_energy(circuit)
    page = energy_page(result, circuit)
    assert re.findall(r"<h2>(.*?)</h2>", page)[-2:] == ["Moves", "Steps"]
    rows = move_table(find_moves(circuit, result.recording, (result.cycle.start, result.cycle.end))).cells()
    assert [(re.sub("<.*?>", "", row[0]), row[1]) for row in rows] == [
        ("slideA", "A+"), ("slideB", "B+"), ("slideB", "B-"), ("slideA", "A-"),
    ]  # fmt: skip
    assert [float(row[3].removesuffix(" mm")) for row in rows] == pytest.approx([100, 50, -50, -100], abs=1.0)

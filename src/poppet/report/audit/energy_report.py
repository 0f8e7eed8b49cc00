"""HTML report of an energy audit: Sankey diagram, balances, air, leaks, savings and moves."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.audit.energy_result import (
    CATEGORIES,
    EXHAUSTED,
    FRICTION,
    HEAT,
    INTEGRATION,
    LITRE,
    MIXING,
    STORED,
    SUPPLIED,
    THROTTLING,
    WORK,
    EnergyAudit,
)
from poppet.audit.moves import Move
from poppet.core.codes import Note
from poppet.core.number_format import pretty
from poppet.report.audit.sankey import NARROW, WIDE, SankeyLink, SankeyNode, draw_sankey
from poppet.report.html_page import Section, document, findings, folded, head, paragraph, picture, write_page
from poppet.report.step_diagram import draw_step_diagram, sequences_of
from poppet.report.styles import stylesheet
from poppet.report.tables import Column, Markup, ReportTable, code, numeric
from poppet.timeseries.plotting.figures import GREY, PALETTE, style

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit
    from poppet.timeseries.recording import Recording

LABELS = {
    SUPPLIED: "Supplied air",
    WORK: "Work on loads",
    FRICTION: "Friction, end stops",
    THROTTLING: "Throttling",
    MIXING: "Mixing",
    HEAT: "Heat",
    EXHAUSTED: "Exhausted air",
    STORED: "Stored",
    INTEGRATION: "Integration error",
}
"""Name of each category in tables and figures."""
_COLOURS = dict(zip(CATEGORIES, (PALETTE[0], PALETTE[2], PALETTE[4], PALETTE[1], PALETTE[3], PALETTE[6], PALETTE[5],
                                 PALETTE[7], GREY), strict=True))  # fmt: skip
_RELEASED = {STORED: "Released by volumes", WORK: "Work of loads", HEAT: "Exergy of heat"}
"""Names of categories that supply exergy."""
_MOTION = {"m": ("mm", 1e3), "rad": ("deg", 180.0 / math.pi)}
FEW_PATHS = 12
"""Maximum number of flow paths whose table is unfolded."""
NEGLIGIBLE = 1e-6
"""Fraction of the largest row below which a value is shown as 0, and omitted in the Sankey diagram."""
SMALLEST_PART = 0.01
"""Fraction of the supplied exergy below which the parts of a category share one node of the Sankey diagram."""
_SANKEY = (
    "Exergy of one cycle. The width of each flow is proportional to its value; flows below 1 % of the supply share one "
    "node. The residual of the balance is {residual:.1e} of the sum of all rows."
)
_TIGHT = "No flow path leaks during the cycle."
_BOUND = (
    "An upper bound (≤) is computed, not simulated. All other savings are differences between two simulated cycles."
)


def write_energy(audit: EnergyAudit, path: str | Path, circuit: BaseCircuit | None = None) -> Path:
    """Write the report of an energy audit as a self-contained HTML page.

    Parameters
    ----------
    audit : EnergyAudit
        Result of the audit.
    path : str or Path
        File name with the suffix `.html`.
    circuit : Circuit, optional
        The audited circuit, for its step diagrams.

    Returns
    -------
    Path
        The written file.
    """
    return write_page(path, lambda: energy_page(audit, circuit))


def energy_page(audit: EnergyAudit, circuit: BaseCircuit | None = None) -> str:
    """Return the report of an energy audit as HTML."""
    title = audit.title or "Energy audit"
    with style("A report of an energy audit"):
        sections = [
            Section(
                "", [head(audit.title or "Energy audit", _lead(audit)), _summary(audit), findings(_notes(audit, ""))]
            ),
            Section("Exergy flow", _sankey_figures(audit)),
            Section("Balance", [balance_table(audit), folded(f"All rows ({len(audit.rows)})", _row_table(audit))]),
            Section("Parts", [_supply_table(audit), part_table(audit)]),
            Section("Flow paths", _path_section(audit)),
            Section("Leaks", [leak_table(audit) or paragraph(_TIGHT), findings(_notes(audit, "leaks"))]),
            Section("Savings", [saving_table(audit), _bound(audit), findings(_notes(audit, "savings"))]),
            Section("Moves", move_table(audit.moves)),
            Section("Steps", _step_figures(circuit, audit.recording)),
            Section("Tariff", _tariff_table(audit)),
        ]
    return document(title, sections, style=stylesheet("audit"))


def _lead(audit: EnergyAudit) -> str:
    cycle = audit.cycle
    period = "one cycle" if cycle.count == 1 else f"{cycle.count} cycles"
    source = f" of {cycle.source}" if cycle.source else ""
    return (
        f"Energy audit of {period}{source}, from {cycle.start:.5g} to {cycle.end:.5g} s. All values are per cycle of "
        f"{cycle.duration:.4g} s."
    )


class _Joules:
    """Number format of energies: one unit for the whole page."""

    def __init__(self, audit: EnergyAudit) -> None:
        self.largest = max((abs(row.exergy) for row in audit.rows), default=0.0)
        kilo, milli = self.largest >= 1e4, self.largest < 0.1
        self.unit, self.factor = ("kJ", 1e-3) if kilo else ("mJ", 1e3) if milli else ("J", 1.0)

    def text(self, value: float) -> str:
        """Return a value in the unit of the page, without the unit; a value that is negligible is 0."""
        return f"{value * self.factor:z.4g}" if abs(value) > NEGLIGIBLE * self.largest else "0"

    def with_unit(self, value: float) -> str:
        return f"{self.text(value)} {self.unit}"


def _litres(audit: EnergyAudit, volume: float) -> str:
    """Return a volume in litres as text; a volume that is negligible is 0."""
    return f"{volume / LITRE:z.4g}" if abs(volume) > NEGLIGIBLE * audit.air_used else "0"


def _percent(value: float, whole: float) -> str:
    return f"{100.0 * value / whole:z.1f}" if whole else ""


def _money(audit: EnergyAudit, value: float) -> str:
    return "" if audit.tariff is None or math.isnan(value) else f"{_plain(value)} {audit.tariff.currency}"


def _plain(value: float) -> str:
    """Return a value with four significant digits, without an exponent for large values."""
    return f"{value:.4g}" if abs(value) < 1e4 else f"{value:.0f}"


def _summary(audit: EnergyAudit) -> str:
    """Return the key results as HTML."""
    joules, supplied = _Joules(audit), audit.exergy_supplied
    flow = audit.air_used / audit.cycle.duration / LITRE * 60.0
    rows = [
        ("Air", f"{audit.air_used / LITRE:.4g} l ANR", f"{flow:.4g} l/min ANR"),
        ("Exergy supplied", joules.with_unit(supplied), ""),
        ("Work on loads", joules.with_unit(audit.work), f"{_percent(audit.work, supplied)} % of the exergy"),
    ]
    if audit.tariff is not None:
        cycles = audit.tariff.cycles_per_year(audit.cycle.duration)
        if not math.isnan(audit.cost):
            thousand = f"{_money(audit, 1e3 * audit.cost)} per 1000 cycles"
            rows.append(("Cost per year", _money(audit, audit.cost * cycles), thousand))
        if not math.isnan(audit.co2):
            thousand = f"{_plain(1e3 * audit.co2)} kg per 1000 cycles"
            rows.append(("CO₂ per year", f"{_plain(audit.co2 * cycles)} kg", thousand))
    table = ReportTable(("", Column("", "s"), ""), rows).html()
    return f'<div class="summary">{table}</div>\n'


def _sankey_figures(audit: EnergyAudit) -> str:
    """Return the Sankey diagram as HTML, in one width for screens and in another for phones."""
    nodes, links = sankey_of(audit)
    caption = _SANKEY.format(residual=abs(audit.residual()))
    return "".join(
        picture(drawing, f"sankey-{kind[:4]}", caption, kind=kind)
        for kind, width in (("desk", WIDE), ("narrow phone", NARROW))
        if (drawing := draw_sankey(nodes, links, width))
    )


def sankey_of(audit: EnergyAudit) -> tuple[list[SankeyNode], list[SankeyLink]]:
    """Return nodes and links of the exergy balance: from the supplies to the categories, and to their parts [J]."""
    joules = _Joules(audit)
    by_part: dict[str, dict[str, float]] = {category: defaultdict(float) for category in CATEGORIES}
    for row in audit.rows:
        by_part[row.category][row.part] += row.exergy
    nodes, links = [], []

    def add(category: str, name: str, label: str, source: str, value: float) -> None:
        nodes.append(SankeyNode(name, label, joules.with_unit(abs(value)), _COLOURS[category]))
        links.append(SankeyLink(source, name, value, joules.with_unit(abs(value))))

    for part, value in by_part[SUPPLIED].items():
        name, text = f"{SUPPLIED}/{part}", joules.with_unit(value)
        nodes.append(SankeyNode(name, f"Supplied by {part}", text, _COLOURS[SUPPLIED]))
        links.append(SankeyLink(name, "cycle", value, text))
    # Released exergy, for example from volumes whose pressure falls, also flows into the cycle.
    losses = [category for category in CATEGORIES if category != SUPPLIED]
    inflow = [link.value for link in links] + [-audit.total(category) for category in losses]
    total = math.fsum(value for value in inflow if value > 0.0)
    nodes.append(SankeyNode("cycle", "One cycle", joules.with_unit(total), GREY))
    for category in losses:
        value = audit.total(category)
        if abs(value) <= NEGLIGIBLE * audit.exergy_supplied:
            continue
        label = LABELS[category] if value >= 0.0 else _RELEASED.get(category, LABELS[category])
        add(category, category, label, "cycle", value)
        if value <= 0.0:
            continue
        parts = _main_parts(by_part[category], SMALLEST_PART * audit.exergy_supplied)
        for label, part_value in parts if category != INTEGRATION else ():
            add(category, f"{category}/{label}", label, category, part_value)
    return nodes, links


def _main_parts(values: dict[str, float], smallest: float) -> list[tuple[str, float]]:
    """Return the parts with the largest values, and the sum of the others as one item.

    The result is empty if all values are small.
    """
    large = sorted(((part, value) for part, value in values.items() if abs(value) >= smallest), key=lambda p: -p[1])
    if not large:
        return []
    others = [value for value in values.values() if abs(value) < smallest and value != 0.0]
    if len(others) == 1:  # the name is not longer than a collective one
        return large + [(part, value) for part, value in values.items() if 0.0 < abs(value) < smallest]
    return large + ([(f"{len(others)} others", math.fsum(others))] if others else [])


def balance_table(audit: EnergyAudit) -> ReportTable:
    """Return the energy and the exergy per cycle of each category."""
    joules, supplied = _Joules(audit), audit.exergy_supplied
    rows = [
        (
            LABELS[category],
            joules.text(audit.total(category, quantity="energy")),
            joules.text(audit.total(category)),
            _percent(audit.total(category), supplied),
        )
        for category in CATEGORIES
        if any(row.category == category for row in audit.rows)
    ]
    residuals = f"{audit.residual('energy'):.1e} of the energy and {audit.residual():.1e} of the exergy"
    caption = f"The supply equals the sum of all other rows. Residuals, relative to the sum of all rows: {residuals}."
    columns = numeric(f"energy [{joules.unit}]", f"exergy [{joules.unit}]", "% of the supply")
    return ReportTable(("", *columns), rows, caption)


def _row_table(audit: EnergyAudit) -> ReportTable:
    joules = _Joules(audit)
    rows = [
        (_path_code(row.name), LABELS[row.category], joules.text(row.energy), joules.text(row.exergy))
        for row in audit.rows
    ]
    return ReportTable(("row", "", *numeric(f"energy [{joules.unit}]", f"exergy [{joules.unit}]")), rows)


def _supply_table(audit: EnergyAudit) -> ReportTable | str:
    if len(audit.air) < 2:
        return ""
    rows = [(code(name), volume / LITRE, _percent(volume, audit.air_used)) for name, volume in audit.air.items()]
    columns = Column("air [l ANR]", "z.4g"), Column("%", "s")
    return ReportTable(("supply", *columns), rows, "Air that each reservoir or source supplies.")


def part_table(audit: EnergyAudit) -> ReportTable:
    """Return the air and the lost exergy of each part, with the largest loss first."""
    joules, supplied = _Joules(audit), audit.exergy_supplied
    rows = [
        (
            code(row.part),
            _litres(audit, audit.shown_air(row)),
            _percent(audit.shown_air(row), audit.air_used),
            joules.text(row.exergy_lost),
            _percent(row.exergy_lost, supplied),
            LABELS.get(row.category, row.category).lower(),
        )
        for row in sorted(audit.parts, key=lambda row: -row.exergy_lost)
    ]
    columns = numeric("air [l ANR]", "% of the air", f"exergy lost [{joules.unit}]", "% of the exergy")
    return ReportTable(("part", *columns, "mainly by"), rows, "Air that each part consumes, and exergy that it loses.")


def _path_code(address: str) -> Markup:
    """Return the address of a mass flow rate as that of its flow path."""
    return code(address.removesuffix("mass_flow_rate").rstrip("._"))


def _path_section(audit: EnergyAudit) -> str:
    count = len(audit.flow_paths)
    return folded(f"Air and throttling ({count})", _path_table(audit), is_open=count <= FEW_PATHS)


def _path_table(audit: EnergyAudit) -> ReportTable:
    joules = _Joules(audit)
    rows = [
        (
            _path_code(path.name),
            f"{path.source or 'outside'} → {path.target or 'outside'}",
            _litres(audit, path.air),
            _litres(audit, path.backward),
            joules.text(path.throttling),
        )
        for path in sorted(audit.flow_paths, key=lambda path: -path.throttling)
    ]
    columns = numeric("air [l ANR]", "backwards [l ANR]", f"lost [{joules.unit}]")
    return ReportTable(("flow path", "", *columns), rows)


def leak_table(audit: EnergyAudit) -> ReportTable:
    """Return the leaks, with the largest first."""
    joules, minutes = _Joules(audit), audit.cycle.duration / 60.0
    rows = [
        (
            _path_code(leak.flow_path),
            f"{leak.air / LITRE:.4g}",
            f"{leak.air / LITRE / minutes:.4g}",
            joules.text(leak.exergy),
            _money(audit, leak.cost_per_year),
        )
        for leak in sorted(audit.leaks, key=lambda leak: -leak.air)
    ]
    columns = numeric("air [l ANR]", "flow [l/min ANR]", f"exergy lost [{joules.unit}]", "cost per year")
    return ReportTable(("leak", *columns), rows)


def saving_table(audit: EnergyAudit) -> ReportTable:
    """Return the simulated effect of each measure."""
    joules = _Joules(audit)
    rows = []
    for row in audit.savings:
        sign = "≤ " if row.is_bound else ""
        texts = [f"{row.air / LITRE:z.4g}", joules.text(row.exergy)]
        texts += ["" if math.isnan(row.cost_per_year) else _money(audit, row.cost_per_year)]
        texts += ["" if math.isnan(row.co2_per_year) else f"{_plain(row.co2_per_year)} kg"]
        time = f"{row.cycle_time:.4g} s"
        rows.append((row.measure, *(f"{sign}{text}" if text else "" for text in texts),
                     _percent(row.air, audit.air_used), time))  # fmt: skip
    columns = numeric(
        "air [l ANR]", f"exergy [{joules.unit}]", "cost per year", "CO₂ per year", "% of the air", "cycle time"
    )
    return ReportTable(("measure", *columns), rows, "Saved air, exergy, cost and CO₂ of each measure alone.")


def move_table(moves: Iterable[Move]) -> ReportTable:
    """Return the moves of a machine cycle, in the order of their starts."""
    rows = []
    for move in moves:
        unit, factor = _MOTION.get(move.unit, (move.unit, 1.0))
        times = ("" if value is None else f"{value:.4g}" for value in (move.command_time, move.stroke_time, move.dwell))
        command_time, stroke_time, dwell = times
        impact = "" if move.impact_speed is None else f"{factor * move.impact_speed:.4g} {unit}/s"
        travel = f"{factor * move.travel:z.4g} {unit}"
        rows.append((code(move.body), move.step, command_time, travel, stroke_time, impact, dwell))
    columns = numeric("command at [s]", "travel", "stroke time [s]", "impact", "dwell [s]")
    caption = (
        "The stroke time is from the command to the stop; the dwell is from the stop to the next move of the body."
    )
    return ReportTable(("body", "step", *columns), rows, caption)


def _notes(audit: EnergyAudit, topic: str) -> list[Note]:
    """Return the notes of a section; those of the topics `leaks` and `savings` have sections of their own."""
    topics = {note: note.code.partition(".")[0] for note in audit.notes}
    own = ("leaks", "savings")
    return [note for note, name in topics.items() if (name == topic if topic else name not in own)]


def _bound(audit: EnergyAudit) -> str:
    return paragraph(_BOUND if any(row.is_bound for row in audit.savings) else "")


def _step_figures(circuit: BaseCircuit | None, recording: Recording | None) -> str:
    if circuit is None or recording is None or not recording.time.size:
        return ""
    figures = ""
    for name in sequences_of(circuit):
        figure = draw_step_diagram(circuit, recording, sequence=name)
        figure.texts[0].set_visible(not circuit.title)  # the page shows the title
        figures += picture(figure, f"steps-{name}", f"The step sequence {name}.", is_still=True)
    return figures


def _tariff_table(audit: EnergyAudit) -> ReportTable | str:
    if audit.tariff is None or (audit.tariff.price is None and audit.tariff.emission is None):
        return ""
    rows = [
        (name.replace("_", " "), pretty(number.display()), str(number.source))
        for name, number in audit.tariff.numbers()
    ]
    return ReportTable(("", Column("value", "s"), "source"), rows, "Values behind cost and CO₂.")

"""Command `poppet audit energy`: air, energy, exergy, cost, leaks and savings of one machine cycle."""

from __future__ import annotations

import argparse
import math
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.cli.assignments import load_circuit, named_by_options, read_assignments
from poppet.cli.progress import Spinner
from poppet.cli.summary import print_notes, require_matplotlib, write_result
from poppet.core.number_format import aligned
from poppet.core.toml_file import TomlFile

if TYPE_CHECKING:
    from poppet.audit.energy_result import EnergyAudit
    from poppet.audit.savings import Measure
    from poppet.circuit.circuit import BaseCircuit


def audit_energy(options: argparse.Namespace) -> int:
    """Run the command `audit energy`: audit one machine cycle of a circuit.

    The result is the exit code.
    """
    from poppet.audit.circuit_leaks import find_leaks
    from poppet.audit.energy import audit_energy as audit
    from poppet.audit.savings import find_savings
    from poppet.audit.tariff import FIELDS, tariff_of
    from poppet.core.errors import InputError

    require_matplotlib(options.report)
    circuit, notes = load_circuit(options)
    measures = read_measures(options.saving)
    try:
        for measure in measures or ():
            circuit.with_values(measure.values)  # an invalid measure is an error before the runs
        given = {name: vars(options)[name] for name in ("tariff", *FIELDS) if vars(options)[name] is not None}
        with named_by_options({f"audit.{name}": f"--{name.replace('_', '-')}" for name in given}):
            tariff = tariff_of(circuit, given)
        settings: dict[str, Any] = {
            "cycle": options.cycle, "step": options.cycle_from or "", "count": options.cycles,
            "duration": options.duration, "tariff": tariff,
        }  # fmt: skip

        def run(changed: BaseCircuit) -> EnergyAudit:
            return audit(changed, **settings)

        with Spinner("simulating", is_quiet=options.quiet):
            result = run(circuit)
            leaks, leak_notes = find_leaks(circuit, result, run, options.leak)
        result = replace(result, leaks=leaks, notes=(*result.notes, *leak_notes))
        if not options.no_savings:
            with Spinner("simulating savings", is_quiet=options.quiet):
                savings, saving_notes = find_savings(circuit, result, run, measures)
            result = replace(result, savings=savings, notes=(*result.notes, *saving_notes))
    except InputError as error:
        raise TomlFile.read(options.file).located(error) from None
    print_notes([*notes, *result.notes])

    def write_report(path: Path) -> None:
        from poppet.report.audit.energy_report import write_energy

        write_energy(result, path, circuit)

    write_result(options, result, energy_summary(result), write_report)
    return 0


def read_measures(texts: list[str]) -> list[Measure] | None:
    """Return the measures of the option --saving; None if there are none, for the default measures.

    Examples
    --------
    >>> read_measures(["cylinder.bore=25 mm, supply.pressure=5 bar g"])[0].values
    {'cylinder.bore': '25 mm', 'supply.pressure': '5 bar g'}
    """
    from poppet.audit.savings import Measure

    return [Measure(text, read_assignments(text.split(","), "--saving")) for text in texts] or None


def energy_summary(audit: EnergyAudit) -> str:
    """Return the result of an energy audit as text for a terminal: cycle, exergy balance and parts."""
    from poppet.audit.energy_result import CATEGORIES, LITRE

    cycle = audit.cycle
    count = f", mean of {cycle.count} cycles" if cycle.count > 1 else ""
    source = "stated" if cycle.found_by == "stated" else f"of {cycle.source}"
    facts = [
        ["cycle", f"{cycle.duration:.6g}", "s", f"{source}, from {cycle.start:.6g} s to {cycle.end:.6g} s{count}"],
        ["air", f"{audit.air_used / LITRE:.6g}", "l ANR", ""],
        ["supplied exergy", f"{audit.exergy_supplied:.6g}", "J", ""],
        ["work on loads", f"{audit.work:.6g}", "J", ""],
    ]
    if audit.tariff is not None:
        cycles, hours = audit.tariff.cycles_per_year(cycle.duration), audit.tariff.hours.display()
        for name, value, unit in (("cost", audit.cost, audit.tariff.currency), ("CO2", audit.co2, "kg")):
            if not math.isnan(value):
                facts.append([f"{name} per year", f"{value * cycles:.4g}", unit, f"{cycles:.4g} cycles in {hours}"])
    balance = [["balance", "energy [J]", "exergy [J]", "% of supply"]]
    for category in CATEGORIES:
        energy, exergy = audit.total(category, quantity="energy"), audit.total(category)
        share = 100.0 * exergy / audit.exergy_supplied if audit.exergy_supplied > 0.0 else math.nan
        balance.append([category, f"{energy:z.4f}", f"{exergy:z.4f}", "" if math.isnan(share) else f"{share:z.2f}"])
    residuals = (f"{audit.residual(quantity):.1e}" for quantity in ("energy", "exergy"))
    balance.append(["residual / sum of rows", *residuals, ""])
    parts = [["part", "air [l ANR]", "lost exergy [J]", "mainly by"]]
    parts += [
        [row.part, f"{audit.shown_air(row) / LITRE:z.5f}", f"{row.exergy_lost:z.4f}", row.category]
        for row in audit.parts
    ]
    tables = aligned(facts, (1,)), aligned(balance, range(1, 4)), aligned(parts, (1, 2))
    texts = _move_text(audit), _leak_text(audit), _saving_text(audit), _tariff_text(audit)
    return "\n\n".join(filter(None, [audit.title, *tables, *texts]))


def _move_text(audit: EnergyAudit) -> str:
    rows = [["move", "step", "command [s]", "stroke time [s]", "travel", "impact", "dwell [s]"]]
    for move in audit.moves:
        unit, factor = ("mm", 1e3) if move.unit == "m" else ("deg", 180.0 / math.pi)
        impact = "" if move.impact_speed is None else f"{factor * move.impact_speed:.4g} {unit}/s"
        times = (move.command_time, move.stroke_time, move.dwell)
        command, stroke, dwell = ("" if time is None else f"{time:.4g}" for time in times)
        rows.append([move.body, move.step, command, stroke, f"{factor * move.travel:.4g} {unit}", impact, dwell])
    return aligned(rows, range(2, 7)) if audit.moves else ""


def _leak_text(audit: EnergyAudit) -> str:
    from poppet.audit.energy_result import LITRE

    currency = "" if audit.tariff is None else audit.tariff.currency
    heads = ["leak", "air [l ANR]", "lost exergy [J]", *([f"cost [{currency}/year]"] if currency else [])]
    rows = [
        [
            leak.flow_path,
            f"{leak.air / LITRE:.5f}",
            f"{leak.exergy:.4f}",
            *([f"{leak.cost_per_year:.4g}"] * bool(currency)),
        ]
        for leak in audit.leaks
    ]
    return aligned([heads, *rows], range(1, len(heads))) if rows else ""


def _saving_text(audit: EnergyAudit) -> str:
    from poppet.audit.energy_result import LITRE

    currency = "" if audit.tariff is None else audit.tariff.currency
    heads = ["saving", "air [l ANR]", "exergy [J]", "cycle [s]", *([f"cost [{currency}/year]"] if currency else [])]
    rows = []
    for row in audit.savings:
        values = [f"{row.air / LITRE:.5f}", f"{row.exergy:.4f}", f"{row.cycle_time:.5g}"]
        values += [f"{row.cost_per_year:.4g}"] if currency else []
        rows.append([f"{row.measure}, upper bound" if row.is_bound else row.measure, *values])
    return aligned([heads, *rows], range(1, len(heads))) if rows else ""


def _tariff_text(audit: EnergyAudit) -> str:
    """Return the values behind cost and CO2 with their sources; empty if there is neither."""
    if audit.tariff is None or (audit.tariff.price is None and audit.tariff.emission is None):
        return ""
    return aligned(
        [[name.replace("_", " "), number.display(), str(number.source)] for name, number in audit.tariff.numbers()],
        (1,),
    )

"""Command `poppet audit energy`: air, energy and exergy of one machine cycle."""

from __future__ import annotations

import argparse
import math
from typing import TYPE_CHECKING

from poppet.cli.assignments import load_circuit
from poppet.cli.progress import Spinner
from poppet.cli.summary import print_notes, print_written
from poppet.core.number_format import aligned
from poppet.core.toml_file import TomlFile

if TYPE_CHECKING:
    from poppet.audit.energy_result import EnergyAudit


def audit_energy(options: argparse.Namespace) -> int:
    """Run the command `audit energy`: audit one machine cycle of a circuit.

    The result is the exit code.
    """
    from poppet.audit.energy import audit_energy as audit
    from poppet.core.errors import InputError

    circuit, notes = load_circuit(options)
    try:
        with Spinner("simulating", is_quiet=options.quiet):
            result = audit(
                circuit, cycle=options.cycle, step=options.cycle_from or "", count=options.cycles,
                duration=options.duration,
            )  # fmt: skip
    except InputError as error:
        raise TomlFile.read(options.file).located(error) from None
    print_notes([*notes, *result.notes])

    if options.output:
        result.save(options.output)
    print(energy_summary(result))
    print_written(options.output)
    return 0


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
    for name, value, unit in (("cost", audit.cost, "currency"), ("CO2", audit.co2, "kg")):
        if not math.isnan(value):
            word = audit.tariff.currency if unit == "currency" and audit.tariff is not None else unit
            facts.append([name, f"{value:.4g}", word, ""])
    balance = [["balance", "energy [J]", "exergy [J]", "% of supply"]]
    for category in CATEGORIES:
        energy, exergy = audit.total(category, quantity="energy"), audit.total(category)
        share = 100.0 * exergy / audit.exergy_supplied if audit.exergy_supplied > 0.0 else math.nan
        balance.append([category, f"{energy:.4f}", f"{exergy:.4f}", f"{share:.2f}"])
    residuals = (f"{audit.residual(quantity):.1e}" for quantity in ("energy", "exergy"))
    balance.append(["residual / sum of rows", *residuals, ""])
    parts = [["part", "air [l ANR]", "lost exergy [J]", "mainly by"]]
    parts += [[row.part, f"{row.air / LITRE:.5f}", f"{row.exergy_lost:.4f}", row.category] for row in audit.parts]
    tables = aligned(facts, (1,)), aligned(balance, range(1, 4)), aligned(parts, (1, 2))
    return "\n\n".join(filter(None, [audit.title, *tables]))

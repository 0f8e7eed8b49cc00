"""Commands `poppet audit safety` (exhaust times and travels) and `poppet faults` (consequences of single faults)."""

from __future__ import annotations

import argparse

from poppet.cli.assignments import load_circuit, named_by_options, read_assignments, split_list
from poppet.cli.main import INTERRUPTED
from poppet.cli.progress import CaseProgress
from poppet.cli.summary import print_notes, require_matplotlib, write_result

OPTIONS = {name: f"--{name}" for name in ("threshold", "duration", "kinds", "samples")}
"""Options of the commands by the names of Python arguments."""


def run_audit(options: argparse.Namespace) -> int:
    """Run the command `audit safety`: report exhaust times and travels after an event.

    The result is the exit code.
    """
    from poppet.audit.safety import audit_safety
    from poppet.audit.valve_faults import STUCK_KINDS
    from poppet.report.audit.safety_report import write_safety
    from poppet.report.audit.safety_text import safety_text

    require_matplotlib(options.report)
    events = read_assignments(options.event, "--event", 'supply.pressure="0 bar g"')
    circuit, notes = load_circuit(options)
    with named_by_options(OPTIONS | {"at": "--at"}), CaseProgress(is_quiet=options.quiet) as progress:
        audit = audit_safety(
            circuit,
            events,
            at="steps" if options.at == ["steps"] else options.at or None,
            threshold=options.threshold,
            duration=options.duration,
            kinds=STUCK_KINDS if options.kinds is None else split_list(options.kinds),
            samples=options.samples,
            seed=options.seed,
            progress=progress,
        )
    print_notes([*notes, *audit.notes])
    write_result(options, audit, safety_text(audit), lambda path: write_safety(audit, path))
    return 0 if audit.is_whole else INTERRUPTED


def run_faults(options: argparse.Namespace) -> int:
    """Run the command `faults`: report the consequences of every single fault.

    The result is the exit code.
    """
    from poppet.audit.fault_table import fault_table
    from poppet.parts.faults import FAULTS
    from poppet.report.audit.faults_report import write_faults
    from poppet.report.audit.safety_text import faults_text

    require_matplotlib(options.report)
    circuit, notes = load_circuit(options)
    with named_by_options(OPTIONS | {"start": "--at"}), CaseProgress(is_quiet=options.quiet) as progress:
        table = fault_table(
            circuit,
            kinds=FAULTS if options.kinds is None else split_list(options.kinds),
            start=options.at,
            duration=options.duration,
            threshold=options.threshold,
            progress=progress,
        )
    print_notes([*notes, *table.notes])
    write_result(options, table, faults_text(table), lambda path: write_faults(table, path))
    return 0 if table.is_whole else INTERRUPTED

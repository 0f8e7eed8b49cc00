"""`poppet export check`: the same run by every target, compared with the kernel."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from poppet.cli.assignments import assignments, changed, listed, with_result
from poppet.cli.main import FAILED
from poppet.cli.parser import REPORT, SET, WITH, Option, tell_written
from poppet.cli.progress import Waiting

EXAMPLES = (
    "poppet export check FILE.toml",
    'poppet export check FILE.toml --duration "2 s" --report parity.html',
    'poppet export check FILE.toml --only "c adaptive,structured text"',
    "poppet export check valve.fmu",
)
OPTIONS = (
    Option("FILE", "circuit file (.toml), or an FMU of one (.fmu), which alone is run then"),
    Option("--circuit FILE", "of an FMU that does not carry its own"),
    Option("--duration TIME", 'of the run, "2 s"; that of the file when left out'),
    Option("--only LIST", "targets wanted, by name; all when left out"),
    WITH,
    SET,
    REPORT,
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.circuit.file import load
    from poppet.deploy.fmu.hosts import fmi_version
    from poppet.deploy.fmu.origin import circuit_of
    from poppet.deploy.parity import parity
    from poppet.deploy.parity.parity_report import not_run, rows_table, write_parity

    values = assignments(options.values)
    if options.duration is not None:
        values |= {"run.duration": options.duration}
    fmu = Path(options.file) if str(options.file).lower().endswith(".fmu") else None
    if fmu is None:
        known = load(options.file)
    else:
        fmi_version(fmu)  # what is no FMU says so here
        known = load(options.circuit) if options.circuit is not None else circuit_of(fmu)
    circuit, _ = changed(with_result(known, options.result)[0], values)
    with Waiting("Every target runs the circuit"):
        found = parity(circuit, only=listed(options.only), fmu=fmu)
    print(rows_table(found).text())
    for line in not_run(found):
        print(f"not run: {line}", file=sys.stderr)
    if options.report is not None:
        write_parity(found, options.report)
    tell_written(options.report)
    return 0 if found.is_well else FAILED

"""`poppet export check`: the same run by every target, compared with the kernel."""

from __future__ import annotations

import argparse
import sys

from poppet.cli.assignments import assignments, changed, listed
from poppet.cli.main import FAILED
from poppet.cli.parser import FILE, REPORT, SET, Option, tell_written
from poppet.cli.progress import Waiting

EXAMPLES = (
    "poppet export check FILE.toml",
    'poppet export check FILE.toml --duration "2 s" --report parity.html',
    'poppet export check FILE.toml --only "c adaptive,structured text"',
)
OPTIONS = (
    FILE,
    Option("--duration TIME", 'of the run, "2 s"; that of the file when left out'),
    Option("--only LIST", "targets wanted, by name; all when left out"),
    SET,
    REPORT,
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.circuit.file import load
    from poppet.deploy.parity import parity
    from poppet.deploy.parity.page import not_run, rows_table, write_parity

    values = assignments(options.values)
    if options.duration is not None:
        values |= {"run.duration": options.duration}
    circuit, _ = changed(load(options.file), values)
    with Waiting("Every target runs the circuit"):
        found = parity(circuit, only=listed(options.only))
    print(rows_table(found).text())
    for line in not_run(found):
        print(f"not run: {line}", file=sys.stderr)
    if options.report is not None:
        write_parity(found, options.report)
    tell_written(options.report)
    return 0 if found.is_well else FAILED

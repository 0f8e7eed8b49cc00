"""Run the ten circuits of the tests by every target, and write the table into docs/parity.md; some ten minutes."""

from __future__ import annotations

import datetime
import platform
import re
import subprocess
import sys
from importlib import import_module
from pathlib import Path

from poppet.core.version import __version__
from poppet.deploy.parity.parity_table import ParityRow, compare_targets

ROOT = Path(__file__).parents[1]
PAGE = ROOT / "docs" / "parity.md"
BEGIN, END = "<!-- written by tools/parity_table.py -->\n", "<!-- until here -->"
COLUMNS = {
    "C adaptive": "c adaptive",
    "WebAssembly": "wasm",
    "FMU CS": "fmu cs",
    "FMI 3 CS": "fmu 3 cs",
    "second host": "fmu cs (second host)",
    "FMU ME": "fmu me",
    "FMI 3 ME": "fmu 3 me",
    "LSODA": "scipy",
    "CVODES": "cvodes",
    "C 1 kHz": "c 1 kHz",
    "C 10 kHz": "c 10 kHz",
    "C 1 kHz / 100": "c 1 kHz / 100",
    "controllers": "controllers",
    "fused": "kernel fused",
}
STEPS = ("regime", "contact")
"""How outputs end that go in whole numbers: a hair of time is a difference of one."""


def main() -> int:
    """Run the circuits."""
    sys.path.insert(0, str(ROOT / "tests"))
    heads = ["circuit", "run [s]", *COLUMNS]
    lines = [heads, ["---", *["---:"] * (len(heads) - 1)]]
    is_well = True
    for name, circuit in import_module("circuits_of_exports").TEN.items():
        parity = compare_targets(circuit(), only=list(COLUMNS.values()))
        rows = {row.name: row for row in parity.rows}
        lines.append(
            [name, f"{parity.duration:g}", *(_cell(rows[target], parity.duration) for target in COLUMNS.values())]
        )
        print(" | ".join(lines[-1]), flush=True)
        is_well &= parity.is_within_limits
    commit = subprocess.run(
        ["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=True
    ).stdout.strip()
    when = f"Written on {datetime.datetime.now(datetime.UTC):%Y-%m-%d} by version {__version__}, commit {commit}, "
    where = f"on {platform.machine()} with {platform.system()}.\n\n"
    table = when + where + "".join(f"| {' | '.join(line)} |\n" for line in lines)
    text = PAGE.read_text(encoding="utf-8")
    new = re.sub(f"{re.escape(BEGIN)}.*{re.escape(END)}", lambda _: BEGIN + table + END, text, flags=re.DOTALL)
    PAGE.write_text(new, encoding="utf-8")
    return 0 if is_well else 1


def _cell(row: ParityRow, duration: float) -> str:
    """Greatest difference that is compared; where that is not the whole run, until when, and states in all of it."""
    if row.greatest is None:
        return "-"
    smooth = max(gap for output, gap in row.differences.items() if not output.endswith(STEPS))
    if row.check.cause == "anything" and smooth < row.greatest:
        return f"{smooth:.0e}; a regime"
    shown = "0" if row.greatest == 0.0 else f"{row.greatest:.0e}"
    if row.verdict in ("coarse", "beyond"):
        shown = f"**{shown}**"
    is_whole = row.until > 0.9 * duration or row.check.cause == "anything"
    if is_whole or row.overall == 0.0:
        return shown
    return f"{shown} until {row.until:.3g}; {row.drift:.0e} ({row.moved:.0e})"


if __name__ == "__main__":
    sys.exit(main())

"""`poppet ensemble`: many runs of a circuit file with uncertain numbers."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.cli.assignments import loaded
from poppet.cli.main import INTERRUPTED
from poppet.cli.parser import FILE, QUIET, REPORT, SET, WITH, Option
from poppet.cli.progress import Running
from poppet.cli.summary import ask_for_drawing
from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.note_groups import grouped

if TYPE_CHECKING:
    from poppet.ensemble import Ensemble, EnsemblePlan

EXAMPLES = (
    "poppet ensemble ensemble.toml",
    "poppet ensemble ensemble.toml --runs 100000 -o bench/ensemble --report ensemble.html",
    "poppet ensemble ensemble.toml --scheduler tcp://bench:8786",
)
EXECUTORS = {"threads": "of this process, the default", "processes": "of this machine"}
OPTIONS = (
    FILE,
    WITH,
    SET,
    Option("-o, --output FOLDER", "where the dataset lies; NAME.ensemble beside a file NAME.toml by default"),
    REPORT,
    Option("--worst FOLDER", "write the worst runs of each requirement as circuit files"),
    Option("--runs N", "number of runs", more={"type": int}),
    Option("--seed N", "of the random numbers", more={"type": int}),
    Option("--executor NAME", "who runs it", choices=EXECUTORS, rival="executor"),
    Option("--scheduler ADDRESS", "address of a Dask scheduler, whose workers run it", rival="executor"),
    Option("--workers N", "threads or processes; one for each processor by default", more={"type": int}),
    QUIET,
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    from poppet.ensemble import run_plan

    ask_for_drawing(options.report)
    plan, notes = _plan(options)
    for note in grouped(notes):
        print(f"note: {note}", file=sys.stderr)
    folder = Path(options.output) if options.output else Path(options.file).with_suffix(".ensemble")
    executor = options.scheduler or options.executor or "threads"
    with Running(is_quiet=options.quiet) as progress:
        found = run_plan(plan, folder, executor, options.workers, progress)
    if not found.is_whole:
        print(Note("ensemble.interrupted", done=found.done, runs=plan.runs, path=str(folder)), file=sys.stderr)
        return INTERRUPTED
    for note in found.remarks():
        print(f"note: {note}", file=sys.stderr)
    written = _write(options, found)
    if not options.quiet:
        print("\n".join([summary(found), *written]))
    return 0


def _plan(options: argparse.Namespace) -> tuple[EnsemblePlan, list[Note]]:
    from poppet.core.toml_file import TomlFile
    from poppet.ensemble import plan_of

    circuit, notes = loaded(options)
    given: dict[str, Any] = {
        key: getattr(options, key) for key in ("runs", "seed") if getattr(options, key) is not None
    }
    try:
        plan = plan_of(circuit, **given)
    except InputError as error:
        raise TomlFile.read(options.file).located(error) from None
    # What a run with the numbers as they stand has to say, the others may have to say as well.
    return plan, [*notes, *circuit.simulate(throw=False).remarks]


def _write(options: argparse.Namespace, found: Ensemble) -> list[str]:
    written = [f"{found.folder}: {found.done} runs."]
    if options.worst:
        written += [f"{path}: written." for path in found.save_worst(options.worst)]
    if options.report:
        from poppet.report.ensemble.ensemble_report import write_ensemble

        written.append(f"{write_ensemble(found, options.report)}: written.")
    return written


def summary(found: Ensemble) -> str:
    """What a person reads in a terminal."""
    from poppet.report.ensemble.ensemble_report import metric_table, yield_table

    lines = [found.plan.circuit.title] if found.plan.circuit.title else []
    for table in (yield_table(found), metric_table(found)):
        lines += ["", table.text()] if table.rows else []
    return "\n".join(lines)

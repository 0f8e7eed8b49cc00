"""Commands `poppet ensemble` (runs with uncertain parameters) and `poppet size` (sizing of a parameter)."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING

from poppet.cli.assignments import load_circuit
from poppet.cli.main import FAILED, INTERRUPTED
from poppet.cli.progress import EnsembleProgress, PointProgress
from poppet.cli.summary import print_notes, print_written, require_matplotlib, write_result
from poppet.core.codes import Note
from poppet.core.errors import InputError

if TYPE_CHECKING:
    from poppet.ensemble import Ensemble


def run_ensemble(options: argparse.Namespace) -> int:
    """Run the command `ensemble`: run a circuit many times with uncertain parameters.

    The result is the exit code.
    """
    from poppet.core.toml_file import TomlFile
    from poppet.ensemble import plan_of, run_plan

    require_matplotlib(options.report)
    circuit, notes = load_circuit(options)
    settings = {key: getattr(options, key) for key in ("runs", "seed") if getattr(options, key) is not None}
    try:
        plan = plan_of(circuit, allow_python=options.allow_python, **settings)
    except InputError as error:
        raise TomlFile.read(options.file).located(error) from None
    # The notes of the nominal run are likely to apply to the other runs.
    print_notes([*notes, *circuit.simulate(throw=False).remarks])
    folder = Path(options.output) if options.output else Path(options.file).with_suffix(".ensemble")
    executor = options.scheduler or options.executor or "threads"
    with EnsembleProgress(is_quiet=options.quiet) as progress:
        ensemble = run_plan(plan, folder, executor, options.workers, progress)
    if not ensemble.is_whole:
        print(Note("ensemble.interrupted", done=ensemble.done, runs=plan.runs, path=str(folder)), file=sys.stderr)
        return INTERRUPTED
    for note in ensemble.remarks():
        print(f"note: {note}", file=sys.stderr)
    worst_files = ensemble.save_worst(options.worst) if options.worst else []
    if options.report:
        from poppet.report.ensemble_report import write_ensemble

        write_ensemble(ensemble, options.report)
    print(ensemble_summary(ensemble))
    print(f"{ensemble.folder}: {ensemble.done} runs.")
    print_written(*worst_files, options.report)
    return 0


def ensemble_summary(ensemble: Ensemble) -> str:
    """Return the tables of yields and metrics of an ensemble as text for a terminal."""
    from poppet.report.ensemble_report import metric_table, yield_table

    lines = [ensemble.plan.circuit.title] if ensemble.plan.circuit.title else []
    for table in (yield_table(ensemble), metric_table(ensemble)):
        lines += ["", table.text()] if table.rows else []
    return "\n".join(lines)


def find_size(options: argparse.Namespace) -> int:
    """Run the command `size`: find the smallest or largest parameter value that meets the requirements.

    The result is the exit code.
    """
    from poppet.core.toml_file import TomlFile
    from poppet.core.units import quantity
    from poppet.ensemble import size
    from poppet.report.ensemble_report import sizing_text, write_sizing

    require_matplotlib(options.report)
    circuit, notes = load_circuit(options)
    required_yield = vars(options)["yield"]
    share = None if required_yield is None else quantity(required_yield, "1", name="--yield").value
    print_notes([*notes, *circuit.static_notes])
    try:
        with PointProgress(is_quiet=options.quiet) as progress:
            sizing = size(
                circuit,
                options.free,
                meet=options.meet,
                between=tuple(options.between) if options.between else None,
                largest=options.largest,
                share=share,
                sizes=options.size,
                allow_python=options.allow_python,
                progress=progress,
            )
    except InputError as error:
        raise TomlFile.read(options.file).located(error) from None
    write_result(options, sizing, sizing_text(sizing), lambda path: write_sizing(sizing, path))
    return 0 if sizing.is_met else FAILED

"""Commands `poppet ensemble` (runs with uncertain parameters) and `poppet size` (sizing of a parameter)."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, Any

from poppet.cli.assignments import load_circuit
from poppet.cli.main import FAILED, INTERRUPTED
from poppet.cli.progress import EnsembleProgress, SizingProgress, Spinner
from poppet.cli.summary import print_notes, print_written, require_matplotlib, write_result
from poppet.core.codes import Note
from poppet.core.errors import InputError, raise_errors

if TYPE_CHECKING:
    from poppet.circuit.circuit import BaseCircuit
    from poppet.ensemble import CatalogueSizing, Ensemble, Sizing

    _Found = tuple[Sizing | CatalogueSizing, str, Callable[[Path], Any]]


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
    circuit.require_equations()
    # The notes of the nominal run are likely to apply to the other runs.
    with Spinner("The nominal run is computed", is_quiet=options.quiet):
        remarks = circuit.simulate(throw=False).remarks
    print_notes([*notes, *remarks])
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
    """Run the command `size`: find the parameter value or the component that meets the requirements.

    The result is the exit code.
    """
    from poppet.core.toml_file import TomlFile

    _check_subject(options)
    require_matplotlib(options.report)
    with SizingProgress(is_quiet=options.quiet) as progress:
        circuit, notes = load_circuit(options)
        settings = {
            "meet": options.meet,
            "largest": options.largest,
            "allow_python": options.allow_python,
            "progress": progress,
        }
        try:
            search = _search_catalogue if options.catalogue else _search_values
            sizing, text, write_report = search(options, circuit, settings)
        except InputError as error:
            raise TomlFile.read(options.file).located(error) from None
    print_notes([*notes, *circuit.static_notes])
    write_result(options, sizing, text, write_report)
    return 0 if sizing.is_met else FAILED


def _check_subject(options: argparse.Namespace) -> None:
    """Raise an error unless either a parameter or a part is to be sized, with options for it only."""
    if not options.free and not options.catalogue:
        raise InputError("size.subject")
    of_parameter = {"--between": options.between, "--yield": vars(options)["yield"], "--size": options.size}
    misplaced = of_parameter if options.catalogue else {"--find": options.find}
    code = "size.not_of_catalogue" if options.catalogue else "size.not_of_parameter"
    raise_errors([InputError(code, option=option) for option, value in misplaced.items() if value])


def _search_values(options: argparse.Namespace, circuit: BaseCircuit, settings: dict[str, Any]) -> _Found:
    from poppet.core.units import quantity
    from poppet.ensemble import size
    from poppet.report.ensemble_report import sizing_text, write_sizing

    required_yield = vars(options)["yield"]
    share = None if required_yield is None else quantity(required_yield, "1", name="--yield").value
    between = tuple(options.between) if options.between else None
    sizing = size(circuit, options.free, between=between, share=share, sizes=options.size, **settings)
    return sizing, sizing_text(sizing), lambda path: write_sizing(sizing, path)


def _search_catalogue(options: argparse.Namespace, circuit: BaseCircuit, settings: dict[str, Any]) -> _Found:
    from poppet.ensemble import size_from_catalogue
    from poppet.report.catalogue_report import catalogue_text, write_catalogue_sizing

    sizing = size_from_catalogue(circuit, options.catalogue, find=options.find or "", **settings)
    return sizing, catalogue_text(sizing), lambda path: write_catalogue_sizing(sizing, path)

"""Commands `poppet export` and `poppet live`.

They list, write and check the exports of a circuit.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from poppet.cli.assignments import load_circuit, read_assignments, split_list
from poppet.cli.main import FAILED, WRONG_INPUT
from poppet.cli.parser import output_path
from poppet.cli.progress import Spinner
from poppet.cli.summary import print_notes, print_written
from poppet.core.errors import InputError, NameSuggestion, raise_errors
from poppet.core.files import open_input
from poppet.core.toml_file import TomlFile
from poppet.deploy.targets import TARGETS, CircuitSource, Export, Target


def list_targets(options: argparse.Namespace) -> int:
    """Run the command `export` without a target: print the names and descriptions of all targets."""
    from poppet.cli.commands import COMMANDS

    targets = {target.command: target.summary for target in TARGETS.values()}
    targets["export check"] = COMMANDS["export check"].summary
    if options.target:
        name = f"export {options.target}"
        raise InputError("names.unknown", name, meaning="a command of poppet", suggestion=NameSuggestion(name, targets))
    width = max(map(len, targets))
    print("\n".join(f"poppet {name:<{width}}  {summary}" for name, summary in targets.items()))
    return WRONG_INPUT


def write_target(options: argparse.Namespace) -> None:
    """Run the command `export TARGET`: export a circuit to a target such as `c` or `fmu`."""
    target = TARGETS[options.command.rpartition(" ")[2]]
    if options.output is None and not (target.is_printable or target.mark):
        raise InputError("deploy.no_folder_named")
    path = Path(options.file)
    if is_twin_file(path):
        write_watch(options)
        return
    if options.output is None and target.mark:
        options.output = default_output(path, target)
    circuit, notes = load_circuit(options)
    source = CircuitSource(
        path.read_text(encoding="utf-8"), path.stem, read_assignments(options.values), options.result
    )
    settings = {option.name: getattr(options, option.name) for option in target.options}
    with Spinner("The export is prepared", is_quiet=options.quiet):
        if options.output is None:
            export = target.make(circuit, source, **settings)
        else:
            export = target.write(circuit, options.output, source, **settings)
    print_notes([*notes, *export.notes])
    if options.output is None:
        print("".join(map(str, export.files.values())), end="")
        return
    print_export(target, export, options.output)


def default_output(file: Path, target: Target) -> Path:
    """Return the output file that has the name of a circuit file, in the current folder.

    An existing file is an error, except an export of the same target.
    """
    output = output_path(f"{file.stem}{target.suffixes[0]}", target.suffixes)
    if output.exists():
        with open_input(output) as stream:
            if target.mark not in stream.read():
                raise InputError("deploy.file_taken", path=str(output), command=f"poppet {target.command}")
    return output


def is_twin_file(path: Path) -> bool:
    """Return True if a file has the tables of a twin file."""
    try:
        return {"measured", "faults"} <= TomlFile.read(path).tables.keys()
    except InputError:
        return False  # the reader of circuits reports the error


def write_watch(options: argparse.Namespace) -> None:
    """Export the watch of a twin file to a target."""
    from poppet.deploy.exported_watch import WatchSource
    from poppet.monitoring.baseline import read_baseline
    from poppet.monitoring.twin_file import read_twin_file

    target = TARGETS[options.command.rpartition(" ")[2]]
    problems = [
        InputError("deploy.watch.option", option=option)
        for option, value in (("--set", options.values), ("--with", options.result))
        if value
    ]
    raise_errors(problems)
    settings = {option.name: getattr(options, option.name) for option in target.options}
    if "name" in settings:
        settings["name"] = settings["name"] or Path(options.file).stem
    with Spinner("The export is prepared", is_quiet=options.quiet):
        twin = read_twin_file(options.file)
        watch = WatchSource(twin.plan, read_baseline(twin.baseline, twin.plan), twin.clock, twin.title)
        export = target.write_watch(watch, options.output, **settings)
    print_notes(list(export.notes))
    print_export(target, export, options.output)


def print_export(target: Target, export: Export, output: Path) -> None:
    """Print the summary of an export, and the file or folder that was written."""
    if export.summary:
        print(export.summary)
    if target.suffixes:
        print_written(output)
    else:
        print(f"{output}: {len(export.files)} files.")


def check_targets(options: argparse.Namespace) -> int:
    """Run the command `export check`: compare the runs of all export targets with a simulation.

    The result is the exit code.
    """
    from poppet.circuit.file import load
    from poppet.cosim.archive import check_archive
    from poppet.deploy.fmu.importers import read_circuit
    from poppet.deploy.parity.parity_table import compare_targets, not_run_notes, results_table, write_parity
    from poppet.identify.parameter_file import change_circuit

    changes = read_assignments(options.values)
    if options.duration is not None:
        changes |= {"run.duration": options.duration}
    fmu = Path(options.file) if str(options.file).lower().endswith(".fmu") else None
    if fmu is None:
        circuit = load(options.file)
    else:
        check_archive(fmu)  # before anything is unpacked or executed
        circuit = load(options.circuit) if options.circuit is not None else read_circuit(fmu)
    circuit, _ = change_circuit(circuit, changes, options.result)
    with Spinner("Every target runs the circuit", is_quiet=options.quiet):
        parity = compare_targets(circuit, only=split_list(options.only), fmu=fmu)
    print(results_table(parity).text())
    for line in not_run_notes(parity):
        print(f"not run: {line}", file=sys.stderr)
    if options.report is not None:
        write_parity(parity, options.report)
    print_written(options.report)
    return 0 if parity.is_within_limits else FAILED

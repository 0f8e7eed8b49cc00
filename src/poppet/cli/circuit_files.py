"""Commands that read or write circuit files without a simulation.

They are `poppet check`, `new`, `show`, `draw` and `schema`.
"""

from __future__ import annotations

import argparse
import json
import tomllib
from pathlib import Path

from poppet.cli.assignments import load_circuit
from poppet.cli.parser import output_path
from poppet.cli.summary import print_notes
from poppet.core.errors import InputError, NameSuggestion, raise_errors
from poppet.core.number_format import aligned
from poppet.core.provenance import LEAST_CERTAIN_FIRST as KINDS

TEMPLATES = {path.stem: path for path in sorted(Path(__file__).with_name("templates").glob("*.toml"))}
"""Templates of circuit files by name."""


def check_files(options: argparse.Namespace) -> None:
    """Run the command `check`: report all errors in circuit files, without a simulation."""
    from poppet.circuit.file import load
    from poppet.core.toml_file import TomlFile
    from poppet.serve.file_check import check_file

    problems: list[InputError] = []
    # An error in one file does not prevent the check of the others.
    for file in options.files:
        try:
            circuit = load(file)
        except InputError as error:
            problems.append(error)
            continue
        try:
            check = check_file(circuit, allow_python=True)  # executes nothing
        except InputError as error:
            problems.append(TomlFile.read(file).located(error))
            continue
        text = ", ".join(f"{count} {name}{'s' * (count != 1)}" for name, count in check.counts().items())
        print(f"{file}: no errors; {text}.")
        for name, part in circuit.fmus.items():
            from poppet.report.fmu_text import fmu_summary

            print(f"  {fmu_summary(name, part)}")
        print_notes(check.notes)
    raise_errors(problems)


def write_template(options: argparse.Namespace) -> None:
    """Run the command `new`: write a template of a circuit file, or list all templates."""
    name = options.template
    if name is None:
        width = max(map(len, TEMPLATES))
        for template, path in TEMPLATES.items():
            print(f"{template:<{width}}  {tomllib.loads(path.read_text(encoding='utf-8'))['title']}")
        return
    if name not in TEMPLATES:
        suggestion = NameSuggestion(name, TEMPLATES)
        raise InputError("fields.not_an_option", "template", value=name, meaning="template", suggestion=suggestion)
    # The parser has checked an `--output`; the default name is checked here.
    target: Path = options.output or output_path(f"{name}.toml", (".toml",))
    if target.exists() and not options.force:
        raise InputError("cli.template.exists", path=str(target))

    from poppet.core.files import write_whole

    write_whole(target, lambda stream: stream.write(TEMPLATES[name].read_bytes()))
    print(f"{target}: written. Run it with: poppet simulate {target}")


def show_parameters(options: argparse.Namespace) -> None:
    """Run the command `show`: print all parameters of a circuit, grouped by the kind of their source."""
    if options.kind is not None and options.kind not in KINDS:
        suggestion = NameSuggestion(options.kind, KINDS)
        raise InputError(
            "fields.not_an_option", "--kind", value=options.kind, meaning="kind of source", suggestion=suggestion
        )

    circuit, _ = load_circuit(options)
    kinds = KINDS if options.kind is None else (options.kind,)
    ambient = circuit.surroundings.pressure
    # Kind of source to a row for each parameter: address, value as written, absolute value in SI units, unit, source.
    groups = {
        kind: [
            (address, number.display(), number.absolute(ambient), number.unit, number.source)
            for address, number in circuit.numbers().items()
            if number.source.kind == kind
        ]
        for kind in kinds
    }
    if options.json:
        keys = ("address", "written", "value", "unit", "source", "locator", "note")
        entries = [
            dict(zip(keys, (*row, source.kind, source.locator, source.note), strict=True))
            for rows in groups.values()
            for *row, source in rows
        ]
        print(json.dumps({"title": circuit.title, "numbers": entries}, indent=2))
        return
    texts = [circuit.title] if circuit.title else []
    for kind, rows in groups.items():
        cells = [
            [f"  {address}", text, f"{value:.6g} {unit if unit != '1' else ''}".rstrip(),
             "; ".join(filter(None, (source.locator, source.note)))]
            for address, text, value, unit, source in rows
        ]  # fmt: skip
        # A requested kind is printed even if it has no parameters.
        if rows or options.kind:
            texts.append(f"{kind} ({len(rows)})\n{aligned(cells, [])}" if rows else f"{kind}: none")
    for name, part in circuit.fmus.items():
        from poppet.report.fmu_text import fmu_table

        texts.append(fmu_table(name, part))
    print("\n\n".join(texts))


def draw_schematic(options: argparse.Namespace) -> None:
    """Run the command `draw`: write the schematic of a circuit to a picture file."""
    from poppet.circuit.file import load
    from poppet.report.circuit.schematic import draw_circuit

    circuit = load(options.file)
    draw_circuit(circuit, options.output)
    print(f"{options.output}: {len(circuit.parts)} parts drawn.")


def write_schema(options: argparse.Namespace) -> None:
    """Run the command `schema`: write the JSON schema of circuit files, with which editors check a file."""
    from poppet.core.files import write_whole
    from poppet.ensemble.ensemble_schema import file_schema

    text = json.dumps(file_schema(), indent=2)
    if options.output is None:
        print(text)
        return
    write_whole(options.output, lambda stream: stream.write(f"{text}\n".encode()))
    print(f"{options.output}: written. Use it in an editor to check circuit files.")

"""`poppet show`: the passport of a circuit."""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING

from poppet.cli.assignments import assignments, changed
from poppet.cli.summary import table
from poppet.ground.errors import InputError, suggestion

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit
    from poppet.ground.provenance import Number

EXAMPLES = (
    "poppet show valve-fill.toml",
    "poppet show valve-fill.toml --kind assumed",
    "poppet show valve-fill.toml --json",
)
KINDS = ("assumed", "datasheet", "fitted", "measured", "given", "paper", "standard")
"""Kinds of source; the least certain ones are shown first."""


def add_options(parser: argparse.ArgumentParser) -> None:
    """Declare the options."""
    parser.add_argument("file", metavar="FILE", help="circuit file (.toml)")
    parser.add_argument(
        "--set",
        action="append",
        default=[],
        metavar="ADDRESS=VALUE",
        dest="values",
        help="change a number first",
    )
    parser.add_argument("--kind", metavar="KIND", help=f"only one kind of source: {', '.join(KINDS)}")
    parser.add_argument("--json", action="store_true", help="print JSON, for machines")


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    if options.kind is not None and options.kind not in KINDS:
        raise InputError(f"--kind {options.kind}", "is no kind of source.", suggestion(options.kind, KINDS))
    from poppet.circuit.file import load

    circuit, _ = changed(load(options.file), assignments(options.values))
    kinds = KINDS if options.kind is None else (options.kind,)
    groups = {kind: _of_kind(circuit, kind) for kind in kinds}
    if options.json:
        entries = [_entry(address, number, circuit) for group in groups.values() for address, number in group.items()]
        print(json.dumps({"title": circuit.title, "numbers": entries}, indent=2))
        return 0
    texts = [_text(kind, group, circuit) for kind, group in groups.items() if group or options.kind]
    print("\n\n".join([circuit.title, *texts] if circuit.title else texts))
    return 0


def _of_kind(circuit: Circuit, kind: str) -> dict[str, Number]:
    return {address: number for address, number in circuit.numbers().items() if number.source.kind == kind}


def _entry(address: str, number: Number, circuit: Circuit) -> dict[str, object]:
    return {
        "address": address,
        "written": number.display(),
        "value": number.absolute(circuit.surroundings.pressure),
        "unit": number.unit,
        "source": number.source.kind,
        "locator": number.source.locator,
        "note": number.source.note,
    }


def _text(kind: str, group: dict[str, Number], circuit: Circuit) -> str:
    if not group:
        return f"{kind}: none"
    rows = []
    for address, number in group.items():
        value = number.absolute(circuit.surroundings.pressure)
        si = f"{value:.6g} {number.unit}" if number.unit != "1" else f"{value:.6g}"
        source = number.source
        rows.append(
            [
                f"  {address}",
                number.display(),
                si,
                "; ".join(text for text in (source.locator, source.note) if text),
            ]
        )
    return f"{kind} ({len(group)})\n{table(rows, 4)}"

"""`poppet show`: the passport of a circuit."""

from __future__ import annotations

import argparse
import json
from typing import TYPE_CHECKING

from poppet.cli.assignments import loaded
from poppet.cli.parser import FILE, SET, WITH, Option
from poppet.core.errors import InputError, NameSuggestion
from poppet.core.number_format import aligned
from poppet.core.provenance import LEAST_CERTAIN_FIRST as KINDS

if TYPE_CHECKING:
    from poppet.circuit.circuit import Circuit
    from poppet.core.provenance import Number

EXAMPLES = (
    "poppet show valve-fill.toml",
    "poppet show valve-fill.toml --kind assumed",
    "poppet show valve-fill.toml --json",
)
OPTIONS = (
    FILE,
    WITH,
    SET,
    Option("--kind KIND", f"only one kind of source: {', '.join(KINDS)}"),
    Option("--json", "print JSON, for machines"),
)


def execute(options: argparse.Namespace) -> int:
    """Run the command."""
    if options.kind is not None and options.kind not in KINDS:
        near = NameSuggestion(options.kind, KINDS)
        raise InputError("fields.not_an_option", "--kind", value=options.kind, meaning="kind of source", near=near)

    circuit, _ = loaded(options)
    kinds = KINDS if options.kind is None else (options.kind,)
    groups = {kind: {a: n for a, n in circuit.numbers().items() if n.source.kind == kind} for kind in kinds}
    if options.json:
        entries = [_entry(address, number, circuit) for group in groups.values() for address, number in group.items()]
        print(json.dumps({"title": circuit.title, "numbers": entries}, indent=2))
        return 0
    # A kind that was asked for is named even where there is none of it.
    texts = [_text(kind, group, circuit) for kind, group in groups.items() if group or options.kind]
    print("\n\n".join([circuit.title, *texts] if circuit.title else texts))
    return 0


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
        source = "; ".join(text for text in (number.source.locator, number.source.note) if text)
        rows.append([f"  {address}", number.display(), si, source])
    return f"{kind} ({len(group)})\n{aligned(rows, [])}"

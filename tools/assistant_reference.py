"""Write the texts for assistants from the declarations: `python tools/assistant_reference.py`.

`llms.txt` is a guide, `llms-full.txt` a reference of all kinds of parts, and `series.json` contains the inputs and
outputs of the parts in the examples.
"""

from __future__ import annotations

import json
import re
import tomllib
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import poppet
from poppet.assist.file_tables import described_tables
from poppet.assist.functions import FUNCTIONS
from poppet.assist.kinds import SECTIONS, SERIES, built_in_kinds, fields_of, series_of_kinds, signal_fields
from poppet.circuit import signal_tables
from poppet.circuit.file import ABOVE, TOP_LEVEL
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.cli.circuit_files import TEMPLATES as TEMPLATE_FILES
from poppet.cli.commands import COMMANDS
from poppet.ensemble.metrics import METRIC_KINDS

TEMPLATES = ("cylinder", "machine")
"""Templates that the reference contains as examples."""
ROOT = Path(__file__).parents[1]
FOLDER = ROOT / "src" / "poppet" / "assist"
CIRCUITS = (*sorted((ROOT / "examples").glob("**/*.toml")), *sorted((ROOT / "website" / "circuits").glob("*.toml")))
"""Circuit files whose parts have the inputs and outputs of the reference."""

EXAMPLE = """\
title = "A tank is filled through a valve"

[parts.supply]
kind = "reservoir"
pressure = "6 bar g"

[parts.valve]
kind = "orifice"
from = "supply"
to = "tank"
sonic_conductance = "0.5 dm^3/(s bar)"
critical_ratio = 0.35

[parts.tank]
kind = "chamber"
volume = "10 l"

[signals."valve.opening"]
kind = "steps"
times = ["0 s", "1 s"]
values = [0, 1]

[run]
duration = "30 s"
output_step = "0.1 s"
"""
"""Circuit file of the guide."""
UNITS = (
    "bar g", "bar", "kPa", "psi g", "degC", "K", "l", "cm^3", "mm", "mm^2", "kg", "g/s", "l/min ANR",
    "dm^3/(s bar)", "N", "N/mm", "N s/m", "s", "ms", "deg", "W/K",
)  # fmt: skip
"""Units of the guide."""


def guide_text() -> str:
    """Return how to write and run circuits, with links, in the form of `llms.txt`."""
    lines = [
        "# poppet",
        "",
        "> Python toolkit and command line for electro-pneumatic valves and the loads that they drive: simulation, "
        "identification, sizing, audits, condition monitoring and export.",
        "",
        "A circuit is a TOML file. Names of kinds, fields and outputs are exact: take them from the reference, and run "
        "`poppet check FILE.toml`, which reports all errors with hints.",
        "",
        "## Circuit file",
        "",
        f"- Tables: {_listed((*TOP_LEVEL, *ABOVE))}.",
        '- `[parts.NAME]` has `kind` and the fields of this kind. A port names a reservoir, a chamber or "ambient".',
        '- `[signals."PART.INPUT"]` drives an input; '
        f"`kind` is {_listed(signal_tables.KINDS)}. A number or a text with a unit is a constant.",
        '- `[connections]` connects an input to an output: `"valve.command" = "controller.output"`.',
        f"- Values are numbers in SI units, or texts with a unit: {_listed(UNITS)}. Gauge pressures end with `g`; all "
        "results are absolute.",
        f"- `[ensemble]` has uncertain parameters and metrics ({_listed(METRIC_KINDS)}), `[requirements]` bounds: "
        '`fast = "rise < 450 ms"`.',
        "- `[run]` has `duration`; `stop_when` is a condition such as `tank.pressure > 5 bar`.",
        "",
        "```toml",
        EXAMPLE.rstrip(),
        "```",
        "",
        "## Commands",
        "",
        *(f"- `poppet {name}`: {command.summary}" for name, command in COMMANDS.items()),
        "",
        "## Functions for assistants",
        "",
        "`poppet mcp FOLDER` serves these functions over the Model Context Protocol, `poppet mcp FOLDER --lines` as "
        "lines of JSON.",
        "",
        *(f"- `{name}`: {function.summary}" for name, function in FUNCTIONS.items()),
        "",
        "## Kinds of parts",
        "",
        *(f"- `{name}`: {kind.summary}" for name, kind in built_in_kinds().items()),
        "",
        "## Documentation",
        "",
        *(f"- [{title}]({link}): {meaning}" for title, link, meaning in LINKS),
        "",
    ]
    return "\n".join(lines)


LINKS = (
    ("Reference of all kinds", "llms-full.txt", "fields, units, defaults, inputs, outputs and signals"),
    ("Circuit file", "docs/circuit_file.html", "rules of all tables"),
    ("Command line", "docs/cli.html", "options, exit codes and limits"),
    ("Python", "docs/python.html", "tour of the Python interface"),
    ("Assistants", "docs/assistants.html", "connection, functions, limits and security"),
)
"""Titles, links and meanings of the pages that the guide names."""


def reference_text() -> str:
    """Return all kinds with their fields, inputs, outputs and signals, in the form of `llms-full.txt`."""
    return "\n".join([*_reference(), ""])


def _reference() -> Iterator[str]:
    yield "# Reference of circuit files"
    yield ""
    yield "Fields: name [SI unit], `*` if required, default after `=`, choices in braces; a condition of `*` is in"
    yield "parentheses. Inputs and outputs: name [SI unit], whose address is PART.NAME; the lists are those of the"
    yield "examples."
    for name, owner in zip(SECTIONS, (Run, Ambient, GasChoice), strict=True):
        yield ""
        yield f"## Table `{name}`"
        yield ""
        yield from _field_lines(owner)
    yield ""
    yield "## Signals"
    yield ""
    for kind in signal_tables.KINDS:
        fields = signal_fields(kind)
        yield f"- `{kind}`: " + ", ".join(f"{n}{'*' * row['is_required']}" for n, row in fields.items())
    yield ""
    yield "## Tables for ensembles, audits and identification"
    yield ""
    for name, fields in described_tables().items():
        yield f"- `{name}`: " + ", ".join(_short(field, row) for field, row in fields.items())
    for name in TEMPLATES:
        yield ""
        yield f"## Example `{name}`"
        yield ""
        yield f"```toml\n{TEMPLATE_FILES[name].read_text(encoding='utf-8').strip()}\n```"
    for name, kind in built_in_kinds().items():
        yield ""
        yield f"## Kind `{name}`"
        yield ""
        yield f"{kind.summary}."
        if kind.sizes:
            yield f"Exactly one of: {', '.join(kind.sizes)}."
        yield ""
        yield from _field_lines(kind)
        for which, series in series_of_kinds().get(name, {}).items():
            yield f"- {which}: " + ", ".join(f"{n} [{unit}]" for n, unit in series.items())


def _field_lines(owner: Any) -> Iterator[str]:
    for name, row in fields_of(owner).items():
        unit = f" [{row['unit']}]" if row.get("unit") else ""
        default = f" = {row['default']}" if "default" in row else ""
        choices = f" {{{', '.join(row['choices'])}}}" if "choices" in row else ""
        condition = row.get("is_required")
        choices += f" ({condition})" if isinstance(condition, str) else ""
        choices += f" (names: {', '.join(row['names'])})" if "names" in row else ""
        yield f"- {name}{'*' * bool(condition)}{unit}{default}{choices}: {row['meaning']}"


def _short(name: str, row: dict[str, Any]) -> str:
    """Return a field of a table in a few words."""
    value = f" = {row['value']}" if "value" in row else ""
    choices = f" {{{', '.join(map(str, row['choices'][:8]))}}}" if "choices" in row else ""
    meaning = f" ({row['meaning']})" if row["meaning"] else ""
    return f"{name}{'*' * bool(row.get('is_required'))}{value}{choices}{meaning}"


def _listed(names: Any) -> str:
    return ", ".join(f"`{name}`" for name in names)


def series_json() -> str:
    """Return the inputs and outputs of the parts in the examples, by kind, with their SI units.

    The parts of a sequence have further ones with names of the user: only those that all of them have are listed.
    """
    found: dict[str, dict[str, dict[str, list[str]]]]
    found = {kind: {"inputs": {}, "outputs": {}} for kind in built_in_kinds()}
    count: Counter[str] = Counter()
    for path in CIRCUITS:
        if "parts" not in tomllib.loads(path.read_text(encoding="utf-8")):
            continue
        circuit = poppet.load(path)
        count.update(part.kind for part in circuit.parts.values())
        inputs = [(f"{name}.{i.name}", i.unit) for name, part in circuit.parts.items() for i in part.inputs()]
        series = {"inputs": inputs, "outputs": circuit.symbolic_model.outputs}
        for which, rows in series.items():
            for address, unit in rows:
                name, _, local = address.partition(".")
                if name in circuit.parts and circuit.parts[name].kind in found:
                    local = re.sub(r"^[0-9]+[.]", "N.", local)
                    found[circuit.parts[name].kind][which].setdefault(local, []).append(unit)
    content = {
        # A controller has the units of what it controls.
        kind: {
            which: {
                name: " or ".join(sorted(set(units)))
                for name, units in sorted(rows.items())
                if not built_in_kinds()[kind].is_switching or len(units) == count[kind]
            }
            for which, rows in groups.items()
        }
        for kind, groups in found.items()
    }
    return json.dumps(content, indent=1) + "\n"


def texts() -> dict[Path, str]:
    """Return the texts by path; the inputs and outputs are those of the present `series.json`."""
    return {FOLDER / "llms.txt": guide_text(), FOLDER / "llms-full.txt": reference_text()}


if __name__ == "__main__":
    SERIES.write_text(series_json(), encoding="utf-8")
    series_of_kinds.cache_clear()
    for path, text in texts().items():
        path.write_text(text, encoding="utf-8")

"""Pages of the reference, made of what is declared: parts, sections, commands, codes, file formats, public names."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import poppet
from poppet.circuit import signal_tables
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.circuit.schema import circuit_schema
from poppet.cli.commands import COMMANDS
from poppet.core.message_format import every_code, plain
from poppet.parts import KINDS
from poppet.parts.fields import BodySpec, GroupSpec, MemberSpec, NumberSpec, OptionSpec, PortSpec, specs

ROOT = Path(__file__).resolve().parents[1]
EXAMPLES, CIRCUITS = ROOT / "examples", ROOT / "website" / "circuits"
FIELDS = ("field", "meaning", "unit", "default", "limits")
SECTIONS = {"ambient": Ambient, "gas": GasChoice, "run": Run}
Pages = dict[str, str]
"""Place of a page in the sources, and its text in MyST."""


def pages() -> Pages:
    """All of them."""
    return {
        **part_pages(),
        **code_pages(),
        "reference/sections.md": section_page(),
        "reference/commands.md": command_page(),
        "reference/api.md": api_page(),
        "static/circuit.schema.json": json.dumps(circuit_schema(), indent=1),
    }


def table(heads: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """A table in Markdown; without rows nothing."""
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    heads = list(heads)
    return "\n".join(["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|", *lines, ""]) if lines else ""


def prose(text: str) -> str:
    """Text that Markdown leaves as it is."""
    return re.sub(r"([\\`*_{}\[\]<>#|$~@])", r"\\\1", text)


# --- Parts -----------------------------------------------------------------------------------------------------------


def part_pages() -> Pages:
    """A page for each kind of part, and their list."""
    driven, shown = series("inputs"), series("outputs")
    found = {f"reference/parts/{kind}.md": part_page(kind, driven.get(kind, {}), shown.get(kind, {})) for kind in KINDS}
    rows = [(f"[{kind}]({kind}.md)", KINDS[kind].summary) for kind in KINDS]
    tree = "\n".join(KINDS)
    found["reference/parts/index.md"] = (
        f"# Parts\n\nWhat may stand under `[parts]` of a circuit file.\n\n{table(('kind', 'what it is'), rows)}\n"
        f"```{{toctree}}\n:hidden:\n\n{tree}\n```\n"
    )
    return found


def part_page(kind: str, driven: Mapping[str, str], shown: Mapping[str, str]) -> str:
    """What a kind of part is, takes and gives."""
    part = KINDS[kind]
    text = [f"# `{kind}`", "", f"{part.summary[:1].upper()}{part.summary[1:]}.", ""]
    text += ["## Fields", "", table(FIELDS, fields(part)) or "None.\n"]
    for title, said, of in (
        ("Inputs", "Signals and connections may drive them.", driven),
        ("Outputs", "A recording has them, and connections may take them.", shown),
    ):
        if of:
            rows = [(f"`{name}`", unit) for name, unit in of.items()]
            text += [f"## {title}", "", f"{said} As examples have them; options and fields may add or remove some.", ""]
            text += [table((title[:-1].lower(), "SI unit"), rows)]
    text += [f"In Python: `poppet.{part.__name__}`. [All about circuit files](../../docs/circuit_file.md)", ""]
    return "\n".join(text)


def fields(kind: Any, prefix: str = "") -> Iterator[tuple[str, str, str, str, str]]:
    """Rows of the fields of a part or section."""
    for name, spec in specs(kind).items():
        at = f"`{prefix}{name}`"
        if isinstance(spec, NumberSpec):
            limits = [f"at least {spec.low:g}" if spec.low > -1e300 else f"> {spec.above:g}"]
            limits += [f"at most {spec.high:g}" if spec.high < 1e300 else f"< {spec.below:g}"]
            default = "" if spec.default is None else f"{spec.default}, {spec.source}"
            yield at, spec.doc, spec.unit, default, ", ".join(each for each in limits if "inf" not in each)
        elif isinstance(spec, OptionSpec):
            yield at, spec.doc, "one of", spec.choices[0], ", ".join(f"`{choice}`" for choice in spec.choices)
        elif isinstance(spec, GroupSpec):
            yield from fields(spec.group, f"{prefix}{name}.")
        elif isinstance(spec, MemberSpec):
            member: Any = spec.part
            if member.kind in KINDS:
                yield at, spec.doc, "part", "", f"fields of [`{member.kind}`]({member.kind}.md)"
            else:
                yield from fields(member, f"{prefix}{name}.")
        elif isinstance(spec, PortSpec | BodySpec):
            what = "a store or `ambient`" if isinstance(spec, PortSpec) else "a mass, joint or guide"
            yield at, spec.doc, "name", "", f"{what}{', optional' if spec.optional else ''}"
        else:
            yield at, getattr(spec, "doc", ""), "", "", ""


def series(which: str) -> dict[str, dict[str, str]]:
    """By kind, inputs, connected or not, or outputs that parts have in the examples, with their SI units."""
    found: dict[str, dict[str, set[str]]] = {}
    for path in sorted([*EXAMPLES.glob("**/*.toml"), *CIRCUITS.glob("*.toml")]):
        with path.open("rb") as file:
            if "parts" not in tomllib.load(file):
                continue
        circuit = poppet.load(path)
        owned = [(f"{name}.{own.name}", own.unit) for name, part in circuit.parts.items() for own in part.inputs()]
        for address, unit in owned if which == "inputs" else circuit.model.outputs:
            name, _, local = address.partition(".")
            if name in circuit.parts:
                own = re.sub(r"^[0-9]+[.]", "N.", local)
                found.setdefault(circuit.parts[name].kind, {}).setdefault(own, set()).add(unit)
    # A controller has the units of what it controls.
    return {kind: {n: ", ".join(sorted(own[n])) for n in sorted(own)} for kind, own in found.items()}


def section_page() -> str:
    """The other tables of a circuit file."""
    text = ["# Sections of a circuit file", ""]
    for name, kind in SECTIONS.items():
        text += [f"## `[{name}]`", "", table(FIELDS, fields(kind))]
    text += ["## `[signals]`", "", "Each names an input and says how it moves.", ""]
    rows = []
    for signal in signal_tables.KINDS:
        required, optional = signal_tables.fields_of(signal)
        rows.append((f"`{signal}`", ", ".join(f"`{f}`" for f in required), ", ".join(f"`{f}`" for f in optional)))
    return "\n".join([*text, table(("kind", "required", "optional"), rows)])


# --- Commands --------------------------------------------------------------------------------------------------------


def command_page() -> str:
    """Every command with its options and examples."""
    text = ["# Commands", "", "`poppet COMMAND --help` prints the same.", ""]
    for name, command in COMMANDS.items():
        text += [f"## `poppet {name}`", "", f"{command.summary[:1].upper()}{command.summary[1:]}.", ""]
        text += [*(f"- {limitation}" for limitation in command.limitations), ""] if command.limitations else []
        rows = [(f"`{option.usage}`", option.meaning) for option in command.options]
        text += [
            table(("option", "meaning"), rows),
            "```console",
            *(f"$ {line}" for line in command.examples),
            "```",
            "",
        ]
    return "\n".join(text)


# --- Codes -----------------------------------------------------------------------------------------------------------


def code_pages() -> Pages:
    """All that the house may say, by the first part of its code, each with an anchor of its own."""
    with (ROOT / "tests" / "golden" / "messages.toml").open("rb") as file:
        cases = tomllib.load(file)
    rooms: dict[str, list[str]] = {}
    for code in every_code():
        rooms.setdefault(code.partition(".")[0], []).append(code)
    found = {}
    for room, codes in rooms.items():
        text = [f"# Codes of `{room}`", ""]
        for code in codes:
            text += [f"(code-{code})=", f"## `{code}`", "", *code_lines(code, cases.get(code, {})), ""]
        found[f"reference/codes/{room}.md"] = "\n".join(text)
    rows = [
        (f"[`{room}`]({room}.md)", ", ".join(f"[`{c}`](#code-{c})" for c in codes)) for room, codes in rooms.items()
    ]
    found["reference/codes/index.md"] = "\n".join([
        "# Codes of notes, findings and mistakes",
        "",
        "Whatever is said has a code, for programs; `poppet explain CODE` prints what stands here.",
        "",
        table(("begins with", "codes"), rows),
        "```{toctree}\n:hidden:\n",
        *rooms,
        "```",
        "",
    ])  # fmt: skip
    return found


def code_lines(code: str, case: Mapping[str, Any]) -> Iterator[str]:
    """Meaning and hint of a code, and what it says in a real case."""
    template = every_code()[code]
    if isinstance(template, str):
        yield prose(plain(template))
    else:
        yield f"**What is wrong:** {prose(plain(template['given'] + ' ' + template['reason']))}"
        yield ""
        yield f"**What to do:** {prose(plain(template['hint']))}"
    said = case.get("words") or " ".join(case[part] for part in ("given", "reason", "hint") if part in case)
    told = " ".join(str(said).split())
    if told and told != template:  # what has no facts says the same in every case
        yield from ("", f"> {prose(told)}")


# --- Names of Python --------------------------------------------------------------------------------------------------


def api_page() -> str:
    """Public names with their docstrings."""
    text = ["# Python", "", "[A tour](../docs/python.md) comes first; here is every public name.", ""]
    for module, title in (
        ("poppet", "poppet"),
        ("poppet.iso6358", "poppet.iso6358"),
        ("poppet.signals", "poppet.signals"),
    ):
        found = __import__(module, fromlist=["__all__"])
        text += [f"## `{title}`", ""]
        for name in sorted(found.__all__):
            thing = getattr(found, name)
            if isinstance(thing, type):
                body = [f".. autoclass:: {module}.{name}", "   :members:"]
                if name == "Circuit":  # most of its methods are those of its base class
                    body.append("   :inherited-members:")
            elif callable(thing):
                body = [f".. autofunction:: {module}.{name}"]
            else:
                continue
            text += ["```{eval-rst}", *body, "```", ""]
    return "\n".join(text)

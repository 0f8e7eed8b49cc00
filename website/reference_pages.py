"""Reference pages from declarations: parts, sections, commands, codes, formats, public names."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from typing import Any

import poppet
from field_meanings import meanings
from poppet.circuit import signal_tables
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.circuit.schema import circuit_schema
from poppet.cli.commands import COMMANDS
from poppet.core.message_format import every_code, plain
from poppet.library.components import CatalogueComponent, components
from poppet.parts import KINDS
from poppet.parts.component_search import flow_capacity, printed_flow_deviation
from poppet.parts.components import numbers_of
from poppet.parts.fields import BodySpec, GroupSpec, MemberSpec, NumberSpec, OptionSpec, PortSpec, specs

ROOT = Path(__file__).resolve().parents[1]
EXAMPLES, CIRCUITS = ROOT / "examples", ROOT / "website" / "circuits"
FIELDS = ("field", "meaning", "unit", "default", "limits")
SECTIONS = {"ambient": Ambient, "gas": GasChoice, "run": Run}
Pages = dict[str, str]
"""Text of each page in MyST by its path in the sources."""


def pages() -> Pages:
    """Return all reference pages."""
    return {
        **part_pages(),
        **code_pages(),
        "reference/sections.md": section_page(),
        "reference/commands.md": command_page(),
        "reference/components.md": component_page(),
        "reference/api.md": api_page(),
        "static/circuit.schema.json": json.dumps(circuit_schema(), indent=1),
    }


def table(heads: Iterable[str], rows: Iterable[Iterable[str]]) -> str:
    """Return a Markdown table, empty without rows."""
    lines = ["| " + " | ".join(cell.replace("|", "\\|") for cell in row) + " |" for row in rows]
    heads = list(heads)
    return "\n".join(["| " + " | ".join(heads) + " |", "|---" * len(heads) + "|", *lines, ""]) if lines else ""


def prose(text: str) -> str:
    """Escape text for Markdown."""
    return re.sub(r"([\\`*_{}\[\]<>#|$~@])", r"\\\1", text)


# --- Parts -----------------------------------------------------------------------------------------------------------


def part_pages() -> Pages:
    """Return a page for each kind of part, and their index."""
    inputs, outputs = series("inputs"), series("outputs")
    pages_by_path = {
        f"reference/parts/{kind}.md": part_page(kind, inputs.get(kind, {}), outputs.get(kind, {})) for kind in KINDS
    }
    rows = [(f"[{kind}]({kind}.md)", KINDS[kind].summary) for kind in KINDS]
    tree = "\n".join(KINDS)
    pages_by_path["reference/parts/index.md"] = (
        "# Parts\n\nKinds of parts in the `[parts]` table of a circuit file.\n\n"
        f"{table(('kind', 'description'), rows)}\n"
        f"```{{toctree}}\n:hidden:\n\n{tree}\n```\n"
    )
    return pages_by_path


def part_page(kind: str, inputs: Mapping[str, str], outputs: Mapping[str, str]) -> str:
    """Return the page of a kind of part."""
    part = KINDS[kind]
    text = [f"# `{kind}`", "", f"{part.summary[:1].upper()}{part.summary[1:]}.", ""]
    known = meanings(kind)
    rows = [(name, known.get(name.strip("`"), doc), *more) for name, doc, *more in fields(part)]
    text += ["## Fields", "", table(FIELDS, rows) or "None.\n"]
    for title, intro, names in (
        ("Inputs", "Signals and connections can drive these inputs.", inputs),
        ("Outputs", "Recordings contain these outputs, and connections can use them.", outputs),
    ):
        if names:
            rows = [(f"`{name}`", unit) for name, unit in names.items()]
            text += [
                f"## {title}",
                "",
                f"{intro} The list is that of the examples; options and fields can change it.",
                "",
            ]
            text += [table((title[:-1].lower(), "SI unit"), rows)]
    text += [f"In Python: `poppet.{part.__name__}`. [Circuit files](../../docs/circuit_file.md)", ""]
    return "\n".join(text)


def fields(kind: Any, prefix: str = "") -> Iterator[tuple[str, str, str, str, str]]:
    """Yield the rows of the fields of a part or section."""
    for name, spec in specs(kind).items():
        address = f"`{prefix}{name}`"
        if isinstance(spec, NumberSpec):
            limits = [f"at least {spec.low:g}" if spec.low > -1e300 else f"> {spec.above:g}"]
            limits += [f"at most {spec.high:g}" if spec.high < 1e300 else f"< {spec.below:g}"]
            default = "" if spec.default is None else f"{spec.default}, {spec.source}"
            yield address, spec.doc, spec.unit, default, ", ".join(limit for limit in limits if "inf" not in limit)
        elif isinstance(spec, OptionSpec):
            yield address, spec.doc, "one of", spec.choices[0], ", ".join(f"`{choice}`" for choice in spec.choices)
        elif isinstance(spec, GroupSpec):
            yield from fields(spec.group, f"{prefix}{name}.")
        elif isinstance(spec, MemberSpec):
            member: Any = spec.part
            if member.kind in KINDS:
                yield address, spec.doc, "part", "", f"fields of [`{member.kind}`]({member.kind}.md)"
            else:
                # The compound part sets the inherited fields of its members.
                inherited = {f"{prefix}{name}.{own}" for own in spec.inherited}
                for row in fields(member, f"{prefix}{name}."):
                    own = row[0].strip("`")
                    if own not in inherited and own.rpartition(".")[0] not in inherited:
                        yield row
        elif isinstance(spec, PortSpec | BodySpec):
            what = "a gas node or `ambient`" if isinstance(spec, PortSpec) else "a mass, joint or guide"
            yield address, spec.doc, "name", "", f"{what}{', optional' if spec.optional else ''}"
        else:
            yield address, getattr(spec, "doc", ""), "", "", ""


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
    text += ["## `[signals]`", "", "Each signal has the name of an input.", ""]
    rows = []
    for signal in signal_tables.KINDS:
        required, optional = signal_tables.fields_of(signal)
        rows.append((f"`{signal}`", ", ".join(f"`{f}`" for f in required), ", ".join(f"`{f}`" for f in optional)))
    return "\n".join([*text, table(("kind", "required", "optional"), rows)])


# --- Components ---


def component_page() -> str:
    """All components of the library, with sizes, documents and doubts."""
    text = ["# Components", ""]
    text += ["Components by manufacturer and catalogue number ([rules](../docs/components.md)). The deviation compares"]
    text += ["a printed nominal flow with the flow from C and b. `*` marks an assumed b.", ""]
    heads = ("model", "part", "numbers", "document and doubts")
    by_manufacturer: dict[str, list[CatalogueComponent]] = {}
    for component in components():
        by_manufacturer.setdefault(component.manufacturer, []).append(component)
    for manufacturer, found in by_manufacturer.items():
        text += [f"## {manufacturer}", "", table(heads, map(component_row, found))]
    page = "\n".join(text)
    for plain_unit, unit in {"dm^3/(s bar)": "dm³/(s·bar)", "cm^3": "cm³", "mm^2": "mm²", "degC": "°C"}.items():
        page = page.replace(plain_unit, unit)
    return page


def component_row(component: CatalogueComponent) -> tuple[str, ...]:
    """Return the cells of a component."""
    numbers = {name: number for kind in component.kinds for name, number in numbers_of(component, KINDS[kind]).items()}
    texts = [f"{name.replace('_', ' ')} {number.display()}" for name, number in numbers.items()]
    capacity, computed = flow_capacity(component), printed_flow_deviation(component)
    texts += ["critical ratio 0.3*"] if capacity is not None and capacity.is_assumed else []
    if component.flow is not None and computed is not None:
        texts.append(f"printed flow {component.flow.texts['value']}, deviation {100.0 * computed[1]:+.2f} %")
    function = str(component.printed.get("function", ""))
    doubts = [f"Doubt: {doubt}." for doubt in component.doubts]
    return (
        prose(component.model),
        ", ".join(f"[`{kind}`](parts/{kind}.md)" for kind in component.kinds)
        + (f": {prose(function)}" if function else ""),
        prose("; ".join(texts)),
        prose(" ".join([f"{component.place}.", *doubts])),
    )


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
    """Return the pages of all codes by their first part, with an anchor per code."""
    with (ROOT / "tests" / "golden" / "messages.toml").open("rb") as file:
        cases = tomllib.load(file)
    groups: dict[str, list[str]] = {}
    for code in every_code():
        groups.setdefault(code.partition(".")[0], []).append(code)
    pages_by_path = {}
    for group, codes in groups.items():
        text = [f"# Codes of `{group}`", ""]
        for code in codes:
            text += [f"(code-{code})=", f"## `{code}`", "", *code_lines(code, cases.get(code, "")), ""]
        pages_by_path[f"reference/codes/{group}.md"] = "\n".join(text)
    rows = [
        (f"[`{group}`]({group}.md)", ", ".join(f"[`{c}`](#code-{c})" for c in codes)) for group, codes in groups.items()
    ]
    pages_by_path["reference/codes/index.md"] = "\n".join([
        "# Codes of notes, findings and errors",
        "",
        "Each message has a code for programs. `poppet explain CODE` prints the same explanation.",
        "",
        table(("begins with", "codes"), rows),
        "```{toctree}\n:hidden:\n",
        *groups,
        "```",
        "",
    ])  # fmt: skip
    return pages_by_path


def code_lines(code: str, case: str) -> Iterator[str]:
    """Yield the meaning and hint of a code, and its text in a real case."""
    template = every_code()[code]
    if isinstance(template, str):
        yield prose(plain(template))
    else:
        yield f"**Cause:** {prose(plain(template['given'] + ' ' + template['reason']))}"
        yield ""
        yield f"**Remedy:** {prose(plain(template['hint']))}"
    example = " ".join(case.split())
    if example and example != template:  # a text without facts needs no example
        yield from ("", f"> {prose(example)}")


# --- Names of Python --------------------------------------------------------------------------------------------------


def api_page() -> str:
    """Return the page of public names with their docstrings."""
    text = ["# Python", "", "This page lists all public names. Start with the [tour](../docs/python.md).", ""]
    for module, title in (
        ("poppet", "poppet"),
        ("poppet.iso6358", "poppet.iso6358"),
        ("poppet.signals", "poppet.signals"),
    ):
        imported = __import__(module, fromlist=["__all__"])
        text += [f"## `{title}`", ""]
        for name in sorted(imported.__all__):
            member = getattr(imported, name)
            if isinstance(member, type):
                # `symbol` would be a target of the type names in other docstrings.
                body = [f".. autoclass:: {module}.{name}", "   :members:", "   :exclude-members: symbol"]
                if name == "Circuit":  # most of its methods are those of its base class
                    body.append("   :inherited-members:")
            elif callable(member):
                body = [f".. autofunction:: {module}.{name}"]
            else:
                continue
            text += ["```{eval-rst}", *body, "```", ""]
    return "\n".join(text)

"""`docs/circuit_file.md` says of every field what its declaration says: unit, default and limits."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import poppet
from poppet.circuit import signal_tables
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.core.units import sizes_of
from poppet.parts import KINDS
from poppet.parts.faults import Valve
from poppet.parts.fields import BodySpec, GroupSpec, MemberSpec, NumberSpec, OptionSpec, PortSpec, specs
from poppet.parts.flow_path import FlowPath

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "docs" / "circuit_file.md").read_text(encoding="utf-8")
SECTIONS = {"[ambient]": Ambient, "[gas]": GasChoice, "[run]": Run}
NEVER_IN_SETS = {"pulley_radius"}
"""Of a joint, where the set is that of a muscle."""
Row = tuple[str, str, str]
"""Unit, default and limits as the table writes them."""


def section(title: str) -> str:
    """The text below a heading, up to the next heading of the same or a higher level."""
    found = re.search(rf"^(#+) {re.escape(title)}\n(.*?)(?=^#{{1,3}} |\Z)", TEXT, re.MULTILINE | re.DOTALL)
    assert found, f"docs/circuit_file.md has no section {title}"
    return found[2]


def documented(title: str) -> dict[str, Row]:
    """Return the rows of a section by field; a row has one or more fields, or refers to those of another section."""
    rows = re.findall(
        r"^\| ((?:`[\w.]+`(?:, )?)+) \| (.*?) \| (.*?) \| (.*?) ?\| (.+?) \|$", section(title), re.MULTILINE
    )
    fields = [(name.strip("`"), row) for names, *row in rows for name in names.split(", ")]
    assert len(fields) == len(dict(fields)), f"a field of {title} has two rows"
    found: dict[str, Row] = {}
    for name, (unit, default, limits, meaning) in fields:
        other = re.fullmatch(r"as in \[(`\w+`)\]\(#\w+\)", meaning)
        found[name] = documented(other[1])[name] if other and not unit else (unit, default, limits)
    return found


def limits(spec: NumberSpec) -> str:
    low = f"≥ {spec.low:g}" if spec.low > -math.inf else f"> {spec.above:g}"
    high = f"≤ {spec.high:g}" if spec.high < math.inf else f"< {spec.below:g}"
    return ", ".join(text for text in (low, high) if "inf" not in text) or "any"


def declared(kind: Any, prefix: str = "", from_data: bool | None = None) -> Iterator[tuple[str, Row]]:
    fields = specs(kind)
    from_data = "data" in fields if from_data is None else from_data
    for name, spec in fields.items():
        if isinstance(spec, NumberSpec):
            needed = "from `data`" if from_data and name not in NEVER_IN_SETS else "required"
            default = str(spec.default) if spec.default is not None else ("optional" if spec.optional else needed)
            yield f"{prefix}{name}", (spec.unit, default, limits(spec))
        elif isinstance(spec, OptionSpec):
            choices = ", ".join(f"`{choice}`" for choice in spec.choices)
            yield f"{prefix}{name}", ("one of", spec.choices[0], choices)
        elif isinstance(spec, PortSpec):
            need = "optional" if spec.optional else "required"
            yield f"{prefix}{name}", ("port", need, "")
        elif isinstance(spec, BodySpec):
            yield f"{prefix}{name}", ("body", "required", "a mass, joint or guide")
        elif isinstance(spec, MemberSpec) and spec.part.kind not in KINDS:  # which stands nowhere else
            inner = declared(spec.part, f"{prefix}{name}.", from_data)
            told = {f"{prefix}{name}.{each}" for each in spec.inherited}
            yield from ((own, row) for own, row in inner if own not in told and own.rpartition(".")[0] not in told)
        elif isinstance(spec, GroupSpec):
            yield from declared(spec.group, f"{prefix}{name}.", from_data and not spec.optional)
        else:
            yield f"{prefix}{name}", ("reference", "optional", "")


SIZES, FAULTS = dict(declared(FlowPath)), dict(declared(Valve))


def test_fields_of_parts_are_documented():
    for kind, part in KINDS.items():
        own = dict(declared(part))
        if issubclass(part, FlowPath):
            own = {name: row for name, row in own.items() if name not in SIZES}
        if issubclass(part, Valve):
            own = {name: row for name, row in own.items() if name not in FAULTS}
            assert "[fault](#faults-of-valves)" in section(f"`{kind}`"), kind
        assert documented(f"`{kind}`") == own, kind


def test_sizes_of_passages_are_documented():
    assert documented("Sizes of passages") == SIZES


def test_faults_of_valves_are_documented():
    assert documented("Faults of valves") == FAULTS


def test_fields_of_sections_are_documented():
    assert {title: documented(f"`{title}`") for title in SECTIONS} == {
        title: dict(declared(kind)) for title, kind in SECTIONS.items()
    }


def test_fields_of_signals_are_documented():
    for kind in signal_tables.KINDS:
        row = re.search(rf"^\| `{kind}` \| (.*?) \|", section("Signals"), re.MULTILINE)
        assert row, f"no row for {kind}"
        required, optional = (tuple(re.findall(r"`(\w+)`", text)) for text in row[1].partition("optional")[::2])
        assert (required, optional) == signal_tables.fields_of(kind), kind


def given_names(part: Any) -> set[str]:
    """Names of outputs that the user gives, and inputs that are named after them."""
    return {*getattr(part, "outputs", ()), *(getattr(part, "inputs_", ()) or ()), *part.connections()}


def is_documented(local: str, kind: str) -> bool:
    """Whether the section of a kind names an output, or the member (`cap.*`) whose outputs a table lists."""
    member, _, name = local.rpartition(".")
    text = section(f"`{kind}`")
    return f"`{local}`" in text or (f"`{member}.*`" in text and f"`{name}`" in section("Outputs of members"))


def test_outputs_of_examples_are_documented():
    missing = [
        f"{path.name}: {address}"
        for path in sorted((ROOT / "examples").glob("*.toml"))
        for circuit in [poppet.load(path)]
        for address, _ in circuit.model.outputs
        for name, _, local in [address.partition(".")]
        if local not in given_names(circuit.parts[name])
        if not is_documented(re.sub(r"^[0-9]+[.]", "N.", local), circuit.parts[name].kind)
    ]
    assert missing == []


def test_sizes_of_numbers_are_documented():
    text = (ROOT / "docs" / "cli.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (\S.*?) \| (\S+) \| (1e\S+|1|10000) \|$", text, re.MULTILINE)
    documented = {unit: (float(least), float(most)) for unit, least, most in rows}
    assert documented.pop("any other") == sizes_of("any other")
    assert documented
    assert documented == {unit: sizes_of(unit) for unit in documented}

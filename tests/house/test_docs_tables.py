"""`docs/circuit_file.md` says of every field what its declaration says: unit, default and limits."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import poppet
from poppet.circuit import signal_tables
from poppet.circuit.options import Ambient, GasChoice, Run
from poppet.parts import KINDS
from poppet.parts.fields import GroupSpec, NumberSpec, OptionSpec, PortSpec, specs
from poppet.parts.flow_path import FlowPath

ROOT = Path(__file__).parents[2]
TEXT = (ROOT / "docs" / "circuit_file.md").read_text(encoding="utf-8")
SECTIONS = {"[ambient]": Ambient, "[gas]": GasChoice, "[run]": Run}
Row = tuple[str, str, str]
"""Unit, default and limits as the table writes them."""


def section(title: str) -> str:
    """The text below a heading, up to the next heading of the same or a higher level."""
    found = re.search(rf"^(#+) {re.escape(title)}\n(.*?)(?=^#{{1,3}} |\Z)", TEXT, re.MULTILINE | re.DOTALL)
    assert found, f"docs/circuit_file.md has no section {title}"
    return found[2]


def documented(title: str) -> dict[str, Row]:
    rows = re.findall(r"^\| `([\w.]+)` \| (.*?) \| (.*?) \| (.*?) ?\| (.+?) \|$", section(title), re.MULTILINE)
    return {name: (unit, default, limits) for name, unit, default, limits, _ in rows}


def limits(spec: NumberSpec) -> str:
    low = f"at least {spec.low:g}" if spec.low > -math.inf else f"> {spec.above:g}"
    high = f"at most {spec.high:g}" if spec.high < math.inf else f"< {spec.below:g}"
    return ", ".join(text for text in (low, high) if "inf" not in text) or "any"


def declared(kind: Any, prefix: str = "", from_data: bool | None = None) -> Iterator[tuple[str, Row]]:
    fields = specs(kind)
    from_data = "data" in fields if from_data is None else from_data
    for name, spec in fields.items():
        if isinstance(spec, NumberSpec):
            needed = "from `data`" if from_data else "required"
            default = str(spec.default) if spec.default is not None else ("optional" if spec.optional else needed)
            yield f"{prefix}{name}", (spec.unit, default, limits(spec))
        elif isinstance(spec, OptionSpec):
            choices = ", ".join(f"`{choice}`" for choice in spec.choices)
            yield f"{prefix}{name}", ("one of", spec.choices[0], choices)
        elif isinstance(spec, PortSpec):
            need = "optional" if spec.optional else "required"
            yield f"{prefix}{name}", ("port", need, "a store or `ambient`")
        elif isinstance(spec, GroupSpec):
            yield from declared(spec.group, f"{prefix}{name}.", from_data and not spec.optional)
        else:
            yield f"{prefix}{name}", ("reference", "optional", "")


SIZES = dict(declared(FlowPath))


@pytest.mark.parametrize("kind", KINDS)
def test_fields_of_a_part_are_documented(kind):
    own = dict(declared(KINDS[kind]))
    if issubclass(KINDS[kind], FlowPath):
        own = {name: row for name, row in own.items() if name not in SIZES}
    assert documented(f"`{kind}`") == own


def test_sizes_of_passages_are_documented():
    assert documented("Sizes of passages") == SIZES


@pytest.mark.parametrize("title", SECTIONS)
def test_fields_of_a_section_are_documented(title):
    assert documented(f"`{title}`") == dict(declared(SECTIONS[title]))


@pytest.mark.parametrize("kind", signal_tables.KINDS)
def test_fields_of_a_signal_are_documented(kind):
    row = re.search(rf"^\| `{kind}` \| (.*?) \|", section("Signals"), re.MULTILINE)
    assert row, f"no row for {kind}"
    required, _, optional = row[1].partition("optional")
    assert (tuple(re.findall(r"`(\w+)`", required)), tuple(re.findall(r"`(\w+)`", optional))) == (
        signal_tables.fields_of(kind)
    )


@pytest.mark.parametrize("path", sorted((ROOT / "examples").glob("*.toml")), ids=lambda path: path.stem)
def test_outputs_of_an_example_are_documented(path):
    circuit = poppet.load(path)
    missing = [
        address
        for address, _ in circuit.model.outputs
        for name, _, local in [address.partition(".")]
        if f"`{local}`" not in section(f"`{circuit.parts[name].kind}`")
    ]
    assert missing == []

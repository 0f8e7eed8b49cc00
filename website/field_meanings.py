"""Meanings of the fields of parts, from the tables of `docs/circuit_file.md`."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from poppet.parts import KINDS
from poppet.parts.faults import Valve
from poppet.parts.flow_path import FlowPath

PAGE = Path(__file__).resolve().parents[1] / "docs" / "circuit_file.md"
SHARED = {FlowPath: "Sizes of passages", Valve: "Faults of valves"}
"""Sections on fields that all parts of a class have."""
ROW = re.compile(r"^\| ((?:`[\w.]+`(?:, )?)+) \| [^|]*\| [^|]*\| [^|]*\| (.+?) \|$", re.MULTILINE)


@cache
def meanings(kind: str) -> dict[str, str]:
    """Return the meaning of each field of a kind, with links that are valid on the page of a part."""
    titles = [f"`{kind}`", *(title for base, title in SHARED.items() if issubclass(KINDS[kind], base))]
    return {name: text for title in titles for name, text in _rows(title).items()}


def _rows(title: str) -> dict[str, str]:
    """Return the meanings of a section; a row can refer to the section of another kind."""
    text = PAGE.read_text(encoding="utf-8")
    section = re.search(rf"^#+ {re.escape(title)}\n(.*?)(?=^#{{1,3}} |\Z)", text, re.MULTILINE | re.DOTALL)
    rows = {}
    for names, meaning in ROW.findall(section[1] if section else ""):
        other = re.fullmatch(r"as in \[`(\w+)`\]\(#\w+\)", meaning)
        for name in re.findall(r"[\w.]+", names):
            rows[name] = meanings(other[1])[name] if other else _relinked(meaning)
    return rows


def _relinked(meaning: str) -> str:
    """Return a text with links from the folder of the pages of parts."""
    text = re.sub(r"\]\(#", "](circuit_file.md#", meaning)
    return re.sub(r"\]\((?!https?:)", "](../../docs/", text)

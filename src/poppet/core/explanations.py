"""Stored examples of messages, and the codes that were renamed."""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from pathlib import Path
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.message_format import sentence, template

EXAMPLES = Path(__file__).with_name("message_examples.json")
RENAMED = EXAMPLES.with_name("renamed_codes.toml")
PARTS = ("given", "reason", "hint")


def renamed_codes() -> dict[str, str]:
    """Return former codes with the codes that replace them."""
    return tomllib.loads(RENAMED.read_text(encoding="utf-8"))


def stored_examples() -> dict[str, dict[str, Any]]:
    """Return the addresses and facts of a real case for each code."""
    examples: dict[str, dict[str, Any]] = json.loads(EXAMPLES.read_text(encoding="utf-8"))
    return examples


def example_texts(code: str, example: Mapping[str, Any]) -> dict[str, str]:
    """Return the texts of a code with the facts of a stored example; a note has one text with an empty name."""
    facts = {name: _restored(value) for name, value in example.get("facts", {}).items()}
    if "cause" in example:
        cause = example["cause"]
        facts["cause"] = InputError(cause["code"], **{name: _restored(value) for name, value in cause["facts"].items()})
    facts["address"] = example.get("address", "")
    return {part: sentence(code, facts, part) for part in (("",) if isinstance(template(code), str) else PARTS)}


def _restored(value: Any) -> Any:
    """Return a fact as it was before it was stored: tuples in place of lists, notes in place of their tables."""
    if isinstance(value, dict):
        if "code" in value and "address" in value:
            facts = {key: _restored(member) for key, member in value.items() if key not in ("code", "address")}
            return Note(value["code"], value["address"], **facts)
        return {key: _restored(member) for key, member in value.items()}
    return tuple(map(_restored, value)) if isinstance(value, list) else value

"""Explanations and stored examples of messages, and renamed message codes.

The folder `remedies/` contains one file of causes, examples and remedies for each topic.
"""

from __future__ import annotations

import json
import tomllib
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

from poppet.core.codes import Note
from poppet.core.errors import InputError
from poppet.core.message_format import plain, sentence, template

EXAMPLES = Path(__file__).with_name("message_examples.json")
RENAMED = EXAMPLES.with_name("renamed_codes.toml")
REMEDIES = EXAMPLES.with_name("remedies")
PARTS = ("given", "reason", "hint")
VERDICTS = EXAMPLES.with_name("verdicts.toml")
EXPLAINED = ("cause", "example", "remedy")


@cache
def renamed_codes() -> dict[str, str]:
    """Return a mapping from former message codes to the codes that replace them."""
    return tomllib.loads(RENAMED.read_text(encoding="utf-8"))


@cache
def stored_examples() -> dict[str, dict[str, Any]]:
    """Return the stored examples of messages, by message code.

    Each example contains an address and facts for the text of the message. Some codes have no example.
    """
    examples: dict[str, dict[str, Any]] = json.loads(EXAMPLES.read_text(encoding="utf-8"))
    return examples


def example_texts(code: str, example: Mapping[str, Any]) -> dict[str, str]:
    """Return the texts of a message with the facts of a stored example.

    An error has the three texts `given`, `reason` and `hint`, which are the keys. A note has one text, whose key is
    empty.
    """
    facts = {name: _with_original_types(value) for name, value in example.get("facts", {}).items()}
    if "cause" in example:
        cause = example["cause"]
        facts["cause"] = InputError(
            cause["code"], **{name: _with_original_types(value) for name, value in cause["facts"].items()}
        )
    facts["address"] = example.get("address", "")
    return {part: sentence(code, facts, part) for part in (("",) if isinstance(template(code), str) else PARTS)}


@cache
def verdict_explanations() -> dict[str, dict[str, str]]:
    """Return the explanations of the verdicts of results by their words, such as `not determined`."""
    return tomllib.loads(VERDICTS.read_text(encoding="utf-8"))


@cache
def _written(topic: str) -> dict[str, Any]:
    """Return the causes, examples and remedies of a topic; empty for texts of reports."""
    file = REMEDIES / f"{topic}.toml"
    return tomllib.loads(file.read_text(encoding="utf-8")) if file.exists() else {}


def explanation(code: str) -> dict[str, str]:
    """Return message, cause, example and remedy of a code or a verdict.

    The message contains the facts of a real case. The example describes this case. A text of a report, such as a
    heading, has only a message.

    Examples
    --------
    >>> list(explanation("fields.out_of_range"))
    ['message', 'cause', 'example', 'remedy']
    """
    if code in verdict_explanations():
        return verdict_explanations()[code]
    text, stored = template(code), stored_examples().get(code)
    pieces = [text] if isinstance(text, str) else list(text.values())
    message = " ".join(map(plain, pieces) if stored is None else example_texts(code, stored).values())
    topic, *keys = code.split(".")
    node = _written(topic)
    for key in keys or (topic,):  # the code `said` has one part
        node = node.get(key, {})
    return {"message": message, **{part: node[part] for part in EXPLAINED if part in node}}


def _with_original_types(value: Any) -> Any:
    """Restore the types of a fact that was read from a JSON file.

    Lists become tuples, and dictionaries with a message code become notes.
    """
    if isinstance(value, dict):
        if "code" in value and "address" in value:
            facts = {
                key: _with_original_types(member) for key, member in value.items() if key not in ("code", "address")
            }
            return Note(value["code"], value["address"], **facts)
        return {key: _with_original_types(member) for key, member in value.items()}
    return tuple(map(_with_original_types, value)) if isinstance(value, list) else value

"""Texts of all messages with facts of real cases; `make golden` updates the file after a change of templates."""

from __future__ import annotations

import importlib.util
from pathlib import Path

from poppet.core.explanations import renamed_codes, stored_examples
from poppet.core.message_format import every_code, topics

ROOT = Path(__file__).parents[2]
SPEC = importlib.util.spec_from_file_location("golden", ROOT / "tools" / "golden.py")
golden = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(golden)
TEXTS = golden.read_texts()
UNSAID = golden.FILE.with_name("unsaid.txt")


def test_the_texts_are_those_of_the_file():
    examples = golden.read()
    changed = [
        f"{code}: {golden.text_of(code, examples[code]) if code in examples else 'no example'}"
        for code, text in TEXTS.items()
        if code not in examples or golden.text_of(code, examples[code]) != text
    ]
    assert not changed, "run `make golden`, and read what has changed:\n" + "\n".join(changed)


def test_every_code_has_an_example():
    """Except for the codes of a list that no new code joins."""
    without = set(UNSAID.read_text(encoding="utf-8").split())
    missing = every_code().keys() - TEXTS.keys() - without
    assert not missing, "run `make golden HARVEST=1`: " + ", ".join(sorted(missing))
    assert without <= every_code().keys() - TEXTS.keys()
    assert stored_examples().keys() == TEXTS.keys()


def test_former_codes_lead_to_codes():
    codes = every_code()
    assert {old: new for old, new in renamed_codes().items() if old in codes or new not in codes} == {}


def test_every_topic_has_a_title():
    assert [topic for topic, title in topics().items() if not title] == []

"""All that the house says, with facts of real cases; `make golden` writes the file after a change of wording."""

from __future__ import annotations

import importlib.util
from pathlib import Path

from poppet.core.message_format import every_code

ROOT = Path(__file__).parents[2]
SPEC = importlib.util.spec_from_file_location("golden", ROOT / "tools" / "golden.py")
golden = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(golden)
MESSAGES = golden.read(golden.FILE)
UNSAID = golden.FILE.with_name("unsaid.txt")


def test_the_words_are_those_of_the_file():
    changed = []
    for code, entry in MESSAGES.items():
        said = golden.words(code, entry) if code in every_code() else {}
        changed += [] if said.items() and said.items() <= entry.items() else [f"{code}: {said}"]
    assert not changed, "run `make golden`, and read what has changed:\n" + "\n".join(changed)


def test_every_code_is_in_the_file():
    """But for those that no test of every day has said so far; none joins them."""
    unsaid = set(UNSAID.read_text(encoding="utf-8").split())
    missing = every_code().keys() - MESSAGES.keys() - unsaid
    assert not missing, "run `make golden HARVEST=1`: " + ", ".join(sorted(missing))
    assert unsaid <= every_code().keys() - MESSAGES.keys()

"""Write the examples of all messages, and their texts in `tests/golden/messages.toml`.

`make golden` renders the texts again after templates change. `make golden HARVEST=1` first runs the tests, and takes
facts from them for codes without an example, or whose templates show other facts than before.
"""

from __future__ import annotations

import atexit
import contextlib
import json
import os
import re
import sys
import tomllib
from collections import Counter
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from poppet.core import codes, errors, explanations, message_format
from poppet.core.toml import value_text

FILE = Path(__file__).parents[1] / "tests" / "golden" / "messages.toml"
HARVEST = "POPPET_GOLDEN"
"""Environment variable with the folder for the messages of a run of the tests."""
MAX_CASES = 50
"""Cases of a code that one process compares to find a short one."""
sentence = message_format.sentence  # not the recording one
Example = dict[str, Any]

_FOLDERS = re.compile(r"(?<![\w.])/(?:[^\s/\"',]+/)+")


def make_example(code: str, address: str, facts: Mapping[str, Any]) -> Example:
    """Return an example of a code; raise KeyError if the template shows other facts."""
    cause = facts.get("cause")
    example: Example = {"address": address} if address else {}
    if isinstance(cause, errors.InputError):
        example["cause"] = {"code": cause.code, "facts": _without_folders(codes.plain(cause.facts))}
    stored = {k: _without_folders(codes.plain(v)) for k, v in facts.items() if v is not cause or cause is None}
    example |= {"facts": stored} if stored else {}
    explanations.example_texts(code, example)
    return example


def text_of(code: str, example: Example) -> str:
    """Return the message of an example in one text."""
    return " ".join(explanations.example_texts(code, example).values())


def read() -> dict[str, Example]:
    """Return the stored examples of codes that exist and show these facts."""
    examples = {}
    for code, example in explanations.stored_examples().items():
        with contextlib.suppress(KeyError):
            text_of(code, example)
            examples[code] = example
    return examples


def read_texts() -> dict[str, str]:
    """Return the texts of the golden file."""
    texts: dict[str, str] = tomllib.loads(FILE.read_text(encoding="utf-8"))
    return texts


def _without_folders(value: Any) -> Any:
    """Return facts without folders, which differ between machines."""
    if isinstance(value, dict):
        return {key: _without_folders(member) for key, member in value.items()}
    if isinstance(value, list):
        return [_without_folders(member) for member in value]
    return _FOLDERS.sub("", value) if isinstance(value, str) else value


def watch(folder: Path) -> None:
    """Record the shortest case of each message of this process, and write them when it ends."""
    shortest: dict[str, str] = {}
    count: Counter[str] = Counter()

    def record(code: str, address: str | None, facts: Mapping[str, Any]) -> None:
        count[code] += 1
        if count[code] > MAX_CASES:
            return
        try:
            text = json.dumps(make_example(code, address or "", facts))
        except (KeyError, AttributeError, TypeError, ValueError, AssertionError):
            return  # built in steps, or by a test with a code of its own
        if (len(text), text) < (len(shortest.get(code, "-" * 10**6)), shortest.get(code, "~")):
            shortest[code] = text

    def record_all(kind: type) -> None:
        original = kind.__init__  # type: ignore[misc]

        def __init__(self: Any, *arguments: Any, **facts: Any) -> None:
            original(self, *arguments, **facts)
            record(self.code, self.address, self.facts)

        kind.__init__ = __init__  # type: ignore[misc]

    record_all(codes.Note)
    record_all(errors.InputError)

    def recording_sentence(code: str, facts: Mapping[str, Any], part: str = "") -> str:
        record(code, facts.get("address", ""), {k: v for k, v in facts.items() if k != "address"})
        return sentence(code, facts, part)

    message_format.sentence = recording_sentence
    atexit.register(lambda: (folder / f"{os.getpid()}.json").write_text(json.dumps(shortest), encoding="utf-8"))


def harvested(folder: Path) -> Iterator[tuple[str, Example]]:
    """Yield the examples that the processes of a run of the tests wrote, the shortest last."""
    pairs = [pair for file in folder.glob("*.json") for pair in json.loads(file.read_text(encoding="utf-8")).items()]
    for code, text in sorted(pairs, key=lambda pair: (-len(pair[1]), pair[1])):
        yield code, json.loads(text)


def main(folders: list[str]) -> None:
    """Write both files."""
    examples = dict(pair for folder in folders for pair in harvested(Path(folder))) | read()
    every_code = message_format.every_code()
    examples = {code: examples[code] for code in sorted(every_code) if code in examples}
    lines = [
        f"{json.dumps(c)}: {json.dumps(e, separators=(',', ':'), ensure_ascii=False)}" for c, e in examples.items()
    ]
    explanations.EXAMPLES.write_text("{\n" + ",\n".join(lines) + "\n}\n", encoding="utf-8")
    texts = [f"{value_text(code)} = {value_text(text_of(code, example))}" for code, example in examples.items()]
    head = "# Made by `make golden` from the templates and examples in `src/poppet/core`; do not edit."
    FILE.write_text("\n".join([head, *texts]) + "\n", encoding="utf-8")
    missing = sorted(every_code.keys() - examples.keys())
    print(f"{len(examples)} messages in {FILE.name}; {len(missing)} codes without an example: {', '.join(missing)}")


if __name__ == "__main__":
    main(sys.argv[1:])

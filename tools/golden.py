"""Write `tests/golden/messages.toml`: each code with facts of a real case, and its text.

`make golden` renders the texts again after messages change. `make golden HARVEST=1` first runs the tests, and takes
from them facts for codes that have none yet, or whose words show other facts than before.
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

from poppet.core import codes, errors, message_format
from poppet.core.toml import value_text

FILE = Path(__file__).parents[1] / "tests" / "golden" / "messages.toml"
HARVEST = "POPPET_GOLDEN"
"""The environment variable that names the folder to which a run of the tests writes what it saw."""
PARTS = ("given", "reason", "hint")
ENOUGH = 50
"""Cases of a code that are looked at in one process, to find a short one."""
sentence = message_format.sentence  # the one that is not watched
Entry = dict[str, Any]

_FOLDERS = re.compile(r"(?<![\w.])/(?:[^\s/\"',]+/)+")


def entry(code: str, address: str, facts: Mapping[str, Any]) -> Entry:
    """A code with its facts, and the words made of them; KeyError where the facts are not those that they show."""
    cause = facts.get("cause")
    # TOML has nothing for None.
    kept = {k: _short(codes.plain(v)) for k, v in facts.items() if v is not None}
    found: Entry = {"address": address, "nothing": [k for k, v in facts.items() if v is None], "facts": kept}
    if isinstance(cause, errors.InputError):
        kept.pop("cause")
        found["cause"] = {"code": cause.code, "facts": _short(codes.plain(cause.facts))}
    return found | words(code, found)


def words(code: str, known: Entry) -> dict[str, str]:
    """What is said for a code with the facts of an entry."""
    facts = dict.fromkeys(message_format.facts_of(code) & {*known.get("nothing", ())}) | _with_tuples(known["facts"])
    if "cause" in known:
        facts["cause"] = errors.InputError(known["cause"]["code"], **_with_tuples(known["cause"]["facts"]))
    facts["address"] = known["address"]
    is_note = isinstance(message_format.template(code), str)
    return {part or "words": sentence(code, facts, part) for part in (("",) if is_note else PARTS)}


def read(file: Path) -> dict[str, Entry]:
    """The entries of a file, with what it leaves out."""
    found: dict[str, Entry] = tomllib.loads(file.read_text(encoding="utf-8"))
    return {code: {"address": "", "nothing": [], "facts": {}} | known for code, known in found.items()}


def rendered(known: Mapping[str, Entry]) -> dict[str, Entry]:
    """Entries with their words made anew; those whose code is gone, or shows other facts now, are left out."""
    result = {}
    for code in sorted(message_format.every_code()):
        if code in known:
            with contextlib.suppress(KeyError):
                stored = {k: v for k, v in known[code].items() if k in ("address", "nothing", "cause", "facts")}
                result[code] = {**stored, **words(code, stored)}
    return result


def _short(value: Any) -> Any:
    """Facts without folders, which differ from machine to machine."""
    if isinstance(value, dict):
        return {key: _short(each) for key, each in value.items()}
    if isinstance(value, list):
        return [_short(each) for each in value]
    return _FOLDERS.sub("", value) if isinstance(value, str) else value


def _with_tuples(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _with_tuples(each) for key, each in value.items()}
    return tuple(map(_with_tuples, value)) if isinstance(value, list) else value


def watch(folder: Path) -> None:
    """Keep, for every code that is said in this process, the case with the least to read; written when it ends."""
    seen: dict[str, str] = {}
    count: Counter[str] = Counter()

    def see(code: str, address: str | None, facts: Mapping[str, Any]) -> None:
        count[code] += 1
        if count[code] > ENOUGH:
            return
        try:
            text = json.dumps(entry(code, address or "", facts))
        except (KeyError, AttributeError, TypeError, ValueError, AssertionError):
            return  # made in steps, or by a test that has no words for it
        if (len(text), text) < (len(seen.get(code, "-" * 10**6)), seen.get(code, "~")):
            seen[code] = text

    def watched(kind: type) -> None:
        own = kind.__init__  # type: ignore[misc]

        def __init__(self: Any, *given: Any, **facts: Any) -> None:
            own(self, *given, **facts)
            see(self.code, self.address, self.facts)

        kind.__init__ = __init__  # type: ignore[misc]

    watched(codes.Note)
    watched(errors.InputError)

    def watched_sentence(code: str, facts: Mapping[str, Any], part: str = "") -> str:
        see(code, facts.get("address", ""), {k: v for k, v in facts.items() if k != "address"})
        return sentence(code, facts, part)

    message_format.sentence = watched_sentence
    atexit.register(lambda: (folder / f"{os.getpid()}.json").write_text(json.dumps(seen), encoding="utf-8"))


def harvested(folder: Path) -> Iterator[tuple[str, Entry]]:
    """What the processes of a run of the tests saw, the shortest last."""
    every = [pair for file in folder.glob("*.json") for pair in json.loads(file.read_text(encoding="utf-8")).items()]
    for code, text in sorted(every, key=lambda pair: (-len(pair[1]), pair[1])):
        yield code, json.loads(text)


def text_of(code: str, known: Entry) -> str:
    """One table of the file: what is empty is left out."""
    lines = [f"{key} = {value_text(value)}" for key, value in known.items() if value]
    return "\n".join([f"[{value_text(code)}]", *lines])


def main(folders: list[str]) -> None:
    known = rendered(read(FILE)) if FILE.exists() else {}
    fresh = dict(pair for folder in folders for pair in harvested(Path(folder)))
    content = rendered(fresh | known)
    head = "# Made by `make golden` of the words in `src/poppet/core/words` with facts of real cases; not edited."
    FILE.parent.mkdir(exist_ok=True)
    FILE.write_text("\n\n".join([head, *(text_of(*pair) for pair in content.items())]) + "\n", encoding="utf-8")
    missing = sorted(message_format.every_code().keys() - content.keys())
    print(f"{len(content)} messages in {FILE.name}; {len(missing)} codes that no test has said: {', '.join(missing)}")


if __name__ == "__main__":
    main(sys.argv[1:])

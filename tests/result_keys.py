"""Compare the documented keys of a result file with those of a result."""

from __future__ import annotations

import re
from functools import cache
from pathlib import Path

from poppet.identify import Result

PAGE = Path(__file__).resolve().parents[1] / "docs" / "identify_result.md"


@cache
def documented() -> dict[str, set[str]]:
    """Names in the table of the page, by table of the file."""
    section = PAGE.read_text(encoding="utf-8").partition("\n## The result file\n")[2].partition("\n## ")[0]
    found: dict[str, set[str]] = {}
    table = ""
    for head, text in re.findall(r"^\| (.*?) \| (.*) \|$", section, re.MULTILINE)[1:]:
        named = re.match(r"`\[+(\w+)", head)
        table = named[1] if named else table if head.startswith("...") else head
        found.setdefault(table, set()).update(re.findall(r"`(\w+)`", text))
    return found


def undocumented(result: Result) -> list[str]:
    """What a result file of this result holds and the page does not name."""
    known, content = documented(), result.content()
    missing = [name for name in content if name not in known and name not in known["top"]]
    for name in ("comparison", "conditions"):
        missing += [f"{name}.{key}" for key in content[name] if key not in known[name]]
    rows = {name: content[name].values() for name in ("parameters", "residuals")} | {"optima": content["optima"]}
    for name, several in rows.items():
        missing += [f"{name}.{key}" for row in several for key in row if key not in known[name]]
    return sorted(set(missing))

"""The one place where codes become words; these stand in `words/`, one file for the first part of a code.

A template is a format string over the facts of a note or mistake, with additions for what sentences need:

- a list shows its members, each by the format given, joined by commas, `{values:.3g}`, `{names:"%s"}`, or by a word,
  `{names:or}`, `{names:and "%s"}`, `{ends:to .3g}`; an empty one shows `nothing`,
- a table shows each name with its value, `{shares:+.2f}`,
- `{n:|row|rows}` shows the first word where n is 1, else the second,
- `{value:g}{unit:unit}` puts a unit behind its number, and nothing where it is `1`,
- `{pressure:Pa>bar .3f}` shows the fact in another unit, with that unit; `{way:{unit}> .3g}` in the one
  in which people read what has the unit of another fact,
- `{unit:? in %s}` shows the text with the fact in it, or nothing where the fact is empty, None or False; the text may
  hold other fields, `{delay:? after {delay:.3g} s}`.
"""

from __future__ import annotations

import re
import string
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from typing import Any

FOLDER = Path(__file__).with_name("messages")
Template = str | dict[str, Any]
# The table of all units stands above: it has mistakes of its own, which are worded here.
SHOWN_IN = {"Pa>bar": 1e-5, "Pa>kPa": 1e-3, "m^3>l": 1e3, "s>ms": 1e3, "m>mm": 1e3, "m/s>mm/s": 1e3, "1>%": 100.0}
"""What a template may convert: from the SI unit of a fact to the one that a reader expects."""


@cache  # a room is read when the first of its codes is said: most runs say nothing of most rooms
def _words(room: str) -> dict[str, Any]:
    import tomllib

    with (FOLDER / f"{room}.toml").open("rb") as file:
        return tomllib.load(file)


def template(code: str) -> Template:
    """What is said for a code: a string for a note, a table of `given`, `reason`, `cure` for a mistake."""
    room, _, rest = code.partition(".")
    found: Template = _words(room)
    for part in rest.split(".") if rest else (room,):  # `said` is a code of one part
        assert isinstance(found, dict), code
        found = found[part]
    result: Template = found
    return result


class _Formatter(string.Formatter):
    def format_field(self, value: Any, spec: str) -> str:
        if spec.startswith("|"):
            return spec[1:].split("|")[int(value != 1)]
        if spec.startswith("?"):
            is_empty = value is None or value is False or (hasattr(value, "__len__") and not len(value))
            return "" if is_empty else spec[1:].replace("%s", self.format_field(value, ""))
        if spec == "unit":
            return "" if value in ("1", "") else f" {value}"
        if isinstance(value, dict):
            return ", ".join(f"{key} {self.format_field(each, spec)}" for key, each in value.items()) or "nothing"
        if isinstance(value, tuple | list | set | frozenset):
            word, _, own = spec.partition(" ") if spec[:3].strip() in ("or", "and", "to") else (",", "", spec)
            *first, last = [self.format_field(each, own) for each in value] or ["nothing"]
            return f"{', '.join(first)}{word if word == ',' else f' {word}'} {last}" if first else last
        if "%s" in spec:
            return spec.replace("%s", str(value))
        if value is None and spec:
            return ""  # inside a text that is not shown
        if ">" in spec and not spec.startswith(">"):
            return _in_unit(value, spec)
        text: str = format(value, spec)
        return text


def _in_unit(value: float, spec: str) -> str:
    """A fact in another unit: `Pa>bar .3f`."""
    units, _, own = spec.rpartition(" ")
    if units.endswith(">"):
        units = next((pair for pair in SHOWN_IN if pair.startswith(units)), units + units[:-1])
    unit, _, shown_in = units.partition(">")
    return f"{value * (1.0 if unit == shown_in else SHOWN_IN[units]):{own}} {shown_in}"


_FORMATTER = _Formatter()


def sentence(code: str, facts: Mapping[str, Any], part: str = "") -> str:
    """The words of a note, or of one `part` of a mistake."""
    found = template(code)
    text: str = found if isinstance(found, str) else found[part]
    return _FORMATTER.vformat(text, (), facts)


@cache
def facts_of(code: str, part: str = "") -> frozenset[str]:
    """Names of the facts that the words of a code show, or those of one `part` of a mistake."""
    found = template(code)
    if not isinstance(found, str) and not part:
        return frozenset().union(*(facts_of(code, each) for each in found))
    text = found if isinstance(found, str) else found[part]
    fields = _fields(text)
    # A text inside a format may hold fields of its own.
    fields += [inner for _, spec in fields for inner in _fields(spec)]
    return frozenset(re.split(r"[.\[]", name)[0] for name, _ in fields)


def _fields(text: str) -> list[tuple[str, str]]:
    return [(name, spec or "") for _, name, spec, _ in _FORMATTER.parse(text) if name]


def plain(text: str) -> str:
    """A template as a person reads it: facts as `<name>`, what is not always said in brackets.

    Examples
    --------
    >>> plain("{address} = {shown} is too large{unit:? in %s}: {n} {n:|row|rows} at {p:Pa>bar .3f}.")
    '<address> = <shown> is too large[ in <unit>]: <n> rows at <p> bar.'
    """
    words: list[str] = []
    for literal, name, spec, _ in _FORMATTER.parse(text):
        words.append(literal)
        if name is None:
            continue
        fact = re.split(r"[.\[]", name)[0]
        shown, spec = f"<{fact}>", spec or ""
        if spec.startswith("|"):
            shown = spec.rpartition("|")[2]
        elif spec.startswith("?"):
            shown = f"[{plain(spec[1:].replace('%s', shown))}]"
        elif spec == "unit":
            shown = f" {shown}"
        elif ">" in spec:
            shown += f" {spec.rpartition(' ')[0].partition('>')[2]}".rstrip()
        words.append(shown)
    return "".join(words)


def every_code() -> dict[str, Template]:
    """All codes with their templates."""
    found: dict[str, Template] = {}

    def walk(prefix: str, table: Mapping[str, Any]) -> None:
        for key, value in table.items():
            code = f"{prefix}.{key}"
            if isinstance(value, str) or "reason" in value:
                found[code] = value
            else:
                walk(code, value)

    for file in sorted(FOLDER.glob("*.toml")):
        walk(file.stem, _words(file.stem))
    return {"said" if code == "said.said" else code: text for code, text in found.items()}

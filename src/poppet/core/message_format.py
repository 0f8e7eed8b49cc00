"""Conversion of message codes to text by templates.

The folder `messages/` contains one file of templates for each topic, the first component of a code.

A template is a format string over the facts of a note or an error, with these additions:

- A list shows its members, each in the given format, separated by commas, `{values:.3g}`, `{names:"%s"}`, or by a word,
  `{names:or}`, `{names:and "%s"}`, `{ends:to .3g}`. An empty list shows `nothing`.
- A table shows each name with its value, `{shares:+.2f}`.
- `{n:|row|rows}` shows the first word if n is 1, otherwise the second.
- `{value:g}{unit:unit}` adds a unit to a value, or nothing if the unit is `1`.
- `{pressure:Pa>bar .3f}` shows the fact in another unit, with that unit. `{way:{unit}> .3g}` uses the unit that is
  usual for the unit of another fact.
- `{unit:? in %s}` shows the text with the fact in it, or nothing if the fact is empty, None or False. The text can
  contain other fields, `{delay:? after {delay:.3g} s}`.
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
# Not the table of all units: its errors are formatted here.
DISPLAY_FACTORS = {
    "Pa>bar": 1e-5, "Pa>kPa": 1e-3, "m^3>l": 1e3, "s>ms": 1e3, "m>mm": 1e3, "m/s>mm/s": 1e3, "1>%": 100.0,
    "m^3/(s Pa)>dm^3/(s bar)": 1e8,
}  # fmt: skip
"""Factors from the SI unit of a fact to the unit of its display."""


@cache  # per topic: most runs show messages of few topics
def _templates(topic: str) -> dict[str, Any]:
    import tomllib

    with (FOLDER / f"{topic}.toml").open("rb") as file:
        return tomllib.load(file)


def template(code: str) -> Template:
    """Return the template of the message with a given code.

    The template of a note is a text. The template of an error is a dictionary with the texts `given`, `reason` and
    `hint`.
    """
    topic, *keys = code.split(".")
    node: Template = _templates(topic)
    for part in keys or (topic,):  # the code `said` has one part
        assert isinstance(node, dict), code
        node = node[part]
    result: Template = node
    return result


class _Formatter(string.Formatter):
    """String formatter for message templates, with additional format specifications."""

    def format_field(self, value: Any, spec: str) -> str:
        if spec.startswith("|"):
            return spec[1:].split("|")[int(value != 1)]
        if spec.startswith("?"):
            is_empty = value is None or value is False or (hasattr(value, "__len__") and not len(value))
            return "" if is_empty else spec[1:].replace("%s", self.format_field(value, ""))
        if spec == "unit":
            return "" if value in ("1", "") else f" {value}"
        if isinstance(value, dict):
            return ", ".join(f"{key} {self.format_field(member, spec)}" for key, member in value.items()) or "nothing"
        if isinstance(value, tuple | list | set | frozenset):
            is_joined = spec[:3].strip() in ("or", "and", "to")
            joint, _, member_spec = spec.partition(" ") if is_joined else (",", "", spec)
            *first, last = [self.format_field(member, member_spec) for member in value] or ["nothing"]
            return f"{', '.join(first)}{joint if joint == ',' else f' {joint}'} {last}" if first else last
        if "%s" in spec:
            return spec.replace("%s", str(value))
        if value is None and spec:
            return ""  # inside a text that is not shown
        if ">" in spec and not spec.startswith(">"):
            # The value in another unit: both units and the format, for example `Pa>bar .3f`.
            units, _, number_spec = spec.rpartition(" ")
            if units.endswith(">"):
                units = next((pair for pair in DISPLAY_FACTORS if pair.startswith(units)), units + units[:-1])
            unit, _, display_unit = units.partition(">")
            return f"{value * (1.0 if unit == display_unit else DISPLAY_FACTORS[units]):{number_spec}} {display_unit}"
        text: str = format(value, spec)
        return text


_FORMATTER = _Formatter()


def sentence(code: str, facts: Mapping[str, Any], part: str = "") -> str:
    """Return the text of a message for the given facts.

    For an error, `part` selects one of its texts: `given`, `reason` or `hint`.
    """
    text = template(code)
    return _FORMATTER.vformat(text if isinstance(text, str) else text[part], (), facts)


@cache
def facts_of(code: str, part: str = "") -> frozenset[str]:
    """Return the names of all facts, the values that a message text contains.

    For an error, `part` selects one of its texts: `given`, `reason` or `hint`. By default, all three are included.
    """
    text = template(code)
    if not isinstance(text, str):
        if not part:
            return frozenset().union(*(facts_of(code, name) for name in text))
        text = text[part]
    fields = _fields(text)
    fields += [inner for _, spec in fields for inner in _fields(spec)]
    return frozenset(re.split(r"[.\[]", name)[0] for name, _ in fields)


def _fields(text: str) -> list[tuple[str, str]]:
    return [(name, spec or "") for _, name, spec, _ in _FORMATTER.parse(text) if name]


def plain(text: str) -> str:
    """Return a template in readable form.

    Placeholders of facts become `<name>`, and optional texts are in brackets.

    Examples
    --------
    >>> plain("{address} = {shown} is too large{unit:? in %s}: {n} {n:|row|rows} at {p:Pa>bar .3f}.")
    '<address> = <shown> is too large[ in <unit>]: <n> rows at <p> bar.'
    """
    pieces: list[str] = []
    for literal, name, spec, _ in _FORMATTER.parse(text):
        pieces.append(literal)
        if name is None:
            continue
        fact = re.split(r"[.\[]", name)[0]
        display, spec = f"<{fact}>", spec or ""
        if spec.startswith("|"):
            display = spec.rpartition("|")[2]
        elif spec.startswith("?"):
            display = f"[{plain(spec[1:].replace('%s', display))}]"
        elif spec == "unit":
            display = f" {display}"
        elif ">" in spec:
            display += f" {spec.rpartition(' ')[0].partition('>')[2]}".rstrip()
        pieces.append(display)
    return "".join(pieces)


def every_code() -> dict[str, Template]:
    """Return a mapping from all message codes to their templates."""
    templates: dict[str, Template] = {}

    def add(prefix: str, table: Mapping[str, Any]) -> None:
        for key, value in table.items():
            code = f"{prefix}.{key}"
            if isinstance(value, str) or "reason" in value:
                templates[code] = value
            else:
                add(code, value)

    for file in sorted(FOLDER.glob("*.toml")):
        add(file.stem, _templates(file.stem))
    return {"said" if code == "said.said" else code: text for code, text in templates.items()}


def topics() -> dict[str, str]:
    """Return a mapping from topics to their titles.

    A topic is the first component of a message code, for example `run`.
    """
    files = sorted(FOLDER.glob("*.toml"))
    return {file.stem: file.read_text(encoding="utf-8").partition("\n")[0].lstrip("# ").rstrip(".") for file in files}

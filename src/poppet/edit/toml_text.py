"""Positions of tables, keys and values in a TOML text.

A change of the text between such positions keeps all comments, the order, the indentation and the line endings of the
other lines. The text must be valid TOML: the scanner does not report errors.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from typing import Any

from poppet.core.toml import value_text

Path = tuple[str | int, ...]
"""Names of the tables and keys from the root to a value; the index of a table in a list of tables is an integer."""

_TEXT = r"""(?:\"{3}(?:[^"\\]|\\.|"(?!""))*+"{3,5}|'{3}(?:[^']|'(?!''))*+'{3,5}|"(?:[^"\\]|\\.)*+"|'[^']*+')"""
_TEXT_VALUE = re.compile(_TEXT, re.DOTALL)
_SCALAR = re.compile(r"[^\s,\]}#]++(?: \d\d:[^\s,\]}#]++)?")  # a date and its time can be separated by a space
_KEY = re.compile(r"""[A-Za-z0-9_-]++|"(?:[^"\\]|\\.)*+"|'[^']*+'""")
_SPACE = re.compile(r"[ \t]*+")
_BLANK = re.compile(r"(?:[ \t\r\n]|#[^\n]*+)*+")
_REST_OF_LINE = re.compile(r"[^\n]*+\n?")
_BARE = re.compile(r"[A-Za-z0-9_-]+")


@dataclass(frozen=True)
class TomlKey:
    """Single name in a key or in a header of a table, and its location in the text."""

    name: str
    start: int
    end: int


@dataclass(frozen=True)
class TomlValue:
    """Location of a value; an inline table has entries, and an array has items."""

    start: int
    end: int
    entries: tuple[TomlEntry, ...] | None = None
    items: tuple[TomlValue, ...] | None = None


@dataclass(frozen=True)
class TomlEntry:
    """Key and value, with the path from the root; `owner` is the path of the table that contains the key."""

    owner: Path
    keys: tuple[TomlKey, ...]
    value: TomlValue

    @property
    def path(self) -> Path:
        """Names from the root to the value."""
        return (*self.owner, *(key.name for key in self.keys))

    @property
    def start(self) -> int:
        """Location of the first character of the key."""
        return self.keys[0].start


@dataclass(frozen=True)
class TomlTable:
    """Table with its own header; the root has no keys.

    `start` is the location of the header and `end` the location behind the last line of the last entry.
    """

    path: Path
    keys: tuple[TomlKey, ...]
    start: int
    end: int
    entries: tuple[TomlEntry, ...]
    is_item: bool = False  # one table of a list, [[name]]


class TomlText:
    """Valid TOML text and the locations of its content.

    Parameters
    ----------
    text : str
        Valid TOML.

    Examples
    --------
    >>> text = TomlText('[parts.tank]\\nvolume = "10 l"  # measured\\n')
    >>> (entry,) = text.entries()
    >>> entry.path, text.raw(entry.value)
    (('parts', 'tank', 'volume'), '"10 l"')
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.newline = "\r\n" if re.search(r"\r?\n|\Z", text).group() == "\r\n" else "\n"  # type: ignore[union-attr]
        self.tables = tuple(self._scan())

    def raw(self, value: TomlValue) -> str:
        """Return a value as it is written."""
        return self.text[value.start : value.end]

    def entries(self) -> Iterator[TomlEntry]:
        """Yield all entries in the order of the text, those of inline tables after the entry that contains them."""
        for table in self.tables:
            for entry in table.entries:
                yield from _with_inner(entry)

    def names(self) -> Iterator[tuple[Path, TomlKey]]:
        """Yield each name in headers and keys, after the path that ends with it."""
        for table in self.tables:
            position = 0
            for key in table.keys:
                position = table.path.index(key.name, position) + 1
                yield table.path[:position], key
        for entry in self.entries():
            for count, key in enumerate(entry.keys, 1):
                yield (*entry.owner, *(k.name for k in entry.keys[:count])), key

    def line_start(self, location: int) -> int:
        """Return the location of the first character of a line."""
        return self.text.rfind("\n", 0, location) + 1

    def line_end(self, location: int) -> int:
        """Return the location after a line and its line ending."""
        return _REST_OF_LINE.match(self.text, location).end()  # type: ignore[union-attr]

    def _scan(self) -> Iterator[TomlTable]:
        path: Path = ()
        keys: tuple[TomlKey, ...] = ()
        entries: list[TomlEntry] = []
        counts: dict[Path, int] = {}
        start = end = 0
        is_item = False
        location = self._skip(_BLANK, 0)
        while location < len(self.text):
            if self.text[location] == "[":
                yield TomlTable(path, keys, start, end, tuple(entries), is_item)
                is_item = self.text.startswith("[[", location)
                start, entries = location, []
                keys, location = self._keys(location + 1 + is_item)
                path = self._header_path(keys, counts, is_item=is_item)
                location += 1 + is_item
            else:
                entry = self._entry(location, path)
                entries.append(entry)
                location = entry.value.end
            end = self.line_end(location)
            location = self._skip(_BLANK, end)
        yield TomlTable(path, keys, start, end, tuple(entries), is_item)

    def _header_path(self, keys: tuple[TomlKey, ...], counts: dict[Path, int], *, is_item: bool) -> Path:
        """Return the path of a header, in which each list of tables is followed by the index of its last table."""
        path: Path = ()
        for position, key in enumerate(keys, 1):
            path = (*path, key.name)
            if is_item and position == len(keys):
                counts[path] = counts.get(path, -1) + 1
            if path in counts:
                path = (*path, counts[path])
        return path

    def _skip(self, pattern: re.Pattern[str], location: int) -> int:
        return pattern.match(self.text, location).end()  # type: ignore[union-attr]

    def _keys(self, location: int) -> tuple[tuple[TomlKey, ...], int]:
        """Return the names of a dotted key, and the location of the next sign after it."""
        keys: list[TomlKey] = []
        while True:
            location = self._skip(_SPACE, location)
            end = self._skip(_KEY, location)
            keys.append(TomlKey(_name(self.text[location:end]), location, end))
            location = self._skip(_SPACE, end)
            if self.text[location] != ".":
                return tuple(keys), location
            location += 1

    def _entry(self, location: int, owner: Path) -> TomlEntry:
        keys, location = self._keys(location)
        path = (*owner, *(key.name for key in keys))
        return TomlEntry(owner, keys, self._value(self._skip(_SPACE, location + 1), path))

    def _value(self, start: int, path: Path) -> TomlValue:
        sign = self.text[start]
        if sign in "\"'":
            return TomlValue(start, self._skip(_TEXT_VALUE, start))
        if sign not in "[{":
            return TomlValue(start, self._skip(_SCALAR, start))
        entries: list[TomlEntry] = []
        items: list[TomlValue] = []
        location = self._skip(_BLANK, start + 1)
        while self.text[location] not in "]}":
            if sign == "{":
                entries.append(self._entry(location, path))
                location = entries[-1].value.end
            else:
                items.append(self._value(location, (*path, len(items))))
                location = items[-1].end
            location = self._skip(_BLANK, location)
            if self.text[location] == ",":
                location = self._skip(_BLANK, location + 1)
        if sign == "{":
            return TomlValue(start, location + 1, entries=tuple(entries))
        return TomlValue(start, location + 1, items=tuple(items))


def _with_inner(entry: TomlEntry) -> Iterator[TomlEntry]:
    yield entry
    values = [entry.value]
    while values:
        value = values.pop()
        values += value.items or ()
        for inner in value.entries or ():
            yield from _with_inner(inner)


def _name(raw: str) -> str:
    if raw[0] == "'" or (raw[0] == '"' and "\\" not in raw):
        return raw[1:-1]
    return next(iter(tomllib.loads(f"{raw} = 0"))) if raw[0] == '"' else raw


@dataclass(frozen=True)
class Splice:
    """Replacement of a piece of text."""

    start: int
    end: int
    text: str


def spliced(text: str, changes: Iterable[Splice]) -> str:
    """Return a text in which pieces are replaced; the pieces must not overlap.

    Examples
    --------
    >>> spliced("volume = 1", [Splice(9, 10, "2"), Splice(0, 0, "# ")])
    '# volume = 2'
    """
    for change in sorted(changes, key=lambda change: change.start, reverse=True):
        text = text[: change.start] + change.text + text[change.end :]
    return text


def read_value(raw: str) -> Any:
    """Return the value of a piece of TOML text."""
    return tomllib.loads(f"value = {raw}".replace("\r\n", "\n"))["value"]


def key_text(name: str) -> str:
    """Return a name as a TOML key, with quotes if they are necessary."""
    return name if _BARE.fullmatch(name) else value_text(name)

"""TOML files of users: reading, tables, and the lines of errors."""

from __future__ import annotations

import math
import re
import tomllib
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import Any

from poppet.core.errors import ErrorCollector, InputError, InputErrors, NameSuggestion
from poppet.core.files import open_input
from poppet.core.number_format import printable

_HEADER = re.compile(r"\s*(\[\[?)\s*(.+?)\s*\]?\]\s*(#.*)?$")
_KEY = re.compile(r"""\s*((?:[\w-]+|"[^"]*"|'[^']*')(?:\s*\.\s*(?:[\w-]+|"[^"]*"|'[^']*'))*)\s*=""")
_PIECE = re.compile(r""""([^"]*)"|'([^']*)'|([\w-]+)""")
_TOO_DEEP = re.compile(r"""(?<![\w"'-])(?:[\w"'-]++\s*+\.\s*+){64}""")
LARGEST = 16 * 2**20
"""Maximum size of a file of a user in bytes; recordings have other readers."""
_DECIMAL_COMMA = re.compile(r"[=\[,]\s*[+-]?\d+,\d+\s*(#|$)")


@dataclass(frozen=True)
class TomlFile:
    """TOML text with its file name, which adds file and line to errors.

    Examples
    --------
    >>> file = TomlFile("[parts.tank]\\nvolume = 1.0\\n", "bench.toml")
    >>> with file.errors() as errors:
    ...     if "volume" in file.content["parts"]["tank"]:
    ...         errors.add("fields.unknown", "parts.tank.volume", table="part", suggestion="Remove this entry.")
    Traceback (most recent call last):
    poppet.core.errors.InputError: bench.toml:2: parts.tank.volume is not a valid field of a part. Remove this entry.
    """

    text: str
    name: str  # shown with each error
    folder: Path = Path()  # base of relative paths in it

    @classmethod
    def read(cls, path: str | Path, table: str = "") -> TomlFile:
        """Read a TOML file.

        If the file does not exist, the error message suggests files with similar names. `table` is the name of a table
        that a suggested file must contain.
        """
        return cls(read_text(Path(path), table), str(path), Path(path).parent)

    @property
    def content(self) -> dict[str, Any]:
        """Tables of the file, after a check for control characters.

        A control character in a key or text raises an error.
        """
        tables = self.tables
        for address, text in _texts(tables):
            if printable(text) != text:
                raise InputError("toml.no_character", address, text=text)
        return tables

    @property
    def tables(self) -> dict[str, Any]:
        """Tables of the file, without a check for control characters.

        Result files can contain such characters, because they repeat texts of other files.
        """
        # A table takes memory for each enclosing table: 50,000 dotted names in 100 kB took 8 GB.
        if _TOO_DEEP.search(self.text):
            raise InputError("toml.too_deep")
        try:
            return tomllib.loads(self.text.replace("\r\n", "\n"))
        except RecursionError:
            raise InputError("toml.too_deep") from None
        except tomllib.TOMLDecodeError as error:
            message = str(error)  # only the message contains the line number
            match = re.search(r"at line (\d+)", message)
            line = int(match.group(1)) if match else 0
            if line in self._lines.twice:
                name, is_table = self._lines.twice[line]
                problem = InputError("toml.table_twice" if is_table else "toml.key_twice", name)
            else:
                has_comma = line and _DECIMAL_COMMA.search(self.text.splitlines()[line - 1])
                problem = InputError("toml.comma" if has_comma else "toml.invalid", why=message)
            raise problem.located(line=line or None) from None

    @contextmanager
    def errors(self) -> Iterator[ErrorCollector]:
        """Collect the errors of a `with` block, and raise them together with their lines."""
        try:
            with ErrorCollector() as collector:
                yield collector
        except InputError as error:
            raise self.located(error) from None

    def located(self, error: InputError) -> InputError:
        """Return the errors with their lines, sorted by line.

        Errors without a line are last.
        """
        for problem in error.problems:
            if problem.file is None:
                problem.located(file=self.name, line=self.line_of(problem.address))
        problems = sorted(error.problems, key=lambda problem: problem.line or math.inf)
        return problems[0] if len(problems) == 1 else InputErrors(problems)

    def line_of(self, address: str | None) -> int | None:
        """Return the line number of an address.

        If the address has no line of its own, the result is the line of its enclosing table. If there is none, the
        result is None.
        """
        while address:
            start = f"{address}."
            line = self.lines.get(address) or next((n for path, n in self.lines.items() if path.startswith(start)), 0)
            if line:
                return line
            # An entry of a list has the line of the list.
            address = address[: address.rindex("[")] if address.endswith("]") else address.rpartition(".")[0]
        return None

    @property
    def lines(self) -> Mapping[str, int]:
        """Mapping from the dotted paths of tables and keys to line numbers.

        The content of an array or inline table has the line of its key.
        """
        return self._lines.of

    @cached_property
    def _lines(self) -> _Lines:
        return _Lines(self.text)


class _Lines:
    """Line numbers of the tables and keys in a TOML text.

    `of` maps the dotted paths of tables and keys to line numbers. `twice` maps line numbers to names that are defined
    twice. The text can be invalid TOML.
    """

    def __init__(self, text: str) -> None:
        self.of: dict[str, int] = {}
        self.twice: dict[int, tuple[str, bool]] = {}
        self._known: set[str] = set()
        table, depth, quotes = "", 0, ""
        for number, line in enumerate(text.splitlines(), 1):
            if quotes:  # inside a text of several lines, which contains no keys
                quotes = "" if quotes in line else quotes
                continue
            # Inside open brackets, a line belongs to the value of an earlier key.
            header = _HEADER.match(line) if depth == 0 else None
            key = _KEY.match(line) if depth == 0 and not header else None
            if header:
                table = _dotted(header.group(2))
                if header.group(1) == "[[":  # next table of a list: its keys can repeat
                    self._known -= {path for path in self._known if path.startswith(table)}
                self._add(table, number, is_table=True)
            elif key:
                path = _dotted(key.group(1))
                self._add(f"{table}.{path}" if table else path, number, is_table=False)
            quotes = next((q for q in ('"""', "'''") if line.count(q) % 2), "")
            if not header and not quotes:
                without_texts = re.sub(r"\"[^\"]*\"|'[^']*'|#.*", "", line)
                opened, closed = (sum(map(without_texts.count, brackets)) for brackets in ("[{", "]}"))
                depth = max(0, depth + opened - closed)

    def _add(self, path: str, number: int, *, is_table: bool) -> None:
        self.of.setdefault(path, number)
        if path in self._known:
            self.twice[number] = path, is_table
        self._known.add(path)


def _texts(value: Any, address: str = "") -> Iterator[tuple[str, str]]:
    """Yield pairs of address and text for all keys and texts in tables."""
    if isinstance(value, str):
        yield address, value
    elif isinstance(value, dict):
        for key, inner in value.items():
            yield address, key
            yield from _texts(inner, f"{address}.{key}" if address else key)
    elif isinstance(value, list):
        for inner in value:
            yield from _texts(inner, address)


def _dotted(text: str) -> str:
    return ".".join(a or b or c for a, b, c in _PIECE.findall(text))


def read_text(path: Path, table: str = "") -> str:
    """Return the content of a text file that the user has specified.

    If the file does not exist, the error suggests similar files that contain the table `table`.
    """
    name = str(path)
    if "\n" in name and "=" in name:
        raise InputError("toml.no_path")
    try:
        with open_input(path) as file:
            data = file.read(LARGEST + 1)
    except FileNotFoundError:
        names = []
        for similar in path.parent.glob(f"*{path.suffix}"):
            with suppress(OSError, UnicodeDecodeError):
                if not 0 < similar.stat().st_size < LARGEST:
                    continue
                if not table or TomlFile(similar.read_text(encoding="utf-8-sig"), similar.name).line_of(table):
                    names.append(similar.name)
        suggestion = NameSuggestion(path.name, names)
        is_lost = not suggestion.names
        new = is_lost and table == "parts"
        raise InputError(
            "toml.no_file", path=name, suggestion="" if is_lost else suggestion, lost=is_lost, new=new
        ) from None
    except OSError as error:
        raise InputError("toml.unreadable", path=name, why=error.strerror) from None
    if len(data) > LARGEST:
        raise InputError("toml.too_large", path=name, most=LARGEST // 2**20)
    try:
        text = data.decode("utf-8-sig")
    except UnicodeDecodeError:
        text = "\0"
    if "\0" in text:
        raise InputError("toml.no_text", path=name)
    if not text.strip():
        is_circuit = table in ("", "parts")
        raise InputError("toml.empty", path=name, new=is_circuit, table="" if is_circuit else table)
    return text

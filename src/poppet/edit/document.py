"""Text of a circuit file in the editor, and the history of its changes."""

from __future__ import annotations

import math
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from poppet.core.errors import InputError
from poppet.core.toml_file import TomlFile
from poppet.edit.operations import CircuitText, apply_operation
from poppet.edit.part_names import part_kind, wired_fields
from poppet.parts.fields import GroupSpec, MemberSpec, specs

MARK = "\ufeff"
"""Byte order mark, with which some editors begin a file."""
LARGEST = 2**20
"""Maximum size of a circuit file in the editor, in bytes."""
MAX_HISTORY = 10**8
"""Maximum number of characters of all texts in a history; the oldest are deleted."""


TARGETS = ("op", "address", "part", "port", "input")
"""Keys of operations that state what is changed."""
Targets = list[tuple[str, ...]]


@dataclass(frozen=True)
class Document:
    """Text of a circuit file, which operations change.

    The text is the only state: comments, order, line endings and unknown tables are unchanged, except where an
    operation changes them. The text can be invalid, since a user can edit it.

    Parameters
    ----------
    text : str
        Content of a circuit file.

    Examples
    --------
    >>> document = Document("# plant\\n")
    >>> document = document.apply([{"op": "add", "kind": "chamber"}])
    >>> print(document.apply([{"op": "set", "address": "chamber.volume", "value": "10 l"}]).text, end="")
    # plant
    <BLANKLINE>
    [parts.chamber]
    kind = "chamber"
    volume = "10 l"
    """

    text: str

    def apply(self, operations: Iterable[Any]) -> Document:
        """Return the document after operations; if one of them is not possible, none has an effect.

        Parameters
        ----------
        operations : iterable of mapping
            Operations in the order in which they are performed, see `poppet.edit.operations`.
        """
        circuit = self._circuit
        circuit.content  # noqa: B018 - raises if the text is not valid
        for operation in operations:
            circuit = apply_operation(circuit, operation)
        document = Document((MARK if self.text.startswith(MARK) else "") + circuit.text)
        document.__dict__["_circuit"] = circuit  # which contains the parsed text
        return document

    @cached_property
    def error(self) -> InputError | None:
        """Error of a text that is not valid TOML, otherwise None."""
        try:
            self._circuit.content  # noqa: B018
        except InputError as error:
            return error
        return None

    @cached_property
    def _circuit(self) -> CircuitText:
        return CircuitText(self.text.removeprefix(MARK))

    @property
    def content(self) -> Mapping[str, Any]:
        """Tables of the text, which must be valid TOML."""
        return self._circuit.content

    def view(self) -> dict[str, Any]:
        """Return the content for the page, as values of JSON.

        The result contains the title, the parts with fields as typed, ports and line, the connections, the signals,
        the drawing, the run options, the ambient and the gas. Of an invalid text, the result contains only its error.
        The result must not be changed.
        """
        return self._view

    @cached_property
    def _view(self) -> dict[str, Any]:
        if self.error is not None:
            line, column = _location(self.text, self.error)
            return {"error": {"line": line, "column": column, "message": str(self.error), "code": self.error.code}}
        circuit = self._circuit
        file = TomlFile(circuit.text, "")
        return {
            "title": str(circuit.content.get("title", "")),
            "parts": {
                name: {**_part_view(table), "line": file.line_of(f"parts.{name}")}
                for name, table in circuit.parts.items()
            },
            "connections": dict(_addresses(circuit.table("connections"))),
            "signals": dict(_addresses(circuit.table("signals"))),
            "drawing": _json(circuit.table("drawing")),
            "run": _json(circuit.table("run")),
            "ambient": _json(circuit.table("ambient")),
            "gas": _json(circuit.content.get("gas", {})),
        }


class History:
    """Documents of an editing session, with undo and redo.

    Each change, undo and redo increases the revision by one. A change refers to the revision that the user saw; a
    change of another revision is rejected.

    Parameters
    ----------
    text : str
        Text at the start.
    revision : int, optional
        Number of the first revision.
    """

    def __init__(self, text: str, revision: int = 0) -> None:
        self.revision = revision
        self.document = Document(text)
        """Present document."""
        self._texts = [text]  # without the parsed content of documents, which is many times larger
        self._position = 0
        self._targets: Targets | None = None  # targets of the last change, if it can be continued

    @property
    def can_undo(self) -> bool:
        """True if there is a change to undo."""
        return self._position > 0

    @property
    def can_redo(self) -> bool:
        """True if there is a change to redo."""
        return self._position + 1 < len(self._texts)

    def apply(self, revision: int, operations: Iterable[Any], *, continues: bool = False) -> Document:
        """Perform operations as one change.

        If `continues` is True for several changes in a row of the same fields or parts, such as those of a slider,
        undo reverts them together.
        """
        self.check(revision)
        operations = list(operations)
        document = self.document.apply(operations)
        return self._append(document, _targets(operations) if continues else None)

    def replace(self, revision: int, text: str) -> Document:
        """Replace the text as one change; the new text can be invalid."""
        self.check(revision)
        return self._append(Document(text))

    def undo(self, revision: int) -> Document:
        """Return to the document before the last change."""
        self.check(revision)
        if not self.can_undo:
            raise InputError("edit.no_undo")
        return self._move(-1)

    def redo(self, revision: int) -> Document:
        """Perform a change again after an undo."""
        self.check(revision)
        if not self.can_redo:
            raise InputError("edit.no_redo")
        return self._move(1)

    def check(self, revision: int) -> None:
        """Raise an error if a revision is not the present one."""
        if revision != self.revision:
            raise InputError("edit.stale", revision=revision, present=self.revision)

    def _append(self, document: Document, targets: Targets | None = None) -> Document:
        if document.text != self.document.text:
            check_text(document.text)
            if targets is not None and targets == self._targets:
                self._position -= 1
            is_reverted = document.text == self._texts[self._position]  # a continued change that ends where it began
            self._texts[self._position + 1 :] = [] if is_reverted else [document.text]
            while len(self._texts) > 2 and sum(map(len, self._texts)) > MAX_HISTORY:
                del self._texts[0]
            self._position = len(self._texts) - 1
            self._targets = None if is_reverted else targets
            self.document = document
            self.revision += 1
        return self.document

    def _move(self, step: int) -> Document:
        self._position += step
        self.document = Document(self._texts[self._position])
        self._targets = None
        self.revision += 1
        return self.document


def _targets(operations: Iterable[Mapping[str, Any]]) -> Targets:
    """Return what operations change, without the new values."""
    return [tuple(str(operation.get(key)) for key in TARGETS) for operation in operations]


def check_text(text: str) -> None:
    """Raise an error if a text cannot be saved and opened again."""
    try:
        size = len(text.encode("utf-8"))
    except UnicodeEncodeError:  # half of a surrogate pair
        raise InputError("edit.no_text") from None
    if "\0" in text:
        raise InputError("edit.no_text")
    if size > LARGEST:
        raise InputError("edit.too_large", most=LARGEST // 2**20)


def _part_view(table: Any) -> dict[str, Any]:
    """Return kind, fields and ports of a part."""
    if not isinstance(table, Mapping):
        return {"kind": "", "fields": {}, "ports": {}}
    kind = part_kind(table)
    wired = [(path, value) for path, _, value in wired_fields(kind, table)] if kind else []
    ports = {".".join(map(str, path)): _json(value) for path, value in wired}
    fields = {address: value for address, value in _fields(kind, table) if address not in ports and address != "kind"}
    return {"kind": str(table.get("kind", "")), "fields": fields, "ports": ports}


def _fields(kind: Any, table: Mapping[str, Any], start: str = "") -> Iterator[tuple[str, Any]]:
    """Yield the address and the value of each field; the fields of groups and members have addresses of their own."""
    declared = specs(kind) if kind else {}
    for name, value in table.items():
        spec = declared.get(name)
        inner = spec.group if isinstance(spec, GroupSpec) else spec.part if isinstance(spec, MemberSpec) else None
        if inner is not None and isinstance(value, Mapping):
            yield from _fields(inner, value, f"{start}{name}.")
        else:
            yield f"{start}{name}", _json(value)


def _addresses(table: Mapping[str, Any], start: str = "") -> Iterator[tuple[str, Any]]:
    """Yield pairs of address and value from `signals` or `connections`, whose tables can be nested."""
    for key, value in table.items():
        if isinstance(value, Mapping) and "kind" not in value:
            yield from _addresses(value, f"{start}{key}.")
        else:
            yield f"{start}{key}", _json(value)


def _json(value: Any) -> Any:
    """Return a value of a TOML file as a value of JSON, which has no dates and no infinite numbers."""
    if isinstance(value, Mapping):
        return {key: _json(inner) for key, inner in value.items()}
    if isinstance(value, list):
        return [_json(inner) for inner in value]
    is_plain = (
        value is None or isinstance(value, bool | int | str) or (isinstance(value, float) and math.isfinite(value))
    )
    return value if is_plain else str(value)


def _location(text: str, error: InputError) -> tuple[int, int]:
    """Return line and column of a syntax error."""
    from tomlkit import parse
    from tomlkit.exceptions import ParseError

    try:
        parse(text)
    except ParseError as problem:
        if error.line in (None, problem.line):
            return problem.line, problem.col + 1
    except Exception:
        pass
    return error.line or 1, 1

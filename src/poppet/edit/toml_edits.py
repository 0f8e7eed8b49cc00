"""Changes of a TOML text that leave all other lines unchanged: set, add and remove.

Each function takes a `TomlText` and returns the new text.
"""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from typing import Any

from poppet.core.errors import InputError
from poppet.core.toml import toml_text, value_text
from poppet.edit.toml_text import Path, Splice, TomlEntry, TomlTable, TomlText, TomlValue, key_text, spliced

_FIRST_COMMENT = re.compile(r"\A(?:#[^\n]*+\n)+[ \t\r]*\n")
_BLANK_LINES = re.compile(r"(?:[ \t]*\r?\n)*")
_COMMENT_LINES = re.compile(r"(?:[ \t]*#[^\n]*+(?:\n|\Z))*")


def set_value(text: TomlText, path: Path, value: Any, order: Sequence[str] = ()) -> str:
    """Set a value; a new key becomes the last one of its table.

    `order` contains the names of the tables at the top level in the usual order.
    """
    raw = value_text(value)
    entry = next((entry for entry in text.entries() if entry.path == path), None)
    if entry is not None:
        return spliced(text.text, [Splice(entry.value.start, entry.value.end, raw)])
    if is_stated(text, path):  # a table with headers or dotted keys
        text = TomlText(remove(text, [path]))
    for count in range(len(path) - 1, -1, -1):
        container, rest = path[:count], path[count:]
        table = next((table for table in text.tables if table.path == container), None)
        if table is not None and (count or len(path) == 1):
            return _with_line(text, table, table.entries[-1] if table.entries else None, f"{_dotted(rest)} = {raw}")
        outer = next((entry for entry in text.entries() if entry.path == container), None)
        if outer is not None:
            if outer.value.entries is None:
                raise InputError("edit.no_table", ".".join(map(str, container)), value=text.raw(outer.value))
            return _with_member(text, outer.value, f"{_dotted(rest)} = {raw}")
        sibling = _last_dotted(text, container)
        if sibling is not None:
            line = f"{_dotted(path[len(sibling.owner) :])} = {raw}"
            owner = next((entry for entry in text.entries() if entry.path == sibling.owner), None)
            if owner is not None and owner.value.entries is not None:
                return _with_member(text, owner.value, line)
            table = next(table for table in reversed(text.tables) if sibling in table.entries)
            return _with_line(text, table, sibling, line)
        inner = next((table for table in text.tables if count and _is_under(table.path, container)), None)
        if inner is not None and isinstance(value, Mapping) and len(rest) == 1:
            last = [table for table in text.tables if _is_under(table.path, container)][-1]
            lines = [f"{_dotted((key,))} = {value_text(item)}\n" for key, item in value.items()]
            return _with_block(text, _block_end(text, last), f"[{_dotted(path)}]\n{''.join(lines)}")
        if inner is not None:
            return _with_block(text, _block_start(text, inner), f"[{_dotted(container)}]\n{_dotted(rest)} = {raw}\n")
    block = f"[{_dotted(path[:-1])}]\n{_dotted(path[-1:])} = {raw}\n"
    return _with_block(text, _place_in_order(text, path, order), block)


def add_table(text: TomlText, path: Path, table: Mapping[str, Any], order: Sequence[str] = ()) -> str:
    """Add a table with its own header behind the last table with the same first name.

    If the enclosing table is an inline table or has dotted keys, the new table is an inline table.
    """
    is_inline = any(entry.path == path[:-1] for entry in text.entries()) or _last_dotted(text, path[:-1]) is not None
    if is_inline:
        return set_value(text, path, table, order)
    content: Any = table
    for name in reversed(path):
        content = {name: content}
    return _with_block(text, _place_in_order(text, path, order), toml_text(content))


def is_stated(text: TomlText, path: Path) -> bool:
    """Return True if a text contains a value or a table with this path."""
    return any(_is_under(table.path, path) for table in text.tables) or any(
        _is_under(entry.path, path) for entry in text.entries()
    )


def remove(text: TomlText, paths: Collection[Path]) -> str:
    """Remove values and tables; a table takes the comment lines directly above its header."""
    changes: list[Splice] = []
    for table in text.tables:
        if any(_is_under(table.path, path) for path in paths):
            changes.append(_without_blank_lines(text, _block_start(text, table), _block_end(text, table)))
            continue
        changes += (
            Splice(text.line_start(entry.start), text.line_end(entry.value.end), "")
            for entry in table.entries
            if any(_is_under(entry.path, path) for path in paths)
        )
    changed = spliced(text.text, changes)
    if changes and max(change.end for change in changes) == len(text.text):
        changed = re.sub(r"(\r?\n)(?:[ \t]*\r?\n)+\Z", r"\1", changed)
    # Members of inline tables one by one, because their commas overlap.
    while True:
        text = TomlText(changed)
        match = next(
            (
                (members, k)
                for outer in text.entries()
                for members in [outer.value.entries or ()]
                for k, entry in enumerate(members)
                if any(_is_under(entry.path, path) for path in paths)
            ),
            None,
        )
        if match is None:
            return changed
        members, index = match
        changed = spliced(changed, [_without_member([(entry.start, entry.value.end) for entry in members], index)])


def remove_items(text: TomlText, value: TomlValue, indices: Collection[int]) -> str:
    """Remove items of an array."""
    members = [(item.start, item.end) for item in value.items or ()]
    changed = text.text
    for index in sorted(indices, reverse=True):
        changed = spliced(changed, [_without_member(members, index)])
        members = members[:index]
    return changed


def _is_under(path: Path, start: Path) -> bool:
    return path[: len(start)] == start


def _dotted(path: Path) -> str:
    return ".".join(key_text(str(name)) for name in path)


def _last_dotted(text: TomlText, container: Path) -> TomlEntry | None:
    """Return the last entry whose dotted key contains the names of a table, which has no header."""
    match = None
    for entry in text.entries():
        if len(entry.owner) < len(container) < len(entry.path) and _is_under(entry.path, container):
            match = entry
    return match


def _with_line(text: TomlText, table: TomlTable, last: TomlEntry | None, line: str) -> str:
    """Add a line behind an entry of a table, or as its first line."""
    if last is not None:
        start = text.line_start(last.start)
        location, indent = text.line_end(last.value.end), text.text[start : last.start]
    elif table.keys:
        start = text.line_start(table.start)
        location, indent = table.end, text.text[start : table.start]
    else:  # the root, which begins behind the first comment
        first = _FIRST_COMMENT.match(text.text)
        location, indent = first.end() if first else 0, ""
        if text.text[location:] and not _BLANK_LINES.match(text.text, location).group():  # type: ignore[union-attr]
            line += text.newline
    before = "" if location == 0 or text.text[location - 1] == "\n" else text.newline
    return spliced(text.text, [Splice(location, location, f"{before}{indent}{line}{text.newline}")])


def _with_member(text: TomlText, value: TomlValue, member: str) -> str:
    """Add a member to an inline table."""
    if value.entries:
        location = value.entries[-1].value.end
        return spliced(text.text, [Splice(location, location, f", {member}")])
    return spliced(text.text, [Splice(value.start, value.end, f"{{ {member} }}")])


def _without_member(members: Sequence[tuple[int, int]], index: int) -> Splice:
    """Return the removal of a member of an array or of an inline table, with one comma."""
    start, end = members[index]
    if index + 1 < len(members):
        return Splice(start, members[index + 1][0], "")
    return Splice(members[index - 1][1] if index else start, end, "")


def _with_block(text: TomlText, location: int, block: str) -> str:
    """Insert lines that begin with a header, separated by blank lines."""
    before, after = text.text[:location], text.text[location:]
    block = block.replace("\n", text.newline)
    if before and not before.endswith("\n"):
        before += text.newline
    if before and not re.search(r"(?:\A|\n)[ \t]*\r?\n\Z", before):
        before += text.newline
    if after and not re.match(r"[ \t]*\r?\n", after):
        block += text.newline
    return before + block + after


def _place_in_order(text: TomlText, path: Path, order: Sequence[str]) -> int:
    """Return the location for a new table: behind the last table with the same first name, or with an earlier one."""
    ranks = {name: rank for rank, name in enumerate(order)}
    tables = [table for table in text.tables if table.keys]
    same = [table for table in tables if table.path[0] == path[0]]
    rank = ranks.get(str(path[0]), len(order))
    earlier = [table for table in tables if ranks.get(str(table.path[0]), len(order)) <= rank]
    if same or earlier:
        return _block_end(text, (same or earlier)[-1])
    return _block_start(text, tables[0]) if tables else len(text.text)


def _block_start(text: TomlText, table: TomlTable) -> int:
    """Return the location of the comment lines directly above a header, or of the header."""
    start = text.line_start(table.start)
    while start:
        line = text.line_start(start - 1)
        if not text.text[line:start].lstrip(" \t").startswith("#"):
            break
        start = line
    return start


def _block_end(text: TomlText, table: TomlTable) -> int:
    """Return the location behind a table and the comment lines that follow it directly.

    Comment lines directly above the next header belong to the next table.
    """
    end = _COMMENT_LINES.match(text.text, table.end).end()  # type: ignore[union-attr]
    following = next((other for other in text.tables if other.start >= end and other.keys), None)
    return table.end if following is not None and text.line_start(following.start) == end else end


def _without_blank_lines(text: TomlText, start: int, end: int) -> Splice:
    """Return the removal of lines, with the blank lines behind them if there is a blank line before them."""
    is_separate = start == 0 or re.search(r"\n[ \t]*\r?\n\Z", text.text[:start]) is not None
    return Splice(start, _BLANK_LINES.match(text.text, end).end() if is_separate else end, "")  # type: ignore[union-attr]

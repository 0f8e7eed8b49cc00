"""Conversion of results to the text of TOML and JSON files, without rounding."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from poppet.core.files import by_suffix, write_whole


class ResultFileMixin:
    """Base class of results that can be saved as files."""

    __slots__ = ()

    def content(self) -> dict[str, Any]:
        """Return the result as nested dictionaries, the content of the result file."""
        raise NotImplementedError

    def save(self, path: str | Path) -> None:
        """Write the result to a `.toml` or `.json` file.

        The function replaces an existing file completely or not at all.

        Parameters
        ----------
        path : str or Path
            Output file.
        """
        text = by_suffix(Path(path), {".toml": toml_text, ".json": json_text})(self.content())
        write_whole(Path(path), lambda stream: stream.write(text.encode("utf-8")))


def json_text(content: Mapping[str, Any]) -> str:
    """Convert a result to JSON text.

    Values that are not finite become the texts "nan", "inf" and "-inf".
    """
    return json.dumps(_basic_types(content, as_text=True), indent=2, ensure_ascii=False, allow_nan=False) + "\n"


def from_json(value: Any) -> Any:
    """Convert the content of a JSON file from `json_text` back to its original values.

    The texts "nan", "inf" and "-inf" become numbers.
    """
    if isinstance(value, dict):
        return {key: from_json(v) for key, v in value.items()}
    if isinstance(value, list):
        return [from_json(v) for v in value]
    return float(value) if value in ("nan", "inf", "-inf") else value


def toml_text(content: Mapping[str, Any]) -> str:
    """Convert a result to TOML text.

    A table begins with its values; nested tables and lists of tables follow.

    Examples
    --------
    >>> print(toml_text({"title": "a", "steps": [{"from": 1.0}, {"from": 2.0}]}), end="")
    title = "a"
    <BLANKLINE>
    [[steps]]
    from = 1.0
    <BLANKLINE>
    [[steps]]
    from = 2.0
    """
    return "\n".join(_lines("", _basic_types(content))).removeprefix("\n") + "\n"


def _lines(path: str, table: Mapping[str, Any]) -> list[str]:
    # Values first: after the header of a table, they would belong to that table.
    values = [f"{_key(k)} = {value_text(v)}" for k, v in table.items() if not _needs_own_header(path, v)]
    lines = ["", f"[{path}]", *values] if path and (values or not table) else values
    for name, inner in table.items():
        address = f"{path}.{_key(name)}" if path else _key(name)
        if isinstance(inner, Mapping):
            lines += _lines(address, inner)
        elif _needs_own_header(path, inner):
            for row in inner:
                lines += ["", f"[[{address}]]", *(f"{_key(k)} = {value_text(v)}" for k, v in row.items())]
    return lines


def _needs_own_header(path: str, value: Any) -> bool:
    """Return True if TOML writes a value below a header such as [run].

    This applies to tables and, if `path` is empty, to lists of tables. `path` is the address of the table that contains
    the value. All other values are written in one line.
    """
    if isinstance(value, Mapping) or path:
        return isinstance(value, Mapping)
    return isinstance(value, list) and bool(value) and all(isinstance(row, Mapping) for row in value)


def _basic_types(value: Any, *, as_text: bool = False) -> Any:
    """Convert the values of nested tables to basic Python types.

    If the keyword `as_text` is True, infinite values and NaN become text.
    """
    if isinstance(value, Mapping):
        # TOML cannot contain None.
        return {str(key): _basic_types(v, as_text=as_text) for key, v in value.items() if as_text or v is not None}
    if hasattr(value, "tolist"):
        value = value.tolist()
    if isinstance(value, list | tuple):
        return [_basic_types(v, as_text=as_text) for v in value]
    return str(value) if as_text and isinstance(value, float) and not math.isfinite(value) else value


def _key(name: str) -> str:
    return name if name.replace("_", "").replace("-", "").isalnum() and name.isascii() else _toml_string(name)


def value_text(value: Any) -> str:
    """Convert a value to TOML text in one line."""
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, Mapping):
        return "{ " + ", ".join(f"{_key(k)} = {value_text(v)}" for k, v in value.items()) + " }"
    if isinstance(value, Sequence) and not isinstance(value, str):
        return "[" + ", ".join(value_text(v) for v in value) + "]"
    if isinstance(value, int):
        return str(value)
    if isinstance(value, float):
        return repr(value)  # nan, inf and -inf are valid TOML
    return _toml_string(str(value))


def _toml_string(text: str) -> str:
    """Return a text as a TOML string in quotes, with escaped special characters.

    The notation is the same as in JSON, except that the character DEL is also escaped.
    """
    return json.dumps(text, ensure_ascii=False).replace("\x7f", "\\u007f")

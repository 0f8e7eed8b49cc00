"""Locations in TOML texts: each located value is the value that the parser of the standard library reads."""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import Any

import pytest

from poppet.edit.toml_text import Splice, TomlText, key_text, read_value, spliced

ROOT = Path(__file__).parents[3]
FILES = sorted(path for folder in ("examples", "website", "tests") for path in (ROOT / folder).rglob("*.toml"))
HARD = '''title.a . "b c" = """two " and "" quotes \\""""""  # comment = 1
'k=[' = [[ { x = 1 , "y" = { z = 2 } }, ],  # ] in a comment
  ]
date = [ 1979-05-27 07:32:00 ]
[[list]]
empty = {}
[list.sub]
text = \'\'\'it\'\'s\'\'\'
[[list]]
'''


def valid_texts() -> list[Any]:
    texts = [pytest.param(HARD, id="hard")]
    for path in FILES:
        text = path.read_bytes().decode("utf-8")
        try:
            tomllib.loads(text)
        except tomllib.TOMLDecodeError:
            continue
        texts.append(pytest.param(text, id=str(path.relative_to(ROOT))))
    return texts


def at(content: Any, path: Any) -> Any:
    for name in path:
        content = content[name]
    return content


def has_tables(content: Any) -> bool:
    return bool(content) and (
        isinstance(content, dict) or (isinstance(content, list) and any(map(has_tables, content)))
    )


def leaves(content: Any) -> int:
    """Number of values that contain no tables."""
    if has_tables(content):
        return sum(leaves(value) for value in (content.values() if isinstance(content, dict) else content))
    return 0 if content == {} else 1


@pytest.mark.parametrize("text", valid_texts())
def test_values_are_located(text):
    content, located = tomllib.loads(text), TomlText(text)
    count = 0
    for entry in located.entries():
        value = read_value(located.raw(entry.value))
        assert value == at(content, entry.path)
        count += 0 if has_tables(value) else leaves(value)
    assert count == leaves(content)


def test_names_of_headers_and_keys():
    names = [(path, key.name) for path, key in TomlText(HARD).names()]
    assert (("list", 0, "sub"), "sub") in names
    assert (("title", "a", "b c"), "b c") in names
    assert all(path[-1] == name for path, name in names)


@pytest.mark.parametrize(("text", "newline"), [("", "\n"), ("a = 1", "\n"), ("a = 1\r\n", "\r\n"), ("a = 1\n", "\n")])
def test_line_ending(text, newline):
    assert TomlText(text).newline == newline


@pytest.mark.parametrize("name", ["tank", "a.b", 'say "x"', "", "Größe", "back\\slash"])
def test_keys_are_quoted_if_necessary(name):
    assert tomllib.loads(f"{key_text(name)} = 1") == {name: 1}


def test_splices_keep_their_locations():
    assert spliced("abcdef", [Splice(4, 5, ""), Splice(0, 1, "xyz")]) == "xyzbcdf"

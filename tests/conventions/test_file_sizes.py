"""Functions that fit on a screen or two, calls that can be read, and no drawer for odds and ends."""

from __future__ import annotations

import ast
import statistics
from functools import cache
from pathlib import Path

from source_files import ROOT, nodes

FILES = {path.relative_to(ROOT).as_posix(): path for path in sorted(ROOT.rglob("*.py"))}
TEXTS = {name: path.read_text(encoding="utf-8") for name, path in FILES.items()}
LONGEST_FUNCTION, MEDIAN, MOST_PLACES = 90, 12, 8
FORBIDDEN_NAMES = ("utils", "util", "helpers", "helper", "base", "common", "misc")


def code_lines(node: ast.FunctionDef | ast.AsyncFunctionDef, lines: list[str]) -> int:
    """Lines of a function that are neither blank, nor comment, nor docstring."""
    body = node.body[1:] if ast.get_docstring(node) is not None else node.body
    last = node.end_lineno or node.lineno
    docstring = range(0) if body is node.body else range(node.body[0].lineno, (node.body[0].end_lineno or 0) + 1)
    wanted = [k for k in range(node.lineno, last + 1) if k not in docstring]
    return sum(1 for k in wanted if lines[k - 1].strip() and not lines[k - 1].strip().startswith("#"))


@cache
def functions(name: str) -> dict[str, int]:
    lines = TEXTS[name].splitlines()
    found = [node for node in nodes(FILES[name]) if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef)]
    return {f"{node.name}:{node.lineno}": code_lines(node, lines) for node in found}


def test_functions_are_not_too_long():
    found = {
        f"{name}: {key}": count for name in FILES for key, count in functions(name).items() if count > LONGEST_FUNCTION
    }
    assert found == {}


def test_most_functions_are_short():
    assert statistics.median(count for name in FILES for count in functions(name).values()) <= MEDIAN


def test_calls_can_be_read():
    """At most eight arguments by place; `self` is not counted."""
    found = []
    for name in FILES:
        for node in nodes(FILES[name]):
            if isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
                places = [each.arg for each in (*node.args.posonlyargs, *node.args.args)]
                count = len([place for place in places if place not in ("self", "cls")])
                found += [f"{name}: {node.name} takes {count}"] if count > MOST_PLACES else []
    assert found == []


def test_public_names_are_literal():
    """What `__all__` lists can be read by the type checkers of those who use the package."""
    found = []
    for name in FILES:
        for node in nodes(FILES[name]):
            targets = node.targets if isinstance(node, ast.Assign) else []
            if any(isinstance(each, ast.Name) and each.id == "__all__" for each in targets):
                literal = isinstance(node.value, ast.List) and all(isinstance(e, ast.Constant) for e in node.value.elts)
                found += [] if literal else [name]
    assert found == []


def test_no_drawer_for_odds_and_ends():
    assert [name for name in FILES if Path(name).stem in FORBIDDEN_NAMES] == []


def test_the_count_leaves_out_docstrings_and_comments():
    text = 'def f(a):\n    """One.\n\n    Two.\n    """\n    # why\n\n    return a\n'
    node = ast.parse(text).body[0]
    assert isinstance(node, ast.FunctionDef)
    assert code_lines(node, text.splitlines()) == 2

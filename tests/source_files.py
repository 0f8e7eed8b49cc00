"""The files of the package as syntax trees: read when a test first asks, once for all tests of a process."""

from __future__ import annotations

import ast
from functools import cache
from pathlib import Path

import poppet

ROOT = Path(poppet.__file__).parent


@cache
def tree(path: Path) -> ast.Module:
    return ast.parse(path.read_text(encoding="utf-8"))


@cache
def nodes(path: Path) -> tuple[ast.AST, ...]:
    """All nodes of a file, in the order of `ast.walk`."""
    return tuple(ast.walk(tree(path)))

"""The list of costly tests names tests that exist."""

from __future__ import annotations

import ast
from pathlib import Path

ROOT = Path(__file__).parents[2]
NAMES = (ROOT / "tests" / "costly.txt").read_text(encoding="utf-8").split()


def test_every_name_is_a_test():
    unknown = []
    for name in NAMES:
        file, *_, test = name.split("::")
        path = ROOT / file
        tree = ast.parse(path.read_text(encoding="utf-8") if path.exists() else "")
        known = {node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}
        unknown += [name] if test not in known else []
    assert unknown == []
    assert sorted(NAMES) == NAMES

"""Docstrings stay true: their parameters are those of the signature, and their examples run."""

from __future__ import annotations

import ast
import doctest
import importlib
import inspect
import re
import warnings
from collections.abc import Iterator
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from source_files import ROOT, nodes, tree

MACHINE_ROOM = ("poppet.engine.integrator", "poppet.engine.lanes", "poppet.engine.stepping")
"""Functions for the compiler, not for people: their arguments are described in a paragraph."""
FRONT_DOOR = (
    "poppet",
    "poppet.control",
    "poppet.identify",
    "poppet.iso6358",
    "poppet.library",
    "poppet.signals",
    "poppet.laws.curves",
    "poppet.laws.physics.gas",
    "poppet.laws.physics.tanks",
    "poppet.core.units",
)
SECTION = re.compile(r"^(\w[\w ]*)\n-{3,}\n", re.MULTILINE)
Definition = ast.FunctionDef | ast.ClassDef


def module_name(path: Path) -> str:
    parts = path.relative_to(ROOT.parent).with_suffix("").parts
    return ".".join(parts[:-1] if parts[-1] == "__init__" else parts)


FILES = {module_name(path): path for path in sorted(ROOT.rglob("*.py")) if path.name != "__main__.py"}


@cache
def classes() -> dict[str, ast.ClassDef]:
    return {node.name: node for path in FILES.values() for node in nodes(path) if isinstance(node, ast.ClassDef)}


def section(docstring: str, title: str) -> str | None:
    """Text of one section of a numpydoc docstring."""
    heads = list(SECTION.finditer(docstring))
    ends = [head.start() for head in heads[1:]] + [len(docstring)]
    return next((docstring[head.end() : end] for head, end in zip(heads, ends, strict=False) if head[1] == title), None)


def documented(docstring: str) -> list[str] | None:
    """Names of the Parameters section, `a, b : float` giving two; None where there is no such section."""
    text = section(docstring, "Parameters")
    if text is None:
        return None
    heads = [line for line in text.splitlines() if line and not line[0].isspace()]
    return [name.strip() for head in heads for name in head.partition(" : ")[0].split(",")]


def is_public(name: str) -> bool:
    return not name.startswith("_")


def decorators(node: Definition) -> set[str]:
    return {ast.unparse(each).partition("(")[0].rpartition(".")[2] for each in node.decorator_list}


def signature(node: ast.FunctionDef, *, bound: bool) -> list[str]:
    arguments = node.args
    names = [each.arg for each in (*arguments.posonlyargs, *arguments.args)]
    if bound and "staticmethod" not in decorators(node):
        names = names[1:]
    names += [f"*{arguments.vararg.arg}"] if arguments.vararg else []
    names += [each.arg for each in arguments.kwonlyargs]
    return names + ([f"**{arguments.kwarg.arg}"] if arguments.kwarg else [])


def bases(node: ast.ClassDef) -> Iterator[ast.ClassDef]:
    for base in node.bases:
        known = classes().get(ast.unparse(base).partition("[")[0].rpartition(".")[2])
        if known is not None:
            yield known
            yield from bases(known)


def own_fields(node: ast.ClassDef) -> list[str]:
    """Public fields of a dataclass that are parameters, in order; constants of the class are none."""
    return [
        each.target.id
        for each in node.body
        if isinstance(each, ast.AnnAssign)
        and isinstance(each.target, ast.Name)
        and is_public(each.target.id)
        and "ClassVar" not in ast.unparse(each.annotation)
        and not (each.value is not None and "init=False" in ast.unparse(each.value))
    ]


def is_dataclass(node: ast.ClassDef) -> bool:
    return "dataclass" in decorators(node)


def problem(where: str, given: list[str] | None, wanted: list[str]) -> list[str]:
    if given is None and not wanted:
        return []
    return [] if given == wanted else [f"{where}: documents {given}, has {wanted}"]


def function_problems(node: ast.FunctionDef, where: str, *, bound: bool, inherited: bool = False) -> list[str]:
    docstring = ast.get_docstring(node)
    if docstring is None:
        return [] if inherited else [f"{where}: has no docstring"]
    given = documented(docstring)
    if given is None:
        return []  # what people call is looked at below
    return problem(where, given, signature(node, bound=bound))


def class_problems(node: ast.ClassDef, where: str) -> list[str]:
    docstring = ast.get_docstring(node)
    if docstring is None:
        return [f"{where}: has no docstring"]
    given = documented(docstring)
    found: list[str] = []
    constructor = next(
        (each for each in node.body if isinstance(each, ast.FunctionDef) and each.name == "__init__"), None
    )
    if is_dataclass(node) and given is not None:
        fields, above = own_fields(node), {name for base in bases(node) for name in own_fields(base)}
        found = problem(where, [name for name in given or [] if name not in above], fields)
    elif constructor is not None and given is not None:
        found = problem(where, given, signature(constructor, bound=True))
    overridden = {each.name for base in bases(node) for each in base.body if isinstance(each, ast.FunctionDef)}
    for each in node.body:
        if (
            isinstance(each, ast.FunctionDef)
            and is_public(each.name)
            and not {"setter", "overload"} & {*decorators(each)}
        ):
            found += function_problems(
                each, f"{where}.{each.name}", bound=True, inherited=each.name in overridden or not bases_known(node)
            )
    return found


def bases_known(node: ast.ClassDef) -> bool:
    """False when a class overrides methods of a package outside the house."""
    return all(
        ast.unparse(base).partition("[")[0].rpartition(".")[2] in {*classes(), "ABC", "Enum", "Exception", "Mapping"}
        for base in node.bases
    )


def test_every_module_has_a_docstring():
    assert [module for module, path in FILES.items() if not ast.get_docstring(tree(path))] == []


def test_parameters_are_those_of_the_signature():
    found: list[str] = []
    for module, path in FILES.items():
        for node in tree(path).body if module not in MACHINE_ROOM else ():
            if isinstance(node, ast.FunctionDef) and is_public(node.name):
                found += function_problems(node, f"{module}.{node.name}", bound=False)
            elif isinstance(node, ast.ClassDef) and is_public(node.name):
                found += class_problems(node, f"{module}.{node.name}")
    assert not found, "\n" + "\n".join(found)


def front_door() -> Iterator[tuple[str, Any]]:
    """Functions and classes that people call."""
    for name in FRONT_DOOR:
        module = importlib.import_module(name)
        for key in getattr(module, "__all__", None) or [key for key in vars(module) if is_public(key)]:
            value = getattr(module, key)
            if (inspect.isfunction(value) or inspect.isclass(value)) and value.__module__.startswith("poppet"):
                yield f"{name}.{key}", value


def test_what_people_call_documents_every_parameter():
    """No one-line docstring at the front door, but for errors and what takes no argument."""
    found = []
    for name, value in front_door():
        if inspect.isclass(value) and issubclass(value, Exception):
            continue
        takes = [key for key in inspect.signature(value).parameters if is_public(key)]
        if takes and documented(inspect.getdoc(value) or "") is None:
            found.append(f"{name}: {takes}")
        for key, method in vars(value).items() if inspect.isclass(value) else ():
            above = any(key in vars(base) for base in value.__mro__[1:])
            if inspect.isfunction(method) and is_public(key) and not above:
                takes = list(inspect.signature(method).parameters)[1:]
                if takes and documented(inspect.getdoc(method) or "") is None:
                    found.append(f"{name}.{key}: {takes}")
    assert not found, "\n" + "\n".join(found)


def test_the_check_sees_what_it_should():
    good = ast.parse(
        'def f(a, *, b=1, **c):\n    """Do.\n\n    Parameters\n    ----------\n'
        '    a, b : float\n        x\n    **c\n        y\n    """'
    ).body[0]
    assert isinstance(good, ast.FunctionDef)
    assert function_problems(good, "f", bound=False) == []
    good.args.args[0].arg = "z"
    assert function_problems(good, "f", bound=False) == ["f: documents ['a', 'b', '**c'], has ['z', 'b', '**c']"]


@pytest.mark.parametrize("module", [m for m, path in FILES.items() if ">>>" in path.read_text(encoding="utf-8")])
def test_examples_run(module, tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        result = doctest.testmod(importlib.import_module(module), optionflags=doctest.NORMALIZE_WHITESPACE, report=True)
    assert result.attempted > 0
    assert result.failed == 0

"""Imports only go down, wherever they stand: at the top of a file, inside a function, or for type checkers alone."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from functools import cache
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

from source_files import ROOT, nodes, tree

FLOORS = (
    "core",
    "laws",
    "timeseries",
    "library",
    "engine",
    "cosim",
    "parts",
    "circuit",
    "identify",
    "bench",
    "control",
    "ensemble",
    "monitoring",
    "audit",
    "report",
    "deploy",
    "serve",
    "api",
    "edit",
    "assist",
    "cli",
)
"""From the lowest; each is a folder, except `api`, a module."""
FACES = {"iso6358": "laws", "signals": "timeseries", "api": "api", "__main__": "cli"}
"""Module in the root folder to its layer."""


def modules() -> dict[str, Path]:
    found = {}
    for path in sorted(ROOT.rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    found.pop("")  # the front door: names of every floor, looked up when first used
    return found


MODULES = modules()


def floor_of(module: str) -> int:
    first = module.partition(".")[0]
    return FLOORS.index(FACES.get(first, first))


def targets(node: ast.Import | ast.ImportFrom) -> Iterator[str]:
    """Modules of the house that an import statement names."""
    if isinstance(node, ast.Import):
        named = [alias.name for alias in node.names]
    else:
        assert node.level == 0, "imports are absolute"
        named = [f"{node.module}.{alias.name}" for alias in node.names]
    for name in named:
        if name.partition(".")[0] == "poppet":
            inside = name.partition(".")[2]
            yield inside if inside in MODULES else inside.rpartition(".")[0]


def imports(module: str) -> set[str]:
    found = {
        target
        for node in nodes(MODULES[module])
        if isinstance(node, ast.Import | ast.ImportFrom)
        for target in targets(node)
    }
    return found - {"", module}


@cache
def graph() -> dict[str, set[str]]:
    return {module: imports(module) for module in MODULES}


def test_the_house_has_these_rooms():
    folders = {path.name for path in ROOT.iterdir() if path.is_dir() and path.name != "__pycache__"}
    assert folders | {"api"} == set(FLOORS)
    assert {path.stem for path in ROOT.glob("*.py")} == {"__init__", *FACES}


def test_imports_go_down():
    up = [(m, t) for m, found in graph().items() for t in sorted(found) if floor_of(t) > floor_of(m)]
    assert up == []


def test_no_circle():
    try:
        TopologicalSorter(graph()).prepare()
    except CycleError as error:
        raise AssertionError(" -> ".join(error.args[1])) from None


def test_the_package_imports_two_light_modules():
    plain = [
        ast.unparse(node)
        for node in tree(ROOT / "__init__.py").body
        if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("poppet")
    ]
    assert plain == ["from poppet.core.notebook import HtmlMixin", "from poppet.core.version import __version__"]


HEAVY = {"scipy", "pandas", "matplotlib", "casadi", "pyarrow", "numba", "llvmlite", "rich", "control", "mpl_toolkits"}
HEAVY |= {"nptdms", "asammdf", "h5py", "xarray", "distributed", "tomlkit", "fmpy"}
ALLOWED_HEAVY = {
    "engine.estimator": {"numba"},
    "engine.integrator": {"numba"},
    "engine.lanes": {"numba", "llvmlite"},
    "engine.stepping": {"numba", "llvmlite"},
}
"""Modules that are themselves imported only when a run begins."""


def test_heavy_packages_are_imported_where_they_are_used():
    found = []
    for module, path in MODULES.items():
        for node in tree(path).body:
            names = [alias.name for alias in node.names] if isinstance(node, ast.Import) else []
            names += [node.module or ""] if isinstance(node, ast.ImportFrom) else []
            heavy = {name.partition(".")[0] for name in names} & HEAVY - ALLOWED_HEAVY.get(module, set())
            found += [f"{module}: {', '.join(sorted(heavy))}"] if heavy else []
    assert found == []

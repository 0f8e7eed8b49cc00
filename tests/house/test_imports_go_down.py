"""Imports only go down: a module uses its own floor and those below, and nothing goes round in a circle."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from graphlib import CycleError, TopologicalSorter
from pathlib import Path

import pytest

import poppet

ROOT = Path(poppet.__file__).parent

FLOORS = (
    ("_version", "errors", "symbolic", "toml_text"),
    ("unit_table", "units", "provenance"),
    ("segments", "series_checks", "signals", "recording", "recording_io", "measured"),
    ("iso6358", "curves", "physics"),
    ("library",),
    ("parts",),
    ("run_options",),
    ("model", "assembly"),
    ("engine",),
    # The independent solvers work on the same problem as the kernel, which simulate.py defines.
    ("simulate", "engine.track", "engine.cross_check", "repeated"),
    (
        "stop_conditions",
        "addresses",
        "doubts",
        "wiring",
        "outcome",
        "circuit",
        "held_inputs",
        "linear_model",
        "sampled",
        "linear",
        "signal_tables",
    ),
    ("circuit_file", "schema", "templates"),
    ("measured",),
    ("identify", "bench"),
    ("control",),
    ("report",),
    ("cli", "__main__"),
)
"""From the ground up; a package stands for all its modules."""

UPWARD = {("recording", "report.plots"): "Recording.plot: a recording may be asked to draw itself, and only then"}
"""Imports that go up, inside a function."""

CIRCLES = {
    ("recording", "report.plots"): UPWARD["recording", "report.plots"],
    ("recording", "recording_io"): "Recording.save, read, to_pandas: the file formats need the type they make",
    ("simulate", "engine.cross_check"): "a run that stalls is handed over to a solver of the same problem",
}
"""Imports inside a function that close a circle: methods whose work is done in another file."""


def modules() -> dict[str, Path]:
    found = {}
    for path in sorted(ROOT.rglob("*.py")):
        parts = path.relative_to(ROOT).with_suffix("").parts
        found[".".join(parts[:-1] if parts[-1] == "__init__" else parts)] = path
    found.pop("")  # the front door: names of every floor, looked up when first used
    return found


MODULES = modules()


def floor_of(module: str) -> int:
    places = {name: floor for floor, names in enumerate(FLOORS) for name in names}
    while module:
        if module in places:
            return places[module]
        module = module.rpartition(".")[0]
    return -1


def targets(node: ast.Import | ast.ImportFrom) -> Iterator[str]:
    """Modules of the house that an import statement names."""
    if isinstance(node, ast.Import):
        named = [alias.name for alias in node.names]
    else:
        assert node.level == 0, "imports are absolute"
        module = node.module or ""
        named = [f"{module}.{alias.name}" for alias in node.names]
    for name in named:
        if name.partition(".")[0] != "poppet":
            continue
        inside = name.partition(".")[2]
        yield from [inside] if inside in MODULES else [inside.rpartition(".")[0]]


def imports(module: str, *, at_import_time: bool = False, types: bool = True) -> set[str]:
    """What a module imports: anywhere, or only while it is itself imported; with or without type checking."""
    found: set[str] = set()
    waiting: list[ast.AST] = [ast.parse(MODULES[module].read_text(encoding="utf-8"))]
    while waiting:
        node = waiting.pop()
        if isinstance(node, ast.Import | ast.ImportFrom):
            found.update(targets(node))
        elif (at_import_time and isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef | ast.Lambda)) or (
            not types and isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)
        ):
            continue
        waiting.extend(ast.iter_child_nodes(node))
    return found - {"", module}


def in_a_circle(graph: dict[str, set[str]]) -> list[str]:
    try:
        TopologicalSorter(graph).prepare()
    except CycleError as error:
        return list(error.args[1])
    return []


def test_every_module_has_a_floor():
    assert [module for module in MODULES if floor_of(module) < 0] == []
    packages = {name.partition(".")[0] for name in MODULES} | {path.name for path in ROOT.iterdir() if path.is_dir()}
    assert [name for names in FLOORS for name in names if name not in {*MODULES, *packages}] == []


@pytest.mark.parametrize("module", MODULES)
def test_imports_go_down(module):
    up = {
        target for target in imports(module) if floor_of(target) > floor_of(module) and (module, target) not in UPWARD
    }
    assert up == set()


def test_no_circle_at_import_time():
    assert in_a_circle({module: imports(module, at_import_time=True, types=False) for module in MODULES}) == []


def test_no_circle_at_all_but_the_documented_ones():
    graph = {module: imports(module, types=False) for module in MODULES}
    for module, target in CIRCLES:
        graph[module].discard(target)
    assert in_a_circle(graph) == []


@pytest.mark.parametrize(("module", "target"), CIRCLES)
def test_documented_circles_are_real_and_closed_inside_functions(module, target):
    graph = {name: imports(name, types=False) for name in MODULES}
    for pair in CIRCLES:
        if pair != (module, target):
            graph[pair[0]].discard(pair[1])
    assert module in in_a_circle(graph)
    assert target not in imports(module, at_import_time=True)


def test_the_front_door_opens_nothing_until_asked():
    tree = ast.parse((ROOT / "__init__.py").read_text(encoding="utf-8"))
    plain = [
        node for node in tree.body if isinstance(node, ast.ImportFrom) and (node.module or "").startswith("poppet")
    ]
    assert [ast.unparse(node) for node in plain] == ["from poppet._version import __version__"]


HEAVY = ("scipy", "pandas", "matplotlib", "casadi", "pyarrow", "numba", "llvmlite", "rich", "control", "mpl_toolkits")
HEAVY += ("nptdms", "asammdf", "h5py")
ALLOWED_HEAVY = {
    "engine.integrator": {"numba"},
    "engine.stepping": {"numba", "llvmlite"},
}
"""Modules that are themselves imported only when a run begins."""


@pytest.mark.parametrize("module", MODULES)
def test_heavy_packages_are_imported_where_they_are_used(module):
    tree = ast.parse(MODULES[module].read_text(encoding="utf-8"))
    found: set[str] = set()
    for node in tree.body:
        if isinstance(node, ast.Import):
            found |= {alias.name.partition(".")[0] for alias in node.names}
        elif isinstance(node, ast.ImportFrom):
            found.add((node.module or "").partition(".")[0])
    assert found & set(HEAVY) <= ALLOWED_HEAVY.get(module, set())

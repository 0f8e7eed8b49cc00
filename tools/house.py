"""Measure checkouts of the house, and draw one from its imports.

python tools/house.py measure CHECKOUT [CHECKOUT...]
python tools/house.py draw CHECKOUT -o docs/images/house.svg
"""

from __future__ import annotations

import argparse
import ast
import io
import tokenize
from collections import Counter
from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

from house_picture import Brick, Floor, Roof, Room, picture
from house_visits import visit_figures

FLOORS = (
    "core",
    "laws",
    "timeseries",
    "library",
    "engine",
    "parts",
    "circuit",
    "identify",
    "bench",
    "control",
    "ensemble",
    "report",
    "deploy",
    "api",
    "cli",
)
"""From the ground up."""

PACKAGE = "poppet"
LONG, VERY_LONG, SHORT, MANY = 60, 90, 6, 8
NOT_CODE = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER}
Function = ast.FunctionDef | ast.AsyncFunctionDef
Graph = dict[str, set[str]]


# Reading


@dataclass(frozen=True)
class Module:
    name: str  # dotted, without the package's own name; the front door is ""
    folder: tuple[str, ...]
    text: str

    @property
    def floor(self) -> str:
        return self.folder[0] if self.folder else self.name if self.name == "api" else ""

    @cached_property
    def tree(self) -> ast.Module:
        return ast.parse(self.text)

    @cached_property
    def nodes(self) -> list[ast.AST]:
        return list(ast.walk(self.tree))

    @cached_property
    def functions(self) -> list[Function]:
        return [node for node in self.nodes if isinstance(node, Function)]

    @cached_property
    def lines(self) -> int:
        return len(self.text.splitlines())


House = dict[str, Module]


def package_of(checkout: Path) -> Path:
    return checkout.resolve() / "src" / PACKAGE


def read(checkout: Path) -> House:
    root, house = package_of(checkout), {}
    for path in sorted(root.rglob("*.py")):
        *folder, stem = path.relative_to(root).with_suffix("").parts
        name = ".".join(folder if stem == "__init__" else [*folder, stem])
        house[name] = Module(name, tuple(folder), path.read_text(encoding="utf-8"))
    if not house:
        raise SystemExit(f"{checkout}: no src/{PACKAGE} with Python files there. Give the root of a checkout.")
    return house


def named(module: Module, node: ast.Import | ast.ImportFrom) -> Iterator[str]:
    """Dotted names, from the package's root, that an import statement may mean; the longest that is a module counts."""
    if isinstance(node, ast.Import):
        full = [alias.name for alias in node.names]
    else:
        above = [PACKAGE, *module.folder][: len(module.folder) + 2 - node.level] if node.level else []
        full = [".".join([*above, *filter(None, [node.module]), alias.name]) for alias in node.names]
    yield from (name.partition(".")[2] for name in full if name.partition(".")[0] == PACKAGE)


def imports(house: House) -> Graph:
    """What each module imports: at its top, inside functions and for types alike."""
    graph: Graph = {}
    for module in house.values():
        statements = [node for node in module.nodes if isinstance(node, ast.Import | ast.ImportFrom)]
        names = [name for node in statements for name in named(module, node)]
        graph[module.name] = {n if n in house else n.rpartition(".")[0] for n in names} & house.keys() - {module.name}
    return graph


def circles(graph: Graph) -> list[int]:
    """Sizes of the groups of modules that each reach each other."""
    reach = {name: reachable(graph, name) for name in graph}
    groups = {frozenset(other for other in reach[name] if name in reach[other]) for name in graph}
    return sorted(len(group) for group in groups if len(group) > 1)


def reachable(graph: Graph, start: str) -> set[str]:
    found: set[str] = set()
    waiting = [start]
    while waiting:
        new = graph[waiting.pop()] - found
        found |= new
        waiting.extend(new)
    return found


def between_floors(house: House, graph: Graph) -> Counter[tuple[str, str]]:
    pairs = ((house[user].floor, house[used].floor) for user, names in graph.items() for used in names)
    return Counter((user, used) for user, used in pairs if user and used and user != used)


# Measuring what is written


def span(node: ast.expr | ast.stmt) -> set[int]:
    return set(range(node.lineno, (node.end_lineno or node.lineno) + 1))


def docstrings(nodes: Iterable[ast.AST]) -> set[int]:
    """Lines of strings that stand alone: those of modules, classes and functions, and those under an assignment."""
    alone = (node.value for node in nodes if isinstance(node, ast.Expr))
    return set().union(
        *(span(node) for node in alone if isinstance(node, ast.Constant) and isinstance(node.value, str))
    )


def length(function: Function) -> int:
    """Lines without the docstring."""
    return len(span(function) - docstrings(function.body[:1]))


def text_figures(house: House) -> dict[str, str]:
    total = code = comments = docs = on_functions = 0
    for module in house.values():
        tokens = list(tokenize.generate_tokens(io.StringIO(module.text).readline))
        documented = docstrings(module.nodes)
        written = {k for t in tokens if t.type not in NOT_CODE for k in range(t.start[0], t.end[0] + 1)}
        blank = {k for k, line in enumerate(module.text.splitlines(), 1) if not line.strip()}
        total += module.lines
        code += len(written - documented - blank)
        docs += len(documented)
        on_functions += len(docstrings(first for function in module.functions for first in function.body[:1]))
        comments += sum(t.type == tokenize.COMMENT for t in tokens)
    return {
        "Python files": f"{len(house)}",
        "lines": f"{total}",
        "code lines": f"{code}",
        "docstring lines": f"{docs}",
        "of these on functions": f"{on_functions}",
        "comment lines (share of code lines)": f"{comments} ({comments / code:.1%})",
    }


def layout_figures(root: Path, house: House) -> dict[str, str]:
    # A folder of which only compiled leftovers remain is none.
    parts = [path.relative_to(root).parts for path in root.rglob("*") if path.is_file()]
    folders = {each[0] for each in parts if len(each) > 1 and "__pycache__" not in each}
    graph = imports(house)
    sizes = circles(graph)
    is_built = set(FLOORS) <= {module.floor for module in house.values()}
    ups = [
        n
        for (user, used), n in between_floors(house, graph).items()
        if {user, used} <= set(FLOORS) and is_up(user, used)
    ]
    return {
        "modules at the root of the package": f"{sum(not module.folder for module in house.values())}",
        "folders at the root of the package": f"{len(folders)}",
        "rooms (folders with Python files, at any depth)": f"{len({m.folder for m in house.values()} - {()})}",
        "import circles": f"{len(sizes)}",
        "modules in the largest circle": f"{max(sizes, default=0)}",
        "imports that run up": f"{sum(ups)}" if is_built else "-",
    }


def is_up(user: str, used: str) -> bool:
    return FLOORS.index(used) > FLOORS.index(user)


def positional(function: Function) -> int:
    names = [argument.arg for argument in (*function.args.posonlyargs, *function.args.args)]
    return len(names) - (names[:1] in (["self"], ["cls"]))


def reads_a_sentence(node: ast.AST) -> bool:
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute):
        return node.func.attr in ("startswith", "endswith") and any(map(has_words, node.args))
    return isinstance(node, ast.Compare) and isinstance(node.ops[0], ast.In | ast.NotIn) and has_words(node.left)


def has_words(node: ast.AST) -> bool:
    """A literal of more than one word; pieces of a tuple or of an f-string count."""
    texts = [each.value for each in ast.walk(node) if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    return any(text.strip() and " " in text for text in texts)


def used_once(house: House) -> int:
    """Short private helpers with one use; a use in another file counts where that file has none of this name itself."""
    uses = {m.name: Counter(filter(None, map(loaded, m.nodes))) for m in house.values()}
    own = {m.name: {function.name for function in m.functions} for m in house.values()}
    found = 0
    for module in house.values():
        for function in module.functions:
            name = function.name
            if name.startswith("_") and not name.endswith("__") and length(function) <= SHORT:
                found += sum(uses[m][name] for m in house if m == module.name or name not in own[m]) == 1
    return found


def loaded(node: ast.AST) -> str | None:
    if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
        return node.id
    return node.attr if isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Load) else None


def function_figures(house: House) -> dict[str, str]:
    functions = [function for module in house.values() for function in module.functions]
    lengths = [length(function) for function in functions]
    counts = [positional(function) for function in functions]
    return {
        f"functions over {LONG} lines": f"{sum(n > LONG for n in lengths)}",
        f"functions over {VERY_LONG} lines": f"{sum(n > VERY_LONG for n in lengths)}",
        f"functions of more than {MANY} positional arguments": f"{sum(n > MANY for n in counts)}",
        "most positional arguments": f"{max(counts)}",
        f"private helpers of at most {SHORT} lines with one use": f"{used_once(house)}",
        "decisions that read a sentence": f"{sum(reads_a_sentence(n) for m in house.values() for n in m.nodes)}",
    }


def measure(checkouts: list[Path]) -> str:
    columns = []
    for checkout in checkouts:
        house = read(checkout)
        layout = layout_figures(package_of(checkout), house)
        columns.append(text_figures(house) | layout | function_figures(house) | visit_figures(checkout))
    rows = [["figure", *(checkout.resolve().name for checkout in checkouts)], ["---", *["---:"] * len(checkouts)]]
    rows += [[label, *(column[label] for column in columns)] for label in columns[0]]
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


# Drawing


def counted(modules: list[Module]) -> str:
    return f"{len(modules)} file{'s' * (len(modules) != 1)} · {sum(m.lines for m in modules):,} lines".replace(",", " ")


def summary(modules: list[Module], floor: str) -> str:
    first = next((module for module in modules if module.name == floor), None)
    return ((first and ast.get_docstring(first.tree)) or "").partition("\n")[0].replace("`", "")


def rooms_of(modules: list[Module]) -> list[Room]:
    rooms = []
    for folder in sorted({module.folder for module in modules}):
        here = [module for module in modules if module.folder == folder]
        bricks = [Brick(m.name.rpartition(".")[2], m.lines) for m in here if m.name != ".".join(folder)]
        if bricks or folder[1:]:
            rooms.append(Room("/".join(folder[1:]), counted(here), bricks))
    return rooms


def draw(checkout: Path, out: Path) -> None:
    """Rooms that have no floor yet are put on top."""
    house = read(checkout)
    found = {module.floor for module in house.values()} - {""}
    floors = []
    for name in [*(floor for floor in FLOORS if floor in found), *sorted(found - set(FLOORS))]:
        modules = [module for module in house.values() if module.floor == name]
        floors.append(Floor(name, summary(modules, name), counted(modules), rooms_of(modules)))
    door = [f"{m.name or '__init__'}.py" for m in house.values() if not m.folder]
    roof = Roof(PACKAGE, counted(list(house.values())), "front door: " + ", ".join(door))
    picture(roof, floors, between_floors(house, imports(house)), out)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    commands = parser.add_subparsers(dest="command", required=True)
    commands.add_parser("measure").add_argument("checkouts", nargs="+", type=Path)
    drawing = commands.add_parser("draw")
    drawing.add_argument("checkout", type=Path)
    drawing.add_argument("-o", "--out", type=Path, required=True)
    options = parser.parse_args()
    if options.command == "measure":
        print(measure(options.checkouts))
    else:
        draw(options.checkout, options.out)


if __name__ == "__main__":
    main()

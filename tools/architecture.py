"""Measure checkouts and draw the layers of the package with the imports between them.

python tools/architecture.py measure CHECKOUT [CHECKOUT ...]
python tools/architecture.py draw CHECKOUT -o docs/images/architecture.svg
"""

from __future__ import annotations

import argparse
import ast
import io
import tokenize
from collections import Counter
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

LAYERS = (
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
"""Packages and modules from the lowest layer to the highest."""

PACKAGE = "poppet"
NOT_CODE = {tokenize.COMMENT, tokenize.NL, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.ENDMARKER}
Function = ast.FunctionDef | ast.AsyncFunctionDef
DOCUMENTED = (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)


@dataclass(frozen=True)
class SourceFile:
    """Python file of the package."""

    name: str  # dotted, without the name of the package; empty for the top-level `__init__`
    text: str

    @property
    def layer(self) -> str:
        return self.name.partition(".")[0]

    @cached_property
    def nodes(self) -> list[ast.AST]:
        return list(ast.walk(ast.parse(self.text)))

    @cached_property
    def functions(self) -> list[Function]:
        return [node for node in self.nodes if isinstance(node, Function)]

    @cached_property
    def docstring_lines(self) -> set[int]:
        lines: set[int] = set()
        for node in self.nodes:
            first = node.body[0] if isinstance(node, DOCUMENTED) and node.body else None
            if (
                isinstance(first, ast.Expr)
                and isinstance(first.value, ast.Constant)
                and isinstance(first.value.value, str)
            ):
                lines |= set(range(first.lineno, (first.end_lineno or first.lineno) + 1))
        return lines

    def count_lines(self) -> dict[str, int]:
        """Return the numbers of code, docstring, comment and import lines."""
        tokens = list(tokenize.generate_tokens(io.StringIO(self.text).readline))
        code = {k for t in tokens if t.type not in NOT_CODE for k in range(t.start[0], t.end[0] + 1)}
        code -= self.docstring_lines
        comments = {t.start[0] for t in tokens if t.type == tokenize.COMMENT} - code
        imports = [node for node in self.nodes if isinstance(node, ast.Import | ast.ImportFrom)]
        return {
            "code lines": len(code),
            "docstring lines": len(self.docstring_lines),
            "comment lines": len(comments),
            "import lines": sum((node.end_lineno or node.lineno) - node.lineno + 1 for node in imports),
        }


def read_package(checkout: Path) -> list[SourceFile]:
    root = checkout.resolve() / "src" / PACKAGE
    files = []
    for path in sorted(root.rglob("*.py")):
        *folders, stem = path.relative_to(root).with_suffix("").parts
        name = ".".join(folders if stem == "__init__" else [*folders, stem])
        files.append(SourceFile(name, path.read_text(encoding="utf-8")))
    if not files:
        raise SystemExit(f"{checkout} has no Python files in src/{PACKAGE}. Specify the root of a checkout.")
    return files


def count_single_callers(files: list[SourceFile]) -> int:
    """Return the number of private functions whose name is used exactly once in the package."""
    uses = Counter(
        node.id if isinstance(node, ast.Name) else node.attr
        for file in files
        for node in file.nodes
        if isinstance(node, ast.Name | ast.Attribute) and isinstance(node.ctx, ast.Load)
    )
    private = [f.name for file in files for f in file.functions if f.name.startswith("_") and not f.name.endswith("__")]
    return sum(uses[name] == 1 for name in private)


def returns_any(function: Function) -> bool:
    return isinstance(function.returns, ast.Name) and function.returns.id == "Any"


def measure(checkouts: list[Path]) -> str:
    """Return the indicators of the checkouts as a Markdown table."""
    columns = []
    for checkout in checkouts:
        files = read_package(checkout)
        total: Counter[str] = Counter()
        for file in files:
            total.update(file.count_lines())
        functions = [function for file in files for function in file.functions]
        single = count_single_callers(files)
        columns.append(
            {
                "files": f"{len(files)}",
                **{name: f"{total[name]}" for name in ("code lines", "docstring lines", "comment lines")},
                "import lines": f"{total['import lines']} ({total['import lines'] / total['code lines']:.1%} of code)",
                "functions": f"{len(functions)}",
                "private functions with one caller": f"{single} ({single / len(functions):.1%} of functions)",
                "files with fewer than 110 lines": f"{sum(file.text.count(chr(10)) < 110 for file in files)}",
                "functions that return `Any`": f"{sum(map(returns_any, functions))}",
            }
        )
    rows = [["indicator", *(path.resolve().name for path in checkouts)], ["---", *["---:"] * len(checkouts)]]
    rows += [[label, *(column[label] for column in columns)] for label in columns[0]]
    return "\n".join(f"| {' | '.join(row)} |" for row in rows)


def count_imports(files: list[SourceFile]) -> Counter[tuple[str, str]]:
    """Return the number of imports from each layer to each other layer."""
    pairs: Counter[tuple[str, str]] = Counter()
    for file in files:
        for node in file.nodes:
            if isinstance(node, ast.ImportFrom) and (node.module or "").startswith(f"{PACKAGE}."):
                target = (node.module or "").split(".")[1]
            elif isinstance(node, ast.ImportFrom) and node.module == PACKAGE and file.layer in LAYERS:
                target = node.names[0].name
            else:
                continue
            if file.layer in LAYERS and target in LAYERS and target != file.layer:
                pairs[file.layer, target] += 1
    return pairs


def draw(checkout: Path, out: Path) -> None:
    """Draw one row per layer, highest first, with its size and the counts of its imports."""
    import matplotlib as mpl
    import matplotlib.patches
    from matplotlib.figure import Figure

    files = read_package(checkout)
    pairs = count_imports(files)
    layers = [layer for layer in reversed(LAYERS) if any(file.layer == layer for file in files)]
    with mpl.rc_context({"svg.hashsalt": "architecture", "svg.fonttype": "path", "font.family": "DejaVu Sans"}):
        figure = Figure(figsize=(11.0, 0.42 * len(layers) + 1.1))
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        axes.set_xlim(0.0, 11.0)
        axes.set_ylim(-len(layers) + 0.3, 2.4)
        axes.axis("off")
        grey, ink, blue = "#66727e", "#22303c", "#1f5fa8"
        left, cell = 4.6, 0.42
        axes.text(left, 2.0, "number of imports from lower layers", color=grey, fontsize=8)
        for column, name in enumerate(layers[1:]):
            x = left + cell * (column + 0.5)
            axes.text(x, 0.55, name, color=ink, fontsize=8, rotation=60, ha="left", rotation_mode="anchor")
        for row, name in enumerate(layers):
            y = -row
            own = [file for file in files if file.layer == name]
            lines = sum(file.count_lines()["code lines"] for file in own)
            box = mpl.patches.FancyBboxPatch(
                (0.2, y - 0.36), 4.1, 0.72, boxstyle="round,pad=0.02", fc="#eef3fa", ec=blue
            )
            axes.add_patch(box)
            axes.text(0.35, y, name, color=ink, fontsize=11, fontweight="bold", va="center")
            size = f"{len(own)} {'file' if len(own) == 1 else 'files'}, {lines} lines of code"
            axes.text(4.2, y, size, color=grey, fontsize=8, va="center", ha="right")
            for column, target in enumerate(layers[1:]):
                count = pairs[name, target]
                if count:
                    shade = min(1.0, 0.15 + count / 60.0)
                    corner = (left + cell * column + 0.02, y - 0.36)
                    axes.add_patch(mpl.patches.Rectangle(corner, cell - 0.04, 0.72, fc=blue, alpha=shade, ec="none"))
                    x, colour = left + cell * (column + 0.5), "white" if shade > 0.5 else ink
                    axes.text(x, y, str(count), fontsize=7, ha="center", va="center", color=colour)
        figure.savefig(out, metadata={"Date": None, "Creator": None} if out.suffix == ".svg" else None)
        if out.suffix == ".svg":
            out.write_text("\n".join(line.rstrip() for line in out.read_text().splitlines()) + "\n")


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

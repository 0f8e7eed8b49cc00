"""Gallery pages: a card and a page for each circuit file in `examples/`."""

from __future__ import annotations

import hashlib
import re
import shutil
import tomllib
from concurrent.futures import ProcessPoolExecutor
from functools import cache, partial
from pathlib import Path

import poppet
from poppet.deploy.targets import TARGETS
from poppet.report.circuit.schematic import draw_circuit

CODE = Path(poppet.__file__).parent


def pages(examples: Path, source: Path) -> dict[str, str]:
    """Return the pages of the gallery by path; write the figures into the sources."""
    pages_by_path, cards = {}, []
    paths = sorted(examples.glob("*.toml"))
    with ProcessPoolExecutor(2) as pool:
        list(pool.map(partial(shown, folder=source / "gallery"), paths))
    for path in paths:
        name, title, intro = path.stem, title_of(path), introduction(path)
        pages_by_path[f"gallery/{name}.md"] = page(path, title, intro)
        cards.append(
            f":::{{grid-item-card}} {title}\n:link: {name}\n:link-type: doc\n:img-top: {name}.png\n\n{intro}\n:::\n"
        )
    tree = "\n".join(path.stem for path in paths)
    pages_by_path["gallery/index.md"] = (
        "# Gallery\n\nAll circuit files of `examples/`. This build has drawn and simulated each of them.\n\n"
        f"::::{{grid}} 1 2 3 3\n:gutter: 3\n\n{''.join(cards)}::::\n\n```{{toctree}}\n:hidden:\n\n{tree}\n```\n"
    )
    return pages_by_path


def title_of(path: Path) -> str:
    """Return the title of a circuit file."""
    with path.open("rb") as file:
        return str(tomllib.load(file)["title"])


def introduction(path: Path) -> str:
    """Return the initial comment of a file."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# "))
    return re.sub(r"([<>*_])", r"\\\1", " ".join(lines))


def page(path: Path, title: str, intro: str) -> str:
    """Return the page of one example."""
    name = path.stem
    return "\n".join([
        f"# {title}",
        "",
        intro,
        "",
        "```console",
        f"$ poppet simulate examples/{name}.toml --plot {name}.png",
        "```",
        "",
        f"![Result of the run: {title}]({name}.png)",
        "",
        f"The [live page]({name}_live.html) runs the model in your browser while you change its parameters:",
        "",
        "```console",
        f"$ poppet live examples/{name}.toml -o {name}_live.html",
        "```",
        "",
        "## Circuit",
        "",
        f"![Drawing of the circuit: {title}]({name}_circuit.svg)",
        "",
        "## Circuit file",
        "",
        f"```{{literalinclude}} ../examples/{name}.toml\n:language: toml\n```",
        "",
    ])  # fmt: skip


def shown(path: Path, folder: Path) -> None:
    """Draw a circuit and its run and write its live page, or copy them from the cache."""
    folder.mkdir(parents=True, exist_ok=True)
    mark = hashlib.sha256(path.read_bytes() + program().encode()).hexdigest()[:16]
    cache = folder.parents[1] / "pictures" / f"{path.stem}-{mark}"
    picture, drawing, live = names = f"{path.stem}.png", f"{path.stem}_circuit.svg", f"{path.stem}_live.html"
    if not all((cache / name).exists() for name in names):
        cache.mkdir(parents=True, exist_ok=True)
        circuit = poppet.load(path)
        circuit.simulate().plot(cache / picture)
        draw_circuit(circuit, cache / drawing)
        TARGETS["live"].write(circuit, cache / live)
    for name in names:
        shutil.copyfile(cache / name, folder / name)


@cache
def program() -> str:
    """Return a hash of the package, which identifies the cached figures."""
    content = hashlib.sha256()
    for path in sorted(path for path in CODE.rglob("*") if path.is_file() and path.suffix != ".pyc"):
        content.update(path.read_bytes())
    return content.hexdigest()[:16]

"""The gallery: for every circuit file of `examples/` a card and a page: drawing, picture, command, live page."""

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
    """Pages of the gallery by their places; the pictures are laid into the sources."""
    found, cards = {}, []
    paths = sorted(examples.glob("*.toml"))
    with ProcessPoolExecutor(2) as pool:
        list(pool.map(partial(shown, folder=source / "gallery"), paths))
    for path in paths:
        name, title, intro = path.stem, title_of(path), introduction(path)
        found[f"gallery/{name}.md"] = page(path, title, intro)
        cards.append(
            f":::{{grid-item-card}} {title}\n:link: {name}\n:link-type: doc\n:img-top: {name}.png\n\n{intro}\n:::\n"
        )
    tree = "\n".join(path.stem for path in paths)
    found["gallery/index.md"] = (
        "# Gallery\n\nEvery circuit file of `examples/`, drawn and run at this build.\n\n"
        f"::::{{grid}} 1 2 3 3\n:gutter: 3\n\n{''.join(cards)}::::\n\n```{{toctree}}\n:hidden:\n\n{tree}\n```\n"
    )
    return found


def title_of(path: Path) -> str:
    """The title that a circuit file has."""
    with path.open("rb") as file:
        return str(tomllib.load(file)["title"])


def introduction(path: Path) -> str:
    """The comment that a file begins with."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if not line.startswith("#"):
            break
        lines.append(line.lstrip("# "))
    return re.sub(r"([<>*_])", r"\\\1", " ".join(lines))


def page(path: Path, title: str, intro: str) -> str:
    """The page of one example."""
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
        f"![What the run gives: {title}]({name}.png)",
        "",
        f"On its [live page]({name}_live.html) the model itself runs while you move its numbers:",
        "",
        "```console",
        f"$ poppet live examples/{name}.toml -o {name}_live.html",
        "```",
        "",
        "## Its parts",
        "",
        f"![Drawing of the circuit: {title}]({name}_circuit.svg)",
        "",
        "## Its file",
        "",
        f"```{{literalinclude}} ../examples/{name}.toml\n:language: toml\n```",
        "",
    ])  # fmt: skip


def shown(path: Path, folder: Path) -> None:
    """Draw a circuit and its run and make its live page, or take what the same program made of the same file."""
    folder.mkdir(parents=True, exist_ok=True)
    mark = hashlib.sha256(path.read_bytes() + program().encode()).hexdigest()[:16]
    kept = folder.parents[1] / "pictures" / f"{path.stem}-{mark}"
    picture, drawing, live = names = f"{path.stem}.png", f"{path.stem}_circuit.svg", f"{path.stem}_live.html"
    if not all((kept / name).exists() for name in names):
        kept.mkdir(parents=True, exist_ok=True)
        circuit = poppet.load(path)
        circuit.simulate().plot(kept / picture)
        draw_circuit(circuit, kept / drawing)
        TARGETS["live"].write(circuit, kept / live)
    for name in names:
        shutil.copyfile(kept / name, folder / name)


@cache
def program() -> str:
    """A mark of all that draws and runs."""
    content = hashlib.sha256()
    for each in sorted(path for path in CODE.rglob("*") if path.is_file() and path.suffix != ".pyc"):
        content.update(each.read_bytes())
    return content.hexdigest()[:16]

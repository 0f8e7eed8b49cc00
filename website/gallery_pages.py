"""The gallery: for every circuit file of `examples/` a card and a page: drawing, picture, command."""

from __future__ import annotations

import hashlib
import re
import shutil
import tomllib
from pathlib import Path

import poppet
from poppet.report.circuit.picture import draw_circuit

CODE = Path(poppet.__file__).parent


def pages(examples: Path, source: Path) -> dict[str, str]:
    """Pages of the gallery by their places; the pictures are laid into the sources."""
    found, cards = {}, []
    for path in sorted(examples.glob("*.toml")):
        name, title, intro = path.stem, title_of(path), introduction(path)
        pictures(path, source / "gallery")
        found[f"gallery/{name}.md"] = page(path, title, intro)
        cards.append(
            f":::{{grid-item-card}} {title}\n:link: {name}\n:link-type: doc\n:img-top: {name}.png\n\n{intro}\n:::\n"
        )
    tree = "\n".join(sorted(path.stem for path in examples.glob("*.toml")))
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
        "## Its parts",
        "",
        f"![Drawing of the circuit: {title}]({name}_circuit.svg)",
        "",
        "## Its file",
        "",
        f"```{{literalinclude}} ../examples/{name}.toml\n:language: toml\n```",
        "",
    ])  # fmt: skip


def pictures(path: Path, folder: Path) -> None:
    """Draw a circuit and its run, or take what was drawn of the same file by the same program."""
    folder.mkdir(parents=True, exist_ok=True)
    kept = folder.parents[1] / "pictures" / _mark(path)
    names = f"{path.stem}.png", f"{path.stem}_circuit.svg"
    if not all((kept / name).exists() for name in names):
        kept.mkdir(parents=True, exist_ok=True)
        circuit = poppet.load(path)
        circuit.simulate().plot(kept / names[0])
        draw_circuit(circuit, kept / names[1])
    for name in names:
        shutil.copyfile(kept / name, folder / name)


def _mark(path: Path) -> str:
    """What a picture depends on."""
    content = hashlib.sha256(path.read_bytes())
    for each in sorted(CODE.rglob("*.py")):
        content.update(each.read_bytes())
    return f"{path.stem}-{content.hexdigest()[:16]}"

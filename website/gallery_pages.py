"""Gallery pages: a card, a live page and a page of the file for each circuit file in `examples/`."""

from __future__ import annotations

import hashlib
import html
import re
import shutil
import tomllib
from concurrent.futures import ProcessPoolExecutor
from dataclasses import replace
from functools import cache, partial
from pathlib import Path

import poppet
from card_pictures import card_curve, card_drawing
from poppet.core.number_format import printable
from poppet.deploy.live.live_page import live_page
from poppet.report.circuit.schematic import draw_circuit
from poppet.timeseries.plotting.plots import Sheet

CODE = Path(poppet.__file__).parent
WEBSITE = Path(__file__).resolve().parent
FILES = ("drawing.svg", "curve.svg", "circuit.svg", "live.html")
"""Files of an example in the cache."""
CURVES = {
    "compressed_air": ("tank.pressure", ""),
    "fill_staircase": ("tank.pressure", "valve.pilot_pressure"),
    "bleed_regulator": ("volume.pressure", "valve.pilot_pressure"),
    "pressure_regulator": ("tank.pressure", "valve.setpoint"),
    "regulator_parts": ("tank.pressure", "controller.target_pressure"),
    "long_tube": ("chamber.pressure", ""),
    "pick_and_place": ("arm.shaft.position", ""),
    "pressure_booster": ("tank.pressure", ""),
    "two_cylinders": ("slideA.position", "slideB.position"),
    "two_tanks": ("high.pressure", "low.pressure"),
    "vacuum": ("cup.pressure", ""),
}
"""Output of the curve and dashed output, of examples whose first plot does not begin with the most telling one."""
GROUPS = {
    "Machines and step sequences": ("sequence",),
    "Muscles and joints": ("muscle", "joint"),
    "Vacuum and compressed-air supply": ("vacuum_ejector", "compressor", "pressure_booster"),
    "Controlled positions and pressures": ("pid", "pressure_controller"),
    "Cylinders": ("cylinder",),
    "Valves, tanks and tubes": (),
}
"""Headings of the gallery, with the kinds of parts of their circuits. The first heading that fits is used."""


OTHERS = """## Inputs of other commands

The folders of `examples/` contain recordings, plans and circuits of these commands. They have no cards, because a plan
or a recording is not a circuit, and a browser cannot run the FMU of another tool.

| folder | command |
|---|---|
| `audit` | [`poppet audit leaks`](../docs/air_costs.md) |
| `bench` | [`poppet bench`](../docs/bench.md) |
| `components` | [`poppet library`](../docs/components.md) |
| `fmu_import` | [circuits with FMUs](../docs/fmu_import.md) |
| `identify`, `regulators` | [`poppet identify`](../docs/identify.md) |
| `serve` | [`poppet serve`](../docs/serve.md) |
| `watch` | [`poppet watch`](../docs/watch.md) |
"""
"""Last section of the gallery."""


def pages(examples: Path, source: Path) -> dict[str, str]:
    """Return the pages of the gallery by path; write drawings and live pages into the sources."""
    paths = sorted(examples.glob("*.toml"))
    with ProcessPoolExecutor(2) as pool:
        pictures = list(pool.map(partial(shown, folder=source), paths))
    pages_by_path, cards = {}, dict.fromkeys(GROUPS, "")
    for path, (drawing, curve) in zip(paths, pictures, strict=True):
        pages_by_path[f"gallery/{path.stem}.md"] = page(path, curve)
        cards[heading_of(path)] += card(path, drawing, curve)
    sections = "".join(
        f'\n## {heading}\n\n<ul class="gallery">\n{items}</ul>\n' for heading, items in cards.items() if items
    )
    tree = "\n".join(path.stem for path in paths)
    pages_by_path["gallery/index.md"] = (
        "# Gallery\n\nEach card opens a live page, which simulates its circuit in the browser while you change its "
        "parameters. The drawing shows the symbols of the circuit.\n"
        f"{sections}\n{OTHERS}\n```{{toctree}}\n:hidden:\n\n{tree}\n```\n"
    )
    return pages_by_path


def card(path: Path, drawing: str, curve: str) -> str:
    """Return the HTML of the card of an example."""
    name, title, intro = path.stem, html.escape(title_of(path)), as_html(introduction(path))
    return (
        f'<li id="{name}">{drawing}{curve}<a class="title" href="live/{name}.html">{title}</a>'
        + f"<p>{intro}</p>" * bool(intro)
        + f'<p class="links"><a href="{name}.html">Circuit file</a></p>{edit_command(name)}</li>\n'
    )


def edit_command(name: str) -> str:
    """Return the HTML of the command that opens an example in the editor."""
    command = f"poppet edit examples/{name}.toml"
    return (
        f'<details class="edit"><summary>Edit this circuit</summary><code>{command}</code> '
        f'<button type="button" data-copy="{command}">Copy</button></details>'
    )


def heading_of(path: Path) -> str:
    """Return the heading of the gallery under which an example is shown."""
    kinds = {table["kind"] for table in content_of(path)["parts"].values()}
    return next(heading for heading, wanted in GROUPS.items() if kinds & {*wanted} or not wanted)


@cache
def content_of(path: Path) -> dict[str, dict[str, dict[str, str]]]:
    """Return the tables of a circuit file."""
    with path.open("rb") as file:
        return tomllib.load(file)


def title_of(path: Path) -> str:
    """Return the title of a circuit file."""
    return str(content_of(path)["title"])


def introduction(path: Path) -> str:
    """Return the first sentences of a file: its initial comment without commands."""
    lines = []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("title ="):
            continue
        if not line.startswith("#") or line.startswith("#   poppet"):
            break
        lines.append(line.lstrip("# "))
    return " ".join(lines).strip()


def as_html(text: str) -> str:
    """Return a text with code in backticks as HTML."""
    return re.sub(r"`([^`]+)`", r"<code>\1</code>", html.escape(text))


def page(path: Path, curve: str) -> str:
    """Return the page of the file of one example."""
    name = path.stem
    return "\n".join([
        f"# {title_of(path)}",
        "",
        re.sub(r"([<>*_])", r"\\\1", introduction(path)),
        "",
        f'<p><a class="run" href="live/{name}.html">Run this circuit in the browser</a></p>',
        f'<div class="telling">{curve}</div>',
        "",
        "```console",
        f"$ poppet edit examples/{name}.toml",
        f"$ poppet simulate examples/{name}.toml --plot {name}.png",
        f"$ poppet live examples/{name}.toml -o {name}.html",
        "```",
        "",
        "## Circuit",
        "",
        '<div class="wide" tabindex="0" role="region" aria-label="Drawing of the circuit">',
        "",
        f"![Drawing of the circuit: {title_of(path)}]({name}_circuit.svg)",
        "",
        "</div>",
        "",
        "## Circuit file",
        "",
        f"```{{literalinclude}} ../examples/{name}.toml\n:language: toml\n```",
        "",
    ])  # fmt: skip


def live_bar(name: str) -> str:
    """Return the HTML of the links above a live page of the gallery."""
    return (
        f'<nav class="bar" aria-label="Gallery"><a href="../index.html">Gallery</a> <a href="../{name}.html">'
        f"Circuit file</a> {edit_command(name)}</nav>\n"
    )


def shown(path: Path, folder: Path) -> tuple[str, str]:
    """Draw a circuit and its curve and write its live page, or copy them from the cache.

    The result is the drawing and the curve of the card as SVG text. `folder` is that of the sources.
    """
    mark = hashlib.sha256(path.read_bytes() + program().encode()).hexdigest()[:16]
    cached = folder.parent / "pictures" / f"{path.stem}-{mark}"
    if not all((cached / name).exists() for name in FILES):
        cached.mkdir(parents=True, exist_ok=True)
        circuit = poppet.load(path)
        recording = circuit.simulate(throw=False)
        address, dashed = CURVES.get(path.stem) or first_curve(recording)
        texts = card_drawing(circuit), card_curve(recording, address, dashed=dashed)
        for name, text in zip(FILES, texts, strict=False):
            (cached / name).write_text(text, encoding="utf-8")
        draw_circuit(replace(circuit, title="", like=circuit), cached / "circuit.svg")  # the page has the title
        page_text = printable(live_page(circuit, bar=live_bar(path.stem)))
        (cached / "live.html").write_text(page_text, encoding="utf-8")
    live = folder.parent / "extra" / "gallery" / "live"
    for target in (folder / "gallery", live):
        target.mkdir(parents=True, exist_ok=True)
    shutil.copyfile(cached / "circuit.svg", folder / "gallery" / f"{path.stem}_circuit.svg")
    shutil.copyfile(cached / "live.html", live / f"{path.stem}.html")
    return (cached / FILES[0]).read_text(encoding="utf-8"), (cached / FILES[1]).read_text(encoding="utf-8")


def first_curve(recording: poppet.Recording) -> tuple[str, str]:
    """Return the first output of the first plot of a run, and a setpoint in the same plot or nothing."""
    names = [series.name for series in Sheet({"": recording}, None, None, "", inner=False).panels[0].series]
    return names[0], next((name for name in names[1:] if name.endswith("setpoint")), "")


@cache
def program() -> str:
    """Return a hash of the package and of the website, which identifies the cached pictures."""
    content = hashlib.sha256()
    files = [path for path in CODE.rglob("*") if path.is_file() and path.suffix != ".pyc"]
    for path in sorted([*files, *WEBSITE.glob("*.py")]):
        content.update(path.read_bytes())
    return content.hexdigest()[:16]

"""What README and docs say works: links, names of code, commands, Python and circuits."""

from __future__ import annotations

import importlib
import re
import runpy
import shlex
from pathlib import Path
from typing import Any

import pytest

from poppet.circuit.file import loads
from poppet.cli.main import COMMANDS, command_of, command_parser

ROOT = Path(__file__).parents[2]
PAGES = [
    ROOT / "README.md",
    ROOT / "CONTRIBUTING.md",
    ROOT / "examples" / "README.md",
    *sorted((ROOT / "docs").glob("*.md")),
]
TEXTS = {str(page.relative_to(ROOT)): page.read_text(encoding="utf-8") for page in PAGES}


def blocks(text: str, language: str) -> list[str]:
    return re.findall(rf"^```{language}\n(.*?)^```$", text, re.MULTILINE | re.DOTALL)


def anchors(text: str) -> set[str]:
    """Anchors of headings, as Markdown viewers make them."""
    prose = re.sub(r"^```.*?^```$", "", text, flags=re.MULTILINE | re.DOTALL)
    titles = re.findall(r"^#+ (.+)$", prose, re.MULTILINE)
    return {re.sub(r"[^\w\- ]", "", title.lower()).replace(" ", "-") for title in titles}


@pytest.mark.parametrize("page", TEXTS)
def test_relative_links_resolve(page):
    broken = []
    for target in re.findall(r"\]\(([^)\s]+)\)", TEXTS[page]):
        if target.startswith(("https://", "http://")):
            continue
        name, _, anchor = target.partition("#")
        file = (ROOT / page).parent / name if name else ROOT / page
        if not file.exists() or (anchor and anchor not in anchors(file.read_text(encoding="utf-8"))):
            broken.append(target)
    assert broken == []


@pytest.mark.parametrize("page", [page for page in TEXTS if blocks(TEXTS[page], "python")])
def test_python_blocks_run(page, tmp_path, monkeypatch, capsys):
    """One after the other, in one namespace, as a reader would type them."""
    monkeypatch.chdir(tmp_path)
    namespace: dict[str, Any] = {"__name__": "__main__"}
    for number, block in enumerate(blocks(TEXTS[page], "python"), 1):
        exec(compile(block, f"{page}, block {number}", "exec"), namespace)
    assert "recording" in namespace


@pytest.mark.parametrize(
    ("page", "block"),
    [(page, block) for page, text in TEXTS.items() for block in blocks(text, "toml") if 'kind = "chamber"' in block],
)
def test_circuits_load(page, block):
    assert loads(block, name=page).run.duration is not None


def resolve(name: str) -> Any:
    """The object of a dotted name."""
    parts = name.split(".")
    for cut in range(len(parts), 0, -1):
        try:
            found: Any = importlib.import_module(".".join(parts[:cut]))
        except ModuleNotFoundError:
            continue
        for attribute in parts[cut:]:
            found = getattr(found, attribute)
        return found
    raise ModuleNotFoundError(name)


NAMES = sorted({name for text in TEXTS.values() for name in re.findall(r"`(poppet(?:\.[A-Za-z_]\w*)+)`", text)})


@pytest.mark.parametrize("name", NAMES)
def test_code_that_is_named_exists(name):
    assert resolve(name) is not None


def commands(text: str) -> list[list[str]]:
    """Arguments of every `poppet ...` in console blocks and in tables of examples."""
    lines = [line[2:] for block in blocks(text, "console") for line in block.splitlines() if line.startswith("$ ")]
    lines += re.findall(r"\| `(poppet [^`]+)` \|", text)
    return [shlex.split(line, comments=True)[1:] for line in lines if line.startswith("poppet ")]


@pytest.mark.parametrize(
    "arguments", [arguments for text in TEXTS.values() for arguments in commands(text)], ids=" ".join
)
def test_command_lines_are_understood(arguments):
    name, rest = command_of(arguments)
    assert name in COMMANDS
    command_parser(name).read(rest)


@pytest.mark.parametrize("name", COMMANDS)
def test_every_option_is_documented(name):
    found = re.search(rf"^## `poppet {name}\b.*?\n(?=^## |\Z)", TEXTS["docs/cli.md"], re.MULTILINE | re.DOTALL)
    assert found, f"docs/cli.md has no section on poppet {name}"
    options = {option for option in command_parser(name)._option_string_actions if option.startswith("--")}
    assert sorted(option for option in options - {"--help"} if option not in found[0]) == []


@pytest.mark.parametrize("path", sorted((ROOT / "examples").glob("*.toml")), ids=lambda path: path.stem)
def test_examples_are_listed(path):
    assert f"poppet simulate examples/{path.name}" in TEXTS["examples/README.md"]


def test_python_example_runs(capsys):
    runpy.run_path(str(ROOT / "examples" / "first_steps.py"))
    assert "highest pressure" in capsys.readouterr().out


def test_make_targets_exist():
    """Every `make ...` that a page names is a target."""
    targets = set(re.findall(r"^([a-z-]+):", (ROOT / "Makefile").read_text(encoding="utf-8"), re.MULTILINE))
    named = {target for text in TEXTS.values() for target in re.findall(r"(?:\$ |`)make ([a-z-]+)", text)}
    assert named <= targets
    assert {"demo", "test"} <= named

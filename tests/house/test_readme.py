"""What README and docs tell people to type exists: commands, options, make targets, files, anchors."""

from __future__ import annotations

import re
import shlex
from pathlib import Path

import pytest

REPOSITORY = Path(__file__).resolve().parents[2]
README = REPOSITORY / "README.md"
PAGES = [path for path in (README, *sorted((REPOSITORY / "docs").glob("*.md"))) if path.is_file()]
FENCE = re.compile(r"^```(\w*)[^\n]*\n(.*?)^```", re.MULTILINE | re.DOTALL)
SHELLS = {"", "sh", "bash", "shell", "console", "text"}

pytestmark = pytest.mark.skipif(not README.is_file(), reason="README.md is not written yet")


def shell_lines(page: Path) -> list[str]:
    """Lines of shell blocks, continued ones joined, without prompts and comments."""
    found = []
    for language, block in FENCE.findall(page.read_text(encoding="utf-8")):
        if language not in SHELLS:
            continue
        lines = [line.strip().removeprefix("$ ") for line in block.replace("\\\n", " ").splitlines()]
        found += [re.sub(r"(^|\s)#.*$", "", line).strip() for line in lines]
    return found


def named(first: str) -> list[tuple[str, str]]:
    """Page and command line, for every line of a shell block or `inline code` that begins with a word."""
    found = []
    for page in PAGES:
        inline = re.findall(rf"`({first} [^`\n]+)`", page.read_text(encoding="utf-8"))
        found += [
            (page.name, line) for line in dict.fromkeys([*shell_lines(page), *inline]) if line.startswith(f"{first} ")
        ]
    return found


def is_form(line: str) -> bool:
    """A general form, `poppet simulate FILE [--plot PNG]`, not a command to be typed."""
    return bool(re.search(r"[\[\]|<>]|\.\.\.|…|\bFILE\b|\bADDRESS\b|\bVALUE\b|\bNAME\b|\bCOMMAND\b", line))


COMMANDS = [(page, line) for page, line in named("poppet") if not is_form(line)] if README.is_file() else []
MAKE = named("make") if README.is_file() else []


def test_readme_shows_how_to_begin():
    assert any(page == "README.md" and line.startswith("poppet simulate") for page, line in COMMANDS)


@pytest.mark.parametrize(("page", "line"), COMMANDS)
def test_command_is_understood(page, line):
    from poppet.cli.main import COMMANDS as KNOWN
    from poppet.cli.main import command_of, command_parser

    name, arguments = command_of(shlex.split(re.split(r" (?:&&|>|\|) ", line)[0])[1:])
    if name.startswith("-"):
        assert name in ("--help", "--version")
        return
    assert name in KNOWN, page
    if arguments:  # a bare command name is spoken about, not typed
        command_parser(name).read([each for each in arguments if each != "--help"]) if arguments != ["--help"] else None


@pytest.mark.parametrize(("page", "line"), MAKE)
def test_make_target_exists(page, line):
    makefile = (REPOSITORY / "Makefile").read_text(encoding="utf-8")
    targets = set(re.findall(r"^([\w-]+):", makefile, re.MULTILINE))
    words = [word for word in shlex.split(line)[1:] if "=" not in word and not word.startswith("-")]
    assert set(words) <= targets, f"{page}: {line}"


@pytest.mark.parametrize("page", PAGES, ids=lambda page: page.name)
def test_links_lead_somewhere(page):
    text = page.read_text(encoding="utf-8")
    links = re.findall(r"\]\((?!https?:|mailto:)([^)\s#]+)(?:#[^)]*)?\)", text)
    missing = [link for link in links if not (page.parent / link).exists()]
    assert missing == []
